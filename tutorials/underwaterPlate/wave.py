"""The water wave in front of a plate, written to 0: p = p0 + peak exp(-(face - x)/(c theta))
in the water before the face, with the velocity and density of a simple wave,

    rho = rho0 ((p + pInf)/(p0 + pInf))^(1/gamma),   u = 2 (c - c0)/(gamma - 1)

Arguments: peak [Pa], theta [s], face, end of the water [m]. The water has a share of 1e-6
of air: where it cavitates this air is what the pressure of vapour is for water.
"""

import sys

import numpy as np

from mpm.case import Case
from mpm.files import foamText

P0, PINF, GAMMA, RHO0, T0, NUCLEI = 1e5, 6e8, 4.4, 1000.0, 290.0, 1e-6
SOUND = np.sqrt(GAMMA*(P0 + PINF)/RHO0)


def centres(case):
    """Cell centres of a mesh of boxes along x, in the order of the cells."""
    edges = case.edges()
    x = 0.5*(edges[0][1:] + edges[0][:-1])
    return np.tile(x, (len(edges[1]) - 1)*(len(edges[2]) - 1))


def write(case, peak, theta, face, end):
    x = centres(case)
    p = np.where(x < face, P0 + peak*np.exp((np.minimum(x, face) - face)/(SOUND*theta)), P0)
    rho = RHO0*((p + PINF)/(P0 + PINF))**(1/GAMMA)
    u = 2/(GAMMA - 1)*(np.sqrt(GAMMA*(p + PINF)/rho) - SOUND)
    water = np.where(x < end, 1 - NUCLEI, 0.0)
    for name, values in (("p", p), ("U", np.column_stack([u, 0*u, 0*u])), ("rho.water", rho),
                         ("alpha.water", water), ("alpha.air", 1 - water),
                         ("T.air", T0*(p/P0)**(1 - 1/1.4))):
        kind = "vector" if values.ndim > 1 else "scalar"
        rows = "\n".join(foamText(v if values.ndim > 1 else float(v)) for v in values)
        case.change("0/" + name, r"(?s)internalField.*?;(?=\n\nboundaryField)",
                    f"internalField nonuniform List<{kind}>\n{len(x)}\n(\n{rows}\n);")


if __name__ == "__main__":
    write(Case(), *(float(a) for a in sys.argv[1:5]))
