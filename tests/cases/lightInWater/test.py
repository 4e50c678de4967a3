#!/usr/bin/env python3
"""Light soft solids in water and air: the step that the time control takes keeps them stable.

Two blocks of rubber meet, one thrown with 5 m/s, the other half in water (the scene of
randomScenes/solids.py), with maxCoGas 0.6. The spring of the pores that the water fills bounds
the step (gasCoupling.H); without that bound each of these scenes stops, or the energy of its
points grows 25-fold or more.

growth    largest kinetic and strain energy of the points over that of the start
named     the log names what has set the step
fixed     a fixed deltaT of 1.5 times that bound is warned of, once
added     added mass of a stiff disc and a stiff plate amid walls, lowMach
"""

import os
import re
import sys

import numpy as np

LIB = os.path.join(os.path.dirname(__file__), "../../lib")
sys.path[:0] = [LIB, os.path.join(os.path.dirname(__file__), "../randomScenes")]
import solids
from fluidCases import WATER, besidePoints, fluidCase
from foamCase import VERIFY, RunFailed, runParts
from gasCases import VAN_LEER

#: Sort of mesh, shape functions, transfer, density [kg/m3]
SCENES = [("plane", "GIMP", t, 100) for t in ("FMPM", "XPIC", "FLIP", "APIC")]
SCENES += [("plane", "GIMP", "FMPM", 500), ("plane", "GIMP", "XPIC", 1000),
           ("plane", "linear", "FMPM", 500), ("wedge", "GIMP", "XPIC", 500),
           ("plane", "nodeDual", "XPIC", 100)]
if VERIFY:
    SCENES = [(sort, functions, t, rho) for sort, functions in (
        ("plane", "GIMP"), ("plane", "linear"), ("plane", "quadraticBSpline"), ("wedge", "GIMP"),
        ("box", "GIMP"), ("tets", "nodeDual")) for t in ("FMPM", "XPIC", "FLIP", "APIC")
              for rho in (100, 500, 1000)]


def draw(sort, functions, transfer, rho, E=1e6, nu=0.3):
    c = (E*(1 - nu)/(1 + nu)/(1 - 2*nu)/rho)**0.5
    body = {"law": "linearElastic", "failure": None, "c": c,
            "entries": {"type": "linearElastic", "rho": rho, "E": E, "nu": nu}}
    return {"around": "water", "sort": sort, "v": 5, "shape": "box", "gap": 2, "PIC": 0,
            "bodies": [{**body, "U": (5, 0, 0)}, {**body, "U": (0, 0, 0)}],
            "transfer": transfer, "update": "MUSL", "functions": functions,
            "contact": {"type": "Coulomb", "mu": 0.3}, "nuclei": 1e-4, "ranks": 1}


def light(table):
    named = 0
    for scene in SCENES:
        sort, functions, transfer, rho = scene
        name = f"{sort} {functions} {transfer} {rho} kg/m3"
        case = solids.write(draw(*scene), 60, name.replace(" ", "-").replace("/", ""),
                            "lightInWater")
        try:
            case.run("materialPointFoam", limit=120)
        except RunFailed as e:
            table.check(f"{name}: does not stop", False, " ".join(str(e).split())[-200:])
            continue
        sums = case.series("energy", "energy.dat")[:, 1:3].sum(axis=1)
        table.row(f"{name}: largest energy of the points over that of the start", 1,
                  np.max(sums)/sums[0], 1.2, "atMost")
        named += "deltaT set by what flows in the pores" in case.log("materialPointFoam")
    table.row("scenes in which the pores have set the step", len(SCENES), named,
              len(SCENES), "atLeast")


def fixed(table):
    case = solids.write(draw(*SCENES[0]), 20, "fixed", "lightInWater")
    control = open(case.file("system/controlDict")).read()

    def run(**entries):
        text = control
        for name, value in entries.items():
            text = re.sub(rf"(?m)^{name} .*;", f"{name} {value};", text)
        with open(case.file("system/controlDict"), "w") as f:
            f.write(text)
        case.run("materialPointFoam", limit=120)
        return case.log("materialPointFoam")
    bound = float(re.search(r"deltaT = (\S+)\ndeltaT set by what flows", run())[1])
    for factor, warnings in ((0.99, 0), (1.5, 1)):
        log = run(deltaT=factor*bound, endTime=10*factor*bound, adjustTimeStep="no", maxCo=1)
        table.row(f"fixed deltaT of {factor} of the bound: warnings of it", warnings,
                  log.count("up to which light points bear"), 0)


def exactAdded(a, L, N=24):
    """Added mass of a cylinder amid a square of side L, over the mass that it displaces.

    phi = sum_n (A_n (r/a)^-n + B_n (r/L)^n) cos n t, n odd, with the velocity of the cylinder at
    r = a and none through the walls, in the least squares.
    """
    n = np.arange(1, 2*N, 2)
    t = np.linspace(0, np.pi/2, 400)[:, None]
    rows = [np.hstack([-n*np.cos(n*t), n*(a/L)**n*np.cos(n*t)])]
    s = np.linspace(0, L/2, 400)[:, None]
    for x, y, turn in ((L/2 + 0*s, s, 0), (s, L/2 + 0*s, np.pi/2)):
        r, angle = np.hypot(x, y), np.arctan2(y, x)
        rows.append(np.hstack([-n*(r/a)**-n*np.cos((n + 1)*angle - turn),
                               n*(r/L)**n*np.cos((n - 1)*angle + turn)])*a/r)
    c = np.linalg.lstsq(np.vstack(rows), np.concatenate([np.cos(t[:, 0]), np.zeros(800)]),
                        rcond=None)[0]
    return -(c[0] + c[N]*a/L)


def exactPlate(L, t, l, n):
    """Added mass of a plate t x l amid a square of side L that moves across itself [m2], for a
    density of 1: the potential's Laplace equation on cells, by conjugate gradients. Its corners
    make an error of first order: n x n and 2n x 2n cells, extrapolated."""
    return 2*onCells(L, t, l, 2*n) - onCells(L, t, l, n)


def onCells(L, t, l, n):
    h = L/n
    x = abs((np.arange(n) + 0.5)*h - L/2)
    solid = (x[:, None] < t/2) & (x[None, :] < l/2)
    open_ = ~solid

    def minusLaplacian(p):
        r = np.zeros_like(p)
        f = (p[1:] - p[:-1])*(open_[1:] & open_[:-1])
        r[:-1] -= f
        r[1:] += f
        f = (p[:, 1:] - p[:, :-1])*(open_[:, 1:] & open_[:, :-1])
        r[:, :-1] -= f
        r[:, 1:] += f
        return r

    left, right = open_[:-1] & solid[1:], solid[:-1] & open_[1:]
    r, p = np.zeros((n, n)), np.zeros((n, n))
    r[:-1][left] += h
    r[1:][right] -= h
    d, rr = r.copy(), np.sum(r*r)
    end = 1e-20*rr
    while rr > end:
        q = minusLaplacian(d)
        a = rr/np.sum(d*q)
        p, r = p + a*d, r - a*q
        new = np.sum(r*r)
        d, rr = r + new/rr*d, new
    return h*abs(np.sum((p[:-1] + h/2)[left]) - np.sum((p[1:] - h/2)[right]))


def pushed(name, n, L, word, shape, rho, E, end, push, Co=0.4, drag="normal"):
    """A body pushed in water amid walls: mean of u/t over the push, from a fifth of it on."""
    case = fluidCase("lightInWater", f"{name}-{n}-{word}-{Co:g}-{drag}", (n, n, 1), (L, L, 0.01),
                     {"water": WATER}, lambda x, y, z: ([1 + 0*x], [1000.0], 0.0, 1e5),
                     end, ends=("zeroGradient", "zeroGradient", "slip"),
                     reconstruct=VAN_LEER,
                     control={"maxCo": 0.4, "maxCoGas": Co, "deltaT": 1e-9, "reportInterval": 20})
    besidePoints(case, {"water": WATER}, {"body": {
        "constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E, "nu": 0.3},
        "drag": {"type": "stick", "direction": drag},
        "bodyForce": {"type": "uniform", "acceleration": f"({push:g} 0 0)"}}},
        {"body": {**shape, "stress": "ambient", "pressure": 1e5}}, settings={"lowMach": word})
    case.run("materialPointFoam", limit=300)
    found = re.findall(r"^Time = (\S+)\n[^\0]*?mass (\S+), momentum \((\S+)",
                       case.log("materialPointFoam"), re.M)
    t, m, p = np.array(found, dtype=float).T
    late = t > 0.2*end
    return np.sum((p/m)[late]*t[late])/np.sum(t[late]**2)/push


def addedMass(table):
    """Stiff bodies amid walls, pushed for 2 ms; direction normal, lowMach."""
    a, L, end, push = 0.01, 0.08, 2e-3, 10.0
    table.row("added mass of a cylinder in a wide square", 1, exactAdded(a, 100*a), 1e-3)
    disc = {"type": "cylinder", "point1": (L/2, L/2, -1), "point2": (L/2, L/2, 1), "radius": a}
    runs = [(32, "yes", 0.4), (32, "solids", 0.4), (32, "solids", 0.1)]
    for n, word, Co in runs + ([(64, "solids", 0.1)] if VERIFY else []):
        ratio = pushed("added", n, L, word, disc, 500.0, 1e9, end, push, Co) \
            * (1 + exactAdded(a, L)/0.5)
        label = f"pushed disc, h = a/{n*a/L:g}, lowMach {word}, maxCoGas {Co:g}: acceleration" \
            " over the exact one"
        if word == "yes":
            table.row(label + ", for comparison", 0.6, ratio, 0.2)
        elif Co < 0.4:
            table.row(label, 1, ratio, 0.06 if n == 32 else 0.03)
        else:
            table.row(label + ", for comparison", 1, ratio, 0.12)
    ratio = pushed("added", 32, L, "solids", disc, 500.0, 1e9, end, push, drag="all") \
        * (1 + exactAdded(a, L)/0.5)
    table.row("pushed disc that sticks, h = a/4, lowMach solids, maxCoGas 0.4: acceleration over"
              " the exact one, for comparison", 0.6, ratio, 0.2)

    # 1.14 pi l^2/4 of a rectangle 10 times as long as thick: DNV-RP-C205, table D-1
    table.row("added mass of a plate in a wide square over pi l^2/4", 1.14,
              exactPlate(8, 0.1, 1, 160)/(np.pi/4), 0.01)
    L, t, l, rho = 0.096, 0.004, 0.04, 2700.0
    added = 1000*exactPlate(L, t, l, 192)/(rho*t*l)
    plate = {"type": "box", "min": ((L - t)/2, (L - l)/2, -1), "max": ((L + t)/2, (L + l)/2, 1)}
    for word in ("no", "yes", "solids"):
        ratio = pushed("plate", 48, L, word, plate, rho, 70e9, end, push)*(1 + added)
        label = f"pushed plate, 2 cells thick, lowMach {word}: acceleration over the exact one"
        if word == "solids":
            table.row(label, 1, ratio, 0.03)
        else:
            table.row(label + ", for comparison", 0.75, ratio, 0.2)


if __name__ == "__main__":
    sys.exit(runParts("lightInWater", light, fixed, addedMass))
