#!/usr/bin/env python3
"""Material points on cells of any kind with node-dual functions (nodeDual).

The unit box cut into tetrahedra, prisms or hexahedra, inner points moved at
random by 20 % of the widths, but for the planes in which bodies begin.

    translation   an elastic block crosses cells at Mach 0.1, 120 steps, FLIP and
                  FMPM 2: |u - v0|/|v0| of every point 1e-12, mass 1e-12,
                  position against x0 + v0 t 1e-12 of the mesh; also on the
                  polyhedra of polyDualMesh, whose faces are warped, and from boxes into
                  such of half the width; through cyclic sides (APIC too), on 2
                  processors
    along a wall  the same block on a slip wall, moving along it (there nodes
                  have a gradient but no mass); tetrahedra
    fall          a neo-Hookean block flies through a cyclic side and onto a fixed
                  wall between slip walls, 120 steps: 2 and 3 processors against 1,
                  1e-10 of each column; restart on 2 processors bit by bit
    impact        the plates of plateImpact, FMPM 3, strainFilter 1, Courant
                  number 0.9, 24 / 50 / 100 cells over the target: L1 9 / 6 / 4 %,
                  overshoot 20 / 13 / 13 %, momentum along the impact 1e-12

With MPM_VERIFY=1 also prisms, warped hexahedra, polyhedra and boxes refined 2:1, 50
and 100 cells, and the first tension within 8 ns. meshes.py and features.py have the
other parts.
"""

import math
import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import plateImpactExact as exact
import bending
import features
import meshes
import turning
from cellMesh import boxOfCells
from foamCase import (FoamCase, RunFailed, VERIFY, controlDict, noSchemes, runParts,
                      velocityFile)
from meshes import BASE, changeMesh
from plates import crossing, startPositions

E, NU, RHO, H = 1e6, 0.3, 1000.0, 0.01
WAVE = np.sqrt(E*(1 - NU)/((1 + NU)*(1 - 2*NU))/RHO)
VELOCITY = np.array([0.1, 0.065, -0.045])*WAVE
STEPS, CO = 120, 0.4

CYCLIC = {"left": ("cyclic", ("x-",), "right"), "right": ("cyclic", ("x+",), "left")}

TRANSFERS = {"FLIP": {"transfer": "FLIP", "PICfraction": 0.01},
             "FMPM2": {"transfer": "FMPM", "order": 2, "strainFilter": 1},
             "APIC": {"transfer": "APIC"},
             "turnSides": {"transfer": "FLIP", "turnSides": True}}

COLUMNS = ("x", "U", "m", "V", "sigma", "leftStretch")

#: Transfer of shocks; L1 and overshoot [%] by cells over the flyer
SHOCK = {"transfer": "FMPM", "order": 3, "strainFilter": 1}
LIMITS = {12: (9, 20), 25: (6, 13), 50: (4, 13)}


def translation(kind, transfer, onWall=False, split=None, cyclic=False):
    """A block of 3 cells in each direction of a mesh of 10; cyclic: out of one side
    and in at the other."""
    n = 10
    low = np.array([6 if cyclic else 2, 2, 0 if onWall else 5])
    velocity = VELOCITY*(1, 1, not onWall)
    case = FoamCase("anyMesh", f"translation-{kind}-{transfer}{'-wall'*onWall}"
                               f"{'-split'*bool(split)}{'-cyclic'*cyclic}")
    case.write("constant/phaseProperties", {
        "phases": ["block"],
        "block": {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E,
                                        "nu": NU}}})
    boxOfCells(case, BASE.get(kind, (kind,))[0], (0, 0, 0), (n*H,)*3, (n,)*3,
               {"outside": ("patch", ("x-", "x+")[:2*(not cyclic)] + ("y-", "y+", "z+")),
                "wall": ("patch", ("z-",)), **(CYCLIC if cyclic else {})},
               kept=[(d, low[d] + k) for d in range(3) for k in (0, 3)])
    velocityFile(case, "block", {"outside": "calculated", "wall": "slip",
                                 **{side: "cyclic" for side in CYCLIC if cyclic}})
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "min": low*H, "max": (low + 3)*H,
        "pointsPerCell": 2, "velocity": velocity}}})
    case.write("system/fvSolution",
               {"materialPoints": {"shapeFunction": "nodeDual", **TRANSFERS[transfer]}})
    noSchemes(case)
    dt = CO*H/(WAVE + np.max(abs(VELOCITY)))
    case.write("system/controlDict", controlDict(STEPS*dt, STEPS*dt, deltaT=dt))
    # The block begins in boxes and goes on in finer ones
    changeMesh(case, kind, (5*H, 0, 0), (10*H, 10*H, 10*H))
    case.run("setMaterialPoints")
    if split:
        case.decompose(split)
        case.runParallel(limit=300)
        case.run("reconstructPar", "-latestTime")
    else:
        case.run("materialPointFoam", limit=300)
    return case, velocity, STEPS*dt, n*H


def judgeTranslation(table, label, case, velocity, t, size):
    first, last = case.points("0", "block"), case.points(case.times()[-1], "block")
    speed = np.linalg.norm(velocity)
    u = last.byId("U")
    travel = last.byId("x") - first.byId("x") - velocity*t
    if "cyclic" in label:
        table.check(f"{label}: all have come through", np.all(travel[:, 0] < -0.9*size))
        travel[:, 0] += size
    table.check(f"{label}: same points", len(u) == len(first["id"]), str(len(u)))
    # Polyhedra do not end at the faces of the block
    mass = np.sum(first.byId("m")) if "polyhedra" in label else RHO*(3*H)**3
    table.row(f"{label}: mass", mass, np.sum(last.byId("m")), 1e-12, "relative")
    table.row(f"{label}: largest |u - v0|/|v0|", 0, np.max(abs(u - velocity))/speed, 1e-12)
    table.row(f"{label}: position error/mesh size", 0, np.max(abs(travel))/size, 1e-12)


def impact(kind, cells, maxCo, numerics, width=3):
    """L1 and overshoot [%] as plateImpact; cells over the flyer."""
    h = exact.H/cells
    T, end = 0.5e-6, 1.3e-6 if VERIFY else 0.5e-6
    margin = max(4, math.ceil(exact.V*(end - 0.7e-6)/h) + 3)
    n = (width, 3*cells + 2*margin, width)
    case = FoamCase("anyMesh", f"impact-{kind}-{cells}")
    law = {"velocityField": "plates",
           "constitutiveModel": {"type": "linearElastic", "rho": exact.RHO,
                                 "E": exact.E, "nu": 0}}
    case.write("constant/phaseProperties",
               {"phases": ["target", "flyer"], "target": law, "flyer": law})
    base, moved = BASE.get(kind, (kind, 0.2))
    boxOfCells(case, base, (0, -margin*h, 0), (width*h, 3*exact.H + margin*h, width*h), n,
               {"ends": ("patch", ("y-", "y+")), "sidesX": ("patch", ("x-", "x+")),
                "sidesZ": ("patch", ("z-", "z+"))},
               moved=moved, kept=[(1, margin + k*cells) for k in (0, 2, 3)])
    velocityFile(case, "plates", {"ends": "calculated", "sidesX": "slip", "sidesZ": "slip"})
    regions = {"target": (0, 2*exact.H, 0), "flyer": (2*exact.H, 3*exact.H, -exact.V)}
    case.write("system/setMaterialPointsDict", {"regions": {
        phase: {"phase": phase, "type": "box", "min": (-1, y0, -1), "max": (1, y1, 1),
                "pointsPerCell": 2, "velocity": (0, v, 0)}
        for phase, (y0, y1, v) in regions.items()}})
    case.write("system/fvSolution", {"materialPoints": {"shapeFunction": "nodeDual",
                                                        **numerics}})
    noSchemes(case)
    case.write("system/controlDict", controlDict(
        end, T, maxCo, functions={"middle": {
            "type": "materialPointProbes", "libs": "(mpmFunctionObjects)",
            "phase": "target", "fields": ["sigma_yy"], "operation": "mean",
            "points": {"box": f"(-1 {exact.H - h/2!r} -1) (1 {exact.H + h/2!r} 1)"},
            "writeControl": "timeStep", "writeInterval": 1}}))
    changeMesh(case, kind, (-1, 0.9*exact.H, -1), (1, 1.1*exact.H, 1))
    case.run("setMaterialPoints")
    seconds = case.run("materialPointFoam", limit=1200)

    time = case.timeName(T)
    y, s, momentum, impulse = [], [], 0, 0
    for phase in regions:
        y.append(startPositions(case, phase))
        points = case.points(time, phase)
        s.append(points.byId("sigma")[:, 3])
        momentum += np.sum(points.byId("m")*points.byId("U")[:, 1])
        impulse -= np.sum(points.byId("m"))*regions[phase][2]
    y, s = np.concatenate(y), np.concatenate(s)
    t, mean = case.series("middle", "sigma_yy.dat").T
    return {"L1": 100*np.mean(abs(s - exact.stress(y, T)))/exact.STRESS,
            "overshoot": 100*(-s.min()/exact.STRESS - 1),
            "tension": 1e9*(crossing(t, mean, 0, 0.8e-6) - exact.T_TENSION),
            "momentum": momentum/impulse + 1,
            "points": len(y), "steps": case.nSteps(), "core-seconds": seconds}


def fall(kind, transfer, name):
    """A block of 3 cells in each direction of a mesh of 8 whose sides x are cyclic
    (of polyhedra slip walls)."""
    n, cyclic = 8, kind != "polyhedra"
    case = FoamCase("anyMesh", f"fall-{kind}-{name}")
    case.write("constant/phaseProperties", {
        "phases": ["block"],
        "block": {"constitutiveModel": {"type": "neoHookean", "rho": RHO, "E": E,
                                        "nu": NU}}})
    sides = CYCLIC if cyclic else {"sides": ("patch", ("x-", "x+"))}
    boxOfCells(case, kind if cyclic else "tets", (0, 0, 0), (n*H,)*3, (n,)*3,
               {**sides, "wall": ("wall", ("y-",)), "top": ("patch", ("y+",)),
                "walls": ("patch", ("z-", "z+"))})
    velocityFile(case, "block", {
        **{name: "cyclic" if cyclic else "slip" for name in sides},
        "wall": {"type": "fixedValue", "value": "uniform (0 0 0)"},
        "top": "calculated", "walls": "slip"})
    low = np.array([4.5 if cyclic else 3, 1.5, 0.5])
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "min": low*H, "max": (low + 3)*H,
        "pointsPerCell": 2,
        "velocity": np.array([0.35 if cyclic else 0.1, -0.25, 0.15])*WAVE}}})
    case.write("system/fvSolution",
               {"materialPoints": {"shapeFunction": "nodeDual", **TRANSFERS[transfer]}})
    noSchemes(case)
    dt = 0.2*H/WAVE
    case.write("system/controlDict", controlDict(STEPS*dt, STEPS*dt/2, deltaT=dt))
    if not cyclic:
        case.run("polyDualMesh", "60", "-overwrite")
    case.run("setMaterialPoints")
    return case


def onProcessors(table, kind, transfer, splits):
    label = f"fall, {kind}, {transfer}"
    one = fall(kind, transfer, f"{transfer}-1")
    start = one.points("0", "block").byId("x")
    one.run("materialPointFoam")
    half, end = one.times()[1:3]
    last = one.points(end, "block")
    table.row(f"{label}: largest stress/E", 0.05, np.max(abs(last["sigma"]))/E, 0.05,
              "atLeast")
    table.check(f"{label}: points have left one side and come in at the other",
                kind == "polyhedra" or np.min(last.byId("x") - start) < -4*H)
    for split in splits:
        several = fall(kind, transfer, f"{transfer}-{'x'.join(map(str, split))}")
        several.decompose(split)
        several.runParallel(limit=300)
        ranks = int(np.prod(split))
        table.row(f"{label}: 1 against {ranks} processors, largest difference", 0,
                  one.largestDifference(several, end, ["block"], COLUMNS), 1e-10, "atMost")
        if kind == "tets" and ranks == 2:
            again = fall(kind, transfer, f"{transfer}-again")
            again.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
            again.decompose(split)
            for p, q in zip(several.processors(), again.processors()):
                shutil.copytree(os.path.join(p, half), os.path.join(q, half))
            again.runParallel(limit=300)
            table.row(f"{label}: restart on 2 processors, largest difference", 0,
                      several.largestDifference(again, end, ["block"], COLUMNS), 0,
                      "atMost")


def judgeImpact(table, label, cells, result):
    print(label, result, flush=True)
    l1, overshoot = LIMITS[cells]
    table.row(f"{label}: L1 [%]", l1, result["L1"], l1, "atMost")
    table.row(f"{label}: overshoot [%]", overshoot, result["overshoot"], overshoot,
              "atMost")
    table.row(f"{label}: momentum", 0, result["momentum"], 1e-12)
    if VERIFY:
        table.row(f"{label}: tension error [ns]", 0, result["tension"], 8)


def translations(table):
    for run in (("tets", "FLIP"), ("tets", "FMPM2"), ("prisms", "FLIP"),
                ("warped", "FLIP"), ("polyhedra", "FLIP"), ("tets", "FLIP", True),
                ("tets", "FMPM2", False, (1, 1, 2)), ("polyhedra", "FLIP", False, (2, 1, 1)),
                ("refined", "FLIP"), ("refined", "APIC", False, (2, 1, 1)),
                ("tets", "APIC", False, None, True), ("hexes", "FLIP", False, None, True),
                ("tets", "turnSides", False, None, True)):
        label = (f"translation, {run[0]}, {run[1]}{', along a wall'*(run[2:3] == (True,))}"
                 f"{', 2 processors'*(len(run) == 4)}"
                 f"{', through cyclic sides'*(len(run) == 5)}")
        try:
            judgeTranslation(table, label, *translation(*run))
        except RunFailed as e:
            table.check(f"{label} runs", False, e)


def falls(table):
    for run in (("tets", "FLIP", [(2, 1, 1), (1, 3, 1)]), ("tets", "turnSides", [(2, 1, 1)]),
                ("polyhedra", "FLIP", [(1, 2, 1)]),
                ("prisms", "FMPM2", [(2, 1, 1)])):
        try:
            onProcessors(table, *run)
        except RunFailed as e:
            table.check(f"fall, {run[0]}, {run[1]} runs", False, e)


def impacts(table):
    kinds = ("tets",) + ("prisms", "warped", "polyhedra", "refined")*VERIFY
    for kind in kinds:
        for cells in list(LIMITS)[:3 if VERIFY else 1]:
            label = f"impact, {kind}, {2*cells} cells over the target"
            try:
                judgeImpact(table, label, cells, impact(kind, cells, 0.9, SHOCK))
            except RunFailed as e:
                table.check(f"{label} runs", False, e)


if __name__ == "__main__":
    sys.exit(runParts("anyMesh", translations, falls, impacts, *meshes.PARTS, *features.PARTS,
                      *bending.PARTS, *turning.PARTS, *(features.LONG if VERIFY else ())))
