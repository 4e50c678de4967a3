"""Reads points and loads of a run of this case."""

import re

import numpy as np

from mpm.case import Case

EXACT = np.pi*0.5*700       # pi R sigma_t [N/m]


def loads(case="."):
    """Times of the reports, force [N/m] of the upper and on the lower jaw: mean since
    the report before; kinetic and stored energy [J/m]; residual and
    remap of the energy [J/m]."""
    rows = []
    for text in re.split(r"^Time = ", Case(case).log(), flags=re.M)[1:]:
        impulse = dict(re.findall(r"^Contact (\w+) .*impulse \(\S+ (\S+) ", text, re.M))
        energy = re.search(r"^Energy: kinetic (\S+), strain (\S+),", text, re.M)
        rest = re.findall(r"(?:residual|remap) ([^\s,]+)", text)
        if impulse and energy:
            rows.append([text.split()[0], impulse["top"], impulse["bottom"],
                         energy[1], energy[2], sum(map(float, rest))])
    t, top, bottom, kinetic, strain, residual = np.array(rows, float).T
    dt = np.diff(t)
    return (t[1:], abs(np.diff(top))/dt, abs(np.diff(bottom))/dt,
            kinetic[1:], strain[1:], residual[1:])


def firstDamage(case="."):
    """Time, and place of the damaged points' centre (weighted by damage), of the first
    written time that has damage; number of points, their largest distance from (0, 0)."""
    for time in Case(case).times("lagrangian"):
        disc = Case(case).points(time, "disc")
        damage = disc["damage"]
        if damage.max() > 0:
            x = disc["x"][:, :2]
            return (float(time), damage @ x/damage.sum(), int((damage > 0).sum()),
                    np.hypot(*x[damage > 0].T).max())
    return None


def tension(rho, alpha=0.11):
    """Hondros (1959): tension across the loaded diameter at the distance rho R from the
    centre, loads spread evenly over arcs of 2 alpha; over P/(pi R)."""
    a = (1 - rho**2)*np.sin(2*alpha)/(1 - 2*rho**2*np.cos(2*alpha) + rho**4)
    return (a - np.arctan((1 + rho**2)/(1 - rho**2)*np.tan(alpha)))/np.sin(alpha)
