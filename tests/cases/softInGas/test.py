#!/usr/bin/env python3
"""Bodies softer than the pressure of the gas around them (referencePressure), 1e5 Pa.

rest      slab, disc and ball with E from 1e3 to 1e6 Pa, laws, transfers: velocity of
          points and gas to rounding, in 1D, 2D and 3D
waves     a pulse in a bar that lies in gas: speed of the law's uniaxial strain,
          sqrt((lambda + 2 mu)/rho), on three meshes
failure   a bar that is torn in gas fails at the strength above p_0
restart   bit by bit; two processors
"""

import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from coupledCases import TRANSFER, coupledCase
from foamCase import VERIFY, runParts
from gasCases import WALL

P0, RHO, NU = 1e5, 1000.0, 0.3
TRANSFERS = {"FLIP": TRANSFER, "FMPM": {**TRANSFER, "transfer": "FMPM", "order": 2},
             "XPIC": {**TRANSFER, "transfer": "XPIC", "order": 2},
             "APIC": {**TRANSFER, "transfer": "APIC"}}
for name in ("FMPM", "XPIC", "APIC"):
    TRANSFERS[name].pop("PICfraction")


def law(E, kind="neoHookean", nu=NU):
    if kind == "MooneyRivlin":
        mu = E/(2*(1 + nu))
        return {"type": kind, "rho": RHO, "c10": 0.4*mu, "c01": 0.1*mu, "K": E/(3*(1 - 2*nu))}
    return {"type": kind, "rho": RHO, "E": E, "nu": nu}


def soft(E, kind="neoHookean", **more):
    return {"constitutiveModel": law(E, kind), "referencePressure": P0, **more}


def lame(E):
    return E*NU/((1 + NU)*(1 - 2*NU)), E/(2*(1 + NU))


def body(nDim, centre, radius):
    """Slab, disc or ball."""
    if nDim == 1:
        return {"type": "box", "min": (centre - radius, -1, -1), "max": (centre + radius, 1, 1)}
    if nDim == 2:
        return {"type": "cylinder", "point1": (centre, centre, -1), "point2": (centre, centre, 1),
                "radius": radius}
    return {"type": "sphere", "centre": 3*(centre,), "radius": radius}


def inGas(name, nDim, n, phase, region, endTime, p=P0, rhoGas=1.2, h=1e-2, cells=None, **more):
    cells = cells or [n if d < nDim else 1 for d in range(3)]
    return coupledCase(
        "softInGas", name, cells, [h*c for c in cells],
        lambda x, y, z: (rhoGas + 0*x, 0*x, p + 0*x), endTime, {"body": phase},
        {"body": region}, **{"ends": WALL, "sides": WALL, **more})


def rest(table):
    laws = ("neoHookean", "MooneyRivlin", "linearElastic")
    scenes = [(d, E, laws[0], "FLIP") for d in (1, 2, 3) for E in (1e3, 1e6)]
    scenes += [(2, 1e3, kind, "FLIP") for kind in laws[1:]]
    scenes += [(2, 1e3, laws[0], t) for t in TRANSFERS if t != "FLIP"]
    if VERIFY:
        scenes = [(d, E, kind, t) for d in (1, 2, 3) for E in (1e3, 1e4, 1e5, 1e6)
                  for kind in laws for t in TRANSFERS]
    for nDim, E, kind, transfer in scenes:
        n = {1: 40, 2: 16, 3: 8}[nDim]
        steps = 2000 if VERIFY else 200
        dt = 0.4*1e-2/342/nDim
        case = inGas(f"rest-{nDim}-{E:g}-{kind}-{transfer}", nDim, n, soft(E, kind),
                     body(nDim, 0.503*n*1e-2, 0.27*n*1e-2), steps*dt,
                     numerics=TRANSFERS[transfer], control={"reportInterval": steps})
        if transfer != "FLIP":
            case.change("system/fvSolution", r"PICfraction[^;]*;", "")
        case.run("materialPointFoam", limit=300)
        end = case.times()[-1]
        table.row(f"rest, {nDim}D, E {E:g} Pa, {kind}, {transfer}, {case.nSteps()} steps:"
                  " speed of the points [m/s]", 0,
                  np.max(abs(case.points(end, "body")["U"])), 1e-11, "atMost")


def pulse(nDim, n, E):
    """Speed of a pulse of velocity over that of the law, and the latter [m/s]."""
    length, width, distance = (1, 0.05, 0.3) if nDim == 1 else (2, 0.1, 0.5)
    lam, mu = lame(E)
    c = np.sqrt((lam + 2*mu)/RHO if nDim == 1 else E/(1 - NU**2)/RHO)
    x = np.linspace(0, length, 401)
    u = 1e-3*c*np.exp(-((x - length/2)/width)**2)
    table = " ".join(f"({float(a)!r} ({float(b)!r} 0 0))" for a, b in zip(x, u))
    # In 2D a plate of 0.05 in gas of 0.15
    cells = (n, 1, 1) if nDim == 1 else (n, round(0.15*n/length), 1)
    low, high = (-1, 1) if nDim == 1 else (0.05, 0.1)
    case = inGas(f"wave-{nDim}-{n}", nDim, n, soft(E),
                 {"type": "box", "min": (0.05*length, low, -1), "max": (0.95*length, high, 1),
                  "velocity": {"x": f"table ({table})"}}, distance/c, rhoGas=6, h=length/n,
                 cells=cells, numerics={"shapeFunction": "GIMP", "transfer": "FLIP"},
                 control={"maxGasSubSteps": 10, "reportInterval": 1000})
    case.run("materialPointFoam", limit=600)
    p = case.points(case.times()[-1], "body")
    x, u = p["x"][:, 0] - length/2, p["U"][:, 0]
    right = (x > 0) & (u > 0.25*np.max(u))
    return np.sum(x[right]*u[right])/np.sum(u[right])/distance, c


def waves(table):
    E = 1e4
    for nDim, meshes in ((1, (50, 100, 200)),):
        found, c = zip(*(pulse(nDim, n, E) for n in meshes))
        print(f"{nDim}D, cells {meshes}: speed over {c[0]:.5g} m/s {found}", flush=True)
        table.row(f"wave in a {('bar', 'plate')[nDim - 1]}, E {E:g} Pa, {meshes[-1]} cells:"
                  f" speed over {c[0]:.4g} m/s", 1, found[-1], 1e-2)
        table.check(f"{nDim}D: the error falls on finer meshes",
                    abs(found[-1] - 1) < abs(found[0] - 1),
                    ", ".join(f"{n}: {f - 1:.2e}" for n, f in zip(meshes, found)))


def struck(name, Co, steps=None, **more):
    """A block that flies in gas of which a part has more pressure."""
    h, E = 1e-3, 2e4
    return coupledCase(
        "softInGas", name, (40, 40, 1), (40*h, 40*h, h),
        lambda x, y, z: (1.2 + 0*x, 0*x, P0 + 4000.0*(x < 8*h)), 4e-3, {"body": soft(E)},
        {"body": {"type": "box", "min": (12.2*h, 6.2*h, -1), "max": (22.3*h, 16.3*h, 1),
                  "velocity": (0.5, -0.3, 0)}},
        ends=WALL, maxCo=Co, maxCoGas=Co, numerics={"energyBudget": True},
        control={"reportInterval": 1000, "functions": {"energy": {
            "type": "materialPointEnergy", "libs": "(mpmFunctionObjects)",
            "writeControl": "timeStep", "writeInterval": 1}}, **more})


def failure(table):
    E, strength, rate = 1e4, 500.0, 10.0
    lam, mu = lame(E)
    low, high = 1.0, 2.0
    for _ in range(100):
        J = 0.5*(low + high)
        low, high = (J, high) if (lam*np.log(J) + mu*(J*J - 1))/J < strength else (low, J)
    at = (J - 1)/rate
    case = inGas("failure", 1, 100, soft(E, failureModel={
        "type": "maxPrincipalStress", "strength": strength}),
        {"type": "box", "min": (0.1, -1, -1), "max": (0.9, 1, 1), "velocity": {
            "x": f"table ((0 ({-0.5*rate} 0 0)) (1 ({0.5*rate} 0 0)))"}}, 1.2*at,
        writeInterval=0.1*at, control={"reportInterval": 1000})
    case.run("materialPointFoam", limit=300)
    share = []
    for t in (0.9*at, 1.1*at):
        p = case.points(case.timeName(t), "body")
        inside = abs(p["x"][:, 0] - 0.5) < 0.2
        share.append(np.mean(p["damage"][inside]))
    table.row(f"bar in gas, strength {strength:g} Pa: failed at 0.9 of the time of its law", 0,
              share[0], 0)
    table.row("at 1.1", 1, share[1], 0)
    table.row("failed points bear the pressure of the gas: largest sigma + p_0 over p_0", 0,
              np.max(abs(p["sigma"][inside][:, [0, 3, 5]] + P0))/P0, 1e-12, "atMost")


def restart(table):
    straight, again, two = (struck(name, 0.4, stopAt="endTime", endTime=4e-4,
                                   writeInterval=2e-4) for name in ("straight", "again", "two"))
    straight.run("materialPointFoam")
    half, end = straight.times()[1:3]
    again.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
    shutil.copytree(straight.file(half), again.file(half))
    again.run("materialPointFoam")
    table.row("restart at half time: points", 0, straight.largestDifference(
        again, end, ["body"], ("x", "U", "sigma", "V", "leftStretch")), 0, "atMost")
    two.decompose((2, 1, 1))
    two.runParallel()
    table.row("two processors against one: points", 0, straight.largestDifference(
        two, end, ["body"], ("x", "U", "sigma", "V")), 1e-10, "atMost")


if __name__ == "__main__":
    sys.exit(runParts("softInGas", rest, waves, failure, restart))
