"""Bending with nodeDual on any cells: a beam that swings, Cook's membrane at rest.

beam   the cantilever of tests/cases/locking, 10 by 1: half a period of its first mode
       beside Euler and Bernoulli's with shear, nu 0.3 and 0.499, 4 cells across, sides on
       planes of cells and between them; on triangles 20 by 1, too; with turnSides and
       without. Limit 5 %. Without, on planes: nodeDual.H
cook   a tapered panel (48 by 44, 16 at its end), clamped at one end, in plane strain: the
       displacement of all points beside that of finite elements of second order (solved
       here) in the same place. Under a body force, and sheared at the other end: there
       the box of surfaceLoads holds part of the lower side too, so that the load grows by
       1/cells of it; the reference has the force that the points carry. The error is of
       first order (surface): body force 2.8 and 1.4 % at 16 and 32 cells
"""

import numpy as np

from features import scene
from foamCase import VERIFY, writeField
from meshes import changeMesh

RHO = 1000.0
MODE = 1.8751040687
HELD = {"type": "fixedValue", "value": "uniform (0 0 0)"}
LIBS = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}


def _law(E, nu):
    return {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E, "nu": nu,
                                  "stress": "Kirchhoff"}}


def depth(kind):
    """Cells across plane strain: one between empty sides, else between slip walls."""
    return (2,) if kind in ("tets", "warped", "polyhedra") else ()


def across(kind):
    """The sides of plane strain, for scene()."""
    return {"across": (("z-", "z+"), "slip")} if depth(kind) else {}


def _halfPeriod(kind, nu, cells, between, length=1.0, turned=True, **numerics):
    """A case; half a period over that of the beam with shear (Dunkerley: 1/w^2 =
    1/w_bending^2 + 1/w_shear^2).
    between: its sides halfway between planes of cells."""
    height, modulus = 0.1, 24e6
    E = modulus*(1 - nu**2)
    h = height/cells
    bending = MODE**2*np.sqrt(modulus*height**2/(12*RHO))/length**2
    shear = 0.5*np.pi/length*np.sqrt(5/6*E/(2*(1 + nu))/RHO)
    exact = np.pi*np.sqrt(bending**-2 + shear**-2)
    low = height + 0.5*h*between
    n = (round(length/h) + 2, 3*cells, *depth(kind))
    name = f"beam {nu} {cells} {between} {length} {turned}"
    case = scene(name, kind, n, {"beam": _law(E, nu)}, {"beam": {
        "min": (0, low, -1), "max": (length, low + height, 1)}}, (1.4 if VERIFY else 1.15)*exact,
        sides={"wall": (("x-",), HELD), **across(kind)}, size=h, run=False,
        numerics={"shapeFunction": "nodeDual", "transfer": "FLIP", "PICfraction": 0,
                  "turnSides": turned, **numerics},
        maxCo=0.8, change=lambda case: changeMesh(case, kind),
        functions={"tip": {"type": "materialPointExtent", **LIBS},
                   "energy": {"type": "materialPointEnergy", **LIBS}})
    x = case.points("0", "beam")["x"]
    k, s = MODE/length, (np.sinh(MODE) - np.sin(MODE))/(np.cosh(MODE) + np.cos(MODE))
    z = k*x[:, 0]
    U = np.zeros((len(x), 3))
    U[:, 1] = 0.05*(np.cosh(z) - np.cos(z) - s*(np.sinh(z) - np.sin(z)))
    writeField(case.file("0/lagrangian/beam/U"), U)
    case.run("materialPointFoam", limit=1200)
    record = case.series("tip", "beam.dat")
    t, y = record[:, 0], record[:, 8] - record[0, 8]
    back = np.flatnonzero((y[:-1] > 0) & (y[1:] <= 0))[0]
    return case, (t[back] + (t[back + 1] - t[back])*y[back]/(y[back] - y[back + 1]))/exact


def beam(table):
    runs = (("prisms", 0.3, 4, True, 1, False), ("hexes", 0.3, 4, True, 1, False),
            ("prisms", 0.499, 4, True, 1, False), ("prisms", 0.3, 8, False, 1, False),
            ("prisms", 0.3, 4, True), ("prisms", 0.499, 4, True), ("prisms", 0.3, 4, False),
            ("prisms", 0.499, 4, False), ("prisms", 0.3, 8, False),
            ("hexes", 0.3, 4, False), ("prisms", 0.3, 4, False, 2))
    if VERIFY:
        runs += (("hexes", 0.3, 4, True), ("hexes", 0.499, 4, True), ("hexes", 0.499, 4, False),
                 ("hexes", 0.3, 8, False), ("prisms", 0.3, 4, True, 2)) + tuple(
            (kind, nu, 4, between) for kind in ("tets", "polyhedra") for nu in (0.3, 0.499)
            for between in (True, False) if between or kind == "tets")
    for kind, nu, cells, between, *more in runs:
        where = "between" if between else "on"
        length, turned = more[0] if more else 1, len(more) < 2
        name = f"beam{', twice as long' if length > 1 else ''}{', turnSides' if turned else ''}"
        table.row(f"{name}, {kind}, {cells} across, sides {where} planes of cells, nu {nu}: "
                  "half a period over the exact one", 1,
                  _halfPeriod(kind, nu, cells, between, length, turned)[1], 0.05)

    # The force is the adjoint of the strain: USAVG keeps the energy to second order in dt
    total = _halfPeriod("prisms", 0.3, 4, False, stressUpdate="USAVG")[0].series(
        "energy", "energy.dat")[:, 3]
    table.row("beam, turnSides, prisms, 4 across, USAVG: largest change of the energy", 0,
              np.max(np.abs(total/total[0] - 1)), 0.001)


# Cook's membrane

WIDTH, LEFT, RIGHT = 0.48, 0.44, 0.16


def _panel(s, t):
    """s from the clamped end, t across, 0 to 1 -> x, y."""
    return WIDTH*s, LEFT*s + (LEFT + (RIGHT - LEFT)*s)*t


def _displacement(E, nu, load, weight, places, m=16):
    """Of m x m quadratic elements in plane strain under a shear at the end [Pa] and a
    body force [N/m3] along y, at places (x, y)."""
    g = np.array([-np.sqrt(0.6), 0, np.sqrt(0.6)])
    w = np.array([5, 8, 5])/9

    def shape(r):
        return np.array([r*(r - 1)/2, 1 - r*r, r*(r + 1)/2])

    def slope(r):
        return np.array([r - 0.5, -2*r, r + 0.5])

    lam, mu = E*nu/((1 + nu)*(1 - 2*nu)), E/(2*(1 + nu))
    D = np.array([[lam + 2*mu, lam, 0], [lam, lam + 2*mu, 0], [0, 0, mu]])
    k = 2*m + 1
    at = np.arange(k)/(2*m)
    X = np.stack(_panel(*np.meshgrid(at, at, indexing="ij")), axis=-1).reshape(-1, 2)
    K, f = np.zeros((2*k*k, 2*k*k)), np.zeros(2*k*k)
    for a in range(m):
        for b in range(m):
            nodes = np.array([(2*a + i)*k + 2*b + j for i in range(3) for j in range(3)])
            dofs = np.stack((2*nodes, 2*nodes + 1), axis=-1).ravel()
            for i, r in enumerate(g):
                for j, q in enumerate(g):
                    dN = np.stack((np.outer(slope(r), shape(q)).ravel(),
                                   np.outer(shape(r), slope(q)).ravel()))
                    J = dN @ X[nodes]
                    dV = w[i]*w[j]*np.linalg.det(J)
                    f[dofs[1::2]] += weight*dV*np.outer(shape(r), shape(q)).ravel()
                    dN = np.linalg.solve(J, dN)
                    B = np.zeros((3, 18))
                    B[0, ::2], B[1, 1::2] = dN
                    B[2, ::2], B[2, 1::2] = dN[1], dN[0]
                    K[np.ix_(dofs, dofs)] += dV*B.T @ D @ B
    # Simpson along the loaded side
    f[2*(k - 1)*k + 1::2] += load*RIGHT/(6*m)*np.r_[1, np.tile([4, 2], m - 1), 4, 1]
    free = np.arange(2*k, 2*k*k)
    u = np.zeros(2*k*k)
    u[free] = np.linalg.solve(K[np.ix_(free, free)], f[free])
    result = []
    for x, y in places:
        s = x/WIDTH
        t = (y - LEFT*s)/(LEFT + (RIGHT - LEFT)*s)
        a, b = (int(min(max(v*m, 0), m - 1)) for v in (s, t))
        N = np.outer(shape(2*(s*m - a) - 1), shape(2*(t*m - b) - 1)).ravel()
        nodes = [(2*a + i)*k + 2*b + j for i in range(3) for j in range(3)]
        result.append([N @ u[2*np.array(nodes)], N @ u[2*np.array(nodes) + 1]])
    return np.array(result)


def _cook(kind, nu, cells, sheared, turned=False):
    """The mean displacement of the end over that of finite elements; the error of all
    points, rms, over the largest displacement."""
    E, beyond, h = 4e5, 2, WIDTH/cells
    load, weight = (1e-4*E, 0) if sheared else (0, 1e-4*E/WIDTH)

    def place(p):
        q = p.copy()
        q[:, 0], q[:, 1] = _panel(p[:, 0]/cells, (p[:, 1] - beyond)/cells)
        q[:, 2] *= h
        return q

    n = (cells + beyond, cells + 2*beyond, *depth(kind))
    loads = {"surfaceLoads": {"end": {"traction": (0, load, 0), "normal": (1, 0, 0),
                                      "min": (WIDTH - 1.5*h, -1, -1)}}} if sheared else {}
    case = scene(f"cook {nu:.3f} {cells} {sheared} {turned}", kind, n, {"panel": {
        **_law(E, nu), "damping": {"type": "kinetic"}, **loads}},
        {"panel": {"min": (0, beyond, -1), "max": (cells, cells + beyond, 9)}},
        0.6, sides={"wall": (("x-",), HELD), **across(kind)}, size=1, place=place,
        gravity=(0, weight/RHO, 0), numerics={
            "transfer": "FLIP", "PICfraction": 0, "turnSides": turned})
    start, end = (case.points(t, "panel") for t in ("0", case.times()[-1]))
    X = start.byId("x")
    if sheared:
        V, shear = end.byId("V"), end.byId("sigma")[:, 1]
        middle = np.abs(X[:, 0]/WIDTH - 0.5) < 0.25
        load = np.sum((V*shear)[middle])/(0.5*WIDTH*RIGHT*h*(depth(kind) or (1,))[0])
    u = (end.byId("x") - X)[:, :2]
    exact = _displacement(E, nu, load, weight, X[:, :2])
    tip = X[:, 0] > WIDTH - h
    return (np.mean(u[tip, 1])/np.mean(exact[tip, 1]),
            np.sqrt(np.mean(np.sum((u - exact)**2, axis=1)))/np.max(np.abs(exact)))


def cook(table):
    # Of first order: 2 % at 32 cells, 4 % at 16
    runs = (("prisms", 1/3, 32, False), ("prisms", 0.499, 16, False), ("hexes", 1/3, 32, True),
            ("prisms", 0.499, 16, False, True), ("hexes", 1/3, 32, True, True))
    if VERIFY:
        runs += tuple((kind, nu, 16, sheared) for kind in ("hexes", "prisms", "tets")
                      for nu in (1/3, 0.499) for sheared in (False, True))
    for kind, nu, cells, sheared, *turned in runs:
        tip, rms = _cook(kind, nu, cells, sheared, *turned)
        name = f"Cook's membrane{', turnSides' if turned else ''}"
        label = (f"{name}, {kind}, {cells} cells across, nu {nu:.3f}, "
                 + ("sheared at its end" if sheared else "body force"))
        limit = 0.02*32/cells
        table.row(f"{label}: displacement of the end over that of finite elements", 1, tip,
                  limit)
        table.row(f"{label}: rms error of the displacement over the largest", 0, rms, limit,
                  "atMost")


PARTS = (beam, cook)
