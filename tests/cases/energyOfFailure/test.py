#!/usr/bin/env python3
"""Energy of points that fail: what their stress carries, and no more.

plane   a ball of 2.5 J on a plate, 2D: each law with each failure model that it allows,
        with and without erosion, with FMPM 2, FLIP and APIC (MPM_VERIFY=1: all of them,
        and the table energyOfFailure.txt). Largest residual of the energy over what has
        left the kinetic energy; energy that failure and laws give back; stored energy
metal   a copper ball on a plate of aluminium at 1 km/s, wedge, with the metals and damage
        of etc/materials: the same; energy and temperature of failed points against shock
        and plastic work
refused laws without what a failure model needs
columns those that failure models add (total strain, crack) and change (e, T): restart,
        two processors; no strain above the limit is whole
"""

import itertools
import math
import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (VERIFY, FoamCase, RunFailed, boxMesh, controlDict, noSchemes,
                      runParts, velocityFile)
from wedge import wedgeConditions, wedgeMesh

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
    "linearElastic": {"type": "linearElastic", **SOLID, "stress": "Kirchhoff"},
    # Its stored energy is exact for proportional strain paths only: in the table, no row
    "linearCauchy": {"type": "linearElastic", **SOLID},
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
    "flaws": {"type": "GradyKipp", "k": 1e28, "m": 8, "crackSpeed": 2000},
    "JCdamage": {"type": "JohnsonCookDamage", "D1": 0.01, "D2": 0.02, "D3": -1.5, "D4": 0,
                 "D5": 0, "referenceRate": 1, "referenceTemperature": 294,
                 "meltTemperature": 925}}
TRANSFERS = {
    "FMPM2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2},
    "FLIP": {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0},
    "APIC": {"shapeFunction": "GIMP", "transfer": "APIC"}}
#: Combinations whose points do not fail in this scene: nothing of a fluid without tension
WHOLE = [("fluid", m) for m in MODELS]
#: Refused: no plastic strain; no total strain
REFUSED = [(law, "JCdamage") for law in ("linearElastic", "linearCauchy", "neoHookean",
                                         "MooneyRivlin", "fluid")] + [("fluid", "strain")]
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
    ball = {"constitutiveModel": LAWS[law]}
    if MODELS[model]:
        ball["failureModel"] = MODELS[model]
    # Somebody has to stay
    plate = {**ball, "erosion": {"type": "damage", "time": 2e-6}} if erosion else ball
    case.write("constant/phaseProperties", {
        "phases": ["ball", "plate"], "ball": ball, "plate": plate,
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


def backOf(loss):
    """Largest amount that a loss, which grows downwards, has come back by."""
    return (loss - np.minimum.accumulate(loss)).max()


def unexplained(b):
    """What the columns leave open: K + W [+ E] less all other terms is constant."""
    totals, energies = ("Time", "total", "gas", "gasGained"), ("kinetic", "strain")
    rest = sum(b[k] for k in energies) + b.get("gasGained", 0) \
        - sum(v for k, v in b.items() if k not in totals + energies)
    return np.abs(rest - rest[0]).max()


def judge(table, label, b):
    """Rows of a budget; its largest residual over the energy exchanged."""
    spent = b["kinetic"][0] - b["kinetic"].min()
    worst = np.abs(b["residual"]).max()/spent
    if "Cauchy" not in label:
        table.row(f"{label}: largest residual over the energy exchanged", 0, worst, 0.01,
                  "atMost")
    table.row(f"{label}: energy that failure has given in all, over the energy exchanged", 0,
              b["failure"].max()/spent, 0.001, "atMost")
    table.row(f"{label}: dissipation that comes back, over the energy exchanged", 0,
              backOf(b["dissipation"])/spent, 0.01, "atMost")
    table.row(f"{label}: largest stored energy over the kinetic energy at the start", 0,
              b["strain"].max()/b["kinetic"][0], 1, "atMost")
    table.row(f"{label}: what the columns leave open, over the energy exchanged", 0,
              unexplained(b)/spent, 1e-12, "atMost")
    return worst, spent


def cases():
    for law, model, erosion, transfer in itertools.product(
            LAWS, MODELS, (False, True), TRANSFERS):
        if (law, model) not in REFUSED and not (erosion and not MODELS[model]):
            yield law, model, erosion, transfer


CHEAP = [("linearElastic", "stress", False, "FLIP"), ("neoHookean", "stress", False, "FMPM2"),
         ("neoHookean", "strain", False, "APIC"), ("MooneyRivlin", "flaws", False, "FLIP"),
         ("J2", "stress", True, "FMPM2"), ("J2", "Gf", False, "APIC"),
         ("J2e", "nothing", False, "FLIP"), ("JohnsonCook", "JCdamage", False, "FLIP"),
         ("JohnsonCooke", "flaws", False, "FLIP"), ("DruckerPrager", "impulse", False, "FMPM2"),
         ("MohrCoulomb", "none", False, "FLIP"), ("fluid", "none", False, "FLIP")]


def plane(table):
    base = template()
    lines = ["law failureModel erosion transfer: in per cent of the 2.5 J: exchanged, largest"
             " stored, at the end stored, transfer, contact, remap, failure, dissipation,"
             " erosion; largest residual and most that failure gave back for a while, in per cent"
             " of the energy exchanged"]
    for law, model, erosion, transfer in cases() if VERIFY else CHEAP:
        try:
            case = planeRun(base, law, model, erosion, transfer)
        except RunFailed as e:
            table.check(f"{law}-{model}-{erosion}-{transfer} runs", False, e)
            continue
        b = budget(case)
        worst, spent = judge(table, case.name, b)
        if MODELS[model] and not erosion:
            failed = sum((case.points(case.times()[-1], p)["damage"] > 0).sum()
                         for p in ("ball", "plate"))
            if (law, model) not in WHOLE:
                table.check(f"{case.name}: points are damaged", failed > 20, failed)
        contact = float(re.findall(r"contact (\S+), .*residual", case.log())[-1])
        eroded = b["erosion"][-1] if "erosion" in b else 0
        values = [spent, b["strain"].max(), b["strain"][-1], b["transfer"][-1], contact,
                  b["remap"][-1], b["failure"][-1], b["dissipation"][-1], eroded]
        lines.append(f"{law:13s} {model:8s} {'yes' if erosion else 'no':3s} {transfer:5s} "
                     + " ".join(f"{100*v/ENERGY:6.1f}" for v in values) + f"  {100*worst:.2f} "
                     f"{100*backOf(b['failure'])/spent:.1f}")
        if VERIFY:
            shutil.rmtree(case.path)
    print("\n".join(lines), flush=True)
    if VERIFY:
        with open(base.file("..", "energyOfFailure.txt"), "w") as f:
            f.write("\n".join(lines) + "\n")


# --- metal -------------------------------------------------------------------

SPEED = 1000.0
#: A, B, n, initial temperature, heat capacity
METALS = {"bullet": ("copperOFHC", 90e6, 292e6, 0.31, 294, 383, 8960),
          "plate": ("aluminium6061T6", 324e6, 114e6, 0.42, 294, 896, 2700)}


def metalCase(transfer, shape, erosion, end):
    case = FoamCase("energyOfFailure", f"metal-{transfer}-{shape}{'-erosion' if erosion else ''}")
    mm = 1e-3
    phases = {}
    for phase, (metal, *_) in METALS.items():
        file = "$MPM_PROJECT_DIR/etc/materials/" + metal
        phases[phase] = {
            "constitutiveModel": {"#include": f'"{file}"', **Q},
            "failureModel": {"#include": f'"{file}Damage"'},
            **({"erosion": {"type": "damage", "time": 2e-6}} if erosion else {})}
    case.write("constant/phaseProperties", {
        "phases": list(phases), **phases, "contact": {"all": {"type": "frictionless"}}})
    case.write("system/blockMeshDict", wedgeMesh(
        (-20*mm, 0), (60*mm, 40*mm), (160, 80),
        {"left": ("patch", "x-"), "right": ("patch", "x+"), "rim": ("patch", "r+")}))
    for phase in phases:
        velocityFile(case, phase, wedgeConditions(
            {"left": "calculated", "right": "calculated",
             "rim": {"type": "fixedValue", "value": "uniform (0 0 0)"}}))
    case.write("system/setMaterialPointsDict", {"regions": {
        "bullet": {"phase": "bullet", "type": "sphere", "centre": (-5*mm, 0, 0),
                   "radius": 5*mm, "pointsPerCell": 2, "velocity": (SPEED, 0, 0),
                   "samples": 4},
        "plate": {"phase": "plate", "type": "box", "min": (0, 0, -1), "max": (3*mm, 40*mm, 1),
                  "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": {
        **TRANSFERS[transfer], "shapeFunction": shape, "energyBudget": True}})
    noSchemes(case)
    case.write("system/controlDict", controlDict(
        end, end, maxCo=0.3,
        functions={"energy": {"type": "materialPointEnergy", **LIBS, "writeInterval": 10}}))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def metal(table):
    runs = [("FMPM2", "GIMP", False, 18e-6), ("APIC", "linear", False, 18e-6)]
    if VERIFY:
        # Until the first fast debris is at the end of the mesh
        runs += [(transfer, "GIMP", erosion, 12e-6) for transfer in TRANSFERS
                 for erosion in (False, True)]
    for transfer, shape, erosion, end in runs:
        case = metalCase(transfer, shape, erosion, end)
        label = f"metal, {transfer}, {shape}{', erosion' if erosion else ''}"
        seconds = case.run("materialPointFoam", limit=400)
        b = budget(case)
        worst, spent = judge(table, label, b)
        print(f"{label}: exchanged {spent:.3f} of {b['kinetic'][0]:.3f} J, residual "
              f"{worst:.4f}, remap {b['remap'][-1]/spent:.4f}, transfer "
              f"{b['transfer'][-1]/spent:.4f}; {seconds:.1f} s")
        table.row(f"{label}: largest kinetic energy over that of the first step", 1,
                  b["kinetic"].max()/b["kinetic"][0], 1.001, "atMost")
        for phase, (_, A, B, n, T0, cp, rho) in METALS.items():
            points = case.points(case.times()[-1], phase)
            failed = points["damage"] >= 1
            if erosion or failed.sum() < 10:
                continue
            e, T, eps = (points[c][failed] for c in ("e", "T", "plasticStrain"))
            # A shock can give no more than the whole velocity at once; rates of
            # 1e6/s raise the strength by less than a half
            most = 0.5*SPEED**2 + 1.5*(A + B*eps**n)*eps/rho
            table.row(f"{label}, {phase}: e of failed points over shock and plastic work", 0,
                      (e/most).max(), 1, "atMost")
            table.row(f"{label}, {phase}: their temperature rise over that of this energy", 0,
                      ((T - T0)*cp/most).max(), 1, "atMost")
            # Isentropic expansion to the tension that they can bear, 5 %
            table.row(f"{label}, {phase}: their least temperature over that at the start", 1,
                      T.min()/T0, math.exp(-2*0.05), "atLeast")


# --- refused, columns --------------------------------------------------------

def refused(table):
    base = template()
    for law, model in REFUSED:
        words = "needs a law with"
        try:
            case = planeRun(base, law, model, False, "FLIP")
            table.check(f"{law} with {MODELS[model]['type']} is refused", False, case.name)
        except RunFailed as e:
            table.check(f"{law} with {MODELS[model]['type']} is refused", words in str(e), e)


def columns(table):
    """The ball breaks by its strain, the plate by cracks."""
    base = template()
    STATE = ("x", "U", "sigma", "damage", "e", "T", "plasticStrain", "crack", "leftStretch")

    def made(name):
        case = FoamCase("energyOfFailure", name, template=base.path)
        shutil.copytree(base.file("constant", "polyMesh"), case.file("constant", "polyMesh"))
        law = LAWS["JohnsonCooke"]
        case.write("constant/phaseProperties", {
            "phases": ["ball", "plate"],
            "ball": {"constitutiveModel": law,
                     "failureModel": {"type": "maxPrincipalStrain", "strain": 0.02}},
            "plate": {"constitutiveModel": law, "failureModel": MODELS["Gf"]},
            "contact": {"all": {"type": "frictionless"}}})
        case.write("system/fvSolution", {"materialPoints": {
            **TRANSFERS["FMPM2"], "energyBudget": True}})
        control = controlDict(12e-6, 6e-6, maxCo=0.3)
        case.write("system/controlDict", {**control, "startFrom": "latestTime"})
        return case

    one = made("columns")
    one.run("materialPointFoam")
    half, end = [t for t in one.times() if t != "0"]
    ball, plate = one.points(end, "ball"), one.points(end, "plate")
    b = ball["leftStretch"]
    full = np.zeros((len(b), 3, 3))
    for k, (i, j) in enumerate(((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))):
        full[:, i, j] = full[:, j, i] = b[:, k]
    strain = 0.5*np.log1p(np.linalg.eigvalsh(full)[:, 2])
    whole = ball["damage"] < 1
    table.check("strain: some points fail, some do not", 5 < whole.sum() < len(whole) - 5,
                f"{(~whole).sum()} of {len(whole)}")
    table.row("strain: largest total strain of a whole point", 0.02, strain[whole].max(), 0.02,
              "atMost")
    table.row("strain: their largest elastic strain is far below", 0,
              np.abs(ball["elasticStrain"][whole]).max(), 0.015, "atMost")
    d, crack = plate["damage"], plate["crack"]
    table.check("crack: where there is damage, and only there", np.array_equal(d > 0, crack > 0)
                and (d > 0).sum() > 20, (d > 0).sum())
    table.row("crack: least and largest of failed points", 1,
              crack[d >= 1].min() if (d >= 1).any() else np.nan, 1e-9)
    table.check("crack: below the damage, at most 1", (crack <= d*(1 + 1e-9)).all())

    again = made("columns-again")
    shutil.copytree(one.file(half), again.file(half))
    again.run("materialPointFoam")
    two = made("columns-2")
    two.decompose((2, 1, 1))
    two.runParallel()
    for case, label, limit in ((again, "restart", 0), (two, "two processors", 1e-9)):
        table.row(f"columns, {label}: largest difference", 0, one.largestDifference(
            case, end, ["ball", "plate"], STATE), limit, "atMost")

    def books(case, place=""):
        with open(case.file(place, end, "uniform/materialPointState")) as f:
            energy = re.search(r"energy\s*\{(.*?)\}", f.read(), re.S)[1]
        return {k: float(v) for k, v in re.findall(r"(\w+)\s+(\S+);", energy)}

    a, r, t = books(one), books(again), books(two, "processor0")
    table.check("columns, restart: the budget bit by bit", a == r)
    table.row("columns, two processors: the budget, largest difference over 2.5 J", 0,
              max(abs(a[k] - t[k]) for k in a)/ENERGY, 1e-9, "atMost")


def main():
    return runParts("energyOfFailure", plane, metal, refused, columns)


if __name__ == "__main__":
    sys.exit(main())
