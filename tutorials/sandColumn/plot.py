"""The heap at some times, its runout and height."""

import numpy as np

from mpm.case import Case
from mpm.pictures import plt

L, HEIGHT, H = 0.1, 0.2, 0.005

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

shown = [t for t in times if t in ("0", "0.1", "0.2", "0.3", "0.5", times[-1])]
figure, axes = plt.subplots(len(shown), 1, figsize=(7, 1.6*len(shown)), sharex=True,
                            sharey=True)
layer = np.zeros(1)
for axis, t in zip(axes, shown):
    if t == "0":
        layer = np.floor(places[t][:, 1]/0.025) % 2
    axis.scatter(*places[t][:, :2].T, c=layer, s=1, cmap="copper")
    axis.set(aspect="equal", ylabel="y [m]", title=f"{t} s")
    axis.axvspan(L*3.4, L*4.6, color="C0", alpha=0.15, lw=0)
axes[-1].set(xlabel="x [m]; blue: where experiments end", xlim=(0, 0.6), ylim=(0, 0.22))
figure.savefig("sandColumn.png")
