"""In variants/: cells of 5 mm, until the shock has reached the wall."""

import os
import shutil

from mpm.variants import runVariants


def refine(case):
    for name in os.listdir("0.orig"):
        shutil.copy(os.path.join("0.orig", name), case.file("0"))
    case.change("system/blockMeshDict", r"^n  .*", "n 2;")
    case.change("system/blockMeshDict", r"^nx .*", "nx 360;")
    case.change("system/blockMeshDict", r"^ny .*", "ny 180;")
    case.change("system/controlDict", r"^endTime .*", "endTime 0.2e-3;")


if __name__ == "__main__":
    runVariants({"fine": ()}, (), refine, lambda case: case.run("setFields"))
