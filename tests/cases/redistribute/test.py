#!/usr/bin/env python3
"""A case goes on with another number of processors (redistributeCase).

    trips    two processors, three, one: points and fields at the end are those of one
             processor to 1e-10, mass and number of points too; also from a mesh that load
             balance has moved and with a boundary condition that has a state
    bits     from two to three and back, without a step: all columns and values bit by bit; from
             one to two as decomposePar
    wrong    messages
"""

import os
import re
import shutil
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from foamCase import FoamCase, RunFailed, mpirun, readField, readInternal, runParts, testModule
from killedRuns import times

CONTROL = "system/controlDict"
FIELDS = ("p", "rho", "U", "T", "theta", "alpha", "sigma", "Umean")


def module(name):
    return testModule(name, "redistribute")


def copyOf(case, name):
    other = FoamCase("redistribute", f"{case.name}-{name}")
    shutil.rmtree(other.path)
    shutil.copytree(case.path, other.path)
    return other


def redistribute(case, n, *options, ranks=None):
    """To so many processors, in slices along x."""
    before = len(case.processors())
    shutil.rmtree(case.file("processorsBefore"), ignore_errors=True)
    case.write("system/decomposeParDict", {
        "numberOfSubdomains": n, "method": "hierarchical",
        "hierarchicalCoeffs": {"n": (n, 1, 1), "delta": 0.001, "order": "xyz"}})
    try:
        case.run(*mpirun(ranks or max(before, n)), "redistributeCase", "-parallel", *options)
    finally:
        shutil.move(case.file("log.mpirun"), case.file("log.redistributeCase"))


def goOn(case, end):
    case.change(CONTROL, "^startFrom.*?;", "startFrom latestTime;")
    case.change(CONTROL, "^endTime.*?;", f"endTime {end};")
    if case.processors():
        case.runParallel()
    else:
        case.run("materialPointFoam")


def fields(case, time):
    return sorted(f for f in os.listdir(case.file(time))
                  if f.split(".")[0] in FIELDS and os.path.isfile(case.file(time, f)))


def difference(one, other, time):
    """Largest difference of points and fields over the largest value, and how many there were."""
    worst, n = 0.0, 0
    clouds = one.file(time, "lagrangian")
    for phase in os.listdir(clouds) if os.path.isdir(clouds) else ():
        columns = [c for c in os.listdir(os.path.join(clouds, phase))
                   if not c.startswith(("orig", "coord", "pos"))]
        worst = max(worst, one.largestDifference(other, time, [phase], columns))
        n += len(columns)
    for name in fields(one, time):
        u, v = (readInternal(c.file(time, name)) for c in (one, other))
        if np.ndim(u) and np.size(u) > 3:
            worst = max(worst, np.max(abs(u - v))/max(np.max(abs(u)), 1e-300)
                        if np.shape(u) == np.shape(v) else np.inf)
            n += 1
    return worst, n


def scenes():
    """Label, case, a mesh that has moved, columns and fields that must be there."""
    rebuild = module("rebuild")
    rebuild.module = module
    yield "failing plates in air", rebuild.plates("FMPM", air={}), True, 20
    yield "gas alone, waves leave it", rebuild.gasAlone(), False, 3
    yield "grains in a gas", rebuild.grainsInGas(), True, 15
    yield ("block through cyclic sides onto a wall", module("parallel").fallingBlock(
        "cyclic", 2, {"shapeFunction": "GIMP", "transfer": "APIC"}), True, 12)


def trips(table):
    for label, one, moves, least in scenes():
        with open(one.file(CONTROL)) as f:
            end = float(re.search(r"^endTime\s+(.*?);", f.read(), re.M)[1])
        one.change(CONTROL, "^writeInterval.*?;", f"writeInterval {end/3!r};")
        trip = copyOf(one, "trip")
        one.run("materialPointFoam")
        t = [name for name in one.times() if float(name) > 0]
        if moves:
            os.environ["MPM_MOVES"] = "5"
        try:
            trip.decompose((1, 2, 1) if "plates" in label else (2, 1, 1))
        finally:
            os.environ.pop("MPM_MOVES", None)
        goOn(trip, t[0])
        moved = os.path.isdir(os.path.join(trip.processors()[0], t[0], "polyMesh"))
        redistribute(trip, 3)
        goOn(trip, t[1])
        three = len(trip.processors())
        redistribute(trip, 1)
        goOn(trip, t[2])
        worst, n = difference(one, trip, t[-1])
        table.row(f"{label}: 2, 3, 1 processors, largest difference to one", 0, worst, 1e-10)
        table.check(f"{label}: all of it, from a mesh that had moved: {moves}",
                    n >= least and three == 3 and moved == moves and not trip.processors(),
                    f"{n} columns and fields, {three} processors, moved {moved}")


def times(case):
    folder = case.processors()[0] if case.processors() else case.path
    return sorted((t for t in os.listdir(folder) if t[0].isdigit() and float(t) > 0), key=float)


def values(case, time, processor):
    """Bytes of all columns of the points, of a processor, and values of fields."""
    found = {}
    root = os.path.join(processor, time)
    for folder, _, names in os.walk(os.path.join(root, "lagrangian")):
        for name in names:
            if name not in ("coordinates", "positions", "origProcId"):
                path = os.path.join(folder, name)
                found[os.path.relpath(path, root)] = np.asarray(readField(path)).tobytes()
    for name in fields(case, os.path.relpath(root, case.path)):
        found[name] = np.asarray(readInternal(os.path.join(root, name))).tobytes()
    for name in ("materialPointState", "materialPointMesh"):
        with open(os.path.join(root, "uniform", name), "rb") as f:
            found[name] = f.read()
    return found


def bits(table):
    rebuild = module("rebuild")
    rebuild.module = module
    case = copyOf(rebuild.plates("FLIP", air={}), "bits")
    case.decompose((2, 1, 1))
    goOn(case, 0.9e-6)
    end = times(case)[-1]
    before = [values(case, end, p) for p in case.processors()]
    redistribute(case, 3, "-time", end)
    middle = [values(case, end, p) for p in case.processors()]
    redistribute(case, 2)
    after = [values(case, end, p) for p in case.processors()]
    differ = [k for a, b in zip(before, after) for k in a if a[k] != b.get(k)]
    table.check("2 to 3 and back to 2, without a step: all columns, fields and states bit by bit",
                len(after) == 2 and not differ and len(before[0]) > 25,
                f"{differ}, of {len(before[0])}")
    table.check("on 3 they were others", len(middle) == 3 and middle[0] != before[0])

    # A case that is not decomposed, against decomposePar
    whole = copyOf(rebuild.plates("FLIP", air={}), "whole")
    whole.change(CONTROL, "^endTime.*?;", "endTime 0.9e-6;")
    whole.run("materialPointFoam")
    end = times(whole)[-1]
    parts = []
    for name in ("decomposePar", "redistributeCase"):
        other = copyOf(whole, name)
        other.write("system/decomposeParDict", {
            "numberOfSubdomains": 2, "method": "simple",
            "simpleCoeffs": {"n": (2, 1, 1), "delta": 0.001}})
        other.run(*(("decomposePar", "-time", end) if name == "decomposePar" else
                    (*mpirun(2), name, "-parallel", "-time", end)))
        parts.append([values(other, end, p) for p in other.processors()])
    differ = [k for a, b in zip(*parts) for k in a if a[k] != b.get(k)]
    table.check("1 to 2, as by decomposePar: all columns, fields and states bit by bit",
                len(parts[1]) == 2 and not differ and len(parts[0][0]) > 25,
                f"{differ}, of {len(parts[0][0])}")


def wrong(table):
    rebuild = module("rebuild")
    rebuild.module = module

    def text(make, label, words):
        try:
            make()
            said = "it ran"
        except RunFailed:
            with open(case.file("log.redistributeCase")) as f:
                said = f.read()
        lacks = [w for w in words if w not in said]
        table.check(f"wrong: {label}", not lacks, f"message lacks {lacks}")

    case = copyOf(rebuild.gasAlone(), "wrong")
    text(lambda: redistribute(case, 2, "-time", "7", ranks=2), "not decomposed, no such time",
         ("processor0", "no complete time"))
    case.decompose((2, 1, 1))
    text(lambda: redistribute(case, 3, ranks=2), "number of processors",
         ("2 processors", "asks for 3", "mpirun -np 3"))
    text(lambda: redistribute(case, 3, "-time", "7"), "time", ("Time 7", "processor0 has"))
    text(lambda: redistribute(case, 1), "time in the case already", ("folder", "already"))
    shutil.copytree(case.processors()[1], case.file("processor2"))
    shutil.rmtree(case.file("processor2", "constant"))
    shutil.move(case.file("processor1"), case.file("aside"))
    text(lambda: redistribute(case, 3, ranks=3), "a processor is missing",
         ("there is no", "processor1"))


if __name__ == "__main__":
    sys.exit(runParts("redistribute", trips, bits, wrong))
