"""Energies over time and pictures of the disks."""

import numpy as np

from energies import Energies, endAndLargest
from mpm.case import Case
from mpm.pictures import SIGNED, colourBar, drawPoints, frame, plt, save

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
save(figure, "energy.png")

figure, axes = plt.subplots(2, 3, figsize=(9.5, 6), sharex=True, sharey=True)
for ax, want in zip(axes.flat, (0, 1.0, 1.4, 1.8, 2.2, 3.0)):
    name = case.nearest(want, "lagrangian")
    frame(ax, (-0.05, 1.05), (-0.05, 1.05), None, None, f"{name} s")
    for phase in ("lower", "upper"):
        cloud = case.points(name, phase)
        s = cloud["sigma"]      # xx xy xz yy yz zz
        image = drawPoints(ax, cloud, -(s[:, 0] + s[:, 3] + s[:, 5])/3, SIGNED.reversed(),
                           (-150, 150), close=1, outline="0.3")
for ax in axes[-1]:
    ax.set_xlabel("x [m]")
for ax in axes[:, 0]:
    ax.set_ylabel("y [m]")
colourBar(figure, image, axes, "pressure [Pa]")
save(figure, "disks.png")

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
