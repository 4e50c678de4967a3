"""In variants/: all cells fine from the start, an even mesh."""

import os

from mpm.variants import runVariants


def fine(case):
    os.remove(case.file("system/adaptiveMeshDict"))
    for n, cells in (("nx", 52), ("ny", 36), ("nz", 28)):
        case.change("system/blockMeshDict", rf"^{n} .*", f"{n} {cells};")


if __name__ == "__main__":
    runVariants({"fine": ()}, fine)
