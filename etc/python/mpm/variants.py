"""Copies of a case with changes, run in variants/."""

import os
import sys

from mpm.case import Case, RunFailed


def variant(name):
    """The case of a variant; of "." the case itself."""
    return Case("." if name == "." else os.path.join("variants", name))


def changeFiles(case, *rows):
    """Rows of file, pattern and text (Case.change)."""
    for row in rows:
        case.change(*row)


def runVariants(variants, start, change=changeFiles, startValues=None):
    """Run variants, each with change(case, *arguments).

    variants       name: arguments
    start          names of the files of 0 that a copy needs
    startValues    called for the case when setMaterialPoints has made its points

    The script ends where one fails."""
    for name, arguments in variants.items():
        case = variant(name)
        try:
            case.copy(start)
            change(case, *arguments)
            print(f"Running {case.path}", flush=True)
            case.run("blockMesh")
            case.run("setMaterialPoints")
            if startValues:
                startValues(case)
            case.run("materialPointFoam")
        except RunFailed as error:
            sys.exit(f"{os.path.basename(sys.argv[0])}: {error}")
