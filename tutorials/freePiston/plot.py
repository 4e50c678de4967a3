"""Period, mass and energies of the slab against the exact motion (mode.py)."""

import numpy as np

from mpm.pictures import plt, save
from mpm.variants import variant
from mode import B, C0, L, RHO, RHO0, SPEED, T, W, firstOrderLoss, shape

AREA = 1e-4
x = (np.arange(1000) + 0.5)/1000
MEAN = SPEED*shape(x)[abs(x - 0.5) < B/2].mean()     # of the slab


def motion(case):
    """Time and mean velocity of the slab."""
    table = case.series("balance", "total.dat", once=True)
    return table[:, 0], table[:, 3]/(RHO*B*AREA)


def period(t, u):
    i = np.nonzero(u[:-1]*u[1:] < 0)[0]
    zero = t[i] - u[i]*(t[i + 1] - t[i])/(u[i + 1] - u[i])
    return 2*np.polyfit(np.arange(len(zero)), zero, 1)[0]


def left(t, u):
    """Amplitude after four periods, over that of the start: a sine of the exact
    period through the last half period."""
    last = (t > 3.75*T) & (t <= 4.25*T)
    A = np.column_stack([np.cos(W*t[last]), np.sin(W*t[last])])
    return np.hypot(*np.linalg.lstsq(A, u[last], rcond=None)[0])/MEAN


CASES = [(".", "stick, 100 cells")] + [
    (d, label) for d, label in (
        ("stick50", "stick, 50 cells"), ("stick200", "stick, 200 cells"),
        ("none50", "no drag, 50 cells"), ("none100", "no drag, 100 cells"),
        ("none200", "no drag, 200 cells"), ("weak100", "constant 1e4, 100 cells"),
        ("middle100", "constant 1e6, 100 cells"),
        ("stick100velocity", "stick, faceDrag velocity"),
        ("stick100noFaceDrag", "stick, faceDrag none"), ("none100vanLeer", "no drag, van Leer"),
        ("none100pores", "the same, poreFloor 0.001"), ("stick100vanLeer", "stick, van Leer"))]
print(f"exact period {T:.6e} s")
for name, label in CASES:
    case = variant(name)
    t, u = motion(case)
    mass, gas = case.numbers("^Gas air: mass N.*energy N").T
    points = case.numbers("^Energy: kinetic .* total N")
    all_ = gas + points
    kinetic = 0.5*RHO*B*AREA*MEAN**2
    steps = case.nSteps()
    first = firstOrderLoss(case.entry("system/blockMeshDict", "n"), t[-1]/steps, 4*T)
    print(f"{label:26s} period {100*(period(t, u)/T - 1):+.4f} %, kinetic energy lost in four"
          f" periods {100*(1 - left(t, u)**2):5.2f} % (first order {100*first:5.2f}), energy of all"
          f" {(all_[-1] - all_[0])/kinetic:+.1e} of it, mass {abs(mass/mass[0] - 1).max():.0e}")

figure, axes = plt.subplots(2, 1, figsize=(8.5, 6.5), sharex=True)
for name, style, label in ((".", "C0-", "stick"), ("none100", "C3-", "no drag")):
    t, u = motion(variant(name))
    axes[0].plot(t/T, u, style, lw=1, label=f"{label}, 100 cells")
axes[0].plot(t/T, MEAN*np.cos(W*t), "k:", lw=1, label="exact")
axes[0].set_ylabel("velocity of the slab [m/s]")
axes[0].legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncol=4)
probe = variant(".").series("walls", "p")
axes[1].plot(probe[:, 0]/T, (probe[:, 1] - 1e5)*1e-3, "C0-", lw=1, label="left wall")
axes[1].plot(probe[:, 0]/T, (probe[:, 2] - 1e5)*1e-3, "C1-", lw=1, label="right wall")
wall = RHO0*C0*SPEED/np.sin(W*L/C0)*np.sin(W*probe[:, 0])
axes[1].plot(probe[:, 0]/T, -wall*1e-3, "k:", lw=1, label="exact")
axes[1].plot(probe[:, 0]/T, wall*1e-3, "k:", lw=1)
axes[1].set_ylabel("pressure at the walls\nover 1 bar [kPa]")
axes[1].set_xlabel("time / exact period")
axes[1].legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncol=4)
save(figure, "piston.png")
