"""Figures of README.md's table, and the picture: water and gate at three times, displacement
of the gate's lower end over time."""

import numpy as np

from mpm.case import Case
from mpm.pictures import BODY, GAS, PART, RIGID, drawPoints, frame, plt, save

#: Peaks of the lower end's displacement [m]: along x and y, of SPHinXsys (github.com/
#: Xiangyu-Hu/SPHinXsys, tests/2d_examples/test_2d_elastic_gate, first and outermost place in
#: its stored Observer_Position; a gate of 7.8 MPa, 0.47 in plane strain, no air); along x of the
#: experiment, and its time [s]: Antoci, Gallati & Sibilla, Comput. Struct. 85 (2007) 879-890,
#: from memory, not read from the paper
COMPUTED = 395.697e-3 - 349.269e-3, 21.069e-3 - 0.909e-3
PEAK, WHEN = 0.045, (0.13, 0.15)
#: Speed of sound of the water [m/s]; thickness of the mesh, length of the gate [m], its
#: stiffness E/(1 - nu^2) h^3/12 [N m]
SOUND, DEPTH, LENGTH = 30.0, 0.0025, 0.079
STIFFNESS = 8.4e6/(1 - 0.4**2)*0.005**3/12
WEIGHT = 1000*9.81

case = Case()
nx, ny = (int(case.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))
x, y = (1e3*e for e in case.edges()[:2])
tip = case.series("tip", "displacement.dat", once=True)
t, u = tip[:, 0], tip[:, 1:3]
first = u[t <= 0.2]
i = np.argmax(first[:, 0])
print(f"largest displacement of the lower end along x: {1e3*first[i, 0]:.1f} mm, SPHinXsys"
      f" {1e3*COMPUTED[0]:.1f} ({100*(first[i, 0]/COMPUTED[0] - 1):+.0f} %), experiment"
      f" {1e3*PEAK:.0f} ({100*(first[i, 0]/PEAK - 1):+.0f} %) at {t[i]:.3f} s; there"
      f" {1e3*first[i, 1]:.1f} mm along y, SPHinXsys {1e3*COMPUTED[1]:.1f};"
      f" {1e3*u[-1, 0]:.1f} mm along x at {t[-1]:.2f} s")
# A linear beam under the weight of the water that is then behind it, nothing relieved below
level = 1e-3*np.diff(y)[0]*case.field(case.nearest(t[i], "lagrangian"), "alpha.water", nx,
                                      ny)[:, :nx//4].sum(axis=0).mean()
top, more = WEIGHT*(level - LENGTH), WEIGHT*LENGTH
beam = LENGTH**4/STIFFNESS*(top/8 + 11*more/120)
print(f"linear beam under the weight of the water, level {1e3*level:.0f} mm: {1e3*beam:.1f} mm")

times = case.times("lagrangian")[1:]
fastest, left = [], []
for time in times:
    mass = case.field(time, "thetaRho.water", nx, ny)
    # Cells with water, none of the gate
    full = mass > 900
    fastest.append(np.linalg.norm(case.field(time, "U", nx, ny), axis=-1)[full].max())
    left.append(mass[:, :nx//2].sum()*np.diff(x)[0]*np.diff(y)[0]*1e-6)
print(f"largest velocity of water over its sound: {max(fastest):.2f}/{SOUND:.0f}"
      f" = {max(fastest)/SOUND:.3f}")
print(f"water behind the gate at the end: {left[-1]:.2f} of 14 kg per metre of depth")
Theta = case.numbers("^Theta: min N, max N")
# Columns: 3 total of the points, 7 residual, 12 work of gravity in the fluids' faces
e = case.series("energy", "energy.dat", once=True)
residual, took, worked = abs(e[:, 7]).max(), np.ptp(e[:, 3]), np.ptp(e[:, 12])
print(f"energy residual {residual:.2e} J: {100*residual/worked:.2f} % of gravity's work"
      f" {worked:.2e} J, {100*residual/took:.1f} % of what the gate took, {took:.2e} J")
for name in ("water", "air"):
    m = case.series("balance", f"{name}.dat", once=True)
    print(f"mass of {name} that nobody gave: {abs(m[:, 9]).max()/m[0, 1]:.0e}")
print(f"Theta {Theta.min():.5f} to {Theta.max():.5f}; {case.nSteps()} steps,"
      f" {case.solverSeconds():.0f} s")

figure, axes = plt.subplots(1, 4, figsize=(13, 3.0), gridspec_kw={"width_ratios": (1, 1, 1, 1.2)})
for ax, want in zip(axes, (0.04, 0.1, 0.16)):
    time = case.nearest(want, "lagrangian")
    frame(ax, (0, x[-1]), (0, y[-1]), title=f"{1e3*float(time):.0f} ms")
    ax.pcolormesh(x, y, 1 - case.field(time, "alpha.water", nx, ny), cmap=PART, vmin=0, vmax=1,
                  rasterized=True, zorder=GAS)
    for phase, colour in (("wall", RIGID), ("gate", BODY)):
        drawPoints(ax, case.points(time, phase), colour, scale=1e3, section=DEPTH)
ax = axes[3]
ax.plot(1e3*t, 1e3*u[:, 0], "C0", label="along x")
ax.plot(1e3*t, 1e3*u[:, 1], "C0--", label="along y")
ax.errorbar(1e3*np.mean(WHEN), 1e3*PEAK, xerr=1e3*np.ptp(WHEN)/2, fmt="ko", ms=4, capsize=3,
            label="Antoci et al., peak, from memory")
ax.axhline(1e3*COMPUTED[0], color="k", ls=":", lw=1, label="SPHinXsys, peak")
ax.set_xlabel("time [ms]")
ax.set_title("displacement of the gate's lower end [mm]")
ax.legend(fontsize=7, loc="lower center")
ax.grid(alpha=0.3)
save(figure, "damBreakGate.png")
