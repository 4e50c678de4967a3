#!/usr/bin/env python3
"""Vapour that grows from nuclei, on three meshes each, against exact solutions; a weak wave in
water with bubbles; a spherical void that collapses.

spread    water that parts with 2 U and a wave on it: bands where the velocity made them alone
pistons   water between two walls parts in the middle with 2 U and is thrown back by what the walls
          send: void 2 (U - Uc) t until T = L/(2 c), then less by 2 (U + Uc) (t - T), pressure
          rho c (U + Uc) when it has closed; Uc = (p0 - pv)/(rho c)
Kennard   a triangular wave below a free surface (E.H. Kennard, Explosive load on underwater
          structures as modified by bulk cavitation, 1943): against water of the law
          p = max(pv, p0 + K eps) along its own mesh, Godunov's faces at Courant number 1,
          800 cells/m
waves     Wood's speed of sound in water with 1 % of air, a step of 2 % of the pressure
Rayleigh  time of collapse of a sphere of void, 0.915 R sqrt(rho/p) (Phil. Mag. 34 (1917) 94-98),
          less what the sides of the mesh at 20 R take from it: 1 - R/B in the kinetic energy
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from fluidCases import WATER, fluidCase, fluidField
from foamCase import FoamCase, controlDict, runParts
from gasCases import VAN_LEER, schemes, volField
from wedge import wedgeMesh

AIR = {"thermo": "perfectGas", "R": 287, "gamma": 1.4}
RHO, PINF, GAMMA, VAPOUR, NUCLEI = 1000.0, 6e8, 4.4, 260.0, 1e-6


def sound(p0):
    return np.sqrt(GAMMA*(p0 + PINF)/RHO)


def volumes(case, of=lambda a: a.mean()):
    """Times; of(alpha.air) at each."""
    times = case.times()
    return np.array([float(t) for t in times]), np.array(
        [of(volField(case, t, "alpha.air")*np.ones(1)) for t in times])


def falls(t, v, to):
    """When v has fallen to a share of its largest value."""
    late = np.arange(len(v)) > np.argmax(v)
    i = np.argmax(late & (v < to*v.max()))
    return t[i - 1] + (v[i - 1] - to*v.max())/(v[i - 1] - v[i])*(t[i] - t[i - 1])


def pistons(table):
    p0, U = 1e5, 10.0
    c = sound(p0)
    Uc, T = (p0 - VAPOUR)/RHO/c, 0.5/c
    closed = T*(1 + (U - Uc)/(U + Uc))
    end = 1.2*closed
    for n in (100, 200, 400):
        case = fluidCase("cavitation", f"pistons-{n}", (n, 1, 1), (1, 0.1, 0.1),
                         {"water": WATER, "air": AIR},
                         lambda x, y, z: ([1 - NUCLEI, NUCLEI], [RHO, p0/287/300],
                                          np.where(x < 0.5, -U, U), p0), end,
                         patches={"ends": ("wall", ("x-", "x+"))},
                         ends=("zeroGradient", "zeroGradient", "slip"), writeInterval=end/96)
        case.run("materialPointFoam")
        t, v = volumes(case)
        label = f"cavity between two pistons, {n} cells"
        table.row(f"{label}: largest void [m]", 2*(U - Uc)*T, v.max(), 0.1, "relative")
        table.row(f"{label}: time until it has 5 % left, over the exact", 1,
                  falls(t, v, 0.05)/(T + 0.95*(closed - T)), 0.05)
        table.row(f"{label}: pressure when it has closed [MPa]", 1e-6*RHO*c*(U + Uc),
                  1e-6*fluidField(case, end, "p")[n//2], 0.03, "relative")


# --- bands ---------------------------------------------------------------------

def spread(table):
    """Nothing pulls at cavitated water: x = X + u(X) t, the share of vapour 1 - dX/dx."""
    U, k, end, start = 50.0, 20*np.pi, 4e-3, 300.0

    def u(x):
        return U*(2*x - 1 + 1.6*np.sin(k*x)/k)
    X = np.linspace(0, 1, 100001)
    for n, limit in ((100, 0.1), (200, 0.07), (400, 0.05)):
        case = fluidCase("cavitation", f"spread-{n}", (n, 1, 1), (1, 0.1, 0.1),
                         {"water": WATER, "air": AIR},
                         lambda x, y, z: ([1 - NUCLEI, NUCLEI], [RHO, 1.2], u(x), start), end)
        case.run("materialPointFoam")
        inside = slice(n//4, 3*n//4)
        a = fluidField(case, end, "alpha.air")[inside]
        exact = (1 - n*np.diff(np.interp(np.arange(n + 1)/n, X + u(X)*end, X)))[inside]
        label = f"water that parts unevenly, {n} cells"
        table.row(f"{label}: void", exact.sum()/n, a.sum()/n, 0.02, "relative")
        table.row(f"{label}: share of vapour, L1 over the mean", 0,
                  np.mean(abs(a - exact))/exact.mean(), limit, "atMost")
        # 0.1 (1 + 2 U t) apart, within half of the column
        table.row(f"{label}: bands", 3, np.sum(np.diff(np.sign(np.diff(a))) < 0), 0)


# --- bulk cavitation -----------------------------------------------------------

P, PULSE, LENGTH, SURFACE = 5e6, 1e6, 1.0, 1.5


def pulse(x):
    front = SURFACE - 0.05
    return np.where((x < front) & (x > front - LENGTH), P*(1 - (front - x)/LENGTH), 0.0)


def bilinear(n, end, p0, air):
    """Times, void, largest pressure; air: rho c of the air above."""
    c, h = sound(p0), 1/n
    x = (np.arange(int(SURFACE*n)) + 0.5)*h
    z, K, rows = RHO*c, RHO*c**2, []
    u, p = pulse(x)/z, p0 + pulse(x)
    e = (p - p0)/K
    for i in range(int(end*c/h)):
        uL, uR = np.append(0, u), np.append(u, 0)
        pL, pR = np.append(p0, p), np.append(p, p0)
        ps = np.maximum(0.5*(pL + pR + z*(uL - uR)), VAPOUR)
        us = 0.5*(uL + uR + (pL - pR)/z)
        us[-1] = (p[-1] + z*u[-1] - p0)/(z + air)
        ps[-1] = p0 + air*us[-1]
        u = u - np.diff(ps)/z
        e = e - np.diff(us)/c
        p = np.maximum(VAPOUR, p0 + K*e)
        rows.append(((i + 1)*h/c, h*np.sum(np.maximum(0, (VAPOUR - p0)/K - e)), p.max()))
    return np.array(rows).T


def Kennard(table):
    p0, end, above = 1e6, 3.6e-3, 0.5
    c, rhoAir = sound(p0), p0/287/300
    t, v, p = bilinear(800, end, p0, rhoAir*np.sqrt(1.4*287*300))
    void, closes, peak = v.max(), falls(t, v, 0.05), p[t > 2.5e-3].max()

    def start(x, y, z):
        q = p0 + pulse(x)
        rho = RHO*((q + PINF)/(p0 + PINF))**(1/GAMMA)
        water = np.where(x < SURFACE, 1 - NUCLEI, 0.0)
        return ([water, 1 - water], [rho, rhoAir*(q/p0)**(1/1.4)],
                2/(GAMMA - 1)*(np.sqrt(GAMMA*(q + PINF)/rho) - c), q)

    def far(value):
        return {"type": "farField", "farValue": f"uniform {value}", "value": f"uniform {value}"}

    def below(a):
        """Void below the surface's interface."""
        last = np.max(np.where(a < 0.5)) - 2
        return np.sum(a[:last] - NUCLEI)*(SURFACE + above)/len(a)
    for n in (100, 200, 400):
        cells = int((SURFACE + above)*n)
        case = fluidCase("cavitation", f"Kennard-{n}", (cells, 1, 1), (SURFACE + above, 0.1, 0.1),
                         {"water": WATER, "air": AIR}, start, end,
                         ends=(far(p0), "zeroGradient", far("(0 0 0)")), writeInterval=end/120)
        case.run("materialPointFoam")
        times, voids = volumes(case, below)
        label = f"wave below a free surface, {n} cells/m"
        table.row(f"{label}: largest void [m]", void, voids.max(), 0.1, "relative")
        table.row(f"{label}: time until it has 5 % left [ms]", 1e3*closes,
                  1e3*falls(times, voids, 0.05), 0.1, "relative")
        late = [t for t in case.times() if float(t) > 2.5e-3]
        table.row(f"{label}: pressure of the collapse [MPa]", 1e-6*peak,
                  1e-6*max(volField(case, t, "p").max() for t in late), 0.1, "relative")


# --- waves in a mixture --------------------------------------------------------

def waves(table):
    n, p0, share, step = 200, 1e5, 0.01, 2e3
    rhoAir = p0/287/300
    rho = share*rhoAir + (1 - share)*RHO
    c = 1/np.sqrt(rho*(share/1.4/p0 + (1 - share)/GAMMA/(p0 + PINF)))
    end = 0.5/c

    def start(x, y, z):
        p = p0 + np.where(x < 0.25, step, 0)
        w, a = ((p + PINF)/(p0 + PINF))**(1/GAMMA), (p/p0)**(1/1.4)
        air = share/a/(share/a + (1 - share)/w)
        return [1 - air, air], [RHO*w, rhoAir*a], (p - p0)/rho/c, p
    for label, settings in (("", None), (", lowMach", {"lowMach": True})):
        case = fluidCase("cavitation", f"wave{label[2:]}", (n, 1, 1), (1, 0.1, 0.1),
                         {"water": WATER, "air": AIR}, start, end, settings=settings)
        case.run("materialPointFoam")
        x = (np.arange(n) + 0.5)/n
        p = (fluidField(case, end, "p") - p0)/step
        ahead = x > 0.4
        label = f"weak wave in water with 1 % of air{label}, {n} cells"
        # A shock of 2 % is faster than sound by 1.2 %: (gamma + 1)/(4 gamma) of it and what u is
        table.row(f"{label}: way over Wood's c t", 1.012,
                  (np.interp(-0.5, -p[ahead], x[ahead]) - 0.25)/0.5, 0.005)
        table.row(f"{label}: cells of the front (5 to 95 %)", 0,
                  np.sum(ahead & (p > 0.05) & (p < 0.95)), 10, "atMost")
        table.row(f"{label}: overshoot", 0, max(p.max() - 1, -p.min()), 0.05, "atMost")


# --- a sphere of void ----------------------------------------------------------

def graded(n, m, first, last):
    """Ratio of m cells from first to last whose first one is first/n wide."""
    low, high = 1.0001, 3.0
    for _ in range(60):
        r = 0.5*(low + high)
        low, high = (low, r) if first/n*(r**m - 1)/(r - 1) > last - first else (r, high)
    return r


def Rayleigh(table):
    R, B, p0, gas = 0.1, 20, 1e6, 1e3
    L, inner = B*R, 1.25*R
    s = np.linspace(0, 1, 20001)[1:-1]
    # r = 1 - s^2; R(t) from the kinetic energy 2 pi rho r^3 (dr/dt)^2 (1 - r/B)
    r = 1 - s**2
    exact = np.sum(np.sqrt(1.5*r**3*(1 - r/B)/(1 - r**3))*2*s)*(s[1] - s[0])*R*np.sqrt(RHO/p0)
    end = 1.2*exact
    for n in (6, 8, 12):
        case = FoamCase("cavitation", f"Rayleigh-{n}")
        case.write("system/fvSchemes", schemes(VAN_LEER))
        case.write("system/fvSolution", {})
        entries = controlDict(end, end/96, maxCo=0.4, writeFormat="binary")
        entries["maxCoGas"] = entries.pop("maxCo")
        case.write("system/controlDict", {**entries, "deltaT": 1e-6*end})
        case.write("constant/phaseProperties", {
            "phases": ["water", "air"], "water": {"type": "fluid", **WATER},
            "air": {"type": "fluid", **AIR, "nuclei": NUCLEI}, "fluids": {"lowMach": True}})
        near = int(round(1.25*n))
        total = near + n
        grading = (f"(({inner/L} {near/total} 1) ({1 - inner/L} {n/total}"
                   f" {graded(near, n, inner, L)**(n - 1)}))")
        mesh = wedgeMesh((0, 0), (L, L), (total, total), {
            "middle": ("symmetryPlane", "x-"), "far": ("patch", "x+"), "side": ("patch", "r+")})
        mesh["blocks"] = mesh["blocks"].replace("(1 1 1)", f"({grading} {grading} 1)")
        case.write("system/blockMeshDict", mesh)
        case.run("blockMesh")
        case.write("system/setFluidsDict", {
            "default": {"fluid": "water", "p": p0}, "regions": {"void": {
                "type": "sphere", "centre": (0, 0, 0), "radius": R, "fluid": "air", "p": gas,
                "T": 300}}})
        case.run("setFluids")
        with open(case.file("0/p"), "rb") as f:
            start = f.read()
        with open(case.file("0/p"), "wb") as f:
            f.write(re.sub(rb"((?:far|side)\s*\{\s*type\s+)zeroGradient;",
                           rb"\1fixedValue; value uniform %d;" % int(p0), start))
        case.run("postProcess", "-func", "writeCellVolumes", "-time", "0")
        V = volField(case, "0", "V")
        case.run("materialPointFoam")
        t, v = volumes(case, lambda a, V=V: np.sum((a - NUCLEI)*V))
        table.row(f"sphere of void, {n} cells over its radius: time of collapse over Rayleigh's",
                  1, t[np.argmin(v)]/exact, 0.1)


if __name__ == "__main__":
    sys.exit(runParts("cavitation", pistons, spread, Kennard, waves, Rayleigh))
