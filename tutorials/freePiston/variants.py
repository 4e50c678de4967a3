"""The same on other meshes, without drag, with other forms of it, in variants/."""

import initialVelocity
from mpm.variants import runVariants

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


runVariants(VARIANTS, change, initialVelocity.start)
