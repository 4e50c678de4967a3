#!/usr/bin/env python3
"""Meshes of gmsh as background and as bodies, and of snappyHexMesh: the tutorials kirsch,
spallOnTriangles, bracket, pipeBlast, sphereOnSphere, cylinderInChannel, connectingRod
and hourglass, short or coarse.

kirsch     plate with a hole on triangles that follow it: stress at the rim 3 S within 2 %,
           stress up to 3 a; the same on boxes with GIMP
spall      plates on triangles, 25 over the target: first tension within 8 ns, compression and
           velocity of the free surface within 1 %
bracket    a body of tetrahedra on other tetrahedra bends over its cells: displacement of its
           centre of mass against a rod, 6 %
pipe       gas drives a plug round a bend of triangles: speed and turning point of a straight
           pipe on boxes within 1 %, mass of the gas to rounding; VERIFY: in 3D on tetrahedra
spheres    two elastic spheres from a mesh collide, half-width of the contact 3 cells: force and
           time of Hertz within 5 %
cylinder   gas at Mach 3 and grains round a cylinder of snappyHexMesh: pitot pressure and place of
           the shock within 5 %, mass of the gas to rounding, no grain lost, their paths those
           of their drag
rod        a rigid part from a STEP file: mass and centre of the mesh to rounding, inertia to second
           order in its size, flight as Euler's equations, momentum to rounding in the hit
ball       a ball from a mesh flies through boxes with GIMP and through tetrahedra with
           nodeDual: velocity 1e-13, momentum and mass to rounding
hourglass  sand through a neck of snappyHexMesh: no point lost, a constant rate 2 %
kept       sand that spreads on the glass: points that pass it are put back, on 2 processors too
pendulum   a block slides in a half-pipe of triangles (halfPipe.py), slip and friction: time,
           speed and energy of the exact pendulum 1 %
"""

import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import halfPipe
import pond
from cellMesh import boxOfCells
from foamCase import PROJECT, VERIFY, FoamCase, boxMesh, controlDict, noSchemes, runParts, velocityFile


def tutorial(name, *modules):
    """Modules of a tutorial; names that several have are read anew."""
    folder = os.path.join(PROJECT, "tutorials", name)
    sys.path.insert(0, folder)
    try:
        for module in modules:
            sys.modules.pop(module, None)
        return [__import__(module) for module in modules]
    finally:
        sys.path.remove(folder)


def copyOf(name, run=None):
    case = FoamCase("gmshMeshes", run or name)
    source = os.path.join(PROJECT, "tutorials", name)
    for part in ("constant", "system", "0"):
        shutil.copytree(os.path.join(source, part), case.file(part), ignore=shutil.ignore_patterns(
            "polyMesh", "lagrangian", "uniform"))
    for path in os.listdir(source):
        if path.endswith(".geo"):
            shutil.copy(os.path.join(source, path), case.path)
    return case


def mesh(case, geo, *patches):
    """As gmshMesh of etc/prepare."""
    case.run("gmsh", "-3", "-format", "msh22", geo + ".geo", "-o", geo + ".msh")
    case.run("gmshToFoam", geo + ".msh")
    for name, kind in patches:
        case.run("foamDictionary", "-entry", f"entry0.{name}.type", "-set", kind,
                 "constant/polyMesh/boundary")


def kirsch(table):
    results, variants = tutorial("kirsch", "results", "variants")
    case = copyOf("kirsch")
    mesh(case, "plate", ("frontAndBack", "empty"))
    case.run("setMaterialPoints")
    case.run("materialPointFoam")
    peak, rms = results.errors(case)
    table.row("plate with a hole, triangles: stress at the rim/S", 3, peak, 0.02, "relative")
    table.row("plate with a hole, triangles: rms error of the stress up to 3 a/S", 0, rms, 0.02)
    boxes = FoamCase("gmshMeshes", "kirschOnBoxes")
    boxes.copy(["U.plate"], source=case.path)
    variants.boxes(boxes)
    boxes.run("blockMesh")
    boxes.run("setMaterialPoints")
    boxes.run("materialPointFoam")
    table.row("plate with a hole, boxes: stress at the rim/S", 3, results.errors(boxes)[0], 0.02,
              "relative")


def spall(table):
    results, = tutorial("spallOnTriangles", "results")
    case = copyOf("spallOnTriangles")
    case.change("plates.geo", r"^h = .*", "h = 15.2e-5;")
    case.change("system/controlDict", r"^endTime .*", "endTime 1.25e-6;")
    case.change("system/controlDict", r"1\.862e-3", "1.824e-3")
    case.change("system/controlDict", r"1\.938e-3", "1.976e-3")
    mesh(case, "plates", ("frontAndBack", "empty"))
    case.run("setMaterialPoints")
    case.run("materialPointFoam")
    tension, torn, plateau, surface = results.figures(case)
    table.row("plates on triangles: first tension [ns]", 3e9*results.H/results.C, 1e9*tension, 8)
    table.row("plates on triangles: compression [MPa]", -1e-6*results.STRESS, 1e-6*plateau, 0.01,
              "relative")
    table.row("plates on triangles: free surface [m/s]", results.V, surface, 0.01, "relative")
    failed = case.points(case.times("lagrangian")[-1], "target")["damage"] > 0.5
    table.check("plates on triangles: the target is torn", 0 < failed.mean() < 0.3,
                f"{failed.mean():.3f} of its points")


def bracket(table):
    results, = tutorial("bracket", "results")
    case = copyOf("bracket")
    case.change("background.geo", r"^h = .*", "h = 0.03;")
    case.change("bracket.geo", r"^h = .*", "h = 0.024;")
    mesh(case, "background")
    case.run("gmsh", "-3", "bracket.geo", "-o", "bracket.msh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=400)
    start = case.points("0", "bracket")
    x = case.series("tip", "bracket.dat")[-1, 7:9] - (start["m"]@start["x"]/start["m"].sum())[:2]
    exact = results.centreOfRod(*(case.entry("constant/phaseProperties", n)
                                  for n in ("E", "nu", "rho")))
    for d in (0, 1):
        table.row(f"bracket: displacement of the centre of mass along {'xy'[d]} [m]", exact[d],
                  x[d], 0.06, "relative")
    table.row("bracket: residual of the energy/work of the weight", 0,
              case.numbers("residual N")[-1]/case.numbers("external N")[-1], 1e-6)


def pipe(table):
    results, variants = tutorial("pipeBlast", "results", "variants")
    folder = os.path.join(PROJECT, "tutorials", "pipeBlast")
    rows = {}
    for name in ("bend", "straight") + (("tube",) if VERIFY else ()):
        case = FoamCase("gmshMeshes", "pipe-" + name)
        case.copy(source=folder)
        for field in os.listdir(os.path.join(folder, "0.orig")):
            shutil.copy(os.path.join(folder, "0.orig", field), case.file("0"))
        if name == "bend":
            shutil.copy(os.path.join(folder, "pipe.geo"), case.path)
            mesh(case, "pipe", ("frontAndBack", "empty"))
        elif name == "tube":
            # It copies files of the folder it is in
            here = os.getcwd()
            os.chdir(folder)
            variants.tube(case)
            os.chdir(here)
        else:
            variants.straight(case)
        case.run("setFields")
        case.run("setMaterialPoints")
        case.run("materialPointFoam", limit=300)
        rows[name] = results.motion(case, name != "straight")
        mass = case.numbers("^Gas air: mass N")
        table.row(f"plug in a {name} pipe: mass of the gas", mass[0], mass[-1], 1e-12, "relative")
    bend, straight, _ = results.figures(rows["bend"], rows["straight"])
    for i, what in ((0, "speed at 5 ms [m/s]"), (2, "turning point [m]")):
        table.row(f"plug in a bent pipe: {what}", straight[i], bend[i], 0.01, "relative")
    if VERIFY:
        table.row("plug in a bent pipe of tetrahedra: turning point [m]", straight[2],
                  results.figures(rows["tube"], rows["straight"])[0][2], 0.01, "relative")


def spheres(table):
    results, = tutorial("sphereOnSphere", "results")
    case = copyOf("sphereOnSphere")
    case.change("sizes.geo", r"^h = .*", "h = 0.4e-3;")
    mesh(case, "space")
    case.run("gmsh", "-3", "spheres.geo", "-o", "spheres.msh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=200)
    rows = results.figures(case)
    for name, unit, exact, ours in (rows[0], rows[2]):
        table.row(f"spheres collide: {name} [{unit}]", exact, ours, 0.05, "relative")


def cylinder(table):
    results, = tutorial("cylinderInChannel", "results")
    case = FoamCase("gmshMeshes", "cylinder")
    folder = os.path.join(PROJECT, "tutorials", "cylinderInChannel")
    case.copy(source=folder)
    for field in os.listdir(os.path.join(folder, "0.orig")):
        shutil.copy(os.path.join(folder, "0.orig", field), case.file("0"))
    for command in (("blockMesh",), ("snappyHexMesh", "-overwrite"), ("extrudeMesh",),
                    ("createPatch", "-overwrite")):
        case.run(*command)
    for side in ("front", "back"):
        case.run("foamDictionary", "-entry", f"entry0.{side}.type", "-set", "empty",
                 "constant/polyMesh/boundary")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=200)
    pressure, shock = results.nose(case, [case.nearest(v, "U.air") for v in (5e-4, 5.5e-4, 6e-4)])
    table.row("cylinder at Mach 3: pressure at the nose (Rayleigh)", results.rayleigh(3.0),
              pressure, 0.05, "relative")
    table.row("cylinder at Mach 3: distance of the shock/R (Billig)", results.SHOCK, shock, 0.05,
              "relative")
    away, free, (_, exact), (_, ours) = results.apart(case)
    table.row("grains round a cylinder: rms distance from their integrated paths/way behind", 0,
              np.sqrt((away[free]**2).mean())*results.R
              /(results.SPEED*8.6e-4 - (exact[-1] - exact[0])[free, 0].min()), 0.02)
    table.row("grains round a cylinder: grains at the end", len(case.points("0", "dust")["m"]),
              len(ours[-1]), 0)
    table.row("grains round a cylinder: mass of the gas", 0, results.massChange(case), 1e-12)
    table.row("grains round a cylinder: fix-ups", 0, case.fixups(), 0)


def rod(table):
    results, = tutorial("connectingRod", "results")
    case = copyOf("connectingRod")
    shutil.copy(os.path.join(PROJECT, "tutorials", "connectingRod", "rod.step"), case.path)
    case.change("system/controlDict", r"^endTime .*", "endTime 0.03;")
    case.change("system/controlDict", r"^writeInterval .*", "writeInterval 0.01;")
    case.run("blockMesh")
    errors = []
    for size in ("3", "6"):
        case.run("gmsh", "-3", "-format", "msh22", "-clmin", size, "-clmax", size, "rod.step",
                 "-o", "rod.msh")
        case.run("setMaterialPoints")
        m, c, inertia = results.massOf(results.tetrahedra(case.file("rod.msh")))
        M, C, I = results.massOfPoints(case.points("0", "rod"))
        table.row(f"part from CAD, {size} mm: mass", m, M, 1e-10, "relative")
        table.row(f"part from CAD, {size} mm: centre of mass [m]", 0, np.abs(C - c).max(), 1e-10)
        errors.append(np.abs(I - inertia).max()/np.trace(inertia))
    table.row("part from CAD: inertia, error of the coarser mesh of its trace", 0, errors[1], 1e-3)
    table.row("part from CAD: inertia, error falls by", 3, errors[1]/errors[0], 3, "atLeast")
    case.run("materialPointFoam")
    apart, way = results.turned(case, case.nearest(0.02, "lagrangian"))
    table.row("part from CAD, flight: distance from Euler's equations/way", 0, apart/way, 1e-3)
    p0, p1 = (results.motion(case, case.nearest(t, "lagrangian"))[0] for t in (0.01, 0.03))
    table.row("part from CAD, hit: momentum of both", 0,
              np.linalg.norm(p1 - p0)/np.linalg.norm(p0), 1e-12)


def ball(table, h=0.01, n=10, steps=100):
    """An elastic ball of 3 cells, elements of 0.8 cells, 5 cells along and across."""
    c = np.sqrt(1e6*0.7/(1.3*0.4)/1000)
    u = np.array((0.1, 0.065, -0.045))*c
    dt = 0.3*h/c
    sides = [a + s for a in "xyz" for s in "-+"]
    for kind, shape in ((None, "GIMP"), ("tets", "nodeDual")):
        case = FoamCase("gmshMeshes", f"ball-{shape}")
        case.write("constant/phaseProperties", {"phases": ["ball"], "ball": {
            "constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0.3}}})
        velocityFile(case, "ball", {"outside": "calculated"})
        noSchemes(case)
        case.write("system/fvSolution", {"materialPoints": {
            "shapeFunction": shape, "transfer": "FLIP"}})
        case.write("system/controlDict", controlDict(steps*dt, steps*dt, deltaT=dt))
        case.write("system/setMaterialPointsDict", {"regions": {"ball": {
            "phase": "ball", "type": "mesh", "file": "ball.msh", "scale": h,
            "pointsPerCell": 1, "velocity": u}}})
        with open(case.file("ball.geo"), "w") as f:
            f.write('SetFactory("OpenCASCADE"); Sphere(1) = {3, 4, 6, 1.5};\n'
                    "Mesh.CharacteristicLengthMin = 0.8; Mesh.CharacteristicLengthMax = 0.8;\n")
        case.run("gmsh", "-3", "ball.geo", "-o", "ball.msh")
        patches = {"outside": ("patch", sides)}
        if kind:
            boxOfCells(case, kind, (0,)*3, (n*h,)*3, (n,)*3, patches)
        else:
            case.write("system/blockMeshDict", boxMesh((0,)*3, (n*h,)*3, (n,)*3, patches))
            case.run("blockMesh")
        case.run("setMaterialPoints")
        case.run("materialPointFoam")
        first, last = case.points("0", "ball"), case.points(case.times()[-1], "ball")
        away = last.byId("x") - first.byId("x") - u*steps*dt
        label = f"ball from a mesh, {shape}"
        table.row(f"{label}: largest |u - u0|/|u0|", 0,
                  np.abs(last["U"] - u).max()/np.linalg.norm(u), 1e-12)
        table.row(f"{label}: place error/mesh size", 0, np.abs(away).max()/(n*h), 1e-12)
        table.row(f"{label}: way in cells", 3, np.linalg.norm(u)*steps*dt/h, 3, "atLeast")


def hourglassMesh(name):
    """Cells of 5 mm, no finer ones at the neck."""
    case = copyOf("hourglass", name)
    case.change("system/snappyHexMeshDict", r"levels  \(\(1 1\)\);", "levels  ((0 0));")
    case.change("system/snappyHexMeshDict", r"level       \(0 1\);", "level       (0 0);")
    for command in (("blockMesh",), ("snappyHexMesh", "-overwrite"), ("extrudeMesh",)):
        case.run(*command)
    for side in ("front", "back"):
        case.run("foamDictionary", "-entry", f"entry0.{side}.type", "-set", "empty",
                 "constant/polyMesh/boundary")
    return case


def hourglass(table):
    results, = tutorial("hourglass", "results")
    case = hourglassMesh("hourglass")
    case.change("system/controlDict", r"^endTime .*", "endTime 0.45;")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=200)
    start, end = (case.points(t, "sand") for t in ("0", case.times("lagrangian")[-1]))
    table.row("hourglass: points at the end", len(start["m"]), len(end["m"]), 0)
    table.row("hourglass: mass of the sand", start["m"].sum(), end["m"].sum(), 1e-12, "relative")
    rate, apart = results.flow(*results.above(case))
    table.row("hourglass: sand above the neck less a constant rate/sand", 0, apart, 0.02)
    print(f"hourglass: C {results.coefficient(rate, results.opening(case)):.2f}")


def kept(table):
    """Sand falls on the floor of the same mesh and spreads to the wall: points that pass them
    are put back, also by two processors."""
    cases = []
    for ranks in (1, 2):
        case = hourglassMesh(f"kept-{ranks}")
        case.change("system/setMaterialPointsDict", r"min  .*", "min (-1 -0.175 -1);")
        case.change("system/setMaterialPointsDict", r"max  .*", "max (0.04 -0.12 1);"
                    " velocity (1 -2 0);")
        case.change("system/controlDict", r"^endTime .*", "endTime 0.03; reportInterval 1;")
        case.change("system/controlDict", r"^writeInterval .*", "writeInterval 0.03;")
        case.run("setMaterialPoints")
        if ranks > 1:
            case.decompose((1, 2, 1))
            case.runParallel(limit=200)
        else:
            case.run("materialPointFoam", limit=200)
        cases.append(case)
    found = [case.numbers("^Put back on walls since the last report: N") for case in cases]
    table.check("sand on a floor: points are put back", found[0].sum() > 0, found[0].sum())
    table.row("sand on a floor: points put back by 2 processors", found[0].sum(),
              found[1].sum(), 0)
    table.row("sand on a floor, 1 against 2 processors: points", 0, cases[0].largestDifference(
        cases[1], "0.03", ["sand"], ("x", "U", "sigma", "V")), 1e-10, "atMost")


def pendulum(table):
    halfPipe.halfPipe(table, mesh)


def still(table):
    pond.pond(table, mesh)


if __name__ == "__main__":
    if not shutil.which("gmsh"):
        sys.exit("gmsh is missing: etc/installOpenFOAM -packages")
    sys.exit(runParts("gmshMeshes", kirsch, spall, bracket, pipe, spheres, cylinder, rod,
                      ball, hourglass, kept, pendulum, still))
