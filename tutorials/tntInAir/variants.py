"""In variants/: half and twice as many cells; products that do not burn on, or with all of
their heat."""

import os
import shutil

from mpm.variants import variant

AFTERBURN = r"^    afterburn .*"
for name, n in (("10", 10), ("40", 40), ("none", 20), ("all", 20)):
    case = variant(name)
    case.copy(())
    for field in os.listdir("0.orig"):
        shutil.copy(os.path.join("0.orig", field), case.file("0"))
    for entry, cells in (("charge", n), ("near", n), ("far", 56*n)):
        case.change("system/blockMeshDict", rf"^{entry} .*", f"{entry} {cells};")
    if name == "none":
        case.change("constant/phaseProperties", AFTERBURN, "")
    if name == "all":
        case.change("constant/phaseProperties", r"Q 3e6", "Q 1e7")
    print(f"Running {case.path}", flush=True)
    for application in ("blockMesh", "setFields", "materialPointFoam"):
        case.run(application)
