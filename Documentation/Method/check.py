# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the formulas of this folder's pages by numbers, and ends with an error where one does not hold:

    python3 Documentation/Method/check.py
"""

import cmath
import math

import check_prescribed
import check_remeshing
import check_streamlines
import check_tensors
from meshes import bumpy, icosphere, tetrahedron
from method import (
    PI,
    Connection,
    Factor,
    Mesh,
    distance,
    dot,
    local_integrals,
    operators,
    section_integrals,
    singularity_indices,
    smallest_eigenpair,
    times,
)

def quadrature(points, omega, bias):
    """The same as local_integrals, for a triangle in the plane that carries the curvature omega, by
    Gauss' rule. The section of corner c is its hat function times a unit section that is parallel along
    the rays from c: in the gauge of that unit section the connection at x is the form
    -i omega / (2 area) ((x - p_c) cross dx)."""
    rule = [(-math.sqrt(0.6), 5 / 18), (0.0, 8 / 18), (math.sqrt(0.6), 5 / 18)]
    parts = 12
    nodes = [((k + 0.5 + 0.5 * x) / parts, w / parts) for k in range(parts) for x, w in rule]

    def minus(a, b):
        return (a[0] - b[0], a[1] - b[1])

    sides = minus(points[1], points[0]), minus(points[2], points[0])
    area = 0.5 * (sides[0][0] * sides[1][1] - sides[0][1] * sides[1][0])
    gradient = []
    for c in range(3):
        e = minus(points[c - 1], points[(c + 1) % 3])
        gradient.append((-e[1] / (2 * area), e[0] / (2 * area)))
    mass = [[0.0] * 3 for _ in range(3)]
    energy = [[0.0] * 3 for _ in range(3)]
    for s, ws in nodes:
        for t, wt in nodes:
            b = (1 - s, s * (1 - t), s * t)
            x = tuple(sum(b[c] * points[c][d] for c in range(3)) for d in range(2))
            weight = ws * wt * s * 2 * area
            value, slope = [], []
            for c in range(3):
                # The holonomy of the triangle p_0, p_c, x takes the section of corner c to the gauge of
                # corner 0, in which all three are compared; the edges from corner 0 are transported by 1.
                phase = cmath.exp(1j * (0.0, omega * b[2], -omega * b[1])[c])
                d = minus(x, points[c])
                form = [-0.5j * omega / area * -d[1], -0.5j * omega / area * d[0]]
                value.append(phase * b[c])
                slope.append([phase * (gradient[c][k] + b[c] * form[k]) for k in range(2)])
            for i in range(3):
                for j in range(3):
                    mass[i][j] += weight * value[i].conjugate() * value[j]
                    products = sum(slope[i][k].conjugate() * slope[j][k] for k in range(2))
                    turned = 1j * (
                        slope[i][0].conjugate() * slope[j][1] - slope[i][1].conjugate() * slope[j][0]
                    )
                    # (1 + s) E_hol + (1 - s) E_anti with the derivatives by x + i y and by x - i y.
                    energy[i][j] += weight * (products + bias * turned)
    return area, mass, energy


def check_integrals():
    points = ((0.1, 0.2), (1.3, 0.1), (0.5, 0.9))
    squared = [distance(points[c], points[(c + 1) % 3]) ** 2 for c in range(3)]
    for omega in (0.0, 0.3, -1.1, 2.5, -4.0, 9.0):
        for bias in (0.0, 1.0, -0.6):
            area, mass, energy = quadrature(points, omega, bias)
            diagonal, local, m_diagonal, m = local_integrals(squared, area, omega, bias)
            # Around the triangle, r of the three edges is 1, exp(-i omega) and 1, or the like: the
            # holonomy r_01 r_12 r_20 is exp(i omega).
            r = (1.0, cmath.exp(1j * omega), 1.0)
            for c in range(3):
                j = (c + 1) % 3
                assert abs(mass[c][c] - m_diagonal) < 1e-7
                assert abs(mass[c][j] - m * complex(r[c]).conjugate()) < 1e-7, (omega, c)
                assert abs(energy[c][c] - diagonal[c]) < 1e-6, (omega, bias, c)
                assert abs(energy[c][j] - local[c] * complex(r[c]).conjugate()) < 1e-6, (omega, bias, c)
    for omega in (1.999999, -1.999999):
        nearly = section_integrals(omega * 1.000001)
        assert all(abs(a - b) < 1e-6 for a, b in zip(section_integrals(omega), nearly))


def check_connection(mesh):
    connection = Connection(mesh)
    for n in (1, 2, 4, 6):
        for t in range(len(mesh.triangles)):
            r = [connection.transport(3 * t + c, n) for c in range(3)]
            omega = n * connection.curvature[t]
            assert abs(r[0] * r[1] * r[2] - cmath.exp(1j * omega)) < 1e-12
    assert abs(sum(connection.curvature) - 4 * PI) < 1e-10


def check_energy(coarse, fine):
    # lambda_1 of the unit sphere is n (1 - s), up to an error that falls with the square of the edges.
    for n, bias in ((1, 0.0), (4, 0.0), (4, 0.5), (2, -1.0), (4, 1.0)):
        values = [
            smallest_eigenpair(*operators(mesh, Connection(mesh), n, bias))[0] for mesh in (coarse, fine)
        ]
        assert abs((4 * values[1] - values[0]) / 3 - n * (1 - bias)) < 0.05, (n, bias, values)
    # Positive semi-definite for each bias, with a boundary, too: the energy is a sum of squares.
    cap = [t for t in fine.triangles if all(fine.points[v][2] > -0.3 for v in t)]
    used = sorted({v for t in cap for v in t})
    number = {v: k for k, v in enumerate(used)}
    half = Mesh([fine.points[v] for v in used], [tuple(number[v] for v in t) for t in cap])
    for bias in (-1.0, 0.0, 1.0):
        for n in (1, 4):
            Factor(*operators(half, Connection(half), n, bias), 1.0, 1e-6)


def check_singularities(mesh):
    connection = Connection(mesh)
    for n in (1, 2, 3, 4, 6):
        for seed in range(3):
            u = [cmath.exp(1j * (2.4 * v * v + seed * v)) for v in range(len(mesh.points))]
            assert sum(singularity_indices(mesh, connection, n, u)) == 2 * n
        _, u = smallest_eigenpair(*operators(mesh, connection, n))
        assert sum(singularity_indices(mesh, connection, n, u)) == 2 * n


def check_large_indices():
    """Each triangle of a tetrahedron has the holonomy 4 pi for crosses, two turns."""
    mesh = tetrahedron()
    connection = Connection(mesh)
    assert all(abs(4 * k - 4 * PI) < 1e-12 for k in connection.curvature)
    _, u = smallest_eigenpair(*operators(mesh, connection, 4), 500)
    assert singularity_indices(mesh, connection, 4, u) == [2, 2, 2, 2]


def check_alignment(mesh):
    """u tends to q for lambda_t to minus infinity, and to the eigenvector for lambda_t to lambda_1."""
    n = 4
    energy, mass = operators(mesh, Connection(mesh), n)
    smallest, first = smallest_eigenpair(energy, mass, 1000)
    q = [cmath.exp(0.37j * v) for v in range(len(mesh.points))]
    for gap, limit in ((1e9, q), (1e-6, first)):
        u = Factor(energy, mass, 1.0, gap - smallest).solve([gap * x for x in times(mass, q)])
        along = abs(dot(times(mass, limit), u))
        sizes = dot(u, times(mass, u)).real * dot(limit, times(mass, limit)).real
        assert along / math.sqrt(sizes) > 1 - 1e-6, gap


def main():
    coarse = bumpy(icosphere(1))
    check_integrals()
    check_connection(coarse)
    check_connection(tetrahedron())
    check_energy(icosphere(1), icosphere(2))
    for mesh in (coarse, icosphere(0), tetrahedron()):
        check_singularities(mesh)
    check_large_indices()
    check_alignment(coarse)
    check_prescribed.check()
    check_remeshing.check()
    check_streamlines.check()
    check_tensors.check()
    print("The formulas hold.")


if __name__ == "__main__":
    main()
