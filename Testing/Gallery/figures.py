# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery: the figures of C. Clemenz' thesis (TU Wien 2019), with the numbers behind them.

Each function makes the panels of a figure and asserts what they show.
"""

import os

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import meshes
from gallery import Panel, producer

BUNNY_CAMERA = ([-0.35, 0.25, 1.0], [0.0, 1.0, 0.0], 1.25)
OBLIQUE = ([0.75, -0.9, 0.75], [0.0, 0.0, 1.0], 1.1)
OBLIQUE_BOX = ([0.5, -0.9, 0.8], [0.0, 0.0, 1.0], 0.95)
FROM_ABOVE = ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0], 1.3)
BOUNDARY, SHARP_EDGE, CURVATURE = 1, 2, 3


def bunny(directory):
    return simple.PLYReader(FileNames=[os.path.join(directory, "bunny.ply")])


def symmetries(directory):
    """1.1: a vector field and a line field, with their singularities."""
    panels = [Panel(bunny(directory), degree, BUNNY_CAMERA) for degree in (1, 2)]
    for panel, degree in zip(panels, (1, 2)):
        panel.field.check_sum()
        assert panel.field.index.sum() == 2 * degree
        assert panel.field.count() >= 2 * degree
    return panels


def energies(_):
    """3.3: the Dirichlet energy against the holomorphic energy, on a torus with bumps."""
    torus = producer(meshes.torus())
    panels = [Panel(torus, 4, OBLIQUE, EnergyBias=bias) for bias in (0.0, 1.0)]
    for panel in panels:
        panel.field.check_sum()
    dirichlet, holomorphic = (panel.field for panel in panels)
    assert dirichlet.count() >= 8
    assert holomorphic.count() == 0
    assert holomorphic.figure("Eigenvalue") < 0.05 * dirichlet.figure("Eigenvalue")
    return panels


def unit_length(directory):
    """The smoothest field of the bunny, the directions of least energy, and those with fewer singularities."""
    panels = [Panel(bunny(directory), 4, BUNNY_CAMERA, glyphs=900, **properties) for properties in (
        {}, {"UnitLength": 1}, {"UnitLength": 1, "SingularityCost": 1.0})]
    for panel in panels:
        panel.field.check_sum()
    smoothest, unit, fewer = (panel.field for panel in panels)
    for field in (unit, fewer):
        before, after = field.surface.GetFieldData().GetArray("UnitEnergy").GetTuple2(0)
        assert after < 0.75 * before, (before, after)
        magnitude = vtk_to_numpy(field.surface.GetPointData().GetArray("RepresentationMagnitude"))
        assert np.allclose(magnitude, 1.0, atol=1e-6)
    assert unit.count() <= 0.85 * smoothest.count(), (smoothest.count(), unit.count())
    assert fewer.count() <= 0.65 * smoothest.count(), (smoothest.count(), fewer.count())
    return panels


def alignment(directory):
    """3.4: the curvature draws the field, from left to right and downwards more and more."""
    strengths = (0.1, 0.5, 0.9, 0.99)
    panels = [
        Panel(bunny(directory), 4, BUNNY_CAMERA, Alignment="Principal Curvature",
              AlignmentStrength=strength) for strength in strengths]
    energy = 0.0
    for panel in panels:
        panel.field.check_sum()
        assert panel.field.figure("SystemResidual") < 1e-6
        assert panel.field.figure("SmoothnessEnergy") > energy
        energy = panel.field.figure("SmoothnessEnergy")
    assert panels[-1].field.count() > panels[0].field.count()
    return panels


def disk(_):
    """4.1 and 4.2: a cross field on a disk without and with boundary constraints."""
    source = producer(meshes.disk())
    panels = [Panel(source, 4, FROM_ABOVE, glyphs=400, ConstrainBoundary=constrain,
                    ConstraintSolver="Least Squares") for constrain in (0, 1)]
    free, constrained = (panel.field for panel in panels)
    assert free.count() == 0
    assert free.deviation([1.0, 0.0, 0.0]).max() < 0.1
    assert sorted(constrained.index[constrained.index != 0]) == [1, 1, 1, 1]
    edge = constrained.kind == BOUNDARY
    assert np.array_equal(edge, np.linalg.norm(constrained.points, axis=1) > 1.0 - 1e-9)
    x, y, _ = constrained.points.T
    tangent = np.stack([-y, x, 0.0 * x], axis=1) + 1e-30
    assert constrained.deviation(tangent)[edge].max() < 0.1
    return panels


def noisy_part(_):
    """4.3: a noisy part without and with sharp-edge constraints, which its noise disturbs, and with those
    that are no noise."""
    source = producer(meshes.noisy_part())
    panels = [Panel(source, 4, OBLIQUE_BOX, glyphs=700, **properties) for properties in (
        {}, {"ConstrainSharpEdges": 1, "MinimumFeatureLength": 0.0, "ConstraintSolver": "Least Squares"},
        {"ConstrainSharpEdges": 1})]
    for panel in panels:
        panel.field.check_sum()
    free, noisy, constrained = (panel.field for panel in panels)
    assert np.count_nonzero(noisy.kind == SHARP_EDGE) > 200
    assert noisy.count() > free.count()
    assert np.count_nonzero(constrained.kind == SHARP_EDGE) > 200
    assert constrained.count() <= noisy.count() / 8
    return panels


def icosahedron(_):
    """4.4: an icosahedron aligned by its curvature and with sharp-edge constraints."""
    source = producer(meshes.icosahedron())
    panels = [
        Panel(source, 4, OBLIQUE, Alignment="Principal Curvature", AlignmentStrength=0.5),
        Panel(source, 4, OBLIQUE, ConstrainSharpEdges=1, FeatureAngle=30.0,
              ConstraintSolver="Least Squares")]
    for panel in panels:
        panel.field.check_sum()
    constrained = panels[1].field
    # Along each edge of the solid, its direction at every point but the corners.
    radius = np.linalg.norm(constrained.points, axis=1)
    corners = constrained.points[radius > radius.max() - 1e-6]
    assert len(corners) == 12
    on_edges = constrained.kind == SHARP_EDGE
    assert np.count_nonzero(on_edges) == 12 + 30 * 15
    side = min(np.linalg.norm(corners[0] - corner) for corner in corners[1:])
    checked = 0
    for i, a in enumerate(corners):
        for b in corners[:i]:
            if abs(np.linalg.norm(a - b) - side) < 1e-6:
                along = constrained.points - a
                t = along @ (b - a) / side ** 2
                distance = np.linalg.norm(along - t[:, None] * (b - a), axis=1)
                inside = (distance < 1e-6) & (t > 1e-6) & (t < 1.0 - 1e-6)
                assert constrained.deviation(b - a)[inside].max() < 0.1
                checked += np.count_nonzero(inside)
    assert checked == 30 * 15
    return panels


def plate(_):
    """4.5: boundary constraints at a large round hole, without and with curvature constraints."""
    source = producer(meshes.plate())
    panels = [
        Panel(source, 4, OBLIQUE_BOX, ConstrainBoundary=1, ConstrainCurvature=curvature,
              ConstraintSolver="Least Squares")
        for curvature in (0, 1)]

    def warp(field):
        """Mean angle to the sides on the flat part, away from the hole."""
        flat = (np.abs(field.points[:, 2]) < 1e-12) & (
            np.linalg.norm(field.points, axis=1) > 0.72)
        return field.deviation([1.0, 0.0, 0.0])[flat].mean()

    warped, straight = (panel.field for panel in panels)
    assert np.count_nonzero(straight.kind == CURVATURE) > 1000
    assert warp(straight) < 0.6 * warp(warped), (warp(straight), warp(warped))
    assert warped.index.sum() == straight.index.sum()
    return panels


FIGURES = {
    "Symmetries": symmetries,
    "Energies": energies,
    "UnitLength": unit_length,
    "Alignment": alignment,
    "Disk": disk,
    "NoisyPart": noisy_part,
    "Icosahedron": icosahedron,
    "Plate": plate,
}
