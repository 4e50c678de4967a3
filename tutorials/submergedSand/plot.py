"""Figures of README.md's table, and the picture: the column in water and dry at three
times, place of the front over time."""

import numpy as np

from mpm.case import Case
from mpm.pictures import BODY, GAS, PART, drawPoints, frame, plt, save

#: Width and height of the column [m]
L, H = 0.06, 0.06
cases = {name: Case(name) for name in ("water", "dry")}


def front(case, time):
    """Where 99.5 % of the points are along x [m]: single ones fly ahead."""
    return np.percentile(case.points(time, "sand")["x"][:, 0], 99.5)


fronts = {}
for name, case in cases.items():
    times = case.times("lagrangian")
    t = np.array([float(s) for s in times])
    x = np.array([front(case, s) for s in times])
    run = (x - x[0])/L
    fronts[name] = t, run
    top = case.points(times[-1], "sand")["x"][:, 1].max()
    last = np.polyfit(t[-3:], x[-3:], 1)[0]
    print(f"{name}: run-out {run[-1]:.2f} of the width, half of it at"
          f" {1e3*np.interp(0.5*run[-1], run, t):.0f} ms, height at the end {top/H:.2f} of that"
          f" of the start, the front then moves by {1e3*last:.1f} mm/s; {case.nSteps()} steps,"
          f" {case.solverSeconds():.0f} s")
water, dry = cases["water"], cases["dry"]
print(f"run-out in water over dry: {fronts['water'][1][-1]/fronts['dry'][1][-1]:.2f}")
Theta = water.numbers("^Theta: min N, max N")
print(f"water: Theta {Theta.min():.7f} to {Theta.max():.7f}")
# Columns: 6 work of gravity on the sand, 7 residual, 12 work of gravity in the fluids' faces
e = water.series("energy", "energy.dat", once=True)
worked = e[-1, 6] + e[-1, 12]
print(f"water: energy residual {100*abs(e[:, 7]).max()/worked:.3f} % of gravity's work on all,"
      f" {worked:.2e} J")
for name in ("water", "air"):
    m = water.series("balance", f"{name}.dat", once=True)
    print(f"water: mass of {name} that nobody gave: {abs(m[:, 9]).max()/m[0, 1]:.0e}")

nx, ny = (int(water.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))
x, y = (1e3*e for e in water.edges()[:2])
figure, axes = plt.subplots(2, 4, figsize=(13, 3.9), gridspec_kw={"width_ratios": (1, 1, 1, 1)})
for row, (name, case) in zip(axes, cases.items()):
    for ax, want in zip(row, (0.1, 0.2, 1)):
        time = case.nearest(want, "lagrangian")
        frame(ax, (0, 240), (0, 120), None, None, f"{name}, {1e3*float(time):.0f} ms")
        if case is water:
            ax.pcolormesh(x, y, case.field(time, "alpha.air", nx, ny), cmap=PART, vmin=0,
                          vmax=1, rasterized=True, zorder=GAS)
        drawPoints(ax, case.points(time, "sand"), BODY, scale=1e3)
for ax in axes[:, 3]:
    ax.remove()
ax = figure.add_subplot(axes[0, 3].get_gridspec()[:, 3])
for name, (t, run) in fronts.items():
    ax.plot(1e3*t, run, label=name)
ax.set_xlabel("time [ms]")
ax.set_title("run-out over the width")
ax.grid(alpha=0.3)
ax.legend()
save(figure, "submergedSand.png")
