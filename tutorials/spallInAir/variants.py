"""The same plates in vacuum, porous, and in air without drag, in variants/."""

import os

from mpm.variants import changeFiles, runVariants

#: name: file, pattern, text
VACUUM = (("constant/phaseProperties", r"\(air target flyer\)", "(target flyer)"),
          ("constant/phaseProperties", r"(?s)^air\n\{.*?^\}\n", ""),
          ("constant/phaseProperties", r"^ *drag .*?$", ""),
          ("constant/phaseProperties", r"ambientPressure 1e5;", ""),
          ("system/setMaterialPointsDict", r"^ *(stress|pressure) .*?$", ""),
          ("system/controlDict", r"(?s)^    gas\n    \{.*?^    \}\n", ""))
POROUS = (("system/setMaterialPointsDict", r"^fraction .*?;", "fraction 0.9;"),)
NO_DRAG = (("constant/phaseProperties", r"type stick;", "type none;"),)
VARIANTS = {"vacuum": VACUUM, "porous": POROUS, "noDrag": NO_DRAG}


def change(case, *rows):
    changeFiles(case, *rows)
    if VACUUM[0] in rows:
        for field in ("p", "T.air", "U.air"):
            os.remove(case.file("0", field))


runVariants(VARIANTS, change)
