"""Wedges of quadrilaterals, moved or not, and of triangles (solidFraction star).

The quantities and limits are those of a plane, along the axis.
"""

import shutil

import numpy as np

from blockInGas import EXTREMES, P0, R, figures, gasFields, gasSchemes
from cellMesh import boxOfCells
from foamCase import (VERIFY, FoamCase, controlDict, foamText, readInternal, velocityFile)
from wedge import ALPHA, wedgeConditions

RHO = 2700.0


def sector(x):
    """A box whose z is 0 or h becomes a sector about x."""
    side = np.where(x[:, 2] > 0, 1, -1)
    return np.column_stack((x[:, 0], x[:, 1], side*x[:, 1]*np.tan(ALPHA)))


def cylinder(h, x0, x1, r0, r1):
    return {"type": "box", "min": (x0*h, r0*h, -1), "max": (x1*h, r1*h, 1)}


def ball(h, x, r):
    return {"type": "sphere", "centre": (x*h, 0, 0), "radius": r*h}


def inWedge(name, kind, n, region, velocity=0.0, steps=400, ends="cyclic", pressure=None,
            h=1e-3, E=70e9, Co=0.4, reports=20, writes=1, gasVelocity=None, moved=0.2,
            split=None, start=None, points=2, shape="nodeDual", gas=None):
    """A body in a gas on n cells of h; ends: cyclic or slip; the body and, without
    gasVelocity, the gas move along the axis; pressure: Pa, of places."""
    case = FoamCase("gasAnyMesh", "wedge-" + name.replace(" ", "-"))
    walls = ends == "slip"
    patches = {"front": ("wedge", ("z+",)), "back": ("wedge", ("z-",)),
               "axis": ("empty", ("y-",)), "outer": ("patch", ("y+",)),
               **({"left": ("patch", ("x-",)), "right": ("patch", ("x+",))} if walls else
                  {"left": ("cyclic", ("x-",), "right"),
                   "right": ("cyclic", ("x+",), "left")})}
    boxOfCells(case, "hexes" if kind == "boxes" else kind, (0, 0, 0), (n[0]*h, n[1]*h, h),
               (*n, 1), patches, moved=0 if kind == "boxes" else moved, place=sector)
    conditions = wedgeConditions({"left": ends, "right": ends, "outer": "slip"})
    case.write("constant/phaseProperties", {
        "phases": ["air", "block"],
        "air": {"type": "gas", "thermo": "perfectGas", "R": R, "gamma": 1.4,
                "solidFraction": "star", **(gas or {})},
        "block": {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E,
                                        "nu": 0.3}}})
    velocityFile(case, "block", conditions)
    v = (velocity, 0, 0)
    gasFields(case, conditions, v if gasVelocity is None else gasVelocity)
    gasSchemes(case)
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", **region, "pointsPerCell": points, "velocity": v,
        "stress": "ambient", "pressure": P0}}})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": shape, "transfer": "FLIP", "PICfraction": 0.01}})
    dt = Co*h/(np.sqrt(1.35*E/RHO) + abs(velocity))
    case.write("system/controlDict", {
        **controlDict(steps*dt, steps//writes*dt, deltaT=dt, functions=EXTREMES),
        "reportInterval": max(1, steps//reports)})
    if pressure:
        case.run("postProcess", "-func", "writeCellCentres", "-time", "0")
        p = pressure(readInternal(case.file("0", "C")))
        case.change("0/p", "internalField.*;",
                    f"internalField nonuniform List<scalar> {len(p)} {foamText(p)};")
    case.run("setMaterialPoints")
    if split:
        case.decompose(split)
        if start:
            start(case)
        case.runParallel(limit=300)
    else:
        case.run("materialPointFoam", limit=300)
    return case


KINDS = ("hexes", "prisms")


def wedgeTranslation(table):
    """Across some cells along the axis; limits: those of a plane."""
    h, n = 1e-3, (24, 12)
    for kind in KINDS:
        for body, where in (("ball", ball(h, 10, 5.2)),
                            ("ring", cylinder(h, 6.2, 14.3, 4.3, 8.6))):
            case = inWedge(f"translation {kind} {body}", kind, n, where, velocity=500.0,
                           steps=4000 if VERIFY else 400)
            f = figures(case)
            label = f"{body} on a wedge of {kind}, along the axis"
            table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-11, "atMost")
            m = f["momentum"][:, 0]
            table.row(f"{label}: momentum of the points", 0,
                      np.max(abs(m - m[0]))/abs(m[0]), 1e-12, "atMost")
            table.row(f"{label}: mass of the gas", f["gasMass"][0], f["gasMass"][-1], 1e-12,
                      "relative")
            table.row(f"{label}: pressures set to the isentrope", 0, f["fixups"][-1][2], 0)
            print(f"{label}: Theta {f['Theta'].min():.4f} to {f['Theta'].max():.4f}")


def wedgeRest(table):
    for kind in KINDS:
        case = inWedge(f"rest {kind}", kind, (16, 10), cylinder(1e-3, 0, 9.3, -1, 6.3),
                       steps=10000 if VERIFY else 500, ends="slip")
        f = figures(case)
        u = np.max(abs(case.points(case.times()[-1], "block")["U"]))
        label = f"cylinder at rest on a wedge of {kind}, {case.nSteps()} steps"
        table.row(f"{label}: velocity of points", 0, u, 1e-11, "atMost")
        table.row(f"{label}: velocity of the gas", 0, np.max(f["speed"]), 1e-11, "atMost")
        table.row(f"{label}: max dP/P", 0, np.max(abs(f["p"]/P0 - 1)), 1e-13, "atMost")


def shocked(kind, Co, steps, **more):
    """Air of 4 bar along the axis meets a ball on it."""
    h = 1e-3
    return inWedge(f"shock {kind} {Co}" + " 2"*("split" in more) + " again"*("start" in more),
                   kind, (30, 15), ball(h, 14, 5.2), velocity=-30.0, gasVelocity=(0, 0, 0),
                   steps=steps, Co=Co, E=7e9, reports=steps, moved=0.1, writes=2,
                   pressure=lambda C: np.where(C[:, 0] < 6*h, 4*P0, P0),
                   gas={"poreFloor": 0.02}, **more)


def wedgeShock(table):
    for kind in KINDS:
        residual = []
        for Co, steps in ((0.4, 300), (0.2, 600)):
            case = shocked(kind, Co, steps)
            one = case if Co == 0.4 else one
            f = figures(case)
            total = (f["momentum"] + f["gasMomentum"])[:, 0]
            energy = f["energy"] + f["gasEnergy"]
            residual.append((energy[-1] - energy[0])
                            / np.max(abs(f["gasEnergy"] - f["gasEnergy"][0])))
        label = f"shock on a ball, wedge of {kind}"
        table.row(f"{label}: momentum of all along the axis, over the ball's", 0,
                  np.max(abs(total - total[0]))/np.max(abs(f["momentum"][0])), 1e-12,
                  "atMost")
        table.row(f"{label}: mass of the gas", f["gasMass"][0], f["gasMass"][-1], 1e-12,
                  "relative")
        table.row(f"{label}: energy residual over exchanged, CFL 0.4", 0, residual[0], 0.01)
        table.check(f"{label}: it falls with the time step",
                    abs(residual[1]) < 0.75*abs(residual[0]),
                    f"{residual[0]:.2e}, {residual[1]:.2e}")

        two = shocked(kind, 0.4, 300, split=(2, 1, 1) if kind == "prisms" else (1, 2, 1))
        half, end = one.times()[1:3]
        table.row(f"{label}, 1 against 2 processors: points", 0, one.largestDifference(
            two, end, ["block"], ("x", "U", "sigma", "V")), 1e-10, "atMost")
        a, b = figures(one), figures(two)
        for name in ("p", "speed", "gasMomentum", "gasEnergy"):
            table.row(f"{label}, 1 against 2 processors: {name}", 0,
                      np.max(abs(a[name] - b[name]))/np.max(abs(a[name])), 1e-10, "atMost")

        again = FoamCase("gasAnyMesh", f"wedge-restart-{kind}", template=one.path)
        shutil.copytree(one.file("constant", "polyMesh"), again.file("constant", "polyMesh"))
        shutil.rmtree(again.file(end))
        again.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
        again.run("materialPointFoam")
        table.row(f"{label}, restart at half time: points", 0, one.largestDifference(
            again, end, ["block"], ("x", "U", "sigma", "V")), 0, "atMost")
        files = [open(c.file(end, "thetaRhoE.air"), "rb").read() for c in (one, again)]
        table.check(f"{label}, restart at half time: gas bit by bit", files[0] == files[1])


def wedgeBlast(table):
    """Air of 10 bar round the axis drives a ring outward: the hoop strain changes the
    volume of the solid, which the gas must see. On boxes beside the form lattice."""
    h, n = 0.5e-3, (4, 60)
    speed = {}
    for kind, form in (("boxes", "lattice"), ("boxes", "star"), ("hexes", "star"),
                       ("prisms", "star")):
        case = inWedge(f"blast {kind} {form}", kind, n, cylinder(h, -1, 200, 22.4, 30.8),
                       gasVelocity=(0, 0, 0), steps=800, Co=0.3, h=h, E=7e9, reports=50,
                       moved=0.1, pressure=lambda C: np.where(C[:, 1] < 16*h, 10*P0, P0),
                       gas={"solidFraction": form})
        f = figures(case)
        energy = f["energy"] + f["gasEnergy"]
        points = case.points(case.times()[-1], "block")
        speed[kind, form] = np.average(points["U"][:, 1], weights=points["m"])
        if form == "star":
            table.row(f"cylindrical blast on a ring, {kind}: energy residual over exchanged",
                      0, (energy[-1] - energy[0])
                      / np.max(abs(f["gasEnergy"] - f["gasEnergy"][0])), 0.01)
    table.row("cylindrical blast on a ring, boxes: its speed, star beside lattice",
              speed["boxes", "lattice"], speed["boxes", "star"], 0.02, "relative")
