"""Points at the start and at the end; how far the free flight is from exact."""

import numpy as np

from mpm.case import Case
from mpm.pictures import plt

H = 0.01

#: case: velocity, cells in a direction
CASES = {"disk": ((18.0, 11.5, 0.0), 32), "ball": ((12.0, 9.5, -7.3), 24)}


def cloud(case, time):
    """Places and velocities in the order of the points' ids."""
    points = Case(case).points(time, case)
    return points.byId("x"), points.byId("U")


figure, axes = plt.subplots(1, 2, figsize=(12, 5.6))
for ax, (case, (velocity, n)) in zip(axes, CASES.items()):
    velocity = np.array(velocity)
    times = Case(case).times("lagrangian")
    for name in times:
        x, u = cloud(case, name)
        ax.scatter(x[:, 0]*100, x[:, 1]*100, s=2, linewidths=0,
                   label=f"t = {float(name)*1e3:g} ms")
    first = cloud(case, times[0])[0]
    travel = float(times[-1])*velocity
    for i in range(0, len(first), max(1, len(first)//12)):
        ax.plot(100*(first[i, 0] + np.array([0, travel[0]])),
                100*(first[i, 1] + np.array([0, travel[1]])), "k-", lw=0.5)
    ax.set_xticks(range(n + 1), minor=True)
    ax.set_yticks(range(n + 1), minor=True)
    ax.grid(True, which="both", lw=0.25)
    ax.set_xlim(0, n)
    ax.set_ylim(0, n)
    ax.set_aspect("equal")
    ax.set_title(f"{case}; black: x + t v", fontsize=9)
    ax.set_xlabel("x [cm]")
    ax.set_ylabel("y [cm]")
    ax.legend(loc="lower right")

    rows = Case(case).series("balance", f"{case}.dat", once=True)
    mass, momentum = rows[:, 2], rows[:, 3:6]
    kinetic, strain, total = rows[:, 9:12].T
    speed = np.linalg.norm(velocity)
    energy = mass[0]*speed**2/2
    print(f"{case}: {len(x)} points of {len(first)}, {len(rows)} steps, "
          f"{'  '.join(f'{abs(c)/H:.1f}' for c in travel if c)} cells crossed along the axes")
    for label, value in (
            ("strain energy/kinetic energy", np.max(strain)/energy),
            ("velocity of any point, |u - v|/|v|", np.max(abs(u - velocity))/speed),
            ("place of any point, |x - x0 - t v|/cell",
             np.max(abs(x - first - travel))/H),
            ("momentum", np.max(abs(momentum - mass[0]*velocity))/(mass[0]*speed)),
            ("total energy", np.max(abs(total/energy - 1))),
            ("mass", np.max(abs(mass/mass[0] - 1)))):
        print(f"    {label:42s} largest deviation {value:.1e}")
figure.savefig("translation.png")
