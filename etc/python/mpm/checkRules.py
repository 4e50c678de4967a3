"""What is probably wrong with a case, by its dictionaries and what the solver says at its start.

    # Facts (mpm.checkFacts) of a case with mesh and points, after materialPointFoam -dry-run
    for finding in findings(facts): ...

Limits of units: bounds of what matter and laboratories have (BOUNDS), not of what the method can
do. Those of schemes are the tables of doc/guide/schemes.md. A rule is a function of the facts
that gives its findings.
"""

import itertools
import math
import os
import re
import shutil

import numpy as np

from mpm import checkFluids, checkStart
from mpm.checkFacts import CONTROL, LIQUIDS, PHASES, REGIONS, SOLUTION, patchPoints
from mpm.checkFinding import Finding
from mpm.files import readField

#: Lowest and highest of what is no mistake
BOUNDS = {"rho": (0.1, 25000), "speed": (10, 20000), "length": (1e-6, 1e3), "g": (0.1, 1000)}
#: A mesh of this length [m] whose cells are larger than all bodies is in another unit
SITE = 100
#: In g/cm3, osmium
HEAVIEST = 23
#: Poisson number from which matter locks
LOCKS = 0.45
#: Steps from which a motion is long for a transfer that dissipates in each
LONG = 20000
#: Written times [bytes] and their number above which a word is due
MUCH, MANY = 50e9, 1000
#: Words of writeControl with an interval in s
IN_TIME = ("adjustableRunTime", "adjustable", "runTime")
PLASTIC = ("J2Plasticity", "JohnsonCook")
#: Conditions of p that let most of a wave out (doc/guide/fluids.md), or have it at a wall
OPEN = ("farField", "waveTransmissive", "advective", "zeroGradient")
#: Types of patches through which nothing shall go
CLOSED = ("empty", "wedge", "cyclic", "symmetry", "symmetryPlane", "wall")


def _outside(value, name):
    low, high = BOUNDS[name]
    return isinstance(value, (int, float)) and not low <= abs(value) <= high


# --- units ---------------------------------------------------------------------

def densities(facts):
    # Numbers without units are no mistake
    g = float(np.linalg.norm(facts.g()))
    liquids = checkFluids.LIQUID_STATES
    inUnits = 9.7 < g < 9.9 or any(
        facts.rho.get(n, 0) > 500 and checkFluids.equation(facts, n) in liquids
        for n in facts.media)
    for name in facts.properties.get("phases", ()):
        of, law = facts.of(name), facts.lawOf(name)
        rho, entry = (law["rho"], "constitutiveModel.rho") if "rho" in law \
            else (of.get("rho"), "rho")
        if _outside(rho, "rho") and rho > 0:
            yield Finding("warning", PHASES, f"{name}.{entry}", f"a density of {rho:g} kg/m3; "
                          "matter has 0.1 to 25000", "kg/m3: 7800 for 7.8 g/cm3, 7.8e-9 t/mm3",
                          "troubleshooting.md", rf"phase {name}\b.*kg/m3")
        elif inUnits and isinstance(rho, (int, float)) and 0.5 <= rho <= HEAVIEST and (
                name in facts.phases or checkFluids.equation(facts, name) in liquids):
            yield Finding("warning", PHASES, f"{name}.{entry}", f"a density of {rho:g} kg/m3: "
                          "cork has 120, air 1.2", f"{1000*rho:g} for {rho:g} g/cm3",
                          "troubleshooting.md")


def waveSpeeds(facts):
    for name, phase in facts.phases.items():
        soft = phase.law in LIQUIDS or phase.law in ("DruckerPrager", "MohrCoulomb", "muI")
        if phase.speed and _outside(phase.speed, "speed") and not (soft and phase.speed < 10):
            what = (f"a layer {phase.speed**2/9.81:.3g} m high is squeezed flat by its own weight"
                    if phase.speed < 10 else "too fast (diamond 18000): a density in g/cm3?")
            yield Finding("warning", PHASES, f"{name}.constitutiveModel", f"a wave speed of "
                          f"{phase.speed:.4g} m/s: {what}", "if it is not meant: moduli in Pa, "
                          "1e6 for 1 MPa, 70e9 for 70 GPa; rho in kg/m3", "troubleshooting.md",
                          rf"phase {name} has a wave speed")


def strengths(facts):
    for name in facts.phases:
        law, failure = facts.lawOf(name), facts.of(name).get("failureModel", {})
        E = law.get("E") or 3*law.get("G", 0)
        if not isinstance(E, (int, float)) or not E:
            continue
        rows = [("constitutiveModel.yield", law.get("yield")),
                ("constitutiveModel.A", law.get("A") if law.get("type") == "JohnsonCook" else 0)]
        if isinstance(failure, dict):
            rows.append(("failureModel.strength", failure.get("strength")))
        for entry, value in rows:
            if isinstance(value, (int, float)) and value > E:
                yield Finding("warning", PHASES, f"{name}.{entry}", f"{value:g} Pa is above the "
                              f"modulus, {E:g} Pa", "both in Pa: is one of them in MPa or GPa?",
                              "troubleshooting.md")


def friction(facts):
    for name in facts.phases:
        angle = facts.lawOf(name).get("frictionAngle")
        if isinstance(angle, (int, float)) and 0 < angle < 1.6:
            yield Finding("warning", PHASES, f"{name}.constitutiveModel.frictionAngle",
                          f"{angle:g} degrees: hardly any friction", "in degrees: "
                          f"{math.degrees(angle):.3g} for {angle:g} rad", "materials.md")


def grains(facts):
    """Regions of grains without room between these."""
    for name, region in facts.regions.items():
        phase = region.get("phase") if isinstance(region, dict) else None
        if facts.of(phase).get("volumeModel") == "grains" and "volumeFraction" not in region:
            yield Finding("warning", REGIONS, f"regions.{name}", f"grains of {phase} fill all of "
                          "it: there is no room between them", "volumeFraction 0.6 (sand has 0.55 "
                          "to 0.65), or 1 if it is meant", "fluids.md#grains")


def meshSize(facts):
    sizes = [float(size[facts.axes].max()) for _, size, _, _ in facts.boxes().values()]
    largest = float(facts.size.max())
    if SITE < largest <= BOUNDS["length"][1] and sizes and max(sizes) < facts.width:
        made = os.path.exists(facts.case.file("system/blockMeshDict"))
        yield Finding("warning", *(("system/blockMeshDict", "scale") if made else (
            "constant/polyMesh", "")), f"the mesh is {largest:.4g} m long, its cells "
                      f"{facts.width:.3g} m wide, the largest body {max(sizes):.3g} m: is the mesh "
                      "in mm?",
                      "lengths in m: scale 1e-3 for a mesh in mm" + (
                          "" if made else ", transformPoints -scale '(1e-3 1e-3 1e-3)'"),
                      "meshes.md")
    for d, size in zip("xyz", facts.size):
        if _outside(float(size), "length"):
            yield Finding("warning", "system/blockMeshDict", "scale", f"the mesh is {size:.4g} m "
                          f"long in {d}", "lengths in m after scale: scale 1e-3 for a mesh in mm",
                          "meshes.md")


def gravity(facts):
    path, g = "constant/g", float(np.linalg.norm(facts.g()))
    if g and _outside(g, "g"):
        yield Finding("warning", path, "value", f"{g:g} m/s2; the earth has 9.81",
                      "m/s2: 9.81 for 9810 mm/s2", "materials.md#body-forces",
                      "whatever the unit of the mesh")
    up = int(np.argmax(np.abs(facts.g())))
    if g and facts.g()[up] > 0:
        yield Finding("note", path, "value", f"({' '.join(f'{c:g}' for c in facts.g())}): things "
                      f"fall towards larger {'xyz'[up]}", f"a negative one where {'xyz'[up]} points up",
                      "materials.md#body-forces")


def pressure(facts):
    """Of the start, in bar. Temperatures in degrees Celsius the programs find themselves."""
    for name in facts.media:
        temperature = facts.case.file("0/T." + name)
        if not facts.p or not os.path.exists(temperature):
            continue
        p, T = np.min(facts.case.field("0", "p")), np.min(facts.case.field("0", "T." + name))
        if 0 < p < 100 and T > 100:
            yield Finding("warning", *_from(facts, "p", p), f"{p:g} Pa at {T:g} K",
                          "in Pa: 1e5 for 1 bar", "fluids.md#gas")
            return


def _from(facts, field, value):
    """File and entry that a value of a field at the start comes from."""
    for path in ("system/setFieldsDict", "system/setFluidsDict"):
        if os.path.exists(facts.case.file(path)):
            with open(facts.case.file(path), errors="replace") as f:
                found = re.findall(rf"\b({field}\w*)\s+([-+]?\d[\d.]*(?:e[-+]?\d+)?)", f.read())
            for name, v in found:
                if abs(float(v) - value) <= 1e-6*abs(value):
                    return path, name
    return "0/" + field, "internalField"


def duration(facts):
    """Waves that do not get anywhere, and runs without end."""
    c = max([p.speed + p.U for p in facts.phases.values()] + [facts.sound])
    cells = c*facts.end/facts.width if c and facts.end > 0 else math.nan
    if cells < 3:
        yield Finding("warning", CONTROL, "endTime", f"in {facts.end:g} s the fastest wave "
                      f"({c:.4g} m/s) goes {cells:.2g} cells of {facts.width:.3g} m: nothing can "
                      "happen", "endTime in s; or the mesh and the shapes are in mm: scale 1e-3",
                      "troubleshooting.md")
    elif cells > 1e7:
        yield Finding("warning", CONTROL, "endTime", f"more than 1e7 steps: in {facts.end:g} s the "
                      f"fastest wave goes {cells:.2g} cells", "endTime in s: 1e-4 for 100 us",
                      "running.md", "would take")


# --- waves ---------------------------------------------------------------------

def wavesLeave(facts):
    """Open sides of a gas or fluids that send waves back before the end."""
    conditions = facts.p.get("boundaryField", {})
    sends = [patch for patch, of in conditions.items() if isinstance(of, dict)
             and facts.patches.get(patch) not in (None, *CLOSED)
             and of.get("type") not in (None, *OPEN)]
    if not facts.sound or not sends:
        return
    low = np.min([p.low for p in facts.phases.values() if p.n] or [facts.low], axis=0)
    high = np.max([p.high for p in facts.phases.values() if p.n] or [facts.high], axis=0)
    if not facts.points:
        low = high = (facts.low + facts.high)/2
    x = readField(facts.case.file("constant/polyMesh/points"))
    for patch, corners in patchPoints(facts.case, x, sends).items():
        kind = conditions[patch]["type"]
        gap = np.maximum(0, np.maximum(low - corners, corners - high))[:, facts.axes]
        way = float(np.sqrt((gap**2).sum(axis=1)).min())
        time = 2*way/facts.sound
        if time < facts.end:
            yield Finding("note", "0/p", f"boundaryField.{patch}", f"{kind} sends waves back: what "
                          f"starts at the {'points' if facts.points else 'middle'} is there again "
                          f"from {time:.3g} s on (endTime {facts.end:g} s)",
                          "farField, or a larger mesh, if waves shall leave",
                          "fluids.md#open-boundaries")


def holders(facts, name):
    """Words on what holds the points of a phase: sides with fixedValue in its 0/U, rigid bodies of
    its velocity field; nothing, where a fluid or gravity loads it."""
    phase = facts.phases[name]
    if not phase.n or facts.of(name).get("type") == "rigid":
        return ""
    gaps = _sides(facts, name)
    words = [f"held by {patch}" if gap < facts.width else
             f"{patch}, which would hold it, is {gap:.3g} m away"
             for patch, (kind, gap) in gaps.items() if kind == "fixedValue"]
    words += ["held by " + body for body in checkStart.clamps(facts, name)]
    if not words and (facts.media or np.linalg.norm(facts.g())) and not _touched(facts, name):
        words.append("no side, rigid body or contact holds it")
    return "".join("; " + w for w in words)


def _touched(facts, name):
    """May sides, rigid bodies or contact act on a phase, or on one of its velocity field?"""
    def field(phase):
        return str(facts.of(phase).get("velocityField", phase))
    all_ = [n for n, p in facts.phases.items() if p.n and field(n) == field(name)
            and facts.of(n).get("type") != "rigid"]
    return bool(facts.properties.get("contact")) or facts.of(name).get("volumeModel") == "grains" \
        or any(gap < facts.width for n in all_ for _, gap in _sides(facts, n).values()) \
        or any(checkStart.clamps(facts, n) for n in all_)


def _sides(facts, name):
    """Patches that prescribe something to the points of a phase: (type, gap from them [m])."""
    field = "0/U." + str(facts.of(name).get("velocityField", name))
    given = facts.conditions(field) if os.path.exists(facts.case.file(field)) else {}
    kinds = {p: str(of.get("type")) for p, of in given.items()
             if of.get("type") not in (*checkFluids.FREE, "empty", "wedge")}
    kinds.update({p: k for p, k in facts.patches.items() if k.startswith("symmetry")})
    x, phase = readField(facts.case.file("constant/polyMesh/points")), facts.phases[name]
    found = {}
    for patch, corners in patchPoints(facts.case, x, kinds).items():
        gap = np.maximum(0, np.maximum(phase.low - corners, corners - phase.high))[:, facts.axes]
        found[patch] = kinds[patch], float(np.sqrt((gap**2).sum(axis=1)).min())
    return found


# --- schemes -------------------------------------------------------------------

def _poisson(law):
    """Poisson number of a law; None: it has none."""
    def number(name):
        value = law.get(name)
        return value if isinstance(value, (int, float)) and value > 0 else None
    nu, E, G, K = (number(n) for n in ("nu", "E", "G", "K"))
    if number("c10"):                           # MooneyRivlin
        G = 2*(law["c10"] + (number("c01") or 0))
    if nu is not None:
        return nu
    if K and G:
        return (3*K - 2*G)/(6*K + 2*G)
    return E/(2*G) - 1 if E and G else None


def locking(facts):
    if facts.nDim < 2 or facts.shape == "nodeDual" \
            or facts.solution.get("dilatation", "point") == "cellMean":
        return
    plastic = [n for n, phase in facts.phases.items() if phase.law in PLASTIC and phase.n]
    if plastic:
        yield Finding("note", SOLUTION, "materialPoints.dilatation", f"plastic flow of "
                      f"{', '.join(plastic)} keeps its volume: with {facts.shape} and dilatation "
                      "point bending is too stiff, and pressures scatter",
                      "dilatation cellMean; after impact also pressureFilter 0.02",
                      "schemes.md#locking")
    for name, phase in facts.phases.items():
        nu = _poisson(facts.lawOf(name))
        if nu is not None and nu >= LOCKS and phase.law not in (*LIQUIDS, *PLASTIC):
            yield Finding("warning", SOLUTION, "materialPoints.dilatation", f"{name} is nearly "
                          f"incompressible (Poisson number {nu:.4g}): with {facts.shape} and "
                          "dilatation point its cells lock", "dilatation cellMean",
                          "schemes.md#locking")


def slowFlow(facts):
    co = facts.control.get("maxCoGas")
    if isinstance(co, (int, float)) and co > 0.6 and facts.of("fluids").get("lowMach", False):
        yield Finding("warning", CONTROL, "maxCoGas", f"{co:g} with lowMach: noise grows where the "
                      "flow is slow", "0.4, 0.6 at most", "fluids.md#several-fluids")


def courant(facts):
    co = facts.control.get("maxCo")
    if not facts.points or not isinstance(co, (int, float)):
        return
    if co > 0.5 and facts.shape != "nodeDual":
        yield Finding("warning", CONTROL, "maxCo", f"{co:g} with {facts.shape}", "0.3 to 0.5",
                      "schemes.md#what-to-choose")
    if facts.number("massFilter", 0) > 0 and facts.shape != "nodeDual" and co > 0.4:
        yield Finding("warning", CONTROL, "maxCo", f"{co:g} with massFilter and {facts.shape}",
                      "0.4 or less", "schemes.md#transfer")


def transfers(facts):
    if not facts.points:
        return
    if facts.transfer == "APIC" and facts.shape == "linear" \
            and facts.solution.get("affineMatrix") == "moment":
        yield Finding("warning", SOLUTION, "materialPoints.affineMatrix",
                      "moment blows up with linear", "affineMatrix gradient, or shapeFunction GIMP",
                      "schemes.md#transfer")
    if facts.update == "USL" and facts.shape == "linear":
        yield Finding("warning", SOLUTION, "materialPoints.stressUpdate",
                      "USL fails with linear where a node has little mass", "stressUpdate MUSL",
                      "schemes.md#stress-update")
    if facts.transfer in ("FMPM", "XPIC"):
        steps = facts.trial.steps if facts.trial else 0
        if steps > LONG:
            yield Finding("note", SOLUTION, "materialPoints.transfer", f"{facts.transfer} "
                          f"dissipates in each of about {steps} steps: smooth motion and rotation "
                          "die out", "FLIP for long elastic motion, APIC with affineMatrix moment "
                          "for rotation", "schemes.md#what-to-choose")
        if any(facts.of(n).get("type") == "fluid" and "equationOfState" in facts.of(n)
               for n in facts.media):
            yield Finding("note", SOLUTION, "materialPoints.transfer", f"{facts.transfer} needs "
                          "short steps for light bodies beside liquids", "FLIP or APIC with GIMP",
                          "fluids.md#states-that-a-step-would-not-leave")


def shapes(facts):
    given = facts.solution.get("shapeFunction")
    if not facts.points or given is None:
        return
    if facts.shape == "linear":
        better = "GIMP" if facts.lattice else "nodeDual"
        yield Finding("note", SOLUTION, "materialPoints.shapeFunction",
                      "linear is noisy as soon as points cross cells", better,
                      "schemes.md#shape-functions")
    if facts.shape == "nodeDual" and facts.lattice:
        yield Finding("note", SOLUTION, "materialPoints.shapeFunction", "nodeDual on boxes is less "
                      "accurate than GIMP", "GIMP", "schemes.md#shape-functions")


def shocks(facts):
    """Heat of strong shocks with FLIP wants a viscosity."""
    if facts.transfer != "FLIP":
        return
    fastest = max([p.U for p in facts.phases.values()], default=0)
    for name, phase in facts.phases.items():
        law = facts.lawOf(name)
        if "equationOfState" in law and "bulkViscosity" not in law and phase.speed \
                and fastest > 0.05*phase.speed:
            yield Finding("note", PHASES, f"{name}.constitutiveModel.bulkViscosity",
                          f"{fastest:g} m/s is a strong shock in {name} ({phase.speed:.4g} m/s), "
                          "and FLIP rings there", "bulkViscosity in the law", "materials.md")


def pointsInCells(facts):
    for name, phase in facts.phases.items():
        per = [r.get("pointsPerCell") for r in facts.regions.values()
               if isinstance(r, dict) and r.get("phase") == name]
        if facts.nDim > 1 and 1 in per and phase.law != "a rigid body":
            yield Finding("note", REGIONS, f"regions of {name}, pointsPerCell",
                          "1 point in a cell: bodies that stretch come apart early",
                          "pointsPerCell 2", "bodies.md")


def damage(facts):
    names = [n for n in facts.phases for failure in [facts.of(n).get("failureModel", {})]
             if isinstance(failure, dict) and "Gf" not in failure
             and str(failure.get("type")).startswith("maxPrincipal")]
    if names:
        yield Finding("note", PHASES, f"failureModel of {', '.join(names)}",
                      "without Gf the energy of cracks follows the width of the cells",
                      "Gf [J/m2] of the material", "materials.md#energy-of-failure")
    for name, phase in facts.phases.items():
        law, failure = facts.lawOf(name), facts.of(name).get("failureModel", {})
        given = [law.get("E"), *(failure.get(k) for k in ("Gf", "strength"))] if isinstance(
            failure, dict) else [None]
        if not phase.n or not all(isinstance(v, (int, float)) and v > 0 for v in given):
            continue
        E, Gf, strength = given
        size, length = max((phase.high - phase.low)[d] for d in facts.axes), E*Gf/strength**2
        if length > 2*size:
            yield Finding("note", PHASES, f"{name}.failureModel.Gf",
                          f"E Gf/strength^2 is {length:.2g} m, the phase {size:.2g} m large: it will"
                          " stretch rather than break", f"Gf {Gf*size/length:.1g} J/m2 or less, if"
                          " it is to be brittle", "materials.md#energy-of-failure")


def passThrough(facts):
    """Bodies with velocity fields of their own that no contact names: nothing acts between."""
    bodies = {}
    for name, phase in facts.phases.items():
        of = facts.of(name)
        if phase.n and (phase.speed or of.get("type") == "rigid"):
            bodies.setdefault(str(of.get("velocityField", name)), []).append(name)
    named = [c for c in facts.properties.get("contact", {}).values() if isinstance(c, dict)]
    if any("fields" not in c and "patch" not in c for c in named):
        return
    pairs = [{str(f) for f in c.get("fields", [])} for c in named if "patch" not in c]
    apart = [(a, b) for a, b in itertools.combinations(bodies, 2)
             if not any({a, b} <= pair for pair in pairs)]
    if apart:
        a, b = (bodies[field][0] for field in apart[0])
        yield Finding("note", PHASES, "contact", f"{a} and {b} have velocity fields of their own and"
                      " no contact: they pass through each other where they meet" + (
                          f" (so do {len(apart) - 1} other pairs)" if len(apart) > 1 else ""),
                      "contact { all { type Coulomb; mu 0.3; } }, or one velocityField for both",
                      "bodies.md#contact", "pass through each other")


def constraints(facts):
    """Conditions of points that a side of type empty, wedge or the like does not take."""
    kinds = set(CLOSED) - {"wall"}
    for field in dict.fromkeys(str(facts.of(n).get("velocityField", n)) for n in facts.phases):
        file = "0/U." + field
        if not os.path.exists(facts.case.file(file)):
            continue
        for patch, of in facts.conditions(file).items():
            kind = facts.patches.get(patch)
            if kind in kinds and of.get("type") not in (kind, None):
                yield Finding("warning", file, f"boundaryField.{patch}", f"{of['type']} does nothing"
                              f" at {patch}, a side of type {kind}", f"type {kind};",
                              "meshes.md#what-patches-need")


def writing(facts):
    interval = facts.control.get("writeInterval")
    inTime = facts.control.get("writeControl") in IN_TIME
    if isinstance(interval, (int, float)) and inTime and interval > facts.end*(1 + 1e-9):
        yield Finding("note", CONTROL, "writeInterval", f"{interval:g} s is longer than the run: "
                      "only its end is written", "a part of endTime", "output.md", "beyond endTime")


def much(facts):
    """Written times that are too many, or larger than what is free."""
    interval, kept = facts.control.get("writeInterval"), facts.control.get("purgeWrite", 0)
    trial, times = facts.trial, 0
    if trial:
        times = trial.writes
    elif facts.control.get("writeControl") in IN_TIME and isinstance(interval, (int, float)) \
            and interval > 0 and facts.end > 0:
        times = facts.end/interval
    if isinstance(kept, int) and kept > 0:
        times = min(times, kept)
    size = times*trial.written if trial else 0
    free = shutil.disk_usage(facts.disk).free
    what = f"{times:.0f} times are written" + (f", {size/1e9:.3g} GB" if trial else "")
    remedy = "a longer one, of some ten to some hundred times; endTime in s; or purgeWrite"
    if size > free:
        yield Finding("warning", CONTROL, "writeInterval", f"{what}, and {free/1e9:.3g} GB are "
                      f"free where the case is", remedy, "output.md")
    elif size > MUCH or times > MANY*(1 + 1e-6):
        yield Finding("note", CONTROL, "writeInterval", what, remedy, "output.md")


RULES = (densities, waveSpeeds, strengths, friction, grains, meshSize, gravity, pressure,
         duration, wavesLeave, *checkFluids.RULES, *checkStart.RULES, locking, slowFlow, courant,
         transfers, shapes, shocks, pointsInCells, damage, passThrough, constraints, writing, much)


def findings(facts):
    """Those of all rules."""
    return [f for rule in RULES for f in rule(facts)]
