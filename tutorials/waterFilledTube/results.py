"""Reads a run and the measurement: motion of the wall, and what is kept."""

import csv

import numpy as np

from mpm.case import Case

#: When the displacement is compared [s]
WHEN = 32.9e-6


def measured(path="measured.csv"):
    """{quantity: rows of t [s], value [m or m/s]}."""
    found = {}
    with open(path) as f:
        next(f)
        for row in csv.DictReader(f):
            found.setdefault(row["quantity"], []).append(
                (float(row["t [s]"]), float(row["value [m or m/s]"])))
    return {name: np.array(rows) for name, rows in found.items()}


def peak(rows):
    """Time and value of the largest."""
    return rows[rows[:, 1].argmax()]


class Run:
    def __init__(self, path="."):
        self.case = Case(path)
        self.x, self.r, _ = self.case.edges()
        self.h = self.x[1] - self.x[0]
        # Columns: time, then x, y, z of the point
        self.displacement, self.velocity = (
            self.case.series("wall", f"{name}.dat", once=True)[:, [0, 2]]
            for name in ("displacement", "U"))

    def at(self, time):
        """Displacement of the wall at a time, or at several [m]."""
        return np.interp(time, *self.displacement.T)

    def difference(self, rows):
        """Root of the mean square of the differences from a measured displacement [m]."""
        return np.sqrt(np.mean((self.at(rows[:, 0]) - rows[:, 1])**2))

    def field(self, time, name):
        """Values on the cells [along r, along x]."""
        return self.case.field(time, name, len(self.x) - 1, len(self.r) - 1)

    def vapour(self, time):
        """Air and vapour in the tube over the volume of its inside at the
        start."""
        x, r = (0.5*(e[1:] + e[:-1]) for e in (self.x, self.r))
        inside = np.outer((r < 0.04445)*r, x < 0.1143)
        return np.sum(self.field(time, "alpha.air")*inside)/inside.sum()

    def kept(self):
        """{what: value}: largest errors of what is conserved, over their size."""
        case = self.case
        # Columns: 3 total of the points, 7 residual
        e = case.series("energy", "energy.dat")
        m = case.series("balance", "mixture.dat")
        tube = case.series("balance", "tube.dat")
        mass = {name: case.series("fluids", f"{name}.dat") for name in ("petn", "water", "air")}
        Theta = case.numbers("^Theta: min N, max N")
        return {
            "energy": abs(e[:, 7]).max()/np.ptp(e[:, 3]),
            "masses": {**{name: abs(a[:, -1]).max()/a[0, 1] for name, a in mass.items()},
                       "tube": np.ptp(tube[:, 2])/tube[0, 2]},
            # Along the axis: the sides of the wedge turn that along the radius
            "momentum": abs(m[:, 9]).max()/abs(m[:, 3]).max(),
            "Theta": (Theta.min(), Theta.max()),
            "fixups": case.numbers("kept N, pressure of relaxation kept N, isentropic N")[-1].sum(),
            "voids": case.numbers("energy N added")[-1]/np.ptp(e[:, 3])}
