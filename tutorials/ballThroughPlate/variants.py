"""In variants/: twice as many cells; a ball of aluminium; failure by plastic strain, and at
twice the stress; ball and plate in one velocity field. With arguments those that they name,
among them quarter: a quarter of the scene in 3D, coarse."""

import os
import sys

from mpm.variants import runVariants


def refine(case):
    case.change("system/blockMeshDict", r"^n  .*", "n 80;")
    case.change("system/blockMeshDict", r"^nx .*", "nx 640;")
    case.change("system/blockMeshDict", r"^nr .*", "nr 320;")


def soften(case):
    case.change("constant/phaseProperties", r"copperOFHC", "aluminium6061T6")


def ductile(case):
    """Damage of Johnson and Cook in place of a spall strength."""
    for metal in ("copperOFHC", "aluminium6061T6"):
        case.change("constant/phaseProperties",
                    rf"(?s)({metal}\".*?failureModel\n    {{\n        )type .*?^    }}",
                    rf'\1#include "$MPM_PROJECT_DIR/etc/materials/{metal}Damage"\n    }}')


def strengthen(case):
    case.change("constant/phaseProperties", r"strength .*?;", "strength 2.6e9;")


def join(case):
    case.change("constant/phaseProperties", r"^(ball|plate)\n{",
                r"\1\n{\n    velocityField metals;")
    case.change("constant/phaseProperties", r"^contact .*", "")
    os.rename(case.file("0/U.ball"), case.file("0/U.metals"))
    os.remove(case.file("0/U.plate"))
    case.change("0/U.metals", "U.ball", "U.metals")


def quarter(case):
    """y and z from the axis on, 16 cells over the ball's diameter."""
    mesh = "system/blockMeshDict"
    case.change(mesh, r"(?s)^// Cells over.*?(?=^scale)", "n 16; nx 96; nr 40;\n\n")
    case.change(mesh, r"(?s)^// Sector.*", """x0 -10; x1 50; R 25;

vertices
(
    ($x0 0 0) ($x1 0 0) ($x1 $R 0) ($x0 $R 0)
    ($x0 0 $R) ($x1 0 $R) ($x1 $R $R) ($x0 $R $R)
);

blocks (hex (0 1 2 3 4 5 6 7) ($nx $nr $nr) simpleGrading (1 1 1));

boundary
(
    axis { type symmetryPlane; faces ((0 1 5 4)); }
    back { type symmetryPlane; faces ((0 3 2 1)); }
    outside { type patch; faces ((0 4 7 3) (1 2 6 5) (3 7 6 2) (4 5 6 7)); }
);
""")
    for field in ("ball", "plate"):
        case.change(f"0/U.{field}", r"^    front .*\n", "")
        case.change(f"0/U.{field}", r"wedge|empty", "symmetryPlane")
    case.change("system/setMaterialPointsDict", r"\(0 0 -1\)", "(0 0 0)")
    case.change("system/setMaterialPointsDict", r"\(2.5e-3 .*\)", "(2.5e-3 22.5e-3 22.5e-3)")
    case.change("system/controlDict", r"^endTime .*", "endTime 9e-6;")


SERIES = {"fine": (refine,), "aluminium": (soften,), "ductile": (ductile,),
          "strong": (strengthen,), "oneField": (join,)}
ALL = {**SERIES, "quarter": (quarter,)}

if __name__ == "__main__":
    runVariants({name: ALL[name] for name in sys.argv[1:] or SERIES},
                lambda case, change: change(case))
