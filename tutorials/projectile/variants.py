"""In variants/: the rod without strength (hydrodynamic limit); a target of 4340 steel;
with the argument fine also the case itself on cells of 0.25 mm up to 8 mm from the axis
(minutes); with tried what the README tells of (no debris, other functions; 42 us)."""

import os
import re
import shutil
import subprocess
import sys

WEAK = """type        J2Plasticity;
        rho         {rho};
        G           {G};
        yield       1e6;
        hardening   none;
        equationOfState {{ type MieGrueneisen; C0 {C0}; S {S}; Gamma0 {Gamma0}; }}"""

#: Constants of etc/materials without their strength
SHOCK = {"tungstenAlloy": {"rho": 17000, "G": "124e9", "C0": 3980, "S": 1.24, "Gamma0": 1.54},
         "steelHzB": {"rho": 7850, "G": "77.8e9", "C0": 3574, "S": 1.92, "Gamma0": 1.69}}


def replace(path, pattern, text):
    with open(path) as f:
        old = f.read()
    new, count = re.subn(pattern, lambda _: text, old, flags=re.M)
    if not count:
        sys.exit(f"variants.py: '{pattern}' is not in {path}")
    with open(path, "w") as f:
        f.write(new)


def weaken(case):
    """Both metals yield at 1 MPa; GIMP, no debris; 42 us, no times written between."""
    for metal, constants in SHOCK.items():
        replace(os.path.join(case, "constant/phaseProperties"),
                rf"#include .*{metal}\"", WEAK.format(**constants))
    # Matter without strength does not hold on to the rod: no debris apart
    oneField(case, "GIMP")


def soften(case):
    replace(os.path.join(case, "constant/phaseProperties"), r"steelHzB", "steel4340")


def short(case):
    control = os.path.join(case, "system/controlDict")
    replace(control, r"^endTime .*", "endTime 42e-6;")
    replace(control, r"^writeInterval .*", "writeInterval 42e-6;")


def oneField(case, functions="linear", dilatation="point"):
    """No debris apart."""
    short(case)
    replace(os.path.join(case, "constant/phaseProperties"), r"limit .*", "limit 1e9;")
    replace(os.path.join(case, "system/fvSolution"), r"shapeFunction .*",
            f"shapeFunction {functions}; dilatation {dilatation};")


def refine(case):
    mesh = os.path.join(case, "system/blockMeshDict")
    replace(mesh, r"^nx .*", "nx 512;")
    replace(mesh, r"^nr .*", "nr 56;")
    replace(mesh, r"simpleGrading .*", "simpleGrading (1 ((8 32 1) (24 24 10)) 1)")


def run(case, *command):
    with open(os.path.join(case, "log." + command[0]), "w") as log:
        if subprocess.run(command, cwd=case, stdout=log, stderr=subprocess.STDOUT).returncode:
            sys.exit(f"variants.py: {command[0]} failed, see {log.name}")


VARIANTS = {"hydrodynamic": weaken, "steel4340": soften}
MORE = {"fine": {"fine": refine},
        "tried": {"linear": oneField, "gimp": lambda c: oneField(c, "GIMP"),
                  "linearCellMean": lambda c: oneField(c, dilatation="cellMean"),
                  "gimpCellMean": lambda c: oneField(c, "GIMP", "cellMean")}}

if __name__ == "__main__":
    chosen = dict(VARIANTS)
    for argument in sys.argv[1:]:
        chosen.update(MORE[argument])
    for name, change in chosen.items():
        case = os.path.join("variants", name)
        shutil.rmtree(case, ignore_errors=True)
        os.makedirs(os.path.join(case, "0"))
        for folder in ("constant", "system"):
            shutil.copytree(folder, os.path.join(case, folder),
                            ignore=shutil.ignore_patterns("polyMesh"))
        for phase in ("rod", "target", "debris"):
            shutil.copy(f"0/U.{phase}", os.path.join(case, "0"))
        change(case)
        print(f"Running {case}", flush=True)
        for command in ("blockMesh", "setMaterialPoints", "materialPointFoam"):
            run(case, command)
