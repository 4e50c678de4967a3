"""Figures of README.md's tables, and pictures: cracks over time, energies, and of the
series the cracks at the end."""

import os

import numpy as np

import results
from mpm.case import Case
from mpm.pictures import DAMAGE, RIGID, colourBar, drawPoints, frame, plt, save
from mpm.variants import variant

SERIES = ("coarse", ".", "fine", "seed1", "seed2", "coarseAir", "coarse3D")


def label(name):
    return "middle" if name == "." else name


def draw(ax, case, time, title, labels=True):
    """Part of the fracture energy that is spent; what has failed in its own colour."""
    frame(ax, (-57, 57), (-3, 57), "x [mm]" if labels else None, "y [mm]" if labels else None,
          title)
    cloud, w = Case(case).points(time, "body"), results.spent(case, time)
    z = cloud["x"][:, 2]
    some = abs(z - 0.06) < 0.003 if np.ptp(z) > 0 else None     # 3D: its middle
    ax.axhspan(-3, 0, color=RIGID, lw=0)
    return drawPoints(ax, cloud, w, DAMAGE, (0, 1), w >= 1, some, 1e3)


present = [name for name in SERIES if os.path.isdir(variant(name).path)
           and results.times(variant(name).path)[-1:] > ["0"]]
print(f"{'case':10s} {'points':>7s}  damaged  failed  left/right     length  peak force  "
      "residual  in cracks  CPU [s]")
for name in present:
    case = variant(name).path
    part, ratio, length = results.cracks(case)
    e, start = results.energy(case)
    _, force = results.floor(case)
    seconds = variant(name).numbers("^ExecutionTime = N s")[-1]
    print(f"{label(name):10s} {len(results.points(case, '0', 'm')):7d}  "
          f"{100*part['damaged']:5.1f} %  {100*part['failed']:4.1f} %  "
          f"{ratio['damaged']:.3f} {ratio['failed']:.3f}  {1e3*length:5.0f} mm  "
          f"{force.max()*1e-3:7.1f} kN  {100*abs(e['residual'] + e['remap']).max()/start:6.2f} %  "
          f"{-100*e['failure'][-1]/start:6.1f} %  {seconds:6.1f}")

figure, axes = plt.subplots(2, 3, figsize=(11.5, 4.6), sharex=True, sharey=True)
for ax, want in zip(axes.flat, (8e-5, 1e-4, 1.2e-4, 1.4e-4, 2e-4, 4e-4)):
    name = variant(".").nearest(want, "lagrangian")
    image = draw(ax, ".", name, f"{1e6*float(name):.0f} $\\mu$s", False)
for ax in axes[-1]:
    ax.set_xlabel("x [mm]")
for ax in axes[:, 0]:
    ax.set_ylabel("y [mm]")
colourBar(figure, image, axes, "part of the fracture energy that is spent\n(1: failed)")
save(figure, "crack.png", 110)

e, start = results.energy()
figure, axes = plt.subplots(1, 2, figsize=(11, 4))
t = 1e6*e["Time"]
for name, what in (("kinetic", "kinetic"), ("strain", "strain"), ("failure", "failure"),
                   ("transfer", "transfer"), ("remap", "remap"),
                   ("residual", "residual")):
    axes[0].plot(t, e[name]/start, label=what)
axes[0].set_ylabel("energy over that at impact")
axes[0].legend()
t, force = results.floor()
axes[1].plot(1e6*t, 1e-3*force)
axes[1].set_ylabel("force of the floor [kN]")
for ax in axes:
    ax.set_xlabel("time [us]")
save(figure, "energy.png")

if len(present) > 1:
    figure, axes = plt.subplots(3, 3, figsize=(13, 8.4))
    for ax in axes.flat[len(present):]:
        ax.axis("off")
    for ax, name in zip(axes.flat, present):
        case = variant(name).path
        image = draw(ax, case, results.times(case)[-1], label(name))
    colourBar(figure, image, axes, "part of the fracture energy that is spent (1: failed)")
    save(figure, "series.png")
