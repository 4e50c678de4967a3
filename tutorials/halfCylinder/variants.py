"""The case at other resolutions, with scatter of the strength, in air and in 3D, in
variants/: python3 variants.py [name ...], all without a name."""

import sys

from mpm.variants import changeFiles, runVariants


def cells(n, nz=1):
    """Cells over the radius; coarse meshes with a smaller Courant number, as the error of
    the time step is most of the residual of the energy"""
    return [("system/blockMeshDict", rf"^{name} .*?;", f"{name} {value};")
            for name, value in (("n", n), ("nx", 26*n//10), ("ny", 13*n//10), ("nz", nz))
            ] + [("system/controlDict", r"^maxCo .*?;", f"maxCo {0.2 if n >= 40 else 0.1};")]


def seed(i):
    return [("constant/phaseProperties", r"(Gf .*?;)",
             rf"\1 weibull {{ modulus 10; seed {i}; }}")]


#: Half-cylinder of 100 mm, free ends
SOLID = [("system/blockMeshDict", r"frontAndBack\s*\{\s*type\s+empty;",
          "frontAndBack { type patch;"),
         ("0/U.body", r"empty;", "calculated;")]

AIR = [("constant/phaseProperties", r"^phases .*?;", "phases (air body);\n\nair { type gas; "
        "thermo perfectGas; molWeight 28.9; gamma 1.4; }\n"),
       ("constant/phaseProperties", r"(Gf .*?;)", r"\1 ambientPressure 1e5;"),
       ("system/setMaterialPointsDict", r"(pointsPerCell .*?;)",
        r"\1 stress ambient; pressure 1e5;"),
       ("system/fvSolution", r"USAVG", "MUSL"),
       ("system/controlDict", r"^(maxCo .*?;)", r"\1\nmaxCoGas 0.4;"),
       ("system/fvSchemes", r"(?s)^(ddtSchemes|laplacianSchemes|snGradSchemes|"
        r"interpolationSchemes)\s.*?\}$", ""),
       ("system/fvSchemes", r"^gradSchemes", """ddtSchemes          { default Euler; }
laplacianSchemes    { default Gauss linear corrected; }
snGradSchemes       { default corrected; }
interpolationSchemes
{
    default             linear;
    reconstruct(rho)    upwind;
    reconstruct(U)      upwind;
    reconstruct(p)      upwind;
}
gradSchemes""")]

VARIANTS = {"coarse": cells(20), "fine": cells(80),
            "seed1": seed(1), "seed2": seed(2),
            "coarseAir": cells(20) + AIR, "coarse3D": cells(12, 28) + SOLID}

GAS = {"p": ("volScalarField", "[1 -1 -2 0 0 0 0]", "1e5", "zeroGradient"),
       "T.air": ("volScalarField", "[0 0 0 1 0 0 0]", "290", "zeroGradient"),
       "U.air": ("volVectorField", "[0 1 -1 0 0 0 0]", "(0 0 0)", "slip")}


def gasFields(case):
    """Air at rest; the floor is a wall, the other sides are open."""
    for name, (kind, dimensions, value, wall) in GAS.items():
        case.write("0/" + name, {
            "dimensions": dimensions, "internalField": f"uniform {value}",
            "boundaryField": {"floor": {"type": wall}, "outside": {"type": "zeroGradient"},
                              "frontAndBack": {"type": "empty"}}}, kind)


def change(case, *rows):
    changeFiles(case, *rows)
    if AIR[0] in rows:
        gasFields(case)


def main():
    unknown = set(sys.argv[1:]) - set(VARIANTS)
    if unknown:
        sys.exit(f"variants.py: no variant {' '.join(sorted(unknown))}; there are "
                 + " ".join(VARIANTS))
    runVariants({name: VARIANTS[name] for name in sys.argv[1:] or VARIANTS}, change)


if __name__ == "__main__":
    main()
