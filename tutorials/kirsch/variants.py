"""The same plate on boxes with GIMP: graded boxes, points cut at the hole.

    variants.py        makes and runs variants/boxes
"""

import os
import re

from mpm.variants import runVariants


def boxes(case):
    """Boxes in place of the triangles."""
    case.change("system/fvSolution", r"^    shapeFunction .*;", "    shapeFunction   GIMP;")
    case.change("system/setMaterialPointsDict", r"(?s)^        type +cells;", """\
        type            difference;
        shapes
        {
            whole   { type cells; }
            hole    { type cylinder; point1 (0 0 -1); point2 (0 0 1); radius 0.01; }
        }""")
    # The rim is no patch
    with open(case.file("0/U.plate")) as f:
        text = f.read()
    with open(case.file("0/U.plate"), "w") as f:
        f.write(re.sub(r"    hole\n    \{.*?\n    \}\n", "", text, flags=re.S))


if __name__ == "__main__":
    os.chdir(os.path.dirname(os.path.abspath(__file__)))
    runVariants({"boxes": ()}, boxes)
