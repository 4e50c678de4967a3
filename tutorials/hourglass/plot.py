"""The hourglass at six times, and the sand above its neck."""

import numpy as np

from mpm.case import Case
from mpm.pictures import GAS, ListedColormap, boxes, frame, plt, save
from results import SLOT, above, coefficient, flow, opening

SAND = ListedColormap(["#8a6d3b", "#e2c58c"])
STEP = 0.015

case = Case()
t, mass = above(case)
W = opening(case)
rate, apart = flow(t, mass)
start = case.points("0", "sand")
layer = np.floor(start.byId("x")[:, 1]/STEP) % 2
size = 1e3*np.sqrt(start.byId("V")/0.005)
corners = [1e3*p for p in case.polygons()]
inside = corners + [p*(-1, 1) for p in corners]

figure = plt.figure(figsize=(11, 4.2))
grid = figure.add_gridspec(1, 7, width_ratios=[1]*6 + [2.9])
for i, want in enumerate((0, 0.1, 0.2, 0.3, 0.45, t[-1])):
    ax = figure.add_subplot(grid[0, i])
    time = case.nearest(want, "lagrangian")
    frame(ax, (-52, 52), (-182, 182), None, "y [mm]" if i == 0 else None,
          f"{float(time):g} s")
    ax.set_xticks([-50, 0, 50])
    if i:
        ax.set_yticklabels([])
    for p in inside:
        ax.fill(*p.T, color="#eef2f6", lw=0, zorder=GAS)
    points = case.points(time, "sand")
    at = np.argsort(np.argsort(points["id"]))
    x = 1e3*points["x"]
    boxes(ax, np.concatenate((x, x*(-1, 1, 1))), np.tile(size[at], 2), overlap=0.3,
          values=np.tile(layer[at], 2), cmap=SAND, zorder=3)
ax = figure.add_subplot(grid[0, 6])
ax.plot(t, mass, "ko", ms=3, label="computed")
some = (mass < 0.85*mass[0]) & (mass > 0.3*mass[0])
ax.plot(t[some], mass[some][0] - rate*(t[some] - t[some][0]), "C1-",
        label=f"{rate:.2f} kg/(s m)")
ax.set(xlabel="t [s]", ylabel="sand above the neck [kg/m]", ylim=(0, None))
ax.legend(loc="upper right")
save(figure, "hourglass.png")

print(f"rate {rate:.3f} kg/(s m), C = {coefficient(rate, W):.3f}, of a slot {SLOT}; largest"
      f" distance from a constant rate {100*apart:.1f} % of the sand")
last = case.points(case.times("lagrangian")[-1], "sand")
print(f"volume of the sand at the end over that of the start"
      f" {last['V'].sum()/start['V'].sum():.2f}")
print(f"sand at the end: {len(last['m'])} of {len(start['m'])} points, mass"
      f" {last['m'].sum()/start['m'].sum() - 1:.0e}; above the neck"
      f" {100*mass[-1]/mass[0]:.1f} %; {case.nCells()} cells, {case.nSteps()} steps,"
      f" {case.solverSeconds():.0f} s")
