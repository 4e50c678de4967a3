"""Cases of a gas alone, in a box; values of its fields.

    case = gasCase("gasAlone", "sod", cells=(200, 1, 1), high=(1, 0.1, 0.1),
                   initial=lambda x, y, z: (rho, u, p), endTime=0.2)
    case.run("materialPointFoam")
    rho = volField(case, case.timeName(0.2), "rho.air")

Gas air with gamma 1.4 and R = 1 J/kg/K, so that T = p/rho; or thermo, the entries
of the phase: with equationOfState the file is rho.air in place of T.air. initial
gives arrays (u: n x 3, or n along x).
"""

import os
import re

import numpy as np

from foamCase import FoamCase, boxMesh, controlDict, fileHeader, foamText

VAN_LEER = {"reconstruct(rho)": "vanLeer", "reconstruct(U)": "vanLeerV",
            "reconstruct(p)": "vanLeer"}
UPWIND = {"reconstruct(rho)": "upwind", "reconstruct(U)": "upwind",
          "reconstruct(p)": "upwind"}

#: Conditions of p, T, U on a patch
OPEN = ("zeroGradient", "zeroGradient", "zeroGradient")
WALL = ("zeroGradient", "zeroGradient", "slip")

DIMENSIONS = {"p": "[1 -1 -2 0 0 0 0]", "T": "[0 0 0 1 0 0 0]",
              "U": "[0 1 -1 0 0 0 0]", "r": "[1 -3 0 0 0 0 0]",
              "a": "[0 0 0 0 0 0 0]"}


def schemes(reconstruct, solver="materialPointFoam"):
    """fvSchemes of this solver and, for comparisons, of rhoCentralFoam."""
    reconstruct = dict(reconstruct)
    if solver == "rhoCentralFoam":
        reconstruct["reconstruct(T)"] = reconstruct.pop("reconstruct(p)")
    return {"fluxScheme": "Kurganov", "ddtSchemes": {"default": "Euler"},
            "gradSchemes": {"default": "Gauss linear"},
            "divSchemes": {"default": "none", "div(tauMC)": "Gauss linear"},
            "laplacianSchemes": {"default": "Gauss linear corrected"},
            "interpolationSchemes": {"default": "linear", **reconstruct},
            "snGradSchemes": {"default": "corrected"}}


def boxCentres(low, high, cells):
    """Cell centres of a box in the order of blockMesh."""
    axes = [l + (np.arange(n) + 0.5)*(h - l)/n for l, h, n in zip(low, high, cells)]
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    return x.ravel(), y.ravel(), z.ravel()


def writeVolField(case, name, values, patches):
    """0/<name>; patches: name: condition (type or dictionary)."""
    values = np.asarray(values, float)
    kind = "vector" if values.ndim > 1 else "scalar"
    rows = "\n".join(foamText(v if values.ndim > 1 else float(v)) for v in values)
    boundary = {n: c if isinstance(c, dict) else {"type": c} for n, c in patches.items()}
    os.makedirs(case.file("0"), exist_ok=True)
    with open(case.file("0", name), "w") as f:
        f.write(fileHeader(name, f"vol{kind.capitalize()}Field")
                + foamText({"dimensions": DIMENSIONS[name[0]],
                            "internalField": f"nonuniform List<{kind}>\n{len(values)}\n"
                                             f"(\n{rows}\n)",
                            "boundaryField": boundary}))


def uniformGas(case, p, T, patches):
    """p, T.air, U.air of air at rest; patches: name: conditions of p, T, U."""
    for i, (name, value) in enumerate((("p", p), ("T.air", T), ("U.air", (0, 0, 0)))):
        case.write("0/" + name,
                   {"dimensions": DIMENSIONS[name[0]],
                    "internalField": "uniform " + foamText(value),
                    "boundaryField": {n: {"type": c[i]} for n, c in patches.items()}},
                   "volVectorField" if name[0] == "U" else "volScalarField")


def gasCase(folder, name, cells, high, initial, endTime, low=(0, 0, 0), ends=OPEN,
            sides=None, reconstruct=VAN_LEER, maxCoGas=0.4, solver="materialPointFoam",
            thermo=None, writeInterval=None, writeFormat="binary", control=None,
            patches=None, conditions=None):
    """A box; ends: conditions of p, T, U at x- and x+, sides: at y- and y+ (and
    z-, z+ in 3D), where there is more than one cell; conditions: of other patches."""
    case = FoamCase(folder, name)
    nDim = sum(n > 1 for n in cells)
    empty = [s for d, s in enumerate(("x", "y", "z")) if d >= nDim for s in (s + "-", s + "+")]
    if patches is None:
        patches = {"ends": ("patch", ("x-", "x+"))}
        if nDim > 1:
            patches["sides"] = ("patch", ("y-", "y+") if nDim == 2
                                else ("y-", "y+", "z-", "z+"))
    patches = dict(patches)
    if empty:
        patches["frontAndBack"] = ("empty", empty)
    case.write("system/blockMeshDict", boxMesh(low, high, cells, patches))

    given = {"ends": ends, "sides": sides or WALL, "frontAndBack": ("empty",)*3,
             **(conditions or {})}
    def conditionsOf(i):
        return {n: given[n][i] if n in given else kind for n, (kind, *_) in patches.items()}

    x, y, z = boxCentres(low, high, cells)
    rho, u, p = (np.asarray(v, float) for v in initial(x, y, z))
    if u.ndim == 1:
        u = np.column_stack([u, 0*u, 0*u])
    own = solver == "materialPointFoam"
    suffix = ".air" if own else ""
    writeVolField(case, "p", p, conditionsOf(0))
    if thermo and "equationOfState" in thermo:
        writeVolField(case, "rho" + suffix, rho, conditionsOf(1))
    elif not thermo or thermo["thermo"] != "isentropic":
        writeVolField(case, "T" + suffix, p/rho, conditionsOf(1))
    writeVolField(case, "U" + suffix, u, conditionsOf(2))

    case.write("system/fvSchemes", schemes(reconstruct, solver))
    case.write("system/fvSolution", {} if own else {
        "solvers": {'"(rho|rhoU|rhoE)"': {"solver": "diagonal"},
                    "U": {"solver": "smoothSolver", "smoother": "GaussSeidel",
                          "tolerance": 1e-9, "relTol": 0.01},
                    "e": {"solver": "smoothSolver", "smoother": "GaussSeidel",
                          "tolerance": 1e-9, "relTol": 0.01}}})
    entries = controlDict(endTime, writeInterval or endTime, maxCo=maxCoGas,
                          writeFormat=writeFormat)
    entries["application"] = solver
    entries["deltaT"] = endTime*1e-5
    if own:
        entries["maxCoGas"] = entries.pop("maxCo")
        case.write("constant/phaseProperties", {"phases": ["air"], "air": {
            "type": "gas", **(thermo or {"thermo": "perfectGas", "R": 1, "gamma": 1.4})}})
    else:
        entries["maxDeltaT"] = endTime
        # R = 1: molWeight is the universal constant; Cp = 3.5
        case.write("constant/thermophysicalProperties", {
            "thermoType": {"type": "hePsiThermo", "mixture": "pureMixture",
                           "transport": "const", "thermo": "hConst",
                           "equationOfState": "perfectGas", "specie": "specie",
                           "energy": "sensibleInternalEnergy"},
            "mixture": {"specie": {"nMoles": 1, "molWeight": 8314.46261815324},
                        "thermodynamics": {"Cp": 3.5, "Hf": 0},
                        "transport": {"mu": 0, "Pr": 1}}})
        case.write("constant/turbulenceProperties", {"simulationType": "laminar"})
    entries.update(control or {})
    case.write("system/controlDict", entries)
    case.run("blockMesh")
    return case


def _meshOf(processor, time):
    """Folder of a processor's mesh of a time: that of the time, or the last one before it."""
    times = [t for t in os.listdir(processor) if re.fullmatch(r"[\d.e+-]+", t)
             and float(t) <= float(time) and os.path.isdir(os.path.join(processor, t, "polyMesh"))]
    return os.path.join(processor, max(times, key=float, default="constant"), "polyMesh")


def volField(case, time, name):
    """Internal values of a field of a time, ascii or binary; of a decomposed
    case those of its processors in the order of the undecomposed cells."""
    if not os.path.exists(case.file(time, name)) and case.processors():
        parts, cells = [], []
        for d in case.processors():
            parts.append(_internal(os.path.join(d, time, name)))
            cells.append(labels(os.path.join(_meshOf(d, time), "cellProcAddressing")))
            if parts[-1].shape[0] == 1 and len(cells[-1]) > 1:
                parts[-1] = np.repeat(parts[-1], len(cells[-1]), axis=0)
        values, cells = np.concatenate(parts), np.concatenate(cells)
        return values[np.argsort(cells)]
    return _internal(case.file(time, name))


_SIZE = {b"scalar": 1, b"vector": 3, b"tensor": 9, b"symmTensor": 6}


def _internal(path):
    with open(path, "rb") as f:
        raw = f.read()
    binary = re.search(rb"format\s+(\w+)\s*;", raw)[1] == b"binary"
    at = re.search(rb"(?:internalField|value)\s+(uniform|nonuniform)\s*", raw)
    if at[1] == b"uniform":
        text = raw[at.end():raw.index(b";", at.end())]
        values = np.array(text.translate(None, b"()").split(), float)
        return values if len(values) == 1 else values[None, :]
    head = re.compile(rb"List<(\w+)>\s*(\d+)\s*\(").match(raw, at.end())
    size, n = _SIZE[head[1]], int(head[2])
    if binary:
        values = np.frombuffer(raw, "f8", n*size, head.end())
    else:
        end = re.compile(rb"\)\s*;").search(raw, head.end()).start()
        values = np.array(raw[head.end():end].translate(None, b"()").split(), float)
    return values.reshape(n, size) if size > 1 else values


def labels(path):
    with open(path, "rb") as f:
        raw = f.read()
    binary = re.search(rb"format\s+(\w+)\s*;", raw)[1] == b"binary"
    head = re.search(rb"\n(\d+)\s*\(", raw)
    if binary:
        return np.frombuffer(raw, "i4", int(head[1]), head.end())
    return np.array(raw[head.end():raw.index(b")", head.end())].split(), int)
