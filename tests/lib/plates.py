"""The flyer and the target of plateImpactExact as a case: a narrow strip.

2D, the normal of the plates is y, target 0..3.8 mm, flyer above it. nu = 0, so
a strip of a few cells with slip sides is the same as wide plates. Both phases
have one velocity field, as in tutorials/spall. With air around them and in their
pores the ends are cyclic, so that the sum of solid and gas is conserved.
"""

import math

import numpy as np

import plateImpactExact as exact
from cellMesh import boxOfCells
from foamCase import (FoamCase, boxMesh, controlDict, noSchemes, velocityFile)
from gasCases import UPWIND, WALL, schemes, uniformGas

#: Air at the start: pressure [Pa], density [kg/m3], gas constant [J/kg/K]
P_AIR, RHO_AIR, R_AIR = 1e5, 1.2, 287.0


def plateCase(group, name, cellsPerFlyer, numerics, endTime, writeInterval, maxCo,
              strength=None, pointsPerCell=2, width=4, probes=(),
              writeFormat="binary", air=None, carried=(0, 0), cells=None, depth=1):
    """Write, mesh and fill a case; not run yet. carried: velocity of all, across
    (through cyclic sides) and along the impact. Probes: phase, name, fields,
    y from, y to (of the start), operation. air: entries of the gas and, of the
    plates, volumeFraction (1) and drag (stick); None is vacuum. cells: prisms, hexes
    or tets (boxOfCells) in place of boxes, not carried; the plates' faces are sides of
    theirs. polyhedra: polyDualMesh of tets, the ends closed in air. depth: cells in z,
    more than one is 3D."""
    h = exact.H/cellsPerFlyer
    # The target's outer face moves on with 100 m/s from 0.75 us
    margin = max(4, math.ceil(exact.V*(endTime - 0.7e-6)/h) + 3)
    above, below = (math.ceil(max(0, v)*endTime/h) for v in (carried[1], -carried[1]))
    low, high = -(margin + below)*h, 3*exact.H + (margin + above)*h
    w = width*h
    law = {"velocityField": "plates",
           "constitutiveModel": {"type": "linearElastic", "rho": exact.RHO,
                                 "E": exact.E, "nu": 0}}
    if strength:
        law["failureModel"] = {"type": "maxPrincipalStress", "strength": strength}
    ends = {"ends": ("patch", ("y-", "y+"))}
    fill = {"pointsPerCell": pointsPerCell}
    phases = {"target": law, "flyer": law}
    if air is not None:
        air = dict(air)
        if cells != "polyhedra":
            ends = {"low": ("cyclic; neighbourPatch high", ("y-",)),
                    "high": ("cyclic; neighbourPatch low", ("y+",))}
        fill.update(stress="ambient", pressure=P_AIR,
                    volumeFraction=air.pop("volumeFraction", 1))
        law["drag"] = {"type": air.pop("drag", "stick")}
        if strength:
            law["failureModel"]["ambientPressure"] = P_AIR
        phases["air"] = {"type": "gas", "thermo": "perfectGas", "R": R_AIR,
                         "gamma": 1.4, **air}

    flat = depth == 1
    frontAndBack = {"frontAndBack": ("empty", ("z-", "z+"))} if flat else {}
    sides = {"sides": ("patch", ("x-", "x+") + (() if flat else ("z-", "z+")))}
    if carried[0]:
        sides = {"left": ("cyclic; neighbourPatch right", ("x-",)),
                 "right": ("cyclic; neighbourPatch left", ("x+",))}
    case = FoamCase(group, name)
    case.write("constant/phaseProperties",
               {"phases": list(phases), **phases})
    case.write("system/blockMeshDict", boxMesh(
        (0, low, 0), (w, high, depth*h),
        (width, 3*cellsPerFlyer + 2*margin + above + below, depth),
        {**ends, **sides, **frontAndBack}))
    conditions = {name: "calculated" if name == "ends" else "cyclic" for name in ends}
    conditions.update({name: "empty" for name in frontAndBack})
    velocityFile(case, "plates", {
        **{side: "cyclic" if carried[0] else "slip" for side in sides}, **conditions})
    case.write("system/setMaterialPointsDict", {"regions": {
        "target": {"phase": "target", "type": "box", "min": (0, 0, 0),
                   "max": (w, 2*exact.H, depth*h), **fill,
                   "velocity": (*carried, 0)},
        "flyer": {"phase": "flyer", "type": "box", "min": (0, 2*exact.H, 0),
                  "max": (w, 3*exact.H, depth*h), **fill,
                  "velocity": (carried[0], carried[1] - exact.V, 0)}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    if air is None:
        noSchemes(case)
    else:
        case.write("system/fvSchemes", schemes(UPWIND))
        uniformGas(case, P_AIR, P_AIR/(RHO_AIR*R_AIR),
                   {"sides": WALL, **{name: WALL if name == "ends" else (c,)*3
                                      for name, c in conditions.items()}})

    functions = {}
    for phase, label, fields, y0, y1, operation in probes:
        functions[label] = {
            "type": "materialPointProbes", "libs": "(mpmFunctionObjects)",
            "phase": phase, "fields": list(fields), "operation": operation,
            "points": {"box": f"(-1 {y0!r} -1) (1 {y1!r} 1)"},
            "writeControl": "timeStep", "writeInterval": 1}
    case.write("system/controlDict", controlDict(
        endTime, writeInterval, maxCo, functions=functions, writeFormat=writeFormat))
    if cells:
        several = {name: (kind.split(";")[0], at, *([{"low": "high", "high": "low"}[name]]
                                                    if "cyclic" in kind else []))
                   for name, (kind, at) in ends.items()}
        dual = cells == "polyhedra"
        boxOfCells(case, "tets" if dual else cells, (0, low, 0), (w, high, depth*h),
                   (width, 3*cellsPerFlyer + 2*margin, depth),
                   {**several, **sides, **frontAndBack}, moved=0 if dual else 0.2,
                   kept=[(1, margin + k*cellsPerFlyer) for k in (0, 2, 3)])
        if dual:
            case.run("polyDualMesh", "60", "-overwrite")
    else:
        case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def startPositions(case, phase):
    """y of the points at the start, in the order of their ids."""
    return case.points("0", phase).byId("x")[:, 1]


def tensionRun(group, name, cells, numerics, maxCo, pointsPerCell=2, probes=(),
               limit=300, carried=(0, 0), kind=None, **size):
    """The impact without failure, 1.2 us; cells over the target. The case, its
    core-seconds, the mean sigma_yy of the points that were within half a cell of
    the target's mid-plane over time, and t343: when it rises through half of
    rho c v/2, exact 3 H/c. size: width and depth of plateCase."""
    h = 2*exact.H/cells
    case = plateCase(
        group, name, cells//2, numerics, 1.2e-6, 1e-6, maxCo,
        pointsPerCell=pointsPerCell,
        probes=(("target", "middle", ("sigma_yy",), exact.H - h/2, exact.H + h/2, "mean"),
                *probes), carried=carried, cells=kind, **size)
    seconds = case.run("materialPointFoam", limit=limit)
    t, sigma = case.series("middle", "sigma_yy.dat").T
    return case, seconds, t, sigma, crossing(t, sigma, exact.STRESS/2)


def crossing(t, f, level, after=0.0):
    """First time after which f has risen through the level; linear between the
    steps; NaN if it never does."""
    for i in range(1, len(t)):
        if t[i] > after and f[i - 1] < level <= f[i]:
            return t[i - 1] + (level - f[i - 1])/(f[i] - f[i - 1])*(t[i] - t[i - 1])
    return np.nan
