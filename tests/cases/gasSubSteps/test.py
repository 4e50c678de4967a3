#!/usr/bin/env python3
"""maxGasSubSteps: several steps of the gas, or of fluids, in one of the points.

    moving      a soft disc moves with air: pressure uniform, momentum and mass kept, on
                boxes, prisms and with water; a light one in water, which limits the step
    shock       a shock of Mach 2 on a soft slab: its velocity by theory and beside the run
                without sub-steps, momentum and energy of both
    body        the same on a rigid body that moves freely
    drag        on dust, by theory
    thrown      a soft disc in air of another velocity: momentum and mass of both, with every
                kind of drag
    times       conditions that know the time, beside the run without sub-steps
    charge      a plate on burning TNT, the same
    bar         a soft bar in closed water: the frequency of its first symmetric mode
    restart     bit by bit
    ranks       2 and 3 processors, 1e-10
    refused     without adjustTimeStep, beside maxSubSteps, out of range
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
from detonations import TNT
from fluidCases import AIR, WATER, besidePoints, fluidCase
from roots import bisection

DISC = {"type": "cylinder", "point1": (0.5, 0.5, -1), "point2": (0.5, 0.5, 1), "radius": 0.2}
P0, RHO0, PINF = 1e5, 1.2, 6e8
BOTH = {"water": WATER, "air": AIR}
V = (80.0, 60.0, 0.0)


def soft(rho, c, **more):
    """A solid in which sound has this speed along a bar."""
    return {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": rho*c*c, "nu": 0},
            **more}


def gasSteps(case):
    """Most steps of the gas in one of the points in the log."""
    return max([int(n) for n in re.findall(r"Steps of the \w+ in this one of the points: (\d+)",
                                           case.log())] or [1])


def movingDisc(name, steps, kind=None, fluids=None, split=None, phase=None, end=1e-3,
               before=lambda case: None, velocity=V, **control):
    """A disc in a gas, or in these fluids (water below), of velocity V."""
    n = 20 if kind else 30
    if kind and not fluids:
        fluids = {"air": AIR}
    cells, high, patches = (n, n, 1), (1, 1, 1/n), cyclicSides("xy")[0]
    control = {"maxCo": 0.3, "maxGasSubSteps": steps, "reportInterval": 1, **control}
    points = dict(phases={"disc": phase or soft(1500, 30)},
                  regions={"disc": {**DISC, "velocity": velocity, "stress": "ambient",
                                    "pressure": P0}},
                  numerics={"shapeFunction": "nodeDual"} if kind else None)
    if fluids:
        def initial(x, y, z):
            a = 1.0*(y < 0.5)
            return ([a, 1 - a] if len(fluids) > 1 else [1.0], [1000.0, RHO0][-len(fluids):],
                    np.tile(V, (len(x), 1)), P0)
        case = fluidCase("gasSubSteps", name, cells, high, fluids, initial, end, patches=patches,
                         reconstruct=UPWIND, kind=kind, control=control)
        besidePoints(case, fluids, **points)
    else:
        case = coupledCase("gasSubSteps", name, cells, high,
                           lambda x, y, z: (RHO0 + 0*x, np.tile(V, (len(x), 1)), P0 + 0*x), end,
                           patches=patches, gas={}, control=control, **points)
    before(case)
    if split:
        case.decompose(split)
        case.runParallel()
    else:
        case.run("materialPointFoam")
    return case


def of(case, end, name):
    """A field of all cells; U.air is U of fluids."""
    if name == "U.air" and os.path.isdir(case.file("0")) and os.path.isfile(case.file("0/U")):
        name = "U"
    return volField(case, f"{end:g}" if case.processors() else case.timeName(end), name)


def balances(case):
    """Mass and momentum of the gas, or of the one fluid, and momentum of the points."""
    log = case.log()
    start = r"^(?:Gas air: mass|Fluids: mass air) "
    mass = [float(m) for m in re.findall(start + r"([-\d.e+]+),", log, re.M)]
    momentum, points = (np.array([m.split() for m in re.findall(begin + r".*momentum \(([^)]*)\)",
                                                                log, re.M)], float)
                        for begin in (start, r"^Material points: "))
    return np.array(mass), momentum, points


def kept(table, label, case, scale):
    """Momentum and mass of gas and points together."""
    mass, momentum, points = balances(case)
    total = momentum + points
    table.row(f"{label}: change of momentum", 0, np.max(abs(total - total[0]))/scale, 1e-12)
    table.row(f"{label}: change of the gas' mass", 0, np.ptp(mass)/mass[0], 1e-12)


def moving(table):
    air, wet, end = {"air": AIR}, BOTH, 2e-3
    for label, kind, fluids, phase, least, most in (
            ("air, boxes", None, None, soft(1500, 30), 4, 100),
            ("air, prisms", "prisms", air, soft(1500, 30), 4, 100),
            ("water and air, boxes", None, wet, soft(7800, 30), 4, 100),
            ("water and air, prisms", "prisms", wet, soft(7800, 30), 4, 100),
            ("water and air, light, boxes", None, wet, soft(100, 30), 1, 2)):
        name = "disc moves with " + label
        case = movingDisc("moving-" + label.replace(" ", "-").replace(",", ""), 100, kind,
                          fluids, phase=phase, end=end)
        p, U = of(case, end, "p"), of(case, end, "U" if fluids else "U.air")
        table.row(f"{name}: dP/(P + pInf)", 0,
                  np.max(abs(p - P0))/(P0 + (PINF if fluids == wet else 0)), 1e-12)
        table.row(f"{name}: dU/U", 0, np.max(abs(U - V))/np.max(np.abs(V)), 1e-10)
        n = gasSteps(case)
        table.check(f"{name}: steps of the gas in one of the points", least <= n <= most, n)
        if fluids != wet:
            kept(table, name, case, np.max(abs(balances(case)[1][0])))


# --- shock -------------------------------------------------------------------

END, START, THICK = 2.5e-3, 0.3, 0.2


def slab(name, steps, phase, n=400, region=None, **numerics):
    """A shock of Mach 2 in air meets a slab, 1D; behind it air at rest."""
    g, M = 1.4, 2.0
    c0 = np.sqrt(g*P0/RHO0)
    p1 = P0*(1 + 2*g/(g + 1)*(M*M - 1))
    rho1 = RHO0*(g + 1)*M*M/((g - 1)*M*M + 2)
    u1 = 2*c0/(g + 1)*(M - 1/M)

    def initial(x, y, z):
        behind = x < START
        return (np.where(behind, rho1, RHO0), np.where(behind, u1, 0.0),
                np.where(behind, p1, P0))
    case = coupledCase(
        "gasSubSteps", name, (n, 1, 1), (2, 0.01, 0.01), initial, END, {"slab": phase},
        {"slab": {"type": "box", "min": (1, -1, -1), "max": (1 + THICK, 1, 1),
                  **({"stress": "ambient", "pressure": P0} if region is None else region)}},
        gas={}, ends=OPEN, numerics={"energyBudget": True, **numerics},
        control={"maxGasSubSteps": steps, "reportInterval": 1, "maxCo": 0.8})
    case.run("materialPointFoam")
    pr = p1*((3*g - 1)*p1 - (g - 1)*P0)/((g - 1)*p1 + (g + 1)*P0)
    ratio = ((g + 1)*pr + (g - 1)*p1)/((g - 1)*pr + (g + 1)*p1)
    return case, {"p": pr, "Z": np.sqrt(g*pr*rho1*ratio), "hit": (1 - START)/(M*c0)}


def residual(case):
    """All energy without a source, over what the gas has gained beside its boundary."""
    log = case.log()
    wrong = sum(float(re.findall(rf"{name} ([^\s,]+)", log)[-1]) for name in ("remap", "residual"))
    gained, boundary = map(float, re.findall(r"gained (\S+), boundary (\S+),", log)[-1])
    return abs(wrong/(gained - boundary))


def shock(table):
    for label, rho, c, least in (("7800 kg/m3", 7800, 300, 5), ("1000 kg/m3", 1000, 300, 4)):
        found = {}
        for steps in (1, 30):
            case, shocked = slab(f"shock-{rho}-{steps}", steps, soft(rho, c))
            found[steps] = gasLog(case)["pointMomentum"][-1, 0]/(rho*THICK*1e-4)
            n = gasSteps(case)
            name = f"shock on a slab of {label}, up to {n} steps"
            if rho == 7800:
                # Acoustics of slab and gas, before the wave in the slab is back
                force = (shocked["p"] - P0)/(1 + shocked["Z"]/(rho*c))
                table.row(f"{name}: velocity", force/(rho*THICK)*(END - shocked["hit"]),
                          found[steps], 0.003, "relative")
            table.row(f"{name}: energy residual over what is exchanged", 0, residual(case), 2e-3)
            table.row(f"{name}: theta kept", 0, gasLog(case)["kept"].max(), 0)
        table.check(f"shock on a slab of {label}: steps of the gas in one", n >= least, n)
        table.row(f"shock on a slab of {label}: velocity over that without sub-steps", 1,
                  found[30]/found[1], 0.001)


# --- body --------------------------------------------------------------------

def body(table):
    found, rho = {}, 1000
    for steps in (1, 10):
        case, _ = slab(f"body-{steps}", steps,
                       {"type": "rigid", "rho": rho, "motion": {"type": "free"}}, n=200, region={})
        found[steps] = case.points(case.timeName(END), "slab")["U"][:, 0].mean()
        n = gasSteps(case)
    table.check("shock on a free body: steps of the gas in one", n >= 4, n)
    table.row("shock on a free body: velocity over that without sub-steps", 1,
              found[10]/found[1], 0.002)


# --- drag --------------------------------------------------------------------

def drag(table):
    """Solid and gas in a periodic box take one velocity: the difference falls by
    exp(-K (1/m_g + 1/m_s) t), m the masses per volume."""
    rho, share, eps, K, u = 100.0, 0.3, 0.01, 230.0, 10.0
    solid = (1 - eps)*share
    # Mass of the gas as the solver makes it: what the fractions leave
    mg, ms, end = RHO0*(1 - solid), rho*share, 4e-3
    for kind in (None, "prisms"):
        for steps in (1, 30):
            n = 10
            phase = soft(rho, 30, drag={"type": "constant", "value": K/(solid*(1 - solid))})
            box = {"type": "box", "min": (-1, -1, -1), "max": (2, 2, 2), "volumeFraction": share,
                   "velocity": (u, 0, 0), "stress": "ambient", "pressure": P0}
            control = {"maxCo": 0.3, "maxGasSubSteps": steps, "reportInterval": 1}
            name, cells, high = f"drag-{kind}-{steps}", (n, n, 1), (1, 1, 1/n)
            patches = cyclicSides("xy")[0]
            if kind:
                case = fluidCase("gasSubSteps", name, cells, high, {"air": AIR},
                                 lambda x, y, z: ([1.0], [RHO0], 0.0, P0), end, patches=patches,
                                 reconstruct=UPWIND, kind=kind, control=control)
                besidePoints(case, {"air": AIR}, {"dust": phase}, {"dust": box},
                             numerics={"shapeFunction": "nodeDual"})
            else:
                case = coupledCase("gasSubSteps", name, cells, high,
                                   lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), end,
                                   {"dust": phase}, {"dust": box}, patches=patches, gas={},
                                   control=control)
            case.run("materialPointFoam")
            k = gasSteps(case)
            name = f"drag on dust, {kind or 'boxes'}, up to {k} steps"
            table.row(f"{name}: velocity of the gas",
                      u*ms/(mg + ms)*(1 - np.exp(-K*(1/mg + 1/ms)*end)),
                      np.mean(of(case, end, "U.air")[:, 0]), 0.01, "relative")
        table.check(f"drag on dust, {kind or 'boxes'}: steps of the gas in one", k >= 4, k)


# --- thrown ------------------------------------------------------------------

def thrown(table):
    for kind in (None, "prisms"):
        for label, given in (("stick", None), ("slip", {"type": "stick", "direction": "normal"}),
                             ("none", {"type": "none"}),
                             ("Gidaspow", {"type": "Gidaspow", "d": 1e-3})):
            found = {}
            for steps in (1, 20):
                case = movingDisc(f"thrown-{kind}-{label}-{steps}", steps, kind, end=2e-3,
                                  velocity=(-40.0, 10.0, 0.0), before=viscous,
                                  phase=soft(1500, 60, **({"drag": given} if given else {})))
                points = balances(case)[2]
                change = points - points[0]
                found[steps] = change[-1, 0]
                n = gasSteps(case)
            name = f"disc in air, {kind or 'boxes'}, drag {label}, {n} steps"
            # The sum over the 484 points, 250 N s, rounds by 1e-12 N s from the first report
            # on and no more later; drag none exchanges 0.9 N s
            kept(table, name, case, max(np.max(abs(change)), 1e-2*np.max(abs(points))))
            table.row(f"{name}: momentum exchanged over that without", 1, found[20]/found[1], 0.02)


def viscous(case):
    """A viscosity, which laws of drag need."""
    file = case.file("constant/phaseProperties")
    with open(file) as f:
        text = f.read()
    name = "fluids" if "fluids" in text else "air"
    with open(file, "w") as f:
        f.write(text.replace(f"\n{name}\n{{", f"\n{name}\n{{\n    mu 1.8e-5;", 1))


# --- times ------------------------------------------------------------------

def times(table):
    """Conditions that know the time: a pulse leaves through waveTransmissive, which keeps old
    values; air is blown in by a table of time. A soft block at the other end makes the steps."""
    end, found = 3e-3, {}
    out = {"type": "waveTransmissive", "gamma": 1.4, "phi": "phi.air", "psi": "psi.air",
           "rho": "rho.air", "fieldInf": P0, "lInf": 10}
    for label in ("pulse that leaves", "air by a table"):
        for steps in (1, 30):
            pulse = 0.05 if "pulse" in label else 0.0
            c = np.sqrt(1.4*P0/RHO0)

            def initial(x, y, z):
                # To the left alone
                d = pulse*np.exp(-((x - 0.4)/0.05)**2)
                return RHO0*(1 + d/1.4), -d*c/1.4, P0*(1 + d)
            left = ((out, "zeroGradient", "zeroGradient") if pulse else
                    ("zeroGradient", {"type": "fixedValue", "value": f"uniform {P0/RHO0!r}"},
                     {"type": "uniformFixedValue",
                      "uniformValue": "table ((0 (0 0 0)) (1.5e-3 (20 0 0)) (1 (20 0 0)))"}))
            case = coupledCase(
                "gasSubSteps", f"times-{'pulse' if pulse else 'table'}-{steps}", (200, 1, 1),
                (1, 0.01, 0.01), initial, end, {"block": soft(1500, 30)},
                {"block": {"type": "box", "min": (0.9, -1, -1), "max": (1, 1, 1),
                           "stress": "ambient", "pressure": P0}}, gas={}, ends=left,
                patches={"ends": ("patch", ("x-",)), "wall": ("wall", ("x+",))},
                conditions={"wall": WALL}, control={"maxCo": 0.3, "maxGasSubSteps": steps, "reportInterval": 1})
            case.run("materialPointFoam")
            found[steps], n = of(case, end, "p"), gasSteps(case)
        scale = 0.05*P0 if pulse else np.ptp(found[1])
        table.check(f"{label}: steps of the gas in one", n >= 4, n)
        table.row(f"{label}: difference of p from that without sub-steps, over the wave", 0,
                  np.max(abs(found[30] - found[1])[:170])/scale, 0.01)


# --- charge ------------------------------------------------------------------

def charge(table):
    """The plate on TNT of the test detonation: the burn follows the time of each step."""
    n, length, thick, high, end = 600, 0.6, 0.01, 0.05, 1.5e-4
    fluids = {"charge": {**TNT, "detonation": {"type": "programmedBurn", "velocity": 6930.0,
                                               "points": [(0, 0, 0)]}},
              "air": {**AIR, "R": 287}}
    found = {}
    for steps in (1, 10):
        case = fluidCase("gasSubSteps", f"charge-{steps}", (n, 1, 1),
                         (length, length/n, length/n), fluids,
                         lambda x, y, z: ([1.0*(x < high), 1.0*(x > high)], [1630.0, 1.2], 0.0,
                                          P0), end, ends=WALL,
                         control={"maxCo": 0.3, "deltaT": 1e-9, "reportInterval": 1,
                                  "maxGasSubSteps": steps})
        besidePoints(case, fluids, {"plate": {"constitutiveModel": {
            "type": "NewtonianFluid", "mu": 1e-3, "rho": 2785, "equationOfState": {
                "type": "MieGrueneisen", "C0": 5328, "S": 1.338, "Gamma0": 2}}}},
                     {"plate": {"type": "box", "min": (high, -1, -1),
                                "max": (high + thick, 1, 1), "pointsPerCell": 2}},
                     numerics={"energyBudget": True})
        case.run("materialPointFoam")
        log = case.log()
        speed = [float(v) for v in re.findall(r"^Material points: .*momentum \((\S+)", log, re.M)]
        found[steps] = speed[-1]/(2785*thick*(length/n)**2), residual(case)
        m = [float(v) for v in re.findall(r"^Fluids: mass charge (\S+)", log, re.M)]
        k = gasSteps(case)
        table.row(f"plate on TNT, up to {k} steps: mass of TNT, late over early", 1, m[-1]/m[0],
                  1e-13)
    table.check("plate on TNT: steps of the fluids in one", k >= 2, k)
    table.row("plate on TNT: velocity over that without sub-steps", 1,
              found[10][0]/found[1][0], 0.002)
    table.row("plate on TNT: energy residual over that without sub-steps", 1,
              found[10][1]/found[1][1], 0.2)


# --- bar ---------------------------------------------------------------------

def crossings(t, q):
    """Times at which q passes 0 downwards."""
    i = np.flatnonzero((q[:-1] > 0) & (q[1:] <= 0))
    return t[i] + (t[i + 1] - t[i])*q[i]/(q[i] - q[i + 1])


def bar(table):
    """As the part bar of wavesInFluids, in one piece."""
    a, b, rho, E, dp, n = 0.1, 0.4, 2700.0, 1e7, 1e4, 200
    sound, cs = np.sqrt(4.4*(P0 + PINF)/1000), np.sqrt(E/rho)
    Zs, Zw = rho*cs, 1000*sound

    def mode(w):
        return (Zw*np.sin(w*a/cs)*np.cos(w*b/sound) + Zs*np.cos(w*a/cs)*np.sin(w*b/sound))
    first = np.pi*min(cs/a, sound/b)
    w = bisection(mode, 0.01*first, 0.999*first)
    end, inBar = 2.6*2*np.pi/w, np.cos(w*a/cs)

    def initial(x, y, z):
        d = np.maximum(abs(x - 0.5) - a, 0)
        p = P0 + dp*np.where(d > 0, inBar*np.cos(w*(b - d)/sound)/np.cos(w*b/sound), inBar)
        return [1.0], [1000*((p + PINF)/(P0 + PINF))**(1/4.4)], 0.0, p
    found = {}
    for steps in (1, 20):
        case = fluidCase("gasSubSteps", f"bar-{steps}", (n, 1, 1), (1, 0.01, 0.01),
                         {"water": WATER}, initial, end, ends=WALL, maxCoGas=0.3,
                         control={"maxCo": 0.8, "deltaT": 1e-9, "maxGasSubSteps": steps,
                                  "reportInterval": 1},
                         writeInterval=end/104)
        edges = np.linspace(0.5 - a, 0.5 + a, n//10 + 1)
        regions = {
            f"piece{i}": {"phase": "bar", "type": "box", "min": (low, -1, -1),
                          "max": (high, 1, 1), "stress": "ambient",
                          "pressure": P0 + dp*np.cos(w*abs(0.5*(low + high) - 0.5)/cs)}
            for i, (low, high) in enumerate(zip(edges[:-1], edges[1:]))}
        law = {"type": "linearElastic", "rho": rho, "E": E, "nu": 0}
        besidePoints(case, {"water": WATER}, {"bar": {"constitutiveModel": law}}, regions)
        case.run("materialPointFoam")
        times = [s for s in case.times() if float(s) > 0]
        q = []
        for s in times:
            points = case.points(s, "bar")
            x = points["x"][:, 0]
            q.append(-np.mean((points["sigma"][:, 0] + P0)*np.cos(w*abs(x - 0.5)/cs)))
        found[steps] = 1/np.mean(np.diff(crossings(np.array([float(s) for s in times]),
                                                   np.array(q))))
        k = gasSteps(case)
        table.row(f"soft bar in water, up to {k} steps: frequency of its first symmetric mode",
                  w/(2*np.pi), found[steps], 1/40, "relative")
    table.check("soft bar in water: steps of the water in one", k >= 2, k)
    table.row("soft bar in water: frequency over that without sub-steps", 1,
              found[20]/found[1], 0.005)


# --- restart, ranks ----------------------------------------------------------

FIELDS = ("p", "U.air", "T.air")


def crash(name, steps=20, split=None, kind=None, before=lambda case: None):
    """A soft disc at rest in moving air, which erodes behind a line."""
    end = 2e-3
    return movingDisc(name, steps, split=split, end=end, before=before, writeInterval=end/2,
                      startFrom="latestTime", velocity=(-40.0, 10.0, 0.0), kind=kind,
                      phase=soft(300, 60, erosion={"type": "outside", "min": (0.32, -9, -9),
                                                   "max": (9, 9, 9)}))


def restart(table):
    end = 2e-3
    for kind in (None, "prisms"):
        label = "restart" + (" on prisms" if kind else "")
        name = "restart" + ("-prisms" if kind else "")
        one = crash(name + "-one", kind=kind)
        table.check(f"{label}: sub-steps", gasSteps(one) > 3, gasSteps(one))
        half = one.timeName(end/2)
        table.check(f"{label}: something is owed",
                    any(os.path.isfile(one.file(f"{half}/owedPressure.{w}")) for w in ("air", "fluids")), "")
        table.check(f"{label}: points have gone",
                    int(re.findall(r"Eroded disc: (\d+) points", one.log())[-1]) > 10, "")
        again = crash(name + "-again", kind=kind,
                      before=lambda case: shutil.copytree(one.file(half), case.file(half)))
        for f in FIELDS:
            table.row(f"{label}: {f}", 0, np.max(abs(of(one, end, f) - of(again, end, f))), 0)
        table.row(f"{label}: points", 0,
                  one.largestDifference(again, one.timeName(end), ["disc"],
                                        ["x", "U", "stress", "damage"]), 0)
        rebuilt = crash(name + "-rebuilt", kind=kind, before=lambda case: setControl(
            case, {"rebuildInterval": 7}))
        for f in FIELDS[:2]:
            table.row(f"{label}: built again every 7 steps, {f}", 0,
                      np.max(abs(of(one, end, f) - of(rebuilt, end, f))), 0)


def ranks(table):
    end = 2e-3
    for kind in (None, "prisms"):
        one = crash(f"ranks-{kind}-1", kind=kind)
        for n, split in ((2, (2, 1, 1)), (3, (1, 3, 1))):
            case = crash(f"ranks-{kind}-{n}", split=split, kind=kind)
            for f in FIELDS:
                a, b = of(one, end, f), of(case, end, f)
                table.row(f"{n} processors, {kind or 'boxes'}: {f}", 0,
                          np.max(abs(a - b))/np.max(abs(a)), 1e-10)


# --- refused -----------------------------------------------------------------

def setControl(case, control):
    file = case.file("system/controlDict")
    with open(file) as f:
        lines = [l for l in f if l.split()[:1] not in [[w] for w in control]]
    with open(file, "w") as f:
        f.writelines(lines)
        f.writelines(f"{k} {v};\n" for k, v in control.items() if v != "none")


def refused(table):
    for label, control, words in (
            ("fixed step", {"adjustTimeStep": "no", "maxCo": "none"},
             "maxGasSubSteps has no effect without adjustTimeStep"),
            ("both", {"maxSubSteps": 3}, "one of them may be greater than 1"),
            ("out of range", {"maxGasSubSteps": 0}, "maxGasSubSteps")):
        try:
            movingDisc("refused-" + label.replace(" ", "-"), 3, end=1e-5,
                       before=lambda case: setControl(case, control))
            table.check(f"refused: {label}", False, "ran")
        except RunFailed as failed:
            table.check(f"refused: {label}", words in " ".join(str(failed).split()),
                        str(failed)[:200])

    # A restart with the other way of sub-steps
    one = crash("refused-mixed-one")
    half = one.timeName(1e-3)

    def before(case):
        shutil.copytree(one.file(half), case.file(half))
        setControl(case, {"maxGasSubSteps": 1, "maxSubSteps": 5, "maxCo": 0.01})
    try:
        crash("refused-mixed", before=before)
        table.check("refused: owed from a run with sub-steps of the gas", False, "ran")
    except RunFailed as failed:
        table.check("refused: owed from a run with sub-steps of the gas",
                    "was written with maxGasSubSteps" in " ".join(str(failed).split()),
                    str(failed)[:200])


if __name__ == "__main__":
    sys.exit(runParts("gasSubSteps", moving, shock, body, drag, thrown, times, charge, bar, restart, ranks, refused))
