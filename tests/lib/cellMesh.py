"""Meshes of tetrahedra, prisms and hexahedra in a box, written as polyMesh.

    boxOfCells(case, "tets", (0, 0, 0), (1, 1, 1), (8, 8, 8),
               {"walls": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}, moved=0.2)

cuts each of 8 x 8 x 8 boxes into six tetrahedra (two prisms along z) and moves
the inner points at random by up to 0.2 of the widths; prisms and hexahedra keep
plane faces: points above each other in z move alike; hexahedra "warped" do not.
kept: planes (axis, index) whose points stay in them. place: where the points of the
box go at last, of an array of positions; zones: boxes (low, high) before that, whose
cells become cellZones.

    {"left": ("cyclic", ("x-",), "right"), "right": ("cyclic", ("x+",), "left"), ...}

makes a cyclic pair: the points of both sides are moved alike.
"""

import os

import numpy as np

_HEADER = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       {kind};
    location    "constant/polyMesh";
    object      {name};
}}

"""

_TET_FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))
_PRISM_FACES = ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5))
_HEX_FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
              (3, 0, 4, 7))


def _cells(kind, n):
    """Lists of outward faces of each cell."""
    def at(i, j, k):
        return i + (n[0] + 1)*(j + (n[1] + 1)*k)

    cells = []
    for k in range(n[2]):
        for j in range(n[1]):
            for i in range(n[0]):
                c = [at(i + di, j + dj, k + dk) for dk in (0, 1)
                     for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]
                if kind == "tets":
                    for o, order in enumerate(((0, 1, 2), (1, 2, 0), (2, 0, 1),
                                               (0, 2, 1), (2, 1, 0), (1, 0, 2))):
                        ijk, p = [i, j, k], [at(i, j, k)]
                        for d in order:
                            ijk[d] += 1
                            p.append(at(*ijk))
                        if o > 2:
                            p[1], p[2] = p[2], p[1]
                        cells.append([tuple(p[v] for v in f) for f in _TET_FACES])
                elif kind == "prisms":
                    for v in ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)):
                        cells.append([tuple(c[v[w]] for w in f) for f in _PRISM_FACES])
                else:
                    cells.append([tuple(c[v] for v in f) for f in _HEX_FACES])
    return cells


def _matched(outer, points, patches):
    """Faces of cyclic patches in the same order on both sides, with the same first
    point; all others by owners."""
    across = {}
    for i, (_, kind, *_) in enumerate(patches):
        if kind == "cyclic":
            used = np.array([points[p] for f in outer if f[0] == i for p in f[2]])
            across[i] = int(np.argmin(np.ptp(used, axis=0)))

    def place(patch, x):
        return tuple(np.delete(x, across[patch]).round(9))

    turned = []
    for patch, owner, face in outer:
        order = (owner,)
        if patch in across:
            first = min(range(len(face)), key=lambda k: place(patch, points[face[k]]))
            face = face[first:] + face[:first]
            order = place(patch, points[list(face)].mean(axis=0))
        turned.append(((patch, *order), (patch, owner, face)))
    return [f for _, f in sorted(turned, key=lambda f: f[0])]


def _joined(places, faces):
    """Points and faces without points that are in the place of others."""
    _, first, number = np.unique(places, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(np.argsort(first))
    number = order[number.ravel()]
    return (places[np.sort(first)],
            [(*f[:-1], tuple(dict.fromkeys(int(number[p]) for p in f[-1]))) for f in faces])


def writePolyMesh(case, points, cells, patchOf, patches, places=None):
    """cells: outward faces of each; patchOf(centre) gives the index of the patch of
    a boundary face; patches: (name, type), of a cyclic one with its neighbour;
    places: points to write instead, those in one place as one; flat faces fall away."""
    first = {}
    inner, outer = [], []
    for c, faces in enumerate(cells):
        for f in faces:
            key = tuple(sorted(f))
            if key in first:
                owner, face = first.pop(key)
                inner.append((owner, c, face))
            else:
                first[key] = (c, f)
    inner.sort(key=lambda f: f[:2])
    for owner, face in first.values():
        outer.append((patchOf(points[list(face)].mean(axis=0)), owner, face))
    outer = _matched(outer, points, patches)
    if places is not None:
        n = len(inner)
        points, joined = _joined(places, inner + outer)
        inner, outer = joined[:n], [f for f in joined[n:] if len(f[2]) > 2]

    folder = os.path.join(case.path, "constant", "polyMesh")
    os.makedirs(folder, exist_ok=True)

    def write(name, kind, rows):
        with open(os.path.join(folder, name), "w") as f:
            f.write(_HEADER.format(kind=kind, name=name))
            f.write(f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)\n")

    write("points", "vectorField",
          [f"({x!r} {y!r} {z!r})" for x, y, z in points.tolist()])
    faces = [f[2] for f in inner] + [f[2] for f in outer]
    write("faces", "faceList",
          [f"{len(f)}({' '.join(map(str, f))})" for f in faces])
    write("owner", "labelList", [str(f[0]) for f in inner] + [str(f[1]) for f in outer])
    write("neighbour", "labelList", [str(f[1]) for f in inner])
    boundary, start = [], len(inner)
    for i, (name, kind, *neighbour) in enumerate(patches):
        n = sum(1 for f in outer if f[0] == i)
        partner = "".join(f" neighbourPatch {p};" for p in neighbour)
        boundary.append(
            f"{name} {{ type {kind};{partner} nFaces {n}; startFace {start}; }}")
        start += n
    write("boundary", "polyBoundaryMesh", boundary)


def _writeZones(case, points, cells, zones):
    centres = np.array([points[sorted({v for f in faces for v in f})].mean(axis=0)
                        for faces in cells])
    text = [_HEADER.format(kind="regIOobject", name="cellZones"), f"{len(zones)}\n("]
    for name, (low, high) in zones.items():
        inside = np.flatnonzero(np.all((centres > low) & (centres < high), axis=1))
        text.append(f"{name}\n{{\n    type cellZone;\n    cellLabels List<label> "
                    f"{len(inside)}({' '.join(map(str, inside))});\n}}")
    with open(os.path.join(case.path, "constant", "polyMesh", "cellZones"), "w") as f:
        f.write("\n".join(text + [")\n"]))


def boxOfCells(case, kind, low, high, n, patches, moved=0.2, kept=(), seed=1,
               place=None, zones=None):
    """patches: name: (type, sides) as those of boxMesh(), of cyclic ones with the
    neighbour: the points of both move alike."""
    low, high = np.array(low, float), np.array(high, float)
    random = np.random.default_rng(seed)
    k, j, i = np.meshgrid(*(np.arange(m + 1) for m in n[::-1]), indexing="ij")
    index = np.stack((i.ravel(), j.ravel(), k.ravel()), axis=1)
    shift = random.uniform(-moved, moved, index.shape)
    if kind not in ("tets", "warped"):
        plane = random.uniform(-moved, moved, ((n[0] + 1)*(n[1] + 1), 3))
        shift = plane[index[:, 0] + (n[0] + 1)*index[:, 1]]
        shift[:, 2] = 0
    for d in range(3):
        if any(kind == "cyclic" and "xyz"[d] + "-" in sides
               for kind, sides, *_ in patches.values()):
            partner = index.copy()
            partner[partner[:, d] == n[d], d] = 0
            shift = shift[partner @ (1, n[0] + 1, (n[0] + 1)*(n[1] + 1))]
    for d in range(3):
        shift[(index[:, d] == 0) | (index[:, d] == n[d]), d] = 0
    for d, at in kept:
        shift[index[:, d] == at, d] = 0
    points = low + (index + shift)*(high - low)/n

    names = list(patches)
    ofSide = {side: names.index(name) for name, (_, sides, *_) in patches.items()
              for side in sides}

    def patchOf(x):
        far = np.abs(np.array([x - low, high - x]))/(high - low)
        side, d = np.unravel_index(np.argmin(far), far.shape)
        return ofSide["xyz"[d] + "-+"[side]]

    cells = _cells(kind, n)
    writePolyMesh(case, points, cells, patchOf,
                  [(name, kind, *neighbour)
                   for name, (kind, _, *neighbour) in patches.items()],
                  place(points) if place else None)
    if zones:
        _writeZones(case, points, cells, zones)
