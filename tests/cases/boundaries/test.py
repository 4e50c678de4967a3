#!/usr/bin/env python3
"""Sides of the mesh: cyclic, slip, moving; points exactly on sides of cells.

cyclic      a free block crosses cyclic sides, on a lattice (GIMP) and on a
            sheared mesh (linear), also landing on them to rounding: velocity,
            energy and momentum as in free space
side        points that land exactly on a side of a cell (linear): the same
slip        a column under gravity between slip walls is in uniaxial strain, no
            shear, whether the walls are one patch with edges or several
moving      a wall with a velocity over time: the nodes have that of the end of
            the step
functions   function objects run once per step
edges       a block slides between slip walls from a taper through a barrel into a room, past
            edges of the wall of 27 and 90 degrees, of one patch or several: velocity and
            way of free space within 1 % (FMPM, XPIC 3 %); pressed outwards it stays in the barrel
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (FoamCase, RunFailed, boxMesh, controlDict, noSchemes, readField,
                      velocityFile)
from report import Report

H = 0.01
LAW = {"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0.3}
C = np.sqrt(1e6*0.7/(1.3*0.4)/1000)
BALANCE = {"balance": {"type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
                       "writeControl": "timeStep", "writeInterval": 1}}


def build(name, cells, patches, conditions, region, numerics, control, shear=0.0,
          neighbours=None, gravity=None):
    case = FoamCase("boundaries", name.replace(",", "").replace(" ", "-"))
    size = [H*n for n in cells]
    mesh = boxMesh((0, 0, 0), size, cells, patches)
    mesh["vertices"] = [(x + shear*y, y, z) for x, y, z in mesh["vertices"]]
    for patch, other in (neighbours or {}).items():
        mesh["boundary"] = mesh["boundary"].replace(
            f"{patch} {{ type cyclic;",
            f"{patch} {{ type cyclic; neighbourPatch {other};")
    case.write("system/blockMeshDict", mesh)
    case.write("constant/phaseProperties",
               {"phases": ["block"], "block": {"constitutiveModel": LAW}})
    velocityFile(case, "block", conditions)
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "pointsPerCell": 2, **region}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    case.write("system/controlDict", control)
    if gravity:
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]",
                                  "value": gravity}, "uniformDimensionedVectorField")
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def translation(table, name, shape, transfer, shear, velocity, courant):
    """Errors of a block that moves through cyclic sides without any force;
    courant: cells travelled per step along x (or y if it does not move in x)."""
    v = np.array(velocity + (0,))*C
    fastest = next(abs(u) for u in v if u)
    dt = courant*H/fastest
    region = ({"type": "cells"} if shear else
              {"type": "box", "min": (3*H, 3*H, 0), "max": (6*H, 6*H, H)})
    case = build(
        name, (8, 6, 1),
        {"xlo": ("cyclic", ("x-",)), "xhi": ("cyclic", ("x+",)),
         "ylo": ("cyclic", ("y-",)), "yhi": ("cyclic", ("y+",)),
         "frontAndBack": ("empty", ("z-", "z+"))},
        {p: "cyclic" for p in ("xlo", "xhi", "ylo", "yhi")} | {"frontAndBack": "empty"},
        {**region, "velocity": tuple(v)}, {"shapeFunction": shape, **transfer},
        controlDict(300*dt, 300*dt, deltaT=dt, functions=BALANCE), shear,
        {"xlo": "xhi", "xhi": "xlo", "ylo": "yhi", "yhi": "ylo"})
    case.run("materialPointFoam")
    record = case.series("balance", "block.dat")
    points = case.points(case.times()[-1], "block")
    error = max(np.abs(points["U"] - v).max()/np.linalg.norm(v),
                np.abs(record[:, 11]/record[0, 11] - 1).max(),
                np.abs(record[:, 3:6] - record[0, 3:6]).max()
                / np.linalg.norm(record[0, 3:6]))
    table.row(f"{name}: largest relative error of u, E, P", 0, error, 1e-12)
    return record


def column(table, onePatch):
    """Vertical stress at half a period of the suddenly loaded column: twice the
    static one, -2 rho g (top - y); and shear."""
    n, g = 10, 20.0
    if onePatch:
        patches = {"walls": ("wall", ("y-", "x-", "x+")), "top": ("patch", ("y+",))}
    else:
        patches = {"walls": ("wall", ("y-",)), "left": ("wall", ("x-",)),
                   "right": ("wall", ("x+",)), "top": ("patch", ("y+",))}
    patches["frontAndBack"] = ("empty", ("z-", "z+"))
    conditions = {p: "slip" for p in patches}
    conditions.update({"top": "calculated", "frontAndBack": "empty"})
    period = 4*n*H/C
    case = build(
        f"column-{'one' if onePatch else 'three'}", (2, n + 2, 1), patches, conditions,
        {"type": "box", "min": (0, 0, 0), "max": (2*H, n*H, H)},
        {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0},
        controlDict(period/2, period/2, maxCo=0.4), gravity=(0, -g, 0))
    case.run("materialPointFoam")
    y = case.points("0", "block").byId("x")[:, 1]
    sigma = case.points(case.times()[-1], "block").byId("sigma")
    exact = -2*1000*g*(n*H - y)
    size = np.abs(exact).max()
    label = "one slip patch" if onePatch else "three slip patches"
    table.row(f"{label}: stress at half a period / twice static", 0,
              np.abs(sigma[:, 3] - exact).max()/size, 0.06)
    table.row(f"{label}: shear stress", 0, np.abs(sigma[:, 1]).max()/size, 1e-12)


def nodeVelocities(case):
    """Of the block at the last time."""
    with open(case.file(case.times()[-1], "U.block"), "rb") as f:
        raw = f.read()
    start = raw.index(b"(", raw.index(b"internalField"))
    count = int(raw[:start].split()[-1])
    return np.frombuffer(raw, "f8", 3*count, start + 1).reshape(-1, 3)


def movingWall(table):
    """Wall velocity 100 t: after the last step its nodes have 100 t_end."""
    case = build(
        "moving", (6, 6, 1),
        {"ground": ("wall", ("y-",)), "outside": ("patch", ("x-", "x+", "y+")),
         "frontAndBack": ("empty", ("z-", "z+"))},
        {"ground": {"type": "timeVaryingUniformFixedValue", "file": '"table"',
                    "outOfBounds": "clamp", "value": "uniform (0 0 0)"},
         "outside": "calculated", "frontAndBack": "empty"},
        {"type": "box", "min": (H, 0, 0), "max": (4*H, 3*H, H)},
        {"shapeFunction": "GIMP", "transfer": "FLIP"},
        controlDict(20*5e-5, 20*5e-5, deltaT=5e-5))
    with open(case.file("table"), "w") as f:
        f.write("((0 (0 0 0)) (1 (0 100 0)))\n")
    case.run("materialPointFoam")
    values = nodeVelocities(case)
    end = float(case.times()[-1])
    table.row("moving wall: node velocity at the end", 100*end, values[:, 1].max(),
              1e-9, "relative")


def gun(name, onePatch, block, contact=None, deep=0, **numerics):
    """A block of 3 x 3 cells at the begin of a barrel of 8 x 3, with a taper of 4 behind it and
    a room of 6 x 9 before it. deep: cells between slip walls in 3D."""
    case = FoamCase("boundaries", name)
    corners = [(-4, -2), (0, 0), (8, 0), (14, 0), (14, 3), (8, 3), (0, 3), (-4, 5),
               (8, -3), (14, -3), (14, 6), (8, 6)]
    blocks = [((0, 1, 6, 7), (4, 6)), ((1, 2, 5, 6), (8, 6)), ((2, 3, 4, 5), (6, 6)),
              ((8, 9, 3, 2), (6, 3)), ((5, 4, 10, 11), (6, 3))]
    n = len(corners)
    face = "({0} {1} {2} {3})".format
    sides = {"breech": [(0, 7)], "taper": [(0, 1), (6, 7)], "barrel": [(1, 2), (5, 6)],
             "muzzle": [(2, 8), (5, 11)],
             "room": [(8, 9), (9, 3), (3, 4), (4, 10), (10, 11)]}
    patches = {"walls": sides["taper"] + sides["barrel"] + sides["muzzle"],
               "breech": sides["breech"], "room": sides["room"]} if onePatch else sides
    text = " ".join(
        f"{p} {{ type patch; faces ({' '.join(face(a, b, b + n, a + n) for a, b in of)}); }}"
        for p, of in patches.items())
    flat = " ".join(face(*c) + " " + face(*(i + n for i in c)) for c, _ in blocks)
    case.write("system/blockMeshDict", {
        "scale": H, "vertices": [(*c, z) for z in (0, deep or 1) for c in corners],
        "blocks": "(" + " ".join(
            f"hex ({' '.join(map(str, c))} {' '.join(str(i + n) for i in c)}) "
            f"({i} {j} {deep or 1})"
            " simpleGrading (1 1 1)" for c, (i, j) in blocks) + ")",
        "boundary": f"({text} frontAndBack {{ type {'patch' if deep else 'empty'};"
                    f" faces ({flat}); }})"})
    case.write("constant/phaseProperties", {
        "phases": ["block"], "block": {"constitutiveModel": LAW},
        **({"contact": {p: {"fields": "(block)", "patch": p, "type": "frictionless"}
                        for p in contact}} if contact else {})})
    free = ("breech", "room", *(contact or ()))
    velocityFile(case, "block", {p: "calculated" if p in free else "slip" for p in patches}
                 | {"frontAndBack": "slip" if deep else "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "min": (0, 0, 0), "max": (3*H, 3*H, (deep or 1)*H),
        "pointsPerCell": 2, **block}}})
    case.write("system/fvSolution", {"materialPoints": {"shapeFunction": "nodeDual",
                                                        **numerics}})
    noSchemes(case)
    end = 8*H/(0.1*C)
    case.write("system/controlDict", controlDict(end, end/4, maxCo=0.4, functions=BALANCE))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam")
    return case


def symmetry(table):
    """Half a barrel one cell wide: the symmetry plane holds beside the edge at its end, too."""
    case = FoamCase("boundaries", "edges-symmetry")
    corners = [(0, 0), (6, 0), (12, 0), (12, 1), (6, 1), (0, 1), (6, 4), (12, 4)]
    blocks = [((0, 1, 4, 5), (6, 1)), ((1, 2, 3, 4), (6, 1)), ((4, 3, 7, 6), (6, 3))]
    face = "({0} {1} {2} {3})".format
    sides = {"plane": ("symmetryPlane", [(0, 1), (1, 2)]), "walls": ("patch", [(5, 4), (4, 6)]),
             "room": ("patch", [(0, 5), (2, 3), (3, 7), (6, 7)])}
    text = " ".join(
        f"{p} {{ type {kind}; faces ({' '.join(face(a, b, b + 8, a + 8) for a, b in of)}); }}"
        for p, (kind, of) in sides.items())
    flat = " ".join(face(*c) + " " + face(*(i + 8 for i in c)) for c, _ in blocks)
    case.write("system/blockMeshDict", {
        "scale": H, "vertices": [(*c, z) for z in (0, 1) for c in corners],
        "blocks": "(" + " ".join(
            f"hex ({' '.join(map(str, c))} {' '.join(str(i + 8) for i in c)}) ({i} {j} 1)"
            " simpleGrading (1 1 1)" for c, (i, j) in blocks) + ")",
        "boundary": f"({text} frontAndBack {{ type empty; faces ({flat}); }})"})
    case.write("constant/phaseProperties", {"phases": ["block"],
                                            "block": {"constitutiveModel": LAW}})
    velocityFile(case, "block", {"plane": "symmetryPlane", "walls": "slip", "room": "calculated",
                                 "frontAndBack": "empty"})
    # Its upper half moves up: without the plane the lower one would follow
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "min": (4*H, 0, 0), "max": (8*H, H, H),
        "pointsPerCell": 2, "velocity": (0, 0.01*C, 0)}}})
    case.write("system/fvSolution", {"materialPoints": {"shapeFunction": "nodeDual",
                                                        "transfer": "FLIP"}})
    noSchemes(case)
    end = 2*H/C
    case.write("system/controlDict", controlDict(end, end, maxCo=0.4, functions=BALANCE))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam")
    u = nodeVelocities(case)
    y = readField(case.file("constant/polyMesh/points"))[:, 1]
    table.check("edges: nodes of the body move", np.abs(u[:, 1]).max() > 1e-4*C,
                np.abs(u[:, 1]).max())
    table.row("edges: velocity across a symmetry plane [m/s]", 0,
              np.abs(u[y < 1e-9, 1]).max(), 0)


def edges(table):
    v = 0.1*C
    for name, numerics in (("FLIP", {"transfer": "FLIP"}), ("FMPM", {"transfer": "FMPM"}),
                           ("XPIC", {"transfer": "XPIC", "order": 3})):
        for onePatch in (True, False):
            what = f"edges of {'one patch' if onePatch else 'several patches'}, {name}"
            case = gun(what.replace(",", "").replace(" ", "-"), onePatch,
                       {"velocity": (v, 0, 0)}, **numerics)
            points = case.points(case.times()[-1], "block")
            # nodeDual reaches a cell beyond the edges: at the start nodes of the taper hold it,
            # and transfers that filter do not give that back
            limit = 0.01 if name == "FLIP" else 0.03
            table.row(f"{what}: way of the block [cells]", 8, points["x"][:, 0].mean()/H - 1.5,
                      limit, "relative")
            table.row(f"{what}: velocity of the block [m/s]", v, points["U"][:, 0].mean(), limit,
                      "relative")
    # In 3D the nodes at the sides have two walls
    case = gun("edges-3D", True, {"velocity": (v, 0, 0)}, deep=3, transfer="FLIP")
    table.row("edges in 3D: velocity of the block [m/s]", v,
              case.points(case.times()[-1], "block")["U"][:, 0].mean(), 0.01, "relative")
    symmetry(table)
    for onePatch, contact in ((True, ("walls",)), (False, ("taper", "barrel", "muzzle"))):
        case = gun(f"edges-contact-{len(contact)}", onePatch, {"velocity": (v, 0, 0)}, contact,
                   transfer="FLIP")
        table.row(f"edges of {len(contact)} patches in contact: velocity of the block [m/s]", v,
                  case.points(case.times()[-1], "block")["U"][:, 0].mean(), 0.01, "relative")
    case = gun("edges-pressed", True, {"velocity": (v, 0, 0), "stress": (
        -1e5, 0, 0, -1e5, 0, -1e5)}, transfer="FLIP")
    for time in case.times("lagrangian")[1:]:
        x = case.points(time, "block")["x"]
        inside = x[(x[:, 0] > 0) & (x[:, 0] < 8*H)]
        ends = [*inside[:, 1], 1.5*H]
        table.check(f"edges: a block under pressure stays in the barrel, {float(time):g} s",
                    0 < min(ends) and max(ends) < 3*H, (len(inside), min(ends), max(ends)))


def main():
    table = Report("boundaries")
    flip = {"transfer": "FLIP", "PICfraction": 0}
    fmpm = {"transfer": "FMPM", "order": 2}
    try:
        record = translation(table, "cyclic lattice, GIMP, FLIP", "GIMP", flip, 0,
                             (0.1, -0.065), 0.05)
        table.row("function objects run once per step: rows", 300, len(record), 0)
        translation(table, "cyclic lattice, quadratic, FMPM", "quadraticBSpline", fmpm,
                    0, (-0.1, 0.065), 0.043)
        translation(table, "sheared cyclic, linear, FLIP", "linear", flip, 0.3,
                    (0.1, -0.065), 0.05)
        translation(table, "sheared cyclic, on the side, -x", "linear", flip, 0.3,
                    (-0.1, 0), 0.05)
        translation(table, "sheared cyclic, on the side, -y", "linear", fmpm, 0.3,
                    (0, -0.1), 0.05)
        translation(table, "linear, points on sides of cells", "linear", flip, 0,
                    (0.1, 0), 0.05)
        column(table, False)
        column(table, True)
        movingWall(table)
        edges(table)
    except RunFailed as e:
        table.check("runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
