#!/usr/bin/env python3
"""Debris and a jet that cross the whole box, with loadBalance and without, by hand:

    tests/cases/loadBalance/crossing.py [number of processors ...]      (default 2 4)

For each: moves, the largest imbalance of the load after a look (as the log has it), the CPU
seconds of all processors with and without, and the largest difference to one processor.
tests/Alltest loadBalance runs the debris on two.
"""

import os
import random
import re
import resource
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from coupledCases import coupledCase
from foamCase import FoamCase, boxMesh, controlDict, noSchemes, velocityFile
from gasCases import WALL

H = 0.0125


def debris(name, ppc=14):
    """Forty blocks of a plate that has broken fly to the right, each with its velocity."""
    case = FoamCase("loadBalance", name)
    n, rng = (96, 24, 1), random.Random(5)
    case.write("constant/phaseProperties", {"phases": ["debris"], "debris": {
        "constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1e6, "nu": 0.3}}})
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), [H*c for c in n], n,
        {"walls": ("patch", ("x-", "x+", "y-", "y+")), "sides": ("empty", ("z-", "z+"))}))
    velocityFile(case, "debris", {"walls": "slip", "sides": "empty"})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0}})
    noSchemes(case)
    case.write("system/controlDict", controlDict(0.034, 0.034, maxCo=0.4))
    case.write("system/setMaterialPointsDict", {"regions": {
        f"b{i}": {"phase": "debris", "type": "box", "pointsPerCell": ppc,
                  "min": (H*(2 + 2*(i % 4)), H*(2 + 2*(i//4)), -1),
                  "max": (H*(4 + 2*(i % 4)), H*(4 + 2*(i//4)), 1),
                  "velocity": (24 + 2*(i % 4) + rng.uniform(-1, 1), rng.uniform(-2, 2), 0)}
        for i in range(40)}})
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def jet(name, ppc=8):
    """A soft jet, whose tip is faster than its end, in a gas at rest."""
    case = coupledCase(
        "loadBalance", name, (96, 24, 1), (1.2, 0.3, H), lambda x, y, z: (1 + 0*x, 0*x, 1 + 0*x),
        0.8, {"jet": {"constitutiveModel": {"type": "neoHookean", "rho": 100, "E": 400,
                                            "nu": 0.3}}},
        {f"j{i}": {"phase": "jet", "type": "box", "min": (0.05 + 4*i*H, 0.1, -1),
                   "max": (0.05 + 4*(i + 1)*H, 0.175, 1), "velocity": (1 + 0.04*i, 0, 0),
                   "pointsPerCell": ppc} for i in range(5)},
        ends=WALL, sides=WALL)
    return case


def after(case):
    """Imbalance after each look that the log tells of."""
    found = re.findall(r"^Load: imbalance ([\d.]+), by \w+ ([\d.]+)(, left)?", case.log(), re.M)
    return [float(a if left else b) for a, b, left in found]


def cpu(run):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run()
    now = resource.getrusage(resource.RUSAGE_CHILDREN)
    return now.ru_utime + now.ru_stime - before.ru_utime - before.ru_stime


def main():
    import test as of
    for make, phase in ((debris, "debris"), (jet, "jet")):
        # Runs of their own: a copy of a case that has run has its results
        one, fresh = make(phase), make(phase + "-fresh")
        one.run("materialPointFoam", limit=900)
        for n in [int(a) for a in sys.argv[1:]] or [2, 4]:
            seconds = {}
            for label, entries in (("without", {"maxImbalance": 1e9}),
                                   ("every", {"maxImbalance": 1.1, "worth": 0}),
                                   ("paying", {"maxImbalance": 1.1})):
                case = of.balanced(fresh, 25, (n, 1, 1), f"{label}{n}", **entries)
                seconds[label] = cpu(lambda c=case: c.runParallel(limit=900))
                worst = one.largestDifference(case, one.times()[-1], [phase], ("x", "U", "V"))
                looks = after(case)
                print(f"{phase}, {n} processors, {label}: {case.nSteps()} steps,"
                      f" {of.moves(case)} moves, imbalance after looks"
                      f" {max(looks) if looks else 'not told'},"
                      f" {seconds[label]:.2f} s of CPU"
                      f" ({100*(seconds[label]/seconds['without'] - 1):+.1f} %), difference to one"
                      f" {worst:.2g}", flush=True)


if __name__ == "__main__":
    main()
