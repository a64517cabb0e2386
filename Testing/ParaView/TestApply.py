# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What one sees after Apply, with nothing set: TestApply.py PLUGIN MESH OUTDIR"""
import os
import sys

import numpy
from paraview import servermanager, simple
from paraview.modules.vtkRemotingServerManager import vtkSMSettings
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkFiltersSources import vtkPlaneSource

from Figures import blue, pixels, red, teal

plugin, mesh, output = sys.argv[1:4]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields

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


def color_of(lookup, value):
    rgb = [0.0, 0.0, 0.0]
    lookup.GetClientSideObject().GetColor(value, rgb)
    return [255 * c for c in rgb]


def apply(view, source):
    """What Apply does in the window."""
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    for port in range(source.GetNumberOfOutputPorts()):
        controller.ShowInPreferredView(source.SMProxy, port, view.SMProxy)
    simple.Render(view)
    return [simple.GetRepresentation(simple.OutputPort(source, port), view)
            if view.FindRepresentation(source.SMProxy, port) else None
            for port in range(source.GetNumberOfOutputPorts())]


def orange(r, g, b):
    return (r > b + 100) & (r > g + 50) & (g > b + 30)


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


def caption(view):
    """What stands at the top left of a view, by the displays that have made it."""
    props = view.GetClientSideObject().GetNonCompositedRenderer().GetViewProps()
    texts = [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]
    texts = [text for text in texts if text.IsA("vtkTextActor") and text.GetVisibility()]
    assert len(texts) <= 1, texts
    return texts[0].GetInput() if texts else ""


def summary(source):
    words = source.GetDataInformation(0).GetFieldDataInformation().GetArrayInformation("Summary")
    return words.GetStringValue(0)


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
    _, balls = apply(view, remeshed)
    simple.ResetCamera(view)
    assert balls.ColorArrayName[:] == ["POINTS", "MissingEdges"]
    path = picture_of(view, "ApplyRemesh.png")
    assert min(pixels(path, red), pixels(path, blue)) > 200, (pixels(path, red), pixels(path, blue))
    balls.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(balls.LookupTable, view)
    assert bar.Title == "Valence" and bar.DrawTickLabels == 0
    assert list(balls.LookupTable.Annotations) == ["-1", "more edges", "1", "fewer edges"]
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


def menu(display):
    """The arrays that the colour menu offers."""
    domain = display.GetProperty("ColorArrayName").GetDomain("array_list")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]


def test_menus():
    """Menus of arrays are short, and are long where Diagnostics is on."""
    view = new_view()
    source = simple.Sphere(ThetaResolution=24, PhiResolution=16, EndPhi=120.0)
    field = DirectionField(Input=simple.Transform(Input=source), Degree=2)
    surface, _ = apply(view, field)
    print(menu(surface))
    for degree in (1, 2, 4):
        field.Degree = degree
        simple.Render(view)
        # The sphere has normals of its own.
        offered = [name for name in menu(surface) if name != "Normals"]
        others = [name for name in offered if not name.startswith("Direction")]
        assert len(offered) == degree + len(others) and len(others) <= 4, (degree, offered)
    [lines] = apply(view, DirectionFieldStreamlines(Input=field))[:1]
    print(menu(lines))
    assert len(menu(lines)) <= 5, menu(lines)
    simple.ResetSession()


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
    field, _, balls = shown_field(view, source)
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
test_directions()
test_constraint_lines()
test_others_hide_directions()
test_captions()
test_replaced()
test_stripes()
test_no_stripes()
test_remesh()
test_guidance()
test_menus()
test_glyphs()
test_tension()
test_sides()
test_one_singularity()
test_no_singularity()
test_user()
print("passed")
