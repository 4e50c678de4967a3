"""Figures of README.md's tables, and the picture: largest overpressure, arrival and impulse
over the distance beside Kingery and Bulmash's fits, overpressure over time at 2 m."""

import os

import numpy as np

import kingery
from mpm.pictures import plt, save
from results import GAUGES, Run

runs = {"20 cells": Run()}
for name, label in (("10", "10 cells"), ("40", "40 cells"), ("none", "20 cells, no afterburn"),
                    ("all", "20 cells, all heat")):
    path = os.path.join("variants", name)
    if os.path.exists(os.path.join(path, "log.materialPointFoam")):
        runs[label] = Run(path)

kinds = (("largest overpressure [kPa]", "peaks", kingery.pressure),
         ("arrival [ms]", "arrivals", kingery.arrival),
         ("impulse [kPa ms]", "impulses", kingery.impulse))
for label, run in runs.items():
    print(f"{label} over the radius of the charge")
    for title, values, fit in kinds:
        found = getattr(run, values)
        print(f"    {title}: " + ", ".join(
            f"{z:g} m {v:.4g} ({100*(v/f - 1):+.1f} %)"
            for z, v, f in zip(GAUGES, found, fit(GAUGES))))

figure, axes = plt.subplots(1, 4, figsize=(15, 3.6))
Z = np.geomspace(0.4, 6, 100)
for ax, (title, values, fit) in zip(axes, kinds):
    ax.loglog(Z, fit(Z), "k-", lw=1, label="Kingery & Bulmash")
    for (label, run), mark in zip(runs.items(), "o+xsv"):
        ax.loglog(GAUGES, getattr(run, values), mark, ms=4, mfc="none", label=label)
    ax.set_xlabel("distance [m]")
    ax.set_title(title)
    ax.grid(alpha=0.3, which="both")
axes[0].legend(fontsize=8)
ax = axes[3]
at = list(GAUGES).index(2)
for label, run in runs.items():
    ax.plot(run.t, run.p[:, at], lw=1, label=label)
ax.axvline(kingery.arrival(2.0), color="k", lw=0.5)
ax.axhline(kingery.pressure(2.0), color="k", lw=0.5)
ax.set_xlim(1.5, 8)
ax.set_xlabel("time [ms]")
ax.set_title("overpressure at 2 m [kPa]")
ax.grid(alpha=0.3)
figure.tight_layout()
save(figure, "blast.png")
