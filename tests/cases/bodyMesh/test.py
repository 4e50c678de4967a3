#!/usr/bin/env python3
"""Bodies from meshes of their own: regions of type mesh.

formats    tetrahedra, hexahedra, prisms and pyramids in .msh 2.2 and 4.1, ASCII and
           binary, and .vtk: mass and centre of each element and each group against
           Gauss integrals; the same points from all of them
corners    a tetrahedron has points at 25/48, 23/144, a box 2 x 2 x 2; half-sizes end at the
           outside
plane      triangles and quadrilaterals in 2D and on a wedge (rings)
gmsh       sphere, torus, a STEP part, two materials made by gmsh: volume and centre 1e-10 of the mesh's,
           moments of inertia to second order in the size of elements
background the same body on boxes, tetrahedra and prisms
cut        a sphere and a box in tetrahedra and prisms, cut: volume 1e-10, centre
           0.5 % of a cell
parts      pointsPerCell 3 and 4 (parts.py): volume and centroid of each cell 1e-12
apart      points of elements, half a cell's box apart in tetrahedra, move as one body: no
           warning of numerical fracture; torn to four times the length: a warning
messages   what is wrong in a file or an entry
mutated    40 files with bytes changed, lines taken away or doubled: a message or points
"""

import os
import random
import shutil
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
sys.path.insert(0, HERE)
from cellMesh import boxOfCells
from foamCase import FoamCase, boxMesh, controlDict, noSchemes, runParts, velocityFile
import parts
from mshFiles import KINDS, moments, readMsh22, whole, writeMsh, writeVtk
from wedge import SECTOR, wedgeConditions, wedgeMesh

RHO = 1000.0


def build(name, phases, low, high, cells, dim=3, kind=None):
    """A case with its mesh: boxes, or tetrahedra and prisms (kind)."""
    case = FoamCase("bodyMesh", name)
    sides = [a + s for a in "xyz"[:dim] for s in "-+"]
    patches = {"outside": ("patch", sides)}
    if dim < 3:
        patches["sides"] = ("empty", [a + s for a in "xyz"[dim:] for s in "-+"])
    case.write("constant/phaseProperties", {
        "phases": phases, **{p: {"type": "rigid", "rho": RHO} for p in phases}})
    for p in phases:
        velocityFile(case, p, {k: "empty" if v[0] == "empty" else "calculated"
                               for k, v in patches.items()})
    case.write("system/fvSolution", {"materialPoints": {"shapeFunction": "GIMP",
                                                        "transfer": "FLIP"}})
    noSchemes(case)
    case.write("system/controlDict", controlDict(1, 1, deltaT=1))
    if kind:
        boxOfCells(case, kind, low, high, cells, patches)
    else:
        case.write("system/blockMeshDict", boxMesh(low, high, cells, patches))
        case.run("blockMesh")
    return case


def fill(case, regions):
    """Points of phases as regions say (entries beside those that are always the same)."""
    case.write("system/setMaterialPointsDict", {"regions": {
        n: {"phase": n, "type": "mesh", "pointsPerCell": 2, **r}
        for n, r in regions.items()}})
    case.run("setMaterialPoints")
    return [case.points("0", n) for n in regions]


def solids():
    """One element of each kind, apart from each other, in groups of two kinds: the pyramid
    in both, faces in none."""
    points, elements = [], []
    turn = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]])
    scale = np.array([[1, 0.2, 0], [0, 0.8, 0.1], [0.3, 0, 0.9]])
    for i, (kind, groups) in enumerate((("tet", [7]), ("hex", [7]), ("prism", [9]),
                                        ("pyramid", [7, 9]))):
        corners = np.array(KINDS[kind][2])@scale@turn.T + (2.5*i, 1.0, 1.5)
        elements.append((kind, list(range(len(points), len(points) + len(corners))), groups))
        points += corners.tolist()
    elements.append(("triangle", [0, 1, 2], [3]))
    elements.append(("line", [0, 1], []))
    return points, elements


NAMES = {(3, 7): "steel", (2, 3): "floor"}


def formats(table):
    points, elements = solids()
    solid = elements[:4]
    wanted = {g: whole(points, [e for e in solid if not g or g in e[2]]) for g in (0, 7, 9)}
    first = None
    for version, binary in (("2.2", False), ("2.2", True), ("4.1", False), ("4.1", True),
                            ("vtk", False)):
        label = f"{version}{' binary'*binary}"
        case = build("formats-" + label.replace(" ", "-"), ["all", "steel", "other"],
                     (-2, -2, -2), (11, 4, 4), (13, 6, 6))
        if version == "vtk":
            writeVtk(case.file("body.vtk"), points, elements)
            regions = {"all": {"file": "body.vtk"}}
        else:
            writeMsh(case.file("body.msh"), points, elements, NAMES, version, binary)
            regions = {"all": {"file": "body.msh", "overlap": "allow"},
                       "steel": {"file": "body.msh", "group": "steel", "overlap": "allow"},
                       "other": {"file": "body.msh", "group": 9, "pointsPerCell": 1}}
        clouds = fill(case, regions)
        for (name, cloud), group in zip(zip(regions, clouds), (0, 7, 9)):
            V, x, _ = wanted[group]
            m = cloud["m"]
            table.row(f"{label}: mass of {name}", RHO*V, m.sum(), 1e-13, "relative")
            table.row(f"{label}: centre of {name} [m]", 0,
                      np.abs(m@cloud["x"]/m.sum() - x).max(), 1e-13)
        cloud = clouds[0]
        if first is None:
            first = cloud
            table.row("points: corners of the elements", 4 + 8 + 6 + 5, len(cloud["m"]), 0)
        elif version == "vtk":
            table.row("vtk: points", len(first["m"]), len(cloud["m"]), 0)
        else:
            table.check(f"{label}: the same points",
                        all(np.array_equal(first.byId(c), cloud.byId(c))
                            for c in ("x", "m", "halfSize")))


def corners(table):
    case = build("corners", ["all"], (-2, -2, -2), (11, 4, 4), (13, 6, 6))
    tet = np.array([(0, 0, 0), (1.2, 0, 0.1), (0.2, 0.9, 0), (0.1, 0.3, 1.1)])
    box = np.array(KINDS["hex"][2])*(0.6, 0.8, 1.0) + (3, 0, 0)
    elements = [("tet", [0, 1, 2, 3], [1]), ("hex", list(range(4, 12)), [1])]
    writeMsh(case.file("body.msh"), np.concatenate((tet, box)), elements, {})
    cloud, = fill(case, {"all": {"file": "body.msh"}})
    x, l = cloud["x"], cloud["halfSize"]
    at = (np.ones((4, 4))*23 + np.eye(4)*52)/144
    found = x[x[:, 0] < 2]
    error = max(np.abs(found - y).max(axis=1).min() for y in at@tet)
    table.row("tetrahedron: points at 25/48, 23/144 [m]", 0, error, 1e-15)
    found, l = x[x[:, 0] > 2], l[x[:, 0] > 2]
    wanted = (np.array(KINDS["hex"][2])*0.5 + 0.25)*(0.6, 0.8, 1.0) + (3, 0, 0)
    error = max(np.abs(found - y).max(axis=1).min() for y in wanted)
    table.row("box: points at the centres of eighths [m]", 0, error, 1e-15)
    # Cubes of the same volume, but for the side that is nearest
    reach = np.abs(found - (3.3, 0.4, 0.5)) + l - np.array((0.3, 0.4, 0.5))
    table.row("box: half-sizes end at its nearest side [m]", 0, np.abs(reach.max(axis=1)).max(),
              1e-15)
    # Bilinear faces: the volume of the trilinear map
    warped = np.array(KINDS["hex"][2]) + np.random.default_rng(1).uniform(-0.2, 0.2, (8, 3))
    writeMsh(case.file("body.msh"), warped, [("hex", list(range(8)), [])], {})
    cloud, = fill(case, {"all": {"file": "body.msh"}})
    table.row("hexahedron with warped faces: volume of the trilinear map",
              moments("hex", warped[None])[0][0], cloud["m"].sum()/RHO, 1e-14, "relative")


def plane(table):
    flat = np.array([(0.1, 0.1, 5), (1.1, 0.2, 5), (1.0, 1.2, 5), (0.2, 0.9, 5), (1.8, 0.7, 5)])
    elements = [("quad", [0, 1, 2, 3], [1]), ("triangle", [1, 4, 2], [2]),
                ("line", [0, 1], [3])]
    V, x, xx = whole(flat, elements[:2])
    case = build("plane", ["body"], (0, 0, 0), (3, 3, 0.5), (6, 6, 1), dim=2)
    for n in (1, 2):
        writeMsh(case.file("body.msh"), flat, elements, {})
        cloud, = fill(case, {"body": {"file": "body.msh", "pointsPerCell": n}})
        m = cloud["m"]
        table.row(f"2D, pointsPerCell {n}: points", (2, 7)[n - 1], len(m), 0)
        table.row(f"2D, pointsPerCell {n}: mass", 0.5*V*RHO, m.sum(), 1e-14, "relative")
        table.row(f"2D, pointsPerCell {n}: centre [m]", 0,
                  np.abs((m@cloud["x"]/m.sum())[:2] - x).max(), 1e-14)
    case.write("system/blockMeshDict", wedgeMesh((0, 0), (3, 3), (6, 6), {
        "left": ("patch", "x-"), "right": ("patch", "x+"), "outside": ("patch", "r+")}))
    velocityFile(case, "body", wedgeConditions({p: "calculated" for p in (
        "left", "right", "outside")}))
    case.run("blockMesh")
    cloud, = fill(case, {"body": {"file": "body.msh"}})
    table.row("wedge: volume of the rings", SECTOR*V*x[1], cloud["m"].sum()/RHO, 1e-14,
              "relative")


GEO = {
    "sphere": "Sphere(1) = {0.1, 0.2, 0.3, 1}; s = %g;",
    "torus": "Torus(1) = {0.1, 0.2, 0.3, 0.8, 0.35}; s = %g;",
    "part": 'Merge "part.step"; s = %g;',
    "two": "Sphere(1) = {0, 0, 0, 1}; Box(2) = {-0.5, -0.5, -0.5, 1, 1, 1};"
           " BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }"
           " Physical Volume(\"core\") = {2}; Physical Volume(\"shell\") = {3}; s = %g;",
}


def gmsh(case, geo, size, *options):
    with open(case.file("body.geo"), "w") as f:
        f.write('SetFactory("OpenCASCADE");\n' + GEO[geo] % size
                + "\nMesh.CharacteristicLengthMin = s; Mesh.CharacteristicLengthMax = s;\n")
    case.run("gmsh", "-3", "body.geo", "-format", "msh22", "-o", "body22.msh", *options)
    case.run("gmsh", "-3", "body.geo", "-format", "msh41", "-o", "body.msh", *options)
    return readMsh22(case.file("body22.msh"), 3)


#: A plate with a boss and a hole, written as STEP by gmsh's OpenCASCADE and read again
STEP = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1.2, 0.8, 0.3};
Cylinder(2) = {0.3, 0.4, 0, 0, 0, 0.9, 0.25};
Cylinder(3) = {0.9, 0.4, -0.1, 0, 0, 1, 0.15};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
BooleanDifference(5) = { Volume{4}; Delete; }{ Volume{3}; Delete; };
Save "part.step";
"""


def stepPart(table):
    """A part from CAD."""
    case = build("step", ["body"], (-0.1, -0.1, -0.1), (1.3, 0.9, 1.0), (14, 10, 11))
    with open(case.file("part.geo"), "w") as f:
        f.write(STEP)
    case.run("gmsh", "-0", "part.geo", "-o", "unused.geo_unrolled")
    points, elements = gmsh(case, "part", 0.1)
    V, x, _ = whole(points, elements)
    cloud, = fill(case, {"body": {"file": "body.msh"}})
    m = cloud["m"]/RHO
    table.row("part from STEP: volume", V, m.sum(), 1e-10, "relative")
    table.row("part from STEP: centre [m]", 0, np.abs(m@cloud["x"]/m.sum() - x).max(), 1e-10)
    table.row("part from STEP: volume of the drawing", 0.288 + np.pi*(0.25**2*0.6 - 0.15**2*0.3),
              m.sum(), 0.02, "relative")


def gmshBodies(table):
    if not shutil.which("gmsh"):
        table.check("gmsh is installed (etc/installOpenFOAM -packages)", False)
        return
    stepPart(table)
    for geo, exact in (("sphere", 4/3*np.pi), ("torus", 2*np.pi**2*0.8*0.35**2)):
        errors = {1: [], 2: []}
        for size in (0.4, 0.2):
            case = build(f"gmsh-{geo}-{size:g}", ["body"], (-1.4, -1.2, -1), (1.6, 1.6, 1.6),
                         (15, 14, 13))
            points, elements = gmsh(case, geo, size)
            V, x, xx = whole(points, elements)
            for n in (1, 2):
                cloud, = fill(case, {"body": {"file": "body.msh", "pointsPerCell": n}})
                m, at = cloud["m"]/RHO, cloud["x"]
                label = f"{geo}, elements of {size}, pointsPerCell {n}"
                table.row(f"{label}: volume", V, m.sum(), 1e-10, "relative")
                table.row(f"{label}: centre [m]", 0, np.abs(m@at/m.sum() - x).max(), 1e-10)
                errors[n].append(np.abs(np.einsum("p,pi,pj", m, at, at) - xx).max()
                                 /np.trace(xx))
        for n in (1, 2):
            a, b = errors[n]
            table.row(f"{geo}, pointsPerCell {n}: inertia, error of the finer mesh", 0, b,
                      0.004 if n == 1 else 0.0015)
            table.row(f"{geo}, pointsPerCell {n}: inertia, error falls by", 3.0, a/b, 3.0,
                      "atLeast")
        table.row(f"{geo}: volume of the finer mesh below the exact one", 0, 1 - V/exact, 0.05)


def background(table):
    """Phases from groups, on several backgrounds, from both versions of gmsh's own files."""
    if not shutil.which("gmsh"):
        return
    sums = {}
    for kind in (None, "tets", "prisms", "hexes"):
        case = build(f"background-{kind}", ["core", "shell"], (-1.2,)*3, (1.2,)*3, (8,)*3,
                     kind=kind)
        points, elements = gmsh(case, "two", 0.3)
        for name in ("body.msh", "body22.msh"):
            clouds = fill(case, {g: {"file": name, "group": g} for g in ("core", "shell")})
            sums[kind, name] = np.array([(c["m"].sum(), *(c["m"]@c["x"])) for c in clouds])
            n = [len(c["m"]) for c in clouds]
        if kind is None:
            for i, group in enumerate((1, 2)):
                V, x, _ = whole(points, [e for e in elements if e[2] == [group]])
                table.row(f"group {('core', 'shell')[i]}: volume", V,
                          sums[kind, name][i, 0]/RHO, 1e-10, "relative")
                table.row(f"group {('core', 'shell')[i]}: points",
                          4*sum(e[2] == [group] for e in elements), n[i], 0)
    mass = sums[None, "body.msh"][:, 0].sum()
    table.row("all backgrounds and versions: mass and moments", 0,
              max(np.abs(s - sums[None, "body.msh"]).max() for s in sums.values())/mass, 1e-12)


def cut(table):
    """Shapes in cells that are no hexahedra: parts of the corners' regions."""
    sphere = {"type": "sphere", "centre": (0.1, 0, -0.05), "radius": 1}
    box = {"type": "box", "min": (-0.77, -0.6, -0.9), "max": (0.83, 0.71, 0.41)}
    for kind in ("tets", "prisms"):
        case = build("cut-" + kind, ["body"], (-1.2,)*3, (1.2,)*3, (8,)*3, kind=kind)
        for shape, V, centre, inertia in (
                (sphere, 4/3*np.pi, sphere["centre"], 4/15*np.pi*np.ones(3)),
                (box, 1.6*1.31*1.31, (0.03, 0.055, -0.245),
                 1.6*1.31*1.31/12*np.array((1.6, 1.31, 1.31))**2)):
            cloud, = fill(case, {"body": {**shape, "parts": "sampled"}})
            m0, x0 = cloud["m"]/RHO, cloud["x"]
            cloud, = fill(case, {"body": shape})
            m, x = cloud["m"]/RHO, cloud["x"]
            label = f"{shape['type']} in {kind}"
            table.row(f"{label}: volume", V, m.sum(), 1e-10, "relative")
            table.row(f"{label}: centre/width of a cell", 0,
                      np.abs(m@x/m.sum() - centre).max()/0.3, 0.005)
            table.row(f"{label}: moments of inertia", 0,
                      np.abs(m@(x - centre)**2/inertia - 1).max(), 0.02)
            far, near = (np.abs(w@y/w.sum() - centre).max() for w, y in ((m0, x0), (m, x)))
            table.row(f"{label}: error of the centre, whole points over cut ones", 4, far/near, 4,
                      "atLeast")


def apart(table):
    """Six tetrahedra in a box of 1 with points 0.5 apart: there are empty cells between
    neighbours from the start."""
    n = 6
    grid = np.indices((n + 1,)*3).reshape(3, -1).T
    at = lambda i, j, k: ((n + 1)*i + j)*(n + 1) + k
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
               (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    elements = [("hex", [at(*(np.array(e) + c)) for c in corners], [7])
                for e in np.ndindex(n, n, n)]
    for name, rate in (("moved", 0), ("torn", 300)):
        case = build(f"apart-{name}", ["body"], (0, 0, 0), (16, 5, 5), (16, 5, 5), kind="tets")
        case.write("constant/phaseProperties", {"phases": ["body"], "body": {
            "constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": 1e5, "nu": 0}}})
        case.write("system/fvSolution", {"materialPoints": {"shapeFunction": "nodeDual",
                                                            "transfer": "FLIP"}})
        case.write("system/controlDict", controlDict(0.01, 0.005, maxCo=0.4))
        writeMsh(case.file("body.msh"), 0.5*grid + 1.013, elements, NAMES, "2.2")
        fill(case, {"body": {"file": "body.msh", "pointsPerCell": 1, "velocity": {
            "uniform": (20, 3, 2), "x": f"table ((1 (0 0 0)) (4 ({3*rate} 0 0)))"}}})
        case.run("materialPointFoam", limit=60)
        table.check(f"{name}: {'a' if rate else 'no'} warning of numerical fracture",
                    ("Numerical fracture: of body" in case.log()) == bool(rate))
    table.check("the log names the cells", "nodes, tetrahedra" in case.log())


def messages(table):
    points, elements = solids()
    case = build("messages", ["all"], (-2, -2, -2), (11, 4, 4), (13, 6, 6))

    def refused(what, words, entries, change=None, dim=None):
        writeMsh(case.file("body.msh"), points, elements, NAMES, "2.2")
        with open(case.file("body.msh")) as f:
            text = f.read()
        if change:
            with open(case.file("body.msh"), "w") as f:
                f.write(change(text))
        case.write("system/setMaterialPointsDict", {"regions": {"all": {
            "phase": "all", "type": "mesh", "pointsPerCell": 2, "file": "body.msh", **entries}}})
        case.run("setMaterialPoints", fails=True)
        text = " ".join(case.log("setMaterialPoints").split())
        table.check(f"message: {what}",
                    "FATAL" in text and all(w in text for w in words)
                    and "printStack" not in text,
                    case.reason(case.file("log.setMaterialPoints"))[:200])

    refused("no such file", ["no such file", "none.msh"], {"file": "none.msh"})
    refused("a surface", ["type surface"], {"file": "body.stl"})
    refused("unknown group", ["group lead", "steel"], {"group": "lead"})
    refused("scale 0", ["scale"], {"scale": 0})
    refused("pointsPerCell (3 3 2)", ["pointsPerCell", "centroid"],
            {"pointsPerCell": "(3 3 2)"})
    refused("too large for the mesh", ["scale 1e-3", "body's mesh (file body.msh)"], {"scale": 1000})
    refused("version 1", ["version 1", "gmsh -save"], {},
            lambda t: t.replace("2.2 0 8", "1 0 8"))
    refused("no .msh", ["$MeshFormat"], {}, lambda t: "solid body\n" + t)
    refused("second order", ["gmsh -order 1"], {}, lambda t: t.replace("\n1 4 2 ", "\n1 11 2 "))
    refused("node that is not there", ["which is not there"], {},
            lambda t: t.replace("\n1 4 2 7 1 2 ", "\n1 4 2 7 1 3 "))
    refused("cut off", ["$Elements"], {}, lambda t: t[:-60])
    refused("folded", ["folded"], {}, lambda t: t.replace(
        "\n2 5 2 7 1 14 17 20 23", "\n2 5 2 7 1 14 20 17 23"))
    twice = build("messages-2D", ["all"], (0, 0, 0), (3, 3, 1), (3, 3, 1), dim=2)
    writeMsh(twice.file("body.msh"), points, elements, NAMES)
    twice.write("system/setMaterialPointsDict", {"regions": {"all": {
        "phase": "all", "type": "mesh", "pointsPerCell": 2, "file": "body.msh"}}})
    twice.run("setMaterialPoints", fails=True)
    table.check("message: a mesh in 3D for a case in 2D",
                "that of the case is 2D" in " ".join(twice.log("setMaterialPoints").split()))


def mutated(table, n=40):
    """No crash, whatever the file holds."""
    points, elements = solids()
    case = build("mutated", ["all"], (-2, -2, -2), (11, 4, 4), (13, 6, 6))
    case.write("system/setMaterialPointsDict", {"regions": {"all": {
        "phase": "all", "type": "mesh", "pointsPerCell": 2, "file": "body.msh"}}})
    rng = random.Random(1)
    bad, read = [], 0
    for i in range(n):
        writeMsh(case.file("body.msh"), points, elements, NAMES, ("2.2", "4.1")[i % 2],
                 bool(i//2 % 2))
        with open(case.file("body.msh"), "rb") as f:
            data = bytearray(f.read())
        for _ in range(rng.randint(1, 3)):
            at = rng.randrange(len(data))
            how = rng.randrange(4)
            if how == 0:
                data[at] = rng.randrange(256)
            elif how == 1:
                data[at:at + 1] = bytes(rng.choice(b"0123456789-e. \n") for _ in range(2))
            elif how == 2:
                lines = data.split(b"\n")
                k = rng.randrange(len(lines))
                lines[k:k + 1] = rng.choice(([], [lines[k]]*2))
                data = bytearray(b"\n".join(lines))
            else:
                del data[at:at + rng.randint(1, 40)]
            data = data or bytearray(b" ")
        with open(case.file("body.msh"), "wb") as f:
            f.write(data)
        try:
            case.run("setMaterialPoints", limit=20)
            read += 1
        except Exception as e:
            text = case.log("setMaterialPoints")
            if "FATAL" not in text or "printStack" in text or "did not end" in str(e):
                bad.append(i)
    table.check(f"{n} mutated files: a message or points, never a crash", not bad,
                f"{read} read, bad: {bad}")


if __name__ == "__main__":
    sys.exit(runParts("bodyMesh", formats, corners, plane, gmshBodies, background, cut,
                      apart, messages, mutated, *parts.PARTS))
