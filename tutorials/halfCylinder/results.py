"""Reads points and energies of a run of this case."""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.environ["MPM_PROJECT_DIR"], "tests/lib"))
from foamCase import readField

#: Radius [m]
R = 0.05


def times(case="."):
    """Names of the time folders with points, in order."""
    names = [n for n in os.listdir(case) if re.fullmatch(r"\d[\d.]*(e-\d+)?", n)
             and os.path.isdir(os.path.join(case, n, "lagrangian"))]
    return sorted(names, key=float)


def points(case, time, name):
    """A column of the points."""
    return readField(os.path.join(case, time, "lagrangian/body", name))


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
