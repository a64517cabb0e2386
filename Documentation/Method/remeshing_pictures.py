# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of Remeshing.md, for pictures.py."""

import math

import extraction
import method
import remeshing
from meshes import bumpy, icosphere
from method import PI, Connection, cross, triangle_area
from svg import BLACK, BLUE, GREEN, GREY, ORANGE, RED, Picture

KIND = {1: RED, -1: BLUE}


def polar(center, radius, angle):
    return (center[0] + radius * math.cos(angle), center[1] - radius * math.sin(angle))


def charts():
    """The charts at the ends of an edge, whose matching is 1; a cone laid flat."""
    image = Picture(760, 300)
    i, j, n = (95, 190), (335, 190), 4
    alpha, beta = 0.5, 0.5 - PI / 2 + 0.12
    image.line([i, j], BLACK, 2.0)
    for center, edge, name in ((i, alpha, "i"), (j, beta, "j")):
        for k in range(n):
            angle = -edge + k * PI / 2
            color, width = (BLUE, 2.4) if k == 0 else ("#9fbbdc", 1.6)
            image.arrow(center, polar(center, 78, angle), color, width, 8)
        image.circle(center, 4, BLACK)
        image.text(center[0] - 10, center[1] + 22, name, 16)
    image.arc(i, 50, -alpha, 0, RED, 1.5, True)
    image.text(i[0] + 66, i[1] + 18, "α", 15, RED)
    image.arc(j, 38, -beta, 0, RED, 1.5, True)
    image.text(j[0] + 34, j[1] - 36, "β", 15, RED)
    image.text(215, 272, "α − β = 1 · 90° + r: the matching m is 1", 13)
    image.text(215, 292, "direction 0 is blue", 12, BLUE)
    center, size = (580, 150), 36

    def at(z):
        return (center[0] + size * z.real, center[1] - size * z.imag)

    for quarter in range(3):
        turn = 1j**quarter
        for a in range(3):
            for b in range(3):
                cell = [complex(a, b), complex(a + 1, b), complex(a + 1, b + 1), complex(a, b + 1)]
                image.area([at(turn * z) for z in cell], "#f6f8fa", GREY, 1.0)
    image.line([at(0j), at(3 + 0j)], ORANGE, 3.0)
    image.line([at(0j), at(-3j)], ORANGE, 3.0)
    image.arc(center, 62, -PI / 2, 0, ORANGE, 1.8, True)
    image.text(center[0] + 62, center[1] + 66, "z ↦ ζ z", 14, ORANGE)
    image.circle(center, 5, RED, RED)
    image.text(center[0] + 34, center[1] + 98, "glued", 12, ORANGE)
    image.text(580, 292, "a cone of index 1: three quarters of the plane", 13)
    return image


def isolines(places, coordinates):
    """The segments in a triangle on which a coordinate is an integer, each with the family's number."""
    segments = []
    for family in range(2):
        value = [z.imag if family else z.real for z in coordinates]
        for level in range(math.ceil(min(value)), math.floor(max(value)) + 1):
            ends = []
            for c in range(3):
                a, b = value[c], value[c - 2]
                if (a < level) != (b < level):
                    s = (level - a) / (b - a)
                    ends.append(tuple((1 - s) * x + s * y for x, y in zip(places[c], places[c - 2])))
            if len(ends) == 2:
                segments.append((family, ends))
    return segments


def integer_grid_map():
    """The cut graph of a cross field, and the lines of its map before and after the rounding."""
    image = Picture(760, 330)
    n = 4
    mesh = bumpy(icosphere(2), 0.6)
    connection = Connection(mesh)
    _, u = method.smallest_eigenpair(*method.operators(mesh, connection, n), 120)
    squared = [
        [mesh.squared_length(h) for h in range(3 * t, 3 * t + 3)] for t in range(len(mesh.triangles))
    ]
    area = sum(triangle_area(s) for s in squared)
    grid = remeshing.GridMap(mesh, connection, n, u, math.sqrt(area / 240))
    angle = 0.75
    seen = [
        (math.cos(angle) * x - math.sin(angle) * z, y, math.sin(angle) * x + math.cos(angle) * z)
        for x, y, z in grid.cut.positions
    ]
    words = ("paths of jumps between cones", "real numbers", "integers rounded")
    for panel, x in enumerate((None, grid.relaxed, grid.rounded)):
        center, scale = (130 + 250 * panel, 145), 106

        def place(p):
            return (center[0] + scale * p[0], center[1] - scale * p[1])

        def is_front(triangle):
            a, b, c = (seen[v] for v in triangle.vertex)
            return cross([q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)])[2] > 0

        front = [is_front(triangle) for triangle in grid.cut.triangles]
        corners = grid.corners(grid.exact(x))[0] if x is not None else None
        for t, triangle in enumerate(grid.cut.triangles):
            if front[t]:
                outline = [place(seen[v]) for v in triangle.vertex]
                image.area(outline, "#f6f8fa", "#dfe3e8", 0.6)
        for t, triangle in enumerate(grid.cut.triangles):
            if front[t] and x is not None:
                outline = [place(seen[v]) for v in triangle.vertex]
                drawn = [remeshing.place(p, n) / remeshing.UNIT for p in corners[t]]
                for _, ends in isolines(outline, drawn):
                    image.line(ends, GREEN, 1.3)
        if x is None:
            for path in grid.graph.paths:
                for h in path:
                    middles = []
                    for half in (h, mesh.twin[h]):
                        t = half // 3
                        if grid.matching.index[t] != 0:
                            middles.append(seen[grid.cut.triangles[t].vertex[0]])
                        else:
                            points = [seen[v] for v in mesh.triangles[t]]
                            middles.append([sum(c) / 3 for c in zip(*points)])
                    if all(front[half // 3] for half in (h, mesh.twin[h])):
                        image.line([place(p) for p in middles], ORANGE, 2.4)
        for t, index in enumerate(grid.matching.index):
            if index != 0 and front[t]:
                cone = grid.cut.triangles[t].vertex[0]
                image.circle(place(seen[cone]), 4.5, KIND[index], "white", 1.0)
        image.text(center[0], 300, words[panel], 13)
    count = len(grid.integers)
    image.text(
        380, 322, f"{len(grid.cut.cones)} cones, {len(grid.graph.paths)} jumps, {count} integers to round", 13
    )
    return image


def extraction_steps():
    """From the triangles of a map to the squares of the grid."""
    image = Picture(760, 540)
    mesh = extraction.example()
    words = (
        "the triangles of a map, and the points of the grid",
        "points inserted, edges flipped: Delaunay",
        "halfway: other vertices removed one by one",
        "all removed; the halves of squares joined",
    )
    for panel in range(4):
        left, top, scale = 30 + 375 * (panel % 2), 20 + 265 * (panel // 2), 52.0
        if panel == 1:
            mesh.insert_grid_points()
        if panel == 2:
            left_over = [v for v in range(len(mesh.places)) if v not in mesh.kept]
            for v in left_over[: len(left_over) // 2]:
                mesh.remove(v)
        if panel == 3:
            mesh.remove_all()

        def at(p):
            return (left + scale * p[0] / extraction.UNIT, top + scale * (4 - p[1] / extraction.UNIT))

        faces = mesh.squares() if panel == 3 else []
        for face in faces:
            image.area([at(mesh.places[v]) for v in face], "#dbe8f6", BLUE, 1.6)
        used = set()
        for t in sorted(mesh.triangles):
            used |= set(t)
            if panel == 3:
                image.area([at(mesh.places[v]) for v in t], "none", "#a9c2e0", 0.7)
            else:
                image.area([at(mesh.places[v]) for v in t], "#f6f8fa", GREY, 1.2)
        if panel == 0:
            for a in range(7):
                for b in range(5):
                    image.circle(at((a * extraction.UNIT, b * extraction.UNIT)), 3, "white", BLUE, 1.4)
        for v in sorted(used):
            image.circle(at(mesh.places[v]), 3.2, BLUE if v in mesh.kept else BLACK, "white", 0.8)
        image.text(left + 156, top + 232, words[panel], 13)
    return image
