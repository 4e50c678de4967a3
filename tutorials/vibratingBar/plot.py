"""Velocity of the mass centre, energies and profiles of the bar against the
exact solution for small strains,

    v(x, t) = v0 sin(beta x) cos(omega t),   u = v0/omega sin(beta x) sin(omega t)

with beta = pi/(2 L), omega = beta sqrt(E/rho): period 4 L/c = 10 s.
"""

import numpy as np

from mpm.case import Case
from mpm.pictures import plt, save

L, E, RHO, V0 = 25.0, 100.0, 1.0, 0.1
C = np.sqrt(E/RHO)
BETA = np.pi/(2*L)
OMEGA = BETA*C
PERIOD = 2*np.pi/OMEGA
MEAN = V0/(BETA*L)
ENERGY = RHO*L*V0**2/4


# time, points, mass, momentum 3, angular momentum 3, kinetic, strain, total
case = Case()
balance = case.series("balance", "bar.dat", once=True)
t, mass = balance[:, 0], balance[:, 2]
velocity = balance[:, 3]/mass
kinetic, strain, total = balance[:, 9:12].T

# The period from all zero crossings, linear between steps
i = np.nonzero(velocity[:-1]*velocity[1:] < 0)[0]
zero = t[i] - velocity[i]*(t[i + 1] - t[i])/(velocity[i + 1] - velocity[i])
period = 2*(zero[-1] - zero[0])/(len(zero) - 1)
exact = MEAN*np.cos(OMEGA*t)


figure, axes = plt.subplots(3, 1, figsize=(8, 9.5))
axes[0].plot(t, exact, "k-", lw=2.5, alpha=0.35, label="exact")
axes[0].plot(t, velocity, "C0-", lw=1, label="materialPointFoam")
axes[0].set_ylabel("velocity of the mass centre [m/s]")
axes[0].legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncol=5)
axes[1].plot(t, kinetic, "C0-", lw=1, label="kinetic")
axes[1].plot(t, strain, "C1-", lw=1, label="strain")
axes[1].plot(t, total, "C2-", label="total")
axes[1].axhline(ENERGY, color="k", ls=":", lw=1, label="exact total")
axes[1].set_ylabel("energy [J]")
axes[1].legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncol=5)
for ax in axes[:2]:
    ax.set_xlabel("time [s]")

last = 0
for colour, want in enumerate((0.0, 40.0, 42.5, 45.0, 47.5)):
    name = case.nearest(want, "lagrangian")
    x, v = (case.points(name, "bar")[column][:, 0] for column in ("x", "U"))
    order = np.argsort(x)
    reference = V0*np.sin(BETA*x)*np.cos(OMEGA*float(name))
    if float(name):
        last = max(last, np.sqrt(np.mean((v - reference)**2))/V0)
    axes[2].plot(x[order], v[order], f"C{colour}.", ms=3, label=f"{name} s")
    axes[2].plot(x[order], reference[order], "k-", lw=0.7)
axes[2].set_xlabel("place [m]; lines: exact")
axes[2].set_ylabel("velocity of the points [m/s]")
axes[2].legend(loc="upper left")
save(figure, "vibratingBar.png")

drift = np.max(abs(total/total[0] - 1))
print(f"period                      {period:9.5f} s, exact {PERIOD:.5f} s, "
      f"{100*(period/PERIOD - 1):+.3f} %")
print(f"velocity of mass centre     {velocity[0]:9.7f} m/s at the start, exact "
      f"{MEAN:.7f} m/s, {100*(velocity[0]/exact[0] - 1):+.3f} %")
print(f"   after {t[-1]/PERIOD:.0f} periods          {velocity[-1]:9.7f} m/s, exact "
      f"{exact[-1]:.7f} m/s, {100*(velocity[-1]/MEAN - exact[-1]/MEAN):+.3f} %")
print(f"total energy at the start   {total[0]:9.7f} J, exact {ENERGY:.7f} J, "
      f"{100*(total[0]/ENERGY - 1):+.3f} %")
print(f"   after {t[-1]/PERIOD:.0f} periods          {total[-1]:9.7f} J, "
      f"{100*(total[-1]/ENERGY - 1):+.3f} %; largest change from the start {100*drift:.3f} %")
print(f"velocity profiles, t >= 40 s: largest rms error {100*last:.2f} % of v0")
