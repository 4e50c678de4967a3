"""Points at the start and at the end; how far the free flight is from exact."""

import numpy as np

from mpm.case import Case
from mpm.pictures import VALUES, drawPoints, frame, plt, save, to_hex

H = 0.01

#: case: velocity, cells in a direction
CASES = {"disk": ((18.0, 11.5, 0.0), 32), "ball": ((12.0, 9.5, -7.3), 24)}


def cloud(case, time):
    """Places and velocities in the order of the points' ids."""
    points = Case(case).points(time, case)
    return points.byId("x"), points.byId("U")


figure, axes = plt.subplots(1, 2, figsize=(10, 5))
for ax, (case, (velocity, n)) in zip(axes, CASES.items()):
    velocity = np.array(velocity)
    times = Case(case).times("lagrangian")
    frame(ax, (0, n), (0, n), "x [cm]", "y [cm]", f"{case}; black: x + t v")
    for name, shade in zip(times, np.linspace(0.1, 0.9, len(times))):
        x, u = cloud(case, name)
        drawPoints(ax, Case(case).points(name, case), to_hex(VALUES(shade)), scale=100)
        ax.plot([], [], "s", color=VALUES(shade), label=f"{float(name)*1e3:g} ms")
    first = cloud(case, times[0])[0]
    travel = float(times[-1])*velocity
    for i in range(0, len(first), max(1, len(first)//12)):
        ax.plot(100*(first[i, 0] + np.array([0, travel[0]])),
                100*(first[i, 1] + np.array([0, travel[1]])), "k-", lw=0.5, zorder=5)
    ax.set_xticks(range(n + 1), minor=True)
    ax.set_yticks(range(n + 1), minor=True)
    ax.grid(True, which="both", lw=0.25)
    ax.set_axisbelow(False)
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
save(figure, "translation.png")
