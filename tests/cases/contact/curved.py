"""A disc slides without friction in a bowl and over a hump: a patch with curved faces."""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import FoamCase, controlDict, noSchemes, velocityFile

#: Radii of hump and bowl, thickness, radius of the disc, cells along a quarter and across
HUMP, BOWL, THICK, A, CELLS = 0.6, 1.0, 0.02, 0.08, (60, 20, 1)
G = 9.81


def ring():
    """blockMeshDict of the lower half of a ring."""
    vertices, edges, blocks = [], [], []
    for z in (0, THICK):
        for degrees in (180, 270, 360):
            vertices += [(r*np.cos(np.radians(degrees)), r*np.sin(np.radians(degrees)), z)
                         for r in (BOWL, HUMP)]
    for k, z in enumerate((0, THICK)):
        for i, degrees in enumerate((225, 315)):
            for j, r in enumerate((BOWL, HUMP)):
                at = 6*k + 2*i + j
                edges.append(f"arc {at} {at + 2} ({r*np.cos(np.radians(degrees))}"
                             f" {r*np.sin(np.radians(degrees))} {z})")
    for i in (0, 2):
        blocks.append("hex ({} {} {} {} {} {} {} {})".format(
            *(k + i + v for k in (0, 6) for v in (0, 2, 3, 1)))
            + " ({} {} {}) simpleGrading (1 1 1)".format(*CELLS))
    sides = {"bowl": "wall; faces ((0 2 8 6) (2 4 10 8))",
             "hump": "wall; faces ((1 3 9 7) (3 5 11 9))",
             "ends": "patch; faces ((0 1 7 6) (4 5 11 10))",
             "flat": "empty; faces ((0 2 3 1) (2 4 5 3) (6 8 9 7) (8 10 11 9))"}
    return {"scale": 1, "vertices": vertices, "edges": "(" + " ".join(edges) + ")",
            "blocks": "(" + " ".join(blocks) + ")",
            "boundary": "(" + " ".join(f"{n} {{ type {s}; }}" for n, s in sides.items()) + ")"}


def slide(patch, length, degrees, g, end, transfer):
    """Time, angle from the vertical, distance from the centre, kinetic and all energy per
    mass."""
    case = FoamCase("contact", f"curved-{patch}-{transfer['transfer']}")
    case.write("system/blockMeshDict", ring())
    case.write("constant/phaseProperties", {
        "phases": ["disc"],
        "disc": {"constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 1e7,
                                       "nu": 0.3}},
        "contact": {"floor": {"fields": "(disc)", "patch": patch, "type": "frictionless"}}})
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, g, 0)})
    velocityFile(case, "disc", {"bowl": "calculated", "hump": "calculated",
                                "ends": "calculated", "flat": "empty"})
    start = np.radians(degrees)
    case.write("system/setMaterialPointsDict", {"regions": {"disc": {
        "phase": "disc", "type": "sphere", "radius": A, "pointsPerCell": 2,
        "centre": (length*np.sin(start), -length*np.cos(start), THICK/2)}}})
    case.write("system/fvSolution", {"materialPoints": transfer})
    noSchemes(case)
    each = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 10}
    case.write("system/controlDict", controlDict(end, end, 0.4, functions={
        "balance": {"type": "materialPointBalance", **each},
        "extent": {"type": "materialPointExtent", **each}}))
    for program in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
        case.run(program)
    extent, balance = case.series("extent", "disc.dat"), case.series("balance", "disc.dat")
    x, y = extent[:, 7], extent[:, 8]
    kinetic = balance[:, 9]/balance[0, 2]
    return (extent[:, 0], np.degrees(np.arctan2(x, -y)), np.hypot(x, y), kinetic,
            kinetic - g*y)


def fall(length, degrees, g, times):
    """Angle of a point mass on a circle, by small steps."""
    angle, rate, t, dt, found = np.radians(degrees), 0.0, 0.0, 1e-5, []
    while t <= times[-1] + dt:
        found.append((t, angle))
        rate += g/length*np.sin(angle)*dt
        angle += rate*dt
        t += dt
    found = np.array(found)
    return np.degrees(np.interp(times, *found.T))


def curved(table):
    for patch, length, degrees, g, end in (("bowl", BOWL - A, -60, -G, 1.2),
                                           ("hump", HUMP + A, 15, G, 0.42)):
        for transfer in ({"transfer": "APIC"}, {"transfer": "FLIP"}):
            t, angle, r, kinetic, energy = slide(patch, length, degrees, g, end, transfer)
            label = f"disc slides on a {patch}, {transfer['transfer']}"
            table.row(f"{label}: angle, error [degrees]", 0,
                      np.max(abs(angle - fall(length, degrees, g, t))), 1, "atMost")
            table.row(f"{label}: way off the circle [cells]", 0, np.max(abs(r - length))/0.02,
                      0.1, "atMost")
            table.row(f"{label}: change of energy over the largest kinetic", 0,
                      np.max(abs(energy - energy[0]))/np.max(kinetic), 0.02, "atMost")
