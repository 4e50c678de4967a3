"""Stress about the hole, along the section above it and at its rim, beside Kirsch."""

import numpy as np

from mpm.case import Case
from mpm.pictures import VALUES, colourBar, frame, plt, save
from results import A, S, errors, kirsch, stresses

RUNS = (("triangles, nodeDual", ".", "C0", "o"), ("boxes, GIMP", "variants/boxes", "C1", "s"))

figure, axes = plt.subplots(1, 3, figsize=(12, 3.8))
x, y, sxx, *_ = stresses(Case())
near = (x < 3.2*A) & (y < 3.2*A)
mm = 1e3*np.array((x[near], y[near]))
triangulation = plt.matplotlib.tri.Triangulation(*mm)
middle = mm[:, triangulation.triangles].mean(axis=2)
triangulation.set_mask(np.hypot(*middle) < 1e3*A)
image = axes[0].tripcolor(triangulation, sxx[near]/S, cmap=VALUES, vmin=-1, vmax=3,
                          shading="gouraud", rasterized=True)
frame(axes[0], (0, 30), (0, 30), title="stress along x / S, triangles")
colourBar(figure, image, axes[0], None, shrink=0.9)

fine = np.linspace(A, 4*A, 200)
axes[1].plot(fine/A, kirsch(0*fine, fine)[0]/S, "k-", lw=1, label="Kirsch")
angle = np.linspace(0, np.pi/2, 200)
q, c2 = 1/1.02**2, np.cos(2*angle)
axes[2].plot(np.degrees(angle), (1 + q - (1 + 3*q*q)*c2)/2, "k-", lw=1,
             label="Kirsch, 0.02 a beyond the rim")
for label, path, colour, marker in RUNS:
    case = Case(path)
    x, y, sxx, sxy, syy, V = stresses(case)
    r, theta = np.hypot(x, y), np.arctan2(y, x)
    some = theta > np.radians(87)
    axes[1].plot(r[some]/A, sxx[some]/S, colour + marker, ms=3, mfc="none", label=label)
    c, s = np.cos(theta), np.sin(theta)
    hoop = sxx*s*s - 2*sxy*s*c + syy*c*c
    some = r < 1.04*A
    axes[2].plot(np.degrees(theta[some]), hoop[some]/S, colour + marker, ms=3, mfc="none",
                 label=label)
    peak, rms = errors(case)
    print(f"{label}: {len(x)} points, stress at the rim {peak:.3f} S ({100*(peak/3 - 1):+.1f} %),"
          f" rms error up to 3 a {100*rms:.2f} % of S")
axes[1].set(xlim=(1, 4), xlabel="y/a above the hole", ylabel="stress along x / S")
axes[2].set(xlabel="angle from the x axis [degrees]", ylabel="hoop stress / S, up to 0.04 a from the rim")
for ax in axes[1:]:
    ax.legend()
save(figure, "kirsch.png")
