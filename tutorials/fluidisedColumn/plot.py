"""Pressure drop of the bed, force on the grid and place of the bed while the stream
grows, against Ergun's law and the weight of the bed.

    fixed bed    dp/H = 150 (1-e)^2 mu U/(e^3 d^2) + 1.75 (1-e) rho U^2/(e^3 d)
    fluidised    dp/H = (1-e) (rho_s - rho_g) g

U: superficial velocity in the middle of the bed; where both are equal it is that of
minimum fluidisation.
"""

import numpy as np

from mpm.case import Case
from mpm.pictures import plt, save

MU, D, RHO_S, G, SHARE, H, R, T = 1.8e-5, 1e-3, 2500.0, 9.81, 0.55, 0.4, 287.0, 300.0
AREA, E = 1e-4, 1 - 0.55


def ergun(U, rho):
    return (150*SHARE**2*MU*U/(E**3*D**2) + 1.75*SHARE*rho*U**2/(E**3*D))*H


def minimum(rho):
    a, b = 1.75*SHARE*rho/(E**3*D), 150*SHARE**2*MU/(E**3*D**2)
    return (-b + np.sqrt(b*b + 4*a*SHARE*(RHO_S - rho)*G))/(2*a)


def results():
    """Time, superficial velocity in the bed, gas density there, pressure drop, force
    on the grid, centre of the bed."""
    case = Case()
    p = case.series("pressure", "p")
    t = p[:, 0]
    rho = 0.5*(p[:, 1] + p[:, 2])/(R*T)
    U = np.interp(t, (0, 0.05, 0.3), (0, 0.645, 0.79))*p[:, 1]/(R*T)/rho
    # Less what the air itself weighs, between the probes
    drop = p[:, 1] - p[:, 2] - rho*G*0.595
    force = case.numbers(r"Load on grid: force \(N")[:len(t)]
    return t, U, rho, drop, force, case.series("place", "bed.dat")


def smooth(t, y, width):
    """Mean over a time."""
    sums = np.concatenate([[0], np.cumsum(0.5*(y[1:] + y[:-1])*np.diff(t))])
    low, high = (np.clip(t + w, t[0], t[-1]) for w in (-width/2, width/2))
    return (np.interp(high, t, sums) - np.interp(low, t, sums))/(high - low)


def figures():
    t, U, rho, drop, force, _ = results()
    plateau = SHARE*(RHO_S - rho)*G*H
    Umf = minimum(np.interp(0.2, t, rho))
    fixed = (t > 0.1) & (U < 0.97*Umf)
    carried = (t > 0.1) & (U >= Umf)
    free = (t > 0.1) & (smooth(t, force, 0.02) >= 0)
    return {"Umf": Umf, "fixed": np.mean(drop[fixed]/ergun(U, rho)[fixed]),
            "carried": np.mean(drop[carried]/plateau[carried]),
            "reached": U[np.argmax((drop >= plateau) & (t > 0.05))],
            "lifted": U[np.argmax(free)]}


if __name__ == "__main__":
    t, U, rho, drop, force, bed = results()
    plateau = SHARE*(RHO_S - rho)*G*H
    r = figures()
    Umf = r["Umf"]
    print(f"fixed bed: pressure drop over Ergun {r['fixed']:.4f}")
    swing = drop[(t > 0.1) & (U >= Umf)]/plateau[0]
    print(f"fluidised: pressure drop over the weight {r['carried']:.4f} in the mean,"
          f" {swing.min():.3f} to {swing.max():.3f} while the bed rises and stops")
    print(f"minimum fluidisation velocity {Umf:.4f} m/s; the pressure drop reaches the weight at"
          f" {r['reached']:.4f} m/s ({100*(r['reached']/Umf - 1):+.2f} %)")
    print(f"  nothing lies on the grid from {r['lifted']:.4f} m/s"
          f" ({100*(r['lifted']/Umf - 1):+.2f} %; mean of 20 ms)")

    # While the stream grows; the bed also later
    weight = -SHARE*RHO_S*H*AREA*G
    grows = (t > 0.1) & (t < 0.3)
    ratio = (U/Umf)[grows]
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.8))
    axes[0].plot(ratio, (drop/plateau)[grows], lw=2, label="pressure drop")
    axes[0].plot(ratio, smooth(t, force, 0.02)[grows]/weight, lw=2,
                 label="force on the grid (mean of 20 ms)")
    axes[0].plot(ratio, (ergun(U, rho)/plateau)[grows], "k--", lw=1,
                 label="Ergun, bed that does not move")
    axes[0].axhline(1, color="k", ls=":", lw=1, label="weight of the bed")
    axes[0].axvline(1, color="0.5", lw=0.8)
    axes[0].set(ylim=(-0.1, 1.3), ylabel="over the weight of the bed",
                xlabel="superficial velocity / that of minimum fluidisation")
    axes[0].legend(loc="center right")
    axes[1].plot(bed[:, 0], 1e3*(bed[:, 7] - bed[0, 7]), lw=2)
    start = t[np.argmax(U >= Umf)]
    axes[1].axvline(start, color="0.5", lw=0.8)
    axes[1].text(start, 9, " minimum\n fluidisation", fontsize=8)
    axes[1].axvline(0.3, color="0.5", lw=0.8, ls=":")
    axes[1].text(0.3, 1, " stream grows\n no further", fontsize=8)
    axes[1].set(xlabel="time [s]", ylabel="rise of the bed's centre [mm]")
    save(figure, "fluidised.png")
