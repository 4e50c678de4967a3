"""Reads a run: overpressure at the gauges."""

import numpy as np

from mpm.case import Case

AMBIENT = 101.325
GAUGES = np.array([0.5, 0.75, 1, 1.5, 2, 3, 4, 5])


class Run:
    """peaks [kPa], arrivals [ms] at half the peak, impulses [kPa ms] up to the first time
    without overpressure after the peak."""

    def __init__(self, path="."):
        self.case = Case(path)
        rows = self.case.series("pressure", "p")
        self.t, self.p = 1e3*rows[:, 0], 1e-3*rows[:, 1:] - AMBIENT
        self.peaks, self.arrivals, self.impulses = [], [], []
        for p in self.p.T:
            most = np.argmax(p)
            first = np.argmax(p > 0.5*p[most])
            after = np.nonzero(p[most:] < 0)[0]
            last = most + after[0] if after.size else len(p)
            part = np.maximum(p[:last], 0)
            self.peaks.append(p[most])
            self.arrivals.append(self.t[first])
            self.impulses.append(np.sum(0.5*(part[1:] + part[:-1])*np.diff(self.t[:last])))
