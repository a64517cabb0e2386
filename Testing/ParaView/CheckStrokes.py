# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playback of the same name. Checks what the mouse has
drawn in the ParaView window."""
import functools
import os
import sys
import time

from paraview import servermanager
from paraview.simple import *
# The modules of plugins are known once ParaView's own are.
from directionfields import preview

sys.path.insert(0, os.environ["HOME"])
import Steps


def camera(view):
    return " ".join(f"{x:.6g}" for x in view.GetActiveCamera().GetPosition())


def start(view):
    Render(view)
    os.environ["DIRECTIONFIELDS_TEST_CAMERA"] = camera(view)


def check_lines(view, number):
    """The strokes, the field along them, and the camera as it was."""
    strokes, field = FindSource("Strokes on bunny.ply"), FindSource("Field of bunny.ply")
    assert servermanager.Fetch(strokes).GetNumberOfLines() == number, list(strokes.Points)
    assert field.Input.GetXMLName() == "GuidanceFromCurves" and field.ConstrainGuidance
    assert field.Input.Curves == strokes
    for shown in (strokes, FindSource("Glyphs of bunny.ply"), OutputPort(field, 1)):
        assert GetRepresentation(shown, view).Visibility, shown.GetXMLName()
    assert not GetRepresentation(FindSource("bunny.ply"), view).Visibility
    assert GetActiveSource() == field and len(GetSources()) == 7, list(GetSources())
    assert camera(view) == os.environ["DIRECTIONFIELDS_TEST_CAMERA"], camera(view)


def check_kept(view):
    check_lines(view, 2)
    SaveScreenshot(os.path.join(os.environ["DIRECTIONFIELDS_TEST_OUTPUT"], "Strokes.png"), view,
                   ImageResolution=[800, 600])


def check_selected(view):
    check_lines(view, 2)
    assert FindSource("Strokes on bunny.ply").SMProxy.GetSelectionInput(0)


def check_soft(view):
    """A double click has made the first stroke soft, and another one of the field."""
    check_lines(view, 2)
    strokes = FindSource("Strokes on bunny.ply")
    assert list(strokes.Strengths) == [0.0, 0.5], list(strokes.Strengths)
    assert FindSource("Field of bunny.ply").GuidanceStrengths == "GuidanceStrengths"
    strengths = servermanager.Fetch(strokes).GetCellData().GetArray("Strength")
    assert [strengths.GetValue(k) for k in (0, 1)] == [0.5, 1.0]
    SaveScreenshot(os.path.join(os.environ["DIRECTIONFIELDS_TEST_OUTPUT"], "SoftStroke.png"), view,
                   ImageResolution=[800, 600])


def check_hard(view):
    check_lines(view, 2)
    assert not len(FindSource("Strokes on bunny.ply").Strengths)


def check_off(view):
    """With drawing switched off, the camera turns."""
    assert camera(view) != os.environ["DIRECTIONFIELDS_TEST_CAMERA"]
    os.environ["DIRECTIONFIELDS_TEST_CAMERA"] = camera(view)
    check_lines(view, 2)


def follow_previews():
    """From now on surfaces of any size have previews, and what becomes of these is written down."""
    put = preview.put

    def noted(field, value):
        preview.values.append(value)
        put(field, value)
    preview.values, preview.put, preview.LARGE = [], noted, 0


def wait():
    """Until the hand has rested; the timer is heard before the next step."""
    assert preview.values == [1], preview.values
    time.sleep(1.0)


def check_finished(view):
    assert preview.values == [1, 0], preview.values
    check_lines(view, 3)


steps = (start, functools.partial(check_lines, number=1), check_kept, check_selected, check_hard, check_soft,
         functools.partial(check_lines, number=2), check_off)
Steps.take_next([functools.partial(check, GetActiveView()) for check in steps] +
                [follow_previews, wait, lambda: None,
                 functools.partial(check_finished, GetActiveView())])
