"""What works on boxes, on cells of any kind: small scenes on triangles and moved
quadrilaterals (2D: prisms and hexahedra one cell deep) and on tetrahedra, none of which
names a shape function: nodeDual is the default there.
"""

import math
import re

import numpy as np

from cellMesh import boxOfCells
from foamCase import FoamCase, RunFailed, controlDict, noSchemes, velocityFile
from meshes import BASE
from pendulum import G, slidingSector, turningPoints

H = 0.05
LAW = {"type": "linearElastic", "rho": 1000, "E": 4e5, "nu": 0.3}
FLIP = {"transfer": "FLIP", "PICfraction": 0.01}
FMPM = {"transfer": "FMPM", "order": 2}
LIBS = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}
BALANCE = {"balance": {"type": "materialPointBalance", **LIBS}}
ENERGY = {"energy": {"type": "materialPointEnergy", **LIBS}}


def scene(name, kind, n, phases, regions, end, sides=None, numerics=FLIP, gravity=None,
          functions=None, size=H, maxCo=0.4, place=None, moved=0.2, run=True, change=None,
          **more):
    """A box of n cells from the origin; two numbers: one cell deep between empty sides.
    sides: patch: (sides, condition); all others are free. Regions keep their planes;
    where place moves the box they are its cells there. change: of the mesh, called with
    the case."""
    case = FoamCase("anyMesh", f"{name}-{kind}".replace(" ", "-").replace(",", ""))
    dim = len(n)
    n = tuple(n) + (1,)*(3 - dim)
    own = sides or {}
    taken = [s for of, _ in own.values() for s in of]
    rest = [a + s for a in "xyz"[:dim] for s in "-+" if a + s not in taken]
    patches = {p: ("patch", of) for p, (of, _) in own.items()}
    conditions = {p: condition for p, (_, condition) in own.items()}
    if rest:
        patches["rest"], conditions["rest"] = ("patch", rest), "calculated"
    if dim == 2:
        patches["empty"], conditions["empty"] = ("empty", ("z-", "z+")), "empty"
    kept = set()
    for r in regions.values():
        for corner in ("min", "max"):
            for d in range(dim):
                at = r.get(corner, (-1, -1, -1))[d]/size
                if abs(at - round(at)) < 1e-9:
                    kept.add((d, round(at)))
    zones = {key: (np.array(r["min"]) - 1e-6*size, np.array(r["max"]) + 1e-6*size)
             for key, r in regions.items()} if place else None
    boxOfCells(case, BASE.get(kind, (kind,))[0], (0, 0, 0), [size*m for m in n], n,
               patches, moved=moved, kept=sorted(kept), place=place, zones=zones)
    case.write("constant/phaseProperties", {"phases": list(phases), **phases, **more})
    for field in {p.get("velocityField", key) for key, p in phases.items()}:
        velocityFile(case, field, conditions)
    if place:
        regions = {key: {"type": "cellZone", "zone": key,
                         **{k: v for k, v in r.items() if k not in ("min", "max")}}
                   for key, r in regions.items()}
    case.write("system/setMaterialPointsDict", {"regions": {
        key: {"phase": key, "type": "box", "pointsPerCell": 2, **r}
        for key, r in regions.items()}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    control = controlDict(end, end, maxCo, functions={**BALANCE, **(functions or {})})
    control["reportInterval"] = 10
    case.write("system/controlDict", control)
    if gravity is not None:
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": gravity},
                   "uniformDimensionedVectorField")
    if change:
        change(case)
    case.run("setMaterialPoints")
    if run:
        case.run("materialPointFoam", limit=300)
    return case


def balance(case, phase):
    """Time, mass, momentum, kinetic energy."""
    record = case.series("balance", f"{phase}.dat")
    return record[:, 0], record[:, 2], record[:, 3:6], record[:, 9]


def turned(angle):
    """A box turned in its plane."""
    c, s = math.cos(angle), math.sin(angle)
    return lambda x: np.stack((c*x[:, 0] - s*x[:, 1], s*x[:, 0] + c*x[:, 1], x[:, 2]), 1)




def slope(table):
    """A block slides down an oblique slip wall: g sin along it, to rounding, and what
    the wall takes is what its momentum misses."""
    angle = math.radians(-30)
    along = np.array((math.cos(angle), math.sin(angle), 0))
    wall = {"forces": {"type": "materialPointPatchForces", "patches": "(wall)", **LIBS}}
    for kind, n in (("prisms", (10, 5)), ("hexes", (10, 5)), ("tets", (8, 4, 4))):
        deep = len(n) == 3
        case = scene(
            "slope", kind, n, {"block": {"constitutiveModel": LAW}},
            {"block": {"min": (2*H, 0, H*deep), "max": (5*H, 2*H, 3*H if deep else H)}},
            0.1, {"wall": (("y-",), "slip")}, gravity=(0, -G, 0), functions=wall,
            place=turned(angle))
        t, m, P, _ = balance(case, "block")
        label = f"slope, {kind}"
        table.row(f"{label}: momentum along the wall/m g sin t - 1", 0,
                  np.max(abs(P @ along/(m*G*math.sin(-angle)*t) - 1)[1:]), 1e-10)
        force = case.series("forces", "wall.dat")
        given = np.cumsum(np.diff(np.concatenate(([0], t)))[:, None]*force[:, 1:4], axis=0)
        missing = np.outer(m*t, (0, -G, 0)) - P
        table.row(f"{label}: impulse on the wall / missing momentum - 1", 0,
                  np.max(np.linalg.norm(given - missing, axis=1))
                  / np.max(np.linalg.norm(missing, axis=1)), 1e-10)


def swing(kind, mu, how, numerics, m=2, name=""):
    """Half a swing of a block in a half-pipe, 27 m cells along it: turning point and
    largest momentum over the mass, exact and seen."""
    ri, ro, nr, nt = 0.8, 1.0, 2*m, 27*m
    low = 0.7
    hr, half = (ro - low)/(3*m), math.radians(90)
    ht = 2*half/nt
    theta0, a = 7*m*ht, 2*m*ht

    def place(x):
        # Up in the box is to the pipe's axis
        theta, r = x[:, 0]/H*ht - half, ro - x[:, 1]/H*hr
        return np.stack((r*np.sin(theta), -r*np.cos(theta), x[:, 2]), 1)

    end = 1.25
    t, theta, rate, arm = slidingSector(a, ri, ro, theta0, mu, end)
    deep = kind == "tets"
    at = nt//2 + 7*m
    n = (nt, 3*m, 2) if deep else (nt, 3*m)
    sides = {"pipe": (("y-",), "slip" if how == "slip" else "calculated")}
    if deep:
        sides["ends"] = (("z-", "z+"), "slip")
    case = scene(
        f"halfPipe {how} {mu}{name}", kind, n,
        {"block": {"constitutiveModel": {**LAW, "E": 1e6}}},
        {"block": {"min": ((at - 2*m)*H, 0, 0), "max": ((at + 2*m)*H, nr*H, (1 + deep)*H)}},
        end, sides, numerics, gravity=(0, -G, 0), place=place,
        **({} if how == "slip" else {"contact": {"pipe": {
            "fields": "(block)", "patch": "pipe", "type": "Coulomb", "mu": mu}}}))
    tm, mass, P, _ = balance(case, "block")
    return ((turningPoints(t, rate)[0], turningPoints(tm, P[:, 0])[0]),
            (np.max(abs(arm*rate*np.cos(theta))), np.max(abs(P[:, 0]/mass))))


def halfPipe(table, runs=(("hexes", 0, "slip"), ("prisms", 0, "slip"),
                          ("hexes", 0, "contact"),
                          ("hexes", 0.1, "contact"), ("prisms", 0.1, "contact"))):
    """A block slides in a half-pipe, held by slip or on it by contact: the exact compound
    pendulum, half a swing."""
    for kind, mu, how in runs:
        label = f"half-pipe, {kind}, {how}, mu {mu}"
        period, momentum = swing(kind, mu, how, {"transfer": "APIC"})
        table.row(f"{label}: time of half a swing [s]", *period, 0.01, "relative")
        table.row(f"{label}: largest momentum along the pipe [m/s]", *momentum, 0.01,
                  "relative")


def halfPipeOrder(table):
    """FLIP in it, on three meshes: the momentum that a polygon of walls takes."""
    for kind in ("hexes", "prisms"):
        errors = []
        for m in (1, 2, 4):
            exact, seen = swing(kind, 0, "slip", {"transfer": "FLIP", "PICfraction": 0}, m,
                                f" FLIP {m}")[1]
            errors.append(abs(seen/exact - 1))
        label = f"half-pipe, {kind}, FLIP, 27, 54, 108 cells"
        table.row(f"{label}: momentum, error at 108", 0, errors[2], 0.01)
        table.row(f"{label}: order over the three", 2, math.log2(errors[0]/errors[2])/2, 1.75,
                  "atLeast")


def incline(table, runs=(("prisms", (20, 5), "patch", 0.3), ("hexes", (20, 5), "patch", 0.3),
                         ("tets", (14, 4, 4), "patch", 0.3), ("boxes", (20, 7), "slab", 0.2),
                         ("hexes", (20, 7), "slab", 0.2), ("hexes", (20, 7), "slab", 0),
                         ("prisms", (20, 7), "slab", 0.2), ("prisms", (20, 7), "slab", 0))):
    """A block slides on an oblique wall and on an oblique rigid slab, with Coulomb
    friction and without, in its own velocity field: g (sin - mu cos)."""
    angle, ramp, end = math.radians(-30), 0.05, 0.25
    along = np.array((math.cos(angle), math.sin(angle), 0))
    pull = {"type": "uniform", "acceleration":
            f"table ((0 (0 0 0)) ({ramp} (0 {-G} 0)) (10 (0 {-G} 0)))"}
    for cells, n, floor, mu in runs:
        kind, moved = ("hexes", 0) if cells == "boxes" else (cells, 0.2)
        deep = len(n) == 3
        low = 2*H if floor == "slab" else 0
        z = (H, 3*H) if deep else (0, H)
        law = {"type": "Coulomb", "mu": mu} if mu else {"type": "frictionless"}
        phases = {"block": {"constitutiveModel": {**LAW, "E": 1e6}, "bodyForce": pull}}
        regions = {"block": {"min": (3*H, low, z[0]), "max": (7*H, low + 2*H, z[1])}}
        pair = {"fields": "(block)", "patch": "wall", **law}
        if floor == "slab":
            phases["slab"] = {"type": "rigid", "rho": 7800}
            regions["slab"] = {"min": (0, 0, 0), "max": (n[0]*H, 2*H, n[-1]*H if deep else H)}
            pair = {"fields": "(block slab)", **law}
        case = scene(
            f"incline {floor} {mu}", kind, n, phases, regions, end,
            {"wall": (("y-",), "calculated")}, place=turned(angle), moved=moved,
            contact={"slope": pair})
        t, m, P, _ = balance(case, "block")
        late = t > 0.08
        a = np.polyfit(t[late], (P @ along/m)[late], 1)[0]
        table.row(f"incline on a {floor}, {cells}, mu {mu}: acceleration",
                  G*(math.sin(-angle) - mu*math.cos(angle)), a,
                  0.02 if floor == "patch" else 0.03, "relative")


def plates(table):
    """Two bars, in contact, part of a cell apart: the second flies on alone, momentum
    of both to rounding, energy."""
    law = {"constitutiveModel": {**LAW, "nu": 0}}
    c, v = math.sqrt(LAW["E"]/LAW["rho"]), 0.1
    for kind, n, numerics in (("prisms", (38, 2), FMPM), ("hexes", (38, 2), FMPM),
                              ("tets", (38, 2, 2), FMPM)):
        w = 2*H
        L, gap = 12*H, 0.0
        regions = {"left": {"min": (4*H, 0, 0), "max": (16*H, w, w), "velocity": (v, 0, 0)},
                   "right": {"min": (16*H + gap, 0, 0), "max": (28*H, w, w)}}
        sides = {"walls": (("y-", "y+") + (("z-", "z+") if len(n) == 3 else ()), "slip")}
        case = scene("plates", kind, n, {"left": law, "right": law}, regions, 4*L/c, sides,
                     {**numerics, "energyBudget": True}, functions=ENERGY,
                     contact={"plates": {"type": "frictionless"}})
        _, m, left, K0 = balance(case, "left")
        _, _, right, K1 = balance(case, "right")
        whole = m[0]*v
        label = f"plates in contact, {kind}"
        # 0.98 on boxes: the functions are wider
        print(f"{label}: momentum of the second / of both {right[-1, 0]/whole:.3f}")
        table.row(f"{label}: momentum of both", 0,
                  np.max(abs((left + right)[:, 0]/whole - 1)), 1e-12)
        table.row(f"{label}: largest residual of the energy / kinetic energy", 0,
                  residual(case)/(0.5*whole*v), 0.01, "atMost")


def residual(case, column="residual"):
    with open(case.file("postProcessing/energy/0/energy.dat")) as f:
        names = [word.split("[")[0] for word in f.readlines()[1].lstrip("# ").split()]
    return np.abs(case.series("energy", "energy.dat")[:, names.index(column)]).max()


def rigidMass(table):
    """A rigid mass hits an elastic bar, in contact and in its velocity field:
    V exp(-Z A t/M), momentum; a fixed rigid plate takes what a block loses."""
    c, v, L = math.sqrt(LAW["E"]/LAW["rho"]), 0.1, 40*H
    Z, w = LAW["rho"]*c, 2*H
    rho = 4*LAW["rho"]
    tau = rho*4*H/Z
    end = 1.5*L/c
    for kind, shared in (("prisms", False), ("prisms", True), ("hexes", True)):
        field = {"velocityField": "solids"} if shared else {}
        case = scene(
            f"rigidMass {'one' if shared else 'two'}", kind, (54, 2),
            {"mass": {"type": "rigid", "rho": rho, **field,
                      "motion": {"type": "free", "velocity": (v, 0, 0)}},
             "bar": {"constitutiveModel": {**LAW, "nu": 0}, **field}},
            {"mass": {"min": (4*H, 0, 0), "max": (8*H, w, H)},
             "bar": {"min": (8*H, 0, 0), "max": (8*H + L, w, H)}}, end,
            {"walls": (("y-", "y+"), "slip")}, FMPM,
            **({} if shared else {"contact": {"face": {"type": "frictionless"}}}))
        t, m, P, _ = balance(case, "mass")
        _, _, other, _ = balance(case, "bar")
        label = f"rigid mass on a bar, {kind}, {'one field' if shared else 'contact'}"
        table.row(f"{label}: momentum of both", 0,
                  np.abs((P + other)[:, 0]/(m[0]*v) - 1).max(), 1e-12)
        # 0.008 on boxes in contact
        error = np.abs(P[:, 0]/(m[0]*v) - np.exp(-t/tau)).max()
        print(f"{label}: velocity of the mass / V - exp(-t/tau) {error:.4f}")
    for kind, n in (("prisms", (12, 12)), ("tets", (8, 8, 6))):
        deep = len(n) == 3
        z = (H, 5*H) if deep else (0, H)
        case = scene(
            "plate", kind, n,
            {"plate": {"type": "rigid", "rho": 7800, "velocityField": "solids"},
             "block": {"constitutiveModel": LAW, "velocityField": "solids"}},
            {"plate": {"min": (H, H, z[0]), "max": (7*H, 2*H, z[1])},
             "block": {"min": (2*H, 2*H, z[0]), "max": (6*H, 5*H, z[1]),
                       "velocity": (0.3, -1, 0)}}, 0.02)
        _, m, P, _ = balance(case, "block")
        found = re.findall(r"^Load on plate: force \(.*?\) N, impulse \((.*?)\) N s",
                           case.log(), flags=re.M)
        start = case.points("0", "block")
        change = P[-1] - start["m"] @ start["U"]
        J = np.array(found[-1].split(), float)
        table.check(f"fixed plate, {kind}: it takes a tenth of the momentum",
                    np.linalg.norm(J) > 0.1*m[0], np.linalg.norm(J)/m[0])
        table.row(f"fixed plate, {kind}: |dP + J|/|dP|", 0,
                  np.linalg.norm(change + J)/np.linalg.norm(change), 1e-12)


def rest(table):
    """A column on a fixed floor, with a traction on its top, damped to rest: stress and
    the force on the floor."""
    g, load = 5.0, 500.0
    for kind, n in (("prisms", (4, 14)), ("hexes", (4, 14)), ("tets", (2, 12, 2))):
        deep = len(n) == 3
        top, w = (n[1] - 2)*H, n[0]*H
        area = w*(w if deep else H)
        sides = {"floor": (("y-",), "fixedValue; value uniform (0 0 0)"),
                 "walls": (("x-", "x+") + (("z-", "z+") if deep else ()), "slip")}
        case = scene(
            "rest", kind, n,
            {"column": {"constitutiveModel": {**LAW, "nu": 0},
                        "damping": {"type": "kinetic"}, "surfaceLoads": {"top": {
                            "traction": (0, -load, 0), "normal": (0, 1, 0),
                            "min": (-9, top/2, -9)}}}},
            {"column": {"min": (0, 0, 0), "max": (w, top, w)}}, 2.0, sides,
            {"transfer": "FLIP"}, gravity=(0, -g, 0),
            functions={"forces": {"type": "materialPointPatchForces",
                                  "patches": "(floor)", **LIBS}})
        points = case.points(case.times()[-1], "column")
        y, s, V = points["x"][:, 1], points["sigma"][:, 3], points["V"]
        exact = -load - LAW["rho"]*g*(top - y)
        label = f"column at rest, {kind}"
        table.row(f"{label}: rms error of the stress / largest", 0,
                  math.sqrt(np.sum(V*(s - exact)**2)/np.sum(V))/np.max(abs(exact)), 0.02)
        weight = area*(load + LAW["rho"]*g*top)
        table.row(f"{label}: force on the floor / weight and load", -1,
                  case.series("forces", "floor.dat")[-1, 2]/weight, 0.005)


def outflow(table):
    """A block flies out through an oblique patch, and a block erodes: mass and momentum
    of left and present points, in every step."""
    for kind, n in (("prisms", (10, 8)), ("tets", (8, 6, 4))):
        deep = len(n) == 3
        case = scene(
            "outflow", kind, n, {"block": {"constitutiveModel": {**LAW, "E": 1e5}}},
            {"block": {"min": (3*H, 2*H, H*deep), "max": (6*H, 4*H, 3*H if deep else H),
                       "velocity": (10, 6, 0)}}, 0.1,
            {"out": (("x+", "y+"), "calculated")}, place=turned(0.4),
            outflow={"patches": "(out)"})
        s = case.series("balance", "block.dat")
        label = f"outflow, {kind}"
        table.check(f"{label}: points present and left, all at the end",
                    np.all(s[:, 1] + s[:, 13] == s[0, 1]) and s[-1, 1] == 0, s[-1, 13])
        m, P = s[:, 2] + s[:, 14], s[:, 3:6] + s[:, 15:18]
        table.row(f"{label}: mass and momentum present and left", 0,
                  max(np.abs(m/m[0] - 1).max(),
                      np.linalg.norm(P - P[0], axis=1).max()/np.linalg.norm(P[0])), 1e-12)


def crack(table):
    """A bar that is pulled apart by rigid phases of its velocity field until it has one
    crack: the energy of the crack is Gf per area."""
    E, strength, Gf, rho = 2e9, 2e6, 20.0, 1840.0
    h, pull, end = 1.25e-3, 0.15, 2e-4
    law = {"type": "linearElastic", "rho": rho, "E": E, "nu": 0}

    def solid(part):
        return {"velocityField": "bar", "constitutiveModel": law, "failureModel": {
            "type": "maxPrincipalStress", "strength": part*strength, "Gf": Gf}}

    def grip(side):
        return {"type": "rigid", "rho": rho, "velocityField": "bar", "motion": {
            "type": "translation", "velocity": (side*0.5*pull, 0, 0)}}

    places = {"left": (2, 4), "lowEnd": (4, 8), "low": (8, 11), "middle": (11, 13),
              "high": (13, 16), "highEnd": (16, 20), "right": (20, 22)}
    phases = {"left": grip(-1), "lowEnd": solid(1.5), "low": solid(1), "middle": solid(0.9),
              "high": solid(1), "highEnd": solid(1.5), "right": grip(1)}
    # On moved quadrilaterals 0.845
    for kind in ("prisms",):
        case = scene(
            "crack", kind, (24, 12), phases,
            {p: {"min": (a*h, 2*h, 0), "max": (b*h, 10*h, h)}
             for p, (a, b) in places.items()}, end,
            numerics={"transfer": "FLIP", "PICfraction": 0.005, "stressUpdate": "USAVG",
                      "energyBudget": True}, functions=ENERGY, size=h, maxCo=0.4)
        with open(case.file("postProcessing/energy/0/energy.dat")) as f:
            names = [word.split("[")[0] for word in f.readlines()[1].lstrip("# ").split()]
        rows = case.series("energy", "energy.dat")
        scale = Gf*8*h*h
        label = f"crack of a bar, {kind}"
        table.row(f"{label}: its energy / Gf", 1,
                  -rows[-1, names.index("failure")]/scale, 0.15)
        table.row(f"{label}: residual of the energy / the same", 0, np.abs(
            rows[:, names.index("residual")] + rows[:, names.index("remap")]).max()/scale,
            0.02, "atMost")


def choice(table):
    """Without shapeFunction: GIMP on boxes, as if it were named, nodeDual elsewhere; cells
    that do not work are named."""
    law, region = {"constitutiveModel": LAW}, {"min": (H, H, 0), "max": (4*H, 3*H, H),
                                               "velocity": (1, 0.5, 0)}

    def run(name, kind, moved, numerics=FLIP, **more):
        return scene(f"choice {name}", kind, (6, 5), {"block": law}, {"block": region}, 0.02,
                     numerics=numerics, moved=moved, **more)

    boxes = run("boxes", "hexes", 0)
    named = run("named", "hexes", 0, {"shapeFunction": "GIMP", **FLIP})
    last = boxes.times()[-1]
    table.check("choice: GIMP on boxes, the same bit by bit",
                "shape function GIMP" in boxes.log() and all(
                    np.array_equal(boxes.points(last, "block")[c],
                                   named.points(last, "block")[c])
                    for c in ("x", "U", "sigma")))
    for kind in ("hexes", "prisms"):
        table.check(f"choice: nodeDual on moved {kind}", "shape function nodeDual" in run(
            "moved", kind, 0.2).log())

    def fold(x):
        # One inner point beyond its neighbour
        at = np.linalg.norm(x[:, :2] - (5*H, 4*H), axis=1) < 0.1*H
        return np.where(at[:, None], x - (1.3*H, 0, 0), x)

    try:
        run("folded", "prisms", 0, run=False, place=fold)
        text = ""
    except RunFailed as e:
        text = str(e)
    found = re.search(r"(\d+) cells are (?:flat|without volume).*?cell (\d+) at "
                      r"\(([^)]*)\), volume", text)
    place = np.array(found[3].split(), float) if found else np.array((9, 9, 9))
    table.check("choice: folded cells are refused with label and place",
                found and np.linalg.norm(place[:2] - (4.3*H, 4*H)) < 1.5*H,
                found[0] if found else text[-300:])


def inclineOfTets(table):
    incline(table, [("tets", (14, 6, 4), "slab", mu) for mu in (0.2, 0)])


def halfPipeOfTets(table):
    halfPipe(table, [("tets", 0, "slip")])


PARTS = (choice, slope, halfPipe, halfPipeOrder, incline, plates, rigidMass, rest, outflow, crack)

#: Longer
LONG = (inclineOfTets, halfPipeOfTets)
