"""Points of pointsPerCell 2 (regions of the cells' corners) on the polyhedra of
polyDualMesh and on boxes refined 2:1 by refineHexMesh: uniform stress, at rest and in
motion, plate impact.
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
    # Measured: polyhedra 0.025, refined 0.011, warped hexahedra 0.008
    # (cornerRegions.H)
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


def uniformMoves(table):
    """The same in a cyclic box, while the points move at a speed that leaves the stress no
    time to act: at the start, and from half a cell of motion on to two and a half."""
    n, h, U = 6, 0.1, 1e4
    names = [a + b for a in "xyz" for b in ("Low", "High")]
    for kind in ("tets", "warped") + ("hexes", "prisms")*VERIFY:
        case = FoamCase("anyMesh", f"uniformMoves-{kind}")
        boxOfCells(case, kind, (0, 0, 0), (n*h,)*3, (n,)*3, {
            a: ("cyclic", (a[0] + "-+"[i % 2],), names[i ^ 1]) for i, a in enumerate(names)})
        case.write("constant/phaseProperties", {"phases": ["body"], "body": {
            "constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 10*P, "nu": 0}}})
        velocityFile(case, "body", {a: "cyclic" for a in names})
        case.write("system/setMaterialPointsDict", {"regions": {"body": {
            "phase": "body", "type": "cells", "pointsPerCell": 2,
            "velocity": (U, 0.7*U, 0.4*U), "stress": (-P, 0, 0, -P, 0, -P)}}})
        case.write("system/fvSolution", {"materialPoints": {"transfer": "FLIP"}})
        noSchemes(case)
        dt = 0.1*h/U
        case.write("system/controlDict", controlDict(25*dt, dt, deltaT=dt))
        case.run("setMaterialPoints")
        case.run("materialPointFoam")
        points = [case.points(t, "body") for t in case.times()]
        m = points[0].byId("m")
        rms = [np.sqrt(np.sum(m[:, None]*(b.byId("U") - a.byId("U"))**2)/np.sum(m))
               * 1000*h/(P*dt) for a, b in zip(points, points[1:])]
        table.row(f"uniform stress, {kind}, cyclic: rho h a/P at the start", 0, rms[0],
                  1e-8 if kind == "tets" else 5e-3, "atMost")
        table.row(f"uniform stress, {kind}, cyclic: largest rho h a/P after motion", 0,
                  max(rms[5:]), 1e-2, "atMost")


PARTS = (uniform, uniformMoves)
