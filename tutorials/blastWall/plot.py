"""Wall and gas at four times; shock and wall over time; the figures of the README."""

import numpy as np
from matplotlib.colors import LogNorm

import blast
import results
from mpm.pictures import FAILED, boxes, plt, save

COLOUR = {"blocks": "#D9CBB3", "mortar": "#8A7F70"}

runs = {name: run for name, run in (("10 mm", results.Run.of(".")),
                                    ("5 mm", results.Run.of("variants/fine"))) if run}
for name, run in runs.items():
    arrivals, exact, peak = run.arrivals()
    print(f"cells of {name}: charge of radius {1e3*run.radius:.2f} mm; arrival [us] "
          + ", ".join(f"{1e6*a:.2f} (fine {1e6*b:.2f}, {100*(a/b - 1):+.1f} %)"
                      for a, b in zip(arrivals, exact)))
    mass, momentum = run.rest()
    print(f"    shock at the wall {1e-5*peak:.1f} bar, thrown back by a rigid one"
          f" {1e-5*blast.reflected(peak):.0f} bar")
    Theta = run.case.numbers("^Theta: min N, max N")
    print(f"    mass {mass:.1e}, momentum {momentum:.1e}, energy residual"
          f" {100*run.residual():.3f} %, fix-ups {run.case.fixups():.0f}, Theta"
          f" {Theta.min():.5f} to {Theta.max():.5f}; {run.case.nSteps()} steps,"
          f" {run.case.numbers('^ExecutionTime = N s').ravel()[-1]:.0f} s")
main = runs["10 mm"]
w = main.wall[-1]
last = main.case.times("lagrangian")[-1]
print(f"wall at {1e3*w[0]:.1f} ms: momentum {w[3]:.1f} N s, mean velocity {w[3]/w[2]:.1f} m/s;"
      " blocks from the middle to the end [m/s]: "
      + ", ".join(f"{v:.0f}" for v in
                  (lambda p, order: [p["U"][s, 0].mean() for s in np.array_split(order, 11)])(
                      main.case.points(last, "blocks"),
                      np.argsort(main.case.points(last, "blocks")["id"]))))


def wall(ax, run, time, sign):
    """Points of the wall; sign -1: mirrored."""
    for phase in ("mortar", "blocks"):
        p = run.case.points(time, phase)
        x, side = p["x"][:, :2]*(1, sign), np.sqrt(p["V"])
        failed = p["damage"] >= 1
        boxes(ax, x[~failed], side[~failed], COLOUR[phase], overlap=0.3)
        boxes(ax, x[failed], 2*p["halfSize"][failed, 0], FAILED, overlap=0.15)


x, y = np.linspace(-0.5, 1.3, main.nx + 1), np.linspace(0, 0.9, main.ny + 1)
figure, axes = plt.subplots(2, 2, figsize=(10.2, 8.4), sharex=True, sharey=True)
for ax, want in zip(axes.flat, (0.2e-3, 1e-3, 4e-3, 8e-3)):
    time = main.case.nearest(want, "lagrangian")
    p, rho = (main.case.field(time, name, main.nx, main.ny) for name in ("p", "rho.air"))
    above = ax.pcolormesh(x, y, 1e-5*p, cmap="viridis", norm=LogNorm(0.2, 20), rasterized=True)
    below = ax.pcolormesh(x, -y, rho, cmap="cividis", norm=LogNorm(0.05, 5), rasterized=True)
    for sign in (1, -1):
        wall(ax, main, time, sign)
    ax.axhline(0, color="w", lw=0.5)
    ax.set_aspect("equal")
    ax.set_xlim(-0.5, 1.3)
    ax.set_ylim(-0.9, 0.9)
    ax.text(0.97, 0.94, f"{1e3*float(time):.1f} ms", transform=ax.transAxes, ha="right",
            color="w")
for ax in axes[1]:
    ax.set_xlabel("x [m]")
for ax in axes[:, 0]:
    ax.set_ylabel("y [m]")
axes[0, 0].legend(handles=[plt.Rectangle((0, 0), 1, 1, color=c) for c in
                           (*COLOUR.values(), FAILED)],
                  labels=[*COLOUR, "failed"], loc="lower left", fontsize=7)
figure.colorbar(above, ax=axes[0], extend="both", aspect=25, label="upper halves: pressure [bar]")
figure.colorbar(below, ax=axes[1], extend="both", aspect=25,
                label="lower halves: density of the gas [kg/m$^3$]")
save(figure, "blast.png", 95)

figure, axes = plt.subplots(1, 2, figsize=(10.5, 4))
t, p = blast.history(main.radius, *results.CHARGE, main.places, 0.1e-3)
for i in range(3):
    axes[0].plot(1e6*t, 1e-5*p[:, i], "k-", lw=0.8,
                 label="fine, without the wall" if not i else None)
    for name, run in runs.items():
        axes[0].plot(1e6*run.t, 1e-5*run.p[:, i], f"C{i}" + ("-" if run is main else "--"), lw=1,
                     label=f"x = {1e3*run.places[i]:.1f} mm, cells of {name}")
axes[0].set_xlim(0, 100)
axes[0].set_ylim(0.8, 100)
axes[0].set_yscale("log")
axes[0].set_xlabel("time [us]")
axes[0].set_ylabel("pressure [bar]")
axes[0].legend(fontsize=6)
total = main.mixture
axes[1].plot(1e3*main.wall[:, 0], main.wall[:, 3], label="of the wall")
axes[1].plot(1e3*total[:, 0], total[:, 3] - main.wall[:, 3], label="of the gas")
axes[1].plot(1e3*total[:, 0], total[:, 6], label="impulse of the boundaries")
axes[1].plot(1e3*total[:, 0], total[:, 3] - total[:, 6], "k--", lw=0.8, label="sum")
axes[1].set_xlabel("time [ms]")
axes[1].set_ylabel("momentum along x, upper half [N s per m]")
axes[1].legend()
figure.savefig("history.png", dpi=90)
