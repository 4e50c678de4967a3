"""Cases of materialPointFoam from Python, for tutorials, tests and benchmarks:

    from mpm.case import Case           # runs a case, reads its times, tables, logs
    from mpm.files import readField     # one file: columns of points, fields, headers
    from mpm.study import Study         # a series of runs over parameters: table, plot
    from mpm.variants import runVariants    # named copies of a tutorial with changes, run
    from mpm.pictures import plt        # matplotlib in the style of the pictures
    from mpm.views import readViews     # what is shown of a case: view.py beside it
    python3 -m mpm.animate              # view.py as an animation
    mpmReport                           # mpm.report: a page of a run; reportLog reads logs,
                                        # reportCase dictionaries and tables, reportPictures
                                        # draws, reportPlots and reportPage make the page

The guide has a page on it: doc/guide/python.md. etc/bashrc puts it on PYTHONPATH.
"""

import sys

try:
    import numpy  # noqa: F401
except ModuleNotFoundError as error:
    sys.exit(f"mpm: no module {error.name} for {sys.executable}: run the script with a Python that"
             f" has numpy and matplotlib, /usr/bin/python3 {sys.argv[0] or '<script>'} (Debian: "
             "apt-get install python3-numpy python3-matplotlib; mpmReport and mpmCheck take"
             " $MPM_PYTHON)")
