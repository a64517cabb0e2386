# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples of the menu Help: TestExamples.py PLUGIN OUTPUT"""
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow

import Messages

plugin, output = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields
from directionfields import examples

messages = []


def source(name):
    """The last filter of a kind."""
    return [one for one in directionfields.pipeline.sources() if one.GetXMLName() == name][-1]


def shown(view, source, port=0):
    display = view.FindRepresentation(source.SMProxy, port)
    return display is not None and servermanager._getPyProxy(display).Visibility == 1


def summary(source):
    data = servermanager.Fetch(source).GetFieldData()
    assert not data.HasArray("Warnings"), data.GetAbstractArray("Warnings").GetValue(0)
    return data.GetAbstractArray("Summary").GetValue(0)


def check_strokes(view):
    """At the points of each stroke one of the four directions runs along it."""
    strokes, field = source("SurfaceStrokes"), source("DirectionField")
    assert shown(view, strokes) and shown(view, source("DirectionFieldGlyphs"))
    lines, data = servermanager.Fetch(strokes), servermanager.Fetch(field)
    assert lines.GetNumberOfLines() == 3 and "points constrained" in summary(field)
    points = vtk_to_numpy(data.GetPoints().GetData())
    direction = vtk_to_numpy(data.GetPointData().GetArray("Direction0")).astype(float)
    rows = np.array(strokes.Points).reshape(-1, 4)
    angles = []
    for before, after in zip(rows[:-2], rows[2:]):
        if before[0] == after[0]:
            nearest = np.argmin(((points - 0.5 * (before + after)[1:]) ** 2).sum(axis=1))
            along = (after - before)[1:] / np.linalg.norm((after - before)[1:])
            angle = np.arccos(np.clip(abs(along @ direction[nearest]), 0.0, 1.0))
            angles.append(min(angle, 0.5 * np.pi - angle))
    assert len(angles) > 40 and np.degrees(np.median(angles)) < 6.0, np.degrees(angles)


def check_part(view):
    """The field runs along the axes on all faces of an L, whose edges do."""
    field = source("DirectionField")
    assert shown(view, source("DirectionFieldGlyphs")) and "singularities" in summary(field)
    directions = vtk_to_numpy(
        servermanager.Fetch(field).GetPointData().GetArray("Direction0")).astype(float)
    # Corners have no plane of their own.
    assert np.mean(np.abs(directions).max(axis=1) > 0.99) > 0.9


def check_stripes(view):
    stripes = source("StripePattern")
    assert shown(view, stripes, 1) and not shown(view, source("DirectionFieldGlyphs"))
    assert servermanager.Fetch(stripes).GetNumberOfLines() > 20, summary(stripes)


def check_quads(view):
    quads = source("FieldAlignedRemesh")
    data = servermanager.Fetch(quads)
    assert shown(view, quads) and shown(view, quads, 1)
    sizes = np.diff(vtk_to_numpy(data.GetPolys().GetOffsetsArray()))
    # Hardly anything but quads, and about as many as it asks for.
    assert np.mean(sizes == 4) > 0.97, np.bincount(sizes)
    assert abs(data.GetNumberOfPolys() - 2000) < 200, summary(quads)


checks = {"Scan with strokes": check_strokes, "Part": check_part, "Stripes": check_stripes,
          "Quads": check_quads}


def test_each():
    """Each one opens without a message, shows what it is about, and leaves earlier ones as they are."""
    assert list(checks) == list(examples.EXAMPLES)
    views = []
    for name, check in checks.items():
        before = {one.SMProxy: [shown(view, one) for view in views]
                  for one in simple.GetSources().values()}
        view = directionfields.open_example(name)
        assert view is not None and not messages, (name, messages)
        assert view not in views and len(simple.GetLayouts()) == len(views) + 1, name
        view.ViewSize = [500, 400]
        check(view)
        assert all(shown_in == [shown(view, one) for view in views]
                   for one, shown_in in ((one, before[one.SMProxy])
                                         for one in simple.GetSources().values()
                                         if one.SMProxy in before))
        views.append(view)
        simple.SaveScreenshot(os.path.join(output, f"Example{name.replace(' ', '')}.png"), view)


def test_states():
    """ParaView opens the files as states, too, and their meshes are beside them."""
    folder = examples.folder_of(plugin)
    for name, file in examples.EXAMPLES.items():
        with open(os.path.join(folder, file)) as state:
            text = state.read()
        assert sum(os.path.exists(os.path.join(folder, part)) for part in text.split('"')
                   if part.endswith((".ply", ".stl"))) >= 1, name
        size = sum(os.path.getsize(os.path.join(folder, one)) for one in os.listdir(folder))
        assert size < 300000, size
    assert examples.example_file("bunny.ply") == os.path.join(folder, "bunny.ply")


def test_refused():
    """A wrong name, and a plugin without its files, leave everything as it was."""
    before = len(simple.GetSources()), len(simple.GetViews()), len(simple.GetLayouts())
    folder, examples.FOLDER = examples.FOLDER, "nowhere"
    assert directionfields.open_example("Part") is None
    assert "There are no examples in" in messages.pop(), messages
    examples.FOLDER = folder
    assert directionfields.open_example("Knot") is None
    assert "no example Knot" in messages.pop(), messages
    # One that fails on its way.
    examples.EXAMPLES["Broken"] = "../broken.py"
    broken = os.path.join(examples.folder_of(plugin), "..", "broken.py")
    with open(broken, "w") as file:
        file.write("from paraview.simple import *\nSphere()\nraise ValueError('It breaks.')\n")
    assert directionfields.open_example("Broken") is None
    os.remove(broken)
    assert "It breaks." in messages.pop() and not messages, messages
    assert before == (len(simple.GetSources()), len(simple.GetViews()), len(simple.GetLayouts()))


window = Messages.collect(messages)
try:
    test_each()
    test_states()
    test_refused()
finally:
    vtkOutputWindow.SetInstance(window)
print("passed")
