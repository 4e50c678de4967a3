"""The paper's three examples as the tutorials have them: what paperExamples.py runs.

An example is a function

    measure(case, mesh, air, scheme, cells) -> (value, second figure, {more figures})

mesh boxes or triangles (prisms), air True or False, scheme the dictionary
fvSolution.materialPoints. An example more: a function and its lines in EXAMPLES.
"""

import importlib.util
import os
import shutil
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
PROJECT = os.path.dirname(os.path.dirname(HERE))
TUTORIALS = os.path.join(PROJECT, "tutorials")
sys.path.insert(0, os.path.join(PROJECT, "tests", "lib"))

from cellMesh import boxOfCells  # noqa: E402
from wedge import ALPHA  # noqa: E402


def module(tutorial, name):
    """A module of a tutorial; several have one of the same name."""
    spec = importlib.util.spec_from_file_location(
        f"{tutorial}.{name}", os.path.join(TUTORIALS, tutorial, name + ".py"))
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    return made


plates = module("spallOnTriangles", "results")
body = module("halfCylinder", "results")
bodyVariants = module("halfCylinder", "variants")
rod = module("projectile", "penetration")

FLAT = {"frontAndBack": ("empty", ("z-", "z+"))}


def begin(case, tutorial, *fields):
    case.copy(fields, os.path.join(TUTORIALS, tutorial))


def end(case, time):
    """Ends here, nothing written before."""
    for entry in ("endTime", "writeInterval"):
        case.change("system/controlDict", rf"^{entry}\s.*?;", f"{entry} {time};")


def count(case, **numbers):
    for name, n in numbers.items():
        case.change("system/blockMeshDict", rf"^{name} .*?;", f"{name} {n};")


def solve(case, scheme, maxCo=None):
    case.write("system/fvSolution", {"materialPoints": scheme})
    if maxCo:
        case.change("system/controlDict", r"^maxCo\s.*?;", f"maxCo {maxCo};")
    case.run("setMaterialPoints")
    case.solve()


def gmsh(case, width):
    """Triangles of the plates (tutorials/spallOnTriangles)."""
    shutil.copy(os.path.join(TUTORIALS, "spallOnTriangles/plates.geo"), case.path)
    case.change("plates.geo", "^h = .*?;", f"h = {width!r};")
    case.run("gmsh", "-3", "-format", "msh22", "plates.geo", "-o", "plates.msh")
    case.run("gmshToFoam", "plates.msh")
    case.run("foamDictionary", "-entry", "entry0.frontAndBack.type", "-set", "empty",
             "constant/polyMesh/boundary")


def spall(case, mesh, air, scheme, cells):
    """Instant at which points of the mid-plane fail, after the exact 3 H/c [ns], NaN where
    the target tears elsewhere; the compression before over the exact one [%]."""
    h = 2*plates.H/cells
    gas = ("p", "T.air", "U.air") if air else ()
    if mesh == "boxes":
        begin(case, "spallInAir" if air else "spall", "U.plates", *gas)
        count(case, n=cells, nx=round((2.8 if air else 2.4)*cells),
              ny=round((2.3 if air else 2)*cells))
        case.run("blockMesh")
    else:
        begin(case, "spallOnTriangles", "U.plates")
        gmsh(case, h)
        if air:
            airOfTriangles(case, gas)
    for probe, low, high in (("midPlane", plates.H - h/2, plates.H + h/2),
                             ("freeSurface", 0, h/2)):
        if probe == "midPlane" or mesh != "boxes" or not air:
            case.change("system/controlDict", rf"(?s)({probe}.*?box \(\S+) \S+ (\S+ \S+) \S+ ",
                        rf"\1 {low!r} \2 {high!r} ")
    end(case, 1.4e-6)
    solve(case, scheme, 0.9 if mesh != "boxes" and not air and scheme["transfer"] == "FMPM"
          else 0.4)
    t, stress = case.series("midPlane", "sigma_yy.dat").T
    plateau = stress[(t > 0.6e-6) & (t < 0.95e-6)].mean()
    exact = 3*plates.H/plates.C
    _, damage = case.series("midPlane", "damage.dat").T
    failed = plates.crossing(t, damage, 0.25, 0) if damage.max() > 0.25 else np.nan
    return (1e9*(failed - exact), 100*(plateau/-plates.STRESS - 1),
            {"largest stress there [MPa]": 1e-6*stress.max()})


def airOfTriangles(case, fields):
    """The air of spallInAir, which has the same patches."""
    source = os.path.join(TUTORIALS, "spallInAir")
    for path in ("constant/phaseProperties", "system/fvSchemes",
                 *("0/" + field for field in fields)):
        shutil.copy(os.path.join(source, path), case.file(path))
    case.change("system/setMaterialPointsDict", r"(pointsPerCell .*?;)",
                r"\1 stress ambient; pressure 1e5;")
    case.change("system/controlDict", r"^maxCo\s.*?;", r"\g<0>\nmaxCoGas 0.4;")


def halfCylinder(case, mesh, air, scheme, cells):
    """Energy in the cracks at 260 us over that at impact; residual of the energy [%]."""
    begin(case, "halfCylinder", "U.body")
    bodyVariants.change(case, *bodyVariants.cells(cells),
                        *(bodyVariants.AIR if air else ()))
    os.makedirs(case.file("constant/triSurface"))
    case.runScript(os.path.join(TUTORIALS, "halfCylinder/shape.py"))
    end(case, 2.6e-4)
    if mesh == "boxes":
        case.run("blockMesh")
    else:
        boxOfCells(case, "prisms", (-0.065, 0, 0), (0.065, 0.065, 0.12),
                   (26*cells//10, 13*cells//10, 1),
                   {"floor": ("patch", ("y-",)), "outside": ("patch", ("x-", "x+", "y+")),
                    **FLAT})
    solve(case, {**{k: v for k, v in scheme.items() if k != "stressUpdate" or not air},
                 "energyBudget": "yes"})
    e, start = body.energy(case.path)
    return (-100*e["failure"][-1]/start,
            100*np.abs(e["residual"] + e["remap"]).max()/start, {})


def sector(x):
    """A box whose z is 0 or 1 becomes a sector about x."""
    side = np.where(x[:, 2] > 0, 1, -1)
    return np.column_stack((x[:, 0], x[:, 1], side*x[:, 1]*np.tan(ALPHA)))


def projectile(case, mesh, air, scheme, cells):
    """Speed of the interface at 10 to 40 us over Tate's with the resistance of a cavity
    in the target [%]; the tail from Tate's, Rt 5.5 GPa [mm]. Cells over 10 mm."""
    begin(case, "projectile", "U.rod", "U.target", "U.debris")
    nx, nr = round(12.8*cells), round(3.2*cells)
    end(case, 4.2e-5)
    if mesh == "boxes":
        count(case, nx=nx, nr=nr)
        case.run("blockMesh")
    else:
        boxOfCells(case, "prisms", (-0.056, 0, 0), (0.072, 0.032, 1), (nx, nr, 1),
                   {"front": ("wedge", ("z+",)), "back": ("wedge", ("z-",)),
                    "axis": ("empty", ("y-",)), "outside": ("patch", ("x-", "x+", "y+"))},
                   kept=[(0, round(5.6*cells))], place=sector)
    solve(case, scheme)
    path = rod.Path(case.path)
    want = rod.tateSpeed(rod.cavityResistance(rod.material("steelHzB")))
    times, _, tail = rod.tate(5.5e9, 40e-6)[:3]
    some = times >= 10e-6
    speed = path.speed()
    return (100*(speed/want - 1), 1e3*np.abs(path.at(times[some])[1] - tail[some]).max(),
            {"m/s": speed, "nose at 40 us [mm]": 1e3*path.at(40e-6)[0]})
