"""Reads points and energies of a run of this case."""

import re

import numpy as np

from mpm.case import Case

#: Radius [m]
R = 0.05


def times(case="."):
    """Names of the time folders with points, in order."""
    return Case(case).times("lagrangian")


def points(case, time, name):
    """A column of the points."""
    return Case(case).points(time, "body")[name]


def cellWidth(case="."):
    return R/Case(case).entry("system/blockMeshDict", "n")


def spent(case, time):
    """Part of the fracture energy that each point has spent: of a crack along the cells;
    maxPrincipalStress.C has the equation of the damage."""
    E, f, Gf = (Case(case).entry("constant/phaseProperties", k)
                for k in ("E", "strength", "Gf"))
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
    columns = Case(case).series("energy", "energy.dat").T
    with open(Case(case).file("postProcessing/energy/0/energy.dat")) as f:
        table = dict(zip(re.findall(r"(\w+)\[\w+\]", f.readlines()[1]), columns))
    m = points(case, "0", "m")
    return table, 0.5*m.sum()*8.474**2


def floor(case="."):
    """Times of the reports; force of the floor [N], mean since the report before."""
    t, J = Case(case).numbers(r"(?s)^Time = N(?:(?!^Time).)*?^Contact floor .*?impulse "
                              r"\(\S+ N ").T
    return t[1:], -np.diff(J)/np.diff(t)
