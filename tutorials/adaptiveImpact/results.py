"""Depth and velocity of the rod, strain of the target."""

import numpy as np


def rod(case, time):
    """How far its centre of mass has come below its start [mm], its velocity down [m/s]."""
    p = case.points(time, "rod")
    mean = [p["m"] @ p[name][:, 1]/p["m"].sum() for name in ("x", "U")]
    return 3 - 1e3*mean[0], -mean[1]


def strain(case, time):
    """Mean plastic strain of the target, by mass."""
    target = case.points(time, "target")
    return np.average(target["plasticStrain"], weights=target["m"])
