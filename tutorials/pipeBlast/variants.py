"""In variants/: triangles of half the side; the straight pipe on boxes, whose plug is as much
heavier as a turning sector is (results.INERTIA). And, if asked for,

    variants.py tube

the same bend in 3D, as deep as it is wide, on tetrahedra."""

import os
import shutil
import sys

from mpm.case import RunFailed
from mpm.variants import variant
from results import INERTIA


def start(case):
    case.copy()
    for name in os.listdir("0.orig"):
        shutil.copy(os.path.join("0.orig", name), case.file("0"))


def fine(case):
    shutil.copy("pipe.geo", case.path)
    case.change("pipe.geo", r"^h = .*;", "h = 0.005;")
    case.run("gmsh", "-3", "-format", "msh22", "pipe.geo", "-o", "pipe.msh")
    case.run("gmshToFoam", "pipe.msh")
    case.run("foamDictionary", "-entry", "entry0.frontAndBack.type", "-set", "empty",
             "constant/polyMesh/boundary")


def straight(case):
    case.change("constant/phaseProperties", r"rho  .*;", f"rho         {500*INERTIA};")
    case.change("system/fvSolution", r"shapeFunction .*", "shapeFunction   GIMP;")
    case.run("blockMesh")


def tube(case):
    """In 3D, without the patch of a case in 2D; along curved walls APIC keeps the points."""
    for name in os.listdir("0.orig"):
        case.change(f"0/{name}", r"(?s)^    frontAndBack\n    {.*?\n    }\n", "")
    case.change("system/fvSolution", r"transfer .*", "transfer        APIC;")
    case.change("system/fvSolution", r"^ *PICfraction .*\n", "")
    shutil.copy("tube.geo", case.path)
    case.run("gmsh", "-3", "-format", "msh22", "tube.geo", "-o", "tube.msh")
    case.run("gmshToFoam", "tube.msh")


if __name__ == "__main__":
    for make in (tube,) if sys.argv[1:] == ["tube"] else (fine, straight):
        case = variant(make.__name__)
        try:
            start(case)
            make(case)
            print(f"Running {case.path}", flush=True)
            case.run("setFields")
            case.run("setMaterialPoints")
            case.run("materialPointFoam")
        except RunFailed as error:
            sys.exit(f"{os.path.basename(sys.argv[0])}: {error}")
