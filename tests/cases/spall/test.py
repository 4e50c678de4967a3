#!/usr/bin/env python3
"""Spall: what tutorials/spall does, measured against the exact solution.

A flyer of 1.9 mm hits a target of 3.8 mm with 100 m/s (lib/plates.py), GIMP,
4 points per cell, Courant number 0.4 (FLIP) and 0.5 (FMPM).

Without failure:
    t343    instant at which the mean sigma_yy of the points that were within
            half a cell of the target's mid-plane rises through half of
            rho c v/2 = 687.39 MPa; exact 3 H/c = 1.1195 us.
            FLIP + 1 % PIC: 24 ns late at 100 cells over the target, 14 ns at
            200 with a prototype, rounded up: 25 and 16 ns.
            FMPM of order 2: 6 and 3 ns asked for.
    place   where the largest tension is at that instant: within 2 cells of the
            mid-plane
    plateau mean of the same points over 0.60..0.95 us: -687.39 MPa +-1 %
    surface mean velocity of the outermost points of the target over
            0.85..1.05 us: 100 +-2 m/s
With failure at 400 MPa: first failure within 2 cells of the mid-plane at
1.12..1.18 us.

Carried: with cubicBSpline and FMPM 3 all moves with 500 m/s along the impact or
across it (100 cells): t343 within 3 ns, failed rows of points within 20 % of those at
rest (issue). With GIMP the stiffness of short waves depends on where the points are in
their cells: 6 rows fail at rest, where all are alike, 8 to 10 carried, t343 is 7 ns later.

With MPM_VERIFY=1 also 50 and 400 cells, and GIMP carried, printed only.
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import plateImpactExact as exact
from foamCase import RunFailed, VERIFY
from plates import plateCase, startPositions, tensionRun
from report import Report

US, NS, MPA = 1e-6, 1e-9, 1e6

SCHEMES = {
    "FLIP": {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01},
    "FMPM2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2}}

MAX_CO = {"FLIP": 0.4, "FMPM2": 0.5}

#: Four points per cell. The prototype's figures for FLIP are for four across
#: the wave (with 2 x 2 they are 25.7 ns)
POINTS = {"FLIP": "(1 4 1)", "FMPM2": 2}

#: Schemes whose places have a limit. FLIP's ringing makes single points up to
#: five cells beside the mid-plane the first: printed, not judged
PLACES = ("FMPM2",)

#: ns
LIMIT_T343 = {("FLIP", 100): 25, ("FLIP", 200): 16,
              ("FMPM2", 100): 6, ("FMPM2", 200): 3}


def elastic(table, scheme, cells):
    label = f"{scheme}, {cells} cells"
    h = 2*exact.H/cells
    case, seconds, t, sigma, t343 = tensionRun(
        "spall", f"{scheme}-{cells}", cells, SCHEMES[scheme], MAX_CO[scheme],
        POINTS[scheme],
        (("target", "surface", ("U_y",), 0, h/2, "mean"),
         ("target", "all", ("sigma_yy",), 0, 2*exact.H, "none")))
    window = (t > 0.60*US) & (t < 0.95*US)
    plateau = np.mean(sigma[window])

    # Columns of "all" are in the order of ids
    every = case.series("all", "sigma_yy.dat")
    y = startPositions(case, "target")
    at = np.searchsorted(t, t343)
    peak = np.nan if np.isnan(t343) else (y[np.argmax(every[at, 1:])] - exact.H)/h

    t, velocity = case.series("surface", "U_y.dat").T
    window = (t > 0.85*US) & (t < 1.05*US)
    surface = np.mean(velocity[window])

    print(f"{label}: t343 {(t343 - exact.T_TENSION)/NS:+.2f} ns, place {peak:+.2f} cells, "
          f"plateau {plateau/MPA:.2f} MPa, surface {surface:.2f} m/s; "
          f"{case.nSteps()} steps, {seconds:.2f} s of one core", flush=True)
    if (scheme, cells) in LIMIT_T343:
        table.row(f"{label}: t343 [ns]", exact.T_TENSION/NS, t343/NS,
                  LIMIT_T343[scheme, cells])
        if scheme in PLACES:
            table.row(f"{label}: place of the largest tension [cells from y = 1.9 mm]",
                      0, peak, 2)
        table.row(f"{label}: compression plateau [MPa]", -exact.STRESS/MPA,
                  plateau/MPA, 0.01, "relative")
        table.row(f"{label}: free surface [m/s]", -exact.V, surface, 2)


def failing(table, scheme, cells):
    label = f"{scheme}, {cells} cells, strength 400 MPa"
    h = 2*exact.H/cells
    case = plateCase(
        "spall", f"{scheme}-{cells}-failing", cells//2, SCHEMES[scheme], 1.4*US, 1.4*US,
        MAX_CO[scheme], strength=400e6, pointsPerCell=POINTS[scheme],
        probes=(("target", "all", ("damage",), 0, 2*exact.H, "none"),
                ("flyer", "flyerAll", ("damage",), 2*exact.H, 3*exact.H, "none")))
    case.run("materialPointFoam", limit=300)
    record = case.series("all", "damage.dat")
    failed = record[:, 1:] > 0
    if not table.check(f"{label}: points fail", failed.any(),
                       f"{failed[-1].sum()} of {failed.shape[1]}"):
        return
    first = np.argmax(failed.any(axis=1))
    y = startPositions(case, "target")[failed[first]]
    farthest = y[np.argmax(abs(y - exact.H))]/h - exact.H/h
    print(f"{label}: first failure {farthest:+.2f} cells from the mid-plane")
    if scheme in PLACES:
        table.row(f"{label}: first failure, farthest from the mid-plane [cells]", 0,
                  farthest, 2)
    table.row(f"{label}: time of first failure [us]", 1.15, record[first, 0]/US, 0.03)
    flyer = case.series("flyerAll", "damage.dat")[:, 1:] > 0
    table.check(f"{label}: flyer is whole", not flyer.any(), f"{flyer[-1].sum()} failed")


#: Velocities of all, across and along
CARRIED = {"at rest": (0, 0), "along": (0, 500), "against": (0, -500),
           "across": (500, 0)}

GALILEAN = {"shapeFunction": "cubicBSpline", "transfer": "FMPM", "order": 3}


def carry(table, label, numerics, judge=True):
    """The same impact in other frames."""
    width, cells = 4, 100
    rest = None
    for name, velocity in CARRIED.items():
        if name == "against" and judge and not VERIFY:
            continue
        folder = f"{label}-{name}".replace(" ", "")
        *_, t343 = tensionRun("spall", folder, cells, numerics, 0.5, carried=velocity)
        case = plateCase("spall", f"{folder}-failing", cells//2, numerics, 2*US, 2*US,
                         0.5, strength=400e6, width=width, carried=velocity)
        case.run("materialPointFoam", limit=300)
        failed = case.points(case.times()[-1], "target")["damage"] >= 1
        rows = failed.sum()/(2*width)
        print(f"{label}, {name}: t343 {(t343 - exact.T_TENSION)/NS:+.2f} ns, "
              f"{rows:g} failed rows", flush=True)
        rest = rest or (t343, rows)
        if judge and name != "at rest":
            table.row(f"{label}, carried {name}: t343 [ns]", rest[0]/NS, t343/NS, 3)
            table.row(f"{label}, carried {name}: failed rows", rest[1], rows, 0.2,
                      "relative")


def main():
    table = Report("spall")
    for scheme in SCHEMES:
        for cells in (50, 100, 200, 400) if VERIFY else (100, 200):
            try:
                elastic(table, scheme, cells)
            except RunFailed as e:
                table.check(f"{scheme}, {cells} cells runs", False, e)
        for cells in (100, 200):
            try:
                failing(table, scheme, cells)
            except RunFailed as e:
                table.check(f"{scheme}, {cells} cells with failure runs", False, e)
    try:
        carry(table, "cubicBSpline FMPM 3", GALILEAN)
        if VERIFY:
            carry(table, "GIMP FMPM 2", SCHEMES["FMPM2"], False)
    except RunFailed as e:
        table.check("carried plates run", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
