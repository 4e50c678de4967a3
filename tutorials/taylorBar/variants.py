"""The bar on other meshes, and the shot at 210 m/s whose outline was measured, in
variants/. With the argument fine also cells of 0.095 mm (minutes)."""

import os
import re
import shutil
import subprocess
import sys

#: cells over the radius, length of the bar [mm], cells over the length, speed [m/s]
VARIANTS = {"coarse": (10, 25.4, 66, 190), "wilkins": (20, 23.47, 122, 210)}
FINE = {"fine": (40, 25.4, 264, 190)}


def replace(path, pattern, text):
    with open(path) as f:
        old = f.read()
    new, count = re.subn(pattern, text, old, flags=re.M)
    if not count:
        sys.exit(f"variants.py: '{pattern}' is not in {path}")
    with open(path, "w") as f:
        f.write(new)


def change(case, cells, length, along, speed):
    """Numbers of a variant into a copy of the case."""
    mesh = os.path.join(case, "system/blockMeshDict")
    points = os.path.join(case, "system/setMaterialPointsDict")
    total = int(round(7.2*cells))
    replace(mesh, r"^nr .*", f"nr {14*cells//5};")
    replace(mesh, r"^nx .*", f"nx {total};")
    replace(mesh, r"^L .*", f"L {length*total/along!r};")
    replace(points, r"max .*", f"max ({length}e-3 3.81e-3 1);")
    replace(points, r"velocity .*", f"velocity ({-speed} 0 0);")


def run(case, *command):
    with open(os.path.join(case, "log." + command[0]), "w") as log:
        if subprocess.run(command, cwd=case, stdout=log, stderr=subprocess.STDOUT).returncode:
            sys.exit(f"variants.py: {command[0]} failed, see {log.name}")


if __name__ == "__main__":
    for name, numbers in {**VARIANTS, **(FINE if "fine" in sys.argv[1:] else {})}.items():
        case = os.path.join("variants", name)
        shutil.rmtree(case, ignore_errors=True)
        os.makedirs(os.path.join(case, "0"))
        for folder in ("constant", "system"):
            shutil.copytree(folder, os.path.join(case, folder),
                            ignore=shutil.ignore_patterns("polyMesh"))
        shutil.copy("0/U.bar", os.path.join(case, "0"))
        change(case, *numbers)
        print(f"Running {case}", flush=True)
        for command in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
            run(case, command)
