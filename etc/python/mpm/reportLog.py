"""What materialPointFoam wrote into its logs, for mpm.report.

    runs = readRuns(case)           # starts of the solver in the order of their times
    history = History(runs)         # all of them as one: history.series("Energy", "kinetic")

A report of the log is a row: values by (head, name), as ("Energy", "kinetic") of the line
"Energy: kinetic 1, strain 2". Units are those of the log, SI.
"""

import os
import re
import socket
import time

import numpy as np

SOLVER = "materialPointFoam"
_NUMBER = re.compile(r"(?<![\w.])([-+]?(?:\d+\.?\d*(?:e[-+]?\d+)?|nan|inf))(?![\w.])")
_BROUGHT = re.compile(r"\(energy (\S+) added, mass (\S+) held back.*?\)")
_LEFT = re.compile(r"about ([\d.]+) (min\w*|h|hours?|days?) left")
_RANK = re.compile(r"\[\d+\] ?")
#: Seconds of the units of the time left
SECONDS = {"m": 60, "h": 3600, "d": 86400}
#: Seconds without a line after which a run whose process is not seen counts as stopped
QUIET = 60


class Message:
    """A warning or an error: text, and the line of the log where it begins."""

    def __init__(self, kind, log, line):
        self.kind, self.log, self.line, self.lines = kind, log, line, []

    @property
    def text(self):
        return "\n".join(line.strip() for line in self.lines).strip()


class Run:
    """One start of the solver."""

    def __init__(self, log, line):
        self.log, self.line = log, line
        self.header, self.head, self.rows = {}, [], []
        self.messages, self.parts, self.steps, self.ended = [], "", None, False
        self.signal = ""        # what the log says of one that ended the run
        self.version, self.loads = "", []

    def when(self):
        """Seconds since 1970 of its start, in local time; of a damaged header 0."""
        words = f"{self.header.get('Date', '')} {self.header.get('Time', '')}"
        try:
            return time.mktime(time.strptime(words, "%b %d %Y %H:%M:%S"))
        except ValueError:
            return 0.0

    def alive(self):
        """Is its process on this machine still there?"""
        pid = self.header.get("PID", "")
        if self.header.get("Host", "") != socket.gethostname().split(".")[0] \
                or not pid.isdigit():
            return False
        try:
            with open(f"/proc/{pid}/cmdline", "rb") as f:
                return SOLVER.encode() in f.read()
        except OSError:
            return False

    def state(self):
        """"done", "failed", "running" or "stopped" (by a signal, or its log has no end)."""
        if self.ended:
            return "stopped" if self.signal else "done"
        if any(m.kind == "error" for m in self.messages):
            return "failed"
        if self.alive() or time.time() - os.path.getmtime(self.log) < QUIET:
            return "running"
        return "stopped"


def names(texts):
    """Names of the numbers between texts, of a line behind its head: (name, first, count),
    count 3 for a vector. A number without a name of its own has that of the head ("") if it
    is the first; of "p 1 to 2" the second is "p to"."""
    found, name, first = [], "", 0
    for i, text in enumerate(texts[:-1]):
        if text == " " and i and first < i:         # within a vector
            continue
        vector = text.endswith("(") and texts[i + 1] == " "
        words = text[:-1] if vector else text
        if not found or re.search("[,(:]", words):
            name = re.split("[,(:]", words)[-1].strip(" =")
        elif words.strip():
            name = f"{name.split()[0]} {words.strip()}" if name else words.strip()
        else:
            name = ""
        count = 1
        while vector and texts[i + count] == " ":
            count += 1
        first = i + count - 1
        if name or not found:
            found.append((name, i, count))
    return found


def heads(line, last):
    """Head and rest of a line of a report; indented ones belong to the head of the last."""
    rest = line.strip()
    match = re.match(r"([A-Za-z][^:=,]*?)(?::| =) ", rest)
    if not line.startswith("    "):
        return (match[1], rest[match.end():]) if match else ("", "")
    if match:
        return f"{last.split(',')[0]}, {match[1]}", rest[match.end():]
    for what in ("gas", "fluids"):
        if rest.startswith(what + " ") and last.startswith("Energy budget"):
            return f"Energy budget, {what}", rest[len(what):]
    return last.split(",")[0], rest


class _Reader:
    """Lines of one log, one after the other."""

    def __init__(self, path):
        self.path, self.runs = path, []
        self.row, self.last, self.message, self.part = {}, "", None, "header"
        self.known, self.fluids = {}, False

    def read(self):
        with open(self.path, errors="replace") as f:
            for number, line in enumerate(f, 1):
                self.line(number, _RANK.sub("", line.rstrip(), count=1)
                          if line.startswith("[") else line.rstrip())
        self.store()
        # Of another program
        return [run for run in self.runs if run.header.get("Exec", SOLVER).startswith(SOLVER)
                and "-postProcess" not in run.header.get("Exec", "")]

    def line(self, number, line):
        if line.startswith("Build  :"):
            self.store()
            self.message = None
            self.runs.append(Run(self.path, number))
            self.part, self.fluids = "header", False
        if not self.runs:
            return
        run = self.runs[-1]
        if self.inMessage(number, line, run):
            return
        if self.part == "header":
            match = re.match(r"(\w+) *: (.*)", line)
            if match:
                run.header[match[1]] = match[2].strip('" ')
            elif line.startswith(SOLVER):
                run.version, self.part = line, "head"
        elif self.part == "head":
            if line == "Starting time loop":
                self.part = "steps"
            elif line and not line.startswith("Create "):
                run.head.append(line)
                self.fluids = self.fluids or line.startswith("Fluids with")
        else:
            self.report(line, run)

    def inMessage(self, number, line, run):
        """Warnings: all lines of theirs are indented, or it is one line (OpenFOAM's of a function
        object); errors end before "From"."""
        if line.startswith("--> FOAM "):
            kind = "error" if "FATAL" in line else "warning"
            self.message = Message(kind, self.path, number)
            run.messages.append(self.message)
            rest = line.split(":", 1)[-1].strip()
            if rest and not rest.startswith("(openfoam"):
                self.message.lines.append(rest)
            return True
        if self.message is None:
            return False
        of, where = self.message, re.match(r"\s*(From |in file )", line)
        if of.kind == "error":
            if where or line.startswith("FOAM ") or len(of.lines) > 40:
                self.message = None
            else:
                of.lines.append(line)
            return True
        if where or line.startswith("    ") or not of.lines:
            if line and not where:
                of.lines.append(line)
            return True
        self.message = None
        return False

    def report(self, line, run):
        if self.fluids:         # the log has one word for both
            line = re.sub(r"\bthe gas\b|^    gas\b", lambda m: m[0].replace("gas", "fluids"), line)
        if line.startswith("Courant Number mean"):
            self.store()
        if line.startswith("Parts of the steps"):
            run.parts = re.sub(r"\bgas\b", "fluids", line) if self.fluids else line
        elif line.startswith("Load: "):
            run.loads.append(line[6:])
        elif line.startswith("Steps: "):
            run.steps = int(line.split()[1])
        elif re.match("Signal .* was received", line):
            run.signal = line
        elif line == "End":
            run.ended = True
        elif line.startswith("deltaT set by "):
            self.row["deltaT set by", ""] = line[14:]
        else:
            self.values(line)

    def values(self, line):
        """Numbers of a line; of lines with the same words the names are found once."""
        line = line.replace("where theta > 0.5: p", "where gas: p")
        line = _BROUGHT.sub(r", energy added \1, mass held back \2", line)
        line = _LEFT.sub(lambda m: f"about {float(m[1])*SECONDS[m[2][0]]:g} s left", line)
        parts = _NUMBER.split(line)
        key = self.last, *parts[::2]
        if key not in self.known:
            head, _ = heads(line, self.last)
            start = len(line) - len(heads(line, self.last)[1])
            # Numbers of the head, as of a phase "layer 2", are no values
            skip = len(_NUMBER.split(line[:start]))//2
            rest = _NUMBER.split(line[start:])[::2]
            self.known[key] = head, [] if not head else [
                (name, skip + first, count) for name, first, count in names(rest)]
        head, found = self.known[key]
        if not head:
            return
        self.last = head
        for name, first, count in found:
            numbers = [float(v) for v in parts[2*first + 1:2*(first + count):2]]
            self.row.setdefault((head, name), numbers if count > 1 else numbers[0])

    def store(self):
        if self.runs and ("Time", "") in self.row and ("Progress", "") in self.row:
            self.runs[-1].rows.append(self.row)
        self.row = {}


def logs(case):
    """Files of the case's folder that begin as a log of the solver."""
    found = []
    for entry in os.scandir(case.path):
        if entry.is_file() and re.search(r"(?i)log|out|\.txt$|nohup", entry.name):
            with open(entry.path, errors="replace") as f:
                if re.search(rf"^Exec   : {SOLVER}\b(?!.*-postProcess)", f.read(20000), flags=re.M):
                    found.append(entry.path)
    return sorted(found)


def readRuns(case, paths=None):
    """Runs of all logs, those left out of which nothing is seen any more: a later one began
    at their start or before."""
    runs = sorted((run for path in paths or logs(case) for run in _Reader(path).read()),
                  key=lambda run: (run.when(), run.log, run.line))
    kept = []
    for run in runs:
        start = run.rows[0]["Time", ""] if run.rows else np.inf
        if run.rows:
            kept = [r for r in kept if r.rows and r.rows[0]["Time", ""] < start]
        kept.append(run)
    # A try that ended before its first step, with a later one
    return [run for run in kept[:-1] if run.rows] + kept[-1:]


class History:
    """The rows of all runs, a later run's in place of those from its start on."""

    def __init__(self, runs):
        self.runs, self.rows, self.of = runs, [], []
        for run in runs:
            start = run.rows[0]["Time", ""] if run.rows else np.inf
            keep = [i for i, row in enumerate(self.rows) if row["Time", ""] < start]
            self.rows = [self.rows[i] for i in keep] + run.rows
            self.of = [self.of[i] for i in keep] + [run]*len(run.rows)
        keys = {}
        for row in self.rows:
            keys.update(dict.fromkeys(row))
        self.keys = list(keys)
        self.times = np.array([row["Time", ""] for row in self.rows])

    def heads(self, pattern):
        return list(dict.fromkeys(h for h, _ in self.keys if re.fullmatch(pattern, h)))

    def names(self, head):
        return [n for h, n in self.keys if h == head]

    def series(self, head, name=""):
        """Values at self.times, nan where a report has none."""
        return np.array([row.get((head, name), np.nan) for row in self.rows], float)

    def vectors(self, head, name):
        return np.array([row.get((head, name), [np.nan]*3) for row in self.rows], float)

    def isVector(self, head, name):
        return any(isinstance(row.get((head, name)), list) for row in self.rows)

    def limiters(self):
        """Who set the time step: (words, reports, smallest step, the last one's words)."""
        found = {}
        for row in self.rows:
            said = row.get(("deltaT set by", ""))
            if not said:
                continue
            who = re.sub(r"point \d+ of", "points of", re.split("[:;]", said)[0])
            old = found.get(who, (0, np.inf, ""))
            found[who] = old[0] + 1, min(old[1], row.get(("deltaT", ""), np.inf)), said
        return sorted(((who, *v) for who, v in found.items()), key=lambda v: -v[1])

    def size(self):
        """Points, and cells of a gas or fluids, of each row; nan where the log has none."""
        points = self.series("Material points") if self.heads("Material points") \
            else np.full(len(self.rows), np.nan)
        cells = np.nan
        for line in self.runs[-1].head if self.runs else ():
            match = re.match(r"(?:Gas|Fluids).* (\d+) cells", line)
            cells = float(match[1]) if match else cells
        changed = self.series("Adaptive mesh") if self.heads("Adaptive mesh") else None
        return points, cells if changed is None else np.where(
            np.isnan(changed), cells, changed)

    def rate(self):
        """Steps per second of CPU time at each report, over the last fortieth of the run's
        time (which has two digits), and the mean over all runs."""
        step, cpu = self.series("Progress", "step"), self.series("ExecutionTime")
        rate, steps, seconds = np.full(len(step), np.nan), 0.0, 0.0
        for run in self.runs:
            some = np.array([i for i, r in enumerate(self.of) if r is run], int)
            if len(some) < 2:
                continue
            n, s = step[some], cpu[some]
            steps, seconds = steps + n[-1] - n[0], seconds + s[-1] - s[0]
            window = max(0.2, (s[-1] - s[0])/40)
            before = np.searchsorted(s, s - window, side="right") - 1
            known = before >= 0
            rate[some[known]] = (n[known] - n[before[known]])/(s[known] - s[before[known]])
        return rate, steps/seconds if seconds > 0 else np.nan
