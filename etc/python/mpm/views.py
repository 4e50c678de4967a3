"""What is shown of a case: the file view.py beside it, for animations (mpm.animate) and
for ParaView (etc/paraview/show).

    VIEWS = {
        "plates": {                                     # plates.gif, plates.pvsm
            "time": (1e6, "us"), "length": (1e3, "mm"),
            "box": (-4.3, 4.3, -0.8, 6.3),
            "points": [{"phases": ("target", "flyer"), "field": "1e-6*sigma_yy",
                        "label": "stress along y [MPa]", "limits": (-700, 700),
                        "colours": "SIGNED", "failed": ("damage", 0.5)}],
            "gas": {"field": "1e-5*p", "label": "pressure [bar]", "limits": (0.5, 1.5)},
        },
    }

    of a view  default
    case       "."      folder of the case, from that of view.py
    time       1, "s"   factor and unit of the times that are shown
    length     1, "m"   the same of the axes
    box        mesh     lowest and highest of the direction across, then of that up [unit]
    axes       "xy"     directions across and up: "yx" for r, x of an axisymmetric case
    mirror     none     "across" or "up": that direction's 0 is a plane of symmetry
    floor      no       True: animations are grey from the lower end of the box up to 0, where
                        the case has a wall
    size       5.6      width of the animation [inches of 100 pixels]
    from       none     direction from which ParaView looks at a case in 3D
    profile    none     a case in 1D: label and limits of the axis up. It shows the layers'
                        fields over x, and points without a field where they are
    points     none     layers of points, one over the other
    gas        none     a layer on the cells, below the points

    of a layer
    phases     of points: names of the clouds
    field      an expression in the names of columns of points or of fields on cells
    label      of the colour bar
    limits     lowest and highest value
    colours    "VALUES" (default), "SIGNED", "HEAT", "DAMAGE", "PART"; of a gas below points
               that have VALUES the default is PART
    log        True: colours by the logarithm
    colour     in place of a field: "BODY", "RIGID", "FAILED" or any of matplotlib's names
    failed     column and value from which on points have the colour of failed matter
    close, outline, section     as in pictures.drawPoints; of points without half-sizes section
               is by default the thickness of the mesh in 2D (in ParaView it must be given)

Components are named by their directions: sigma_yy, U_x, U.air_x.
"""

import os
import re
import runpy

import numpy as np

#: Stops of the colour maps that matplotlib and ParaView do not have: place, colour. SIGNED:
#: blue, white, orange, whose lightness falls linearly from the middle to both ends
STOPS = {
    "SIGNED": [(0, "#2166ac"), (0.318, "#92c5de"), (0.5, "#f7f7f7"), (0.676, "#fdb863"),
               (1, "#b35806")],
    "PART": [(0, "#2166ac"), (0.636, "#92c5de"), (1, "#f7f7f7")],
    "DAMAGE": [(0, "#e8e4da"), (0.5, "#e0ac72"), (1, "#882255")]}
COLOURS = {"FAILED": "#882255", "BODY": "#c9c9c9", "RIGID": "#8a8a8a"}

FUNCTIONS = {"sqrt": np.sqrt, "abs": np.abs, "log10": np.log10}
_NAME = re.compile(r"(?<![\w.])[A-Za-z]\w*(?:\.[A-Za-z]\w*)?")
_COMPONENTS = {3: ("x", "y", "z"), 6: ("xx", "xy", "xz", "yy", "yz", "zz")}
_KEYS = {"case", "time", "length", "box", "axes", "mirror", "floor", "size", "from", "profile",
         "points", "gas"}
_LAYER = {"phases", "field", "label", "limits", "colours", "log", "colour", "failed", "close",
          "outline", "section"}


def readViews(folder="."):
    """Views of a folder by name; an error says what is wrong with one."""
    path = os.path.join(folder, "view.py")
    if not os.path.exists(path):
        raise SystemExit(f"no file {path}: mpm/views.py says what it has")
    views = runpy.run_path(path)["VIEWS"]
    for name, view in views.items():
        for what, found, known in [("of the view", view, _KEYS)] + [
                ("of a layer", layer, _LAYER) for layer in layers(view)]:
            wrong = set(found) - known
            if wrong:
                raise SystemExit(f"{path}, {name}: unknown {' '.join(sorted(wrong))}; words"
                                 f" {what}: {' '.join(sorted(known))}")
        if "gas" in view and any("field" in layer and layer.get("colours", "VALUES") == "VALUES"
                                 for layer in view.get("points", ())):
            view["gas"].setdefault("colours", "PART")   # not those of the points
    return views


def layers(view):
    return [*view.get("points", ()), *([view["gas"]] if "gas" in view else [])]


def names(expression):
    """Names of the columns or fields in an expression, without the components'."""
    return sorted({component(n)[0] for n in _NAME.findall(expression) if n not in FUNCTIONS})


def component(name):
    """A name and its direction: sigma_yy is sigma, yy."""
    base, _, direction = name.rpartition("_")
    return (base, direction) if base and re.fullmatch("[xyz]{1,2}", direction) else (name, "")


def evaluate(expression, read):
    """Values of an expression; read gives the array of a name."""
    found = []

    def take(match):
        if match[0] in FUNCTIONS:
            return match[0]
        base, direction = component(match[0])
        values = read(base)
        if direction:
            values = values[..., _COMPONENTS[values.shape[-1]].index(direction)]
        found.append(values)
        return f"_v[{len(found) - 1}]"
    text = _NAME.sub(take, expression)
    return eval(text, {"__builtins__": {}, "_v": found, **FUNCTIONS})


def calculator(expression):
    """The expression as ParaView's Calculator reads it."""
    def quote(match):
        base, direction = component(match[0])
        if match[0] in FUNCTIONS:
            return match[0]
        return '"' + base + (f"_{direction.upper()}" if direction else "") + '"'
    return _NAME.sub(quote, expression)
