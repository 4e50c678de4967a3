#!/usr/bin/env python3
"""The condition farField of p and U: what comes back of waves that leave.

    tubes     the difference of the pressure to that of a tube four times as long, a tenth
              of the length or more away from the outlet, over the wave's amplitude there:
              shocks, a pulse, a blast behind a wall in a perfect gas; shocks of 1 MPa and
              1 GPa in water; two gases, whose contact leaves; air on water; bubbles. At most
              2 % (asked of outlets); beside waveTransmissive (MPM_VERIFY=1: zeroGradient and a
              fixed pressure, too, for comparison)
    oblique   plane waves under an angle a: linear theory (1 - cos a)/(1 + cos a), and less
              with a source
    layers    farField with a layer, on three meshes: plane waves, round ones beside a corner and
              bubbles; at most 2 % (5 % of bubbles) as asked of outlets; beside it without a layer
    blast     in a quarter of a disc; then the mean pressure comes back
    rest      water and air under gravity, the far field that of the start, without
              and with points
    whole     processors and restart, with points that touch the outlet too
    wedge     a burst in an axisymmetric box, until all is quiet
"""

import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from coupledCases import ambient, coupledCase
from fluidCases import AIR, WATER, besidePoints, fluidCase, fluidField
from foamCase import VERIFY, RunFailed, runParts
from gasCases import UPWIND, WALL, gasCase, volField, writeVolField
from wedge import wedgeMesh

OPEN = ("zeroGradient",)*3
CONDITIONS = ("farField", "waveTransmissive", "zeroGradient", "fixedValue")


def outlet(kind, p=1.0, u=(0, 0, 0), ofT="zeroGradient", fluids=False, gamma=1.4, source=None,
           layer=None):
    """Conditions of p, T, U."""
    if kind == "farField":
        more = {**({"source": source} if source else {}), **({"layer": layer} if layer else {})}
        return ({"type": "farField", "farValue": f"uniform {p!r}", **more}, ofT,
                {"type": "farField", "farValue": "uniform ({} {} {})".format(*u)})
    if kind == "waveTransmissive":
        of = "" if fluids else ".air"
        return ({"type": kind, "phi": "phi" + of, "psi": "psi" + of, "gamma": gamma,
                 "fieldInf": p, "lInf": 1, "value": f"uniform {p!r}"}, *OPEN[1:])
    if kind == "fixedValue":
        return ({"type": kind, "value": f"uniform {p!r}"}, *OPEN[1:])
    return OPEN


def shock(p, rho, ratio, gamma=1.4, pInf=0.0):
    """rho, u, p behind a shock, and its speed: perfect or stiffened gas at rest."""
    a, b = p + pInf, ratio*p + pInf
    r = b/a
    m = np.sqrt(rho*((gamma + 1)/2*b + (gamma - 1)/2*a))
    return (rho*((gamma + 1)*r + gamma - 1)/((gamma - 1)*r + gamma + 1), (b - a)/m,
            ratio*p), m/rho


def history(case):
    """All written pressures."""
    times = [t for t in case.times() if float(t) > 0]
    return {t: volField(case, t, "p") for t in times}


def steps(end, dt, writes=30):
    return {"adjustTimeStep": False, "deltaT": dt, "writeControl": "timeStep",
            "writeInterval": max(1, int(round(end/dt/writes)))}


# --- tubes -------------------------------------------------------------------

def tube(name, length, n, initial, end, dt, inlet, out, fluids=None, thermo=None):
    cells, high = (int(n*length), 1, 1), (length, 0.01, 0.01)
    if fluids:
        case = fluidCase("outlets", name, cells, high, fluids, initial, end,
                         patches={"ends": ("patch", ("x-",)), "sides": ("patch", ("x+",))},
                         ends=inlet, sides=out, control=steps(end, dt))
    else:
        case = gasCase("outlets", name, cells, high, initial, end, thermo=thermo,
                       patches={"inlet": ("patch", ("x-",)), "outlet": ("patch", ("x+",))},
                       conditions={"inlet": inlet, "outlet": out}, control=steps(end, dt))
    case.run("materialPointFoam")
    return history(case)


def front(ratio, start=0.5):
    state, speed = shock(1.0, 1.0, ratio)

    def initial(x, y, z):
        return [np.where(x < start, a, b) for a, b in zip(state, (1.0, 0.0, 1.0))]
    return initial, 0.5/speed + 0.45, 0.3/(speed + 1)


def simpleWave(size, middle, width):
    """A simple wave to the right."""
    def initial(x, y, z):
        p = 1 + size*np.exp(-((x - middle)/width)**2)
        rho = p**(1/1.4)
        return rho, 5*(np.sqrt(1.4*p/rho) - np.sqrt(1.4)), p
    return initial


def hot(x, y, z):
    on = x < 0.1
    return np.where(on, 5., 1.), 0*x, np.where(on, 20., 1.)


def ofWater(ratio, fluids):
    state, speed = shock(1e5, 1000., ratio, 4.4, 6e8)

    def initial(x, y, z):
        rho, u, p = (np.where(x < 0.5, a, b) for a, b in zip(state, (1000., 0., 1e5)))
        return ([1 + 0*x], [rho], u, p) if fluids else (rho, u, p)
    return initial, 0.5/speed + 0.4/1700, 0.3/(speed + state[1])


def contact(x, y, z):
    """A heavy gas pushes air out, and leaves."""
    heavy = 1.0*(x < 0.6)
    return [heavy, 1 - heavy], [6. + 0*x, 1.2 + 0*x], 0*x, np.where(x < 0.6, 4e5, 1e5)


def airOnWater(x, y, z):
    water = 1.0*(x > 0.4)
    return [water, 1 - water], [1000. + 0*x, 1.2 + 0*x], 0*x, np.where(x < 0.4, 2e6, 1e5)


def bubbles(x, y, z):
    p = 1e5*(1 + 0.02*np.exp(-((x - 0.3)/0.08)**2))
    return [0.99 + 0*x, 0.01 + 0*x], [1000. + 0*x, 1.2*(p/1e5)**(1/1.4)], 0*x, p


WATER_GAS = {"rho": 1000, "equationOfState": WATER["equationOfState"]}
FIXED = {"type": "fixedValue", "value": "uniform 1"}
INLET = {"type": "inletOutlet", "phi": "phi.air", "inletValue": "uniform 1", "value": "uniform 1"}


def tubes(table):
    n = 200
    scenes = [(f"shock of ratio {r}", *front(r), 1.0, OPEN, {}, 0.02) for r in (1.1, 2, 4, 10)]
    scenes += [("pulse of 1 %", simpleWave(0.01, 0.5, 0.08), 0.8, 0.25, 1.0, OPEN, {}, 0.02),
               ("pulse of 200 %", simpleWave(2, 0.3, 0.1), 1.2, 0.07, 1.0, OPEN, {}, 0.02),
               ("blast", hot, 1.6, 0.06, 1.0, WALL, {}, 0.02),
               ("blast, T fixed", hot, 1.6, 0.06, 1.0, WALL, {"ofT": FIXED}, 0.02),
               ("shock of ratio 2, T inletOutlet", *front(2), 1.0, OPEN, {"ofT": INLET}, 0.02)]
    for size, ratio in (("1 MPa", 11.0), ("1 GPa", 1e4)):
        for fluids in (None, {"water": WATER}):
            scenes.append((f"water, {'type fluid' if fluids else 'type gas'}, shock of {size}",
                           *ofWater(ratio, fluids), 1e5, OPEN,
                           {"fluids": fluids} if fluids else {"thermo": WATER_GAS}, 0.02))
    two = {"fluids": {"heavy": AIR, "air": AIR}}
    mixed = {"fluids": {"water": WATER, "air": AIR}}
    scenes += [("two gases, the contact leaves", contact, 2.5e-3, 0.3/900, 1e5, WALL, two, 0.02),
               ("air on water", airOnWater, 8e-4, 0.3/2000, 1e5, WALL, mixed, 0.02),
               ("1 % of bubbles, pulse of 2 %", bubbles, 1.2e-2, 0.3/1700, 1e5, WALL, mixed,
                0.02)]
    for label, initial, end, step, p0, inlet, more, limit in scenes:
        name = label.replace(" ", "-").replace(",", "").replace("%", "")
        more = dict(more)
        ofT = more.pop("ofT", "zeroGradient")
        long = tube(name + "-long", 4, n, initial, end, step/n, inlet, OPEN, **more)
        amplitude = max(p[n - 1] for p in long.values()) - p0
        back = {}
        # A few show what waveTransmissive does
        beside = label in ("shock of ratio 2", "pulse of 1 %", "water, type gas, shock of 1 MPa")
        for kind in CONDITIONS if VERIFY else CONDITIONS[:1 + beside]:
            condition = outlet(kind, p0, ofT=ofT, fluids="fluids" in more,
                               gamma=1.0 if "thermo" in more or "fluids" in more else 1.4)
            try:
                short = tube(f"{name}-{kind}", 1, n, initial, end, step/n, inlet, condition,
                             **more)
            except RunFailed:
                if kind == "farField":
                    raise
                continue
            back[kind] = max(np.max(abs(short[t] - long[t][:n])[:9*n//10])
                             for t in short)/amplitude
        print(f"{label}: " + ", ".join(f"{k} {100*v:.3g} %" for k, v in back.items()))
        table.row(f"{label}: reflected", 0, back["farField"], limit, "atMost")
        if beside:
            table.row(f"{label}: what waveTransmissive reflects over that", 10,
                      back["waveTransmissive"]/back["farField"], 10, "atLeast")


# --- plane -------------------------------------------------------------------

def plane(name, n, high, initial, end, dt, out, rest, cyclic):
    sides = ({"left": ("cyclic", ("x-",), "right"), "right": ("cyclic", ("x+",), "left"),
              "rest": ("patch", ("y-",)), "outlet": ("patch", ("y+",))} if cyclic else
             {"rest": ("patch", ("x-", "y-")), "outlet": ("patch", ("x+", "y+"))})
    case = gasCase("outlets", name, (round(n*high[0]), round(n*high[1]), 1), (*high, 0.01), initial,
                   end, patches=sides, control=steps(end, dt, 20),
                   conditions={"rest": rest, "outlet": out, "left": ("cyclic",)*3,
                               "right": ("cyclic",)*3})
    case.run("materialPointFoam")
    return {t: p.reshape(-1, round(n*high[0])) for t, p in history(case).items()}


def oblique(table):
    """Trains of waves, so long that one has gone before the next."""
    n, end = 60, 0.6
    for degrees in (0, 30, 45):
        a = np.radians(degrees)
        d = np.array([np.sin(a), np.cos(a)])
        period = max(d[0], 0.5)

        def initial(x, y, z):
            s = x*d[0] + (y - 0.6)*d[1]
            if degrees:
                s = (s + period/2) % period - period/2
            p = 1 + 0.01*np.exp(-(s/0.06)**2)
            rho = p**(1/1.4)
            u = 5*(np.sqrt(1.4*p/rho) - np.sqrt(1.4))
            return rho, np.column_stack([u*d[0], u*d[1], 0*u]), p
        width, dt = period/d[0] if degrees else 0.5, 0.25/n/1.3
        long = plane(f"plane-{degrees}-long", n, (width, 2), initial, end, dt, OPEN, OPEN, True)
        theory = (1 - d[1])/(1 + d[1])
        size = max(p[n - 1].max() for p in long.values()) - 1
        back = {}
        for kind, source in (("farField", None), ("with a source", (-1e3*d[0], -1e3*d[1], 0)),
                             *VERIFY*(("waveTransmissive", None), ("zeroGradient", None))):
            out = outlet("farField" if source else kind, source=source)
            short = plane(f"plane-{degrees}-{kind.replace(' ', '-')}", n, (width, 1), initial,
                          end, dt, out, OPEN, True)
            back[kind] = max(np.max(abs(short[t] - long[t][:n])[:9*n//10])
                             for t in short)/size
        print(f"{degrees} degrees: theory {100*theory:.3g} %, "
              + ", ".join(f"{k} {100*v:.3g} %" for k, v in back.items()))
        table.row(f"plane wave, {degrees} degrees: reflected", theory, back["farField"], 0.02)
        table.row(f"plane wave, {degrees} degrees, source: reflected", 0,
                  back["with a source"], 0.02, "atMost")


# --- layers ---

LAYER = 0.25


def back(long, short, n):
    """What comes back, a tenth of the length or more away from the patch."""
    return max(np.max(abs(short[t][:n, :n] - long[t][:n, :n])[:9*n//10, :9*n//10])
               for t in short)


def packet(degrees, n):
    """A train of plane waves that ends before the patch at the start: long, {layer: short}."""
    a = np.radians(degrees)
    d = np.array([np.sin(a), np.cos(a)])
    period = max(d[0], 0.5)
    width, end, dt = (period/d[0] if degrees else 0.5), 0.9, 0.25/n/1.3

    def initial(x, y, z):
        s = x*d[0] + (y - 0.6)*d[1]
        if degrees:
            s = (s + period/2) % period - period/2
        p = 1 + 0.005*np.exp(-(s/0.06)**2)*(1 - np.tanh((y - 0.65)/0.12))
        rho = p**(1/1.4)
        u = 5*(np.sqrt(1.4*p/rho) - np.sqrt(1.4))
        return rho, np.column_stack([u*d[0], u*d[1], 0*u]), p

    def run(name, high, out):
        of = plane(f"packet-{degrees}-{n}-{name}", n, (width, high), initial, end, dt, out, OPEN,
                   True)
        # As high as wide, so that back() leaves nothing out
        return {t: np.tile(p, (1, 2*n))[:, :2*n] for t, p in of.items()}
    return (run("long", 2, OPEN),
            {layer: run(f"layer-{layer}", 1 + layer, outlet("farField", layer=layer))
             for layer in (0, LAYER)})


def roundWave(strong, n):
    """A burst beside the corner of two patches, whose other sides are walls."""
    def initial(x, y, z):
        r = np.hypot(x - 0.75, y - 0.75)
        if strong:
            return np.where(r < 0.1, 5., 1.), 0*x, np.where(r < 0.1, 20., 1.)
        p = 1 + 0.01*np.exp(-(r/0.1)**2)
        return p**(1/1.4), 0*x, p
    end, dt = 1.5, (0.2/5 if strong else 0.25/1.3)/n
    tag = f"corner-{'strong' if strong else 'weak'}-{n}"
    return (plane(f"{tag}-long", n, (2, 2), initial, end, dt, OPEN, WALL, False),
            {layer: plane(f"{tag}-layer-{layer}", n, (1 + layer, 1 + layer), initial, end, dt,
                          outlet("farField", layer=layer), WALL, False)
             for layer in (0, LAYER)})


def bubbleTube(n):
    more = {"fluids": {"water": WATER, "air": AIR}}
    end, step = 1.2e-2, 0.3/1700

    def run(name, length, out):
        of = tube(f"layer-bubbles-{n}-{name}", length, n, bubbles, end, step/n, WALL, out, **more)
        return {t: np.tile(p[:, None], (1, n)) for t, p in of.items()}
    return (run("long", 4, OPEN),
            {layer: run(layer, 1 + layer, outlet("farField", 1e5, fluids=True, layer=layer))
             for layer in (0, LAYER)})


def layers(table):
    scenes = [(f"plane wave, {a} degrees", lambda n, a=a: packet(a, n), 1.0, 0.02)
              for a in (0, 30, 45, 60)]
    scenes += [("round wave beside a corner", lambda n: roundWave(False, n), 1.0, 0.02),
               ("1 % of bubbles", bubbleTube, 1e5, 0.05)]
    for label, runs, p0, limit in scenes:
        for n in (40, 60, 80):
            long, short = runs(n)
            size = max(max(p[n - 1, :n].max(), p[:n, n - 1].max()) if "round" in label
                       else p[n - 1].max() for p in long.values()) - p0
            without, with_ = (back(long, short[k], n)/size for k in (0, LAYER))
            print(f"{label}, {n} cells: layer {100*with_:.3g} %, without {100*without:.3g} %")
            table.row(f"{label}, layer, {n} cells: reflected", 0, with_, limit, "atMost")
    long, short = roundWave(True, 40)
    size = max(max(p[39, :40].max(), p[:40, 39].max()) for p in long.values()) - 1
    without, with_ = (back(long, short[k], 40)/size for k in (0, LAYER))
    print(f"burst of 20 beside a corner: layer {100*with_:.3g} %, without {100*without:.3g} %")


# --- blast -------------------------------------------------------------------

def blast(table):
    """A hot corner of a disc. With VERIFY what comes back while the wave leaves, by the mesh
    three times as large; the mean pressure, for long."""
    n, end = 50 if VERIFY else 25, 1.6
    dt = 0.2/n/5

    def initial(x, y, z):
        on = np.hypot(x, y) < 0.2
        return np.where(on, 5., 1.), 0*x, np.where(on, 20., 1.)
    if VERIFY:
        long = plane("blast-long", n, (3, 3), initial, end, dt, OPEN, WALL, False)
        size = max(p[n - 1, 0] for p in long.values()) - 1
        for kind in ("farField", "with a source", "waveTransmissive", "zeroGradient"):
            out = outlet("farField", source=(0, 0, 0)) if " " in kind else outlet(kind)
            short = plane(f"blast-{kind}".replace(" ", "-"), n, (1, 1), initial, end, dt, out,
                          WALL, False)
            print(f"blast in 2D: {kind} %.3g %%" % (100/size*max(
                np.max(abs(short[t] - long[t][:n, :n])[:9*n//10, :9*n//10]) for t in short)))
    for kind in ("farField", *VERIFY*("zeroGradient",)):
        mean = plane(f"blast-mean-{kind}", n, (1, 1), initial, 40, 0.3/n/5, outlet(kind), WALL,
                     False)
        last = [p.mean() - 1 for p in mean.values()]
        print(f"blast in 2D, {kind}: mean pressure less 1 at t = 10, 20, 40: "
              + " ".join(f"{last[i]:.2g}" for i in (4, 9, -1)))
        if kind == "farField":
            table.row("blast in 2D, after 47 times the length over c: mean pressure over that "
                      "far away", 1, 1 + last[-1], 1e-3)


# --- rest --------------------------------------------------------------------

def rest(table):
    """Water below air in a box with far fields at its sides and top, of the start."""
    n, g = 24, 9.81

    def initial(x, y, z):
        ys = np.unique(y)
        a = np.where(ys < 0.5, 1.0, 0.0)
        a[n//2] = 0.3
        rho = a*1000 + (1 - a)*1.2
        p = 1e5 + np.append(np.cumsum((g/n*0.5*(rho[1:] + rho[:-1]))[::-1])[::-1], 0)
        i = np.searchsorted(ys, y - 1e-9)
        return [a[i], 1 - a[i]], [1000.0, 1.2], 0.0, p[i]
    far = ({"type": "farField"}, "zeroGradient",
           {"type": "farField", "farValue": "uniform (0 0 0)"})
    air = {"thermo": "perfectGas", "R": 287, "gamma": 1.4}
    dt, end = 4e-6, 4e-3
    for label in ("fluids", "fluids, 2 processors", "fluids in a layer"):
        far[0]["layer"] = 0.2
        if "layer" not in label:
            del far[0]["layer"]
        case = fluidCase("outlets", "rest-" + label.replace(" ", "-").replace(",", ""),
                         (n, n, 1), (1, 1, 0.01), {"water": WATER, "air": air}, initial, end,
                         patches={"ends": ("patch", ("x-", "x+", "y+")),
                                  "sides": ("patch", ("y-",))}, ends=far, gravity=(0, -g, 0),
                         control={"deltaT": dt, "adjustTimeStep": False})
        if "2" in label:
            for name in ("p", "U"):
                with open(case.file("0", name)) as f:
                    text = f.read()
                value = "uniform 1e5" if name == "p" else "uniform (0 0 0)"
                with open(case.file("0", name), "w") as f:
                    f.write(text.replace("farField;", f"farField;\n value {value};"))
            case.decompose((2, 1, 1))
            case.runParallel()
        else:
            case.run("materialPointFoam")
        table.row(f"rest of {label} with far fields, 1000 steps: largest velocity [m/s]", 0,
                  np.max(abs(volField(case, "0.004", "U"))), 1e-8)


# --- the whole ---------------------------------------------------------------

def burst(name, control=None, split=None, before=lambda case: None, points=False, gas=False):
    """A hot disc in a box, far fields at two sides, with points also layers. (Later
    rounding has grown in the fluids' vortices, with any outlet.)"""
    def initial(x, y, z):
        on = np.hypot(x - 0.6, y - 0.5) < 0.2
        p = np.where(on, 5., 1.)
        rho = 1 + 0*x
        if gas:
            return rho, 0*x, p
        heavy = 1.0*(x < 0.3)
        return [heavy, 1 - heavy], [3*rho, rho], 0*x, p
    far = ({"type": "farField", "farValue": "uniform 1", "value": "uniform 1",
            **({"layer": 0.25} if points else {})},
           {"type": "inletOutlet", "phi": "phi.air" if gas else "phi", "inletValue": "uniform 1",
            "value": "uniform 1"},
           {"type": "farField", "farValue": "uniform (0 0 0)", "value": "uniform (0 0 0)"})
    of = {"ends": far, "sides": WALL}
    control = {"startFrom": "latestTime", **(control or {})}
    cells, high, end = (24, 24, 1), (1, 1, 0.1), 0.25
    if points:
        body = {"constitutiveModel": {"type": "linearElastic", "rho": 50, "E": 1e4, "nu": 0}}
        region = {"type": "box", "min": (0.7, 0.3, -1), "max": (1, 0.6, 1), "stress": ambient(1)}
        if gas:
            case = coupledCase("outlets", name, cells, high, initial, end, {"body": body},
                               {"body": region}, control=control, **of)
        else:
            case = fluidCase("outlets", name, cells, high, {"heavy": AIR, "air": AIR}, initial,
                             end, control={**control, "maxCo": 0.4}, reconstruct=UPWIND, **of)
            besidePoints(case, {"heavy": AIR, "air": AIR}, {"body": body}, {"body": region})
    elif gas:
        case = gasCase("outlets", name, cells, high, initial, end, control=control, **of)
    else:
        case = fluidCase("outlets", name, cells, high, {"heavy": AIR, "air": AIR}, initial, end,
                         control=control, **of)
    if not gas:
        # What comes in is air
        with open(case.file("0/alpha.heavy")) as f:
            text = f.read()
        with open(case.file("0/alpha.heavy"), "w") as f:
            f.write(text.replace("inletValue uniform 1", "inletValue uniform 0"))
    case.solve(split, before)
    return case


def whole(table):
    for gas in (True, False):
        for points in (False, True):
            label = ("gas" if gas else "fluids") + (" with points" if points else "")
            tag = label.replace(" ", "-")
            options = {"gas": gas, "points": points}
            one = burst(f"{tag}-1", {"writeInterval": 0.125}, **options)
            two = burst(f"{tag}-2", {"writeInterval": 0.125}, split=(2, 1, 1), **options)
            several = [("2", two)]
            if points or VERIFY:
                several.append(("3", burst(f"{tag}-3", {"writeInterval": 0.125},
                                           split=(1, 3, 1), **options)))
            fields = ["p", "U.air", "T.air"] if gas else ["p", "U", "alpha.heavy", "thetaRhoE"]

            def apart(other):
                return max(np.max(abs(volField(one, "0.25", f) - volField(other, "0.25", f)))
                           /np.max(abs(volField(one, "0.25", f))) for f in fields)
            for name, other in several:
                table.row(f"{label}, {name} processors: largest difference", 0, apart(other),
                          1e-10)
            again = burst(f"{tag}-again", {"writeInterval": 0.125},
                          before=lambda c: shutil.copytree(one.file("0.125"), c.file("0.125")),
                          **options)
            table.row(f"{label}, restart: largest difference", 0, apart(again), 0, "atMost")


def wedge(table):
    for layer in (None, 0.2):
        wedgeBurst(table, layer)


def wedgeBurst(table, layer):
    """A hot part about the axis; the far field is around and at both ends."""
    of = ", a layer" if layer else ""
    case = gasCase("outlets", "wedge-layer" if layer else "wedge", (4, 4, 1), (1, 1, 1),
                   lambda x, y, z: (1 + 0*x, 0*x, 1 + 0*x), 20,
                   writeInterval=1)
    patches = {"ends": ("patch", "x-"), "top": ("patch", "x+"), "around": ("patch", "r+")}
    far = outlet("farField", layer=layer)
    case.write("system/blockMeshDict", wedgeMesh((0, 0), (1, 0.5), (40, 20), patches))
    case.run("blockMesh")
    n = 800
    x, r = (a.ravel() for a in np.meshgrid((np.arange(40) + 0.5)/40, (np.arange(20) + 0.5)/40))
    conditions = {**{name: far for name in patches}, "front": ("wedge",)*3, "back": ("wedge",)*3,
                  "axis": ("empty",)*3}
    p = np.where(np.hypot(x - 0.5, r) < 0.15, 10., 1.)
    for i, (name, values) in enumerate((("p", p), ("T.air", 1 + 0*p), ("U.air", np.zeros((n, 3))))):
        writeVolField(case, name, values, {k: c[i] for k, c in conditions.items()})
    case.run("materialPointFoam")
    p = volField(case, "20", "p")
    table.row(f"burst on a wedge{of}, t = 20: largest |p - p of the far field|", 0,
              np.max(abs(p - 1)), 1e-3)
    p = volField(case, "1", "p").reshape(20, 40)
    table.row(f"burst on a wedge{of}: t = 1: symmetry along the axis", 0,
              np.max(abs(p - p[:, ::-1])), 1e-10)


if __name__ == "__main__":
    sys.exit(runParts("outlets", tubes, oblique, layers, blast, rest, whole, wedge))
