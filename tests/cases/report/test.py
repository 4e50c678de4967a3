#!/usr/bin/env python3
"""mpmReport: the page of a case.

pages       small cases in 1D, 2D, 3D and with a gas: the page has the numbers of the log, the
            constants with their units, a picture of each time, the plots of log and tables;
            it needs nothing from elsewhere and is below 3 MB
going       a run that goes on, its page made by -watch: the page reloads until the run has
            ended; a restart: both logs are one history
compared    -with: entries that differ are those that were changed, lines of both
failures    failed points: in a colour of their own, which the title names; colours that are the
            same in all pictures
parts       without a run: words of dictionaries, units of the time left, remedies that belong to
            the time of an error, probes
bad         no case, no log, a log that is cut off, an error, processor folders alone, a
            machine without dygraphs: one clear sentence or a page that says it
browser     in Chromium at two widths: no error, nothing loaded, nothing wider than the page;
            slider and zoom, by mouse and keys. Skipped where there is none
"""

import base64
import html.parser
import io
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import PIL.Image

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../lib"))
from bar import barRun
from blockInGas import blockInGas
from browser import Browser, inBrowser
from foamCase import PATIENCE, PROJECT, RUN, FoamCase, fileHeader, runParts
from plates import plateCase
from pictureRows import colours, views

sys.path.insert(0, os.path.join(os.environ["MPM_PROJECT_DIR"], "etc/python"))
from mpm.reportCase import Meanings, parse, tables
from mpm.pictures import SIGNED, VALUES, to_rgb
from mpm.reportColours import FAILED, fluidColours, joined
from mpm.reportLog import History, _Reader, logs
from mpm.reportPage import Remedies, numbers
from mpm.reportPictures import choose, gasRange, pictures
from mpm.reportPlots import (Plot, heldBack, logPlots, probes, short, shortName, tablePlots,
                             together)

TOOL = os.path.join(PROJECT, "etc/bin/mpmReport")
TEMPLATE = os.path.join(PROJECT, "etc/caseTemplate")
FLIP = {"shapeFunction": "GIMP", "transfer": "FLIP", "PICfraction": 0.01}


class Page(html.parser.HTMLParser):
    """What a test looks at: data, rows of tables, links, text."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.data, self.rows, self.keys = [], [], {}, [], {}
        self.text, self.inside, self.key, self.cell = "", None, None, False
        with open(path, encoding="utf-8") as f:
            self.source = f.read()
        self.feed(self.source)

    def handle_starttag(self, tag, attributes):
        data = dict(attributes)
        if tag == "a":
            self.links.append(data.get("href", ""))
        else:
            self.loads += [v for k, v in attributes if k in ("src", "href", "action", "data")]
        if tag == "script":
            self.inside = data.get("id", "code")
        elif tag == "style":
            self.inside = "style"
        elif tag == "tr":
            self.rows.append([])
            self.key = data.get("data-key")
        elif tag in ("td", "th") and self.rows:
            self.rows[-1].append("")
            self.cell = True

    def handle_endtag(self, tag):
        if tag in ("script", "style"):
            self.inside = None
        elif tag == "tr" and self.key:
            self.keys[self.key] = self.rows[-1]
        elif tag in ("td", "th"):
            self.cell = False

    def handle_data(self, text):
        if self.inside == "style" or self.inside == "code":
            return
        if self.inside:
            self.data[self.inside] = json.loads(text)
            return
        self.text += text
        if self.cell:
            self.rows[-1][-1] += text

    def last(self, key):
        """The last value of a number of the log."""
        return float(self.keys[key][3])


def report(*words, fails=False, environment=None):
    """What mpmReport prints."""
    run = subprocess.run([sys.executable, TOOL, *words], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, timeout=200,
                         env={**os.environ, **(environment or {})})
    output = run.stdout.decode()
    if bool(run.returncode) != fails:
        raise RuntimeError(f"mpmReport {' '.join(words)}: exit {run.returncode}: {output}")
    return output


def pageOf(case, *words, **options):
    report(case.path, *words, **options)
    return Page(case.file("report.html"))


def template(name, endTime="20e-6", **changes):
    """etc/caseTemplate, meshed and filled; changes: file with _ for its slash, rows."""
    case = FoamCase("report", name, TEMPLATE)
    case.change("system/controlDict", r"^endTime .*?;", f"endTime {endTime};")
    for path, (pattern, value) in changes.items():
        case.change(path.replace("_", "/"), pattern, value)
    case.run("blockMesh")
    case.run("setMaterialPoints")
    return case


def lastOf(case, pattern):
    """The last number of this pattern in the log."""
    return float(case.numbers(pattern).ravel()[-1])


def gas(name, nDim):
    case = blockInGas("report", name, nDim, 16 if nDim < 3 else 8, {
        "type": "box", "min": (2e-4, 2e-4, 0), "max": (6e-4, 6e-4, 1)}, (100, 50, 0), steps=40)
    case.change("system/controlDict", r"^writeInterval (\S+);",
                lambda m: f"writeInterval {float(m[1])/4};")
    case.run("materialPointFoam")
    return case


# --- pages -----------------------------------------------------------------------

#: Numbers of the log, found here on their own: key of the page, pattern
NUMBERS = (("Energy|kinetic", "^Energy: kinetic N,"),
           ("Energy|strain", "^Energy: .*strain N,"),
           ("Energy|total", "^Energy: .*total N$"),
           ("Material points|", "^Material points: N, mass"),
           ("Material points|mass", "^Material points: .*mass N, mom"),
           ("Material points|momentum x", r"momentum \(N \S+ \S+\)$"),
           ("Failed points|", "^Failed points: N,"), ("deltaT|", "^deltaT = N$"),
           ("Progress|step", "^Progress: .*step N"))
OF_GAS = (("Theta|min", "^Theta: min N,"), ("Theta|max", "^Theta: .*max N$"),
          ("Gas air|mass", "^Gas air: mass N,"), ("Gas air|energy", "^Gas air: .*energy N$"),
          ("Gas air|p", "^    p N to"), ("Gas air|p to", "^    p .* to N, outflow"))


def alone(page):
    """What the page would load from elsewhere, links for the reader left out."""
    found = [u for u in page.loads if not u.startswith(("data:", "#"))]
    styles = re.sub(r"<script.*?</script>", "", page.source, flags=re.S)
    return found + re.findall(r"url\((?!['\"]?(?:data:|#))[^)]*\)|@import.*", styles)


def looked(table, name, case, numbers, constants):
    """The rows that hold for the page of any case."""
    start = resource.getrusage(resource.RUSAGE_CHILDREN)
    page = pageOf(case)
    end = resource.getrusage(resource.RUSAGE_CHILDREN)
    table.row(f"{name}: seconds of a core", 20, end.ru_utime + end.ru_stime - start.ru_utime
              - start.ru_stime, 20*PATIENCE, "atMost")
    table.row(f"{name}: MB of the page", 3, len(page.source.encode())/1e6, 3, "atMost")
    table.check(f"{name}: needs nothing from elsewhere", not alone(page), alone(page))
    worst = 0.0
    for key, pattern in numbers:
        exact = lastOf(case, pattern)
        worst = max(worst, abs(page.last(key) - exact)/(abs(exact) or 1))
    table.row(f"{name}: {len(numbers)} numbers of the log, largest error", 0, worst, 1e-9)
    missing = [c for c in constants if not any(r[:3] == list(c) for r in page.rows)]
    table.check(f"{name}: constants with units", not missing, missing)
    times = case.times("lagrangian")
    frames = page.data["frames"]
    table.row(f"{name}: pictures, one of each time", len(times), len(frames[0]["images"]), 0)
    sizes = set()
    for image in frames[0]["images"]:
        with PIL.Image.open(io.BytesIO(base64.b64decode(image.split(",")[1]))) as picture:
            sizes.add(picture.size)
            colours = len(picture.convert("RGB").getcolors(1 << 24))
    table.check(f"{name}: pictures of one size, with colours",
                len(sizes) == 1 and colours > 20, f"{sizes} {colours}")
    table.check(f"{name}: says that it is done", re.search(r"badge\s+done", page.source))
    return page


def pages(table):
    bar = barRun("report", "bar", {**FLIP, "PICfraction": 0}, 20)[0]
    page = looked(table, "1D", bar, NUMBERS, (("constitutiveModel.E", "100.0", "Pa"),))
    t, energy = bar.series("balance", "bar.dat")[:, [0, 11]].T
    plot = next(p for p in page.data["plots"] if p["title"] == "balance: bar"
                and p["unit"] == "J")
    line = next(x for x in plot["lines"] if x["name"] == "total")
    table.row("1D: the plot of a table keeps its largest value", energy.max(), max(line["y"]),
              1e-5, "relative")
    table.row("1D: ... at its time", t[energy.argmax()],
              plot["t"][0][int(np.argmax(line["y"]))], 1e-5, "relative")

    plain = template("plain")
    plain.run("materialPointFoam")
    looked(table, "2D", plain, NUMBERS, (
        ("constitutiveModel.E", "210e9", "Pa"), ("constitutiveModel.rho", "2700", "kg/m3"),
        ("failureModel.Gf", "10000", "J/m2"), ("all.mu", "0.2", ""),
        ("endTime", "20e-6", "s")))
    block = plateCase("report", "block", 4, FLIP, 2e-7, 1e-7, 0.4, depth=4)
    block.run("materialPointFoam")
    looked(table, "3D", block, NUMBERS, ())
    for name, nDim in (("gas 2D", 2), ("gas 3D", 3)):
        page = looked(table, name, gas(name.replace(" ", ""), nDim), NUMBERS + OF_GAS,
                      (("gamma", "1.4", ""),))
        titles = {p["title"] for p in page.data["plots"]}
        table.check(f"{name}: plots", {
            "Energy", "Theta", "Gas air: mass", "Gas air: momentum", "Gas air: pressure",
            "time step", "pressure: fieldMinMax"} <= titles, sorted(titles))
        table.check(f"{name}: cards of the gas and of a driven body", "mass of air" in page.text
                    and re.search(r"energy of the points\S+ J", page.text))


# --- a run that goes on --------------------------------------------------------------

def going(table):
    # So slow that nothing leaves the mesh, however long this takes
    case = template("going", endTime="1", system_setMaterialPointsDict=(
        r"velocity .*?;", "velocity (0 -0.05 0);"))
    with open(case.file("log.materialPointFoam"), "w") as log:
        solver = subprocess.Popen(["materialPointFoam"], cwd=case.path, stdout=log,
                                  stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                  env={**os.environ, "PWD": case.path})
    watch = subprocess.Popen([sys.executable, TOOL, "-watch", "-interval", "1", "-times", "3",
                              case.path], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
    path, states = case.file("report.html"), []
    try:
        steps = set()
        until = time.time() + 90
        while time.time() < until and len(steps) < 3:
            time.sleep(0.2)
            if os.path.exists(path):
                page = Page(path)
                states.append((re.search(r"badge\s+(\w+)", page.source)[1],
                               page.data["page"]["refresh"]))
                if "Progress|step" in page.keys:
                    steps.add(page.last("Progress|step"))
        table.row("-watch: pages with later steps while it runs", 3, len(steps), 3, "atLeast")
        table.check("-watch: says running, and reloads", states[-1:] == [("running", 1)],
                    states[-1:])
        warned(table, case)
        solver.send_signal(signal.SIGTERM)
        solver.wait(60)
        said = watch.communicate(timeout=60)[0].decode()
        table.check("-watch: ends with the run, which a signal has stopped",
                    watch.returncode == 0 and "is stopped" in said, said)
        page = Page(path)
        table.check("stopped by a signal: the page says which",
                    "Signal 15 (Terminated) was received." in page.text)
        table.check("-watch: the last page does not reload",
                    page.data["page"]["refresh"] is None)
        table.row("-watch: the last page has the last step",
                  lastOf(case, "^Progress: .*step N"), page.last("Progress|step"), 0)
        rows = case.numbers("(?s)^Progress: [^\n]*?step N[^\n]*\nExecutionTime = N s")
        speed = np.ptp(rows, axis=0)
        table.row("speed: million point-steps a second, by the log",
                  1e-6*2020*speed[0]/speed[1], float(re.search(
                      r"point-steps a second of CPU([\d.]+) million", page.text)[1]), 1e-3,
                  "relative")
        plot = next(p for p in page.data["plots"] if p["title"] == "speed")["lines"][0]["y"]
        known = [y for y in plot if y is not None]
        table.row("speed: its plot has that mean", 1e-6*2020*speed[0]/speed[1],
                  float(np.mean(known)), 0.25, "relative")
    finally:
        for process in (solver, watch):
            if process.poll() is None:
                process.kill()
                process.wait()

    # Gone on with, in a second log
    case = template("restart")
    case.run("materialPointFoam")
    shutil.move(case.file("log.materialPointFoam"), case.file("log.first"))
    case.change("system/controlDict", r"^endTime .*?;", "endTime 40e-6;")
    case.run("materialPointFoam")
    page = pageOf(case)
    table.row("restart: steps of both logs", lastOf(case, "^Progress: .*step N"),
              page.last("Progress|step"), 0)
    plot = next(p for p in page.data["plots"] if p["title"] == "Energy")
    t = np.array(plot["t"][0])
    table.check("restart: one history, times grow", np.all(np.diff(t) > 0)
                and t[0] < 20 < t[-1], (t[0], t[-1]))
    table.check("restart: says so", "2 starts" in page.text)


def warned(table, case):
    """endTime of 1 s is 3e7 steps away: the warning, its line, its remedy."""
    page = Page(case.file("report.html"))
    lines = [n for n, line in enumerate(case.log().split("\n"), 1)
             if line.startswith("--> FOAM Warning")]
    notes = re.findall(r'<div class="note" data-line="(\d+)">(.*?)</div>', page.source, re.S)
    table.check("a warning: the line of the log", lines == [int(n) for n, _ in notes],
                f"{lines} {[n for n, _ in notes]}")
    text = " ".join(t for _, t in notes)
    table.check("a warning: its words and its remedy", "Is endTime in s?" in text
                and "50 us are <code>endTime 50e-6</code>" in text, text[:300])


def compared(table):
    one = template("one", endTime="10e-6")
    two = template("two", endTime="10e-6", constant_phaseProperties=(r"E 70e9", "E 60e9"))
    two.change("system/setMaterialPointsDict", r"\(0 -50 0\)", "(0 -60 0)")
    # The same value, written otherwise
    two.change("constant/phaseProperties", r"rho 2700", "rho 2.7e3")
    for case in (one, two):
        case.run("materialPointFoam")
    for case in (one, two):
        os.makedirs(case.file("postProcessing/final/0"))
        with open(case.file("postProcessing/final/0/profile.dat"), "w") as f:
            f.write(f"# Profile\n# x[m]\tu[m/s]\n0 1\n1 {2 if case is one else 3}\n")
    page = pageOf(one, "-with", two.path)
    table.check("-with: tables that are not over time, of both", re.search(
        r"final: profile.dat</h3>.*final: profile.dat, two</h3>", page.source, re.S))
    files = ("constant/phaseProperties", "system/setMaterialPointsDict")
    found = {(r[0], r[1], r[2], r[3]) for r in page.rows if len(r) == 4
             and r[0].startswith(("constant/", "system/", "0/"))}
    table.check("-with: entries that differ, no others", found == {
        (files[0], "target.constitutiveModel.E", "70e9", "60e9"),
        (files[1], "regions.flyer.velocity", "(0 -50 0)", "(0 -60 0)")}, found)
    plot = next(p for p in page.data["plots"] if p["title"] == "Energy")
    names = [x["name"] for x in plot["lines"]]
    table.check("-with: lines of both", names == [
        "kinetic", "strain", "total", "kinetic (two)", "strain (two)", "total (two)"], names)
    table.row("-with: last energy of the other in its line",
              lastOf(two, "^Energy: .*total N$"), plot["lines"][5]["y"][-1], 1e-5, "relative")
    energy = np.array(page.keys["Energy|kinetic"][7:], float)
    table.row("-with: least and largest of the other", 0, np.abs(energy - [f(two.numbers(
        "^Energy: kinetic N,")) for f in (np.min, np.max)]).max(), 1e-9)
    table.check("the header names the version", re.search(r"OpenFOAM v\d{4}\s", page.text))
    table.check("-with: cards of both", page.text.count("simulated time") == 2)
    table.row("-with: pictures of both", 2, len(page.data["frames"]), 0)
    long = FoamCase("report", "E_6e+10-speed_60", two.path)
    shutil.copytree(two.path, long.path, dirs_exist_ok=True)
    page = pageOf(one, "-with", long.path)
    plot = next(p for p in page.data["plots"] if p["title"] == "Energy")
    names = [x["name"] for x in plot["lines"][3:]]
    table.check("-with: of a long name its end in the legends", names == [
        f"{n} (…10-speed_60)" for n in ("kinetic", "strain", "total")]
        and "Compared with E_6e+10-speed_60" in page.text, names)
    same = pageOf(one, "-with", one.path)
    table.check("-with itself: no entry differs",
                "All entries of the dictionaries are the same" in same.text)


# --- parts ---------------------------------------------------------------------------

REGIONS = "system/setMaterialPointsDict"
#: An entry, its dictionary, a word of its meaning; none: of OpenFOAM, or of the user
MEANINGS = (
    ("system/blockMeshDict", "scale", "scale 1e-3;", ""),
    ("system/blockMeshDict", "boundary.outflow.type", "boundary { outflow { type patch; } }", ""),
    ("constant/g", "value", "value (0 -9.81 0);", ""),
    ("system/decomposeParDict", "method", "method simple;", ""),
    ("system/decomposeParDict", "loadBalance.interval", "loadBalance { interval 9; }", "look"),
    ("system/controlDict", "functions.drag.type", "functions { drag { type forces; } }", ""),
    ("system/controlDict", "functions.a.phases",
     "functions { a { type forces; libs (forces); phases (x); } }", ""),
    ("system/controlDict", "functions.a.fields", "functions { a { type materialPointVTK;"
     " libs (mpmFunctionObjects); fields (p); } }", "time folder"),
    (REGIONS, "radius", "radius 2;", ""),
    (REGIONS, "regions.a.radius", "regions { a { type sphere; radius 2; } }", "sphere"),
    (REGIONS, "regions.contact.type", "regions { contact { type box; } }", "shape"),
    (REGIONS, "regions.a.surface.type", "regions { a { surface { type triSurfaceMesh; } } }", ""),
    ("constant/phaseProperties", "drag.drag.type", "drag { drag { type stick; } }", ""),
    ("constant/phaseProperties", "drag.velocityField", "drag { velocityField a; }", "share"),
    ("constant/phaseProperties", "a.equationOfState.soundSpeed",
     "a { type fluid; equationOfState { type stiffenedGas; soundSpeed 3; } }", "softened"))


def lab(colours):
    """CIELAB of colours in sRGB."""
    c = np.atleast_2d(colours)[:, :3]
    linear = np.where(c <= 0.04045, c/12.92, ((c + 0.055)/1.055)**2.4)
    xyz = linear @ np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722],
                             [0.0193, 0.1192, 0.9505]]).T/[0.9505, 1, 1.089]
    f = np.where(xyz > (6/29)**3, np.cbrt(xyz), xyz*(29/6)**2/3 + 4/29)
    return np.stack([116*f[:, 1] - 16, 500*(f[:, 0] - f[:, 1]), 200*(f[:, 1] - f[:, 2])], 1)


def failures(table):
    case = template("failed", endTime="10e-6", constant_phaseProperties=(
        "strength 400e6; Gf 10000;", "strength 400e6;"))
    case.run("materialPointFoam")
    table.row("failures: failed points", 1, lastOf(case, "^Failed points: N"), 1, "atLeast")
    frame = pageOf(case).data["frames"][0]
    table.check("failures: the title names their colour", f"({FAILED}: failed)" in frame["title"],
                frame["title"])
    # Half of what is between black and white
    for name, scale in (("VALUES", VALUES), ("SIGNED", SIGNED)):
        apart = np.linalg.norm(lab(scale(np.linspace(0, 1, 256))) - lab(to_rgb(FAILED)), axis=1)
        table.row(f"failures: least difference from the colours of {name}", 50, apart.min(), 50,
                  "atLeast")
    shown = []
    for image in frame["images"]:
        with PIL.Image.open(io.BytesIO(base64.b64decode(image.split(",")[1]))) as picture:
            away = lab(np.asarray(picture.convert("RGB")).reshape(-1, 3)/255) - lab(to_rgb(FAILED))
            shown.append(int((np.linalg.norm(away, axis=1) < 10).sum()))
    table.check("failures: pixels of it in the last picture, none in the first",
                shown[0] == 0 < shown[-1], shown)
    colours(table)
    views(table)


def parts(table):
    found = parse("a { reconstruct(U) (p) vanLeer; reconstruct(p) upwind;"
                  " div((nu*dev2(T(grad(U))))) Gauss; b (0 (1 2) 3); }")["a"]
    table.check("entries with brackets in their names", found == {
        "reconstruct(U)": "(p) vanLeer", "reconstruct(p)": "upwind",
        "div((nu*dev2(T(grad(U)))))": "Gauss", "b": "(0 (1 2) 3)"}, found)
    for words, seconds in (("40 s", 40), ("3 minutes", 180), ("5 hours", 18000),
                           ("2 days", 172800)):
        reader = _Reader("")
        reader.values(f"Progress: 10 %, step 7, about {words} left")
        table.row(f"time left, {words}", seconds, reader.row["Progress", "about"], 0)
    text, remedies = "density and rho c^2 must be positive", Remedies("report.html")
    table.check("an error after steps: no remedy of the start",
                "at the start" in remedies.find(text) and "maxCoGas" in remedies.find(text, True)
                and "at the start" not in remedies.find(text, True))
    table.check("#calc as root: its remedy", "#eval" in remedies.find(
        "This code should not be executed by someone with administrator rights for security"))
    for file, path, data, word in MEANINGS:
        meaning = Meanings().find(file, path, parse(data))[1]
        table.check(f"meaning of {path} in {file}: {'has ' + word if word else 'none'}",
                    word in meaning if word else not meaning, meaning)
    table.check("limits of colours of both runs", joined((0, 2), {"U": (1, 5)}, "U") == (0, 5))
    case = FoamCase("report", "probes", TEMPLATE)
    folder = case.file("postProcessing/tip/0")
    os.makedirs(folder)
    with open(os.path.join(folder, "displacement.dat"), "w") as f:
        f.write("# Phase flap, 1 points\n# Point 199 was at (0 0 0) at time 0\n"
                "# Time[s]\tdisplacement_x(199)[m]\tdisplacement_y(199)[m]\n"
                "0 0 0\n1 0.5 -3\n2 0.25 1\n")
    ofTables(table, case)
    ofFluids(table)
    missing(table)
    ofOpenFOAM(table)
    flatLines(table)
    pressureUnits(table)
    mixed(table)
    ranges(table)
    for own, shown in (("E_1e+06-drop_0.03", "E_4e+06"), ("E_4e+06-drop_0.01", "drop_0.03"),
                       ("E_1e-06-drop_0.01", "…6-drop_0.03"), ("reference", "…6-drop_0.03")):
        table.check(f"legends: E_4e+06-drop_0.03 beside {own}: {shown}",
                    shortName("E_4e+06-drop_0.03", own) == shown)
    spread(table)
    found = probes(t for t in tables(case) if t.function == "tip")
    table.check("probes: the largest, its time, short names", found == [
        ("tip: displacement_x", 0.5, "m", 1), ("tip: displacement_y", -3, "m", 1)], found)
    names = [n for n, _, _ in tablePlots(
        [t for t in tables(case) if t.function == "tip"])[0].lines]
    table.check("probes: short names of lines", names == ["displacement_x", "displacement_y"],
                names)
    named = [short([f"{c}({i})" for i in ids for c in ("U_x", "U_y")])
             for ids in ((199, 7), (3, 52))]
    table.check("probes: two places have the same names on another mesh", named == 2*[
        ["U_x, place 1", "U_y, place 1", "U_x, place 2", "U_y, place 2"]], named)


#: Tables as blastProbes, OpenFOAM's probes and materialPointExtent write them
TABLES = {
    "gauges/0/p.dat": "# Probes: 0 at (-1 0 2.5), 1 at (1 0 0), 2 patch wall, field p\n"
                      "# Time[s]\t0\t1\t2\n0 1 2 3\n1 2 3 4\n",
    "gauges/0/summary.dat": "# At 1 s. Probes are places, then patches\n"
                            "# Probe\tx[m]\tambient\tpeak\tpositiveImpulse\n0 -1 1e5 2e5 3\n",
    "probes/0/T": "# Probe 0 (-1 0 2)\n# Probe 1 (1 0 0)\n#       Probe             0            1\n"
                  "#        Time\n 0 300 400\n 1 301 402\n",
    "extent/0/rod.dat": "# Phase rod, coordinates of points\n# Time[s]\t" + "\t".join(
        f"{what}_{d}[m]" for what in ("min", "max", "centre") for d in "xyz") + "\n"
                        "0 0 1 1e-19 2 3 1e-19 1 2 1e-19\n1 4 1 0 6 3 0 5 2 0\n",
    "sums/0/rod.dat": "# Phase rod, angular momentum about (0 0 0)\n"
                      "# Time[s]\tPx[kg.m/s]\tLz[kg.m2/s]\n0 1 2\n1 2 3\n"}


def ofTables(table, case):
    """Names of the lines, columns and plots of tables of function objects."""
    for path, text in TABLES.items():
        path = case.file("postProcessing", path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as f:
            f.write(text)
    found = {(t.function, t.name): t for t in tables(case)}
    plots = {f"{p.title} [{p.unit}]": [n for n, _, _ in p.lines]
             for p in tablePlots(list(found.values()))}
    for what, title, names in (
            ("blastProbes", "gauges: p [Pa]", ["(-1 0 2.5)", "(1 0 0)", "patch wall"]),
            ("OpenFOAM's probes", "probes: T [K]", ["(-1 0 2)", "(1 0 0)"]),
            ("extent", "extent: rod, along x [m]", ["min", "max", "centre"])):
        table.check(f"{what}: lines named by {'direction' if what == 'extent' else 'place'}",
                    plots.get(title) == names, plots)
    said = [p.comment for p in tablePlots([found["sums", "rod.dat"]])]
    table.check("sums: the place of angular momentum stands with that alone", said == [
        "Phase rod", "Phase rod, angular momentum about (0 0 0)"], said)
    known = probes([found["gauges", "p.dat"], found["probes", "T"], found["extent", "rod.dat"]])
    table.check("probes of fields: the largest of each place", known == [
        ("gauges: p at (-1 0 2.5)", 2, "Pa", 1), ("gauges: p at (1 0 0)", 3, "Pa", 1),
        ("gauges: p at patch wall", 4, "Pa", 1), ("probes: T at (-1 0 2)", 301, "K", 1),
        ("probes: T at (1 0 0)", 402, "K", 1)], known)
    table.check("extent: no z in 2D", [t for t in plots if t.startswith("extent")] == [
        "extent: rod, along x [m]", "extent: rod, along y [m]"], list(plots))
    units = found["gauges", "summary.dat"].columns
    table.check("blastProbes: units of the summary", units == [
        "Probe", "x[m]", "ambient[Pa]", "peak[Pa]", "positiveImpulse[Pa s]"], units)


#: What the log has of fluids, with fix-ups
FLUIDS = """Build  : OPENFOAM=1912 patch=200626
Exec   : materialPointFoam
materialPointFoam 0.9.0
Fluids with one velocity and one pressure, 3600 cells:
Starting time loop
Courant Number mean: 0.6 max: 0.6
Courant Number of points: 0.2, of the gas: 0.6
deltaT = 1e-8
deltaT set by the gas: Courant number 0.6
Time = 1e-6
Energy budget: transfer 0, residual 1
    gas 7782, gained 0
Fluids: mass water 3 air 1, momentum (0 0 0), energy 5
    p 1 to 2, cells at interfaces 9, outflow limited 70, theta kept 8, isentropic 0, voids 0 """ \
    """(energy 0.5 added, mass 0.002 held back, 0 dropped)
Progress: 5 %, step 20, about 23 s left
"""


def ofFluids(table):
    reader = _Reader("")
    for i, line in enumerate(FLUIDS.split("\n"), 1):
        reader.line(i, line)
    reader.store()
    case = FoamCase("report", "afterwards")
    for name, text in (("log.run", FLUIDS), ("log.post", FLUIDS.replace(
            "Foam\n", "Foam -postProcess\n", 1))):
        with open(case.file(name), "w") as f:
            f.write(text)
    found = [os.path.basename(p) for p in logs(case)], [
        len(_Reader(case.file(name)).read()) for name in ("log.run", "log.post")]
    table.check("a log of -postProcess is no run", found == (["log.run"], [1, 0]), found)
    history = History(reader.runs)
    heads = {h for h, _ in history.keys} | {who for who, _, _, _ in history.limiters()}
    table.check("fluids: no head says gas", {"Energy budget, fluids", "the fluids"} <= {
        h.split(":")[0] for h in heads} and not any("gas" in h for h in heads), heads)
    table.row("fix-ups: mass held back, % of the mass", 100*0.002/4, heldBack(history, "Fluids"),
              1e-12, "relative")
    text = numbers(history, None, "", "fluids.md")
    table.check("fix-ups: share and link beside the numbers", '<a href="fluids.md#fix-ups">mass'
                " held back</a>, 0.05 % of the mass" in text and '#fix-ups">outflow limited</a>'
                in text)
    comment = next(p.comment for p in logPlots(history) if p.title == "Fluids")
    table.check("fix-ups: share beside their plot", "0.05 % of the mass" in comment, comment)


def mixed(table):
    """Three fluids, a third of the picture each, the one in the middle half of the last."""
    case = template("mixed")
    shutil.rmtree(case.file("0/lagrangian"))
    third = np.arange(2400)//(2400//3)
    for i, name in enumerate(("water", "oil", "air")):
        share = np.where(third == i, 1.0, 0.0) if i == 0 else np.where(
            third == 1, 0.5, 1.0*(third == i))
        with open(case.file(f"0/alpha.{name}"), "w") as f:
            f.write(fileHeader(f"alpha.{name}", "volScalarField") + "dimensions [0 0 0 0 0 0 0];\n"
                    "internalField nonuniform List<scalar> 2400\n(\n"
                    + "\n".join(map(str, share)) + "\n);\nboundaryField {}\n")
    fluids = {n: {"type": "fluid", **({"thermo": "perfectGas"} if n == "air" else {})}
              for n in ("water", "oil", "air")}
    pressure = {"water": 2e5, "oil": 1e5, "air": 1e5}
    with open(case.file("0/p"), "w") as f:
        f.write(fileHeader("p", "volScalarField") + "dimensions [1 -1 -2 0 0 0 0];\n"
                "internalField nonuniform List<scalar> 2400\n(\n"
                + "\n".join(str([*pressure.values()][i]) for i in third)
                + "\n);\nboundaryField {}\n")
    shown = pictures(case, fluids, 1)
    titles = [p.title.split("): ")[1] for p in shown]
    table.check("fluids: pictures by shares and by pressure",
                titles == ["fluids", "pressure of the fluids"], titles)
    with PIL.Image.open(io.BytesIO(base64.b64decode(shown[1].frames[0][1].split(",")[1]))) as one:
        pixels = lab(np.asarray(one.convert("RGB")).reshape(-1, 3)/255)
    high, low = ((np.linalg.norm(pixels - lab(np.array(VALUES(v)[:3])), axis=1) < 4).sum()
                 for v in (1.0, 0.0))
    table.row("pressure of fluids: pixels of the lower over those of the higher", 2,
              low/max(high, 1), 0.1)
    with PIL.Image.open(io.BytesIO(base64.b64decode(shown[0].frames[0][1].split(",")[1]))) as one:
        pixels = lab(np.asarray(one.convert("RGB")).reshape(-1, 3)/255)
    of = fluidColours(fluids)
    for name, colour in (("water", of["water"]), ("oil and air", (of["oil"] + of["air"])/2),
                         ("air", of["air"])):
        n = (np.linalg.norm(pixels - lab(colour), axis=1) < 4).sum()
        if name == "water":
            first = n
        table.row(f"three fluids: pixels of {name} over those of water", 1, n/max(first, 1), 0.05)
    table.check("two fluids: by the share of the first", not fluidColours(
        {n: fluids[n] for n in ("water", "air")}))


def ranges(table):
    """A blast of 40 bar at first, then of 2, 1.5, 1.2 bar over an air of 1 bar."""
    class Blast:
        def cells(self, time, field):
            return [], np.linspace(1e5, time, 1001)
    high = gasRange(None, Blast(), "p", (4e6, 2e5, 1.5e5))[1]
    table.row("pictures: end of the range of pressures, three times the middle [Pa]",
              1e5 + 3*0.995*1e5, high, 0.01, "relative")
    table.row("pictures: of another field it is the largest", 0.995*4e6,
              gasRange(None, Blast(), "T", (4e6, 2e5, 1.5e5))[1], 0.01, "relative")


def ofOpenFOAM(table):
    """A warning of OpenFOAM's whose text is not indented, in the log's steps."""
    text = FLUIDS + "\n--> FOAM Warning : \nUnknown function type interfaceHeight\n\nValid" \
        " function types :\n\n2\n(\nprobes\nsets\n)\n\n" + FLUIDS
    reader = _Reader("")
    for i, line in enumerate(text.split("\n"), 1):
        reader.line(i, line)
    said = [m.lines for run in reader.runs for m in run.messages]
    table.check("messages: a warning of OpenFOAM's has its text",
                said == [["Unknown function type interfaceHeight"]], said)


def missing(table):
    """Lines that the log has only at first: three sub-steps, a force until 2 us."""
    text = "".join(FLUIDS.replace("Build", "Build" if t == 1 else "#Build").replace(
        "Time = 1e-6", f"Time = {t}e-6\n" + ("Steps of the points in this one of the gas: 3\n"
        "Force: of wall 5" if t < 3 else "")) for t in (1, 2, 3, 4))
    reader = _Reader("")
    for i, line in enumerate(text.split("\n"), 1):
        reader.line(i, line)
    reader.store()
    history = History(reader.runs)
    plots = {p.title: p for p in logPlots(history)}
    steps = plots["Steps of the points in this one of the fluids"]
    table.check("missing lines: one step of the points where the log has no line",
                not steps.constant() and list(steps.lines[0][2]) == [3, 3, 1, 1], steps.lines)
    said = plots["Force"].constant()
    table.check("missing lines: a value that stays, from when to when",
                said == "Force: of wall 5 (from 1e-06 to 2e-06 s)", said)


def flatLines(table):
    """An energy of 3095 J beside what it gains."""
    t = np.arange(4.)

    def of(start, gained):
        return Plot("", "Energy budget, fluids", "J", [("value", t, start + gained*t),
                                                       ("gained", t, gained*t)])
    plot = of(3095, 0.01)
    together([plot], [of(3000, 0.02)])
    plot.changes()
    ends = [y[-1] for _, _, y in plot.lines + plot.other]
    table.row("flat lines: changes since the start in both runs [J]", 0, np.abs(
        np.array(ends) - (0.03, 0.03, 0.06, 0.06)).max(), 1e-9)
    table.check("flat lines: the axis and the comment say so", "changes since the start" in
                plot.axis and "value 3095 J" in plot.comment, (plot.axis, plot.comment))
    plot = of(1, 0.1)
    plot.changes()
    table.check("flat lines: no others are changed", plot.axis == "J"
                and plot.lines[0][2][0] == 1)


def pressureUnits(table):
    """Plots of pressures have the unit of their largest, both runs the same."""
    t = np.arange(3.)
    for size, unit, factor in ((50, "Pa", 1), (2e5, "kPa", 1e-3), (3e6, "MPa", 1e-6),
                               (2e10, "GPa", 1e-9)):
        plot = Plot("", "gauges: p", "Pa", [("p", t, 0.01*size*(1 + t))])
        together([plot], [Plot("", "gauges: p", "Pa", [("p", t, -size*t/2)])])
        plot.pressures()
        table.check(f"pressure up to {size:g} Pa: unit", plot.unit == plot.axis == unit, plot.unit)
        table.row(f"pressure up to {size:g} Pa: least of the other run [{unit}]", -factor*size,
                  plot.other[0][2].min(), 1e-12, "relative")
    plot = Plot("", "gauges: p", "Pa", [("value", t, 1e5 + 0*t)])
    plot.pressures()
    table.check("pressure that stays: in Pa", plot.constant() == "gauges: p [Pa]: 100000",
                plot.constant())


def spread(table):
    """The pictures' times: evenly, of any number of written times."""
    worst = 0.0
    for n in (13, 21, 24, 60, 101):
        some = [float(t) for t in choose([f"{i/(n - 1):.6g}" for i in range(n)], 12)]
        steps = np.diff(some)[1:]
        worst = max(worst, np.ptp(steps)/steps.mean() if (some[0], some[-1]) == (0, 1)
                    and 6 < len(some) <= 12 else np.inf)
    table.row("times of pictures: relative difference of steps behind the first", 0, worst, 1e-3)


# --- what is wrong -------------------------------------------------------------------

def bad(table):
    for tool in (TOOL, os.path.join(os.path.dirname(TOOL), "mpmCheck")):
        run = [subprocess.run([sys.executable, tool, word], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT) for word in ("-help", "-h", "--help")]
        table.check(f"{os.path.basename(tool)}: -help, -h and --help say the same", all(
            r.returncode == 0 and r.stdout == run[0].stdout for r in run)
            and "[case]" in run[0].stdout.decode(), run[0].stdout.decode()[:40])
    root = os.path.join(RUN, "report")
    said = report(os.path.join(root, "nowhere"), fails=True)
    table.check("no folder: one line", "there is no folder" in said
                and said.count("\n") == 1, said)
    said = report(os.path.join(PROJECT, "tutorials/blockInAir"), fails=True)
    table.check("no case: names those in it", "is no case" in said and "moving" in said
                and said.count("\n") == 1, said)
    case = template("cut")
    table.check("no log yet: the page says so", "No log of materialPointFoam" in
                pageOf(case).text)
    table.check("no log yet: what is computed", "constitutiveModel.E" in
                Page(case.file("report.html")).text)
    case.run("materialPointFoam")
    log = case.log()
    # In the middle of a number, an hour old
    at = log.index("strain", len(log)//2) + 9
    case.write("log.materialPointFoam", {})
    with open(case.file("log.materialPointFoam"), "w") as f:
        f.write(log[:at])
    os.utime(f.name, (time.time() - 3600,)*2)
    page = pageOf(case)
    table.check("cut log: stopped, and says why", re.search(r"badge\s+stopped", page.source)
                and "ends before its end" in page.text)
    whole = re.findall(r"^Progress: .*step (\d+)", log[:at], re.M)
    table.row("cut log: the last whole report", float(whole[-1]),
              page.last("Progress|step"), 0)
    with open(case.file("log.materialPointFoam"), "wb") as f:
        f.write(os.urandom(5000))
    table.check("no text in the log: as none", "No log of materialPointFoam" in
                pageOf(case).text)
    wrong = template("wrong")
    wrong.change("constant/phaseProperties", "E 70e9", "EE 70e9")
    wrong.run("materialPointFoam", fails=True)
    page = pageOf(wrong)
    table.check("an error: says failed, the message, its line", re.search(
        r"badge\s+failed", page.source) and "EE" in page.text
        and "log.materialPointFoam:" in page.text)
    links = [u for u in page.links if "troubleshooting.md#" in u]
    place, anchor = links[0].split("#") if links else ("none", "none")
    target = os.path.join(wrong.path, place)
    exists = os.path.isfile(target)
    heads = []
    if exists:
        with open(target) as f:
            heads = [re.sub(r"[^\w -]", "", x.strip("# \n")).lower().replace(" ", "-")
                     for x in f if x.startswith("#")]
    table.check("an error: link to its remedy, which is there", exists and anchor in heads,
                links)
    for words in (("-times", "0"), ("-watsch",), ("-log", "nothing")):
        said = report(case.path, *words, fails=True)
        table.check(f"{' '.join(words)}: refused without a traceback",
                    "Traceback" not in said and "mpmReport" in said, said)
    case = template("view", endTime="1e-6")
    case.run("materialPointFoam")
    with open(case.file("view.py"), "w") as f:
        f.write("VIEWS = {")
    said = report(case.path)
    table.check("a wrong view.py: said, the page has the automatic choice", "view.py: " in said
                and Page(case.file("report.html")).data["frames"], said)
    squares(table)
    ranks(table)
    still = template("still", endTime="10e-6")
    still.run("materialPointFoam")
    page = pageOf(still, environment={"MPM_DYGRAPHS": "/nowhere"})
    table.check("no dygraphs: says how to get it",
                "apt-get install libjs-dygraphs" in page.text)
    table.row("no dygraphs: plots as still pictures", 5, page.source.count("<svg"), 5,
              "atLeast")
    table.check("no dygraphs: nothing from elsewhere", not alone(page), alone(page))


#: As the table of doc/guide/output.md has it; in brackets what more a layer has
VIEW = """VIEWS = {{"both": {{"points": [{{"phases": ("target", "flyer"), "field": "%s",
    "label": "stress [Pa]", "limits": (-1e8, 1e8){}}}]}}}}"""


def squares(table):
    """Points without half-sizes in a view that does not say how thick the body is."""
    case = template("squares", endTime="1e-6")
    case.run("materialPointFoam")
    for name in case.times("lagrangian"):       # as on a mesh of gmsh
        for phase in ("target", "flyer"):
            os.remove(case.file(name, "lagrangian", phase, "halfSize"))
    thick = np.ptp(case.edges()[2])
    images = []
    for more in ("", f', "section": {thick}'):
        with open(case.file("view.py"), "w") as f:
            f.write(VIEW.format(more) % "sigma_yy")
        said = report(case.path)
        images.append(Page(case.file("report.html")).data["frames"][0]["images"])
        table.check(f"view.py {'with' if more else 'without'} section: no message, all times",
                    "no picture" not in said and len(images[-1]) == len(
                        case.times("lagrangian")), said)
    table.check("view.py: the thickness of the mesh is what section says",
                images[0] == images[1])
    with open(case.file("view.py"), "w") as f:
        f.write(VIEW.format("") % "nothing_yy")
    said = report(case.path)
    frames = Page(case.file("report.html")).data["frames"]
    table.check("a view without a picture: the automatic choice", len(frames) == 1
                and "automatic" in frames[0]["title"] and frames[0]["images"])
    table.check("view.py: one message of all pictures of a view", said.count("no picture both")
                == 1 and "times, first time 0" in said, said)


def ranks(table):
    """Two processors, of whose folders alone the page is made."""
    case = template("ranks")
    case.decompose((2, 1, 1))
    case.runParallel()
    for name in case.times():
        shutil.rmtree(case.file(name))
    shutil.rmtree(case.file("constant/polyMesh"))
    page = pageOf(case)
    times = len(os.listdir(case.file("processor0"))) - 1        # and constant
    table.row("processor folders alone: pictures", times,
              len(page.data["frames"][0]["images"]), 0)
    table.row("processor folders alone: cells", 2400, float(re.search(
        r"(\d+) cells at the start", page.text)[1]), 0)
    table.row("processor folders alone: kinetic energy",
              lastOf(case, "^Energy: kinetic N,"), page.last("Energy|kinetic"), 1e-9,
              "relative")
    said = report(case.file("processor0"), fails=True)
    table.check("processor0: give the folder above", "give the folder above" in said
                or "is no case" in said, said)


# --- in a browser ----------------------------------------------------------------------

#: Labels of the axis up of the first plot with values that differ in their seventh digit
TICKS = """(() => {
    const g = Object.values(mpmReport.graphs)[0];
    g.updateOptions({file: [[0, 101325.01], [1, 101325.06]], labels: ["time", "p"], series: {},
                     dateWindow: null});
    return [...g.graphDiv.querySelectorAll(".dygraph-axis-label-y")].map(e => e.textContent);
})()"""

#: The first plot with volumes of twelve letters in place of its data: the room that is left
UNIT = """(() => {
    const g = Object.values(mpmReport.graphs)[0];
    g.updateOptions({file: [[0, -1.23451e-10], [1, -1.23459e-10]], labels: ["time", "V"],
                     series: {}, ylabel: "m3", dateWindow: null});
    const box = e => {
        const r = document.createRange();
        r.selectNodeContents(e);
        return r.getBoundingClientRect();
    };
    const one = g.graphDiv;
    const numbers = [...one.querySelectorAll(".dygraph-axis-label-y")].map(e => box(e).left);
    return Math.min(...numbers) - box(one.querySelector(".dygraph-ylabel")).right;
})()"""


def browser(table):
    if not Browser.find():
        table.skip("the page in a browser", "no chromium here")
        return
    case = template("browser")
    case.run("materialPointFoam")
    report(case.path)
    path = case.file("report.html")
    inBrowser(table, os.path.join(RUN, "report", "profile"),
              lambda held, chromium: looks(held, chromium, path, case))
    other = FoamCase("report", "browserOther", case.path)
    shutil.copytree(case.path, other.path, dirs_exist_ok=True)
    report(other.path, "-with", case.path)
    inBrowser(table, os.path.join(RUN, "report", "profile"), lambda held, chromium: legends(
        held, chromium.open(other.file("report.html"), 1400, 900), "browser"))


def looks(table, chromium, path, case):
    """The page at two widths."""
    for width in (1400, 420):
        page = chromium.open(path, width, 900)
        # Plots are drawn when they come into view
        page.evaluate("document.querySelector('.plot').scrollIntoView({block: 'center'})")
        page.wait("Object.keys(mpmReport.graphs).length > 0")
        name = f"{width} pixels"
        table.row(f"{name}: plots are drawn", 1, page.evaluate(
            "document.querySelectorAll('.plot canvas').length"), 1, "atLeast")
        table.row(f"{name}: pixels wider than the page", 0, page.evaluate(
            "document.documentElement.scrollWidth - window.innerWidth"), 0, "atMost")
        slider(table, name, page)
        zoom(table, name, page)
        table.row(f"{name}: pixels between the unit and the longest numbers of an axis", 2,
                  page.evaluate(UNIT), 2, "atLeast")
        labels = page.evaluate(TICKS)
        table.check(f"{name}: no two ticks of an axis have the same label", len(labels) > 2
                    and len(set(labels)) == len(labels), labels)
        page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
        table.row(f"{name}: plots that are drawn to be printed, of all", 1, page.evaluate(
            "Object.keys(mpmReport.graphs).length/document.querySelectorAll('.plot').length"), 0)
        page.screenshot(case.file(f"page{width}.png"), whole=True)
        table.check(f"{name}: no error in the console", not page.errors, page.errors)
        others = [u for u in page.requests
                  if not u.startswith(("data:", "file://" + path))]
        table.check(f"{name}: nothing is loaded", not others, others)


def legends(table, page, name):
    """With another run each line stands once in a legend, without its dashed one; an error in
    the console would be one of the page's."""
    page.evaluate("document.querySelector('.plot').scrollIntoView({block: 'center'})")
    page.wait("Object.keys(mpmReport.graphs).length > 0")
    shown = page.evaluate("document.querySelector('.plot .legend').innerText").split()
    lines = page.evaluate("mpmReport.plots[0].lines.filter(l => l.run === 0).map(l => l.name)")
    table.check("legend with another run: each line once, and whose the dashed ones are",
                shown == " ".join(lines + ["dashed:", name]).split(), (shown, lines))
    over = page.evaluate("(() => { mpmReport.graphs[0].setSelection(2);"
                         " return document.querySelector('.plot .legend').innerText; })()")
    table.check("legend under the cursor: lines of both runs with values",
                all(f"{n}: " in over and f"{n} ({name}): " in over for n in lines), over)
    table.check("legend: no error in the console", not page.errors, page.errors)


def slider(table, name, page):
    """By keys: an earlier time, an earlier picture."""
    look = "[document.getElementById('shown').textContent," \
           " document.getElementById('picture0').src]"
    before = page.evaluate(look)
    page.evaluate("document.getElementById('time').focus()")
    page.key("ArrowLeft")
    after = page.evaluate(look)
    table.check(f"{name}: slider by key, another time and picture",
                before[0] != after[0] and before[1] != after[1], (before[0], after[0]))
    page.key("End")
    table.check(f"{name}: and back", page.evaluate(look) == before)


def zoom(table, name, page):
    """A drag over the first plot shows that part, a double click all; keys."""
    find = "document.querySelector('.plot .canvas')"
    page.evaluate(find + ".scrollIntoView({block: 'center'})")
    time.sleep(0.3)
    x, y, w, h = page.evaluate(
        f"(() => {{ const r = {find}.getBoundingClientRect();"
        " return [r.x, r.y, r.width, r.height]; })()")
    span = "(() => { const d = document.querySelector('.plot').dataset;" \
        " return d.to - d.from; })()"
    whole = page.evaluate(span)
    page.drag((x + 0.4*w, y + 0.5*h), (x + 0.7*w, y + 0.5*h))
    part = page.evaluate(span)
    # The part of the width that the axis of y leaves: 98 pixels and its ticks
    table.row(f"{name}: part of the time after a drag over 0.3 of the width",
              0.3*w/(w - 98 - 6), part/whole, 0.05, "relative")
    page.doubleClick((x + 0.6*w, y + 0.5*h))
    table.row(f"{name}: after a double click", 1, page.evaluate(span)/whole, 0.02)
    page.evaluate(find + ".focus()")
    page.key("+", "+")
    table.row(f"{name}: after the key +", 0.5, page.evaluate(span)/whole, 0.02)
    page.key("0", "0")
    table.row(f"{name}: after the key 0", 1, page.evaluate(span)/whole, 0.02)


if __name__ == "__main__":
    sys.exit(runParts("report", pages, going, compared, failures, parts, bad, browser))
