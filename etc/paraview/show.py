"""ParaView's state and a picture of the views of a case (view.py, see etc/python/mpm/views.py):

    pvbatch etc/paraview/show.py [folder]       # etc/paraview/state calls it

makes <view>.pvsm, which `paraview <view>.pvsm` opens, and <view>ParaView.png of the last time.
Points are Point Gaussians as large as their boxes, failed ones apart in the colour of failed
matter. A gas is a cut through its cells, behind the points; no other part of the mesh is
shown, so that the slab of cells of a case in 2D hides nothing. A case in 1D is a strip.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../python"))
from mpm import views  # noqa: E402
from mpm.case import Case  # noqa: E402

try:
    from paraview import simple as pv  # noqa: E402
except ModuleNotFoundError as missing:
    sys.exit(f"etc/paraview/show.py: {missing}: this pvbatch lacks ParaView's Python"
             " (Debian: package python3-paraview)")

PRESETS = {"VALUES": "Viridis (matplotlib)", "HEAT": "Cividis"}
#: Radius of a Gaussian over half the side of a box: circles leave no holes between points
RADIUS = 1.42
#: Pixels beside the scene for bars of colours
BARS = 150
#: Height of the strip of a case in 1D over its length
STRIP = 0.06


def rgb(name):
    name = views.COLOURS.get(name, name)
    return [int(name[i:i + 2], 16)/255 for i in (1, 3, 5)]


class Scene:
    def __init__(self, view, folder):
        self.view = view
        self.case = Case(os.path.join(folder, view.get("case", ".")))
        self.file = os.path.abspath(self.case.file("case.foam"))
        open(self.file, "a").close()
        self.edges = self.case.edges()
        self.flat = "from" not in view
        self.factor = view.get("length", (1, "m"))[0]
        self.low, self.high = ([e[end] for e in self.edges] for end in (0, -1))
        # A case in 1D is stretched across
        self.stretch = STRIP*(self.high[0] - self.low[0])/(self.high[1] - self.low[1]) \
            if "profile" in view else 1
        self.window = pv.CreateView("RenderView")
        self.window.UseColorPaletteForBackground = 0
        self.window.Background = [1, 1, 1]
        self.window.OrientationAxesVisibility = 0 if self.flat else 1
        self.bars = []

    def read(self, region, name):
        """What the reader has of a region of the case, all times."""
        reader = pv.OpenFOAMReader(registrationName=name, FileName=self.file)
        reader.SkipZeroTime = 0
        reader.UpdatePipelineInformation()
        if region not in reader.MeshRegions.Available:
            # It lists what the time has at which it is: some phases come later
            reader.UpdatePipeline(reader.TimestepValues[-1])
            reader.UpdatePipelineInformation()
        if region not in reader.MeshRegions.Available:
            print(f"{self.file}: ParaView finds no {region}")
            pv.Delete(reader)
            return None
        reader.MeshRegions = [region]
        return reader

    def placed(self, source):
        """Mirrored and stretched as the view says."""
        mirror = self.view.get("mirror")
        if mirror:
            across, up = self.view.get("axes", "xy").upper()
            source = pv.Reflect(Input=source, Plane=across if mirror == "across" else up)
        if self.stretch != 1:
            source = pv.Transform(Input=source, Transform="Transform")
            source.Transform.Scale = [1, self.stretch, self.stretch]
        return source

    def colour(self, shown, layer, where):
        """By the layer's field, with a bar."""
        label = layer.get("label") or self.view["profile"][0]
        low, high = layer.get("limits") or self.view["profile"][1]
        pv.ColorBy(shown, (where, label))
        table = pv.GetColorTransferFunction(label)
        name = layer.get("colours", "VALUES")
        if name in PRESETS:
            table.ApplyPreset(PRESETS[name], True)
        else:
            table.ColorSpace = "RGB"
            table.RGBPoints = [v for at, c in views.STOPS[name] for v in (at, *rgb(c))]
        table.RescaleTransferFunction(low, high)
        if layer.get("log"):
            table.MapControlPointsToLogSpace()
            table.UseLogScale = 1
        bar = pv.GetScalarBar(table, self.window)
        bar.Title, bar.ComponentTitle = label, ""
        bar.TitleColor = bar.LabelColor = [0, 0, 0]
        bar.TitleFontSize = bar.LabelFontSize = 14
        bar.RangeLabelFormat = bar.LabelFormat = "%-#.3g"
        bar.Visibility = 1
        if bar not in self.bars:
            self.bars.append(bar)

    def gas(self, layer):
        cells = self.read("internalMesh", "gas")
        if cells is None:
            return
        cut = pv.Slice(Input=cells, SliceType="Plane")
        cut.SliceType.Normal = [0, 0, 1]
        cut.SliceType.Origin = [0, 0, self.low[2] + 1e-3*(self.high[2] - self.low[2])]
        cut.Triangulatetheslice = 0
        values = pv.Calculator(registrationName="gas: field", Input=self.placed(cut))
        values.AttributeType = "Cell Data"
        values.ResultArrayName = layer.get("label") or self.view["profile"][0]
        values.Function = views.calculator(layer["field"])
        shown = pv.Show(values, self.window)
        shown.Representation = "Surface"
        # The colours as they are, without a light
        shown.Ambient, shown.Diffuse = 1, 0
        self.colour(shown, layer, "CELLS")

    def points(self, phase, layer):
        source = self.read("lagrangian/" + phase, phase)
        if source is None:
            return
        last = pv.Calculator(registrationName=phase + ": radius", Input=self.placed(source))
        half = f"0.5*sqrt(V/{layer['section']:g})" if "section" in layer else "halfSize_X"
        last.ResultArrayName, last.Function = "radius", f"{RADIUS}*{half}"
        if "field" in layer:
            last = pv.Calculator(registrationName=phase + ": field", Input=last)
            last.ResultArrayName = layer.get("label") or self.view["profile"][0]
            last.Function = views.calculator(layer["field"])
        if "failed" not in layer:
            self.gaussians(last, layer)
            return
        name, limit = layer["failed"]
        for what, method in (("", "Below Lower Threshold"),
                             (", failed", "Above Upper Threshold")):
            part = pv.Threshold(registrationName=phase + what, Input=last)
            part.Scalars = ["POINTS", name]
            part.ThresholdMethod = method
            # Below: less than the limit itself
            part.LowerThreshold, part.UpperThreshold = limit*(1 - 1e-9), limit
            self.gaussians(part, {"colour": "FAILED"} if what else layer)

    def gaussians(self, source, layer):
        shown = pv.Show(source, self.window)
        shown.Representation = "Point Gaussian"
        shown.ShaderPreset = "Plain circle" if self.flat else "Sphere"
        shown.GaussianRadius = 1
        shown.ScaleByArray = 1
        shown.SetScaleArray = ["POINTS", "radius"]
        shown.UseScaleFunction = 0
        if "field" in layer:
            self.colour(shown, layer, "POINTS")
        else:
            shown.ColorArrayName = [None, ""]
            shown.AmbientColor = shown.DiffuseColor = rgb(layer.get("colour", "BODY"))

    def camera(self):
        """The box fills the window beside the bars: in 2D seen along z or, with r to the
        right and x up, from the other side."""
        w = self.window
        low, high = list(self.low), list(self.high)
        axes = self.view.get("axes", "xy")
        if "box" in self.view and "profile" not in self.view:
            for k, a in enumerate(axes):
                low["xyz".index(a)], high["xyz".index(a)] = (
                    v/self.factor for v in self.view["box"][2*k:2*k + 2])
        low[1], high[1] = low[1]*self.stretch, high[1]*self.stretch
        middle = [0.5*(a + b) for a, b in zip(low, high)]
        size = [b - a for a, b in zip(low, high)]
        if self.flat:
            across, up = ("xyz".index(a) for a in axes)
            pixel = max(size[across]/1000, size[up]/800)
            width = int(size[across]/pixel) + 20 + (BARS if self.bars else 0)
            height = max(int(size[up]/pixel) + 20, 60 + 250*len(self.bars))
            middle[across] = low[across] + (0.5*width - 10)*pixel
            eye = list(middle)
            eye[2] += (1 if axes == "xy" else -1)*5*max(size)
            w.CameraViewUp = [float(k == up) for k in range(3)]
            w.CameraParallelProjection = 1
            w.CameraParallelScale = 0.5*height*pixel
            w.InteractionMode = "2D"
        else:
            eye = [m + 2*max(size)*d for m, d in zip(middle, self.view["from"])]
            width, height = 1000, 800
        w.CameraPosition, w.CameraFocalPoint = eye, middle
        w.CenterOfRotation = middle
        w.ViewSize = [width, height]
        for k, bar in enumerate(self.bars):
            bar.WindowLocation = "Any Location"
            part = 1/len(self.bars)
            bar.ScalarBarLength = 0.7*part
            bar.Position = [1 - (BARS - 20)/width, 1 - part*(k + 0.9)]

    def build(self):
        if "gas" in self.view:
            self.gas(self.view["gas"])
        for layer in self.view.get("points", ()):
            for phase in layer["phases"]:
                self.points(phase, layer)
        scene = pv.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        scene.GoToLast()
        self.camera()


def main(folder="."):
    for name, view in views.readViews(folder).items():
        scene = Scene(view, folder)
        scene.build()
        base = os.path.join(folder, name)
        pv.SaveScreenshot(base + "ParaView.png", scene.window,
                          ImageResolution=list(scene.window.ViewSize))
        pv.SaveState(base + ".pvsm")
        print(f"{base}.pvsm, {base}ParaView.png")
        for source in reversed(list(pv.GetSources().values())):
            pv.Delete(source)
        pv.Delete(scene.window)


main(*sys.argv[1:2])
