#!/usr/bin/env python3
"""Material points in a gas against exact values.

piston     slab between two columns of gas, started as the exact normal mode: period; what
           it loses with sticking drag is what a gas of first order loses, and next to
           nothing with van Leer's
shock      shock of Mach 1.2, 2, 3 reflected by a dense slab: pressure, overshoot
sealed     gas compressed 5:1 by a rigid piston: isentropic pressure, mass
thrown     slab without drag that a gas throws back from 12 bar (adiabatic): speed within 2 %
           (where the gas ran through its pores 12 %)
cylinder   shock of Mach 2 on a fixed rigid disc: symmetry, no fix-up, no suction
wedge      Mach 2 over fixed rigid wedges, drag along the normal: angle of the shock,
           pressure behind
sound      dusty gas: speed of sound in equilibrium
relax      dusty gas: relaxation by drag, K 1 to 1e15

MPM_VERIFY=1 adds finer meshes.
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from coupledCases import ambient, coupledCase, gasLog
from foamCase import VERIFY, RunFailed, readField, writeField
from gasCases import OPEN, UPWIND, VAN_LEER, WALL, volField
from report import Report

GAMMA, P0, RHO0 = 1.4, 1e5, 1.2
C0 = np.sqrt(GAMMA*P0/RHO0)
EVERY = {"reportInterval": 1}


# --- piston ------------------------------------------------------------------

def pistonOmega(L, width, rho, cs):
    """Lowest antisymmetric mode: slab of finite stiffness, a column of length L on
    each side: rho cs tan(w width/2/cs) = rho0 c0 cot(w L/c0)."""
    def f(w):
        return rho*cs*np.tan(w*width/2/cs)*np.tan(w*L/C0) - RHO0*C0
    low, high = 1e-6, np.pi/2*C0/L
    for _ in range(200):
        w = 0.5*(low + high)
        low, high = (w, high) if f(w) < 0 else (low, w)
    return w


def firstOrderLoss(w, L, m, h, dt, time):
    """Share of the energy of the mode that a gas of first order loses: faces spend
    z (du)^2/2 + (dp)^2/(2 z), the explicit step gives c dt/h of it back."""
    k = w/C0
    s2 = np.sin(k*L)**2
    energy = 0.5*m + RHO0/(2*s2)*(L - np.sin(2*k*L)/(2*k))
    return 1 - np.exp(-time*RHO0*C0*(h - C0*dt)*k**2*L/(2*s2)/energy)


def piston(table):
    L, width, rho, E = 0.45, 0.1, 27.0, 7e7
    w = pistonOmega(L, width, rho, np.sqrt(E/rho))
    T = 2*np.pi/w
    speed = 0.005*P0*w*L/(RHO0*C0*C0)      # of about 0.5 % of P0
    runs = [(n, drag, UPWIND) for n in ((50, 100, 200, 400) if VERIFY else (100,))
            for drag in ("none", "stick")]
    runs += [(100, "stick", VAN_LEER)] + ([] if VERIFY else [(50, "stick", UPWIND)])
    for n, drag, scheme in runs:
        def initial(x, y, z):
            u = np.where(x < L, np.sin(w*x/C0), np.sin(w*(1 - x)/C0))/np.sin(w*L/C0)
            u = np.where((x > L) & (x < L + width), 1, u)
            return RHO0 + 0*x, speed*u, P0 + 0*x
        name = "" if scheme is UPWIND else ", van Leer"
        case = coupledCase(
            "immersed", f"piston-{drag}-{n}" + name.replace(", ", "-").replace(" ", ""),
            (n, 1, 1), (1, 0.01, 0.01), initial,
            4.3*T, {"slab": {"drag": {"type": drag}, "constitutiveModel": {
                "type": "linearElastic", "rho": rho, "E": E, "nu": 0}}},
            {"slab": {"type": "box", "min": (L, 0, 0), "max": (L + width, 1, 1),
                      "velocity": (speed, 0, 0), "stress": ambient(P0)}},
            ends=WALL, ppc=4, control={"reportInterval": 10}, reconstruct=scheme)
        case.run("materialPointFoam", limit=900)
        g = gasLog(case)
        t = reportTimes(case)
        v = g["pointMomentum"][:, 0]
        cross = [t[i] - v[i]*(t[i + 1] - t[i])/(v[i + 1] - v[i])
                 for i in range(len(v) - 1) if v[i]*v[i + 1] <= 0 and v[i] != 0]
        period = 2*np.polyfit(np.arange(len(cross)), cross, 1)[0]
        label = f"piston, {n} cells, drag {drag}{name}"
        if n >= 100:
            table.row(f"{label}: period [s]", T, period, 1e-3, "relative")
        else:
            print(f"{label}: period {period/T - 1:+.2e}")
        table.row(f"{label}: change of the gas' mass", 0,
                  np.max(abs(g["mass"]/g["mass"][0] - 1)), 1e-14, "atMost")
        total = g["energy"] + g["total"]
        table.row(f"{label}: change of the energy of gas and slab over the slab's"
                  " kinetic energy", 0,
                  abs(total[-1] - total[0])/(0.5*rho*width*speed**2*1e-4), 1e-3, "atMost")
        fourth = abs(t - 4*T) < 0.1*T
        lost = 1 - (np.max(abs(v[fourth]))/(rho*width*speed*1e-4))**2
        expected = firstOrderLoss(w, L, rho*width, 1/n, t[-1]/case.nSteps(), 4*T)
        if name:
            table.row(f"{label}: energy lost in four periods [%]", 0, 100*lost, 1, "atMost")
        elif drag == "stick":
            table.row(f"{label}: energy lost in four periods, that of a gas of first order"
                      " [%]", 100*expected, 100*lost, 0.1, "relative")
        print(f"{label}: {lost:.4f} of the energy lost in four periods, first order alone"
              f" {expected:.4f}; all energy {total[-1]/total[0] - 1:+.1e}; Theta"
              f" {g['ThetaMin'].min():.6f} to {g['ThetaMax'].max():.6f}")


def reportTimes(case):
    """Time of each report."""
    times, t = [], None
    for line in case.log().split("\n"):
        if line.startswith("Time = "):
            t = float(line[7:])
        elif line.startswith("Gas air: mass"):
            times.append(t)
    return np.array(times)


# --- shock -------------------------------------------------------------------

def shockStates(Ms):
    """p, rho, u behind a shock of a Mach number, p reflected by a wall, speed of the
    reflected shock."""
    g = GAMMA
    p2 = P0*(1 + 2*g/(g + 1)*(Ms**2 - 1))
    rho2 = RHO0*(g + 1)*Ms**2/((g - 1)*Ms**2 + 2)
    u2 = 2*C0/(g + 1)*(Ms - 1/Ms)
    pr = p2*((3*g - 1)*p2 - (g - 1)*P0)/((g - 1)*p2 + (g + 1)*P0)
    W = (pr - p2)/(rho2*u2) - u2
    return p2, rho2, u2, pr, W


def shock(table):
    xs, start = 0.8, 0.3
    for n in (400, 800) if VERIFY else (400,):
        face = xs + 0.3/n
        for Ms, limit in ((1.2, 0.7e-2), (2, 0.7e-2), (3, 1.5e-2)):
            p2, rho2, u2, pr, W = shockStates(Ms)
            back = 0.25
            end = (face - start)/(Ms*C0) + back/W

            def initial(x, y, z):
                low = x < start
                return (np.where(low, rho2, RHO0), np.where(low, u2, 0.0),
                        np.where(low, p2, P0))
            case = coupledCase(
                "immersed", f"shock-{Ms}-{n}", (n, 1, 1), (1, 0.01, 0.01), initial, end,
                {"slab": {"constitutiveModel": {"type": "linearElastic", "rho": 2700,
                                                "E": 7e9, "nu": 0}}},
                {"slab": {"type": "box", "min": (face, 0, 0), "max": (1, 1, 1),
                          "stress": ambient(P0)}},
                ends=OPEN, control=EVERY)
            case.run("materialPointFoam", limit=900)
            p = volField(case, case.timeName(end), "p")
            x = (np.arange(n) + 0.5)/n
            window = (x > face - 0.8*back) & (x < face - 0.02)
            g = gasLog(case)
            label = f"shock, Ms {Ms}, {n} cells"
            table.row(f"{label}: pressure behind the reflected shock", pr,
                      p[window].mean(), limit, "relative")
            table.row(f"{label}: largest pressure ever over the exact [%]", 0,
                      100*(g["pMax"].max()/pr - 1), 10, "atMost")
            mixed = p[(x > face - 1.0/n) & (x < face + 1.0/n)]
            front = x[x < face][p[x < face] > 0.5*(p2 + pr)][0]
            print(f"{label}: last cells {mixed/pr}, reflected shock at"
                  f" {(face - front)/back - 1:+.3f} of its way, fix-ups"
                  f" {g['limited'][-1]:g} {g['kept'][-1]:g} {g['isentropic'][-1]:g}")


# --- sealed ------------------------------------------------------------------

def sealed(table):
    """The piston leaves its back chamber's end: what leaks shows."""
    L, Ls, gap, n = 1.0, 0.2, 0.1, 130
    end = 0.16
    for eps in (1e-2, 1e-3):
        t = np.linspace(0, end, 81)
        v = -0.8*L*2/end*np.sin(np.pi*t/end)**2
        v *= 0.8*L/abs(np.sum(0.5*(v[1:] + v[:-1])*np.diff(t)))
        rows = " ".join(f"({a!r} ({b!r} 0 0))" for a, b in zip(t.tolist(), v.tolist()))
        case = coupledCase(
            "immersed", f"sealed-{eps}", (n, 1, 1), (L + Ls + gap, 0.01, 0.01),
            lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), end,
            {"piston": {"type": "rigid", "rho": 7800, "motion": {
                "type": "translation", "velocity": f"table ({rows})"}}},
            {"piston": {"type": "box", "min": (L, 0, 0), "max": (L + Ls, 1, 1)}},
            gas={"poreFloor": eps}, ends=WALL, control={"reportInterval": 10},
            pointConditions="calculated")
        case.run("materialPointFoam", limit=900)
        time = case.timeName(end)
        p, rho = volField(case, time, "p"), volField(case, time, "rho.air")
        x = (np.arange(n) + 0.5)/n*(L + Ls + gap)
        g = gasLog(case)
        front = x < 0.2*L - 0.02
        exact = ((L + eps*Ls)/(0.2*L + eps*Ls))**1.4
        label = f"sealed, poreFloor {eps}"
        table.row(f"{label}: pressure after 5:1 over P0", exact, p[front].mean()/P0, 1e-2,
                  "relative")
        table.row(f"{label}: change of mass", 0, np.max(abs(g["mass"]/g["mass"][0] - 1)),
                  1e-12, "atMost")
        inside = (x > 0.2*L) & (x < 0.2*L + Ls)
        print(f"{label}: p/P0 {p[front].min()/P0:.4f} to {p[front].max()/P0:.4f}, 5^1.4"
              f" {5**1.4:.4f}, rho/rho0 {rho[front].mean()/RHO0:.4f}, in the piston"
              f" {np.round(p[inside]/P0, 3)}, behind {p[x > 0.45].mean()/P0:.5f}; exact"
              f" {((gap + 0)/(gap + 0.8*L))**1.4:.5f}")


# --- cylinder ----------------------------------------------------------------

def cylinder(table):
    n, h, Ms = 48, 1e-3, 2
    R = 12*h
    p2, rho2, u2, pr, W = shockStates(Ms)
    start = 12*h
    end = 3.5*R/(Ms*C0) + 2*R/(Ms*C0)
    cells, high = (80, n, 1), (80*h, n*h, h)
    centre = (36*h, 0.5*n*h)

    def initial(x, y, z):
        low = x < start
        return (np.where(low, rho2, RHO0), np.where(low, u2, 0.0), np.where(low, p2, P0))
    for ppc in (2, 4) if VERIFY else (2,):
        case = coupledCase(
            "immersed", f"cylinder-{ppc}", cells, high, initial, end,
            {"disc": {"type": "rigid", "rho": 7800}},
            {"disc": {"type": "cylinder", "point1": (*centre, -1), "point2": (*centre, 1),
                      "radius": R}},
            ends=OPEN, sides=WALL, control=EVERY, ppc=ppc, pointConditions="calculated")
        case.run("materialPointFoam", limit=900)
        time = case.timeName(end)
        p = volField(case, time, "p").reshape(n, 80)
        u = volField(case, time, "U.air").reshape(n, 80, 3)
        g = gasLog(case)
        label = f"cylinder, {ppc}x{ppc} points"
        table.row(f"{label}: |p - p mirrored|/p2", 0, np.max(abs(p - p[::-1]))/p2, 1e-10,
                  "atMost")
        table.row(f"{label}: |v + v mirrored|/u2", 0,
                  np.max(abs(u[..., 1] + u[::-1, :, 1]))/u2, 1e-10, "atMost")
        table.row(f"{label}: fix-ups", 0,
                  g["limited"].sum() + g["kept"].sum() + g["isentropic"].sum(), 0)
        table.row(f"{label}: least pressure over p1", 1, g["pMin"].min()/P0, 0.9, "atLeast")
        print(f"{label}: p {g['pMin'].min()/P0:.4f} p1 to {g['pMax'].max()/pr:.4f} p_r")


# --- wedge -------------------------------------------------------------------

def prism(case, name, corners):
    """A triangle along z as STL."""
    low, high = ([(x, y, z) for x, y in corners] for z in (-1.0, 2.0))
    faces = [low[::-1], high]
    for i in range(3):
        j = (i + 1) % 3
        faces += [[low[i], low[j], high[j]], [low[i], high[j], high[i]]]
    os.makedirs(case.file("constant/triSurface"), exist_ok=True)
    with open(case.file("constant/triSurface", name), "w") as f:
        f.write("solid body\n")
        for face in faces:
            f.write("facet normal 0 0 0\n outer loop\n")
            for v in face:
                f.write("  vertex {!r} {!r} {!r}\n".format(*v))
            f.write(" endloop\nendfacet\n")
        f.write("endsolid body\n")


WEDGE_TIP = 0.2


def flowOverWedge(angle, beta, cells, height, end=3.0, name="", drag=None, **options):
    """Case, x, y and p of Mach 2 (p and rho 1) over a half wedge on a plane of
    symmetry."""
    tip = WEDGE_TIP
    slope = np.tan(np.radians(angle))
    speed = 2*np.sqrt(GAMMA)
    inflow = tuple({"type": "fixedValue", "value": f"uniform {v}"}
                   for v in (1.0, 1.0, f"({speed!r} 0 0)"))
    nx, ny, _ = cells
    case = coupledCase(
        "immersed", f"wedge-{angle}-{nx}{name}", cells, (1, height, 0.01),
        lambda x, y, z: (1 + 0*x, speed + 0*x, 1 + 0*x), end,
        {"body": {"type": "rigid", "rho": 7800,
                  "drag": drag or {"type": "stick", "direction": "normal"}}},
        {"body": {"type": "surface", "surface": {
            "type": "triSurfaceMesh", "file": '"body.stl"'}}},
        patches={"inlet": ("patch", ("x-",)), "outlet": ("patch", ("x+", "y+")),
                 "axis": ("patch", ("y-",))},
        conditions={"inlet": inflow, "outlet": OPEN, "axis": WALL},
        control={"reportInterval": 20}, pointConditions="calculated",
        prepare=lambda c: prism(c, "body.stl", [
            (tip, -1e-6), (2.0, -1e-6), (2.0, (2.0 - tip)*slope)]), **options)
    case.run("materialPointFoam", limit=900)
    p = volField(case, case.timeName(end), "p").reshape(ny, nx)
    return case, (np.arange(nx) + 0.5)/nx, (np.arange(ny) + 0.5)/ny*height, p


def shockBehindTip(x, y, p, angle, beta, ratio):
    """Angle of the shock, and p behind it along x."""
    slope, tangent = np.tan(np.radians(angle)), np.tan(np.radians(beta))
    height = y[-1] + 0.5*(y[1] - y[0])
    where, behind = [], []
    at = [i for i in range(len(x)) if 0.45 < x[i] < 0.95
          and (x[i] - WEDGE_TIP)*tangent < 0.85*height]
    for i in at:
        middle = 0.5*(1 + ratio)
        j = np.max(np.nonzero(p[:, i] > middle)[0])
        where.append(y[j] + (y[1] - y[0])*(p[j, i] - middle)/(p[j, i] - p[j + 1, i]))
        s = y/(x[i] - WEDGE_TIP)
        between = (s > slope + 0.2*(tangent - slope)) & (s < slope + 0.7*(tangent - slope))
        behind.append(p[between, i].mean())
    return np.degrees(np.arctan(np.polyfit(x[at], where, 1)[0])), np.array(behind)


def wedge(table):
    for angle, beta, ratio, cells, height in (
            (10, 39.31, 1.7066, (100, 70, 1), 0.7), (20, 53.42, 2.8429, (100, 100, 1), 1.0)):
        for m in (1, 2) if VERIFY else (1,):
            size = (m*cells[0], m*cells[1], 1)
            case, x, y, p = flowOverWedge(angle, beta, size, height)
            found, behind = shockBehindTip(x, y, p, angle, beta, ratio)
            g = gasLog(case)
            label = f"wedge, half angle {angle}, {size[0]} cells"
            table.row(f"{label}: angle of the shock", beta, found, 1)
            table.row(f"{label}: p2/p1", ratio, behind.mean(), 3e-2, "relative")
            print(f"{label}: p2/p1 {behind.min():.4f} to {behind.max():.4f}, least p"
                  f" {g['pMin'].min():.3f}, fix-ups {g['limited'].sum():g}"
                  f" {g['kept'].sum():g} {g['isentropic'].sum():g}")


# --- dust --------------------------------------------------------------------

EPS, SHARE, RHO_S = 1e-2, 1e-2, 2700.0
THETA_G = 1 - (1 - EPS)*SHARE
MASS_G, MASS_S = THETA_G*RHO0, SHARE*RHO_S


def dust(name, n, initial, end, drag, velocity=None, **options):
    """Grains that fill 1 % of a periodic box and do not touch: failed points that
    are open, so that they have no stress but the pressure of the gas."""
    case = coupledCase(
        "immersed", name, (n, 1, 1), (1, 0.01, 0.01), initial, end,
        {"dust": {"drag": drag, "constitutiveModel": {
            "type": "linearElastic", "rho": RHO_S, "E": RHO_S*1e4, "nu": 0},
            "failureModel": {"type": "maxPrincipalStress", "strength": 1e3}}},
        {"dust": {"type": "cells", "volumeFraction": SHARE}},
        patches={"left": ("cyclic; neighbourPatch right", ("x-",)),
                 "right": ("cyclic; neighbourPatch left", ("x+",))}, **options)
    column = lambda c: case.file("0/lagrangian/dust", c)  # noqa: E731
    opened = 1.5
    writeField(column("damage"), np.ones(len(readField(column("m")))))
    writeField(column("V"), opened*readField(column("V")))
    stretch = readField(column("leftStretch")).copy()
    stretch[:, [0, 3, 5]] = opened**(2/3) - 1        # held as b - I
    writeField(column("leftStretch"), stretch)
    if velocity:
        u = readField(column("U")).copy()
        u[:, 0] = velocity(readField(column("x"))[:, 0])
        writeField(column("U"), u)
    return case


def sound(table):
    rhoM = MASS_G + MASS_S
    c = np.sqrt(GAMMA*P0/(THETA_G*rhoM))
    amplitude = 1e-3

    def u(x):
        return amplitude*c*np.sin(2*np.pi*x)

    def initial(x, y, z):
        p = P0 + rhoM*c*u(x)
        return RHO0*(p/P0)**(1/GAMMA), u(x), p
    errors = {}
    for n in (50, 100, 200) if VERIFY else (50, 100):
        case = dust(f"sound-{n}", n, initial, 1/c, {"type": "stick"}, u)
        case.run("materialPointFoam", limit=900)
        p = volField(case, case.timeName(1/c), "p")
        mode = np.mean((p - P0)*np.exp(-2j*np.pi*(np.arange(n) + 0.5)/n))
        start = np.mean((initial((np.arange(n) + 0.5)/n, 0, 0)[2] - P0)
                        *np.exp(-2j*np.pi*(np.arange(n) + 0.5)/n))
        errors[n] = -np.angle(mode/start)/(2*np.pi)
        print(f"dusty gas, {n} cells: speed of sound {errors[n]:+.2e}, amplitude left"
              f" {abs(mode/start):.3f}, c {c:.4f} m/s")
    table.row("dusty gas, 100 cells: speed of sound in equilibrium [m/s]", c,
              c*(1 + errors[100]), 2e-3, "relative")
    table.row("dusty gas: order, 50 to 100 cells", 1, np.log2(abs(errors[50]/errors[100])),
              1, "atLeast")


def relax(table):
    speed = 10.0
    total = 1/MASS_G + 1/MASS_S
    errors = {}
    for K in (1, 1e2, 1e4, 1e6, 1e9, 1e15):
        for part in (1, 2) if K == 1e4 else (1,):
            rate = K*total
            dt = min(1e-5, 0.1/rate if K <= 1e4 else 1e-5)/part
            steps = 200*part
            case = dust(
                f"relax-{K:g}-{part}", 8, lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x),
                steps*dt, {"type": "constant", "value": K/((1 - THETA_G)*THETA_G)},
                lambda x: speed + 0*x,
                control={**EVERY, "adjustTimeStep": False, "deltaT": dt,
                         "writeControl": "runTime"})
            case.change("system/controlDict", r"maxCo .*;", "")
            case.run("materialPointFoam")
            g = gasLog(case)
            gas = g["momentum"][:, 0]/g["mass"]
            solid = g["pointMomentum"][:, 0]/(MASS_S*1e-4)
            t = reportTimes(case)
            gap = (solid - gas)/speed
            error = np.max(abs(gap - np.exp(-rate*t)))
            label = f"relaxation, K {K:g}" + (", half the step" if part > 1 else "")
            errors[K, part] = error
            if rate*dt < 1:
                table.row(f"{label}: |gap - exp|, K dt {rate*dt:.2g} of both masses", 0,
                          error, 0.25*rate*dt, "atMost")
            else:
                table.row(f"{label}: gap after a step", 1/(1 + rate*dt), gap[0], 1e-10)
            table.row(f"{label}: least gap (no overshoot)", 0, gap.min(), -1e-12, "atLeast")
            table.row(f"{label}: momentum", 0, np.max(abs(
                (g["momentum"] + g["pointMomentum"])[:, 0]/(MASS_S*1e-4*speed) - 1)),
                1e-12, "atMost")
    table.row("relaxation: error over error of half the step", 2,
              errors[1e4, 1]/errors[1e4, 2], 0.1)


# --- thrown ------------------------------------------------------------------

def thrown(table):
    n, length, high = 100, 0.2, 2e-3
    column, width, rho = 0.1197, 0.01, 2700
    r = 12**(1/GAMMA)
    work = P0*column*((r**(GAMMA - 1) - 1)/(GAMMA - 1) - (1 - 1/r))
    u = np.sqrt(2*work/(rho*width))
    start = length - column - width
    case = coupledCase(
        "immersed", "thrown", (n, 1, 1), (length, high, high),
        lambda x, y, z: (RHO0 + 0*x, 0*x, P0 + 0*x), 9e-3,
        {"slab": {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": 7e8,
                                        "nu": 0}, "drag": {"type": "none"}}},
        {"slab": {"type": "box", "min": (start, -1, -1), "max": (start + width, 1, 1),
                  "velocity": (u, 0, 0), "stress": ambient(P0)}}, ends=WALL,
        control={"reportInterval": 20})
    case.run("materialPointFoam", limit=300)
    g = gasLog(case)
    momentum = g["pointMomentum"][:, 0]/(rho*width*high**2*u)
    table.row("slab without drag, thrown back by a gas: speed over that before", -1,
              momentum.min(), 0.02)
    table.row("slab without drag: fix-ups", 0,
              g["limited"][-1] + g["kept"][-1] + g["isentropic"][-1], 0)


def main():
    table = Report("immersed")
    parts = [piston, shock, sealed, thrown, cylinder, wedge, sound, relax]
    for part in parts:
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
