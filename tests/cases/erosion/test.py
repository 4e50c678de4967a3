#!/usr/bin/env python3
"""Erosion of points by criterion, and neighbours that are apart.

marked      every criterion on a block whose columns are written by hand: exactly the
            points above the limit leave, those a millionth below it stay
bar         a bar that swings: first erosion where and when the exact strain passes
            the limit
booked      a block hits a plate that erodes: mass and momentum of left and eroded
            points in every step, energies against the run without erosion, restart
            bit by bit, two and three processors, a criterion that nothing meets
anvil       the load on a rigid body that erodes a block
gone        all points of one phase, then of all
debris      the same into a phase of its own: nothing leaves, every column goes along
outflow     a block flies out through a patch, then pieces of a plate do: mass, momentum
            and energy of left and present points in every step, restart bit by bit, two
            processors; the end of a run that loses all points
separation  neighbours of the start against pairs that are counted here
watched     a soft block is stretched: the solver warns of numerical fracture, once, when
            neighbours have an empty cell between them, and not before
"""

import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import bar as bars
from foamCase import (VERIFY, FoamCase, boxMesh, controlDict, noSchemes, runParts, velocityFile,
                      writeField)

FLIP = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0}
LIBS = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}
FUNCTIONS = {"balance": {"type": "materialPointBalance", **LIBS},
             "energy": {"type": "materialPointEnergy", **LIBS},
             "apart": {"type": "materialPointSeparation", **LIBS}}
H = 0.01
METAL = {"type": "J2Plasticity", "rho": 1000, "E": 1e7, "nu": 0.3, "yield": 1e5,
         "hardening": "none"}
STEEL = {"type": "JohnsonCook", "rho": 1000, "E": 1e7, "nu": 0.3, "A": 1e5, "B": 0,
         "n": 1, "C": 0, "m": 1, "referenceRate": 1, "referenceTemperature": 300,
         "meltTemperature": 1500, "cp": 400, "beta": 0.9}
TEARS = {"type": "maxPrincipalStress", "strength": 1e9}


def planeCase(name, phases, regions, cells, control, **more):
    """2D in a free box of so many cells of width H."""
    case = FoamCase("erosion", name)
    case.write("constant/phaseProperties", {"phases": list(phases), **phases, **more})
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), [H*n for n in (*cells, 1)], (*cells, 1),
        {"outer": ("patch", ("x-", "x+", "y-", "y+")),
         "frontAndBack": ("empty", ("z-", "z+"))}))
    for field in {p.get("velocityField", n) for n, p in phases.items()}:
        velocityFile(case, field, {"outer": "calculated", "frontAndBack": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": regions})
    case.write("system/fvSolution", {"materialPoints": FLIP})
    noSchemes(case)
    case.write("system/controlDict", control)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def box(phase, low, high, ppc=2, **entries):
    return {"phase": phase, "type": "box", "min": (low[0]*H, low[1]*H, 0),
            "max": (high[0]*H, high[1]*H, H), "pointsPerCell": ppc, **entries}


# --- marked ------------------------------------------------------------------

DT = 1e-7


def marked(table):
    """Left cells with 2 x 2 points, right ones with one."""
    regions = {"many": box("body", (2, 2), (5, 6)), "one": box("body", (5, 2), (8, 6), 1)}
    first = np.arange(60) % 3 == 0

    def spread(value, below, above):
        return {value: np.where(first, above, below)}

    near = 1e-6
    damaged = spread("damage", 0.0, 1.0)
    c = np.sqrt(METAL["E"]*(1 - METAL["nu"])/(1 + METAL["nu"])/(1 - 2*METAL["nu"])/1000)
    rows = (
        ("plasticStrain", METAL, {"type": "plasticStrain", "limit": 0.5},
         spread("plasticStrain", 0.5*(1 - near), 0.5*(1 + near)), 1, "first"),
        ("temperature", STEEL, {"type": "temperature", "limit": 900},
         spread("T", 900*(1 - near), 900*(1 + near)), 1, "first"),
        ("volumeRatio max", METAL, {"type": "volumeRatio", "max": 1.2},
         {"J": np.where(first, 1.2*(1 + near), 1.2*(1 - near))}, 1, "first"),
        ("volumeRatio min", METAL, {"type": "volumeRatio", "min": 0.8, "max": 1.2},
         {"J": np.where(first, 0.8*(1 - near), 0.8*(1 + near))}, 1, "first"),
        ("speed", METAL, {"type": "speed", "limit": 5},
         {"U": np.where(first, 5*(1 + near), 5*(1 - near))[:, None]
          * np.array((0.6, -0.8, 0))}, 1, "first"),
        ("timeStep", METAL, {"type": "timeStep", "limit": H/(c + 50)},
         {"U": np.where(first, 51, 49)[:, None]*np.array((0.4, -1, 0))}, 1, "first"),
        ("outside", METAL, {"type": "outside", "min": (2.5*H, 0, -1),
                            "max": (6.6*H, 4.8*H, -0.5)}, {}, 1, "outside"),
        ("damage", METAL, {"type": "damage"}, damaged, 1, "first"),
        ("damage, before its time", METAL, {"type": "damage", "time": 2.5*DT}, damaged,
         2, "none"),
        ("damage, at its time", METAL, {"type": "damage", "time": 2.5*DT}, damaged, 3,
         "first"),
        ("lone", METAL, {"type": "lone"}, damaged, 1, "lone"),
        ("any", METAL, {"type": "any", "a": {"type": "lone"},
                        "b": {"type": "plasticStrain", "limit": 0.5}},
         {**damaged, "plasticStrain": np.where(np.arange(60) % 7 == 0, 0.6, 0.4)}, 1, "any"))

    for label, law, erosion, columns, nSteps, which in rows:
        control = controlDict(nSteps*DT, nSteps*DT, deltaT=DT, functions=FUNCTIONS)
        case = planeCase("marked-" + re.sub(r"[, ]+", "-", label), {"body": {
            "constitutiveModel": law, "failureModel": TEARS, "erosion": erosion}},
            regions, (10, 8), control)
        start = case.points("0", "body")
        ids, m, V = start["id"], start["m"], start["V"]
        for name, values in columns.items():
            values = values[ids]
            if name == "J":
                name, values = "V", values*m/law["rho"]
            writeField(case.file("0/lagrangian/body", name), values)
        case.run("materialPointFoam")
        lone = first & (np.arange(60) >= 48)
        x = start["x"][np.argsort(ids)]/H
        out = (x[:, 0] < 2.5) | (x[:, 0] > 6.6) | (x[:, 1] > 4.8)
        gone = {"first": first, "none": first & False, "lone": lone, "outside": out,
                "any": lone | (np.arange(60) % 7 == 0)}[which]
        left = np.sort(case.points(case.times()[-1], "body")["id"])
        table.check(f"{label}: exactly the points above the limit leave",
                    np.array_equal(left, np.flatnonzero(~gone)),
                    f"{60 - len(left)} of {gone.sum()}")
        last = case.series("balance", "body.dat")[-1]
        mass = m[np.argsort(ids)][gone].sum()
        table.row(f"{label}: eroded mass [kg]", mass, last[14], 1e-15*m.sum())


# --- bar ---------------------------------------------------------------------

def bar(table):
    """J - 1 = v0/c cos(pi x/2L) sin(2 pi t/T), largest at the wall."""
    strain, cells = 0.8*bars.V0/10, 50
    case = FoamCase("erosion", "bar")
    case.write("constant/phaseProperties", {"phases": ["bar"], "bar": {
        "constitutiveModel": {"type": "linearElastic", "rho": bars.RHO, "E": bars.E,
                              "nu": 0},
        "erosion": {"type": "volumeRatio", "max": 1 + strain}}})
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (bars.L*(1 + 4/cells), 1, 1), (cells + 4, 1, 1),
        {"wall": ("patch", ("x-",)), "end": ("patch", ("x+",)),
         "sides": ("empty", ("y-", "y+", "z-", "z+"))}))
    velocityFile(case, "bar", {
        "wall": {"type": "fixedValue", "value": "uniform (0 0 0)"},
        "end": "calculated", "sides": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {"bar": {
        "phase": "bar", "type": "box", "min": (0, 0, 0), "max": (bars.L, 1, 1),
        "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": FLIP})
    noSchemes(case)
    exact = bars.T/(2*np.pi)*np.arcsin(0.8)
    case.write("system/controlDict", controlDict(1.01*exact, 1.01*exact, maxCo=0.1,
                                                 functions=FUNCTIONS))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    x = case.points("0", "bar")["x"][:, 0]
    start = np.zeros((len(x), 3))
    start[:, 0] = bars.V0*np.sin(np.pi*x/(2*bars.L))
    writeField(case.file("0/lagrangian/bar/U"), start)
    case.run("materialPointFoam")
    record = case.series("balance", "bar.dat")
    gone = record[:, 13]
    table.row("bar: time of the first erosion over that of the exact strain", 1,
              record[np.argmax(gone > 0), 0]/exact, 0.01)
    left = case.points(case.times()[-1], "bar")["id"]
    n = len(x) - len(left)
    table.check("bar: those at the wall leave", np.array_equal(
        np.setdiff1d(np.arange(len(x)), left), np.arange(n)) and n > 0, f"{n} points")


# --- booked ------------------------------------------------------------------

END = 2e-3
ERODES = {"target": {"type": "any", "strain": {"type": "plasticStrain", "limit": 0.4},
                     "stray": {"type": "lone"}},
          "flyer": {"type": "volumeRatio", "max": 1.3, "min": 0.7}}


def impact(name, erosion, contact=False, numerics=None):
    law = {p: {"constitutiveModel": METAL, "velocityField": p if contact else "solids",
               "failureModel": {"type": "maxPrincipalStress", "strength": 4e5},
               **({"erosion": erosion[p]} if p in erosion else {})}
           for p in ("target", "flyer")}
    case = planeCase(
        name, law,
        {"target": box("target", (8, 4), (11, 20)),
         "flyer": box("flyer", (2, 10), (8, 14), velocity=(40, 1, 0))},
        (28, 24), controlDict(END, END/4, maxCo=0.3, functions=FUNCTIONS),
        **({"contact": {"all": {"type": "frictionless"}}} if contact else {}))
    case.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
    if numerics:
        case.write("system/fvSolution", {"materialPoints": numerics})
    return case


def sums(case, start="0"):
    return {p: case.series("balance", p + ".dat", start)
            for p in ("target", "flyer", "total")}


def sameFiles(a, b, time, phase):
    """Same columns bit by bit."""
    one, two = (c.file(time, "lagrangian", phase) for c in (a, b))
    for name in ("x", "U", "m", "V", "sigma", "id", "plasticStrain", "damage",
                 "failedTime"):
        exists = [os.path.exists(os.path.join(p, name)) for p in (one, two)]
        if exists[0] != exists[1]:
            return False
        if exists[0] and not np.array_equal(a.points(time, phase)[name],
                                            b.points(time, phase)[name]):
            return False
    return True


def state(case, time):
    with open(os.path.join(case.file(time), "uniform/materialPointState")) as f:
        return f.read()


def booked(table):
    for label, contact, numerics in (
            ("one field", False, None), ("contact", True, None),
            ("USAVG, APIC", False, {"shapeFunction": "GIMP", "transfer": "APIC",
                                    "stressUpdate": "USAVG"}),
            ("USL, FMPM", False, {"shapeFunction": "quadraticBSpline", "transfer": "FMPM",
                                  "order": 2, "stressUpdate": "USL"})):
        name = re.sub("[, ]+", "-", label)
        whole = impact(name + "-whole", {}, contact, numerics)
        whole.run("materialPointFoam")
        never = {p: {"type": "plasticStrain", "limit": 1e9} for p in ERODES}
        idle = impact(name + "-never", never, contact, numerics)
        idle.run("materialPointFoam")
        last = whole.times()[-1]
        table.check(f"{label}: a criterion that nothing meets changes no bit", all(
            sameFiles(whole, idle, last, p) for p in ERODES))

        case = impact(name, ERODES, contact, numerics)
        case.run("materialPointFoam")
        s, w = sums(case), sums(whole)
        e, we = (c.series("energy", "energy.dat") for c in (case, whole))
        total = s["total"]
        print(f"{label}: eroded {s['target'][-1, 13]:.0f} and {s['flyer'][-1, 13]:.0f}"
              f" points in {np.sum(np.diff(total[:, 13]) > 0)} of {len(total)} steps;"
              f" apart at the end {case.series('apart', 'target.dat')[-1, 1:5]}")
        table.check(f"{label}: points of both phases erode",
                    s["target"][-1, 13] > 10 and s["flyer"][-1, 13] > 0)
        table.check(f"{label}: points present and eroded are those of the start", np.all(
            total[:, 1] + total[:, 13] == 288))
        for p in ERODES:
            m = s[p][:, 2] + s[p][:, 14]
            table.row(f"{label}, {p}: mass left and eroded, worst step", 0,
                      np.abs(m/m[0] - 1).max(), 1e-12)
        P = total[:, 3:6] + total[:, 15:18]
        table.row(f"{label}: momentum left and eroded, worst step", 0,
                  np.linalg.norm(P - P[0], axis=1).max()/np.linalg.norm(P[0]), 1e-12)

        # Until the first erosion the run is that without it
        i = np.argmax(total[:, 13] > 0)
        for what, column, gone in (("kinetic energy", 9, 18), ("stored energy", 10, 19),
                                   ("momentum", 3, 15)):
            table.row(f"{label}: {what} left and eroded over that of the run without, "
                      "first erosion", 1,
                      (total[i, column] + total[i, gone])/w["total"][i, column], 1e-12)
        size = we[0, 3]
        table.row(f"{label}: residual less that of the run without, first erosion, over "
                  "the energy", 0, (e[i, 7] - we[i, 7])/size, 1e-12)
        table.row(f"{label}: the budget's erosion over what was booked", 1,
                  -e[-1, 9]/(total[-1, 18] + total[-1, 19]), 1e-12)
        # K + W of the points, with what is booked as transfer, work and erosion
        rest = e[:, 3] - e[0, 3] - np.sum(e[:, 4:12] - e[0, 4:12],
                                          axis=1)
        if not contact:
            table.row(f"{label}: energy left less all terms of the budget, worst step, "
                      "over the energy", 0, np.abs(rest).max()/size, 1e-12)

        log = re.findall(r"^Eroded (\w+): (\d+) points, mass (\S+),", case.log(), re.M)[-2:]
        table.check(f"{label}: the log has it", [(p, int(n)) for p, n, _ in log] == [
            (p, int(s[p][-1, 13])) for p in ("target", "flyer")], log)

        # Restart from a time after the first erosion
        times = case.times()
        half = times[2]
        again = impact(name + "-again", ERODES, contact, numerics)
        shutil.copytree(case.file(half), again.file(half))
        again.run("materialPointFoam")
        table.check(f"{label}: restart, every column and every sum bit by bit", all(
            sameFiles(case, again, last, p) for p in ERODES)
            and state(case, last) == state(again, last)
            and "eroded" in state(case, half))

        # On two processors: contact, and APIC with its matrices
        few = not VERIFY and name not in ("contact", "USAVG-APIC")
        for n in ((2, 1, 1), (3, 1, 1))[few:]:
            nProcs = n[0]
            split = impact(f"{name}-{nProcs}", ERODES, contact, numerics)
            split.decompose(n)
            split.runParallel()
            t = sums(split)
            same = all(np.array_equal(np.sort(case.points(last, p)["id"]),
                                      np.sort(split.points(last, p)["id"])) for p in ERODES)
            table.check(f"{label}, {nProcs} processors: the same points are left", same)
            sameSteps = all(np.array_equal(s[p][:, 13], t[p][:, 13]) for p in s) \
                if len(s["total"]) == len(t["total"]) else False
            table.check(f"{label}, {nProcs} processors: as many erode in each step", sameSteps)
            if sameSteps:
                scale = np.abs(total[:, 13:]).max(axis=0)
                table.row(f"{label}, {nProcs} processors: sums of the eroded over those of "
                          "one", 0, np.max(np.abs(t["total"][:, 13:] - total[:, 13:])
                                           [:, scale > 0]/scale[scale > 0]), 1e-10)
                apart = [c.series("apart", "target.dat") for c in (case, split)]
                table.check(f"{label}, {nProcs} processors: the same pairs are apart",
                            np.array_equal(apart[0][:, 1:5], apart[1][:, 1:5])
                            and np.allclose(apart[0][:, 5], apart[1][:, 5], rtol=1e-10))
            if nProcs == 2:
                again = impact(f"{name}-2-again", ERODES, contact, numerics)
                again.decompose(n)
                for k, folder in enumerate(split.processors()):
                    shutil.copytree(os.path.join(folder, half),
                                    os.path.join(again.file(f"processor{k}"), half))
                again.runParallel()
                table.check(f"{label}, 2 processors: restart bit by bit", all(
                    np.array_equal(split.points(last, p)[c], again.points(last, p)[c])
                    for p in ERODES for c in ("id", "x", "U", "sigma", "m"))
                    and re.sub(r"energy\s*\{.*", "", state(split, "processor0/" + last),
                               flags=re.S)
                    == re.sub(r"energy\s*\{.*", "", state(again, "processor0/" + last),
                              flags=re.S))


# --- anvil -------------------------------------------------------------------

def anvil(table):
    """The load on a rigid body is what left and eroded points lost."""
    case = planeCase(
        "anvil", {
            "block": {"constitutiveModel": METAL, "velocityField": "solids",
                      "erosion": {"type": "plasticStrain", "limit": 0.2}},
            "plate": {"type": "rigid", "rho": 1000, "velocityField": "solids", "motion": {
                "type": "translation", "velocity": (0, 2, 0)}}},
        {"block": box("block", (6, 5), (10, 12), velocity=(1, -30, 0)),
         "plate": box("plate", (2, 3), (14, 5))},
        (16, 16), controlDict(END, END, maxCo=0.3, functions=FUNCTIONS))
    case.run("materialPointFoam")
    s = case.series("balance", "block.dat")
    start = case.points("0", "block")
    P0 = (start["m"][:, None]*start["U"]).sum(axis=0)
    load = re.findall(r"Load on plate: force .* N, impulse \((\S+) (\S+) (\S+)\)",
                      case.log())[-1]
    wrong = s[-1, 3:6] + s[-1, 15:18] + np.array(load, float) - P0
    table.check("anvil: points erode", s[-1, 13] > 5, s[-1, 13])
    table.row("anvil: momentum left, eroded and taken by the rigid body, less that of the "
              "start", 0, np.linalg.norm(wrong)/np.linalg.norm(P0), 1e-12)


# --- gone --------------------------------------------------------------------

def gone(table):
    law = {"constitutiveModel": METAL}
    regions = {"fast": box("fast", (2, 2), (4, 4), velocity=(3, 0, 0)),
               "slow": box("slow", (12, 2), (14, 4), velocity=(0.1, 0, 0))}
    probes = {"type": "materialPointProbes", **LIBS, "phase": "fast", "fields": ["U_x"]}
    functions = {
        **FUNCTIONS, "each": {**probes, "points": {"ids": [0, 7]}},
        "mean": {**probes, "points": {"box": "(0 0 0) (1 1 1)"}},
        "extent": {"type": "materialPointExtent", **LIBS},
        "xt": {"type": "materialPointXT", **LIBS, "field": "U_x", "direction": "x",
               "range": [0, 20*H], "nBins": 4},
        "smooth": {"type": "materialPointFields", "libs": "(mpmFunctionObjects)",
                   "fields": ["alpha", "U"]}}
    control = controlDict(4*DT, 2*DT, deltaT=DT, functions=functions)
    case = planeCase("gone", {"fast": {**law, "erosion": {"type": "speed", "limit": 2}},
                              "slow": law}, regions, (20, 6), control)
    case.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
    case.run("materialPointFoam")
    last = case.series("balance", "fast.dat")[-1]
    table.check("all points of a phase erode, the other goes on",
                last[1] == 0 and last[13] == 16 and case.times()[-1] == f"{4*DT:g}", last[13])
    for name in ("each", "mean"):
        values = case.series(name, "U_x.dat")[:, 1:]
        table.check(f"probes of points that have eroded: {name}", np.all(np.isnan(values)),
                    values.shape)
    case.change("system/controlDict", "endTime .*?;", f"endTime {6*DT};")
    case.run("materialPointFoam")
    table.check("restart with no point of a phase",
                case.times()[-1] == f"{6*DT:g}" and "Eroded fast: 16 points" in case.log())

    case = planeCase("allGone", {p: {**law, "erosion": {"type": "speed", "limit": 0.01}}
                                 for p in ("fast", "slow")}, regions, (20, 6), control)
    case.run("materialPointFoam", fails=True)
    table.check("no point left: one message",
                case.log().count("All points have eroded") == 1)


# --- debris ------------------------------------------------------------------

def debrisCase(name):
    """A block hits a plate, whose eroded points have a velocity field of their own."""
    law = {"constitutiveModel": METAL,
           "failureModel": {"type": "maxPrincipalStress", "strength": 4e5}}
    case = planeCase(
        name,
        {"target": {**law, "erosion": {**ERODES["target"], "to": "dust"}},
         "flyer": law, "dust": law},
        {"target": box("target", (8, 4), (11, 20)),
         "flyer": box("flyer", (2, 10), (8, 14), velocity=(40, 1, 0))},
        (28, 24), controlDict(END, END/4, maxCo=0.3, functions={
            **FUNCTIONS, "probe": {"type": "materialPointProbes", "phase": "target",
                                   "fields": "(plasticStrain)", "points": {"ids": [0, 95]},
                                   **LIBS}}),
        contact={"all": {"type": "frictionless"}})
    case.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
    return case


def debris(table):
    phases = ("target", "flyer", "dust")
    case = debrisCase("debris")
    case.run("materialPointFoam")
    s = {p: case.series("balance", p + ".dat") for p in (*phases, "total")}
    total, moved = s["total"], s["dust"][:, 1]
    table.check("debris: points of the target have gone there",
                moved[0] == 0 and moved[-1] > 10, f"{moved[-1]:.0f} points")
    table.check("debris: points of target and dust, every step",
                np.all(s["target"][:, 1] + moved == 192))
    table.check("debris: nothing is booked as gone", np.all(total[:, 13:] == 0)
                and total.shape[1] > 13)
    table.row("debris: mass, worst step", 0,
              np.abs(total[:, 2]/total[0, 2] - 1).max(), 1e-12)
    P = total[:, 3:6]
    table.row("debris: momentum, worst step", 0,
              np.linalg.norm(P - P[0], axis=1).max()/np.linalg.norm(P[0]), 1e-12)
    table.check("debris: the log has it", re.findall(
        r"^Eroded target: (\d+) points.*to dust$", case.log(), re.M)[-1:]
        == [f"{moved[-1]:.0f}"])

    times = case.times()
    start = case.points("0", "target")
    dust = case.points(times[-1], "dust")
    order = np.argsort(start["id"])
    table.row("debris: mass of each point, by id", 0,
              np.abs(dust["m"] - start["m"][order][dust["id"].astype(int)]).max(), 0)
    table.check("debris: above the limit or failed and alone",
                np.all((dust["plasticStrain"] > 0.4) | (dust["damage"] == 1)) and np.all(case.points(times[-1], "target")["plasticStrain"] <= 0.4))

    half = times[2]
    again = debrisCase("debris-again")
    shutil.copytree(case.file(half), again.file(half))
    again.run("materialPointFoam")
    table.check("debris: restart bit by bit", all(
        sameFiles(case, again, times[-1], p) for p in phases)
        and state(case, times[-1]) == state(again, times[-1]))
    for later in times[3:]:
        shutil.rmtree(again.file(later))
    shutil.rmtree(again.file(half, "lagrangian/dust"))
    again.run("materialPointFoam", fails=True)
    table.check("debris: restart without its folder stops at once",
                "Phase dust has 0 material points, but" in again.log())
    split = debrisCase("debris-2")
    split.decompose((2, 1, 1))
    split.runParallel()
    for p in phases:
        one, two = (c.points(times[-1], p) for c in (case, split))
        a, b = np.argsort(one["id"]), np.argsort(two["id"])
        same = np.array_equal(one["id"][a], two["id"][b])
        table.check(f"debris, 2 processors: points of {p}", same)
        if same:
            table.row(f"debris, 2 processors: places of {p} [cells]", 0,
                      np.abs(one["x"][a] - two["x"][b]).max()/H, 1e-9)


# --- outflow -----------------------------------------------------------------

OUT = {"outflow": {"patches": "(outer)"}}


def lostAndPresent(table, label, s):
    """Rows of materialPointBalance: points, mass and momentum in every step."""
    table.check(f"{label}: points present and left, every step",
                np.all(s[:, 1] + s[:, 13] == s[0, 1]) and s[-1, 13] > 0, s[-1, 13])
    m = s[:, 2] + s[:, 14]
    table.row(f"{label}: mass present and left, worst step", 0,
              np.abs(m/m[0] - 1).max(), 1e-12)
    P = s[:, 3:6] + s[:, 15:18]
    table.row(f"{label}: momentum present and left, worst step", 0,
              np.linalg.norm(P - P[0], axis=1).max()/np.linalg.norm(P[0]), 1e-12)


def plateOut(name, contact):
    """A block drives a plate out of the mesh."""
    law = {p: {"constitutiveModel": METAL, "velocityField": p if contact else "solids",
               "failureModel": {"type": "maxPrincipalStress", "strength": 4e5}}
           for p in ("target", "flyer")}
    case = planeCase(
        name, law,
        {"target": box("target", (22, 6), (25, 18)),
         "flyer": box("flyer", (16, 10), (22, 14), velocity=(60, 1, 0))},
        (28, 24), controlDict(1.2*END, 0.3*END, maxCo=0.3, functions=FUNCTIONS), **OUT,
        **({"contact": {"all": {"type": "frictionless"}}} if contact else {}))
    case.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
    return case


def outflow(table):
    law = {"constitutiveModel": METAL}
    case = planeCase("outflow", {"block": law}, {"block": box(
        "block", (3, 2), (7, 5), velocity=(30, 20, 0))}, (10, 8),
        controlDict(0.01, 0.01, maxCo=0.3, functions=FUNCTIONS), **OUT)
    case.run("materialPointFoam")
    s = case.series("balance", "block.dat")
    lostAndPresent(table, "block that flies out", s)
    table.row("block that flies out: kinetic energy present and left, worst step", 1,
              max(abs(s[:, 9] + s[:, 18])/s[0, 9], key=lambda r: abs(r - 1)), 1e-12)
    table.row("block that flies out: stored energy over the kinetic, worst step", 0,
              np.abs(s[:, 10]).max()/s[0, 9], 1e-12)
    table.check("block that flies out: the run ends when nothing is left",
                s[-1, 1] == 0 and "All material points have left" in case.log()
                and case.log().rstrip().endswith("End") and float(case.times()[-1]) < 0.01)
    times = case.times()
    case.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
    case.run("materialPointFoam")
    table.check("block that flies out: nothing to go on with from its end", case.times()
                == times and "All material points have left" in case.log()
                and case.log().rstrip().endswith("End"), case.times())

    for contact in (False, True):
        label = "plate driven out" + (", contact" if contact else "")
        name = label.replace(" ", "").replace(",", "-")
        case = plateOut(name, contact)
        case.run("materialPointFoam")
        s = {p: case.series("balance", p + ".dat") for p in ("target", "total")}
        lostAndPresent(table, label, s["total"])
        e = case.series("energy", "energy.dat")
        rest = e[:, 3] - e[0, 3] - np.sum(e[:, 4:12] - e[0, 4:12], axis=1)
        if not contact:
            table.row(f"{label}: energy left less all terms of the budget, worst step, "
                      "over the energy", 0, np.abs(rest).max()/e[0, 3], 1e-12)
        table.row(f"{label}: the budget's erosion over what left", 1,
                  -e[-1, 9]/(s["total"][-1, 18] + s["total"][-1, 19]), 1e-12)
        table.check(f"{label}: the log has it", re.findall(
            r"^Outflow target: (\d+) points", case.log(), re.M)[-1:]
            == [f"{s['target'][-1, 13]:.0f}"])

        times = case.times()
        half, last = times[3], times[-1]
        again = plateOut(name + "-again", contact)
        shutil.copytree(case.file(half), again.file(half))
        again.run("materialPointFoam")
        table.check(f"{label}: restart, every column and every sum bit by bit", all(
            sameFiles(case, again, last, p) for p in ("target", "flyer"))
            and state(case, last) == state(again, last) and "outflow" in state(case, half))
        split = plateOut(name + "-2", contact)
        split.decompose((1, 2, 1))
        split.runParallel()
        t = split.series("balance", "total.dat")
        table.check(f"{label}, 2 processors: as many leave in each step",
                    len(t) == len(s["total"])
                    and np.array_equal(t[:, 13], s["total"][:, 13]))
        table.check(f"{label}, 2 processors: the same points are left", all(
            np.array_equal(np.sort(case.points(last, p)["id"]),
                           np.sort(split.points(last, p)["id"]))
            for p in ("target", "flyer")))
        table.row(f"{label}, 2 processors: momentum that left over that of one", 0,
                  np.linalg.norm(t[-1, 15:18] - s["total"][-1, 15:18])
                  / np.linalg.norm(t[-1, 15:18]), 1e-10)


# --- separation --------------------------------------------------------------

def separation(table):
    """A block of 6 x 4 points in cells of 2 x 2; later the right half is elsewhere."""
    for shift, apart in ((1.9, True), (0.45, False)):
        case = planeCase(f"separation-{shift}", {"body": {"constitutiveModel": METAL,
                                                          "failureModel": TEARS}},
                         {"body": box("body", (2, 2), (5, 4))}, (14, 8),
                         controlDict(1, 1, maxCo=0.4))
        start = case.points("0", "body")
        x, ids = start["x"], start["id"]
        shutil.copytree(case.file("0"), case.file("1"))
        now = x + np.where(x[:, 0] > 3.6*H, shift*H, 0)[:, None]*np.array((1, 0, 0))
        writeField(case.file("1/lagrangian/body/x"), now)
        damage = (ids % 5 == 0).astype(float)
        writeField(case.file("1/lagrangian/body/damage"), damage)
        case.change("system/controlDict", "functions", "functions\n{\napart\n{\n"
                    "type materialPointSeparation; libs (mpmFunctionObjects);\n}\n}\n"
                    "unused")
        case.run("materialPointFoam", "-postProcess", "-time", "0:1")
        row = np.vstack([np.loadtxt(case.file("postProcessing/apart", t, "body.dat"), ndmin=2)
                         for t in sorted(os.listdir(case.file("postProcessing/apart")))])[-1]
        expected = np.zeros(4, int)
        for i in range(len(x)):
            for j in range(i):
                if abs(np.linalg.norm(x[i] - x[j])/(0.5*H) - 1) < 1e-6:
                    failed = damage[i] or damage[j]
                    far = np.abs(now[i] - now[j]).max() > H
                    expected[2*int(failed)] += 1
                    expected[2*int(failed) + 1] += int(far)
        table.check(f"separation by {shift} cells: pairs, apart, failed, failed and apart",
                    np.array_equal(row[1:5], expected)
                    and bool(expected[1] and expected[3]) == apart, list(row[1:5]))
        far = 0.5 + shift
        table.row(f"separation by {shift} cells: largest distance [cells]", far, row[5], 1e-12)


# --- watched -----------------------------------------------------------------

def watched(table):
    rate, end = 100.0, 0.024
    law = {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1, "nu": 0.3}}
    for label, ppc, stretch, more, expected in (
            ("2 points per cell, stretch 3.4", 2, 3.4, {}, 1),
            ("2 points per cell, stretch 1.9", 2, 1.9, {}, 0),
            ("4 points per cell, stretch 3.4", 4, 3.4, {}, 0),
            ("2 points per cell, stretch 3.4, 2 processors", 2, 3.4, {}, 1)):
        case = planeCase("watched-" + re.sub("[, .]+", "-", label), {"body": {**law, **more}},
                         {"body": box("body", (2, 2), (8, 4), ppc)}, (28, 6),
                         controlDict(end*(stretch - 1)/2.4, end*(stretch - 1)/9.6, maxCo=0.3))
        x = case.points("0", "body")["x"][:, 0]
        U = np.zeros((len(x), 3))
        U[:, 0] = rate*(x - 2*H)
        writeField(case.file("0/lagrangian/body/U"), U)
        if "processors" in label:
            case.decompose((2, 1, 1))
            case.runParallel()
        else:
            case.run("materialPointFoam")
        table.row(f"numerical fracture, {label}: warnings", expected,
                  case.log().count("Numerical fracture: of body"), 0)


def main():
    return runParts("erosion", marked, bar, booked, anvil, gone, debris, outflow,
                    separation, watched)


if __name__ == "__main__":
    sys.exit(main())
