"""Rows of badInput with several fluids: numbers of another unit, what points displace."""

from gasRows import HEAD, putField

WATER = "rho 1000; equationOfState { type stiffenedGas; gamma 4.4; pInf 6e8; p0 1e5; }"
AIR = "thermo perfectGas; R 287; gamma 1.4;"
TNT = ("rho 1630; equationOfState { type JWL; A 371.2e9; B 3.231e9; R1 4.15; R2 0.95; omega 0.3;"
       " E0 7e9; } detonation { type programmedBurn; velocity 6930; points ((5 5 0.5)); time %s; }")


def fluids(liquid=WATER, air=AIR, p="1e5", T="300", far=None, points=False, kind="fluid", share="0.5"):
    """A liquid and air in the mesh of the small case, half and half in each cell."""
    def change(case):
        of = f"liquid {{ type fluid; {liquid} }}\nair {{ type {kind}; {air} }}\n"
        if points:
            case.sub("constant/phaseProperties", r"phases\s+\(base block\);",
                     "phases (liquid air base block);\n" + of)
        else:
            case.write("constant/phaseProperties", HEAD.format("dictionary", "phaseProperties")
                       + "phases (liquid air);\n" + of)
        case.sub("system/fvSchemes", r"default linear;",
                 "default linear; reconstruct(rho) upwind; reconstruct(U) upwind;"
                 " reconstruct(p) upwind;")
        ofP = f"type farField; farValue uniform {far};" if far else "type zeroGradient;"
        ofU = "type farField; farValue uniform (0 0 0);" if far else "type slip;"
        for name, kindOf, dimensions, value, outside in (
                ("p", "volScalarField", "[1 -1 -2 0 0 0 0]", p, ofP),
                ("T.air", "volScalarField", "[0 0 0 1 0 0 0]", T, "type zeroGradient;"),
                ("U", "volVectorField", "[0 1 -1 0 0 0 0]", "(0 0 0)", ofU),
                ("alpha.liquid", "volScalarField", "[0 0 0 0 0 0 0]", share,
                 "type zeroGradient;")):
            putField(case, name, kindOf, dimensions, value, outside)
        case.sub("system/controlDict", r"endTime +0\.2", "endTime 1e-3")
        case.sub("system/controlDict", r"writeInterval +\S+;", "writeInterval 1e-3;")
        case.sub("system/controlDict", r"deltaT +5e-4", "deltaT 1e-6")
    return change


def chargeOf(rho):
    """A charge of another density than its entry's."""
    def change(case):
        fluids(TNT % "0")(case)
        putField(case, "rho.liquid", "volScalarField", "[1 -3 0 0 0 0 0]", rho, "type zeroGradient;")
    return change


def withDict(*missing):
    """Points and fluids with a setFluidsDict; without these files of the start."""
    def change(case):
        fluids(points=True)(case)
        for name in missing:
            case.remove("0/" + name)
        case.write("system/setFluidsDict", HEAD.format("dictionary", "setFluidsDict")
                   + "default { fluid air; p 1e5; T 300; }\n")
    return change


def fluidRows(solve, line):
    """The rows, made with the helpers of test.py."""
    dry = solve + ["-dry-run"]

    def water(old, new):
        return WATER.replace(old, new)

    return [
        ("allowed: water and air", dry, fluids(), None,
         {"warnings": 0, "has": "starts with rho 1000 kg/m3, speed of sound 1624.9 m/s"}),
        ("allowed: water in g/cm3", dry, fluids(water("1000", "1")), None,
         {"warnings": 1, "has": "No matter is that light and fast: 1 g/cm3 are 1000 kg/m3"}),
        ("allowed: pInf of water in MPa", dry, fluids(water("6e8", "600")), None,
         {"warnings": 1, "has": "No liquid is that slow: pressures are in Pa"}),
        ("allowed: softened water", dry, fluids(water("pInf 6e8", "soundSpeed 30")), None,
         {"warnings": 0}),
        ("allowed: water of 1e6 kg/m3", dry, fluids(water("1000", "1e6")), None,
         {"warnings": 1, "has": "No matter is that dense"}),
        ("allowed: molWeight of air in g/kmol", dry,
         fluids(air=AIR.replace("R 287", "molWeight 28960")), None,
         {"warnings": 1, "has": "No gas is that dense"}),
        ("allowed: air among fluids in degrees Celsius", dry, fluids(T="20"), None,
         {"warnings": 1, "has": "20 degrees Celsius are 293.15 K"}),
        ("allowed: pressure of fluids in bar", dry, fluids(p="1"), None,
         {"warnings": 1, "has": "1 bar is 1e5 Pa"}),
        ("allowed: farField of fluids in bar", dry, fluids(far="1"), None,
         {"warnings": 1, "has": "has the farValue 1 Pa, but the cells there start with 100000 Pa"}),
        ("allowed: farField of fluids", dry, fluids(far="9e4"), None, {"warnings": 0}),
        ("allowed: charge lit after the end", dry, fluids(TNT % "10"), None,
         {"warnings": 1, "has": "The detonation is lit at 10 s (entries time"}),
        ("allowed: charge lit in the run", dry, fluids(TNT % "1e-4"), None, {"warnings": 0}),
        ("allowed: charge of another density", dry, chargeOf("1500"), None,
         {"warnings": 1, "has": "mass and shape), but its entry rho is 1630: "}),
        ("allowed: charge of its density", dry, chargeOf("1631"), None, {"warnings": 0}),
        ("allowed: products at 1 bar", dry, fluids((TNT % "0").split(" detonation")[0]), None,
         {"warnings": 1, "has": "Pa: it will not explode"}),
        ("allowed: points on a charge", dry, fluids(TNT % "0", points=True), None,
         {"has": "they displace 41.58 % of its mass"}),
        ("allowed: points in water", dry, fluids(points=True), None,
         {"has": "Points displace liquid "}),
        ("allowed: water in tension", solve, fluids(p="-2e5", share="1"), None,
         {"warnings": 1, "has": "nuclei 1e-6;"}),
        ("allowed: water in tension, with nuclei", solve,
         fluids(p="2e5", share="1", air=AIR + " nuclei 1e-6;"), None, {"warnings": 0}),
        ("misspelt nuclei", dry, fluids(air=AIR + " nuclie 1e-6;"),
         [line("phaseProperties"), "Unknown keyword nuclie in ", "[Vv]alid keywords are: .*nuclei"]),
        ("allowed: setMaterialPoints before setFluids", ["setMaterialPoints"],
         withDict("p", "T.air", "U", "alpha.liquid", "lagrangian"), None,
         {"has": "Run setFluids first, then setMaterialPoints"}),
        ("allowed: setFluids after setMaterialPoints", ["setFluids"], withDict(), None,
         {"warnings": 1, "has": "were made before these fluids"}),
        ("allowed: setFluids before setMaterialPoints", ["setFluids"], withDict("lagrangian"),
         None, {"warnings": 0}),
        ("water torn apart", solve, fluids(p="-7e8", share="1"),
         ["rho c.2 must be positive", "nuclei 1e-6", "in air of constant/phaseProperties"]),
        ("gas among fluids", solve, fluids(kind="gas"),
         [line("phaseProperties"), "Phase air is of type gas, but phase liquid of type fluid",
          "write +type fluid;"]),
    ]
