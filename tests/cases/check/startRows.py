"""Rows of mpmCheck for the start: fields, thin bodies, what holds them, probes, output, mm."""

import io
import os
import re
import shutil

from checkCases import CONTROL, MESH, PHASES, REGIONS, TEMPLATE, basin, found, toldOf
from foamCase import FoamCase
from mpm.check import write

SETFIELDS = "system/setFieldsDict"
H = 0.3514/71       # cells of the basin [m]


def start(table):
    order(table)
    regions(table)
    vessel(table)
    thin(table)
    held(table)
    probes(table)
    output(table)
    units(table)


def withFields(name, low, high, p=1e6):
    """The basin, with p in a box by setFields."""
    case = basin(name)
    case.write(SETFIELDS, {
        "defaultFieldValues": "( volScalarFieldValue p 1e4 )",
        "regions": f"( boxToCell {{ box ({' '.join(map(str, low))}) ({' '.join(map(str, high))});"
                   f" fieldValues ( volScalarFieldValue p {p:g} ); }} )"})
    return case


def order(table):
    """What setFields gives is there as setMaterialPoints looks at p; points that are there."""
    case = withFields("order", (-1, -1, -1), (1, 1, 1))
    word = "starts with the pressure 10000 Pa; what flows in its cells has 1000000 Pa"
    hits, check = toldOf(case, word)
    table.check("start: a body in gas of setFields", hits == [("warning", REGIONS)], found(check))
    for name in ("blockMesh", "setFluids", "setMaterialPoints", "setFields"):
        if name == "setFluids":
            shutil.copytree(case.file("0.orig"), case.file("0"))
        case.run(name)
    hits, check = toldOf(case, word)
    table.check("start: the same with points that are there", check.hasPoints
                and hits == [("warning", REGIONS)], found(check))
    # An Allrun with setFields first: setFluids gives p anew, by hydrostatic
    case = withFields("ownOrder", (-1, -1, -1), (1, 1, 1))
    with open(case.file("Allrun"), "w") as f:
        f.write("runApplication setFields\nrunApplication setFluids\n")
    hits, check = toldOf(case, word)
    table.check("start: setFluids after setFields in the Allrun", not hits, found(check))


def regions(table):
    word = "no cell starts with its values (p 1e+06)"
    for name, low, high, told in (("in the mesh", (0, 0, -1), (0.1, 0.1, 1), False),
                                  ("off the mesh", (0, -0.2, -1), (0.1, -0.1, 1), True),
                                  ("between centres", (0, 0, -1), (0.4*H, 1, 1), True)):
        hits, check = toldOf(withFields("regions", low, high), word)
        table.check(f"start: a region of setFields {name}",
                    hits == [("warning", SETFIELDS)]*told, found(check))


def vessel(table):
    """The block, 0.2 to 0.24 m: gas of 1 MPa that ends within, at its side, around it."""
    word = "jumps in its cells"
    for name, x, told in (("ends within", 0.22, True), ("ends at", 0.2, False),
                          ("is all around", 1, False)):
        case = withFields("vessel", (0, -1, -1), (x, 1, 1))
        hits, check = toldOf(case, word)
        table.check(f"start: gas of 1 MPa {name} a body", hits == [("note", REGIONS)]*told,
                    found(check))
    # Water is no jump: 0.2 m of it below gas of 1000 Pa
    case = basin("deep")
    case.set("system/setFluidsDict", "regions.column.max", (1, 0.22, 1))
    case.change("system/setFluidsDict", "p 1e4;", "p 1e3;")
    case.set(REGIONS, "regions.obstacle.pressure", 1e3)
    hits, check = toldOf(case, word)
    table.check("start: a body half in water", not hits, found(check))


def clamped(name, plate, clamp, **entries):
    """The template with boxes for a plate and a rigid clamp of one velocity field [mm]."""
    case = FoamCase("check", name, TEMPLATE)
    os.remove(case.file("0/U.flyer"))
    case.change(PHASES, r"(?s)flyer\n\{.*",
                "flyer { type rigid; rho 7800; velocityField target; }\n")
    for body, box in (("target", plate), ("flyer", clamp)):
        x, y, X, Y = (1e-3*v for v in box)
        case.set(REGIONS, "regions." + body, {
            "phase": body, "type": "box", "min": (x, y, 0), "max": (X, Y, 1), "pointsPerCell": 2,
            **(entries if body == "target" else {})})
    return case


def thin(table):
    """Cells of 1 mm."""
    word, clamp = "cells wide in y, fewer than 2", (10, -5, 15, 10)
    for name, height, told in (("0.5 mm", 0.5, True), ("3 mm", 3, False)):
        hits, check = toldOf(clamped("thin", (-20, 0, 10, height), clamp), word)
        table.check(f"start: a plate of {name} beside a clamp", hits == [("warning", REGIONS)]*told,
                    found(check))
    # A second layer of the plate below the first, with a higher clamp beside both
    case = clamped("layers", (-20, 0, 10, 1.5), clamp)
    case.set(REGIONS, "regions.below", {
        "phase": "target", "type": "box", "min": (-0.02, -0.0015, 0),
        "max": (0.01, 0, 1), "pointsPerCell": 2}, add=True)
    hits, check = toldOf(case, word)
    table.check("start: two layers of 1.5 mm beside a clamp", not hits, found(check))
    # Alone, setMaterialPoints says it, and mpmCheck not again
    hits, check = toldOf(clamped("alone", (-20, 0, 5, 0.5), clamp), word)
    table.check("start: a plate of 0.5 mm alone, told once", hits == [("warning", REGIONS)],
                found(check))


def held(table):
    word = "apart, 0.6 cells: flyer holds what is in a cell with it"
    for name, end, options, told in (
            ("0.6 cells off its plate", 9.4, {}, True), ("at its plate", 10, {}, False),
            ("3 cells off", 7, {}, False), ("0.6 cells off, with 50 m/s", 9.4,
                                            {"velocity": (50, 0, 0)}, False)):
        hits, check = toldOf(clamped("gap", (-20, 0, end, 4), (10, -5, 15, 10), **options), word)
        table.check(f"start: a clamp {name}", hits == [("note", REGIONS)]*told, found(check))
        said = dict(check.lines)["target"]
        table.check(f"start: a clamp {name}: held", said.endswith("; held by flyer") == (end > 9),
                    said[-60:])
    loose = "no side, rigid body or contact holds it"
    for name, floor, touches in (("in the air", 0.2, False), ("on a floor of slip", 0, True)):
        case = basin("loose")
        case.set(REGIONS, "regions.obstacle.min", (0.2, floor, 0))
        _, check = toldOf(case, "")
        table.check(f"start: a body {name}", (loose in dict(check.lines)["obstacle"]) != touches,
                    dict(check.lines)["obstacle"][-60:])


def probes(table):
    for place, told in ((0.009, False), (0.025, True)):
        case = FoamCase("check", "probes", TEMPLATE)
        case.set(CONTROL, "functions.mid", {
            "type": "materialPointProbes", "libs": ["mpmFunctionObjects"], "phase": "target",
            "fields": ["U"], "points": {"nearest": [(0, place, 0.0005)]},
            "writeControl": "timeStep", "writeInterval": 1}, add=True)
        hits, check = toldOf(case, "the point nearest to")
        table.check(f"start: a probe at {place} m of a target 0.01 m high",
                    hits == [("note", CONTROL)]*told, found(check))
        away = re.search(r"is (\S+) m away, (\S+) cells", " ".join(found(check)))
        if told:            # the upper points are a quarter of a cell inside
            table.row("start: the probe is away by [m]", place - 0.00975,
                      float(away[1]) if away else 0, 5e-3, "relative")


def output(table):
    """500 times of 1.28 MB, and 5000."""
    case = FoamCase("check", "output", TEMPLATE)
    usage = shutil.disk_usage
    for name, interval, keep, free, expected in (
            ("500 times", 1e-7, 0, 1e12, []), ("5000 times", 1e-8, 0, 1e12, ["note"]),
            ("5000 times, of which 3 are kept", 1e-8, 3, 1e12, []),
            ("500 times, 0.1 GB free", 1e-7, 0, 1e8, ["warning"])):
        case.set(CONTROL, "writeInterval", interval)
        case.set(CONTROL, "purgeWrite", keep, add=True)
        shutil.disk_usage = lambda path, free=free: usage("/")._replace(free=free)
        try:
            hits, check = toldOf(case, "times are written", trial=True, steps=5)
        finally:
            shutil.disk_usage = usage
        table.check(f"start: {name}", hits == [(kind, CONTROL) for kind in expected], found(check))
    case.set(CONTROL, "purgeWrite", 0)
    case.set(CONTROL, "writeInterval", 1e-8)
    hits, check = toldOf(case, "5000 times are written")
    table.check("start: 5000 times, without a trial", hits == [("note", CONTROL)], found(check))


def units(table):
    """A mesh ten times as long as one of mm, bodies of metres; an error of the trial after it."""
    case = FoamCase("check", "units", TEMPLATE)
    case.set(MESH, "scale", 10)
    case.change(REGIONS, "0.0101", "0.0")
    case.set(REGIONS, "regions.target.min", (-0.02, 0.02, 0))
    case.set(REGIONS, "regions.target.max", (0.02, 0.03, 1))
    hits, check = toldOf(case, "is the mesh in mm?")
    table.check("start: bodies of mm in a mesh of 600 m", hits == [("warning", MESH)],
                found(check))
    case.set(CONTROL, "functions.mid", {
        "type": "materialPointProbes", "libs": ["mpmFunctionObjects"], "phase": "target",
        "fields": ["U"], "points": {"nearest": [(0.01, 0.02, 0), (0.011, 0.02, 0)]},
        "writeControl": "timeStep", "writeInterval": 1}, add=True)
    hits, check = toldOf(case, "is the mesh in mm?", trial=True)
    out = io.StringIO()
    write(check, out)
    said = out.getvalue()
    table.check("start: units before the error that comes of them", hits and 0 < said.find(
        "is the mesh in mm?") < said.find("chosen twice")
        and "mend first what is warned of above" in said, found(check))
