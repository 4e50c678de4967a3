#!/usr/bin/env python3
"""Mutated input: one change of one file of a tutorial's case at a time.

The changes are made from the files' own entries (changes.py): an entry deleted,
misspelt, without value, negative, huge, tiny, zero, no number, of another type;
a file deleted, cut off, filled with rubbish; the columns of points in the time
of setMaterialPoints and in a later one. The meshes are coarse and the runs a
few steps long. The tools that read the file run in the order of the user.

What must hold for each: exit status 1 with exactly one fatal message that names
the file, the entry or the point, within the time limit; or the change has no
bad effect for a reason that HARMLESS states. No signal, no abort, no hang.

Beside tutorials: cases of several fluids (fluidSeeds.py), a spread of their own.

    test.py             a spread of the changes, the same each time
    test.py --all       all of them (half an hour and more)
    test.py --number N  a spread of N
    test.py --fluids    only the cases of fluids
    test.py word ...    all whose name has all of the words
"""

import os
import re
import shutil
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
RUN = os.path.join(PROJECT, "tests", "run", "mutatedInput", "cases")
LIMIT = 200.0 if os.environ.get("MPM_BUILD") == "sanitize" else 10.0
N_SPREAD, N_FLUIDS = 250, 120

sys.path.insert(0, os.path.join(PROJECT, "tests", "lib"))
import fluidSeeds  # noqa: E402
from changes import Folder, allChanges, spread  # noqa: E402
from launcher import launch  # noqa: E402
from report import Report  # noqa: E402

# --- the tutorials with coarse meshes and few steps --------------------------

BLOCKS, CONTROL = "system/blockMeshDict", "system/controlDict"

#: Tutorial: changes of its files (pattern and text), end of the first run, of
#: the run after the restart, names of the later time's files that change
SHRINK = {
    "spall": ([(BLOCKS, r"^n  +100", "n 20"), (BLOCKS, r"^nx +240", "nx 48"),
               (BLOCKS, r"^ny +200", "ny 40"), (CONTROL, "1.881e-3", "1.7e-3"),
               (CONTROL, "1.919e-3", "2.1e-3"), (CONTROL, "1.9e-5", "1.9e-4"),
               (CONTROL, "nBins +300", "nBins 30")], "4e-8", "8e-8"),
    "cantilever": ([(BLOCKS, r"^nx +48", "nx 24"), (BLOCKS, r"^ny +42", "ny 21")],
                   "2e-4", "4e-4"),
    "twoDisks": ([(BLOCKS, r"^n +28", "n 14")], "4e-3", "8e-3"),
    "vibratingBar": ([(BLOCKS, r"^n +36", "n 18")], "0.06", "0.12"),
    "obliqueTranslation/disk": ([(BLOCKS, r"\(\$n \$n 1\) s", "(16 16 1) s")],
                                "2e-4", "4e-4"),
    "obliqueTranslation/ball": ([(BLOCKS, r"\(\$n \$n \$n\) s", "(12 12 12) s")],
                                "2e-4", "4e-4"),
}

#: Clouds that are changed in the time of setMaterialPoints, and in a later one
START_CLOUDS = ("cantilever", "spall")
LATER_CLOUDS = ("spall", "twoDisks", "vibratingBar", "obliqueTranslation/ball")

# --- changes without a bad effect, and why -----------------------------------
# Patterns of file, entry and kind (all of the text), reason. The first that
# matches a change whose tools all end well counts. Each is a fact of the
# README, of a header or of OpenFOAM; what is not here must be an error.

#: A reason holds only if the result is that of the unchanged case
SAME = object()

#: The same to 1e-10
CLOSE = object()

#: Files that our tools do not read, changed as a whole only
UNREAD = r".*/lagrangian/\w+/(coordinates|positions|p|pPoint|sigmaEq|origId|origProcId)" \
    r"|\d.*/(alpha|Umean|sigma)\.\w+|system/fvSchemes" \
    r"|.*/uniform/(lagrangian|functionObjects)/.*"

RECORD = r".*/uniform/phaseProperties"
DICTS = r"(system|constant|0)/[\w.]+"
REGIONS = "system/setMaterialPointsDict"
PHASES = "constant/phaseProperties"
OTHER = r"(?!.*FoamFile).*"

HARMLESS = [
    # Not read, or not by us
    (UNREAD, ".*", ".*", "our tools do not read the file", SAME),
    (RECORD, ".*", ".*", "only a warning of what has changed since", SAME),
    (r".*/uniform/time", ".*", ".*",
     "OpenFOAM's own; materialPointState has the exact time", SAME),
    (".*", r"FoamFile(\.\w+)?|header format", ".*",
     "OpenFOAM checks only the class of a header", SAME),
    (".*", ".*", "binary rubbish at .*",
     "it fell on words of the header that nobody reads", SAME),
    (r".*/uniform/materialPointMesh", "points.*", "unknown keyword|misspelt|deleted|empty dictionary",
     "the number of points of another phase, or none to compare with", SAME),
    (r".*/uniform/materialPointMesh", "", "folder for file",
     "OpenFOAM v2512 takes it as if it were not there: nothing to compare with", SAME),
    (".*", ".*", "no semicolon",
     "OpenFOAM takes the closing brace for the end of the entry", SAME),
    (r"[\d.e-]+/U\..*", r"boundaryField\.\w+\.value", "negative in list",
     "a legal velocity of the wall"),
    (r"[\d.e-]+/U\..*", r"internalField|boundaryField.*|cell \d+", ".*",
     "the velocity of the nodes comes from the points; a condition that is the"
     " same in another spelling", SAME),

    # controlDict: OpenFOAM's own words and their defaults
    (CONTROL, "application|startTime|purgeWrite|writePrecision|writeCompression"
     "|timeFormat|timePrecision|runTimeModifiable|writeFormat|startFrom|stopAt",
     ".*", "OpenFOAM's own word: its default, or a word for another start"),
    ("system/decomposeParDict", ".*", ".*",
     "OpenFOAM's own, read by decomposePar: the same run on one processor", SAME),
    (CONTROL, "adjustTimeStep", "number for word",
     "OpenFOAM takes a number for a switch", SAME),
    (CONTROL, "deltaT", ".*", "adjustTimeStep sets the time step", SAME),
    (CONTROL, r"functions(\..*)?", ".*",
     "OpenFOAM leaves the function object out, and warns", SAME,
     "FOAM Warning|Unknown function type|while loading function"),
    (CONTROL, r"functions(\.\w+(\.write(Control|Interval))?)?", ".*",
     "OpenFOAM's own words: other output, the same run", SAME),
    (CONTROL, r"functions\.\w+\.(points\.\w+|range|nBins)", ".*list|tiny|huge",
     "another choice of points to look at, the same run", SAME),
    (CONTROL, r"functions\.\w+\.(fields|phases)", "short list",
     "fewer fields or phases to look at, the same run", SAME),
    (CONTROL, r"functions\.\w+\.libs", ".*",
     "another function object loads the library", SAME),
    (CONTROL, "", "truncated to .*",
     "cut between two entries: a complete file without function objects", SAME),
    (CONTROL, "writeControl|writeInterval", ".*", "OpenFOAM's own: other output"),
    (CONTROL, "endTime", "zero|negative|tiny",
     "the start is the end: no step is to be made"),
    (CONTROL, "maxCo", "tiny", "a small step is legal"),

    # Defaults that the headers state
    (PHASES, r"\w+\.velocityField", "deleted", "default: name of the phase"),
    (PHASES, r"\w+\.constitutiveModel\.stress", "deleted", "default: Cauchy"),
    (PHASES, r"\w+\.failureModel", "deleted", "no failure"),
    ("system/fvSolution", r"materialPoints\.(order|PICfraction)", "deleted",
     "default of the README"),
    (REGIONS, r"regions\.\w+\.velocity", "deleted", "default: at rest"),
    (DICTS, r".*\.\w+Coeffs", "unknown keyword",
     "a Function1 of OpenFOAM reads the words that it knows and leaves others", SAME),
    (REGIONS, r"regions\.\w+", "misspelt", "a region's name is free", SAME),
    (REGIONS, r"regions\.\w+", "deleted", "fewer regions, with a warning"),
    ("constant/g", "", "file deleted", "no gravity"),

    # Legal values
    (PHASES, r"\w+\.constitutiveModel\.\w+|.*strength",
     "negative|tiny|huge|zero", "a legal value of the law"),
    ("system/fvSolution", r"materialPoints\.PICfraction", "tiny|zero",
     "a legal fraction"),
    (REGIONS, r"regions\.\w+\.(velocity(\..*)?|centre|min|max|radius)",
     "negative in list|huge in list|huge|tiny",
     "a legal place, size or velocity; what reaches beyond the mesh is not filled"),
    ("constant/g", "value", "negative in list|huge in list", "legal gravity"),
    (BLOCKS, ".*", ".*", "another mesh that OpenFOAM accepts, or the same"),

    # Points
    (".*/lagrangian/.*", r"point \d+", "zero|tiny|negative|huge",
     "a legal value of the column"),
    (".*/lagrangian/.*", "", "binary rubbish at .*",
     "in a binary column: finite numbers, which no check can tell from others"),
    (".*/lagrangian/.*/(id|x)", "", "file deleted|folder for file",
     "another tool's cloud: its own ids, its positions"),
    (".*/lagrangian/.*/(damage|leftStretch)", "", "file deleted|folder for file",
     "no column in the time of setMaterialPoints: undamaged, unstrained", SAME),
    (".*/uniform/materialPointState", "", "file deleted|folder for file",
     "the time counts as incomplete, is set aside and the one before is used"),
    (".*/uniform/materialPointState", r"points\.materials\.\w+\.failureModel", "misspelt value",
     "a failureModel that the phase had before, and has no longer: warned of", SAME,
     "have the damage of the failureModel"),
    (".*/uniform/materialPointState", "points.rigid", ".*",
     "the case has no rigid phase", SAME),
    (".*/uniform/materialPointState", "origin|growFrom|points.*",
     "negative|zero|tiny|huge", "a legal value of the state"),
]

# --- runs --------------------------------------------------------------------

CRASH = r"printStack|[Ss]egmentation fault|AddressSanitizer|runtime error:" \
    r"|Assertion|terminate called|\[stack trace\]"


def run(command, path):
    """Exit status (None: stopped at the limit) and output."""
    log = os.path.join(path, "log." + command)
    open(log, "w").close()
    status, _ = launch([command], path, log, LIMIT, session=True)
    with open(log, "rb") as f:
        text = f.read(2_000_000).decode("latin-1")

    # Where OpenFOAM itself aborts it adds the places in its libraries
    return status, re.sub(r"(?<=\nFOAM aborting\n).*", "", text, flags=re.S)


def edit(path, file, pattern, new):
    name = os.path.join(path, file)
    with open(name) as f:
        text, n = re.subn(pattern, new, f.read(), flags=re.M)
    if not n:
        raise SystemExit(f"{name} has no {pattern}")
    with open(name, "w") as f:
        f.write(text)


def seed(tutorial):
    """The start and the later state of a tutorial's case; later: None."""
    edits, end, _ = SHRINK[tutorial]
    source = os.path.join(PROJECT, "tutorials", tutorial)
    name = os.path.basename(tutorial)
    path = os.path.join(RUN, "seeds", name)
    for folder in ("system", "constant", "0"):
        shutil.copytree(os.path.join(source, folder), os.path.join(path, folder),
                        ignore=shutil.ignore_patterns("lagrangian", "polyMesh",
                                                      "uniform"))
    for file, pattern, new in edits:
        edit(path, file, pattern, new)
    edit(path, CONTROL, r"^endTime .*?;", f"endTime         {end};")
    edit(path, CONTROL, r"^writeInterval .*?;", f"writeInterval   {end};")
    for command in ("blockMesh", "setMaterialPoints"):
        mustRun(command, path)

    later = path + "-later"
    shutil.copytree(path, later)
    mustRun("materialPointFoam", later)
    edit(later, CONTROL, r"^endTime .*?;", f"endTime         {SHRINK[tutorial][2]};")
    return path, later


def fluidSeed(name):
    """The same of a case of fluids."""
    make, before = fluidSeeds.SEEDS[name]
    path = make(os.path.join("cases", "seeds")).path
    for command in before:
        mustRun(command, path)
    later = path + "-later"
    shutil.copytree(path, later)
    mustRun("materialPointFoam", later)
    edit(later, CONTROL, r"^endTime .*?;", f"endTime         {fluidSeeds.ENDS[name][1]};")
    return path, later


def unchanged(path):
    """The result of the case as it is."""
    case = path + "-run"
    shutil.copytree(path, case)
    mustRun("materialPointFoam", case)
    return points(case)


def mustRun(command, path):
    status, text = run(command, path)
    if status:
        sys.exit(f"{command} of {path} failed:\n{text[-2000:]}")


def files(path, tutorial, later):
    """The files to change."""
    def inFolder(folder):
        top = os.path.join(path, folder)
        return sorted(os.path.relpath(os.path.join(root, f), path)
                      for root, _, names in os.walk(top) for f in names)

    if later:
        folder, = [f for f in os.listdir(path)
                   if re.fullmatch(r"\d.*", f) and f != "0"]
        return [f for f in inFolder(folder)
                if tutorial in LATER_CLOUDS or tutorial in fluidSeeds.SEEDS]
    found = inFolder("system") + [f for f in inFolder("constant")
                                  if "polyMesh" not in f]
    return found + [f for f in inFolder("0")
                    if "lagrangian" not in f or tutorial in START_CLOUDS]


def tools(tutorial, change):
    """The tools that the user runs after an edit of the file."""
    name = os.path.basename(change.file)
    if "uniform" in change.file:
        return ("materialPointFoam",)
    if tutorial in fluidSeeds.SEEDS:
        before = fluidSeeds.SEEDS[tutorial][1]
        first = {"blockMeshDict": 0, "phaseProperties": 1, "g": 1, "setFluidsDict": 1,
                 "setMaterialPointsDict": 2}.get(name, 3)
        return (*before[first:], "materialPointFoam")
    return {"blockMeshDict": ("blockMesh", "setMaterialPoints", "materialPointFoam"),
            "setMaterialPointsDict": ("setMaterialPoints", "materialPointFoam"),
            "phaseProperties": ("setMaterialPoints", "materialPointFoam"),
            }.get(name, ("materialPointFoam",))


def apply(path, change):
    name = os.path.join(path, change.file)
    os.remove(name)
    if change.new is Folder:
        os.mkdir(name)
    elif change.new is not None:
        with open(name, "wb") as f:
            f.write(change.new)


def message(text):
    """The fatal message as one line."""
    return " ".join(text[text.find("--> FOAM FATAL"):].split())


def names(change, text):
    """Does the message name the file, the entry or the point?"""
    return (os.path.basename(change.file) in text
            or any(re.search(rf"\b{re.escape(k)}\b", text)
                   for k in change.entry.split(".") if k)
            or re.search(r"[Mm]aterial point \d+ of \w+", text)
            or (change.entry.endswith("velocityField") and "/0/U." in text)
            # What is wrong shows in the next step: a phase that lost its region, a
            # step that follows from the points
            or (change.file == REGIONS and "has no material points" in text)
            # Of a mesh of another size: the boxes that are looked in and of the points
            or (change.file.endswith("blockMeshDict") and change.entry == "scale"
                and "Its points are in the box" in text)
            or (change.file.endswith("setFluidsDict") and "no cell has any of it" in text)
            # The state of a gas or of fluids, at the first look at it
            or ("/theta" in change.file or "/alpha." in change.file or "/F." in change.file)
            and re.search(r"look into .*thetaRho|The fields p, theta|Gas \w+ has density", text)
            # OpenFOAM's own: a unit that it does not know
            or (change.entry == "dimensions" and "not found in table" in text)
            or ("/lagrangian/" in change.file
                and "velocities of the points" in text)
            or ("/U." in change.file and "0/U.<velocityField>" in text)
            or ("blockMeshDict" in change.file
                and re.search(r"[mM]esh|Cell \d+|[Pp]atch|0/U\.", text)))


def points(path):
    """Positions, velocities and stresses of the last time and what cells conserve, as
    they are on disk."""
    times = [f for f in os.listdir(path) if re.fullmatch(r"\d[\d.e-]*", f)]
    last = os.path.join(path, max(times, key=float))
    found = {}
    for root, _, names in os.walk(last):
        for name in names:
            if name in ("x", "U", "sigma") or name.startswith("thetaRho"):
                with open(os.path.join(root, name), "rb") as f:
                    found[os.path.relpath(os.path.join(root, name), last)] = f.read()
    return found


def numbers(data):
    """Those of a binary column or field, whatever their type."""
    at = re.search(rb"}.*?(\d+)\s*\(", data, re.S)
    n = int(at[1])*(6 if b"symmTensor" in at.string[:at.end()] else
                    3 if b"ector" in at.string[:at.end()] else 1)
    return np.frombuffer(data[at.end():at.end() + 8*n])


def near(path, reference):
    """Is the result that of the unchanged case to 1e-10 of each column's largest value?"""
    found = points(path)
    return found.keys() == reference.keys() and all(
        np.abs(numbers(found[f]) - numbers(reference[f])).max()
        <= 1e-10*np.abs(numbers(reference[f])).max() for f in found)


def harmless(reasons, change, same, close, text):
    """The stated reason, or None. A reason that needs the same result, or words
    in the output, only counts with them."""
    for file, entry, kind, reason, *needs in reasons:
        if (re.fullmatch(file, change.file) and re.fullmatch(entry, change.entry)
                and re.fullmatch(kind, change.kind)
                and all(same if need is SAME else close() if need is CLOSE else re.search(need, text)
                        for need in needs)):
            return reason
    return None


def judge(tutorial, change, path, reference):
    """Wrong or '', and what the tools said: the message, or the reason why the
    change is harmless."""
    for command in tools(tutorial, change):
        status, text = run(command, path)
        last = message(text) if "--> FOAM FATAL" in text else \
            " ".join(text[-200:].split())
        if status is None:
            return f"{command} still runs after {LIMIT:g} s", last
        if command == "blockMesh":
            if status:
                return "", "blockMesh, OpenFOAM's own, refuses it"
            continue
        if status < 0 or status > 127:
            return f"{command} ended by a signal, exit {status}", last
        crash = re.search(CRASH, text)
        if crash:
            return f"{command} crashed: {crash.group()}", last
        fatal = text.count("--> FOAM FATAL")
        if status:
            if status != 1 or fatal != 1:
                return f"{command}: exit {status}, {fatal} fatal messages", last
            if not names(change, last):
                return f"{command}: message without file, entry or point", last
            return "", last
        if fatal or "End" not in text.split():
            return f"{command}: exit 0, {fatal} fatal messages or no End", last
    same = points(path) == reference
    known = tutorial in fluidSeeds.SEEDS
    reason = harmless(fluidSeeds.harmless(SAME, CLOSE) + HARMLESS if known else HARMLESS,
                      change, same, lambda: near(path, reference), text)
    if reason is None:
        return "no error and no stated reason", "the same result" if same \
            else "another result"
    return "", "harmless: " + reason


def one(number, tutorial, path, reference, change):
    """Number, change, wrong, what was said."""
    case = os.path.join(RUN, f"{number:04d}")
    shutil.copytree(path, case)
    apply(case, change)
    wrong, said = judge(tutorial, change, case, reference)
    if not wrong:
        shutil.rmtree(case)
    return number, tutorial, change, wrong, said


def label(tutorial, change):
    return f"{tutorial} {change.file} {change.entry}: {change.kind}".replace(" :", ":")


def main():
    words = [a for a in sys.argv[1:] if not a.startswith("-")]
    number = int(words.pop(0)) if "--number" in sys.argv else N_SPREAD
    jobs = int(os.environ.get("MPM_MUTATION_JOBS", "1"))
    os.environ["FOAM_SIGFPE"] = "true"
    os.environ.pop("FOAM_ABORT", None)
    shutil.rmtree(RUN, ignore_errors=True)
    table = Report("mutatedInput")

    groups = [fluidSeeds.SEEDS] if "--fluids" in sys.argv else [SHRINK, fluidSeeds.SEEDS]
    chosen, total = [], 0
    for group in groups:
        changes = []
        for tutorial in group:
            fluids = group is fluidSeeds.SEEDS
            start, later = (fluidSeed if fluids else seed)(tutorial)
            for path, isLater in ((start, False), (later, True)):
                reference = unchanged(path)
                for change in allChanges(path, files(path, tutorial, isLater),
                                         fluidSeeds.UNREAD if fluids else UNREAD):
                    changes.append(((tutorial, path, reference), change))
        total += len(changes)
        if words:
            changes = [c for c in changes
                       if all(w in label(c[0][0], c[1]) for w in words)]
        elif "--all" not in sys.argv:
            changes = spread(changes, N_FLUIDS if fluids and "--number" not in sys.argv
                             else number)
        chosen += changes
    changes = chosen

    begin, counts, reasons = time.monotonic(), {"error": 0, "harmless": 0}, {}
    with ThreadPoolExecutor(jobs) as pool:
        results = pool.map(lambda a: one(a[0], *a[1][0], a[1][1]),
                           enumerate(changes, 1))
        for number, tutorial, change, wrong, said in results:
            what = label(tutorial, change)
            if wrong:
                table.check(what, False, f"{number:04d}: {wrong} | {said[:160]}")
            elif said.startswith("harmless: "):
                counts["harmless"] += 1
                reasons.setdefault(said[10:], []).append(what)
                print(f"{number:04d} {what} | {said}", flush=True)
            else:
                counts["error"] += 1
                print(f"{number:04d} {what} | {said[:160]}", flush=True)

    print("\nWithout a bad effect:")
    for reason, them in sorted(reasons.items()):
        print(f"    {len(them):4d}  {reason}")
    if not words:
        least = 100 if "--fluids" in sys.argv else 200
        table.row("single changes tried", least, len(changes), least, "atLeast")
        table.row("changes that end in one clear error", 0, counts["error"],
                  len(changes)//2, "atLeast")
    table.check("every change is an error or has a stated reason",
                not any(not r[-1] for r in table.rows),
                f"{counts['error']} errors, {counts['harmless']} harmless of "
                f"{len(changes)} ({total} possible), "
                f"{time.monotonic() - begin:.0f} s")
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
