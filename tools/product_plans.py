#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes src/product/plans.h: in which order sparse products multiply what by what.

Functions are blocks (l, m), m >= 0, of one coefficient or, with that of -m, two. Three blocks X, Y, Z
whose Gaunt coefficient does not vanish contribute X Y to Z, and so on around. A step takes a pair
(X, Y) and some Z: it adds X Y to each Z ("forward"), and the sum of all Z times Y to X, and times X
to Y ("back", after Snyder, MSR-TR-2006-53). Greedy, the cheapest step per contribution first, with
noise, again and again; the best of all tries is written.
"""
import itertools
import math
import random
import sys


def blocks(order):
    return [(l, m) for l in range(order) for m in range(l + 1)]


def index(block):
    return block[0] * (block[0] + 1) // 2 + block[1]


def gauss_legendre(n):
    nodes = []
    for i in range(n):
        x = math.cos(math.pi * (i + 0.75) / (n + 0.5))
        for _ in range(30):
            below, value = 1.0, x
            for k in range(2, n + 1):
                below, value = value, ((2 * k - 1) * x * value - (k - 1) * below) / k
            slope = n * (x * value - below) / (x * x - 1)
            x -= value / slope
        nodes.append((x, 2 / ((1 - x * x) * slope * slope)))
    return nodes


NODES = gauss_legendre(20)
POLAR = {}
GAUNT = {}


def polar(block):
    if block not in POLAR:
        l, m = block
        scale = math.sqrt((2 * l + 1) / (4 * math.pi) * (2 if m else 1) *
                          math.factorial(l - m) / math.factorial(l + m))
        values = []
        for z, _ in NODES:
            below, value = 0.0, 1.0
            for i in range(1, m + 1):
                value *= -(2 * i - 1) * math.sqrt(1 - z * z)
            for k in range(m + 1, l + 1):
                below, value = value, ((2 * k - 1) * z * value - (k + m - 1) * below) / (k - m)
            values.append(scale * value)
        POLAR[block] = values
    return POLAR[block]


def gaunt(x, y, z):
    key = tuple(sorted((x, y, z)))
    if key not in GAUNT:
        degrees = sorted(b[0] for b in key)
        orders = sorted(b[1] for b in key)
        value = 0.0
        if sum(degrees) % 2 == 0 and degrees[2] <= degrees[0] + degrees[1] and \
                orders[2] == orders[0] + orders[1]:
            azimuth = math.pi * (2 if orders[2] == 0 else 1 if orders[0] == 0 else 0.5)
            value = azimuth * sum(w * a * b * c for (_, w), a, b, c in
                                  zip(NODES, polar(x), polar(y), polar(z)))
        GAUNT[key] = 0.0 if abs(value) < 1e-12 else value
    return GAUNT[key]


def size(block):
    return 2 if block[1] else 1


class Product:
    """Contributions of a product; without band 0, which has steps of its own."""

    def __init__(self, a, b, out):
        self.symmetric = a == b
        self.a, self.b, self.out = (set(blocks(n)[1:]) for n in (a, b, out))
        every = blocks(max(a, b, out))[1:]
        self.left = set()
        self.pairs = {}  # of blocks: those that couple with both
        for x, y in itertools.product(every, every):
            if x > y and self.symmetric:
                continue
            couples = [z for z in every if gaunt(x, y, z)]
            if couples:
                self.pairs[x, y] = couples
            if x in self.a and y in self.b:
                self.left.update(((x, y), z) for z in couples if z in self.out)

    def key(self, x, y):
        return (min(x, y), max(x, y)) if self.symmetric else (x, y)

    def covers(self, x, y, z, forward, back_x, back_y):
        done = set()
        if self.symmetric:
            if forward and z in self.out:
                done.add((self.key(x, y), z))
            if back_x:
                done.add((self.key(y, z), x))
            if back_y:
                done.add((self.key(x, z), y))
        else:
            if forward:
                done.add(((x, y), z))
            if back_x:  # z is of the first factor
                done.add(((z, y), x))
            if back_y:
                done.add(((z, x), y))
        return done

    def cost(self, x, y, zs, forward, back_x, back_y, scaled):
        """Multiplications and additions of a step."""
        twice = 2 if self.symmetric else 1
        once = 1 if x == y or not self.symmetric else 2
        plus = [z for z in zs if x[1] and y[1] and z[1] == x[1] + y[1]]
        minus = [z for z in zs if z not in plus]
        mul = add = 0
        if forward:
            to = [z for z in zs if z in self.out]
            to_plus = [z for z in to if z in plus]
            to_minus = [z for z in to if z in minus]
            if x[1] and y[1]:
                imaginary = bool(to_plus) or any(z[1] for z in to_minus)
                square = x == y and self.symmetric
                mul += 4 if square else (4 if imaginary else 2) * (2 if self.symmetric else 1)
                if square and not to_plus:
                    mul -= 2
                if to_plus and to_minus:
                    add += 4 if any(z[1] for z in to_minus) else 2
            else:
                mul += once * size(x) * size(y)
            mul += sum(size(z) for z in to)
        if back_x or back_y:
            if not scaled:
                mul += twice * sum(size(z) for z in zs)
            if x[1] and y[1]:
                if plus and minus:
                    add += twice * (4 if any(z[1] for z in minus) else 2)
                each = twice * (4 if plus or any(z[1] for z in minus) else 2)
                mul += each * (back_x + (back_y and x != y))
            else:
                mul += twice * size(x) * size(y) * (back_x + (back_y and x != y))
        return mul, add

    def candidates(self, x, y, couples, left, split):
        zs = [z for z in couples if (self.key(x, y), z) in left] \
            if x in self.a and y in self.b else []
        if zs:
            yield zs, True, False, False
        if self.symmetric:
            back_x, back_y = x in self.out, y in self.out and x != y
            forward = x in self.a and y in self.a
            zs = [z for z in couples if z in self.a and not x == y == z and
                  self.covers(x, y, z, forward, back_x, back_y) <= left]
        else:  # a matrix of the first factor's real blocks, for one pair of blocks
            back_x, back_y = x in self.out and y in self.b, y in self.out and x in self.b and x != y
            forward = False
            zs = [z for z in couples if z in self.a and x <= y and
                  self.covers(x, y, z, False, back_x, back_y) <= left]
        if zs and (back_x or back_y):
            yield zs, forward, back_x, back_y
            if split and len(zs) > 1:
                for z in zs:
                    yield [z], forward, back_x, back_y
                real = [z for z in zs if not z[1]]
                if real and len(real) < len(zs):
                    yield real, forward, back_x, back_y

    def plan(self, rng, noise, weight, power):
        left, steps, total, known = set(self.left), [], [0, 0], set()
        while left:
            best = None
            for (x, y), couples in self.pairs.items():
                for zs, forward, back_x, back_y in self.candidates(x, y, couples, left, noise > 0):
                    covered = set().union(*(self.covers(x, y, z, forward, back_x, back_y)
                                            for z in zs)) & left
                    if not covered:
                        continue
                    single = None
                    if len(zs) == 1 and (back_x or back_y):
                        half = 0.5 if x != y and zs[0] in (x, y) and self.symmetric else 1.0
                        single = (zs[0], round(half * gaunt(x, y, zs[0]), 9))
                    mul, add = self.cost(x, y, zs, forward, back_x, back_y,
                                         single is not None and single in known)
                    gain = sum(size(to) ** power for _, to in covered)
                    score = (mul + weight * add) / gain * (1 + noise * rng.random())
                    if best is None or score < best[0]:
                        best = score, (x, y, zs, forward, back_x, back_y), covered, mul, add, single
            _, step, covered, mul, add, single = best
            steps.append(step)
            left -= covered
            known.add(single)
            total[0] += mul
            total[1] += add
        return total, steps


def search(a, b, out, tries):
    product = Product(a, b, out)
    rng = random.Random(1)
    best = None
    for t in range(tries):
        noise = 0.0 if t == 0 else rng.choice([0.03, 0.1, 0.2, 0.4])
        total, steps = product.plan(rng, noise, rng.choice([0, 0.3, 0.6]), rng.choice([0.5, 0.8, 1]))
        value = total[0] + 0.3 * total[1]
        if best is None or value < best[0]:
            best = value, total, steps
    print(f"{a}x{b}->{out}: {best[1][0]} multiplications, {best[1][1]} additions, "
          f"{len(best[2])} steps, besides band 0", file=sys.stderr)
    return best[2]


def text(name, steps):
    lines = [f"inline constexpr std::array<Step, {len(steps)}> k{name} = {{{{"]
    for x, y, zs, forward, back_x, back_y in steps:
        flags = "|".join(f for f, on in (("kForward", forward), ("kToX", back_x), ("kToY", back_y))
                         if on)
        numbers = ", ".join(str(index(z)) for z in zs)
        lines.append(f"    {{{index(x)}, {index(y)}, {flags.replace('|', ' | ')}, "
                     f"{len(zs)}, {{{numbers}}}}},")
    lines.append("}};")
    return lines


HEAD = """// SPDX-License-Identifier: MIT
// Steps of sparse products. Made by tools/product_plans.py.
#ifndef GAUNT_PRODUCT_PLANS_H_
#define GAUNT_PRODUCT_PLANS_H_

#include <array>

#include "product/plan.h"

namespace gaunt::product {

// clang-format off"""

TAIL = """// clang-format on

}  // namespace gaunt::product

#endif  // GAUNT_PRODUCT_PLANS_H_"""


def main():
    out = [HEAD]
    for a, b, o, tries in [(1, 1, 1, 1), (2, 2, 2, 1), (3, 3, 3, 3000), (4, 4, 4, 3000),
                           (6, 6, 3, 60), (2, 6, 6, 20), (3, 6, 6, 20)]:
        out += text(f"Steps{a}x{b}To{o}", search(a, b, o, tries))
    out.append(TAIL)
    print("\n".join(out))


if __name__ == "__main__":
    main()
