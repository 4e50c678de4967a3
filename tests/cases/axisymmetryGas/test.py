#!/usr/bin/env python3
"""A gas on wedge patches, alone and with material points in it.

alone        at rest; Sod's tube along the axis as in 2D; a cylindrical explosion
             against 1000 rings of a scheme in Python
together     bodies that move with the gas or rest in it: pressure, fractions; a shock on
             a cylinder: momentum, mass, energy, 2 processors
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from blockInGas import EXTREMES, P0, R, figures, gasFields, gasSchemes
from foamCase import FoamCase, RunFailed, controlDict, velocityFile
from gasCases import (OPEN, VAN_LEER, WALL, boxCentres, gasCase, schemes, volField,
                      writeVolField)
from report import Report
from wedge import wedgeConditions, wedgeMesh


# --- alone ---------------------------------------------------------------------------

def gasWedge(name, cells, high, state, endTime, ends=OPEN, outer=WALL, reconstruct=VAN_LEER):
    """A gas in a solid wedge about x; state(x, r) gives rho, p."""
    case = FoamCase("axisymmetryGas", name)
    case.write("system/blockMeshDict", wedgeMesh((0, 0), high, cells, {
        "left": ("patch", "x-"), "right": ("patch", "x+"), "outer": ("patch", "r+")}))
    x, r, _ = boxCentres((0, 0, 0), (*high, 1), (*cells, 1))
    rho, p = state(x, r)
    given = wedgeConditions({"left": ends, "right": ends, "outer": outer})
    for i, (field, values) in enumerate((("p", p), ("T.air", p/rho),
                                         ("U.air", np.zeros((len(x), 3))))):
        writeVolField(case, field, values, {
            n: c if isinstance(c, str) else c[i] for n, c in given.items()})
    case.write("system/fvSchemes", schemes(reconstruct))
    case.write("system/fvSolution", {})
    case.write("constant/phaseProperties", {"phases": ["air"], "air": {
        "type": "gas", "thermo": "perfectGas", "R": 1, "gamma": 1.4}})
    control = controlDict(endTime, endTime, maxCo=0.4)
    control["maxCoGas"] = control.pop("maxCo")
    case.write("system/controlDict", control)
    case.run("blockMesh")
    case.run("materialPointFoam")
    return case, x, r


def radialReference(R, end, n=1000):
    """Density of a cylindrical explosion: n rings, HLL with limited slopes (minmod,
    two stages), in Python."""
    h = R/n
    r, f = (np.arange(n) + 0.5)*h, np.arange(n + 1)*h
    U = np.stack([np.where(r < 0.4, 1, 0.125), 0*r, np.where(r < 0.4, 1, 0.1)/0.4])

    def rate(U):
        rho, u = U[0], U[1]/U[0]
        W = np.stack([rho, u, 0.4*(U[2] - 0.5*rho*u*u)])
        d = np.diff(W, axis=1, prepend=W[:, :1], append=W[:, -1:])
        d[1, 0], d[1, -1] = 2*W[1, 0], -2*W[1, -1]
        a, b = d[:, :-1], d[:, 1:]
        s = np.where(a*b > 0, np.sign(a)*np.minimum(np.abs(a), np.abs(b)), 0)
        L, Q = (W + 0.5*s)[:, :-1], (W - 0.5*s)[:, 1:]

        def flux(w):
            e = w[2]/0.4 + 0.5*w[0]*w[1]**2
            return (np.stack([w[0]*w[1], w[0]*w[1]**2 + w[2], (e + w[2])*w[1]]),
                    np.stack([w[0], w[0]*w[1], e]), np.sqrt(1.4*w[2]/w[0]))

        (FL, UL, cL), (FR, UR, cR) = flux(L), flux(Q)
        lo = np.minimum(np.minimum(L[1] - cL, Q[1] - cR), 0)
        hi = np.maximum(np.maximum(L[1] + cL, Q[1] + cR), 0)
        F = np.zeros((3, n + 1))
        F[:, 1:-1] = (hi*FL - lo*FR + lo*hi*(UR - UL))/(hi - lo)
        F[1, -1] = W[2, -1]
        out = -np.diff(f*F, axis=1)/(h*r)
        out[1] += W[2]/r
        return out, np.max(np.abs(u) + np.sqrt(1.4*W[2]/rho))

    t = 0.0
    while t < end:
        k, speed = rate(U)
        dt = min(0.4*h/speed, end - t)
        V = U + dt*k
        U = 0.5*(U + V + dt*rate(V)[0])
        t += dt
    return r, U[0]


def alone(table):
    case, x, r = gasWedge("gas-rest", (10, 8), (1, 0.5),
                          lambda x, r: (1 + 0.5*np.sin(9*x + 7*r), np.ones_like(x)), 1.0,
                          ends=WALL)
    end = case.times()[-1]
    table.row("gas at rest: pressure - 1", 0,
              np.abs(volField(case, end, "p") - 1).max(), 1e-12)
    table.row("gas at rest: velocity", 0, np.abs(volField(case, end, "U.air")).max(), 1e-12)

    n = 100
    case, x, r = gasWedge("gas-axial", (n, 4), (1, 0.04), lambda x, r: (
        np.where(x < 0.5, 1, 0.125), np.where(x < 0.5, 1, 0.1)), 0.2)
    rho = volField(case, case.timeName(0.2), "rho.air")
    u = volField(case, case.timeName(0.2), "U.air")
    box = gasCase("axisymmetryGas", "gas-box", (n, 4, 1), (1, 0.04, 0.01), lambda x, y, z: (
        np.where(x < 0.5, 1, 0.125), 0*x, np.where(x < 0.5, 1, 0.1)), 0.2)
    box.run("materialPointFoam")
    plane = volField(box, box.timeName(0.2), "rho.air")
    table.row("Sod's tube along the axis: density against the same in 2D", 0,
              np.abs(rho - plane).max(), 1e-10)
    table.row("Sod's tube along the axis: radial velocity", 0, np.abs(u[:, 1]).max(), 1e-10)

    n = 100
    fine, exact = radialReference(1.0, 0.25)
    # The mean over each cell
    mean = (fine*exact).reshape(n, -1).sum(1)/fine.reshape(n, -1).sum(1)
    for label, reconstruct in (("vanLeer", VAN_LEER), ("MLP", dict.fromkeys(VAN_LEER, "MLP"))):
        case, x, r = gasWedge(f"gas-radial-{label}", (1, n), (0.01, 1), lambda x, r: (
            np.where(r < 0.4, 1, 0.125), np.where(r < 0.4, 1, 0.1)), 0.25, ends=WALL,
            reconstruct=reconstruct)
        rho = volField(case, case.timeName(0.25), "rho.air")
        # Sod's tube has 6e-3 at 100 cells
        table.row(f"cylindrical explosion, {label}: L1 of the density, 100 rings against 1000",
                  0, np.abs(rho - mean).mean(), 6e-3, "atMost")


# --- together ----------------------------------------------------------------------

def inGas(name, region, velocity=0.0, steps=400, walls=False, gasVelocity=None,
          pressure=None, Co=0.4, numerics=None, reports=20, E=70e9, graded=False):
    """A body in the gas of blockInGas, 30 x 15 cells of 1 mm about x; graded: 0.8 to 1.2 mm along
    the axis, narrower by a half outwards."""
    n, m, h = 30, 15, 1e-3
    ends = (("patch", "x-"), ("patch", "x+")) if walls else (
        ("cyclic; neighbourPatch right", "x-"), ("cyclic; neighbourPatch left", "x+"))
    case = FoamCase("axisymmetryGas", name)
    case.write("system/blockMeshDict", wedgeMesh((0, 0), (n*h, m*h), (n, m), {
        "left": ends[0], "right": ends[1], "outer": ("patch", "r+")}))
    if graded:
        case.change("system/blockMeshDict", r"simpleGrading \(1 1 1\)",
                    "simpleGrading (((0.5 0.5 1.5) (0.5 0.5 0.6666666666666667)) 0.5 1)")
    end = "slip" if walls else "cyclic"
    conditions = wedgeConditions({"left": end, "right": end, "outer": "slip"})
    case.write("constant/phaseProperties", {
        "phases": ["air", "block"],
        "air": {"type": "gas", "thermo": "perfectGas", "R": R, "gamma": 1.4},
        "block": {"constitutiveModel": {"type": "linearElastic", "rho": 2700, "E": E,
                                        "nu": 0.3}}})
    velocityFile(case, "block", conditions)
    v = (velocity, 0, 0)
    gasFields(case, conditions, v if gasVelocity is None else gasVelocity,
              None if pressure is None else pressure(n, m))
    gasSchemes(case)
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", **region, "pointsPerCell": 2, "velocity": v,
        "stress": "ambient", "pressure": P0}}})
    case.write("system/fvSolution", {"materialPoints": numerics or {
        "shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}})
    dt = Co*h/(np.sqrt(1.35*E/2700) + abs(velocity))
    case.write("system/controlDict", {
        **controlDict(steps*dt, steps*dt, deltaT=dt, functions=EXTREMES),
        "reportInterval": max(1, steps//reports)})
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def cylinderRegion(x0, x1, r0, r1):
    return {"type": "box", "min": (1e-3*x0, 1e-3*r0, -1), "max": (1e-3*x1, 1e-3*r1, 1)}


def together(table):
    for label, region in (("cylinder", cylinderRegion(5.2, 15.2, -1, 7.3)),
                          ("ring", cylinderRegion(5.2, 15.2, 4.3, 9.3)),
                          ("full width", cylinderRegion(5.2, 15.2, -1, 20)),
                          ("ball", {"type": "sphere", "centre": (0.01, 0, 0),
                                    "radius": 6.2e-3})):
        name = label.replace(" ", "-")
        case = inGas("gas-moving-" + name, region, velocity=500.0, steps=1500)
        case.run("materialPointFoam", limit=300)
        f = figures(case)
        table.row(f"gas, {label} moves with it: max dP/P", 0,
                  np.max(abs(f["p"]/P0 - 1)), 1e-10)
        # At the axis two points per cell sample kernels that are symmetric in r^2
        table.row(f"gas, {label} moves: max |Theta - 1|", 0, np.max(abs(f["Theta"] - 1)),
                  1e-3 if label == "ring" else 0.02)
        table.row(f"gas, {label} moves: fix-ups", 0, np.sum(f["fixups"][-1]), 0, "atMost")
    # From cells of one size to others; dP/P is exact there too
    for name, r0, r1 in (("cylinder", -1, 7.3), ("ring", 4.3, 9.3)):
        case = inGas("gas-graded-" + name, cylinderRegion(5.2, 15.2, r0, r1), velocity=500.0,
                     steps=1500, Co=0.25, graded=True)
        case.run("materialPointFoam", limit=300)
        f = figures(case)
        table.row(f"gas, {name} moves with it through graded cells: max dP/P", 0,
                  np.max(abs(f["p"]/P0 - 1)), 1e-10)
        table.row(f"gas, {name} moves through graded cells: max |Theta - 1|", 0,
                  np.max(abs(f["Theta"] - 1)), 0.06)
    case = inGas("gas-resting", cylinderRegion(0, 15.2, -1, 7.3), walls=True, steps=1000)
    case.run("materialPointFoam", limit=300)
    f = figures(case)
    table.row("gas, cylinder at rest: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-13)
    table.row("gas, cylinder at rest: velocity of points", 0,
              np.max(abs(case.points(case.times()[-1], "block")["U"])), 1e-11)

    def shocked(name, Co, steps):
        def pressure(n, m):
            p = np.full((m, n), P0)
            p[:, :6] = 4*P0
            return p.ravel()
        return inGas(name, cylinderRegion(10.2, 18.3, -1, 7.3), velocity=-30.0, steps=steps,
                     walls=False, gasVelocity=(0, 0, 0), pressure=pressure, Co=Co,
                     reports=steps, E=7e9)

    residual = []
    for Co, steps in ((0.4, 300), (0.2, 600)):
        case = shocked(f"gas-shock-{Co}", Co, steps)
        case.run("materialPointFoam", limit=300)
        f = figures(case)
        total = (f["momentum"] + f["gasMomentum"])[:, 0]
        energy = f["energy"] + f["gasEnergy"]
        residual.append((energy[-1] - energy[0])
                        / np.max(abs(f["gasEnergy"] - f["gasEnergy"][0])))
        if Co == 0.4:
            one = case
            table.row("shock on a moving cylinder: axial momentum of all / the cylinder's",
                      0, np.max(abs(total - total[0]))/np.max(abs(f["momentum"][0])), 1e-12)
            table.row("shock: mass of the gas", f["gasMass"][0], f["gasMass"][-1], 1e-12,
                      "relative")
            table.row("shock: max |Theta - 1|", 0, np.max(abs(f["Theta"] - 1)), 0.02)
    table.row("shock: energy residual over exchanged, CFL 0.4", 0, residual[0], 0.01)
    table.check("shock: it falls with the time step",
                abs(residual[1]) < 0.75*abs(residual[0]),
                f"{residual[0]:.2e}, {residual[1]:.2e}")
    for cut in ((2, 1, 1), (1, 2, 1)):
        two = shocked(f"gas-shock-{cut[0]}{cut[1]}", 0.4, 300)
        two.decompose(cut)
        two.runParallel()
        table.row(f"shock, 2 processors ({cut[0]} x {cut[1]}) against 1: points", 0,
                  one.largestDifference(two, one.times()[-1], ["block"],
                                        ("x", "U", "sigma", "V")), 1e-10)


def main():
    table = Report("axisymmetryGas")
    tests = {f.__name__: f for f in (alone, together)}
    for name in sys.argv[1:] or tests:
        try:
            tests[name](table)
        except RunFailed as e:
            table.check(f"{name} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
