# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the formulas of Tensors.md by numbers, for check.py."""

import cmath
import math


def section(a, c, b, turn=0.0):
    """q and H of the plane tensor [a, b; b, c] in a frame that is turned."""
    x = (math.cos(turn), math.sin(turn))
    y = (-x[1], x[0])

    def form(u, v):
        return u[0] * (a * v[0] + b * v[1]) + u[1] * (b * v[0] + c * v[1])

    return complex((form(x, x) - form(y, y)) / 2, form(x, y)), (form(x, x) + form(y, y)) / 2


def check_section():
    """The principal values and the direction, in any frame."""
    a, c, b = 1.7, -0.6, 0.9
    root = math.sqrt((a - c) ** 2 / 4 + b * b)
    for turn in (0.0, 0.4, 2.0):
        q, mean = section(a, c, b, turn)
        assert abs(mean + abs(q) - (a + c) / 2 - root) < 1e-12
        assert abs(mean - abs(q) - (a + c) / 2 + root) < 1e-12
        theta = turn + cmath.phase(q) / 2
        x = (math.cos(theta), math.sin(theta))
        largest = (a + c) / 2 + root
        assert abs(a * x[0] + b * x[1] - largest * x[0]) < 1e-12
        assert abs(b * x[0] + c * x[1] - largest * x[1]) < 1e-12


def check_isotropic_points():
    """Around the zeros z and conj(z) the directions turn by half a turn, one way and the other."""
    for zero, turns in ((lambda z: z, 0.5), (lambda z: z.conjugate(), -0.5)):
        total = 0.0
        for k in range(60):
            before = zero(cmath.exp(2j * math.pi * k / 60))
            after = zero(cmath.exp(2j * math.pi * (k + 1) / 60))
            total += cmath.phase(after / before) / 2
        assert abs(total / (2 * math.pi) - turns) < 1e-12


def check_noise():
    """The figures 0.634 and 0.184: white noise on the lattice of equilateral triangles, where each
    of the six neighbours has an eighth of a mean."""
    weights = {(0, 0): 1.0}
    neighbours = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, -1), (-1, 1))
    scatter = 0.0
    for step in range(1, 33):
        before, new = weights, {}
        for (i, j), w in weights.items():
            new[i, j] = new.get((i, j), 0.0) + 0.25 * w
            for di, dj in neighbours:
                at = (i + di, j + dj)
                new[at] = new.get(at, 0.0) + 0.125 * w
        weights = new
        if step <= 2:
            change = sum((before.get(at, 0.0) - w) ** 2 for at, w in weights.items())
            scatter += change if step == 1 else -change
    assert abs(scatter - 0.634) < 5e-4
    assert abs(32 * sum(w * w for w in weights.values()) - 0.184) < 5e-3


def check():
    check_section()
    check_isotropic_points()
    check_noise()
