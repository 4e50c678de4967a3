#!/usr/bin/env python3
"""The function object materialPointVTK, read with VTK's own readers.

serial      plates in air: at all written times position, id and columns of the points and all
            fields on cells equal the run's files, bit by bit; volume of the mesh; ascii; the files of
            the times are the same bits as without the function object; -postProcess
parallel    2 processors, one of them without points, and cells that move between them: one
            piece for each, points and volumes; the same on 3, one of which has no cell
restart     the series of a run that goes on from half time, and from an earlier one
meshes      cell volumes of a wedge, of boxes refined 2:1, of prisms, tetrahedra and polyhedra
            with points, and points in them; types of the cells; 1D to 3D
gasAlone    a gas on polyhedra and in 1D; points alone without a mesh
times       writeControl: points by its own times, the mesh at the run's
wrong       entries that are wrong end with a message that names the valid ones
cost        MPM_VERIFY=1: seconds of a core for 1e5 points, and over the run's own write
"""

import os
import re
import shutil
import sys
import xml.etree.ElementTree as xml

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from cellMesh import boxOfCells
from foamCase import (VERIFY, FoamCase, boxMesh, controlDict, noSchemes, readInternal, runParts,
                      velocityFile)
from gasCases import gasCase
from gasOnCells import gasOnCells
from killedRuns import sameBits
from plates import plateCase
from wedge import wedgeConditions, wedgeMesh

GROUP = "materialPointVTK"
END = 2.5e-7
NUMERICS = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}
LAW = {"type": "linearElastic", "rho": 1000, "E": 1e9, "nu": 0.3}
VTK_ORDER = [0, 3, 5, 1, 4, 2]      # of xx xy xz yy yz zz
COLUMNS = ("x", "id", "U", "m", "sigma", "damage")
TETRA, HEXAHEDRON, WEDGE, POLYHEDRON = 10, 12, 13, 42


# --- files -------------------------------------------------------------------

def vtk(**entries):
    return {"vtk": {"type": "materialPointVTK", "libs": "(mpmFunctionObjects)", **entries}}


def functions(case, **entries):
    """Put the function object into a case that has none."""
    text = " ".join(f"{k} {v};" for k, v in vtk(**entries)["vtk"].items())
    case.change("system/controlDict", r"(?s)^functions.*", f"functions {{ vtk {{ {text} }} }}\n")


def series(case, name):
    """{name of the time: path} of a .pvd file."""
    folder = case.file("postProcessing/vtk")
    sets = xml.parse(os.path.join(folder, name + ".pvd")).getroot().iter("DataSet")
    return {s.get("timestep"): os.path.join(folder, s.get("file")) for s in sets}


def load(path):
    """The data of a file, of all its pieces; arrays of points and cells by their names."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules import vtkIOXML

    kind = os.path.splitext(path)[1]
    reader = {".vtp": vtkIOXML.vtkXMLPolyDataReader,
              ".pvtp": vtkIOXML.vtkXMLPPolyDataReader,
              ".vtu": vtkIOXML.vtkXMLUnstructuredGridReader,
              ".pvtu": vtkIOXML.vtkXMLPUnstructuredGridReader}[kind]()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    arrays = []
    for values in (data.GetPointData(), data.GetCellData()):
        arrays.append({values.GetArrayName(i): np.copy(vtk_to_numpy(values.GetArray(i)))
                       for i in range(values.GetNumberOfArrays())})
    if data.GetNumberOfPoints():
        arrays[0]["x"] = np.copy(vtk_to_numpy(data.GetPoints().GetData()))
    return data, *arrays


def volumes(data):
    """Volumes of the cells as VTK computes them; of polyhedra, whose faces need not be
    plane, from the outward faces as OpenFOAM does."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

    sizes = vtkCellSizeFilter()
    sizes.SetInputData(data)
    sizes.Update()
    V = np.copy(vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume")))
    for i in range(len(V)):
        if data.GetCellType(i) == POLYHEDRON:
            faces = [np.copy(vtk_to_numpy(data.GetCell(i).GetFace(f).GetPoints().GetData()))
                     for f in range(data.GetCell(i).GetNumberOfFaces())]
            V[i] = polyhedron(faces)
    return V


def polyhedron(faces):
    """Pyramids over the faces, which are fans of triangles around their mean point."""
    areas, centres = [], []
    for x in faces:
        mean, y = x.mean(axis=0), np.roll(x, -1, axis=0)
        a = np.cross(y - x, mean - x)/2
        size = np.linalg.norm(a, axis=1)
        areas.append(a.sum(axis=0))
        centres.append(size @ ((x + y + mean)/3)/size.sum())
    middle = np.mean(centres, axis=0)
    return sum(a @ (c - middle) for a, c in zip(areas, centres))/3


def types(data):
    return {data.GetCellType(i) for i in range(data.GetNumberOfCells())}


def pieces(path):
    return [p.get("Source") for p in xml.parse(path).getroot().iter("Piece")]


def wrongPoints(case, time, phase, columns, path, computed=3):
    """Columns of a file that are not the bits of the run's, by id; the number of points.
    Positions in the first directions: those of a plane are rounded anew on processors."""
    data, found, _ = load(path)
    points = case.points(time, phase)
    order, wrong = np.argsort(found["id"]), []
    for name in columns:
        expected = points.byId(name)
        if expected.ndim > 1 and expected.shape[1] == 6:
            expected = expected[:, VTK_ORDER]
        if name == "x":
            expected, found[name] = expected[:, :computed], found[name][:, :computed]
        if name not in found or not np.array_equal(found[name][order], expected):
            wrong.append(name)
    if data.GetNumberOfVerts() != data.GetNumberOfPoints():
        wrong.append("vertices")
    return wrong, data.GetNumberOfPoints()


def wrongFields(case, time, cells):
    """Fields of the time folder that are no arrays of the cells, or other bits; how many
    were compared."""
    wrong, n = [], 0
    for name in os.listdir(case.file(time)):
        path = case.file(time, name)
        if not os.path.isfile(path):
            continue
        with open(path, "rb") as f:
            if not re.search(rb"class\s+vol\w+Field;", f.read(2000)):
                continue
        expected, n = readInternal(path), n + 1
        if name in cells and np.size(expected) in (1, 3, 6, 9):     # uniform
            expected = np.broadcast_to(expected, cells[name].shape)
        if expected.ndim > 1 and expected.shape[1] == 6:
            expected = expected[:, VTK_ORDER]
        if name not in cells or not np.array_equal(cells[name], expected):
            wrong.append(name)
    return wrong, n


def plates(name, air=True, **entries):
    case = plateCase(GROUP, name, 10, NUMERICS, END, END/2, 0.4, strength=400e6,
                     air={} if air else None)
    functions(case, **entries)
    return case


def checkPoints(table, label, case, columns=COLUMNS, phases=("target", "flyer"), computed=3):
    """All times of the series of points against the run's files."""
    wrong, n = [], 0
    for phase in phases:
        for time, path in series(case, "points." + phase).items():
            # The start has no file of what is zero there
            there = [c for c in columns if c in case.points(time, phase)]
            bad, some = wrongPoints(case, time, phase, there, path, computed)
            wrong += [f"{phase} {time} {c}" for c in bad]
            n += some
    table.check(f"{label}: points of all times, the run's bits", not wrong and n > 0,
                " ".join(wrong) or f"{n} points")


# --- parts -------------------------------------------------------------------

def serial(table):
    case = plates("serial")
    case.run("materialPointFoam")
    without = plateCase(GROUP, "without", 10, NUMERICS, END, END/2, 0.4, strength=400e6, air={})
    without.run("materialPointFoam")
    times = case.times()
    for name in ("points.target", "points.flyer", "mesh"):
        found = list(series(case, name))
        table.check(f"serial: times of {name}.pvd", found == times and len(times) == 3, found)
    checkPoints(table, "serial", case)
    last = case.times()[-1]
    data, _, cells = load(series(case, "mesh")[last])
    wrong, n = wrongFields(case, last, cells)
    table.check("serial: fields on cells, the run's bits", not wrong and n > 8,
                " ".join(wrong) or f"{n} fields")
    table.check("serial: no array beside them", len(cells) == n, len(cells) - n)
    case.run("postProcess", "-func", "writeCellVolumes", "-time", "0")
    V = readInternal(case.file("0/V"))
    table.row("serial: volumes of the cells", 0, abs(volumes(data)/V - 1).max(), 1e-12)
    differ, n = sameBits(case, without, last, unlike=())
    table.check("serial: files of the run, with and without", not differ and n > 20,
                " ".join(differ) or f"{n} files")

    kept = {n: series(case, n) for n in ("points.target", "mesh")}
    bits = {p: open(p, "rb").read() for n in kept for p in kept[n].values()}
    for path in bits:
        os.remove(path)
    os.remove(case.file("postProcessing/vtk/mesh.pvd"))
    case.run("materialPointFoam", "-postProcess", "-time", "1e-7:1")
    again = {n: series(case, n) for n in kept}
    table.check("-postProcess: keeps the series, makes a new one",
                again["points.target"] == kept["points.target"]
                and list(again["mesh"]) == times[1:], list(again["mesh"]))
    differ = [p for p in again["mesh"].values() if open(p, "rb").read() != bits[p]]
    table.check("-postProcess: the mesh is the same bits", not differ, " ".join(differ))
    _, found, _ = load(again["points.target"][last])
    points = case.points(last, "target")
    table.check("-postProcess: positions of the points",
                np.array_equal(found["x"][np.argsort(found["id"])], points.byId("x")))


    # Fields come from the files, whatever their format is
    text = plates("ascii")
    text.change("system/controlDict", "^writeFormat.*", "writeFormat ascii;")
    text.change("system/controlDict", "^writeCompression.*", "writeCompression on;")
    text.run("materialPointFoam")
    _, _, found = load(series(text, "mesh")[last])
    table.check("ascii, compressed: the files are", os.path.isfile(text.file(last, "p.gz")))
    table.row("ascii, compressed: fields on cells", 0, max(
        abs(found[name] - cells[name]).max()/max(abs(cells[name]).max(), 1e-300)
        for name in cells), 1e-12)


def onPieces(name, split, balance=False, emptyToo=False):
    """The plates on processors, run; emptyToo: the last one without cells."""
    case = plates(name, columns="(U m sigma damage displacement)")
    case.decompose(split)
    if emptyToo:
        n, nCells = int(np.prod(split)), case.nCells()
        with open(case.file("constant/cells"), "w") as f:
            f.write("FoamFile { version 2.0; format ascii; class labelList; object cells; }\n"
                    f"{nCells}\n(\n" + "\n".join(str(n*i//nCells) for i in range(nCells)) + "\n)\n")
        case.write("system/decomposeParDict", {
            "numberOfSubdomains": n + 1, "method": "manual", "manualCoeffs": {"dataFile": '"cells"'}})
        case.run("decomposePar", "-force")
    if balance:
        case.change("system/decomposeParDict", r"\Z", (
            "\nloadBalance { interval 3; maxImbalance 1; worth 0; method random; }\n"))
    case.runParallel()
    return case


def parallel(table):
    for label, n, case in (
            ("2 processors", 2, onPieces("two", (1, 2, 1))),
            ("3, cells that move", 3, onPieces("moved", (1, 3, 1), balance=True)),
            ("3, one without cells", 3, onPieces("empty", (1, 2, 1), emptyToo=True))):
        last = list(series(case, "mesh"))[-1]
        table.row(f"{label}: time of the last files", END, float(last), 1e-15)
        sizes = {}
        for name in ("points.target", "points.flyer", "mesh"):
            path = series(case, name)[last]
            sizes[name] = [load(os.path.join(os.path.dirname(path), p))[0].GetNumberOfCells()
                           for p in pieces(path)]
            table.check(f"{label}: pieces of {name}", len(sizes[name]) == n, sizes[name])
        if "move" in label:
            table.check(f"{label}: cells have moved", len(re.findall("^Load: ", case.log(), re.M)) > 3)
        else:
            table.check(f"{label}: a piece has no point of the flyer",
                        min(sizes["points.flyer"]) == 0 < max(sizes["points.flyer"]))
        if "without" in label:
            table.check(f"{label}: a piece has no cell", min(sizes["mesh"]) == 0)

        checkPoints(table, label, case, computed=2)
        _, found, _ = load(series(case, "points.target")[last])
        moved = case.points(last, "target").byId("x") - case.points("0", "target").byId("x")
        table.check(f"{label}: displacements", np.array_equal(
            found["displacement"][np.argsort(found["id"])][:, :2], moved[:, :2])
            and abs(moved).max() > 0, abs(moved).max())

        path = series(case, "mesh")[last]
        sides = np.prod([edges[-1] - edges[0] for edges in case.edges()[:3]])
        table.row(f"{label}: volume of the mesh", sides, volumes(load(path)[0]).sum(),
                  1e-12, "relative")
        wrong, some = [], 0
        for piece, folder in zip(pieces(path), case.processors()):
            data, _, cells = load(os.path.join(os.path.dirname(path), piece))
            if data.GetNumberOfCells():
                bad, k = wrongFields(case, os.path.join(folder, last), cells)
                wrong += [f"{piece} {name}" for name in bad]
                some += k
        table.check(f"{label}: fields on cells, the run's bits", not wrong and some > 16,
                    " ".join(wrong) or f"{some} fields")


def restart(table):
    """In the end the series is that of the last run from its start on."""
    case = plates("restart")
    case.change("system/controlDict", "^startFrom.*", "startFrom latestTime;")
    case.change("system/controlDict", "^writeInterval.*", f"writeInterval {END/5!r};")
    straight = plates("restart-straight")
    shutil.copy(case.file("system/controlDict"), straight.file("system/controlDict"))
    straight.run("materialPointFoam")
    whole = list(series(straight, "mesh"))
    case.change("system/controlDict", "^endTime.*", f"endTime {END*3/5!r};")
    case.run("materialPointFoam")
    half = list(series(case, "mesh"))
    case.change("system/controlDict", "^endTime.*", f"endTime {END!r};")
    case.run("materialPointFoam")
    table.check("restart: series of the first run", half == whole[:4] and len(half) == 4, half)
    for name in ("points.target", "points.flyer", "mesh"):
        found, expected = series(case, name), series(straight, name)
        table.check(f"restart: times of {name}, of one run", list(found) == whole, list(found))
        differ = [t for t in found
                  if open(found[t], "rb").read() != open(expected.get(t, ""), "rb").read()]
        table.check(f"restart: files of {name}, the bits of one run", not differ, " ".join(differ))

    # From the second time on, with fewer times: those after it are another run's
    for time in whole[2:]:
        shutil.rmtree(case.file(time))
    case.change("system/controlDict", "^writeInterval.*", f"writeInterval {END*2!r};")
    case.run("materialPointFoam")
    for name in ("points.target", "mesh"):
        found = list(series(case, name))
        table.check(f"restart: times after an earlier start go, of {name}",
                    found == [*whole[:2], whole[-1]], found)


def filled(name, patches, conditions, makeMesh):
    """A mesh with points in all cells, run for two steps."""
    case = FoamCase(GROUP, name)
    case.write("constant/phaseProperties",
               {"phases": ["body"], "body": {"constitutiveModel": LAW}})
    velocityFile(case, "body", conditions)
    case.write("system/setMaterialPointsDict", {"regions": {"body": {
        "phase": "body", "type": "cells", "pointsPerCell": 2, "velocity": (1, 0, 0)}}})
    case.write("system/fvSolution", {"materialPoints": {"transfer": "FLIP"}})
    noSchemes(case)
    case.write("system/controlDict", controlDict(2e-7, 2e-7, deltaT=1e-7, functions=vtk()))
    makeMesh(case, patches)
    case.run("setMaterialPoints")
    case.run("materialPointFoam")
    return case


def meshes(table):
    box = (0, 0, 0), (1, 0.8, 0.6), (5, 4, 3)
    walls = {"walls": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}

    def cells(kind):
        def make(case, patches):
            boxOfCells(case, "tets" if kind == "polyhedra" else
                       "hexes" if kind == "refined" else kind, *box, patches, moved=0)
            if kind == "polyhedra":
                case.run("polyDualMesh", "60", "-overwrite")
            if kind == "refined":
                case.write("system/topoSetDict", {"actions": [
                    "{ name fine; type cellSet; action new; source boxToCell; sourceInfo"
                    " { box (0.3 0.1 0.1) (9 9 0.5); } }"]})
                case.run("topoSet")
                case.run("refineHexMesh", "fine", "-overwrite")
        return make

    def blocks(n):
        def make(case, patches):
            case.write("system/blockMeshDict", boxMesh(*box[:2], n, patches))
            case.run("blockMesh")
        return make

    def sector(case, patches):
        case.write("system/blockMeshDict", wedgeMesh((0, 0), (1, 0.5), (8, 5), patches))
        case.run("blockMesh")

    flat = {"walls": ("patch", ("x-", "x+", "y-", "y+")), "sides": ("empty", ("z-", "z+"))}
    line = {"walls": ("patch", ("x-", "x+")), "sides": ("empty", ("y-", "y+", "z-", "z+"))}
    whole = {"walls": "slip"}
    for kind, patches, conditions, make, expected in (
            ("1D", line, {**whole, "sides": "empty"}, blocks((6, 1, 1)), {HEXAHEDRON}),
            ("2D", flat, {**whole, "sides": "empty"}, blocks((6, 5, 1)), {HEXAHEDRON}),
            ("3D", walls, whole, blocks((6, 5, 4)), {HEXAHEDRON}),
            ("wedge", {"left": ("patch", "x-"), "right": ("patch", "x+"), "outer": ("patch", "r+")},
             wedgeConditions({"left": "slip", "right": "slip", "outer": "slip"}), sector,
             {HEXAHEDRON, WEDGE}),
            ("prisms", walls, whole, cells("prisms"), {WEDGE}),
            ("tets", walls, whole, cells("tets"), {TETRA}),
            ("refined", walls, whole, cells("refined"), {HEXAHEDRON, POLYHEDRON}),
            ("polyhedra", walls, whole, cells("polyhedra"), {POLYHEDRON})):
        case = filled(kind, patches, conditions, make)
        last = case.times()[-1]
        data, _, arrays = load(series(case, "mesh")[last])
        table.check(f"{kind}: types of the cells", types(data) == expected, types(data))
        case.run("postProcess", "-func", "writeCellVolumes", "-time", "0")
        V = np.broadcast_to(readInternal(case.file("0/V")), data.GetNumberOfCells())
        table.row(f"{kind}: volumes of the cells", 0, abs(volumes(data)/V - 1).max(), 1e-10)
        wrong, n = wrongFields(case, last, arrays)
        table.check(f"{kind}: fields on cells, the run's bits", not wrong and n > 2, wrong or n)
        checkPoints(table, kind, case, COLUMNS[:-1], ("body",))


def gasAlone(table):
    def wave(C, t):
        p = 1 + 0.01*np.sin(2*np.pi*C[:, 0])
        return np.ones(len(p)), np.zeros((len(p), 3)), p

    walls = {"walls": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}
    case, _, V = gasOnCells(GROUP, "gas-polyhedra", "polyhedra", (4, 3, 3), (1, 0.75, 0.75), walls,
                            {"walls": ("zeroGradient", "zeroGradient", "slip")}, wave, 0.02,
                            moved=0, start=functions)
    tube = gasCase(GROUP, "gas-1D", (40, 1, 1), (1, 0.1, 0.1),
                   lambda x, y, z: (1 + 0*x, 0*x, 1 + 0.1*np.sin(x)), 0.02)
    functions(tube)
    tube.run("materialPointFoam")
    for label, one, exact in (("gas on polyhedra", case, V), ("gas in 1D", tube, 0.01/40)):
        last = one.times()[-1]
        data, _, cells = load(series(one, "mesh")[last])
        wrong, n = wrongFields(one, last, cells)
        table.check(f"{label}: fields on cells, the run's bits", not wrong and n > 3, wrong or n)
        table.check(f"{label}: p varies", np.ptp(cells["p"]) > 1e-3, np.ptp(cells["p"]))
        table.row(f"{label}: volumes of the cells", 0, abs(volumes(data)/exact - 1).max(), 1e-10)
        table.check(f"{label}: no files of points", not any(
            f.startswith("points") for f in os.listdir(one.file("postProcessing/vtk"))))

    alone = plates("points-alone", air=False, fields="()", columns="(U_y sigmaEq)",
                   phases="(flyer)")
    alone.run("materialPointFoam")
    found = sorted(os.listdir(alone.file("postProcessing/vtk")))
    table.check("points alone: files", found == ["points.flyer", "points.flyer.pvd"], found)
    last = alone.times()[-1]
    _, arrays, _ = load(series(alone, "points.flyer")[last])
    points, order = alone.points(last, "flyer"), np.argsort(arrays["id"])
    table.check("points alone: columns that were asked for",
                set(arrays) == {"x", "id", "U_y", "sigmaEq"}
                and np.array_equal(arrays["U_y"][order], points.byId("U")[:, 1])
                and np.array_equal(arrays["sigmaEq"][order], points.byId("sigmaEq")),
                " ".join(sorted(arrays)))

    some = plates("points-some", air=False, fields="()", columns="(U damage)")
    some.change("constant/phaseProperties",
                r"(?s)(\n\s*flyer\s*\{.*?)failureModel\s*\{[^}]*\}", r"\1")
    some.run("materialPointFoam")
    found = {p: set(load(series(some, f"points.{p}")[some.times()[-1]])[1])
             for p in ("target", "flyer")}
    table.check("a column that one phase has: left out of the other",
                found == {"target": {"x", "id", "U", "damage"}, "flyer": {"x", "id", "U"}}, found)


def times(table):
    case = plates("times", writeControl="timeStep", writeInterval=3, fields='(p "alpha.*")')
    case.run("materialPointFoam")
    steps, written = case.nSteps(), case.times()
    points, mesh = list(series(case, "points.target")), series(case, "mesh")
    table.check("writeControl timeStep: points of each third step and the start",
                len(points) == steps//3 + 1 > len(written), f"{len(points)} of {steps}")
    table.check("writeControl timeStep: the mesh at times of both",
                list(mesh) == [t for t in points if t in written], list(mesh))
    chosen = plates("chosen", fields='(p "alpha.*")')
    chosen.run("materialPointFoam")
    data, _, cells = load(series(chosen, "mesh")[chosen.times()[-1]])
    table.check("fields that were asked for", set(cells) == {"p", "alpha.target", "alpha.flyer"},
                " ".join(sorted(cells)))
    table.check("no point data but what was asked for", data.GetPointData().GetNumberOfArrays() == 0)


def wrong(table):
    for label, entries, words, air in (
            ("phase", {"phases": "(target flier)"}, ("flier", "flyer"), True),
            ("no phase", {"phases": "()"}, ("empty", "flyer"), True),
            ("column", {"columns": "(U sygma)"}, ("sygma", "sigmaEq"), True),
            ("column twice", {"columns": "(U m U)"}, ("U", "twice"), True),
            ("column of a number", {"columns": "7"}, ("columns",), True),
            ("field", {"fields": "(p rho.aer)"}, ("rho.aer", "rho.air", "alpha.target"), True),
            ("keyword", {"column": "(U)"}, ("column", "columns", "fields"), True),
            ("type", {"type": "materialPointsVTK"}, ("materialPointVTK",), True)):
        case = plates("wrong-" + label.replace(" ", "-"), **entries)
        case.run("materialPointFoam", fails=True)
        text = case.log()
        error = text[text.find("FATAL IO ERROR"):] if "FATAL IO ERROR" in text else ""
        table.check(f"wrong {label}: one message with the file and the valid ones",
                    all(re.search(rf"\b{re.escape(w)}", error) for w in words)
                    and "system/controlDict" in error and text.count("FATAL") == 1,
                    " ".join(error.split())[:120])
    tube = gasCase(GROUP, "wrong-gas", (10, 1, 1), (1, 0.1, 0.1),
                   lambda x, y, z: (1 + 0*x, 0*x, 1 + 0*x), 0.02)
    functions(tube, columns="(U)")
    tube.run("materialPointFoam", fails=True)
    table.check("columns without points: a message", re.search(
        r"FATAL IO ERROR.*no material points.*columns", tube.log(), re.S))


def cost(table):
    if not VERIFY:
        return
    n, steps, dt = 25, 40, 1e-7
    boxes = {"walls": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}

    def mesh(case, patches):
        case.write("system/blockMeshDict", boxMesh((0, 0, 0), (1, 1, 1), (n,)*3, patches))
        case.run("blockMesh")

    case = filled("cost", boxes, {"walls": "slip"}, mesh)
    per = 1e5/(8*n**3)/steps

    def seconds(interval, **entries):
        """Fewest of three runs."""
        case.write("system/controlDict", controlDict(
            steps*dt, interval, deltaT=dt, functions=vtk(**entries) if entries else None))
        some = []
        for _ in range(3):
            for time in case.times()[1:]:
                shutil.rmtree(case.file(time))
            some.append(case.run("materialPointFoam"))
        return min(some)

    none = seconds(1)
    points = seconds(1, fields="()", writeControl="timeStep", writeInterval=1) - none
    path = list(series(case, "points.body").values())[-1]
    own = seconds(dt) - none
    table.row("cost: seconds of a core for a file of 1e5 points", 0.1, points*per, 0.1, "atMost")
    table.row("cost: seconds of the run's own write of 1e5 points", 1, own*per, 1, "atMost")
    table.row("cost: bytes for a point with U m sigma", 116, os.path.getsize(path)/(8*n**3), 1)
    table.row("cost: share of the run's own write", 0.5, points/own, 0.5, "atMost")


def main():
    return runParts(GROUP, serial, parallel, restart, meshes, gasAlone, times, wrong, cost)


if __name__ == "__main__":
    sys.exit(main())
