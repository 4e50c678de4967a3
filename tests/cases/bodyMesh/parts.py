"""pointsPerCell 3 and more in cells and elements that are no hexahedra (simplexParts).

Volume and centroid of the points of every cell against those of the cell by its
faces' triangles (the divergence theorem), their number against the table of the
guide; half-sizes are those of cubes of their size.
"""

import numpy as np

from cellMesh import boxOfCells, writePolyMesh
from foamCase import FoamCase, controlDict, noSchemes, velocityFile
from mshFiles import KINDS, whole, writeMsh
from wedge import ALPHA, SECTOR, wedgeConditions

RHO = 1000.0


def sector(x):
    """A box whose z is 0 or 1 becomes a sector about x."""
    side = np.where(x[:, 2] > 0, 1, -1)
    return np.column_stack((x[:, 0], x[:, 1], side*x[:, 1]*np.tan(ALPHA)))


def count(faces, flat, n):
    """Parts of a cell: the table of the guide."""
    if flat:
        edges = len(next(f for f in faces if sum(len(set(f) & set(g)) > 1 for g in faces)
                         == len(faces) - 1))
        return (n - 1)**2 if edges == 3 else edges*(n//2)**2
    if len(faces) == 4:
        return (n - 1)**3
    return sum(len(f) - 2 for f in faces)*(n//2)**3


def bare(name, conditions=None):
    case = FoamCase("bodyMesh", name)
    case.write("constant/phaseProperties", {
        "phases": ["body"], "body": {"type": "rigid", "rho": RHO}})
    velocityFile(case, "body", conditions or {"outside": "calculated"})
    case.write("system/fvSolution", {"materialPoints": {"transfer": "FLIP"}})
    noSchemes(case)
    case.write("system/controlDict", controlDict(1, 1, deltaT=1))
    return case


def fill(case, n, **region):
    case.write("system/setMaterialPointsDict", {"regions": {"body": {
        "phase": "body", "type": "cells", "pointsPerCell": n, **region}}})
    case.run("setMaterialPoints")
    return case.points("0", "body")


def polyMesh(case):
    """Points and the outward faces of each cell of constant/polyMesh (ASCII)."""
    def rows(name):
        with open(case.file("constant", "polyMesh", name)) as f:
            text = f.read()
        text = text[text.index("}", text.index("FoamFile")) + 1:]
        inside = text[text.index("(") + 1:text.rindex(")")]
        return inside.replace(")", "").split("\n")

    x = np.array([[float(v) for v in r.strip().lstrip("(").split()]
                  for r in rows("points") if r.strip()])
    faces = [[int(v) for v in r[r.index("(") + 1:].split()]
             for r in rows("faces") if r.strip()]
    owner, neighbour = ([int(v) for v in " ".join(rows(n)).split()]
                        for n in ("owner", "neighbour"))
    cells = [[] for _ in range(max(owner + neighbour) + 1)]
    for i, f in enumerate(faces):
        cells[owner[i]].append(f)
        if i < len(neighbour):
            cells[neighbour[i]].append(f[:1] + f[:0:-1])
    return x, cells


def cellMoments(x, faces):
    """Volume and centroid of a cell whose faces are triangles of their first point."""
    O = np.mean([x[p] for f in faces for p in f], axis=0)
    V, first = 0.0, np.zeros(3)
    for f in faces:
        for a, b in zip(f[1:], f[2:]):
            v = np.linalg.det((x[f[0]] - O, x[a] - O, x[b] - O))/6
            V += v
            first += v*(O + x[f[0]] + x[a] + x[b])/4
    return V, first/V


def pyramids(case, n, moved):
    """n^3 cubes of 1 with moved inner points, each six pyramids on its (warped) sides."""
    at = lambda i, j, k: i + (n + 1)*(j + (n + 1)*k)
    grid = np.stack(np.meshgrid(*[np.arange(n + 1.0)]*3, indexing="ij"), -1)
    grid = grid.transpose(2, 1, 0, 3).reshape(-1, 3)
    shift = np.random.default_rng(2).uniform(-moved, moved, grid.shape)
    shift[(grid == 0) | (grid == n)] = 0
    points, cells = list(grid + shift), []
    for i, j, k in np.ndindex(n, n, n):
        c = [at(i + a, j + b, k + d) for d in (0, 1) for a, b in
             ((0, 0), (1, 0), (1, 1), (0, 1))]
        top = len(points)
        points.append(np.mean([points[p] for p in c], axis=0))
        for f in ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
                  (3, 0, 4, 7)):
            f = [c[p] for p in f]
            cells.append([f] + [(b, a, top) for a, b in zip(f, f[1:] + f[:1])])
    writePolyMesh(case, np.array(points), cells, lambda x: 0, [("outside", "patch")])


def pentagons(case):
    """Two pentagons and a triangle, one layer."""
    flat = [(0, 0), (2, 0), (2, 1), (1, 1.7), (0, 1), (3.4, 0.3), (3.1, 1.6), (2.4, 2.1)]
    points = np.array([(*p, z) for z in (0.0, 0.5) for p in flat])
    n, cells = len(flat), []
    for ring in ((0, 1, 2, 3, 4), (1, 5, 6, 7, 2), (2, 7, 3)):
        sides = [(a, b, b + n, a + n) for a, b in zip(ring, ring[1:] + ring[:1])]
        cells.append([ring[::-1], tuple(p + n for p in ring)] + sides)
    writePolyMesh(case, points, cells, lambda x: 0 if 0 < x[2] < 0.5 else 1,
                  [("outside", "patch"), ("sides", "empty")])


def meshes():
    """Name, case with its mesh, in 2D its thickness."""
    outside = {"outside": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}
    flat = {"outside": ("patch", ("x-", "x+", "y-", "y+")), "sides": ("empty", ("z-", "z+"))}
    plane = {"outside": "calculated", "sides": "empty"}
    for name in ("tets", "prisms", "pyramids", "polyhedra", "polygons", "triangles"):
        case = bare(f"parts-{name}", conditions=plane if name in ("polygons", "triangles")
                    else None)
        if name == "pyramids":
            pyramids(case, 2, 0.1)
        elif name == "polygons":
            pentagons(case)
        elif name == "triangles":
            boxOfCells(case, "prisms", (0, 0, 0), (3, 3, 0.5), (3, 3, 1), flat)
        else:
            boxOfCells(case, "tets" if name == "polyhedra" else name, (0, 0, 0), (3, 3, 3),
                       (3, 3, 3), outside)
        if name == "polyhedra":
            case.change("system/controlDict", "^writeFormat.*?;", "writeFormat ascii;")
            case.run("polyDualMesh", "60", "-overwrite")
            case.change("system/controlDict", "^writeFormat.*?;", "writeFormat binary;")
        yield name, case, 0.5 if name in ("polygons", "triangles") else None


def cellsInParts(table):
    for name, case, thickness in meshes():
        x, cells = polyMesh(case)
        V, C = zip(*(cellMoments(x, faces) for faces in cells))
        d = 2 if thickness else 3
        for n in (3, 4):
            points = fill(case, n)
            m, l = points["m"]/RHO, points["halfSize"][:, :d]
            parts = [count(faces, thickness, n) for faces in cells]
            label = f"{name}, pointsPerCell {n}"
            table.row(f"{label}: points", sum(parts), len(m), 0)
            # Points are in the order of cells
            own = np.split(np.arange(len(m)), np.cumsum(parts)[:-1])
            if name != "polyhedra":
                table.row(f"{label}: volume of each cell", 0,
                          max(abs(m[i].sum()/v - 1) for i, v in zip(own, V)), 1e-12)
                table.row(f"{label}: centroid of each cell over its width", 0, max(
                    np.abs(m[i]@points["x"][i]/v - c).max()/v**(1/3)
                    for i, v, c in zip(own, V, C)), 1e-12)
            else:
                # Some of their warped faces are cut from another point than the first
                table.row(f"{label}: volume of the box", 27, m.sum(), 1e-12, "relative")
                table.row(f"{label}: centroid of the box", 0,
                          np.abs(m@points["x"]/27 - 1.5).max(), 1e-12)
            size = (m/(thickness or 1))**(1/d)
            table.row(f"{label}: half-sizes of cubes (squares)", 0,
                      np.abs(2*l/size[:, None] - 1).max(), 1e-12)
            print(label, "parts of a cell", min(parts), "to", max(parts), flush=True)


def cutParts(table):
    """A sphere in polyhedra and in triangles (a disc)."""
    outside = ("x-", "x+", "y-", "y+", "z-", "z+")
    sphere = {"type": "sphere", "centre": (0.1, 0, -0.05), "radius": 1}
    for kind in ("polyhedra", "triangles"):
        flat = kind == "triangles"
        case = bare(f"parts-cut-{kind}", conditions={"outside": "calculated", **(
            {"sides": "empty"} if flat else {})})
        boxOfCells(case, "prisms" if flat else "tets", (-1.2, -1.2, -1.2), (1.2,)*3,
                   (8, 8, 1 if flat else 8),
                   {"outside": ("patch", outside[:4 if flat else 6]),
                    **({"sides": ("empty", outside[4:])} if flat else {})})
        if not flat:
            case.run("polyDualMesh", "60", "-overwrite")
        points = fill(case, 3, **sphere)
        m, x = points["m"]/RHO, points["x"]
        label = f"sphere in {kind}, pointsPerCell 3"
        table.row(f"{label}: volume", 2.4*np.pi if flat else 4/3*np.pi, m.sum(), 0.003,
                  "relative")
        table.row(f"{label}: centre/width of a cell", 0, np.abs(
            m@x/m.sum() - sphere["centre"])[:2 if flat else 3].max()/0.3, 0.005)


def ringsInParts(table):
    """Rings of a wedge: of its cells (triangles), and of the elements of a mesh."""
    case = bare("parts-wedge", conditions=wedgeConditions(
        {p: "calculated" for p in ("left", "right", "outside")}))
    boxOfCells(case, "prisms", (0, 0, 0), (3, 2, 1), (6, 4, 1), {
        "front": ("wedge", ("z+",)), "back": ("wedge", ("z-",)), "axis": ("empty", ("y-",)),
        "left": ("patch", ("x-",)), "right": ("patch", ("x+",)),
        "outside": ("patch", ("y+",))}, place=sector)
    flat = np.array([(0.1, 0.1, 5), (1.1, 0.2, 5), (1.0, 1.2, 5), (0.2, 0.9, 5), (1.8, 0.7, 5)])
    elements = [("quad", [0, 1, 2, 3], [1]), ("triangle", [1, 4, 2], [2])]
    writeMsh(case.file("body.msh"), flat, elements, {})
    V, x, _ = whole(flat, elements)
    for n, k in ((3, 1), (4, 2)):
        m = fill(case, n)["m"]/RHO
        table.row(f"wedge of triangles, pointsPerCell {n}: volume", SECTOR*3*2*1, m.sum(),
                  1e-12, "relative")
        m = fill(case, n, type="mesh", file="body.msh")["m"]/RHO
        table.row(f"elements in a wedge, pointsPerCell {n}: points", (n - 1)**2 + 4*k**2,
                  len(m), 0)
        table.row(f"elements in a wedge, pointsPerCell {n}: volume", SECTOR*V*x[1], m.sum(),
                  1e-12, "relative")


def elementsInParts(table):
    """Elements of a mesh; the volume with warped faces too (that of bilinear ones)."""
    random = np.random.default_rng(3)
    turn = np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]])
    for kind, simplices in (("tet", 1), ("hex", 24), ("prism", 14), ("pyramid", 8)):
        case = bare(f"parts-element-{kind}")
        boxOfCells(case, "hexes", (-2, -2, -2), (2, 2, 2), (5, 5, 5),
                   {"outside": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}, moved=0)
        for warp in (0, 0.08):
            corners = np.array(KINDS[kind][2])@turn
            corners = corners + random.uniform(-warp, warp, corners.shape)
            element = [(kind, list(range(len(corners))), [1])]
            writeMsh(case.file("body.msh"), corners, element, {})
            V, centre, _ = whole(corners, element)
            for n in (3, 4):
                points = fill(case, n, type="mesh", file="body.msh")
                m = points["m"]/RHO
                label = f"{kind} as an element{', warped'*(warp > 0)}, pointsPerCell {n}"
                table.row(f"{label}: volume", V, m.sum(), 1e-12, "relative")
                if not warp:
                    k = n - 1 if kind == "tet" else n//2
                    table.row(f"{label}: points", simplices*k**3, len(m), 0)
                    table.row(f"{label}: centre", 0, np.abs(m@points["x"]/V - centre).max(),
                              1e-12)


def refusedParts(table):
    case = bare("parts-refused")
    boxOfCells(case, "tets", (0, 0, 0), (1, 1, 1), (2, 2, 2),
               {"outside": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))})
    case.write("system/setMaterialPointsDict", {"regions": {"body": {
        "phase": "body", "type": "cells", "pointsPerCell": "(3 3 2)"}}})
    case.run("setMaterialPoints", fails=True)
    text = " ".join(case.log("setMaterialPoints").split())
    table.check("message: pointsPerCell (3 3 2) in tetrahedra",
                "FATAL" in text and "the same in all directions" in text)


PARTS = (cellsInParts, cutParts, ringsInParts, elementsInParts, refusedParts)
