#!/usr/bin/env python3
"""Free rigid bodies: mass, inertia, gravity, contact, nodes shared with others.

fall       a block alone falls: velocity and place of every step, work of gravity
tumble     a box of unequal sides turns without torque in 3D: angular momentum, shape;
           energy and place against Euler's equations at two time steps
wedge      along the axis of a wedge: momentum
bar        a rigid mass hits an elastic bar, with contact and with a shared velocity
           field: velocity V exp(-Z A t/M), stress at the face, momentum
collide    a rigid disc meets an elastic one off centre, and one that is half rigid:
           momentum; a restart bit by bit, 1 and 2 processors
slide      a rigid block slides on a slope, on a patch and on a rigid slab: Coulomb
roll       a rigid disc rolls, or slides, down a patch: 2/3 g sin
piston     a rigid piston between two gases: period, momentum, energy
"""

import os
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import (PROJECT, FoamCase, boxMesh, controlDict, foamText, noSchemes,
                      runParts, velocityFile)
from wedge import SECTOR, wedgeConditions, wedgeMesh

FLIP = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}
FMPM = {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2}
BALANCE = {"balance": {"type": "materialPointBalance", "libs": "(mpmFunctionObjects)",
                       "writeControl": "timeStep", "writeInterval": 1}}
ENERGY = {"energy": {"type": "materialPointEnergy", "libs": "(mpmFunctionObjects)",
                     "writeControl": "timeStep", "writeInterval": 1}}


def build(name, low, h, cells, phases, regions, control, numerics=FLIP, gravity=None,
          contact=None, patches=None):
    """Boxes of width h from low; sides in the directions of cells; patches: {name:
    sides} of the rest, all free."""
    case = FoamCase("freeBody", name.replace(",", "").replace(" ", "-"))
    D = len(cells)
    full = list(cells) + [1]*(3 - D)
    low = list(low) + [0]*(3 - D)
    own = patches or {}
    rest = [a + s for a in "xyz"[:D] for s in "-+"
            if a + s not in sum(own.values(), [])]
    sides = {**{p: ("patch", s) for p, s in own.items()}, "rest": ("patch", rest)}
    if D < 3:
        sides["empty"] = ("empty", [a + s for a in "xyz"[D:] for s in "-+"])
    case.write("system/blockMeshDict", boxMesh(
        low, [x + n*h for x, n in zip(low, full)], full, sides))
    case.write("constant/phaseProperties", {
        "phases": list(phases), **phases, **({"contact": contact} if contact else {})})
    for field in {p.get("velocityField", n) for n, p in phases.items()}:
        velocityFile(case, field, {p: "empty" if p == "empty" else "calculated"
                                   for p in sides})
    case.write("system/setMaterialPointsDict", {"regions": {
        r: {"phase": r, "pointsPerCell": 2, "type": "box", **entries}
        for r, entries in regions.items()}})
    case.write("system/fvSolution", {"materialPoints": {**numerics, "energyBudget": True}})
    noSchemes(case)
    case.write("system/controlDict", control)
    if gravity is not None:
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": gravity},
                   "uniformDimensionedVectorField")
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def balance(case, phase):
    """Time, mass, momentum, angular momentum, kinetic energy of a phase."""
    r = case.series("balance", f"{phase}.dat")
    return r[:, 0], r[:, 2], r[:, 3:6], r[:, 6:9], r[:, 9]


def body(velocity=(0, 0, 0), rho=1000, **more):
    field = {k: more.pop(k) for k in ("velocityField", "drag") if k in more}
    return {"type": "rigid", "rho": rho, **field,
            "motion": {"type": "free", "velocity": velocity, **more}}


def fall(table):
    g, v0, dt, n = np.array((0.3, -9.81, 0)), np.array((0.2, 1, 0)), 1e-3, 300
    for dim, place, held in ((1, "1D", ""), (2, "2D", ""), (3, "3D", ""),
                             (3, "3D with y and rotation held", "y rotation")):
        mask = (np.arange(3) < dim) & ~np.isin(list("xyz"), held.split())
        case = build(f"fall {place}", (-1, -1, -1)[:dim], 0.1, (20,)*dim,
                     {"block": body(v0*mask, constraints=f"({held})")},
                     {"block": {"min": (-0.2,)*dim + (0,)*(3 - dim),
                                "max": (0.1,)*dim + (0.1,)*(3 - dim)}},
                     controlDict(n*dt, n*dt, deltaT=dt, functions={**BALANCE, **ENERGY}),
                     gravity=g*(np.arange(3) < dim))
        case.run("materialPointFoam")
        t, m, P, _, K = balance(case, "block")
        exact = (v0 + np.outer(t, g))*mask
        table.row(f"fall {place}: velocity", 0,
                  np.abs(P/m[:, None] - exact).max()/np.abs(exact).max(), 1e-12)
        now, start = case.points(case.times()[-1], "block"), case.points("0", "block")
        T = n*dt
        way = (v0*T + 0.5*g*T**2)*mask
        table.row(f"fall {place}: place / way", 0,
                  np.abs((now.byId("x") - start.byId("x"))[:, :dim] - way[:dim]).max()
                  /np.abs(way).max(), 1e-12)
        table.row(f"fall {place}: mass / (rho V)", 1, m[0]/(1000*0.3**dim*0.1**(3 - dim)),
                  1e-12)
        work = re.findall(r"^Energy budget: transfer (\S+), .*external (\S+),", case.log(),
                          re.M)[-1]
        table.row(f"fall {place}: work of gravity / gain of kinetic energy", 1,
                  float(work[1])/(K[-1] - 0.5*m[0]*((v0*mask)**2).sum()), 1e-5)


def wedge(table):
    """A rigid cylinder flies along the axis of a wedge and hits an elastic one."""
    v, h = 1.0, 0.1
    ends = {n: ("patch", side) for n, side in
            (("left", "x-"), ("right", "x+"), ("outer", "r+"))}
    case = FoamCase("freeBody", "wedge")
    case.write("system/blockMeshDict", wedgeMesh((0, 0), (3, 0.8), (30, 8), ends))
    case.write("constant/phaseProperties", {
        "phases": "(ball rod)", "ball": body((v, 0, 0)),
        "rod": {"constitutiveModel": {"type": "neoHookean", "rho": 1000, "E": 1e6,
                                      "nu": 0.3}},
        "contact": {"all": {"type": "frictionless"}}})
    for field in ("ball", "rod"):
        velocityFile(case, field, wedgeConditions({p: "calculated" for p in ends}))
    case.write("system/setMaterialPointsDict", {"regions": {
        name: {"phase": name, "type": "box", "min": (low, -9, -9), "max": (high, 0.4, 9),
               "pointsPerCell": 2}
        for name, low, high in (("ball", 0.3, 0.7), ("rod", 0.75, 1.75))}})
    case.write("system/fvSolution", {"materialPoints": FLIP})
    noSchemes(case)
    case.write("system/controlDict", controlDict(0.3, 0.3, 0.3, functions=BALANCE))
    case.run("blockMesh")
    case.run("setMaterialPoints")
    case.run("materialPointFoam", limit=100)
    _, m, P, _, _ = balance(case, "ball")
    _, _, other, _, _ = balance(case, "rod")
    table.row("wedge: mass / that of the sector", 1,
              m[0]/(1000*0.4*0.5*0.4**2*SECTOR), 1e-12)
    table.row("wedge: change of momentum along the axis / m V", 0,
              np.abs((P + other)[:, 0]/(m[0]*v) - 1).max(), 1e-12)
    table.row("wedge: velocity across / V", 0, np.abs(P[:, 1:]).max()/(m[0]*v), 0)
    table.check("wedge: they have met", P[-1, 0] < 0.7*m[0]*v, f"{P[-1, 0]/(m[0]*v):.3g}")


def euler(I, w, T, n=20000):
    """Turn of a free body after T: its matrix Q, by Runge and Kutta's rule."""
    h = T/n
    L = I*w

    def rate(Q):
        spin = Q @ ((Q.T @ L)/I)
        return np.array(((0, -spin[2], spin[1]), (spin[2], 0, -spin[0]),
                         (-spin[1], spin[0], 0))) @ Q

    Q = np.eye(3)
    for _ in range(n):
        a = rate(Q)
        b = rate(Q + 0.5*h*a)
        c = rate(Q + 0.5*h*b)
        Q = Q + h/6*(a + 2*b + 2*c + rate(Q + h*c))
    return Q


def tumble(table):
    # Turns about the axis of the middle inertia, which is unstable
    side, w, T = np.array((0.8, 0.5, 0.2)), np.array((0.4, 5.0, 0.2)), 4.0
    square = side**2
    I = 1000*side.prod()/12*(square.sum() - square)
    Q = euler(I, w, T)
    errors, swings = [], []
    for dt in (4e-3, 2e-3):
        case = build(f"tumble {dt}", (-1, -1, -1), 0.1, (20, 20, 20),
                     {"box": body((0, 0, 0), angularVelocity=w)},
                     {"box": {"min": -side/2, "max": side/2}},
                     controlDict(T, T, deltaT=dt, functions=BALANCE))
        case.run("materialPointFoam", limit=300)
        _, m, P, L, K = balance(case, "box")
        if not errors:
            table.row("tumble: L at the start / (I w)", 0,
                      np.abs(L[0] - I*w).max()/np.abs(I*w).max(), 1e-12)
        table.row(f"tumble, dt {dt}: change of L / L", 0,
                  np.linalg.norm(L - L[0], axis=1).max()/np.linalg.norm(L[0]), 1e-13)
        table.row(f"tumble, dt {dt}: momentum / (m w length)", 0,
                  np.abs(P).max()/(m[0]*5*0.8), 1e-13)
        swings.append(np.abs(K/K[0] - 1).max())
        x0 = case.points("0", "box").byId("x")
        x = case.points(case.times()[-1], "box").byId("x")
        pick = np.random.default_rng(1).integers(0, len(x), (2, 2000))
        far = [np.linalg.norm(y[pick[0]] - y[pick[1]], axis=1) for y in (x0, x)]
        table.row(f"tumble, dt {dt}: change of distances / length", 0,
                  np.abs(far[1] - far[0]).max()/0.8, 1e-13)
        errors.append(np.abs(x - x0 @ Q.T).max()/0.8)
    print("tumble: error of place", errors, "swing of the energy", swings)
    table.row("tumble: order of the place in dt", 2, np.log2(errors[0]/errors[1]), 0.1)
    table.row("tumble: order of the energy in dt", 2, np.log2(swings[0]/swings[1]), 0.1)


def bar(table):
    rho, E, v, n, h = 1.0, 100.0, 0.01, 250, 0.1
    c, L = np.sqrt(E/rho), n*h
    Z = rho*c
    M, width = 0.4*rho*L, 10*h
    tau = M/Z
    for label, shared, numerics, give in (
            ("contact, FMPM 2", False, FMPM, False),
            ("contact, FLIP", False, FLIP, False),
            ("one field, FMPM 2", True, FMPM, False),
            ("one field, FLIP", True, FLIP, False),
            ("contact, mass given", False, FMPM, True)):
        field = {"velocityField": "solids"} if shared else {}
        mass = {"mass": M*h*h} if give else {}
        end = 1.9*L/c
        probes = {"face": {
            "type": "materialPointProbes", "libs": "(mpmFunctionObjects)", "phase": "bar",
            "fields": ["sigma_xx"], "operation": "mean",
            "points": {"box": f"({2*h} -1 -1) ({3*h} 1 1)"},
            "writeControl": "timeStep", "writeInterval": 1}}
        case = build(
            f"bar {label}", (-30*h,), h, (n + 60,),
            {"mass": body((v, 0, 0), M/width if not give else 1.0, **field, **mass),
             "bar": {"constitutiveModel": {"type": "linearElastic", "rho": rho, "E": E,
                                           "nu": 0}, **field}},
            {"mass": {"min": (-width, 0, 0), "max": (0, h, h)},
             "bar": {"min": (0, 0, 0), "max": (L, h, h)}},
            controlDict(end, end, 0.4, functions={**BALANCE, **probes}), numerics,
            contact=None if shared else {"face": {"type": "frictionless"}})
        case.run("materialPointFoam", limit=300)
        t, m, P, _, _ = balance(case, "mass")
        _, _, other, _, _ = balance(case, "bar")
        if give:
            table.row(f"bar, {label}: mass", M*h*h, m[0], 1e-12, "relative")
        table.row(f"bar, {label}: momentum of both", 0,
                  np.abs((P + other)[:, 0]/(m[0]*v) - 1).max(), 1e-12)
        table.row(f"bar, {label}: velocity of the mass / V - exp(-t/tau)", 0,
                  np.abs(P[:, 0]/(m[0]*v) - np.exp(-t/tau)).max(), 0.01)
        s = case.series("face", "sigma_xx.dat")
        late = (s[:, 0] > 20*h/c) & (s[:, 0] < 1.8*L/c)
        exact = -Z*v*np.exp(-(s[late, 0] - 2.5*h/c)/tau)
        error = s[late, 1] - exact
        print(f"bar, {label}: largest error of the stress {np.abs(error).max()/(Z*v):.4f},"
              f" mean {np.abs(error).mean()/(Z*v):.4f}")
        residual = np.array(re.findall(r"remap (\S+), residual (\S+)", case.log()),
                            float).sum(axis=1)
        if numerics is FLIP:
            # The filter of the strain of FMPM is in remap
            table.row(f"bar, {label}: energy residual / kinetic energy", 0,
                      np.abs(residual).max()/(0.5*m[0]*v**2), 0.01)
        else:
            # FLIP rings behind the front
            # Where the mass sticks to a cell of the bar it rings a little
            kind = "mean" if shared else "largest"
            table.row(f"bar, {label}: stress at the face, {kind} error / (Z V)", 0,
                      getattr(np.abs(error), "mean" if shared else "max")()/(Z*v), 0.01)


def collideCase(name, kind, end, writeInterval, numerics=FLIP):
    """A rigid ball meets an elastic disc, or a block whose upper half is a rigid body
    in the velocity field of the lower."""
    h = 0.05
    phases = {"ball": body((1, 1, 0), angularVelocity=(0, 0, 3), velocityField="a"),
              "disc": {"velocityField": "b", "constitutiveModel": {
                  "type": "neoHookean", "rho": 1000, "E": 1e5, "nu": 0.3}}}
    regions = {"ball": {"type": "sphere", "centre": (0.2, 0.27, 0), "radius": 0.15,
                        "pointsPerCell": 4},
               "disc": {"type": "sphere", "centre": (0.6, 0.55, 0), "radius": 0.2,
                        "pointsPerCell": 4, "velocity": (-1, -1, 0)}}
    if kind == "half rigid":
        phases["core"] = body((-1, -1, 0), velocityField="b")
        regions["disc"] = {"min": (0.45, 0.4, 0), "max": (0.8, 0.5, h),
                           "velocity": (-1, -1, 0)}
        regions["core"] = {"min": (0.45, 0.5, 0), "max": (0.8, 0.7, h)}
    control = controlDict(end, writeInterval, 0.3, functions=BALANCE)
    control["startFrom"] = "latestTime"
    return build(name, (-0.3, -0.3), h, (32, 32), phases, regions, control, numerics,
                 contact={"all": {"type": "Coulomb", "mu": 0.3}})


def sums(case, phases):
    P = sum(balance(case, p)[2] for p in phases)
    L = sum(balance(case, p)[3] for p in phases)
    m = sum(balance(case, p)[1] for p in phases)[0]
    return P/m, L/m


def collide(table):
    for kind in ("elastic", "half rigid"):
        phases = ("ball", "disc") + (("core",) if kind == "half rigid" else ())
        for label, numerics in (("FLIP", FLIP), ("FMPM 2", FMPM)):
            case = collideCase(f"collide {kind} {label}", kind, 0.4, 0.1, numerics)
            case.run("materialPointFoam", limit=300)
            name = f"collide, {kind}, {label}"
            P, L = sums(case, phases)
            table.row(f"{name}: change of momentum / (m V)", 0,
                      np.abs(P - P[0]).max(), 1e-12)
            first, last = (balance(case, "ball")[2][i] for i in (0, -1))
            table.check(f"{name}: they have met",
                        np.linalg.norm(last - first) > 0.3*np.linalg.norm(first),
                        f"{np.linalg.norm(last - first)/np.linalg.norm(first):.3g}")
            print(f"{name}: change of angular momentum {np.abs(L - L[0]).max():.3g} m V")
        case = collideCase(f"restart {kind}", kind, 0.4, 0.1)
        case.run("materialPointFoam", limit=300)
        times = [t for t in case.times() if t != "0"]
        again = collideCase(f"restart {kind} from {times[1]}", kind, 0.4, 0.1)
        shutil.copytree(case.file(times[1]), again.file(times[1]))
        again.run("materialPointFoam", limit=300)
        columns = ("x", "U", "sigma", "V")
        table.row(f"collide, {kind}: restart, largest difference", 0,
                  case.largestDifference(again, times[-1], phases, columns), 0, "atMost")
        two = collideCase(f"two {kind}", kind, 0.4, 0.1)
        two.decompose((2, 1, 1))
        two.runParallel(limit=300)
        table.row(f"collide, {kind}: 2 processors, largest difference", 0,
                  case.largestDifference(two, times[-1], phases, columns), 1e-11, "atMost")


def slide(table):
    g, slope, h = 9.81, np.radians(30), 0.1
    gravity = g*np.array((np.sin(slope), -np.cos(slope), 0))
    for floor in ("patch", "slab"):
        for mu in (0.0, 0.3, 0.8):
            end = 0.6
            phases = {"block": body(rho=1000)}
            regions = {"block": {"min": (0.5, 0, 0), "max": (1.1, 0.4, h)}}
            contact, low = {"fields": "(block)", "patch": "floor", "type": "Coulomb",
                            "mu": mu}, 0
            if floor == "slab":
                phases["slab"] = {"type": "rigid", "rho": 1000}
                low = -2*h
                regions["slab"] = {"min": (0, low, 0), "max": (4, 0, h)}
                contact = {"fields": "(block slab)", "type": "Coulomb", "mu": mu}
            case = build(f"slide {floor} {mu}", (0, low), h, (40, 10), phases, regions,
                         controlDict(end, end, deltaT=1e-3, functions=BALANCE), FLIP,
                         gravity, {"slope": contact}, {"floor": ["y-"]})
            case.run("materialPointFoam", limit=300)
            t, m, P, L, _ = balance(case, "block")
            exact = max(0.0, g*(np.sin(slope) - mu*np.cos(slope)))
            name = f"slide on a {floor}, mu {mu}"
            if exact > 0:
                table.row(f"{name}: velocity / a t", 1, P[-1, 0]/m[-1]/(exact*t[-1]), 0.01)
            else:
                table.row(f"{name}: velocity / g t", 0, P[-1, 0]/m[-1]/(g*t[-1]), 1e-4)
            table.row(f"{name}: velocity into the floor / g t", 0,
                      P[-1, 1]/m[-1]/(g*t[-1]), 1e-4)


def roll(table):
    """A disc rolls down a patch, and with too little friction slides."""
    g, slope, h, R, end = 9.81, np.radians(20), 0.1, 0.4, 0.8
    gravity = g*np.array((np.sin(slope), -np.cos(slope), 0))
    M = 500*np.pi*R**2*h
    rolling = 2/3*g*np.sin(slope)
    for label, how, exact in (
            ("stick", {"type": "stick"}, rolling),
            ("mu 0.5", {"type": "Coulomb", "mu": 0.5}, rolling),
            ("mu 0.05", {"type": "Coulomb", "mu": 0.05},
             g*(np.sin(slope) - 0.05*np.cos(slope)))):
        case = build(
            f"roll {label}", (0, 0), h, (24, 12),
            {"disc": body(rho=500, mass=M, inertia=0.5*M*R**2)},
            {"disc": {"type": "sphere", "centre": (0.6, R, 0.5*h), "radius": R,
                      "pointsPerCell": 8}},
            controlDict(end, end, deltaT=5e-4, functions=BALANCE), FLIP, gravity,
            {"floor": {"fields": "(disc)", "patch": "floor", **how}}, {"floor": ["y-"]})
        case.run("materialPointFoam", limit=300)
        t, m, P, _, K = balance(case, "disc")
        v = P[:, 0]/m[0]
        table.row(f"roll on a patch, {label}: velocity / a t", 1, v[-1]/(exact*t[-1]), 0.01)
        if how["type"] == "stick":
            work = [float(w) for w in re.findall(r"contact (\S+), .*residual", case.log())]
            left = np.array(re.findall(r"remap (\S+), residual (\S+)", case.log()),
                            float).sum(axis=1)
            table.row("roll on a patch, stick: work of contact / kinetic energy at the end", 0,
                      np.abs(work).max()/K[-1], 0.01)
            table.row("roll on a patch, stick: energy residual / kinetic energy at the end", 0,
                      np.abs(left).max()/K[-1], 0.01)
        print(f"roll on a patch, {label}: spin energy / translation"
              f" {K[-1]/(0.5*m[0]*v[-1]**2) - 1:.4f}, velocity across"
              f" {np.abs(P[:, 1]).max()/m[0]:.2e}")


def piston(table):
    """tutorials/freePiston with a rigid slab."""
    gamma, p0, rho0, speed = 1.4, 1e5, 1e5/(287*290), 0.9
    c0, L, b, rho, n = np.sqrt(gamma*p0/rho0), 0.45, 0.1, 27.0, 100
    low, high = 1e-6, 0.5*np.pi*c0/L
    for _ in range(200):
        w = 0.5*(low + high)
        low, high = (w, high) if rho*b*w*np.tan(w*L/c0) < 2*rho0*c0 else (low, w)
    period = 2*np.pi/w
    for drag in ("stick", "none"):
        case = FoamCase("freeBody", f"piston-{drag}",
                        os.path.join(PROJECT, "tutorials/freePiston"))
        case.run("./Allclean")
        case.write("constant/phaseProperties", {
            "phases": "(air slab)",
            "air": {"type": "gas", "thermo": "perfectGas", "R": 287, "gamma": gamma},
            "slab": body((speed, 0, 0), rho, drag={"type": drag})})
        case.write("system/setMaterialPointsDict", {"regions": {"slab": {
            "phase": "slab", "type": "box", "min": (L, 0, 0), "max": (L + b, 0.01, 0.01),
            "pointsPerCell": 4}}})
        x = (np.arange(n) + 0.5)/n
        u = np.where(abs(x - 0.5) < b/2, 1,
                     np.sin(w*np.minimum(x, 1 - x)/c0)/np.sin(w*L/c0))
        case.write("0/U.air", {
            "dimensions": "[0 1 -1 0 0 0 0]",
            "internalField": f"nonuniform List<vector> {n} "
                             + foamText([(speed*v, 0, 0) for v in u]),
            "boundaryField": {"walls": {"type": "slip"}, "frontAndBack": {"type": "empty"}}},
            "volVectorField")
        case.change("system/fvSchemes", r"(reconstruct\((rho|p)\) +)upwind", r"\1vanLeer")
        case.change("system/fvSchemes", r"(reconstruct\(U\) +)upwind", r"\1vanLeerV")
        case.change("system/fvSolution", "shapeFunction", "energyBudget yes; shapeFunction")
        case.run("blockMesh")
        case.run("setMaterialPoints")
        case.run("materialPointFoam", limit=300)
        t, m, P, _, K = balance(case, "slab")
        v = P[:, 0]/m
        i = np.nonzero(v[:-1]*v[1:] < 0)[0]
        zero = t[i] - v[i]*(t[i + 1] - t[i])/(v[i + 1] - v[i])
        got = 2*np.polyfit(np.arange(len(zero)), zero, 1)[0]
        table.row(f"piston, {drag}: period / exact", 1, got/period, 2e-3)
        mixture = case.series("balance", "mixture.dat")
        table.row(f"piston, {drag}: momentum of gas and piston that is missing / m V", 0,
                  np.abs(mixture[:, -3]).max()/(m[0]*speed), 1e-12)
        residual = sum(np.array(re.findall(rf"{name} ([^\s,]+)", case.log()), float)
                       for name in ("remap", "residual"))
        table.row(f"piston, {drag}: energy residual / kinetic energy", 0,
                  np.abs(residual).max()/K[0], 0.005)
        last = t > t[-1] - period
        print(f"piston, {drag}: {len(zero)} half periods, velocity kept"
              f" {np.abs(v[last]).max()/speed:.4f}")


def main():
    return runParts("freeBody", fall, tumble, wedge, bar, collide, slide, roll, piston)


if __name__ == "__main__":
    sys.exit(main())
