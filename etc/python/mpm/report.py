"""mpmReport: one HTML file of a case, running or done, that needs no server and no network.

    mpmReport [options] [case]          # <case>/report.html

    -case <folder>      the case (default: this folder)
    -output <file>      the page (default: report.html in the case)
    -with <folder>      another run: its lines in the same plots, its pictures, the entries of
                        the dictionaries that differ
    -times <n>          pictures of each view (default 12)
    -log <file>         log of the solver (default: all of its logs in the case)
    -watch              make the page anew while the run goes on; it reloads by itself
    -interval <s>       with -watch: seconds between two pages (default 10)

What is shown comes from dictionaries, logs, written times and postProcessing. Pictures are
those of view.py, or an automatic choice.
"""

import argparse
import os
import re
import sys
import time

import numpy as np

from mpm import reportPage as page
from mpm.case import Case
from mpm.reportCase import (FILES, Meanings, differences, fields, meshOf, readDictionary,
                            tables)
from mpm.reportColours import ofPressure
from mpm.reportLog import SOLVER, History, logs, readRuns
from mpm.reportPage import dygraphs, esc, number
from mpm.reportPictures import pictures, scale, writtenTimes
from mpm.reportPlots import (heldBack, logPlots, packed, probes, shortName, tablePlots,
                             together)


def fail(text):
    sys.exit(f"mpmReport: {text}")


def isCase(folder):
    return os.path.isfile(os.path.join(folder, "system/controlDict")) \
        and os.path.isfile(os.path.join(folder, FILES[0]))


def checkedCase(folder):
    """The case of a folder, or one error that says what is wrong with it."""
    if not os.path.isdir(folder):
        fail(f"there is no folder {folder}")
    if os.path.basename(os.path.realpath(folder)).startswith("processor") and isCase(
            os.path.join(folder, "..")):
        fail(f"{folder} is a part of a decomposed case: give the folder above it")
    if not isCase(folder):
        below = sorted(d for d in os.listdir(folder) if isCase(os.path.join(folder, d)))
        missing = [n for n in ("system/controlDict", FILES[0])
                   if not os.path.isfile(os.path.join(folder, n))]
        fail(f"{folder} is no case of {SOLVER}: it has no {' and no '.join(missing)}"
             + (f"; cases in it: {' '.join(below)}" if below else ""))
    return Case(folder)


class Content:
    """What is known of a case: dictionaries, logs, tables."""

    def __init__(self, case, log=None):
        self.case = case
        self.name = os.path.basename(os.path.realpath(case.path))
        self.dictionaries = {name: readDictionary(case, name) for name in FILES}
        self.runs = readRuns(case, [log] if log else None)
        self.history = History(self.runs)
        self.tables = list(tables(case))
        self.plots = logPlots(self.history)
        self.more = tablePlots(self.tables)

    def state(self):
        return self.runs[-1].state() if self.runs else "no log"

    def endTime(self):
        try:
            return float(self.dictionaries["system/controlDict"].get("endTime", "nan"))
        except ValueError:
            return np.nan

    def lastTime(self):
        return self.history.times[-1] if self.history.rows else np.nan

    def timeScale(self):
        """Factor and unit in which times are shown."""
        known = [t for t in (self.endTime(), self.lastTime()) if np.isfinite(t)]
        factor, prefix = scale(max(known) if known else 0)
        return factor, prefix + "s"


#: Where the guide says what fix-ups are
FIXUPS = "doc/guide/fluids.md"


def cards(content):
    """The most important figures: (what, figure, comment, page of the guide that says more)."""
    h = content.history
    if not h.rows:
        return []
    last, found = h.rows[-1], []
    factor, unit = content.timeScale()
    end = content.endTime()
    share = ""
    if np.isfinite(end):
        share = f"{last['Progress', '']:.3g} % of {factor*end:.5g} {unit}"
    found.append(("simulated time", f"{factor*content.lastTime():.5g} {unit}", share))
    steps = last.get(("Progress", "step"))
    if steps is not None:
        found.append(("steps", f"{steps:.0f}", f"last time step {number(last['deltaT', ''])} s"
                      if ("deltaT", "") in last else ""))
    points, cells = h.size()
    cells = np.broadcast_to(cells, points.shape)
    flow = "fluids" if h.heads("Fluids") else "gas"
    for what, n in (("points", points), (f"cells of the {flow}", cells)):
        if np.isfinite(n[-1]):
            found.append((what, f"{n[-1]:.0f}", f"{n[0]:.0f} at the start"
                          if n[0] != n[-1] else ""))
    ends = [r.rows[-1] for r in content.runs if r.rows]
    cpu, wall = (sum(row.get(("ExecutionTime", name), 0) for row in ends)
                 for name in ("", "ClockTime"))
    n = content.runs[-1].header.get("nProcs", "1")
    of, on = ("", "") if n == "1" else (f"of one of {n} processors, ", f"on {n} processors")
    found.append(("CPU time", f"{cpu:.5g} s", of + f"{wall:.0f} s passed"))
    _, mean = h.rate()
    if np.isfinite(mean):
        for what, n in (("point-steps", points), ("cell-steps", cells)):
            if np.isfinite(n).any():
                found.append((f"{what} a second of CPU",
                              f"{1e-6*mean*np.nanmean(n):.4g} million", on))
    return found + balance(content)


def balance(content):
    """Cards of what should stay: energy, mass, fractions, load."""
    h, found = content.history, []
    total = h.series("Energy", "total")
    if np.isfinite(total).any():
        known = total[np.isfinite(total)]
        found.append(("energy of the points", f"{known[-1]:.4g} J", "at the last report; gravity,"
                      " gas or fluids do work") if driven(content) else
                     ("change of the energy", change(total), "of the points, from the first"
                      " report to the last; its largest is 100 %"))
    mass = h.series("Material points", "mass")
    if np.isfinite(mass).any():
        found.append(("change of the mass", change(mass), "of the points"))
    found += ofFluids(content)
    for head in h.heads("Gas [^:,]*|Fluids"):
        held = heldBack(h, head)
        n = [h.series(head, name)[-1] for name in ("outflow limited", "theta kept")]
        if np.isfinite(held) and any(n):
            found.append(("mass held back by fix-ups", f"{held:.3g} %",
                          f"of the mass beside it, over the whole run: outflow limited {n[0]:.0f}"
                          f" times, theta kept {n[1]:.0f} times", "fix-ups"))
    low, high = h.series("Theta", "min"), h.series("Theta", "max")
    if np.isfinite(low).any():
        found.append(("sum of volume fractions", f"{np.nanmin(low):.5g} to"
                      f" {np.nanmax(high):.5g}", "Theta, 1 where all fits"))
    residual = content.case.energyResidual()
    if residual is not None:
        found.append(("residual of the energy budget", f"{100*residual:.3g} %", "of the largest "
                      "energy of the points, or what a source brought or took"))
    for line in content.runs[-1].head:
        if "imbalance" in line and "points per processor" in line:
            found.append(("imbalance at the start", f"{float(line.split()[-2]):.3g} %",
                          "points of the fullest processor over the mean"))
    if content.runs[-1].loads:
        found.append(("last look of loadBalance", content.runs[-1].loads[-1].split(",")[0],
                      content.runs[-1].loads[-1]))
    n = sum(m.kind == "warning" for r in content.runs for m in r.messages)
    return found + [("warnings", str(n), "" if n == 0 else "below")]


def driven(content):
    """Does gravity, a gas or do fluids work on the points?"""
    numbers = re.findall(r"[-+.\de]*\d[-+.\de]*", content.dictionaries["constant/g"].get(
        "value", ""))
    return bool(content.history.heads("Gas .*|Fluids")) or any(float(v) for v in numbers)


def ofFluids(content):
    """Cards of the mass of each fluid, by the log, and its kinetic energy, by a table."""
    h, found = content.history, []
    for head in h.heads("Gas [^:,]*|Fluids"):
        for name in h.names(head):
            words = name.split()
            if words[:1] == ["mass"] and len(words) == (2 if head == "Fluids" else 1):
                v = h.series(head, name)
                found.append((f"mass of {words[-1] if head == 'Fluids' else head[4:]}",
                              change(v), f"{v[np.isfinite(v)][-1]:.5g} kg"))
    fluids = {f[0].split()[-1] for f in found}
    for one in content.tables:
        name = os.path.splitext(one.name)[0]
        if name in fluids and one.overTime and "kinetic[J]" in one.columns:
            found.append((f"kinetic energy of {name}",
                          f"{one.data[-1, one.columns.index('kinetic[J]')]:.4g} J",
                          f"{one.function}, last row"))
    return found


def probeParts(content, other):
    """Largest values of probes as cards, with another run as a table of both."""
    factor, unit = content.timeScale()
    mine, theirs = probes(content.tables), probes(other.tables) if other else []
    if not mine and not theirs:
        return ""
    if not other:
        return '<div class="cards">' + cardBoxes([
            (what, withUnit(v, u), f"farthest from 0, at {factor*t:.5g} {unit}")
            for what, v, u, t in mine]) + "</div>\n"
    known = [{(what, u): v for what, v, u, _ in some} for some in (mine, theirs)]
    rows = []
    for what, u in {**known[0], **known[1]}:
        values = [some.get((what, u)) for some in known]
        factor, shown = ofPressure(max(abs(v) for v in values if v is not None)) if u == "Pa" \
            else (1, u)
        rows.append(page.row(esc(what), esc(shown), *(
            "" if v is None else f"{factor*v:.5g}" for v in values)))
    return page.table(["probe", "unit", f"largest of {content.name}", f"largest of {other.name}"],
                      rows)


def withUnit(value, unit):
    """A value as text, pressures in kPa, MPa or GPa."""
    factor, unit = ofPressure(abs(value)) if unit == "Pa" else (1, unit)
    return f"{factor*value:.5g} {unit}"


def cardBoxes(some, guide=""):
    """Cards; guide: link to the page of the guide, whose section a card may name."""
    return "".join(
        f'<div class="card"><span>{esc(what)}</span><b>{esc(figure)}</b><span>{esc(comment)}'
        + "".join(f' <a href="{esc(guide)}#{a}">{a}</a>' for a in more) + "</span></div>"
        for what, figure, comment, *more in some)


def change(v):
    v = v[np.isfinite(v)]
    size = np.abs(v).max()      # of the largest, as after a start at rest
    return f"{100*(v[-1] - v[0])/size:+.4g} %" if v[-1] != v[0] else "0 %"


def notices(content):
    """What must be said first: no log, a log that ends before its end."""
    found = []
    if not content.runs:
        has = len(writtenTimes(content.case)) > 1
        found.append(f"No log of {SOLVER} in this case"
                     + (": what it printed was not kept. Run it as" if has else
                        " yet: run it as")
                     + f" <code>{SOLVER} &gt; log.{SOLVER} 2&gt;&amp;1</code>, or name the log"
                     " with <code>-log</code>.")
    elif content.state() == "stopped":
        found.append(esc(content.runs[-1].signal) or "The log ends before its end, and no process"
                     " writes it: the run was killed, or the log was cut off.")
    elif not content.history.rows:
        found.append("The log has no report of a step yet.")
    if dygraphs() is None:
        found.append(esc(page.MISSING))
    return found


def pictureParts(content, other, n, cache, notes):
    """HTML and data of the pictures, of the other run beside."""
    shown = []
    runs = [c for c in (content, other) if c]
    for run, one in enumerate(runs):
        beside = [(c.case, c.dictionaries[FILES[0]]) for c in runs if c is not one]
        for picture in pictures(one.case, one.dictionaries[FILES[0]], n,
                                cache.setdefault(run, {}), notes, beside):
            shown.append((one, picture))
    if not shown:
        return "", [], []
    times = sorted({t for one, p in shown for t, _ in p.frames if one is content}
                   or {t for _, p in shown for t, _ in p.frames})
    data, boxes = [], []
    for i, (one, picture) in enumerate(shown):
        title = picture.title if one is content else f"{picture.title}, {one.name}"
        data.append({"id": f"picture{i}", "title": title,
                     "times": [t for t, _ in picture.frames],
                     "images": [image for _, image in picture.frames]})
        boxes.append(f'<figure><img id="picture{i}" alt="{esc(title)}"'
                     f' src="{picture.frames[-1][1]}"><figcaption>{esc(title)}</figcaption>'
                     "</figure>\n")
    factor, unit = content.timeScale()
    names = [f"{factor*t:.5g} {unit}" for t in times]
    text = ('<h2 id="pictures">Pictures</h2>\n'
            '<div class="times"><label for="time">time</label>'
            f'<input type="range" id="time" min="0" max="{len(times) - 1}" step="1"'
            f' value="{len(times) - 1}"><output id="shown" for="time">{names[-1]}</output>'
            '<button type="button" id="play">Play</button></div>\n'
            f'<div class="pictures">{"".join(boxes)}</div>\n')
    return text, data, list(zip(times, names))


def differenceParts(content, other):
    rows = differences(content.case, other.case)
    head = f'<h2 id="differences">Compared with {esc(other.name)}</h2>\n<p class="soft">' \
        f"{esc(os.path.realpath(other.case.path))}; its lines are dashed.</p>"
    if not rows:
        return head + "<p>All entries of the dictionaries are the same.</p>"

    def short(v):
        return f"<code>{esc(v[:300])}</code>" if v else '<span class="soft">none</span>'
    found = page.table(
        ["file", "entry", content.name, other.name],
        [page.row(f"<code>{esc(f)}</code>", f"<code>{esc(k)}</code>", short(a), short(b))
         for f, k, a, b in rows])
    n = f"{len(rows)} entries differ" if len(rows) > 1 else "one entry differs"
    return f"{head}<details{' open' if len(rows) < 40 else ''}><summary>{n}</summary>" \
        f"{found}</details>"


def header(content, refresh):
    state = content.state()
    parts = [f"<header><h1>{esc(content.name)}</h1><span class='badge"
             f" {state if state != 'no log' else ''}'>{state}</span>\n"]
    line = [esc(os.path.realpath(content.case.path))]
    if content.runs:
        run = content.runs[-1]
        started = " ".join(run.header.get(k, "") for k in ("Date", "Time")).strip()
        if started:
            line.append(esc(f"started {started}"))
        build = run.header.get("Build", "")
        number = re.search(r"OPENFOAM=(\d+)", build)
        line += [esc(w) for w in (run.version, "OpenFOAM " + (f"v{number[1]}" if number else build)
                                  if build else "") if w]
        if len(content.runs) > 1:
            line.append(f"{len(content.runs)} starts")
        if state == "running":
            age = page.ago(time.time() - os.path.getmtime(run.log))
            left = run.rows[-1].get(("Progress", "about")) if run.rows else None
            line.append(f"last line {age} ago" + (
                f", about {page.ago(left)} left" if left is not None else ""))
    parts.append(f'<p class="soft">{" &middot; ".join(line)}</p>')
    if refresh:
        parts.append('<p><label><input type="checkbox" id="hold"> hold: do not reload</label>'
                     f' <span class="soft">(every {refresh:g} s)</span></p>')
    return "".join(parts) + "</header>\n"


def build(content, other, n, output, refresh=None, cache=None):
    """The page's text, and what is to be said on the terminal."""
    notes = []
    remedies = page.Remedies(output)
    guide = page.linkTo(FIXUPS, output)
    shown, frames, times = pictureParts(content, other, n,
                                        {} if cache is None else cache, notes)
    if not shown and writtenTimes(content.case) in ([], ["0"]):
        notes.append("no pictures: no written times")
    plots, more = list(content.plots), list(content.more)
    if other:
        together(plots, other.plots)
        together(more, other.more)
    for plot in plots + more:
        plot.changes()
        plot.pressures()
    short = shortName(other.name, content.name) if other else ""
    factor, unit = content.timeScale()
    axis = f"time [{unit}]"

    def still(plot):
        return page.still(plot, factor, axis, short)
    zoom = dygraphs() is not None
    said = "".join(f'<div class="note">{t}</div>' for t in notices(content))
    said += "".join(f'<div class="note">{esc(t)}</div>' for t in notes)
    last = content.runs[-1] if content.runs else None
    sections = [("pictures", "Pictures", shown),
                ("probes", "Probes", probeParts(content, other))]
    if other:
        sections.append(("differences", "Comparison", differenceParts(content, other)))
    sections += [
        ("run", "Run", page.plotBoxes(plots, 0, zoom, still) + page.limiters(content.history)
         + page.stepParts(last.parts if last else "")),
        ("output", "Function objects", page.plotBoxes(more, len(plots), zoom, still)
         + page.xtDiagrams(content.tables) + page.otherTables(content.tables)
         + (page.otherTables(other.tables, f", {other.name}") if other else "")),
        ("numbers", "Numbers of the log", page.numbers(
            content.history, other.history if other else None, other.name if other else "",
            guide) if content.history.rows else ""),
        ("case", "What is computed", page.computed(
            content.dictionaries, Meanings(), fields(content.case), meshOf(content.case),
            last.head if last else []))]
    sections = [s for s in sections if s[2]]
    body = [header(content, refresh), "<main>\n<nav>",
            "".join(f'<a href="#{key}">{title}</a>' for key, title, _ in sections), "</nav>\n",
            said, f'<div class="cards">{cardBoxes(cards(content), guide)}</div>\n',
            f'<p class="soft">{esc(other.name)}:</p><div class="cards">'
            f"{cardBoxes(cards(other), guide)}</div>\n" if other else "",
            page.messages(content.runs, remedies, content.case)]
    for key, title, inside in sections:
        body.append(inside if inside.startswith("<h2") else
                    f'<h2 id="{key}">{title}</h2>\n{inside}')
    data = {"page": {"times": [t for t, _ in times], "names": [n for _, n in times],
                     "timeLabel": axis, "timeName": "t ="},
            "frames": frames,
            "plots": packed(plots + more, factor, short)}
    return page.document(f"{content.name}: report", "".join(body) + "</main>\n", data,
                         refresh), notes


def write(path, text):
    """At once, for a browser that reads it meanwhile."""
    try:
        with open(path + ".part", "w", encoding="utf-8") as f:
            f.write(text)
        os.replace(path + ".part", path)
    except OSError as error:
        fail(f"cannot write {path}: {error.strerror}")


def changed(case):
    """What tells that there is something new to show."""
    return ([(p, os.path.getsize(p)) for p in logs(case)], writtenTimes(case))


def watch(case, other, options, output):
    """New pages until the run has ended; Ctrl-C ends it, too. A run that has stopped is
    waited for, it may be started again."""
    cache, before = {}, None
    while True:
        now = changed(case)
        content = Content(case, options.log)
        ended = content.state() == "failed" or bool(content.runs) and content.runs[-1].ended
        if now != before or ended:
            text, _ = build(content, other, options.times, output,
                            None if ended else options.interval, cache)
            write(output, text)
            if before is None:
                print(f"{output}: open it in a browser; Ctrl-C ends the watch", flush=True)
            before = now
        if ended:
            print(f"{output}: the run is {content.state()}")
            return
        time.sleep(options.interval)


def arguments(words):
    parser = argparse.ArgumentParser(
        prog="mpmReport", usage="mpmReport [options] [case]", add_help=False,
        allow_abbrev=False)
    parser.add_argument("folder", nargs="?")
    for name in ("-case", "-output", "-with", "-log"):
        parser.add_argument(name, dest=name.strip("-").replace("with", "other"))
    parser.add_argument("-times", type=int, default=12)
    parser.add_argument("-interval", type=float, default=10)
    parser.add_argument("-watch", action="store_true")
    parser.add_argument("-help", "-h", "--help", action="store_true")
    options = parser.parse_args(words)
    if options.help:
        print(__doc__.strip())
        sys.exit(0)
    if options.folder and options.case:
        fail("give the case once: -case or the folder alone")
    if options.times < 1 or options.interval <= 0:
        fail("-times and -interval must be positive")
    return options


def main(words=None):
    options = arguments(words)
    case = checkedCase(options.case or options.folder or ".")
    if options.log and not os.path.isfile(options.log):
        fail(f"there is no file {options.log}")
    other = Content(checkedCase(options.other)) if options.other else None
    output = options.output or case.file("report.html")
    if os.path.isdir(output):
        output = os.path.join(output, "report.html")
    output = os.path.abspath(output)
    try:
        if options.watch:
            watch(case, other, options, output)
            return
        content = Content(case, options.log)
        text, notes = build(content, other, options.times, output)
    except KeyboardInterrupt:
        return
    write(output, text)
    for note in notes + ([] if dygraphs() else [page.MISSING]):
        print(f"mpmReport: {note}", file=sys.stderr)
    print(f"{output}: {len(text.encode())/1e6:.2f} MB, run {content.state()}")


if __name__ == "__main__":
    main()
