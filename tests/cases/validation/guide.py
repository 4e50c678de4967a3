"""Figures of the pages of doc/guide and of README.md.

A comment of the page gives the origin of all figures of the text above it, up to the comment
or heading before:

    <!-- figures
    shapes | disc, R = 5 h, rolls: velocity / a t - 1 [%] | -2.1
    contact | …: stress [MPa] | within 0.3 = 100*(m/r - 1)
    tutorials/hertz/README.md | 3.5
    tests/Allverify spinningDisk | 1.05 1.65
    given | 0.4 5
    -->

- a test: words of its row, … for anything, and the figure: a number, "within x" (the largest
  of the rows, its size) or "below x" (larger than all of them; than a third of it not, unless
  it is rounding, 1e-9 or less). After = the value in terms of m, measured, and r, reference:
  without it m; with within and below m - r;
- a page of the project, which has the figure too, with the command that makes it;
- a command, for what a test does not print by rows;
- given: no result, but an input, a limit, a definition.

Those of README.md stand in readme.figures beside this file, in the same words.

A figure is a number with a point, an exponent or "%". In code it is none.
"""

import glob
import os
import re

from figures import agrees, fitting, formatted, results
from foamCase import PROJECT, TESTS

HERE = os.path.dirname(os.path.abspath(__file__))

_BLOCK = re.compile(r"<!-- figures\n(.*?)-->", re.S)
_N = r"[-+]?\d+(?:\.\d+)?(?:e-?\d+)?"
#: Numbers before one "%": "7.9 / 5.3 %", "1.4, 2 and 3 %", "0.8 to 1.4 %"
_PERCENT = re.compile(rf"(?<![\w.^])({_N}(?:(?: to | / |, | and | or ){_N})*) %")
_PLAIN = re.compile(r"(?<![\w.^])[-+]?(?:\d+\.\d+(?:e-?\d+)?|\d+e-\d+)(?![\w.]*\w)")


def withoutCode(text):
    text = re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)
    text = re.sub(r"`[^`]*`", "", text)
    text = re.sub(r"\]\([^)\s]+\)", "]", text)
    return "\n".join(line for line in text.split("\n") if not line.startswith("    "))


def numbers(text):
    """Figures in a text without code, without signs."""
    text = re.sub(r"\s+", " ", text)
    found = {n for run in _PERCENT.findall(text) for n in re.findall(_N, run)}
    return {n.lstrip("+-") for n in found | set(_PLAIN.findall(text))}


def lines(block):
    return [line.strip() for line in block.split("\n") if line.strip()]


def units(path):
    """(text, lines of its comment) of a page, one after the other."""
    with open(path, encoding="utf-8") as f:
        text = withoutCode(f.read())
    if os.path.basename(os.path.dirname(path)) != "guide":
        with open(os.path.join(HERE, "readme.figures"), encoding="utf-8") as f:
            yield text, lines(f.read())
        return
    for part in re.split(r"^#+ .*$", text, flags=re.M):
        pieces = _BLOCK.split(part)
        for piece, block in zip(pieces[::2], pieces[1::2] + [""]):
            yield piece, lines(block)


def value(expression, reference, measured):
    if not re.fullmatch(r"(?:abs|[mr\d\s.e()+*/-])+", expression):
        raise ValueError(expression)
    return eval(expression, {"__builtins__": {}, "abs": abs},       # noqa: S307
                {"m": measured, "r": reference})


def ofRows(words, claim, rows):
    """(figure, what is wrong, value of the rows) of a claim about rows of a test."""
    claim, _, expression = (c.strip() for c in claim.partition("="))
    kind, _, figure = claim.rpartition(" ")
    found = fitting(words, rows)
    if not re.fullmatch(_N, figure):
        return figure, "is no number", None
    if not found:
        return figure, "there is no such row", None
    if not kind and len(found) > 1:
        return figure, f"{len(found)} rows fit", None
    values = [value(expression or ("m - r" if kind else "m"), r, m) for r, m in found]
    is_ = max(map(abs, values)) if kind else values[0]
    if kind == "below":
        limit = float(figure)
        good = is_ < limit and (limit <= 1e-9 or is_ > limit/3)
    else:
        good = agrees(figure, is_)
    return figure, "" if good else f"{is_:g} in the results", is_


def ofLine(line, skipped):
    """(figures, what is wrong with them, rows compared) of a line of a comment."""
    origin, _, rest = line.partition(" | ")
    if os.path.isfile(os.path.join(TESTS, "cases", origin, "test.py")):
        words, _, claim = rest.rpartition(" | ")
        rows = results(origin)
        if rows is None:
            skipped.add(origin)
            return [claim.partition("=")[0].split()[-1]], [], 0
        figure, says, _ = ofRows(words, claim, rows)
        return [figure], [f"{origin}: {words}: {figure}, {says}"] if says else [], 1
    figures = rest.split()
    if origin.endswith(".md"):
        with open(os.path.join(PROJECT, origin), encoding="utf-8") as f:
            page = f.read()
        return figures, [f"{n} is not in {origin}" for n in figures if not stands(n, page)], 0
    if origin == "given" or os.path.exists(os.path.join(PROJECT, origin.partition(" ")[0])):
        return figures, [], 0
    return figures, [f"no test, page or command: {origin}"], 0


def standing(number):
    return re.compile(rf"(?<![\d.]){re.escape(number.lstrip('+-'))}(?!\d|\.\d)")


def stands(number, text):
    return bool(standing(number).search(text))


def update():
    """New figures into comments and texts of doc/guide, where the old one stands once."""
    for path in sorted(glob.glob(os.path.join(PROJECT, "doc/guide/*.md"))):
        with open(path, encoding="utf-8") as f:
            pieces = re.split(r"(<!-- figures\n.*?-->)", f.read(), flags=re.S)
        for i in range(1, len(pieces), 2):
            for line in lines(pieces[i]):
                origin, _, rest = line.partition(" | ")
                words, _, claim = rest.rpartition(" | ")
                rows = results(origin) if words else None
                if rows is None:
                    continue
                old, says, now = ofRows(words, claim, rows)
                if not says:
                    continue
                print(f"{os.path.basename(path)}: {words}: {old}, {says}")
                at = max([m.end() for m in re.finditer(r"^#+ .*$", pieces[i - 1], re.M)],
                         default=0)
                text = pieces[i - 1][at:]
                if now is None or claim.startswith("below") or now*float(old) <= 0 \
                        or len(standing(old).findall(text)) != 1:
                    print("    by hand")
                    continue
                new = formatted(old, now).lstrip("-")
                pieces[i - 1] = pieces[i - 1][:at] + standing(old).sub(new, text)
                pieces[i] = pieces[i].replace(line, f"{origin} | {words} | " + standing(old).sub(
                    new, claim, count=1))
        with open(path, "w", encoding="utf-8") as f:
            f.write("".join(pieces))


def check(table):
    """The part "guide" of the test."""
    compared, skipped, wrong, nFigures = 0, set(), [], 0
    for path in [os.path.join(PROJECT, "README.md")] + sorted(
            glob.glob(os.path.join(PROJECT, "doc/guide/*.md"))):
        name = os.path.basename(path)
        for text, comment in units(path):
            there, known = numbers(text), set()
            nFigures += len(there)
            for line in comment:
                figures, says, n = ofLine(line, skipped)
                known |= {figure.lstrip("+-") for figure in figures}
                compared += n
                wrong += [f"{name}: {s}" for s in says]
                wrong += [f"{name}: {n} is not in the text" for n in figures
                          if not line.startswith("given | ") and not stands(n, text)]
            wrong += [f"{name}: {n} has no origin" for n in sorted(there - known)]
    for line in wrong:
        table.check(f"guide: {line}", False)
    print(f"guide: {nFigures} figures, {compared} of rows compared"
          + "".join(f"; {t} has not run" for t in sorted(skipped)))
    table.row("guide: figures that are wrong or have no origin", 0, len(wrong), 0)
    # The check finds a figure that has drifted, and one without origin
    table.check("guide: another figure is found", bool(
        ofRows("a", "2.1", {"a": (2, 2.2)})[1] and not ofRows("a", "2.2", {"a": (2, 2.2)})[1]
        and ofRows("a", "below 2", {"a": (0, 2.2)})[1]
        and numbers(withoutCode("1 to 3.1 % or 2e-5, `4.1`")) == {"1", "3.1", "2e-5"}))
    if os.environ.get("MPM_ALL_TESTS", "") == "1":
        table.check("guide: all its tests have run", not skipped, " ".join(sorted(skipped)))
