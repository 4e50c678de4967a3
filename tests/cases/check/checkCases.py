"""Cases of the rows of mpmCheck, and what it finds in them."""

import os

from foamCase import PROJECT, FoamCase
from mpm.check import Check

TEMPLATE = os.path.join(PROJECT, "etc/caseTemplate")
PHASES, REGIONS = "constant/phaseProperties", "system/setMaterialPointsDict"
MESH, SOLUTION, CONTROL = "system/blockMeshDict", "system/fvSolution", "system/controlDict"


def found(check):
    return [f"{f.kind} {f.file}: {f.text}" for f in check.findings]


def basin(name):
    """A block 0.1 m above water of 0.1 m, which it gets to with 1 m/s: damBreakObstacle's."""
    case = FoamCase("check", name, os.path.join(PROJECT, "tutorials/damBreakObstacle"))
    case.set("system/setFluidsDict", "regions.column.max", (1, 0.1, 1))
    for entry, value in (("min", (0.2, 0.2, 0)), ("max", (0.24, 0.24, 0.005)),
                         ("velocity", (0, -1, 0))):
        case.set(REGIONS, "regions.obstacle." + entry, value, add=True)
    case.change("0.orig/U.solids", "fixedValue;\n *value .*;", "slip;")
    case.set(CONTROL, "functions.tip.points", {"nearest": [(0.2, 0.2, 0.0025)]})
    case.set("system/fvSolution", "materialPoints.PICfraction", 0.01)
    case.set(PHASES, "fluids.lowMach", "solids")
    return case


def toldOf(case, word, **options):
    """Kind and file of the findings with a word, and the check; without a trial."""
    check = Check(case.path, **{"trial": False, **options})
    check.run()
    return [(f.kind, f.file) for f in check.findings if word in f.text], check
