#!/usr/bin/env python3
"""Contact between velocity fields and with patches, against exact values.

plates     plates that fly over a gap of part of a cell, press, and part: time of
           contact, stress, momentum of each after they have parted
pair       plates of different impedance: stress and velocity of the interface
incline    block on a slope, on a rigid body and on a patch: Coulomb's friction
disks      two elastic discs meet off centre: momentum, no pull
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (FoamCase, RunFailed, boxMesh, controlDict, noSchemes, velocityFile)
from report import Report

FMPM = {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2}
FLIP = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}


def contactLog(case, name):
    """Force and impulse on the second body, gap, over the reports."""
    text = case.log()
    rows = re.findall(rf"^Contact {name} .*force \(([^)]*)\) N, impulse \(([^)]*)\) N s,"
                      r" gap (\S+)(?: m)?, closed nodes (\d+)", text, re.M)
    time = [float(t) for t in re.findall(r"^Time = (\S+)", text, re.M)]
    force = np.array([r[0].split() for r in rows], float)
    impulse = np.array([r[1].split() for r in rows], float)
    gap = np.array([np.inf if r[2] == "none" else float(r[2]) for r in rows])
    closed = np.array([int(r[3]) for r in rows])
    return np.array(time[-len(rows):]), force, impulse, gap, closed


def balance(case, phase):
    """Time, mass, momentum, kinetic energy of a phase."""
    record = case.series("balance", f"{phase}.dat")
    return record[:, 0], record[:, 2], record[:, 3:6], record[:, 9]


BALANCE = {"balance": {"type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
                       "writeControl": "timeStep", "writeInterval": 1}}


def plateRun(name, cells, gap, left, right, speed, endTime, numerics, maxCo=0.4):
    """1D: left (length, rho, E) with its face at x = 0 flies at speed to right, whose
    face is gap cells away; cells in the length of left."""
    h = left[0]/cells
    n = int(round((left[0] + right[0])/h)) + 24
    case = FoamCase("contact", name)
    phase = {}
    for label, body in (("left", left), ("right", right)):
        phase[label] = {"constitutiveModel": {"type": "linearElastic", "rho": body[1],
                                              "E": body[2], "nu": 0}}
    case.write("constant/phaseProperties", {
        "phases": ["left", "right"], **phase,
        "contact": {"plates": {"fields": "(left right)", "type": "frictionless"}}})
    x0 = -left[0] - 12*h
    case.write("system/blockMeshDict", boxMesh(
        (x0, 0, 0), (x0 + n*h, h, h), (n, 1, 1),
        {"ends": ("patch", ("x-", "x+")), "sides": ("empty", ("y-", "y+", "z-", "z+"))}))
    for label in phase:
        velocityFile(case, label, {"ends": "calculated", "sides": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {
        "left": {"phase": "left", "type": "box", "min": (-left[0], 0, 0),
                 "max": (0, h, h), "pointsPerCell": 2, "velocity": (speed, 0, 0)},
        "right": {"phase": "right", "type": "box", "min": (gap*h, 0, 0),
                  "max": (gap*h + right[0], h, h), "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    functions = dict(BALANCE)
    for label, x, phase in (("leftFace", -0.15*left[0], "left"),
                            ("rightFace", gap*h + 0.15*left[0], "right")):
        functions[label] = {
            "type": "materialPointProbes", "libs": "(mpmFunctionObjects)", "phase": phase,
            "fields": ["sigma_xx", "U_x"], "operation": "mean", "points": {
                "box": f"({x - h!r} -1 -1) ({x + h!r} 1 1)"},
            "writeControl": "timeStep", "writeInterval": 1}
    control = controlDict(endTime, endTime, maxCo, functions=functions)
    control["reportInterval"] = 1
    case.write("system/controlDict", control)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=300)
    return case, h


def plates(table):
    L, rho, E, v = 1.9e-3, 2700.0, 70e9, 100.0
    c = np.sqrt(E/rho)
    for label, numerics in (("FMPM 2", FMPM), ("FLIP", FLIP)):
        for gap in (0.37, 1.6):
            case, h = plateRun(f"plates-{label.replace(' ', '')}-{gap}", 40, gap,
                               (L, rho, E), (2*L, rho, E), v, gap*L/40/v + 6*L/c, numerics)
            t, force, impulse, opening, _ = contactLog(case, "plates")
            _, mass, left, _ = balance(case, "left")
            _, _, right, _ = balance(case, "right")
            start = t[np.argmax(force[:, 0] > 0)]
            name = f"plates, {label}, gap {gap} cells"
            table.row(f"{name}: early contact [cells]", 0, (gap*h/v - start)*v/h, 0.2)
            table.row(f"{name}: least force", 0, force[:, 0].min(), 0, "atLeast")
            s = case.series("rightFace", "sigma_xx.dat")
            middle = (s[:, 0] > start + 0.6*L/c) & (s[:, 0] < start + 1.5*L/c)
            # Hencky's law at 1 % strain: as in tests/cases/plateImpact
            table.row(f"{name}: stress [MPa]", -687.4, s[middle, 1].mean()/1e6, 1e-2,
                      "relative")
            whole = left[0, 0]
            table.row(f"{name}: momentum of the target after parting", 1,
                      right[-1, 0]/whole, 1e-2)
            table.row(f"{name}: momentum of the flyer", 0, left[-1, 0]/whole, 1e-2)
            table.row(f"{name}: momentum of both", 0,
                      np.max(abs((left + right)[:, 0]/whole - 1)), 1e-12, "atMost")
            table.row(f"{name}: the gap is open at the end [cells]", 0,
                      opening[-1]/h if np.isfinite(opening[-1]) else 9, 0.1, "atLeast")
            face = case.series("leftFace", "sigma_xx.dat")
            print(f"{name}: contact at {start*1e6:.4f} us (exact {gap*h/v*1e6:.4f}),"
                  f" stress at the left face {face[:, 1].min()/1e6:.1f} to"
                  f" {face[:, 1].max()/1e6:.1f} MPa")


def pair(table):
    L, v = 1.9e-3, 100.0
    soft, hard = (L, 2700.0, 70e9), (2*L, 7850.0, 210e9)
    for name, a, b in (("light on heavy", soft, hard),
                       ("heavy on light", (L, *hard[1:]), (2*L, *soft[1:]))):
        za, zb = np.sqrt(a[1]*a[2]), np.sqrt(b[1]*b[2])
        case, h = plateRun(f"pair-{name.replace(' ', '-')}", 80, 0.0, a, b, v,
                           1.5*L/np.sqrt(a[2]/a[1]), FMPM)
        for side in ("leftFace", "rightFace"):
            s = case.series(side, "sigma_xx.dat")
            u = case.series(side, "U_x.dat")
            late = s[:, 0] > 0.5*L/np.sqrt(soft[2]/soft[1])
            table.row(f"{name}, {side}: stress [MPa]", -za*zb/(za + zb)*v/1e6,
                      s[late, 1].mean()/1e6, 1e-2, "relative")
            table.row(f"{name}, {side}: velocity", za*v/(za + zb), u[late, 1].mean(),
                      1e-2, "relative")


def incline(table):
    g, angle, rho, E = 9.81, np.radians(30), 1000.0, 1e6
    h = 0.1
    for floor in ("rigid", "patch"):
        for mu in (0.0, 0.3, 0.6):
            case = FoamCase("contact", f"incline-{floor}-{mu}")
            phases = {"block": {"constitutiveModel": {
                "type": "linearElastic", "rho": rho, "E": E, "nu": 0.3}}}
            contact = {"fields": "(block)", "patch": "floor", "type": "Coulomb", "mu": mu}
            regions = {"block": {"phase": "block", "type": "box",
                                 "min": (0.5, 0, 0), "max": (1.5, 0.5, h),
                                 "pointsPerCell": 2}}
            low = 0
            if floor == "rigid":
                phases["slab"] = {"type": "rigid", "rho": 7800}
                contact = {"fields": "(block slab)", "type": "Coulomb", "mu": mu}
                low = -2*h
                regions["slab"] = {"phase": "slab", "type": "box", "min": (0, low, 0),
                                   "max": (4, 0, h), "pointsPerCell": 2}
            case.write("constant/phaseProperties", {
                "phases": list(phases), **phases, "contact": {"slope": contact}})
            case.write("constant/g", f"dimensions [0 1 -2 0 0 0 0];\nvalue"
                       f" ({g*np.sin(angle)!r} {-g*np.cos(angle)!r} 0);\n",
                       kind="uniformDimensionedVectorField")
            case.write("system/blockMeshDict", boxMesh(
                (0, low, 0), (4, 1, h), (40, int(round((1 - low)/h)), 1),
                {"floor": ("patch", ("y-",)), "rest": ("patch", ("x-", "x+", "y+")),
                 "frontAndBack": ("empty", ("z-", "z+"))}))
            for p in phases:
                velocityFile(case, p, {"floor": "calculated", "rest": "calculated",
                                       "frontAndBack": "empty"})
            case.write("system/setMaterialPointsDict", {"regions": regions})
            case.write("system/fvSolution", {"materialPoints": FLIP})
            noSchemes(case)
            end = 0.8
            case.write("system/controlDict", controlDict(end, end, 0.3, functions=BALANCE))
            case.run("blockMesh")
            case.run("setMaterialPoints")
            case.run("materialPointFoam", limit=300)
            t, mass, momentum, _ = balance(case, "block")
            u = momentum[:, 0]/mass
            late = t > 0.3
            a = np.polyfit(t[late], u[late], 1)[0]
            exact = max(0.0, g*(np.sin(angle) - mu*np.cos(angle)))
            label = f"incline on a {floor}, mu {mu}"
            if exact > 0:
                table.row(f"{label}: acceleration", exact, a, 1e-2, "relative")
            else:
                table.row(f"{label}: velocity at the end (sticks)", 0, u[-1],
                          1e-2*g*np.sin(angle)*end, "absolute")
            print(f"{label}: {a:.5f}, exact {exact:.5f}")


def disks(table):
    case = FoamCase("contact", "disks")
    law = {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1000, "nu": 0.3}}
    case.write("constant/phaseProperties", {
        "phases": ["a", "b"], "a": law, "b": law,
        "contact": {"all": {"type": "Coulomb", "mu": 0.2}}})
    case.write("system/blockMeshDict", boxMesh(
        (-0.2, -0.2, 0), (1.2, 1.2, 0.05), (28, 28, 1),
        {"sides": ("patch", ("x-", "x+", "y-", "y+")), "frontAndBack": ("empty", ("z-", "z+"))}))
    for p in "ab":
        velocityFile(case, p, {"sides": "calculated", "frontAndBack": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {
        p: {"phase": p, "type": "cylinder", "p1": (*x, -1), "p2": (*x, 1), "radius": 0.2,
            "pointsPerCell": 4, "velocity": v}
        for p, x, v in (("a", (0.2, 0.27), (0.1, 0.1, 0)),
                        ("b", (0.8, 0.73), (-0.1, -0.1, 0)))}})
    case.write("system/fvSolution", {"materialPoints": FLIP})
    noSchemes(case)
    control = controlDict(3, 3, 0.3, functions=BALANCE)
    control["reportInterval"] = 1
    case.write("system/controlDict", control)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=300)
    _, mass, a, energy = balance(case, "a")
    _, _, b, other = balance(case, "b")
    size = np.linalg.norm(a[0])
    table.row("discs: momentum of both", 0, np.max(np.linalg.norm(a + b, axis=1))/size,
              1e-12, "atMost")
    t, force, _, _, _ = contactLog(case, "all")
    n = np.array([0.6, 0.46])/np.hypot(0.6, 0.46)
    push = force[:, :2] @ n
    table.row("discs: least force along the line of centres", 0,
              push.min()/push.max(), -1e-2, "atLeast")
    table.row("discs: they part (velocity of one against the other)", 0,
              ((b - a)[-1, :2] @ n)/size, 0.5, "atLeast")
    print(f"discs: kinetic energy {(energy + other)[-1]/(energy + other)[0]:.4f} of the"
          f" first, in contact {t[push > 0].min():.3f} to {t[push > 0].max():.3f} s")


def main():
    table = Report("contact")
    for part in (plates, pair, incline, disks):
        if len(sys.argv) > 1 and part.__name__ not in sys.argv[1:]:
            continue
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
