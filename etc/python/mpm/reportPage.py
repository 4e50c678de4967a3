"""The page of mpm.report: HTML, with its style, script and data in the one file."""

import base64
import html
import io
import json
import os
import re
import time
import urllib.request
import zlib

import numpy as np

from mpm.reportCase import FILES, PROJECT, flat
from mpm.reportPlots import heldBack, label, quantities

HERE = os.path.dirname(os.path.abspath(__file__))
#: dygraphs of Debian's package libjs-dygraphs, or a copy of it that MPM_DYGRAPHS names
DYGRAPHS = "/usr/share/javascript/dygraphs"
MISSING = ("plots are still pictures, without zoom: dygraphs is missing (Debian and Ubuntu:"
           " apt-get install libjs-dygraphs; elsewhere MPM_DYGRAPHS=<folder of its"
           " dygraph.min.js and .css>)")

esc = html.escape


def dygraphs():
    """Script and style of the plots, None if this machine has none."""
    folder = os.environ.get("MPM_DYGRAPHS", DYGRAPHS)
    found = []
    for name in ("dygraph.min.js", "dygraph.min.css"):
        path = os.path.join(folder, name)
        if not os.path.exists(path):
            return None
        with open(path, encoding="utf-8") as f:
            found.append(re.sub(r"(//|/\*)# sourceMappingURL=.*", "", f.read()))
    return found


def number(value):
    return "" if value is None or not np.isfinite(value) else f"{value:.10g}"


def row(*cells, head=False, kind=""):
    tag = "th" if head else "td"
    return f"<tr{f' class={kind}' if kind else ''}>" + "".join(
        f"<{tag}>{c}</{tag}>" for c in cells) + "</tr>\n"


def table(head, rows):
    return ('<div class="wide"><table>\n' + row(*map(esc, head), head=True) + "".join(rows)
            + "</table></div>\n")


def linkTo(path, output):
    """A file of the project as seen from the page."""
    return urllib.request.pathname2url(os.path.relpath(
        os.path.join(PROJECT, path), os.path.dirname(os.path.abspath(output))))


class Remedies:
    """Cause and remedy of messages, from doc/guide/troubleshooting.md."""

    def __init__(self, output):
        self.rows, self.path = [], os.path.join(PROJECT, "doc/guide/troubleshooting.md")
        self.link = linkTo(self.path, output)
        section = ""
        if not os.path.exists(self.path):
            return
        with open(self.path, encoding="utf-8") as f:
            for line in f:
                if line.startswith("#"):
                    section = re.sub(r"[^\w -]", "", line.strip("# \n")).lower()
                cells = [c.strip() for c in line.split("|")[1:-1]]
                if len(cells) == 2 and cells[0] not in ("message", "---", "what"):
                    patterns = re.findall("`([^`]+)`", cells[0]) \
                        or re.sub(r"\(OpenFOAM's\)", "", cells[0]).split(";")
                    for p in patterns:
                        parts = [re.escape(x.strip()) for x in p.split("...")]
                        self.rows.append((re.compile(r"\s*.{0,120}?\s*".join(parts)), len(p),
                                          cells[1], section.replace(" ", "-")))

    def find(self, text, later=False):
        """HTML of the remedy of a message, "" if the page has none; later: after steps, for
        which a remedy of the start is none."""
        words = " ".join(text.split())
        found = [r for r in self.rows if r[0].search(words)]
        if not found:
            return ""
        _, _, remedy, section = max(found, key=lambda r: r[1])
        if later and remedy.startswith("at the start: "):
            remedy = remedy.split("; later: ")[1] if "; later: " in remedy else ""
        remedy = esc(re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", remedy), quote=False)
        remedy = re.sub("`([^`]*)`", r"<code>\1</code>", remedy)
        return (f'<p>{remedy} <a href="{esc(self.link)}#{section}">troubleshooting</a></p>')


def messages(runs, remedies, case):
    """Errors and warnings with their places; the same warning once."""
    found = {}
    for run in runs:
        for m in run.messages:
            key = m.kind, re.sub(r"[-+]?\d[\d.e+-]*", "#", m.text)
            found.setdefault(key, []).append(m)
            m.later = m.kind == "error" and bool(run.rows)
    parts = []
    for (kind, _), all_ in sorted(found.items(), key=lambda item: item[0][0] != "error"):
        m = all_[0]
        where = f"{os.path.relpath(m.log, case.path)}:{m.line}"
        more = f", {len(all_)} times, last at line {all_[-1].line}" if len(all_) > 1 else ""
        css = "note error" if kind == "error" else "note"
        text = m.text if len(m.text) < 3000 else m.text[:3000] + " ..."
        parts.append(f'<div class="{css}" data-line="{m.line}"><b>{kind}</b> '
                     f'<code>{esc(where)}</code>{more}<pre>{esc(text)}</pre>'
                     f"{remedies.find(m.text, m.later)}</div>\n")
    return "".join(parts)


# --- what is computed --------------------------------------------------------------

def entries(file, dictionary, meanings, name=""):
    """Rows of the entries of the dictionary of a file, or of one in it, with units, meanings."""
    rows = []
    for path, value in flat(dictionary[name] if name else dictionary).items():
        unit, meaning = meanings.find(file, f"{name}.{path}" if name else path, dictionary)
        if len(value) > 400:
            value = value[:400] + " ..."
        rows.append(row(f"<code>{esc(path)}</code>", f"<code>{esc(value)}</code>", esc(unit),
                        f'<span class="soft">{esc(meaning)}</span>'))
    return rows


def computed(dictionaries, meanings, conditions, mesh, head):
    """Phases, mesh, conditions, schemes and time control."""
    parts = []
    if head:
        parts.append(f"<h3>As the log says</h3><pre>{esc(chr(10).join(head))}</pre>")
    columns = ("entry", "value", "unit", "meaning")
    phases = dictionaries.get(FILES[0], {})
    parts.append("<h3>Phases and their laws</h3>")
    rows = []
    for name, data in phases.items():
        if isinstance(data, dict):
            rows.append(f'<tr class="group"><td colspan="4">{esc(name)}</td></tr>\n')
            rows += entries(FILES[0], phases, meanings, name)
        else:
            rows += entries(FILES[0], {name: data}, meanings)
    parts.append(table(columns, rows))
    if mesh:
        parts.append(f"<h3>Mesh</h3><p>{mesh['cells']} cells at the start</p>")
        fields = list(conditions)
        rows = [row(f"<code>{esc(p)}</code>", esc(kind), n, *(
            esc(words(conditions[f], p)) for f in fields))
            for p, (kind, n) in mesh["patches"].items()]
        parts.append(table(["patch", "type", "faces", *fields], rows))
    for title, file in (
            ("Where the points are", "system/setMaterialPointsDict"),
            ("Where the fluids are", "system/setFluidsDict"),
            ("Schemes", "system/fvSolution"), ("", "system/fvSchemes"),
            ("Time control and output", "system/controlDict"),
            ("Gravity", "constant/g"), ("Adaptive mesh", "system/adaptiveMeshDict"),
            ("Processors", "system/decomposeParDict"),
            ("Blocks of the mesh", "system/blockMeshDict")):
        if dictionaries.get(file):
            parts.append((f"<h3>{title}</h3>" if title else "")
                         + f'<details{" open" if title in ("Schemes",) else ""}><summary>'
                         f"<code>{file}</code></summary>"
                         + table(columns, entries(file, dictionaries[file], meanings))
                         + "</details>")
    return "".join(parts)


def words(patches, name):
    """The condition of a patch in a few words; patterns of names count too."""
    data = patches.get(name)
    if data is None:
        for key, value in patches.items():
            try:
                if re.fullmatch(key.strip('"'), name):
                    data = value
            except re.error:
                pass
    if not isinstance(data, dict):
        return ""
    rest = {k: v for k, v in flat(data).items() if k != "type" and len(v) < 60}
    return " ".join([data.get("type", "")] + [f"{k} {v};" for k, v in rest.items()])


# --- numbers -------------------------------------------------------------------------

#: Numbers of the log that count fix-ups, or what they did
FIXUPS = ("outflow limited", "theta kept", "pressure of relaxation kept", "isentropic", "voids",
          "energy added", "mass held back", "kept positive at faces")


def numbers(history, other, name, guide):
    """All numbers of the log: at the first and last report, smallest and largest. guide: link to
    the page with the section on fix-ups."""
    of = {(h, n): v for h, n, _, v in quantities(other)} if other else {}
    rows, group = [], None
    for head, quantity, unit, v in quantities(history):
        some = v[np.isfinite(v)]
        if not len(some):
            continue
        if head != group:
            rows.append(f'<tr class="group"><td colspan="{9 if other else 6}">'
                        f"{esc(head)}</td></tr>\n")
            group = head
        cells = [number(x) for x in (some[0], some[-1], some.min(), some.max())]
        if other:
            w = of.get((head, quantity), np.zeros(0))
            w = w[np.isfinite(w)]
            cells += [number(x) for x in (w[-1], w.min(), w.max())] if len(w) else [""]*3
        what = esc(label(quantity))
        if quantity in FIXUPS and re.match("Gas |Fluids", head):
            what = f'<a href="{esc(guide)}#fix-ups">{what}</a>'
            share = heldBack(history, head)
            if quantity == "mass held back" and np.isfinite(share):
                what += f", {share:.3g} % of the mass"
        rows.append(f'<tr data-key="{esc(head)}|{esc(quantity)}">'
                    f"<td>{what}</td>"
                    f"<td>{esc(unit)}</td>" + "".join(f'<td class="n">{c}</td>' for c in cells)
                    + "</tr>\n")
    return table(["quantity", "unit", "first report", "last", "smallest", "largest"]
                 + ([f"{x} of {name}" for x in ("last", "smallest", "largest")]
                    if other else []), rows)


def limiters(history):
    total = sum(n for _, n, _, _ in history.limiters())
    rows = [row(esc(who), f"{100*n/total:.3g} %", number(least), esc(last))
            for who, n, least, last in history.limiters()]
    return table(["time step set by", "of the reports", "smallest [s]", "last time"],
                 rows) if rows else ""


def stepParts(text):
    """The parts of a step's wall time as bars."""
    parts = re.findall(r"([a-z][\w ]*?) ([\d.]+) %", text.split(":", 1)[-1])
    if not parts:
        return ""
    return "<h3>Where the time of the steps went</h3>" + f"<p>{esc(text.split(':')[0])}</p>" \
        '<table class="bars">' + "".join(
            f'<tr><td>{esc(name)}</td><td class="n">{share} %</td><td style="width:200px">'
            f'<div class="bar" style="width:{min(100, float(share)):.1f}%"></div></td></tr>'
            for name, share in parts) + "</table>"


def xtDiagrams(tables):
    """Pictures of tables whose columns are bins of a place."""
    from mpm.pictures import SIGNED, VALUES, colourBar, plt
    from mpm.reportPictures import scale
    parts = []
    for one in tables:
        if not one.bins or one.data.shape[0] < 2 or one.data.shape[1] < 3:
            continue
        try:
            places = np.array([float(c) for c in one.columns[1:]])
        except ValueError:
            continue
        t, v = one.data[:, 0], one.data[:, 1:]
        (length, long), (duration, short) = scale(np.abs(places).max()), scale(t[-1])
        low, high = np.nanpercentile(v, (0.5, 99.5))
        signed = low < 0 < high
        size = max(-low, high)
        figure, ax = plt.subplots(figsize=(5.2, 3.4))
        image = ax.pcolormesh(length*places, duration*t, v, rasterized=True,
                              cmap=SIGNED if signed else VALUES,
                              vmin=-size if signed else low, vmax=size if signed else high)
        ax.set(xlabel=f"place [{long}m]", ylabel=f"time [{short}s]")
        colourBar(figure, image, ax, one.title.split(" of ")[0])
        buffer = io.BytesIO()
        figure.savefig(buffer, format="jpeg", dpi=100, pil_kwargs={"quality": 85})
        plt.close(figure)
        parts.append(
            '<figure><img alt="x-t diagram" src="data:image/jpeg;base64,'
            f'{base64.b64encode(buffer.getvalue()).decode()}">'
            f"<figcaption>{esc(one.function)}: {esc(one.title)}</figcaption></figure>")
    return f'<div class="pictures">{"".join(parts)}</div>' if parts else ""


def otherTables(tables, of=""):
    """Tables that are not over time, as they are; of: the other run whose they are."""
    parts = []
    for one in tables:
        if one.overTime or one.bins or one.data.shape[0] > 200 or one.data.shape[1] > 40:
            continue
        rows = [row(*(f"{v:.6g}" if np.isfinite(v) else "" for v in r)) for r in one.data]
        parts.append(f"<h3>{esc(one.function)}: {esc(one.name)}{esc(of)}</h3>"
                     f'<p class="soft">{esc(one.title)}</p>' + table(one.columns, rows))
    return "".join(parts)


# --- plots -----------------------------------------------------------------------------

def still(plot, factor, timeLabel, name):
    """A plot as SVG, where there is no script that draws it."""
    from mpm.pictures import plt
    figure, ax = plt.subplots(figsize=(4.6, 2.5))
    for run, lines in enumerate((plot.lines, plot.other)):
        for k, (title, t, y) in enumerate(lines):
            some = np.unique(np.linspace(0, len(t) - 1, 300).astype(int))
            ax.plot(factor*t[some], y[some], f"C{k % 10}" + ("--" if run else ""), lw=1,
                    label=title + (f" ({name})" if run else ""))
    ax.set(xlabel=timeLabel, ylabel=plot.axis)
    if plot.log:
        ax.set_yscale("log")
    ax.legend(fontsize=6)
    buffer = io.StringIO()
    figure.savefig(buffer, format="svg")
    plt.close(figure)
    svg = buffer.getvalue()
    # Names of parts that are those of this plot alone
    own = zlib.crc32(f"{plot.section} {plot.title} {plot.unit}".encode())
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg[svg.index("<svg"):], flags=re.S)
    return re.sub(r'(id="|url\(#|href="#)', rf"\g<1>s{own}", svg)


def plotBoxes(plots, first, zoom, draw):
    """The places of plots, in sections; of those that stay the same their values."""
    parts, sections = [], {}
    for i, plot in enumerate(plots, first):
        sections.setdefault(plot.section, []).append((i, plot))
    for title, some in sections.items():
        shown = [(i, p) for i, p in some if not p.zero() and not p.constant()]
        zero = [p.title for _, p in some if p.zero()]
        constant = [p.constant() for _, p in some if p.constant() and not p.zero()]
        parts.append(f"<h3>{esc(title)}</h3>")
        if shown:
            parts.append('<div class="plots">')
        for i, plot in shown:
            unit = f" [{plot.unit}]" if plot.unit else ""
            inside = '<div class="legend"></div><div class="canvas"></div>' if zoom \
                else draw(plot)
            comment = f'<p class="soft">{esc(plot.comment)}</p>' if plot.comment else ""
            parts.append(f'<div class="plot" id="plot{i}"><h4>{esc(plot.title + unit)}</h4>'
                         f"{comment}{inside}</div>\n")
        if shown:
            parts.append("</div>")
        if zero:
            parts.append(f'<p class="soft">Zero all the time: {esc(", ".join(zero))}</p>')
        if constant:
            parts.append('<p class="soft">The same all the time, to six digits or nearly: '
                         f'{esc("; ".join(constant))}</p>')
    return "".join(parts)


def script(name, data):
    """Data for the script; no text in it can end the element."""
    text = json.dumps(data, separators=(",", ":")).replace("<", "\\u003c")
    return f'<script type="application/json" id="{name}">{text}</script>\n'


def ago(seconds):
    for size, unit in ((86400, "day"), (3600, "hour"), (60, "minute")):
        if seconds >= size:
            n = int(seconds//size)
            return f"{n} {unit}{'s' if n > 1 else ''}"
    return f"{seconds:.0f} s"


def document(title, body, data, refresh):
    """The file: style, body, data and scripts."""
    parts = []
    for name in ("reportPage.css", "reportPage.js"):
        with open(os.path.join(HERE, name), encoding="utf-8") as f:
            parts.append(f.read())
    zoom = dygraphs()
    style = parts[0] + (zoom[1] if zoom else "")
    head = (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f'<link rel="icon" href="data:,">\n<title>{esc(title)}</title>\n'
            f"<style>\n{style}</style>\n</head>\n<body>\n")
    code = f"<script>\n{parts[1]}</script>\n"
    if zoom:
        code = f"<script>{zoom[0]}</script>\n" + code
    data["page"].update(zoom=bool(zoom), refresh=refresh)
    made = time.strftime("%Y-%m-%d %H:%M:%S")
    return (head + body + f"<footer>Made by mpmReport of materialPointFoam, {made}."
            " Drag over a plot to zoom, double click: all; with the keyboard + - arrows, 0:"
            " all.</footer>\n" + "".join(script(n, d) for n, d in data.items()) + code
            + "</body>\n</html>\n")
