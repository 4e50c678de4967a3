"""Contact pressure of the cylinder beside Hertz's, and its figures."""

import os
import re
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, os.path.join(os.environ["MPM_PROJECT_DIR"], "tests/lib"))
from foamCase import readField

R, E, NU, H, THICKNESS = 0.16, 1e8, 0.3, 1e-3, 1e-3

log = open("log.materialPointFoam").read()
t = np.array([float(w) for w in re.findall(r"^Time = (\S+)", log, re.M)])
rows = re.findall(r"^Time = (\S+)(?:(?!^Time).)*?^Contact plane .*?force \((\S+) (\S+) ",
                  log, re.M | re.S)
time, force = np.array([(float(a), -2*float(c)/THICKNESS) for a, b, c in rows]).T
late = time > 0.9*time[-1]
F, scatter = force[late].mean(), np.ptp(force[late])

last = max((d for d in os.listdir(".") if re.fullmatch(r"[0-9.e-]+", d)
            and os.path.isdir(f"{d}/lagrangian")), key=float)
x = readField(f"{last}/lagrangian/cylinder/x")
sigma = readField(f"{last}/lagrangian/cylinder/sigma")
# Points less than half a cell from the surface, means of those in a cell's width
ids = readField(f"{last}/lagrangian/cylinder/id")
first = readField("0/lagrangian/cylinder/x")[np.argsort(readField("0/lagrangian/cylinder/id"))]
volume = readField(f"{last}/lagrangian/cylinder/V")
x, sigma, volume = (v[np.argsort(ids)] for v in (x, sigma, volume))
low = np.flatnonzero(first[:, 1] - first[:, 0]**2/(2*R) < 0.5*H)
column = (first[low, 0]/H).astype(int)
r, p = (np.bincount(column, volume[low]*v)/np.bincount(column, volume[low])
        for v in (x[low, 0], -sigma[low, 3]))

a = np.sqrt(4*F*R*(1 - NU**2)/(np.pi*E))
p0 = 2*F/(np.pi*a)
# p^2 = p0^2 (1 - x^2/a^2)
inside = p > 0.3*p.max()
slope, square = np.polyfit(r[inside]**2, p[inside]**2, 1)
width, peak = np.sqrt(-square/slope), np.sqrt(square)
print(f"force {F:.1f} N/m, varies by {100*scatter/F:.2f} % at the end")
for name, exact, value, scale, unit in (("half-width", a, width, 1e3, "mm"),
                                        ("peak pressure", p0, peak, 1e-6, "MPa")):
    print(f"{name}: {value*scale:.4f} {unit}, Hertz {exact*scale:.4f},"
          f" {100*(value/exact - 1):+.2f} %")
print(f"largest pressure of a cell {p.max()/1e6:.4f} MPa"
      f" ({100*(p.max()/p0 - 1):+.2f} %); cells in the half-width {a/H:.1f}")

figure, axes = plt.subplots(1, 2, figsize=(10, 4.2), constrained_layout=True)
axes[0].plot(r/a, p/p0, ".", label="points at the surface, means in a cell's width")
s = np.linspace(0, 1, 200)
axes[0].plot(s, np.sqrt(1 - s*s), "k", lw=0.8, label="Hertz")
axes[0].set(xlabel="x/a", ylabel="p/p0", xlim=(0, 2))
axes[0].legend(fontsize=8)
near = (x[:, 0] < 3*a) & (x[:, 1] < 3*a)
image = axes[1].scatter(x[near, 0]*1e3, x[near, 1]*1e3, c=-sigma[near, 3]/1e6, s=6, cmap="viridis")
axes[1].set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]")
figure.colorbar(image, ax=axes[1], label="-sigma_yy [MPa]")
figure.savefig("hertz.png", dpi=130)
