#!/usr/bin/env python3
"""Scenes drawn at random, as users set them up: none may stop for what the scheme did.

    fluids    two to four fluids of all equations of state in boxes, wedges and tetrahedra
              with walls, fluids.py: goes on to its end, or until its time is over; mass of each
              fluid within 1e-12 of all, energy within 1e-12 but what the log says was added,
              which is more than 1 % in 15 % of the scenes at most; or is refused at the start

    test.py [first last]     other seeds than 0 to 39, for longer
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import fluids as fluidScenes
from foamCase import RunFailed
from report import Report

#: Steps of a scene's fastest wave through a cell, and seconds; a run that goes on has not
#: stopped. Of the default run, of seeds that are given
STEPS, LIMIT = (60, 4) if len(sys.argv) < 2 else (200, 10)


def columns(path):
    """Columns of a table of a function object, by their names without unit."""
    with open(path) as f:
        names = [line for line in f if line.startswith("#")][-1].strip("# \n").split("\t")
    return dict(zip((n.split("[")[0] for n in names), np.loadtxt(path, ndmin=2).T))


def outcome(scene):
    """Error of mass and of energy; why it ended (None: at its end)."""
    case = fluidScenes.write(scene, STEPS)
    why, slow = None, False
    try:
        if scene["ranks"] > 1:
            case.decompose((2, 1, 1))
            case.runParallel(limit=LIMIT)
        else:
            case.run("materialPointFoam", limit=LIMIT)
    except RunFailed as e:
        slow = "did not end" in str(e)
        why = None if slow else " ".join(str(e).split())[:300]
    log = case.log("materialPointFoam")
    if why and "FATAL" in log:
        why = " ".join(log[log.index("FATAL") + 14:].split())[:300]
    if not os.path.exists(case.file("postProcessing", "balance")):
        return {"why": why, "start": True}
    rows = {name: columns(case.file("postProcessing", "balance", "0", name + ".dat"))
            for name in scene["fluids"] + ["total"]}
    total = rows["total"]
    mass = max(np.max(np.abs(r["massRest"])) for r in rows.values())/total["mass"][0]
    scale = np.max(np.abs(total["internal"]) + total["kinetic"])
    energy = np.max(np.abs(total["energyRest"]))/scale
    added = re.findall(r"\(energy (\S+) added", log)
    return {"why": why, "slow": slow, "mass": mass, "energy": energy, "case": case,
            "added": abs(float(added[-1]))/scale if added else 0,
            "steps": case.nSteps(),
            "bounded": re.findall(r"bounded fluxes (\d+), steps halved (\d+)", log)[-1:]}


def main():
    table = Report("randomScenes")
    numbers = [int(a) for a in sys.argv[1:] if a.isdigit()]
    first, last = numbers if numbers else (0, 40)
    refused = slow = fixed = 0
    for seed in range(first, last):
        scene = fluidScenes.draw(seed)
        name = "fluids " + fluidScenes.describe(scene)
        try:
            r = outcome(scene)
        except RunFailed as e:
            # setFluids: a region may lie within another
            refused += "fills no part" in str(e)
            if "fills no part" not in str(e):
                table.check(name, False, " ".join(str(e).split())[:300])
            continue
        print(name, {k: v for k, v in r.items() if k != "case"}, flush=True)
        if "start" in r:
            refused += 1
            table.check(f"{name}: refused with a reason", "must be" in r["why"], r["why"])
            continue
        slow += r["slow"]
        fixed += r["added"] > 0.01
        table.check(f"{name}: does not stop", r["why"] is None, r["why"] or "")
        table.row(f"fluids {seed}: mass of each", 0, r["mass"], 1e-12)
        table.row(f"fluids {seed}: energy", 0, r["energy"], 1e-12)
    table.row("scenes whose fix-ups added more than 1 % of the energy [%]", 0,
              100*fixed/(last - first), 15)
    table.row("scenes not set up [%]", 0, 100*refused/(last - first), 15)
    print(f"{slow} still ran when their time was over")
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
