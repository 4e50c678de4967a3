"""Cases of the tests: write their dictionaries, run them, read what they wrote.

    case = FoamCase("spall", "cells100")        # tests/run/spall/cells100, empty
    case.write("system/fvSolution", {"materialPoints": {"shapeFunction": "GIMP"}})
    seconds = case.run("materialPointFoam", limit=60)
    table = case.series("gauge", "sigma_yy.dat")
    velocity = case.points("0", "target")["U"]

etc/python/mpm has what tutorials use too: Case with the reading, and the files.
"""

import importlib.util
import os
import re
import shutil
import sys
import traceback

import numpy as np

from launcher import launch, library
from report import Report

TESTS = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
PROJECT = os.path.dirname(TESTS)
sys.path.insert(0, os.path.join(PROJECT, "etc", "python"))
from mpm.case import Case, RunFailed  # noqa: E402
from mpm.files import (Points, fileHeader, foamText, readField,  # noqa: E402,F401
                       readInternal, writeField)

RUN = os.path.join(TESTS, "run")

#: Programs with the sanitizers are five to ten times slower
SANITIZED = os.environ.get("MPM_BUILD") == "sanitize"
PATIENCE = 20 if SANITIZED else 1

#: Also the long series
VERIFY = os.environ.get("MPM_VERIFY", "") not in ("", "0")


class FoamCase(Case):
    """One case folder, tests/run/<case>/<name>, made anew."""

    limit = 120

    def __init__(self, case, name, template=None):
        super().__init__(os.path.join(RUN, case, name))
        self.name = name
        shutil.rmtree(self.path, ignore_errors=True)
        os.makedirs(os.path.dirname(self.path), exist_ok=True)
        if template:
            shutil.copytree(template, self.path, ignore=shutil.ignore_patterns(
                "log.*", "postProcessing", "polyMesh", "processor*", "VTK"))
        else:
            os.makedirs(self.path)

    def run(self, *command, limit=None, **options):
        if command == ("blockMesh",) and not options:
            return self._mesh(limit)
        return super().run(*command, limit=PATIENCE*(limit or self.limit), **options)

    def _execute(self, command, log, limit):
        open(log, "w").close()
        return launch(command, self.path, log, limit)

    #: Files of the meshes that blockMesh has made for this script, with its log
    _meshes = {}

    def _mesh(self, limit):
        """blockMesh, or a copy of what it has made from the same dictionary."""
        with open(self.file("system/blockMeshDict")) as f:
            text = f.read()
        with open(self.file("system/controlDict")) as f:
            key = text, *re.findall(r"^\s*(write[FPC]\w+\s.*?);", f.read(), re.M)
        folder, log = self.file("constant/polyMesh"), self.file("log.blockMesh")
        new = not os.path.exists(folder)
        if new and key in self._meshes:
            for path, data in self._meshes[key].items():
                os.makedirs(os.path.dirname(self.file(path)), exist_ok=True)
                with open(self.file(path), "wb") as f:
                    f.write(data)
            return 0.0
        seconds = super().run("blockMesh", limit=PATIENCE*(limit or self.limit))
        paths = [log] + [os.path.join(folder, name) for name in os.listdir(folder)]
        # Not where it reads other files, nor with sets
        if new and not re.search(r"#|geometry", text) and all(map(os.path.isfile, paths)):
            self._meshes[key] = {}
            for path in paths:
                with open(path, "rb") as f:
                    self._meshes[key][os.path.relpath(path, self.path)] = f.read()
        return seconds

    def largestDifference(self, other, time, phases, columns):
        """Largest difference of any column by id over the column's maximum;
        infinite if other has other points."""
        worst = 0.0
        for phase in phases:
            a, b = self.points(time, phase), other.points(time, phase)
            if not np.array_equal(np.sort(a["id"]), np.sort(b["id"])):
                return np.inf
            for column in columns:
                if column in a:
                    u, v = a.byId(column), b.byId(column)
                    size = np.max(np.abs(u)) or 1.0
                    worst = max(worst, float(np.max(np.abs(u - v)))/size)
        return worst

    def decompose(self, n, weightField=None):
        """decomposePar into (nx, ny, nz) pieces of the method hierarchical. MPM_MOVES=7: all
        cells go to random processors every 7 steps of the run (loadBalance)."""
        moves = os.environ.get("MPM_MOVES")
        self.write("system/decomposeParDict", {
            "numberOfSubdomains": int(np.prod(n)), "method": "hierarchical",
            **({"weightField": weightField} if weightField else {}),
            **({"loadBalance": {"interval": int(moves), "maxImbalance": 1, "worth": 0,
                                "method": "random"}} if moves else {}),
            "hierarchicalCoeffs": {"n": n, "delta": 0.001, "order": "xyz"}})
        self.run("decomposePar", "-force")

    def solve(self, split=None, before=lambda case: None):
        """The solver, on the processors of a split if there is one; before: called with the
        case when that is made."""
        if split:
            self.decompose(split)
        before(self)
        if split:
            self.runParallel()
        else:
            self.run("materialPointFoam")

    def runParallel(self, application="materialPointFoam", *options, limit=None):
        """An application on all processors of the case."""
        try:
            return self.run(*mpirun(len(self.processors())), application, "-parallel",
                            *options, limit=limit)
        finally:
            shutil.move(self.file("log.mpirun"), self.file("log." + application))


def mpirun(nProcs):
    """Start of a command on so many processors, also as root and on fewer cores, which
    those that wait leave to others. Networks are not looked for: a fifth of a short run."""
    sleep = () if SANITIZED else ("-x", "LD_PRELOAD=" + library("patientRank"))
    return ("mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
            "--mca", "mpi_yield_when_idle", "1", "--mca", "pml", "ob1",
            "--mca", "btl", "self,vader", *sleep, "-np", str(nProcs))


_SIDES = {"x-": (0, 4, 7, 3), "x+": (1, 2, 6, 5), "y-": (0, 1, 5, 4),
          "y+": (3, 7, 6, 2), "z-": (0, 3, 2, 1), "z+": (4, 5, 6, 7)}


def boxMesh(low, high, cells, patches):
    """blockMeshDict of a box along the axes; patches: name: (type, sides), e.g.
    {"walls": ("patch", ("y-", "y+")), "sides": ("empty", ("z-", "z+"))}; of cyclic
    ones (type, sides, neighbour)."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    vertices = [(x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0),
                (x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)]
    boundary = "(" + " ".join(
        f"{name} {{ type {kind}; faces {foamText([_SIDES[s] for s in sides])};"
        + "".join(f" neighbourPatch {n};" for n in neighbour) + " }"
        for name, (kind, sides, *neighbour) in patches.items()) + ")"
    return {"scale": 1, "vertices": vertices,
            "blocks": f"(hex (0 1 2 3 4 5 6 7) {foamText(cells)} simpleGrading (1 1 1))",
            "boundary": boundary}


def velocityFile(case, field, patches):
    """0/U.<field> with a condition (dictionary or type) for each patch."""
    conditions = {name: c if isinstance(c, dict) else {"type": c}
                  for name, c in patches.items()}
    case.write("0/U." + field,
               {"dimensions": "[0 1 -1 0 0 0 0]", "internalField": "uniform (0 0 0)",
                "boundaryField": conditions}, "pointVectorField")


def noSchemes(case):
    """Material points need none, but foamToVTK and others want the file."""
    case.write("system/fvSchemes",
               {name: {"default": value} for name, value in (
                   ("ddtSchemes", "none"), ("gradSchemes", "Gauss linear"),
                   ("divSchemes", "none"), ("laplacianSchemes", "none"),
                   ("interpolationSchemes", "linear"), ("snGradSchemes", "none"))})


def controlDict(endTime, writeInterval, maxCo=None, deltaT=None, functions=None,
                writeFormat="binary"):
    """controlDict with maxCo or, without, a fixed deltaT."""
    return {
        "application": "materialPointFoam", "startFrom": "startTime",
        "startTime": 0, "stopAt": "endTime", "endTime": endTime,
        "deltaT": deltaT if deltaT else endTime*1e-6,
        "adjustTimeStep": maxCo is not None,
        **({"maxCo": maxCo} if maxCo is not None else {}),
        "writeControl": "adjustableRunTime" if maxCo is not None else "runTime",
        "writeInterval": writeInterval, "purgeWrite": 0,
        "writeFormat": writeFormat, "writePrecision": 16,
        "writeCompression": "off", "timeFormat": "general", "timePrecision": 12,
        "runTimeModifiable": False, "functions": functions or {}}


def testModule(name, group):
    """A test of tests/cases as a module; the cases that it makes are those of a group."""
    path = os.path.join(os.path.dirname(__file__), "../cases", name, "test.py")
    spec = importlib.util.spec_from_file_location(name, path)
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    made.FoamCase = lambda _, case, template=None: FoamCase(group, f"{name}-{case}", template)

    # Makers of cases of tests/lib: two tests at once must not have the same folders
    for maker in ("plateCase", "gasCase", "coupledCase", "fluidCase", "blockInGas"):
        if hasattr(made, maker):
            def make(_, case, *args, of=getattr(made, maker), **more):
                return of(group, f"{name}-{case}", *args, **more)
            setattr(made, maker, make)
    return made


def runParts(case, *parts):
    """A test in parts, or those of them that the arguments name: each is called with the
    table; a run that fails is a row that failed. The exit code."""
    table = Report(case)
    for part in parts:
        if len(sys.argv) > 1 and part.__name__ not in sys.argv[1:]:
            continue
        try:
            part(table)
        except RunFailed as e:
            table.check(f"{part.__name__} runs", False, e)
        except Exception:
            # With its place, and the other parts still run
            table.check(f"{part.__name__} runs", False, traceback.format_exc())
    return table.finish()
