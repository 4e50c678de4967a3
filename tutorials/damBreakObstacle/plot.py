"""Figures of README.md's table, and the picture: water and obstacle at three times, displacement
of the obstacle's upper corner over time beside six published computations."""

import numpy as np

from mpm.case import Case
from mpm.pictures import BODY, GAS, PART, drawPoints, frame, plt, save

#: Displacement of the corner along x [mm] every 20 ms from 160 to 300 ms, its peak [mm, s], when
#: it passes 10 mm [s], from curves that others took off the published figures: Meduri and
#: Ryzhakov from github.com/solids4foam/solids4foam, tutorials/fluidSolidInteraction/
#: flexibleDamBreak/referenceSolution; the others from github.com/LandslideSIM/
#: MaterialPointSolver.jl, docs/assets/data/2d_water_structure
PUBLISHED = {
    "Walhorn 2005": (
        (0.8, 14.0, 30.2, 39.5, 41.4, 40.0, 35.8, 31.1),
        (41.4, 0.246), 0.176),
    "Idelsohn 2008": (
        (9.0, 25.6, 38.1, 46.2, 48.2, 47.0, 44.7, 41.3),
        (48.2, 0.242), 0.161),
    "Rafiee 2009": (
        (5.9, 21.3, 34.9, 43.2, 46.7, 46.9, 45.1, 42.1),
        (47.2, 0.255), 0.165),
    "Ryzhakov 2010": (
        (8.5, 24.5, 35.8, 40.4, 40.9, 37.9, 33.3, 28.9),
        (41.0, 0.235), 0.163),
    "Li 2015": (
        (7.5, 26.1, 39.5, 46.2, 48.2, 46.8, 44.6, 41.8),
        (48.2, 0.243), 0.164),
    "Meduri 2018": (
        (2.9, 25.3, 41.7, 47.7, 48.8, 46.5, 41.8, 39.3),
        (49.1, 0.235), 0.165),
}
WHEN = np.arange(160, 301, 20)
#: Speed of sound of the water [m/s]; thickness of the mesh [m]
SOUND, DEPTH = 35.0, 0.005


def band(values):
    return f"{min(values):g} to {max(values):g}"


case = Case()
nx, ny = (int(case.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))
x, y = (1e3*e for e in case.edges()[:2])
tip = case.series("tip", "displacement.dat", once=True)
t, u = tip[:, 0], 1e3*tip[:, 1]
i = np.argmax(u)
curves = np.array([p[0] for p in PUBLISHED.values()])
print(f"largest displacement of the upper corner along x: {u[i]:.1f} mm at {t[i]:.3f} s,"
      f" published {band([p[1][0] for p in PUBLISHED.values()])} mm at"
      f" {band([p[1][1] for p in PUBLISHED.values()])} s")
print(f"it passes 10 mm at {np.interp(10, u[:i], t[:i]):.3f} s,"
      f" published {band([p[2] for p in PUBLISHED.values()])} s")
print(f"at 0.3 s: {np.interp(0.3, t, u):.1f} mm,"
      f" published {band(curves[:, WHEN == 300].ravel())} mm")
mine = np.interp(1e-3*WHEN, t, u)
off = np.maximum(np.maximum(curves.min(axis=0) - mine, mine - curves.max(axis=0)), 0)
print(f"every 20 ms from 160 to 300 ms: {np.sum(off == 0)} of {len(WHEN)} within the published"
      f" band, at most {off.max():.1f} mm outside (at {WHEN[np.argmax(off)]} ms)")

times = case.times("lagrangian")[1:]
fastest = 0
for time in times:
    mass = case.field(time, "thetaRho.water", nx, ny)
    # Cells with water, none of the obstacle
    fastest = max(fastest, np.linalg.norm(case.field(time, "U", nx, ny), axis=-1)[mass > 900].max())
print(f"largest velocity of water over its sound: {fastest:.2f}/{SOUND:.0f}"
      f" = {fastest/SOUND:.3f}")
Theta = case.numbers("^Theta: min N, max N")
# Columns: 3 total of the points, 7 residual, 12 work of gravity in the fluids' faces
e = case.series("energy", "energy.dat", once=True)
residual, took, worked = abs(e[:, 7]).max(), np.ptp(e[:, 3]), np.ptp(e[:, 12])
print(f"energy residual {residual:.2e} J: {100*residual/worked:.2f} % of gravity's work"
      f" {worked:.2e} J, {100*residual/took:.1f} % of what the obstacle took, {took:.2e} J")
for name in ("water", "air"):
    m = case.series("balance", f"{name}.dat", once=True)
    print(f"mass of {name} that nobody gave: {abs(m[:, 9]).max()/m[0, 1]:.0e}")
print(f"Theta {Theta.min():.5f} to {Theta.max():.5f}; {case.nSteps()} steps,"
      f" {case.solverSeconds():.0f} s")

figure, axes = plt.subplots(1, 4, figsize=(13, 2.8), gridspec_kw={"width_ratios": (1, 1, 1, 1.2)})
for ax, want in zip(axes, (0.16, 0.22, 0.3)):
    time = case.nearest(want, "lagrangian")
    frame(ax, (0, x[-1]), (0, y[-1]), title=f"{1e3*float(time):.0f} ms")
    ax.pcolormesh(x, y, 1 - case.field(time, "alpha.water", nx, ny), cmap=PART, vmin=0, vmax=1,
                  rasterized=True, zorder=GAS)
    drawPoints(ax, case.points(time, "obstacle"), BODY, scale=1e3, section=DEPTH)
ax = axes[3]
for colour, (name, (curve, _, _)) in zip("0.35 0.6 C2 C1 C4 C5".split(), PUBLISHED.items()):
    ax.plot(WHEN, curve, colour, ls="--", lw=1, label=name)
ax.plot(1e3*t, u, "C0", lw=2, label="this case")
ax.set_xlabel("time [ms]")
ax.set_title("displacement of the upper corner [mm]")
ax.legend(fontsize=6, loc="upper left")
ax.grid(alpha=0.3)
save(figure, "damBreakObstacle.png")
