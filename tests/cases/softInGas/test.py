#!/usr/bin/env python3
"""Bodies softer than the pressure of the gas around them (referencePressure), 1e5 Pa.

rest      slab, disc and ball with E from 1e3 to 1e6 Pa, laws, transfers: velocity of
          points and gas to rounding, in 1D, 2D and 3D
waves     a pulse in a bar that lies in gas: speed of the law's uniaxial strain,
          sqrt((lambda + 2 mu)/rho), in 1D, and of a plate, sqrt(E/(1 - nu^2)/rho), in 2D
          with gas along its sides; on three meshes
squeezed  slab, disc and ball in gas whose pressure is p_0 + dp: volume at rest of the
          law at -dp in all directions (neo-Hookean; in 1D and 2D plane strain)
energy    a wave of the gas hits a soft block: what the budget does not explain over what
          is exchanged, falling with the time step
failure   a bar that is torn in gas fails at the strength above p_0
restart   bit by bit; two processors
"""

import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from coupledCases import TRANSFER, coupledCase
from foamCase import VERIFY, runParts
from gasCases import WALL

P0, RHO, NU = 1e5, 1000.0, 0.3
TRANSFERS = {"FLIP": TRANSFER, "FMPM": {**TRANSFER, "transfer": "FMPM", "order": 2},
             "XPIC": {**TRANSFER, "transfer": "XPIC", "order": 2},
             "APIC": {**TRANSFER, "transfer": "APIC"}}
for name in ("FMPM", "XPIC", "APIC"):
    TRANSFERS[name].pop("PICfraction")


def law(E, kind="neoHookean", nu=NU):
    if kind == "MooneyRivlin":
        mu = E/(2*(1 + nu))
        return {"type": kind, "rho": RHO, "C10": 0.4*mu, "C01": 0.1*mu, "K": E/(3*(1 - 2*nu))}
    return {"type": kind, "rho": RHO, "E": E, "nu": nu}


def soft(E, kind="neoHookean", **more):
    return {"constitutiveModel": law(E, kind), "referencePressure": P0, **more}


def lame(E):
    return E*NU/((1 + NU)*(1 - 2*NU)), E/(2*(1 + NU))


def body(nDim, centre, radius):
    """Slab, disc or ball."""
    if nDim == 1:
        return {"type": "box", "min": (centre - radius, -1, -1), "max": (centre + radius, 1, 1)}
    if nDim == 2:
        return {"type": "cylinder", "point1": (centre, centre, -1), "point2": (centre, centre, 1),
                "radius": radius}
    return {"type": "sphere", "centre": 3*(centre,), "radius": radius}


def inGas(name, nDim, n, phase, region, endTime, p=P0, rhoGas=1.2, h=1e-2, cells=None, **more):
    cells = cells or [n if d < nDim else 1 for d in range(3)]
    return coupledCase(
        "softInGas", name, cells, [h*c for c in cells],
        lambda x, y, z: (rhoGas + 0*x, 0*x, p + 0*x), endTime, {"body": phase},
        {"body": region}, **{"ends": WALL, "sides": WALL, **more})


def rest(table):
    laws = ("neoHookean", "MooneyRivlin", "linearElastic", "J2Plasticity", "DruckerPrager")
    scenes = [(d, E, laws[0], "FLIP") for d in (1, 2, 3) for E in (1e3, 1e6)]
    scenes += [(2, 1e3, kind, "FLIP") for kind in laws[1:3]]
    scenes += [(2, 1e3, laws[0], t) for t in TRANSFERS if t != "FLIP"]
    if VERIFY:
        scenes = [(d, E, kind, t) for d in (1, 2, 3) for E in (1e3, 1e4, 1e5, 1e6)
                  for kind in laws[:3] for t in TRANSFERS]
    for nDim, E, kind, transfer in scenes:
        n = {1: 40, 2: 16, 3: 8}[nDim]
        steps = 2000 if VERIFY else 200
        dt = 0.4*1e-2/342/nDim
        case = inGas(f"rest-{nDim}-{E:g}-{kind}-{transfer}", nDim, n, soft(E, kind),
                     body(nDim, 0.503*n*1e-2, 0.27*n*1e-2), steps*dt,
                     numerics=TRANSFERS[transfer], control={"reportInterval": steps})
        case.run("materialPointFoam", limit=300)
        end = case.times()[-1]
        table.row(f"rest, {nDim}D, E {E:g} Pa, {kind}, {transfer}, {case.nSteps()} steps:"
                  " speed of the points [m/s]", 0,
                  np.max(abs(case.points(end, "body")["U"])), 1e-11, "atMost")


def pulse(name, nDim, n, E, distance):
    """Centre of the right half of a pulse of velocity, and time."""
    h, amplitude = 1/n, 1e-3
    lam, mu = lame(E)
    c = np.sqrt((lam + 2*mu)/RHO if nDim == 1 else E/(1 - NU**2)/RHO)
    x = np.linspace(0, 1, 401)
    u = amplitude*c*np.exp(-((x - 0.5)/0.05)**2)
    velocity = {"x": "table (" + " ".join(f"({a!r} ({b!r} 0 0))" for a, b in zip(x, u)) + ")"}
    # In 2D a bar of 0.05 in a channel of 0.15
    cells = (n, 1, 1) if nDim == 1 else (n, round(0.15*n), 1)
    low, high = (-1, 1) if nDim == 1 else (0.05, 0.1)
    case = inGas(name, nDim, n, soft(E),
                 {"type": "box", "min": (0.05, low, -1), "max": (0.95, high, 1),
                  "velocity": velocity}, distance/c, h=h, cells=cells,
                 numerics={"shapeFunction": "GIMP", "transfer": "FLIP"},
                 control={"maxGasSubSteps": 10})
    case.run("materialPointFoam", limit=600)
    p = case.points(case.times()[-1], "body")
    x, u = p["x"][:, 0], p["U"][:, 0]
    right = (x > 0.5) & (u > 0.25*np.max(u))
    return np.sum(x[right]*u[right])/np.sum(u[right]) - 0.5, c


def waves(table):
    E = 1e4
    for nDim, meshes in ((1, (50, 100, 200)), (2, (40, 80, 160) if VERIFY else (40, 80))):
        errors = []
        for n in meshes:
            found, c = pulse(f"wave-{nDim}-{n}", nDim, n, E, 0.3)
            errors.append(found/0.3 - 1)
        print(nDim, meshes, errors)
        table.row(f"wave in a bar, {nDim}D, {meshes[-1]} cells, E {E:g} Pa: speed over"
                  f" {c:.4g} m/s", 1, 1 + errors[-1], 5e-3)


def equilibrium(E, nDim, dp):
    """J of a neo-Hookean body at the pressure dp in all computed directions."""
    lam, mu = lame(E)
    low, high = 1e-3, 1.0
    for _ in range(200):
        J = 0.5*(low + high)
        s = (lam*np.log(J) + mu*(J**(2/nDim) - 1))/J
        low, high = (J, high) if s < -dp else (low, J)
    return J


def squeezed(table):
    E, dp = 1e4, 2000.0
    for nDim, n in ((1, 40), (2, 20), (3, 10)):
        case = inGas(f"squeezed-{nDim}", nDim, n,
                     soft(E, damping={"type": "viscous", "rate": 60}),
                     body(nDim, 0.503*n*1e-2, 0.27*n*1e-2), 0.4, p=P0 + dp, rhoGas=20,
                     ends=("fixedValue", "zeroGradient", "zeroGradient"),
                     control={"reportInterval": 1000, "maxGasSubSteps": 10})
        case.run("materialPointFoam", limit=600)
        a, b = (case.points(t, "body") for t in (case.times()[0], case.times()[-1]))
        J = np.sum(b["V"])/np.sum(a["V"])
        table.row(f"{('slab', 'disc', 'ball')[nDim - 1]}, E {E:g} Pa, gas {dp:g} Pa above"
                  " p_0: change of volume", equilibrium(E, nDim, dp) - 1, J - 1, 1e-2, "relative")
        table.row(f"{nDim}D: speed left", 0, np.max(abs(b["U"])), 1e-3, "atMost")


if __name__ == "__main__":
    sys.exit(runParts("softInGas", rest, waves, squeezed))
