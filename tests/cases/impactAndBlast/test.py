#!/usr/bin/env python3
"""tutorials/ballThroughPlate, coarse and short, and tutorials/blastWall until its shock is
at the wall: sums, energies, and what theory says.

ball    speed with the plug of the plate that it takes along, front of the debris between
        the interface of two flat faces and twice its speed
blast   arrival of the shock against a fine solution along the radius
"""

import importlib.util
import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import PROJECT, FoamCase, RunFailed, runParts


def tutorialCase(tutorial, start="0"):
    """A copy of a tutorial, and its results.py."""
    folder = os.path.join(PROJECT, "tutorials", tutorial)
    case = FoamCase("impactAndBlast", tutorial, template=folder)
    if case.times() != (["0"] if start == "0" else []) or case.times("lagrangian"):
        raise RunFailed(f"{folder} has results: run its Allclean")
    if start != "0":
        shutil.copytree(case.file(start), case.file("0"))
    sys.path.insert(0, folder)      # for what it imports itself
    try:
        spec = importlib.util.spec_from_file_location(f"results_{tutorial}",
                                                      os.path.join(folder, "results.py"))
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    finally:
        sys.path.pop(0)
    return case, module


def ball(table):
    case, results = tutorialCase("ballThroughPlate")
    for name, value in (("n ", 20), ("nx", 160), ("nr", 80)):
        case.change("system/blockMeshDict", rf"^{name} .*", f"{name} {value};")
    case.change("system/controlDict", r"^endTime .*", "endTime 5e-6;")
    for application in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
        case.run(application)
    run = results.Run(case.path, after=3e-6)
    table.row("ball: mass with that of the outflow, over the first", 0, run.mass, 1e-12,
              "atMost")
    table.row("ball: momentum along the axis likewise", 0, run.momentum, 1e-12, "atMost")
    # README: failure with Mie-Grueneisen
    table.row("ball: largest residual of the energy over the ball's", 0, run.residual, 3.2e-3,
              "atMost")
    table.row("ball: speed over that of ball and plug", 1,
              run.speed/results.plugSpeed("copper"), 0.05)
    interface = results.interfaceSpeed("copper")
    table.row("ball: front of the debris over the speed of the interface, 1 to 2", 1.5,
              run.front["plate"]/interface, 0.5)


def blast(table):
    case, results = tutorialCase("blastWall", "0.orig")
    case.change("system/controlDict", r"^endTime .*", "endTime 1e-4;")
    for application in ("blockMesh", "setMaterialPoints", "setFields", "materialPointFoam"):
        case.run(application)
    run = results.Run(case.path)
    mass, momentum = run.rest()
    table.row("blast: mass that nobody gave, over all", 0, mass, 1e-12, "atMost")
    table.row("blast: momentum that nobody gave, over the largest", 0, momentum, 1e-12, "atMost")
    table.row("blast: largest residual of the energy over what the wall got", 0, run.residual(),
              1e-2, "atMost")
    found, exact, _ = run.arrivals(n=750)
    speed = np.gradient(run.places, exact)
    for place, a, b, v in zip(run.places, found, exact, speed):
        table.row(f"blast: place of the shock from the fine one's at {1e3*place:.0f} mm [cells]",
                  0, (b - a)*v/run.h, 1)


if __name__ == "__main__":
    sys.exit(runParts("impactAndBlast", ball, blast))
