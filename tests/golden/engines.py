#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes engines.csv: the coefficients that each engine holds for one radiance of order 3.

Nothing here is the library's code. An engine is what its own source or specification publishes: the
polynomials that its coefficients multiply (or, in ambisonics, that encode a source), its axes, and
what the sum is. The radiance is a function of physical directions, sampled at points; coefficients
are what makes the engine's formula give the same values. 50 digits, printed with 20.
"""
from fractions import Fraction

from mpmath import legendre, lu_solve, matrix, mp, mpf, nstr, pi, quad, sqrt

mp.dps = 50

# The radiance in gaunt's convention: multiples of 1/64, so exact in float.
RADIANCE = [Fraction(k, 64) for k in (113, -37, 52, 19, -11, 23, -31, 45, -7)]

K0 = sqrt(1 / pi) / 2
K1 = sqrt(3 / pi) / 2
K2 = sqrt(15 / pi) / 2
K3 = sqrt(5 / pi) / 4
K4 = sqrt(15 / pi) / 4


def sloan(x, y, z):
    """Sloan 2008, appendix A2."""
    return [K0, -K1 * y, K1 * z, -K1 * x,
            K2 * x * y, -K2 * y * z, K3 * (3 * z * z - 1), -K2 * x * z, K4 * (x * x - y * y)]


def positive(x, y, z):
    """SphericalHarmonics3.getAt() of three.js."""
    return [K0, K1 * y, K1 * z, K1 * x,
            K2 * x * y, K2 * y * z, K3 * (3 * z * z - 1), K2 * x * z, K4 * (x * x - y * y)]


def unity(x, y, z):
    """SHA, SHB, SHC as SHProperties packs them and SampleSH9() dots them, one coefficient at a time."""
    functions = []
    for i in range(9):
        c = [mpf(k == i) for k in range(9)]
        a = [c[3], c[1], c[2], c[0] - c[6]]
        b = [c[4], c[5], 3 * c[6], c[7]]
        functions.append(a[0] * x + a[1] * y + a[2] * z + a[3] + b[0] * x * y + b[1] * y * z
                         + b[2] * z * z + b[3] * z * x + c[8] * (x * x - y * y))
    return functions


def filament(x, y, z):
    """Irradiance_SphericalHarmonics()."""
    return [mpf(1), y, z, x, y * x, y * z, 3 * z * z - 1, z * x, x * x - y * y]


def godot(x, y, z):
    """The lightmap captures in the scene's shader, with the exact values of its constants."""
    return [K0 * pi, K1 * pi * 2 / 3 * y, K1 * pi * 2 / 3 * z, K1 * pi * 2 / 3 * x,
            K2 * pi / 4 * x * y, K2 * pi / 4 * y * z, K3 * pi / 4 * (3 * z * z - 1),
            K2 * pi / 4 * x * z, K4 * pi / 4 * (x * x - y * y)]


def ambix(x, y, z):
    """Encoding gains, ACN and SN3D."""
    r = sqrt(mpf(3))
    return [mpf(1), y, z, x,
            r * x * y, r * y * z, (3 * z * z - 1) / 2, r * x * z, r / 2 * (x * x - y * y)]


def fuma(x, y, z):
    """Encoding gains W X Y Z R S T U V."""
    return [1 / sqrt(mpf(2)), x, y, z,
            (3 * z * z - 1) / 2, 2 * z * x, 2 * y * z, x * x - y * y, 2 * x * y]


def solid(function, points):
    """Directions whose values tell any polynomial of degree 2: a system to solve."""
    return matrix([function(*p) for p in points])


# Directions along forward, left, up: 9 in general position.
POINTS = []
for a, b, c in [(1, 2, 3), (-2, 1, 5), (3, -1, 1), (-1, -4, 2), (2, 5, -3), (4, -3, -2),
                (-5, 2, -1), (-2, -3, -4), (1, -1, 6)]:
    r = sqrt(mpf(a * a + b * b + c * c))
    POINTS.append((a / r, b / r, c / r))

# Axes from forward, left, up; what the sum is; the offset.
ENGINES = [
    ("gaunt", sloan, lambda f, l, u: (f, l, u), "L", 0),
    ("d3dx", sloan, lambda f, l, u: (f, l, u), "L", 0),
    ("unreal", sloan, lambda f, l, u: (f, -l, u), "L", 0),
    ("unity", unity, lambda f, l, u: (-l, u, f), "E/pi", 0),
    ("godot", godot, lambda f, l, u: (-l, u, -f), "E/pi", 0),
    ("threejs", positive, lambda f, l, u: (-l, u, -f), "L", 0),
    ("filament", filament, lambda f, l, u: (-l, u, -f), "E/pi", 0),
    ("gaussian_splats", sloan, lambda f, l, u: (-l, -u, f), "L", mpf(1) / 2),
]


def band(i):
    return 0 if i == 0 else 1 if i < 4 else 2


# Band l of E/pi by Funk and Hecke: 2 times the integral of t P_l(t) over 0 .. 1.
COSINE = [quad(lambda t, l=l: 2 * t * legendre(l, t), [0, 1]) for l in range(3)]


def value(quantity, point):
    return sum(mpf(c.numerator) / c.denominator * y * (COSINE[band(i)] if quantity == "E/pi" else 1)
               for i, (c, y) in enumerate(zip(RADIANCE, sloan(*point))))


def encoded(gains):
    """The integral over the sphere of radiance times gains: Gauss-Legendre in z, steps around it."""
    nodes = [-sqrt(mpf(3) / 5), mpf(0), sqrt(mpf(3) / 5)]
    weights = [mpf(5) / 9, mpf(8) / 9, mpf(5) / 9]
    total = [mpf(0)] * 9
    for z, weight in zip(nodes, weights):
        for k in range(6):
            s = sqrt(1 - z * z)
            point = (s * mp.cos(2 * pi * k / 6 + 1), s * mp.sin(2 * pi * k / 6 + 1), z)
            part = weight * 2 * pi / 6 * value("L", point)
            total = [t + part * g for t, g in zip(total, gains(*point))]
    return total


def main():
    print("engine,coefficient,value")
    rows = []
    for name, functions, axes, quantity, offset in ENGINES:
        own = [axes(*p) for p in POINTS]
        right = matrix([value(quantity, p) - offset for p in POINTS])
        rows.append((name, lu_solve(solid(functions, own), right)))
    rows.append(("ambix", encoded(ambix)))
    rows.append(("fuma", encoded(fuma)))
    for name, coefficients in rows:
        for i in range(9):
            print(f"{name},{i},{nstr(coefficients[i], 20, strip_zeros=False)}")


main()
