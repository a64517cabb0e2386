# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a direction field."""

import collections

from paraview import servermanager
from paraview import simple
from vtkmodules.vtkCommonCore import vtkOutputWindow

from directionfields.camera import is_untouched, place_camera
from directionfields.compute import check_properties, compute, connect, field_for, register
from directionfields.pipeline import (BETWEEN, MAKERS, REMESHERS, follower, is_field, mesh_of,
                                      name_of, proxy_of, singularities_port, sources, upstream)
from directionfields.restore import Pipeline

SURFACE_COLOR = [0.93, 0.91, 0.87]
DARK, LIGHT = [0.15, 0.15, 0.17], [1.0, 1.0, 1.0]
# The summaries and, below them, the warnings of all blocks, in lines that end before the legend begins
# in a view of 600 pixels. It is evaluated where the data are: a server does not know this module.
CAPTION = (
    "'\\n'.join([__import__('textwrap').fill((prefix + array.GetValue(k))"
    ".replace(' %', '\\xa0%'), 56)"
    " for data in (inputs[0] if inputs[0].IsA('vtkCompositeDataSet') else [inputs[0]])"
    " for name, prefix in (('Summary', ''), ('Warnings', 'Warning: '))"
    " for array in [data.VTKObject.GetFieldData().GetAbstractArray(name)] if array"
    " for k in range(array.GetNumberOfValues())][:8])")

Picture = collections.namedtuple("Picture", "field surface glyphs legend caption view")
Picture.__doc__ = """What show() has built.

field    the filter Direction Field; its second output port are the singularities
surface  the surface that is shown: the field with normals for smooth shading
glyphs   the filter Direction Field Glyphs
legend   the scalar bar of the singularities, or None; glyphs along tensors have one of their own
caption  the annotation with the summary and the warnings, or None
view     the render view"""


def show(mesh, degree=4, view=None, *, glyphs=None, legend=True, **properties):
    """Computes the direction field of a mesh and builds the whole picture of it in a view.

    The surface is shown in a light solid colour, with glyphs of all directions and, at the
    singularities, balls that are red for a positive and blue for a negative index and as large as
    the index; below them a line that says what the field is like, and the warnings if there are
    any. Everything stays a pipeline: properties can be changed afterwards. What else the view
    shows of the mesh and of its fields is hidden.

    mesh        a source, an output port of one, or the name of a .ply, .obj, .stl or .vtp file; a
                filter with a field, or something made of one, whose field is shown as it is
    degree      directions per point, 1 to 16
    view        a render view; by default the active one, or else a new one with a white background.
                The camera is placed in front of the mesh unless the user has moved it
    glyphs      properties of the filter Direction Field Glyphs, as a dictionary
    legend      whether to add a legend and the line that sums the field up
    properties  other properties of the filter Direction Field: EnergyBias=1.0, ...

    Returns a Picture of the proxies. Where there is none, everything is as it was."""
    check_properties("DirectionFieldGlyphs", glyphs or {})
    with Pipeline():
        return draw(compute(mesh, degree, properties), view, glyphs or {}, legend)


def draw(field, view, glyphs, legend):
    """Builds the picture of a field that is there."""
    marks = glyphs_of(field, glyphs)
    if view is None:
        view = simple.GetActiveView()
        if not is_render_view(view):
            view = white_view()
    if not is_render_view(view):
        raise TypeError("show() draws in a render view.")
    is_free = is_untouched(view, field)
    # The first render would reset the camera.
    simple._DisableFirstRenderCameraReset()

    surface = show_surface(field, view)
    marks = show_glyphs(marks, view, legend)
    balls = show_singularities(field, view)
    bar = words = None
    if legend:
        bar, words = show_legend(field, balls, view)
        leave_caption(field, view)
    # Only now, since ParaView places the camera anew where something is shown in an empty view.
    hide_others(field, [marks, surface, balls and balls.Input, words], view)
    if is_free:
        place_camera(view, field)
    simple.SetActiveSource(field)
    simple.Render(view)
    return Picture(field, surface, marks, bar, words, view)


def show_active():
    """Shows the active source as show() does: what the button "Show direction field" does.

    The source may be a mesh, a field, or anything made of these, as glyphs: a field that is there
    is shown as it is, with the glyphs that it has. Of image data and grids the surface is shown. A
    new field has Unit Length. Returns the Picture, or None where there is nothing to show; then one
    sentence in ParaView's messages says why, and everything is as it was."""
    try:
        source = simple.GetActiveSource()
        with Pipeline():
            view = view_of_button()
            return draw(field_for(source, UnitLength=1), view, {}, True)
    except Exception as problem:  # A button has nobody to catch what it raises.
        complain("Show direction field", problem)
        return None


def view_of_button():
    """The view that a button of the window draws in."""
    view = simple.GetActiveView()
    return view if is_render_view(view) else simple.FindViewOrCreate("RenderView1", "RenderView")


def complain(button, problem):
    """Says in ParaView's messages, in one sentence, why a button has done nothing."""
    text = " ".join(str(problem).split()) or type(problem).__name__
    vtkOutputWindow.GetInstance().DisplayWarningText(f"{button}: {text}\n")


def hide_others(field, parts, view):
    """Hides the mesh, and what the view shows of fields and quads of it that is not a part of the
    picture."""
    kept = {(proxy_of(part), part.Port) for part in parts if part is not None}
    mesh = mesh_of(field)
    for source in sources():
        chain = upstream(source)
        belongs = proxy_of(mesh) in map(proxy_of, chain) and (
            proxy_of(source) == proxy_of(mesh) or source.GetXMLName() in BETWEEN or
            any(is_field(before) or before.GetXMLName() in MAKERS + REMESHERS for before in chain))
        for port in range(source.SMProxy.GetNumberOfOutputPorts()):
            # Curves stay over the field that is drawn to them.
            is_curves = source.GetXMLName() == "GuidanceFromCurves" and port == 1
            if (belongs and (proxy_of(source), port) not in kept and not is_curves and
                    view.FindRepresentation(source.SMProxy, port)):
                simple.Hide(simple.OutputPort(source, port), view)
        # The captions of all pictures are at the same place.
        if (not belongs and is_caption(source) and
                view.FindRepresentation(source.SMProxy, 0)):
            simple.Hide(source, view)
    simple.HideUnusedScalarBars(view)


def is_caption(source):
    """Whether show() has made an annotation; states of other versions have other expressions."""
    return source.GetXMLName() == "PythonAnnotation" and any(
        part in source.Expression for part in ("'Summary'", "negative singularities' %"))


def is_render_view(view):
    return isinstance(view, servermanager.Proxy) and view.GetXMLName() == "RenderView"


def white_view():
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.UseFXAA = 1
    return view


def part_name(part, field):
    """The name in the pipeline browser of what is made of a field: of its mesh's, in short."""
    return f"{part} of {name_of(field).removeprefix('Field of ')}"


def glyphs_of(field, properties):
    """The glyphs that a field has, or new ones."""
    marks = follower(field, "DirectionFieldGlyphs")
    if marks is None:
        marks = connect(check_properties("DirectionFieldGlyphs", {}), field, properties)
        return register(marks, part_name("Glyphs", field))
    for name, value in properties.items():
        setattr(marks, name, value)
    return marks


def color(display, rgb):
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = rgb


def show_surface(field, view):
    surface = field
    if not field.PointData.GetArray("Normals"):
        # This splits the surface at sharp edges only, and keeps the orientation of the mesh. States of
        # older versions have ParaView's own filter.
        surface = follower(field, "ShadedSurface", "PPolyDataNormals", "PolyDataNormals",
                           "SurfaceNormals")
        surface = surface or register(connect(check_properties("ShadedSurface", {}), field, {}),
                                      part_name("Surface", field))
    display = simple.Show(surface, view)
    display.SetRepresentationType("Surface")
    color(display, SURFACE_COLOR)
    display.Specular = 0.1
    display.Ambient = 0.2
    return surface


def show_glyphs(marks, view, legend):
    # The plugin gives glyphs and singularities their look.
    display = simple.Show(marks, view)
    if legend and display.ColorArrayName[1] == "PrincipalValue":
        display.SetScalarBarVisibility(view, True)
        bar = place_legend(display, view, 0.25)
        bar.ScalarBarLength = 0.4
    return marks


def show_singularities(field, view):
    """The display of the singularities, where the field comes with such an output."""
    port = singularities_port(field)
    return None if port is None else simple.Show(simple.OutputPort(field, port), view)


def leave_caption(field, view):
    """The displays of a field do not write what the caption of the picture says."""
    proxy = proxy_of(field)
    for port in range(proxy.GetNumberOfOutputPorts()):
        display = view.FindRepresentation(proxy, port)
        if display and display.GetProperty("ShowSummary"):
            servermanager._getPyProxy(display).ShowSummary = 0


def number_of(points):
    return points.GetDataInformation(points.Port).GetNumberOfPoints()


def text_color(view):
    background = view.Background if not view.UseColorPaletteForBackground else [0.32, 0.34, 0.43]
    return DARK if sum(background) > 1.5 else LIGHT


def place_legend(display, view, height):
    bar = simple.GetScalarBar(display.LookupTable, view)
    bar.WindowLocation = "Any Location"
    bar.Position = [0.87, height]
    bar.TitleFontSize = bar.LabelFontSize = 13
    bar.TitleColor = bar.LabelColor = text_color(view)
    return bar


def show_balls_legend(balls, view):
    # Balls that there are none of have no colours either.
    if balls is None or balls.LookupTable is None or number_of(balls.Input) == 0:
        return None
    balls.SetScalarBarVisibility(view, True)
    # Legend and caption must fit side by side even into a small window.
    return place_legend(balls, view, 0.03)


def show_legend(field, balls, view):
    bar = show_balls_legend(balls, view)
    words = follower(field, "PythonAnnotation")
    if words is None or not is_caption(words):
        words = simple.PythonAnnotation(registrationName=part_name("Summary", field), Input=field)
    words.Expression = CAPTION
    display = simple.Show(words, view)
    display.Color = text_color(view)
    display.WindowLocation = "Lower Left Corner"
    display.Justification = "Left"
    display.FontSize = 14
    return bar, words
