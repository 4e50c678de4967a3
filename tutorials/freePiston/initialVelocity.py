"""Gives gas and points the velocity of the exact motion at its largest.

    initialVelocity.py [case]

Writes 0/U.air and 0/lagrangian/slab/U.
"""

import os
import re
import sys

import numpy as np

from mode import SPEED, shape

case = sys.argv[1] if len(sys.argv) > 1 else "."


def rows(v):
    return f"{len(v)}\n(\n" + "".join(f"({u!r} 0 0)\n" for u in v.tolist()) + ")\n"


def header(name, kind):
    return ("FoamFile\n{\n    version 2.0;\n    format ascii;\n"
            f"    class {kind};\n    object {name};\n}}\n\n")


with open(os.path.join(case, "system/blockMeshDict")) as f:
    n = int(re.search(r"^n\s+(\d+);", f.read(), re.M)[1])
with open(os.path.join(case, "0/U.air"), "w") as f:
    f.write(header("U.air", "volVectorField") + "dimensions [0 1 -1 0 0 0 0];\n"
            "internalField nonuniform List<vector>\n"
            + rows(SPEED*shape((np.arange(n) + 0.5)/n)) + ";\nboundaryField\n{\n"
            "    walls { type slip; }\n    frontAndBack { type empty; }\n}\n")

with open(os.path.join(case, "0/lagrangian/slab/x"), "rb") as f:
    raw = f.read()
count = re.search(rb"\n(\d+)\s*\(", raw)
x = np.frombuffer(raw, "f8", 3*int(count[1]), count.end()).reshape(-1, 3)[:, 0]
with open(os.path.join(case, "0/lagrangian/slab/U"), "w") as f:
    f.write(header("U", "vectorField") + rows(SPEED*shape(x)))
