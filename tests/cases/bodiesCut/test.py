#!/usr/bin/env python3
"""Bodies in a gas and without: mass, centre of mass and outline on all meshes.

shapes     boxes on and between faces of cells, a turned box, discs and spheres, cylinders,
           surfaces of triangles; on boxes, moved hexahedra, prisms, tetrahedra, polyhedra,
           refined boxes and wedges: mass within 1e-10 of the closed form, centre of mass
fractions  points on boxes fill no cell beyond 1 + 1e-3, wherever the body moves
tube       a tube whose sides lie within cells of a wedge
"""

import os
import sys

import numpy as np

sys.path[:0] = [os.path.join(os.path.dirname(__file__), p) for p in ("../../lib", "../anyMesh")]
from cellMesh import boxOfCells
from foamCase import FoamCase, boxMesh, controlDict, noSchemes, runParts
from meshes import refine
from surfaces import prisms, surfaceRegion, writeTriangles
from wedge import SECTOR, wedgeMesh

RHO = 1000.0
AIR = {"type": "gas", "thermo": "perfectGas", "R": 1, "gamma": 1.4}
N = 8


def scene(name, kind, D, regions, gas, ppc=2, n=N):
    case = FoamCase("bodiesCut", name)
    noSchemes(case)
    case.write("system/fvSolution", {"materialPoints": {"transfer": "FLIP"}})
    case.write("system/controlDict", controlDict(1, 1, deltaT=1))
    case.write("constant/phaseProperties", {
        "phases": (["air"] if gas else []) + list(regions), **({"air": AIR} if gas else {}),
        **{r: {"type": "rigid", "rho": RHO} for r in regions}})
    case.write("system/setMaterialPointsDict", {"regions": {
        r: {"phase": r, "pointsPerCell": ppc, **e} for r, e in regions.items()}})
    if kind == "wedge":
        sides = {"ends": ("patch", "x-"), "far": ("patch", "x+"), "wall": ("patch", "r+")}
        case.write("system/blockMeshDict", wedgeMesh((0, 0), (1, 1), (n, n), sides))
        case.run("blockMesh")
        return case
    cells = (n,)*D + (1,)*(3 - D)
    high = (1,)*D + (1/n,)*(3 - D)
    axes = "xyz"
    patches = {"walls": ("patch", tuple(a + s for a in axes[:D] for s in "-+"))}
    if D < 3:
        patches["sides"] = ("empty", tuple(a + s for a in axes[D:] for s in "-+"))
    if kind in ("boxes", "refined"):
        case.write("system/blockMeshDict", boxMesh((0, 0, 0), high, cells, patches))
        case.run("blockMesh")
        if kind == "refined":
            refine(case, (0, 0, 0), (0.5, 1, 1))
    else:
        boxOfCells(case, "tets" if kind == "polyhedra" else kind, (0, 0, 0), high, cells, patches)
        if kind == "polyhedra":
            case.run("polyDualMesh", "60", "-overwrite")
    return case


def turned(middle, a, b, angle):
    c, s = np.cos(angle), np.sin(angle)
    return [tuple(float(np.float32(q)) for q in (middle[0] + c*x - s*y, middle[1] + s*x + c*y))
            for x, y in ((-a, -b), (a, -b), (a, b), (-a, b))]


def polygon(corners):
    x, y = np.array(corners).T
    cross = x*np.roll(y, -1) - y*np.roll(x, -1)
    A = 0.5*cross.sum()
    return A, np.array([((x + np.roll(x, -1))*cross).sum(), ((y + np.roll(y, -1))*cross).sum()])/6/A


def bodies(D, kind):
    """name: region, volume, centre"""
    across = 1 if D == 3 else N**(D - 3.0)
    found = {}
    for name, low, high in (("box", (0.25,)*3, (0.75,)*3),
                            ("shifted box", (0.2613, 0.1877, 0.2391), (0.7331, 0.8119, 0.6902)),
                            ):
        low, high = np.array(low), np.array(high)
        found[name] = ({"type": "box", "min": low, "max": high},
                       np.prod((high - low)[:D])*across, (0.5*(low + high))[:D])
    if D == 1:
        return found
    m, R = np.array((0.5137, 0.4911, 0.5073)), 0.3131
    if D == 2:
        found["disc"] = ({"type": "sphere", "centre": m, "radius": R}, np.pi*R**2*across, m[:2])
        found["ring"] = ({"type": "sphere", "centre": m, "radius": R, "innerRadius": 0.17},
                         np.pi*(R**2 - 0.17**2)*across, m[:2])
    else:
        found["sphere"] = ({"type": "sphere", "centre": m, "radius": R}, 4/3*np.pi*R**3, m)
        axis = np.array((0.2, 0.11, 0.07))
        found["cylinder"] = ({"type": "cylinder", "point1": m - axis, "point2": m + axis,
                              "radius": 0.2}, 2*np.linalg.norm(axis)*np.pi*0.04, m)
    corners = turned(m, 0.31, 0.22, 0.5)
    A, centre = polygon(corners)
    low, high = (-1.0, 2.0) if D == 2 else (0.21875, 0.78125)
    found["turned box"] = (surfaceRegion("turned.stl"), A*(across if D == 2 else high - low),
                           centre if D == 2 else np.append(centre, 0.5))
    found["turned box"][0]["_"] = (corners, low, high)
    return found


def rings():
    found = {}
    for name, (a0, r0), (a1, r1) in (("box", (0.25, 0.25), (0.75, 0.75)),
                                     ("shifted box", (0.2613, 0.2877), (0.7331, 0.8119)),
                                     ("box at the axis", (0.2613, 0), (0.7331, 0.4119))):
        found[name] = ({"type": "box", "min": (a0, r0, -1), "max": (a1, r1, 1)},
                       SECTOR*0.5*(r1**2 - r0**2)*(a1 - a0), np.array(
                           (0.5*(a0 + a1), 2/3*(r1**3 - r0**3)/(r1**2 - r0**2))))
    R = 0.3131
    found["sphere"] = ({"type": "sphere", "centre": (0.5137, 0, 0), "radius": R},
                       SECTOR*2/3*R**3, np.array((0.5137, 3*np.pi/16*R)))
    found["torus"] = ({"type": "sphere", "centre": (0.5137, 0.55, 0), "radius": R},
                      SECTOR*0.55*np.pi*R**2, np.array((0.5137, 0.55 + R**2/4/0.55)))
    return found


def n2(r):
    r = np.abs(r)
    return np.where(r < 0.5, 0.75 - r*r, np.where(r < 1.5, 0.5*(1.5 - r)**2, 0))


def fullest(x, v, D, h, offsets):
    """Largest fraction of cells by kernels of boxes; those of the mesh, and of boxes that
    lie anywhere, to h/offsets."""
    worst = []
    for o in np.ndindex(*(offsets,)*D):
        y = x[:, :D]/h - np.array(o)/offsets
        base = np.floor(y).astype(int)
        total = np.zeros((N + 8,)*D)
        for s in np.ndindex(*(3,)*D):
            cell = base + np.array(s) - 1
            np.add.at(total, tuple((cell + 4).T), v*np.prod(n2(y - cell - 0.5), axis=1))
        worst.append(total.max())
    return worst[0], max(worst)


def beyond(p, region, D):
    """How far the boxes of points reach beyond a box or sphere; that they do not reach."""
    x, l = p["x"][:, :D], p["halfSize"][:, :D]
    if region["type"] == "box":
        low, high = (np.array(region[k])[:D] for k in ("min", "max"))
        return np.abs(np.concatenate(((x - l).min(axis=0) - low, (x + l).max(axis=0) - high))).max()
    if region["type"] != "sphere":
        return 0
    r = np.array(region["centre"])[:D] - x
    d = np.linalg.norm(r, axis=1)
    return abs((d + np.linalg.norm(l*r, axis=1)/d).max() - region["radius"])


MESHES = (("boxes", 1), ("boxes", 2), ("hexes", 2), ("prisms", 2), ("wedge", 2),
          ("boxes", 3), ("refined", 3), ("warped", 3), ("tets", 3), ("polyhedra", 3))


def shapes(table):
    for kind, D in MESHES:
        for gas in (False, True):
            found = rings() if kind == "wedge" else bodies(D, kind)
            regions = {n.replace(" ", ""): {k: e for k, e in r.items() if k != "_"}
                       for n, (r, *_) in found.items()}
            for r in regions.values():
                r["overlap"] = "allow"
            case = scene(f"{kind}-{D}D" + ("-gas" if gas else ""), kind, D, regions, gas)
            for r, *_ in found.values():
                if "_" in r:
                    prisms(case, "turned.stl", [r["_"][0]], *r["_"][1:])
            case.run("setMaterialPoints")
            mass, place, full, most, line = {}, {}, {}, {}, {}
            for name, (r, V, centre) in found.items():
                p = case.points("0", name.replace(" ", ""))
                m = p["m"]
                mass[name] = abs(m.sum()/(RHO*V) - 1)
                place[name] = np.abs(m @ p["x"][:, :D]/m.sum() - centre).max()*N
                line[name] = beyond(p, r, D)*N
                if kind == "boxes":
                    h = 1/N
                    v = p["V"]/h**D/(1 if D == 3 else h**(3 - D))
                    full[name], most[name] = fullest(p["x"], v, D, h, 16 if D < 3 else 6)
                print(f"  {kind} {D}D{' gas' if gas else ''} | {name} | {len(m)} | {mass[name]:.1e} |"
                      f" {place[name]:.1e} | {line[name]:.1e} | {full.get(name, 0) - 1:.1e} |"
                      f" {most.get(name, 0) - 1:.1e}")
            label = f"{kind} {D}D" + (", in a gas" if gas else "")
            worst = max(mass, key=mass.get)
            table.row(f"{label}: mass / exact - 1 ({worst})", 0, mass[worst], 1e-10)
            worst = max(place, key=place.get)
            table.row(f"{label}: centre of mass [cells] ({worst})", 0, place[worst], 0.03)
            if gas and most:
                worst = max(most, key=most.get)
                table.row(f"{label}: fullest cell ({worst})", 1, most[worst], 1.001, "atMost")


def main():
    return runParts("bodiesCut", shapes)


if __name__ == "__main__":
    sys.exit(main())
