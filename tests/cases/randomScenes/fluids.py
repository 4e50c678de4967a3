"""Random scenes of two to four fluids between walls, as a user would set them up.

    scene = draw(seed)          # a dictionary of what was drawn
    case = write(scene)         # its case folder, meshed and with fields
    print(describe(scene))

Fluids of all equations of state with an energy; boxes in 1D and 2D, wedges, tetrahedra;
regions of a fluid each, with pressures over six decades, densities over four, velocities
to 5 km/s; some with nuclei, first order, lowMach or two processors.
"""

import os
import random
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../lib"))
from cellMesh import boxOfCells
from foamCase import FoamCase, boxMesh, controlDict
from gasCases import UPWIND, VAN_LEER, schemes
from wedge import wedgeMesh

#: Entries of a phase; what its regions need: T, or densities from ... to [kg/m3]
FLUIDS = {
    "air": ({"thermo": "perfectGas", "R": 287, "gamma": 1.4}, None),
    "helium": ({"thermo": "perfectGas", "R": 2077, "gamma": 1.667}, None),
    "water": ({"rho": 1000, "equationOfState": {"type": "stiffenedGas", "gamma": 4.4,
                                                "pInf": 6e8, "p0": 1e5}}, ()),
    "liquid": ({"rho": 1150, "equationOfState": {
        "type": "nobleAbelStiffenedGas", "gamma": 1.19, "pInf": 7.028e8, "b": 6.61e-4,
        "q": -1177788, "p0": 1e5}}, (1000, 1200)),
    "tnt": ({"rho": 1630, "equationOfState": {
        "type": "JWL", "A": 371.2e9, "B": 3.231e9, "R1": 4.15, "R2": 0.95, "omega": 0.3,
        "E0": 7e9}}, (500, 1700)),
    "vapour": ({"rho": 50, "equationOfState": {
        "type": "vanDerWaals", "gamma": 1.4, "a": 5, "b": 1e-3, "p0": 1e5}}, (5, 300)),
    "metal": ({"rho": 2700, "equationOfState": {
        "type": "MieGrueneisen", "C0": 5330, "S": 1.34, "Gamma0": 2}}, ()),
    "copper": ({"rho": 8900, "equationOfState": {
        "type": "CochranChan", "A": 145.67e9, "B": 147.75e9, "E1": 2.99, "E2": 1.99,
        "Gamma0": 2, "p0": 1e5}}, ()),
}
GASES = ("air", "helium")

NX = {"line": 100, "box": 40, "wedge": 40, "tets": 12}


def draw(seed):
    r = random.Random(seed)
    sort = r.choice(("line", "line", "box", "box", "wedge", "tets"))
    names = r.sample(GASES, 1) + r.sample(sorted(set(FLUIDS) - set(GASES)) + ["helium"],
                                          r.choice((1, 1, 2, 3)))
    names = list(dict.fromkeys(names))
    if len(names) < 2:
        names.append("air" if names[0] == "helium" else "helium")
    ambient = r.choice((1e4, 1e5, 1e6))
    edges = [0.0] + sorted(r.uniform(0.1, 0.9) for _ in range(r.choice((1, 2, 3)))) + [1.0]
    regions = []
    for low, high in zip(edges, edges[1:]):
        name = r.choice(names)
        region = {"fluid": name, "x": (low, high),
                  "p": min(ambient*10**r.uniform(-1, r.choice((1, 4, 5))), 3e10),
                  "u": r.choice((0, 0, r.uniform(-100, 100), r.uniform(-1000, 1000),
                                 r.uniform(-5000, 5000)))}
        if name in GASES:
            region["T"] = r.uniform(250, 3000)
        elif FLUIDS[name][1] and r.random() < 0.7:
            region["rho"] = r.uniform(*FLUIDS[name][1])
            if name == "tnt":
                # Products, no colder than 2 MJ/kg
                region["p"] = max(region["p"], 6e5*region["rho"])
        y = sorted((r.uniform(-0.3, 0.8), r.uniform(0.2, 1.3)))
        region["y"] = (-1, 2) if sort == "line" or y[1] - y[0] < 0.2 else y
        regions.append(region)
    return {"seed": seed, "sort": sort, "fluids": names, "ambient": ambient,
            "regions": regions, "nuclei": r.choice((0, 0, 1e-6, 1e-4)),
            "upwind": r.random() < 0.15, "lowMach": r.random() < 0.15,
            "ranks": 2 if r.random() < 0.1 else 1}


def describe(scene):
    return (f"{scene['seed']} {scene['sort']}"
            + "".join(f" {k}" for k in ("upwind", "lowMach") if scene[k])
            + (f" nuclei {scene['nuclei']:g}" if scene["nuclei"] else "")
            + (" two processors" if scene["ranks"] > 1 else "") + ": "
            + " | ".join(f"{r['fluid']} {r['p']:.2g} Pa {r['u']:.0f} m/s"
                         + (f" {r['rho']:.0f} kg/m3" if "rho" in r else "")
                         + (f" {r['T']:.0f} K" if "T" in r else "")
                         for r in scene["regions"]))


def speed(region):
    """Velocity and speed of sound, nearly [m/s]."""
    gas = FLUIDS[region["fluid"]][0]
    c2 = (gas["gamma"]*gas["R"]*region["T"] if "R" in gas else
          (4*region["p"] + 5e9)/region.get("rho", gas["rho"]))
    return abs(region["u"]) + c2**0.5


def field(case, name, dimensions, value, conditions, kind="volScalarField"):
    case.write("0/" + name, {"dimensions": dimensions, "internalField": f"uniform {value}",
                             "boundaryField": {n: {"type": t} for n, t in conditions.items()}},
               kind)


def write(scene, steps):
    """The case; steps: of the scene's fastest wave through a cell."""
    case = FoamCase("randomScenes", f"fluids{scene['seed']}")
    sort, n = scene["sort"], NX[scene["sort"]]
    width = 1.0 if sort == "line" else 0.75
    ny = 1 if sort == "line" else int(0.75*n)
    case.write("system/fvSchemes", schemes(UPWIND if scene["upwind"] else VAN_LEER))
    case.write("system/fvSolution", {})
    case.write("system/controlDict", controlDict(1, 1, maxCo=0.4))
    if sort == "wedge":
        patches = {"ends": ("wall", "x-"), "far": ("wall", "x+"), "rim": ("wall", "r+")}
        case.write("system/blockMeshDict", wedgeMesh((0, 0), (1, width), (n, ny), patches))
        flat = {"front": "wedge", "back": "wedge", "axis": "empty"}
    else:
        patches = {"ends": ("wall", ("x-", "x+")), "rim": ("wall", ("y-", "y+")),
                   "flat": ("wall" if sort == "tets" else "empty", ("z-", "z+"))}
        if sort == "line":
            patches["flat"] = ("empty", ("y-", "y+", "z-", "z+"))
            del patches["rim"]
        high, cells = (1, width, width), (n, ny, ny if sort == "tets" else 1)
        flat = {} if sort == "tets" else {"flat": "empty"}
        if sort == "tets":
            boxOfCells(case, "tets", (0, 0, 0), high, cells, patches)
        else:
            case.write("system/blockMeshDict", boxMesh((0, 0, 0), high, cells, patches))
    if sort != "tets":
        case.run("blockMesh")
    walls = {name: None for name in patches if name not in flat}
    field(case, "p", "[1 -1 -2 0 0 0 0]", 1e5, {**dict.fromkeys(walls, "zeroGradient"), **flat})
    field(case, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", {**dict.fromkeys(walls, "slip"), **flat},
          "volVectorField")
    properties = {"phases": scene["fluids"]}
    for name in scene["fluids"]:
        properties[name] = {"type": "fluid", **FLUIDS[name][0]}
        if name in GASES and scene["nuclei"]:
            properties[name]["nuclei"] = scene["nuclei"]
    properties["fluids"] = {"lowMach": True} if scene["lowMach"] else {}
    case.write("constant/phaseProperties", properties)
    gas = next(f for f in scene["fluids"] if f in GASES)
    regions = {}
    for i, r in enumerate(scene["regions"]):
        regions[f"r{i}"] = {
            "type": "box", "min": (r["x"][0], width*r["y"][0], -1),
            "max": (r["x"][1], width*r["y"][1], 2), "fluid": r["fluid"], "p": r["p"],
            "U": (r["u"], 0, 0), **{k: r[k] for k in ("T", "rho") if k in r}}
    case.write("system/setFluidsDict", {
        "default": {"fluid": gas, "p": scene["ambient"], "T": 300}, "regions": regions})
    case.run("setFluids")
    end = steps*0.4/n/max(speed(r) for r in scene["regions"])
    control = controlDict(end, end, maxCo=0.4)
    control.update({"deltaT": 1e-3*end/steps, "maxCoGas": 0.6, "reportInterval": 100,
                    "functions": {"balance": {
                        "type": "fluidBalance", "libs": ["mpmFunctionObjects"],
                        "writeControl": "timeStep", "writeInterval": 20}}})
    case.write("system/controlDict", control)
    return case
