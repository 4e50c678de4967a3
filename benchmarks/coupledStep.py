"""Cost of a step of points in a gas: a block that fills a part of a periodic square
or cube of air and moves with it; GIMP, FLIP, MUSL, first-order gas, sticking drag.

    coupledStep.py

prints for each scene ns per (cell + point) and step, and the time of the coupling
and the gas over that of the points' part; and the same of a block at 300 m/s in 300
times its volume of air at rest, with activeRegion and without it. Run it on an idle machine (etc/prepare
sourced). Best of three. Uintah MPM-ICE needs 960 (linear, first order) to 1905 ns.
"""

import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../tests/lib"))
from blockInGas import blockInGas  # noqa: E402

#: Name, dimensions, cells in each direction, share of the side, steps
SCENES = (("2D, block in a quarter", 2, 128, 0.5, 300),
          ("2D, block nearly everywhere", 2, 128, 0.9, 300),
          ("3D, block in an eighth", 3, 32, 0.5, 100),
          ("3D, block in a 64th", 3, 48, 0.25, 100))


#: The same in air at rest, with the gas' entries
STILL = tuple((f"3D, block in still air{name}", 3, 80, 0.15, 100, gas)
              for name, gas in (("", {}), (", activeRegion", {"activeRegion": "yes"})))


def once(case):
    case.run("materialPointFoam", limit=600)
    log = case.log()
    parts = dict((n, float(v)) for n, v in re.findall(
        r"([a-z]+(?: and force)?) ([\d.]+) %", re.search(r"^Parts of.*", log, re.M)[0]))
    seconds = float(re.search(r"^Parts of the steps' (\S+) s", log, re.M)[1])
    other = (parts.get("coupling", 0) + parts.get("gas", 0))/100
    return seconds, other


def main():
    print(f"{'scene':30} {'cells':>8} {'points':>8} {'ns/(cell + point)':>18}"
          f" {'gas and coupling over points':>30}")
    for name, nDim, n, side, steps, gas in [(*s, None) for s in SCENES] + list(STILL):
        h = 1e-4
        low, high = 0.5*(1 - side)*n*h, 0.5*(1 + side)*n*h
        case = blockInGas(
            "coupledStep", name.replace(" ", "-").replace(",", ""), nDim, n,
            {"type": "box", "min": (low, low, low if nDim > 2 else -1),
             "max": (high, high, high if nDim > 2 else 1)},
            (40, 30, 0) if gas is None else (300, 0, 0), steps, h=h, reports=2,
            gas=gas, gasVelocity=None if gas is None else (0, 0, 0), walls=gas is not None)
        points = len(case.points("0", "block")["x"])
        best = min(once(case) for _ in range(3))
        cells = n**nDim
        print(f"{name:30} {cells:8d} {points:8d} {best[0]*1e9/steps/(cells + points):18.0f}"
              f" {best[1]/(1 - best[1]):30.2f}")


if __name__ == "__main__":
    main()
