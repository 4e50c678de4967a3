"""Contact pressure of the cylinder beside Hertz's, and its figures."""

import numpy as np

from mpm.case import Case
from mpm.pictures import RIGID, VALUES, colourBar, drawPoints, frame, plt, save

R, E, NU, H, THICKNESS = 0.16, 1e8, 0.3, 1e-3, 1e-3

case = Case()
time, force = case.numbers(r"(?s)^Time = N(?:(?!^Time).)*?^Contact plane .*?force \(\S+ N ").T
force *= -2/THICKNESS
late = time > 0.9*time[-1]
F, scatter = force[late].mean(), np.ptp(force[late])

start, end = (case.points(t, "cylinder") for t in ("0", case.times("lagrangian")[-1]))
x, sigma, volume = (end.byId(name) for name in ("x", "sigma", "V"))
# Points less than half a cell from the surface, means of those in a cell's width
first = start.byId("x")
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

figure, axes = plt.subplots(1, 2, figsize=(9, 3.9))
axes[0].plot(r/a, p/p0, "o", ms=4, label="points at the surface")
s = np.linspace(0, 1, 200)
axes[0].plot(s, np.sqrt(1 - s*s), "k", lw=0.8, label="Hertz")
axes[0].set(xlabel="x/a", ylabel="p/p$_0$", xlim=(0, 2))
axes[0].legend()
frame(axes[1], (-2.2*a*1e3, 2.2*a*1e3), (-0.4*a*1e3, 3.6*a*1e3))
axes[1].axhspan(-a*1e3, 0, color=RIGID, lw=0)
for s, name in ((-1, "-a"), (1, "a")):
    axes[1].plot([s*a*1e3]*2, [-0.3*a*1e3, 0], "k", lw=1, zorder=5)
    axes[1].text(1.05*s*a*1e3, -0.15*a*1e3, name, va="center", ha="left" if s > 0 else "right")
image = drawPoints(axes[1], end, -end["sigma"][:, 3]/1e6, VALUES, (0, 3), scale=1e3,
                   mirror=True)
colourBar(figure, image, axes[1], "-$\\sigma_{yy}$ [MPa]")
save(figure, "hertz.png")
