"""What the automatic pictures of mpm.report are coloured by, and the limits of the colours."""

import numpy as np

from mpm.pictures import SIGNED, VALUES, to_rgb

#: What points are coloured by: column, label, colours, expression; the first that has values
COLUMNS = (("plasticStrain", "plastic strain", VALUES, lambda v: v),
           ("damage", "damage", "DAMAGE", lambda v: v),
           ("sigmaEq", "von Mises stress", VALUES, lambda v: v),
           ("pPoint", "pressure", SIGNED, lambda v: v),
           ("U", "speed", VALUES, lambda v: np.linalg.norm(v, axis=1)))
#: Failed points, by name: like no colour of VALUES and SIGNED, whose dark violet FAILED is near to
FAILED = "magenta"
#: Colours of more than two fluids, liquids first, and of gases among them: pale, under points
LIQUIDS = ("#3f7fbf", "#e0a030", "#70a860", "#b070a8", "#a07050", "#60a8a8")
GASES = ("#eef2f6", "#d8e0d0", "#e6dccb")
#: Field and label of what fluids have beside their shares
PRESSURE = "p", "pressure of the fluids"
UNITS = {"sigmaEq": "Pa", "pPoint": "Pa", "p": "Pa", "U": "m/s"}


def span(parts):
    """Limits of colours: without the outermost 0.5 % of the values."""
    found = [np.percentile(v, (0.5, 99.5)) for v in parts if len(v)]
    found = [f for f in found if np.isfinite(f).all()]
    return (min(f[0] for f in found), max(f[1] for f in found)) if found else (0.0, 0.0)


def columnOf(scene, times):
    """What shows most of the points: (column, label, colours, function, limits)."""
    for column, label, colours, function in COLUMNS:
        parts = []
        for time in times:
            for phase in scene.phases:
                cloud = scene.cloud(time, phase)
                if phase not in scene.rigid and cloud is not None and column in cloud:
                    parts.append(function(cloud[column]))
        low, high = span(parts)
        if column == "damage" and parts and not any(
                ((v > 0.02) & (v < 0.98)).mean() > 0.02 for v in parts if len(v)):
            continue        # sound or failed, nothing between: that has a colour of its own
        if UNITS.get(column) == "Pa" and max(abs(low), abs(high)) < 1e-3:
            continue        # rounding
        if high > low:
            if column == "pPoint":
                low, high = -max(-low, high), max(-low, high)
            if column in ("plasticStrain", "sigmaEq", "U", "damage"):
                low = 0.0
            return column, label, colours, function, (low, high)
    return None


def unitOf(column, limits):
    """Factor and unit of a column's values."""
    unit = UNITS.get(column, "")
    return ofPressure(max(abs(v) for v in limits)) if unit == "Pa" else (1, unit)


def ofPressure(size):
    """Factor and unit for pressures up to this one."""
    for factor, name in ((1e-9, "GPa"), (1e-6, "MPa"), (1e-3, "kPa")):
        if size*factor >= 1:
            return factor, name
    return 1, "Pa"


def gasField(scene):
    """Field and label of a gas or fluids: the share of the first liquid, or the pressure."""
    if not scene.gas:
        return None
    if scene.mixed:
        return f"alpha.{scene.gas[0]}", "fluids"
    if scene.fluids and len(scene.gas) > 1:
        return f"alpha.{scene.gas[0]}", f"share of {scene.gas[0]}"
    return "p", "pressure of the gas"


def fluidColours(dictionary):
    """Colours of fluids by name, red, green and blue, where there are more than two."""
    fluids = {n: d for n, d in dictionary.items() if isinstance(d, dict)
              and d.get("type") == "fluid"}
    if len(fluids) < 3:
        return {}
    gases = [n for n, d in fluids.items() if "thermo" in d]
    liquids = [n for n in fluids if n not in gases]
    return {n: np.array(to_rgb(colours[i % len(colours)]))
            for some, colours in ((liquids, LIQUIDS), (gases, GASES))
            for i, n in enumerate(some)}


def joined(limits, others, what):
    """Limits that hold for the others' values of the same, too."""
    low, high = others.get(what, limits)
    return min(limits[0], low), max(limits[1], high)
