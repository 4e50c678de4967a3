#!/usr/bin/env python3
"""Detonation of fluids: fronts of given speed and a rate by the pressure, against exact
plane detonations (tests/lib/detonations.py).

A plane charge of TNT, 200 mm, is lit at a wall: speed of the front, wave of Taylor behind
it, at 200, 400 and 800 cells. A closed box conserves mass and energy. Two points at
different times, a line and a plane burn where their fronts have been. A disc and an
eighth of a sphere in air stay symmetric. QM-100 with the rate of JWL++ finds the speed of
Chapman and Jouguet by itself. A moving charge takes its burn fraction along. A plate of
points on a charge gets Gurney's velocity. Processors, restart in the middle of the burn,
wrong input. tutorials/tntInAir against Kingery and Bulmash's fits.
"""

import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from detonations import QM100, QM100_RATE, TNT, PlaneDetonation, energyOf, jwlOf
from fluidCases import WATER, besidePoints, fluidCase, fluidField, shareFile
from foamCase import FoamCase, PROJECT, RunFailed, runParts
from gasCases import WALL, boxCentres, volField
from gasOnCells import cyclicSides
from riemannEquation import JWL

D = 6930.0
AIR = {"thermo": "perfectGas", "R": 287, "gamma": 1.4}
CLOSED = {"ends": WALL, "sides": WALL}


def lit(fluid=TNT, **entries):
    """A fluid that detonates, by default from the origin."""
    if "type" not in entries:
        entries = {"type": "programmedBurn", "velocity": D, **entries}
        if not {"points", "lines", "planes"} & set(entries):
            entries["points"] = [(0, 0, 0)]
    return {**fluid, "detonation": entries}


def tube(name, n, end, fluid, rho=1630.0, length=0.2, **options):
    case = fluidCase("detonation", name, (n, 1, 1), (length, length/n, length/n),
                     {"charge": fluid}, lambda x, y, z: ([1.0], [rho], 0.0, 1e5), end,
                     **CLOSED, **options)
    case.run("materialPointFoam")
    return case


# --- plane charge ------------------------------------------------------------

def plane(table):
    exact = PlaneDetonation(jwlOf(TNT), energyOf(TNT))
    table.row("TNT: speed of Chapman and Jouguet, published 6930 m/s", 6930, exact.D, 2e-3,
              "relative")
    for name, jwl, E0, speed in (
            ("C4", JWL(609.77e9, 12.95e9, 4.5, 1.4, 0.25, 1601), 9e9, 8193),
            ("PETN", JWL(617e9, 16.926e9, 4.4, 1.2, 0.25, 1770), 10.1e9, 8300)):
        table.row(f"{name}: speed of Chapman and Jouguet, published {speed} m/s", speed,
                  PlaneDetonation(jwl, E0/jwl.rho0).D, 2e-3, "relative")
    length, end, errors = 0.2, 0.16/D, {}
    for n, limits in ((200, (0.006, 0.08)), (400, (0.003, 0.06)), (800, (0.0015, 0.04))):
        case = tube(f"plane-{n}", n, end, lit(), writeInterval=end/2)
        x = (np.arange(n) + 0.5)*length/n
        p, F = fluidField(case, end, "p"), fluidField(case, end, "F.charge")
        u = fluidField(case, end, "U")[:, 0]
        at = [np.sum(fluidField(case, t, "F.charge"))*length/n for t in (end/2, end)]
        uExact, pExact = exact.at(x/end)
        errors[n] = np.mean(abs(p - pExact))/exact.p
        label = f"plane charge of TNT, {n} cells"
        table.row(f"{label}: speed of the front [m/s]", D, (at[1] - at[0])/(end/2), 1e-2,
                  "relative")
        shock = x[np.where(p > 0.5*p.max())[0][-1]] + 0.5*length/n
        table.row(f"{label}: place of the pressure's front [cells]", D*end*n/length,
                  shock*n/length, 1.5)
        table.row(f"{label}: L1 of p over p_CJ", 0, errors[n], limits[0], "atMost")
        table.row(f"{label}: L1 of u over u_CJ", 0, np.mean(abs(u - uExact))/exact.u,
                  1.2*limits[0], "atMost")
        table.row(f"{label}: largest pressure over p_CJ", 1, p.max()/exact.p, limits[1])
        table.row(f"{label}: pressure at the wall", exact.wall, p[0], 2e-3, "relative")
        inner = (x/end > 0.1*D) & (x/end < 0.9*D)
        table.row(f"{label}: largest error of p between 0.1 and 0.9 of the way, over p_CJ", 0,
                  np.max(abs(p - pExact)[inner])/exact.p, 3*limits[0], "atMost")
        behind = x < D*end - 2*length/n
        table.row(f"{label}: least burn fraction behind the front", 1, F[behind].min(), 0)
        table.row(f"{label}: largest ahead", 0, F[x > D*end + 2*length/n].max(), 1e-9)
    table.row("plane charge of TNT: order of L1 of p from 200 to 800 cells", 0.9,
              np.log2(errors[200]/errors[800])/2, 0.9, "atLeast")


def travelling(table):
    """A charge that moves with 800 m/s, lit in its middle: the same waves, carried along."""
    exact = PlaneDetonation(jwlOf(TNT), energyOf(TNT))
    n, length, U0, end = 400, 0.4, 800.0, 0.12/D
    for label, moving in (("moving", U0), ("at rest", 0.0)):
        case = fluidCase(
            "detonation", f"travelling-{moving:g}", (n, 1, 1), (length, 0.001, 0.001),
            {"charge": lit(points=[(0.2, 0, 0)], moving=(moving, 0, 0))},
            lambda x, y, z, moving=moving: ([1.0], [1630.0], moving, 1e5), end,
            control={"deltaT": 1e-10})
        case.run("materialPointFoam")
        x = (np.arange(n) + 0.5)*length/n - 0.2 - moving*end
        _, pExact = exact.at(abs(x)/end)
        p = fluidField(case, end, "p")
        table.row(f"charge {label}, 120 cells each way: L1 of p over p_CJ", 0,
                  np.mean(abs(p - pExact)[abs(x) < 0.13])/exact.p, 0.012, "atMost")
        F = fluidField(case, end, "F.charge")
        table.row(f"charge {label}: burnt length [m]", 2*D*end, np.sum(F)*length/n, 1e-2,
                  "relative")


def conservation(table):
    """All of it burns in a closed box; e at the start is q + p0/(omega rho0)."""
    n, length = 100, 0.2
    for label, fluid in (("from one end", lit()),
                         ("from two points and a plane, in turn", lit(
                             points=[(0.05, 0, 0), (0.15, 0, 0)],
                             planes=[[(0.1, 0, 0), (1, 0, 0)]], times=[0, 2e-6, 5e-6]))):
        end = 2*length/D
        case = tube("closed", n, end, fluid)
        E = fluidField(case, end, "thetaRhoE").mean()
        table.row(f"closed box, lit {label}: energy", 7e9 + 1e5/0.3, E, 1e-12, "relative")
        table.row(f"closed box, lit {label}: mass", 1630,
                  fluidField(case, end, "thetaRho.charge").mean(), 1e-13, "relative")
        table.row(f"closed box, lit {label}: least burn fraction", 1,
                  fluidField(case, end, "F.charge").min(), 0)


# --- where it burns ----------------------------------------------------------

def places(table):
    """Burnt by half where the formula says so, but for the cells of the front."""
    n, length, end = 50, 0.2, 0.07/D
    wide = {"points": ([(0.05, 0.05, 0), (0.15, 0.16, 0)],
                       lambda x, y: [np.hypot(x - 0.05, y - 0.05),
                                     np.hypot(x - 0.15, y - 0.16) + D*4e-6],
                       {"times": [0, 4e-6]}),
            "lines": ([[(0.05, 0.05, 0), (0.05, 0.15, 0)]],
                      lambda x, y: [np.hypot(x - 0.05, y - np.clip(y, 0.05, 0.15))], {}),
            "planes": ([[(0.1, 0.1, 0), (1, 1, 0)]],
                       lambda x, y: [abs(x - 0.1 + y - 0.1)/np.sqrt(2) + D*3e-6],
                       {"time": 3e-6})}
    x, y, _ = boxCentres((0, 0, 0), (length, length, length/n), (n, n, 1))
    for kind, (sources, distances, more) in wide.items():
        case = fluidCase("detonation", f"places-{kind}", (n, n, 1), (length, length, length/n),
                         {"charge": lit(**{kind: sources}, **more)},
                         lambda x, y, z: ([1.0], [1630.0], 0.0, 1e5), end, **CLOSED)
        case.run("materialPointFoam")
        F = fluidField(case, end, "F.charge")
        ahead = D*end - np.min(distances(x, y), axis=0)
        h = length/n
        table.check(f"{kind}: some is burnt and some is not",
                    0.1 < F.mean() < 0.9, F.mean())
        table.row(f"{kind}: cells that differ from the formula, two cells off the front", 0,
                  np.sum((F < 1)[ahead > 2*h]) + np.sum((F > 1e-6)[ahead < -2*h]), 0)


def discCase(name, n, end, split=None, control=None, before=lambda case: None, dims=2,
             fluid=None):
    """A disc, or an eighth of a sphere in a corner, in air; radius 0.3 of the box."""
    length = 0.125
    high = (length, length, length if dims == 3 else length/n)
    cells = (n, n, n if dims == 3 else 1)
    low = (0, 0, 0) if dims == 3 else (-length, -length, 0)
    if dims == 2:
        cells = (2*n, 2*n, 1)

    def initial(x, y, z):
        r2 = x**2 + y**2 + (z**2 if dims == 3 else 0)
        a = np.clip((0.3*length - np.sqrt(r2))*n/length + 0.5, 0, 1)
        return [a, 1 - a], [1630.0, 1.2], 0.0, 1e5
    patches = {"ends": ("patch", ("x-", "x+") + (("z-", "z+") if dims == 3 else ())),
               "sides": ("patch", ("y-", "y+"))}
    case = fluidCase("detonation", name, cells, high, {"charge": fluid or lit(), "air": AIR},
                     initial, end, low=low, patches=patches, control=control, **CLOSED)
    case.solve(split, before)
    return case


def symmetric(table):
    n, end = 32, 1.2e-5
    case = discCase("disc", n, end)
    p = fluidField(case, end, "p").reshape(2*n, 2*n)
    for label, other in (("mirrored in x", p[:, ::-1]), ("mirrored in y", p[::-1]),
                         ("transposed", p.T)):
        table.row(f"disc of TNT in air, {label}: difference of p over its largest", 0,
                  np.max(abs(p - other))/p.max(), 1e-12)
    x, y, _ = boxCentres((-0.125, -0.125, 0), (0.125, 0.125, 0.1), (2*n, 2*n, 1))
    behind = np.hypot(x, y) < D*end - 0.01
    table.row("disc of TNT in air: least burn fraction where the front has been", 1,
              fluidField(case, end, "F.charge")[behind].min(), 0)
    n, end = 20, 1e-5
    case = discCase("sphere", n, end, dims=3)
    p = fluidField(case, end, "p").reshape(n, n, n)
    for axes in ((1, 0, 2), (2, 1, 0), (0, 2, 1)):
        table.row(f"corner charge, axes {axes}: difference of p over its largest", 0,
                  np.max(abs(p - p.transpose(axes)))/p.max(), 1e-12)


def inAir(table):
    """Energy and mass of a disc with the air around it, in a closed box."""
    n, end = 32, 1.2e-5
    for time in (0, 1):
        case = discCase("disc", n, end, fluid=lit(time=time))
        alpha = np.clip(0.3*n - n/0.125*np.hypot(*boxCentres(
            (-0.125, -0.125, 0), (0.125, 0.125, 0.1), (2*n, 2*n, 1))[:2]) + 0.5, 0, 1)
        label = "disc of TNT in air" + (", not yet lit" if time else "")
        start = np.mean(alpha*(7e9 + 1e5/0.3) + (1 - alpha)*1e5/0.4)
        log = case.log()
        table.row(f"{label}: energy", start, fluidField(case, end, "thetaRhoE").mean(), 1e-12,
                  "relative")
        table.row(f"{label}: mass of TNT", 1630*alpha.mean(),
                  fluidField(case, end, "thetaRho.charge").mean(), 1e-13, "relative")
        table.row(f"{label}: mass of air", 1.2*(1 - alpha).mean(),
                  fluidField(case, end, "thetaRho.air").mean(), 1e-13, "relative")
        table.check(f"{label}: nothing was put right", "pressure of relaxation kept 0" in log)
        if time:
            table.row(f"{label}: largest velocity [m/s]", 0,
                      np.max(abs(fluidField(case, end, "U"))), 1e-8)
            table.row(f"{label}: change of the pressure [Pa]", 0,
                      np.max(abs(fluidField(case, end, "p") - 1e5)), 1e-4)


# --- rate by the pressure ----------------------------------------------------

def rate(table):
    """From a booster of 20 mm; the length of the reaction D/(G p_CJ) is 6 mm."""
    exact = PlaneDetonation(jwlOf(QM100), energyOf(QM100))
    e = QM100["equationOfState"]
    v = QM100["rho"]/exact.rho
    C = (exact.p - e["A"]*np.exp(-e["R1"]*v) - e["B"]*np.exp(-e["R2"]*v))*v**1.3
    table.row("QM-100: constant C of the isentrope, published 5.06568e8 Pa", 5.06568e8, C, 1e-3,
              "relative")
    length = 1.2
    end = 0.85*length/exact.D
    for n, limit in ((600, 0.01), (1200, 0.005)):
        case = tube(f"rate-{n}", n, end, lit(QM100, **QM100_RATE, booster={
            "points": [(0, 0, 0)], "velocity": exact.D, "radius": 0.02}), 1260.0, length,
            writeInterval=end/10)
        h, at = length/n, []
        x = (np.arange(n) + 0.5)*h
        for t in (0.7*end, end):
            p = fluidField(case, t, "p")
            i = np.where(p > 0.3*exact.p)[0][-1]
            at.append(x[i] + h*(p[i] - 0.3*exact.p)/(p[i] - p[i + 1]))
        label = f"QM-100, cells of {1e3*h:g} mm"
        table.row(f"{label}: speed of the front over that of Chapman and Jouguet", 1,
                  (at[1] - at[0])/(0.3*end)/exact.D, limit)
        # Behind the reaction: wave of Taylor, whose start the run-up has shifted
        uExact, pExact = exact.at(x/end)
        inner = (x > 0.1*length) & (x < at[1] - 0.1)
        table.row(f"{label}: error of p behind the reaction over p_CJ, mean", 0,
                  np.mean(abs(p - pExact)[inner])/exact.p, 0.02, "atMost")
        table.row(f"{label}: spike over p_CJ, at least", 1.5, p.max()/exact.p, 1.5, "atLeast")
        table.row(f"{label}: energy", 1260*2.913e6 + 1e5/0.3,
                  fluidField(case, end, "thetaRhoE").mean(), 1e-12, "relative")


def quiet(table):
    """Below the threshold a charge only moves: its burn fraction goes with it."""
    n, end = 100, 1e-3
    fluid = lit(**{**QM100_RATE, "threshold": 1e9})

    case = fluidCase("detonation", "quiet", (n, 1, 1), (1, 0.01, 0.01), {"charge": fluid},
                     lambda x, y, z: ([1.0], [1630.0], 1000.0, 1e6), end,
                     patches=cyclicSides("x")[0])
    shareFile(case, "F.charge", 0.5*(abs((np.arange(n) + 0.5)/n - 0.5) < 0.2))
    case.run("materialPointFoam")
    F = fluidField(case, end, "F.charge")
    rho = fluidField(case, end, "thetaRho.charge")
    table.row("moving charge: burnt mass", 0.5*0.4*1630, np.mean(F*rho), 1e-12, "relative")
    table.row("moving charge: place of the burnt mass after one turn [m]", 0.5,
              np.sum(F*(np.arange(n) + 0.5)/n)/np.sum(F), 1e-3)
    # The donor cell's fraction flows: the edges spread, nothing is above or below
    table.row("moving charge: largest burn fraction", 0.5, F.max(), 0.5*(1 + 1e-12), "atMost")
    table.row("moving charge: dp over rho c^2", 0,
              np.max(abs(fluidField(case, end, "p") - 1e6))/1e10, 1e-12)


def plate(table):
    """Points driven by the charge: an aluminium plate of 10 mm on 50 mm of TNT at a wall, half
    of Gurney's symmetric sandwich, sqrt(2 E) (M/C + 1/3)^(-1/2) with 2.44 km/s of TNT
    (P. W. Cooper, Explosives Engineering, 1996)."""
    n, length, charge, thick, end = 600, 0.6, 0.05, 0.01, 1.5e-4
    fluids = {"charge": lit(), "air": AIR}
    case = fluidCase("detonation", "plate", (n, 1, 1), (length, length/n, length/n), fluids,
                     lambda x, y, z: ([1.0*(x < charge), 1.0*(x > charge)], [1630.0, 1.2], 0.0,
                                      1e5), end,
                     ends=WALL, control={"maxCo": 0.3, "deltaT": 1e-9, "reportInterval": 1})
    besidePoints(case, fluids, {"plate": {"constitutiveModel": {
        "type": "NewtonianFluid", "mu": 1e-3, "rho": 2785, "equationOfState": {
            "type": "MieGrueneisen", "C0": 5328, "S": 1.338, "Gamma0": 2}}}},
                 {"plate": {"type": "box", "min": (charge, -1, -1),
                            "max": (charge + thick, 1, 1), "pointsPerCell": 2}})
    case.run("materialPointFoam")

    def last(pattern):
        return [float(v) for v in re.findall(pattern, case.log(), re.M)]
    mass = last(r"^Material points: \d+, mass ([^,]+)")[-1]
    speed = last(r"^Material points: .*momentum \((\S+)")[-1]/mass
    ratio = 2785*thick/(1630*charge)
    table.row("plate of points on a charge: velocity, Gurney [m/s]",
              2440/np.sqrt(ratio + 1/3), speed, 0.05, "relative")
    m = last(r"^Fluids: mass charge (\S+)")
    table.row("plate of points on a charge: mass of TNT, late over early", 1, m[-1]/m[0], 1e-13)


# --- processors, restart -----------------------------------------------------

FIELDS = ("p", "U", "rho", "alpha.charge", "alpha.air", "thetaRho.charge", "thetaRho.air",
          "thetaRhoE", "F.charge")


def differences(a, b, time):
    worst = 0.0
    for name in FIELDS:
        u, v = volField(a, time, name), volField(b, time, name)
        if name == "F.charge":
            # Of traces (alpha 1e-14) a fraction of the mass is rounding
            u, v = (f*volField(c, time, "alpha.charge") for f, c in ((u, a), (v, b)))
        worst = max(worst, np.max(abs(u - v))/np.max(abs(u)))
    return worst


def ranks(table):
    end = 6e-6
    one = discCase("ranks-1", 16, end)
    F = fluidField(one, end, "F.charge")
    for split in ((2, 1, 1), (3, 1, 1), (2, 2, 1)):
        n = int(np.prod(split))
        other = discCase(f"ranks-{n}", 16, end, split)
        table.row(f"disc, {n} processors: largest difference", 0,
                  differences(one, other, one.timeName(end)), 1e-10)
    table.row("disc: its burn fraction is anything between 0 and 1", 1, F.max() - F.min(), 1e-9)


def restart(table):
    end, half = 4e-6, 2e-6
    for label, split in (("one processor", None), ("2 processors", (2, 1, 1))):
        runs = []
        for again in (False, True):
            case = discCase("restart-" + ("again" if again else "whole"), 16, end, split,
                            control={"writeInterval": half, "startFrom": "latestTime"},
                            before=lambda c, h=again: h and [
                                shutil.copytree(os.path.join(u, "2e-06"),
                                                os.path.join(v, "2e-06"))
                                for u, v in zip(runs[0].processors() or [runs[0].path],
                                                c.processors() or [c.path])])
            runs.append(case)
        F = volField(runs[0], "2e-06", "F.charge")
        table.check(f"restart, {label}: in the middle of the burn",
                    np.any((F > 0) & (F < 1)), (F.min(), F.max()))
        table.row(f"restart, {label}: largest difference", 0, differences(*runs, "4e-06"), 0,
                  "atMost")


# --- the tutorial ------------------------------------------------------------

def blastCase(name, n, burnsOn):
    """The tutorial with n cells over the radius of the charge: its run, the case."""
    case = FoamCase("detonation", name, template=os.path.join(PROJECT, "tutorials", "tntInAir"))
    shutil.copytree(case.file("0.orig"), case.file("0"), dirs_exist_ok=True)
    for part, cells in (("charge", n), ("near", n), ("far", 56*n)):
        case.change("system/blockMeshDict", rf"^{part} .*;", f"{part} {cells};")
    if not burnsOn:
        case.change("constant/phaseProperties", "^ *afterburn .*", "")
    for application in ("blockMesh", "setFields", "materialPointFoam"):
        case.run(application, limit=300)
    if case.path not in sys.path:
        sys.path.insert(0, case.path)
    from results import Run
    return Run(case.path), case


def blast(table):
    """tutorials/tntInAir: fits of measured bursts, whose products burn on in the air.
    Without that, on seven tenths of its cells: peak within 20 %, arrival within 5 %. With it,
    on its cells: impulse within 10 %, peak and arrival within 5 %, but where doc/misses.md
    says that they are not."""
    missed = {"peak": (0.5, 0.75, 1), "arrival": (1, 1.5), "impulse": (0.75,)}
    for burnsOn, label in ((False, ", no afterburn"), (True, "")):
        run, case = blastCase("blast" if burnsOn else "blastAlone", 20 if burnsOn else 14,
                              burnsOn)
        import kingery
        from results import GAUGES
        for z, peak, time, impulse in zip(GAUGES, run.peaks, run.arrivals, run.impulses):
            at = f"1 kg of TNT in air{label}, {z:g} m"
            for name, unit, fit, found, limit in (
                    ("peak", "kPa", kingery.pressure, peak, 0.05 if burnsOn else 0.2),
                    ("arrival", "ms", kingery.arrival, time, 0.05),
                    ("impulse", "kPa ms", kingery.impulse, impulse, 0.1)):
                if not burnsOn and name == "impulse":
                    continue
                if burnsOn and z in missed[name]:
                    print(f"{at}: {name} {found:.4g} {unit}, {100*(found/fit(z) - 1):+.1f} %")
                    continue
                table.row(f"{at}: {name} [{unit}]", fit(z), found, limit, "relative")
        E, came = ([float(v) for v in re.findall(pattern, case.log(), re.M)] for pattern in (
            r"^Fluids: .* energy (\S+)$", r"^    burned on of .* energy (\S+)$"))
        came = came or [0]*len(E)
        table.row(f"1 kg of TNT in air{label}: energy, late over early", 1,
                  (E[-1] - came[-1])/(E[1] - came[1]), 1e-12)
        # A pyramid has 4 tan^2 x^3/3
        m = [float(v) for v in re.findall(r"^Fluids: mass tnt (\S+)", case.log(), re.M)]
        table.row(f"1 kg of TNT in air{label}: charge [kg]", 1 - (0.001/0.05271181)**3,
                  m[-1]*np.pi/0.02**2, 1e-6, "relative")


# --- wrong input -------------------------------------------------------------

def wrong(table):
    def case(label, charge, change=None, rho=1630.0):
        # Thick layers of cells, where places are far from a cell's corners
        high = (1, 0.1, 2) if "Thick" in label else (1, 0.1, 0.1)
        c = fluidCase("detonation", "wrong-" + label, (8, 1, 1), high,
                      {"charge": charge, "air": AIR},
                      lambda x, y, z: ([1.0*(x < 0.5), 1.0*(x > 0.5)], [rho, 1.2], 0.0, 1e5),
                      1e-7)
        if change:
            change(c)
        return c

    def badField(c):
        shutil.copy(c.file("0/alpha.charge"), c.file("0/F.charge"))
        with open(c.file("0/F.charge")) as f:
            text = f.read().replace("alpha.charge", "F.charge").replace("1.0", "1.5")
        with open(c.file("0/F.charge"), "w") as f:
            f.write(text)
    gas = {**AIR, "detonation": lit()["detonation"]}
    for label, charge, words, change in (
            ("keyword", lit(velocty=1), ("velocty", "velocity", "points"), None),
            ("law", lit(type="programedBurn", velocity=D), ("programedBurn", "pressureRate"),
             None),
            ("nowhere", {**TNT, "detonation": {"type": "programmedBurn", "velocity": D}},
             ("points lines planes",), None),
            ("noVelocity", lit(type="programmedBurn", points=[(0, 0, 0)]), ("velocity",), None),
            ("velocity", lit(velocity=-1), ("velocity", "-1"), None),
            ("outside", lit(points=[(0.8, 0.05, 0.05)]),
             ("point (0.8 0.05 0.05)", "outside of the charge", "setFluids"), None),
            ("outsideThick", lit(points=[(0.8, 0.05, 1)]),
             ("point (0.8 0.05 1)", "outside of the charge"), None),
            ("outsideLine", lit(lines=[[(0.8, 0, 0), (0.9, 0, 0)]]),
             ("line from (0.8 0 0)", "outside of the charge"), None),
            ("outsidePlane", lit(planes=[[(0.8, 0, 0), (1, 0, 0)]]),
             ("plane through (0.8 0 0)", "outside of the charge"), None),
            ("normal", lit(planes=[[(0.2, 0, 0), (0, 0, 0)]]), ("planes", "normal"), None),
            ("times", lit(times=[1, 2]), ("times", "2 values", "1 points"), None),
            ("water", {**WATER, "detonation": lit()["detonation"]},
             ("stiffenedGas", "cannot detonate", "JWL"), None),
            ("gas", gas, ("perfectGas", "JWL"), None),
            ("rate", lit(**{**QM100_RATE, "G": 0}), ("G",), None),
            ("booster", lit(**QM100_RATE, booster={"points": [(0, 0, 0)], "speed": 1}),
             ("speed", "velocity"), None),
            ("fraction", lit(), ("F.charge", "1.5", "[0, 1]"), badField)):
        c = case(label, charge, change)
        try:
            c.run("materialPointFoam")
            table.check(f"wrong input: {label}", False, "ran")
            continue
        except RunFailed:
            pass
        text = " ".join(c.log().split())
        missing = [w for w in words if w not in text]
        table.check(f"wrong input: {label}",
                    not missing and "FOAM FATAL" in text and "printStack" not in text,
                    f"message lacks {missing}")

    # Mass and shape that do not fit: the energy is that of another density
    c = case("density", lit(points=[(0.1, 0.05, 0.05)]), rho=1624.0)
    c.run("materialPointFoam")
    energy = c.numbers(r"^Fluids: .*energy N$")[0] - 1e5/0.4*0.005
    table.row("charge of 1624 kg/m3 in place of 1630: energy over E0 m/rho0", 1.018,
              energy/(7e9*0.005*1624/1630), 2e-3)
    table.check("charge of 1624 kg/m3: told", "constants of products, the velocity of detonation "
                "and E0 are of one density" in " ".join(c.log().split()))


if __name__ == "__main__":
    sys.exit(runParts("detonation", plane, travelling, conservation, places, symmetric, inAir,
                      rate, quiet, plate, ranks, restart, blast, wrong))
