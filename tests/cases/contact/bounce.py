"""Elastic bodies that fall on a rigid floor: contact gives no energy."""

import itertools
import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import FoamCase, boxMesh, controlDict, noSchemes, velocityFile
from surfaces import surfaceRegion, writeTriangles

H, A, G = 1e-3, 6e-3, 9.81
FALL = 2e-3

RUNS = {"GIMP, FLIP": {"shapeFunction": "GIMP", "transfer": "FLIP"},
        "GIMP, FLIP, USAVG": {"shapeFunction": "GIMP", "transfer": "FLIP",
                              "stressUpdate": "USAVG"},
        "GIMP, FMPM 2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2},
        "cubicBSpline, FLIP": {"shapeFunction": "cubicBSpline", "transfer": "FLIP"},
        "nodeDual, FLIP": {"shapeFunction": "nodeDual", "transfer": "FLIP"}}


def octahedron(name, numerics, end=35e-3, writeInterval=None):
    """An octahedron of 12 cells between opposite corners falls on one of them."""
    case = FoamCase("contact", "bounce-" + name.replace(" ", "").replace(",", "-"))
    top = A + FALL
    case.write("constant/phaseProperties", {
        "phases": ["body"],
        "body": {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1e5,
                                       "nu": 0.3}},
        "contact": {"floor": {"fields": "(body)", "patch": "floor", "type": "frictionless"}}})
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, 0, -G)})
    case.write("system/blockMeshDict", boxMesh(
        (-10*H, -10*H, 0), (10*H, 10*H, 20*H), (20, 20, 20),
        {"floor": ("patch", ("z-",)), "others": ("patch", ("x-", "x+", "y-", "y+", "z+"))}))
    velocityFile(case, "body", {"floor": "calculated", "others": "calculated"})
    corners = [[s*A*(i == k) for i in range(3)] for k in range(3) for s in (1, -1)]
    triangles = []
    for x, y, z in itertools.product((0, 1), (2, 3), (4, 5)):
        a, b, c = (tuple(np.array(corners[i]) + (0, 0, top)) for i in (x, y, z))
        triangles.append((a, b, c) if (x + y + z) % 2 == 0 else (a, c, b))
    writeTriangles(case, "octahedron.stl", triangles)
    case.write("system/setMaterialPointsDict", {"regions": {"body": {
        "phase": "body", **surfaceRegion("octahedron.stl"), "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    control = controlDict(end, writeInterval or end, 0.4, functions={"balance": {
        "type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
        "writeControl": "timeStep", "writeInterval": 1}})
    case.write("system/controlDict", {**control, "startFrom": "latestTime"})
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def rebound(case):
    record = case.series("balance", "body.dat")
    v = record[:, 5]/record[:, 2]
    first = v.argmin()
    return -v[first:].max()/v[first]


def bounce(table):
    for name, numerics in RUNS.items():
        case = octahedron(name, {**numerics, "energyBudget": "yes"})
        case.run("materialPointFoam", limit=200)
        speed = rebound(case)
        table.check(f"octahedron on its tip, {name}: no energy that grows",
                    "Energy has grown" not in case.log())
        label = f"octahedron on its tip, {name}: speed after over that before"
        table.row(label, 1, speed, 1, "atMost")
        # Half of the energy; one that slip on the floor holds gets 0.95 to 0.99 of its speed
        table.row(f"{label}, at least", 1, speed, np.sqrt(0.5), "atLeast")

    # USAVG begins a step with what the last one has closed
    straight, again = (octahedron(f"restart {i}", RUNS["GIMP, FLIP, USAVG"], 25.2e-3, 2.4e-3)
                       for i in (1, 2))
    straight.run("materialPointFoam", limit=200)
    times = straight.times()
    shutil.copytree(straight.file(times[-2]), again.file(times[-2]))
    again.run("materialPointFoam", limit=200)
    table.check("octahedron: it presses at the restart",
                "pressed0" in open(straight.file(times[-2], "uniform", "materialPointState"))
                .read())
    table.row("octahedron, USAVG: restart in contact, largest difference", 0,
              straight.largestDifference(again, times[-1], ("body",), ("x", "U", "sigma")), 0,
              "atMost")
