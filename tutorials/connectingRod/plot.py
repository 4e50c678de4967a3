"""The rod before, while and after it hits the pad; momentum of both."""

from collections import Counter

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from mpm.case import Case
from mpm.pictures import VALUES, colourBar, frame, plt, save, to_rgba
from results import massOf, massOfPoints, motion, tetrahedra, turned

# The camera looks from CAMERA; directions across and up of the picture
CAMERA = np.array((0.42, -0.86, 0.28))/np.linalg.norm((0.42, -0.86, 0.28))
ACROSS = np.cross((0, 0, 1), CAMERA)/np.hypot(*CAMERA[:2])
UP = np.cross(CAMERA, ACROSS)
LIGHT = np.array((-0.4, -0.7, 0.6))/np.linalg.norm((-0.4, -0.7, 0.6))


def surface(corners):
    """Triangles of the outside of tetrahedra, outwards."""
    nodes, index = np.unique(corners.reshape(-1, 3).round(9), axis=0, return_inverse=True)
    tets = index.reshape(-1, 4)
    faces = np.concatenate([tets[:, f] for f in ([1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1])])
    count = Counter(map(tuple, np.sort(faces, axis=1)))
    outer = [f for f in faces if count[tuple(sorted(f))] == 1]
    inside = {tuple(sorted(f)): tets[i % len(tets)] for i, f in enumerate(faces)}
    found = []
    for f in outer:
        a, b, c = nodes[f]
        behind = nodes[inside[tuple(sorted(f))]].mean(axis=0)
        found.append((a, b, c) if np.cross(b - a, c - a)@(a - behind) > 0 else (a, c, b))
    return np.array(found)


def rigid(x, X):
    """Rotation and shift that bring x to X."""
    a, b = x.mean(axis=0), X.mean(axis=0)
    U, _, V = np.linalg.svd((x - a).T@(X - b))
    Q = (U@V).T
    return Q, b - Q@a


def skin(x, values, order, shape):
    """Quadrilaterals of the outside of a block of points in rows, and their values."""
    x, values = x[order].reshape(*shape, 3), values[order].reshape(shape)
    polygons, colours = [], []
    for axis in range(3):
        for end in (0, -1):
            f, v = np.take(x, end, axis), np.take(values, end, axis)
            quads = np.stack((f[:-1, :-1], f[1:, :-1], f[1:, 1:], f[:-1, 1:]), axis=2)
            flip = (axis == 1) != (end == 0)
            polygons.append(quads.reshape(-1, 4, 3)[:, ::-1 if flip else 1])
            colours.append((v[:-1, :-1] + v[1:, 1:]).ravel()/2)
    return np.concatenate(polygons), np.concatenate(colours)


def shaded(polygons, colours):
    n = np.cross(polygons[:, 1] - polygons[:, 0], polygons[:, 2] - polygons[:, 0])
    n /= np.maximum(np.linalg.norm(n, axis=1), 1e-30)[:, None]
    out = np.array(colours)
    out[:, :3] *= (0.55 + 0.45*np.clip(n@LIGHT, 0, 1))[:, None]
    return out


case = Case()
corners = tetrahedra("rod.msh")
outside = surface(corners)
start = {p: case.points("0", p) for p in ("rod", "pad")}
x0 = start["pad"].byId("x")
shape = [len(np.unique(x0[:, d].round(6))) for d in range(3)]
order = np.lexsort(x0.round(6).T[::-1])
norm = Normalize(0, 250)

figure, axes = plt.subplots(1, 5, figsize=(12, 3.6), width_ratios=(1, 1, 1, 1, 1.35))
for ax, want in zip(axes[:4], (0, 0.02, 0.0275, 0.07)):
    time = case.nearest(want, "lagrangian")
    Q, shift = rigid(start["rod"].byId("x"), case.points(time, "rod").byId("x"))
    rod = outside@Q.T + shift
    pad = case.points(time, "pad")
    block, stress = skin(pad.byId("x"), 1e-3*pad.byId("sigmaEq"), order, shape)
    polygons = [*rod, *block]
    colours = np.concatenate((
        shaded(rod, np.tile(to_rgba("#c4c8d0"), (len(rod), 1))),
        shaded(block, VALUES(norm(stress)))))
    far = np.argsort([p.mean(axis=0)@CAMERA for p in polygons])
    ax.add_collection(PolyCollection(
        [1e3*np.stack((polygons[k]@ACROSS, polygons[k]@UP), axis=1) for k in far],
        facecolors=colours[far], edgecolors=colours[far], linewidths=0.3))
    frame(ax, (-85, 155), (-275, 70), title=f"{1e3*float(time):g} ms")
    ax.set_axis_off()
colourBar(figure, ScalarMappable(norm, VALUES), axes[:4], "equivalent stress [kPa]",
          location="bottom", shrink=0.5, aspect=40)

ax = axes[4]
times = case.times("lagrangian")
p = np.array([[motion(case, t, ph)[0][2] for t in times[1:]] for ph in (["rod"], ["pad"])])
t = 1e3*np.array([float(v) for v in times[1:]])
for row, name, colour in ((p[0], "rod", "k"), (p[1], "pad", "C0"), (p.sum(axis=0), "both", "C1")):
    ax.plot(t, row, "-", color=colour, label=name)
ax.set(xlabel="time [ms]", ylabel="momentum upwards [N s]")
ax.legend()
save(figure, "rod.png")

m, c, inertia = massOf(corners)
M, C, I = massOfPoints(start["rod"])
print(f"mass of the points over the mesh's - 1: {M/m - 1:.0e}, centre of mass apart"
      f" {abs(C - c).max():.0e} m, inertia apart {abs(I - inertia).max()/np.trace(inertia):.1e} of"
      " its trace")
before = case.nearest(0.02, "lagrangian")
apart, way = turned(case, before)
print(f"rotation at {1e3*float(before):g} ms: points at most {1e6*apart:.1f} um from Euler's"
      f" equations, way {1e3*way:.1f} mm ({1e4*apart/way:.1f}e-4)")
# The points of a free body have its velocity from the first step on
(p0, L0), (p1, L1) = (motion(case, t) for t in (times[1], times[-1]))
print(f"momentum of both: change {np.linalg.norm(p1 - p0)/np.linalg.norm(p0):.0e}, angular momentum"
      f" about the origin {np.linalg.norm(L1 - L0)/np.linalg.norm(L0):.1e}")
print(f"points {len(start['rod']['m'])} + {len(x0)}, steps {case.nSteps()},"
      f" {case.solverSeconds():.0f} s")
