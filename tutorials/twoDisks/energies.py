"""Reads the energies that the function object balance has written."""

import numpy as np

from mpm.case import Case


class Energies:
    """Energies [J] of both disks over time.

    With stressUpdate USAVG velocity and stress of a row belong to the same time.
    With the others they step past each other (leapfrog): total is K(n) + W(n)
    as the balance has it, whatever the scheme. transfer and residual are those
    of the budget (materialPointEnergy).
    """

    def __init__(self, case="."):
        rows = Case(case).series("balance", "total.dat", once=True)
        # time, points, mass, momentum 3, angular momentum 3, K, W, K + W
        self.t = rows[:, 0]
        self.mass = rows[:, 2]
        self.momentum = rows[:, 3:6]
        self.angular = rows[:, 6:9]
        self.kinetic, self.strain, self.total = rows[:, 9:12].T

        #: Of the points' mass with the velocity of setMaterialPoints
        self.start = self.mass[0]*(0.1**2 + 0.1**2)/2

        #: Errors in per cent of the energy at the start
        self.error = 100*(self.total/self.start - 1)

        budget = Case(case).series("energy", "energy.dat")
        #: In per cent of the energy at the start
        self.transfer = 100*budget[:, 4]/self.start
        self.residual = 100*(budget[:, 7] + budget[:, -1])/self.start

        #: Of one disk's momentum, and of that times the distance of the centres
        size = self.mass[0]/2*np.hypot(0.1, 0.1)
        self.momentumError = np.abs(self.momentum - self.momentum[0]).max()/size
        self.angularError = np.abs(self.angular - self.angular[0]).max()/(size*0.6)


def endAndLargest(error):
    """Of an error over time"""
    return error[-1], np.max(abs(error))
