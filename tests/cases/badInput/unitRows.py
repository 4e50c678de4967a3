"""Rows of badInput: wrong units, what needs a gas, and changes before a restart."""

import os

JWL = "type JWL; A 371.2e9; B 3.231e9; R1 4.15; R2 0.95; omega 0.30; E0 7e9;"


def tetrahedron(case):
    corners = ["3 3 0", "7 3 0", "5 6 0", "5 4 1"]
    faces = "".join("facet normal 0 0 0\nouter loop\n" + "".join(
        f"vertex {corners[i]}\n" for i in face) + "endloop\nendfacet\n"
        for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)))
    os.makedirs(case.file("constant/triSurface"))
    case.write("constant/triSurface/a.stl", f"solid a\n{faces}endsolid a\n")


def unitRows(solve, replace, remove, several, withPoints, meshOf, line, air, gravity):
    """The rows, made with the helpers of test.py, gasRows and runRows."""
    phases, regions = "constant/phaseProperties", "system/setMaterialPointsDict"
    inPhases, inRegion = [line("phaseProperties")], [line("setMaterialPointsDict")]
    places = ["setMaterialPoints"]
    dry = solve + ["-dry-run"]
    half = {"seed": "half"}

    def rho(value, entry=""):
        return replace(phases, r"rho +1000;", f"rho {value}; {entry}")

    def plastic(value):
        return replace(phases, "type +linearElastic;", "type J2Plasticity; hardening linear;"
                       f" H 0; yield {value};")

    def contact(mu):
        return replace(phases, r"phases\s", "contact { a { fields (body block); type Coulomb;"
                       f" mu {mu}; }} }}\nphases ")

    def ownFields(case):
        """The block with a velocity field of its own."""
        case.sub(phases, r"\$base;", "$base; velocityField block;")
        case.write("0/U.block", case.read("0/U.body").replace("U.body", "U.block"))

    def region(entries):
        return replace(regions, "velocity", entries + " velocity")

    def inAir(equation, entries):
        """The block as a fluid of this equation of state in air."""
        def change(case):
            air(case)
            case.sub(phases, r"\$base;", "velocityField body; constitutiveModel { type"
                     f" NewtonianFluid; rho 1630; mu 0; equationOfState {{ {equation} }} }}")
            case.sub(regions, r"phase +block; stress ambient; pressure 1e5;",
                     "phase block; " + entries)
        return change

    def isIn(words):
        return {"warnings": 1, "has": words}

    rows = [
        (f"allowed: {name}", dry, withPoints(several(
            rho(density), replace(phases, r"E +1e6;", f"E {E};"))), None, {"has": said})
        for name, density, E, said in (
            ("tonne, mm, s", "2.7e-9", "70e3", "2.7e-09 t/mm3 are 2700 kg/m3: materialPointFoam"),
            ("kg, mm, ms", "2.7e-6", "70", "2.7e-06 kg/mm3 are 2700 kg/m3"))]
    soft = "is squeezed flat by its own weight on earth. Moduli are in Pa: 1e6 for 1 MPa"
    rows += [
        (f"allowed: {name}", dry, withPoints(several(
            rho(density), replace(phases, r"E +1e6;", f"E {E};"))), None, said)
        for name, density, E, said in (
            ("rubber in MPa", "1000", "1", {"has": "a layer 0.000113 m high " + soft}),
            ("soft rubber", "1000", "1e5", {"warnings": 0}),
            ("heavy rubber", "4000", "1e6", {"warnings": 0}))]
    rows += [
        ("allowed: strength in MPa", dry, several(
            replace(phases, r"E +1e6;", "E 70e9;"), replace(phases, "strength +1e5;",
                                                             "strength 400;")), None,
         {"has": "Entry strength of phase block is 400 Pa, "}),
        ("allowed: ambientPressure in bar", dry,
         replace(phases, "strength +1e5;", "strength 1e5; ambientPressure 1;"), None,
         {"has": "Entry ambientPressure of phase block is 1: it is in Pa"}),
        ("allowed: C0 in km/s", dry, withPoints(replace(
            phases, r"\$base;", "velocityField body; constitutiveModel { type NewtonianFluid;"
            " rho 2700; mu 0; equationOfState { type MieGrueneisen; C0 5.33; S 1.34; Gamma0 2; } }"
        )), None, {"has": "Entry C0 of phase block is 5.33"}),
        ("allowed: yield in MPa", dry, several(
            replace(phases, r"E +1e6;", "E 70e9;"), plastic("200")), None,
         {"has": "Entry yield of phase block is 200 Pa"}),
        ("allowed: a yield of 1e-5 E", dry, plastic("10"), None, {"warnings": 0}),
        ("allowed: mu 20", dry, several(ownFields, contact(20)), None,
         isIn("The coefficient of friction mu is 20")),
        ("allowed: mu 1.2", dry, several(ownFields, contact(1.2)), None, {"warnings": 0}),
        ("allowed: gravity in mm/s2", dry, gravity("(0 -9810 0)"), None,
         isIn("1000 times that of the earth")),
        ("allowed: pressure of the gas in bar", dry, withPoints(several(
            air, replace("0/p", "1e5", "1"), replace(regions, "pressure 1e5", "pressure 1"))),
         None, isIn("The gas starts with a pressure of 1 Pa")),
        ("allowed: body in mm", places, replace(regions, r"\(10 3 1\)", "(10000 3 1)"),
         None, {"has": "It is 1000 times as large as the mesh: places and sizes are in m"}),
        ("scale beside surface", places, several(tetrahedron, replace(
            regions, r"box;\s*min +\(3 3 0\);\s*max +\(7 6 1\);",
            'surface; scale 1e-3; surface { type triSurfaceMesh; file "a.stl"; }')),
         inRegion + ["Unknown keyword scale", r"it belongs into +surface \{ file"]),
        ("misspelt law", solve, replace(phases, "linearElastic", "linearElastc"),
         inPhases + ["Unknown constitutiveModel linearElastc; is linearElastic meant",
                     "[Vv]alid"]),

        # Without a gas
        ("drag without a gas", solve, replace(
            phases, r"\$base;", "$base; drag { type constant; value 1; }"),
         inPhases + ["Entry drag of phase block acts between points and a gas",
                     "add a phase of +type gas"]),
        ("heatTransfer without a gas", solve, replace(
            phases, r"\$base;", "$base; Cv 800; heatTransfer { type constant; value 1; }"),
         inPhases + ["Entry heatTransfer of phase block acts between points and a gas"]),
        ("stress ambient without a gas", places, region("stress ambient; pressure 1e5;"),
         inRegion + ["Entry stress is ambient, the pressure of a gas",
                     r"stress \(-1e5 0 0 -1e5 0 -1e5\)"]),

        # An explosive
        ("allowed: explosive in air", places, inAir(JWL, ""), None, {"warnings": 1}),
        ("allowed: liquid without pressure in air", places,
         inAir("type Tait; p0 1e4; K 2e9; n 7;", ""), None, {"has": "Region block lies in the gas air and starts without stress"}),
        ("explosive with a referencePressure", places, several(
            inAir(JWL, ""), replace(phases, "velocityField body; constitutiveModel",
                                    "referencePressure 1e5; velocityField body;"
                                    " constitutiveModel")),
         inPhases + ["a pressure of its own where it is unstrained"]),
        ("explosive with the pressure of the air", solve, withPoints(
            inAir(JWL, "stress ambient; pressure 1e5;")),
         ["gives it the energy e -", r"E0/rho, is 4294478\.\d+ J/kg",
          "leave +stress +.*out of their region"]),
        ("allowed: explosive with another pressure", dry, withPoints(
            inAir(JWL, "stress (-8e9 0 0 -8e9 0 -8e9);")), None,
         {"has": "Points with an own energy need no stress"}),

        # Restarts
        ("allowed: rho at a restart", solve, rho(2700), None,
         {**half, "has": "rho of phase block has changed from 1000 to 2700"}),
        ("allowed: E at a restart", solve, replace(phases, "E +1e6;", "E 1.1e6;"), None,
         {**half, "has": "modulus of phase block has changed from"}),
        ("allowed: E at a restart, which entry", solve, replace(phases, "E +1e6;", "E 1.1e6;"),
         None, {**half, "has": "block.constitutiveModel.E: 1000000 before, 1100000 now"}),
        ("law at a restart", solve, replace(
            phases, r"type\s+linearElastic;", "type J2Plasticity; yield 1e4;"
            " hardening linear; H 0;"),
         ["Column elasticStrain of phase base is missing", "another law"],
         {**half, "has": "block.constitutiveModel.type: linearElastic before, J2Plasticity now"}),
        ("allowed: no failureModel at a restart", solve, replace(
            phases, r"failureModel\s*\{.*?\}", ""), None,
         {**half, "has": "failureModel maxPrincipalStress at time 0.1, but the phase has no"}),
        ("allowed: restart as it was", solve, lambda case: None, None,
         {**half, "warnings": 0}),
        ("another mesh at a restart", solve, meshOf(replace(
            "system/blockMeshDict", r"\(10 10 1\) simple", "(20 20 1) simple")),
         ["The mesh is not that of the points of base, time 0.1", "it has 400 cells"], half),
        ("allowed: rho 3 % off", solve, rho(1030), None,
         {"has": "have the density 1000 kg/m3"}),
        ("decomposed without points", ["mpirun", "--oversubscribe", "-np", "2", *solve, "-parallel"],
         several(remove("0/lagrangian"), decompose), ["and +decomposePar -force +after it"],
         {"ranks": 2}),
    ]
    return rows


def decompose(case):
    case.write("system/decomposeParDict", "FoamFile { version 2.0; format ascii;"
               " class dictionary; object decomposeParDict; }\n"
               "numberOfSubdomains 2; method simple;"
               " simpleCoeffs { n (2 1 1); delta 1e-3; }\n")
    status, text, _ = case.run(["decomposePar"])
    if status:
        raise RuntimeError("decomposePar failed: " + text[-500:])
