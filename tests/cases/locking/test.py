#!/usr/bin/env python3
"""dilatation cellMean (B-bar): points of a nearly incompressible cell do not lock.

beam       a cantilever, 10 by 1, four cells high, with Poisson's ratio 0.49 swings
           in its first mode: half a period beside Euler and Bernoulli's with shear
           (Dunkerley: 1/w^2 = 1/w_bending^2 + 1/w_shear^2). The same with
           dilatation point is printed
split      the same on two processors, and stopped and gone on, bit by bit
punch      ground of von Mises under a strip: Prandtl's limit load (punch.py). With
           MPM_VERIFY=1 on three meshes, and FLIP, which creeps
energy     the swinging beam, USAVG, FLIP: its energy is kept as with dilatation point
"""

import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (VERIFY, FoamCase, boxMesh, controlDict, noSchemes, runParts,
                      velocityFile, writeField)
from punch import longPunch, punch

L, H, RHO, NU, CELLS = 1.0, 0.1, 2.0, 0.49, 4
E = 48000*(1 - NU**2)
MODE = 1.8751040687


def beamCase(name, dilatation, end=0.25, run=True, **numerics):
    h = H/CELLS
    case = FoamCase("locking", name)
    case.write("constant/phaseProperties", {"phases": ["beam"], "beam": {
        "constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E, "nu": NU,
                              "stress": "Kirchhoff"}}})
    case.write("system/blockMeshDict", boxMesh(
        (0, -2*H, 0), (L + 2*h, 3*H, h), (round(L/h) + 2, round(5*H/h), 1),
        {"wall": ("patch", ("x-",)), "free": ("patch", ("x+", "y-", "y+")),
         "sides": ("empty", ("z-", "z+"))}))
    velocityFile(case, "beam", {
        "wall": {"type": "fixedValue", "value": "uniform (0 0 0)"},
        "free": "calculated", "sides": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {"beam": {
        "phase": "beam", "type": "box", "min": (0, 0, 0), "max": (L, H, h),
        "pointsPerCell": 3}}})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0,
        "dilatation": dilatation, **numerics}})
    noSchemes(case)
    libs = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}
    case.write("system/controlDict", controlDict(end, end/2, maxCo=0.4, functions={
        "tip": {"type": "materialPointExtent", **libs},
        "balance": {"type": "materialPointBalance", **libs}}))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    x = case.points("0", "beam")["x"]
    k, s = MODE/L, (np.sinh(MODE) - np.sin(MODE))/(np.cosh(MODE) + np.cos(MODE))
    z = k*x[:, 0]
    U = np.zeros((len(x), 3))
    U[:, 1] = 0.02*(np.cosh(z) - np.cos(z) - s*(np.sinh(z) - np.sin(z)))
    writeField(case.file("0/lagrangian/beam/U"), U)
    case.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
    if run:
        case.run("materialPointFoam", limit=300)
    return case


def halfPeriod(case):
    """Until the centre of mass is back."""
    record = case.series("tip", "beam.dat")
    t, y = record[:, 0], record[:, 8] - 0.5*H
    back = np.flatnonzero((y[:-1] > 0) & (y[1:] <= 0))[0]
    return t[back] + (t[back + 1] - t[back])*y[back]/(y[back] - y[back + 1])


def beam(table):
    bending = MODE**2*np.sqrt(48000*H**2/(12*RHO))/L**2
    shear = 0.5*np.pi/L*np.sqrt(5/6*E/(2*(1 + NU))/RHO)
    exact = np.pi*np.sqrt(bending**-2 + shear**-2)
    case = beamCase("cellMean", "cellMean")
    table.row("beam, nu 0.49: half a period over the exact one", 1, halfPeriod(case)/exact,
              0.03)
    locked = halfPeriod(beamCase("point", "point"))/exact
    print(f"with dilatation point {locked:.4f}")
    table.check("beam, nu 0.49, dilatation point: stiffer than with cellMean",
                locked < halfPeriod(case)/exact)


def energy(table):
    case = beamCase("energy", "cellMean", stressUpdate="USAVG")
    record = case.series("balance", "beam.dat")
    total = record[:, 9] + record[:, 10]
    table.row("energy of the beam in half a period, largest change", 0,
              np.abs(total/total[0] - 1).max(), 1e-4)


def split(table):
    end, columns = 0.02, ("x", "U", "sigma", "V")
    one = beamCase("one", "cellMean", end)
    half, last = one.times()[-2:]
    again = beamCase("again", "cellMean", end, run=False)
    shutil.copytree(one.file(half), again.file(half))
    again.run("materialPointFoam")
    table.check("restart bit by bit", all(
        np.array_equal(one.points(last, "beam")[c], again.points(last, "beam")[c])
        for c in columns))
    two = beamCase("two", "cellMean", end, run=False)
    two.decompose((2, 1, 1))
    two.runParallel()
    table.row("two processors, largest difference", 0,
              one.largestDifference(two, last, ("beam",), columns), 1e-9, "atMost")


def main():
    return runParts("locking", beam, split, energy, punch, *((longPunch,) if VERIFY else ()))


if __name__ == "__main__":
    sys.exit(main())
