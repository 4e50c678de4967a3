"""Figures of README.md's table, and pictures: profiles beside the curves of Houim and
Oran (2016)."""

import numpy as np

from mpm.case import Case
from mpm.pictures import plt, save

ATM = 101298.0
RHO_DILUTE = 1.293                 # density of the gas on the right [kg/m3]


def curve(name):
    return np.loadtxt(f"data/{name}.csv", delimiter=",").T


def front(x, values, level):
    """Last place where values fall through a level."""
    i = np.max(np.nonzero(values > level)[0])
    return x[i] + (x[i + 1] - x[i])*(values[i] - level)/(values[i] - values[i + 1])


def mean(x, values, low, high):
    return values[(x > low) & (x < high)].mean()


def panel(ax, title, published, x, values, label="this case", color="C0"):
    ax.plot(x, values, color=color, label=label)
    ax.plot(*published, "k.", ms=4, label="Houim & Oran")
    ax.set_title(title, fontsize=10)
    ax.grid(alpha=0.3)


def row(what, published, own):
    print(f"{what}: published {published:.5g}, this case {own:.5g}"
          f" ({100*(own/published - 1):+.1f} %)")


# Dilute
n, L = 400, 0.258
case, time = Case("dilute"), "0.0001842"
x = (np.arange(n) + 0.5)*L/n
p = case.field(time, "p")/ATM
gas = case.field(time, "theta.air")*case.field(time, "rho.air")/RHO_DILUTE
dust = (1 - case.field(time, "theta.air"))*2500/RHO_DILUTE
pP, rhoP = curve("dilute_p"), curve("dilute_rho")

# The expansion fan is in gas alone: u - c = (x - x0)/t, u + 5 c = 5 c0
fan = (pP[1] > 4) & (pP[1] < 9) & (pP[0] < 0.115)
ratio = (pP[1][fan]/pP[1][pP[1] > 9.9].mean())**(1/7)
ct = np.median((0.129 - pP[0][fan])/(ratio - 5*(1 - ratio)))
l = 4/3*1e-5*2500/RHO_DILUTE
print(f"dilute, time of the published fan {ct/(np.sqrt(1.4)*l):.3f} l/u,"
      f" l {l:.6f} m, l/u {l/np.sqrt(ATM/RHO_DILUTE)*1e6:.2f} us")
at = pP[0] > 0.2
row("dilute, place of the shock [m]", front(pP[0][at], pP[1][at], 1.66),
    front(x, p, 1.66))
row("dilute, pressure at 0.14 to 0.17 m [atm]", mean(*pP, 0.14, 0.17),
    mean(x, p, 0.14, 0.17))
gasP = rhoP[:, rhoP[1] > 2]
gasP = gasP[:, np.argsort(gasP[0])]
at = gasP[0] > 0.15
row("dilute, place of the contact [m]", front(gasP[0][at], gasP[1][at], 3.5),
    front(x, gas, 3.5))
row("dilute, density of the gas at 0.135 to 0.155 m", mean(*gasP, 0.135, 0.155),
    mean(x, gas, 0.135, 0.155))

figure, axes = plt.subplots(1, 2, figsize=(10, 3.8))
panel(axes[0], "pressure [atm]", pP, x, p)
panel(axes[1], "density over that of the gas on the right", rhoP, x, gas, "gas")
axes[1].plot(x, dust, "C3", label="dust, mass per volume")
for ax in axes:
    ax.set_xlabel("x [m]")
    ax.legend()
figure.suptitle("Few grains of 10 um, 10 atm on 1 atm, 184 us")
save(figure, "dilute.png")

# Dense
n, L = 576, 0.12
case, time = Case("dense"), "0.0001"
x = (np.arange(n) + 0.5)*L/n
theta = case.field(time, "theta.air")
p = case.field(time, "p")/ATM
gas = theta*case.field(time, "rho.air")
dust = (1 - theta)*1470
there = case.field(time, "alpha.dust") > 0
uG, uS = case.field(time, "U.air")[:, 0], case.field(time, "Umean.dust")[:, 0]
TG, TS = case.field(time, "T.air"), case.field(time, "Tmean.dust")
published = {q: curve("dense_" + q) for q in ("p_g", "rho_g", "rho_p", "U_g", "U_p", "T_g", "T_p")}
u = published["U_p"]
at = (u[1] > 8) & (u[1] < 40)
row("dense, place of the compaction front [m]", np.median(u[0][at]), front(x, uS, 24))
row("dense, place of the bed's edge [m]",
    np.median(published["rho_p"][0][published["rho_p"][0] < 0.0373]), x[np.argmax(dust > 400)])
for what, q, values, low, high in (
        ("density of the grains [kg/m3]", "rho_p", dust, 0.039, 0.045),
        ("velocity of the grains [m/s]", "U_p", uS, 0.039, 0.045),
        ("velocity of the gas before the bed [m/s]", "U_g", uG, 0.015, 0.034),
        ("pressure of the gas before the bed [atm]", "p_g", p, 0.015, 0.034),
        ("pressure of the gas in the bed [atm]", "p_g", p, 0.043, 0.0465),
        ("temperature of the gas before the bed [K]", "T_g", TG, 0.015, 0.034),
        ("temperature of the gas in the bed [K]", "T_g", TG, 0.043, 0.047),
        ("temperature of the grains [K]", "T_p", TS, 0.039, 0.045)):
    row("dense, " + what, mean(*published[q], low, high), mean(x, values, low, high))
half = (published["p_g"][1] > 33) & (published["p_g"][1] < 41)
row("dense, half of the pressure at [m]", np.median(published["p_g"][0][half]),
    front(x, p, 37))

figure, axes = plt.subplots(2, 2, figsize=(10, 7))
panel(axes[0, 0], "pressure of the gas [atm]", published["p_g"], x, p)
panel(axes[0, 1], "mass per volume [kg/m3]", published["rho_p"], x, dust, "grains", "C3")
panel(axes[0, 1], "mass per volume [kg/m3]", published["rho_g"], x, gas, "gas")
panel(axes[1, 0], "velocity [m/s]", published["U_p"], x[there], uS[there], "grains", "C3")
panel(axes[1, 0], "velocity [m/s]", published["U_g"], x, uG, "gas")
panel(axes[1, 1], "temperature [K]", published["T_p"], x[there], TS[there], "grains", "C3")
panel(axes[1, 1], "temperature [K]", published["T_g"], x, TG, "gas")
for ax in axes.flat:
    ax.set_xlim(0, 0.06)
    ax.set_xlabel("x [m]")
    handles, labels = ax.get_legend_handles_labels()
    unique = dict(zip(labels, handles))
    ax.legend(unique.values(), unique.keys(), fontsize=8)
axes[1, 0].set_ylim(-5, 110)
axes[1, 1].set_ylim(265, 325)
figure.suptitle("Bed of 0.4 by volume, grains of 5 um, 100 atm on 1 atm, 100 us")
save(figure, "dense.png")
