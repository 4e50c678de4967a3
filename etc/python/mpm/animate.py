"""Animations of a case's views (view.py, see mpm.views): <view>.gif with a frame for each
written time.

    "$MPM_PYTHON" -m mpm.animate [folder]       # Allrun -animate calls it
"""

import os
import re
import sys

import numpy as np

from mpm import pictures, views
from mpm.case import Case
from mpm.pictures import (GAS, RIGID, colourBar, drawPoints, frame, layOut, plt, polygons,
                          saveAnimation)


def shownTimes(case, view):
    """The times that have all clouds and fields of a view; of several phases of a layer
    one is enough, others may come and go."""
    def has(time):
        return all(
            any(os.path.exists(case.file(time, "lagrangian", p)) for p in layer["phases"])
            if "phases" in layer else
            all(os.path.exists(case.file(time, n)) for n in views.names(layer["field"]))
            for layer in views.layers(view))
    return [time for time in case.times() if has(time)]


def colours(layer):
    return getattr(pictures, layer.get("colours", "VALUES"))


def colour(layer):
    return views.COLOURS.get(layer["colour"], layer["colour"])


def norm(layer):
    kind = pictures.LogNorm if layer.get("log") else pictures.Normalize
    return kind(*layer["limits"])


class Drawing:
    """One view of a case on a figure; draw(time) shows another time of it. exact: as
    pictures.drawPoints."""
    exact = False

    def __init__(self, view, folder="."):
        self.view = view
        self.case = Case(os.path.join(folder, view.get("case", ".")))
        self.times = shownTimes(self.case, view)
        if not self.times:
            sys.exit(f"{self.case.path} has no times with what its view shows: run it first")
        self.edges = self.case.edges()
        self.nCells = self.case.nCells()
        self.factor, self.unit = view.get("length", (1, "m"))
        self.across, self.up = ("xyz".index(a) for a in view.get("axes", "xy"))
        width = view.get("size", 5.6)
        if "profile" in view:
            self.figure, self.ax = plt.subplots(figsize=(width, 0.55*width))
            return
        self.box = view.get("box") or [
            self.factor*self.edges[a][end] for a in (self.across, self.up) for end in (0, -1)]
        height = (self.box[3] - self.box[2])/(self.box[1] - self.box[0])
        bars = sum("field" in layer for layer in views.layers(view))
        self.figure, self.ax = plt.subplots(
            figsize=(width, max(1.6, (width - 0.7 - 0.9*bars)*height + 0.75)))
        self.limits()
        for layer in views.layers(view):
            if "field" in layer:
                colourBar(self.figure, pictures.ScalarMappable(norm(layer), colours(layer)),
                          self.ax, layer["label"], shrink=0.9 if height > 0.6 else 1,
                          aspect=22, extend="both" if layer.get("log") else "neither")
        layOut(self.figure)
        self.pixels = [n*3//4 for n in pictures._pixels(self.ax, self.box)]
        # Laid out once, for all frames
        self.figure.set_layout_engine("none")

    def limits(self):
        labels = (f"{'xyz'[a]} [{self.unit}]" for a in (self.across, self.up))
        frame(self.ax, self.box[:2], self.box[2:], *labels, title=" ")

    def draw(self, time):
        self.ax.clear()
        if "profile" in self.view:
            self.profile(time)
        else:
            self.limits()
            if "gas" in self.view:
                self.gas(time, self.view["gas"])
            if self.view.get("floor"):
                self.ax.axhspan(self.box[2], 0, color=RIGID, lw=0)
            for layer in self.view.get("points", ()):
                for phase in layer["phases"]:
                    self.points(time, phase, layer)
        factor, unit = self.view.get("time", (1, "s"))
        self.ax.set_title(f"{factor*float(time):.4g} {unit}")
        return self.figure

    def onCells(self, time, layer):
        """Values [row up, column across], for a mesh in the plane of x and y."""
        nx, ny = (len(e) - 1 for e in self.edges[:2])
        return views.evaluate(layer["field"],
                              lambda name: self.case.field(time, name, nx, ny))

    def gas(self, time, layer):
        nx, ny = (len(e) - 1 for e in self.edges[:2])
        if nx*ny != self.nCells:
            self.anyCells(time, layer)
            return
        values = self.onCells(time, layer)
        x, y = (self.factor*e for e in self.edges[:2])
        for sign in (1, -1) if "mirror" in self.view else (1,):
            signs = (1, sign) if self.view.get("mirror") == "up" else (sign, 1)
            self.ax.pcolormesh(signs[0]*x, signs[1]*y, values, cmap=colours(layer),
                               norm=norm(layer), rasterized=True, zorder=GAS)

    def anyCells(self, time, layer):
        """Values on the polygons of a mesh in the plane of x and y."""
        values = views.evaluate(layer["field"], lambda name: self.case.field(time, name))
        self.ax.add_collection(polygons(
            [self.factor*p for p in self.case.polygons()],
            np.broadcast_to(values, self.nCells), colours(layer), norm(layer)))

    def points(self, time, phase, layer):
        cloud = self.case.points(time, phase)
        if "x" not in cloud or not len(cloud["x"]):
            return
        failed = layer.get("failed")
        field = "field" in layer
        values = views.evaluate(layer["field"], cloud.__getitem__) if field else colour(layer)
        drawPoints(self.ax, cloud, values, colours(layer), layer.get("limits"),
                   cloud[failed[0]] >= failed[1] if failed else None, scale=self.factor,
                   axes=(self.across, self.up), mirror=self.view.get("mirror"),
                   close=layer.get("close", 0.5), outline=layer.get("outline"),
                   pixels=self.pixels, section=self.section(cloud, layer), exact=self.exact)

    def section(self, cloud, layer):
        """What the sides of points follow from that have no half-sizes: the layer's word, the
        thickness of a mesh in 2D, or in 3D squares as deep as they are wide."""
        if "section" in layer or "halfSize" in cloud:
            return layer.get("section")
        out = 3 - self.across - self.up
        with open(self.case.file("constant/polyMesh/boundary"), errors="replace") as f:
            flat = re.search(r"\btype\s+(empty|wedge);", f.read())
        return float(np.ptp(self.edges[out])) if flat else np.cbrt(cloud["V"])

    def profile(self, time):
        """Fields over x."""
        label, limits = self.view["profile"]
        for layer in self.view.get("points", ()):
            for phase in layer["phases"]:
                cloud = self.case.points(time, phase)
                x = self.factor*cloud["x"][:, 0]
                values = views.evaluate(layer["field"], cloud.__getitem__) \
                    if "field" in layer else np.full(len(x), limits[0])
                self.ax.plot(x, values, "C1." if "field" in layer else "C7|",
                             ms=4 if "field" in layer else 14, label=phase)
        if "gas" in self.view:
            edges = self.factor*self.edges[0]
            self.ax.plot(0.5*(edges[1:] + edges[:-1]),
                         self.onCells(time, self.view["gas"]).mean(axis=0), "C0", lw=1.2,
                         label="gas")
        ends = self.view.get("box", (self.factor*self.edges[0][0], self.factor*self.edges[0][-1]))
        self.ax.set(xlabel=f"x [{self.unit}]", ylabel=label, xlim=ends, ylim=limits)
        self.ax.legend(loc="upper right", ncol=3)


def animate(folder="."):
    """All views of a folder."""
    for name, view in views.readViews(folder).items():
        drawing = Drawing(view, folder)
        path = os.path.join(folder, name + ".gif")
        saveAnimation(map(drawing.draw, drawing.times), path)
        plt.close(drawing.figure)
        print(f"{path}: {len(drawing.times)} frames")


if __name__ == "__main__":
    animate(*sys.argv[1:2])
