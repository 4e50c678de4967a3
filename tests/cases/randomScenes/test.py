#!/usr/bin/env python3
"""Scenes drawn at random, as users set them up: none may stop for what the scheme did.

    fluids    two to four fluids of all equations of state in boxes, wedges and tetrahedra
              with walls, fluids.py: goes on to its end, or until its time is over; mass of each
              fluid within 1e-12 of all, energy within 1e-12 but what the log says was added,
              which is more than 1 % in 15 % of the scenes at most; or is refused at the start
    solids    two bodies of all laws, failure models, transfers and contact laws in nothing, a gas
              or water and air, solids.py: goes on; mass and, with fluids, momentum less impulses
              within 1e-12; residual of the energy at most 1 % of what is exchanged in 95 % of
              the scenes
    memory    one of them does not depend on what memory held before, to the last digit
    stops     points at walls are put back; a volume that turns over stops with its point
    pores     gas in the pores of bodies that collide goes on; so do points drawn apart

    test.py [fluids|solids] [first last]     other seeds than 0 to 39, and 0 to 19 and 65
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import fluids as fluidScenes
import solids as solidScenes
from foamCase import RunFailed
from report import Report

#: Steps of a scene's fastest wave through a cell, and seconds; a run that goes on has not
#: stopped. Of the default run, of seeds that are given
STEPS, LIMIT = (40, 4) if len(sys.argv) < 2 else (200, 10)


def columns(path):
    """Columns of a table of a function object, by their names without unit."""
    with open(path) as f:
        names = [line for line in f if line.startswith("#")][-1].strip("# \n").split("\t")
    return dict(zip((n.split("[")[0] for n in names), np.loadtxt(path, ndmin=2).T))


def run(scene, case, limit):
    """Why it ended (None: at its end), whether it was still running."""
    try:
        if scene["ranks"] > 1:
            case.decompose((2, 1, 1))
            case.runParallel(limit=limit)
        else:
            case.run("materialPointFoam", limit=limit)
    except RunFailed as e:
        if "did not end" in str(e):
            return None, True
        log = case.log("materialPointFoam")
        # OpenFOAM after v1912 gives its version before the message
        start = re.search(r"FATAL (IO )?ERROR: *(\(openfoam-[^)]*\))?", log)
        text = log[start.end():] if start else str(e)
        return " ".join(text.split())[:300], False
    return None, False


def outcome(scene):
    """Error of mass and of energy; why it ended (None: at its end)."""
    case = fluidScenes.write(scene, STEPS)
    why, slow = run(scene, case, LIMIT)
    log = case.log("materialPointFoam")
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


def meeting(scene):
    """The same of two solids; energy: largest residual over what has been exchanged."""
    case = solidScenes.write(scene, STEPS)
    why, slow = run(scene, case, LIMIT)
    if not os.path.exists(case.file("postProcessing", "energy")):
        return {"why": why, "slow": slow, "start": True}
    e = columns(case.file("postProcessing", "energy", "0", "energy.dat"))
    rows = {name: columns(case.file("postProcessing", "balance", "0", name + ".dat"))
            for name in ("total", "mixture") if name == "total" or scene["around"] != "nothing"}
    size = max(np.max(np.abs(e["gasGained"])) if "gasGained" in e else 0,
               *(np.ptp(e[name]) for name in ("kinetic", "strain")), 1e-3*e["kinetic"][0])
    m = rows["total"]["mass"]
    r = {"why": why, "slow": slow, "steps": case.nSteps(), "case": case,
         "mass": np.ptp(m)/m[0], "energy": np.max(np.abs(e["residual"]))/size,
         **{name: (e[name][-1]/size) for name in
            ("transfer", "remap", "contact", "failure", "dissipation", "residual") if name in e},
         "exchange": e["exchange"][-1]/size if "exchange" in e else 0}
    if "mixture" in rows:
        largest, rest = (max(np.max(np.abs(rows[table][n + d]))
                             for d in ("x" if scene["sort"] == "wedge" else "xyz"))
                         for table, n in (("total", "P"), ("mixture", "rest")))
        r["momentum"] = rest/largest
    return r


def each(table, kind, seeds, scenes, result):
    """Seed and result of the scenes that were set up and have begun; refused: the others."""
    for seed in seeds:
        scene = scenes.draw(seed)
        name = f"{kind} {scenes.describe(scene)}"
        try:
            r = result(scene)
        except RunFailed as e:
            # setFluids: a region may lie within another
            if "fills no part" not in str(e):
                table.check(name, False, " ".join(str(e).split())[:300])
            continue
        print(name, {k: f"{v:.2g}" if isinstance(v, float) else v for k, v in r.items()
                     if k != "case"}, flush=True)
        if "start" in r:
            # Nothing was written when its time was over, or before its first step
            if not r.get("slow"):
                table.check(f"{name}: refused with a reason", "must be" in r["why"], r["why"])
            continue
        table.check(f"{name}: does not stop", r["why"] is None, r["why"] or "")
        table.row(f"{kind} {seed}: mass of each", 0, r["mass"], 1e-12)
        yield seed, r


def fluids(table, seeds):
    n = fixed = slow = 0
    for seed, r in each(table, "fluids", seeds, fluidScenes, outcome):
        n += 1
        slow += r["slow"]
        fixed += r["added"] > 0.01
        table.row(f"fluids {seed}: energy", 0, r["energy"], 1e-12)
    table.row("scenes whose fix-ups added more than 1 % of the energy [%]", 0,
              100*fixed/len(seeds), 15)
    table.row("scenes not set up [%]", 0, 100*(len(seeds) - n)/len(seeds), 15)
    print(f"{slow} still ran when their time was over")


def solids(table, seeds):
    wrong = 0
    for seed, r in each(table, "solids", seeds, solidScenes, meeting):
        if "momentum" in r:
            table.row(f"solids {seed}: momentum less impulses", 0, r["momentum"], 1e-12)
        wrong += r["energy"] > 0.01
    table.row("solids whose energy residual is above 1 % of what is exchanged [%]", 0,
              100*wrong/len(seeds), 5)


def memory(table, _):
    """A shock on solids in water and air, with memory that holds other bytes before it is set
    (numbers of -1e28)."""
    scene = solidScenes.draw(107)
    found = []
    for filled in ("0", "58"):
        case = solidScenes.write(scene, 60, f"memory{filled}")
        os.environ["MALLOC_PERTURB_"] = filled
        try:
            case.run("materialPointFoam", limit=60)
        finally:
            del os.environ["MALLOC_PERTURB_"]
        found.append(case.series("energy", "energy.dat"))
    limited = re.findall(r"outflow limited (\d+)", case.log("materialPointFoam"))
    table.row("solids in water: outflow limited", 1, float(limited[-1]), 1, "atLeast")
    table.row("solids in water: energies with other bytes in memory", 0,
              np.max(np.abs(found[1] - found[0])), 0, "atMost")


def stops(table, _):
    """Points thrown at plane walls of boxes that used to leave through them; a point whose
    volume turns over (USL with linear functions) stops the run with its place."""
    for seed in (54, 125):
        scene = solidScenes.draw(seed)
        case = solidScenes.write(scene, 200, f"wall{seed}")
        why, slow = run(scene, case, 60)
        table.check(f"solids {seed} stay within walls", why is None and not slow, why or "")
        log = case.log("materialPointFoam")
        table.check(f"solids {seed}: points put back", "Put back on walls" in log)
    scene = {**solidScenes.draw(87), "transfer": "FLIP", "ranks": 1}
    case = solidScenes.write(scene, 200, "turned")
    why, _ = run(scene, case, 60)
    table.check("USL with linear functions: a volume turns over",
                bool(re.match(r"Material point .* at \(.*the volume is not positive", why or "")),
                why)
    table.check("USL with linear functions: warned of at the start",
                "stressUpdate USL with shapeFunction linear" in case.log("materialPointFoam"))


def pores(table, _):
    """Air squeezed at the axis of a wedge between bodies (latticeFraction: gasPush), which
    stopped by fix-ups, and water; water in pores that owed more heat than it had (addHeat);
    points drawn apart, which overfilled their cells (solidFraction: updateVolumes)."""
    for seed in (309, 344, 395, 161, 202, 226, 456):
        scene = solidScenes.draw(seed)
        case = solidScenes.write(scene, 200, f"pores{seed}")
        why, slow = run(scene, case, 60)
        table.check(f"solids {seed}: the gas in their pores goes on", why is None and not slow,
                    why or "")


def main():
    table = Report("randomScenes")
    words = [a for a in sys.argv[1:] if not a.isdigit()]
    numbers = [int(a) for a in sys.argv[1:] if a.isdigit()]
    # In 65 the fluids' steps are made of halves beside the solids
    for part, seeds in ((fluids, range(40)), (solids, [*range(20), 65]), (memory, None),
                        (stops, None), (pores, None)):
        if not words or part.__name__ in words:
            part(table, range(*numbers) if numbers else seeds)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
