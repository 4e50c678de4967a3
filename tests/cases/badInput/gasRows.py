"""Rows of badInput with a gas around the points."""

import re

HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"


def putField(case, name, kind, dimensions, value, outside):
    case.write("0/" + name, HEAD.format(kind, name)
               + f"dimensions {dimensions};\ninternalField uniform {value};\n"
               f"boundaryField {{ outside {{ {outside} }} ground {{ {outside} }}"
               " frontAndBack { type empty; } }\n")


def air(case):
    """Air of 1 bar in the mesh of the small case."""
    case.sub("constant/phaseProperties", r"phases\s+\(base block\);",
             "phases (air base block);\nair { type gas; thermo perfectGas;"
             " R 287; gamma 1.4; }")
    case.sub("system/fvSchemes", r"default linear;",
             "default linear; reconstruct(rho) upwind; reconstruct(U) upwind;"
             " reconstruct(p) upwind;")
    putField(case, "p", "volScalarField", "[1 -1 -2 0 0 0 0]", "1e5",
             "type zeroGradient;")
    putField(case, "T.air", "volScalarField", "[0 0 0 1 0 0 0]", "300",
             "type zeroGradient;")
    putField(case, "U.air", "volVectorField", "[0 1 -1 0 0 0 0]", "(0 0 0)",
             "type slip;")
    for region in ("base", "block"):
        case.sub("system/setMaterialPointsDict", rf"phase +{region};",
                 f"phase {region}; stress ambient; pressure 1e5;")
    # Sound is faster than the solid's waves: as many steps
    case.sub("system/controlDict", r"5e-4", "1e-4")


def gasRows(solve, replace, remove, several, withPoints, line):
    """The rows, made with the helpers of test.py."""
    phases, numerics = "constant/phaseProperties", "system/fvSolution"
    control, schemes = "system/controlDict", "system/fvSchemes"
    inPhases, inNumerics = [line("phaseProperties")], [line("fvSolution")]
    valid = r"[Vv]alid \w[\w ]*:"
    cell = r"cell \d+ at \(\S+ \S+ \S+\), time \d"

    def inAir(*changes):
        return withPoints(several(air, *changes))

    def gas(entries):
        return replace(phases, r"R 287;", entries)

    def drag(entries):
        return replace(phases, r"(base\s*\{)", r"\1 drag { " + entries + " }")

    def value(name, new):
        return replace("0/" + name, r"internalField uniform [^;]*",
                       "internalField uniform " + new)

    def totalPressure(entries):
        return replace("0/p", r"outside \{ type zeroGradient;",
                       "outside { type totalPressure; p0 uniform 1e5; U U.air; phi phi.air;"
                       f" {entries} value uniform 1e5;")

    rows = [("allowed: points in air", solve, inAir(), None, {"has": "Theta: min"})]
    for name in ("p", "T.air", "U.air"):
        rows.append((f"gas without {name}", solve, inAir(remove("0/" + name)),
                     ["Field " + re.escape(name), "missing", "0/" + re.escape(name)]))
    for label, name, new in (
            ("negative pressure", "p", "-1e5"), ("pressure 0", "p", "0"),
            ("negative temperature", "T.air", "-300"),
            ("temperature 0", "T.air", "0"), ("p nan", "p", "nan"),
            ("T.air nan", "T.air", "nan"), ("U.air inf", "U.air", "(inf 0 0)"),
            ("U.air 1e200", "U.air", "(1e200 0 0)")):
        rows.append((f"gas: {label}", solve, inAir(value(name, new)),
                     [cell + "|file: \\S*0/" + re.escape(name), re.escape(name)]))
    rows += [
        ("gas: negative pressure in one cell", solve,
         inAir(replace("0/p", r"uniform 1e5", "nonuniform List<scalar> 100 ("
                       + "1e5 "*56 + "-2e4 " + "1e5 "*43 + ")")),
         ["cell 56 at \\(6.5 5.5 0.5\\), time 0", "pressure -20000", "0/p"]),
        ("gas: dimensions of p", solve,
         inAir(replace("0/p", r"\[1 -1 -2 0", "[0 2 -2 0")), ["0/p", "dimensions"]),
        ("gas: nan during the run", solve,
         inAir(replace("0/p", r"outside \{ type zeroGradient;",
                       "outside { type uniformFixedValue; uniformValue table ((0 1e5)"
                       " (0.01 1e5) (0.02 -1e7));")),
         [r"Gas air has density \S+ .*pressure", cell, "maxCoGas"]),
        ("gas: no reconstruct(U)", solve,
         inAir(replace(schemes, r"reconstruct\(U\) upwind;", "")),
         [r"reconstruct\(U\)", "fvSchemes"]),
        ("gas with stressUpdate USL", solve,
         inAir(replace(numerics, "transfer", "stressUpdate USL; transfer")),
         inNumerics + ["stressUpdate", "MUSL"]),
        ("allowed: gas with erosion", solve,
         inAir(replace(phases, r"(base\s*\{)", r"\1 erosion { type speed; limit 9; }")), None,
         {"has": "erosion speed"}),
        ("gas with outflow", solve,
         inAir(replace(phases, "phases", "outflow { patches (outside); }\nphases")),
         inPhases + ["outflow", "does not work in a gas"]),
        ("gas: point leaves the mesh", solve,
         inAir(replace("system/setMaterialPointsDict", r"\(0 -1 0\)", "(0 40 0)"),
               replace(control, r"1e-4", "5e-4")),
         ["leaves the mesh", "Make the mesh larger"], {"lacks": "outflow"}),
        ("gas: inletOutlet without names", solve,
         inAir(replace("0/T.air", r"outside \{ type zeroGradient;",
                       "outside { type inletOutlet; inletValue uniform 300;"
                       " value uniform 300;")),
         ["inletOutlet of patch outside of T.air", r"Add the entries: phi phi.air; "],
         {"lacks": "(psi|rho|U) (psi|rho|U).air;"}),
        ("gas: waveTransmissive without names", solve,
         inAir(replace("0/p", r"outside \{ type zeroGradient;",
                       "outside { type waveTransmissive; gamma 1.4; fieldInf 1e5;"
                       " lInf 1; value uniform 1e5;")),
         ["waveTransmissive of patch outside of p", "phi phi.air; psi psi.air;"]),
        ("gas: farField of p alone", solve,
         inAir(replace("0/p", r"outside \{ type zeroGradient;",
                       "outside { type farField; farValue uniform 1e5; value uniform 1e5;")),
         ["Patch outside has the condition farField in p but not in U.air", "both",
          r"outside \{ type farField; value uniform \(0 0 0\); \}", "0/U.air"]),
        ("gas: misspelt entry of farField", solve,
         inAir(replace("0/p", r"outside \{ type zeroGradient;",
                       "outside { type farField; farvalue uniform 1e5; value uniform 1e5;")),
         ["farvalue", "farValue"]),
        ("gas: farField of T", solve,
         inAir(replace("0/T.air", r"outside \{ type zeroGradient;",
                       "outside { type farField; farValue uniform 300; value uniform 300;")),
         ["T.air", "farField", "inletOutlet"]),
        ("gas: misspelt scheme", solve,
         inAir(replace(schemes, r"\(rho\) upwind", "(rho) vanLer")),
         [line("fvSchemes"), r"vanLer of reconstruct\(rho\); is vanLeer meant", valid, "MLP",
          "SuperBee"], {"lacks": "CoBlended|limitWith"}),
        ("gas: misspelt scheme of U", solve,
         inAir(replace(schemes, r"\(U\) upwind", "(U) vanLerV")),
         ["is vanLeerV meant", valid, "MinmodV"]),
        ("gas: totalPressure with psi of no gas", solve,
         inAir(totalPressure("psi psi; gamma 1.4;")),
         ["looks for the field psi, which is called psi.air", "psi psi.air; gamma",
          "psi none; rho rho.air;", "Fields of the gas: p phi.air U.air psi.air rho.air"]),
        ("gas: totalPressure without psi and rho", solve, inAir(totalPressure("")),
         ["looks for the field rho, which is called rho.air", "psi psi.air; gamma"]),
        ("allowed: totalPressure with psi", solve,
         inAir(totalPressure("psi psi.air; gamma 1.4;")), None, {"has": "Theta: min"}),
        ("allowed: totalPressure with rho", solve, inAir(totalPressure("psi none; rho rho.air;")),
         None, {"has": "Theta: min"}),
        ("allowed: temperature in degrees Celsius", solve + ["-dry-run"],
         inAir(value("T.air", "27")), None, {"has": "27 degrees Celsius are 300.15 K"}),
        ("gas: gravity along the empty direction", solve,
         inAir(lambda case: case.write(
             "constant/g", HEAD.format("uniformDimensionedVectorField", "g")
             + "dimensions [0 1 -2 0 0 0 0]; value (0 0 1);\n")),
         ["acts along z", "computed directions are: x y"]),
        ("gas: molWeight in kg/mol", solve,
         inAir(replace(phases, "R 287;", "molWeight 0.0289;")),
         inPhases + ["molWeight 0.0289", "kg/kmol"]),
        ("gas: unknown thermo", solve,
         inAir(replace(phases, "perfectGas", "perfctGas")), inPhases + [valid, "perfectGas"]),
        ("gas: no gamma", solve, inAir(replace(phases, "gamma 1.4;", "")),
         inPhases + ["gamma"]),
        ("gas: R negative", solve, inAir(gas("R -287;")), inPhases + ["R"]),
        ("gas: unknown keyword", solve, inAir(gas("R 287; poreFlor 0.1;")),
         inPhases + ["poreFlor", valid]),
        ("gas: equationOfState beside points", solve,
         inAir(replace(phases, r"thermo perfectGas; R 287; gamma 1.4;",
                       "rho 1.2; equationOfState { type Tait; K 1e5; n 1.4; p0 1e5; }")),
         inPhases + ["equationOfState", "beside", "thermo perfectGas or isentropic"]),
        ("gas: poreFloor 1", solve, inAir(gas("R 287; poreFloor 1;")),
         inPhases + ["poreFloor"]),
        ("gas: faceDrag 1, a number of older cases", solve, inAir(gas("R 287; faceDrag 1;")),
         inPhases + ["faceDrag 1", valid, "impedance"]),
        ("gas: faceDrag pressure", solve, inAir(gas("R 287; faceDrag pressure;")),
         inPhases + ["faceDrag pressure", valid, "impedance"]),
        ("gas: mu negative", solve, inAir(gas("R 287; mu -1;")), inPhases + ["mu"]),
        ("gas: two gases", solve,
         inAir(replace(phases, r"\(air base block\);", "(air base block steam);\nsteam"
                       " { type gas; thermo perfectGas; R 462; gamma 1.3; }")),
         ["2 phases of type gas", "phaseProperties"]),
        ("drag: unknown type", solve, inAir(drag("type stik;")),
         inPhases + ["stik", valid, "SchillerNaumann"]),
        ("drag: no type", solve, inAir(drag("value 1;")), inPhases + ["type"]),
        ("drag: Ergun without mu of the gas", solve, inAir(drag("type Ergun; d 1e-3;")),
         inPhases + ["mu", "air"]),
        ("drag: Ergun without d", solve, inAir(drag("type Ergun;")), inPhases + ["d"]),
        ("drag: permeability 0", solve,
         inAir(gas("R 287; mu 1e-5;"), drag("type Darcy; permeability 0;")),
         inPhases + ["permeability"]),
        ("drag: constant, negative", solve, inAir(drag("type constant; value -1;")),
         inPhases + ["value"]),
        ("drag: direction sideways", solve,
         inAir(drag("type stick; direction sideways;")), inPhases + ["direction", "normal"]),
        ("drag: word instead of a dictionary", solve,
         inAir(replace(phases, r"(base\s*\{)", r"\1 drag stick;")), inPhases + ["drag"]),
        ("gas: energyBudget of an isentropic gas", solve,
         inAir(replace(phases, r"thermo perfectGas; R 287; gamma 1.4;",
                       "thermo isentropic; p0 1e5; rho0 1.2; gamma 1.4;"),
               replace(numerics, "transfer", "energyBudget yes; transfer")),
         ["isentropic", "energyBudget"]),
        ("gas: materialPointBalance with executeControl", solve,
         inAir(replace(control, r"maxCo", "functions { b { type materialPointBalance;"
                       " libs (mpmFunctionObjects); executeControl timeStep;"
                       " executeInterval 2; } }\nmaxCo")),
         ["executeControl"]),
    ]
    # Soft bodies
    def soft(entries, E="1e6", strength="strength +1e5;", failure="strength 1e5;"):
        return several(replace(phases, r"(base\s*\{)", r"\1 " + entries),
                       replace(phases, r"E +1e6;", f"E {E};"),
                       replace(phases, strength, failure))

    bare = 2*[replace("system/setMaterialPointsDict", r"stress ambient; pressure 1e5;", "")]
    rows += [
        ("allowed: soft bodies in air", solve + ["-dry-run"],
         inAir(soft("referencePressure 1e5;", "1e3"), *bare), None, {"warnings": 0}),
        ("allowed: soft bodies with the pressure of the air", ["setMaterialPoints"],
         several(air, soft("", "1e5")), None,
         {"has": "starts 100000 Pa above the pressure at which phase block is unstressed"}),
        ("soft bodies cannot bear the air", solve,
         inAir(soft("", "1e5"), replace(phases, "type +linearElastic", "type neoHookean")),
         ["cannot start with the stress", r"referencePressure <of the gas>;"]),
        ("allowed: referencePressure in bar", ["setMaterialPoints"],
         several(air, soft("referencePressure 1;", "1e3"), *bare), None,
         {"has": "starts with the pressure 1 Pa"}),
        ("allowed: referencePressure without a gas", ["setMaterialPoints"],
         soft("referencePressure 1e5;"), None, {"warnings": 2, "has": "as in a vacuum"}),
        ("referencePressure and ambientPressure", ["setMaterialPoints"],
         several(air, soft("referencePressure 1e5;", failure="strength 1e5; ambientPressure 1e5;")),
         inPhases + ["leave ambientPressure out"]),
        ("referencePressure of grains", solve,
         several(air, soft("referencePressure 1e5; volumeModel grains;")),
         inPhases + ["stress of grains"]),
        ("referencePressure negative", solve, several(air, soft("referencePressure -1;")),
         inPhases + ["referencePressure is -1"]),
    ]
    # Two warnings are of failure without ambientPressure
    given = r"stress ambient; pressure 1e5;"
    rows += [
        (f"allowed: in a gas with the stress {stress}", ["setMaterialPoints"],
         several(air, *2*[replace("system/setMaterialPointsDict", given,
                                  f"stress ({stress} 0 0 {stress} 0 {stress});")]), None,
         {"warnings": warnings, "has": said})
        for stress, warnings, said in (
            ("1e5", 4, "starts with the pressure -100000 Pa (minus a third of the trace"),
            ("-1e6", 4, "starts with the pressure 1000000 Pa (minus a third of the trace"),
            ("-1.05e5", 2, "End"))]
    rows += [
        ("ambient stress without a pressure", ["setMaterialPoints"],
         several(air, replace("system/setMaterialPointsDict", "pressure 1e5;", "")),
         [line("setMaterialPointsDict"), "pressure"]),
    ]
    return rows
