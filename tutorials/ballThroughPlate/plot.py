"""Debris at four times, the hole and its diameter beside fits; the figures of the README."""

import numpy as np
from matplotlib.colors import LogNorm

import results
from mpm.pictures import FAILED, boxes, plt

COLOUR = {"copper": "#E08A3C", "aluminium": "#9DB7C9"}
RUNS = {"copper, n 40": ".", "copper, n 80": "variants/fine",
        "aluminium, n 40": "variants/aluminium", "one velocity field": "variants/oneField",
        "Johnson-Cook's damage": "variants/ductile", "twice the strength": "variants/strong"}

runs = {name: run for name, run in ((n, results.Run.of(p)) for n, p in RUNS.items()) if run}
for name, run in runs.items():
    whole, slow = results.hole(run.case, run.times[-1])
    exact = results.interfaceSpeed(run.ball)
    print(f"{name}: hole {1e3*whole:.2f} mm (slow matter {1e3*slow:.2f}), over D"
          f" {whole/results.D:.3f}; " + ", ".join(
              f"{k} {v:.2f}" for k, v in results.fits(run.ball).items()))
    rho, sound, slope = results.SHOCK["aluminium"]
    print(f"    highest pressure at the face on the axis {1e-9*run.face[1]:.1f} GPa, of flat"
          f" faces {1e-9*rho*(sound + slope*exact)*exact:.1f}; then {run.face[0]:.0f} m/s,"
          f" {exact:.0f}; fronts: plate {run.front['plate']:.0f} m/s, limit {2*exact:.0f},"
          f" ball {run.front['ball']:.0f}")
    print(f"    ball's mean velocity {run.speed:.0f} m/s, with its plug"
          f" {results.plugSpeed(run.ball):.0f}; mass {run.mass:.1e}, momentum"
          f" {run.momentum:.1e}, energy residual {100*run.residual:.3f} %, lost in the"
          f" transfer {100*run.transfer:.2f} %; {run.case.nSteps()} steps,"
          f" {run.case.numbers('^ExecutionTime = N s').ravel()[-1]:.0f} s")


def section(ax, run, time, sign=1):
    """Points of one half of the section."""
    for phase in ("plate", "ball"):
        p = run.case.points(time, phase)
        x = 1e3*p["x"][:, :2]*(1, sign)
        failed = p["damage"] >= 1
        side = 1e3*results.side(p, phase)
        metal = run.ball if phase == "ball" else "aluminium"
        boxes(ax, x[failed], side[failed], FAILED)
        boxes(ax, x[~failed], side[~failed], COLOUR[metal])


main = runs["copper, n 40"]
fine = runs.get("copper, n 80", main)
xs, ys = np.arange(-20, 60.1, 0.25), np.arange(-25, 0.1, 0.25)
figure, axes = plt.subplots(2, 2, figsize=(11.5, 6.6), sharex=True, sharey=True)
for ax, want in zip(axes.flat, (1e-6, 3e-6, 6e-6, 10e-6)):
    time = fine.case.nearest(want)
    image = 0.1*results.radiograph(fine.case, time, 1e-3*xs, 1e-3*ys)
    shadow = ax.pcolormesh(xs, ys, np.maximum(image, 1e-9), cmap="magma",
                           norm=LogNorm(0.005, 10), rasterized=True)
    section(ax, fine, time)
    ax.set_xlim(-20, 60)
    ax.set_ylim(-25, 25)
    ax.set_aspect("equal")
    ax.text(0.97, 0.93, f"{1e6*float(time):.0f} us", transform=ax.transAxes, ha="right")
for ax in axes[1]:
    ax.set_xlabel("x [mm]")
for ax in axes[:, 0]:
    ax.set_ylabel("y [mm]")
figure.colorbar(shadow, ax=axes, aspect=40, pad=0.01, extend="both",
                label="lower halves: mass per area across the axis [g/cm$^2$]")
axes[0, 0].legend(handles=[plt.Rectangle((0, 0), 1, 1, color=c) for c in
                           (COLOUR["copper"], COLOUR["aluminium"], FAILED)],
                  labels=["copper", "aluminium", "failed"], loc="upper left", fontsize=7)
figure.savefig("debris.png", dpi=100, pil_kwargs={"optimize": True})
