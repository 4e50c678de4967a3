"""Length, foot and outline of the bar against published computations, the experiment
and a measured outline; picture of the plastic strain and temperature."""

import csv
import os

import numpy as np

from mpm.case import Case
from mpm.pictures import HEAT, RIGID, VALUES, colourBar, drawPoints, frame, plt, save
from shape import Bar, energy

#: What the published constants give in other codes, and the experiment
CODES, EXPERIMENT = (0.68, 1.91), (0.638, 1.78)


def rows(path):
    with open(path) as f:
        return list(csv.DictReader(line for line in f if not line.startswith("#")))


def tell(name, bar, h, case):
    t, kinetic = energy(case)
    part, widest = bar.fractured(h)
    slow = t[np.argmax(kinetic < 0.01)]*1e6
    print(f"{name}: Lf/L0 {bar.length/bar.length0:.4f}, Df/D0 {bar.foot/7.62e-3:.4f},"
          f" bulge at 0.2 Lf {bar.bulge()*1e3:.2f} mm; kinetic energy below 1 % at"
          f" {slow:.1f} us; plastic strain {bar.strain.max():.2f}, {bar.T.max():.0f} K;"
          f" {100*part:.1f} % of neighbours more than a cell apart (most {widest:.2f})")


cases = [("0.381 mm", "variants/coarse", 0.381e-3), ("0.1905 mm", ".", 0.1905e-3),
         ("0.09525 mm", "variants/fine", 0.09525e-3)]
bars = {}
for name, case, h in cases:
    if os.path.isdir(case + "/postProcessing"):
        bars[name] = Bar(case)
        tell("cells of " + name, bars[name], h, case)
main = bars["0.1905 mm"]
for what, value in (("published computations", CODES), ("experiment", EXPERIMENT)):
    print(f"against {what}: Lf {100*(main.length/main.length0/value[0] - 1):+.1f} %,"
          f" Df {100*(main.foot/7.62e-3/value[1] - 1):+.1f} %")
wilkins = Bar("variants/wilkins", 23.47e-3)
tell("210 m/s, 23.47 mm", wilkins, 0.1905e-3, "variants/wilkins")
shot = rows("taylor_copper_measured.csv")[0]
print(f"measured at 210 m/s: Lf/L0 {shot['Lf_over_L0']}, Df/D0 {shot['Rf_over_R0']},"
      f" bulge {2*float(shot['W_0.2Lf_mm']):.2f} mm")

figure, axes = plt.subplots(1, 2, figsize=(9, 6), sharey=True)
for name, bar in bars.items():
    x, r = bar.outline.T*1e3
    axes[0].plot(np.append(r, [r[-1], 0]), np.append(x, [1e3*bar.length]*2),
                 label="cells of " + name)
L, D = 25.4, 7.62
axes[0].plot([0, EXPERIMENT[1]*D/2], [EXPERIMENT[0]*L, 0], "kx", label="experiment (JC 1983)")
axes[0].plot([10.1/2], [0.2*EXPERIMENT[0]*L], "k+")
axes[0].plot([0, CODES[1]*D/2], [CODES[0]*L, 0], "o", mfc="none", color="0.5",
             label="other codes, same constants")
axes[0].set_title("25.4 mm, 190 m/s", fontsize=9)
x, r = wilkins.outline.T*1e3
axes[1].plot(np.append(r, [r[-1], 0]), np.append(x, [1e3*wilkins.length]*2),
             label="cells of 0.1905 mm")
measured = np.array([(float(row["r_mm"]), float(row["z_mm"]))
                     for row in rows("taylor_copper_outlines.csv") if row["id"] == "1"])
axes[1].plot(*measured.T, "kx-", lw=0.5, label="measured (Wilkins & Guinan)")
axes[1].set_title("23.47 mm, 210 m/s", fontsize=9)
for ax in axes:
    ax.set_xlabel("r [mm]")
    ax.set_xlim(0, 9)
    ax.set_ylim(-0.3, 23)
    ax.set_aspect("equal")
    ax.legend(fontsize=7, loc="upper right")
axes[0].set_ylabel("distance from the anvil [mm]")
save(figure, "profile.png")

figure, axes = plt.subplots(1, 5, figsize=(11, 4), sharey=True)
for ax, want in zip(axes, (0, 2e-5, 4e-5, 1e-4, 1e-4)):
    last = ax is axes[-1]
    cloud = Case().points(Case().nearest(want, "lagrangian"), "bar")
    frame(ax, (-8, 8), (-0.8, 26.5), "r [mm]", None,
          f"{want*1e6:.0f} $\\mu$s" + (", temperature" if last else ""))
    ax.axhspan(-0.8, 0, color=RIGID, lw=0)
    image = drawPoints(ax, cloud, cloud["T" if last else "plasticStrain"],
                       HEAT if last else VALUES, None if last else (0, 2), scale=1e3,
                       axes=(1, 0), close=2.5, mirror=True)
    if want == 1e-4:
        colourBar(figure, image, ax if last else axes[:-1],
                  "temperature [K]" if last else "plastic strain", shrink=0.75)
axes[0].set_ylabel("distance from the anvil [mm]")
save(figure, "strain.png")
