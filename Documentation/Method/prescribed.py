# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""PrescribedSingularities.md for small closed meshes: the rotation of least energy with given indices, in terms
of angles at the vertices.
"""

import cmath
import math

from integers import cholesky, solve
from method import PI, corner_angle, edge_rotations, singularity_indices
from remeshing import JoinedSets


class Forms:
    """Numbers along edges, kept at the half-edge whose twin has the larger number (TrivialConnection/DiscreteForms)."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.edges = [h for h, twin in enumerate(mesh.twin) if h < twin]
        self.number = {}
        for e, h in enumerate(self.edges):
            self.number[h], self.number[mesh.twin[h]] = (e, 1), (e, -1)
        self.weight = [
            sum(0.5 / math.tan(corner_angle(mesh, mesh.previous(side))) for side in (h, mesh.twin[h]))
            for h in self.edges
        ]

    def along(self, form, h):
        e, sign = self.number[h]
        return sign * form[e]

    def around(self, form, t):
        return sum(self.along(form, h) for h in range(3 * t, 3 * t + 3))

    def product(self, a, b):
        return sum(w * x * y for w, x, y in zip(self.weight, a, b))

    def inflow(self, form):
        result = [0.0] * len(self.mesh.points)
        for h, w, x in zip(self.edges, self.weight, form):
            result[self.mesh.head(h)] += w * x
            result[self.mesh.tail(h)] -= w * x
        return result

    def without_rise(self, form, a):
        return [x - a[self.mesh.head(h)] + a[self.mesh.tail(h)] for h, x in zip(self.edges, form)]


class TreeCotree:
    """A tree of the triangles, a tree of the vertices, and the edges in neither (TrivialConnection/TreeCotree)."""

    def __init__(self, forms):
        self.forms, mesh = forms, forms.mesh
        self.order, self.to_root, seen = [0], [None] * len(mesh.triangles), {0}
        for t in self.order:
            for h in range(3 * t, 3 * t + 3):
                other = mesh.twin[h] // 3
                if other not in seen:
                    seen.add(other)
                    self.to_root[other] = mesh.twin[h]
                    self.order.append(other)
        crossed = {forms.number[h][0] for h in self.to_root if h is not None}
        sets, self.up = JoinedSets(len(mesh.points)), {}
        self.generators, tree = [], []
        for e, h in enumerate(forms.edges):
            if e not in crossed:
                is_tree = sets.join(mesh.tail(h), mesh.head(h))
                (tree if is_tree else self.generators).append(e)
        reached, queue = {0}, [0]
        for v in queue:
            for e in tree:
                ends = mesh.tail(forms.edges[e]), mesh.head(forms.edges[e])
                if v in ends:
                    other = ends[0] if ends[1] == v else ends[1]
                    if other not in reached:
                        reached.add(other)
                        self.up[other] = (e, v)
                        queue.append(other)

    def route(self, around):
        """Integers along edges whose sums around the triangles are those given."""
        around, form = list(around), [0] * len(self.forms.edges)
        for t in reversed(self.order):
            h = self.to_root[t]
            if h is not None:
                e, sign = self.forms.number[h]
                form[e] += sign * around[t]
                around[self.forms.mesh.twin[h] // 3] += around[t]
        return form

    def form_of(self, generator):
        """A closed form: 1 on the generator, and what the tree of triangles takes back."""
        form = [0] * len(self.forms.edges)
        form[generator] = 1
        around = [0] * len(self.forms.mesh.triangles)
        h = self.forms.edges[generator]
        around[h // 3], around[self.forms.mesh.twin[h] // 3] = -1, 1
        return [a + b for a, b in zip(form, self.route(around))]

    def loop_of(self, generator):
        """The half-edges of the loop that a generator closes in the tree of vertices."""
        mesh, h = self.forms.mesh, self.forms.edges[generator]

        def path(v):
            vertices = [v]
            while vertices[-1] in self.up:
                vertices.append(self.up[vertices[-1]][1])
            return vertices

        ahead, behind = path(mesh.head(h)), path(mesh.tail(h))
        while len(ahead) > 1 and len(behind) > 1 and ahead[-2] == behind[-2]:
            ahead.pop()
            behind.pop()
        vertices = ahead + behind[-2::-1]
        ends = {(mesh.tail(k), mesh.head(k)): k for k in range(len(mesh.corners))}
        return [h] + [ends[a, b] for a, b in zip(vertices, vertices[1:])]


def turning_number(mesh, connection, n, forms, rotation, loop):
    """How often a field turns against the tangent of a loop, in units of 1/n (TrivialConnection/LoopHolonomies)."""
    total = sum(forms.along(rotation, h) for h in loop)
    for h, following in zip(loop, loop[1:] + loop[:1]):
        turn = connection.edge_angle[following] - connection.edge_angle[mesh.twin[h]] - PI
        total -= n * (turn - 2 * PI * round(turn / (2 * PI)))
    return total / (2 * PI)


def nearest_integers(products, slope):
    """x for which x^T G x / 2 + g^T x is small: rounded, then changed by 1 at a time."""
    x = [float(round(y)) for y in solve(cholesky(products), [-g for g in slope])] if slope else []
    while True:
        gradient = [sum(a * y for a, y in zip(row, x)) + g for row, g in zip(products, slope)]
        gain, j = max(((abs(g) - 0.5 * products[k][k], k) for k, g in enumerate(gradient)), default=(0, 0))
        if gain < 1e-9:
            return x
        x[j] -= math.copysign(1.0, gradient[j])


def rotation_around(flat, weights, index, holonomy):
    """Along the edges of a flat triangle with a singularity in it: its index times the angle under which it sees
    each edge, less a third of the holonomy (TrivialConnection/RotationAtPlace)."""
    most = 0.99 * PI
    weights = [max(w, 0.05) for w in weights]
    place = sum(w * z for w, z in zip(weights, flat)) / sum(weights)
    even = (2 * PI * index - holonomy) / 3
    seen = [cmath.phase((flat[c - 2] - place) / (flat[c] - place)) for c in range(3)]
    rotation, part = [index * s - holonomy / 3 for s in seen], 0.0
    for r in rotation:
        if abs(r) > most:
            part = max(part, (r - math.copysign(most, r)) / (r - even))
    return [r + min(part, 1.0) * (even - r) for r in rotation]


class MergedUnknowns:
    """Values that differ from each other as given are one unknown."""

    def __init__(self, count):
        self.set, self.offset = list(range(count)), [0.0] * count

    def join(self, a, b, difference):
        if self.set[a] == self.set[b]:
            return False
        moved, shift = self.set[b], self.offset[a] + difference - self.offset[b]
        for v, s in enumerate(self.set):
            if s == moved:
                self.set[v], self.offset[v] = self.set[a], self.offset[v] + shift
        return True


class Editor:
    """Fields on a closed mesh whose singularities are prescribed (TrivialConnection/TrivialConnection)."""

    def __init__(self, mesh, connection, n, base):
        self.mesh, self.connection, self.n, self.base = mesh, connection, n, base
        self.forms = Forms(mesh)
        self.tree = TreeCotree(self.forms)
        omega = edge_rotations(mesh, connection, n, base)
        self.omega = [omega[h] for h in self.forms.edges]
        self.indices = singularity_indices(mesh, connection, n, base)

    def solve(self, form, merged=None):
        """L a = the inflow of the form, some of the unknowns being joined; the first one is 0."""
        mesh, forms = self.mesh, self.forms
        merged = merged or MergedUnknowns(len(mesh.points))
        form = forms.without_rise(form, merged.offset)
        names = sorted(set(merged.set))
        number = {name: k for k, name in enumerate(names)}
        size = len(names)
        matrix, side = [[0.0] * size for _ in range(size)], [0.0] * size
        for v, flow in enumerate(forms.inflow(form)):
            side[number[merged.set[v]]] += flow
        for h, w in zip(forms.edges, forms.weight):
            i, j = (number[merged.set[v]] for v in (mesh.tail(h), mesh.head(h)))
            if i != j:
                matrix[i][i] += w
                matrix[j][j] += w
                matrix[i][j] -= w
                matrix[j][i] -= w
        values = [0.0] + solve(cholesky([row[1:] for row in matrix[1:]]), side[1:])
        return [values[number[s]] + o for s, o in zip(merged.set, merged.offset)]

    def flat(self, t):
        squared = [self.mesh.squared_length(h) for h in range(3 * t, 3 * t + 3)]
        base = math.sqrt(squared[0])
        x = 0.5 * (squared[0] + squared[2] - squared[1]) / base
        return [0j, base + 0j, complex(x, math.sqrt(max(0.0, squared[2] - x * x)))]

    def turn(self, indices, places=None, keeps=False):
        """The turn a of each vertex and the rotation w. Where the places of singularities are given, as weights, the
        rotation around them is set."""
        jumps = self.tree.route([k - j for k, j in zip(indices, self.indices)])
        form = [2 * PI * p + (0.0 if keeps else o) for p, o in zip(jumps, self.omega)]
        a = self.solve(form)
        closed = [self.tree.form_of(g) for g in self.tree.generators]
        rises = [self.solve(z) for z in closed]
        harmonic = [self.forms.without_rise(z, b) for z, b in zip(closed, rises)]
        products = [[self.forms.product(x, y) for y in harmonic] for x in harmonic]
        rotation = self.forms.without_rise(form, a)
        slope = [self.forms.product(z, rotation) / (2 * PI) for z in closed]
        for z, x in zip(closed, nearest_integers(products, slope)):
            form = [f + 2 * PI * x * y for f, y in zip(form, z)]
        whole = [f + (o if keeps else 0.0) for f, o in zip(form, self.omega)]
        merged = MergedUnknowns(len(self.mesh.points))
        for t, weights in (places or {}).items():
            holonomy = self.n * self.connection.curvature[t]
            around = rotation_around(self.flat(t), weights, indices[t], holonomy)
            corners = self.mesh.triangles[t]
            if len({merged.set[v] for v in corners}) == 3:
                for c in range(2):
                    wanted = self.forms.along(whole, 3 * t + c) - around[c]
                    merged.join(corners[c], corners[c + 1], wanted)
        a = self.solve(form, merged)
        return a, self.forms.without_rise(whole, a)

    def section(self, a):
        return [u / abs(u) * cmath.exp(-1j * x) for u, x in zip(self.base, a)]
