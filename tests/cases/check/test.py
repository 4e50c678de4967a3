#!/usr/bin/env python3
"""mpmCheck: what it tells of cases before they run.

template    etc/caseTemplate: nothing found, exit code 0, nothing in the case is changed or new
told        masses, sides, cells across bodies, the smallest cell; a sound too low for the height of
            the water; files in binary
mistakes    one wrong unit or choice each in the template: found, with file and entry
leaks       water on a floor of type patch, to which setFluids gives zeroGradient, and without
            gravity: found; open sides beside it: not; sides that hold a body, not a rigid one
names       entries of fields that are no patch, patches without an entry, types misspelt: found
            with the nearest name; groups, patterns, conditions of other meshes: not
dropped     a block above water: p and velocity at the start; no p of the water's weight, no
            gravity, no stress, floors of no condition, steps, gauges: found, and where not
start       setFields before setMaterialPoints, regions of setFields without cells, bodies in a vessel,
            thin beside a clamp, short of it, held by nothing; probes away, too many times, mm
codes       exit codes of the command: 0, 1, 2; 2 with the solver's own words
trial       steps foretold of three cases against those of the run: within 30 %; memory; two ranks
tutorials   all tutorials: the warnings are those listed here with what is true of them
"""

import glob
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
from checkCases import (CONTROL, MESH, PHASES, REGIONS, SOLUTION, TEMPLATE, basin, found,
                        toldOf)
from foamCase import PROJECT, FoamCase, runParts
from mpm.check import Check, _place, write
from mpm.checkFinding import Finding
from mpm.trial import Trial
from startRows import start

#: What is set in the template: a word of the finding, its file
MISTAKES = {
    "E in MPa": ([(PHASES, "target.E", 70e3)], "wave speed", PHASES),
    "E in GPa": ([(PHASES, "flyer.E", 210)], "wave speed", PHASES),
    "density in g/cm3": ([(PHASES, "flyer.rho", 7.8)], "wave speed", PHASES),
    "density in t/mm3": ([(PHASES, "flyer.rho", 7.8e-9)], "kg/m3", PHASES),
    "density in mg/m3": ([(PHASES, "flyer.rho", 7.8e6)], "density", PHASES),
    "strength in MPa": ([(PHASES, "target.strength", 400)], "that weak", PHASES),
    "strength above E": ([(PHASES, "target.strength", 400e9)], "above the modulus", PHASES),
    "mesh in km": ([(MESH, "scale", 1e3), (REGIONS, "target.max", (2e4, 1e4, 1)),
                    (REGIONS, "target.min", (-2e4, 0, 0)), (REGIONS, "flyer.min", (-5e3, 11e3, 0)),
                    (REGIONS, "flyer.max", (5e3, 2e4, 0))], "the mesh is", MESH),
    "mesh in mm, shapes in m": ([(MESH, "scale", 1)], "wide in", REGIONS),
    "mesh and shapes in mm": ([
        (MESH, "scale", 1), (REGIONS, "target.min", (-20, 0, 0)),
        (REGIONS, "target.max", (20, 10, 1)), (REGIONS, "flyer.min", (-5, 10.1, 0)),
        (REGIONS, "flyer.max", (5, 20.1, 1))],
        "nothing can happen", CONTROL),
    "endTime in us": ([(CONTROL, "endTime", 500.0)], "1e7 steps", CONTROL),
    "gravity in mm/s2": ([("constant/g", "value", (0, -9810, 0))], "m/s2", "constant/g"),
    "gravity in km/s2": ([("constant/g", "value", (0, -9.81e-3, 0))], "m/s2", "constant/g"),
    "velocity in mm/s": ([(REGIONS, "flyer.velocity", (0, -50e3, 0))], "wave speed", REGIONS),
    "nearly incompressible": ([(PHASES, "target.nu", 0.499)], "incompressible", SOLUTION),
    "rubber": ([(PHASES, "flyer.constitutiveModel", {
        "type": "MooneyRivlin", "rho": 1000.0, "c10": 1e6, "c01": 1e5, "K": 1e9})],
        "incompressible", SOLUTION),
    "angle in radians": ([(PHASES, "target.constitutiveModel", {
        "type": "DruckerPrager", "rho": 1600, "E": 1e7, "nu": 0.3, "frictionAngle": 0.576,
        "cohesion": 0, "dilationAngle": 0, "match": "planeStrain"})],
        "hardly any friction", PHASES),
    "sand in g/cm3": ([("constant/g", "value", (0, -9.81, 0)), (PHASES, "target.constitutiveModel", {
        "type": "DruckerPrager", "rho": 2.65, "E": 1e7, "nu": 0.3, "frictionAngle": 33,
        "cohesion": 0, "dilationAngle": 0, "match": "planeStrain"})], "cork has 120", PHASES),
    "grains without room": ([(PHASES, "target.volumeModel", "grains", True)], "no room", REGIONS),
    "slip on a side of type empty": ([("0/U.target", "boundaryField.frontAndBack.type", "slip")],
                                     "slip does nothing", "0/U.target"),
    "maxCo": ([(CONTROL, "maxCo", 0.8)], "0.8 with GIMP", CONTROL),
    "moment with linear": ([(SOLUTION, "materialPoints", {
        "shapeFunction": "linear", "transfer": "APIC", "affineMatrix": "moment"})], "blows up",
        SOLUTION)}

#: Tutorials that need a step of their own before mpmCheck can read them, and words of it
UNMADE = {"bracket": "no mesh", "brazilianDisc": "no file", "connectingRod": "no such file",
          "cylinderInChannel": "patch", "freePiston": "U.air", "halfCylinder": "no file",
          "hourglass": "patch", "spallOnTriangles": "no mesh", "sphereOnSphere": "no mesh"}
#: Warnings that are true of tutorials, on purpose there
TRUE = {"adaptiveImpact": ["reaches beyond the mesh"],       # a target longer than the mesh
        "refinedImpact": ["reaches beyond the mesh"],
        "shockOnSlab/wedge": ["reaches beyond the mesh"],
        "projectile": ["has no points"],                     # debris to come
        "fluidisedColumn": ["that weak"],                    # grains that hold nothing
        "twoDisks": ["a wave speed of 1.16 m/s"]*2}          # without units


def state(folder):
    """Every file of a folder with its time and contents."""
    made = hashlib.sha256()
    for root, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            path = os.path.join(root, name)
            made.update(f"{path} {os.stat(path).st_mtime_ns}".encode())
            with open(path, "rb") as f:
                made.update(f.read())
    return made.hexdigest()


def template(table):
    before = state(TEMPLATE)
    check = Check(TEMPLATE)
    table.row("template: exit code", 0, check.run(), 0)
    table.check("template: no findings, no notes", not check.findings, found(check))
    table.check("template: the case is as it was", state(TEMPLATE) == before)
    said = dict(check.lines)
    table.check("template: points in a cell", "4 to 4, mean 4" in said["target"], said["target"])
    table.check("template: what sets the time step", "points of target" in said["time step"],
                said["time step"])


def told(table):
    check = Check(TEMPLATE, trial=False)
    check.run()
    said = "\n".join(f"{n}: {text}" for n, text in check.lines)
    for words in ("mesh: 2400 cells, 2D, 0.06 x 0.04 m, 0.001 m thick",
                  "patches: outside: patch, U.target calculated, U.flyer calculated",
                  # 40 x 10 x 1 mm of 2700 kg/m3, of cells of 1 mm
                  "linearElastic, mass 0.00108 kg",
                  "target: 10 cells across the thinnest side, 0.01 m"):
        table.check(f"told: {words}", words in said, "" if words in said else said.splitlines())
    table.check("told: equal cells have no smallest", "smallest" not in said)

    # Cells of 3 x 1 mm, a target 10 mm high
    case = FoamCase("check", "flat", TEMPLATE)
    case.change(MESH, r"\(60 40 1\) simple", "(20 40 1) simple")
    check = Check(case.path, trial=False)
    check.run()
    said = "\n".join(text for _, text in check.lines)
    across = re.search(r"target: (\S+) cells across", said)
    table.row("told: cells across, of 3 x 1 mm", 10, float(across[1]), 1e-9)

    # A slab of 4 x 18 mm that is turned by 30 degrees: 13 mm high, on cells of 1 mm
    case = FoamCase("check", "turned", TEMPLATE)
    case.set(REGIONS, "regions.target", {
        "phase": "target", "type": "cylinder", "radius": 0.002, "pointsPerCell": 2,
        "point1": (-0.009*3**0.5/2, 0.001, 0.0005), "point2": (0.009*3**0.5/2, 0.010, 0.0005)})
    for corner, value in (("min", (0.02, 0.012, 0)), ("max", (0.025, 0.02, 0.001))):
        case.set(REGIONS, "regions.flyer." + corner, value)
    check = Check(case.path, trial=False)
    check.run()
    said = "\n".join(text for _, text in check.lines)
    across = re.search(r"target: (\S+) cells across the thinnest side of its points,", said)
    table.row("told: cells across a turned slab", 4, float(across[1]) if across else 0, 0.1,
              "relative")

    # A row of cells 8 times as long at one end as at the other, 1 mm high: lengths are a
    # geometric series of 60 over 60 mm
    case = FoamCase("check", "graded", TEMPLATE)
    case.change(MESH, r"simpleGrading \(1 1 1\)", "simpleGrading (8 1 1)")
    check = Check(case.path, trial=False)
    check.run()
    cell = re.search(r"smallest cell (\S+) m at \((\S+) \S+ \S+\), mean \S+ m, largest (\S+) m",
                      "\n".join(text for _, text in check.lines))
    q = 8**(1/59)
    dx = 60e-3*(q - 1)/(q**60 - 1)
    for name, value, exact in (("smallest cell, width [m]", cell[1], (dx*1e-3)**0.5),
                               ("its place along x [m]", cell[2], -30e-3 + dx/2),
                               ("largest cell, width [m]", cell[3], (8*dx*1e-3)**0.5)):
        table.row(f"told: {name}", exact, float(value), 6e-3, "relative")    # three digits

    # A rod of 25.4 mm and 3.81 mm radius about the axis, on a wedge: as box and as cylinder
    for kind, shape in (("box", {}), ("cylinder", {
            "point1": (0, 0, 0), "point2": (25.4e-3, 0, 0), "radius": 3.81e-3})):
        case = FoamCase("check", "wedge", os.path.join(PROJECT, "tutorials/taylorBar"))
        if shape:
            case.set(REGIONS, "regions.bar", {"phase": "bar", "type": kind, **shape,
                                              "pointsPerCell": 2, "velocity": (-190, 0, 0)})
        check = Check(case.path, trial=False)
        check.run()
        said = "\n".join(text for _, text in check.lines)
        across = re.search(r"bar: \S+ cells across the thinnest side.*, (\S+) m", said)
        table.row(f"told: radius of a {kind} on a wedge [m]", 3.81e-3,
                  float(across[1]) if across else 0, 1e-3, "relative")

    case = FoamCase("check", "told", os.path.join(PROJECT, "tutorials/damBreak"))
    case.set(CONTROL, "writeFormat", "binary")
    height = 0.292
    for factor in (1.05, 0.95):
        c = factor*10*(2*9.81*height)**0.5
        case.set(PHASES, "water.equationOfState", {
            "type": "stiffenedGas", "gamma": 4.4, "soundSpeed": c, "p0": 1e5})
        check = Check(case.path, trial=False)
        code = check.run()
        hits = [f.entry for f in check.findings if "is not ten times" in f.text]
        table.check(f"told: sound of water {factor} of ten times sqrt(2 g H)",
                    code == (1 if factor < 1 else 0)
                    and hits == (["water.equationOfState.soundSpeed"] if factor < 1 else []),
                    found(check))
    said = "\n".join(f"{n}: {text}" for n, text in check.lines)
    mass = re.search(r"^water: .* mass (\S+) kg", said, re.M)
    table.row("told: mass of water of binary files [kg]", 0.146*height*0.01*1000,
              float(mass[1]), 1e-3, "relative")
    table.check("told: sides of binary files", "walls: wall, U slip, p zeroGradient" in said)


def mistakes(table):
    for Gf, much in ((1e4, False), (1e7, True)):
        case = FoamCase("check", f"Gf-{Gf:g}", TEMPLATE)
        case.set("constant/phaseProperties", "target.failureModel.Gf", Gf)
        check = Check(case.path, trial=False)
        check.run()
        said = [f.text for f in check.findings if "stretch rather than break" in f.text]
        table.check(f"mistakes: Gf {Gf:g}, {'larger than the body bears' if much else 'fits'}",
                    bool(said) == much, said)
    for weight in (9.81, -9.81):
        case = FoamCase("check", f"g_{weight:g}", TEMPLATE)
        case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, weight, 0)},
                   "uniformDimensionedVectorField")
        check = Check(case.path, trial=False)
        check.run()
        hits = [f for f in check.findings if "fall towards larger y" in f.text]
        table.check(f"mistakes: gravity (0 {weight:g} 0), {'a note' if weight > 0 else 'none'}",
                    [f.kind for f in hits] == ["note"]*(weight > 0), found(check))
    for name, (changes, word, file) in MISTAKES.items():
        case = FoamCase("check", re.sub(r"\W", "-", name), TEMPLATE)
        if changes[0][0] == "constant/g":
            case.write("constant/g", {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, -9.81, 0)},
                       "uniformDimensionedVectorField")
        for change in changes:
            case.set(*change[:3], add=len(change) > 3)
        check = Check(case.path, trial=False)
        code = check.run()
        hits = [f for f in check.findings if f.kind != "note" and word in f.text and f.file == file]
        table.check(f"mistakes: {name}", code > 0 and hits,
                    (hits[0].text if hits else str(found(check)))[:110])
        if name == "mesh in mm, shapes in m":
            table.check("mistakes: with the remedy of the guide",
                        "wrong unit of the shape" in hits[0].remedy, hits[0].remedy)


def leaks(table):
    """damBreak, whose walls are a side for each direction: as they are and as patches."""
    case = FoamCase("check", "leaks", os.path.join(PROJECT, "tutorials/damBreak"))
    case.change(MESH, r"(?s)    walls\n.*?    \}\n", """
    floor { type wall; faces ((0 1 5 4)); }
    left  { type wall; faces ((0 4 7 3)); }
    rest  { type wall; faces ((1 2 6 5) (3 7 6 2)); }
""")
    for kind, expected in (("wall", []), ("patch", [("warning", "floor"), ("note", "left")])):
        case.change(MESH, r"type\s+(wall|patch);", f"type {kind};")
        check = Check(case.path, trial=False)
        check.run()
        hits = [(f.kind, f.entry.split(".")[-1]) for f in check.findings if " out: " in f.text]
        table.check(f"leaks: water beside sides of type {kind}", hits == expected, found(check))

    out(table)
    open_(table)
    # A rigid body by walls of fixedValue, and what it holds
    case = FoamCase("check", "rigid", os.path.join(PROJECT, "tutorials/damBreakGate"))
    case.set("0.orig/U.solids", "boundaryField.walls",
             {"type": "fixedValue", "value": "uniform (0 0 0)"})
    check = Check(case.path, trial=False)
    check.run()
    said = dict(check.lines)
    table.check("leaks: nothing holds a rigid body", "walls" in said["gate"]
                and "walls" not in said["wall"], f"{said['gate']} | {said['wall']}")

    # A bar that is clamped at its end, and 2 m off it
    case = FoamCase("check", "clamped", os.path.join(PROJECT, "tutorials/vibratingBar"))
    for low, words in ((0, "; held by wall"), (2, "; wall, which would hold it, is 2.")):
        case.set(REGIONS, "bar.min", (low, 0, 0))
        check = Check(case.path, trial=False)
        check.run()
        said = dict(check.lines)["bar"]
        table.check(f"leaks: what holds a body, {low} m off the wall", words in said, said)


def out(table):
    """Sides of the basin: slip, zeroGradient, farField; with and without gravity."""
    far = "farField; farValue uniform (0 0 0); value uniform (0 0 0);"
    for weight in (True, False):
        kind = "warning" if weight else "note"
        for condition, expected in (("slip;", []), ("zeroGradient;", [
                ("note", "sides"), (kind, "floor")]), (far, [(kind, "floor")] if weight else [])):
            case = basin("out")
            case.change("0.orig/U", r"(floor\"\n *\{\n *type *)slip;", rf"\1{condition}")
            if condition == far:
                case.change("0.orig/p", r"zeroGradient;", "farField; farValue uniform 1e4; "
                            "value uniform 1e4;")
            if not weight:
                case.change("system/setFluidsDict", "^hydrostatic.*", "")
                case.set("system/setFluidsDict", "default.p", 1e4, add=True)
                os.remove(case.file("constant/g"))
            check = Check(case.path, trial=False)
            check.run()
            hits = [(f.kind, f.entry.split(".")[-1]) for f in check.findings
                    if " out: " in f.text]
            table.check(f"leaks: walls of {condition.split(';')[0]}, "
                        f"{'' if weight else 'no '}gravity", sorted(hits) == sorted(expected),
                        found(check))


def open_(table):
    """The basin's top: farField, and what setFluids gives without 0.orig; tank filled to the top
    by a pool in mm."""
    for given in (True, False):
        case = basin("top")
        if not given:
            os.remove(case.file("0.orig/U"))
            os.remove(case.file("0.orig/p"))
        hits, check = toldOf(case, "nothing holds the pressure at top")
        table.check(f"open: top {'of farField' if given else 'without files'}",
                    hits == [("warning", "0/p")]*(not given), found(check))
    case = basin("full")
    case.set("system/setFluidsDict", "regions.column.max", (1000, 100, 1))
    hits, check = toldOf(case, "air, which is to be in what no region fills, is nowhere")
    table.check("open: pool in mm", hits == [("warning", "system/setFluidsDict")], found(check))


def heavyAbove(table):
    """A liquid on a lighter and on a heavier one."""
    for rho, told in ((1100.0, True), (900.0, False)):
        case = basin("oil")
        case.set(PHASES, "phases", "(water oil air obstacle)")
        case.set(PHASES, "oil", {"type": "fluid", "rho": rho, "equationOfState": {
            "type": "stiffenedGas", "gamma": 1.12, "soundSpeed": 35, "p0": 1e4}}, add=True)
        case.set("system/setFluidsDict", "regions.layer", {
            "type": "box", "min": (-1, 0.1, -1), "max": (1, 0.15, 1), "fluid": "oil"}, add=True)
        hits, check = toldOf(case, "lies above water")
        table.check(f"dropped: oil of {rho:g} kg/m3 on water", hits == [("note", PHASES)]*told,
                    found(check))


def sticking(table):
    """A body that takes water along (tests/cases/lightInWater)."""
    for drag, told in (("", True), ("normal", False)):
        case = basin("sticking")
        if not drag:
            case.change(PHASES, r"drag +\{ type stick; direction normal; \}", "")
        hits, check = toldOf(case, "takes along what is within a cell")
        table.check(f"dropped: drag {drag or 'none given'}", hits == [("note", PHASES)]*told,
                    found(check))


def names(table):
    field = "0.orig/U.solids"

    def of(name, *changes, file=field):
        case = basin(name)
        for change in changes:
            case.change(file, *change)
        check = Check(case.path, trial=False)
        return check.run(), check.findings, found(check)

    code, findings, said = of("flor", (r"^ *floor", "    flor"))
    table.check("names: flor for floor", code == 2 and len(findings) == 1
                and findings[0].file == field and findings[0].entry == "boundaryField.flor"
                and "no patch flor (nearest: floor); floor of the mesh has no entry" in said[0]
                and "its patches: sides, floor, top, frontAndBack" in said[0]
                and findings[0].remedy == "floor in place of flor", said)
    code, findings, said = of("bare", (r"sides\|top", "top"))
    table.check("names: a patch without an entry", code == 2 and len(findings) == 1
                and "sides of the mesh has no entry" in said[0], said)
    both = (r"sides\|top", ".*"), (r"^ *floor", "    flor")
    code, findings, said = of("misspelt", *both)
    table.check("names: misspelt beside a pattern for all", code == 1
                and "nearest: floor" in " ".join(said), said)
    code, findings, said = of("foreign", both[0], (
        r"^ *floor", "    hole { type slip; }\n    floor"))
    table.check("names: one of another mesh beside a pattern for all", code == 0, said)
    code, findings, said = of("groups", (
        r"(?s)boundaryField.*", "boundaryField\n{\n    #includeEtc "
        "\"caseDicts/setConstraintTypes\"\n    wall { type slip; }\n    \"to.*\" "
        "{ type calculated; }\n}\n"))
    table.check("names: groups, patterns, setConstraintTypes", code == 0, said)
    code, findings, said = of("contactt", (r"\Z", "\ncontactt { }\n"), file=PHASES)
    table.check("names: contactt for contact", code == 2 and "is contact meant?" in said[0], said)
    code, findings, said = of("farfield", (r"farField;", "farfield;"), file="0.orig/p")
    word = re.search(r"type farfield [^.]*?; nearest: (\w+)", " ".join(said))
    table.check("names: the nearest type first", code == 2 and word and word[1] == "farField",
                said[0][:150])


def dropped(table):
    case = basin("dropped")
    hits, check = toldOf(case, "")
    table.check("dropped: nothing found as it should be", not hits, found(check))
    said = dict(check.lines)["start"]
    table.check("dropped: gravity and velocity", said.startswith("gravity (0 -9.81 0), p ")
                and said.endswith("Pa, obstacle at (0 -1 0) m/s"), said)
    width = 0.3514/71
    for name, value, exact in zip(("least", "largest"), re.findall(r"(\d+) (?:to|Pa)", said), (
            1e4, 1e4 + 1.2*9.81*(0.34 - 0.1) + 1000*9.81*(0.1 - width/2))):
        table.row(f"dropped: {name} p at the start [Pa]", exact, float(value), 1e-3, "relative")

    atRest(table)
    around(table)
    floors(table)
    steps(table)
    gauges(table)
    programs(table)
    shaking(table)
    slow(table)
    dissipating(table)
    sticking(table)
    heavyAbove(table)
    gaps(table)


def shaking(table):
    """FLIP without PIC keeps what shakes a body in water."""
    for name, fraction, exact in (("FLIP alone", 0.001, [("note", SOLUTION)]),
                                  ("FLIP with PIC", 0.01, []), ("APIC", None, [])):
        case = basin("shaking")
        if fraction is None:
            case.change(SOLUTION, "transfer +FLIP;", "transfer APIC;")
            case.change(SOLUTION, "PICfraction .*;", "")
        else:
            case.set(SOLUTION, "materialPoints.PICfraction", fraction)
        hits, check = toldOf(case, "")
        table.check(f"dropped: {name}", hits == exact
                    and (not exact or "obstacle may shake where it lies in water" in
                         check.findings[0].text), found(check))


def gaps(table):
    """Two bodies with a part of a cell between them, 2 cells, none; drag across faces alone;
    with velocity fields of their own, and no contact."""
    h = 0.3514/71
    for cells, drag, own in ((0.5, "all", False), (2, "all", False), (0, "all", False),
                             (0.5, "normal", False), (0.5, "all", True)):
        case = basin("gap")
        if own:
            case.set(PHASES, "phases", "(water air obstacle other)")
            with open(case.file(PHASES), "a") as f:
                f.write("other { $obstacle; velocityField other; }\n")
            shutil.copy(case.file("0.orig/U.solids"), case.file("0.orig/U.other"))
        case.set(PHASES, "obstacle.drag", {"type": "stick", "direction": drag}, add=True)
        low = 0.24 + cells*h
        case.set(REGIONS, "regions.second", {
            "phase": "other" if own else "obstacle", "type": "box", "min": (low, 0.2, 0),
            "max": (low + 0.04, 0.24, 0.005), "velocity": (0, -1, 0), "pointsPerCell": 2,
            "stress": "ambient", "pressure": 1e4}, add=True)
        hits, check = toldOf(case, "their drag holds what is between")
        name = f"{cells:g} cells away, drag {drag}" + (", fields of their own" if own else "")
        table.check(f"dropped: a second body beside it, {name}", hits == [("note", REGIONS)]*(
            cells == 0.5 and drag == "all" and not own), found(check))
        apart = [f for f in check.findings if "pass through each other" in f.text]
        table.check(f"dropped: {name}: bodies without contact", len(apart) == own, found(check))


def slow(table):
    """Noise that lowMach leaves above maxCoGas 0.6, as tests/cases/fluidsAlone measures it."""
    for Co, expected in ((0.8, [("warning", CONTROL)]), (0.6, [])):
        case = basin("slow")
        case.set(PHASES, "fluids.lowMach", "yes")
        case.set(CONTROL, "maxCoGas", Co)
        hits, check = toldOf(case, "noise grows")
        table.check(f"dropped: lowMach with maxCoGas {Co}", hits == expected, found(check))


def dissipating(table):
    """What lowMach leaves beside a body, as tests/cases/lightInWater measures it, and what waves
    lose without it (tests/cases/flowOutput)."""
    for word in ("yes", "no"):
        case = FoamCase("check", "waves", os.path.join(PROJECT, "tutorials/damBreak"))
        case.set(PHASES, "fluids.lowMach", word)
        hits, check = toldOf(case, "waves of water die out")
        table.check(f"damBreak, lowMach {word}: waves", hits == [("note", PHASES)]*(word == "no"),
                    found(check))
    for word, exact in (("yes", "yes: obstacle may move less"), ("solids", ""), ("no", "no: obst")):
        case = basin("dissipating")
        case.set(PHASES, "fluids.lowMach", word)
        hits, check = toldOf(case, "may move less than it should")
        table.check(f"dropped: lowMach {word}", hits == [("note", PHASES)]*bool(exact) and (
            not exact or check.findings[0].text.startswith(exact)), found(check))


def atRest(table):
    case = basin("noHydrostatic")
    case.change("system/setFluidsDict", "^hydrostatic.*", "")
    case.set("system/setFluidsDict", "default.p", 1e4, add=True)
    hits, check = toldOf(case, "the same p above and below")
    table.check("dropped: no hydrostatic", hits == [("warning", "system/setFluidsDict")]
                and any("hydrostatic { point" in f.remedy for f in check.findings), found(check))
    ring = re.search(r"2 rho g H = (\d+) Pa", " ".join(found(check)))
    table.row("dropped: 2 rho g H [Pa]", 2*1000*9.81*0.1, float(ring[1]) if ring else 0, 0.05,
              "relative")        # H in whole cells
    os.remove(case.file("constant/g"))
    hits, check = toldOf(case, "there is no gravity")
    table.check("dropped: no gravity", hits == [("warning", "constant/g")] and check.run() == 1
                and dict(check.lines)["start"].startswith("no gravity, p 10000 Pa"), found(check))
    none = {"dimensions": "[0 1 -2 0 0 0 0]", "value": (0, 0, 0)}
    case.write("constant/g", none, "uniformDimensionedVectorField")
    hits, check = toldOf(case, "there is no gravity")
    table.check("dropped: no gravity, which constant/g says", hits == [("note", "constant/g")],
                found(check))
    os.remove(case.file("constant/g"))
    case.set(CONTROL, "endTime", 0.01)        # it would fall by 0.5 mm
    hits, check = toldOf(case, "there is no gravity")
    table.check("dropped: no gravity, too short for it", not hits, found(check))


def around(table):
    case = basin("noStress")
    case.change(REGIONS, " *(stress|pressure) .*\n", "")
    hits, check = toldOf(case, "lies in air, whose p is 100")
    table.check("dropped: no stress, in air of 1e4 Pa", hits == [("warning", REGIONS)] and any(
        re.search(r"referencePressure 100\d\d;", f.remedy) for f in check.findings), found(check))
    case.set(REGIONS, "regions.obstacle.min", (0.2, 0.02, 0))
    case.set(REGIONS, "regions.obstacle.max", (0.24, 0.06, 0.005))
    hits, check = toldOf(case, "lies in water, whose p is 10")
    table.check("dropped: no stress, in water", len(hits) == 1, found(check))


def floors(table):
    case = basin("floors")
    case.change("0.orig/U.solids", "slip;", "calculated;")
    hits, check = toldOf(case, "obstacle may get to floor")
    table.check("dropped: nothing on the floor", hits == [("note", "0/U.solids")], found(check))
    # From 0.2 m with 1 m/s down, less half a cell
    time = re.search(r"floor from (\S+) s", " ".join(found(check)))
    table.row("dropped: time of the fall [s]", ((1 + 2*9.81*0.2)**0.5 - 1)/9.81,
              float(time[1]) if time else 0, 0.05, "relative")
    case.set(PHASES, "contact", {"floor": {"type": "frictionless", "fields": ["solids"],
                                           "patch": "floor"}}, add=True)
    hits, check = toldOf(case, "may get to")
    table.check("dropped: contact with the floor", not hits, found(check))
    case = basin("upwards")
    case.change("0.orig/U.solids", "slip;", "calculated;")
    case.set(REGIONS, "regions.obstacle.velocity", (0, 1, 0))
    case.set(CONTROL, "endTime", 0.2)         # it is back at its place then
    hits, check = toldOf(case, "may get to")
    table.check("dropped: thrown up", not hits, found(check))


def steps(table):
    case = basin("stiff")
    case.set(PHASES, "obstacle.E", 1e10)
    word = "obstacle sets the step"
    for name, options in (("without a trial", {}), ("after a trial", {"trial": True, "steps": 5})):
        hits, check = toldOf(case, word, **options)
        table.check(f"dropped: stiff, {name}", hits == [("note", CONTROL)] and any(
            f.remedy.startswith("maxSubSteps 10") for f in check.findings), found(check))
    read = Trial.read

    def byPoint(trial):
        read(trial)
        trial.setBy = "point 7 of obstacle: sound 3162 m/s in 2 mm"
    Trial.read = byPoint
    try:
        hits, check = toldOf(case, word, trial=True, steps=5)
    finally:
        Trial.read = read
    table.check("dropped: stiff, one deformed point sets the step", hits == [("note", CONTROL)],
                found(check))
    case.set(CONTROL, "maxSubSteps", 10, add=True)
    hits, check = toldOf(case, word)
    table.check("dropped: stiff, with maxSubSteps", not hits, found(check))
    # Step of steel with E 2e11 and 10 sub-steps: ten times that of sound in a cell, by hand
    case.set(PHASES, "obstacle.E", 2e11)
    hits, check = toldOf(case, word, trial=True, steps=5)
    table.check("dropped: stiff, with too few sub-steps", hits == [("note", CONTROL)] and any(
        "with maxSubSteps 10; water" in f.text and "100 at most" in f.remedy
        and "type rigid; motion { type free; }" in f.remedy for f in check.findings), found(check))
    bear = re.search(r"would bear (\S+) s", " ".join(found(check)))
    softer = re.search(r"or a softer E, (\S+) Pa", " ".join(f.remedy for f in check.findings))
    case.set(PHASES, "obstacle.E", 0.8*float(softer[1]) if softer else 2e11)
    hits, check = toldOf(case, "", trial=True, steps=5)
    said = dict(check.lines).get("time step", "")
    table.check("dropped: with the softer E the fluids set the step", softer
                and "points" not in said, said)
    table.row("dropped: step that the fluids bear, over what they then take", 1,
              float(bear[1])/float(said.split()[0]) if bear and said else 0, 0.1)


def programs(table):
    """What programs say: line, lists, file, without what follows from it."""
    case = basin("line")
    case.change(PHASES, r"\}\s*$", "")
    with open(case.file(PHASES), "a") as f:
        f.write("other\n{\n")
    hits, check = toldOf(case, "Unexpected EOF")
    table.check("programs: the line of an error of OpenFOAM",
                re.search(r"stops at line \d+: Unexpected EOF", " ".join(found(check))),
                found(check))
    case = basin("zone")
    case.write("system/setFieldsDict", {
        "defaultFieldValues": "( volScalarFieldValue p 20 )",
        "regions": "( zoneToCell { zone nowhere; fieldValues ( volScalarFieldValue p 20 ); } )"})
    hits, check = toldOf(case, "Cannot find any cellZone")
    table.check("programs: a zone of setFields that is not there, file and names",
                hits == [("warning", "system/setFieldsDict")] and re.search(
                    r"Valid names: 0?\(\)", " ".join(found(check))), found(check))
    case.set("system/setFluidsDict", "default.T", 300)
    hits, check = toldOf(case, "20 Pa at")
    table.check("programs: a pressure in bar, the file that it is from",
                hits == [("warning", "system/setFieldsDict")], found(check))
    case = basin("libs")
    case.set(CONTROL, "libs", ["mpmFunctionObject"], add=True)
    hits, check = toldOf(case, "Could not load")
    table.check("programs: a library that is not there", hits and all(
        h == ("warning", CONTROL) for h in hits) and any(
            "mpmFunctionObjects" in f.remedy for f in check.findings), found(check))
    case = basin("functions")
    case.set(CONTROL, "functions.walls", {"type": "forcess", "libs": ["forces"]}, add=True)
    check = Check(case.path)
    check.run()
    said = [f.text for f in check.findings if (f.kind, f.file) == ("warning", CONTROL)]
    table.check("programs: a type of function object that OpenFOAM has not, the nearest",
                len(said) == 1 and said[0].startswith(
                    "Unknown function type forcess; nearest: forces"), found(check))
    case = basin("thick")
    case.change("system/blockMeshDict", r"\bempty\b", "patch")
    for name in os.listdir(case.file("0.orig")):
        case.change("0.orig/" + name, r"\bempty\b", "calculated")
    case.set(REGIONS, "regions.obstacle.max", (0.24, 0.24, 1))
    hits, check = toldOf(case, "is one layer of cells thick")
    table.check("programs: no empty patches, and not that boxes are deeper", len(hits) == 1
                and "reaches beyond the mesh" not in " ".join(found(check)), found(check))


def gauges(table):
    case = basin("gauges")
    case.set(CONTROL, "functions.gauges", {
        "type": "blastProbes", "libs": ["mpmFunctionObjects"],
        "probeLocations": [(0.22, 0.01, 0.0025)]}, add=True)
    hits, check = toldOf(case, "measures pressures in water softened to 35 m/s")
    table.check("dropped: gauges in softened water", hits == [("note", CONTROL)]
                and "35000 Pa for 1 m/s" in " ".join(found(check)), found(check))
    period = re.search(r"4 H/c = (\S+) s", " ".join(found(check)))
    table.row("dropped: period 4 H/c [s]", 4*0.1/35, float(period[1]) if period else 0, 0.06,
              "relative")        # two digits, H in whole cells
    case.set(PHASES, "water.soundSpeed", 1482)
    hits, check = toldOf(case, "measures pressures")
    table.check("dropped: gauges in water of its own sound", not hits, found(check))


def command(case, *options):
    run = subprocess.run([os.path.join(PROJECT, "etc/bin/mpmCheck"), case, *options], timeout=120,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return run.returncode, run.stdout.decode()


def codes(table):
    code, said = command(TEMPLATE, "-noTrial")
    table.check("codes: 0 where nothing is found", code == 0 and "Nothing found." in said, code)
    case = FoamCase("check", "codes", TEMPLATE)
    case.set(PHASES, "target.nu", 0.499)
    before = state(case.path)
    code, said = command(case.path, "-noTrial")
    table.check("codes: 1 with a warning", code == 1 and "warning: system/fvSolution" in said
                and "see doc/guide/schemes.md#locking" in said, code)
    case.set(PHASES, "target.E", -7e10)
    code, said = command(case.path)
    table.check("codes: 2 with the solver's words", code == 2
                and "target.constitutiveModel" in said and "must be greater than 0" in said, code)
    table.check("codes: places of entries as v1912 and as v2506 write them", all(
        _place(sign.join((file, "target", "E"))) == (file, "target.E")
        for sign in "./" for file in (PHASES, CONTROL)), "")
    case.set(PHASES, "target.E", 7e10)
    case.set(CONTROL, "maxCo", 3)       # read with the first step only
    code, said = command(case.path)
    table.check("codes: 2 with what the trial finds", code == 2
                and "Entry maxCo is 3" in said, code)
    code, said = command("-h")
    table.check("codes: -h says what -noTrial leaves out", code == 0
                and "no function objects" in " ".join(said.split()), code)
    code, said = command(case.file("system"))
    table.check("codes: 2 where there is no case", code == 2 and "is no case" in said,
                " ".join(said.split())[-60:])
    # What OpenFOAM itself says has a remedy and a page too
    for file, words in ((None, "cannot find file"), ("lawz", "Cannot open include file")):
        lacking = FoamCase("check", "lacking", case.path)
        if file:
            lacking.change(PHASES, "^phases", f'#include "{file}"\nphases')
        else:
            os.remove(lacking.file("system/fvSchemes"))
        code, said = command(lacking.path, "-noTrial")
        table.check(f"codes: 2 for {words}", code == 2 and words in said and "    do: " in said
                    and "troubleshooting.md#mesh-and-start-of-a-run" in said,
                    " ".join(said.split())[-60:])
    lacking = FoamCase("check", "lacking", TEMPLATE)
    lacking.change(PHASES, r" nu 0\.33;", "")
    code, said = command(lacking.path, "-noTrial")
    table.check("codes: the meaning of an entry that is missing",
                "do: nu: Poisson" in said, " ".join(said.split())[-90:])
    told = []
    for kinds in (("warning", "error"), ("note", "error")):
        check, out = Check(TEMPLATE, trial=False), io.StringIO()
        check.findings = [Finding(kind, "", "", kind, "") for kind in kinds]
        write(check, out)
        told.append("what is warned of below: it may be the cause" in out.getvalue())
    table.check("codes: an error with warnings points to them", told == [True, False], told)
    code, said = command(case.path, "-n", "0")
    table.check("codes: 2 for a wrong option", code == 2 and "a whole number" in said,
                " ".join(said.split())[-30:])
    case.set(CONTROL, "maxCo", 0.4)
    case.set(PHASES, "target.nu", 0.499)
    table.check("codes: the case is as it was but for these", sorted(os.listdir(case.path))
                == ["0", "constant", "system"] and before != "")


def trial(table):
    for name in ("vibratingBar", "slidingBlock", "taylorBar"):
        case = FoamCase("check", name, os.path.join(PROJECT, "tutorials", name))
        if name == "taylorBar":         # a third of its time: the bar slows down
            case.set(CONTROL, "endTime", 33e-6)
            case.set(CONTROL, "writeInterval", 11e-6)
        check = Check(case.path, steps=None if name != "taylorBar" else 60)
        code = check.run()
        table.check(f"trial: {name} starts", code < 2, found(check))
        case.prepare()
        case.run("materialPointFoam")
        table.row(f"trial: {name}: steps foretold over those of the run", 1,
                  check.trial.steps/case.nSteps(), 0.3)
    check = Check(TEMPLATE, ranks=2)
    table.row("trial: two ranks, exit code", 0, check.run(), 0)
    said = [text for _, text in check.lines]
    table.check("trial: one core and two ranks", all(any(w in t for t in said) for w in (
        "on 1 core, if", "on 2 ranks, if", "largest of 2 ranks")), said[-3])
    # The target on one of them
    case = FoamCase("check", "uneven", TEMPLATE)
    case.write("system/decomposeParDict", {
        "numberOfSubdomains": 2, "method": "hierarchical",
        "hierarchicalCoeffs": {"n": "(1 2 1)", "delta": 0.001, "order": "xyz"}})
    table.check("trial: even slabs are no finding", "decomposeParDict" not in found(check))
    uneven = Check(case.path, ranks=2)
    uneven.run()
    table.check("trial: uneven slabs are a note", any(
        f.kind == "note" and "58.4 % more points than the mean" in f.text
        for f in uneven.findings), found(uneven))
    for last, words in ((2e-7, True), (1.05e-7, False)):
        with open(case.file("log.materialPointFoam"), "w") as f:
            for i, dt in enumerate((1e-8, 1e-7, last), 1):
                f.write(f"Time = {i}e-6\ndeltaT = {dt}\ndeltaT set by points of target\n"
                        f"Progress: step {i}0\nExecutionTime = {i} s\n")
        short = Trial(case)
        short.read()
        table.check(f"trial: a step that {'grows' if words else 'has grown'}",
                    (short.grows == 1e-7) == words, short.grows)
    # Neither less than Python's own pages nor more than the machine's
    table.row("trial: memory [MB]", 20, check.trial.memory, 20, "atLeast")


def tutorials(table):
    top = os.path.join(PROJECT, "tutorials")
    unmade, false, n = [], [], 0
    for control in sorted(glob.glob(os.path.join(top, "**/system/controlDict"), recursive=True)):
        folder = os.path.dirname(os.path.dirname(control))
        name = os.path.relpath(folder, top)
        if "variants" in name or "schemes" in name:
            continue
        n += 1
        check = Check(folder, trial=False)
        code = check.run()
        if name in UNMADE and not check.hasMesh:
            if code != 2 or UNMADE[name] not in check.findings[0].text:
                unmade.append(f"{name}: {found(check)}")
            continue
        told = [f.text for f in check.findings if f.kind != "note"]
        true = TRUE.get(name, [])
        if code == 2 or len(told) != len(true) or any(w not in t for w, t in zip(true, told)):
            false.append(f"{name}: {told}")
        notes = [f.text for f in check.findings if f.kind == "note"]
        print("   ", name, code, *(f"[{t[:60]}]" for t in told + notes), flush=True)
        if not check.lines:
            write(check, sys.stdout)
    table.row("tutorials: cases", 50, n, 50, "atLeast")
    table.check("tutorials: those whose mesh is to be made first say so", not unmade,
                " | ".join(unmade)[:300])
    table.check("tutorials: no false alarm", not false, " | ".join(false)[:300])


if __name__ == "__main__":
    sys.exit(runParts("check", template, told, mistakes, leaks, names,
                      dropped, start, codes, trial, tutorials))
