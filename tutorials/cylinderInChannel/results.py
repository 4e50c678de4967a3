"""Gas at the nose of the cylinder, and the paths of the grains by an integration of their own.

Rayleigh's pitot formula, the pressure at rest behind a normal shock of Mach number M:

    p/p1 = ((g + 1)^2 M^2/(4 g M^2 - 2 (g - 1)))^(g/(g - 1)) (1 - g + 2 g M^2)/(g + 1)

Billig's fit of measured shocks before cylinders (J. Spacecraft and Rockets 4 (1967) 822):

    distance/R = 0.386 exp(4.67/M^2)

A grain with the drag of Schiller and Naumann, u_g and rho of the gas where it is:

    du/dt = 3/4 C_D Re mu/(d^2 rho_s) (u_g - u),   Re = rho |u_g - u| d/mu,
    C_D Re = 24 (1 + 0.15 Re^0.687) below Re = 1000
"""

import numpy as np
from matplotlib.tri import LinearTriInterpolator, Triangulation

R, HEIGHT, P1, MACH, SPEED = 0.05, 0.2, 1e5, 3.0, 1041.56
D, RHO, MU = 2e-6, 2500.0, 1.8e-5
SHOCK = 0.386*np.exp(4.67/MACH**2)
BEHIND = P1*(2.8*MACH**2 - 0.4)/2.4         # pressure right behind the shock


def rayleigh(M, g=1.4):
    return (((g + 1)*M)**2/(4*g*M*M - 2*(g - 1)))**(g/(g - 1))*(1 - g + 2*g*M*M)/(g + 1)


def centres(case):
    """Middle of each cell's corners."""
    return np.array([corners.mean(axis=0) for corners in case.polygons()])


def nose(case, times):
    """Largest pressure of the cells at the nose over that of the stream, and distance of the
    shock over R, at the middle line; means of some times."""
    x = centres(case)
    r, angle = np.hypot(*x.T), np.arctan2(x[:, 1], -x[:, 0])
    line = np.flatnonzero((angle < 0.1) & (r < 3*R))
    line = line[np.argsort(r[line])]
    rows = []
    for time in times:
        p = case.field(time, "p")[line]
        i = np.argmax(p < 0.5*(P1 + BEHIND))
        edge = np.interp(0.5*(P1 + BEHIND), p[[i, i - 1]], r[line[[i, i - 1]]])
        rows.append((p[r[line] < 1.1*R].max()/P1, edge/R - 1))
    return np.mean(rows, axis=0)


def acceleration(w, rho):
    """Of grains from the velocity of the gas relative to them."""
    Re = rho*np.linalg.norm(w, axis=1)*D/MU
    drag = np.where(Re < 1000, 24*(1 + 0.15*np.maximum(Re, 1e-9)**0.687), 0.44*Re)
    return (0.75*drag*MU/(D*D*RHO))[:, None]*w


class Gas:
    """Velocity and density, linear between the centres of cells and between times."""

    def __init__(self, case):
        self.case, self.times = case, case.times("U.air")
        self.at = np.array([float(t) for t in self.times])
        # With mirror images beyond the middle plane and the wall
        x = centres(case)
        self.cells, self.turn, y = np.arange(len(x)), np.ones(len(x)), x
        for plane in (0, HEIGHT):
            some = np.flatnonzero(abs(x[:, 1] - plane) < 0.03)
            self.cells = np.append(self.cells, some)
            self.turn = np.append(self.turn, -np.ones(len(some)))
            y = np.concatenate((y, x[some]*(1, -1) + (0, 2*plane)))
        self.triangles = Triangulation(*y.T)
        self.kept = {}

    def values(self, i, x):
        if i not in self.kept:
            U, rho = (self.case.field(self.times[i], n) for n in ("U.air", "rho.air"))
            U = np.broadcast_to(U, (self.cells.max() + 1, 3))[self.cells]
            rho = np.broadcast_to(rho, self.cells.max() + 1)[self.cells]
            self.kept = {k: v for k, v in self.kept.items() if k >= i - 1}
            self.kept[i] = [LinearTriInterpolator(self.triangles, c)
                            for c in (U[:, 0], U[:, 1]*self.turn, rho)]
        return np.stack([f(*x.T).filled(np.nan) for f in self.kept[i]], axis=1)

    def __call__(self, t, x):
        i = min(max(np.searchsorted(self.at, t) - 1, 1), len(self.at) - 2)
        part = (t - self.at[i])/(self.at[i + 1] - self.at[i])
        v = (1 - part)*self.values(i, x) + part*self.values(i + 1, x)
        return v[:, :2], v[:, 2]


def paths(case, dt=1e-6):
    """Times, places [time, grain, 2] of the grains by Heun's method. Those that touch
    cylinder or wall slide."""
    start = case.points("0", "dust")
    x, u = start.byId("x")[:, :2], start.byId("U")[:, :2]
    gas, t = Gas(case), 0.0
    rows, times = [x], [t]
    while t < gas.at[-1] - 0.5*dt:
        def rate(t, x, u):
            U, rho = gas(t, x)
            return acceleration(U - u, rho)
        a = rate(t, x, u)
        b = rate(t + dt, x + dt*u, u + dt*a)
        x, u, t = x + dt*u + 0.5*dt*dt*a, u + 0.5*dt*(a + b), t + dt
        r = np.linalg.norm(x, axis=1)
        inside = r < R
        n = x[inside]/r[inside, None]
        x[inside] = R*n
        u[inside] -= np.minimum((u[inside]*n).sum(axis=1), 0)[:, None]*n
        rows.append(x)
        times.append(t)
    return np.array(times), np.array(rows)


def grains(case):
    """Places of the solver's grains [time, grain, 2] at its times."""
    times = case.times("lagrangian")
    return (np.array([float(t) for t in times]),
            np.array([case.points(t, "dust").byId("x")[:, :2] for t in times]))


def apart(case):
    """Distances of both at the end over R, of the grains that do not come within 0.05 R of
    the cylinder; their mask; largest way across; times and paths of both."""
    t, exact = paths(case)
    times, ours = grains(case)
    free = np.hypot(*exact.T).T.min(axis=0) > 1.05*R
    away = np.linalg.norm(ours[-1] - exact[np.argmin(abs(t - times[-1]))], axis=1)/R
    return away, free, (t, exact), (times, ours)


def massChange(case):
    """Largest change of the gas' mass over it."""
    mass = case.numbers("^Gas air: mass N")
    return abs(mass/mass[0] - 1).max()
