"""Exact plane detonations of an equation of state, and explosives as entries of phases.

    exact = PlaneDetonation(jwl, q)          # q: chemical energy [J/kg]
    exact.D, exact.p, exact.u, exact.rho     # state of Chapman and Jouguet
    u, p = exact.at(x/t)                     # lit at a wall x = 0: wave of Taylor

State of Chapman and Jouguet: where the line of Rayleigh touches the Hugoniot of the
products, i.e. the least speed

    D^2 = v0^2 (p_H - p0)/(v0 - v),    p_H from e - q = (p + p0)(v0 - v)/2

Behind it the flow is similar, x/t = u + c, and du = c drho/rho along the isentrope,
down to u = 0 at the wall (second order steps, 4000 of them: error below 1e-6).
"""

import numpy as np

from riemannEquation import JWL

#: etc/materials/TNT
TNT = {"rho": 1630, "equationOfState": {"type": "JWL", "A": 3.712e11, "B": 3.231e9, "R1": 4.15,
                                        "R2": 0.95, "omega": 0.3, "E0": 7e9}}

#: QM-100: JWL++ constants of Souers et al. (2000), as Uintah's example QM100CuRS.ups has
#: them; Murnaghan's kappa 1.02e-9/Pa, n 7; E0 2.913e6 J/kg
QM100 = {"rho": 1260, "equationOfState": {"type": "JWL", "A": 4.8702e11, "B": 2.54887e9,
                                          "R1": 5, "R2": 1, "omega": 0.3,
                                          "E0": 1260*2.913e6}}
QM100_RATE = {"type": "pressureRate", "G": 9.1e-5, "b": 1, "threshold": 2e8,
              "K": 1/1.02e-9, "n": 7}


def jwlOf(fluid):
    e = fluid["equationOfState"]
    return JWL(e["A"], e["B"], e["R1"], e["R2"], e["omega"], fluid["rho"])


def energyOf(fluid):
    """Chemical energy [J/kg]."""
    return fluid["equationOfState"]["E0"]/fluid["rho"]


class PlaneDetonation:
    def __init__(self, equation, q, p0=1e5, steps=4000):
        v0 = 1/equation.rho0

        def speed2(rho):
            a, b, _, _ = equation.of(rho)
            half = b*(v0 - 1/rho)/2
            p = (a + b*q + half*p0)/(1 - half)
            return v0**2*(p - p0)/(v0 - 1/rho), p
        low, high = 1.05*equation.rho0, 2*equation.rho0
        ratio = (np.sqrt(5) - 1)/2
        for _ in range(100):
            a, b = high - ratio*(high - low), low + ratio*(high - low)
            if speed2(a)[0] < speed2(b)[0]:
                high = b
            else:
                low = a
        rho = (low + high)/2
        d2, p = speed2(rho)
        self.D, self.p, self.rho, self.p0 = np.sqrt(d2), p, rho, p0
        self.u = u = (p - p0)*v0/self.D
        e, step, rows = equation.energy(rho, p), -0.6*rho/steps, []

        def slopes(rho, e):
            return equation.pressure(rho, e)/rho**2, equation.c(rho, e)/rho
        while True:
            rows.append((u + equation.c(rho, e), u, equation.pressure(rho, e)))
            if u <= 0:
                break
            de, _ = slopes(rho, e)
            de, du = slopes(rho + step/2, e + de*step/2)
            e, u, rho = e + de*step, u + du*step, rho + step
        self.wave = np.array(rows)[::-1]
        self.wall = self.wave[0, 2]

    def at(self, s):
        s = np.asarray(s)
        u = np.interp(s, self.wave[:, 0], np.maximum(self.wave[:, 1], 0))
        p = np.interp(s, self.wave[:, 0], self.wave[:, 2])
        return np.where(s > self.D, 0, u), np.where(s > self.D, self.p0, p)
