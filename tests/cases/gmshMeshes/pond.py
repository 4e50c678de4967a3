"""Water and air at rest over a bank of 40 degrees, on gmsh's triangles and quadrilaterals, lowMach:
they stay there."""

import os

import numpy as np
from foamCase import FoamCase, controlDict
from gasCases import schemes, volField

G, DEPTH, TOP, END, P0 = 9.81, 0.25, 0.7, 0.5, 1e3
SIDES = ("floor", "walls", "bank")


def pond(table, mesh):
    still(table, mesh, "pond", "")
    case = still(table, mesh, "pondOfQuads", "quadrilaterals, ")
    other = still(table, mesh, "pondOnTwo", "", 2)
    u, v = (volField(c, f"{END:g}", "U") for c in (case, other))
    table.row("pond of quadrilaterals, 2 processors: velocity, difference over that of free fall", 0,
              np.abs(u - v).max()/np.sqrt(2*G*DEPTH), 1e-5, "atMost")


def still(table, mesh, name, of, processors=1):
    case = FoamCase("gmshMeshes", name)
    with open(os.path.join(os.path.dirname(__file__), "pond.geo")) as f:
        geometry = f.read()
    if name != "pond":
        geometry = geometry.replace("out[] =", "Recombine Surface{1};\nout[] =")
    with open(case.file("pond.geo"), "w") as f:
        f.write(geometry)
    case.write("system/controlDict", controlDict(END, END, maxCo=0.3))
    case.set("system/controlDict", "maxCoGas", 0.6, add=True)
    case.write("system/fvSchemes", schemes({f"reconstruct({q})": "MLP" for q in ("rho", "U", "p")}))
    case.write("system/fvSolution", {})
    mesh(case, "pond", ("frontAndBack", "empty"))
    case.write("constant/phaseProperties", {
        "phases": ["water", "air"], "fluids": {"lowMach": True},
        "water": {"type": "fluid", "rho": 1000, "equationOfState": {
            "type": "stiffenedGas", "gamma": 1.12, "soundSpeed": 25, "p0": P0}},
        "air": {"type": "fluid", "thermo": "perfectGas", "R": 287, "gamma": 1.4}})
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, -G, 0)},
               "uniformDimensionedVectorField")
    case.write("system/setFluidsDict", {
        "default": {"fluid": "air", "T": 2.9},
        "hydrostatic": {"point": (1, TOP, 0), "p": P0},
        "regions": {"pond": {"type": "box", "min": (-1, -1, -1), "max": (3, DEPTH, 1),
                             "fluid": "water"}}})
    for name, kind, start, side in (
            ("U", "Vector", "(0 0 0)", "slip"),
            ("p", "Scalar", f"{P0:g}", "zeroGradient")):
        case.write("0/" + name, {
            "dimensions": "[0 1 -1 0 0 0 0]" if name == "U" else "[1 -1 -2 0 0 0 0]",
            "internalField": "uniform " + start, "boundaryField": {
                "frontAndBack": {"type": "empty"},
                "top": {"type": "farField", "value": "uniform " + start},
                **{s: {"type": side} for s in SIDES}}}, f"vol{kind}Field")
    case.run("setFluids")
    if processors > 1:
        case.decompose((processors, 1, 1))
        case.runParallel()
        return case
    case.run("materialPointFoam")
    u = np.linalg.norm(volField(case, f"{END:g}", "U"), axis=1)
    wet = volField(case, f"{END:g}", "alpha.water") > 0.5
    for name, there in (("water", wet), ("air", ~wet)):
        table.row(f"pond at rest, {of}lowMach, MLP: largest velocity of {name} over that of"
                  " free fall", 0, u[there].max()/np.sqrt(2*G*DEPTH), 2e-3, "atMost")
    return case
