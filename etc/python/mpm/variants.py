"""Copies of a case with changes, run in variants/."""

import os
import sys

from mpm.case import Case, RunFailed


def variant(name):
    """The case of a variant; of "." the case itself."""
    return Case("." if name == "." else os.path.join("variants", name))


def runVariants(changes, start, startValues=None):
    """Run variants. changes: name and what to do to the copy, a function of the case or
    rows of file, pattern and text; start: files of 0 that a copy needs; startValues: called
    for the case when its points are there. The script ends where one fails."""
    for name, change in changes.items():
        case = variant(name)
        try:
            case.copy(start)
            if callable(change):
                change(case)
            else:
                for row in change:
                    case.change(*row)
            print(f"Running {case.path}", flush=True)
            case.run("blockMesh")
            case.run("setMaterialPoints")
            if startValues:
                startValues(case)
            case.run("materialPointFoam")
        except RunFailed as error:
            sys.exit(f"{os.path.basename(sys.argv[0])}: {error}")
