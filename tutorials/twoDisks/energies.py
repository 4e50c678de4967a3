"""Reads the energies that the function object balance has written."""

import glob
import os

import numpy as np


class Energies:
    """Energies [J] of both disks over time."""

    def __init__(self, case="."):
        rows = np.loadtxt(sorted(glob.glob(os.path.join(
            case, "postProcessing/balance/*/total.dat")))[0])
        # time, points, mass, momentum 3, angular momentum 3, K, W, K + W
        self.t = rows[:, 0]
        self.mass = rows[:, 2]
        self.momentum = rows[:, 3:6]
        self.angular = rows[:, 6:9]
        self.kinetic, self.strain, self.total = rows[:, 9:12].T

        #: Of the points' mass with the velocity of setMaterialPoints
        self.start = self.mass[0]*(0.1**2 + 0.1**2)/2

        #: Error of the total energy in per cent of the energy at the start
        self.error = 100*(self.total/self.start - 1)

    def errors(self):
        """Error of the total energy at the end, largest [%]."""
        e = self.error
        return e[-1], e[np.argmax(abs(e))]
