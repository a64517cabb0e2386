# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The extraction of Remeshing.md in one chart: grid points are inserted into the triangles of a map, all other
vertices are removed, triangles are joined in pairs. Coordinates are integers, in parts of the grid's unit.
"""

UNIT = 1 << 10


def orientation(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def is_in_circle(p, q, r, s):
    """Whether s is inside of the circle through p, q, r, which are counter-clockwise."""
    edges = [(x[0] - s[0], x[1] - s[1]) for x in (p, q, r)]
    return (
        sum(
            (u[0] ** 2 + u[1] ** 2) * (v[0] * w[1] - v[1] * w[0])
            for u, v, w in zip(edges, edges[1:] + edges[:1], edges[2:] + edges[:2])
        )
        > 0
    )


def quality(p, q, r):
    """Twice the area over the sum of the squared sides; negative where the triangle is turned over."""
    squares = sum((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 for a, b in ((p, q), (q, r), (r, p)))
    return orientation(p, q, r) / squares


class ExtractionMesh:
    """Triangles in the plane of the grid (Extraction/ExtractionMesh, whose charts are many)."""

    def __init__(self, places, triangles):
        self.places, self.triangles = list(places), set(tuple(t) for t in triangles)
        self.kept = set()

    def edges(self):
        """The triangle to the left of each half-edge, turned such that this comes first."""
        return {(t[c], t[c - 2]): (t[c], t[c - 2], t[c - 1]) for t in self.triangles for c in range(3)}

    def drop(self, triangle):
        for c in range(3):
            self.triangles.discard(triangle[c:] + triangle[:c])

    def insert(self, place):
        """Puts a vertex at a place, into a triangle or onto an edge; returns it."""
        if place in self.places:
            return self.places.index(place)
        v = len(self.places)
        self.places.append(place)
        for t in sorted(self.triangles):
            signs = [orientation(self.places[t[c]], self.places[t[c - 2]], place) for c in range(3)]
            if min(signs) < 0:
                continue
            if 0 not in signs:
                self.drop(t)
                self.triangles |= {(t[c], t[c - 2], v) for c in range(3)}
                return v
            c = signs.index(0)
            edges = self.edges()
            for a, b in ((t[c], t[c - 2]), (t[c - 2], t[c])):
                if (a, b) in edges:
                    self.drop(edges[a, b])
                    self.triangles |= {(a, v, edges[a, b][2]), (v, b, edges[a, b][2])}
            return v
        raise ValueError("The place is outside of the mesh.")

    def insert_grid_points(self):
        low = [min(p[d] for p in self.places) for d in range(2)]
        high = [max(p[d] for p in self.places) for d in range(2)]
        for b in range(-(-low[1] // UNIT), high[1] // UNIT + 1):
            for a in range(-(-low[0] // UNIT), high[0] // UNIT + 1):
                self.kept.add(self.insert((a * UNIT, b * UNIT)))
        self.make_delaunay()

    def make_delaunay(self):
        """Extraction/DelaunayFlips"""
        flipped = True
        while flipped:
            flipped = False
            edges = self.edges()
            for (a, b), (_, _, c) in sorted(edges.items()):
                if (b, a) not in edges:
                    continue
                d = edges[b, a][2]
                p, q, r, s = (self.places[v] for v in (a, b, c, d))
                if is_in_circle(p, q, r, s) and orientation(s, r, p) > 0 and orientation(r, s, q) > 0:
                    self.drop((a, b, c))
                    self.drop((b, a, d))
                    self.triangles |= {(d, c, a), (c, d, b)}
                    flipped = True
                    break

    def ring(self, v):
        """The neighbours counter-clockwise, and whether v is on the boundary."""
        after = {b: c for (a, b), (_, _, c) in self.edges().items() if a == v}
        first = [b for b in after if b not in after.values()]
        ring = [first[0] if first else min(after)]
        while ring[-1] in after and (len(ring) == 1 or ring[-1] != ring[0]):
            ring.append(after[ring[-1]])
        return (ring, True) if first else (ring[:-1], False)

    def remove(self, v):
        """Another triangulation of the polygon around a vertex, the least quality of whose triangles is as
        large as can be, by dynamic programming (Extraction/VertexRemoval). Returns whether there is one."""
        ring, _ = self.ring(v)
        places, count = [self.places[w] for w in ring], len(ring)
        best, choice = {}, {}
        for length in range(1, count):
            for i in range(count - length):
                j = i + length
                best[i, j] = float("inf") if length == 1 else -1.0
                for k in range(i + 1, j):
                    q = min(best[i, k], best[k, j], quality(places[i], places[k], places[j]))
                    if q > best[i, j]:
                        best[i, j], choice[i, j] = q, k
        if best[0, count - 1] <= 0:
            return False
        for t in [t for t in self.triangles if v in t]:
            self.triangles.discard(t)
        open_ = [(0, count - 1)]
        while open_:
            i, j = open_.pop()
            if j - i > 1:
                k = choice[i, j]
                self.triangles.add((ring[i], ring[k], ring[j]))
                open_ += [(i, k), (k, j)]
        self.make_delaunay()
        return True

    def remove_all(self):
        """Returns how many vertices that are not kept are left."""
        used = {v for t in self.triangles for v in t}
        left = sorted(used - self.kept)
        before = None
        while left and len(left) != before:
            before = len(left)
            left = [v for v in left if not self.remove(v)]
        return len(left)

    def squares(self):
        """The pairs of triangles that are halves of a unit square (Extraction/Pairing)."""
        edges, joined, faces = self.edges(), set(), []
        for (a, b), t in sorted(edges.items()):
            if a > b or (b, a) not in edges:
                continue
            other = edges[b, a]
            p, q, r, s = (self.places[v] for v in (a, b, t[2], other[2]))
            is_diagonal = abs(p[0] - q[0]) == abs(p[1] - q[1]) == UNIT
            is_square = is_diagonal and all(p[d] + q[d] == r[d] + s[d] for d in range(2))
            if is_square and not {frozenset(t), frozenset(other)} & joined:
                joined |= {frozenset(t), frozenset(other)}
                faces.append((a, other[2], b, t[2]))
        return faces


def example():
    """The map of a flat patch: a rectangle of six by four cells with vertices here and there."""
    columns, rows, places, triangles = 5, 4, [], []
    width, height = 6 * UNIT, 4 * UNIT
    for r in range(rows + 1):
        for k in range(columns + 1):
            x, y = width * k // columns, height * r // rows
            if 0 < k < columns:
                x += (197 * (k * k + 3 * r) + 61 * r * r) % 501 - 250
            if 0 < r < rows:
                y += (149 * (r + 2 * k * k) + 83 * k * r) % 501 - 250
            places.append((x, y))
    for r in range(rows):
        for k in range(columns):
            v = r * (columns + 1) + k
            up = v + columns + 1
            triangles += [(v, v + 1, up + 1), (v, up + 1, up)]
    return ExtractionMesh(places, triangles)
