"""Plastic strain after 12 us on halved cells, their mesh, and the depth over the cost."""

import os

from matplotlib.collections import PolyCollection

from mpm.case import Case
from mpm.pictures import HEAT, colourBar, drawPoints, frame, plt, save
from mpm.variants import variant
from results import FINEST, depth, strain

case = Case()
figure, axes = plt.subplots(1, 3, figsize=(11.5, 3.9), width_ratios=(1, 1, 0.9))
time = case.times("lagrangian")[-1]
for ax, box, title in ((axes[0], ((0, 31), (-23, 8)), f"{1e6*float(time):g} $\\mu$s"),
                       (axes[1], ((0, 13), (-9, 4)), "cells and points")):
    frame(ax, *box, ylabel="y [mm]" if ax is axes[0] else None, title=title)
    ax.add_collection(PolyCollection([1e3*p for p in case.polygons()], facecolors="none",
                                     edgecolors="0.75" if ax is axes[0] else "0.6",
                                     linewidths=0.3, zorder=3))
    for phase in ("target", "rod"):
        cloud = case.points(time, phase)
        image = drawPoints(ax, cloud, 100*cloud["plasticStrain"], HEAT, (0, 40), scale=1e3,
                           close=1, section=1e-3)
colourBar(figure, image, axes[:2], "plastic strain [%]", shrink=0.8)

runs = [(".", "1 mm, halved twice")] + [
    (f"even{n}", f"even, {32/n:g} mm") for n in (32, 64, 128, 256)
    if os.path.isdir(f"variants/even{n}")]
for i, (name, label) in enumerate(runs):
    run = variant(name)
    d, cost = depth(run), run.solverSeconds()
    points = sum(len(run.points("0", phase)["m"]) for phase in ("rod", "target"))
    print(f"{label}: {points} points, {cost:.2f} s, depth {d:.4f} mm ({d - FINEST:+.4f} from"
          f" that of 0.125 mm), plastic strain of the target {100*strain(run):.3f} %")
    if name == "even256":
        continue
    axes[2].loglog(cost, FINEST - d, "C1D" if name == "." else "C0s", ms=6,
                   label="halved twice" if name == "." else "even" if i == 1 else None)
    axes[2].annotate(label.split(",")[-1].strip() if i else "1 to 0.25 mm", (cost, FINEST - d),
                     xytext=(0, 7 if i else -15), textcoords="offset points", ha="center",
                     fontsize=8)
axes[2].set(xlim=(0.03, 10), ylim=(0.07, 1), xlabel="seconds of one core",
            title="depth, short of that on 0.125 mm [mm]")
axes[2].legend(loc="lower left")
save(figure, "impact.png")
