"""In variants/: the rod without strength (hydrodynamic limit); a target of 4340 steel;
with the argument fine also the case itself on cells of 0.25 mm up to 8 mm from the axis
(minutes); with tried what the README tells of (no debris, other functions; 42 us)."""

import sys

from mpm.variants import runVariants

WEAK = """type        J2Plasticity;
        rho         {rho};
        G           {G};
        yield       1e6;
        hardening   none;
        equationOfState {{ type MieGrueneisen; C0 {C0}; S {S}; Gamma0 {Gamma0}; }}"""

#: Constants of etc/materials without their strength
SHOCK = {"tungstenAlloy": {"rho": 17000, "G": "124e9", "C0": 3980, "S": 1.24, "Gamma0": 1.54},
         "steelHzB": {"rho": 7850, "G": "77.8e9", "C0": 3574, "S": 1.92, "Gamma0": 1.69}}


def weaken(case):
    """Both metals yield at 1 MPa; GIMP, no debris; 42 us, no times written between."""
    for metal, constants in SHOCK.items():
        case.change("constant/phaseProperties", rf"#include .*{metal}\"",
                    WEAK.format(**constants))
    # Matter without strength does not hold on to the rod: no debris apart
    oneField(case, "GIMP")


def soften(case):
    case.change("constant/phaseProperties", r"steelHzB", "steel4340")


def short(case):
    case.change("system/controlDict", r"^endTime .*", "endTime 42e-6;")
    case.change("system/controlDict", r"^writeInterval .*", "writeInterval 42e-6;")


def oneField(case, functions="linear", dilatation="point"):
    """No debris apart."""
    short(case)
    case.change("constant/phaseProperties", r"limit .*", "limit 1e9;")
    case.change("system/fvSolution", r"shapeFunction .*",
                f"shapeFunction {functions}; dilatation {dilatation};")


def refine(case):
    mesh = "system/blockMeshDict"
    case.change(mesh, r"^nx .*", "nx 512;")
    case.change(mesh, r"^nr .*", "nr 56;")
    case.change(mesh, r"simpleGrading .*", "simpleGrading (1 ((8 32 1) (24 24 10)) 1)")


VARIANTS = {"hydrodynamic": (weaken,), "steel4340": (soften,)}
MORE = {"fine": {"fine": (refine,)},
        "tried": {"linear": (oneField,), "gimp": (oneField, "GIMP"),
                  "linearCellMean": (oneField, "linear", "cellMean"),
                  "gimpCellMean": (oneField, "GIMP", "cellMean")}}

if __name__ == "__main__":
    for argument in sys.argv[1:]:
        VARIANTS.update(MORE[argument])
    runVariants(VARIANTS, lambda case, change, *arguments: change(case, *arguments))
