"""Meshes of wedges: sectors of axisymmetric scenes, as blockMesh makes them.

    case.write("system/blockMeshDict", wedgeMesh(
        (0, 0), (1, 0.5), (20, 10), {"left": ("patch", "x-"), "right": ("patch", "x+"),
                                     "wall": ("patch", "r+")}))

Coordinates are along the axis and from it, the radius on the mid-plane; "x-" and
"x+" are the ends of the axis whatever its name is, "r-" the inner side of a mesh
with a hole. The wedge patches are front and back, the collapsed side is axis.
"""

import numpy as np

#: Half the angle of the wedges
ALPHA = np.radians(2.5)

#: Volume of a sector over radius and section, 2 tan(alpha)
SECTOR = 2*np.tan(ALPHA)


def wedgeMesh(low, high, cells, patches, axes="xy", alpha=ALPHA, shift=0.0):
    """blockMeshDict; axes: names of the axis and of the radius; shift: the mesh is
    moved so far along its radius (then it is no wedge for material points)."""
    (x0, r0), (x1, r1) = low, high
    a, r = ("xyz".index(c) for c in axes)
    across = 3 - a - r
    # The corners of a hex turn right-handed
    front = -1 if (r - a) % 3 == 1 else 1

    def vertex(x, radius, side):
        p = [0.0, 0.0, 0.0]
        p[a], p[r], p[across] = x, radius + shift, side*front*radius*np.tan(alpha)
        return p

    hole = r0 > 0
    vertices = [vertex(x0, r0, 1), vertex(x1, r0, 1), vertex(x1, r1, 1), vertex(x0, r1, 1)]
    if hole:
        vertices += [vertex(x0, r0, -1), vertex(x1, r0, -1)]
    vertices += [vertex(x1, r1, -1), vertex(x0, r1, -1)]
    b = (4, 5, 6, 7) if hole else (0, 1, 4, 5)
    sides = {"x-": (0, b[0], b[3], 3), "x+": (1, 2, b[2], b[1]),
             "r-": (0, 1, b[1], b[0]), "r+": (3, b[3], b[2], 2)}

    def text(corners):
        return "(" + " ".join(map(str, corners)) + ")"

    boundary = [f"front {{ type wedge; faces ({text((0, 3, 2, 1))}); }}",
                f"back {{ type wedge; faces ({text(b)}); }}"]
    if not hole:
        boundary.append(f"axis {{ type empty; faces ({text(sides['r-'])}); }}")
    boundary += [f"{name} {{ type {kind}; faces ({text(sides[side])}); }}"
                 for name, (kind, side) in patches.items()]
    return {"scale": 1, "vertices": vertices,
            "blocks": f"(hex {text((0, 1, 2, 3) + b)} ({cells[0]} {cells[1]} 1)"
                      " simpleGrading (1 1 1))",
            "boundary": "(" + " ".join(boundary) + ")"}


def wedgeConditions(patches, hole=False):
    """Conditions of 0/U.<field> with those of the wedge patches."""
    return {"front": "wedge", "back": "wedge", **({} if hole else {"axis": "empty"}),
            **patches}
