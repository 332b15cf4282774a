# Hertz's line contact, the scene of scripts/problems/hertz2d.lua: a quarter of a hollow cylinder, radii 0.1 and 1,
# E = 1, nu = 0.3, plane strain, pressed by half of the force F = 2e-3 onto a rigid plane. Graded meshes and errors of the
# pressure, used by getfem/hertz.py and calculix/hertz.py.
import numpy as np

A = 0.04814  # half-width of the contact, Hertz


def graded(h, fine, length, ratio):
    """Knots: equal steps h on [0, fine], then geometrically growing ones up to `length`."""
    n0 = int(round(fine / h))
    x = list(np.linspace(0, fine, n0 + 1))
    h, rest, n = fine / n0, length - fine, 1
    while h * sum(ratio**k for k in range(1, n + 1)) < rest:
        n += 1
    low, high = 1.0, ratio
    for _ in range(200):
        q = (low + high) / 2
        if h * sum(q**k for k in range(1, n + 1)) < rest:
            low = q
        else:
            high = q
    for k in range(1, n + 1):
        x.append(x[-1] + h * q**k)
    x[-1] = length
    return np.array(x)


def breaks(level):
    """Angles from the lowest point, and depths below the outer radius: elements a/(2^(level + 1)) at the contact."""
    h, ratio = A / 2 ** (level + 1), 1.4 if level < 3 else 1.3
    return graded(h, 1.5 * A, np.pi / 2, ratio), graded(h, A, 0.9, ratio)


def errors(x, p):
    """The relative L2 error of the pressure p(x) over x/a in [0, 1.2] and the relative error of the largest one."""
    a = np.sqrt(4 * 2e-3 * (1 - 0.3**2) / np.pi)
    p0, xi = 2 * 2e-3 / (np.pi * a), np.linspace(0, 1.2, 4000)
    ours, exact = np.interp(xi * a, x, p, right=0.0) / p0, np.sqrt(np.maximum(0, 1 - xi**2))
    return np.sqrt(np.sum((ours - exact) ** 2) / np.sum(exact**2)), ours.max() - 1
