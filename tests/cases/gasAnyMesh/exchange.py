"""What points and gas exchange on prisms and tetrahedra (solidFraction star): finite drag
and heat, drag normal to the surface only, failed points.
"""

import re

import numpy as np

from blockInGas import P0, R, T0, figures
from coupledCases import gasLog
from foamCase import controlDict, readField, writeField

H = 1e-3


def relaxation(table, bodyInGas):
    """Warm grains at rest in a gas that moves, everywhere alike: the differences of
    velocity and temperature fall as exp(-rate t)."""
    a, rho, Cv, U, warm, steps = 0.1, 100.0, 500.0, 1.0, 30.0, 100
    thetaG = 1 - a + 1e-3           # poreFloor
    m, M = a*rho, thetaG*P0/(R*T0)
    C, D = m*Cv, M*R/0.4
    drag = 2e5
    rate = (1 - thetaG)*thetaG*drag*(1/m + 1/M)
    heat = rate/((1 - thetaG)*thetaG)/(1/C + 1/D)
    dt = 0.01/rate
    for kind, n in (("prisms", (10, 10, 1)), ("tets", (5, 5, 5))):
        case = bodyInGas(
            f"relaxation {kind}", kind, n,
            {"type": "cells", "volumeFraction": a, "velocity": (0, 0, 0),
             "temperature": T0 + warm}, (0, 0, 0), steps, walls="cyclic",
            gasVelocity=(U, 0, 0), h=H, control={
                **controlDict(steps*dt, steps*dt, deltaT=dt), "reportInterval": 1},
            phase={"volumeModel": "grains", "Cv": Cv,
                   "constitutiveModel": {"type": "noStress", "rho": rho},
                   "drag": {"type": "constant", "value": drag},
                   "heatTransfer": {"type": "constant", "value": heat}})
        g = gasLog(case)
        V = np.prod(n)*H**3
        Q = np.array(re.findall(r"^Heat of block: ([-\d.e+]+)", case.log(), re.M), float)
        t = dt*np.arange(1, steps + 1)
        u = g["momentum"][:, 0]/(V*M) - g["pointMomentum"][:, 0]/(V*m)
        T = Q/(V*C) - g["energy"]/(V*D)
        label = f"grains in a moving gas, {kind}"
        for what, gap in (("velocities", u/U), ("temperatures", T/warm)):
            table.row(f"{label}: difference of {what} less exp(-rate t), rate dt 0.01", 0,
                      np.max(abs(gap - np.exp(-rate*t))), 0.25*0.01)
        total = g["momentum"] + g["pointMomentum"]
        table.row(f"{label}: momentum of both", 0,
                  np.max(abs(total[:, 0]/(V*M*U) - 1)), 1e-12)
        whole = g["energy"] + g["kinetic"] + Q
        table.row(f"{label}: energy of both over the heat exchanged", 0,
                  np.max(abs(whole - whole[0]))/np.ptp(Q), 1e-11)


def alongSurface(table, bodyInGas):
    """Air flows along a slab that fills the box from side to side. With drag normal it
    slips: on even prisms the slab gets as much as on boxes, a thirtieth of what sticking air
    would give it. Where cells are moved their normals are rough."""
    share = {}
    for kind, n, moved, how in (("boxes", (10, 10, 1), 0, "normal"),
                                ("prisms", (10, 10, 1), 0, "normal"),
                                ("prisms", (10, 10, 1), 0, "all"),
                                ("tets", (5, 6, 5), 0.2, "normal")):
        case = bodyInGas(
            f"along {kind} {how}", kind, n,
            {"type": "box", "min": (-1, 0.3*n[1]*H, -1), "max": (1, 0.7*n[1]*H, 1)},
            (0, 0, 0), 200, walls="cyclic", gasVelocity=(50, 0, 0), h=H, modulus=7e9,
            moved=moved, gas={"solidFraction": "star"},
            phase={"drag": {"type": "stick", "direction": how}})
        f = figures(case)
        total = f["momentum"] + f["gasMomentum"]
        label = f"air along a slab, {kind}, drag {how}"
        table.row(f"{label}: momentum of both", 0,
                  np.max(abs(total - total[0]))/np.max(abs(total)), 1e-12)
        table.row(f"{label}: pressures set to the isentrope", 0, f["fixups"][-1][2], 0)
        share[kind, how] = f["momentum"][-1, 0]/total[0, 0]
        print(f"{label}: {share[kind, how]:.4f} of the momentum is the slab's")
    table.row("air along a slab, drag normal: momentum of the slab, prisms/boxes", 1,
              share["prisms", "normal"]/share["boxes", "normal"], 0.02)
    table.row("air along a slab, prisms: momentum of the slab, drag normal/all", 0,
              share["prisms", "normal"]/share["prisms", "all"], 0.05)


def dry(table, bodyInGas, compressed):
    """A shock on a body whose points have failed, which feel no pressure of the gas."""
    for kind, n, body in (("prisms", (24, 20, 1), "block at 30 degrees"),
                          ("tets", (10, 8, 8), "ball")):
        def prepare(case, width=0.2*n[0]*H):
            compressed(width)(case)
            x = readField(case.file("0/lagrangian/block/x"))
            writeField(case.file("0/lagrangian/block/damage"), np.ones(len(x)))

        case = bodyInGas(
            f"dry {kind}", kind, n, body, (50, -30, 0), 200, walls="cyclic", h=H,
            gasVelocity=(0, 0, 0), modulus=7e9, reports=200, prepare=prepare, phase={
                "failureModel": {"type": "maxPrincipalStress", "strength": 1e15,
                                 "ambientPressure": P0}})
        f = figures(case)
        label = f"shock on a failed block, {kind}"
        total = f["momentum"] + f["gasMomentum"]
        table.row(f"{label}: momentum of all, over the block's", 0,
                  np.max(abs(total - total[0]))/np.max(abs(f["momentum"][0])), 1e-12)
        table.row(f"{label}: mass of the gas", f["gasMass"][0], f["gasMass"][-1], 1e-12,
                  "relative")
        table.row(f"{label}: pressures set to the isentrope", 0, f["fixups"][-1][2], 0)
        table.row(f"{label}: least pressure over that of the start", 1,
                  f["p"][:, 0].min()/P0, 0.5, "atLeast")
