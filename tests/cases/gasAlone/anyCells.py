"""The gas on prisms, tetrahedra and polyhedra, inner points moved by 20 % (gasAlone):

    orders         isentropic vortex, simple wave between walls, density wave
    sodOnCells     Sod's tube: error beside first order, overshoots
    halvedBoxes    order, two processors, gas left alone
    uniformFlow    nothing changes
    linearFlow     a linear density in it stays linear away from the sides
    ring           a quarter with cyclic sides that turn as a whole ring
    partsOfCells   two processors against one, restart bit by bit
    tetrahedra     schemes that are not stable there are refused
"""

import os
import re
import shutil

import numpy as np

import riemannExact as exact
from foamCase import RunFailed, VERIFY
from gasCases import OPEN, UPWIND, VAN_LEER, WALL, volField
from gasOnCells import cyclicSides, densityWave, gasOnCells, simpleWave

STATE = ("theta.air", "thetaRho.air", "thetaRhoU.air", "thetaRhoE.air",
         "p", "T.air", "U.air")

MLP = {"reconstruct(rho)": "MLP", "reconstruct(U)": "MLP", "reconstruct(p)": "MLP"}

#: A row of cells along x with cyclic ends, between walls
BETWEEN_WALLS = ({**cyclicSides("x")[0], "walls": ("wall", ("y-", "y+", "z-", "z+"))},
                 {**cyclicSides("x")[1], "walls": WALL})


def vortexState(x, y):
    """Isentropic vortex of strength 5 in a stream (1, 1): Shu, ICASE report 97-65."""
    r2 = x**2 + y**2
    swirl = 5/(2*np.pi)*np.exp(0.5*(1 - r2))
    T = 1 - 0.4/(2*1.4)*swirl**2
    return T**2.5, np.column_stack([1 - swirl*y, 1 + swirl*x, 0*x]), T**3.5


def difference(a, b, time, fields=STATE):
    worst = 0.0
    for name in fields:
        u, v = volField(a, time, name), volField(b, time, name)
        worst = max(worst, np.max(abs(u - v))/max(np.max(abs(u)), 1e-300))
    return worst


def swirl(x, y, z):
    """A hot spot off the middle in a shear flow that is zero at the walls."""
    r2 = (x - 0.4)**2 + (y - 0.6)**2
    p = 1 + 4*np.exp(-r2/0.01)
    rho = 1 + 0.5*np.sin(2*np.pi*x)*np.sin(2*np.pi*y)
    u = np.column_stack([0.5*np.sin(np.pi*x)*np.cos(np.pi*y),
                         -0.5*np.cos(np.pi*x)*np.sin(np.pi*y), 0*x])
    return rho, u, p


def vortexOn(kind, n, **options):
    case, C, V = gasOnCells(
        "gasAlone", f"vortex-{kind}-{n}", kind, (n, n, 1), (5, 5, 10/n), *cyclicSides("xy"),
        lambda C, t: vortexState(C[:, 0] - t, C[:, 1] - t), 1.0, low=(-5, -5, 0), **options)
    rho = volField(case, case.timeName(1.0), "rho.air")
    return np.sum(V*abs(rho - vortexState(C[:, 0] - 1, C[:, 1] - 1)[0]))/np.sum(V)


def waveOnTets(n, state, sides):
    case, C, V = gasOnCells("gasAlone", f"{state.__name__}-tets-{n}", "tets", (n, 4, 4),
                            (1, 4/n, 4/n), *sides, state, 0.3)
    error = abs(volField(case, case.timeName(0.3), "rho.air") - state(C, 0.3)[0])
    return np.sum(V*error)/np.sum(V)


def orders(table):
    """Least squares through the faces alone blew up on tetrahedra."""
    for label, grids, run in (
            ("isentropic vortex, prisms", (25, 50), lambda n: vortexOn("prisms", n)),
            ("simple wave, tetrahedra between walls", (24, 48),
             lambda n: waveOnTets(n, simpleWave, BETWEEN_WALLS)),
            ("density wave, tetrahedra", (24, 48),
             lambda n: waveOnTets(n, densityWave, cyclicSides("xyz")))):
        errors = [run(n) for n in grids + (2*grids[-1],)*VERIFY]
        table.row(f"{label}: L1 of the density, {grids[1]} cells", 0, errors[1], 1e-3, "atMost")
        for n, a, b in zip(grids + grids[1:]*VERIFY, errors, errors[1:]):
            table.row(f"{label}: order, {n} to {2*n}", 2, np.log2(a/b), 1.8, "atLeast")


def sodOn(kind, n, reconstruct, label):
    m = n//10
    walls = ("y-", "y+") + (("z-", "z+") if kind == "tets" else ())

    def state(C, t):
        rho, u, p = (np.where(C[:, 0] < 0.5, *sides) for sides in zip(*exact.SOD))
        return rho, np.column_stack([u, 0*u, 0*u]), p
    case, C, V = gasOnCells(
        "gasAlone", f"sod-{kind}-{label}", kind, (n, m, m if kind == "tets" else 1),
        (1, m/n, m/n), {"ends": ("patch", ("x-", "x+")), "walls": ("wall", walls)},
        {"ends": OPEN, "walls": WALL}, state, 0.2, reconstruct)
    rho, u, p = (volField(case, case.timeName(0.2), f) for f in ("rho.air", "U.air", "p"))
    return case, C[:, 0], V, rho, u[:, 0], p


def sodOnCells(table):
    ps, us = exact.star(*exact.SOD)
    for kind, n, factor, most in ((("prisms", 100, 3, 2.0),)
                                  + (("tets", 60, 2.5, 5.0),)*VERIFY):
        errors = {}
        for label, reconstruct in (("upwind", UPWIND), ("vanLeer", VAN_LEER)):
            case, x, V, rho, u, p = sodOn(kind, n, reconstruct, label)
            s = (x - 0.5)/0.2
            errors[label] = (np.sum(V*abs(rho - exact.solution(*exact.SOD, s)[0]))
                             / np.sum(V))
        name = f"Sod, {kind}, {n} along the tube"
        table.row(f"{name}: L1 of the density, of first order over this", factor,
                  errors["upwind"]/errors["vanLeer"], factor, "atLeast")
        table.row(f"{name}: overshoot of u [%]", 0, 100*(u.max()/us - 1), most, "atMost")
        table.row(f"{name}: overshoot of p behind the shock [%]", 0,
                  100*(p[s > 0.2].max()/ps - 1), 2, "atMost")
        table.row(f"{name}: density beyond that of the ends", 0,
                  max(rho.max() - 1, 0.125 - rho.min()), 1e-4, "atMost")


def uniformFlow(table):
    def state(C, t):
        one = np.ones(len(C))
        return 1.2*one, np.column_stack([0.7*one, -0.4*one, 0*one]), one
    outside = ({"outside": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))},
               {"outside": OPEN})
    for kind, n, sides in (("prisms", (8, 8, 1), cyclicSides("xy")),
                           ("tets", (4, 4, 4), cyclicSides("xyz")),
                           ("polyhedra", (4, 4, 4), outside)):
        case, C, _ = gasOnCells("gasAlone", f"uniform-{kind}", kind, n, (1, 1, n[2]/n[0]),
                                *sides, state, 1.0)
        t = case.timeName(1.0)
        worst = max(np.max(abs(volField(case, t, f) - v)) for f, v in zip(
            ("rho.air", "U.air", "p"), state(C, 0)))
        table.row(f"uniform flow, {kind}, {case.nSteps()} steps: largest change", 0, worst,
                  1e-13, "atMost")


def halvedBoxes(table):
    """Limiters of boxes where cells are halved; the vortex comes out of the fine cells."""
    half = (((-6, -6, -1), (0, 6, 9)),)
    errors = [vortexOn("hexes", n, moved=0, halved=half) for n in (24, 48)]
    table.row("vortex from boxes that are halved: order, 24 to 48", 2,
              np.log2(errors[0]/errors[1]), 1.8, "atLeast")
    table.row("vortex from boxes that are halved: error over that of all coarse", 1,
              errors[1]/vortexOn("boxes", 48, moved=0), 1, "atMost")
    walls = {"walls": ("wall", ("x-", "x+", "y-", "y+", "z-", "z+"))}, {"walls": WALL}
    boxes = ((0.2, 0.2, -0.1), (0.8, 0.7, 0.7)), ((0.4, 0.4, -0.1), (0.6, 0.7, 0.4))

    whole, parts = (gasOnCells(
        "gasAlone", f"halved-{split}".replace(" ", ""), "hexes", (8, 8, 8), (1, 1, 1), *walls,
        spot, 0.1, deltaT=1e-3, moved=0, halved=boxes, split=split)[0]
        for split in (None, (2, 1, 1)))
    table.row("halved boxes: 1 against 2 processors, largest difference", 0,
              difference(whole, parts, "0.1"), 1e-12, "atMost")

    def still(C, t):
        high = np.all(C[:, :2] < 0.05, axis=1)
        return 1 + 0.5*high, np.zeros((len(C), 3)), 1 + 2.0*high

    def leaveAlone(case):
        case.change("constant/phaseProperties", "gamma", "activeRegion yes; gamma")
    every, active = (gasOnCells(
        "gasAlone", f"halved-still-{start is None}", "hexes", (60, 60, 1), (1, 1, 0.1),
        {"walls": ("wall", ("x-", "x+", "y-", "y+"))}, {"walls": WALL}, still, 0.12, deltaT=1.5e-3,
        moved=0, halved=(((0.1, -1, -1), (0.2, 2, 1)),), start=start)[0]
        for start in (None, leaveAlone))
    table.row("halved boxes: gas at rest left alone, largest difference", 0,
              difference(every, active, "0.12"), 0, "atMost")
    n, of = map(int, re.findall(r"(\d+) of (\d+) cells active", active.log())[-1])
    table.row("halved boxes: cells that were not, of all", 0, n/of, 0.75, "atMost")


def linearFlow(table):
    dt, velocity, slope = 2e-3, np.array((1.0, 0.5, -0.3)), np.array((0.1, 0.2, -0.1))
    sides = {"outside": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}, {"outside": OPEN}
    flat = {"outside": ("patch", ("x-", "x+", "y-", "y+"))}, {"outside": OPEN}
    for kind, n, (patches, conditions) in (("prisms", (10, 10, 1), flat),
                                           ("tets", (8, 8, 8), sides),
                                           ("hexes", (8, 8, 8), sides)):
        u = velocity*(1, 1, n[2] > 1)

        def state(C, t):
            return (1 + (C - u*t) @ (slope*(1, 1, n[2] > 1)), np.tile(u, (len(C), 1)),
                    np.ones(len(C)))
        halved = ((0.3, 0.3, 0.3), (0.6, 0.7, 0.6)), ((0.4, 0.4, 0.4), (0.55, 0.6, 0.6))
        case, C, _ = gasOnCells("gasAlone", f"linear-{kind}", kind, n, (1, 1, n[2]/n[0]),
                                patches, conditions, state, dt, deltaT=dt,
                                **{"moved": 0, "halved": halved} if kind == "hexes" else {})
        inner = np.all(abs(C - 0.5)[:, :2 + (n[2] > 1)] < 0.2, axis=1)
        worst = np.max(abs(volField(case, f"{dt:g}", "rho.air") - state(C, dt)[0])[inner])
        table.row(f"linear density moves, {kind}, one step: largest error of {inner.sum()}"
                  " cells", 0, worst, 1e-13, "atMost")


def spot(C, t):
    return swirl(*C.T)


def partsOfCells(table):
    """Two processors against one, restart bit by bit."""
    walls = {"walls": ("wall", ("x-", "x+", "y-", "y+", "z-", "z+"))}, {"walls": WALL}
    for kind, n, sides, split in (
            ("prisms", (12, 12, 1), cyclicSides("xy"), (2, 1, 1)),
            ("tets", (5, 5, 5), cyclicSides("xyz"), (1, 2, 1)),
            ("polyhedra", (5, 5, 5), walls, (2, 1, 1))):
        def run(name, pieces=None, start=None):
            return gasOnCells("gasAlone", f"{name}-{kind}", kind, n, (1, 1, n[2]/n[0]), *sides,
                              spot, 0.2, MLP, deltaT=2e-3, split=pieces, writes=2,
                              start=start)[0]
        one, two = run("whole"), run("halves", split)
        table.row(f"{kind}: 1 against 2 processors, largest difference", 0,
                  difference(one, two, "0.2"), 1e-12, "atMost")

        def half(case):
            for a, b in zip(two.processors(), case.processors()):
                shutil.copytree(os.path.join(a, "0.1"), os.path.join(b, "0.1"))
            case.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
        table.row(f"{kind}: restart on 2 processors, largest difference", 0,
                  difference(two, run("again", split, half), "0.2"), 0, "atMost")


def ring(table):
    """Four quarters against one. Extremes beyond sides that turn are those of cells with a
    face there: all of them on these cells in the first step."""
    def place(x):
        a = 0.5*np.pi*x[:, 1]
        return np.column_stack([x[:, 0]*np.cos(a), x[:, 0]*np.sin(a), x[:, 2]])

    def state(C, t):
        r, a = np.hypot(C[:, 0], C[:, 1]), np.arctan2(C[:, 1], C[:, 0])
        return (1 + 0.2*np.sin(4*a)*(r - 1), np.column_stack([-0.4*C[:, 1], 0.4*C[:, 0], 0*r]),
                1 + 0.3*np.cos(4*a + 1)*np.sin(np.pi*(r - 1)))
    patches, conditions = cyclicSides("y")
    sides = ({**patches, "walls": ("wall", ("x-", "x+"))}, {**conditions, "walls": WALL})
    values = []
    for quarters in (1, 4):
        case = gasOnCells("gasAlone", f"ring-{quarters}", "hexes", (8, 8*quarters, 1),
                          (2, quarters, 0.2), *sides, state, 3e-3, MLP, low=(1, 0, 0), moved=0,
                          deltaT=3e-3, place=place)[0]
        values.append(np.column_stack([volField(case, "0.003", f)
                                       for f in ("rho.air", "U.air", "p")])[:64])
    table.row("quarter of a ring against the whole, one step: largest difference", 0,
              np.max(abs(values[0] - values[1])), 1e-14, "atMost")


def tetrahedra(table):
    cases = []
    schemes = {"reconstruct(rho)": "limitedLinear 1", "reconstruct(U)": "limitedLinearV 1",
               "reconstruct(p)": "limitedLinear 1"}
    try:
        gasOnCells("gasAlone", "refused", "tets", (2, 2, 2), (1, 1, 1), *cyclicSides("xyz"),
                   densityWave, 0.1, schemes, start=cases.append)
        text = "it ran"
    except RunFailed:
        text = cases[0].log()
    missing = [w for w in ("FOAM FATAL IO", "Cell 0 at", "limitedLinearV 1", "MLP", "fvSchemes")
               if w not in text]
    table.check("limitedLinear on tetrahedra is refused", not missing, str(missing))
