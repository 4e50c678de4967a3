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

