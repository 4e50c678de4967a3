"""The bent beam and the way of its end against the elastica.

The reference is the inextensible beam without shear (Euler's elastica) with the
weight P at its end and the beam's own weight q along it. With s from 0 to 1
along the beam and theta the angle below the horizontal

    theta'' = -(k + w (s1 - s)) cos(theta),   theta(0) = 0, theta'(1) = 0,

k = P L^2/(E' I), w = q L^3/(E' I) (only for s < s1 = 0.95: there the weight
begins), E' = E/(1 - nu^2) for plane strain. Solved by shooting with a
fourth-order Runge-Kutta method.
"""

import re

import numpy as np

from mpm.case import Case
from mpm.pictures import RIGID, SIGNED, colourBar, drawPoints, frame, plt, save

L, HEIGHT, G = 1.0, 0.1, 10.0
BEGIN, MASS_VOLUME = 0.95, 0.01

#: P L^2/(E' I): deflection/L, shortening/L of the end without own weight
TABLE = {1.0: (0.30172, 0.05643), 2.0: (0.49346, 0.16064)}

text = re.sub(r"//.*", "", open("constant/phaseProperties").read())
rho = [float(v) for v in re.findall(r"\brho\s+([^;\s]+)", text)]
young, nu = (float(re.search(rf"\b{name}\s+([^;\s]+)", text)[1]) for name in ("E", "nu"))
stiffness = young/(1 - nu**2)*HEIGHT**3/12
LOAD = rho[1]*MASS_VOLUME*G*L**2/stiffness
OWN = rho[0]*HEIGHT*G*L**3/stiffness


def elastica(k, w, n=400):
    """x and y along the beam"""
    h = 1/n

    def rate(s, y):
        return np.array([y[1], -(k + w*max(BEGIN - s, 0))*np.cos(y[0]),
                         np.cos(y[0]), -np.sin(y[0])])

    def shoot(moment):
        y = np.zeros((n + 1, 4))
        y[0, 1] = moment
        for i in range(n):
            s = i*h
            a = rate(s, y[i])
            b = rate(s + h/2, y[i] + h/2*a)
            c = rate(s + h/2, y[i] + h/2*b)
            d = rate(s + h, y[i] + h*c)
            y[i + 1] = y[i] + h/6*(a + 2*b + 2*c + d)
        return y

    low, high = 0.0, k + w
    for _ in range(45):
        middle = (low + high)/2
        if shoot(middle)[-1, 1] > 0:
            high = middle
        else:
            low = middle
    y = shoot((low + high)/2)
    return y[:, 2]*L, y[:, 3]*L


case = Case()
# time, smallest 3, largest 3, centre of mass 3, ...
rows = case.series("tip", "weight.dat")
t, x, y = rows[:, 0], rows[:, 7], rows[:, 8]
late = t > t[-1] - 1.0
down, short = -y[late].mean(), L - x[late].mean()
swing = (y[late].max() - y[late].min())/2

bare, loaded = elastica(LOAD, 0), elastica(LOAD, OWN)
print(f"P L^2/(E' I) = {LOAD:.4f}, own weight q L^3/(E' I) = {OWN:.4f} up to s = {BEGIN}")
if round(LOAD, 6) in TABLE:
    table = TABLE[round(LOAD, 6)]
    print(f"elastica, end load alone: deflection {-bare[1][-1]:.5f} m (table {table[0]}), "
          f"shortening {L - bare[0][-1]:.5f} m (table {table[1]})")
for name, value, reference in (("deflection", down, -loaded[1][-1]),
                               ("shortening", short, L - loaded[0][-1])):
    print(f"{name} of the end: {value:.5f} m, elastica with own weight "
          f"{reference:.5f} m, {100*(value/reference - 1):+.2f} %")
print(f"swing that is left in the last second: +-{100*swing/down:.2f} % of the deflection")

figure, axes = plt.subplots(1, 2, figsize=(11, 3.8))
last = case.times("lagrangian")[-1]
frame(axes[0], (-0.03, 1.15), (-0.5, 0.1), "x [m]", "y [m]", f"{last} s")
for phase in ("beam", "weight"):
    cloud = case.points(last, phase)
    image = drawPoints(axes[0], cloud, cloud["sigma"][:, 0]*1e-3 if phase == "beam" else RIGID,
                       SIGNED, (-2, 2), close=1)
    if phase == "beam":
        bar = image
axes[0].axvspan(-0.03, 0, color="0.3", lw=0)
axes[0].plot(*loaded, "k-", zorder=5, lw=1, label="elastica with own weight")
axes[0].plot(*bare, "k:", zorder=5, lw=1, label="elastica, end load alone")
axes[0].legend(loc="lower left")
colourBar(figure, bar, axes[0], "$\\sigma_{xx}$ [kPa]", shrink=0.6)
axes[1].plot(t, -y, "C0", label="centre of the weight")
axes[1].axhline(-loaded[1][-1], color="k", lw=1, label="elastica with own weight")
axes[1].axhline(-bare[1][-1], color="k", ls=":", lw=1, label="elastica, end load alone")
axes[1].set_xlabel("time [s]")
axes[1].set_ylabel("deflection of the end [m]")
axes[1].legend()
save(figure, "cantilever.png")
