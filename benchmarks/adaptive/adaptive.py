"""Cells that follow the scene beside all cells fine and all twice as wide: seconds of the
processor and results. Arguments: scenes (octant projectile ball). In benchmarks/run/adaptive;
octant needs 4 GB of memory and ten minutes.

    octant      a sphere of TNT bursts in air, an eighth of it, up to 13 of its radii, 4 fine
                cells over the radius (128^3 in all)
    projectile  tutorials/projectile up to 40 us, points that split
    ball        tutorials/ballThroughPlate, points that split
"""

import os
import re
import sys

import numpy as np

from mpm.case import Case

HERE = os.path.dirname(os.path.abspath(__file__))
TUTORIALS = os.path.join(HERE, "../../tutorials")
RUN = os.path.join(HERE, "../run/adaptive")

#: Of the TNT [m]; fine cells over it, base cells to them; gauges in radii
RADIUS, CELLS, LEVELS, GAUGES = 0.05, 4, 3, (5, 8, 12)


def octant(case, cells, levels):
    n = 32*cells >> levels
    corners = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    sides = {"x": ("(0 4 7 3)", "(1 2 6 5)"), "y": ("(0 1 5 4)", "(3 7 6 2)"),
             "z": ("(0 3 2 1)", "(4 5 6 7)")}
    case.write("system/blockMeshDict", {
        "scale": 32*RADIUS, "vertices": corners,
        "blocks": [f"hex (0 1 2 3 4 5 6 7) ({n} {n} {n}) simpleGrading (1 1 1)"],
        "boundary": [f"{axis} {{ type symmetryPlane; faces ({low}); }}"
                     for axis, (low, _) in sides.items()]
        + [f"outside {{ type patch; faces ({' '.join(high for _, high in sides.values())}); }}"]})
    for name, dimensions, value in (("p", "[1 -1 -2 0 0 0 0]", 101325),
                                    ("T.air", "[0 0 0 1 0 0 0]", 288),
                                    ("U", "[0 1 -1 0 0 0 0]", "(0 0 0)")):
        case.write("0/" + name, {
            "dimensions": dimensions, "internalField": f"uniform {value}",
            "boundaryField": {'"[xyz]"': {"type": "symmetryPlane"},
                              "outside": {"type": "zeroGradient"}}},
            "volVectorField" if name == "U" else "volScalarField")
    charge = {"type": "sphere", "centre": (0, 0, 0), "radius": RADIUS}
    case.write("system/setFluidsDict", {
        "default": {"fluid": "air", "T": 288, "p": 101325},
        "regions": {"charge": {**charge, "fluid": "tnt"}}})
    places = [[r*RADIUS*x for x in d] for r in GAUGES for d in ((1, 0.02, 0.02), (3**-0.5,)*3)]
    case.change("system/controlDict", r"^endTime .*", "endTime 3e-4;")
    case.change("system/controlDict", r"^writeInterval .*", "writeInterval 3e-4;")
    case.change("system/controlDict", r"(?s)probeLocations\s*\(.*?\);",
                f"fixedLocations yes; probeLocations ({' '.join(map(foamVector, places))});")
    case.change("constant/phaseProperties", r"\(\(0.001 0 0\)\)", "((0 0 0))")
    if levels:
        case.write("system/adaptiveMeshDict", {
            "maxLevel": levels, "keep": 1, "refine": {
                "charge": {"type": "shape", "to": 3e-5, "shape": {**charge, "radius": 2*RADIUS}},
                "shock": {"type": "jump", "field": "p", "relative": 0.3}}})


def foamVector(x):
    return f"({' '.join(f'{v:.6g}' for v in x)})"


def octantResults(case):
    """Largest overpressures [bar], arrivals [us] at half of them."""
    rows = case.series("pressure", "p")
    t, p = rows[:, 0], rows[:, 1:] - 101325
    return {"peaks [bar]": 1e-5*p.max(axis=0),
            "arrivals [us]": 1e6*t[np.argmax(p > 0.5*p.max(axis=0), axis=0)]}


def even(case, mesh, ratio):
    """Cells of the tutorial times 1/ratio; nodeDual, which halved cells need."""
    for entry in mesh:
        n = int(case.entry("system/blockMeshDict", entry))
        case.change("system/blockMeshDict", rf"^{entry} .*", f"{entry} {n//ratio};")
    case.change("system/fvSolution", r"shapeFunction .*", "shapeFunction nodeDual;")


def follow(case, phases):
    """Fine around points of these phases, one level less further away."""
    near = {"type": "points", "phases": phases}
    case.write("system/adaptiveMeshDict", {
        "maxLevel": 2, "buffer": 8, "splitPoints": "yes",
        "refine": {"near": near, "around": {**near, "level": 1}}})


def projectile(case, ratio, adaptive):
    even(case, ("nx", "nr"), ratio)
    case.change("system/controlDict", r"^endTime .*", "endTime 40e-6;")
    case.change("system/controlDict", r"^writeInterval .*", "writeInterval 40e-6;")
    case.change("constant/phaseProperties", r"^contact", "outflow { patches (outside); }\n\ncontact")
    if adaptive:
        follow(case, ("rod", "debris"))


def projectileResults(case):
    rod, debris = (case.points(case.nearest(40e-6), name) for name in ("rod", "debris"))
    x, m = (np.concatenate([rod[n], debris[n]]) for n in ("x", "m"))
    order = np.argsort(-x[:, 0])
    nose = np.searchsorted(np.cumsum(m[order]), 0.05*m.sum())
    return {"5 % of the rod are beyond [mm]": 1e3*x[order[nose], 0],
            "tail [mm]": 1e3*rod["x"][:, 0].min(), "not eroded [%]": 100*rod["m"].sum()/m.sum()}


def ball(case, ratio, adaptive):
    even(case, ("n", "nx", "nr"), ratio)
    if adaptive:
        follow(case, ("ball",))


def ballResults(case):
    body, plate = (case.points(case.nearest(10e-6), name) for name in ("ball", "plate"))
    slow = np.linalg.norm(plate["U"], axis=1) < 150
    return {"mean speed [m/s]": np.average(body["U"][:, 0], weights=body["m"]),
            "foremost [mm]": 1e3*plate["x"][:, 0].max(),
            "hole [mm]": 2e3*plate["x"][slow, 1].min()}


#: Tutorial, files of 0, set-up with its arguments (fine, coarse, adaptive), programs, results
SCENES = {
    "octant": ("tntInAir", (), octant, ((CELLS, 0), (CELLS//2, 0), (CELLS, LEVELS)),
               "setFluids", octantResults),
    "projectile": ("projectile", ("U.rod", "U.target", "U.debris"), projectile,
                   ((1, False), (2, False), (4, True)), "setMaterialPoints", projectileResults),
    "ball": ("ballThroughPlate", ("U.ball", "U.plate"), ball,
             ((1, False), (2, False), (4, True)), "setMaterialPoints", ballResults)}


def run(scene):
    tutorial, start, make, arguments, setter, results = SCENES[scene]
    for name, given in zip(("all fine", "all twice as wide", "adaptive"), arguments):
        case = Case(os.path.join(RUN, scene, name.replace(" ", "_")))
        case.copy(start, os.path.join(TUTORIALS, tutorial))
        make(case, *given)
        adapts = os.path.exists(case.file("system/adaptiveMeshDict"))
        for program in ("blockMesh", *(("adaptMesh",) if adapts else ()), setter,
                        "materialPointFoam"):
            case.run(program)
        seconds = re.findall(r"^ExecutionTime = (\S+) s", case.log(), re.M)[-1]
        changes = re.findall(r"^Adaptive mesh: (.* took \S+)", case.log(), re.M)
        print(f"{scene}, {name}: {float(seconds):.1f} s, {case.nSteps()} steps", *changes)
        for key, value in results(case).items():
            print(f"    {key}: {np.array2string(np.asarray(value), precision=4)}", flush=True)


if __name__ == "__main__":
    for argument in sys.argv[1:] or SCENES:
        run(argument)
