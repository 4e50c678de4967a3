"""What is probably wrong with a case, by its dictionaries and what the solver says at its start.

    facts = Facts(case)             # a case with mesh and points, after materialPointFoam -dry-run
    for finding in findings(facts): ...

Limits of units: bounds of what matter and laboratories have (BOUNDS), not of what the method can
do. Those of schemes are the tables of doc/guide/schemes.md. A rule is a function of the facts
that gives its findings.
"""

import math
import os
import re
from dataclasses import dataclass, field

import numpy as np

from mpm.dictionaries import DictionaryError, readDictionary
from mpm.files import readField, readLists

#: Lowest and highest of what is no mistake
BOUNDS = {"rho": (0.1, 25000), "speed": (10, 20000), "length": (1e-6, 1e3), "g": (0.1, 1000)}
#: Poisson number from which matter locks
LOCKS = 0.45
#: Steps from which a motion is long for a transfer that dissipates in each
LONG = 20000
PHASES, REGIONS = "constant/phaseProperties", "system/setMaterialPointsDict"
SOLUTION, CONTROL = "system/fvSolution", "system/controlDict"
PLASTIC = ("J2Plasticity", "JohnsonCook")
LIQUIDS = ("NewtonianFluid",)
#: Conditions of p that let most of a wave out (doc/guide/fluids.md), or have it at a wall
OPEN = ("farField", "waveTransmissive", "advective", "zeroGradient")
#: Types of patches through which nothing shall go
CLOSED = ("empty", "wedge", "cyclic", "symmetry", "symmetryPlane", "wall")
#: Conditions of U through which a fluid leaves
LETS_OUT = ("zeroGradient", "inletOutlet", "pressureInletOutletVelocity", *OPEN[:3])


@dataclass
class Finding:
    """kind: error, warning, note. unless: not told if a text with this pattern is there."""
    kind: str
    file: str
    entry: str
    text: str
    remedy: str = ""
    page: str = ""
    unless: str = ""


@dataclass
class Phase:
    """What the solver says of the points of a phase, and how many are in a cell."""
    n: int
    law: str
    speed: float = 0.0
    least: int = 0
    most: int = 0
    mean: float = 0.0
    low: np.ndarray = field(default_factory=lambda: np.zeros(3))
    high: np.ndarray = field(default_factory=lambda: np.zeros(3))
    U: float = 0.0


class Facts:
    """A case as it starts."""

    def __init__(self, case):
        self.case, self.trial = case, None
        self.properties = case.get(PHASES)
        self.control = case.get(CONTROL)
        self.solution = self._may(SOLUTION).get("materialPoints", {})
        self.regions = self._may(REGIONS).get("regions", {})
        self.log = case.log()
        self._readMesh()
        self._readPhases()
        self._readMedia()

    def _may(self, path):
        """A dictionary that may be missing."""
        return self.case.get(path) if os.path.exists(self.case.file(path)) else {}

    def of(self, phase):
        """The dictionary of a phase."""
        found = self.properties.get(phase, {})
        return found if isinstance(found, dict) else {}

    def lawOf(self, phase):
        found = self.of(phase).get("constitutiveModel", {})
        return found if isinstance(found, dict) else {}

    def _readMesh(self):
        x = readField(self.case.file("constant/polyMesh/points"))
        self.low, self.high = x.min(axis=0), x.max(axis=0)
        self.nCells = self.case.nCells()
        with open(self.case.file("constant/polyMesh/boundary"), "rb") as f:
            text = re.sub(r"/\*.*?\*/|//[^\n]*", "", f.read().decode("latin-1"), flags=re.S)
        self.patches = dict(re.findall(r"(\S+)\s*\{[^}]*?\btype\s+(\w+);", text.split("}", 1)[1]))
        flat = "empty" in self.patches.values()
        self.axes = [d for d in range(3) if not flat or len(np.unique(
            np.round(x[:, d]/max(np.ptp(x), 1e-300), 9))) > 2]
        if "wedge" in self.patches.values():
            # The direction around has the least extent
            self.axes = sorted(set(self.axes) - {int(np.argmin(np.ptp(x, axis=0)))})
        self.size = (self.high - self.low)[self.axes]
        self.nDim = len(self.axes)
        self.mesh = ""
        said = re.search(r"^Material points: .*, ((?:axisymmetric )?)(\d)D, \d+ nodes, (.*)$",
                         self.log, re.M)
        self.lattice = bool(said) and said[3] == "lattice"
        if said:
            self.nDim = int(said[2])
            self.mesh = said[1] + ("boxes" if self.lattice else said[3])
        #: Width of a cell by volume [m]
        volume = float(np.prod(self.size))
        self.width = (volume/self.nCells)**(1/max(self.nDim, 1))

    def _readPhases(self):
        self.phases = {}
        for name, n, rest in re.findall(r"^Phase (\S+): (\d+) points of (.*)$", self.log, re.M):
            speed = re.search(r"wave speed ([\d.e+-]+) m/s", rest)
            law = rest.split(",")[0]
            phase = Phase(int(n), law, float(speed[1]) if speed else 0.0)
            if phase.n:
                self._readPoints(name, phase)
            self.phases[name] = phase
        self.points = sum(p.n for p in self.phases.values())
        shape = re.search(r"shape function (\w+),.*? stress update (\w+)", self.log)
        transfer = re.search(r"^ *transfer (\w+)( of order \d+)?", self.log, re.M)
        self.shape, self.update = shape.groups() if shape else ("", "")
        self.transfer = transfer[1] if transfer else ""
        self.scheme = f"{self.shape}, {self.transfer}{transfer[2] or ''}, {self.update}" \
            if shape and transfer else ""

    def _readPoints(self, name, phase):
        time = self.case.times("lagrangian")[-1]
        cloud = self.case.points(time, name)
        x = cloud["x"]
        phase.low, phase.high = x.min(axis=0), x.max(axis=0)
        phase.U = float(np.sqrt((cloud["U"]**2).sum(axis=1)).max())
        count = np.bincount(_cells(self.case.file(time, "lagrangian", name, "coordinates")))
        count = count[count > 0]
        if len(count):
            phase.least, phase.most, phase.mean = count.min(), count.max(), count.mean()

    def _readMedia(self):
        """Gas and fluids: name: text; speed of sound where it is simple."""
        self.media, self.sound, self.p = {}, 0.0, {}
        for name in self.properties.get("phases", ()):
            of = self.of(name)
            if of.get("type") not in ("gas", "fluid"):
                continue
            state = of.get("equationOfState", {})
            kind = of.get("thermo") or (state.get("type") if isinstance(state, dict) else "")
            text, c = f"{of['type']}, {kind}", 0.0
            if kind == "perfectGas":
                c = self._soundOfGas(name, of)
            elif isinstance(state, dict):
                c = self._soundOfLiquid(of, state)
            self.media[name] = text + (f", sound {c:.4g} m/s" if c else "")
            self.sound = max(self.sound, c)
        start = os.path.join("0", "p")
        if self.media and os.path.exists(self.case.file(start)):
            try:
                self.p = readDictionary(self.case.file(start), self.case.path)
            except DictionaryError:
                pass

    def _soundOfGas(self, name, of):
        """sqrt(gamma R T) of the largest T of the start."""
        R = of.get("R") or 8314.46/of["molWeight"] if of.get("R") or of.get("molWeight") else 0
        gamma = of.get("gamma") or (
            of["Cp"]/(of["Cp"] - R) if of.get("Cp") else 1 + R/of["Cv"] if of.get("Cv") else 0)
        path = self.case.file("0", "T." + name)
        if not (R and gamma and os.path.exists(path)):
            return 0.0
        T = np.max(self.case.field("0", "T." + name))
        return float(np.sqrt(gamma*R*T)) if T > 0 else 0.0

    def _soundOfLiquid(self, of, state):
        """At rest: C0, soundSpeed, or sqrt(gamma (p0 + pInf)/rho)."""
        c = state.get("C0", state.get("soundSpeed"))
        if isinstance(c, (int, float)):
            return float(c)
        needed = [state.get("gamma"), state.get("pInf"), of.get("rho")]
        if state.get("type") != "stiffenedGas" or not all(
                isinstance(v, (int, float)) for v in needed):
            return 0.0
        gamma, pInf, rho = needed
        return math.sqrt(gamma*(pInf + (state.get("p0") or 0))/rho)

    @property
    def end(self):
        return float(self.control.get("endTime", math.nan))

    def g(self):
        """Gravity [m/s2]; zero without its file, or where it is no list of numbers."""
        g = self._may("constant/g").get("value", [])
        numbers = isinstance(g, list) and all(isinstance(v, (int, float)) for v in g)
        return np.array(g if numbers and len(g) == 3 else (0, 0, 0), float)

    def conditions(self, field):
        """Patches: the dictionary of their condition, by name or by pattern."""
        given = {key: of for key, of in self.case.get(field).get("boundaryField", {}).items()
                 if isinstance(of, dict)}
        found = {p: of for key, of in given.items() for p in self.patches
                 if re.fullmatch(key, p)}
        found.update({p: given[p] for p in self.patches if p in given})
        return found

    def number(self, name, default):
        """A number of fvSolution.materialPoints."""
        value = self.solution.get(name, default)
        return value if isinstance(value, (int, float)) else default


def _cells(path):
    """Numbers of the cells of points in OpenFOAM's file of coordinates, ascii or binary."""
    with open(path, "rb") as f:
        raw = f.read()
    body = re.sub(rb"\A.*?\n\}\n", b"", raw, count=1, flags=re.S)
    body = re.sub(rb"\A(\s*//[^\n]*\n)*\s*", b"", body, count=1)
    head = re.match(rb"(\d+)\s*\(", body)
    if not head or not int(head[1]):
        return np.zeros(0, int)
    if re.search(rb"format\s+binary", raw[:2000]):
        # A line each: ( and ) around 4 doubles and 3 labels
        record = np.dtype([("open", "S1"), ("w", "4f8"), ("cell", "3i4"), ("close", "S2")])
        start = body.index(b"(", head.end())
        return np.frombuffer(body, record, int(head[1]), start)["cell"][:, 0]
    return np.array(re.findall(rb"\)\s+(\d+)\s+\d+\s+\d+", body[head.end():]), int)


def _outside(value, name):
    low, high = BOUNDS[name]
    return isinstance(value, (int, float)) and not low <= abs(value) <= high


# --- units ---------------------------------------------------------------------

def densities(facts):
    for name in facts.properties.get("phases", ()):
        of, law = facts.of(name), facts.lawOf(name)
        rho, entry = (law["rho"], "constitutiveModel.rho") if "rho" in law \
            else (of.get("rho"), "rho")
        if _outside(rho, "rho") and rho > 0:
            yield Finding("warning", PHASES, f"{name}.{entry}", f"a density of {rho:g} kg/m3; "
                          "matter has 0.1 to 25000", "kg/m3: 7800 for 7.8 g/cm3, 7.8e-9 t/mm3",
                          "troubleshooting.md", rf"phase {name}\b.*kg/m3")


def waveSpeeds(facts):
    for name, phase in facts.phases.items():
        soft = phase.law in LIQUIDS or phase.law in ("DruckerPrager", "MohrCoulomb", "muI")
        if phase.speed and _outside(phase.speed, "speed") and not (soft and phase.speed < 10):
            what = ("too slow: a modulus in MPa or GPa?" if phase.speed < 10 else
                    "too fast (diamond 18000): a density in g/cm3?")
            yield Finding("warning", PHASES, f"{name}.constitutiveModel", f"a wave speed of "
                          f"{phase.speed:.4g} m/s: {what}", "moduli in Pa: 1e6 for 1 MPa, 70e9 for "
                          "70 GPa; rho in kg/m3", "troubleshooting.md",
                          rf"phase {name} has a wave speed")


def strengths(facts):
    for name in facts.phases:
        law, failure = facts.lawOf(name), facts.of(name).get("failureModel", {})
        E = law.get("E") or 3*law.get("G", 0)
        if not isinstance(E, (int, float)) or not E:
            continue
        rows = [("constitutiveModel.yield", law.get("yield")),
                ("constitutiveModel.A", law.get("A") if law.get("type") == "JohnsonCook" else 0)]
        if isinstance(failure, dict):
            rows.append(("failureModel.strength", failure.get("strength")))
        for entry, value in rows:
            if isinstance(value, (int, float)) and value > E:
                yield Finding("warning", PHASES, f"{name}.{entry}", f"{value:g} Pa is above the "
                              f"modulus, {E:g} Pa", "both in Pa: is one of them in MPa or GPa?",
                              "troubleshooting.md")


def meshSize(facts):
    for d, size in zip("xyz", facts.size):
        if _outside(float(size), "length"):
            yield Finding("warning", "system/blockMeshDict", "scale", f"the mesh is {size:.4g} m "
                          f"long in {d}", "lengths in m after scale: scale 1e-3 for a mesh in mm",
                          "meshes.md")


def gravity(facts):
    path, g = "constant/g", float(np.linalg.norm(facts.g()))
    if g and _outside(g, "g"):
        yield Finding("warning", path, "value", f"{g:g} m/s2; the earth has 9.81",
                      "m/s2: 9.81 for 9810 mm/s2", "materials.md#body-forces",
                      "whatever the unit of the mesh")


def pressure(facts):
    """Of the start, in bar. Temperatures in degrees Celsius the programs find themselves."""
    for name in facts.media:
        temperature = facts.case.file("0/T." + name)
        if not facts.p or not os.path.exists(temperature):
            continue
        p, T = np.min(facts.case.field("0", "p")), np.min(facts.case.field("0", "T." + name))
        if 0 < p < 100 and T > 100:
            yield Finding("warning", "0/p", "internalField", f"{p:g} Pa at {T:g} K",
                          "in Pa: 1e5 for 1 bar", "fluids.md#gas")
            return


def duration(facts):
    """Waves that do not get anywhere, and runs without end."""
    c = max([p.speed + p.U for p in facts.phases.values()] + [facts.sound])
    cells = c*facts.end/facts.width if c and facts.end > 0 else math.nan
    if cells < 3:
        yield Finding("warning", CONTROL, "endTime", f"in {facts.end:g} s the fastest wave "
                      f"({c:.4g} m/s) goes {cells:.2g} cells of {facts.width:.3g} m: nothing can "
                      "happen", "endTime in s; or the mesh and the shapes are in mm: scale 1e-3",
                      "troubleshooting.md")
    elif cells > 1e7:
        yield Finding("warning", CONTROL, "endTime", f"more than 1e7 steps: in {facts.end:g} s the "
                      f"fastest wave goes {cells:.2g} cells", "endTime in s: 1e-4 for 100 us",
                      "running.md", "would take")


# --- waves ---------------------------------------------------------------------

def wavesLeave(facts):
    """Open sides of a gas or fluids that send waves back before the end."""
    conditions = facts.p.get("boundaryField", {})
    sends = [patch for patch, of in conditions.items() if isinstance(of, dict)
             and facts.patches.get(patch) not in (None, *CLOSED)
             and of.get("type") not in (None, *OPEN)]
    if not facts.sound or not sends:
        return
    low = np.min([p.low for p in facts.phases.values() if p.n] or [facts.low], axis=0)
    high = np.max([p.high for p in facts.phases.values() if p.n] or [facts.high], axis=0)
    if not facts.points:
        low = high = (facts.low + facts.high)/2
    x = readField(facts.case.file("constant/polyMesh/points"))
    for patch, corners in _patchPoints(facts.case, x, sends).items():
        kind = conditions[patch]["type"]
        gap = np.maximum(0, np.maximum(low - corners, corners - high))[:, facts.axes]
        way = float(np.sqrt((gap**2).sum(axis=1)).min())
        time = 2*way/facts.sound
        if time < facts.end:
            yield Finding("note", "0/p", f"boundaryField.{patch}", f"{kind} sends waves back: what "
                          f"starts at the {'points' if facts.points else 'middle'} is there again "
                          f"from {time:.3g} s on (endTime {facts.end:g} s)",
                          "farField, or a larger mesh, if waves shall leave",
                          "fluids.md#open-boundaries")


def holders(facts, name):
    """Words on the sides that hold the points of a phase: fixedValue in its 0/U."""
    field = "0/U." + str(facts.of(name).get("velocityField", name))
    phase = facts.phases[name]
    if not phase.n or not os.path.exists(facts.case.file(field)):
        return ""
    fixed = [p for p, of in facts.conditions(field).items() if of.get("type") == "fixedValue"]
    x, words = readField(facts.case.file("constant/polyMesh/points")), []
    for patch, corners in _patchPoints(facts.case, x, fixed).items():
        gap = np.maximum(0, np.maximum(phase.low - corners, corners - phase.high))[:, facts.axes]
        gap = float(np.sqrt((gap**2).sum(axis=1)).min())
        words.append(f"held by {patch}" if gap < facts.width else
                     f"{patch}, which would hold it, is {gap:.3g} m away")
    return "".join("; " + w for w in words)


def _patchPoints(case, x, patches):
    """Corners of the faces of some patches."""
    faces = readLists(case.file("constant/polyMesh/faces"))
    return {name: x[np.unique(np.concatenate(faces[start:start + n]))]
            for name, (start, n) in _patchFaces(case).items() if n and name in patches}


def _patchFaces(case):
    """Patches: first face and number of faces."""
    with open(case.file("constant/polyMesh/boundary"), "rb") as f:
        rows = re.findall(r"(\S+)\s*\{[^}]*?nFaces\s+(\d+);\s*startFace\s+(\d+);",
                          f.read().decode("latin-1"))
    return {name: (int(start), int(n)) for name, n, start in rows}


def runsOut(facts):
    """Sides below or beside a liquid under gravity through which it leaves."""
    liquids = [n for n in facts.media if isinstance(facts.of(n).get("equationOfState"), dict)
               and facts.of(n)["equationOfState"].get("type") in ("stiffenedGas", "Tait")
               and os.path.exists(facts.case.file("0", "alpha." + n))]
    g = facts.g()
    if not liquids or not np.linalg.norm(g) or not os.path.exists(facts.case.file("0/U")):
        return
    lets = {p: of["type"] for p, of in facts.conditions("0/U").items()
            if of.get("type") in LETS_OUT}
    alpha = sum(facts.case.field("0", "alpha." + n)*np.ones(facts.nCells) for n in liquids)
    x = readField(facts.case.file("constant/polyMesh/points"))
    faces = readLists(facts.case.file("constant/polyMesh/faces"))
    owner = readLists(facts.case.file("constant/polyMesh/owner"))
    for patch, (start, n) in _patchFaces(facts.case).items():
        wet = [f for f in range(start, start + n) if alpha[owner[f]] > 0.5] \
            if patch in lets else []
        down = [_normal(x[faces[f]]) @ g/np.linalg.norm(g) for f in wet]
        if not wet or max(down) < -0.1:
            continue
        below = max(down) > 0.1
        yield Finding("warning" if below else "note", "0/U", f"boundaryField.{patch}",
                      f"{lets[patch]} lets {' and '.join(liquids)} out: {len(wet)} faces of "
                      f"{patch} ({facts.patches.get(patch)}) are {'below' if below else 'beside'} "
                      "it", "a wall has type wall in constant/polyMesh/boundary (setFluids gives "
                      "it slip), or slip in 0.orig/U; then setFluids again",
                      "meshes.md#what-patches-need")


def _normal(corners):
    """Unit normal of a polygon, to the side from which its corners go left about."""
    area = np.cross(corners - corners[0], np.roll(corners, -1, axis=0) - corners[0]).sum(axis=0)
    return area/max(np.linalg.norm(area), 1e-300)


# --- schemes -------------------------------------------------------------------

def _poisson(law):
    """Poisson number of a law; None: it has none."""
    def number(name):
        value = law.get(name)
        return value if isinstance(value, (int, float)) and value > 0 else None
    nu, E, G, K = (number(n) for n in ("nu", "E", "G", "K"))
    if number("c10"):                           # MooneyRivlin
        G = 2*(law["c10"] + (number("c01") or 0))
    if nu is not None:
        return nu
    if K and G:
        return (3*K - 2*G)/(6*K + 2*G)
    return E/(2*G) - 1 if E and G else None


def locking(facts):
    if facts.nDim < 2 or facts.shape == "nodeDual" \
            or facts.solution.get("dilatation", "point") == "cellMean":
        return
    plastic = [n for n, phase in facts.phases.items() if phase.law in PLASTIC and phase.n]
    if plastic:
        yield Finding("note", SOLUTION, "materialPoints.dilatation", f"plastic flow of "
                      f"{', '.join(plastic)} keeps its volume: with {facts.shape} and dilatation "
                      "point bending is too stiff, and pressures scatter",
                      "dilatation cellMean; after impact also pressureFilter 0.02",
                      "schemes.md#locking")
    for name, phase in facts.phases.items():
        nu = _poisson(facts.lawOf(name))
        if nu is not None and nu >= LOCKS and phase.law not in (*LIQUIDS, *PLASTIC):
            yield Finding("warning", SOLUTION, "materialPoints.dilatation", f"{name} is nearly "
                          f"incompressible (Poisson number {nu:.4g}): with {facts.shape} and "
                          "dilatation point its cells lock", "dilatation cellMean",
                          "schemes.md#locking")


def courant(facts):
    co = facts.control.get("maxCo")
    if not facts.points or not isinstance(co, (int, float)):
        return
    if co > 0.5 and facts.shape != "nodeDual":
        yield Finding("warning", CONTROL, "maxCo", f"{co:g} with {facts.shape}", "0.3 to 0.5",
                      "schemes.md#what-to-choose")
    if facts.number("massFilter", 0) > 0 and facts.shape != "nodeDual" and co > 0.4:
        yield Finding("warning", CONTROL, "maxCo", f"{co:g} with massFilter and {facts.shape}",
                      "0.4 or less", "schemes.md#transfer")


def transfers(facts):
    if not facts.points:
        return
    if facts.transfer == "APIC" and facts.shape == "linear" \
            and facts.solution.get("affineMatrix") == "moment":
        yield Finding("warning", SOLUTION, "materialPoints.affineMatrix",
                      "moment blows up with linear", "affineMatrix gradient, or shapeFunction GIMP",
                      "schemes.md#transfer")
    if facts.update == "USL" and facts.shape == "linear":
        yield Finding("warning", SOLUTION, "materialPoints.stressUpdate",
                      "USL fails with linear where a node has little mass", "stressUpdate MUSL",
                      "schemes.md#stress-update")
    if facts.transfer in ("FMPM", "XPIC"):
        steps = facts.trial.steps if facts.trial else 0
        if steps > LONG:
            yield Finding("note", SOLUTION, "materialPoints.transfer", f"{facts.transfer} "
                          f"dissipates in each of about {steps} steps: smooth motion and rotation "
                          "die out", "FLIP for long elastic motion, APIC with affineMatrix moment "
                          "for rotation", "schemes.md#what-to-choose")
        if any(facts.of(n).get("type") == "fluid" and "equationOfState" in facts.of(n)
               for n in facts.media):
            yield Finding("note", SOLUTION, "materialPoints.transfer", f"{facts.transfer} needs "
                          "short steps for light bodies beside liquids", "FLIP or APIC with GIMP",
                          "fluids.md#states-that-a-step-would-not-leave")


def shapes(facts):
    given = facts.solution.get("shapeFunction")
    if not facts.points or given is None:
        return
    if facts.shape == "linear":
        better = "GIMP" if facts.lattice else "nodeDual"
        yield Finding("note", SOLUTION, "materialPoints.shapeFunction",
                      "linear is noisy as soon as points cross cells", better,
                      "schemes.md#shape-functions")
    if facts.shape == "nodeDual" and facts.lattice:
        yield Finding("note", SOLUTION, "materialPoints.shapeFunction", "nodeDual on boxes is less "
                      "accurate than GIMP", "GIMP", "schemes.md#shape-functions")


def shocks(facts):
    """Heat of strong shocks with FLIP wants a viscosity."""
    if facts.transfer != "FLIP":
        return
    fastest = max([p.U for p in facts.phases.values()], default=0)
    for name, phase in facts.phases.items():
        law = facts.lawOf(name)
        if "equationOfState" in law and "bulkViscosity" not in law and phase.speed \
                and fastest > 0.05*phase.speed:
            yield Finding("note", PHASES, f"{name}.constitutiveModel.bulkViscosity",
                          f"{fastest:g} m/s is a strong shock in {name} ({phase.speed:.4g} m/s), "
                          "and FLIP rings there", "bulkViscosity in the law", "materials.md")


def pointsInCells(facts):
    for name, phase in facts.phases.items():
        per = [r.get("pointsPerCell") for r in facts.regions.values()
               if isinstance(r, dict) and r.get("phase") == name]
        if facts.nDim > 1 and 1 in per and phase.law != "a rigid body":
            yield Finding("note", REGIONS, f"regions of {name}, pointsPerCell",
                          "1 point in a cell: bodies that stretch come apart early",
                          "pointsPerCell 2", "bodies.md")


def damage(facts):
    names = [n for n in facts.phases for failure in [facts.of(n).get("failureModel", {})]
             if isinstance(failure, dict) and "Gf" not in failure
             and str(failure.get("type")).startswith("maxPrincipal")]
    if names:
        yield Finding("note", PHASES, f"failureModel of {', '.join(names)}",
                      "without Gf the energy of cracks follows the width of the cells",
                      "Gf [J/m2] of the material", "materials.md#energy-of-failure")


def writing(facts):
    interval = facts.control.get("writeInterval")
    inTime = facts.control.get("writeControl") in ("adjustableRunTime", "adjustable", "runTime")
    if isinstance(interval, (int, float)) and inTime and interval > facts.end*(1 + 1e-9):
        yield Finding("note", CONTROL, "writeInterval", f"{interval:g} s is longer than the run: "
                      "only its end is written", "a part of endTime", "output.md", "beyond endTime")


RULES = (densities, waveSpeeds, strengths, meshSize, gravity, pressure, duration, wavesLeave,
         runsOut, locking, courant, transfers, shapes, shocks, pointsInCells, damage, writing)


def findings(facts):
    """Those of all rules."""
    return [f for rule in RULES for f in rule(facts)]
