# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What one sees after Apply, with nothing set: TestApply.py PLUGIN MESH OUTDIR"""
import os
import sys

from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMSettings
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

from Figures import blue, pixels, red, teal
from Views import SIZE, apply, caption, color_of, new_view, orange, picture_of, shown_field, summary

plugin, mesh = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields


def test_field():
    """The surface is quiet; the singularities are balls, red and blue, each at least 0.2 % of the
    picture, and nothing else is red or blue."""
    view = new_view()
    field = DirectionField(Input=simple.PLYReader(FileNames=[mesh]))
    surface, balls = shown_field(view, field)
    assert surface.Representation == "Direction Field" and not surface.ColorArrayName[1]
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


def test_constraint_lines():
    """The edges that a field follows are drawn: those of a cube; on the bunny's scan they are so few
    that the field has no more singularities than the smoothest one."""
    view = new_view()
    cube = simple.Subdivide(Input=simple.Triangulate(Input=simple.Box()), NumberofSubdivisions=2)
    for constrain, least, most in ((1, 3000, 8000), (0, 0, 0)):
        field = DirectionField(Input=cube, ConstrainSharpEdges=constrain)
        _, balls = apply(view, field)
        balls.Visibility = 0
        view.CameraPosition, view.CameraFocalPoint = [2.0, 1.5, 2.5], [0.0, 0.0, 0.0]
        simple.ResetCamera(view)
        count = pixels(picture_of(view, f"ApplyLines{constrain}.png"), orange)
        assert least <= count <= most, (constrain, count)
        simple.Hide(field, view)
    bunny = simple.PLYReader(FileNames=[mesh])
    found = []
    for constrain in (0, 1):
        field = DirectionField(Input=bunny, ConstrainSharpEdges=constrain)
        field.UpdatePipeline()
        found.append(field.GetDataInformation(1).GetNumberOfPoints())
    kinds = field.GetDataInformation(0).GetPointDataInformation().GetArrayInformation("ConstraintKind")
    assert kinds.GetComponentRange(0) == (0.0, 2.0) and found[1] <= found[0], found
    simple.ResetSession()


def test_captions():
    """What each filter has made stands in the picture, whole and once, while a display of it does."""
    view = new_view()
    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    field, other = (DirectionField(Input=sphere, Degree=2, EnergyBias=bias) for bias in (0.0, 0.5))
    makers = {
        "DirectionFieldStreamlines": {"Input": field}, "EditSingularities": {"Input": field},
        "CompareDirectionFields": {"Input": field, "Other": other},
        "FieldAlignedRemesh": {"Input": field, "NumberOfFaces": 200},
        "StripePattern": {"Input": field}}
    for name, inputs in makers.items():
        apply(view, field)
        before = summary(field)
        made = globals()[name](**inputs)
        displays = apply(view, made)
        lines = caption(view).split("\n")
        assert max(map(len, lines)) <= 56, lines
        expected = summary(made)
        if name in ("DirectionFieldStreamlines", "CompareDirectionFields"):
            expected = before + " " + expected
        if name == "FieldAlignedRemesh":
            expected += " Warning: The direction field of the input has degree 2"
        text = " ".join(lines)
        assert text.startswith(expected) and text.count(summary(made)) == 1, (name, lines)
        for display in displays:
            if display is not None:
                display.Visibility = 0
        simple.Hide(field, view)
        simple.Hide(simple.OutputPort(field, 1), view)
        assert caption(view) == "", (name, caption(view))
        simple.Show(made, view)
        simple.Render(view)
        assert " ".join(caption(view).split("\n")).startswith(summary(made)), caption(view)
        simple.Delete(made)
        assert caption(view) == "", (name, caption(view))
    # Where the button's picture says the same, it is not there twice.
    apply(view, field)
    assert caption(view) == summary(field)
    shown = directionfields.show(field, view=view)
    assert caption(view) == "" and simple.GetRepresentation(shown.caption, view).Visibility == 1
    simple.Hide(shown.caption, view)
    assert caption(view) == ""
    # The words follow the field, and can be switched off.
    simple.Hide(shown.surface, view)
    display = simple.Show(field, view)
    display.ShowSummary = 1
    for degree in (1, 6):
        field.Degree = degree
        simple.Render(view)
        assert caption(view) == summary(field), (caption(view), summary(field))
    display.ShowSummary = 0
    assert caption(view) == ""
    simple.ResetSession()


def test_ground():
    """The words are read over a pale surface, too: they stand on the color of the view's background."""
    view = new_view()
    view.UseColorPaletteForBackground, view.Background = 0, [0.2, 0.3, 0.4]
    field = DirectionField(Input=simple.Plane(XResolution=8, YResolution=8))
    display = simple.Show(field, view)
    display.DiffuseColor = display.AmbientColor = [1.0, 1.0, 1.0]
    display.Ambient, display.Diffuse, display.Specular, display.ShowSummary = 1.0, 0.0, 0.0, 1
    simple.ResetCamera(view)
    view.CameraPosition = [0.0, 0.0, 0.5]
    def ground(name):
        return pixels(picture_of(view, name), lambda r, g, b: (r > 50) & (r < 120) & (b > 110) & (b < 145))
    assert 1000 < ground("ApplyGround.png") < SIZE[0] * SIZE[1] // 8
    display.ShowSummary = 0
    assert ground("ApplyNoGround.png") < 300
    simple.ResetSession()


def test_replaced():
    """Nothing of the field before lies among what stripes, an edit and a remesh show."""
    view = new_view()
    # A cone has no normals, hence its picture has a surface of its own.
    shown = directionfields.show(simple.Cone(Resolution=24), 2, view)
    assert shown.surface.SMProxy != shown.field.SMProxy
    for name, properties in (("EditSingularities", {}), ("StripePattern", {}),
                             ("FieldAlignedRemesh", {"NumberOfFaces": 200})):
        made = globals()[name](Input=shown.field, **properties)
        apply(view, made)
        seen = {display.Input.GetXMLName() for display in view.Representations
                if display.Visibility and display.GetProperty("Input")}
        assert seen == {name}, seen
        assert shown.legend.Visibility == (name == "EditSingularities"), name
        simple.Delete(made)
        directionfields.show(shown.field, view=view)
    simple.ResetSession()


def test_stripes():
    """Stripe Pattern shows bands and nothing else, with one legend."""
    view = new_view()
    field = DirectionField(Input=simple.PLYReader(FileNames=[mesh]), Degree=2)
    lines, bands, branches = apply(view, StripePattern(Input=field))
    assert lines is None and branches is None
    assert bands.ColorArrayName[:] == ["CELLS", "Stripe"]
    simple.ResetCamera(view)
    picture_of(view, "ApplyStripes.png")
    simple.ResetSession()


def test_no_stripes():
    """A cross field has no stripes: it is shown as it is, with a sentence in the picture that goes when
    there are stripes."""
    view = new_view()
    field = DirectionField(Input=simple.PLYReader(FileNames=[mesh]))
    apply(view, field)
    # The message that says the same is a warning.
    window = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    _, bands, _ = apply(view, StripePattern(Input=field))
    assert "Set Directions Per Point" in vtkOutputWindow.GetInstance().GetOutput()
    simple.Hide(simple.OutputPort(field, 1), view)
    simple.ResetCamera(view)

    def white(path):
        return pixels(path, lambda r, g, b: (r > 250) & (g > 250) & (b > 250))
    path = picture_of(view, "ApplyNoStripes.png")
    assert pixels(path, teal) > 0.02 * SIZE[0] * SIZE[1] and white(path) > 40, white(path)
    bands.Visibility = 0
    assert white(picture_of(view, "ApplyNoStripesHidden.png")) == 0
    bands.Visibility = 1
    field.Degree = 2
    simple.Render(view)
    assert " stripes " in caption(view) and "no stripes" not in caption(view), caption(view)
    assert bands.ColorArrayName[:] == ["CELLS", "Stripe"]
    vtkOutputWindow.SetInstance(window)
    simple.ResetSession()


def test_remesh():
    """Irregular vertices are balls, red and blue, of the size of the faces."""
    view = new_view()
    remeshed = FieldAlignedRemesh(Input=simple.PLYReader(FileNames=[mesh]), NumberOfFaces=2000)
    _, balls, lines = apply(view, remeshed)
    assert lines is None
    simple.ResetCamera(view)
    assert balls.ColorArrayName[:] == ["POINTS", "MissingEdges"]
    path = picture_of(view, "ApplyRemesh.png")
    assert min(pixels(path, red), pixels(path, blue)) > 200, (pixels(path, red), pixels(path, blue))
    balls.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(balls.LookupTable, view)
    assert bar.Title == "Valence" and bar.DrawTickLabels == 0
    assert list(balls.LookupTable.Annotations) == ["-1", "more edges", "1", "fewer edges"]
    simple.ResetSession()


def test_one_value():
    """An array that is the same everywhere, as the label of the only solid of an STL file, is not
    what a surface is colored by, as ParaView colors that of the file; one that differs is."""
    view = new_view()
    path = os.path.join(sys.argv[-1], "Apply.stl")
    simple.SaveData(path, simple.Sphere(), FileType="Ascii")
    solid = simple.STLReader(FileNames=[path])
    solid.UpdatePipeline()
    assert solid.CellData.keys() == ["STLSolidLabeling"], solid.CellData.keys()
    apply(view, solid)
    hidden = simple.STLReader(FileNames=[path])
    rising = simple.Elevation(Input=simple.Sphere(), LowPoint=[0, 0, -0.5], HighPoint=[0, 0, 0.5])
    height = simple.PointDatatoCellData(Input=rising)
    for source, array in ((solid, ""), (hidden, ""), (height, "Elevation")):
        for made in (DirectionField(Input=source), EditSingularities(Input=DirectionField(Input=source)),
                     FieldAlignedRemesh(Input=source, NumberOfFaces=100)):
            made.UpdatePipeline()
            surface = apply(view, made)[0]
            assert (surface.ColorArrayName[1] or "") == array, (made, surface.ColorArrayName[:])
    # What a script chooses stays, from the first picture on.
    made = FieldAlignedRemesh(Input=height, NumberOfFaces=100, MaximumWarpage=1)
    chosen = simple.Show(made, view)
    simple.ColorBy(chosen, ("CELLS", "Pass"))
    simple.Render(view)
    low, high = made.CellData["Pass"].GetRange()
    assert low == high and chosen.ColorArrayName[:] == ["CELLS", "Pass"], chosen.ColorArrayName[:]
    simple.ResetSession()


def test_guidance():
    """Guidance From Curves shows curve and vectors."""
    view = new_view()
    sphere = simple.Sphere(ThetaResolution=48, PhiResolution=32)
    circle = simple.PolyLineSource(Points=[0.5, 0, 0, 0.35, 0, 0.35, 0, 0, 0.5, -0.35, 0, 0.35])
    guidance = GuidanceFromCurves(Input=sphere, Curves=circle)
    _, strokes = apply(view, guidance)
    view.CameraPosition, view.CameraFocalPoint = [0.0, 2.0, 4.0], [0.0, 0.0, 0.0]
    simple.ResetCamera(view)
    count = pixels(picture_of(view, "ApplyGuidance.png"), orange)
    assert count > 1000, count
    strokes.Visibility = 0
    assert pixels(picture_of(view, "ApplyNoStrokes.png"), orange) == 0
    simple.ResetSession()


def test_one_singularity():
    """A field with a single singularity shows it as a ball of a size that fits."""
    view = new_view()
    half = simple.Sphere(EndPhi=90.0, ThetaResolution=48, PhiResolution=24)
    field = DirectionField(Input=half, Degree=1, ConstrainBoundary=1)
    shown_field(view, field)
    count = field.GetDataInformation(1).GetNumberOfPoints()
    assert count == 1, count
    found = pixels(picture_of(view, "ApplyOne.png"), red)
    assert 10 < found < 0.02 * SIZE[0] * SIZE[1], found
    simple.ResetSession()


def test_no_singularity():
    """A field without singularities shows none, says nothing, and has its colors ready for those
    that come with other properties."""
    view = new_view()
    field = DirectionField(Input=simple.Plane(XResolution=20, YResolution=20))
    _, balls = shown_field(view, field)
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
    surface, balls = shown_field(view, DirectionField(Input=simple.Sphere()))
    assert surface.Opacity == 0.5 and list(surface.DiffuseColor) == [0.0, 1.0, 0.0]
    assert list(balls.LookupTable.Annotations) == []
    settings.ClearAllSettings()
    simple.ResetSession()


test_field()
test_constraint_lines()
test_captions()
test_ground()
test_replaced()
test_stripes()
test_no_stripes()
test_remesh()
test_one_value()
test_guidance()
test_one_singularity()
test_no_singularity()
test_user()
print("passed")
