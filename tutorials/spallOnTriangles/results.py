"""Figures of a run beside the exact elastic solution (one dimension, no failure)."""

import numpy as np

RHO, E, V, H = 2700.0, 70e9, 100.0, 1.9e-3
C = np.sqrt(E/RHO)
STRESS = RHO*C*V/2


def crossing(t, y, value, after):
    """First time after which y exceeds a value, linear between the steps."""
    i = np.flatnonzero((t > after) & (y > value))[0]
    return t[i - 1] + (value - y[i - 1])*(t[i] - t[i - 1])/(y[i] - y[i - 1])


def figures(case):
    """Times of the first tension at the mid-plane and of its tearing [s], compression there
    [Pa], velocity of the free surface [m/s]."""
    t, stress = case.series("midPlane", "sigma_yy.dat").T
    tension = crossing(t, stress, 0, 0.8e-6)
    plateau = stress[(t > 0.6e-6) & (t < 0.95e-6)].mean()
    t, damage = case.series("midPlane", "damage.dat").T
    torn = crossing(t, damage, 0.5, 0)
    t, u = case.series("freeSurface", "U_y.dat").T
    return tension, torn, plateau, -u[(t > 0.85e-6) & (t < 1.05e-6)].mean()
