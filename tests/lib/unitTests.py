#!/usr/bin/env python3
"""Runs mpmUnitTests (doctest): one row of the table for each test case."""

import subprocess
import sys
import xml.etree.ElementTree as ElementTree

from report import Report


def main():
    table = Report("unit")
    try:
        run = subprocess.run(["mpmUnitTests", "-r=xml"], stdout=subprocess.PIPE,
                             stdin=subprocess.DEVNULL, timeout=300)
        text = run.stdout.decode(errors="replace")
        tests = ElementTree.fromstring(text[text.index("<?xml"):])
    except (OSError, subprocess.TimeoutExpired, ValueError,
            ElementTree.ParseError) as error:
        table.check("mpmUnitTests runs to its end", False, repr(error)[:200])
        return table.finish()

    for case in tests.iter("TestCase"):
        result = case.find("OverallResultsAsserts")
        if result is None:      # skipped
            continue
        table.check(case.get("name"), result.get("test_case_success") == "true",
                    f"{result.get('successes')} right, {result.get('failures')} wrong")
        for wrong in case.iter("Expression"):
            print(f"    {wrong.get('filename')}:{wrong.get('line')}:",
                  *(part.text.strip() for part in wrong if part.text))
    table.check("exit status of mpmUnitTests is that of its tests",
                (run.returncode == 0) == all(r[-1] for r in table.rows), run.returncode)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
