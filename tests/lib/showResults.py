#!/usr/bin/env python3
"""Prints the results that the test scripts left in a CSV file (report.py) as a
table, and as the last line the numbers of passed, failed and skipped rows.

    showResults.py results.csv [failed script ...]

A script that failed without a failed row of its own counts as a failed row. What failed
is shown once more at the end, with all that the row says or the end of the script's log.
Exits with 1 if something failed or if there are no rows.
"""

import csv
import os
import sys

from report import COLUMNS

LONGEST = 70

#: The row of a script without a failed one
ENDS = "script ends without an error"

#: Lines and letters of what is shown of a failed row or script
TAIL, LETTERS = 20, 3000


def log(script, path):
    """The end of the log of a script, in a folder of its own beside the results."""
    name = os.path.join(os.path.dirname(path), script, "log.test")
    if not os.path.exists(name):
        return ""
    with open(name, errors="replace") as f:
        return "".join(f.readlines()[-TAIL:])


def main(path, failedScripts):
    rows = []
    if os.path.exists(path):
        with open(path, newline="") as f:
            rows = [[row[c] for c in COLUMNS] for row in csv.DictReader(f)]
    for script in failedScripts:
        if not any(row[0] == script and row[-1] not in ("ok", "skipped") for row in rows):
            rows.append([script, ENDS, "holds",
                         "see its log", "", "", "FAILED"])

    # Tests ran side by side: the rows of each together, by name
    rows.sort(key=lambda row: row[0])

    shown = [COLUMNS] + [[" ".join(v.split()) for v in row] for row in rows]
    shown = [[v if len(v) <= LONGEST or i == 1 else v[:LONGEST - 3] + "..."
              for i, v in enumerate(row)] for row in shown]
    widths = [max(len(row[i]) for row in shown) for i in range(len(COLUMNS))]
    lines = [" | ".join(v.ljust(w) for v, w in zip(row, widths)).rstrip()
             for row in shown]
    print("\n".join(lines))

    skipped = [line for line, row in zip(lines[1:], rows) if row[-1] == "skipped"]
    failed = [(line, row) for line, row in zip(lines[1:], rows) if row[-1] not in ("ok", "skipped")]
    if skipped:
        print("\nSkipped:", *skipped, sep="\n")
    if failed:
        print("\nFailed:")
    for line, row in failed:
        print(line)
        whole = log(row[0], path) if row[1] == ENDS else row[3] if len(row[3]) > LONGEST else ""
        for text in whole.strip()[-LETTERS:].splitlines():
            print(f"    {text}")
    print(f"\nResults: {path}")
    print(f"{len(rows) - len(failed) - len(skipped)} passed, {len(failed)} failed"
          + (f", {len(skipped)} skipped" if skipped else ""))
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
