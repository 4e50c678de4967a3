"""In variants/: 1mm and 0.5mm, the same on finer cells; those that have ended are kept.
Arguments: names of those to run (all)."""

import sys

from mpm.variants import runVariants

CELLS = {"1mm": "(160 90 1)", "0.5mm": "(320 180 1)"}


def change(case, cells):
    case.change("system/blockMeshDict", r"^cells .*", f"cells   {cells};")


if __name__ == "__main__":
    runVariants({name: (CELLS[name],) for name in sys.argv[1:] or CELLS}, change)
