"""Cases of several fluids alone, in a box.

    case = fluidCase("fluidsAlone", "tube", (200, 1, 1), (1, 0.1, 0.1),
                     {"water": WATER, "air": AIR}, initial, endTime)
    initial(x, y, z) -> (alphas, rhos, u, p): lists in the order of the fluids, arrays
    of the cells or numbers; u: n x 3 or n along x

WATER, AIR: entries of the phases. AIR has R = 1 J/kg/K, so that T = p/rho.
"""

import os

import numpy as np

from cellMesh import boxOfCells
from coupledCases import addPoints
from foamCase import FoamCase, boxMesh, controlDict, readInternal
from gasCases import OPEN, VAN_LEER, WALL, boxCentres, schemes, volField, writeVolField

WATER = {"rho": 1000, "equationOfState": {"type": "stiffenedGas", "gamma": 4.4, "pInf": 6e8,
                                          "p0": 1e5}}
AIR = {"thermo": "perfectGas", "R": 1, "gamma": 1.4}


def fluidCase(folder, name, cells, high, fluids, initial, endTime, low=(0, 0, 0), ends=OPEN,
              sides=None, reconstruct=VAN_LEER, maxCoGas=0.4, writeInterval=None, control=None,
              patches=None, gravity=None, settings=None, kind=None, moved=0.2,
              given=None):
    """ends, sides: conditions of p, T (and rho, alpha), U, as of gasCases.gasCase; kind: cells
    of cellMesh.boxOfCells in place of boxes; given: {patch: {field: condition}} beside these."""
    case = FoamCase(folder, name)
    nDim = sum(n > 1 for n in cells)
    if patches is None:
        patches = {"ends": ("patch", ("x-", "x+"))}
        if nDim > 1:
            patches["sides"] = ("patch", ("y-", "y+") if nDim == 2
                                else ("y-", "y+", "z-", "z+"))
    patches = dict(patches)
    empty = [s for d, s in enumerate(("x", "y", "z")) if d >= nDim for s in (s + "-", s + "+")]
    if empty:
        patches["frontAndBack"] = ("empty", empty)
    case.write("system/fvSchemes", schemes(reconstruct))
    case.write("system/fvSolution", {})
    entries = controlDict(endTime, writeInterval or endTime, maxCo=maxCoGas,
                          writeFormat="binary")
    entries["application"] = "materialPointFoam"
    entries["deltaT"] = endTime*1e-6
    entries["maxCoGas"] = entries.pop("maxCo")
    entries.update(control or {})
    case.write("system/controlDict", entries)
    if kind:
        boxOfCells(case, kind, low, high, cells, patches, moved=moved)
        os.makedirs(case.file("0"), exist_ok=True)
        case.run("postProcess", "-func", "writeCellCentres", "-time", "0")
        x, y, z = readInternal(case.file("0", "C")).T
        for f in ("C", "Cx", "Cy", "Cz"):
            os.remove(case.file("0", f))
    else:
        case.write("system/blockMeshDict", boxMesh(low, high, cells, patches))
        case.run("blockMesh")
        x, y, z = boxCentres(low, high, cells)
    sorts = {"ends": ends, "sides": sides or WALL, "frontAndBack": ("empty",)*3}

    def conditionsOf(i, field):
        return {n: (given or {}).get(n, {}).get(field, sorts[n][i] if n in sorts else t)
                for n, (t, *_) in patches.items()}

    alphas, rhos, u, p = initial(x, y, z)
    one = np.ones_like(x)
    u = np.asarray(u, float)*(one if np.ndim(u) < 2 else 1)
    if u.ndim == 1:
        u = np.column_stack([u, 0*u, 0*u])
    p = p*one
    writeVolField(case, "p", p, conditionsOf(0, "p"))
    writeVolField(case, "U", u, conditionsOf(2, "U"))
    for (fluid, values), alpha, rho in zip(fluids.items(), alphas, rhos):
        share = "alpha." + fluid
        writeVolField(case, share, alpha*one, conditionsOf(1, share))
        if values.get("thermo") == "perfectGas":
            name, state = "T." + fluid, p/(rho*one)/values["R"]
        else:
            name, state = "rho." + fluid, rho*one
        writeVolField(case, name, state, conditionsOf(1, name))
    properties = {"phases": list(fluids)}
    for fluid, values in fluids.items():
        properties[fluid] = {"type": "fluid", **values}
    if settings:
        properties["fluids"] = settings
    case.write("constant/phaseProperties", properties)
    if gravity is not None:
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": tuple(gravity)},
                   "uniformDimensionedVectorField")
    return case


def besidePoints(case, fluids, phases, regions, settings=None, **options):
    """Points in a case of fluidCase(); options of coupledCases.addPoints()."""
    addPoints(case, {**{n: {"type": "fluid", **e} for n, e in fluids.items()},
                     "fluids": settings or {}}, phases, regions, **options)


def shareFile(case, name, values):
    """0/<name>, a share in each cell, with the conditions of 0/p."""
    with open(case.file("0/p")) as f:
        head, rest = f.read().split("(", 1)
    rows = "\n".join(f"{v:g}" for v in values)
    text = head + "(\n" + rows + "\n)" + rest[rest.index(")") + 1:]
    with open(case.file("0", name), "w") as f:
        f.write(text.replace("[1 -1 -2 0 0 0 0]", "[0 0 0 0 0 0 0]").replace(
            "object p;", f"object {name};"))


def fluidField(case, end, name):
    return volField(case, case.timeName(end), name)
