#!/usr/bin/env python3
"""Spall in air: the plates of tests/cases/spall with air in their pores and
around them, a strip, 50 cells over the target, 2 x 2 points per cell, GIMP, FLIP
with 1 % PIC, Courant number 0.4, sticking drag, gas of first order.

Air of 1e5 Pa weighs nothing beside 687 MPa, so the solid must do what it does in
vacuum, and with pores of 10 % (volumeFraction 0.9 of the same material) the same:

    t343    as in tests/cases/spall; air against vacuum 0.1 %, porous against
            dense 0.2 %
    gas     pressure above zero, no fix-up, Theta (sum of all volume fractions)
            in 0.998..1.002
    sums    cyclic ends: mass of the gas to rounding, momentum of solid and gas
            1e-11 of the flyer's; what energy is lost is lost by FLIP and in
            failure, as in vacuum: 1e-3 of the flyer's

Without failure to 1.2 us, with a strength of 400 MPa to 3 us; pore floor 0.01.
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import plateImpactExact as exact
from foamCase import RunFailed
from plates import P_AIR, crossing, plateCase, startPositions
from report import Report

US, NS = 1e-6, 1e-9
CELLS = 50
NUMERICS = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}
DENSE = {"volumeFraction": 1, "poreFloor": 1e-2}
POROUS = {"volumeFraction": 0.9, "poreFloor": 1e-2}

NUMBER = r"([-+\d.e]+|-?nan|-?inf)"


def numbers(log, pattern):
    """Rows of all matches of a pattern in which N stands for a number."""
    return np.array([np.array(m if isinstance(m, tuple) else (m,), float) for m in
                     re.findall(pattern.replace("N", NUMBER), log, flags=re.M)])


def run(name, air, strength=None):
    h = 2*exact.H/CELLS
    case = plateCase(
        "spallInAir", name, CELLS//2, NUMERICS, 3*US if strength else 1.2*US, 1*US, 0.4,
        strength=strength, air=air,
        probes=[("target", "middle", ("sigma_yy",), exact.H - h/2, exact.H + h/2, "mean")]
        + bool(strength)*[("target", "all", ("damage",), 0, 2*exact.H, "none")])
    case.change("system/controlDict", "^adjustTimeStep", "reportInterval 1;\nadjustTimeStep")
    case.run("materialPointFoam", limit=300)
    return case


def t343(case):
    return crossing(*case.series("middle", "sigma_yy.dat").T, exact.STRESS/2)


def solid(case):
    """Momentum along y and energy over the reports."""
    log = case.log()
    return (numbers(log, r"^Material points:.*momentum \(N N N\)")[:, 1],
            numbers(log, r"^Energy:.* total N")[:, 0])


def gasRows(table, label, case):
    """What must hold in every step."""
    log = case.log()
    p = numbers(log, r"^    p N to N,")
    fixups = numbers(log, r"outflow limited N, theta kept N, isentropic N ")
    Theta = numbers(log, r"^Theta: min N, max N")
    gas = numbers(log, r"^Gas air: mass N, momentum \(N N N\), energy N")
    table.check(f"{label}: a report of each step",
                len(p) == len(fixups) == len(Theta) == len(gas) >= case.nSteps(), len(p))
    table.check(f"{label}: pressure above zero", np.min(p) > 0,
                f"{np.min(p)/P_AIR:.4g} to {np.max(p)/P_AIR:.4g} of 1e5 Pa")
    table.row(f"{label}: fix-ups", 0, np.max(fixups[-1]), 0)
    table.row(f"{label}: least Theta", 0.998, np.min(Theta), 0.998, "atLeast")
    table.row(f"{label}: largest Theta", 1.002, np.max(Theta), 1.002, "atMost")
    table.row(f"{label}: change of the gas' mass", 0,
              np.max(abs(gas[:, 0]/gas[0, 0] - 1)), 1e-12)
    return gas


def sums(table, label, case, gas, vacuum):
    """Momentum and energy of solid and gas; the energy against that in vacuum."""
    momentum, energy = solid(case)
    total = momentum + gas[:, 2]
    table.row(f"{label}: change of momentum, solid and gas", 0,
              np.max(abs(total/total[0] - 1)), 1e-11)
    energy = energy + gas[:, 4]
    kinetic = solid(vacuum)[1][0]
    lost = (energy[0] - energy[-1])/kinetic
    lostInVacuum = (kinetic - solid(vacuum)[1][-1])/kinetic
    table.row(f"{label}: energy lost, solid and gas, against vacuum", lostInVacuum, lost,
              1e-3)


def elastic(table):
    cases = {name: run(name, air) for name, air in
             (("vacuum", None), ("dense", DENSE), ("porous", POROUS))}
    t = {name: t343(case) for name, case in cases.items()}
    print("t343 [ns]: " + ", ".join(f"{name} {v/NS:.3f}" for name, v in t.items())
          + f", exact {exact.T_TENSION/NS:.3f}; seconds: "
          + ", ".join(f"{n} {c.solverSeconds():.2f}" for n, c in cases.items()), flush=True)
    table.row("t343 in air against vacuum [ns]", t["vacuum"]/NS, t["dense"]/NS, 1e-3,
              "relative")
    table.row("t343 porous against dense [ns]", t["dense"]/NS, t["porous"]/NS, 2e-3,
              "relative")
    for name in ("dense", "porous"):
        gas = gasRows(table, name, cases[name])
        if name == "dense":
            sums(table, name, cases[name], gas, cases["vacuum"])


def failed(case):
    """Whether each point failed, the time of the first."""
    record = case.series("all", "damage.dat")
    damaged = record[:, 1:] > 0
    return damaged[-1], record[np.argmax(damaged.any(axis=1)), 0]


def failing(table):
    vacuum = run("vacuum-failing", None, 400e6)
    where, when = failed(vacuum)
    y = startPositions(vacuum, "target")
    for name, air in (("dense", DENSE), ("porous", POROUS)):
        label = f"{name}, 400 MPa"
        case = run(f"{name}-failing", air, 400e6)
        gas = gasRows(table, label, case)
        here, first = failed(case)
        table.check(f"{label}: points fail", here.any(), f"{here.sum()} of {len(here)}")
        table.row(f"{label}: failed points other than in vacuum ({where.sum()} there)", 0,
                  np.sum(here != where), 0)
        table.row(f"{label}: first failure against vacuum [ns]", when/NS, first/NS, 1e-3,
                  "relative")
        if name == "dense":
            sums(table, label, case, gas, vacuum)
        print(f"{label}: failed from {y[here].min():.3e} to {y[here].max():.3e} m, "
              f"{case.solverSeconds():.2f} s, vacuum {vacuum.solverSeconds():.2f} s",
              flush=True)


def main():
    table = Report("spallInAir")
    for part in (elastic, failing):
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
