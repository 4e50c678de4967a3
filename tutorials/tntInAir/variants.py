"""In variants/: half and twice as many cells."""

import os
import shutil

from mpm.variants import variant

for n in (10, 40):
    case = variant(str(n))
    case.copy(())
    for name in os.listdir("0.orig"):
        shutil.copy(os.path.join("0.orig", name), case.file("0"))
    for entry, cells in (("charge", n), ("near", n), ("far", 56*n)):
        case.change("system/blockMeshDict", rf"^{entry} .*", f"{entry} {cells};")
    print(f"Running {case.path}", flush=True)
    for application in ("blockMesh", "setFields", "materialPointFoam"):
        case.run(application)
