"""The same on other meshes, without drag, with other forms of it, in variants/."""

import os
import re
import shutil
import subprocess
import sys

#: cells, drag, faceDrag, scheme of the gas(, poreFloor)
VARIANTS = {
    "none50": (50, "type none;", "impedance", "upwind"),
    "none100": (100, "type none;", "impedance", "upwind"),
    "none200": (200, "type none;", "impedance", "upwind"),
    "none100vanLeer": (100, "type none;", "impedance", "vanLeer"),
    "none100pores": (100, "type none;", "impedance", "vanLeer", 0.001),
    "stick50": (50, "type stick;", "impedance", "upwind"),
    "stick200": (200, "type stick;", "impedance", "upwind"),
    "stick100velocity": (100, "type stick;", "velocity", "upwind"),
    "stick100noFaceDrag": (100, "type stick;", "none", "upwind"),
    "stick100vanLeer": (100, "type stick;", "impedance", "vanLeer"),
    "weak100": (100, "type constant; value 1e4;", "impedance", "upwind"),
    "middle100": (100, "type constant; value 1e6;", "impedance", "upwind")}


def replace(path, pattern, text):
    with open(path) as f:
        old = f.read()
    new, count = re.subn(pattern, text, old, flags=re.M)
    if not count:
        sys.exit(f"variants.py: '{pattern}' is not in {path}")
    with open(path, "w") as f:
        f.write(new)


def run(case, *command):
    with open(os.path.join(case, "log." + os.path.basename(command[0])), "w") as log:
        if subprocess.run(command, cwd=case, stdout=log, stderr=subprocess.STDOUT).returncode:
            sys.exit(f"variants.py: {command[0]} failed, see {log.name}")


for name, (cells, drag, face, scheme, *pores) in VARIANTS.items():
    case = os.path.join("variants", name)
    shutil.rmtree(case, ignore_errors=True)
    os.makedirs(os.path.join(case, "0"))
    for folder in ("constant", "system"):
        shutil.copytree(folder, os.path.join(case, folder),
                        ignore=shutil.ignore_patterns("polyMesh"))
    for field in ("p", "T.air", "U.slab"):
        shutil.copy(os.path.join("0", field), os.path.join(case, "0"))
    replace(os.path.join(case, "system/blockMeshDict"), r"^n .*", f"n           {cells};")
    replace(os.path.join(case, "constant/phaseProperties"), r"drag .*", f"drag {{ {drag} }}")
    replace(os.path.join(case, "constant/phaseProperties"), r"faceDrag .*",
            f"faceDrag {face};")
    if pores:
        replace(os.path.join(case, "constant/phaseProperties"), r"poreFloor .*",
                f"poreFloor {pores[0]};")
    if scheme != "upwind":
        for field, vector in (("rho", ""), ("U", "V"), ("p", "")):
            replace(os.path.join(case, "system/fvSchemes"), rf"reconstruct\({field}\).*",
                    f"reconstruct({field}) {scheme}{vector};")
    print(f"Running {case}", flush=True)
    run(case, "blockMesh")
    run(case, "setMaterialPoints")
    subprocess.run([sys.executable, "initialVelocity.py", case], check=True)
    run(case, "materialPointFoam")
