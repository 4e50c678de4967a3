"""Figures of README.md's table, and the picture: the wedge in the water, pressure along its
face and force over time beside the similarity solution."""

import re

import numpy as np

from mpm.case import Case
from mpm.pictures import GAS, PART, RIGID, drawPoints, frame, plt, save

#: Velocity [m/s], height of the tip over the water [m], tangent of the deadrise, thickness
V, GAP, SLOPE, DEPTH, RHO, P0 = 10.0, 0.004, np.tan(np.radians(30)), 0.002, 1000.0, 1e5
#: Similarity solution of Dobrovol'skaya (J. Fluid Mech. 36 (1969) 805) at 30 degrees, digits
#: of Zhao & Faltinsen (J. Fluid Mech. 246 (1993) 593), from memory: largest pressure over
#: rho V^2/2, its height over the still water over V t, force on both faces over rho V^3 t
PEAK, HEIGHT, FORCE = 6.927, 0.4243, 14.139
#: Wagner (1932): c = pi V t/(2 tan), peak (pi/(2 tan))^2
WAGNER = np.pi/2/SLOPE

case = Case()
nx, ny = (int(case.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))
x, y = case.edges()[:2]
xc, yc = 0.5*(x[1:] + x[:-1]), 0.5*(y[1:] + y[:-1])


def face(time):
    """Pressure coefficient in the highest cells below the wedge without any of it, and
    where they have no water nan."""
    theta = case.field(time, "theta", nx, ny)
    p = case.field(time, "p", nx, ny)
    water = case.field(time, "alpha.water", nx, ny)
    tip = GAP - V*float(time)
    found = np.full(nx, np.nan)
    for i in range(nx):
        below = np.flatnonzero((theta[:, i] > 0.999) & (yc < tip + xc[i]*SLOPE))
        if len(below) and water[below[-1], i] > 0.5:
            found[i] = (p[below[-1], i] - P0)/(0.5*RHO*V**2)
    return found


log = case.log()
t = np.array([float(v) for v in re.findall(r"^Time = (\S+)", log, re.M)])
F = case.numbers(r"Load on wedge: force \(\S+ N")
# Each force is the mean since the line before
t = t[:len(F)] - GAP/V
t, F = 0.5*(t[1:] + t[:-1]), F[1:]
late = t > 0.5*t[-1]
unit = 0.5*RHO*V**3*DEPTH
mean, slope = np.mean(F[late]/t[late])/unit, np.polyfit(t[late], F[late], 1)[0]/unit
print(f"force over rho V^3 t, second half: {mean:.2f}, similarity {FORCE}"
      f" ({100*(mean/FORCE - 1):+.1f} %), Wagner {np.pi*WAGNER**2:.2f}; of its slope {slope:.2f}"
      f" ({100*(slope/FORCE - 1):+.1f} %)")
rows = []
for s in case.times():
    since = float(s) - GAP/V
    if since < 0.5*t[-1]:
        continue
    Cp = face(s)
    # Not at the keel
    i = np.nanargmax(np.where(xc > V*since/SLOPE, Cp, np.nan))
    rows.append((Cp[i], xc[i]*SLOPE/(V*since)))
    print(f"{1e3*since:.1f} ms after it touched the water: largest pressure over rho V^2/2"
          f" {Cp[i]:.2f} at {rows[-1][1]:.3f} V t/tan")
peak, place = np.mean(rows, axis=0)
print(f"largest pressure over rho V^2/2, mean: {peak:.2f}, similarity {PEAK}"
      f" ({100*(peak/PEAK - 1):+.1f} %), Wagner {WAGNER**2:.2f}")
print(f"where, over V t/tan, mean: {place:.3f}, similarity {1 + HEIGHT:.3f}"
      f" ({100*(place/(1 + HEIGHT) - 1):+.1f} %), Wagner {np.pi/2:.3f}")
# Columns: 7 residual, 13 work of the wedge
e = case.series("energy", "energy.dat", once=True)
print(f"energy residual {100*abs(e[:, 7]).max()/e[-1, 13]:.3f} % of the wedge's work {e[-1, 13]:.3f} J")
for name in ("water", "air"):
    m = case.series("balance", f"{name}.dat", once=True)
    print(f"mass of {name} that nobody gave: {abs(m[:, 9]).max()/m[0, 1]:.0e}")
Theta = case.numbers("^Theta: min N, max N")
print(f"Theta {Theta.min():.5f} to {Theta.max():.5f}; {case.nSteps()} steps,"
      f" {case.solverSeconds():.0f} s")

figure, axes = plt.subplots(1, 3, figsize=(13, 3.6))
last = case.times()[-1]
ax = axes[0]
frame(ax, (0, 200), (-80, 90), title=f"{1e3*(float(last) - GAP/V):.1f} ms")
ax.pcolormesh(1e3*x, 1e3*y, case.field(last, "alpha.air", nx, ny), cmap=PART, vmin=0, vmax=1,
              rasterized=True, zorder=GAS)
drawPoints(ax, case.points(last, "wedge"), RIGID, scale=1e3)
ax = axes[1]
for s in case.times():
    since = float(s) - GAP/V
    if since > 0.3*t[-1]:
        ax.plot(xc*SLOPE/(V*since), face(s), lw=1, label=f"{1e3*since:.1f} ms")
ax.plot(1 + HEIGHT, PEAK, "ko", ms=4, label="similarity, peak")
ax.plot(np.pi/2, WAGNER**2, "k+", label="Wagner, peak")
ax.set_xlim(0, 2.5)
ax.set_ylim(-0.5, 8)
ax.set_xlabel(r"$x\,\tan 30^\circ/(Vt)$")
ax.set_title(r"pressure along the face over $\rho V^2/2$")
ax = axes[2]
ax.plot(1e3*t, F/DEPTH*1e-3, "C0", lw=0.8, label="this case")
line = np.array([0, t[-1]])
ax.plot(1e3*line, 0.5e-3*FORCE*RHO*V**3*line, "k--", label="similarity")
ax.plot(1e3*line, 0.5e-3*np.pi*WAGNER**2*RHO*V**3*line, "k:", label="Wagner")
ax.set_xlabel("time since it touched the water [ms]")
ax.set_title("force on one face [kN/m]")
for ax in axes[1:]:
    ax.grid(alpha=0.3)
    ax.legend(fontsize=7)
save(figure, "wedgeEntry.png")
