#!/usr/bin/env python3
"""doc/validation.md beside the results: Alltest runs this test after all others.

    page      its tables have as many rows as ever; each names a test, or a tutorial
    figures   reference and figure of each row are those that the test has printed last
              (tests/run/<test>/log.test), to the digits of the page. A test that has not run
              is skipped, and said so; in a run of all tests none may be
    tutorials the figure stands in the tutorial's README; where the tutorial has run, in its
              log.plot too
    guide     each figure of doc/guide is that of a row, stands in a page that has its command,
              has a command of its own, or is given (guide.py)

    test.py -update      writes the figures of the last results into the pages

A row of the page: `test` | words of the test's row, … for anything | reference | figure. The
figure is a number (of one row); "within x": the largest difference from the reference, of all
rows that fit; "below x": all are smaller (rounding, whose digits nobody compares).
"""

import glob
import math
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../lib"))
sys.path.insert(0, HERE)
import guide as pagesOfGuide
from figures import NUMBER, agrees, fitting, formatted, results
from foamCase import PROJECT, TESTS, runParts

PAGE = os.path.join(PROJECT, "doc", "validation.md")
ROW = re.compile(r"^\| `(\w+)` \| (.+?) \| ([^|]+?) \| ([^|]+?) \|$")
TUTORIAL = re.compile(r"^\| \[(\w+)\]\(\.\./tutorials/\w+/README\.md\) \| .* \| ([^|]+?) \|$")


def differences(words, reference, figure, rows):
    """What a row of the page says otherwise than the results; and its figure by these."""
    found = fitting(words, rows)
    kind, _, number = figure.rpartition(" ")
    if not found:
        return "there is no such row", figure
    if not kind and len(found) > 1:
        return f"{len(found)} rows fit", figure
    if reference != "exact" and not all(math.isclose(float(reference), r, rel_tol=1e-5)
                                        for r, _ in found):
        return f"the reference is {found[0][0]:g}", figure
    largest = max(abs(m - r) for r, m in found)
    if kind == "below":
        return ("" if largest < float(number) else f"{largest:.2g} in the results"), figure
    value = largest if kind == "within" else found[0][1]
    if agrees(number, value):
        return "", figure
    return f"{value:g} in the results", f"{kind} {formatted(number, value)}".lstrip()


def lines():
    with open(PAGE, encoding="utf-8") as f:
        return f.read().split("\n")


def rowsOfPage():
    return [ROW.match(line).groups() for line in lines() if ROW.match(line)]


def plain(words):
    return words.replace("\\|", "|").replace("\\*", "*")


# --- parts -------------------------------------------------------------------

def page(table):
    table.row("page: rows of tests", 135, len(rowsOfPage()), 135, "atLeast")
    table.row("page: rows of tutorials", 25,
              sum(bool(TUTORIAL.match(line)) for line in lines()), 25, "atLeast")
    tables = [line for line in lines() if line.startswith("|") and "---" not in line]
    table.row("page: lines of tables that are neither", 0, sum(
        not (ROW.match(line) or TUTORIAL.match(line) or "| quantity |" in line)
        for line in tables), 0)
    table.row("page: longest line", 160, max(map(len, lines())), 160, "atMost")
    unknown = sorted({t for t, *_ in rowsOfPage()
                      if not os.path.exists(os.path.join(TESTS, "cases", t, "test.py"))})
    table.check("page: tests that there are", not unknown, " ".join(unknown))


def figures(table):
    skipped, compared, wrong = set(), 0, 0
    for test, words, reference, figure in rowsOfPage():
        rows = results(test)
        if rows is None:
            skipped.add(test)
            continue
        compared += 1
        says, _ = differences(plain(words), reference, figure, rows)
        if says:
            wrong += 1
            table.check(f"{test}: {plain(words)}", False, f"{figure} on the page, {says}")
    print(f"figures: {compared} compared" + "".join(f"; {t} has not run" for t in sorted(skipped)))
    if compared:
        table.row("figures: that differ from the results", 0, wrong, 0)
    if os.environ.get("MPM_ALL_TESTS", "") == "1":
        table.row("figures: without results, of a run of all tests", 0,
                  len(rowsOfPage()) - compared, 0)


def tutorials(table):
    for line in lines():
        match = TUTORIAL.match(line)
        if not match:
            continue
        name, figure = match.groups()
        folder = os.path.join(PROJECT, "tutorials", name)
        with open(os.path.join(folder, "README.md"), encoding="utf-8") as f:
            there = re.search(rf"(?<![\d.]){re.escape(figure)}(?!\d)", f.read())
        table.check(f"tutorials: {name}: {figure} in its README", bool(there))
        for log in glob.glob(os.path.join(folder, "log.plot")):
            with open(log, encoding="utf-8") as f:
                values = [float(v) for v in NUMBER.findall(f.read())]
            # Rounding has its own digits on every machine
            table.check(f"tutorials: {name}: {figure} in its log", any(
                agrees(figure, v) or max(abs(float(figure)), abs(v)) < 1e-12 for v in values))


def guide(table):
    pagesOfGuide.check(table)


def update():
    new = []
    for line in lines():
        match = ROW.match(line)
        rows = results(match.group(1)) if match else None
        if rows is not None:
            test, words, reference, figure = match.groups()
            says, now = differences(plain(words), reference, figure, rows)
            if says:
                print(f"{test}: {plain(words)}: {figure}, {says}")
                line = f"| `{test}` | {words} | {reference} | {now} |"
        new.append(line)
    with open(PAGE, "w", encoding="utf-8") as f:
        f.write("\n".join(new))


if __name__ == "__main__":
    if sys.argv[1:] == ["-update"]:
        update()
        pagesOfGuide.update()
        sys.exit(0)
    sys.exit(runParts("validation", page, figures, tutorials, guide))
