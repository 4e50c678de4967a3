"""A step on 1, 2, 4 and 8 processors, counted, and a model of it for more.

    Allrun                  measures all scenes, then the model
    Allrun points gas       measures these scenes only
    Allrun -model           the tables of the model from what was measured last

Scenes, each in two sizes: points (benchmarks/block: boxes, linear, FLIP), gas (a block in a
gas of benchmarks/coupledStep.py, 3D), fluids (two gases as fluids, a ball of one in the other).
A library for LD_PRELOAD (countMPI.c, made here by the compiler with mpi.h) counts the calls of
MPI of each rank and takes their processor time from that of the rank: what is left is
computing. Runs of N and of 2 N steps; the differences are what N steps take, without the
start. Least time of four. On fewer cores than ranks the processor time and the counts mean
something, the clock does not. benchmarks/run/scale/steps.csv; model.py has the model."""

import csv
import glob
import os
import re
import shutil
import subprocess
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../tests/lib"))
import model  # noqa: E402
from blockInGas import blockInGas  # noqa: E402
from fluidCases import fluidCase  # noqa: E402
from foamCase import Case, FoamCase, RunFailed, mpirun  # noqa: E402
from gasCases import OPEN  # noqa: E402

RUN = os.path.join(HERE, "../run/scale")
REPEATS = 4

#: Ranks along x, y, z
PIECES = {1: (1, 1, 1), 2: (2, 1, 1), 4: (2, 2, 1), 8: (2, 2, 2)}


def points(k, steps):
    """8 k^3 points in cells of 1/k m."""
    case = FoamCase("scale", f"points-{k}", os.path.join(HERE, "../block"))
    dt = 2.5e-4*32/k
    cells = round(k*40/32), round(k*40/32), round(k*36/32)
    case.change("system/blockMeshDict", r"\(40 40 36\)", "(%d %d %d)" % cells)
    case.change("system/controlDict", "^deltaT .*", f"deltaT {dt!r};")
    case.run("blockMesh")
    case.run("setMaterialPoints", "-cellWeights")
    return case, np.prod(cells), len(case.points("0", "block")["x"]), dt*steps


def gas(n, steps):
    """A block at 50 m/s in the middle of air at rest, in n^3 cells; half of a side, of larger
    boxes a quarter, so that points and cells can be told apart."""
    h, side = 1e-4, 0.5 if n < 48 else 0.25
    low, high = 0.5*(1 - side)*n*h, 0.5*(1 + side)*n*h
    case = blockInGas("scale", f"gas-{n}", 3, n, {"type": "box", "min": (low,)*3,
                                                  "max": (high,)*3},
                      (40, 30, 0), 1, h=h, gasVelocity=(0, 0, 0), walls=True)
    # Without the function objects of the tests, which ask all ranks in each step
    case.change("system/controlDict", r"(?s)^functions\s*\{.*?^\}", "")
    case.change("system/controlDict", "^reportInterval .*", "")
    end = case.entry("system/controlDict", "endTime")
    return case, n**3, len(case.points("0", "block")["x"]), end*steps


def fluids(n, steps):
    """A ball of a gas in another, quarters of different states."""
    air = {"thermo": "perfectGas", "R": 1, "gamma": 1.4}
    end = 0.15*steps/n

    def initial(x, y, z):
        up = (x < 0.5) ^ (y < 0.5) ^ (z < 0.5)
        ball = 1.0*((x - 0.5)**2 + (y - 0.5)**2 + (z - 0.5)**2 < 0.3**2)
        rho = np.where(up, 1, 0.5)
        return [ball, 1 - ball], [rho, rho], 0.0, np.where(up, 1, 0.5)

    case = fluidCase("scale", f"fluids-{n}", (n, n, n), (1, 1, 1), {"one": air, "other": air},
                     initial, end, sides=OPEN)
    return case, n**3, 0, end


#: Scene: maker, sizes and steps N of each: of the first two whole tens, between which a report is
SCENES = {"points": (points, ((24, 200), (48, 60))), "gas": (gas, ((32, 40), (64, 20))),
          "fluids": (fluids, ((32, 40), (64, 8)))}


def library():
    """countMPI.c, compiled in the run folder."""
    made = os.path.join(RUN, "countMPI.so")
    flags = subprocess.run(["mpicc", "-showme:compile"], stdout=subprocess.PIPE,
                           check=True).stdout.decode().split()
    if subprocess.run([os.environ.get("CC", "cc"), *flags, "-O2", "-shared", "-fPIC",
                       os.path.join(HERE, "countMPI.c"), "-o", made]).returncode:
        sys.exit("countMPI.c: needs a C compiler and mpi.h (libopenmpi-dev)")
    return made


def realTime():
    """Words before a command that give it real-time priority, if one may."""
    words = ["chrt", "-r", "1"]
    return words if shutil.which("chrt") and not subprocess.run(
        words + ["true"], stderr=subprocess.DEVNULL).returncode else []


def decomposed(case, ranks, hasPoints):
    """A copy of the case with a box of cells for each rank, the same points (else cells) in
    each."""
    copy = FoamCase("scale", f"{case.name}-{ranks}", case.path)
    shutil.copytree(case.file("constant"), copy.file("constant"), dirs_exist_ok=True)
    if ranks > 1:
        copy.write("system/decomposeParDict", {
            "numberOfSubdomains": ranks, "method": "hierarchical",
            **({"weightField": "cellWeights"} if hasPoints else {}),
            "hierarchicalCoeffs": {"n": PIECES[ranks], "delta": 0.001, "order": "xyz"}})
        copy.run(*mpirun(ranks), "redistributeCase", "-parallel", limit=600)
    return copy


def sharedFaces(case):
    """Faces between ranks, each once."""
    n = 0
    for folder in case.processors():
        with open(os.path.join(folder, "constant/polyMesh/boundary")) as f:
            n += sum(map(int, re.findall(r"procBoundary\w+\s*\{[^}]*?nFaces\s+(\d+)", f.read())))
    return n//2


def counted(case, ranks, end, made):
    """Of one run: steps, and of each rank the words of countMPI.c."""
    case.change("system/controlDict", r"^endTime .*", f"endTime {end!r};")
    case.change("system/controlDict", r"^(writeControl) .*", r"\1 timeStep;")
    case.change("system/controlDict", r"^(writeInterval) .*", r"\1 1000000;")
    base = case.file("count")
    for path in glob.glob(base + ".*"):
        os.remove(path)
    command = ["env", "LD_PRELOAD=" + made, "MPM_COUNT=" + base, "materialPointFoam"]
    if ranks > 1:
        command = [*mpirun(ranks), *command, "-parallel"]
    with open(case.file("log.materialPointFoam"), "w") as log:
        if subprocess.run(realTime() + command, cwd=case.path, stdout=log,
                          stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=600,
                          env={**os.environ, "PWD": case.path}).returncode:
            raise RunFailed(case.reason(log.name))
    nFiles = 0
    for folder in (case.path, *case.processors()):
        for name in Case(folder).times():
            if name != "0":
                nFiles = sum(len(files) for _, _, files in os.walk(os.path.join(folder, name)))
                shutil.rmtree(os.path.join(folder, name))
    found = []
    for rank in range(ranks):
        with open(f"{base}.{rank}") as f:
            lines = [line.split() for line in f]
        words = {" ".join(w[:-2]): np.array(w[-2:], float) for w in lines if len(w) > 2}
        found.append({**{w[0]: float(w[1]) for w in lines if len(w) == 2}, **words})
    found[0]["files"] = nFiles
    return case.nSteps(), found


def kindOf(a, b):
    """Pieces of 2 x 2 x 2 that have a face, an edge or a corner in common."""
    return ("faces", "edges", "corners")[bin(a ^ b).count("1") - 1]


def oneRound(cases, end, made):
    """{(ranks, 1 or 2): steps and words} of runs to the end and to twice the end."""
    return {(ranks, n): counted(case, ranks, n*end, made)
            for ranks, case in cases.items() for n in (1, 2)}


def perStep(one, two, n, name, column):
    """Of all ranks: calls (column 0) or bytes (1) of a step."""
    return sum((b.get(name, (0, 0))[column] - a.get(name, (0, 0))[column])/n
               for a, b in zip(one, two))


def overKinds(one, two, n):
    """On eight ranks: messages and bytes of a step between two that touch."""
    row = {}
    for kind in ("faces", "edges", "corners"):
        pairs = [(a, b) for a in range(8) for b in range(8)
                 if a != b and kindOf(a, b) == kind] if len(one) == 8 else []
        for column, name in enumerate(("messages", "bytes")):
            row[f"{name} over {kind}"] = np.mean(
                [perStep(one[a:a + 1], two[a:a + 1], n, f"to {b}", column)
                 for a, b in pairs]) if pairs else ""
    return row


def measure(scene, size, steps, made):
    """Rows of a scene: per step, of all ranks."""
    case, nCells, nPoints, end = SCENES[scene][0](size, steps)
    cases = {ranks: decomposed(case, ranks, scene == "points") for ranks in PIECES}
    rounds = [oneRound(cases, end, made) for _ in range(REPEATS)]
    for ranks in PIECES:
        (n1, one), (n2, two) = (rounds[0][ranks, k] for k in (1, 2))
        n = n2 - n1
        first, second = (np.min([[f["computing"] for f in r[ranks, k][1]] for r in rounds],
                                axis=0) for k in (1, 2))
        computing = (second - first)/n

        def of(names, column):
            return sum(perStep(one, two, n, name, column) for name in names)
        lists = ("Send", "Bsend", "Gatherv", "Scatterv")
        row = {"scene": scene, "size": size, "cells": nCells, "points": nPoints, "ranks": ranks,
               "shared faces": sharedFaces(cases[ranks]), "steps": n, "files": one[0]["files"],
               "computing [s]": computing.sum(), "largest [s]": computing.max(),
               "messages": of(["Isend"], 0), "bytes": of(["Isend"], 1),
               "all-reduces": of(["Allreduce"], 0)/ranks,
               "trees": of(["Send", "Bsend"], 0)/max(1, 2*(ranks - 1)),
               "to all": of(["Alltoall", "Alltoallv", "Gatherv", "Scatterv"], 0)/ranks,
               # Of start and end: the run of N steps without N times those of a step
               "lists [bytes]": sum(f[name][1] for f in one for name in lists)
               - n1*of(lists, 1), **overKinds(one, two, n)}
        yield row
        print(f"{scene} {size} on {ranks}: {n} steps, {1e3*computing.sum():.2f} ms computing,"
              f" {row['messages']:.1f} messages, {row['bytes']:.0f} bytes,"
              f" {row['all-reduces']:.2f} all-reduces, {row['trees']:.2f} trees", flush=True)


def main():
    table = os.path.join(RUN, "steps.csv")
    if sys.argv[1:] != ["-model"]:
        os.makedirs(RUN, exist_ok=True)
        made = library()
        print("real-time priority" if realTime() else "no real-time priority")
        scenes = sys.argv[1:] or list(SCENES)
        rows = [r for r in model.read(table) if r["scene"] not in scenes]
        for scene in scenes:
            for size, steps in SCENES[scene][1]:
                rows += measure(scene, size, steps, made)
        with open(table, "w", newline="") as f:
            out = csv.DictWriter(f, list(rows[0]))
            out.writeheader()
            out.writerows(rows)
    model.show(model.read(table))


if __name__ == "__main__":
    main()
