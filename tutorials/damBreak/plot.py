"""Figures of README.md's table, and the picture: place of the tip over time beside
experiments and Koshizuka and Oka's own computation, the water at three times."""

import re

import numpy as np

from mpm.case import Case
from mpm.pictures import PART, frame, plt, save

#: Width of the column [m], of the tank, its height; speed of sound of the water [m/s]
A, W, H, G = 0.146, 0.584, 0.438, 9.81
GAMMA, PINF, RHO = 1.12, 8.82e5, 1000

#: t sqrt(2 g/a), x/a. S. Koshizuka & Y. Oka, Nucl. Sci. Eng. 123 (1996) 421-434, and
#: J.C. Martin & W.J. Moyce, Phil. Trans. R. Soc. Lond. A 244 (1952) 312-324 (height
#: twice the width, a 1.125 inches); digits as in examples/db_exp_data.py of PySPH
EXPERIMENT = np.array([
    (0, 1), (0.381, 1.111), (0.769, 1.252), (1.153, 1.505), (1.537, 1.892), (1.935, 2.241),
    (2.323, 2.615), (2.719, 3.003), (3.096, 3.624)])
MPS = np.array([
    (0, 1.002), (0.227, 1.019), (0.416, 1.091), (0.591, 1.205), (0.778, 1.351), (0.958, 1.512),
    (1.095, 1.637), (1.226, 1.771), (1.381, 1.931), (1.536, 2.1), (1.684, 2.268),
    (1.858, 2.48), (2.043, 2.707), (2.278, 3.004), (2.451, 3.251), (2.604, 3.481),
    (2.752, 3.7), (2.943, 3.997)])
MARTIN = np.array([
    (0.849, 1.245), (1.212, 1.443), (1.602, 1.884), (2.283, 2.689), (2.95, 3.728)])

case = Case()
with open("system/blockMeshDict") as f:
    text = f.read()
nx, ny = (int(re.search(rf"^{n}\s+(\d+)", text, re.M)[1]) for n in ("nx", "ny"))
dx = W/nx
times = case.times()
water = {t: (case.field(t, "alpha.water")*np.ones(nx*ny)).reshape(ny, nx) for t in times}


def tip(row):
    """Where the water ends in the cells at the floor: half a share."""
    i = np.max(np.nonzero(row > 0.5)[0])
    part = (row[i] - 0.5)/(row[i] - row[i + 1]) if i + 1 < nx else 0.5
    return (i + 0.5 + part)*dx/A


T = np.array([float(t) for t in times])*np.sqrt(2*G/A)
X = np.array([tip(water[t][0]) for t in times])
fastest = max(np.max(np.linalg.norm(case.field(t, "U"), axis=1)[water[t].ravel() > 0.5])
              for t in times[1:])
sound = np.sqrt(GAMMA*(1e5 + PINF)/RHO)
print(f"largest velocity of water over its sound: {fastest:.2f}/{sound:.1f}"
      f" = {fastest/sound:.3f}")
for name, data in (("Koshizuka and Oka's experiment", EXPERIMENT),
                   ("Martin and Moyce's experiment", MARTIN),
                   ("Koshizuka and Oka's computation", MPS)):
    off = 100*(np.interp(data[:, 0], T, X)/data[:, 1] - 1)
    i = np.argmax(abs(off))
    print(f"tip against {name}: {off.min():+.1f} to {off.max():+.1f} %, most at"
          f" t sqrt(2 g/a) {data[i, 0]:.3f}, rms {np.sqrt(np.mean(off**2)):.1f} %")
V = np.array([np.sum(water[t]) for t in (times[0], times[-1])])*dx*H/ny
print(f"volume of water at the end over that of the start: {V[1]/V[0]:.5f}")

figure, axes = plt.subplots(1, 4, figsize=(15, 3.4), gridspec_kw={"width_ratios": (1, 1, 1, 1.2)})
for ax, t in zip(axes, (0.1, 0.2, 0.28)):
    name = min(times, key=lambda s: abs(float(s) - t))
    ax.imshow(1 - water[name], origin="lower", extent=(0, W*1e3, 0, H*1e3), cmap=PART,
              vmin=0, vmax=1)
    frame(ax, (0, W*1e3), (0, H*1e3), title=f"{float(name)*1e3:.0f} ms")
ax = axes[3]
ax.plot(T, X, "C0", label="this case")
ax.plot(*MPS.T, "k--", lw=1, label="Koshizuka & Oka, computed")
ax.plot(*EXPERIMENT.T, "ko", ms=4, label="Koshizuka & Oka, measured")
ax.plot(*MARTIN.T, "C1s", ms=4, label="Martin & Moyce, measured")
ax.set_xlabel(r"$t\sqrt{2g/a}$")
ax.set_title("tip of the water x/a")
ax.legend(fontsize=8)
ax.grid(alpha=0.3)
save(figure, "damBreak.png")
