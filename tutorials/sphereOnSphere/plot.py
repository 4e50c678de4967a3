"""The spheres at their closest and the forces between them, beside Hertz's."""

import numpy as np

from mpm.case import Case
from mpm.pictures import POINTS, VALUES, colourBar, frame, plt, save
from results import APPROACH, FORCE, GAP, R, SPEED, K, figures, hertz, motion


def section(path, group):
    """Nodes of a file .msh of version 2 [mm] and the triangles at y = 0 of its tetrahedra of a
    group."""
    nodes, found = {}, []
    with open(path) as f:
        for words in map(str.split, f):
            if len(words) == 4:
                nodes[words[0]] = [1e3*float(w) for w in words[1:]]
            elif len(words) > 6 and words[1] == "4" and int(words[3]) == group:
                flat = [n for n in words[-4:] if abs(nodes[n][1]) < 1e-9]
                if len(flat) == 3:
                    found.append(flat)
    used = {n: i for i, n in enumerate(dict.fromkeys(n for t in found for n in t))}
    return np.array([nodes[n] for n in used]), np.array([[used[n] for n in t] for t in found])


def near(x, cloud, start):
    """Displacement and stress [mm, kPa] at nodes: means of the six points that were nearest."""
    from_ = 1e3*start.byId("x")
    way, stress = 1e3*cloud.byId("x") - from_, 1e-3*cloud.byId("sigmaEq")
    moved, value = np.empty_like(x), np.empty(len(x))
    for i, node in enumerate(x):
        r2 = ((from_ - node)**2).sum(axis=1)
        some = np.argpartition(r2, 6)[:6]
        w = 1/(r2[some] + r2[some].mean())
        moved[i], value[i] = w@way[some]/w.sum(), w@stress[some]/w.sum()
    return moved, value


case = Case()
t, d, F = motion(case)
exact = hertz()

figure = plt.figure(figsize=(11, 4.6))
grid = figure.add_gridspec(2, 3, width_ratios=(0.62, 1, 0.8))
whole, contact = figure.add_subplot(grid[:, 0]), figure.add_subplot(grid[:, 1])
a = 1e3*np.sqrt(R/2*APPROACH)
time = case.nearest(GAP/SPEED + exact[0][exact[1].argmax()], "lagrangian")
for ax, x, z in ((whole, 11, 21), (contact, 3.2, 3.2)):
    frame(ax, (-x, x), (-z, z), ylabel="z [mm]")
nodes, triangles = section("space.msh", 3)
for side in (-1, 1):
    contact.triplot(side*nodes[:, 0], nodes[:, 2], triangles, color="0.8", lw=0.5)
for group, phase in ((1, "upper"), (2, "lower")):
    nodes, triangles = section("spheres.msh", group)
    moved, stress = near(nodes, case.points(time, phase), case.points("0", phase))
    x = nodes + moved
    x[nodes[:, 0] < 1e-9, 0] = 0
    for ax in (whole, contact):
        for side in (-1, 1):
            image = ax.tripcolor(side*x[:, 0], x[:, 2], triangles, stress, cmap=VALUES,
                                 vmin=0, vmax=700, shading="gouraud", zorder=POINTS)
whole.set(title=f"{1e3*float(time):g} ms")
for x in (-a, a):
    contact.plot([x, x], [-0.3, 0.3], "w-", lw=3, zorder=5)
    contact.plot([x, x], [-0.3, 0.3], "k-", lw=1.2, zorder=6)
contact.set(title="Contact; upright lines: Hertz's width", ylabel=None)
colourBar(figure, image, contact, "equivalent stress [kPa]", shrink=0.8)

force, law = figure.add_subplot(grid[0, 2]), figure.add_subplot(grid[1, 2])
force.plot(1e3*(t - GAP/SPEED), F, "C0", label="computed")
force.plot(1e3*exact[0], exact[2], "k--", lw=1, label="Hertz")
force.set(xlabel="time from the first touch [ms]", ylabel="force [N]", xlim=(-0.1, 1.6))
force.legend(loc="lower center")
law.plot(1e3*d, F, "C0")
law.plot(1e3*exact[1], K*np.maximum(exact[1], 0)**1.5, "k--", lw=1)
law.set(xlabel="approach [mm]", ylabel="force [N]", xlim=(-0.05, 1.1e3*APPROACH),
        ylim=(-0.2, 1.1*FORCE))
save(figure, "spheres.png")

for name, unit, theirs, ours in figures(case):
    print(f"{name}: {ours:.4g} {unit}, Hertz {theirs:.4g}, {100*(ours/theirs - 1):+.1f} %")
print(f"points {sum(len(case.points('0', p)['m']) for p in ('upper', 'lower'))}, cells"
      f" {case.nCells()}, steps {case.nSteps()}, {case.solverSeconds():.0f} s")
