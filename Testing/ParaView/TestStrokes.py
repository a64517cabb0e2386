# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strokes drawn over a view: TestStrokes.py PLUGIN MESH OUTDIR"""
import functools
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

import Messages

plugin, mesh, output_directory = sys.argv[1:4]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields
from directionfields import laying, strokes as room
from directionfields.laying import Screen

import StrokeChecks
from StrokeChecks import SIZE, caption, middle, names, new_view, points_of

messages = []
pixels_of = functools.partial(
    StrokeChecks.pixels_of, os.path.join(output_directory, "TestStrokes.png"))


def bunny():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    source = simple.PLYReader(registrationName="bunny", FileNames=[mesh])
    simple.Show(source, view)
    simple.SetActiveSource(source)
    simple.ResetCamera(view)
    simple.Render(view)
    return source, view


def distances(points, source):
    data = servermanager.Fetch(source)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    found, cell, part, square, all_of = [0.0] * 3, mutable(0), mutable(0), mutable(0.0), []
    for point in points:
        locator.FindClosestPoint(point, found, cell, part, square)
        all_of.append(float(square) ** 0.5)
    return np.array(all_of)


def check_follows(field):
    """Where the strokes are, one of the directions is theirs."""
    data = servermanager.Fetch(field).GetPointData()
    weights = vtk_to_numpy(data.GetArray("GuidanceWeights"))
    on = weights > 0.5
    assert on.sum() > 10, on.sum()
    wanted = vtk_to_numpy(data.GetArray("GuidanceVectors"))[on].astype(float)
    wanted /= np.linalg.norm(wanted, axis=1)[:, None]
    degree = field.Degree
    best = np.full(len(wanted), -1.0)
    for k in range(degree):
        given = vtk_to_numpy(data.GetArray(f"Direction{k}"))[on].astype(float)
        given /= np.linalg.norm(given, axis=1)[:, None]
        best = np.maximum(best, (given * wanted).sum(axis=1))
    assert np.median(best) > 0.999 and best.min() > 0.95, (np.median(best), best.min())


def test_first():
    """A stroke on a mesh makes the pipeline; another one only changes it; both can go."""
    source, view = bunny()
    x, y = middle(view, source)
    strokes = directionfields.draw_stroke([(x - 60, y - 40), (x, y), (x + 70, y + 10)])
    assert not messages, messages
    made = names()
    assert made == sorted(["PLYReader", "SurfaceStrokes", "GuidanceFromCurves", "DirectionField",
                           "DirectionFieldGlyphs", "ShadedSurface", "PythonAnnotation"]), made
    field = simple.GetActiveSource()
    assert field.GetXMLName() == "DirectionField" and field.UnitLength
    assert simple.FindSource("Field of bunny").SMProxy == field.SMProxy, list(simple.GetSources())
    check_follows(field)
    line, = points_of(strokes)
    bounds = np.array(source.GetDataInformation().GetBounds()).reshape(3, 2)
    diagonal = np.linalg.norm(bounds[:, 1] - bounds[:, 0])
    away = distances(line, source) / diagonal
    assert 0.001 < away.min() and away.max() < 0.0021, (away.min(), away.max())
    ends = room.Screen(view).pixels(line[[0, -1]])
    assert np.abs(ends - [(x - 60, y - 40), (x + 70, y + 10)]).max() < 1.5, ends
    assert simple.GetRepresentation(strokes, view).Visibility
    assert not simple.GetRepresentation(source, view).Visibility

    again = directionfields.draw_stroke([(x - 30, y - 60), (x + 50, y - 40)])
    assert again.SMProxy == strokes.SMProxy and names() == made, names()
    assert len(points_of(strokes)) == 2, points_of(strokes)
    check_follows(field)
    # Near the first one.
    assert directionfields.remove_stroke((x + 3, y + 2))
    rest, = points_of(strokes)
    assert np.abs(room.Screen(view).pixels(rest[:1]) - [(x - 30, y - 60)]).max() < 1.5
    # None is near, hence the last one; the field is free again.
    assert directionfields.remove_stroke((1, 1))
    assert "SurfaceStrokes" not in names() and "GuidanceFromCurves" not in names(), names()
    assert field.Input.SMProxy == source.SMProxy and not field.ConstrainGuidance
    assert not messages, messages
    assert not directionfields.remove_stroke((1, 1))
    assert len(messages) == 1 and "There are no strokes" in messages.pop(), messages
    simple.ResetSession()


def test_select():
    """A click selects a stroke without another computation, and the selected one is what goes."""
    view = new_view()
    source = sphere(view)
    simple.SetActiveSource(source)
    x, y = middle(view, source)
    strokes = directionfields.draw_stroke([(x - 50, y), (x + 50, y)])
    directionfields.draw_stroke([(x - 50, y + 40), (x + 50, y + 40)])
    output = simple.GetActiveSource().GetClientSideObject().GetOutputDataObject(0)
    before = output.GetMTime()
    # Between two of its points.
    assert directionfields.select_stroke((x + 3, y + 2)) == (strokes, 0)
    # What ParaView's window expects.
    assert strokes.SMProxy.GetSelectionInput(0).GetXMLName() == "AppendSelections"
    assert output.GetMTime() == before
    magenta = (1.0, 0.0, 1.0)
    assert pixels_of(view, magenta) > 100
    assert directionfields.select_stroke((1, 1)) is None and pixels_of(view, magenta) == 0
    assert directionfields.select_stroke((x, y + 1)) == (strokes, 0)
    # However near the mouse is to the other one.
    assert directionfields.remove_stroke((x, y + 40))
    assert set(list(strokes.Points)[0::4]) == {1.0} and pixels_of(view, magenta) == 0
    assert directionfields.remove_stroke((x, y + 40)) and "SurfaceStrokes" not in names()
    assert directionfields.select_stroke((x, y)) is None and not messages, messages
    simple.ResetSession()


def test_parts():
    """A stroke ends where it leaves the surface or what it is on hides what is behind; it is never
    behind the surface."""
    source, view = bunny()
    x, y = middle(view, source)
    strokes = directionfields.draw_stroke([(0, y + 100), (SIZE[0] - 1, y + 100), (x, y), (0, y)])
    lines = points_of(strokes)
    assert len(lines) > 1, len(lines)
    screen = room.Screen(view)
    surface = laying.Surface(source)
    for line in lines:
        steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
        assert steps.max() < 8.0 * np.median(steps) or steps.max() < 0.6, steps
        for point, pixel in zip(line, screen.pixels(line)):
            ray = screen.ray(pixel)
            seen = surface.hit(ray)
            # Smoothing moves points by less than a step.
            assert seen is None or np.linalg.norm(seen - point) < 0.5, (seen, point)
    assert not messages, messages
    simple.ResetSession()


def test_moved():
    """A mesh that has changed is drawn on as it is now."""
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    source = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    simple.Show(source, view)
    simple.ResetCamera(view)
    simple.SetActiveSource(source)
    x, y = middle(view, source)
    for radius in (0.5, 0.4):
        source.Radius = radius
        strokes = directionfields.draw_stroke([(x - 50, y), (x + 50, y + 5)])
        lengths = np.linalg.norm(points_of(strokes)[-1], axis=1)
        assert np.abs(lengths / radius - 1.0).max() < 0.02, (radius, lengths)
    assert not messages, messages
    simple.ResetSession()


def test_given():
    """A field that is there takes the strokes and keeps its properties; quads of it follow."""
    source, view = bunny()
    field = directionfields.show(source, degree=4, view=view, UnitLength=1, EnergyBias=0.25).field
    quads = FieldAlignedRemesh(Input=field, NumberOfFaces=1500, KeepThinParts=0)
    before = servermanager.Fetch(quads).GetPoint(7)
    x, y = middle(view, source)
    simple.SetActiveSource(quads)
    strokes = directionfields.draw_stroke([(x - 60, y - 40), (x + 70, y + 30)])
    assert not messages, messages
    assert names().count("DirectionField") == 1, names()
    assert field.EnergyBias == 0.25 and field.Input.GetXMLName() == "GuidanceFromCurves"
    check_follows(field)
    assert servermanager.Fetch(quads).GetPoint(7) != before

    # In a state, and there to go on with.
    state = os.path.join(output_directory, "TestStrokes.pvsm")
    simple.SaveState(state)
    rows, summary = list(strokes.Points), caption(field)
    simple.ResetSession()
    simple.LoadState(state)
    strokes, field = simple.FindSource("Strokes on bunny"), simple.FindSource("Field of bunny")
    assert np.allclose(list(strokes.Points), rows) and caption(field) == summary
    simple.SetActiveView(simple.GetRenderViews()[0])
    simple.SetActiveSource(field)
    again = directionfields.draw_stroke([(x - 30, y - 60), (x + 50, y - 40)])
    assert again.SMProxy == strokes.SMProxy and len(points_of(again)) == 2
    simple.ResetSession()


def sphere(view, **properties):
    source = simple.Sphere(ThetaResolution=24, PhiResolution=16, **properties)
    simple.Show(source, view)
    simple.ResetCamera(view)
    simple.Render(view)
    return source


def test_nearest():
    """The nearest mesh is drawn on, whatever is selected, and never a hidden one. Strokes end where
    it hides another mesh."""
    view = new_view()
    back, front = sphere(view), sphere(view, Center=[0.3, 0.0, 2.0], Radius=0.2)
    simple.ResetCamera(view)
    simple.Render(view)
    simple.SetActiveSource(back)
    x, y = middle(view, front)
    strokes = directionfields.draw_stroke([(x - 20, y), (x + 20, y + 5)])
    assert distances(points_of(strokes)[0], front).max() < 0.01
    for shown in list(view.Representations):
        shown.Visibility = 0
    simple.Show(back, view)
    simple.Render(view)
    simple.SetActiveSource(front)
    strokes = directionfields.draw_stroke([(x - 20, y), (x + 20, y + 5)])
    assert distances(points_of(strokes)[0], back).max() < 0.01
    # Only what is seen of the mesh behind.
    simple.Show(front, view)
    simple.Render(view)
    xs, ys = middle(view, back)
    again = directionfields.draw_stroke([(xs - 100, ys), (x + 300, ys)])
    assert again.SMProxy == strokes.SMProxy and not messages, messages
    screen = room.Screen(view)
    for line in points_of(strokes)[1:]:
        for pixel in screen.pixels(line):
            inside = laying.Surface(front).hit(screen.ray(pixel))
            assert inside is None or np.hypot(*(pixel - [x, y])) > 20.0, (pixel, x, y)
    simple.ResetSession()


def test_views():
    """What another view shows stays; where none is near, the stroke that was drawn last goes."""
    lines = []
    for _ in range(2):
        view = new_view()
        source = sphere(view)
        simple.SetActiveSource(source)
        x, y = middle(view, source)
        lines.append(directionfields.draw_stroke([(x - 50, y), (x + 50, y + 5)]))
    assert directionfields.remove_stroke((x, y + 2))
    assert len(points_of(lines[0])) == 1 and "SurfaceStrokes" in names()
    assert not directionfields.remove_stroke((x, y + 2)), names()
    assert "no strokes in this view" in messages.pop() and not messages
    simple.ResetSession()

    view = new_view()
    meshes = [sphere(view), sphere(view, Center=[1.5, 0.0, 0.0])]
    simple.ResetCamera(view)
    simple.Render(view)
    made = []
    for mesh in meshes + meshes[:1]:
        x, y = middle(view, mesh)
        made.append(directionfields.draw_stroke([(x - 50, y), (x + 50, y + 5)]))
    assert made[0].SMProxy == made[2].SMProxy != made[1].SMProxy and not messages, messages
    assert directionfields.remove_stroke((1, 1))
    assert [len(points_of(one)) for one in made[:2]] == [1, 1]
    simple.ResetSession()


def test_used():
    """Strokes that are an input of other filters are emptied, and then drawn on again."""
    view = new_view()
    source = sphere(view)
    simple.SetActiveSource(source)
    x, y = middle(view, source)
    strokes = directionfields.draw_stroke([(x - 50, y), (x + 50, y + 5)])
    field = simple.GetActiveSource()
    quads = FieldAlignedRemesh(Input=field, NumberOfFaces=200, KeptCurves=strokes)
    assert directionfields.remove_stroke((x, y + 2))
    assert quads.KeptCurves.SMProxy == strokes.SMProxy and not len(strokes.Points)
    assert "GuidanceFromCurves" not in names() and not field.ConstrainGuidance
    simple.SetActiveSource(field)
    again = directionfields.draw_stroke([(x - 50, y), (x + 50, y - 5)])
    assert again.SMProxy == strokes.SMProxy and len(points_of(again)) == 1 and not messages, messages
    check_follows(field)
    simple.ResetSession()


def test_selected():
    """Of two fields of a mesh the selected one takes the stroke."""
    view = new_view()
    source = sphere(view)
    fields = [directionfields.show(DirectionField(Input=source, Degree=degree), view=view).field
              for degree in (4, 2)]
    x, y = middle(view, source)
    simple.SetActiveSource(fields[0])
    assert directionfields.draw_stroke([(x - 50, y), (x + 50, y + 5)]) and not messages, messages
    assert [field.ConstrainGuidance for field in fields] == [1, 0]
    simple.SetActiveSource(fields[1])
    assert directionfields.draw_stroke([(x - 50, y), (x + 50, y + 5)]) and not messages, messages
    assert [len(points_of(field.Input.Curves)) for field in fields] == [1, 1]
    simple.ResetSession()


def test_late():
    """A failure when all is drawn already leaves field and strokes as they were."""
    view = new_view()
    source = sphere(view)
    field = directionfields.show(source, view=view).field
    x, y = middle(view, source)
    show = room.show

    def fail(*_):
        raise RuntimeError("no picture")
    for count in (0, 1):
        def state():
            strokes = [one for one in simple.GetSources().values()
                       if one.GetXMLName() == "SurfaceStrokes"]
            return ([list(one.Points) for one in strokes], field.Input.GetXMLName(),
                    list(field.GuidanceVectors), list(field.GuidanceWeights),
                    field.ConstrainGuidance)
        before = state()
        room.show = fail
        refuse("no picture", [(x - 50, y), (x + 50, y + 5)], view)
        room.show = show
        assert state() == before and len(before[0]) == count, (state(), before)
        field.UpdatePipeline()
        assert not messages, messages
        if not count:
            assert directionfields.draw_stroke([(x - 50, y), (x + 50, y + 5)])
    simple.ResetSession()


def refuse(words, path, view):
    before = names(), sum(display.Visibility for display in view.Representations)
    assert directionfields.draw_stroke(path) is None
    assert len(messages) == 1 and messages[0].startswith("Draw strokes: "), messages
    assert words in messages[0] and messages.pop().count("\n") == 1, words
    assert before == (names(), sum(display.Visibility for display in view.Representations))


def test_refused():
    """What cannot be drawn on gets a sentence, and leaves nothing behind."""
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    simple.Render(view)
    across = [(100, 300), (700, 300)]
    refuse("no surface under the stroke", across, view)
    line = simple.Line()
    simple.Show(line, view)
    simple.ResetCamera(view)
    refuse("no surface under the stroke", across, view)
    simple.Delete(line)
    source, view = bunny()
    refuse("no surface under the stroke", [(1, 1), (1, 30)], view)
    refuse("Drag the mouse", [(400, 300)], view)
    simple.ResetSession()
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    source = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    directionfields.show(source, view=view, Alignment="Point Vectors", GuidanceVectors="Normals")
    x, y = middle(view, source)
    del messages[:]
    refuse("follows other vectors already", [(x - 30, y), (x + 30, y)], view)
    simple.ResetSession()


def constrained_in_blocks(field):
    """How many points of each block the guidance constrains."""
    data = servermanager.Fetch(field)
    blocks = [data.GetBlock(k) for k in range(data.GetNumberOfBlocks())]
    return [int((vtk_to_numpy(block.GetPointData().GetArray("GuidanceWeights")) > 0).sum())
            for block in blocks]


def test_one_of_blocks():
    """A stroke guides the block that it is drawn on, and no other one, whatever the order."""
    for centers in ([0, 2], [2, 0]):
        view = simple.CreateView("RenderView")
        view.ViewSize = SIZE
        source = simple.GroupDatasets(Input=[
            simple.Sphere(Center=[x, 0, 0], ThetaResolution=24, PhiResolution=16)
            for x in centers])
        simple.Show(source, view)
        simple.ResetCamera(view)
        simple.SetActiveSource(source)
        guided = None
        for k, x in enumerate(centers):
            (px, py), = Screen(view).pixels(np.array([[float(x), 0.0, 0.0]]))
            assert directionfields.draw_stroke([(px - 40, py - 20), (px + 40, py + 20)])
            before, guided = guided, constrained_in_blocks(simple.GetActiveSource())
            assert guided[k] > 2 and (guided[1 - k] == 0 if k == 0 else
                                      guided[0] == before[0]), (centers, before, guided)
        assert not messages, messages
        for source in reversed(directionfields.pipeline.sources()):
            simple.Delete(source)
        simple.Delete(view)


def test_blocks():
    """Several blocks, and data whose surface is taken."""
    for make in (lambda: simple.GroupDatasets(Input=[
            simple.Sphere(ThetaResolution=24, PhiResolution=16), simple.Sphere(Center=[2, 0, 0])]),
                 lambda: simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])):
        view = simple.CreateView("RenderView")
        view.ViewSize = SIZE
        source = make()
        simple.Show(source, view)
        simple.ResetCamera(view)
        simple.SetActiveSource(source)
        x, y = middle(view, source)
        strokes = directionfields.draw_stroke([(x - 200, y - 20), (x + 200, y + 20)])
        assert strokes is not None and not messages, messages
        for source in reversed(directionfields.pipeline.sources()):
            simple.Delete(source)
        simple.Delete(view)


window = Messages.collect(messages)
try:
    test_first()
    test_select()
    test_parts()
    test_moved()
    test_given()
    test_refused()
    test_nearest()
    test_views()
    test_used()
    test_selected()
    test_late()
    test_one_of_blocks()
    test_blocks()
finally:
    vtkOutputWindow.SetInstance(window)
print("passed")
