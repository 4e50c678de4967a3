"""Nose and tail over time beside Alekseevskii and Tate's theory; materials and
temperature at four times; the figures of the README."""

import os

import numpy as np

import penetration as p
from mpm.case import Case
from mpm.pictures import BODY, FAILED, HEAT, colourBar, drawPoints, frame, plt, save

LIMITS = (4.5e9, 5.5e9)


def tell(name, case, h, steel="steelHzB"):
    path = p.Path(case)
    speed = path.speed()
    band = [p.tateSpeed(R) for R in reversed(LIMITS)]
    own = p.cavityResistance(p.material(steel))
    print(f"{name}: interface speed {speed:.1f} m/s at 10 to 40 us, Tate"
          f" {band[0]:.1f} to {band[1]:.1f}; effective Rt {p.effectiveR(speed)/1e9:.2f} GPa,"
          f" cavity in {steel} {own/1e9:.2f}: {p.tateSpeed(own):.1f} m/s")
    tails = [p.tate(R, 40e-6)[2] for R in LIMITS]
    times = p.tate(LIMITS[0], 40e-6)[0]
    some = (times >= 10e-6)
    here = path.at(times[some])[1]
    print(f"    tail beside Tate's, Rt 4.5: {1e3*np.abs(here - tails[0][some]).max():.2f} mm,"
          f" Rt 5.5: {1e3*np.abs(here - tails[1][some]).max():.2f} mm")
    end = p.times(case)[-1]
    depth = path.nose.max()
    finals = [p.tate(R, 90e-6)[1][-1] for R in (*LIMITS, own)]
    print(f"    deepest {depth*1e3:.2f} mm at {path.t[path.nose.argmax()]*1e6:.0f} us, P/L"
          f" {depth/p.LENGTH:.3f}; Tate {finals[1]/p.LENGTH:.3f} to {finals[0]/p.LENGTH:.3f},"
          f" with the cavity's Rt {finals[2]/p.LENGTH:.3f}")
    print(f"    at {float(end)*1e6:.0f} us {100*p.coating(case, end, h):.1f} % of the rod's"
          f" mass within 2 cells of the target")
    print(f"    neighbours more than a cell apart: rod"
          f" {100*p.fractured(case, end, 'rod', h):.1f} %, target"
          f" {100*p.fractured(case, end, 'target', h):.1f} %")
    return path


paths = {"HzB, cells of 0.5 mm": tell("HzB, cells of 0.5 mm", ".", 0.5e-3),
         "4340, cells of 0.5 mm": tell("4340, cells of 0.5 mm", "variants/steel4340", 0.5e-3,
                                       "steel4340")}
if os.path.isdir("variants/fine/postProcessing"):
    paths["HzB, cells of 0.25 mm"] = tell("HzB, cells of 0.25 mm", "variants/fine", 0.25e-3)
for name in ("linear", "gimp", "linearCellMean", "gimpCellMean"):
    if os.path.isdir(f"variants/{name}/postProcessing"):
        print(f"one velocity field, {name}: interface speed"
              f" {p.Path(f'variants/{name}').speed():.1f} m/s")
weak = p.Path("variants/hydrodynamic").speed(10e-6, 40e-6)
exact = p.SPEED/(1 + np.sqrt(p.RHO_T/p.RHO_P))
print(f"without strength: {weak:.1f} m/s at 10 to 40 us, exact {exact:.1f}"
      f" ({100*(weak/exact - 1):+.2f} %)")

figure, ax = plt.subplots(figsize=(7.5, 6))
times = p.tate(LIMITS[0], 80e-6)[0]*1e6
nose = [p.tate(R, 80e-6)[1]*1e3 for R in LIMITS]
tail = [p.tate(R, 80e-6)[2]*1e3 for R in LIMITS]
ax.fill_between(times, *nose, color="0.8", label="Alekseevskii-Tate, Rt 4.5 to 5.5 GPa")
ax.fill_between(times, *tail, color="0.8")
own = p.cavityResistance(p.material("steelHzB"))
ax.plot(times, p.tate(own, 80e-6)[1]*1e3, "C0--", lw=1,
        label=f"the same, Rt {own/1e9:.2f} (cavity in HzB)")
table = np.loadtxt("tate_1250.csv", delimiter=",", skiprows=2)
ax.plot(table[:, 0], table[:, 1], "k:", lw=1, label="the same, Rt 5.5 (tate_1250.csv)")
ax.plot(table[:, 0], table[:, 2], "k:", lw=1)
for i, (name, path) in enumerate(paths.items()):
    ax.plot(path.t*1e6, path.nose*1e3, f"C{i}", label=name)
    ax.plot(path.t*1e6, path.tail*1e3, f"C{i}")
ax.set_xlabel("time [us]")
ax.set_ylabel("nose and tail [mm]; face of the target 0")
ax.invert_yaxis()
ax.legend()
save(figure, "penetration.png")

PHASES = {"target": BODY, "rod": "#d98b3a", "debris": FAILED}
figure, axes = plt.subplots(1, 4, figsize=(11, 5.3), sharey=True)
for ax, want in zip(axes, (10e-6, 25e-6, 40e-6, 80e-6)):
    name = Case().nearest(want, "lagrangian/rod")
    frame(ax, (-16, 16), (38, -42), "r [mm]", None, f"{float(name)*1e6:.0f} $\\mu$s")
    for phase, colour in PHASES.items():
        if not os.path.isdir(f"{name}/lagrangian/{phase}"):
            continue
        cloud = Case().points(name, phase)
        # Materials on the left half, temperature on the right
        drawPoints(ax, cloud, colour, scale=1e3, axes=(1, 0), close=1, flip=True)
        image = drawPoints(ax, cloud, cloud["T"], HEAT, (294, 1500), scale=1e3, axes=(1, 0),
                           close=1)
axes[0].set_ylabel("x [mm]")
axes[0].legend(handles=[plt.Rectangle((0, 0), 1, 1, color=c) for c in PHASES.values()],
               labels=[*PHASES], loc="upper left")
colourBar(figure, image, axes, "right halves: temperature [K]", extend="max")
save(figure, "materials.png", 120)
