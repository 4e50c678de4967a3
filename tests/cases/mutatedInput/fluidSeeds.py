"""Cases of several fluids whose input is changed: all words that fluids know.

    charge    TNT that is lit at a point, on a line and in a plane, water and air in a closed
              and an open box, a plate of points that may erode and takes heat; gravity,
              viscosity, nuclei, gauges and a balance
    rate      a charge that burns by its pressure beside a liquid of Cochran and Chan's
              equation, gas of van der Waals' and softened water
    viscous   one gas with viscosity and conduction

Each is made by the tools: blockMesh, setFluids (not viscous), setMaterialPoints (charge).
harmless(): reasons for changes without a bad effect, as those of test.py.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from detonations import QM100, QM100_RATE, TNT
from foamCase import FoamCase, boxMesh, controlDict, velocityFile
from gasCases import DIMENSIONS, VAN_LEER, schemes

FAR = {"type": "farField", "farValue": "uniform 1e5"}
FAR_U = {"type": "farField", "farValue": "uniform (0 0 0)"}

#: Name: end of the first run, of the run after the restart
ENDS = {"charge": ("4e-6", "8e-6"), "rate": ("2e-6", "4e-6"), "viscous": ("1e-4", "2e-4")}

CHARGE = {
    "phases": ["tnt", "water", "air", "plate"],
    "tnt": {"type": "fluid", **TNT, "mu": 0, "kappa": 0, "Cv": 1000, "detonation": {
        "type": "programmedBurn", "velocity": 6930, "points": [(0.03, 0.09, 0.005)],
        "lines": [[(0.02, 0.08, 0), (0.02, 0.1, 0)]],
        "planes": [[(0.01, 0.09, 0), (1, 0, 0)]], "times": [0, 1e-6, 2e-6], "width": 2,
        "radius": 0.1, "K": 1e10, "n": 7}},
    "water": {"type": "fluid", "rho": 1000, "Cv": 3610, "mu": 1e-3, "kappa": 0.6,
              "equationOfState": {"type": "nobleAbelStiffenedGas", "gamma": 1.19,
                                  "pInf": 7.028e8, "b": 6.61e-4, "q": -1177788, "p0": 1e5}},
    "air": {"type": "fluid", "thermo": "perfectGas", "R": 287, "gamma": 1.4, "nuclei": 1e-6,
            "mu": 1.8e-5, "kappa": 0.026},
    "fluids": {"viscous": True, "lowMach": False, "drainage": 0.1, "mu": 1e-3, "Pr": 0.7,
               "poreFloor": 0.01, "faceDrag": "impedance", "solidFraction": "lattice"},
    "plate": {"velocityField": "solids", "Cv": 900,
              "heatTransfer": {"type": "constant", "value": 1e5},
              "erosion": {"type": "plasticStrain", "limit": 0.3},
              "constitutiveModel": {"type": "J2Plasticity", "rho": 2700, "E": 7e10, "nu": 0.3,
                                    "yield": 3e8, "hardening": "none"}}}

RATE = {
    "phases": ["charge", "liquid", "gas", "water"],
    "charge": {"type": "fluid", **QM100, "detonation": {**QM100_RATE, "booster": {
        "points": [(0, 0, 0)], "velocity": 5000, "time": 1e-7, "width": 2, "radius": 0.01}}},
    "liquid": {"type": "fluid", "rho": 1134, "equationOfState": {
        "type": "CochranChan", "A": 8.192e8, "B": 1.508e9, "E1": 4.53, "E2": 1.42,
        "Gamma0": 1.19, "p0": 1e5}},
    "gas": {"type": "fluid", "rho": 50, "equationOfState": {
        "type": "vanDerWaals", "gamma": 1.4, "a": 5, "b": 1e-3, "p0": 1e5}},
    "water": {"type": "fluid", "rho": 1000, "equationOfState": {
        "type": "stiffenedGas", "gamma": 4.4, "soundSpeed": 800, "p0": 1e5}},
    "fluids": {"lowMach": True}}


def _fields(case, names, patches):
    """0/: air at rest, all of it; patches: name: conditions of p, the rest, U."""
    for name in names:
        i = {"p": 0, "U": 2}.get(name.split(".")[0], 1)
        value = {"p": "1e5", "U": "(0 0 0)", "T": "300", "a": "1" if "air" in name else "0",
                 "r": "1000"}[name[0]]
        case.write("0/" + name, {
            "dimensions": DIMENSIONS[name[0]], "internalField": "uniform " + value,
            "boundaryField": {n: c[i] if isinstance(c[i], dict) else {"type": c[i]}
                              for n, c in patches.items()}},
            "volVectorField" if name[0] == "U" else "volScalarField")


def _case(name, folder, cells, high, patches, control):
    case = FoamCase("mutatedInput", os.path.join(folder, name))
    case.write("system/blockMeshDict", boxMesh((0, 0, 0), high, cells, patches))
    case.write("system/fvSchemes", schemes(VAN_LEER))
    end = float(ENDS[name][0])
    case.write("system/controlDict", {
        **controlDict(end, end, deltaT=1e-9), "startFrom": "latestTime", "endTime": ENDS[name][0],
        "writeInterval": ENDS[name][0], "adjustTimeStep": True,
        "writeControl": "adjustableRunTime", "maxCoGas": 0.4, "reportInterval": 1, **control})
    case.write("system/fvSolution", {})
    return case


WALLS = ("zeroGradient", "zeroGradient", "slip")
EMPTY = ("empty",)*3
OUT = (FAR, "zeroGradient", FAR_U)


def charge(folder):
    case = _case("charge", folder, (24, 18, 1), (0.24, 0.18, 0.01), {
        "walls": ("wall", ("x-", "y-", "y+")), "outside": ("patch", ("x+",)),
        "frontAndBack": ("empty", ("z-", "z+"))}, {"maxCo": 0.3, "functions": {
            "gauges": {"type": "blastProbes", "libs": "(mpmFunctionObjects)",
                       "probeLocations": [(0.1, 0.09, 0.005)], "patches": ["walls"],
                       "field": "p", "ambient": 1e5, "threshold": 1000,
                       "writeControl": "timeStep", "writeInterval": 1},
            "balance": {"type": "fluidBalance", "libs": "(mpmFunctionObjects)",
                        "writeControl": "timeStep", "writeInterval": 1}}})
    case.write("constant/phaseProperties", CHARGE)
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, -9.81, 0)},
               "uniformDimensionedVectorField")
    _fields(case, ("p", "U", "T.air", "alpha.air", "alpha.tnt", "alpha.water", "rho.tnt",
                   "rho.water"), {"walls": WALLS, "outside": OUT, "frontAndBack": EMPTY})
    velocityFile(case, "solids", {"walls": "slip", "outside": "slip", "frontAndBack": "empty"})
    case.write("system/setFluidsDict", {
        "default": {"fluid": "air", "T": 300},
        "hydrostatic": {"point": (0.12, 0.17, 0.005), "p": 1e5},
        "regions": {
            "lake": {"type": "box", "min": (-1, -1, -1), "max": (1, 0.115, 1),
                     "fluid": "water", "rho": 1000},
            "charge": {"type": "cylinder", "point1": (0.03, 0.09, -1),
                       "point2": (0.03, 0.09, 1), "radius": 0.025, "fluid": "tnt",
                       "mass": 0.03, "U": (0, 0, 0)}}})
    case.write("system/setMaterialPointsDict", {"regions": {"plate": {
        "phase": "plate", "type": "box", "min": (0.06, 0.05, -1), "max": (0.08, 0.13, 1),
        "pointsPerCell": 2, "stress": "ambient", "pressure": 1e5, "temperature": 300}}})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}})
    return case


def rate(folder):
    case = _case("rate", folder, (60, 1, 1), (0.06, 0.001, 0.001), {
        "wall": ("wall", ("x-",)), "outside": ("patch", ("x+",)),
        "sides": ("empty", ("y-", "y+", "z-", "z+"))}, {})
    case.write("constant/phaseProperties", RATE)
    case.write("system/setFluidsDict", {
        "default": {"fluid": "water", "p": 1e5},
        "regions": {
            "charge": {"type": "box", "min": (-1, -1, -1), "max": (0.0305, 1, 1),
                       "fluid": "charge"},
            "liquid": {"type": "box", "min": (0.0305, -1, -1), "max": (0.04, 1, 1),
                       "fluid": "liquid"},
            "gas": {"type": "box", "min": (0.04, -1, -1), "max": (0.05, 1, 1),
                    "fluid": "gas", "rho": 50}}})
    return case


def viscous(folder):
    case = _case("viscous", folder, (20, 10, 1), (0.2, 0.1, 0.01), {
        "walls": ("wall", ("y-", "y+", "x-")), "outside": ("patch", ("x+",)),
        "frontAndBack": ("empty", ("z-", "z+"))}, {})
    case.write("constant/phaseProperties", {"phases": ["air"], "air": {
        "type": "gas", "thermo": "perfectGas", "R": 287, "gamma": 1.4, "viscous": True,
        "mu": 1.8e-3, "kappa": 2.6}})
    still = {"type": "fixedValue", "value": "uniform (5 0 0)"}
    warm = {"type": "fixedValue", "value": "uniform 350"}
    _fields(case, ("p", "U.air", "T.air"), {
        "walls": ("zeroGradient", warm, still), "outside": OUT, "frontAndBack": EMPTY})
    return case


#: Name: what makes it, tools before the solver
SEEDS = {"charge": (charge, ("blockMesh", "setFluids", "setMaterialPoints")),
         "rate": (rate, ("blockMesh", "setFluids")),
         "viscous": (viscous, ("blockMesh",))}

LATER = r"[\d.]+e-06|0\.0001"
STATE = rf"({LATER})/(theta\w*|alpha|F)(\.\w+)?"
PHASES = "constant/phaseProperties"
LEGAL = "negative|tiny|huge|zero"


#: Files that our tools do not read
UNREAD = r".*/lagrangian/\w+/(coordinates|positions|p|pPoint|sigmaEq|origId|origProcId)" \
    r"|[\d.e-]+/((alpha|Umean|sigma|Tmean)\.plate|Theta|phi|rho(\.air)?)" \
    r"|.*/uniform/(lagrangian|functionObjects)/.*"


def harmless(same, close):
    """The reasons; same, close: test.py's SAME, CLOSE. The first that matches counts."""
    return [
        (UNREAD, ".*", ".*", "our tools do not read the file", same),
        (r".*/uniform/phaseProperties", ".*", ".*", "only a warning of what has changed since",
         same),

        # Output, whose values the state gives anew
        (rf"({LATER})/(p|U|rho|T)(\.\w+)?", "cell .*", ".*",
         "a restart has the values of cells from thetaRho and the like", same),
        (rf"({LATER})/(rho|T)\.\w+", "", ".*", "the same", same),
        (rf"({LATER})/U\.solids", "cell .*", ".*", "velocities of nodes come from points", same),
        (rf"({LATER})/theta(\.air)?", r"boundaryField.*", ".*",
         "faces of the boundary have the porosity of their cells", same),
        (rf"({LATER})/theta.*", "internalField", "header", "no such word in the file", same),
        (STATE, "cell .*", ".*", "the number that was there, or one within 1e-5 of the pressure",
         same),
        (STATE, "cell .*", "two|tiny|zero|negative|huge",
         "a finite number that leaves the pressure within 1e-5 of rho c^2"),
        (STATE, "", "binary rubbish at .*", "finite numbers in a binary column, as those of points"),
        (rf"({LATER})/uniform/materialPointState", r"(gas|points).*|complete",
         LEGAL + ".*|misspelt|deleted|unknown keyword", "sums of reports only", same),
        (".*/uniform/materialPointMesh", "", "file deleted|folder for file",
         "no mesh to compare with", same),
        ("0/uniform/.*", ".*", ".*", "of setMaterialPoints: nothing to compare with", same),

        # Fields of the start
        (r"0/alpha\.\w+", "", "file deleted", "one fluid may be without: it has the rest",
         close),
        (r"0/rho\.\w+", "", "file deleted", "default: rho of the phase (doc/entries.md)"),
        (r"0/(p|U|T\.\w+|rho\.\w+|U\.\w+|alpha\.\w+)", "boundaryField.*", ".*",
         "OpenFOAM: words that it does not know, and empty patches by their type", same),
        (r"0/U(\.air)?", "internalField", "negative in list|huge in list", "a legal velocity"),
        (r"0/\w+(\.\w+)?", "internalField", "number for word|misspelt value",
         "OpenFOAM reads the number alone, with a warning", "deprecated"),
        (r"0/(p|U|alpha\.\w+|T\.\w+|rho\.\w+)", "internalField", "misspelt value",
         "setFluids writes the values anew", same),
        ("system/controlDict", "reportInterval", "deleted", "default: every tenth step", same),
        (r"0/(rho|T)\.\w+", "cell .*", ".*", "no such fluid in the cell", same),
        (r"0/(p|U(\.\w+)?|rho\.\w+|T\.\w+)", "cell .*|internalField.*",
         LEGAL + "|two|negative in list", "a legal state"),
        (r"0/[\w.]+", r"boundaryField\..*(value|farValue)", LEGAL + "|negative in list|huge in list",
         "a legal value at the boundary"),

        # Entries with defaults, of the headers
        (PHASES, r"fluids(\.(viscous|lowMach|drainage|mu|Pr|poreFloor|faceDrag|solidFraction))?",
         "deleted|empty dictionary", "defaults of doc/entries.md"),
        (PHASES, r"\w+\.(nuclei|kappa|Cv|erosion|heatTransfer|detonation)", "deleted",
         "optional: doc/entries.md"),
        (PHASES, r"\w+\.detonation\.(booster\.)?(points|lines|planes|times?|width|radius|K|n)"
         r"|\w+\.detonation\.(threshold|booster)", "deleted|empty list", "optional: doc/entries.md"),
        (PHASES, r"\w+\.detonation\.(booster\.)?(points|lines|planes)", "negative in list",
         "a place beside the charge of a line or plane that still touches it"),
        (PHASES, r"fluids\.lowMach", "misspelt value", "no becomes on"),
        (PHASES, r"fluids\.\w+", "number for word", "OpenFOAM takes a number for a switch"),
        (PHASES, r"\w+\.detonation\.(booster\.)?(times?|velocity|radius|width|K|n|G|b|threshold)",
         LEGAL + "|negative in list|huge in list", "a legal time, speed, length or rate"),
        (PHASES, r"\w+\.(equationOfState|erosion|heatTransfer)\.\w+|\w+\.(rho|R|gamma|Cv|mu|kappa"
         r"|nuclei)|fluids\.\w+", LEGAL, "a legal value of the law"),
        (PHASES, r"\w+\.viscous", "number for word", "OpenFOAM takes a number for a switch"),
        ("constant/g", ".*", ".*", "legal gravity, or none"),

        # Tools
        ("system/setFluidsDict", r"regions\.\w+\.(min|max|point1|point2|radius|U|mass|rho|p)"
         r"|hydrostatic\.(p|point)|default\.\w+", LEGAL + "|negative in list|huge in list",
         "a legal place, state or velocity"),
        ("system/setFluidsDict", r"regions\.\w+\.(rho|U|p|mass)", "deleted",
         "optional: rho of the phase, at rest, p of the default"),
        ("system/setFluidsDict", r"regions(\.\w+)?", "deleted|misspelt|empty dictionary",
         "fewer regions, or the same of a free name"),
        ("system/setMaterialPointsDict", r"regions\.\w+\.(pressure|temperature)", LEGAL,
         "a legal pressure or temperature"),
        ("system/controlDict", r"functions\.\w+\.(patches|probeLocations|field|ambient|threshold).*",
         ".*", "another choice of places to look at, the same run", same),
        ("system/controlDict", "maxCoGas", "deleted", "the default is that of the case", same),
        ("system/fvSchemes", "", ".*", "cut between entries that nobody reads", same),
        ("system/fvSchemes", r"(?!interpolationSchemes).*", ".*", "not read", same),
    ]
