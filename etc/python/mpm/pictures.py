"""Pictures in one style: matplotlib without a screen, points as their boxes.

    image = drawPoints(ax, case.points(time, "plate"), values, SIGNED, (-700, 700),
                       failed=damage > 0.5, scale=1e3)
    drawPoints(ax, cloud, "0.7")                        # in one colour
    ax.pcolormesh(x, y, p, cmap=VALUES, zorder=GAS)     # a gas: below the points
    colourBar(figure, image, axes, "stress [MPa]")
    save(figure, "plate.png")
    saveAnimation(map(draw, times), "plate.gif")        # draw gives a figure for a time

Points are rasterised: a pixel belongs to the point in whose box it lies (of several
the one whose centre is nearest), which leaves no pattern between pixels and points as
markers do. Where a body is stretched its boxes come apart: gaps up to `close` boxes
wide between them are closed.

Colours: VALUES from low to high and SIGNED about zero have an even lightness and are
told apart by the colour-blind; failed matter is FAILED (reportColours has its own).
"""

import io

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import PIL.Image  # noqa: E402
from matplotlib.cm import ScalarMappable  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402
from matplotlib.colors import (LinearSegmentedColormap, ListedColormap,  # noqa: E402,F401
                               LogNorm, Normalize, to_hex, to_rgb, to_rgba)

from mpm.views import COLOURS, STOPS  # noqa: E402

plt.rcParams.update({
    "figure.constrained_layout.use": True, "savefig.dpi": 130, "font.size": 9,
    "axes.titlesize": 9, "legend.fontsize": 8, "legend.frameon": False,
    "image.cmap": "viridis", "pcolor.shading": "auto"})

SIGNED = LinearSegmentedColormap.from_list("signed", STOPS["SIGNED"])
#: Parts of a whole: blue to white
PART = LinearSegmentedColormap.from_list("part", STOPS["PART"])
VALUES = plt.get_cmap("viridis")
HEAT = plt.get_cmap("cividis")
#: From sound to failed
DAMAGE = LinearSegmentedColormap.from_list("damage", STOPS["DAMAGE"])
FAILED, BODY, RIGID = (COLOURS[name] for name in ("FAILED", "BODY", "RIGID"))
#: Bytes of a picture above which it is saved with fewer colours
LARGE = 148000
#: zorder of a gas, and of points
GAS, POINTS = 1, 2


def _erode(mask, rx, ry):
    """Pixels whose neighbours up to rx and ry away are all in the mask or outside the
    picture."""
    for axis, n in ((1, rx), (0, ry)):
        if n == 0:
            continue
        width = [(0, 0), (0, 0)]
        width[axis] = (n, n)
        sums = np.cumsum(~np.pad(mask, width, constant_values=True), axis=axis)
        sums = np.concatenate([np.zeros_like(sums.take([0], axis)), sums], axis)
        size = mask.shape[axis]
        high = sums.take(np.arange(2*n + 1, 2*n + 1 + size), axis)
        mask = high == sums.take(np.arange(size), axis)
    return mask


def owners(x, half, box, shape, close=0.5):
    """Index of the point to which each pixel [row, column] of a picture belongs, -1:
    none. x, half: centres and half-sizes (n, 2); box: x0, x1, y0, y1."""
    ny, nx = shape
    size = np.array([(box[1] - box[0])/nx, (box[3] - box[2])/ny])
    place = (x - [box[0], box[2]])/size - 0.5
    half = np.maximum(half/size, 0.5)
    reach = half + close*half
    near = ((place > -reach - 1) & (place < [nx, ny] + reach)).all(axis=1)
    index = np.flatnonzero(near)
    place, half, reach = place[near], half[near], reach[near]
    owner = np.full((ny, nx), -1)
    if not len(index):
        return owner
    distance = np.full((ny, nx), np.inf)
    first = np.rint(place).astype(int)
    # Points of about one size together: where they differ, the large ones are few
    size = np.ceil(np.log2(reach.max(axis=1))).astype(int)
    for one in np.unique(size):
        group = np.flatnonzero(size == one)
        most = np.ceil(reach[group].max(axis=0)).astype(int)
        for j in range(-most[1], most[1] + 1):
            for i in range(-most[0], most[0] + 1):
                at = first[group] + [i, j]
                d = (abs(at - place[group])/half[group]).max(axis=1)
                some = (d <= 1 + close) & (at >= 0).all(axis=1) & (at < [nx, ny]).all(axis=1)
                column, row, d = at[some, 0], at[some, 1], d[some]
                better = d < distance[row, column]
                distance[row[better], column[better]] = d[better]
                owner[row[better], column[better]] = index[group[some]][better]
    # Closed, not grown: what the longer reach added outside is taken away again
    back = np.floor(close*np.median(half, axis=0)).astype(int)
    inside = (distance <= 1) | _erode(distance < np.inf, *back)
    owner[~inside] = -1
    return owner


def _pixels(ax, box, exact=False):
    """Rows and columns of a raster: twice those of the axes in the saved picture; exact: those
    of the figure as it is."""
    ax.figure.canvas.draw()
    frame = ax.get_window_extent()
    dpi = 1 if exact else 2*plt.rcParams["savefig.dpi"]/ax.figure.dpi
    unit = min(frame.width/(box[1] - box[0]), frame.height/(box[3] - box[2]))*dpi
    return (max(1, int(np.ceil(unit*(box[3] - box[2])))),
            max(1, int(np.ceil(unit*(box[1] - box[0])))))


def drawPoints(ax, cloud, values, cmap=VALUES, limits=None, failed=None, some=None,
               scale=1.0, axes=(0, 1), close=0.5, mirror=False, flip=False, outline=None, size=1.0,
               pixels=None, section=None, failedColour=FAILED, exact=False):
    """Points of a cloud, in the limits that the axes have (set them before).

    values   one per point with cmap (VALUES, SIGNED, HEAT, DAMAGE or a name of matplotlib's)
             and limits, or a colour for all
    failed   mask of points in the colour of failed matter, failedColour
    some     mask of the points that are drawn
    scale    of the places: 1e3 for millimetres
    axes     directions across and up: (1, 0) for r, x of an axisymmetric case
    mirror   drawn at both sides of the axis ("up": of 0 of the direction up); flip: at
             the other side
    size     of the boxes drawn over theirs
    section  thickness of the mesh [m], where points have no half-sizes: squares of their volume
    outline  colour of a line about those that have not failed
    exact    each pixel has the colour of one point: edges are steps, and a thin body or a failed
             point among others is not mixed with what is beside it
    Returns what a colour bar needs.
    """
    x = cloud["x"][:, axes]*scale
    if section is None and "halfSize" not in cloud:
        raise ValueError("drawPoints: these points have no half-sizes (shapeFunction nodeDual and"
                         " others): give section=<thickness of the mesh [m]>")
    half = cloud["halfSize"][:, axes] if section is None else np.stack(
        [0.5*np.sqrt(cloud["V"]/section)]*2, axis=1)
    half = half*scale*size
    plain = isinstance(values, str)
    cmap = plt.get_cmap(cmap) if isinstance(cmap, str) else cmap
    norm = None if plain else Normalize(*(limits or (np.min(values), np.max(values))))
    colours = np.tile(to_rgba(values), (len(x), 1)) if plain else cmap(norm(values))
    if failed is not None:
        colours[failed] = to_rgba(failedColour)
    if some is not None:
        x, half, colours = x[some], half[some], colours[some]
    if flip:
        x = x*[-1, 1]
    if mirror:
        x, half, colours = (np.concatenate(v) for v in (
            (x, x*([1, -1] if mirror == "up" else [-1, 1])), (half, half),
            (colours, colours)))
    box = (*sorted(ax.get_xlim()), *sorted(ax.get_ylim()))
    owner = owners(x, half, box, pixels or _pixels(ax, box, exact), close)
    image = np.zeros((*owner.shape, 4))
    image[owner >= 0] = colours[owner[owner >= 0]]
    # Without a colour of its own at the edge of what is transparent
    image[owner < 0, :3] = 1
    ax.imshow(image, origin="lower", extent=box, zorder=POINTS, aspect=ax.get_aspect(),
              interpolation="nearest" if exact else "antialiased")
    if outline:
        sound = owner >= 0
        if failed is not None:
            sound &= (colours != to_rgba(failedColour)).any(axis=1)[owner]
        if sound.any() and not sound.all():
            ax.contour(np.linspace(*box[:2], owner.shape[1]),
                       np.linspace(*box[2:], owner.shape[0]), sound, [0.5], colors=outline,
                       linewidths=0.6, zorder=POINTS)
    return ScalarMappable(norm, cmap)


def boxes(ax, x, side, colours=None, values=None, overlap=0.05, **options):
    """Points as squares of these sides about x [point, 2], one colour, colours by point,
    or values with cmap, vmin, vmax. The squares overlap by this part, so that neighbours
    leave no seam (bodies that turn: 0.3). Returns the collection, for a colour bar."""
    half = 0.5*(1 + overlap)*np.broadcast_to(side, len(x))
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    squares = PolyCollection(x[:, None, :2] + half[:, None, None]*corners, linewidths=0,
                             antialiaseds=False, rasterized=True, **options)
    if values is None:
        squares.set_facecolor(colours)
    else:
        squares.set_array(np.asarray(values))
    ax.add_collection(squares)
    return squares


def polygons(corners, values, cmap, norm):
    """Values on cells of any shape (Case.polygons), to be added to the axes."""
    return PolyCollection(corners, array=values, cmap=cmap, norm=norm, edgecolors="face",
                          linewidths=0.3, rasterized=True, zorder=GAS)


def frame(ax, xlim, ylim, xlabel="x [mm]", ylabel="y [mm]", title=None):
    """Axes with the same unit in both directions."""
    ax.set(xlim=xlim, ylim=ylim, aspect="equal", xlabel=xlabel, ylabel=ylabel, title=title)


def colourBar(figure, image, axes, label, **options):
    options = {"aspect": 30, "pad": 0.015, **options}
    bar = figure.colorbar(image, ax=axes, label=label, **options)
    bar.outline.set_linewidth(0.5)
    return bar


def layOut(figure):
    """Room for all labels: with a colour bar beside equal units it takes some passes."""
    for _ in range(3):
        figure.draw_without_rendering()


def save(figure, name, dpi=None):
    """A PNG; one that is large in 256 colours, a third of the size."""
    layOut(figure)
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=dpi)
    with open(name, "wb") as f:
        f.write(buffer.getvalue())
    if buffer.tell() > LARGE:
        image = PIL.Image.open(buffer).convert("RGB")
        image.quantize(256, dither=PIL.Image.Dither.NONE).save(name, optimize=True)


def saveAnimation(figures, name, seconds=4, colours=128):
    """A GIF of one frame for each figure (a generator may give the same one, drawn
    anew), in one palette, that lasts about so long; the last frame stays a second."""
    frames = []
    for figure in figures:
        figure.canvas.draw()
        frames.append(PIL.Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3]))
    # Colours of some frames, rare ones (of a bar) with more than their share
    some = np.concatenate([np.asarray(f).reshape(-1, 3)
                           for f in frames[::max(1, len(frames)//8)]])
    found, count = np.unique(some & 0xfc, axis=0, return_counts=True)
    found = np.repeat(found | 2, np.ceil(np.sqrt(count)).astype(int), axis=0)
    palette = PIL.Image.fromarray(found[None].astype(np.uint8)).quantize(colours)
    table = np.array(palette.getpalette()).reshape(-1, 3)
    table[(table >= 250).all(axis=1)] = 255         # white stays white
    palette.putpalette(table.astype(np.uint8).tobytes())
    frames = [f.quantize(palette=palette, dither=PIL.Image.Dither.NONE) for f in frames]
    each = 10*round(min(max(100*seconds/len(frames), 5), 25))
    frames[0].save(name, save_all=True, append_images=frames[1:], loop=0, optimize=False,
                   duration=[each]*(len(frames) - 1) + [1000])
