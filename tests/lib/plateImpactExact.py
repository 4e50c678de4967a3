"""Exact solution of the impact of two plates, small strains, nu = 0.

A flyer of thickness H with velocity -V hits a target of thickness 2 H at rest
at t = 0. X is the position before, along the normal: target 0..2H, flyer
2H..3H; both outer faces are free. d'Alembert: with the initial velocity V0,
continued as an even function at X = 0 and X = 3H (free faces: no strain there),

    v(X, t)     = (V0(X - c t) + V0(X + c t))/2
    sigma(X, t) = rho c (V0(X + c t) - V0(X - c t))/2

with all reflections, as long as flyer and target stay together (tension at
X = 2H would begin at 4H/c = 1.493 us).
"""

import numpy as np

RHO = 2700.0
E = 70e9
H = 1.9e-3
V = 100.0

C = np.sqrt(E/RHO)              # 5091.75 m/s
STRESS = RHO*C*V/2              # 687.39 MPa
T_TENSION = 3*H/C               # 1.1195 us: first tension, at X = H
T_FREE_SURFACE = 2*H/C          # 0.7463 us: outer face of the target jumps to V


def startVelocity(X):
    """Initial velocity, continued evenly with period 6 H."""
    X = np.mod(np.asarray(X, float), 6*H)
    X = np.where(X > 3*H, 6*H - X, X)
    return np.where(X > 2*H, -V, 0.0)


def velocity(X, t):
    return (startVelocity(X - C*t) + startVelocity(X + C*t))/2


def stress(X, t):
    return RHO*C*(startVelocity(X + C*t) - startVelocity(X - C*t))/2


if __name__ == "__main__":
    # Of this case, by hand
    assert abs(C - 5091.75) < 0.01 and abs(STRESS - 687.39e6) < 1e4
    us = 1e-6
    assert np.isclose(stress(H, 0.5*us), -STRESS, rtol=1e-12) and velocity(H, 0.5*us) == -V/2
    assert np.isclose(stress(H, 1.11*us), -STRESS, rtol=1e-12)
    assert np.isclose(stress(H, 1.13*us), STRESS, rtol=1e-12)
    assert velocity(0.01e-3, 0.76*us) == -V
    print("plateImpactExact: ok")
