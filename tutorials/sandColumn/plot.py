"""The heap at some times, its runout and height."""

import numpy as np

from mpm.case import Case
from mpm.pictures import ListedColormap, drawPoints, frame, plt, save

L, HEIGHT, H = 0.1, 0.2, 0.005
SAND = ListedColormap(["#8a6d3b", "#e2c58c"])

case = Case()
times = case.times("lagrangian")
places = {t: case.points(t, "sand").byId("x") for t in times}


def front(x):
    """End of the heap: last cell from the middle with as many points as one has."""
    count = np.bincount((x[:, 0]/H).astype(int), minlength=200)
    return H*np.argmax(count < 4)


for t in times:
    x = places[t]
    print(f"t {t} s: runout (L - L0)/L0 {(front(x) - L)/L:.2f}, farthest point"
          f" {(x[:, 0].max() - L)/L:.2f}, height over L0"
          f" {(x[x[:, 0] < 2*H, 1].max() + 0.25*H)/L:.2f}")
x = places[times[-1]]
U = case.points(times[-1], "sand")["U"]
print(f"speed at the end: mean {np.linalg.norm(U, axis=1).mean():.1e} m/s")

# Layers of the start, in the colours of two sands
STEP = 0.025
shown = [t for t in times if t in ("0", "0.1", "0.2", "0.3", "0.5", times[-1])]
figure, axes = plt.subplots(3, 2, figsize=(11, 7.2), sharex=True, sharey=True)
layer = np.floor(places["0"][:, 1]/STEP) % 2
for ax, t in zip(axes.flat, shown):
    frame(ax, (0, 0.6), (0, 0.215), None, None, f"{t} s")
    ax.axvspan(L*3.4, L*4.6, color="#cfe0ef", lw=0)
    cloud = case.points(t, "sand")
    drawPoints(ax, cloud, layer[np.argsort(np.argsort(cloud["id"]))], SAND, (0, 1), close=3)
for ax in axes[-1]:
    ax.set_xlabel("x [m]")
for ax in axes[:, 0]:
    ax.set_ylabel("y [m]")
axes[0, 0].text(4*L, 0.1, "end of the heap\nin experiments", ha="center", fontsize=8)
save(figure, "sandColumn.png")
