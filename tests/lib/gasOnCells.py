"""A gas alone on prisms, tetrahedra, polyhedra or moved hexahedra; exact smooth flows.

    case, C, V = gasOnCells("gasAlone", "wave", "tets", (24, 4, 4), (1, 1/6, 1/6),
                            *cyclicSides("xyz"), simpleWave, 0.3)

The state (C, t) -> rho, U, p gives the start; case has run, C and V are the centres
and volumes of its cells. "polyhedra" are the dual cells of tetrahedra.
"""

import os

import numpy as np

from cellMesh import boxOfCells
from foamCase import FoamCase, controlDict, readInternal
from gasCases import VAN_LEER, schemes, writeVolField


def cyclicSides(axes):
    """Patches and conditions: these sides cyclic."""
    patches = {a + s: ("cyclic", (a + t,), a + o) for a in axes
               for s, t, o in (("Low", "-", "High"), ("High", "+", "Low"))}
    return patches, {name: ("cyclic",)*3 for name in patches}


def halve(case, boxes):
    case.write("system/adaptiveMeshDict", {"maxLevel": len(boxes), "buffer": 0, "refine": {
        f"box{i}": {"type": "shape", "level": i + 1,
                    "shape": {"type": "box", "min": low, "max": high}}
        for i, (low, high) in enumerate(boxes)}})
    case.run("adaptMesh")
    os.remove(case.file("system", "adaptiveMeshDict"))


def gasOnCells(folder, name, kind, n, high, patches, conditions, state, end,
               reconstruct=VAN_LEER, low=(0, 0, 0), moved=0.2, maxCoGas=0.4, deltaT=None,
               split=None, writes=1, start=None, place=None, halved=()):
    """conditions: of p, T, U on each patch; split: pieces (nx, ny, nz), one for each
    processor; start: called with the case before the run; place: as for boxOfCells;
    halved: boxes (low, high) whose cells are halved, inner ones twice."""
    case = FoamCase(folder, name.replace(" ", "-"))
    patches, conditions = dict(patches), dict(conditions)
    if n[2] == 1:
        patches["sides"], conditions["sides"] = ("empty", ("z-", "z+")), ("empty",)*3
    boxOfCells(case, "tets" if kind == "polyhedra" else kind, low, high, n, patches,
               moved=moved, place=place)
    case.write("system/fvSchemes", schemes(reconstruct))
    case.write("system/fvSolution", {})
    entries = controlDict(end, end/writes, maxCo=None if deltaT else maxCoGas,
                          deltaT=deltaT)
    entries["maxCoGas"] = entries.pop("maxCo", maxCoGas)
    case.write("system/controlDict", entries)
    case.write("constant/phaseProperties", {"phases": ["air"], "air": {
        "type": "gas", "thermo": "perfectGas", "R": 1, "gamma": 1.4}})
    if kind == "polyhedra":
        case.run("polyDualMesh", "60", "-overwrite")
    if halved:
        halve(case, halved)
    os.makedirs(case.file("0"), exist_ok=True)
    for what in ("Centres", "Volumes"):
        case.run("postProcess", "-func", "writeCell" + what, "-time", "0")
    C, V = (readInternal(case.file("0", f)) for f in "CV")
    rho, U, p = state(C, 0)
    for i, (field, values) in enumerate((("p", p), ("T.air", p/rho), ("U.air", U))):
        writeVolField(case, field, values, {k: c[i] for k, c in conditions.items()})
    if split:
        case.decompose(split)
    if start:
        start(case)
    if split:
        case.runParallel()
    else:
        case.run("materialPointFoam")
    return case, C, V


def simpleWave(C, t, amplitude=0.1):
    """Simple wave along x of length 1: what u has at a place runs with u + c."""
    c, k = np.sqrt(1.4), 2*np.pi
    u = amplitude*np.sin(k*C[:, 0])
    for _ in range(200):
        u = amplitude*np.sin(k*(C[:, 0] - (c + 1.2*u)*t))
    f = 1 + 0.2*u/c
    return f**5, np.column_stack([u, 0*u, 0*u]), f**7


def densityWave(C, t):
    """Density that moves with the gas along x, pressure and velocity 1."""
    one = np.ones(len(C))
    return (1 + 0.2*np.sin(2*np.pi*(C[:, 0] - t)), np.column_stack([one, 0*one, 0*one]), one)
