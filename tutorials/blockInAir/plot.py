"""Figures of README.md's table; pictures of the block and the air."""

import numpy as np

from mpm.case import Case
from mpm.pictures import BODY, GAS, PART, colourBar, drawPoints, frame, plt, save

P0, R, T0, GAMMA = 1e5, 287, 290, 1.4
N, M, H = 40, 10, 1e-3        # cells along x, and along y in the tube
EDGES = np.arange(N + 1)


def tables(case):
    """Least and largest pressure, balance of the block over time."""
    return (case.series("pressure", "fieldMinMax.dat"),
            case.series("balance", "total.dat", once=True))


# --- moving with the air
moving = Case("moving")
p, table = tables(moving)
Theta = moving.numbers("^Theta: min N, max N")
u = table[:, 3:5]/table[:, 2:3]
print(f"moving: {np.hypot(80, 60)*p[-1, 0]/H:.0f} cells in {len(p)} steps, |dP|/P at most"
      f" {abs(p[:, 1:]/P0 - 1).max():.1e}, Theta - 1 {Theta.min() - 1:+.1e} to"
      f" {Theta.max() - 1:+.1e}, velocity {abs(u - [80, 60]).max()/100:.1e}, fix-ups"
      f" {moving.fixups():.0f}")

figure, axes = plt.subplots(1, 3, figsize=(11, 3.5), gridspec_kw={"width_ratios": (1, 1, 1.2)})
for ax, wanted in zip(axes, (0, 1.6e-4)):
    time = moving.nearest(wanted)
    frame(ax, (0, N), (0, N), title=f"{float(time)*1e3:.2f} ms")
    # At the start no field is written yet: free air where no points are
    if float(time) > 0:
        theta = moving.field(time, "theta.air", N, N)
        image = ax.pcolormesh(EDGES, EDGES, theta, cmap=PART, vmin=0, vmax=1, zorder=GAS)
    else:
        ax.set_facecolor(PART(1.0))
    drawPoints(ax, moving.points(time, "block"), BODY, scale=1/H, outline="k")
    ax.annotate("", (0.9, 0.9), (0.75, 0.7875), xycoords="axes fraction", zorder=5,
                arrowprops={"arrowstyle": "-|>", "color": "k"})
    ax.text(0.72, 0.9, "100 m/s", transform=ax.transAxes, ha="center", zorder=5, fontsize=8)
colourBar(figure, image, axes[1], "volume fraction of the air")
axes[2].semilogy(p[:, 0]*1e3, np.maximum(abs(p[:, 1:]/P0 - 1).max(axis=1), 1e-17), lw=0.7)
axes[2].axhline(1e-10, color="k", ls=":", lw=0.8)
axes[2].text(0, 0.9e-10, "limit", fontsize=8, va="top")
axes[2].set(xlabel="time [ms]", ylabel="largest |p - p$_0$|/p$_0$")
save(figure, "moving.png")

# --- carried by the air
carried = Case("carried")
p, table = tables(carried)
gas = carried.numbers(r"^Gas air: mass N, momentum \(N N N\), energy N")
mass, momentum = gas[:, 0], gas[:, 1]
steps = len(table)
solidMass = table[0, 2]
total = momentum[:steps] + table[:len(momentum), 3]
energy = gas[:, 4] + carried.numbers("^Energy: kinetic .* total N").ravel()
end = total[0]/(mass[0] + solidMass)
kinetic = 0.5*momentum[0]**2/mass[0]
volume = mass[0]*R*T0/P0
E, RHO = 7e7, 24           # of the block
# Heat: what kinetic energy is lost; the block is pressed together a little
rise = (kinetic - 0.5*(mass[0] + solidMass)*end**2)/(
    volume/(GAMMA - 1) + GAMMA/(GAMMA - 1)*P0*solidMass/RHO/E)
t = table[:, 0]
block = table[:, 3]/solidMass
air = momentum/mass
pEnd, theta = (carried.field(carried.times()[-1], name, N, M) for name in ("p", "theta.air"))
print(f"carried: momentum of all {abs(total/total[0] - 1).max():.1e}, mass of the gas"
      f" {abs(mass/mass[0] - 1).max():.1e}, energy of all"
      f" {(energy[-1] - energy[0])/kinetic:+.1e} of the kinetic energy at the start")
print(f"carried: at {t[-1]*1e3:.0f} ms block {block[-1]:.4f} m/s, air {air[-1]:.4f}, exact"
      f" {end:.4f}; along y {abs(table[:, 4]).max()/solidMass:.1e} m/s")
print(f"carried: pressure at the end {pEnd[theta > 0.99].mean():.1f} Pa, exact"
      f" {P0 + rise:.1f}; on the way {p[:, 1].min()/P0:.3f} to {p[:, 2].max()/P0:.3f} bar,"
      f" fix-ups {carried.fixups():.0f}")

figure, axes = plt.subplots(2, 2, figsize=(12, 6))
x = (np.arange(N) + 0.5)
for color, wanted in enumerate((0.04e-3, 0.08e-3, 0.16e-3, 3e-3)):
    name = carried.nearest(wanted)
    free = carried.field(name, "theta.air", N, M)[0] > 0.5
    for ax, field in ((axes[0, 0], "p"), (axes[0, 1], "U.air")):
        line = carried.field(name, field, N, M)[0]
        line = line*1e-5 if field == "p" else line[:, 0]
        ax.plot(x, np.where(free, line, np.nan), ".-", ms=3, lw=1, color=f"C{color}",
                label=f"{float(name)*1e3:.2f} ms")
for ax, label in ((axes[0, 0], "pressure of the air [bar]"),
                  (axes[0, 1], "velocity of the air [m/s]")):
    ax.set_xlabel("x [mm]; gap: the block")
    ax.set_ylabel(label)
    ax.legend()
axes[1, 0].plot(t*1e3, block, label="block")
axes[1, 0].plot(t*1e3, air[:steps], label="air")
axes[1, 0].axhline(end, color="k", ls=":", lw=1, label="exact, at the end")
axes[1, 0].set_ylabel("mean velocity [m/s]")
axes[1, 0].legend()
axes[1, 1].plot(p[:, 0]*1e3, p[:, 1:]*1e-5, lw=0.8)
axes[1, 1].axhline((P0 + rise)*1e-5, color="k", ls=":", lw=1)
axes[1, 1].set_ylabel("least and largest pressure [bar];\ndotted: exact, at the end")
for ax in axes[1]:
    ax.set_xlabel("time [ms]")
save(figure, "carried.png")
