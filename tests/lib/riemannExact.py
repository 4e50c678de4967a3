"""Exact solution of the Riemann problem of a perfect gas.

    p, u = star(left, right)                   # star state; left = (rho, u, p)
    rho, u, p = solution(left, right, x/t)     # arrays

Star pressure by Newton's method on the sum of both waves' velocity jumps
(E.F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, chapter 4).
"""

import numpy as np

SOD = ((1.0, 0.0, 1.0), (0.125, 0.0, 0.1))
TEST123 = ((1.0, -2.0, 0.4), (1.0, 2.0, 0.4))


def _jump(p, state, gamma):
    """Velocity jump over a wave to the pressure p, and its derivative."""
    rho, _, p0 = state
    if p > p0:
        a, b = 2/((gamma + 1)*rho), (gamma - 1)/(gamma + 1)*p0
        root = np.sqrt(a/(p + b))
        return (p - p0)*root, root*(1 - 0.5*(p - p0)/(p + b))
    c = np.sqrt(gamma*p0/rho)
    z = (gamma - 1)/(2*gamma)
    return 2*c/(gamma - 1)*((p/p0)**z - 1), (p/p0)**(-(gamma + 1)/(2*gamma))/(rho*c)


def star(left, right, gamma=1.4):
    """Pressure and velocity between the waves."""
    du = right[1] - left[1]
    z = (gamma - 1)/(2*gamma)
    cl, cr = (np.sqrt(gamma*s[2]/s[0]) for s in (left, right))
    p = ((cl + cr - 0.5*(gamma - 1)*du)
         /(cl/left[2]**z + cr/right[2]**z))**(1/z)
    for _ in range(100):
        (fl, dl), (fr, dr) = _jump(p, left, gamma), _jump(p, right, gamma)
        new = max(p - (fl + fr + du)/(dl + dr), 1e-3*p)
        done = abs(new - p) <= 1e-15*p
        p = new
        if done:
            break
    fl, fr = _jump(p, left, gamma)[0], _jump(p, right, gamma)[0]
    return p, 0.5*(left[1] + right[1] + fr - fl)


def starDensity(state, p, gamma=1.4):
    """Density behind the wave into a state."""
    rho, _, p0 = state
    if p > p0:
        m = (gamma - 1)/(gamma + 1)
        return rho*(p/p0 + m)/(m*p/p0 + 1)
    return rho*(p/p0)**(1/gamma)


def solution(left, right, s, gamma=1.4):
    """Density, velocity, pressure on the rays s = x/t."""
    s = np.asarray(s, float)
    ps, us = star(left, right, gamma)
    rho, u, p = (np.empty_like(s) for _ in range(3))
    for state, sign in ((left, -1), (right, 1)):
        side = s <= us if sign < 0 else s > us
        r0, u0, p0 = state
        c = np.sqrt(gamma*p0/r0)
        rs = starDensity(state, ps, gamma)
        if ps > p0:
            speed = u0 + sign*c*np.sqrt((gamma + 1)/(2*gamma)*ps/p0
                                        + (gamma - 1)/(2*gamma))
            outside = side & (sign*(s - speed) > 0)
            inside = side & ~outside
            fan = np.zeros_like(side)
        else:
            cs = np.sqrt(gamma*ps/rs)
            head, tail = u0 + sign*c, us + sign*cs
            outside = side & (sign*(s - head) > 0)
            inside = side & (sign*(s - tail) < 0)
            fan = side & ~outside & ~inside
        rho[outside], u[outside], p[outside] = r0, u0, p0
        rho[inside], u[inside], p[inside] = rs, us, ps
        k = (2 - sign*(gamma - 1)*(u0 - s[fan])/c)/(gamma + 1)
        rho[fan] = r0*k**(2/(gamma - 1))
        p[fan] = p0*k**(2*gamma/(gamma - 1))
        u[fan] = s[fan] - sign*c*k
    return rho, u, p
