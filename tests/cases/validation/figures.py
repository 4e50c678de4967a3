"""Figures of pages beside the rows that tests have printed last (tests/run/<test>/log.test)."""

import decimal
import math
import os
import re

from foamCase import RUN

NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")


def results(test):
    """{words: (reference, measured)} of the rows that a test printed last, or None."""
    path = os.path.join(RUN, test, "log.test")
    if not os.path.exists(path):
        return None
    rows = {}
    with open(path, encoding="utf-8") as f:
        for line in f:
            # The words may have " | " of their own, what a check says too
            parts = line.rstrip("\n").split(" | ")
            if len(parts) >= 7 and parts[0] == test and "holds" not in parts:
                rows[" | ".join(parts[1:-5])] = float(parts[-5]), float(parts[-4])
    return rows


def fitting(words, rows):
    """(reference, measured) of all rows that fit; … stands for anything."""
    pattern = re.compile(".*".join(re.escape(w) for w in words.split("…")))
    return [rows[label] for label in rows if pattern.fullmatch(label)]


def agrees(printed, value):
    """A number as printed is a value, to its last digit; 0 without a point is 0."""
    if float(printed) == 0 and "." not in printed:
        return value == 0
    unit = 10.0**decimal.Decimal(printed).as_tuple().exponent
    return abs(float(printed) - value) <= 0.5*unit*(1 + 1e-6) + 1e-12*abs(value)


def formatted(like, value):
    """A value with as many digits as another number has."""
    digits = len(re.sub(r"[eE].*|[^\d]", "", like).lstrip("0")) or 1
    if value == 0:
        return "0"
    places = digits - 1 - math.floor(math.log10(abs(value)))
    if abs(value) >= 1e6 or abs(value) < 1e-4:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    return f"{value:.{max(places, 0)}f}"
