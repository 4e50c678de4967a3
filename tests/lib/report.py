"""Rows of the table of results.

Every test script gets its table with

    from report import Report
    table = Report("name of the case")
    table.row("quantity", reference, measured, limit)             # absolute
    table.row("quantity", reference, measured, limit, "relative") # |m - r|/|r|
    table.row("quantity", reference, measured, limit, "atMost")   # measured <= limit
    table.row("quantity", reference, measured, limit, "atLeast")  # measured >= limit
    table.check("what must hold", condition, detail)
    table.skip("what cannot be tested here", "why")
    sys.exit(table.finish())

Rows are appended to the CSV that the environment variable MPM_RESULTS names
(tests/Alltest and tests/Allverify set it) and printed. finish() returns 1 if a
row failed or if none has passed: a script that measured nothing has failed.
"""

import csv
import math
import os

COLUMNS = ["case", "quantity", "reference", "measured", "error", "limit", "ok"]


def _text(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)


class Report:
    def __init__(self, case, held=False):
        self.case = case
        self.held = held
        self.rows = []

    def row(self, quantity, reference, measured, limit, kind="absolute"):
        """One figure against its limit; a NaN fails."""
        reference, measured = float(reference), float(measured)
        if kind == "absolute":
            error = abs(measured - reference)
            ok = error <= limit
        elif kind == "relative":
            error = abs(measured - reference)/abs(reference)
            ok = error <= limit
        elif kind == "atMost":
            error = measured - reference
            ok = measured <= limit
        elif kind == "atLeast":
            error = measured - reference
            ok = measured >= limit
        else:
            raise ValueError(f"unknown kind of limit {kind}")
        ok = bool(ok) and math.isfinite(measured)
        sign = {"atMost": "<= ", "atLeast": ">= "}.get(kind, "")
        unit = " rel" if kind == "relative" else ""
        self._add([self.case, quantity, _text(reference), _text(measured),
                   _text(error) + unit, sign + _text(float(limit)), ok])
        return ok

    def check(self, quantity, condition, detail=""):
        """Something that holds or does not."""
        self._add([self.case, quantity, "holds",
                   str(detail) if detail else str(bool(condition)), "", "",
                   bool(condition)])
        return bool(condition)

    def skip(self, quantity, why):
        """Something that this machine cannot test; neither passed nor failed."""
        self._add([self.case, quantity, "holds", why, "", "", None])

    def take(self, held):
        """Adds the rows that another table has held."""
        for row in held.rows:
            self._add(row)

    def _add(self, row):
        self.rows.append(row)
        if self.held:
            return
        word = "skipped" if row[-1] is None else "ok" if row[-1] else "FAILED"
        print(" | ".join(str(v) for v in row[:-1]), "|", word, flush=True)
        path = os.environ.get("MPM_RESULTS")
        if path:
            new = not os.path.exists(path)
            with open(path, "a", newline="") as f:
                writer = csv.writer(f)
                if new:
                    writer.writerow(COLUMNS)
                writer.writerow(row[:-1] + [word])

    def finish(self):
        results = [r[-1] for r in self.rows if r[-1] is not None]
        return 0 if results and all(results) else 1
