# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strokes that are made soft, and hard again: TestSoftStrokes.py PLUGIN OUTDIR"""
import functools
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow

import Messages

plugin, output_directory = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields

from directionfields import preview

import StrokeChecks
from StrokeChecks import caption, middle, names, new_view, points_of

messages = []
pixels_of = functools.partial(
    StrokeChecks.pixels_of, os.path.join(output_directory, "TestSoftStrokes.png"))


def away_from(field, number):
    """The mean angle in degrees between a cross field and a stroke at the points beside it."""
    data = servermanager.Fetch(field)
    line = points_of(field.Input.Curves)[number]
    points = vtk_to_numpy(data.GetPoints().GetData())
    along = line[-1] - line[0]
    angles = []
    for point in np.flatnonzero(np.linalg.norm(points[:, None] - line[None], axis=2).min(axis=1) < 0.03):
        best = max((np.array(data.GetPointData().GetArray(f"Direction{k}").GetTuple(point)) @ along)
                   for k in range(4))
        angles.append(np.degrees(np.arccos(min(1.0, best / np.linalg.norm(along)))))
    assert len(angles) > 5, len(angles)
    return np.mean(angles)


def test_soft():
    """A double click makes a stroke soft, and hard again; only its own look and the field change."""
    view = new_view()
    source = simple.Plane(XResolution=40, YResolution=40)
    simple.Show(source, view)
    simple.ResetCamera(view)
    field = directionfields.show(source, view=view, ConstrainBoundary=1).field
    x, y = middle(view, source)
    strokes = directionfields.draw_stroke([(x - 60, y - 20), (x + 60, y + 20)])
    directionfields.draw_stroke([(x - 60, y + 80), (x + 60, y + 60)])
    hard = [away_from(field, number) for number in (0, 1)]
    assert max(hard) < 2.0, hard
    white, before = pixels_of(view, (1.0, 1.0, 1.0)), names()
    assert directionfields.toggle_stroke((x + 3, y + 2)) == (strokes, 0, 0.5)
    assert list(strokes.Strengths) == [0.0, 0.5] and names() == before, list(strokes.Strengths)
    soft = [away_from(field, number) for number in (0, 1)]
    assert hard[0] + 1.0 < soft[0] < 18.0 and soft[1] < 2.0, (hard, soft)
    # Dashes have gaps.
    assert pixels_of(view, (1.0, 1.0, 1.0)) > white + 50
    lines = points_of(strokes)
    rows = np.array(list(strokes.Points)).reshape(-1, 4)
    assert np.allclose(lines[0][[0, -1]], rows[rows[:, 0] == 0][[0, -1], 1:])
    assert len(lines[1]) == (rows[:, 0] == 1).sum()
    steps = np.linalg.norm(np.diff(lines[0], axis=0), axis=1).sum()
    wanted = np.linalg.norm(np.diff(rows[rows[:, 0] == 0][:, 1:], axis=0), axis=1).sum()
    assert abs(steps / wanted - 1.0) < 1e-9, (steps, wanted)

    # The stiffer, the nearer.
    last = 90.0
    for strength in (0.0, 0.2, 0.8, 1.0):
        directionfields.set_stroke_strength(strokes, 0, strength)
        now = away_from(field, 0)
        assert now < last, (strength, now, last)
        last = now
    assert not len(strokes.Strengths) and abs(last - hard[0]) < 1e-3
    assert pixels_of(view, (1.0, 1.0, 1.0)) == white
    # Beside all strokes nothing happens.
    assert directionfields.toggle_stroke((1, 1)) is None and not messages, messages
    for wrong in ((strokes, 0, 1.5), (strokes, 7, 0.5)):
        try:
            directionfields.set_stroke_strength(*wrong)
            assert False, wrong
        except ValueError as problem:
            assert "0 to 1" in str(problem) or "no stroke 7" in str(problem)
    # A number that comes again is hard.
    assert directionfields.toggle_stroke((x, y + 70)) == (strokes, 1, 0.5)
    state = os.path.join(output_directory, "TestSoft.pvsm")
    simple.SaveState(state)
    summary = caption(field)
    assert directionfields.remove_stroke((x, y + 70)) and not len(strokes.Strengths)
    simple.ResetSession()
    simple.LoadState(state)
    strokes, field = (next(one for one in simple.GetSources().values() if one.GetXMLName() == kind)
                      for kind in ("SurfaceStrokes", "DirectionField"))
    assert list(strokes.Strengths) == [1.0, 0.5] and caption(field) == summary
    # Of older versions, there are neither strengths at the field nor colors at the picture.
    view = simple.GetRenderViews()[0]
    simple.SetActiveView(view)
    field.GuidanceStrengths = "None"
    strokes.Strengths = []
    simple.GetRepresentation(strokes, view).ColorArrayName = ["POINTS", ""]
    simple.Render(view)
    hard = away_from(field, 0)
    directionfields.set_stroke_strength(strokes, 0, 0.5)
    assert field.GuidanceStrengths == "GuidanceStrengths" and away_from(field, 0) > hard + 1.0
    assert pixels_of(view, (1.0, 1.0, 1.0)) > 50 and not messages, messages
    simple.ResetSession()


def directions(field):
    return vtk_to_numpy(servermanager.Fetch(field).GetPointData().GetArray("Direction0"))


def test_previews():
    """On a large surface the field along a stroke, a further one, a soft one and one less is a preview
    until the hand rests, and then the one that comes without; neither a state nor a script has any."""
    view = new_view()
    source = simple.Plane(XResolution=150, YResolution=140)
    simple.Show(source, view)
    simple.ResetCamera(view)
    x, y = middle(view, source)
    first, second = ([(x - 60, y + at), (x + 60, y + at + rise)] for at, rise in ((-40, 30), (45, 0)))
    strokes = preview.previewed(directionfields.draw_stroke, first)
    field = next(one for one in simple.GetSources().values() if one.GetXMLName() == "DirectionField")
    assert preview.is_preview(field) and ", a preview" in caption(field), caption(field)
    preview.finish()
    simple.Render(view)
    assert "preview" not in caption(field), caption(field)
    for change, arguments in (("draw_stroke", [second]), ("toggle_stroke", [(x, y + 45)]),
                              ("remove_stroke", [(x, y - 25)])):
        before = list(strokes.Points), list(strokes.Strengths)
        preview.previewed(getattr(directionfields, change), *arguments)
        assert (list(strokes.Points), list(strokes.Strengths)) != before, change
        assert preview.is_preview(field) and ", a preview" in caption(field), caption(field)
        state = os.path.join(output_directory, "TestPreview.pvsm")
        simple.SaveState(state)
        with open(state, encoding="utf8") as file:
            assert '"Preview"' not in file.read()
        early = directions(field).copy()
        preview.finish()
        simple.Render(view)
        assert not preview.is_preview(field) and "preview" not in caption(field), caption(field)
        late = directions(field).copy()
        # One stroke that is straight leaves the same field to both.
        assert change == "remove_stroke" or np.abs(early - late).max() > 1e-3, change
        other = DirectionField(Input=field.Input, UnitLength=1, ConstrainGuidance=1,
                               GuidanceStrengths="GuidanceStrengths")
        assert (directions(other) == late).all(), change
        simple.Delete(other)
    # A script has nobody who ends its previews, and small surfaces need none.
    directionfields.draw_stroke(first)
    assert not preview.is_preview(field)
    preview.previewed(directionfields.draw_stroke, second)
    directionfields.remesh_active()
    assert not preview.is_preview(field)
    simple.ResetSession()
    assert not messages, messages


window = Messages.collect(messages)
try:
    test_soft()
    test_previews()
finally:
    vtkOutputWindow.SetInstance(window)
print("passed")
