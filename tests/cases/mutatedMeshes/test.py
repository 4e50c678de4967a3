#!/usr/bin/env python3
"""Mutated meshes: one change of constant/polyMesh at a time (mutations.py).

A small elastic block that moves, turns and is strained, in the middle of a box of
hexahedra, prisms, tetrahedra or polyhedra, with GIMP, linear and node-dual functions, in
vacuum and in a gas; 10 steps. The mesh is changed before setMaterialPoints; if that refuses it,
materialPointFoam gets it too, with the points of the unchanged mesh. Some meshes are
changed on one of two processors.

What must hold for each: exit status 1 with one fatal message that names a file, face,
cell, point or patch, within 10 s; or, where the change is harmless, the result of the
unchanged mesh to 1e-10, point by point; or, where it leaves another good mesh, finite
numbers, mass to 1e-12 and, in vacuum, momentum to 1e-10. No signal, no abort, no NaN,
no hang (30 s on two processors, which may share a core).

    test.py             all
    test.py word ...    those whose name has all of the words
"""

import os
import random
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from blockInGas import P0, gasFields, gasSchemes
from cellMesh import boxOfCells
from foamCase import (PATIENCE, FoamCase, controlDict, mpirun, noSchemes, readInternal,
                      velocityFile)
from launcher import launch
from mutations import (EITHER, MUTATIONS, ON_PROCESSORS, REFUSED, SAME, VALID)
from polyMesh import PolyMesh
from report import Report

LIMIT = 10*PATIENCE
N, STEPS, RHO, E = 6, 10, 1000.0, 1e9
H = 1/N
#: Cells, how far their points are moved, shape function
MESHES = {"boxes": ("hexes", 0, "GIMP"), "moved": ("hexes", 0.2, "nodeDual"),
          "linear": ("hexes", 0.2, "linear"), "prisms": ("prisms", 0.2, "nodeDual"),
          "tets": ("tets", 0.2, "nodeDual"), "polyhedra": ("tets", 0.2, "nodeDual"),
          "gas": ("prisms", 0.2, "nodeDual")}
PLACE = np.array((0.5, 0.5, 0.5))

CRASH = r"printStack|[Ss]egmentation fault|AddressSanitizer|runtime error:" \
    r"|Assertion|terminate called|\[stack trace\]|signal \d"

#: What a message names: a file of the mesh, or what is wrong with its place
NAMES = r"polyMesh/\w+|file \"\w+\" in directory \"polyMesh\"|boundaryField" \
    r"|[Cc]ells? \d|[Ff]aces? \d|[Pp]oints? \d|[Pp]atch" \
    r"|[Rr]egion \w+ has no points|mesh is not that of|leaves the mesh|directions of the" \
    r" mesh|mesh .* has no cells"


def base(name):
    """The unchanged case with its points, and its mesh."""
    kind, moved, shape = MESHES[name]
    flat, gas = kind == "prisms", name == "gas"
    case = FoamCase("mutatedMeshes", "base-" + name)
    n = (N, N, 1 if flat else N)
    patches = {"inlet": ("patch", ("x-",)),
               "walls": ("patch", ("x+", "y-", "y+") + (() if flat else ("z-", "z+"))),
               **({"sides": ("empty", ("z-", "z+"))} if flat else {})}
    boxOfCells(case, kind, (0, 0, 0), (1, 1, 1), n, patches, moved=moved,
               kept=[(d, k) for d in range(2 if flat else 3) for k in (2, 4)])
    conditions = {p: "empty" if t == "empty" else "slip" if gas else "calculated"
                  for p, (t, _) in patches.items()}
    extra = {'"extra.*"': "slip" if gas else "calculated"}
    velocityFile(case, "block", {**conditions, **extra})
    case.write("constant/phaseProperties", {
        "phases": (["air"] if gas else []) + ["block"],
        **({"air": {"type": "gas", "thermo": "perfectGas", "R": 287.0, "gamma": 1.4,
                    "solidFraction": "star"}} if gas else {}),
        "block": {"constitutiveModel": {"type": "linearElastic", "rho": RHO, "E": E,
                                        "nu": 0.2}}})
    case.write("system/setMaterialPointsDict", {"regions": {"block": {
        "phase": "block", "type": "box", "min": (2*H, 2*H, -1 if flat else 2*H),
        "max": (4*H, 4*H, 2 if flat else 4*H), "pointsPerCell": 2,
        "velocity": {"uniform": (20.0, -15.0, 0 if flat else 5.0),
                     "x": "table ((0 (0 0 0)) (1 (40 30 0)))",
                     "y": "table ((0 (0 0 0)) (1 (-20 -50 0)))"},
        **({"stress": "ambient", "pressure": P0} if gas else {})}}})
    case.write("system/fvSolution", {"materialPoints": {
        "shapeFunction": shape, "transfer": "FLIP"}})
    if gas:
        gasFields(case, {**conditions, **extra})
        gasSchemes(case)
    else:
        noSchemes(case)
    dt = 0.2*H/np.sqrt(E/RHO)
    case.write("system/controlDict", controlDict(STEPS*dt, STEPS*dt, deltaT=dt,
                                                 writeFormat="ascii"))
    if name == "polyhedra":
        case.run("polyDualMesh", "60", "-overwrite")
    case.run("setMaterialPoints")
    return case


def run(case, *command):
    """Exit status (None: stopped at the limit) and output."""
    log = case.file("log." + command[-1 - (command[-1] == "-parallel")])
    open(log, "w").close()
    # Two processes that wait for each other may have one core
    status, _ = launch(command, case.path, log,
                       LIMIT*(3 if "-parallel" in command else 1), session=True)
    with open(log, "rb") as f:
        return status, f.read(2_000_000).decode("latin-1")


def message(text):
    return " ".join(text[max(0, text.find("--> FOAM FATAL")):].split())[:1500]


def judgeTool(name, status, text, nRanks=1):
    """What is wrong with the end of a tool or '', and is it refused?"""
    if status is None:
        return f"{name} still runs after {nRanks*LIMIT:g} s or more", False
    if status < 0 or status > 127:
        return f"{name} ended by a signal, exit {status}", False
    crash = re.search(CRASH, text)
    if crash:
        return f"{name} crashed: {crash.group()}", False
    fatal = text.count("--> FOAM FATAL")
    if status:
        if status != 1 or not 1 <= fatal <= nRanks:
            return f"{name}: exit {status}, {fatal} fatal messages", False
        if not re.search(NAMES, message(text)):
            return f"{name}: message names no file, face, cell, point, patch", False
        return "", True
    if fatal or "End" not in text.split():
        return f"{name}: exit 0, {fatal} fatal messages or no End", False
    return "", False


def columns(case, time, factor=1.0):
    """The cloud, of a case of factor times the size in the size of the others."""
    points = case.points(time, "block")
    size = {"x": factor, "m": factor**3, "V": factor**3}
    return {c: points.byId(c)/size.get(c, 1) for c in ("x", "U", "m", "V", "sigma")}


def scale(case, factor):
    """Body and times."""
    regions = "system/setMaterialPointsDict"
    with open(case.file(regions)) as f:
        boxes = re.findall(r"^\s*(?:min|max)\s+\((.*)\);", f.read(), flags=re.M)
    for old in boxes:
        new = " ".join(repr(factor*float(x)) for x in old.split())
        case.change(regions, re.escape(f"({old})"), f"({new})")
    case.change(regions, r"\(1 \(", f"({factor!r} (")
    for key in ("endTime", "deltaT", "writeInterval"):
        value = case.entry("system/controlDict", key)
        case.change("system/controlDict", rf"^({key}\s+).*;", rf"\g<1>{factor*value!r};")


def difference(a, b):
    """Largest difference of two clouds over each column's largest value; points are
    matched by their places."""
    if len(a["x"]) != len(b["x"]):
        return np.inf
    near = np.linalg.norm(a["x"][:, None] - b["x"], axis=2).argmin(axis=1)
    if len(set(near)) != len(near):
        return np.inf
    return max(np.max(np.abs(a[c] - b[c][near]))/(np.max(np.abs(a[c])) or 1) for c in a)


def sums(case, name, first, last):
    """What is wrong with the sums of a result, or ''."""
    if not all(np.all(np.isfinite(v)) for v in last.values()):
        return "not finite"
    m, before = last["m"], first["m"]
    if abs(np.sum(m)/np.sum(before) - 1) > 1e-12:
        return f"mass {np.sum(before)} -> {np.sum(m)}"
    if abs(np.sum(before)/(RHO*np.sum(first["V"])) - 1) > 1e-12 or not 0.7 < \
            np.sum(first["V"])/(4*H*H*(1 if name in ("prisms", "gas") else 2*H)) < 1.3:
        return f"mass {np.sum(before)}, volume {np.sum(first['V'])}"
    p, q = m @ last["U"], before @ first["U"]
    off = np.linalg.norm(p - q)/np.linalg.norm(q)
    if off > (0.05 if name == "gas" else 1e-10):
        return f"momentum changes by {off:.2e}"
    if np.max(np.abs(last["sigma"])) > 0.2*E or np.max(np.linalg.norm(last["U"], axis=1)) > 80:
        return f"stress {np.max(np.abs(last['sigma'])):.2e}"
    if name == "gas":
        gas = readInternal(case.file(case.times()[-1], "p"))
        if not np.all(np.isfinite(gas)) or gas.min() < 0.5e5 or gas.max() > 2e5:
            return f"gas {gas.min()} to {gas.max()} Pa"
    return ""


def judge(case, name, expected, reference, factor):
    """Wrong or '', and what came of it."""
    saved = case.file("points")
    shutil.copytree(case.file("0"), saved)
    status, text = run(case, "setMaterialPoints")
    wrong, refused = judgeTool("setMaterialPoints", status, text)
    said = message(text)
    if wrong:
        return wrong, said
    if refused:
        shutil.rmtree(case.file("0"))
        shutil.copytree(saved, case.file("0"))
    status, text = run(case, "materialPointFoam")
    wrong, alsoRefused = judgeTool("materialPointFoam", status, text)
    said = said if refused else message(text)
    if wrong:
        return wrong, said + " || " + message(text)
    if refused or alsoRefused:
        if expected in (SAME, VALID):
            return "refused", said
        if not alsoRefused:
            said += " || materialPointFoam runs"
        return "", "refused: " + said
    if expected == REFUSED:
        return "not refused", "runs"
    first, last = (columns(case, case.times()[i], factor) for i in (0, -1))
    wrong = sums(case, name, first, last)
    same = difference(reference["end"], last)
    if expected == SAME and not wrong and not same <= 1e-10:
        wrong = "other points at the start" if difference(reference["0"], first) > 1e-10 else \
            f"differs by {same:.2e}"
    return wrong, f"runs, difference {same:.1e}"


def one(number, name, mesh, kind, expected, change, original, reference):
    case = FoamCase("mutatedMeshes", f"{number:03d}", template=original.path)
    for time in case.times()[1:]:
        shutil.rmtree(case.file(time))
    os.makedirs(case.file("constant", "polyMesh"))
    m = PolyMesh(original.file("constant", "polyMesh"))
    change(m, PLACE*(1, 1, 1), random.Random(number))
    m.write(case.file("constant", "polyMesh"))
    factor = getattr(change, "factor", 1.0)
    if factor != 1:
        scale(case, factor)
    wrong, said = judge(case, mesh, expected, reference, factor)
    if not wrong:
        shutil.rmtree(case.path)
    return wrong, said


def onProcessors(number, kind, change, original):
    """The mesh of one of two processors is changed: a message, or a result."""
    case = FoamCase("mutatedMeshes", f"{number:03d}", template=original.path)
    for folder in original.processors():
        shutil.copytree(folder, case.file(os.path.basename(folder)))
    folder = case.file("processor1", "constant", "polyMesh")
    m = PolyMesh(folder)
    change(m, PLACE, random.Random(number))
    m.write(folder)
    status, text = run(case, *mpirun(2), "materialPointFoam", "-parallel")
    wrong, refused = judgeTool("materialPointFoam", status, text, 2)
    if not wrong and not refused:
        wrong = "not refused"
    if not wrong:
        shutil.rmtree(case.path)
    return wrong, ("refused: " if refused else "") + message(text)


def main():
    words = sys.argv[1:]
    os.environ["FOAM_SIGFPE"] = "true"
    os.environ.pop("FOAM_ABORT", None)
    table = Report("mutatedMeshes")
    tries = [(f"{mesh}: {kind}", mesh, kind, expected, change)
             for kind, expected, meshes, change in MUTATIONS for mesh in meshes]
    tries += [(f"2 processors, {mesh}: {kind}", mesh, kind, None, change)
              for kind, meshes, change in ON_PROCESSORS for mesh in meshes]
    chosen = [(i, t) for i, t in enumerate(tries, 1) if all(w in t[0] for w in words)]
    bases, split, counts = {}, {}, {"refused": 0, "runs": 0}
    for number, (name, mesh, kind, expected, change) in chosen:
        if mesh not in bases:
            case = base(mesh)
            case.run("materialPointFoam")
            end = columns(case, case.times()[-1])
            bases[mesh] = case, {"0": columns(case, "0"), "end": end}
            wrong = sums(case, mesh, columns(case, "0"), end)
            table.check(f"{mesh}, unchanged", not wrong, wrong)
        case, reference = bases[mesh]
        if expected is None:
            if mesh not in split:
                split[mesh] = FoamCase("mutatedMeshes", "split-" + mesh,
                                       template=case.path)
                shutil.copytree(case.file("constant", "polyMesh"),
                                split[mesh].file("constant", "polyMesh"))
                split[mesh].decompose((2, 1, 1))
            wrong, said = onProcessors(number, kind, change, split[mesh])
        else:
            wrong, said = one(number, name, mesh, kind, expected, change, case, reference)
        if wrong:
            table.check(name, False, f"{number:03d}: {wrong} | {said[:400]}")
        else:
            counts["refused" if said.startswith("refused") else "runs"] += 1
            print(f"{number:03d} {name} | {said[:300]}", flush=True)
    if not words:
        table.row("changes of meshes tried", 100, len(chosen), 100, "atLeast")
        table.row("changes with a message", 0, counts["refused"], 140, "atLeast")
        table.row("changes with a right result", 0, counts["runs"], 40, "atLeast")
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
