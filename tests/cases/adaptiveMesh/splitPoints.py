"""Points that are split with their cells (splitPoints of adaptiveMeshDict): sums of before, and
a run on points that were split as on points that were set in the fine cells."""

import re

import numpy as np

from foamCase import FoamCase, boxMesh, controlDict, noSchemes, velocityFile


def spinning(name, nDim, n, end, split, transfer="FLIP", deltaT=None, lows=(0.375, 0.625),
             motion=None):
    """A block that spins and flies in the unit cube, halved once from the first x on, twice from
    the second."""
    case = FoamCase("adaptiveMesh", f"split-{name}-{nDim}D")
    ends = {"ends": ("empty", ("z-", "z+"))} if nDim == 2 else {}
    sides = ("x-", "x+", "y-", "y+") + (("z-", "z+") if nDim == 3 else ())
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (1, 1, 1 if nDim == 3 else 1/n), (n, n, n if nDim == 3 else 1),
        {**ends, "walls": ("wall", sides)}))
    noSchemes(case)
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "nodeDual", "transfer": transfer}})
    case.write("system/controlDict", controlDict(end, end, None if deltaT else 0.3, deltaT))
    case.write("constant/phaseProperties", {"phases": ["block"], "block": {
        "constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1e6, "nu": 0.3}}})
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "min": (0.25, 0.25, 0.25 if nDim == 3 else -1),
        "max": (0.75, 0.75, 0.75 if nDim == 3 else 2), "pointsPerCell": 2,
        **(motion or {"velocity": {"uniform": (1, 0.5, 0), "omega": 4, "axis": (0, 0, 1),
                                   "origin": (0.5, 0.5, 0)}})}}})
    velocityFile(case, "block", {"walls": "slip", **({"ends": "empty"} if nDim == 2 else {})})
    case.write("system/adaptiveMeshDict", {
        "maxLevel": 2, "splitPoints": split, "buffer": 0, "keep": 0, "refine": {
            f"right{i}": {"type": "shape", "level": i, "shape": {
                "type": "box", "min": (low, -1, -1), "max": (2, 2, 2)}}
            for i, low in enumerate(lows, 1)}})
    case.run("blockMesh")
    if not split:
        case.run("adaptMesh")
    case.run("setMaterialPoints")
    return case


def sums(case, time):
    """Number of points; their mass, momentum, moment of momentum and kinetic energy."""
    p = case.points(time, "block")
    m, x, U = p["m"], p["x"], p["U"]
    return len(m), np.concatenate([[m.sum()], m @ U, m @ np.cross(x, U),
                                   [0.5*m @ (U**2).sum(axis=1)]])


def split(table):
    for nDim, n in ((2, 16), (3, 8)):
        case = spinning("sums", nDim, n, 2e-9, True, deltaT=1e-9)
        case.run("materialPointFoam")
        (before, a), (after, b) = sums(case, "0"), sums(case, case.times()[-1])
        table.row(f"points split in {nDim}D: {before} become", 3*before, after, 2*before,
                  "atLeast")
        table.row(f"points split in {nDim}D: mass, momentum, its moment, kinetic energy, over"
                  " the largest", 0, np.max(np.abs(b - a))/np.max(np.abs(a)), 1e-12)
    for transfer in ("FLIP", "APIC"):
        # All of it, with one velocity: in cells with hanging points other points are set
        runs = [spinning(f"{transfer}-{made}", 2, 16, 0.02, made, transfer, 1e-4, lows=(0, 0.125),
                         motion={"velocity": (1, 0.5, 0), "stress": (2e4, 0, 0, 0, 0, 0)})
                for made in (False, True)]
        for case in runs:
            case.run("materialPointFoam")
        (nSet, a), (nSplit, b) = (sums(c, c.times()[-1]) for c in runs)
        table.check(f"{transfer}: as many points as are set in the fine cells", nSet == nSplit,
                    f"{nSet}, {nSplit}")
        x, y = (np.sort(c.points(c.times()[-1], "block")["x"].round(9).view(
            [("x", float), ("y", float), ("z", float)]), axis=0)["x"] for c in runs)
        table.row(f"{transfer}: places of the points, difference to those", 0,
                  np.max(np.abs(x - y)) if len(x) == len(y) else np.inf, 2e-9)
        table.row(f"{transfer}: sums over the largest, difference to those", 0,
                  np.max(np.abs(b - a))/np.max(np.abs(a)), 1e-10)
    three = spinning("FLIP-three", 2, 16, 0.02, True)
    three.decompose((3, 1, 1))
    three.runParallel()
    one = spinning("FLIP-one", 2, 16, 0.02, True)
    one.run("materialPointFoam")
    table.row("points split on three processors: largest difference to one", 0,
              one.largestDifference(three, one.times()[-1], ["block"], ("x", "U", "V", "sigma")),
              1e-10)

    # A column of the points: the lower half of the block, 4 by 8 cells, moves faster along x
    case = spinning("column", 2, 16, 1e-9, True, deltaT=1e-9)
    case.write("system/adaptiveMeshDict", {"maxLevel": 1, "buffer": 0, "keep": 0, "refine": {
        "fast": {"type": "points", "phases": ["block"], "column": "U", "min": 1}}})
    case.run("materialPointFoam")
    cells = [int(n) for n in re.findall(r"^Adaptive mesh: (\d+) cells", case.log(), re.M)]
    table.row("points whose column is at least min: cells", 16**2 + 3*4*8, cells[-1], 0)
