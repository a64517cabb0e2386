# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playback of the same name. Checks which examples are open
in the ParaView window."""
import os
import sys

from paraview.simple import *

sys.path.insert(0, os.environ["HOME"])
import Steps


def shown(source, view, port=0):
    display = view.FindRepresentation(source.SMProxy, port)
    return display is not None and display.GetProperty("Visibility").GetElement(0) == 1


def check_quads():
    """Beside the mesh that was there, in a layout of its own."""
    quads = FindSource("Remesh of bunny.ply")
    assert shown(quads, GetActiveView())
    assert len(GetViews()) == len(GetLayouts()) == 2, (GetViews(), GetLayouts())
    assert 1800 < quads.GetDataInformation(0).GetNumberOfCells() < 2200


def check_undone():
    """All of it is one step; the example before stays."""
    assert FindSource("Strokes on bunny.ply") is None, list(GetSources())
    assert FindSource("Remesh of bunny.ply") is not None, list(GetSources())


def check_strokes():
    view = GetActiveView()
    assert shown(FindSource("Strokes on bunny.ply"), view)
    assert FindSource("Field of bunny.ply").ConstrainGuidance
    assert len(GetLayouts()) == 3, GetLayouts()
    SaveScreenshot(os.path.join(os.environ["DIRECTIONFIELDS_TEST_OUTPUT"], "Examples.png"), view)


Steps.take_next([check_quads, check_undone, check_strokes])
