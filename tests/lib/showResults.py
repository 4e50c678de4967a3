#!/usr/bin/env python3
"""Prints the results that the test scripts left in a CSV file (report.py) as a
table, and as the last line the numbers of passed, failed and skipped rows.

    showResults.py results.csv [failed script ...]

A script that failed without a failed row of its own counts as a failed row.
Exits with 1 if something failed or if there are no rows.
"""

import csv
import os
import sys

from report import COLUMNS

LONGEST = 70


def main(path, failedScripts):
    rows = []
    if os.path.exists(path):
        with open(path, newline="") as f:
            rows = [[row[c] for c in COLUMNS] for row in csv.DictReader(f)]
    for script in failedScripts:
        if not any(row[0] == script and row[-1] not in ("ok", "skipped") for row in rows):
            rows.append([script, "script ends without an error", "holds",
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
    failed = [line for line, row in zip(lines[1:], rows) if row[-1] not in ("ok", "skipped")]
    for title, found in (("Skipped", skipped), ("Failed", failed)):
        if found:
            print(f"\n{title}:")
            print("\n".join(found))
    print(f"\nResults: {path}")
    print(f"{len(rows) - len(failed) - len(skipped)} passed, {len(failed)} failed"
          + (f", {len(skipped)} skipped" if skipped else ""))
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
