# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The integer-grid map of Remeshing.md for small closed surfaces without features, in plain Python: charts,
cut graph, cones, variables and energy; integers.py has the equations and the rounding.
"""

import cmath
import heapq
import math

from integers import Elimination, Sum, cholesky, covariance, round_greedily, solve
from method import PI, corner_angle, triangle_area


# --- The grid Z[zeta], zeta = exp(2 pi i / n) ----------------------------------------------------------


def turned(point, k, n):
    """zeta^k times a + b zeta, as the pair (a, b); the pairs may hold numbers or Sums."""
    a, b = point
    for _ in range(k % n):
        a, b = (-b, a) if n == 4 else (-b, a + b)
    return a, b


def place(point, n):
    return complex(*point) if n == 4 else complex(point[0] + 0.5 * point[1], math.sqrt(0.75) * point[1])


def coordinates(z, n):
    b = z.imag if n == 4 else z.imag / math.sqrt(0.75)
    return (z.real, b) if n == 4 else (z.real - 0.5 * b, b)


def add(p, q):
    return p[0] + q[0], p[1] + q[1]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


# --- Charts and their matching (Charts/FieldMatching) ---------------------------------------------------


class Matching:
    """The angle of direction 0 at each vertex; m and the remainder of each half-edge; triangles' indices."""

    def __init__(self, mesh, connection, n, u):
        self.n, self.angle = n, [cmath.phase(value) / n for value in u]
        self.m, self.remainder = [0] * len(mesh.corners), [0.0] * len(mesh.corners)
        for h, twin in enumerate(mesh.twin):
            if h < twin:
                tail, head = mesh.tail(h), mesh.head(h)
                at_tail = connection.edge_angle[h] - self.angle[tail]
                at_head = connection.edge_angle[twin] + PI - self.angle[head]
                m = round((at_tail - at_head) * n / (2 * PI))
                self.remainder[h] = at_tail - at_head - 2 * PI * m / n
                self.m[h], self.m[twin] = m % n, -m % n
                self.remainder[twin] = -self.remainder[h]
        self.index = [
            round((connection.curvature[t] + sum(self.remainder[3 * t : 3 * t + 3])) * n / (2 * PI))
            for t in range(len(mesh.triangles))
        ]


class Transition:
    """z -> zeta^turn z + the sum over jumps T of (a + b zeta) T, kept as shift[T] = (a, b)."""

    def __init__(self, n, turn=0, shift=()):
        self.n, self.turn, self.shift = n, turn % n, dict(shift)

    def after(self, first):
        shift = dict(self.shift)
        for jump, factor in first.shift.items():
            shift[jump] = add(shift.get(jump, (0, 0)), turned(factor, self.turn, self.n))
        kept = {jump: factor for jump, factor in shift.items() if factor != (0, 0)}
        return Transition(self.n, self.turn + first.turn, kept)

    def inverse(self):
        factors = {j: turned((-f[0], -f[1]), -self.turn, self.n) for j, f in self.shift.items()}
        return Transition(self.n, -self.turn, factors)

    def apply(self, point, jumps):
        """To a point as a pair of Sums or numbers; jumps are pairs of the same kind."""
        result = turned(point, self.turn, self.n)
        for jump, (a, b) in self.shift.items():
            for factor, base in ((a, jumps[jump]), (b, turned(jumps[jump], 1, self.n))):
                if factor != 0:
                    scaled = [x.times(factor) if isinstance(x, Sum) else factor * x for x in base]
                    result = add(result, scaled)
        return result


# --- The cut graph (Charts/CutGraph) ---------------------------------------------------------------------


class JoinedSets:
    def __init__(self, count):
        self.parent = list(range(count))

    def find(self, a):
        while self.parent[a] != a:
            a = self.parent[a]
        return a

    def join(self, a, b):
        a, b = self.find(a), self.find(b)
        self.parent[max(a, b)] = min(a, b)
        return a != b


class CutGraph:
    """Paths over the triangles between the singular ones and around handles, one unknown jump each."""

    def __init__(self, mesh, matching):
        self.mesh, self.matching = mesh, matching
        self.jumps = [Transition(matching.n) for _ in mesh.corners]
        self.paths, self.seed = [], None
        self._spread()
        crossed, links = set(), []
        for h, twin in enumerate(mesh.twin):
            if h > twin:
                continue
            if self.parent[h // 3] == h or self.parent[twin // 3] == twin:
                crossed.add(h)
            elif self.region[h // 3] != self.region[twin // 3]:
                length = self.distance[h // 3] + self.step(h) + self.distance[twin // 3] + self.step(twin)
                links.append((length, h))
        regions = JoinedSets(self.sources)
        for _, h in sorted(links):
            if regions.join(self.region[h // 3], self.region[mesh.twin[h] // 3]):
                crossed.add(h)
                self._add_path(h)
        vertices = JoinedSets(len(mesh.points))
        around = [
            h
            for h, twin in enumerate(mesh.twin)
            if h < twin and h not in crossed and not vertices.join(mesh.tail(h), mesh.head(h))
        ]
        self.loops = len(around)
        for h in around:
            self._add_path(h)

    def step(self, h):
        """From the middle of an edge to the middle of the triangle."""
        mesh = self.mesh
        squares = [mesh.squared_length(x) for x in (h, mesh.next(h), mesh.previous(h))]
        return math.sqrt(max(0.0, 2 * (squares[1] + squares[2]) - squares[0])) / 6

    def _spread(self):
        count = len(self.mesh.triangles)
        self.distance, self.region = [math.inf] * count, [None] * count
        self.parent = [None] * count
        singular = [t for t in range(count) if self.matching.index[t] != 0]
        if not singular:
            self.seed = 0
            singular = [0]
        self.sources, front = len(singular), []
        for source, t in enumerate(singular):
            self.distance[t], self.region[t] = 0.0, source
            front.append((0.0, t))
        while front:
            distance, t = heapq.heappop(front)
            if distance > self.distance[t]:
                continue
            for h in range(3 * t, 3 * t + 3):
                twin = self.mesh.twin[h]
                reached = distance + self.step(h) + self.step(twin)
                if reached < self.distance[twin // 3]:
                    self.distance[twin // 3], self.parent[twin // 3] = reached, twin
                    self.region[twin // 3] = self.region[t]
                    heapq.heappush(front, (reached, twin // 3))

    def _to_source(self, t):
        parents = []
        while self.parent[t] is not None:
            parents.append(self.parent[t])
            t = self.mesh.twin[parents[-1]] // 3
        return parents

    def _add_path(self, h):
        """The jump is T where the path begins, and zeta^exponent T after each triangle."""
        mesh, n = self.mesh, self.matching.n
        path = [(parent, True) for parent in reversed(self._to_source(h // 3))] + [(h, False)]
        path += [(parent, False) for parent in self._to_source(mesh.twin[h] // 3)]
        exponent, left, variable = 0, None, len(self.paths)
        for half, inwards in path:
            new = mesh.tail(half) if inwards else mesh.head(half)
            if left is not None and new != left:
                inside = mesh.twin[half] if inwards else half
                third = mesh.next(inside)
                if mesh.tail(third) != new:
                    third = mesh.previous(inside)
                m = self.matching.m[third]
                exponent -= m if mesh.tail(third) == left else -m
            left = new
            # The edge as it runs from the left end of the path to its right one.
            across = half if mesh.tail(half) == left else mesh.twin[half]
            jump = Transition(n, self.matching.m[across], {variable: turned((1, 0), exponent, n)})
            back = jump.inverse()
            for edge, added in ((across, jump), (mesh.twin[across], back)):
                sum_ = dict(self.jumps[edge].shift)
                for key, factor in added.shift.items():
                    sum_[key] = add(sum_.get(key, (0, 0)), factor)
                self.jumps[edge] = Transition(n, 0, sum_)
        self.paths.append([half for half, _ in path])

    def along(self, h):
        """From the chart of a half-edge's head to that of its tail."""
        return Transition(self.matching.n, self.matching.m[h], self.jumps[h].shift)


# --- A vertex in each cone, and a chart for every triangle (Charts/CutMesh) ---------------------------


class MapTriangle:
    def __init__(self, vertex, corner, target, weight, twin):
        self.vertex, self.corner, self.target, self.weight = vertex, corner, target, weight
        self.twin = twin


def half_cotangent(angle):
    return 0.5 * max(-20.0, min(20.0, 1 / math.tan(angle)))


class CutMesh:
    def __init__(self, mesh, connection, matching, graph, u):
        self.mesh, self.connection, self.matching, self.graph = mesh, connection, matching, graph
        self.n = matching.n
        self.positions = [tuple(p) for p in mesh.points]
        self.triangles = [None] * len(mesh.triangles)
        self.cones, self.image = [], [None] * len(mesh.corners)
        for t in range(len(mesh.triangles)):
            if matching.index[t] != 0 or t == graph.seed:
                self._add_cone(t, u)
            else:
                self._add_regular(t)
        for h, twin in enumerate(mesh.twin):
            self.triangles[self.image[h] // 3].twin[self.image[h] % 3] = self.image[twin]

    def angle_at_tail(self, h):
        return self.connection.edge_angle[h] - self.matching.angle[self.mesh.tail(h)]

    def _edge_target(self, h):
        """Of a half-edge in the chart of its tail: half of what differs goes to each end."""
        length = math.sqrt(self.mesh.squared_length(h))
        return cmath.rect(length, self.angle_at_tail(h) - 0.5 * self.matching.remainder[h])

    def _add_regular(self, t):
        n, hs = self.n, range(3 * t, 3 * t + 3)
        corner = [Transition(n), self.graph.along(3 * t), self.graph.along(3 * t + 2).inverse()]
        target = [
            self._edge_target(h) * cmath.exp(2j * PI * corner[c].turn / n) for c, h in enumerate(hs)
        ]
        weight = [half_cotangent(corner_angle(self.mesh, self.mesh.previous(h))) for h in hs]
        for c, h in enumerate(hs):
            self.image[h] = h
        vertices = list(self.mesh.triangles[t])
        self.triangles[t] = MapTriangle(vertices, corner, target, weight, [None] * 3)

    def zero_of(self, t, u):
        """Weights of the corners where the linear interpolant vanishes, at least 0.12 each."""
        value, phase = [], 0.0
        for h in range(3 * t, 3 * t + 3):
            value.append(cmath.rect(abs(u[self.mesh.tail(h)]), phase))
            phase += self.n * self.matching.remainder[h]
        weight = [(value[c - 2].conjugate() * value[c - 1]).imag for c in range(3)]
        total = sum(weight)
        weight = [max(0.12, w / total) for w in weight] if total != 0 else [1.0] * 3
        return [w / sum(weight) for w in weight]

    def _add_cone(self, t, u):
        mesh, n = self.mesh, self.n
        weight = self.zero_of(t, u)
        squared = [mesh.squared_length(h) for h in range(3 * t, 3 * t + 3)]
        base = math.sqrt(squared[0])
        flat = [0j, base + 0j]
        flat.append(
            complex(0.5 * (squared[0] + squared[2] - squared[1]) / base, 2 * triangle_area(squared) / base)
        )
        middle = sum(w * z for w, z in zip(weight, flat))
        cone, extra = len(self.positions), len(self.triangles)
        number = [t, extra, extra + 1]
        self.triangles += [None, None]
        spoke = []
        for c in range(3):
            away = middle - flat[c]
            inside = cmath.phase(away / (flat[c - 2] - flat[c]))
            scale = self.connection.scale[mesh.tail(3 * t + c)]
            spoke.append(cmath.rect(abs(away), self.angle_at_tail(3 * t + c) + scale * inside))

        def weight_at(p, q, r):
            return half_cotangent(abs(cmath.phase((r - p) / (q - p))))

        back = Transition(n)
        for c in range(3):
            h, after = 3 * t + c, (c + 1) % 3
            ring = self.graph.along(h)
            target = [-spoke[c], self._edge_target(h), spoke[after] * cmath.exp(2j * PI * ring.turn / n)]
            p, q = flat[c], flat[after]
            weights = [weight_at(q, middle, p), weight_at(middle, p, q), weight_at(p, q, middle)]
            twin = [3 * number[c - 1] + 2, None, 3 * number[after]]
            corner = [back.inverse(), Transition(n), ring]
            vertex = [cone, mesh.tail(h), mesh.head(h)]
            self.triangles[number[c]] = MapTriangle(vertex, corner, target, weights, twin)
            self.image[h] = 3 * number[c] + 1
            back = back.after(ring)
        points = [mesh.points[v] for v in mesh.triangles[t]]
        self.positions.append(tuple(sum(w * p[d] for w, p in zip(weight, points)) for d in range(3)))
        self.cones.append((cone, back))


# --- The map (Parametrization) ----------------------------------------------------------------------------


class Variables:
    """Two coordinates of each vertex, of each cone, of each jump (Parametrization/ParametrizationVariables)."""

    def __init__(self, cut):
        self.cut, self.vertices = cut, len(cut.positions)
        cones = {v for v, _ in cut.cones}
        flags = [1 if v in cones else 0 for v in range(self.vertices) for _ in range(2)]
        self.solved = Elimination(flags + [1] * 2 * len(cut.graph.paths))
        self.jumps = [self.pair(self.vertices + j) for j in range(len(cut.graph.paths))]
        for sum_ in self.pair(cut.cones[0][0]):
            self.solved.require(sum_)
        for v, holonomy in cut.cones:
            for sum_ in minus(holonomy.apply(self.pair(v), self.jumps), self.pair(v)):
                self.solved.require(sum_)

    @staticmethod
    def pair(k):
        return Sum({2 * k: 1}), Sum({2 * k + 1: 1})

    def corner(self, t, c):
        triangle = self.cut.triangles[t]
        return triangle.corner[c].apply(self.pair(triangle.vertex[c]), self.jumps)


class Energy:
    """x^T K x - 2 b^T x over the free variables (Parametrization/ParametrizationEnergy)."""

    def __init__(self, variables, h):
        cut, solved = variables.cut, variables.solved
        self.free = solved.free()
        self.reals = sum(1 for v in self.free if not solved.integer[v])
        slot = {v: k for k, v in enumerate(self.free)}
        size, mixed = len(self.free), 0.0 if cut.n == 4 else 0.5
        self.matrix, self.side = [[0.0] * size for _ in range(size)], [0.0] * size
        for t, triangle in enumerate(cut.triangles):
            for c, twin in enumerate(triangle.twin):
                if twin < 3 * t + c:
                    continue
                weight = max(0.05, triangle.weight[c] + cut.triangles[twin // 3].weight[twin % 3])
                difference = minus(variables.corner(t, (c + 1) % 3), variables.corner(t, c))
                sums = [solved.resolve(s) for s in difference]
                target = coordinates(triangle.target[c] / h, cut.n)
                # |a + b zeta|^2 = a^2 + b^2 + 2 Re(zeta) a b
                for i in range(2):
                    for v, p in sums[i].items():
                        self.side[slot[v]] += weight * p * (target[i] + mixed * target[1 - i])
                        for j in range(2):
                            factor = weight * p * (1.0 if i == j else mixed)
                            for w, q in sums[j].items():
                                self.matrix[slot[v]][slot[w]] += factor * q


UNIT = 1 << 18


class GridMap:
    """The map with all integers as given, in exact numbers (Parametrization/IntegerGridMap)."""

    def __init__(self, mesh, connection, n, u, h):
        self.matching = Matching(mesh, connection, n, u)
        self.graph = CutGraph(mesh, self.matching)
        self.cut = CutMesh(mesh, connection, self.matching, self.graph, u)
        self.variables = Variables(self.cut)
        self.energy = Energy(self.variables, h)
        self.factor = cholesky(self.energy.matrix)
        self.relaxed = solve(self.factor, self.energy.side)
        reals = self.energy.reals
        self.covariance = covariance(self.factor, reals)
        self.integers = round_greedily(self.covariance, self.relaxed[reals:])
        self.rounded = self.with_integers(self.integers)

    def with_integers(self, integers):
        """The least energy among the maps with these integers."""
        reals, matrix = self.energy.reals, self.energy.matrix
        side = [
            b - sum(a * y for a, y in zip(matrix[i][reals:], integers))
            for i, b in enumerate(self.energy.side[:reals])
        ]
        factor = [row[:reals] for row in self.factor[:reals]]
        return solve(factor, side) + list(integers)

    def energy_at(self, x):
        product = [sum(a * y for a, y in zip(row, x)) for row in self.energy.matrix]
        return sum(y * (p - 2 * b) for y, p, b in zip(x, product, self.energy.side))

    def exact(self, x):
        """All variables in multiples of 1 / UNIT; what depends on integers only is exact whatever x is."""
        solved, value = self.variables.solved, {}
        for v, y in zip(self.energy.free, x):
            value[v] = round(y) * UNIT if solved.integer[v] else round(y * UNIT)
        for v in range(len(solved.integer)):
            if v in solved.dependent:
                value[v] = sum(c * value[w] for w, c in solved.resolve(Sum({v: 1})).items())
        return value

    def corners(self, value):
        """The coordinates of each corner in its triangle's chart, and the jumps."""
        pairs = [(value[2 * k], value[2 * k + 1]) for k in range(self.variables.vertices)]
        first = 2 * self.variables.vertices
        jumps = [(value[first + 2 * j], value[first + 2 * j + 1]) for j in range(len(self.graph.paths))]
        corners = [
            [triangle.corner[c].apply(pairs[triangle.vertex[c]], jumps) for c in range(3)]
            for triangle in self.cut.triangles
        ]
        return corners, jumps
