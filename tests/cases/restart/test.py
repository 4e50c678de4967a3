#!/usr/bin/env python3
"""A run that stops and goes on gives the result of the straight run.

The spall strip with failure and Weibull scatter, GIMP, FLIP, FMPM and APIC
with USAVG, points crossing cells: from every written time on, binary bit by bit, ascii (17 digits,
writePrecision 6) to 1e-13 of each field's maximum. A run that is killed while it
writes goes on from the last complete time, says so, and ends at the same result.
The same of a detonating charge in water and air beside points, on 1 and 2 processors;
a file of its last time that is cut off or gone is named.
Times of function objects are met, and a restarted run makes the same steps to them.
The end of a run is written, SIGTERM and SIGINT write and end, limits of the time step
and the energy end with the state written, fvSolution may be edited meanwhile.
"""

import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from detonations import TNT
from fluidCases import WATER, besidePoints, fluidCase
from foamCase import VERIFY, FoamCase, RunFailed
from gasCases import WALL
from killedRuns import kills, sameBits, times
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


def functionTimes(table):
    """A function object with writeControl adjustableRunTime: its times are met, and a restarted
    run makes the same steps to them."""
    for label, interval in (("7 in an interval of writing", INTERVAL/7),
                            ("that do not divide it", 0.137*INTERVAL)):
        def make(name, interval=interval):
            c = case(name, "FLIP", "binary")
            c.set("system/controlDict", "functions.probes", {
                "type": "materialPointProbes", "libs": "(mpmFunctionObjects)",
                "phase": "target", "fields": "(U)", "points": {"ids": "(1)"},
                "writeControl": "adjustableRunTime", "writeInterval": interval}, add=True)
            return c
        straight = make("functionTimes")
        straight.run("materialPointFoam")
        rows = straight.table("probes/U.dat")["Time"]/interval
        table.row(f"function object, times {label}: rows", int(END/interval*(1 + 1e-9)),
                  len(rows[rows > 0.5]), 0)
        table.row(f"function object, times {label}: intervals beside a whole number of them", 0,
                  float(np.max(np.abs(rows - np.round(rows)))), 1e-8)
        again = make("functionTimesAgain")
        shutil.copytree(straight.file(straight.times()[2]), again.file(straight.times()[2]))
        again.run("materialPointFoam")
        table.row(f"function object, times {label}: restart, largest difference at the end", 0,
                  difference(straight, again, straight.times()[-1]), 0)


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


def begun(table):
    """A run that was killed when its first time was a folder and little more."""
    for label, make in (("points", lambda: case("begun", "FLIP", "binary")),
                        ("fluids alone", lambda: fluidCase(
                            "restart", "begunFluids", (8, 1, 1), (1, 0.1, 0.1), {"water": WATER},
                            lambda x, y, z: ([1.0], [1000.0], 0.0, 1e5), 1e-5, ends=WALL,
                            control={"startFrom": "latestTime"}))):
        c = make()
        for folder in ("1e-09", "2e-09/uniform/lagrangian/target"):
            os.makedirs(c.file(folder))
        c.run("materialPointFoam")
        table.check(f"{label}: last times without a field, the run starts before them",
                    c.log().count("was not written to its end") == 2
                    and "run starts from 0" in c.log()
                    and {"1e-09.incomplete", "2e-09.incomplete"} <= set(os.listdir(c.path))
                    and c.log().rstrip().endswith("End"), c.times())


def burning(name, split=None):
    """A charge that burns in water under air beside a plate of points; its front takes
    9 us through the charge."""
    fluids = {"tnt": {**TNT, "detonation": {
        "type": "programmedBurn", "velocity": 6930, "points": [(0.15, 0.1, 0.005)]}},
        "water": WATER, "air": {"thermo": "perfectGas", "R": 287, "gamma": 1.4}}

    def initial(x, y, z):
        charge = 1.0*(np.hypot(x - 0.15, y - 0.1) < 0.06)
        water = (1 - charge)*(y < 0.2)
        return [charge, water, 1 - charge - water], [1630.0, 1000.0, 1.2], 0.0, 1e5
    c = fluidCase("restart", name, (40, 40, 1), (0.3, 0.3, 0.01), fluids, initial, 2e-5, ends=WALL,
                  writeInterval=5e-7, control={"maxCo": 0.3, "deltaT": 1e-8,
                                               "startFrom": "latestTime"})
    besidePoints(c, fluids, {"plate": {"constitutiveModel": {
        "type": "linearElastic", "rho": 2700, "E": 7e10, "nu": 0.3}}},
        {"plate": {"type": "box", "min": (0.05, 0.02, -1), "max": (0.07, 0.25, 1),
                   "stress": "ambient", "pressure": 1e5}})
    if split:
        c.decompose(split)
    return c


def killedFluids(table):
    for n, split in ((1, None), (2, (2, 1, 1))):
        def run(c, n=n):
            return c.run("materialPointFoam") if n == 1 else c.runParallel()
        straight, c = burning(f"burning-{n}", split), burning(f"burningKilled-{n}", split)
        run(straight)
        # The time of the end may be less than endTime by the last digit
        run(straight)
        table.check(f"charge beside points, {n} processor{'s'*(n > 1)}: a run that has ended"
                    " ends at once", "nothing to do" in straight.log()
                    or "No step" in straight.log(), straight.log()[-80:])
        folders = c.processors() or [c.path]
        end = times(straight)[-1]
        label = f"charge beside points, {n} processor{'s'*(n > 1)}"

        # As after a kill in the first write, before its points
        for folder in folders:
            os.makedirs(os.path.join(folder, "5e-07"))
            shutil.copy(os.path.join(folder, "0", "p"), os.path.join(folder, "5e-07", "Theta"))
        done, _ = kills(c, 6)
        table.check(f"{label}: a first time that was only begun is set aside",
                    all(os.path.isdir(os.path.join(folder, "5e-07.incomplete"))
                        for folder in folders), str(times(c)))
        table.check(f"{label}: killed on the way", 0 < float(times(c)[-1]) < float(end),
                    times(c)[-1])

        # A file of the last time that is cut off or gone, then the time without its mark
        run(c)
        t, folder = times(c)[-1], folders[-1]
        for file, words in (("thetaRhoE", "thetaRhoE"), ("F.tnt", "F.tnt"),
                            ("alpha.water", "alpha.water")):
            name = os.path.join(folder, t, file)
            for what in ("cut off", "empty", "gone"):
                os.rename(name, name + ".kept")
                if what != "gone":
                    with open(name + ".kept", "rb") as f, open(name, "wb") as g:
                        g.write(f.read()[:os.path.getsize(name + ".kept")//2
                                         if what == "cut off" else 0])
                try:
                    run(c)
                    text = ""
                except RunFailed:
                    text = c.log()
                if os.path.exists(name):
                    os.remove(name)
                os.rename(name + ".kept", name)
                table.check(f"{label}: {file} of the last time is {what}, one message names it",
                            text.count("--> FOAM FATAL") == 1 and words in text
                            and "printStack" not in text, " ".join(text.split()[-40:])[:100])
        os.remove(os.path.join(folder, t, "uniform", "materialPointState"))
        os.truncate(os.path.join(folder, t, "thetaRhoE"), 999)
        run(c)
        table.check(f"{label}: a last time without its mark, the run goes back and says so",
                    "was not written to its end" in c.log())
        differ, count = sameBits(straight, c, end)
        table.check(f"{label}: {done} kills, files of the end that differ",
                    not differ and count > 20*n, f"{differ} of {count}")


def ended(table):
    """The end is written whatever writeInterval is; SIGTERM writes and ends."""
    straight = case("end-straight", "FMPM2", "binary")
    straight.run("materialPointFoam")
    c = case("end", "FMPM2", "binary")
    c.change("system/controlDict", "writeInterval.*?;", f"writeInterval {0.7*END};")
    c.run("materialPointFoam")
    table.row("writeInterval does not divide endTime: last written time over endTime", 1,
              float(c.times()[-1])/END, 1e-9)
    for control, value in (("timeStep", 100000), ("runTime", 10*END)):
        c = case(f"end-{control}", "FMPM2", "binary")
        c.change("system/controlDict", "writeControl.*?;", f"writeControl {control};")
        c.change("system/controlDict", "writeInterval.*?;", f"writeInterval {value};")
        c.run("materialPointFoam")
        table.row(f"writeControl {control}: last written time over endTime", 1,
                  float(c.times()[-1])/END, 0.01)

    for name, number in (("SIGTERM", signal.SIGTERM), ("SIGINT", signal.SIGINT)):
        c = case(name, "FMPM2", "binary")
        c.change("system/controlDict", "writeInterval.*?;", "writeInterval 1;")
        c.change("system/controlDict", "endTime .*?;", "endTime 0.1; maxDeltaT 1e-10;")
        with open(c.file("log.signal"), "w") as log:
            p = subprocess.Popen(["materialPointFoam"], cwd=c.path, stdout=log, stderr=log,
                                 env={**os.environ, "PWD": c.path})
            for _ in range(600):
                time.sleep(0.1)
                if "\nTime = " in open(c.file("log.signal")).read():
                    break
            p.send_signal(number)
            status = p.wait(60)
        text = open(c.file("log.signal")).read()
        table.check(f"{name}: the run says so, ends well and has its state", status == 0
                    and f"Signal {int(number)} (" in text and text.rstrip().endswith("End")
                    and os.path.exists(c.file(c.times()[-1], "uniform/materialPointState"))
                    and float(c.times()[-1]) > 0, f"exit {status}, times {c.times()}")
        if float(c.times()[-1]) < 0.9*END:
            # To a time that the straight run has written
            later = [t for t in straight.times() if float(t) > 1.05*float(c.times()[-1])][0]
            c.change("system/controlDict", "writeInterval.*?;", f"writeInterval {INTERVAL};")
            c.change("system/controlDict", "endTime .*?;.*?;", f"endTime {later};")
            c.run("materialPointFoam")
            table.check(f"{name}: goes on to the end", abs(
                float(c.times()[-1])/float(later) - 1) < 1e-6, c.times()[-1])


def limits(table):
    """minDeltaT and maxEnergyGrowth end a run with its state, and it says who."""
    c = case("minDeltaT", "FLIP", "binary")
    c.change("system/controlDict", "^maxCo", "minDeltaT 1;\nmaxCo")
    c.run("materialPointFoam")
    table.check("minDeltaT: the run ends with its state", len(c.times()) == 2
                and "below minDeltaT" in c.log() and os.path.exists(
                    c.file(c.times()[-1], "uniform/materialPointState")), c.times())
    table.check("the log names who sets the time step", re.search(
        r"^deltaT set by points of (target|flyer): sound [\d.]+ m/s in \S+ mm", c.log(), re.M) is not None)
    c = case("maxEnergyGrowth", "FLIP", "binary")
    # FLIP beyond its stable step
    c.change("system/controlDict", "adjustTimeStep.*?;", "adjustTimeStep no;")
    c.change("system/controlDict", "deltaT .*?;", "deltaT 3.6e-8;")
    c.change("system/controlDict", "^maxCo.*?;", "maxEnergyGrowth 0.5;")
    c.change("system/fvSolution", "PICfraction.*?;", "maxTravel 0.9; maxStrain 1;")
    c.change("constant/phaseProperties", "strength.*?;", "strength 1e13;")
    c.change("system/controlDict", "endTime .*?;", "endTime 1e-3;")
    c.run("materialPointFoam")
    table.check("energy that grows without a source: one warning, then the end",
                c.log().count("Energy has grown by") >= 2 and c.log().count(
                    "Warning") >= 1 and "more than maxEnergyGrowth" in c.log()
                and float(c.times()[-1]) < 1e-3, c.times()[-1])

    # Found in the last step
    end = c.times()[-1]
    c.change("system/controlDict", "maxEnergyGrowth .*?;", "maxEnergyGrowth 0.05;")
    c.change("system/controlDict", "endTime .*?;", f"endTime {end}; reportInterval 100000;")
    c.change("system/controlDict", "writeInterval.*?;", f"writeInterval {float(end)/2!r};")
    for t in c.times()[1:]:
        shutil.rmtree(c.file(t))
    c.run("materialPointFoam")
    table.check("energy that has grown in the last step: it is the last",
                "more than maxEnergyGrowth" in c.log() and c.log().rstrip().endswith("End")
                and abs(float(c.times()[-1])/float(end) - 1) < 1e-9, c.times())
    table.check("energy that has grown in the last step: progress of the end",
                re.findall(r"^Progress: (\S+) %", c.log(), re.M)[-1] == "100")


def contactGains(table):
    """What contact gives at a step beyond the stable one is a growth of energy too."""
    template = os.path.join(os.path.dirname(__file__), "../../../etc/caseTemplate")
    for deltaT, warns in ((None, False), (1e-6, True)):
        c = FoamCase("restart", f"contactGains-{deltaT}", template)
        c.change("system/controlDict", "endTime .*?;", "endTime 20e-6; maxEnergyGrowth 1;")
        if deltaT:
            c.change("system/controlDict", "adjustTimeStep.*?;", "adjustTimeStep no;")
            c.change("system/controlDict", "deltaT .*?;", f"deltaT {deltaT!r};")
        for command in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
            c.run(command)
        grown = "Energy has grown by" in c.log()
        table.check(f"template, {'deltaT 6 times the stable' if warns else 'its own step'}: "
                    f"{'a warning, then the end' if warns else 'no warning of energy'}",
                    grown == warns and ("more than maxEnergyGrowth" in c.log()) == warns
                    and (float(c.times()[-1]) < 20e-6) == warns, c.times()[-1])


def drivenContact(table):
    """The work of a die that is pressed into a plate is a source, not a growth."""
    template = os.path.join(os.path.dirname(__file__), "../../../etc/caseTemplate")
    c = FoamCase("restart", "drivenContact", template)
    phases = "constant/phaseProperties"
    c.change(phases, r"(?s)flyer\s*\{.*?\}\s*\}", "flyer { type rigid; rho 7800; motion { type"
             " translation; velocity (0 -10 0); } }")
    c.change(phases, r"(?s)^target\s*\{.*?\}\s*(?=flyer)", "target { constitutiveModel { type"
             " J2Plasticity; rho 2700; E 70e9; nu 0.33; yield 300e6; hardening linear;"
             " H 500e6; } }\n")
    c.change("system/setMaterialPointsDict", r"velocity +\(.*?\);", "")
    c.change("system/controlDict", "endTime .*?;", "endTime 20e-6; maxEnergyGrowth 0.02;")
    for command in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
        c.run(command)
    contact = [float(v) for v in re.findall(r"^Energy budget:.* contact (\S+),", c.log(), re.M)]
    total = [float(v) for v in re.findall(r"^Energy: .* total (\S+)", c.log(), re.M)]
    table.row("die pressed into a plate: work in contact over the largest energy", 0.5,
              contact[-1]/max(total), 0.5, "atLeast")
    table.check("die pressed into a plate: no energy that grows",
                "Energy has grown" not in c.log() and float(c.times()[-1]) > 19.9e-6,
                c.times()[-1])


def edited(table):
    """fvSolution that is changed while the run goes on."""
    c = case("edited", "FMPM2", "binary")
    c.change("system/controlDict", "runTimeModifiable.*?;", "runTimeModifiable yes;")
    c.change("system/controlDict", "endTime .*?;", "endTime 1e-4; maxDeltaT 1e-13;")
    c.change("system/controlDict", "writeInterval.*?;", "writeInterval 1;")
    # OpenFOAM takes a file as changed if it is 10 s younger
    os.utime(c.file("system/fvSolution"), (time.time() - 60,)*2)
    with open(c.file("log.edited"), "w") as log:
        p = subprocess.Popen(["materialPointFoam"], cwd=c.path, stdout=log, stderr=log,
                             env={**os.environ, "PWD": c.path})

        def until(words):
            for _ in range(300):
                time.sleep(0.1)
                if re.search(words, open(c.file("log.edited")).read()):
                    return True
            return False

        until("\nTime = ")
        c.change("system/fvSolution", "order 2;", "order 3; maxStrain 0.1;\nstressUpdate USL;")
        acts = until("act from time")
        # Another transfer, then one more entry: each 20 s younger than the one before
        c.change("system/fvSolution", r"transfer FMPM;\s+order 3;", "transfer APIC;", age=-20)
        stays = until(r"changed: \d*\([^)]*\btransfer\b[^)]*\) *\n? *act only")
        c.change("system/fvSolution", "maxStrain 0.1;", "maxStrain 0.15;", age=-40)
        goesOn = until(r"\(maxStrain\) act")
        p.send_signal(signal.SIGTERM)
        status = p.wait(60)
    text = " ".join(open(c.file("log.edited")).read().split())
    table.check("fvSolution edited while running: what acts is named", acts and re.search(
        r"fvSolution.materialPoints has changed: \d*\((order maxStrain|maxStrain order)\) act"
        r" from time", text) is not None)
    table.check("fvSolution edited while running: what does not act is named",
                "(stressUpdate) act only in a new run" in text)
    table.check("fvSolution edited while running: another transfer waits for a new run, what"
                " comes after acts", stays and goesOn and status == 0, f"exit {status}")


def main():
    table = Report("restart")
    for scheme in SCHEMES:
        for writeFormat in ("binary", "ascii"):
            try:
                restarts(table, scheme, writeFormat)
            except RunFailed as e:
                table.check(f"{scheme}, {writeFormat} runs", False, e)
    for part in (functionTimes, lambda t: killed(t, 20), begun, killedFluids, ended, limits, contactGains,
                 drivenContact, edited):
        try:
            part(table)
        except RunFailed as e:
            table.check("runs", False, e)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
