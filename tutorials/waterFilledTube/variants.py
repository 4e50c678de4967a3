"""In variants/: 1mm and 0.5mm, the same on finer cells; those that have ended are kept.
Arguments: names of those to run (all)."""

import os
import shutil
import sys

from mpm.variants import runVariants

CELLS = {"1mm": "(160 90 1)", "0.5mm": "(320 180 1)"}


def ended(path):
    """Has the folder a run that came to its end?"""
    log = os.path.join(path, "log.materialPointFoam")
    if not os.path.exists(log):
        return False
    with open(log, errors="replace") as f:
        return "\nEnd\n" in f.read()


def change(case, cells):
    for name in os.listdir("0.orig"):
        shutil.copy(os.path.join("0.orig", name), case.file("0"))
    case.change("system/blockMeshDict", r"^cells .*", f"cells   {cells};")


if __name__ == "__main__":
    runVariants({name: (CELLS[name],) for name in sys.argv[1:] or CELLS
                 if not ended(os.path.join("variants", name))}, (), change,
                lambda case: case.run("setFluids"))
