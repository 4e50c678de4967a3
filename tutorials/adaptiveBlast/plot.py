"""The plane of symmetry and the wall from the front at four times, a film of both, and the
figures of the README."""

import numpy as np
from matplotlib.colors import LogNorm

import results
from mpm.pictures import DAMAGE, boxes, plt, save, saveAnimation

runs = {name: run for name, run in (("adaptive", results.Run.of(".")),
                                    ("all fine", results.Run.of("variants/fine"))) if run}
for name, run in runs.items():
    mass, momentum = run.rest()
    theta = run.case.numbers("^Theta: min N, max N")
    cells = run.case.numbers("^Adaptive mesh: N cells").ravel()
    last = run.times() if run.case.processors() else run.case.times("lagrangian")
    points = [run.case.points(last[-1], phase) for phase in ("blocks", "mortar")]
    print(f"{name}: arrival [us] " + ", ".join(f"{1e6*t:.1f}" for t in run.arrivals())
          + "; largest overpressure [bar] " + ", ".join(f"{1e-5*p:.2f}" for p in run.p.max(axis=0)))
    print(f"    momentum of the wall {run.wall[-1, 3]:.1f} N s, mean velocity"
          f" {run.wall[-1, 3]/run.wall[-1, 2]:.2f} m/s, largest of a block"
          f" {points[0]['U'][:, 0].max():.1f} m/s; failed "
          + ", ".join(f"{100*np.mean(p['damage'] >= 1):.0f} %" for p in points))
    print(f"    mass {mass:.1e}, momentum {momentum:.1e}, energy residual"
          f" {100*run.residual():.3f} %, fix-ups {run.case.fixups():.0f}, Theta"
          f" {theta.min():.5f} to {theta.max():.5f}; {run.case.nSteps()} steps,"
          f" {run.case.numbers('^ExecutionTime = N s').ravel()[-1]:.0f} s"
          + (f"; cells {cells.min():.0f} to {cells.max():.0f}" if cells.size else ""))
main = runs["adaptive"]


def draw(side, front, time):
    """Pressure on the cells at z = 0 and the points there; all points seen along x."""
    x, w, p = main.cells(time, "p")
    at = x[:, 2] < 1e-6
    image = boxes(side, x[at, :2] + 0.5*w[at, None], w[at], values=1e-5*p[at], overlap=0,
                  cmap="viridis", norm=LogNorm(0.3, 30))
    image.set(linewidth=0.15, edgecolor="k", antialiased=True)
    for phase in ("mortar", "blocks"):
        cloud = main.case.points(time, phase)
        at = cloud["x"][:, 2] < 0.025
        if at.any():
            boxes(side, cloud["x"][at, :2], np.cbrt(cloud["V"][at]), values=cloud["damage"][at],
                  cmap=DAMAGE, clim=(0, 1))
        order = np.argsort(-cloud["x"][:, 0])
        seen = cloud["x"][order][:, [2, 1]]
        for sign in (1, -1):
            boxes(front, seen*(sign, 1), np.cbrt(cloud["V"][order]),
                  values=cloud["damage"][order], cmap=DAMAGE, clim=(0, 1))
    side.set(xlim=(-0.4, 0.9), ylim=(0, 0.9), aspect="equal",
             title=f"{1e3*float(time):.2f} ms")
    front.set(xlim=(-0.65, 0.65), ylim=(0, 0.9), aspect="equal")
    return image


times = main.times()
figure, axes = plt.subplots(2, 4, figsize=(13, 5.2))
for (side, front), want in zip(axes.T, (0.25e-3, 0.5e-3, 1e-3, 2e-3)):
    image = draw(side, front, min(times, key=lambda t: abs(float(t) - want)))
figure.colorbar(image, ax=axes[0], extend="both", aspect=20, label="pressure [bar]")
figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(0, 1), DAMAGE), ax=axes[1], aspect=20,
                label="damage")
save(figure, "blast.png", 95)
plt.close(figure)


def frames():
    figure, (side, front) = plt.subplots(1, 2, figsize=(8, 2.9))
    for i, time in enumerate(times):
        side.clear()
        front.clear()
        image = draw(side, front, time)
        if i == 0:
            figure.colorbar(image, ax=side, extend="both", label="pressure [bar]")
        yield figure


saveAnimation(frames(), "blast.gif", colours=64)
