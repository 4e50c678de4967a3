"""Columns of the points of a case that was written in ascii, in the order of ids."""

import os
import re

import numpy as np


def column(path):
    """A column of the points; one row per point."""
    text = open(path).read()
    text = text[text.index("FoamFile"):]
    text = text[text.index("}") + 1:]
    uniform = re.match(r"[^0-9]*(\d+)\s*\{\(?([^(){}]*)\)?\}", text)
    if uniform:
        return np.tile([float(w) for w in uniform[2].split()], (int(uniform[1]), 1))
    count = re.search(r"^(\d+)\s*\(", text, re.M)
    body = text[count.end():text.rindex(")")]
    values = np.array(body.translate(str.maketrans("()", "  ")).split(), float)
    return values.reshape(int(count[1]), -1)


def times(case="."):
    """Names of the times that have points, in order."""
    names = [d for d in os.listdir(case) if re.fullmatch(r"[0-9.]+(e-?\d+)?", d)
             and os.path.isdir(f"{case}/{d}/lagrangian")]
    return sorted(names, key=float)


def cloud(case, time, phase, *names):
    """Columns by id."""
    folder = f"{case}/{time}/lagrangian/{phase}/"
    order = np.argsort(column(folder + "id")[:, 0])
    return [np.squeeze(column(folder + name)[order]) for name in names]
