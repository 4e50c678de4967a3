#!/usr/bin/env python3
"""Hard cases: what must hold is that all columns stay finite, that the time step does
not collapse (at least a tenth of the first) and that momentum is exact.

impact     copper on copper at 5 km/s, two bodies in contact
squash     a column between walls is pressed to a tenth of its height, into one cell
lonePoint  one point crosses the mesh and another body's neighbourhood
tinyMass   a point of 1e-12 of its neighbours' mass in the face of an impact
densities  plates of densities 1 and 1e4: the closed form of the interface
nearlyIncompressible  discs of nu 0.499 meet
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (FoamCase, boxMesh, controlDict, noSchemes, runParts, velocityFile,
                      writeField)

FLIP = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}
FMPM = {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2}
BALANCE = {"balance": {"type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
                       "writeControl": "timeStep", "writeInterval": 1}}
SLIP_WALL = {"type": "slip"}


def planeCase(name, phases, regions, size, h, end, numerics=FLIP, contact=None, walls=None,
              maxCo=0.3):
    """2D in a box of size from the origin, cells of h; walls: conditions on x-, x+, y-,
    y+ other than calculated."""
    case = FoamCase("hardCases", name)
    case.write("constant/phaseProperties", {
        "phases": list(phases), **phases, **({"contact": contact} if contact else {})})
    names = {"left": "x-", "right": "x+", "lower": "y-", "upper": "y+"}
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (*size, h), (*(int(round(s/h)) for s in size), 1),
        {**{n: ("patch", (s,)) for n, s in names.items()},
         "frontAndBack": ("empty", ("z-", "z+"))}))
    for p in phases:
        velocityFile(case, p, {**{n: "calculated" for n in names}, **(walls or {}),
                               "frontAndBack": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": regions})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    case.write("system/controlDict", controlDict(end, end, maxCo, functions=BALANCE))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def box(phase, low, high, h, ppc=2, **entries):
    return {"phase": phase, "type": "box", "min": (*low, 0), "max": (*high, h),
            "pointsPerCell": ppc, **entries}


def run(table, case, phases, momentum=True):
    """Run and check what must hold of all; (time, momentum) of each phase."""
    case.change("system/controlDict", "^deltaT ", "reportInterval 1;\ndeltaT ")
    case.run("materialPointFoam", limit=300)
    last = case.times()[-1]
    finite = all(np.all(np.isfinite(case.points(last, p)[c])) for p in phases
                 for c in ("x", "U", "sigma", "V", "m"))
    table.check(f"{case.name}: all columns are finite", finite)
    steps = [float(d) for d in re.findall(r"^(?:Step redone: )?deltaT = (\S+)", case.log(),
                                          re.M)]
    table.row(f"{case.name}: least time step over the first", 1, min(steps)/steps[0], 0.1,
              "atLeast")
    found = {p: case.series("balance", f"{p}.dat") for p in phases}
    if momentum:
        total = sum(f[:, 3:6] for f in found.values())
        size = max(np.linalg.norm(f[:, 3:6], axis=1).max() for f in found.values())
        table.row(f"{case.name}: momentum", 0,
                  np.max(np.linalg.norm(total - total[0], axis=1))/size, 1e-12, "atMost")
    return {p: (f[:, 0], f[:, 2], f[:, 3:6]) for p, f in found.items()}


def impact(table):
    h = 0.5e-3
    copper = {"type": "JohnsonCook", "rho": 8960, "G": 46e9, "A": 90e6, "B": 292e6,
              "n": 0.31, "C": 0.025, "m": 1.09, "referenceRate": 1,
              "referenceTemperature": 294, "meltTemperature": 1356, "cp": 383, "beta": 0.9,
              "equationOfState": {"type": "MieGrueneisen", "C0": 3940, "S": 1.489,
                                  "Gamma0": 2.02},
              "bulkViscosity": {"linear": 0.06, "quadratic": 1.5}}
    for label, numerics in (("FLIP", FLIP), ("FMPM", FMPM)):
        case = planeCase(
            f"impact-{label}", {p: {"constitutiveModel": copper} for p in ("rod", "plate")},
            {"rod": box("rod", (20*h, 32*h), (30*h, 40*h), h, velocity=(5000, 0, 0)),
             "plate": box("plate", (30*h, 16*h), (42*h, 56*h), h)},
            (72*h, 72*h), h, 2e-6, numerics, {"all": {"type": "frictionless"}})
        m = run(table, case, ("rod", "plate"))
        print(f"{case.name}: momentum left in the rod"
              f" {m['rod'][2][-1, 0]/m['rod'][2][0, 0]:.3f}")


def squash(table):
    h, E = 0.1, 1e5
    law = {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": E, "nu": 0.3}}
    end = 1.0
    ram = {"type": "rigid", "rho": 1000, "motion": {
        "type": "translation", "velocity": "table ((0 (0 0 0)) (0.1 (0 -1 0))"
        " (0.9 (0 -1 0)) (1 (0 0 0)) (2 (0 0 0)))"}}
    case = planeCase(
        "squash", {"soft": law, "ram": ram},
        {"soft": box("soft", (0, 0), (2*h, 1), h), "ram": box("ram", (0, 1), (2*h, 1.2), h)},
        (2*h, 1.3), h, end, FLIP, {"face": {"type": "frictionless"}},
        {"left": SLIP_WALL, "right": SLIP_WALL, "lower": SLIP_WALL})
    run(table, case, ("soft",), momentum=False)
    last = case.times()[-1]
    soft = case.points(last, "soft")
    J = soft["V"].sum()/case.points("0", "soft")["V"].sum()
    table.row("squash: height over the first", 0.1, J, 1e-2)
    mu, lame = E/2.6, E*0.3/(1.3*0.4)
    exact = (mu*(J*J - 1) + lame*np.log(J))/J
    print(f"squash: stress over E, mean over the volume"
          f" {(soft['V']*soft['sigma'][:, 3]).sum()/soft['V'].sum()/E:.2f}, closed form at"
          f" this height {exact/E:.2f} (the points' boxes keep their size)")


def lonePoint(table):
    h = 0.1
    law = {"constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0.3}}
    case = planeCase(
        "lonePoint", {"one": law, "body": law},
        {"one": box("one", (0.1, 1.6), (0.2, 1.7), h, 1, velocity=(3, 0.7, 0)),
         "body": box("body", (0.8, 0.5), (1.4, 1.0), h)},
        (3, 3), h, 0.8, FLIP, {"all": {"type": "frictionless"}})
    m = run(table, case, ("one", "body"))
    table.row("lonePoint: largest change of its velocity", 0,
              np.max(abs(m["one"][2]/m["one"][1][:, None] - (3, 0.7, 0))), 1e-12, "atMost")

    # It runs into the body, as a point and nothing beside
    case = planeCase(
        "lonePointHits", {"one": law, "body": law},
        {"one": box("one", (0.2, 0.7), (0.3, 0.8), h, 1, velocity=(3, 0.1, 0)),
         "body": box("body", (0.8, 0.5), (1.4, 1.0), h)},
        (3, 3), h, 0.5, FLIP, {"all": {"type": "frictionless"}})
    m = run(table, case, ("one", "body"))
    table.row("lonePointHits: momentum that the body has got over the point's, at least",
              1, m["body"][2][-1, 0]/m["one"][2][0, 0], 0.9, "atLeast")


def tinyMass(table):
    h = 0.1
    law = {"constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0.3}}
    for label, numerics in (("FLIP", FLIP), ("FMPM", FMPM)):
        case = planeCase(
            f"tinyMass-{label}", {"left": law, "right": law},
            {"left": box("left", (0.5, 0.8), (1.0, 1.2), h, velocity=(1, 0.2, 0)),
             "right": box("right", (1.15, 0.8), (1.65, 1.2), h)},
            (3, 2), h, 0.5, numerics, {"all": {"type": "Coulomb", "mu": 0.3}})
        points = case.points("0", "left")
        x, m, V = points["x"], points["m"].copy(), points["V"].copy()
        tiny = np.argmax(x[:, 0] + 0.1*x[:, 1])     # upper right corner
        m[tiny] *= 1e-12
        V[tiny] *= 1e-12
        writeField(case.file("0/lagrangian/left/m"), m)
        writeField(case.file("0/lagrangian/left/V"), V)
        run(table, case, ("left", "right"))
        speed = np.linalg.norm(case.points(case.times()[-1], "left")["U"], axis=1)
        table.row(f"{case.name}: fastest point over the impact", 1, speed.max(), 5, "atMost")


def densities(table):
    h, L, E, v = 0.05, 1.0, 1e8, 1.0
    laws = {p: {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E, "nu": 0}}
            for p, rho in (("light", 1.0), ("heavy", 1e4))}
    for label, numerics in (("FLIP", FLIP), ("FMPM", FMPM)):
        case = planeCase(
            f"densities-{label}", laws,
            {"light": box("light", (0.5, 0), (1.5, 2*h), h, velocity=(v, 0, 0)),
             "heavy": box("heavy", (1.5, 0), (2.0, 2*h), h)},
            (3, 2*h), h, 1.6*L/np.sqrt(E), numerics, {"all": {"type": "frictionless"}},
            {"lower": SLIP_WALL, "upper": SLIP_WALL})
        m = run(table, case, ("light", "heavy"))
        t, _, p = m["heavy"]
        za, zb = 1e0*np.sqrt(E/1.0), 1e4*np.sqrt(E/1e4)
        force = za*zb/(za + zb)*v*2*h*h
        while_ = (t > 0.2*L/np.sqrt(E)) & (t < 1.5*L/np.sqrt(E))
        table.row(f"{case.name}: force of the interface (closed form) [N]", force,
                  np.polyfit(t[while_], p[while_, 0], 1)[0], 2e-2, "relative")


def nearlyIncompressible(table):
    h = 0.05
    law = {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1000, "nu": 0.499}}
    case = planeCase(
        "nearlyIncompressible", {"a": law, "b": law},
        {p: {"phase": p, "type": "sphere", "centre": (*x, 0.5*h), "radius": 0.2,
             "pointsPerCell": 2, "velocity": v}
         for p, x, v in (("a", (0.4, 0.47), (0.1, 0.1, 0)),
                         ("b", (1.0, 0.93), (-0.1, -0.1, 0)))},
        (1.4, 1.4), h, 3, FLIP, {"all": {"type": "Coulomb", "mu": 0.2}})
    m = run(table, case, "ab")
    n = np.array([0.6, 0.46])/np.hypot(0.6, 0.46)
    table.row("nearlyIncompressible: they part (velocity of one against the other)", 0,
              ((m["b"][2] - m["a"][2])[-1, :2] @ n)/np.linalg.norm(m["a"][2][0]), 0.2,
              "atLeast")
    V = case.points(case.times()[-1], "a")["V"]
    V0 = case.points("0", "a")["V"]
    table.row("nearlyIncompressible: volume of a disc over the first", 1, V.sum()/V0.sum(),
              2e-2)


def main():
    return runParts(
        "hardCases", impact, squash, lonePoint, tinyMass, densities, nearlyIncompressible)


if __name__ == "__main__":
    sys.exit(main())
