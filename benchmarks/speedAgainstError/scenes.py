"""Scenes with a known answer: what speedAgainstError.py runs with each scheme.

A scene has a name, what its error is, the resolutions (coarse to fine; the quick
mode takes the first two), the errors of the summary and a function

    measure(label, numerics, cells) -> (case, error, core-seconds, {more figures})

with numerics the dictionary fvSolution.materialPoints and error signed; "cells" in it
is the kind of cells (boxOfCells) in place of boxes, which scenes in 1D do not have, and
those in 2D not in 3D (COLUMNS). A scene more: a function and a line in SCENES.
"""

import os
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
PROJECT = os.path.dirname(os.path.dirname(HERE))
DISKS = os.path.join(PROJECT, "tutorials", "twoDisks")
sys.path[:0] = [os.path.join(PROJECT, "tests", "lib"), DISKS]

import bar  # noqa: E402
from cellMesh import boxOfCells  # noqa: E402
import foamCase  # noqa: E402
import plateImpactExact as exact  # noqa: E402
from energies import Energies  # noqa: E402
from plates import tensionRun  # noqa: E402

RUN = os.path.join(HERE, "run")
foamCase.RUN = RUN


#: Kinds of cells of which the plates are made as columns of 2 x 2 boxes in 3D; as many
#: boxes across as the strips in 2D have, up to 200 cells over the target. Polyhedra:
#: polyDualMesh of the tetrahedra
COLUMNS = {"boxes in 3D": None, "tets": "tets", "polyhedra": "polyhedra"}


def cellsOf(numerics):
    """Numerics without the kind of cells, and that."""
    return {k: v for k, v in numerics.items() if k != "cells"}, numerics.get("cells")


def spall(label, numerics, cells):
    """Instant of the tension at the mid-plane of the target (tests/cases/spall)."""
    numerics, kind = cellsOf(numerics)
    if kind in COLUMNS and cells > 200:
        return None
    size = {"width": 2, "depth": 2} if kind in COLUMNS else {}
    case, seconds, _, sigma, t343 = tensionRun(
        "spall", f"{label}-{cells}", cells, numerics, 0.5, kind=COLUMNS.get(kind, kind),
        limit=1200, **size)
    return case, 1e9*(t343 - exact.T_TENSION), seconds, {
        "largest tension": sigma.max()/exact.STRESS}


def vibratingBar(label, numerics, cells):
    """Period over five periods (tests/cases/vibratingBar)."""
    if "cells" in numerics:
        return None
    case, t, v, energy, seconds = bar.barRun("bar", f"{label}-{cells}", numerics, cells)
    return case, 100*(bar.period(t, v)/bar.T - 1), seconds, {
        "energy %": 100*(energy[-1]/bar.ENERGY - 1)}


def twoDisks(label, numerics, cells):
    """Total energy of two disks that bounce (tutorials/twoDisks); the largest
    error over 3 s, kinetic and strain energy at the same time."""
    if numerics.get("cells") in COLUMNS:
        return None
    case = foamCase.FoamCase("disks", f"{label}-{cells}", DISKS)
    case.change("system/blockMeshDict", r"^n\s.*?;", f"n {cells};")
    case.change("system/controlDict", r"^maxCo\s.*?;", "maxCo 0.1;")
    case.change("system/controlDict", r"^writeInterval\s.*?;", "writeInterval 3;")
    numerics, kind = cellsOf(numerics)
    case.write("system/fvSolution", {"materialPoints": numerics})
    if kind:
        boxOfCells(case, kind, (-0.2, -0.2, 0), (1.2, 1.2, 1), (cells, cells, 1),
                   {"outside": ("patch", ("x-", "x+", "y-", "y+")),
                    "frontAndBack": ("empty", ("z-", "z+"))})
    else:
        case.run("blockMesh")
    case.run("setMaterialPoints")
    seconds = case.run("materialPointFoam", limit=1200)
    e = Energies(case.path)
    # Without USAVG a row's velocities are those of the middle of the step before
    energy = e.total if numerics.get("stressUpdate") == "USAVG" \
        else e.total[:-1] + np.diff(e.kinetic)/2
    error = 100*(energy/e.start - 1)
    return case, error[np.argmax(np.abs(error))], seconds, {
        "kinetic left %": 100*e.kinetic[-1]/e.start}


#: name: (measure, what the error is, resolutions, errors of the summary)
SCENES = {
    "spall": (spall, "instant of tension [ns]", (50, 100, 200, 400),
              (20, 10, 5)),
    "vibratingBar": (vibratingBar, "period [%]", (16, 32, 64, 128),
                     (0.1, 0.03, 0.01)),
    "twoDisks": (twoDisks, "total energy [%]", (14, 28, 56, 112),
                 (5, 1, 0.3))}
