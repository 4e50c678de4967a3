"""Stress at the mid-plane and x-t diagram against the exact solution; the plates.

Exact (linear elastic, one dimension, no failure): c = sqrt(E/rho), the impact
makes sigma = rho c v/2 = 687.4 MPa of compression; release waves from both
free surfaces meet at the target's mid-plane at t = 3 H/c = 1.1195 us (H the
flyer's thickness) and leave tension of the same size behind them.
"""

import numpy as np

from mpm.case import Case
from mpm.pictures import FAILED, SIGNED, colourBar, drawPoints, frame, plt, save

RHO, E, V, H = 2700.0, 70e9, 100.0, 1.9e-3
C = np.sqrt(E/RHO)
STRESS = RHO*C*V/2


def exact(x, t):
    """sigma_yy of flyer (2H..3H, -V at the start) and target (0..2H): waves of
    the initial velocity, reflected at the free surfaces 0 and 3H."""
    def velocity(y):
        y = np.mod(y, 6*H)
        y = np.where(y > 3*H, 6*H - y, y)
        return np.where(y > 2*H, -V, 0.0)
    return 0.5*RHO*C*(velocity(x + C*t) - velocity(x - C*t))


# Mid-plane and free surface over time
case = Case()
t, stress = case.series("midPlane", "sigma_yy.dat").T
ts, surface = case.series("freeSurface", "U_y.dat").T

figure, axes = plt.subplots(2, 1, figsize=(7, 7), sharex=True)
fine = np.linspace(0, t[-1], 3000)
axes[0].plot(fine*1e6, exact(np.full_like(fine, H), fine)*1e-6, "k-", lw=0.8,
             label="exact, without failure")
axes[0].plot(t*1e6, stress*1e-6, "C0-", label="materialPointFoam")
axes[0].axhline(400, color="C3", ls=":", label="strength")
axes[0].axvline(3*H/C*1e6, color="k", ls=":", lw=0.8)
axes[0].set_ylabel("stress at the mid-plane [MPa]")
axes[0].legend()
arrival = 2*H/C
axes[1].plot(np.array([0, arrival, arrival, fine[-1]])*1e6, [0, 0, 100, 100],
             "k-", lw=0.8, label="exact until the release arrives (instant failure: stays)")
axes[1].plot(ts*1e6, -surface, "C0-", label="materialPointFoam")
axes[1].set_xlabel("time [us]")
axes[1].set_ylabel("free-surface velocity [m/s]")
axes[1].legend()
save(figure, "stress.png")

half = STRESS/2
late = np.where((t > 0.8e-6) & (stress > half))[0]
if len(late):
    i = late[0]
    t343 = t[i - 1] + (half - stress[i - 1])*(t[i] - t[i - 1])/(stress[i] - stress[i - 1])
    print(f"t343 {t343*1e6:.4f} us, exact {3*H/C*1e6:.4f} us, "
          f"error {(t343 - 3*H/C)*1e9:.1f} ns")
plateau = (t > 0.6e-6) & (t < 0.95e-6)
print(f"plateau {stress[plateau].mean()*1e-6:.1f} MPa, exact {-STRESS*1e-6:.1f} MPa")
plateau = (ts > 0.85e-6) & (ts < 1.05e-6)
print(f"free surface {-surface[plateau].mean():.2f} m/s, exact {V:.0f} m/s")

# x-t diagram
table = case.series("stressXT", "sigma_yy.dat")
with open(case.file("postProcessing/stressXT/0/sigma_yy.dat")) as f:
    header = [line for line in f if line.startswith("#")]
centres = np.array([float(w) for w in header[-1].replace("#", " ").split()
                    if w.replace(".", "").replace("e", "").replace("-", "")
                    .replace("+", "").isdigit()])
figure, axes = plt.subplots(1, 2, figsize=(9, 4.6), sharey=True)
for ax, values, title in (
        (axes[0], table[:, 1:], "material points"),
        (axes[1], exact(centres[None, :], table[:, 0][:, None]),
         "exact, without failure")):
    image = ax.pcolormesh(centres*1e3, table[:, 0]*1e6, values*1e-6, cmap=SIGNED,
                          vmin=-700, vmax=700, shading="nearest", rasterized=True)
    ax.set_title(title)
    ax.set_xlabel("y at the start [mm]")
    ax.axvline(2e3*H, color="k", lw=0.6)
    for x, name in ((H, "target"), (2.5*H, "flyer")):
        ax.text(x*1e3, 0.06, name, ha="center", fontsize=8)
axes[0].set_ylabel("time [us]")
colourBar(figure, image, axes, "stress along y [MPa], tension positive")
save(figure, "xt.png")


# The plates: compression, release, tension that tears the target, the gap
def plates(ax, want, title, xlim=(-4.3, 4.3), ylim=(-0.8, 6.3)):
    """Points coloured by their stress along y; failed ones in their own colour."""
    time = case.nearest(want, "lagrangian")
    frame(ax, xlim, ylim, ylabel=None, title=f"{float(time)*1e6:.2f} $\\mu$s: {title}")
    for phase in ("target", "flyer"):
        cloud = case.points(time, phase)
        # The gap is as wide as it is: its edges are not drawn together
        image = drawPoints(ax, cloud, cloud["sigma"][:, 3]*1e-6, SIGNED, (-700, 700),
                           cloud["damage"] > 0.5, scale=1e3, close=0.2, outline="0.3")
    return image


def moves(ax, y, places=(-2.6, 0, 2.6)):
    for x in places:
        ax.annotate("", (x, y - 0.75), (x, y + 0.25), zorder=5, arrowprops={
            "arrowstyle": "-|>", "color": "k", "lw": 1})


GAP = (2.6, 4.2), (1.1, 2.4)
figure, axes = plt.subplots(1, 5, figsize=(12.5, 2.75))
plates(axes[0], 0.25e-6, "compression runs out")
image = plates(axes[1], 1.0e-6, "release from both faces")
plates(axes[2], 1.25e-6, "tension tears the target")
plates(axes[3], 3e-6, "the gap opens")
plates(axes[4], 3e-6, "at its edge", *GAP)
axes[3].indicate_inset([GAP[0][0], GAP[1][0], np.ptp(GAP[0]), np.ptp(GAP[1])], edgecolor="k")
axes[0].set_ylabel("y [mm]")
axes[0].text(0, 5.35, "flyer, 100 m/s", ha="center", va="center", fontsize=8)
axes[0].text(0, 1.2, "target", ha="center", va="center", fontsize=8)
axes[3].text(0, 0.7, "100 m/s", ha="center", va="center", fontsize=8)
moves(axes[0], 5.6, (-3, 3))
moves(axes[3], 0.95, (-3,))
colourBar(figure, image, axes, "stress along y [MPa]\n(tension positive)", shrink=0.75,
          aspect=18)
axes[4].legend(handles=[plt.Rectangle((0, 0), 1, 1, color=FAILED)], labels=["failed"],
               loc="lower left", frameon=True)
save(figure, "plates.png")
