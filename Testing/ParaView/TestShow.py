# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module of the plugin: TestShow.py PLUGIN MESH OUTDIR"""
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from Figures import blue, figures, pixels, red
from Views import color_of, picture_of

plugin, mesh, output = sys.argv[1:4]
try:
    import directionfields
    raise AssertionError("The module does not come from the plugin.")
except ImportError:
    pass
simple.LoadPlugin(plugin, remote=False)
import directionfields


def fails(error, text, *arguments, **options):
    try:
        directionfields.show(*arguments, **options)
    except error as problem:
        assert text in str(problem), problem
        return
    raise AssertionError(f"No {error.__name__} says '{text}'.")


def test_errors():
    assert directionfields.show_active() is None
    fails(ValueError, "no mesh", None)
    fails(TypeError, "not int", 7)
    fails(ValueError, "1 to 16", simple.Sphere(), degree=0)
    fails(ValueError, "1 to 16", simple.Sphere(), degree=2.5)
    fails(TypeError, "no property Bias", simple.Sphere(), Bias=1)
    fails(TypeError, "no property Sise", simple.Sphere(), glyphs={"Sise": 1})
    fails(ValueError, "not a .ply", "mesh.stp")
    fails(FileNotFoundError, "no file", "no such mesh.ply")
    fails(TypeError, "render view", simple.Sphere(), view=simple.CreateView("SpreadSheetView"))
    simple.ResetSession()


def test_file():
    shown = directionfields.show(mesh)
    assert shown.field.Degree == 4
    assert shown.field.Input.GetXMLName() == "PLYReader"
    display = {name: simple.GetRepresentation(proxy, shown.view) for name, proxy in (
        ("surface", shown.surface), ("glyphs", shown.glyphs),
        ("singularities", simple.OutputPort(shown.field, 1)))}
    for name, representation in display.items():
        assert representation.Visibility == 1, name
    for name in ("surface", "glyphs"):
        assert display[name].Representation == "Surface", display[name].Representation
        assert not display[name].ColorArrayName[1], name
    assert max(display["surface"].DiffuseColor) - min(display["surface"].DiffuseColor) < 0.1
    glyphs = shown.glyphs.GetDataInformation()
    assert glyphs.GetNumberOfCells() > 500, glyphs.GetNumberOfCells()

    spheres = display["singularities"]
    assert spheres.Representation == "3D Glyphs"
    assert spheres.GlyphType.GetXMLName() == "SphereSource"
    assert (spheres.Scaling, spheres.ScaleMode, spheres.SelectScaleArray) == (
        1, "Magnitude", "Size")
    lookup = spheres.LookupTable
    for index in range(1, 4):
        assert red(*color_of(lookup, index)), index
        assert blue(*color_of(lookup, -index)), -index
    assert shown.legend.Visibility == 1

    # The spheres are in the picture, red and blue, and nothing else there is red or blue.
    path = picture_of(shown.view, "Show.png")
    found = pixels(path, red), pixels(path, blue)
    assert min(found) > 500, found
    simple.Hide(simple.OutputPort(shown.field, 1), shown.view)
    shown.legend.Visibility = 0
    path = picture_of(shown.view, "ShowNoSingularities.png")
    without = pixels(path, red), pixels(path, blue)
    assert max(without) < 20, without
    simple.ResetSession()


def test_options():
    """Properties reach both filters; what follows a change of the field follows it in the
    picture."""
    view = simple.CreateView("RenderView")
    background = list(view.Background)
    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    simple.Show(sphere, view)
    shown = directionfields.show(sphere, 2, view, legend=False, EnergyBias=0.5,
                                 Alignment="Point Vectors", GuidanceVectors="Normals",
                                 glyphs={"MaximumNumberOfGlyphs": 10})
    assert shown.view is view and list(view.Background) == background
    assert shown.legend is None and shown.caption is None
    assert (shown.field.Degree, shown.field.EnergyBias) == (2, 0.5)
    assert shown.field.Alignment == "Point Vectors"
    assert shown.field.GuidanceVectors == "Normals", shown.field.GuidanceVectors
    assert shown.glyphs.MaximumNumberOfGlyphs == 10
    assert simple.GetRepresentation(sphere, view).Visibility == 0
    simple.ResetSession()

    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    field = directionfields.show(sphere, degree=1).field
    assert figures(servermanager.Fetch(field), servermanager.Fetch(field, idx=1))["Total"] == 2
    again = directionfields.show(field)
    assert again.field.SMProxy is field.SMProxy
    again.field.Degree = 6
    again.caption.UpdatePipeline()
    text = servermanager.Fetch(again.caption).GetColumn(0).GetValue(0)
    count = servermanager.Fetch(field, idx=1).GetNumberOfPoints()
    assert text.startswith(f"{count} singularities ({count} +, 0 -), index sum 12"), text
    fails(TypeError, "does not change", field, EnergyBias=1.0)


def visible(view):
    """The names of what a view shows, annotations and legends included."""
    names = []
    for display in view.Representations:
        if display.Visibility:
            source = display.Input if display.GetProperty("Input") is not None else None
            names.append(source.GetXMLName() if source is not None else display.GetXMLName())
    return sorted(names)


def test_active():
    """show_active() finds the field of whatever is selected, shows it once, and hides what it
    replaces."""
    view = simple.CreateView("RenderView")
    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    simple.Show(sphere, view)
    camera = view.CameraPosition = [1.0, 2.0, 3.0]
    simple.SetActiveSource(sphere)
    first = directionfields.show_active()
    assert simple.GetActiveSource().GetXMLName() == "DirectionField"
    assert list(view.CameraPosition) == camera
    count, once = len(simple.GetSources()), visible(view)
    assert "SphereSource" not in once and len(once) == 5, once
    first.field.Degree = 2
    for source in (sphere, first.field, first.glyphs, first.surface, first.caption,
                   simple.OutputPort(first.field, 1)):
        simple.SetActiveSource(source)
        again = directionfields.show_active()
        assert again.field.SMProxy is first.field.SMProxy and again.field.Degree == 2
        assert (len(simple.GetSources()), visible(view)) == (count, once), visible(view)

    # Another field of the same mesh replaces the picture, another view has one of its own.
    other = directionfields.show(sphere, 6, view)
    assert visible(view) == once, visible(view)
    assert simple.GetRepresentation(other.glyphs, view).Visibility == 1
    assert simple.GetRepresentation(first.glyphs, view).Visibility == 0
    beside = simple.CreateView("RenderView")
    directionfields.show(sphere, 1, beside)
    assert visible(view) == visible(beside) == once, (visible(view), visible(beside))

    # Warnings are in the picture.
    other.field.ConstrainBoundary = 1
    other.field.GetClientSideObject().AddObserver("WarningEvent", lambda *_: None)
    lines = servermanager.Fetch(other.caption).GetColumn(0).GetValue(0).split("\n")
    assert lines[1].startswith("Warning: Turn Constrain Boundary off"), lines
    simple.ResetSession()


def test_camera():
    """The camera is placed where ParaView has put it, also for flat data and for other ones than
    those it was put for, and stays where a user has moved it; a view has one caption."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [800, 600]
    plane = simple.Plane()
    simple.Show(plane, view)
    view.InteractionMode = "2D"
    view.ResetCamera()
    before = view.CameraParallelScale
    directionfields.show(plane, view=view)
    assert view.CameraParallelScale < 0.9 * before, (view.CameraParallelScale, before)
    view.InteractionMode = "3D"
    simple.ResetCamera(view)
    large = simple.Sphere(Radius=50.0)
    directionfields.show(large, view=view)
    assert 100.0 < view.CameraPosition[2] < 300.0, view.CameraPosition
    view.GetActiveCamera().Azimuth(30.0)
    moved = view.GetActiveCamera().GetPosition()
    third = directionfields.show(simple.Cone(), view=view)
    assert view.GetActiveCamera().GetPosition() == moved
    captions = [display.Input.GetXMLName() for display in view.Representations
                if display.Visibility and display.GetProperty("Input") is not None]
    assert captions.count("PythonAnnotation") == 1, captions
    assert simple.GetRepresentation(third.caption, view).Visibility == 1
    simple.ResetSession()


def test_legend():
    """A field that comes to have no singularities takes the legend with it, if no other picture has
    balls; it comes back with them, unless the user has hidden it."""
    view = simple.CreateView("RenderView")
    sphere, plane = simple.Sphere(), simple.Plane()
    shown = directionfields.show(sphere, view=view)
    other = directionfields.show(simple.Cone(), view=view)
    assert shown.legend.Visibility == 1
    shown.field.Input = plane
    simple.Render(view)
    assert shown.legend.Visibility == 1
    simple.Hide(simple.OutputPort(other.field, 1), view)
    simple.Render(view)
    shown.field.Degree = 2
    simple.Render(view)
    assert shown.legend.Visibility == 0
    assert directionfields.show(shown.field, view=view).legend is None
    assert shown.legend.Visibility == 0
    for visibility in (1, 0):
        shown.field.Input = sphere
        simple.Render(view)
        assert shown.legend.Visibility == visibility
        shown.legend.Visibility = 0
        shown.field.Input = plane
        simple.Render(view)
    simple.ResetSession()


def arms(view, glyphs):
    """How far each glyph that faces the camera reaches from its middle, in pixels."""
    mesh, camera = servermanager.Fetch(glyphs), view.GetActiveCamera()
    width, height = view.ViewSize
    matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1.0, 1.0)
    matrix = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    seen = np.c_[points, np.ones(len(points))] @ matrix.T
    seen = 0.5 * seen[:, :2] / seen[:, 3:] * [width, height]
    offsets, corners = (vtk_to_numpy(array()) for array in (
        mesh.GetPolys().GetOffsetsArray, mesh.GetPolys().GetConnectivityArray))
    glyph = np.zeros(len(points), int)
    glyph[corners] = np.repeat(
        vtk_to_numpy(mesh.GetCellData().GetArray("Location")), np.diff(offsets))
    number = np.maximum(np.bincount(glyph), 1)[:, None]

    def mean(values):
        return np.stack([np.bincount(glyph, value) for value in values.T], axis=1) / number
    reach = np.zeros(len(number))
    np.maximum.at(reach, glyph, np.linalg.norm(seen - mean(seen)[glyph], axis=1))
    normals = mean(vtk_to_numpy(mesh.GetPointData().GetNormals()).astype(float))
    # On both sides of an open surface the normals of a glyph cancel each other out.
    towards = -normals @ camera.GetDirectionOfProjection()
    return reach[(towards > 0.8) | (np.linalg.norm(normals, axis=1) < 0.1)]


def test_glyph_size():
    """In the view of a laptop's window the arms of glyphs as they come are long enough to be told
    apart."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [850, 530]
    for name, make in (("Plane", simple.Plane),
                       ("bunny", lambda: simple.PLYReader(FileNames=[mesh]))):
        view.CameraPosition, view.CameraFocalPoint = [0.0, 0.0, 5.0], [0.0, 0.0, 0.0]
        view.CameraViewUp = [0.0, 1.0, 0.0]
        shown = directionfields.show(make(), 1, view)
        for degree in (4, 6):
            shown.field.Degree = degree
            simple.Render(view)
            found = np.median(arms(view, shown.glyphs))
            print(f"{name}, degree {degree}: arms of {found:.1f} pixels")
            assert 7.5 < found < 20.0, (name, degree, found)
        for source in reversed(directionfields.pipeline.sources()):
            simple.Delete(source)
    simple.ResetSession()


def columns(view, name):
    """The first and the last column of a picture with a pixel that is not the white background."""
    width, _ = view.ViewSize
    reader = vtkPNGReader()
    reader.SetFileName(os.path.join(output, name))
    simple.SaveScreenshot(reader.GetFileName(), view)
    reader.Update()
    colors = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    where = np.flatnonzero((colors[:, :3].min(axis=1) < 200).reshape(-1, width).any(axis=0))
    return where[0], where[-1]


def test_caption():
    """The longest caption ends before the legend begins, in a small window, too."""
    view = directionfields.picture.white_view()
    view.ViewSize = [600, 400]
    shown = directionfields.show(mesh, 4, view, ConstrainSharpEdges=1, ConstrainCurvature=1,
                                 UnitLength=1, Alignment="Principal Curvature")
    for source in directionfields.pipeline.sources():
        for port in range(source.SMProxy.GetNumberOfOutputPorts()):
            if source.GetXMLName() != "PythonAnnotation":
                simple.Hide(simple.OutputPort(source, port), view)
    shown.legend.Visibility = 0
    _, end = columns(view, "ShowCaption.png")
    simple.Hide(shown.caption, view)
    shown.legend.Visibility = 1
    begin, _ = columns(view, "ShowLegend.png")
    assert 250 < end < begin - 10, (end, begin)
    simple.ResetSession()


def test_state():
    """A saved state brings the whole picture back."""
    shown = directionfields.show(mesh)
    path = picture_of(shown.view, "ShowBefore.png")
    before = pixels(path, red), pixels(path, blue)
    count = shown.glyphs.GetDataInformation().GetNumberOfCells()
    state = os.path.join(output, "TestShow.pvsm")
    simple.SaveState(state)
    del shown
    simple.ResetSession()
    simple.LoadState(state)
    glyphs = simple.FindSource("Glyphs of bunny.ply")
    glyphs.UpdatePipeline()
    assert glyphs.GetDataInformation().GetNumberOfCells() == count
    path = picture_of(simple.GetActiveViewOrCreate("RenderView"), "ShowAfter.png")
    assert (pixels(path, red), pixels(path, blue)) == before


test_errors()
test_file()
test_options()
test_active()
test_camera()
test_legend()
test_state()
test_glyph_size()
test_caption()
print("passed")
