# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: checks what the button "Show direction field" has built in the ParaView window."""
import os
import traceback

from paraview.simple import *


def shown(proxy, view):
    display = GetRepresentation(proxy, view)
    return display is not None and display.Visibility == 1


def check():
    view = GetActiveView()
    field = GetActiveSource()
    assert field.GetXMLName() == "DirectionField", field.GetXMLName()
    assert field.Input.GetXMLName() == "PLYReader", field.Input.GetXMLName()
    assert not shown(field.Input, view)
    spheres = GetRepresentation(OutputPort(field, 1), view)
    assert spheres.Visibility == 1 and spheres.Representation == "3D Glyphs"
    glyphs = FindSource("DirectionFieldGlyphs1")
    assert glyphs.GetDataInformation().GetNumberOfCells() > 500
    assert shown(glyphs, view)
    assert shown(FindSource("Surface"), view)
    assert shown(FindSource("Number of singularities"), view)
    # The macro leaves the camera where the user has put it.
    assert list(view.CameraViewUp) == [0.0, 1.0, 0.0], list(view.CameraViewUp)
    SaveScreenshot(os.path.join(output, "Button.png"), view, ImageResolution=[800, 600])


output = os.environ["DIRECTIONFIELDS_TEST_OUTPUT"]
verdict = "passed\n"
try:
    check()
except BaseException:
    verdict = traceback.format_exc()
with open(os.path.join(output, "Button.txt"), "w") as file:
    file.write(verdict)
