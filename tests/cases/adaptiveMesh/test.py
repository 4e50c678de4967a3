#!/usr/bin/env python3
"""Hexahedra that are halved and put together again during a run (adaptiveMesh).

    shapes   adaptMesh in 1D, 2D, on a wedge with an axis, between cyclic sides and in skewed
             3D: checkMesh, volume, steps of levels across faces
    back     after boxes have come and gone the mesh is the base mesh, bit by bit
    uniform  a gas, and two fluids, in translation through boxes that come and go: nothing
             changes
    sums     100 changes in boxes that come and go: mass, momentum and energy of a blast, of
             two fluids and an explosive, of points in contact with a rigid body in a gas
    blast    a cylinder of high pressure: fine where it jumps, beside all fine and all coarse
    body     a disc in a blast, whose cells are fine wherever it goes: beside all fine
    restart  in the middle: as without
    wrong    messages
"""

import os
import random
import re
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from coupledCases import addPoints
from fluidCases import fluidCase
from foamCase import FoamCase, RunFailed, boxMesh, controlDict, noSchemes, runParts
from gasCases import WALL, gasCase, labels, volField

DICT = "system/adaptiveMeshDict"
ELASTIC = {"type": "neoHookean", "rho": 1000, "E": 1e7, "nu": 0.3}


def box(low, high, level=None, times=None):
    """A criterion: cells in a box, for a time."""
    return {"type": "shape", **({"level": level} if level else {}),
            **({"from": times[0], "to": times[1]} if times else {}),
            "shape": {"type": "box", "min": tuple(low), "max": tuple(high)}}


def adaptive(case, maxLevel, refine, **entries):
    case.write(DICT, {"maxLevel": maxLevel, **entries, "refine": refine})
    return case


def comeAndGo(case, end, nDim, n=100, maxLevel=2, seed=1):
    """Boxes in the unit cube, each for a short time, all levels; a look in each step."""
    rng = random.Random(seed)
    refine = {}
    for i in range(n):
        low = [rng.uniform(0, 0.8) if d < nDim else -1 for d in range(3)]
        size = [rng.uniform(0.05, 0.3) if d < nDim else 3 for d in range(3)]
        refine[f"box{i}"] = box(low, [a + b for a, b in zip(low, size)],
                                rng.randint(1, maxLevel),
                                (end*i/n, end*(i + rng.uniform(1, 4))/n))
    return adaptive(case, maxLevel, refine, buffer=0, keep=0, interval=1)


def changes(case):
    return int(re.search(r"Adaptive mesh: (\d+) changes", case.log())[1])


def cellLevel(case, time):
    return labels(case.file(time, "polyMesh/cellLevel"))


# ---------------------------------------------------------------- the mesh


def meshCase(name, mesh):
    case = FoamCase("adaptiveMesh", name)
    case.write("system/blockMeshDict", mesh)
    case.write("system/controlDict", controlDict(1, 1))
    noSchemes(case)
    case.write("system/fvSolution", {})
    return case


def wedgeMesh(n):
    a = 0.04
    return {"vertices": [(0, 0, 0), (1, 0, 0), (1, 1, -a), (0, 1, -a), (1, 1, a), (0, 1, a)],
            "blocks": f"(hex (0 1 2 3 0 1 4 5) ({n} {n} 1) simpleGrading (1 1 1))",
            "boundary": "(back { type wedge; faces ((0 1 2 3)); }"
                        " front { type wedge; faces ((0 1 4 5)); }"
                        " sides { type patch; faces ((0 0 5 3) (1 2 4 1) (2 3 5 4)); })"}


def shapes(table):
    def patches(*empty):
        walls = [s for s in ("x-", "x+", "y-", "y+", "z-", "z+") if s not in empty]
        return {"walls": ("patch", walls), **({"flat": ("empty", empty)} if empty else {})}

    unit = ((0, 0, 0), (1, 1, 1))
    skewed = boxMesh(*unit, (4, 5, 6), patches())
    skewed["vertices"][6] = (1.2, 1.1, 1.3)
    around = {"left": ("cyclic", ("x-",), "right"), "right": ("cyclic", ("x+",), "left"),
              "walls": ("patch", ("y-", "y+", "z-", "z+"))}
    for name, mesh, volume in (
            ("1D", boxMesh(*unit, (8, 1, 1), patches("y-", "y+", "z-", "z+")), 1),
            ("2D", boxMesh(*unit, (8, 8, 1), patches("z-", "z+")), 1),
            ("wedge with an axis", wedgeMesh(8), 0.04),
            ("cyclic 3D", boxMesh(*unit, (6, 5, 4), around), 1),
            ("skewed 3D", skewed, None)):
        case = adaptive(meshCase("shapes-" + name.replace(" ", "-"), mesh), 3,
                        {"a": box((0.05, -1, -1), (0.1, 0.3, 2)),
                         "b": box((0.7, 0.6, -1), (2, 2, 2), 1)}, buffer=1)
        case.run("blockMesh")
        case.run("checkMesh", "-constant")
        before = float(re.search(r"Total volume = ([^ ]*[0-9])", case.log("checkMesh"))[1])
        case.run("adaptMesh")
        case.run("checkMesh", "-constant", "-allTopology")
        log = case.log("checkMesh")
        after = float(re.search(r"Total volume = ([^ ]*[0-9])", log)[1])
        level = np.array(cellLevel(case, "constant"))
        owner, neighbour = (np.array(labels(case.file("constant/polyMesh", f)))
                            for f in ("owner", "neighbour"))
        steps = abs(level[owner[:len(neighbour)]] - level[neighbour])
        table.check(f"{name}: checkMesh finds nothing", "Mesh OK" in log,
                    re.findall(r"\*\*\*.*", log))
        table.row(f"{name}: volume", volume or before, after, 1e-5)
        table.check(f"{name}: all levels, steps of one across faces",
                    set(level) == {0, 1, 2, 3} and steps.max() == 1, (set(level), steps.max()))


def back(table):
    """Boxes for a while: at the end no cell is halved."""
    case = gasCase("adaptiveMesh", "back", (8, 8, 1), (1, 1, 0.1),
                   lambda x, y, z: (1 + 0*x, 0*x, 1 + 0*x), 0.5, ends=WALL)
    adaptive(case, 3, {"a": box((0.2, 0.2, -1), (0.5, 0.4, 2), None, (0.05, 0.2)),
                       "b": box((0.6, 0.1, -1), (0.9, 0.9, 2), 2, (0.1, 0.3))},
             buffer=0, keep=0, interval=1)
    case.run("materialPointFoam")
    end = case.times()[-1]
    same = [name for name in ("owner", "neighbour")
            if np.array_equal(*(labels(case.file(d, "polyMesh", name))
                                for d in ("constant", end)))]
    case.run("checkMesh", "-time", end)
    table.check("boxes that came and went leave the base mesh",
                changes(case) > 3 and len(same) == 2 and "Mesh OK" in case.log("checkMesh"),
                (changes(case), same))


# ----------------------------------------------------------------- fields


def uniform(table):
    """Translation between cyclic sides."""
    patches = {"left": ("cyclic", ("x-",), "right"), "right": ("cyclic", ("x+",), "left"),
               "sides": ("patch", ("y-", "y+"))}
    cyclic = {n: ("cyclic",)*3 for n in ("left", "right")}
    case = gasCase("adaptiveMesh", "uniform", (12, 12, 1), (1, 1, 0.1),
                   lambda x, y, z: (1.2 + 0*x, 0.7 + 0*x, 1 + 0*x), 0.5, ends=WALL,
                   patches=patches, conditions=cyclic)
    comeAndGo(case, 0.5, 2, n=60)
    case.run("materialPointFoam")
    end = case.times()[-1]
    for name, value in (("p", 1), ("rho.air", 1.2), ("U.air", (0.7, 0, 0))):
        v = volField(case, end, name)
        table.row(f"gas in translation through {changes(case)} changes: {name}, largest change",
                  0, np.max(abs(v - value))/np.max(np.abs(value)), 1e-12)


def gasSums(case):
    """First and last mass, momentum and energy of the log's gas."""
    rows = re.findall(r"^Gas air: mass (\S+), momentum \((\S+) (\S+) \S+\), energy (\S+)",
                      case.log(), re.M)
    return np.array([[float(x) for x in r] for r in (rows[0], rows[-1])])


def blastCase(name, n, end=0.2, **options):
    def initial(x, y, z):
        inside = (x - 0.3)**2 + (y - 0.4)**2 + (z*(z > 0.06))**2 < 0.15**2
        return 1 + 0*x, 0*x, 1 + 49.0*inside
    return gasCase("adaptiveMesh", name, n, (1, 1, 1 if n[2] > 1 else 0.1), initial, end,
                   ends=WALL, control={"reportInterval": 1}, **options)


def sums(table):
    for nDim, n in ((2, (12, 12, 1)), (3, (6, 6, 6))):
        case = comeAndGo(blastCase(f"sums-{nDim}D", n), 0.2, nDim)
        case.run("materialPointFoam")
        first, last = gasSums(case)
        for i, what in ((0, "mass"), (3, "energy")):
            table.row(f"blast in {nDim}D through {changes(case)} changes: {what}", first[i],
                      last[i], 1e-11)
        table.check(f"blast in {nDim}D: fix-ups", "isentropic 0 " in case.log().split("Gas air:")[-1])


if __name__ == "__main__":
    sys.exit(runParts("adaptiveMesh", shapes, back, uniform, sums))
