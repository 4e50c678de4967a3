#!/usr/bin/env python3
"""The three examples of Zhang, Ma & Giguere (Computation of multi-material interactions using
material point method, section 4), each with the recommended scheme and two others, on boxes
and on triangles, with air and without: error against core-seconds.

    Allrun              everything: ten minutes of a core
    Allrun word ...     runs that have all of the words: Allrun spall triangles, Allrun GIMP 20
    Allrun -table       only table and picture, of the runs that are there

Writes benchmarks/run/paperExamples/results.csv (a row per run; later runs take the places
of earlier ones), table.md and paperExamples.png. Core-seconds are user time of the solver
with start-up; they belong to a machine.
"""

import csv
import math
import os
import resource
import subprocess
import sys

import examples
from mpm.case import Case, RunFailed

RUN = os.path.join(examples.HERE, "../run/paperExamples")
RESULTS, TABLE = (os.path.join(RUN, name) for name in ("results.csv", "table.md"))
PICTURE = os.path.join(RUN, "paperExamples.png")

FLIP1 = {"transfer": "FLIP", "PICfraction": 0.01}
USAVG = {"transfer": "FLIP", "PICfraction": 0.005, "stressUpdate": "USAVG"}
FMPM3 = {"transfer": "FMPM", "order": 3, "strainFilter": 1}

#: Of each example and mesh; the first is the one that doc/guide/schemes.md or the tutorial
#: recommends. PAPER: its equations 5 to 9, linear functions, FLIP, stresses after the move
PAPER = {"shapeFunction": "linear", "transfer": "FLIP", "PICfraction": 0}
SCHEMES = {
    "spall": {
        "boxes": {"GIMP FMPM 2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2},
                  "GIMP FLIP + 1 % PIC": {"shapeFunction": "GIMP", **FLIP1},
                  "linear FLIP (paper)": PAPER},
        "triangles": {"nodeDual FMPM 3": {"shapeFunction": "nodeDual", **FMPM3},
                      "nodeDual FMPM 2": {"shapeFunction": "nodeDual", **FMPM3, "order": 2},
                      "nodeDual FLIP + 1 % PIC": {"shapeFunction": "nodeDual", **FLIP1}}},
    "halfCylinder": {
        "boxes": {"GIMP FLIP + 0.5 % PIC": {"shapeFunction": "GIMP", **USAVG},
                  "GIMP FMPM 2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2},
                  "linear FLIP (paper)": PAPER},
        "triangles": {"nodeDual FLIP + 0.5 % PIC": {"shapeFunction": "nodeDual", **USAVG},
                      "nodeDual FMPM 3": {"shapeFunction": "nodeDual", **FMPM3},
                      "nodeDual APIC": {"shapeFunction": "nodeDual", "transfer": "APIC"}}},
    "projectile": {
        "boxes": {"linear APIC": {"shapeFunction": "linear", "transfer": "APIC"},
                  "GIMP APIC": {"shapeFunction": "GIMP", "transfer": "APIC"},
                  "linear FLIP (paper)": PAPER},
        "triangles": {"nodeDual APIC": {"shapeFunction": "nodeDual", "transfer": "APIC"},
                      "nodeDual FMPM 3": {"shapeFunction": "nodeDual", **FMPM3},
                      "nodeDual FLIP": {"shapeFunction": "nodeDual", "transfer": "FLIP",
                                        "PICfraction": 0}}}}

#: Resolutions by mesh, without and with air
CELLS = {"spall": {"boxes": ((20, 40, 80), (20, 40)), "triangles": ((20, 40, 80), (20, 40))},
         "halfCylinder": {"boxes": ((10, 20, 40), (10, 20)),
                          "triangles": ((10, 20), (10, 20))},
         "projectile": {"boxes": ((10, 20), ()), "triangles": ((10,), ())}}

#: What errors of halfCylinder are taken from; one run on triangles that is long
FINEST = ("halfCylinder", "boxes", "no", "GIMP FLIP + 0.5 % PIC", 80)
LONG = ("projectile", "triangles", "no", "nodeDual APIC", 15)

ERRORS = {"spall": "failure at the mid-plane, after the exact instant [ns]",
          "halfCylinder": "energy in cracks, from the finest run [% of impact]",
          "projectile": "speed of the interface, from Tate's [%]"}
SECOND = {"spall": "compression, from the exact one [%]",
          "halfCylinder": "residual of the energy [% of impact]",
          "projectile": "tail, from Tate's [mm]"}
COLUMNS = ("example", "mesh", "air", "scheme", "cells", "value", "second", "seconds", "steps",
           "more")


class Run(Case):
    limit = 1200

    def __init__(self, *words):
        super().__init__(os.path.join(RUN, "-".join(
            "".join(c for c in str(w) if c.isalnum() or c == ".") for w in words)))
        self.seconds = math.nan

    def solve(self):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.run("materialPointFoam")
        self.seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

    def runScript(self, path):
        subprocess.run([sys.executable, "-B", path], cwd=self.path, check=True)


def run(key):
    example, mesh, air, scheme, cells = key
    case = Run(*key)
    try:
        value, second, more = getattr(examples, example)(
            case, mesh, air == "yes", SCHEMES[example][mesh][scheme], cells)
        more = ", ".join(f"{name} {v:.4g}" for name, v in more.items())
    except RunFailed as reason:
        value, second, more = math.nan, math.nan, "fails: " + str(reason).replace("\n", " ")[:120]
    steps = case.nSteps() if os.path.exists(case.file("log.materialPointFoam")) else 0
    row = dict(zip(COLUMNS, (*key, value, second, case.seconds, steps, more)))
    print(" ".join(f"{w:12.4g}" if isinstance(w, float) else f"{w!s:12s}"
                   for w in row.values()), flush=True)
    return row


def keys():
    found = [(example, mesh, air, scheme, cells) for example, meshes in CELLS.items()
             for mesh, sizes in meshes.items() for air, some in zip(("no", "yes"), sizes)
             for scheme in SCHEMES[example][mesh] for cells in some]
    return [*found, FINEST, LONG]


def read():
    """Rows by key, with numbers."""
    if not os.path.exists(RESULTS):
        return {}
    with open(RESULTS, newline="") as f:
        rows = list(csv.DictReader(f))
    for row in rows:
        row.update(cells=int(row["cells"]),
                   **{name: float(row[name]) for name in ("value", "second", "seconds")})
    return {tuple(row[c] for c in COLUMNS[:5]): row for row in rows}


def write(rows):
    with open(RESULTS, "w", newline="") as f:
        writer = csv.DictWriter(f, COLUMNS)
        writer.writeheader()
        writer.writerows(rows[key] for key in keys() if key in rows)


def lines(rows):
    """Runs of a scheme from coarse to fine: (cells, error, second figure, seconds)."""
    found = {}
    for key in keys():
        if key in rows and key != FINEST:
            row = rows[key]
            reference = rows[FINEST]["value"] if key[0] == FINEST[0] and FINEST in rows else 0
            found.setdefault(key[:4], []).append(
                (key[4], row["value"] - reference, row["second"], row["seconds"]))
    return found


def table(rows):
    """Markdown: error, second figure / core-seconds of each resolution."""
    text = []
    for example, what in ERRORS.items():
        some = {key: line for key, line in lines(rows).items() if key[0] == example}
        sizes = sorted({cells for line in some.values() for cells, *_ in line})
        text += [f"{example}: {what}; {SECOND[example]} / core-seconds", "",
                 "| mesh | air | scheme | " + " | ".join(map(str, sizes)) + " |",
                 "| --- "*(3 + len(sizes)) + "|"]
        for (_, *words), line in some.items():
            at = {cells: f"{'-' if math.isnan(error) else f'{error:+.3g}'}, {second:+.2g}"
                  f" / {seconds:.2g}" for cells, error, second, seconds in line}
            text.append("| " + " | ".join((*words, *(at.get(n, "") for n in sizes))) + " |")
        text.append("")
    return "\n".join(text)


def plot(rows):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, len(ERRORS), figsize=(14, 6))
    for (example, what), ax in zip(ERRORS.items(), axes):
        for (name, mesh, air, scheme), line in lines(rows).items():
            line = [(seconds, error if example == FINEST[0] else abs(error))
                    for _, error, _, seconds in line if math.isfinite(error)]
            if name == example and line:
                ax.loglog(*zip(*line), "s" if mesh == "boxes" else "^", lw=1, ms=5,
                          color=f"C{[*SCHEMES[name][mesh]].index(scheme) + 3*(mesh != 'boxes')}",
                          ls=":" if air == "yes" else "-",
                          mfc="w" if air == "yes" else None,
                          label=scheme if air == "no" else None)
        if example == FINEST[0]:
            ax.set_yscale("linear")
        if example == "spall":
            ax.axhline(60, color="k", ls="--", lw=0.8, label="the paper: 1.18 for 1.12 us")
        ax.set(title=example, xlabel="core-seconds", ylabel=what)
        ax.grid(True, which="both", alpha=0.3)
        ax.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=2)
    figure.suptitle("squares: on boxes; triangles: on triangles; dotted and open: in air",
                    fontsize=10)
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110)


def main():
    words = sys.argv[1:]
    chosen = [] if words == ["-table"] else [
        key for key in keys() if all(w in map(str, key) or w in key[3] for w in words)]
    if words != ["-table"] and not chosen:
        sys.exit(f"paperExamples.py: no run has all of: {' '.join(words)}")
    os.makedirs(RUN, exist_ok=True)
    rows = read()
    for key in chosen:
        rows[key] = run(key)
        write(rows)
    rows = read()
    text = table(rows)
    with open(TABLE, "w") as f:
        f.write(text)
    total = sum(row["seconds"] for row in rows.values() if row["seconds"] > 0)
    print(text + f"{total:.0f} core-seconds in all")
    plot(rows)
    print(f"Table and picture: {RUN}")


if __name__ == "__main__":
    main()
