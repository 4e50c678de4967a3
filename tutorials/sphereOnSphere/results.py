"""Force of the spheres on each other, beside Hertz.

    F = K d^(3/2),   K = 4/3 E* sqrt(R*),   1/E* = 2 (1 - nu^2)/E,   R* = R/2

with the approach d. Bodies of reduced mass M that meet with V, M d'' = -F, come as close
as d1 = (5 M V^2/(4 K))^(2/5) and part after 2.943 d1/V.
"""

import re

import numpy as np

R, GAP, SPEED = 0.01, 4e-5, 0.92
E, NU, RHO = 1e7, 0.3, 1000.0

K = 4/3*E/(2*(1 - NU**2))*np.sqrt(R/2)
MASS = 4/3*np.pi*R**3*RHO/2
APPROACH = (5*MASS*SPEED**2/(4*K))**0.4
FORCE = K*APPROACH**1.5


def hertz(n=20000):
    """Times from the first touch, approach, force."""
    t = np.linspace(0, 3.2*APPROACH/SPEED, n)
    d, V, dt = np.zeros(n), SPEED, t[1]
    for i in range(1, n):
        V -= K*max(d[i - 1], 0)**1.5/MASS*dt
        d[i] = d[i - 1] + V*dt
    return t, d, K*np.maximum(d, 0)**1.5


def motion(case):
    """Times, approach and force of the whole spheres, from the log's lines of the contact of
    their quarters."""
    number = r"([-+\d.e]+)"
    rows = np.array(re.findall(
        rf"^Time = {number}(?:(?!^Time).)*?^Contact spheres .*? force \(\S+ \S+ {number}\) N,"
        rf" impulse \(\S+ \S+ {number}\)", case.log(), flags=re.M | re.S), float)
    t, F, J = rows[:, 0], -4*rows[:, 1], -4*rows[:, 2]
    V = SPEED - J/MASS
    d = V[0]*t[0] - GAP + np.append(0, np.cumsum(0.5*(V[1:] + V[:-1])*np.diff(t)))
    return t, d, F


def duration(t, F):
    """Time from where the force is 2 % of Hertz's largest to where it is that again."""
    low = 0.02*FORCE
    on = np.flatnonzero(F > low)
    first = np.interp(low, F[on[0] - 1:on[0] + 1], t[on[0] - 1:on[0] + 1])
    last = np.interp(-low, -F[on[-1]:on[-1] + 2], t[on[-1]:on[-1] + 2])
    return last - first


def figures(case):
    """Rows of quantity, unit, Hertz's, ours."""
    t, d, F = motion(case)
    exact = hertz()
    return [("largest force", "N", FORCE, F.max()),
            ("closest approach", "mm", 1e3*APPROACH, 1e3*d.max()),
            ("time of contact", "ms", 1e3*duration(exact[0], exact[2]), 1e3*duration(t, F)),
            ("speed after it over that before", "", 1.0,
             -(d[-1] - d[-11])/(t[-1] - t[-11])/SPEED)]
