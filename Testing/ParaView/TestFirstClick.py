# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The first click on anything: TestFirstClick.py PLUGIN OUTDIR

On each kind of source the buttons are pressed, and each filter that its menu offers is applied as it
comes, with other inputs left empty as by OK in the dialog for them. None may write an error or a
traceback, whatever the source; a button shows the field that is there or quads along it, or says one
sentence."""
import os
import sys

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow, vtkStringOutputWindow

plugin, output = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields
from directionfields import compute, picture, quads

FILTERS = ("DirectionField", "DirectionFieldGlyphs", "DirectionFieldStreamlines", "StripePattern",
           "EditSingularities", "GuidanceFromCurves", "CompareDirectionFields",
           "ReadDirectionField", "FieldAlignedRemesh")
FOLDER = os.path.join(output, "FirstClick")
os.makedirs(FOLDER, exist_ok=True)
errors, warnings = [], []


def listen():
    """Hears what would be written in red or as a warning."""
    def listener(texts):
        def hear(_, event, text):
            texts.append(text)
        hear.CallDataType = VTK_STRING
        return hear
    window = vtkStringOutputWindow()
    window.AddObserver("ErrorEvent", listener(errors))
    window.AddObserver("WarningEvent", listener(warnings))
    before = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    return before


def sphere(**properties):
    return simple.Sphere(ThetaResolution=16, PhiResolution=12, **properties)


def field(degree=4):
    return DirectionField(Input=sphere(), Degree=degree)


def updated(source):
    source.UpdatePipeline()
    return source


def files(ending, source):
    path = os.path.join(FOLDER, f"saved.{ending}")
    for name in os.listdir(FOLDER):
        os.remove(os.path.join(FOLDER, name))
    simple.SaveData(path, proxy=source)
    return path


def time_series():
    paths = []
    for i, radius in enumerate((0.5, 1.0)):
        paths.append(os.path.join(FOLDER, f"moving{i}.vtp"))
        simple.SaveData(paths[-1], proxy=sphere(Radius=radius))
    return simple.XMLPolyDataReader(FileName=paths)


def read():
    given = updated(field())
    return ReadDirectionField(Input=sphere(), FileName=files("rosy", given))


def with_field(path):
    """A mesh whose file has a field."""
    simple.SaveData(path, proxy=updated(field()))
    return simple.XMLPolyDataReader(FileName=[path])


def program(script, kind="vtkPolyData"):
    return simple.ProgrammableSource(OutputDataSetType=kind, Script=script)


MIXED = """
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
for k, source in enumerate((vtkSphereSource(), vtkRTAnalyticSource())):
    source.Update()
    self.GetOutput().SetBlock(k, source.GetOutput())
"""
DAMAGED = """
from vtkmodules.vtkFiltersSources import vtkSphereSource
source = vtkSphereSource()
source.Update()
self.GetOutput().ShallowCopy(source.GetOutput())
points = source.GetOutput().GetPoints()
points.SetPoint(3, float("nan"), 0.0, 0.0)
"""
TORUS = """
from math import cos, pi, sin
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUAD
output, n, m, points = self.GetOutput(), 24, 12, vtkPoints()
for i in range(n):
    for j in range(m):
        u, v = 2 * pi * i / n, 2 * pi * j / m
        points.InsertNextPoint((2 + cos(v)) * cos(u), (2 + cos(v)) * sin(u), sin(v))
output.SetPoints(points)
output.Allocate(n * m)
for i in range(n):
    for j in range(m):
        output.InsertNextCell(VTK_QUAD, 4, [(i + a) % n * m + (j + b) % m
                                            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])
"""
# What the button shows: a new field, a field before the source (its name, and how many filters
# there are before), or nothing.
NEW, NOTHING = "new", "nothing"
KINDS = {
    "Plane": (NEW, simple.Plane),
    "fine plane": (NEW, lambda: simple.Plane(XResolution=8, YResolution=8)),
    "open cylinder": (NEW, lambda: simple.Cylinder(Capping=0)),
    "torus": (NEW, lambda: program(TORUS)),
    "flat part": (NEW, lambda: simple.Disk(CircumferentialResolution=16)),
    "Sphere": (NEW, sphere),
    "Box": (NEW, simple.Box),
    "Wavelet": (NEW, lambda: simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])),
    "image": (NEW, lambda: simple.Wavelet(WholeExtent=[-4, 4, -4, 4, 0, 0])),
    "grid of triangles": (NEW, lambda: simple.AppendDatasets(Input=[sphere()])),
    "grid of tetrahedra": (NEW, lambda: simple.Tetrahedralize(
        Input=simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2]))),
    "group": (NEW, lambda: simple.GroupDatasets(Input=[sphere(), sphere(Center=[2, 0, 0])])),
    "group with lines": (NEW, lambda: simple.GroupDatasets(Input=[sphere(), simple.Line()])),
    "mixed group": (NEW, lambda: program(MIXED, "vtkMultiblockDataSet")),
    "time series": (NEW, time_series),
    "lines": (NOTHING, simple.Line),
    "points": (NOTHING, simple.PointSource),
    "grid of points": (NOTHING, lambda: simple.AppendDatasets(Input=[simple.PointSource()])),
    "empty mesh": (NOTHING, lambda: program("")),
    "table": (NOTHING, lambda: program("", "vtkTable")),
    "no file": (NOTHING, lambda: ReadDirectionField(Input=sphere())),
    "field": ("DirectionField", field),
    "line field": ("DirectionField", lambda: field(2)),
    "edited field": ("EditSingularities", lambda: EditSingularities(Input=field())),
    "read field": ("ReadDirectionField", read),
    "opened field": ("DirectionFieldFile",
                     lambda: simple.OpenDataFile(files("ffield", updated(field())))),
    "field of a file": ("XMLPolyDataReader",
                        lambda: with_field(os.path.join(FOLDER, "field.vtp"))),
    "glyphs": ("DirectionField", lambda: DirectionFieldGlyphs(Input=field(),
                                                              MaximumNumberOfGlyphs=20)),
    "streamlines": ("DirectionField", lambda: DirectionFieldStreamlines(Input=field())),
    "stripes": ("DirectionField", lambda: StripePattern(Input=field(2))),
    "quads": ("DirectionField", lambda: FieldAlignedRemesh(Input=field(), NumberOfFaces=200)),
    "quads of an edit": ("EditSingularities", lambda: FieldAlignedRemesh(
        Input=EditSingularities(Input=field()), NumberOfFaces=200)),
    "plain quads": (NEW, lambda: FieldAlignedRemesh(Input=sphere(), NumberOfFaces=200)),
    "slice of a field": ("DirectionField", lambda: simple.Slice(Input=field())),
    "half of a field": ("DataSetSurfaceFilter", lambda: simple.Clip(Input=field())),
    # Last, for ParaView's camera does not come back from a point that is nowhere.
    "damaged mesh": (NOTHING, lambda: program(DAMAGED)),
}

# What is wrong with a damaged mesh is said in red; the others are like those that are applied to.
ONLY_PRESSED = ("damaged mesh", "fine plane", "Box", "image", "grid of tetrahedra",
                "grid of points", "group with lines", "line field", "quads of an edit",
                "plain quads")
# ParaView takes a seventh of a second for a display, hence the whole picture is made of one source
# of each kind that looks different; of the others, the field that it would be of.
PICTURED = ("Plane", "Sphere", "Wavelet", "group", "lines", "empty mesh", "table",
            "field", "edited field", "read field", "opened field", "streamlines",
            "half of a field", "damaged mesh")
# The button for quads is pressed before the other one, which then has to hide what it has shown.
REMESHED = ("Wavelet", "group", "field", "edited field", "half of a field")
# What is shown on Apply by filters that are not drawn as they come in a test of their own.
DISPLAYED = {"Plane": ("GuidanceFromCurves", "ReadDirectionField", "FieldAlignedRemesh"),
             "lines": ("DirectionField",),
             "field": ("EditSingularities", "GuidanceFromCurves", "CompareDirectionFields",
                       "ReadDirectionField")}


def count(name):
    # Programmable sources put names of their own over Python's sum().
    return len([source for source in simple.GetSources().values() if source.GetXMLName() == name])


def scene(view):
    """The pipeline, and what the view shows."""
    return (sorted(name for name, _ in simple.GetSources()),
            sorted((display.GetXMLName(), display.Visibility) for display in view.Representations
                   if display.Visibility), list(view.CameraPosition))


def quiet(kind, action):
    assert not errors, (kind, action, errors[0])


def apply(view, source):
    """What Apply does in the window, all but drawing, which takes most of the time."""
    source.UpdatePipeline()
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    for port in range(source.GetNumberOfOutputPorts()):
        controller.ShowInPreferredView(source.SMProxy, port, view.SMProxy)
    view.SMProxy.Update()


def clear():
    """Empties the pipeline; a new session for each kind would take most of the time."""
    for source in reversed(directionfields.pipeline.sources()):
        simple.Delete(source)
    errors.clear()
    warnings.clear()


def new_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = [200, 150]
    return view


def press(kind, expected, source, view):
    simple.SetActiveSource(source)
    fields = count("DirectionField")
    del warnings[:]
    if kind not in PICTURED and expected != NOTHING:
        field = compute.field_for(source, UnitLength=1)
        quiet(kind, "the field of the button")
        check_field(kind, expected, field, fields)
        return
    if expected == NOTHING:
        refuse(kind, view, "Show direction field", directionfields.show_active)
        refuse(kind, view, "Remesh to quads", directionfields.remesh_active)
        return
    shown = directionfields.show_active()
    quiet(kind, "the button")
    assert shown is not None, (kind, warnings)
    assert shown.glyphs.GetDataInformation().GetNumberOfCells() > 0, kind
    check_field(kind, expected, shown.field, fields)
    check_picture(kind, shown)
    # Pressed again, on the source as on the picture, it shows the same.
    for again in (source, shown.surface):
        after = len(simple.GetSources())
        simple.SetActiveSource(again)
        other = directionfields.show_active()
        quiet(kind, "the button again")
        assert other.field.SMProxy == shown.field.SMProxy, (kind, again.GetXMLLabel())
        assert len(simple.GetSources()) == after, (kind, again.GetXMLLabel())


def refuse(kind, view, button, action):
    """A button says one sentence, and leaves everything as it was."""
    before = scene(view)
    del warnings[:]
    assert action() is None, kind
    quiet(kind, button)
    assert len(warnings) == 1 and warnings[0].startswith(f"{button}: "), warnings
    assert warnings[0].count("\n") == 1 and "Traceback" not in warnings[0], warnings
    print(f"{kind}: {warnings[0].strip()}")
    assert scene(view) == before, (kind, before, scene(view))


def remesh(kind, expected, source, view):
    """Quads follow the field that is there, which they share with the picture of it; a mesh without
    a field is remeshed as it is."""
    simple.SetActiveSource(source)
    shown = directionfields.remesh_active()
    quiet(kind, "the button for quads")
    assert shown is not None, (kind, warnings)
    before = shown.quads.Input
    name = before.GetXMLName()
    if expected == NEW:
        assert before.SMProxy == source.SMProxy or name in directionfields.pipeline.EXTRACTORS, name
    else:
        assert name == expected and directionfields.pipeline.is_field(before, before.Port), name
    visible = {(display.Input.SMProxy, display.Input.Port) for display in view.Representations
               if display.Visibility and display.GetProperty("Input") is not None}
    assert visible == {(shown.quads.SMProxy, 0), (shown.quads.SMProxy, 1)}, (kind, visible)
    assert simple.GetActiveSource().SMProxy == shown.quads.SMProxy, kind
    # Pressed again, on the source as on the quads, it shows the same.
    after = len(simple.GetSources())
    for again in (source, shown.quads, simple.OutputPort(shown.quads, 1)):
        simple.SetActiveSource(again)
        assert directionfields.remesh_active().quads.SMProxy == shown.quads.SMProxy, kind
        assert len(simple.GetSources()) == after, kind


def check_field(kind, expected, field, fields):
    """It is the field that there is, or the only new one."""
    assert count("DirectionField") == fields + (expected == NEW), kind
    assert field.GetXMLName() == ("DirectionField" if expected == NEW else expected), (
        kind, field.GetXMLName())
    assert directionfields.pipeline.is_field(field, field.Port), kind
    data = servermanager.Fetch(field)
    if data.IsA("vtkPolyData") and data.GetFieldData().HasArray("Summary"):
        check_words(kind, data.GetFieldData().GetAbstractArray("Summary").GetValue(0))


def check_words(kind, text):
    """What the summary and the caption begin with."""
    assert text, kind
    if kind in ("Plane", "fine plane", "open cylinder", "flat part"):
        assert text.startswith("no singularities"), (kind, text)
    if kind == "torus":
        assert "index sum 0" in text, text


def check_picture(kind, shown):
    """The legend is there where singularities are, and the caption says where none are."""
    shown.caption.UpdatePipeline()
    text = servermanager.Fetch(shown.caption).GetColumn(0).GetValue(0)
    assert not [display for display in shown.view.Representations if display.Visibility and
                display.GetProperty("Input") is not None and
                display.Input.GetXMLName() == "FieldAlignedRemesh"], kind
    port = directionfields.pipeline.singularities_port(shown.field)
    if port is not None:
        number = shown.field.GetDataInformation(port).GetNumberOfPoints()
        assert (shown.legend is not None) == (number > 0), (kind, number)
        assert (number > 0) != text.startswith("no singularities"), (kind, text)
    check_words(kind, text)


PROTOTYPES = {}


def is_offered(name, source):
    """Whether the menu offers a filter for a source."""
    if name not in PROTOTYPES:
        PROTOTYPES[name] = getattr(servermanager.filters, name)()
    prototype = PROTOTYPES[name].SMProxy.GetProperty("Input")
    prototype.RemoveAllUncheckedProxies()
    prototype.AddUncheckedInputConnection(source.SMProxy, 0)
    offered = prototype.IsInDomains() > 0
    prototype.RemoveAllUncheckedProxies()
    return offered


def apply_all(kind, source, view):
    """Applies what the menu offers; returns the names."""
    offered = [name for name in FILTERS if is_offered(name, source)]
    for name in offered:
        made = globals()[name](Input=source)
        if name == "FieldAlignedRemesh" and kind not in DISPLAYED:
            made.NumberOfFaces = 100
        if name in DISPLAYED.get(kind, ()):
            apply(view, made)
        made.UpdatePipeline()
        quiet(kind, name)
    return offered


def test_kinds():
    view, offers = new_view(), {}
    for kind, (expected, make) in KINDS.items():
        source = make()
        if kind in PICTURED:
            apply(view, source)
        else:
            source.UpdatePipeline()
        quiet(kind, "Apply")
        if kind in REMESHED:
            remesh(kind, expected, source, view)
        press(kind, expected, source, view)
        if kind not in ONLY_PRESSED:
            offers[kind] = apply_all(kind, source, view)
        clear()
    assert offers["field"] == list(FILTERS), offers["field"]
    assert offers["Plane"] == ["DirectionField", "GuidanceFromCurves", "ReadDirectionField",
                               "FieldAlignedRemesh"], offers["Plane"]
    assert offers["table"] == offers["Wavelet"] == [], offers
    simple.ResetSession()


def test_taken_back():
    """A failure half way leaves nothing behind."""
    real = picture.show_legend

    def broken(*arguments):
        real(*arguments)
        raise KeyError("half way")
    view = new_view()
    for make in (lambda: simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]),
                 lambda: DirectionFieldGlyphs(Input=field())):
        source = make()
        apply(view, source)
        simple.SetActiveSource(source)
        before = scene(view)
        del warnings[:]
        picture.show_legend = broken
        assert directionfields.show_active() is None
        picture.show_legend = real
        assert len(warnings) == 1 and "half way" in warnings[0], warnings
        assert scene(view) == before, (before, scene(view))
        assert simple.GetActiveSource().SMProxy == source.SMProxy
        view.SMProxy.Update()
        quiet(source.GetXMLName(), "a failure")
        clear()


def test_quads_of_lines():
    """Quads cannot follow a field of two directions: they are of its mesh, or of its other field."""
    mesh = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    lines = DirectionField(Input=mesh, Degree=2)
    simple.SetActiveSource(lines)
    shown = directionfields.remesh_active()
    quiet("a line field", "the button for quads")
    assert shown.quads.Input.SMProxy == mesh.SMProxy, shown.quads.Input.GetXMLName()
    crosses = DirectionField(Input=mesh, Degree=4)
    crosses.UpdatePipeline()
    simple.SetActiveSource(lines)
    assert directionfields.remesh_active().quads.Input.SMProxy == crosses.SMProxy
    clear()


connect = quads.connect
quads.connect = lambda proxy, source, _: connect(proxy, source, {"NumberOfFaces": 100})
window = listen()
try:
    test_kinds()
    test_taken_back()
    test_quads_of_lines()
finally:
    # Python's own words go through it.
    vtkOutputWindow.SetInstance(window)
print("passed")
