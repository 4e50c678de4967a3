"""Positions of waves and interfaces over time, and their velocities. Time counts from the
shock's arrival at the upstream edge of the cylinder; lengths in m.

An interface is where half of a cell is helium, a front where the pressure is 5 % above that
of the start; the incident shock, below the wall, is in the middle of its jump. A velocity is
the slope of a straight line through the positions in a window, as of the experiment.
"""

import os

import numpy as np

from mpm.case import Case

EDGE, START, P1, P2 = 0.035, 0.025, 101325.0, 159060.0
SHOCK = 1.22*np.sqrt(1.4*287*295)

#: J.-F. Haas & B. Sturtevant, J. Fluid Mech. 181 (1987) 41-76, table 2 (they say 10 %);
#: J.J. Quirk & S. Karni, ICASE Report 94-75 (1994), J. Fluid Mech. 318 (1996) 129-163, table 3
MEASURED = {"incident shock": 410, "refracted shock": 900, "transmitted shock": 393,
            "upstream interface": 170, "jet": 230, "downstream interface": 145,
            "upstream interface, late": 113}
COMPUTED = {"incident shock": 422, "refracted shock": 943, "transmitted shock": 377,
            "upstream interface": 178, "jet": 227, "downstream interface": 146}


def crossing(x, v, level, last=False):
    """Where v rises above the level first, or falls below it last; NaN: nowhere."""
    above = np.flatnonzero(v > level)
    if not len(above):
        return np.nan
    i = above[-1] if last else above[0]
    j = i + 1 if last else i - 1
    if not 0 <= j < len(x):
        return x[i]
    return x[i] + (x[j] - x[i])*(v[i] - level)/(v[i] - v[j])


class Run:
    def __init__(self, path="."):
        self.case = case = Case(path)
        folder = case.file("postProcessing", "rows")
        names = sorted(os.listdir(folder), key=float)
        self.t = np.array([float(n) for n in names]) - (EDGE - START)/SHOCK
        rows = [[np.loadtxt(os.path.join(folder, n, f"{row}_alpha.helium_p.xy"))
                 for row in ("axis", "wall")] for n in names]
        self.rows = rows
        self.upstream = np.array([crossing(*a[:, :2].T, 0.5) for a, _ in rows])
        self.downstream = np.array([crossing(*a[:, :2].T, 0.5, True) for a, _ in rows])
        self.front = np.array([crossing(a[:, 0], a[:, 2], 1.05*P1, True) for a, _ in rows])
        self.incident = np.array([crossing(w[:, 0], w[:, 2], 0.5*(P1 + P2), True)
                                  for _, w in rows])
        # Helium in any row, at the written times
        nx, ny = (int(case.entry("system/blockMeshDict", n)) for n in ("nx", "ny"))
        times = case.times()[1:]
        x = rows[0][0][:, 0]
        self.late = np.array([float(n) for n in times]) - (EDGE - START)/SHOCK
        self.rear = np.array([crossing(x, case.field(n, "alpha.helium", nx, ny).max(axis=0), 0.5)
                              for n in times])

    def velocities(self):
        out = self.t[np.flatnonzero((self.t > 0) & (self.front > self.downstream))[0]]
        found = {}
        for name, t, x, low, high in (
                ("incident shock", self.t, self.incident, 0, 50e-6),
                ("refracted shock", self.t, self.front, 5e-6, out),
                ("transmitted shock", self.t, self.front, out + 10e-6, 250e-6),
                ("upstream interface", self.t, self.upstream, 0, 100e-6),
                ("jet", self.t, self.upstream, 100e-6, 300e-6),
                ("downstream interface", self.t, self.downstream, 100e-6, 250e-6),
                ("upstream interface, late", self.late, self.rear, 600e-6, 1e-3)):
            on = (t >= low) & (t <= high)
            if np.sum(on) > 2 and t[-1] > 0.95*high:
                found[name] = np.polyfit(t[on], x[on], 1)[0]
        return found
