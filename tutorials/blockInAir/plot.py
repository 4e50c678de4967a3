"""Figures of README.md's table; pictures of the block and the air."""

import os

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import fields

P0, N, M, H = 1e5, 40, 30, 1e-3
EDGES = np.arange(N + 1)


def balance(case):
    table = np.loadtxt(os.path.join(case, "postProcessing/balance/0/total.dat"))
    return table[np.unique(table[:, 0], return_index=True)[1]]


def extremes(case):
    return np.loadtxt(os.path.join(case, "postProcessing/pressure/0/fieldMinMax.dat"))


# --- moving with the air
p, table = extremes("moving"), balance("moving")
Theta = fields.log("moving", "^Theta: min N, max N")
u = table[:, 3:5]/table[:, 2:3]
print(f"moving: {np.hypot(80, 60)*p[-1, 0]/H:.0f} cells in {len(p)} steps, |dP|/P at most"
      f" {abs(p[:, 1:]/P0 - 1).max():.1e}, Theta - 1 {Theta.min() - 1:+.1e} to"
      f" {Theta.max() - 1:+.1e}, velocity {abs(u - [80, 60]).max()/100:.1e}, fix-ups"
      f" {fields.fixups('moving'):.0f}")

figure, axes = plt.subplots(1, 3, figsize=(14, 4.6), constrained_layout=True)
for ax, wanted in zip(axes, (0, 1.6e-4)):
    time = min(fields.times("moving"), key=lambda t: abs(float(t) - wanted))
    if float(time) > 0:
        theta = fields.cells("moving", time, "theta.air", N, N)
        image = ax.pcolormesh(EDGES, EDGES, theta, cmap="Blues_r", vmin=0, vmax=1)
    x = fields.points("moving", time, "block", "x")/H
    ax.plot(*x[:, :2].T, "k.", ms=1.2)
    ax.set_title(f"{float(time)*1e3:.2f} ms", fontsize=10)
    ax.set_xlim(0, N)
    ax.set_ylim(0, N)
    ax.set_aspect("equal")
    ax.set_xlabel("x [mm]")
axes[0].set_ylabel("y [mm]")
figure.colorbar(image, ax=axes[1], label="volume fraction of the air")
axes[2].semilogy(p[:, 0]*1e3, np.maximum(abs(p[:, 1:]/P0 - 1).max(axis=1), 1e-17), lw=0.7)
axes[2].axhline(1e-10, color="k", ls=":")
axes[2].set_xlabel("time [ms]")
axes[2].set_ylabel("largest |dP|/P; dotted: limit")
figure.savefig("moving.png", dpi=130)

# --- carried by the air
table, p = balance("carried"), extremes("carried")
gas = fields.log("carried", r"^Gas air: mass N, momentum \(N N N\), energy N")
mass, momentum = gas[:, 0], gas[:, 1]
steps = len(table)
solidMass = table[0, 2]
total = momentum[:steps] + table[:len(momentum), 3]
energy = gas[:, 4] + fields.log("carried", "^Energy: kinetic .* total N").ravel()
end = total[0]/(mass[0] + solidMass)
kinetic = 0.5*momentum[0]**2/mass[0]
t = table[:, 0]
block = table[:, 3]/solidMass
print(f"carried: momentum of all {abs(total/total[0] - 1).max():.1e}, mass of the gas"
      f" {abs(mass/mass[0] - 1).max():.1e}, energy of all"
      f" {(energy[-1] - energy[0])/kinetic:+.1e} of the kinetic energy at the start")
print(f"carried: at {t[-1]*1e3:.0f} ms the block has {block[-1]:.2f} m/s, the air"
      f" {momentum[-1]/mass[-1]:.2f}, both together {end:.2f}; across"
      f" {abs(table[:, 4]).max()/solidMass:.1e} m/s; P {p[:, 1].min()/P0:.3f} to"
      f" {p[:, 2].max()/P0:.3f} bar, fix-ups {fields.fixups('carried'):.0f}")

figure, axes = plt.subplots(1, 3, figsize=(14.5, 4.6), constrained_layout=True)
time = min(fields.times("carried"), key=lambda name: abs(float(name) - 0.6e-3))
for ax, name, label in ((axes[0], "p", "pressure of the air [bar]"),
                        (axes[1], "U.air", "speed of the air [m/s]")):
    field = fields.cells("carried", time, name, M, M)
    field = field*1e-5 if name == "p" else np.linalg.norm(field, axis=2)
    image = ax.pcolormesh(np.arange(M + 1), np.arange(M + 1), field, cmap="viridis")
    ax.plot(*(fields.points("carried", time, "block", "x")/H)[:, :2].T, "w.", ms=0.8)
    ax.set_aspect("equal")
    ax.set_xlabel("x [mm]")
    ax.set_title(f"{float(time)*1e3:.1f} ms", fontsize=10)
    figure.colorbar(image, ax=ax, label=label)
axes[0].set_ylabel("y [mm]")
axes[2].plot(t*1e3, block, label="block")
axes[2].plot(t*1e3, momentum[:steps]/mass[:steps], label="air")
axes[2].axhline(end, color="k", ls=":", lw=1, label="all with one velocity")
axes[2].set_xlabel("time [ms]")
axes[2].set_ylabel("mean velocity along x [m/s]")
axes[2].legend(fontsize=8)
figure.savefig("carried.png", dpi=130)
