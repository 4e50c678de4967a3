#!/usr/bin/env python3
"""Drag and gravity in flows that last, against exact values.

darcy       tutorials/darcyFlow: pressure drop of a porous block that is held, 1 %
fluidised   tutorials/fluidisedColumn: plateau of the pressure drop 2 %, velocity of
            minimum fluidisation 2 %
settling    a dilute cloud sinks through air in a closed column: terminal velocity 2 %
"""

import importlib.util
import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from coupledCases import ambient, coupledCase, gasLog
from foamCase import PROJECT, FoamCase, RunFailed
from gasCases import WALL
from report import Report


def tutorial(name, limit=300):
    """A tutorial's case, run, and its plot script as a module."""
    path = os.path.join(PROJECT, "tutorials", name)
    case = FoamCase("porousFlow", name, template=path)
    for time in case.times()[1:]:
        shutil.rmtree(case.file(time))
    for command in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
        case.run(command, limit=limit)
    spec = importlib.util.spec_from_file_location(name, os.path.join(path, "plot.py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    os.chdir(case.path)
    return case, module


def darcy(table):
    _, plot = tutorial("darcyFlow")
    r = plot.results()
    table.row("darcy: mass flux before and behind the block", r["flux"], r["fluxBehind"],
              1e-3, "relative")
    table.row("darcy: pressure drop in the block [Pa]", r["expected"], r["drop"], 1e-2,
              "relative")
    table.row("darcy: load on the block against pressures and momentum [N]",
              r["exactForce"], r["force"], 1e-3, "relative")


def fluidised(table):
    _, plot = tutorial("fluidisedColumn")
    r = plot.figures()
    table.row("fluidised: pressure drop of the fixed bed over Ergun's", 1, r["fixed"], 2e-2)
    table.row("fluidised: plateau of the pressure drop over the weight", 1, r["carried"],
              2e-2)
    table.row("fluidised: velocity at which the pressure drop reaches the weight [m/s]",
              r["Umf"], r["reached"], 2e-2, "relative")
    table.row("fluidised: velocity at which nothing lies on the grid [m/s]", r["Umf"],
              r["lifted"], 2e-2, "relative")


def wenYu(u, thetaS, thetaG, rho, mu, d):
    """Coefficient of the drag [kg/m3/s]."""
    Re = thetaG*rho*u*d/mu
    C = 24/Re*(1 + 0.15*Re**0.687) if Re < 1000 else 0.44
    return 0.75*C*thetaS*thetaG**-1.65*rho*u/d


def settling(table):
    """Of the relative velocity u = u_s - u_g the force K u/theta_g carries the weight
    of the grains less that of the air in their place; theta_s u_s = -theta_g u_g."""
    share, rhoS, d, mu, g, P, rho = 0.01, 2500.0, 1e-4, 1.8e-5, 9.81, 1e5, 1.2
    low, high = 1e-3, 10.0
    for _ in range(100):
        u = 0.5*(low + high)
        K = wenYu(u, share, 1 - share, rho, mu, d)
        low, high = (u, high) if K*u/(1 - share) < share*(rhoS - rho)*g else (low, u)
    exact = u*(1 - share)
    end = 0.5

    def gravity(case):
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (-g, 0, 0)},
                   "uniformDimensionedVectorField")
    case = coupledCase(
        "porousFlow", "settling", (100, 1, 1), (1, 0.01, 0.01),
        lambda x, y, z: (rho*(1 - rho*g*x/P), 0*x, P*(1 - rho*g*x/P)), end,
        {"grains": {"drag": {"type": "WenYu", "d": d}, "constitutiveModel": {
            "type": "linearElastic", "rho": rhoS, "E": 1e5, "nu": 0},
            "failureModel": {"type": "maxPrincipalStress", "strength": 1e-3,
                             "ambientPressure": P, "limitOn": "effective"}}},
        {"grains": {"type": "box", "min": (0.6, 0, 0), "max": (0.9, 1, 1),
                    "volumeFraction": share, "stress": ambient(P)}},
        gas={"mu": mu, "poreFloor": 1e-4}, ends=WALL, control={"reportInterval": 50},
        prepare=gravity)
    case.run("materialPointFoam", limit=300)
    f = gasLog(case)
    v = -f["pointMomentum"][:, 0]/(share*rhoS*0.3*1e-4)
    steady = v[4*len(v)//5:]
    print(f"settling: {len(v)} reports, velocity {steady.min():.4f} to {steady.max():.4f}"
          f" m/s, exact {exact:.4f}, Re {rho*u*d/mu:.1f}, Theta {f['ThetaMin'].min():.5f}")
    table.row("settling: terminal velocity [m/s]", exact, steady.mean(), 2e-2, "relative")
    table.row("settling: change of the gas' mass", 0,
              np.max(abs(f["mass"]/f["mass"][0] - 1)), 1e-12, "atMost")


def main():
    table = Report("porousFlow")
    words = sys.argv[1:]
    for part in (darcy, fluidised, settling):
        if words and part.__name__ not in words:
            continue
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
