#!/usr/bin/env python3
"""Cracks of the crack band: the cases of tutorials/brazilianDisc and halfCylinder.

disc       first damage on the loaded diameter about the centre, peak load
half       half-cylinder on a rigid floor at two resolutions (MPM_VERIFY=1: also the
           third): symmetry, damaged area, energy
air        the same in air
"""

import importlib.util
import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import PROJECT, VERIFY, FoamCase, RunFailed
from report import Report


def tutorialCase(tutorial, name):
    """A copy of a tutorial with its shapes written."""
    case = FoamCase("brittle", name, template=os.path.join(PROJECT, "tutorials", tutorial))
    for entry in os.listdir(case.path):
        if re.fullmatch(r"\d[\d.]*(e-\d+)?", entry) and entry != "0":
            raise RunFailed(f"tutorials/{tutorial} has results: run its Allclean")
    case.run(sys.executable, "shape.py")
    return case


def module(tutorial, name):
    """A script of a tutorial."""
    path = os.path.join(PROJECT, "tutorials", tutorial, name + ".py")
    spec = importlib.util.spec_from_file_location(f"{tutorial}_{name}", path)
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


def run(case, limit=300):
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case.run("materialPointFoam", limit=limit)


def disc(table):
    case = tutorialCase("brazilianDisc", "disc")
    case.change("system/controlDict", r"^endTime .*?;", "endTime 0.74;")
    seconds = run(case)
    results = module("brazilianDisc", "results")
    R = 0.5
    time, place, n, spread = results.firstDamage(case.path)
    table.row("disc: centre of the first damage from that of the disc, over R", 0,
              np.hypot(*place)/R, 0.05)
    # On a loaded diameter theory has no more than a flat maximum at the centre
    table.row("disc: exact tension where damage begins over that at the centre", 1,
              results.tension(spread/R)/results.tension(0), 0.05)
    t, top, bottom, kinetic, strain, residual = results.loads(case.path)
    force = 0.5*(top + bottom)
    table.row("disc: load at first damage [N/m]", results.EXACT, np.interp(time, t, force),
              0.05, "relative")
    table.row("disc: peak load [N/m]", results.EXACT, force.max(), 0.05, "relative")
    table.row("disc: it falls after the peak", 0, force[-1]/force.max(), 0.95, "atMost")
    table.row("disc: kinetic over stored energy at first damage", 0,
              np.interp(time, t, kinetic/strain), 0.01, "atMost")
    table.row("disc: residual of the energy over the largest stored", 0,
              abs(residual).max()/strain.max(), 0.02, "atMost")
    print(f"disc: {n} points at first, up to {spread/R:.2f} R from the centre, {seconds:.1f} s")


def change(case, changes):
    for file, pattern, text in changes:
        with open(case.file(file)) as f:
            old = f.read()
        new, count = re.subn(pattern, text, old, flags=re.S | re.M)
        if not count:
            raise RunFailed(f"{pattern} is not in {file}")
        with open(case.file(file), "w") as f:
            f.write(new)


def halfRun(name, changes, table, air=False):
    """Run a variant; its rows, and the part of the mass that is damaged."""
    variants, results = module("halfCylinder", "variants"), module("halfCylinder", "results")
    case = tutorialCase("halfCylinder", name)
    change(case, changes)
    if air:
        variants.gasFields(case.path)
    seconds = run(case, limit=600)
    failed, damaged, ratio = results.damaged(case.path)
    table.row(f"{name}: failed mass, left over right", 1, ratio, 0.05)
    energy, start = results.energy(case.path)
    table.row(f"{name}: residual of the energy over that at impact", 0,
              abs(energy["residual"]).max()/start, 0.02, "atMost")
    # Cracks only take energy
    table.row(f"{name}: energy that cracks give back, over that at impact", 0,
              np.diff(energy["failure"]).max()/start, 1e-3, "atMost")
    print(f"{name}: failed {failed:.4f}, damaged {damaged:.4f}, energy of failure "
          f"{-energy['failure'][-1]/start:.4f}, {seconds:.1f} s")
    return damaged, case


def half(table):
    cells = module("halfCylinder", "variants").cells
    area = [halfRun(f"half{n}", cells(n), table)[0]
            for n in ((20, 40, 80) if VERIFY else (20, 40))]
    table.row("half-cylinder: damaged area, last resolution over the one before", 1,
              area[-1]/area[-2], 0.15)


def air(table):
    variants = module("halfCylinder", "variants")
    _, case = halfRun("air20", variants.VARIANTS["coarseAir"], table, air=True)
    log = case.log()
    p = [float(x) for x in re.findall(r"^    p (\S+) to", log, re.M)]
    fixups = re.findall(r"outflow limited (\S+), theta kept (\S+), isentropic (\S+) ", log)
    table.row("air: least pressure [Pa]", 0, min(p), 0, "atLeast")
    table.row("air: fix-ups of the gas", 0, sum(float(v) for v in fixups[-1]), 0, "atMost")


def main():
    table = Report("brittle")
    for part in (disc, half, air):
        if len(sys.argv) > 1 and part.__name__ not in sys.argv[1:]:
            continue
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
