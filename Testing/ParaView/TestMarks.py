# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The marks of a field that one sees after Apply: TestMarks.py PLUGIN MESH OUTDIR"""
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource

from Figures import blue, pixels, red, teal
from Views import SIZE, apply, new_view, picture_of, shown_field

plugin, mesh = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields


def test_directions():
    """Direction Field shows directions, on each block of a group, and they move with the surface."""
    view = new_view()
    field = DirectionField(Input=simple.PLYReader(FileNames=[mesh]))
    surface, balls = apply(view, field)
    assert balls.Representation == "3D Glyphs"
    simple.ResetCamera(view)
    count = pixels(picture_of(view, "ApplyDirections.png"), teal)
    assert count > 0.02 * SIZE[0] * SIZE[1], count
    # ParaView 5.13 has given the property another name.
    place = surface.GetProperty("Translation") or surface.GetProperty("Position")
    place.SetData([1000.0, 0.0, 0.0])
    assert pixels(picture_of(view, "ApplyMoved.png"), teal) == 0
    place.SetData([0.0, 0.0, 0.0])
    surface.Representation = "Surface"
    assert pixels(picture_of(view, "ApplyPlain.png"), teal) == 0
    surface.Representation = "Direction Field"
    again = pixels(picture_of(view, "ApplyAgain.png"), teal)
    assert abs(again - count) < 0.02 * count, (again, count)
    surface.Visibility = 0
    assert pixels(picture_of(view, "ApplyHidden.png"), teal) == 0
    simple.ResetSession()

    view = new_view()
    group = simple.GroupDatasets(Input=[simple.Sphere(Center=[-1, 0, 0]), simple.Sphere(Center=[1, 0, 0])])
    apply(view, DirectionField(Input=group))
    view.CameraPosition, view.CameraFocalPoint = [0.0, 0.0, 8.0], [0.0, 0.0, 0.0]
    simple.ResetCamera(view)
    path = picture_of(view, "ApplyGroup.png")
    for half in (0, 1):
        count = pixels(path, lambda r, g, b: teal(r, g, b) & half_of(r, half))
        assert count > 1000, (half, count)
    simple.ResetSession()


def half_of(red, half):
    columns = numpy.tile(numpy.arange(SIZE[0]), SIZE[1])
    return (columns >= SIZE[0] // 2) == bool(half)


def test_others_hide_directions():
    """What is drawn along a field does not lie among its glyphs."""
    view = new_view()
    field = DirectionField(Input=simple.Sphere(ThetaResolution=48, PhiResolution=32), Degree=2)
    surface, _ = apply(view, field)
    glyphs = DirectionFieldGlyphs(Input=field)
    [marks] = apply(view, glyphs)
    assert (surface.Representation, marks.Visibility) == ("Surface", 1)
    surface.Representation = "Direction Field"
    apply(view, DirectionFieldStreamlines(Input=field))
    assert (surface.Representation, marks.Visibility) == ("Surface", 0)
    # The user's choice stays.
    marks.Visibility = 1
    simple.Render(view)
    assert marks.Visibility == 1
    simple.ResetSession()


def test_glyphs():
    """Glyphs are teal, and `Coloring` by each of their arrays gives more than one colour."""
    view = new_view()
    field = DirectionField(Input=simple.PLYReader(FileNames=[mesh]))
    shown_field(view, field)
    glyphs = DirectionFieldGlyphs(Input=field)
    display = simple.Show(glyphs, view)
    assert not display.ColorArrayName[1], display.ColorArrayName
    plain = pixels(picture_of(view, "ApplyGlyphs.png"), teal)
    assert plain > 0.03 * SIZE[0] * SIZE[1], plain
    for array in ("Direction", "RepresentationMagnitude", "Branch"):
        simple.ColorBy(display, ("CELLS", array))
        if array == "Direction":
            display.LookupTable.VectorMode = "Component"
            display.LookupTable.RescaleTransferFunction(-1.0, 1.0)
        path = picture_of(view, f"ApplyGlyphs{array}.png")
        reddish = pixels(path, lambda r, g, b: (r > b + 60) & (r > g + 30))
        bluish = pixels(path, lambda r, g, b: (b > r + 60) & (b > g + 20))
        assert min(reddish, bluish) > 500, (array, reddish, bluish)
    simple.ResetSession()


def pull(stress, size):
    """Makes a square source one that is pulled along x and pressed along y by 1."""
    plane, tensors = vtkPlaneSource(), vtkDoubleArray()
    plane.SetResolution(20, 20)
    plane.Update()
    square = plane.GetOutput()
    tensors.SetName("Stress")
    tensors.SetNumberOfComponents(6)
    for _ in range(square.GetNumberOfPoints()):
        tensors.InsertNextTuple((size, -1.0, 0.0, 0.0, 0.0, 0.0))
    square.GetPointData().AddArray(tensors)
    stress.GetClientSideObject().SetOutput(square)
    stress.MarkModified(stress.SMProxy)
    stress.UpdatePipeline()
    return stress


def map_range(display):
    points = display.LookupTable.RGBPoints
    return points[0], points[-4]


def test_tension():
    """Lines and glyphs along tensors are red where these pull and blue where they press, teal where there are
    none; the colors are symmetric about 0 until the user gives them another range."""
    view = new_view()
    stress = pull(simple.TrivialProducer(), 2.0)
    field = DirectionField(Input=stress, Degree=4, Alignment="Tensor", TensorArray=["POINTS", "Stress"])
    surface, _ = apply(view, field)
    simple.ResetCamera(view)
    for name, made in (("Lines", DirectionFieldStreamlines), ("Glyphs", DirectionFieldGlyphs)):
        marks = apply(view, made(Input=field))[0]
        assert marks.ColorArrayName[1] == "PrincipalValue", marks.ColorArrayName
        assert numpy.allclose(map_range(marks), (-2.0, 2.0), atol=1e-3), map_range(marks)
        for condition, degree, least in ((red, 4, 2000), (blue, 4, 2000), (red, 2, 2000), (blue, 2, 0)):
            field.Degree = degree
            found = pixels(picture_of(view, f"ApplyTension{name}{degree}.png"), condition)
            # The glyphs of a line field have no arms across.
            assert found >= least and (least > 0 or found == 0), (name, degree, condition, found)
        field.Degree = 4
        marks.SetScalarBarVisibility(view, True)
        bar = simple.GetScalarBar(marks.LookupTable, view)
        assert (bar.Title, bar.Visibility) == ("Principal value", 1)
        field.Alignment = "None"
        path = picture_of(view, f"ApplyNoTension{name}.png")
        assert pixels(path, teal) > 2000 and pixels(path, red) == pixels(path, blue) == 0, name
        assert bar.Visibility == 0 and not marks.ColorArrayName[1], name
        field.Alignment = "Tensor"
        assert pixels(picture_of(view, f"ApplyTensionAgain{name}.png"), blue) > 2000
        assert marks.ColorArrayName[1] == "PrincipalValue"
        marks.SetScalarBarVisibility(view, False)
        marks.Visibility = 0
    # The range follows larger values, but not against the user.
    marks.Visibility = 1
    pull(stress, 3.0)
    simple.Render(view)
    assert numpy.allclose(map_range(marks), (-3.0, 3.0), atol=1e-3), map_range(marks)
    marks.LookupTable.RescaleTransferFunction(-1.0, 5.0)
    pull(stress, 8.0)
    simple.Render(view)
    assert numpy.allclose(map_range(marks), (-1.0, 5.0)), map_range(marks)
    # The surface is quiet until it is colored, by the same colors.
    assert not surface.ColorArrayName[1], surface.ColorArrayName
    marks.Visibility = 0
    for array, condition, most in (("MajorValue", red, 8.0), ("MinorValue", blue, 1.0)):
        simple.ColorBy(surface, ("POINTS", array))
        simple.Render(view)
        assert numpy.allclose(map_range(surface), (-most, most), atol=1e-3), map_range(surface)
    simple.ResetSession()

    shown = directionfields.show(pull(simple.TrivialProducer(), 2.0), 2, new_view(), Alignment="Tensor",
                                 TensorArray=["POINTS", "Stress"])
    assert pixels(picture_of(shown.view, "ApplyTensionShown.png"), red) > 2000
    # A number stays in the line of its unit.
    lines = servermanager.Fetch(shown.caption).GetColumn(0).GetValue(0).split("\n")
    assert lines[-1].endswith("0\xa0% isotropic"), lines
    bars = [display for display in shown.view.Representations
            if display.GetXMLName() == "ScalarBarWidgetRepresentation"]
    assert [bar.Title for bar in bars if bar.Visibility] == ["Principal value"], bars
    simple.ResetSession()


def sphere(inside_out=False):
    source = simple.Sphere(ThetaResolution=48, PhiResolution=32)
    if not inside_out:
        return source
    turned = getattr(simple, "SurfaceNormals", None) or simple.GenerateSurfaceNormals
    return turned(Input=source, FlipNormals=1, Splitting=0)


def glyph_pixels(source, sides):
    """How many pixels glyphs take, seen from above and from below."""
    view = new_view()
    field = DirectionField(Input=source)
    _, balls = shown_field(view, field)
    balls.Visibility = 0
    simple.Show(DirectionFieldGlyphs(Input=field), view)
    view.CameraFocalPoint, view.CameraViewUp = [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]
    counts = []
    for side in sides:
        view.CameraPosition = [0.0, 0.0, side]
        simple.ResetCamera(view)
        counts.append(pixels(picture_of(view, f"ApplySide{side}.png"), teal))
    simple.ResetSession()
    return counts


def test_sides():
    """Glyphs are seen on surfaces wound inside out as on others, and on open ones from both
    sides."""
    [plain], [turned] = glyph_pixels(sphere(), [5]), glyph_pixels(sphere(inside_out=True), [5])
    assert plain > 10000 and abs(turned - plain) < 0.15 * plain, (plain, turned)
    front, back = glyph_pixels(simple.Plane(XResolution=20, YResolution=20), [5, -5])
    assert front > 10000 and abs(back - front) < 0.15 * front, (front, back)


test_directions()
test_others_hide_directions()
test_glyphs()
test_tension()
test_sides()
print("passed")
