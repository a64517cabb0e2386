# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of PrescribedSingularities.md, for pictures.py."""

import cmath
import math

import method
import prescribed
from meshes import bumpy, icosphere
from method import PI, Connection, cross
from svg import BLUE, ORANGE, Picture


def moved_singularities():
    """A line field, the integers routed to where its singularities are to be, and the field that has them."""
    image = Picture(760, 310)
    n, mesh = 2, bumpy(icosphere(2), 0.6)
    connection = Connection(mesh)
    _, base = method.smallest_eigenpair(*method.operators(mesh, connection, n), 120)
    editor = prescribed.Editor(mesh, connection, n, base)
    tangent = method.frames(mesh, connection)

    def toward(direction):
        """The triangle that is seen in a direction."""
        size = math.sqrt(sum(x * x for x in direction))

        def closeness(t):
            middle = [sum(mesh.points[v][d] for v in mesh.triangles[t]) / 3 for d in range(3)]
            length = math.sqrt(sum(x * x for x in middle))
            return sum(a * b for a, b in zip(direction, middle)) / (size * length)

        return max(range(len(mesh.triangles)), key=closeness)

    wanted = [toward(d) for d in ((-0.5, 0.5, 1.0), (0.45, 0.6, 1.0), (0.1, -0.6, 1.0), (0.0, 0.0, -1.0))]
    indices = [1 if t in wanted else 0 for t in range(len(mesh.triangles))]
    route = editor.tree.route([k - j for k, j in zip(indices, editor.indices)])
    turn, rotation = editor.turn(indices, {t: (1 / 3, 1 / 3, 1 / 3) for t in wanted})
    fields = ((base, editor.indices), (base, editor.indices), (editor.section(turn), indices))
    found = method.singularity_indices(mesh, connection, n, fields[2][0])
    most = max(abs(x) for x in rotation) / PI
    words = ("the smoothest line field", "integers p routed along a tree", "the field with the indices asked for")
    for panel, (u, index) in enumerate(fields):
        center, scale = (130 + 250 * panel, 140), 100

        def place(p):
            return (center[0] + scale * p[0], center[1] - scale * p[1])

        front = []
        for t, triangle in enumerate(mesh.triangles):
            a, b, c = (mesh.points[v] for v in triangle)
            front.append(cross([q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)])[2] > 0)
            if front[t]:
                fill = "#f3c1bb" if index[t] > 0 else "#f6f8fa"
                if panel == 1 and indices[t] != 0:
                    fill = "#f8dcb8"
                image.area([place(p) for p in (a, b, c)], fill, "#d5dae1", 0.7)
        if panel == 1:
            for e, h in enumerate(editor.forms.edges):
                sides = h // 3, mesh.twin[h] // 3
                if route[e] != 0 and all(front[t] for t in sides):
                    middles = [
                        [sum(mesh.points[v][d] for v in mesh.triangles[t]) / 3 for d in range(3)] for t in sides
                    ]
                    image.line([place(p) for p in middles], ORANGE, 1.6 + 0.8 * abs(route[e]))
        else:
            for v, p in enumerate(mesh.points):
                normal, x, y = tangent[v]
                if normal[2] < 0.12:
                    continue
                angle = cmath.phase(u[v]) / n
                d = [math.cos(angle) * e + math.sin(angle) * f for e, f in zip(x, y)]
                ends = [[e + s * 0.08 * f for e, f in zip(p, d)] for s in (-1, 1)]
                image.line([place(q) for q in ends], BLUE, 1.7)
        image.text(center[0], 282, words[panel], 13)
    same = "the same" if found == indices else "others"
    image.text(
        380, 304, f"indices of the new field, computed anew: {same}; largest rotation {most:.2f} of a half turn", 13
    )
    return image
