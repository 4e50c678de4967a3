"""Debris at four times, the hole and its diameter beside fits; the figures of the README."""

import os

import numpy as np
from matplotlib.colors import LogNorm, to_rgb

import results
from mpm.case import Case
from mpm.pictures import FAILED, plt, save

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


def section(ax, run, time, xs, rs, sign=1):
    """One half of the section."""
    colours = [to_rgb(c) for c in (FAILED, COLOUR["copper"], COLOUR["aluminium"])]
    image = results.section(run.case, time, colours, 1e-3*xs, 1e-3*rs)
    ax.imshow(image, origin="lower" if sign > 0 else "upper",
              extent=(xs[0], xs[-1], *sorted((sign*rs[0], sign*rs[-1]))))


main = runs["copper, n 40"]
fine = runs.get("copper, n 80", main)
xs, ys = np.arange(-20, 60.1, 0.25), np.arange(-25, 0.1, 0.25)
figure, axes = plt.subplots(2, 2, figsize=(11.5, 6.6), sharex=True, sharey=True)
for ax, want in zip(axes.flat, (1e-6, 3e-6, 6e-6, 10e-6)):
    time = fine.case.nearest(want)
    image = 0.1*results.radiograph(fine.case, time, 1e-3*xs, 1e-3*ys)
    shadow = ax.pcolormesh(xs, ys, np.maximum(image, 1e-9), cmap="magma",
                           norm=LogNorm(0.005, 10), rasterized=True)
    section(ax, fine, time, np.arange(-20, 60.1, 0.15), np.arange(0, 25.1, 0.15))
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
save(figure, "debris.png", 100)

figure, axes = plt.subplots(1, 2, figsize=(10.5, 4.6),
                            gridspec_kw={"width_ratios": (1, 1.9)})
for run, sign in ((main, 1), (fine, -1)):
    time = run.case.nearest(12e-6)
    section(axes[0], run, time, np.arange(-6, 9.01, 0.05), np.arange(0, 16.01, 0.05), sign)
axes[0].set_aspect("equal")
axes[0].set_xlim(-6, 9)
axes[0].set_ylim(-16, 16)
axes[0].axhline(0, color="k", lw=0.6)
axes[0].set_xlabel("x [mm]")
axes[0].set_ylabel(f"y [mm]; n {main.n} above, n {fine.n} below")
axes[0].set_title(f"the hole at {1e6*float(time):.0f} us", fontsize=10)
for name, style in (("copper, n 40", "-"), ("copper, n 80", "--"), ("aluminium, n 40", ":")):
    if name in runs:
        for phase, colour in (("plate", "C0"), ("ball", "C1")):
            t, x = runs[name].series[phase]
            axes[1].plot(1e6*t, 1e3*x, colour + style,
                         label=f"{name}: {'plate' if phase == 'plate' else 'ball'}")
for ball, style in {(run.ball, "-" if run is main else ":") for run in runs.values()
                    if run is main or run.ball != main.ball}:
    t = np.array([0, 8])
    u = 2*results.interfaceSpeed(ball)
    axes[1].plot(t, 1e3*results.T + 1e-3*u*t, "0.6", ls=style, lw=1,
                 label=f"limit, {ball}: {1e-3*u:.2f} km/s")
axes[1].set_xlim(0, 12)
axes[1].set_ylim(0, 60)
axes[1].set_xlabel("time [us]")
axes[1].set_ylabel("foremost point [mm]")
axes[1].legend(fontsize=7)
save(figure, "hole.png", 100)

if os.path.isdir("variants/quarter/postProcessing"):
    case = Case("variants/quarter")
    last = case.times("lagrangian")[-1]
    whole, slow = results.hole(case, last)
    e = case.series("energy", "energy.dat")
    n = case.entry("system/blockMeshDict", "n")
    print(f"quarter in 3D, n {n:.0f}: hole {1e3*whole:.2f} mm (slow matter {1e3*slow:.2f}), over"
          f" D {whole/results.D:.3f}; energy residual {100*abs(e[:, 7]).max()/e[0, 1]:.3f} %;"
          f" {case.nSteps()} steps")
    figure, axes = plt.subplots(1, 2, figsize=(11, 3.6), sharey=True)
    xs, ys = np.arange(-10, 50.1, 0.4), np.arange(-20, 0.1, 0.4)
    for ax, want in zip(axes, (4e-6, 8e-6)):
        time = case.nearest(want, "lagrangian")
        image = 0.1*results.radiographOfQuarter(case, time, 1e-3*xs, 1e-3*ys)
        for sign in (-1, 1):
            shadow = ax.pcolormesh(xs, -sign*ys, np.maximum(image, 1e-9), cmap="magma",
                                   norm=LogNorm(0.005, 10), rasterized=True)
        ax.set_aspect("equal")
        ax.text(0.97, 0.92, f"{1e6*float(time):.0f} us", transform=ax.transAxes, ha="right",
                color="w")
        ax.set_xlabel("x [mm]")
    axes[0].set_ylabel("y [mm]")
    figure.colorbar(shadow, ax=axes, extend="both", label="mass per area [g/cm$^2$]")
    save(figure, "quarter.png", 100)
