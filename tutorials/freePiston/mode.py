"""The exact motion: a slab of width b, density rho and wave speed c_s between two
columns of gas of length L (rho0, c0). Small motion, antisymmetric about the middle:

    slab    u = cos(w (x - 1/2)/c_s)/cos(w b/2/c_s),  gas  u = sin(w x/c0)/sin(w L/c0)
    rho c_s tan(w b/2/c_s) = rho0 c0 cot(w L/c0)

(a rigid slab of mass m has m w = 2 rho0 c0 cot(w L/c0)).
"""

import numpy as np

GAMMA, P0, RHO0 = 1.4, 1e5, 1e5/(287*290)
C0 = np.sqrt(GAMMA*P0/RHO0)
L, B, RHO, E = 0.45, 0.1, 27.0, 7e6
CS = np.sqrt(E/RHO)
SPEED = 0.9        # of the slab's faces


def omega():
    low, high = 1e-6, 0.5*np.pi*C0/L
    for _ in range(200):
        w = 0.5*(low + high)
        left = RHO*CS*np.tan(w*B/2/CS)*np.tan(w*L/C0) - RHO0*C0
        low, high = (w, high) if left < 0 else (low, w)
    return w


W = omega()
T = 2*np.pi/W


def firstOrderLoss(n, dt, time):
    """Share of the mode's energy that a gas of first order on n cells loses. A face
    turns (rho0 c0 (du)^2 + (dp)^2/(rho0 c0))/2 into heat, of which the explicit step
    gives c0 dt/h back."""
    h, k = 1/n, W/C0
    s2 = np.sin(k*L)**2
    energy = 0.5*RHO*B + RHO0/(2*s2)*(L - np.sin(2*k*L)/(2*k))
    return 1 - np.exp(-time*RHO0*C0*(h - C0*dt)*k**2*L/(2*s2)/energy)


def shape(x):
    """Velocity over that of the slab's faces."""
    return np.where(abs(x - 0.5) < B/2, np.cos(W*(x - 0.5)/CS)/np.cos(W*B/2/CS),
                    np.sin(W*np.minimum(x, 1 - x)/C0)/np.sin(W*L/C0))
