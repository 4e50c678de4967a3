#!/usr/bin/env python3
"""maxSubSteps: several steps of the points in one of the gas.

    moving      a steel disc moves with air: pressure uniform and momentum as without
                sub-steps, on boxes, prisms and with water; also where it erodes
    shock       a shock on a steel slab: reflected pressure by the exact solution,
                momentum and energy of both, beside the run without sub-steps
    body        a rigid piston whose motion depends on time: its way, the pressure
    walls       materialPointBalance and materialPointPatchForces see all of the sub-steps;
                -postProcess of the same case
    restart     bit by bit
    ranks       2 and 3 processors, 1e-10
    refused     without adjustTimeStep, or without a gas
"""

import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from coupledCases import coupledCase, gasLog
from gasCases import OPEN, UPWIND, WALL, volField
from gasOnCells import cyclicSides
from foamCase import RunFailed, runParts
from fluidCases import AIR, WATER, besidePoints, fluidCase

STEEL = {"constitutiveModel": {"type": "linearElastic", "rho": 7800, "E": 2e11, "nu": 0}}
STIFF = {"constitutiveModel": {"type": "linearElastic", "rho": 2700, "E": 2e12, "nu": 0}}
REAL = {}
DISC = {"type": "cylinder", "point1": (0.5, 0.5, -1), "point2": (0.5, 0.5, 1), "radius": 0.2}
P0, RHO0 = 1e5, 1.2


def subSteps(case):
    """Numbers of sub-steps in the log."""
    return [int(n) for n in re.findall(r"Steps of the points in this one of the \w+: (\d+)",
                                       case.log())]


BOTH = {"water": WATER, "air": AIR}
V = (80.0, 60.0, 0.0)


def movingDisc(name, steps, kind=None, fluids=None, split=None, phase=None, end=1e-3,
               before=lambda case: None, disc=None, **control):
    """A disc in a gas, or in these fluids (water below), of the same velocity."""
    n = 20 if kind else 30
    cells, high, patches = (n, n, 1), (1, 1, 1/n), cyclicSides("xy")[0]
    control = {"maxCo": 0.3, "maxSubSteps": steps, "reportInterval": 1, **control}
    points = dict(phases={"disc": phase or STEEL},
                  regions={"disc": {**DISC, "velocity": V, "stress": "ambient", "pressure": P0,
                                    **(disc or {})}},
                  numerics={"shapeFunction": "nodeDual"} if kind else None)
    if fluids:
        def initial(x, y, z):
            a = 1.0*(y < 0.5)
            return ([a, 1 - a] if len(fluids) > 1 else [1.0], [1000.0, RHO0][-len(fluids):],
                    np.tile(V, (len(x), 1)), P0)
        case = fluidCase("subSteps", name, cells, high, fluids, initial, end, patches=patches,
                         reconstruct=UPWIND, kind=kind, control=control)
        besidePoints(case, fluids, **points)
    else:
        case = coupledCase("subSteps", name, cells, high,
                           lambda x, y, z: (RHO0 + 0*x, np.tile(V, (len(x), 1)), P0 + 0*x), end,
                           patches=patches, gas=REAL, control=control, **points)
    before(case)
    if split:
        case.decompose(split)
        case.runParallel()
    else:
        case.run("materialPointFoam")
    return case


def of(case, end, name):
    return volField(case, f"{end:g}" if case.processors() else case.timeName(end), name)


def uniform(table, label, case, end, limit=1e-11, fluids=None):
    p, U = of(case, end, "p"), of(case, end, "U" if fluids else "U.air")
    pInf = 6e8 if fluids and "water" in fluids else 0
    table.row(f"{label}: dP/(P + pInf)", 0, np.max(abs(p - P0))/(P0 + pInf), limit)
    table.row(f"{label}: dU/U", 0, np.max(abs(U - V))/np.max(np.abs(V)), 1e-9)
    n = max(subSteps(case) or [1])
    table.check(f"{label}: steps of the points in one of the gas", n > 3, n)


def moving(table):
    for label, kind, fluids in (("air, boxes", None, None), ("air, prisms", "prisms", {"air": AIR}),
                                ("water and air, boxes", None, BOTH)):
        # The sound of water needs more than three steps of a stiffer disc
        end, law = (5e-4, STIFF) if fluids == BOTH else (1e-3, STEEL)
        label = "disc moves with " + label
        case = movingDisc("moving-" + label[16:].replace(" ", "-").replace(",", ""), 20, kind,
                          fluids, end=end, phase=law)
        uniform(table, label, case, end, 1e-12 if fluids == BOTH else 1e-11, fluids)
        if not fluids:
            log = gasLog(case)
            total = log["momentum"] + log["pointMomentum"]
            table.row(f"{label}: change of momentum", 0,
                      np.max(abs(total - total[0]))/np.max(abs(log["momentum"][0])), 1e-11)
            table.row(f"{label}: change of the gas' mass", 0,
                      np.ptp(log["mass"])/log["mass"][0], 1e-12)
    gone = {**STEEL, "erosion": {"type": "outside", "min": (-9, -9, -9), "max": (0.55, 0.55, 9)}}
    label, end = "disc erodes in air", 1e-3
    case = movingDisc("eroding", 20, phase=gone, end=end)
    uniform(table, label, case, end)
    lost = int(re.findall(r"Eroded disc: (\d+) points", case.log())[-1])
    table.check(f"{label}: points have gone", lost > 100, lost)
    Theta = of(case, end, "Theta")
    table.row(f"{label}: sum of all fractions, least", 1, Theta.min(), 0.02)
    table.row(f"{label}: sum of all fractions, most", 1, Theta.max(), 0.02)


# --- shock -------------------------------------------------------------------

def slab(name, steps, rho=7800, E=2e11, end=2.5e-3, split=None, n=200, drag=None, **control):
    """A shock of Mach 2 in air meets a slab, 1D; behind it air at rest."""
    g = 1.4
    M = 2.0
    c0 = np.sqrt(g*P0/RHO0)
    p1 = P0*(1 + 2*g/(g + 1)*(M*M - 1))
    rho1 = RHO0*(g + 1)*M*M/((g - 1)*M*M + 2)
    u1 = 2*c0/(g + 1)*(M - 1/M)

    def initial(x, y, z):
        behind = x < 0.3
        return (np.where(behind, rho1, RHO0), np.where(behind, u1, 0.0),
                np.where(behind, p1, P0))
    law = {"type": "linearElastic", "rho": rho, "E": E, "nu": 0}
    phase = {"constitutiveModel": law, **({"drag": drag} if drag else {})}
    case = coupledCase(
        "subSteps", name, (n, 1, 1), (2, 0.01, 0.01), initial, end, {"slab": phase},
        {"slab": {"type": "box", "min": (1, -1, -1), "max": (1.2, 1, 1), "stress": "ambient",
                  "pressure": P0}},
        gas=REAL, ends=OPEN, numerics={"energyBudget": True},
        control={"maxSubSteps": steps, "reportInterval": 1, **control})
    if split:
        case.decompose(split)
        case.runParallel()
    else:
        case.run("materialPointFoam")
    reflected = p1*((3*g - 1)*p1 - (g - 1)*P0)/((g - 1)*p1 + (g + 1)*P0)
    return case, reflected


def velocityOf(case):
    return gasLog(case)["pointMomentum"][-1, 0]/(0.2*1e-4)


def residual(case):
    """All energy without a source, over what the gas has gained beside its boundary."""
    log = case.log()
    wrong = sum(float(re.findall(rf"{name} ([^\s,]+)", log)[-1]) for name in ("remap", "residual"))
    gained, boundary = map(float, re.findall(r"gained (\S+), boundary (\S+),", log)[-1])
    return abs(wrong/(gained - boundary))


def shock(table):
    end = 2.5e-3
    for label, rho, E, most in (("steel", 7800, 2e11, 6), ("light and stiff", 100, 2e10, 17)):
        found = {}
        for steps in (1, 30):
            case, reflected = slab(f"shock-{label.replace(' ', '-')}-{steps}", steps, rho, E)
            found[steps] = velocityOf(case)/rho
            n = max(subSteps(case) or [1])
            name = f"shock on a slab, {label}, up to {n} steps"
            if label == "steel":
                table.row(f"{name}: reflected pressure", reflected, of(case, end, "p")[90],
                          0.005, "relative")
            table.row(f"{name}: energy residual over what is exchanged", 0, residual(case), 1e-3)
        table.row(f"shock on a slab, {label}: steps in one of the gas", most, n, 2)
        table.row(f"shock on a slab, {label}: velocity over that without sub-steps", 1,
                  found[30]/found[1], 0.002)

    # In water: a step of 2 MPa on a thick slab; acoustics of water and slab, before the
    # slab's end is heard
    rho, E, p1, end = 2700.0, 5e11, 2e6, 2.35e-4
    K = 4.4*(6e8 + P0)
    Z0, Zs = np.sqrt(1000*K), np.sqrt(rho*E)
    for steps in (1, 30):
        def initial(x, y, z):
            behind = x < 0.3
            return ([1.0], [1000*(1 + (p1 - P0)/K*behind)], (p1 - P0)/Z0*behind,
                    np.where(behind, p1, P0))
        case = fluidCase("subSteps", f"water-{steps}", (200, 1, 1), (1.0, 0.01, 0.01),
                         {"water": WATER}, initial, end,
                         control={"maxCo": 0.4, "maxSubSteps": steps, "reportInterval": 1})
        law = {"type": "linearElastic", "rho": rho, "E": E, "nu": 0}
        besidePoints(case, {"water": WATER}, {"slab": {"constitutiveModel": law}},
                     {"slab": {"type": "box", "min": (0.6, -1, -1), "max": (1, 1, 1),
                               "stress": "ambient", "pressure": P0}})
        case.run("materialPointFoam")
        n = max(subSteps(case) or [1])
        p = of(case, end, "p")
        table.row(f"step in water on a slab, {n} steps: reflected pressure", 2*Zs/(Zs + Z0),
                  (np.mean(p[112:117]) - P0)/(p1 - P0), 0.005, "relative")


# --- fast --------------------------------------------------------------------

def fast(table):
    """A stiff block at 2 km/s through air at rest sweeps less than a cell in a step of the
    gas: momentum that air gets, as without sub-steps; no fix-ups."""
    end, found = 1.5e-4, {}
    for steps in (1, 30):
        case = coupledCase(
            "subSteps", f"fast-{steps}", (200, 20, 1), (1, 0.1, 0.005),
            lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), end,
            {"block": {"constitutiveModel": {"type": "linearElastic", "rho": 7800, "E": 4e12,
                                             "nu": 0}}},
            {"block": {"type": "box", "min": (0.2, 0.03, -1), "max": (0.3, 0.07, 1),
                       "velocity": (2000, 0, 0), "stress": "ambient", "pressure": P0}},
            numerics={"energyBudget": True},
            control={"maxSubSteps": steps, "reportInterval": 1})
        case.run("materialPointFoam")
        log = gasLog(case)
        found[steps] = log["pointMomentum"][0, 0] - log["pointMomentum"][-1, 0]
        n = max(subSteps(case) or [1])
        table.row(f"block at 2 km/s, {n} steps: theta kept", 0, log["kept"].max(), 0)
        table.row(f"block at 2 km/s, {n} steps: energy residual over what is exchanged", 0,
                  residual(case), 0.01)
    table.check("block at 2 km/s: sub-steps", n > 3, n)
    table.row("block at 2 km/s: momentum lost over that without sub-steps", 1,
              found[30]/found[1], 0.02)


# --- body --------------------------------------------------------------------

def body(table):
    """A piston whose velocity is 20 sin(2 pi 125 t) m/s compresses air in a tube: its place
    is the integral at each step, the pressure that without sub-steps."""
    end, found = 2e-3, {}
    for steps in (1, 20):
        # A block of steel at the other end makes the sub-steps
        case = coupledCase(
            "subSteps", f"piston-{steps}", (100, 1, 1), (1, 0.01, 0.01),
            lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), end,
            {"piston": {"type": "rigid", "rho": 1000,
                        "motion": {"type": "translation", "velocity": {
                            "type": "sine", "frequency": 125, "amplitude": 20,
                            "scale": (1, 0, 0), "level": (0, 0, 0)}}},
             "block": STEEL},
            {"piston": {"type": "box", "min": (0.1, -1, -1), "max": (0.2, 1, 1)},
             "block": {"type": "box", "min": (0.9, -1, -1), "max": (1, 1, 1),
                       "stress": "ambient", "pressure": P0}},
            ends=WALL, control={"maxSubSteps": steps, "reportInterval": 1})
        case.run("materialPointFoam")
        x = case.points(case.timeName(end), "piston")["x"][:, 0]
        n = max(subSteps(case) or [1])
        # Within what a step's trapezoid of the sine has
        table.row(f"piston, {n} steps: way", 20/(2*np.pi*125)*(1 - np.cos(2*np.pi*125*end)),
                  np.mean(x) - 0.15, 1e-5, "relative")
        found[steps] = of(case, end, "p")
    table.check("piston: sub-steps", n > 3, n)
    table.row("piston: pressure before it over that without sub-steps", 1,
              found[20][35]/found[1][35], 1e-3)


# --- walls -------------------------------------------------------------------

def onFloor(name, split=None):
    """A block of steel slides on the floor of a closed box of air, drawn down by gravity."""
    def weigh(case):
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, -1e4, 0)},
                   "uniformDimensionedVectorField")
    libs = "(mpmFunctionObjects)"
    case = coupledCase(
        "subSteps", name, (20, 20, 1), (0.2, 0.2, 0.01),
        lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), 4e-4, {"block": STEEL},
        {"block": {"type": "box", "min": (0.05, -1, -1), "max": (0.13, 0.08, 1),
                   "velocity": (50, 0, 0), "stress": "ambient", "pressure": P0}},
        ends=WALL, sides=WALL, gas=REAL, prepare=weigh, control={
            "maxSubSteps": 20, "reportInterval": 1, "writeInterval": 2e-4, "functions": {
                "sums": {"type": "materialPointBalance", "libs": libs, "writeControl": "timeStep"},
                "walls": {"type": "materialPointPatchForces", "libs": libs,
                          "patches": "(sides)", "writeControl": "timeStep"},
                "gauges": {"type": "blastProbes", "libs": libs, "probeLocations": "((0.18 0.1 0))"},
                "view": {"type": "materialPointVTK", "libs": libs, "columns": "(U sigma)"}}})
    if split:
        case.decompose(split)
        case.runParallel()
    else:
        case.run("materialPointFoam")
    return case


def walls(table):
    for label, split in (("one processor", None), ("two processors", (2, 1, 1))):
        case = onFloor("walls" + label[:3], split)
        n = max(subSteps(case) or [1])
        table.check(f"block on a floor, {label}: steps of the points in one of the gas", n > 3, n)
        rows = case.table("sums/mixture.dat")
        J = np.array([rows[f"J{d}"] for d in "xyz"])
        rest = np.array([rows[f"rest{d}"] for d in "xyz"])
        table.row(f"block on a floor, {label}: rest of the momentum over the impulse", 0,
                  np.max(abs(rest))/np.max(abs(J)), 1e-11, "atMost")
        air, force, t = case.table("sums/air.dat"), case.table("walls/sides.dat"), rows["Time"]
        pushed = np.cumsum(force["Fy"]*np.diff(t, prepend=0))
        # Of the floor on the block, by the momentum of both, gravity and the walls of the air
        other = rows["Py"] - air["Jy"] + 1e4*(rows["mass"]*t)
        table.row(f"block on a floor, {label}: impulse of the block on the floor", 0, np.ptp(
            pushed + other)/np.max(abs(pushed)), 1e-9, "atMost")
    case = onFloor("wallsAgain")
    shutil.rmtree(case.file("postProcessing"))
    case.run("materialPointFoam", "-postProcess")
    found = sorted(len(case.table(f"sums/{name}.dat")["Time"]) for name in ("block", "total"))
    table.check("-postProcess in a gas: rows of the points at all times", found == [3, 3], found)
    table.check("-postProcess: blastProbes writes nothing",
                not os.path.exists(case.file("postProcessing/gauges"))
                and "gauges writes nothing" in case.log(), "")
    files = sorted(os.listdir(case.file("postProcessing/view/points.block")))
    table.check("-postProcess, materialPointVTK with columns: files of all times",
                files == ["0.0002.vtp", "0.0004.vtp", "0.vtp"], files)


# --- restart, ranks ----------------------------------------------------------

FIELDS = ("p", "U.air", "T.air")


def crash(name, steps=20, split=None, before=lambda case: None):
    """A disc that is thrown into air at rest and erodes on its way."""
    end = 5e-4
    return movingDisc(name, steps, split=split, end=end, before=before, writeInterval=end/5,
                      startFrom="latestTime", disc={"velocity": (400.0, 100.0, 0.0)},
                      phase={**STEEL, "erosion": {"type": "outside", "min": (-9, -9, -9),
                                                  "max": (0.78, 9, 9)}})


def restart(table):
    end = 5e-4
    one = crash("restart-one")
    table.check("restart: sub-steps", max(subSteps(one)) > 3, max(subSteps(one)))
    table.check("restart: points have gone", "Eroded disc: 0" not in one.log().splitlines()[-1]
                and "Eroded disc" in one.log(), "")
    for part in (1, 3):
        time = one.timeName(end*part/5)
        again = crash("restart-again",
                      before=lambda case, time=time: shutil.copytree(one.file(time),
                                                                     case.file(time)))
        for f in FIELDS:
            table.row(f"restart from {part}/5: {f}", 0,
                      np.max(abs(of(one, end, f) - of(again, end, f))), 0)
        table.row(f"restart from {part}/5: points", 0, one.largestDifference(
            again, one.timeName(end), ["disc"], ["x", "U", "stress", "damage"]), 0)


def ranks(table):
    end = 5e-4
    one = crash("ranks-1")
    for n, split in ((2, (2, 1, 1)), (3, (1, 3, 1))):
        case = crash(f"ranks-{n}", split=split)
        for f in FIELDS:
            a, b = of(one, end, f), of(case, end, f)
            table.row(f"{n} processors: {f}", 0, np.max(abs(a - b))/np.max(abs(a)), 1e-10)


# --- refused -----------------------------------------------------------------

def refused(table):
    for label, control, words in (
            ("fixed step", {"adjustTimeStep": "no", "maxCo": "none"},
             "maxSubSteps has no effect without adjustTimeStep"),
            ("out of range", {"maxSubSteps": 0}, "maxSubSteps")):
        def change(case, control=control):
            file = case.file("system/controlDict")
            with open(file) as f:
                lines = [l for l in f if l.split()[:1] not in [[w] for w in control]]
            with open(file, "w") as f:
                f.writelines(lines)
                f.writelines(f"{k} {v};\n" for k, v in control.items() if v != "none")
        try:
            movingDisc("refused-" + label.replace(" ", "-"), 3, end=1e-5, before=change)
            table.check(f"refused: {label}", False, "ran")
        except RunFailed as failed:
            table.check(f"refused: {label}", words in str(failed), str(failed)[:200])


if __name__ == "__main__":
    sys.exit(runParts("subSteps", moving, shock, fast, body, walls, restart, ranks, refused))
