"""What mpm.check knows of a case as it starts: mesh, phases, what is in the cells.

    facts = Facts(case)     # a case with mesh and points, after materialPointFoam -dry-run
"""

import math
import os
import re
from dataclasses import dataclass, field

import numpy as np

from mpm import checkPatches
from mpm.dictionaries import DictionaryError
from mpm.files import readField, readLists

PHASES, REGIONS = "constant/phaseProperties", "system/setMaterialPointsDict"
SOLUTION, CONTROL = "system/fvSolution", "system/controlDict"
FLUIDS, GRAVITY = "system/setFluidsDict", "constant/g"
LIQUIDS = ("NewtonianFluid",)


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
    mass: float = 0.0
    width: float = 0.0      # of the cells in which its points are [m]
    x: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    v: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    cells: np.ndarray = field(default_factory=lambda: np.zeros(0, int))
    half: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))  # sizes of their boxes [m]


class Facts:
    """A case as it starts."""

    def __init__(self, case, disk=None):
        """disk: where the case will run, if not where it is."""
        self.case, self.trial, self.disk = case, None, disk or case.path
        self.properties = case.get(PHASES)
        self.control = case.get(CONTROL)
        self.solution = self._may(SOLUTION).get("materialPoints", {})
        self.regions = self._may(REGIONS).get("regions", {})
        try:
            self.fluidStart = self._may(FLUIDS)
        except DictionaryError:     # #calc and the like: what is in it is not known
            self.fluidStart = {"hydrostatic": {}}
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
        self.groups = checkPatches.patchesOf(self.case)
        self.patches = {name: kind for name, (kind, _) in self.groups.items()}
        flat = "empty" in self.patches.values()
        self.axes = [d for d in range(3) if not flat or len(np.unique(
            np.round(x[:, d]/max(np.ptp(x), 1e-300), 9))) > 2]
        if "wedge" in self.patches.values():
            # The direction around has the least extent
            self.axes = sorted(set(self.axes) - {int(np.argmin(np.ptp(x, axis=0)))})
        self.size = (self.high - self.low)[self.axes]
        #: Of one layer of cells its thickness [m], else 0
        self.thickness = float(np.ptp(x, axis=0)[[d for d in range(3) if d not in self.axes]][0]) \
            if len(self.axes) == 2 and flat else 0.0
        self.nDim = len(self.axes)
        self.mesh = ""
        said = re.search(r"^Material points: .*, ((?:axisymmetric )?)(\d)D, \d+ nodes, (.*)$",
                         self.log, re.M)
        self.lattice = bool(said) and said[3] == "lattice"
        if said:
            self.nDim = int(said[2])
            self.mesh = said[1] + ("boxes" if self.lattice else said[3])
        self.V, self.centres, sides, extents = cells(self.case, x)
        # A square is two triangles, a cube six tetrahedra
        sides -= 2*(3 - self.nDim)
        parts = np.where(sides == self.nDim + 1, {2: 2, 3: 6}.get(self.nDim, 1), 1)
        across = np.prod([np.ptp(x, axis=0)[d] for d in range(3) if d not in self.axes])
        #: Width of each cell: of the square or cube of its size [m]; not on a wedge
        self.widths = np.zeros(0) if "wedge" in self.patches.values() else (
            parts*self.V/across)**(1/max(self.nDim, 1))
        #: Along x, y, z: of boxes their sides, of other cells their width [m]
        box = abs(extents.prod(axis=1)/self.V - 1) < 1e-6
        self.lengths = np.where(box[:, None], extents, self.widths[:, None]) \
            if len(self.widths) else extents
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
        phase.x, phase.v = x, cloud["U"]
        if "halfSize" in cloud:
            phase.half = cloud["halfSize"]
        phase.U = float(np.sqrt((cloud["U"]**2).sum(axis=1)).max())
        phase.mass = float(cloud["m"].sum()) if "m" in cloud else 0.0
        where = _cells(self.case.file(time, "lagrangian", name, "coordinates"))
        if len(self.widths) and len(where):
            phase.width = float(np.median(self.widths[where]))
        phase.cells = where
        count = np.bincount(where)
        count = count[count > 0]
        if len(count):
            phase.least, phase.most, phase.mean = count.min(), count.max(), count.mean()

    def _readMedia(self):
        """Gas and fluids: name: text; speed of sound where it is simple."""
        self.media, self.sounds, self.sound, self.p, self.rho = {}, {}, 0.0, {}, {}
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
            mass = self._massOf(name, of)
            room = float((self.share(name)*self.V).sum()) if mass else 0.0
            self.rho[name] = mass/room if room > 0 else 0.0
            self.media[name] = text + (f", sound {c:.4g} m/s" if c else "") + (
                f", mass {mass:.4g} kg" if mass else "")
            self.sounds[name] = c
            self.sound = max(self.sound, c)
        self.pressure = np.zeros(0)
        if self.media and os.path.exists(self.case.file("0/p")):
            self.p = {"boundaryField": self.boundary("0/p")}
            #: Of the cells at the start [Pa]
            self.pressure = self.case.field("0", "p")*np.ones(self.nCells)

    def share(self, name):
        """Share of a gas or fluid in the cells at the start; of a fluid without file the rest."""
        def read(fluid):
            return self.case.field("0", "alpha." + fluid) if os.path.exists(
                self.case.file("0", "alpha." + fluid)) else 0.0
        own = os.path.exists(self.case.file("0", "alpha." + name))
        others = [n for n in self.properties["phases"]
                  if n != name and self.of(n).get("type") == "fluid"]
        return (read(name) if own else 1.0 - sum(map(read, others)))*np.ones(self.nCells)

    def _massOf(self, name, of):
        """Of a gas or fluid at the start, points taken for none of the room; 0: not known."""
        def has(field):
            return os.path.exists(self.case.file("0", field))
        if has("rho." + name):
            rho = self.case.field("0", "rho." + name)
        elif of.get("thermo") == "perfectGas" and has("T." + name) and has("p"):
            T = self.case.field("0", "T." + name)
            rho = self.case.field("0", "p")/np.maximum(_gasConstant(of)*T, 1e-300) \
                if _gasConstant(of) else None
        else:
            rho = of.get("rho")
        known = isinstance(rho, (int, float, np.ndarray))
        return float((self.share(name)*rho*self.V).sum()) if known else 0.0

    def _soundOfGas(self, name, of):
        """sqrt(gamma R T) of the largest T of the start."""
        R = _gasConstant(of)
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

    def thinnest(self, name, low, high):
        """Least length of a phase's points in a box along their own principal axes [m], of points
        of one size; 0: too few to say."""
        phase, at = self.phases[name], self.axes
        x = phase.x[((phase.x >= low) & (phase.x <= high))[:, at].all(axis=1)][:, at]
        if len(x) < 16 or len(at) < 2 or not phase.width or not phase.mean:
            return 0.0
        axes = np.linalg.eigh(np.cov(x.T))[1]
        return float(np.ptp(x @ axes, axis=0).min()) + phase.width/phase.mean**(1/self.nDim)

    def boxes(self):
        """Regions with points: (kind of shape, size, low, high) by setMaterialPoints [m]; on a
        wedge with what would be on the other side of the axis."""
        path = self.case.file("log.setMaterialPoints")
        found = re.findall(
            r"^    (\S+): (\w+) of \(([^)]*)\) m from \(([^)]*)\) to \(([^)]*)\) m",
            self.case.log("setMaterialPoints") if os.path.exists(path) else "", re.M)
        return {name: (kind, *(np.array(v.split(), float) for v in of))
                for name, kind, *of in found}

    def length(self, name, d, low, high, of=np.mean):
        """Of the lengths along d of the cells with points of a phase in a box the mean, or another
        [m]; 0: none."""
        phase, at = self.phases[name], self.axes
        if len(phase.cells) != len(phase.x):
            return 0.0
        inside = phase.cells[((phase.x >= low) & (phase.x <= high))[:, at].all(axis=1)]
        return float(of(self.lengths[inside, d])) if len(inside) else 0.0

    @property
    def end(self):
        return float(self.control.get("endTime", math.nan))

    def g(self):
        """Gravity [m/s2]; zero without its file, or where it is no list of numbers."""
        g = self._may(GRAVITY).get("value", [])
        numbers = isinstance(g, list) and all(isinstance(v, (int, float)) for v in g)
        return np.array(g if numbers and len(g) == 3 else (0, 0, 0), float)

    def conditions(self, field):
        """Patches: the dictionary of their condition, by name, group or pattern."""
        return checkPatches.conditions(self.boundary(field), self.groups)

    def boundary(self, field):
        return checkPatches.boundary(self.case, field)

    def sides(self):
        """Patches that have the same type and conditions: (names, words) of each kind."""
        fields = [f"0/U.{f}" for f in dict.fromkeys(
            str(self.of(n).get("velocityField", n)) for n in self.phases)]
        fields += ["0/" + f for f in ("U", *(f"U.{n}" for n in self.media), "p")]
        given = {f[2:]: self.conditions(f) for f in fields if os.path.exists(self.case.file(f))}
        kinds = {}
        for patch, kind in self.patches.items():
            words = [f"{field} {of[patch].get('type')}" for field, of in given.items()
                     if patch in of and of[patch].get("type") != kind]
            kinds.setdefault(", ".join([kind, *words]), []).append(patch)
        return [(", ".join(names), words) for words, names in kinds.items()]

    def number(self, name, default):
        """A number of fvSolution.materialPoints."""
        value = self.solution.get(name, default)
        return value if isinstance(value, (int, float)) else default


def _gasConstant(of):
    """R [J/kg/K] of a phase; 0 of none."""
    return of.get("R") or (8314.46/of["molWeight"] if of.get("molWeight") else 0.0)


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


def cells(case, x):
    """Volume [m3], middle, number of faces of each cell, and its extents along x, y, z [m]: faces
    as triangles about the mean of their corners, so that the sum of all volumes is the mesh's."""
    corners, n = readLists(case.file("constant/polyMesh/faces"), flat=True)
    owner = readLists(case.file("constant/polyMesh/owner"))
    neighbour = readLists(case.file("constant/polyMesh/neighbour"))
    start = np.append(0, np.cumsum(n)[:-1])
    then = np.arange(1, len(corners) + 1)
    then[start + n - 1] = start
    origin = x.mean(axis=0)
    x = x - origin
    a, b = x[corners], x[corners[then]]
    middle = np.add.reduceat(a, start)/n[:, None]
    of = np.repeat(middle, n, axis=0)
    part = ((np.cross(a - of, b - of)/6)*(a + b + of)/3).sum(axis=1)
    through = np.add.reduceat(part, start)
    inner, nCells = len(neighbour), owner.max() + 1
    sides = np.bincount(owner, minlength=nCells) + np.bincount(neighbour, minlength=nCells)
    V = np.bincount(owner, through, nCells) - np.bincount(neighbour, through[:inner], nCells)
    centres = np.stack([np.bincount(owner, m, nCells) + np.bincount(neighbour, m[:inner], nCells)
                        for m in middle.T], axis=1)/sides[:, None]
    faces = np.concatenate((np.arange(len(owner)), np.arange(inner)))
    faces = faces[np.argsort(np.concatenate((owner, neighbour)), kind="stable")]
    first = np.append(0, np.cumsum(sides)[:-1])
    low, high = (of.reduceat(of.reduceat(a, start)[faces], first)
                 for of in (np.minimum, np.maximum))
    return V, centres + origin, sides, high - low


def patchPoints(case, x, patches):
    """Corners of the faces of some patches."""
    faces = readLists(case.file("constant/polyMesh/faces"))
    return {name: x[np.unique(np.concatenate(faces[start:start + n]))]
            for name, (start, n) in patchFaces(case).items() if n and name in patches}


def patchFaces(case):
    """Patches: first face and number of faces."""
    with open(case.file("constant/polyMesh/boundary"), "rb") as f:
        rows = re.findall(r"(\S+)\s*\{[^}]*?nFaces\s+(\d+);\s*startFace\s+(\d+);",
                          f.read().decode("latin-1"))
    return {name: (int(start), int(n)) for name, n, start in rows}
