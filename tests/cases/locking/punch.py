"""A smooth strip presses on ground of von Mises in plane strain: Prandtl's limit load,
(2 + pi) k of the strip's width, k = yield/sqrt(3).

Half of the ground, symmetric at x = 0. A traction ramps up to a multiple of the limit and
stays, viscous damping takes what moves: above the limit the strip sinks with a speed that
is the excess over the damping, so that the line through the speeds at 1.05 and 1.10 of the
limit is zero at the load that the scheme can bear. n and a half cells under half the strip:
the nodes of the load have the area up to the middle of a cell. Triangles keep the planes of
the ground's top and of the strip's end.
"""

import numpy as np

from cellMesh import boxOfCells
from foamCase import FoamCase, boxMesh, controlDict, noSchemes, velocityFile

K, E, NU = 1.0, 1e4, 0.3
LIMIT = (2 + np.pi)*K
C = np.sqrt(E*(1 - NU)/((1 + NU)*(1 - 2*NU)))
MULTIPLES = (1.05, 1.10)


def speed(name, kind, n, multiple, numerics):
    """Sinking speed of the strip at the end."""
    case = FoamCase("locking", f"punch-{name}-{kind}-{n}-{multiple}".replace(" ", ""))
    h = 1/(n + 0.5)
    nx, ny = 4*n, round(2.5*n)
    ramp, end = 20/C, 80/C
    load = f"(0 {-multiple*LIMIT} 0)"
    case.write("constant/phaseProperties", {"phases": ["ground"], "ground": {
        "constitutiveModel": {"type": "J2Plasticity", "rho": 1, "E": E, "nu": NU,
                              "yield": np.sqrt(3)*K, "hardening": "none"},
        "surfaceLoads": {"strip": {
            "traction": f"table ((0 (0 0 0)) ({ramp} {load}) ({2*end} {load}))",
            "normal": (0, 1, 0), "min": (-1, -1.5*h, -1), "max": ((n + 0.2)*h, 1, 1)}},
        "damping": {"type": "viscous", "rate": 0.25*C}}})
    patches = {"left": ("symmetryPlane", ("x-",)), "wall": ("patch", ("x+", "y-")),
               "free": ("patch", ("y+",)), "sides": ("empty", ("z-", "z+"))}
    velocityFile(case, "ground", {
        "left": "symmetryPlane", "free": "calculated", "sides": "empty",
        "wall": {"type": "fixedValue", "value": "uniform (0 0 0)"}})
    case.write("system/setMaterialPointsDict", {"regions": {"ground": {
        "phase": "ground", "type": "box", "min": (0, -ny*h, 0), "max": (nx*h, 0, h),
        "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    case.write("system/controlDict", {**controlDict(end, end/8, maxCo=0.4),
                                      "startFrom": "latestTime"})
    low, high, cells = (0, -ny*h, 0), (nx*h, 3*h, h), (nx, ny + 3, 1)
    if kind == "boxes":
        case.write("system/blockMeshDict", boxMesh(low, high, cells, patches))
        case.run("blockMesh")
    else:
        boxOfCells(case, kind, low, high, cells, patches, kept=((1, ny), (0, n), (0, n + 1)))
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=300)
    x = case.points("0", "ground").byId("x")
    under = (x[:, 0] < 1) & (x[:, 1] > -h)
    times = case.times()[-3:]
    y = [case.points(t, "ground").byId("x")[under, 1].mean() for t in (times[0], times[-1])]
    return (y[0] - y[1])/(float(times[-1]) - float(times[0]))


def limitLoad(*scheme):
    """Over Prandtl's."""
    one, two = (speed(*scheme[:3], m, scheme[3]) for m in MULTIPLES)
    return MULTIPLES[0] - one*(MULTIPLES[1] - MULTIPLES[0])/(two - one)


MEAN = {"shapeFunction": "GIMP", "dilatation": "cellMean"}
FLIP = {"transfer": "FLIP", "PICfraction": 0}
FMPM = {"transfer": "FMPM", "order": 2}
#: Name, mesh, cells under half the strip, scheme
SCHEMES = (("FMPM", "boxes", 8, {**MEAN, **FMPM}), ("APIC", "boxes", 8,
                                                    {**MEAN, "transfer": "APIC"}),
           ("FMPM", "prisms", 8, {"shapeFunction": "nodeDual", **FMPM}),
           ("APIC", "prisms", 8, {"shapeFunction": "nodeDual", "transfer": "APIC"}))
LONG = (("FMPM", "boxes", 4, SCHEMES[0][3]), ("FMPM", "boxes", 16, SCHEMES[0][3]),
        ("FMPM", "prisms", 4, SCHEMES[2][3]), ("FMPM", "prisms", 16, SCHEMES[2][3]),
        ("FLIP", "boxes", 16, {**MEAN, **FLIP}),
        ("FMPM pressureFilter", "boxes", 8, {**SCHEMES[0][3], "pressureFilter": 0.02}))


def punch(table, schemes=SCHEMES):
    for scheme in schemes:
        name, kind, n, _ = scheme
        table.row(f"punch, {kind}, {name}, {n} cells: limit load over Prandtl's", 1,
                  limitLoad(*scheme), 0.02)


def longPunch(table):
    punch(table, LONG)
