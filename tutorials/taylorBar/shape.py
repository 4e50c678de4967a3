"""Shape of a deformed bar from its points.

A row or column of points of the start is half a spacing inside the surface. Where the
surface is now follows from the last two of a line of points: x(R0) with the R0 of the
surface at the start, x linear in the place R of the points at the start.
"""

import numpy as np

from mpm.case import Case

RADIUS = 3.81e-3


def lines(place, of):
    """Numbers of the points in each line of equal place at the start, sorted by of."""
    key = np.round(place/np.ptp(place)*1e6).astype(int)
    return [np.flatnonzero(key == k)[np.argsort(of[key == k])] for k in np.unique(key)]


def beyond(X, x, surface):
    """x at the surface from the last two points of a line."""
    return x[-1] + (x[-1] - x[-2])/(X[-1] - X[-2])*(surface - X[-1])


class Bar:
    """Outline of the bar at a time, along x with the anvil at x = 0; lengths in m."""

    def __init__(self, case=".", length=25.4e-3, time=None):
        case = Case(case)
        X = case.points("0", "bar").byId("x")
        now = case.points(time or case.times("lagrangian/bar")[-1], "bar")
        x, strain, T = (now.byId(name) for name in ("x", "plasticStrain", "T"))
        self.x, self.strain, self.T = x, strain, T
        self.length0 = length
        self.lines = lines(X[:, 0], X[:, 1]) + lines(X[:, 1], X[:, 0])
        # Outer surface: along each radius of the start
        self.outline = np.array([
            (x[i[-1], 0], beyond(X[i, 1], x[i, 1], RADIUS))
            for i in lines(X[:, 0], X[:, 1])])
        # Rear end: mean over its area of lines along the axis
        rear = [(X[i[-1], 1], beyond(X[i, 0], x[i, 0], length))
                for i in lines(X[:, 1], X[:, 0])]
        weight, place = np.array(rear).T
        self.length = np.sum(weight*place)/np.sum(weight)
        # The foot: the largest radius near the anvil
        near = self.outline[:, 0] < 0.15*self.length
        self.foot = 2*np.max(self.outline[near, 1])
        self.pointLength = x[:, 0].max()
        self.pointFoot = 2*x[:, 1].max()

    def bulge(self, part=0.2):
        """Diameter at a part of the length from the anvil."""
        order = np.argsort(self.outline[:, 0])
        return 2*np.interp(part*self.length, *self.outline[order].T)

    def fractured(self, h):
        """Part of the neighbours of the start that are more than a cell h apart: there
        points part without any damage (numerical fracture)."""
        apart = np.concatenate([np.abs(np.diff(self.x[i, :2], axis=0)).max(axis=1)
                                for i in self.lines])
        return np.mean(apart > h), apart.max()/h


def energy(case):
    """Time and kinetic energy over that of the start."""
    record = Case(case).series("balance", "bar.dat")
    return record[:, 0], record[:, 9]/record[0, 9]
