"""A block slides in a half-pipe of gmsh's triangles, which follow both: held by slip, and on
it by contact with friction, against the exact compound pendulum."""

import math
import os
import shutil

import numpy as np

from foamCase import FoamCase, controlDict, noSchemes, velocityFile
from pendulum import G, slidingSector, turningPoints

RI, RO, THETA0, A = 0.8, 1.0, math.radians(46.667), math.radians(13.333)
LIBS = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}
MASS_FILTER = {"transfer": "FLIP", "massFilter": 1}


def slide(name, transfer, mu, end, mesh):
    """The run; its columns of balance and energy."""
    case = FoamCase("gmshMeshes", name)
    shutil.copy(os.path.join(os.path.dirname(__file__), "halfPipe.geo"), case.path)
    contact = {"contact": {"pipe": {"fields": "(block)", "patch": "pipe", "type": "Coulomb",
                                    "mu": mu}}}
    case.write("constant/phaseProperties", {"phases": ["block"], "block": {
        "constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0.3}},
        **(contact if mu else {})})
    velocityFile(case, "block", {"frontAndBack": "empty", "rest": "calculated",
                                 "pipe": "calculated" if mu else "slip"})
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "cellZone", "zone": "block", "pointsPerCell": 2}}})
    case.write("system/fvSolution", {"materialPoints": {**transfer, "energyBudget": True}})
    noSchemes(case)
    forces = {} if mu else {"forces": {"type": "materialPointPatchForces",
                                       "patches": "(pipe)", **LIBS}}
    case.write("system/controlDict", {"reportInterval": 100, **controlDict(
        end, end, 0.4, functions={"balance": {"type": "materialPointBalance", **LIBS},
                                  "energy": {"type": "materialPointEnergy", **LIBS}, **forces})})
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, -G, 0)},
               "uniformDimensionedVectorField")
    mesh(case, "halfPipe", ("frontAndBack", "empty"))
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=200)
    with open(case.file("postProcessing/energy/0/energy.dat")) as f:
        names = [word.split("[")[0] for word in f.readlines()[1].lstrip("# ").split()]
    energy = dict(zip(["time", *names[1:]], case.series("energy", "energy.dat").T))
    return case, case.series("balance", "block.dat"), energy


def halfPipe(table, mesh):
    for how, transfer, mu, swings in (("slip", MASS_FILTER, 0, 2),
                                      ("slip", {"transfer": "APIC"}, 0, 1),
                                      ("contact", MASS_FILTER, 0.1, 1)):
        end = 1.05*swings + 0.1
        t, theta, rate, arm = slidingSector(A, RI, RO, THETA0, mu, end)
        label = f"half-pipe, {how}, mu {mu}, {transfer['transfer']}"
        case, s, energy = slide(label.replace(",", "").replace(" ", "-"), transfer, mu, end,
                                mesh)
        m, P = s[0, 2], s[:, 3:6]
        exact = turningPoints(t, rate)[swings - 1]
        ours = turningPoints(s[:, 0], P[:, 0])[swings - 1]
        table.row(f"{label}: time of {'half a swing' if swings == 1 else 'a swing'} [s]",
                  exact, ours, 0.01, "relative")
        speed = np.abs(arm*rate*np.cos(theta)).max()
        table.row(f"{label}: largest momentum along x [m/s]", speed, np.abs(P[:, 0]/m).max(),
                  0.01, "relative")
        # Heights, by the work of gravity
        kinetic = 0.5*m*(RO**2 + RI**2)/2*(rate**2).max()
        fallen = m*G*arm*(np.interp(exact, t, np.cos(theta)) - math.cos(THETA0))
        table.row(f"{label}: energy missing at the turning point/largest kinetic", 0,
                  (np.interp(ours, energy["time"], energy["external"]) - fallen)/kinetic, 0.01)
        table.row(f"{label}: residual of the energy/the same", 0,
                  np.abs(energy["residual"]).max()/kinetic, 1e-3)
        if mu:
            table.row(f"{label}: work of friction/largest kinetic", -fallen/kinetic,
                      np.interp(ours, energy["time"], energy["contact"])/kinetic, 0.02)
        else:
            force = case.series("forces", "pipe.dat")
            impulse = np.cumsum(np.diff(np.concatenate(([0], s[:, 0])))[:, None]
                                * force[:, 1:4], axis=0)
            missing = np.outer(m*s[:, 0], (0, -G, 0)) - P
            table.row(f"{label}: impulse on the wall/missing momentum - 1", 0,
                      np.max(np.linalg.norm(impulse - missing, axis=1))
                      / np.max(np.linalg.norm(missing, axis=1)), 1e-10)
