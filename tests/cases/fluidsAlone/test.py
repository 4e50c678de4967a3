#!/usr/bin/env python3
"""Several fluids in one cell, without points: two-fluid shock tubes against the exact
Riemann solution of two equations of state, translation of interfaces with uniform
pressure, rest under gravity, processors, restart, wrong input.

Tubes: p*, u* are means around the contact, to both sides 0.8 of the way from it to the
shock; rho*R over the middle third between contact and shock; L1 is the
mean of |rho - exact|, which the rarefaction's tail is in (there p of water from 1 GPa is off
by 1.4 MPa in some cells). Limits are those that a
one-dimensional program of the same scheme reached, but for those that its note says this
one misses. Water and a gas of van der Waals: also against the curves of Zheng et al.
(2011), within 1 % of their range. A disc is carried five domains along the diagonal, a slotted one
turns with a velocity that is given: L1 over its area.
A charge in the corner of three planes of symmetry: no direction is another. Rayleigh and Taylor's
growing mode at low Mach number against linear theory, and what of p changes sign from cell to cell.
"""

import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import riemannEquation as exact
import slottedReferences
from fluidCases import AIR, WATER, besidePoints, fluidCase, fluidField
from foamCase import VERIFY, FoamCase, PROJECT, RunFailed, runParts
from gasCases import VAN_LEER, WALL, boxCentres, volField
from gasOnCells import cyclicSides

TNT = {"rho": 1630, "equationOfState": {"type": "JWL", "A": 3.712e11, "B": 3.231e9, "R1": 4.15,
                                        "R2": 0.95, "omega": 0.3, "E0": 7e9}}
DENSE = {"rho": 50, "equationOfState": {"type": "vanDerWaals", "gamma": 1.4, "a": 5, "b": 1e-3,
                                        "p0": 1e5}}
LIQUID = {"rho": 1050, "equationOfState": {
    "type": "nobleAbelStiffenedGas", "gamma": 1.19, "pInf": 7.028e8, "b": 6.61e-4, "q": -1177788,
    "p0": 1e5}}
COPPER = {"rho": 8900, "equationOfState": {
    "type": "CochranChan", "A": 145.67e9, "B": 147.75e9, "E1": 2.99, "E2": 1.99, "Gamma0": 2,
    "p0": 1e5}}
REAL_AIR = {"thermo": "perfectGas", "R": 287, "gamma": 1.4}
CLOSED = ("zeroGradient", "zeroGradient", "slip")


# --- shock tubes -------------------------------------------------------------

EQUATIONS = {"water": exact.StiffenedGas(4.4, 6e8), "air": exact.StiffenedGas(1.4),
             "tnt": exact.JWL(3.712e11, 3.231e9, 4.15, 0.95, 0.3, 1630),
             "dense": exact.VanDerWaals(1.4, 5, 1e-3),
             "liquid": exact.NobleAbelStiffenedGas(1.19, 7.028e8, 6.61e-4, -1177788),
             "copper": exact.CochranChan(145.67e9, 147.75e9, 2.99, 1.99, 2, 8900)}
FLUIDS = {"water": WATER, "air": AIR, "tnt": TNT, "dense": DENSE, "liquid": LIQUID,
          "copper": COPPER}


def tube(name, pair, left, right, n, end, middle, lowest):
    """Errors of p*, u*, rho*R (relative), L1 of rho, case."""
    def initial(x, y, z):
        on = x < middle
        return ([1.0*on, 1.0*~on], [left[0], right[0]], np.where(on, left[1], right[1]),
                np.where(on, left[2], right[2]))
    # Two fluids of one equation have names of their own
    names = pair if pair[0] != pair[1] else (pair[0] + "1", pair[1] + "2")
    case = fluidCase("fluidsAlone", f"{name}-{n}", (n, 1, 1), (1, 0.01, 0.01),
                     dict(zip(names, (FLUIDS[f] for f in pair))), initial, end)
    case.run("materialPointFoam")
    solution = exact.Riemann(tuple(EQUATIONS[f] for f in pair), left, right, lowest)
    s = ((np.arange(n) + 0.5)/n - middle)/end
    r, _, p = solution.at(s)
    rho, P = fluidField(case, end, "rho"), fluidField(case, end, "p")
    U = fluidField(case, end, "U")[:, 0]
    star = np.where(abs(p/solution.p - 1) < 1e-9)[0]
    behind = [i for i in star if s[i] > solution.u]
    both = star[abs(s[star] - solution.u) < 0.8*(s[behind[-1]] - solution.u)]
    behind = behind[len(behind)//3:2*len(behind)//3]
    alpha = fluidField(case, end, "alpha." + names[0])
    return {"p*": P[both].mean()/solution.p - 1, "u*": U[both].mean()/solution.u - 1,
            "rho*R": rho[behind].mean()/solution.rhoR - 1, "L1": np.mean(abs(rho - r)),
            "cells": int(np.sum((alpha > 0.01) & (alpha < 0.99))), "case": case}


def vanDerWaals(table):
    """Water at 1 GPa beside a gas of van der Waals, 300 cells as published."""
    n, end, middle = 300, 2.4e-4, 0.7
    found = tube("water-vanDerWaals", ("water", "dense"), (1000.0, 0.0, 1e9), (50.0, 0.0, 1e5),
                 n, end, middle, 5e4)
    label = "water 1 GPa, gas of van der Waals"
    for quantity, limit in (("p*", 5e-3), ("u*", 5e-3), ("rho*R", 0.08)):
        table.row(f"{label}, {n} cells: {quantity} error", 0, found[quantity], limit)
    table.row(f"{label}, {n} cells: cells of the interface (1 to 99 %)", 0, found["cells"], 3,
              "atMost")
    case = found["case"]
    table.check(f"{label}: nothing was put right", "pressure of relaxation kept 0" in case.log())
    x = (np.arange(n) + 0.5)/n
    for quantity, values in (("p", fluidField(case, end, "p")),
                             ("u", fluidField(case, end, "U")[:, 0])):
        points = np.loadtxt(os.path.join(os.path.dirname(__file__), f"zheng2011_{quantity}.csv"),
                            delimiter=",")
        # Their shock is 0.010 ahead of the exact one: no points there
        points = points[abs(points[:, 0] - 0.855) > 0.012]
        table.row(f"{label}: {quantity} against Zheng et al. (2011), mean difference over the "
                  "range", 0, np.mean(abs(np.interp(points[:, 0], x, values) - points[:, 1]))
                  /np.ptp(points[:, 1]), 0.01, "atMost")


def tubes(table):
    sod = ("air", "air"), (1.0, 0.0, 1.0), (0.125, 0.0, 0.1)
    water = (1000.0, 0.0, 1e9)
    for label, problem, n, end, middle, lowest, limits in (
            ("Sod of two fluids", sod, 200, 0.2, 0.5, 0.05,
             {"p*": 1e-3, "u*": 1e-3, "L1": 4e-3}),
            ("water 1 GPa, air 50 kg/m3", (("water", "air"), water, (50.0, 0.0, 1e5)), 300,
             2.2e-4, 0.7, 5e4, {"p*": 0.01, "u*": 5e-3, "rho*R": 0.08, "L1": 2.9}),
            ("water 1 GPa, air 50 kg/m3", (("water", "air"), water, (50.0, 0.0, 1e5)), 1200,
             2.2e-4, 0.7, 5e4, {"p*": 1e-3, "u*": 5e-4, "rho*R": 5e-3, "L1": 0.8}),
            ("water 1 GPa, air 1.2 kg/m3", (("water", "air"), water, (1.2, 0.0, 1e5)), 1200,
             2.2e-4, 0.7, 5e4, {"p*": 5e-3, "u*": 5e-3, "rho*R": 0.04, "L1": 0.6}),
            ("products of TNT, water", (("tnt", "water"), (1630.0, 0.0, 8.4e9),
                                        (1000.0, 0.0, 1e5)), 200,
             8e-5, 0.5, 5e4, {"p*": 1e-3, "u*": 1e-3, "rho*R": 1e-3}),
            ("copper 120 GPa, liquid of nobleAbelStiffenedGas", (
                ("copper", "liquid"), (11000.0, 0.0, 1.2e11), (1050.0, 0.0, 1e5)), 200,
             3.5e-5, 0.5, 5e4, {"p*": 1e-3, "u*": 1e-3, "rho*R": 1e-3})):
        pair, left, right = problem
        found = tube(label.replace(" ", "-").replace(",", "").replace("/", ""), pair, left,
                     right, n, end, middle, lowest)
        for quantity, limit in limits.items():
            table.row(f"{label}, {n} cells: {quantity}" + ("" if quantity == "L1" else " error"),
                      0, found[quantity], limit, *(("atMost",) if quantity == "L1" else ()))
        table.row(f"{label}, {n} cells: cells of the interface (1 to 99 %)", 0, found["cells"],
                  2 if "Sod" in label else 3, "atMost")
        table.check(f"{label}, {n} cells: nothing was put right",
                    "pressure of relaxation kept 0" in found["case"].log())


# --- interfaces --------------------------------------------------------------

def translation(table):
    """Water, air and a heavy gas, five crossings: p stays uniform."""
    n, end = 100, 0.05

    def initial(x, y, z):
        a, b = 1.0*(abs(x - 0.3) < 0.15), 1.0*(abs(x - 0.7) < 0.1)
        return [a, b, 1 - a - b], [1000.0, 6.0, 1.2], 100.0, 1e5
    case = fluidCase("fluidsAlone", "translation", (n, 1, 1), (1, 0.01, 0.01),
                     {"water": WATER, "heavy": AIR, "air": AIR}, initial, end,
                     patches=cyclicSides("x")[0])
    case.run("materialPointFoam")
    table.row("translation of three fluids: dP/(P + pInf)", 0,
              np.max(abs(fluidField(case, end, "p") - 1e5))/6e8, 1e-12)
    table.row("translation of three fluids: velocity [m/s]", 100,
              fluidField(case, end, "U")[:, 0].mean(), 1e-8)
    x = (np.arange(n) + 0.5)/n
    for fluid, alpha, rho in zip(("water", "heavy", "air"), *initial(x, 0, 0)[:2]):
        a = fluidField(case, end, "alpha." + fluid)
        table.row(f"translation of three fluids: mass of {fluid}", rho*alpha.mean(),
                  fluidField(case, end, "thetaRho." + fluid).mean(), 1e-13, "relative")
        table.row(f"translation of three fluids: cells of an interface of {fluid} (1 to 99 %)",
                  0, np.sum((a > 0.01) & (a < 0.99))/(4 if fluid == "air" else 2), 3, "atMost")


def covered(x, y, h, inside, m=16):
    """Share of square cells that a shape covers, by m x m samples."""
    s = (np.arange(m) + 0.5)/m - 0.5
    return inside(x[:, None, None] + h*s[None, :, None],
                  y[:, None, None] + h*s[None, None, :]).mean(axis=(1, 2))


def discCase(name, n, end, split=None, control=None, before=lambda case: None):
    def initial(x, y, z):
        a = covered(x, y, 1/n, lambda X, Y: 1.0*((X - 0.5)**2 + (Y - 0.5)**2 < 0.0225))
        return [a, 1 - a], [1.0, 0.5], np.column_stack([1 + 0*x, 1 + 0*x, 0*x]), 1.0
    case = fluidCase("fluidsAlone", name, (n, n, 1), (1, 1, 1/n), {"disc": AIR, "air": AIR},
                     initial, end, patches=cyclicSides("xy")[0], maxCoGas=0.8, control=control)
    case.solve(split, before)
    start = initial(*boxCentres((0, 0, 0), (1, 1, 1/n), (n, n, 1)))[0][0]
    return case, start


def disc(table):
    n, end = 64, 5
    case, start = discCase("disc", n, end)
    a = fluidField(case, end, "alpha.disc")
    # What a two-dimensional program of transport alone reached
    table.row("disc, five domains along the diagonal, 64 x 64: L1/area", 0,
              np.mean(abs(a - start))/start.mean(), 0.16, "atMost")
    table.row("disc: least share", 0, a.min(), 1e-15)
    table.row("disc: largest share", 1, a.max(), 1e-15)
    table.row("disc: its mass", 1, a.mean()/start.mean(), 1e-12)
    table.row("disc: dp/p", 0, np.max(abs(fluidField(case, end, "p") - 1)), 1e-11)


def slottedCase(name, n, end=1.0, split=None, control=None, before=lambda case: None):
    """S.T. Zalesak's disc (J. Comput. Phys. 31 (1979) 335-362) turns with its surroundings."""
    def initial(x, y, z):
        a = covered(x, y, 1/n, lambda X, Y: 1.0*(
            ((X - 0.5)**2 + (Y - 0.75)**2 < 0.0225) & ((abs(X - 0.5) > 0.025) | (Y > 0.85))))
        u = 2*np.pi*np.column_stack([0.5 - y, x - 0.5, 0*x])
        return [a, 1 - a], [1.0, 0.5], u, 1.0
    fields = ("p", "U", "alpha.disc", "alpha.air", "T.disc", "T.air")
    case = fluidCase("fluidsAlone", name, (n, n, 1), (1, 1, 1/n), {"disc": AIR, "air": AIR},
                     initial, end, patches={"rim": ("patch", ("x-", "x+", "y-", "y+"))},
                     given={"rim": dict.fromkeys(fields, "zeroGradient")},
                     settings={"velocity": "given"},
                     control={"deltaT": 0.1/n, "adjustTimeStep": False, **(control or {})})
    case.solve(split, before)
    return case, initial(*boxCentres((0, 0, 0), (1, 1, 1/n), (n, n, 1)))


def slotted(table):
    """A slotted disc with a velocity that is given, one turn in 10 n steps, beside interFoam
    (MULES, cAlpha 1) and interIsoFoam (isoAdvector) of OpenFOAM v1912 with frozenFlow on the
    same cells from the same start with the same steps (slottedReferences.py): no worse than the
    first, within twice the second. MPM_VERIFY=1: also those, and 200 x 200 cells, where the
    second is missed (doc/misses.md)."""
    for n in (50, 100, 200) if VERIFY else (50, 100):
        compressed, cut = slottedReferences.ERRORS[n]
        case, (alphas, _, u, _) = slottedCase(f"slotted-{n}", n)
        a = fluidField(case, 1.0, "alpha.disc")
        error = np.mean(abs(a - alphas[0]))/alphas[0].mean()
        label = f"slotted disc, one turn, {n} x {n}"
        table.row(f"{label}: L1/area, interFoam {compressed}", 0, error, compressed, "atMost")
        if n < 200:
            table.row(f"{label}: L1/area over that of interIsoFoam, {cut}", 1, error/cut, 2,
                      "atMost")
        else:
            print(f"{label}: L1/area over that of interIsoFoam {error/cut:.3g}")
        if VERIFY and slottedReferences.there():
            for program, known in (("interFoam", compressed), ("interIsoFoam", cut)):
                table.row(f"{label}: L1/area of {program}", known,
                          slottedReferences.error(program, n, alphas[0]), 0.01, "relative")
        # A trace of it leaves through the rim
        table.row(f"{label}: its area", 1, a.mean()/alphas[0].mean(), 1e-10)
        table.row(f"{label}: change of the velocity", 0,
                  np.max(abs(fluidField(case, 1.0, "U") - u)), 1e-12)
        table.row(f"{label}: dp/p", 0, np.max(abs(fluidField(case, 1.0, "p") - 1)), 1e-11)
    halves = {"writeInterval": 0.1, "startFrom": "latestTime"}
    whole, _ = slottedCase("slotted-whole", 32, 0.2, control=halves)
    again, _ = slottedCase("slotted-again", 32, 0.2, control=halves, before=lambda c: (
        shutil.copytree(os.path.join(whole.path, "0.1"), os.path.join(c.path, "0.1"))))
    two, _ = slottedCase("slotted-2", 32, 0.2, (2, 1, 1), halves)
    table.row("slotted disc, restart: largest difference", 0, differences(whole, again, "0.2"), 0,
              "atMost")
    table.row("slotted disc, 2 processors: largest difference", 0, differences(whole, two, "0.2"),
              1e-10)


# --- heat that the scheme makes ----------------------------------------------

def torn(table):
    """Water with nuclei of air parts with 2 v: the void is 2 (v - p0/(rho c)) t long, its
    pressure no more than the vapour's of water at 20 degrees C."""
    n, end, p0, nuclei = 200, 2.4e-4, 1e5, 1e-6
    c = np.sqrt(4.4*(p0 + 6e8)/1000)
    for v, limit in ((10.0, 5e-3), (200.0, 0.02)):
        def apart(x, y, z, v=v):
            return [1 - nuclei, nuclei], [1000.0, 1.2], np.where(x < 0.5, -v, v), p0
        for label, settings in (("", None), (", lowMach", {"lowMach": "yes"})):
            case = fluidCase("fluidsAlone", f"torn-{v:g}{label[2:]}", (n, 1, 1), (1, 0.1, 0.1),
                             {"water": WATER, "air": REAL_AIR}, apart, end, settings=settings)
            case.run("materialPointFoam")
            a, p = fluidField(case, end, "alpha.air"), fluidField(case, end, "p")
            void = a > 1e-3
            label = f"water torn with {2*v:g} m/s{label}"
            table.row(f"{label}: length of the void [m]", 2*(v - p0/1000/c)*end,
                      (a - nuclei).mean(), limit, "relative")
            table.row(f"{label}: mean pressure of the void [Pa]", 0,
                      np.sum((p*a)[void])/np.sum(a[void]), 2339, "atMost")
            table.row(f"{label}: energy added to voids over the kinetic", 0,
                      case.numbers(r"voids N \(energy N added")[-1][1]/(0.5*1000*v**2*0.01),
                      1e-3, "atMost")


def sheared(table):
    """Columns of water with bubbles of air that pass each other, until they have mixed: the
    air no hotter than all the energy makes it when it heats by mass."""
    e, v, share, p0, T0, cv = 2e-2, 40.0, 0.02, 1e5, 300.0, 287/0.4
    heat, E = 0.5*v**2, (p0 + 4.4*6e8)/3.4/1000
    low, high = p0, 10*p0
    for _ in range(100):
        p = 0.5*(low + high)
        theta = ((1 - share)*(p0 + 4.4*6e8)/(p + 4.4*6e8)*(1 + heat/E)
                 + share*(1 + heat/cv/T0)*(p/p0)**(-1/1.4))
        low, high = (p, high) if theta > 1 else (low, p)
    hottest = T0*(1 + heat/cv/T0)*(p/p0)**(0.4/1.4)

    for label, wide in (("of one cell", 1), ("of half the box", 20)):
        def columns(x, y, z, wide=wide):
            one = np.ones_like(x)
            sign = np.where(np.floor(x*40/wide) % 2 < 1, v, -v)
            return ([1 - share, share], [1000.0, p0/287/T0],
                    np.column_stack([20*one, sign, 0*one]), p0)
        case = fluidCase("fluidsAlone", f"sheared-{wide}", (40, 2, 1), (1, 0.05, 0.025),
                         {"water": WATER, "air": REAL_AIR}, columns, e,
                         patches=cyclicSides("xy")[0])
        case.run("materialPointFoam")
        a, T = fluidField(case, e, "alpha.air"), fluidField(case, e, "T.air")
        label = f"water with air, sheared columns {label}"
        table.row(f"{label}: largest T [K]", 0, T[a > 1e-9].max(), 1.01*hottest, "atMost")
        table.row(f"{label}: least T [K]", 0, T[a > 1e-9].min(), 0.99*T0, "atLeast")
        table.row(f"{label}: largest share of air over the least, less 1", 0,
                  a.max()/a.min() - 1, 0.05, "atMost")
        if wide == 1:
            table.row(f"{label}: what is left of the shear", 0,
                      np.max(abs(fluidField(case, e, "U")[:, 1]))/v, 0.05, "atMost")


# --- boundaries --------------------------------------------------------------

def fixed(value):
    return {"type": "fixedValue", "value": f"uniform {value}"}


def inflow(table):
    """Water that is given flows into air; where nothing is given, what the cell has."""
    n, u, end, start = 50, 20.0, 0.012, 0.21
    pressure, free = fixed(1e5), "zeroGradient"

    def column(x, y, z):
        a = np.clip((start - x)*n + 0.5, 0, 1)
        return [a, 1 - a], [1000.0, 1.2], u, 1e5
    case = fluidCase(
        "fluidsAlone", "inflow-given", (n, 1, 1), (1, 0.01, 0.01),
        {"water": WATER, "air": REAL_AIR}, lambda *x: ([0.0, 1.0], *column(*x)[1:]), end,
        patches={"in": ("patch", ("x-",)), "out": ("patch", ("x+",))},
        given={"in": {"U": fixed(f"({u} 0 0)"), "p": free, "alpha.water": fixed(1),
                      "alpha.air": fixed(0), "rho.water": fixed(1000),
                      "T.air": fixed(1e5/287/1.2)},
               "out": {**dict.fromkeys(("U", "alpha.water", "alpha.air", "rho.water", "T.air"),
                                       free), "p": pressure}})
    case.run("materialPointFoam")
    label = "water of the boundary flows into air"
    table.row(f"{label}: its mass [kg/m2]", 1000*u*end,
              fluidField(case, end, "thetaRho.water").mean(), 1e-12, "relative")
    table.row(f"{label}: dP/(P + pInf)", 0,
              np.max(abs(fluidField(case, end, "p") - 1e5))/6e8, 1e-12)

    def layer(x, y, z):
        return (column(y, x, z)[0], [1.0, 0.5], np.tile((1.0, 0.5, 0.0), (len(x), 1)), 1.0)
    end = 0.24
    free = dict.fromkeys(("U", "alpha.low", "alpha.high", "T.low", "T.high"), "zeroGradient")
    case = fluidCase(
        "fluidsAlone", "inflow-free", (20, n, 1), (0.4, 1, 0.02), {"low": AIR, "high": AIR}, layer,
        end, patches={"in": ("patch", ("x-", "y-")), "out": ("patch", ("x+", "y+"))},
        given={s: {**free, "p": fixed(1)} for s in ("in", "out")}, maxCoGas=0.8)
    case.run("materialPointFoam")
    a = fluidField(case, end, "alpha.low").reshape(n, 20)
    label = "a layer rises obliquely, inflow of what the cell has"
    # Shares near 1e-8 go or stay by their last digits, and sharpening makes that grow
    table.row(f"{label}: largest difference along the layer", 0, np.max(np.ptp(a, axis=1)), 5e-3)
    table.row(f"{label}: its volume", start + 0.5*end, a.mean(axis=1).sum()/n, 1e-3)
    table.row(f"{label}: dp/p", 0, np.max(abs(fluidField(case, end, "p") - 1)), 1e-12)


# --- a shock on helium -------------------------------------------------------

def helium(table):
    """tutorials/shockOnHelium on 37 cells over the diameter: velocities within the 10 % of the
    experiment, of Quirk and Karni's within 5 %; the jet (100 to 300 us) wants finer cells."""
    template = os.path.join(PROJECT, "tutorials", "shockOnHelium")
    case = FoamCase("fluidsAlone", "helium")
    case.copy(source=template)
    case.change("system/blockMeshDict", "^nx .*", "nx 195;")
    case.change("system/blockMeshDict", "^ny .*", "ny 67;")
    case.change("system/controlDict", "^endTime .*", "endTime 3.4e-4;")
    for application in ("blockMesh", "setFluids", "materialPointFoam"):
        case.run(application)
    sys.path.insert(0, template)
    import results
    found = results.Run(case.path).velocities()
    table.row("shock on helium: velocities found", 6, len(found), 0)
    for name, v in found.items():
        coarse = 0.15 if name == "jet" else None
        table.row(f"shock on helium: {name} [m/s], Haas and Sturtevant", results.MEASURED[name], v,
                  coarse or 0.1, "relative")
        table.row(f"shock on helium: {name} [m/s], Quirk and Karni", results.COMPUTED[name], v,
                  coarse or 0.05, "relative")


# --- symmetry ----------------------------------------------------------------

def corner(table):
    """Products of TNT in a corner of three planes of symmetry: no direction is another."""
    n, ordered = 20, {}

    def initial(x, y, z):
        # By sorted coordinates, so that the start is symmetric to the last bit
        s = np.sort(np.column_stack([x, y, z]), axis=1)
        a = np.mean([np.sum((s + (d - 0.5)/n)**2, axis=1) < 0.09
                     for d in np.stack(np.meshgrid(*3*[(np.arange(4) + 0.5)/4]), -1)
                     .reshape(-1, 3)], axis=0)
        # Sub-cells of sorted cells are not sorted: equal cells get the mean of both
        for i, k in enumerate(map(tuple, s.round(12))):
            a[i] = ordered.setdefault(k, a[i])
        return [a, 1 - a], [1630.0, 1000.0], 0.0, np.where(a > 0, 8.4e9, 1e5)
    planes = {f"plane{d}": ("symmetryPlane", (d + "-",)) for d in "xyz"}
    # Momentum: the velocity of air with wisps of products, 14 km/s, multiplies rounding (1e-11)
    for label, other, last in (("water", WATER, 2e-4), ("air", REAL_AIR, 2.25e-5)):
        def start(x, y, z, other=other):
            alphas, rhos, u, p = initial(x, y, z)
            return alphas, [rhos[0], 1.2 if other is REAL_AIR else 1000.0], u, p
        case = fluidCase("fluidsAlone", "corner-" + label, (n, n, n), (1, 1, 1),
                         {"tnt": TNT, label: other}, start, last,
                         patches={**planes, "ends": ("patch", ("x+", "y+", "z+"))})
        case.run("materialPointFoam")
        end = case.timeName(last)
        worst = {}
        for name in ("p", "rho", "alpha.tnt", "thetaRhoU"):
            v = volField(case, end, name).reshape(n, n, n, -1)       # [z, y, x, component]
            for axes in ((0, 2, 1), (1, 0, 2), (2, 1, 0), (1, 2, 0), (2, 0, 1)):
                w = v.transpose(*axes, 3)
                if name == "thetaRhoU":
                    # Component of x is last of the axes
                    w = w[..., [2 - axes[2 - c] for c in range(3)]]
                worst[name] = max(worst.get(name, 0), np.max(abs(v - w))/np.max(abs(v)))
        for name, value in worst.items():
            table.row(f"products of TNT in a corner, {label}: {name} with axes exchanged, largest"
                      " difference over the largest value", 0, value, 1e-12)
        table.row(f"products of TNT in a corner, {label}: steps", 100, int(re.search(
            r"^Steps: (\d+)", case.log(), re.M)[1]), 100, "atLeast")


# --- slow flow ---------------------------------------------------------------

HEAVY, LIGHT = ({"rho": rho, "equationOfState": {
    "type": "stiffenedGas", "gamma": 4.4, "pInf": 100/4.4*rho, "p0": 1.0}} for rho in (3, 1))


def RayleighTaylor(table):
    """The growing mode of linear theory, a exp(sigma t), sigma^2 = A g k, with its velocity
    and pressure as the start; Atwood number 0.5, half a wave, sound 10 sqrt(g lambda). Beside
    the growth: what of the pressure changes its sign from cell to cell, by third differences
    away from the interface, over the mode's pressure."""
    k, a0, end = 2*np.pi, 0.005, 1.0
    sigma = np.sqrt(0.5*k)
    # Measured 0.043, 0.015: what the start leaves is hardly damped
    for n, limit, uneven in ((32, 0.1, 0.05), (64, 0.05, 0.02)):
        def initial(x, y, z, n=n):
            h, eta = 1/n, a0*np.cos(k*x)
            light = np.clip((eta - y)/h + 0.5, 0, 1)
            up, decay = y > eta, np.exp(-k*abs(y))
            w, u = sigma*a0*decay*np.cos(k*x), sigma*a0*decay*np.sin(k*x)
            p = 1.0 + np.where(up, -3*y, -y) + np.where(up, 3, -1)*sigma**2*a0/k*decay*np.cos(k*x)
            # Of cells with both the mean
            q = 1.0 - y*(light + 3*(1 - light)) + (3*(1 - light) - light)*sigma**2*a0/k*np.cos(k*x)
            mixed = (light > 0) & (light < 1)
            return ([1 - light, light], [3.0, 1.0],
                    np.column_stack([np.where(up, u, -u), w, 0*u]), np.where(mixed, q, p))
        case = fluidCase("fluidsAlone", f"RayleighTaylor-{n}", (n//2, 2*n, 1), (0.5, 1, 1/n),
                         {"heavy": HEAVY, "light": LIGHT}, initial, end, low=(0, -1, 0),
                         patches={"sides": ("wall", ("x-", "x+", "y-", "y+"))},
                         gravity=(0, -1, 0), settings={"lowMach": True}, writeInterval=0.1)
        case.run("materialPointFoam")
        x, y = (np.arange(n//2) + 0.5)/n, (np.arange(2*n) + 0.5)/n - 1
        t, a, odd = [], [], []
        for name in case.times()[1:]:
            light = volField(case, name, "alpha.light").reshape(2*n, n//2)
            t.append(float(name))
            a.append(2*np.mean(light.sum(axis=0)/n*np.cos(k*x)))
            p = volField(case, name, "p").reshape(2*n, n//2)
            away = np.abs(y) > 0.2
            size = 3*sigma**2*a[-1]/k*np.exp(-0.2*k)
            odd.append(max(np.sqrt(np.mean(np.diff(part, 3, axis=d)**2))/8/size
                           for part in (p[away & (y > 0)], p[away & (y < 0)]) for d in (0, 1)))
        rate = np.polyfit(t[1:], np.log(a[1:]), 1)[0]
        table.row(f"Rayleigh and Taylor, {n} cells a wave: growth rate over linear theory's", 1,
                  rate/sigma, limit)
        table.row(f"Rayleigh and Taylor, {n} cells a wave: odd-even part of p over the mode's", 0,
                  odd[-1], uneven, "atMost")
        table.row(f"Rayleigh and Taylor, {n} cells a wave: amplitude at the end", a0*np.exp(
            sigma*end), a[-1], 2*limit, "relative")


# --- rest --------------------------------------------------------------------

def rest(table):
    """Water below air, one cell shared, 1e4 steps under gravity."""
    n, g, dt = 60, 9.81, 2e-6

    def initial(x, y, z):
        a = np.where(x < 0.5, 1.0, 0.0)
        a[n//2] = 0.3
        rho = a*1000 + (1 - a)*1.2
        jumps = g/n*0.5*(rho[1:] + rho[:-1])
        p = 1e5 + np.append(np.cumsum(jumps[::-1])[::-1], 0)
        return [a, 1 - a], [1000.0, 1.2], 0.0, p
    end = 1e4*dt
    case = fluidCase("fluidsAlone", "rest", (n, 1, 1), (1, 0.01, 0.01),
                     {"water": WATER, "air": REAL_AIR}, initial, end, ends=CLOSED,
                     gravity=(-g, 0, 0), writeInterval=end/10, control={
                         "deltaT": dt, "adjustTimeStep": False, "functions": {"balance": {
                             "type": "fluidBalance", "libs": ["mpmFunctionObjects"],
                             "writeControl": "timeStep", "writeInterval": 1000}}})
    case.run("materialPointFoam")
    # Columns: mass second, rest of momentum along x the fourth but last
    total = case.series("balance", "total.dat")
    table.row("rest of water and air: momentum less impulse of walls and gravity, over weight t",
              0, np.max(np.abs(total[:, -4]))/(total[0, 1]*g*end), 1e-9)
    # Rounding of pInf moves the shared cell's pressure by 5e-7 Pa
    table.row("rest of water and air, 1e4 steps: largest velocity [m/s]", 0, max(
        np.max(abs(fluidField(case, float(t), "U"))) for t in case.times()[1:]), 1e-11)
    p = fluidField(case, end, "p")
    table.row("rest of water and air: weight [Pa]",
              g/n*(29.5*1000 + 300 + 0.7*1.2 + 28.5*1.2 + 1000*0.5 - 500 + 0), p[0] - p[-1], 30)


def noise(table):
    """Velocities of 1e-4 m/s at random in air and in soft water, closed box: with 0.4
    they die, with 0.6 stay small; where lowMach leaves no dissipation they grow a thousandfold."""
    n, soft = 40, {"rho": 1000, "equationOfState": {
        "type": "stiffenedGas", "gamma": 1.12, "soundSpeed": 25, "p0": 1e3}}
    air = {"thermo": "perfectGas", "R": 287.0, "gamma": 1.4}
    u = np.column_stack([*1e-4*np.random.default_rng(1).standard_normal((2, n*n)), np.zeros(n*n)])
    for name, share in (("air", 0.0), ("water", 1.0)):
        for Co in (0.4, 0.6):
            case = fluidCase("fluidsAlone", f"noise-{name}-{Co}", (n, n, 1), (1, 1, 0.025),
                             {"water": soft, "air": air}, lambda x, y, z, share=share: (
                                 [share + 0*x, 1 - share + 0*x], [1000.0, 1e3/287/2.9], u, 1e3),
                             1.0, ends=WALL, sides=WALL, settings={"lowMach": "yes"},
                             reconstruct=VAN_LEER, control={"maxCoGas": Co})
            case.run("materialPointFoam")
            table.row(f"noise in {name}, lowMach, maxCoGas {Co}: largest velocity after 25 or more"
                      " passages of sound over that at the start", 0, np.abs(
                          fluidField(case, 1.0, "U")).max()/np.abs(u).max(), 5, "atMost")


# --- processors, restart -----------------------------------------------------

FIELDS = ("p", "U", "rho", "alpha.disc", "alpha.air", "thetaRho.disc", "thetaRho.air",
          "thetaRhoE")


def differences(a, b, time):
    worst = 0.0
    for name in FIELDS:
        u, v = volField(a, time, name), volField(b, time, name)
        worst = max(worst, np.max(abs(u - v))/np.max(abs(u)))
    return worst


def ranks(table):
    end = 0.5
    one, _ = discCase("ranks-1", 24, end)
    for split in ((2, 1, 1), (3, 1, 1), (2, 2, 1)):
        n = int(np.prod(split))
        other, _ = discCase(f"ranks-{n}", 24, end, split)
        table.row(f"disc, {n} processors: largest difference", 0,
                  differences(one, other, one.timeName(end)), 1e-10)


def restart(table):
    for label, split in (("one processor", None), ("2 processors", (2, 1, 1))):
        runs = []
        for half in (False, True):
            case = discCase("restart-" + ("again" if half else "whole"), 24, 0.5, split,
                            control={"writeInterval": 0.25, "startFrom": "latestTime"},
                            before=lambda c, h=half: h and [
                                shutil.copytree(os.path.join(u, "0.25"), os.path.join(v, "0.25"))
                                for u, v in zip(runs[0].processors() or [runs[0].path],
                                                c.processors() or [c.path])])[0]
            runs.append(case)
        table.row(f"restart, {label}: largest difference", 0, differences(*runs, "0.5"), 0,
                  "atMost")


# --- a softened liquid, nuclei ------------------------------------------------

def softened(table):
    """soundSpeed is that of the waves; a flow too fast for it is told once; nuclei."""
    c, n = 50.0, 200
    soft = {"rho": 1000, "nuclei": 0, "equationOfState": {
        "type": "stiffenedGas", "gamma": 4.4, "soundSpeed": c, "p0": 1e5}}

    def initial(x, y, z):
        p = np.where(x < 0.5, 1e5 + 10, 1e5)
        return [1.0, 0.0], [1000.0 + (p - 1e5)/c**2, 1.2], np.where(x < 0.5, 10/1000/c, 0), p
    end = 0.3/c
    case = fluidCase("fluidsAlone", "softened", (n, 1, 1), (1, 0.01, 0.01),
                     {"water": soft, "air": {**REAL_AIR, "nuclei": 0}}, initial, end)
    case.run("materialPointFoam")
    p = fluidField(case, end, "p") - 1e5
    x = (np.arange(n) + 0.5)/n
    table.row("softened water: way of a weak wave [m]", 0.3, np.interp(-5, -p, x) - 0.5, 0.003)
    table.check("softened water: a slow flow is not told of", "soundSpeed" not in
                case.log().split("Time =")[-1])
    for u, told in ((4.9, 0), (5.2, 1)):
        case = fluidCase("fluidsAlone", f"softened-{u}", (10, 1, 1), (1, 0.01, 0.01),
                         {"water": soft, "air": REAL_AIR},
                         lambda x, y, z, u=u: ([1.0, 0.0], [1000.0, 1.2], u, 1e5), 0.01,
                         patches=cyclicSides("x")[0])
        case.run("materialPointFoam")
        table.row(f"softened water: warnings at {u/c:.3f} of its sound", told,
                  case.log().count("Give it a soundSpeed of"), 0)
    case = fluidCase("fluidsAlone", "nuclei", (10, 1, 1), (1, 0.01, 0.01),
                     {"water": WATER, "air": {**REAL_AIR, "nuclei": 1e-5}},
                     lambda x, y, z: ([1.0*(x < 0.5), 1.0*(x > 0.5)], [1000.0, 1.2], 0.0, 1e5),
                     1e-4, writeInterval=1e-6)
    case.run("materialPointFoam")
    a = volField(case, "1e-06", "alpha.air")
    table.row("nuclei: least share of air", 1e-5, a.min(), 1e-9)
    table.row("nuclei: largest share of air", 1, a.max(), 1e-12)


# --- wrong input -------------------------------------------------------------

def wrong(table):
    def initial(x, y, z):
        a = 1.0*(x < 0.5)
        return [a, 1 - a], [1000.0, 1.2], 0.0, 1e5

    def case(label, fluids=None, change=None, **options):
        c = fluidCase("fluidsAlone", "wrong-" + label, (8, 1, 1), (1, 0.1, 0.1),
                      fluids or {"water": WATER, "air": AIR}, initial, 1e-6, **options)
        if change:
            change(c)
        return c

    def replace(name, old, new):
        def change(c):
            with open(c.file(name)) as f:
                text = f.read()
            with open(c.file(name), "w") as f:
                f.write(text.replace(old, new))
        return change
    def beside(c):
        law = {"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0}
        besidePoints(c, {"water": WATER, "air": AIR}, {"bar": {"constitutiveModel": law}}, {
            "bar": {"phase": "bar", "type": "box", "min": (0.4, 0, 0), "max": (0.6, 1, 1)}},
                     settings=given)
    given = {"velocity": "given"}
    tait = {"rho": 1000, "equationOfState": {"type": "Tait", "K": 2.2e9, "n": 7, "p0": 1e5}}
    for label, made, words in (
            ("noEnergy", lambda: case("noEnergy", {"water": tait, "air": AIR}),
             ("water", "stiffenedGas", "pInf")),
            ("sum", lambda: case("sum", change=lambda c: shutil.copy(
                c.file("0/alpha.water"), c.file("0/alpha.air"))), ("add up to", "alpha")),
            ("share", lambda: case("share", change=replace("0/alpha.water", "1.0", "1.5")),
             ("alpha.water", "1.5", "[0, 1]")),
            ("noShares", lambda: case("noShares", change=lambda c: [
                os.remove(c.file("0", f)) for f in ("alpha.water", "alpha.air")]),
             ("alpha.air", "missing")),
            ("noTemperature", lambda: case("noTemperature", change=lambda c: os.remove(
                c.file("0/T.air"))), ("T.air", "missing")),
            ("mixed", lambda: case("mixed", change=replace(
                "constant/phaseProperties", "type fluid;\n    thermo", "type gas;\n    thermo")),
             ("type gas", "type fluid")),
            ("twoSounds", lambda: case("twoSounds", {"water": {"rho": 1000, "equationOfState": {
                **WATER["equationOfState"], "soundSpeed": 20}}, "air": AIR}),
             ("pInf and soundSpeed",)),
            ("slowSound", lambda: case("slowSound", {"water": {"rho": 1000, "equationOfState": {
                "type": "stiffenedGas", "gamma": 4.4, "soundSpeed": 20, "p0": 1e5}}, "air": AIR}),
             ("soundSpeed 20", "20.97")),
            ("nuclei", lambda: case("nuclei", {"water": WATER, "air": {**AIR, "nuclei": 0.5}}),
             ("nuclei", "0.01")),
            ("keyword", lambda: case("keyword", {"water": WATER, "air": {**AIR, "gama": 1.4}}),
             ("gama", "gamma")),
            ("setting", lambda: case("setting", settings={"lowmach": True}),
             ("lowmach", "lowMach")),
            ("velocity", lambda: case("velocity", settings={"velocity": "fixed"}),
             ("fixed", "velocity", "computed", "given")),
            ("givenGravity", lambda: case("givenGravity", settings=given, gravity=(-9.81, 0, 0)),
             ("velocity given", "constant/g", "velocity computed")),
            ("givenPoints", lambda: case("givenPoints", change=beside),
             ("velocity given", "phases of points", "velocity computed"))):
        c = made()
        try:
            c.run("materialPointFoam")
            table.check(f"wrong input: {label}", False, "ran")
            continue
        except RunFailed:
            pass
        text = c.log()
        missing = [w for w in words if w not in text]
        table.check(f"wrong input: {label}",
                    not missing and "FOAM FATAL" in text and "printStack" not in text,
                    f"message lacks {missing}")


if __name__ == "__main__":
    sys.exit(runParts("fluidsAlone", tubes, vanDerWaals, translation, disc, slotted, torn, sheared,
                      inflow, helium, corner, RayleighTaylor, rest, noise, ranks, restart, softened,
                      wrong))
