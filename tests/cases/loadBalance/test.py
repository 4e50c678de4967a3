#!/usr/bin/env python3
"""Cells that go from processor to processor while a run goes on (loadBalance).

    moved    scenes of tests/cases/rebuild and two fluids, one of which detonates: every few
             steps all cells go to random processors, of three; points and fields of the
             whole case, by reconstructPar, are those of one processor to 1e-10
    allOfIt  points in contact, a free body, two fluids and a detonation in one scene, moved
             every second step: mass, momentum with what walls and gravity gave and the energy
             budget as without moves, to 1e-12, its terms to 3e-13 of the gas' energy
    budget   terms of the energy budget of a turning disc, a shock and a block, so too
    mesh     after moves to and fro a processor has the mesh of decomposePar, bit by bit
    restart  from a time in the middle, with the mesh of that time: to 1e-10
    killed   kill -9 before, in and after moves: the restarted run ends with the bits of the
             one that was left alone
    functions  of OpenFOAM that keep cells and fields of the mesh: probes, fieldAverage, mag
    thrown   a block that crosses the box: without moves it is on one of two processors,
             with them the points are shared evenly
    crossing  debris that crosses the box (crossing.py has more, by hand): imbalance after looks
    wrong    messages
"""

import os
import re
import random
import shutil
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from blockInGas import blockInGas
from everything import PHASES, everything, sums
from foamCase import FoamCase, RunFailed, foamText, readInternal, runParts, testModule
from gasCases import labels, volField
from killedRuns import killWhen, sameBits, times
from mpm.files import Points

DICT = "system/decomposeParDict"
RANDOM = {"maxImbalance": 1, "worth": 0, "method": "random"}


def module(name):
    return testModule(name, "loadBalance")


def balanced(case, interval, split=(3, 1, 1), name="moved", **entries):
    """The case, not run yet, on several processors with moves."""
    other = FoamCase("loadBalance", f"{case.name}-{name}")
    shutil.rmtree(other.path)
    shutil.copytree(case.path, other.path)
    other.decompose(split)
    other.change(DICT, "^method ", "loadBalance\n{\n    interval %d;\n%s}\nmethod " % (
        interval, "".join(f"    {k} {v};\n" for k, v in entries.items())))
    return other


def moves(case):
    return len(re.findall("^Load: .*[0-9]$", case.log(), re.M))


def difference(one, other, time):
    """Largest difference of points and of fields of the whole case, over the largest value."""
    clouds = one.file(time, "lagrangian")
    worst = 0.0
    for phase in os.listdir(clouds) if os.path.isdir(clouds) else ():
        a, b = one.points(time, phase), other.points(time, phase)
        for name in ("x", "U", "V", "damage"):
            if os.path.exists(os.path.join(clouds, phase, name)):
                u, v = a.byId(name), b.byId(name)
                worst = max(worst, np.max(abs(u - v))/max(np.max(abs(u)), 1e-300)
                            if u.shape == v.shape else np.inf)
    other.run("reconstructPar", "-time", time)
    n = 0
    for name in os.listdir(one.file(time)):
        if re.match(r"(p|T|rho|U|alpha|F)(\.|$)", name) and os.path.isfile(one.file(time, name)):
            try:
                u, v = (np.array(readInternal(c.file(time, name))) for c in (one, other))
            except (ValueError, TypeError):
                continue
            worst = max(worst, np.max(abs(u - v))/max(np.max(abs(u)), 1e-300)
                        if u.shape == v.shape else np.inf)
            n += 1
    return worst, n


def scenes():
    """Label, case, steps between moves, split."""
    rebuild = module("rebuild")
    rebuild.module = module
    yield ("failing plates in air", rebuild.plates("FMPM", air={}), 13, (1, 3, 1))
    yield ("discs in contact with friction", rebuild.shorter(
        module("contact").discsCase("discs", 3, 0.5)[0], 1.1), 13, (3, 1, 1))
    erosion = module("erosion")
    yield ("failure, contact and erosion to debris", erosion.debrisCase("debris"), 13, (3, 1, 1))
    axisymmetry = module("axisymmetryGas")
    yield ("wedge, cylinder in a gas", axisymmetry.inGas(
        "wedge", axisymmetry.cylinderRegion(5.2, 15.2, -1, 7.3), velocity=300.0,
        gasVelocity=(0, 0, 0), steps=40), 9, (1, 3, 1))
    yield "gas alone, an equation of state", rebuild.gasAlone(), 50, (3, 1, 1)


def moved(table):
    for label, case, interval, split in scenes():
        other = balanced(case, interval, split, **RANDOM)
        case.run("materialPointFoam")
        other.runParallel()
        worst, n = difference(case, other, case.times()[-1])
        table.row(f"{label}: moved often, largest difference to one processor", 0, worst, 1e-10)
        table.check(f"{label}: it was, and fields were compared", moves(other) > 2 and n > 0,
                    f"{moves(other)} times, {n} fields")


def booked(case):
    case.change("system/controlDict", r"^functions\s*\{", "functions\n{\n"
                + foamText({"fluids": {"type": "fluidBalance", "libs": "(mpmFunctionObjects)",
                                       "writeControl": "timeStep", "writeInterval": 1}}, 4))


def fluids(table):
    """Two fluids, of which one detonates; a wave on a block in water and air."""
    os.environ["MPM_MOVES"] = "7"
    try:
        for name, make, end, fields, limit in (
                ("detonation", "discCase", 2e-6, None, 1e-10),
                ("pointsInFluids", "struck", 5e-5, ("p", "U", "alpha.water"), 1e-9)):
            of = module(name)
            if make == "discCase":
                one, other = (of.discCase(f"moved-{n}", 16, end, split, before=booked)
                              for n, split in ((1, None), (3, (3, 1, 1))))
                what, worst = "largest difference to one processor", of.differences(
                    one, other, one.timeName(end))
                u, v = (c.series("fluids", "total.dat") for c in (one, other))
                table.row(f"{name}: moved often, fluidBalance, difference to one processor", 0,
                          np.max(abs(u - v))/np.max(abs(u)) if u.shape == v.shape else np.inf,
                          1e-12)
            else:
                one, other = (of.struck(f"moved-{n}", end, split=split)
                              for n, split in ((1, None), (3, (3, 1, 1))))
                pairs = [[of.volField(c, one.timeName(end), f) for c in (one, other)]
                         for f in fields]
                what = "fields against one processor"
                worst = max(np.max(abs(a - b))/np.max(abs(a)) for a, b in pairs)
            table.row(f"{name}: moved often, {what}", 0, worst, limit)
            table.check(f"{name}: it was", moves(other) > 0, moves(other))
    finally:
        del os.environ["MPM_MOVES"]


def allOfIt(table):
    one = everything("everything")
    still = balanced(one, 2, (2, 1, 1), "still", maxImbalance=1e9)
    other = balanced(one, 2, (2, 1, 1), **RANDOM)
    for case in (still, other):
        case.runParallel(limit=600)
    a, b = sums(still), sums(other)
    if any(a[k].shape != b[k].shape for k in a):
        table.check("everything: as many steps", False)
        return

    def worst(name, columns, size):
        return np.max(abs(a[name] - b[name])[:, columns])/size
    mixture, energy = a["balance mixture.dat"], a["energy energy.dat"]
    impulse = np.max(abs(mixture[:, 6:9]))
    exchanged = module("energyInGas").exchanged(energy)
    masses = {"balance mixture.dat": 1, "fluids charge.dat": 1, "fluids air.dat": 1,
              **{f"balance {p}.dat": 2 for p in PHASES}}
    label = "points, contact, a free body, two fluids, detonation, moved often, to without moves"
    table.row(f"{label}: masses", 0, max(worst(k, [i], np.max(a[k][:, i]))
                                         for k, i in masses.items()), 1e-12)
    table.row(f"{label}: momentum less what walls and gravity gave, over that", 0,
              worst("balance mixture.dat", [9, 10, 11], impulse), 1e-12)
    table.row(f"{label}: momenta of phases over that", 0,
              max(worst(f"balance {p}.dat", [3, 4, 5], impulse) for p in PHASES), 1e-12)
    # The gas has 33 times what was exchanged: 1e-11 of that is 3e-13 of its energy
    table.row(f"{label}: terms of the energy budget over what was exchanged", 0,
              worst("energy energy.dat", slice(1, None), exchanged), 1e-11)
    table.row(f"{label}: fluidBalance, impulse and energy through walls, over the largest", 0,
              max(worst("fluids total.dat", [10, 11], impulse),
                  worst("fluids total.dat", [13], exchanged)), 1e-9)
    closed = [float(n) for n in re.findall("^Contact all between .*closed nodes ([0-9]+)",
                                           still.log(), re.M)]
    table.check(f"{label}: bodies have met, the body too, it was moved",
                moves(other) >= 100 and max(closed[::3]) > 0 and max(closed[2::3]) > 0
                and moves(still) == 0, f"{moves(other)} times")


def killed(table):
    """Moves every 7 steps, times every 11: the restart's first step has no look."""
    case = module("parallel").fallingBlock(
        "killed", 2, {"shapeFunction": "GIMP", "transfer": "FLIP"})
    case.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
    case.change("system/controlDict", "^writeControl.*?;", "writeControl timeStep;")
    case.change("system/controlDict", "^writeInterval.*?;", "writeInterval 11;")
    case.change("system/controlDict", "^endTime.*?;", "endTime 4.6e-3;")
    straight = balanced(case, 7, (2, 1, 1), "straight", **RANDOM)
    straight.runParallel()
    other = balanced(case, 7, (2, 1, 1), "again", **RANDOM)
    rng = random.Random(3)
    n = sum(killWhen(other, words, 1 + i % 3, 0.004*rng.random())
            for i in range(4) for words in ("deltaT set by", "Load: imbalance",
                                            "Simulation is built again"))
    other.runParallel()
    end = times(straight)[-1]
    differ, count = sameBits(straight, other, end)
    table.check("kill -9 before, in and after moves: the last time has the bits of the run that"
                " was left alone", not differ and count > 20 and times(other)[-1] == end,
                f"{differ} of {count}, {times(other)[-1]} {end}")
    table.check("kill -9: runs were killed, steps", n >= 8 and 66 < straight.nSteps() < 77,
                f"{n}, {straight.nSteps()}")


def crossing(table):
    """Debris that crosses the box."""
    import crossing as of
    one, fresh = (of.debris(f"debris{word}", 3) for word in ("", "-fresh"))
    one.run("materialPointFoam")
    end = one.times()[-1]
    for n in (2, 4):
        case = balanced(fresh, 25, (n, 1, 1), f"on{n}", maxImbalance=1.1, worth=0)
        case.runParallel()
        label = f"debris that crosses the box, {n} processors"
        table.row(f"{label}: largest difference to one", 0,
                  one.largestDifference(case, end, ["debris"], ("x", "U", "V", "sigma")), 1e-10)
        looks = of.after(case)
        table.row(f"{label}: largest imbalance of the load after a look", 1, max(looks), 1.2,
                  "atMost")
        table.check(f"{label}: it was moved", moves(case) > 8, moves(case))
        table.row(f"{label}: way of the centre [boxes]", 0.6, np.mean(
            one.points(end, "debris")["x"][:, 0] - one.points("0", "debris")["x"][:, 0])/1.2, 0.6,
            "atLeast")


def thrown(table):
    """A block that crosses the box, which two processors share by its length."""
    parallel = module("parallel")

    def make(name):
        return parallel.fallingBlock(name, 2, {"shapeFunction": "GIMP", "transfer": "FLIP"})
    one = make("thrown")
    one.run("materialPointFoam")
    end = one.times()[-1]
    shares = {}
    for name, most in (("left", 1000), ("balanced", 1.1)):
        fresh = make(f"thrown-{name}")
        case = balanced(fresh, 10, (2, 1, 1), maxImbalance=most, worth=0)
        case.runParallel()
        table.row(f"thrown block, {name}: largest difference to one processor", 0,
                  one.largestDifference(case, end, ["block"], ("x", "U", "V")), 1e-10)
        counts = [len(Points([os.path.join(p, end, "lagrangian/block")])["x"])
                  for p in case.processors()]
        shares[name] = max(counts)/np.mean(counts)
    table.row("thrown block: points of the fuller processor over the mean, left", 2,
              shares["left"], 1.3, "atLeast")
    table.row("thrown block: the same, balanced", 1, shares["balanced"], 1.2, "atMost")


def mesh(table):
    """Random moves, and back to the first distribution."""
    parallel = module("parallel")
    case = parallel.fallingBlock("mesh", 2, {"shapeFunction": "GIMP", "transfer": "FLIP"})
    other = balanced(case, 10, (2, 2, 1), **RANDOM)
    other.runParallel()
    end = sorted((t for t in os.listdir(other.processors()[0]) if t[0].isdigit()), key=float)[-1]
    where = {}
    for i, p in enumerate(other.processors()):
        where.update({c: i for c in labels(os.path.join(p, end, "polyMesh/cellProcAddressing"))})
    again = FoamCase("loadBalance", "mesh-manual")
    shutil.rmtree(again.path)
    shutil.copytree(case.path, again.path)
    again.write("constant/cellDecomposition", "")
    with open(again.file("constant/cellDecomposition"), "w") as f:
        f.write("FoamFile { version 2.0; format ascii; class labelList; object d; }\n"
                f"{len(where)}\n(\n" + "\n".join(str(where[c]) for c in sorted(where))
                + "\n)\n")
    again.write(DICT, {"numberOfSubdomains": 4, "method": "manual",
                       "manualCoeffs": {"dataFile": '"cellDecomposition"'}})
    again.run("decomposePar", "-force")
    bad = []
    for p, q in zip(other.processors(), again.processors()):
        for name in ("owner", "neighbour", "faces", "points", "cellProcAddressing",
                     "faceProcAddressing", "pointProcAddressing", "boundaryProcAddressing"):
            a, b = (data(os.path.join(d, "polyMesh", name))
                    for d in (os.path.join(p, end), os.path.join(q, "constant")))
            if a != b:
                bad.append(os.path.join(os.path.basename(p), name))
    table.check("after random moves each processor has the mesh that decomposePar makes of the"
                " same distribution, bit by bit", len(other.processors()) == 4 and not bad, bad)


def data(path):
    """A file without its header."""
    with open(path, "rb") as f:
        raw = f.read()
    return raw[raw.index(b"// * *"):].split(b"\n", 1)[1]


def budget(table):
    energy = module("energyInGas")
    turning = {"type": "rotation", "origin": (0.0251, 0.0197, 0), "axis": (0, 0, 1),
               "omega": 3000}
    one = energy.struck("budget", turning, True)
    other = balanced(one, 20, (2, 1, 1), **RANDOM)
    one.run("materialPointFoam", limit=300)
    other.runParallel()
    a, b = (c.series("energy", "energy.dat") for c in (one, other))
    table.row("energy budget of points in a gas, moved often: terms against one processor", 0,
              np.max(abs(a - b))/energy.exchanged(a) if a.shape == b.shape else np.inf, 1e-9,
              "atMost")
    table.check("energy budget: it was moved", moves(other) > 3, moves(other))


def functions(table):
    """Function objects of OpenFOAM that keep cells and fields of the mesh."""
    case = blockInGas("loadBalance", "functions", 2, 16, {
        "type": "box", "min": (4e-4, 4e-4, -1), "max": (1e-3, 1e-3, 1)}, (80, 60, 0), 40, reports=2)
    case.change("system/controlDict", "^functions\n{", """functions
{
    magnitude { type mag; libs (fieldFunctionObjects); field U.air; writeControl writeTime; }
    mean
    {
        type fieldAverage;
        libs (fieldFunctionObjects);
        fields (p { mean on; prime2Mean off; base time; });
        writeControl writeTime;
    }
    places
    {
        type probes;
        libs (sampling);
        fields (p);
        probeLocations ((3.3e-4 4.2e-4 5e-5) (1.2e-3 9e-4 5e-5));
        writeControl timeStep;
        writeInterval 1;
    }
""")
    other = balanced(case, 7, (2, 1, 1), **RANDOM)
    case.run("materialPointFoam")
    other.runParallel()
    end = case.times()[-1]
    for name in ("pMean", "mag(U.air)"):
        u, v = (volField(c, end, name) for c in (case, other))
        table.row(f"function objects, {name}: largest difference to one processor", 0,
                  np.max(abs(u - v))/np.max(abs(u)), 1e-10)
    u, v = (c.series("places", "p") for c in (case, other))
    table.row("function objects, probes: largest difference to one processor", 0,
              np.max(abs(u - v))/np.max(abs(u)) if u.shape == v.shape else np.inf, 1e-5)
    table.check("function objects: it was moved", moves(other) > 2, moves(other))


def restart(table):
    parallel = module("parallel")
    case = parallel.fallingBlock("restart", 2, {"shapeFunction": "GIMP", "transfer": "APIC"})
    case.change("system/controlDict", "^startFrom.*?;", "startFrom latestTime;")
    a = balanced(case, 10, (2, 2, 1), **RANDOM)
    b = balanced(case, 10, (2, 2, 1), "again", **RANDOM)
    a.runParallel()
    half, end = sorted((t for t in os.listdir(a.processors()[0])
                        if re.fullmatch(r"[\d.e+-]+", t)), key=float)[1:]
    for p, q in zip(a.processors(), b.processors()):
        shutil.copytree(os.path.join(p, half), os.path.join(q, half))
    b.runParallel()
    table.row("restart from a mesh that was moved: largest difference to the straight run", 0,
              a.largestDifference(b, end, ["block"], ("x", "U", "V", "C")), 1e-10)
    table.check("restart: both were moved", moves(a) > 5 and moves(b) > 2,
                f"{moves(a)}, {moves(b)}")


def wrong(table):
    parallel = module("parallel")
    case = parallel.fallingBlock("wrong", 2, {"shapeFunction": "GIMP", "transfer": "FLIP"})
    for label, entries, words in (
            ("keyword", {"maxImbalence": 1.2}, ("maxImbalence", "maxImbalance")),
            ("value", {"maxImbalance": 0.5}, ("maxImbalance", "0.5")),
            ("method", {"method": "scotchy"}, ("scotchy", "hierarchical"))):
        other = balanced(case, 5, (2, 1, 1), f"wrong-{label}", **entries)
        try:
            other.runParallel()
            text = ""
        except RunFailed:
            text = other.log()
        lacks = [w for w in words if w not in text]
        table.check(f"wrong input: {label}", not lacks, f"message lacks {lacks}")
    other = balanced(case, 5, (2, 1, 1), "wrong-handler")
    try:
        other.runParallel("materialPointFoam", "-fileHandler", "collated")
        text = ""
    except RunFailed:
        text = other.log()
    table.check("wrong input: fileHandler collated",
                "fileHandler collated" in text and "uncollated" in text, text[-200:])
    other = balanced(case, 5, (2, 1, 1), "wrong-addressing")
    os.remove(os.path.join(other.processors()[1], "constant/polyMesh/cellProcAddressing"))
    try:
        other.runParallel()
        text = ""
    except RunFailed:
        text = other.log()
    table.check("wrong input: no cellProcAddressing",
                "cellProcAddressing" in text and "decomposePar" in text, text[-200:])


if __name__ == "__main__":
    sys.exit(runParts("loadBalance", moved, fluids, allOfIt, budget, mesh, functions, restart,
                      killed, crossing, thrown, wrong))
