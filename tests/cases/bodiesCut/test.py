#!/usr/bin/env python3
"""Bodies are where the user put them, in a gas and without, on all meshes.

shapes     boxes on and between faces of cells, turned boxes, discs, rings, spheres,
           cylinders, surfaces of triangles; on boxes, moved and warped hexahedra, prisms,
           tetrahedra, polyhedra, refined boxes and wedges: mass within 1e-10 of the closed
           form, centre of mass, where the boxes of points end; on boxes and wedges in a gas
           no cell is fuller than 1 + 1e-3, also when the body has moved by part of a cell
warning    a mass that is 0.1 % off is said with its remedy
"""

import os
import sys

import numpy as np

sys.path[:0] = [os.path.join(os.path.dirname(__file__), p) for p in ("../../lib", "../anyMesh")]
from cellMesh import boxOfCells
from foamCase import FoamCase, boxMesh, controlDict, noSchemes, runParts
from meshes import refine
from surfaces import prisms, surfaceRegion
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


#: Of the turned box; OpenFOAM reads STL in single precision
TURNED, HEIGHT = turned((0.5137, 0.4911), 0.31, 0.22, 0.5), (0.21875, 0.78125)


def bodies(D):
    """name: region, volume, centre"""
    across = N**(D - 3.0)
    found = {}
    for name, low, high in (("box", (0.25,)*3, (0.75,)*3),
                            ("shifted box", (0.2613, 0.1877, 0.2391), (0.7331, 0.8119, 0.6902))):
        low, high = np.array(low), np.array(high)
        found[name] = ({"type": "box", "min": low, "max": high},
                       np.prod((high - low)[:D])*across, (0.5*(low + high))[:D])
    if D == 1:
        return found
    A, centre = polygon(TURNED)
    m, R = np.array((0.5137, 0.4911, 0.5073)), 0.3131
    ball = {"type": "sphere", "centre": m, "radius": R}
    if D == 2:
        found["disc"] = (ball, np.pi*R**2*across, m[:2])
        found["ring"] = ({**ball, "innerRadius": 0.17}, np.pi*(R**2 - 0.17**2)*across, m[:2])
        found["surface"] = (surfaceRegion("turned.stl"), A*across, centre)
        return found
    axis = np.array((0.2, 0.11, 0.07))
    found["sphere"] = (ball, 4/3*np.pi*R**3, m)
    found["cylinder"] = ({"type": "cylinder", "point1": m - axis, "point2": m + axis,
                          "radius": 0.2}, 2*np.linalg.norm(axis)*np.pi*0.04, m)
    found["surface"] = (surfaceRegion("turned.stl"), A*(HEIGHT[1] - HEIGHT[0]),
                        np.append(centre, 0.5))
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
    """Largest fraction of cells of boxes, which lie anywhere, to h/offsets (pointKernels)."""
    worst = 0
    for o in np.ndindex(*(offsets,)*D):
        y = x[:, :D]/h - np.array(o)/offsets
        base = np.floor(y).astype(int)
        total = np.zeros((N + 8,)*D)
        for s in np.ndindex(*(3,)*D):
            cell = base + np.array(s) - 1
            np.add.at(total, tuple((cell + 4).T), v*np.prod(n2(y - cell - 0.5), axis=1))
        worst = max(worst, total.max())
    return worst


def fullestRing(x, v, h, offsets):
    """The same of a wedge: radial functions of r^2, places along the axis anywhere."""
    worst, i = 0, np.floor(x[:, 1]/h).astype(int)
    s, low, high = (x[:, 1]/h)**2, i**2, (i + 1)**2
    c0 = np.maximum(1 - (s - low)/np.maximum(low - (i - 1)**2, 1e-30), 0)*(i > 0)
    c1 = np.maximum(1 - (high - s)/(high - low), 0)
    radial = (0.5*c0**2, 1 - 0.5*c0**2 - 0.5*c1**2, 0.5*c1**2)
    for o in range(offsets):
        y = x[:, 0]/h - o/offsets
        base = np.floor(y).astype(int)
        total = np.zeros((N + 8, N + 8))
        for a in (-1, 0, 1):
            for b in (-1, 0, 1):
                np.add.at(total, (base + a + 4, i + b + 4), v*n2(y - base - a - 0.5)*radial[b + 1])
        ring = np.maximum(SECTOR*h**3*(np.arange(N + 8) - 3.5), 1e-30)
        worst = max(worst, (total/ring)[:, 4:].max())
    return worst


def beyond(p, region, D):
    """How far from the faces of a box or sphere the boxes of points end."""
    x, l = p["x"][:, :D], p["halfSize"][:, :D]
    if region["type"] == "box":
        low, high = (np.array(region[k])[:D] for k in ("min", "max"))
        return np.abs(np.concatenate(((x - l).min(axis=0) - low, (x + l).max(axis=0) - high))).max()
    if region["type"] != "sphere":
        return 0
    r = np.array(region["centre"])[:D] - x
    d = np.linalg.norm(r, axis=1)
    return abs((d + np.linalg.norm(l*r, axis=1)/d).max() - region["radius"])


def shapes(table):
    """What beside mass is not to rounding: the centre of mass of points in a gas, and on
    wedges, where a place is the centre of the section."""
    for kind, D, gases, ofCentre in (
            ("boxes", 1, (True,), 1e-10), ("boxes", 2, (False, True), 2e-3),
            ("hexes", 2, (True,), 2e-3), ("prisms", 2, (True,), 1e-4),
            ("wedge", 2, (False, True), 0.04), ("boxes", 3, (True,), 2e-3),
            ("refined", 3, (True,), 1e-4), ("warped", 3, (True,), 1e-3),
            ("tets", 3, (True,), 2e-4), ("polyhedra", 3, (True,), 2e-4)):
        for gas in gases:
            found = rings() if kind == "wedge" else bodies(D)
            case = scene(f"{kind}-{D}D" + ("-gas" if gas else ""), kind, D, {
                n.replace(" ", ""): {**r, "overlap": "allow"} for n, (r, *_) in found.items()}, gas)
            if D > 1 and kind != "wedge":
                prisms(case, "turned.stl", [TURNED], *((-1, 2) if D == 2 else HEIGHT))
            case.run("setMaterialPoints")
            mass, place, most, ends = {}, {}, {}, {}
            for name, (r, V, centre) in found.items():
                p = case.points("0", name.replace(" ", ""))
                m, h = p["m"], 1/N
                mass[name] = abs(m.sum()/(RHO*V) - 1)
                place[name] = np.abs(m @ p["x"][:, :D]/m.sum() - centre).max()/h
                ends[name] = beyond(p, r, D)/h if "axis" not in name and r.get(
                    "centre", (1, 1))[1] > 0 else 0
                if gas and kind == "boxes":
                    most[name] = fullest(p["x"], p["V"]/h**3, D, h, 8 if D < 3 else 3)
                elif gas and kind == "wedge":
                    most[name] = fullestRing(p["x"], p["V"], h, 8)
            for what, errors, limit in (("mass / exact - 1", mass, 1e-10),
                                        ("centre of mass [cells]", place, ofCentre),
                                        ("ends of points [cells]", ends, 1e-10)):
                worst = max(errors, key=errors.get)
                table.row(f"{kind} {D}D{', gas' if gas else ''}: {what} ({worst})", 0,
                          errors[worst], limit)
            if most:
                worst = max(most, key=most.get)
                table.row(f"{kind} {D}D, gas: fullest cell ({worst})", 1.001, most[worst], 1.001,
                          "atMost")


def warning(table):
    ball = {"type": "sphere", "centre": (0.5137, 0.4911, 0.5073), "radius": 0.3131}
    for label, more in (("sampled", {"parts": "sampled"}), ("exact", {})):
        case = scene("warning-" + label, "boxes", 2, {"a": {**ball, **more}}, True)
        case.run("setMaterialPoints")
        said = " ".join(case.log("setMaterialPoints").split())
        table.check(f"parts {label}: a warning if the mass is wrong",
                    ("that of its shape in the mesh" in said) == bool(more)
                    and ("Remove parts sampled;" in said) == bool(more))


def main():
    return runParts("bodiesCut", shapes, warning)


if __name__ == "__main__":
    sys.exit(main())
