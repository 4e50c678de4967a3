"""Blast of a sphere of TNT in free air at sea level: Kingery and Bulmash's fits.

C. N. Kingery & G. Bulmash, Airblast parameters from TNT spherical air burst and
hemispherical surface burst, ARBRL-TR-02555 (1984). Polynomials of U = a + b log10 Z, in
kPa, ms and kPa ms per kg^(1/3), Z in m/kg^(1/3); coefficients as in public calculators
that name this report (three of them agree on those of the pressure).
"""

import numpy as np

PRESSURE = ((-0.214362789151, 1.35034249993), (
    2.611368669, -1.69012801396, 0.00804973591951, 0.336743114941, -0.00516226351334,
    -0.0809228619888, -0.00478507266747, 0.00793030472242, 0.0007684469735))
ARRIVAL = ((-0.253273111999, 1.37407043777), (
    0.0720707787637, 1.36456871214, -0.0570035692784, -0.182832224796, 0.0118851436014,
    0.0432648687627, -0.0007997367834, -0.00436073555033))
#: Below and above Z = 0.792
IMPULSE = (((2.34723921354, 3.24299066475), (
    2.38830516757, -0.443749377691, 0.168825414684, 0.0348138030308, -0.010435192824)),
           ((-1.75305660315, 2.30629231803), (
               1.55197227115, -0.40463292088, -0.0142721946082, 0.00912366316617,
               -0.0006750681404, -0.00800863718901, 0.00314819515931, 0.00152044783382,
               -0.0007470265899)))


def fit(of, Z):
    (a, b), c = of
    return 10**np.polynomial.polynomial.polyval(a + b*np.log10(Z), c)


def pressure(Z):
    """Largest overpressure [kPa]."""
    return fit(PRESSURE, Z)


def arrival(Z):
    """Of 1 kg [ms]."""
    return fit(ARRIVAL, Z)


def impulse(Z):
    """Of the positive phase, 1 kg [kPa ms]."""
    return np.where(np.asarray(Z) < 0.792, fit(IMPULSE[0], Z), fit(IMPULSE[1], Z))
