#!/usr/bin/env python3
"""Waves of water beside air and bodies, against exact solutions.

    springs     0.4 m of water between two columns of air as springs, 1 m/s (Mach number
                6e-4), lowMach: period of the rigid column on isentropic springs (an integral),
                amplitude kept in a period
    bar         soft bars of 0.2 m in closed water, first symmetric mode: the frequency of
                Z_s cot(w a/c_s) = Z_w tan(w b/c_w), with E 7e10, 1e9 and 1e7 Pa
    oblique     a step of 2 MPa in water on a slab, both at 45 degrees to the cells, cyclic:
                reflected and largest pressure by acoustics
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from fluidCases import AIR, WATER, besidePoints, fluidCase, fluidField
from foamCase import runParts
from gasOnCells import cyclicSides
from roots import bisection
from surfaces import prisms, surfaceRegion

PINF, P0 = 6e8, 1e5
K = 4.4*(PINF + P0)
SOUND = np.sqrt(K/1000)
CLOSED = ("zeroGradient", "zeroGradient", "slip")


def crossings(t, q):
    """Times at which q passes 0 downwards."""
    i = np.flatnonzero((q[:-1] > 0) & (q[1:] <= 0))
    return t[i] + (t[i + 1] - t[i])*q[i]/(q[i] - q[i + 1])


def ofLog(case, pattern):
    """Times of the reports and what the pattern finds in each."""
    t, q, now = [], [], 0.0
    for line in case.log().splitlines():
        if line.startswith("Time = "):
            now = float(line[7:])
        found = re.search(pattern, line)
        if found:
            t.append(now)
            q.append(float(found[1]))
    return np.array(t), np.array(q)


# --- springs -----------------------------------------------------------------

def springPeriod(u0, m, a):
    """m x'' = A (p(-x) - p(x)) of isentropic air, from u0 at x = 0: four times the time
    to the turning point."""
    def work(x):
        # Of both springs, from 0 to x [J/m2]
        g = 1.4
        return P0*a/(g - 1)*((1 + x/a)**(1 - g) + (1 - x/a)**(1 - g) - 2)
    most = bisection(lambda x: work(x) - 0.5*m*u0*u0, 0.0, 0.9*a)
    s = (np.arange(4000) + 0.5)/4000*np.pi/2
    x = most*np.sin(s)
    u = np.sqrt(2/m*(work(most) - work(x)))
    return 4*np.sum(most*np.cos(s)/u)*np.pi/2/4000


def springs(table):
    u0, a, b = 1.0, 0.3, 0.4
    rho = 1.2
    # A third of the air moves with the water
    T = springPeriod(u0, 1000*b + 2*rho*a/3, a)

    def initial(x, y, z):
        inside = (x > a) & (x < a + b)
        # Air's velocity falls to 0 at its wall
        u = np.where(inside, 1.0, np.minimum(x, 1 - x)/a)*u0
        return [1.0*inside, 1.0*~inside], [1000.0, rho], u, P0
    n, kept = 100, 0.998
    case = fluidCase("wavesInFluids", f"springs-{n}", (n, 1, 1), (1, 0.01, 0.01),
                     {"water": WATER, "air": AIR}, initial, 2.1*T, ends=CLOSED,
                     settings={"lowMach": True}, writeInterval=2.1*T/168,
                     control={"deltaT": 1e-8})
    case.run("materialPointFoam")
    times = case.times()
    t = np.array([float(s) for s in times])
    m = np.array([np.sum(fluidField(case, float(s), "thetaRhoU")[:, 0]) if float(s) > 0
                  else 1000*u0*b*n for s in times])
    down = crossings(t, m)
    # The largest of each half period by its cosine
    def amplitude(i):
        near = abs(t - (down[0] + (0.5*i + 0.25)*T)) < 0.12*T
        c = np.cos(2*np.pi*(t[near] - down[0])/T + np.pi/2)
        return abs(np.sum(m[near]*c)/np.sum(c*c))
    table.row(f"water on two springs of air, {n} cells: period", T, np.mean(np.diff(down)),
              0.004, "relative")
    table.row(f"water on two springs of air, {n} cells: amplitude kept in a period", 1,
              amplitude(2)/amplitude(0), 1 - kept)


# --- bar ---------------------------------------------------------------------

def bar(table):
    a, b, rho, dp = 0.1, 0.4, 2700.0, 1e4
    # The strain of the softest bar, half a wave long, presses the water in its pores, whose
    # pressure falls in a cell at its ends: a frequency within one cell of its length, where it
    # drains faster within half a cell
    for E, n, limit, drainage in ((7e10, 200, 0.005, 0.1), (1e9, 200, 0.005, 0.1),
                                  (1e7, 200, 1/40, 0.1), (1e7, 200, 1/80, 0.4),
                                  (1e7, 400, 1/80, 0.1)):
        pieces = n//10
        cs = np.sqrt(E/rho)
        Zs, Zw = rho*cs, 1000*SOUND
        # p cos(w x/c_s) in the half bar, p cos(w (L - x)/c_w) in water: equal p, equal u

        def mode(w):
            return (Zw*np.sin(w*a/cs)*np.cos(w*b/SOUND)
                    + Zs*np.cos(w*a/cs)*np.sin(w*b/SOUND))
        first = np.pi*min(cs/a, SOUND/b)
        w = bisection(mode, 0.01*first, 0.999*first)
        T = 2*np.pi/w
        end = 2.6*T
        # Pressure in the bar over that at its end
        inBar = np.cos(w*a/cs)

        def initial(x, y, z):
            d = np.maximum(abs(x - 0.5) - a, 0)
            p = np.where(d > 0, inBar*np.cos(w*(b - d)/SOUND)/np.cos(w*b/SOUND), inBar)
            p = P0 + dp*p
            return [1.0], [1000*((p + PINF)/(P0 + PINF))**(1/4.4)], 0.0, p
        case = fluidCase("wavesInFluids", f"bar-{E:g}-{n}-{drainage}", (n, 1, 1), (1, 0.01, 0.01),
                         {"water": WATER}, initial, end, ends=CLOSED, maxCoGas=0.3,
                         control={"maxCo": 0.3, "deltaT": 1e-9}, writeInterval=end/104)
        edges = np.linspace(0.5 - a, 0.5 + a, pieces + 1)
        regions = {}
        for i, (low, high) in enumerate(zip(edges[:-1], edges[1:])):
            middle = abs(0.5*(low + high) - 0.5)
            regions[f"piece{i}"] = {
                "phase": "bar", "type": "box", "min": (low, -1, -1), "max": (high, 1, 1),
                "stress": "ambient", "pressure": P0 + dp*np.cos(w*middle/cs)}
        law = {"type": "linearElastic", "rho": rho, "E": E, "nu": 0}
        besidePoints(case, {"water": WATER}, {"bar": {"constitutiveModel": law}}, regions,
                     settings={"drainage": drainage})
        case.run("materialPointFoam")
        times = [s for s in case.times() if float(s) > 0]
        t = np.array([float(s) for s in times])
        # Pressure of the middle of the bar
        q = []
        for s in times:
            points = case.points(s, "bar")
            x = points["x"][:, 0]
            # Projected on the mode: others of the start add nothing
            q.append(-np.mean((points["sigma"][:, 0] + P0)*np.cos(w*abs(x - 0.5)/cs)))
        down = crossings(t, np.array(q))
        label = f"bar of {E:g} Pa in water" + (f", drainage {drainage}" if drainage > 0.1 else "")
        table.row(f"{label}, {n//5} cells: frequency of its first symmetric mode",
                  w/(2*np.pi), 1/np.mean(np.diff(down)), limit, "relative")


# --- oblique -----------------------------------------------------------------

def oblique(table):
    n, dp, E, rho = 140, 2e6, 7e10, 2700.0
    Z, Zs = 1000*SOUND, np.sqrt(E*rho)
    period = np.sqrt(0.5)
    low, high, face = 0.4, period, 0.4
    end = (face - 0.25)/SOUND + 5e-5

    def along(x, y):
        return ((x + y)*np.sqrt(0.5)) % period

    def initial(x, y, z):
        behind = (along(x, y) > 0.08) & (along(x, y) < 0.25)
        p = np.where(behind, P0 + dp, P0)
        u = np.where(behind, dp/Z, 0.0)*np.sqrt(0.5)
        return ([1.0], [1000*((p + PINF)/(P0 + PINF))**(1/4.4)],
                np.column_stack([u, u, 0*u]), p)
    case = fluidCase("wavesInFluids", "oblique", (n, n, 1), (1, 1, 1/n), {"water": WATER},
                     initial, end, patches=cyclicSides("xy")[0],
                     control={"maxCo": 0.4, "deltaT": 1e-8})
    # x + y = s sqrt(2) of both strips in the square
    s0, s1 = low*np.sqrt(2), high*np.sqrt(2)
    strips = [[(s0, 0), (s1, 0), (0, s1), (0, s0)],
              [(1, s0), (1, 1), (1, 1), (s0, 1)]]
    prisms(case, "slab.stl", [[np.array(p, float) for p in polygon] for polygon in
                              (strips[0], [(1, s0), (1, 1), (s0, 1)])])
    besidePoints(case, {"water": WATER},
                 {"slab": {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E,
                                                 "nu": 0.0}}},
                 {"slab": surfaceRegion("slab.stl", stress="ambient", pressure=P0)})
    case.run("materialPointFoam")
    p = fluidField(case, end, "p")
    x, y = np.meshgrid((np.arange(n) + 0.5)/n, (np.arange(n) + 0.5)/n)
    s = along(x, y).ravel()
    reflected = 2*Zs/(Z + Zs)*dp
    behind = (s > face - 0.6*SOUND*5e-5) & (s < face - 1.5/n)
    table.row("step on a slab at 45 degrees: reflected pressure", 1,
              (p[behind].mean() - P0)/reflected, 3e-3)
    near = (s > 0.28) & (s < face)
    table.row("step on a slab at 45 degrees: largest pressure", 1.02,
              (p[near].max() - P0)/reflected, 1.02, "atMost")


if __name__ == "__main__":
    sys.exit(runParts("wavesInFluids", springs, bar, oblique))
