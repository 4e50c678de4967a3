"""The rod of rod.msh: its mass, centre and inertia from the tetrahedra, and its free flight
by Euler's equations.

Of a tetrahedron with corners a_i and volume V: mass rho V, centre the mean of a_i,

    int x x^T dV = V/20 (sum_i a_i a_i^T + (sum_i a_i)(sum_i a_i)^T)

Flight: I dw/dt = -w x I w in axes of the body, dQ/dt = Q [w x], Runge-Kutta of fourth order.
"""

import numpy as np

RHO, SPEED, SPIN = 7800.0, np.array((0, 0, -3.0)), np.array((25.0, 35.0, 15.0))


def tetrahedra(path, scale=1e-3):
    """Corners [m] of the tetrahedra of a file .msh of version 2."""
    nodes, found = {}, []
    with open(path) as f:
        for words in map(str.split, f):
            if len(words) == 4:
                nodes[words[0]] = [scale*float(w) for w in words[1:]]
            elif len(words) > 6 and words[1] == "4":
                found.append([nodes[n] for n in words[-4:]])
    return np.array(found)


def spread(xx):
    """Tensor of inertia from int x x^T dm."""
    return np.trace(xx)*np.eye(3) - xx


def massOf(corners):
    """Mass, centre, inertia about it."""
    a = corners
    V = np.abs(np.linalg.det(a[:, 1:] - a[:, :1]))/6
    m, s = RHO*V.sum(), a.sum(axis=1)
    c = V@s/4/V.sum()
    xx = RHO*(np.einsum("t,tci,tcj->ij", V, a, a) + np.einsum("t,ti,tj->ij", V, s, s))/20
    return m, c, spread(xx - m*np.outer(c, c))


def massOfPoints(cloud):
    """The same of points without a size."""
    m, x = cloud["m"], cloud["x"]
    c = m@x/m.sum()
    return m.sum(), c, spread(np.einsum("p,pi,pj->ij", m, x - c, x - c))


def flight(inertia, end, n=4000):
    """Matrix of the rotation after a time without forces."""
    def rate(Q, w):
        W = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
        return Q@W, np.linalg.solve(inertia, -np.cross(w, inertia@w))
    Q, w, h = np.eye(3), SPIN.copy(), end/n
    for _ in range(n):
        a = rate(Q, w)
        b = rate(Q + h/2*a[0], w + h/2*a[1])
        c = rate(Q + h/2*b[0], w + h/2*b[1])
        d = rate(Q + h*c[0], w + h*c[1])
        Q, w = (v + h/6*(a[i] + 2*b[i] + 2*c[i] + d[i]) for i, v in enumerate((Q, w)))
    return Q


def turned(case, time):
    """Largest distance of the points from where Euler's equations with the inertia of the mesh
    bring them [m], and their largest way by the rotation."""
    m, c, inertia = massOf(tetrahedra(case.file("rod.msh")))
    x = case.points("0", "rod").byId("x") - c
    Q = flight(inertia, float(time))
    there = case.points(time, "rod").byId("x") - c - SPEED*float(time)
    return (np.linalg.norm(there - x@Q.T, axis=1).max(),
            np.linalg.norm(x@Q.T - x, axis=1).max())


def motion(case, time, phases=("rod", "pad")):
    """Momentum and angular momentum about the origin."""
    p, L = np.zeros(3), np.zeros(3)
    for phase in phases:
        cloud = case.points(time, phase)
        mu = cloud["m"][:, None]*cloud["U"]
        p, L = p + mu.sum(axis=0), L + np.cross(cloud["x"], mu).sum(axis=0)
    return p, L
