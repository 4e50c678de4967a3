#!/usr/bin/env python3
"""Bodies as setMaterialPoints makes them: true volume, true place, no points made by
hand.

volumes    table of setMaterialPoints and every cut sub-cell against closed forms: disc,
           sphere, hollow sphere, tubes, composite shapes, surfaces, wedge; mass, centre
           and moment of inertia
places     plates at any place begin and end there; a gap of 0.37 cells
joined     regions of one body: centre of mass and moments as if it were one
start      velocity with omega and functions of place: momentum, angular momentum
messages   what the start table says, and what is refused
ellipses   no ellipse of half-sizes, which contact sees, sticks out of a disc or sphere
roll       a free rigid disc and a sphere roll down a patch: 2/3 and 5/7 g sin
slope      a rigid block turned by 30 degrees slides down a slab turned by 30 degrees
sphere     a rigid sphere, R = 100 h, pressed by h into an elastic half space: Hertz
"""

import glob
import itertools
import os
import re
import subprocess
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from cellMesh import boxOfCells
from foamCase import (VERIFY, FoamCase, boxMesh, controlDict, foamText, noSchemes,
                      runParts, velocityFile)
from gasCases import writeVolField
from surfaces import prisms, surfaceRegion
from wedge import SECTOR, wedgeConditions, wedgeMesh

RHO = 1000.0


def build(name, low, h, cells, regions, mesh=None, phases=None, numerics=None,
          control=None, contact=None, gravity=None, patches=None, run=True):
    """Boxes of width h from low; rigid phases without motion unless given."""
    case = FoamCase("shapes", name)
    D = len(cells)
    full = list(cells) + [1]*(3 - D)
    start = list(low) + [0.0]*(3 - D)
    own = patches or {}
    if mesh is None:
        taken = sum(own.values(), [])
        sides = {**{p: ("patch", s) for p, s in own.items()}, "rest": (
            "patch", [a + s for a in "xyz"[:D] for s in "-+" if a + s not in taken])}
        if D < 3:
            sides["empty"] = ("empty", [a + s for a in "xyz"[D:] for s in "-+"])
        mesh = boxMesh(start, [x + n*h for x, n in zip(start, full)], full, sides)
        conditions = {p: "empty" if p == "empty" else "calculated" for p in sides}
    else:
        mesh, conditions = mesh
    phases = phases or {r["phase"] if "phase" in r else n: {"type": "rigid", "rho": RHO}
                        for n, r in regions.items()}
    case.write("system/blockMeshDict", mesh)
    case.write("constant/phaseProperties", {
        "phases": list(phases), **phases, **({"contact": contact} if contact else {})})
    for field in {p.get("velocityField", n) for n, p in phases.items()}:
        velocityFile(case, field, conditions)
    case.write("system/setMaterialPointsDict", {"regions": {
        r: {"phase": r, "pointsPerCell": 2, **entries} for r, entries in regions.items()}})
    case.write("system/fvSolution", {"materialPoints": numerics or {
        "shapeFunction": "GIMP", "transfer": "FLIP"}})
    noSchemes(case)
    case.write("system/controlDict", control or controlDict(1, 1, deltaT=1))
    if gravity is not None:
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]",
                                  "value": foamText(gravity)}, "uniformDimensionedVectorField")
    case.run("blockMesh")
    if run:
        case.run("setMaterialPoints")
    return case


def said(case, region):
    """Volume and exact volume of the table of setMaterialPoints."""
    row = re.search(rf"^    {region} .*$", case.log("setMaterialPoints"), re.M)[0].split()
    return float(row[4]), row[5], row[6]


def discArea(R, x0, x1, y0, y1):
    """Area of a disc around the origin in a rectangle."""
    def primitive(x):
        x = min(max(x, -R), R)
        return 0.5*(x*np.sqrt(max(R*R - x*x, 0)) + R*R*np.arcsin(x/R))

    a, b = max(x0, -R), min(x1, R)
    if b <= a:
        return 0.0
    edges = [a, b]
    for y in (y0, y1):
        if abs(y) < R:
            edges += [s*np.sqrt(R*R - y*y) for s in (-1, 1)]
    edges = sorted(e for e in edges if a <= e <= b)
    area = 0.0
    for u, v in zip(edges, edges[1:]):
        s = np.sqrt(max(R*R - (0.5*(u + v))**2, 0))
        if min(s, y1) <= max(-s, y0):
            continue
        part = primitive(v) - primitive(u)
        area += (part if s < y1 else y1*(v - u)) + (part if -s > y0 else -y0*(v - u))
    return area


def ballVolume(R, low, high):
    """Volume of a ball around the origin in a box: discs between all kinks."""
    a, b = max(low[2], -R), min(high[2], R)
    if b <= a:
        return 0.0
    edges = [a, b]
    sides = [(x, y) for x in (low[0], high[0], 0) for y in (low[1], high[1], 0)]
    for x, y in sides:
        if R*R > x*x + y*y:
            edges += [s*np.sqrt(R*R - x*x - y*y) for s in (-1, 1)]
    edges = sorted(e for e in edges if a <= e <= b)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    volume = 0.0
    for u, v in zip(edges, edges[1:]):
        half = 0.5*(v - u)
        for t, w in zip(nodes, weights):
            z = 0.5*(u + v) + half*t*(1.5 - 0.5*t*t)
            r = np.sqrt(max(R*R - z*z, 0))
            if r > 0:
                volume += half*w*1.5*(1 - t*t)*discArea(
                    r, low[0], high[0], low[1], high[1])
    return volume


def polygonArea(corners, x0, x1, y0, y1):
    """Area of a convex polygon in a rectangle."""
    for d, at, sign in ((0, x0, -1), (0, x1, 1), (1, y0, -1), (1, y1, 1)):
        cut = []
        for p, q in zip(corners, corners[1:] + corners[:1]):
            fp, fq = sign*(p[d] - at), sign*(q[d] - at)
            if fp <= 0:
                cut.append(p)
            if fp*fq < 0:
                cut.append(tuple(np.add(p, np.subtract(q, p)*(fp/(fp - fq)))))
        corners = cut
        if len(corners) < 3:
            return 0.0
    x, y = np.array(corners).T
    return 0.5*abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def subCells(low, h, cells, n):
    """Corners of all sub-cells in the order of points: cells, then sub-cells."""
    D = len(cells)
    s = h/n
    for cell in itertools.product(*(range(c) for c in cells[::-1])):
        for sub in itertools.product(range(n), repeat=D):
            yield tuple(low[d] + cell[D - 1 - d]*h + sub[D - 1 - d]*s for d in range(D))


def compare(table, name, case, region, low, h, cells, n, volume, tolerance=1e-10):
    """Volumes of the points, by id, against those of the sub-cells; parts below a
    thousandth lie with their neighbours."""
    s = h/n
    D = len(cells)
    exact = {tuple(np.round(np.subtract(c, low)/s).astype(int)): volume(c, [x + s for x in c])
             for c in subCells(low, h, cells, n)}
    whole = s**D
    V = case.points("0", region).byId("V")/(h if D == 2 else 1)
    kept = [c for c, v in exact.items() if v >= 1e-3*whole]
    small = [c for c, v in exact.items() if tolerance*whole < v < 1e-3*whole]
    table.row(f"{name}: points", len(kept), len(V), 0)
    if len(kept) != len(V):
        return
    beside = {tuple(np.add(c, step)) for c in small
              for d in range(D) for step in (np.eye(D, dtype=int)[d], -np.eye(D, dtype=int)[d])}
    error = [abs(v - exact[c])/whole for v, c in zip(V, kept) if c not in beside]
    nCut = sum(exact[c] < (1 - 1e-9)*whole for c in kept)
    table.row(f"{name}: {nCut} cut sub-cells, largest error / sub-cell", 0, max(error),
              tolerance, "atMost")
    total = sum(exact.values())
    table.row(f"{name}: volume / exact - 1", 0, V.sum()/total - 1, tolerance)


def volumes(table):
    R, h = 0.04713, 0.01
    low = (-0.0637, -0.0592, -0.0611)

    # Every sub-cell
    case = build("disc", low[:2], h, (13, 12), {"a": {
        "type": "sphere", "centre": (0, 0, 0), "radius": R}})
    compare(table, "disc", case, "a", low[:2], h, (13, 12), 2,
            lambda a, b: discArea(R, a[0], b[0], a[1], b[1]))
    case = build("ring", low[:2], h, (13, 12), {"a": {
        "type": "sphere", "centre": (0, 0, 0), "radius": R, "innerRadius": 0.0213,
        "pointsPerCell": 3}})
    compare(table, "ring", case, "a", low[:2], h, (13, 12), 3,
            lambda a, b: discArea(R, a[0], b[0], a[1], b[1])
            - discArea(0.0213, a[0], b[0], a[1], b[1]))
    case = build("hollow-sphere", low, 1.5*h, (8, 8, 8), {"a": {
        "type": "sphere", "centre": (0, 0, 0), "radius": R, "innerRadius": 0.0213}})
    compare(table, "hollow sphere", case, "a", low, 1.5*h, (8, 8, 8), 2,
            lambda a, b: ballVolume(R, a, b) - ballVolume(0.0213, a, b))

    # Mass, centre and inertia of a finer one: 2/5 M (R^5 - r^5)/(R^3 - r^3)
    case = build("hollow-sphere-fine", low, h, (12, 12, 12), {"a": {
        "type": "sphere", "centre": (0, 0, 0), "radius": R, "innerRadius": 0.0213}})
    p = case.points("0", "a")
    m, x, half = p["m"], p["x"], p["halfSize"]
    r = 0.0213
    M = RHO*4/3*np.pi*(R**3 - r**3)
    table.row("hollow sphere: mass", M, m.sum(), 1e-10, "relative")
    table.row("hollow sphere: centre / R", 0, np.abs(m @ x).max()/M/R, 1e-3)
    square = x**2 + half**2/3
    inertia = np.array([m @ (square[:, (d + 1) % 3] + square[:, (d + 2) % 3])
                        for d in range(3)])
    exact = 0.4*M*(R**5 - r**5)/(R**3 - r**3)
    table.row("hollow sphere: moment of inertia", 1, inertia.mean()/exact, 1e-2)

    # Turned by 30 degrees; OpenFOAM reads STL in single precision
    c, s = np.cos(np.pi/6), np.sin(np.pi/6)
    corners = [(c*x - s*y, s*x + c*y) for x, y in (
        (-0.031, -0.017), (0.029, -0.017), (0.029, 0.0113), (-0.031, 0.0113))]
    corners = [tuple(map(float, np.float32(p))) for p in corners]
    bottom, top = map(float, np.float32((-0.0131, 0.0147)))
    for D, cells in ((2, (13, 12)), (3, (13, 12, 4))):
        case = build(f"block-{D}D", low[:D - 1] + ((-0.02,) if D == 3 else low[1:2]), h,
                     cells, {"a": surfaceRegion("a.stl")}, run=False)
        prisms(case, "a.stl", [corners], *((-1, 2) if D == 2 else (bottom, top)))
        case.run("setMaterialPoints")

        def part(a, b):
            area = polygonArea(corners, a[0], b[0], a[1], b[1])
            return area*(max(0, min(b[2], top) - max(a[2], bottom)) if D == 3 else 1)

        compare(table, f"surface of triangles, {D}D", case, "a",
                low[:D - 1] + ((-0.02,) if D == 3 else low[1:2]), h, cells, 2, part)
        volume, exact, _ = said(case, "a")
        table.row(f"surface of triangles, {D}D: its volume in the table", volume,
                  float(exact), 1e-5, "relative")

    # Totals of the rest
    lens = np.pi*(4*R + 0.05)*(2*R - 0.05)**2/12
    ball = 4/3*np.pi*R**3
    one = {"type": "sphere", "centre": (-0.025, 0, 0), "radius": R}
    two = {**one, "centre": (0.025, 0, 0)}
    axis = np.array((0.05, 0.03, 0.02))
    tube = {"type": "cylinder", "point1": -axis, "point2": axis, "radius": 0.02}
    plate = {"type": "box", "min": (-0.031, -0.027, -0.0113), "max": (0.033, 0.029, 0.0127)}
    hole = {"type": "cylinder", "point1": (0, 0, -1), "point2": (0, 0, 1), "radius": 0.0117}
    wide, cells = (-0.0837, -0.0692, -0.0611), (16, 14, 12)
    for name, shape, exact in (
            ("box", plate, 0.064*0.056*0.024),
            ("oblique cylinder", tube, 2*np.linalg.norm(axis)*np.pi*0.02**2),
            ("oblique tube", {**tube, "innerRadius": 0.0123},
             2*np.linalg.norm(axis)*np.pi*(0.02**2 - 0.0123**2)),
            ("union", {"type": "union", "shapes": {"a": one, "b": two}}, 2*ball - lens),
            ("intersection", {"type": "intersection", "shapes": {"a": one, "b": two}}, lens),
            ("difference", {"type": "difference", "shapes": {"a": plate, "b": hole}},
             0.064*0.056*0.024 - np.pi*0.0117**2*0.024),
            ("nested", {"type": "difference", "shapes": {"a": plate, "b": {
                "type": "intersection", "shapes": {
                    "c": hole, "d": {"type": "box", "min": (-1, -1, -1),
                                     "max": (1, 1, 0.0021)}}}}},
             0.064*0.056*0.024 - np.pi*0.0117**2*(0.0021 + 0.0113))):
        case = build("total-" + name.replace(" ", "-"), wide, h, cells, {"a": shape})
        table.row(f"{name}: volume / exact - 1", 0,
                  case.points("0", "a")["V"].sum()/exact - 1, 1e-10)

    # Rings on a wedge
    ends = {"ends": ("patch", "x-"), "far": ("patch", "x+"), "wall": ("patch", "r+")}
    mesh = wedgeMesh((-0.06, 0), (0.06, 0.06), (12, 6), ends)
    conditions = wedgeConditions({p: "calculated" for p in ends})
    for name, shape, exact in (
            ("sphere", {"type": "sphere", "centre": (0.003, 0, 0), "radius": R},
             SECTOR*2/3*R**3),
            ("torus", {"type": "sphere", "centre": (0, 0.03, 0), "radius": 0.0213},
             SECTOR*0.03*np.pi*0.0213**2),
            ("rod", {"type": "cylinder", "point1": (-0.0312, 0, 0),
                     "point2": (0.0207, 0, 0), "radius": 0.0213},
             SECTOR*0.5*0.0213**2*0.0519),
            ("tube", {"type": "cylinder", "point1": (-0.0312, 0, 0), "innerRadius": 0.0113,
                      "point2": (0.0207, 0, 0), "radius": 0.0371},
             SECTOR*0.5*(0.0371**2 - 0.0113**2)*0.0519),
            ("box", {"type": "box", "min": (-0.0312, 0.0113, -1), "max": (0.0207, 0.0371, 1)},
             SECTOR*0.5*(0.0371**2 - 0.0113**2)*0.0519)):
        case = build(f"wedge-{name}", (0, 0), h, (12, 6), {"a": shape},
                     mesh=(mesh, conditions))
        # The sector comes from the patches, with the digits of blockMesh
        V = case.points("0", "a")["V"].sum()
        table.row(f"{name} on a wedge: volume / exact - 1", 0, V/exact - 1, 1e-10)
        log = case.log("setMaterialPoints")
        table.row(f"{name} on a wedge: exact of the table / exact - 1", 0,
                  float(re.search(r"^ +total +a +\d+ +\S+ +\S+ +(\S+)", log, re.M)[1])/exact
                  - 1, 1e-5)
        table.check(f"{name} on a wedge: does not reach beyond the mesh",
                    "reaches beyond" not in log)


def places(table):
    h = 0.01
    for D, cells in ((1, (20,)), (2, (20, 3))):
        faces = ((0.01337, 0.06121), (0.06121 + 0.37*h, 0.15003))
        case = build(f"plates-{D}D", (0, 0, 0)[:D], h, cells, {
            name: {"type": "box", "min": (a, 0, 0), "max": (b, 1, 1)}
            for name, (a, b) in zip("pq", faces)})
        worst = volume = 0.0
        ends = []
        for name, (a, b) in zip("pq", faces):
            p = case.points("0", name)
            x, l = p["x"][:, 0], p["halfSize"][:, 0]
            ends += [(x - l).min(), (x + l).max()]
            worst = max(worst, abs(ends[-2] - a), abs(ends[-1] - b))
            section = h*h if D == 1 else 3*h*h
            volume = max(volume, abs(p["V"].sum()/(section*(b - a)) - 1))
        table.row(f"plates, {D}D: where the boxes of points end - faces [cells]", 0,
                  worst/h, 1e-10)
        table.row(f"plates, {D}D: gap of 0.37 cells", 0.37, (ends[2] - ends[1])/h, 1e-10)
        table.row(f"plates, {D}D: volume / exact - 1", 0, volume, 1e-10)


def joined(table):
    """A core in a box of the same velocity field: points at their common face keep the
    moments, as if the body were one."""
    h, R = 0.01, 0.0313
    low, high = np.array((-0.0537, -0.0481, -0.0463)), np.array((0.0491, 0.0527, 0.0439))
    centre = (0.0013, 0.0027, -0.0011)
    ball = {"type": "sphere", "centre": centre, "radius": R}
    for D in (2, 3):
        box = {"type": "box", "min": low, "max": high}
        case = build(f"joined-{D}D", (-0.06, -0.06, -0.06)[:D], h, (12,)*D, {
            "core": ball, "shell": {"type": "difference", "shapes": {"a": box, "b": ball}}},
            phases={n: soft(velocityField="body") for n in ("core", "shell")})
        p = [case.points("0", n) for n in ("core", "shell")]
        m, x, l = (np.concatenate([q[name] for q in p]) for name in ("m", "x", "halfSize"))
        side, middle = (high - low)[:D], 0.5*(low + high)[:D]
        M = RHO*np.prod(side)*(h if D == 2 else 1)
        x, l = x[:, :D], l[:, :D]
        table.row(f"core in a box, {D}D: mass", M, m.sum(), 1e-10, "relative")
        table.row(f"core in a box, {D}D: centre of mass [cells]", 0,
                  np.abs(m @ (x - middle)).max()/M/h, 1e-8)
        table.row(f"core in a box, {D}D: second moments", 0, np.abs(
            m @ ((x - middle)**2 + l**2/3)/(M*side**2/12) - 1).max(), 1e-8)


def parcels(case, phase):
    """Positions, as foamToVTK writes them (4 bytes each)."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(glob.glob(case.file("VTK/lagrangian", phase, "*.vtp"))[0])
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPoints().GetData())


def soft(**more):
    return {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": 1e6, "nu": 0.3},
            **more}


def start(table):
    R, h, omega = 0.2, 0.02, 12.5
    low, centre = (-0.3, -0.3), np.array((0.0113, -0.0071))
    case = build("spin", low, h, (30, 30), {"a": {
        "type": "sphere", "centre": (*centre, 0), "radius": R, "velocity": {
            "uniform": (1, 2, 0), "omega": omega, "axis": (0, 0, 3),
            "origin": (*centre, 0)}}}, phases={"a": soft()})
    p = case.points("0", "a")
    m, x, U = p["m"], p["x"][:, :2] - centre, p["U"][:, :2]
    M = RHO*np.pi*R**2*h
    table.row("spinning disc: momentum / (M omega R)", 0,
              np.abs(m @ U - M*np.array((1, 2))).max()/(M*omega*R), 1e-3)
    # Points have no spin of their own: s^2/6 of their sub-cells is missing
    L = m @ (x[:, 0]*(U[:, 1] - 2) - x[:, 1]*(U[:, 0] - 1))
    table.row("spinning disc: angular momentum / (M R^2 omega/2)", 1 - (h/2)**2/(3*R**2),
              L/(0.5*M*R**2*omega), 2e-3)
    case = build("wave", (0,), h, (30,), {"a": {
        "type": "box", "min": (0, 0, 0), "max": (0.6, 1, 1), "velocity": {
            "x": "sine", "xCoeffs": {"frequency": 1/0.6, "amplitude": 3,
                                     "scale": (1, 0, 0), "level": (0, 0, 0)}}}},
                 phases={"a": soft()})
    p = case.points("0", "a")
    table.row("velocity as a function of x", 0, np.abs(
        p["U"][:, 0] - 3*np.sin(2*np.pi*p["x"][:, 0]/0.6)).max(), 1e-12)


def ellipses(table):
    for D, h, ppc in ((2, 0.01, 2), (2, 0.01, 1), (3, 0.02, 2)):
        R, low = 0.0513, (-0.07, -0.08, -0.08)
        n = int(round(0.16/h))
        case = build(f"ellipses-{D}D-{ppc}", low[:D], h, (n,)*D, {"a": {
            "type": "sphere", "centre": (0.003, 0.001, 0.0017), "radius": R,
            "pointsPerCell": ppc}})
        p = case.points("0", "a")
        x = (p["x"] - (0.003, 0.001, 0.0017))[:, :D]
        r = np.linalg.norm(x, axis=1)
        reach = r + np.linalg.norm(p["halfSize"][:, :D]*x/r[:, None], axis=1)
        table.row(f"disc or sphere, {D}D, {ppc} per direction: what sticks out [cells]", 0,
                  (reach.max() - R)/h, 1e-6)
        if D == 2:
            angle = np.sort(np.arctan2(x[:, 1], x[:, 0])[reach > R - 1e-6*h])
            print(f"disc, {ppc} per direction: widest angle without a point at the surface"
                  f" {np.diff(angle).max()*R*ppc/h:.2f} sub-cells")


def messages(table):
    box = {"type": "box", "min": (0, 0, 0), "max": (0.05, 0.05, 1)}

    def text(name, regions, *options, before=None, fails=False, **more):
        case = build("says-" + name, (0, 0), 0.01, (10, 10), regions, run=False, **more)
        if before:
            before(case)
        case.run("setMaterialPoints", *options, fails=fails)
        return " ".join(case.log("setMaterialPoints").split())

    def check(name, said, *words):
        missing = [w for w in words if w not in said]
        table.check(name, not missing, f"missing: {missing}" if missing else "")

    check("table", text("table", {"a": box}), "points per cell", "(0.05 0.05 0)", "difference")
    check("overlap of two velocity fields", text("overlap", {
        "a": box, "b": {**box, "min": (0.033, 0.033, 0)}}),
        "Regions a and b overlap at", "overlap allow;")
    check("no overlap of neighbours", text("neighbours", {
        "a": {**box, "max": (0.033, 0.05, 1)}, "b": {**box, "min": (0.033, 0, 0)}}), "End")
    said = text("neighbours", {
        "a": {**box, "max": (0.033, 0.05, 1)}, "b": {**box, "min": (0.033, 0, 0)}})
    table.check("neighbours do not overlap", "overlap" not in said)
    check("word for a surface", text("word", {
        "a": {"type": "surface", "surface": '"b.stl"'}}, fails=True),
        "Entry surface is not a dictionary", 'file "body.stl";', "setMaterialPointsDict")

    def millimetres(case):
        prisms(case, "a.stl", [[(-1, -1), (50, -1), (50, 50), (-1, 50)]], -1, 100)

    check("surface in mm", text(
        "mm", {"a": surfaceRegion("a.stl")}, before=millimetres, fails=True),
        "Region a fills the whole mesh", "times as large", "write scale", "1e-2 for cm")
    check("region of several shapes", text("several", {"a": {
        "type": "union", "shapes": {"b": box}}}), "a: union of")

    def far(case):
        prisms(case, "a.stl", [[(10, 10), (50, 10), (50, 50), (10, 50)]], -1, 100)

    check("surface in mm beside the mesh", text(
        "mmFar", {"a": surfaceRegion("a.stl")}, before=far, fails=True),
        "times as large as the mesh: scale 1e-3; (mm)", "It lies in (10 10 0) (50 50 0) m")

    def partly(factor):
        """A square of 0.04 m from (0.01 0.01) on, of which the mesh sees a corner."""
        high = 0.04*factor
        return lambda case: prisms(case, "a.stl", [[(0.01, 0.01), (high, 0.01), (high, high),
                                                    (0.01, high)]], -1, 1.5)

    check("surface in mm, of which a part is in the mesh", text(
        "mmPart", {"a": surfaceRegion("a.stl")}, before=partly(1000), fails=True),
        "Region a: The surface is", "times as large as the mesh: scale 1e-3; (mm) beside its"
        " file would put it into the mesh", "intersection")
    check("surface of 40 times the mesh: a warning only", text(
        "part", {"a": surfaceRegion("a.stl")}, before=partly(100)),
        "Warning", "times as large as the mesh", "Writing")

    def beside(case):
        prisms(case, "a.stl", [[(0.02, 0.02), (0.05, 0.02), (0.05, 0.05), (0.02, 0.05)]], 2, 3)

    check("surface beside the thickness of a mesh in 2D", text(
        "beside", {"a": surfaceRegion("a.stl")}, before=beside, fails=True),
        "has no points", "the section of the surface with the middle of the mesh's thickness")
    check("inner radius", text("inner", {"a": {
        "type": "sphere", "centre": (0, 0, 0), "radius": 0.02, "innerRadius": 0.03}},
        fails=True), "innerRadius is 0.03", "less than radius")
    check("no shapes", text("shapes", {"a": {"type": "union", "shapes": {}}}, fails=True),
          "There are no shapes")
    check("word in a shape of shapes", text("shapeWord", {"a": {
        "type": "union", "shapes": {"b": {**box, "radius": 2}}}}, fails=True), "radius")
    check("axis along the plane", text("axis", {"a": {**box, "velocity": {
        "omega": 1, "axis": (1, 0, 0), "origin": (0, 0, 0)}}}, phases={"a": soft()},
        fails=True), "not computed", "axis")
    check("Gf of a strong solid on wide cells", text("Gf", {"a": box}, phases={"a": soft(
        failureModel={"type": "maxPrincipalStress", "strength": 1e4, "Gf": 0.1})}),
        "cells of 0.01 m", "2 E Gf/strength^2 = 0.002", "no Gf")
    # Bands of 0.012 m: wide enough for cells of 0.01 m, not for their diagonal of 0.01414;
    # those of 0.0144 m are, but not for the strongest of 100 points
    for label, Gf, weibull, words in (
            ("Oblique", 0.6, {}, ["up to 0.0141421", "fails obliquely"]),
            ("Fine", 0.72, {}, None),
            ("Weibull", 0.72, {"weibull": {"modulus": 6, "seed": 1}}, ["strongest point"])):
        said = text("Gf" + label, {"a": box}, phases={"a": soft(failureModel={
            "type": "maxPrincipalStress", "strength": 1e4, "Gf": Gf, **weibull})})
        if words:
            check(f"Gf, {label}", said, "needs bands narrower", *words)
        else:
            table.check(f"Gf, {label}: no warning", "narrower" not in said)
    check("half of a shape beyond the mesh", text("beyond", {
        "a": {**box, "min": (-0.05, 0, 0)}}), "reaches beyond the mesh, 50 % of it")
    # Less than 1 % or half at a plane of symmetry may be meant
    for label, low, words in (("1.2 %", -0.0006, "1.2 % of its box has no points"),
                              ("0.8 %", -0.0004, None), ("half", -0.05, None)):
        said = text("warns-" + label.split()[0], {"a": {**box, "min": (low, 0, 0)}})
        table.check(f"{label} of a shape beyond the mesh: "
                    + ("warning" if words else "no warning"),
                    words in said if words else "has no points. The" not in said)
    # sqrt(1.346 E/rho) = 36.69 m/s; another body of two cells, and layers of one
    for label, regions, words in (
            ("4.9 times the wave speed", {"a": {**box, "velocity": (180, 0, 0)}}, None),
            ("5.1 times the wave speed", {"a": {**box, "velocity": (187, 0, 0)}},
             ["5.09", "times the wave speed of phase a", "wrong unit"]),
            ("another phase is hit at 5.1 times its wave speed", {
                "a": {**box, "max": (0.03, 0.05, 1)},
                "b": {**box, "phase": "b", "min": (0.05, 0, 0), "max": (0.08, 0.05, 1),
                      "velocity": (-187, 0, 0)}},
             ["Region b starts with 187", "5.09", "times the wave speed of phase a"]),
            ("1.9 cells wide", {"a": {**box, "max": (0.019, 0.05, 1)}},
             ["1.9 cells wide in x", "fewer than 2"]),
            ("2 cells wide", {"a": {**box, "max": (0.02, 0.05, 1)}}, None),
            ("layers of one cell", {
                "a": {**box, "max": (0.01, 0.05, 1)},
                "b": {**box, "phase": "a", "min": (0.01, 0, 0), "max": (0.02, 0.05, 1)}},
             None)):
        phases = {"a": soft()}
        if label.startswith("another"):
            phases["b"] = {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": 1e9,
                                                 "nu": 0.3}}
        said = text("units-" + label.replace(" ", "-"), regions, phases=phases)
        if words:
            check(label, said, *words)
        else:
            table.check(f"{label}: no warning", "Warning" not in said and "End" in said)
    # The boxes cut into triangles or tetrahedra count as before
    for kind, D in (("prisms", 2), ("tets", 3)):
        for width in (0.019, 0.02):
            case = build(f"says-{kind}{width}", (0,)*D, 0.01, (10,)*D, {
                "a": {**box, "max": (width, 0.05, 0.1)}}, phases={"a": soft()}, run=False)
            boxOfCells(case, kind, (0, 0, 0), (0.1, 0.1, 0.01 if D == 2 else 0.1),
                       (10, 10, 1 if D == 2 else 10), {"rest": (
                           "patch", ("x-", "x+", "y-", "y+") + ("z-", "z+")*(D == 3)),
                           **({"empty": ("empty", ("z-", "z+"))} if D == 2 else {})},
                       moved=0)
            case.run("setMaterialPoints")
            said = " ".join(case.log("setMaterialPoints").split())
            wide = re.search(r"is (\S+) cells wide in x, fewer than 2", said)
            if width < 0.02:
                table.row(f"1.9 cells wide, {kind}: cells of the warning", 1.9,
                          float(wide[1]) if wide else np.inf, 1e-9)
            else:
                table.check(f"2 cells wide, {kind}: no warning", not wide and "End" in said)
    # Inner points moved: OpenFOAM's own track to some place in them has no end
    boxOfCells(case, "tets", (0, 0, 0), (0.1, 0.1, 0.1), (10, 10, 10),
               {"rest": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))})
    for width in (0.019, 0.02):
        case.set("system/setMaterialPointsDict", "regions.a.max", (width, 0.05, 0.1))
        case.run("setMaterialPoints", "-force")
        case.run("foamToVTK")
        table.row(f"box of {width:g} m in moved tets: OpenFOAM's parcels [m]", 0,
                  abs(parcels(case, "a") - case.points("0", "a")["x"]).max(), 1e-8)
    air = {"type": "gas", "thermo": "perfectGas", "R": 287, "gamma": 1.4}

    def bar(case):
        writeVolField(case, "p", np.full(100, 1e5), {})

    for label, pressure in (("another", 1), ("the same", 1e5)):
        said = text("pressure" + label.split()[-1], {
            "a": {"type": "sphere", "centre": (0.05, 0.05, 0), "radius": 0.033,
                  "stress": "ambient", "pressure": pressure}}, before=bar,
            phases={"air": air, "a": soft(failureModel={
                "type": "maxPrincipalStress", "strength": 1e4})})
        table.check(f"points with {label} pressure as the gas",
                    ("in its cells has 100000 Pa. They are not in equilibrium" in said)
                    == (pressure == 1))
        check("failure in a gas, round body", said, "has no ambientPressure",
              "mass asked 0.0342119 kg, put 0.0342119 kg")
    check("no stress in a gas", text("gas", {"a": box}, phases={
        "air": {"type": "gas", "thermo": "perfectGas", "R": 287, "gamma": 1.4},
        "a": soft()}), "lies in the gas air", "stress ambient;")

    # After a run, and after decomposePar
    case = build("says-again", (0, 0), 0.01, (10, 10), {"a": box})
    os.makedirs(case.file("processor0"))
    case.run("setMaterialPoints")
    check("decomposed", " ".join(case.log("setMaterialPoints").split()),
          "decomposePar -force takes")
    os.rmdir(case.file("processor0"))
    control = controlDict(1e-3, 1e-3, deltaT=1e-3)
    control["startFrom"] = "latestTime"
    case.write("system/controlDict", control)
    case.run("materialPointFoam")
    x = case.points(case.times()[-1], "a")["x"]
    case.run("setMaterialPoints", fails=True)
    check("after a run", " ".join(case.log("setMaterialPoints").split()),
          "has been written by a run", "startFrom startTime;", "-force")
    table.check("after a run: its points are there",
                np.array_equal(x, case.points(case.times()[-1], "a")["x"]))

    # With -force a run starts anew there
    control = controlDict(2e-3, 1e-3, deltaT=1e-3)
    control["startFrom"] = "latestTime"
    case.write("system/controlDict", control)
    state = case.file(case.times()[-1], "uniform/materialPointState")
    with open(state) as f:
        old = f.read()
    with open(state, "w") as f:
        f.write(old.replace("stepsRedone     0;", "stepsRedone     7;"))
    case.run("setMaterialPoints", "-force")
    case.run("materialPointFoam")
    table.check("after a run, -force: what the run had summed up is gone",
                "stepsRedone     0;" in old and "steps redone: 0" in case.log(),
                re.findall("steps redone: .*", case.log())[-1:])


def free(**more):
    return {"type": "rigid", "rho": RHO, "motion": {"type": "free", **more}}


BALANCE = {"balance": {"type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
                       "writeControl": "timeStep", "writeInterval": 1}}


def velocity(case, phase, d=0):
    r = case.series("balance", phase + ".dat")
    return r[:, 0], r[:, 3 + d]/r[:, 2]


def roll(table):
    """A rigid cylinder: R = 0.05 m, slope 45 degrees, mu 0.6."""
    g = 9.81*np.sqrt(0.5)
    for D, n, limit in ((2, 1, 2.5), (2, 2, 1.5)) + (((2, 4, 1.0),) if VERIFY else ()) \
            + ((3, 1, 6.7),):
        h = 0.01/n
        control = controlDict(0.4, 0.4, 0.3, functions=BALANCE)
        control["maxDeltaT"] = 1e-3
        case = build(f"roll-{D}D-{n}", (0, 0, 0)[:D], h,
                     ((58, 12) if D == 2 else (58, 12, 12))[:D] if n == 1
                     else (58*n, 12*n), {"ball": {
                         "type": "sphere", "centre": (0.1, 0.05, 0.06 if D == 3 else 0),
                         "radius": 0.05}}, phases={"ball": free()},
                     control=control, gravity=(g, -g, 0), patches={"floor": ["y-"]},
                     contact={"floor": {"fields": "(ball)", "patch": "floor",
                                        "type": "Coulomb", "mu": 0.6}})
        case.run("materialPointFoam", limit=300)
        t, v = velocity(case, "ball")
        exact = (2/3 if D == 2 else 5/7)*g
        table.row(f"{'disc' if D == 2 else 'sphere'}, R = {5*n} h, rolls: velocity / a t"
                  " - 1 [%]", 0, 100*(v[-1]/(exact*t[-1]) - 1), limit)


def slope(table):
    """A block on a slab, both turned by 30 degrees against the mesh."""
    h, g, angle = 0.02, 9.81, np.pi/6
    c, s = np.cos(angle), np.sin(angle)

    def turned(x0, x1, y0, y1):
        return [(c*x + s*y, -s*x + c*y + 0.8) for x, y in (
            (x0, y0), (x1, y0), (x1, y1), (x0, y1))]

    for mu in (0.0, 0.3):
        # A rigid block lies on all its normals at once: one for all
        case = build(f"slope-{mu}", (0, 0), h, (70, 55), {
            "block": surfaceRegion("block.stl"), "slab": surfaceRegion("slab.stl")},
            phases={"block": free(), "slab": {"type": "rigid", "rho": RHO}},
            control=controlDict(0.3, 0.3, deltaT=5e-4, functions=BALANCE),
            gravity=(0, -g, 0), run=False, contact={"all": {
                "fields": "(block slab)", "type": "Coulomb", "mu": mu,
                "normal": (-s, -c, 0)}})
        prisms(case, "block.stl", [turned(0.2, 0.5, 0, 0.15)])
        prisms(case, "slab.stl", [turned(0.05, 1.4, -0.06, 0)])
        case.run("setMaterialPoints")
        case.run("materialPointFoam", limit=300)
        t, vx = velocity(case, "block")
        _, vy = velocity(case, "block", 1)
        exact = g*(s - mu*c)
        along, across = c*vx - s*vy, s*vx + c*vy
        table.row(f"block on a slope of 30 degrees, mu {mu}: velocity / a t", 1,
                  along[-1]/(exact*t[-1]), 0.01)
        table.row(f"block on a slope of 30 degrees, mu {mu}: velocity across / a t", 0,
                  across[-1]/(exact*t[-1]), 0.01)


def sphere(table):
    """Hertz, R 0.1 m, in a small block; a = 10 h."""
    E, nu, R, d, h = 1e8, 0.3, 0.1, 1e-3, 1e-3
    ramp = 1.2265e-3
    speed = d/(3*ramp)
    mesh = wedgeMesh((-0.2, 0), (0.012, 0.2), (1, 1), {
        "floor": ("symmetryPlane", "x-"), "outside": ("patch", "x+"),
        "wall": ("patch", "r+")})
    mesh["blocks"] = re.sub(
        r"\(1 1 1\) simpleGrading \(1 1 1\)",
        "(66 52 1) simpleGrading (((0.176 30 0.0724) (0.036 36 1))"
        " ((0.024 24 1) (0.176 28 14.5)) 1)", mesh["blocks"])
    conditions = wedgeConditions({
        "floor": "symmetryPlane", "outside": "calculated", "wall": "calculated"})
    moves = foamText([(0, (0, 0, 0)), (ramp, (-speed, 0, 0)), (3*ramp, (-speed, 0, 0)),
                      (4*ramp, (0, 0, 0)), (1e9, (0, 0, 0))])
    control = controlDict(6.2e-3, 6.2e-3, 0.4)
    control["reportInterval"] = 5
    case = build("hertz-sphere", (0, 0), h, (1, 1), {
        "block": {"type": "box", "min": (-0.2, 0, -1), "max": (0, 0.2, 1)},
        "ball": {"type": "sphere", "centre": (R, 0, 0), "radius": R}},
        mesh=(mesh, conditions), control=control, contact={"all": {"type": "frictionless"}},
        phases={"block": {"constitutiveModel": {
            "type": "linearElastic", "rho": 1000, "E": E, "nu": nu}},
                "ball": {"type": "rigid", "rho": 1000, "motion": {
                    "type": "translation", "velocity": f"table {moves}"}}},
        numerics={"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.05})
    case.run("materialPointFoam", limit=600)
    force = [float(f) for f in re.findall(r"^Contact all.*?force \((\S+)", case.log(), re.M)]
    exact = 4/3*E/(1 - nu**2)*np.sqrt(R*d)*d*SECTOR/(2*np.pi)
    last = np.mean(force[-len(force)//5:])
    table.row("sphere, R = 100 h, a = 10 h: force / Hertz", 1, last/exact, 0.06)


def main():
    return runParts("shapes", volumes, places, joined, start, ellipses, messages, roll,
                    slope, sphere)


if __name__ == "__main__":
    sys.exit(main())
