"""Reads points and energies of a run of this case."""

import os
import re

import numpy as np


def times(case="."):
    """Names of the time folders with points, in order."""
    names = [n for n in os.listdir(case) if re.fullmatch(r"\d[\d.]*(e-\d+)?", n)
             and os.path.isdir(os.path.join(case, n, "lagrangian"))]
    return sorted(names, key=float)


def points(case, time, name):
    """A column of the points, binary or one value for all."""
    with open(os.path.join(case, time, "lagrangian/body", name), "rb") as f:
        raw = f.read()
    size = {b"scalar": 1, b"vector": 3, b"symmTensor": 6}[
        re.search(rb"class\s+(scalar|vector|symmTensor)Field", raw)[1]]
    body = re.compile(rb"FoamFile\s*\{.*?\}(?:\s*//[^\n]*\n)*\s*", re.S).search(raw).end()
    uniform = re.compile(rb"(\d+)\{\(?([^(){}]*)\)?\}").match(raw, body)
    if uniform:
        return np.tile(np.array(uniform[2].split(), float), (int(uniform[1]), 1)).squeeze()
    count = re.compile(rb"(\d+)\s*\(").match(raw, body)
    return np.frombuffer(raw, "f8", size*int(count[1]), count.end()).reshape(-1, size).squeeze()


def damaged(case=".", time=None):
    """Parts of the mass: failed (damage 1), damaged at all; failed mass on the left over
    that on the right."""
    time = time or times(case)[-1]
    x, d, m = (points(case, time, name) for name in ("x", "damage", "m"))
    failed, left = d >= 1, x[:, 0] < 0
    right = m[failed & ~left].sum()
    return (m[failed].sum()/m.sum(), m[d > 0].sum()/m.sum(),
            m[failed & left].sum()/right if right else np.nan)


def energy(case="."):
    """Columns of the energy budget by name, and what the body had at the start."""
    path = os.path.join(case, "postProcessing/energy/0/energy.dat")
    with open(path) as f:
        names = re.findall(r"(\w+)\[\w+\]", f.readlines()[1])
    table = dict(zip(names, np.loadtxt(path).T))
    m = points(case, "0", "m")
    return table, 0.5*m.sum()*8.474**2


def floor(case="."):
    """Times of the reports; force of the floor [N], mean since the report before."""
    with open(os.path.join(case, "log.materialPointFoam")) as f:
        rows = re.findall(r"^Time = (\S+)(?:(?!^Time).)*?^Contact floor .*?impulse "
                          r"\(\S+ (\S+) ", f.read(), flags=re.M | re.S)
    t, J = np.array(rows, float).T
    return t[1:], -np.diff(J)/np.diff(t)
