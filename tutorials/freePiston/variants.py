"""The same on other meshes, without drag, with other forms of it, in variants/."""

import initialVelocity
from mpm.variants import runVariants

#: cells, drag, faceDrag, scheme of the gas(, poreFloor)
VARIANTS = {
    "none50": (50, "type none;", 3, "upwind"), "none100": (100, "type none;", 3, "upwind"),
    "none200": (200, "type none;", 3, "upwind"),
    "none100vanLeer": (100, "type none;", 3, "vanLeer"),
    "none100pores": (100, "type none;", 3, "vanLeer", 0.001),
    "stick50": (50, "type stick;", 3, "upwind"), "stick200": (200, "type stick;", 3, "upwind"),
    "stick100face1": (100, "type stick;", 1, "upwind"),
    "stick100face0": (100, "type stick;", 0, "upwind"),
    "stick100vanLeer": (100, "type stick;", 3, "vanLeer"),
    "weak100": (100, "type constant; value 1e4;", 3, "upwind"),
    "middle100": (100, "type constant; value 1e6;", 3, "upwind")}


def change(case, cells, drag, face, scheme, poreFloor=None):
    """Numbers of a variant into a copy of the case."""
    phases = "constant/phaseProperties"
    case.change("system/blockMeshDict", r"^n .*", f"n           {cells};")
    case.change(phases, r"drag .*", f"drag {{ {drag} }}")
    case.change(phases, r"faceDrag .*", f"faceDrag {face};")
    if poreFloor:
        case.change(phases, r"poreFloor .*", f"poreFloor {poreFloor};")
    if scheme != "upwind":
        for field, vector in (("rho", ""), ("U", "V"), ("p", "")):
            case.change("system/fvSchemes", rf"reconstruct\({field}\).*",
                        f"reconstruct({field}) {scheme}{vector};")


runVariants(VARIANTS, ("p", "T.air", "U.slab"), change, initialVelocity.start)
