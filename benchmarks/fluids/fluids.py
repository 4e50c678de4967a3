"""Several fluids: error and time beside compressibleInterFoam, time beside one gas.

    Allrun              both tables; run/fluids*.csv
    Allrun tubes        two tubes of two fluids, 16 rows of cells that do the same, exact solution by tests/lib/riemannEquation.py:
                        L1 of the density over its range, core-seconds, ns per cell-step,
                        the least error of the other and the first mesh here that is below it
    Allrun step         400 x 200 cells: one gas, the same gas as two fluids with an
                        interface across, as two fluids everywhere mixed: ns per cell-step

compressibleInterFoam (OpenFOAM v1912) with vanLeer for all that it transports, three pressure
corrections, a fixed step: acoustic Courant number 0.2 (at 0.4 it rings).
Runs alternate, the least time of three counts; they run at real-time priority (chrt -r 1)
where that is permitted. ExecutionTime from the first to the last step: no start-up.
"""

import csv
import os
import re
import shutil
import subprocess
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../tests/lib"))
import riemannEquation as exact  # noqa: E402
from fluidCases import WATER, fluidCase, fluidField  # noqa: E402
from foamCase import RunFailed, boxMesh, controlDict, FoamCase  # noqa: E402
from gasCases import OPEN, VAN_LEER, boxCentres, gasCase, volField, writeVolField  # noqa: E402

OWN, OTHER = "materialPointFoam", "compressibleInterFoam"
R, REPEATS, ROWS = 287.0, 3, 16
FIRST = {"thermo": "perfectGas", "R": R, "gamma": 1.4}
SECOND = {"thermo": "perfectGas", "R": R, "gamma": 5/3}

#: Fluids, equations, states (rho, u, p), interface, end, sound of the fastest side [m/s]
DENSE = 1000*((1e9 + 6e8)/(1e5 + 6e8))**(1/4.4)
TUBES = {
    "gases": (("first", "second"), (FIRST, SECOND),
              (exact.StiffenedGas(1.4), exact.StiffenedGas(5/3)), (1.2, 0, 1e5),
              (0.15, 0, 1e4), 0.5, 6e-4, 360, 1e3),
    "water and air": (("water", "air"), (WATER, FIRST),
                      (exact.StiffenedGas(4.4, 6e8), exact.StiffenedGas(1.4)), (DENSE, 0, 1e9),
                      (50, 0, 1e5), 0.7, 2e-4, 2400, 5e4)}


def realTime():
    """Words before a command that give it real-time priority, if one may."""
    words = ["chrt", "-r", "1"]
    return words if shutil.which("chrt") and not subprocess.run(
        words + ["true"], stderr=subprocess.DEVNULL).returncode else []


def run(case, solver):
    """Runs a solver; its log has its own name. Returns seconds, steps."""
    log = case.file("log." + solver)
    with open(log, "w") as out:
        status = subprocess.run(realTime() + [solver], cwd=case.path, stdout=out,
                                stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=900,
                                env={**os.environ, "PWD": case.path}).returncode
    if status:
        raise RunFailed(f"{solver}: exit status {status}: {log}")
    with open(log, errors="replace") as f:
        text = f.read()
    t = re.findall(r"^ExecutionTime = ([\d.eE+-]+) s", text, flags=re.M)
    steps = case.nSteps() if solver == OWN else text.count("\nTime = ")
    return float(t[-1]) - float(t[0]), steps


# --- tubes -------------------------------------------------------------------

def own(name, n):
    fluids, entries, _, left, right, middle, end, _, _ = TUBES[name]

    def initial(x, y, z):
        on = x < middle
        return ([1.0*on, 1.0*~on], [left[0], right[0]], 0.0, np.where(on, left[2], right[2]))
    return fluidCase("benchmarkFluids", f"{name}-{n}-{OWN}".replace(" ", "-"), (n, ROWS, 1),
                     (1, 0.1, 0.01), dict(zip(fluids, entries)), initial, end,
                     control={"reportInterval": 20})


def thermo(entries):
    """thermophysicalProperties of a phase. Water by its isentrope through 1 bar."""
    gas = "thermo" in entries
    equation = {} if gas else {"equationOfState": {"p0": 1e5, "rho0": 1000, "gamma": 4.4, "B": 6e8}}
    W = 8314.46261815324/R
    g = entries["gamma"] if gas else 1.4
    return {"thermoType": {"type": "heRhoThermo", "mixture": "pureMixture", "transport": "const",
                           "thermo": "hConst", "equationOfState":
                           "perfectGas" if gas else "adiabaticPerfectFluid",
                           "specie": "specie", "energy": "sensibleInternalEnergy"},
            "mixture": {"specie": {"molWeight": W}, **equation,
                        "thermodynamics": {"Cp": g/(g - 1)*R if gas else 4195, "Hf": 0},
                        "transport": {"mu": 0, "Pr": 1}}}


def other(name, n, Co=0.2):
    fluids, entries, _, left, right, middle, end, sound, pMin = TUBES[name]
    case = FoamCase("benchmarkFluids", f"{name}-{n}-{OTHER}".replace(" ", "-"))
    case.write("system/blockMeshDict", boxMesh((0, 0, 0), (1, 0.1, 0.01), (n, ROWS, 1), {
        "ends": ("patch", ("x-", "x+")), "sides": ("patch", ("y-", "y+")),
        "frontAndBack": ("empty", ("z-", "z+"))}))
    x = boxCentres((0, 0, 0), (1, 0.1, 0.01), (n, ROWS, 1))[0]
    on = x < middle
    p = np.where(on, left[2], right[2])
    T = [s[2]/(s[0]*R) if "thermo" in e else 300.0 for s, e in zip((left, right), entries)]
    patches = {"ends": "zeroGradient", "sides": "zeroGradient", "frontAndBack": "empty"}
    for field, values in (("p", p), ("p_rgh", p), ("T", np.where(on, *T)),
                          ("U", np.zeros((n*ROWS, 3))), (f"alpha.{fluids[0]}", 1.0*on)):
        writeVolField(case, field, values, {**patches, "sides": "slip"} if field == "U" else patches)
    case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, 0, 0)},
               "uniformDimensionedVectorField")
    case.write("constant/turbulenceProperties", {"simulationType": "laminar"})
    case.write("constant/thermophysicalProperties", {
        "phases": list(fluids), "pMin": 1, "sigma": {"type": "constant", "sigma": 0}})
    for f, e in zip(fluids, entries):
        case.write("constant/thermophysicalProperties." + f, thermo(e))
    case.write("system/fvSchemes", {
        "ddtSchemes": {"default": "Euler"}, "gradSchemes": {"default": "Gauss linear"},
        "divSchemes": {"default": "Gauss vanLeer", "div(phirb,alpha)": "Gauss linear",
                       "div(rhoPhi,U)": "Gauss vanLeerV",
                       "div(((rho*nuEff)*dev2(T(grad(U)))))": "Gauss linear"},
        "laplacianSchemes": {"default": "Gauss linear uncorrected"},
        "interpolationSchemes": {"default": "linear"}, "snGradSchemes": {"default": "uncorrected"}})
    smooth = {"solver": "smoothSolver", "smoother": "symGaussSeidel", "tolerance": 1e-9, "relTol": 0}
    pressure = {"solver": "PCG", "preconditioner": "DIC", "tolerance": 1e-9, "relTol": 0.01}
    case.write("system/fvSolution", {
        "solvers": {'"alpha.*"': {"nAlphaCorr": 1, "nAlphaSubCycles": 1, "cAlpha": 1,
                                  "MULESCorr": False, "nLimiterIter": 5, **smooth},
                    '".*(rho|rhoFinal)"': {"solver": "diagonal"}, '"pcorr.*"': pressure,
                    "p_rgh": pressure, "p_rghFinal": {**pressure, "relTol": 0}, '"(U|T).*"': smooth},
        "PIMPLE": {"momentumPredictor": False, "transonic": False, "nOuterCorrectors": 1,
                   "nCorrectors": 3, "nNonOrthogonalCorrectors": 0}})
    control = controlDict(end, end, deltaT=end/np.ceil(end*sound*n/Co))
    control.update({"application": OTHER, "adjustTimeStep": False, "maxCo": 1, "maxAlphaCo": 1,
                    "maxDeltaT": 1})
    case.write("system/controlDict", control)
    case.run("blockMesh")
    return case


def density(case, name, solver):
    fluids, entries, *_ = TUBES[name]
    end = TUBES[name][6]
    if solver == OWN:
        return fluidField(case, end, "rho")
    t = case.timeName(end)
    a, p, T = (volField(case, t, f) for f in (f"alpha.{fluids[0]}", "p", "T"))
    rho = [p/(R*T) if "thermo" in e else 1000*((p + 6e8)/(1e5 + 6e8))**(1/4.4) for e in entries]
    return a*rho[0] + (1 - a)*rho[1]


def tubes():
    rows = [["tube", "solver", "cells", "L1 rho/range", "steps", "core-s", "ns/cell-step"]]
    at = []
    for name, (_, _, equations, left, right, middle, end, _, lowest) in TUBES.items():
        solution = exact.Riemann(equations, left, right, lowest)
        line = {OWN: [], OTHER: []}
        for n in (100, 200, 400, 800):
            rho = solution.at(((np.arange(n) + 0.5)/n - middle)/end)[0]
            least, error, steps = {}, {}, {}
            for _ in range(REPEATS):
                for solver, make in ((OWN, own), (OTHER, other)):
                    case = make(name, n)
                    try:
                        t, steps[solver] = run(case, solver)
                    except RunFailed as e:
                        least.setdefault(solver, str(e)[-80:])
                        continue
                    least[solver] = min(least.get(solver, 1e9), t)
                    error[solver] = np.mean(abs(density(case, name, solver)[:n] - rho))/np.ptp(
                        [left[0], right[0]])
            for solver in (OWN, OTHER):
                if solver not in error:
                    rows.append([name, solver, n, "fails", "", "", least[solver]])
                    continue
                t = max(least[solver], 0.005)
                rows.append([name, solver, n, f"{error[solver]:.2e}", steps[solver],
                             f"{least[solver]:.2f}", f"{1e9*t/n/ROWS/steps[solver]:.0f}"])
                line[solver].append((error[solver], t))
        if line[OTHER]:
            e, t = min(line[OTHER])
            at += [[name, OTHER, "", f"{e:.2e}", "", f"{t:.2f}", "its least error"]]
            at += [[name, OWN, "", f"{a:.2e}", "", f"{b:.2f}", "first mesh below that"]
                   for a, b in line[OWN] if a <= e][:1]
    return rows + at


# --- one step ----------------------------------------------------------------

def step():
    """Quadrants of different states: waves in all directions, as of benchmarks/gasAlone."""
    n, high, end = (400, 200, 1), (2, 1, 0.01), 0.02

    def states(x, y):
        up = (x < 1) ^ (y < 0.5)
        return np.where(up, 1, 0.125), np.where(up, 1, 0.1)

    def gas():
        return gasCase("benchmarkFluids", "step-gas", n, high, lambda x, y, z: (
            states(x, y)[0], 0*x, states(x, y)[1]), end, maxCoGas=0.2, sides=OPEN)

    air = {"thermo": "perfectGas", "R": 1, "gamma": 1.4}

    def fluids(name, share):
        def initial(x, y, z):
            rho, p = states(x, y)
            return [share(x), 1 - share(x)], [rho, rho], 0.0, p
        return fluidCase("benchmarkFluids", "step-" + name, n, high, {"one": air, "other": air},
                         initial, end, maxCoGas=0.2, sides=OPEN)
    kinds = {"one gas": gas, "two fluids, interface across": lambda: fluids(
                 "interface", lambda x: 1.0*(x < 1)),
             "two fluids, all cells mixed": lambda: fluids("mixed", lambda x: 0.5 + 0*x)}
    least = {}
    for _ in range(REPEATS):
        for name, make in kinds.items():
            case = make()
            t, steps = run(case, OWN)
            least[name] = min(least.get(name, 1e9), 1e9*t/n[0]/n[1]/(steps - 1))
    first = least["one gas"]
    return [["400 x 200 cells, van Leer, one core", "ns/cell-step", "over one gas"]] + [
        [name, f"{t:.0f}", f"{t/first:.2f}"] for name, t in least.items()]


def main():
    folder = os.path.join(HERE, "../run")
    os.makedirs(folder, exist_ok=True)
    print("real-time priority" if realTime() else "no real-time priority")
    for part in (tubes, step):
        if sys.argv[1:] and part.__name__ not in sys.argv[1:]:
            continue
        rows = part()
        with open(os.path.join(folder, f"fluids-{part.__name__}.csv"), "w", newline="") as f:
            csv.writer(f).writerows(rows)
        widths = [max(len(str(r[i])) for r in rows) for i in range(len(rows[0]))]
        for r in rows:
            print("  ".join(str(v).ljust(w) for v, w in zip(r, widths)), flush=True)
        print()


if __name__ == "__main__":
    main()
