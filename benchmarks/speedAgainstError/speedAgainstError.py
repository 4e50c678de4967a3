#!/usr/bin/env python3
"""Error against core-seconds of all schemes on scenes with a known answer.

    Allrun                  everything: some minutes of an idle core
    Allrun -quick           the two coarsest resolutions of each, 2 to 3 minutes
    Allrun word ...         schemes and scenes whose name has one of the words, or is
                            one: Allrun "GIMP FLIP" "nodeDual, tetrahedra" spall

Writes run/results.csv (one row per run) and run/speedAgainstError.png (error over
core-seconds, one line per scheme from coarse to fine), and prints what each
scheme costs down to given errors. Core-seconds are those of the solver's steps,
without start-up and meshing; they belong to a machine.
"""

import csv
import math
import os
import sys

import scenes
from foamCase import RunFailed

SHAPES = {name: {"shapeFunction": name} for name in (
    "GIMP", "linear", "quadraticBSpline", "cubicBSpline", "nodeDual")}
SHAPES.update({
    "nodeDual, triangles": {"shapeFunction": "nodeDual", "cells": "prisms"},
    "nodeDual, moved boxes": {"shapeFunction": "nodeDual", "cells": "hexes"},
    **{f"{shape}, boxes in 3D": {"shapeFunction": shape, "cells": "boxes in 3D"}
       for shape in ("GIMP", "nodeDual")},
    "nodeDual, tetrahedra": {"shapeFunction": "nodeDual", "cells": "tets"},
    "nodeDual, polyhedra": {"shapeFunction": "nodeDual", "cells": "polyhedra"}})

#: A scheme more: a line here
TRANSFERS = {
    "FLIP": {"transfer": "FLIP", "PICfraction": 0},
    "FLIP + 1 % PIC": {"transfer": "FLIP", "PICfraction": 0.01},
    "FMPM 1": {"transfer": "FMPM", "order": 1},
    "FMPM 2": {"transfer": "FMPM", "order": 2},
    "FMPM 4": {"transfer": "FMPM", "order": 4},
    "XPIC 2": {"transfer": "XPIC", "order": 2},
    "APIC": {"transfer": "APIC"},
    "FLIP USAVG": {"transfer": "FLIP", "PICfraction": 0, "stressUpdate": "USAVG"}}

SCHEMES = {f"{shape} {name}": {**entries, **transfer}
           for shape, entries in SHAPES.items() for name, transfer in TRANSFERS.items()}

COLUMNS = ("scene", "scheme", "cells", "error", "unit", "steps", "core-seconds",
           "with start-up", "more")


def run(scene, scheme, cells):
    measure, unit = scenes.SCENES[scene][:2]
    label = "".join(c for c in scheme.replace("+", "-") if c not in " ,%")
    try:
        found = measure(label, SCHEMES[scheme], cells)
        if found is None:
            return None
        case, error, seconds, more = found
        steps, cost = case.nSteps(), max(case.solverSeconds(), 0.01)
        figures = ", ".join(f"{k} {v:.4g}" for k, v in more.items())
    except RunFailed as reason:
        error = cost = seconds = math.nan
        steps, figures = 0, "fails: " + str(reason)[:120]
    row = dict(zip(COLUMNS, (scene, scheme, cells, error, unit, steps, cost, seconds,
                             figures)))
    print(f"{scene:13s} {scheme:32s} {cells:5d} {error:+10.4g} {unit:24s} "
          f"{cost:8.2f} s  {figures}", flush=True)
    return row


def lineOf(rows, scene, scheme):
    """Cost and size of the error, coarse to fine."""
    return [(r["core-seconds"], abs(r["error"])) for r in rows
            if (r["scene"], r["scheme"]) == (scene, scheme) and math.isfinite(r["error"])]


def plot(rows, path):
    """One picture, a panel for each scene."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    shown = list(dict.fromkeys(r["scene"] for r in rows))
    figure, axes = pyplot.subplots(1, len(shown), figsize=(4.6*len(shown), 6), squeeze=False)
    handles = {}
    for scene, ax in zip(shown, axes[0]):
        for scheme in SCHEMES:
            line = lineOf(rows, scene, scheme)
            if line:
                shape = max((s for s in SHAPES if scheme.startswith(s + " ")), key=len)
                transfer = scheme[len(shape) + 1:]
                at = list(SHAPES).index(shape)
                style = {"marker": "osD^vXP<>ph"[at], "linestyle": ("-", ":", "--", "-.")[at % 4]}
                colour = f"C{list(TRANSFERS).index(transfer)}"
                ax.loglog(*zip(*line), lw=1, ms=5, color=colour, **style)
                handles[shape] = pyplot.Line2D([], [], lw=1, ms=5, color="0.4", **style)
                handles[transfer] = pyplot.Line2D([], [], lw=3, color=colour)
        ax.set_xlabel("core-seconds of the steps")
        ax.set_ylabel("error: " + scenes.SCENES[scene][1])
        ax.set_title(f"{scene}: cells " + ", ".join(
            map(str, sorted({r["cells"] for r in rows if r["scene"] == scene}))), fontsize=10)
        ax.grid(True, which="both", alpha=0.3)
    names = [n for n in (*SHAPES, *TRANSFERS) if n in handles]
    figure.legend([handles[n] for n in names], names, loc="lower center", ncol=5, fontsize=8)
    figure.tight_layout(rect=(0, 0.03 + 0.035*math.ceil(len(names)/5), 1, 1))
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def costAt(line, error):
    """Least core-seconds from which on all finer runs have at most this error."""
    cost = math.nan
    for seconds, e in reversed(line):
        if e > error:
            break
        cost = seconds
    return cost


def summary(rows):
    for scene in dict.fromkeys(r["scene"] for r in rows):
        levels = scenes.SCENES[scene][3]
        print(f"\n{scene}, {scenes.SCENES[scene][1]}: core-seconds for an error of at most "
              + ", ".join(f"{v:g}" for v in levels) + "; error of the finest run")
        table = []
        for scheme in SCHEMES:
            line = lineOf(rows, scene, scheme)
            if line:
                costs = [costAt(line, v) for v in levels]
                table.append((*[math.inf if math.isnan(c) else c for c in costs[::-1]],
                              scheme, costs, line[-1][1]))
        for *_, scheme, costs, last in sorted(table, key=lambda r: (r[:3], r[-1])):
            print(f"    {scheme:32s}" + "".join(
                f"{'-' if math.isnan(c) else f'{c:.2f}':>9s}" for c in costs)
                + f"{last:12.3g}")


def main():
    quick = "-quick" in sys.argv[1:]
    words = [w for w in sys.argv[1:] if w != "-quick"]
    names = [*SCHEMES, *scenes.SCENES]
    unknown = [w for w in words if not any(w in name for name in names)]
    if unknown:
        sys.exit(f"Nothing has {unknown[0]} in its name; there are: " + ", ".join(names))

    def chosen(group):
        some = [n for n in group
                if n in words or any(w in n for w in words if w not in names)]
        return some or list(group)

    os.makedirs(scenes.RUN, exist_ok=True)
    rows = []
    for scene in chosen(scenes.SCENES):
        resolutions = scenes.SCENES[scene][2]
        for scheme in chosen(SCHEMES):
            for cells in resolutions[:2] if quick else resolutions:
                row = run(scene, scheme, cells)
                if row:
                    rows.append(row)
    with open(os.path.join(scenes.RUN, "results.csv"), "w", newline="") as f:
        writer = csv.DictWriter(f, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    plot(rows, os.path.join(scenes.RUN, "speedAgainstError.png"))
    summary(rows)
    print(f"\nTable and picture: {scenes.RUN}")


if __name__ == "__main__":
    main()
