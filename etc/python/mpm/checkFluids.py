"""Rules of mpmCheck for a gas and fluids: at rest under gravity, around bodies, softened.

A rule is a function of the facts (mpm.checkFacts) that gives its findings, as in mpm.checkRules.
"""

import math
import os
import re

import numpy as np

from mpm.checkFacts import (CONTROL, FLUIDS, GRAVITY, LIQUIDS, PHASES, REGIONS, SOLUTION,
                            patchFaces)
from mpm.checkFinding import Finding
from mpm.files import readField, readLists

#: Conditions of U through which a fluid leaves
LETS_OUT = ("zeroGradient", "inletOutlet", "pressureInletOutletVelocity", "farField",
            "waveTransmissive", "advective")
#: Conditions of U of points that prescribe nothing
FREE = ("calculated", "zeroGradient")
#: Equations of state of liquids
LIQUID_STATES = ("stiffenedGas", "Tait")
#: Speed of sound below which a liquid is softened [m/s]
SOFT = 1000
#: Steps of fluids over one of the points from which sub-steps pay
SUBSTEPS = 4
#: Function objects that measure pressures
GAUGES = ("blastProbes", "materialPointPatchForces")


def number(value):
    """Pressures without powers of ten where they are short."""
    return f"{value:.0f}" if 100 <= abs(value) < 1e6 else f"{value:.4g}"


def _list(v):
    return "(" + " ".join(f"{c:.4g}" for c in v) + ")"


def start(facts):
    """Words on gravity, p and the velocity of the bodies at the start."""
    words = [f"gravity {_list(facts.g())}" if np.linalg.norm(facts.g()) else "no gravity"]
    if len(facts.pressure):
        low, high = facts.pressure.min(), facts.pressure.max()
        words.append(f"p {number(low)} Pa" if high - low < 1e-9*abs(high) else
                     f"p {number(low)} to {number(high)} Pa")
    for name, phase in facts.phases.items():
        if not phase.n:
            continue
        size = np.linalg.norm(phase.v, axis=1)
        if not size.max():
            words.append(f"{name} at rest")
        elif np.ptp(phase.v, axis=0).max() < 1e-9*size.max():
            words.append(f"{name} at {_list(phase.v[0])} m/s")
        else:
            words.append(f"{name} at {size.min():.4g} to {size.max():.4g} m/s")
    return ", ".join(words)


# --- gravity -------------------------------------------------------------------

def _down(facts):
    """Direction and size of gravity."""
    g = facts.g()
    size = float(np.linalg.norm(g))
    return (g/size if size else g), size


def equation(facts, name):
    """Type of the equation of state of a phase, "" of one that has none."""
    state = facts.of(name).get("equationOfState")
    return str(state.get("type", "")) if isinstance(state, dict) else ""


def _liquids(facts):
    """Fluids and gases whose equation of state is that of a liquid: cells full of each."""
    for name in facts.media:
        state = facts.of(name).get("equationOfState")
        if equation(facts, name) in LIQUID_STATES:
            wet = facts.share(name) > 0.5
            if wet.any():
                yield name, state, wet


def _height(facts, wet, down):
    """From the lowest to the highest of some cells [m]."""
    width = float(np.median(facts.widths[wet])) if len(facts.widths) else 0.0
    return float(np.ptp(facts.centres[wet] @ down)) + width


def _beside(facts, wet):
    """Patches: unit normals of their faces at some cells, outward."""
    x = readField(facts.case.file("constant/polyMesh/points"))
    faces = readLists(facts.case.file("constant/polyMesh/faces"))
    owner = readLists(facts.case.file("constant/polyMesh/owner"))
    return {patch: [_normal(x[faces[f]]) for f in range(first, first + n) if wet[owner[f]]]
            for patch, (first, n) in patchFaces(facts.case).items()
            if facts.patches.get(patch) not in ("empty", "wedge")}


def noGravity(facts):
    """A light and a heavy fluid without gravity, as far as the heavy one would fall: a liquid with
    a surface wants a word on it, a gas may go without."""
    rho = {n: r for n, r in facts.rho.items() if r > 0}
    if np.linalg.norm(facts.g()) or len(rho) < 2:
        return
    heavy, light = max(rho, key=rho.get), min(rho, key=rho.get)
    liquid = heavy in {n for n, _, _ in _liquids(facts)}
    fall = 9.81/2*facts.end**2*(rho[heavy] - rho[light])/(rho[heavy] + rho[light])
    if not fall > facts.width or rho[heavy] < (1.05 if liquid else 10)*rho[light]:
        return
    said = os.path.exists(facts.case.file(GRAVITY))     # that there is none
    yield Finding("warning" if liquid and not said else "note", GRAVITY, "", "there is no "
                  f"gravity, and {heavy} of {rho[heavy]:.4g} kg/m3 is beside {light} of "
                  f"{rho[light]:.4g}: till endTime it would fall by {fall:.3g} m",
                  f"value (0 -9.81 0) in {GRAVITY}, and hydrostatic in {FLUIDS}; value (0 0 0) if "
                  "there is none", "materials.md#body-forces")


def upsideDown(facts):
    """A heavier liquid that lies above a lighter one at the start."""
    down, size = _down(facts)
    liquids = [n for n, _, _ in _liquids(facts)] if size else []
    for name in liquids:
        for other in liquids:
            if facts.rho[name] < 1.001*facts.rho[other]:
                continue
            depths = [float(np.average(facts.centres @ down, weights=facts.share(n)*facts.V))
                      for n in (name, other)]
            if depths[0] < depths[1]:
                yield Finding("note", PHASES, f"{name}.rho", f"{name} of {facts.rho[name]:.4g} "
                              f"kg/m3 lies above {other} of {facts.rho[other]:.4g} kg/m3",
                              f"is it meant? Else mind rho, or the places in {FLUIDS}",
                              "fluids.md#several-fluids")


def slipOnAnyCells(facts):
    """Water that slips along bodies on other cells than boxes with large steps."""
    Co = facts.control.get("maxCoGas", 0.4)
    if facts.lattice or not isinstance(Co, (int, float)) or Co <= 0.4 + 1e-9 \
            or not list(_liquids(facts)):
        return
    for name, phase in facts.phases.items():
        drag = facts.of(name).get("drag")
        if phase.n and isinstance(drag, dict) and drag.get("direction") == "normal":
            yield Finding("note", CONTROL, "maxCoGas", f"{Co:g}: where the liquid slips along "
                          f"{name} on cells that are no boxes, the pressure in its pores may swing",
                          "maxCoGas 0.4", "fluids.md#points-in-a-gas")


def notAtRest(facts):
    """Liquids under gravity whose p at the start does not bear them."""
    down, size = _down(facts)
    if not size or not len(facts.pressure) or "hydrostatic" in facts.fluidStart:
        return
    for name, _, wet in _liquids(facts):
        height, p = _height(facts, wet, down), facts.pressure[wet]
        weight = facts.rho[name]*size*height
        if not weight or np.ptp(p) > 0.1*weight:
            continue
        stands = any(n @ down > 0.1 for patch, normals in _beside(facts, wet).items()
                     for n in normals)
        top = facts.centres[np.argmin(facts.centres @ down)]
        yield Finding("warning" if stands else "note", *(
            (FLUIDS, "") if facts.fluidStart else ("0/p", "internalField")), f"{name} starts with "
            f"the same p above and below, {number(p.mean())} Pa: under gravity it sinks until its "
            f"weight is borne and rings, by up to 2 rho g H = {number(2*weight)} Pa (H "
            f"{height:.3g} m)", f"hydrostatic {{ point {_list(top)}; p "
            f"{number(facts.pressure.min())}; }} in {FLUIDS}, in place of p in default",
            "fluids.md#fluids-at-the-start-setfluids", r"steps of its own .*startValues")


def runsOut(facts):
    """Sides below or beside a liquid through which it leaves; without gravity all are beside it.
    Beside it zeroGradient alone, which setFluids gives: the others are chosen to be open."""
    down, size = _down(facts)
    liquids = [n for n, _, _ in _liquids(facts)
               if os.path.exists(facts.case.file("0", "alpha." + n))]
    if not liquids or not os.path.exists(facts.case.file("0/U")):
        return
    lets = {p: of["type"] for p, of in facts.conditions("0/U").items()
            if of.get("type") in LETS_OUT}
    wet = sum(facts.case.field("0", "alpha." + n)*np.ones(facts.nCells) for n in liquids) > 0.5
    for patch, normals in _beside(facts, wet).items():
        steepest = max((float(n @ down) for n in normals), default=-1)
        below = steepest > 0.1
        if patch not in lets or steepest < -0.1 or not below and lets[patch] != "zeroGradient":
            continue
        yield Finding("warning" if below else "note", "0/U", f"boundaryField.{patch}",
                      f"{lets[patch]} lets {' and '.join(liquids)} out: {len(normals)} faces of "
                      f"{patch} ({facts.patches.get(patch)}) are {'below' if below else 'beside'} "
                      "it", "a wall has type wall in constant/polyMesh/boundary (setFluids gives "
                      "it slip), or slip in 0.orig/U; then setFluids again. If it is open, ignore "
                      "this",
                      "meshes.md#what-patches-need")


def unheld(facts):
    """Open sides under gravity at which nothing holds the pressure: what comes in has no bound."""
    if not np.linalg.norm(facts.g()) or not list(_liquids(facts)) \
            or not all(os.path.exists(facts.case.file(f)) for f in ("0/U", "0/p")):
        return
    p = facts.conditions("0/p")
    for patch, of in facts.conditions("0/U").items():
        if facts.patches.get(patch) == "patch" and of.get("type") == "zeroGradient" \
                and p.get(patch, {}).get("type") == "zeroGradient":
            yield Finding("warning", "0/p", f"boundaryField.{patch}", f"nothing holds the pressure "
                          f"at {patch}: p and U are zeroGradient, and what comes in there has no "
                          "bound (air over a pond gained 16 % in 0.2 s)", "farField for p and U in "
                          "0.orig, then setFluids again; a wall has type wall in "
                          "constant/polyMesh/boundary", "meshes.md#what-patches-need")


def nowhere(facts):
    """A fluid that setFluids has put into no cell, though it is what fills the rest."""
    rest = (facts.fluidStart.get("default") or {}).get("fluid") if facts.fluidStart else None
    if rest in facts.media and not facts.share(rest).any():
        yield Finding("warning", FLUIDS, "regions", f"{rest}, which is to be in what no region "
                      "fills, is nowhere: the regions fill the whole mesh", "sizes in m: 0.2 for "
                      "200 mm", "fluids.md#fluids-at-the-start-setfluids")


def _normal(corners):
    """Unit normal of a polygon, to the side from which its corners go left about."""
    area = np.cross(corners - corners[0], np.roll(corners, -1, axis=0) - corners[0]).sum(axis=0)
    return area/max(np.linalg.norm(area), 1e-300)


# --- softened liquids ----------------------------------------------------------

def softened(facts):
    """Liquids whose sound is not ten times what they reach by falling as far as they are high."""
    down, size = _down(facts)
    if not size:
        return
    rows = [(n, f"{n}.constitutiveModel", p.speed, float(abs(down) @ (p.high - p.low)))
            for n, p in facts.phases.items() if p.n and p.law in LIQUIDS]
    for name, state, wet in _liquids(facts):
        if facts.sounds[name]:
            entry = next((e for e in ("soundSpeed", "pInf", "K") if e in state), "type")
            rows.append((name, f"{name}.equationOfState.{entry}", facts.sounds[name],
                         _height(facts, wet, down)))
    for name, entry, c, height in rows:
        fall = math.sqrt(2*size*height)
        if fall > 0.1*c:
            yield Finding("warning", PHASES, entry, f"the sound of {name}, {c:.4g} m/s, is not ten "
                          f"times {fall:.3g} m/s, to which it falls by its height {height:.3g} m: "
                          "it is compressed as it flows", f"sound of {10*fall:.2g} m/s or more",
                          "fluids.md#several-fluids")


def gaugesInSoftened(facts):
    """Pressures are measured in a liquid whose sound is not its own."""
    functions = facts.control.get("functions", {})
    gauges = [n for n, of in functions.items() if isinstance(of, dict)
              and of.get("type") in GAUGES] if isinstance(functions, dict) else []
    down, size = _down(facts)
    for name, state, wet in _liquids(facts):
        c = facts.sounds[name]
        if not gauges or "soundSpeed" not in state or not 0 < c < SOFT:
            continue
        rings = f", and it rings with the period 4 H/c = {4*_height(facts, wet, down)/c:.2g} s" \
            if size else ""
        yield Finding("note", CONTROL, f"functions.{gauges[0]}", f"measures pressures in {name} "
                      f"softened to {c:.4g} m/s: an impact of v presses with up to rho c v, "
                      f"{number(facts.rho[name]*c)} Pa for 1 m/s{rings}; neither is that of the "
                      "real liquid", "compare a run with another soundSpeed before you use peaks",
                      "fluids.md#several-fluids")


# --- bodies --------------------------------------------------------------------

def nameFluid(finding, facts, log):
    """Of a body without stress: the fluids in which it lies, and their pressure there."""
    said = re.match(r"Region (\S+) lies in the .* and starts without stress", finding.text)
    region = facts.regions.get(said[1]) if said else None
    phase = facts.phases.get(region.get("phase")) if isinstance(region, dict) else None
    box = re.search(rf"^    {said[1]}: \w+ of \([^)]*\) m from \(([^)]*)\) to \(([^)]*)\) m", log,
                    re.M) if phase else None
    if not box or not len(facts.pressure) or len(phase.cells) != len(phase.x):
        return
    low, high = (np.array(b.split(), float) for b in box.groups())
    at = facts.axes         # of a mesh of one layer the box is flat
    inside = phase.cells[((phase.x >= low) & (phase.x <= high))[:, at].all(axis=1)]
    if not len(inside):
        return
    shares = {n: float(facts.share(n)[inside].mean()) for n in facts.media}
    around = " and ".join(n for n, share in shares.items() if share > 0.01)
    p = number(facts.pressure[inside].mean())
    finding.text = (f"Region {said[1]} lies in {around}, whose p is {p} Pa there, and starts "
                    "without stress: it is pressed together at once (setMaterialPoints)")
    finding.remedy = (f"stress ambient; pressure {p}; in the region (never of an explosive with "
                      f"E0), or referencePressure {p}; in the phase of what is soft or light")
    finding.file, finding.entry = REGIONS, "regions." + said[1]


def subSteps(facts):
    """Stiff solids whose step is far below that of the gas or fluids around them."""
    control = facts.control
    n = control.get("maxSubSteps", 1)
    # A charge that is to burn sets another step than the start
    if not facts.trial and any("detonation" in facts.of(name) for name in facts.media):
        return
    if not facts.sound or control.get("adjustTimeStep") not in ("yes", "on", "true", True) \
            or not isinstance(n, int) or control.get("maxGasSubSteps", 1) != 1:
        return
    solids = {n: p for n, p in facts.phases.items() if p.n and p.speed}
    if not solids or (facts.trial and not re.match(r"points? ", facts.trial.setBy)):
        return
    co, coGas = (v if isinstance(v, (int, float)) else d for v, d in (
        (control.get("maxCo"), 0.4), (control.get("maxCoGas"), 0.4)))
    name = max(solids, key=lambda n: solids[n].speed/(solids[n].width or facts.width))
    solid = co*(solids[name].width or facts.width)/(solids[name].speed + solids[name].U)
    solid = facts.trial.deltaT if facts.trial else solid*n
    # The Courant number of a cell is the sum of those along the axes
    width = float(facts.widths.min()) if len(facts.widths) else facts.width
    fluid = coGas*width/facts.sound/facts.nDim
    ratio = fluid/solid
    if ratio >= SUBSTEPS:
        remedy = f"maxSubSteps {min(100 if n > 1 else 10, int(n*ratio))}: so many steps of the " \
            "points in one of the gas or fluids"
        if n*ratio > 10:        # the steps of the points alone are many
            E = facts.lawOf(name).get("E")
            remedy += f" (100 at most); {name} as type rigid; motion {{ type free; }} where its " \
                "shape stays; or a softer E" + (
                    f", {E/ratio**2:.2g} Pa for the step of the fluids"
                    if isinstance(E, (int, float)) else "")
        yield Finding("note", CONTROL, "maxSubSteps", f"{name} sets the step, about {solid:.2g} s"
                      + (f" with maxSubSteps {n}" if n > 1 else "") + "; "
                      f"{' and '.join(facts.media)} would bear {fluid:.2g} s, {ratio:.2g} times as "
                      "much", remedy, "fluids.md#points-in-a-gas")


def shakes(facts):
    """FLIP keeps what shakes a body that lies in a liquid: seen of a block on the floor."""
    fraction = facts.number("PICfraction", 0)
    bodies = [n for n, p in facts.phases.items()
              if p.n and p.law not in LIQUIDS and facts.of(n).get("type") != "rigid"]
    if facts.transfer != "FLIP" or fraction >= 0.01 or not bodies or not np.linalg.norm(facts.g()):
        return
    liquids = [name for name, _, _ in _liquids(facts)]
    if liquids:
        yield Finding("note", SOLUTION, "materialPoints.PICfraction", f"FLIP with PICfraction "
                      f"{fraction:g}: {' and '.join(bodies)} may shake where it lies in "
                      f"{' and '.join(liquids)}", "PICfraction 0.01, or transfer APIC",
                      "fluids.md#a-body-that-floats-or-falls-into-water")


def dissipates(facts):
    """What a body pushes slowly in a liquid, and waves on it: the dissipation of shocks."""
    bodies = [n for n, p in facts.phases.items() if p.n and p.law not in LIQUIDS and (
        facts.of(n).get("type") != "rigid" or (facts.of(n).get("motion") or {}).get("type")
        == "free")]
    low = facts.of("fluids").get("lowMach", False)
    liquids = [name for name, _, _ in _liquids(facts)]
    charge = any("detonation" in facts.of(name) for name in facts.media)
    if bodies and liquids and low != "solids" and not charge:
        yield Finding("note", PHASES, "fluids.lowMach", f"{'yes' if low else 'no'}: "
                      f"{' and '.join(bodies)} may move less than it should where a slow load "
                      f"pushes it in {' and '.join(liquids)} (a plate two cells thick: "
                      f"{'0.80' if low else '0.64'} of its acceleration)",
                      "fluids { lowMach solids; }, or compare both", "fluids.md#several-fluids")
    # A prescribed body does not mind
    drags = {n: facts.of(n).get("drag", {}) for n in bodies}
    sticking = [n for n, of in drags.items() if isinstance(of, dict)
                and of.get("type", "stick") == "stick" and of.get("direction") != "normal"
                and facts.of(n).get("volumeModel") != "grains"]
    if sticking and liquids and not charge:
        yield Finding("note", PHASES, f"{sticking[0]}.drag", f"{' and '.join(sticking)} takes along "
                      f"what is within a cell in {' and '.join(liquids)}: a disc of 4 cells over "
                      "its radius has 0.62 of its acceleration, 0.90 where water slips",
                      "drag { type stick; direction normal; } on boxes; or finer cells",
                      "fluids.md#a-body-that-floats-or-falls-into-water")
    if liquids and not bodies and not low and not charge and len(facts.media) > len(liquids) \
            and np.linalg.norm(facts.g()):
        yield Finding("note", PHASES, "fluids.lowMach", f"no: waves of {' and '.join(liquids)} die "
                      "out (of one 80 cells long 44 % in a period, 4 % with lowMach)",
                      "fluids { lowMach yes; }", "fluids.md#several-fluids")


def narrowGaps(facts):
    """Boxes of points of one velocity field beside each other with less than two cells of fluids
    between them, which their drag holds there."""
    boxes = []
    for name, region in facts.regions.items() if facts.media else ():
        corners = [region.get(k) for k in ("min", "max")] if isinstance(region, dict) else []
        if (corners and region.get("type") == "box" and region.get("phase") in facts.phases
                and all(isinstance(c, list) and len(c) == 3 for c in corners)):
            try:
                boxes.append((name, region["phase"], *np.array(corners, float)))
            except (TypeError, ValueError):     # words of a macro
                pass
    drags = {phase: facts.of(phase).get("drag") for phase in facts.phases}
    normal = [phase for phase, drag in drags.items()
              if isinstance(drag, dict) and drag.get("direction") == "normal"]
    for i, (a, phase, low, high) in enumerate(boxes):
        for b, other, from_, to in boxes[:i]:
            fields = {facts.of(n).get("velocityField", n) for n in (phase, other)}
            if phase in normal and other in normal or len(fields) > 1:
                continue
            apart = np.maximum(from_ - high, low - to)[facts.axes]
            d = int(apart.argmax())
            width = facts.length(phase, facts.axes[d], low, high, np.min)
            if np.count_nonzero(apart > 0) != 1 or not width:
                continue
            if 1e-3*width < apart[d] < 2*width*(1 - 1e-6):
                yield Finding("note", REGIONS, f"regions.{a}", f"{a} and {b} are {apart[d]:.3g} m "
                              f"apart, {apart[d]/width:.2g} cells: their drag holds what is "
                              "between them, and it may get the pressure of the other side of a "
                              "body",
                              "a velocityField for each (and contact), or drag { type stick; "
                              "direction normal; } and fluids { faceDrag none; }, or two cells "
                              "between them",
                              "fluids.md#several-fluids")


def _way(centres, d, low, high):
    """From a box along d to each of some places [m]; inf: not in its way."""
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = (centres - low)/d, (centres - high)/d
    inside = (centres >= low) & (centres <= high)
    near = np.where(d == 0, np.where(inside, -np.inf, np.inf), np.minimum(a, b)).max(axis=1)
    far = np.where(d == 0, np.inf, np.maximum(a, b)).min(axis=1)
    return np.where((near <= far) & (far >= 0), np.maximum(near, 0), np.inf)


def _time(way, speed, g):
    """Until a body has gone so far [s]."""
    if way == 0:
        return 0.0
    root = speed*speed + 2*g*way
    return 2*way/(speed + math.sqrt(root)) if root > 0 and speed + math.sqrt(root) > 0 else math.inf


def _closed(facts):
    """Patches that are walls of a mesh, or of what flows in it."""
    fields = [f for f in ("0/U", *(f"0/U.{n}" for n in facts.media))
              if os.path.exists(facts.case.file(f))]
    walls = {p for p, kind in facts.patches.items() if kind == "wall"}
    for field in fields if facts.media else ():
        walls |= {p for p, of in facts.conditions(field).items() if facts.patches[p] == "patch"
                  and of.get("type") in ("slip", "noSlip", "fixedValue")}
    return walls


def leavesMesh(facts):
    """Walls without a condition for the points or contact, in the way of a body."""
    walls = _closed(facts)
    contacts = [c for c in facts.properties.get("contact", {}).values() if isinstance(c, dict)]
    x = readField(facts.case.file("constant/polyMesh/points"))
    faces, shapes = patchFaces(facts.case), readLists(facts.case.file("constant/polyMesh/faces"))
    fields = {n: str(facts.of(n).get("velocityField", n)) for n in facts.phases}
    rigid = {field for n, field in fields.items() if facts.of(n).get("type") == "rigid"}
    for name, phase in facts.phases.items():
        field = fields[name]
        if not phase.n or field in rigid \
                or not os.path.exists(facts.case.file("0/U." + field)):
            continue
        given = facts.conditions("0/U." + field)
        held = [p for p, of in given.items() if of.get("type") == "fixedValue"
                and _gap(facts, phase, x, shapes, faces.get(p)) < facts.width]
        for patch in sorted(walls & {p for p, of in given.items() if of.get("type") in FREE}):
            touched = any(c.get("patch") == patch and field in c.get("fields", [field])
                          for c in contacts)
            if touched or held or not faces[patch][1]:
                continue
            first, n = faces[patch]
            time = _arrival(facts, name, np.array(
                [x[s].mean(axis=0) for s in shapes[first:first + n]]))
            if time < facts.end:
                yield Finding("note", "0/U." + field, f"boundaryField.{patch}", f"{name} may get "
                              f"to {patch} from {time:.2g} s on, and {given[patch]['type']} "
                              "prescribes nothing there: without contact it leaves the mesh",
                              f"slip, or contact {{ wall {{ type Coulomb; mu 0.3; fields ({field});"
                              f" patch {patch}; }} }} in {PHASES}", "bodies.md#contact")


def _gap(facts, phase, x, shapes, where):
    """Between the box of a phase and a patch [m]."""
    if not where or not where[1]:
        return math.inf
    corners = x[np.unique(np.concatenate(shapes[where[0]:where[0] + where[1]]))]
    gap = np.maximum(0, np.maximum(phase.low - corners, corners - phase.high))[:, facts.axes]
    return float(np.sqrt((gap**2).sum(axis=1)).min())


def _arrival(facts, name, centres):
    """Of a phase at faces: by its velocity or by gravity, nothing else in between [s]."""
    phase, (down, size) = facts.phases[name], _down(facts)
    v = phase.v.mean(axis=0)
    speed = float(np.linalg.norm(v))
    flat = [d for d in range(3) if d not in facts.axes]
    low, high = phase.low - facts.width/2, phase.high + facts.width/2
    low[flat], high[flat] = -np.inf, np.inf
    first = math.inf
    for d in ([v/speed] if speed else []) + ([down] if size else []):
        way = float(_way(centres, d, low, high).min())
        if not math.isfinite(way):
            continue
        end = way*d
        between = [p for n, p in facts.phases.items() if n != name and p.n and all(
            p.low[k] < phase.high[k] + max(end[k], 0) and p.high[k] > phase.low[k] + min(end[k], 0)
            for k in facts.axes)]
        if not between:
            first = min(first, _time(way, float(v @ d), size*float(down @ d)))
    return first


RULES = (noGravity, upsideDown, slipOnAnyCells, notAtRest, runsOut, unheld, nowhere, softened,
         gaugesInSoftened, subSteps, shakes, dissipates, narrowGaps, leavesMesh)
