"""One scene with all that load balance moves: a charge detonates in air, between walls and
under gravity; plates of points are thrown onto each other and onto a free rigid body.

    case = everything("straight")
    sums(case)          # {function and file: its rows}
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../lib"))
from coupledCases import TRANSFER
from detonations import TNT
from fluidCases import besidePoints, fluidCase
from foamCase import velocityFile
from gasCases import WALL

H, CELLS = 1/160, (48, 32, 1)
FLUIDS = {"charge": {**TNT, "detonation": {"type": "programmedBurn", "velocity": 6930,
                                           "points": [(0.09, 0.1, 0)]}},
          "air": {"thermo": "perfectGas", "R": 287, "gamma": 1.4}}
LAW = {"constitutiveModel": {"type": "J2Plasticity", "rho": 2700, "E": 7e10, "nu": 0.3,
                             "yield": 3e8, "hardening": "none"},
       "failureModel": {"type": "maxPrincipalStress", "strength": 9e8, "weibull": {"modulus": 10,
                                                                           "seed": 3}}}
EACH = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}
BOOKS = {"energy": {"type": "materialPointEnergy", **EACH},
         "balance": {"type": "materialPointBalance", **EACH},
         "fluids": {"type": "fluidBalance", **EACH}}
PHASES = ("plate", "cover", "body")


def everything(name, end=4.2e-5):
    """The case, not run yet."""
    def initial(x, y, z):
        a = np.clip((0.04 - np.hypot(x - 0.09, y - 0.1))/H + 0.5, 0, 1)
        return [a, 1 - a], [1630.0, 1.2], 0.0, 1e5
    high = [H*n for n in CELLS]
    case = fluidCase("loadBalance", name, CELLS, high, FLUIDS, initial, end, ends=WALL, sides=WALL,
                     gravity=(0, -1e5, 0), control={
                         "maxCo": 0.3, "deltaT": 1e-9, "functions": BOOKS, "reportInterval": 1})
    phases = {"plate": {**LAW, "velocityField": "solids"},
              "cover": {**LAW, "velocityField": "cover"},
              "body": {"type": "rigid", "rho": 7800, "motion": {
                  "type": "free", "velocity": (-100, 20, 0), "angularVelocity": (0, 0, 500)},
                  "velocityField": "body"}}

    def conditions(case):
        for field in ("cover", "body"):
            velocityFile(case, field, {"ends": "slip", "sides": "slip", "frontAndBack": "empty"})
        case.change("constant/phaseProperties", "^phases",
                    "contact { all { type Coulomb; mu 0.3; } }\nphases")
    stress = {"stress": "ambient", "pressure": 1e5}
    besidePoints(case, FLUIDS, phases, {
        "plate": {"type": "box", "min": (0.15, 0.05, -1), "max": (0.165, 0.15, 1), **stress},
        "cover": {"type": "box", "min": (0.175, 0.06, -1), "max": (0.19, 0.14, 1), **stress},
        "body": {"type": "sphere", "centre": (0.213, 0.11, 0.5*H), "radius": 0.02}},
        numerics={**TRANSFER, "energyBudget": True}, prepare=conditions)
    return case


def sums(case):
    """Mass, momentum with its rest, energies: of phases, fluids, and all."""
    found = {}
    for function, file in (("energy", "energy.dat"), ("balance", "mixture.dat"),
                           *(("balance", p + ".dat") for p in PHASES),
                           *(("fluids", f + ".dat") for f in (*FLUIDS, "total"))):
        found[f"{function} {file}"] = case.series(function, file)
    return found
