"""The mesh, the crack and the air in it."""

import re

import numpy as np

from mpm.case import Case

H, STRESS = 1.9e-3, 687.39e6    # flyer [m], rho c v/2 [Pa]
WIDTH = 7.6e-3                  # plates, from -WIDTH/2


def mesh():
    """Cells along x and y and the sides of the cells [m]."""
    with open("system/blockMeshDict") as f:
        text = f.read()
    number = {k: float(v) for k, v in re.findall(r"^(n[xy]|[xy][01])\s+([-\d.]+);", text, re.M)}
    nx, ny = int(number["nx"]), int(number["ny"])
    return (nx, ny, 1e-3*np.linspace(number["x0"], number["x1"], nx + 1),
            1e-3*np.linspace(number["y0"], number["y1"], ny + 1))


def cells(case, time, name):
    """A field on the cells, [row along y, column along x(, component)]."""
    return Case(case).field(time, name, *mesh()[:2])


def crossing(t, f, level, after=0.8e-6):
    """First time at which f rises through the level; linear between the steps."""
    i = np.where((t > after) & (f >= level))[0][0]
    return t[i - 1] + (level - f[i - 1])/(f[i] - f[i - 1])*(t[i] - t[i - 1])


def firstFailure(case):
    t, damage = Case(case).series("failure", "damage.dat").T
    return t[np.argmax(damage > 0)]


def crack(case):
    """Cells within two cells of a failed point of the last time."""
    nx, ny, x, y = mesh()
    target = Case(case).points(Case(case).times()[-1], "target")
    at = target["x"][target["damage"] > 0.5]
    column, row = np.searchsorted(x, at[:, 0]) - 1, np.searchsorted(y, at[:, 1]) - 1
    found = np.zeros((ny, nx), bool)
    for i in range(-2, 3):
        for j in range(-2, 3):
            found[np.clip(row + j, 0, ny - 1), np.clip(column + i, 0, nx - 1)] = True
    return found


def crackMass(case):
    """Times, gas mass of the crack within 6 cells of the plate's free edges over
    what it was at first failure (linear between the written times)."""
    _, _, x, _ = mesh()
    middle = abs(0.5*(x[1:] + x[:-1]))
    band = crack(case) & (middle < WIDTH/2) & (middle > WIDTH/2 - 6*(x[1] - x[0]))
    names = Case(case).times()[1:]
    t = np.array([float(n) for n in names])
    mass = np.array([cells(case, n, "thetaRho.air")[band].sum() for n in names])
    return t, mass/np.interp(firstFailure(case), t, mass)
