"""Pressure along the channel against Darcy's law for a gas, and the load on the block.

With the mass flux G [kg/m2/s], rho = p/(R T) and T constant (the block neither moves
nor takes heat, Mach 0.03) grad p = -mu/k G/rho has the solution

    p^2 = p_2^2 + 2 mu G R T/k (x_2 - x)
"""

import re

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

K, MU, R, T = 2e-9, 1.8e-5, 287.0, 300.0
LENGTH, AREA = 0.2, 1e-4


def field(time, name):
    with open(f"{time}/{name}") as f:
        text = f.read()
    inner = text[text.index("internalField"):]
    count = re.search(r"List<\w+>\s*(\d+)\s*\(", inner)
    body = inner[count.end():]
    values = body[:re.search(r"\)\s*;", body).start()].translate(str.maketrans("()", "  "))
    return np.array(values.split(), float).reshape(int(count[1]), -1).squeeze()


def exact(x, x2, p2, G):
    return np.sqrt(p2**2 + 2*MU*G*R*T/K*(x2 - x))


if __name__ == "__main__":
    with open("log.materialPointFoam") as f:
        log = f.read()
    time = "0.04"
    p = field(time, "p")
    G = field(time, "thetaRhoU.air")[:, 0]
    n = len(p)
    x = -0.1 + 0.4*(np.arange(n) + 0.5)/n

    # Between the first and the last cell that lie in the block with their neighbours
    inside = np.nonzero((x > 0.4/n) & (x < LENGTH - 0.4/n))[0]
    a, b = inside[0], inside[-1]
    flux = np.mean(G[inside])
    drop = p[a] - p[b]
    expected = exact(x[a], x[b], p[b], flux) - p[b]
    print(f"mass flux {flux:.5f} kg/m2/s, of the inlet {p[0]/(R*T)*10:.5f}, in the block"
          f" within {np.ptp(G[inside])/flux:.1e}")
    print(f"pressure drop between the block's cells {drop:.1f} Pa, Darcy {expected:.1f} Pa:"
          f" {100*(drop/expected - 1):+.2f} %")
    linear = MU/K*flux*R*T/p[b]*(x[b] - x[a])
    print(f"  (constant density would give {linear:.1f} Pa)")
    whole = exact(0, LENGTH, 1e5, flux) - 1e5
    ends = np.interp(0, x[x < 0][-2:], p[x < 0][-2:]), p[-1]
    print(f"pressure before less behind the block {ends[0] - ends[1]:.1f} Pa, Darcy with"
          f" 1e5 Pa behind it {whole:.1f} Pa: {100*((ends[0] - ends[1])/whole - 1):+.2f} %")
    force = float(re.findall(r"Load on block: force \(([^ ]+)", log)[-1])
    momentum = flux**2*R*T*(1/p[-1] - 1/p[0])*AREA
    print(f"load on the block {force:.5f} N; pressure difference times area"
          f" {(p[0] - p[-1])*AREA:.5f} N, less the gas' change of momentum"
          f" {(p[0] - p[-1])*AREA - momentum:.5f} N")

    figure, axes = plt.subplots(2, 1, figsize=(8, 6.5), sharex=True,
                                constrained_layout=True)
    for ax in axes:
        ax.axvspan(0, LENGTH, color="0.9")
    fine = np.linspace(x[a], x[b], 200)
    axes[0].plot(x, p*1e-3, "C0.", label="cells")
    axes[0].plot(fine, exact(fine, x[b], p[b], flux)*1e-3, "k-", lw=1,
                 label="Darcy, compressible, through the last cell")
    axes[0].plot(fine, (p[b] + linear*(x[b] - fine)/(x[b] - x[a]))*1e-3, "k:",
                 label="Darcy, constant density")
    axes[0].set_ylabel("p [kPa]")
    axes[0].legend()
    axes[1].plot(x, G, "C0.", label=r"$\theta\rho u$ of the cells")
    axes[1].set_ylim(0, 1.3*G.max())
    axes[1].set_ylabel("mass flux [kg/m2/s]")
    axes[1].set_xlabel("x [m]; the block is grey")
    axes[1].legend()
    figure.savefig("darcy.png", dpi=130)
