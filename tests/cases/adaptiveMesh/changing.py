"""Meshes that change, for the parts of this test."""

import os
import random
import re

from gasCases import labels

DICT = "system/adaptiveMeshDict"


def box(low, high, level=None, times=None):
    """A criterion: cells in a box, for a time."""
    return {"type": "shape", **({"level": level} if level else {}),
            **({"from": times[0], "to": times[1]} if times else {}),
            "shape": {"type": "box", "min": tuple(low), "max": tuple(high)}}


def adaptive(case, maxLevel, refine, **entries):
    case.write(DICT, {"maxLevel": maxLevel, **entries, "refine": refine})
    return case


def comeAndGo(case, end, nDim, n=100, maxLevel=2, seed=1):
    """Boxes in the unit cube, each for a short time, all levels; a look in each step."""
    rng = random.Random(seed)
    refine = {}
    for i in range(n):
        low = [rng.uniform(0, 0.8) if d < nDim else -1 for d in range(3)]
        size = [rng.uniform(0.05, 0.3) if d < nDim else 3 for d in range(3)]
        refine[f"box{i}"] = box(low, [a + b for a, b in zip(low, size)],
                                rng.randint(1, maxLevel),
                                (end*i/n, end*(i + rng.uniform(1, 4))/n))
    return adaptive(case, maxLevel, refine, buffer=0, keep=0, interval=1)


def changes(case):
    return int(re.search(r"Adaptive mesh: (\d+) changes", case.log())[1])


def cellLevel(case, time):
    """Of the time, or of the last one before it with a mesh."""
    at = [t for t in ("constant", *case.times()) if t == "constant" or float(t) <= float(time)]
    files = [case.file(t, "polyMesh/cellLevel") for t in at]
    return labels([f for f in files if os.path.exists(f)][-1])
