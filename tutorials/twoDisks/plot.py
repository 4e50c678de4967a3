"""Energies over time and pictures of the disks."""

import numpy as np

from energies import Energies, endAndLargest
from mpm.case import Case
from mpm.pictures import plt

case, e = Case(), Energies()
EXACT = 2*0.5*1000*np.pi*0.2**2*0.02

figure, axes = plt.subplots(2, 1, figsize=(7.5, 7.5), sharex=True)
axes[0].plot(e.t, e.kinetic, label="kinetic")
axes[0].plot(e.t, e.strain, label="strain")
axes[0].plot(e.t, e.total, label="total")
axes[0].axhline(EXACT, color="k", ls=":", lw=0.8, label="two disks, exact")
axes[0].set_ylabel("energy [J]")
axes[0].legend()
axes[1].plot(e.t, e.error, "C2")
axes[1].axhline(0, color="k", lw=0.5)
axes[1].set_ylabel("error of the total energy [%]")
axes[1].set_xlabel("time [s]")
figure.savefig("energy.png")

figure, axes = plt.subplots(2, 3, figsize=(11, 7.4), sharex=True, sharey=True)
for ax, want in zip(axes.flat, (0, 1.0, 1.4, 1.8, 2.2, 3.0)):
    name = case.nearest(want, "lagrangian")
    for phase in ("lower", "upper"):
        x, s = (case.points(name, phase)[column] for column in ("x", "sigma"))
        # xx xy xz yy yz zz
        image = ax.scatter(x[:, 0], x[:, 1], s=6, c=-(s[:, 0] + s[:, 3] + s[:, 5])/3,
                           cmap="viridis", vmin=-120, vmax=120, linewidths=0)
    ax.set_xticks(np.arange(-0.2, 1.21, 0.05), minor=True)
    ax.set_yticks(np.arange(-0.2, 1.21, 0.05), minor=True)
    ax.grid(True, which="both", lw=0.2)
    ax.set_aspect("equal")
    ax.set_title(f"t = {name} s", fontsize=9)
figure.colorbar(image, ax=axes, label="pressure [Pa]")
figure.savefig("disks.png")

i = np.argmin(e.kinetic)
apart = np.linalg.norm(e.momentum - e.momentum[0], axis=1)
scale = e.mass[0]/2*np.sqrt(0.02)
print(f"kinetic energy at the start {e.kinetic[0]:.4f} J, exact disks {EXACT:.4f} J "
      f"(points at the border: {100*(e.start/EXACT - 1):+.2f} %)")
print(f"smallest kinetic energy     {e.kinetic[i]:.4f} J at {e.t[i]:.3f} s")
print(f"kinetic energy at {e.t[-1]:.0f} s       {e.kinetic[-1]:.4f} J, "
      f"{100*e.kinetic[-1]/e.start:.1f} % of the start")
print(f"momentum                    changes by {apart.max()/scale:.1e} of one disk's")
end, largest = endAndLargest(e.error)
print(f"error of total energy       {end:+.4f} % at 3 s, largest {largest:.4f} %")
print(f"energy budget at 3 s        transfer {e.transfer[-1]:+.4f} %, residual "
      f"{e.residual[-1]:+.4f} %")
