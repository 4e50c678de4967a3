#!/usr/bin/env python3
"""etc/python/mpm for users: doc/guide/python.md, dictionaries, studies.

guide         the Python blocks of the page run as they stand, one after the other, on the case
              that its commands make; what they write is there
dictionaries  entries of the tutorials as foamDictionary reads them; setting an entry to what it
              is leaves the file as it was, to another value changes only that
study         a bar that vibrates: its period by the exact one, 4 L/c; runs that have ended are
              not run anew but when the case has changed, one that fails is a row that says why;
              of two studies in one folder the second stops
mistakes      a mesh without blockMeshDict is copied; a study that cannot give what it is asked
              for stops before its runs, one in which all fail says so; a Python without numpy
"""

import contextlib
import glob
import io
import os
import re
import shutil
import subprocess
import sys
import time

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from bar import L, T, V0, barRun
from foamCase import PROJECT, RUN, FoamCase, runParts, writeField
from mpm.case import Case, RunFailed
from mpm.dictionaries import DictionaryError, getEntry, parse, setEntry
from mpm.study import Study, energyResidual, largest, last, least, period, steps


def guide(table):
    page = os.path.join(PROJECT, "doc/guide/python.md")
    with open(page) as f:
        blocks = re.findall(r"^```python\n(.*?)^```", f.read(), re.S | re.M)
    table.row("guide: blocks of Python", 3, len(blocks), 0)
    folder = os.path.join(RUN, "python", "guide")
    shutil.rmtree(folder, ignore_errors=True)
    case = FoamCase("python", "guide/myCase", os.path.join(PROJECT, "etc/caseTemplate"))
    for application in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
        case.run(application)
    first = case.points("0", "target")
    before = [first["id"], first["x"], case.nCells()]
    for path in ("0/lagrangian/target/id", "0/lagrangian/target/x", "constant/polyMesh/owner"):
        subprocess.run(["gzip", case.file(path)], check=True)
    after = [first["id"], first["x"], case.nCells()]
    table.check("guide: compressed files are the same", all(map(np.array_equal, before, after))
                and "x" in first.keys() and not os.path.exists(first.paths[0] + "/x"), after[2])
    for name, block in zip(("read", "change", "study"), blocks):
        path = os.path.join(folder, name + ".py")
        with open(path, "w") as f:
            f.write(block)
        run = subprocess.run([sys.executable, path], cwd=folder, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, timeout=300)
        table.check(f"guide: {name} runs", run.returncode == 0,
                    " ".join(run.stdout.decode().replace("|", " ").split())[-150:])
    table.check("guide: table and picture of the study are there", all(os.path.exists(
        os.path.join(folder, n)) for n in ("strain.csv", "strain.md", "strain.png")))


# --- dictionaries ---------------------------------------------------------------

def leaves(entry, above=""):
    """Paths of all entries that are no dictionaries."""
    for child in entry.entries or ():
        if child.entries is not None:
            yield from leaves(child, above + child.name + ".")
        elif child.end > child.start:
            yield above + child.name, child


def foamDictionary(case, path, name):
    return subprocess.run(
        ["foamDictionary", path, "-entry", name, "-value"], cwd=case.path,
        stdout=subprocess.PIPE, env={**os.environ, "PWD": case.path}).stdout.decode()


def dictionaries(table):
    files = sorted(p for folder in ("constant", "system", "0", "0.orig") for p in glob.glob(
        os.path.join(PROJECT, "tutorials/**", folder, "*"), recursive=True)
        if os.path.isfile(p) and not p.endswith((".stl", ".gz")))
    nEntries, moved, unread = 0, [], []
    for path in files:
        with open(path, errors="replace") as f:
            text = f.read()
        if "FoamFile" not in text or re.search(r"format\s+binary", text):     # of a run
            continue
        try:
            for name, entry in leaves(parse(text)):
                if name.startswith("FoamFile") or name.startswith("#"):
                    continue
                nEntries += 1
                try:
                    if setEntry(text, name, text[entry.start:entry.end]) != text:
                        moved.append(f"{path}: {name}")
                except DictionaryError as error:
                    unread.append(f"{path}: {error}")
        except DictionaryError as error:
            unread.append(f"{path}: {error}")
    table.row("dictionaries: entries of the tutorials", 3000, nEntries, 3000, "atLeast")
    table.check("dictionaries: all are read", not unread, " | ".join(unread[:3]))
    table.check("dictionaries: setting what is there changes nothing", not moved,
                " ".join(moved[:3]))

    case = FoamCase("python", "entries", os.path.join(PROJECT, "tutorials/spall"))
    for path, entry, name in (
            ("system/controlDict", "endTime", "endTime"),
            ("constant/phaseProperties", "target.E", "target/constitutiveModel/E"),
            ("system/blockMeshDict", "nx", "nx"),
            ("system/setMaterialPointsDict", "flyer.velocity", "regions/flyer/velocity")):
        read = foamDictionary(case, path, name)
        said = [float(v) for v in re.findall(r"[-+.\deE]+", read)]
        mine = np.ravel(case.get(path, entry))
        table.check(f"dictionaries: {entry} as foamDictionary reads it",
                    list(mine) == said and len(said) > 0, f"{mine} {said}")
    before = case._text("constant/phaseProperties")
    case.set("constant/phaseProperties", "target.E", 1.5e9)
    after = case._text("constant/phaseProperties")
    changed = [(a, b) for a, b in zip(before.split("\n"), after.split("\n")) if a != b]
    table.check("dictionaries: another value changes one line",
                len(changed) == 1 and before.count("\n") == after.count("\n"), changed)
    case.set("system/fvSolution", "materialPoints.maxStrain", 0.1, add=True)
    read = foamDictionary(case, "system/fvSolution", "materialPoints/maxStrain")
    table.check("dictionaries: a new entry is read", float(read) == 0.1, read.strip())

    try:
        case.points("99", "flyr")["x"]
        said = ""
    except FileNotFoundError as error:
        said = str(error)
    table.check("a cloud that is not there is an error", "no clouds at this time" in said,
                said[-60:])
    text = "a { x 1; b { y 2; } }\nc { y 3; }\n"
    for path, words in (("y", "a.b.y, c.y"), ("a.z", "a has x, b"), ("q", "the file has a, c")):
        try:
            getEntry(text, path)
            table.check(f"dictionaries: {path} is refused", False)
        except DictionaryError as error:
            table.check(f"dictionaries: {path} is refused with the choices", words in str(error),
                        error)
    text = 'water { type fluid; #include "$DIR/water" }\nplate { rho 2; #includeIfPresent "x"; }\n'
    text += "bed { rho 3; }\n"
    for path, value in (("water.type", "fluid"), ("plate.rho", "2"), ("bed.rho", "3")):
        try:
            found = getEntry(text, path)
        except DictionaryError as error:
            found = error
        table.check(f"dictionaries: {path} beside #include", str(found) == value, found)


# --- study ----------------------------------------------------------------------

def start(case):
    """The bar of tests/lib/bar.py: its velocity at the start is none of a dictionary."""
    case.prepare()
    x = case.points("0", "bar")["x"][:, 0]
    v = np.zeros((len(x), 3))
    v[:, 0] = V0*np.sin(np.pi*x/(2*L))
    writeField(case.file("0/lagrangian/bar/U"), v)
    case.run("materialPointFoam")


def tableOnly(case):
    """A run that writes a table of two columns."""
    os.makedirs(case.file("postProcessing/balance/0"))
    with open(case.file("postProcessing/balance/0/bar.dat"), "w") as f:
        f.write("# Time\tforce\n0 0\n1 2\n")


def tableThenWait(case, out):
    """A table, then a run that goes on until something is said, 30 s at most."""
    tableOnly(case)
    start = time.monotonic()
    while "Ctrl-C" not in out.getvalue() and time.monotonic() < start + 30:
        time.sleep(0.1)
    return time.monotonic() - start


def series(base, folder, modulus=(100.0, 400.0, -1.0), entry="bar.E"):
    return Study(base, {"E": ("constant/phaseProperties", entry, list(modulus))},
                 {"period": period("balance/bar.dat", "Px"), "steps": steps}, folder=folder,
                 steps=start)


def stopped(case):
    """As the log of a run that a signal has ended, which gives exit code 0."""
    with open(case.file("log.materialPointFoam"), "w") as f:
        f.write("\nSignal 15 (Terminated) was received.\n")


#: The budget of a case with fluids in the log, and a table with a probe's columns
LOG = """Energy: kinetic 1, strain 3, total {total}
Energy budget: transfer -1, boundary 0, remap -1e-10
    gas 1602.58, gained 2.5e-05, rigid 0, dry 0, fix-ups 0
    to points: pressure 2.7e-07, drag -7e-10
    last step -5e-10, laws 2e-20, exchange 7e-09, residual {residual}
Failed points: 0, steps redone: 0
"""


def budget(table):
    """Quantities of a log and a table that are given."""
    case = FoamCase("python", "budget", os.path.join(PROJECT, "etc/caseTemplate"))
    with open(case.file("log.materialPointFoam"), "w") as f:
        f.write(LOG.format(total=8, residual=0.5) + LOG.format(total=4, residual=0.2))
    table.row("study: energyResidual beside fluids", 0.2/8, energyResidual(case), 1e-12)
    os.makedirs(case.file("postProcessing/tip/0"))
    with open(case.file("postProcessing/tip/0/displacement.dat"), "w") as f:
        f.write("# Time\tdisplacement_x(199)\tdisplacement_y(199)\n0\t1\t5\n1\t3\t4\n")
    table.row("study: a column by a pattern", 3, largest(
        "tip/displacement.dat", "displacement_x*")(case), 0)
    try:
        largest("tip/displacement.dat", "displacement*")(case)
        said = ""
    except RunFailed as error:
        said = str(error)
    table.check("study: a pattern of two columns is an error with both",
                "each of displacement_x(199), displacement_y(199)" in said, said[:100])
    with open(case.file("postProcessing/tip/0/two.dat"), "w") as f:
        f.write("# Time\tU_x(7)\tU_y(7)\tU_x(3)\tU_y(3)\n0\t1\t5\t2\t6\n1\t3\t4\t1\t7\n")
    found = [f("tip/two.dat", "U_x*", place=k)(case) for f in (last, largest, least)
             for k in (1, 2)]
    table.check("study: a column by a pattern and its place", found == [3, 1, 3, 2, 1, 1], found)
    try:
        last("tip/two.dat", "U_y*", place=3)(case)
        said = ""
    except RunFailed as error:
        said = str(error)
    table.check("study: a place that is not there is an error with those that are",
                "1 is U_y(7), 2 is U_y(3)" in said, said[:120])


def study(table):
    base = barRun("python", "bar", {"shapeFunction": "GIMP", "transfer": "FLIP"}, 32)[0]
    base.set("system/controlDict", "endTime", 2.5*T)
    folder = os.path.join(RUN, "python", "study")
    shutil.rmtree(folder, ignore_errors=True)
    made = series(base.path, folder)
    rows = made.run(2)
    # The mesh alone makes (k h)^2/24 = 1e-4 with k = pi/(2 L); 2e-3 is a tolerance
    for E, measured in zip(rows["E"][:2], rows["period"]):
        table.row(f"study: period of the bar, E {E:g}", 4*L/np.sqrt(E), measured, 2e-3, "relative")
    table.check("study: a run that fails is a row with the solver's error",
                "must be greater than 0" in rows["state"][2] and np.isnan(rows["period"][2]),
                rows["state"][2])

    logs = [made.case(E=E).file("log.materialPointFoam") for E in (100.0, 400.0)]
    written = [os.path.getmtime(p) for p in logs]
    again = series(base.path, folder).run(2)
    table.check("study: what has ended is not run anew",
                list(again["state"][:2]) == ["kept", "kept"]
                and [os.path.getmtime(p) for p in logs] == written, list(again["state"][:2]))
    table.check("study: with the same figures", np.array_equal(
        again["period"][:2], rows["period"][:2]))
    base.set("system/controlDict", "endTime", 2.0*T)
    changed = series(base.path, folder, (100.0,)).run(2)
    table.check("study: it is where the case has changed", changed["state"][0] == "ran"
                and changed["steps"][0] < rows["steps"][0], changed["state"][0])

    ended = [Study(base.path, {}, {}, folder=os.path.join(folder, "stopped"),
                   steps=stopped).run()["state"][0] for _ in range(2)]
    def wrong(case):
        raise KeyError("no such thing")
    mixed = Study(base.path, {}, {"bad": wrong, "steps": steps}, folder=folder,
                  steps=lambda case: case.write("log.materialPointFoam", {})).run()
    table.check("study: a quantity that fails is nan, with its reason, and no other is",
                np.isnan(mixed["bad"][0]) and not np.isnan(mixed["steps"][0]) and mixed["state"][0]
                == "ran; quantity bad: KeyError: 'no such thing'", mixed["state"][0])

    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        Study(base.path, {"E": ("constant/phaseProperties", "bar.E", [1.0, 2.0])},
              {"least": least("balance/bar.dat", "missing")}, folder=os.path.join(folder, "hint"),
              steps=tableOnly).run(1)
    first, hint, second = out.getvalue().splitlines()[1:4]
    table.check("study: a column that is missing is said after the first run, once, with what to "
                "do", first.startswith("1/2") and "no column missing" in first
                and "there are: Time, force" in first and "Ctrl-C" in hint
                and second.startswith("2/2") and out.getvalue().count("Ctrl-C") == 1, first)

    out, waited = io.StringIO(), []
    with contextlib.redirect_stdout(out):
        Study(base.path, {"E": ("constant/phaseProperties", "bar.E", [1.0, 2.0])},
              {"least": least("balance/bar.dat", "missing")},
              folder=os.path.join(folder, "early"),
              steps=lambda case: waited.append(tableThenWait(case, out))).run(1)
    lines = out.getvalue().splitlines()
    table.check("study: a column that is missing is said while the first run goes on, once",
                "no column missing" in lines[1] and "Ctrl-C" in lines[2] and lines[3].startswith(
                    "1/2") and out.getvalue().count("Ctrl-C") == 1 and waited[0] < 30, lines[1:4])

    table.check("study: a run that a signal has ended has not run", all(
        state.startswith("failed: Signal 15") for state in ended), ended)

    both = Study(base.path, {"E": ("constant/phaseProperties", "bar.E", [1.0, 2.0]),
                             "Co": ("system/controlDict", "maxCo", [0.1, 0.2])}, {},
                 combine="list")
    table.row("study: runs of combine list", 2, len(both.points), 0)
    try:
        Study(base.path, {"E": ("constant/phaseProperties", "bar.e", [1.0])}, {})
        said = ""
    except DictionaryError as error:
        said = str(error)
    table.check("study: an entry that is not there is an error before anything runs",
                "no entry bar.e; bar has constitutiveModel" in said, said[-60:])
    try:
        base.get("constant/phaseProperties", "bar.Rho")
        said = ""
    except DictionaryError as error:
        said = str(error)
    table.check("an entry that is nearly there", "is bar.constitutiveModel.rho meant?" in said,
                said[-60:])
    apart = Case(os.path.join(RUN, "python", "apart"))
    apart.copy(source=base.path)
    with open(apart.file("constant/law"), "w") as f:
        f.write("type linearElastic; rho 1; E 100; nu 0;\n")
    apart.change("constant/phaseProperties", r"constitutiveModel\s*\{[^}]*\}",
                 'constitutiveModel { #include "law" }')
    included = series(apart.path, folder + "Apart", (400.0,), "bar.constitutiveModel.E").run()
    table.row("study: period with E of a file that is included", 4*L/np.sqrt(400),
              included["period"][0], 2e-3, "relative")
    words = Study(base.path, {"E": ("constant/phaseProperties", "bar.E", ["100 Pa"])}, {},
                  folder=folder)
    table.check("study: no blank in the folder of a value", words.case(E="100 Pa").path.endswith(
        "/100_Pa"), words.case(E="100 Pa").path)
    try:
        last("balance/bar.dat", "Pq")(made.case(E=400.0))
        said = ""
    except RunFailed as error:
        said = str(error)
    table.check("study: a column that is not there is an error with those that are",
                "Px" in said and "kinetic" in said, said[:100])
    budget(table)
    rows.write(os.path.join(folder, "table"))
    _, ax = rows.plot("E", "period", file=os.path.join(folder, "period.svg"), log="xy")
    table.check("study: axes with units, of doc/entries.md and of tables",
                ax.get_xlabel() == "E [Pa]" and ax.get_ylabel() == "period [s]" and last(
                    "balance/bar.dat", "kin*").unit(made.case(E=400.0)) == "J",
                (ax.get_xlabel(), ax.get_ylabel()))
    _, ax = rows.plot("period", "period", by="E", file=os.path.join(folder, "by.svg"))
    words = [text.get_text() for text in ax.get_legend().get_texts()]
    table.check("study: a legend with units", words[0] == "E 100 Pa", words)
    shown = Study(base.path, {"weight": ("constant/phaseProperties", "bar.E", {1: 100.0})},
                  {"steps": steps}, folder=os.path.join(folder, "shown")).run()
    table.check("study: what a dictionary shows has not the unit of the entry",
                "weight" not in shown.units, shown.units)
    other = os.path.join(folder, "log.other")
    with open(other, "w") as f:
        f.write("--> FOAM Warning : \n    odd\n--> FOAM FATAL IO ERROR: \n"
                "size 5711 is not equal to the given value of 5889\n\nfile: x\n")
    table.check("a field of another mesh: what to do", "keep the files that you wrote in 0.orig"
                in Case.reason(other), Case.reason(other))

    def odd(case):
        shutil.copy(other, case.file("log.odd"))
        raise RunFailed("no")
    state = Study(base.path, {}, {"steps": steps}, folder=os.path.join(folder, "warned"),
                  steps=odd).run()["state"][0]
    table.check("study: a run that fails with warnings says where they are",
                state == "failed: no; warnings in log.odd may tell the cause", state)
    gauges = made.case(E=400.0)
    os.makedirs(gauges.file("postProcessing/gauges/0"))
    with open(gauges.file("postProcessing/gauges/0/p.dat"), "w") as f:
        f.write("# Probes: 0 at (-1 0 2.5), field p\n# Time[s]\t0\n0 1\n1 2\n")
    table.check("study: probes of a field have its unit",
                last("gauges/p.dat", "0").unit(gauges) == "Pa")
    with open(os.path.join(folder, "table.csv")) as f:
        table.row("study: lines of the CSV", 4, len(f.readlines()), 0)
    table.check("study: picture as SVG", os.path.getsize(os.path.join(folder, "period.svg")) > 1000)


#: A study whose run waits, in a folder, of a case
WAITS = """import sys, time
from mpm.study import Study
def wait(case):
    print("waits", flush=True)
    time.sleep(60)
Study(sys.argv[1], {}, {}, folder=sys.argv[2], steps=wait).run(1)
"""


def together(table):
    """Two studies in one folder: the second is an error, until the first ends or is killed."""
    case = FoamCase("python", "together", os.path.join(PROJECT, "etc/caseTemplate"))
    folder = case.file("study")
    first = subprocess.Popen([sys.executable, "-c", WAITS, case.path, folder],
                             stdout=subprocess.PIPE, env={
                                 **os.environ, "PYTHONPATH": os.path.join(PROJECT, "etc/python")})
    try:
        while first.stdout.readline() not in (b"waits\n", b""):
            pass
        second = Study(case.path, {}, {}, folder=folder,
                       steps=lambda case: case.write("log.materialPointFoam", {}))
        start = time.monotonic()
        words = said(second.run)
        table.row("study: seconds until the second of one folder stops", 0,
                  time.monotonic() - start, 2)
        table.check("study: it says where, and what to do", words.startswith(
            f"another study is running in {folder}: wait until it has ended, or take another"
            " folder"), words)
        table.check("study: the first's run is as it was", first.poll() is None
                    and os.listdir(folder + "/base") and not os.path.exists(folder + "/base.new"))
    finally:
        first.kill()
        first.wait()
        first.stdout.close()
    table.check("study: when the first has been killed it runs", second.run(1)["state"][0] == "ran")


# --- mistakes -------------------------------------------------------------------

def said(call):
    """What an error of a call says, "" if there is none."""
    try:
        call()
    except (RunFailed, ValueError) as error:
        return str(error)
    return ""


def fails(case):
    raise RunFailed("no disk")


def ofGmsh(table):
    """As a mesh of gmsh: in constant, without blockMeshDict."""
    case = FoamCase("python", "noDict", os.path.join(PROJECT, "etc/caseTemplate"))
    nothing = FoamCase("python", "noMesh", os.path.join(PROJECT, "etc/caseTemplate"))
    for one in (case, nothing):
        one.set("system/controlDict", "endTime", 2e-7)
    case.run("blockMesh")
    for one in (case, nothing):
        os.remove(one.file("system/blockMeshDict"))
    case.run("setMaterialPoints")
    copied = Case(case.path + "Copy")
    copied.copy(source=case.path)
    table.check("copy: a mesh without blockMeshDict is taken, points are not",
                os.path.exists(copied.file("constant/polyMesh/faces"))
                and not os.path.exists(copied.file("0/lagrangian")))
    folder = os.path.join(RUN, "python", "gmshStudy")
    for old in (folder, folder + "None"):
        shutil.rmtree(old, ignore_errors=True)
    E = {"E": ("constant/phaseProperties", "target.E", [70e9])}
    rows = Study(copied.path, E, {"steps": steps}, folder=folder).run(1)
    table.check("study: of the copy runs", rows["state"][0] == "ran" and rows["steps"][0] > 0,
                rows["state"][0])
    words = said(Study(nothing.path, E, {}, folder=folder + "None").run)
    table.check("study: without a mesh it stops before its runs", words.startswith(
        f"{nothing.path} has neither constant/polyMesh nor system/blockMeshDict")
        and not os.path.exists(folder + "None"), words)


def mistakes(table):
    ofGmsh(table)
    case = FoamCase("python", "asked", os.path.join(PROJECT, "etc/caseTemplate"))
    folder = os.path.join(RUN, "python", "asked", "study")
    words = said(Study(case.path, {}, {"strain": largest("energy/target.dat", "strain")},
                       folder=folder).run)
    table.check("study: a table that no function object writes", "no function object energy in"
                in words and "there are: balance" in words, words)
    case.set("system/fvSolution", "materialPoints.energyBudget", False)
    words = said(Study(case.path, {}, {"residual": energyResidual}, folder=folder).run)
    table.check("study: energyResidual without energyBudget", "needs the energy budget" in words
                and "energyBudget yes; in materialPoints of system/fvSolution" in words, words)
    table.check("study: neither has run anything", not os.path.exists(folder))

    rows = Study(case.path, {"E": ("constant/phaseProperties", "target.E", [1.0, 2.0])},
                 {"steps": steps}, folder=folder, steps=fails).run(1)
    name = os.path.join(folder, "table")
    for what, call in (("write", lambda: rows.write(name)),
                       ("plot", lambda: rows.plot("E", "steps", file=name + ".png"))):
        words = said(call)
        table.check(f"study: all fail, {what} is an error with the first", "2 of 2 failed, the"
                    " first: E 1: failed: no disk" in words, words)
    table.check("study: all fail, a table and no picture",
                os.path.exists(name + ".csv") and not os.path.exists(name + ".png"))

    # In place of numpy, as in a Python without it
    os.makedirs(case.file("without/numpy"))
    with open(case.file("without/numpy/__init__.py"), "w") as f:
        f.write("raise ModuleNotFoundError('No module named numpy', name='numpy')\n")
    run = subprocess.run(
        [sys.executable, "-c", "from mpm.study import Study"], stderr=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(
            [case.file("without"), os.path.join(PROJECT, "etc/python")])})
    words = run.stderr.decode()
    table.check("without numpy: one line with the remedy", run.returncode == 1 and words.count(
        "\n") == 1 and "no module numpy" in words and "MPM_PYTHON" in words, words)


if __name__ == "__main__":
    sys.exit(runParts("python", guide, dictionaries, study, together, mistakes))
