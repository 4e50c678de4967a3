"""Grains that collide, in a gas that damps and feeds their granular temperature T: a cyclic box
full of them, all the same everywhere, drag K = theta_s theta_g value. With b = K/M_s,
l = K (1/rho_g + 1/M_s):

    u = u0 exp(-l t),  J0 = b^2 d u0^2/(4 sqrt(pi)),
    s^3 = s0^3 exp(-3 b t) + J0 (exp(-2 l t) - exp(-3 b t))/(3 b - 2 l),  s = sqrt(T)

without loss in collisions (e 1).
"""

import re
import shutil

import numpy as np

from coupledCases import coupledCase, gasLog
from foamCase import readField

RHO0, P0, EPS = 1.2, 1e5, 1e-2
RHO_S, D, SHARE, T0, VALUE, N, WIDTH = 2500.0, 5e-4, 0.1, 1e-3, 6e7, 8, 1e-2
THETA = (1 - EPS)*SHARE
K, MASS_G, MASS_S = VALUE*THETA*(1 - THETA), RHO0*(1 - THETA), RHO_S*SHARE
B, LAMBDA = K/MASS_S, K*(1/MASS_G + 1/MASS_S)


def exact(t, u0):
    J0 = B**2*D*u0**2/(4*np.sqrt(np.pi))
    cube = T0**1.5*np.exp(-3*B*t) + J0*(np.exp(-2*LAMBDA*t) - np.exp(-3*B*t))/(3*B - 2*LAMBDA)
    return cube**(2/3)


def run(name, cells, u0, dt, end, processors=1, since=None):
    """Case whose gas has u0 along x at the start, or goes on from the middle of another."""
    patches = {a + side: (f"cyclic; neighbourPatch {a}{other}", (f"{a}{side}",))
               for a, n in zip("xyz", cells) if n > 1 for side, other in ("-+", "+-")}
    patches = {k.replace("-", "Low").replace("+", "High"):
               (v[0].replace("-", "Low").replace("+", "High"), v[1]) for k, v in patches.items()}
    case = coupledCase(
        "grains", name, cells, tuple(WIDTH*n for n in cells),
        lambda x, y, z: (RHO0 + 0*x, u0 + 0*x, P0 + 0*x), end,
        {"dust": {"volumeModel": "grains", "drag": {"type": "constant", "value": VALUE},
                  "constitutiveModel": {
                      "type": "muI", "rho": RHO_S, "E": 1e3, "nu": 0.2, "muS": 0.5, "mu2": 0.5,
                      "I0": 0.3, "d": D, "packing": SHARE, "collisions": {
                          "e": 1, "alphaMax": 0.64, "granularTemperature": T0}}}},
        {"dust": {"type": "cells", "volumeFraction": SHARE}}, patches=patches,
        control={"reportInterval": 1, "adjustTimeStep": False, "deltaT": dt,
                 "writeControl": "runTime", "writeInterval": end/2, "startFrom": "latestTime"},
        numerics={"energyBudget": True})
    case.change("system/controlDict", r"maxCo .*;", "")
    if since:
        shutil.copytree(since.file(since.times()[1]), case.file(since.times()[1]))
    if processors > 1:
        case.decompose((processors, 1, 1))
        case.runParallel()
    else:
        case.run("materialPointFoam")
    return case


def temperature(case, time):
    return readField(case.file(time, "lagrangian/dust", "granularTemperature"))


def fluctuations(table):
    """Still gas: exact at any step. Gas that streams: first order in the step; the energy of gas
    and grains together stays. Two processors, two directions."""
    end = 1/B
    for parts in (4, 40):
        case = run(f"still-{parts}", (N, 1, 1), 0.0, end/parts, end)
        T = temperature(case, case.timeName(end))
        table.row(f"grains in still gas, dt {1/parts:g}/b: T over exp(-2 b t)", 1,
                  T.mean()/(T0*np.exp(-2)), 1e-9)
        table.row(f"grains in still gas, dt {1/parts:g}/b: spread of T", 0, np.ptp(T)/T0, 1e-12,
                  "atMost")
    u0, end, errors, line = 2.0, 1/LAMBDA, [], {}
    for parts in (20, 40):
        case = run(f"stream-{parts}", (N, 1, 1), u0, end/parts, end)
        time = case.timeName(end)
        got, right = temperature(case, time).mean(), exact(end, u0)
        line[parts] = got
        errors.append(abs(got/right - 1))
        g = gasLog(case)
        total = g["energy"] + g["total"]
        residual = np.array(re.findall(r"\bresidual ([-+.e\d]+)", case.log()), float)
        gained = 1.5*MASS_S*(N*WIDTH**3)*(right - T0)
        table.row(f"grains in gas that streams, dt {1/parts:g}/l: error of T", 0, errors[-1],
                  1/parts, "atMost")
        table.row(f"grains in gas that streams, dt {1/parts:g}/l: change of all energy over"
                  " what the fluctuations gained", 0, np.ptp(total)/gained, 1e-8, "atMost")
        table.row(f"grains in gas that streams, dt {1/parts:g}/l: residual over it", 0,
                  np.max(abs(residual))/gained, 1e-8, "atMost")
    print(f"grains in gas that streams: T {T0} to {got:.4e} (exact {right:.4e}), error"
          f" {errors[0]:.2e}, {errors[1]:.2e}")
    table.row("grains in gas that streams: error over that of half the step", 2,
              errors[0]/errors[1], 0.2)
    one, two = (run(f"plane-{n}", (N, N, 1), u0, end/20, end, n) for n in (1, 2))
    time = one.timeName(end)
    table.row("grains in gas that streams, 2D: T over that in 1D", 1,
              temperature(one, time).mean()/line[20], 1e-9)
    table.row("grains in gas that streams, two processors: points and T", 0, one.largestDifference(
        two, time, ("dust",), ("x", "U", "granularTemperature")), 1e-11, "atMost")
    again = run("plane-again", (N, N, 1), u0, end/20, end, since=one)
    table.row("grains in gas that streams, restart: points and T", 0, one.largestDifference(
        again, time, ("dust",), ("x", "U", "granularTemperature")), 0, "atMost")
