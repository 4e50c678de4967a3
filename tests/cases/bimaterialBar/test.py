#!/usr/bin/env python3
"""Two laws, one velocity field: a wave meets the joint of two bars.

1D, bar A in 0..1 (rho 1000, c 1000), bar B in 1..2; the joint is in the middle of
a cell, which holds one point of each. A pulse runs to the right in A, with its
velocity and its stress as initial state,

    v = v0 exp(-((x - 0.7)/0.08)^2),   sigma = -Z_A v,   Z = rho c,

v that of half a step earlier, as velocities belong to the middle of a step.

Exact, small strains (nu 0):

    reflected    v_r/v = (Z_A - Z_B)/(Z_A + Z_B) = R,   sigma_r/sigma = -R
    transmitted  v_t/v = 2 Z_A/(Z_A + Z_B) = T,         sigma_t/sigma = T Z_B/Z_A

Measured when both pulses are away from the joint: velocity and stress at the peak
of the pulses, and momentum of each bar over that of the pulse (R and T Z_B/Z_A).
Limits 1 %, where R = 0 of the incident pulse (measured 0.23 %: the cell of the
joint scatters); momentum of both bars to rounding. B is heavier, softer,
or of A's impedance. The reflected peak is looked for within 0.1 of its place: the
part of the initial stress that differs between the points of a cell moves no node
and stays where the pulse started.
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (FoamCase, RunFailed, boxMesh, controlDict, noSchemes,
                      velocityFile, writeField)
from report import Report

H, V0, START = 1/400, 1e-3, 0.7
RHO_A, C_A = 1000.0, 1000.0
DT = 0.4*H/C_A
END = 900*DT      # 0.9/c
#: rho and c of B
SECOND = {"heavier": (4000.0, 500.0), "softer": (500.0, 500.0),
          "impedance of A": (2000.0, 500.0)}
SCHEMES = {"GIMP FLIP": {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0},
           "GIMP FMPM 2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2}}


def run(table, name, scheme):
    rho, c = SECOND[name]
    Z, ZB = RHO_A*C_A, rho*c
    R, T = (Z - ZB)/(Z + ZB), 2*Z/(Z + ZB)

    case = FoamCase("bimaterialBar", f"{name}-{scheme}".replace(" ", ""))
    law = {"type": "linearElastic", "nu": 0}
    case.write("constant/phaseProperties", {
        "phases": ["A", "B"],
        "A": {"velocityField": "bars", "constitutiveModel": {
            **law, "rho": RHO_A, "E": RHO_A*C_A**2}},
        "B": {"velocityField": "bars", "constitutiveModel": {
            **law, "rho": rho, "E": rho*c**2}}})
    n = round(2/H) + 9
    case.write("system/blockMeshDict", boxMesh(
        (-4.5*H, 0, 0), (2 + 4.5*H, 1, 1), (n, 1, 1),
        {"ends": ("patch", ("x-", "x+")), "sides": ("empty", ("y-", "y+", "z-", "z+"))}))
    velocityFile(case, "bars", {"ends": "calculated", "sides": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {
        p: {"phase": p, "type": "box", "min": (a, 0, 0), "max": (a + 1, 1, 1),
            "pointsPerCell": 2} for p, a in (("A", 0), ("B", 1))}})
    case.write("system/fvSolution", {"materialPoints": SCHEMES[scheme]})
    noSchemes(case)
    case.write("system/controlDict", controlDict(END, END, deltaT=DT))
    case.run("blockMesh")
    case.run("setMaterialPoints")

    start = case.points("0", "A")
    x = start["x"][:, 0]
    U, sigma = np.zeros((len(x), 3)), np.zeros((len(x), 6))

    def pulseAt(t):
        return V0*np.exp(-((x - START - C_A*t)/0.08)**2)

    U[:, 0], sigma[:, 0] = pulseAt(-DT/2), -Z*pulseAt(0)
    writeField(case.file("0/lagrangian/A/U"), U)
    writeField(case.file("0/lagrangian/A/sigma"), sigma)
    pulse = start["m"] @ U[:, 0]
    both = sorted(case.points("0", "B")["x"][:, 0])[0] - max(x)
    table.check(f"{name}, {scheme}: one cell holds both phases", both < 0.6*H,
                f"distance {both/H:.3g} cells")
    case.run("materialPointFoam")

    a, b = (case.points(case.times()[-1], p) for p in "AB")

    near = abs(a["x"][:, 0] - (2 - START - C_A*END)) < 0.1

    def peak(values):
        return values[np.argmax(np.abs(values))]

    label = f"{name}, {scheme}"
    PA, PB = (p["m"] @ p["U"][:, 0]/pulse for p in (a, b))
    size = abs(R) or 1      # no relative error of a reflection that is zero
    for what, exact, value, scale in (
            ("reflected v", R, peak(a["U"][near, 0])/V0, size),
            ("reflected stress", -R, peak(a["sigma"][near, 0])/(-Z*V0), size),
            ("reflected momentum", R, PA, size),
            ("transmitted v", T, peak(b["U"][:, 0])/V0, T),
            ("transmitted stress", T*ZB/Z, peak(b["sigma"][:, 0])/(-Z*V0), T*ZB/Z),
            ("transmitted momentum", T*ZB/Z, PB, T*ZB/Z)):
        table.row(f"{label}: {what}", exact, value, 0.01*scale)
    table.row(f"{label}: momentum of both", 1, PA + PB, 1e-12)


def main():
    table = Report("bimaterialBar")
    for name in SECOND:
        for scheme in SCHEMES:
            try:
                run(table, name, scheme)
            except RunFailed as e:
                table.check(f"{name}, {scheme} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
