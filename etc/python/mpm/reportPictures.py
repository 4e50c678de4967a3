"""Pictures of a case at chosen times for mpm.report: those of its view.py, or of an automatic
choice: points by plastic strain, damage, stress or speed, a gas by pressure, fluids by the
share of the first; in 3D the outer points seen from the side and a section of the gas.

    for picture in pictures(case, 12): ...      # picture.title, picture.frames [(time, image)]
"""

import base64
import io
import os
import re

import numpy as np
import PIL.Image

from mpm import animate, views
from mpm.case import Case
from mpm.pictures import (BODY, GAS, SIGNED, VALUES, Normalize, PolyCollection, ScalarMappable,
                          _pixels, colourBar, drawPoints, frame, layOut, plt)

#: Dots per inch of the pictures
DPI = 110
#: Bytes of all pictures of a page, as text
ROOM = 1900000


class Picture:
    """What is drawn: a title and a function that gives the figure of a time."""

    def __init__(self, title, times, draw, close):
        self.title, self.times, self.draw, self.close = title, times, draw, close
        self.frames = []


def encode(figure):
    """A figure as text for a page: PNG of 128 colours or JPEG, whatever is smaller."""
    figure.canvas.draw()
    image = PIL.Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3])
    best = b""
    for kind, picture, options in (
            ("png", image.quantize(128, dither=PIL.Image.Dither.NONE), {"optimize": True}),
            ("jpeg", image, {"quality": 82, "optimize": True})):
        buffer = io.BytesIO()
        picture.save(buffer, kind, **options)
        text = f"data:image/{kind};base64,".encode() + base64.b64encode(buffer.getvalue())
        best = min((best or text), text, key=len)
    return best.decode()


def choose(times, n):
    """n of the times, evenly, with the first and the last."""
    if len(times) <= n:
        return list(times)
    values = np.array([float(t) for t in times])
    wanted = np.linspace(values[0], values[-1], n)
    return [times[i] for i in sorted({int(abs(values - w).argmin()) for w in wanted})]


def writtenTimes(case):
    """Names of the time folders of the case or, where it has none but the start, of its first
    processor."""
    times = case.times()
    if len(times) < 2 and case.processors():
        times = Case(case.processors()[0]).times()
    return times


# --- what view.py describes --------------------------------------------------------

def viewsOf(case):
    """(name, view, folder) of view.py in the case, or beside it of this case."""
    found = []
    path = os.path.realpath(case.path)
    for folder in (path, os.path.dirname(path)):
        if os.path.exists(os.path.join(folder, "view.py")):
            found = [(name, view, folder) for name, view in views.readViews(folder).items()
                     if os.path.realpath(os.path.join(folder, view.get("case", "."))) == path]
        if found:
            break
    return found


def described(case):
    """Pictures of the views; a line for each that has no times."""
    for name, view, folder in viewsOf(case):
        try:
            drawing = animate.Drawing(view, folder)
        except SystemExit as error:
            yield str(error)
            continue
        drawing.figure.set_dpi(DPI)
        if "profile" not in view:
            drawing.pixels = [4*n//5 for n in drawing.pixels]
        yield Picture(name, drawing.times, drawing.draw,
                      lambda d=drawing: plt.close(d.figure))


# --- the automatic choice ------------------------------------------------------------

def scale(size):
    """Factor and prefix of the unit for lengths or times up to this one."""
    for factor, prefix in ((1, ""), (1e3, "m"), (1e6, "u")):
        if size*factor >= 1:
            return factor, prefix
    return (1e9, "n") if size > 0 else (1, "")


class Scene:
    """Mesh, phases and columns of a case that has been run."""

    def __init__(self, case, dictionary):
        self.case, self.times = case, writtenTimes(case)
        pieces = [case] if os.path.exists(case.file("constant/polyMesh/points")) else \
            [Case(p) for p in case.processors()]
        edges = [p.edges() for p in pieces]
        self.box = np.array([[min(e[i][0] for e in edges), max(e[i][-1] for e in edges)]
                             for i in range(3)])
        self.flat = self.flatDirections(pieces[0])
        self.gas = [n for n, d in dictionary.items() if isinstance(d, dict)
                    and d.get("type") in ("gas", "fluid")]
        self.fluids = any(d.get("type") == "fluid" for d in dictionary.values()
                          if isinstance(d, dict))
        self.rigid = [n for n, d in dictionary.items() if isinstance(d, dict)
                      and d.get("type") == "rigid"]
        last = self.times[-1] if self.times else "0"
        folders = [case.file(last, "lagrangian")] + [
            os.path.join(p, last, "lagrangian") for p in case.processors()]
        self.phases = sorted({n for f in folders if os.path.isdir(f) for n in os.listdir(f)})
        used = [a for a in range(3) if a not in self.flat]
        self.axes = (used + [a for a in self.flat if a not in used])[:2]
        self.nDim = len(used)

    def flatDirections(self, case):
        """Directions without extent: of empty patches and wedges."""
        with open(case.file("constant/polyMesh/boundary"), errors="replace") as f:
            kinds = set(re.findall(r"\btype\s+(empty|wedge)", f.read()))
        if not kinds:
            return []
        n = [len(e) for e in case.edges()]
        size = np.ptp(self.box, axis=1)
        # One layer of cells; of a wedge the direction in which the sector is thin
        flat = [a for a in range(3) if n[a] == 2]
        if "wedge" in kinds:
            flat.append(min((a for a in range(3) if a not in flat), key=lambda a: size[a]))
        return flat

    def cloud(self, time, phase):
        """The points of a phase, None where there are none."""
        cloud = self.case.points(time, phase)
        return cloud if "x" in cloud and len(cloud["x"]) else None


#: What points are coloured by: column, label, colours, expression; the first that has values
COLUMNS = (("plasticStrain", "plastic strain", VALUES, lambda v: v),
           ("damage", "damage", "DAMAGE", lambda v: v),
           ("sigmaEq", "von Mises stress", VALUES, lambda v: v),
           ("pPoint", "pressure", SIGNED, lambda v: v),
           ("U", "speed", VALUES, lambda v: np.linalg.norm(v, axis=1)))
UNITS = {"sigmaEq": "Pa", "pPoint": "Pa", "p": "Pa", "U": "m/s"}


def span(parts):
    """Limits of colours: without the outermost 0.5 % of the values."""
    found = [np.percentile(v, (0.5, 99.5)) for v in parts if len(v)]
    found = [f for f in found if np.isfinite(f).all()]
    return (min(f[0] for f in found), max(f[1] for f in found)) if found else (0.0, 0.0)


def columnOf(scene, times):
    """What shows most of the points: (column, label, colours, function, limits)."""
    for column, label, colours, function in COLUMNS:
        parts = []
        for time in times:
            for phase in scene.phases:
                cloud = scene.cloud(time, phase)
                if phase not in scene.rigid and cloud is not None and column in cloud:
                    parts.append(function(cloud[column]))
        low, high = span(parts)
        if column == "damage" and parts and not any(
                ((v > 0.02) & (v < 0.98)).mean() > 0.02 for v in parts if len(v)):
            continue        # sound or failed, nothing between: that has a colour of its own
        if UNITS.get(column) == "Pa" and max(abs(low), abs(high)) < 1e-3:
            continue        # rounding
        if high > low:
            if column == "pPoint":
                low, high = -max(-low, high), max(-low, high)
            if column in ("plasticStrain", "sigmaEq", "U", "damage"):
                low = 0.0
            return column, label, colours, function, (low, high)
    return None


def unitOf(column, limits):
    """Factor and unit of a column's values."""
    unit = UNITS.get(column, "")
    size = max(abs(v) for v in limits)
    if unit == "Pa":
        for factor, name in ((1e-9, "GPa"), (1e-6, "MPa"), (1e-3, "kPa")):
            if size*factor >= 1:
                return factor, name
    return 1, unit


class Section:
    """Values on the cells of a mesh of any kind, cut by the plane through its middle. VTK
    reads the case, put together or not, with the mesh of each time."""

    def __init__(self, scene, normal):
        from vtkmodules.vtkCommonDataModel import vtkPlane
        from vtkmodules.vtkFiltersCore import vtkCutter
        from vtkmodules.vtkIOParallel import vtkPOpenFOAMReader
        self.reader = vtkPOpenFOAMReader()
        whole = len(scene.case.times()) > 1 or not scene.case.processors()
        self.reader.SetCaseType(1 if whole else 0)
        self.reader.SetFileName(scene.case.file("system/controlDict"))
        self.reader.CreateCellToPointOff()
        self.reader.DecomposePolyhedraOff()
        self.reader.UpdateInformation()
        self.reader.DisableAllLagrangianArrays()
        self.reader.DisableAllPointArrays()
        self.reader.DisableAllPatchArrays()
        self.reader.SetPatchArrayStatus("internalMesh", 1)
        plane = vtkPlane()
        plane.SetOrigin(*(scene.box.mean(axis=1) + 1e-7*np.ptp(scene.box, axis=1)))
        plane.SetNormal(*(float(a == normal) for a in range(3)))
        self.cutter = vtkCutter()
        self.cutter.SetCutFunction(plane)
        self.cutter.GenerateTrianglesOff()
        self.times = self.reader.GetTimeValues()

    def cells(self, time, field):
        """Polygons [corner, 3] and values of the cells at a time."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        values = [self.times.GetValue(i) for i in range(self.times.GetNumberOfTuples())]
        self.reader.DisableAllCellArrays()
        self.reader.SetCellArrayStatus(field, 1)
        near = min(values, key=lambda t: abs(t - float(time)))
        self.reader.UpdateTimeStep(near)
        corners, found = [], []

        def take(data):
            if hasattr(data, "GetNumberOfBlocks"):
                for i in range(data.GetNumberOfBlocks()):
                    if data.GetBlock(i) is not None:
                        take(data.GetBlock(i))
                return
            self.cutter.SetInputData(data)
            self.cutter.Update()
            cut = self.cutter.GetOutput()
            array = cut.GetCellData().GetArray(field)
            if array is None or not cut.GetNumberOfCells():
                return
            x = vtk_to_numpy(cut.GetPoints().GetData())
            for i in range(cut.GetNumberOfCells()):
                ids = cut.GetCell(i).GetPointIds()
                corners.append(x[[ids.GetId(j) for j in range(ids.GetNumberOfIds())]])
            found.append(vtk_to_numpy(array))
        take(self.reader.GetOutput())
        return corners, np.concatenate(found) if found else np.zeros(0)


def gasField(scene):
    """Field and label of a gas or fluids: the share of the first liquid, or the pressure."""
    if not scene.gas:
        return None
    if scene.fluids and len(scene.gas) > 1:
        return f"alpha.{scene.gas[0]}", f"share of {scene.gas[0]}"
    return "p", "pressure of the gas"


class Automatic:
    """Figures of a scene in 2D or 3D, points over a section of the gas."""

    def __init__(self, scene, times):
        self.scene, self.times = scene, times
        self.column = columnOf(scene, times) if scene.phases else None
        self.gas = gasField(scene)
        self.section, self.gasLimits = None, None
        self.far = scene.nDim == 3
        if self.gas and scene.nDim > 1:
            out = [a for a in range(3) if a not in scene.axes][0]
            self.section = Section(scene, out)
            self.gasLimits = span([self.section.cells(t, self.gas[0])[1] for t in times])
            low, high = self.gasLimits
            if high - low < 1e-6*max(abs(low), abs(high)) or high == low:
                self.gasLimits = low - 0.01*(abs(low) or 1), high + 0.01*(abs(high) or 1)
        self.length = scale(np.ptp(scene.box, axis=1).max())
        self.time = scale(float(times[-1]) if times else 0)
        self.layOut()

    def title(self):
        words = []
        if self.column and self.column[0] != "none":
            words.append(f"points by {self.column[1]}")
        if self.gas:
            words.append(self.gas[1])
        return "automatic choice: " + ", ".join(words or ["points"])

    def layOut(self):
        a, b = self.scene.axes
        factor, prefix = self.length
        self.box = factor*self.scene.box[[a, b]].ravel()
        if self.scene.nDim == 1:
            self.figure, self.ax = plt.subplots(figsize=(6, 3.2))
        else:
            height = (self.box[3] - self.box[2])/(self.box[1] - self.box[0])
            width = 6.0 if height < 2 else 4.0
            self.figure, self.ax = plt.subplots(
                figsize=(width, min(6.5, max(2.0, (width - 1.8)*height + 0.75))))
            frame(self.ax, self.box[:2], self.box[2:], *self.labels(), title=" ")
            self.bars()
        self.figure.set_dpi(DPI)
        layOut(self.figure)
        self.figure.set_layout_engine("none")
        self.pixels = [3*n//5 for n in _pixels(self.ax, self.box)]

    def labels(self):
        prefix = self.length[1]
        return [f"{'xyz'[i]} [{prefix}m]" for i in self.scene.axes]

    def colours(self, column):
        from mpm import pictures
        return getattr(pictures, column[2]) if isinstance(column[2], str) else column[2]

    def bars(self):
        if self.column:
            factor, unit = unitOf(self.column[0], self.column[4])
            limits = [factor*v for v in self.column[4]]
            self.bar(self.colours(self.column), limits, self.column[1], unit)
        if self.gasLimits:
            factor, unit = unitOf(self.gas[0], self.gasLimits)
            self.bar("Blues_r" if self.column else VALUES,
                     [factor*v for v in self.gasLimits], self.gas[1], unit)

    def bar(self, cmap, limits, label, unit):
        colourBar(self.figure, ScalarMappable(Normalize(*limits), cmap), self.ax,
                  label + (f" [{unit}]" if unit else ""), shrink=0.9, aspect=22)

    def draw(self, time):
        self.ax.clear()
        if self.scene.nDim == 1:
            self.profile(time)
        else:
            frame(self.ax, self.box[:2], self.box[2:], *self.labels())
            if self.section:
                corners, values = self.section.cells(time, self.gas[0])
                some = [self.length[0]*c[:, self.scene.axes] for c in corners]
                self.ax.add_collection(PolyCollection(
                    some, array=values, cmap="Blues_r" if self.column else VALUES,
                    norm=Normalize(*self.gasLimits), edgecolors="face", linewidths=0.3,
                    rasterized=True, zorder=GAS))
            for phase in self.scene.phases:
                self.points(time, phase)
        self.ax.set_title(f"{self.time[0]*float(time):.4g} {self.time[1]}s")
        return self.figure

    def values(self, cloud, phase):
        if self.column is None or phase in self.scene.rigid or self.column[0] not in cloud:
            return BODY
        return self.column[3](cloud[self.column[0]])

    def points(self, time, phase):
        cloud = self.scene.cloud(time, phase)
        if cloud is None:
            return
        values = self.values(cloud, phase)
        failed = cloud["damage"] >= 0.98 if "damage" in cloud and self.column and \
            self.column[0] != "damage" else None
        some = nearest(cloud, self.scene.axes) if self.far else None
        section = None if "halfSize" in cloud else self.thickness()
        drawPoints(self.ax, cloud, values, self.colours(self.column) if self.column else VALUES,
                   self.column[4] if self.column else None, failed, some,
                   scale=self.length[0], axes=tuple(self.scene.axes), section=section,
                   pixels=self.pixels)

    def thickness(self):
        """Of the mesh, across the picture; of points in 3D their own."""
        out = [a for a in range(3) if a not in self.scene.axes][0]
        return float(np.ptp(self.scene.box[out]))

    def profile(self, time):
        """Values over the one direction of a case in 1D."""
        a, factor = self.scene.axes[0], self.length[0]
        size, unit = unitOf(self.column[0], self.column[4]) if self.column else (1, "")
        for phase in self.scene.phases:
            cloud = self.scene.cloud(time, phase)
            values = self.values(cloud, phase) if cloud is not None else BODY
            if not isinstance(values, str):
                self.ax.plot(factor*cloud["x"][:, a], size*values, ".", ms=4, label=phase)
        if self.column:
            low, high = (size*v for v in self.column[4])
            self.ax.set(ylabel=f"{self.column[1]} [{unit}]", ylim=(
                low - 0.05*(high - low), high + 0.05*(high - low)))
        self.ax.set(xlabel=self.labels()[0], xlim=self.box[:2])
        if self.gas:
            self.gasProfile(time, self.ax if not self.column else self.twin())
        if self.column:
            self.ax.legend(loc="upper right")

    def twin(self):
        for other in self.figure.axes[1:]:
            other.remove()
        return self.ax.twinx()

    def gasProfile(self, time, ax):
        values = np.atleast_1d(self.scene.case.field(time, "p"))
        edges = self.length[0]*self.scene.case.edges()[self.scene.axes[0]]
        if len(values) in (1, len(edges) - 1):
            ax.plot(0.5*(edges[1:] + edges[:-1]), np.broadcast_to(values, len(edges) - 1)*1e-5,
                    "C0", lw=1.2)
            ax.set_ylabel("pressure of the gas [bar]")


def nearest(cloud, axes):
    """Points in 3D that one sees: of each column of points across the picture the nearest."""
    out = [a for a in range(3) if a not in axes][0]
    x = cloud["x"]
    size = 2*np.cbrt(np.median(cloud["V"]))
    place = np.floor(x[:, axes]/size*2).astype(int)
    order = np.argsort(x[:, out])
    key = place[order, 0]*2**31 + place[order, 1]
    _, last = np.unique(key[::-1], return_index=True)
    mask = np.zeros(len(x), bool)
    mask[order[::-1][last]] = True
    return mask


# --- all of them ---------------------------------------------------------------------

def pictures(case, dictionary, n, known=None, notes=None):
    """Pictures with n frames at most, of a case without written times none. known: frames of
    an earlier call by (title, time), which are not drawn again; notes: what is said of
    pictures that cannot be made."""
    known, notes = {} if known is None else known, [] if notes is None else notes
    found = []
    for one in described(case):
        if isinstance(one, str):
            notes.append(one)
        else:
            found.append(one)
    if not found and writtenTimes(case):
        try:
            scene = Scene(case, dictionary)
            times = [t for t in choose(scene.times, n)
                     if scene.phases and any(scene.cloud(t, p) for p in scene.phases)
                     or hasField(case, t, gasField(scene))]
            if times:
                automatic = Automatic(scene, times)
                found.append(Picture(automatic.title(), times, automatic.draw,
                                     lambda: plt.close(automatic.figure)))
        except Exception as error:      # a page without pictures is better than none
            notes.append(f"no automatic picture: {type(error).__name__}: {error}")
    for picture in found:
        for time in choose(picture.times, n):
            key = picture.title, time
            if key not in known:
                try:
                    known[key] = encode(picture.draw(time))
                except Exception as error:
                    notes.append(f"no picture {picture.title} of time {time}:"
                                 f" {type(error).__name__}: {error}")
                    continue
            picture.frames.append((float(time), known[key]))
        picture.close()
    room(found, notes)
    return [p for p in found if p.frames]


def hasField(case, time, field):
    return field is not None and any(
        os.path.exists(os.path.join(d, time, field[0]))
        for d in [case.path, *case.processors()])


def room(found, notes):
    """Every second frame is left out until all pictures fit on the page."""
    while sum(len(image) for p in found for _, image in p.frames) > ROOM and any(
            len(p.frames) > 2 for p in found):
        for picture in found:
            if len(picture.frames) > 2:
                picture.frames = picture.frames[::-2][::-1]
        if not any("left out" in note for note in notes):
            notes.append("pictures of some times are left out, so that the page stays small")
