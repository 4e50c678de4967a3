"""Points of pointsPerCell 2 (regions of the cells' corners) and 3 (parts of the cells'
simplices) on the polyhedra of polyDualMesh and on boxes refined 2:1 by refineHexMesh:
uniform stress, at rest and in motion, plate impact.
"""

import numpy as np

from cellMesh import boxOfCells
from foamCase import VERIFY, FoamCase, boxMesh, controlDict, noSchemes, velocityFile

P = 1e5
LAW = {"type": "linearElastic", "rho": 1000, "E": 1e9, "nu": 0.3}


def refine(case, low, high):
    """The cells of a box of a mesh of hexahedra in half."""
    case.write("system/topoSetDict", {"actions": [
        "{ name fine; type cellSet; action new; source boxToCell; sourceInfo { box "
        f"({low[0]!r} {low[1]!r} {low[2]!r}) ({high[0]!r} {high[1]!r} {high[2]!r}); }} }}"]})
    case.run("topoSet")
    case.run("refineHexMesh", "fine", "-overwrite")


#: Mesh that boxOfCells makes for those that changeMesh() changes, how far it is moved
BASE = {"polyhedra": ("tets", 0.2), "refined": ("hexes", 0)}


def changeMesh(case, kind, low=None, high=None):
    """tets to the polyhedra of their dual, hexes to finer ones in a box."""
    if kind == "polyhedra":
        case.run("polyDualMesh", "60", "-overwrite")
    elif kind == "refined":
        refine(case, low, high)


def uniform(table):
    """A box full of points under one pressure between slip walls: the acceleration of
    the points in the first step over P/(rho h)."""
    n, h = 6, 0.1
    # Measured with 2: polyhedra 0.025, refined 0.011, warped hexahedra 0.008
    # (cornerRegions.H)
    for kind, nPoints, limit in (
            ("tets", 2, 1e-10), ("polyhedra", 3, 1e-10), ("refined", 3, 1e-10)) + (
            ("polyhedra", 2, 5e-3), ("refined", 2, 5e-3), ("warped", 2, 5e-3))*VERIFY:
        case = FoamCase("anyMesh", f"uniform-{kind}-{nPoints}")
        base, moved = BASE.get(kind, (kind, 0.2))
        boxOfCells(case, base, (0, 0, 0), (n*h,)*3, (n,)*3,
                   {"walls": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))},
                   moved=moved)
        case.write("constant/phaseProperties",
                   {"phases": ["body"], "body": {"constitutiveModel": LAW}})
        velocityFile(case, "body", {"walls": "slip"})
        case.write("system/setMaterialPointsDict", {"regions": {"body": {
            "phase": "body", "type": "cells", "pointsPerCell": nPoints,
            "stress": (-P, 0, 0, -P, 0, -P)}}})
        case.write("system/fvSolution", {"materialPoints": {"transfer": "FLIP"}})
        noSchemes(case)
        dt = 1e-7
        case.write("system/controlDict", controlDict(dt, dt, deltaT=dt))
        changeMesh(case, kind, (0.2, 0.2, 0.2), (9, 9, 0.4))
        case.run("setMaterialPoints")
        case.run("materialPointFoam")
        points = case.points(case.times()[-1], "body")
        m, U = points["m"], points["U"]
        rms = np.sqrt(np.sum(m[:, None]*U**2)/np.sum(m))
        table.row(f"uniform stress, {kind}, pointsPerCell {nPoints}: rho h a/P", 0,
                  rms*1000*h/(P*dt), limit)


def uniformMoves(table):
    """The same in a cyclic box, while the points move at a speed that leaves the stress no
    time to act: at the start, and from half a cell of motion on to two and a half."""
    n, h, U = 6, 0.1, 1e4
    names = [a + b for a in "xyz" for b in ("Low", "High")]
    for kind in ("tets", "warped", "refined") + ("hexes", "prisms")*VERIFY:
        case = FoamCase("anyMesh", f"uniformMoves-{kind}")
        base, moved = BASE.get(kind, (kind, 0.2))
        boxOfCells(case, base, (0, 0, 0), (n*h,)*3, (n,)*3, {
            a: ("cyclic", (a[0] + "-+"[i % 2],), names[i ^ 1]) for i, a in enumerate(names)},
            moved=moved)
        case.write("constant/phaseProperties", {"phases": ["body"], "body": {
            "constitutiveModel": {"type": "linearElastic", "rho": 1000, "E": 10*P, "nu": 0}}})
        velocityFile(case, "body", {a: "cyclic" for a in names})
        case.write("system/setMaterialPointsDict", {"regions": {"body": {
            "phase": "body", "type": "cells", "pointsPerCell": 2,
            "velocity": (U, 0.7*U, 0.4*U), "stress": (-P, 0, 0, -P, 0, -P)}}})
        case.write("system/fvSolution", {"materialPoints": {"transfer": "FLIP"}})
        noSchemes(case)
        dt = 0.1*h/U
        case.write("system/controlDict", controlDict(25*dt, dt, deltaT=dt))
        changeMesh(case, kind, (0.2, 0.2, 0.2), (0.4, 0.4, 0.4))
        case.run("setMaterialPoints")
        case.run("materialPointFoam")
        points = [case.points(t, "body") for t in case.times()]
        m = points[0].byId("m")
        rms = [np.sqrt(np.sum(m[:, None]*(b.byId("U") - a.byId("U"))**2)/np.sum(m))
               * 1000*h/(P*dt) for a, b in zip(points, points[1:])]
        table.row(f"uniform stress, {kind}, cyclic: rho h a/P at the start", 0, rms[0],
                  1e-8 if kind == "tets" else 5e-3, "atMost")
        table.row(f"uniform stress, {kind}, cyclic: largest rho h a/P after motion", 0,
                  max(rms[5:]), 1e-2, "atMost")


#: Layers beside a ball that is cut out of a mesh of blockMesh
SNAPPY = """castellatedMesh true; snap true; addLayers true;
geometry { ball { type searchableSphere; centre (0.3 0.3 0.3); radius 0.13; } }
castellatedMeshControls
{
    maxLocalCells 100000; maxGlobalCells 100000; minRefinementCells 0;
    nCellsBetweenLevels 1; resolveFeatureAngle 30; allowFreeStandingZoneFaces true;
    features (); locationInMesh (0.043 0.037 0.029);
    refinementSurfaces { ball { level (0 0); patchInfo { type patch; } } }
    refinementRegions {}
}
snapControls { nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; }
addLayersControls
{
    relativeSizes true; layers { ball { nSurfaceLayers 2; } } expansionRatio 1;
    finalLayerThickness 0.3; minThickness 0.05; nGrow 0; featureAngle 60; nRelaxIter 3;
    nSmoothSurfaceNormals 1; nSmoothNormals 3; nSmoothThickness 10;
    maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3;
    minMedianAxisAngle 90; minMedialAxisAngle 90;
    nBufferCellsNoExtrude 0; nLayerIter 50;
}
meshQualityControls
{
    maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80;
    minVol 1e-13; minTetQuality 1e-15; minArea -1; minTwist 0.02; minDeterminant 0.001;
    minFaceWeight 0.05; minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4;
    errorReduction 0.75;
}
mergeTolerance 1e-6;
"""


def writeText(case, path, text):
    name = path.split("/")[-1]
    with open(case.file(path), "w") as f:
        f.write("FoamFile { version 2.0; format ascii; class dictionary; object "
                f"{name}; }}\n{text}")


def madeMesh(case, kind, n, h):
    """mirrored: tets and their image in the plane x = n h/2; layers: cubes round a ball."""
    if kind == "mirrored":
        boxOfCells(case, "tets", (0, 0, 0), (0.5*n*h, n*h, n*h), (n//2, n, n),
                   {"walls": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}, moved=0.2)
        writeText(case, "system/mirrorMeshDict", "planeType pointAndNormal; pointAndNormalDict"
                  f" {{ point ({0.5*n*h} 0 0); normal (1 0 0); }} planeTolerance 1e-6;")
        case.run("mirrorMesh", "-overwrite")
        return ["walls"]
    case.write("system/blockMeshDict", boxMesh((0, 0, 0), (n*h,)*3, (n,)*3, {
        "walls": ("patch", ("x-", "x+", "y-", "y+", "z-", "z+"))}))
    writeText(case, "system/snappyHexMeshDict", SNAPPY)
    case.run("blockMesh")
    case.run("snappyHexMesh", "-overwrite")
    return ["walls", "ball"]


def otherMeshes(table):
    """Meshes of mirrorMesh and of snappyHexMesh with layers: a pressure everywhere at rest,
    and a body that flies past the ball, across the layers or the plane of the mirror."""
    n, h, dt = 6, 0.1, 1e-7
    u = np.array((1.0, 0.15, -0.1))
    # Measured: layers 0.033 at rest (cornerRegions.H)
    for kind, limit in (("mirrored", 1e-10), ("layers", 5e-3)):
        for flies in (False, True) if kind == "mirrored" or VERIFY else (True,):
            case = FoamCase("anyMesh", f"{kind}-{'flies' if flies else 'rests'}")
            case.write("constant/phaseProperties",
                       {"phases": ["body"], "body": {"constitutiveModel": LAW}})
            case.write("system/fvSolution", {"materialPoints": {"transfer": "FLIP"}})
            noSchemes(case)
            step = 0.2*h/1000 if flies else dt
            case.write("system/controlDict", controlDict(
                75*step if flies else dt, 75*step if flies else dt, deltaT=step))
            patches = madeMesh(case, kind, n, h)
            velocityFile(case, "body", dict.fromkeys(patches, "calculated" if flies else "slip"))
            where = {"type": "box", "min": (0.05, 0.42, 0.2), "max": (0.25, 0.54, 0.4),
                     "velocity": 200*u} if flies else {
                         "type": "cells", "stress": (-P, 0, 0, -P, 0, -P)}
            case.write("system/setMaterialPointsDict", {"regions": {"body": {
                "phase": "body", "pointsPerCell": 2, **where}}})
            case.run("setMaterialPoints")
            case.run("materialPointFoam")
            points = case.points(case.times()[-1], "body")
            m, U = points["m"], points["U"]
            label = f"mesh with {kind}" if kind == "layers" else f"{kind} mesh"
            if flies:
                table.row(f"{label}: body that flies over 3 cells, largest |u - u0|/|u0|", 0,
                          np.abs(U - 200*u).max()/np.linalg.norm(200*u), 1e-12)
            else:
                rms = np.sqrt(np.sum(m[:, None]*U**2)/np.sum(m))
                table.row(f"{label}: uniform stress, rho h a/P", 0, rms*1000*h/(P*dt), limit)


PARTS = (uniform, uniformMoves, otherMeshes)
