#!/usr/bin/env python3
"""Function objects: forces on patches, fields on mesh points, probes.

balance     a block that falls obliquely on walls (fixed, slip, moving; corners)
            under gravity: in each step P(n+1) - P(n) = dt (m g - F), F the sum
            over all walls, to 1e-12 of the largest momentum; several schemes
rare rows   the same run with every 7th row: sum of F times their lengths
rest        a column in a box of slip walls, damped: floor F = weight, walls
            nu/(1 - nu) rho g h^2/2 per thickness, moment of the floor = force
            at the middle
fields      a block that translates: alpha 1 and U the velocity at its inner
            mesh points, whatever place it has in the cells
probes      values of nearest, ids and box against the cloud on disk
parallel    every file of all function objects, and fields on mesh points, of
            2 to 4 processors (some without points) against one processor, to
            1e-10 of each column's maximum; also restarted at half time
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (VERIFY, FoamCase, RunFailed, boxMesh, controlDict, noSchemes,
                      readInternal, velocityFile)
from report import Report

H = 0.01
RHO, E, NU = 1000.0, 1e6, 0.3
LAW = {"type": "linearElastic", "rho": RHO, "E": E, "nu": NU}
C = np.sqrt(E*(1 - NU)/((1 + NU)*(1 - 2*NU))/RHO)
LIBS = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}
BALANCE = {"type": "materialPointBalance", **LIBS}

FLIP = {"transfer": "FLIP", "PICfraction": 0}
SCHEMES = {
    "GIMP FLIP": {"shapeFunction": "GIMP", **FLIP},
    "GIMP FLIP + 5 % PIC": {"shapeFunction": "GIMP", "transfer": "FLIP",
                            "PICfraction": 0.05},
    "GIMP FMPM 1": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 1},
    "GIMP FMPM 2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2},
    "quadraticBSpline FMPM 4": {"shapeFunction": "quadraticBSpline",
                                "transfer": "FMPM", "order": 4},
    "GIMP XPIC 2": {"shapeFunction": "GIMP", "transfer": "XPIC", "order": 2},
    "GIMP APIC": {"shapeFunction": "GIMP", "transfer": "APIC"},
    "GIMP FLIP USAVG": {"shapeFunction": "GIMP", **FLIP, "stressUpdate": "USAVG"},
    "linear FLIP": {"shapeFunction": "linear", **FLIP}}

MOVING = {"type": "timeVaryingUniformFixedValue", "file": '"<case>/table"',
          "outOfBounds": "clamp", "value": "uniform (0 0 0)"}
FIXED = {"type": "fixedValue", "value": "uniform (0 0 0)"}


def build(name, cells, conditions, region, numerics, control, gravity=None):
    """A 2D box with the patches floor, left, right and top."""
    case = FoamCase("functionObjects", name.replace("%", "").replace(" ", "-"))
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), [H*n for n in cells], cells,
        {"floor": ("patch", ("y-",)), "left": ("patch", ("x-",)),
         "right": ("patch", ("x+",)), "top": ("patch", ("y+",)),
         "frontAndBack": ("empty", ("z-", "z+"))}))
    case.write("constant/phaseProperties",
               {"phases": ["block"], "block": {"constitutiveModel": LAW}})
    velocityFile(case, "block", {**conditions, "frontAndBack": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "pointsPerCell": 2, **region}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    case.write("system/controlDict", control)
    if gravity:
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]",
                                  "value": gravity}, "uniformDimensionedVectorField")
    case.run("blockMesh")
    case.run("setMaterialPoints")
    with open(case.file("table"), "w") as f:
        f.write("((0 (0 0 0)) (1 (0 50 0)))\n")
    return case


def balance(table, scheme, walls, conditions):
    g = np.array((0, -400.0, 0))
    end = 60*H/C
    forces = {"type": "materialPointPatchForces", "libs": "(mpmFunctionObjects)",
              "patches": walls, "writeControl": "timeStep"}
    case = build(
        f"balance-{scheme}-{'-'.join(sorted(set(map(str, walls))))}-"
        f"{conditions['floor'] if isinstance(conditions['floor'], str) else conditions['floor']['type']}",
        (8, 12, 1), conditions,
        {"min": (0, 0.5*H, 0), "max": (4*H, 5.5*H, H), "velocity": (-0.02*C, -0.06*C, 0)},
        SCHEMES[scheme],
        controlDict(end, end, maxCo=0.4, functions={
            "balance": BALANCE, "forces": {**forces, "writeInterval": 1},
            "rare": {**forces, "writeInterval": 7}}), tuple(g))
    case.run("materialPointFoam")
    # time, points, mass, momentum
    record = case.series("balance", "block.dat")
    force = case.series("forces", "total.dat")
    points = case.points("0", "block")
    t = np.concatenate(((0,), record[:, 0]))
    P = np.vstack(((points["m"][:, None]*points["U"]).sum(axis=0), record[:, 3:6]))
    dt = np.diff(t)[:, None]
    mass = record[0, 2]
    wrong = np.diff(P, axis=0) - dt*(mass*g - force[:, 1:4])
    size = np.abs(P).max()
    floor = conditions["floor"] if isinstance(conditions["floor"], str) \
        else conditions["floor"]["type"]
    label = f"{scheme}, {floor}, {len(walls)} walls"
    table.check(f"{label}: walls are hit", np.abs(force[:, 1:4]).max() > 2*mass*400,
                f"{np.abs(force[:, 1:4]).max()/(mass*400):.1f} weights")
    table.row(f"{label}: P(n+1) - P(n) - dt (m g - F) over max P, worst step", 0,
              np.abs(wrong).max()/size, 1e-12)

    parts = sum(case.series("forces", f"{w}.dat")[:, 1:] for w in walls)
    table.row(f"{label}: sum of the walls / total", 0,
              np.abs(parts - force[:, 1:]).max()/np.abs(force[:, 1:]).max(), 1e-12)
    rare = case.series("rare", "total.dat")
    n = 7*len(rare)
    whole = (dt*force[:, 1:])[:n].sum(axis=0)
    some = (np.diff(np.concatenate(((0,), rare[:, 0])))[:, None]*rare[:, 1:]).sum(axis=0)
    table.row(f"{label}: impulse and moment of every 7th row / of all", 0,
              np.abs(some - whole).max()/np.abs(whole).max(), 1e-12)


def rest(table):
    n, w, g = 10, 4, 20.0
    period = 4*n*H/C
    case = build(
        "rest", (w, n + 2, 1),
        {"floor": "slip", "left": "slip", "right": "slip", "top": "calculated"},
        {"min": (0, 0, 0), "max": (w*H, n*H, H)},
        SCHEMES["GIMP FMPM 1"],
        controlDict(40*period, 40*period, maxCo=0.4, functions={
            "forces": {"type": "materialPointPatchForces", **LIBS,
                       "patches": ["floor", "left", "right"]}}), (0, -g, 0))
    case.run("materialPointFoam")
    weight = RHO*w*H*n*H*H*g
    side = NU/(1 - NU)*RHO*g*(n*H)**2/2*H
    last = {p: case.series("forces", f"{p}.dat")[-1, 1:] for p in ("floor", "left", "right")}
    table.row("column at rest: force on the floor [N]", -weight, last["floor"][1], 1e-3,
              "relative")
    table.row("column at rest: moment of the floor / (weight w/2)", -1,
              last["floor"][5]/(weight*w*H/2), 1e-3)
    for p, sign in (("left", -1), ("right", 1)):
        table.row(f"column at rest: force on the {p} wall [N]", sign*side, last[p][0], 0.02,
                  "relative")
        table.row(f"column at rest: shear on the {p} wall / weight", 0, last[p][1]/weight,
                  1e-12)
    first = case.series("forces", "floor.dat")
    table.row("suddenly loaded column: mean floor force over time / weight", -1,
              np.average(first[:, 2], weights=np.diff(np.concatenate(((0,), first[:, 0]))))
              / weight, 0.01)


def fields(table, shape):
    v = np.array((0.13*C, 0.071*C, 0))
    end = 9*H/C
    case = build(
        f"fields-{shape}", (12, 12, 1),
        dict.fromkeys(("floor", "left", "right", "top"), "calculated"),
        {"min": (3*H, 3*H, 0), "max": (8*H, 8*H, H), "velocity": tuple(v)},
        {"shapeFunction": shape, **FLIP},
        controlDict(end, end, maxCo=0.4, functions={
            "balance": BALANCE,
            "pictures": {"type": "materialPointFields", **LIBS,
                         "fields": ["alpha", "U", "sigma", "sigma_xy", "displacement"]}}))
    case.run("materialPointFoam")
    time = case.times()[-1]
    alpha, U, moved = (readInternal(case.file(time, f"point{f}.block"))
                       for f in ("Alpha", "U", "Displacement"))
    reached = alpha > 0
    table.check(f"{shape}: fields only at write times", not os.path.exists(
        case.file("0", "pointAlpha.block")) and len(case.times()) == 2, case.times())
    table.row(f"{shape}: alpha at inner mesh points", 1, alpha.max(), 1e-12)
    # Mesh points whose shape functions do not reach past the block's border
    margin = 1.25*H if shape == "GIMP" else H
    inner = 2*np.prod([sum(3*H + d + margin <= i*H <= 8*H + d - margin for i in range(13))
                       for d in v[:2]*end])
    table.row(f"{shape}: number of mesh points with alpha 1", inner,
              (alpha > 1 - 1e-12).sum(), inner, "atLeast")
    volume = case.points(time, "block")["V"].sum()
    # In 2D a node is two mesh points
    table.row(f"{shape}: sum of alpha V_l / volume of the block", 1,
              alpha.sum()/2*H**3/volume, 1e-12)
    table.row(f"{shape}: U where points are / velocity", 0,
              np.abs(U[reached] - v).max()/np.linalg.norm(v), 1e-12)
    table.row(f"{shape}: displacement / velocity times time", 0,
              np.abs(moved[reached]/(v*end + (0, 0, 1)) - (1, 1, 0)).max(), 1e-12)
    table.row(f"{shape}: sigma far from points", 0,
              np.abs(readInternal(case.file(time, "pointSigma.block"))).max()/E, 1e-12)
    if shape == "GIMP":
        os.remove(case.file(time, "pointAlpha.block"))
        case.run("materialPointFoam", "-postProcess", "-latestTime")
        again = readInternal(case.file(time, "pointAlpha.block"))
        table.row("fields by -postProcess / of the run", 0, np.abs(again - alpha).max(), 1e-12)


def probes(table):
    end = 30*H/C
    probe = {"type": "materialPointProbes", **LIBS, "phase": "block",
             "fields": ["x", "U_y", "sigma", "J", "displacement"]}
    case = build(
        "probes", (8, 12, 1),
        {"floor": FIXED, "left": "slip", "right": "slip", "top": "calculated"},
        {"min": (2*H, 0.5*H, 0), "max": (6*H, 5.5*H, H), "velocity": (0, -0.06*C, 0)},
        SCHEMES["GIMP FLIP"],
        controlDict(end, end, maxCo=0.4, functions={
            "ids": {**probe, "points": {"ids": [70, 3]}},
            "nearest": {**probe, "points": {"nearest": [(2*H, 0, 0), (6*H, 6*H, 0)]}},
            "box": {**probe, "points": {"box": f"(0 0 0) (1 {3*H} 1)"}},
            "low": {**probe, "operation": "min", "points": {"box": f"(0 0 0) (1 {3*H} 1)"}},
            "extent": {"type": "materialPointExtent", **LIBS, "halfSize": True},
            "xt": {"type": "materialPointXT", **LIBS, "field": "sigma_yy",
                   "direction": "y", "range": (0, 12*H), "nBins": 3}}))
    case.run("materialPointFoam")
    start, now = case.points("0", "block"), case.points(case.times()[-1], "block")
    x0, x = start.byId("x"), now.byId("x")
    V0, V, U = start.byId("V"), now.byId("V"), now.byId("U")
    sigma = now.byId("sigma")

    def last(name, field):
        return case.series(name, field + ".dat")[-1, 1:]

    wrong = max(np.abs(last("ids", "x") - x[[70, 3]].ravel()).max()/H,
                np.abs(last("ids", "U_y") - U[[70, 3], 1]).max()/C,
                np.abs(last("ids", "J") - (V/V0)[[70, 3]]).max(),
                np.abs(last("ids", "displacement")[[0, 1, 3, 4]]
                       - (x - x0)[[70, 3]][:, :2].ravel()).max()/H)
    table.row("probes: ids against the cloud on disk", 0, wrong, 1e-13)
    near = [np.argmin(((x0 - p)[:, :2]**2).sum(axis=1)) for p in ((2*H, 0, 0), (6*H, 6*H, 0))]
    table.row("probes: nearest", 0, np.abs(last("nearest", "x") - x[near].ravel()).max()/H,
              1e-13)
    low = x0[:, 1] <= 3*H
    mean = (V[low, None]*sigma[low]).sum(axis=0)/V[low].sum()
    table.row("probes: mean of a box", 0, np.abs(last("box", "sigma") - mean).max()
              / np.abs(mean).max(), 1e-12)
    table.row("probes: smallest of a box", 0, np.abs(
        last("low", "sigma") - sigma[low].min(axis=0)).max()/np.abs(mean).max(), 1e-13)
    bins = np.array([(V*sigma[:, 3])[b].sum()/max(V[b].sum(), 1e-300)
                     for b in (np.floor(x0[:, 1]/(4*H)) == i for i in range(3))])
    table.row("xt: means of bins", 0, np.abs(last("xt", "sigma_yy") - bins).max()
              / np.abs(bins).max(), 1e-12)
    m, h = now.byId("m")[:, None], now.byId("halfSize")
    extent = np.concatenate(((x - h).min(axis=0), (x + h).max(axis=0),
                             (m*x).sum(axis=0)/m.sum()))
    table.row("extent: box with half-sizes and centre of mass", 0,
              np.abs(last("extent", "block")[:9] - extent).max()/H, 1e-12)


def parallel(table, scheme):
    """All objects on one processor and on several."""
    end = 20*H/C
    probe = {"type": "materialPointProbes", **LIBS, "phase": "block",
             "fields": ["x", "U_y", "sigma", "J", "displacement"]}
    xt = {"type": "materialPointXT", **LIBS, "direction": "x", "range": (0, 3.5*H), "nBins": 5}
    objects = {
        "balance": {**BALANCE, "origin": (0.01, 0.02, 0)},
        "extent": {"type": "materialPointExtent", **LIBS},
        "ids": {**probe, "points": {"ids": [70, 3, 44]}},
        "nearest": {**probe, "points": {"nearest": [(4*H, 0, 0), (0, 6*H, 0), (2*H, 3*H, 0)]}},
        "box": {**probe, "points": {"box": f"(0 0 0) ({2*H} {3*H} 1)"}},
        "largest": {**probe, "operation": "max", "points": {"box": f"(0 0 0) (1 {3*H} 1)"}},
        "xt": {**xt, "field": "sigma_yy"}, "xtJ": {**xt, "field": "J"},
        "forces": {"type": "materialPointPatchForces", **LIBS, "patches": ["left", "floor"],
                   "origin": (0.01, 0.02, 0)},
        "pictures": {"type": "materialPointFields", **LIBS,
                     "fields": ["alpha", "U", "sigma", "displacement"]}}

    def make(name, stop=end):
        return build(
            f"parallel-{scheme}-{name}", (8, 12, 1),
            {"floor": "slip", "left": FIXED, "right": "calculated", "top": "calculated"},
            {"min": (0.5*H, 0.5*H, 0), "max": (4.5*H, 5.5*H, H),
             "velocity": (-0.03*C, -0.06*C, 0)}, SCHEMES[scheme],
            {**controlDict(stop, end/2, maxCo=0.4, functions=objects),
             "startFrom": "latestTime"}, (0, -400, 0))

    def files(case, time="0"):
        """All tables of the objects."""
        root = case.file("postProcessing")
        return {os.path.join(o, f): case.series(o, f, time)
                for o in sorted(os.listdir(root))
                for f in sorted(os.listdir(os.path.join(root, o, time)))}

    one = make("one")
    one.run("materialPointFoam")
    expected = files(one)
    half = one.times()[1]

    def judge(label, case, time="0"):
        found = files(case, time)
        table.check(f"{scheme}, {label}: files", set(found) == set(expected),
                    f"{len(found)}, {sorted(set(found) ^ set(expected))}")
        worst, where = 0, "none"
        for name, rows in found.items():
            want = expected[name][-len(rows):]
            if rows.shape != want.shape:
                worst, where = np.inf, name
                continue
            # Components of one quantity by its largest one
            size = np.abs(expected[name][:, 1:]).max(axis=0)
            if name.split("/")[0] not in ("balance", "extent"):
                size[:] = size.max()
            else:
                kinds = ([0], [1], [2, 3, 4], [5, 6, 7], [8, 9, 10], [11]) \
                    if name.startswith("balance") \
                    else ([0, 1, 2, 3, 4, 5, 6, 7, 8], [9], [10, 11, 12])
                for kind in kinds:
                    size[kind] = size[kind].max()
            error = (np.abs(rows[:, 1:] - want[:, 1:]).max(axis=0)/np.maximum(size, 1e-300)).max()
            if error > worst:
                worst, where = error, name
        table.row(f"{scheme}, {label}: worst of all tables ({where})", 0, worst, 1e-10)

    for pieces in ((2, 1, 1), (1, 3, 1), (2, 2, 1)):
        label = "x".join(map(str, pieces[:2])) + " processors"
        case = make(label)
        case.decompose(pieces)
        case.runParallel()
        judge(label, case)
        end_ = one.times()[-1]
        one.run("compareMaterialPoints", one.path, case.path, "-time", end_, "-tolerance",
                "1e-10", "-processors", "second")
        table.check(f"{scheme}, {label}: points and fields of compareMaterialPoints",
                    "pointDisplacement.block" in one.log("compareMaterialPoints"), "1e-10")

    case = make("restart", float(half))
    case.decompose((2, 2, 1))
    case.runParallel()
    case.change("system/controlDict", "endTime [^;]*;", f"endTime {end!r};")
    case.runParallel()
    judge("restarted on 2x2 processors", case, half)


def main():
    table = Report("functionObjects")
    slip = {"floor": "slip", "left": "slip", "right": "calculated", "top": "calculated"}
    fixed = {**slip, "floor": FIXED}
    moving = {**fixed, "floor": MOVING}
    jobs = [(balance, scheme, ("floor", "left"), conditions)
            for scheme in SCHEMES for conditions in (slip, fixed)]
    jobs += [(balance, "GIMP FLIP", ("floor", "left"), moving),
             (balance, "GIMP FMPM 2", ("floor", "left"), moving),
             (rest,), *([(parallel, "GIMP FLIP")] if VERIFY else []), (parallel, "GIMP FMPM 2"),
             (parallel, "linear FLIP"), (fields, "GIMP"), (fields, "linear"), (probes,)]
    for function, *arguments in jobs:
        try:
            function(table, *arguments)
        except (RunFailed, OSError) as e:
            table.check(f"{function.__name__} {arguments[:1]} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
