"""Reads a run. Lengths in m, times in s, pressures in Pa."""

import os

import numpy as np

import blast
from mpm.case import Case

GAUGES = (0.1535, 0.1835, 0.2135)   # along the axis; the wall is at 0.25
CHARGE = (600e5, 3000.0)            # pressure, temperature


class Run:
    def __init__(self, path="."):
        self.case = case = Case(path)
        self.nx, self.ny = (int(case.entry("system/blockMeshDict", k)) for k in ("nx", "ny"))
        self.h = 1.8/self.nx
        # The charge is whole cells: its radius is that of their area
        part = (case.field("0", "p") - blast.AIR[0])/(CHARGE[0] - blast.AIR[0])
        self.radius = np.sqrt(2*part.sum()*self.h**2/np.pi)
        gauges = case.series("gauges", "p")
        self.t, self.p = gauges[:, 0], gauges[:, 1:]
        # Each gauge shows the cell around it
        self.places = (np.floor(np.array(GAUGES)/self.h + 1e-6) + 0.5)*self.h
        self.mixture = case.series("balance", "mixture.dat")
        self.wall = case.series("balance", "total.dat")
        self.energy = case.series("energy", "energy.dat")

    def arrivals(self, n=1500):
        """Of the shock at the gauges, here and in the fine solution, at half the height that
        the pressure reaches there; that of the fine one at the wall's face."""
        t, p = blast.history(self.radius, *CHARGE, (*self.places, 0.25), 0.11e-3, n)
        half = 0.5*p.max(axis=0)
        return ([blast.arrival(self.t, g, h) for g, h in zip(self.p.T, half)],
                [blast.arrival(t, g, h) for g, h in zip(p.T[:3], half)], 2*half[3])

    def rest(self):
        """Mass and momentum that nobody gave or took, over the mass and the largest momentum
        or impulse of the boundaries."""
        m = self.mixture
        size = max(np.linalg.norm(m[:, c:c + 2], axis=1).max() for c in (3, 6))
        return abs(m[:, 2]).max()/m[0, 1], np.linalg.norm(m[:, 9:11], axis=1).max()/size

    def residual(self):
        """Largest residual of the energy over what the gas gave to the wall, or the wall had."""
        e = self.energy
        return abs(e[:, 7]).max()/max(e[:, 3].max(), abs(e[:, 10] - e[:, 11]).max())

    @classmethod
    def of(cls, path):
        return cls(path) if os.path.exists(os.path.join(path, "log.materialPointFoam")) else None
