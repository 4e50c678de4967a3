"""Cases of the tests: write their dictionaries, run them, read what they wrote.

    case = FoamCase("spall", "cells100")        # tests/run/spall/cells100, empty
    case.write("system/fvSolution", {"materialPoints": {"shapeFunction": "GIMP"}})
    seconds = case.run("materialPointFoam", limit=60)
    table = case.series("gauge", "sigma_yy.dat")
    velocity = case.points("0", "target")["U"]

Values of dictionaries: text goes in as it is, numbers with all digits, True and
False as yes and no, lists in parentheses, dictionaries in braces.
"""

import os
import re
import resource
import shutil
import subprocess
import sys
import time

import numpy as np

from report import Report

TESTS = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
PROJECT = os.path.dirname(TESTS)
RUN = os.path.join(TESTS, "run")

#: Also the long series
VERIFY = os.environ.get("MPM_VERIFY", "") not in ("", "0")


class RunFailed(Exception):
    """An application ended with an error or did not end in time."""


def foamText(value, indent=0):
    """A value as OpenFOAM's dictionaries have it."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, dict):
        pad = " "*indent
        lines = []
        for key, entry in value.items():
            if isinstance(entry, dict):
                lines.append(f"{pad}{key}\n{pad}{{\n"
                             f"{foamText(entry, indent + 4)}{pad}}}\n")
            else:
                lines.append(f"{pad}{key} {foamText(entry)};\n")
        return "".join(lines)
    if isinstance(value, (list, tuple, np.ndarray)):
        return "(" + " ".join(foamText(v) for v in value) + ")"
    return str(value)


def fileHeader(objectName, kind="dictionary"):
    return ("FoamFile\n{\n    version 2.0;\n    format ascii;\n"
            f"    class {kind};\n    object {objectName};\n}}\n\n")


class FoamCase:
    """One case folder, tests/run/<case>/<name>, made anew."""

    def __init__(self, case, name, template=None):
        self.name = name
        self.path = os.path.join(RUN, case, name)
        shutil.rmtree(self.path, ignore_errors=True)
        os.makedirs(os.path.dirname(self.path), exist_ok=True)
        if template:
            shutil.copytree(template, self.path, ignore=shutil.ignore_patterns(
                "log.*", "postProcessing", "polyMesh", "processor*", "VTK"))
        else:
            os.makedirs(self.path)

    def file(self, *parts):
        return os.path.join(self.path, *parts)

    def write(self, path, entries, kind="dictionary"):
        """A dictionary file in place of what was there."""
        os.makedirs(os.path.dirname(self.file(path)), exist_ok=True)
        with open(self.file(path), "w") as f:
            f.write(fileHeader(os.path.basename(path), kind) + foamText(entries))

    def change(self, path, pattern, text, age=0):
        """Replace a regular expression, which must be there, in a file: at once, for runs
        that read it meanwhile. Seconds of age."""
        with open(self.file(path)) as f:
            old = f.read()
        new, count = re.subn(pattern, text, old, flags=re.M)
        if not count:
            raise RunFailed(f"{pattern} not found in {self.file(path)}")
        with open(self.file(path) + ".part", "w") as f:
            f.write(new)
        if age:
            os.utime(f.name, (time.time() - age,)*2)
        shutil.copymode(self.file(path), f.name)
        os.replace(f.name, self.file(path))

    def run(self, *command, limit=120, fails=False):
        """Run an application in the case; its output goes to log.<name>.
        Returns the seconds of one core that it took."""
        log = self.file("log." + os.path.basename(command[0]))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        with open(log, "w") as out:
            try:
                code = subprocess.run(
                    command, cwd=self.path, stdout=out, stderr=subprocess.STDOUT,
                    stdin=subprocess.DEVNULL, timeout=limit,
                    env={**os.environ, "PWD": self.path}).returncode
            except subprocess.TimeoutExpired:
                raise RunFailed(f"{command[0]} did not end in {limit} s: {log}")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if bool(code) != fails:
            raise RunFailed(f"{' '.join(command)}: exit status {code}: "
                            + self.reason(log))
        return (after.ru_utime + after.ru_stime
                - before.ru_utime - before.ru_stime)

    @staticmethod
    def reason(log):
        """One line: OpenFOAM's error or the last words, and the log's name."""
        with open(log, errors="replace") as f:
            text = f.read()
        error = re.search(r"FATAL (?:IO )?ERROR:\s*(.*?)\n\s*\n", text, flags=re.S)
        words = (error[1] if error else text[-300:]).split()
        return " ".join(words)[:300] + f" ({log})"

    def log(self, application="materialPointFoam"):
        with open(self.file("log." + application), errors="replace") as f:
            return f.read()

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

    def nSteps(self):
        """Steps of a run that has ended, of another those that its log has."""
        log = self.log()
        end = re.search(r"^Steps: (\d+)$", log, flags=re.M)
        return int(end[1]) if end else len(re.findall(r"^Time = ", log, flags=re.M))

    def solverSeconds(self):
        """CPU seconds from the first to the last step: without start-up."""
        times = re.findall(r"^ExecutionTime = ([0-9.eE+-]+) s", self.log(), flags=re.M)
        return float(times[-1]) - float(times[0]) if len(times) > 1 else 0.0

    def times(self):
        """Names of the time folders in order."""
        names = []
        for name in os.listdir(self.path):
            try:
                names.append((float(name), name))
            except ValueError:
                pass
        return [name for _, name in sorted(names)]

    def timeName(self, value, tolerance=1e-6):
        """The time folder of a value."""
        for name in self.times():
            if abs(float(name) - value) <= tolerance*abs(value):
                return name
        raise RunFailed(f"no time {value} in {self.path}: {self.times()}")

    def series(self, functionObject, fileName, time="0"):
        """A table of postProcessing, one row per time."""
        return np.loadtxt(self.file("postProcessing", functionObject, time, fileName),
                          ndmin=2)

    def points(self, time, phase):
        """The cloud of a time: of the case or, where it has none, of its
        processors one after the other."""
        path = self.file(time, "lagrangian", phase)
        if os.path.exists(path):
            return Points([path])
        return Points([p for p in (
            os.path.join(d, time, "lagrangian", phase) for d in self.processors())
            if os.path.exists(os.path.join(p, "id"))])

    def processors(self):
        """The processor folders in the order of their numbers."""
        names = [d for d in os.listdir(self.path) if re.fullmatch(r"processor\d+", d)]
        return [self.file(d) for d in sorted(names, key=lambda d: int(d[9:]))]

    def decompose(self, n, weightField=None):
        """decomposePar into (nx, ny, nz) pieces of the method hierarchical."""
        self.write("system/decomposeParDict", {
            "numberOfSubdomains": int(np.prod(n)), "method": "hierarchical",
            **({"weightField": weightField} if weightField else {}),
            "hierarchicalCoeffs": {"n": n, "delta": 0.001, "order": "xyz"}})
        self.run("decomposePar", "-force")

    def runParallel(self, application="materialPointFoam", *options, limit=120):
        """An application on all processors of the case."""
        try:
            return self.run(*mpirun(len(self.processors())), application, "-parallel",
                            *options, limit=limit)
        finally:
            shutil.move(self.file("log.mpirun"), self.file("log." + application))


def mpirun(nProcs):
    """Start of a command on so many processors, also as root and on fewer cores."""
    return ("mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(nProcs))


class Points:
    """Columns of a cloud, read when asked for: points["sigma"]."""

    def __init__(self, paths):
        self.paths = paths

    def __getitem__(self, name):
        return np.concatenate([readField(os.path.join(p, name)) for p in self.paths])

    def __contains__(self, name):
        return bool(self.paths) and os.path.exists(os.path.join(self.paths[0], name))

    def byId(self, name):
        """The column in the order of the points' ids."""
        return self[name][np.argsort(self["id"])]


_KINDS = {"scalarField": ("f8", 1), "vectorField": ("f8", 3),
          "symmTensorField": ("f8", 6), "tensorField": ("f8", 9),
          "labelField": ("i4", 1)}


def readField(path):
    """A field of a cloud, ascii or binary, as an array."""
    with open(path, "rb") as f:
        raw = f.read()
    head = re.search(rb"FoamFile\s*\{(.*?)\}", raw, flags=re.S)
    kind, size = _KINDS[re.search(rb"class\s+(\w+)\s*;", head[1])[1].decode()]
    binary = re.search(rb"format\s+(\w+)\s*;", head[1])[1] == b"binary"
    body = re.sub(rb"\A(\s*//[^\n]*\n)*\s*", b"", raw[head.end():], count=1)
    count = re.match(rb"(\d+)\s*", body)
    n, body = int(count[1]), body[count.end():]
    if n == 0:
        values = np.zeros(0, kind)
    elif body[:1] == b"{":
        one = np.array(body[1:body.index(b"}")].translate(None, b"()").split(), kind)
        values = np.tile(one, n)
    elif binary:
        values = np.frombuffer(body, kind, n*size, 1)
    else:
        text = body[:body.index(b"// ***")] if b"// ***" in body else body
        values = np.array(text.translate(None, b"()").split(), kind)
    return values.reshape(n, size) if size > 1 else values


_TYPES = {"scalar": 1, "vector": 3, "symmTensor": 6, "tensor": 9}


def readInternal(path):
    """Inner values of a field on cells or mesh points; they must not be uniform
    unless there is one value."""
    with open(path, "rb") as f:
        raw = f.read()
    binary = re.search(rb"format\s+(\w+)\s*;", raw)[1] == b"binary"
    head = re.search(rb"internalField\s+(?:uniform\s+([^;]*);"
                     rb"|nonuniform\s+List<(\w+)>\s*(\d+)\s*\()", raw)
    if head[1] is not None:
        return np.array([head[1].translate(None, b"()").split()], float)
    n, size = int(head[3]), _TYPES[head[2].decode()]
    body = raw[head.end():]
    if binary:
        values = np.frombuffer(body, "f8", n*size)
    else:
        values = np.array(body[:body.index(b";")].translate(None, b"()").split(), float)
    return values.reshape(n, size) if size > 1 else values


def writeField(path, values):
    """A field of a cloud in ascii with all digits."""
    values = np.asarray(values)
    kind = {1: "scalarField", 3: "vectorField", 6: "symmTensorField"}[
        1 if values.ndim == 1 else values.shape[1]]
    with open(path, "w") as f:
        f.write(fileHeader(os.path.basename(path), kind))
        f.write(f"{len(values)}\n(\n")
        for v in values:
            f.write(foamText(v if values.ndim > 1 else float(v)) + "\n")
        f.write(")\n")


_SIDES = {"x-": (0, 4, 7, 3), "x+": (1, 2, 6, 5), "y-": (0, 1, 5, 4),
          "y+": (3, 7, 6, 2), "z-": (0, 3, 2, 1), "z+": (4, 5, 6, 7)}


def boxMesh(low, high, cells, patches):
    """blockMeshDict of a box along the axes; patches: name: (type, sides), e.g.
    {"walls": ("patch", ("y-", "y+")), "sides": ("empty", ("z-", "z+"))}."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    vertices = [(x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0),
                (x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)]
    boundary = "(" + " ".join(
        f"{name} {{ type {kind}; faces {foamText([_SIDES[s] for s in sides])}; }}"
        for name, (kind, sides) in patches.items()) + ")"
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
    return table.finish()
