#!/usr/bin/env python3
"""Material points and a gas in the same cells.

Translation: points and gas move together with 100 m/s through cyclic sides; the
pressure must stay uniform whatever the points do (dP/P 1e-12 in 1D, 1e-10 in 2D and
3D) and the fractions must add up to 1 (1e-3). Boxes begin and end where the user put
them, anyhow on the cells (1e-10 cells), with fractions that add up to 1. Rest against
walls: velocities 1e-11 m/s, dP/P 1e-13. A shock hits a moving block in a periodic
box: momentum of gas and points 1e-12 of the block's and of the impulse, mass of the
gas 1e-12, residual of the energy at most 1 % of what is exchanged and falling with
the time step. One processor against two and four, restart bit by bit.

Light gas: blocks of steel, aluminium and rigid ones in gas of 1, 133 and 1e5 Pa, 300
and 3000 K (densities of the solid up to 7e9 times that of the gas), 1e4 steps of maxCo
and maxCoGas 0.4 (MPM_VERIFY=1; else 1e3 of a few of them). At rest: speed 1e-6 m/s. Gas
of 1 m/s, left and right from cell to cell, around a block at rest: a tenth is left.
Moving with the gas with 100 m/s through cyclic sides: dP/P 1e-10. A slab that moves with
100 m/s into still gas: pressure of the shock that it drives within 3 % of the exact, the
gas ahead of that as it was (1e-6). A plate meets another with 200 m/s: no fix-up.
"""

import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from blockInGas import EXTREMES, P0, blockInGas, figures
from coupledCases import ambient, coupledCase, gasLog
from foamCase import RunFailed, VERIFY
from gasCases import OPEN, volField
from report import Report

STICK, NONE = None, {"type": "none"}
H = 1e-4


def box(low, high):
    return {"type": "box", "min": [H*x for x in low], "max": [H*x for x in high]}


def rotatedBox(case):
    """constant/triSurface/rotated.stl: a box of 15 cells, turned by 30 degrees."""
    c, s = 15*H*np.cos(np.pi/6), 15*H*np.sin(np.pi/6)
    corners = np.array([[14*H + i*c - j*s, 6*H + i*s + j*c, k*4*H - 1.5*H]
                        for k in (0, 1) for j in (0, 1) for i in (0, 1)])
    path = case.file("constant", "triSurface")
    os.makedirs(path, exist_ok=True)
    with open(os.path.join(path, "rotated.stl"), "w") as f:
        f.write("solid box\n")
        for quad in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3),
                     (0, 4, 6, 2), (1, 3, 7, 5)):
            for t in ((0, 1, 2), (0, 2, 3)):
                f.write("facet normal 0 0 0\nouter loop\n" + "".join(
                    "vertex {} {} {}\n".format(*map(float, corners[quad[i]])) for i in t)
                    + "endloop\nendfacet\n")
        f.write("endsolid box\n")


def graded(case):
    """Cells that grow and shrink by a half along each direction."""
    half = "((0.5 0.5 1.5) (0.5 0.5 0.6666666666666667))"
    nDim = 3 - case.get("system/blockMeshDict")["blocks"][2].count(1)
    case.change("system/blockMeshDict", r"simpleGrading \(1 1 1\)",
                "simpleGrading (" + " ".join([half]*nDim + ["1"]*(3 - nDim)) + ")")


# Dimension, cells, region, velocity [m/s], crossings of a cell, points per cell, further
MOVING = {
    "1D, 2 points": (1, 60, box((20.3, 0, 0), (40.3, 1, 1)), (100, 0, 0), 50, 2, {}),
    "1D, 4 points": (1, 60, box((20.3, 0, 0), (40.3, 1, 1)), (100, 0, 0), 50, 4, {}),
    "1D, no drag": (1, 60, box((20.3, 0, 0), (40.3, 1, 1)), (100, 0, 0), 50, 4,
                    {"drag": NONE}),
    "1D, 7.78 cells": (1, 60, box((20.37, 0, 0), (28.15, 1, 1)), (100, 0, 0), 50, 2, {}),
    "1D, porous 0.6": (1, 60, {**box((20.3, 0, 0), (40.3, 1, 1)), "volumeFraction": 0.6},
                       (100, 0, 0), 50, 4, {}),
    "2D, block": (2, 30, box((5.2, 7.2, -1), (20.3, 20.3, 2)), (80, 60, 0), 20, 2, {}),
    "2D, block, B-spline": (2, 30, box((5.2, 7.2, -1), (20.3, 20.3, 2)), (80, 60, 0), 20, 2,
                            {"numerics": {"shapeFunction": "quadraticBSpline",
                                          "transfer": "FLIP", "PICfraction": 0.01}}),
    "2D, block at 30 degrees": (2, 36, {"type": "surface", "surface": {
        "type": "triSurfaceMesh", "file": '"rotated.stl"'}}, (80, 60, 0), 20, 2, {}),
    "2D, disc, 3 points": (2, 30, {"type": "cylinder", "point1": [15.2*H, 14.9*H, -H],
                                   "point2": [15.2*H, 14.9*H, 2*H], "radius": 10*H},
                           (80, 60, 0), 20, 3, {}),
    "1D, graded": (1, 60, box((20.3, 0, 0), (40.3, 1, 1)), (100, 0, 0), 50, 4,
                   {"prepare": graded, "Co": 0.3}),
    "2D, block, graded": (2, 30, box((5.2, 7.2, -1), (20.3, 20.3, 2)), (80, 60, 0), 20, 2,
                          {"prepare": graded, "Co": 0.3}),
    "3D, block, graded": (3, 12, box((3.2, 2.2, 4.1), (8.3, 7.3, 9.2)), (80, 60, -30),
                          20 if VERIFY else 4, 2, {"prepare": graded, "Co": 0.3}),
    "3D, block": (3, 12, box((3.2, 2.2, 4.1), (8.3, 7.3, 9.2)), (80, 60, -30),
                  20 if VERIFY else 4, 2, {}),
}


def moving(table, label):
    nDim, n, region, v, crossings, points, more = MOVING[label]
    speed = np.linalg.norm(v)
    Co = more.get("Co", 0.4)
    steps = int(crossings/(Co*max(np.abs(v))/(np.sqrt(70e9/2700) + max(np.abs(v))))
                * max(np.abs(v))/speed)
    case = blockInGas("gasCoupling", label.replace(" ", "").replace(",", "-"), nDim, n,
                      region, v, steps, pointsPerCell=points,
                      **{"prepare": rotatedBox, **more})
    case.run("materialPointFoam", limit=300)
    f = figures(case)
    limit = 1e-12 if nDim == 1 else 1e-10
    uneven = "graded" in label
    way = f"way through {label}" if uneven else f"translation {label}"
    table.row(f"{way}, {crossings} cells: max dP/P", 0,
              np.max(abs(f["p"]/P0 - 1)), limit, "atMost")
    # Points go from cells of one width to others: what they fill is uneven there
    table.row(f"{way}: max |Theta - 1|", 0, np.max(abs(f["Theta"] - 1)),
              0.06 if uneven else 1e-3, "atMost")
    if not uneven:
        table.row(f"{way}: fix-ups", 0, np.sum(f["fixups"][-1]), 0, "atMost")


# Dimension, cells, low and high corner [cells], points per cell
STARTING = (
    (1, 60, (20.37, 0, 0), (40.37, 1, 1), 2),
    (1, 60, (20.37, 0, 0), (28.15, 1, 1), 2),
    (1, 60, (20.37, 0, 0), (24.15, 1, 1), 4),
    (2, 30, (5.37, 7.13, -1), (20.15, 13.79, 2), 2),
    (3, 12, (3.37, 2.13, 4.79), (8.37, 7.23, 9.29), 2))


def starting(table):
    """Boxes at any place, at rest."""
    for i, (nDim, n, low, high, points) in enumerate(STARTING):
        case = blockInGas("gasCoupling", f"start-{i}", nDim, n, box(low, high),
                          steps=1, pointsPerCell=points, reports=1)
        p = case.points("0", "block")
        x, l = p["x"][:, :nDim]/H, p["halfSize"][:, :nDim]/H
        label = f"box of {points} points per cell from {low[:nDim]} to {high[:nDim]} h"
        table.row(f"{label}: where its points begin and end [cells]", 0, max(
            np.abs((x - l).min(0) - low[:nDim]).max(),
            np.abs((x + l).max(0) - high[:nDim]).max()), 1e-10)
        volume = np.prod(np.subtract(high, low)[:nDim])*H**3
        table.row(f"{label}: mass over the exact", 1, p["m"].sum()/(2700*volume), 1e-10)
        case.run("materialPointFoam")
        table.row(f"{label}: max |Theta - 1|", 0, np.abs(
            volField(case, case.times()[-1], "Theta") - 1).max(), 1e-12)


def resting(table, label, nDim, n, region, steps):
    case = blockInGas("gasCoupling", "rest-" + label, nDim, n, region, steps=steps,
                      pointsPerCell=2, walls=True)
    case.run("materialPointFoam", limit=300)
    f = figures(case)
    u = np.max(abs(case.points(case.times()[-1], "block")["U"]))
    table.row(f"rest {label}, {steps} steps: velocity of points", 0, u, 1e-11, "atMost")
    table.row(f"rest {label}: velocity of the gas", 0, np.max(f["speed"]), 1e-11, "atMost")
    table.row(f"rest {label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-13, "atMost")


def shocked(name, drag, Co, steps, **more):
    pressure = np.full((40, 40), P0)
    pressure[:, :8] = 4*P0
    case = blockInGas(
        "gasCoupling", name, 2, 40, {"type": "box", "min": (12.2e-3, 6.2e-3, -1),
                                     "max": (22.3e-3, 16.3e-3, 1)},
        (50, -30, 0), steps, h=1e-3, E=7e9, Co=Co, drag=drag, gasVelocity=(0, 0, 0),
        pressure=pressure.ravel(), reports=steps, **more)
    return case


def shock(table):
    for label, drag in (("sticking", STICK), ("no drag", NONE)):
        residual = []
        for Co, steps in ((0.4, 600), (0.2, 1200)):
            case = shocked(f"shock-{label.replace(' ', '')}-{Co}", drag, Co, steps)
            case.run("materialPointFoam", limit=300)
            f = figures(case)
            total = f["momentum"] + f["gasMomentum"]
            drift = np.max(abs(total - total[0]))
            energy = f["energy"] + f["gasEnergy"]
            residual.append((energy[-1] - energy[0])
                            / np.max(abs(f["gasEnergy"] - f["gasEnergy"][0])))
        table.row(f"shock on a moving block, {label}: momentum of all, over the block's", 0,
                  drift/np.max(abs(f["momentum"][0])), 1e-12, "atMost")
        table.row(f"shock, {label}: mass of the gas", f["gasMass"][0],
                  f["gasMass"][-1], 1e-12, "relative")
        table.row(f"shock, {label}: energy residual over exchanged, CFL 0.4", 0,
                  residual[0], 0.01)
        table.check(f"shock, {label}: it falls with the time step",
                    abs(residual[1]) < 0.75*abs(residual[0]),
                    f"{residual[0]:.2e}, {residual[1]:.2e}")


def processors(table):
    one = shocked("one", STICK, 0.4, 80)
    one.run("materialPointFoam")
    end = one.times()[-1]
    for n in ((2, 1, 1), (2, 2, 1)):
        several = shocked(f"processors-{n[0]*n[1]}", STICK, 0.4, 80)
        several.decompose(n)
        several.runParallel()
        table.row(f"{n[0]*n[1]} processors against one: points", 0,
                  one.largestDifference(several, end, ["block"], ("x", "U", "sigma", "V")),
                  1e-10, "atMost")
        a, b = figures(one)["p"], figures(several)["p"]
        table.row(f"{n[0]*n[1]} processors against one: pressure", 0,
                  np.max(abs(a - b))/np.max(a), 1e-10, "atMost")

    cases = [shocked(f"graded-{n}", STICK, 0.3, 80, prepare=graded) for n in (1, 2)]
    cases[0].run("materialPointFoam")
    cases[1].decompose((2, 1, 1))
    cases[1].runParallel()
    table.row("graded boxes, 2 processors against one: points", 0, cases[0].largestDifference(
        cases[1], cases[0].times()[-1], ["block"], ("x", "U", "sigma", "V")), 1e-10, "atMost")
    a, b = (figures(c)["p"] for c in cases)
    table.row("graded boxes, 2 processors against one: pressure", 0,
              np.max(abs(a - b))/np.max(a), 1e-10, "atMost")

    straight, again = (shocked(name, STICK, 0.4, 80) for name in ("straight", "again"))
    for case in (straight, again):
        case.change("system/controlDict", "^writeInterval.*?;",
                    f"writeInterval {float(end)/2!r};")
    straight.run("materialPointFoam")
    half = straight.times()[1]
    again.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
    shutil.copytree(straight.file(half), again.file(half))
    again.run("materialPointFoam")
    table.row("restart at half time: points", 0, straight.largestDifference(
        again, straight.times()[-1], ["block"], ("x", "U", "sigma", "V")), 0, "atMost")
    files = [open(c.file(straight.times()[-1], "thetaRhoE.air"), "rb").read()
             for c in (straight, again)]
    table.check("restart at half time: gas bit by bit", files[0] == files[1])


# --- gas much lighter than the solid ------------------------------------------

GAMMA, R = 1.4, 287.0
SOLIDS = {"steel": (7850, 210e9), "aluminium": (2700, 70e9), "rigid": (7800, None)}
THIN = [(solid, p, T) for solid in SOLIDS for p in (1, 133, 1e5) for T in (300, 3000)]
THIN_FEW = {"thinStill": [("steel", 133, 300, 1000), ("rigid", 1e5, 3000, 1000)],
            "thinCarried": [("rigid", 1, 300, 1000)],
            "thinPiston": [("rigid", 1, 300, 1000)],
            "thinImpact": [("steel", 1, 300)]}
SLIP = ("zeroGradient", "zeroGradient", "slip")


def inThinGas(kind, solid, p, T, cells, region, velocity, gasVelocity, steps, **options):
    """The case after its run, the time simulated, max |dP/P| and speeds of the gas."""
    rho, E = SOLIDS[solid]
    c = np.sqrt(GAMMA*R*T)
    speed = np.linalg.norm(velocity)
    dt = 0.4*H/(sum(n > 1 for n in cells)*c + sum(np.abs(velocity)))
    if E:
        nu = 0.3
        wave = np.sqrt(E*(1 - nu)/((1 + nu)*(1 - 2*nu)*rho))
        dt = min(dt, 0.4*H/(wave + speed))
        phase = {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E, "nu": nu}}
        start = {"stress": ambient(p), "velocity": velocity}
    else:
        motion = {"type": "translation", "velocity": velocity} if speed else {"type": "fixed"}
        phase, start = {"type": "rigid", "rho": rho, "motion": motion}, {}

    def initial(x, y, z):
        # coupledCase writes p/rho as the temperature
        return p/T + 0*x, gasVelocity(x, y, z), p + 0*x

    case = coupledCase(
        "gasCoupling", f"thin-{kind}-{solid}-{p:g}-{T:g}", cells, [H*n for n in cells],
        initial, steps*dt, {"block": phase}, {"block": {**region, **start}},
        gas={"R": R}, maxCo=0.4, control={"reportInterval": 100, "functions": EXTREMES},
        pointConditions="calculated", **options)
    case.run("materialPointFoam", limit=300)
    pressure = case.series("pressure", "fieldMinMax.dat")[:, 1:]
    return (case, steps*dt, np.max(abs(pressure/p - 1)),
            case.series("speed", "fieldMinMax.dat")[:, 2])


def thinStill(table, solid, p, T, steps=10000):
    for kind, limit in (("rest", 1e-6), ("stirred", 0.1)):
        def gasVelocity(x, y, z):
            away = (abs(x/H - 9.7) > 5.5) | (abs(y/H - 8.2) > 4.5)
            side = 1 - 2*((np.round(x/H - 0.5) + np.round(y/H - 0.5)) % 2)
            return np.column_stack([side*away*(kind == "stirred"), 0*x, 0*x])

        case, _, _, speed = inThinGas(
            kind, solid, p, T, (20, 16, 1), box((6.3, 5.4, -1), (13.1, 11.2, 2)),
            (0, 0, 0), gasVelocity, steps, ends=SLIP, sides=SLIP)
        u = np.max(np.abs(case.points(case.times()[-1], "block")["U"]))
        label = f"{solid} in gas of {p:g} Pa, {T} K, {kind}, {case.nSteps()} steps"
        table.row(f"{label}: speed of the gas", 0, np.max(speed) if kind == "rest"
                  else speed[-1], limit, "atMost")
        table.row(f"{label}: of the points", 0, u, limit, "atMost")


def thinCarried(table, solid, p, T, steps=10000):
    case, _, off, _ = inThinGas(
        "carried", solid, p, T, (20, 16, 1), box((6.3, 5.4, -1), (13.1, 11.2, 2)),
        (80, 60, 0), lambda x, y, z: np.tile((80.0, 60.0, 0.0), (len(x), 1)), steps,
        patches={"l": ("cyclic; neighbourPatch r", ("x-",)),
                        "r": ("cyclic; neighbourPatch l", ("x+",)),
                        "b": ("cyclic; neighbourPatch t", ("y-",)),
                        "t": ("cyclic; neighbourPatch b", ("y+",))})
    table.row(f"{solid} in gas of {p:g} Pa, {T} K, both with 100 m/s,"
              f" {case.nSteps()} steps: max dP/P", 0, off, 1e-10, "atMost")


def thinPiston(table, solid, p, T, steps=10000):
    u = 100.0
    c = np.sqrt(GAMMA*R*T)
    M = 0.25*(GAMMA + 1)*u/c
    M += np.sqrt(M**2 + 1)
    exact = p*(1 + 2*GAMMA/(GAMMA + 1)*(M**2 - 1))
    back, thick = 30, 10
    # Cells that a sound of the solid's time step passes
    wave = 0.4*steps/(c if solid == "rigid" else max(c, 5000))
    n = int(back + thick + 1.2*M*c*wave + 40)
    case, end, _, _ = inThinGas(
        "piston", solid, p, T, (n, 1, 1), box((back + 0.3, -1, -1),
                                              (back + thick + 0.3, 2, 2)),
        (u, 0, 0), lambda x, y, z: 0*x, steps, ends=OPEN)
    pressure = volField(case, case.timeName(end), "p")
    x = np.arange(n) + 0.5
    face = back + thick + 0.3 + u*end/H
    shock = back + thick + 0.3 + M*c*end/H
    behind = (x > face + 4) & (x < face + 0.8*(shock - face))
    label = f"slab of {solid} with 100 m/s into gas of {p:g} Pa, {T} K, {case.nSteps()} steps"
    table.row(f"{label}: pressure of its shock, over that of the gas", exact/p - 1,
              np.mean(pressure[behind])/p - 1, 3e-2, "relative")
    ahead = x > shock + 0.15*(shock - face) + 10
    table.row(f"{label}: max dP/P ahead", 0, np.max(abs(pressure[ahead]/p - 1)), 1e-6,
              "atMost")


def thinImpact(table, solid, p, T):
    rho, E = SOLIDS[solid]
    plate = {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E, "nu": 0.3}}
    case = coupledCase(
        "gasCoupling", f"thin-impact-{solid}-{p:g}-{T}", (100, 1, 1), (100*H, H, H),
        lambda x, y, z: (p/T + 0*x, 0*x, p + 0*x), 10e-6, {"a": plate, "b": plate},
        {"a": {**box((20.3, -1, -1), (40.3, 2, 2)), "velocity": (200, 0, 0),
               "stress": ambient(p)},
         "b": {**box((50.3, -1, -1), (70.3, 2, 2)), "stress": ambient(p)}},
        gas={"R": R}, ends=OPEN, control={"reportInterval": 100})
    case.run("materialPointFoam", limit=300)
    label = f"plates of {solid} meet with 200 m/s in gas of {p:g} Pa, {T} K"
    log = gasLog(case)
    table.row(f"{label}: fix-ups", 0,
              log["limited"][-1] + log["kept"][-1] + log["isentropic"][-1], 0)


def main():
    table = Report("gasCoupling")
    parts = [(lambda label=label: moving(table, label)) for label in MOVING]
    parts += [lambda: starting(table)]
    parts += [lambda: resting(table, "1D", 1, 60, box((20.3, 0, 0), (40.3, 1, 1)),
                              100000 if VERIFY else 10000),
              lambda: resting(table, "2D-wall", 2, 20, box((0, 0, -1), (10, 10.3, 2)),
                              10000 if VERIFY else 1000),
              lambda: shock(table), lambda: processors(table)]
    thin = [(lambda f=f, of=of: f(table, *of))
            for f in (thinStill, thinCarried, thinPiston, thinImpact)
            for of in (THIN if VERIFY else THIN_FEW[f.__name__])
            if f != thinImpact or of[0] != "rigid"]
    for part in parts + thin:
        try:
            part()
        except RunFailed as e:
            table.check("runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
