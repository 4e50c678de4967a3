#!/usr/bin/env python3
"""Points and a gas on cells of any kind (solidFraction star).

A box of prisms, moved hexahedra (one layer with empty sides) or tetrahedra, as in
anyMesh; points with node-dual functions.

    translation   a disc and a turned block move with the gas at 100 m/s across the
                  mesh: pressure of every step within 1e-11, momentum 1e-12
    rest          a block in still gas between walls: velocities 1e-11 m/s
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from blockInGas import EXTREMES, P0, R, figures, gasFields, gasSchemes
from cellMesh import boxOfCells
from foamCase import FoamCase, VERIFY, controlDict, runParts, velocityFile
from surfaces import prisms, surfaceRegion

H, E, RHO = 1e-4, 70e9, 2700.0
WAVE = np.sqrt(E/RHO)
FLIP = {"shapeFunction": "nodeDual", "transfer": "FLIP", "PICfraction": 0.01}
DISC, BLOCK, BALL = "disc", "block at 30 degrees", "ball"


def region(case, body, n):
    """Region of setMaterialPointsDict around the middle of n cells."""
    c = 0.5*H*np.array(n)
    if body == DISC:
        return {"type": "cylinder", "point1": [c[0], c[1], -1], "point2": [c[0], c[1], 1],
                "radius": 6.2*H}
    if body == BALL:
        return {"type": "sphere", "centre": c, "radius": 2.6*H}
    if body == BLOCK:
        s, co = 5.1*np.sin(np.pi/6), 5.1*np.cos(np.pi/6)
        corners = [c[:2] + H*np.array([co*i - s*j, s*i + co*j])
                   for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        prisms(case, "turned.stl", [corners])
        return surfaceRegion("turned.stl")
    return body


def bodyInGas(name, kind, n, body, velocity, steps, walls=False, moved=0.2, Co=0.4,
              numerics=FLIP, gas=None, phase=None, reports=20, points=2, **fields):
    case = FoamCase("gasAnyMesh", name.replace(" ", "-").replace(",", ""))
    case.write("constant/phaseProperties", {
        "phases": ["air", "block"],
        "air": {"type": "gas", "thermo": "perfectGas", "R": R, "gamma": 1.4, **(gas or {})},
        "block": {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E,
                                        "nu": 0}, **(phase or {})}})
    flat = n[2] == 1
    sides = ("x-", "x+", "y-", "y+") + (() if flat else ("z-", "z+"))
    patches = {"outside": ("wall" if walls else "patch", sides)}
    conditions = {"outside": "slip"}
    if flat:
        patches["sides"] = ("empty", ("z-", "z+"))
        conditions["sides"] = "empty"
    boxOfCells(case, kind, (0, 0, 0), H*np.array(n), n, patches, moved=moved)
    velocityFile(case, "block", {k: "calculated" if v == "slip" and not walls else v
                                 for k, v in conditions.items()})
    gasFields(case, conditions, velocity, **fields)
    if not walls:
        case.change("0/U.air", "type slip;", "type fixedValue; value $internalField;")
    gasSchemes(case)
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", **region(case, body, n), "pointsPerCell": points,
        "velocity": velocity, "stress": "ambient", "pressure": P0}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    dt = Co*H/(WAVE + np.max(np.abs(velocity)))
    case.write("system/controlDict", {
        **controlDict(steps*dt, steps*dt, deltaT=dt, functions=EXTREMES),
        "reportInterval": max(1, steps//reports)})
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=300)
    return case


TRANSLATIONS = (("prisms", (36, 34, 1), DISC), ("prisms", (36, 34, 1), BLOCK),
                ("hexes", (36, 34, 1), DISC), ("hexes", (36, 34, 1), BLOCK),
                ("tets", (12, 11, 10), BALL))


def translation(table):
    crossings = 20 if VERIFY else 4
    for kind, n, body in TRANSLATIONS:
        v = np.array((80.0, 60.0, 0.0 if n[2] == 1 else -30.0))
        dt = 0.4*H/(WAVE + np.max(np.abs(v)))
        case = bodyInGas(f"translation {kind} {body}", kind, n, body, v,
                         int(crossings*H/(dt*np.linalg.norm(v))))
        f = figures(case)
        label = f"translation, {kind}, {body}, {crossings} cells"
        table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-11, "atMost")
        m = f["momentum"]
        table.row(f"{label}: momentum of the points", 0,
                  np.max(abs(m - m[0]))/np.max(abs(m[0])), 1e-12, "atMost")
        table.row(f"{label}: fix-ups", 0, np.sum(f["fixups"][-1]), 0, "atMost")
        print("Theta", f["Theta"].min(), f["Theta"].max())


def rest(table):
    for kind, n in (("prisms", (20, 18, 1)), ("hexes", (20, 18, 1)), ("tets", (8, 8, 8))):
        case = bodyInGas(
            f"rest {kind}", kind, n,
            {"type": "box", "min": (0, 3*H, -1 if n[2] == 1 else 2*H),
             "max": (0.5*n[0]*H, 0.6*n[1]*H, 1 if n[2] == 1 else 5*H)},
            (0, 0, 0), 10000 if VERIFY else 500, walls=True)
        f = figures(case)
        u = np.max(abs(case.points(case.times()[-1], "block")["U"]))
        label = f"rest, {kind}, {case.nSteps()} steps"
        table.row(f"{label}: velocity of points", 0, u, 1e-11, "atMost")
        table.row(f"{label}: velocity of the gas", 0, np.max(f["speed"]), 1e-11, "atMost")
        table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-13, "atMost")


if __name__ == "__main__":
    sys.exit(runParts("gasAnyMesh", translation, rest))
