#!/usr/bin/env python3
"""Function objects of a gas and of fluids: blastProbes, fluidBalance and fluidHeight.

    wave      a period of a sine, of sound, passes a probe: arrival, peak, time of the peak,
              duration, both impulses by the exact wave, at two resolutions
    heights   water at rest on boxes, triangles and on ground of points: depth and level
    slosh     the first standing wave of a tank, its level by linear theory
    parallel  probes (one on the face between processors, one outside of the piece of the
              master) and balances: 1, 2 and 3 processors to 1e-12, restart: the same digits
    balance   gas and two fluids with far fields: what is there less what came in is constant
    wrong     input that is refused, a probe in solid
"""

import os
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from coupledCases import ambient, coupledCase
from fluidCases import AIR, besidePoints, fluidCase
from foamCase import RunFailed, runParts
from gasCases import WALL, gasCase

LIBS = {"libs": "(mpmFunctionObjects)", "writeControl": "timeStep", "writeInterval": 1}
SUMMARY = ("ambient", "arrival", "peak", "peakTime", "duration", "positive", "negative",
           "later")


def probes(places, **more):
    return {"type": "blastProbes", **LIBS, "probeLocations": list(places), **more}


def summary(case, name, time="0"):
    """{quantity: of each probe}"""
    rows = np.atleast_2d(np.loadtxt(case.file("postProcessing", name, time, "summary.dat")))
    return dict(zip(SUMMARY, rows[:, 4:].T))


def rows(case, name, file, time="0"):
    return np.atleast_2d(np.loadtxt(case.file("postProcessing", name, time, file)))


# --- wave --------------------------------------------------------------------

def wave(table):
    size, length, start, c = 1e-4, 0.4, 0.5, np.sqrt(1.4)
    for n, limit in ((200, 0.05), (800, 0.01)):
        def initial(x, y, z):
            s = start - x
            p = 1 + size*np.where((s > 0) & (s < length), np.sin(2*np.pi*s/length), 0)
            rho = p**(1/1.4)
            return rho, 5*(np.sqrt(1.4*p/rho) - c), p
        x = (int(0.8*n) + 0.5)/n
        case = gasCase("flowOutput", f"wave-{n}", (n, 1, 1), (1, 0.01, 0.01), initial, 0.9,
                       control={"functions": {"gauge": probes(
                           [(x, 0.005, 0.005)], threshold=0.2*size, patches=["ends"])}})
        case.run("materialPointFoam")
        found = {k: v[0] for k, v in summary(case, "gauge").items()}
        front = (x - start)/c
        for quantity, exact, scale in (
                ("ambient", 1.0, 1.0),
                ("arrival", front + length/(2*np.pi*c)*np.arcsin(0.2), length/c),
                ("peak", size, size), ("peakTime", front + length/4/c, length/c),
                ("duration", length/c*(0.5 - np.arcsin(0.2)/(2*np.pi)), length/c),
                ("positive", size*length/(np.pi*c), size*length/(np.pi*c)),
                ("negative", -size*length/(np.pi*c), size*length/(np.pi*c))):
            table.row(f"sine of sound, {n} cells: {quantity}, error over its scale", 0,
                      (found[quantity] - exact)/scale, limit if quantity != "ambient" else 1e-12)

        # The same from the history, by other means
        h = rows(case, "gauge", "p.dat")
        fine = np.linspace(0, h[-1, 0], 400001)
        over = np.interp(fine, h[:, 0], h[:, 1]) - 1
        table.row(f"sine of sound, {n} cells: impulse of the history, sampled finely",
                  np.trapezoid(np.maximum(over, 0), fine) if hasattr(np, "trapezoid")
                  else np.trapz(np.maximum(over, 0), fine), found["positive"], 1e-6, "relative")


# --- parallel ----------------------------------------------------------------

GAUGES = ((0.5, 0.5, 0.05), (0.9, 0.3, 0.05), (0.25, 0.51, 0.05))


def burst(name, split=None, before=lambda case: None, fluids=True, end=0.2, first=()):
    def initial(x, y, z):
        p = np.where(np.hypot(x - 0.6, y - 0.5) < 0.2, 5., 1.)
        a = 1.0*(x < 0.3)
        return ([a, 1 - a], [3 + 0*x, 1 + 0*x], 0*x, p) if fluids else (1 + 0*x, 0*x, p)
    far = ({"type": "farField", "farValue": "uniform 1", "value": "uniform 1"}, "zeroGradient",
           {"type": "farField", "farValue": "uniform (0 0 0)", "value": "uniform (0 0 0)"})
    functions = {"gauges": probes([*first, *GAUGES],
                                  patches=["sides", "ends"]),
                 "balance": {"type": "fluidBalance", **LIBS}}
    if fluids:
        functions["heights"] = {**lines([(0.5, 0.5, 0.05), (0.23, 0.1, 0.05)], fluid="heavy"),
                                "direction": (0, 1, 0)}
    options = {"ends": far, "sides": WALL, "writeInterval": end/2,
               "control": {"functions": functions, "startFrom": "latestTime"}}
    cells, high = (24, 24, 1), (1, 1, 0.1)
    if fluids:
        case = fluidCase("flowOutput", name, cells, high, {"heavy": AIR, "air": AIR}, initial, end,
                         **options)
    else:
        case = gasCase("flowOutput", name, cells, high, initial, end, **options)
    case.solve(split, before)
    return case


def phases(table, case, name="gauges"):
    """Impulses of the first phase and of all after it, by the history."""
    found, h = summary(case, name), rows(case, name, "p.dat")
    fine = np.linspace(0, h[-1, 0], 400001)
    errors, later = [], 0
    for i, ambient in enumerate(found["ambient"]):
        over = np.maximum(np.interp(fine, h[:, 0], h[:, 1 + i]) - ambient, 0)
        ends = found["arrival"][i] + found["duration"][i]
        parts = [np.sum(over[part])*fine[1] for part in (~(fine > ends), fine > ends)]
        scale = max(sum(parts), 1e-12)
        errors += [(found["positive"][i] - parts[0])/scale, (found["later"][i] - parts[1])/scale]
        later += parts[1] > 0.01*scale
    table.row("burst: impulse of the first phase and of all after it, beside the history", 0,
              np.max(np.abs(errors)), 1e-4)
    table.check("burst: later phases at some gauge", later > 0, str(later))


def apart(a, b):
    return np.max(abs(a - b)/np.maximum(np.max(abs(a), axis=0), 1e-6))


def parallel(table):
    one = burst("parallel-1")
    history = rows(one, "gauges", "p.dat")
    for split in ((2, 1, 1), (1, 3, 1)):
        n = max(split)
        other = burst(f"parallel-{n}", split)
        table.row(f"{n} processors: histories of probes and patches", 0,
                  apart(history, rows(other, "gauges", "p.dat")), 1e-11, "atMost")
        table.row(f"{n} processors: summary", 0, max(
            np.max(abs(u - v))/np.max(abs(u)) for u, v in zip(
                *([np.nan_to_num(u) + 1e-12 for u in summary(c, "gauges").values()]
                  for c in (one, other)))), 1e-10, "atMost")
        for f in ("depth.dat", "level.dat"):
            table.row(f"{n} processors: fluidHeight, {f}", 0,
                      apart(rows(one, "heights", f), rows(other, "heights", f)), 1e-11, "atMost")
        for f in ("heavy.dat", "air.dat", "total.dat"):
            table.row(f"{n} processors: balance, {f}", 0,
                      apart(rows(one, "balance", f), rows(other, "balance", f)), 1e-8, "atMost")
    again = burst("again", before=lambda c: shutil.copytree(one.file("0.1"), c.file("0.1")))
    h = rows(again, "gauges", "p.dat", "0.1")
    table.row("restart: history", 0, np.max(abs(h - history[-len(h):])), 0, "atMost")
    same = [np.array_equal(u, v, equal_nan=True) for u, v in zip(
        summary(one, "gauges").values(), summary(again, "gauges", "0.1").values())]
    table.check("restart: summary to the last digit", all(same), str(same))
    more = burst("again-more", first=[(0.2, 0.2, 0.05)],
                 before=lambda c: shutil.copytree(one.file("0.1"), c.file("0.1")))
    same = [np.array_equal(u, v[1:], equal_nan=True) for u, v in zip(
        summary(one, "gauges").values(), summary(more, "gauges", "0.1").values())]
    table.check("restart with a new gauge before the others: their summary to the last digit",
                all(same) and "(0.2 0.2 0.05)" in more.log(), str(same))
    phases(table, burst("phases", end=0.8))
    table.row("restart: balance of all", 0, apart(
        rows(one, "balance", "total.dat")[-len(h):], rows(again, "balance", "total.dat", "0.1")),
        1e-8, "atMost")


# --- heights -----------------------------------------------------------------

SOFT = {"rho": 1000, "equationOfState": {"type": "stiffenedGas", "gamma": 1.12,
                                         "soundSpeed": 30, "p0": 1e3}}
G, DEEP, HIGH = 9.81, 0.5, 1.0


def tank(name, cells, surface, pressure, end, functions, kind=None, sides=None,
         settings=None, maxCoGas=0.4):
    """Water beneath a surface y = surface(x), air above it, in a tank 1 m long and high."""
    def initial(x, y, z):
        h = HIGH/cells[1]
        p = pressure(x, y)
        alpha = np.clip((surface(x) - y)/h + 0.5, 0, 1)
        pInf = 1000*30**2/1.12 - 1e3
        return ([alpha, 1 - alpha], [1000*((p + pInf)/(1e3 + pInf))**(1/1.12), (p/1e3)**(1/1.4)],
                0*x, p)
    return fluidCase("flowOutput", name, cells, (1, HIGH, 0.1), {"water": SOFT, "air": AIR},
                     initial, end, ends=WALL, sides=sides, gravity=(0, -G, 0), kind=kind,
                     settings=settings, maxCoGas=maxCoGas,
                     control={"functions": functions, "maxCo": 0.3})


def lines(places, **more):
    return {"type": "fluidHeight", **LIBS, "fluid": "water", "probeLocations": list(places),
            **more}


def atRest(x, y):
    return 1e3 + 1000*G*np.maximum(DEEP - y, 0)


def heights(table):
    """What the shares say, of the start: exact where the sides of cells are vertical."""
    deep = 0.437
    places = [(0.31, 0.4, 0.05), (0.5, 0.4, 7), (0, 0.4, 0), (1, 0.9, 0.1)]
    for kind, limit in ((None, 1e-12), ("prisms", 0.05/2)):
        case = tank(f"depth-{kind}", (20, 20, 1), lambda x: deep + 0*x, atRest, 1e-6,
                    {"waves": lines(places)}, kind)
        case.run("materialPointFoam")
        for what, exact in (("depth", deep), ("level", deep - np.array([p[1] for p in places]))):
            table.row(f"water at rest, {kind or 'boxes'} of 0.05: {what}, error [m]", 0,
                      np.max(abs(rows(case, "waves", what + ".dat")[0, 1:] - exact)), limit,
                      "atMost")
    # Oil of 0.2 on water of 0.437
    oil = {**SOFT, "rho": 800}

    def layers(x, y, z):
        water = np.clip((deep - y)/0.05 + 0.5, 0, 1)
        wet = np.clip((deep + 0.2 - y)/0.05 + 0.5, 0, 1)
        return [water, wet - water, 1 - wet], [1000., 800., 1.], 0*x, 1e3 + 0*x
    case = fluidCase("flowOutput", "oil", (20, 20, 1), (1, HIGH, 0.1),
                     {"water": SOFT, "oil": oil, "air": AIR}, layers, 1e-6, ends=WALL,
                     gravity=(0, -G, 0), control={"functions": {
                         "water": lines(places), "oil": lines(places, fluid="oil")}})
    case.run("materialPointFoam")
    for fluid, depth, top in (("water", deep, deep), ("oil", 0.2, deep + 0.2)):
        for what, exact in (("depth", depth), ("level", top - np.array([p[1] for p in places]))):
            table.row(f"{fluid} of oil on water: {what}, error [m]", 0, np.max(abs(
                rows(case, fluid, what + ".dat")[0, 1:] - exact)), 1e-12, "atMost")
    case = tank("ground", (20, 20, 1), lambda x: deep + 0*x, atRest, 1e-6,
                {"waves": lines([(0.31, 0.4, 0.05), (0.7, 0.4, 0.05)])})
    besidePoints(case, {"water": SOFT, "air": AIR},
                 {"ground": {"constitutiveModel": {"type": "linearElastic", "rho": 2000, "E": 1e6,
                                                   "nu": 0}}},
                 {"ground": {"type": "box", "min": (0, 0, -1), "max": (0.5, 0.22, 1),
                             "stress": ambient(1e3)}})
    case.run("materialPointFoam")
    # Solid leaves 1 % of its cells to pores
    for what, exact in (("depth", (deep - 0.99*0.22, deep)), ("level", (deep - 0.4,)*2)):
        table.row(f"the same on ground of points: {what}, error [m]", 0, np.max(abs(
            rows(case, "waves", what + ".dat")[0, 1:] - exact)), 1e-12, "atMost")


# --- slosh -------------------------------------------------------------------

def slosh(table):
    """Standing wave, the first of the tank. Linear theory of two layers with potentials:
    w^2 = g k (r1 - r2)/(r1 coth(k h1) + r2 coth(k h2)), level = a cos(k x) cos(w t)."""
    k, a = np.pi, 0.01
    w = np.sqrt(G*k*(1000 - 1)/((1000 + 1)/np.tanh(k*DEEP)))
    period = 2*np.pi/w

    def pressure(x, y):
        return atRest(x, y) + np.where(y < DEEP, 1000*G*a*np.cos(k*x)*np.cosh(k*y)
                                       / np.cosh(k*DEEP), 0)
    for n, slow, late, lost in ((20, "yes", 0.02, 0.15), (40, "yes", 0.01, 0.1),
                                (40, "no", 0.1, 0.6)):
        case = tank(f"slosh-{n}-{slow}", (n, n, 1), lambda x: DEEP + a*np.cos(k*x), pressure,
                    1.4*period, {"waves": lines([(0, DEEP, 0), (0.5, DEEP, 0), (1, DEEP, 0)])},
                    settings={"lowMach": slow})
        case.run("materialPointFoam")
        t, left, middle, right = rows(case, "waves", "level.dat").T
        wave = 0.5*(left - right)
        down = [np.interp(0, wave[[i + 1, i]], t[[i + 1, i]])
                for i in range(len(t) - 1) if wave[i] > 0 >= wave[i + 1]]
        label = f"standing wave, {n} cells long, lowMach {slow}"
        table.row(f"{label}: period", period, down[1] - down[0], late, "relative")
        table.row(f"{label}: height lost in a period", 0,
                  1 - np.max(wave[abs(t - period) < period/4])/a, lost, "atMost")
        table.row(f"{label}: level in its node over its height", 0, np.max(abs(middle))/a,
                  0.1, "atMost")


# --- balance -----------------------------------------------------------------

def balance(table):
    for fluids in (False, True):
        label = "two fluids" if fluids else "gas"
        case = burst(label.replace(" ", "-"), fluids=fluids, end=0.6)
        for f in ("heavy", "air") if fluids else ("air",):
            r = rows(case, "balance", f + ".dat")
            table.row(f"{label}, mass of {f} less what came in, change over the mass", 0,
                      np.max(abs(r[:, 9]))/r[0, 1], 1e-13, "atMost")
        r = rows(case, "balance", ("total" if fluids else "air") + ".dat")
        table.check(f"{label}: mass has gone out", r[-1, 8] < -0.01*r[0, 1], f"{r[-1, 8]}")
        energy = r[0, 5] + r[0, 6]
        table.row(f"{label}: rest of energy", 0, np.max(abs(r[:, 17]))/energy, 1e-12, "atMost")
        table.row(f"{label}: rest of momentum", 0,
                  np.max(abs(r[:, 14:17]))/np.sqrt(energy*r[0, 1]), 1e-12, "atMost")


# --- wrong input -------------------------------------------------------------

def refused(case):
    """The log of a run that stops, "" of one that does not."""
    try:
        case.run("materialPointFoam")
        return ""
    except RunFailed:
        return case.log()


def wrong(table):
    for label, entries, words in (
            ("place outside", probes([(0.5, 5, 0.05)]), ("probeLocations", "not in the mesh",
                                                         "(0 0 0)")),
            ("no places", {"type": "blastProbes", **LIBS}, ("probeLocations", "patches")),
            ("unknown patch", probes([], patches=["wall"]), ("wall", "Valid patches", "ends")),
            ("unknown field", probes([(0.5, 0.5, 0.05)], field="q"), ("field q", "Valid fields")),
            ("threshold", probes([(0.5, 0.5, 0.05)], threshold=-1), ("threshold",)),
            ("misspelt", probes([(0.5, 0.5, 0.05)], treshold=1), ("treshold", "threshold")),
            ("executeControl", probes([(0.5, 0.5, 0.05)], executeControl="writeTime"),
             ("Remove executeControl",)),
            ("fluidHeight in one gas", lines([(0.5, 0.5, 0)]), ("two or more", "is one")),
            ("misspelt of fluidBalance", {"type": "fluidBalance", **LIBS, "phase": "air"},
             ("phase", "Valid keywords"))):
        case = gasCase("flowOutput", "wrong-" + label.replace(" ", "-"), (4, 4, 1), (1, 1, 0.1),
                       lambda x, y, z: (1 + 0*x, 0*x, 1 + 0*x), 1e-3,
                       control={"functions": {"one": entries}})
        text = refused(case)
        missing = [w for w in words if w not in text]
        table.check(f"wrong input: {label}", not missing and "FOAM FATAL" in text
                    and "printStack" not in text, f"message lacks {missing}")

    for label, entries, words in (
            ("fluid", lines([(0.5, 0.5, 0)], fluid="watr"), ("watr", "water", "air")),
            ("direction", lines([(0.5, 0.5, 0)], direction="(0 0 0)"), ("direction", "zero")),
            ("no places", lines([]), ("probeLocations has no place",)),
            ("height in mm", lines([(0.5, 500, 0)]), ("(0.5 500 0)", "in m", "from 0 to 1 m")),
            ("outside", lines([(0.5, 0.5, 0), (1.5, 0.5, 0)]), ("(1.5 0.5 0)", "meet the mesh"))):
        case = tank("wrong-height-" + label.replace(" ", "-"), (4, 4, 1), lambda x: DEEP + 0*x,
                    atRest, 1e-6, {"one": entries})
        text = refused(case)
        missing = [w for w in words if w not in text]
        table.check(f"wrong input of fluidHeight: {label}", not missing and "FOAM FATAL" in text,
                    f"message lacks {missing}")

    case = coupledCase("flowOutput", "solid", (10, 10, 1), (1, 1, 0.1),
                       lambda x, y, z: (1 + 0*x, 0*x, 1 + 0*x), 1e-3,
                       {"body": {"constitutiveModel": {"type": "linearElastic", "rho": 50, "E": 1e4,
                                                       "nu": 0}}},
                       {"body": {"type": "box", "min": (0.5, 0, -1), "max": (1, 1, 1),
                                 "stress": ambient(1)}}, ends=WALL, sides=WALL,
                       control={"functions": {"gauges": probes([(0.85, 0.55, 0.05),
                                                                (0.15, 0.55, 0.05)])}})
    case.run("materialPointFoam")
    log = case.log()
    table.check("a probe in solid is told", "(0.85 0.55 0.05) is in solid" in log
                and "(0.15 0.55 0.05) is in solid" not in log)


if __name__ == "__main__":
    sys.exit(runParts("flowOutput", wave, heights, slosh, parallel, balance, wrong))
