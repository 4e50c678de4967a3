"""Reads a run: fragments, their velocity, products outside the ring; Gurney's velocity and
Mott's number of fragments."""

import numpy as np

from mpm.case import Case
from mpm.pieces import pieces

SIDE, DEPTH = 0.22, 1e-3
#: Ring, steel and TNT [kg/m3]; Gurney's constant of TNT [m/s]
INNER, OUTER, STEEL, TNT, GURNEY = 0.04, 0.048, 7830.0, 1630.0, 2370.0
#: The same on all meshes, of what cells of 1.83 mm resolve: points nearer to each other than
#: LINK [m] hold together (1.2 cells); pieces of less than this share of the ring's mass (three
#: cells long) are chips
LINK, CHIP = 2.2e-3, 0.02


def gurney(charge, loss=0.0):
    """Mass of the ring over that of a cylinder of this radius [m], and the velocity when all
    of the charge's energy but this [J/kg of ring] is spent on it."""
    ratio = STEEL*(OUTER**2 - INNER**2)/(TNT*charge**2)
    return ratio, np.sqrt(GURNEY**2/(ratio + 0.5) - 2*loss)


def mott(velocity, stress, slope):
    """Fragments of a ring: each break lets the tension go to a distance x0 on both sides until
    nothing breaks between them; x0 = sqrt(2 stress/(density slope)) r/velocity, the mean
    length 1.5 x0. slope: d ln(rate of breaks)/d strain."""
    return 2*np.pi*velocity/(1.5*np.sqrt(2*stress/(STEEL*slope)))


class Run:
    def __init__(self, path="."):
        self.case = Case(path)
        self.n = int(self.case.entry("system/blockMeshDict", "n"))
        self.h = SIDE/self.n
        self.times = self.case.times("lagrangian")
        centres = (np.arange(self.n) + 0.5)*self.h - SIDE/2
        self.radius = np.hypot(*np.meshgrid(centres, centres))

    def fragments(self, time, link=LINK, chip=CHIP):
        """Of a time: number of pieces, their mean radial velocity, share of the ring that is
        chips or has failed."""
        p = self.case.points(time, "ring")
        holds = p["damage"] < 1
        x, u, m = p["x"][holds, :2], p["U"][holds, :2], p["m"][holds]
        number = pieces(x, link)
        kept = np.bincount(number, m) > chip*p["m"].sum()
        part = kept[number]
        radial = np.sum(x*u, axis=1)/np.hypot(*x.T)
        return (kept.sum(), np.average(radial[part], weights=m[part]),
                1 - m[part].sum()/p["m"].sum())

    def meanRadius(self, time):
        p = self.case.points(time, "ring")
        return np.average(np.hypot(*p["x"][:, :2].T), weights=p["m"])

    def nearWhole(self):
        """The last time that is written with less than a hundredth of the ring failed."""
        def failed(time):
            return np.mean(self.case.points(time, "ring")["damage"] >= 1)
        return [time for time in self.times if failed(time) < 0.01][-1]

    def outside(self, time):
        """Products beyond the ring's mean radius [kg per metre of depth]."""
        mass = self.case.field(time, "thetaRho.tnt", self.n, self.n)
        return mass[self.radius > self.meanRadius(time)].sum()*self.h**2

    def hoopStress(self, time):
        """Mean tension of the ring that flows in plane strain [Pa]."""
        p = self.case.points(time, "ring")
        holds = p["damage"] < 1
        return 2/np.sqrt(3)*np.average(p["sigmaEq"][holds], weights=p["m"][holds])
