"""The same plates in vacuum, porous, and in air without drag, in variants/."""

import os
import re
import shutil
import subprocess
import sys

#: name: file, pattern, text
VACUUM = (("constant/phaseProperties", r"\(air target flyer\)", "(target flyer)"),
          ("constant/phaseProperties", r"^air\n\{.*?^\}\n", ""),
          ("constant/phaseProperties", r"^ *drag .*?$", ""),
          ("constant/phaseProperties", r"ambientPressure 1e5;", ""),
          ("system/setMaterialPointsDict", r"^ *(stress|pressure) .*?$", ""),
          ("system/controlDict", r"^    gas\n    \{.*?^    \}\n", ""))
POROUS = (("system/setMaterialPointsDict", r"^fraction .*?;", "fraction 0.9;"),)
NO_DRAG = (("constant/phaseProperties", r"type stick;", "type none;"),)
VARIANTS = {"vacuum": VACUUM, "porous": POROUS, "noDrag": NO_DRAG}


def replace(path, pattern, text):
    with open(path) as f:
        old = f.read()
    new, count = re.subn(pattern, text, old, flags=re.S | re.M)
    if not count:
        sys.exit(f"variants.py: '{pattern}' is not in {path}")
    with open(path, "w") as f:
        f.write(new)


for name, changes in VARIANTS.items():
    case = os.path.join("variants", name)
    shutil.rmtree(case, ignore_errors=True)
    os.makedirs(os.path.join(case, "0"))
    for folder in ("constant", "system"):
        shutil.copytree(folder, os.path.join(case, folder))
    for field in ("p", "T.air", "U.air", "U.plates"):
        if name != "vacuum" or field == "U.plates":
            shutil.copy(os.path.join("0", field), os.path.join(case, "0"))
    for file, pattern, text in changes:
        replace(os.path.join(case, file), pattern, text)
    for application in ("setMaterialPoints", "materialPointFoam"):
        print(f"Running {application} in {case}", flush=True)
        with open(os.path.join(case, "log." + application), "w") as log:
            code = subprocess.run([application], cwd=case, stdout=log,
                                  stderr=subprocess.STDOUT).returncode
        if code:
            sys.exit(f"variants.py: {application} failed, see {log.name}")
