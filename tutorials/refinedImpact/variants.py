"""In variants/: even meshes of 1, 0.5 and 0.25 mm, with MPM_FINE=1 of 0.125 mm too."""

import os

from mpm.variants import runVariants

EVEN = {f"even{n}": (n,) for n in (32, 64, 128)}


def even(case, n):
    case.change("system/blockMeshDict", r"^n .*", f"n           {n};")


if __name__ == "__main__":
    fine = {"even256": (256,)} if os.environ.get("MPM_FINE") else {}
    runVariants({**EVEN, **fine}, even)
