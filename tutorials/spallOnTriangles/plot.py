"""The plates on their triangles, and the stress at the mid-plane beside the exact one."""

import numpy as np

from mpm.case import Case
from mpm.pictures import FAILED, SIGNED, colourBar, drawPoints, frame, plt, save
from results import C, H, STRESS, V, figures


def triangles(path):
    """Nodes [mm] and triangles of the mesh: the lower sides of gmsh's prisms."""
    nodes, cells = {}, []
    with open(path) as f:
        for words in map(str.split, f):
            if len(words) == 4:
                nodes[int(words[0])] = [1e3*float(w) for w in words[1:3]]
            elif len(words) > 6 and words[1] == "6":
                cells.append([int(w) for w in words[-6:-3]])
    place = {n: i for i, n in enumerate(nodes)}
    return np.array(list(nodes.values())), [[place[n] for n in cell] for cell in cells]


case = Case()
mesh = triangles("plates.msh")
figure, axes = plt.subplots(1, 4, figsize=(12, 4.2), width_ratios=(1, 1, 1, 1.5))
whole, near = ((-2.4, 2.4), (-0.4, 6)), ((-2.05, -1.2), (1.35, 2.45))
for ax, want, (xlim, ylim), title in (
        (axes[0], 0.5e-6, whole, "compression"), (axes[1], 3e-6, whole, "torn"),
        (axes[2], 3e-6, near, "its edge")):
    time = case.nearest(want, "lagrangian")
    frame(ax, xlim, ylim, ylabel="y [mm]" if ax is axes[0] else None,
           title=f"{float(time)*1e6:g} $\\mu$s: {title}")
    if ax is axes[2]:
        ax.triplot(*mesh[0].T, mesh[1], color="0.7", lw=0.4)
    for phase in ("target", "flyer"):
        cloud = case.points(time, phase)
        image = drawPoints(ax, cloud, cloud["sigma"][:, 3]*1e-6, SIGNED, (-700, 700),
                           failed=cloud["damage"] > 0.5, scale=1e3,
                           close=0 if ax is axes[2] else 1, section=1e-3)
axes[2].plot([], [], "s", color=FAILED, label="failed")
axes[2].legend(loc="upper right")
colourBar(figure, image, axes[:3], "stress along y [MPa]", shrink=0.7)

t, stress = case.series("midPlane", "sigma_yy.dat").T
fine = np.linspace(0, 2e-6, 2000)
exact = np.where(fine < H/C, 0, np.where(fine < 3*H/C, -STRESS, STRESS))
axes[3].plot(fine*1e6, exact*1e-6, "k-", lw=0.8, label="exact, without failure")
axes[3].plot(t*1e6, stress*1e-6, "C0-", label="triangles")
axes[3].axhline(400, color="C3", ls=":", label="strength")
axes[3].set(xlim=(0, 2), xlabel="time [us]", title="stress at the mid-plane [MPa]")
axes[3].legend()
save(figure, "spallOnTriangles.png")

tension, torn, plateau, surface = figures(case)
print(f"first tension {tension*1e6:.4f} us, exact {3e6*H/C:.4f} us, "
      f"error {(tension - 3*H/C)*1e9:.1f} ns; torn at {torn*1e6:.4f} us")
print(f"plateau {plateau*1e-6:.1f} MPa, exact {-STRESS*1e-6:.1f} MPa")
print(f"free surface {surface:.2f} m/s, exact {V:.0f} m/s")
