"""Speed and memory of the time step, beside what the machine can do.

The 3D case is the block of the peers' comparison: 262144 points (32^3 cells
with 8 points) in 40 x 40 x 36 cells of 1/32 m, E 1e6, nu 0.3, rho 1000, gravity,
bottom fixed, dt 2.5e-4 s, double precision, full steps with FLIP (MUSL), no
output; and the same block free, without gravity, moving 0.1 cell per step.
The 2D case is a square of 256^2 cells with 4 points. "tetrahedra" is the block in
30 x 30 x 27 boxes cut into six tetrahedra each, with 4 points per cell.

Peers' rates (fastest of six open codes, same block, their machine with 22 GB/s
triad and 58 GFlop/s): linear 2.00, GIMP 0.92 M point-steps/s (MPM3D-F90),
quadratic B-splines 0.72. The last column divides by the peer's rate and by the
larger of the ratios of triad and FMA, so that a faster machine is no merit.

Best of three of each; run on an idle machine.

    rates.py -processors 2      the block and the spall tutorial on 1 and 2
    rates.py -laws              the block at rest with other laws than linearElastic
    rates.py -cells             nodeDual on cells of all kinds beside linear on boxes,
                                at rest, moving along x and obliquely: processor time,
                                parts of the step, what finding the points' cells and
                                sorting take, moving along x; the best of five
                                runs, alternating, at real-time priority on one core
                                where the user may have it
"""

import csv
import os
import re
import shutil
import subprocess
import sys
from types import SimpleNamespace

HERE = os.path.dirname(os.path.abspath(__file__))
RUN = os.path.join(HERE, "run")
PEERS = {"linear": 2.00, "GIMP": 0.92, "quadraticBSpline": 0.72}
SHAPES = {"block": tuple(PEERS) + ("nodeDual",), "square": ("linear", "GIMP", "nodeDual"),
          "tetrahedra": ("nodeDual",)}
sys.path.insert(0, os.path.join(HERE, "../tests/lib"))


def run(command, folder):
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if result.returncode:
        sys.exit(f"{' '.join(command)} failed in {folder}:\n"
                 + (result.stdout + result.stderr)[-2000:])
    return result.stdout


def number(text, name):
    return float(re.search(re.escape(name) + r"\s+([-+.\deE]+)", text).group(1))


def set_text(path, pattern, value):
    with open(path) as f:
        text = f.read()
    new, n = re.subn(pattern, lambda m: value, text, flags=re.M)
    if not n:
        sys.exit(f"{path}: no {pattern}")
    with open(path, "w") as f:
        f.write(new)


#: Blocks of other cells than boxes: kind (boxOfCells), boxes of which they are made.
#: Polyhedra are the dual of the tetrahedra
CELLS = {"tetrahedra": ("tets", (30, 30, 27)), "polyhedra": ("tets", (30, 30, 27)),
         "prisms": ("prisms", (30, 30, 27)), "hexahedra": ("hexes", (40, 40, 36))}

#: Blocks of boxes of which some are halved, in the middle and above the points
REFINED = {"refined": "(0.5 0.5 0.25) (0.75 0.75 0.5)",
           "refinedAbove": "(0.5 0.5 1.07) (0.75 0.75 1.125)"}


def prepare(name, template, velocity=None, small=False):
    case = os.path.join(RUN, name)
    shutil.rmtree(case, ignore_errors=True)
    solid = template != "square"
    shutil.copytree(os.path.join(HERE, "block" if solid else template), case)
    points = os.path.join(case, "system/setMaterialPointsDict")
    if velocity:
        set_text(points, r"^velocity .*", f"velocity ({velocity});")
        if solid:
            os.remove(os.path.join(case, "constant/g"))
            set_text(os.path.join(case, "0/U.block"), r"bottom \{.*\}",
                     "bottom { type calculated; }")
    if small:
        set_text(points, r"^high .*", "high 0.16;")
        if solid:
            set_text(points, r"^top .*", "top 0.04;")
    if template in CELLS:
        from cellMesh import boxOfCells
        kind, n = CELLS[template]
        boxOfCells(SimpleNamespace(path=case), kind, (0, 0, 0), (1.25, 1.25, 1.125), n,
                   {"bottom": ("wall", ("z-",)),
                    "others": ("patch", ("x-", "x+", "y-", "y+", "z+"))},
                   kept=[(d, k*n[0]//10) for d in (0, 1) for k in (1, 9)]
                   + [(2, 8*n[2]//9)])
        if template == "polyhedra":
            run(["polyDualMesh", "60", "-overwrite"], case)
    else:
        run(["blockMesh"], case)
    if template in REFINED:
        with open(os.path.join(case, "system/topoSetDict"), "w") as f:
            f.write("FoamFile { version 2.0; format ascii; class dictionary;"
                    " object topoSetDict; }\nactions ( { name fine; type cellSet; action new;"
                    f" source boxToCell; sourceInfo {{ box {REFINED[template]}; }} }} );\n")
        run(["topoSet"], case)
        run(["refineHexMesh", "fine", "-overwrite"], case)
    run(["setMaterialPoints"], case)
    return case


def measure(case, shape, transfer, steps):
    set_text(os.path.join(case, "system/fvSolution"), r"materialPoints\s*\{[^}]*\}",
             "materialPoints { shapeFunction %s; %s }" % (shape, transfer))
    return run(["stepRate", "-steps", str(steps), "-warmup", "3", "-repeat", "3"], case)


def processors(most):
    """Rates on 1 to so many processors, each with equal shares of the points."""
    rows = []
    for name, shapes in (("block", tuple(PEERS)), ("spall", ("GIMP",))):
        if name == "block":
            case = prepare("ranks-block", "block")
        else:
            case = os.path.join(RUN, "ranks-spall")
            shutil.rmtree(case, ignore_errors=True)
            shutil.copytree(os.path.join(HERE, "../tutorials/spall"), case,
                            ignore=lambda folder, names: [
                                n for n in names if n not in (
                                    "0", "constant", "system") and folder.endswith("spall")])
            run(["blockMesh"], case)
            set_text(os.path.join(case, "system/controlDict"), r"^functions[\s\S]*", "")
        run(["setMaterialPoints", "-cellWeights"], case)
        for shape in shapes:
            set_text(os.path.join(case, "system/fvSolution"),
                     r"materialPoints\s*\{[^}]*\}",
                     f"materialPoints {{ shapeFunction {shape}; transfer FLIP; }}")
            one = None
            for n in range(1, most + 1):
                with open(os.path.join(case, "system/decomposeParDict"), "w") as f:
                    f.write("FoamFile { version 2.0; format ascii; class dictionary;"
                            " object decomposeParDict; }\n"
                            f"numberOfSubdomains {n}; method hierarchical;"
                            " weightField cellWeights;\n"
                            f"hierarchicalCoeffs {{ n ({n} 1 1); delta 0.001; order xyz; }}\n")
                command = ["stepRate", "-steps", "20", "-warmup", "3", "-repeat", "3"]
                if n > 1:
                    run(["decomposePar", "-force"], case)
                    command = ["mpirun", "--allow-run-as-root", "-np", str(n)] \
                        + command + ["-parallel"]
                rate = number(run(command, case), "rate [M point-steps/s]")
                one = one or rate
                rows.append([name, shape, n, f"{rate:.2f}", f"{rate/one:.3f}"])
                print("  ".join(str(v) for v in rows[-1]), flush=True)
    with open(os.path.join(RUN, "processors.csv"), "w", newline="") as f:
        csv.writer(f).writerows(
            [["case", "shape", "processors", "M point-steps/s", "over one"]] + rows)


#: The block's stiffness in other laws. Yield stresses far below the block's
#: weight, so that most points flow
COOK = ("rho 1000; G 384615; A 10; B 100; n 0.3; C 0.01; m 1; referenceRate 1;"
        " referenceTemperature 300; meltTemperature 1000; cp 400; beta 0.9; ")
LAWS = {
    "linearElastic": "rho 1000; E 1e6; nu 0.3;",
    "neoHookean": "rho 1000; E 1e6; nu 0.3;",
    "MooneyRivlin": "rho 1000; c10 1e5; c01 9e4; K 833333;",
    "J2Plasticity": "rho 1000; E 1e6; nu 0.3; yield 100; hardening linear; H 1e4;",
    "JohnsonCook": COOK + "K 833333;",
    "JohnsonCook, energy": COOK + "equationOfState { type MieGrueneisen; C0 28.87;"
                                  " S 1.5; Gamma0 2; }",
    "JohnsonCook, energy, q": COOK + "equationOfState { type MieGrueneisen; C0 28.87;"
                                     " S 1.5; Gamma0 2; }"
                                     " bulkViscosity { linear 0.06; quadratic 1.5; }",
    "DruckerPrager": "rho 1000; E 1e6; nu 0.3; cohesion 10; frictionAngle 10;"
                     " dilationAngle 0; match outer;",
    "MohrCoulomb": "rho 1000; E 1e6; nu 0.3; cohesion 10; frictionAngle 10;"
                   " dilationAngle 0;",
    "NewtonianFluid": "rho 1000; mu 1; K 833333;",
}


def laws():
    """Rates of the block with each law, over that of linearElastic."""
    case = prepare("laws", "block")
    rows = [["law", "shape", "M point-steps/s", "over linearElastic"]]
    for shape in ("linear", "GIMP"):
        first = None
        for name, entries in LAWS.items():
            with open(os.path.join(case, "constant/phaseProperties"), "w") as f:
                f.write("FoamFile { version 2.0; format ascii; class dictionary;"
                        " object phaseProperties; }\nphases (block);\nblock {"
                        f" constitutiveModel {{ type {name.split(',')[0]}; {entries} }} }}\n")
            run(["setMaterialPoints"], case)
            rate = number(measure(case, shape, "transfer FLIP;", 10),
                          "rate [M point-steps/s]")
            first = first or rate
            rows.append([name, shape, f"{rate:.2f}", f"{rate/first:.2f}"])
            print("  ".join(rows[-1]), flush=True)
    with open(os.path.join(RUN, "laws.csv"), "w", newline="") as f:
        csv.writer(f).writerows(rows)


#: Motions of the block: 0.1 of the boxes of the block a step, along x and obliquely
MOTIONS = {"rest": None, "moving": "12.5 0 0", "oblique": "8.9 6.7 5.7"}


def cells():
    """Rates of nodeDual on cells of all kinds over that of linear on boxes."""
    first = ["chrt", "-r", "1", "taskset", "-c", str(max(os.sched_getaffinity(0)))]
    try:
        run(first + ["true"], RUN)
    except (SystemExit, FileNotFoundError):
        first = []
    triad, fma = re.findall(r"([\d.]+) G", run(first + ["machineRates"], RUN))
    print(f"machine, one core: triad {triad} GB/s, FMA {fma} GFlop/s; compiler flags"
          f" {os.environ.get('MPM_CXXFLAGS', '?')}; {' '.join(first) or 'no'} priority\n")
    runs = [("block", "linear")] + [(k, "nodeDual") for k in ("block", *REFINED, *CELLS)]
    cases = {(k, v): prepare(f"cells-{k}-{v}", k, MOTIONS[v])
             for k in dict(runs) for v in MOTIONS}
    best = {}
    for _ in range(5):
        for kind, shape in runs:
            for motion in MOTIONS:
                case = cases[kind, motion]
                set_text(os.path.join(case, "system/fvSolution"),
                         r"materialPoints\s*\{[^}]*\}",
                         f"materialPoints {{ shapeFunction {shape}; transfer FLIP;"
                         " PICfraction 0; }")
                out = run(first + ["stepRate", "-steps", "5", "-warmup", "2", "-repeat", "1",
                                   "-cpuTime"], case)
                ns = number(out, "ns per point and step")
                parts = {p: number(out.split("[%]:")[1], p)*ns/100
                         for p in ("nodes", "move", "sort", "project", "force")}
                key = kind, shape, motion
                # Parts are those of the clock on the wall
                least, of, _ = best.get(key, (ns, parts, 0))
                best[key] = (min(ns, least), {p: min(parts[p], of[p]) for p in of},
                             number(out, "points"))
    rows = [["cells", "shape", "points", "ns at rest", "over linear", "ns along x",
             "over linear", "ns oblique", "over linear", "finding cells", "sorting"]]
    for kind, shape in runs:
        of = {v: best[kind, shape, v] for v in MOTIONS}
        rows.append([kind, shape, f"{of['rest'][2]:.0f}",
                     *(text for v in MOTIONS
                       for text in (f"{of[v][0]:.1f}",
                                    f"{of[v][0]/best['block', 'linear', v][0]:.2f}")),
                     *(f"{of['moving'][1][p] - of['rest'][1][p]:.1f}"
                       for p in ("move", "sort"))])
        print(kind, shape, {v: {k: round(x, 1) for k, x in of[v][1].items()}
                            for v in MOTIONS})
    widths = [max(len(r[i]) for r in rows) for i in range(len(rows[0]))]
    for r in rows:
        print("  ".join(v.ljust(w) for v, w in zip(r, widths)))
    with open(os.path.join(RUN, "cells.csv"), "w", newline="") as f:
        csv.writer(f).writerows(rows)


def main():
    if len(sys.argv) > 1 and sys.argv[1] == "-cells":
        os.makedirs(RUN, exist_ok=True)
        return cells()
    if len(sys.argv) > 1 and sys.argv[1] == "-laws":
        os.makedirs(RUN, exist_ok=True)
        return laws()
    if len(sys.argv) > 2 and sys.argv[1] == "-processors":
        os.makedirs(RUN, exist_ok=True)
        return processors(int(sys.argv[2]))
    shutil.rmtree(RUN, ignore_errors=True)
    os.makedirs(RUN)

    machine = run(["machineRates"], RUN)
    triad, fma = (float(x) for x in re.findall(r"([\d.]+) G", machine))
    factor = max(triad/22, fma/58)
    print(f"machine, one core: triad {triad} GB/s, FMA {fma} GFlop/s: "
          f"{factor:.2f} times the peers' machine")
    print(f"compiler flags: {os.environ.get('MPM_CXXFLAGS', '?')}\n")

    flip, fmpm = "transfer FLIP; PICfraction 0;", "transfer FMPM; order 2;"
    rows = []
    for template, motion, velocity in (
            ("block", "at rest", None), ("block", "translating", "12.5 0 0"),
            ("tetrahedra", "at rest", None), ("tetrahedra", "translating", "12.5 0 0"),
            ("square", "at rest", None), ("square", "translating", "19.53125 0 0")):
        case = prepare(f"{template}-{motion.replace(' ', '')}", template, velocity)
        for shape in SHAPES[template]:
            for name, transfer in (("FLIP", flip), ("FMPM(2)", fmpm)):
                out = measure(case, shape, transfer, 10)
                rate = number(out, "rate [M point-steps/s]")
                share = re.search(r"share of the step \[%\]: (.*)", out).group(1)
                peer = (rate/PEERS[shape]/factor
                        if template == "block" and name == "FLIP" and shape in PEERS
                        else None)
                rows.append([template, motion, shape, name, f"{rate:.2f}",
                             f"{number(out, 'ns per point and step'):.1f}",
                             f"{number(out, 'columns and buffers [bytes per point]'):.0f}",
                             f"{number(out, 'node columns [bytes per point]'):.0f}",
                             number(out, "peak memory [kB]"), number(out, "points"),
                             "" if peer is None else f"{peer:.2f}", share])

    # Memory: the same mesh with a few points instead
    base = {}
    for template in SHAPES:
        case = prepare(f"{template}-small", template, small=True)
        for shape in SHAPES[template]:
            out = measure(case, shape, flip, 2)
            base[template, shape] = (number(out, "peak memory [kB]"), number(out, "points"))

    header = ["case", "motion", "shape", "transfer", "M point-steps/s", "ns",
              "columns B/pt", "nodes B/pt", "(RSS-RSS0)/pt", "raw RSS/pt",
              "over the peer", "share of the step [%]"]
    table = []
    for r in rows:
        rss0, n0 = base[r[0], r[2]]
        table.append(r[:8] + [f"{(r[8] - rss0)*1024/(r[9] - n0):.0f}",
                              f"{r[8]*1024/r[9]:.0f}"] + r[10:])
    with open(os.path.join(RUN, "rates.csv"), "w", newline="") as f:
        csv.writer(f).writerows([header] + table)
    widths = [max(len(str(r[i])) for r in [header] + table) for i in range(len(header))]
    for r in [header] + table:
        print("  ".join(str(v).ljust(w) for v, w in zip(r, widths)))
    print(f"\nCSV: {os.path.join(RUN, 'rates.csv')}")


if __name__ == "__main__":
    main()
