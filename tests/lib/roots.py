"""Roots of functions of one variable."""


def bisection(f, low, high):
    for _ in range(200):
        middle = 0.5*(low + high)
        low, high = (middle, high) if f(low)*f(middle) > 0 else (low, middle)
    return low
