"""What a case asks for (its dictionaries) and the tables that function objects wrote, for
mpm.report.

    data = readDictionary(case, "constant/phaseProperties")     # nested dict of texts
    flat(data)                                                  # {"ball.rho": "8960", ...}
    meanings = Meanings()                   # of entries: unit and meaning of doc/entries.md
    for table in tables(case): ...          # of postProcessing
"""

import os
import re
import shutil
import subprocess

import numpy as np

#: Dictionaries that say what is computed, in the order in which they are shown
FILES = ("constant/phaseProperties", "constant/g", "system/setMaterialPointsDict",
         "system/setFluidsDict", "system/fvSolution", "system/fvSchemes",
         "system/controlDict", "system/blockMeshDict", "system/adaptiveMeshDict",
         "system/decomposeParDict")
PROJECT = os.path.abspath(os.path.join(os.path.dirname(__file__), "../../.."))

#: What may stand in brackets behind a word, as in reconstruct(p) or div(phi,interpolate(U))
_WITHIN = r"[^\s(){};\[\]\"]*"
for _ in range(4):
    _WITHIN = rf"(?:[^\s(){{}};\[\]\"]|\({_WITHIN}\))*"
_TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|#[^\n]*|"[^"]*"|[{}();\[\]]'
                    rf'|[^\s{{}}();\[\]"]+(?:\({_WITHIN}\))*', re.S)


def parse(text):
    """A dictionary's text without macros and comments: a nested dict of texts."""
    tokens = [t for t in _TOKEN.findall(text) if not t.startswith(("//", "/*", "#"))]
    data, _ = _entries(tokens, 0)
    data.pop("FoamFile", None)
    return data


def _entries(tokens, i):
    data = {}
    while i < len(tokens) and tokens[i] != "}":
        key, i = tokens[i], i + 1
        if key == ";":
            continue
        if i < len(tokens) and tokens[i] == "{":
            data[key], i = _entries(tokens, i + 1)
            i += 1
            continue
        words, depth = [], 0
        while i < len(tokens) and (depth or tokens[i] not in (";", "}")):
            depth += {"(": 1, ")": -1, "{": 1, "}": -1}.get(tokens[i], 0)
            words.append(tokens[i])
            i += 1
        if i < len(tokens) and tokens[i] == ";":
            i += 1
        data[key] = re.sub(r"([(\[]) | ([)\]])", r"\1\2", " ".join(words))
    return data, i


def readDictionary(case, name):
    """A dictionary of the case, with what its macros stand for; {} if it is missing. Without
    OpenFOAM's foamDictionary, or where it cannot read the file, as the file has it."""
    path = case.file(name)
    if not os.path.isfile(path):
        return {}
    with open(path, errors="replace") as f:
        text = f.read()
    plain = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    if re.search(r"[#$]", plain) and shutil.which("foamDictionary"):
        run = subprocess.run(
            ["foamDictionary", "-expand", name], cwd=case.path, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            env={**os.environ, "PWD": os.path.realpath(case.path)})
        if run.returncode == 0:
            text = run.stdout.decode(errors="replace")
            text = text[max(0, text.find("FoamFile")):]
    return parse(text)


def flat(data, before=""):
    """Entries by their path: {"ball.constitutiveModel.rho": "8960"}."""
    found = {}
    for key, value in data.items():
        if isinstance(value, dict):
            found.update(flat(value, f"{before}{key}."))
            if not value:
                found[before + key] = "{}"
        else:
            found[before + key] = value
    return found


def fields(case, time="0"):
    """Conditions of the fields of the start: {field: {patch: dict}}, inner values left out."""
    found, folder = {}, case.file(time)
    if not os.path.isdir(folder):
        folder += ".orig"
    for name in sorted(os.listdir(folder)) if os.path.isdir(folder) else ():
        path = os.path.join(folder, name)
        if not os.path.isfile(path):
            continue
        with open(path, "rb") as f:
            raw = f.read()
        at = raw.find(b"boundaryField")
        if at >= 0 and len(raw) - at < 1e5 and b"nonuniform" not in raw[at:]:
            found[name] = parse(raw[at:].decode(errors="replace")).get("boundaryField", {})
    return found


def same(a, b):
    """Are two values the same, numbers by what they are worth (1e5 and 100000)?"""
    first, second = (re.split(r"([\s()\[\]]+)", v) for v in (a, b))
    if len(first) != len(second):
        return False
    for u, v in zip(first, second):
        if u.strip() != v.strip():
            try:
                if float(u) != float(v):
                    return False
            except ValueError:
                return False
    return True


def differences(case, other):
    """Rows of file, entry, value of the one, value of the other ("": it has none)."""
    rows = []
    for name in FILES:
        a, b = (flat(readDictionary(c, name)) for c in (case, other))
        rows += [(name, key, a.get(key, ""), b.get(key, "")) for key in {**a, **b}
                 if key not in a or key not in b or not same(a[key], b[key])]
    a, b = fields(case), fields(other)
    for name in sorted({**a, **b}):
        u, v = (flat(f.get(name, {})) for f in (a, b))
        rows += [(f"0/{name}", key, u.get(key, ""), v.get(key, "")) for key in {**u, **v}
                 if key not in u or key not in v or not same(u[key], v[key])]
    return rows


_UNITS = re.compile(r"(?:list of )?((?:Pa|m|s|kg|J|K|W|N|rad|degrees|1)"
                    r"(?:[/ ](?:Pa|m|s|kg|kmol|J|K|W|N)\d?(?:\^\w+)?|\d)*)(?=$|[,;])")
#: Dictionaries of constant/phaseProperties and their section of doc/entries.md
_SECTIONS = {
    "equationOfState": "Equations of state", "constitutiveModel": "Laws",
    "failureModel": "Failure models", "erosion": "Erosion", "drag": "Drag",
    "heatTransfer": "Heat transfer", "granularPressure": "Granular pressure",
    "detonation": "Detonation", "afterburn": "Afterburn", "motion": "Motion of rigid phases",
    "bodyForce": "Body forces", "surfaceLoads": "Surface loads", "damping": "Damping"}
_BLOCKS = {"contact": "Contact", "outflow": "Outflow and parts of the step",
           "stepParts": "Outflow and parts of the step", "fluids": "Fluids"}
#: A fluid has the thermo of a gas
_KINDS = {"gas": ["Gas"], "fluid": ["Fluids", "Gas"]}
_WHOLE = ("system/fvSchemes", "system/adaptiveMeshDict", "constant/phaseProperties")


def _within(data, words):
    """The dictionary in which an entry of a path stands."""
    for word in words[:-1]:
        data = data.get(word, {})
    return data


def sectionsOf(file, words, data):
    """Sections of doc/entries.md that may explain the entry of a path in a file: none of those of
    OpenFOAM, or of words of one's own."""
    inner = words[1:-1]
    if file == "constant/phaseProperties" and len(words) > 1:
        if words[0] in _BLOCKS:
            return [_BLOCKS[words[0]]]
        of = _KINDS.get(data[words[0]].get("type"), ["Phases of points"])
        found = [_SECTIONS[w] for w in inner if w in _SECTIONS]
        if inner and found:
            return found[-1:] + (of if words[-2:] == ["erosion", "to"] else [])
        return of if inner else [*of, file]
    if file in ("system/setMaterialPointsDict", "system/setFluidsDict"):
        if len(words) < 3:
            return [file] if words[0] in ("default", "hydrostatic", "regions") else []
        if "surface" in inner:      # OpenFOAM's
            return []
        return ["Shapes"] if "shapes" in inner else [file, "Shapes"]
    if file == "system/controlDict" and words[0] == "functions":
        ours = len(words) > 2 and "mpmFunctionObjects" in str(
            data["functions"].get(words[1], {}).get("libs"))
        return ["Function objects"] if ours else []
    if file == "system/adaptiveMeshDict" and "shape" in inner:
        return ["Shapes"]
    if file == "system/decomposeParDict":
        return ["system/decomposeParDict, loadBalance"] if words[0] == "loadBalance" else []
    if file == "system/fvSolution":
        return [file] if words[0] == "materialPoints" else []
    return [file] if file in _WHOLE or len(words) == 1 else []


class Meanings:
    """Unit and meaning of entries, as doc/entries.md has them."""

    def __init__(self):
        self.rows, section = {}, ""
        path = os.path.join(PROJECT, "doc/entries.md")
        if not os.path.exists(path):
            return
        with open(path, encoding="utf-8") as f:
            for line in f:
                if line.startswith("#"):
                    section = line.strip("# \n")
                cells = [c.strip() for c in re.split(r"(?<!\\)\|", line)[1:-1]]
                if len(cells) == 4:
                    for name in re.findall(r"`([^`]+)`", cells[0]):
                        self.rows.setdefault((section, name), []).append((cells[1], cells[3]))

    def find(self, file, path, data):
        """(unit, meaning) of the entry of a path "ball.constitutiveModel.rho" in the dictionary
        of a file; of several rows that which names the type beside the entry."""
        words = path.split(".")
        for section in sectionsOf(file, words, data):
            rows = self.rows.get((section, words[-1]), [])
            kind = _within(data, words).get("type")
            rows = [r for r in rows if isinstance(kind, str) and re.search(
                rf"\b{re.escape(kind)}\b", r[1])] or rows
            if rows:
                values, meaning = rows[0]
                unit = _UNITS.match(values)
                meaning = re.sub(r"\[([^]]*)\]\([^)]*\)|`", r"\1", meaning)
                return unit[1] if unit else "", meaning
        return "", ""


# --- tables of postProcessing ----------------------------------------------------

#: Units of fields that are probed
UNITS = {"p": "Pa", "T": "K", "rho": "kg/m3", "depth": "m", "level": "m"}


class Table:
    """A table of a function object: names of its columns, numbers, what its head says."""

    def __init__(self, function, name, paths, fluids=False):
        self.function, self.name, self.paths = function, name, paths
        comments, rows = [], []
        for path in paths:
            with open(path, errors="replace") as f:
                lines = f.read().splitlines()
            head = [x.lstrip("# ").rstrip() for x in lines if x.startswith("#")]
            comments = head or comments
            new = [self.numbers(x) for x in lines if x.strip() and not x.startswith("#")]
            # The last line may be cut off where a run goes on
            new = [r for r in new if r and len(r) == len(new[0])]
            if new and rows and len(new[0]) == len(rows[0]):
                rows = [r for r in rows if r[0] < new[0][0]]
            elif new:
                rows = []
            rows += new
        self.data = np.array(rows, float, ndmin=2) if rows else np.zeros((0, 0))
        self.title = comments[0] if len(comments) > 1 else ""
        self.columns = self.head(comments[-1] if comments else "")
        self.places = self.placesOf(comments)
        if fluids:
            self.title = re.sub("^Gas fluids", "Fluids", re.sub(
                "^Gas and", "Fluids and", self.title))
            if self.title.startswith("Energy budget"):
                self.columns = [re.sub("^gas", "fluids", c) for c in self.columns]
        self.overTime = self.columns[:1] and self.columns[0].startswith("Time")
        self.bins = any("bins" in c for c in comments[:2])

    def placesOf(self, comments):
        """Are the columns probes of a field, of blastProbes or OpenFOAM? Their names are then the
        places and patches."""
        said = " ".join(c for c in comments if re.match(r"Probes?[: ]", c))
        found = re.findall(r"\b\d+ (?:at )?(\([^)]*\)|patch [^,]+)", said)
        if not found or len(found) != len(self.columns) - 1:
            return []
        unit = UNITS.get(os.path.splitext(self.name)[0], "-")
        self.columns[1:] = [f"{place}[{unit}]" for place in found]
        self.title = "".join(re.findall(r"field \w+$", self.title))
        return found

    @staticmethod
    def numbers(line):
        """Numbers of a line; those of vectors one after the other; none if it has words."""
        try:
            return [float(v) for v in line.replace("(", " ").replace(")", " ").split()]
        except ValueError:
            return []

    def head(self, line):
        names = [n.strip() for n in re.split(r"\t|  +", line) if n.strip()]
        n = self.data.shape[1]
        if len(names) < n and len(names) > 1 and (n - 1) % (len(names) - 1) == 0:
            parts = (n - 1)//(len(names) - 1)
            axes = {3: "xyz", 6: ("xx", "xy", "xz", "yy", "yz", "zz")}.get(
                parts, range(parts))
            names = names[:1] + [f"{name} {a}" for name in names[1:] for a in axes]
        if len(names) != n:
            names = ["Time"] + [str(i) for i in range(1, n)]
        return names

    def groups(self):
        """Columns by their unit, of those without by their name: [(unit, columns)]."""
        found = {}
        for i, name in enumerate(self.columns[1:], 1):
            unit = re.search(r"\[([^]]*)\]$", name)
            what = re.search(r"\((\w.*)\)$", name)
            # Heat is so much more that it would hide the kinetic energy
            heat = name.startswith(("internal[", "gas[", "fluids["))
            # Ends of a material and its centre, one direction after the other
            along = re.match(r"(?:min|max|centre)_([xyz])\[m\]", name)
            key = (unit[1], along[1] if along else heat) if unit and unit[1] != "-" else (
                "", "" if self.places else what[1] if what else re.sub(r"\W.*|\d+$", "", name))
            found.setdefault(key, []).append(i)
        return [(unit, columns) for (unit, _), columns in found.items()]


def units(summary, names):
    """The columns of blastProbes' summary with the unit of their field, whose table is beside."""
    field = next((os.path.splitext(n)[0] for n in names if n != summary.name), "")
    unit = UNITS.get(field, "")
    if unit and summary.columns[0] == "Probe":
        summary.columns = [
            c + f"[{unit}]" if c in ("ambient", "peak") else
            c + f"[{unit} s]" if c.endswith("Impulse") else c for c in summary.columns]
        summary.title += f", field {field}"


def tables(case):
    """All tables of postProcessing, later starts of the run behind the earlier ones."""
    root = case.file("postProcessing")
    fluids = any(isinstance(d, dict) and d.get("type") == "fluid"
                 for d in readDictionary(case, FILES[0]).values())
    for function in sorted(os.listdir(root)) if os.path.isdir(root) else ():
        files = {}
        folder = os.path.join(root, function)
        for time in sorted(os.listdir(folder), key=_time) if os.path.isdir(folder) else ():
            where = os.path.join(folder, time)
            for name in sorted(os.listdir(where)) if os.path.isdir(where) else ():
                if os.path.splitext(name)[1] in ("", ".dat") \
                        and os.path.isfile(os.path.join(where, name)):
                    files.setdefault(name, []).append(os.path.join(where, name))
        for name, paths in files.items():
            try:
                table = Table(function, name, paths, fluids)
            except (ValueError, OSError):
                continue
            if name == "summary.dat":
                units(table, files)
            if table.data.size:
                yield table


def _time(name):
    try:
        return float(name)
    except ValueError:
        return np.inf


# --- mesh ------------------------------------------------------------------------

def meshOf(case):
    """Cells, points and patches (name, type, faces) of the mesh, of one that is decomposed of
    all processors; {} if there is none."""
    pieces = [case.path] if os.path.exists(case.file("constant/polyMesh/owner")) else \
        case.processors()
    cells, patches = 0, {}
    for piece in pieces:
        folder = os.path.join(piece, "constant/polyMesh")
        try:
            with open(os.path.join(folder, "owner"), "rb") as f:
                note = re.search(rb"nCells: *(\d+)", f.read(2000))
            with open(os.path.join(folder, "boundary"), errors="replace") as f:
                text = re.sub(r"(?s)FoamFile.*?}", "", f.read(), count=1)
        except OSError:
            continue
        cells += int(note[1]) if note else 0
        for name, body in re.findall(r"(\S+)\s*\{(.*?)\}", text, flags=re.S):
            kind = re.search(r"\btype\s+(\w+)", body)
            n = re.search(r"\bnFaces\s+(\d+)", body)
            if kind and kind[1] != "processor":
                old = patches.get(name, ("", 0))[1]
                patches[name] = kind[1], old + (int(n[1]) if n else 0)
    return {"cells": cells, "patches": patches} if cells or patches else {}
