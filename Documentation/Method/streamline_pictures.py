# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of Streamlines.md, for pictures.py."""

import cmath
import math

from meshes import disk
from method import PI, Connection, Mesh
from streamlines import Tracer, hermite, ray_angles, root_of_cubic
from svg import BLACK, BLUE, GREEN, GREY, ORANGE, RED, Picture


def separatrices():
    """Lines of two cross fields in the plane, those out of their singularities in red and blue."""
    image = Picture(760, 400)
    n, mesh = 4, disk(4)
    points = [(x + 0.1 * math.sin(5 * x + 3 * y), y + 0.1 * math.cos(4 * x - y), 0.0) for x, y, _ in mesh.points]
    mesh = Mesh(points, mesh.triangles)
    connection = Connection(mesh)
    for panel, k in enumerate((1, -1)):
        center, scale = (190 + 380 * panel, 180), 44

        def at(z):
            return (center[0] + scale * z.real, center[1] - scale * z.imag)

        def value(z):
            # A field that bends a little, so that rays are no straight lines.
            z = z - (0.13 + 0.21j)
            return (z if k > 0 else z.conjugate()) * cmath.exp(0.25j * z.real - 0.2j * z.imag)

        u = []
        for v, p in enumerate(mesh.points):
            q = mesh.points[mesh.head(mesh.fan(v)[0])]
            own = math.atan2(q[1] - p[1], q[0] - p[0]) - connection.edge_angle[mesh.fan(v)[0]]
            u.append(value(complex(*p[:2])) * cmath.exp(-1j * n * own))
        tracer = Tracer(mesh, connection, n, u)

        def frame(t):
            a, b = (complex(*mesh.points[v][:2]) for v in mesh.triangles[t][:2])
            return a, (b - a) / abs(b - a)

        def find(z):
            for t in range(len(mesh.triangles)):
                a, turn = frame(t)
                if min(tracer.on[t].weight(c, (z - a) / turn) for c in range(3)) > 1e-6:
                    return t
            return None

        def trace(z, direction, longest):
            t = find(z)
            if t is None:
                return []
            a, turn = frame(t)
            line = [z]
            for s, _, end in tracer.trace(t, (z - a) / turn, direction / turn, longest):
                a, turn = frame(s)
                line.append(a + turn * end)
            return line

        for triangle in mesh.triangles:
            image.area([at(complex(*mesh.points[v][:2])) for v in triangle], "none", "#e3e6ea", 0.8)
        for ring in range(1, 8):
            for m in range(8):
                start = 0.13 + 0.21j + 0.5 * ring * cmath.exp(2j * PI * (m + 0.5 * (ring % 2)) / 8)
                for way in (1, 1j, -1, -1j):
                    line = trace(start, way, 0.35)
                    if line:
                        image.line([at(z) for z in line], "#b9c6d6", 1.1)
        zero = None
        for t, field in enumerate(tracer.on):
            z = field.zero()
            if abs(field.at(z)) < 1e-9:
                a, turn = frame(t)
                zero = a + turn * z
        found = 0
        t = find(zero)
        a, turn = frame(t)
        rays = ray_angles(
            lambda beta: tracer.on[t].at((zero - a) / turn + 0.02 * cmath.exp(1j * beta)), n, k
        )
        for beta in rays:
            ray = cmath.exp(1j * beta) * turn
            line = [zero] + trace(zero + 0.02 * ray, ray, 9.0)
            image.line([at(z) for z in line], RED if k > 0 else BLUE, 2.2)
            found += 1
        image.circle(at(zero), 4.5, RED if k > 0 else BLUE, "white", 1.0)
        sign = "+1" if k > 0 else "−1"
        words = f"index {sign}: |n − k| = {found} lines end in it"
        image.text(center[0], 388, words, 14, RED if k > 0 else BLUE)
    return image


def exit_of_triangle():
    """A step that leaves a triangle, the chord and the cubic through its ends."""
    image = Picture(760, 290)
    corners = [60 + 250j, 430 + 250j, 210 + 40j]
    image.area([(z.real, z.imag) for z in corners], "#f6f8fa", GREY, 1.6)
    begin, end = 205 + 190j, 445 + 130j
    first, last = cmath.exp(-0.95j), cmath.exp(0.42j)
    length = 270.0

    def weight(z):
        a, b = corners[1], corners[2]
        normal = 1j * (b - a)
        inside = ((corners[0] - a) * normal.conjugate()).real
        return ((z - a) * normal.conjugate()).real / inside

    def slope(d):
        return (weight(begin + d) - weight(begin)) * length

    values = (weight(begin), slope(first), weight(end), slope(last))
    root = root_of_cubic(*values)
    curve = [hermite(begin, length * first, end, length * last, k / 40) for k in range(41)]
    image.line([(begin.real, begin.imag), (end.real, end.imag)], GREY, 1.4, dash="5 4")
    image.line([(z.real, z.imag) for z in curve], BLUE, 2.2)
    for z, d in ((begin, first), (end, last)):
        tip = z + 60 * d
        image.arrow((z.real, z.imag), (tip.real, tip.imag), ORANGE, 2.0, 8)
        image.circle((z.real, z.imag), 4, BLACK)
    at = hermite(begin, length * first, end, length * last, root)
    image.circle((at.real, at.imag), 5, RED, "white", 1.0)
    image.text(begin.real - 12, begin.imag + 18, "z_0", 15)
    image.text(end.real + 16, end.imag + 18, "z_1", 15)
    image.text(at.real + 8, at.imag - 12, "t", 15, RED, "start")
    left, top, width, height = 540, 30, 190, 190
    image.box(left, top, width, height, "none", GREY)
    low, high = values[2] - 0.15, max(hermite(*values, k / 40) for k in range(41)) + 0.1

    def on(t, b):
        return (left + width * t, top + height * (high - b) / (high - low))

    image.line([on(0, 0), on(1, 0)], GREY, 1.0)
    image.line([on(k / 40, hermite(*values, k / 40)) for k in range(41)], GREEN, 2.2)
    image.circle(on(root, 0), 5, RED, "white", 1.0)
    image.text(left + 0.5 * width, 248, "weight of the opposite corner", 13, GREEN)
    image.text(left + 0.5 * width, 268, "from the begin to the end of the step", 12)
    return image
