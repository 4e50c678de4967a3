"""Riemann problem of any equation of state p = A(rho) + B(rho) e, numerically exact.

    water = StiffenedGas(4.4, 6e8)
    exact = Riemann(water, left, right, lowest)      # left = (rho, u, p)
    exact = Riemann((water, air), left, right, lowest)      # two fluids
    exact.p, exact.u, exact.rhoL, exact.rhoR         # between the waves
    rho, u, p = exact.at(x/t)                        # arrays

Shocks by the jump conditions: e - e0 = (p + p0)(1/rho0 - 1/rho)/2 is linear in p, so
that the Hugoniot is p(rho) in closed form; without energy (B = 0) p = A(rho). Fans
by the equations of the isentrope along the pressure,

    drho/dp = 1/c^2,   de/dp = p/(rho c)^2,   du/dp = -+ 1/(rho c),

with Runge and Kutta's steps of fourth order (their error against closed forms is a row
of tests/cases/riemannEquations). Where both velocities agree is found by bisection
between the lowest pressure that both isentropes have and one above all.
"""

import numpy as np


class Equation:
    """of(rho): A, B, dA, dB as in equationOfState.H; written again from the formulas."""

    def pressure(self, rho, e):
        a, b, _, _ = self.of(rho)
        return a + b*e

    def energy(self, rho, p):
        a, b, _, _ = self.of(rho)
        return (p - a)/b if b else 0.0

    def c(self, rho, e):
        a, b, da, db = self.of(rho)
        return np.sqrt(da + e*db + (a + b*e)*b/rho**2)


class StiffenedGas(Equation):
    def __init__(self, gamma, pInf=0.0):
        self.gamma, self.pInf = gamma, pInf

    def of(self, rho):
        return -self.gamma*self.pInf, (self.gamma - 1)*rho, 0.0, self.gamma - 1


class Tait(Equation):
    def __init__(self, K, n, p0, rho0):
        self.K, self.n, self.p0, self.rho0 = K, n, p0, rho0

    def of(self, rho):
        x = (rho/self.rho0)**self.n
        return self.p0 + self.K/self.n*(x - 1), 0.0, self.K*x/rho, 0.0


class Linear(Equation):
    def __init__(self, K, rho0):
        self.K, self.rho0 = K, rho0

    def of(self, rho):
        return self.K*(rho/self.rho0 - 1), 0.0, self.K/self.rho0, 0.0


class MieGrueneisen(Equation):
    """dA by differences of A: the formula of the code is not written down twice."""

    def __init__(self, C0, S, Gamma0, rho0):
        self.C0, self.S, self.Gamma0, self.rho0 = C0, S, Gamma0, rho0

    def _a(self, rho):
        x = 1 - self.rho0/rho
        if x < 0:
            return self.C0**2*(rho - self.rho0)
        return self.rho0*self.C0**2*x/(1 - self.S*x)**2*(1 - 0.5*self.Gamma0*x)

    def of(self, rho):
        d = 1e-5*rho
        slope = (8*(self._a(rho + d) - self._a(rho - d))
                 - self._a(rho + 2*d) + self._a(rho - 2*d))/(12*d)
        return self._a(rho), self.Gamma0*self.rho0, slope, 0.0


class JWL(Equation):
    def __init__(self, A, B, R1, R2, omega, rho0):
        self.A, self.B, self.R1, self.R2 = A, B, R1, R2
        self.omega, self.rho0 = omega, rho0

    def of(self, rho):
        v, w, a, da = self.rho0/rho, self.omega, 0.0, 0.0
        for k, r in ((self.A, self.R1), (self.B, self.R2)):
            f = k*np.exp(-r*v)
            a += f*(1 - w/(r*v))
            da += f*(r*(1 - w/(r*v)) - w/(r*v**2))*v/rho
        return a, w*rho, da, w


class CochranChan(Equation):
    """Energy from the cold curve: e_c is the integral of p_c drho/rho^2 from rho0."""

    def __init__(self, A, B, E1, E2, Gamma0, rho0):
        self.terms, self.Gamma0, self.rho0 = ((A, E1), (-B, E2)), Gamma0, rho0

    def of(self, rho):
        x, g, a, da = rho/self.rho0, self.Gamma0, 0.0, 0.0
        for k, n in self.terms:
            e = k/self.rho0*(x**(n - 1) - 1)/(n - 1)
            a += k*x**n - g*rho*e
            da += (k*n*x**n - g*k*x**n)/rho - g*e
        return a, g*rho, da, g


class VanDerWaals(Equation):
    def __init__(self, gamma, a, b):
        self.gamma, self.a, self.b = gamma, a, b

    def of(self, rho):
        g, a, b = self.gamma - 1, self.a, self.b
        v = 1 - b*rho
        return (g*a*rho**2/v - a*rho**2, g*rho/v,
                g*a*rho*(2 - b*rho)/v**2 - 2*a*rho, g/v**2)


class NobleAbelStiffenedGas(Equation):
    def __init__(self, gamma, pInf, b, q):
        self.gamma, self.pInf, self.b, self.q = gamma, pInf, b, q

    def of(self, rho):
        g, v = self.gamma - 1, 1 - self.b*rho
        return (-self.gamma*self.pInf - g*rho*self.q/v, g*rho/v, -g*self.q/v**2, g/v**2)


class _Fan:
    """Isentrope from a state downwards; u is that of a wave to the right."""

    def __init__(self, eos, state, lowest, steps=1500):
        rho, u, p = state
        self.p = np.linspace(p, lowest, steps + 1)
        h = self.p[1] - self.p[0]
        y = np.array([rho, eos.energy(rho, p), 0.0])
        rows = [y]

        def slope(p, y):
            c = eos.c(y[0], y[1])
            return np.array([1/c**2, p/(y[0]*c)**2, 1/(y[0]*c)])
        with np.errstate(all="ignore"):
            for q in self.p[:-1]:
                a = slope(q, y)
                b = slope(q + h/2, y + h/2*a)
                d = slope(q + h/2, y + h/2*b)
                e = slope(q + h, y + h*d)
                y = y + h/6*(a + 2*b + 2*d + e)
                rows.append(y)
        rows = np.array(rows)
        good = np.all(np.isfinite(rows), axis=1) & (rows[:, 0] > 0)
        n = len(good) if good.all() else np.argmin(good)
        self.p, rows = self.p[:n], rows[:n]
        self.rho, self.du = rows[:, 0], rows[:, 2]
        self.c = np.array([eos.c(r, e) for r, e in rows[:, :2]])

    def at(self, p):
        """Density, velocity change, sound speed at a pressure."""
        return [np.interp(-p, -self.p, v) for v in (self.rho, self.du, self.c)]


def _shock(eos, state, p):
    """Density and velocity change behind a shock of pressure p > p0."""
    rho0, _, p0 = state
    e0 = eos.energy(rho0, p0)

    def hugoniot(rho):
        a, b, _, _ = eos.of(rho)
        dv = 0.5*(1/rho0 - 1/rho)
        return (a + b*(e0 + p0*dv))/(1 - b*dv) if b*dv < 1 else np.inf
    low, high = rho0, rho0*1.001
    while hugoniot(high) < p:
        high *= 1.05
    for _ in range(200):
        rho = 0.5*(low + high)
        if hugoniot(rho) < p:
            low = rho
        else:
            high = rho
    return rho, np.sqrt((p - p0)*(1/rho0 - 1/rho))


class Riemann:
    """p, u, rhoL, rhoR between the waves; at(x/t). lowest: a pressure below p."""

    def __init__(self, eos, left, right, lowest):
        self.sides = left, right
        self.eos = eos if isinstance(eos, tuple) else (eos, eos)
        self.fans = [_Fan(e, s, lowest) for e, s in zip(self.eos, self.sides)]
        low = max(f.p[-1] for f in self.fans)
        rho, _, p = left
        high = max(p, right[2]) \
            + 1e-3*rho*self.eos[0].c(rho, self.eos[0].energy(rho, p))**2
        while self._faster(high):
            high += high - low
        for _ in range(100):
            p = 0.5*(low + high)
            low, high = (p, high) if self._faster(p) else (low, p)
        self.p = p
        (self.rhoL, a), (self.rhoR, b) = self._wave(0, p), self._wave(1, p)
        self.u = 0.5*(a + b)

    def _wave(self, i, p):
        """Density and velocity behind the wave into the left (0) or right side."""
        state = self.sides[i]
        if p > state[2]:
            rho, du = _shock(self.eos[i], state, p)
        else:
            rho, du, _ = self.fans[i].at(p)
        return rho, state[1] + (du if i else -du)

    def _faster(self, p):
        return self._wave(0, p)[1] > self._wave(1, p)[1]

    def at(self, s):
        """Density, velocity, pressure on the rays s = x/t."""
        s = np.asarray(s, float)
        rho, u, p = (np.empty_like(s) for _ in range(3))
        for state, rs, fan, sign in ((self.sides[0], self.rhoL, self.fans[0], -1),
                                     (self.sides[1], self.rhoR, self.fans[1], 1)):
            side = s <= self.u if sign < 0 else s > self.u
            r0, u0, p0 = state
            if self.p > p0:
                speed = (rs*self.u - r0*u0)/(rs - r0)
                outside = side & (sign*(s - speed) > 0)
                rho[side], u[side], p[side] = rs, self.u, self.p
            else:
                # From the star state outwards rays get faster
                part = fan.p > self.p
                fanRho, du, c, fanP = (np.append(end, values[part][::-1]) for end, values in zip(
                    (*fan.at(self.p), self.p), (fan.rho, fan.du, fan.c, fan.p)))
                rays = sign*u0 + du + c
                outside = side & (sign*s > rays[-1])
                for to, values in ((rho, fanRho), (u, u0 + sign*du), (p, fanP)):
                    to[side] = np.interp(sign*s[side], rays, values)
            rho[outside], u[outside], p[outside] = r0, u0, p0
        return rho, u, p
