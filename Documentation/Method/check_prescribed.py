# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the formulas of PrescribedSingularities.md by numbers, for check.py."""

import cmath
import random

import prescribed
from meshes import bumpy, icosphere, torus
from method import PI, Connection, operators, singularity_indices, smallest_eigenpair


def base_of(mesh, connection, n):
    return smallest_eigenpair(*operators(mesh, connection, n))[1]


def check_sums(editor, indices, rotation):
    """d w = 2 pi k - Omega around each triangle."""
    for t, k in enumerate(indices):
        wanted = 2 * PI * k - editor.n * editor.connection.curvature[t]
        assert abs(editor.forms.around(rotation, t) - wanted) < 1e-9


def check_sphere(mesh, connection, numbers):
    for n in (1, 2, 4):
        base = base_of(mesh, connection, n)
        editor = prescribed.Editor(mesh, connection, n, base)
        random_base = [cmath.exp(1j * numbers.uniform(0, 6)) for _ in mesh.points]
        other = prescribed.Editor(mesh, connection, n, random_base)
        # Its own indices: the energy of the rotation does not grow.
        _, rotation = editor.turn(editor.indices)
        energy = editor.forms.product(rotation, rotation)
        assert energy <= editor.forms.product(editor.omega, editor.omega) + 1e-9
        # Moved to other triangles, from the field and from a random one: the same rotation.
        triangles = numbers.sample(range(len(mesh.triangles)), 2 * n)
        indices = [1 if t in triangles else 0 for t in range(len(mesh.triangles))]
        turn, rotation = editor.turn(indices)
        check_sums(editor, indices, rotation)
        again = other.turn(indices)[1]
        assert max(abs(x - y) for x, y in zip(rotation, again)) < 1e-8
        if max(abs(x) for x in rotation) < PI:
            assert singularity_indices(mesh, connection, n, editor.section(turn)) == indices
        # The least change of a field to its own indices is none.
        turn, rotation = editor.turn(editor.indices, keeps=True)
        assert max(abs(x) for x in turn) < 1e-9
        assert max(abs(x - y) for x, y in zip(rotation, editor.omega)) < 1e-9


def check_divergence(editor, indices, numbers):
    """The rotation of least energy has no divergence; with set edges only their corners have, together none."""
    _, rotation = editor.turn(indices)
    assert max(abs(x) for x in editor.forms.inflow(rotation)) < 1e-8
    places = {t: (0.5, 0.3, 0.2) for t, k in enumerate(indices) if k != 0}
    turn, rotation = editor.turn(indices, places)
    check_sums(editor, indices, rotation)
    inflow = editor.forms.inflow(rotation)
    corners = {v for t in places for v in editor.mesh.triangles[t]}
    assert max(abs(x) for v, x in enumerate(inflow) if v not in corners) < 1e-8
    assert max(abs(x) for x in inflow) > 1e-3
    for t, weights in places.items():
        holonomy = editor.n * editor.connection.curvature[t]
        wanted = prescribed.rotation_around(editor.flat(t), weights, indices[t], holonomy)
        assert abs(sum(wanted) - 2 * PI * indices[t] + holonomy) < 1e-9
        assert max(abs(x) for x in wanted) < PI
        for c, x in enumerate(wanted):
            assert abs(editor.forms.along(rotation, 3 * t + c) - x) < 1e-9


def check_torus():
    """2 g loops; a closed form changes one turning number by one; the chosen ones have the least energy."""
    mesh, n = torus(9, 6), 4
    connection = Connection(mesh)
    editor = prescribed.Editor(mesh, connection, n, base_of(mesh, connection, n))
    tree, forms = editor.tree, editor.forms
    assert len(tree.generators) == 2
    loops = [tree.loop_of(g) for g in tree.generators]
    closed = [tree.form_of(g) for g in tree.generators]
    for loop in loops:
        for h, following in zip(loop, loop[1:] + loop[:1]):
            assert mesh.head(h) == mesh.tail(following)
    for z in closed:
        assert all(forms.around(z, t) == 0 for t in range(len(mesh.triangles)))
    indices = [0] * len(mesh.triangles)
    indices[10], indices[70] = 1, -1
    _, rotation = editor.turn(indices)
    check_sums(editor, indices, rotation)
    energy = forms.product(rotation, rotation)
    numbers = [prescribed.turning_number(mesh, connection, n, forms, rotation, loop) for loop in loops]
    assert all(abs(x - round(x)) < 1e-8 for x in numbers)
    for j, z in enumerate(closed):
        for sign in (1, -1):
            moved = [w + sign * 2 * PI * x for w, x in zip(rotation, z)]
            after = [prescribed.turning_number(mesh, connection, n, forms, moved, loop) for loop in loops]
            changed = [round(b - a) for a, b in zip(numbers, after)]
            assert changed == [sign if i == j else 0 for i in range(2)], changed
            moved = forms.without_rise(moved, editor.solve(moved))
            assert forms.product(moved, moved) > energy


def check_bound():
    """A triangle can have the index k if |2 pi k - Omega| < 3 pi: in the plane 1 and -1, not 2."""
    for k, holonomy, can in ((1, 0.0, True), (2, 0.0, False), (2, 4 * PI, True), (-1, 2 * PI, False)):
        flat = [0j, 1 + 0j, 0.3 + 0.8j]
        around = prescribed.rotation_around(flat, (1 / 3, 1 / 3, 1 / 3), k, holonomy)
        assert (max(abs(x) for x in around) < PI) == can


def check():
    numbers = random.Random(3)
    mesh = bumpy(icosphere(1))
    connection = Connection(mesh)
    check_bound()
    check_sphere(mesh, connection, numbers)
    editor = prescribed.Editor(mesh, connection, 2, base_of(mesh, connection, 2))
    indices = [1 if t in (3, 21, 44, 70) else 0 for t in range(len(mesh.triangles))]
    check_divergence(editor, indices, numbers)
    check_torus()
