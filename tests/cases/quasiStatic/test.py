#!/usr/bin/env python3
"""Loads on surfaces and damping to rest, against closed forms (plane strain; strains of
1e-4, so that the shape hardly changes).

plate      quarter of a plate, traction on its upper side, which is inside a cell;
           viscous and kinetic damping: stress everywhere, displacement of the side,
           kinetic energy left; the energy budget closes: the load works twice what
           is stored, damping takes the half
ring       thick ring, inner pressure (Lame): stresses and displacement
hole       plate with a hole under tension: Howland's factor of the finite width (a fit of his
           values: Pilkey, Peterson's Stress Concentration Factors), stress along the
           narrowest section (Kirsch)
axis       thick tube on a wedge, inner pressure (Lame)
sphere     hollow sphere on a wedge, inner pressure (Lame)
restart    kinetic damping and a load that grows: bit by bit
parallel   the same on two processors
redone     viscous damping where steps are redone
source     a load is no growth of energy without a source
pushed     nor is a wall that begins to push a body at rest
bad input  messages
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (VERIFY, FoamCase, RunFailed, boxMesh, controlDict, noSchemes,
                      velocityFile)
from report import Report
from surfaces import strip, surfaceRegion
from wedge import wedgeConditions, wedgeMesh

E, NU, RHO = 1e6, 0.3, 1000.0
LAW = {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E, "nu": NU}}
C = np.sqrt(E*(1 - NU)/((1 + NU)*(1 - 2*NU))/RHO)
FLIP = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0,
        "stressUpdate": "USAVG", "energyBudget": True}
ENERGY = {"energy": {"type": "materialPointEnergy", "libs": "(mpmFunctionObjects)",
                     "writeControl": "timeStep", "writeInterval": 1}}


def build(name, cells, region, phase, end, writeInterval=None, lines=None, maxCo=0.4,
          wedge=False):
    """Quarter of a body on cells of 1 m, symmetry planes at x = 0 and y = 0; or on a
    wedge, symmetry planes across the axis x."""
    case = FoamCase("quasiStatic", name.replace(" ", "-"))
    patches = {"left": ("symmetryPlane", ["x-"]), "bottom": ("symmetryPlane", ["y-"]),
               "outside": ("patch", ["x+", "y+"]), "sides": ("empty", ["z-", "z+"])}
    conditions = {"left": "symmetryPlane", "bottom": "symmetryPlane",
                  "outside": "calculated", "sides": "empty"}
    mesh = boxMesh((0, 0, 0), (*cells, 1), (*cells, 1), patches)
    if wedge:
        mesh = wedgeMesh((0, 0), cells, cells, {
            "left": ("symmetryPlane", "x-"), "right": ("symmetryPlane", "x+"),
            "outside": ("patch", "r+")})
        conditions = wedgeConditions({"left": "symmetryPlane", "right": "symmetryPlane",
                                      "outside": "calculated"})
    case.write("system/blockMeshDict", mesh)
    case.write("constant/phaseProperties", {"phases": ["body"], "body": {**LAW, **phase}})
    velocityFile(case, "body", conditions)
    if lines:
        strip(case, "body.stl", *lines)
        region = surfaceRegion("body.stl")
    case.write("system/setMaterialPointsDict", {"regions": {
        "body": {"phase": "body", "pointsPerCell": 2, **region}}})
    case.write("system/fvSolution", {"materialPoints": FLIP})
    noSchemes(case)
    control = controlDict(end, writeInterval or end, maxCo=maxCo, functions=ENERGY)
    control["startFrom"] = "latestTime"
    case.write("system/controlDict", control)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def last(case):
    """Start places, displacements and stresses of the points at the end."""
    start, end = case.points("0", "body"), case.points(case.times()[-1], "body")
    x = start.byId("x")[:, :2]
    return x, end.byId("x")[:, :2] - x, end.byId("sigma")


def energyAtEnd(case):
    """Last values of energy.dat by the names of its columns."""
    with open(case.file("postProcessing", "energy", "0", "energy.dat")) as f:
        head = [line for line in f if line.startswith("#")][-1]
    names = [word.split("[")[0] for word in head.replace("#", " ").split()]
    return dict(zip(names, case.series("energy", "energy.dat")[-1]))


def plate(table, label, damping, periods, h=16.37, w=6):
    """Upper side at y = h, inside a cell; t on it."""
    t = 100.0
    loads = {"top": {"traction": (0, t, 0), "normal": (0, 1, 0), "min": (-1, h - 2, -1)}}
    case = build(f"plate {label}", (w + 2, int(h) + 3),
                 {"type": "box", "min": (0, 0, 0), "max": (w, h, 1)},
                 {"surfaceLoads": loads, "damping": damping}, periods*4*h/C,
                 maxCo=0.1)
    case.run("materialPointFoam", limit=120)
    x, u, sigma = last(case)
    table.row(f"plate, {label}: sigma_yy/t of all points, largest error", 0,
              np.abs(sigma[:, 3]/t - 1).max(), 0.03)
    table.row(f"plate, {label}: mean sigma_yy/t", 1, sigma[:, 3].mean()/t, 0.005, "relative")
    table.row(f"plate, {label}: displacement of the points", 0,
              np.abs(u[:, 1] - t*(1 - NU**2)/E*x[:, 1]).max()
              /(t*(1 - NU**2)/E*h), 0.01)
    e = energyAtEnd(case)
    table.row(f"plate, {label}: kinetic/strain energy", 0, e["kinetic"]/e["strain"], 1e-4)
    table.row(f"plate, {label}: work of the load/strain energy", 2,
              e["external"]/e["strain"], 0.01, "relative")
    table.row(f"plate, {label}: damping/strain energy", -1, e["damping"]/e["strain"], 0.01,
              "relative")
    table.row(f"plate, {label}: residual and remap/work of the load", 0,
              (e["residual"] + e["remap"])/e["external"], 0.01)


def arc(radius, n=32):
    angle = np.linspace(0, np.pi/2, n + 1)
    return radius*np.array((np.cos(angle), np.sin(angle))).T


def ring(table, a, limit):
    """Inner pressure on a ring of outer radius 2 a."""
    b, p = 2.0*a, 100.0
    n = int(b) + 2
    case = build(f"ring {a}", (n, n), {},
                 {"surfaceLoads": {"inside": {"pressure": p,
                                              "max": (a + 1.5, a + 1.5, 1)}},
                  "damping": {"type": "kinetic"}},
                 40*b/C, lines=(arc(a), arc(b)))
    case.run("materialPointFoam", limit=300)
    x, u, sigma = last(case)
    r = np.hypot(*x.T)
    cos, sin = x.T/r
    hoop = sigma[:, 0]*sin**2 - 2*sigma[:, 1]*sin*cos + sigma[:, 3]*cos**2
    radial = sigma[:, 0]*cos**2 + 2*sigma[:, 1]*sin*cos + sigma[:, 3]*sin**2
    k = p*a*a/(b*b - a*a)
    inner = (r > a + 1) & (r < b - 1)
    peak = k*(1 + b*b/a/a)
    for name, value, exact in (("hoop", hoop, k*(1 + b*b/r**2)),
                               ("radial", radial, k*(1 - b*b/r**2))):
        error = (value - exact)[inner]/peak
        table.row(f"ring, a {a} h: {name} stress, rms error of the largest", 0,
                  np.sqrt(np.mean(error**2)), limit)
    ur = (u*x).sum(axis=1)/r
    exact = (1 + NU)/E*k*((1 - 2*NU)*r + b*b/r)
    table.row(f"ring, a {a} h: displacement, mean over the exact", 1,
              np.mean(ur[inner]/exact[inner]), limit, "relative")


def axis(table, a=6.0):
    b, p = 2*a, 100.0
    case = build("axis", (4, int(b) + 2),
                 {"type": "box", "min": (0, a, -9), "max": (4, b, 9)},
                 {"surfaceLoads": {"inside": {"pressure": p, "max": (9, a + 1.5, 9)}},
                  "damping": {"type": "kinetic"}}, 40*b/C, wedge=True)
    case.run("materialPointFoam", limit=100)
    x, _, sigma = last(case)
    r = x[:, 1]
    k = p*a*a/(b*b - a*a)
    peak = k*(1 + b*b/a/a)
    cell = np.floor(r).astype(int) - int(a)
    for name, value, exact in (("hoop", sigma[:, 5], k*(1 + b*b/r**2)),
                               ("radial", sigma[:, 3], k*(1 - b*b/r**2))):
        mean = np.bincount(cell, value - exact)/np.bincount(cell)
        table.row(f"tube on a wedge, a {a:g} h: {name} stress of cells, largest error of the"
                  " largest", 0, np.abs(mean).max()/peak, 0.02)


def sphere(table, a=10.0, limit=0.05):
    b, p = 2*a, 100.0
    n = int(b) + 2
    case = build("sphere", (n, n), {"type": "sphere", "centre": (0, 0, 0), "radius": b,
                                    "innerRadius": a},
                 {"surfaceLoads": {"inside": {"pressure": p, "max": (a + 1.5, a + 1.5, 9)}},
                  "damping": {"type": "kinetic"}}, 40*b/C, wedge=True)
    case.run("materialPointFoam", limit=100)
    x, u, sigma = last(case)
    r = np.hypot(*x.T)
    cos, sin = x.T/r
    radial = sigma[:, 0]*cos**2 + 2*sigma[:, 1]*sin*cos + sigma[:, 3]*sin**2
    k = p*a**3/(b**3 - a**3)
    inner = (r > a + 1) & (r < b - 1)
    peak = k*(1 + b**3/a**3/2)
    for name, value, exact in (("hoop", sigma[:, 5], k*(1 + b**3/r**3/2)),
                               ("radial", radial, k*(1 - b**3/r**3))):
        error = (value - exact)[inner]/peak
        table.row(f"hollow sphere on a wedge, a {a:g} h: {name} stress, rms error of the "
                  "largest", 0, np.sqrt(np.mean(error**2)), limit)
    ur = (u*x).sum(axis=1)/r
    exact = k/E*((1 - 2*NU)*r + (1 + NU)/2*b**3/r**2)
    table.row(f"hollow sphere on a wedge, a {a:g} h: displacement, mean over the exact", 1,
              np.mean(ur[inner]/exact[inner]), limit, "relative")


def hole(table, a, limit, width=6):
    """Half width of the plate: width a."""
    t, w = 100.0, float(width*a)
    n = int(w)
    rim = np.array([(w, w*np.tan(s)) if s <= np.pi/4 else (w/np.tan(s), w)
                    for s in np.linspace(0, np.pi/2, 33)])
    case = build(f"hole {a}", (n + 2, n + 2), {},
                 {"surfaceLoads": {"top": {"traction": (0, t, 0), "normal": (0, 1, 0),
                                           "min": (-1, w - 2, -1)}},
                  "damping": {"type": "kinetic"}}, 30*w/C, lines=(arc(a), rim))
    case.run("materialPointFoam", limit=600)
    x, _, sigma = last(case)
    near = (x[:, 1] < 0.5) & (x[:, 0] > a + 0.5)
    r, s = x[near, 0], sigma[near, 3]/t
    ratio = 1/width
    net = 2 + 0.284*(1 - ratio) - 0.6*(1 - ratio)**2 + 1.32*(1 - ratio)**3
    gross = net/(1 - ratio)
    kirsch = (2 + (a/r)**2 + 3*(a/r)**4)/2
    order = np.argsort(r)[:2*a]
    # From the first points beyond half a cell to the rim, along Kirsch' curve
    peak = np.mean((s/kirsch)[order[:4]])*3
    table.row(f"hole, a {a} h: stress at its rim/t", gross, peak, limit, "relative")
    table.row(f"hole, a {a} h: stress up to 2 a, rms error of Kirsch'", 0,
              np.sqrt(np.mean((s - kirsch*gross/3)[order]**2))/gross, limit)


def growing(name, stops, end=0.6):
    case = build(name, (6, 10), {"type": "box", "min": (0, 0, 0), "max": (4, 8, 1)},
                 {"surfaceLoads": {"top": {
                     "traction": f"table ((0 (0 0 0)) ({end} (10 1e3 0)))",
                     "normal": (0, 1, 0), "min": (-1, 6.5, -1)}},
                  "damping": {"type": "kinetic"}}, end, end/4)
    return case


def restart(table, end=0.6):
    results = []
    for stops in ((end,), (end/2, end)):
        case = growing(f"restart {len(stops)}", stops, end)
        for stop in stops:
            case.change("system/controlDict", r"^endTime .*;", f"endTime {stop};")
            case.run("materialPointFoam")
        points = case.points(case.times()[-1], "body")
        results.append([points[c] for c in ("x", "U", "sigma", "V")])
    table.check("restart: bit by bit",
                all(np.array_equal(a, b) for a, b in zip(*results)),
                f"{np.abs(results[0][0] - results[1][0]).max():.3g}")


def parallel(table):
    one, two = growing("one", ()), growing("two", ())
    one.run("materialPointFoam")
    two.decompose((1, 2, 1))
    two.runParallel()
    table.row("2 processors against 1, of the largest value", 0,
              one.largestDifference(two, one.times()[-1], ("body",),
                                    ("x", "U", "sigma", "V")), 1e-9)


def redone(table, rate=0.5, U=5*C, end=1.0):
    """A block flies freely, viscous damping, steps that are redone: U exp(-rate t)."""
    case = build("redone", (4*int(U*end/4) + 8, 2),
                 {"type": "box", "min": (2.5, 0, 0), "max": (4.5, 1, 1),
                  "velocity": (U, 0, 0)}, {"damping": {"type": "viscous", "rate": rate}},
                 end, maxCo=0.9)
    # Steps grow to 0.75 of a cell and are made smaller
    case.write("system/fvSolution", {"materialPoints": {**FLIP, "maxTravel": 0.5}})
    case.run("materialPointFoam")
    n = int(re.findall(r"steps redone: (\d+)", case.log())[-1])
    u = case.points(case.times()[-1], "body")["U"][:, 0]
    table.check("viscous damping: steps were redone", n > 10, n)
    table.row("viscous damping, redone steps: velocity over the exact", 1,
              u.mean()/(U*np.exp(-rate*end)), 1e-9)
    e = energyAtEnd(case)
    table.row("viscous damping, redone steps: term damping over what K lost", 1,
              e["damping"]/(0.5*2*RHO*U**2*(np.exp(-2*rate*end) - 1)), 1e-9)


def source(table):
    """A load is a source of energy: without a budget nothing is warned of."""
    case = growing("source", ())
    case.write("system/fvSolution", {"materialPoints": {**FLIP, "energyBudget": False}})
    case.change("system/controlDict", r"functions\s*\{[\s\S]*", "reportInterval 1;")
    case.run("materialPointFoam")
    strain = [float(w) for w in re.findall(r"strain (\S+),", case.log())]
    table.check("a load that does work is no growth without a source", "Energy has grown"
                not in case.log() and strain[-1] > 10*strain[0], strain[-1])


def pushed(table):
    """A wall begins to push a body at rest: its energy is nearly zero at first."""
    case = build("pushed", (10, 10), {"type": "box", "min": (0, 4, 0), "max": (10, 10, 1)},
                 {}, 0.5)
    velocityFile(case, "body", {
        "left": "symmetryPlane", "bottom": "symmetryPlane", "sides": "empty",
        "outside": {"type": "timeVaryingUniformFixedValue", "value": "uniform (0 0 0)",
                    "file": '"wall"', "outOfBounds": "clamp"}})
    with open(case.file("wall"), "w") as f:
        f.write("((0 (0 0 0)) (0.5 (0 -0.05 0)))\n")
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "GIMP", "transfer": "FMPM", "order": 2, "energyBudget": True}})
    case.change("system/controlDict", r"functions\s*\{[\s\S]*",
                "reportInterval 1;")
    case.run("materialPointFoam")
    work = [float(w) for w in re.findall(r", boundary (\S+),", case.log())]
    table.check("a wall that begins to push is no growth without a source",
                "Energy has grown" not in case.log() and work[-1] > 10*work[0] > 0,
                work[-1])


def badInput(table):
    top = {"pressure": 1.0}
    for what, phase, words in (
            ("both", {"surfaceLoads": {"top": {**top, "traction": (0, 1, 0)}}},
             ("either pressure",)),
            ("neither", {"surfaceLoads": {"top": {"min": (0, 0, 0)}}}, ("either pressure",)),
            ("no normal", {"surfaceLoads": {"top": {"traction": (0, 1, 0)}}}, ("normal",)),
            ("normal 0", {"surfaceLoads": {"top": {"traction": (0, 1, 0),
                                                   "normal": (0, 0, 0)}}}, ("direction",)),
            ("normal of a pressure", {"surfaceLoads": {"top": {**top, "normal": (0, 1, 0)}}},
             ("only goes with traction",)),
            ("box outside", {"surfaceLoads": {"top": {**top, "min": (90, 0, 0)}}},
             ("No node", "the mesh is in")),
            ("unknown keyword", {"surfaceLoads": {"top": {**top, "box": 1}}}, ("box", "min")),
            ("damping type", {"damping": {"type": "linear"}}, ("viscous", "kinetic")),
            ("no rate", {"damping": {"type": "viscous"}}, ("rate",)),
            ("rate of kinetic", {"damping": {"type": "kinetic", "rate": 1}}, ("rate",))):
        case = build("bad input", (4, 4), {"type": "box", "min": (0, 0, 0), "max": (2, 2, 1)},
                     {}, 0.01)
        case.write("constant/phaseProperties", {"phases": ["body"], "body": {**LAW, **phase}})
        case.run("materialPointFoam", fails=True)
        text = " ".join(case.log().split())
        table.check(f"message: {what}", "FATAL" in text and all(w in text for w in words),
                    case.reason(case.file("log.materialPointFoam"))[:150])


def main():
    table = Report("quasiStatic")
    w1 = np.pi*np.sqrt(E/(1 - NU**2)/RHO)/2/16.37
    tests = [
        lambda: plate(table, "viscous", {"type": "viscous", "rate": 2*w1}, 3),
        lambda: plate(table, "kinetic", {"type": "kinetic"}, 5),
        lambda: ring(table, 6, 0.05),
        lambda: hole(table, 4, 0.1),
        lambda: axis(table),
        lambda: sphere(table),
        lambda: restart(table),
        lambda: parallel(table),
        lambda: redone(table),
        lambda: source(table),
        lambda: pushed(table),
        lambda: badInput(table)]
    if VERIFY:
        tests += [lambda: ring(table, 16, 0.02), lambda: hole(table, 10, 0.05)]
    for test in tests:
        try:
            test()
        except RunFailed as e:
            table.check("runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
