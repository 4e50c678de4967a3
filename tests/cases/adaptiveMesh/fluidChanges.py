"""Fluids on a mesh that changes: a lake at rest, an interface that is carried, a dam break."""

import os
import re
import shutil

import numpy as np

from changing import adaptive, box, cellLevel, changes, comeAndGo
from fluidCases import AIR, WATER, fluidCase
from foamCase import PROJECT, VERIFY, FoamCase
from gasCases import UPWIND, volField
from gasOnCells import cyclicSides

REAL_AIR = {"thermo": "perfectGas", "R": 287, "gamma": 1.4}


def lakeCase(name, adapt, mixed=0.0, end=0.1, **options):
    """Water of H = 0.5 m (and a share of a cell), air above, 8 x 8 cells; adapt(case). Largest
    velocity at the end over sqrt(g H), and the case."""
    g, n, softened = 9.81, 8, {**WATER, "equationOfState": {
        "type": "stiffenedGas", "gamma": 1.12, "pInf": 8.82e5, "p0": 1e5}}
    case = fluidCase("adaptiveMesh", name, (n, n, 1), (1, 1, 0.1),
                     {"water": softened, "air": REAL_AIR},
                     lambda x, y, z: ([1.0*(y < 0.5), 1.0*(y > 0.5)], [1000.0, 1.2], 0.0, 1e5),
                     end, gravity=(0, -g, 0), **options, patches={
                         "walls": ("wall", ("x-", "x+", "y-", "y+"))})
    shutil.rmtree(case.file("0"))
    adapt(case)
    case.write("system/setFluidsDict", {
        "default": {"fluid": "air", "T": 300}, "hydrostatic": {"point": (0.5, 1, 0), "p": 1e5},
        "regions": {"pool": {"type": "box", "min": (-9, -9, -9), "max": (9, 0.5 + mixed/n, 9),
                             "fluid": "water"}}})
    case.run("setFluids")
    case.run("materialPointFoam")
    return np.max(abs(volField(case, case.timeName(end), "U")))/np.sqrt(0.5*g), case


def lake(table):
    """Fluids rest on cells of several sizes that stay, and when whole cells are halved or put
    together. A cell whose neighbours have other shares is halved without its gradients: what
    sits rho g h/4 off goes as a wave of sound, of velocity g h/(4 c)."""
    def halved(case):
        adaptive(case, 2, {"box": box((0.3, 0.3, -1), (0.7, 0.7, 1))}, buffer=0)
        case.run("adaptMesh")
    upwind = lakeCase("lake-upwind", halved, reconstruct=UPWIND)[0]
    table.row("lake, halved before, upwind: largest velocity over sqrt(g H)", 0, upwind, 1e-8)
    once = []
    for name, low, high in (("inside", (0.3, 0.14), (0.6, 0.24)), ("floor", (0.3, -1), (0.6, 0.1)),
                            ("corner", (-1, -1), (0.1, 0.1)),
                            ("surface", (0.3, 0.38), (0.6, 0.6)), ("air", (0.3, 0.6), (0.6, 0.8))):
        for way, times in (("halved", (1e-3, 1)), ("together", (-1, 1e-3))):
            once.append(lakeCase(f"lake-{name}-{way}", lambda c: adaptive(
                c, 2, {name: box((*low, -1), (*high, 1), 2, times)}, buffer=0, keep=0,
                interval=1), end=3e-3)[0])
    table.row(f"lake, whole cells halved twice and put together at {len(once)//2} places: largest"
              " velocity over sqrt(g H)", 0, max(once), 1e-8)
    stays, moves, n = [], [], 0
    for mixed in (0, 0.3):
        stays.append(lakeCase(f"lake-halved-{mixed}", halved, mixed)[0])
        v, case = lakeCase(f"lake-{mixed}", lambda c: comeAndGo(c, 0.1, 2, n=40), mixed)
        moves.append(v)
        n += changes(case)
    table.row("lake, halved before: largest velocity over sqrt(g H)", 0, max(stays), 1e-6)
    g, H, h, c = 9.81, 0.5, 1/8, np.sqrt(1.12*(8.82e5 + 1e5)/1000)
    table.row(f"lake through {n} changes: largest velocity over sqrt(g H)", 0, max(moves),
              g*h/(4*c)/np.sqrt(g*H))


def places(level, n):
    """Centres and widths of cells in 2D, in widths of a base cell; n base cells along x."""
    at = np.cumsum(np.concatenate([[0], 4.0**-level]))[:-1]
    cell = np.floor(at + 1e-9).astype(int)
    part, x, y = at - cell, (cell % n).astype(float), (cell//n).astype(float)
    for i in range(1, 1 + level.max()):
        digit = np.floor(part*4 + 1e-9).astype(int)
        part = part*4 - digit
        x, y = x + (digit & 1)*0.5**i, y + (digit >> 1)*0.5**i
    width = 0.5**level
    return x + 0.5*width, y + 0.5*width, width


def carried(table):
    """A disc, once along the diagonal; also coarse for a while."""
    n, end, radius = 16, 1.0, 0.25
    sides = cyclicSides("xy")[0]
    follow = {"type": "jump", "field": "alpha.air", "absolute": 0.01}

    def make(name, m, refine=None):
        case = fluidCase("adaptiveMesh", name, (n*m, n*m, 1), (1, 1, 0.1),
                         {"disc": AIR, "air": AIR},
                         lambda x, y, z: ([0.0, 1.0], [1.0, 1.0], 0.0*x, 1.0), end,
                         patches=sides, maxCoGas=0.8, control={"reportInterval": 1})
        shutil.rmtree(case.file("0"))
        flow = {"p": 1, "T": 1, "U": (1, 0.2, 0)}
        case.write("system/setFluidsDict", {
            "default": {"fluid": "air", **flow},
            "regions": {"disc": {"type": "cylinder", "radius": radius, "point1": (0.5, 0.5, -1),
                                 "point2": (0.5, 0.5, 1), "fluid": "disc", **flow, "T": 0.1}}})
        if refine:
            adaptive(case, 2, refine, buffer=0 if name == "carried-static" else 2)
            case.run("adaptMesh")
        case.run("setFluids")
        return case
    everywhere, width = ((-1, -1, -1), (2, 2, 2)), {}
    for name, case in (
            ("static", make("carried-static", 1, {"right": box((1/16, -1, -1), (2, 2, 2)),
                                                  "above": box((-1, 1/16, -1), (2, 2, 2))})),
            ("follows", make("carried", 1, {"interface": follow})),
            ("coarse", make("carried-coarse", 1, {
                "first": box(*everywhere, 2, (0, 0.3)), "then": box(*everywhere, 2, (0.5, 9))}))):
        case.run("materialPointFoam")
        time = case.timeName(end)
        a = volField(case, time, "alpha.air")
        w = places(cellLevel(case, time), n)[2]
        # Their area over the length of the interface, over the width of a fine cell
        width[name] = np.sum((w*w)[(a > 0.05) & (a < 0.95)])/(2*np.pi*radius*n)*4
        words = f"disc carried, {name}, {len(a)} cells, {changes(case)} changes"
        for fluid in ("disc", "air"):
            mass = re.findall(rf"^Fluids: mass .*?{fluid} (\S+?)(?:,| |$)", case.log(), re.M)
            table.row(f"{words}: mass of {fluid}", 1, float(mass[-1])/float(mass[0]), 1e-12)
        for field, value in (("p", 1), ("U", (1, 0.2, 0))):
            table.row(f"{words}: {field}, largest change", 0,
                      np.max(abs(volField(case, time, field) - value)), 1e-12)
    table.row("disc carried, fine where it ends: cells of its interface (5 to 95 %), beside the"
              " same with all cells fine", width["static"], width["follows"], 0.01, "relative")
    table.row("disc carried, coarse for a fifth of its way and fine again: cells of its interface",
              width["static"], width["coarse"], 3, "atMost")


def tip(case, times, n):
    """Where the water ends in the cells at the floor, half a share; mean number of cells."""
    found, cells = [], []
    for time in times:
        alpha = volField(case, time, "alpha.water")
        level = (cellLevel(case, time) if os.path.exists(case.file("system/adaptiveMeshDict"))
                 else np.zeros(len(alpha), int))
        x, y, w = places(level, n)
        floor = np.flatnonzero(y < 0.6*w)
        floor = floor[np.argsort(x[floor])]
        x, row = x[floor]/n, alpha[floor]
        i = np.max(np.nonzero(row > 0.5)[0])
        found.append(x[i] + (row[i] - 0.5)/(row[i] - row[i + 1])*(x[i + 1] - x[i]))
        cells.append(len(level))
    return np.array(found), np.mean(cells)


def dam(table):
    def make(name, n, adapt=False):
        case = FoamCase("adaptiveMesh", name, template=os.path.join(PROJECT, "tutorials/damBreak"))
        case.change("system/blockMeshDict", "^nx .*", f"nx {n};")
        case.change("system/blockMeshDict", "^ny .*", f"ny {n*3//4};")
        case.change("system/controlDict", "^endTime .*", "endTime 0.2;")
        case.run("blockMesh")
        if adapt:
            adaptive(case, 2, {"interface": {"type": "jump", "field": "alpha.water",
                                             "absolute": 0.05}}, buffer=4)
            case.run("adaptMesh")
        case.run("setFluids")
        case.run("materialPointFoam")
        return case

    for n in (32, 64) if VERIFY else (32,):
        fine, coarse = make(f"dam-{n}", n), make(f"dam-{n//4}", n//4)
        case = make(f"dam-adaptive-{n}", n//4, True)
        times = fine.times()[1:]
        x, cells = tip(fine, times, n)
        follows, some = tip(case, times, n//4)
        far = np.max(abs(tip(coarse, times, n//4)[0]/x - 1))
        table.row(f"dam break, {n} cells along, fine at the interface ({changes(case)} changes,"
                  f" {some/cells:.2f} of the cells): tip over that of all fine cells, largest"
                  f" difference (coarse: {far:.2f})", 0, np.max(abs(follows/x - 1)), 0.05)
        mass = [float(m) for m in re.findall(r"^Fluids: mass water (\S+)", case.log(), re.M)]
        table.row(f"dam break, {n} cells along: mass of water", 1, mass[-1]/mass[0], 1e-12)
