"""Place and speed of the plug along the middle of the pipe."""

import numpy as np

R1, R2 = 0.2933, 0.3433
R = 0.5*(R1 + R2)

#: A sector that turns moves as a straight plug of RHO*INERTIA: int r^2 dA/(R^2 A)
INERTIA = (R1*R1 + R2*R2)/(2*R*R)


def along(cloud, bent=True):
    """Length [m] from the breech and speed [m/s] of the plug's points, mean by mass."""
    x, u, m = cloud["x"], cloud["U"], cloud["m"]/cloud["m"].sum()
    if not bent:
        return m @ x[:, 0], m @ u[:, 0]
    angle = np.arctan2(x[:, 1], x[:, 0])
    turn = (x[:, 0]*u[:, 1] - x[:, 1]*u[:, 0])/(x[:, 0]**2 + x[:, 1]**2)
    return R*(m @ angle), R*(m @ turn)


def motion(case, bent=True):
    """Columns t, length, speed of the times that were written."""
    times = case.times("lagrangian")
    return np.array([(float(t), *along(case.points(t, "plug"), bent)) for t in times])


def figures(bend, straight):
    """Speed at 5 ms, largest speed, turning point: of the bend, of the straight pipe;
    largest distance of both before the turning point, over the way."""
    def three(rows):
        top = rows[:, 1].argmax()
        near = np.polyfit(rows[top - 1:top + 2, 0] - rows[top, 0], rows[top - 1:top + 2, 1], 2)
        return np.interp(5e-3, rows[:, 0], rows[:, 2]), rows[:, 2].max(), \
            near[2] - near[1]**2/(4*near[0])

    until = straight[:, 1].argmax() + 1
    way = straight[:until, 1].max() - straight[0, 1]
    # The bend's at the times of the straight one: Allrun -animate writes it more often
    length = np.interp(straight[:until, 0], bend[:, 0], bend[:, 1])
    apart = np.abs(length - straight[:until, 1]).max()/way
    return three(bend), three(straight), apart
