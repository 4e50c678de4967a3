#!/usr/bin/env python3
"""setFluids: shares of cells by exact cuts, states, rest, wrong input.

volumes    shapes in the unit box of boxes, moved tetrahedra and hexahedra with warped
           faces, of polyDualMesh: volume against the closed form, the mass of a charge,
           how far shares had to be corrected (not at all)
shares     a disc on moved quadrilaterals and boxes: the share of each cell against the
           area by Gauss' sums between the breaks
sections   discs, boxes and surfaces in 2D and on a wedge, whose volume is the sector's
states     order of regions, mass, energy and momentum of cells that regions share
conditions farField of p and U in pairs
rest       what lies in layers stays at rest, also as cells of any size; a column of
           water beside air starts without sound
damBreak   the tutorial on wider cells: the tip against Koshizuka and Oka's computation (Nucl.
           Sci. Eng. 123 (1996) 421-434)
processors the same on two processors, one without an interface
wrong      one message each, with the valid words
"""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from cellMesh import boxOfCells
from fluidCases import WATER
from foamCase import PROJECT, FoamCase, RunFailed, boxMesh, controlDict, runParts
from gasCases import VAN_LEER, schemes, volField
from surfaces import prisms, surfaceRegion, writeTriangles
from wedge import SECTOR, wedgeMesh

AIR = {"thermo": "perfectGas", "R": 287, "gamma": 1.4}
TNT = {"rho": 1630, "equationOfState": {"type": "JWL", "A": 3.712e11, "B": 3.231e9, "R1": 4.15,
                                        "R2": 0.95, "omega": 0.3, "E0": 7e9}}
FLUIDS = {"water": WATER, "air": AIR, "tnt": TNT}
SIDES = {"walls": ("wall", ("x-", "x+", "y-", "y+", "z-", "z+"))}
FLAT = {"walls": ("wall", ("x-", "x+", "y-", "y+")), "flat": ("empty", ("z-", "z+"))}
DEFAULT = {"fluid": "air", "p": 1e5, "T": 300}


def fluidStart(name, mesh, regions, default=None, fluids=None, more=None, gravity=None,
               control=None, before=lambda case: None, reconstruct=VAN_LEER):
    """A case with its mesh and fields; mesh(case) makes it."""
    case = FoamCase("setFluids", name)
    case.write("system/fvSchemes", schemes(reconstruct))
    case.write("system/fvSolution", {})
    case.write("system/controlDict", {**controlDict(1e-6, 1e-6, deltaT=1e-6), **(control or {})})
    fluids = fluids or FLUIDS
    case.write("constant/phaseProperties", {
        "phases": list(fluids), **{f: {"type": "fluid", **v} for f, v in fluids.items()}})
    if gravity is not None:
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": tuple(gravity)},
                   "uniformDimensionedVectorField")
    mesh(case)
    before(case)
    case.write("system/setFluidsDict", {"default": default or DEFAULT, "regions": regions,
                                        **(more or {})})
    case.run("setFluids")
    return case


def boxes(low, high, n, patches):
    def make(case):
        case.write("system/blockMeshDict", boxMesh(low, high, n, patches))
        case.run("blockMesh")
    return make


def unitBox(kind, n):
    if kind == "boxes":
        return boxes((0, 0, 0), (1, 1, 1), (n, n, n), SIDES)

    def make(case):
        boxOfCells(case, "warped" if kind == "warped" else "tets", (0, 0, 0), (1, 1, 1),
                   (n, n, n), SIDES)
        if kind == "polyhedra":
            case.run("polyDualMesh", "60", "-overwrite")
    return make


def cellVolumes(case):
    case.run("postProcess", "-func", "writeCellVolumes", "-time", "0")
    return volField(case, "0", "V")*np.ones(1)


def corrected(case, region):
    """The table's largest change of a share."""
    for line in case.log("setFluids").splitlines():
        if line.split()[:1] == [region]:
            return float(line.split()[5])
    raise RunFailed(f"no line of region {region}")


def torus(case, name, centre, R, r, n=24, m=12):
    """Triangles of a torus about z; their volume, of points of single precision as those of
    an STL file."""
    a, b = np.meshgrid(2*np.pi*np.arange(n)/n, 2*np.pi*np.arange(m)/m, indexing="ij")
    x = np.stack(((R + r*np.cos(b))*np.cos(a), (R + r*np.cos(b))*np.sin(a), r*np.sin(b)),
                 axis=-1) + centre
    x = np.float32(x).astype(float)
    triangles = []
    for i in range(n):
        for j in range(m):
            p, q, s, t = (x[i, j], x[(i + 1) % n, j], x[(i + 1) % n, (j + 1) % m],
                          x[i, (j + 1) % m])
            triangles += [(p, q, s), (p, s, t)]
    writeTriangles(case, name, [tuple(tuple(map(float, v)) for v in t) for t in triangles])
    t = np.array(triangles) - centre
    return np.sum(np.cross(t[:, 0], t[:, 1])*t[:, 2])/6


# --- volumes -----------------------------------------------------------------

C = np.array([0.47, 0.52, 0.49])
AXIS = np.array([0.3, 0.2, 0.25])


def lens(R, d):
    """Volume of two balls of radius R, centres d apart."""
    return 2*(4*np.pi/3)*R**3 - np.pi*(4*R + d)*(2*R - d)**2/12


SHAPES = {
    "box": ({"type": "box", "min": (0.13, 0.21, 0.33), "max": (0.77, 0.68, 0.81)},
            0.64*0.47*0.48),
    "sphere": ({"type": "sphere", "centre": C, "radius": 0.37}, 4*np.pi/3*0.37**3),
    "shell": ({"type": "sphere", "centre": C, "radius": 0.37, "innerRadius": 0.36},
              4*np.pi/3*(0.37**3 - 0.36**3)),
    "small sphere": ({"type": "sphere", "centre": C, "radius": 0.01}, 4*np.pi/3*1e-6),
    "cylinder": ({"type": "cylinder", "point1": C - AXIS, "point2": C + AXIS, "radius": 0.17},
                 np.pi*0.17**2*2*np.linalg.norm(AXIS)),
    "difference": ({"type": "difference", "shapes": {
        "a": {"type": "box", "min": (0.13, 0.21, 0.33), "max": (0.77, 0.68, 0.81)},
        "b": {"type": "sphere", "centre": (0.5, 0.4, 0.6), "radius": 0.15}}},
        0.64*0.47*0.48 - 4*np.pi/3*0.15**3),
}


def charge(shape):
    return {"charge": {**shape, "fluid": "water", "mass": 1, "p": 1e5}}


def oneVolume(table, kind, n, label, shape, exact, limit=1e-10, limitCorrected=1e-12,
              before=lambda case: None):
    name = f"{label.replace(' ', '-')}-{kind}"
    case = fluidStart(name, unitBox(kind, n), charge(shape), before=before)
    V = cellVolumes(case)
    a, rho = volField(case, "0", "alpha.water"), volField(case, "0", "rho.water")
    where = f"{label}, {kind}"
    table.row(f"{where}: volume", exact, np.sum(a*V), limit, "relative")
    table.row(f"{where}: a charge of 1 kg [kg]", 1, np.sum(a*V*rho), 1e-10)
    table.row(f"{where}: largest correction of a share", 0, corrected(case, "charge"),
              limitCorrected, "atMost")
    table.row(f"{where}: shares, sum of both fluids", 0,
              np.max(abs(a + volField(case, "0", "alpha.air") - 1)), 1e-14)


def volumes(table):
    for kind, n in (("boxes", 12), ("tets", 6), ("polyhedra", 6), ("warped", 8)):
        for label, (shape, exact) in SHAPES.items():
            # The volume of the box less a sphere is not known: nothing is corrected
            oneVolume(table, kind, n, label, shape, exact)
        found = []
        case = FoamCase("setFluids", "torus")
        found.append(torus(case, "torus.stl", C, 0.3, 0.1))
        oneVolume(table, kind, n, "torus", surfaceRegion("torus.stl"), found[0],
                  before=lambda c: torus(c, "torus.stl", C, 0.3, 0.1))
    # Two curved surfaces in one cell: halved, then planes
    two = {"type": "union", "shapes": {
        k: {"type": "sphere", "centre": C + s*np.array([0.1, 0, 0]), "radius": 0.2}
        for k, s in (("a", 1), ("b", -1))}}
    oneVolume(table, "boxes", 12, "two spheres", two, lens(0.2, 0.2), 1e-7)


# --- shares ------------------------------------------------------------------

def discInColumn(x, y0, y1, R):
    """int of the height of a disc (centre 0) in y0..y1 over x[0]..x[1], exact."""
    def F(t):
        t = np.clip(t, -R, R)
        return 0.5*(t*np.sqrt(max(R*R - t*t, 0)) + R*R*np.arcsin(t/R))
    cuts = {max(x[0], -R), min(x[1], R)}
    for y in (y0, y1):
        if abs(y) < R:
            r = np.sqrt(R*R - y*y)
            cuts |= {t for t in (-r, r) if max(x[0], -R) < t < min(x[1], R)}
    cuts = sorted(cuts)
    total = 0.0
    for a, b in zip(cuts[:-1], cuts[1:]):
        top = np.sqrt(max(R*R - (0.5*(a + b))**2, 0))
        up = (y1*(b - a) if y1 < top else F(b) - F(a)) if y1 > -top else None
        low = (y0*(b - a) if y0 > -top else F(a) - F(b)) if y0 < top else None
        total += up - low if up is not None and low is not None else 0
    return total


def shares(table):
    n, R = 20, 0.33
    case = fluidStart("shares", boxes((0, 0, 0), (1, 1, 0.05), (n, n, 1), FLAT),
                      charge({"type": "sphere", "centre": C, "radius": R}))
    a = volField(case, "0", "alpha.water").reshape(n, n)
    exact = np.array([[discInColumn((i/n - C[0], (i + 1)/n - C[0]), j/n - C[1],
                                    (j + 1)/n - C[1], R)*n*n
                       for i in range(n)] for j in range(n)])
    table.row("disc on boxes: largest error of a share", 0, np.max(abs(a - exact)), 1e-13)
    table.row("disc on boxes: cells that it cuts", 60, np.sum((a > 0) & (a < 1)), 10)


# --- sections ----------------------------------------------------------------

def sections(table):
    polygon = [(0.2, 0.2), (0.7, 0.3), (0.6, 0.7), (0.3, 0.6)]
    x, y = np.array(polygon, np.float32).astype(float).T
    area = 0.5*np.sum(x*np.roll(y, -1) - y*np.roll(x, -1))

    def moved(case):
        boxOfCells(case, "prisms", (0, 0, 0), (1, 1, 0.1), (10, 10, 1), FLAT)
    for label, shape, exact in (
            ("disc", {"type": "sphere", "centre": C, "radius": 0.3}, 0.1*np.pi*0.09),
            ("box", SHAPES["box"][0], 0.1*0.64*0.47),
            ("surface", surfaceRegion("body.stl"), 0.1*area)):
        case = fluidStart(f"2D-{label}", moved, charge(shape),
                          before=lambda c: prisms(c, "body.stl", [polygon]))
        V = cellVolumes(case)
        mass = volField(case, "0", "alpha.water")*V
        table.row(f"2D, prisms, {label}: volume", exact, np.sum(mass), 1e-10, "relative")
        table.row(f"2D, prisms, {label}: largest correction", 0, corrected(case, "charge"),
                  1e-12, "atMost")

    def wedge(case):
        case.write("system/blockMeshDict", wedgeMesh(
            (0, 0), (1, 0.8), (20, 16), {"ends": ("patch", "x-"), "right": ("patch", "x+"),
                                         "wall": ("wall", "r+")}))
        case.run("blockMesh")
    moment = np.sum((x*np.roll(y, -1) - y*np.roll(x, -1))*(y + np.roll(y, -1)))/6
    for label, shape, exact in (
            ("sphere", {"type": "sphere", "centre": (0.5, 0, 0), "radius": 0.33},
             SECTOR*2*0.33**3/3),
            ("torus", {"type": "sphere", "centre": (0.5, 0.4, 0), "radius": 0.23},
             SECTOR*0.4*np.pi*0.23**2),
            ("ring", {"type": "box", "min": (0.22, 0.13, -1), "max": (0.71, 0.57, 1)},
             SECTOR*0.49*(0.57**2 - 0.13**2)/2),
            ("surface", surfaceRegion("body.stl"), SECTOR*moment)):
        case = fluidStart(f"wedge-{label}", wedge, charge(shape),
                          before=lambda c: prisms(c, "body.stl", [polygon]))
        V = cellVolumes(case)
        a, rho = volField(case, "0", "alpha.water"), volField(case, "0", "rho.water")
        table.row(f"wedge, {label}: volume of the sector", exact, np.sum(a*V), 1e-10, "relative")
        table.row(f"wedge, {label}: a charge of 1 kg [kg]", 1, np.sum(a*V*rho), 1e-10)
        table.row(f"wedge, {label}: largest correction", 0, corrected(case, "charge"), 1e-11,
                  "atMost")


# --- states ------------------------------------------------------------------

def states(table):
    """Water, a bubble in it, a charge on top of both, in cells that cut them all."""
    ball = 4*np.pi/3
    case = fluidStart("states", unitBox("boxes", 7), {
        "pool": {"type": "box", "min": (-1, -1, -1), "max": (2, 2, 0.55), "fluid": "water",
                 "rho": 998, "U": (0, 0, 2)},
        "bubble": {"type": "sphere", "centre": C, "radius": 0.31, "fluid": "air", "T": 400,
                   "p": 3e5},
        "charge": {"type": "sphere", "centre": C, "radius": 0.2, "fluid": "tnt", "mass": 5,
                   "p": 1e9, "U": (1, 0, 0)}})
    V = cellVolumes(case)
    field = {f: volField(case, "0", f) for f in
             ("p", "U", "alpha.water", "alpha.air", "alpha.tnt", "T.air", "rho.water", "rho.tnt")}
    h = 0.55 - C[2]
    above = np.pi*(0.31 - h)**2*(2*0.31 + h)/3
    bubble, core = ball*0.31**3, ball*0.2**3
    water, air = 0.55 - (bubble - above), bubble - core
    masses = {"water": 998*water, "tnt": 5.0,
              "air": (1 - 0.55 - above)*1e5/(287*300) + air*3e5/(287*400)}
    rho = {"water": field["rho.water"], "tnt": field["rho.tnt"],
           "air": field["p"]/(287*field["T.air"])}
    for f, mass in masses.items():
        table.row(f"order of regions: mass of {f}", mass,
                  np.sum(field["alpha." + f]*rho[f]*V), 1e-8, "relative")
    total = sum(field["alpha." + f]*rho[f]*V for f in masses)
    table.row("order of regions: momentum along z", 2*masses["water"],
              np.sum(total*field["U"][:, 2]), 1e-8, "relative")
    table.row("order of regions: momentum along x", 5, np.sum(total*field["U"][:, 0]), 1e-8,
              "relative")
    A, B, R1, R2, w, r0 = 3.712e11, 3.231e9, 4.15, 0.95, 0.3, 1630

    def jwl(p, r):
        v = r0/r
        return (p - A*(1 - w/R1/v)*np.exp(-R1*v) - B*(1 - w/R2/v)*np.exp(-R2*v))/w
    p = field["p"]
    energy = (field["alpha.water"]*(p + 4.4*6e8)/3.4 + field["alpha.air"]*p/0.4
              + np.where(field["alpha.tnt"] > 0, field["alpha.tnt"]*jwl(p, rho["tnt"]), 0))
    table.row("order of regions: internal energy",
              water*(1e5 + 4.4*6e8)/3.4 + ((1 - 0.55 - above)*1e5 + air*3e5)/0.4
              + core*jwl(1e9, 5/core), np.sum(energy*V), 1e-7, "relative")


# --- rest --------------------------------------------------------------------

def conditions(table):
    """A field without a file: farField where the other of p and U has it, else by its patch."""
    sides = {"walls": ("wall", ("x-", "x+", "y-")), "top": ("patch", ("y+",)),
             "flat": ("empty", ("z-", "z+"))}
    far = {"p": {"type": "farField", "farValue": "uniform 1e5", "value": "uniform 1e5"},
           "U": {"type": "farField", "value": "uniform (0 0 0)"}}
    for given, other, kind, unit in (("p", "U", "volScalarField", "[1 -1 -2 0 0 0 0]"),
                                     ("U", "p", "volVectorField", "[0 1 -1 0 0 0 0]"),
                                     ("none", "p", "", "")):
        def before(case):
            if kind:
                case.write("0/" + given, {
                    "dimensions": unit, "internalField": far[given]["value"],
                    "boundaryField": {"top": far[given], "flat": {"type": "empty"},
                                      "walls": {"type": "zeroGradient"}}}, kind)
        case = fluidStart(f"far-{given}", boxes((0, 0, 0), (1, 1, 0.1), (4, 4, 1), sides), {
            "a": {"type": "box", "min": (-1, -1, -1), "max": (2, 0.5, 1), "fluid": "water"}},
                          before=before, control={"writeFormat": "ascii"})
        types = {p: case.get("0/" + other)["boundaryField"][p]["type"] for p in sides}
        table.check(f"farField of {given}: conditions of {other}", types == {
            "walls": "slip" if other == "U" else "zeroGradient", "flat": "empty",
            "top": "farField" if kind else "zeroGradient"}, types)
        case.run("materialPointFoam", "-dry-run")


def bank():
    """blockMeshDict: 5 x 20 boxes, and as many cells over ground that rises by 0.3."""
    x = (0, 0.25, 0.5)
    return {"scale": 1, "vertices": [(x[i], y, z) for z in (0, 0.05) for i, y in (
                (0, 0), (1, 0), (2, 0.3), (0, 1), (1, 1), (2, 1))],
            "blocks": "(" + " ".join(
                f"hex ({i} {i + 1} {i + 4} {i + 3} {i + 6} {i + 7} {i + 10} {i + 9})"
                " (5 20 1) simpleGrading (1 1 1)" for i in (0, 1)) + ")",
            "boundary": "(walls { type wall; faces ((0 1 7 6) (1 2 8 7) (3 4 10 9) (4 5 11 10)"
            " (0 3 9 6) (2 5 11 8)); } sides { type empty; faces ((0 1 4 3) (1 2 5 4) (6 7 10 9)"
            " (7 8 11 10)); })"}


def rest(table):
    layers = {"pool": {"type": "box", "min": (-9, -9, -9), "max": (9, 0.437, 9),
                       "fluid": "water"}}
    more = {"hydrostatic": {"point": (0.5, 1, 0.05), "p": 1e5}}
    run = {"deltaT": 1e-5, "endTime": 1e-2, "writeInterval": 1e-2, "adjustTimeStep": False}
    default = {"fluid": "air", "T": 300}
    case = fluidStart("layers", boxes((0, 0, 0), (1, 1, 0.1), (4, 40, 1), FLAT), layers, default,
                      {"water": WATER, "air": AIR}, more, (0, -9.81, 0), run)
    p = volField(case, "0", "p")
    a = volField(case, "0", "alpha.water").reshape(40, 4)[:, 0]
    rho = a*1000 + (1 - a)*p.reshape(40, 4)[:, 0]/(287*300)
    table.row("layers: weight of all [Pa]", 9.81/40*np.sum(rho) - 9.81/80*rho[0],
              p[0] - 1e5, 1e-8*p[0])
    case.run("materialPointFoam")
    table.row("layers: largest velocity after 1000 steps [m/s]", 0,
              np.max(abs(volField(case, case.timeName(1e-2), "U"))), 1e-9)

    def graded(c):
        c.write("system/blockMeshDict", boxMesh((0, 0, 0), (1, 1, 0.1), (4, 30, 1), FLAT))
        path = c.file("system/blockMeshDict")
        with open(path) as f:
            text = f.read()
        with open(path, "w") as f:
            f.write(text.replace("simpleGrading (1 1 1)", "simpleGrading (3 0.2 1)"))
        c.run("blockMesh")
    case = fluidStart("graded", graded, layers, default, {"water": WATER, "air": AIR}, more,
                      (0, -9.81, 0), run)
    case.run("materialPointFoam")
    table.row("layers, graded cells: largest velocity after 1000 steps [m/s]", 0,
              np.max(abs(volField(case, case.timeName(1e-2), "U"))), 1e-9)

    # Any cells: upwind to rounding, of second order but for the change of density. The surface
    # cuts cells; bank: boxes beside cells that rise with the ground. Of warped faces the pressure is
    # not linear, and MLP has more of that on polyhedra: 0.15 and 2.5 % of g t
    for kind in ("prisms", "tets", "quadrilaterals", "warped", "polyhedra", "bank"):
        for scheme, limit in (("upwind", 1e-8), ("MLP", 1e-4)):
            def cells(c, kind=kind):
                flat = kind in ("prisms", "quadrilaterals", "bank")
                if kind == "bank":
                    c.write("system/blockMeshDict", bank())
                    c.run("blockMesh")
                    return
                boxOfCells(c, "tets" if kind == "polyhedra" else kind, (0, 0, 0),
                           (0.5, 1, 0.05 if flat else 0.25), (10, 20, 1 if flat else 5),
                           {"walls": ("wall", ("x-", "x+", "y-", "y+")),
                            "sides": ("empty" if flat else "wall", ("z-", "z+"))})
                if kind == "polyhedra":
                    c.run("polyDualMesh", "60", "-overwrite")
            case = fluidStart(
                f"layers-{kind}-{scheme}", cells, layers, default, {"water": WATER, "air": AIR},
                {"hydrostatic": {"point": (0.25, 1, 0.02), "p": 1e5}}, (0, -9.81, 0),
                {**run, "deltaT": 2e-6, "endTime": 2e-3, "writeInterval": 2e-3},
                reconstruct={f"reconstruct({q})": scheme for q in ("rho", "U", "p")})
            case.run("materialPointFoam")
            # 1e-4: 0.5 % of g t
            if kind in ("warped", "polyhedra"):
                limit = 5e-4 if (kind, scheme) == ("polyhedra", "MLP") else 3e-5
            table.row(f"layers, {kind}, {scheme}: largest velocity after 1000 steps [m/s]", 0,
                      np.max(abs(volField(case, case.timeName(2e-3), "U"))), limit)

    # A column beside air: without sound from the start the pressure at the bottom's corner
    # stays near that of the incompressible solution
    column = {"column": {"type": "box", "min": (-9, -9, -9), "max": (0.3, 0.6, 9),
                         "fluid": "water"}}
    case = fluidStart("column", boxes((0, 0, 0), (1, 1, 0.1), (20, 20, 1), FLAT), column,
                      default, {"water": WATER, "air": AIR}, more, (0, -9.81, 0),
                      {**run, "endTime": 2e-3, "writeInterval": 1e-3, "deltaT": 5e-6})
    first = volField(case, "0", "p")
    case.run("materialPointFoam")
    full = 9810*0.6
    for time in case.times()[1:]:
        p = volField(case, time, "p")
        table.row(f"column beside air: (p - p start)/(rho g H) of the corner, t {time} s", 0,
                  (p[0] - first[0])/full, 0.1)


# --- dam break ---------------------------------------------------------------

#: t sqrt(2 g/a), x/a, computed by Koshizuka and Oka
TIP = np.array([(0.591, 1.205), (1.095, 1.637), (1.536, 2.1), (2.043, 2.707), (2.451, 3.251),
                (2.752, 3.7)])


def dam(name, nx, ny, end):
    """The tutorial on other cells and to another time, with its mesh and fields."""
    case = FoamCase("setFluids", name, template=os.path.join(PROJECT, "tutorials", "damBreak"))
    for file, old, new in (("system/blockMeshDict", "nx      64", f"nx {nx}"),
                           ("system/blockMeshDict", "ny      48", f"ny {ny}"),
                           ("system/controlDict", "endTime         0.28", f"endTime {end}")):
        with open(case.file(file)) as f:
            text = f.read()
        if old not in text:
            raise RunFailed(f"{file} has no '{old}'")
        with open(case.file(file), "w") as f:
            f.write(text.replace(old, new))
    case.run("blockMesh")
    case.run("setFluids")
    return case


def damBreak(table):
    nx, ny = 40, 30
    case = dam("damBreak", nx, ny, 0.25)
    case.set("system/controlDict", "maxCoGas", 0.4)     # with 0.6 it comes later by 1 %
    case.run("materialPointFoam")
    a, h = 0.146, 0.584/nx
    times = case.times()
    x = []
    for time in times:
        row = (volField(case, time, "alpha.water")*np.ones(nx*ny))[:nx]
        i = np.max(np.nonzero(row > 0.5)[0])
        x.append((i + 0.5 + (row[i] - 0.5)/(row[i] - row[i + 1]))*h/a)
    T = np.array(times, float)*np.sqrt(2*9.81/a)
    off = np.interp(TIP[:, 0], T, x)/TIP[:, 1] - 1
    table.row("dam break, 10 cells over the column's width: tip, largest relative difference", 0,
              np.max(abs(off)), 0.1)
    table.row("dam break: mass of water [kg]", 426.32e-3, np.sum(
        volField(case, times[-1], "thetaRho.water"))*h*h*0.01, 1e-12, "relative")


def processors(table):
    """The right half is air alone: its processor has no interface. The sheared air beside the
    column makes rounding grow a hundredfold in 10 ms."""
    one = dam("processors-1", 32, 24, 0.005)
    one.run("materialPointFoam")
    other = dam("processors-2", 32, 24, 0.005)
    other.decompose((2, 1, 1))
    other.runParallel()
    time = one.times()[-1]
    # The velocity over that of free fall through the column's width
    worst = max(np.max(abs(volField(one, time, f) - volField(other, time, f)))/size
                for f, size in (("p", 1e5), ("U", np.sqrt(2*9.81*0.146)), ("alpha.water", 1)))
    table.row("dam break, 2 processors: largest difference", 0, worst, 1e-10)


# --- wrong input -------------------------------------------------------------

def wrong(table):
    ball = {"type": "sphere", "centre": (0.5, 0.5, 0.05), "radius": 0.2, "fluid": "water"}
    mesh = boxes((0, 0, 0), (1, 1, 0.1), (4, 4, 1), FLAT)
    top = {"hydrostatic": {"point": (0.5, 1, 0), "p": 1e5}}
    for label, regions, default, more, words in (
            ("fluid", {"a": {**ball, "fluid": "watr"}}, None, None, ("watr", "water", "tnt")),
            ("type", {"a": {**ball, "type": "ball"}}, None, None, ("ball", "sphere", "union")),
            ("keyword", {"a": {**ball, "radios": 1}}, None, None, ("radios", "radius")),
            ("temperature", {"a": {**ball, "T": 300}}, None, None, ("T", "perfectGas")),
            ("twoDensities", {"a": {**ball, "rho": 1, "mass": 1}}, None, None,
             ("several", "rho", "mass")),
            ("noDensity", {"a": {**ball, "fluid": "air"}}, None, None, ("none", "T", "rho")),
            ("velocity", {"a": {**ball, "U": (0, 0, 1)}}, None, None, ("U", "does not compute")),
            ("outside", {"a": {**ball, "centre": (3, 3, 0)}}, None, None,
             ("fills no part", "shape lies in")),
            ("covered", {"a": ball, "b": {**ball, "radius": 0.3, "fluid": "tnt"}}, None, None,
             ("covered", "on top")),
            ("noPressure", {"a": ball}, {"fluid": "air", "T": 300}, None,
             ("nowhere", "hydrostatic")),
            ("twoPressures", {"a": ball}, None, top, ("gravity", "constant/g", "(0 -9.81 0)")),
            ("negative", {"a": {**ball, "fluid": "air", "T": 300, "p": -1}}, None, None,
             ("p", "greater than 0")),
            ("noSound", {"a": {**ball, "p": -7e8}}, None, None, ("speed of sound",)),
            ("defaultMass", {"a": ball}, {"fluid": "air", "p": 1e5, "mass": 1}, None,
             ("mass", "shape")),
            ("hydrostatik", {"a": ball}, None, {"R": 1, "hydrostatik": {"p": 1e5}},
             ("Unknown keyword hydrostatik in", "is hydrostatic meant?", "regions")),
            ("notADictionary", {"a": 3}, None, None, ("not a dictionary", "type box"))):
        case = None
        try:
            fluidStart("wrong-" + label, mesh, regions, default, more=more)
            table.check(f"wrong input: {label}", False, "ran")
            continue
        except RunFailed:
            case = FoamCase.__new__(FoamCase)
        with open(os.path.join(os.path.dirname(__file__), "../../run/setFluids",
                               "wrong-" + label, "log.setFluids")) as f:
            text = f.read()
        del case
        missing = [w for w in words if w not in text]
        table.check(f"wrong input: {label}",
                    not missing and text.count("FOAM FATAL") == 1 and "printStack" not in text,
                    f"message lacks {missing}")
    case = fluidStart("variable", mesh, {"a": ball})
    case.write("system/setFluidsDict", {"R": 0.2, "default": DEFAULT, "regions": {
        "a": {**ball, "radius": "$R"}}})
    case.run("setFluids")
    table.row("variable of one's own at the top: disc's volume [m3]", 0.1*np.pi*0.2**2,
              np.sum(case.field("0", "alpha.water"))*0.1/16, 1e-12)
    for T, told in ((20, 1), (300, 0)):
        case = fluidStart(f"T-{T}", mesh, {"a": {**ball, "fluid": "air", "T": T}})
        table.row(f"air of T {T}: warnings of degrees Celsius", told,
                  case.log("setFluids").count("20 degrees Celsius are 293.15 K"), 0)
    # A cell at its border has the pressure of both energies, and a gas of few K
    case = fluidStart("pressed", boxes((0, 0, 0), (1, 1, 0.1), (40, 40, 1), FLAT), {
        "a": {**ball, "fluid": "air", "T": 200, "p": 2e7}}, default={"fluid": "water", "p": 1e5})
    mixed = case.field("0", "alpha.air")
    mixed = case.field("0", "T.air")[(mixed > 0.01) & (mixed < 0.99)]
    table.row("air of 20 MPa in water: least T of mixed cells", 60, mixed.min(), 60, "atMost")
    case.run("materialPointFoam", "-dry-run")
    table.check("... no warning of degrees Celsius", "Celsius" not in case.log(), case.log()[-300:])
    case = fluidStart("outside", mesh, {"a": {**ball, "centre": (0, 0.3, 0)}})
    table.check("a ball of which half lies in the mesh: said",
                "of the sphere 50 % lie in the mesh" in case.log("setFluids"),
                case.log("setFluids")[-700:])


if __name__ == "__main__":
    sys.exit(runParts("setFluids", volumes, shares, sections, states, conditions, rest, damBreak,
                      processors, wrong))
