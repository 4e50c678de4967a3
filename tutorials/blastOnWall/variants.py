"""In variants/: free, the same blast with no wall in its way, until it has passed the wall's
place; its peak there is that of the incident wave. rigid, with the end of the mesh as a rigid
wall there. With the argument fine also fine, fineFree, fineRigid: cells of half the size, until
the peak is over."""

import os
import shutil
import sys

from mpm.case import Case, RunFailed


def run(name, what, fine=False):
    case = Case(os.path.join("variants", name))
    case.copy()
    for field in os.listdir("0.orig"):
        if what == "wall" or field != "U.wall":
            shutil.copy(os.path.join("0.orig", field), case.file("0"))
    mesh, factor = "system/blockMeshDict", 2 if fine else 1
    length = 180
    if what != "wall":
        case.change("constant/phaseProperties", r"^phases .*", "phases (tnt air);")
        case.change("constant/phaseProperties", r"(?s)^blocks\n.*?(?=\n// \*)", "")
        for entry in ("balance", "energy"):
            case.change("system/controlDict", rf"(?s)^    {entry}\n    \{{.*?\n    \}}\n", "")
    if what == "rigid":
        length = 120
        case.change(mesh, r"\(1\.2 ", "(0 ")
        case.change(mesh, r"\(\(0 1 5 4\)\)", "((0 1 5 4) (1 2 6 5))")
        case.change(mesh, r"(?<=\(0 4 7 3\)) \(1 2 6 5\)", "")
    case.change(mesh, r"^nx .*", f"nx      {factor*length};")
    case.change(mesh, r"^ny .*", f"ny      {factor*90};")
    case.change("system/controlDict", r"^endTime .*", f"endTime {1.6e-3 if fine else 2.5e-3};")
    print(f"Running {case.path}", flush=True)
    for application in ("blockMesh", "setFluids", *["setMaterialPoints"]*(what == "wall"),
                        "materialPointFoam"):
        case.run(application)


if __name__ == "__main__":
    try:
        run("free", "free")
        run("rigid", "rigid")
        if "fine" in sys.argv[1:]:
            run("fine", "wall", True)
            run("fineFree", "free", True)
            run("fineRigid", "rigid", True)
    except RunFailed as error:
        sys.exit(f"variants.py: {error}")
