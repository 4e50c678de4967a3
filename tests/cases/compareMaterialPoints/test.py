#!/usr/bin/env python3
"""compareMaterialPoints: finds every difference and no other.

A block on a floor, binary and ascii, whole and decomposed (decomposePar, also
with a processor that has no points and no files), changed by known amounts in
known points; missing points, columns and clouds; two times of one case. Rows "True" are runs whose exit status would have
stopped the test.
"""

import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (FoamCase, RunFailed, boxMesh, controlDict, fileHeader, noSchemes,
                      readField, velocityFile, writeField)
from report import Report

H = 0.01
GROUP = "compareMaterialPoints"


def build(name, writeFormat, compression="off"):
    case = FoamCase(GROUP, name)
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (8*H, 9*H, H), (8, 9, 1),
        {"floor": ("patch", ("y-",)), "outside": ("patch", ("x-", "x+", "y+")),
         "frontAndBack": ("empty", ("z-", "z+"))}))
    case.write("constant/phaseProperties", {"phases": ["block"], "block": {
        "constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 1e6, "nu": 0.3}}})
    velocityFile(case, "block", {
        "floor": {"type": "fixedValue", "value": "uniform (0 0 0)"},
        "outside": "calculated", "frontAndBack": "empty"})
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "pointsPerCell": 2, "min": (2*H, 0, 0),
        "max": (6*H, 5*H, H), "velocity": (1, -0.3, 0)}}})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "GIMP", "transfer": "FLIP"}})
    noSchemes(case)
    control = controlDict(2e-3, 1e-3, maxCo=0.4, writeFormat=writeFormat)
    control["writeCompression"] = compression
    case.write("system/controlDict", control)
    # The third piece has no points
    case.write("system/decomposeParDict", {
        "numberOfSubdomains": 3, "method": "simple",
        "simpleCoeffs": {"n": (1, 3, 1), "delta": 1e-3}})
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam")
    return case


def copyOf(case, name):
    other = FoamCase(GROUP, name)
    shutil.rmtree(other.path)
    shutil.copytree(case.path, other.path)
    return other


def compare(case, other, *options, fails=False):
    """What the table says of each name: number, four norms, the rest of the line."""
    case.run("compareMaterialPoints", case.path, other.path, *options, fails=fails)
    text = case.log("compareMaterialPoints")
    rows = re.findall(r"^  (\S+) +(\d+) +(\S+) +(\S+) +(\S+) +(\S+)(.*)$", text, flags=re.M)
    return {r[0]: (int(r[1]), *map(float, r[2:6]), r[6]) for r in rows}, text


def change(case, time, column, row, value):
    path = case.file(time, "lagrangian", "block", column)
    values = np.array(readField(path), float)
    values[row] = value
    writeField(path, values)
    return values


def main():
    table = Report(GROUP)
    try:
        case = build("binary", "binary")
        first, last = (case.timeName(t) for t in (1e-3, 2e-3))
        same, _ = compare(case, copyOf(case, "copy"), "-tolerance", "0")
        points = case.points(last, "block")
        expected = {"x", "U", "m", "V", "sigma", "halfSize", "leftStretch", "pPoint",
                    "sigmaEq", "alpha.block", "Umean.block", "sigma.block", "U.block"}
        table.check("a copy: all columns and fields are compared", expected == set(same),
                    " ".join(sorted(set(same) ^ expected)) or len(same))
        table.row("a copy: largest difference", 0, max(r[1] for r in same.values()), 0)
        table.row("number of points", len(points["m"]), same["x"][0], 0)
        table.row("number of cells", 72, same["alpha.block"][0], 0)
        table.row("number of mesh points", 180, same["U.block"][0], 0)

        # One stress is other by a known tensor
        other = copyOf(case, "changed")
        sigma, ids = points["sigma"], points["id"]
        row = 17
        change(other, last, "sigma", row, sigma[row] + np.array((3., 0, 0, 4, 0, 0)))
        size = np.linalg.norm(sigma, axis=1).max()
        result, _ = compare(case, other, "-tolerance", repr(4.9/size), fails=True)
        table.row("one stress changed: largest difference", 5, result["sigma"][1], 5e-3)
        table.row("one stress changed: relative", 5/size, result["sigma"][2], 1e-3, "relative")
        table.row("one stress changed: L2", 5/np.sqrt(len(ids)), result["sigma"][3], 1e-3,
                  "relative")
        table.check("one stress changed: worst point",
                    f"id {ids[row]} (" in result["sigma"][5], result["sigma"][5].strip())
        table.row("one stress changed: largest difference of others", 0,
                  max(r[1] for n, r in result.items() if n != "sigma"), 0)
        compare(case, other, "-tolerance", repr(5.1/size))
        table.check("exit status follows the tolerance", True)

        # A body at rest but for rounding, beside one that moves with 1 m/s
        pair = [copyOf(case, "rest1"), copyOf(case, "rest2")]
        for one, u in zip(pair, (1e-17, -2e-17)):
            folder = one.file(last, "lagrangian")
            shutil.copytree(os.path.join(folder, "block"), os.path.join(folder, "rest"))
            writeField(os.path.join(folder, "rest", "U"), np.full_like(points["U"], u))
        result, text = compare(*pair, "-tolerance", "1e-15")
        said = re.search(r"^Largest relative difference: (\S+), of (\w+)", text, re.M)
        table.row("a body at rest: relative to itself", 1.5, result["U"][2], 1e-3, "relative")
        table.row("a body at rest: the verdict, relative to the speed of all",
                  np.sqrt(3)*3e-17/np.linalg.norm(points["U"], axis=1).max(), float(said[1]),
                  1e-3, "relative")
        compare(case, other)
        result, _ = compare(case, other, "-tolerance", "0", "-fields", "(x U)")
        table.check("-fields: only these", set(result) == {"x", "U"}, " ".join(result))

        # What decomposePar reads is no result
        weighed = copyOf(case, "weighed")
        with open(weighed.file(last, "cellWeights"), "w") as f:
            f.write(fileHeader("cellWeights", "volScalarField") + "dimensions [0 0 0 0 0 0 0];\n"
                    "internalField uniform 1;\nboundaryField { \".*\" { type calculated; } }\n")
        compare(case, weighed, "-tolerance", "0")
        _, text = compare(case, weighed, "-tolerance", "0", "-fields", "(x cellWeights)",
                          fails=True)
        table.check("cellWeights in one case: no difference, unless -fields names it",
                    "second case: field cellWeights" in text)

        change(other, last, "sigma", row, sigma[row])
        change(other, last, "V", row, points["V"][row]*1.5)
        result, _ = compare(case, other, "-tolerance", "1e-3", fails=True)
        table.row("one volume changed: largest difference / volume", 0.5,
                  result["V"][1]/points["V"][row], 1e-3, "relative")

        # A point and a column less
        other = copyOf(case, "missing")
        for column in os.listdir(other.file(last, "lagrangian/block")):
            if column in ("positions", "coordinates", "origProcId", "origId"):
                continue
            path = other.file(last, "lagrangian/block", column)
            values = np.delete(np.array(readField(path)), 5, axis=0)
            if column == "id":
                with open(path, "w") as f:
                    f.write(fileHeader("id", "labelField") + f"{len(values)}\n(\n"
                            + "\n".join(map(str, values)) + "\n)\n")
            else:
                writeField(path, values)
        result, text = compare(case, other, "-tolerance", "1e-14", fails=True)
        table.check("a point is missing", f"1 points of block, the first with id {ids[5]}"
                    in text and "Only in the first" in text)
        table.row("a point is missing: the others are compared", len(ids) - 1, result["x"][0], 0)
        table.row("a point is missing: the others are the same", 0,
                  max(r[2] for r in result.values()), 1e-14)
        os.remove(other.file(last, "lagrangian/block/pPoint"))
        _, text = compare(other, case, "-tolerance", "1", fails=True)
        table.check("a column is missing",
                    "Only in the second case: column pPoint of block" in text)

        # Inner values alone, as a gas writes its state
        parts = [copyOf(case, name) for name in ("inner", "inner-changed")]
        for c, value in zip(parts, (2.0, 3.0)):
            with open(c.file(last, "thetaRho.air"), "w") as f:
                f.write(fileHeader("thetaRho.air", "volScalarField::Internal")
                        + "dimensions [1 -3 0 0 0 0 0];\nvalue nonuniform List<scalar> 72\n("
                        + "4 "*71 + f"{value});\n")
        result, _ = compare(*parts, "-tolerance", "0.1", fails=True)
        table.row("a field of inner values (thetaRho): largest difference", 1,
                  result.get("thetaRho.air", [0]*6)[1], 1e-3)

        # Two times of one case
        result, text = compare(case, case, "-time", first, "-time2", last)
        x = [case.points(t, "block").byId("x") for t in (first, last)]
        table.row("two times: largest way of a point", np.linalg.norm(
            x[1] - x[0], axis=1).max(), result["x"][1], 1e-3, "relative")
        case.run("compareMaterialPoints", ".", ".", "-time", "7", fails=True)
        table.check("unknown time: the times are listed", f"(0 {first} {last})"
                    in " ".join(case.log("compareMaterialPoints").split()))

        # Whole against decomposed
        text, packed = build("ascii", "ascii"), build("compressed", "ascii", "on")
        table.check("the compressed case is compressed",
                    os.path.exists(packed.file(last, "lagrangian/block/x.gz")))
        compare(case, text, "-tolerance", "1e-12")
        compare(text, packed, "-tolerance", "0")
        table.check("ascii as binary to 1e-12, compressed as ascii to 0", True)
        for name, c in (("binary", case), ("ascii", text), ("compressed", packed)):
            parts = copyOf(c, name + "-parts")
            parts.run("decomposePar", "-latestTime")
            # As the solver has it where there are no points
            shutil.rmtree(parts.file("processor2", last, "lagrangian"), ignore_errors=True)
            tolerance = "0" if name == "binary" else "1e-11"
            result, text = compare(c, parts, "-tolerance", tolerance, "-processors", "second")
            table.check(f"{name}: decomposed is read", "of 3 processors" in text)
            table.check(f"{name}: decomposed: all are compared", expected <= set(result),
                        len(result))
            table.row(f"{name}: decomposed: points", len(ids), result["x"][0], 0)
            table.row(f"{name}: decomposed: mesh points, twice on two sides", 180 + 2*18,
                      result["U.block"][0], 0)
            shutil.rmtree(parts.file(last))
            compare(parts, c, "-tolerance", tolerance)
            table.check(f"{name}: the other way round, processors found", "of 3 processors"
                        in parts.log("compareMaterialPoints"))
    except RunFailed as e:
        table.check("runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
