#!/usr/bin/env python3
"""Contact between velocity fields and with patches, against exact values.

plates     plates that fly over a gap of part of a cell, press, and part: time of
           contact, stress, momentum of each after they have parted
pair       plates of different impedance: stress and velocity of the interface
incline    block on a slope, on a rigid body and on a patch, in 2D and 3D: friction
anyCells   two blocks fly over a gap of part of a cell on prisms, moved hexahedra and
           tetrahedra, faces anyhow on the cells: time of contact, force of an elastic wave
disks      two elastic discs meet off centre: momentum, no pull; 1 and 2 processors
           give the same, a restart the same bit by bit
balls      two balls in 3D meet off centre: momentum
ledger     five impacts in one scene, every transfer, boxes and nodeDual, two time steps:
           impulse and load of the log are what the bodies' momenta change by
thin       ball in 2D on rigid floors of one and three layers of cells: gap, impulse, energy
curved     a disc slides in a bowl and over a hump, patches (curved.py): the exact motion
bounce     an octahedron falls on its tip (bounce.py): no more speed than before, with
           each transfer; restart in contact bit by bit
hertz      tutorials/hertz: half-width and pressure
sand       tutorials/sandColumn: runout
"""

import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from bounce import bounce
from cellMesh import boxOfCells
from curved import curved
from foamCase import (PROJECT, VERIFY, FoamCase, boxMesh, controlDict, foamText, noSchemes,
                      runParts, velocityFile)

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
            if label == "FLIP":
                # Misses 1 % by what rings in the plates
                print(f"{name}: momentum of the target after parting"
                      f" {right[-1, 0]/whole:.4f}, of the flyer {left[-1, 0]/whole:.4f}")
            else:
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


#: Gravity grows in RAMP s: at once the block would bounce, and slide while it is light
G, SLOPE, RAMP = 9.81, np.radians(30), 0.2


def inclineRun(name, floor, mu, dim=2, end=0.8):
    """Block of a soft solid on a floor; gravity is turned by 30 degrees, in 3D downhill
    along (1 0 1)."""
    h = 0.1
    depth = 1.5 if dim == 3 else h
    case = FoamCase("contact", name)
    along = np.array([1, 0, 1])/np.sqrt(2) if dim == 3 else np.array([1, 0, 0])
    g = foamText(G*(np.sin(SLOPE)*along - np.cos(SLOPE)*np.array([0, 1, 0])))
    phases = {"block": {
        "constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0.3},
        "bodyForce": {"type": "uniform", "acceleration":
                      f"table ((0 (0 0 0)) ({RAMP} {g}) (10 {g}))"}}}
    contact = {"fields": "(block)", "patch": "floor", "type": "Coulomb", "mu": mu}
    regions = {"block": {"phase": "block", "type": "box", "min": (0.5, 0, 0.5*(dim == 3)),
                         "max": (1.0 if dim == 3 else 1.5, 0.3,
                                 1.0 if dim == 3 else h), "pointsPerCell": 2}}
    low = 0.0
    if floor == "rigid":
        phases["slab"] = {"type": "rigid", "rho": 7800}
        contact = {"fields": "(block slab)", "type": "Coulomb", "mu": mu}
        low = -2*h
        regions["slab"] = {"phase": "slab", "type": "box", "min": (0, low, 0),
                           "max": (4, 0, depth), "pointsPerCell": 2}
    length = 1.5 if dim == 3 else 4
    case.write("constant/phaseProperties", {
        "phases": list(phases), **phases, "contact": {"slope": contact}})
    n = [int(round(v/h)) for v in (length, 1 - low, depth)]
    sides = ("x-", "x+", "y+") + (("z-", "z+") if dim == 3 else ())
    patches = {"floor": ("patch", ("y-",)), "rest": ("patch", sides)}
    conditions = {"floor": "calculated", "rest": "calculated"}
    if dim == 2:
        patches["frontAndBack"] = ("empty", ("z-", "z+"))
        conditions["frontAndBack"] = "empty"
    case.write("system/blockMeshDict",
               boxMesh((0, low, 0), (length, 1, depth), n, patches))
    for p in phases:
        velocityFile(case, p, conditions)
    case.write("system/setMaterialPointsDict", {"regions": regions})
    case.write("system/fvSolution", {"materialPoints": FLIP})
    noSchemes(case)
    case.write("system/controlDict", controlDict(end, end, 0.3, functions=BALANCE))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=300)
    t, mass, momentum, _ = balance(case, "block")
    return t, momentum/mass[:, None]


def incline(table):
    runs = [(floor, mu, 2, 0.8) for floor in ("rigid", "patch") for mu in (0.0, 0.3, 0.6)]
    runs += [("patch", mu, 3, 0.5) for mu in (0.3, 0.6)]
    for floor, mu, dim, end in runs:
        label = f"incline on a {floor}, mu {mu}" + (", 3D" if dim == 3 else "")
        t, u = inclineRun(f"incline-{floor}-{mu}-{dim}D", floor, mu, dim, end)
        late = t > 0.3
        exact = max(0.0, G*(np.sin(SLOPE) - mu*np.cos(SLOPE)))
        for d in (0, 2) if dim == 3 else (0,):
            part = np.sqrt(0.5) if dim == 3 else 1
            a = np.polyfit(t[late], u[late, d], 1)[0]
            name = f"{label}{', along ' + 'xyz'[d] if dim == 3 else ''}"
            if exact > 0:
                table.row(f"{name}: acceleration", exact*part, a, 1e-2, "relative")
            else:
                table.row(f"{name}: velocity at the end over that without friction", 0,
                          u[-1, d]/(G*np.sin(SLOPE)*(end - 0.5*RAMP)), 1e-2)


def discsCase(name, end, writeInterval, dim=2):
    """Two discs or balls of radius 0.2 meet off centre with friction."""
    case = FoamCase("contact", name)
    h = 0.05
    law = {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1000, "nu": 0.3}}
    case.write("constant/phaseProperties", {
        "phases": ["a", "b"], "a": law, "b": law,
        "contact": {"all": {"type": "Coulomb", "mu": 0.2}}})
    centres = {"a": (0.2, 0.27, 0.3), "b": (0.8, 0.73, 0.38)}
    if dim == 2:
        case.write("system/blockMeshDict", boxMesh(
            (-0.2, -0.2, 0), (1.2, 1.2, h), (28, 28, 1),
            {"sides": ("patch", ("x-", "x+", "y-", "y+")),
             "frontAndBack": ("empty", ("z-", "z+"))}))
        conditions = {"sides": "calculated", "frontAndBack": "empty"}
    else:
        case.write("system/blockMeshDict", boxMesh(
            (-0.1, -0.1, 0), (1.1, 1.1, 0.7), (24, 24, 14),
            {"sides": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}))
        conditions = {"sides": "calculated"}
    for p in "ab":
        velocityFile(case, p, conditions)
    speed = {"a": (0.1, 0.1, 0), "b": (-0.1, -0.1, 0)}
    shape = {}
    for p, x in centres.items():
        if dim == 2:
            shape[p] = {"type": "sphere", "centre": (*x[:2], 0.5*h), "radius": 0.2,
                        "pointsPerCell": 4}
        else:
            shape[p] = {"type": "sphere", "centre": x, "radius": 0.2, "pointsPerCell": 2}
    case.write("system/setMaterialPointsDict", {"regions": {
        p: {"phase": p, **shape[p], "velocity": speed[p]} for p in shape}})
    case.write("system/fvSolution", {"materialPoints": FLIP})
    noSchemes(case)
    control = controlDict(end, writeInterval, 0.3, functions=BALANCE)
    control["startFrom"] = "latestTime"
    control["reportInterval"] = 1
    case.write("system/controlDict", control)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    n = np.subtract(centres["b"], centres["a"])[:dim]
    return case, n/np.linalg.norm(n)


COLUMNS = ("x", "U", "m", "V", "sigma", "halfSize")


def parting(table, name, case, n):
    """Momentum, forces and parting of a run of discsCase."""
    _, _, a, energy = balance(case, "a")
    _, _, b, other = balance(case, "b")
    size = np.linalg.norm(a[0])
    table.row(f"{name}: momentum of both", 0,
              np.max(np.linalg.norm(a + b - a[0] - b[0], axis=1))/size, 1e-12, "atMost")
    t, force, _, _, _ = contactLog(case, "all")
    push = force[:, :len(n)] @ n
    table.row(f"{name}: least force along the line of centres over the largest", 0,
              push.min()/push.max(), -1e-2, "atLeast")
    table.row(f"{name}: they part (velocity of one against the other)", 0,
              ((b - a)[-1, :len(n)] @ n)/size, 0.5, "atLeast")
    print(f"{name}: kinetic energy {(energy + other)[-1]/(energy + other)[0]:.4f} of the"
          f" first, in contact {t[push > 0].min():.3f} to {t[push > 0].max():.3f} s")


def anyCells(table):
    """The force grows to its half, rho c v A/2, when the faces meet: within 0.05 cells."""
    h, rho, E = 1e-3, 2700.0, 70e9
    law = {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E, "nu": 0}}
    for kind, gap, shift, per in (
            ("prisms", 0.4, 0, 2), ("prisms", 1.6, 0.3, 2), ("prisms", 1.6, 0, 1),
            ("hexes", 0.4, 0, 2), ("hexes", 0.4, 0.3, 1), ("hexes", 1.6, 0.3, 2),
            ("tets", 0.4, 0.3, 2)):
        flat = kind != "tets"
        # The faces close while the wave crosses the bodies, of which those in 3D are short
        v = 20.0 if flat else 100.0
        case = FoamCase("contact", f"anyCells-{kind}-{gap}-{shift}-{per}")
        n = np.array((26, 14, 1) if flat else (18, 11, 11))
        low = np.array((-n[0]*h/2, -n[1]*h/2, -n[2]*h/2))
        wide = (n[1] - 5)*h/2, (h if flat else (n[2] - 5)*h/2)
        length = (n[0]/2 - 3)*h
        boxOfCells(case, kind, low, -low, n, {
            "sides": ("patch", ("x-", "x+", "y-", "y+") + (() if flat else ("z-", "z+"))),
            **({"frontAndBack": ("empty", ("z-", "z+"))} if flat else {})},
            moved=0.25 if flat else 0.15)
        case.write("constant/phaseProperties", {
            "phases": ["left", "right"], "left": law, "right": law,
            "contact": {"faces": {"fields": "(left right)", "type": "frictionless"}}})
        begin = shift*h
        regions = {"left": (begin - length, begin), "right": (
            begin + gap*h, begin + gap*h + length)}
        case.write("system/setMaterialPointsDict", {"regions": {name: {
            "phase": name, "type": "box", "min": (a, -wide[0], -wide[1]),
            "max": (b, wide[0], wide[1]), "pointsPerCell": per,
            **({"velocity": (v, 0, 0)} if name == "left" else {})}
            for name, (a, b) in regions.items()}})
        for name in regions:
            velocityFile(case, name, {"sides": "calculated",
                                      **({"frontAndBack": "empty"} if flat else {})})
        case.write("system/fvSolution", {"materialPoints": {
            "shapeFunction": "nodeDual", "transfer": "FMPM", "order": 2}})
        noSchemes(case)
        end = gap*h/v + 0.3*h/v
        case.write("system/controlDict", {**controlDict(end, end, 0.5), "reportInterval": 1})
        case.run("setMaterialPoints")
        case.run("materialPointFoam")
        t, force, *_ = contactLog(case, "faces")
        area = 2*wide[0]*(h if flat else 2*wide[1])
        half = 0.25*rho*np.sqrt(E/rho)*v*area
        start = t[np.argmax(force[:, 0] > half)] if (force[:, 0] > half).any() else np.inf
        table.row(f"blocks on {kind}, gap {gap}, face at {shift}, {per} per direction: early"
                  " contact [cells]", 0, (gap*h/v - start)*v/h, 0.05)


def disks(table):
    case, n = discsCase("disks", 3, 0.5)
    case.run("materialPointFoam", limit=300)
    parting(table, "discs", case, n)
    times = [t for t in case.times() if t != "0"]

    def sums(c):
        return re.findall(r"^Contact all.*(impulse \(.*?\))", c.log(), re.M)[-1]

    worst, same = 0.0, True
    for t in times[2:-1:2]:
        again, _ = discsCase(f"disks-from{t}", 3, 0.5)
        shutil.copytree(case.file(t), again.file(t))
        again.run("materialPointFoam", limit=300)
        worst = max(worst, case.largestDifference(again, times[-1], "ab", COLUMNS))
        same = same and sums(again) == sums(case)
    table.row("discs: restarts, largest difference at the end", 0, worst, 0, "atMost")
    table.check("discs: a restart goes on with the impulse of the contact", same, sums(case))

    two, _ = discsCase("disks-2", 3, 0.5)
    two.decompose((2, 1, 1))
    two.runParallel(limit=300)
    table.row("discs: 1 and 2 processors, largest difference at the end", 0,
              case.largestDifference(two, times[-1], "ab", COLUMNS), 1e-10, "atMost")


def balls(table):
    case, n = discsCase("balls", 2.5, 2.5, dim=3)
    case.run("materialPointFoam", limit=300)
    parting(table, "balls", case, n)


def tutorial(name, *changes):
    """A tutorial on one processor, with changes of its files; what its plot.py says."""
    case = FoamCase("contact", name, os.path.join(PROJECT, "tutorials", name))
    case.run("./Allclean")
    for change in changes:
        case.change(*change)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=400)
    case.run(sys.executable, "plot.py")
    return case.log(os.path.basename(sys.executable))


def thin(table):
    """On a floor of one layer the ball's points reach nodes of its underside."""
    h, push = 0.004, {}
    for layers in (1, 3):
        low = -layers*h
        case = FoamCase("contact", f"thin-{layers}")
        case.write("constant/phaseProperties", {
            "phases": ["ball", "floor"],
            "ball": {"constitutiveModel": {"type": "neoHookean", "rho": 1100, "E": 2e6,
                                           "nu": 0.45}},
            "floor": {"type": "rigid", "rho": 2000},
            "contact": {"both": {"type": "Coulomb", "mu": 0.6}}})
        case.write("system/blockMeshDict", boxMesh(
            (-0.06, low - h, 0), (0.06, 0.06, h), (30, 16 + layers, 1),
            {"sides": ("patch", ("x-", "x+", "y-", "y+")),
             "frontAndBack": ("empty", ("z-", "z+"))}))
        for p in ("ball", "floor"):
            velocityFile(case, p, {"sides": "calculated", "frontAndBack": "empty"})
        case.write("system/setMaterialPointsDict", {"regions": {
            "ball": {"phase": "ball", "type": "sphere", "centre": (0, 0.0247, 0.5*h),
                     "radius": 0.02, "pointsPerCell": 2, "velocity": (0.5, -3, 0)},
            "floor": {"phase": "floor", "type": "box", "min": (-0.06, low, 0),
                      "max": (0.06, 0, h), "pointsPerCell": 2}}})
        case.write("system/fvSolution", {"materialPoints": {**FLIP, "energyBudget": "yes"}})
        noSchemes(case)
        control = controlDict(6e-3, 6e-3, 0.4)
        control["reportInterval"] = 1
        case.write("system/controlDict", control)
        case.run("blockMesh")
        case.run("setMaterialPoints")
        case.run("materialPointFoam", limit=300)
        _, _, impulse, gap, _ = contactLog(case, "both")
        push[layers] = -impulse[-1, 1]
        table.row(f"floor, layers {layers}: least gap [cells]", 0, gap.min()/h,
                  -0.05, "atLeast")
        print(f"floor, layers {layers}: impulse {impulse[-1]}")
    # Below the first layer the floor touches nothing
    table.row("floor of one layer: impulse over that of three", 1, push[1]/push[3], 1e-4)


#: What soft blocks fall on, and how it moves
GROUNDS = {"soft": None, "patch": None,
           "pushed": {"type": "translation", "velocity": "(3 5 0)"},
           "fixed": {"type": "fixed"}, "free": {"type": "free"}}

BLOCK = (4, -10, 0)

TRANSFERS = {"FLIP": {"transfer": "FLIP"},
             "FLIP massFilter 1": {"transfer": "FLIP", "massFilter": 1},
             "FLIP 10 % PIC, massFilter 0.5": {"transfer": "FLIP", "PICfraction": 0.1,
                                               "massFilter": 0.5},
             "FLIP 10 % PIC": {"transfer": "FLIP", "PICfraction": 0.1},
             "FMPM 1": {"transfer": "FMPM", "order": 1},
             "FMPM 2": {"transfer": "FMPM", "order": 2},
             "FMPM 4": {"transfer": "FMPM", "order": 4},
             "XPIC 3": {"transfer": "XPIC", "order": 3},
             "APIC": {"transfer": "APIC"}}


def ledgerRun(shape, name, transfer, maxCo):
    """Blocks that hit their grounds obliquely, with friction."""
    h = 1e-3
    soft = {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1e8, "nu": 0.3}}
    phases, contact, regions = {}, {}, {}
    for i, (ground, motion) in enumerate(GROUNDS.items()):
        x, low = (7*i + 1.2)*h, 0 if ground == "patch" else 3*h
        phases[f"block{i}"] = soft
        regions[f"block{i}"] = {
            "phase": f"block{i}", "type": "box", "min": (x + h, low + 0.3*h, 0),
            "max": (x + 4*h, low + 3.3*h, h), "pointsPerCell": 2, "velocity": BLOCK}
        contact[ground] = {"fields": f"(block{i})", "type": "Coulomb", "mu": 0.2}
        if ground == "patch":
            contact[ground]["patch"] = "floor"
            continue
        phases[ground] = {"type": "rigid", "rho": 2000, "motion": motion} if motion else soft
        contact[ground]["fields"] = f"(block{i} {ground})"
        regions[ground] = {"phase": ground, "type": "box", "min": (x, 1.1*h, 0),
                           "max": (x + 5*h, 3*h, h), "pointsPerCell": 2}
    case = FoamCase("contact", f"ledger-{shape}-{name}-{maxCo}".replace(" ", ""))
    case.write("constant/phaseProperties", {
        "phases": list(phases), **phases, "contact": contact})
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (36*h, 9*h, h), (36, 9, 1),
        {"floor": ("patch", ("y-",)), "rest": ("patch", ("x-", "x+", "y+")),
         "frontAndBack": ("empty", ("z-", "z+"))}))
    for p in phases:
        velocityFile(case, p, {"floor": "calculated", "rest": "calculated",
                               "frontAndBack": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": regions})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": shape, **transfer, "energyBudget": "yes"}})
    noSchemes(case)
    case.write("system/controlDict", controlDict(7e-5, 7e-5, maxCo, functions=BALANCE))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=300)
    return case


def ledgerError(case):
    """Largest relative difference between impulses of the log and changes of momentum;
    least impulse upwards over what a block brings."""
    def said(line):
        found = re.findall(line + r".*impulse \((.*?)\) N s", case.log(), re.M)
        return np.array(found[-1].split(), float)

    def gained(phase, velocity=(0, 0, 0)):
        # The first row is that of the first step's end
        _, mass, momentum, _ = balance(case, phase)
        return momentum[-1] - mass[-1]*np.array(velocity), mass[-1]

    worst, least = 0, np.inf
    for i, ground in enumerate(GROUNDS):
        given, mass = gained(f"block{i}", BLOCK)
        sums = [said(f"^Contact {ground} between ")]
        sums += [gained(ground)[0]] if ground in ("soft", "free") else []
        sums += [said(f"^Load on {ground}:")] if GROUNDS[ground] else []
        for taken in sums:
            worst = max(worst, np.linalg.norm(taken + given)/np.linalg.norm(given))
        least = min(least, -given[1]/(mass*BLOCK[1]))
    return worst, least


def ledger(table):
    gain, least = -np.inf, np.inf
    for shape in ("GIMP", "nodeDual"):
        for name, transfer in TRANSFERS.items():
            for maxCo in (0.4, 0.1):
                # nodeDual has no affine velocities
                if shape == "nodeDual" and name == "APIC":
                    continue
                case = ledgerRun(shape, name, transfer, maxCo)
                worst, push = ledgerError(case)
                table.row(f"{shape}, {name}, maxCo {maxCo}: impulses of contact and loads"
                          " against momenta", 0, worst, 1e-12)
                least = min(least, push)
                if name not in ("FLIP", "FLIP massFilter 1"):
                    took = re.findall(r"^Energy budget: transfer ([^,]+),", case.log(),
                                      re.M)
                    gain = max(gain, float(took[-1]))
    table.row("the blocks hit: least impulse over what they brought", 0.5, least, 0.5,
              "atLeast")
    table.row("transfer takes energy in all of them [J]", 0, gain, 0, "atMost")


def shared(table):
    """Two blocks on one floor: by a dictionary for both as by one for each."""
    h = 1e-3
    soft = {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1e8, "nu": 0.3}}
    how = {"patch": "floor", "type": "Coulomb", "mu": 0.2}
    said = []
    for name, contact in (("one", {"floor": {"fields": "(a b)", **how}}), (
            "each", {"floorA": {"fields": "(a)", **how}, "floorB": {"fields": "(b)", **how}})):
        case = FoamCase("contact", "shared-" + name)
        case.write("constant/phaseProperties", {
            "phases": ["a", "b"], "a": soft, "b": soft, "contact": contact})
        case.write("system/blockMeshDict", boxMesh(
            (0, 0, 0), (14*h, 6*h, h), (14, 6, 1),
            {"floor": ("patch", ("y-",)), "rest": ("patch", ("x-", "x+", "y+")),
             "frontAndBack": ("empty", ("z-", "z+"))}))
        for p in "ab":
            velocityFile(case, p, {"floor": "calculated", "rest": "calculated",
                                   "frontAndBack": "empty"})
        case.write("system/setMaterialPointsDict", {"regions": {p: {
            "phase": p, "type": "box", "min": (x, 0.3*h, 0), "max": (x + 3*h, 3.3*h, h),
            "pointsPerCell": 2, "velocity": v}
            for p, x, v in (("a", 1.4*h, BLOCK), ("b", 8.2*h, (-5, -20, 0)))}})
        case.write("system/fvSolution", {"materialPoints": {
            "shapeFunction": "GIMP", "transfer": "FLIP"}})
        noSchemes(case)
        case.write("system/controlDict", controlDict(7e-5, 7e-5, 0.4))
        for program in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
            case.run(program)
        said.append([[float(v) for v in re.findall(
            rf"^Contact \w+ between {p} and patch floor: .*impulse \((\S+) (\S+)", case.log(),
            re.M)[-1]] for p in "ab"])
    table.row("two fields on a patch by one dictionary: impulses as with one for each [N s]", 0,
              np.abs(np.array(said[0]) - said[1]).max(), 0)
    table.row("two fields on a patch: least impulse on the floor over what a block brought", 0.5,
              min(-s[1]/(9*h**3*1000*v) for s, v in zip(said[0], (-BLOCK[1], 20))), 0.5, "atLeast")


def hertz(table):
    said = tutorial("hertz")
    for name in ("half-width", "peak pressure"):
        value, exact = re.search(rf"^{name}: (\S+) \w+, Hertz ([^,]+),", said, re.M).groups()
        table.row(f"hertz: {name}", float(exact), float(value), 5e-2, "relative")


def sand(table):
    # Nothing moves after 0.5 s
    shorter = () if VERIFY else (("system/controlDict", r"^endTime .*?;", "endTime 0.5;"),)
    said = re.findall(r"runout \(L - L0\)/L0 (\S+), farthest point (\S+),",
                      tutorial("sandColumn", *shorter))
    for name, value in zip(("end of the heap", "farthest point"), said[-1]):
        # Lube 1.2 a, Lajeunesse 1.8 a with a = 2
        table.row(f"sand column: runout, {name}", 3.0, float(value), 0.6)


def main():
    return runParts("contact", plates, pair, anyCells, incline, disks, balls, ledger, shared,
                    curved, thin, bounce, hertz, sand)


if __name__ == "__main__":
    sys.exit(main())
