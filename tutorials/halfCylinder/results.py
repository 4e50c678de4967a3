"""Reads points and energies of a run of this case."""

import os
import re

import numpy as np

#: Radius [m]
R = 0.05


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


def entry(case, file, name):
    """A number of a dictionary."""
    with open(os.path.join(case, file)) as f:
        return float(re.search(rf"^\s*{name}\s+([\d.eE+-]+)", f.read(), re.M)[1])


def cellWidth(case="."):
    return R/entry(case, "system/blockMeshDict", "n")


def spent(case, time):
    """Part of the fracture energy that each point has spent: of a crack along the cells;
    maxPrincipalStress.H has the equation of the damage."""
    E, f, Gf = (entry(case, "constant/phaseProperties", k) for k in ("E", "strength", "Gf"))
    r = 2*E*Gf/(f**2*cellWidth(case))
    d = points(case, time, "damage")
    return d/(d + r*(1 - d))


def cracks(case=".", time=None):
    """Parts of the mass: damaged (the strength was reached), failed (damage 1); both on
    the left over those on the right; and length of a crack one cell wide that has the
    failed mass [m] (3D: area over the length of the body)."""
    time = time or times(case)[-1]
    x, d, m = (points(case, time, name) for name in ("x", "damage", "m"))
    left = x[:, 0] < 0
    part, ratio = {}, {}
    for name, there in (("damaged", d > 0), ("failed", d >= 1)):
        right = m[there & ~left].sum()
        part[name] = m[there].sum()/m.sum()
        ratio[name] = m[there & left].sum()/right if right else np.nan
    return part, ratio, part["failed"]*0.5*np.pi*R**2/cellWidth(case)


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
