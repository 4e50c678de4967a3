#!/usr/bin/env python3
"""Energy of points that fail: what their stress carries, and no more.

plane   a ball of 2.5 J on a plate, 2D: each law with each failure model that it allows,
        with and without erosion, with FMPM 2, FLIP and APIC (MPM_VERIFY=1: all of them).
        Residual of the energy over what has left the kinetic energy; failed points
        take energy and give none; stored energy below what was there
metal   a copper ball on a plate of aluminium at 1 km/s, wedge, with the metals and damage
        of etc/materials: the same; energy and temperature of failed points against shock
        and plastic work
columns crack: the part of Gf that is spent; total strain of maxPrincipalStrain
"""

import itertools
import math
import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (PROJECT, VERIFY, FoamCase, RunFailed, boxMesh, controlDict, noSchemes,
                      runParts, velocityFile)

# --- plane -------------------------------------------------------------------

H, R, RHO, E, NU = 1e-3, 4e-3, 2700.0, 70e9, 0.3
ENERGY = 2.5
V = math.sqrt(2*ENERGY/(RHO*math.pi*R**2*H))
G, K = E/(2*(1 + NU)), E/(3*(1 - 2*NU))
SOLID = {"rho": RHO, "E": E, "nu": NU}
METAL = {"rho": RHO, "G": G}
GRUENEISEN = {"equationOfState": {"type": "MieGrueneisen", "C0": math.sqrt(K/RHO), "S": 1.34,
                                  "Gamma0": 2}}
JC = {"type": "JohnsonCook", **METAL, "A": 150e6, "B": 100e6, "n": 0.4, "C": 0.01, "m": 1,
      "referenceRate": 1, "referenceTemperature": 294, "meltTemperature": 925, "cp": 896,
      "beta": 0.9}
ROCK = {**SOLID, "cohesion": 200e6, "frictionAngle": 30, "dilationAngle": 10}
Q = {"bulkViscosity": {"linear": 0.06, "quadratic": 1.5}}
J2 = {"type": "J2Plasticity", **METAL, "yield": 250e6, "hardening": "none"}
LAWS = {
    "linearElastic": {"type": "linearElastic", **SOLID},
    "neoHookean": {"type": "neoHookean", **SOLID},
    "MooneyRivlin": {"type": "MooneyRivlin", "rho": RHO, "c10": 0.4*G, "c01": 0.1*G, "K": K},
    "J2": {**J2, "K": K},
    "J2e": {**J2, **GRUENEISEN, **Q},
    "JohnsonCook": {**JC, "K": K, **Q},
    "JohnsonCooke": {**JC, **GRUENEISEN, **Q},
    "DruckerPrager": {"type": "DruckerPrager", **ROCK, "match": "planeStrain"},
    "MohrCoulomb": {"type": "MohrCoulomb", **ROCK},
    "fluid": {"type": "NewtonianFluid", "rho": RHO, "mu": 1, "K": K, "pMin": 0, **Q}}
STRENGTH = 150e6
MODELS = {
    "none": None,
    "stress": {"type": "maxPrincipalStress", "strength": STRENGTH},
    "nothing": {"type": "maxPrincipalStress", "strength": STRENGTH, "failed": "nothing"},
    "Gf": {"type": "maxPrincipalStress", "strength": STRENGTH, "Gf": 1500},
    "strain": {"type": "maxPrincipalStrain", "strain": 2.5e-3},
    "impulse": {"type": "TulerButcher", "strength": STRENGTH, "exponent": 1, "impulse": 20},
    "flaws": {"type": "GradyKipp", "k": 1e32, "m": 8, "crackSpeed": 2000},
    "JCdamage": {"type": "JohnsonCookDamage", "D1": 0.01, "D2": 0.02, "D3": -1.5, "D4": 0,
                 "D5": 0, "referenceRate": 1, "referenceTemperature": 294,
                 "meltTemperature": 925}}
TRANSFERS = {
    "FMPM2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2},
    "FLIP": {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0},
    "APIC": {"shapeFunction": "GIMP", "transfer": "APIC"}}
#: Refused: no plastic strain; no total strain
REFUSED = ([(law, "JCdamage") for law in ("linearElastic", "neoHookean", "MooneyRivlin",
                                          "fluid")] + [("fluid", "strain")])
LIBS = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep"}


def template():
    """Mesh and points, the same for all laws."""
    case = FoamCase("energyOfFailure", "template")
    cells = (30, 24)
    case.write("constant/phaseProperties", {
        "phases": ["ball", "plate"],
        **{p: {"constitutiveModel": LAWS["linearElastic"]} for p in ("ball", "plate")}})
    case.write("system/blockMeshDict", boxMesh(
        (-14*H, -12*H, 0), (16*H, 12*H, H), (*cells, 1),
        {"outer": ("patch", ("x-", "x+", "y-", "y+")),
         "frontAndBack": ("empty", ("z-", "z+"))}))
    for phase in ("ball", "plate"):
        velocityFile(case, phase, {"outer": "calculated", "frontAndBack": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {
        "ball": {"phase": "ball", "type": "sphere", "centre": (-R, 0, 0.5*H), "radius": R,
                 "pointsPerCell": 2, "velocity": (V, 0, 0)},
        "plate": {"phase": "plate", "type": "box", "min": (0, -8*H, 0), "max": (2*H, 8*H, H),
                  "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": TRANSFERS["FLIP"]})
    noSchemes(case)
    case.write("system/controlDict", controlDict(1e-6, 1e-6, maxCo=0.3))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def planeRun(base, law, model, erosion, transfer):
    name = "-".join((law, model, "erosion" if erosion else "all", transfer))
    case = FoamCase("energyOfFailure", name, template=base.path)
    shutil.copytree(base.file("constant", "polyMesh"), case.file("constant", "polyMesh"))
    phase = {"constitutiveModel": LAWS[law]}
    if MODELS[model]:
        phase["failureModel"] = MODELS[model]
        if erosion:
            phase["erosion"] = {"type": "damage", "time": 2e-6}
    case.write("constant/phaseProperties", {
        "phases": ["ball", "plate"], "ball": phase, "plate": phase,
        "contact": {"all": {"type": "frictionless"}}})
    case.write("system/fvSolution", {"materialPoints": {
        **TRANSFERS[transfer], "energyBudget": True}})
    case.write("system/controlDict", controlDict(
        20e-6, 20e-6, maxCo=0.3,
        functions={"energy": {"type": "materialPointEnergy", **LIBS, "writeInterval": 5}}))
    case.run("materialPointFoam", limit=300)
    return case


def budget(case):
    """Columns of the energy budget by name."""
    path = case.file("postProcessing", "energy", "0", "energy.dat")
    with open(path) as f:
        names = [line for line in f if line.startswith("#")][-1].strip("# \n").split()
    table = np.loadtxt(path, ndmin=2)
    return {n.split("[")[0]: table[:, i] for i, n in enumerate(names)}


def judge(b, start, spent):
    """Residual, energy that failed points give back, largest stored energy; all over
    what has left the kinetic energy."""
    worst = np.abs(b["residual"]).max()
    back = max(np.maximum.accumulate(-b["failure"]).max() + b["failure"][-1], 0)
    return worst/spent, back/spent, b["strain"].max()/spent


def cases():
    for law, model, erosion, transfer in itertools.product(
            LAWS, MODELS, (False, True), TRANSFERS):
        if (law, model) not in REFUSED and not (erosion and not MODELS[model]):
            yield law, model, erosion, transfer


CHEAP = [("linearElastic", "stress", False, "FLIP"), ("neoHookean", "stress", False, "FMPM2"),
         ("MooneyRivlin", "strain", False, "FLIP"), ("J2", "stress", True, "FMPM2"),
         ("J2", "Gf", False, "APIC"), ("J2e", "nothing", False, "FLIP"),
         ("JohnsonCook", "JCdamage", False, "FLIP"), ("JohnsonCooke", "flaws", False, "FLIP"),
         ("DruckerPrager", "impulse", False, "FMPM2"), ("MohrCoulomb", "none", False, "FLIP"),
         ("fluid", "none", False, "FLIP")]


def plane(table):
    base = template()
    for law, model, erosion, transfer in cases() if VERIFY else CHEAP:
        case = planeRun(base, law, model, erosion, transfer)
        b = budget(case)
        spent = ENERGY - b["kinetic"].min()
        residual, back, stored = judge(b, ENERGY, spent)
        print(f"{case.name}: kinetic {b['kinetic'][-1]:.3f}, strain {b['strain'][-1]:.3f}, "
              f"transfer {b['transfer'][-1]:.3f}, failure {b['failure'][-1]:.3f}, "
              f"dissipation {b['dissipation'][-1]:.3f}, residual "
              f"remap {b['remap'][-1]:.3f}, {b['residual'][-1]:.4f}, worst {residual:.4f}, back {back:.4f}")
        table.row(f"{case.name}: residual over the energy exchanged", 0, residual, 0.01,
                  "atMost")


def main():
    return runParts("energyOfFailure", plane)


if __name__ == "__main__":
    sys.exit(main())
