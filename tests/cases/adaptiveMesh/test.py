#!/usr/bin/env python3
"""Hexahedra that are halved and put together again during a run (adaptiveMesh).

    shapes   adaptMesh in 1D, 2D, on a wedge with an axis, between cyclic sides and in skewed
             3D: checkMesh, volume, steps of levels across faces
    back     after boxes have come and gone the mesh is the base mesh, bit by bit
    uniform  a gas, and two fluids, in translation through boxes that come and go: nothing
             changes
    sums     boxes that come and go: mass and energy of a blast
    together the same: an explosive in air, points in contact, a rigid body; on three processors
             while base cells go to random ones
    rounding two fluids, shares of 1 - 1e-15 in some cells: halved as with 1
    blast    a square of high pressure: fine where it jumps, beside all fine and all coarse
    lake     water below air at rest, boxes come and go through the surface: largest velocity
             beside that on a mesh that was halved before and stays
    carried  a disc of a fluid in another, carried over cyclic sides: width of its interface
             in fine cells beside that on fine cells, masses
    dam      a column of water collapses (tutorials/damBreak), fine at the interface: tip
             beside that on fine cells; with MPM_VERIFY=1 also on cells half as wide
    restart  in the middle: as without
    ranks    on three processors, from the base mesh and from one that was halved before; while
             all base cells go to random ones (loadBalance)
    balance  loadBalance shares the fine cells
    split    points that are split with their cells
    waves    across sides between two sizes, in points and in a gas
    wrong    messages
"""

import os
import re
import shutil
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from acrossSides import waves
from changing import DICT, adaptive, box, cellLevel, changes, comeAndGo
from fluidChanges import carried, dam, lake
from fluidCases import AIR, besidePoints, fluidCase
from foamCase import (FoamCase, RunFailed, boxMesh, controlDict, noSchemes, runParts,
                      testModule, velocityFile)
from gasCases import WALL, gasCase, labels, volField
from splitPoints import split


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
        level = np.array(cellLevel(case, 0))
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


def blastCase(name, n, end=0.2, slanted=False, **options):
    """slanted: without the symmetry, which rounding breaks by chance."""
    def initial(x, y, z):
        # Whole cells of 1/4, and of less
        inside = (x > 0.25) & (x < 0.5) & (y > 0.25) & (y < 0.5) & (z < 0.5)
        if slanted:
            return 1 + 0.1*x + 0.03*y, 0.1 + 0.05*y, 1 + 9.0*inside + 0.2*x + 0.1*y
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
        table.check(f"blast in {nDim}D: no fix-ups",
                    "isentropic 0 " in case.log().split("Gas air:")[-1])


def volumes(case, time, whole, nBase, nDim):
    """Of cells that are equal boxes in the base mesh."""
    return whole/nBase/2.0**(nDim*cellLevel(case, time))


def toLeaves(case, nDim):
    """Start values of the base cells to the cells that adaptMesh has made of them."""
    level = cellLevel(case, 0)
    at = np.cumsum(np.concatenate([[0], 2.0**(-nDim*level)]))
    cell = np.floor(at[:-1] + 1e-9).astype(int)
    for name in os.listdir(case.file("0")):
        if os.path.isfile(case.file("0", name)):
            with open(case.file("0", name)) as f:
                text = f.read()
            found = re.search(r"(nonuniform List<\w+>\s*)\d+\s*\(\n(.*?)\n\)", text, re.S)
            if found:
                rows = found[2].split("\n")
                new = f"{found[1]}{len(cell)}\n(\n" + "\n".join(rows[c] for c in cell) + "\n)"
                with open(case.file("0", name), "w") as f:
                    f.write(text[:found.start()] + new + text[found.end():])


def everything(name, n, end, halved=None):
    """An explosive in air, a block in contact with a plate, a rigid body that is pushed."""
    def initial(x, y, z):
        a = np.where((x - 0.3)**2 + (y - 0.4)**2 < 0.15**2, 1.0, 0.0)
        return [a, 1 - a], [1630.0, 1.2], 0.0, 1e5
    detonation = testModule("detonation", "adaptiveMesh")
    charge = detonation.lit()
    charge["detonation"] = {"type": "programmedBurn", "points": [(0.3, 0.4, 0)],
                            "velocity": 6930}
    fluids = {"charge": charge, "air": AIR}
    case = fluidCase("adaptiveMesh", name, (n, n, 1), (1, 1, 1/n), fluids, initial, end,
                     ends=WALL, maxCoGas=0.3,
                     control={"maxCo": 0.3, "reportInterval": 1})
    if halved:
        adaptive(case, 2, halved)
        case.run("adaptMesh")
        toLeaves(case, 2)
    law = {"constitutiveModel": {"type": "neoHookean", "rho": 2000, "E": 1e9, "nu": 0.3}}
    besidePoints(
        case, fluids,
        {"block": {**law, "velocityField": "block"}, "plate": {**law, "velocityField": "plate"},
         "body": {"type": "rigid", "rho": 7800, "motion": {"type": "free"},
                  "velocityField": "body"}},
        {"block": {"type": "box", "min": (0.55, 0.3, -1), "max": (0.7, 0.5, 1),
                   "velocity": (300, 0, 0)},
         "plate": {"type": "box", "min": (0.72, 0.2, -1), "max": (0.8, 0.7, 1)},
         "body": {"type": "sphere", "centre": (0.3, 0.75, 0), "radius": 0.1}},
        numerics={"shapeFunction": "nodeDual"}, ppc=8)
    for phase in ("block", "plate", "body"):
        velocityFile(case, phase, {"ends": "slip", "sides": "slip", "frontAndBack": "empty"})
    case.change("constant/phaseProperties", "^phases",
                "contact { all { type frictionless; } }\nphases")
    return case


def movesOf(case):
    return len(re.findall("^Load: imbalance [^,]*, by random [^,]*$", case.log(), re.M))


def toRandom(case, interval):
    """All base cells to random ones of three processors, every so many steps."""
    case.decompose((3, 1, 1))
    case.change("system/decomposeParDict", "^method ",
                f"loadBalance {{ interval {interval}; maxImbalance 1; worth 0;"
                " method random; }\nmethod ")


def together(table):
    n, end = 16, 1.2e-4
    one, moved = (comeAndGo(everything(name, n, end), end, 2) for name in ("together", "moved"))
    one.run("materialPointFoam")
    toRandom(moved, 3)
    moved.runParallel()
    for label, case in (("", one), (", three processors", moved)):
        log = case.log()
        name = "explosive, air, contact, rigid body" + label
        table.row(f"{name}: changes and moves", 100 if label else 50,
                  changes(case) + movesOf(case), 100 if label else 50, "atLeast")
        rows = re.findall(r"^Fluids: mass (.*?)(?:, |$)", log, re.M)
        first, last = ([float(x) for x in re.findall(r" ([0-9.e+-]+)", " " + row)]
                       for row in (rows[0], rows[-1]))
        for i, (m, m0) in enumerate(zip(last, first)):
            table.row(f"{name}: mass of fluid {i}", 1, m/m0, 1e-11)
        masses = re.findall(r"^Material points: \d+, mass (\S+),", log, re.M)
        table.row(f"{name}: mass of the points", 1, float(masses[-1])/float(masses[0]), 1e-11)
    table.row("the same: points of block and plate, difference to one processor", 0,
              one.largestDifference(moved, one.times()[-1], ["block", "plate"], ("x", "U", "V")),
              1e-10)


def rounding(table):
    """A slope of p in one of two fluids, whose share is 1, or less by rounding in every third
    cell: the children do not see that."""
    def run(name, less):
        def initial(x, y, z):
            b = less*(np.arange(len(x)) % 3 == 0)
            return [1 - b, b], [1.2 + 0.3*x, 1.2], 0.0, 1e5*(1 + 0.5*x + 0.2*y)
        case = fluidCase("adaptiveMesh", name, (8, 8, 1), (1, 1, 0.1), {"a": AIR, "b": AIR},
                         initial, 1e-5, ends=WALL)
        adaptive(case, 2, {"box": box((0.3, 0.3, -1), (0.7, 0.7, 1))})
        case.run("materialPointFoam")
        return [volField(case, case.times()[-1], f) for f in ("p", "rho")]
    exact, rounded = run("shares-1", 0), run("shares-rounded", 1e-15)
    for name, u, v in zip(("p", "rho"), exact, rounded):
        table.row(f"shares of 1 that rounding made less: {name} of halved cells, difference", 0,
                  np.max(np.abs(u - v))/np.max(np.abs(u)), 1e-10)


def blast(table):
    """A square of high pressure: errors of p and rho at the end on the base cells, by a mesh
    twice as fine; halved twice where it jumps, all fine, all coarse."""
    end, n = 0.06, 32
    refine = {name: {"type": "jump", "field": field, "relative": 0.1}
              for name, field in (("shock", "p"), ("contact", "rho.air"))}
    cases = {k: blastCase(f"blast-{k}", (n*k, n*k, 1), end) for k in (1, 4, 8)}
    cases["adaptive"] = adaptive(blastCase("blast", (n, n, 1), end), 2, refine)
    for c in cases.values():
        c.run("materialPointFoam")
    time = cases[1].times()[-1]
    levels = cellLevel(cases["adaptive"], time)

    def onBase(k, name):
        v = volField(cases[k], time, name)
        if k == "adaptive":
            at = np.cumsum(np.concatenate([[0], 4.0**-levels]))
            cell = np.floor(at[:-1] + 1e-9).astype(int)
            return np.bincount(cell, v*4.0**-levels, n*n)
        return v.reshape(n, k, n, k).mean(axis=(1, 3)).ravel()
    for name in ("p", "rho.air"):
        error = {k: np.abs(onBase(k, name) - onBase(8, name)).mean() for k in cases}
        table.row(f"blast, {name}, halved twice where it jumps: error over that of all fine"
                  f" cells ({error[1]/error[4]:.1f}: coarse)", 1, error["adaptive"]/error[4],
                  1.05, "atMost")
    table.row("blast: cells over all fine ones", 1, len(levels)/(4*n)**2, 0.7, "atMost")


def restart(table):
    """From a time in the middle, bit by bit."""
    case = adaptive(blastCase("restart", (12, 12, 1), 0.2, writeInterval=0.1), 2,
                    {"shock": {"type": "jump", "field": "p", "relative": 0.05}})
    case.run("materialPointFoam")
    end = case.times()[-1]
    before = {}
    for name in ("p", "thetaRhoU.air", "polyMesh/owner", "polyMesh/points", "polyMesh/cellLevel"):
        with open(case.file(end, name), "rb") as f:
            before[name] = f.read()
    shutil.rmtree(case.file(end))
    case.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
    case.run("materialPointFoam")
    bad = []
    for name, data in before.items():
        with open(case.file(end, name), "rb") as f:
            bad += [name] if f.read() != data else []
    table.check("restart from the middle: files of the end, bit by bit", not bad, bad)

    # The mesh changes once, its first folder is removed
    case = adaptive(blastCase("purged", (8, 8, 1), 0.02, writeInterval=0.005), 1,
                    {"box": box((0, 0, -1), (0.5, 0.5, 1))})
    case.change("system/controlDict", "purgeWrite.*?;", "purgeWrite 1;")
    case.run("materialPointFoam")
    times = [t for t in case.times() if float(t) > 0]
    table.check("old times removed: the mesh is in the one that is left",
                len(times) == 1 and changes(case) == 1
                and os.path.exists(case.file(times[0], "polyMesh/cellLevel")), times)


def ofBase(case, time, name):
    """Values of a field in the order of the whole base mesh, of one or several processors."""
    if not case.processors():
        return volField(case, time, name)
    nDim, parts = 2, {}
    for folder in case.processors():
        level = labels(os.path.join(folder, time, "polyMesh/cellLevel"))
        base = [t for t in os.listdir(folder)
                if os.path.exists(os.path.join(folder, t, "base/polyMesh/cellProcAddressing"))]
        last = max(base, key=lambda t: -1 if t == "constant" else float(t))
        number = labels(os.path.join(folder, last, "base/polyMesh/cellProcAddressing"))
        at = np.cumsum(np.concatenate([[0], 2.0**(-nDim*level)]))
        cell = np.floor(at[:-1] + 1e-9).astype(int)
        values = volField(FolderOf(folder), time, name)
        for c in range(len(number)):
            parts[number[c]] = values[cell == c] if len(values) > 1 else values
    return np.concatenate([parts[c] for c in sorted(parts)])


class FolderOf:
    """A processor's folder as a case."""

    def __init__(self, path):
        self.path = path

    def file(self, *names):
        return os.path.join(self.path, *names)

    def processors(self):
        return []


def ranks(table):
    """On three processors, from the base mesh and with trees that decomposePar has cut; a
    restart there."""
    end = 0.1
    refine = {name: {"type": "jump", "field": field, "relative": 0.1}
              for name, field in (("shock", "p"), ("contact", "rho.air"))}

    def blastOn(name):
        return adaptive(blastCase(name, (16, 16, 1), end, True, writeInterval=end/2), 2, refine)

    def cut(name, changing=True):
        case = everything(name, 16, 1e-5, halved={"box": box((0.2, 0.3, -1), (0.9, 0.9, 1))})
        return comeAndGo(case, 1e-5, 2, n=30) if changing else case
    state, flow = ("p", "rho.air", "U.air"), ("p", "U", "alpha.air")
    for label, make, fields, moves in (
            ("blast", blastOn, state, 0),
            ("trees cut, explosive, contact, rigid body", cut, flow, 0),
            ("the same, unchanged", lambda name: cut(name, False), flow, 0),
            ("blast, all base cells to random processors", blastOn, state, 7),
            ("everything to random processors", cut, flow, 2)):
        short = label.split(",")[0].replace(" ", "-") + "-moved"*(moves > 0)
        one, other = make("one-" + short), make("three-" + short)
        one.run("materialPointFoam")
        if moves:
            toRandom(other, moves)
        else:
            other.decompose((3, 1, 1))
        other.runParallel()
        time = one.times()[-1]
        worst = 0
        for name in fields:
            u, v = (ofBase(c, time, name) for c in (one, other))
            worst = max(worst, np.max(np.abs(u - v))/np.max(np.abs(u))
                        if u.shape == v.shape else np.inf)
        table.row(f"{label}: fields of three processors, difference to one", 0, worst, 1e-10)
        table.check(f"{label}: the mesh has changed", changes(other) > 2 or "unchanged" in label,
                    changes(other))
        if moves:
            table.row(f"{label}: moves", 10, movesOf(other), 10, "atLeast")
        if fields == state:
            before = {n: ofBase(other, time, n) for n in fields}
            for folder in other.processors():
                shutil.rmtree(os.path.join(folder, time))
            other.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
            other.runParallel()
            same = [n for n in fields if np.array_equal(before[n], ofBase(other, time, n))]
            table.check("restart on three processors: fields of the end, bit by bit",
                        len(same) == len(fields), same)
        else:
            # The rigid body hardly moves: its velocity is rounding
            for phases, columns in ((["block", "plate"], ("x", "U", "V")), (["body"], ("x", "V"))):
                table.row(f"{label}: points of {' and '.join(phases)}, difference", 0,
                          one.largestDifference(other, time, phases, columns), 1e-10)


def balance(table):
    """Cells of the processor that has most, over the mean: the fine ones are in a corner."""
    refine = {"shock": {"type": "jump", "field": "p", "relative": 0.1}}
    share = {}
    for balanced in (False, True):
        case = adaptive(blastCase(f"balance-{balanced}", (24, 24, 1), 0.04), 2, refine)
        case.decompose((2, 1, 1))
        if balanced:
            case.change("system/decomposeParDict", "^method ",
                        "loadBalance { interval 5; maxImbalance 1.05; worth 0; }\nmethod ")
        case.runParallel()
        n = [len(labels(os.path.join(f, "0.04", "polyMesh/cellLevel")))
             for f in case.processors()]
        share[balanced] = max(n)/np.mean(n)
    table.row(f"cells of two processors, most over mean ({share[False]:.2f} without loadBalance)",
              1, share[True], 1.2, "atMost")
    table.check("without loadBalance it is more", share[False] > 1.2, share[False])


def wrong(table):
    for label, entries, words in (
            ("level", {"maxLevel": 7}, ("maxLevel", "5")),
            ("keyword", {"bufer": 2}, ("bufer", "buffer")),
            ("type", {"refine": {"a": {"type": "jmp"}}}, ("jmp", "jump")),
            ("field", {"refine": {"a": {"type": "jump", "field": "rho", "relative": 1}}},
             ("rho", "rho.air")),
            ("threshold", {"refine": {"a": {"type": "jump", "field": "p"}}},
             ("relative", "absolute")),
            ("column", {"refine": {"a": {"type": "points", "column": "damage"}}}, ("min",)),
            ("nothing", {"refine": {}}, ("no criteria",))):
        case = blastCase(f"wrong-{label}", (4, 4, 1))
        case.write(DICT, {"maxLevel": 2, "refine": {"a": box((0, 0, 0), (1, 1, 1))}, **entries})
        try:
            case.run("materialPointFoam")
            text = ""
        except RunFailed:
            text = case.log()
        lacks = [w for w in (*words, "adaptiveMeshDict") if w not in text]
        table.check(f"wrong input: {label}", not lacks, f"message lacks {lacks}")


if __name__ == "__main__":
    sys.exit(runParts("adaptiveMesh", shapes, back, uniform, sums, together, rounding, blast,
                      lake, carried, dam, restart, ranks, balance, split, waves, wrong))
