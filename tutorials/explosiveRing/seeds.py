"""In variants/: <cells>-<seed>, eight scatters of the ring's strength on two meshes, with the
same points in both; filled, with a charge that fills the ring. Arguments: the first part of
names of those to run (all)."""

import sys

from mpm.variants import runVariants

#: Cells along a side: points along each of their sides. The scatter is that of points: they
#: have one size
CELLS, SEEDS = {120: 3, 180: 2}, range(1, 9)
VARIANTS = {
    **{f"{n}-{seed}": (n, points, seed) for n, points in CELLS.items() for seed in SEEDS},
    "filled": (120, 3, 1, "filled")}


def change(case, n, points, seed, what=None):
    case.change("system/blockMeshDict", r"^n  .*", f"n       {n};")
    case.change("system/setMaterialPointsDict", r"pointsPerCell .*;", f"pointsPerCell   {points};")
    case.change("constant/phaseProperties", r"seed .*;", f"seed            {seed};")
    if what == "filled":
        case.change("system/setFluidsDict", r"radius .*;", "radius  0.04;")
        case.change("system/controlDict", r"^endTime .*", "endTime 4e-5;")


if __name__ == "__main__":
    names = [name for name in VARIANTS
             if not sys.argv[1:] or name.split("-")[0] in sys.argv[1:]]
    runVariants({name: VARIANTS[name] for name in names}, change)
