"""What crosses a side between cells of two sizes, without a mesh that changes: waves in points
and gas leave next to nothing behind, a body goes on as without."""

import numpy as np

from foamCase import FoamCase, boxMesh, controlDict, noSchemes, velocityFile
from gasCases import OPEN, WALL, volField
from gasOnCells import gasOnCells, halve


def pulse(label, boxes, transfer, n=200, width=0.2):
    """Velocity of the points of a bar, x over its length, after a pulse has split into two and
    one of them has crossed x = 0.65; over the height of that one."""
    case = FoamCase("adaptiveMesh", f"pulse-{transfer}-{label}")
    h = 1/n
    case.write("system/blockMeshDict", boxMesh(
        (0, 0, 0), (1, 4*h, h), (n, 4, 1),
        {"ends": ("patch", ("x-", "x+")), "sides": ("symmetryPlane", ("y-",)),
         "others": ("symmetryPlane", ("y+",)), "frontAndBack": ("empty", ("z-", "z+"))}))
    noSchemes(case)
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": "nodeDual", "transfer": transfer}})
    E, rho, height = 1e6, 1000, 1e-3
    c = np.sqrt(E/rho)
    case.write("system/controlDict", controlDict(0.3/c, 0.3/c, 0.3))
    case.write("constant/phaseProperties", {"phases": ["bar"], "bar": {
        "constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E, "nu": 0}}})
    x = np.linspace(0, 1, 4*n + 1)
    u = np.where(abs(x - 0.5) < width/2, 2*height*np.cos(np.pi*(x - 0.5)/width)**2, 0)
    table = "(" + " ".join(f"({a:.6g} ({b:.8g} 0 0))" for a, b in zip(x, u)) + ")"
    case.run("blockMesh")
    if boxes:
        halve(case, boxes)
    case.write("system/setMaterialPointsDict", {"regions": {"bar": {
        "phase": "bar", "type": "box", "min": (0.02, -1, -1), "max": (0.98, 1, 1),
        "pointsPerCell": 2, "velocity": {"x": "table " + table}}}})
    case.run("setMaterialPoints")
    velocityFile(case, "bar", {"ends": "calculated", "sides": "symmetryPlane",
                               "others": "symmetryPlane", "frontAndBack": "empty"})
    case.run("materialPointFoam")
    p = case.points(case.times()[-1], "bar")
    return p["x"][:, 0], p["U"][:, 0]/height


def waves(table):
    def mean(x, u):
        """Of two coarse cells, of the 40 of the wave."""
        bins = np.arange(0, 1.005, 0.01)
        n, sums = (np.histogram(x, bins, weights=w)[0] for w in (None, u))
        return 0.5*(bins[1:] + bins[:-1]), sums/np.maximum(n, 1)
    for transfer in ("FLIP", "APIC"):
        x, even = mean(*pulse("even", (), transfer))
        for label, box in (("coarse to fine", ((0.65, -1, -1), (2, 1, 1))),
                           ("fine to coarse", ((-1, -1, -1), (0.65, 1, 1)))):
            u = mean(*pulse(label.replace(" ", "-"), (box,), transfer))[1]
            back, on = abs(x - 0.5) < 0.08, x > 0.7
            table.row(f"pulse in points, {transfer}, {label}: thrown back, over its height", 0,
                      np.max(np.abs(u - even)[back])/np.max(even[on]), 0.01, "atMost")
            table.row(f"pulse in points, {transfer}, {label}: height over that of even cells", 1,
                      np.max(u[on])/np.max(even[on]), 0.05)

    def state(C, t):
        high = C[:, 0] < 0.2
        return (np.where(high, 4.0, 1.0), np.zeros((len(C), 3)), np.where(high, 10.0, 1.0))
    values = {}
    for label, boxes in (("even", ()), ("coarse to fine", (((0.5, -1, -1), (2, 1, 1)),)),
                         ("fine to coarse", (((-1, -1, -1), (0.5, 1, 1)),))):
        case, C, _ = gasOnCells(
            "adaptiveMesh", f"shock-{label}", "hexes", (100, 8, 1), (1, 0.08, 0.1),
            {"ends": ("patch", ("x-", "x+")), "walls": ("wall", ("y-", "y+"))},
            {"ends": OPEN, "walls": WALL}, state, 0.24, moved=0, halved=boxes)
        # Between the contact and where the shock has crossed
        at = abs(C[:, 0] - 0.46) < 0.04
        p = volField(case, case.timeName(0.24), "p")
        values[label] = p[at].min(), p[at].max(), C[p > 2, 0].max()
    low, high, front = values.pop("even")
    for label, (a, b, _) in values.items():
        table.row(f"shock in a gas, {label}: pressure left behind, off that on even cells, over"
                  " the jump", 0, max(abs(a - low), abs(b - high))/(high - 1), 0.01, "atMost")
    table.check("the shock has crossed the side", front > 0.55, front)
