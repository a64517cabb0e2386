# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Equations with integer coefficients, small symmetric systems, and the rounding of their unknowns, for
Remeshing.md and PrescribedSingularities.md.
"""

import math


class Sum(dict):
    """A sum of variables with integer coefficients."""

    def __add__(self, other):
        result = Sum(self)
        for v, c in other.items():
            result[v] = result.get(v, 0) + c
            if result[v] == 0:
                del result[v]
        return result

    def __neg__(self):
        return Sum({v: -c for v, c in self.items()})

    def __sub__(self, other):
        return self + -other

    def times(self, factor):
        return Sum({v: factor * c for v, c in self.items()})


class Elimination:
    """Integers/IntegerElimination"""

    def __init__(self, integer):
        self.integer, self.dependent = list(integer), {}

    def resolve(self, sum_):
        result = Sum()
        for v, factor in sum_.items():
            if v in self.dependent:
                self.dependent[v] = self.resolve(self.dependent[v])
                result = result + self.dependent[v].times(factor)
            else:
                result = result + Sum({v: factor})
        return result

    def require(self, sum_):
        """The sum vanishes from now on."""
        sum_ = self.resolve(sum_)
        while sum_:
            divisor = math.gcd(*sum_.values())
            sum_ = Sum({v: c // divisor for v, c in sum_.items()})
            units = [(self.integer[v], -v) for v, c in sum_.items() if abs(c) == 1]
            if units:
                pivot = -min(units)[1]
                factor = sum_.pop(pivot)
                self.dependent[pivot] = sum_.times(-factor)
                return
            # A step of Euclid: x = x' - s y leaves the remainder of y's coefficient by that of x.
            x = min(sum_, key=lambda v: (abs(sum_[v]), v))
            y = next(v for v in sorted(sum_) if v != x and sum_[v] % sum_[x] != 0)
            new = len(self.integer)
            self.integer.append(self.integer[x])
            quotient = sum_[y] // sum_[x]
            self.dependent[x] = Sum({new: 1, y: -quotient})
            sum_ = self.resolve(sum_)

    def free(self):
        """The free variables, those that are real before the integers."""
        variables = [v for v in range(len(self.integer)) if v not in self.dependent]
        return sorted(variables, key=lambda v: (self.integer[v], v))


def cholesky(matrix):
    rows = []
    for i, line in enumerate(matrix):
        row = []
        for j in range(i + 1):
            other = rows[j] if j < i else row
            rest = line[j] - sum(x * y for x, y in zip(row, other))
            row.append(rest / other[j] if j < i else math.sqrt(rest))
        rows.append(row)
    return rows


def solve(factor, side):
    x = list(side)
    for i, row in enumerate(factor):
        x[i] = (x[i] - sum(row[k] * x[k] for k in range(i))) / row[i]
    for i in range(len(x) - 1, -1, -1):
        x[i] /= factor[i][i]
        for k in range(i):
            x[k] -= factor[i][k] * x[i]
    return x


def covariance(factor, reals):
    """G, the inverse of the Schur complement of the integers, by the trailing block of the factor."""
    block = [row[reals:] for row in factor[reals:]]
    size = len(block)
    return [solve(block, [1.0 if i == k else 0.0 for i in range(size)]) for k in range(size)]


def round_greedily(g, x):
    """The one that is nearest to an integer gets it, the others follow (Integers/IntegerRounding)."""
    g, x, left = [list(row) for row in g], list(x), list(range(len(x)))
    while left:
        k = min(left, key=lambda i: (abs(x[i] - round(x[i])), i))
        step, variance = round(x[k]) - x[k], g[k][k]
        column = [row[k] for row in g]
        for i in left:
            x[i] += step * column[i] / variance
            for j in left:
                g[i][j] -= column[i] * column[j] / variance
        x[k] = float(round(x[k]))
        left.remove(k)
    return x
