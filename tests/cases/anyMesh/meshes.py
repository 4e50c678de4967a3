"""Points of pointsPerCell 2 (regions of the cells' corners) on the polyhedra of
polyDualMesh and on boxes refined 2:1 by refineHexMesh: uniform stress, plate impact.
"""

import numpy as np

from cellMesh import boxOfCells
from foamCase import VERIFY, FoamCase, controlDict, noSchemes, velocityFile

P = 1e5
LAW = {"type": "linearElastic", "rho": 1000, "E": 1e9, "nu": 0.3}


def refine(case, low, high):
    """The cells of a box of a mesh of hexahedra in half."""
    case.write("system/topoSetDict", {"actions": [
        "{ name fine; type cellSet; action new; source boxToCell; sourceInfo { box "
        f"({low[0]!r} {low[1]!r} {low[2]!r}) ({high[0]!r} {high[1]!r} {high[2]!r}); }} }}"]})
    case.run("topoSet")
    case.run("refineHexMesh", "fine", "-overwrite")


#: Mesh that boxOfCells makes for those that changeMesh() changes, how far it is moved
BASE = {"polyhedra": ("tets", 0.2), "refined": ("hexes", 0)}


def changeMesh(case, kind, low=None, high=None):
    """tets to the polyhedra of their dual, hexes to finer ones in a box."""
    if kind == "polyhedra":
        case.run("polyDualMesh", "60", "-overwrite")
    elif kind == "refined":
        refine(case, low, high)


def uniform(table):
    """A box full of points under one pressure between slip walls: the acceleration of
    the points in the first step over P/(rho h)."""
    n, h = 6, 0.1
    # Measured: polyhedra 0.027, refined 0.011, warped hexahedra 0.008
    for kind, limit in (("tets", 1e-10),) + (
            ("polyhedra", 5e-3), ("refined", 5e-3), ("warped", 5e-3))*VERIFY:
        case = FoamCase("anyMesh", f"uniform-{kind}")
        base, moved = BASE.get(kind, (kind, 0.2))
        boxOfCells(case, base, (0, 0, 0), (n*h,)*3, (n,)*3,
                   {"walls": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))},
                   moved=moved)
        case.write("constant/phaseProperties",
                   {"phases": ["body"], "body": {"constitutiveModel": LAW}})
        velocityFile(case, "body", {"walls": "slip"})
        case.write("system/setMaterialPointsDict", {"regions": {"body": {
            "phase": "body", "type": "cells", "pointsPerCell": 2,
            "stress": (-P, 0, 0, -P, 0, -P)}}})
        case.write("system/fvSolution", {"materialPoints": {"transfer": "FLIP"}})
        noSchemes(case)
        dt = 1e-7
        case.write("system/controlDict", controlDict(dt, dt, deltaT=dt))
        changeMesh(case, kind, (0.2, 0.2, 0.2), (9, 9, 0.4))
        case.run("setMaterialPoints")
        case.run("materialPointFoam")
        points = case.points(case.times()[-1], "body")
        m, U = points["m"], points["U"]
        rms = np.sqrt(np.sum(m[:, None]*U**2)/np.sum(m))
        table.row(f"uniform stress, {kind}: rho h a/P", 0, rms*1000*h/(P*dt), limit)


PARTS = (uniform,)
