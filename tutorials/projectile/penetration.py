"""Nose and tail of the rod, Alekseevskii and Tate's theory, and where the rod's
matter is. Lengths in m, times in s, pressures in Pa; the target's face is at x = 0.

    1/2 rho_p (v - u)^2 + Y = 1/2 rho_t u^2 + R      at the nose, speed u
    dv/dt = -Y/(rho_p L),   dL/dt = -(v - u)         of the rod that is left

The resistance R that the constants of a steel have by themselves is that of a cavity
which opens quasi-statically in it, incompressible, with the flow stress s(e) of the
logarithmic strain e of the target in adiabatic flow (Hill 1950; the usual estimate of R):

    R = int_0^inf s(e)/(exp(3 e/2) - 1) de
"""

import os
import re

import numpy as np

from mpm.case import Case

RHO_P, RHO_T, Y, LENGTH, SPEED = 17000.0, 7850.0, 1.5e9, 50e-3, 1250.0


def noseSpeed(v, R, strength=Y):
    """u of Tate's balance."""
    a, b = RHO_P - RHO_T, 0.5*RHO_P*v*v + strength - R
    if b <= 0:
        return 0.0
    return (RHO_P*v - np.sqrt((RHO_P*v)**2 - 2*a*b))/a


def tate(R, end, dt=2e-8):
    """Columns time, nose, tail, u, v; the nose stays where it stops."""
    L, v, P, t = LENGTH, SPEED, 0.0, 0.0
    rows = []
    while t <= end + 0.5*dt:
        u = noseSpeed(v, R)
        rows.append((t, P, P - L, u, v))
        t += dt
        if u == 0 or L < 1e-3*LENGTH:
            continue
        # Midpoint rule
        vm, Lm = v - 0.5*dt*Y/(RHO_P*L), L - 0.5*dt*(v - u)
        um = noseSpeed(vm, R)
        P += dt*um
        L -= dt*(vm - um)
        v -= dt*Y/(RHO_P*Lm)
    return np.array(rows).T


def flowStress(law, rate, strains):
    """Adiabatic flow stress of Johnson and Cook's law (entries as numbers)."""
    T, before, stress = law["referenceTemperature"], 0.0, []
    for e in strains:
        hot = min((T - law["referenceTemperature"])
                  / (law["meltTemperature"] - law["referenceTemperature"]), 1.0)
        s = (law["A"] + law["B"]*e**law["n"])*(1 - hot**law["m"])
        s *= 1 + law["C"]*np.log(rate/law["referenceRate"])
        T += law["beta"]*s*(e - before)/(law["rho"]*law["cp"])
        before = e
        stress.append(s)
    return np.array(stress)


def cavityResistance(law, rate=1e5):
    """R of the cavity; rate is of the order u over the rod's radius."""
    K = law["rho"]*law["C0"]**2
    E = 9*K*law["G"]/(3*K + law["G"])
    plastic = np.concatenate(([0], np.logspace(-7, 1.5, 5000)))
    stress = flowStress(law, rate, plastic)
    strain = plastic + stress/E
    elastic = np.linspace(1e-9, strain[0], 2000)
    return (np.trapz(E*elastic/np.expm1(1.5*elastic), elastic)
            + np.trapz(stress/np.expm1(1.5*strain), strain))


def material(name):
    """Numbers of a file of etc/materials."""
    with open(os.path.join(os.environ["MPM_PROJECT_DIR"], "etc/materials", name)) as f:
        text = re.sub(r"//.*|/\*.*?\*/", "", f.read())
    return {k: float(v) for k, v in re.findall(r"^\s*(\w+)\s+(-?[\d.]+(?:e-?\d+)?);", text, re.M)}


class Path:
    """Nose, the foremost point of rod and debris, and tail over time."""

    def __init__(self, case="."):
        rod, debris = (Case(case).series("extent", p + ".dat") for p in ("rod", "debris"))
        self.t, self.nose = rod[:, 0], np.maximum(rod[:, 4], debris[:, 4])
        t, moved = Case(case).series("tail", "displacement_x.dat").T
        self.tail = np.interp(self.t, t, moved) - LENGTH

    def at(self, time):
        return (np.interp(time, self.t, self.nose), np.interp(time, self.t, self.tail))

    def speed(self, start=10e-6, end=40e-6):
        """Of the nose: slope of a straight line."""
        some = (self.t >= start) & (self.t <= end)
        return np.polyfit(self.t[some], self.nose[some], 1)[0]


def tateSpeed(R, start=10e-6, end=40e-6):
    """The same of Tate's nose."""
    t, nose = tate(R, end)[:2]
    some = t >= start
    return np.polyfit(t[some], nose[some], 1)[0]


def effectiveR(speed):
    """R with which Tate has this speed of the nose, by bisection."""
    low, high = 0.0, 8e9
    for _ in range(40):
        R = 0.5*(low + high)
        if tateSpeed(R) > speed:
            low = R
        else:
            high = R
    return R


def times(case="."):
    """Names of the times that have points, in order."""
    return Case(case).times("lagrangian/rod")


def matter(case, time, phase, name):
    """A column of a phase by id, of the rod with its debris."""
    clouds = [Case(case).points(time, p) for p in ((phase, "debris") if phase == "rod" else (phase,))
              if os.path.isdir(f"{case}/{time}/lagrangian/{p}")]
    ids = np.concatenate([c["id"] for c in clouds])
    return np.concatenate([c[name] for c in clouds])[np.argsort(ids)]


def coating(case, time, h, cells=2.0):
    """Part of the rod's mass with a point of the target within so many cells."""
    x, wall = (matter(case, time, p, "x")[:, :2] for p in ("rod", "target"))
    low, high = x.min(axis=0) - cells*h, x.max(axis=0) + cells*h
    wall = wall[np.all((wall > low) & (wall < high), axis=1)]
    near = np.array([np.min(np.sum((wall - p)**2, axis=1)) < (cells*h)**2 for p in x]) \
        if len(wall) else np.zeros(len(x), bool)
    m = matter(case, time, "rod", "m")
    return np.sum(m[near])/np.sum(m)


def fractured(case, time, phase, h):
    """Part of the neighbours of the start that are more than a cell apart now; without
    points that have been eroded."""
    X, x = (matter(case, t, phase, "x")[:, :2] for t in ("0", time))
    X = X[np.isin(matter(case, "0", phase, "id"), matter(case, time, phase, "id"))]
    apart = []
    for d in (0, 1):
        key = np.round(X/h*1e3).astype(int)
        order = np.lexsort((X[:, d], key[:, 1 - d]))
        same = np.diff(key[order, 1 - d]) == 0
        apart.append(np.abs(np.diff(x[order], axis=0)).max(axis=1)[same])
    return np.mean(np.concatenate(apart) > h)
