"""The plug on its way round the bend, and its way and speed beside a straight pipe's."""

import os

import numpy as np
from matplotlib.colors import Normalize

from mpm.case import Case
from mpm.pictures import BODY, VALUES, colourBar, drawPoints, frame, plt, polygons, save
from mpm.variants import variant
from results import figures, motion

case = Case()
corners = [1e3*p for p in case.polygons()]
figure = plt.figure(figsize=(11.5, 6))
grid = figure.add_gridspec(2, 3, width_ratios=(1, 1, 0.9))
axes = [figure.add_subplot(grid[i, j]) for i in (0, 1) for j in (0, 1)]
for ax, want in zip(axes, (0, 4e-3, 8e-3, 16e-3)):
    time = case.nearest(want, "lagrangian")
    frame(ax, (-360, 360), (-15, 360), xlabel="x [mm]" if ax in axes[2:] else None,
          ylabel="y [mm]" if ax in (axes[0], axes[2]) else None,
          title=f"{1e3*float(time):g} ms")
    gas = ax.add_collection(polygons(corners, 1e-5*case.field(time, "p"), VALUES,
                                     Normalize(1, 5)))
    drawPoints(ax, case.points(time, "plug"), BODY, scale=1e3, close=1, section=1e-2)
    if ax is axes[0]:
        ax.plot([], [], "s", color=BODY, label="plug")
        ax.legend(loc="lower center")
colourBar(figure, gas, axes, "pressure [bar]", shrink=0.6, location="bottom", aspect=40)

straight = motion(variant("straight"), bent=False)
way, speed = (figure.add_subplot(grid[i, 2]) for i in (0, 1))
for ax, column in ((way, 1), (speed, 2)):
    ax.plot(1e3*straight[:, 0], straight[:, column], "k-", lw=1,
            label="straight pipe, boxes of 5 mm, GIMP")
way.set(title="way along the middle of the pipe [m]")
speed.set(xlabel="time [ms]", title="speed [m/s]")
bends = [(".", "C0o", "bend, triangles of 10 mm"), ("fine", "C1x", "bend, triangles of 5 mm")]
if os.path.exists("variants/tube/0.02"):
    bends.append(("tube", "C2+", "bend in 3D, tetrahedra"))
for name, marker, label in bends:
    run = variant(name)
    rows = motion(run)
    for ax, column in ((way, 1), (speed, 2)):
        ax.plot(1e3*rows[:, 0], rows[:, column], marker, ms=4, mfc="none", label=label)
    own, other, apart = figures(rows, straight)
    words = ("speed at 5 ms [m/s]", "largest speed [m/s]", "turning point [m]")
    print(f"{label}: " + ", ".join(f"{w} {a:.4g} ({b:.4g}, {100*(a/b - 1):+.2f} %)"
                                   for w, a, b in zip(words, own, other))
          + f"; at most {100*apart:.2f} % of the way apart")
    mass, energy = run.numbers("^Gas air: mass N.*energy N").T
    points = run.numbers("^Energy: kinetic .* total N")
    whole = energy + points
    print(f"    mass of the gas {abs(mass/mass[0] - 1).max():.0e}, energy of gas and plug"
          f" {(whole[-1] - whole[0])/points.max():+.1e} of the plug's, pressures set to the isentrope"
          f" {run.numbers('isentropic N')[-1]:.0f};"
          f" {run.nCells()} cells, {run.nSteps()} steps, {run.solverSeconds():.0f} s")
way.legend(loc="lower right")
save(figure, "pipe.png")
