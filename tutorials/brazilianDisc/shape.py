"""Writes the disc of radius 0.5 m as closed surfaces: body.stl between y = -0.375 m and
0.375 m, caps.stl the rest."""

import math
import os

R, Y, N = 0.5, 0.375, 180
TOP = math.asin(Y/R)


def prism(f, rim):
    """A convex polygon, drawn out from z = 0 to 1."""
    middle = [sum(c)/len(rim) for c in zip(*rim)]

    def facet(*corners):
        f.write("facet normal 0 0 0\nouter loop\n"
                + "".join("vertex %.16g %.16g %.16g\n" % c for c in corners)
                + "endloop\nendfacet\n")

    for (x0, y0), (x1, y1) in zip(rim, rim[1:] + rim[:1]):
        facet((x0, y0, 0), (x1, y1, 0), (x1, y1, 1))
        facet((x0, y0, 0), (x1, y1, 1), (x0, y0, 1))
        facet((*middle, 0), (x1, y1, 0), (x0, y0, 0))
        facet((*middle, 1), (x0, y0, 1), (x1, y1, 1))


def arc(low, high):
    angles = [low + (high - low)*i/N for i in range(N + 1)]
    return [(R*math.cos(a), R*math.sin(a)) for a in angles]


os.makedirs("constant/triSurface", exist_ok=True)
for name, rims in (
        ("body", [arc(-TOP, TOP) + arc(math.pi - TOP, math.pi + TOP)]),
        ("caps", [arc(TOP, math.pi - TOP), arc(math.pi + TOP, 2*math.pi - TOP)])):
    with open(f"constant/triSurface/{name}.stl", "w") as f:
        f.write(f"solid {name}\n")
        for rim in rims:
            prism(f, rim)
        f.write(f"endsolid {name}\n")
