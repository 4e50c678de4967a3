"""Nose and tail of the rod, Alekseevskii and Tate's theory, and where the rod's
matter is. Lengths in m, times in s, pressures in Pa; the target's face is at x = 0.

    1/2 rho_p (v - u)^2 + Y = 1/2 rho_t u^2 + R      at the nose, speed u
    dv/dt = -Y/(rho_p L),   dL/dt = -(v - u)         of the rod that is left
"""

import glob
import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.environ["MPM_PROJECT_DIR"], "tests/lib"))
from foamCase import Points

RHO_P, RHO_T, Y, LENGTH, SPEED = 17000.0, 7850.0, 1.5e9, 50e-3, 1250.0


def noseSpeed(v, R, strength=Y):
    """u of Tate's balance."""
    a, b = RHO_P - RHO_T, 0.5*RHO_P*v*v + strength - R
    if b <= 0:
        return 0.0
    return (RHO_P*v - np.sqrt((RHO_P*v)**2 - 2*a*b))/a


def tate(R, end, dt=2e-8):
    """Columns time, nose, tail, u, v."""
    L, v, P, t = LENGTH, SPEED, 0.0, 0.0
    rows = []
    while t <= end + 0.5*dt:
        u = noseSpeed(v, R)
        rows.append((t, P, P - L, u, v))
        # Midpoint rule
        vm, Lm = v - 0.5*dt*Y/(RHO_P*L), L - 0.5*dt*(v - u)
        um = noseSpeed(vm, R)
        P += dt*um
        L -= dt*(vm - um)
        v -= dt*Y/(RHO_P*Lm)
        t += dt
    return np.array(rows).T


def table(case, folder, name):
    path = sorted(glob.glob(f"{case}/postProcessing/{folder}/*/{name}"))[0]
    return np.loadtxt(path)


class Path:
    """Nose, the foremost point of the rod, and tail over time."""

    def __init__(self, case="."):
        record = table(case, "extent", "rod.dat")
        self.t, self.nose = record[:, 0], record[:, 4]
        t, moved = table(case, "tail", "displacement_x.dat").T
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
    return sorted((d for d in os.listdir(case) if re.fullmatch(r"[0-9.]+(e-?\d+)?", d)
                   and os.path.isdir(f"{case}/{d}/lagrangian/rod")), key=float)


def points(case, time, phase):
    return Points([f"{case}/{time}/lagrangian/{phase}"])


def coating(case, time, h, cells=2.0):
    """Part of the rod's mass with a point of the target within so many cells."""
    rod, target = points(case, time, "rod"), points(case, time, "target")
    x, wall = rod["x"][:, :2], target["x"][:, :2]
    low, high = x.min(axis=0) - cells*h, x.max(axis=0) + cells*h
    wall = wall[np.all((wall > low) & (wall < high), axis=1)]
    near = np.array([np.min(np.sum((wall - p)**2, axis=1)) < (cells*h)**2 for p in x]) \
        if len(wall) else np.zeros(len(x), bool)
    m = rod["m"]
    return np.sum(m[near])/np.sum(m)


def fractured(case, time, phase, h):
    """Part of the neighbours of the start that are more than a cell apart now."""
    X = points(case, "0", phase).byId("x")[:, :2]
    x = points(case, time, phase).byId("x")[:, :2]
    apart = []
    for d in (0, 1):
        key = np.round(X/h*1e3).astype(int)
        order = np.lexsort((X[:, d], key[:, 1 - d]))
        same = np.diff(key[order, 1 - d]) == 0
        apart.append(np.abs(np.diff(x[order], axis=0)).max(axis=1)[same])
    return np.mean(np.concatenate(apart) > h)
