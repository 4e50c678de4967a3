"""Gives gas and points the velocity of the exact motion at its largest.

    initialVelocity.py [case]

Writes 0/U.air and 0/lagrangian/slab/U.
"""

import sys

import numpy as np

from mpm.case import Case
from mpm.files import foamText, writeField
from mode import SPEED, shape


def vectors(u):
    """Vectors along x."""
    return np.outer(u, (1, 0, 0))


def start(case):
    n = int(case.entry("system/blockMeshDict", "n"))
    values = vectors(SPEED*shape((np.arange(n) + 0.5)/n))
    case.write("0/U.air", {
        "dimensions": "[0 1 -1 0 0 0 0]",
        "internalField": f"nonuniform List<vector> {n} {foamText(values)}",
        "boundaryField": {"walls": {"type": "slip"}, "frontAndBack": {"type": "empty"}}},
        "volVectorField")
    x = case.points("0", "slab")["x"][:, 0]
    writeField(case.file("0/lagrangian/slab/U"), vectors(SPEED*shape(x)))


if __name__ == "__main__":
    start(Case(*sys.argv[1:]))
