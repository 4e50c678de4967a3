#!/usr/bin/env python3
"""The law muI in flows: dense grains whose friction grows with the rate of shear.

bagnold    steady flow down a rough slope: Bagnold's profile, exact, on three meshes with
           three transfers
column     columns as high as wide and twice as high collapse: run-out
again      restart and two processors
bubble     tutorials/fluidisedBed: size of the bubble beside that by twoPhaseEulerFoam
fluctuations   granular temperature in a gas: damped, fed, energy, two processors
immersed   loose and dense columns in a viscous liquid: sign of the pore pressure, run-out

MPM_VERIFY=1: also a high column, constant friction, FLIP with PIC, columns without dilatancy,
6 s in the liquid.
"""

import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (PROJECT, VERIFY, FoamCase, boxMesh, controlDict, foamText,
                      noSchemes, runParts, velocityFile)
import bubble as beds
from fluctuations import fluctuations


G = 9.81

#: Friction of glass beads (Jop et al. 2006: tan 20.9 and tan 32.76 degrees, I0 0.279)
BEADS = {"muS": 0.383, "mu2": 0.643, "I0": 0.279}

#: The last in the long series only
TRANSFERS = {"FLIP": {"transfer": "FLIP"}, "FMPM 2": {"transfer": "FMPM", "order": 2},
             "APIC": {"transfer": "APIC"},
             "FLIP 1 % PIC": {"transfer": "FLIP", "PICfraction": 0.01}}


def slopeRun(label, n, end):
    """Layer of n cells, 0.1 m, on a slope of 26 degrees with cyclic ends; gravity grows
    in 0.2 s. The case, exact velocity at y."""
    H, slope, cells = 0.1, np.radians(26), 3
    h, mu = H/n, np.tan(slope)
    law = {"type": "muI", "rho": 1500, "E": 1e6, "nu": 0.2, **BEADS, "d": 0.02,
           "packing": 0.6}
    I = law["I0"]*(mu - law["muS"])/(law["mu2"] - mu)

    def exact(y):
        return (2/3*I/law["d"]*np.sqrt(law["packing"]*G*np.cos(slope))
                * (H**1.5 - np.maximum(H - y, 0)**1.5))
    case = FoamCase("grains", f"slope-{label.replace(' ', '').replace('%', '')}-{n}")
    g = foamText(G*np.array([np.sin(slope), -np.cos(slope), 0]))
    case.write("constant/phaseProperties", {"phases": ["sand"], "sand": {
        "constitutiveModel": law, "bodyForce": {
            "type": "uniform", "acceleration": f"table ((0 (0 0 0)) (0.2 {g}) (100 {g}))"}}})
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (cells*h, (n + 3)*h, h), (cells, n + 3, 1),
        {"left": ("cyclic", ("x-",), "right"), "right": ("cyclic", ("x+",), "left"),
         "floor": ("wall", ("y-",)), "top": ("patch", ("y+",)),
         "frontAndBack": ("empty", ("z-", "z+"))}))
    velocityFile(case, "sand", {
        "left": "cyclic", "right": "cyclic", "top": "calculated", "frontAndBack": "empty",
        "floor": {"type": "fixedValue", "value": "uniform (0 0 0)"}})
    case.write("system/setMaterialPointsDict", {"regions": {"sand": {
        "phase": "sand", "type": "box", "min": (0, 0, 0), "max": (cells*h, H, h),
        "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "GIMP", "dilatation": "cellMean", **TRANSFERS[label]}})
    noSchemes(case)
    case.write("system/controlDict", controlDict(end, 0.2*end, 0.3))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=300)
    return case, exact


def bagnold(table):
    """u = 2/3 I/d sqrt(packing g cos) (H^1.5 - (H - y)^1.5) with mu(I) = tan: the pressure
    is rho g cos (H - y), I the same at all depths."""
    end = 5
    for label in list(TRANSFERS)[:4 if VERIFY else 3]:
        errors = []
        for n in (6, 12, 24):
            case, exact = slopeRun(label, n, end)
            points, before = case.points(f"{end}", "sand"), case.points("4", "sand")
            y, u = points["x"][:, 1], points["U"][:, 0]
            errors.append(np.sqrt(np.mean((u - exact(y))**2))/exact(0.1))
            print(f"slope, {label}, {n} cells: surface {exact(0.1):.4f} m/s, fastest point"
                  f" {u.max():.4f}, rms error {errors[-1]:.5f}, mean velocity over that of a"
                  f" second ago {u.mean()/before['U'][:, 0].mean():.6f}")
        print(f"slope, {label}: order {np.log2(errors[0]/errors[2])/2:.2f}")
        if label != "FLIP 1 % PIC":
            table.row(f"slope, {label}, 24 cells: rms error over the velocity of the"
                      " surface", 0, errors[2], 1e-2)


def columnRun(name, aspect, end, h=5e-3, law=None):
    """Half of a plane column, 0.1 m wide, on a floor that holds its lowest points."""
    L = 0.1
    nx, ny = int(round((2 + 1.5*aspect)*L/h)), int(round((aspect + 0.1)*L/h))
    case = FoamCase("grains", name)
    case.write("constant/phaseProperties", {"phases": ["sand"], "sand": {
        "constitutiveModel": {"type": "muI", "rho": 1500, "E": 0.84e6, "nu": 0.3, **BEADS,
                              "d": 1.15e-3, "packing": 0.6, **(law or {})}}})
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, -G, 0)},
               "uniformDimensionedVectorField")
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (nx*h, ny*h, h), (nx, ny, 1),
        {"middle": ("symmetryPlane", ("x-",)), "floor": ("wall", ("y-",)),
         "outside": ("patch", ("x+", "y+")), "frontAndBack": ("empty", ("z-", "z+"))}))
    velocityFile(case, "sand", {
        "middle": "symmetryPlane", "outside": "calculated", "frontAndBack": "empty",
        "floor": {"type": "fixedValue", "value": "uniform (0 0 0)"}})
    case.write("system/setMaterialPointsDict", {"regions": {"sand": {
        "phase": "sand", "type": "box", "min": (0, 0, 0), "max": (L, aspect*L, h),
        "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "GIMP", "dilatation": "cellMean", "transfer": "FLIP",
        "PICfraction": 0.01}})
    noSchemes(case)
    case.write("system/controlDict", {**controlDict(end, 0.1, 0.3), "startFrom": "latestTime"})
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def runout(case, time, h):
    """(L - L0)/L0 by the end of the heap, as in tutorials/sandColumn; height over L0."""
    x = case.points(time, "sand")["x"]
    count = np.bincount((x[:, 0]/h).astype(int), minlength=1000)
    return h*np.argmax(count < 4)/0.1 - 1, x[:, 1].max()/0.1


def column(table):
    """Fits of Lube et al. and Lajeunesse et al., after Lagree et al. (2011): 1.2 and 1.8
    times the aspect ratio a of low columns, 1.9 and 2.3 a^(2/3) of high ones."""
    for a, end, h in ((1, 0.5, 5e-3), (2, 0.6, 5e-3), (6, 1, 1e-2))[:3 if VERIFY else 2]:
        case = columnRun(f"column-{a}", a, end, h)
        case.run("materialPointFoam", limit=300)
        times = case.times()[1:]
        run = [runout(case, t, h) for t in times]
        print(f"column, aspect ratio {a}: run-out and height of the last three times",
              *(f"{t} s {r[0]:.2f} {r[1]:.2f};" for t, r in zip(times[-3:], run[-3:])))
        low, high = (1.2*a, 1.8*a) if a < 3 else (1.9*a**(2/3), 2.3*a**(2/3))
        if a < 3:
            table.row(f"column, aspect ratio {a}: run-out", 0.5*(low + high), run[-1][0],
                      0.5*(high - low))
    if VERIFY:
        slow = columnRun("column-2-slow", 2, 0.6, law={"mu2": BEADS["muS"]})
        slow.run("materialPointFoam", limit=300)
        print(f"column, aspect ratio 2, friction muS: {runout(slow, '0.6', 5e-3)}")


COLUMNS = ("x", "U", "m", "V", "sigma", "openStrain", "plasticStrain",
           "granularTemperature")


def again(table):
    """A column with dilatancy and collisions: restart and two processors."""
    law = {"dilatancy": {"phiC": 0.58, "K2": 0.2, "K3": 4},
           "collisions": {"e": 0.9, "alphaMax": 0.65}}
    case, second, two = (columnRun(f"again-{n}", 1, 0.3, 1e-2, law) for n in range(3))
    case.run("materialPointFoam")
    shutil.copytree(case.file("0.2"), second.file("0.2"))
    second.run("materialPointFoam")
    table.row("restart: largest difference at the end", 0,
              case.largestDifference(second, "0.3", ["sand"], COLUMNS), 0, "atMost")
    two.decompose((2, 1, 1))
    two.runParallel()
    table.row("1 and 2 processors: largest difference at the end", 0,
              case.largestDifference(two, "0.3", ["sand"], COLUMNS), 1e-10, "atMost")


#: Rondon et al. (2011): columns of glass beads in a viscous liquid, 60 mm wide, loose (48 mm
#: high) and dense (42 mm), sizes from memory. Constants of friction and dilatancy after
#: Pailha & Pouliquen, from memory
LIQUID, RHOS, ETA = 1010, 2500, 12e-3
IMMERSED = {"muS": 0.415, "mu2": 0.868, "I0": 0.005, "viscosity": ETA}
DILATANCY = {"phiC": 0.582, "K2": 25, "K3": 4.09}


def immersedRun(name, packing, height, end, dilatancy=True, h=6e-3):
    """A column in a tank with a free surface, in equilibrium but for its side; the case."""
    case = FoamCase("grains", name, os.path.join(PROJECT, "tutorials/submergedSand/water"))
    case.run("cp", "-r", "0.orig", "0")
    law = {"type": "muI", "rho": RHOS, "E": 3e5, "nu": 0.2, **IMMERSED, "packing": packing,
           **({"dilatancy": DILATANCY} if dilatancy else {})}
    case.write("constant/phaseProperties", {
        "phases": ["water", "air", "sand"],
        "water": {"type": "fluid", "rho": LIQUID, "equationOfState": {
            "type": "stiffenedGas", "gamma": 1.12, "soundSpeed": 20, "p0": 1e3}},
        "air": {"type": "fluid", "thermo": "perfectGas", "R": 287, "gamma": 1.4},
        "fluids": {"lowMach": "yes", "mu": ETA},
        "sand": {"volumeModel": "grains", "constitutiveModel": law,
                 "drag": {"type": "Gidaspow", "d": 225e-6}}})
    nx, ny = int(round(0.24/h)), int(round(0.09/h))
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (nx*h, ny*h, h), (nx, ny, 1),
        {"floor": ("wall", ("y-",)), "walls": ("wall", ("x-", "x+", "y+")),
         "frontAndBack": ("empty", ("z-", "z+"))}))
    regions = {}
    for i in range(int(round(height/h))):
        # Stress in the volume of the grains
        s = (RHOS - LIQUID)*G*(height - (i + 0.5)*h)
        regions[f"layer{i}"] = {
            "phase": "sand", "type": "box", "min": (0, i*h, 0), "max": (0.06, (i + 1)*h, h),
            "pointsPerCell": 3, "volumeFraction": packing,
            "stress": (-0.6*s, 0, 0, -s, 0, -0.6*s)}
    case.write("system/setMaterialPointsDict", {"regions": regions})
    case.write("system/setFluidsDict", {
        "default": {"fluid": "air", "T": 1.2},
        "hydrostatic": {"point": (0.1, 0.085, 0.5*h), "p": 1e3},
        "regions": {"water": {"type": "box", "min": (-1, -1, -1), "max": (1, 0.078, 1),
                              "fluid": "water"}}})
    # Else the volume of each point goes its own way, and half of them part
    case.change("system/fvSolution", "shapeFunction", "dilatation cellMean; shapeFunction")
    case.change("system/controlDict", r"^endTime .*?;", f"endTime {end};")
    case.change("system/controlDict", r"^writeInterval .*?;", "writeInterval 0.05;")
    for command in ("blockMesh", "setMaterialPoints", "setFluids"):
        case.run(command)
    case.run("materialPointFoam", limit=3000 if VERIFY else 300)
    return case


def immersed(table):
    """Rondon et al.: the pore pressure under a loose column rises, it runs fast; that under
    a dense one falls, it is slow and runs half as far (abstract). Without dilatancy both
    do nearly the same, and the pressure falls a little under both."""
    end, probe = (6 if VERIFY else 1), 3
    runs = {}
    for name, packing, height, dilatancy in (
            ("loose", 0.55, 0.048, True), ("dense", 0.60, 0.042, True),
            ("loose, no dilatancy", 0.55, 0.048, False),
            ("dense, no dilatancy", 0.60, 0.042, False))[:4 if VERIFY else 2]:
        case = immersedRun("immersed-" + name.replace(", ", "-").replace(" ", ""), packing,
                           height, end, dilatancy)
        times = case.times("lagrangian")
        x = np.array([np.percentile(case.points(t, "sand")["x"][:, 0], 99.5) for t in times])
        p = np.array([case.field(t, "p", 40, 15)[0, probe] for t in times])
        # Weight of the grains in the liquid on the bottom
        weight = packing*(RHOS - LIQUID)*G*height
        early = (p[1:] - p[0])[np.array(times[1:], float) < 0.25]/weight
        volume = case.points(times[-1], "sand")["V"].sum()/case.points("0", "sand")["V"].sum()
        runs[name] = (x[-1] - x[0])/0.06, early[np.argmax(abs(early))]
        print(f"{name}: run-out over the width at {end} s {runs[name][0]:.3f}, pore pressure"
              f" over the weight, to 0.2 s {early.min():.3f} to {early.max():.3f}, volume"
              f" {volume:.4f}, {case.nSteps()} steps, {case.solverSeconds():.0f} s;",
              "run-out", *(f"{v:.3f}" for v in (x - x[0])[::len(x)//10]/0.06))
    table.row("loose column in a liquid: pore pressure over the weight", 0,
              runs["loose"][1], 0, "atLeast")
    table.row("dense column in a liquid: pore pressure over the weight", 0,
              runs["dense"][1], 0, "atMost")
    table.row("dense column in a liquid: run-out over that of the loose one", 0,
              runs["dense"][0]/runs["loose"][0], 0.5, "atMost")


def bubble(table):
    """Diameter of the bubble that a jet blows, 10 % of that by twoPhaseEulerFoam; of the granular
    temperature (median) a quarter of it. MPM_VERIFY=1:
    that computed anew, both on cells of half the size; ours without collisions."""
    end = 0.3 if VERIFY else 0.2
    case, found = beds.ours("bed", 1, end)
    reference = beds.RESULTS.REFERENCE
    for t in (0.1, 0.2):
        table.row(f"bubble in a bed at {t} s: diameter over twoPhaseEulerFoam's", 1,
                  found[t][0]/reference[t][0], 0.1)
    table.row("bubble in a bed at 0.2 s: median granular temperature over twoPhaseEulerFoam's", 1,
              beds.temperature(case, "0.2")/beds.RESULTS.TEMPERATURE[0.2], 0.25)
    if VERIFY:
        no = [(r"\n +collisions\s*\{[^}]*\}", "")]
        for name, (case, run) in (
                ("ours", (case, found)), ("ours, no collisions", beds.ours("bed-no", 1, end, no)),
                ("ours, 3.75 mm", beds.ours("bed-2", 2, end)),
                ("twoPhaseEulerFoam", beds.twoPhase("two", 1, end)),
                ("twoPhaseEulerFoam, 3.75 mm", beds.twoPhase("two-2", 2, end))):
            print(f"bed, {name}: diameter, lowest and highest place at",
                  *(f"{t} s {d:.4f} {low:.4f} {high:.4f} m;" for t, (d, low, high) in run.items()
                    if t in reference))
            if "no collisions" not in name:
                print(f"bed, {name}: median granular temperature at", *(
                    f"{t} s {beds.temperature(case, t):.2e} m2/s2;" for t in case.times()[1:]
                    if float(t) in reference))


def main():
    return runParts("grains", bagnold, column, again, bubble, fluctuations, immersed)


if __name__ == "__main__":
    sys.exit(main())
