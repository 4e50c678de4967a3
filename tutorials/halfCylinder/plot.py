"""Figures of README.md's tables, and pictures: cracks over time, energies, and of the
series the cracks at the end."""

import os

import numpy as np

import results
from mpm.pictures import plt
from mpm.variants import variant

SERIES = ("coarse", ".", "fine", "seed1", "seed2", "coarseAir", "coarse3D")


def label(name):
    return "middle" if name == "." else name


def draw(ax, case, time, title):
    x, w = results.points(case, time, "x"), results.spent(case, time)
    if np.ptp(x[:, 2]) > 0:     # 3D: the middle of its length
        slab = abs(x[:, 2] - 0.06) < 0.003
        x, w = x[slab], w[slab]
    order = np.argsort(w)
    x, w = x[order], w[order]
    image = ax.scatter(*(1e3*x[:, :2].T), c=w, s=4e4/len(w), cmap="YlOrRd", vmin=0, vmax=1,
                       linewidths=0)
    ax.axhline(0, color="k", lw=1)
    ax.set_aspect("equal")
    ax.set_xlim(-58, 58)
    ax.set_ylim(-2, 60)
    ax.set_title(title, fontsize=9)
    return image


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

figure, axes = plt.subplots(2, 3, figsize=(13, 5.4))
for ax, want in zip(axes.flat, (2e-5, 6e-5, 1e-4, 1.4e-4, 2e-4, 4e-4)):
    name = variant(".").nearest(want, "lagrangian")
    image = draw(ax, ".", name, f"{1e6*float(name):.0f} us")
figure.colorbar(image, ax=axes, label="part of Gf that is spent")
figure.savefig("crack.png", dpi=120)

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
figure.savefig("energy.png", dpi=120)

if len(present) > 1:
    figure, axes = plt.subplots(3, 3, figsize=(13, 8.4))
    for ax in axes.flat[len(present):]:
        ax.axis("off")
    for ax, name in zip(axes.flat, present):
        case = variant(name).path
        image = draw(ax, case, results.times(case)[-1], label(name))
    figure.colorbar(image, ax=axes, label="part of Gf that is spent")
    figure.savefig("series.png", dpi=120)
