"""Figures of README.md's table, and pictures: load over time, crack."""

import numpy as np

import results
from mpm.case import Case
from mpm.pictures import RIGID, SIGNED, colourBar, drawPoints, frame, plt, save
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
save(figure, "load.png")

case = Case()
last = case.times("lagrangian")[-1]
figure, axes = plt.subplots(1, 3, figsize=(11, 3.9), sharey=True)
for ax, want in zip(axes, (time, t[i] + 0.01, float(last))):
    name = case.nearest(want, "lagrangian")
    frame(ax, (-0.6, 0.6), (-0.68, 0.68), "x [m]", None, f"{float(name):.2f} s")
    for phase in ("caps", "upper", "lower"):
        drawPoints(ax, case.points(name, phase), RIGID)
    disc = case.points(name, "disc")
    image = drawPoints(ax, disc, disc["sigma"][:, 0], SIGNED, (-700, 700), disc["damage"] >= 0.99,
                       outline="0.3")
axes[0].set_ylabel("y [m]")
colourBar(figure, image, axes, "$\\sigma_{xx}$ [Pa]; failed dark", shrink=0.9)
save(figure, "crack.png")
