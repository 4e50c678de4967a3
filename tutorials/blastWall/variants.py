"""In variants/: cells of 5 mm, until the shock has reached the wall."""

from mpm.variants import runVariants


def refine(case):
    case.change("system/blockMeshDict", r"^n  .*", "n 2;")
    case.change("system/blockMeshDict", r"^nx .*", "nx 360;")
    case.change("system/blockMeshDict", r"^ny .*", "ny 180;")
    case.change("system/controlDict", r"^endTime .*", "endTime 0.2e-3;")


if __name__ == "__main__":
    runVariants({"fine": ()}, refine)
