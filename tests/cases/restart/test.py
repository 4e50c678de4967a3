#!/usr/bin/env python3
"""A run that stops and goes on gives the result of the straight run.

The spall strip with failure and Weibull scatter, GIMP, FLIP, FMPM and APIC
with USAVG, points crossing cells: from every written time on, binary bit by bit, ascii (17 digits,
writePrecision 6) to 1e-13 of each field's maximum. A run that is killed while it
writes goes on from the last complete time, says so, and ends at the same result.
"""

import os
import random
import shutil
import signal
import subprocess
import sys
import time

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from foamCase import VERIFY, RunFailed
from plates import plateCase
from report import Report

END, INTERVAL = 1.5e-6, 0.25e-6
COLUMNS = ("x", "U", "m", "V", "sigma", "id", "leftStretch", "damage", "halfSize")
SCHEMES = {
    "FLIP": {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01},
    "FMPM2": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2},
    "APIC-USAVG": {"shapeFunction": "GIMP", "transfer": "APIC", "stressUpdate": "USAVG"}}


def case(name, scheme, writeFormat):
    c = plateCase("restart", name, 19, SCHEMES[scheme], END, INTERVAL, 0.5,
                  strength=400e6, writeFormat=writeFormat)
    c.change("constant/phaseProperties", "strength.*?;",
             "strength 400e6; weibull { modulus 10; seed 3; }")
    c.change("system/controlDict", "startFrom.*?;", "startFrom latestTime;")
    c.change("system/controlDict", "writePrecision.*?;", "writePrecision 6;")
    c.change("system/controlDict", "timePrecision.*?;", "timePrecision 6;")
    return c


def difference(a, b, timeName):
    """Largest difference of any column over the maximum of the column."""
    worst = 0.0
    for phase in ("target", "flyer"):
        for column in COLUMNS + (("C",) if "C" in a.points(timeName, phase) else ()):
            u = a.points(timeName, phase)[column]
            v = b.points(timeName, phase)[column]
            if u.shape != v.shape:
                return np.inf
            size = np.max(np.abs(u)) or 1.0
            worst = max(worst, float(np.max(np.abs(u - v)))/size)
    return worst


def restarts(table, scheme, writeFormat):
    straight = case(f"{scheme}-{writeFormat}", scheme, writeFormat)
    straight.run("materialPointFoam")
    times = [t for t in straight.times() if t != "0"]
    end = times[-1]
    worst = 0.0
    for t in times[:-1]:
        again = case(f"{scheme}-{writeFormat}-from{t}", scheme, writeFormat)
        shutil.copytree(straight.file(t), again.file(t))
        again.run("materialPointFoam")
        worst = max(worst, difference(straight, again, end))
    limit = 0 if writeFormat == "binary" else 1e-13
    table.row(f"{scheme}, {writeFormat}: restart from {len(times) - 1} times, "
              "largest difference at the end", 0, worst, limit, "atMost")
    failed = straight.points(end, "target")["damage"].sum()
    table.check(f"{scheme}, {writeFormat}: points have failed", failed > 0, failed)


def killed(table, tries):
    c = case("killed", "FLIP", "binary")
    # Writes at every third step: many kills hit a write
    c.change("system/controlDict", "writeInterval.*?;", "writeInterval 2e-8;")
    straight = case("straight-often", "FLIP", "binary")
    straight.change("system/controlDict", "writeInterval.*?;", "writeInterval 2e-8;")
    straight.run("materialPointFoam")
    end = straight.times()[-1]

    rng = random.Random(5)
    fellBack = 0
    with open(c.file("log.killed"), "w") as log:
        # On a slow machine until some times are there
        kills, wait = 0, 0.1
        while kills < tries or (len(c.times()) < 4 and kills < tries + 20):
            p = subprocess.Popen(["materialPointFoam"], cwd=c.path, stdout=log,
                                 stderr=log, env={**os.environ, "PWD": c.path})
            time.sleep(wait + 0.1*rng.random())
            p.send_signal(signal.SIGKILL)
            p.wait()
            kills += 1
            wait *= 1.0 if kills < tries else 1.3
    # One more: the last written time loses its mark and half of a column
    last = c.times()[-1]
    if last != "0":
        mark = c.file(last, "uniform", "materialPointState")
        if os.path.exists(mark):
            os.remove(mark)
        column = c.file(last, "lagrangian", "target", "sigma")
        if os.path.exists(column):
            with open(column, "r+b") as f:
                f.truncate(os.path.getsize(column)//2)
    c.run("materialPointFoam")
    fellBack = open(c.file("log.killed")).read().count("was not written to its end")
    table.check("a broken last time: the run goes back and says so",
                "was not written to its end" in c.log(), f"{fellBack} times before")
    table.row(f"kill -9 {tries} times or more: largest difference to the straight run at the end",
              0, difference(straight, c, end), 0, "atMost")


def main():
    table = Report("restart")
    for scheme in SCHEMES:
        for writeFormat in ("binary", "ascii"):
            try:
                restarts(table, scheme, writeFormat)
            except RunFailed as e:
                table.check(f"{scheme}, {writeFormat} runs", False, e)
    try:
        killed(table, 20)
    except RunFailed as e:
        table.check("killed run goes on", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
