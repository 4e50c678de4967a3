"""Figures of README.md's table, and the picture: pressure beside the exact shock tubes
of the frozen flow and of the flow in equilibrium, speed of the shock over time."""

import numpy as np

from mpm.case import Case
from mpm.pictures import plt, save

L, N, X0, P_LEFT, P_RIGHT, RHO_RIGHT = 3.4, 1700, 1.53, 10.13e5, 1.013e5, 1.23
GAS = 1.4

#: gamma and density of what the shock runs into
FROZEN, EQUILIBRIUM = (1.4, RHO_RIGHT), (1.2, 2*RHO_RIGHT)


def starState(gamma, rho):
    """p, u between the waves, speed of the shock: gas of gamma 1.4 on the left."""
    c = np.sqrt(GAS*P_LEFT/(10*RHO_RIGHT))

    def velocities(p):
        left = 2*c/(GAS - 1)*(1 - (p/P_LEFT)**((GAS - 1)/(2*GAS)))
        right = (p - P_RIGHT)/np.sqrt(rho/2*((gamma + 1)*p + (gamma - 1)*P_RIGHT))
        return left, right
    low, high = P_RIGHT, P_LEFT
    for _ in range(200):
        p = 0.5*(low + high)
        left, right = velocities(p)
        low, high = (p, high) if right < left else (low, p)
    speed = np.sqrt(((gamma + 1)*p + (gamma - 1)*P_RIGHT)/(2*rho))
    return p, right, speed


def exactPressure(x, t, star):
    """Fan on the left, two constant states, shock."""
    p, u, speed = star
    c = np.sqrt(GAS*P_LEFT/(10*RHO_RIGHT))
    xi = (x - X0)/t
    cFan = np.clip(2/(GAS + 1) - (GAS - 1)/(GAS + 1)*xi/c, 0, 1)
    fan = np.maximum(P_LEFT*cFan**(2*GAS/(GAS - 1)), p)
    return np.where(xi < speed, fan, P_RIGHT)


frozen, equilibrium = starState(*FROZEN), starState(*EQUILIBRIUM)
for name, star in (("frozen", frozen), ("equilibrium", equilibrium)):
    print(f"exact, {name}: p {star[0]:.0f} Pa, u {star[1]:.2f} m/s, shock {star[2]:.2f} m/s")

x = (np.arange(N) + 0.5)*L/N
case = Case()
times = case.times()[1:]
pressure = {t: case.field(t, "p") for t in times}


def shock(p):
    """Where the pressure rises halfway to its value behind the frozen shock, the least
    that can be in front of the relaxation zone."""
    level = 0.5*(P_RIGHT + frozen[0])
    i = np.max(np.nonzero(p > level)[0])
    return x[i] + (x[i + 1] - x[i])*(p[i] - level)/(p[i] - p[i + 1])


t = np.array([float(name) for name in times])
place = np.array([shock(pressure[name]) for name in times])
between, speed = 0.5*(t[1:] + t[:-1]), np.diff(place)/np.diff(t)
late = t > 0.75*t[-1]
lateSpeed = np.polyfit(t[late], place[late], 1)[0]
firstSpeed = (place[0] - X0)/t[0]
print(f"speed of the shock, first {t[0]*1e6:.0f} us: {firstSpeed:.2f} m/s"
      f" ({100*(firstSpeed/frozen[2] - 1):+.2f} % of frozen); last quarter: {lateSpeed:.2f} m/s"
      f" ({100*(lateSpeed/equilibrium[2] - 1):+.2f} % of equilibrium)")
p, u = pressure[times[-1]], case.field(times[-1], "U.air")[:, 0]
at = (x > X0 + 1.15*equilibrium[1]*t[-1]) & (x < place[-1] - 0.25)
for name, values, exact in (("pressure [Pa]", p, equilibrium[0]),
                            ("velocity [m/s]", u, equilibrium[1])):
    print(f"late {name} behind the shock: {values[at].mean():.6g}, exact {exact:.6g}"
          f" ({100*(values[at].mean()/exact - 1):+.2f} %)")

figure, axes = plt.subplots(1, 3, figsize=(14, 4))
early = times[np.argmin(abs(t - 3.8e-4))]
for ax, name in zip(axes, (early, times[-1])):
    ax.plot(x, pressure[name]*1e-5, "C0", label="this case")
    ax.plot(x, exactPressure(x, float(name), frozen)*1e-5, "k:", label="exact, frozen")
    ax.plot(x, exactPressure(x, float(name), equilibrium)*1e-5, "k--",
            label="exact, equilibrium")
    ax.set_title(f"pressure [bar], {float(name)*1e3:.2f} ms")
    ax.set_xlabel("x [m]")
    ax.legend()
axes[0].set_xlim(1.3, 1.9)
axes[2].plot(between*1e3, speed, "C0", label="this case")
axes[2].axhline(frozen[2], color="k", ls=":", label="exact, frozen")
axes[2].axhline(equilibrium[2], color="k", ls="--", label="exact, equilibrium")
axes[2].set_title("speed of the shock [m/s]")
axes[2].set_xlabel("time [ms]")
axes[2].legend()
for ax in axes:
    ax.grid(alpha=0.3)
save(figure, "dustyShockTube.png")
