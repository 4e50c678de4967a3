#!/usr/bin/env python3
"""A free body at rest stays at rest; one in uniform motion goes on.

An elastic block (E 1e6, rho 1000, nu 0.3) in 1D, 2D and 3D, linear functions,
GIMP and B-splines, 200 steps at Courant number 0.4, no gravity. A uniform velocity must give
uniform node velocities, no strain and no force: all figures are round-off, which
the limits allow for (c is the wave speed, v0 the velocity of the motion, oblique
in 2D and 3D, with several cells crossed):

    at rest       largest |u|/c 1e-12, energy over rho c^2 V 1e-20
    translation   |u - v0|/|v0| of every point 1e-12, |E - E0|/E0 1e-12,
                  momentum 1e-12, strain energy/kinetic energy 1e-20, position
                  against x0 + v0 t 1e-12 of the mesh, no point lost
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (FoamCase, RunFailed, VERIFY, boxMesh, controlDict, noSchemes,
                      velocityFile)
from report import Report

E, NU, RHO, H = 1e6, 0.3, 1000.0, 0.01
WAVE = np.sqrt(E*(1 - NU)/((1 + NU)*(1 - 2*NU))/RHO)
VELOCITY = np.array([0.1, 0.065, -0.045])*WAVE
STEPS, CO = 200, 0.4

TRANSFERS = {"FLIP": {"transfer": "FLIP", "PICfraction": 0.01},
             "FMPM2": {"transfer": "FMPM", "order": 2}}


def makeCase(nDim, shape, transfer, moving):
    """The block has 4 cells in each direction of a mesh of 16."""
    velocity = np.where(np.arange(3) < nDim, VELOCITY, 0.0)*moving
    cells = [16 if d < nDim else 1 for d in range(3)]
    low = np.array([4 if velocity[d] >= 0 else 8 for d in range(3)])*(np.arange(3) < nDim)
    high = [low[d] + 4 if d < nDim else 1 for d in range(3)]

    case = FoamCase("restAndTranslation",
                    f"{nDim}D-{shape}-{transfer}-{'moving' if moving else 'rest'}")
    case.write("constant/phaseProperties", {
        "phases": ["block"],
        "block": {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E,
                                        "nu": NU}}})
    sides = [s for d in range(3) for s in ("xyz"[d] + "-", "xyz"[d] + "+")]
    patches = {"outside": ("patch", sides[:2*nDim])}
    conditions = {"outside": "calculated"}
    if nDim < 3:
        patches["sides"] = ("empty", sides[2*nDim:])
        conditions["sides"] = "empty"
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), [H*n for n in cells], cells, patches))
    velocityFile(case, "block", conditions)
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "min": low*H, "max": [H*n for n in high],
        "pointsPerCell": 2, "velocity": velocity}}})
    case.write("system/fvSolution",
               {"materialPoints": {"shapeFunction": shape, **TRANSFERS[transfer]}})
    noSchemes(case)
    dt = CO*H/(WAVE + np.max(abs(velocity)))
    case.write("system/controlDict", controlDict(STEPS*dt, STEPS*dt, deltaT=dt, functions={
        "balance": {"type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
                    "writeControl": "timeStep", "writeInterval": 1}}))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=120)
    return case, velocity


def largest(values):
    return float(np.max(np.abs(values)))


def judge(table, label, case, velocity):
    record = case.series("balance", "block.dat")
    kinetic, strain, total = record[:, 9], record[:, 10], record[:, 11]
    momentum, mass = record[:, 3:6], record[:, 2]
    first, last = case.points("0", "block"), case.points(case.times()[-1], "block")
    u, n = last.byId("U"), len(first["id"])

    table.check(f"{label}: same points", len(u) == n and np.all(record[:, 1] == n),
                f"{len(u)} of {n}")
    table.row(f"{label}: mass", mass[0], mass[-1], 1e-12, "relative")
    if not np.any(velocity):
        table.row(f"{label}: largest |u|/c", 0, largest(u)/WAVE, 1e-12)
        table.row(f"{label}: energy/(m c^2)", 0, largest(total)/(mass[0]*WAVE**2), 1e-20)
        return
    speed = np.linalg.norm(velocity)
    energy = mass[0]*speed**2/2
    table.row(f"{label}: largest |u - v0|/|v0|", 0, largest(u - velocity)/speed, 1e-12)
    table.row(f"{label}: |E - E0|/E0", 0, largest(total/energy - 1), 1e-12)
    table.row(f"{label}: |P - P0|/P0", 0,
              largest(momentum - mass[0]*velocity)/(mass[0]*speed), 1e-12)
    table.row(f"{label}: strain energy/kinetic", 0, largest(strain/kinetic), 1e-20)
    t = record[-1, 0]
    travel = last.byId("x") - first.byId("x") - velocity*t
    table.row(f"{label}: position error/mesh size", 0, largest(travel)/(16*H), 1e-12)
    table.row(f"{label}: cells crossed", 3, np.max(abs(velocity))*t/H, 3, "atLeast")


def main():
    table = Report("restAndTranslation")
    for nDim in (1, 2, 3):
        for shape in ("linear", "GIMP", "quadraticBSpline", "cubicBSpline"):
            for transfer in TRANSFERS if VERIFY or shape == "GIMP" else ("FLIP",):
                for moving in (False, True):
                    label = (f"{nDim}D {shape} {transfer}, "
                             f"{'translation' if moving else 'rest'}")
                    try:
                        judge(table, label, *makeCase(nDim, shape, transfer, moving))
                    except RunFailed as e:
                        table.check(f"{label} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
