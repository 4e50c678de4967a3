"""Depth of the rod after 12 us, strain and cost of a run."""

import numpy as np

#: Depth [mm] on even cells of 0.125 mm (MPM_FINE=1)
FINEST = 1.8631


def depth(case):
    """How far the rod's centre of mass has come below its start [mm]."""
    rod = case.points(case.times("lagrangian")[-1], "rod")
    return 3 - 1e3*(rod["m"] @ rod["x"][:, 1])/rod["m"].sum()


def strain(case):
    """Mean plastic strain of the target, by mass."""
    target = case.points(case.times("lagrangian")[-1], "target")
    return np.average(target["plasticStrain"], weights=target["m"])
