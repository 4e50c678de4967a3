#!/usr/bin/env python3
"""Wrong input and runs that go wrong.

Each row changes one thing of the small case and runs the initialiser or the
solver. What must hold: an end within the time limit by one fatal message, with
what the user needs to find the mistake (file, line and choices, or point,
position and time); no signal, no core, and the time folders that were there
before stay byte for byte. Rows that start with "allowed" must run to the end.

    test.py              all rows
    test.py word ...     only rows whose name has one of the words

A row's case stays in tests/run/badInput/cases/<number> with its log.
"""

import glob
import os
import re
import shutil
import struct
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
PROJECT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
RUN = os.path.join(PROJECT, "tests", "run", "badInput", "cases")
LIMIT = 200.0 if os.environ.get("MPM_BUILD") == "sanitize" else 10.0
CRASH = r"printStack|[Ss]egmentation fault|AddressSanitizer|runtime error:" \
    r"|Assertion|terminate called"

sys.path.insert(0, os.path.join(PROJECT, "tests", "lib"))
from launcher import launch  # noqa: E402
from report import Report  # noqa: E402
from fluidRows import fluidRows  # noqa: E402
from gasRows import air, gasRows  # noqa: E402
from runRows import gravity, runRows  # noqa: E402
from unitRows import unitRows  # noqa: E402


# --- a case and changes of it ------------------------------------------------

class Case:
    def __init__(self, path, seed):
        self.path = path
        shutil.copytree(seed, path)

    def file(self, name):
        return os.path.join(self.path, name)

    def read(self, name):
        with open(self.file(name), encoding="latin-1") as f:
            return f.read()

    def write(self, name, text):
        os.makedirs(os.path.dirname(self.file(name)), exist_ok=True)
        with open(self.file(name), "w", encoding="latin-1") as f:
            f.write(text)

    def sub(self, name, pattern, new):
        """Replace the first place where a pattern matches; it must."""
        text, n = re.subn(pattern, lambda m: m.expand(new), self.read(name),
                          count=1, flags=re.S)
        if not n:
            raise LookupError(f"{name} has no {pattern}")
        self.write(name, text)

    def remove(self, name):
        path = self.file(name)
        shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)

    def column(self, name, change):
        """Rewrite the values of a field of points, given as strings."""
        text = self.read(name)
        head, body = re.match(r"(.*?// (?:\* )+//\n)(.*)", text, re.S).groups()
        n, same, values = re.match(r"\s*(\d+)\s*(?:\{(.*?)\}|\((.*)\))", body,
                                   re.S).groups()
        if same is not None:
            values = [same]*int(n)
        else:
            values = re.findall(r"\([^()]*\)|[^\s()]+", values)
        values = change(values)
        self.write(name, f"{head}\n{len(values)}\n(\n"
                   + "\n".join(values) + "\n)\n")

    def contents(self):
        """Bytes of all files in time folders."""
        found = {}
        for folder in os.listdir(self.path):
            if re.fullmatch(r"[0-9].*", folder):
                for root, _, files in os.walk(self.file(folder)):
                    for f in files:
                        name = os.path.join(root, f)
                        with open(name, "rb") as stream:
                            found[os.path.relpath(name, self.path)] = \
                                stream.read()
        return found

    def run(self, command, environment=None, limit=LIMIT):
        """Exit status (None: stopped at the limit), output, seconds."""
        start = time.monotonic()
        with open(self.file("log." + command[0]), "ab+") as log:
            begin = log.tell()
            status, _ = launch(command, self.path, log.name, limit, session=True,
                               environment=environment)
            seconds = time.monotonic() - start
            log.seek(begin)
            text = log.read(2_000_000).decode("latin-1")
        return status, text, seconds


def replace(name, pattern, new):
    return lambda case: case.sub(name, pattern, new)


def remove(name):
    return lambda case: case.remove(name)


def setValue(name, p, value):
    """Another value for point p of a column."""
    return lambda case: case.column(
        name, lambda v: v[:p] + [value(v[p]) if callable(value) else value]
        + v[p + 1:])


def setBinary(name, p, n, value):
    """The first of n numbers of point p in a binary column."""
    def change(case):
        with open(case.file(name), "rb") as f:
            data = f.read()
        head, size = re.match(rb"(.*?\n(\d+)\n?\()", data, re.S).groups()
        at = len(head) + 8*n*p
        assert data[len(head) + 8*n*int(size):][:1] == b")", name
        with open(case.file(name), "wb") as f:
            f.write(data[:at] + struct.pack("d", value) + data[at + 8:])
    return change


def several(*changes):
    def change(case):
        for c in changes:
            c(case)
    return change


def eroding(entries):
    """Erosion of the phases, which have the same entries."""
    return lambda case: case.sub(PHASES, r"(velocityField\s+body;)",
                                 r"\1 erosion { " + entries + " }")


# --- what the message must hold ----------------------------------------------

def line(name):
    """File and line of a dictionary."""
    return rf"file: \S*{name}\S* (at|from) line \d+"


POINT = r"[Mm]aterial point \d+ of \w+ (at|.* from) \(\S+ \S+ \S+\)"
TIME = r"time \d"
VALID = r"[Vv]alid \w[\w ]*:"

PHASES = "constant/phaseProperties"
NUMERICS = "system/fvSolution"
REGIONS = "system/setMaterialPointsDict"
CONTROL = "system/controlDict"
BLOCKS = "system/blockMeshDict"
BLOCK = "0/lagrangian/block/"

inPhases = [line("phaseProperties")]
inLaw = [line("phaseProperties"), r"constitutiveModel"]
inErosion = [line("phaseProperties"), "erosion"]
inContact = [line("phaseProperties"), "contact"]
inRegion = [line("setMaterialPointsDict")]
inControl = [line("controlDict")]
inNumerics = [line("fvSolution")]


def meshOf(change):
    """Change of blockMeshDict: mesh anew, and points if the mesh has them."""
    def make(case):
        change(case)
        status, text, _ = case.run(["blockMesh"])
        if status:
            raise RuntimeError("blockMesh failed: " + text[-500:])
    return make


def withPoints(change):
    def make(case):
        change(case)
        status, text, _ = case.run(["setMaterialPoints"])
        if status:
            raise RuntimeError("setMaterialPoints failed: " + text[-500:])
    return make


skewed = meshOf(replace(BLOCKS, r"\(10 10 0\) (.*)\(10 10 1\)",
                        r"(9 10 0) \1(9 10 1)"))
graded = meshOf(several(
    replace(BLOCKS, r"\(10 10 1\) simple", "(5 10 1) simple"),
    replace(BLOCKS, r"simpleGrading \(1 1 1\)", "simpleGrading (4 1 1)")))


def lShape(case):
    """Three blocks around a re-entrant corner at (5 5)."""
    xy = [(0, 0), (5, 0), (10, 0), (0, 5), (5, 5), (10, 5), (0, 10), (5, 10)]
    vertices = "".join(f"({x} {y} {z})\n" for z in (0, 1) for x, y in xy)
    quads = [(0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6)]
    blocks = "".join(
        "hex (" + " ".join(str(v + z) for z in (0, 8) for v in q)
        + ") (5 5 1) simpleGrading (1 1 1)\n" for q in quads)

    def side(a, b):
        return f"({a} {b} {b + 8} {a + 8})"

    outside = " ".join(side(a, b) for a, b in
                       [(2, 5), (5, 4), (4, 7), (7, 6), (6, 3), (3, 0)])
    flat = "".join(f"({a} {d} {c} {b}) ({a + 8} {b + 8} {c + 8} {d + 8})\n"
                   for a, b, c, d in quads)
    case.sub(BLOCKS, r"vertices.*",
             f"vertices\n(\n{vertices});\nblocks\n(\n{blocks});\nboundary\n(\n"
             f"outside {{ type patch; faces ({outside}); }}\n"
             f"ground {{ type wall; faces ({side(0, 1)} {side(1, 2)}); }}\n"
             f"frontAndBack {{ type empty; faces ({flat}); }}\n);\n")


def wedge(case, shift=0, back=1.0):
    """About y, radius x; shift moves it off the axis, back stretches one side."""
    a, b = 1 + shift, 10 + shift
    vertices = " ".join(f"({x} {y} {z})" for k in (-1, back) for x, y, z in (
        (a, 0, 0.05*k), (b, 0, 0.5*k), (b, 10, 0.5*k), (a, 10, 0.05*k)))
    case.sub(BLOCKS, r"vertices.*", "vertices\n(" + vertices + """);
blocks (hex (0 1 2 3 4 5 6 7) (9 10 1) simpleGrading (1 1 1));
boundary
(
    outside { type patch; faces ((3 7 6 2) (0 4 7 3) (1 2 6 5)); }
    ground { type wall; faces ((0 1 5 4)); }
    front { type wedge; faces ((0 3 2 1)); }
    back { type wedge; faces ((4 5 6 7)); }
);
""")
    case.sub("0/U.body", r"frontAndBack\s*\{.*?\}",
             "front { type wedge; }\n    back { type wedge; }")


def prisms(case):
    """The left side of the block is one edge."""
    case.sub(BLOCKS, r"hex \(0 1 2 3 4 5 6 7\)", "hex (0 1 2 0 4 5 6 4)")
    case.sub(BLOCKS, r"\(10 10 0\) \(0 10 0\)", "(10 10 0)")
    case.sub(BLOCKS, r"\(0 0 1\) \(10 0 1\) \(10 10 1\) \(0 10 1\)",
             "(0 0 1) (10 0 1) (10 10 1)")
    case.sub(BLOCKS, r"hex \(0 1 2 0 4 5 6 4\)", "hex (0 1 2 0 3 4 5 3)")
    case.sub(BLOCKS, r"\(\(3 7 6 2\) \(0 4 7 3\) \(1 2 6 5\)\)",
             "((0 3 5 2) (1 2 5 4))")
    case.sub(BLOCKS, r"\(\(0 1 5 4\)\)", "((0 1 4 3))")
    case.sub(BLOCKS, r"\(\(0 3 2 1\) \(4 5 6 7\)\)", "((0 0 2 1) (3 4 5 3))")


def tetrahedron(case):
    """A mesh of one tetrahedron."""
    def put(name, kind, text):
        case.write(f"constant/polyMesh/{name}",
                   "FoamFile { version 2.0; format ascii; class "
                   f"{kind}; object {name}; }}\n{text}\n")

    case.remove("constant/polyMesh")
    put("points", "vectorField", "4((0 0 0)(10 0 0)(0 10 0)(0 0 10))")
    put("faces", "faceList", "4(3(0 2 1)3(0 1 3)3(0 3 2)3(1 2 3))")
    put("owner", "labelList", "4(0 0 0 0)")
    put("neighbour", "labelList", "0()")
    put("boundary", "polyBoundaryMesh",
        "1(outside { type patch; nFaces 4; startFace 0; })")


def truncate(name, part=0.5):
    def change(case):
        with open(case.file(name), "rb") as f:
            data = f.read()
        with open(case.file(name), "wb") as f:
            f.write(data[:int(part*len(data))])
    return change


def binary(case):
    """Write the time 0.1 anew in binary, with scatter in all columns."""
    case.column("0.05/lagrangian/block/V",
                lambda v: [repr(float(x)*(1 + 1e-9*i)) for i, x in enumerate(v)])
    case.column("0.05/lagrangian/block/m",
                lambda v: [repr(float(x)*(1 + 1e-9*i)) for i, x in enumerate(v)])
    case.column("0.05/lagrangian/block/halfSize",
                lambda v: [f"({0.25 + 1e-9*i!r} 0.25 0)" for i in range(len(v))])
    case.column("0.05/lagrangian/block/damage",
                lambda v: [repr(1e-30*i) for i in range(len(v))])
    case.remove("0.1")
    case.sub(CONTROL, r"writeFormat +ascii", "writeFormat binary")
    case.sub(CONTROL, r"endTime +0\.2", "endTime 0.1")
    status, text, _ = case.run(SOLVE)
    case.sub(CONTROL, r"endTime +0\.1", "endTime 0.2")
    if status:
        raise RuntimeError("materialPointFoam failed: " + text[-500:])


def fields(a, b):
    """Velocity field names of the phases base and block."""
    def change(case):
        text = case.read("0/U.body")
        for name in {a, b}:
            case.write(f"0/U.{name}", text.replace("U.body", f"U.{name}"))
        case.sub(PHASES, r"velocityField\s+body", f"velocityField {a}")
        case.sub(PHASES, r"\$base;", f"$base;\n    velocityField {b};")
    return change


def contact(entries, ground="calculated; //"):
    """Base and block with own fields, the ground free for contact."""
    return several(
        replace("0/U.body", "fixedValue;", ground), fields("base", "block"),
        replace(PHASES, r"(phases\s)", f"contact {{ {entries} }}\n\\1"))


def movingGround(table):
    """Velocity of the ground from a table of time."""
    return several(
        lambda case: case.write("table", table + "\n"),
        replace("0/U.body", r"fixedValue;.*?;",
                'timeVaryingUniformFixedValue;\n    file "<case>/table";\n'
                "    outOfBounds error;"))


def fixedStep(deltaT):
    return several(replace(CONTROL, "5e-4", deltaT),
                   replace(CONTROL, "adjustTimeStep  yes", "adjustTimeStep no"))


def rigid(entries):
    """The block as a rigid phase."""
    return replace(PHASES, r"\$base;", "type rigid; velocityField body; " + entries)


def rigidMotion(entries):
    return rigid("rho 7800; motion { " + entries + " }")


def bodyForce(entries):
    return replace(PHASES, r"\$base;", "$base; bodyForce { " + entries + " }")


def inGas(entries, air="", region=""):
    """The block as grains in a gas, with entries of the phase, the gas and the
    region."""
    def fields(case):
        for name, kind, dimensions, value, ground in (
                ("p", "volScalarField", "[1 -1 -2 0 0 0 0]", "1e5", "zeroGradient"),
                ("T.air", "volScalarField", "[0 0 0 1 0 0 0]", "300", "zeroGradient"),
                ("U.air", "volVectorField", "[0 1 -1 0 0 0 0]", "(0 0 0)", "slip")):
            case.write("0/" + name, "FoamFile { version 2.0; format ascii; class "
                       f"{kind}; object {name}; }}\ndimensions {dimensions};\n"
                       f"internalField uniform {value};\nboundaryField\n{{\n"
                       "outside { type zeroGradient; }\n"
                       f"ground {{ type {ground}; }}\nfrontAndBack {{ type empty; }}\n}}\n")
        case.write("system/fvSchemes", """FoamFile
{ version 2.0; format ascii; class dictionary; object fvSchemes; }
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes { default none; }
laplacianSchemes { default Gauss linear corrected; }
snGradSchemes { default corrected; }
interpolationSchemes
{
    default linear;
    "reconstruct.*" upwind;
}
""")
    return several(
        fields,
        replace(PHASES, r"base block", "air base block"),
        replace(PHASES, r"(base\s*\{)",
                f"air {{ type gas; thermo perfectGas; R 287; gamma 1.4; {air} }}\n\\1"),
        replace(PHASES, r"\$base;", "velocityField body; " + entries),
        replace(REGIONS, r"(velocity +\(0 -1 0\);)", r"\1 " + region))


NO_STRESS = "constitutiveModel { type noStress; rho 2500; } "
GRAINS = "volumeModel grains; " + NO_STRESS
HEAT = GRAINS + "Cv 800; heatTransfer { type constant; value 10; } "
def law(entries):
    """Another law for both phases."""
    return replace(PHASES, r"constitutiveModel\s*\{.*?\}",
                   "constitutiveModel { rho 1000; " + entries + " }")


def failure(entries):
    return replace(PHASES, r"failureModel\s*\{.*?\}", "failureModel { " + entries + " }")


METAL = "type J2Plasticity; G 4e5; K 6e5; yield 1e4; hardening none; "
COOK = ("type JohnsonCook; G 4e5; A 1e4; B 1e4; n 0.3; C 0.02; m 1; referenceRate 1;"
        " referenceTemperature 300; meltTemperature 1000; cp 400; beta 0.9; ")
GRUENEISEN = "equationOfState { type MieGrueneisen; C0 30; S 1.5; Gamma0 2; } "
SOIL = ("type DruckerPrager; E 1e6; nu 0.2; cohesion 1e3; frictionAngle 30;"
        " dilationAngle 0; ")
BEADS = "type muI; E 1e6; nu 0.2; muS 0.4; mu2 0.6; I0 0.3; packing 0.6; "
DAMAGE = ("type JohnsonCookDamage; D1 0.5; D2 4; D3 -3; D4 0.01; D5 1; referenceRate 1;"
          " referenceTemperature 300; meltTemperature 1000; ")


def nanLaw(n):
    return several(
        replace(CONTROL, "application", 'libs ("../nanLaw/libnanLaw.so");\n'
                "application"),
        replace(PHASES, r"type\s+linearElastic;",
                f"type nanLaw; nanAfter {n};"),
        replace(PHASES, r"nu\s+0.2;", ""),
        replace(PHASES, r"failureModel\s*\{.*?\}", ""))


def function(kind, entries):
    """A function object of the solver."""
    return replace(CONTROL, "application",
                   f"functions {{ object {{ type materialPoint{kind}; "
                   f"libs (mpmFunctionObjects); {entries} }} }}\napplication")


# --- rows: name, programme, change, patterns of the message, options ---------

SET, SOLVE = ["setMaterialPoints"], ["materialPointFoam"]

#- keywords that nobody reads, and required ones misspelt: then the message
#  must hold the misspelt word or the valid ones
ROWS = [
    ("keyword of phaseProperties", SOLVE,
     replace(PHASES, "phases", "dragModel none;\nphases"),
     [line("phaseProperties"), "dragModel", VALID]),
    ("keyword of phaseProperties", SET,
     replace(PHASES, "phases", "dragModel none;\nphases"),
     [line("phaseProperties"), "dragModel", VALID]),
    ("keyword of phase", SOLVE,
     replace(PHASES, "velocityField", "velocityfield"),
     [line("phaseProperties"), "velocityfield", VALID]),
    ("keyword of phase", SET,
     replace(PHASES, "velocityField", "velocityfield"),
     [line("phaseProperties"), "velocityfield", VALID]),
    ("required keyword of phase", SOLVE,
     replace(PHASES, "constitutiveModel", "constitutivModel"),
     [line("phaseProperties"), "constitutivModel|" + VALID]),
    ("keyword phases", SOLVE, replace(PHASES, r"phases\s", "phase "),
     [line("phaseProperties"), "phases"]),
    ("phase without dictionary", SOLVE, replace(PHASES, "base block", "base brick"),
     [line("phaseProperties"), "brick"]),
    ("keyword of law", SOLVE, replace(PHASES, "nu  ", "Nu 0.1; nu  "),
     inLaw + ["Nu", VALID]),
    ("required keyword of law", SOLVE, replace(PHASES, "nu  ", "Nu  "),
     inLaw + ["Nu", VALID]),
    ("required keyword rho of law", SOLVE, replace(PHASES, "rho ", "rhoo "),
     inLaw + ["rhoo|" + VALID]),
    ("keyword of failureModel", SOLVE,
     replace(PHASES, "strength", "toughness 1; strength"),
     [line("phaseProperties"), "toughness", VALID]),
    ("required keyword of failureModel", SOLVE,
     replace(PHASES, "strength", "strenght"),
     [line("phaseProperties"), "strenght|" + VALID]),
    ("keyword of weibull", SOLVE,
     replace(PHASES, "strength", "weibull { modulus 5; sead 1; } strength"),
     [line("phaseProperties"), "sead", VALID]),
    ("keyword of materialPoints", SOLVE,
     replace(NUMERICS, "PICfraction", "PICFraction"),
     inNumerics + ["PICFraction", VALID]),
    ("required keyword of materialPoints", SOLVE,
     replace(NUMERICS, "transfer", "transfr"),
     inNumerics + ["transfr", VALID]),
    ("keyword of region", SET, replace(REGIONS, "velocity", "Velocity"),
     inRegion + ["Velocity", VALID]),
    ("required keyword of region", SET, replace(REGIONS, "phase  ", "phas  "),
     inRegion + ["phas[ .\n]|" + VALID]),
    ("required keyword of shape", SET, replace(REGIONS, "max ", "maxx "),
     inRegion + ["maxx|" + VALID]),
    ("keyword regions", SET, replace(REGIONS, "regions", "region"),
     inRegion + ["regions"]),

    #- choices that do not exist
    ("unknown law", SOLVE, replace(PHASES, "linearElastic", "hyperGlue"),
     inLaw + ["hyperGlue", VALID, "linearElastic"]),
    ("unknown law", SET, replace(PHASES, "linearElastic", "hyperGlue"),
     inLaw + ["hyperGlue", VALID, "linearElastic"]),
    ("unknown failureModel", SOLVE,
     replace(PHASES, "maxPrincipalStress", "bang"),
     [line("phaseProperties"), "bang", VALID, "maxPrincipalStress"]),
    ("unknown shapeFunction", SOLVE, replace(NUMERICS, "GIMP", "spline9"),
     inNumerics + ["spline9", VALID, "GIMP", "cubicBSpline", "linear", "quadraticBSpline"]),
    ("turnSides with GIMP", SOLVE, replace(NUMERICS, "transfer", "turnSides true; transfer"),
     inNumerics + ["turnSides is for shapeFunction nodeDual in 2D and 3D, here it is GIMP"]),
    ("unknown transfer", SOLVE, replace(NUMERICS, "FLIP", "PIC9"),
     inNumerics + ["PIC9", VALID, "FLIP", "FMPM", "XPIC", "APIC"]),
    ("unknown stressUpdate", SOLVE,
     replace(NUMERICS, "transfer", "stressUpdate USM; transfer"),
     inNumerics + ["USM", VALID, "MUSL", "USL", "USF", "USAVG"]),
    ("unknown dilatation", SOLVE,
     replace(NUMERICS, "transfer", "dilatation mean; transfer"),
     inNumerics + ["mean", VALID, "point", "cellMean"]),
    ("unknown affineMatrix", SOLVE,
     replace(NUMERICS, r"FLIP;.*?0\.01;", "APIC; affineMatrix full;"),
     inNumerics + ["full", VALID, "gradient", "moment"]),
    ("PICfraction of another transfer", SOLVE, replace(NUMERICS, "FLIP", "APIC"),
     inNumerics + ["PICfraction belongs to transfer FLIP, not to APIC"]),
    ("order of another transfer", SOLVE,
     replace(NUMERICS, "transfer", "order 2; transfer"),
     inNumerics + ["order belongs to transfer FMPM or XPIC, not to FLIP"]),
    ("XPIC of order 0", SOLVE,
     replace(NUMERICS, r"FLIP;.*?0\.01;", "XPIC; order 0;"),
     inNumerics + ["order is 0", r"\[1, 100\]"]),
    ("word for energyBudget", SOLVE,
     replace(NUMERICS, "transfer", "energyBudget some; transfer"),
     inNumerics + ["some|energyBudget"]),
    ("keyword of materialPointEnergy", SOLVE,
     replace(CONTROL, r"maxCo", "functions { energy { type materialPointEnergy;"
             " libs (mpmFunctionObjects); origin (0 0 0); } }\nmaxCo"),
     [line("controlDict"), "origin", VALID]),
    ("unknown region type", SET, replace(REGIONS, "box", "blob"),
     inRegion + ["blob", VALID, "box", "cylinder"]),
    ("unknown phase of region", SET, replace(REGIONS, "phase  +block", "phase brick"),
     inRegion + ["brick", VALID, "base", "block"]),
    ("unknown type of phase", SOLVE,
     replace(PHASES, "velocityField", "type liquid; velocityField"),
     [line("phaseProperties"), "liquid", VALID, "materialPoints"]),
    ("phase listed twice", SOLVE, replace(PHASES, "base block", "base block base"),
     [line("phaseProperties"), "base is listed twice"]),

    #- laws of metals, soils, fluids; equations of state; failure models
    ("allowed: J2Plasticity", SOLVE, law(METAL), None),
    ("allowed: JohnsonCook with energy", SOLVE, law(COOK + GRUENEISEN), None),
    ("allowed: JohnsonCook, its damage", SOLVE,
     several(law(COOK + "K 1e6;"), failure(DAMAGE)), None),
    ("allowed: JohnsonCook in GPa, J/g/K and degrees Celsius", SOLVE,
     law("G 0.4; " + COOK.replace("G 4e5;", "").replace("cp 400", "cp 0.4")
         .replace("Temperature 300", "Temperature 27") + "K 1e6;"), None,
     {"warnings": 6, "has": "J/kg/K, 477 for 0.477 J/g/K"}),
    ("allowed: law of etc/materials", SOLVE,
     law('#include "$MPM_PROJECT_DIR/etc/materials/copperOFHC"\n'), None,
     {"has": "JohnsonCook", "maybe": True}),
    ("negative yield", SOLVE, law(METAL + "yield -1;"), inLaw + ["yield is -1"]),
    ("negative yield", SET, law(METAL + "yield -1;"), inLaw + ["yield is -1"]),
    ("unknown hardening", SOLVE, law(METAL + "hardening some;"),
     inLaw + ["some", VALID, "none", "linear", "power"]),
    ("hardening linear without H", SOLVE, law(METAL + "hardening linear;"),
     inLaw + ["H is missing|Entry H"]),
    ("H of another hardening", SOLVE, law(METAL + "H 1;"), inLaw + ["H", VALID]),
    ("beta 1.2", SOLVE, law(COOK + "K 1e6; beta 1.2;"),
     inLaw + ["beta is 1.2", r"\[0, 1\]"]),
    ("melting below the reference", SOLVE, law(COOK + "K 1e6; meltTemperature 200;"),
     inLaw + ["meltTemperature is 200", "referenceTemperature"]),
    ("K and equationOfState", SOLVE, law(COOK + GRUENEISEN + "K 1;"),
     inLaw + ["K and equationOfState", "not both"]),
    ("neither K nor equationOfState", SOLVE, law(COOK),
     inLaw + ["One of the entries K and equationOfState"]),
    ("E beside G", SOLVE, law(METAL + "E 1e6; nu 0.2;"), inLaw + ["Entry G beside E"]),
    ("unknown equationOfState", SOLVE, law(COOK + "equationOfState { type glue; }"),
     inLaw + ["glue", VALID, "MieGrueneisen", "Tait", "linear"]),
    ("word for equationOfState", SOLVE, law(COOK + "equationOfState Tait;"),
     inLaw + ["equationOfState", "not a dictionary"]),
    ("keyword of equationOfState", SOLVE, law(COOK + GRUENEISEN.replace("S ", "s ")),
     inLaw + ["Unknown keyword s", VALID]),
    ("keyword of bulkViscosity", SOLVE,
     law(METAL + "bulkViscosity { linear 0.1; cubic 2; }"),
     inLaw + ["bulkViscosity", "cubic", VALID]),
    ("negative bulkViscosity", SOLVE,
     law(METAL + "bulkViscosity { linear -1; quadratic 2; }"), inLaw + ["linear is -1"]),
    ("dilationAngle above frictionAngle", SOLVE,
     law(SOIL + "match inner; dilationAngle 40;"), inLaw + ["dilationAngle is 40"]),
    ("DruckerPrager without match", SOLVE, law(SOIL), inLaw + ["match"]),
    ("mu2 below muS", SOLVE, law(BEADS + "d 1e-3; mu2 0.3;"), inLaw + ["mu2 is 0.3"]),
    ("muI without d", SOLVE, law(BEADS), inLaw + ["d"]),
    ("keyword of dilatancy", SOLVE,
     law(BEADS + "d 1e-3; dilatancy { phiC 0.58; K2 0; K3 4; K1 1; }"),
     inLaw + ["dilatancy", "K1", VALID]),
    ("unknown failed", SOLVE,
     replace(PHASES, "strength", "failed glue; strength"),
     inPhases + ["glue", VALID, "compression", "nothing"]),
    ("cells too wide for Gf", SOLVE, replace(PHASES, "1e5;", "1e3; Gf 1e-3;"),
     ["narrower than", "Gf", r"point \d+ of \w+ is"]),
    ("JohnsonCookDamage of an elastic law", SOLVE, failure(DAMAGE),
     ["JohnsonCookDamage", "plastic strain", "linearElastic"]),
    ("keyword of JohnsonCookDamage", SOLVE,
     several(law(COOK + "K 1e6;"), failure(DAMAGE + "D6 1;")),
     inPhases + ["D6", VALID]),
    ("TulerButcher without impulse", SOLVE,
     failure("type TulerButcher; strength 1e5; exponent 2;"), inPhases + ["impulse"]),
    ("GradyKipp with k 0", SOLVE, failure("type GradyKipp; k 0; m 9; crackSpeed 1;"),
     inPhases + ["k is 0"]),
    ("GradyKipp without crackSpeed", SOLVE, failure("type GradyKipp; k 1; m 9;"),
     inPhases + ["crackSpeed"]),
    ("GradyKipp with strength", SOLVE,
     failure("type GradyKipp; k 1; m 9; crackSpeed 1; strength 1;"),
     inPhases + ["strength", VALID]),
    ("limitOn of another model", SOLVE,
     failure("type maxPrincipalStrain; strain 0.1; limitOn total;"),
     inPhases + ["limitOn", VALID]),

    #- rigid phases and body forces
    ("allowed: rigid phase", SOLVE, rigid("rho 7800;"), None, {"has": "Load on block"}),
    ("allowed: rigid phase that moves", SOLVE,
     rigidMotion("type translation; velocity (0 -1 0);"), None, {"has": "Load on block"}),
    ("rigid phase without rho", SOLVE, rigid(""), inPhases + ["rho"]),
    ("rigid phase without rho", SET, rigid(""), inPhases + ["rho"]),
    ("rigid phase of rho -1", SOLVE, rigid("rho -1;"), inPhases + ["rho is -1"]),
    ("rigid phase with a law", SOLVE,
     rigid("rho 1; constitutiveModel { type linearElastic; }"),
     inPhases + ["constitutiveModel", VALID, "motion"]),
    ("motion of a phase with a law", SOLVE,
     replace(PHASES, r"\$base;", "$base; motion { type fixed; }"),
     inPhases + ["motion", VALID]),
    ("word for motion", SOLVE, rigid("rho 1; motion fixed;"), inPhases + ["motion"]),
    ("unknown motion", SOLVE, rigidMotion("type wobble;"),
     inPhases + ["wobble", VALID, "fixed", "rotation", "translation"]),
    ("keyword of motion", SOLVE, rigidMotion("type fixed; velocity (0 0 0);"),
     inPhases + ["velocity", VALID]),
    ("translation without velocity", SOLVE, rigidMotion("type translation;"),
     inPhases + ["velocity"]),
    ("number for velocity of translation", SOLVE,
     rigidMotion("type translation; velocity 1;"), inPhases),
    ("translation out of the plane", SOLVE,
     rigidMotion("type translation; velocity (0 0 1);"),
     [r"velocity \(0 0 1\)", "not computed"]),
    ("rotation without omega", SOLVE,
     rigidMotion("type rotation; origin (5 5 0); axis (0 0 1);"), inPhases + ["omega"]),
    ("rotation about an axis of the plane", SOLVE,
     rigidMotion("type rotation; origin (5 5 0); axis (1 0 1); omega 1;"),
     inPhases + [r"axis is \(1 0 1\)", "normal"]),
    ("rotation about no axis", SOLVE,
     rigidMotion("type rotation; origin (5 5 0); axis (0 0 0); omega 1;"),
     inPhases + [r"axis is \(0 0 0\)"]),
    ("allowed: free body", SOLVE, rigidMotion(
        "type free; velocity (0 -1 0); angularVelocity (0 0 1); mass 2; inertia 3;"
        " constraints (x);"), None, {"has": "motion free, mass 2 kg"}),
    ("keyword of a free body", SOLVE, rigidMotion("type free; force (0 1 0);"),
     inPhases + ["force", VALID]),
    ("free body of mass 0", SOLVE, rigidMotion("type free; mass 0;"),
     inPhases + ["mass is 0"]),
    ("free body of inertia -1", SOLVE, rigidMotion("type free; inertia -1;"),
     inPhases + ["inertia is -1"]),
    ("tensor for inertia in 2D", SOLVE, rigidMotion("type free; inertia (1 0 0 1 0 1);"),
     inPhases),
    ("unknown constraint", SOLVE, rigidMotion("type free; constraints (y spin);"),
     inPhases + ["spin", VALID, "rotationZ"]),
    ("velocity of a free body where it is held", SOLVE,
     rigidMotion("type free; velocity (1 0 0); constraints (x);"),
     inPhases + [r"velocity is \(1 0 0\)", "x must be 0", "constraints"]),
    ("free body turns out of the plane", SOLVE,
     rigidMotion("type free; angularVelocity (0 1 0);"),
     inPhases + [r"angularVelocity is \(0 1 0\)", "y must be 0", "not computed"]),
    ("rigid phase leaves the mesh", SOLVE,
     rigidMotion("type translation; velocity (0 50 0);"),
     [r"point \d+ of block leaves the mesh", r"from \(\S+ \S+ \S+\)", TIME]),
    ("velocity of a rigid phase's region", SET, rigid("rho 1;"),
     inRegion + ["velocity", "block is rigid", "motion"]),
    ("stress of a rigid phase's region", SET,
     several(rigid("rho 1;"), replace(REGIONS, r"velocity +\(0 -1 0\)",
                                      "stress (-1 0 0 -1 0 -1)")),
     inRegion + ["stress", "block is rigid"]),
    ("allowed: body force", SOLVE, bodyForce("type uniform; acceleration (0 1 0);"), None),
    ("body force along the empty direction", SOLVE,
     bodyForce("type uniform; acceleration (0 1 2);"), inPhases + ["does not compute"]),
    ("allowed: wave speed that makes the run one step", SOLVE, law(
        "type linearElastic; E 1e-3; nu 0.2;"), None, {"has": "longer than the whole run"}),
    ("allowed: endTime 0", SOLVE, replace(CONTROL, r"endTime +0\.2", "endTime 0"), None,
     {"warnings": 1, "has": "endTime 0 is not after the time of the start, 0: nothing to do"}),
    ("allowed: endTime of a run that was there", SOLVE,
     replace(CONTROL, r"endTime +0\.2", "endTime 0.1"), None,
     {"warnings": 1, "has": "endTime 0.1 is not after the time of the start, 0.1",
      "seed": "half"}),
    ("unknown body force", SOLVE, bodyForce("type wind;"),
     inPhases + ["wind", VALID, "uniform"]),
    ("unknown body force", SET, bodyForce("type wind;"),
     inPhases + ["wind", VALID, "uniform"]),
    ("body force without acceleration", SOLVE, bodyForce("type uniform;"),
     inPhases + ["acceleration"]),
    ("keyword of body force", SOLVE,
     bodyForce("type uniform; acceleration (0 0 0); from 3;"), inPhases + ["from", VALID]),
    ("number for acceleration", SOLVE, bodyForce("type uniform; acceleration 9.81;"),
     inPhases),
    ("allowed: pressure at the start", SOLVE,
     withPoints(replace(REGIONS, "velocity", "stress (-1e4 0 0 -1e4 0 -1e4); velocity")),
     None),
    ("stress that no strain of the law carries", SOLVE,
     withPoints(replace(REGIONS, "velocity", "stress (-1e9 0 0 -1e9 0 -1e9); velocity")),
     ["linearElastic cannot start with the stress", r"strains .* must be in \[-3, 3\]"]),
    ("stress that no strain of neoHookean carries", SOLVE,
     several(replace(PHASES, "linearElastic", "neoHookean"),
             withPoints(replace(REGIONS, "velocity",
                                "stress (-1e6 0 0 -1e6 0 -1e6); velocity"))),
     ["neoHookean cannot start with the stress", r"above \S+ Pa"]),

    #- grains in a gas and heat
    ("allowed: grains", SOLVE, withPoints(inGas(GRAINS)), None),
    ("allowed: grains with heat and granular pressure", SOLVE, withPoints(inGas(
        HEAT + "granularPressure { type JohnsonJackson; alphaMin 0.5; alphaMax 0.65; }",
        region="temperature 300; volumeFraction 0.5;")), None, {"has": "Heat of block"}),
    ("unknown volumeModel", SOLVE, inGas("volumeModel sand; " + NO_STRESS),
     inPhases + ["sand", VALID, "ownStress", "grains"]),
    ("noStress without grains", SOLVE, inGas(NO_STRESS),
     inPhases + ["noStress", "volumeModel grains"]),
    ("noStress without grains", SET, inGas(NO_STRESS),
     inPhases + ["noStress", "volumeModel grains"]),
    ("keyword of noStress", SOLVE,
     inGas("volumeModel grains; constitutiveModel { type noStress; rho 1; E 2; }"),
     inLaw + ["E", VALID]),
    ("failureModel of noStress", SOLVE,
     inGas(GRAINS + "failureModel { type maxPrincipalStress; strength 1; }"),
     inPhases + ["failureModel", "no stress"]),
    ("stress of noStress", SOLVE,
     withPoints(inGas(GRAINS, region="stress ambient; pressure 1e5;")),
     ["law noStress does not support points that start with a stress"]),
    ("granularPressure without grains", SOLVE,
     inGas("$base; granularPressure { type JohnsonJackson; }"),
     inPhases + ["granularPressure", "volumeModel grains"]),
    ("unknown granularPressure", SOLVE,
     withPoints(inGas(GRAINS + "granularPressure { type Lun; alphaMin 0.5; alphaMax 0.6; }")),
     inPhases + ["Lun", VALID, "JohnsonJackson"]),
    ("alphaMax below alphaMin", SOLVE, withPoints(inGas(
        GRAINS + "granularPressure { type JohnsonJackson; alphaMin 0.5; alphaMax 0.4; }")),
     inPhases + ["alphaMax is 0.4"]),
    ("keyword of granularPressure", SOLVE, withPoints(inGas(
        GRAINS + "granularPressure { type JohnsonJackson; alphaMin 0.5; alphaMax 0.6;"
        " p 5; }")), inPhases + ["p", VALID]),
    ("heatTransfer without Cv", SOLVE,
     inGas(GRAINS + "heatTransfer { type constant; value 1; }"), inPhases + ["Cv"]),
    ("Cv without heatTransfer", SOLVE, inGas(GRAINS + "Cv 800;"),
     inPhases + ["Cv", "heatTransfer"]),
    ("region without temperature", SET, inGas(HEAT), inRegion + ["temperature"]),
    ("temperature without heatTransfer", SET, inGas(GRAINS, region="temperature 300;"),
     inRegion + ["temperature", "heatTransfer"]),
    ("temperature -3", SET, inGas(HEAT, region="temperature -3;"),
     inRegion + ["temperature is -3"]),
    ("points without T", SOLVE, several(
        withPoints(inGas(HEAT, region="temperature 300;")), remove(BLOCK + "T")),
     ["block has heatTransfer", "column T", "setMaterialPoints"]),
    ("T of a point 0", SOLVE, several(
        withPoints(inGas(HEAT, region="temperature 300;")),
        setValue(BLOCK + "T", 3, "0")), [POINT, "T \\(temperature\\) is 0"]),
    ("unknown heatTransfer", SOLVE, withPoints(inGas(
        GRAINS + "Cv 800; heatTransfer { type warm; }", region="temperature 300;")),
     inPhases + ["warm", "constant", "Gunn", "RanzMarshall"]),
    ("keyword of heatTransfer", SOLVE, withPoints(inGas(
        GRAINS + "Cv 800; heatTransfer { type Gunn; d 1e-4; Nu 2; }",
        region="temperature 300;")), inPhases + ["Nu", VALID]),
    ("heatTransfer without Pr", SOLVE, withPoints(inGas(
        GRAINS + "Cv 800; heatTransfer { type Gunn; d 1e-4; }", air="mu 1.8e-5;",
        region="temperature 300;")), inPhases + ["Pr", "air"]),
    ("heatTransfer with an isentropic gas", SOLVE, several(
        withPoints(inGas(HEAT, region="temperature 300;")),
        replace(PHASES, "perfectGas; R 287;", "isentropic; p0 1e5; rho0 1.2;")),
     inPhases + ["isentropic"]),

    #- missing files
    ("velocityField misspelt", SOLVE, replace(PHASES, r"velocityField\s+body", "velocityField bdy"),
     [r"0/U\.bdy\S* cannot be read: there is no such file", r"Files of velocity there: U\.body\."]),
    ("no U of field", SOLVE, remove("0/U.body"),
     [r"0/U\.body\S* cannot be read: there is no such file", "velocityField body"],
     {"lacks": "cannot find file"}),
    ("no phaseProperties", SOLVE, remove(PHASES), ["has no file", "etc/caseTemplate/" + PHASES]),
    ("no phaseProperties", SET, remove(PHASES), ["has no file", "etc/caseTemplate/" + PHASES]),
    ("no setMaterialPointsDict", SET, remove(REGIONS),
     ["has no file", "etc/caseTemplate/" + REGIONS]),
    ("no materialPoints in fvSolution", SOLVE,
     replace(NUMERICS, r"materialPoints\s*\{.*?\}", ""),
     ["materialPoints", "system/fvSolution"]),
    ("no fvSolution", SOLVE, remove(NUMERICS), ["system/fvSolution"]),
    ("no mesh", SOLVE, remove("constant/polyMesh"), ["points.*polyMesh"]),
    ("no cloud", SOLVE, remove("0/lagrangian/block"),
     ["0/lagrangian/block", "setMaterialPoints"]),
    ("no clouds", SOLVE, remove("0/lagrangian"),
     ["0/lagrangian/base", "setMaterialPoints"]),
    ("no column m", SOLVE, remove(BLOCK + "m"), ["0/lagrangian/block"]),
    ("no column V", SOLVE, remove(BLOCK + "V"),
     ["cannot find file", "0/lagrangian/block/V"]),
    ("no column halfSize", SOLVE, remove(BLOCK + "halfSize"),
     ["cannot find file", "0/lagrangian/block/halfSize"]),
    ("no positions at all", SOLVE,
     several(remove(BLOCK + "x"), remove(BLOCK + "positions"),
             remove(BLOCK + "coordinates")),
     ["0/lagrangian/block|Cloud block"]),
    ("no surface file", SET,
     replace(REGIONS, r"box;\s+min.*?max.*?\);",
             'surface; surface { type triSurfaceMesh; file "none.stl"; }'),
     inRegion + ["there is no file constant/triSurface/none.stl"]),
    ("no library", SOLVE,
     replace(CONTROL, "application", 'libs ("libnone.so");\napplication'),
     None, {"allowed": "by OpenFOAM", "has": "libnone.so"}),

    #- numbers
    ("density -1000", SOLVE, replace(PHASES, "1000", "-1000"),
     inLaw + ["rho is -1000", "greater than 0"]),
    ("density -1000", SET, replace(PHASES, "1000", "-1000"),
     inLaw + ["rho is -1000", "greater than 0"]),
    ("density of region 0", SET, replace(REGIONS, "velocity", "density 0; velocity"),
     inRegion + ["density is 0"]),
    ("density nan", SOLVE, replace(PHASES, "1000", "nan"),
     inLaw + ["rho"]),
    ("E inf", SOLVE, replace(PHASES, "1e6", "inf"), inLaw + ["E"]),
    ("E 0", SOLVE, replace(PHASES, "1e6", "0"), inLaw + ["E is 0"]),
    ("nu 0.5", SOLVE, replace(PHASES, "0.2", "0.5"),
     inLaw + ["nu is 0.5", r"\[.*\]"]),
    ("strength -1", SOLVE, replace(PHASES, "1e5", "-1"),
     [line("phaseProperties"), "strength is -1"]),
    ("weibull modulus 0", SOLVE,
     replace(PHASES, "strength", "weibull { modulus 0; seed 1; } strength"),
     [line("phaseProperties"), "modulus is 0"]),
    ("volumeFraction 2", SET, replace(REGIONS, "velocity", "volumeFraction 2; velocity"),
     inRegion + ["volumeFraction is 2", r"\[.*\]"]),
    ("pointsPerCell 0", SET, replace(REGIONS, "pointsPerCell   2", "pointsPerCell 0"),
     inRegion + ["pointsPerCell", "1 to 16"]),
    ("massFilter 2", SOLVE, replace(NUMERICS, "PICfraction", "massFilter 2; PICfraction"),
     inNumerics + ["massFilter is 2", r"\[0, 1\]"]),
    ("PICfraction 2", SOLVE, replace(NUMERICS, "0.01", "2"),
     inNumerics + ["PICfraction is 2", r"\[0, 1\]"]),
    ("order 0", SOLVE, replace(NUMERICS, r"FLIP;.*?0\.01", "FMPM; order 0"),
     inNumerics + ["order is 0", r"\[1, \d+\]"]),
    ("order 1.5", SOLVE, replace(NUMERICS, r"FLIP;.*?0\.01", "FMPM; order 1.5"),
     inNumerics + ["order"]),
    ("maxTravel 5", SOLVE, replace(NUMERICS, "PICf", "maxTravel 5; PICf"),
     inNumerics + ["maxTravel is 5"]),
    ("maxCo missing", SOLVE, replace(CONTROL, "maxCo.*?;", ""),
     inControl + ["maxCo"]),
    ("maxCo 0", SOLVE, replace(CONTROL, r"maxCo\s+0.4", "maxCo 0"),
     inControl + ["maxCo is 0", r"\[.*\]"]),
    ("maxCo 2", SOLVE, replace(CONTROL, r"maxCo\s+0.4", "maxCo 2"),
     inControl + ["maxCo is 2", r"\[.*\]"]),
    ("maxDeltaT 0", SOLVE, replace(CONTROL, "maxCo", "maxDeltaT 0; maxCo"),
     inControl + ["maxDeltaT is 0"]),

    #- erosion
    ("allowed: erosion", SOLVE, eroding("type volumeRatio; max 5;"), None,
     {"has": "Eroded block: 0 points"}),
    ("allowed: erosion, any", SOLVE,
     eroding("type any; a { type lone; } b { type damage; time 9; }"), None,
     {"has": "Eroded block: 0 points"}),
    ("erosion unknown", SET, eroding("type vanish;"),
     inErosion + ["vanish", VALID, "plasticStrain"]),
    ("erosion without type", SOLVE, eroding("limit 1;"), inErosion + ["type"]),
    ("erosion without limit", SOLVE, eroding("type speed;"), inErosion + ["limit"]),
    ("erosion limit -1", SOLVE, eroding("type speed; limit -1;"),
     inErosion + ["limit is -1", "greater than 0"]),
    ("erosion, keyword", SOLVE, eroding("type lone; limit 1;"),
     inErosion + ["limit", VALID]),
    ("erosion time -1", SOLVE, eroding("type damage; time -1;"),
     inErosion + ["time is -1", r"\[0"]),
    ("erosion by a column that the law lacks", SOLVE,
     eroding("type plasticStrain; limit 1;"),
     inErosion + ["plasticStrain", "linearElastic has none"]),
    ("erosion by temperature without one", SOLVE, eroding("type temperature; limit 900;"),
     inErosion + ["column T", "linearElastic has none"]),
    ("erosion by damage without failureModel", SOLVE,
     several(eroding("type lone;"), replace(PHASES, r"failureModel\s*\{.*?\}", "")),
     inErosion + ["lone", "failureModel"]),
    ("erosion by no volumeRatio", SOLVE, eroding("type volumeRatio;"),
     inErosion + ["min", "max"]),
    ("erosion volumeRatio min 2", SOLVE, eroding("type volumeRatio; min 2;"),
     inErosion + ["min is 2", r"\[0, 1\]"]),
    ("erosion volumeRatio max 0.5", SOLVE, eroding("type volumeRatio; max 0.5;"),
     inErosion + ["max is 0.5", r"\[1"]),
    ("erosion by any of none", SOLVE, eroding("type any;"), inErosion + ["any"]),
    ("erosion, word in any", SOLVE, eroding("type any; lone yes;"),
     inErosion + ["lone"]),
    ("erosion, any of a bad one", SOLVE, eroding("type any; a { type speed; limit 0; }"),
     inErosion + ["limit is 0"]),
    ("erosion to no phase", SOLVE, eroding("type speed; limit 9; to dust;"),
     inErosion + ["dust", "The phases are"]),
    ("erosion to itself", SOLVE, eroding("type speed; limit 9; to block;"),
     inErosion + ["block"]),
    ("word for erosion", SOLVE,
     replace(PHASES, r"(velocityField\s+body;)", r"\1 erosion yes;"), inErosion),
    ("erosion of a rigid phase", SOLVE,
     replace(PHASES, r"block\s*\{.*?\}",
             "block { type rigid; rho 1000; velocityField body;"
             " erosion { type speed; limit 1; } }"),
     inErosion + [VALID, "motion"]),

    #- entries of the wrong type
    ("word for rho", SOLVE, replace(PHASES, "1000", "heavy"), inLaw + ["heavy|rho"]),
    ("word for PICfraction", SOLVE, replace(NUMERICS, "0.01", "some"),
     inNumerics + ["some"]),
    ("number for transfer", SOLVE, replace(NUMERICS, "FLIP", "3"),
     inNumerics + ["transfer|3"]),
    ("word for maxCo", SOLVE, replace(CONTROL, "0.4", "big"), inControl),
    ("number for velocity", SET, replace(REGIONS, r"\(0 -1 0\)", "-1"), inRegion),
    ("word for pointsPerCell", SET,
     replace(REGIONS, "pointsPerCell   2", "pointsPerCell many"), inRegion),
    ("fraction for pointsPerCell", SET,
     replace(REGIONS, "pointsPerCell   2", "pointsPerCell 2.5"), inRegion),
    ("word for a dictionary", SOLVE,
     replace(PHASES, r"failureModel\s*\{.*?\}", "failureModel strong;"),
     [line("phaseProperties"), "failureModel"]),
    ("word for a region", SET,
     replace(REGIONS, r"regions\s*\{", "regions\n{\n    rest all;"),
     inRegion + ["rest"]),
    ("brace missing", SOLVE, replace(PHASES, r"\}\s*block", "block"),
     ["phaseProperties"]),
    ("brace missing", SET, truncate(REGIONS, 0.9), ["setMaterialPointsDict"]),

    #- fields of points
    ("truncated x", SOLVE, truncate(BLOCK + "x"), ["0/lagrangian/block/x"]),
    ("truncated x, binary", SOLVE,
     several(withPoints(replace(CONTROL, r"writeFormat +ascii", "writeFormat binary")),
             truncate(BLOCK + "x")), ["0/lagrangian/block/x"]),
    ("empty file m", SOLVE, truncate(BLOCK + "m", 0), ["0/lagrangian/block/m"]),
    ("header of m wrong", SOLVE, replace(BLOCK + "m", "scalarField", "vectorField"),
     ["scalarField", "vectorField", "0/lagrangian/block/m"]),
    ("size of x too large", SOLVE,
     replace(BLOCK + "x", "\n48\n", "\n99999999999\n"), ["0/lagrangian/block/x"]),
    ("size of x 49", SOLVE, replace(BLOCK + "x", "\n48\n", "\n49\n"),
     ["0/lagrangian/block/x"]),
    ("size of x -1", SOLVE, replace(BLOCK + "x", "\n48\n", "\n-1\n"),
     ["0/lagrangian/block/x"]),
    ("word in V", SOLVE, setValue(BLOCK + "V", 5, "much"),
     [line("lagrangian/block/V")]),
]

for column in ("x", "U", "V", "sigma", "id", "halfSize", "damage", "leftStretch"):
    ROWS.append(
        (f"one value of {column} too few", SOLVE,
         lambda c, name=column: c.column(BLOCK + name, lambda v: v[:-1]),
         [f"lagrangian/block/{column}", "47", "48"]))
ROWS.append(("one value of m too few", SOLVE,
             lambda c: c.column(BLOCK + "m", lambda v: v[:-1]),
             ["lagrangian/block", "47", "48"]))

for column, n in (("x", 3), ("U", 3), ("m", 1), ("V", 1), ("sigma", 6),
                  ("halfSize", 3), ("damage", 1), ("leftStretch", 6)):
    ROWS.append((f"nan in {column}", SOLVE,
                 setValue(BLOCK + column, 7,
                          lambda v: re.sub(r"[^\s()]+", "nan", v, count=1)),
                 [line(f"lagrangian/block/{column}"), "nan"]))
    for traps in ("true", "false"):
        # Restart: no column is uniform
        ROWS.append(
            (f"nan in binary {column}, FOAM_SIGFPE {traps}", SOLVE,
             several(binary, setBinary(f"0.1/lagrangian/block/{column}", 7, n,
                                       float("nan"))),
             [POINT, TIME, "block"],
             {"environment": {"FOAM_SIGFPE": traps}, "seed": "half"}))

ROWS += [
    ("inf in U", SOLVE, setValue(BLOCK + "U", 7, "(inf 0 0)"),
     [line("lagrangian/block/U"), "inf"]),
    ("1e200 in U", SOLVE, setValue(BLOCK + "U", 7, "(1e200 0 0)"),
     ["point 7 of block", TIME]),
    ("m 0", SOLVE, setValue(BLOCK + "m", 7, "0"),
     [r"point 7 of block at \(\S+ \S+ \S+\)", TIME]),
    ("V -1", SOLVE, setValue(BLOCK + "V", 7, "-1"),
     [r"point 7 of block at \(\S+ \S+ \S+\)", TIME]),
    ("halfSize 0", SOLVE, setValue(BLOCK + "halfSize", 7, "(0 0 0)"),
     [r"point 7 of block at \(\S+ \S+ \S+\)", TIME, "halfSize"]),
    ("halfSize larger than cell", SOLVE, setValue(BLOCK + "halfSize", 7, "(2 2 0)"),
     [r"point 7 of block at \(\S+ \S+ \S+\)", TIME, "half-?[sS]ize"]),
    ("duplicate id", SOLVE, setValue(BLOCK + "id", 7, "8"),
     ["block", "id 8", TIME]),
    ("point outside the mesh", SOLVE, setValue(BLOCK + "x", 7, "(30 3.25 0.5)"),
     [r"point 7 of block at \(30 3.25 0.5\)", TIME, "outside"]),
    ("point just outside", SOLVE, setValue(BLOCK + "x", 7, "(3.25 -1e-9 0.5)"),
     [r"point 7 of block at \(3.25 -1e-09 0.5\)", TIME, "outside"]),
    ("point far outside", SOLVE, setValue(BLOCK + "x", 7, "(1e300 0 0.5)"),
     ["point 7 of block", TIME]),
    ("velocity 1e200 of region", SET, replace(REGIONS, r"\(0 -1 0\)", "(0 -1e200 0)"),
     None, {"allowed": "writes it"}),
    ("stress 1e200 of region", SET,
     replace(REGIONS, "velocity", "stress (1e200 0 0 0 0 0); velocity"),
     None, {"allowed": "writes it"}),

    #- regions and meshes
    ("region without points", SET,
     replace(REGIONS, r"type +box;\s+min +\(3 3 0\);\s+max +\(7 6 1\)",
             "type difference; shapes { a { type box; min (3 3 0); max (7 6 1); }"
             " b { type cells; } }"),
     inRegion + ["block has no points"]),
    ("region outside the mesh", SET,
     replace(REGIONS, r"min +\(3 3 0\);\s+max +\(7 6 1\)",
             "min (30 3 0); max (70 6 1)"),
     inRegion + ["block has no points", r"\(0 0 0\) \(10 10 1\)"]),
    ("regions overlap", SET, replace(REGIONS, r"min +\(3 3 0\)", "min (3 2 0)"),
     inRegion + ["base and block overlap", r"\(\S+ \S+ \S+\)"]),
    ("GIMP on skewed cells", SOLVE, withPoints(skewed),
     inNumerics + ["GIMP", "linear"]),
    ("allowed: linear on skewed cells", SOLVE,
     several(withPoints(skewed), replace(NUMERICS, "GIMP", "linear")), None),
    ("allowed: GIMP on graded boxes", SOLVE, withPoints(graded), None),
    ("quadraticBSpline on graded boxes", SOLVE,
     several(withPoints(graded), replace(NUMERICS, "GIMP", "quadraticBSpline")),
     inNumerics + ["quadraticBSpline", "direction [xy] is graded", "GIMP", "linear"]),
    ("cubicBSpline on a re-entrant corner", SOLVE,
     several(withPoints(meshOf(lShape)), replace(NUMERICS, "GIMP", "cubicBSpline")),
     inNumerics + ["cubicBSpline", "re-entrant"]),
    ("GIMP on a re-entrant corner", SOLVE, withPoints(meshOf(lShape)),
     inNumerics + ["GIMP", "linear", "re-entrant"]),
    ("allowed: linear at a re-entrant corner", SOLVE,
     several(withPoints(meshOf(lShape)), replace(NUMERICS, "GIMP", "linear")), None),
    ("allowed: mesh with prisms", SET, meshOf(prisms), None),
    ("mesh with prisms", SOLVE, meshOf(prisms), [r"Cell \d+ at \(", "hexahedr"]),
    ("allowed: mesh of a tetrahedron", SET, tetrahedron, None),
    ("allowed: mesh with wedges", SET, meshOf(wedge), None),
    ("allowed: mesh with wedges", SOLVE, withPoints(meshOf(wedge)), None),
    ("wedge off axis", SET, meshOf(lambda case: wedge(case, shift=2)),
     ["front back", "they meet at x = 2", "coordinate axis"]),
    ("wedge off axis", SOLVE, meshOf(lambda case: wedge(case, shift=2)),
     ["front back", "they meet at x = 2", "coordinate axis"]),
    ("wedge on the wrong side of its axis", SET, meshOf(lambda case: wedge(case, shift=-11)),
     ["front back", "coordinate axis", "not negative"]),
    ("wedge of unequal angles", SET, meshOf(lambda case: wedge(case, back=1.5)),
     ["front back", "their normals are", "the same angle"]),
    ("rotation on a wedge", SOLVE, several(meshOf(wedge), rigidMotion(
        "type rotation; origin (5 5 0); axis (0 0 1); omega 1;")),
     inPhases + ["wedge", "fixed", "translation"]),

    #- boundary conditions
    ("patch type inletOutlet", SOLVE, replace("0/U.body", "calculated", "inletOutlet"),
     [line(r"0/U\.body"), "inletOutlet", VALID, "fixedValue", "slip"]),
    ("patch type of another field", SOLVE, replace("0/U.body", "calculated", "noType"),
     [line(r"0/U\.body"), "noType", VALID, "fixedValue", "slip"]),
    ("patch missing in U", SOLVE, replace("0/U.body", r"ground\s*\{.*?\}", ""),
     [line(r"0/U\.body"), "ground"]),
    ("patch of U without value", SOLVE, replace("0/U.body", r"value.*?;", ""),
     [line(r"0/U\.body"), "value"]),
    ("patch type empty on a patch", SOLVE, replace("0/U.body", "calculated", "empty"),
     [line(r"0/U\.body"), "outside"]),
    ("class of U", SOLVE, replace("0/U.body", "pointVectorField", "volVectorField"),
     [r"0/U\.body", "volVectorField", "pointVectorField"]),
    ("internalField of U too short", SOLVE,
     replace("0/U.body", "uniform", "nonuniform List<vector> 2((0 0 0)(0 0 0)); //"),
     [line(r"0/U\.body")]),
    ("allowed: zeroGradient", SOLVE, replace("0/U.body", "calculated", "zeroGradient"), None),
    ("allowed: slip", SOLVE, replace("0/U.body", "calculated", "slip"), None),
    ("allowed: timeVaryingUniformFixedValue", SOLVE,
     movingGround("((0 (0 0 0)) (1 (0 1 0)))"), None),
    ("table of boundary values too short", SOLVE,
     movingGround("((0 (0 0 0)) (0.1 (0 0 0)))"), ["overflow|0.1"]),
    ("table of boundary values missing", SOLVE,
     several(movingGround("()"), remove("table")), [r'(cases/\d+/|IOstream ")table']),

    #- function objects
    ("forces: patch not in the mesh", SOLVE, function("PatchForces", "patches (ground roof);"),
     inControl + ["roof is not in the mesh", VALID + " .*ground"]),
    ("forces: patch without condition", SOLVE,
     function("PatchForces", "patches (outside);"),
     inControl + ["outside fixes no velocity", VALID + " .*ground"]),
    ("forces: patch listed twice", SOLVE,
     function("PatchForces", "patches (ground ground);"),
     inControl + ["ground is listed twice", VALID]),
    ("forces: no patches", SOLVE, function("PatchForces", "patches ();"),
     inControl + ["empty", VALID + " .*ground"]),
    ("forces: required keyword", SOLVE, function("PatchForces", ""),
     inControl + ["patches"]),
    ("forces: keyword", SOLVE, function("PatchForces", "patches (ground); rho 1;"),
     inControl + ["rho", VALID + "[^\\n]*|patches"]),
    ("forces: velocity field", SOLVE,
     function("PatchForces", "patches (ground); velocityFields (soil);"),
     inControl + ["soil", VALID + " .*body"]),
    ("forces: not in each step", SOLVE,
     function("PatchForces", "patches (ground); executeInterval 5;"),
     inControl + ["executeInterval", "each step"]),
    ("allowed: forces, -postProcess", SOLVE + ["-postProcess"],
     function("PatchForces", "patches (ground);"), None,
     {"has": "belong to time steps", "warnings": 1}),
    ("forces: origin", SOLVE, function("PatchForces", "patches (ground); origin (0 0);"),
     inControl),
    ("fields on mesh points: unknown field", SOLVE,
     function("Fields", "fields (alpha sigmaa);"), inControl + ["sigmaa", VALID, "sigmaEq"]),
    ("fields on mesh points: none", SOLVE, function("Fields", "fields ();"),
     inControl + ["empty", VALID, "alpha"]),
    ("fields on mesh points: required keyword", SOLVE, function("Fields", ""),
     inControl + ["fields"]),
    ("fields on mesh points: phase", SOLVE,
     function("Fields", "fields (U); phases (soil);"), inControl + ["soil", VALID, "block"]),
    ("probes: unknown id", SOLVE,
     function("Probes", "phase block; fields (U); points { ids (3 1000000); }"),
     inControl + ["Unknown id 1000000", "ids from 0 to"]),
    ("probes: no point in the box", SOLVE,
     function("Probes", "phase block; fields (U); points { box (20 20 20) (21 21 21); }"),
     inControl + ["no point of phase block", "Its points are in the box"]),
    ("x-t diagram: no point in the range", SOLVE,
     function("XT", "field p; direction y; range (100 200); nBins 3;"),
     inControl + ["no point is in the range", "They are in"]),
    ("allowed: forces and fields", SOLVE,
     function("PatchForces", "patches (ground); origin (1 2 0); velocityFields (body);"),
     None),

    #- runs that go wrong
    ("E 1e300: no end in sight", SOLVE, replace(PHASES, "1e6", "1e300"),
     [r"time step|deltaT"]),
    ("the time does not advance", SOLVE,
     replace(CONTROL, "maxCo", "maxDeltaT 1e-20; maxCo"),
     [r"time step|deltaT"], {"seed": "half"}),
    ("velocity 1e30", SOLVE,
     withPoints(replace(REGIONS, r"\(0 -1 0\)", "(0 -1e30 0)")),
     [r"The time step \S+ s at time \S+ would take", "velocities", "maxCo"]),
    ("velocity 1e200", SOLVE,
     withPoints(replace(REGIONS, r"\(0 -1 0\)", "(0 -1e200 0)")),
     [POINT, TIME]),
    ("velocity 1e200, fixed step", SOLVE,
     several(withPoints(replace(REGIONS, r"\(0 -1 0\)", "(0 -1e200 0)")),
             replace(CONTROL, "adjustTimeStep  yes", "adjustTimeStep no")),
     [POINT, TIME]),
    *((f"{name} without adjustTimeStep", SOLVE, withPoints(
        replace(CONTROL, r"adjustTimeStep  yes;\s*maxCo .*?;", f"{name} 0.3;")),
       [f"Entry {name} has no effect without adjustTimeStep", "Write +adjustTimeStep yes;"])
      for name in ("maxCo", "maxCoGas")),
    ("point leaves the mesh", SOLVE,
     withPoints(replace(REGIONS, r"\(0 -1 0\)", "(0 50 0)")),
     [r"point \d+ of block leaves the mesh", r"from \(\S+ \S+ \S+\)", TIME, "U.body",
      r"contact \{ floor \{ fields \(body\); patch",
      r"for inspection; a restart begins at 0\."]),
    ("point leaves the mesh after restart", SOLVE,
     lambda c: c.column("0.1/lagrangian/block/U", lambda v: ["(100 0 0)"]*len(v)),
     [r"point \d+ of block leaves the mesh", r"from \(\S+ \S+ \S+\)", TIME, "U.body"],
     {"seed": "half"}),
    ("point leaves in the first step", SOLVE,
     several(setValue(BLOCK + "x", 47, "(9.99 9.99 0.5)"),
             setValue(BLOCK + "U", 47, "(10 0 0)")),
     [r"point 47 of block leaves the mesh", r"from \(\S+ \S+ \S+\)", TIME]),
    ("point leaves in the first step after restart", SOLVE,
     several(setValue("0.1/lagrangian/block/x", 47, "(9.99 9.99 0.5)"),
             setValue("0.1/lagrangian/block/U", 47, "(10 0 0)")),
     [r"point \d+ of block leaves the mesh", r"from \(\S+ \S+ \S+\)", TIME],
     {"seed": "half"}),
    ("point leaves the mesh: deltaT is too large", SOLVE,
     several(withPoints(replace(REGIONS, r"\(0 -1 0\)", "(0 50 0)")),
             replace(NUMERICS, "transfer", "maxTravel 0.9; transfer"), fixedStep("0.017")),
     [r"leaves the mesh", "Courant number above 1 in this step",
      r"deltaT 0\.01\d of system/controlDict is \S+ times the stable one: use +deltaT 0\.00",
      "Otherwise make the mesh larger"]),
    ("no end in sight: deltaT is too large", SOLVE,
     several(withPoints(replace(REGIONS, r"\(0 -1 0\)", "(0 -15 0)")),
             replace(CONTROL, r"0\.2;", "9.9e7;"), fixedStep("0.05")),
     ["would take", "deltaT 0.05 of system/controlDict is", "Otherwise it follows"]),
    ("allowed: a warning at first and when the Courant number doubles", SOLVE,
     fixedStep("0.032"), None, {"warnings": 1, "has": "is above 1", "end": True}),
    ("allowed: words of controlDict that are nearly ours", SOLVE,
     replace(CONTROL, "maxCo", "maxDeltat 1; reportIntervall 5; minDeltT 0; maxCoGass 1;"
             " maxU 3; myLimit 7; maxAlphaCo 1; maxCo"), None,
     {"warnings": 4, "has": "Entry maxDeltat is not read; is maxDeltaT meant?"}),
    ("allowed: deltaT 0.05, fixed", SOLVE, fixedStep("0.05"), None,
     {"maybe": True, "has": "Courant number", "end": True}),
    ("allowed: deltaT 0.2, fixed", SOLVE, fixedStep("0.2"), None,
     {"maybe": True, "has": "Courant number", "end": True}),
    ("allowed: deltaT 1, fixed", SOLVE, fixedStep("1"), None,
     {"maybe": True, "end": True}),
    ("allowed: deltaT 1, adjusted", SOLVE, replace(CONTROL, "5e-4", "1"), None,
     {"end": True}),
    ("allowed: deltaT 0.1, fixed, steps redone", SOLVE,
     several(withPoints(replace(REGIONS, r"\(0 -1 0\)", "(0 -15 0)")),
             fixedStep("0.1")), None,
     {"has": "redone", "maybe": True, "end": True}),
    ("allowed: every step redone, output at its times", SOLVE,
     replace(NUMERICS, "PICf", "maxTravel 0.005; PICf"), None,
     {"has": "redone", "times": [0.05, 0.1, 0.15, 0.2]}),
    ("deltaT 0", SOLVE, fixedStep("0"), ["deltaT"]),
    ("deltaT -1", SOLVE, fixedStep("-1"), ["deltaT"]),
    ("parallel, not decomposed", ["mpirun", "--oversubscribe", "-np", "2",
                                  "materialPointFoam", "-parallel"],
     lambda c: None, ["processor|decomposeParDict"]),
    ("parallel", SET + ["-parallel"], lambda c: None, None,
     {"refused": r"Invalid option: -parallel"}),
    ("allowed: fields that meet", SOLVE, fields("base", "block"), None,
     {"warnings": 1, "has": "velocity fields"}),
    ("allowed: fields that overlap", SOLVE,
     withPoints(several(fields("base", "block"),
                        replace(REGIONS, r"min +\(3 3 0\)", "min (3 2 0)"))),
     None, {"warnings": 1, "has": "velocity fields"}),
    ("allowed: contact", SOLVE,
     contact("one { fields (base block); type Coulomb; mu 0.3; }"
             " two { fields (base); patch ground; type stick; }"), None,
     {"has": "Contact two between base and patch ground: force"}),
    ("allowed: contact of two fields with a patch", SOLVE,
     contact("one { fields (base block); type stick; }"
             " two { fields (block base); patch ground; type stick; }"), None,
     {"has": "Contact two between base and patch ground: force"}),
    ("contact of two fields with a patch, one of them twice", SOLVE,
     contact("one { fields (base block); patch ground; type frictionless; }"
             " two { fields (block); patch ground; type stick; }"),
     inContact + ["field block, patch ground: .*already"]),
    ("contact with a patch of no field", SOLVE,
     contact("one { fields (); patch ground; type stick; }"), inContact + ["it has none"]),
    ("contact of a field that does not exist", SOLVE,
     contact("one { fields (base brick); type frictionless; }"),
     inContact + ["brick", VALID, "base"]),
    ("contact with a patch of a field that does not exist", SOLVE,
     contact("one { fields (brick); patch ground; type frictionless; }"),
     inContact + ["brick", VALID, "base"]),
    ("contact of a field with itself", SOLVE,
     contact("one { fields (base base); type frictionless; }"), inContact + ["itself"]),
    ("contact of one pair twice", SOLVE,
     contact("one { fields (base block); type frictionless; }"
             " two { fields (block base); type stick; }"), inContact + ["already"]),
    ("contact of a field and a patch twice", SOLVE,
     contact("one { fields (base); patch ground; type frictionless; }"
             " two { fields (base); patch ground; type stick; }"),
     inContact + ["already", "ground"]),
    ("contact of all others twice", SOLVE,
     contact("one { type frictionless; } two { type stick; }"),
     inContact + ["all other pairs"]),
    ("allowed: contact of all others where there are none", SOLVE,
     contact("one { fields (base block); type stick; } all { type frictionless; }"), None,
     {"warnings": 1,
      "has": "there is none: it does nothing. A wall is a patch that is named:  floor {"
             " fields (base); patch floor; type frictionless; }"}),
    ("contact of three fields", SOLVE,
     contact("one { fields (base block base); type stick; }"), inContact + ["two velocity"]),
    ("contact with a patch that does not exist", SOLVE,
     contact("one { fields (base); patch floor; type frictionless; }"),
     inContact + ["Contact one: the mesh has no patch floor", "Patches: .*ground"]),
    ("contact with an empty patch", SOLVE,
     contact("one { fields (base); patch frontAndBack; type frictionless; }"),
     inContact + ["patch frontAndBack is of type empty", "Patches: .*ground"]),
    ("contact with a slip patch", SOLVE,
     contact("one { fields (base); patch ground; type frictionless; }", "slip; //"),
     inContact + ["ground", "calculated"]),
    ("contact with a patch that holds the points", SOLVE,
     contact("one { fields (base); patch ground; type frictionless; }", "fixedValue;"),
     inContact + ["ground", "calculated"]),
    ("contact: mu negative", SOLVE, contact("one { type Coulomb; mu -0.1; }"),
     inContact + ["mu"]),
    ("contact: mu missing", SOLVE, contact("one { type Coulomb; }"), inContact + ["mu"]),
    ("contact: mu of frictionless", SOLVE,
     contact("one { type frictionless; mu 0.3; }"), inContact + ["mu", "Coulomb"]),
    ("contact: unknown type", SOLVE, contact("one { type glue; }"),
     inContact + ["glue", VALID, "frictionless"]),
    ("contact: unknown keyword", SOLVE, contact("one { type stick; friction 1; }"),
     inContact + ["friction", VALID]),
    ("contact: no dictionary", SOLVE, contact("one frictionless;"),
     inContact + ["one", "dictionary"]),
    ("contact: normal zero", SOLVE,
     contact("one { fields (base block); type stick; normal (0 0 0); }"),
     inContact + ["normal"]),
    ("allowed: contact with a reversed normal", SOLVE,
     contact("one { fields (base block); type stick; normal (0 -1 0); }"), None,
     {"warnings": 1, "has": "centre of mass of base (5 1.5 0.5) to that of block (5 4.5 0.5):"
      " they may never touch. If it is reversed, write  normal (0 1 0);"}),
    ("allowed: contact with a normal", SOLVE,
     contact("one { fields (base block); type stick; normal (0 1 0); }"), None,
     {"warnings": 0}),
    ("allowed: contact with a normal across", SOLVE,
     contact("one { fields (base block); type stick; normal (1 0 0); }"), None,
     {"warnings": 0}),
    ("contact: normal of a patch", SOLVE,
     contact("one { fields (base); patch ground; type stick; normal (0 1 0); }"),
     inContact + ["normal"]),
    ("stepParts: unknown type", SOLVE,
     replace(PHASES, r"(phases\s)", "stepParts { one { type glue; } }\n\\1"),
     [line("phaseProperties"), "stepParts", "Unknown stepPart glue", VALID]),
    ("stepParts: no dictionary", SOLVE,
     replace(PHASES, r"(phases\s)", "stepParts { one glue; }\n\\1"),
     [line("phaseProperties"), "one", "dictionary"]),
    ("stepParts: the name of another part", SOLVE,
     replace(PHASES, r"(phases\s)", "stepParts { loads { type glue; } }\n\\1"),
     [line("phaseProperties"), "loads", "another name"]),
    ("allowed: user's law", SOLVE, nanLaw(1000000000), None, {"has": "nanLaw"}),
    ("unknown law beside the user's", SOLVE,
     several(nanLaw(5), replace(PHASES, "nanLaw", "nan9Law")),
     inLaw + ["nan9Law", VALID, "nanLaw"]),
]

ROWS += gasRows(SOLVE, replace, remove, several, withPoints, line)
ROWS += runRows(SOLVE, replace, remove, several, withPoints, meshOf, line)
ROWS += unitRows(SOLVE, replace, remove, several, withPoints, meshOf, line, air, gravity)

ROWS += fluidRows(SOLVE, line)

for traps in ("true", "false"):
    for name, n in (("first step", 50), ("middle", 1234), ("write time", 900)):
        ROWS.append(
            (f"user's law gives nan, {name}, FOAM_SIGFPE {traps}", SOLVE,
             nanLaw(n), [POINT, TIME, "stress"],
             {"environment": {"FOAM_SIGFPE": traps}, "seed": "half" if n == 50
              else "start", "points": True}))


# --- one row ------------------------------------------------------------------

def block(text):
    """The text of the fatal message, as one line."""
    at = text.find("--> FOAM FATAL")
    text = re.sub(r"^\[\d+\] ?", "", text[at:], flags=re.M)
    return " ".join(text.split())


def judge(command, case, patterns, options):
    """What is wrong, and the message in short."""
    before = case.contents()
    status, text, seconds = case.run(command, options.get("environment"))
    fatal = text.count("--> FOAM FATAL")
    message = block(text) if fatal else ""
    wrong = []

    if status is None:
        return [f"still runs after {LIMIT:g} s"], ""
    if status < 0 or status > 127:
        wrong.append(f"ended by signal {-status if status < 0 else status - 128}")
    crash = re.search(CRASH, text)
    if crash:
        wrong.append(f"crash: {crash.group()}")
    if glob.glob(case.file("core*")):
        wrong.append("core file")

    maybe = options.get("maybe") and fatal
    if "refused" in options:
        # OpenFOAM's own refusal of an option: a usage message
        if status != 1 or not re.search(options["refused"], text):
            wrong.append(f"exit {status} or no refusal")
    elif patterns is None and not maybe:
        if status or fatal:
            wrong.append(f"exit {status}, {fatal} fatal messages")
        if "End" not in text.split():
            wrong.append("no End")
    else:
        if status == 0:
            wrong.append("exit 0")
        if not 1 <= fatal <= options.get("ranks", 1):
            wrong.append(f"{fatal} fatal messages")
        missing = [p for p in patterns or [] if not re.search(p, message)]
        if missing:
            wrong.append("message without "
                         + ", ".join(p.replace("\n", "") for p in missing))
    times = sorted(float(f) for f in os.listdir(case.path)
                   if re.fullmatch(r"\d[\d.e-]*", f))
    if options.get("end") and not fatal and times[-1] < 0.19:
        wrong.append("ended without a step to the end time")
    missed = [t for t in options.get("times", []) if t not in times]
    if missed:
        wrong.append("no output at " + " ".join(map(str, missed)))
    if "has" in options and options["has"] not in text:
        wrong.append(f"output without {options['has']}")
    if "lacks" in options and re.search(options["lacks"], message):
        wrong.append(f"message with {options['lacks']}")
    if "warnings" in options:
        n = len(re.findall(r"--> FOAM Warning", text))
        if n != options["warnings"]:
            wrong.append(f"{n} warnings")

    after = case.contents()
    if command[0] == "materialPointFoam":
        changed = [f for f in before if after.get(f) != before[f]]
        if changed:
            wrong.append("changed " + " ".join(changed[:3])
                         + (f" and {len(changed) - 3} more"
                            if len(changed) > 3 else ""))
    elif patterns is not None and after != before:
        wrong.append("changed time folders")

    if options.get("points"):
        holds = [f for f in after if re.search(rb"\bnan\b", after[f])]
        if holds:
            wrong.append("nan written in " + " ".join(sorted(holds)[:3]))

    # Only the message itself, without where and file
    message = re.sub(r"^--> FOAM FATAL (IO )?ERROR:? *(\(openfoam-[^)]*\) *)?", "", message)
    message = re.sub(r" (file: |From |FOAM exiting).*", "", message)
    return wrong, message or f"exit {status} in {seconds:.1f} s"


def run(table, number, row, seeds):
    name, command, change, patterns = row[:4]
    options = row[4] if len(row) > 4 else {}
    case = Case(os.path.join(RUN, f"{number:03d}"),
                seeds[options.get("seed", "start")])
    try:
        change(case)
        wrong, message = judge(command, case, patterns, options)
    except (LookupError, RuntimeError, OSError, AttributeError,
            AssertionError) as e:
        wrong, message = [f"cannot prepare the row: {e}"], ""
    detail = f"{number:03d}: " + ("; ".join(wrong) + " | " if wrong else "")
    tool = [c for c in command if c in SET + SOLVE + ["setFluids"]][0]
    table.check(f"{name} ({tool})", not wrong, detail + message[:90])


def prepare():
    """Case with mesh and points; case that has run half way; user's law."""
    shutil.rmtree(RUN, ignore_errors=True)
    os.makedirs(RUN)
    start = Case(os.path.join(RUN, "start"), os.path.join(HERE, "case"))
    for command in (["blockMesh"], SET):
        status, text, _ = start.run(command)
        if status:
            sys.exit(f"{command[0]} failed:\n{text[-2000:]}")
    half = Case(os.path.join(RUN, "half"), start.path)
    half.sub(CONTROL, r"endTime +0\.2", "endTime         0.1")
    status, text, _ = half.run(SOLVE)
    half.sub(CONTROL, r"endTime +0\.1", "endTime         0.2")
    if status or "0.1/U.body" not in half.contents():
        sys.exit(f"materialPointFoam failed:\n{text[-2000:]}")

    law = Case(os.path.join(RUN, "nanLaw"), os.path.join(HERE, "nanLaw"))
    return {"start": start.path, "half": half.path}, law.run(["wmake"], limit=120)


def main():
    words = sys.argv[1:]
    table = Report("badInput")
    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1",
                      OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", FOAM_SIGFPE="true")
    os.environ.pop("FOAM_ABORT", None)
    seeds, (status, text, seconds) = prepare()
    table.check("a user's law in one file compiles without warning",
                status == 0 and "warning:" not in text,
                f"exit {status} in {seconds:.1f} s")
    for number, row in enumerate(ROWS, 1):
        if not words or any(w in row[0] for w in words):
            run(table, number, row, seeds)
    return table.finish()


if __name__ == "__main__":
    sys.exit(main())
