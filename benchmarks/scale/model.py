"""The time of a step against the number of ranks, of what scale.py has counted.

    t = a points/ranks + b cells/ranks + bytes/bandwidth + messages latency
        + (all-reduces + 2 trees) log2(ranks) latency

a, b: processor time outside MPI on 1 and 2 ranks of both sizes, least squares of the relative
errors. Messages: so many to a rank that touches by a face, an edge or a corner; bytes: per
face between ranks; all-reduces (MPI_Allreduce) and trees (OpenFOAM's reduce of other
operations: up and down a tree of messages): constants of a scene. These from 2, 4 and 8 ranks.
A rank of many is a cube with 6 + 12 + 8 neighbours, all have the same work, nothing overlaps
with computing, and all bytes leave the node."""

import csv
import os

import numpy as np

#: s, and bytes/s of a node: what the checks of CSCS expect of osu_latency and osu_bw on Piz
#: Daint (reframe-hpc/reframe, pull request 1232). Ranks that share a node: assumed. Beside it:
#: an MPI_Allreduce of 8 bytes on 256 ranks of two nodes of ARCHER2 takes 6.9 us
#: (docs.archer2.ac.uk/user-guide/containers), 8 latencies are 12.8 us
LATENCY, BANDWIDTH, PER_NODE = 1.6e-6, 9.6e9, 64

RANKS = (64, 1024, 16384)
KINDS = {"faces": 6, "edges": 12, "corners": 8}

#: Points and cells of all ranks (strong) and of each (weak)
STRONG = {"points": (1e9, 1e9/8), "gas": (1e8, 1e8), "fluids": (0, 1e8)}
WEAK = {"points": (1e5, 1e5/8), "gas": (1e5, 1e5), "fluids": (0, 1e5)}


def read(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="") as f:
        return [{k: float(v) if v and k != "scene" else v for k, v in row.items()}
                for row in csv.DictReader(f)]


def proportion(x, y):
    """c of y = c x with the least relative errors, and the largest of these."""
    ratio = np.asarray(x, float)/np.asarray(y, float)
    c = ratio.sum()/(ratio**2).sum()
    return c, np.max(abs(c*ratio - 1))


def touching(ranks):
    """Pairs (each way) of 1, 2 x 1, 2 x 2, 2 x 2 x 2 boxes by faces, edges, corners."""
    d = int(np.log2(ranks))
    return {"faces": ranks*d, "edges": ranks*(d*(d - 1)//2), "corners": ranks*(d == 3)}


def fit(rows):
    """Constants of a scene."""
    few = [r for r in rows if r["ranks"] <= 2]
    columns = [c for c in ("points", "cells") if any(r[c] for r in rows)]
    if rows[0]["scene"] == "points":
        columns.remove("cells")     # they are as many per point in both sizes
    matrix = np.array([[r[c]/r["computing [s]"] for c in columns] for r in few])
    m = {"points": 0.0, "cells": 0.0,
         **dict(zip(columns, np.linalg.lstsq(matrix, np.ones(len(few)), rcond=None)[0]))}
    many = [r for r in rows if r["ranks"] > 1]
    eight = [r for r in rows if r["ranks"] == 8]
    m["messages"] = {k: np.mean([r[f"messages over {k}"] for r in eight]) for k in KINDS}
    m["bytes"], m["bytes error"] = proportion([2*r["shared faces"] for r in many],
                                              [r["bytes"] for r in many])
    for name in ("all-reduces", "trees", "to all"):
        m[name] = np.mean([r[name] for r in many])
        m["most " + name] = np.max([r[name] for r in many])
    # Lists of the start that go from all to all: what grows with the faces between ranks. On
    # eight a tree up and down sends seven times what all have. What is written has a sample of
    # the points, equal in both sizes from 10^4 points on
    small, large = sorted(eight, key=lambda r: r["cells"])
    m["lists"] = max(0, (large["lists [bytes]"] - small["lists [bytes]"])/7/2/(
        large["shared faces"] - small["shared faces"]))
    m["files"] = max(r["files"] for r in many)
    return m


def computing(m, points, cells):
    return m["points"]*points + m["cells"]*cells


def seconds(m, ranks, points, cells):
    """Parts of a step of a rank with so many points and cells: computing, bytes, messages,
    sums."""
    messages = sum(n*m["messages"][k] for k, n in KINDS.items())
    return np.array([
        computing(m, points, cells), m["bytes"]*6*cells**(2/3)/(BANDWIDTH/PER_NODE),
        messages*LATENCY, (m["all-reduces"] + 2*m["trees"])*np.log2(ranks)*LATENCY])


def table(head, rows):
    print("\n| " + " | ".join(head) + " |\n|" + " --- |"*len(head))
    for row in rows:
        print("| " + " | ".join(str(c) for c in row) + " |")


def size(r):
    if not r["points"]:
        return f"{r['cells']:.0f} cells"
    return f"{r['points']:.0f} points, {r['cells']:.0f} cells"


def show(rows):
    scenes = [s for s in STRONG if any(r["scene"] == s for r in rows)]
    models = {s: fit([r for r in rows if r["scene"] == s]) for s in scenes}
    table(("constants", "ns per point", "ns per cell", "messages over a face, an edge, a corner",
           "bytes per face, largest error", "all-reduces", "trees", "MPI_Alltoall and the like",
           "lists of the start: bytes per face"),
          [(s, f"{1e9*m['points']:.0f}", f"{1e9*m['cells']:.0f}",
            ", ".join(f"{m['messages'][k]:.2f}" for k in KINDS),
            f"{m['bytes']:.0f}, {100*m['bytes error']:.0f} %",
            f"{m['all-reduces']:.2f} to {m['most all-reduces']:.2f}",
            f"{m['trees']:.2f} to {m['most trees']:.2f}", f"{m['to all']:.2f}",
            f"{m['lists']:.0f}") for s, m in models.items()])
    seen = []
    for r in rows:
        m, p = models[r["scene"]], int(r["ranks"])
        pairs = touching(p)
        seen.append((
            r["scene"], size(r), p, f"{r['shared faces']:.0f}",
            f"{1e3*r['computing [s]']:.2f}",
            f"{1e3*computing(m, r['points'], r['cells']):.2f}",
            f"{r['largest [s]']*p/r['computing [s]']:.2f}", f"{r['messages']:.1f}",
            f"{sum(n*m['messages'][k] for k, n in pairs.items()):.1f}",
            f"{r['bytes']:.0f}", f"{2*m['bytes']*r['shared faces']:.0f}",
            f"{r['all-reduces']:.2f}, {r['trees']:.2f}", f"{r['lists [bytes]']:.0f}"))
    table(("scene", "", "ranks", "shared faces", "computing of all [ms]", "model",
           "largest over mean", "messages of all", "model", "bytes of all", "model",
           "all-reduces, trees", "lists"), seen)
    for name, sizes in (("strong", STRONG), ("weak", WEAK)):
        out = []
        for s, m in models.items():
            for p in RANKS:
                points, cells = (x/(p if name == "strong" else 1) for x in sizes[s])
                t = seconds(m, p, points, cells)
                out.append((s, p, f"{points:.3g}", f"{cells:.3g}",
                            *(f"{1e3*x:.3g}" for x in (t.sum(), *t)),
                            f"{100*t[0]/t.sum():.0f} %",
                            f"{1e-9*p*m['lists']*6*cells**(2/3):.2g}", f"{p*m['files']:.0f}"))
        table((name, "ranks", "points of each", "cells of each", "step [ms]", "computing",
               "bytes", "messages", "sums", "computing's share",
               "lists of the start on each [GB]", "files of a time"), out)
