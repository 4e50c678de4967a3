"""The bubble in the bed: cells with less than 20 % of beads that hang together, beside the axis
or not, below the open space above the bed; the largest of them. And what twoPhaseEulerFoam says.

REFERENCE   twoPhaseEulerFoam of OpenFOAM v1912 on the same cells: kinetic theory with its
            equation of the granular temperature, e 0.9, drag of Gidaspow, friction of Johnson
            and Jackson (tests/cases/grains/bubble.py computes it anew). Time: diameter of the
            circle with the area of both halves, lowest and highest place of the bubble [m]
TEMPERATURE the same: median over the beads of their granular temperature [m2/s2]
"""

import numpy as np

H, NX, NY = 0.0075, 20, 72

REFERENCE = {0.04: (0.0397, 0.000, 0.0375), 0.1: (0.0980, 0.000, 0.105),
             0.16: (0.1327, 0.0075, 0.1575), 0.2: (0.1461, 0.0225, 0.1875),
             0.26: (0.1565, 0.0525, 0.2325), 0.3: (0.1676, 0.0825, 0.27)}

TEMPERATURE = {0.04: 2.05e-4, 0.1: 8.21e-5, 0.16: 7.67e-5, 0.2: 7.84e-5, 0.3: 9.89e-5}


def beads(case, time, n=1):
    """Share of the beads, rows from below, on n times as many cells in each direction; the mesh
    has two blocks beside each other."""
    share = 1 - case.field(time, "theta.air")
    left, right = np.split(share, [n*n*NY])
    return np.hstack([left.reshape(n*NY, n), right.reshape(n*NY, n*(NX - 1))])


def patch(inside, seed):
    """Cells that hang together with a seed."""
    found = np.zeros_like(inside)
    found[seed] = True
    while True:
        more = found.copy()
        more[1:] |= found[:-1]
        more[:-1] |= found[1:]
        more[:, 1:] |= found[:, :-1]
        more[:, :-1] |= found[:, 1:]
        more &= inside
        if (more == found).all():
            return found
        found = more


def bubble(share, h=H):
    """Diameter, lowest and highest place [m] of the largest bubble."""
    empty = share < 0.2
    empty &= ~patch(empty, (len(share) - 1, 0))
    best = np.zeros_like(empty)
    while empty.any():
        one = patch(empty, tuple(np.argwhere(empty)[0]))
        best = one if one.sum() > best.sum() else best
        empty &= ~one
    rows = np.flatnonzero(best.any(axis=1))
    if not len(rows):
        return 0.0, 0.0, 0.0
    return np.sqrt(8*best.sum()/np.pi)*h, rows[0]*h, (rows[-1] + 1)*h
