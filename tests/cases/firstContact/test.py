#!/usr/bin/env python3
"""Water at 100 m/s meets a plate across a gap of air of 0 to 5 cells, in 1D.

The air is pressed to a film and stops nothing: the pressure that stays is that of the shock in
the water (stiffened gas, Rankine-Hugoniot) and of the elastic wave in the plate,

    U - v = (p - p0) sqrt(A/(p + pInf + B)),  A = 2/((g + 1) rho),  B = (g - 1)/(g + 1) (p0 + pInf),
    v = (p - p0)/Z,  Z = sqrt(rho_s E) of the plate, endless of a rigid one.

Largest pressure in the cells before the plate (limit 5 %), and the one that stays 0.1 ms later
(limit of first order, 4, 2 and 1 % on 100, 200 and 400 cells to a metre),

wall      of a wall of the mesh
plate     of points with E 70 GPa, its side on a side of a cell or inside one (solidSurface)
rigid     a rigid phase
star      both with solidFraction star
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from fluidCases import AIR, WATER, besidePoints, fluidCase, fluidField
from foamCase import runParts
from roots import bisection

P0, PINF, G, RHO, U = 1e5, 6e8, 4.4, 1000.0, 100.0
E, RHOS = 7e10, 2700.0
CLOSED = ("zeroGradient", "zeroGradient", "slip")
FLUIDS = {"water": WATER, "air": AIR}
ELASTIC = {"constitutiveModel": {"type": "linearElastic", "rho": RHOS, "E": E, "nu": 0}}
RIGID = {"type": "rigid", "rho": RHOS, "motion": {"type": "fixed"}}


def exact(Z):
    A, B = 2/((G + 1)*RHO), (G - 1)/(G + 1)*(P0 + PINF)
    return bisection(lambda p: p*np.sqrt(A/(p + P0 + PINF + B)) + p/Z - U, 0.0, 1e9)


def contact(table, label, n, gap, Z, plate=None, form=None):
    """Water from 0.1 to 0.5 m, then the gap, n cells to a metre; then a wall or a plate."""
    h = 1/n
    face = 0.5 + gap*h
    cells = n if plate else round(face/h)
    end = gap*h/U + 1.2e-4

    def initial(x, y, z):
        water = np.clip((np.minimum(x + h/2, 0.5) - np.maximum(x - h/2, 0.1))/h, 0, 1)
        return [water, 1 - water], [RHO, 1.2], np.where(x < 0.5, U, 0.0), P0
    case = fluidCase("firstContact", label.replace(" ", "-").replace(",", ""), (cells, 1, 1),
                     (cells*h, 0.01, 0.01), FLUIDS, initial, end, ends=CLOSED,
                     writeInterval=min(end/40, 2e-6), control={"maxCo": 0.4, "deltaT": 1e-9})
    if plate:
        box = {"type": "box", "min": (face, -1, -1), "max": (0.9, 1, 1)}
        if "type" not in plate:
            box.update(stress="ambient", pressure=P0)
        besidePoints(case, FLUIDS, {"plate": plate}, {"plate": box},
                     settings={"solidFraction": form} if form else None)
    case.run("materialPointFoam")
    last = min(int(face/h - 1e-9), cells - 1)
    p = np.array([fluidField(case, float(s), "p")[last - 4:last + 1].max() - P0
                  for s in case.times() if float(s) > 0])
    table.row(f"{label}: largest pressure over the exact one", 1, p.max()/exact(Z), 0.05)
    table.row(f"{label}: pressure that stays over the exact one", 1, p[-10:].mean()/exact(Z),
              4/n)


def wall(table):
    for n, gap in ((100, 0), (100, 5), (200, 1), (400, 0), (400, 5)):
        contact(table, f"wall, {n} cells, gap of {gap}", n, gap, np.inf)


def plate(table):
    for n, gaps in ((100, (0, 0.2, 0.5, 1, 1.3, 5)), (200, (0, 0.2, 1)), (400, (0.2, 1.3))):
        for gap in gaps:
            contact(table, f"plate, {n} cells, gap of {gap}", n, gap, np.sqrt(RHOS*E), ELASTIC)


def rigid(table):
    for n, gap in ((100, 0), (100, 0.2), (100, 1), (200, 0.2)):
        contact(table, f"rigid phase, {n} cells, gap of {gap}", n, gap, np.inf, RIGID)


def star(table):
    for gap in (0, 0.2):
        for name, Z, phase in (("plate", np.sqrt(RHOS*E), ELASTIC), ("rigid phase", np.inf, RIGID)):
            contact(table, f"{name}, star, 200 cells, gap of {gap}", 200, gap, Z, phase, "star")


if __name__ == "__main__":
    sys.exit(runParts("firstContact", wall, plate, rigid, star))
