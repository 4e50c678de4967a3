"""Reads the runs, and what theory and published fits say of them. Lengths in m, times in
s, pressures in Pa; the ball hits the plate's face x = 0 at t = 0."""

import os
import re

import numpy as np

from mpm.case import Case

D, T, SPEED = 10e-3, 2.5e-3, 5000.0
ALPHA = np.radians(2.5)

#: Density, sound speed and slope of the Hugoniot
SHOCK = {"copper": (8960.0, 3940.0, 1.489), "aluminium": (2700.0, 5386.0, 1.339)}


def metal(case):
    """Of the ball."""
    with open(case.file("constant/phaseProperties")) as f:
        return "copper" if re.search("copper", f.read()) else "aluminium"


def interfaceSpeed(ball, V=SPEED):
    """Of two flat faces that meet: the pressures rho (C0 + S u) u are equal."""
    (rb, cb, sb), (rp, cp, sp) = SHOCK[ball], SHOCK["aluminium"]
    low, high = 0.0, V
    for _ in range(60):
        u = 0.5*(low + high)
        if rp*(cp + sp*u)*u < rb*(cb + sb*(V - u))*(V - u):
            low = u
        else:
            high = u
    return u


def fits(ball, V=SPEED):
    """Hole's diameter over the ball's, of fits to experiments (README.md)."""
    ratio, sound = SHOCK[ball][0]/SHOCK["aluminium"][0], 5100.0
    found = {"Sawle": 3.2*(ratio*V/sound)**0.22*(T/D)**(2/3) + 1}
    if ball == "aluminium":
        found["Maiden & McMillan"] = 2.4*V/sound*(T/D)**(2/3) + 0.9
        found["Nysmith & Denardo"] = 0.88*np.sqrt(2.7*V*1e-3)*(T/D)**0.45
    return found


def plugSpeed(ball, V=SPEED):
    """Of the ball and the plug of its diameter that it punches out and takes along:
    momentum alone (Recht & Ipson without losses)."""
    return V/(1 + 1.5*SHOCK["aluminium"][0]/SHOCK[ball][0]*T/D)


def inPlane(p):
    """x and distance from the axis, and sizes of the squares, of points of a wedge or of a
    quarter in 3D."""
    if np.ptp(p["x"][:, 2]) > 1e-6:
        r, size = np.hypot(p["x"][:, 1], p["x"][:, 2]), np.cbrt(p["V"])
    else:
        r = p["x"][:, 1]
        size = np.sqrt(p["V"]/(2*r*np.tan(ALPHA)))
    return np.column_stack([p["x"][:, 0], r]), size


def hole(case, time):
    """Diameters of the hole: of matter that has not failed, and of all that is slow."""
    p = case.points(time, "plate")
    x, side = inPlane(p)
    inner = x[:, 1] - np.minimum(0.5*side, p["halfSize"][:, 0])
    whole = (p["damage"] < 1) & (abs(x[:, 0] - 0.5*T) < 2*T)
    slow = np.linalg.norm(p["U"], axis=1) < 150
    return 2*inner[whole].min(), 2*inner[slow].min()


def jittered(x, size, rays):
    """x and distance from the axis of points spread over squares of their sizes, again and
    again."""
    rng = np.random.default_rng(1)
    for _ in range(rays):
        u, v = rng.uniform(-0.5, 0.5, (2, len(x)))
        yield x[:, 0] + u*size, abs(x[:, 1] + v*size), rng


def section(case, time, colours, xs, ys, rays=60):
    """Picture (RGBA) of the section on bins xs, ys: matter by its colour, of failed, copper,
    aluminium; the paler the more it has spread."""
    cover = np.zeros((3, len(ys) - 1, len(xs) - 1))
    for phase in ("ball", "plate"):
        p = case.points(time, phase)
        x, size = inPlane(p)
        area = 4*p["halfSize"][:, 0]**2/rays
        kind = np.where(p["damage"] >= 1, 0,
                        1 if phase == "ball" and metal(case) == "copper" else 2)
        for X, R, _ in jittered(x, np.minimum(size, 2e-3), rays):
            for k in range(3):
                some = kind == k
                cover[k] += np.histogram2d(R[some], X[some], (ys, xs), weights=area[some])[0]
    cover /= np.outer(np.diff(ys), np.diff(xs))
    total = cover.sum(axis=0)
    mixed = np.einsum("kij,kc->ijc", cover, colours)/np.maximum(total, 1e-12)[..., None]
    return np.clip(np.dstack([mixed, 1.2*np.sqrt(total)]), 0, 1)


def radiograph(case, time, xs, ys, rays=400):
    """Mass per area [kg/m2] along lines of sight across the axis, on bins xs, ys: each
    point is a ring as thick as its volume says, at most 2 mm."""
    image = np.zeros((len(ys) - 1, len(xs) - 1))
    for phase in ("ball", "plate"):
        p = case.points(time, phase)
        x, size = inPlane(p)
        for X, R, rng in jittered(x, np.minimum(size, 2e-3), rays):
            y = R*np.sin(np.pi*rng.uniform(-0.5, 0.5, len(R)))
            image += np.histogram2d(y, X, bins=(ys, xs), weights=p["m"])[0]
    return image*np.pi/np.tan(ALPHA)/rays/np.outer(np.diff(ys), np.diff(xs))


def radiographOfQuarter(case, time, xs, ys, rays=50):
    """The same of a quarter in 3D, seen along z."""
    rng = np.random.default_rng(1)
    image = np.zeros((len(ys) - 1, len(xs) - 1))
    for phase in ("ball", "plate"):
        p = case.points(time, phase)
        thick = np.minimum(np.cbrt(p["V"]), 3e-3)
        for _ in range(rays):
            x, y = (p["x"][:, i] + rng.uniform(-0.5, 0.5, len(thick))*thick for i in (0, 1))
            image += np.histogram2d(-abs(y), x, bins=(ys, xs), weights=2*p["m"])[0]
    return image/rays/np.outer(np.diff(ys), np.diff(xs))


class Run:
    """One run's figures."""

    def __init__(self, path=".", after=5e-6):
        """after: from when on the speeds of the debris are taken, for 2 us."""
        self.case = Case(path)
        self.ball = metal(self.case)
        self.times = self.case.times("lagrangian")
        self.n = int(self.case.entry("system/blockMeshDict", "n"))
        total = self.case.series("balance", "total.dat")
        m, P = total[:, 2] + total[:, 14], total[:, 3] + total[:, 15]
        self.mass, self.momentum = np.ptp(m)/m[0], np.ptp(P)/P[0]
        e = self.case.series("energy", "energy.dat")
        self.residual = abs(e[:, 7]).max()/e[0, 1]
        self.transfer = -e[-1, 4]/e[0, 1]
        # When the pressure is highest there
        i = np.argmin(self.case.series("face", "sigma_xx.dat")[:, 1])
        self.face = (self.case.series("face", "U_x.dat")[i, 1],
                     -self.case.series("face", "sigma_xx.dat")[i, 1])
        b = self.case.series("balance", "ball.dat")
        b = b[np.searchsorted(b[:, 0], after)]
        self.speed = (b[3] + b[15])/(b[2] + b[14])
        front = {p: self.case.series("extent", p + ".dat") for p in ("ball", "plate")}
        self.front = {p: np.polyfit(*f[(f[:, 0] > after) & (f[:, 0] < after + 2e-6)][:, (0, 4)].T,
                                    1)[0] for p, f in front.items()}
        self.series = {p: (f[:, 0], f[:, 4]) for p, f in front.items()}

    @classmethod
    def of(cls, path):
        return cls(path) if os.path.exists(os.path.join(path, "log.materialPointFoam")) else None
