"""A series of runs over parameters, with a table and a plot at the end.

    from mpm.study import Study, largest, last

    study = Study("myCase",
                  {"E": ("constant/phaseProperties", "target.E", [50e9, 70e9, 90e9]),
                   "speed": ("system/setMaterialPointsDict", "flyer.velocity",
                             {50: (0, -50, 0), 100: (0, -100, 0)})},
                  {"strain": largest("balance/target.dat", "strain"),
                   "kinetic": last("balance/total.dat", "kinetic")})
    table = study.run()
    table.write("strain")                       # strain.csv, strain.md
    table.plot("speed", "strain", by="E", file="strain.png")        # or .svg

Parameters: name: (file, entry, values), entries as in Case.set; or (function, values), called
as function(case, value) in the copy. Values are a list, or a dictionary of what the table shows
and what the entry gets. All combinations run (combine="grid"), or the first values of all, then
the second (combine="list").

Quantities: name: function of the Case that gives a number; last, largest, least, period,
energyResidual, steps and seconds make some.

Each run is a folder of its own in `folder`, where one study runs at a time. Runs that have ended
well are not run anew, unless their dictionaries or the programs have changed; their quantities are
read anew. A run that failed is a row that says why, and is tried again by the next call. A quantity
that fails is nan; state says why.
"""

import contextlib
import csv
import fcntl
import fnmatch
import glob
import hashlib
import inspect
import itertools
import json
import os
import re
import shutil
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from mpm.case import Case, RunFailed
from mpm.dictionaries import DictionaryError
from mpm.files import foamText
from mpm.reportCase import UNITS, Meanings, flat, readDictionary

RECORD, LOCK = "study.json", ".lock"
#: Seconds between looks at the tables of a run
WATCH = 2.0
BUDGET = "energyBudget yes; in materialPoints of system/fvSolution"


class Study:
    """A series of runs. base: folder of the case, left as it is.

    folder      of the runs
    combine     grid or list
    steps       function(case) in place of Case.prepare and materialPointFoam
    limit       seconds that a program may take; None: any"""

    def __init__(self, base, parameters, quantities, folder="study", combine="grid",
                 steps=None, limit=None):
        self.base, self.folder = str(base), folder
        if not os.path.isdir(os.path.join(self.base, "system")):
            raise ValueError(f"{self.base} is no case: it has no folder system")
        self.parameters = {name: _Parameter(name, *spec) for name, spec in parameters.items()}
        self.quantities, self.steps, self.limit = quantities, steps, limit
        double = set(parameters) & {*quantities, "state"} | set(quantities) & {"state"}
        if double:
            raise ValueError(f"a column of the table twice: {' '.join(double)}")
        lists = [list(p.values) for p in self.parameters.values()]
        if combine == "list" and len({len(v) for v in lists}) > 1:
            raise ValueError("combine list: each parameter needs as many values, there are "
                             + ", ".join(f"{len(v)} of {n}" for n, v in zip(parameters, lists)))
        if combine not in ("grid", "list"):
            raise ValueError(f"combine {combine} is none of grid, list")
        for parameter in self.parameters.values():
            parameter.check(Case(self.base))
        rows = itertools.product(*lists) if combine == "grid" else zip(*lists)
        self.points = [dict(zip(parameters, row)) for row in rows]
        names = [self._name(point) for point in self.points]
        if len(set(names)) < len(names):
            raise ValueError("two runs have the same values of all parameters")
        self._stopped, self._hinted = threading.Event(), threading.Lock()

    def _name(self, point):
        """The folder of a run: its values; of one parameter with words the word."""
        if len(point) == 1 and isinstance(next(iter(point.values())), str):
            parts = point.values()
        else:
            parts = [f"{n}_{_text(v)}" for n, v in point.items()]
        return "-".join(re.sub(r"[^\w.+-]+", "_", p).rstrip("_") for p in parts) or "base"

    def case(self, **values):
        """The case of a run by its values: study.case(E=70e9, speed=50)."""
        return Case(os.path.join(self.folder, self._name(
            {name: values[name] for name in self.parameters})))

    def run(self, jobs=None):
        """Run what has not run, so many at a time (all cores); the table."""
        self._check()
        os.makedirs(self.folder, exist_ok=True)
        with self._alone():
            return self._runAll(jobs or len(os.sched_getaffinity(0)))

    @contextlib.contextmanager
    def _alone(self):
        """Two studies in one folder would spoil each other's runs: the second is an error. The
        lock ends with the process that has it, however that ends; the file stays."""
        with open(os.path.join(self.folder, LOCK), "a") as f:
            try:
                fcntl.flock(f, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                raise RunFailed(
                    f"another study is running in {os.path.abspath(self.folder)}: wait until it "
                    "has ended, or take another folder, Study(..., folder=...)") from None
            except OSError:         # a file system without locks
                pass
            yield

    def _runAll(self, jobs):
        print(f"{_runs(len(self.points))} in {self.folder}, {jobs} at a time", flush=True)
        with ThreadPoolExecutor(jobs) as pool:
            waiting = [pool.submit(self._row, i) for i in range(len(self.points))]
            try:
                rows = [w.result() for w in waiting]
            except BaseException:
                self._stopped.set()     # what has been interrupted has not ended well
                for w in waiting:
                    w.cancel()
                raise
        results = Results(rows, list(self.parameters), list(self.quantities), self._units(rows))
        if results.failed:
            print(results.summary(), flush=True)
        return results

    def _units(self, rows):
        """Units of entries, by doc/entries.md, and of quantities, by a run that has not failed:
        {column: unit}, of those that are known."""
        base, meanings, found = Case(self.base), Meanings(), {}
        for name, parameter in self.parameters.items():
            # What a dictionary shows may have another unit than the entry
            if parameter.entry and all(_key(v) == shown for shown, v in parameter.values.items()):
                file, path = parameter.entry
                data = readDictionary(base, file)
                # A short path is that of one entry
                names = r"\.(?:.*\.)?".join(map(re.escape, path.split(".")))
                whole = [p for p in flat(data) if re.fullmatch(r"(?:.*\.)?" + names, p)]
                if whole:
                    path = path if path in whole else whole[0]
                    found[name] = meanings.find(file, path, data)[0]
        ran = [p for p, row in zip(self.points, rows) if not row["state"].startswith("failed")]
        for name, quantity in self.quantities.items():
            if ran and hasattr(quantity, "unit"):
                try:
                    found[name] = quantity.unit(self.case(**ran[0]))
                except RunFailed:       # state has said so
                    pass
        return {name: unit for name, unit in found.items() if unit}

    def _check(self):
        """Before anything runs: has the case a mesh, and what the quantities need? Functions
        of the user may make it in the copies."""
        if self.steps or not all(p.entry for p in self.parameters.values()):
            return
        base = Case(self.base)
        base.needMesh()
        for name, quantity in self.quantities.items():
            need = getattr(quantity, "need", None)
            wrong = need and need(base, [p.entry for p in self.parameters.values()])
            if wrong:
                raise ValueError(f"quantity {name}: {wrong}")

    def _row(self, i):
        """One row of the table."""
        point = self.points[i]
        case = Case(os.path.join(os.path.abspath(self.folder), self._name(point)))
        case.limit = self.limit
        row = {**point, **dict.fromkeys(self.quantities, np.nan), "state": "ran"}
        try:
            start = time.monotonic()
            row["state"] = "kept" if self._start(case, point) else "ran"
            if row["state"] == "ran":
                with self._watched(case):
                    self._run(case)
            said = f"{row['state']}, {time.monotonic() - start:.0f} s"
            wrong = self._read(case, row)
            if wrong:
                row["state"] = said = "; ".join([row["state"], *wrong])
        except Exception as error:      # of any function of a user: a row, not the end
            what = "" if isinstance(error, RunFailed) else type(error).__name__ + ": "
            said = (what + str(error)).replace(os.path.abspath(self.folder), self.folder)
            said += _warned(case)
            row["state"] = said = "failed: " + " ".join(said.split())
        print(f"{i + 1}/{len(self.points)} {self._name(point)}: {said}", flush=True)
        if "; quantity " in said:
            self._hint()
        return row

    def _hint(self, *before):
        """What to do about a quantity that fails, once."""
        if len(self.points) > 1 and self._hinted.acquire(blocking=False):
            print(*before, "If that is so of all runs: Ctrl-C, mend the quantity, start again; "
                  "runs that have ended are kept", sep="\n", flush=True)

    @contextlib.contextmanager
    def _watched(self, case):
        """While a run goes on: a column that its table has not is said as soon as the table is
        there, not when the run has ended."""
        ended = threading.Event()
        quantities = {n: q for n, q in self.quantities.items() if hasattr(q, "nameIn")}
        watch = threading.Thread(target=self._watch, args=(case, quantities, ended), daemon=True)
        watch.start()
        try:
            yield
        finally:
            ended.set()
            watch.join()

    def _watch(self, case, waiting, ended):
        while waiting and not self._hinted.locked() and not ended.wait(WATCH):
            for name, quantity in list(waiting.items()):
                try:
                    table = case.table(quantity.table)
                except Exception:       # not there, without rows, half a line
                    continue
                del waiting[name]
                try:
                    table[quantity.nameIn(table)]
                except RunFailed as error:
                    self._hint(f"{os.path.basename(case.path)}: quantity {name}: {error}")

    def _read(self, case, row):
        """The quantities into a row, nan of those that fail; what these say."""
        wrong = []
        for name, quantity in self.quantities.items():
            try:
                row[name] = quantity(case)
            except Exception as error:  # of any function of a user: a column, not the run
                what = "" if isinstance(error, RunFailed) else type(error).__name__ + ": "
                wrong.append(f"quantity {name}: " + " ".join(f"{what}{error}".split()))
        return wrong

    def _start(self, case, point):
        """Make the case with its values. True: it has ended well with these files before."""
        new = Case(case.path + ".new")
        new.copy(source=self.base)
        for name, value in point.items():
            self.parameters[name].apply(new, value)
        digest = self._digest(new)
        try:
            with open(case.file(RECORD)) as f:
                same = json.load(f) == digest
        except (OSError, ValueError):
            same = False
        if same:
            shutil.rmtree(new.path)
            return True
        shutil.rmtree(case.path, ignore_errors=True)
        os.rename(new.path, case.path)
        case.digest = digest
        return False

    def _digest(self, case):
        """Of all files of a case before it runs, of its steps, and of the build that runs it."""
        made = hashlib.sha256()
        for folder in ("FOAM_USER_APPBIN", "FOAM_USER_LIBBIN"):
            if os.path.isdir(os.environ.get(folder, "")):
                for entry in sorted(os.scandir(os.environ[folder]), key=lambda e: e.name):
                    made.update(f"{entry.name} {entry.stat().st_mtime_ns}".encode())
        if self.steps:
            try:
                made.update(inspect.getsource(self.steps).encode())
            except OSError:             # typed in, not in a file
                pass
        for root, folders, names in os.walk(case.path):
            folders.sort()
            for name in sorted(n for n in names if not n.startswith("log.")):
                path = os.path.join(root, name)
                made.update(os.path.relpath(path, case.path).encode())
                with open(path, "rb") as f:
                    made.update(f.read())
        return made.hexdigest()

    def _run(self, case):
        if self._stopped.is_set():
            raise RunFailed("interrupted")
        if self.steps:
            self.steps(case)
        else:
            case.prepare()
            case.run("materialPointFoam")
        log = case.file("log.materialPointFoam")
        signal = os.path.exists(log) and re.search(r"^Signal .* was received", case.log(), re.M)
        if self._stopped.is_set() or signal:
            raise RunFailed(signal[0] if signal else "interrupted")
        with open(case.file(RECORD), "w") as f:
            json.dump(case.digest, f)


def _warned(case):
    """The logs of a run that failed with warnings, which may tell the cause."""
    logs = []
    for path in sorted(glob.glob(case.file("log.*"))):
        with open(path, errors="replace") as f:
            if re.search(r"^--> FOAM (IO)?Warning", f.read(), re.M):
                logs.append(os.path.basename(path))
    return f"; warnings in {', '.join(logs)} may tell the cause" if logs else ""


class _Parameter:
    """Values of one name, and where they go."""

    def __init__(self, name, *spec):
        self.entry = None
        if len(spec) == 2 and callable(spec[0]):
            self.function, values = spec
        elif len(spec) == 3:
            *self.entry, values = spec
            self.function = self._set
        else:
            raise ValueError(f"parameter {name}: (file, entry, values) or (function, values)")
        self.values = values if isinstance(values, dict) else {_key(v): v for v in values}
        if not self.values:
            raise ValueError(f"parameter {name} has no values")

    def check(self, base):
        """Before anything runs: an entry that is not there is an error (DictionaryError)."""
        if self.entry:
            base.get(*self.entry)

    def _set(self, case, value):
        try:
            case.set(*self.entry, value)
        except DictionaryError:
            # Of a file that is included: an entry behind it counts
            case.set(*self.entry, value, add=True)

    def apply(self, case, shown):
        self.function(case, self.values[shown])


def _key(value):
    """A value as the table shows it."""
    if isinstance(value, np.generic):
        return value.item()
    return value if isinstance(value, (int, float, str, bool)) else foamText(value)


def _runs(n):
    return "1 run" if n == 1 else f"{n} runs"


def _text(value):
    return f"{value:.6g}" if isinstance(value, (float, np.floating)) else str(value)


class Results:
    """The rows of a study: table["strain"], write, plot; print(table) shows it."""

    def __init__(self, rows, parameters, quantities, units=None):
        self.rows, self.parameters, self.quantities = rows, parameters, quantities
        self.units = units or {}
        self.columns = [*parameters, *quantities, "state"]
        self.failed = [row for row in rows if row["state"].startswith("failed")]

    def summary(self):
        """How many runs failed, and what the first of them said."""
        first = self.failed[0]
        values = ", ".join(f"{p} {_text(first[p])}" for p in self.parameters)
        return f"{len(self.failed)} of {len(self.rows)} failed, the first: " \
            + (values and values + ": ") + first["state"]

    def __getitem__(self, name):
        """A column as an array."""
        if name not in self.columns:
            raise KeyError(f"no column {name}; there are: {', '.join(self.columns)}")
        return np.array([row[name] for row in self.rows])

    def __str__(self):
        """The table in Markdown."""
        lines = [self.columns, ["---"]*len(self.columns)] + [
            [_text(row[c]).replace("|", "\\|") for c in self.columns] for row in self.rows]
        return "\n".join("| " + " | ".join(line) + " |" for line in lines)

    def write(self, name):
        """<name>.csv and <name>.md. If all runs failed an error is raised when they are there."""
        with open(name + ".csv", "w", newline="") as f:
            writer = csv.writer(f)
            writer.writerow(self.columns)
            writer.writerows([row[c] for c in self.columns] for row in self.rows)
        with open(name + ".md", "w") as f:
            f.write(str(self) + "\n")
        if len(self.failed) == len(self.rows):
            raise RunFailed(self.summary())

    def plot(self, x, y, by=None, file=None, log="", xlabel=None, ylabel=None):
        """y over x, a line for each value of another column; to a file by its ending. log: axes
        with logarithms, "x", "y", "xy". The figure and its axes. Without a value an error."""
        from mpm.pictures import plt, save
        if self[y].dtype.kind in "fi" and not np.isfinite(self[y]).any():
            raise RunFailed(f"no value of {y}, no picture: " + (
                self.summary() if self.failed else self.rows[0]["state"]))
        figure, ax = plt.subplots(figsize=(5, 3.5))
        lines = {}
        for xi, yi, key in zip(self[x], self[y], self[by] if by else [""]*len(self.rows)):
            lines.setdefault(key, []).append((xi, yi))
        for key, line in lines.items():
            if self[x].dtype.kind in "if":
                line = sorted(line)
            unit = " " + self.units[by] if by in self.units else ""
            ax.plot(*zip(*line), "o-", ms=4, label=f"{by} {_text(key)}{unit}" if by else None)
        names = [f"{n} [{self.units[n]}]" if n in self.units else n for n in (x, y)]
        ax.set(xlabel=xlabel or names[0], ylabel=ylabel or names[1],
               **{f"{a}scale": "log" for a in log})
        ax.grid(alpha=0.3)
        if by:
            ax.legend()
        if file and file.endswith(".png"):
            save(figure, file)
        elif file:
            figure.savefig(file)
        plt.close(figure)
        return figure, ax


# --- quantities --------------------------------------------------------------

def last(table, column, place=None):
    """The last value of a column of a table (Case.table). The name may be a pattern of one
    column, "displacement_x*"; of several with place: the first, 1, and so on as they stand in
    the table, where names carry ids of points that differ between meshes."""
    return _ofTable(table, lambda t, v: float(v[-1]), column, place)


def largest(table, column, place=None):
    return _ofTable(table, lambda t, v: float(np.max(v)), column, place)


def least(table, column, place=None):
    return _ofTable(table, lambda t, v: float(np.min(v)), column, place)


def period(table, column, about=0.0, place=None):
    """Mean period [s] of a column that swings about a value: from its crossings, straight
    between two rows."""
    def of(t, v):
        v = v - about
        i = np.nonzero(v[:-1]*v[1:] < 0)[0]
        if len(i) < 2:
            raise RunFailed(f"{column} of {table} crosses {about} only {len(i)} times: no period")
        zero = t[i] - v[i]*(t[i + 1] - t[i])/(v[i + 1] - v[i])
        return float(2*(zero[-1] - zero[0])/(len(zero) - 1))
    quantity = _ofTable(table, of, column, place)
    quantity.unit = lambda case: "s"
    return quantity


def _ofTable(table, number, column, place):
    """A quantity, number(times, values), with what it needs: the function object that writes the
    table. need(case, entries that the study sets) says what the case lacks; unit(case) is that
    of the column, nameIn(columns) its name."""
    def quantity(case):
        columns = case.table(table)
        return number(next(iter(columns.values())), columns[quantity.nameIn(columns)])

    def need(case, entries):
        name = table.split("/")[0]
        functions = case.get("system/controlDict").get("functions") or {}
        if name in functions or any("functions" in entry for _, entry in entries):
            return ""
        return (f"no function object {name} in {case.file('system/controlDict')} to write the"
                f" table {table}; there are: {' '.join(functions) or 'none'}")

    def unit(case):
        # As the table says, or of the field whose name it has (blastProbes: p.dat)
        columns = case.table(table)
        field = os.path.splitext(os.path.basename(columns.path))[0]
        return columns.units.get(quantity.nameIn(columns)) or UNITS.get(field, "")

    quantity.need, quantity.unit, quantity.table = need, unit, table
    quantity.nameIn = lambda columns: _nameOf(columns, column, place)
    return quantity


def _nameOf(columns, column, place):
    """The name of a column by a pattern (*, ?) that only one matches, the one at a place of those
    that match, or as it is."""
    names = [n for n in columns if fnmatch.fnmatchcase(n, column)]
    if column in columns or not names:
        return column                   # an error lists those that are
    if place is not None and place not in range(1, len(names) + 1):
        raise RunFailed(f"place {place} of {column} in {columns.path}: "
                        + ", ".join(f"{k} is {n}" for k, n in enumerate(names, 1)))
    if place is None and len(names) > 1:
        raise RunFailed(f"{column} of {columns.path} is each of {', '.join(names)}; with place=1 "
                        "the first, and so on")
    return names[(place or 1) - 1]


def energyResidual(case):
    """Case.energyResidual, from the log; with energyBudget yes in materialPoints."""
    found = case.energyResidual()
    if found is None:
        raise RunFailed("no energy budget in the log: " + BUDGET)
    return found


def _needBudget(case, entries):
    points = case.get("system/fvSolution").get("materialPoints") or {}
    if points.get("energyBudget") or any("energyBudget" in entry for _, entry in entries):
        return ""
    return f"energyResidual needs the energy budget, and {case.path} has none: {BUDGET}"


energyResidual.need = _needBudget


def steps(case):
    """Time steps of the run."""
    return case.nSteps()


def seconds(case):
    """Seconds of one core of its time steps."""
    return case.solverSeconds()


seconds.unit = lambda case: "s"
