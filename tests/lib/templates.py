"""Libraries of etc/codeTemplates, compiled outside the tree of the project as a user does."""

import os

from foamCase import PROJECT, VERIFY, FoamCase

TEMPLATES = os.path.join(PROJECT, "etc", "codeTemplates")

#: Of userSchemes; the others are of userLibrary
SCHEMES = ("midpoint.C", "PIC.C", "fullStepAtL.C", "nodewiseLinear.C")


def compileTemplates(group, sources, name):
    """wmake of the sources to ../lib<name>.so of a case's folder, whose log is that of the
    case. They are included by one file and compiled with little optimisation: reading
    OpenFOAM's headers is three seconds of one core. MPM_VERIFY=1: each by itself, as in
    Make/files of the templates."""
    case = FoamCase(group, "library", TEMPLATES)
    files = list(sources)
    if not VERIFY:
        files = ["all.C"]
        with open(case.file("all.C"), "w") as f:
            f.writelines(f'#include "{source}"\n' for source in sources)
        with open(case.file("Make/options"), "a") as f:
            f.write("EXE_INC += -O1 -fexpensive-optimizations\n")
    with open(case.file("Make/files"), "w") as f:
        f.write("\n".join((*files, "", "LIB = lib" + name, "")))
    case.run("wmake", limit=300)
    return case
