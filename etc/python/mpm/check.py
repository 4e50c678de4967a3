"""mpmCheck: what a case will be, and what is probably wrong with it, before it runs.

    mpmCheck [case] [-n ranks] [-noTrial] [-steps N]

It works on a copy: mesh and points are made if the case has none that are newer than their
dictionaries, the solver reads all (-dry-run), a few steps are run. What the programs warn of and
what the rules of mpm.checkRules find is told with file, entry, remedy and page of the guide.

Exit code: 0 nothing found (notes do not count), 1 warnings, 2 it does not start.
"""

import argparse
import os
import re
import shutil
import sys
import tempfile

import numpy as np

from mpm import checkFluids, checkPatches, checkRules
from mpm.case import Case, RunFailed
from mpm.checkFacts import CONTROL, Facts
from mpm.checkFinding import Finding
from mpm.dictionaries import DictionaryError
from mpm.reportCase import Meanings, readDictionary
from mpm.trial import Trial

#: Files beside the dictionaries, which they may read, up to this size [bytes]
LARGEST = 5e7

_FATAL = re.compile(r"--> FOAM FATAL (?:IO )?ERROR[^\n]*\n(.*?)(?=\n\s*From |\nFOAM |\Z)", re.S)
_WARNING = re.compile(r"--> FOAM (?:IO)?Warning[^\n]*\n((?:    [^\n]*\n?)+"
                      r"(?:Valid names[^\n]*\n)?)")
#: OpenFOAM's of a function object, which is not indented
_UNKNOWN = re.compile(r"--> FOAM Warning *:? *\n(Unknown function type .*?\n\))", re.S)


class Check:
    """The check of one case. findings and lines (what the run will be) after run()."""

    def __init__(self, path, ranks=1, trial=True, steps=None):
        self.path, self.ranks, self.withTrial, self.nSteps = path, ranks, trial, steps
        self.findings, self.lines, self.trial = [], [], None

    def run(self):
        """All of it; the exit code."""
        if "WM_PROJECT_DIR" not in os.environ:
            self._find("error", "", "", "the settings of OpenFOAM are missing in this shell",
                       "source etc/bashrc of materialPointFoam", "README.md#install-and-build")
            return 2
        lacking = [n for n in ("system/controlDict", "constant")
                   if not os.path.exists(os.path.join(self.path, n))]
        if lacking:
            self._find("error", "", "", f"{self.path} is no case: it has no {lacking[0]}",
                       "run mpmCheck in a case, or name one: etc/caseTemplate is the smallest")
            return 2
        with tempfile.TemporaryDirectory(prefix="mpmCheck") as folder:
            self.case = Case(os.path.join(os.path.realpath(folder),
                                          os.path.basename(os.path.abspath(self.path))))
            try:
                self._check()
            except RunFailed:
                pass            # told where it failed
            except DictionaryError as error:
                self._find("error", "", "", self._own(str(error)), "")
        kinds = {f.kind for f in self.findings}
        return 2 if "error" in kinds else 1 if "warning" in kinds else 0

    def _check(self):
        self._copy()
        try:
            self._make()
            self._program("materialPointFoam", "-dry-run")
        finally:
            self._allrun()
        facts = Facts(self.case, self.path)
        for finding in self.findings:
            checkFluids.nameFluid(finding, facts, self._log("setMaterialPoints"))
        self._tell(facts)
        try:
            if self.withTrial:
                self._try()
        finally:                # what the trial stumbled on, too
            facts.trial = self.trial
            self.findings += [f for f in checkRules.findings(facts) if not self._known(f)]

    def _known(self, finding):
        """Has a program warned of the same entry's dictionary or phase already?"""
        return bool(finding.unless) and any(
            re.search(finding.unless, f.text) for f in self.findings)

    # --- the copy -------------------------------------------------------------

    def _newer(self, made, *dictionaries):
        """Is what was made there, and newer than its dictionaries?"""
        def age(name):
            path = os.path.join(self.path, name)
            return os.path.getmtime(path) if os.path.exists(path) else None
        made = age(made)
        return made is not None and all(
            t is None or t <= made for t in map(age, dictionaries))

    def _copy(self):
        """The case without its results; mesh, points and fields as they are where they are
        there and newer than their dictionaries."""
        mesh = "constant/polyMesh/faces"
        mesh += ".gz" if os.path.exists(os.path.join(self.path, mesh + ".gz")) else ""
        dictionary = "system/blockMeshDict"
        self.hasMesh = self._newer(mesh, dictionary)
        self.case.copy(source=self.path, mesh=self.hasMesh)
        fields = os.path.join(self.path, "0")
        self.hasPoints = self.hasMesh and any(
            self._newer(os.path.join("0/lagrangian", name, "id"), mesh,
                        "system/setMaterialPointsDict", "constant/phaseProperties")
            for name in (os.listdir(os.path.join(fields, "lagrangian"))
                         if os.path.isdir(os.path.join(fields, "lagrangian")) else ()))
        if self.hasPoints:      # with the fields that belong to them
            shutil.copytree(fields, self.case.file("0"), dirs_exist_ok=True)
        for name in os.listdir(self.path):
            path = os.path.join(self.path, name)
            if os.path.isfile(path) and os.path.getsize(path) < LARGEST \
                    and not name.startswith("log."):
                shutil.copy(path, self.case.path)

    def _make(self):
        case = self.case
        if not self.hasMesh:
            if not os.path.exists(case.file("system/blockMeshDict")):
                self._find("error", "constant/polyMesh", "", "there is no mesh, and no "
                           "system/blockMeshDict to make one from", "make the mesh first (what "
                           "the Allrun of the case does before materialPointFoam)", "meshes.md")
                raise RunFailed
            self._program("blockMesh")
            if os.path.exists(case.file("system/adaptiveMeshDict")):
                self._program("adaptMesh")
        self._patches()
        if self.hasPoints:
            try:
                case.run("setMaterialPoints", "-count")     # its table of bodies
                self._readLog("setMaterialPoints")
            except RunFailed:
                pass
            return
        for name in self._fieldsFirst():
            if os.path.exists(case.file(f"system/{name}Dict")):
                self._program(name, *(
                    ["-cellWeights"] if name == "setMaterialPoints" and self.ranks > 1 else []))

    def _fieldsFirst(self):
        """Programs of the start: setMaterialPoints compares stresses with p, whoever wrote it;
        setFields before setFluids where the Allrun has them so."""
        path, text = os.path.join(self.path, "Allrun"), ""
        if os.path.exists(path):
            with open(path, errors="replace") as f:
                text = f.read()
        own = re.findall(r"^ *(?:runApplication +)?(setFields|setFluids)\b", text, re.M)
        first = ["setFields", "setFluids"] if own[:2] == ["setFields", "setFluids"] else [
            "setFluids", "setFields"]
        return [*first, "setMaterialPoints"]

    def _patches(self):
        """Names of patches, before programs stop at the first."""
        own = os.path.isdir(os.path.join(self.path, "0.orig")) and not self.hasPoints
        self.findings += checkPatches.names(self.case, "0.orig" if own else "0")
        if any(f.kind == "error" for f in self.findings):
            raise RunFailed

    def _allrun(self):
        """Its own commands are not known here."""
        path = os.path.join(self.path, "Allrun")
        if not os.path.exists(path):
            path = os.path.join(self.path, "..", "Allrun")
        if self.hasPoints or not os.path.exists(path):
            return
        with open(path, errors="replace") as f:
            text = f.read()
        own = [w for w in ("startValues", "makeMesh") if re.search(rf"^ *{w} *\(\)", text, re.M)
               and not (w == "makeMesh" and self.hasMesh)]
        if re.search(r"startValues\(\) \{ runApplication setFields; \}", text):
            own.remove("startValues")       # mpmCheck runs it
        if "\nrunCase" in text:
            own += re.findall(r"^\"\$MPM_PYTHON\" (\w+\.py)", text.split("\nrunCase")[0], re.M)
        if own:
            self._find("note", "Allrun", "", f"it has steps of its own before the run "
                       f"({', '.join(own)}), which mpmCheck does not know: what it tells may be "
                       "of another mesh or start", "run mpmCheck when mesh and points are made")

    # --- programs -------------------------------------------------------------

    def _program(self, name, *options):
        """Run a program; what it warns of and its error are findings."""
        self._say(" ".join((name, *options)))
        try:
            self.case.run(name, *options)
        except RunFailed:
            self._readLog(name)
            self._fatal(name, " ".join((name, *options)))
            raise
        except FileNotFoundError:
            self._find("error", "", "", f"there is no program {name}",
                       "source etc/bashrc, build with Allwmake", "README.md#install-and-build")
            raise RunFailed from None
        self._readLog(name)

    def _say(self, text):
        """Who waits sees at what."""
        if sys.stderr.isatty():
            print(f"mpmCheck: {text} ...", file=sys.stderr, flush=True)

    def _own(self, text):
        return text.replace(self.case.path + "/", "")

    def _readLog(self, name):
        log = self.case.log(name)
        for text in _WARNING.findall(log):
            self._warning(name, self._own(text))
        for text in sorted(set(_UNKNOWN.findall(log))):
            said = checkPatches.nearestFirst(text).split(". Of ")[0] + f" ({name})"
            if not any(f.text == said for f in self.findings):
                self._find("warning", CONTROL, "functions", said, "a type that is in its libs, of "
                           "this version of OpenFOAM: the run goes on without it",
                           "output.md#function-objects")

    def _warning(self, name, text):
        text = re.sub(r"^ *(From .*|in file .*)\n", "", text, flags=re.M)
        place = re.match(r'\s*Reading "([^"]*?)"[^\n]*\n', text)
        file, entry = _place(place[1]) if place else _named(text)
        file = file or ("system/setFieldsDict" if name == "setFields" else
                        CONTROL if "Could not load" in text else "")
        text = " ".join((text[place.end():] if place else text).split())
        if "Increased the timePrecision" in text:       # of the trial's own times
            return
        # Of boxes that are as deep as in 2D
        if "reaches beyond the mesh" in text and any(
                "is one layer of cells thick" in f.text for f in self.findings):
            return
        if not any(f.text.startswith(text) for f in self.findings):
            self._find("warning", file, entry, f"{text} ({name})", *_remedy(text))

    def _fatal(self, name, command):
        """The error of a program in its own words."""
        text = self._own(self.case.log(name))
        found = _FATAL.search(text)
        message = found[1].strip() if found else text[-400:].strip()
        place = re.search(r"^file: (\S+)(?:.*?\b(at line \d+|from line \d+ to line \d+))?", message,
                          re.M)
        file, entry = _place(place[1]) if place else ("", "")
        message = re.sub(r"\n*^file: .*", "", message, flags=re.M).strip()
        message = checkPatches.nearestFirst(message)
        remedy, page = _remedy(message)
        lacks = re.match(r"Entry (\w+) is missing", message)
        if lacks and file and os.path.exists(self.case.file(file)):
            unit, meaning = Meanings().find(file, f"{entry}.{lacks[1]}".lstrip("."),
                                         readDictionary(self.case, file))
            if meaning:
                remedy = f"{lacks[1]}{f' [{unit}]' if unit else ''}: {meaning}; see doc/entries.md"
        where = f" {place[2]}" if place and place[2] else ""
        self._find("error", file, entry, f"{command} stops{where}: {message}", remedy, page)

    def _find(self, kind, file, entry, text, remedy, page=""):
        self.findings.append(Finding(kind, file, entry, text, remedy, page))

    # --- what it will be ------------------------------------------------------

    def _tell(self, facts):
        size = " x ".join(f"{s:.4g}" for s in facts.size[:facts.nDim])
        self._line("mesh", f"{facts.nCells} cells, {facts.nDim}D, {size} m"
                   + (f", {facts.thickness:.4g} m thick" if facts.thickness else "")
                   + (f", {facts.mesh}" if facts.mesh else ""))
        if len(facts.widths) and np.ptp(facts.widths) > 1e-3*facts.widths.max():
            least = int(facts.widths.argmin())
            place = " ".join(f"{v:.4g}" for v in facts.centres[least])
            self._line("", f"smallest cell {facts.widths[least]:.3g} m at ({place}), mean "
                       f"{facts.widths.mean():.3g} m, largest {facts.widths.max():.3g} m")
        for k, (patches, words) in enumerate(facts.sides()):
            self._line("" if k else "patches", f"{patches}: {words}")
        for name, phase in facts.phases.items():
            self._line(name, f"{phase.n} points of {phase.law}"
                       + (f", mass {phase.mass:.4g} kg" if phase.mass else "")
                       + (f", wave speed {phase.speed:.4g} m/s" if phase.speed else "")
                       + (f"; in a cell {phase.least} to {phase.most}, mean {phase.mean:.3g}"
                          if phase.n else "") + checkRules.holders(facts, name))
            self._tellBodies(facts, name)
        if facts.points:
            self._line("points", f"{facts.points} in all")
            self._line("scheme", facts.scheme)
        for name in facts.media:
            self._line(name, facts.media[name])
        self._line("start", checkFluids.start(facts))

    def _tellBodies(self, facts, phase):
        """Cells over the thinnest side of each body's box, of many only of the thinnest."""
        found = []
        for name, (kind, size, low, high) in facts.boxes().items():
            region = facts.regions.get(name, {})
            if "wedge" in facts.patches.values():       # what is on this side of the axis
                low, high = np.maximum(low, facts.low), np.minimum(high, facts.high)
                size = high - low
            thin = min(facts.axes, key=lambda d: size[d])
            width = facts.length(phase, thin, low, high)
            if width and isinstance(region, dict) and region.get("phase") == phase:
                turned = facts.thinnest(phase, low, high)
                if 0 < turned < 0.9*size[thin]:
                    found.append((turned, name, width, " of its points"))
                else:
                    found.append((float(size[thin]), name, width, "" if kind == "box" else
                                  " of its box"))
        for thin, name, width, of in sorted(found)[:1 if len(found) > 8 else 8]:
            self._line("", f"{name}: {thin/width:.2g} cells across the thinnest side{of}, "
                       f"{thin:.4g} m")

    def _try(self):
        """Some steps of the copy: on one processor, then on the ranks."""
        own = self.case.file("system/controlDict")
        shutil.copy(own, own + ".own")
        for ranks in {1: 1, self.ranks: self.ranks}:
            shutil.copy(own + ".own", own)
            trial = Trial(self.case, ranks)
            self._say(f"a few steps on {_cores(ranks)}")
            try:
                trial.run(self.nSteps)
            except RunFailed:
                name = "materialPointFoam"
                if ranks > 1 and "FATAL" in self._log("decomposePar"):
                    name = "decomposePar"
                self._readLog(name)
                self._fatal(name, f"{name} on {_cores(ranks)}")
                raise
            self._readLog("materialPointFoam")
            self._tellTrial(trial)
            self.trial = self.trial or trial
        t = self.trial
        self._line("output", f"{t.writes} times of {_bytes(t.written)} each, together "
                   f"{_bytes(t.writes*t.written)}, beside tables")
        cores = len(os.sched_getaffinity(0))
        if self.ranks > cores:
            self._find("note", "", "", f"{self.ranks} ranks on {cores} cores: their times above "
                       "are those of ranks that wait for each other", "",
                       "running.md#several-processors")

    def _tellTrial(self, t):
        where = _cores(t.ranks)
        self._line("trial", f"{t.nTrial} steps, {1e3*t.perStep:.3g} ms of CPU for a step on "
                   + where)
        if t.ranks == 1:
            self._line("time step", f"{t.deltaT:.4g} s at least, set by {t.setBy}")
        self._line("run", f"about {t.steps} steps to endTime {t.end:g} s, {_duration(t.seconds)} "
                   f"on {where}, if the time step stays" + (
                       f"; it still grows ({t.grows:.3g} s at half of the trial): less then"
                       if t.grows else ""))
        if t.imbalance > 30:
            self._find("note", "system/decomposeParDict", "",
                       f"the fullest of {t.ranks} ranks has {t.imbalance:.3g} % more points than "
                       "the mean, and sets the pace", "setMaterialPoints -cellWeights before "
                       "decomposePar, and weightField cellWeights; in decomposeParDict, or slabs "
                       "across the bodies", "running.md#several-processors")
        self._line("memory", _bytes(t.memory*2**20) + (
            "" if t.ranks == 1 else f" of the largest of {t.ranks} ranks") + ", as in the trial")

    def _log(self, name):
        return self.case.log(name) if os.path.exists(self.case.file("log." + name)) else ""

    def _line(self, name, text):
        self.lines.append((name, text))


def _place(path):
    """File and entry of a place as OpenFOAM writes it: constant/phaseProperties.target, newer
    ones constant/phaseProperties/target."""
    file = re.match(r"(?:constant/polyMesh|constant|system|0)/[^/]+", path)
    if file:
        path = file[0] + path[file.end():].replace("/", ".")
    folder, name = os.path.split(path)
    if folder.split("/")[0] == "0" or name.startswith(("U.", "T.", "rho.", "alpha.")):
        return tuple(path.partition(".boundaryField.")[::2]) if ".boundaryField." in path \
            else (path.replace(".boundaryField", ""), "")
    file, _, entry = name.partition(".")
    return os.path.join(folder, file), entry


def _named(text):
    """File and entry that a message without a place names."""
    file = re.search(r'"((?:constant|system|0)/[^"]*)"', text)
    region = re.match(r"\s*Region (\w+)\b", text)
    if region and not file:
        return checkRules.REGIONS, "regions." + region[1]
    return (file[1] if file else ""), ""


def _remedy(message):
    """What doc/guide/troubleshooting.md says of a message, and the place there."""
    page = "troubleshooting.md"
    path = os.path.join(os.path.dirname(__file__), "../../../doc/guide", page)
    if not os.path.exists(path):
        return "", ""
    with open(path) as f:
        heading = ""
        for line in f:
            if line.startswith("## "):
                heading = "#" + re.sub(r"[^\w -]", "", line[3:].strip().lower()).replace(" ", "-")
            row = re.fullmatch(r"\| (?:`(.*)`|(.*) \(OpenFOAM's\)) \| (.*) \|\n", line)
            pieces = [p.strip() for p in (row[1] or row[2]).split("...") if p.strip()] \
                if row else []
            if pieces and all(" ".join(p.split()) in message for p in pieces):
                text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", row[3]).replace("`", "")
                return re.sub("^a warning[^:]*: ", "", text), page + heading
    return "", ""


def _cores(ranks):
    return "1 core" if ranks == 1 else f"{ranks} ranks"


def _duration(seconds):
    for unit, length, least in (("days", 86400, 172800), ("hours", 3600, 5400),
                                ("minutes", 60, 120)):
        if seconds >= least:
            return f"{seconds/length:.2g} {unit}"
    return f"{seconds:.2g} s"


def _bytes(n):
    for unit in ("B", "kB", "MB", "GB"):
        if n < 1000 or unit == "GB":
            return f"{n:.3g} {unit}"
        n /= 1000
    return ""


def write(check, out):
    """What will be, then the findings: worst first, but errors after words on units, of which they
    come."""
    width = max([len(n) for n, _ in check.lines] + [9])
    for name, text in check.lines:
        print(f"{name:{width}}  {text}", file=out)
    order = ("error", "warning", "note")
    count = {k: sum(f.kind == k for f in check.findings) for k in order}
    lead = "\n" if check.lines else ""
    units = [f for f in check.findings if count["error"] and f.kind == "warning"
             and re.search(r"\bunit\b|\bin mm\b", f.text + f.remedy)]
    for f in sorted(check.findings, key=lambda f: (f not in units, order.index(f.kind))):
        place = ", ".join(p for p in (f.file, f.entry) if p)
        print(f"{lead}{f.kind}: {place + ': ' if place else ''}{f.text}", file=out)
        if f.remedy:
            print(f"    do: {f.remedy}", file=out)
        if f.page:
            print(f"    see doc/guide/{f.page}", file=out)
        if f.kind == "error" and count["warning"]:
            print(f"    or mend first what is warned of {'above' if units else 'below'}: it may be "
                  "the cause", file=out)
        lead = "\n"
    words = [f"{n} {k}{'s' if n > 1 else ''}" for k, n in count.items() if n]
    print("\n" + (", ".join(words) if words else "Nothing found."), file=out)


def _count(text):
    if not re.fullmatch(r"0*[1-9]\d*", text):
        raise argparse.ArgumentTypeError(f"{text}: a whole number, 1 or more")
    return int(text)


def main(arguments=None):
    """The command."""
    parser = argparse.ArgumentParser(
        prog="mpmCheck", allow_abbrev=False, add_help=False,
        description="What a case will be, and what is probably wrong with it, before it runs.",
        epilog="Exit code: 0 nothing found, 1 warnings, 2 the case does not start.")
    parser.add_argument("-help", "-h", "--help", action="help", help="this text")
    parser.add_argument("case", nargs="?", default=".", help="folder of the case (this one)")
    parser.add_argument("-n", type=_count, default=1, metavar="ranks",
                        help="try on so many ranks, too")
    parser.add_argument("-noTrial", action="store_true",
                        help="no steps: dictionaries, mesh, points and the solver's start alone, "
                        "no function objects")
    parser.add_argument("-steps", type=_count, metavar="N",
                        help="steps of the trial (40, of small cases more)")
    given = parser.parse_args(arguments)
    check = Check(given.case, given.n, not given.noTrial, given.steps)
    try:
        code = check.run()
    except KeyboardInterrupt:
        return 130
    write(check, sys.stdout)
    return code


if __name__ == "__main__":
    sys.exit(main())
