"""A block of points in a gas, at rest or moving with it, on a box of cells.

    case = blockInGas("group", "name", nDim=2, n=30, region={...}, velocity=(80, 60, 0),
                      steps=500)

Air of 1e5 Pa and 1.2 kg/m3; linear elastic points (nu 0) that start with the
pressure of the air; sides cyclic or walls with slip; the time step is fixed by the
Courant number of the points; prepare(case) may add files. figures(case) reads Theta,
fix-ups, masses, momenta and energies of every report from the log, and of every step
the least and largest pressure and the largest speed of the gas.
"""

import re

import numpy as np

from foamCase import FoamCase, boxMesh, controlDict, foamText, velocityFile

P0, RHO_GAS, R = 1e5, 1.2, 287.0
T0 = P0/(RHO_GAS*R)


def gasField(case, name, kind, dimensions, value, conditions):
    case.write("0/" + name, {"dimensions": dimensions, "internalField": value,
                             "boundaryField": {k: {"type": v} for k, v in conditions.items()}},
               kind)


def gasSchemes(case, scheme="upwind"):
    case.write("system/fvSchemes", {
        "ddtSchemes": {"default": "Euler"}, "gradSchemes": {"default": "Gauss linear"},
        "divSchemes": {"default": "none"},
        "laplacianSchemes": {"default": "Gauss linear corrected"},
        "interpolationSchemes": {"default": "linear", "reconstruct(rho)": scheme,
                                 "reconstruct(U)": scheme, "reconstruct(p)": scheme},
        "snGradSchemes": {"default": "corrected"}})


#: Extremes of pressure and speed in every step, for figures()
EXTREMES = {
    name: {"type": "fieldMinMax", "libs": "(fieldFunctionObjects)", "fields": [field],
           "location": False, "log": False, "writeControl": "timeStep",
           "writeInterval": 1}
    for name, field in (("pressure", "p"), ("speed", "U.air"))}


def gasFields(case, conditions, velocity=(0, 0, 0), pressure=None):
    """p, T.air and U.air; conditions: of the velocity, slip, cyclic or empty."""
    scalar = {k: "zeroGradient" if v == "slip" else v for k, v in conditions.items()}
    p = (f"uniform {P0}" if pressure is None else
         f"nonuniform List<scalar> {len(pressure)} {foamText(pressure)}")
    gasField(case, "p", "volScalarField", "[1 -1 -2 0 0 0 0]", p, scalar)
    gasField(case, "T.air", "volScalarField", "[0 0 0 1 0 0 0]", f"uniform {T0!r}", scalar)
    gasField(case, "U.air", "volVectorField", "[0 1 -1 0 0 0 0]",
             "uniform " + foamText(velocity), conditions)


def blockInGas(group, name, nDim, n, region, velocity=(0, 0, 0), steps=500, h=1e-4,
               E=70e9, rho=2700.0, Co=0.4, pointsPerCell=2, numerics=None, drag=None,
               walls=False, gasVelocity=None, pressure=None, gas=None, reports=20,
               prepare=None):
    case = FoamCase(group, name)
    case.write("constant/phaseProperties", {
        "phases": ["air", "block"],
        "air": {"type": "gas", "thermo": "perfectGas", "R": R, "gamma": 1.4, **(gas or {})},
        "block": {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E, "nu": 0},
                  **({"drag": drag} if drag else {})}})
    sides = [s for d in range(3) for s in ("xyz"[d] + "-", "xyz"[d] + "+")]
    patches, conditions = {}, {}
    for d in range(nDim):
        low, high = "xyz"[d] + "Low", "xyz"[d] + "High"
        for own, other, side in ((low, high, sides[2*d]), (high, low, sides[2*d + 1])):
            patches[own] = ("wall" if walls else f"cyclic; neighbourPatch {other}", (side,))
            conditions[own] = "slip" if walls else "cyclic"
    if nDim < 3:
        patches["sides"] = ("empty", sides[2*nDim:])
        conditions["sides"] = "empty"
    cells = [n if d < nDim else 1 for d in range(3)]
    case.write("system/blockMeshDict",
               boxMesh((0, 0, 0), [h*c for c in cells], cells, patches))
    velocityFile(case, "block", conditions)
    v = np.where(np.arange(3) < nDim, velocity, 0.0)
    gasFields(case, conditions, v if gasVelocity is None else gasVelocity, pressure)
    gasSchemes(case)
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", **region, "pointsPerCell": pointsPerCell, "velocity": v,
        "stress": "ambient", "pressure": P0}}})
    case.write("system/fvSolution", {"materialPoints": numerics or {
        "shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}})
    dt = Co*h/(np.sqrt(E/rho) + np.max(abs(v)))
    case.write("system/controlDict", {
        **controlDict(steps*dt, steps*dt, deltaT=dt, functions=EXTREMES),
        "reportInterval": max(1, steps//reports)})
    if prepare:
        prepare(case)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def figures(case):
    log = case.log()

    def numbers(pattern):
        return np.array([[float(x) for x in m] if isinstance(m, tuple) else float(m)
                         for m in re.findall(pattern, log, re.M)])

    def vectors(pattern):
        return np.array([[float(x) for x in m.split()] for m in re.findall(pattern, log, re.M)])

    number = r"([-\d.e+]+)"
    return {
        "p": case.series("pressure", "fieldMinMax.dat")[:, 1:],
        "speed": case.series("speed", "fieldMinMax.dat")[:, 2],
        "Theta": numbers(rf"^Theta: min {number}, max {number}"),
        "fixups": numbers(r"limited (\d+), theta kept (\d+), isentropic (\d+)"),
        "gasMass": numbers(rf"^Gas air: mass {number}"),
        "gasMomentum": vectors(r"^Gas air: mass .*momentum \(([^)]*)\)"),
        "gasEnergy": numbers(rf"^Gas air: .*energy {number}$"),
        "momentum": vectors(r"^Material points: .*momentum \(([^)]*)\)"),
        "energy": numbers(rf"^Energy: kinetic .* total {number}")}
