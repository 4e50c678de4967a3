#!/usr/bin/env python3
"""Energy, momentum and mass of points and gas together, and what a gas does to
bodies that are held.

budget   residual and remap of the energy of points and gas over what was exchanged (largest
         change of the energy of the gas, of the points' kinetic and of their stored
         energy): at most 1 % and falling with the time step, for the plates of
         spall in air with failure, a shock on a moving block, a free piston
blast    a burst of air of 10 bar meets a plate of masonry whose side lies anywhere in its cell:
         residual and remap over what the plate took, at most 0.05 % on cells of 10 mm
restart  the budget goes on through a restart
load     a shock on a body held fixed, one that turns or moves, and a block that
         flies against it: momentum of gas and points less the impulse of walls and
         bodies, to rounding; work of a moving body on the gas; two processors
"""

import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import plateImpactExact as exact
from blockInGas import P0, blockInGas
from coupledCases import TRANSFER, ambient, coupledCase
from foamCase import RunFailed, foamText
from gasCases import WALL
from plates import plateCase
from report import Report

EACH = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}
BOOKS = {"energy": {"type": "materialPointEnergy", **EACH},
         "balance": {"type": "materialPointBalance", **EACH}}
BOOKED = {**TRANSFER, "energyBudget": True}

#: Columns of energy.dat after the time
KINETIC, STRAIN, TOTAL, TRANSFERRED, BOUNDARY, EXTERNAL, RESIDUAL, FAILURE, GAS, GAINED, \
    GAS_BOUNDARY, GAS_EXTERNAL, GAS_RIGID, GAS_DRY, GAS_FIXUPS, DISSIPATION, REMAP = range(1, 18)


def books(case):
    """Function objects of the balances in a case that is there."""
    case.change("system/controlDict", r"^functions\s*\{",
                "functions\n{\n" + foamText(BOOKS, 4))


def exchanged(e):
    """Largest change of the energy of gas, motion or strain."""
    return max(np.max(abs(e[:, GAINED])), np.max(abs(e[:, KINETIC] - e[0, KINETIC])),
               np.max(abs(e[:, STRAIN] - e[0, STRAIN])))


def figures(case, label):
    e = case.series("energy", "energy.dat")
    size = exchanged(e)
    end = e[-1]
    print(f"{label}: exchanged {size:.4g} J; of it gas {end[GAINED]/size:+.4f}, kinetic "
          f"{(end[KINETIC] - e[0, KINETIC])/size:+.4f}, strain "
          f"{(end[STRAIN] - e[0, STRAIN])/size:+.4f}, transfer "
          f"{end[TRANSFERRED]/size:+.5f}, failure {end[FAILURE]/size:+.5f}, dry "
          f"{end[GAS_DRY]/size:+.2e}, boundary {end[BOUNDARY]/size:+.2e} "
          f"{end[GAS_BOUNDARY]/size:+.2e}, rigid {end[GAS_RIGID]/size:+.2e}, fix-ups "
          f"{end[GAS_FIXUPS]/size:+.2e}, dissipation {end[DISSIPATION]/size:+.5f}; remap "
          f"{end[REMAP]/size:+.5f}, residual {end[RESIDUAL]/size:+.5f}, largest "
          f"{np.max(abs(e[:, RESIDUAL]))/size:.5f}", flush=True)
    # K + W + E less all other terms is constant; the last three are parts of others
    rest = e[:, KINETIC] + e[:, STRAIN] + e[:, GAINED] \
        - np.delete(e[:, :-3], (0, KINETIC, STRAIN, TOTAL, GAS, GAINED), axis=1).sum(axis=1)
    wrong = e[:, RESIDUAL] + e[:, REMAP]
    return np.max(abs(wrong))/size, np.max(abs(rest - rest[0]))/size


def falling(table, label, runs):
    """runs: Courant number: largest residual, and what the columns leave open."""
    table.row(f"{label}: what the columns of the budget leave open, over exchanged", 0,
              max(r[1] for r in runs.values()), 1e-11, "atMost")
    runs = {Co: r[0] for Co, r in runs.items()}
    steps = sorted(runs, reverse=True)
    table.row(f"{label}: largest remap and residual over exchanged, Courant number"
              f" {steps[0]}", 0, runs[steps[0]], 1e-2, "atMost")
    table.check(f"{label}: it falls with the time step",
                runs[steps[-1]] < 0.75*runs[steps[0]],
                ", ".join(f"{c}: {runs[c]:.2e}" for c in steps))


def spall(table):
    for label, strength in (("spall in air, elastic", None),
                            ("spall in air, 400 MPa", 400e6)):
        runs = {}
        for Co in (0.4, 0.2):
            case = plateCase(
                "energyInGas", f"spall-{strength is not None}-{Co}", 15, BOOKED,
                3e-6 if strength else 1.2e-6, 3e-6, Co, strength=strength,
                air={"poreFloor": 1e-2})
            books(case)
            case.run("materialPointFoam", limit=300)
            runs[Co] = figures(case, f"{label}, Courant number {Co}")
        falling(table, label, runs)


def block(name, drag, Co, steps, region=None, **more):
    pressure = np.full((40, 40), P0)
    pressure[:, :8] = 4*P0
    case = blockInGas(
        "energyInGas", name, 2, 40, region or {
            "type": "box", "min": (12.2e-3, 6.2e-3, -1), "max": (22.3e-3, 16.3e-3, 1)},
        (50, -30, 0), steps, h=1e-3, E=7e9, Co=Co, drag=drag, gasVelocity=(0, 0, 0),
        pressure=pressure.ravel(), numerics=BOOKED, **more)
    books(case)
    return case


def shock(table):
    for label, drag in (("sticking", None), ("no drag", {"type": "none"})):
        runs = {}
        for Co, steps in ((0.4, 600), (0.2, 1200)):
            case = block(f"shock-{label[:2]}-{Co}", drag, Co, steps)
            case.run("materialPointFoam", limit=300)
            runs[Co] = figures(case, f"shock on a block, {label}, Courant number {Co}")
        falling(table, f"shock on a moving block, {label}", runs)
        mixtureRows(table, f"shock on a moving block, {label}", case)


def mixtureRows(table, label, case):
    m = case.series("balance", "mixture.dat")
    size = max(np.max(abs(m[:, 3:6])), np.max(abs(m[:, 6:9])))
    table.row(f"{label}: momentum of all less impulses, over the largest", 0,
              np.max(abs(m[:, 9:12]))/size, 1e-12, "atMost")
    table.row(f"{label}: mass of all less what came in", 0,
              np.max(abs(m[:, 2]))/m[0, 1], 1e-12, "atMost")


def landing(table):
    """The block falls on a wall by contact and slides along it: what that gets is booked."""
    def floor(case):
        with open(case.file("constant/phaseProperties"), "a") as f:
            f.write("contact { floor { fields (block); patch yLow; type Coulomb; mu 0.3; } }\n")
        case.change("0/U.block", r"yLow\s*\{[^}]*\}", "yLow { type calculated; }")
    case = block("landing", None, 0.4, 300, {
        "type": "box", "min": (12.2e-3, 1e-3, -1), "max": (22.3e-3, 11.1e-3, 1)},
        walls=True, prepare=floor)
    case.run("materialPointFoam", limit=300)
    given = case.numbers(r"^Contact floor .*impulse \(N N N\)")[-1]
    fell = 30*2700*10.1e-3**2*1e-3
    table.check("landing on a wall: it is turned round and slides", fell < -given[1] < 2*fell
                and abs(given[0]/given[1] + 0.3) < 1e-6, str(given))
    mixtureRows(table, "landing on a wall", case)


def piston(table):
    L, width, rho, E = 0.45, 0.1, 27.0, 7e7
    for drag in ("none", "stick"):
        runs = {}
        for Co in (0.4, 0.2):
            case = coupledCase(
                "energyInGas", f"piston-{drag}-{Co}", (100, 1, 1), (1, 0.01, 0.01),
                lambda x, y, z: (1.2 + 0*x, 0*x, 1e5 + 0*x), 5e-3,
                {"slab": {"drag": {"type": drag}, "constitutiveModel": {
                    "type": "linearElastic", "rho": rho, "E": E, "nu": 0}}},
                {"slab": {"type": "box", "min": (L, 0, 0), "max": (L + width, 1, 1),
                          "velocity": (5, 0, 0), "stress": ambient(1e5)}},
                ends=WALL, ppc=4, maxCo=Co, numerics={"energyBudget": True},
                maxCoGas=Co)
            books(case)
            case.run("materialPointFoam", limit=300)
            runs[Co] = figures(case, f"piston, drag {drag}, Courant number {Co}")
        falling(table, f"free piston, drag {drag}", runs)
        mixtureRows(table, f"free piston, drag {drag}", case)


def blast(table):
    rho, g, width, thick = 1.2, 1.4, 0.3, 0.1
    c = np.sqrt(g*P0/rho)

    def burst(x, y, z):
        # A wave that runs to the right, steep in front
        ratio = 1 + 10*np.clip((x - 0.5)/width + 1, 0, 1)**2*(x < 0.5)
        return (rho*ratio**(1/g), 2*c/(g - 1)*(ratio**((g - 1)/(2*g)) - 1), P0*ratio)

    for part in (0, 0.25, 0.5, 0.75):
        face = 0.8 + 0.01*part
        case = coupledCase(
            "energyInGas", f"blast-{part}", (120, 1, 1), (1.2, 0.01, 0.01), burst, 7.5e-4,
            {"plate": {"constitutiveModel": {
                "type": "linearElastic", "rho": 1800, "E": 5e9, "nu": 0}}},
            {"plate": {"type": "box", "min": (face, -1, -1), "max": (face + thick, 1, 1),
                       "stress": ambient(P0)}},
            ends=WALL, maxCo=0.4, maxCoGas=0.4, numerics={"energyBudget": True})
        books(case)
        case.run("materialPointFoam", limit=300)
        e = case.series("energy", "energy.dat")
        wrong = np.max(abs(e[:, RESIDUAL] + e[:, REMAP]))
        table.row(f"blast on a plate, its side at {part} of a cell: largest remap and residual over"
                  " what it took", 0, wrong/np.ptp(e[:, TOTAL]), 5e-4, "atMost")


def struck(name, motion=None, withBlock=True, Co=0.4, steps=None):
    """A shock and, if asked for, a block meet a disc that is held or turns."""
    h, n = 1e-3, 40
    phases = {"disc": {"type": "rigid", "rho": 7800, **({"motion": motion} if motion else {})}}
    regions = {"disc": {"type": "cylinder", "point1": (25.1*h, 19.7*h, -1),
                        "point2": (25.1*h, 19.7*h, 1), "radius": 7*h}}
    if withBlock:
        phases["block"] = {"constitutiveModel": {
            "type": "linearElastic", "rho": 2700, "E": 7e9, "nu": 0}}
        regions["block"] = {"type": "box", "min": (11.2*h, 14.2*h, -1),
                            "max": (16.3*h, 26.1*h, 1), "velocity": (80, 5, 0),
                            "stress": ambient(1e5)}
    case = coupledCase(
        "energyInGas", name, (n, n, 1), (n*h, n*h, h),
        lambda x, y, z: (1.2 + 2.4*(x < 8*h), 0*x, 1e5 + 3e5*(x < 8*h)), 8e-5, phases,
        regions, ends=WALL, maxCo=Co, maxCoGas=Co, numerics={"energyBudget": True})
    books(case)
    return case


def load(table):
    turning = {"type": "rotation", "origin": (0.0251, 0.0197, 0), "axis": (0, 0, 1),
               "omega": 3000}
    ends = {}
    for label, motion, withBlock in (("disc held in a shock", None, False),
                                     ("disc held, shock and block", None, True),
                                     ("turning disc, shock and block", turning, True)):
        name = f"load-{len(ends)}"
        case = struck(name, motion, withBlock)
        case.run("materialPointFoam", limit=300)
        mixtureRows(table, label, case)
        ends[label] = case
        impulse = np.array(re.findall(r"Load on disc: .* impulse \(([^)]*)\)",
                                      case.log())[-1].split(), float)
        gas = case.series("balance", "air.dat")[-1]
        if not withBlock:
            table.row(f"{label}: impulse on it against what gas and walls miss [N s]",
                      gas[7] - gas[2], impulse[0],
                      1e-11*abs(impulse[0]))
    runs = {}
    moving = {"type": "translation", "velocity": (-120, 30, 0)}
    for Co in (0.4, 0.2):
        case = struck(f"moving-{Co}", moving, False, Co)
        case.run("materialPointFoam", limit=300)
        runs[Co] = figures(case, f"moving disc in a shock, Courant number {Co}")
    falling(table, "moving disc in a shock", runs)
    mixtureRows(table, "moving disc in a shock", case)
    several = struck("load-parallel", turning, True)
    several.decompose((2, 1, 1))
    several.runParallel()
    label = "turning disc, shock and block, two processors"
    mixtureRows(table, label, several)
    one, two = (c.series("energy", "energy.dat") for c in
                (ends["turning disc, shock and block"], several))
    table.row(f"{label}: terms of the budget against one", 0,
              np.max(abs(one - two))/exchanged(one) if one.shape == two.shape else np.inf,
              1e-9, "atMost")


def restart(table):
    straight, again = (block(name, None, 0.4, 100) for name in ("straight", "again"))
    for case in (straight, again):
        case.change("system/controlDict", "^writeInterval.*?;",
                    f"writeInterval {50*float(value(case, 'deltaT'))!r};")
    straight.run("materialPointFoam")
    half = straight.times()[1]
    again.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
    shutil.copytree(straight.file(half), again.file(half))
    again.run("materialPointFoam")
    a = straight.series("energy", "energy.dat")[-1]
    b = again.series("energy", "energy.dat", half)[-1]
    size = exchanged(straight.series("energy", "energy.dat"))
    table.row("restart: terms of the budget against the run without", 0,
              np.max(abs(a - b))/size, 1e-12, "atMost")


def value(case, keyword):
    with open(case.file("system/controlDict")) as f:
        return re.search(rf"^{keyword}\s+(\S+);", f.read(), re.M)[1]


def main():
    table = Report("energyInGas")
    parts = [spall, shock, landing, piston, blast, load, restart]
    words = sys.argv[1:]
    for part in parts:
        if words and part.__name__ not in words:
            continue
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
