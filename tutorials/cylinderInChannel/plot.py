"""The cloud on its way round the cylinder, and paths of grains beside their integration."""

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.patches import Circle

from mpm.case import Case
from mpm.pictures import GAS, POINTS, VALUES, boxes, colourBar, frame, plt, polygons, save
from results import R, SHOCK, SPEED, apart, massChange, nose, rayleigh

case = Case()
corners = [1e3*p for p in case.polygons()]
both = corners + [p*(1, -1) for p in corners]
figure = plt.figure(figsize=(10.5, 6.2))
grid = figure.add_gridspec(2, 6, height_ratios=(1.1, 1))
axes = [figure.add_subplot(grid[0, 2*i:2*i + 2]) for i in range(3)]
for ax, want in zip(axes, (5.2e-4, 6.8e-4, 8.6e-4)):
    time = case.nearest(want, "lagrangian")
    frame(ax, (-260, 220), (-200, 200), ylabel="y [mm]" if ax is axes[0] else None,
          title=f"{1e3*float(time):g} ms: pressure, grains in white")
    p = 1e-5*case.field(time, "p")
    gas = ax.add_collection(polygons(both, np.append(p, p), VALUES, LogNorm(0.1, 12)))
    ax.add_patch(Circle((0, 0), 1e3*R, color="0.75", zorder=GAS))
    x = 1e3*case.points(time, "dust")["x"]
    boxes(ax, np.concatenate((x, x*(1, -1, 1))), 5, colours="w", zorder=POINTS)
bar = colourBar(figure, gas, axes, "pressure [bar]", shrink=1, aspect=20)
bar.set_ticks([0.1, 0.3, 1, 3, 10], labels=["0.1", "0.3", "1", "3", "10"])

away, free, (t, exact), (times, ours) = apart(case)
ax = figure.add_subplot(grid[1, :3])
frame(ax, (-130, 230), (0, 200), ylabel="y [mm]", title="paths of grains; mesh of snappyHexMesh")
ax.add_collection(polygons(corners, None, None, None))
mesh = ax.collections[-1]
mesh.set(facecolor="none", edgecolor="0.82", linewidth=0.4)
ax.add_patch(Circle((0, 0), 1e3*R, color="0.75", zorder=GAS))
start = exact[0]
first = np.flatnonzero(abs(start[:, 0] - start[:, 0].max()) < 1e-6)
first = first[np.argsort(start[first, 1])]
for k in first[::2]:
    a, = ax.plot(*1e3*exact[:, k].T, "k-", lw=0.9, zorder=3)
    b, = ax.plot(*1e3*ours[:, k].T, "C1o", ms=3, mfc="none", zorder=4)
ax.legend([b, a], ["computed", "drag integrated by itself"], loc="upper left", frameon=True)
last = figure.add_subplot(grid[1, 3:])
frame(last, (-130, 230), (0, 200), title=f"the cloud at {1e3*times[-1]:g} ms")
last.add_patch(Circle((0, 0), 1e3*R, color="0.75", zorder=GAS))
last.plot(*1e3*exact[-1].T, "k+", ms=5, mew=0.8)
last.plot(*1e3*ours[-1].T, "C1o", ms=3.5, mfc="none", mew=0.8)
save(figure, "cylinder.png")

pressure, shock = nose(case, [case.nearest(v, "U.air") for v in np.arange(5e-4, 6.01e-4, 2e-5)])
exactPressure = rayleigh(3.0)
print(f"pressure at the nose over that of the stream: {pressure:.2f}, Rayleigh"
      f" {exactPressure:.2f}, {100*(pressure/exactPressure - 1):+.1f} %")
print(f"distance of the shock/R: {shock:.3f}, Billig {SHOCK:.3f}, {100*(shock/SHOCK - 1):+.1f} %")
behind, across = abs(exact[-1] - exact[0] - (SPEED*t[-1], 0))[free].max(axis=0)/R
print(f"places of the grains at the end: {np.sqrt((away[free]**2).mean()):.3f} R from the"
      f" integration (rms), at most {away[free].max():.2f} R; way across the stream up to"
      f" {across:.2f} R, left behind up to {behind:.2f} R; {free.sum()} of {len(free)} grains,"
      " without those that touch the cylinder")
print(f"mass of the gas {massChange(case):.0e}; grains {len(case.points('0', 'dust')['m'])} at the"
      f" start, {len(ours[-1])} at the end; {case.nCells()} cells, {case.nSteps()} steps,"
      f" {case.solverSeconds():.0f} s")
