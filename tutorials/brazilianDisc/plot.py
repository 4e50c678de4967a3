"""Figures of README.md's table, and pictures: load over time, crack."""

import numpy as np

import results
from mpm.case import Case
from mpm.pictures import plt
from results import EXACT

t, top, bottom, kinetic, strain, residual = results.loads()
force = 0.5*(top + bottom)
i = force.argmax()
time, place, n, spread = results.firstDamage()
least = results.tension(spread/0.5)/results.tension(0)
print(f"first damage by {time:.3f} s: {n} points about ({place[0]:+.4f} {place[1]:+.4f}) m, "
      f"load {np.interp(time, t, force):.1f} N/m")
print(f"    they reach {spread:.3f} m from the centre, where the exact tension is "
      f"{100*least:.1f} % of the centre's")
print(f"peak load {force[i]:.1f} N/m at {t[i]:.4f} s (upper jaw {top.max():.1f}, lower "
      f"{bottom.max():.1f}), exact {EXACT:.1f}: {100*(force[i]/EXACT - 1):+.2f} %")
print(f"kinetic over stored energy at first damage: "
      f"{100*np.interp(time, t, kinetic/strain):.2f} %")
print(f"residual of the energy budget: {100*residual[i]/strain[i]:+.2f} % of the stored energy "
      f"at the peak, at most {100*abs(residual).max()/strain.max():.2f} % in all")

figure, ax = plt.subplots(figsize=(7, 4))
ax.plot(t, top, lw=1, label="upper jaw")
ax.plot(t, bottom, lw=1, label="lower jaw")
ax.axhline(EXACT, color="k", ls=":", lw=1, label="pi R sigma_t")
ax.axvline(time, color="0.6", lw=0.8)
ax.set_xlabel("time [s]")
ax.set_ylabel("load [N/m]")
ax.legend()
figure.savefig("load.png")

case = Case()
last = case.times("lagrangian")[-1]
figure, axes = plt.subplots(1, 3, figsize=(14, 4.6), sharey=True)
for ax, want in zip(axes, (time, t[i] + 0.01, float(last))):
    name = case.nearest(want, "lagrangian")
    for phase in ("caps", "upper", "lower"):
        ax.scatter(*case.points(name, phase)["x"][:, :2].T, s=3, color="0.7", lw=0)
    disc = case.points(name, "disc")
    x, damage, stress = disc["x"], disc["damage"], disc["sigma"][:, 0]
    image = ax.scatter(*x[:, :2].T, s=3, c=stress, cmap="RdBu_r", vmin=-700, vmax=700, lw=0)
    ax.scatter(*x[damage > 0][:, :2].T, s=3, c=damage[damage > 0], cmap="Greys", vmin=-0.5,
               vmax=1, lw=0)
    ax.set_aspect("equal")
    ax.set_title(f"{name} s", fontsize=9)
figure.colorbar(image, ax=axes, label="sigma_xx [Pa]; damaged: black")
figure.savefig("crack.png", dpi=110)
