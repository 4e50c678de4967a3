"""Figures of README.md, and the picture: fluids and tube at three times, motion of the wall
beside the measured one."""

import os

import numpy as np
from matplotlib.patches import Patch

from mpm.case import Case
from mpm.pictures import GAS, PART, RIGID, drawPoints, frame, plt, save, to_rgba
from results import WHEN, Run, measured, peak
from variants import CELLS

#: Colour of the products; times of the picture [s]
PRODUCTS = "#e08a3c"
TIMES = (2e-5, 1e-4, 2e-4)


def tell(name, run):
    (t, v), (late, d) = peak(run.velocity), peak(run.displacement)
    kept = run.kept()
    print(f"{name}: wall's peak {v:.1f} m/s at {1e6*t:.0f} us; displacement"
          f" {1e3*run.at(WHEN):.2f} mm at {1e6*WHEN:.1f} us, at most {1e3*d:.2f} mm at"
          f" {1e6*late:.0f} us; rms difference {1e3*run.difference(exp['displacement']):.3f} mm")
    print(f"    energy residual {100*kept['energy']:.4f} % of what the tube took; mass that nobody"
          " gave " + ", ".join(f"{n} {m:.0e}" for n, m in kept["masses"].items())
          + f"; momentum along x {kept['momentum']:.0e}")
    print("    Theta {:.4f} to {:.4f}".format(*kept["Theta"])
          + f"; fix-ups {kept['fixups']:.0f}, pressure of voids"
          f" {100*kept['voids']:.4f} % of that energy; {run.case.nSteps()} steps,"
          f" {run.case.solverSeconds():.0f} s")
    times = run.case.times("lagrangian")[1:]
    share = [run.vapour(time) for time in times]
    i = int(np.argmax(share))
    print(f"    air and vapour in the tube: at most {100*share[i]:.1f} % of its inside, at"
          f" {1e6*float(times[i]):.0f} us")


exp = measured()
(t, v), (late, d) = peak(exp["velocity"]), peak(exp["displacement"])
first = np.interp(WHEN, *exp["displacement"].T)
print(f"measured: peak {v:.1f} m/s at {1e6*t:.0f} us; {1e3*first:.2f} mm at {1e6*WHEN:.1f} us, at"
      f" most {1e3*d:.2f} mm at {1e6*late:.0f} us")
run = Run()
runs = {"2 mm": run}
for name in CELLS:
    path = os.path.join("variants", name)
    if os.path.exists(path) and "\nEnd\n" in Case(path).log():
        runs[name.replace("mm", " mm")] = Run(path)
for name, one in runs.items():
    tell(name, one)

figure = plt.figure(figsize=(12, 6))
above, below = figure.subfigures(2, 1, height_ratios=(0.8, 1))
x, r = 1e3*run.x, 1e3*run.r
for ax, want in zip(above.subplots(1, 3, sharey=True), TIMES):
    time = run.case.nearest(want, "lagrangian")
    ax.set_xticks((-100, 0, 100))
    frame(ax, (-150, 150), (-80, 80), "x [mm]", "r [mm]" if want == TIMES[0] else None,
          f"{1e6*float(time):.0f} us")
    share = {name: run.field(time, f"alpha.{name}") for name in ("petn", "water", "air")}
    rest = share["air"]/np.maximum(share["air"] + share["water"], 1e-12)
    products = (share["petn"]/sum(share.values()))[..., None]
    image = products*to_rgba(PRODUCTS) + (1 - products)*PART(rest)
    # The half that is computed, on both sides of its planes of symmetry
    image = np.concatenate([image[:, ::-1], image], axis=1)
    ax.imshow(np.concatenate([image[::-1], image]), origin="lower",
              extent=(-x[-1], x[-1], -r[-1], r[-1]), zorder=GAS, interpolation="nearest")
    cloud = run.case.points(time, "tube")
    both = {name: np.concatenate([factor*cloud[name], cloud[name]])
            for name, factor in (("x", (-1, 1, 1)), ("halfSize", (1, 1, 1)))}
    drawPoints(ax, both, RIGID, scale=1e3, mirror="up")
    if want == TIMES[0]:
        ax.annotate("measured here", (0, 51), (0, 70), ha="center", va="center", fontsize=8,
                    arrowprops={"arrowstyle": "->"}, zorder=5)
        ax.legend(handles=[
            Patch(color=PRODUCTS, label="products"), Patch(color=RIGID, label="tube"),
            Patch(color=PART(0.0), label="water"), Patch(color=PART(0.5), label="with vapour"),
            Patch(facecolor=PART(1.0), edgecolor="0.5", label="air")],
            ncol=5, loc="lower center", fontsize=7.5, columnspacing=0.8, handlelength=1,
            handletextpad=0.4)
axes = dict(zip("du", below.subplots(1, 2)))
for key, rows, computed, factor, label in (
        ("d", exp["displacement"], "displacement", 1e3, "displacement of the wall [mm]"),
        ("u", exp["velocity"], "velocity", 1, "velocity of the wall [m/s]")):
    ax = axes[key]
    ax.plot(1e6*rows[:, 0], factor*rows[:, 1], "ko", ms=3.5, zorder=5,
            label="measured, Wardlaw et al.")
    for i, (name, one) in enumerate(runs.items()):
        t, value = getattr(one, computed).T
        ax.plot(1e6*t, factor*value, f"C{i}", lw=1.3, label=f"cells of {name}")
    ax.set(xlabel="time [us]", ylabel=label, xlim=(0, 400))
    ax.grid(alpha=0.3)
    ax.legend()
save(figure, "tube.png", 110)
