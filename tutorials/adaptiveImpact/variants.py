"""In variants/: even meshes of 1 and 0.5 mm, with MPM_FINE=1 of 0.25 mm too."""

import os

from mpm.variants import runVariants

EVEN = {"even32": (32,), "even64": (64,)}


def even(case, n):
    os.remove(case.file("system/adaptiveMeshDict"))
    case.change("system/blockMeshDict", r"^nx .*", f"nx          {n};")
    case.change("system/blockMeshDict", r"^ny .*", f"ny          {2*n};")


if __name__ == "__main__":
    fine = {"even128": (128,)} if os.environ.get("MPM_FINE") else {}
    runVariants({**EVEN, **fine}, even)
