"""Gives the block's lower side the cylinder's shape: y + x^2/(2 R) for every point.

Places are in x; of coordinates the solver takes the cell alone.
"""

import re

R, H, NX = 0.16, 1e-3, 52


def rows(path):
    """Head of a file with a list, and its rows."""
    with open(path) as f:
        text = f.read()
    start = re.search(r"\n\d+\s*\n\(\n", text).end()
    return text[:start], text[start:text.rindex("\n)")].split("\n")


# A face of each cell
face = {int(cell): i for i, cell in enumerate(rows("constant/polyMesh/owner")[1])}
face.update({int(cell): i for i, cell in enumerate(rows("constant/polyMesh/neighbour")[1])})

for phase in ("cylinder", "platen"):
    folder = f"0/lagrangian/{phase}/"
    head, places = rows(folder + "x")
    bent, cells = [], []
    for row in places:
        x, y, z = (float(w) for w in row.strip("()").split())
        y += x*x/(2*R)
        cell = int(x/H) + NX*int(y/H)
        bent.append(f"({x!r} {y!r} {z!r})")
        cells.append(f"(1 0 0 0) {cell} {face[cell]} 1")
    files = [("x", head, bent), ("coordinates", rows(folder + "coordinates")[0], cells)]
    if phase == "platen":
        files.append(("X", rows(folder + "X")[0], bent))
    for name, start, new in files:
        with open(folder + name, "w") as f:
            f.write(start + "\n".join(new) + "\n)\n")
