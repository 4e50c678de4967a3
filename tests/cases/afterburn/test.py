#!/usr/bin/env python3
"""Products that burn on (afterburn): heat, rate, transport.

    rate      in a closed cell, without pressure exponent: the exact solution whatever the step;
              with it, where p grows with what has burned (logistic), at three steps
    heat      a disc of TNT detonates in air in a closed box and burns on: energy that came in
    carried   a part that has burned on, in translation; fluids that do not burn on pay nothing
    changing  boxes that come and go on an adaptive mesh; a wedge: energy
    ranks     processors; restart in the middle, bit by bit
    beside    points in it: the energy budget
    wrong     messages
"""

import os
import re
import shutil
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../lib"), os.path.join(HERE, "../adaptiveMesh")]
from changing import changes, comeAndGo
from detonations import TNT
from fluidCases import AIR, WATER, besidePoints, fluidCase, fluidField, shareFile
from foamCase import RunFailed, runParts, testModule
from gasCases import WALL, volField
from gasOnCells import cyclicSides

CLOSED = {"ends": WALL, "sides": WALL}
detonation = testModule("detonation", "afterburn")


def on(fluid=TNT, **entries):
    return {**fluid, "afterburn": {"type": "Miller", **entries}}


def cell(name, end, fluid, rho, p, steps):
    """Two closed cells of products at rest."""
    case = fluidCase("afterburn", name, (2, 1, 1), (1, 0.1, 0.1), {"charge": fluid},
                     lambda x, y, z: ([1.0], [rho], 0.0, p), end,
                     control={"deltaT": end/steps, "adjustTimeStep": False}, **CLOSED)
    case.run("materialPointFoam")
    return fluidField(case, end, "lambda.charge"), fluidField(case, end, "p")


def rate(table):
    rho, p0, Q, end = 2.0, 1e6, 5e6, 1e-3
    for m, exact in ((0.5, lambda s: 1 - (1 - 0.5*s)**2), (1, lambda s: 1 - np.exp(-s)),
                     (2, lambda s: 1 - 1/(1 + s)), (0, lambda s: s)):
        for steps in (10, 40, 160):
            share, p = cell(f"exact-{m}-{steps}", end, on(Q=Q, a=0.8/end, m=m, n=0), rho, p0,
                            steps)
            table.row(f"closed cell, m = {m}, n = 0, {steps} steps: lambda", exact(0.8),
                      share[0], 1e-12, "relative")
            table.row(f"closed cell, m = {m}, n = 0, {steps} steps: pressure [Pa]",
                      p0 + 0.3*rho*Q*share[0], p[0], 1e-12, "relative")
    # d lambda/dt = a (1 - lambda) (p0 + c lambda)
    c, errors = 0.3*rho*Q, {}
    a = 1/(end*(p0 + c))
    E = np.exp(a*(p0 + c)*end)
    exact = p0*(E - 1)/(c + p0*E)
    for steps, limit in ((20, 0.03), (80, 8e-3), (320, 2e-3)):
        share, _ = cell(f"logistic-{steps}", end, on(Q=Q, a=a, m=1, n=1), rho, p0, steps)
        errors[steps] = abs(share[0]/exact - 1)
        table.row(f"closed cell, m = n = 1, {steps} steps: error of lambda", 0, errors[steps],
                  limit, "atMost")
    table.row("closed cell, m = n = 1: order of the error from 20 to 320 steps", 0.9,
              np.log2(errors[20]/errors[320])/4, 0.9, "atLeast")


def discEnergy(n):
    alpha = np.clip(0.3*n - n/0.125*np.hypot(*detonation.boxCentres(
        (-0.125, -0.125, 0), (0.125, 0.125, 0.1), (2*n, 2*n, 1))[:2]) + 0.5, 0, 1)
    return np.mean(alpha*(7e9 + 1e5/0.3) + (1 - alpha)*1e5/0.4), 1630*np.mean(alpha)


def heat(table):
    """In parts, then all of it."""
    n, end, Q = 32, 2.8e-5, 1e7
    start, mass = discEnergy(n)
    for label, a, least in (("in parts", 4e2, 0), ("all", 2e5, 1)):
        case = detonation.discCase("heat-" + label.split(" ")[-1], n, end,
                                   fluid=on(detonation.lit(), Q=Q, a=a), control={
            "functions": {"balance": {"type": "fluidBalance", "libs": ["mpmFunctionObjects"],
                                      "writeControl": "timeStep", "writeInterval": 1}}})
        share = fluidField(case, end, "lambda.charge")
        m, F = (fluidField(case, end, f + ".charge") for f in ("thetaRho", "F"))
        gained = fluidField(case, end, "thetaRhoE").mean() - start
        table.row(f"disc that burns on, {label}: heat over Q m lambda", 1,
                  gained/(Q*np.mean(m*share)), 1e-10)
        table.check(f"disc that burns on, {label}: no more than has detonated",
                    np.all((share >= 0) & (share <= F)), (share.min(), np.max(share - F)))
        if least:
            table.row(f"disc that burns on, {label}: heat over Q times its mass", 1,
                      gained/(Q*mass), 1e-10)
        else:
            table.row(f"disc that burns on, {label}: share", 0.5, np.mean(m*share)/mass, 0.4)
        rows = case.series("balance", "total.dat")
        table.row(f"disc that burns on, {label}: energyRest of fluidBalance over what came in", 0,
                  np.max(abs(rows[:, -1]))/np.max(abs(rows[:, -5])), 1e-9, "atMost")


def carried(table):
    n, end = 100, 1e-3
    fluid = on(Q=1e-3, a=1e-9)
    case = fluidCase("afterburn", "carried", (n, 1, 1), (1, 0.01, 0.01), {"charge": fluid},
                     lambda x, y, z: ([1.0], [1.0], 1000.0, 1e6), end,
                     patches=cyclicSides("x")[0])
    shareFile(case, "lambda.charge", 0.5*(abs((np.arange(n) + 0.5)/n - 0.5) < 0.2))
    case.run("materialPointFoam")
    share, rho = (fluidField(case, end, f + ".charge") for f in ("lambda", "thetaRho"))
    table.row("moving products: what has burned on", 0.2, np.mean(share*rho), 1e-9, "relative")
    table.row("moving products: its place after one turn [m]", 0.5,
              np.sum(share*(np.arange(n) + 0.5)/n)/np.sum(share), 1e-3)
    table.row("moving products: largest share", 0.5, share.max(), 0.5*(1 + 1e-9), "atMost")
    still = fluidCase("afterburn", "without", (n, 1, 1), (1, 0.01, 0.01), {"charge": TNT},
                      lambda x, y, z: ([1.0], [1.0], 0.0, 1e6), 1e-5)
    still.run("materialPointFoam")
    table.check("without afterburn there is no such field and no line of the log",
                not os.path.exists(still.file(still.times()[-1], "lambda.charge"))
                and "burned on" not in still.log())


def burnedOn(case):
    """Energy of the log's first and last report, with what burned on."""
    log = case.log()
    E = [float(v) for v in re.findall(r"^Fluids: .* energy (\S+)$", log, re.M)]
    came = [float(v) for v in re.findall(r"^    burned on of \S+: \S+, energy (\S+)$", log, re.M)]
    return E, came


def changing(table):
    n, end = 16, 6e-5
    fluids = {"charge": on(detonation.lit(points=[(0.3, 0.4, 0)]), Q=1e7, a=1e3), "air": AIR}

    def initial(x, y, z):
        a = np.where((x - 0.3)**2 + (y - 0.4)**2 < 0.15**2, 1.0, 0.0)
        return [a, 1 - a], [1630.0, 1.2], 0.0, 1e5
    case = comeAndGo(fluidCase("afterburn", "changing", (n, n, 1), (1, 1, 1/n), fluids, initial,
                               end, ends=WALL, control={"reportInterval": 1}), end, 2)
    case.run("materialPointFoam")
    E, came = burnedOn(case)
    table.row("adaptive mesh: changes", 50, changes(case), 50, "atLeast")
    table.row("adaptive mesh: energy that came in over Q m lambda", 1,
              (E[-1] - E[0])/(came[-1] - came[0]), 1e-9)
    table.check("adaptive mesh: some has burned on", came[-1] > 10*came[0] > 0, came[::20])


def ranks(table):
    end = 6e-6
    fluid = on(detonation.lit(), Q=1e7, a=3e3)
    one = detonation.discCase("ranks-1", 16, end, fluid=fluid)
    two = detonation.discCase("ranks-2", 16, end, (2, 1, 1), fluid=fluid)

    def difference(a, b, time):
        shares = (volField(c, time, "lambda.charge")*volField(c, time, "alpha.charge")
                  for c in (a, b))
        return max(detonation.differences(a, b, time), np.max(abs(np.subtract(*shares))))
    table.row("disc that burns on, 2 processors: largest difference", 0,
              difference(one, two, one.timeName(end)), 1e-10)
    share = fluidField(one, end, "lambda.charge")
    table.row("disc that burns on: its largest share", 0.5, share.max(), 0.45)
    runs = []
    for again in (False, True):
        runs.append(detonation.discCase(
            "restart-" + ("again" if again else "whole"), 16, 4e-6, fluid=fluid,
            control={"writeInterval": 2e-6, "startFrom": "latestTime"},
            before=lambda c, h=again: h and shutil.copytree(runs[0].file("2e-06"),
                                                            c.file("2e-06"))))
    table.row("disc that burns on, restart: largest difference", 0,
              difference(*runs, "4e-06"), 0, "atMost")
    os.remove(runs[1].file("2e-06", "lambda.charge"))
    shutil.rmtree(runs[1].file("4e-06"))
    try:
        runs[1].run("materialPointFoam")
        text = ""
    except RunFailed:
        text = " ".join(runs[1].log().split())
    table.check("restart without the file lambda: a message", "lambda.charge" in text
                and "has not all of the state" in text, text[-200:])


def beside(table):
    """A plate of points in a closed box: heat in the energy budget is that of the log."""
    n, end, Q = 20, 3e-5, 1e7
    fluids = {"charge": on(detonation.lit(points=[(0.05, 0.1, 0)]), Q=Q, a=1e3), "air": AIR}

    def initial(x, y, z):
        a = 1.0*(np.hypot(x - 0.05, y - 0.1) < 0.03)
        return [a, 1 - a], [1630.0, 1.2], 0.0, 1e5
    case = fluidCase("afterburn", "beside", (n, n, 1), (0.2, 0.2, 0.2/n), fluids, initial, end,
                     ends=WALL, control={"maxCo": 0.3, "deltaT": 1e-9, "reportInterval": 1})
    besidePoints(case, fluids, {"plate": {"constitutiveModel": {
        "type": "linearElastic", "rho": 2700, "E": 7e10, "nu": 0.3}}},
        {"plate": {"type": "box", "min": (0.12, 0.05, -1), "max": (0.14, 0.15, 1),
                   "stress": "ambient", "pressure": 1e5}}, numerics={"energyBudget": True})
    case.run("materialPointFoam")
    _, came = burnedOn(case)
    booked = [float(v) for v in re.findall(r", afterburn (\S+)$", case.log(), re.M)]
    table.row("beside points: heat of the energy budget over that of the log", 1,
              booked[-1]/came[-1], 1e-9)


def wrong(table):
    def badField(c):
        with open(c.file("0/alpha.charge")) as f:
            text = f.read().replace("alpha.charge", "lambda.charge").replace("1.0", "1.5")
        with open(c.file("0/lambda.charge"), "w") as f:
            f.write(text)
    law = {"Q": 1e7, "a": 100}
    for label, charge, words, change in (
            ("keyword", on(**law, k=1), ("afterburn", "k", "Q"), None),
            ("law", {**TNT, "afterburn": {"type": "miller", **law}}, ("miller", "Miller"), None),
            ("noHeat", on(a=1), ("Q",), None),
            ("heat", on(Q=-1, a=1), ("Q", "-1"), None),
            ("noRate", on(Q=1), ("a",), None),
            ("power", on(**law, m=-1), ("m", "-1"), None),
            ("exponent", on(**law, n=11), ("n", "11"), None),
            ("water", on(WATER, **law), ("stiffenedGas", "cannot burn on", "JWL"), None),
            ("gas", on(AIR, **law), ("perfectGas", "JWL"), None),
            ("share", on(**law), ("lambda.charge", "1.5", "[0, 1]"), badField)):
        c = fluidCase("afterburn", "wrong-" + label, (8, 1, 1), (1, 0.1, 0.1),
                      {"charge": charge, "air": AIR},
                      lambda x, y, z: ([1.0*(x < 0.5), 1.0*(x > 0.5)], [1630.0, 1.2], 0.0, 1e5),
                      1e-7)
        if change:
            change(c)
        try:
            c.run("materialPointFoam")
            text = ""
        except RunFailed:
            text = " ".join(c.log().split())
        missing = [w for w in words if w not in text]
        table.check(f"wrong input: {label}", not missing and text.count("--> FOAM FATAL") == 1
                    and "printStack" not in text, f"message lacks {missing}")


if __name__ == "__main__":
    sys.exit(runParts("afterburn", rate, heat, carried, changing, ranks, beside, wrong))
