"""Flow through the neck of the hourglass, from the points of its written times."""

import re

import numpy as np

#: Density of the packing [kg/m3], gravity [m/s2], thickness of the mesh [m]
RHO, G, THICKNESS = 1600.0, 9.81, 0.005

#: Discharge coefficient of a slot, Q = C rho sqrt(g) W^(3/2) (Beverloo's law in 2D)
SLOT = 1.03


def opening(case):
    """Width of the neck [m]."""
    with open(case.file("system/snappyHexMeshDict")) as f:
        x = float(re.search(r"point1\s+\(([\d.]+)", f.read())[1])
    return 2*(x - case.entry("system/snappyHexMeshDict", "radius"))


def above(case):
    """Times [s], and the sand above the neck [kg/m, both halves]."""
    times = case.times("lagrangian")
    mass = []
    for t in times:
        points = case.points(t, "sand")
        mass.append(2*points["m"][points["x"][:, 1] > 0].sum()/THICKNESS)
    return np.array(times, float), np.array(mass)


def flow(t, mass, low=0.3, high=0.85):
    """Rate [kg/(s m)] and the largest distance from a straight line/mass of the start,
    between these parts of it."""
    some = (mass < high*mass[0]) & (mass > low*mass[0])
    line = np.polyfit(t[some], mass[some], 1)
    return -line[0], np.abs(np.polyval(line, t[some]) - mass[some]).max()/mass[0]


def coefficient(rate, W):
    return rate/(RHO*np.sqrt(G)*W**1.5)
