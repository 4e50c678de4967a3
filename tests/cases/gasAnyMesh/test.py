#!/usr/bin/env python3
"""Points and a gas on cells of any kind (solidFraction star).

A box of prisms, moved hexahedra (one layer with empty sides) or tetrahedra, as in
anyMesh; points with node-dual functions.

    translation   a disc and a turned block move with the gas at 100 m/s across the
                  mesh, also on two processors: pressure of every step within 1e-11,
                  momentum 1e-12
                  a rigid block through cyclic sides: pressure 1e-11
    rest          a block in still gas between walls: velocities 1e-11 m/s
    rotation      a disc of 10 cells that turns with its pore gas, edge speed 100 m/s,
                  sticking, for the time of half a turn: pressure in gas, mixed cells and
                  core; no pressure set to the isentrope; with APIC its angular momentum
                  2 % (boxes), 5 %
    shock         air of 4 bar meets a moving block at 30 degrees in a cyclic box: momentum
                  of all 1e-12, mass 1e-12, energy residual <= 1e-3, falling with the step;
                  on triangles of gmsh between walls too. At twice the Courant number (of
                  the gas on prisms 0.95) no pressure set to the isentrope
    stable        the same at maxCo 0.4 with a pore floor of 0.003: bodies light and heavy,
                  soft and stiff, FLIP, APIC and FMPM 2 on cells of all kinds: no pressure
                  set to the isentrope, none above 1.5 of the highest at the start; rigid
                  bodies too, with a free one momentum of all 1e-12
    restart       at half time of a shock: bit by bit
    processors    a shock on a body that moves from one processor to the other, on prisms
                  and tetrahedra with cyclic sides and polyhedra with warped faces: as on
                  one processor, 1e-10; restart on two bit by bit
    packed        grains that their granular pressure pushes away from a wall: momentum
                  3 %; a disc that it drives apart: momentum of all 1e-12, on two processors
                  as on one
    second order  MLP: a disc and a ball move with the gas, the latter on two processors; a
                  block at rest; a shock on a moving block, with the limits of the parts above
    open sides    a block at rest from one open side to the other: pressure 1e-10, mass of
                  the gas 1e-12
    spall         plates in air on prisms, and as 3D columns on tetrahedra and polyhedra,
                  FMPM 2, Courant number 0.4, failure at 400 MPa to 3 us: first tension 1.5 %
                  (50 cells over the target; polyhedra 30), p > 0, no pressure set to the
                  isentrope, mass of the gas 1e-12; without failure compression and tension
                  4 %. Columns: short ones always, the others with VERIFY
    wedges        quadrilaterals and triangles about an axis (wedges.py): translation, rest,
                  shock, restart, processors as above; a ring that a blast drives outward:
                  energy 1 %, its speed as with the form lattice
    exchanges   finite drag and heat, normal drag, failed points (exchange.py)
"""

import math
import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import exchange
import plateImpactExact as exact
import wedges
from blockInGas import EXTREMES, P0, R, figures, gasFields, gasSchemes
from cellMesh import boxOfCells
from coupledCases import gasLog
from foamCase import (FoamCase, VERIFY, controlDict, foamText, readField, readInternal,
                      runParts, velocityFile, writeField)
from plates import crossing, plateCase
from surfaces import prisms, surfaceRegion

H, E, RHO = 1e-4, 70e9, 2700.0
WAVE = np.sqrt(E/RHO)
FLIP = {"shapeFunction": "nodeDual", "transfer": "FLIP", "PICfraction": 0.01}
DISC, BLOCK, BALL = "disc", "block at 30 degrees", "ball"


def region(case, body, n, H):
    """Region of setMaterialPointsDict around the middle of n cells."""
    c = 0.5*H*np.array(n)
    if body == DISC:
        return {"type": "cylinder", "point1": [c[0], c[1], -1], "point2": [c[0], c[1], 1],
                "radius": 6.2*H}
    if body == BALL:
        return {"type": "sphere", "centre": c, "radius": 2.6*H}
    if body == BLOCK:
        s, co = 5.1*np.sin(np.pi/6), 5.1*np.cos(np.pi/6)
        corners = [c[:2] + H*np.array([co*i - s*j, s*i + co*j])
                   for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        prisms(case, "turned.stl", [corners])
        return surfaceRegion("turned.stl")
    return body


def bodyInGas(name, kind, n, body, velocity, steps, walls=False, moved=0.2, Co=0.4,
              numerics=FLIP, gas=None, phase=None, reports=20, points=2, writes=1,
              prepare=None, h=H, modulus=E, gasVelocity=None, split=None, start=None,
              rho=RHO, control=None, scheme="upwind"):
    """walls: True, False (open) or "cyclic"; split: pieces (nx, ny, nz), one for each
    processor; start: called with the case before the run on these; control: more of
    controlDict."""
    case = FoamCase("gasAnyMesh", name.replace(" ", "-").replace(",", ""))
    solid = not {"type", "volumeModel"} & set(phase or {})
    case.write("constant/phaseProperties", {
        "phases": ["air", "block"],
        "air": {"type": "gas", "thermo": "perfectGas", "R": R, "gamma": 1.4, **(gas or {})},
        "block": {**({} if not solid else
                     {"constitutiveModel": {"type": "linearElastic", "rho": rho,
                                            "E": modulus, "nu": 0}}), **(phase or {})}})
    flat = n[2] == 1
    sides = ("x-", "x+", "y-", "y+") + (() if flat else ("z-", "z+"))
    patches = {"outside": ("wall" if walls else "patch", sides)}
    conditions = {"outside": "slip"}
    if walls == "cyclic":
        names = [s.replace("-", "Low").replace("+", "High") for s in sides]
        patches = {a: ("cyclic", (sides[i],), names[i ^ 1]) for i, a in enumerate(names)}
        conditions = {a: "cyclic" for a in names}
    if flat:
        patches["sides"] = ("empty", ("z-", "z+"))
        conditions["sides"] = "empty"
    gasSchemes(case, scheme)
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", **region(case, body, n, h), "pointsPerCell": points,
        **({} if not solid else
           {"velocity": velocity, "stress": "ambient", "pressure": P0})}}})
    case.write("system/fvSolution", {"materialPoints": numerics})
    dt = Co*h/(np.sqrt(modulus/rho) + np.max(np.abs(velocity)))
    case.write("system/controlDict", {
        **controlDict(steps*dt, steps//writes*dt, deltaT=dt, functions=EXTREMES),
        "reportInterval": max(1, steps//reports), **(control or {})})
    if kind == "gmsh":
        triangles(case, h*np.array(n), h)
    else:
        boxOfCells(case, {"polyhedra": "tets", "boxes": "hexes"}.get(kind, kind), (0, 0, 0),
                   h*np.array(n), n, patches, moved=0 if kind == "boxes" else moved)
    if kind == "polyhedra":
        case.run("polyDualMesh", "60", "-overwrite")
    velocityFile(case, "block", {k: "calculated" if v == "slip" and not walls else v
                                 for k, v in conditions.items()})
    gasFields(case, conditions, velocity if gasVelocity is None else gasVelocity)
    if not walls:
        case.change("0/U.air", "type slip;", "type fixedValue; value $internalField;")
    case.run("setMaterialPoints")
    if prepare:
        prepare(case)
    if split:
        case.decompose(split)
        if start:
            start(case)
        case.runParallel(limit=300)
    else:
        case.run("materialPointFoam", limit=300)
    return case


def triangles(case, L, h):
    """Delaunay triangles of gmsh, one layer."""
    with open(case.file("box.geo"), "w") as f:
        f.write(f"""SetFactory("OpenCASCADE");
Mesh.Algorithm = 5;
Rectangle(1) = {{0, 0, 0, {L[0]}, {L[1]}}};
MeshSize {{ PointsOf {{ Surface {{1}}; }} }} = {h};
out[] = Extrude {{0, 0, {L[2]}}} {{ Surface {{1}}; Layers {{1}}; Recombine; }};
Physical Volume("all") = {{out[1]}};
Physical Surface("sides") = {{1, out[0]}};
Physical Surface("outside") = {{out[2], out[3], out[4], out[5]}};
""")
    case.run("gmsh", "-3", "-format", "msh22", "box.geo", "-o", "box.msh")
    case.run("gmshToFoam", "box.msh")
    for name, kind in (("sides", "empty"), ("outside", "wall")):
        case.run("foamDictionary", "-entry", f"entry0.{name}.type", "-set", kind,
                 "constant/polyMesh/boundary")


def compressed(width):
    """Air of 4e5 Pa at x below width."""
    def prepare(case):
        case.run("postProcess", "-func", "writeCellCentres", "-time", "0")
        C = readInternal(case.file("0", "C"))
        p = np.where(C[:, 0] < width, 4*P0, P0)
        case.change("0/p", "internalField.*;",
                    f"internalField nonuniform List<scalar> {len(p)} {foamText(p)};")

    return prepare


TRANSLATIONS = (("prisms", (36, 34, 1), DISC), ("prisms", (36, 34, 1), BLOCK),
                ("hexes", (36, 34, 1), DISC), ("hexes", (36, 34, 1), BLOCK),
                ("prisms", (36, 34, 1), DISC, (2, 1, 1)),
                ("tets", (12, 11, 10), BALL),
                ("tets", (12, 11, 10), BALL, (1, 2, 1)))


def translation(table):
    crossings = 20 if VERIFY else 4
    for kind, n, body, *split in TRANSLATIONS:
        v = np.array((80.0, 60.0, 0.0 if n[2] == 1 else -30.0))
        dt = 0.4*H/(WAVE + np.max(np.abs(v)))
        label = f"translation, {kind}, {body}, {crossings} cells" + ", 2 processors"*len(split)
        case = bodyInGas(f"translation {kind} {body}" + " 2"*len(split), kind, n, body, v,
                         int(crossings*H/(dt*np.linalg.norm(v))),
                         split=split[0] if split else None)
        f = figures(case)
        table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-11, "atMost")
        m = f["momentum"]
        table.row(f"{label}: momentum of the points", 0,
                  np.max(abs(m - m[0]))/np.max(abs(m[0])), 1e-12, "atMost")
        table.row(f"{label}: pressures set to the isentrope", 0, f["fixups"][-1][2], 0)
        print(f"{label}: Theta {f['Theta'].min():.4f} to {f['Theta'].max():.4f}")


def rigidTranslation(table):
    """A rigid block moves with the gas through cyclic sides."""
    v = (100.0, 60.0, 0.0)
    for kind, Co, steps, split in (("prisms", 0.13, 400, None), ("hexes", 0.3, 170, None),
                                   ("prisms", 0.13, 400, (2, 1, 1))):
        name = f"{kind}" + ", 2 processors"*bool(split)
        case = bodyInGas(
            f"rigid translation {name}", kind, (16, 16, 1), BLOCK, v, steps, walls="cyclic",
            modulus=RHO*400.0**2, numerics={"transfer": "FLIP"}, Co=Co, split=split,
            phase={"type": "rigid", "rho": RHO,
                   "motion": {"type": "translation", "velocity": v}})
        f = figures(case)
        label = f"rigid block through cyclic sides, {name}"
        table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-11, "atMost")
        table.row(f"{label}: pressures set to the isentrope", 0, f["fixups"][-1][2], 0)


def rest(table):
    for kind, n in (("prisms", (20, 18, 1)), ("hexes", (20, 18, 1)), ("tets", (8, 8, 8))):
        case = bodyInGas(
            f"rest {kind}", kind, n,
            {"type": "box", "min": (0, 3*H, -1 if n[2] == 1 else 2*H),
             "max": (0.5*n[0]*H, 0.6*n[1]*H, 1 if n[2] == 1 else 5*H)},
            (0, 0, 0), 10000 if VERIFY else 500, walls=True)
        f = figures(case)
        u = np.max(abs(case.points(case.times()[-1], "block")["U"]))
        label = f"rest, {kind}, {case.nSteps()} steps"
        table.row(f"{label}: velocity of points", 0, u, 1e-11, "atMost")
        table.row(f"{label}: velocity of the gas", 0, np.max(f["speed"]), 1e-11, "atMost")
        table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-13, "atMost")


def shockOnBlock(name, kind, steps, n=(40, 40, 1), **options):
    """Air of 4e5 Pa in a fifth of a box, cyclic or with walls, meets a moving block."""
    h = 1e-3
    case = bodyInGas(f"{name} {kind}", kind, n, BLOCK if n[2] == 1 else BALL,
                     (30, -10, 0) if kind == "polyhedra" else (50, -30, 0),
                     steps, walls=kind in ("gmsh", "polyhedra") or "cyclic",
                     prepare=compressed(0.2*n[0]*h), h=h, reports=steps,
                     gasVelocity=(0, 0, 0), **options)
    return case, figures(case)


def residual(f):
    energy = f["energy"] + f["gasEnergy"]
    return (energy[-1] - energy[0])/np.max(abs(f["gasEnergy"] - f["gasEnergy"][0]))


def shock(table):
    for kind, courant in (("hexes", 0.4), ("prisms", 0.4), ("gmsh", 0.3)):
        left = []
        for Co in (courant, courant/2):
            _, f = shockOnBlock(f"shock {Co}", kind, round(240/Co), modulus=7e9, Co=Co)
            left.append(residual(f))
            label = f"shock on a turned block, {kind}, Courant number {Co}"
            table.row(f"{label}: pressures set to the isentrope", 0, f["fixups"][-1][2], 0)
        if kind != "gmsh":
            total = f["momentum"] + f["gasMomentum"]
            table.row(f"{label}: momentum of all, over the block's", 0,
                      np.max(abs(total - total[0]))/np.max(abs(f["momentum"][0])), 1e-12,
                      "atMost")
        table.row(f"{label}: mass of the gas", f["gasMass"][0], f["gasMass"][-1], 1e-12,
                  "relative")
        table.row(f"{label}: energy residual over exchanged", 0, left[1], 1e-3)
        table.check(f"{label}: half of the step before's", abs(left[1]) < 0.75*abs(left[0]),
                    f"{left[0]:.2e}, {left[1]:.2e}")


TRANSFERS = {"FLIP": FLIP, "APIC": {"shapeFunction": "nodeDual", "transfer": "APIC"},
             "FMPM 2": {"shapeFunction": "nodeDual", "transfer": "FMPM", "order": 2}}
#: Kind, modulus, density, transfer; those that VERIFY adds are all others
STABLE = (("prisms", 0.1e9, 50.0, "FMPM 2"), ("hexes", 0.1e9, 2700.0, "APIC"),
          ("tets", 0.1e9, 2700.0, "FLIP"), ("polyhedra", 7e9, 2700.0, "FMPM 2"))


def stableRows(table, label, kind, **options):
    flat = kind in ("prisms", "hexes")
    end = 100e-6 if flat else 40e-6 if VERIFY else 25e-6
    case, f = shockOnBlock(
        f"stable {label}", kind, 1, (24, 20, 1) if flat else (10, 8, 8),
        gas={"poreFloor": 0.003}, **options,
        control={"endTime": end, "deltaT": 1e-9, "writeInterval": end, "maxCo": 0.4,
                 "writeControl": "adjustableRunTime", "adjustTimeStep": True})
    label += ", maxCo 0.4"
    table.row(f"{label}: pressures set to the isentrope", 0, f["fixups"][-1][2], 0)
    table.row(f"{label}: largest pressure over that of the start", 1,
              f["p"][:, 1].max()/(4*P0), 1.5, "atMost")
    print(f"{label}: {case.nSteps()} steps, {case.solverSeconds():.1f} s, p"
          f" {f['p'][:, 0].min():.0f} to {f['p'][:, 1].max():.0f} Pa", flush=True)
    return f


def stable(table):
    scenes = STABLE
    if VERIFY:
        scenes = [(kind, E, rho, transfer) for kind in ("prisms", "hexes", "tets", "polyhedra")
                  for E in (7e9, 0.1e9) for rho in (2700.0, 50.0) for transfer in TRANSFERS]
    for kind, modulus, rho, transfer in scenes:
        f = stableRows(table, f"{kind}, E {modulus:g}, density {rho:g}, {transfer}", kind,
                       modulus=modulus, rho=rho, numerics=TRANSFERS[transfer])
        print(f"energy residual {residual(f):.1e}")
    for motion in ({"type": "translation", "velocity": (50, -30, 0)},
                   {"type": "free", "velocity": (50, -30, 0),
                    "constraints": ["rotation"]}):
        f = stableRows(table, f"prisms, rigid, {motion['type']}", "prisms", phase={
            "type": "rigid", "rho": 2700.0, "motion": motion})
    total = f["momentum"] + f["gasMomentum"]
    table.row("prisms, rigid, free: momentum of all over the body's", 0,
              np.max(abs(total - total[0]))/np.max(abs(f["momentum"][0])), 1e-12, "atMost")


def secondOrder(table):
    """The gas beside solid is of first order, away from it by MLP."""
    for kind, n, body, split in (("prisms", (36, 34, 1), DISC, None),
                                 ("tets", (12, 11, 10), BALL, (2, 1, 1))):
        v = np.array((80.0, 60.0, 0.0 if n[2] == 1 else -30.0))
        case = bodyInGas(f"MLP translation {kind}", kind, n, body, v, 100, split=split,
                         scheme="MLP")
        f = figures(case)
        label = f"MLP, translation, {kind}" + ", 2 processors"*bool(split)
        table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-11, "atMost")
        m = f["momentum"]
        table.row(f"{label}: momentum of the points", 0,
                  np.max(abs(m - m[0]))/np.max(abs(m[0])), 1e-12, "atMost")
    case = bodyInGas("MLP rest", "prisms", (20, 18, 1),
                     {"type": "box", "min": (0, 3*H, -1), "max": (10*H, 11*H, 1)}, (0, 0, 0), 500,
                     walls=True, scheme="MLP")
    f = figures(case)
    table.row("MLP, rest, prisms: velocity of the gas", 0, np.max(f["speed"]), 1e-11, "atMost")
    table.row("MLP, rest, prisms: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-13, "atMost")

    case, f = shockOnBlock("MLP shock", "hexes", 600, modulus=7e9, scheme="MLP")
    total = f["momentum"] + f["gasMomentum"]
    label = "MLP, shock on a turned block, hexes"
    table.row(f"{label}: momentum of all, over the block's", 0,
              np.max(abs(total - total[0]))/np.max(abs(f["momentum"][0])), 1e-12, "atMost")
    table.row(f"{label}: mass of the gas", f["gasMass"][0], f["gasMass"][-1], 1e-12, "relative")
    table.row(f"{label}: energy residual over exchanged, CFL 0.4", 0,
              residual(f), 0.01)


def restart(table):
    for kind, U, options in (("prisms", (0, 0, 0), {"walls": True}),
                             ("boxes", (100, -80, 0), {"walls": "cyclic", "modulus": 7e9})):
        straight = bodyInGas(f"restart {kind}", kind, (16, 16, 1), BLOCK, U, 120,
                             prepare=compressed(5*H), writes=2, **options)
        half, end = straight.times()[1:]
        again = FoamCase("gasAnyMesh", f"restart-again-{kind}", template=straight.path)
        shutil.copytree(straight.file("constant", "polyMesh"),
                        again.file("constant", "polyMesh"))
        shutil.rmtree(again.file(end))
        again.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
        again.run("materialPointFoam")
        table.row(f"restart at half time, {kind}: points", 0, straight.largestDifference(
            again, end, ["block"], ("x", "U", "sigma", "V")), 0, "atMost")
        files = [open(c.file(end, "thetaRhoE.air"), "rb").read() for c in (straight, again)]
        table.check(f"restart at half time, {kind}: gas bit by bit", files[0] == files[1])


def onProcessors(name, kind, n, split=None, start=None, **options):
    """A shock on a moving body in the middle, which is where the pieces meet."""
    flat = n[2] == 1
    return bodyInGas(f"ranks {name}", kind, n, BLOCK if flat else BALL,
                     (100, -80, 0 if flat else 50), 60, modulus=7e9, writes=2, reports=60,
                     prepare=compressed(0.3*n[0]*H), split=split, start=start, **options)


MESHES = (("prisms", (16, 16, 1), [(2, 1, 1)], {"walls": "cyclic"}),
          ("tets", (8, 8, 8), [(1, 2, 1)], {"walls": "cyclic"}),
          ("polyhedra", (6, 6, 6), [(2, 1, 1)], {"walls": True}))
MORE_MESHES = (("hexes", (16, 16, 1), [(1, 2, 1), (3, 1, 1)], {"walls": "cyclic"}),
               ("warped", (8, 8, 8), [(1, 1, 2), (1, 3, 1)], {"walls": "cyclic"}),
               ("boxes", (16, 16, 1), [(2, 1, 1), (3, 1, 1)],
                {"walls": "cyclic", "gas": {"solidFraction": "star"},
                 "numerics": {**FLIP, "shapeFunction": "linear"}}))


def processors(table):
    for kind, n, splits, options in MESHES + MORE_MESHES*VERIFY:
        one = onProcessors(f"{kind} 1", kind, n, **options)
        half, end = one.times()[1:3]
        for split in splits + [(3, 1, 1)]*(VERIFY and len(splits) == 1):
            ranks = int(np.prod(split))
            several = onProcessors(f"{kind} {ranks}", kind, n, split, **options)
            label = f"shock, {kind}, 1 against {ranks} processors"
            table.row(f"{label}: points", 0, one.largestDifference(
                several, end, ["block"], ("x", "U", "sigma", "V")), 1e-10, "atMost")
            a, b = figures(one), figures(several)
            for name in ("p", "speed", "gasMomentum", "gasEnergy"):
                table.row(f"{label}: {name}", 0,
                          np.max(abs(a[name] - b[name]))/np.max(abs(a[name])), 1e-10,
                          "atMost")

        def fromHalf(case):
            for p, q in zip(several.processors(), case.processors()):
                shutil.copytree(os.path.join(p, half), os.path.join(q, half))
            case.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")

        again = onProcessors(f"{kind} again", kind, n, split, fromHalf, **options)
        label = f"{kind}, restart at half time on {ranks} processors"
        table.row(f"{label}: points", 0, several.largestDifference(
            again, end, ["block"], ("x", "U", "sigma", "V")), 0, "atMost")
        files = [[open(os.path.join(p, end, "thetaRhoE.air"), "rb").read()
                  for p in c.processors()] for c in (several, again)]
        table.check(f"{label}: gas bit by bit", files[0] == files[1])


def grains(name, kind, n, region, U, steps, low=0.5, high=0.65, Fr=10, split=None, **more):
    return bodyInGas(
        name, kind, n, {"volumeFraction": 0.6, "velocity": U, **region}, U, steps, h=1e-3,
        phase={"volumeModel": "grains",
               "constitutiveModel": {"type": "noStress", "rho": 2500.0},
               "granularPressure": {"type": "JohnsonJackson", "alphaMin": low,
                                    "alphaMax": high, "Fr": Fr, "delta": 0.04}},
        modulus=RHO*340**2, Co=0.12, reports=steps, split=split, **more)


def packed(table):
    """Grains of fraction a against a wall push themselves away from it: their momentum is
    p_s(a) times area and time until the wave, c = sqrt(p_s'/rho), is back at the wall."""
    n, a, low, high, width = (20, 4, 1), 0.6, 0.5, 0.65, 1e-2
    p = 10*a*(a - low)**2/(high - a)**5
    c = np.sqrt(p*(1/a + 2/(a - low) + 5/(high - a))/2500)
    dt = 0.12e-3/340
    steps = int(0.6*width/c/dt)
    for kind in ("prisms", "hexes"):
        case = grains(f"packed {kind}", kind, n,
                      {"type": "box", "min": (-1, -1, -1), "max": (width, 1, 1)}, (0, 0, 0),
                      steps, walls=True)
        table.row(f"packed grains at a wall, {kind}: momentum [kg m/s]",
                  p*n[1]*1e-6*steps*dt, figures(case)["momentum"][-1, 0], 0.03, "relative")

    n, U = (20, 20, 1), np.array((1.0, 0.5, 0.0))
    disc = {"type": "cylinder", "point1": (0.01, 0.01, -1), "point2": (0.01, 0.01, 1),
            "radius": 0.006}
    cases = [grains(f"packed disc {split}".replace(", ", ""), "prisms", n, disc, U, steps,
                    walls="cyclic", split=split) for split in (None, (2, 1, 1))]
    for case, ranks in zip(cases, (1, 2)):
        f = figures(case)
        total = f["momentum"] + f["gasMomentum"]
        label = f"disc of packed grains, prisms, {ranks} processors"
        table.row(f"{label}: momentum of all over the grains'", 0,
                  np.max(abs(total - total[0]))/np.max(abs(f["momentum"])), 1e-12, "atMost")
    u = cases[0].points(cases[0].times()[-1], "block").byId("U")
    table.row("disc of packed grains, prisms: it is driven apart, mean velocity over half of"
              " p_s/(rho c)", 1, np.mean(np.linalg.norm(u - U, axis=1))/(0.5*p/(1500*c)), 1,
              "atLeast")
    table.row("disc of packed grains, 1 against 2 processors: points", 0,
              cases[0].largestDifference(cases[1], cases[0].times()[-1], ["block"],
                                         ("x", "U", "V")), 1e-10, "atMost")


def spallOf(kind, cells, end, strength=None, **options):
    """Plates in air, cells over the flyer; time and stress in the middle, the log."""
    h = exact.H/cells
    case = plateCase("gasAnyMesh", f"spall-{kind}-{'failing' if strength else 'whole'}", cells,
                     {"shapeFunction": "nodeDual", "transfer": "FMPM", "order": 2,
                      "strainFilter": 1}, end, end, 0.4, strength=strength, air={},
                     probes=[("target", "middle", ("sigma_yy",), exact.H - h/2,
                              exact.H + h/2, "mean")], cells=kind, **options)
    case.change("system/controlDict", "^adjustTimeStep", "reportInterval 20;\nadjustTimeStep")
    case.run("materialPointFoam", limit=300)
    log = gasLog(case)
    print(case.path, "Theta", log["ThetaMin"].min(), log["ThetaMax"].max(), case.nSteps(),
          "steps", case.solverSeconds(), "s", flush=True)
    return (*case.series("middle", "sigma_yy.dat").T, log)


def spallRows(table, label, t, stress, log):
    table.row(f"{label}: first tension [us]", 1e6*exact.T_TENSION,
              1e6*crossing(t, stress, 0, 0.8e-6), 0.015, "relative")
    table.row(f"{label}: least pressure [Pa]", 0, log["pMin"].min(), 0, "atLeast")
    table.row(f"{label}: largest pressure [Pa]", 2e5, log["pMax"].max(), 2e5, "atMost")
    table.row(f"{label}: pressures set to the isentrope", 0, log["isentropic"][-1], 0)
    table.row(f"{label}: mass of the gas", log["mass"][0], log["mass"][-1], 1e-12,
              "relative")


def spall(table):
    """Plates in air, with failure and without."""
    column = {"width": 2, "depth": 2}
    for kind, cells, size in (("prisms", 25, {}),
                              *(VERIFY*(("tets", 25, column), ("polyhedra", 15, column)))):
        spallRows(table, f"spall in air, {kind}, strength 400 MPa, to 3 us",
                  *spallOf(kind, cells, 3e-6, 400e6, **size))
    for kind, cells, size in (("tets", 25, column), ("polyhedra", 15 if VERIFY else 10, column),
                              *(VERIFY*(("prisms", 25, {}),))):
        t, stress, log = spallOf(kind, cells, 1.8e-6 if VERIFY else 1.15e-6, **size)
        label = f"plates in air, {kind}"
        spallRows(table, label, t, stress, log)
        for name, sign, low, high in (("compression", -1, 0.6e-6, 0.95e-6),
                                      ("tension", 1, 1.35e-6, 1.75e-6)):
            if high < t[-1]:
                table.row(f"{label}: {name} over the exact", sign,
                          np.mean(stress[(t > low) & (t < high)])/exact.STRESS, 0.04)


def openSides(table):
    """A block from one open side of the mesh to the other."""
    def opened(case):
        case.change("0/p", "type zeroGradient;",
                    f"type totalPressure; p0 uniform {P0}; gamma 1.4; rho rho.air;"
                    " phi phi.air; U U.air; psi psi.air;")
        case.change("0/U.air", "type fixedValue;",
                    "type pressureInletOutletVelocity; phi phi.air;")

    across = {"type": "box", "min": (-1, 3*H, -1), "max": (1, 7*H, 1)}
    for kind in ("prisms", "boxes"):
        case = bodyInGas(f"open sides {kind}", kind, (12, 10, 1), across, (0, 0, 0), 300,
                         prepare=opened)
        f = figures(case)
        label = f"block across open sides, {kind}, at rest"
        table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-10, "atMost")
        table.row(f"{label}: mass of the gas", f["gasMass"][0], f["gasMass"][-1], 1e-12,
                  "relative")


def turningDisc(name, kind, edge, arc, R=10, n=(36, 36, 1), points=2, Co=0.4,
                numerics=None):
    """A disc that turns by arc [cells at its edge] with its pore gas."""
    centre = 0.5*H*np.array(n[:2])

    def turning(x):
        r = x[:, :2] - centre
        return np.column_stack((-r[:, 1], r[:, 0], 0*r[:, 0]))*edge/(R*H)

    def prepare(case):
        case.run("postProcess", "-func", "writeCellCentres", "-time", "0")
        C = readInternal(case.file("0", "C"))
        inside = (C[:, 0] - centre[0])**2 + (C[:, 1] - centre[1])**2 < (R*H)**2
        U = turning(C)*inside[:, None]
        case.change("0/U.air", "internalField.*;",
                    f"internalField nonuniform List<vector> {len(U)} {foamText(U)};")
        x = readField(case.file("0/lagrangian/block/x"))
        writeField(case.file("0/lagrangian/block/U"), turning(x))

    dt = Co*H/(WAVE + edge)
    steps = int(arc*H/edge/dt)//20*20
    body = {"type": "cylinder", "point1": [*centre, -1], "point2": [*centre, 1],
            "radius": R*H}
    return bodyInGas(name, kind, n, body, (0, 0, 0), steps, walls=True, prepare=prepare,
                     writes=20, points=points, Co=Co,
                     numerics=numerics or FLIP), centre


def deviation(case):
    """Largest |dP|/P in gas, mixed cells and core over the second half."""
    worst = np.zeros(3)
    times = case.times()[1:]
    for name in times[len(times)//2:]:
        p, theta = (readInternal(case.file(name, f)) for f in ("p", "theta.air"))
        off = abs(p/P0 - 1)
        for i, where in enumerate((theta >= 0.99, (theta < 0.99) & (theta > 0.02),
                                   theta <= 0.02)):
            if where.any():
                worst[i] = max(worst[i], off[where].max())
    return worst


def angularMomentum(case, time, centre):
    points = case.points(time, "block")
    x, U, m = points["x"][:, :2] - centre, points["U"], points["m"]
    return np.sum(m*(x[:, 0]*U[:, 1] - x[:, 1]*U[:, 0]))


APIC = {"transfer": "APIC"}

#: Cells, points, numerics, limits of core and mixed cells (prototype in 2D, where there
#: is one; 4: 18 and 5: 32 points per box of two triangles, asked of 16: 0.2, 0.25), least
#: angular momentum (issue: one turn). FLIP's PIC fraction stops the disc
TURNS = (("boxes", 2, APIC, None, None, 0.98),
         ("hexes", 4, {"shapeFunction": "nodeDual", **APIC}, 0.067, 0.059, 0.95),
         ("prisms", 2, {"shapeFunction": "nodeDual", **APIC}, None, None, 0.95),
         ("prisms", 2, FLIP, 0.33, 0.32, None), ("hexes", 2, FLIP, 0.14, 0.05, None),
         ("prisms", 4, FLIP, 0.2, 0.25, None)) + VERIFY*(
         ("prisms", 5, {"shapeFunction": "nodeDual", **APIC}, 0.2, 0.25, 0.95),)


def rotation(table):
    """Sticking, half a turn at 100 m/s. The gas around at most 1.3 times as far off as on
    boxes (lattice)."""
    ofBoxes = None
    for kind, points, numerics, ofCore, ofMixed, kept in TURNS:
        transfer = numerics["transfer"]
        case, centre = turningDisc(f"rotation {kind} {points} {transfer}", kind, 100,
                                   np.pi*10, points=points, numerics=numerics)
        gas, mixed, core = deviation(case)
        f = figures(case)
        L = (angularMomentum(case, case.times()[-1], centre)
             / angularMomentum(case, "0", centre))
        label = f"disc, 100 m/s, half a turn, {kind}, pointsPerCell {points}, {transfer}"
        ofBoxes = ofBoxes or gas
        table.row(f"{label}: |dP|/P in the gas", 0, gas, 1.3*ofBoxes, "atMost")
        if ofCore:
            table.row(f"{label}: in mixed cells", 0, mixed, ofMixed, "atMost")
            table.row(f"{label}: in the core", 0, core, ofCore, "atMost")
        if kept:
            table.row(f"{label}: angular momentum left", 1, L, kept, "atLeast")
        table.row(f"{label}: pressures set to the isentrope", 0, f["fixups"][-1][2], 0)
        print(f"{label}: mixed {mixed:.3f}, core {core:.3f}, Theta {f['Theta'].min():.4f} to"
              f" {f['Theta'].max():.4f}; {L:.4f} of the angular momentum is left;"
              f" {case.nSteps()} steps, {case.solverSeconds():.1f} s", flush=True)


def exchanges(table):
    exchange.relaxation(table, bodyInGas)
    exchange.alongSurface(table, bodyInGas)
    exchange.dry(table, bodyInGas, compressed)


if __name__ == "__main__":
    sys.exit(runParts("gasAnyMesh", translation, rigidTranslation, rest, rotation, shock, stable,
                      secondOrder, restart, processors, packed, openSides, spall, exchanges,
                      wedges.wedgeTranslation, wedges.wedgeRest, wedges.wedgeShock,
                      wedges.wedgeBlast))
