#!/usr/bin/env python3
"""Gas at rest that nothing has reached yet is left alone (activeRegion): same bits, less work.

A block of points at 300 m/s, or a tenfold pressure beside one at rest, in air between walls; with
activeRegion and without it: all files of all times byte for byte, and

upwind    in 2D, 3D and on two processors
limited   vanLeer by faces and MLP by points
refused   under gravity, with viscosity
"""

import filecmp
import os
import re
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from blockInGas import blockInGas, gasSchemes
from foamCase import RunFailed, foamText, runParts

H = 1e-4
VAN_LEER = ("vanLeer", "vanLeerV", "vanLeer")


def scene(label, n, active, steps, schemes, nDim=2, split=None, spot=False, size=0.2):
    low, high = 0.5*(1 - size)*n*H, 0.5*(1 + size)*n*H
    pressure = None
    if spot:
        pressure = np.full(n**nDim, 1e5)
        pressure[:3] = 1e6
    case = blockInGas(
        "stillGas", label.replace(" ", "-") + ("-active" if active else ""), nDim, n,
        {"type": "box", "min": (low, low, low if nDim > 2 else -1),
         "max": (high, high, high if nDim > 2 else 1)},
        (0, 0, 0) if spot else (300, 100, 0), steps, h=H, reports=4, walls=True,
        gasVelocity=(0, 0, 0), pressure=pressure, gas={"activeRegion": "yes"} if active else {})
    gasSchemes(case)
    with open(case.file("system", "fvSchemes")) as f:
        text = f.read()
    for name, scheme in zip(("rho", "U", "p"), schemes):
        text = re.sub(rf"reconstruct\({name}\)\s+upwind", f"reconstruct({name}) {scheme}", text)
    with open(case.file("system", "fvSchemes"), "w") as f:
        f.write(text)
    if split:
        case.decompose(split)
        case.runParallel("materialPointFoam")
    else:
        case.run("materialPointFoam")
    return case


def differing(a, b):
    """Files of times in case a that are not so in b, and how many there are."""
    lacking, n = [], 0
    for root, _, names in os.walk(a.path):
        part = os.path.relpath(root, a.path)
        if not re.match(r"(processor\d+/)?\d[\d.e-]*(/|$)", part) or part.endswith("uniform"):
            continue
        for name in names:
            n += 1
            other = os.path.join(b.path, part, name)
            if not os.path.exists(other) or not filecmp.cmp(
                    os.path.join(root, name), other, shallow=False):
                lacking.append(os.path.join(part, name))
    return lacking, n


def compare(table, label, *args, most=0.75, **more):
    """most: largest share of active cells in the first report."""
    plain, active = (scene(label, args[0], on, *args[1:], **more) for on in (False, True))
    lacking, n = differing(plain, active)
    table.row(f"{label}: files of times", 20, n, 20, "atLeast")
    table.check(f"{label}: the same bytes with activeRegion", not lacking, " ".join(lacking[:4]))
    shares = [int(a)/int(b) for a, b in
              re.findall(r"(\d+) of (\d+)\s+cells active", active.log())]
    table.row(f"{label}: share of the cells that are active at first", most, shares[0], most,
              "atMost")


def upwind(table):
    first = ("upwind",)*3
    compare(table, "block in 2D", 80, 250, first)
    compare(table, "block in 3D", 40, 60, first, nDim=3, size=0.15)
    compare(table, "pressure in a corner", 80, 250, first, spot=True)
    compare(table, "two processors", 80, 250, first, split=(2, 1, 1))


def limited(table):
    compare(table, "block in 2D, vanLeer", 80, 250, VAN_LEER)
    compare(table, "block in 3D, vanLeer", 30, 60, VAN_LEER, nDim=3, size=0.15)
    compare(table, "block in 2D, MLP", 80, 150, ("MLP",)*3)


def refused(table):
    for label, gas, gravity in (("gravity", {}, (0, -9.81, 0)),
                                ("viscosity", {"viscous": "yes", "mu": 1e-5}, None)):
        def prepare(case, gravity=gravity):
            if gravity:
                case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]",
                                          "value": foamText(gravity)},
                           "uniformDimensionedVectorField")
        case = blockInGas("stillGas", "refused-" + label, 2, 10,
                          {"type": "box", "min": (4*H, 4*H, -1), "max": (6*H, 6*H, 1)},
                          steps=2, walls=True, gas={"activeRegion": "yes", **gas},
                          prepare=prepare)
        try:
            case.run("materialPointFoam")
            message = ""
        except RunFailed:
            message = case.log().split("FOAM FATAL IO ERROR")[-1]
        table.check(f"activeRegion with {label}: refused with a reason and its place",
                    "Remove activeRegion" in message
                    and re.search(r"phaseProperties\S* (at|from) line", message) is not None,
                    " ".join(message.split())[:200])


if __name__ == "__main__":
    sys.exit(runParts("stillGas", upwind, limited, refused))
