# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the formulas of Streamlines.md by numbers, for check.py."""

import cmath
import math

from meshes import bumpy, disk, icosphere
from method import (
    PI,
    Connection,
    Mesh,
    corner_angle,
    operators,
    singularity_indices,
    smallest_eigenpair,
)
from streamlines import Interpolant, Tracer, direction_near, hermite, ray_angles, root_of_cubic


def check_interpolant(mesh, connection, n, u):
    """On an edge q is the linear blend of its ends, the same from both sides; around a triangle it winds by the
    index; in singular triangles it has a zero of that sign."""
    field = [Interpolant(mesh, connection, n, u, t) for t in range(len(mesh.triangles))]
    index = singularity_indices(mesh, connection, n, u)
    for h, twin in enumerate(mesh.twin):
        (t, c), (other, d) = divmod(h, 3), divmod(twin, 3)
        here, there = field[t], field[other]
        # Against the edge, in which the head's ray arrives at the angle theta of its own half-edge plus pi.
        tail = u[mesh.tail(h)] * cmath.exp(-1j * n * connection.edge_angle[h])
        head = u[mesh.head(h)] * cmath.exp(-1j * n * (connection.edge_angle[twin] + PI))
        for s in (0.1, 0.5, 0.83):
            place = here.corner[c] + s * (here.corner[c - 2] - here.corner[c])
            beyond = there.corner[d - 2] + s * (there.corner[d] - there.corner[d - 2])
            q = here.at(place) / here.along[c] ** n
            assert abs(q - (1 - s) * tail - s * head) < 1e-10
            assert abs(q - there.at(beyond) / (-there.along[d]) ** n) < 1e-10
    for t in range(len(mesh.triangles)):
        winding, steps = 0.0, 16
        for c in range(3):
            places = [
                field[t].corner[c] + (k + 0.5) / steps * (field[t].corner[c - 2] - field[t].corner[c])
                for k in range(steps)
            ]
            ends = [field[t].power[c]]
            ends += [field[t].at(z) for z in places]
            following = 3 * t + (c + 1) % 3
            arriving = n * field[t].excess[c - 2] * corner_angle(mesh, following)
            ends.append(field[t].power[c - 2] * cmath.exp(1j * arriving))
            winding += sum(cmath.phase(b / a) for a, b in zip(ends, ends[1:]))
            winding -= n * field[t].excess[c] * corner_angle(mesh, 3 * t + c)
        assert abs(winding - 2 * PI * index[t]) < 1e-9, (winding, index[t])
    for t, k in enumerate(index):
        if abs(k) == 1:
            z = field[t].zero()
            value, along, conjugate = field[t].jet(z)
            assert abs(value) < 1e-9 * max(abs(p) for p in field[t].power), t
            assert (abs(along) > abs(conjugate)) == (k > 0)


def check_jet(mesh, connection, n, u):
    field = Interpolant(mesh, connection, n, u, 7)
    z = 0.5 * field.corner[0] + 0.3 * field.corner[1] + 0.2 * field.corner[2]
    value, along, conjugate = field.jet(z)
    assert abs(value - field.at(z)) < 1e-12
    for step in (1e-6, 1e-6j):
        change = along * step + conjugate * step.conjugate() if isinstance(step, complex) else along + conjugate
        change = change if isinstance(step, complex) else change * step
        assert abs(field.at(z + step) - value - change) < 1e-10


def check_rays():
    """A zero of index k/n has |n - k| rays, at (arg b + 2 pi m) / (n - k) where it is isotropic."""
    for n in (1, 2, 3, 4, 6):
        for k in (1, -1):
            for phase in (0.0, 0.7):

                def isotropic(beta):
                    return cmath.exp(1j * (k * beta + phase))

                angles = ray_angles(isotropic, n, k)
                assert len(angles) == abs(n - k), (n, k, len(angles))
                expected = [(phase + 2 * PI * m) / (n - k) for m in range(abs(n - k))]
                for a in expected:
                    assert min(abs(cmath.exp(1j * a) - cmath.exp(1j * b)) for b in angles) < 1e-9

                def bent(beta):
                    z = cmath.exp(1j * beta)
                    main, other = (z, z.conjugate()) if k > 0 else (z.conjugate(), z)
                    return main * cmath.exp(1j * phase) + 0.15 * other

                assert len(ray_angles(bent, n, k)) == abs(n - k)


def check_root():
    cubic = (0.3, 0.2, -0.1, -0.9)
    root = root_of_cubic(*cubic)
    assert abs(hermite(*cubic, root)) < 1e-12
    assert all(hermite(*cubic, root * k / 50) > 0 for k in range(50))
    # From an edge: 0 at the begin is not the exit.
    cubic = (0.0, 0.5, -0.2, -1.1)
    root = root_of_cubic(*cubic)
    assert 0.1 < root < 1 and abs(hermite(*cubic, root)) < 1e-12
    assert root_of_cubic(0.0, -0.1, -0.2, -0.1) == 0.0


def plane_field(mesh, connection, n, of):
    """u of a field in the plane whose n-th power at a place is of(z)."""
    u = []
    for v, p in enumerate(mesh.points):
        h = mesh.fan(v)[0]
        q = mesh.points[mesh.head(h)]
        own = math.atan2(q[1] - p[1], q[0] - p[0]) - connection.edge_angle[h]
        u.append(of(complex(p[0], p[1])) * cmath.exp(-1j * n * own))
    return u


def in_plane(mesh, t, field, z):
    """A place of a triangle laid flat in the plane of a flat mesh."""
    weights = [field.weight(c, z) for c in range(3)]
    return sum(w * complex(*mesh.points[v][:2]) for w, v in zip(weights, mesh.triangles[t]))


def check_straight_rays():
    """For q = z and its conjugate, which linear interpolation has exactly, rays are straight, and a line is
    a curve z(s) with z' along it: the fourth order of the method is seen in the end of a line that bends."""
    flat = disk(3)
    moved = [(x + 0.11 * math.sin(5 * x + 3 * y), y + 0.09 * math.cos(4 * x - y), 0.0) for x, y, _ in flat.points]
    mesh = Mesh(moved, flat.triangles)
    connection = Connection(mesh)
    for n in (2, 4):
        for k in (1, -1):
            u = plane_field(mesh, connection, n, (lambda z: z) if k > 0 else (lambda z: z.conjugate()))
            tracer = Tracer(mesh, connection, n, u)
            for t in range(len(mesh.triangles)):
                a, b, c = (complex(*mesh.points[v][:2]) for v in mesh.triangles[t])
                if all(((q - p).conjugate() * -p).imag > 0 for p, q in ((a, b), (b, c), (c, a))):
                    break
            turn = (b - a) / abs(b - a)
            for m in range(abs(n - k)):
                beta = 2 * PI * m / (n - k)
                ray = cmath.exp(1j * beta)
                start = (0.05 * ray - a) / turn
                pieces = tracer.trace(t, start, ray / turn, 2.0)
                assert len({piece[0] for piece in pieces}) > 2
                for triangle, _, end in pieces:
                    z = in_plane(mesh, triangle, tracer.on[triangle], end)
                    assert abs(cmath.phase(z / ray)) < 1e-9
    ends = []
    for part in (0.25, 0.125, 1 / 32):
        u = plane_field(mesh, connection, 4, lambda z: z)
        tracer = Tracer(mesh, connection, 4, u, part)
        pieces = tracer.trace(0, sum(tracer.on[0].corner) / 3, 1 + 0j, 1e9)
        triangle, _, end = pieces[-1]
        ends.append(in_plane(mesh, triangle, tracer.on[triangle], end))
    assert abs(ends[0] - ends[2]) < 1e-3 and abs(ends[1] - ends[2]) < 0.3 * abs(ends[0] - ends[2])


def check_no_crossing(mesh, connection, u):
    """Lines of a line field from places beside each other never cross."""
    tracer = Tracer(mesh, connection, 2, u)
    lines = []
    for s in (0.2, 0.4, 0.6, 0.8):
        field = tracer.on[5]
        z = (1 - s) * field.corner[0] + s * (0.5 * field.corner[1] + 0.5 * field.corner[2])
        across = direction_near(field.at(z), 2, 1j)
        lines.append(tracer.trace(5, z, across, 2.5))

    def side(a, b, z):
        return ((b - a).conjugate() * (z - a)).imag

    for i, line in enumerate(lines):
        for other in lines[:i]:
            for t, a, b in line:
                for s, c, d in other:
                    if s == t:
                        assert side(a, b, c) * side(a, b, d) > 0 or side(c, d, a) * side(c, d, b) > 0


def check():
    check_root()
    check_rays()
    check_straight_rays()
    mesh = bumpy(icosphere(1), 0.6)
    connection = Connection(mesh)
    for n in (1, 2, 4, 6):
        _, u = smallest_eigenpair(*operators(mesh, connection, n))
        check_interpolant(mesh, connection, n, u)
        check_jet(mesh, connection, n, u)
        if n == 2:
            check_no_crossing(mesh, connection, u)
