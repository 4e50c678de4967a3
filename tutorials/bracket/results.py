"""The bracket at rest as a rod in plane strain that bends, stretches and shears (Reissner
1972), clamped at its upper end, under its own weight.

With the middle line r(s), the angle theta(s) of its cross-sections, W(s) the weight beyond s
and the forces N along and V across the rod of the vector (0, -W), for a depth of 1:

    r'     = (1 + N/(E' t)) e + V/(k G t) n,   e = (cos theta, sin theta)
    theta' = 1/R + M/(E' I),   M' = W x',   M(end) = 0

E' = E/(1 - nu^2), k = 5/6; in the corner I is that of a curved bar, t e R (Winkler). Solved
by shooting with a Runge-Kutta method of fourth order.
"""

import numpy as np

T, R, LEG, ARM, G = 0.08, 0.12, 0.28, 0.36, 10.0
LENGTH = LEG + R*np.pi/2 + ARM


def rod(E, nu, rho, n=400):
    """s, x and y along the middle line; the same without load."""
    plane = E/(1 - nu**2)
    bend = plane*T**3/12
    curved = plane*T*R*(R - T/np.log((R + T/2)/(R - T/2)))
    shear = 5/6*T*E/2/(1 + nu)
    h = LENGTH/n

    def rate(s, state, load):
        _, _, theta, M = state
        W = load*rho*G*T*(LENGTH - s)
        corner = LEG < s < LEG + R*np.pi/2
        c, sn = np.cos(theta), np.sin(theta)
        stretch, slide = 1 - W*sn/(plane*T), -W*c/shear
        x = stretch*c - slide*sn
        return np.array((x, stretch*sn + slide*c,
                         corner/R + M/(curved if corner else bend), W*x))

    def shoot(M, load=1.0):
        rows = [np.array((0, 0, -np.pi/2, M))]
        for i in range(n):
            s, y = i*h, rows[-1]
            a = rate(s + 1e-9*h, y, load)
            b = rate(s + h/2, y + h/2*a, load)
            c = rate(s + h/2, y + h/2*b, load)
            d = rate(s + h*(1 - 1e-9), y + h*c, load)
            rows.append(y + h/6*(a + 2*b + 2*c + d))
        return np.array(rows)

    low, high = -2*rho*G*T*LENGTH**2, 0.0
    for _ in range(50):
        middle = 0.5*(low + high)
        if shoot(middle)[-1, 3] > 0:
            high = middle
        else:
            low = middle
    return (np.linspace(0, LENGTH, n + 1), shoot(0.5*(low + high))[:, :2],
            shoot(0.0, 0.0)[:, :2])


def tip(case, time):
    """Mean displacement of the points of the last 20 mm of the arm at the start, and their
    mean place along the rod."""
    start, end = case.points("0", "bracket"), case.points(time, "bracket")
    x = start.byId("x")
    some = x[:, 0] > R + ARM - 0.02
    return (end.byId("x") - x)[some].mean(axis=0)[:2], LENGTH - R - ARM + x[some, 0].mean()


def tipOfRod(s, *material):
    along, loaded, bare = rod(*material)
    return np.array([np.interp(s, along, (loaded - bare)[:, d]) for d in (0, 1)])


def centreOfRod(*material):
    """Displacement of the centre of mass."""
    along, loaded, bare = rod(*material)
    return np.trapz(loaded - bare, along, axis=0)/LENGTH


def rest(x):
    """Where a damped swing comes to rest: from its last three turning points, which go to
    their end by one factor (Aitken); without them the last value."""
    turns = np.flatnonzero(np.diff(np.sign(np.diff(x)))) + 1
    if len(turns) < 3:
        return x[-1]
    a, b, c = x[turns[-3:]]
    return (a*c - b*b)/(a + c - 2*b)
