"""The shock of a cylinder of gas at high pressure, on its way through the air: Euler's
equations along the radius, far finer than the case and by a program of its own (HLLC
fluxes, minmod slopes, Heun's two stages). Lengths in m, times in s, pressures in Pa.

    d(r U)/dt + d(r F)/dr = (0, p, 0),   U = (rho, rho u, rho E)
"""

import numpy as np

GAMMA, R = 1.4, 287.0
AIR = (1e5, 290.0)                      # pressure and temperature


def hllc(left, right):
    """Flux of rho, rho u, rho E between the states (rho, u, p)."""
    (rl, ul, pl), (rr, ur, pr) = left, right
    cl, cr = np.sqrt(GAMMA*pl/rl), np.sqrt(GAMMA*pr/rr)
    sl, sr = np.minimum(ul - cl, ur - cr), np.maximum(ul + cl, ur + cr)
    s = (pr - pl + rl*ul*(sl - ul) - rr*ur*(sr - ur))/(rl*(sl - ul) - rr*(sr - ur))
    flux = 0
    for rho, u, p, side, here in ((rl, ul, pl, sl, s >= 0), (rr, ur, pr, sr, s < 0)):
        E = p/(GAMMA - 1) + 0.5*rho*u*u
        outer = np.array([rho*u, rho*u*u + p, u*(E + p)])
        factor = rho*(side - u)/(side - s)
        star = factor*np.array([np.ones_like(u), s,
                                E/rho + (s - u)*(s + p/(rho*(side - u)))])
        inner = outer + side*(star - np.array([rho, rho*u, E]))
        supersonic = side*(1 if side is sl else -1) >= 0
        flux = flux + np.where(here, np.where(supersonic, outer, inner), 0)
    return flux


def slope(a, b):
    return np.where(a*b > 0, np.where(abs(a) < abs(b), a, b), 0)


def primitive(U):
    rho, u = U[0], U[1]/U[0]
    return np.array([rho, u, (GAMMA - 1)*(U[2] - 0.5*rho*u*u)])


def rate(U, r, h):
    W = primitive(U)
    W = np.concatenate([W[:, 1::-1]*[[1], [-1], [1]], W, W[:, -1:], W[:, -1:]], axis=1)
    half = 0.5*slope(W[:, 1:-1] - W[:, :-2], W[:, 2:] - W[:, 1:-1])
    flux = hllc((W[:, 1:-1] + half)[:, :-1], (W[:, 1:-1] - half)[:, 1:])
    faces = h*np.arange(len(r) + 1)
    change = -(faces[1:]*flux[:, 1:] - faces[:-1]*flux[:, :-1])/(r*h)
    change[1] += W[2, 2:-2]/r
    return change


def history(radius, p, T, gauges, end, n=1500, length=0.45, Co=0.4):
    """Times, and pressures at the gauges, of a cylinder of this radius, pressure and
    temperature at the start."""
    h = length/n
    r = h*(np.arange(n) + 0.5)
    # The cell that holds the radius has its part of both
    part = np.clip((radius**2 - (r - 0.5*h)**2)/(2*r*h), 0, 1)
    rho = part*p/(R*T) + (1 - part)*AIR[0]/(R*AIR[1])
    U = np.array([rho, 0*r, (part*p + (1 - part)*AIR[0])/(GAMMA - 1)])
    t, rows = 0.0, []
    while t < end:
        W = primitive(U)
        rows.append((t, *np.interp(gauges, r, W[2])))
        dt = Co*h/np.max(abs(W[1]) + np.sqrt(GAMMA*W[2]/W[0]))
        first = U + dt*rate(U, r, h)
        U = 0.5*(U + first + dt*rate(first, r, h))
        t += dt
    rows = np.array(rows)
    return rows[:, 0], rows[:, 1:]


def arrival(t, p, level):
    """When the pressure rises through the level; linear between the steps."""
    i = np.argmax(p > level)
    return t[i - 1] + (level - p[i - 1])/(p[i] - p[i - 1])*(t[i] - t[i - 1])


def reflected(p, p0=AIR[0]):
    """Pressure behind a shock of this pressure when a rigid wall has thrown it back."""
    return p*((3*GAMMA - 1)*p - (GAMMA - 1)*p0)/((GAMMA - 1)*p + (GAMMA + 1)*p0)
