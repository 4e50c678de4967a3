"""The row of pictures at the top of README.md, all of one height, from runs of the
tutorials:

    row.py ../../tutorials
"""

import os
import sys

import numpy as np

from mpm.case import Case
from mpm.pictures import (BODY, DAMAGE, GAS, RIGID, SIGNED, VALUES, ListedColormap, drawPoints,
                          plt, save)

HERE, TUTORIALS = os.path.dirname(os.path.abspath(__file__)), sys.argv[1]
HEIGHT, DPI = 2.0, 340


def case(*path):
    return Case(os.path.join(TUTORIALS, *path))


def picture(name, xlim, ylim, background="w"):
    """Axes without a frame that fill a picture; save them with close()."""
    figure = plt.figure(figsize=(HEIGHT*(xlim[1] - xlim[0])/(ylim[1] - ylim[0]), HEIGHT),
                        constrained_layout=False)
    ax = figure.add_axes((0, 0, 1, 1), facecolor=background)
    ax.set(xlim=xlim, ylim=ylim, xticks=[], yticks=[], aspect="equal")
    for side in ax.spines.values():
        side.set_visible(False)
    return ax, lambda: save(figure, os.path.join(HERE, f"row{name}.png"), DPI)


# A shock has run around a disc
run = case("shockOnSlab", "cylinder")
time = run.nearest(0.16e-3)
ax, close = picture("Shock", (0, 125), (5, 115))
ax.pcolormesh(np.arange(161), np.arange(121), run.field(time, "p", 160, 120), cmap=VALUES,
              vmin=1e5, vmax=10e5, zorder=GAS)
drawPoints(ax, run.points(time, "disc"), BODY, scale=1e3)
close()

# Taylor's bar
run = case("taylorBar")
cloud = run.points(run.nearest(1e-4), "bar")
ax, close = picture("TaylorBar", (-9, 9), (-1, 18.5))
ax.axhspan(-1, 0, color=RIGID, lw=0)
drawPoints(ax, cloud, cloud["plasticStrain"], VALUES, (0, 2), scale=1e3, axes=(1, 0), close=2.5,
           mirror=True)
close()

# Cracks of the half-cylinder
run = case("halfCylinder")
cloud = run.points(run.nearest(4e-4), "body")
E, f, Gf = (run.entry("constant/phaseProperties", k) for k in ("E", "strength", "Gf"))
r = 2*E*Gf/(f**2*0.05/run.entry("system/blockMeshDict", "n"))
spent = cloud["damage"]/(cloud["damage"] + r*(1 - cloud["damage"]))
ax, close = picture("HalfCylinder", (-55, 55), (-3, 55))
ax.axhspan(-3, 0, color=RIGID, lw=0)
drawPoints(ax, cloud, spent, DAMAGE, (0, 1), spent >= 1, scale=1e3)
close()

# A column of sand
run = case("sandColumn")
start, cloud = run.points("0", "sand"), run.points(run.nearest(0.2), "sand")
layer = np.floor(start.byId("x")[:, 1]/0.025) % 2
ax, close = picture("SandColumn", (0, 0.235), (-0.005, 0.15))
ax.axhspan(-0.005, 0, color=RIGID, lw=0)
drawPoints(ax, cloud, layer[np.argsort(np.argsort(cloud["id"]))],
           ListedColormap(["#8a6d3b", "#e2c58c"]), (0, 1), close=3)
close()

# Spall: tension has torn the plate
run = case("spall")
ax, close = picture("Spall", (-4, 4), (-0.4, 5.9))
time = run.nearest(1.25e-6)
for phase in ("target", "flyer"):
    cloud = run.points(time, phase)
    drawPoints(ax, cloud, cloud["sigma"][:, 3]*1e-6, SIGNED, (-500, 500), cloud["damage"] > 0.5,
               scale=1e3, close=0.2, outline="0.3")
close()
