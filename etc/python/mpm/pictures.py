"""matplotlib in the style of the tutorials' pictures, without a screen."""

import io

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import PIL.Image  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

plt.rcParams.update({"figure.constrained_layout.use": True, "legend.fontsize": 8,
                     "savefig.dpi": 130})

#: Matter that has failed, in every picture
FAILED = "#882255"


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


def save(figure, name, dpi=100):
    """A PNG of 256 colours: a third of the size, for pictures of many points."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=dpi)
    image = PIL.Image.open(buffer).convert("RGB")
    image.quantize(256, dither=PIL.Image.Dither.NONE).save(name, optimize=True)
