# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Singularities edited over a view: TestSingularities.py PLUGIN MESH OUTDIR"""
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import Messages

plugin, mesh, output = sys.argv[1:4]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields
from directionfields import singularities as room
from directionfields.strokes import Screen

SIZE = [800, 600]
messages = []


def view_of(source):
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    simple.Show(source, view)
    simple.SetActiveSource(source)
    simple.ResetCamera(view)
    simple.Render(view)
    return view


def bunny():
    source = simple.PLYReader(registrationName="bunny", FileNames=[mesh])
    return source, view_of(source)


def singularities(edit):
    data = servermanager.Fetch(edit, idx=1)
    index = vtk_to_numpy(data.GetPointData().GetArray("SingularityIndex"))
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float), index


def directions(source):
    data = servermanager.Fetch(source)
    return vtk_to_numpy(data.GetPointData().GetArray("Direction0")).astype(float)


def seen_handle(hand, sign):
    """A handle that is not near another one, and its pixel."""
    pixels = Screen(hand.view).pixels(hand.rows[:, :3])
    gaps = np.linalg.norm(pixels[:, None] - pixels[None], axis=2) + 1e9 * np.eye(len(pixels))
    known = [k for k in range(len(pixels))
             if hand.seen[k] and np.sign(hand.rows[k, 3]) == sign and gaps[k].min() > 15.0]
    return known[0], pixels[known[0]]


def test_hand():
    """Each step changes the list, and the field has it; the rest of the field stays."""
    source, view = bunny()
    assert room.begin() == "" and not messages, messages
    edit = simple.GetActiveSource()
    assert edit.GetXMLName() == "EditSingularities" and edit.Objective == "Least Change"
    assert len(edit.SingularityList) == 0
    handles = room._handles
    hand = handles.hand
    field = edit.Input
    # To begin with it is the field itself.
    assert np.array_equal(directions(edit), directions(field))
    assert 5 < hand.seen.sum() < len(hand.rows), hand.seen
    number, pixel = seen_handle(hand, 1)
    assert room.hover(*pixel).startswith("Singularity of index +1/4"), room.hover(*pixel)
    assert room.press(*pixel).startswith("+") and handles.held == number
    before = hand.rows.copy()
    for step in range(1, 5):
        answer = room.drag(*(pixel + [0.0, 5.0 * step]))
        assert answer.startswith("Singularity"), answer
        rows = np.array(list(edit.SingularityList)).reshape(-1, 4)
        assert np.abs(Screen(view).pixels(rows[number:number + 1, :3]) -
                      (pixel + [0.0, 5.0 * step])).max() < 1.0
    room.drop()
    others = np.arange(len(before)) != number
    assert np.array_equal(rows[others], before[others]) and rows[number, 3] == before[number, 3]
    places, index = singularities(edit)
    assert len(places) == len(before) and index.sum() == 8
    edge = 0.02 * np.linalg.norm(np.ptp(before[:, :3], axis=0))
    assert np.linalg.norm(places - rows[number, :3], axis=1).min() < edge

    # Off the surface it stays where it was.
    room.press(*(pixel + [0.0, 20.0]))
    assert "no surface" in room.drag(1.0, 1.0)
    assert np.array_equal(np.array(list(edit.SingularityList)).reshape(-1, 4), rows)
    room.drop()

    count = len(rows)
    middle = Screen(view).pixels(
        np.array(source.GetDataInformation().GetBounds()).reshape(3, 2).mean(axis=1)[None])[0]
    said = room.add(*middle, -1, True)
    assert said == "" and len(edit.SingularityList) // 4 == count + 2, said
    places, index = singularities(edit)
    assert len(places) == count + 2 and index.sum() == 8
    said = room.add(*middle, 1, False)
    assert "add up to 8, and have to" in said and len(edit.SingularityList) // 4 == count + 2
    said = room.merge(*middle)
    assert "both are gone" in said, said
    assert len(edit.SingularityList) // 4 == count
    assert "no singularity under" in room.merge(1, 1)
    room.end()
    assert not messages, messages

    # In a state.
    state = os.path.join(output, "TestSingularities.pvsm")
    simple.SaveState(state)
    rows, given = list(edit.SingularityList), directions(edit)
    simple.ResetSession()
    simple.LoadState(state)
    edit = simple.FindSource("Edited field of bunny")
    assert np.allclose(list(edit.SingularityList), rows)
    assert np.allclose(directions(edit), given, atol=1e-6)
    # And without the list it is the field again.
    edit.SingularityList = []
    assert np.array_equal(directions(edit), directions(edit.Input))
    simple.ResetSession()


def test_script():
    """The steps as functions, and a list by hand."""
    source = simple.Sphere(ThetaResolution=48, PhiResolution=32)
    view = view_of(source)
    simple.SetActiveSource(source)
    x, y = Screen(view).pixels(np.zeros((1, 3)))[0]
    assert directionfields.add_singularities((x, y)) == "", directionfields.add_singularities((x, y))
    edit = simple.FindSource("Edited field of Sphere1") or [
        one for one in simple.GetSources().values() if one.GetXMLName() == "EditSingularities"][0]
    simple.SetActiveSource(edit)
    count = len(edit.SingularityList) // 4
    assert directionfields.move_singularity(count - 2, (x + 60.0, y + 20.0)) == ""
    moved = np.array(edit.SingularityList[4 * (count - 2):4 * (count - 2) + 3])
    assert np.abs(Screen(view).pixels(moved[None])[0] - [x + 60.0, y + 20.0]).max() < 1.0
    assert "gone" in directionfields.merge_singularity(count - 1)
    assert not messages, messages

    # A list that no field can have keeps the field, and the caption says why.
    edit.SingularityList = [0.0, 0.0, 0.5, 1.0]
    edit.UpdatePipeline()
    assert np.array_equal(directions(edit), directions(edit.Input))
    data = servermanager.Fetch(edit).GetFieldData()
    assert "cannot be met" in data.GetAbstractArray("Summary").GetValue(0)
    assert "add up to 1, but" in data.GetAbstractArray("Warnings").GetValue(0)
    assert all("add up to 1" in text for text in messages), messages
    del messages[:]
    simple.ResetSession()


def test_boundary():
    """A free boundary lets indices in and out; a drag over it stays on the surface."""
    source = simple.Plane(XResolution=30, YResolution=30)
    view = view_of(source)
    assert room.begin() == ""
    edit = simple.GetActiveSource()
    x, y = Screen(view).pixels(np.zeros((1, 3)))[0]
    assert room.add(x + 3.0, y + 2.0, 1, False) == ""
    assert len(edit.SingularityList) == 4
    room.press(x + 3.0, y + 2.0)
    for reach in (30.0, 100.0, 1000.0):
        room.drag(x + 3.0 + reach, y)
    room.drop()
    place = np.array(edit.SingularityList[:3])
    assert np.abs(place).max() <= 0.5 and place[0] > 0.05, place
    pixel = Screen(view).pixels(place[None])[0]
    assert "left through the boundary" in room.merge(*pixel)
    assert edit.SingularityList[3] == 0.0 and singularities(edit)[1].size == 0
    room.end()
    assert not messages, messages
    simple.ResetSession()


def test_bad():
    """Nothing there, lines, blocks, a filter that goes: a sentence, and no error."""
    # The one of the session before is not forgotten by itself.
    simple.SetActiveSource(None)
    assert "no mesh" in room.begin() and any("no mesh" in text for text in messages), messages
    del messages[:]
    for source in (simple.Line(), simple.PointSource()):
        simple.SetActiveSource(source)
        assert room.begin() and any(text.startswith(room.BUTTON) for text in messages), messages
        del messages[:]
    assert room.hover(3, 3) == room.drag(3, 3) == room.drop() == room.refresh() == ""
    simple.ResetSession()
    group = simple.GroupDatasets(Input=[simple.Sphere(), simple.Sphere(Center=[2, 0, 0])])
    view = view_of(group)
    assert room.begin() == "", room.begin()
    edit = simple.GetActiveSource()
    hand = room._handles.hand
    assert hand.rows[:, 3].sum() == 16
    number, pixel = seen_handle(hand, 1)
    other = np.sign(1.0 - hand.rows[number, 0])
    target = Screen(view).pixels(np.array([[1.0 + other, 0.0, 0.0]]))[0]
    assert room.press(*pixel).startswith("+")
    assert "cannot go there" in room.drag(*target)
    room.drag(*(pixel + [3.0, 3.0]))
    assert len(edit.SingularityList) == 4 * len(hand.rows)
    room.drop()
    for source in reversed(directionfields.pipeline.sources()):
        simple.Delete(source)
    assert room.hover(*pixel) == room.refresh() == room.add(*pixel, 1, True) == ""
    assert not messages, messages


window = Messages.collect(messages)
try:
    for test in (test_hand, test_script, test_boundary, test_bad):
        if len(sys.argv) < 5 or test.__name__ in sys.argv[4:]:
            test()
finally:
    from vtkmodules.vtkCommonCore import vtkOutputWindow
    vtkOutputWindow.SetInstance(window)
print("passed")
