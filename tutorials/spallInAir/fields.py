"""The case as arrays: fields on the cells as rows of the mesh, points, logs."""

import os
import re

import numpy as np

H, STRESS = 1.9e-3, 687.39e6    # flyer [m], rho c v/2 [Pa]
WIDTH = 7.6e-3                  # plates, from -WIDTH/2


def times(case):
    """Names of the time folders in order."""
    names = [n for n in os.listdir(case) if re.fullmatch(r"\d[\d.]*(e-\d+)?", n)]
    return sorted(names, key=float)


def nearest(case, wanted):
    return min(times(case), key=lambda name: abs(float(name) - wanted))


def mesh():
    """Cells along x and y and the sides of the cells [m]."""
    with open("system/blockMeshDict") as f:
        text = f.read()
    number = {k: float(v) for k, v in re.findall(r"^(n[xy]|[xy][01])\s+([-\d.]+);", text, re.M)}
    nx, ny = int(number["nx"]), int(number["ny"])
    return (nx, ny, 1e-3*np.linspace(number["x0"], number["x1"], nx + 1),
            1e-3*np.linspace(number["y0"], number["y1"], ny + 1))


def values(path):
    """All values of a file that OpenFOAM wrote in binary, or one if uniform."""
    with open(path, "rb") as f:
        raw = f.read()
    head = raw.index(b"}") + 1
    field = re.compile(rb"(?:internalField|value)\s+(uniform|nonuniform)").search(raw, head)
    if field and field[1] == b"uniform":
        text = raw[field.end():raw.index(b";", field.end())]
        return np.array(text.translate(None, b"()").split(), float)[None, :]
    size = {b"scalar": 1, b"vector": 3, b"symmTensor": 6}[
        re.search(rb"class\s+\w*?(scalar|vector|symmTensor|Scalar|Vector)",
                  raw)[1].lower().replace(b"symmt", b"symmT")]
    count = re.compile(rb"(\d+)\s*\(").search(raw, field.end() if field else head)
    return np.frombuffer(raw, "f8", size*int(count[1]), count.end()).reshape(-1, size)


def cells(case, time, name):
    """A field on the cells, [row along y, column along x(, component)]."""
    nx, ny, _, _ = mesh()
    v = values(os.path.join(case, time, name))
    return np.broadcast_to(v, (nx*ny, v.shape[1])).reshape(ny, nx, -1).squeeze()


def points(case, time, phase, name):
    return values(os.path.join(case, time, "lagrangian", phase, name)).squeeze()


def record(case, folder, name):
    """Table of a function object."""
    with open(os.path.join(case, "postProcessing", folder, "0", name)) as f:
        return np.array([re.sub("[()]", " ", line).split() for line in f
                         if not line.startswith("#")], float)


def log(case):
    with open(os.path.join(case, "log.materialPointFoam")) as f:
        return f.read()


def crossing(t, f, level, after=0.8e-6):
    """First time at which f rises through the level; linear between the steps."""
    i = np.where((t > after) & (f >= level))[0][0]
    return t[i - 1] + (level - f[i - 1])/(f[i] - f[i - 1])*(t[i] - t[i - 1])


def firstFailure(case):
    t, damage = record(case, "failure", "damage.dat").T
    return t[np.argmax(damage > 0)]


def crack(case):
    """Cells within two cells of a failed point of the last time."""
    nx, ny, x, y = mesh()
    last = times(case)[-1]
    at = points(case, last, "target", "x")[points(case, last, "target", "damage") > 0.5]
    column, row = np.searchsorted(x, at[:, 0]) - 1, np.searchsorted(y, at[:, 1]) - 1
    found = np.zeros((ny, nx), bool)
    for i in range(-2, 3):
        for j in range(-2, 3):
            found[np.clip(row + j, 0, ny - 1), np.clip(column + i, 0, nx - 1)] = True
    return found


def crackMass(case):
    """Times, gas mass of the crack within 6 cells of the plate's free edges over
    what it was at first failure (linear between the written times)."""
    _, _, x, _ = mesh()
    middle = abs(0.5*(x[1:] + x[:-1]))
    band = crack(case) & (middle < WIDTH/2) & (middle > WIDTH/2 - 6*(x[1] - x[0]))
    names = [n for n in times(case) if float(n) > 0]
    t = np.array([float(n) for n in names])
    mass = np.array([cells(case, n, "thetaRho.air")[band].sum() for n in names])
    return t, mass/np.interp(firstFailure(case), t, mass)
