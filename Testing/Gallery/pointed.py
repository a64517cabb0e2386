# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of quads on parts of few, long triangles, with sharp edges and corners."""

import numpy as np
from paraview import simple

import meshes
from gallery import producer
from remeshed import RemeshedPanel


def star(points, inside):
    """A flat star with so many points, of triangles that all meet in its middle."""
    turn = np.arange(2 * points) * np.pi / points
    radius = np.where(np.arange(2 * points) % 2 == 0, 1.0, inside)
    outline = np.stack([radius * np.cos(turn), radius * np.sin(turn), 0.0 * turn], axis=1)
    k = np.arange(2 * points)
    return meshes.polydata(
        np.vstack([outline, [[0.0, 0.0, 0.0]]]),
        np.stack([k, (k + 1) % (2 * points), np.full_like(k, 2 * points)], axis=1))


def gear(teeth, height):
    """A toothed wheel: two flat faces of triangles that meet in their middles, and a wall."""
    k = np.arange(4 * teeth)
    turn = k * 2.0 * np.pi / len(k)
    radius = np.where(k % 4 < 2, 1.0, 0.8)
    outline = np.stack([radius * np.cos(turn), radius * np.sin(turn)], axis=1)
    points = np.vstack([
        np.column_stack([outline, np.zeros(len(k))]), np.column_stack([outline, np.full(len(k), height)]),
        [[0.0, 0.0, 0.0], [0.0, 0.0, height]]])
    after, up, middle = (k + 1) % len(k), len(k), 2 * len(k)
    return meshes.polydata(points, np.vstack([
        np.stack([after, k, np.full_like(k, middle)], axis=1),
        np.stack([k + up, after + up, np.full_like(k, middle + 1)], axis=1),
        np.stack([k, after, after + up], axis=1), np.stack([k, after + up, k + up], axis=1)]))


def pointed(_):
    """ParaView's cone, whose sides meet at 26 degrees; a star; ParaView's cylinder, along its smoothest field, which
    knows nothing of its edges; a toothed wheel."""
    cone = RemeshedPanel(simple.Cone(), ([0.5, 0.35, 1.0], [0.0, 1.0, 0.0], 0.85), NumberOfFaces=1500)
    cone.check(4, 0.995)
    # No face at the apex can be better than the sine of its angle.
    angle = 2.0 * np.arcsin(0.25 / np.sqrt(1.25))
    assert 0.9 * np.sin(angle) < cone.least_quality() <= np.sin(angle) + 1e-6, cone.least_quality()
    plate = RemeshedPanel(
        producer(star(8, 0.5)), ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0], 1.3), NumberOfFaces=1500)
    plate.check(4, 0.995)
    assert plate.least_quality() > 0.4, plate.least_quality()
    cylinder = RemeshedPanel(
        simple.DirectionField(Input=simple.Cylinder(Resolution=30)), ([0.5, 0.6, 1.0], [0.0, 1.0, 0.0], 0.9),
        NumberOfFaces=1500)
    cylinder.check(4, 0.995)
    assert cylinder.number("IrregularVertices") <= 12.0, cylinder.number("IrregularVertices")
    wheel = RemeshedPanel(
        producer(gear(20, 0.3)), ([0.3, -0.7, 0.9], [0.0, 0.0, 1.0], 1.0), NumberOfFaces=4000)
    wheel.check(4, 0.99)
    assert wheel.least_quality() > 0.25, wheel.least_quality()
    return [cone, plate, cylinder, wheel]
