#!/usr/bin/env python3
"""A gas alone with each equation of state: Riemann problems against numerically exact
solutions (tests/lib/riemannEquation.py, equations written down again there).

L1 is the mean over the tube of |density, velocity, pressure - exact| over the range of
the exact values, with vanLeer. Its limit at 200 cells is one cell's width of each front,
h times the total variation of the exact values (of Sod's density 4.4e-3). Orders from 100
to 400 cells: velocity and pressure at least 0.8 as Sod's (shocks 1), density 2/3, that of
a contact in a scheme of second order. Star states are means over the middle of their
plateaus, limit 2e-3 of the range (densities: of their value) as Sod's.

    Sod           perfectGas as equation against the words of thermo, and the solver here
                  against the closed form
    stiffenedGas  water at 1 GPa beside water at 1 bar; water that parts with 200 m/s
                  (p* -149 MPa); that parts with 1700 m/s (p + pInf near 0)
                  and a ratio of 1e6 of p + pInf into near vacuum (fluxes of Harten, Lax
                  and van Leer; L1 limits as gasAlone's)
    Tait, linear  a step of the density; the waves of linear do not steepen: orders of 2/3
    MieGrueneisen copper at 120 GPa beside copper at rest without pressure; impact
    JWL           products of TNT beside such that have expanded, to a pressure of 200 MPa
                  and of 10 MPa (there contact and shock are close: 400 and 1600 cells)
    vanDerWaals   a dense gas at 20 MPa beside a thin one
    nobleAbelStiffenedGas  water at 1 GPa beside water at 1 bar
    CochranChan   TNT that has not burnt, at 10 GPa beside TNT at rest
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import riemannEquation as exact
import riemannExact as perfect
from foamCase import RunFailed
from gasCases import OPEN, UPWIND, VAN_LEER, WALL, gasCase, volField
from report import Report

WATER = {"rho": 1000, "equationOfState": {
    "type": "stiffenedGas", "gamma": 4.4, "pInf": 6e8, "p0": 1e5}}
TAIT = {"rho": 1000, "equationOfState": {"type": "Tait", "K": 2.15e9, "n": 7.15, "p0": 1e5}}
LINEAR = {"rho": 7850, "equationOfState": {"type": "linear", "K": 140e9}}
COPPER = {"rho": 8960, "equationOfState": {
    "type": "MieGrueneisen", "C0": 3940, "S": 1.489, "Gamma0": 2.02}}
TNT = {"rho": 1630, "equationOfState": {
    "type": "JWL", "A": 371.2e9, "B": 3.231e9, "R1": 4.15, "R2": 0.95, "omega": 0.3,
    "E0": 7e9}}

DENSE = {"rho": 50, "equationOfState": {
    "type": "vanDerWaals", "gamma": 1.4, "a": 5, "b": 1e-3, "p0": 1e5}}
LIQUID = {"rho": 1050, "equationOfState": {
    "type": "nobleAbelStiffenedGas", "gamma": 1.19, "pInf": 7.028e8, "b": 6.61e-4, "q": -1177788,
    "p0": 1e5}}
SOLID_TNT = {"rho": 1840, "equationOfState": {
    "type": "CochranChan", "A": 12.87e9, "B": 13.42e9, "E1": 4.1, "E2": 3.1, "Gamma0": 0.93,
    "p0": 1e5}}

water = exact.StiffenedGas(4.4, 6e8)
tait = exact.Tait(2.15e9, 7.15, 1e5, 1000)
linear = exact.Linear(140e9, 7850)
copper = exact.MieGrueneisen(3940, 1.489, 2.02, 8960)
dense = exact.VanDerWaals(1.4, 5, 1e-3)
liquid = exact.NobleAbelStiffenedGas(1.19, 7.028e8, 6.61e-4, -1177788)
solidTNT = exact.CochranChan(12.87e9, 13.42e9, 4.1, 3.1, 0.93, 1840)
tnt = exact.JWL(371.2e9, 3.231e9, 4.15, 0.95, 0.3, 1630)


def tube(name, n, words, problem, end, **options):
    """Cell centres less the middle, density, velocity, pressure at the end; the case."""
    def initial(x, y, z):
        return tuple(np.where(x < 0.5, l, r) for l, r in zip(*problem))
    case = gasCase("riemannEquations", f"{name}-{n}", (n, 1, 1), (1, 0.01, 0.01), initial, end,
                   thermo=words, **options)
    case.run("materialPointFoam")
    t = case.timeName(end)
    return ((np.arange(n) + 0.5)/n - 0.5, volField(case, t, "rho.air"),
            volField(case, t, "U.air")[:, 0], volField(case, t, "p"), case)


def series(table, label, words, eos, problem, lowest, end, stars=4, cells=(100, 200, 400),
           steepens=True):
    """One problem: L1 and order; the first so many of p*, u*, rho*L, rho*R."""
    name = re.sub("[^A-Za-z]+", "-", label)
    riemann = exact.Riemann(eos, *problem, lowest)
    errors = {}
    for n in cells:
        x, *values, case = tube(name, n, words, problem, end)
        reference = riemann.at(x/end)
        errors[n] = [np.mean(abs(a - b))/np.ptp(b) for a, b in zip(values, reference)]
        if n == cells[1]:
            limits = [np.sum(abs(np.diff(b)))/np.ptp(b)/n for b in reference]
        if n != 200:
            continue
        inside = abs(reference[2] - riemann.p) < 1e-6*np.ptp(reference[2])
        for i, (quantity, value, side) in enumerate((
                ("p*", riemann.p, 0), ("u*", riemann.u, 0),
                ("rho*L", riemann.rhoL, -1), ("rho*R", riemann.rhoR, 1))):
            part = inside & (side*(x - riemann.u*end) >= 0)
            # Off the waves that end the plateau
            places = np.sort(x[part])
            a, b = places[0], places[-1]
            part &= abs(x - (a + b)/2) < 0.25*(b - a)
            measured = (values[2], values[1], values[0], values[0])[i][part].mean()
            scale = abs(value) if i > 1 else np.ptp(reference[2 - i])
            if i < stars:
                table.row(f"{label}, 200 cells: {quantity}, error over its range", 0,
                          (measured - value)/scale, 2e-3)
    for i, quantity in enumerate(("density", "velocity", "pressure")):
        if steepens:
            table.row(f"{label}, {cells[1]} cells: L1 of the {quantity} over its range", 0,
                      errors[cells[1]][i], limits[i], "atMost")
        order = 0.8 if i and steepens else 2/3
        table.row(f"{label}: order of the {quantity}, {cells[0]} to {cells[-1]} cells", order,
                  np.log(errors[cells[0]][i]/errors[cells[-1]][i])/np.log(cells[-1]/cells[0]),
                  order, "atLeast")


def solver(table):
    """The numerically exact solver against the closed form of a perfect gas."""
    riemann = exact.Riemann(exact.StiffenedGas(1.4), *perfect.SOD, 0.05)
    p, u = perfect.star(*perfect.SOD)
    table.row("exact solver, Sod: p*", p, riemann.p, 1e-6, "relative")
    table.row("exact solver, Sod: u*", u, riemann.u, 1e-6, "relative")
    # Off the jumps, which a ray may hit
    s = np.linspace(-1.5, 2, 501)
    pairs = list(zip(riemann.at(s), perfect.solution(*perfect.SOD, s)))
    for quantity, (a, b) in zip(("density", "velocity", "pressure"), pairs):
        table.row(f"exact solver, Sod: largest difference of the {quantity}", 0,
                  np.max(abs(a - b)), 1e-5, "atMost")

    # p + pInf of a stiffened gas is p of a perfect one
    shift = [(r, u, p - 6e8) for r, u, p in ((1000, 0, 1.6e9), (1000, 0, 6.001e8))]
    riemann = exact.Riemann(water, *shift, 1e5)
    p, u = perfect.star((1000, 0, 1.6e9), (1000, 0, 6.001e8), 4.4)
    table.row("exact solver, water: p*", p - 6e8, riemann.p, 1e-6, "relative")
    table.row("exact solver, water: u*", u, riemann.u, 1e-6, "relative")


def asEquation(table):
    """perfectGas as an equation of state is the gas of thermo perfectGas."""
    words = {"rho": 1, "Cv": 2.5, "equationOfState": {
        "type": "perfectGas", "gamma": 1.4, "p0": 1}}
    for label, reconstruct in (("vanLeer", VAN_LEER), ("upwind", UPWIND)):
        *one, case = tube(f"sod-equation-{label}", 200, words, perfect.SOD, 0.2,
                          reconstruct=reconstruct)
        *two, other = tube(f"sod-thermo-{label}", 200, None, perfect.SOD, 0.2,
                           reconstruct=reconstruct)
        table.row(f"Sod, {label}: equationOfState perfectGas against thermo perfectGas", 0,
                  max(np.max(abs(a - b)) for a, b in zip(one, two)), 1e-12, "atMost")
        T = [volField(c, c.timeName(0.2), "T.air") for c in (case, other)]
        table.row(f"Sod, {label}: T of Cv, the same", 0, np.max(abs(T[0] - T[1])), 1e-12,
                  "atMost")


def stiffened(table):
    series(table, "stiffenedGas, 1 GPa and 1 bar", WATER, water,
           ((1000, 0, 1e9), (1000, 0, 1e5)), 1e5, 1.5e-4)
    series(table, "stiffenedGas, tension", WATER, water,
           ((1000, -100, 1e5), (1000, 100, 1e5)), -4e8, 2.2e-4, stars=1)

    # Tension to near the limit of the equation
    problem = ((1000, -850, 1e5), (1000, 850, 1e5))
    for label, reconstruct in (("vanLeer", VAN_LEER), ("upwind", UPWIND)):
        x, rho, u, p, case = tube(f"limit-{label}", 200, WATER, problem, 1.5e-4,
                                  reconstruct=reconstruct)
        name = f"stiffenedGas parts with 1700 m/s, {label}"
        table.row(f"{name}: least p + pInf [Pa]", 0, p.min() + 6e8, 0, "atLeast")
        star = perfect.star((1000, -850, 6.001e8), (1000, 850, 6.001e8), 4.4)[0]
        if label == "vanLeer":
            table.row(f"{name}: |p - p*|/(p_L + pInf) in the middle", 0,
                      abs(p[abs(x) < 0.02] + 6e8 - star).max()/6.001e8, 1e-2, "atMost")

    # Into near vacuum of p + pInf
    problem, end = ((1000, 0, 0), (1e-3, 0, 600 - 6e8)), 5e-5
    for label, reconstruct, limit in (("vanLeer", VAN_LEER, 4e-3), ("upwind", UPWIND, 2e-2)):
        x, rho, u, p, case = tube(f"ratio-{label}", 400, WATER, problem, end,
                                  reconstruct=reconstruct)
        name = f"stiffenedGas, ratio of p + pInf 1e6, {label}"
        reference = perfect.solution(*((r, v, q + 6e8) for r, v, q in problem), x/end, 4.4)
        table.row(f"{name}: L1 of the density over its range", 0,
                  np.mean(abs(rho - reference[0]))/1000, limit, "atMost")
        table.row(f"{name}: least p + pInf [Pa]", 0, p.min() + 6e8, 0, "atLeast")
        table.row(f"{name}: mass over that of the start", 1, rho.mean()/500.0005, 1e-12)
        table.row(f"{name}: energy over that of the start", 1,
                  volField(case, case.timeName(end), "thetaRhoE.air").mean()
                  /np.mean([(q + 4.4*6e8)/3.4 for _, _, q in problem]), 1e-12)
        table.check(f"{name}: some faces were kept positive", "kept positive" in case.log())


def barotropic(table):
    series(table, "Tait", TAIT, tait, ((1100, 0, tait.pressure(1100, 0)), (1000, 0, 1e5)),
           -1e8, 1.7e-4)
    series(table, "linear", LINEAR, linear,
           ((8000, 0, linear.pressure(8000, 0)), (7850, 0, 0)), -1e9, 0.9e-4, steepens=False)


def MieGrueneisen(table):
    series(table, "MieGrueneisen, 120 GPa", COPPER, copper,
           ((11000, 0, 1.2e11), (8960, 0, 0)), -1e9, 5.5e-5)
    x, rho, u, p, case = tube("impact", 200, COPPER, ((8960, 500, 0), (8960, -500, 0)), 8e-5)
    up = 500
    Us = 3940 + 1.489*up
    behind = (abs(x) < 0.15) & (abs(x) > 0.05)
    table.row("MieGrueneisen, copper on copper at 1000 m/s: pressure", 8960*Us*up,
              p[behind].mean(), 2e-3, "relative")
    table.row("MieGrueneisen, copper on copper at 1000 m/s: density", 8960*Us/(Us - up),
              rho[behind].mean(), 2e-3, "relative")


def JWL(table):
    products = (1630, 0, tnt.pressure(1630, 7e9/1630))
    series(table, "JWL, to 200 MPa", TNT, tnt, (products, (400, 0, 2e8)), 2e8, 8e-5)
    series(table, "JWL, to 10 MPa", TNT, tnt, (products, (100, 0, 1e7)), 1e7, 8e-5, stars=0,
           cells=(400, 1600))


def covolumes(table):
    series(table, "vanDerWaals, 20 MPa", DENSE, dense,
           ((300, 0, 2e7), (50, 0, 1e6)), 5e5, 8e-4)
    series(table, "nobleAbelStiffenedGas, 1 GPa", LIQUID, liquid,
           ((1050, 0, 1e9), (1050, 0, 1e5)), 1e5, 1.5e-4)


def CochranChan(table):
    series(table, "CochranChan, TNT at 10 GPa", SOLID_TNT, solidTNT,
           ((2300, 0, 1e10), (1840, 0, 1e5)), 0, 8e-5)


# --- fields, conservation, processors, restart -------------------------------

def box(name, words, p, end, **options):
    """2D: a spot of pressure p(spot) in a closed box."""
    def initial(x, y, z):
        spot = np.exp(-((x - 0.4)**2 + (y - 0.6)**2)/0.02)
        return words["rho"] + 0*x, 0*x, p(spot)
    return gasCase("riemannEquations", name, (24, 20, 1), (1, 1, 0.1), initial, end,
                   ends=WALL, thermo=words, **options)


def conserved(case, time, energy):
    names = ["thetaRho.air"] + (["thetaRhoE.air"] if energy else [])
    return np.array([volField(case, time, n).sum() for n in names])


def plane(table):
    for label, words, p, end in (
            ("stiffenedGas", WATER, lambda s: 1e5 + 2e8*s, 2e-4),
            ("Tait", TAIT, lambda s: 1e5 + 2e8*s, 2e-4)):
        energy = label == "stiffenedGas"
        first = box(f"{label}-whole", words, p, end, writeInterval=end/2)
        first.run("materialPointFoam")
        times = first.times()
        names = ["p", "U.air", "thetaRho.air"] + (["thetaRhoE.air"] if energy else [])
        a, b = (conserved(first, t, energy) for t in times[-2:])
        table.row(f"{label}, closed box: change of mass (and energy)", 0,
                  np.max(abs(b/a - 1)), 1e-13, "atMost")

        second = box(f"{label}-restart", words, p, end/2)
        second.run("materialPointFoam")
        second.change("system/controlDict", r"startFrom .*;", "startFrom latestTime;")
        second.change("system/controlDict", r"endTime .*;", f"endTime {end!r};")
        second.run("materialPointFoam")
        table.row(f"{label}, restart: largest difference", 0,
                  max(np.max(abs(volField(first, times[-1], n)
                                 - volField(second, times[-1], n))) for n in names), 0,
                  "atMost")

        many = box(f"{label}-processors", words, p, end, writeInterval=end/2)
        many.decompose((2, 1, 1))
        many.runParallel()
        table.row(f"{label}: 1 against 2 processors, largest relative difference", 0,
                  max(np.max(abs(volField(first, times[-1], n)
                                 - volField(many, times[-1], n)))
                      /np.max(abs(volField(first, times[-1], n))) for n in names), 1e-10,
                  "atMost")


def leaves(table):
    """A weak pulse leaves through waveTransmissive. psi.air is 1/c^2, so that with gamma 1
    water sends back the share that a perfect gas does."""
    shares = []
    for label, words, gamma, rho, p0, c in (
            ("water", WATER, 1, 1000, 1e5, np.sqrt(4.4*6.001e5)),
            ("air", None, 1.4, 1, 1, np.sqrt(1.4))):
        out = ({"type": "waveTransmissive", "gamma": gamma, "phi": "phi.air",
                "psi": "psi.air", "rho": "rho.air", "fieldInf": p0, "lInf": 1e3},
               "zeroGradient", "zeroGradient")
        end = 1/c
        rest = []
        for name, ends in (("out", out), ("walls", WALL)):
            case = gasCase("riemannEquations", f"leaves-{label}-{name}", (200, 1, 1),
                           (1, 0.01, 0.01),
                           lambda x, y, z: (rho + 0*x, 0*x, p0 + 1e-4*rho*c**2
                                            *np.exp(-((x - 0.5)/0.05)**2)),
                           end, thermo=words, ends=ends)
            case.run("materialPointFoam")
            rest.append(np.max(abs(volField(case, case.timeName(end), "p") - p0)))
        shares.append(rest[0]/rest[1])
    table.row("waveTransmissive: share of a pulse that comes back, water against air",
              shares[1], shares[0], 1e-2, "relative")


# --- wrong input -------------------------------------------------------------

def wrong(table):
    phases = "constant/phaseProperties"

    def swap(old, new):
        return lambda c: c.change(phases, old, new)
    for i, (label, words, change, texts) in enumerate((
            ("Cv of an equation without temperature", {**TAIT, "Cv": 4000}, None,
             ("Cv", "Tait", "no temperature")),
            ("thermo and equationOfState", {**WATER, "thermo": "perfectGas"}, None,
             ("thermo", "equationOfState")),
            ("no rho", WATER, swap(r"rho 1000;", ""), ("rho", "missing")),
            ("unknown equation", WATER, swap("stiffenedGas", "stiffGas"),
             ("stiffGas", "MieGrueneisen")),
            ("neither thermo nor equationOfState", WATER,
             swap(r"equationOfState[^}]*}", ""), ("thermo", "equationOfState")),
            ("no file rho.air", WATER, lambda c: os.remove(c.file("0/rho.air")),
             ("rho.air", "missing")),
            ("p + pInf negative", WATER,
             lambda c: c.change("0/p", r"^100000.0$", "-7e8"),
             ("rho c^2", "in cell", "0/rho.air")))):
        case = gasCase("riemannEquations", f"wrong-{i}", (20, 1, 1), (1, 0.1, 0.1),
                       lambda x, y, z: (1000 + 0*x, 0*x, 1e5 + 0*x), 1e-6, thermo=words)
        if change:
            change(case)
        try:
            case.run("materialPointFoam", fails=True)
        except RunFailed as e:
            table.check(f"wrong input: {label}", False, e)
            continue
        text = case.log()
        missing = [w for w in texts if w not in text]
        table.check(f"wrong input: {label}", text.count("FOAM FATAL") == 1 and not missing,
                    f"message lacks {missing}" if missing else "")


def main():
    table = Report("riemannEquations")
    for part in (solver, asEquation, stiffened, barotropic, MieGrueneisen, JWL, covolumes,
                 CochranChan, plane, leaves, wrong):
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
