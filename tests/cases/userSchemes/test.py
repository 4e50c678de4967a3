#!/usr/bin/env python3
"""Transfer schemes, a stress update and a shape function of a user's library (four of
etc/codeTemplates), loaded with libs and selected by name.

    compiles    wmake outside the tree of the project, without a warning
    falling     a block falls freely, N steps of dt from rest: points of FLIP move with
                u^L, x = g dt^2 N (N + 1)/2; of the user's midpoint with the mean of u^n
                and u^L, x = g (N dt)^2/2. Both to rounding (1e-12 of the way)
    crash       two halves of a block run against each other: the user's PIC is FLIP with
                PICfraction 1 and his fullStepAtL is USL bit by bit; FLIP with 0 and MUSL
                are not (the velocity differs by more than 1e-3)
    stencil     the same crash with the user's nodewiseLinear, whose number of nodes is known
                at run time only: linear to rounding (1e-12 of the largest value after 60
                steps), with FLIP and APIC; GIMP is not (1e-3)
    choices     an unknown transfer, stressUpdate and shapeFunction: the error names the
                user's among the valid ones; an entry of FLIP belongs to midpoint too
"""

import os
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from foamCase import FoamCase, boxMesh, controlDict, noSchemes, runParts, velocityFile
from templates import SCHEMES, compileTemplates

H, G, N, DT = 0.01, -10.0, 40, 1e-3
COLUMNS = ["x", "U", "sigma", "V"]


def makeCase(name, numerics, steps, dt, crash):
    case = FoamCase("userSchemes", name)
    case.write("constant/phaseProperties", {
        "phases": ["block"],
        "block": {"constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 1e4,
                                        "nu": 0.3}}})
    if not crash:
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]",
                                  "value": f"(0 {G} 0)"}, "uniformDimensionedVectorField")
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (0.1, 0.1, H), (10, 10, 1),
        {"outside": ("patch", ("x-", "x+", "y-", "y+")), "sides": ("empty", ("z-", "z+"))}))
    velocityFile(case, "block", {"outside": "calculated", "sides": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {
        side: {"phase": "block", "type": "box", "min": (x, 0.05, 0),
               "max": (x + 2*H, 0.09, H), "pointsPerCell": 2,
               "velocity": (u*crash, 0.3*u*crash, 0)}
        for side, x, u in (("left", 0.03, 1), ("right", 0.05, -1))}})
    case.write("system/fvSolution", {"materialPoints": {"shapeFunction": "GIMP", **numerics}})
    noSchemes(case)
    case.write("system/controlDict", {
        "libs": '("../library/libuserSchemes.so")',
        **controlDict(steps*dt, steps*dt, deltaT=dt)})
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def compiles(table):
    case = compileTemplates("userSchemes", SCHEMES, "userSchemes")
    table.check("a user's schemes compile without warning",
                "warning:" not in case.log("wmake"))


def falling(table):
    for transfer, way in (("FLIP", G*DT**2*N*(N + 1)/2), ("midpoint", G*(N*DT)**2/2)):
        case = makeCase("falling" + transfer, {"transfer": transfer}, N, DT, False)
        case.run("materialPointFoam")
        first, last = case.points("0", "block"), case.points(case.times()[-1], "block")
        fall = last.byId("x")[:, 1] - first.byId("x")[:, 1]
        table.row(f"{transfer}: way of a falling point [m]", way, np.mean(fall), 1e-12*abs(way))
        table.row(f"{transfer}: spread of the ways over the way", 0,
                  np.ptp(fall)/abs(way), 1e-12)


def crash(table):
    cases = {}
    for name, numerics in {
            "PIC": {"transfer": "PIC"},
            "FLIP1": {"transfer": "FLIP", "PICfraction": 1},
            "MUSL": {"transfer": "FLIP"},
            "fullStepAtL": {"transfer": "FLIP", "stressUpdate": "fullStepAtL"},
            "USL": {"transfer": "FLIP", "stressUpdate": "USL"}}.items():
        cases[name] = makeCase("crash" + name, numerics, 60, 2e-4, True)
        cases[name].run("materialPointFoam")

    def difference(a, b):
        time = cases[a].times()[-1]
        return cases[a].largestDifference(cases[b], time, ["block"], COLUMNS)

    table.row("PIC of the user against FLIP with PICfraction 1", 0,
              difference("PIC", "FLIP1"), 0)
    table.row("PIC against FLIP", 1e-3, difference("PIC", "MUSL"), 1e-3, "atLeast")
    table.row("fullStepAtL of the user against USL", 0, difference("fullStepAtL", "USL"), 0)
    table.row("fullStepAtL against MUSL", 1e-3, difference("fullStepAtL", "MUSL"), 1e-3,
              "atLeast")


def stencil(table):
    for transfer in ("FLIP", "APIC"):
        cases = {}
        for shape in ("linear", "nodewiseLinear", "GIMP"):
            cases[shape] = makeCase(transfer + shape, {
                "transfer": transfer, "shapeFunction": shape}, 60, 2e-4, True)
            cases[shape].run("materialPointFoam")
        time = cases["linear"].times()[-1]

        def difference(shape):
            return cases["linear"].largestDifference(cases[shape], time, ["block"], COLUMNS)

        table.row(f"{transfer}: nodewiseLinear of the user against linear", 0,
                  difference("nodewiseLinear"), 1e-12)
        table.row(f"{transfer}: GIMP against linear", 1e-3, difference("GIMP"), 1e-3, "atLeast")


def choices(table):
    for label, numerics, words in (
            ("transfer", {"transfer": "PIC9"}, ("PIC9", "APIC", "FLIP", "PIC", "midpoint")),
            ("stressUpdate", {"transfer": "FLIP", "stressUpdate": "best"},
             ("best", "MUSL", "fullStepAtL")),
            ("shapeFunction", {"transfer": "FLIP", "shapeFunction": "tnt"},
             ("tnt", "GIMP", "linear", "nodewiseLinear")),
            ("entry", {"transfer": "PIC", "PICfraction": 0.1},
             ("PICfraction belongs to transfer FLIP or midpoint, not to PIC",))):
        case = makeCase("choices" + label, numerics, 1, DT, False)
        case.run("materialPointFoam", fails=True)
        log = case.log().replace("\n", " ")
        error = log[log.find("FATAL IO ERROR"):]
        table.check(f"unknown {label}: the error names all", all(w in error for w in words),
                    " ".join(error.split())[:200])


if __name__ == "__main__":
    sys.exit(runParts("userSchemes", compiles, falling, crash, stencil, choices))
