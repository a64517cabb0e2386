# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playback of the same name. Checks what the button and
the menu entry "Show direction field" have built in the ParaView window."""
import os
import sys

from paraview.simple import *

sys.path.insert(0, os.environ["HOME"])
import Steps

output = os.environ["DIRECTIONFIELDS_TEST_OUTPUT"]


def shown(proxy, view):
    display = GetRepresentation(proxy, view)
    return display is not None and display.Visibility == 1


def camera(view):
    return " ".join(f"{x:.6g}" for x in view.GetActiveCamera().GetPosition())


def start(view):
    """The user looks at the mesh from some side."""
    Render(view)
    view.GetActiveCamera().Azimuth(40.0)
    Render(view)
    os.environ["DIRECTIONFIELDS_TEST_CAMERA"] = camera(view)


def check_picture(view):
    field = GetActiveSource()
    assert field.GetXMLName() == "DirectionField", field.GetXMLName()
    assert field.Input.GetXMLName() == "PLYReader", field.Input.GetXMLName()
    assert not shown(field.Input, view)
    balls = GetRepresentation(OutputPort(field, 1), view)
    assert balls.Visibility == 1 and balls.Representation == "3D Glyphs"
    glyphs = FindSource("Glyphs of bunny.ply")
    assert glyphs.GetDataInformation().GetNumberOfCells() > 500
    assert shown(glyphs, view) and shown(FindSource("Surface of bunny.ply"), view)
    assert shown(FindSource("Summary of bunny.ply"), view)
    # The camera stays where the user has put it.
    assert camera(view) == os.environ["DIRECTIONFIELDS_TEST_CAMERA"], camera(view)
    # Singularities alone have a legend, and nothing is shown twice.
    bars = [bar for bar in view.Representations
            if bar.GetXMLName() == "ScalarBarWidgetRepresentation" and bar.Visibility]
    assert [bar.Title for bar in bars] == ["Singularities"], [bar.Title for bar in bars]
    visible = [display for display in view.Representations
               if display.Visibility and display.GetProperty("Input") is not None]
    assert len(visible) == 4, [display.Input for display in visible]
    assert len(GetSources()) == 5, list(GetSources())
    SetActiveSource(glyphs)
    SaveScreenshot(os.path.join(output, "Button.png"), view, ImageResolution=[800, 600])


view = GetActiveView()
Steps.take_next([lambda: start(view)] + 2 * [lambda: check_picture(view)])
