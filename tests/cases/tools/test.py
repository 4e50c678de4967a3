#!/usr/bin/env python3
"""OpenFOAM's tools on a case of material points, and the options of ours.

The plates of tutorials/spall, 20 cells over the target, run to 0.25 us with all
four function objects. Then -help, -dry-run, -postProcess, foamDictionary on
every dictionary of the case and of the tutorials, foamListTimes, foamLog,
checkMesh, foamToVTK and postProcess -func do what they do on any case. Values
that a tool gives are compared with the columns and tables of the run itself.
"""

import glob
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
import plateImpactExact as exact
from foamCase import PROJECT, RunFailed, fileHeader, foamText
from launcher import launch
from plates import plateCase
from report import Report

END, INTERVAL = 2.5e-7, 1.25e-7

FUNCTIONS = {
    "balance": {"type": "materialPointBalance"},
    "extent": {"type": "materialPointExtent"},
    "xt": {"type": "materialPointXT", "field": "sigma_yy", "direction": "y",
           "range": [0, 3*exact.H], "nBins": 15},
    "gauge": {"type": "materialPointProbes", "phase": "target",
              "fields": ["U_y", "sigma_yy"],
              "points": {"nearest": [[0, exact.H, 0]]}},
}


def makeCase():
    case = plateCase("tools", "plates", 10,
                     {"shapeFunction": "GIMP", "transfer": "FMPM"}, END, INTERVAL,
                     0.4, strength=400e6)
    functions = "".join(
        f"{name} {{\nlibs (mpmFunctionObjects);\nwriteControl timeStep;\n"
        + foamText(entries) + "}\n" for name, entries in FUNCTIONS.items())
    case.change("system/controlDict", r"^functions\s*\{", "functions\n{\n" + functions)
    case.change("system/controlDict", "^deltaT ", "reportInterval 1;\ndeltaT ")
    case.run("materialPointFoam")
    return case


def output(case, *command):
    """Exit status and output of a tool."""
    log = case.file("log.output")
    open(log, "w").close()
    status = launch(command, case.path, log, limit=60).status
    with open(log, encoding="latin-1") as f:
        return status, f.read()


def contents(case, folders):
    found = {}
    for folder in folders:
        for root, _, names in os.walk(case.file(folder)):
            for name in names:
                with open(os.path.join(root, name), "rb") as f:
                    found[os.path.join(root, name)] = f.read()
    return found


def ownOptions(table, case):
    for tool, words in (("materialPointFoam", ("-dry-run", "-postProcess", "-case")),
                        ("setMaterialPoints", ("-dict", "-count", "phaseProperties"))):
        status, text = output(case, tool, "-help")
        missing = [w for w in words if w not in text]
        table.check(f"{tool} -help", status == 0 and not missing and "Usage:" in text,
                    f"exit {status}, missing: {missing}")

    before = contents(case, case.times() + ["postProcessing"])
    status, text = output(case, "materialPointFoam", "-dry-run")
    table.check("materialPointFoam -dry-run", status == 0 and "complete" in text
                and "Time = " not in text.split("Create mesh")[-1].split("\n", 1)[1],
                f"exit {status}")
    status, text = output(case, "setMaterialPoints", "-count")
    n = len(case.points("0", "target")["id"])
    table.check("setMaterialPoints -count",
                status == 0 and re.search(rf"target +target +{n} ", text), f"exit {status}")
    table.check("-dry-run and -count write nothing",
                contents(case, case.times() + ["postProcessing"]) == before)


def ownPostProcess(table, case):
    """Function objects after the run give the rows of the run."""
    files = sorted(glob.glob(case.file("postProcessing", "*", "0", "*.dat")))
    during = {f: np.loadtxt(f, ndmin=2) for f in files}
    status, text = output(case, "materialPointFoam", "-postProcess")
    table.check("materialPointFoam -postProcess",
                status == 0 and "--> FOAM" not in text, f"exit {status}")
    nRows, worst = 0, 0.0
    for name, rows in during.items():
        folder = os.path.dirname(os.path.dirname(name))
        after = [f for f in glob.glob(os.path.join(
            folder, "*", os.path.basename(name)[:-4] + "*.dat")) if f != name]
        for row in (r for f in after for r in np.loadtxt(f, ndmin=2)):
            near = rows[np.argmin(abs(rows[:, 0] - row[0]))]
            if abs(near[0] - row[0]) > 1e-6*END:
                continue        # the start: no row during the run
            nRows += 1
            # Columns of one quantity, whose rounding is that of the largest
            scale = np.maximum(abs(rows).max(axis=0), 1e-12*abs(rows).max())
            worst = max(worst, float((abs(near - row)/scale)[1:].max()))
    table.row("-postProcess: files of the run that it repeats", 8, len(during), 0)
    table.row("-postProcess: rows at times of the run", 16, nRows, 16, "atLeast")
    table.row("-postProcess: difference from the run's rows", 0, worst, 1e-12)


def dictionaries(table, case):
    paths = [os.path.join(case.path, f) for f in
             ("system/controlDict", "system/fvSolution", "system/setMaterialPointsDict",
              "constant/phaseProperties", "0/U.plates",
              case.times()[-1] + "/uniform/materialPointState")]
    for root, folders, names in os.walk(os.path.join(PROJECT, "tutorials")):
        folders[:] = [f for f in folders if f not in ("variants", "postProcessing")]
        if os.path.basename(root) in ("system", "constant", "0"):
            paths += [os.path.join(root, n) for n in names
                      if re.match(r"U\.|g$|.*Dict$|fv|phaseP", n)]
    bad = []
    for path in paths:
        status, text = output(case, "foamDictionary", path)
        if status or "FOAM" in text.replace("FoamFile", ""):
            bad.append(path)
    table.check("foamDictionary reads all dictionaries", not bad and len(paths) > 200,
                " ".join(bad) or len(paths))

    status, text = output(case, "foamDictionary", "constant/phaseProperties",
                          "-entry", "target.constitutiveModel.rho", "-value")
    table.check("foamDictionary -entry -value",
                status == 0 and float(text.split()[-1]) == exact.RHO, text.strip())
    output(case, "foamDictionary", "system/setMaterialPointsDict",
           "-entry", "regions.target.pointsPerCell", "-set", "3")
    status, text = output(case, "setMaterialPoints", "-count")
    n = len(case.points("0", "target")["id"])*9//4
    table.check("foamDictionary -set, then setMaterialPoints -count",
                status == 0 and re.search(rf"target +target +{n} ", text), f"exit {status}")


def times(table, case):
    status, text = output(case, "foamListTimes")
    table.check("foamListTimes", status == 0 and text.split() == case.times()[1:],
                " ".join(text.split()))
    status, text = output(case, "foamListTimes", "-latestTime")
    table.check("foamListTimes -latestTime", text.split() == case.times()[-1:],
                " ".join(text.split()))


def foamLog(table, case):
    """Columns from the log: one value per step."""
    status, text = output(case, "foamLog", "log.materialPointFoam")
    n = case.nSteps()
    table.check("foamLog", status == 0, f"exit {status}")
    for name, check in (
            ("Time", lambda v: np.all(np.diff(v) > 0) and abs(v[-1]/END - 1) < 1e-6),
            ("deltaT", lambda v: np.all(v > 0)),
            ("CourantMax", lambda v: np.all((v > 0) & (v <= 0.4*1.01))),
            ("CourantMean", lambda v: np.all((v > 0) & (v <= 0.4*1.01))),
            ("executionTime", lambda v: np.all(np.diff(v) >= 0)),
            ("clockTime", lambda v: np.all(np.diff(v) >= 0))):
        path = case.file("logs", name + "_0")
        try:
            # What is printed before the first "Time =" has no time, only a value
            with open(path) as f:
                values = np.array([float(row.split()[-1]) for row in f])
            ok = abs(len(values) - n) <= 1 and check(values[:n])
            table.check(f"foamLog: {name}", ok, f"{len(values)} values, {n} steps")
        except (OSError, ValueError, IndexError) as error:
            table.check(f"foamLog: {name}", False, repr(error))


def fieldTools(table, case):
    status, text = output(case, "checkMesh")
    table.check("checkMesh", status == 0 and "Mesh OK" in text, f"exit {status}")

    status, text = output(case, "foamToVTK")
    made = glob.glob(case.file("VTK", "**", "*.vtp"), recursive=True)
    table.check("foamToVTK writes the clouds of all times",
                status == 0 and len([f for f in made if "lagrangian" in f])
                >= 2*len(case.times()[1:]), f"exit {status}, {len(made)} .vtp")

    # Cell means: their integral is the volume of the points
    case.write("system/volume", {
        "type": "volFieldValue", "libs": "(fieldFunctionObjects)",
        "operation": "volIntegrate", "regionType": "all",
        "writeFields": False, "fields": "(alpha.target)"})
    status, text = output(case, "postProcess", "-latestTime", "-func", "volume")
    last = case.times()[-1]
    found = glob.glob(case.file("postProcessing", "volume*", "*", "volFieldValue*.dat"))
    volume = np.loadtxt(found[0], ndmin=2)[-1, -1] if found else np.nan
    table.row("postProcess -func: integral of alpha.target",
              case.points(last, "target")["V"].sum(), volume, 1e-9, "relative")

    status, text = output(case, "postProcess", "-latestTime", "-func",
                          "mag(Umean.flyer)")
    made = glob.glob(case.file(last, "mag(Umean.flyer)"))
    table.check("postProcess -func mag(Umean.flyer)", status == 0 and made,
                f"exit {status}")

    # Ours need the points, which postProcess does not have: it must say so
    case.write("system/ours", {"type": "materialPointBalance",
                               "libs": "(mpmFunctionObjects)"})
    # (OpenFOAM's programs cannot load libraries built with the sanitizers)
    if os.environ.get("MPM_BUILD") != "sanitize":
        status, text = output(case, "postProcess", "-latestTime", "-func", "ours")
        table.check("postProcess -func with our function object says why not",
                    "materialPointFoam -postProcess" in text
                    and "printStack" not in text, f"exit {status}")
    status, text = output(case, "materialPointFoam", "-postProcess", "-latestTime",
                          "-func", "ours")
    table.check("materialPointFoam -postProcess -func",
                status == 0 and glob.glob(case.file("postProcessing", "ours", "*", "*")),
                f"exit {status}")


def copiedTutorial(table, case):
    """A tutorial runs from a folder of its own; all look for the project by its name."""
    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(folder, "deep", "down", "bar")
        shutil.copytree(os.path.join(PROJECT, "tutorials/vibratingBar"), copy,
                        ignore=shutil.ignore_patterns("log.*", "postProcessing", "polyMesh"))
        control = os.path.join(copy, "system/controlDict")
        with open(control) as f:
            text = f.read()
        with open(control, "w") as f:
            f.write(text.replace("endTime         50;", "endTime         12.5;"))
        run = subprocess.run([os.path.join(copy, "Allrun")], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=120,
                             cwd="/", env={**os.environ, "MPM_PROJECT_DIR": PROJECT})
        log = os.path.join(copy, "log.materialPointFoam")
        done = os.path.exists(log) and open(log).read().rstrip().endswith("End")
        table.check("a copied tutorial runs elsewhere", done, run.stdout.decode()[-200:])
        size = os.path.getsize(log)/1e6 if done else np.inf
        table.row("size of its log [MB]", 1, size, 1, "atMost")
    scripts = glob.glob(os.path.join(PROJECT, "tutorials/*/Allrun"))
    bad = [s for s in scripts
           if '. "${MPM_PROJECT_DIR:-../..}/etc/prepare"' not in open(s).read()]
    table.check(f"all {len(scripts)} tutorials look for the project by its name", not bad,
                " ".join(bad))


def copiedCheckout(table, case):
    """What was built in a checkout is good where that is copied to; a build with other settings
    that is interrupted leaves the programs that were there."""
    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(folder, "project")
        os.makedirs(os.path.join(copy, "tests"))
        for name in ("src", "applications", "etc", "platforms", "Allwmake", "tests/unit",
                     "benchmarks"):
            subprocess.run(["cp", "-a", os.path.join(PROJECT, name), os.path.join(copy, name)],
                           check=True)
        library = os.path.join(copy, os.path.relpath(os.environ["FOAM_USER_LIBBIN"], PROJECT))
        target = os.path.dirname(library)
        stamp = max((os.path.join(target, name) for name in os.listdir(target)
                     if name.startswith("built")), key=os.path.getmtime)
        kind = re.fullmatch(r"built(\+tests)?(\+benchmarks)?(-separate-(\w+)-(\w+))?",
                            os.path.basename(stamp))
        options = [option for option, has in
                   (("-tests", kind[1]), ("-benchmarks", kind[2]),
                    (f"-separate={kind[4]}/{kind[5]}", kind[3])) if has]
        # cp gives folders and links their times too, so nothing is newer than the build
        made = subprocess.run(["bash", "Allwmake", *options], cwd=copy, text=True, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        table.check("a copied checkout is up to date", made.returncode == 0
                    and made.stdout == f"Everything is up to date in {target}\n", made.stdout)
        with open(os.path.join(target, "settings")) as f:
            table.check("its settings name its place", f"target    {target}\n" in f.read())
        build = subprocess.Popen(["bash", "Allwmake"], cwd=copy, start_new_session=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 env={**os.environ, "MPM_EXTRA_CXXFLAGS": "-DOTHER"}, text=True)
        first = build.stdout.readline()
        anew = os.path.join(target, "anew")
        until = time.monotonic() + 20
        while not os.path.isdir(anew) and time.monotonic() < until:
            time.sleep(0.1)
        os.killpg(build.pid, signal.SIGTERM)
        build.communicate()
        program = os.path.join(target, "bin/materialPointFoam")
        helped = subprocess.run([program, "-help"], capture_output=True,
                                env={**os.environ, "LD_LIBRARY_PATH": library + ":"
                                     + os.environ["LD_LIBRARY_PATH"]})
        table.check("an interrupted build with other settings leaves the programs",
                    first.startswith("other settings than before") and os.path.isdir(anew)
                    and helped.returncode == 0 and b"Usage" in helped.stdout, first)


def variants(table, case):
    """What the tutorials' variants change is still in their dictionaries: programs that do
    nothing stand for the solver and its tools."""
    arguments = {"taylorBar": ["fine"], "projectile": ["fine", "tried"],
                 "ballThroughPlate": ["fine", "aluminium", "ductile", "strong", "oneField",
                                      "quarter"]}
    point = "mkdir -p 0/lagrangian/slab\ncat > 0/lagrangian/slab/x <<END\n" \
        + fileHeader("x", "vectorField") + "1\n(\n(0.5 0 0)\n)\nEND\n"
    with tempfile.TemporaryDirectory() as folder:
        for program in ("blockMesh", "setFields", "setFluids", "setMaterialPoints",
                        "materialPointFoam"):
            with open(os.path.join(folder, program), "w") as f:
                f.write("#!/bin/sh\n" + (point if program == "setMaterialPoints" else ""))
            os.chmod(f.name, 0o755)
        scripts = glob.glob(os.path.join(PROJECT, "tutorials/*/variants.py"))
        bad = []
        for script in scripts:
            name = os.path.basename(os.path.dirname(script))
            copy = os.path.join(folder, name)
            shutil.copytree(os.path.dirname(script), copy, ignore=shutil.ignore_patterns(
                "log.*", "postProcessing", "polyMesh", "processor*", "VTK", "variants",
                "lagrangian", "[1-9]*", "0.[0-9]*"))
            run = subprocess.run(
                [sys.executable, "variants.py", *arguments.get(name, [])], cwd=copy,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                timeout=60, env={**os.environ, "PATH": folder + ":" + os.environ["PATH"],
                                 "PYTHONPATH": os.path.join(PROJECT, "etc", "python")})
            if run.returncode:
                bad.append(f"{name}: {run.stdout.decode()[-200:]}")
    table.check(f"variants of {len(scripts)} tutorials fit their dictionaries",
                scripts and not bad, " ".join(bad))


def main():
    table = Report("tools")
    try:
        case = makeCase()
    except RunFailed as error:
        table.check("the case runs", False, error)
        return table.finish()
    for check in (ownOptions, ownPostProcess, times, foamLog, fieldTools, dictionaries,
                  copiedTutorial, copiedCheckout, variants):
        check(table, case)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
