# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery: the figures of C. Clemenz' thesis (TU Wien 2019), with the numbers behind them.

Each function makes the panels of a figure and asserts what they show.
"""

import math
import os
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import meshes
from engineering import engineering, roof
from gallery import BUNNY_CAMERA, OBLIQUE, Panel, bunny, producer
from pointed import pointed
from remeshed import RemeshedPanel, remeshed
from shown import ComparisonPanel, GivenPanel, LinesPanel
from striped import EigenStripesPanel, StripePanel

OBLIQUE_BOX = ([0.5, -0.9, 0.8], [0.0, 0.0, 1.0], 0.95)
FROM_ABOVE = ([0.0, 0.0, 1.0], [0.0, 1.0, 0.0], 1.3)
BOUNDARY, SHARP_EDGE, CURVATURE = 1, 2, 3


def symmetries(directory):
    """1.1: a vector field and a line field, with their singularities."""
    panels = [Panel(bunny(directory), degree, BUNNY_CAMERA) for degree in (1, 2)]
    for panel, degree in zip(panels, (1, 2)):
        panel.field.check_sum()
        assert panel.field.index.sum() == 2 * degree
        assert panel.field.count() >= 2 * degree
    return panels


def what_it_does(directory):
    """What one does with a field: a cross field that keeps the features of a part, a line field as a
    texture, lines, and a mesh of quads."""
    part = simple.STLReader(FileNames=[os.path.join(directory, "bracket.stl")])
    panels = [
        Panel(part, 4, ([0.75, -0.9, 0.75], [0.0, 0.0, 1.0], 0.85), glyphs=700,
              ConstrainSharpEdges=1, UnitLength=1),
        Panel(bunny(directory), 2, BUNNY_CAMERA, UnitLength=1),
        Panel(bunny(directory), 4, BUNNY_CAMERA, UnitLength=1),
        Panel(bunny(directory), 4, BUNNY_CAMERA, UnitLength=1)]
    part, texture, lines, quads = panels
    for panel in panels:
        panel.field.check_sum()
    sharp = np.count_nonzero(part.field.kind == SHARP_EDGE)
    assert sharp > 20, sharp

    display = simple.GetRepresentation(texture.picture.surface, texture.view)
    display.SetRepresentationType("Surface LIC")
    display.SelectInputVectors = ["POINTS", "Direction0"]
    display.NumberOfSteps = 60
    display.ColorMode = "Blend"
    display.LICIntensity = 0.6
    display.EnhanceContrast = "LIC Only"
    for panel in (texture, lines, quads):
        simple.Hide(panel.picture.glyphs, panel.view)

    followed = simple.DirectionFieldStreamlines(Input=lines.proxy)
    simple.Show(followed, lines.view).LineWidth = 2.0
    count = servermanager.Fetch(followed).GetNumberOfLines()
    assert count > 10, count

    remeshed = simple.FieldAlignedRemesh(Input=quads.proxy, NumberOfFaces=3000)
    mesh = servermanager.Fetch(remeshed)
    sizes = np.diff(vtk_to_numpy(mesh.GetPolys().GetOffsetsArray()))
    assert 2400 < len(sizes) < 3600 and np.mean(sizes == 4) > 0.99, (len(sizes), np.mean(sizes == 4))
    simple.Hide(quads.picture.surface, quads.view)
    display = simple.Show(remeshed, quads.view)
    display.SetRepresentationType("Surface With Edges")
    display.EdgeColor = [0.25, 0.25, 0.28]
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
        {}, {"ConstrainSharpEdges": 1, "FeatureAngle": 30.0, "MinimumFeatureLength": 0.0,
             "ConstraintSolver": "Least Squares"},
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


def strokes(directory):
    """A cross field without guidance, and led by a curve around the bunny, which it follows."""
    mesh = bunny(directory)
    curve = simple.Slice(Input=mesh, SliceType="Plane")
    curve.SliceType.Normal = [1.0, 0.8, 0.3]
    guided = simple.GuidanceFromCurves(Input=mesh, Curves=curve, Degree=4)
    panels = [Panel(mesh, 4, BUNNY_CAMERA), Panel(
        guided, 4, BUNNY_CAMERA, ConstrainGuidance=1, GuidanceVectors="GuidanceVectors",
        GuidanceWeights="GuidanceWeights", DropConstraintsAtSingularities=0)]
    data = panels[1].field.surface.GetPointData()
    vectors = vtk_to_numpy(data.GetArray("GuidanceVectors")).astype(float)
    weights = vtk_to_numpy(data.GetArray("GuidanceWeights"))
    on = weights > 0.0
    assert 100 < on.sum() < 0.2 * len(on), on.sum()
    assert weights.max() <= 1.0 + 1e-6
    vectors[~on] = [1.0, 0.0, 0.0]
    free, led = (panel.field.deviation(vectors)[on] for panel in panels)
    assert led.max() < 0.1, led.max()
    assert free.mean() > 10.0, free.mean()
    for panel in panels:
        panel.field.check_sum()
    display = simple.Show(simple.Tube(Input=curve, Radius=0.07), panels[1].view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0.85, 0.51, 0.18]
    return panels


def comparison(directory):
    """Two cross fields, the smoothest one and one drawn to the curvature, and the angles between them."""
    mesh = bunny(directory)
    panels = [Panel(mesh, 4, BUNNY_CAMERA),
              Panel(mesh, 4, BUNNY_CAMERA, Alignment="Principal Curvature")]
    panels.append(ComparisonPanel(panels[0].proxy, panels[1].proxy, BUNNY_CAMERA))
    compared = servermanager.Fetch(panels[2].compared)
    angles = vtk_to_numpy(compared.GetPointData().GetArray("AngleDifference"))
    one, other = (panel.field for panel in panels[:2])
    expected = np.min([one.deviation(direction) for direction in other.directions], axis=0)
    assert np.allclose(angles, expected, atol=0.05), np.abs(angles - expected).max()
    figures = compared.GetFieldData()
    assert abs(figures.GetArray("MaximumAngleDifference").GetTuple1(0) - angles.max()) < 1e-9
    assert 0.0 < figures.GetArray("MeanAngleDifference").GetTuple1(0) < 45.0
    matched, first, second = figures.GetArray("MatchedSingularities").GetTuple3(0)
    assert matched + first == one.count() and matched + second == other.count()
    assert matched >= 8
    return panels


def exchange(directory):
    """A cross field, and the same from the .rosy file that it was saved to, one direction a triangle."""
    mesh = bunny(directory)
    own = Panel(mesh, 4, BUNNY_CAMERA)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "bunny.rosy")
        simple.SaveData(path, proxy=own.proxy)
        with open(path, encoding="ascii") as file:
            assert [file.readline(), file.readline()] == [f"{len(own.field.triangles)}\n", "4\n"]
        back = simple.ReadDirectionField(Input=mesh, FileName=path)
        back.UpdatePipeline()
        panels = [own, GivenPanel(back, BUNNY_CAMERA)]
        compared = servermanager.Fetch(simple.CompareDirectionFields(
            Input=own.proxy, Other=back, Diagnostics=1))
    for panel in panels:
        panel.field.check_sum()
    mean = compared.GetFieldData().GetArray("MeanAngleDifference").GetTuple1(0)
    assert mean < 1.0, mean
    return panels


def singularities(_):
    """A cube-like sphere with four singularities between its corners (left), and moved to the corners (right)."""
    base = simple.DirectionField(Input=producer(meshes.rounded_cube()), Degree=4)
    size = 3.0 ** (-1.0 / 6.0)
    panels = []
    energy = []
    for turned_by in (math.pi / 4.0, 0.0):
        places = []
        for height, angle in ((size, turned_by), (-size, 0.0)):
            for k in range(4):
                phi = math.pi / 4.0 + math.pi / 2.0 * k + angle
                places.append([math.sqrt(2.0) * size * math.cos(phi),
                               math.sqrt(2.0) * size * math.sin(phi), height])
        points = producer(meshes.polydata(places, np.zeros((0, 3))))
        edit = simple.EditSingularities(Input=base, Singularities=points, Diagnostics=1)
        edit.UpdatePipeline()
        panels.append(GivenPanel(edit, OBLIQUE))
        balls = simple.Show(simple.Glyph(
            Input=simple.OutputPort(edit, 1), GlyphType="Sphere", GlyphMode="All Points",
            ScaleArray=["POINTS", "Size"], ScaleFactor=3.0,
            OrientationArray=["POINTS", "No orientation array"]), panels[-1].view)
        balls.ColorArrayName = ["POINTS", ""]
        balls.AmbientColor = balls.DiffuseColor = [0.84, 0.10, 0.11]
        figures = panels[-1].field.surface.GetFieldData()
        energy.append(figures.GetArray("RotationEnergy").GetValue(0))
        assert figures.GetArray("WrongTriangles").GetValue(0) == 0
        found = vtk_to_numpy(servermanager.Fetch(edit, idx=1).GetPoints().GetData())
        distances = np.linalg.norm(found[:, None] - np.array(places)[None], axis=2)
        assert len(found) == 8
        # The lower ones are on the surface; the upper four are between corners at first, off the surface.
        assert distances.min(axis=1)[found[:, 2] < 0.0].max() < 0.05
        if not turned_by:
            assert distances.min(axis=1).max() < 0.05
    assert energy[1] < 0.9 * energy[0], energy
    for panel in panels:
        panel.field.check_sum()
    return panels


def stripes(directory):
    """Stripes around a scan, and courses and wales on a sleeve, which branch where it gets narrower."""
    scan = simple.DirectionField(Input=bunny(directory), Degree=2)
    sleeve = simple.DirectionField(Input=producer(meshes.sleeve()), Degree=2, ConstrainBoundary=1)
    wales = simple.StripePattern(Input=sleeve, StripeDirection="Across Field", Spacing=0.12)
    panels = [StripePanel(scan, BUNNY_CAMERA),
              StripePanel(sleeve, ([0.1, -0.2, 1.0], [0.0, 1.0, 0.0], 1.2), wales, Spacing=0.12)]
    for panel in panels:
        assert abs(panel.share() - 1.0) < 0.03, panel.share()
        assert 0.0 < panel.figure("Misfit") < 0.15, panel.figure("Misfit")
        assert panel.figure("BranchPoints") > 10
    # The sleeve loses half of its wales to the wrist: 2 pi (1 - 0.5) / 0.12 of them.
    index = vtk_to_numpy(servermanager.Fetch(wales, idx=2).GetPointData().GetArray("StripeIndex"))
    assert 0.6 * 26.2 < abs(index.sum()) < 1.1 * 26.2, index.sum()
    return panels


def stripes_eigenvector(directory):
    """Radial stripes on a ring: the smallest eigenvector forgets most of it, relaxed phases do not."""
    spacing = 0.25
    field = simple.DirectionField(Input=producer(meshes.annulus()), Degree=1, Alignment="Point Vectors",
                                  AlignmentStrength=0.99, GuidanceVectors="Around")
    panels = [EigenStripesPanel(field, FROM_ABOVE, spacing),
              StripePanel(field, FROM_ABOVE, StripeDirection="Across Field", Spacing=spacing)]
    for panel in panels:
        panel.cell = 100
    eigen, relaxed = panels[0].eigen, panels[1]
    points = relaxed.field.points
    around = np.stack([-points[:, 1], points[:, 0], points[:, 2]], axis=1)
    assert relaxed.field.deviation(around).max() < 1.0
    modulus = np.abs(eigen.section)
    print(f"modulus {modulus.min() / modulus.max():.1e}, misfit {eigen.misfit():.3f}, "
          f"{eigen.branch_points()} branch points; relaxed {relaxed.figure('Misfit'):.3f}, "
          f"{relaxed.figure('BranchPoints'):.0f} of {2.0 * np.pi / spacing:.1f} due")
    assert modulus.min() < 1e-2 * modulus.max()
    assert relaxed.figure("Misfit") < 0.85 * eigen.misfit()
    assert eigen.branch_points() < 0.5 * relaxed.figure("BranchPoints")
    assert 0.55 < relaxed.figure("BranchPoints") * spacing / (2.0 * np.pi) < 1.1
    return panels


def lines(directory):
    """Evenly spaced lines of a line field and of a cross field."""
    panels = [LinesPanel(bunny(directory), degree, BUNNY_CAMERA) for degree in (2, 4)]
    for panel, families in zip(panels, (1, 2)):
        panel.field.check_sum()
        a, b, c = (panel.field.points[panel.field.triangles[:, k]] for k in range(3))
        area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
        spacing = panel.traced.GetFieldData().GetArray("SeparatingDistance").GetTuple1(0)
        assert abs(spacing - np.sqrt(area) / 40.0) < 1e-3 * spacing
        # Each family covers the surface once.
        covered = panel.array("Length").sum() * spacing / (families * area)
        assert 0.9 < covered < 1.3, covered
        along = vtk_to_numpy(panel.traced.GetPointData().GetArray("Direction"))
        assert np.allclose(np.linalg.norm(along, axis=1), 1.0, atol=1e-5)
    return panels


class StressPanel(LinesPanel):
    """Lines along both principal directions of the array Stress, red where it pulls and blue where it presses."""

    def __init__(self, mesh, camera, most, **properties):
        super().__init__(producer(mesh), 4, camera,
                         {"Alignment": "Tensor", "TensorArray": ["POINTS", "Stress"]}, **properties)
        display = simple.GetRepresentation(self.lines, self.view)
        display.LineWidth = 3.0
        simple.ColorBy(display, ("POINTS", "PrincipalValue"), separate=True)
        display.UseSeparateColorMap = 1
        colors = simple.GetColorTransferFunction("PrincipalValue", display, separate=True)
        colors.ColorSpace = "RGB"
        colors.RGBPoints = [-most, 0.05, 0.2, 0.75, 0.0, 0.6, 0.6, 0.6, most, 0.8, 0.05, 0.05]
        display.SetScalarBarVisibility(self.view, False)
        surface = simple.GetRepresentation(self.proxy, self.view)
        surface.AmbientColor = surface.DiffuseColor = [0.95, 0.94, 0.92]

    def along(self):
        return vtk_to_numpy(self.traced.GetPointData().GetArray("PrincipalValue"))


def stress(_):
    """Where forces run: in a plate with a hole that is pulled sideways, and in a torus under pressure."""
    panels = [StressPanel(meshes.stressed_plate(), FROM_ABOVE, 1.5),
              StressPanel(meshes.pressurized_torus(), OBLIQUE, 0.5)]
    plate, torus = panels
    assert plate.field.count() == torus.field.count() == 0
    assert plate.along().min() < -0.7 and plate.along().max() > 2.5, plate.along()
    # A torus under pressure is pulled everywhere, the least along its circles.
    assert torus.along().min() > 0.19, torus.along().min()
    x, y, _ = torus.field.points.T
    assert torus.field.deviation(np.stack([-y, x, 0.0 * x], axis=1)).max() < 1.0
    return panels


def graph(directory):
    """The lines out of the singularities of a cross field, and its graph: they end where they meet."""
    mesh = bunny(directory)
    most = 12.0
    panels = [
        LinesPanel(
            mesh, 4, BUNNY_CAMERA, SeedType="Singularities", MaximumStreamlineLength=most),
        LinesPanel(mesh, 4, BUNNY_CAMERA, SeedType="Singularities", StopAtCrossings=1)]
    free, stopped = panels
    index = free.field.index[free.field.index != 0]
    assert len(free.array("Length")) == np.abs(4 - index).sum()
    assert free.array("Length").max() < most + 1e-6
    # Each ends in a singularity or where it crosses another one, and what leads from one singularity to another
    # is there once.
    ends = stopped.array("ReasonForTermination")[:, 1]
    crossings, into = (ends == 9).sum(), (ends == 6).sum()
    assert crossings + into == len(ends) and crossings > 10, (crossings, into, len(ends))
    rays = np.abs(4 - index).sum()
    assert 0 <= rays - len(ends) <= into, (rays, len(ends), into)
    kinds = vtk_to_numpy(stopped.nodes.GetPointData().GetArray("NodeType"))
    assert (kinds == 0).sum() == len(index) and (kinds == 1).sum() == crossings
    # By Euler's formula, and by their corners: two at each crossing, one between two rays of a singularity. Where
    # a line runs into a singularity beside its rays, there is one more.
    patches = stopped.field.figure("EulerCharacteristic") + len(ends) - len(index)
    assert 4 * patches - 2 * crossings - rays == 2 * (into - (rays - len(ends))), patches
    return panels


FIGURES = {
    "Stripes": stripes,
    "StripesEigenvector": stripes_eigenvector,
    "WhatItDoes": what_it_does,
    "Remeshed": remeshed,
    "Pointed": pointed,
    "Engineering": engineering,
    "Roof": roof,
    "Symmetries": symmetries,
    "Energies": energies,
    "UnitLength": unit_length,
    "Alignment": alignment,
    "Disk": disk,
    "NoisyPart": noisy_part,
    "Icosahedron": icosahedron,
    "Plate": plate,
    "Strokes": strokes,
    "Comparison": comparison,
    "Exchange": exchange,
    "Singularities": singularities,
    "Lines": lines,
    "Graph": graph,
    "Stress": stress,
}
