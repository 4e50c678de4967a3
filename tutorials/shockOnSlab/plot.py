"""Figures of README.md's table; pictures of slab, disc and wedge."""

import numpy as np

from mpm.case import Case
from mpm.pictures import BODY, GAS, VALUES, colourBar, drawPoints, frame, plt, save

GAMMA, R, P1, T1, MS = 1.4, 287, 1e5, 290, 2
C1 = np.sqrt(GAMMA*R*T1)
RHO1 = P1/(R*T1)


def behindShock():
    """p, rho and u behind the shock, p and speed of the one that a wall sends back."""
    g = GAMMA
    p2 = P1*(1 + 2*g/(g + 1)*(MS**2 - 1))
    rho2 = RHO1*(g + 1)*MS**2/((g - 1)*MS**2 + 2)
    u2 = 2*C1/(g + 1)*(MS - 1/MS)
    pr = p2*((3*g - 1)*p2 - (g - 1)*P1)/((g - 1)*p2 + (g + 1)*P1)
    return p2, rho2, u2, pr, (pr - p2)/(rho2*u2) - u2


P2, RHO2, U2, PR, W = behindShock()

# --- slab: 1D
slab = Case("slab")
n, face = 400, 0.80075
arrival = face/(MS*C1)
x = (np.arange(n) + 0.5)/n
last = slab.times()[-1]
p = slab.field(last, "p")
back = W*(float(last) - arrival)         # way of the reflected shock
window = (x > face - 0.8*back) & (x < face - 0.02)
middle = np.nonzero(p > 0.5*(P2 + PR))[0][0]
found = x[middle - 1] + (0.5*(P2 + PR) - p[middle - 1])/(p[middle] - p[middle - 1])/n
largest = slab.numbers("^    p N to N,")[:, 1].max()
Theta = slab.numbers("^Theta: min N, max N")
print(f"slab: reflected pressure {p[window].mean()*1e-5:.4f} bar, exact {PR*1e-5:.4f}"
      f" ({100*(p[window].mean()/PR - 1):+.3f} %)")
print(f"slab: largest pressure ever {100*(largest/PR - 1):+.2f} % of it")
print(f"slab: speed of the reflected shock {(face - found)/(float(last) - arrival):.1f} m/s,"
      f" exact {W:.1f}")
print(f"slab: fix-ups {slab.fixups():.0f}, Theta {Theta.min():.6f} to"
      f" {Theta.max():.6f}")
figure, axes = plt.subplots(1, 2, figsize=(12, 4.5))
for time, color in zip([t for t in slab.times() if float(t) in
                        (0.6e-3, 1.0e-3, 1.4e-3, 1.8e-3)], ("C0", "C1", "C2", "C3")):
    t = float(time)
    line = slab.field(time, "p")*1e-5
    gas = x < face
    axes[0].plot(x[gas], line[gas], color, lw=1.5, label=f"{t*1e3:.1f} ms")
    if t < arrival:
        s = MS*C1*t
        axes[0].plot([0, s, s, face], np.array([P2, P2, P1, P1])*1e-5, "k:", lw=1)
    else:
        s = face - W*(t - arrival)
        axes[0].plot([0, s, s, face], np.array([P2, P2, PR, PR])*1e-5, "k:", lw=1)
axes[0].axvspan(face, 1, color="0.85")
axes[0].text(0.5*(face + 1), 8, "slab", ha="center")
axes[0].set_xlabel("x [m]")
axes[0].set_ylabel("pressure of the air [bar]; dotted: exact")
axes[0].legend()
probe = slab.series("front", "p")
for column, place in ((1, 0.65), (2, 0.75), (3, 0.798)):
    axes[1].plot(probe[:, 0]*1e3, probe[:, column]*1e-5, lw=1, label=f"x = {place} m")
axes[1].axhline(PR*1e-5, color="k", ls=":", lw=1)
axes[1].set_xlabel("time [ms]")
axes[1].set_ylabel("pressure of the air [bar]")
axes[1].legend()
save(figure, "slab.png")

# --- disc: 2D
disc, nx, ny = Case("cylinder"), 160, 120
p, v = (disc.field(disc.times()[-1], name, nx, ny) for name in ("p", "U.air"))
print(f"disc: |p - p mirrored|/p2 {np.abs(p - p[::-1]).max()/P2:.1e}, |v + v mirrored|/u2"
      f" {np.abs(v[..., 1] + v[::-1, :, 1]).max()/U2:.1e}")
extremes = disc.numbers("^    p N to N,")
print(f"disc: least pressure {extremes[:, 0].min()/P1:.3f} p1, largest"
      f" {extremes[:, 1].max()/PR:.3f} of the pressure at a plane wall; fix-ups"
      f" {disc.fixups():.0f}")
nose = disc.series("nose", "p")
print(f"disc: 2.5 mm before the nose at most {nose[:, 1].max()*1e-5:.2f} bar")

figure, axes = plt.subplots(1, 4, figsize=(12.5, 2.9), sharey=True)
edges = np.arange(nx + 1), np.arange(ny + 1)
for ax, wanted in zip(axes, (0.08e-3, 0.12e-3, 0.16e-3, 0.2e-3)):
    time = disc.nearest(wanted)
    frame(ax, (0, nx), (0, ny), ylabel=None, title=f"{float(time)*1e3:.2f} ms")
    image = ax.pcolormesh(*edges, disc.field(time, "p", nx, ny)*1e-5, cmap=VALUES, vmin=1,
                          vmax=12, rasterized=True, zorder=GAS)
    drawPoints(ax, disc.points(time, "disc"), BODY, scale=1e3, outline="k")
    ax.axvline(MS*C1*float(time)*1e3, color="w", ls=":", lw=1)
axes[0].set_ylabel("y [mm]")
colourBar(figure, image, axes, "pressure [bar]", shrink=0.9, aspect=18)
save(figure, "cylinder.png")

# --- wedge: 2D
wedge, nx, ny, tip = Case("wedge"), 100, 70, 0.2
angle, BETA, RATIO = np.radians(10), np.radians(39.31), 1.7066     # NACA 1135
p = wedge.field(wedge.times()[-1], "p", nx, ny)/P1
x, y = (np.arange(nx) + 0.5)/nx, (np.arange(ny) + 0.5)*0.7/ny
where, behind = [], []
inside = [i for i in range(nx) if 0.45 < x[i] < 0.95]
for i in inside:
    middle = 0.5*(1 + RATIO)
    j = np.max(np.nonzero(p[:, i] > middle)[0])
    where.append(y[j] + (y[1] - y[0])*(p[j, i] - middle)/(p[j, i] - p[j + 1, i]))
    low, high = (np.tan(angle) + part*(np.tan(BETA) - np.tan(angle)) for part in (0.2, 0.7))
    slope = y/(x[i] - tip)
    behind.append(p[(slope > low) & (slope < high), i].mean())
found = np.degrees(np.arctan(np.polyfit(x[inside], where, 1)[0]))
print(f"wedge: angle of the shock {found:.2f} degrees, exact {np.degrees(BETA):.2f}")
print(f"wedge: p2/p1 {np.mean(behind):.4f} ({min(behind):.3f} to {max(behind):.3f}), exact"
      f" {RATIO} ({100*(np.mean(behind)/RATIO - 1):+.2f} %); fix-ups"
      f" {wedge.fixups():.0f}")
figure, ax = plt.subplots(figsize=(7, 3.9))
frame(ax, (0, 1), (0, 0.5), "x [m]", "y [m]")
image = ax.pcolormesh(np.linspace(0, 1, nx + 1), np.linspace(0, 0.7, ny + 1), p, cmap=VALUES,
                      vmin=1, vmax=1.8, rasterized=True, zorder=GAS)
drawPoints(ax, wedge.points(wedge.times()[-1], "wedge"), BODY, outline="k")
for slope, x, name in ((BETA, 0.58, f"exact shock, {np.degrees(BETA):.1f}$^\\circ$"),
                       (angle, 0.6, "wedge, 10$^\\circ$")):
    ax.text(x, (x - tip)*np.tan(slope) - 0.015, name, fontsize=9, rotation_mode="anchor",
            rotation=np.degrees(slope), ha="center", va="top", zorder=5)
ax.plot([tip, 1], [0, (1 - tip)*np.tan(BETA)], "k:", lw=1.2, zorder=5)
ax.annotate("", (0.16, 0.25), (0.04, 0.25), arrowprops={"arrowstyle": "-|>", "color": "w"},
            zorder=5)
ax.text(0.04, 0.26, "Mach 2", color="w", zorder=5)
colourBar(figure, image, ax, "p/p$_1$", shrink=0.9)
save(figure, "wedge.png")
