# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playbacks Quads and QuadsByMenu. Checks what the button
"Remesh to quads" has built in the ParaView window."""
import functools
import os
import sys

from paraview import servermanager
from paraview.simple import *

sys.path.insert(0, os.environ["HOME"])
import Steps

output = os.environ["DIRECTIONFIELDS_TEST_OUTPUT"]
saved = os.path.join(output, "Quads.obj")


def remeshes():
    return [source for source in GetSources().values()
            if source.GetXMLName() == "FieldAlignedRemesh"]


def visible(view):
    return [display for display in view.Representations
            if display.Visibility and display.GetProperty("Input") is not None]


def select_mesh():
    SetActiveSource(FindSource("bunny.ply"))


def check_undone(view):
    """One step back undoes the whole picture."""
    assert list(GetSources().values()) == [FindSource("bunny.ply")], list(GetSources())
    assert [display.Input for display in visible(view)] == [FindSource("bunny.ply")]
    if os.path.exists(saved):
        os.remove(saved)
    select_mesh()


def check_picture(view, quads):
    """The quads with their edges and the irregular vertices, and nothing else."""
    assert GetActiveSource() == quads, GetActiveSource()
    surface, balls = GetRepresentation(quads, view), GetRepresentation(OutputPort(quads, 1), view)
    assert sorted(display.SMProxy.GetGlobalID() for display in visible(view)) == sorted(
        display.SMProxy.GetGlobalID() for display in (surface, balls)), visible(view)
    assert surface.Representation == "Surface With Edges" and surface.ShowSummary
    assert balls.Representation == "3D Glyphs" and balls.Visibility
    bars = [bar for bar in view.Representations
            if bar.GetXMLName() == "ScalarBarWidgetRepresentation" and bar.Visibility]
    assert [bar.Title for bar in bars] == ["Valence"], [bar.Title for bar in bars]
    mesh = servermanager.Fetch(quads)
    corners = [mesh.GetCell(k).GetNumberOfPoints() for k in range(mesh.GetNumberOfCells())]
    assert 4000 < len(corners) < 6000 and corners.count(4) > 0.98 * len(corners), len(corners)


def check_mesh(view):
    """Without a field the quads are of the mesh itself."""
    quads, = remeshes()
    assert FindSource("Remesh of bunny.ply") == quads, list(GetSources())
    assert quads.Input == FindSource("bunny.ply") and len(GetSources()) == 2
    check_picture(view, quads)
    SaveScreenshot(os.path.join(output, "QuadsOfMesh.png"), view, ImageResolution=[800, 600])
    select_mesh()


def check_field(view):
    """With a field the quads share it; those of the mesh are hidden."""
    before = FindSource("Remesh of bunny.ply")
    quads, = [remesh for remesh in remeshes() if remesh != before]
    assert quads.Input == FindSource("Field of bunny.ply"), quads.Input
    fields = [source for source in GetSources().values() if source.GetXMLName() == "DirectionField"]
    assert len(fields) == 1, list(GetSources())
    check_picture(view, quads)
    SaveScreenshot(os.path.join(output, "Quads.png"), view, ImageResolution=[800, 600])
    os.environ["DIRECTIONFIELDS_TEST_COUNT"] = str(len(GetSources()))
    select_mesh()


def check_again(view):
    """Nothing is made twice."""
    assert len(GetSources()) == int(os.environ["DIRECTIONFIELDS_TEST_COUNT"]), list(GetSources())
    assert GetActiveSource().Input == FindSource("Field of bunny.ply")
    check_picture(view, GetActiveSource())


def check_saved(view):
    """Pressed on quads that are on show, the button saves them."""
    check_again(view)
    with open(saved) as file:
        faces = [line.split() for line in file if line.startswith("f ")]
    assert len(faces) == GetActiveSource().GetDataInformation().GetNumberOfCells(), len(faces)
    assert sum(len(face) == 5 for face in faces) > 0.98 * len(faces)


steps = (check_undone, check_mesh, check_field, check_again, check_saved)
version = GetParaViewVersion()
if (version.major, version.minor) >= (5, 12):  # QuadsByMenu does not save.
    steps = steps[:-1]
Steps.take_next([functools.partial(check, GetActiveView()) for check in steps])
