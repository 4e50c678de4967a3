"""The bar on other meshes, and the shot at 210 m/s whose outline was measured, in
variants/. With the argument fine also cells of 0.095 mm (minutes)."""

import sys

from mpm.variants import runVariants

#: cells over the radius, length of the bar [mm], cells over the length, speed [m/s]
VARIANTS = {"coarse": (10, 25.4, 66, 190), "wilkins": (20, 23.47, 122, 210)}
FINE = {"fine": (40, 25.4, 264, 190)}


def change(case, cells, length, along, speed):
    """Numbers of a variant into a copy of the case."""
    mesh, points = "system/blockMeshDict", "system/setMaterialPointsDict"
    total = int(round(7.2*cells))
    case.change(mesh, r"^nr .*", f"nr {14*cells//5};")
    case.change(mesh, r"^nx .*", f"nx {total};")
    case.change(mesh, r"^L .*", f"L {length*total/along!r};")
    case.change(points, r"max .*", f"max ({length}e-3 3.81e-3 1);")
    case.change(points, r"velocity .*", f"velocity ({-speed} 0 0);")


if __name__ == "__main__":
    if "fine" in sys.argv[1:]:
        VARIANTS.update(FINE)
    runVariants(VARIANTS, change)
