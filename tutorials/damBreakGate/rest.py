"""The pressure of water at rest behind the gate, p0 + rho g (top - y), written to 0/p; beside
and above it that of the air. setFluids' hydrostatic has that of water that is let go."""

import numpy as np

from mpm.case import Case
from mpm.files import foamText

P0, RHO, G, TOP = 1e4, 1000.0, 9.81, 0.14

case = Case()
x, y = (0.5*(e[1:] + e[:-1]) for e in case.edges()[:2])
x, y = np.tile(x, len(y)), np.repeat(y, len(x))
water = case.field("0", "alpha.water")*np.ones(len(x))
p = P0 + RHO*G*np.where(water > 0, np.maximum(TOP - y, 0), 0)
rows = "\n".join(foamText(float(v)) for v in p)
case.change("0/p", r"(?s)internalField.*?;(?=\n\nboundaryField)",
            f"internalField nonuniform List<scalar>\n{len(x)}\n(\n{rows}\n);")
