"""A block between two radii, of half-angle a, that slides in a pipe of radius ro: the exact
compound pendulum, with Coulomb friction of an even pressure.

    t, theta, rate, arm = slidingSector(a, ri, ro, theta0, mu, end)

The centre of mass is arm from the pipe's axis.
"""

import math

import numpy as np

G = 9.81


def slidingSector(a, ri, ro, theta0, mu, end, n=20000):
    arm = 2*(ro**3 - ri**3)/3*math.sin(a)/a/(ro**2 - ri**2)
    inertia = (ro**2 + ri**2)/2

    def rate(y):
        theta, w = y
        normal = G*math.cos(theta) + arm*w**2
        return np.array((w, -(G*arm*math.sin(theta)
                              + np.sign(w)*mu*ro*normal*a/math.sin(a))/inertia))

    t, y = np.linspace(0, end, n + 1), np.empty((n + 1, 2))
    y[0] = theta0, -1e-9
    h = end/n
    for i in range(n):
        k1 = rate(y[i])
        k2 = rate(y[i] + h/2*k1)
        k3 = rate(y[i] + h/2*k2)
        k4 = rate(y[i] + h*k3)
        y[i + 1] = y[i] + h/6*(k1 + 2*k2 + 2*k3 + k4)
    return t, y[:, 0], y[:, 1], arm


def turningPoints(time, speed):
    """When the block turns, of a quantity with the sign of its speed."""
    late = time > 0.1
    t, v = time[late], speed[late]
    at = np.flatnonzero(v[1:]*v[:-1] < 0)
    return t[at] - v[at]*(t[at + 1] - t[at])/(v[at + 1] - v[at])
