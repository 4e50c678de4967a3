"""Random pairs of solids that may meet between walls, in nothing, a gas or water and air.

    scene = draw(seed)          # a dictionary of what was drawn
    case = write(scene)         # its case folder, meshed, with points and fields
    print(describe(scene))

All laws, failure models, transfers and contact laws; boxes in 2D and 3D, wedges, tetrahedra;
speeds from 1 m/s to 2 km/s, densities from 100 to 17 000 kg/m3; all sides are slip walls.
"""

import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from cellMesh import boxOfCells
from fluids import FLUIDS, field
from foamCase import FoamCase, boxMesh, controlDict, velocityFile
from gasCases import VAN_LEER, schemes
from wedge import wedgeMesh

def ofFile(name):
    """Entries of a dictionary that is a file of etc/materials."""
    return {"#include": f'"$MPM_PROJECT_DIR/etc/materials/{name}"'}


def law(r, fluid):
    """Name, entries (a file's name: of etc/materials) and largest speed of sound [m/s]."""
    kind = r.choice(("linearElastic", "Hencky", "neoHookean", "MooneyRivlin", "J2Plasticity",
                     "JohnsonCook", "JohnsonCook", "DruckerPrager", "MohrCoulomb")
                    + (("NewtonianFluid",) if fluid else ()))
    rho = r.choice((100, 500, 1000, 2500, 7800))
    E, nu = 10**r.uniform(6, 11), r.choice((0, 0.2, 0.3, 0.45))
    elastic = {"rho": rho, "E": E, "nu": nu}
    c = (E*(1 - nu)/(1 + nu)/(1 - 2*nu)/rho)**0.5
    if kind == "Hencky":
        return kind, {"type": "linearElastic", "stress": "Kirchhoff", **elastic}, c
    if kind in ("linearElastic", "neoHookean"):
        return kind, {"type": kind, **elastic}, c
    if kind == "MooneyRivlin":
        return kind, {"type": kind, "rho": rho, "c10": E/8, "c01": E/16, "K": 2*E}, (4*E/rho)**0.5
    if kind == "J2Plasticity":
        hardening = r.choice(({"hardening": "none"}, {"hardening": "linear", "H": 0.01*E}))
        return kind, {"type": kind, **elastic, "yield": E*10**r.uniform(-4, -2), **hardening}, c
    if kind == "JohnsonCook":
        name = r.choice(("aluminium6061T6", "copperOFHC", "ironArmco", "steel4340",
                         "tungstenAlloy"))
        return name, name, 6500
    if kind == "NewtonianFluid":
        return kind, {"type": kind, "rho": 1000, "mu": 1e-3, "K": 2.2e9}, 1500
    frictional = {"cohesion": E*10**r.uniform(-4, -2), "frictionAngle": r.choice((20, 30, 40)),
                  "dilationAngle": r.choice((0, 10))}
    if kind == "DruckerPrager":
        frictional["match"] = r.choice(("outer", "inner"))
    return kind, {"type": kind, **elastic, **frictional}, c


def failure(r, name, entries):
    """A failure model that the law may have, or None."""
    if name in ("aluminium6061T6", "copperOFHC", "ironArmco", "steel4340"):
        return r.choice((None, name + "Damage", name + "Damage"))
    if name not in ("linearElastic", "Hencky", "neoHookean"):
        return None
    strength = entries["E"]*10**r.uniform(-3, -1.5)
    return r.choice((
        None, None, {"type": "maxPrincipalStress", "strength": strength},
        {"type": "maxPrincipalStress", "strength": strength, "Gf": strength*1e-3},
        {"type": "maxPrincipalStrain", "strain": 10**r.uniform(-3, -1)},
        {"type": "TulerButcher", "strength": strength, "exponent": 2,
         "impulse": strength**2*1e-6},
        {"type": "GradyKipp", "k": 1e25, "m": 7, "crackSpeed": 1000}))


def draw(seed):
    r = random.Random(1000 + seed)
    around = r.choice(("nothing", "gas", "water"))
    sort = r.choice(("plane", "plane", "plane", "wedge", "box", "tets"))
    bodies = []
    for _ in range(2):
        name, entries, c = law(r, around == "nothing")
        bodies.append({"law": name, "entries": entries, "c": c,
                       "failure": failure(r, name, entries)})
    v = 10**r.uniform(0, 3.3)
    bodies[0]["U"] = (v, 0 if sort == "wedge" else r.uniform(-0.2, 0.2)*v, 0)
    bodies[1]["U"] = r.choice(((0, 0, 0), (-0.5*v, 0, 0)))
    return {"seed": seed, "around": around, "sort": sort, "bodies": bodies, "v": v,
            "shape": r.choice(("sphere", "box")),
            "gap": r.randint(0, 4), "transfer": r.choice(("FLIP", "FLIP", "FMPM", "XPIC", "APIC")),
            "PIC": r.choice((0, 0, 0.01)), "update": r.choice(("MUSL", "USAVG", "USL")) if around == "nothing" else "MUSL",
            "functions": r.choice(("GIMP", "GIMP", "linear", "quadraticBSpline", "nodeDual")),
            "contact": r.choice(({"type": "frictionless"}, {"type": "Coulomb", "mu": 0.3},
                                 {"type": "stick"})),
            "nuclei": r.choice((0, 1e-4)), "ranks": 2 if r.random() < 0.1 else 1}


def describe(scene):
    a, b = scene["bodies"]

    def body(x):
        f = x["failure"]
        return x["law"] + (f" with {f['type'] if isinstance(f, dict) else 'Damage'}" if f else "")

    return (f"{scene['seed']} {scene['sort']} in {scene['around']}, "
            f"{functions(scene)} {scene['transfer']} {scene['update']} "
            f"{scene['contact']['type']}"
            + (" two processors" if scene["ranks"] > 1 else "")
            + f": {body(a)} on {body(b)}, {scene['v']:.0f} m/s")


def functions(scene):
    """Shape functions that the mesh permits."""
    return "nodeDual" if scene["sort"] == "tets" else scene["functions"]


#: Lengths [mm] and cells of the box; the wedge has its axis at y = 0
SIZE = (40.0, 30.0, 30.0)
CELLS = {"plane": (40, 30, 1), "wedge": (40, 30, 1), "box": (20, 15, 15), "tets": (10, 8, 8)}


def mesh(case, sort):
    """Meshes the case; returns its patches: kind of condition of a vector."""
    length = [1e-3*x for x in SIZE]
    if sort == "wedge":
        case.write("system/blockMeshDict", wedgeMesh(
            (0, 0), length[:2], CELLS[sort][:2],
            {"walls": ("wall", "x-"), "end": ("wall", "x+"), "rim": ("wall", "r+")}))
        flat = {"front": "wedge", "back": "wedge", "axis": "empty"}
        walls = ("walls", "end", "rim")
    else:
        flat = {"flat": "empty"} if sort == "plane" else {}
        sides = ("x-", "x+", "y-", "y+") + (() if flat else ("z-", "z+"))
        patches = {f"w{i}": ("wall", (s,)) for i, s in enumerate(sides)}
        walls = tuple(patches)
        if flat:
            length[2] = 1e-3
            patches["flat"] = ("empty", ("z-", "z+"))
        if sort == "tets":
            boxOfCells(case, "tets", (0, 0, 0), length, CELLS[sort], patches)
        else:
            case.write("system/blockMeshDict",
                       boxMesh((0, 0, 0), length, CELLS[sort], patches))
    if sort != "tets":
        case.run("blockMesh")
    return walls, flat


def write(scene, steps, name=None, test="randomScenes"):
    """The case; steps: of the scene's fastest wave through a cell."""
    sort, fluids = scene["sort"], scene["around"]
    case = FoamCase(test, name or f"solids{scene['seed']}")
    case.write("system/fvSchemes", schemes(VAN_LEER))
    numerics = {"shapeFunction": functions(scene), "transfer": scene["transfer"],
                "stressUpdate": scene["update"], "energyBudget": True}
    if scene["transfer"] == "FLIP" and scene["PIC"]:
        numerics["PICfraction"] = scene["PIC"]
    case.write("system/fvSolution", {"materialPoints": numerics})
    case.write("system/controlDict", controlDict(1, 1, maxCo=0.4))
    walls, flat = mesh(case, sort)
    properties = {"phases": ["a", "b"], "contact": {"a_b": scene["contact"]}}
    for name, body in zip("ab", scene["bodies"]):
        phase = {"velocityField": name, "constitutiveModel": (
            body["entries"] if isinstance(body["entries"], dict) else ofFile(body["entries"]))}
        if body["failure"]:
            phase["failureModel"] = (body["failure"] if isinstance(body["failure"], dict)
                                     else ofFile(body["failure"]))
        properties[name] = phase
        velocityFile(case, name, {**dict.fromkeys(walls, "slip"), **flat})
    if fluids == "gas":
        properties["phases"].append("air")
        properties["air"] = {"type": "gas", **FLUIDS["air"][0]}
    elif fluids == "water":
        properties["phases"] += ["water", "air"]
        for name in ("water", "air"):
            properties[name] = {"type": "fluid", **FLUIDS[name][0]}
        if scene["nuclei"]:
            properties["air"]["nuclei"] = scene["nuclei"]
        properties["fluids"] = {}
    case.write("constant/phaseProperties", properties)
    if fluids != "nothing":
        scalar = {**dict.fromkeys(walls, "zeroGradient"), **flat}
        vector = {**dict.fromkeys(walls, "slip"), **flat}
        field(case, "p", "[1 -1 -2 0 0 0 0]", 1e5, scalar)
        field(case, "U" if fluids == "water" else "U.air", "[0 1 -1 0 0 0 0]", "(0 0 0)", vector,
              "volVectorField")
    if fluids == "gas":
        field(case, "T.air", "[0 0 0 1 0 0 0]", 300, scalar)
    if fluids == "water":
        case.write("system/setFluidsDict", {
            "default": {"fluid": "air", "p": 1e5, "T": 300},
            "regions": {"w": {"type": "box", "min": (0.02, -1, -1), "max": (1, 1, 1),
                              "fluid": "water"}}})
        case.run("setFluids")
    ambient = {"stress": "ambient", "pressure": 1e5} if fluids != "nothing" else {}
    middle = 0 if sort == "wedge" else 0.015
    centre = (0.012, middle, 0.015 if sort in ("box", "tets") else 0)
    left = {"type": "sphere", "centre": centre, "radius": 0.005} if scene["shape"] == "sphere" \
        else {"type": "box", "min": tuple(x - 0.0047 for x in centre),
              "max": tuple(x + 0.0047 for x in centre)}
    x = 0.018 + 1e-4*scene["gap"]
    deep = (0.006, 0.024) if sort in ("box", "tets") else (-1, 1)
    right = {"type": "box", "min": (x, -1 if sort == "wedge" else 0.004, deep[0]),
             "max": (x + 0.006, 0.011 if sort == "wedge" else 0.026, deep[1])}
    case.write("system/setMaterialPointsDict", {"regions": {
        n: {"phase": n, **shape, "pointsPerCell": 2, "velocity": body["U"], **ambient}
        for n, shape, body in zip("ab", (left, right), scene["bodies"])}})
    case.run("setMaterialPoints")
    h = 1e-3*SIZE[0]/CELLS[sort][0]
    rate = max(*(b["c"] for b in scene["bodies"]), 1600 if fluids == "water" else 350) + scene["v"]
    end = max(steps*0.4*h/rate, min(0.01/scene["v"], 3*steps*0.4*h/rate))
    control = controlDict(end, end, maxCo=0.4)
    control.update({"maxCoGas": 0.6, "reportInterval": 100, "functions": {
        name: {"type": kind, "libs": ["mpmFunctionObjects"], "writeControl": "timeStep",
               "writeInterval": 10}
        for name, kind in (("energy", "materialPointEnergy"),
                           ("balance", "materialPointBalance"))}})
    case.write("system/controlDict", control)
    return case
