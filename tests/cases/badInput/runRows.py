"""Rows of badInput: what a user of a first case of their own runs into."""


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

    return [
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
        ("minDeltaT negative", solve, replace(control, "maxCo", "minDeltaT -1; maxCo"),
         [line("controlDict"), "minDeltaT"]),
        ("reportInterval 0", solve, replace(control, "maxCo", "reportInterval 0; maxCo"),
         [line("controlDict"), "reportInterval"]),
        ("no end in sight: who sets the step", solve, replace(phases, "1e6", "1e300"),
         ["time step", r"set by b\w+: sound \S+ m/s in 1 m[.;]"]),
    ]
