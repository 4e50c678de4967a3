"""Figures of README.md, and the pictures: wall and pressure at four times; pressure
before the wall with and without it."""

import os

import numpy as np
from matplotlib.colors import LogNorm

from mpm.case import Case
from mpm.pictures import FAILED, GAS, boxes, colourBar, frame, plt, save
from mpm.pieces import pieces

P0, GAMMA, SIZE = 101325.0, 1.4, (-2.4, 1.2, 0, 1.8)
COLOUR = {"blocks": "#D9CBB3", "mortar": "#8A7F70"}
#: Columns of summary.dat
ARRIVAL, PEAK, IMPULSE = 5, 6, 9
#: Columns of energy.dat
TOTAL, RESIDUAL, REMAP = 3, 7, 17
#: Points nearer than this [m] hold together: 1.5 of their distances; least piece [kg]
REACH, LEAST = 0.015, 0.5


def reflected(p):
    """Pressure behind a shock of this pressure when a rigid wall has thrown it back:
    Rankine and Hugoniot's relations of a perfect gas."""
    return p*((3*GAMMA - 1)*p - (GAMMA - 1)*P0)/((GAMMA - 1)*p + (GAMMA + 1)*P0)


case = Case(".")
nx, ny = (int(case.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))


def blast(label, *names):
    """Prints the blast at the foot of the wall, the same at a rigid wall and with no wall;
    the reflected pressure [Pa]. Impulses to the same time, of p - p0."""
    cases = [Case(name) for name in names]
    hit, fixed, incident = (c.series("gauges", "summary.dat")[0] for c in cases)
    p = [c.series("gauges", "p.dat")[:, :2] for c in cases]
    end = min(rows[-1, 0] for rows in p)
    impulse = []
    for rows in p:
        t, over = rows[rows[:, 0] <= end].T
        impulse.append(np.sum(np.diff(t)*(0.5*(over[1:] + over[:-1]) - P0)))
    ideal = reflected(P0 + incident[PEAK]) - P0
    print(f"{label}: arrival {1e3*incident[ARRIVAL]:.3f} ms free, {1e3*fixed[ARRIVAL]:.3f} rigid,"
          f" {1e3*hit[ARRIVAL]:.3f} here; peak over the air's [bar] {1e-5*incident[PEAK]:.2f} free,"
          f" {1e-5*ideal:.2f} Rankine and Hugoniot, {1e-5*fixed[PEAK]:.2f} rigid,"
          f" {1e-5*hit[PEAK]:.2f} here ({100*(hit[PEAK]/ideal - 1):+.1f},"
          f" {100*(hit[PEAK]/fixed[PEAK] - 1):+.1f} %)")
    print(f"    impulse to {1e3*end:.1f} ms [Pa s] {impulse[2]:.0f} free, {impulse[1]:.0f} rigid,"
          f" {impulse[0]:.0f} here ({100*(impulse[0]/impulse[1] - 1):+.1f} %);"
          f" positive phase here {hit[IMPULSE]:.0f}")
    return ideal


ideal = blast("20 mm", ".", "variants/rigid", "variants/free")
if os.path.exists("variants/fineRigid/postProcessing"):
    blast("10 mm", "variants/fine", "variants/fineRigid", "variants/fineFree")

for name in ("tnt", "air"):
    rows = case.series("fluids", f"{name}.dat")
    print(f"mass of {name}: nobody gave {abs(rows[:, 9]).max()/rows[0, 1]:.1e},"
          f" {rows[0, 1]:.4f} kg at the start, {rows[-1, 1]:.4f} at the end")
points = case.series("balance", "total.dat")
e = case.series("energy", "energy.dat")
m = case.series("balance", "mixture.dat")
size = max(np.linalg.norm(m[:, c:c + 2], axis=1).max() for c in (3, 6))
Theta = case.numbers("^Theta: min N, max N")
print(f"mass of the points {np.ptp(points[:, 2])/points[0, 2]:.1e}; momentum nobody gave"
      f" {np.linalg.norm(m[:, 9:11], axis=1).max()/size:.1e}")
took = np.ptp(e[:, TOTAL])
residual, wrong = (abs(sums).max() for sums in (e[:, RESIDUAL], e[:, RESIDUAL] + e[:, REMAP]))
print(f"energy residual {residual:.0f} J: {100*residual/took:.3f} % of what the wall took,"
      f" with remap {100*wrong/took:.3f} %; Theta {Theta.min():.5f} to {Theta.max():.5f};"
      f" fix-ups {sum(case.numbers('kept N, pressure of relaxation kept N, isentropic N')[-1]):.0f};"
      f" {case.nSteps()} steps, {case.solverSeconds():.0f} s")

last = case.times("lagrangian")[-1]
w = points[-1]
blocks = case.points(last, "blocks")
order = np.argsort(blocks["id"])
print(f"wall at {1e3*float(last):.1f} ms: mean velocity {w[3]/w[2]:.1f} m/s; failed"
      f" {sum(np.sum(case.points(last, n)['damage'] >= 1) for n in COLOUR)} of {w[1]:.0f} points;"
      " blocks from the floor up [m/s]: "
      + ", ".join(f"{blocks['U'][s, 0].mean():.1f}" for s in np.array_split(order, 10)))

cloud = [case.points(last, n) for n in COLOUR]
x, weight, damage = (np.concatenate([p[key] for p in cloud]) for key in ("x", "m", "damage"))
hold = damage < 1
mass = np.bincount(pieces(x[hold, :2], REACH), weight[hold])
mass = np.sort(mass[mass > LEAST])[::-1]
print(f"pieces of more than {LEAST} kg: {len(mass)}, together {mass.sum():.0f} of"
      f" {weight.sum():.0f} kg: " + ", ".join(f"{one:.1f}" for one in mass))

x, y = (np.linspace(a, b, n + 1) for a, b, n in ((*SIZE[:2], nx), (*SIZE[2:], ny)))
figure, axes = plt.subplots(2, 2, figsize=(11, 6), sharex=True, sharey=True)
for ax, want in zip(axes.flat, (0.5e-3, 1e-3, 6e-3, 24e-3)):
    time = case.nearest(want, "lagrangian")
    frame(ax, SIZE[:2], SIZE[2:], "x [m]" if ax in axes[1] else None,
          "y [m]" if ax in axes[:, 0] else None, f"{1e3*float(time):.2f} ms")
    image = ax.pcolormesh(x, y, 1e-5*case.field(time, "p", nx, ny), cmap="viridis",
                          norm=LogNorm(0.3, 30), rasterized=True, zorder=GAS)
    ax.contour(0.5*(x[1:] + x[:-1]), 0.5*(y[1:] + y[:-1]),
               case.field(time, "alpha.tnt", nx, ny), levels=(0.5,), colors="w", linewidths=0.8)
    for phase, colour in COLOUR.items():
        p = case.points(time, phase)
        at, side = p["x"][:, :2], np.sqrt(p["V"])
        failed = p["damage"] >= 1
        boxes(ax, at[~failed], side[~failed], colour, overlap=0.3)
        boxes(ax, at[failed], 2*p["halfSize"][failed, 0], FAILED, overlap=0.15)
colourBar(figure, image, axes, "pressure [bar]; white: edge of the products", shrink=0.8)
save(figure, "wall.png", 90)

figure, ax = plt.subplots(figsize=(6, 3.6))
for name, label in ((".", "at the foot of the wall"), ("variants/rigid", "of a rigid wall"),
                    ("variants/free", "there, without the wall")):
    p = Case(name).series("gauges", "p.dat")
    ax.plot(1e3*p[:, 0], 1e-5*(p[:, 1] - P0), label=label)
ax.axhline(1e-5*ideal, color="k", ls=":", lw=0.8, label="Rankine and Hugoniot")
ax.set_xlim(0.3, 2.5)
ax.set_xlabel("time [ms]")
ax.set_ylabel("overpressure [bar]")
ax.grid(alpha=0.3)
ax.legend(fontsize=8)
save(figure, "history.png")
