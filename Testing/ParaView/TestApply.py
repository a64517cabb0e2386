# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What one sees after Apply, with nothing set: TestApply.py PLUGIN MESH OUTDIR"""
import os
import sys

from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMSettings

from Figures import blue, pixels, red, teal

plugin, mesh, output = sys.argv[1:4]
simple.LoadPlugin(plugin, remote=False, ns=globals())
SIZE = [800, 600]


def picture_of(view, name):
    path = os.path.join(output, name)
    simple.SaveScreenshot(path, view, ImageResolution=SIZE)
    return path


def new_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    return view


def shown_field(view, source, **properties):
    field = DirectionField(Input=source, **properties)
    return field, simple.Show(field, view), simple.Show(simple.OutputPort(field, 1), view)


def test_field():
    """The surface is quiet; the singularities are balls, red and blue, each at least 0.2 % of the
    picture, and nothing else is red or blue."""
    view = new_view()
    field, surface, balls = shown_field(view, simple.PLYReader(FileNames=[mesh]))
    assert surface.Representation == "Surface" and not surface.ColorArrayName[1]
    assert max(surface.DiffuseColor) - min(surface.DiffuseColor) < 0.1
    assert balls.Representation == "3D Glyphs", balls.Representation
    assert balls.ColorArrayName[:] == ["POINTS", "SingularityIndex"]
    assert balls.GlyphType.GetXMLName() == "SphereSource"
    assert balls.SelectScaleArray == "Size" and balls.ScaleFactor == 1.0
    path = picture_of(view, "Apply.png")
    found = pixels(path, red), pixels(path, blue)
    assert min(found) >= 0.002 * SIZE[0] * SIZE[1], found
    simple.Hide(simple.OutputPort(field, 1), view)
    path = picture_of(view, "ApplySurface.png")
    assert max(pixels(path, red), pixels(path, blue)) == 0

    # The cells' index has the same colors, and 0 that of the surface.
    simple.ColorBy(surface, ("CELLS", "SingularityIndex"))
    lookup = surface.LookupTable
    for value, condition in ((-3, blue), (-1, blue), (1, red), (2, red)):
        assert condition(*color_of(lookup, value)), value
    zero = color_of(lookup, 0)
    assert max(zero) - min(zero) < 30 and min(zero) > 200, zero

    # The panel Information shows the summary where other arrays have their ranges.
    data = field.GetDataInformation(0).GetFieldDataInformation()
    text = data.GetArrayInformation("Summary").GetRangesAsString()
    assert " singularities (" in text and "index sum 8" in text, text

    # The legend names the two signs, without ticks and numbers.
    balls.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(balls.LookupTable, view)
    assert (bar.Title, bar.DrawTickLabels, bar.AddRangeLabels) == ("Singularities", 0, 0)
    assert list(balls.LookupTable.Annotations) == ["-1", "negative", "1", "positive"]
    simple.ResetSession()


def color_of(lookup, value):
    rgb = [0.0, 0.0, 0.0]
    lookup.GetClientSideObject().GetColor(value, rgb)
    return [255 * c for c in rgb]


def test_glyphs():
    """Glyphs are teal, and `Coloring` by each of their arrays gives more than one colour."""
    view = new_view()
    field, _, _ = shown_field(view, simple.PLYReader(FileNames=[mesh]))
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


def sphere(inside_out=False):
    source = simple.Sphere(ThetaResolution=48, PhiResolution=32)
    if not inside_out:
        return source
    turned = getattr(simple, "SurfaceNormals", None) or simple.GenerateSurfaceNormals
    return turned(Input=source, FlipNormals=1, Splitting=0)


def glyph_pixels(source, direction, name):
    view = new_view()
    field, _, balls = shown_field(view, source)
    balls.Visibility = 0
    simple.Show(DirectionFieldGlyphs(Input=field), view)
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraPosition = direction
    view.CameraViewUp = [0.0, 1.0, 0.0]
    simple.ResetCamera(view)
    count = pixels(picture_of(view, name), teal)
    simple.ResetSession()
    return count


def test_sides():
    """Glyphs are seen on surfaces wound inside out as on others, and on open ones from both
    sides."""
    plain = glyph_pixels(sphere(), [0, 0, 5], "ApplySphere.png")
    turned = glyph_pixels(sphere(inside_out=True), [0, 0, 5], "ApplyInsideOut.png")
    assert plain > 10000 and abs(turned - plain) < 0.15 * plain, (plain, turned)
    plane = dict(XResolution=20, YResolution=20)
    front = glyph_pixels(simple.Plane(**plane), [0, 0, 5], "ApplyFront.png")
    back = glyph_pixels(simple.Plane(**plane), [0, 0, -5], "ApplyBack.png")
    assert front > 10000 and abs(back - front) < 0.15 * front, (front, back)


def test_one_singularity():
    """A field with a single singularity shows it as a ball of a size that fits."""
    view = new_view()
    half = simple.Sphere(EndPhi=90.0, ThetaResolution=48, PhiResolution=24)
    field, _, _ = shown_field(view, half, Degree=1, ConstrainBoundary=1)
    count = field.GetDataInformation(1).GetNumberOfPoints()
    assert count == 1, count
    found = pixels(picture_of(view, "ApplyOne.png"), red)
    assert 10 < found < 0.02 * SIZE[0] * SIZE[1], found
    simple.ResetSession()


def test_no_singularity():
    """A field without singularities shows none, says nothing, and has its colors ready for those
    that come with other properties."""
    view = new_view()
    field, _, balls = shown_field(view, simple.Plane(XResolution=20, YResolution=20))
    assert field.GetDataInformation(1).GetNumberOfPoints() == 0
    path = picture_of(view, "ApplyNone.png")
    assert pixels(path, red) + pixels(path, blue) == 0 and not balls.ColorArrayName[1]
    field.Degree = 1
    field.ConstrainBoundary = 1
    field.UpdatePipeline()
    assert field.GetDataInformation(1).GetNumberOfPoints() > 0
    assert pixels(picture_of(view, "ApplySome.png"), red) > 10
    assert balls.ColorArrayName[:] == ["POINTS", "SingularityIndex"]
    simple.ResetSession()


def test_user():
    """What the user has set, or saved as a default, is left alone."""
    settings = vtkSMSettings.GetInstance()
    settings.AddCollectionFromString(
        '{"representations": {"DirectionFieldRepresentation": {"Opacity": 0.5,'
        ' "DiffuseColor": [0.0, 1.0, 0.0]}},'
        ' "standard_presets": {"SingularityIndex": "Grayscale"}}', 2.0)
    view = new_view()
    _, surface, balls = shown_field(view, simple.Sphere())
    assert surface.Opacity == 0.5 and list(surface.DiffuseColor) == [0.0, 1.0, 0.0]
    assert list(balls.LookupTable.Annotations) == []
    settings.ClearAllSettings()
    simple.ResetSession()


test_field()
test_glyphs()
test_sides()
test_one_singularity()
test_no_singularity()
test_user()
print("passed")
