"""Kirsch's plate (infinite, tension S along x, hole of radius a about the origin), and the
stress at the rim of a run."""

import numpy as np

A, S = 0.01, 100e6


def kirsch(x, y):
    """sigma_xx, sigma_xy, sigma_yy."""
    r2, theta = x*x + y*y, np.arctan2(y, x)
    q = A*A/r2
    c2, s2 = np.cos(2*theta), np.sin(2*theta)
    radial = S/2*(1 - q + (1 - 4*q + 3*q*q)*c2)
    hoop = S/2*(1 + q - (1 + 3*q*q)*c2)
    shear = -S/2*(1 + 2*q - 3*q*q)*s2
    c, s = np.cos(theta), np.sin(theta)
    return (radial*c*c + hoop*s*s - 2*shear*s*c, (radial - hoop)*s*c + shear*(c*c - s*s),
            radial*s*s + hoop*c*c + 2*shear*s*c)


def rim(x, y, sxx, sxy, syy):
    """sigma_xx/S at the rim at 90 degrees: the terms of Michell's solution without and with
    cos 2 theta, fitted to the hoop stress of the points within half a radius of the rim."""
    r, theta = np.hypot(x, y), np.arctan2(y, x)
    near = r < 1.5*A
    c, s = np.cos(theta[near]), np.sin(theta[near])
    hoop = sxx[near]*s*s - 2*sxy[near]*s*c + syy[near]*c*c
    q, c2 = (A/r[near])**2, np.cos(2*theta[near])
    basis = np.stack((np.ones_like(q), q, c2, c2*q**2), axis=1)
    k = np.linalg.lstsq(basis, hoop, rcond=None)[0]
    return (k[0] + k[1] - k[2] - k[3])/S


def stresses(case, phase="plate"):
    """x, y, sigma_xx, sigma_xy, sigma_yy and volumes of the points at the end."""
    cloud = case.points(case.times("lagrangian")[-1], phase)
    x, sigma = cloud["x"], cloud["sigma"]
    return x[:, 0], x[:, 1], sigma[:, 0], sigma[:, 1], sigma[:, 3], cloud["V"]


def errors(case):
    """sigma_xx/S at the rim, and rms errors of the three stresses over S up to 3 a."""
    x, y, *sigma, V = stresses(case)
    near = np.hypot(x, y) < 3*A
    difference = sum((a - b)**2 for a, b in zip(sigma, kirsch(x, y)))/3
    return rim(x, y, *sigma), np.sqrt(np.average(difference[near], weights=V[near]))/S
