"""Writes the half-cylinder as a closed surface: radius 50 mm, round side on y = 0, flat
side up, 10 to 110 mm along z."""

import math
import os

R, Z, N = 0.05, (0.01, 0.11), 360

# Symmetric to the last digit
half = [(R*math.sin(0.5*math.pi*i/N), R*(1 - math.cos(0.5*math.pi*i/N))) for i in range(N)]
half.append((R, R))
rim = [(-x, y) for x, y in reversed(half[1:])] + half
os.makedirs("constant/triSurface", exist_ok=True)
with open("constant/triSurface/halfCylinder.stl", "w") as f:
    def facet(*corners):
        f.write("facet normal 0 0 0\nouter loop\n"
                + "".join("vertex %.16g %.16g %.16g\n" % c for c in corners)
                + "endloop\nendfacet\n")

    f.write("solid halfCylinder\n")
    for (x0, y0), (x1, y1) in zip(rim, rim[1:] + rim[:1]):
        facet((x0, y0, Z[0]), (x1, y1, Z[0]), (x1, y1, Z[1]))
        facet((x0, y0, Z[0]), (x1, y1, Z[1]), (x0, y0, Z[1]))
        facet((0, R/2, Z[0]), (x1, y1, Z[0]), (x0, y0, Z[0]))
        facet((0, R/2, Z[1]), (x0, y0, Z[1]), (x1, y1, Z[1]))
    f.write("endsolid halfCylinder\n")
