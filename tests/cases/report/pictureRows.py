"""Rows of mpmReport for the colours of its pictures: a thin plate with some failed points beside
a rigid clamp in a gas, whose points and pressures are given, not run."""

import base64
import io
import os

import numpy as np
import PIL.Image

from foamCase import PROJECT, FoamCase, fileHeader
from mpm.pictures import BODY, GAS, plt, to_rgb
from mpm.reportColours import FAILED
from mpm.reportPictures import encode, pictures
from mpm.views import readViews

PHASES = {"air": {"type": "gas"}, "plate": {}, "clamp": {"type": "rigid"}}
#: Gas and points in one picture, without words on their colours
VIEW = """VIEWS = {"both": {"gas": {"field": "p", "label": "p", "limits": (0, 1)}, "points": [
    {"phases": ("plate",), "field": "plasticStrain", "label": "strain", "limits": (0, 1)%s}]}}"""


def pixels(image):
    """Red, green and blue [row, column] of a picture of a page."""
    with PIL.Image.open(io.BytesIO(base64.b64decode(image.split(",")[1]))) as picture:
        return np.asarray(picture.convert("RGB")).astype(int)


def count(image, colour):
    """Pixels that have this colour, no other however near."""
    return int((image == np.rint(255*np.array(to_rgb(colour)))).all(axis=-1).sum())


def box(low, high, n):
    """Columns of points that fill a rectangle [mm]."""
    half = 0.5e-3*(np.array(high) - low)/n
    x, y = (1e-3*a + h*(2*np.arange(m) + 1) for a, h, m in zip(low, half, n))
    x, y = (v.ravel() for v in np.meshgrid(x, y))
    return {"x": np.stack([x, y, np.full(len(x), 5e-4)], axis=1), "V": np.full(len(x), 1e-9),
            "halfSize": np.tile([*half, 5e-4], (len(x), 1))}


def made():
    """The case at 0 and 1 s: pressures of either time, failed points at the second."""
    case = FoamCase("report", "colours", os.path.join(PROJECT, "etc/caseTemplate"))
    case.run("blockMesh")
    x, y = np.meshgrid(np.linspace(-1, 1, 60), np.linspace(-1, 1, 40))
    for time, p in (("0", 2 + x + 0.3*y), ("1", 2 + np.sin(3*x)*np.cos(5*y))):
        for phase in ("plate", "clamp"):
            os.makedirs(case.file(time, "lagrangian", phase), exist_ok=True)
        with open(case.file(time, "p"), "w") as f:
            f.write(fileHeader("p", "volScalarField") + "dimensions [1 -1 -2 0 0 0 0];\n"
                    "internalField nonuniform List<scalar> 2400\n(\n"
                    + "\n".join(map(str, 1e5*p.ravel())) + "\n);\nboundaryField {}\n")
    plate, clamp = box((-10, 9), (10, 10), (80, 4)), box((8, 10), (12, 12), (16, 8))
    plate["plasticStrain"] = np.linspace(0, 0.2, 320)

    def points(time, phase):
        if phase == "clamp":
            return clamp
        return {**plate, "damage": 1.0*(np.arange(320) % 80 < 2)*(time == "1")}
    case.points = points
    return case


def colours(table):
    shown = pictures(made(), PHASES, 2)
    table.check("small bodies: all of the mesh, then the part with the bodies", [
        "the part with the bodies" in p.title for p in shown] == [False, True],
        [p.title for p in shown])
    # Right of their pixel there are bars of colours alone
    for name, right, picture in zip(("all", "part"), (480, 510), shown):
        first, second = (pixels(image) for _, image in picture.frames)
        failed = [count(image, FAILED) for image in (first, second)]
        table.check(f"{name}: failed points are exactly {FAILED}", failed[0] == 0 < failed[1],
                    failed)
        # Right of the title, which is another
        body = [count(image[:, 320:], BODY) for image in (first, second)]
        table.row(f"{name}: pixels of the rigid body's colour at two times", body[0], body[1], 0)
        table.row(f"{name}: ... are there", 50, body[0], 50, "atLeast")
        table.row(f"{name}: bars of colours at two times, largest difference of 255", 0,
                  abs(first - second)[:, right:].max(), 0)
    figure, ax = plt.subplots(figsize=(3, 2))
    ax.pcolormesh(np.random.default_rng(1).random((20, 30)), zorder=GAS)
    stored = pixels(encode(figure))
    drawn = np.asarray(figure.canvas.buffer_rgba())[..., :3].astype(int)
    plt.close(figure)
    table.row("pictures: stored and drawn, largest difference of 255", 0,
              abs(stored - drawn).max(), 0)


def views(table):
    """Gas and points in one picture are not in the same colours."""
    case = FoamCase("report", "colours", os.path.join(PROJECT, "etc/caseTemplate"))
    for more, expected in (("", "PART"), (', "colours": "SIGNED"', None)):
        with open(case.file("view.py"), "w") as f:
            f.write(VIEW % more)
        found = readViews(case.path)["both"]["gas"].get("colours")
        table.check(f"view.py: colours of a gas below points{' that are SIGNED' if more else ''}",
                    found == expected, found)
