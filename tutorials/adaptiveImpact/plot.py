"""Plastic strain, points and cells at three times; the rod's velocity on all meshes."""

import os

from matplotlib.collections import PolyCollection

from mpm.case import Case
from mpm.pictures import HEAT, colourBar, drawPoints, frame, plt, save
from mpm.variants import variant
from results import rod, strain

case = Case()

# On several processors the meshes are there: reconstructPar does not know them
parts = [Case(folder) for folder in case.processors()] or [case]
times = parts[0].times("lagrangian")
figure, axes = plt.subplots(1, 4, figsize=(12.5, 4.3), width_ratios=(1, 1, 1, 1.1))
for ax, wanted in zip(axes, (4e-6, 12e-6, 24e-6)):
    time = min(times, key=lambda t: abs(float(t) - wanted))
    frame(ax, (0, 20), (-26, 8), ylabel="y [mm]" if ax is axes[0] else None,
          title=f"{1e6*float(time):g} $\\mu$s")
    cells = [1e3*p for part in parts for p in part.polygons(time)]
    ax.add_collection(PolyCollection(cells, facecolors="none", edgecolors="0.6",
                                     linewidths=0.25, zorder=3))
    for phase in ("target", "rod"):
        cloud = case.points(time, phase)
        image = drawPoints(ax, cloud, 100*cloud["plasticStrain"], HEAT, (0, 100), scale=1e3,
                           close=1, section=1e-3)
colourBar(figure, image, axes[:3], "plastic strain [%]", shrink=0.8)

runs = [(".", "1 mm, halved twice around the rod")] + [
    (f"even{n}", f"all {32/n:g} mm") for n in (32, 64, 128) if os.path.isdir(f"variants/even{n}")]
for (name, label), style in zip(runs, ("C1D-", "C0-", "C2-", "C3-")):
    run = variant(name)
    times = (parts[0] if name == "." else run).times("lagrangian")
    depths = [rod(run, t) for t in times]
    points = [sum(len(run.points(t, phase)["m"]) for phase in ("rod", "target"))
              for t in (times[0], times[-1])]
    print(f"{label}: {points[0]} to {points[1]} points, {run.solverSeconds():.1f} s,"
          f" depth {depths[-1][0]:.3f} mm, velocity {depths[-1][1]:.1f} m/s, plastic strain of"
          f" the target {100*strain(run, times[-1]):.2f} %")
    print("    depth [mm] " + " ".join(f"{d:.3f}" for d, _ in depths)
          + "; velocity [m/s] " + " ".join(f"{v:.1f}" for _, v in depths))
    axes[3].plot([1e6*float(t) for t in times], [v for _, v in depths],
                 style, ms=5, label=label)
axes[3].set(xlabel="time [$\\mu$s]", title="velocity of the rod [m/s]", ylim=(0, None))
axes[3].legend(fontsize=8)
save(figure, "impact.png")
