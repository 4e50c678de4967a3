#!/usr/bin/env python3
"""The same result on any number of processors.

Smooth: an elastic block falls, obliquely, through cyclic sides onto a wall;
120 steps (MPM_VERIFY=1: 500) in 1D, 2D and 3D, on boxes and on skewed cells, every shape function,
FLIP and FMPM; 1 processor against 2, 3 or 4. All columns by id agree to 1e-10 of the column's
maximum, no point is lost. (Not bit by bit: sharedNodes.H.)

Failing: the spall strip at 400 MPa with Weibull strengths: the same points have
failed after the same steps.

Round trip: decomposePar on 2, run, reconstructPar, decomposePar on 4, go on: the
result of the straight run to 1e-10. Restart on the same processors, binary: bit
by bit, also with a phase on each processor; killed while it writes: goes on from the last complete time of all.

Balance: cellWeights for decomposePar. Another number of processors by decomposePar
-latestTime; a processor whose points are missing.
"""

import os
import re
import shutil
import signal
import subprocess
import sys
import time

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (VERIFY, FoamCase, RunFailed, boxMesh, controlDict, mpirun, noSchemes,
                      readInternal, velocityFile)
from plates import plateCase
from report import Report

COLUMNS = ("x", "U", "m", "V", "sigma", "leftStretch", "damage", "halfSize")
E, RHO, H, STEPS = 1e6, 1000.0, 0.01, 500 if VERIFY else 120
WAVE = np.sqrt(E/RHO)


def fallingBlock(name, nDim, numerics, skew=0.0, sides="cyclic"):
    """A block of a third of the box (1D: 0.45); y down is the wall, x cyclic."""
    n = {1: (48, 1, 1), 2: (24, 24, 1), 3: (12, 12, 12)}[nDim]
    case = FoamCase("parallel", name)
    case.write("constant/phaseProperties", {
        "phases": ["block"],
        "block": {"constitutiveModel": {"type": "neoHookean", "rho": RHO, "E": E,
                                        "nu": 0.3}}})
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]",
                              "value": "(0 -500 0)" if nDim > 1 else "(-500 0 0)"},
               "uniformDimensionedVectorField")
    if nDim == 1:
        patches = {"wall": ("patch", ("x-",)), "top": ("patch", ("x+",)),
                   "sides": ("empty", ("y-", "y+", "z-", "z+"))}
        conditions = {"wall": {"type": "fixedValue", "value": "uniform (0 0 0)"},
                      "top": "slip", "sides": "empty"}
    else:
        patches = {"wall": ("wall", ("y-",)), "top": ("patch", ("y+",)),
                   "left": ("cyclic", ("x-",)), "right": ("cyclic", ("x+",)),
                   "sides": ("patch" if nDim == 3 else "empty", ("z-", "z+"))}
        conditions = {"wall": {"type": "fixedValue", "value": "uniform (0 0 0)"},
                      "top": "slip", "left": "cyclic", "right": "cyclic",
                      "sides": "slip" if nDim == 3 else "empty"}
    mesh = boxMesh((0, 0, 0), [H*c for c in n], n, patches)
    if nDim > 1:
        for a, b in (("left", "right"), ("right", "left")):
            mesh["boundary"] = mesh["boundary"].replace(
                f"{a} {{ type cyclic;", f"{a} {{ type cyclic; neighbourPatch {b};")
    if skew:
        mesh["vertices"] = [(x + skew*y, y, z) for x, y, z in mesh["vertices"]]
    case.write("system/blockMeshDict", mesh)
    velocityFile(case, "block", conditions)
    v = np.array([0.35, -0.25, 0.1])*WAVE*(np.arange(3) < nDim)
    if nDim == 1:
        v[0] = -0.3*WAVE
    # It lies across faces between processors while the wall strains it: a sum that lacks
    # parts is not seen in what only moves on
    low = [0.15, 0.12, 0.3] if nDim > 1 else [0.1, 0, 0]
    low = [(low[d] if d < nDim else 0)*H*n[d] for d in range(3)]
    length = 1/3 if nDim > 1 else 0.45
    high = [(low[d] + length*H*n[d]) if d < nDim else H for d in range(3)]
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "min": low, "max": high,
        "pointsPerCell": 2, "velocity": v}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    dt = 0.2*H/WAVE
    case.write("system/controlDict",
               controlDict(STEPS*dt, STEPS*dt/2, deltaT=dt))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


#: Label: dimensions, numerics, skew, splits; of several the last, MPM_VERIFY=1 all
SMOOTH = {
    "1D GIMP FLIP": (1, {"shapeFunction": "GIMP", "transfer": "FLIP"}, 0, [(2, 1, 1), (3, 1, 1)]),
    "2D linear FLIP": (2, {"shapeFunction": "linear", "transfer": "FLIP"}, 0,
                       [(2, 1, 1), (2, 2, 1)]),
    "2D GIMP FLIP": (2, {"shapeFunction": "GIMP", "transfer": "FLIP"}, 0,
                     [(2, 1, 1), (1, 2, 1), (2, 2, 1)]),
    "2D GIMP FMPM": (2, {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2}, 0,
                     [(4, 1, 1)]),
    "2D quadratic B-spline FMPM": (
        2, {"shapeFunction": "quadraticBSpline", "transfer": "FMPM", "order": 2}, 0,
        [(2, 2, 1)]),
    "2D cubic B-spline FLIP": (
        2, {"shapeFunction": "cubicBSpline", "transfer": "FLIP"}, 0, [(3, 1, 1)]),
    "2D skewed, linear FLIP": (
        2, {"shapeFunction": "linear", "transfer": "FLIP"}, 0.2, [(2, 1, 1), (2, 2, 1)]),
    "2D GIMP APIC USAVG": (
        2, {"shapeFunction": "GIMP", "transfer": "APIC", "stressUpdate": "USAVG",
            "energyBudget": True}, 0, [(2, 2, 1)]),
    "2D quadratic XPIC USL": (
        2, {"shapeFunction": "quadraticBSpline", "transfer": "XPIC",
            "stressUpdate": "USL"}, 0, [(2, 2, 1)]),
    "2D nodeDual FLIP": (
        2, {"shapeFunction": "nodeDual", "transfer": "FLIP", "energyBudget": True}, 0,
        [(2, 1, 1), (3, 1, 1)]),
    "2D skewed, nodeDual FMPM USAVG": (
        2, {"shapeFunction": "nodeDual", "transfer": "FMPM", "order": 3,
            "stressUpdate": "USAVG"}, 0.2, [(2, 1, 1), (1, 3, 1)]),
    "3D nodeDual FLIP": (3, {"shapeFunction": "nodeDual", "transfer": "FLIP"}, 0,
                         [(1, 2, 1)]),
    "3D GIMP FLIP": (3, {"shapeFunction": "GIMP", "transfer": "FLIP"}, 0,
                     [(2, 1, 1), (2, 2, 1)]),
    "3D linear FMPM": (3, {"shapeFunction": "linear", "transfer": "FMPM", "order": 2}, 0,
                       [(1, 2, 2)]),
}


def smooth(table, label):
    nDim, numerics, skew, splits = SMOOTH[label]
    word = re.sub(r"\W+", "-", label)
    one = fallingBlock(word, nDim, numerics, skew)
    start = one.points("0", "block").byId("x")
    one.run("materialPointFoam")
    end = one.times()[-1]
    steps = one.nSteps()
    for n in splits if VERIFY or nDim == 1 else splits[-1:]:
        text = "x".join(str(i) for i in n)
        several = fallingBlock(f"{word}-{text}", nDim, numerics, skew)
        several.decompose(n)
        several.runParallel()
        table.row(f"{label}: 1 against {text} processors, {steps} steps, largest difference",
                  0, one.largestDifference(several, end, ["block"], COLUMNS), 1e-10,
                  "atMost")
        nodes = [int(re.search(r", (\d+) nodes, ", case.log())[1]) for case in (one, several)]
        table.row(f"{label}: nodes that the log of {text} processors names", *nodes, 0)
    moved = np.max(abs(one.points(end, "block").byId("x") - start))
    stress = np.max(abs(one.points(end, "block")["sigma"]))/E
    table.row(f"{label}: it moved, cells", 3, moved/H, 3, "atLeast")
    table.row(f"{label}: it hit the wall, largest stress/E", 0.01, stress, 0.01, "atLeast")


def spallStrip(name, transfer):
    c = plateCase("parallel", name, 19,
                  {"shapeFunction": "GIMP", **transfer}, 1.25e-6, 0.125e-6, 0.5,
                  strength=400e6)
    c.change("constant/phaseProperties", "strength.*?;",
             "strength 400e6; weibull { modulus 10; seed 3; }")
    c.change("system/controlDict", "^startFrom.*?;",
             "startFrom latestTime; reportInterval 1;")
    return c


def failures(case):
    """Failed points after each step, and the ids of those at each written time."""
    counts = [int(n) for n in re.findall(r"^Failed points: (\d+)", case.log(), re.M)]
    root = case if case.nProcs == 1 else None
    times = case.times() if root else sorted(
        (t for t in os.listdir(case.processors()[0])
         if re.fullmatch(r"[\d.e+-]+", t)), key=float)
    ids = []
    for t in times:
        if float(t) > 0:
            points = case.points(t, "target")
            ids.append(tuple(np.sort(points["id"][points["damage"] > 0.5])))
    return counts, ids


def failing(table):
    for name, transfer in (("FLIP", {"transfer": "FLIP", "PICfraction": 0.01}),
                           ("FMPM2", {"transfer": "FMPM", "order": 2})):
        one = spallStrip(f"spall-{name}", transfer)
        one.nProcs = 1
        one.run("materialPointFoam")
        reference = failures(one)
        table.row(f"spall {name}: failed points", 10, reference[0][-1], 10, "atLeast")
        for n in ((1, 2, 1), (2, 2, 1)):
            several = spallStrip(f"spall-{name}-{n[0]*n[1]}", transfer)
            several.decompose(n)
            several.nProcs = n[0]*n[1]
            several.runParallel()
            counts, ids = failures(several)
            table.check(f"spall {name}, {several.nProcs} processors: as many failed after "
                        f"each of {len(counts)} steps", counts == reference[0])
            table.check(f"spall {name}, {several.nProcs} processors: the same ids at each of "
                        f"{len(ids)} times", ids == reference[1])


def roundTrip(table):
    numerics = SMOOTH["2D GIMP FLIP"][1]
    straight = fallingBlock("trip-straight", 2, numerics)
    straight.run("materialPointFoam")
    half, end = straight.times()[1:3]
    number = len(straight.points(end, "block")["id"])

    trip = fallingBlock("trip", 2, numerics)
    trip.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
    trip.change("system/controlDict", "^endTime.*?;", f"endTime {half};")
    trip.decompose((2, 1, 1))
    trip.runParallel()
    trip.run("reconstructPar")
    table.check("trip: reconstructPar has all points",
                len(trip.points(half, "block")["id"]) == number)
    for d in trip.processors():
        shutil.rmtree(d)
    trip.decompose((2, 2, 1))
    table.check("trip: decomposePar on 4 has all points",
                sum(len(trip_points) for trip_points in processorIds(trip, half)) == number)
    trip.change("system/controlDict", "^endTime.*?;", f"endTime {float(end)!r};")
    trip.runParallel()
    trip.run("reconstructPar", "-latestTime")
    table.row("trip: 2, reconstruct, 4 against 1, largest difference", 0,
              straight.largestDifference(trip, end, ["block"], COLUMNS), 1e-10, "atMost")
    trip.run("foamToVTK", "-latestTime")

    # Restart on the same processors
    a = fallingBlock("restart-straight", 2, numerics)
    a.decompose((2, 1, 1))
    a.runParallel()
    b = fallingBlock("restart-half", 2, numerics)
    b.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
    b.decompose((2, 1, 1))
    for p, q in zip(a.processors(), b.processors()):
        shutil.copytree(os.path.join(p, half), os.path.join(q, half))
    b.runParallel()
    table.row("restart on 2 processors, binary, largest difference", 0,
              a.largestDifference(b, end, ["block"], COLUMNS), 0, "atMost")

    # A time that one processor has not finished
    os.remove(os.path.join(b.processors()[0], end, "uniform", "materialPointState"))
    shutil.rmtree(os.path.join(b.processors()[1], end, "lagrangian"))
    b.runParallel()
    table.check("a time that one processor has not finished: all go back and say so",
                "was not written to its end" in b.log())
    table.row("and the result is that of the straight run, largest difference", 0,
              a.largestDifference(b, end, ["block"], COLUMNS), 0, "atMost")


def apart(table):
    """Two phases, at the restart each on a processor of its own: APIC goes on with the
    matrices that were written."""
    def make(name):
        c = fallingBlock(name, 2, {"shapeFunction": "GIMP", "transfer": "APIC"})
        law = {"velocityField": "block", "constitutiveModel": {
            "type": "neoHookean", "rho": RHO, "E": E, "nu": 0.3}}
        c.write("constant/phaseProperties", {"phases": ["block", "upper"], "block": law,
                                             "upper": law})
        c.write("system/setMaterialPointsDict", {"regions": {
            name: {"phase": name, "type": "box", "min": low, "max": np.add(low, 5*H),
                   "pointsPerCell": 2, "velocity": (0, v, 0)}
            for name, low, v in (("block", (7*H, 4*H, 0), -8), ("upper", (5*H, 15*H, 0), 5))}})
        c.run("setMaterialPoints")
        c.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
        c.decompose((1, 2, 1))
        return c

    a, b = make("apart-straight"), make("apart-half")
    a.runParallel()
    half, end = sorted((t for t in os.listdir(a.processors()[0])
                        if re.fullmatch(r"[\d.e+-]+", t)), key=float)[1:]
    table.check("phases apart: each on one processor", [
        os.listdir(os.path.join(p, half, "lagrangian")) for p in a.processors()]
        == [["block"], ["upper"]])
    for p, q in zip(a.processors(), b.processors()):
        shutil.copytree(os.path.join(p, half), os.path.join(q, half))
    b.runParallel()
    table.row("phases apart, APIC: restart on 2 processors, largest difference", 0,
              a.largestDifference(b, end, ["block", "upper"], COLUMNS), 0, "atMost")


def processorIds(case, timeName):
    for d in case.processors():
        path = os.path.join(d, timeName, "lagrangian", "block")
        if os.path.exists(os.path.join(path, "id")):
            from foamCase import readField
            yield readField(os.path.join(path, "id"))


def killed(table):
    """kill -9 of all processors while they write every second step."""
    numerics = SMOOTH["2D GIMP FLIP"][1]
    def make(name):
        c = fallingBlock(name, 2, numerics)
        c.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
        c.change("system/controlDict", "^writeControl.*?;", "writeControl timeStep;")
        c.change("system/controlDict", "^writeInterval.*?;", "writeInterval 2;")
        c.decompose((2, 1, 1))
        return c
    straight = make("kill-straight")
    straight.runParallel()
    c = make("kill")
    wait = 0.6
    for _ in range(5):
        p = subprocess.Popen(mpirun(2) + ("materialPointFoam", "-parallel"),
                             cwd=c.path, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, start_new_session=True,
                             env={**os.environ, "PWD": c.path})
        time.sleep(wait)
        os.killpg(p.pid, signal.SIGKILL)
        subprocess.run(["pkill", "-9", "-s", str(p.pid)], check=False)
        p.wait()
        time.sleep(0.2)
        wait += 0.13
    c.runParallel()
    end = max((t for t in os.listdir(c.processors()[0])
               if re.fullmatch(r"[\d.e+-]+", t)), key=float)
    table.row("kill -9 five times on 2 processors: difference to the straight run", 0,
              straight.largestDifference(c, end, ["block"], COLUMNS), 0, "atMost")


def balance(table):
    numerics = SMOOTH["2D GIMP FLIP"][1]
    share = {}
    for weightField in (None, "cellWeights"):
        c = fallingBlock(f"balance-{weightField}", 2, numerics)
        c.run("setMaterialPoints", "-cellWeights")
        c.decompose((1, 2, 1), weightField)
        c.change("system/controlDict", "^endTime.*?;", "endTime 1e-3;")
        c.runParallel()
        share[weightField] = float(re.search(r"imbalance ([\d.e+-]+) %", c.log())[1])
    table.row("balance: imbalance in % by cells", 50, share[None], 50, "atLeast")
    table.row("balance: imbalance in % with cellWeights, at most a row of cells", 0,
              share["cellWeights"], 13, "atMost")


def rankChange(table):
    """From 2 to 3 processors as README.md says, shares by cellWeights."""
    numerics = SMOOTH["2D GIMP FLIP"][1]
    straight = fallingBlock("ranks-straight", 2, numerics)
    straight.run("materialPointFoam")
    half, end = straight.times()[1:3]

    c = fallingBlock("ranks", 2, numerics)
    c.run("setMaterialPoints", "-cellWeights")
    c.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
    c.change("system/controlDict", "^endTime.*?;", f"endTime {half};")
    c.decompose((1, 2, 1), "cellWeights")
    c.runParallel()
    c.run("reconstructPar", "-latestTime")
    for d in c.processors():
        shutil.rmtree(d)
    c.decompose((3, 1, 1), "cellWeights")
    for d in c.processors():
        shutil.rmtree(d)
    c.run("decomposePar", "-latestTime")
    weights = readInternal(c.file(half, "cellWeights"))
    table.row("other number of processors: sum of cellWeights over the points", 1,
              np.sum(weights[weights > 1] - 0.02)/len(c.points(half, "block")["id"]), 1e-9)
    c.change("system/controlDict", "^endTime.*?;", f"endTime {float(end)!r};")
    c.runParallel()
    c.run("reconstructPar", "-latestTime")
    table.row("2, then 3 processors by decomposePar -latestTime against 1, largest "
              "difference", 0, straight.largestDifference(c, end, ["block"], COLUMNS),
              1e-10, "atMost")

    # A processor has lost its points
    n = len(c.points(half, "block")["id"])
    for d in c.processors():
        shutil.rmtree(os.path.join(d, end))
    shutil.rmtree(os.path.join(c.processors()[1], half, "lagrangian"))
    try:
        c.runParallel()
        table.check("a processor without lagrangian: the run stops", False, "exit status 0")
    except RunFailed:
        table.check("a processor without lagrangian: the run stops and says why",
                    f"but {n} were written: a part of lagrangian/block"
                    in " ".join(c.log().replace('"', "").split()))


def main():
    table = Report("parallel")
    for label in SMOOTH:
        try:
            smooth(table, label)
        except RunFailed as e:
            table.check(f"{label} runs", False, e)
    for part in (failing, roundTrip, apart, killed, balance, rankChange):
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
