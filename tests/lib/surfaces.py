"""Closed surfaces for regions of setMaterialPointsDict."""

import os


def prisms(case, name, polygons, low=-1.0, high=2.0):
    """constant/triSurface/<name>: convex polygons, corners (x, y) anticlockwise,
    drawn out along z."""
    triangles = []
    for corners in polygons:
        bottom, top = ([(float(x), float(y), z) for x, y in corners] for z in (low, high))
        n = len(corners)
        for i in range(1, n - 1):
            triangles += [(bottom[0], bottom[i + 1], bottom[i]), (top[0], top[i], top[i + 1])]
        for i in range(n):
            j = (i + 1) % n
            triangles += [(bottom[i], bottom[j], top[j]), (bottom[i], top[j], top[i])]
    writeTriangles(case, name, triangles)


def strip(case, name, one, other, low=-1.0, high=2.0):
    """constant/triSurface/<name>: what lies between two lines of as many corners (x, y),
    both anticlockwise around it, drawn out along z; other is the outer one."""
    (a, b), (c, d) = ([[(float(x), float(y), z) for x, y in line] for z in (low, high)]
                      for line in (one, other))
    triangles = []

    def face(p, q, r, s):
        triangles.extend(((p, q, r), (p, r, s)))

    for i in range(len(a) - 1):
        face(b[i], d[i], d[i + 1], b[i + 1])
        face(a[i], a[i + 1], c[i + 1], c[i])
        face(c[i], c[i + 1], d[i + 1], d[i])
        face(a[i + 1], a[i], b[i], b[i + 1])
    face(a[0], c[0], d[0], b[0])
    face(c[-1], a[-1], b[-1], d[-1])
    writeTriangles(case, name, triangles)


def writeTriangles(case, name, triangles):
    path = case.file("constant", "triSurface")
    os.makedirs(path, exist_ok=True)
    with open(os.path.join(path, name), "w") as f:
        f.write("solid body\n")
        for triangle in triangles:
            f.write("facet normal 0 0 0\n outer loop\n"
                    + "".join("  vertex {!r} {!r} {!r}\n".format(*v) for v in triangle)
                    + " endloop\nendfacet\n")
        f.write("endsolid body\n")


def surfaceRegion(name, **more):
    return {"type": "surface", "surface": {"type": "triSurfaceMesh", "file": f'"{name}"'},
            **more}

