"""Figures of README.md's table, and the picture: numerical schlieren at six times of the
experiment's photographs, places of the interfaces over time."""

import numpy as np

from mpm.case import Case
from mpm.pictures import frame, plt, save
from results import COMPUTED, EDGE, MEASURED, SHOCK, START, Run

run = Run()
case = Case()
found = run.velocities()
for name, value in found.items():
    print(f"{name}: {value:.1f} m/s, measured {MEASURED[name]} ({100*(value/MEASURED[name] - 1):+.1f}"
          " %)" + (f", Quirk and Karni {COMPUTED[name]} ({100*(value/COMPUTED[name] - 1):+.1f} %)"
                   if name in COMPUTED else ""))
nx, ny = (int(case.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))
print(f"cells over the diameter {0.05/0.26*nx:.0f}; {case.nSteps()} steps,"
      f" {case.solverSeconds():.0f} s; fix-ups"
      f" {sum(case.numbers('relaxation kept N, isentropic N')[-1]):.0f}")
helium = case.numbers("^Fluids: mass air N helium N,")[:, 1]
print(f"helium: changes by {abs(helium/helium[0] - 1).max():.0e} of its mass")

x, y = (1e3*e for e in case.edges()[:2])
figure = plt.figure(figsize=(13, 5))
grid = figure.add_gridspec(2, 4, width_ratios=(1, 1, 1, 1.1))
for k, want in enumerate((50e-6, 100e-6, 250e-6, 450e-6, 700e-6, 1e-3)):
    time = case.nearest(want + (EDGE - START)/SHOCK)
    ax = figure.add_subplot(grid[k//3, k % 3])
    rho = case.field(time, "rho", nx, ny)
    gy, gx = np.gradient(rho, y[1] - y[0], x[1] - x[0])
    # Quirk and Karni: exp of the gradient over its largest, the light gas stronger
    share = case.field(time, "alpha.helium", nx, ny)
    size = np.hypot(gx, gy)
    shade = np.exp(-(20 + 100*share)*size/size.max())
    ax.pcolormesh(x, y, shade, cmap="gray", vmin=0, vmax=1, rasterized=True)
    low = 1e3*run.rear[np.argmin(abs(run.late + (EDGE - START)/SHOCK - float(time)))] - 12
    frame(ax, (low, low + 100), (-44.5, 44.5), "x [mm]" if k > 2 else None,
          "y [mm]" if k % 3 == 0 else None,
          f"{1e6*(float(time) - (EDGE - START)/SHOCK):.0f} us")
ax = figure.add_subplot(grid[:, 3])
place = 1e3*EDGE
for name, t, at, style in (
        ("pressure front on the axis", run.t, run.front, "k-"),
        ("upstream interface, jet", run.t, run.upstream, "C0-"),
        ("downstream interface", run.t, run.downstream, "C1-"),
        ("last helium in any row", run.late, run.rear, "C2o")):
    ax.plot(1e3*at - place, 1e6*t, style, ms=4, mfc="none", label=name)
ax.set(xlim=(-5, 200), ylim=(0, 1000), xlabel="x from the cylinder's edge [mm]",
       title="time [us]")
ax.legend(loc="lower right")
ax.grid(alpha=0.3)
save(figure, "helium.png")
