# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The method of this folder's pages on small meshes, in plain Python: nothing here is fast, and every
function stands beside its formula in the pages. check.py checks the formulas by numbers, and pictures.py
draws the pictures with it.
"""

import cmath
import math

PI = math.pi


# --- Connection.md: the mesh and its connection ----------------------------------------------------


def distance(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def scalar(a, b):
    return sum(x * y for x, y in zip(a, b))


def normalized(a):
    size = math.sqrt(scalar(a, a))
    return tuple(x / size for x in a)


class Mesh:
    """Half-edge 3 t + c runs from corner c of triangle t to corner c + 1 (Mesh/TriangleMesh)."""

    def __init__(self, points, triangles):
        self.points = points
        self.triangles = triangles
        self.corners = [v for triangle in triangles for v in triangle]
        ends = {(self.tail(h), self.head(h)): h for h in range(len(self.corners))}
        self.twin = [ends.get((self.head(h), self.tail(h))) for h in range(len(self.corners))]
        self.outgoing = [None] * len(points)
        for h in range(len(self.corners)):
            v = self.tail(h)
            if self.outgoing[v] is None or self.twin[h] is None:
                self.outgoing[v] = h

    @staticmethod
    def next(h):
        return h - 2 if h % 3 == 2 else h + 1

    @staticmethod
    def previous(h):
        return h + 2 if h % 3 == 0 else h - 1

    def tail(self, h):
        return self.corners[h]

    def head(self, h):
        return self.corners[self.next(h)]

    def is_boundary(self, v):
        return self.twin[self.outgoing[v]] is None

    def fan(self, v):
        """The outgoing half-edges counter-clockwise, on the boundary from the first one on."""
        fan, h = [], self.outgoing[v]
        while h is not None and h not in fan:
            fan.append(h)
            h = self.twin[self.previous(h)]
        return fan

    def squared_length(self, h):
        return sum((a - b) ** 2 for a, b in zip(self.points[self.head(h)], self.points[self.tail(h)]))


def triangle_area(squared):
    a, b, c = squared
    return 0.25 * math.sqrt(max(0.0, 2 * (a * b + b * c + c * a) - a * a - b * b - c * c))


def corner_angle(mesh, h):
    out, across = mesh.squared_length(h), mesh.squared_length(mesh.next(h))
    back = mesh.squared_length(mesh.previous(h))
    return math.acos((out + back - across) / (2 * math.sqrt(out * back)))


class Connection:
    """theta, s, rho and the curvature of triangles (Geometry/Connection)."""

    def __init__(self, mesh):
        count = len(mesh.corners)
        self.scale, self.angle_sum = [], []
        self.edge_angle, self.corner = [0.0] * count, [0.0] * count
        for v in range(len(mesh.points)):
            fan = mesh.fan(v)
            boundary = mesh.is_boundary(v)
            total = sum(corner_angle(mesh, h) for h in fan)
            scale = 1.0 if boundary else 2 * PI / total
            if not boundary:
                reference = min(range(len(fan)), key=lambda k: mesh.points[mesh.head(fan[k])])
                fan = fan[reference:] + fan[:reference]
            theta = 0.0
            for h in fan:
                self.edge_angle[h] = theta
                self.corner[h] = scale * corner_angle(mesh, h)
                theta += self.corner[h]
            self.scale.append(scale)
            self.angle_sum.append(total if boundary else 2 * PI)
        self.rotation = [self._rotation(mesh, h) for h in range(count)]
        self.curvature = [sum(self.corner[3 * t : 3 * t + 3]) - PI for t in range(count // 3)]

    def _rotation(self, mesh, h):
        """rho of a half-edge: that of its edge, whose direction is that of one of the two."""
        twin = mesh.twin[h]
        if twin is not None and twin < h:
            return -self._rotation(mesh, twin)
        back = self.angle_sum[mesh.head(h)] if twin is None else self.edge_angle[twin]
        return back + PI - self.edge_angle[h]

    def transport(self, h, n):
        """r of a half-edge for a field of degree n."""
        return cmath.exp(1j * n * self.rotation[h])


def frames(mesh, connection):
    """Unit normals weighted by angle, and the tangent vectors of angle 0 (Geometry/TangentFrames)."""
    result = []
    for v, p in enumerate(mesh.points):
        fan = mesh.fan(v)
        edges = [tuple(a - b for a, b in zip(mesh.points[mesh.head(h)], p)) for h in fan]
        normal = [0.0, 0.0, 0.0]
        for k, h in enumerate(fan):
            unit = normalized(cross(edges[k], edges[(k + 1) % len(edges)]))
            normal = [a + connection.corner[h] * b for a, b in zip(normal, unit)]
        normal = normalized(normal)
        axis = cross(normal, min(((1, 0, 0), (0, 1, 0), (0, 0, 1)), key=lambda e: abs(scalar(e, normal))))
        a = normalized(axis)
        b = cross(normal, a)
        fit = 0.0
        for h, edge in zip(fan, edges):
            z = complex(scalar(edge, a), scalar(edge, b))
            fit += z / abs(z) * cmath.exp(-1j * connection.edge_angle[h])
        fit /= abs(fit)
        x = tuple(fit.real * c + fit.imag * d for c, d in zip(a, b))
        result.append((normal, x, cross(normal, x)))
    return result


# --- Energy.md: the integrals over a triangle and the matrices ---------------------------------------


def section_integrals(omega):
    """E4, F1 and F2 (Sections/SectionIntegrals)."""
    z = 1j * omega
    if abs(omega) < 2.0:
        term = [z**m / math.factorial(m + 4) for m in range(20)]
        e4 = sum(term)
        f1 = -z / 24 - sum((m + 1) * (m + 2) / 2 * term[m] for m in range(2, 20))
        f2 = -0.25 - z / 24 - sum((m + 2) ** 2 * term[m] for m in range(2, 20))
        return e4, f1, f2
    e, o = cmath.exp(z), omega
    e4 = (e - 1 - z - z**2 / 2 - z**3 / 6) / z**4
    f1 = (3 + z + o**4 / 24 - 1j * o**5 / 60 + (-3 + 2 * z + o**2 / 2) * e) / o**4
    f2 = (4 + z - 1j * o**3 / 6 - o**4 / 12 + 1j * o**5 / 30 + (-4 + 3 * z + o**2) * e) / o**4
    return e4, f1, f2


def local_integrals(squared, area, omega, bias):
    """Energy and mass of hat sections over a triangle, before transport: the diagonal entries, and those
    of the row of corner c and the column of corner c + 1. squared[c] belongs to that edge."""
    e4, f1, f2 = section_integrals(omega)

    def dot(c):
        return 0.5 * (squared[c] + squared[c - 1] - squared[(c + 1) % 3])

    diagonal, energy = [], []
    for c in range(3):
        after, before = (c + 1) % 3, (c + 2) % 3
        spread = squared[c] + dot(c) + squared[before]
        diagonal.append((squared[after] + omega**2 * spread / 90) / (4 * area) - bias * omega / 6)
        dirichlet = ((squared[after] + squared[before]) * f1 + dot(before) * f2) / area
        energy.append(dirichlet - bias * (2 * omega * e4 - 0.5j))
    return diagonal, energy, area / 6, 2 * area * e4


def operators(mesh, connection, n, bias=0.0):
    """A and M, a dictionary of columns for each row (Sections/Assembly)."""
    energy = [{} for _ in mesh.points]
    mass = [{} for _ in mesh.points]

    def add(matrix, row, column, value):
        matrix[row][column] = matrix[row].get(column, 0.0) + value

    for t in range(len(mesh.triangles)):
        squared = [mesh.squared_length(3 * t + c) for c in range(3)]
        omega = n * connection.curvature[t]
        diagonal, local, m_diagonal, m = local_integrals(squared, triangle_area(squared), omega, bias)
        for c in range(3):
            j, k = mesh.tail(3 * t + c), mesh.head(3 * t + c)
            r = connection.transport(3 * t + c, n)
            add(energy, j, j, diagonal[c])
            add(mass, j, j, m_diagonal)
            for matrix, value in ((energy, local[c]), (mass, m)):
                add(matrix, j, k, r.conjugate() * value)
                add(matrix, k, j, r * value.conjugate())
    return energy, mass


def times(matrix, u):
    return [sum(value * u[column] for column, value in row.items()) for row in matrix]


def dot(u, v):
    return sum(a.conjugate() * b for a, b in zip(u, v))


# --- Solvers.md: an eigensolver for small matrices -----------------------------------------------------


class Factor:
    """L D L^* of a Hermitian positive definite matrix a A + m M."""

    def __init__(self, energy, mass, a, m):
        n = len(energy)
        self.rows = []
        self.pivots = []
        for i in range(n):
            row = [a * energy[i].get(j, 0.0) + m * mass[i].get(j, 0.0) for j in range(i + 1)]
            for j in range(i):
                other, upper = self.rows[j], row[j]
                for k in range(j):
                    upper -= row[k] * other[k].conjugate()
                row[j] = upper
            scaled = [row[j] / self.pivots[j] for j in range(i)]
            self.pivots.append((row[i] - sum(x * y.conjugate() for x, y in zip(row, scaled))).real)
            if not self.pivots[-1] > 0.0:
                raise ValueError("The matrix is not positive definite.")
            self.rows.append(scaled)

    def solve(self, b):
        x = list(b)
        for i, row in enumerate(self.rows):
            x[i] -= sum(row[k] * x[k] for k in range(i))
        x = [value / pivot for value, pivot in zip(x, self.pivots)]
        for i in range(len(x) - 1, -1, -1):
            for k, value in enumerate(self.rows[i]):
                x[k] -= value.conjugate() * x[i]
        return x


def smallest_pairs(energy, mass, count, steps=60):
    """Inverse iteration with a block that is kept orthonormal in M; the values ascend."""
    trace = sum(energy[i][i].real / mass[i][i].real for i in range(len(energy))) / len(energy)
    factor = Factor(energy, mass, 1.0, 1e-4 * trace)
    block = [
        [cmath.exp(1j * (2.4 * v * (b + 1) + 0.7 * b)) for v in range(len(energy))] for b in range(count)
    ]
    for _ in range(steps):
        for b in range(count):
            u = factor.solve(times(mass, block[b]))
            for other in block[:b] * 2:
                along = dot(times(mass, other), u)
                u = [x - along * y for x, y in zip(u, other)]
            size = math.sqrt(dot(u, times(mass, u)).real)
            block[b] = [x / size for x in u]
    return [(dot(u, times(energy, u)).real, u) for u in block]


def smallest_eigenpair(energy, mass, steps=60):
    return smallest_pairs(energy, mass, 1, steps)[0]


# --- Singularities.md --------------------------------------------------------------------------------


def edge_rotations(mesh, connection, n, u):
    """omega of each half-edge in (-pi, pi], the negative for the other half-edge of its edge."""
    omega = [0.0] * len(mesh.corners)
    for h in range(len(mesh.corners)):
        twin = mesh.twin[h]
        if twin is None or h < twin:
            there, here = u[mesh.head(h)], u[mesh.tail(h)]
            omega[h] = cmath.phase(there / (connection.transport(h, n) * here))
            if twin is not None:
                omega[twin] = -omega[h]
    return omega


def singularity_indices(mesh, connection, n, u):
    omega = edge_rotations(mesh, connection, n, u)
    return [
        round((sum(omega[3 * t : 3 * t + 3]) + n * connection.curvature[t]) / (2 * PI))
        for t in range(len(mesh.triangles))
    ]


# --- Alignment.md --------------------------------------------------------------------------------------


def constrained(mesh, connection, n, given):
    """K_ff u_f = -K_fc u_c: the smoothest section with given values."""
    energy, _ = operators(mesh, connection, n)
    free = [v for v in range(len(mesh.points)) if v not in given]
    number = {v: k for k, v in enumerate(free)}
    inner = [{number[w]: a for w, a in energy[v].items() if w in number} for v in free]
    right = [-sum(a * given[w] for w, a in energy[v].items() if w in given) for v in free]
    solution = Factor(inner, inner, 1.0, 0.0).solve(right)
    return [given[v] if v in given else solution[number[v]] for v in range(len(mesh.points))]


# --- Solvers.md, once more ------------------------------------------------------------------------------


def aggregates(energy, mass):
    """Multigrid/Aggregation on the finest level; returns the strengths, too."""
    n = len(energy)
    strength = [{} for _ in range(n)]
    for i in range(n):
        for j, a in energy[i].items():
            if j != i:
                along = (a * (mass[i][j] / abs(mass[i][j])).conjugate()).real
                bound = 0.08**2 * energy[i][i].real * energy[j][j].real
                if along < 0 and along * along > bound:
                    strength[i][j] = -along
    group = [None] * n
    count = 0
    for root in range(n):
        if group[root] is None and strength[root] and all(group[j] is None for j in strength[root]):
            for j in [root] + list(strength[root]):
                group[j] = count
            count += 1
    before = list(group)
    for number in (before, group):
        for v in range(n):
            if group[v] is None:
                near = [(s, j) for j, s in strength[v].items() if number[j] is not None]
                if near:
                    group[v] = number[max(near)[1]]
                elif number is group:
                    group[v] = count
                    count += 1
    return group, count, strength
