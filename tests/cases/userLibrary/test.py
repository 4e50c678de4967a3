#!/usr/bin/env python3
"""Models of a user's library (etc/codeTemplates), loaded with libs and selected by name,
each against an exact value.

    compiles    wmake outside the tree of the project, without a warning; each in one file
                under 60 lines (heldNodes, two kinds in one: 80)
    law         Maxwell: simple shear at a rate r between walls, on cyclic sides: the stress
                is G r T (1 - exp(-t/T)), T the relaxation time. The law has it exactly for
                a constant rate: to rounding
    equation    NobleAbel, of the gas alone: the shock that runs back from a wall has the
                pressure of a perfect gas of the specific volume 1/rho - b (200 cells,
                0.2 % as the plateaus of tests/cases/riemannEquations)
    gas         mixture, a thermo: of two gases with the mean R and gamma of one, bit by bit
                as this one. quadraticViscosity, a face flux: the shock is another (1e-3),
                the pressure behind it the exact one
    drag        quadratic: dust with another velocity than the air around. Per volume both
                have M_s and M_g: the slip is w0/(1 + t/t0) with
                1/t0 = K/w (1/M_s + 1/M_g) w0. The implicit step has it exactly
    friction    viscousFriction: a block on a floor, whose normal force is m g: the velocity
                is u0 exp(-mu I/speed), I the integral of g over time
    spring      wallSpring: period of a block, 2 pi sqrt(m/k); the same on 2 processors
    force       shaking: a block under a sin(2 pi f t) from rest has moved
                a/(2 pi f) (t - sin(2 pi f t)/(2 pi f))
    object      centreOfMass: its last row against the points written
    failure     hydrostaticTension: of points that start with a mean stress below and above
                the strength those above fail
    criterion   fastPoints of an adaptive mesh
    erosion     behindPlane: a block that flies through an oblique plane: left are the points
                before it
    heat        WhitakerHeat: gas and dust with a slip that nothing changes; the gap of their
                temperatures after n implicit steps is (1 + rate dt)^-n, exact
    pressure    linearGrains: standing wave of packed grains in a thin gas, c = sqrt(k/rho)
    column      peakStress: the largest of all steps written; a restart goes on bit by bit;
                two processors
    nodes       heldNodes in the cells of a floor: as a fixedValue of the patch, bit by bit
    choices     an unknown name: the error names the user's among the valid ones
"""

import glob
import os
import re
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from coupledCases import coupledCase, gasLog
from foamCase import (FoamCase, boxMesh, controlDict, noSchemes, readField, runParts,
                      velocityFile, writeField)
from gasCases import WALL, gasCase, volField
from templates import SCHEMES, TEMPLATES, compileTemplates

LIBS = {"libs": '("../library/libuserLibrary.so")'}
FLIP = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0}
ELASTIC = {"type": "linearElastic", "rho": 1000, "E": 1e4, "nu": 0.3}
CENTRE = {"centre": {"type": "centreOfMass", "phase": "block", "writeControl": "timeStep",
                     "writeInterval": 1}}
H = 0.1


def compiles(table):
    # The schemes are compiled by userSchemes
    with open(os.path.join(TEMPLATES, "Make/files")) as f:
        made = {line for line in f.read().split() if line.endswith(".C")}
    case = compileTemplates("userLibrary", sorted(made - set(SCHEMES)), "userLibrary")
    table.check("a user's library compiles without a warning",
                "warning:" not in case.log("wmake"))
    names = sorted(glob.glob(os.path.join(TEMPLATES, "*.C")))
    table.check("all templates are compiled", made == {os.path.basename(n) for n in names})
    for name in names:
        base = os.path.basename(name)
        most = 79 if base in ("heldNodes.C", "nodewiseLinear.C") else 59
        with open(name) as f:
            table.row(f"lines of {base}", most, len(f.readlines()), most, "atMost")


def planeCase(name, cells, patches, conditions, region, end, dt, law=None, phase=None,
              properties=None):
    """A block in 2D, cells of H."""
    case = FoamCase("userLibrary", name)
    case.write("constant/phaseProperties", {
        "phases": ["block"],
        "block": {"constitutiveModel": law or ELASTIC, **(phase or {})},
        **(properties or {})})
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (H*cells[0], H*cells[1], H), (*cells, 1),
        {**patches, "frontAndBack": ("empty", ("z-", "z+"))}))
    velocityFile(case, "block", {**conditions, "frontAndBack": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {
        "block": {"phase": "block", "pointsPerCell": 2, **region}}})
    case.write("system/fvSolution", {"materialPoints": FLIP})
    noSchemes(case)
    case.write("system/controlDict", {
        **LIBS, **controlDict(end, end, deltaT=dt, functions=CENTRE)})
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def freeBlock(name, end, dt, **more):
    """4 x 2 cells of matter that nothing touches."""
    return planeCase(name, (16, 6), {"outside": ("patch", ("x-", "x+", "y-", "y+"))},
                     {"outside": "calculated"},
                     {"type": "box", "min": (6*H, 2*H, 0), "max": (10*H, 4*H, H)}, end, dt,
                     **more)


def centre(case):
    series = case.series("centre", "block.dat")
    return series[:, 0], series[:, 1:4]


def unknown(table, case, user, words, key="type"):
    """Another name in place of the user's: the error names his among the valid ones."""
    case.change("constant/phaseProperties", f"{key} {user};", f"{key} best;")
    case.run("materialPointFoam", fails=True)
    case.change("constant/phaseProperties", f"{key} best;", f"{key} {user};")
    log = " ".join(case.log().split())
    error = log[log.find("FATAL IO ERROR"):]
    table.check(f"unknown name in place of {user}: the error names all",
                all(w in error for w in ("best", user, *words)), error[:200])


# --- law ---------------------------------------------------------------------

def law(table):
    n, rate, G, T, dt, steps = 4, 5.0, 1e4, 0.05, 1e-3, 100
    wall = {"type": "fixedValue", "value": "uniform (0 0 0)"}
    case = planeCase(
        "shear", (n, n),
        {"left": ("cyclic; neighbourPatch right", ("x-",)),
         "right": ("cyclic; neighbourPatch left", ("x+",)),
         "low": ("patch", ("y-",)), "high": ("patch", ("y+",))},
        {"left": "cyclic", "right": "cyclic", "low": wall,
         "high": {**wall, "value": f"uniform ({rate*n*H} 0 0)"}},
        {"type": "box", "min": (0, 0, 0), "max": (n*H, n*H, H)}, steps*dt, dt,
        law={"type": "Maxwell", "rho": 1000, "K": 2e4, "G": G, "relaxationTime": T})
    path = case.file("0/lagrangian/block")
    x = readField(os.path.join(path, "x"))
    writeField(os.path.join(path, "U"), np.outer(rate*x[:, 1], (1, 0, 0)))
    case.run("materialPointFoam")
    sigma = case.points(case.times()[-1], "block")["sigma"]
    exact = G*rate*T*(1 - np.exp(-steps*dt/T))
    table.row("law: shear stress of any point over the exact one - 1", 0,
              np.max(abs(sigma[:, 1]/exact - 1)), 1e-10)
    table.row("law: other stresses over it", 0,
              np.max(abs(sigma[:, (0, 2, 3, 4, 5)]))/exact, 1e-10)


# --- equation ----------------------------------------------------------------

def wallPressure(volume, p, u, gamma):
    """Of a perfect gas of a specific volume that runs into a wall: the root q of
    u^2 = (q - p)^2 A/(q + B), A = 2 volume/(gamma + 1), B = p (gamma - 1)/(gamma + 1)."""
    half = 0.25*(gamma + 1)*u**2/volume
    return p + half + np.sqrt(half**2 + 2*half*p*2*gamma/(gamma + 1))


def equation(table):
    n, rho, p, u, gamma, b, end = 200, 1.0, 1.0, 1.0, 1.4, 0.4, 0.2
    case = gasCase(
        "userLibrary", "equation", (n, 1, 1), (1, 0.01, 0.01),
        lambda x, y, z: (rho + 0*x, u + 0*x, p + 0*x), end, ends=WALL,
        thermo={"rho": rho, "equationOfState": {"type": "NobleAbel", "gamma": gamma, "b": b,
                                                "p0": p}}, control=LIBS)
    case.run("materialPointFoam")
    exact = wallPressure(1/rho - b, p, u, gamma)
    table.check("equation: a perfect gas would have 10 % less",
                wallPressure(1/rho, p, u, gamma) < 0.9*exact)
    measured = volField(case, case.timeName(end), "p")[3*n//4:-n//20]
    table.row("equation: pressure behind the shock", exact, measured.mean(), 2e-3, "relative")
    unknown(table, case, "NobleAbel", ("equationOfState", "stiffenedGas"))


# --- gas ---------------------------------------------------------------------

def gas(table):
    n, end, p = 200, 0.2, {}
    perfect = {"thermo": "perfectGas", "R": 1, "gamma": 1.4}
    for name, thermo in (
            ("one", perfect),
            ("mixture", {"thermo": "mixture", "components": {
                "light": {"Y": 0.5, "R": 1.2, "Cp": 4}, "heavy": {"Y": 0.5, "R": 0.8, "Cp": 3}}}),
            ("viscosity", {**perfect, "faceFlux": "quadraticViscosity", "C": 1})):
        case = gasCase("userLibrary", name, (n, 1, 1), (1, 0.01, 0.01),
                       lambda x, y, z: (1 + 0*x, 1 + 0*x, 1 + 0*x), end, ends=WALL,
                       thermo=thermo, control=LIBS)
        case.run("materialPointFoam")
        p[name] = volField(case, case.timeName(end), "p")
        if name == "mixture":
            unknown(table, case, "mixture", ("perfectGas", "isentropic"), "thermo")
    table.row("gas: mixture against one gas", 0, np.max(abs(p["mixture"] - p["one"])), 0)
    table.row("gas: quadraticViscosity against none", 1e-3,
              np.max(abs(p["viscosity"] - p["one"])), 1e-3, "atLeast")
    table.row("gas: pressure behind the shock with it", wallPressure(1, 1, 1, 1.4),
              p["viscosity"][17*n//20:-n//20].mean(), 2e-3, "relative")
    unknown(table, case, "quadraticViscosity", ("impedance",), "faceFlux")


# --- drag --------------------------------------------------------------------

def drag(table):
    n, h, w0, rho, rhoS, alpha, eps, C = 4, 1e-2, 10.0, 1.2, 2500.0, 2e-3, 1e-2, 5000.0
    end = 1e-2
    case = coupledCase(
        "userLibrary", "drag", (n, 1, 1), (n*h, h, h),
        lambda x, y, z: (rho + 0*x, 0*x, 1e5 + 0*x), end,
        {"dust": {"volumeModel": "grains",
                  "constitutiveModel": {"type": "noStress", "rho": rhoS},
                  "drag": {"type": "quadratic", "C": C}}},
        {"dust": {"type": "cells", "volumeFraction": alpha, "velocity": (w0, 0, 0)}},
        patches={"left": ("cyclic; neighbourPatch right", ("x-",)),
                 "right": ("cyclic; neighbourPatch left", ("x+",))},
        control={**LIBS, "reportInterval": 1})
    case.run("materialPointFoam")
    g = gasLog(case)
    V = n*h**3
    thetaS = (1 - eps)*alpha
    Ms, Mg = alpha*rhoS, (1 - thetaS)*rho
    u = g["pointMomentum"][-1, 0]/(Ms*V)
    U = g["momentum"][-1, 0]/(Mg*V)
    rate = C*thetaS*(1/Ms + 1/Mg)*w0
    print(f"drag: {case.nSteps()} steps, t/t0 {rate*end:.3f}")
    table.row("drag: slip after the run over that at the start", 1/(1 + rate*end),
              (u - U)/w0, 1e-3, "relative")
    unknown(table, case, "quadratic", ("dragModel", "SchillerNaumann"))


# --- friction ----------------------------------------------------------------

def friction(table):
    g, ramp, u0, mu, speed, end = 9.81, 0.2, 1.0, 0.4, 2.0, 0.8
    case = planeCase(
        "friction", (24, 6), {"floor": ("patch", ("y-",)),
                              "rest": ("patch", ("x-", "x+", "y+"))},
        {"floor": "calculated", "rest": "calculated"},
        {"type": "box", "min": (4*H, 0, 0), "max": (14*H, 3*H, H),
         "velocity": (u0, 0, 0)}, end, 5e-4,
        law={"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0.3},
        phase={"bodyForce": {"type": "uniform", "acceleration":
               f"table ((0 (0 0 0)) ({ramp} (0 {-g} 0)) (10 (0 {-g} 0)))"}},
        properties={"contact": {"slide": {
            "fields": "(block)", "patch": "floor", "type": "viscousFriction", "mu": mu,
            "speed": speed}}})
    case.run("materialPointFoam")
    U = case.points(case.times()[-1], "block").byId("U")[:, 0]
    exact = u0*np.exp(-mu/speed*g*(end - ramp/2))
    table.row("friction: velocity of the sliding block [m/s]", exact, np.mean(U), 1e-2,
              "relative")


# --- spring, force, object ---------------------------------------------------

def spring(table):
    m, k = 1000*4*2*H**3, 50.0
    period = 2*np.pi*np.sqrt(m/k)
    case = freeBlock("spring", 2*period, period/400, properties={"stepParts": {
        "anchor": {"type": "wallSpring", "phase": "block", "k": k,
                   "rest": (0.7, 3*H, 0)}}})
    case.run("materialPointFoam")
    t, x = centre(case)
    way = x[:, 0] - 0.7
    case.decompose((2, 1, 1))
    case.runParallel()
    table.row("spring: 1 and 2 processors, centre at the end [m]", x[-1, 0],
              case.series("centre", "block_1.dat")[-1, 1], 1e-12)
    i = np.nonzero(way[1:]*way[:-1] < 0)[0]
    zeros = t[i] - way[i]*(t[i + 1] - t[i])/(way[i + 1] - way[i])
    table.row("spring: passages through rest", 4, len(zeros), 0)
    table.row("spring: period [s]", period, zeros[2] - zeros[0], 1e-3, "relative")
    table.row("spring: amplitude at the end [m]", 0.1, np.max(way[len(way)//2:]), 1e-3,
              "relative")


def force(table):
    a, f, end, dt = 2.0, 1.5, 0.8, 1e-3
    case = freeBlock("force", end, dt, phase={"bodyForce": {
        "type": "shaking", "amplitude": (a, 0, 0), "frequency": f}})
    case.run("materialPointFoam")
    t, x = centre(case)
    w = 2*np.pi*f
    exact = a/w*(end - np.sin(w*end)/w)
    first = case.points("0", "block")
    table.row("force: way of a shaken block [m]", exact,
              x[-1, 0] - np.mean(first["x"][:, 0]), 2e-3, "relative")
    last = case.points(case.times()[-1], "block")
    table.row("object: centre of mass against the points written [m]", 0,
              np.max(abs(last["x"].mean(axis=0) - x[-1])[:2]), 1e-14)


# --- failure, erosion --------------------------------------------------------

def failure(table):
    s, half = 1e3, 4*H
    regions = {side: {"phase": "block", "type": "box", "min": (x, 0, 0),
                      "max": (x + half, 4*H, H), "stress": (p, 0, 0, p, 0, p),
                      "pointsPerCell": 2}
               for side, x, p in (("low", 0, 0.99*s), ("high", half, 1.01*s))}
    case = planeCase(
        "failure", (8, 4), {"outside": ("patch", ("x-", "x+", "y-", "y+"))},
        {"outside": "calculated"}, {"type": "cells"}, 1e-6, 1e-6,
        phase={"failureModel": {"type": "hydrostaticTension", "strength": s}})
    case.write("system/setMaterialPointsDict", {"regions": regions})
    case.run("setMaterialPoints", "-force")
    case.run("materialPointFoam")
    points = case.points(case.times()[-1], "block")
    failed = points["damage"] >= 1
    table.row("failure: points that fail", 64, np.sum(failed), 0)
    table.check("failure: those above the strength",
                np.array_equal(failed, points["x"][:, 0] > half))
    unknown(table, case, "hydrostaticTension", ("failureModel", "maxPrincipalStress"))


def erosion(table):
    u, end, n, origin = 2.0, 0.1, np.array((1.0, 0.5)), np.array((1.1, 0.3))
    case = planeCase(
        "erosion", (16, 6), {"outside": ("patch", ("x-", "x+", "y-", "y+"))},
        {"outside": "calculated"},
        {"type": "box", "min": (6*H, 2*H, 0), "max": (10*H, 4*H, H),
         "velocity": (u, 0, 0)}, end, 1e-3,
        phase={"erosion": {"type": "behindPlane", "origin": (*origin, 0),
                           "normal": (*n, 0)}})
    case.run("materialPointFoam")
    first, last = case.points("0", "block"), case.points(case.times()[-1], "block")
    before = (first["x"][:, :2] + (u*end, 0) - origin).dot(n) <= 0
    table.row("erosion: points before the plane", np.sum(before), len(last["id"]), 0)
    table.check("erosion: these points, some of all", 0 < np.sum(before) < len(before)
                and set(last["id"]) == set(first["id"][before]))
    unknown(table, case, "behindPlane", ("erosion", "plasticStrain"))


# --- heat, pressure of grains ------------------------------------------------

PERIODIC = {"left": ("cyclic; neighbourPatch right", ("x-",)),
            "right": ("cyclic; neighbourPatch left", ("x+",))}


def heat(table):
    n, h, u, rho, rhoS, alpha, eps, d = 4, 1e-2, 10.0, 1.2, 2500.0, 2e-3, 1e-2, 1e-4
    mu, Pr, gamma, p, CvS, Ts, dt, steps = 2e-5, 0.7, 1.4, 1e5, 1.0, 2e5, 2e-4, 40
    case = coupledCase(
        "userLibrary", "heat", (n, 1, 1), (n*h, h, h),
        lambda x, y, z: (rho + 0*x, 0*x, p + 0*x), steps*dt,
        {"dust": {"volumeModel": "grains", "Cv": CvS, "drag": {"type": "none"},
                  "constitutiveModel": {"type": "noStress", "rho": rhoS},
                  "heatTransfer": {"type": "Whitaker", "d": d}}},
        {"dust": {"type": "cells", "volumeFraction": alpha, "velocity": (u, 0, 0),
                  "temperature": Ts}},
        gas={"mu": mu, "Pr": Pr}, patches=PERIODIC,
        control={**LIBS, "reportInterval": 1, "adjustTimeStep": False, "deltaT": dt,
                 "writeControl": "runTime"})
    case.change("system/controlDict", r"maxCo .*;", "")
    case.run("materialPointFoam")
    thetaS = (1 - eps)*alpha
    Cs, Cg = alpha*rhoS*CvS, (1 - thetaS)*rho/(gamma - 1)
    held = [float(line.split()[3].rstrip(",")) for line in case.log().split("\n")
            if line.startswith("Heat of dust:")]
    T = gasLog(case)["energy"]/(Cg*n*h**3)
    gap = (held[-1]/(Cs*n*h**3) - T[-1])/(Ts - p/rho)
    Re = rho*u*d/mu
    Nu = 2 + (0.4*Re**0.5 + 0.06*Re**(2/3))*Pr**0.4
    rate = 6*thetaS*mu*gamma/(gamma - 1)/Pr*Nu/d**2*(1/Cs + 1/Cg)
    exact = (1 + rate*dt)**-steps
    print(f"heat: Re {Re:.1f}, Nu {Nu:.3f}, gap {exact:.4f}")
    table.row("heat: gap of temperatures over that at the start", exact, gap, 1e-9,
              "relative")
    unknown(table, case, "Whitaker", ("heatTransferModel", "RanzMarshall"))


def pressure(table):
    n, h, k, rhoS, alpha, least = 32, 1e-2, 1e5, 1000.0, 0.6, 0.5
    L, v = n*h, 0.02
    period = L/np.sqrt(k/rhoS)
    case = coupledCase(
        "userLibrary", "pressure", (n, 1, 1), (L, h, h),
        lambda x, y, z: (1e-3 + 0*x, 0*x, 1 + 0*x), period,
        {"dust": {"volumeModel": "grains", "drag": {"type": "none"},
                  "constitutiveModel": {"type": "noStress", "rho": rhoS},
                  "granularPressure": {"type": "linear", "alphaMin": least, "k": k,
                                       "linear": 0, "quadratic": 0}}},
        {"dust": {"type": "cells", "volumeFraction": alpha}}, patches=PERIODIC,
        numerics={"PICfraction": 0}, control={**LIBS, "reportInterval": 1})
    path = case.file("0/lagrangian/dust")
    x = readField(os.path.join(path, "x"))
    mode = np.sin(2*np.pi*x[:, 0]/L)
    writeField(os.path.join(path, "U"), np.outer(v*mode, (1, 0, 0)))
    case.run("materialPointFoam")
    g = gasLog(case)
    kinetic, time = g["kinetic"], np.array(
        [float(line.split()[2]) for line in case.log().split("\n")
         if line.startswith("Time = ")])
    # v cos(2 pi t/period): the kinetic energy is least at a quarter and three quarters
    least = [time[low][np.argmin(kinetic[low])]
             for low in (time < 0.5*period, time > 0.5*period)]
    print(f"pressure: least kinetic energy at {least} of {period}")
    table.row("pressure: period of a wave of packed grains [s]", period,
              2*(least[1] - least[0]), 0.02, "relative")
    unknown(table, case, "linear", ("granularPressure", "JohnsonJackson"))


# --- column, nodes -----------------------------------------------------------

def column(table):
    dt, steps = 5e-3, 40
    case = planeCase(
        "column", (16, 6), {"outside": ("patch", ("x-", "x+", "y-", "y+"))},
        {"outside": "calculated"},
        {"type": "box", "min": (6*H, 2*H, 0), "max": (10*H, 4*H, H),
         "velocity": {"x": "table ((0.6 (1 0 0)) (0.8 (-1 0 0)) (1 (1 0 0)))"}}, steps*dt, dt,
        properties={"stepParts": {"peak": {"type": "peakStress", "phase": "block"}}})
    case.change("system/controlDict", "^writeInterval .*;", f"writeInterval {dt};")
    case.run("materialPointFoam")
    times = case.times("lagrangian")[1:]
    last = case.points(times[-1], "block").byId("peak")
    table.row("column: steps written", steps, len(times), 0)
    largest = np.max([case.points(t, "block").byId("sigmaEq") for t in times], axis=0)
    now = case.points(times[-1], "block").byId("sigmaEq")
    table.row("column: largest of all steps", 0, np.max(abs(last/largest - 1)), 1e-12)
    table.check("column: it is not that of the end", np.max(now/largest) < 0.9
                or np.sum(now < 0.9*largest) > 16)
    case.change("system/controlDict", "^startFrom .*;", "startFrom startTime;")
    case.change("system/controlDict", "^startTime .*;", f"startTime {times[len(times)//2]};")
    case.run("materialPointFoam")
    again = case.points(times[-1], "block").byId("peak")
    table.check("column: restart bit by bit", np.array_equal(last, again))
    case.change("system/controlDict", "^startTime .*;", "startTime 0;")
    case.decompose((2, 1, 1))
    case.runParallel()
    case.run("reconstructPar", "-latestTime")
    two = case.points(times[-1], "block").byId("peak")
    table.row("column: 2 processors", 0, np.max(abs(two/last - 1)), 1e-10)


def nodes(table):
    v, end, dt = 0.5, 0.1, 5e-4
    cases = []
    for name, floor, parts in (
            ("patch", {"type": "fixedValue", "value": f"uniform ({v} 0 0)"}, {}),
            ("held", "calculated", {"stepParts": {"grip": {
                "type": "heldNodes", "field": "block", "min": (-1, -1e-3, -1),
                "max": (9, 1e-3, 1), "velocity": (v, 0, 0)}}})):
        case = planeCase(
            "nodes" + name, (16, 6), {"floor": ("patch", ("y-",)),
                                      "rest": ("patch", ("x-", "x+", "y+"))},
            {"floor": floor, "rest": "calculated"},
            {"type": "box", "min": (4*H, 0, 0), "max": (8*H, 3*H, H)}, end, dt,
            properties=parts)
        case.run("materialPointFoam")
        cases.append(case)
    time = cases[0].times()[-1]
    table.row("nodes: held by the part against the patch", 0, cases[0].largestDifference(
        cases[1], time, ["block"], ["x", "U", "sigma", "V"]), 0)
    table.row("nodes: largest velocity of a point [m/s]", 0.1*v,
              np.max(cases[1].points(time, "block")["U"][:, 0]), 0.1*v, "atLeast")


# --- criterion of an adaptive mesh -------------------------------------------

def criterion(table):
    """A fast block and a slow one: cells are halved at the fast one."""
    case = freeBlock("criterion", 1e-3, 1e-3)
    case.write("system/setMaterialPointsDict", {"regions": {
        name: {"phase": "block", "type": "box", "min": (x, 2*H, 0), "max": (x + 2*H, 4*H, H),
               "pointsPerCell": 2, "velocity": (0, u, 0)}
        for name, x, u in (("slow", 2*H, 0.1), ("fast", 12*H, 2))}})
    case.run("setMaterialPoints")
    case.write("system/fvSolution", {"materialPoints": {**FLIP, "shapeFunction": "nodeDual"}})
    case.write("system/adaptiveMeshDict", {"maxLevel": 1, "buffer": 0, "keep": 0, "refine": {
        "fast": {"type": "fastPoints", "speed": 1}}})
    case.run("materialPointFoam")
    cells = [int(n) for n in re.findall(r"^Adaptive mesh: (\d+) cells", case.log(), re.M)]
    table.row("criterion: 16 by 6 cells, four of them halved", 16*6 + 4*3, cells[-1], 0)


# --- choices -----------------------------------------------------------------

def choices(table):
    contact = {"fields": "(block)", "patch": "outside", "type": "viscousFriction", "mu": 1,
               "speed": 1}
    spring = {"phase": "block", "k": 1, "rest": (0, 0, 0), "type": "wallSpring"}
    case = freeBlock(
        "choices", 1e-3, 1e-3,
        law={"type": "Maxwell", "rho": 1000, "K": 2e4, "G": 1e4, "relaxationTime": 1},
        phase={"bodyForce": {"type": "shaking", "amplitude": (0, 0, 0), "frequency": 1}},
        properties={"contact": {"one": contact}, "stepParts": {"one": spring}})
    case.run("materialPointFoam")
    table.check("all of them in one case", "Contact one" in case.log())
    for user, words in (("Maxwell", ("constitutiveModel", "linearElastic")),
                        ("viscousFriction", ("contactLaw", "Coulomb")),
                        ("wallSpring", ("stepPart",)),
                        ("shaking", ("bodyForce", "uniform"))):
        unknown(table, case, user, words)


if __name__ == "__main__":
    sys.exit(runParts("userLibrary", compiles, law, equation, gas, drag, friction, spring, force,
                      failure, erosion, heat, pressure, column, nodes, criterion, choices))
