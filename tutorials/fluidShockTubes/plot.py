"""Figures of README.md's table, and the picture: density, velocity and pressure of three
tubes over the exact solution, which riemannEquation.py of the tests has."""

import os
import sys

import numpy as np

from mpm.case import Case
from mpm.pictures import plt, save

TESTS = os.path.join(os.environ["MPM_PROJECT_DIR"], "tests")
sys.path.insert(0, os.path.join(TESTS, "lib"))
import riemannEquation as exact  # noqa: E402

#: Equations of state as in constant/phaseProperties, states (rho, u, p) of both sides,
#: place of the interface [m], a pressure below the one between the waves
WATER = exact.StiffenedGas(4.4, 6e8)
TUBES = {
    "waterAir": ("water 1 GPa | air 50 kg/m$^3$", ("water", "air"),
                 (WATER, exact.StiffenedGas(1.4)), (1000, 0, 1e9), (50, 0, 1e5), 0.7, 5e4),
    "productsWater": ("products of TNT | water", ("products", "water"),
                      (exact.JWL(3.712e11, 3.231e9, 4.15, 0.95, 0.3, 1630), WATER),
                      (1630, 0, 8.4e9), (1000, 0, 1e5), 0.5, 5e4),
    "vanDerWaals": ("water 1 GPa | van der Waals", ("water", "gas"),
                    (WATER, exact.VanDerWaals(1.4, 5, 1e-3)), (1000, 0, 1e9), (50, 0, 1e5),
                    0.7, 5e4)}


def measured(quantity):
    """Zheng et al. (2011), with the test of the same tube."""
    return np.loadtxt(os.path.join(TESTS, f"cases/fluidsAlone/zheng2011_{quantity}.csv"),
                      delimiter=",")


figure, axes = plt.subplots(3, 3, figsize=(12, 7.5), sharex=True)
for column, (name, (title, fluids, equations, left, right, middle, lowest)) in zip(
        axes.T, TUBES.items()):
    case = Case(name)
    n = int(case.entry("system/blockMeshDict", "n"))
    time = case.times()[-1]
    t = float(time)
    solution = exact.Riemann(equations, left, right, lowest)
    x = (np.arange(n) + 0.5)/n
    rho, u, p = solution.at((x - middle)/t)
    found = {f: case.field(time, f) for f in ("rho", "p")}
    found["U"] = case.field(time, "U")[:, 0]
    # Means around the contact, to both sides 0.8 of the way from it to the shock; behind the
    # shock the middle third
    star = np.nonzero(abs(p/solution.p - 1) < 1e-9)[0]
    contact = middle + solution.u*t
    behind = star[x[star] > contact]
    inner = star[abs(x[star] - contact) < 0.8*(x[behind[-1]] - contact)]
    behind = behind[len(behind)//3:2*len(behind)//3]
    alpha = case.field(time, "alpha." + fluids[0])
    print(f"{name}: between the waves p {100*(found['p'][inner].mean()/solution.p - 1):+.3f} %,"
          f" u {100*(found['U'][inner].mean()/solution.u - 1):+.3f} %, density behind the shock"
          f" {100*(found['rho'][behind].mean()/solution.rhoR - 1):+.2f} %; mean |rho - exact|"
          f" over the densities' range {np.mean(abs(found['rho'] - rho))/np.ptp(rho):.4f};"
          f" cells of the interface {np.sum((alpha > 0.01) & (alpha < 0.99))};"
          f" fix-ups {sum(case.numbers('kept N, isentropic N')[-1]):.0f}")
    for label, values in zip((*fluids, "energy"), case.numbers(
            f"^Fluids: mass {fluids[0]} N {fluids[1]} N, .*energy N").T):
        print(f"    {label}: changes by {abs(values/values[0] - 1).max():.0e} of it")
    print(f"    exact: p {solution.p:.6g} Pa, u {solution.u:.6g} m/s, densities"
          f" {solution.rhoL:.5g} and {solution.rhoR:.5g} kg/m3")
    fine = np.linspace(0, 1, 4001)
    lines = solution.at((fine - middle)/t)
    for ax, values, line, factor, label in zip(
            column, (found["rho"], found["U"], found["p"]), lines, (1, 1, 1e-5),
            ("density [kg/m$^3$]", "velocity [m/s]", "pressure [bar]")):
        ax.plot(fine, factor*line, "k-", lw=0.8, label="exact")
        ax.plot(x, factor*values, "C0.", ms=3, label=f"{n} cells")
        if ax in axes[:, 0]:
            ax.set_ylabel(label)
        ax.grid(alpha=0.3)
    column[0].set_title(f"{title}, {1e6*t:g} us")
    column[2].set_xlabel("x [m]")
    if name == "vanDerWaals":
        for ax, quantity, values, factor in ((column[1], "u", found["U"], 1),
                                             (column[2], "p", found["p"], 1e-5)):
            points = measured(quantity)
            ax.plot(points[:, 0], factor*points[:, 1], "C1+", ms=5, label="Zheng et al.")
            # Their shock is 0.010 ahead of the exact one: no points there
            near = points[abs(points[:, 0] - 0.855) > 0.012]
            print(f"    {quantity} against Zheng et al.: mean difference"
                  f" {100*np.mean(abs(np.interp(near[:, 0], x, values) - near[:, 1]))/np.ptp(near[:, 1]):.2f}"
                  " % of the range")
    column[2].legend()
save(figure, "tubes.png")
