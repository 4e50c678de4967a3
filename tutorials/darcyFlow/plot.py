"""Pressure along the channel against Darcy's law for a gas, and the load on the block.

With the mass flux G [kg/m2/s], rho = p/(R T) and T constant (the block neither moves
nor takes heat, Mach 0.01) grad p = -mu/k G/rho has the solution

    p^2 = p_2^2 + 2 mu G R T/k (x_2 - x)
"""

import numpy as np

from mpm.case import Case
from mpm.pictures import plt, save

K, MU, R, T = 4e-10, 1.8e-5, 287.0, 300.0
LENGTH, AREA = 0.2, 1e-4


def exact(x, x2, p2, G):
    return np.sqrt(p2**2 + 2*MU*G*R*T/K*(x2 - x))


def results():
    case = Case()
    p, u = case.field("0.15", "p"), case.field("0.15", "U.air")[:, 0]
    n = len(p)
    x = -0.1 + 0.4*(np.arange(n) + 0.5)/n

    # What flows outside the block, and the first and the last cell that lie in it
    # with their neighbours
    G = p/(R*T)*u
    flux, behind = G[x < -0.02].mean(), G[x > LENGTH + 0.02].mean()
    inside = np.nonzero((x > 0.4/n) & (x < LENGTH - 0.4/n))[0]
    a, b = inside[0], inside[-1]
    force = case.numbers(r"Load on block: force \(N")[-1]
    pressures = (p[0] - p[-1])*AREA
    return {"x": x, "p": p, "u": u, "a": a, "b": b, "flux": flux, "fluxBehind": behind,
            "drop": p[a] - p[b], "expected": exact(x[a], x[b], p[b], flux) - p[b],
            "linear": MU/K*flux*R*T/p[b]*(x[b] - x[a]), "force": force,
            "pressures": pressures,
            "exactForce": pressures - flux**2*R*T*(1/p[-1] - 1/p[0])*AREA}


if __name__ == "__main__":
    r = results()
    x, p, a, b = r["x"], r["p"], r["a"], r["b"]
    flux, linear = r["flux"], r["linear"]
    print(f"mass flux {flux:.5f} kg/m2/s, behind the block {r['fluxBehind']/flux - 1:+.1e}")
    print(f"pressure drop between the block's cells {r['drop']:.1f} Pa, Darcy"
          f" {r['expected']:.1f} Pa: {100*(r['drop']/r['expected'] - 1):+.2f} %")
    print(f"  (constant density would give {linear:.1f} Pa)")
    whole = exact(0, LENGTH, 1e5, flux) - 1e5
    print(f"pressure before less behind the block {p[0] - p[-1]:.1f} Pa, Darcy {whole:.1f} Pa:"
          f" {100*((p[0] - p[-1])/whole - 1):+.2f} %")
    print(f"load on the block {r['force']:.6f} N; pressures {r['pressures']:.6f} N, less the"
          f" gas' change of momentum {r['exactForce']:.6f} N")

    figure, axes = plt.subplots(2, 1, figsize=(8, 6.5), sharex=True)
    for ax in axes:
        ax.axvspan(0, LENGTH, color="0.9")
    fine = np.linspace(x[a], x[b], 200)
    axes[0].plot(x, p*1e-3, "C0.", label="cells")
    axes[0].plot(fine, exact(fine, x[b], p[b], flux)*1e-3, "k-", lw=1,
                 label="Darcy, compressible, through the last cell")
    axes[0].plot(fine, (p[b] + linear*(x[b] - fine)/(x[b] - x[a]))*1e-3, "k:",
                 label="Darcy, constant density")
    axes[0].set_ylabel("p [kPa]")
    axes[0].legend(fontsize="medium")
    axes[1].plot(x, r["u"], "C0.")
    axes[1].set_ylim(0, None)
    axes[1].set_ylabel("velocity of the air [m/s]")
    axes[1].set_xlabel("x [m]; the block is grey")
    save(figure, "darcy.png")
