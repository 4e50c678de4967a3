#!/usr/bin/env python3
"""A run that is taken down to rows and built again in memory (simulation).

    same        rebuildInterval: every few steps, on the same mesh. All files of the last
                time are those of the run that was not, bit by bit: columns, fields, nodes'
                velocities, the state of restarts
    ranks       the same on 2 processors, without the state, whose sums over processors
                are added in another order
    renumbered  once, on a mesh whose cells and faces of patches are in random order
                (renumbered/): all columns and fields of the gas to 1e-12 of their maximum
    memory      the most memory of a run that was rebuilt 60 times over that of one that
                was rebuilt 6 times
"""

import os
import re
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from blockInGas import blockInGas
from coupledCases import ambient, coupledCase
from foamCase import RUN, FoamCase, runParts, testModule
from gasCases import WALL, gasCase
from plates import plateCase

CONTROL = "system/controlDict"


def module(name):
    return testModule(name, "rebuild")


def again(case, interval, name="rebuilt"):
    """The case, not run yet, as one that is rebuilt."""
    other = FoamCase("rebuild", f"{case.name}-{name}")
    shutil.rmtree(other.path)
    shutil.copytree(case.path, other.path)
    other.change(CONTROL, "^startTime", f"rebuildInterval {interval};\nstartTime")
    return other


def differing(a, b, folder, skip=()):
    """Files below a folder that are not the same in both cases."""
    names = set()
    for case in (a, b):
        for path, _, files in os.walk(case.file(folder)):
            names |= {os.path.relpath(os.path.join(path, f), case.path) for f in files}
    bad = []
    for name in sorted(names):
        if os.path.basename(name) in skip:
            continue
        contents = []
        for case in (a, b):
            try:
                with open(case.file(name), "rb") as f:
                    contents.append(f.read())
            except FileNotFoundError:
                contents.append(None)
        if contents[0] != contents[1]:
            bad.append(name)
    return bad, len(names)


def rebuilt(case):
    """How many times a run was."""
    return case.log().count("Simulation is built again")


def plates(scheme, **options):
    numerics = {
        "FLIP": {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01},
        "FMPM": {"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2},
        "APIC-USAVG": {"shapeFunction": "GIMP", "transfer": "APIC", "stressUpdate": "USAVG"}}
    case = plateCase("rebuild", "plates-" + scheme + ("-air" if options else ""), 19,
                     {**numerics[scheme], "energyBudget": not options}, 0.9e-6, 0.9e-6, 0.5,
                     strength=400e6, **options)
    case.change("constant/phaseProperties", "strength.*?;",
                "strength 400e6; weibull { modulus 10; seed 3; }")
    return case


def shorter(case, end):
    case.change(CONTROL, "^endTime .*?;", f"endTime {end!r};")
    case.change(CONTROL, "^writeInterval .*?;", f"writeInterval {end!r};")
    return case


def rigidPush():
    rigid = module("rigid")
    return rigid.build(
        "push", (14, 16),
        {"plate": {"type": "rigid", "rho": 7800, "motion": {
            "type": "translation",
            "velocity": "table ((0 (0 0 0)) (0.013 (0 0.9 0)) (1 (0 0.9 0)))"}},
         "block": {"constitutiveModel": rigid.LAW, "bodyForce": {
             "type": "uniform", "acceleration": "table ((0 (0 0 0)) (0.1 (30 -50 0)))"}}},
        {"plate": {"min": (rigid.H, 2*rigid.H, 0), "max": (13*rigid.H, 4*rigid.H, rigid.H)},
         "block": {"min": (4*rigid.H, 4*rigid.H, 0), "max": (9*rigid.H, 9*rigid.H, rigid.H)}},
        {**rigid.FLIP, "PICfraction": 0.01}, rigid.controlDict(0.03, 0.03, maxCo=0.4))


def gasAlone():
    """Stiffened gas whose ends have a boundary condition with a state."""
    ends = ({"type": "waveTransmissive", "gamma": 1, "phi": "phi.air", "psi": "psi.air",
             "rho": "rho.air", "fieldInf": 1, "lInf": 1}, "zeroGradient", "zeroGradient")
    return gasCase("rebuild", "gas-alone", (60, 1, 1), (1, 0.1, 0.1),
                   lambda x, y, z: (1 + (x < 0.5), 0*x, 1 + (x < 0.5)), 0.5, ends=ends,
                   thermo={"rho": 1, "equationOfState": {
                       "type": "stiffenedGas", "gamma": 4.4, "pInf": 6, "p0": 1}})


def grainsInGas():
    """Grains with drag and a granular pressure in a gas between walls."""
    return coupledCase(
        "rebuild", "grains", (20, 10, 1), (1, 0.5, 0.05),
        lambda x, y, z: (1 + 0*x, 0*x, 1 + 0.3*(x < 0.4)), 0.1,
        {"dust": {"constitutiveModel": {"type": "noStress", "rho": 100},
                  "volumeModel": "grains",
                  "granularPressure": {"type": "JohnsonJackson", "Fr": 1e-6, "alphaMin": 0.3,
                                       "alphaMax": 0.65},
                  "drag": {"type": "SchillerNaumann", "d": 1e-3}}},
        {"dust": {"type": "box", "min": (0.3, 0.1, -1), "max": (0.6, 0.4, 1),
                  "volumeFraction": 0.4, "velocity": (0.5, 0.3, 0)}},
        gas={"mu": 1e-3}, ends=WALL, sides=WALL)


def cases():
    """Label, case, interval of rebuilding."""
    for scheme in ("FLIP", "FMPM", "APIC-USAVG"):
        yield f"failing plates, {scheme}", plates(scheme), 7
    yield ("discs in contact with friction",
           shorter(module("contact").discsCase("discs", 3, 0.5)[0], 1.3), 11)
    yield "prescribed motion and body force", rigidPush(), 9
    yield ("free body in contact, FMPM", module("freeBody").collideCase(
        "half rigid", "half rigid", 0.25, 0.25, module("freeBody").FMPM), 13)
    erosion = module("erosion")
    yield "failure, contact and erosion to debris", erosion.debrisCase("debris"), 10
    yield ("erosion, APIC, USAVG", erosion.impact(
        "apic", erosion.ERODES, False, {"shapeFunction": "GIMP", "transfer": "APIC",
                                        "stressUpdate": "USAVG"}), 10)
    yield "failing plates in air", plates("FLIP", air={}), 13
    yield "block in a shock, drag", blockInGas(
        "rebuild", "shocked", 2, 16, {"type": "box", "min": (4e-4, 4e-4, -1),
                                      "max": (1.0e-3, 1.1e-3, 1)},
        velocity=(200, 100, 0), gasVelocity=(0, 0, 0), steps=60,
        numerics={"shapeFunction": "GIMP", "transfer": "FMPM", "order": 2}), 7
    yield "grains in a gas", grainsInGas(), 9
    yield "gas alone, an equation of state", gasAlone(), 7
    axisymmetry = module("axisymmetryGas")
    yield ("wedge, cylinder in a gas", axisymmetry.inGas(
        "wedge", axisymmetry.cylinderRegion(5.2, 15.2, -1, 7.3), velocity=300.0,
        gasVelocity=(0, 0, 0), steps=60), 7)


def same(table):
    for label, case, interval in cases():
        other = again(case, interval)
        case.run("materialPointFoam")
        other.run("materialPointFoam")
        bad, n = differing(case, other, case.times()[-1])
        times = rebuilt(other)
        table.check(f"{label}: rebuilt {'often' if times > 3 else 'too seldom'}, all files of"
                    " the last time are the same", times > 3 and n > 5 and not bad,
                    f"{times} times, {n} files, different: {bad[:8]}")


def ranks(table):
    for label, make in (("failing plates in air", lambda: plates("FMPM", air={})),
                        ("discs in contact", lambda: shorter(
                            module("contact").discsCase("discs-2", 3, 0.5)[0], 1.1))):
        case = make()
        case.decompose((1, 2, 1))
        other = again(case, 13)
        case.runParallel()
        other.runParallel()
        bad, n = [], 0
        for i in range(2):
            last = sorted((t for t in os.listdir(case.file(f"processor{i}"))
                           if t[0].isdigit()), key=float)[-1]
            wrong, more = differing(case, other, f"processor{i}/{last}",
                                    ("materialPointState",))
            bad, n = bad + wrong, n + more
        times = rebuilt(other)
        table.check(f"{label}, 2 processors: rebuilt, all files of the last time are the same",
                    times > 3 and n > 10 and not bad,
                    f"{times} times, {n} files, different: {bad[:8]}")


def renumbered(table):
    build = os.path.join(RUN, "rebuild", "renumbered")
    shutil.rmtree(build, ignore_errors=True)
    shutil.copytree(os.path.join(HERE, "renumbered"), build)
    made = subprocess.run(["wmake", build], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, env={**os.environ, "FOAM_USER_APPBIN": build})
    if made.returncode:
        table.check("renumbered is built", False, made.stdout[-200:])
        return
    axisymmetry = module("axisymmetryGas")
    erosion = module("erosion")
    for label, case, dt in (
            ("grains in a gas", grainsInGas(), 2e-3),
            ("failing plates in air", plates("FMPM", air={}), 3e-9),
            ("contact, failure, erosion", erosion.impact("numbers", erosion.ERODES, True),
             2e-5),
            ("wedge, cylinder in a gas", axisymmetry.inGas(
                "numbers", axisymmetry.cylinderRegion(5.2, 15.2, -1, 7.3), velocity=300.0,
                # Rounding of the strain times E is 1e-16*E: against 1 bar
                gasVelocity=(0, 0, 0), steps=60, E=7e7), None)):
        case.change(CONTROL, "^adjustTimeStep .*?;", "adjustTimeStep no;")
        case.change(CONTROL, "^startFrom .*?;", "startFrom startTime;")
        if dt:
            case.change(CONTROL, "^deltaT .*?;", f"deltaT {dt!r};")
        case.run(os.path.join(build, "renumbered"), "-steps", "40")
        found = re.findall(r"^(?:Column|Field) (\S+): (\S+)$", case.log("renumbered"), re.M)
        worst = max(found, key=lambda f: float(f[1]))
        table.row(f"{label}: largest difference after 40 steps, the mesh renumbered at 20",
                  0, float(worst[1]), 1e-12)
        table.check(f"{label}: columns and fields were compared, and the order did matter",
                    len(found) > 5 and float(worst[1]) > 0, f"{len(found)}, {worst[0]}")


def ownMemory(run):
    """Largest memory of a process without pages of files: of the 64 MB of this run 58 are
    libraries, of which the system maps more or fewer as it has them at hand. What is left
    is 6076 kB after 6 steps, 6124 after 60 and 6152 after 600."""
    most = 0
    while run.poll() is None:
        try:
            with open(f"/proc/{run.pid}/status") as status:
                most = max([most, *map(int, re.findall(r"RssAnon:\s+(\d+)", status.read()))])
        except OSError:
            pass
        time.sleep(2e-3)
    return most


def memory(table):
    peaks = []
    for n in (6, 60):
        case = again(plates("FMPM", air={}), 1, f"memory-{n}")
        case.change(CONTROL, "^adjustTimeStep .*?;", "adjustTimeStep no;")
        case.change(CONTROL, "^deltaT .*?;", "deltaT 3e-9;")
        case.change(CONTROL, "^writeControl .*?;", "writeControl timeStep;")
        case.change(CONTROL, "^writeInterval .*?;", "writeInterval 1000;")
        case.change(CONTROL, "^endTime .*?;", f"endTime {n*3e-9!r};")
        with open(case.file("log.materialPointFoam"), "w") as log:
            run = subprocess.Popen(["materialPointFoam"], cwd=case.path, stdout=log,
                                   stderr=log, env={**os.environ, "PWD": case.path})
            peaks.append(ownMemory(run))
        times = rebuilt(case)
        table.check(f"memory: {n} steps, rebuilt before each but the first",
                    run.returncode == 0 and times >= n - 1, times)
    if os.environ.get("MPM_BUILD") == "sanitize":
        table.skip("memory: most of 60 steps over most of 6 steps",
                   "the address sanitizer keeps what was freed")
        return
    table.row("memory: most of 60 steps over most of 6 steps", 1, peaks[1]/peaks[0], 1.03,
              "atMost")


if __name__ == "__main__":
    sys.exit(runParts("rebuild", same, ranks, renumbered, memory))
