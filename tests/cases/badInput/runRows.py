"""Rows of badInput: what a user of a first case of their own runs into."""

import os


def gravity(value):
    return lambda case: case.write(
        "constant/g", "FoamFile { version 2.0; format ascii; class"
        " uniformDimensionedVectorField; object g; }\n"
        f"dimensions [0 1 -2 0 0 0 0]; value {value};\n")


def cut(name, text):
    """The file up to before a text."""
    def change(case):
        old = case.read(name)
        at = old.index(text)
        case.write(name, old[:at] + "}\n"*(old[:at].count("{") - old[:at].count("}")))
    return change


def runRows(solve, replace, remove, several, withPoints, meshOf, line):
    phases, control = "constant/phaseProperties", "system/controlDict"
    regions, blocks = "system/setMaterialPointsDict", "system/blockMeshDict"
    state = "0.1/uniform/materialPointState"
    inPhases = [line("phaseProperties")]

    def outflow(entries):
        return replace(phases, r"phases\s", "outflow { " + entries + " }\nphases ")

    def away(*changes):
        """The block flies out at the top."""
        return several(withPoints(replace(regions, r"\(0 -1 0\)", "(0 40 0)")), *changes)

    def manyPhases(case):
        names = " ".join(f"p{i}" for i in range(1000000))
        case.sub(phases, r"phases\s+\(base block\);", f"phases ({names});")

    def solid(rho, E):
        return several(replace(phases, r"rho +1000;", f"rho {rho};"),
                       replace(phases, r"E +1e6;", f"E {E};"),
                       replace(phases, r"strength +1e5;", f"strength {1e-3*float(E):g};"))

    def functions(entries):
        return replace(control, "maxCo", "functions { energy { " + entries + " } }\nmaxCo")

    def layer(kind):
        """Front and back of another type than empty: 3D."""
        return withPoints(several(
            meshOf(replace(blocks, r"type\s+empty;", f"type {kind};")),
            replace("0/U.body", r"type\s+empty;", "type calculated;")))

    def decomposedFirst(case):
        case.write("system/decomposeParDict", "FoamFile { version 2.0; format ascii;"
                   " class dictionary; object decomposeParDict; }\n"
                   "numberOfSubdomains 2; method simple;"
                   " simpleCoeffs { n (2 1 1); delta 1e-3; }\n")
        points = case.file("0/lagrangian")
        os.rename(points, case.file("aside"))
        case.run(["decomposePar"])
        os.rename(case.file("aside"), points)

    def sector(case):
        """The flat mesh between planes that meet at x = -1; patch, not wedge."""
        case.sub(blocks, r"vertices.*?;", "vertices ((0 0 -0.05) (10 0 -0.5) (10 10 -0.5)"
                 " (0 10 -0.05) (0 0 0.05) (10 0 0.5) (10 10 0.5) (0 10 0.05));")
        case.sub(blocks, r"type\s+empty;", "type patch;")

    dry = solve + ["-dry-run"]
    rows = [
        (f"allowed: one layer of cells between faces of type {kind}", dry, layer(kind), None,
         {"warnings": 1, "has": f"one layer of cells thick in z, and its faces there have"
          f" other types than empty, frontAndBack ({kind}): "}) for kind in ("patch", "wall")]
    rows.append(("allowed: a sector between faces of type patch", ["setMaterialPoints"],
                 meshOf(sector), None, {"has": "They make an angle with each other: for a"
                 " sector of a scene with an axis give them  type wedge;"}))
    rows += [
        (f"allowed: {name}", dry, withPoints(solid(rho, E)), None, {"warnings": 2, "has": said})
        for name, rho, E, said in (
            ("density in g/cm3", "7.8", "210e9", "7.8 g/cm3 are 7800 kg/m3"),
            ("E in kPa for Pa", "2700", "70e12", "rho is 2700 kg/m3, E 7e+13 Pa"),
            ("E in GPa", "7850", "200", "By E 200 Pa and rho 7850 kg/m3 a layer 0.00289 m high"),
            ("E in MPa", "7800", "210000", "a layer 3.05 m high is squeezed flat by its own weight"))]
    rows += [
        (f"allowed: {name}", dry, withPoints(solid(rho, E)), None, {"warnings": 0})
        for name, rho, E in (
            ("steel", "7800", "210e9"), ("beryllium", "1850", "303e9"),
            ("diamond", "3515", "1050e9"), ("foam", "20", "5e6"), ("jelly", "1000", "1e3"),
            ("brain", "1040", "500"))]
    rows += [
        ("allowed: endTime of 4e8 steps", solve,
         several(replace(control, r"endTime +0\.2", "endTime 5e6"),
                 replace(control, "maxCo", "minDeltaT 1; maxCo")), None,
         {"warnings": 1, "has": "Is endTime in s?"}),
        ("allowed: nothing to write", solve,
         replace(control, r"writeInterval +\S+;", "writeInterval 5;"), None,
         {"warnings": 1, "has": "beyond endTime 0.2 s: only its end will be written"}),
        ("allowed: number of steps at the start", solve, lambda case: None, None,
         {"warnings": 0, "has": "About 20 steps of 0.01 s to endTime 0.2 s"}),
        ("another name for nu", solve, replace(phases, r"nu  ", "poissonRatio "),
         inPhases + ["Unknown keyword poissonRatio", "is nu meant", "[Vv]alid"]),
        ("misspelt word in place of a required one", solve,
         replace(phases, r"phases ", "phase "),
         ["Entry phases is missing", r"is it meant by phase\?"]),
        ("misspelt choice", solve, replace("system/fvSolution", "GIMP", "Gimp"),
         ["Gimp", "[Vv]alid", "GIMP"]),
        ("letters that changed places", solve, replace("system/fvSolution", "GIMP", "GIPM"),
         ["shapeFunction GIPM; is GIMP meant", "[Vv]alid"]),
        ("beginning of a law's name", solve, replace(phases, "linearElastic", "J2"),
         inPhases + ["Unknown constitutiveModel J2; is J2Plasticity meant", "[Vv]alid"]),
        ("letters left out", ["setMaterialPoints"], replace(regions, "pointsPerCell", "ptsPerCell"),
         ["Unknown keyword ptsPerCell", "is pointsPerCell meant"]),
        ("pointsPerCell 2.5", ["setMaterialPoints"],
         replace(regions, r"pointsPerCell +2;", "pointsPerCell 2.5;"),
         [line("setMaterialPointsDict"), "pointsPerCell is 2.5", "whole number, 1 to 16"]),
        ("pointsPerCell (2 0.5 1)", ["setMaterialPoints"],
         replace(regions, r"pointsPerCell +2;", "pointsPerCell (2 0.5 1);"),
         ["pointsPerCell is 0.5 in direction y", "whole number"]),
        ("allowed: misspelt maxSubSteps", solve,
         replace(control, "maxCo", "maxSubStep 4; maxCo"), None,
         {"has": "Entry maxSubStep is not read; is maxSubSteps meant?"}),
        ("function object: misspelt type", solve,
         functions("type materialPointEnergi; libs (mpmFunctionObjects);"),
         [line("controlDict"), "Unknown type materialPointEnergi of function object energy",
          "is materialPointEnergy meant", "Valid types"]),
        ("function object: misspelt type, -postProcess", solve + ["-postProcess"],
         functions("type materialPointEnergi; libs (mpmFunctionObjects);"),
         [line("controlDict"), "Unknown type materialPointEnergi of function object energy"]),
        ("function object: unknown phase, -postProcess", solve + ["-postProcess"],
         functions("type materialPointBalance; libs (mpmFunctionObjects); phases (blok);"),
         [line("controlDict"), "blok", "[Vv]alid"]),
        ("function object: misspelt type of the gas", solve,
         functions("type blastProbe; libs (mpmFunctionObjects);"),
         [line("controlDict"), "Unknown type blastProbe of function object energy",
          "is blastProbes meant", "fluidBalance"]),
        ("function object: type of none of ours", solve,
         functions("type materialPointTemperature; libs (mpmFunctionObjects);"),
         ["Unknown type materialPointTemperature", "Valid types", "materialPointXT"]),
        ("function object: no libs", solve, functions("type materialPointEnergy;"),
         [line("controlDict"), "energy of type materialPointEnergy needs libs"]),
        ("function object: misspelt libs", solve,
         functions("type materialPointEnergy; libs (mpmFunctionObject);"),
         ["needs libs \\(mpmFunctionObjects\\)", "its libs are .*mpmFunctionObject"]),
        ("allowed: function object of a user's library", solve,
         functions("type materialPointEnergi; libs (userLibrary);"), None,
         {"has": "materialPointEnergi"}),
    ]
    return rows + [
        ("outflow: unknown patch", solve, outflow("patches (lid);"),
         inPhases + ["lid", "Valid choices", "outside"]),
        ("outflow: empty patch", solve, outflow("patches (frontAndBack);"),
         inPhases + ["frontAndBack", "Valid choices", "ground"]),
        ("outflow: no patches", solve, outflow(""), ["outflow", "patches is missing"]),
        ("outflow: unknown keyword", solve, outflow("patches (outside); phase block;"),
         inPhases + ["phase", "[Vv]alid keywords"]),
        ("allowed: outflow", solve, away(outflow('patches ("out.*");')), None,
         {"has": "Outflow block: 48 points"}),
        ("point leaves through another patch than that of outflow", solve,
         away(outflow("patches (ground);")), ["leaves the mesh", r"outflow \{ patches"]),
        ("erosion to a phase with the same erosion", solve,
         replace(phases, r"(base\s*\{)", r"\1 erosion { type speed; limit 9; to block; }"),
         inPhases + ["whose own go to block", "#remove erosion"]),
        ("allowed: erosion to a phase without it", solve,
         several(replace(phases, r"(base\s*\{)",
                         r"\1 erosion { type speed; limit 9; to block; }"),
                 replace(phases, r"\$base;", "$base; #remove erosion"),
                 replace(regions, r"phase +block;", "phase base;"),
                 withPoints(lambda case: case.remove("0/lagrangian"))), None,
         {"warnings": 0,
          "has": "velocity field body, failure maxPrincipalStress, erosion speed\n"}),
        ("allowed: rho changed after setMaterialPoints", solve,
         replace(phases, r"rho +1000;", "rho 1200;"), None,
         {"warnings": 2, "has": "have the density 1000 kg/m3 (mass over volume), but its rho is"
          " 1200 kg/m3: they were made with another rho."}),
        ("allowed: rho changed by less than 1 %", dry,
         replace(phases, r"rho +1000;", "rho 1009;"), None, {"warnings": 0}),
        ("allowed: density of a region of its own", dry,
         withPoints(replace(regions, r"(phase +\w+;)", r"\1 density 1500;")), None,
         {"warnings": 0}),
        ("allowed: rho changed before a restart", solve,
         replace(phases, r"rho +1000;", "rho 1200;"), None,
         {"warnings": 3, "seed": "half", "has": "the points keep their mass"}),
        ("allowed: no gravity", dry, lambda case: None, None,
         {"has": "No gravity: constant/g is missing"}),
        ("allowed: gravity", dry, gravity("(0 -9.81 0)"), None,
         {"warnings": 0, "has": "Gravity (0 -9.81 0) m/s2"}),
        ("points made after decomposePar",
         ["mpirun", "--oversubscribe", "-np", "2"] + solve + ["-parallel"],
         decomposedFirst, ["Phase base has no material points", "decomposePar -force"],
         {"ranks": 2}),
        ("erosion outside of nothing", solve,
         replace(phases, r"(velocityField\s+body;)",
                 r"\1 erosion { type outside; min (0 0 0); max (1 0 1); }"),
         inPhases + ["box", "min is", "max is"]),
        ("erosion by a time step of 0", solve,
         replace(phases, r"(velocityField\s+body;)",
                 r"\1 erosion { type timeStep; limit 0; }"),
         inPhases + ["limit", "greater than 0"]),
        ("gravity along the empty direction", solve, gravity("(0 0 -9.81)"),
         ["acts along z", "computed directions are: x y"]),
        ("mesh scaled after setMaterialPoints", solve,
         meshOf(replace(blocks, "vertices", "scale 2;\nvertices")),
         ["mesh is not that of the points", "before setMaterialPoints"]),
        ("mesh refined after setMaterialPoints", solve,
         meshOf(replace(blocks, r"\(10 10 1\) simple", "(20 20 1) simple")),
         ["mesh is not that of the points", "400 cells", "100 cells"]),
        ("hardening as a dictionary", solve,
         replace(phases, r"type\s+linearElastic;",
                 "type J2Plasticity; yield 1e4; hardening { type none; }"),
         inPhases + ["hardening", "must be a word: hardening none;", "linear"]),
        ("dictionary of no phase", solve,
         replace(phases, r"phases\s+\(base block\);", "phases (base);"),
         inPhases + ["block is not a phase", "not in the list phases"]),
        ("a million phases", solve, manyPhases, inPhases + ["1000000 phases", "at most"]),
        ("no ids", solve,
         several(remove("0/lagrangian/block/id"), remove("0/lagrangian/block/origId")),
         ["no file id", "0/lagrangian/block", "setMaterialPoints"]),
        ("state cut off between entries", solve, cut(state, "\ncomplete"),
         [line("materialPointState"), "cut off"], {"seed": "half"}),
        ("state cut off inside its points", solve, cut(state, "stepsRedone"),
         [line("materialPointState")], {"seed": "half"}),
        ("state of what the case no longer has", solve,
         replace(state, "stepsRedone", "contact { } stepsRedone"),
         [line("materialPointState"), "Entry contact", "the case no longer has",
          "remove the entry from this file"], {"seed": "half"}),
        ("minDeltaT negative", solve, replace(control, "maxCo", "minDeltaT -1; maxCo"),
         [line("controlDict"), "minDeltaT"]),
        ("reportInterval 0", solve, replace(control, "maxCo", "reportInterval 0; maxCo"),
         [line("controlDict"), "reportInterval"]),
        ("no end in sight: who sets the step", solve, replace(phases, "1e6", "1e300"),
         ["time step", r"set by points of b\w+: sound \S+ m/s in 1 m[.;]"]),
    ]
