# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The method of this folder's pages on small meshes, in plain Python: nothing here is fast, and every
function stands beside its formula in the pages. The pictures are drawn with it.

    python3 Documentation/Method/method.py

checks the formulas of the pages by numbers and ends with an error where one does not hold.
"""

import cmath
import math

PI = math.pi


# --- Connection.md: the mesh and its connection ----------------------------------------------------


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


# --- Small meshes ------------------------------------------------------------------------------------


def icosphere(levels):
    g = (1 + math.sqrt(5)) / 2
    points = [(s * a, t * b * g, 0.0) for a in (1,) for b in (1,) for s in (-1, 1) for t in (-1, 1)]
    points = [p[k:] + p[:k] for k in (0, 2, 1) for p in points]
    points = [tuple(x / math.sqrt(1 + g * g) for x in p) for p in points]
    edge = min(distance(points[0], p) for p in points[1:])
    near = [[w for w in range(12) if w != v and distance(points[v], points[w]) < 1.1 * edge] for v in range(12)]
    triangles = []
    for a in range(12):
        for b in near[a]:
            for c in near[a]:
                if a < b and a < c and c in near[b] and determinant(points[a], points[b], points[c]) > 0:
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
        return 1 + amount * (0.6 * math.sin(2.3 * p[0] + 0.4) * p[1] + 0.5 * p[2] * p[2] * p[0] + 0.4 * p[1] * p[2])

    return Mesh([tuple(factor(p) * x for x in p) for p in mesh.points], mesh.triangles)


def distance(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)))


def determinant(a, b, c):
    return (
        a[0] * (b[1] * c[2] - b[2] * c[1])
        - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
    )


# --- Checks ------------------------------------------------------------------------------------------


def quadrature(points, omega, bias):
    """The same as local_integrals, for a triangle in the plane that carries the curvature omega, by
    Gauss' rule. The section of corner c is its hat function times a unit section that is parallel along
    the rays from c: in the gauge of that unit section the connection at x is the form
    -i omega / (2 area) ((x - p_c) cross dx)."""
    rule = [(-math.sqrt(0.6), 5 / 18), (0.0, 8 / 18), (math.sqrt(0.6), 5 / 18)]
    parts = 12
    nodes = [((k + 0.5 + 0.5 * x) / parts, w / parts) for k in range(parts) for x, w in rule]
    cross = lambda a, b: a[0] * b[1] - a[1] * b[0]
    minus = lambda a, b: (a[0] - b[0], a[1] - b[1])
    area = 0.5 * cross(minus(points[1], points[0]), minus(points[2], points[0]))
    gradient = []
    for c in range(3):
        e = minus(points[c - 1], points[(c + 1) % 3])
        gradient.append((-e[1] / (2 * area), e[0] / (2 * area)))
    mass = [[0.0] * 3 for _ in range(3)]
    energy = [[0.0] * 3 for _ in range(3)]
    for s, ws in nodes:
        for t, wt in nodes:
            b = (1 - s, s * (1 - t), s * t)
            x = tuple(sum(b[c] * points[c][d] for c in range(3)) for d in range(2))
            weight = ws * wt * s * 2 * area
            value, slope = [], []
            for c in range(3):
                # The holonomy of the triangle p_0, p_c, x takes the section of corner c to the gauge of
                # corner 0, in which all three are compared; the edges from corner 0 are transported by 1.
                phase = cmath.exp(1j * (0.0, omega * b[2], -omega * b[1])[c])
                d = minus(x, points[c])
                form = [-0.5j * omega / area * -d[1], -0.5j * omega / area * d[0]]
                value.append(phase * b[c])
                slope.append([phase * (gradient[c][k] + b[c] * form[k]) for k in range(2)])
            for i in range(3):
                for j in range(3):
                    mass[i][j] += weight * value[i].conjugate() * value[j]
                    products = sum(slope[i][k].conjugate() * slope[j][k] for k in range(2))
                    turned = 1j * (
                        slope[i][0].conjugate() * slope[j][1] - slope[i][1].conjugate() * slope[j][0]
                    )
                    # (1 + s) E_hol + (1 - s) E_anti with the derivatives by x + i y and by x - i y.
                    energy[i][j] += weight * (products + bias * turned)
    return area, mass, energy


def check_integrals():
    points = ((0.1, 0.2), (1.3, 0.1), (0.5, 0.9))
    squared = [distance(points[c], points[(c + 1) % 3]) ** 2 for c in range(3)]
    for omega in (0.0, 0.3, -1.1, 2.5, -4.0, 9.0):
        for bias in (0.0, 1.0, -0.6):
            area, mass, energy = quadrature(points, omega, bias)
            diagonal, local, m_diagonal, m = local_integrals(squared, area, omega, bias)
            # Around the triangle, r of the three edges is 1, exp(-i omega) and 1, or the like: the
            # holonomy r_01 r_12 r_20 is exp(i omega).
            r = (1.0, cmath.exp(1j * omega), 1.0)
            for c in range(3):
                j = (c + 1) % 3
                assert abs(mass[c][c] - m_diagonal) < 1e-7
                assert abs(mass[c][j] - m * complex(r[c]).conjugate()) < 1e-7, (omega, c)
                assert abs(energy[c][c] - diagonal[c]) < 1e-6, (omega, bias, c)
                assert abs(energy[c][j] - local[c] * complex(r[c]).conjugate()) < 1e-6, (omega, bias, c)
    for omega in (1.999999, -1.999999):
        nearly = section_integrals(omega * 1.000001)
        assert all(abs(a - b) < 1e-6 for a, b in zip(section_integrals(omega), nearly))


def check_connection(mesh):
    connection = Connection(mesh)
    for n in (1, 2, 4, 6):
        for t in range(len(mesh.triangles)):
            r = [connection.transport(3 * t + c, n) for c in range(3)]
            omega = n * connection.curvature[t]
            assert abs(r[0] * r[1] * r[2] - cmath.exp(1j * omega)) < 1e-12
    assert abs(sum(connection.curvature) - 4 * PI) < 1e-10


def check_energy(coarse, fine):
    # lambda_1 of the unit sphere is n (1 - s), up to an error that falls with the square of the edges.
    for n, bias in ((1, 0.0), (4, 0.0), (4, 0.5), (2, -1.0), (4, 1.0)):
        values = [
            smallest_eigenpair(*operators(mesh, Connection(mesh), n, bias))[0] for mesh in (coarse, fine)
        ]
        assert abs((4 * values[1] - values[0]) / 3 - n * (1 - bias)) < 0.05, (n, bias, values)
    # Positive semi-definite for each bias, with a boundary, too: the energy is a sum of squares.
    cap = [t for t in fine.triangles if all(fine.points[v][2] > -0.3 for v in t)]
    used = sorted({v for t in cap for v in t})
    number = {v: k for k, v in enumerate(used)}
    half = Mesh([fine.points[v] for v in used], [tuple(number[v] for v in t) for t in cap])
    for bias in (-1.0, 0.0, 1.0):
        for n in (1, 4):
            Factor(*operators(half, Connection(half), n, bias), 1.0, 1e-6)


def check_singularities(mesh):
    connection = Connection(mesh)
    for n in (1, 2, 3, 4, 6):
        for seed in range(3):
            u = [cmath.exp(1j * (2.4 * v * v + seed * v)) for v in range(len(mesh.points))]
            assert sum(singularity_indices(mesh, connection, n, u)) == 2 * n
        _, u = smallest_eigenpair(*operators(mesh, connection, n))
        assert sum(singularity_indices(mesh, connection, n, u)) == 2 * n


def check_large_indices():
    """Each triangle of a tetrahedron has the holonomy 4 pi for crosses, two turns."""
    mesh = tetrahedron()
    connection = Connection(mesh)
    assert all(abs(4 * k - 4 * PI) < 1e-12 for k in connection.curvature)
    _, u = smallest_eigenpair(*operators(mesh, connection, 4), 500)
    assert singularity_indices(mesh, connection, 4, u) == [2, 2, 2, 2]


def check_alignment(mesh):
    """u tends to q for lambda_t to minus infinity, and to the eigenvector for lambda_t to lambda_1."""
    n = 4
    energy, mass = operators(mesh, Connection(mesh), n)
    smallest, first = smallest_eigenpair(energy, mass, 1000)
    q = [cmath.exp(0.37j * v) for v in range(len(mesh.points))]
    for gap, limit in ((1e9, q), (1e-6, first)):
        u = Factor(energy, mass, 1.0, gap - smallest).solve([gap * x for x in times(mass, q)])
        along = abs(dot(times(mass, limit), u))
        sizes = dot(u, times(mass, u)).real * dot(limit, times(mass, limit)).real
        assert along / math.sqrt(sizes) > 1 - 1e-6, gap


def main():
    coarse = bumpy(icosphere(1))
    check_integrals()
    check_connection(coarse)
    check_connection(tetrahedron())
    check_energy(icosphere(1), icosphere(2))
    for mesh in (coarse, icosphere(0), tetrahedron()):
        check_singularities(mesh)
    check_large_indices()
    check_alignment(coarse)
    print("The formulas hold.")


if __name__ == "__main__":
    main()
