"""Pictures of a case at chosen times for mpm.report: those of its view.py, or of an automatic
choice: points by plastic strain, damage, stress or speed, a gas by pressure, two fluids by the
share of the first, more by mixed colours, and fluids once more by their pressure; in 3D outer
points from the side, a section of a gas. Small bodies in a large mesh are shown once more, large.

    for picture in pictures(case, 12): ...      # picture.title, picture.frames [(time, image)]
"""

import base64
import io
import os
import re

import numpy as np
import PIL.Image
import PIL.features

from mpm import animate, views
from mpm.case import Case
from mpm.pictures import (BODY, GAS, VALUES, ListedColormap, Normalize, PolyCollection,
                          ScalarMappable, _pixels, colourBar, drawPoints, frame, layOut, plt)
from mpm.reportColours import (FAILED, PRESSURE, columnOf, fluidColours, gasField, joined, span,
                               unitOf)
from mpm.reportSection import Section

#: Dots per inch of the pictures
DPI = 110
#: Bytes of all pictures of a page, as text
ROOM = 1900000


class Picture:
    """What is drawn: a title and a function that gives the figure of a time. coloured: by
    values, not by materials alone."""

    def __init__(self, title, times, draw, close, coloured=True):
        self.title, self.times, self.draw, self.close = title, times, draw, close
        self.coloured, self.frames = coloured, []


def encode(figure):
    """A figure as text for a page, all colours as they are drawn: WebP without loss, or where
    Pillow has none PNG, twice as large."""
    figure.canvas.draw()
    image = PIL.Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3])
    kind, options = ("webp", {"lossless": True}) if PIL.features.check("webp") else \
        ("png", {"optimize": True})
    buffer = io.BytesIO()
    image.save(buffer, kind, **options)
    return f"data:image/{kind};base64,{base64.b64encode(buffer.getvalue()).decode()}"


def choose(times, n):
    """n of the times or some fewer, evenly, with the first and the last."""
    if len(times) <= n:
        return list(times)
    values = np.array([float(t) for t in times])
    steps = np.diff(values)
    if n > 2 and np.ptp(steps) < 0.01*steps.mean():
        # The same number of written times between two, if one fits
        last = len(times) - 1
        each = next((last//m for m in range(n - 1, n//2, -1) if last % m == 0),
                    -(-last//(n - 1)))
        return [*times[:1], *times[last % each or each::each]]
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
    if len(case.times()) < 2 and case.processors():
        return              # they want a whole case
    try:
        found = viewsOf(case)
    except (Exception, SystemExit) as error:
        yield f"view.py: {error}"
        return
    for name, view, folder in found:
        try:
            drawing = animate.Drawing(view, folder)
        except (Exception, SystemExit) as error:
            yield f"view.py, {name}: {error}"
            continue
        drawing.figure.set_dpi(DPI)
        if "profile" not in view:
            drawing.exact = True
            drawing.pixels = _pixels(drawing.ax, drawing.box, exact=True)
        yield Picture(name, drawing.times, drawing.draw,
                      lambda d=drawing: plt.close(d.figure),
                      any("field" in layer for layer in views.layers(view)))


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
        self.mixed = fluidColours(dictionary)
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

    def normal(self):
        """The first direction that the pictures leave out."""
        return [a for a in range(3) if a not in self.axes][0]

    def shows(self, time):
        """Are there points, or the field of the gas?"""
        field = gasField(self)
        return any(self.cloud(time, p) is not None for p in self.phases) or bool(
            field and any(os.path.exists(os.path.join(d, time, field[0]))
                          for d in (self.case.path, *self.case.processors())))

    def hasPressure(self):
        """Are the fluids drawn by their shares, and their pressure written?"""
        field = gasField(self)
        return bool(field and field[0] != PRESSURE[0] and any(
            os.path.exists(os.path.join(d, self.times[-1], PRESSURE[0]))
            for d in (self.case.path, *self.case.processors())))

    def cloud(self, time, phase):
        """The points of a phase, None where there are none."""
        cloud = self.case.points(time, phase)
        return cloud if "x" in cloud and len(cloud["x"]) else None

    def around(self, times):
        """A box about the points that can deform, None where it is half as long as the mesh or
        longer in a direction of the pictures."""
        found = [self.cloud(t, p) for t in times for p in self.phases if p not in self.rigid]
        if self.nDim < 2 or all(c is None for c in found):
            return None
        x = np.concatenate([c["x"] for c in found if c is not None])
        low, high = x.min(axis=0), x.max(axis=0)
        sizes = np.ptp(self.box, axis=1)[self.axes]
        margin = max(0.1*(high - low)[self.axes].max(), 0.01*sizes.max())
        box = np.clip(np.stack([low - margin, high + margin], axis=1), *self.box.T[:, :, None])
        return box if (np.ptp(box, axis=1)[self.axes] < 0.5*sizes).all() else None


class Automatic:
    """Figures of a scene in 2D or 3D, points over a section of the gas; pressure: bodies over
    that of the fluids; near: the part of the mesh that is shown."""

    def __init__(self, scene, times, others, pressure=False, near=None):
        self.scene, self.times, self.near = scene, times, near
        some = choose(times, 5)         # for the limits of colours
        self.column = columnOf(scene, some) if scene.phases and not pressure else None
        if self.column:
            self.column = (*self.column[:4], joined(self.column[4], others, self.column[0]))
        self.gas = PRESSURE if pressure else gasField(scene)
        self.mixed = {} if pressure else scene.mixed
        self.section, self.gasLimits = None, None
        self.seen = Oblique(scene) if scene.nDim == 3 and not self.gas else None
        if self.gas:
            self.section = Section(scene, scene.normal())
        if self.gas and not self.mixed:
            self.gasLimits = joined(gasRange(scene, self.section, self.gas[0], some), others,
                                    self.gas[0])
            low, high = self.gasLimits
            if high - low < 1e-6*max(abs(low), abs(high)) or high == low:
                self.gasLimits = low - 0.01*(abs(low) or 1), high + 0.01*(abs(high) or 1)
        self.part = scene.box if near is None else near
        self.length = scale(np.ptp(self.part, axis=1).max())
        self.time = scale(float(times[-1]) if times else 0)
        self.layOut()

    def title(self):
        words = []
        if self.column:
            words.append(f"points by {self.column[1]}")
        if self.gas:
            words.append(self.gas[1])
        failed = any("damage" in c for c in (
            self.scene.cloud(self.times[-1], p) for p in self.scene.phases) if c is not None)
        choice = "automatic choice (your own: a view.py in the case): "
        if self.near is not None:
            choice += "the part with the bodies, "
        return choice + ", ".join(words or ["points"]) + (
            f" ({FAILED}: failed)" if failed and self.column and self.column[0] != "damage"
            else "")

    def layOut(self):
        a, b = self.scene.axes
        factor = self.length[0]
        self.box = factor*self.part[[a, b]].ravel()
        if self.scene.nDim == 1:
            n = max(1, bool(self.column) + bool(self.gas))
            self.figure, axes = plt.subplots(n, figsize=(6, 1.2 + 1.9*n), sharex=True,
                                             squeeze=False)
            self.figure.set_dpi(DPI)
            self.all = axes[:, 0]
            return
        if self.seen:
            ends = factor*self.seen.project(self.seen.corners())[:, :2]
            low, high = ends.min(axis=0), ends.max(axis=0)
            self.box = np.stack([low, high], axis=1).ravel()
        height = (self.box[3] - self.box[2])/(self.box[1] - self.box[0])
        width = 6.0 if height < 2 else 4.0
        self.figure, self.ax = plt.subplots(
            figsize=(width, min(6.5, max(2.0, (width - 1.8)*height + 0.75))))
        frame(self.ax, self.box[:2], self.box[2:], *self.labels(), title=" ")
        self.bars()
        self.figure.set_dpi(DPI)
        layOut(self.figure)
        self.figure.set_layout_engine("none")
        self.pixels = _pixels(self.ax, self.box, exact=True)

    def labels(self):
        prefix = self.length[1]
        return [f"{'xyz'[i]} [{prefix}m]" for i in self.scene.axes]

    def colours(self, column):
        from mpm import pictures
        return getattr(pictures, column[2]) if isinstance(column[2], str) else column[2]

    def gasColours(self):
        """Under points of colour blue: of a share of a liquid dark where it is."""
        if not self.column:
            return VALUES
        return "Blues" if self.gas[0].startswith("alpha.") else "Blues_r"

    def bars(self):
        if self.column:
            factor, unit = unitOf(self.column[0], self.column[4])
            limits = [factor*v for v in self.column[4]]
            self.bar(self.colours(self.column), limits, self.column[1], unit)
        if self.mixed:
            self.legend()
        elif self.gasLimits:
            factor, unit = unitOf(self.gas[0], self.gasLimits)
            self.bar(self.gasColours(), [factor*v for v in self.gasLimits], self.gas[1], unit)

    def legend(self):
        """Of more than two fluids: a bar with their names."""
        of = self.mixed
        self.bar(ListedColormap([*of.values()]), (0, len(of)), self.gas[1], "").set_ticks(
            np.arange(len(of)) + 0.5, labels=of)

    def bar(self, cmap, limits, label, unit):
        return colourBar(self.figure, ScalarMappable(Normalize(*limits), cmap), self.ax,
                         label + (f" [{unit}]" if unit else ""), shrink=0.9, aspect=22)

    def draw(self, time):
        title = f"{self.time[0]*float(time):.4g} {self.time[1]}s"
        if self.scene.nDim == 1:
            self.profile(time)
            self.all[0].set_title(title)
            return self.figure
        self.ax.clear()
        frame(self.ax, self.box[:2], self.box[2:], *self.labels(), title=title)
        if self.seen:
            self.seen.frame(self.ax, *self.length)
        if self.section:
            if self.mixed:
                corners, values = self.section.mixture(time, self.mixed)
                paint = {"facecolors": values}
            else:
                corners, values = self.section.cells(time, self.gas[0])
                paint = dict(array=values, cmap=self.gasColours(), norm=Normalize(*self.gasLimits))
            self.ax.add_collection(PolyCollection(
                [self.length[0]*c[:, self.scene.axes] for c in corners], **paint,
                edgecolors="face", linewidths=0.3, rasterized=True, zorder=GAS))
        for phase, cloud, some in self.clouds(time):
            self.points(phase, cloud, some)
        return self.figure

    def clouds(self, time):
        """(phase, cloud, mask of the points that are drawn); in 3D those that are seen, or
        those of the section."""
        found = [(p, self.scene.cloud(time, p)) for p in self.scene.phases]
        found = [(p, c) for p, c in found if c is not None]
        if self.scene.nDim < 3:
            return [(p, c, None) for p, c in found]
        if not self.seen:
            out = self.section.normal
            return [(p, c, abs(c["x"][:, out] - self.section.place) < 0.6*np.cbrt(c["V"]))
                    for p, c in found]
        flat = [Flat(c, self.seen) for _, c in found]
        masks = visible(flat)
        return [(p, c, m) for (p, _), c, m in zip(found, flat, masks)]

    def values(self, cloud, phase):
        if self.column is None or phase in self.scene.rigid or self.column[0] not in cloud:
            return BODY
        return self.column[3](cloud[self.column[0]])

    def points(self, phase, cloud, some):
        if some is not None and not some.any():
            return
        values = self.values(cloud, phase)
        failed = cloud["damage"] >= 0.98 if "damage" in cloud and self.column and \
            self.column[0] != "damage" else None
        if self.scene.nDim == 3:
            section = np.cbrt(cloud["V"])       # boxes as wide as they are deep
        else:
            out = [a for a in range(3) if a not in self.scene.axes][0]
            section = None if "halfSize" in cloud else float(np.ptp(self.scene.box[out]))
        cmap = self.colours(self.column) if self.column else VALUES
        drawPoints(self.ax, cloud, values, cmap,
                   self.column[4] if self.column else None, failed, some,
                   scale=self.length[0], axes=(0, 1) if self.seen else tuple(self.scene.axes),
                   section=section, pixels=self.pixels, close=1.0 if self.seen else 0.5,
                   failedColour=FAILED, exact=True)

    def profile(self, time):
        """Values over the one direction of a case in 1D: of points, and of the gas."""
        a, factor = self.scene.axes[0], self.length[0]
        for ax in self.all:
            ax.clear()
        if self.column:
            size = unitOf(self.column[0], self.column[4])
            self.label(self.all[0], self.column[1], self.column[4], *size)
            for phase in self.scene.phases:
                cloud = self.scene.cloud(time, phase)
                values = self.values(cloud, phase) if cloud is not None else BODY
                if not isinstance(values, str):
                    self.all[0].plot(factor*cloud["x"][:, a], size[0]*values, ".", ms=4,
                                     label=phase)
            if self.all[0].lines:
                self.all[0].legend(loc="upper right")
        if self.gas:
            limits = self.gasLimits or (0, 1)
            size = unitOf(self.gas[0], limits)
            self.label(self.all[-1], self.gas[1], limits, *size)
            for field in [f"alpha.{n}" for n in self.mixed] or [self.gas[0]]:
                corners, values = self.section.cells(time, field)
                x = np.array([c[:, a].mean() for c in corners])
                order = np.argsort(x)
                self.all[-1].plot(factor*x[order], size[0]*values[order], lw=1.2, label=field[6:])
            if self.mixed:
                self.all[-1].legend(loc="upper right")
        self.all[-1].set(xlabel=self.labels()[0], xlim=self.box[:2])

    @staticmethod
    def label(ax, label, limits, factor, unit):
        low, high = (factor*v for v in limits)
        ax.set(ylabel=label + (f" [{unit}]" if unit else ""),
               ylim=(low - 0.05*(high - low), high + 0.05*(high - low)))


class Oblique:
    """A scene in 3D as one sees it from the right, a little from above; up is against
    gravity, otherwise y."""

    def __init__(self, scene):
        up = np.array([0.0, 1, 0])
        if os.path.exists(scene.case.file("constant/g")):
            with open(scene.case.file("constant/g")) as f:
                value = re.search(r"value\s*\(([^)]*)\)", f.read())
            g = np.array(value[1].split(), float) if value else np.zeros(3)
            if g.any():
                up = np.eye(3)[abs(g).argmax()]*-np.sign(g[abs(g).argmax()])
        right = np.array([1.0, 0, 0]) if not up[0] else np.array([0, 1.0, 0])
        to = 0.45*right + 0.4*up + 0.8*np.cross(right, up)
        to /= np.linalg.norm(to)
        across = np.cross(up, to)/np.linalg.norm(np.cross(up, to))
        self.turn = np.stack([across, np.cross(to, across), to])
        self.box = scene.box

    def project(self, x):
        """Places across and up, and the distance towards the one who sees them."""
        return x @ self.turn.T

    def corners(self):
        return np.array([[self.box[a][i >> a & 1] for a in range(3)] for i in range(8)])

    def frame(self, ax, factor, prefix):
        """The mesh's box, its lower edges with their names and lengths."""
        ax.axis("off")
        x = factor*self.project(self.corners())[:, :2]
        for i in range(8):
            for a in range(3):
                if not i >> a & 1:
                    ax.plot(*x[[i, i | 1 << a]].T, color="0.75", lw=0.7, zorder=GAS)
        for a in range(3):
            ax.annotate(f"{'xyz'[a]} {factor*self.box[a][1]:.3g} {prefix}m", x[1 << a],
                        fontsize=8, color="0.35", ha="right", va="top")


class Flat:
    """A cloud as one sees it: x are its projected places."""

    def __init__(self, cloud, seen):
        self.cloud, self.x = cloud, seen.project(cloud["x"])

    def __getitem__(self, name):
        return self.x if name == "x" else self.cloud[name]

    def __contains__(self, name):
        return name != "halfSize" and name in self.cloud


def visible(clouds):
    """Masks of the points of all clouds that no other hides: those that are near the one
    that is nearest in their part of the picture."""
    if not clouds:
        return []
    x = np.concatenate([c.x for c in clouds])
    size = np.cbrt(np.median(np.concatenate([c["V"] for c in clouds])))
    place = np.floor((x[:, :2] - x[:, :2].min(axis=0))/size).astype(int)
    depth = np.full(place.max(axis=0) + 3, -np.inf)
    np.maximum.at(depth, tuple(place.T + 1), x[:, 2])
    around = np.max([depth[1 + i:depth.shape[0] - 1 + i, 1 + j:depth.shape[1] - 1 + j]
                     for i, j in ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))], axis=0)
    near = x[:, 2] > around[tuple(place.T)] - 2*size
    return np.split(near, np.cumsum([len(c.x) for c in clouds])[:-1])


# --- all of them ---------------------------------------------------------------------

def pictures(case, dictionary, n, known=None, notes=None, beside=()):
    """Pictures with n frames at most, of a case without written times none. known: frames of
    an earlier call by (title, time), which are not drawn again; notes: what is said of
    pictures that cannot be made; beside: (case, dictionary) of runs with the same range of
    colours."""
    known, notes = {} if known is None else known, [] if notes is None else notes
    found = []
    for one in described(case):
        if isinstance(one, str):
            notes.append(one)
        else:
            found.append(one)
            drawn(one, choose(one.times, n), known, notes)
    if not any(p.coloured and p.frames for p in found) and writtenTimes(case):
        try:
            scene = Scene(case, dictionary)
            times = choose([t for t in scene.times if scene.shows(t)], n)
            kinds = [(False, None)] + [(True, None)]*scene.hasPressure() if times else []
            near = scene.around(choose(times, 5)) if scene.nDim == 2 or scene.gas else None
            kinds += [(False, near)]*(near is not None)
            others = ranges(beside, n) if times else {}
            for pressure, near in kinds:
                automatic = Automatic(scene, times, others, pressure, near)
                found.append(Picture(automatic.title(), times, automatic.draw,
                                     lambda a=automatic: plt.close(a.figure)))
                drawn(found[-1], times, known, notes)
        except Exception as error:      # a page without pictures is better than none
            notes.append(f"no automatic picture: {type(error).__name__}: {error}")
    room(found, notes)
    return [p for p in found if p.frames]


def drawn(picture, times, known, notes):
    """The frames of a picture; of all errors one note."""
    wrong = []
    for time in times:
        key = picture.title, time
        if key not in known:
            try:
                known[key] = encode(picture.draw(time))
            except Exception as error:
                wrong.append(f"time {time}: {type(error).__name__}: {error}")
                continue
        picture.frames.append((float(time), known[key]))
    if wrong:
        notes.append(f"no picture {picture.title} of {len(wrong)} of {len(times)} times, first"
                     f" {wrong[0]}")
    picture.close()


def ranges(cases, n):
    """Limits of colours of other cases: {what: (low, high)}."""
    found = {}
    for case, dictionary in cases:
        if not writtenTimes(case):
            continue
        scene = Scene(case, dictionary)
        times = choose(choose([t for t in scene.times if scene.shows(t)], n), 5)
        column = columnOf(scene, times) if scene.phases else None
        if column:
            found[column[0]] = column[4]
        gas = gasField(scene)
        fields = [gas[0]] if gas and times and not scene.mixed else []
        fields += [PRESSURE[0]]*(bool(times) and scene.hasPressure())
        for field in fields:
            found[field] = gasRange(scene, Section(scene, scene.normal()), field, times)
    return found


def gasRange(scene, section, field, times):
    """Limits of the colours. A blast is far above what follows: three times what the middle one
    of the times has above the least is the end of it."""
    parts = [section.cells(t, field)[1] for t in times]
    low, high = span(parts)
    if field == PRESSURE[0] and len(parts) > 2:
        high = min(high, low + 3*float(np.median([span([p])[1] - low for p in parts])))
    return low, high


def room(found, notes):
    """Every second frame is left out until all pictures fit on the page."""
    while sum(len(image) for p in found for _, image in p.frames) > ROOM and any(
            len(p.frames) > 2 for p in found):
        for picture in found:
            if len(picture.frames) > 2:
                picture.frames = picture.frames[::-2][::-1]
        if not any("left out" in note for note in notes):
            notes.append("pictures of some times are left out, so that the page stays small")
