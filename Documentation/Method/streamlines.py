# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Streamlines.md for small meshes: the field inside of a triangle, its zeros and rays, and lines traced along it."""

import cmath
import math

from method import PI, triangle_area


class Interpolant:
    """q on a triangle laid flat, corner 0 at 0 and corner 1 on the real axis (Interpolation/FieldInterpolant)."""

    def __init__(self, mesh, connection, n, u, t):
        self.n, hs = n, range(3 * t, 3 * t + 3)
        squared = [mesh.squared_length(h) for h in hs]
        base = math.sqrt(squared[0])
        self.area = triangle_area(squared)
        height = 2 * self.area / base
        self.corner = [0j, base + 0j, complex(0.5 * (squared[0] + squared[2] - squared[1]) / base, height)]
        self.size = math.sqrt(2 * self.area)
        self.along, self.slope, self.power, self.excess = [], [], [], []
        for c, h in enumerate(hs):
            edge = self.corner[c - 2] - self.corner[c]
            opposite = self.corner[c - 1] - self.corner[c - 2]
            self.along.append(edge / abs(edge))
            self.slope.append(1j * opposite / (2 * self.area))
            self.excess.append(1 - connection.scale[mesh.tail(h)])
            angle = cmath.phase(self.along[c]) - connection.edge_angle[h]
            self.power.append(u[mesh.tail(h)] * cmath.exp(1j * n * angle))

    def weight(self, c, z):
        offset = z - self.corner[c - 2]
        return (self.slope[c].conjugate() * offset).real

    def ray_angle(self, c, z):
        """From the half-edge at a corner to a place, at least 0 inside."""
        angle = cmath.phase((z - self.corner[c]) / self.along[c]) if z != self.corner[c] else 0.0
        return angle if angle > -PI / 2 else angle + 2 * PI

    def at(self, z):
        return sum(
            self.weight(c, z) * p * cmath.exp(1j * self.n * self.excess[c] * self.ray_angle(c, z))
            for c, p in enumerate(self.power)
        )

    def jet(self, z):
        """The value, and the derivatives by z and by its conjugate."""
        value = along = conjugate = 0j
        for c in range(3):
            weight, slope = self.weight(c, z), self.slope[c]
            p = self.power[c] * cmath.exp(1j * self.n * self.excess[c] * self.ray_angle(c, z))
            turning = self.n * self.excess[c] * weight / (z - self.corner[c])
            value += weight * p
            along += 0.5 * p * (slope.conjugate() + turning)
            conjugate += 0.5 * p * (slope - turning.conjugate())
        return value, along, conjugate

    def zero(self):
        """By Newton's method from the middle, with steps that are halved (Interpolation/InterpolantZero)."""
        z = sum(self.corner) / 3
        for _ in range(60):
            value, along, conjugate = self.jet(z)
            if abs(value) < 1e-13:
                break
            determinant = abs(along) ** 2 - abs(conjugate) ** 2
            step = (conjugate * value.conjugate() - along.conjugate() * value) / determinant
            part = 1.0
            while part > 1e-9:
                new = z + part * step
                inside = min(self.weight(c, new) for c in range(3)) > 1e-4
                if inside and abs(self.at(new)) < abs(value):
                    break
                part *= 0.5
            z = new
        return z


def direction_near(q, n, near, sense=1):
    """The direction whose n-th power is q that is nearest to a unit number; against it for the sense -1."""
    turn = q / near**n * (-1 if sense < 0 and n % 2 == 1 else 1)
    return near * cmath.exp(1j * cmath.phase(turn) / n)


def ray_angles(q, n, index, value=0.0, places=360):
    """Where n beta - arg q(beta) passes multiples of 2 pi, plus a value, on a circle (Streamlines/SingularPoints);
    q is a function of the angle."""

    def difference(beta):
        return cmath.phase(cmath.exp(1j * (n * beta - value)) / q(beta))

    if n == index:
        return []
    first = 0.123
    angles, last = [], difference(first)
    for k in range(places):
        low, high = first + 2 * PI * k / places, first + 2 * PI * (k + 1) / places
        after = difference(high)
        if (last < 0) != (after < 0) and abs(after - last) < PI:
            rises = after > last
            for _ in range(50):
                middle = 0.5 * (low + high)
                if (difference(middle) > 0) == rises:
                    high = middle
                else:
                    low = middle
            angles.append(0.5 * (low + high) % (2 * PI))
        last = after
    return sorted(angles)


def root_of_cubic(begin, begin_slope, end, end_slope):
    """Where in (0, 1] the cubic with these values and slopes at 0 and 1 vanishes; end < 0
    (Streamlines/StreamlineTrace.cxx). One that begins at 0 and rises vanishes once more: divided by t."""
    starts_at_zero = not begin > 1e-12
    if starts_at_zero and not begin_slope > 0:
        return 0.0

    def value(t):
        s = 1 - t
        rest = end * t * (3 - 2 * t) - end_slope * t * s
        if starts_at_zero:
            return begin_slope * s * s + rest
        return begin * s * s * (1 + 2 * t) + t * (begin_slope * s * s + rest)

    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        if value(middle) > 0:
            low = middle
        else:
            high = middle
    return high


def hermite(begin, begin_slope, end, end_slope, t):
    s = 1 - t
    return (
        begin * s * s * (1 + 2 * t) + begin_slope * t * s * s + end * t * t * (3 - 2 * t) - end_slope * t * t * s
    )


class Tracer:
    """A line from a place in a triangle, piece by piece (Streamlines/StreamlineTrace)."""

    def __init__(self, mesh, connection, n, u, part=0.25):
        self.mesh, self.part = mesh, part
        self.on = [Interpolant(mesh, connection, n, u, t) for t in range(len(mesh.triangles))]

    def step(self, field, z, first, length):
        """Runge and Kutta's, with the direction nearest to the last one."""
        near = direction_near
        second = near(field.at(z + 0.5 * length * first), field.n, first)
        third = near(field.at(z + 0.5 * length * second), field.n, second)
        fourth = near(field.at(z + length * third), field.n, third)
        return z + length * (first + 2 * second + 2 * third + fourth) / 6, fourth

    def trace(self, t, z, direction, longest):
        """Pieces (triangle, begin, end) until a length, or the boundary."""
        pieces, done = [], 0.0
        direction = direction_near(self.on[t].at(z), self.on[t].n, direction)
        while done < longest:
            field = self.on[t]
            length = self.part * field.size
            end, heading = self.step(field, z, direction, length)
            exits = []
            for c in range(3):
                if field.weight(c, end) < 0:
                    slope = field.slope[c].conjugate()
                    begin_slope, end_slope = ((length * slope * d).real for d in (direction, heading))
                    root = root_of_cubic(
                        field.weight(c, z), begin_slope, field.weight(c, end), end_slope
                    )
                    exits.append((root, (c + 1) % 3))
            if not exits:
                pieces.append((t, z, end))
                done += abs(end - z)
                z, direction = end, direction_near(field.at(end), field.n, heading)
                continue
            root, edge = min(exits)
            at = hermite(z, length * direction, end, length * heading, root)
            fraction = ((at - field.corner[edge]) / field.along[edge]).real
            whole = abs(field.corner[edge - 2] - field.corner[edge])
            fraction = min(max(fraction / whole, 1e-9), 1 - 1e-9)
            at = field.corner[edge] + fraction * (field.corner[edge - 2] - field.corner[edge])
            heading = direction_near(field.at(at), field.n, direction if root < 0.5 else heading)
            pieces.append((t, z, at))
            done += abs(at - z)
            twin = self.mesh.twin[3 * t + edge]
            if twin is None:
                break
            angle = heading / field.along[edge]
            t, edge = divmod(twin, 3)
            field = self.on[t]
            start = field.corner[edge - 2]
            z = start + fraction * (field.corner[edge] - start)
            direction = -field.along[edge] * angle
        return pieces
