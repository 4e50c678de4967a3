#!/usr/bin/env python3
"""What other programs read of the points: foamToVTK and VTK's own reader.

A strip of the plates of tutorials/spall, 20 cells over the target, runs to 0.25 us,
once in binary and once in ascii. foamToVTK makes .vtp files of the clouds of the binary run; VTK
reads these, and its vtkOpenFOAMReader (that of ParaView without OpenFOAM) reads
the case itself. All must hold what the solver wrote in ascii with 16 digits: the
points, and the values of all columns to the precision of float32 that foamToVTK
writes (symmetric tensors in VTK's order xx yy zz xy yz xz).
"""

import glob
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import RunFailed
from plates import plateCase
from report import Report

TIME = 2.5e-7
PHASES = ("target", "flyer")
COMPONENTS = {"sigma": 6, "pPoint": 1, "sigmaEq": 1, "damage": 1, "V": 1, "m": 1, "U": 3}
VTK_ORDER = [0, 3, 5, 1, 4, 2]      # of xx xy xz yy yz zz

#: Half a unit in the last place of float32, and the rounding of small values
FLOAT32 = 1.2e-7


def makeCase(writeFormat):
    case = plateCase("foamToVTK", writeFormat, 10,
                     {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01},
                     TIME, TIME, 0.4, strength=400e6, writeFormat=writeFormat)
    case.run("materialPointFoam")
    return case


def difference(a, b):
    """Largest difference over the largest value."""
    if a.shape != b.shape:
        return np.inf
    return float(np.max(abs(a - b))/max(np.max(abs(b)), 1e-300))


def checkFile(table, phase, path, points):
    """A .vtp file of foamToVTK."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    n = len(points["id"])
    table.check(f"{phase}: points in {os.path.basename(path)}",
                data.GetNumberOfPoints() == n, f"{data.GetNumberOfPoints()} of {n}")
    if data.GetNumberOfPoints() != n:
        return
    x = points["x"]
    table.row(f"{phase}: positions", 0,
              difference(vtk_to_numpy(data.GetPoints().GetData()), x), FLOAT32)
    for name, size in COMPONENTS.items():
        array = data.GetPointData().GetArray(name)
        found = array.GetNumberOfComponents() if array else 0
        if not table.check(f"{phase}: components of {name}", found == size, found):
            continue
        expected = points[name]
        if size == 6:
            expected = expected[:, VTK_ORDER]
        table.row(f"{phase}: values of {name}", 0,
                  difference(vtk_to_numpy(array), expected), FLOAT32)


def leaves(blocks):
    """Name and data of all sets of a tree of blocks."""
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

    for i in range(blocks.GetNumberOfBlocks()):
        child = blocks.GetBlock(i)
        if child is not None and child.IsA("vtkMultiBlockDataSet"):
            yield from leaves(child)
        elif child is not None and blocks.HasMetaData(i):
            yield blocks.GetMetaData(i).Get(vtkCompositeDataSet.NAME()), child


def checkReader(table, case, ascii):
    """VTK's reader of OpenFOAM cases."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader

    name = case.file("case.foam")
    open(name, "w").close()
    reader = vtkOpenFOAMReader()
    reader.SetFileName(name)
    reader.UpdateInformation()
    reader.EnableAllPatchArrays()
    reader.EnableAllLagrangianArrays()
    reader.UpdateTimeStep(TIME)
    reader.Update()

    parts = [reader.GetPatchArrayName(i) for i in range(reader.GetNumberOfPatchArrays())]
    clouds = dict(leaves(reader.GetOutput()))
    for phase in PHASES:
        table.check(f"{phase}: vtkOpenFOAMReader lists the cloud",
                    any(p.endswith("lagrangian/" + phase) for p in parts),
                    " ".join(p for p in parts if "lagrangian" in p) or parts)
        points = ascii.points(ascii.timeName(TIME), phase)
        n = len(points["id"])
        data = clouds.get(phase)
        found = data.GetNumberOfPoints() if data else 0
        if not table.check(f"{phase}: vtkOpenFOAMReader reads its points", found == n,
                           f"{found} of {n}"):
            continue
        table.row(f"{phase}: vtkOpenFOAMReader, positions", 0,
                  difference(vtk_to_numpy(data.GetPoints().GetData()), points["x"]),
                  FLOAT32)
        array = data.GetPointData().GetArray("pPoint")
        table.row(f"{phase}: vtkOpenFOAMReader, values of pPoint", 0,
                  difference(vtk_to_numpy(array), points["pPoint"]) if array else np.nan,
                  FLOAT32)


def main():
    table = Report("foamToVTK")
    try:
        case, ascii = makeCase("binary"), makeCase("ascii")
        case.run("foamToVTK")
    except RunFailed as e:
        table.check("the case runs", False, e)
        return table.finish()

    time = case.timeName(TIME)
    for phase in PHASES:
        points, copy = case.points(time, phase), ascii.points(time, phase)
        table.check(f"{phase}: positions are written", "positions" in points)
        # 16 digits of the start are rounded, and the steps add to it
        table.row(f"{phase}: binary against ascii, sigma", 0,
                  difference(points["sigma"], copy["sigma"]), 1e-12)
        files = [f for f in glob.glob(case.file("VTK/lagrangian", phase, "*.vtp"))
                 if not f.endswith("_0.vtp")]
        if table.check(f"{phase}: one .vtp of {TIME} s", len(files) == 1, len(files)):
            checkFile(table, phase, files[0], copy)
    checkReader(table, case, ascii)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
