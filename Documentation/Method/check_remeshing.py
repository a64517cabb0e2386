# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the formulas and invariants of Remeshing.md by numbers, for check.py."""

import cmath
import math
import random

import extraction
import integers
import remeshing
from integers import Sum
from meshes import bumpy, icosphere, torus
from method import (
    PI,
    Connection,
    edge_rotations,
    operators,
    singularity_indices,
    smallest_eigenpair,
    triangle_area,
)
from remeshing import UNIT, Transition, minus, turned


def is_identity(transition):
    return transition.turn == 0 and not transition.shift


def surface_area(mesh):
    squared = [
        [mesh.squared_length(h) for h in range(3 * t, 3 * t + 3)] for t in range(len(mesh.triangles))
    ]
    return sum(triangle_area(s) for s in squared)


def check_grid():
    """zeta times a + b zeta, and the norm, in coordinates; a transition and its inverse."""
    for n in (4, 6):
        zeta = cmath.exp(2j * PI / n)
        for point in ((3, -2), (0, 5), (-7, 1)):
            z = remeshing.place(point, n)
            assert abs(remeshing.place(turned(point, 1, n), n) - zeta * z) < 1e-12
            a, b = point
            assert abs(abs(z) ** 2 - (a * a + b * b + (0 if n == 4 else a * b))) < 1e-12
        first = Transition(n, 1, {0: (2, 1)})
        second = Transition(n, n - 2, {0: (0, 3), 1: (1, -1)})
        assert is_identity(first.after(first.inverse())) and is_identity(second.inverse().after(second))
        jumps = [(5, -2), (1, 4)]
        both = second.apply(first.apply((6, 7), jumps), jumps)
        assert second.after(first).apply((6, 7), jumps) == both


def check_matching(mesh, connection, n, u, matching):
    assert matching.index == singularity_indices(mesh, connection, n, u)
    omega = edge_rotations(mesh, connection, n, u)
    assert all(abs(n * r - w) < 1e-9 for r, w in zip(matching.remainder, omega))
    for t, index in enumerate(matching.index):
        assert (sum(matching.m[3 * t : 3 * t + 3]) + index) % n == 0


def check_cut_graph(mesh, matching, graph, euler):
    """Around each regular triangle the transitions are the identity, whatever the jumps are."""
    assert graph.loops == 2 - euler
    singular = [t for t, index in enumerate(matching.index) if index != 0]
    assert len(graph.paths) == max(len(singular), 1) - 1 + graph.loops
    for t, index in enumerate(matching.index):
        around = Transition(matching.n)
        for h in range(3 * t, 3 * t + 3):
            around = around.after(graph.along(h))
        if index == 0 and t != graph.seed:
            assert is_identity(around), t
        else:
            assert around.turn == -index % matching.n
    for h, twin in enumerate(mesh.twin):
        assert is_identity(graph.along(h).after(graph.along(twin)))


def check_elimination():
    """Random integers in the free variables satisfy all equations, and make integers of the dependent ones."""
    numbers = random.Random(7)
    for _ in range(20):
        solved = integers.Elimination([0] * 2 + [1] * 8)
        equations = []
        for k in range(5):
            terms = {v: numbers.choice((-4, -3, -2, 2, 3, 4)) for v in numbers.sample(range(2, 10), 3)}
            # Two of the equations tie a real variable to integers.
            equations.append(Sum(terms) + Sum({k: 1} if k < 2 else {}))
            solved.require(equations[-1])
        value = {v: numbers.randint(-9, 9) for v in solved.free()}
        for v in range(len(solved.integer)):
            if v in solved.dependent:
                terms = solved.resolve(Sum({v: 1}))
                value[v] = sum(c * value[w] for w, c in terms.items())
                assert not solved.integer[v] or all(solved.integer[w] for w in terms)
        assert all(sum(c * value[v] for v, c in e.items()) == 0 for e in equations)


def check_fixed_points():
    """(1 - zeta^M) c = tau: for n = 4 and M = 1 there is a grid point c where the coordinates of tau have an
    even sum, for n = 6 always."""
    for a in range(-4, 5):
        for b in range(-4, 5):
            for n, sign in ((4, 1), (4, -1), (6, 1), (6, -1)):
                c = remeshing.coordinates(
                    remeshing.place((a, b), n) / (1 - cmath.exp(2j * PI * sign / n)), n
                )
                is_integer = all(abs(x - round(x)) < 1e-9 for x in c)
                assert is_integer == (n == 6 or (a + b) % 2 == 0)


def check_rounding(grid):
    """Fixing one integer by its column of the covariance is what the whole system says."""
    reals = grid.energy.reals
    x, g = grid.relaxed, grid.covariance
    k = len(g) // 2
    step = round(x[reals + k]) - x[reals + k]
    matrix, side, at = grid.energy.matrix, grid.energy.side, reals + k
    others = [i for i in range(len(x)) if i != at]
    fixed = integers.solve(
        integers.cholesky([[matrix[i][j] for j in others] for i in others]),
        [side[i] - matrix[i][at] * (x[at] + step) for i in others],
    )
    for i, value in zip(others, fixed):
        if i >= reals:
            assert abs(value - (x[i] + step * g[i - reals][k] / g[k][k])) < 1e-8
    # What the energy gains is the square of the step over the variance.
    gained = grid.energy_at(fixed[:at] + [x[at] + step] + fixed[at:]) - grid.energy_at(x)
    assert abs(gained - step * step / g[k][k]) < 1e-8
    assert grid.energy_at(grid.relaxed) < grid.energy_at(grid.rounded)
    # Rounding one by one costs less than rounding all at once.
    at_once = grid.with_integers([float(round(y)) for y in grid.relaxed[reals:]])
    assert grid.energy_at(grid.rounded) < grid.energy_at(at_once)


def check_map(grid, n):
    """Charts agree exactly across each edge; cones are grid points; the area is that of whole cells."""
    value = grid.exact(grid.rounded)
    corners, jumps = grid.corners(value)
    for t, triangle in enumerate(grid.cut.triangles):
        for c, twin in enumerate(triangle.twin):
            other, d = divmod(twin, 3)
            # The tail here is the head there.
            tails = corners[t][c], corners[other][(d + 1) % 3]
            heads = corners[t][(c + 1) % 3], corners[other][d]
            along, beyond = minus(heads[0], tails[0]), minus(heads[1], tails[1])
            turns = [k for k in range(n) if turned(beyond, k, n) == along]
            assert turns, "The two sides of an edge are not turned into each other."
            shift = minus(tails[0], turned(tails[1], turns[0], n))
            assert all(x % UNIT == 0 for x in shift)
    for v, _ in grid.cut.cones:
        assert all(value[2 * v + k] % UNIT == 0 for k in range(2))
    assert all(x % UNIT == 0 for jump in jumps for x in jump)
    twice = 0
    for p, q, r in corners:
        u, v = minus(q, p), minus(r, p)
        twice += u[0] * v[1] - u[1] * v[0]
    # For n = 6 a cell is a triangle, half a parallelogram of the grid.
    assert twice % (UNIT * UNIT * (2 if n == 4 else 1)) == 0


def check_extraction():
    """Removal leaves the grid's own triangles: halves of unit squares, which are all joined."""
    mesh = extraction.example()
    boundary = sum(1 for a, b in mesh.edges() if (b, a) not in mesh.edges())
    assert boundary == 2 * (5 + 4)
    mesh.insert_grid_points()
    assert mesh.remove_all() == 0
    assert len(mesh.triangles) == 2 * 6 * 4 and len(mesh.kept) == 7 * 5
    faces = mesh.squares()
    assert len(faces) == 6 * 4
    used = {v for face in faces for v in face}
    edges = {frozenset((face[c], face[c - 1])) for face in faces for c in range(4)}
    assert len(used) - len(edges) + len(faces) == 1


def check_sum_of_valences():
    """The sum of (4 - valence) and (4 - corners) over a closed mesh of quads and triangles is 4 chi: for a
    cube with one face cut into two triangles, and for the torus of quads."""
    cube = [(0, 3, 2, 1), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6), (4, 6, 7)]
    grid = [
        (3 * i + j, 3 * ((i + 1) % 3) + j, 3 * ((i + 1) % 3) + (j + 1) % 3, 3 * i + (j + 1) % 3)
        for i in range(3)
        for j in range(3)
    ]
    for faces, euler in ((cube, 2), (grid, 0)):
        edges = {frozenset((f[c], f[c - 1])) for f in faces for c in range(len(f))}
        vertices = {v for f in faces for v in f}
        assert len(vertices) - len(edges) + len(faces) == euler
        valence = sum(4 - sum(1 for e in edges if v in e) for v in vertices)
        assert valence + sum(4 - len(f) for f in faces) == 4 * euler


def check_pairs_for_sizes():
    """A layer has half of |grad l| / l^2 pairs for each unit of area: L / 2 (1 / l0 - 1 / l1) over a strip, 49 where
    3000 faces of a square grow from 1 to 5. Around a pair at opposite corners of a quad two rows begin."""
    steps = 10000
    area = sum(1.0 / (1.0 + 4.0 * (k + 0.5) / steps) ** 2 for k in range(steps)) / steps
    least = math.sqrt(area / 3000.0)
    lengths = [least * (1.0 + 4.0 * (k + 0.5) / steps) for k in range(steps)]
    pairs = sum(0.5 * 4.0 * least / length**2 for length in lengths) / steps
    assert abs(pairs - 0.5 * (1.0 / least - 1.0 / (5.0 * least))) < 1e-3 * pairs
    assert round(pairs) == 49
    # A walk of edges that closes around the pair would not close in the grid: each corner of three faces, or five, is
    # a turn by a quarter about it, forth and back.
    three, five = 0.0, 1.0 + 1.0j
    after = (lambda z: three + 1j * (z - three)), (lambda z: five - 1j * (z - five))
    assert abs(after[1](after[0](0.0)) - 0.0) == 2.0


def check():
    check_grid()
    check_pairs_for_sizes()
    check_elimination()
    check_fixed_points()
    check_extraction()
    check_sum_of_valences()
    mesh = bumpy(icosphere(1))
    connection = Connection(mesh)
    for n in (4, 6):
        _, u = smallest_eigenpair(*operators(mesh, connection, n))
        grid = remeshing.GridMap(mesh, connection, n, u, math.sqrt(surface_area(mesh) / 60))
        check_matching(mesh, connection, n, u, grid.matching)
        check_cut_graph(mesh, grid.matching, grid.graph, 2)
        assert len(grid.integers) == 2 * (len(grid.cut.cones) - 2)
        check_rounding(grid)
        check_map(grid, n)
    mesh = torus(9, 6)
    connection = Connection(mesh)
    for n in (4, 6):
        for u in (
            smallest_eigenpair(*operators(mesh, connection, n))[1],
            [cmath.exp(1j * (0.7 * v * v)) for v in range(len(mesh.points))],
        ):
            matching = remeshing.Matching(mesh, connection, n, u)
            graph = remeshing.CutGraph(mesh, matching)
            check_matching(mesh, connection, n, u, matching)
            check_cut_graph(mesh, matching, graph, 0)
            cut = remeshing.CutMesh(mesh, connection, matching, graph, u)
            solved = remeshing.Variables(cut).solved
            integers = sum(1 for v in solved.free() if solved.integer[v])
            assert integers == 2 * len(cut.cones) or graph.seed is not None, (integers, len(cut.cones))
