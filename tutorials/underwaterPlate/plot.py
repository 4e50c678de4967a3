"""Figures of README.md's table, and the pictures: velocity of Taylor's plate beside his
formula, the clamped plate at four times."""

import numpy as np

from mpm.case import Case
from mpm.pictures import BODY, FAILED, GAS, PART, boxes, colourBar, frame, plt, save

#: As in wave.py and Allrun; mass of the plate [kg/m2]
PEAK, THETA, MASS, AREA = 1e7, 1e-4, 27.0, 1e-4
P0, RHO, SOUND = 1e5, 1000.0, np.sqrt(4.4*(1e5 + 6e8)/1000.0)
PSI = RHO*SOUND*THETA/MASS


def exact(t):
    """Velocity of the plate until the water before it cavitates, p at its face."""
    a, b = np.exp(-t/THETA), np.exp(-PSI*t/THETA)
    return (2*PEAK*THETA/MASS/(PSI - 1)*(a - b),
            P0 + 2*PEAK*a - RHO*SOUND*2*PEAK*THETA/MASS/(PSI - 1)*(a - b))


def budget(name, case):
    """Largest residuals over what was exchanged."""
    e = case.series("energy", "energy.dat")
    m = case.series("balance", "mixture.dat")
    # Columns: 3 total of the points, 7 residual
    exchanged = np.ptp(e[:, 3])
    momentum = abs(m[:, 3:9]).max()
    Theta = case.numbers("^Theta: min N, max N")
    print(f"{name}: energy residual {100*abs(e[:, 7]).max()/exchanged:.3f} % of what the plate"
          f" took, mass nobody gave {abs(m[:, 2]).max()/m[0, 1]:.0e}, momentum"
          f" {abs(m[:, 9:12]).max()/momentum:.0e}; Theta {Theta.min():.6f} to {Theta.max():.6f};"
          f" fix-ups {sum(case.numbers('kept N, pressure of relaxation kept N, isentropic N')[-1]):.0f}"
          f" with {100*case.numbers('energy N added')[-1]/exchanged:.2g} % of that energy;"
          f" {case.nSteps()} steps, {case.solverSeconds():.0f} s")


# --- Taylor's plate: 1D
case = Case("taylor")
plate = case.series("balance", "plate.dat")
t, v = plate[:, 0], plate[:, 3]/(MASS*AREA)
p = case.series("gauge", "p")
late = THETA*np.log(PSI)/(PSI - 1)
low = P0 + 0.01*PEAK
found = p[np.argmax((p[:, 1] < low) & (p[:, 0] > 0.2*late)), 0]
line = np.linspace(0, late, 20001)
falls = line[np.argmax(exact(line)[1] < low)]
print(f"taylor: largest velocity {v.max():.3f} m/s, exact {exact(late)[0]:.3f}"
      f" ({100*(v.max()/exact(late)[0] - 1):+.2f} %)")
print(f"taylor: before the plate p - p0 falls to 1 % of the peak at {1e6*found:.2f} us, exact"
      f" {1e6*falls:.2f} ({100*(found/falls - 1):+.1f} %); velocity then"
      f" {np.interp(found, t, v):.3f} m/s")
print(f"taylor: least pressure {case.numbers('^    p N to').min():.0f} Pa")
budget("taylor", case)
figure, axes = plt.subplots(1, 2, figsize=(10, 3.6))
early = np.linspace(0, late, 300)
axes[0].plot(1e6*t, v, "C0", label="plate")
axes[0].plot(1e6*early, exact(early)[0], "k:", label="Taylor (1941), until cavitation")
axes[0].set_ylabel("velocity of the plate [m/s]")
axes[1].plot(1e6*p[:, 0], 1e-6*p[:, 1], "C0", label="1.25 mm before the plate")
axes[1].plot(1e6*early, 1e-6*exact(early)[1], "k:", label="Taylor (1941), at the plate")
axes[1].set_ylabel("pressure of the water [MPa]")
for ax in axes:
    ax.axvline(1e6*late, color="0.7", lw=0.8)
    ax.set_xlabel("time [us]")
    ax.grid(alpha=0.3)
    ax.legend()
save(figure, "taylor.png")

# --- clamped plate: 2D
case = Case("clamped")
nx, ny = (int(case.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))
x, y = (1e3*e for e in case.edges()[:2])
budget("clamped", case)
last = case.times("lagrangian")[-1]
end = case.points(last, "plate")
depth = case.edges()[2][-1]
# The gap: above the piece that flies, beyond the plate's first place
flies = end["x"][end["x"][:, 0] > 0.02]
gap = np.ix_(0.5e-3*(y[1:] + y[:-1]) > flies[:, 1].max(), 0.5*(x[1:] + x[:-1]) > 8)
water = case.field(last, "thetaRho.water", nx, ny)[gap].sum()*1e-6*np.diff(x)[0]*np.diff(y)[0]
plate = case.series("balance", "plate.dat")
print(f"clamped: {np.sum(end['damage'] >= 1)} of {len(end['damage'])} points torn; mean velocity"
      f" of the plate at most {np.max(plate[:, 3]/plate[:, 2]):.1f} m/s; water in the gap at"
      f" the wall {water:.2f} kg per metre of depth, half plate")
figure, axes = plt.subplots(1, 4, figsize=(13, 4.2), sharey=True)
for ax, want in zip(axes, (0, 1.2e-4, 4e-4, 8e-4)):
    time = case.nearest(want, "lagrangian")
    frame(ax, (-60, 130), (-100, 100), "x [mm]", "y [mm]" if ax is axes[0] else None,
          f"{1e3*float(time):.2f} ms")
    air = case.field(time, "alpha.air", nx, ny)
    points = case.points(time, "plate")
    failed = points["damage"] >= 1
    side = 1e3*np.sqrt(points["V"]/depth)
    for sign in (1, -1):
        image = ax.pcolormesh(x, sign*y, air, cmap=PART, vmin=0, vmax=1, rasterized=True,
                              zorder=GAS)
        at = 1e3*points["x"][:, :2]*(1, sign)
        boxes(ax, at[~failed], side[~failed], BODY, overlap=0.3)
        boxes(ax, at[failed], side[failed], FAILED, overlap=0.15)
colourBar(figure, image, axes, "share of air", shrink=0.8)
save(figure, "clamped.png")
