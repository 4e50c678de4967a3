"""A case folder: run applications in it, read what they wrote.

    case = Case("variants/fine")
    case.change("system/blockMeshDict", r"^n .*", "n 80;")
    case.run("materialPointFoam")
    t, stress = case.series("gauge", "sigma_yy.dat").T
    x = case.points(case.times("lagrangian")[-1], "target")["x"]
    lowest, highest = case.numbers("^    p N to N,").T
    case.set("constant/phaseProperties", "target.E", 7e10)      # comments stay
    kinetic = case.table("balance/target.dat")["kinetic"]
"""

import os
import re
import resource
import shutil
import subprocess
import time

import numpy as np

from mpm.dictionaries import DictionaryError, getEntry, readDictionary, setEntry
from mpm.files import Points, fileHeader, foamText, readField, readInternal, readLists

NUMBER = r"([-+\d.]+(?:e[-+]?\d+)?|-?nan|-?inf)"


class RunFailed(Exception):
    """An application ended with an error or did not end in time."""


class Table(dict):
    """Columns by name; another name is an error that lists them. units: those that the table
    names, by the column's name."""

    def __init__(self, columns, path, units=None):
        super().__init__(columns)
        self.path, self.units = path, units or {}

    def __missing__(self, name):
        raise RunFailed(f"no column {name} in {self.path}; there are: {', '.join(self)}")


class Case:
    #: Seconds that an application may take; None: any
    limit = None

    def __init__(self, path="."):
        self.path = path

    def file(self, *parts):
        return os.path.join(self.path, *parts)

    def copy(self, start=None, source=".", mesh=None):
        """Make the folder anew from another case: constant, system and these files of 0; by
        default all that a user writes, of 0.orig if there is one. mesh: constant/polyMesh too;
        by default if there is no blockMeshDict to make it anew."""
        if mesh is None:
            mesh = not os.path.exists(os.path.join(source, "system/blockMeshDict"))
        shutil.rmtree(self.path, ignore_errors=True)
        for folder in ("constant", "system"):
            shutil.copytree(os.path.join(source, folder), self.file(folder),
                            ignore=None if mesh else shutil.ignore_patterns("polyMesh"))
        os.makedirs(self.file("0"))
        zero = os.path.join(source, "0")
        if start is None:
            zero += ".orig" if os.path.isdir(zero + ".orig") else ""
            start = [n for n in (os.listdir(zero) if os.path.isdir(zero) else ())
                     if os.path.isfile(os.path.join(zero, n)) and n != "cellWeights"]
        for name in start:
            shutil.copy(os.path.join(zero, name), self.file("0"))

    def needMesh(self):
        """An error if there is no mesh, and no blockMeshDict to make it."""
        if not any(os.path.exists(self.file(name)) for name in (
                "system/blockMeshDict", "constant/polyMesh/faces", "constant/polyMesh/faces.gz")):
            raise RunFailed(f"{self.path} has neither constant/polyMesh nor system/blockMeshDict:"
                            " make its mesh first (gmsh: gmshToFoam)")

    def prepare(self):
        """Mesh, fluids and points of the dictionaries that the case has. A mesh that is there
        stays if no blockMeshDict is."""
        self.needMesh()
        for dictionary, application in (
                ("blockMeshDict", "blockMesh"), ("adaptiveMeshDict", "adaptMesh"),
                ("setFluidsDict", "setFluids"), ("setFieldsDict", "setFields"),
                ("setMaterialPointsDict", "setMaterialPoints")):
            if os.path.exists(self.file("system", dictionary)):
                self.run(application)

    def get(self, path, entry=None):
        """The value of an entry of a dictionary, or all of it as dict: numbers, lists, text, as
        OpenFOAM reads them ($, #include). Entries as in set."""
        try:
            text = self._text(path)
            if entry is None:
                return readDictionary(self.file(path), self.path)
            try:
                found = getEntry(text, entry)
                if "$" not in str(found) and "#" not in str(found):
                    return found
            except DictionaryError:
                if "$" not in text and "#" not in text:
                    raise
            return getEntry(foamText(readDictionary(self.file(path), self.path)), entry)
        except DictionaryError as error:
            raise DictionaryError(f"{self.file(path)}: {error}") from None

    def set(self, path, entry, value, add=False):
        """Another value of an entry: "target.constitutiveModel.E" or, if there is only one in
        the target, "target.E". Text as it is, numbers, True and False, lists, dict. add: it may
        be new, and the path is the whole one. Comments and layout stay."""
        try:
            text = setEntry(self._text(path), entry, value, add)
        except DictionaryError as error:
            raise DictionaryError(f"{self.file(path)}: {error}") from None
        self._put(path, text)

    def _text(self, path):
        try:
            with open(self.file(path), errors="surrogateescape") as f:
                return f.read()
        except OSError as error:
            raise DictionaryError(error.strerror) from None

    def write(self, path, entries, kind="dictionary"):
        """A dictionary file in place of what was there."""
        os.makedirs(os.path.dirname(self.file(path)), exist_ok=True)
        with open(self.file(path), "w") as f:
            f.write(fileHeader(os.path.basename(path), kind) + foamText(entries))

    def change(self, path, pattern, text, age=0):
        """Replace a regular expression, which must be there ((?s) first: dots are line
        ends too), in a file: at once, for runs that read it meanwhile. Seconds of age."""
        with open(self.file(path)) as f:
            old = f.read()
        new, count = re.subn(pattern, text, old, flags=re.M)
        if not count:
            raise RunFailed(f"{pattern} not found in {self.file(path)}")
        self._put(path, new, age)

    def _put(self, path, text, age=0):
        """A file's new text at once, for runs that read it meanwhile."""
        with open(self.file(path) + ".part", "w", errors="surrogateescape") as f:
            f.write(text)
        if age:
            os.utime(f.name, (time.time() - age,)*2)
        shutil.copymode(self.file(path), f.name)
        os.replace(f.name, self.file(path))

    def run(self, *command, limit=None, fails=False):
        """Run an application in the case; its output goes to log.<name>.
        Returns the seconds of one core that it took."""
        limit = limit or self.limit
        log = self.file("log." + os.path.basename(command[0]))
        code, seconds = self._execute(command, log, limit)
        if code is None:
            raise RunFailed(f"{command[0]} did not end in {limit} s: {log}")
        if bool(code) != fails:
            raise RunFailed(f"{' '.join(command)}: exit status {code}: "
                            + self.reason(log))
        return seconds

    def _execute(self, command, log, limit):
        """Exit status (None: stopped at the limit) and seconds of one core."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        with open(log, "w") as out:
            try:
                code = subprocess.run(
                    command, cwd=self.path, stdout=out, stderr=subprocess.STDOUT,
                    stdin=subprocess.DEVNULL, timeout=limit,
                    env={**os.environ, "PWD": self.path}).returncode
            except subprocess.TimeoutExpired:
                code = None
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return code, (after.ru_utime + after.ru_stime
                      - before.ru_utime - before.ru_stime)

    @staticmethod
    def reason(log):
        """One line: OpenFOAM's error or the last words, and the log's name."""
        with open(log, errors="replace") as f:
            text = f.read()
        error = re.search(r"FATAL (?:IO )?ERROR:\s*(?:\(openfoam-[^)]*\)\s*)?(.*?)\n\s*\n",
                          text, flags=re.S)
        words = (error[1] if error else text[-300:]).split()
        if re.search(r"^size \d+ is not equal to the given value", " ".join(words)):
            words.append("(a field of 0 is of another mesh: keep the files that you wrote in "
                         "0.orig, from which each run then starts)")
        return " ".join(words)[:300] + f" ({log})"

    def log(self, application="materialPointFoam"):
        with open(self.file("log." + application), errors="replace") as f:
            return f.read()

    def numbers(self, pattern, application="materialPointFoam"):
        """Rows of the numbers N of a regular expression wherever the log has it."""
        return np.array(re.findall(pattern.replace("N", NUMBER), self.log(application),
                                   flags=re.M), float)

    def energyResidual(self):
        """Last residual of the energy budget over the largest energy of the points or what a source
        has brought or taken: boundary, external, and of a gas or fluids pressure and drag. None
        without a budget in the log."""
        log = self.log()
        found = re.findall(r"\bresidual (\S+)$", log, re.M)
        lines = "\n".join(re.findall(
            r"^(?:Energy: .*|Energy budget: .*|    to points: .*)$", log, re.M))
        sizes = re.findall(r"\b(?:total|boundary|external|pressure|drag) ([-+.\de]+)", lines)
        return float(found[-1])/(max(abs(float(v)) for v in sizes) or 1.0) \
            if found and sizes else None

    def fixups(self):
        """Number of fix-ups of the gas in the run."""
        return self.numbers("outflow limited N, theta kept N, isentropic N ")[-1].sum()

    def entry(self, path, name):
        """The first number of this name in a dictionary."""
        with open(self.file(path)) as f:
            return float(re.search(rf"^\s*{name}\s+([\d.eE+-]+)", f.read(), flags=re.M)[1])

    def nSteps(self):
        """Steps of a run that has ended, of another those that its log has."""
        log = self.log()
        end = re.search(r"^Steps: (\d+)", log, flags=re.M)
        return int(end[1]) if end else len(re.findall(r"^Time = ", log, flags=re.M))

    def solverSeconds(self):
        """CPU seconds from the first to the last step: without start-up."""
        times = re.findall(r"^ExecutionTime = ([0-9.eE+-]+) s", self.log(), flags=re.M)
        return float(times[-1]) - float(times[0]) if len(times) > 1 else 0.0

    def times(self, part=""):
        """Names of the time folders in order: of those that have a part of this path."""
        names = []
        for name in os.listdir(self.path):
            try:
                names.append((float(name), name))
            except ValueError:
                pass
        return [name for _, name in sorted(names) if os.path.exists(self.file(name, part))]

    def nearest(self, value, part=""):
        """The time folder nearest to a value."""
        return min(self.times(part), key=lambda name: abs(float(name) - value))

    def timeName(self, value, tolerance=1e-6):
        """The time folder of a value."""
        for name in self.times():
            if abs(float(name) - value) <= tolerance*abs(value):
                return name
        raise RunFailed(f"no time {value} in {self.path}: {self.times()}")

    def series(self, functionObject, fileName, time="0", once=False):
        """A table of postProcessing, one row per time (once: the first if it has more)."""
        table = np.loadtxt(self.file("postProcessing", functionObject, time, fileName),
                           ndmin=2)
        return table[np.unique(table[:, 0], return_index=True)[1]] if once else table

    def table(self, path):
        """Columns of a table of postProcessing by name, "balance/target.dat": those of all
        starts of a run one after the other, each up to the next."""
        name, file = os.path.split(path)
        parts = [(float(t), os.path.join(self.file("postProcessing", name), t, file))
                 for t in self._folders("postProcessing", name)]
        parts = [(t, p) for t, p in sorted(parts) if os.path.exists(p)]
        if not parts:
            raise RunFailed(f"no table {path} in {self.file('postProcessing')}; there are: "
                            + " ".join(self.tables()))
        with open(parts[0][1]) as f:
            head = [line for line in f if line.startswith("#")][-1].strip("# \n")
        heads = [re.fullmatch(r"(.*?)(?:\[([^]]*)\])?", w.strip())
                 for w in re.split(r"\t+|\s{2,}", head)]
        names = [h[1] for h in heads]
        rows = [np.loadtxt(p, ndmin=2) for _, p in parts]
        ends = [t for t, _ in parts[1:]] + [np.inf]
        rows = np.concatenate([r[r[:, 0] <= end] for r, end in zip(rows, ends) if r.size])
        return Table({n: rows[:, i] for i, n in enumerate(names[:rows.shape[1]])}, path,
                     {h[1]: h[2] for h in heads if h[2]})

    def tables(self):
        """Names of the tables of postProcessing, as table takes them."""
        top = self.file("postProcessing")
        return sorted({os.path.join(os.path.relpath(os.path.dirname(root), top), n)
                       for root, _, names in os.walk(top) for n in names if n.endswith(".dat")})

    def _folders(self, *parts):
        """Names of folders that are numbers."""
        place = self.file(*parts)
        return [n for n in (os.listdir(place) if os.path.isdir(place) else ())
                if re.fullmatch(r"[\d.eE+-]+", n)]

    def field(self, time, name, *n):
        """Values on the cells; with numbers (nx, ny) of a mesh's cells
        [row along y, column along x(, component)], also if it is uniform."""
        values = readInternal(self.file(time, name))
        if not n:
            return values
        size = values.shape[1:]
        return np.broadcast_to(values, (int(np.prod(n)), *size)).reshape(*n[::-1], *size)

    def edges(self):
        """Coordinates along x, y and z that the mesh's points have: of a mesh of boxes the
        edges of its cells."""
        x = readField(self.file("constant/polyMesh/points"))
        found = []
        for a in x.T:
            a = np.sort(a)
            found.append(a[np.append(True, np.diff(a) > 1e-9*np.ptp(x))])
        return found

    def nCells(self):
        return int(readLists(self.file("constant/polyMesh/owner")).max()) + 1

    def polygons(self, time=None):
        """Corners (x, y) of each cell of a mesh in the plane of x and y, any cells: the mesh of
        a time, or that of the start."""
        changed = [t for t in self.times("polyMesh/faces") if time and float(t) <= float(time)]
        mesh = self.file(changed[-1] if changed else "constant", "polyMesh")
        x = readField(os.path.join(mesh, "points"))
        faces = readLists(os.path.join(mesh, "faces"))
        owner = readLists(os.path.join(mesh, "owner"))
        with open(os.path.join(mesh, "boundary"), "rb") as f:
            empty = re.findall(rb"type\s+empty;.*?nFaces\s+(\d+);\s*startFace\s+(\d+);",
                               f.read(), flags=re.S)
        middle, found = x[:, 2].mean(), {}
        for n, start in empty:
            for i in range(int(start), int(start) + int(n)):
                corners = x[faces[i]]
                if corners[:, 2].mean() < middle:
                    found[owner[i]] = corners[:, :2]
        return [found[c] for c in range(len(found))]

    def points(self, time, phase):
        """The cloud of a time: of the case or, where it has none, of its
        processors one after the other."""
        path = self.file(time, "lagrangian", phase)
        if os.path.exists(path):
            return Points([path], path)
        return Points([p for p in (
            os.path.join(d, time, "lagrangian", phase) for d in self.processors())
            if os.path.exists(os.path.join(p, "id"))], self.file(time, "lagrangian", phase))

    def processors(self):
        """The processor folders in the order of their numbers."""
        names = [d for d in os.listdir(self.path) if re.fullmatch(r"processor\d+", d)]
        return [self.file(d) for d in sorted(names, key=lambda d: int(d[9:]))]
