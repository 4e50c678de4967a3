"""Figures of README.md's table, and the picture: the bed at four times, the bubble beside that of
twoPhaseEulerFoam."""

import numpy as np

from mpm.case import Case
from mpm.pictures import PART, frame, plt, save
from results import H, NX, NY, REFERENCE, TEMPERATURE, beads, bubble

case = Case()
times = case.times()
found = {float(t): bubble(beads(case, t)) for t in times if t != "0"}
for t, (d, low, high) in REFERENCE.items():
    ours = found[t]
    print(f"{t} s: bubble {ours[0]:.4f} m ({100*(ours[0]/d - 1):+.1f} % of twoPhaseEulerFoam's),"
          f" from {ours[1]:.4f} to {ours[2]:.4f} m ({low:.4f} to {high:.4f} m)")
bed = case.points(times[-1], "beads")
T = bed["granularTemperature"]
print(f"granular temperature at the end: median {np.median(T):.1e} (twoPhaseEulerFoam"
      f" {TEMPERATURE[0.3]:.1e}), 99 % below {np.percentile(T, 99):.1e} m2/s2")

figure, axes = plt.subplots(1, 5, figsize=(13, 4.2), gridspec_kw={"width_ratios": (1,)*4 + (1.5,)})
x = 1e3*H*np.arange(-NX, NX + 1)
for ax, t in zip(axes, ("0.06", "0.14", "0.2", "0.3")):
    share = beads(case, t)
    ax.pcolormesh(x, 1e3*H*np.arange(NY + 1), 1 - np.hstack([share[:, ::-1], share]),
                  cmap=PART, vmin=0.35, vmax=1, rasterized=True)
    frame(ax, (x[0], x[-1]), (0, 450), title=f"{1e3*float(t):.0f} ms")
ax = axes[4]
t = np.array(sorted(found))
d, low, high = np.array([found[s] for s in t]).T
reference = np.array([(s, *v) for s, v in REFERENCE.items()]).T
ax.plot(1e3*t, 1e3*d, "C0", label="diameter")
ax.plot(1e3*t, 1e3*high, "C2", label="top")
ax.plot(1e3*t, 1e3*low, "C1", label="lowest place")
for row, colour in zip(reference[1:], ("C0", "C1", "C2")):
    ax.plot(1e3*reference[0], 1e3*row, colour + "o", ms=4,
            label="twoPhaseEulerFoam" if colour == "C0" else None)
ax.set_xlabel("time [ms]")
ax.set_title("bubble [mm]")
ax.legend()
ax.grid(alpha=0.3)
save(figure, "fluidisedBed.png")
