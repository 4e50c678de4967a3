"""The cases as arrays: fields on the cells as rows of the mesh, points, logs."""

import os
import re

import numpy as np

NUMBER = r"([-+\d.e]+)"


def times(case):
    """Names of the time folders in order."""
    names = [n for n in os.listdir(case) if re.fullmatch(r"\d[\d.]*(e-\d+)?", n)]
    return sorted(names, key=float)


def values(path):
    """All values of a file that OpenFOAM wrote in binary, or one if uniform."""
    with open(path, "rb") as f:
        raw = f.read()
    head = raw.index(b"}") + 1
    field = re.compile(rb"(?:internalField|value)\s+(uniform|nonuniform)").search(raw, head)
    if field and field[1] == b"uniform":
        text = raw[field.end():raw.index(b";", field.end())]
        return np.array(text.translate(None, b"()").split(), float)[None, :]
    size = {b"scalar": 1, b"vector": 3}[
        re.search(rb"class\s+\w*?(scalar|vector|Scalar|Vector)", raw)[1].lower()]
    count = re.compile(rb"(\d+)\s*\(").search(raw, field.end() if field else head)
    return np.frombuffer(raw, "f8", size*int(count[1]), count.end()).reshape(-1, size)


def cells(case, time, name, nx, ny):
    """A field on the cells, [row along y, column along x(, component)]."""
    v = values(os.path.join(case, time, name))
    return np.broadcast_to(v, (nx*ny, v.shape[1])).reshape(ny, nx, -1).squeeze()


def points(case, time, phase, name):
    return values(os.path.join(case, time, "lagrangian", phase, name)).squeeze()


def log(case, pattern):
    """All numbers N of the lines of the log that have the pattern."""
    with open(os.path.join(case, "log.materialPointFoam")) as f:
        return np.array(re.findall(pattern.replace("N", NUMBER), f.read(), re.M), float)


def fixups(case):
    return log(case, "outflow limited N, theta kept N, isentropic N ")[-1].sum()
