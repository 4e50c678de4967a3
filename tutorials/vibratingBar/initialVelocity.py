"""Gives the points of the bar the velocity v0 sin(pi x/(2 L)) along x.

Reads the places x that setMaterialPoints wrote to 0/lagrangian/bar (ascii) and
replaces the file U there: a header and a list of vectors in the same order.
"""

import math
import re

L, V0 = 25.0, 0.1
CLOUD = "0/lagrangian/bar/"

NUMBER = r"[-+.0-9eE]+"

with open(CLOUD + "x") as f:
    text = f.read()
text = text[text.index("}") + 1:]
places = [float(m[1]) for m in
          re.finditer(rf"\(\s*({NUMBER})\s+{NUMBER}\s+{NUMBER}\s*\)", text)]

with open(CLOUD + "U", "w") as f:
    f.write("FoamFile\n{\n    version 2.0;\n    format ascii;\n"
            "    class vectorField;\n    object U;\n}\n\n")
    f.write(f"{len(places)}\n(\n")
    for x in places:
        f.write(f"({V0*math.sin(math.pi*x/(2*L))!r} 0 0)\n")
    f.write(")\n")

print(f"Initial velocity of {len(places)} points written to {CLOUD}U")
