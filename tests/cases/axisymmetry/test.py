#!/usr/bin/env python3
"""Axisymmetric scenes on wedge patches.

identities   volumes of the sector; a ring that a rigid phase opens with one radial
             velocity: hoop strain ln(r/R) of every point, no other strain; equal
             pressure everywhere stays at rest, on the axis too; a moving cylinder
             keeps its velocity and has no stress
ring         thick ring, b/a = 2, plane strain, opened from inside by a slow
             displacement: stresses of the cells against Lame, on a wedge and in a
             quarter in 2D and in 3D; the pressure that the inner side feels
cylinder     solid cylinder pressed in from outside: one stress, smooth at the axis
rod          longitudinal vibration of a thin rod, nu 0.3, free surface: the speed
             sqrt(E/rho) of bars, not that of the law
impact       two cylinders hit each other end on: mass and momentum, energy budget;
             the six orientations of a wedge; 2 processors; restart; foamToVTK
wrong        meshes that are no sector
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from bar import period
from foamCase import (VERIFY, FoamCase, RunFailed, boxMesh, controlDict, foamText, noSchemes,
                      readInternal, velocityFile, writeField)
from report import Report
from wedge import SECTOR, wedgeConditions, wedgeMesh

E, NU, RHO = 1.0, 0.3, 1.0
LAW = {"type": "linearElastic", "rho": RHO, "E": E, "nu": NU}
LAMBDA, MU = E*NU/((1 + NU)*(1 - 2*NU)), E/(2*(1 + NU))
WAVE = np.sqrt((LAMBDA + 2*MU)/RHO)

FLIP = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0}
FMPM = {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2}
APIC = {"shapeFunction": "GIMP", "transfer": "APIC"}
SHAPES = ("GIMP", "linear", "quadraticBSpline", "cubicBSpline", "nodeDual")
COLUMNS = ("x", "U", "sigma", "m", "V", "leftStretch", "C")

BALANCE = {"type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
           "writeControl": "timeStep", "writeInterval": 1}

#: Places of xx, rr, hoop and x-r in OpenFOAM's order, axis x and radius y
XX, XR, RR, HOOP = 0, 1, 3, 5


def build(name, mesh, patches, phases, regions, numerics, control):
    """A case with points; regions: name: entries (box and phase of its name)."""
    case = FoamCase("axisymmetry", name)
    case.write("system/blockMeshDict", mesh)
    case.write("constant/phaseProperties", {
        "phases": list(phases),
        **{p: {"velocityField": "solids", **entries} for p, entries in phases.items()}})
    velocityFile(case, "solids", patches)
    case.write("system/setMaterialPointsDict", {"regions": {
        p: {"phase": p, "pointsPerCell": 2, "type": "box", **entries}
        for p, entries in regions.items()}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    noSchemes(case)
    case.write("system/controlDict", control)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def tube(name, low, high, cells, conditions, numerics, control, axes="xy", law=None,
         **region):
    """A wedge that one body fills; conditions of left, right, outer (inner)."""
    hole = low[1] > 0
    sides = {"left": "x-", "right": "x+", "outer": "r+", **({"inner": "r-"} if hole else {})}
    mesh = wedgeMesh(low, high, cells, {p: ("patch", s) for p, s in sides.items()}, axes)
    return build(name, mesh, wedgeConditions(conditions, hole),
                 {"body": {"constitutiveModel": law or LAW}},
                 {"body": {"min": (-1e3,)*3, "max": (1e3,)*3, **region}},
                 numerics, control)


#: A velocity over time, and its file
TABLE = {"type": "timeVaryingUniformFixedValue", "file": '"<case>/table"',
         "outOfBounds": "clamp", "value": "uniform (0 0 0)"}


def writeTable(case, rows):
    with open(case.file("table"), "w") as f:
        f.write(foamText(rows) + "\n")


# --- identities ----------------------------------------------------------------

def identities(table):
    L, a, b = 1.0, 0.5, 1.0
    for shape in SHAPES:
        numerics = {**FLIP, "shapeFunction": shape}

        # A rigid phase over the whole mesh gives all nodes its velocity
        V, dt = 0.01, 0.05
        case = build(
            f"opened-{shape}",
            wedgeMesh((0, a), (L, b), (6, 5), {n: ("patch", s) for n, s in (
                ("left", "x-"), ("right", "x+"), ("inner", "r-"), ("outer", "r+"))}),
            wedgeConditions({p: "calculated" for p in ("left", "right", "inner", "outer")},
                            hole=True),
            {"tool": {"type": "rigid", "rho": 1, "motion": {
                "type": "translation", "velocity": (0, V, 0)}},
             "body": {"constitutiveModel": LAW}},
            {p: {"min": (0, inner, -1), "max": (L, outer, 1), "overlap": "allow"}
             for p, inner, outer in (("tool", a, b), ("body", 0.6, 0.9))},
            numerics, controlDict(dt, dt, deltaT=dt))
        case.run("materialPointFoam")
        start, now = case.points("0", "body"), case.points(case.times()[-1], "body")
        R = start.byId("x")[:, 1]
        h = 0.5*np.log1p(now.byId("leftStretch"))
        exact = np.log1p(dt*V/R)
        # The step has the first two terms of the logarithm
        table.row(f"opened, {shape}: hoop strain / ln(r/R) - 1", 0,
                  np.abs(h[:, HOOP]/exact - 1).max(), (dt*V/0.6)**2)
        table.row(f"opened, {shape}: other strains / (dt V/r)", 0,
                  np.abs(h[:, (XX, XR, RR)]).max()*a/(dt*V), 1e-10)
        if shape == "GIMP":
            table.row("volume of the points / that of the sector - 1", 0,
                      start["V"].sum()/(SECTOR*L*(0.9**2 - 0.6**2)/2) - 1, 1e-12)

    # Rest under pressure: the outer side is held. B-splines have no average over
    # the point: sums over the points stand for integrals of r dS/dr + S
    P = 0.01
    for shape, n in (("GIMP", 2), ("linear", 2), ("quadraticBSpline", 3),
                     ("cubicBSpline", 5), ("nodeDual", 2)):
        case = tube(f"pressure-{shape}", (0, 0), (L, b), (8, 8),
                    {"left": "slip", "right": "slip", "outer": "slip"},
                    {**FLIP, "shapeFunction": shape}, controlDict(2, 2, maxCo=0.4),
                    stress=(-P, 0, 0, -P, 0, -P), pointsPerCell=n)
        case.run("materialPointFoam")
        end = case.times()[-1]
        start, now = case.points("0", "body"), case.points(end, "body")
        exact = shape != "cubicBSpline"
        table.row(f"pressure, {shape}, {n} points per direction: |change of the stress| / p",
                  0, np.abs(now.byId("sigma") - start.byId("sigma")).max()/P,
                  1e-10 if exact else 0.01)
        if shape == "GIMP":
            full = readInternal(case.file("0/alpha.body")) \
                if os.path.exists(case.file("0/alpha.body")) \
                else readInternal(case.file(end, "alpha.body"))
            table.row("a full mesh has the volume fraction 1", 0, np.abs(full - 1).max(),
                      1e-9)

    # A cylinder that flies along the axis
    dual = {**FLIP, "shapeFunction": "nodeDual"}
    for name, transfer in (("FLIP", FLIP), ("FMPM", FMPM), ("APIC", APIC),
                           ("nodeDual FLIP", dual),
                           ("nodeDual APIC", {**APIC, "shapeFunction": "nodeDual"})):
        v = 0.1
        case = flight("flight-" + name.replace(" ", "-"), transfer, v)
        case.run("materialPointFoam")
        now = case.points(case.times()[-1], "body")
        table.row(f"flight, {name}: |u - v|/v", 0,
                  np.abs(now["U"] - (v, 0, 0)).max()/v, 1e-12)
        table.row(f"flight, {name}: stress / E", 0, np.abs(now["sigma"]).max()/E, 1e-13)


def flight(name, numerics, v):
    mesh = wedgeMesh((0, 0), (2, 0.8), (20, 8), {n: ("patch", s) for n, s in (
        ("left", "x-"), ("right", "x+"), ("outer", "r+"))})
    return build(name, mesh,
                 wedgeConditions({p: "calculated" for p in ("left", "right", "outer")}),
                 {"body": {"constitutiveModel": LAW}},
                 {"body": {"type": "sphere", "centre": (0.6, 0, 0), "radius": 0.45,
                           "velocity": (v, 0, 0)}},
                 numerics, controlDict(5, 5, maxCo=0.4))


# --- Lame ------------------------------------------------------------------------

A, B, OPENING = 1.0, 2.0, 1e-5
RAMP = 40.0


def lame(r):
    """Pressure at A, radial and hoop stress at r for the displacement OPENING at A."""
    ratio = (LAMBDA + MU)*B**2/MU
    c = OPENING/(A + ratio/A)
    stress = lambda r, sign: 2*(LAMBDA + MU)*c + sign*2*MU*ratio*c/r**2  # noqa: E731
    return -stress(A, -1), stress(r, -1), stress(r, 1)


def ramp(direction=1.0):
    """Velocity at A, (1 - cos)/2 over the time: so smooth that the ring hardly swings
    after it."""
    top = 2*OPENING/RAMP*np.asarray(direction, float)
    return [(s*RAMP, 0.5*(1 - np.cos(2*np.pi*s))*top) for s in np.linspace(0, 1, 401)
            ] + [(10*RAMP, 0*top)]


def quarterRing(name, dim, n):
    """A quarter of the ring on a curved mesh, 2D or one cell in 3D."""
    s, m = np.sqrt(0.5), 3*n//2
    corners = [(A, 0), (B, 0), (0, B), (0, A)]
    h = (B - A)/n
    vertices = [(x, y, z) for z in (0.0, h) for x, y in corners]
    arcs = " ".join(f"arc {i} {j} {foamText((r*s, r*s, z))}"
                    for i, j, r, z in ((1, 2, B, 0.0), (0, 3, A, 0.0), (5, 6, B, h),
                                       (4, 7, A, h)))
    ends = "empty" if dim == 2 else "patch"
    boundary = ("(inner { type patch; faces ((0 4 7 3)); }"
                " outer { type patch; faces ((1 2 6 5)); }"
                " bottom { type patch; faces ((0 1 5 4)); }"
                " left { type patch; faces ((3 7 6 2)); }"
                f" ends {{ type {ends}; faces ((0 3 2 1) (4 5 6 7)); }})")
    mesh = {"scale": 1, "vertices": vertices,
            "blocks": f"(hex (0 1 2 3 4 5 6 7) ({n} {m} 1) simpleGrading (1 1 1))",
            "edges": f"({arcs})", "boundary": boundary}
    patches = {"inner": {"type": "timeVaryingMappedFixedValue", "mapMethod": "nearest",
                         "setAverage": False, "offset": (0, 0, 0)},
               "outer": "calculated", "bottom": "slip", "left": "slip",
               "ends": "empty" if dim == 2 else "slip"}
    case = FoamCase("axisymmetry", name)
    phi = np.arange(m + 1)*np.pi/2/m
    radial = np.column_stack([np.cos(phi), np.sin(phi), 0*phi])
    places = np.concatenate([A*radial + (0, 0, z) for z in (0.0, h)])
    radial = np.concatenate([radial, radial])

    def sample(path, rows):
        os.makedirs(os.path.dirname(case.file(path)), exist_ok=True)
        with open(case.file(path), "w") as f:
            f.write("(\n" + "\n".join(foamText(r) for r in rows) + "\n)\n")

    sample("constant/boundaryData/inner/points", places)
    for t, v in ramp():
        sample(f"constant/boundaryData/inner/{t:g}/U.solids", v*radial)
    case.write("system/blockMeshDict", mesh)
    case.write("constant/phaseProperties", {"phases": ["body"], "body": {
        "velocityField": "solids", "constitutiveModel": LAW}})
    velocityFile(case, "solids", patches)
    case.write("system/setMaterialPointsDict", {"regions": {"body": {
        "phase": "body", "pointsPerCell": 2, "type": "box", "min": (-9, -9, -9),
        "max": (9, 9, 9)}}})
    case.write("system/fvSolution", {"materialPoints": {**FLIP, "shapeFunction": "linear"}})
    noSchemes(case)
    case.write("system/controlDict", {**controlDict(RAMP, RAMP, maxCo=0.4),
                                      "libs": '("libfvMotionSolvers.so")'})
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def ringErrors(table, label, case, n):
    """Mean radial and hoop stress of each ring of cells against Lame."""
    start, now = case.points("0", "body"), case.points(case.times()[-1], "body")
    x, s = start.byId("x"), now.byId("sigma")
    if label == "wedge":
        r, rr, hoop = x[:, 1], s[:, RR], s[:, HOOP]
    else:
        r = np.hypot(x[:, 0], x[:, 1])
        c, d = x[:, 0]/r, x[:, 1]/r
        rr = s[:, 0]*c*c + 2*s[:, 1]*c*d + s[:, 3]*d*d
        hoop = s[:, 0]*d*d - 2*s[:, 1]*c*d + s[:, 3]*c*c
    ring = np.minimum(((r - A)*n/(B - A)).astype(int), n - 1)
    count = np.bincount(ring)
    mean = [np.bincount(ring, q)/count for q in (rr, hoop)]
    # Of the exact stress the same mean
    p = lame(A)[0]
    exact = [np.bincount(ring, q)/count for q in lame(r)[1:]]
    for name, q, e in zip(("radial", "hoop"), mean, exact):
        table.row(f"ring, {label}: largest error of the {name} stress / p", 0,
                  np.abs(q - e).max()/p, 0.01)
    return p


def ring(table):
    n = 24
    case = tube("ring-wedge", (0, A), (0.1, B), (2, n), {
        "left": "slip", "right": "slip", "outer": "calculated",
        "inner": TABLE},
        FLIP, controlDict(RAMP, RAMP, maxCo=0.4, functions={"forces": {
            "type": "materialPointPatchForces", "libs": "(mpmFunctionObjects)",
            "patches": "(inner)", "writeControl": "timeStep", "writeInterval": 25}}))
    writeTable(case, ramp((0, 1, 0)))
    case.run("materialPointFoam", limit=300)
    p = ringErrors(table, "wedge", case, n)
    files = os.listdir(case.file("postProcessing/forces/0"))
    force = case.series("forces", [f for f in files if "inner" in f][0])
    table.row("ring, wedge: pressure on the inner side", p,
              -np.mean(force[-5:, 2])/(SECTOR*A*0.1), 0.01, "relative")
    for dim, n in ((2, 12), (3, 12 if VERIFY else 10)):
        case = quarterRing(f"ring-{dim}D", dim, n)
        case.run("materialPointFoam", limit=300)
        ringErrors(table, f"{dim}D", case, n)


def cylinder(table):
    """Pressed in from outside by a slow displacement."""
    n, R, end = 10, 1.0, 100.0
    u = -1e-5
    exact = 2*(LAMBDA + MU)*u/R
    v = [(0, (0, 0, 0)), (end/2, (0, 2*u/end, 0)), (end, (0, 0, 0)), (2*end, (0, 0, 0))]
    for shape, perCell in (("GIMP", 2), ("linear", 2), ("quadraticBSpline", 3),
                           ("cubicBSpline", 4), ("nodeDual", 2)):
        case = tube(f"cylinder-{shape}", (0, 0), (0.2, R), (2, n), {
            "left": "slip", "right": "slip",
            "outer": TABLE},
            {**FLIP, "shapeFunction": shape}, controlDict(end, end, maxCo=0.4),
            pointsPerCell=perCell)
        writeTable(case, v)
        case.run("materialPointFoam")
        now = case.points(case.times()[-1], "body")
        r, s = now["x"][:, 1], now["sigma"]
        table.row(f"cylinder, {shape}: radial stress, largest error", 0,
                  np.abs(s[:, RR]/exact - 1).max(), 0.01)
        table.row(f"cylinder, {shape}: hoop stress, largest error", 0,
                  np.abs(s[:, HOOP]/exact - 1).max(), 0.01)
        first = r < R/n
        table.row(f"cylinder, {shape}: |radial - hoop| in the cells at the axis / stress", 0,
                  np.abs(s[first, RR] - s[first, HOOP]).max()/abs(exact), 0.01)


# --- rod ---------------------------------------------------------------------------

def rod(table):
    """First longitudinal mode, one end on a slip wall: period 4 L/sqrt(E/rho), longer
    by nu^2 k^2 R^2/4 = 0.014 % (Rayleigh)."""
    n, aspect = 4, 20
    R, L, v = 1.0, 20.0, 1e-5
    T = 4*L/np.sqrt(E/RHO)
    for label, numerics, beyond in (
            ("surface at the mesh's side, FLIP", FLIP, 0),
            ("surface at the mesh's side, FMPM", FMPM, 0),
            ("surface inside the mesh, FLIP", FLIP, 2)):
        h = R/n
        mesh = wedgeMesh((0, 0), (L + beyond*h, R + beyond*h),
                         (aspect*n + beyond, n + beyond),
                         {p: ("patch", s) for p, s in (("left", "x-"), ("right", "x+"),
                                                       ("outer", "r+"))})
        case = build("rod-" + re.sub(r"\W+", "-", label), mesh, wedgeConditions(
            {"left": "slip", "right": "calculated", "outer": "calculated"}),
            {"body": {"constitutiveModel": LAW}},
            {"body": {"min": (0, 0, -1), "max": (L, R, 1)}}, numerics,
            controlDict(1.4*T, 1.4*T, maxCo=0.4, functions={"balance": BALANCE}))
        x = case.points("0", "body")["x"]
        k = np.pi/(2*L)
        u = np.zeros_like(x)
        u[:, 0] = v*np.sin(k*x[:, 0])
        writeField(case.file("0/lagrangian/body/U"), u)
        case.run("materialPointFoam", limit=300)
        record = case.series("balance", "body.dat")
        c = 4*L/period(record[:, 0], record[:, 3])
        table.row(f"rod, {label}: speed", np.sqrt(E/RHO), c, 0.01, "relative")


# --- impact --------------------------------------------------------------------------

def impact(name, numerics, axes="xy", end=0.6, control=None, interval=None):
    """Two cylinders hit each other end on at a tenth of the wave speed."""
    a, r = ("xyz".index(c) for c in axes)

    def place(x, radius):
        p = [-1.0, -1.0, -1.0] if radius == 0 else [1.0, 1.0, 1.0]
        p[a], p[r] = x, radius
        return p

    def along(v):
        p = [0.0]*3
        p[a] = v
        return p

    v = 0.1*WAVE
    mesh = wedgeMesh((0, 0), (1.2, 0.5), (24, 10), {n: ("patch", s) for n, s in (
        ("left", "x-"), ("right", "x+"), ("outer", "r+"))}, axes)
    return build(name, mesh, wedgeConditions(
        {"left": "calculated", "right": "calculated", "outer": "calculated"}),
        {p: {"constitutiveModel": {**LAW, "type": "neoHookean"}}
         for p in ("hammer", "anvil")},
        {"hammer": {"min": place(0.2, 0), "max": place(0.6, 0.2), "velocity": along(v)},
         "anvil": {"min": place(0.6, 0), "max": place(0.95, 0.3), "velocity": along(-v)}},
        {**numerics, "energyBudget": True},
        control or controlDict(end, interval or end, maxCo=0.3,
                               functions={"balance": BALANCE}))


def impacts(table):
    for name, numerics in (("FLIP", FLIP), ("FMPM", FMPM), ("APIC", APIC),
                           ("linear", {**FLIP, "shapeFunction": "linear"}),
                           ("cubic", {**FLIP, "shapeFunction": "cubicBSpline"}),
                           ("nodeDual", {**FLIP, "shapeFunction": "nodeDual"}),
                           ("USAVG", {**FLIP, "stressUpdate": "USAVG"})):
        case = impact(f"impact-{name}", numerics)
        case.run("materialPointFoam")
        record = case.series("balance", "total.dat")
        start = case.points("0", "hammer")
        size = (start["m"] @ start["U"])[0]
        table.row(f"impact, {name}: largest change of the axial momentum / that of a body",
                  0, np.abs(record[:, 3] - record[0, 3]).max()/size, 1e-12)
        table.row(f"impact, {name}: change of the mass", 0,
                  np.abs(record[:, 2]/record[0, 2] - 1).max(), 1e-12)
        # Kinetic energy that the impact turned: something has happened
        table.check(f"impact, {name}: bodies are strained",
                    record[:, 10].max() > 0.1*record[0, 9],
                    f"{record[:, 10].max()/record[0, 9]:.3g} of the kinetic energy")
        # What FMPM and APIC filter away is in remap, in 2D as here
        if name not in ("FMPM", "APIC"):
            budget = re.findall(r"remap (\S+), residual (\S+)$", case.log(), flags=re.M)
            table.row(f"impact, {name}: residual of the energy budget / kinetic energy", 0,
                      abs(sum(map(float, budget[-1])))/record[0, 9], 0.02)


def orientations(table):
    """The same scene about every axis."""
    cases = {axes: impact("axes-" + axes, FMPM, axes, 0.3)
             for axes in ("xy", "xz", "yx", "yz", "zx", "zy")}
    for case in cases.values():
        case.run("materialPointFoam")
    one = cases["xy"]
    end = one.times()[-1]
    for axes, case in cases.items():
        if axes == "xy":
            continue
        order = ["xyz".index(c) for c in axes]
        order.append(3 - sum(order))
        worst = 0.0
        for phase in ("hammer", "anvil"):
            # Ids follow the names of the axes: the same points by their places
            i = np.lexsort(one.points("0", phase).byId("x").T.round(6))
            j = np.lexsort(case.points("0", phase).byId("x")[:, order].T.round(6))
            p, q = one.points(end, phase), case.points(case.timeName(float(end)), phase)
            for column in ("x", "U"):
                u, w = p.byId(column)[i], q.byId(column)[j][:, order]
                worst = max(worst, np.abs(u - w).max()/np.abs(u).max())
            full = lambda s: np.array([[s[:, 0], s[:, 1], s[:, 2]],  # noqa: E731
                                       [s[:, 1], s[:, 3], s[:, 4]],
                                       [s[:, 2], s[:, 4], s[:, 5]]])
            u, w = full(p.byId("sigma")[i]), full(q.byId("sigma")[j])[np.ix_(order, order)]
            worst = max(worst, np.abs(u - w).max()/np.abs(u).max())
        table.row(f"axis {axes[0]}, radius {axes[1]}: as axis x, radius y", 0, worst, 1e-10)


def parallel(table):
    cuts = ((2, 1, 1), (1, 2, 1))
    for i, numerics in enumerate((FLIP, FMPM, APIC, {**FLIP, "shapeFunction": "linear"},
                                  {**FLIP, "shapeFunction": "cubicBSpline"},
                                  {**APIC, "shapeFunction": "nodeDual"})):
        name = f"{numerics['transfer']}-{numerics['shapeFunction']}"
        one = impact(f"parallel-{name}-1", numerics, end=0.3)
        one.run("materialPointFoam")
        for cut in cuts if VERIFY else cuts[i % 2:i % 2 + 1]:
            two = impact(f"parallel-{name}-{cut[0]}{cut[1]}", numerics, end=0.3)
            two.decompose(cut)
            two.runParallel()
            end = one.times()[-1]
            table.row(f"2 processors ({cut[0]} x {cut[1]}) against 1, {name}", 0,
                      one.largestDifference(two, end, ("hammer", "anvil"), COLUMNS), 1e-10)


def restart(table):
    for numerics in (FLIP, FMPM, APIC):
        name = numerics["transfer"]
        results = []
        for stops in ((0.3,), (0.15, 0.3)):
            case = impact(f"restart-{name}-{len(stops)}", numerics, end=0.3, interval=0.15)
            case.change("system/controlDict", r"^startFrom .*;", "startFrom latestTime;")
            for stop in stops:
                case.change("system/controlDict", r"^endTime .*;", f"endTime {stop};")
                case.run("materialPointFoam")
            results.append(case)
        end = results[0].times()[-1]
        table.row(f"restart, {name}: largest difference", 0, results[0].largestDifference(
            results[1], end, ("hammer", "anvil"), COLUMNS), 0)
    case = results[0]
    case.run("foamToVTK")
    text = case.log("foamToVTK")
    table.check("foamToVTK writes the points", os.path.isdir(case.file(
        "VTK/lagrangian/hammer")) and "FATAL" not in text, "VTK/lagrangian/hammer")
    x = case.points(end, "hammer")["x"]
    table.row("points lie on the mid-plane", 0, np.abs(x[:, 2]).max(), 1e-15)
    table.row("least radius of a point [cells]", 0, x[:, 1].min()/0.05, 0, "atLeast")


# --- wrong input -------------------------------------------------------------------

def wrong(table):
    def refused(label, words, change, **options):
        mesh = wedgeMesh((0, 0.2), (1, 1), (4, 4), {n: ("patch", s) for n, s in (
            ("left", "x-"), ("right", "x+"), ("inner", "r-"), ("outer", "r+"))}, **options)
        case = FoamCase("axisymmetry", "wrong-" + re.sub(r"\W+", "-", label))
        change(mesh)
        case.write("system/blockMeshDict", mesh)
        case.write("constant/phaseProperties", {
            "phases": ["body"], "body": {"constitutiveModel": LAW}})
        velocityFile(case, "body", wedgeConditions(
            {p: "calculated" for p in ("left", "right", "inner", "outer")}, hole=True))
        case.write("system/setMaterialPointsDict", {"regions": {"body": {
            "phase": "body", "pointsPerCell": 2, "type": "cells"}}})
        case.write("system/fvSolution", {"materialPoints": FLIP})
        noSchemes(case)
        case.write("system/controlDict", controlDict(1, 1, maxCo=0.4))
        case.run("blockMesh")
        case.run("setMaterialPoints", fails=True)
        text = " ".join(case.log("setMaterialPoints").split())
        table.check(f"{label}: one message that says what is wrong",
                    text.count("FOAM FATAL") == 1 and all(w in text for w in words),
                    case.reason(case.file("log.setMaterialPoints"))[:60])

    def nothing(mesh):
        pass

    def oneWedge(mesh):
        mesh["boundary"] = mesh["boundary"].replace("back { type wedge", "back { type patch")

    def axialEmpty(mesh):
        mesh["boundary"] = mesh["boundary"].replace("left { type patch", "left { type empty"
                                                    ).replace("right { type patch",
                                                              "right { type empty")

    def lean(mesh):
        # One side at twice the angle
        mesh["vertices"] = [tuple(c*(1.5 if i == 2 and c > 0 else 1)
                                  for i, c in enumerate(v)) for v in mesh["vertices"]]

    refused("wedge off axis", ("front", "they meet at y = 0."), nothing, shift=0.1)
    refused("one wedge patch", ("front", "there are 1"), oneWedge)
    refused("wedge and empty", ("front back", "1 directions"), axialEmpty)
    refused("unequal angles", ("front back", "their normals are"), lean)


def main():
    table = Report("axisymmetry")
    tests = {f.__name__: f for f in (identities, ring, cylinder, rod, impacts, orientations,
                                     parallel, restart, wrong)}
    for name in sys.argv[1:] or tests:
        try:
            tests[name](table)
        except RunFailed as e:
            table.check(f"{name} runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
