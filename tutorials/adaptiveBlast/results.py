"""Reads a run, also of several processors. Lengths in m, times in s, pressures in Pa."""

import os

import numpy as np

from mpm.case import Case
from mpm.files import readInternal, readLists

AMBIENT = 1e5


def leaves(level, cells, n, low, h):
    """Low corners and widths of cells: base cells that are halved level times, in the order
    of their tree; n: base cells along x, y, z, of the width h."""
    at = np.cumsum(np.append(0, 8.0**-level))[:-1]
    order = np.floor(at + 1e-9).astype(int)
    part, base = at - order, cells[order]
    x = np.stack([base % n[0], base//n[0] % n[1], base//(n[0]*n[1])], axis=1).astype(float)
    for i in range(1, 1 + level.max(initial=0)):
        digit = np.floor(8*part + 1e-9).astype(int)
        part = 8*part - digit
        x += (digit[:, None] >> np.arange(3) & 1)*0.5**i
    return np.array(low) + h*x, h*0.5**level


class Run:
    def __init__(self, path="."):
        self.case = case = Case(path)
        self.n = [int(case.entry("system/blockMeshDict", k)) for k in ("nx", "ny", "nz")]
        self.low, self.h = (-0.4, 0, 0), 1.3/self.n[0]
        gauges = case.series("gauges", "p")
        self.t, self.p = gauges[:, 0], gauges[:, 1:] - AMBIENT
        self.mixture = case.series("balance", "mixture.dat")
        self.wall = case.series("balance", "total.dat")
        self.energy = case.series("energy", "energy.dat")

    def times(self):
        """Those with fields; on several processors trees are cut until the first step."""
        parts = self.case.processors()
        return Case(parts[0]).times("p")[1:] if parts else self.case.times("p")

    def cells(self, time, *names):
        """Low corners, widths and fields of the cells of a time."""
        parts = []
        for folder in self.case.processors() or [self.case.path]:
            part = Case(folder)
            number = np.arange(np.prod(self.n))
            if folder != self.case.path:
                at = [t for t in sorted(os.listdir(folder)) if os.path.exists(
                    part.file(t, "base/polyMesh/cellProcAddressing"))]
                number = readLists(part.file(at[0], "base/polyMesh/cellProcAddressing"))
            files = [part.file(t, "polyMesh/cellLevel") for t in ["constant", *part.times()]
                     if t == "constant" or float(t) <= float(time)]
            files = [f for f in files if os.path.exists(f)]
            level = readLists(files[-1]) if files else np.zeros(len(number), int)
            values = [np.broadcast_to(readInternal(part.file(time, n)), len(level))
                      for n in names]
            parts.append((*leaves(level, number, self.n, self.low, self.h), *values))
        return [np.concatenate(x) for x in zip(*parts)]

    def arrivals(self):
        """At the gauges, at half the largest overpressure."""
        return [self.t[np.argmax(p > 0.5*p.max())] for p in self.p.T]

    def rest(self):
        """Mass and momentum that nobody gave or took, over the mass and the largest momentum
        or impulse of the boundaries."""
        m = self.mixture
        size = max(np.linalg.norm(m[:, c:c + 3], axis=1).max() for c in (3, 6))
        return abs(m[:, 2]).max()/m[0, 1], np.linalg.norm(m[:, 9:12], axis=1).max()/size

    def residual(self):
        """Largest residual of the energy over what the gas gave to the wall, or the wall had."""
        e = self.energy
        return abs(e[:, 7]).max()/max(e[:, 3].max(), abs(e[:, 10] - e[:, 11]).max())

    @classmethod
    def of(cls, path):
        return cls(path) if os.path.exists(os.path.join(path, "log.materialPointFoam")) else None
