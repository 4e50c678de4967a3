"""In variants/: all cells fine from the start, an even mesh."""

import os
import shutil

from mpm.variants import runVariants


def fine(case):
    for name in os.listdir("0.orig"):
        shutil.copy(os.path.join("0.orig", name), case.file("0"))
    os.remove(case.file("system/adaptiveMeshDict"))
    for n, cells in (("nx", 52), ("ny", 36), ("nz", 28)):
        case.change("system/blockMeshDict", rf"^{n} .*", f"{n} {cells};")


if __name__ == "__main__":
    runVariants({"fine": ()}, (), fine, lambda case: case.run("setFields"))
