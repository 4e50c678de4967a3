"""Rules of mpmCheck for the start: regions of setFields, pressures in bodies, what holds them,
probes.

A rule is a function of the facts (mpm.checkFacts) that gives its findings, as in mpm.checkRules.
"""

import os
import re

import numpy as np

from mpm.checkFacts import CONTROL, REGIONS
from mpm.checkFinding import Finding
from mpm.dictionaries import DictionaryError, parse, value
from mpm.files import readLists

SETFIELDS = "system/setFieldsDict"
#: Pairs of points that are compared, at most
PAIRS = 2e7


def _isRigid(facts, name):
    return facts.of(name).get("type") == "rigid"


def _field(facts, name):
    """The velocity field of a phase."""
    return str(facts.of(name).get("velocityField", name))


def _bodies(facts):
    """Regions of phases that deform: (name, phase, dictionary, size, low, high)."""
    for name, (_, size, low, high) in facts.boxes().items():
        region = facts.regions.get(name)
        phase = region.get("phase") if isinstance(region, dict) else None
        if phase in facts.phases and facts.phases[phase].n and not _isRigid(facts, phase) \
                and len(facts.phases[phase].cells) == facts.phases[phase].n:
            yield name, phase, region, size, low, high


def _inside(facts, phase, low, high):
    """Which points of a phase lie in a box, as it is printed; of a mesh of one layer it is flat."""
    x, near = facts.phases[phase].x, 1e-3*(high - low)
    return ((x >= low - near) & (x <= high + near))[:, facts.axes].all(axis=1)


# --- fields --------------------------------------------------------------------

def _shapes(text):
    """Regions of cells in setFieldsDict: (type, values by field)."""
    for found in re.finditer(r"\b(\w+ToCell)\s*\{", text):
        end, depth = found.end(), 1
        while depth and end < len(text):
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        body = text[found.end():end - 1]
        try:
            words = value(body, parse(body)).get("fieldValues")
        except DictionaryError:
            continue
        if isinstance(words, list) and len(words) % 3 == 0:
            yield found[1], dict(zip(words[1::3], words[2::3]))


def emptyRegions(facts):
    """Regions of setFields whose values no cell has at the start."""
    case = facts.case
    if not os.path.exists(case.file(SETFIELDS)):
        return
    try:
        text = case.get(SETFIELDS).get("regions")
    except DictionaryError:     # setFields says what is wrong
        return
    for i, (kind, values) in enumerate(_shapes(text) if isinstance(text, str) else (), 1):
        has, known = np.ones(facts.nCells, bool), bool(values)
        for name, v in values.items():
            known &= os.path.exists(case.file("0", str(name))) and not isinstance(v, str)
            if known:
                a = np.asarray(case.field("0", name), float)
                off = abs(a - np.asarray(v, float))
                near = off <= 1e-6*np.maximum(abs(a), 1e-30)
                has &= near.all(axis=-1) if np.ndim(v) else near
        if known and not has.any():
            words = ", ".join(f"{n} {v:g}" for n, v in values.items() if not np.ndim(v))
            yield Finding("warning", SETFIELDS, f"regions, {kind} (no. {i})", "no cell starts with "
                          f"its values{f' ({words})' if words else ''}: the shape has no cell, or "
                          "others cover it", "a shape in the mesh, in m; setFields again if the "
                          "fields are older", "fluids.md#gas", "Cannot find any cellZone")


def pressedInside(facts):
    """Bodies of a given pressure in whose cells that of the start jumps to another."""
    p = facts.pressure
    for name, phase, region, _, low, high in _bodies(facts) if len(p) else ():
        own = region.get("pressure")
        if region.get("stress") != "ambient" or not isinstance(own, (int, float)):
            continue
        points = facts.phases[phase].cells[_inside(facts, phase, low, high)]
        count = np.bincount(points, minlength=facts.nCells)
        # Cells at the outside are cut: what loads the body may be there
        full = count >= facts.phases[phase].mean
        other = full & ((own < 0.9*p) | (own > 1.1*p))
        if not other.any() or other[full].all() or not _jumps(facts, p, count > 0):
            continue
        least, most = p[other].min(), p[other].max()
        yield Finding("note", REGIONS, f"regions.{name}", f"starts with {own:g} Pa, and p of the "
                      f"start jumps in its cells: {count[other].sum()} of its {len(points)} points "
                      f"have {f'{least:g} to ' if least < 0.999*most else ''}{most:g} Pa around "
                      "them",
                      f"a shape in setFieldsDict or setFluidsDict that ends at {name}",
                      "fluids.md#gas", rf"Region {name} starts with the pressure")


def _jumps(facts, p, cells):
    """Does p jump between neighbours of some cells, by more than weight does?"""
    neighbour = readLists(facts.case.file("constant/polyMesh/neighbour"))
    owner = readLists(facts.case.file("constant/polyMesh/owner"))[:len(neighbour)]
    both = cells[owner] & cells[neighbour]
    a, b = p[owner[both]], p[neighbour[both]]
    weight = 2*max(facts.rho.values(), default=0)*float(np.linalg.norm(facts.g()))*facts.width
    return bool((abs(a - b) > 0.1*np.maximum(a, b) + weight).any())


# --- bodies --------------------------------------------------------------------

def _between(facts, a, b):
    """Gap between the boxes of the points of two phases [m], and in cells of the larger; None: it
    is not known, or far."""
    a, b = sorted((facts.phases[a], facts.phases[b]), key=lambda p: p.n, reverse=True)
    at = facts.axes
    if not len(a.half) or not len(b.half) or len(a.cells) != a.n:
        return None
    reach = 2*facts.lengths[a.cells].max(axis=0)
    i = np.flatnonzero(((a.x >= b.low - reach) & (a.x <= b.high + reach))[:, at].all(axis=1))
    j = np.flatnonzero(((b.x >= a.low - reach) & (b.x <= a.high + reach))[:, at].all(axis=1))
    if not len(i) or not len(j) or len(i)*len(j) > PAIRS:
        return None
    best = None
    for k in j:
        gap = np.maximum(0, abs(a.x[i] - b.x[k]) - a.half[i] - b.half[k])[:, at]
        far = np.sqrt((gap**2).sum(axis=1))
        n = int(far.argmin())
        if best is None or far[n] < best[0]:
            d = at[int(gap[n].argmax())]
            best = float(far[n]), float(far[n]/facts.lengths[a.cells[i[n]], d])
    return best


def clamps(facts, name):
    """Rigid bodies of the velocity field of a phase, in a cell with it."""
    gaps = {other: _between(facts, name, other) for other in facts.phases if _isRigid(facts, other)
            and _field(facts, other) == _field(facts, name)}
    return [other for other, gap in gaps.items() if gap and gap[1] < 1]


def _fixed(facts):
    """Rigid bodies at rest that stay so."""
    for name, phase in facts.phases.items():
        motion = facts.of(name).get("motion", {})
        if phase.n and _isRigid(facts, name) and isinstance(motion, dict) \
                and motion.get("type", "fixed") == "fixed":
            yield name


def nearlyHeld(facts):
    """A clamp that ends short of what it is to hold, by a part of a cell."""
    if np.linalg.norm(facts.g()):
        return
    for clamp in _fixed(facts):
        for name, phase in facts.phases.items():
            if not phase.n or _isRigid(facts, name) or phase.U \
                    or _field(facts, name) != _field(facts, clamp):
                continue
            gap = _between(facts, name, clamp)
            if gap and 1e-3 < gap[1] < 1:
                yield Finding("note", REGIONS, f"regions of {clamp}", f"{clamp} and {name} are "
                              f"{gap[0]:.3g} m apart, {gap[1]:.2g} cells: {clamp} holds what is "
                              "in a cell with it, as if they touched", "the region of one up to "
                              "that of the other; or two cells and more between them",
                              "bodies.md#rigid-bodies")


def probesAway(facts):
    """Probes at the nearest point, which is far."""
    functions = facts.control.get("functions", {})
    for entry, of in functions.items() if isinstance(functions, dict) else ():
        of = of if isinstance(of, dict) else {}
        phase, points = facts.phases.get(of.get("phase")), of.get("points")
        places = points.get("nearest") if isinstance(points, dict) else None
        if of.get("type") != "materialPointProbes" or phase is None or not phase.n \
                or not isinstance(places, list) or len(phase.cells) != phase.n:
            continue
        for place in places:
            if not isinstance(place, list) or len(place) != 3 or any(
                    not isinstance(c, (int, float)) for c in place):
                continue
            far = np.sqrt(((phase.x - place)[:, facts.axes]**2).sum(axis=1))
            k = int(far.argmin())
            width = float(facts.lengths[phase.cells[k], facts.axes].max())
            if far[k] > 1.5*width:
                yield Finding("note", CONTROL, f"functions.{entry}.points", "the point nearest to "
                              f"({' '.join(f'{c:g}' for c in place)}) is {far[k]:.3g} m away, "
                              f"{far[k]/width:.2g} cells", f"a place in {of['phase']}, in m",
                              "output.md#function-objects")


RULES = (emptyRegions, pressedInside, nearlyHeld, probesAway)
