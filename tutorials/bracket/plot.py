"""The bent bracket on its background, and its centre of mass over time, beside a rod."""

import re

import numpy as np

from mpm.case import Case
from mpm.pictures import VALUES, colourBar, drawPoints, frame, plt, save
from results import centreOfRod, rest, rod, tip, tipOfRod


def triangles(path):
    """Nodes and triangles on the sides of the background, which are those of a file .msh of
    version 2."""
    nodes, faces = {}, []
    with open(path) as f:
        for words in map(str.split, f):
            if len(words) == 4:
                nodes[int(words[0])] = [float(w) for w in words[1:]]
            elif len(words) > 6 and words[1] == "2":
                faces.append([int(w) for w in words[-3:]])
    place = {n: i for i, n in enumerate(nodes)}
    x = np.array(list(nodes.values()))
    faces = np.array([[place[n] for n in face] for face in faces])
    return x[:, :2], faces[(x[faces, 2] == 0).all(axis=1)]


with open("constant/phaseProperties") as f:
    text = re.sub(r"//.*", "", f.read())
E, nu, rho = (float(re.search(rf"\b{name}\s+([^;\s]+)", text)[1]) for name in ("E", "nu", "rho"))

case = Case()
times = case.times("lagrangian")
figure, axes = plt.subplots(1, 2, figsize=(10, 4.6), width_ratios=(1.25, 1))
frame(axes[0], (-0.16, 0.66), (-0.76, 0.01), "x [m]", "y [m]", f"0 and {times[-1]} s")
nodes, faces = triangles("background.msh")
axes[0].triplot(*nodes.T, faces, color="0.85", lw=0.3, zorder=0)
for time in (times[0], times[-1]):
    cloud = case.points(time, "bracket")
    image = drawPoints(axes[0], cloud, cloud["sigmaEq"]*1e-3 if time != times[0] else "#c9c9c9",
                       VALUES, (0, 60), close=1, section=np.mean(cloud["V"])**(1/3))
along, loaded, bare = rod(E, nu, rho)
axes[0].plot(*loaded.T, "k-", zorder=5, lw=1, label="Reissner's rod, bent by the weight")
axes[0].plot(*bare.T, "k:", zorder=5, lw=1, label="the same without weight")
axes[0].plot([], [], "s", color="#c9c9c9", label="bracket at time 0")
axes[0].legend(loc="lower left")
colourBar(figure, image, axes[0], "equivalent stress [kPa]", shrink=0.8)

rows = case.series("tip", "bracket.dat")
t, x = rows[:, 0], rows[:, 7:9]
start = case.points(times[0], "bracket")
x = x - (start["m"]@start["x"]/start["m"].sum())[:2]
exact = centreOfRod(E, nu, rho)
for d in (0, 1):
    axes[1].plot(t, x[:, d], f"C{d}", label=f"along {'xy'[d]}")
    axes[1].axhline(exact[d], color=f"C{d}", ls=":")
axes[1].plot([], [], "k:", label="Reissner's rod at rest")
axes[1].set(xlabel="time [s]", ylabel="displacement of the centre of mass [m]")
axes[1].legend()
save(figure, "bracket.png")

moved, s = tip(case, times[-1])
at = [rest(x[:, d]) for d in (0, 1)]
for name, a, b in (("end, last time", moved, tipOfRod(s, E, nu, rho)),
                   ("centre of mass, last time", x[-1], exact),
                   ("centre of mass, at rest", at, exact)):
    print(f"displacement of the {name}: ({a[0]:.4f} {a[1]:.4f}) m, rod ({b[0]:.4f} {b[1]:.4f}),"
          f" {100*(np.linalg.norm(a)/np.linalg.norm(b) - 1):+.1f} %")
