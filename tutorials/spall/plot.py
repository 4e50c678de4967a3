"""Stress at the mid-plane and x-t diagram against the exact solution, damage.

Exact (linear elastic, one dimension, no failure): c = sqrt(E/rho), the impact
makes sigma = rho c v/2 = 687.4 MPa of compression; release waves from both
free surfaces meet at the target's mid-plane at t = 3 H/c = 1.1195 us (H the
flyer's thickness) and leave tension of the same size behind them.
"""

import glob

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from mpm.case import Case
from mpm.pictures import plt

RHO, E, V, H = 2700.0, 70e9, 100.0, 1.9e-3
C = np.sqrt(E/RHO)
STRESS = RHO*C*V/2


def exact(x, t):
    """sigma_yy of flyer (2H..3H, -V at the start) and target (0..2H): waves of
    the initial velocity, reflected at the free surfaces 0 and 3H."""
    def velocity(y):
        y = np.mod(y, 6*H)
        y = np.where(y > 3*H, 6*H - y, y)
        return np.where(y > 2*H, -V, 0.0)
    return 0.5*RHO*C*(velocity(x + C*t) - velocity(x - C*t))


# Mid-plane and free surface over time
case = Case()
t, stress = case.series("midPlane", "sigma_yy.dat").T
ts, surface = case.series("freeSurface", "U_y.dat").T

figure, axes = plt.subplots(2, 1, figsize=(7, 7), sharex=True)
fine = np.linspace(0, t[-1], 3000)
axes[0].plot(fine*1e6, exact(np.full_like(fine, H), fine)*1e-6, "k-", lw=0.8,
             label="exact, without failure")
axes[0].plot(t*1e6, stress*1e-6, "C0-", label="materialPointFoam")
axes[0].axhline(400, color="C3", ls=":", label="strength")
axes[0].axvline(3*H/C*1e6, color="k", ls=":", lw=0.8)
axes[0].set_ylabel("stress at the mid-plane [MPa]")
axes[0].legend()
arrival = 2*H/C
axes[1].plot(np.array([0, arrival, arrival, fine[-1]])*1e6, [0, 0, 100, 100],
             "k-", lw=0.8, label="exact until the release arrives (instant failure: stays)")
axes[1].plot(ts*1e6, -surface, "C0-", label="materialPointFoam")
axes[1].set_xlabel("time [us]")
axes[1].set_ylabel("free-surface velocity [m/s]")
axes[1].legend()
figure.savefig("stress.png")

half = STRESS/2
late = np.where((t > 0.8e-6) & (stress > half))[0]
if len(late):
    i = late[0]
    t343 = t[i - 1] + (half - stress[i - 1])*(t[i] - t[i - 1])/(stress[i] - stress[i - 1])
    print(f"t343 {t343*1e6:.4f} us, exact {3*H/C*1e6:.4f} us, "
          f"error {(t343 - 3*H/C)*1e9:.1f} ns")
plateau = (t > 0.6e-6) & (t < 0.95e-6)
print(f"plateau {stress[plateau].mean()*1e-6:.1f} MPa, exact {-STRESS*1e-6:.1f} MPa")
plateau = (ts > 0.85e-6) & (ts < 1.05e-6)
print(f"free surface {-surface[plateau].mean():.2f} m/s, exact {V:.0f} m/s")

# x-t diagram
table = case.series("stressXT", "sigma_yy.dat")
with open(case.file("postProcessing/stressXT/0/sigma_yy.dat")) as f:
    header = [line for line in f if line.startswith("#")]
centres = np.array([float(w) for w in header[-1].replace("#", " ").split()
                    if w.replace(".", "").replace("e", "").replace("-", "")
                    .replace("+", "").isdigit()])
figure, axes = plt.subplots(1, 2, figsize=(10, 5), sharey=True)
for ax, values, title in (
        (axes[0], table[:, 1:], "material points"),
        (axes[1], exact(centres[None, :], table[:, 0][:, None]),
         "exact, without failure")):
    image = ax.pcolormesh(centres*1e3, table[:, 0]*1e6, values*1e-6,
                          cmap="RdBu_r", vmin=-700, vmax=700, shading="nearest")
    ax.set_title(title)
    ax.set_xlabel("place at the start [mm]; target left of the line")
    ax.axvline(3.8, color="k", lw=0.5)
axes[0].set_ylabel("time [us]")
figure.colorbar(image, ax=axes, label="stress [MPa], tension positive")
figure.savefig("xt.png")


# Damage, from what foamToVTK wrote
def cloud(phase, index):
    files = sorted(glob.glob(f"VTK/lagrangian/{phase}/*.vtp"),
                   key=lambda f: int(f.split("_")[-1].split(".")[0]))
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(files[index])
    reader.Update()
    data = reader.GetOutput()
    return (vtk_to_numpy(data.GetPoints().GetData()),
            vtk_to_numpy(data.GetPointData().GetArray("damage")),
            vtk_to_numpy(data.GetPointData().GetArray("sigma"))[:, 1])


times = case.times("lagrangian")
chosen = [times.index(case.nearest(want, "lagrangian")) for want in (1.0e-6, 1.25e-6, 3.0e-6)]
figure, axes = plt.subplots(1, len(chosen), figsize=(13, 4.2), sharey=True)
for ax, index in zip(axes, chosen):
    for phase in ("target", "flyer"):
        x, damage, sigma = cloud(phase, index)
        image = ax.scatter(x[:, 0]*1e3, x[:, 1]*1e3, c=sigma*1e-6, s=0.4,
                           cmap="RdBu_r", vmin=-700, vmax=700, linewidths=0)
        failed = damage > 0.5
        ax.scatter(x[failed, 0]*1e3, x[failed, 1]*1e3, c="lime", s=1.5,
                   linewidths=0)
    ax.set_aspect("equal")
    ax.set_title(f"t = {float(times[index])*1e6:.2f} us", fontsize=9)
    ax.set_xlabel("x [mm]")
axes[0].set_ylabel("y [mm]")
figure.colorbar(image, ax=axes, label="sigma_yy [MPa]; green: failed points")
figure.savefig("damage.png")
