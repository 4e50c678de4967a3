"""Copies of a tutorial with changes, run in variants/: a study over names."""

import os
import sys

from mpm.case import Case
from mpm.study import RECORD, Study


def variant(name):
    """The case of a variant; of "." the case itself."""
    return Case("." if name == "." else os.path.join("variants", name))


def ended(name):
    """Has a variant a run that came to its end?"""
    return os.path.exists(variant(name).file(RECORD))


def changeFiles(case, *rows):
    """Rows of file, pattern and text (Case.change)."""
    for row in rows:
        case.change(*row)


def runVariants(variants, change=changeFiles, startValues=None):
    """Run variants, {name: arguments}, each with change(case, *arguments); those that have
    ended are kept.

    startValues    called for the case when it has its mesh, fluids and points

    The script ends with the error of those that fail."""
    def steps(case):
        case.prepare()
        if startValues:
            startValues(case)
        case.run("materialPointFoam")

    rows = Study(".", {"variant": (lambda case, arguments: change(case, *arguments), variants)},
                 {}, folder="variants", steps=steps).run(1).rows
    failed = [f"{row['variant']}: {row['state']}" for row in rows
              if row["state"].startswith("failed")]
    if failed:
        sys.exit("\n".join(f"{os.path.basename(sys.argv[0])}: {text}" for text in failed))
