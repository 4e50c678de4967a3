"""The slotted disc by OpenFOAM's own programs: interFoam (MULES, cAlpha 1, two correctors)
and interIsoFoam (isoAdvector) with frozenFlow, from their tutorial
notchedDiscInSolidBodyRotation, whose disc turns in x and z. The same cells, start and steps as
ours; one turn."""

import os
import shutil

import numpy as np

from foamCase import FoamCase

TUTORIAL = os.path.join(os.environ.get("WM_PROJECT_DIR", "/"), "tutorials/multiphase",
                        "interIsoFoam/notchedDiscInSolidBodyRotation")
#: L1 over the area on n x n cells, v1912: n: (interFoam, interIsoFoam)
ERRORS = {50: (0.3358, 0.0921), 100: (0.1202, 0.0276), 200: (0.0770, 0.0118)}


def there():
    return os.path.isdir(TUTORIAL) and all(map(shutil.which, ("interFoam", "interIsoFoam")))


def error(application, n, start):
    """L1 over the area after one turn in 10 n steps; start: shares, x fastest."""
    case = FoamCase("fluidsAlone", f"{application}-{n}", TUTORIAL)
    os.rename(case.file("0.orig"), case.file("0"))
    for key in ("nx", "nz"):
        case.change("system/blockMeshDict", rf"^{key} .*", f"{key} {n};")
    for key, value in (("endTime", 1), ("writeInterval", 1), ("deltaT", 0.1/n)):
        case.change("system/controlDict", rf"^{key} .*", f"{key} {value};")
    case.change("system/controlDict", r"^ *reverseTime .*", "")
    if application == "interFoam":
        case.change("system/fvSolution", r"cAlpha +1;",
                    "cAlpha 1; nAlphaCorr 2; MULESCorr no; nLimiterIter 5;")
    values = " ".join(repr(float(a)) for a in start)
    case.change("0/alpha.water", r"internalField .*;",
                f"internalField nonuniform List<scalar> {len(start)} ({values});")
    case.run("blockMesh")
    case.run(application, "-postProcess", "-time", "0")
    case.run(application, limit=600)
    end = case.field("1", "alpha.water")
    return np.mean(abs(end - start))/np.mean(start)
