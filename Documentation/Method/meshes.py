# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small meshes for method.py and pictures.py."""

import math

from method import Mesh, cross, distance, scalar


def icosphere(levels):
    g = (1 + math.sqrt(5)) / 2
    points = [(s * a, t * b * g, 0.0) for a in (1,) for b in (1,) for s in (-1, 1) for t in (-1, 1)]
    points = [p[k:] + p[:k] for k in (0, 2, 1) for p in points]
    points = [tuple(x / math.sqrt(1 + g * g) for x in p) for p in points]
    edge = min(distance(points[0], p) for p in points[1:])
    near = [
        [w for w in range(12) if w != v and distance(points[v], points[w]) < 1.1 * edge] for v in range(12)
    ]
    triangles = []
    for a in range(12):
        for b in near[a]:
            for c in near[a]:
                if a < b and a < c and c in near[b] and scalar(cross(points[a], points[b]), points[c]) > 0:
                    triangles.append((a, b, c))
    for _ in range(levels):
        middle, finer = {}, []
        for triangle in triangles:
            inner = []
            for c in range(3):
                a, b = triangle[c], triangle[(c + 1) % 3]
                key = (min(a, b), max(a, b))
                if key not in middle:
                    p = [x + y for x, y in zip(points[a], points[b])]
                    size = math.sqrt(sum(x * x for x in p))
                    middle[key] = len(points)
                    points.append(tuple(x / size for x in p))
                inner.append(middle[key])
            a, b, c = triangle
            x, y, z = inner
            finer += [(a, x, z), (x, b, y), (z, y, c), (x, y, z)]
        triangles = finer
    return Mesh(points, triangles)


def tetrahedron():
    points = [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)]
    return Mesh(points, [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)])


def bumpy(mesh, amount=0.35):
    """The same connectivity without any symmetry."""

    def factor(p):
        bumps = 0.6 * math.sin(2.3 * p[0] + 0.4) * p[1] + 0.5 * p[2] * p[2] * p[0] + 0.4 * p[1] * p[2]
        return 1 + amount * bumps

    return Mesh([tuple(factor(p) * x for x in p) for p in mesh.points], mesh.triangles)


def disk(rings):
    """A triangulated disk in the plane, a triangle in its middle."""
    points, rows = [], []
    height = math.sqrt(3) / 2
    for y in range(-rings, rings + 1):
        row = {}
        for x in range(-2 * rings, 2 * rings + 1):
            p = (x + 0.5 * (y % 2) - 0.5, (y + 1 / 3) * height, 0.0)
            if math.hypot(p[0], p[1]) <= rings - 0.1:
                row[x] = len(points)
                points.append(p)
        rows.append((y, row))
    triangles = []
    for (y, low), (_, high) in zip(rows, rows[1:]):
        side = y % 2
        for x, v in low.items():
            right, left_up, right_up = low.get(x + 1), high.get(x - 1 + side), high.get(x + side)
            if right is not None and right_up is not None:
                triangles.append((v, right, right_up))
            if left_up is not None and right_up is not None:
                triangles.append((v, right_up, left_up))
    used = sorted({v for t in triangles for v in t})
    number = {v: k for k, v in enumerate(used)}
    return Mesh([points[v] for v in used], [tuple(number[v] for v in t) for t in triangles])


def morton(p, low, high):
    code = 0
    for bit in range(15, -1, -1):
        for d in range(2):
            cell = int((p[d] - low) / (high - low) * 65535)
            code = 2 * code + (cell >> bit & 1)
    return code


def patch(columns, rows):
    """A patch of the plane, stretched on its right half; its vertices follow a Morton curve."""
    points = []
    for r in range(rows):
        for k in range(columns):
            noise = math.sin(12.9898 * k + 78.233 * r) * 43758.5453
            other = math.sin(39.346 * k + 11.135 * r) * 24634.6345
            jitter = 0.22
            dx, dy = jitter * (noise - math.floor(noise) - 0.5), jitter * (other - math.floor(other) - 0.5)
            x = k + 0.5 * (r % 2) + dx
            x = x if x < columns / 2 else columns / 2 + 2.6 * (x - columns / 2)
            points.append((x, 0.87 * (r + dy), 0.0))
    triangles = []
    for r in range(rows - 1):
        for k in range(columns - 1):
            v = r * columns + k
            up = v + columns
            if r % 2 == 0:
                triangles += [(v, v + 1, up), (v + 1, up + 1, up)]
            else:
                triangles += [(v, v + 1, up + 1), (v, up + 1, up)]
    high = max(max(p[:2]) for p in points) + 0.2
    order = sorted(range(len(points)), key=lambda v: morton(points[v], -0.2, high))
    number = {v: k for k, v in enumerate(order)}
    return Mesh([points[v] for v in order], [tuple(number[v] for v in t) for t in triangles])


def torus(columns, rows, radius=2.0):
    """Its tube has the radius 1 and is a little uneven."""
    points = []
    for k in range(columns):
        for r in range(rows):
            a, b = 2 * math.pi * k / columns, 2 * math.pi * r / rows
            size = 1 + 0.15 * math.sin(2 * a + b)
            away = radius + size * math.cos(b)
            points.append((away * math.cos(a), away * math.sin(a), size * math.sin(b)))
    triangles = []
    for k in range(columns):
        for r in range(rows):
            v, up = k * rows + r, k * rows + (r + 1) % rows
            right, corner = (k + 1) % columns * rows + r, (k + 1) % columns * rows + (r + 1) % rows
            triangles += [(v, right, corner), (v, corner, up)]
    return Mesh(points, triangles)
