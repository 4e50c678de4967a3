"""Files .msh of gmsh: written in four kinds, read (ASCII 2.2), and the exact integrals of
their elements.

    elements = [(kind, nodes, groups), ...]     kind: "tet", ...; nodes from 0
"""

import struct

import numpy as np

#: gmsh's type, dimension, coordinates of the corners in the unit element
KINDS = {
    "line": (1, 1, [(0,), (1,)]),
    "triangle": (2, 2, [(0, 0), (1, 0), (0, 1)]),
    "quad": (3, 2, [(0, 0), (1, 0), (1, 1), (0, 1)]),
    "tet": (4, 3, [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]),
    "hex": (5, 3, [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                   (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]),
    "prism": (6, 3, [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)]),
    "pyramid": (7, 3, [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1)]),
}
VTK = {"line": 3, "triangle": 5, "quad": 9, "tet": 10, "hex": 12, "prism": 13, "pyramid": 14}


def writeMsh(path, points, elements, names, version="4.1", binary=False):
    """names: {(dim, tag): name}. In version 4.1 each set of groups is an entity."""
    def pack(f, kinds, *values):
        if binary:
            f.write(struct.pack("=" + kinds, *values))
        else:
            f.write((" ".join(repr(v) for v in values) + "\n").encode())

    def head(f):
        f.write(f"$MeshFormat\n{version} {int(binary)} 8\n".encode())
        if binary:
            f.write(struct.pack("=i", 1) + b"\n")
        f.write(b"$EndMeshFormat\n")
        if names:
            f.write(f"$PhysicalNames\n{len(names)}\n".encode())
            for (dim, tag), name in names.items():
                f.write(f'{dim} {tag} "{name}"\n'.encode())
            f.write(b"$EndPhysicalNames\n")

    # Numbers of nodes with gaps
    number = [3*i + 2 for i in range(len(points))]
    points = [[float(v) for v in x] for x in points]
    with open(path, "wb") as f:
        head(f)
        if version == "2.2":
            f.write(f"$Nodes\n{len(points)}\n".encode())
            for n, x in zip(number, points):
                pack(f, "i3d", n, *x)
            f.write(b"$EndNodes\n$Elements\n")
            rows = [(k, nodes, g) for k, nodes, groups in elements for g in groups or [0]]
            f.write(f"{len(rows)}\n".encode())
            for i, (kind, nodes, group) in enumerate(rows):
                tags, nodes = (group, 1), [number[n] for n in nodes]
                if binary:
                    pack(f, "3i", KINDS[kind][0], 1, len(tags))
                    pack(f, f"{1 + len(tags) + len(nodes)}i", i + 1, *tags, *nodes)
                else:
                    pack(f, "", i + 1, KINDS[kind][0], len(tags), *tags, *nodes)
            f.write(b"$EndElements\n")
            return
        entities = {}
        for kind, _, groups in elements:
            entities.setdefault((KINDS[kind][1], tuple(groups)), len(entities) + 5)
        f.write(b"$Entities\n")
        pack(f, "4Q", *(sum(1 for d, _ in entities if d == dim) for dim in range(4)))
        for dim in range(4):
            for (d, groups), tag in entities.items():
                if d == dim:
                    pack(f, f"i6dQ{len(groups)}iQ", tag, *(0.0,)*6, len(groups), *groups, 0)
        f.write(b"\n$EndEntities\n$Nodes\n")
        half = len(points)//2
        pack(f, "4Q", 2, len(points), min(number), max(number))
        for part in (slice(0, half), slice(half, None)):
            n = len(number[part])
            pack(f, "3iQ", 3, 5, 0, n)
            for k in number[part]:
                pack(f, "Q", k)
            for x in points[part]:
                pack(f, "3d", *x)
        f.write(b"\n$EndNodes\n$Elements\n")
        pack(f, "4Q", len(elements), len(elements), 1, len(elements))
        for i, (kind, nodes, groups) in enumerate(elements):
            dim = KINDS[kind][1]
            pack(f, "3iQ", dim, entities[dim, tuple(groups)], KINDS[kind][0], 1)
            pack(f, f"{1 + len(nodes)}Q", i + 1, *(number[n] for n in nodes))
        f.write(b"\n$EndElements\n")


def writeVtk(path, points, elements):
    with open(path, "w") as f:
        f.write("# vtk DataFile Version 2.0\nbody\nASCII\nDATASET UNSTRUCTURED_GRID\n")
        f.write(f"POINTS {len(points)} double\n")
        f.writelines(" ".join(repr(float(v)) for v in x) + "\n" for x in points)
        f.write(f"CELLS {len(elements)} {sum(len(e[1]) + 1 for e in elements)}\n")
        f.writelines(f"{len(e[1])} {' '.join(map(str, e[1]))}\n" for e in elements)
        f.write(f"CELL_TYPES {len(elements)}\n")
        f.writelines(f"{VTK[e[0]]}\n" for e in elements)


def readMsh22(path, dim):
    """Points and elements of a dimension of an ASCII file of version 2.2, with the group of
    each."""
    kinds = {t: (k, len(c)) for k, (t, d, c) in KINDS.items() if d == dim}
    points, elements, at = {}, [], None
    with open(path) as f:
        lines = [line.split() for line in f]
    for words in lines:
        if words[0].startswith("$"):
            at = words[0]
        elif at == "$Nodes" and len(words) == 4:
            points[int(words[0])] = [float(w) for w in words[1:]]
        elif at == "$Elements" and len(words) > 3 and int(words[1]) in kinds:
            kind, n = kinds[int(words[1])]
            elements.append((kind, [int(w) for w in words[-n:]], [int(words[3])]))
    place = {n: i for i, n in enumerate(points)}
    return np.array(list(points.values())), [
        (k, [place[n] for n in nodes], g) for k, nodes, g in elements]



def moments(kind, x, n=4):
    """int dV, int x dV and int x x dV of elements x [element, corner, 3 or 2] by Gauss
    points of the isoparametric map: exact for any corners. Unit triangles, tetrahedra and
    pyramids are collapsed cubes."""
    dim = KINDS[kind][1]
    g, w = np.polynomial.legendre.leggauss(n)
    g, w = 0.5*(g + 1), 0.5*w
    grid = np.array(np.meshgrid(*[g]*dim, indexing="ij")).reshape(dim, -1).T
    weight = np.prod(np.array(np.meshgrid(*[w]*dim, indexing="ij")).reshape(dim, -1), axis=0)

    # Corners of the cube to those of the element
    cube = {"triangle": (0, 1, 2, 2), "quad": (0, 1, 2, 3),
            "tet": (0, 1, 2, 2, 3, 3, 3, 3), "hex": range(8),
            "prism": (0, 1, 2, 2, 3, 4, 5, 5), "pyramid": (0, 1, 2, 3, 4, 4, 4, 4)}[kind]
    signs = np.array(KINDS["quad" if dim == 2 else "hex"][2])
    y = x[:, list(cube), :dim]
    volume, first, second = 0, 0, 0
    for xi, wi in zip(grid, weight):
        factors = np.where(signs, xi, 1 - xi)
        N = np.prod(factors, axis=1)
        dN = np.stack([np.where(signs[:, d], 1, -1)*np.prod(np.delete(factors, d, 1), axis=1)
                       for d in range(dim)], axis=1)
        J = np.linalg.det(np.einsum("ecd,cf->edf", y, dN))
        at = np.einsum("ecd,c->ed", y, N)
        volume = volume + wi*J
        first = first + (wi*J)[:, None]*at
        second = second + (wi*J)[:, None, None]*at[:, :, None]*at[:, None, :]
    sign = np.sign(volume)
    return sign*volume, sign[:, None]*first, sign[:, None, None]*second


def whole(points, elements):
    """Volume, centre and int x x dV of a mesh."""
    points = np.asarray(points, float)
    V, X, XX = 0, 0, 0
    for kind in {e[0] for e in elements}:
        nodes = np.array([e[1] for e in elements if e[0] == kind])
        v, x, xx = moments(kind, points[nodes])
        V, X, XX = V + v.sum(), X + x.sum(axis=0), XX + xx.sum(axis=0)
    return V, X/V, XX
