"""Figures of README.md, and the picture: ring and products at three times, products outside
the ring over time; of variants/ the fragments of all seeds."""

import os

import numpy as np

from mpm.pictures import BODY, FAILED, GAS, PART, boxes, colourBar, frame, plt, save
from results import DEPTH, INNER, SIDE, STEEL, Run, gurney, mott
from seeds import CELLS, SEEDS

#: Of the scatter: constant/phaseProperties
MODULUS, CHARGE = 8, 0.025


def ends(path):
    return os.path.exists(os.path.join(path, "log.materialPointFoam")) and Run(path)


def results(label, runs):
    """Mean number and velocity of eight scatters."""
    table = np.array([r.fragments(r.times[-1]) for r in runs], float)
    n, v, chips = table.mean(axis=0)
    own = np.mean([r.fragments(r.times[-1], 1.2*r.h, 0.005)[0] for r in runs])
    print(f"{label}: fragments " + " ".join(f"{k:.0f}" for k in table[:, 0])
          + f", mean {n:.2f} +- {table[:, 0].std(ddof=1)/np.sqrt(len(table)):.2f};"
          f" velocity {table[:, 1].min():.1f} to {table[:, 1].max():.1f}, mean {v:.1f} m/s;"
          f" failed or chips {100*chips:.0f} %; with a link of 1.2 of its own cells and chips"
          f" of 0.5 %: {own:.2f} fragments")
    return n, v


def work(run, time):
    """Plastic work to this time [J/kg], and mean strain: the tension of the ring at that time
    over the whole way."""
    strain = np.log(run.meanRadius(time)/run.meanRadius(run.times[0]))
    return run.hoopStress(time)/STEEL*strain, strain


run = Run()
case = run.case
print("time [us], mean radius [mm], fragments, their mean velocity [m/s], products outside"
      " [kg/m]")
rows = []
for time in run.times[1:]:
    n, v, _ = run.fragments(time)
    rows.append((1e6*float(time), 1e3*run.meanRadius(time), n, v, run.outside(time)))
    print("    {:.0f} {:.1f} {:.0f} {:.1f} {:.6f}".format(*rows[-1]))
rows = np.array(rows)
last = run.times[-1]
products = case.series("fluids", "tnt.dat")
inside = products[0, 1]/DEPTH
print(f"products {inside:.3f} kg/m; outside at the end {100*rows[-1, 4]/inside:.2f} %")
# The last time that the ring is whole
whole = np.flatnonzero(rows[:, 2] == 1)[-1]
time = run.times[1 + whole]
loss, strain = work(run, time)
ratio, v = gurney(CHARGE)
print(f"M/C {ratio:.2f}: Gurney {v:.0f} m/s, less plastic work of {1e-3*loss:.0f} kJ/kg"
      f" {gurney(CHARGE, loss)[1]:.0f}; here {rows[-1, 3]:.0f} ({rows[-1, 3]/v:.2f})")
slope = (MODULUS - 1)/strain
print(f"whole until {rows[whole, 0]:.0f} us: radius {rows[whole, 1]:.1f} mm, strain"
      f" {strain:.3f}, velocity {rows[whole, 3]:.0f} m/s, tension"
      f" {1e-9*run.hoopStress(time):.2f} GPa: Mott"
      f" {mott(rows[whole, 3], run.hoopStress(time), slope):.1f} fragments")

mass = [case.series("fluids", f"{name}.dat") for name in ("tnt", "air")]
e = case.series("energy", "energy.dat")
m = case.series("balance", "mixture.dat")
ring = case.series("balance", "ring.dat")
Theta = case.numbers("^Theta: min N, max N")
print("mass nobody gave: "
      + ", ".join(f"{name} {abs(a[:, -1]).max()/a[0, 1]:.0e}" for name, a in zip(
          ("tnt", "air"), mass))
      + f", ring {np.ptp(ring[:, 2])/ring[0, 2]:.0e}; momentum nobody gave, over the mass at"
      f" the mean velocity {np.linalg.norm(m[:, 9:11], axis=1).max()/(ring[0, 2]*v):.0e}")
print(f"energy residual {100*abs(e[:, 7]).max()/np.ptp(e[:, 3]):.3f} % of what the ring took;"
      f" Theta {Theta.min():.4f} to {Theta.max():.4f}; {case.nSteps()} steps,"
      f" {case.solverSeconds():.0f} s")

found = {}
for n in CELLS:
    runs = [ends(f"variants/{n}-{seed}") for seed in SEEDS]
    if all(runs):
        found[n] = results(f"{n} cells", runs)
if len(found) == 2:
    (a, u), (b, w) = (found[n] for n in CELLS)
    print("coarse over fine: fragments {:+.1f} %, velocity {:+.2f} %".format(
        100*(a/b - 1), 100*(u/w - 1)))
filled = ends("variants/filled")
if filled:
    speeds = [filled.fragments(time)[1] for time in filled.times]
    loss, _ = work(filled, filled.nearWhole())
    ratio, v = gurney(INNER)
    print(f"filled: M/C {ratio:.2f}, Gurney {v:.0f} m/s, less plastic work"
          f" {gurney(INNER, loss)[1]:.0f}; here "
          + ", ".join(f"{s:.0f} at {1e6*float(t):.0f} us, radius {1e3*filled.meanRadius(t):.0f} mm"
                      for s, t in zip(speeds, filled.times) if float(t) > 0))

figure, axes = plt.subplots(1, 4, figsize=(14, 3.6), gridspec_kw={"width_ratios": (1, 1, 1, 0.9)})
edges = np.linspace(-500*SIDE, 500*SIDE, run.n + 1)
for ax, want in zip(axes, (3e-5, 6e-5, 8.5e-5)):
    time = case.nearest(want, "lagrangian")
    frame(ax, (-110, 110), (-110, 110), "x [mm]", "y [mm]" if ax is axes[0] else None,
          f"{1e6*float(time):.0f} us")
    share = case.field(time, "alpha.tnt", run.n, run.n)
    image = ax.pcolormesh(edges, edges, share, cmap=PART, vmin=0, vmax=1, rasterized=True,
                          zorder=GAS)
    points = case.points(time, "ring")
    failed = points["damage"] >= 1
    at, side = 1e3*points["x"][:, :2], 1e3*np.sqrt(points["V"]/DEPTH)
    boxes(ax, at[~failed], side[~failed], BODY, overlap=0.3)
    boxes(ax, at[failed], side[failed], FAILED, overlap=0.15)
ax = axes[3]
ax.plot(rows[:, 0], 100*rows[:, 4]/inside, "C0")
ax.set_ylabel("products outside the ring [%]", color="C0")
ax.set_xlabel("time [us]")
ax.grid(alpha=0.3)
other = ax.twinx()
other.plot(rows[:, 0], rows[:, 3], "C1")
other.set_ylabel("velocity of the fragments [m/s]", color="C1")
figure.tight_layout()
colourBar(figure, image, axes[:3], "share of products", shrink=0.8)
save(figure, "ring.png")
