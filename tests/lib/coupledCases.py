"""Cases of material points in a gas, in a box; figures from their log.

    case = coupledCase("immersed", "slab", (100, 1, 1), (1, 0.01, 0.01),
                       initial=lambda x, y, z: (rho, u, p), endTime=0.1,
                       phases={"slab": {"constitutiveModel": {...}}},
                       regions={"slab": {"type": "box", ...}}, ends=WALL)
    case.run("materialPointFoam")
    gas = gasLog(case)                  # arrays, one value per report

The rest as gasCases.gasCase; a region's phase is its own name. Points slip along
the patches unless pointConditions says otherwise.
"""

import re

import numpy as np

from foamCase import velocityFile
from gasCases import UPWIND, gasCase

TRANSFER = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}


def coupledCase(folder, name, cells, high, initial, endTime, phases, regions, gas=None,
                pointConditions="slip", numerics=None, maxCo=0.4, prepare=None, ppc=2,
                control=None, reconstruct=UPWIND, **options):
    """prepare(case): writes what the regions need before setMaterialPoints."""
    case = gasCase(folder, name, cells, high, initial, endTime, reconstruct=reconstruct,
                   thermo={"thermo": "perfectGas", "R": 1, "gamma": 1.4, **(gas or {})},
                   control={"maxCo": maxCo, **(control or {})}, **options)
    air = {"type": "gas", "thermo": "perfectGas", "R": 1, "gamma": 1.4, **(gas or {})}
    addPoints(case, {"air": air}, phases, regions, pointConditions, numerics, ppc, prepare)
    return case


def addPoints(case, flow, phases, regions, pointConditions="slip", numerics=None, ppc=2,
              prepare=None):
    """Points beside the phases of flow: their files, and setMaterialPoints."""
    case.write("constant/phaseProperties", {
        "phases": [*(n for n in flow if n != "fluids"), *phases], **flow,
        **{p: {"velocityField": "solids", **e} for p, e in phases.items()}})
    with open(case.file("constant/polyMesh/boundary")) as f:
        kinds = re.findall(r"(\w+)\s*\{\s*type\s+(\w+);", f.read())
    velocityFile(case, "solids", {
        n: kind if kind in ("empty", "cyclic") else pointConditions
        for n, kind in kinds})
    case.write("system/fvSolution", {"materialPoints": {**TRANSFER, **(numerics or {})}})
    case.write("system/setMaterialPointsDict", {"regions": {
        p: {"phase": p, "pointsPerCell": ppc, **e} for p, e in regions.items()}})
    if prepare:
        prepare(case)
    case.run("setMaterialPoints")


def ambient(p):
    """Stress of points at rest in a gas of a pressure."""
    return f"({-p} 0 0 {-p} 0 {-p})"


def gasLog(case):
    """mass, energy, momentum of the gas, least and largest p, fix-ups, Theta; of the
    points kinetic and total energy and momentum: arrays over the reports."""
    log = case.log()

    def column(pattern):
        return np.array([[float(v) for v in (m if isinstance(m, tuple) else (m,))]
                         for m in re.findall(pattern, log, re.M)]).squeeze(axis=-1)

    def vectors(pattern):
        return np.array([m.split() for m in re.findall(pattern, log, re.M)], float)

    number = r"([-\d.e+]+)"
    return {
        "mass": column(rf"^Gas air: mass {number}"),
        "energy": column(rf"^Gas air: .*energy {number}"),
        "momentum": vectors(r"^Gas air: mass .*momentum \(([^)]*)\)"),
        "pMin": column(rf"^    p {number} to"),
        "pMax": column(rf"^    p \S+ to {number},"),
        "limited": column(rf"outflow limited {number}"),
        "kept": column(rf"theta kept {number}"),
        "isentropic": column(rf"isentropic {number}"),
        "ThetaMin": column(rf"^Theta: min {number}"),
        "ThetaMax": column(rf"^Theta: min \S+ max {number}"),
        "kinetic": column(rf"^Energy: kinetic {number}"),
        "total": column(rf"^Energy: kinetic .* total {number}"),
        "pointMomentum": vectors(r"^Material points: .*momentum \(([^)]*)\)")}
