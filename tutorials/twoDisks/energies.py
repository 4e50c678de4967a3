"""Reads the energies that the function object balance has written."""

import glob
import os

import numpy as np


class Energies:
    """Energies [J] of both disks over time.

    Velocity and stress step past each other (leapfrog): the velocity of a row
    has had the force of the stress of the row before, so it belongs to the
    middle between the two. centred is the energy with both at the same time,
    (K(n) + K(n+1))/2 + W(n); total is K(n) + W(n) as the balance has it.
    """

    def __init__(self, case="."):
        rows = np.loadtxt(sorted(glob.glob(os.path.join(
            case, "postProcessing/balance/*/total.dat")))[0])
        # One row for each time
        rows = rows[np.unique(rows[:, 0], return_index=True)[1]]
        # time, points, mass, momentum 3, angular momentum 3, K, W, K + W
        self.t = rows[:, 0]
        self.mass = rows[:, 2]
        self.momentum = rows[:, 3:6]
        self.angular = rows[:, 6:9]
        self.kinetic, self.strain, self.total = rows[:, 9:12].T

        #: Of the points' mass with the velocity of setMaterialPoints
        self.start = self.mass[0]*(0.1**2 + 0.1**2)/2

        self.centred = self.total[:-1] + np.diff(self.kinetic)/2

        #: Errors in per cent of the energy at the start
        self.error = 100*(self.total/self.start - 1)
        self.errorCentred = 100*(self.centred/self.start - 1)


def endAndLargest(error):
    """Of an error over time"""
    return error[-1], np.max(abs(error))
