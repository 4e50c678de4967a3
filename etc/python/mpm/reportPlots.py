"""Plots over time for mpm.report: what the log and the tables of postProcessing have, in
sections, thinned so that the page stays small.

    plots = logPlots(history) + tablePlots(tables)      # of one run
    together(plots, plotsOfAnother, "name")             # with the lines of another run
    data = packed(plots, factor)                        # for the page
"""

import os
import re

import numpy as np

from mpm.reportColours import ofPressure

#: Numbers of all plots of a page, times and values
ROOM = 110000
#: Columns of a table that are drawn as lines; of more the least, mean and largest
LINES = 10
#: A constant part so many times larger than all changes of a plot is left out of its lines
FLAT = 20

_UNITS = {"kinetic": "J", "strain": "J", "total": "J", "energy": "J", "stored": "J",
          "energy added": "J", "mass": "kg", "mass held back": "kg", "momentum": "kg m/s",
          "p": "Pa", "p to": "Pa", "force": "N", "impulse": "N s", "gap": "m", "T": "K",
          "T to": "K", "moment": "N m"}
#: Heads of the log that other plots have, or that say nothing over time
_LEFT = {"Time", "Progress", "ExecutionTime", "deltaT", "deltaT set by", "Courant Number mean",
         "Courant Number of points"}
SECTIONS = ("Energy", "Mass and momentum", "Volume fractions, pressure", "Time step and speed",
            "Contact, loads and others")


class Plot:
    """Lines over time: lines is a list of (name, times, values)."""

    def __init__(self, section, title, unit, lines, log=False, comment=""):
        self.section, self.title, self.unit = section, title, unit
        self.lines, self.log, self.comment = lines, log, comment
        self.other, self.digits, self.axis = [], 1e-12, unit

    def zero(self):
        return all(not np.any(np.nan_to_num(y)) for _, _, y in self.lines + self.other)

    def constant(self):
        """Values of lines that all stay the same, to rounding; "" of others."""
        words = []
        for name, t, y in self.lines + self.other:
            known = np.isfinite(y)
            some = y[known]
            if not len(some) or np.ptp(some) > self.digits*abs(some[0]):
                return ""
            # Of what is not in every report: from when to when
            when = "" if known.all() else f" (from {t[known][0]:.4g} to {t[known][-1]:.4g} s)"
            if np.ptp(some) > 1e-12*abs(some[0]):
                words.append(f"{name} {some.min():.6g} to {some.max():.6g}{when}")
                continue
            words.append(f"{some[0]:.6g}{when}" if name == "value" else
                         f"{name} {some[0]:.6g}{when}")
        return f"{self.title} [{self.unit}]: {', '.join(words)}" if self.unit else \
            f"{self.title}: {', '.join(words)}"

    def changes(self):
        """Energies whose constant part would flatten all lines: their changes in its place."""
        if self.unit != "J" or len(self.lines) < 2 or self.constant():
            return
        lines = [y[np.isfinite(y)] for _, _, y in self.lines]
        most = FLAT*max((np.ptp(y) for y in lines if len(y)), default=0)
        large = {line[0]: y[0] for line, y in zip(self.lines, lines)
                 if len(y) and np.abs(y).min() > most}
        if not large:
            return
        for some in (self.lines, self.other):
            some[:] = [(name, t, y - y[np.isfinite(y)][:1] if name in large else y)
                       for name, t, y in some]
        self.axis = "J, changes since the start"
        starts = ", ".join(f"{n} {v:.6g} J" for n, v in large.items())
        digits = " (the log has six digits)" if self.digits > 1e-6 else ""
        self.comment = f"at the start: {starts}{digits}. {self.comment}".strip()

    def pressures(self):
        """Pressures that change in kPa, MPa or GPa."""
        if self.unit != "Pa" or self.constant():
            return
        known = [np.abs(y[np.isfinite(y)]).max(initial=0) for _, _, y in self.lines + self.other]
        factor, self.unit = ofPressure(max(known, default=0))
        self.axis = self.unit
        for some in (self.lines, self.other):
            some[:] = [(name, t, factor*y) for name, t, y in some]

    def withoutZeros(self):
        """Lines that are zero, or rounding beside the others, lie over the axis: said."""
        size = [np.nanmax(np.abs(y)) if np.isfinite(y).any() else 0 for _, _, y in self.lines]
        zero = [line[0] for line, s in zip(self.lines, size) if s <= 1e-12*max(size)]
        if zero and not self.zero():
            self.lines = [line for line in self.lines if line[0] not in zero]
            self.comment = f"{self.comment} (zero: {', '.join(zero)})".strip()
        return self


def unitOf(head, name):
    """Unit of a number of the log."""
    if head.startswith("Energy"):
        return "J"
    if name.startswith("mass "):
        return "kg"
    if head.startswith("Heat of") and not name:
        return "J"
    if head in ("Time", "deltaT", "ExecutionTime") or name == "about":
        return "s"
    if head == "Progress" and not name:
        return "%"
    return _UNITS.get(name, "")


def label(name):
    """What is said of a number of the log: "p to" is the largest of "p"."""
    if name.endswith(" to"):
        return f"{name[:-3]}, largest"
    return {"": "value", "about": "time left, about"}.get(name, name)


def quantities(history):
    """(head, name, unit, values) of all numbers of the log; of vectors by components."""
    for head, name in history.keys:
        if head == "deltaT set by":
            continue
        if history.isVector(head, name):
            v = history.vectors(head, name)
            for k in range(v.shape[1]):
                yield head, f"{name} {'xyz'[k]}".strip(), unitOf(head, name), v[:, k]
        else:
            values = history.series(head, name)
            if head.startswith("Steps of the points"):      # the log leaves out a single one
                values = np.where(np.isnan(values), 1, values)
            yield head, name, unitOf(head, name), values


def section(head, unit):
    if head.startswith("Energy") or unit == "J" and not head.startswith("Eroded"):
        return SECTIONS[0]
    if re.match("Theta|Gas|Fluids", head) and unit in ("", "Pa"):
        return SECTIONS[2]
    if unit in ("kg", "kg m/s") and not head.startswith("Eroded"):
        return SECTIONS[1]
    if re.match("Steps of|Adaptive mesh", head):
        return SECTIONS[3]
    return SECTIONS[4]


def logPlots(history):
    """Plots of the log: lines of one head and unit together; the time step, the speed."""
    if len(history.rows) < 1:
        return []
    groups = {}
    for head, name, unit, values in quantities(history):
        if head not in _LEFT:
            groups.setdefault((head, unit), []).append((label(name), history.times, values))
    plots = []
    for (head, unit), lines in groups.items():
        what = {"kg": "mass", "kg m/s": "momentum", "Pa": "pressure", "N": "force",
                "N s": "impulse", "m": "gap", "K": "temperature",
                "s": "time", "J": "" if head.startswith("Energy") else "energy"}.get(unit, "")
        plots.append(Plot(section(head, unit), head + (f": {what}" if what else ""), unit,
                          lines).withoutZeros())
        held = heldBack(history, head) if not unit else np.nan
        if np.isfinite(held) and {"outflow limited", "theta kept"} & {
                name for name, _, _ in plots[-1].lines} and not plots[-1].zero():
            plots[-1].comment = (
                "Fix-ups are counts, one for each cell and step. The mass held back by all of them"
                f" is {held:.3g} % of the mass. {plots[-1].comment}").strip()
    step = history.series("deltaT")
    if np.isfinite(step).any():
        plots.append(Plot(SECTIONS[3], "time step", "s", [("deltaT", history.times, step)],
                          log=np.nanmax(step) > 5*np.nanmin(step) > 0))
    number = [(n, h) for n, h in (("largest", "Courant Number mean"),
                                  ("of points", "Courant Number of points"))
              if h in {k for k, _ in history.keys}]
    if number:
        plots.append(Plot(SECTIONS[3], "Courant number", "", [
            (n, history.times, history.series(h)) for n, h in number]))
    plots += speedPlots(history)
    for plot in plots:
        plot.digits = 5e-5      # ten times what six digits of the log resolve
    plots.sort(key=lambda p: SECTIONS.index(p.section))
    return plots


def heldBack(history, head):
    """Mass that the limits of the outflow held back by all fix-ups until now [% of the mass beside
    it] of a gas or the fluids; nan of others."""
    held = history.series(head, "mass held back")
    mass = sum((history.series(head, n) for n in history.names(head)
                if re.fullmatch(r"mass( [\w.]+)?", n)), np.zeros(len(held)))
    known = np.isfinite(held) & (mass > 0)
    return 100*held[known][-1]/mass[known][-1] if known.any() else np.nan


def speedPlots(history):
    rate, _ = history.rate()
    if not np.isfinite(rate).any():
        return []
    points, cells = history.size()
    lines = [(name, history.times, 1e-6*rate*n) for name, n in (
        ("point-steps", points), ("cell-steps", np.broadcast_to(cells, rate.shape)))
        if np.isfinite(n).any()]
    return [Plot(SECTIONS[3], "speed", "million a second", lines,
                 comment="steps times points (cells) over CPU time")] if lines else []


def tablePlots(tables):
    """Plots of the tables over time of postProcessing: columns of one unit together."""
    plots = []
    for table in tables:
        if not table.overTime or table.bins:
            continue
        t = table.data[:, 0]
        name = os.path.splitext(table.name)[0]
        for unit, columns in table.groups():
            data = table.data[:, columns]
            heads = [re.sub(r"\[[^]]*\]$", "", table.columns[c]) for c in columns]
            heads = short(heads)
            kinds = {re.sub(r"\d+|\W", "", h) for h in heads}
            # The place of angular momentum is none of the others'
            said = table.title if unit == "kg.m2/s" else re.sub(
                ", angular momentum about .*", "", table.title)
            if len(columns) > LINES and len(kinds) > 3:
                # Terms of their own: the ten that change most
                some = np.sort(np.argsort(-np.ptp(data, axis=0), kind="stable")[:LINES])
                lines = [(heads[k], t, data[:, k]) for k in some]
                comment = f"the {LINES} of {len(columns)} columns that change most. {said}"
            elif len(columns) > LINES:
                lines = [(what, t, f(data, axis=1)) for what, f in (
                    ("least", np.min), ("mean", np.mean), ("largest", np.max))]
                comment = f"of {len(columns)} columns. {said}"
            else:
                lines = [(h, t, data[:, k]) for k, h in enumerate(heads)]
                comment = said
            what = heads[0] if len(columns) == 1 else ""
            along = {h[-2:] for h in heads if re.match("(min|max|centre)_[xyz]$", h)}
            if len(along) == 1 and len(heads) == 3:
                what = f"along {along.pop()[-1]}"
                if np.ptp(data) <= 1e-9*np.abs(table.data[:, 1:10]).max():
                    continue        # the direction that a case in 2D has not
                lines = [(h[:-2], t, v) for h, t, v in lines]
            title = f"{table.function}: {name}"
            title += f", {what}" if what not in (name, "") else ""
            plots.append(Plot(table.function, title, unit, lines,
                              comment=comment).withoutZeros())
    return plots


def short(names):
    """Names of columns without the number of the point, where there is only one; of several with
    the place in their order: the numbers of points differ between meshes."""
    numbers = list(dict.fromkeys(m for n in names for m in re.findall(r"\((\d+)\)$", n)))
    place = {n: f", place {k}" if len(numbers) > 1 else "" for k, n in enumerate(numbers, 1)}
    return [re.sub(r"\((\d+)\)$", lambda m: place[m[1]], n) for n in names]


def probes(tables):
    """Largest values of the columns of materialPointProbes, and of the places of blastProbes and
    OpenFOAM's probes if they are no more than LINES: (what, value, unit, time)."""
    found = []
    for table in tables:
        ofPoints = re.match(r"Phase \S+, \d+ points", table.title)
        if not table.overTime or not ofPoints and not 0 < len(table.places) <= LINES:
            continue
        of = "" if ofPoints else os.path.splitext(table.name)[0] + " at "
        for unit, columns in table.groups():
            heads = short([re.sub(r"\[[^]]*\]$", "", table.columns[c]) for c in columns])
            for head, c in zip(heads, columns):
                y = table.data[:, c]
                if np.isfinite(y).any() and np.nanmax(np.abs(y)) > 0:
                    k = np.nanargmax(np.abs(y))
                    found.append((f"{table.function}: {of}{head}", y[k], unit, table.data[k, 0]))
    return found


def together(plots, others):
    """The lines of another run to the plots that it has too; its other plots are left out."""
    known = {(p.title, p.unit): p for p in others}
    for plot in plots:
        match = known.get((plot.title, plot.unit))
        plot.other = match.lines if match else []


def thin(t, columns, n):
    """Places of about n rows that keep the extremes of all columns."""
    if len(t) <= n:
        return np.arange(len(t))
    parts = np.array_split(np.arange(len(t)), max(1, n//(2*len(columns))))
    keep = [0, len(t) - 1]
    for part in parts:
        for y in columns:
            v = np.nan_to_num(y[part], nan=0.0, posinf=0.0, neginf=0.0)
            keep += [part[v.argmin()], part[v.argmax()]]
    return np.unique(keep)


def _rounded(values, digits=6):
    return [float(f"{v:.{digits}g}") if np.isfinite(v) else None for v in values]


def shortName(name, own="", most=12):
    """Of another run for legends: of a long one the parts (between "-") in which it differs from
    this run's, of a part that is long its end."""
    if len(name) <= most:
        return name
    parts, of = (re.split(r"(?<!\de)-", n) for n in (name, own))
    if parts != of:
        while parts and of and parts[-1] == of[-1]:
            parts, of = parts[:-1], of[:-1]
        while len(parts) > 1 and of and parts[0] == of[0]:
            parts, of = parts[1:], of[1:]
    part = "-".join(parts) or name
    same = len(os.path.commonprefix([part[::-1], own[::-1]]))
    if most <= same + 1 and same < len(part) > most:    # its end says nothing
        part = part[:-same]
    return part if len(part) <= most else "…" + part[1 - most:]


def packed(plots, factor, name):
    """What the page draws: times by a factor (1e6: in us), all lines of a run at the same."""
    each = max(60, ROOM//max(1, sum(1 + len(p.lines) + len(p.other) for p in plots)))
    data = []
    for plot in plots:
        one = {"title": plot.title, "axis": plot.axis, "unit": plot.unit, "log": bool(plot.log),
               "id": f"{plot.title} {plot.unit}", "other": name, "t": [], "lines": []}
        for run, lines in enumerate((plot.lines, plot.other)):
            if not lines:
                continue
            t = lines[0][1]
            some = thin(t, [y for _, _, y in lines], min(each, 700))
            one["t"].append(_rounded(factor*t[some], 8))
            one["lines"] += [{"name": n if run == 0 else f"{n} ({name})", "of": n, "run": run,
                              "y": _rounded(y[some])} for n, _, y in lines]
        data.append(one)
    return data
