"""Figures of README.md's table, and pictures: air and plates, crack, stress and
pressure at the mid-plane, air that flows into the crack."""

import numpy as np

import fields
from fields import STRESS
from mpm.case import Case
from mpm.pictures import (BODY, FAILED, GAS, PART, SIGNED, VALUES, colourBar, drawPoints, frame,
                          plt, save)

VACUUM, POROUS, NO_DRAG = "variants/vacuum", "variants/porous", "variants/noDrag"

# Figures
print("first failure [us]: " + ", ".join(
    f"{name} {fields.firstFailure(case)*1e6:.4f}" for name, case in
    (("air", "."), ("vacuum", VACUUM), ("porous", POROUS), ("no drag", NO_DRAG))))
t343 = {case: fields.crossing(*Case(case).series("midPlane", "sigma_yy.dat").T, STRESS/2)
        for case in (".", VACUUM, POROUS)}
print("t343 [us]: " + ", ".join(f"{case} {t*1e6:.5f}" for case, t in t343.items()))
print(f"t343 in air against vacuum {100*(t343['.']/t343[VACUUM] - 1):+.4f} %")
print(f"t343 porous against dense {100*(t343[POROUS]/t343['.'] - 1):+.4f} %")
for name, case in (("stick", "."), ("porous", POROUS), ("no drag", NO_DRAG)):
    p = Case(case).numbers("^    p N to N,")
    Theta = Case(case).numbers("^Theta: min N, max N")
    print(f"{name}: p {p.min():.0f} to {p.max():.0f} Pa, fix-ups {Case(case).fixups():.0f}, "
          f"Theta {Theta.min():.5f} to {Theta.max():.5f}, gas mass of the crack's edges "
          f"x {fields.crackMass(case)[1][-1]:.3f}")
t, sigma = Case().series("midPlane", "sigma_yy.dat").T
gas = Case().series("gas", "p")
tension = np.interp(gas[:, 0], t, sigma) > 0
tension &= gas[:, 0] <= t[np.argmax(sigma)]
print(f"air at the mid-plane while the solid is in tension (up to {sigma.max()*1e-6:.0f} MPa): "
      f"{gas[tension, 1:].min()*1e-5:.3f} to {gas[tension, 1:].max()*1e-5:.3f} bar")
seconds = {case: Case(case).numbers("^ExecutionTime = N s")[-1] for case in (".", VACUUM)}
print(f"CPU time {seconds['.']:.2f} s, vacuum {seconds[VACUUM]:.2f} s: "
      f"x {seconds['.']/seconds[VACUUM]:.2f}")


# Points over cells
_, _, X, Y = fields.mesh()
X, Y = X*1e3, Y*1e3


def plates(ax, case, time, stress=True, pieces=1):
    """Points with their stress or in one colour; failed ones in theirs, in pieces of
    this part of their boxes."""
    for phase in ("target", "flyer"):
        points = Case(case).points(time, phase)
        values = points["sigma"][:, 3]*1e-6 if stress else BODY
        failed = points["damage"] > 0.5
        drawPoints(ax, points, FAILED, some=failed, scale=1e3, close=0.2, size=pieces)
        image = drawPoints(ax, points, values, SIGNED, (-700, 700), some=~failed, scale=1e3,
                           close=0.2, outline="0.3")
    return image


def speed(case, time):
    return np.linalg.norm(fields.cells(case, time, "U.air"), axis=2)


chosen = [Case().nearest(t) for t in (0.6e-6, 1.4e-6, 3e-6)]
figure, axes = plt.subplots(2, 3, figsize=(10.5, 6.2), sharex=True, sharey=True)
for column, time in zip(axes.T, chosen):
    for ax in column:
        frame(ax, (X[0], X[-1]), (Y[0], Y[-1]), None, None)
    column[0].set_title(f"{float(time)*1e6:.1f} $\\mu$s")
    column[1].set_xlabel("x [mm]")
    pressure = column[0].pcolormesh(X, Y, fields.cells(".", time, "p")*1e-5, cmap=VALUES,
                                    vmin=0.5, vmax=1.5, zorder=GAS, rasterized=True)
    plates(column[0], ".", time, False)
    velocity = column[1].pcolormesh(X, Y, speed(".", time), cmap=VALUES, vmin=0, vmax=110,
                                    zorder=GAS, rasterized=True)
    stress = plates(column[1], ".", time)
for ax in axes[:, 0]:
    ax.set_ylabel("y [mm]")
colourBar(figure, pressure, axes[0], "pressure of the air [bar]")
colourBar(figure, stress, axes[1], "stress of the plates along y [MPa]", location="bottom",
          shrink=0.5, pad=0.02)
colourBar(figure, velocity, axes[1], "speed of the air [m/s]")
axes[0, 0].legend(handles=[plt.Rectangle((0, 0), 1, 1, color=c) for c in (BODY, FAILED)],
                  labels=["plates", "failed"], loc="upper left", labelcolor="w")
save(figure, "plates.png")

# The crack at the right edge, at the end
last = chosen[-1]
centre = 0.5*(X[1:] + X[:-1]), 0.5*(Y[1:] + Y[:-1])
figure, axes = plt.subplots(1, 2, figsize=(10, 4), sharey=True)
for ax, case, label in ((axes[0], ".", "sticking drag"), (axes[1], NO_DRAG, "without drag")):
    time = Case(case).nearest(3e-6)
    frame(ax, (2.4, 4.7), (0.9, 2.6), ylabel=None, title=label)
    image = ax.pcolormesh(X, Y, fields.cells(case, time, "p")*1e-5, cmap=PART, vmin=0,
                          vmax=1.1, zorder=GAS, rasterized=True)
    plates(ax, case, time, False, 0.4)
    u = np.where(fields.cells(case, time, "theta.air")[..., None] > 0.1,
                 fields.cells(case, time, "U.air"), np.nan)
    every = (slice(None, None, 2),)*2
    arrows = ax.quiver(centre[0][::2], centre[1][::2], u[every][..., 0], u[every][..., 1],
                       color="k", scale=1800, width=0.004, zorder=5)
    ax.quiverkey(arrows, 0.87, 0.92, 200, "200 m/s", coordinates="axes",
                 zorder=6)
axes[0].set_ylabel("y [mm]")
axes[0].legend(handles=[plt.Rectangle((0, 0), 1, 1, color=c) for c in (BODY, FAILED)],
               labels=["plate", "failed"], loc="lower left", framealpha=1, frameon=True)
colourBar(figure, image, axes, "pressure of the air [bar]", shrink=0.85)
save(figure, "crack.png")

# Mid-plane over time
figure, axes = plt.subplots(3, 1, figsize=(7.5, 8.5), sharex=True)
for case, style, label in ((VACUUM, "k-", "vacuum"), (".", "C0--", "air, dense"),
                           (POROUS, "C3:", "air, volume fraction 0.9")):
    t, sigma = Case(case).series("midPlane", "sigma_yy.dat").T
    axes[0].plot(t*1e6, sigma*1e-6, style, label=label)
axes[0].axhline(400, color="k", ls=":", lw=0.8)
axes[0].text(0.02, 430, "strength", fontsize=8)
axes[0].set_ylim(-950, 550)
axes[0].set_ylabel("stress yy of the solid\nat the mid-plane [MPa]")
axes[0].legend()
for column, label in ((1, "in the middle"), (2, "0.5 mm inside the free edge"),
                      (3, "0.1 mm inside")):
    axes[1].plot(gas[:, 0]*1e6, gas[:, column]*1e-5, label=label)
axes[1].set_ylim(0, None)
axes[1].set_ylabel("pressure of the air\nat the mid-plane [bar]")
axes[1].legend()
for case, label in ((NO_DRAG, "without drag"), (".", "sticking drag"),
                    (POROUS, "sticking drag, porous")):
    t, mass = fields.crackMass(case)
    axes[2].plot(t*1e6, mass, ".-", ms=3, label=label)
axes[2].set_ylabel("air in the crack within 6 cells of\nthe edges / at first failure")
axes[2].set_xlabel("time [us]")
axes[2].legend()
for ax in axes:
    ax.axvline(fields.firstFailure(".")*1e6, color="k", ls=":", lw=0.8)
save(figure, "midPlane.png")
