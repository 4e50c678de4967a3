"""The gas alone beside rhoCentralFoam (Kurganov, vanLeer, Euler, maxCo 0.2).

Sod at 100 to 800 cells: L1 of the density, star states, overshoot, order,
core-seconds; 123 at 200; a 400 x 200 mesh: cell-steps per second of one core,
without start-up, both on the same mesh with the same schemes, taken in turn,
best of three each. Exact values from tests/lib/riemannExact.py.
"""

import csv
import os
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../tests/lib"))
import riemannExact as exact  # noqa: E402
from foamCase import RUN, RunFailed  # noqa: E402
from gasCases import OPEN, UPWIND, VAN_LEER, gasCase, volField  # noqa: E402

SOLVERS = {"materialPointFoam": 0.4, "rhoCentralFoam": 0.2}


def steps(case, solver):
    """Steps of a run; materialPointFoam's log has not a line of each."""
    return case.nSteps() if solver == "materialPointFoam" else case.log(solver).count("\nTime = ")


def seconds(case, solver):
    """Core-seconds from the first to the last step."""
    import re
    t = re.findall(r"^ExecutionTime = ([\d.eE+-]+) s", case.log(solver), flags=re.M)
    return float(t[-1]) - float(t[0])


def tube(solver, name, n, problem, end, reconstruct=VAN_LEER, maxCo=None):
    def initial(x, y, z):
        return tuple(np.where(x < 0.5, l, r) for l, r in zip(*problem))
    case = gasCase("benchmarkGas", f"{name}-{n}-{solver}", (n, 1, 1), (1, 0.01, 0.01),
                   initial, end, solver=solver, reconstruct=reconstruct,
                   maxCoGas=maxCo or SOLVERS[solver])
    total = case.run(solver, limit=600)
    t = case.timeName(end)
    suffix = ".air" if solver == "materialPointFoam" else ""
    p, T = volField(case, t, "p"), volField(case, t, "T" + suffix)
    return (np.arange(n) + 0.5)/n, p/T, volField(case, t, "U" + suffix)[:, 0], p, total, \
        steps(case, solver)


def sod(rows):
    end = 0.2
    ps, us = exact.star(*exact.SOD)
    rl, rr = (exact.starDensity(s, ps) for s in exact.SOD)
    for solver, reconstruct, label, maxCo in (
            ("materialPointFoam", VAN_LEER, "materialPointFoam, vanLeer", 0.4),
            ("materialPointFoam", UPWIND, "materialPointFoam, upwind", 0.4),
            ("rhoCentralFoam", VAN_LEER, "rhoCentralFoam, vanLeer", 0.2),
            ("rhoCentralFoam", VAN_LEER, "rhoCentralFoam, vanLeer", 0.4)):
        last = None
        for n in (100, 200, 400, 800):
            x, rho, u, p, total, nSteps = tube(
                solver, f"sod-{reconstruct['reconstruct(rho)']}-{maxCo}", n, exact.SOD, end,
                reconstruct, maxCo)
            s = (x - 0.5)/end
            error = np.mean(abs(rho - exact.solution(*exact.SOD, s)[0]))
            between, left, right = (s > 0.1) & (s < 1.65), (s > 0.1) & (s < 0.75), \
                (s > 1.1) & (s < 1.65)
            rows.append([label, maxCo, n, f"{error:.2e}",
                         f"{np.log2(last/error):.2f}" if last else "",
                         f"{100*(p[between].mean()/ps - 1):+.3f}",
                         f"{100*(u[between].mean()/us - 1):+.3f}",
                         f"{100*(rho[left].mean()/rl - 1):+.3f}",
                         f"{100*(rho[right].mean()/rr - 1):+.3f}",
                         f"{100*(u.max()/us - 1):.2f}",
                         f"{100*(rho[s > 1.1].max()/rr - 1):.2f}", nSteps, f"{total:.2f}"])
            last = error
    return ["solver", "maxCo", "cells", "L1 rho", "order", "p* %", "u* %", "rho*L %",
            "rho*R %", "over u %", "over rho %", "steps", "core-s"]


def vacuum(rows):
    for solver in SOLVERS:
        try:
            x, rho, u, p, total, nSteps = tube(solver, "123", 200, exact.TEST123, 0.15)
        except RunFailed as e:
            rows.append([solver, "fails", str(e)[:80], "", ""])
            continue
        error = np.mean(abs(rho - exact.solution(*exact.TEST123, (x - 0.5)/0.15)[0]))
        rows.append([solver, f"{error:.2e}", f"{rho.min():.3e}", f"{p.min():.3e}",
                     f"{100*(p[abs(x - 0.5) < 0.02].mean() - exact.star(*exact.TEST123)[0])/0.4:+.2f}"])
    return ["123, 200 cells", "L1 rho", "least rho", "least p", "(p - p*)/p_L %"]


def rate(rows):
    """Quadrants of different states: waves in all directions."""
    n = (400, 200, 1)
    def initial(x, y, z):
        high = (x < 1) ^ (y < 0.5)
        return np.where(high, 1, 0.125), 0*x, np.where(high, 1, 0.1)
    best = {}
    for repeat in range(3):
        for solver, reconstruct, label in (
                ("materialPointFoam", VAN_LEER, "materialPointFoam, vanLeer"),
                ("materialPointFoam", UPWIND, "materialPointFoam, upwind"),
                ("rhoCentralFoam", VAN_LEER, "rhoCentralFoam, vanLeer"),
                ("rhoCentralFoam", UPWIND, "rhoCentralFoam, upwind")):
            case = gasCase("benchmarkGas", f"rate-{label}".replace(", ", "-"), n, (2, 1, 0.01),
                           initial, 0.05, solver=solver, reconstruct=reconstruct,
                           maxCoGas=0.2, sides=OPEN)
            case.run(solver, limit=600)
            r = n[0]*n[1]*(steps(case, solver) - 1)/seconds(case, solver)/1e6
            best[label] = max(best.get(label, 0), r)
    for label, r in best.items():
        rows.append([label, f"{r:.2f}"])
    return ["400 x 200 cells, one core", "M cell-steps/s"]


def main():
    os.makedirs(os.path.join(RUN, "benchmarkGas"), exist_ok=True)
    for part in (sod, vacuum, rate):
        rows = []
        rows.insert(0, part(rows))
        with open(os.path.join(RUN, "benchmarkGas", f"{part.__name__}.csv"), "w",
                  newline="") as f:
            csv.writer(f).writerows(rows)
        widths = [max(len(str(r[i])) for r in rows) for i in range(len(rows[0]))]
        for r in rows:
            print("  ".join(str(v).ljust(w) for v, w in zip(r, widths)), flush=True)
        print()


if __name__ == "__main__":
    main()
