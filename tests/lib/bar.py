"""Axial vibration of a bar that is fixed at x = 0: case and exact solution.

Length 25, E 100, rho 1, nu 0, so c = 10; 1D, 2 points per cell. It starts
unstrained with v(x, 0) = v0 sin(pi x/(2 L)), v0 = 0.1. Exact, small strains: the
mass centre has the velocity 2 v0/pi cos(2 pi t/T) with T = 4 L/c = 10, and the
total energy is rho L v0^2/4 = 0.0625 times the section.
"""

import numpy as np

from foamCase import (FoamCase, boxMesh, controlDict, noSchemes, velocityFile, writeField)

L, E, RHO, V0 = 25.0, 100.0, 1.0, 0.1
T = 4*L/np.sqrt(E/RHO)
ENERGY = RHO*L*V0**2/4


def barRun(group, name, numerics, cells, maxCo=0.2):
    """Five periods. The case, time, velocity of the mass centre, total energy,
    seconds of one core."""
    case = FoamCase(group, name)
    case.write("constant/phaseProperties", {
        "phases": ["bar"],
        "bar": {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E,
                                      "nu": 0}}})
    beyond = 4
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (L*(1 + beyond/cells), 1, 1), (cells + beyond, 1, 1),
        {"wall": ("patch", ("x-",)), "end": ("patch", ("x+",)),
         "sides": ("empty", ("y-", "y+", "z-", "z+"))}))
    velocityFile(case, "bar", {
        "wall": {"type": "fixedValue", "value": "uniform (0 0 0)"},
        "end": "calculated", "sides": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {"bar": {
        "phase": "bar", "type": "box", "min": (0, 0, 0), "max": (L, 1, 1),
        "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    case.write("system/controlDict", controlDict(5*T, 5*T, maxCo=maxCo, functions={
        "balance": {"type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
                    "writeControl": "timeStep", "writeInterval": 1}}))
    case.run("blockMesh")
    case.run("setMaterialPoints")

    x = case.points("0", "bar")["x"][:, 0]
    start = np.zeros((len(x), 3))
    start[:, 0] = V0*np.sin(np.pi*x/(2*L))
    writeField(case.file("0/lagrangian/bar/U"), start)

    seconds = case.run("materialPointFoam", limit=600)
    # time, points, mass, momentum 3, angular momentum 3, kinetic, strain, total
    record = case.series("balance", "bar.dat")
    return case, record[:, 0], record[:, 3]/record[:, 2], record[:, 11], seconds


def period(t, v):
    """From all zero crossings, linear between the steps."""
    i = np.nonzero(v[:-1]*v[1:] < 0)[0]
    zero = t[i] - v[i]*(t[i + 1] - t[i])/(v[i + 1] - v[i])
    return 2*(zero[-1] - zero[0])/(len(zero) - 1) if len(zero) > 1 else np.nan
