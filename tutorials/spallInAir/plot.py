"""Figures of README.md's table, and pictures: air and plates, crack, stress and
pressure at the mid-plane, air that flows into the crack."""

import numpy as np

import fields
from fields import STRESS
from mpm.case import Case
from mpm.pictures import plt

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


def plates(ax, time):
    """Points with their stress; failed ones green."""
    for phase in ("target", "flyer"):
        points = Case().points(time, phase)
        x, failed, sigma = points["x"]*1e3, points["damage"] > 0.5, points["sigma"][:, 3]*1e-6
        image = ax.scatter(*x[~failed, :2].T, c=sigma[~failed], cmap="RdBu_r", vmin=-700,
                           vmax=700, s=5, marker="s", linewidths=0)
        ax.scatter(*x[failed, :2].T, c="limegreen", s=5, marker="s", linewidths=0)
    return image


def failedPoints(ax, time):
    points = Case().points(time, "target")
    x, failed = points["x"]*1e3, points["damage"] > 0.5
    ax.scatter(*x[failed, :2].T, c="limegreen", s=0.6, marker="s", linewidths=0)


def air(ax, time, name):
    """Cells: pressure [bar] or speed of the gas [m/s]."""
    if name == "p":
        return ax.pcolormesh(X, Y, fields.cells(".", time, "p")*1e-5, cmap="PuOr_r",
                             vmin=0.5, vmax=1.5)
    speed = np.linalg.norm(fields.cells(".", time, "U.air"), axis=2)
    return ax.pcolormesh(X, Y, speed, cmap="magma", vmin=0, vmax=110)


chosen = [Case().nearest(t) for t in (0.6e-6, 1.4e-6, 3e-6)]
figure, axes = plt.subplots(2, 3, figsize=(13, 7.4), sharex=True, sharey=True)
for column, time in zip(axes.T, chosen):
    pressure = air(column[0], time, "p")
    stress = plates(column[0], time)
    speed = air(column[1], time, "U")
    failedPoints(column[1], time)
    column[0].set_title(f"t = {float(time)*1e6:.1f} us")
    column[1].set_xlabel("x [mm]")
    for ax in column:
        ax.set_aspect("equal")
for ax in axes[:, 0]:
    ax.set_ylabel("y [mm]")
figure.colorbar(stress, ax=axes[0], label="stress yy of the points [MPa]", pad=0.01,
                aspect=30)
figure.colorbar(pressure, ax=axes[0], label="pressure of the air [bar]", pad=0.06,
                aspect=30)
figure.colorbar(speed, ax=axes[1], label="speed of the air [m/s]; green: failed points",
                aspect=30)
figure.savefig("plates.png")

# The crack at the right edge, at the end
last = chosen[-1]
centre = 0.5*(X[1:] + X[:-1]), 0.5*(Y[1:] + Y[:-1])
figure, axes = plt.subplots(1, 2, figsize=(12.5, 5.5), sharey=True)
for ax, case, label in ((axes[0], ".", "sticking drag"), (axes[1], NO_DRAG, "without drag")):
    time = Case(case).nearest(3e-6)
    image = ax.pcolormesh(X, Y, fields.cells(case, time, "p")*1e-5, cmap="viridis",
                          vmin=0, vmax=1.2)
    for phase in ("target", "flyer"):
        points = Case(case).points(time, phase)
        x, failed = points["x"]*1e3, points["damage"] > 0.5
        ax.scatter(*x[~failed, :2].T, c="0.8", s=5, linewidths=0)
        ax.scatter(*x[failed, :2].T, c="red", s=7, linewidths=0)
    u = fields.cells(case, time, "U.air")
    arrows = ax.quiver(*centre, u[..., 0], u[..., 1], color="w", scale=2500, width=0.003)
    ax.quiverkey(arrows, 0.87, 0.94, 200, "200 m/s", labelcolor="w", coordinates="axes")
    ax.set_aspect("equal")
    ax.set_xlim(2.2, 4.8)
    ax.set_ylim(0.7, 2.8)
    ax.set_xlabel("x [mm]")
    ax.set_title(f"{label}, t = {float(time)*1e6:.1f} us", fontsize=10)
axes[0].set_ylabel("y [mm]")
figure.colorbar(image, ax=axes, pad=0.01,
                label="pressure of the air [bar]; arrows: its velocity; failed points red")
figure.savefig("crack.png")

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
figure.savefig("midPlane.png")
