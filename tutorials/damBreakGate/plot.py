"""Figures of README.md's table, and the picture: water and gate at three times, displacement
of the gate's lower end over time."""

import numpy as np

from mpm.case import Case
from mpm.pictures import BODY, GAS, PART, RIGID, drawPoints, frame, plt, save

#: Peaks of the lower end's displacement along x and y [m] of SPHinXsys (github.com/
#: Xiangyu-Hu/SPHinXsys, tests/2d_examples/test_2d_elastic_gate, first and outermost place in
#: its stored Observer_Position; a gate of 7.8 MPa, 0.47 in plane strain, no air)
COMPUTED = 395.697e-3 - 349.269e-3, 21.069e-3 - 0.909e-3
#: Of the experiment, Antoci, Gallati & Sibilla, Comput. Struct. 85 (2007) 879-890: t [s], along x
#: [mm]; of three computations every 20 ms from 20 to 200 ms. As others took them off figures:
#: github.com/dineshadepu/fsi_etvf, code/ng_2020_elastic_dam_break_*
EXPERIMENT = np.array([(0.040, 12.5), (0.080, 34.0), (0.119, 44.0), (0.161, 46.4), (0.200, 44.2)])
OTHERS = {
    "Khayyer et al. 2018": (4.0, 14.4, 28.2, 36.9, 41.4, 42.5, 41.7, 39.6, 37.4, 34.6),
    "Yang et al. 2012": (4.2, 14.5, 26.4, 35.3, 38.4, 39.3, 37.9, 35.8, 33.0, 30.9),
    "Ng et al. 2020": (5.5, 14.6, 26.1, 34.4, 37.7, 38.8, 37.1, 34.8, 32.8, 30.6)}
EVERY = np.arange(0.02, 0.201, 0.02)
#: Speed of sound of the water [m/s]; thickness of the mesh, length and thickness of the gate [m],
#: its E/(1 - nu^2) [Pa] and density
SOUND, DEPTH, LENGTH, THICK = 30.0, 0.0025, 0.079, 0.005
MODULUS, DENSITY = 8.4e6/(1 - 0.4**2), 1100
WEIGHT = 1000*9.81


def beam(level, n=400):
    """Lower end's displacement [m] of a beam of any rotation theta under the weight of water at
    rest up to a level [m] at its one face, nothing relieved: with s from the clamp,
    E/(1 - nu^2) h^3/12 theta' = M(s), the moment about s of p n + rho_gate h g beyond s."""
    ds = LENGTH/n
    theta, change = np.zeros(n), 1.0

    def beyond(q):
        return np.append(np.cumsum(q[::-1])[::-1], 0)*ds

    while abs(change) > 1e-9:
        x = np.insert(np.cumsum(np.sin(theta)), 0, 0)*ds
        y = LENGTH - np.insert(np.cumsum(np.cos(theta)), 0, 0)*ds
        xm, ym = 0.5*(x[1:] + x[:-1]), 0.5*(y[1:] + y[:-1])
        p = WEIGHT*np.maximum(level - ym, 0)
        qx, qy = p*np.cos(theta), p*np.sin(theta) - DENSITY*THICK*9.81
        M = beyond(xm*qy - ym*qx) - x*beyond(qy) + y*beyond(qx)
        bend = 0.5*(M[1:] + M[:-1])/(MODULUS*THICK**3/12)*ds
        more = 0.3*(np.cumsum(bend) - 0.5*bend - theta)
        theta, change = theta + more, np.max(abs(more))
    return x[-1]


case = Case()
nx, ny = (int(case.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))
x, y = (1e3*e for e in case.edges()[:2])
tip = case.series("tip", "displacement.dat", once=True)
t, u = tip[:, 0], tip[:, 1:3]
i = np.argmax(u[:, 0])
at = [1e3*np.interp(time, t, u[:, 0]) for time in EXPERIMENT[:, 0]]
print(f"largest displacement of the lower end along x: {1e3*u[i, 0]:.1f} mm, SPHinXsys"
      f" {1e3*COMPUTED[0]:.1f} ({100*(u[i, 0]/COMPUTED[0] - 1):+.0f} %), others "
      + ", ".join(f"{max(o):.1f}" for o in OTHERS.values())
      + f", experiment {EXPERIMENT[:, 1].max():.1f}"
      f" ({100*(1e3*u[i, 0]/EXPERIMENT[:, 1].max() - 1):+.0f} %) at {t[i]:.3f} s; there"
      f" {1e3*u[i, 1]:.1f} mm along y, SPHinXsys {1e3*COMPUTED[1]:.1f}")
print("along x at " + ", ".join(f"{1e3*e:.0f}" for e in EXPERIMENT[:, 0]) + " ms: "
      + ", ".join(f"{v:.1f}" for v in at) + " mm, experiment "
      + ", ".join(f"{v:.1f}" for v in EXPERIMENT[:, 1]))
for k in (1, 2, 3):
    print(f"along x at {1e3*EVERY[k]:.0f} ms: {1e3*np.interp(EVERY[k], t, u[:, 0]):.1f} mm, others "
          + ", ".join(f"{o[k]:.1f}" for o in OTHERS.values()))
for when in (t[i], t[-1]):
    level = 1e-3*np.diff(y)[0]*case.field(case.nearest(when, "lagrangian"), "alpha.water", nx,
                                          ny)[:, :nx//4].sum(axis=0).mean()
    print(f"beam of any rotation under the weight of the water at {when:.3f} s, level"
          f" {1e3*level:.0f} mm: {1e3*beam(level):.1f} mm; seen"
          f" {1e3*np.interp(when, t, u[:, 0]):.1f} mm")
print(f"the same of the level of the start: {1e3*beam(0.14):.1f} mm")

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
for colour, (name, curve) in zip(("0.4", "C1", "C2"), OTHERS.items()):
    ax.plot(1e3*EVERY, curve, colour, ls=":", label=name)
ax.plot(1e3*EXPERIMENT[:, 0], EXPERIMENT[:, 1], "ko", ms=4, label="Antoci et al., measured")
ax.axhline(1e3*COMPUTED[0], color="k", ls=":", lw=1, label="SPHinXsys, peak")
ax.set_xlabel("time [ms]")
ax.set_title("displacement of the gate's lower end [mm]")
ax.set_ylim(-18, 50)
ax.legend(fontsize=6, loc="lower center", ncol=2)
ax.grid(alpha=0.3)
save(figure, "damBreakGate.png")
