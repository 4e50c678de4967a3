"""tutorials/fluidisedBed, and the same by twoPhaseEulerFoam: its kinetic theory with the equation
of the granular temperature, schemes and tolerances of its own tutorial fluidisedBed."""

import importlib.util
import os
import shutil

import numpy as np

from foamCase import PROJECT, VERIFY, FoamCase, boxMesh, controlDict, foamText
from gasCases import boxCentres

spec = importlib.util.spec_from_file_location(
    "results", os.path.join(PROJECT, "tutorials/fluidisedBed/results.py"))
RESULTS = importlib.util.module_from_spec(spec)
spec.loader.exec_module(RESULTS)

G, P0, RHOG, MU = 9.81, 1e5, 1.2, 1.8e-5
RHOS, D, PACKING, ALPHAMAX, E = 2660, 500e-6, 0.6, 0.63, 0.9
#: Half width and height of the box, height of the bed, half of the orifice, its velocity
W, H, BED, ORIFICE, JET = 0.15, 0.54, 0.3, 7.5e-3, 10
T0 = P0/(287*RHOG)


def lowest():
    """Superficial velocity of minimum fluidisation, Ergun [m/s]."""
    e = 1 - PACKING
    a, b = 1.75*RHOG/(D*e**3), 150*MU*PACKING/(D*D*e**3)
    return (np.sqrt(b*b + 4*a*(RHOS - RHOG)*G) - b)/(2*a)


def mesh(case, h):
    nx, ny = (int(round(a/h)) for a in (W, H))
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (nx*h, ny*h, h), (nx, ny, 1),
        {"axis": ("symmetryPlane", ("x-",)), "side": ("wall", ("x+",)),
         "bottom": ("patch", ("y-",)), "top": ("patch", ("y+",)),
         "frontAndBack": ("empty", ("z-", "z+"))}))
    return nx, ny


def start(nx, ny, h):
    """x of the cells, share of the grains, pressure, inflow of the lowest cells."""
    x, y, _ = boxCentres((0, 0, 0), (nx*h, ny*h, h), (nx, ny, 1))
    p = P0 + G*(RHOS*PACKING + RHOG*(1 - PACKING))*np.maximum(BED - y, 0)
    return x, np.where(y < BED, PACKING, 0.0), p, np.where(x[:nx] < ORIFICE, JET, lowest())


def inflow(u):
    rows = " ".join(f"(0 {v!r} 0)" for v in map(float, u))
    return f"nonuniform List<vector> {len(u)} ({rows})"


def ours(name, n, end, law=None):
    """The tutorial on n times as many cells in each direction; law: changes of its law, pairs of
    expression and text. Diameter, lowest and highest place of the bubble at each time."""
    case = FoamCase("grains", name, os.path.join(PROJECT, "tutorials/fluidisedBed"))
    for time in case.times():
        shutil.rmtree(case.file(time))
    shutil.copytree(case.file("0.orig"), case.file("0"))
    for across in (1, 19):
        case.change("system/blockMeshDict", rf"\({across} 72 1\)", f"({across*n} {72*n} 1)")
    case.change("system/controlDict", r"^endTime .*?;", f"endTime {end};")
    for change in law or ():
        case.change("constant/phaseProperties", *change)
    case.run("blockMesh")
    for command in ("setExprFields", "setMaterialPoints", "materialPointFoam"):
        case.run(command, limit=1800 if VERIFY else 300)
    return case, {float(t): RESULTS.bubble(RESULTS.beads(case, t, n), RESULTS.H/n)
                  for t in case.times()[1:]}


def field(name, dimensions, internal, patches, kind="scalar"):
    return name, {"dimensions": dimensions, "internalField": internal, "boundaryField": {
        **{q: {"type": c} if isinstance(c, str) else c for q, c in patches.items()}}}, \
        f"vol{kind.capitalize()}Field"


def twoPhase(name, n, end):
    """As ours, by twoPhaseEulerFoam."""
    h = RESULTS.H/n
    case = FoamCase("grains", name)
    nx, ny = mesh(case, h)
    x, share, p, u = start(nx, ny, h)
    case.write("constant/phaseProperties", {
        "phases": ["particles", "air"],
        "particles": {"diameterModel": "constant", "constantCoeffs": {"d": D},
                      "alphaMax": ALPHAMAX, "residualAlpha": 1e-6},
        "air": {"diameterModel": "constant", "constantCoeffs": {"d": 1}, "residualAlpha": 0},
        "blending": {"default": {"type": "none", "continuousPhase": "air"}},
        "sigma": "((particles and air) 0)", "aspectRatio": "()",
        "drag": "((particles in air) { type GidaspowErgunWenYu; residualRe 1e-3;"
                " swarmCorrection { type none; } })",
        "virtualMass": "()", "lift": "()", "wallLubrication": "()",
        "turbulentDispersion": "()",
        "heatTransfer": "((particles in air) { type RanzMarshall; residualAlpha 1e-3; })",
        "pMin": 1e4})
    case.write("constant/turbulenceProperties.air", {"simulationType": "laminar"})
    case.write("constant/turbulenceProperties.particles", {
        "simulationType": "RAS", "RAS": {
            "RASModel": "kineticTheory", "turbulence": "on", "printCoeffs": "on",
            "kineticTheoryCoeffs": {
                "equilibrium": "off", "e": E, "alphaMax": ALPHAMAX, "alphaMinFriction": PACKING,
                "residualAlpha": 1e-4, "viscosityModel": "Gidaspow",
                "conductivityModel": "Gidaspow", "granularPressureModel": "Lun",
                "frictionalStressModel": "JohnsonJackson", "radialModel": "SinclairJackson",
                "JohnsonJacksonCoeffs": {"Fr": 0.05, "eta": 2, "p": 5, "phi": 28.5,
                                         "alphaDeltaMin": 0.01}}}})
    thermo = {"type": "heRhoThermo", "mixture": "pureMixture", "transport": "const",
              "thermo": "hConst", "specie": "specie", "energy": "sensibleInternalEnergy"}
    for phase, weight, equation, cp, mu in (("air", 8314.5/287, "perfectGas", 1004.5, MU),
                                            ("particles", 100, "rhoConst", 800, 0)):
        case.write("constant/thermophysicalProperties." + phase, {
            "thermoType": {**thermo, "equationOfState": equation},
            "mixture": {"specie": {"molWeight": weight}, "equationOfState": {"rho": RHOS},
                        "thermodynamics": {"Cp": cp, "Hf": 0},
                        "transport": {"mu": mu, "Pr": 0.7}}})
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, -G, 0)},
               "uniformDimensionedVectorField")
    still = {"axis": "symmetryPlane", "frontAndBack": "empty", **{
        q: "zeroGradient" for q in ("side", "bottom", "top")}}

    def held(value):
        return {"type": "fixedValue", "value": "uniform " + foamText(value)}

    def values(a):
        return f"nonuniform List<scalar> {len(a)} ({' '.join(repr(float(v)) for v in a)})"
    flux = {"type": "fixedFluxPressure", "value": f"uniform {P0}"}
    any = {"type": "calculated", "value": f"uniform {P0}"}
    one, K, m2, velocity = "[0 0 0 0 0 0 0]", "[0 0 0 1 0 0 0]", "[0 2 -1 0 0 0 0]", \
        "[0 1 -1 0 0 0 0]"
    rows = " ".join(f"(0 {lowest()/(1 - a)!r} 0)" for a in share)
    none = {**still, **{q: {"type": "calculated", "value": "uniform 0"}
                        for q in ("side", "bottom", "top")}}
    for file, content, kind in (
            field("p", "[1 -1 -2 0 0 0 0]", values(p), {
                **still, "side": any, "bottom": any, "top": any}),
            field("p_rgh", "[1 -1 -2 0 0 0 0]", values(p), {
                **still, "side": flux, "bottom": flux, "top": {
                    "type": "prghPressure", "p": f"uniform {P0}", "value": f"uniform {P0}"}}),
            field("alpha.particles", one, values(share), still),
            field("Theta.particles", "[0 2 -2 0 0 0 0]", "uniform 1e-8", {
                **still, "bottom": held(1e-8)}),
            field("T.air", K, f"uniform {T0}", {**still, "bottom": held(T0), "top": {
                "type": "inletOutlet", "phi": "phi.air", "inletValue": f"uniform {T0}",
                "value": f"uniform {T0}"}}),
            field("T.particles", K, f"uniform {T0}", still),
            field("U.air", velocity, f"nonuniform List<vector> {len(x)} ({rows})", {
                **still, "side": "slip", "bottom": {
                    "type": "fixedValue", "value": inflow(u)}}, "vector"),
            field("U.particles", velocity, "uniform (0 0 0)", {
                **still, "side": "slip", "bottom": held((0, 0, 0)), "top": held((0, 0, 0))},
                "vector"),
            field("nut.particles", m2, "uniform 0", none),
            field("alphat.particles", "[1 -1 -1 0 0 0 0]", "uniform 0", none),
            field("nut.air", m2, "uniform 0", none),
            field("alphat.air", "[1 -1 -1 0 0 0 0]", "uniform 0", none)):
        case.write("0/" + file, content, kind)
    case.write("system/fvSchemes", SCHEMES)
    case.write("system/fvSolution", SOLUTION)
    case.write("system/controlDict", {
        **controlDict(end, 0.02, 0.3, 1e-5), "application": "twoPhaseEulerFoam",
        "maxDeltaT": 2e-4})
    case.run("blockMesh")
    case.run("twoPhaseEulerFoam", limit=1800)
    return case, {float(t): RESULTS.bubble(1 - case.field(t, "alpha.air").reshape(ny, nx), h)
                  for t in case.times()[1:]}


def median(values, weights):
    order = np.argsort(values)
    return values[order][np.searchsorted(np.cumsum(weights[order]), 0.5*weights.sum())]


def temperature(case, time):
    """Median over the beads of their granular temperature [m2/s2], of ours or twoPhaseEulerFoam."""
    if os.path.exists(case.file(time, "Theta.particles")):
        return median(case.field(time, "Theta.particles"), case.field(time, "alpha.particles"))
    bed = case.points(time, "beads")
    return median(bed["granularTemperature"], bed["m"])


#: Of the tutorial fluidisedBed
SCHEMES = {
    "ddtSchemes": {"default": "Euler"}, "gradSchemes": {"default": "Gauss linear"},
    "divSchemes": {
        "default": "none", '"div\\(phi,alpha.*\\)"': "Gauss vanLeer",
        '"div\\(phir,alpha.*\\)"': "Gauss vanLeer",
        '"div\\(alphaRhoPhi.*,U.*\\)"': "Gauss limitedLinearV 1",
        '"div\\(phi.*,U.*\\)"': "Gauss limitedLinearV 1",
        '"div\\(alphaRhoPhi.*,(h|e|K|Theta).*\\)"': "Gauss limitedLinear 1",
        '"div\\(alphaPhi.*,p\\)"': "Gauss limitedLinear 1",
        '"div\\(.*dev2.*\\)"': "Gauss linear"},
    "laplacianSchemes": {"default": "Gauss linear uncorrected",
                         "bounded": "Gauss linear uncorrected"},
    "interpolationSchemes": {"default": "linear"},
    "snGradSchemes": {"default": "uncorrected", "bounded": "uncorrected"}}
SMOOTH = {"solver": "smoothSolver", "smoother": "symGaussSeidel", "relTol": 0, "minIter": 1}
SOLUTION = {
    "solvers": {
        '"alpha.*"': {"nAlphaCorr": 1, "nAlphaSubCycles": 2, "smoothLimiter": 0.1,
                      "implicitPhasePressure": "yes", "tolerance": 1e-9, **SMOOTH},
        '"p_rgh.*"': {"solver": "GAMG", "smoother": "DIC", "tolerance": 1e-8, "relTol": 0},
        '"(U|e|h|Theta).*"': {"tolerance": 1e-6, **SMOOTH}},
    "PIMPLE": {"nOuterCorrectors": 3, "nCorrectors": 1, "nNonOrthogonalCorrectors": 0},
    "relaxationFactors": {"equations": {'".*"': 1}}}
