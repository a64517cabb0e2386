# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a direction field."""

import collections
import itertools
import math
import os

import numpy as np
from paraview import servermanager
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow

from directionfields.files import read
from directionfields.pipeline import field_of, fields_of, follower, input_of, proxy_of

SURFACE_COLOR = [0.93, 0.91, 0.87]
DARK, LIGHT = [0.15, 0.15, 0.17], [1.0, 1.0, 1.0]
MOST_DIRECTIONS = 16
# The summaries and, below them, the warnings of all blocks. It is evaluated where the data are: a
# server does not know this module.
CAPTION = (
    "'\\n'.join([__import__('textwrap').fill(prefix + array.GetValue(k), 96)"
    " for data in (inputs[0] if inputs[0].IsA('vtkCompositeDataSet') else [inputs[0]])"
    " for name, prefix in (('Summary', ''), ('Warnings', 'Warning: '))"
    " for array in [data.VTKObject.GetFieldData().GetAbstractArray(name)] if array"
    " for k in range(array.GetNumberOfValues())][:8])")

Picture = collections.namedtuple("Picture", "field surface glyphs legend caption view")
Picture.__doc__ = """What show() has built.

field    the filter Direction Field; its second output port are the singularities
surface  the surface that is shown: the field with normals for smooth shading
glyphs   the filter Direction Field Glyphs
legend   the scalar bar of the singularities, or None
caption  the annotation with the summary and the warnings, or None
view     the render view"""


def show(mesh, degree=4, view=None, *, glyphs=None, legend=True, **properties):
    """Computes the direction field of a mesh and builds the whole picture of it in a view.

    The surface is shown in a light solid colour, with glyphs of all directions and, at the
    singularities, balls that are red for a positive and blue for a negative index and as large as
    the index; below them a line that says what the field is like, and the warnings if there are
    any. Everything stays a pipeline: properties can be changed afterwards. What else the view
    shows of the mesh and of its fields is hidden.

    mesh        a source, an output port of one, a Direction Field filter, which is shown as it is,
                or the name of a .ply, .obj, .stl or .vtp file
    degree      directions per point, 1 to 16
    view        a render view; by default the active one, or else a new one with a white background.
                In an empty view the camera is placed in front of the mesh
    glyphs      properties of the filter Direction Field Glyphs, as a dictionary
    legend      whether to add a legend and the line that sums the field up
    properties  other properties of the filter Direction Field: EnergyBias=1.0, ...

    Returns a Picture of the proxies."""
    check_properties("DirectionFieldGlyphs", glyphs or {})
    field = compute(mesh, degree, properties)
    marks = glyphs_of(field, glyphs or {})
    if view is None:
        view = simple.GetActiveView()
        if not is_render_view(view):
            view = white_view()
    if not is_render_view(view):
        raise TypeError("show() draws in a render view.")
    empty = not any(shown.Visibility for shown in view.Representations)
    # The first render would reset the camera.
    simple._DisableFirstRenderCameraReset()

    surface = show_surface(field, view)
    marks = show_glyphs(marks, view)
    lookup = show_singularities(field, view)
    bar = words = None
    if legend:
        bar, words = show_legend(field, lookup, view)
    # Only now, since ParaView places the camera anew where something is shown in an empty view.
    hide_others(field, [marks, surface, words], view)
    if empty:
        place_camera(view, field)
    simple.SetActiveSource(field)
    simple.Render(view)
    return Picture(field, surface, marks, bar, words, view)


def show_active():
    """Shows the active source as show() does: what the button "Show direction field" does.

    The source may be a mesh, its field, or anything made of that, as its glyphs: a field that is
    there is shown as it is, with the glyphs that it has. Returns the Picture, or None where there
    is nothing to show; why is said in ParaView's messages."""
    source = simple.GetActiveSource()
    try:
        if source is None:
            raise ValueError("There is no mesh: open one, press Apply, and select it.")
        fields = fields_of(source)
        field = field_of(source) or (fields[-1] if fields else None)
        view = simple.GetActiveView()
        if not is_render_view(view):
            view = simple.FindViewOrCreate("RenderView1", "RenderView")
        return show(field or source, view=view)
    except (ValueError, TypeError, RuntimeError) as problem:
        vtkOutputWindow.GetInstance().DisplayWarningText(f"Show direction field: {problem}\n")
        return None


def hide_others(field, parts, view):
    """Hides the mesh, and what the view shows of fields of it that is not a part of the picture."""
    kept = {(proxy_of(part), 0) for part in parts if part is not None} | {(proxy_of(field), 1)}
    mesh = proxy_of(input_of(field))
    for source in list(simple.GetSources().values()):
        before = field_of(source)
        belongs = before is not None and proxy_of(input_of(before)) == mesh
        for port in range(source.GetNumberOfOutputPorts()):
            if ((belongs or proxy_of(source) == mesh) and (proxy_of(source), port) not in kept and
                    view.FindRepresentation(source.SMProxy, port)):
                simple.Hide(simple.OutputPort(source, port), view)


def is_render_view(view):
    return isinstance(view, servermanager.Proxy) and view.GetXMLName() == "RenderView"


def white_view():
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.UseFXAA = 1
    return view


def check_properties(name, properties):
    """Finds mistakes before anything is computed. paraview.simple knows the filter only if it has
    been told; ParaView 6 always knows."""
    if not hasattr(servermanager.filters, name) and hasattr(servermanager, "updateModules"):
        servermanager.updateModules()
    if not hasattr(servermanager.filters, name):
        raise RuntimeError(f"ParaView does not know the filter {name}: load the plugin "
                           "DirectionFields, on a remote server, too.")
    proxy = getattr(servermanager.filters, name)()
    known = set(proxy.ListProperties()) - {"Input"}
    unknown = sorted(set(properties) - known)
    if unknown:
        raise TypeError(f"{proxy.GetXMLLabel()} has no property {unknown[0]}, but "
                        f"{', '.join(sorted(known))}.")
    return proxy


def connect(proxy, source, properties):
    controller = servermanager.ParaViewPipelineController()
    controller.PreInitializeProxy(proxy)
    proxy.Input = source
    for name, value in properties.items():
        setattr(proxy, name, value)
    controller.PostInitializeProxy(proxy)
    controller.RegisterPipelineProxy(proxy)
    return proxy


def glyphs_of(field, properties):
    """The glyphs that a field has, or new ones."""
    marks = follower(field, "DirectionFieldGlyphs")
    if marks is None:
        return connect(check_properties("DirectionFieldGlyphs", {}), field, properties)
    for name, value in properties.items():
        setattr(marks, name, value)
    return marks


def compute(mesh, degree, properties):
    """The filter with a field that is known to be good."""
    if isinstance(mesh, (str, os.PathLike)):
        mesh = read(mesh)
    if mesh is None:
        raise ValueError("There is no mesh: open one and select it.")
    if not isinstance(mesh, servermanager.SourceProxy):
        raise TypeError("show() takes a source, an output port or the name of a file, not "
                        f"{type(mesh).__name__}.")
    if mesh.GetXMLName() == "DirectionField":
        # The field is on the first port, whichever one was given.
        field = simple.OutputPort(mesh, 0)
        if properties:
            raise TypeError("show() does not change the properties of a filter that it is given.")
    else:
        if isinstance(degree, bool) or degree not in range(1, MOST_DIRECTIONS + 1):
            raise ValueError(f"The degree is a whole number from 1 to {MOST_DIRECTIONS}, not "
                             f"{degree!r}.")
        field = check_properties("DirectionField", properties)
        mesh.UpdatePipeline()
        if mesh.GetDataInformation().GetNumberOfCells() == 0:
            raise ValueError("The mesh has no cells.")
        # The degree decides which alignments there are, hence it is set first.
        connect(field, mesh, {"Degree": int(degree), **properties})
    field.UpdatePipeline()
    if not field.GetDataInformation(0).GetCellDataInformation().GetArrayInformation(
            "SingularityIndex"):
        raise RuntimeError("The mesh has no direction field; the filter's message says why.")
    return field


def diagonal(field):
    bounds = field.GetDataInformation(0).GetBounds()
    return sum((bounds[2 * k + 1] - bounds[2 * k]) ** 2 for k in range(3)) ** 0.5


def color(display, rgb):
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = rgb


def show_surface(field, view):
    surface = field
    if not field.PointData.GetArray("Normals"):
        # This splits the surface at sharp edges only, and keeps the orientation of the mesh.
        # ParaView 5.13 has given the filter another name.
        normals = getattr(simple, "SurfaceNormals", None) or simple.GenerateSurfaceNormals
        surface = follower(field, "PPolyDataNormals", "PolyDataNormals", "SurfaceNormals") or normals(
            registrationName="Surface", Input=field, FeatureAngle=60.0, Consistency=0)
    display = simple.Show(surface, view)
    display.SetRepresentationType("Surface")
    color(display, SURFACE_COLOR)
    display.Specular = 0.1
    display.Ambient = 0.2
    return surface


def show_glyphs(marks, view):
    # The plugin gives glyphs and singularities their look.
    simple.Show(marks, view)
    return marks


def show_singularities(field, view):
    return simple.Show(simple.OutputPort(field, 1), view).LookupTable


def text_color(view):
    background = view.Background if not view.UseColorPaletteForBackground else [0.32, 0.34, 0.43]
    return DARK if sum(background) > 1.5 else LIGHT


def show_legend(field, lookup, view):
    display = simple.GetRepresentation(simple.OutputPort(field, 1), view)
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(lookup, view)
    bar.WindowLocation = "Any Location"
    # Legend and caption must fit side by side even into a small window.
    bar.Position = [0.87, 0.03]
    bar.TitleFontSize = bar.LabelFontSize = 13
    bar.TitleColor = bar.LabelColor = text_color(view)
    words = follower(field, "PythonAnnotation") or simple.PythonAnnotation(
        registrationName="Summary", Input=field, Expression=CAPTION)
    display = simple.Show(words, view)
    display.Color = text_color(view)
    display.WindowLocation = "Lower Left Corner"
    display.FontSize = 14
    return bar, words


def extremes(field):
    """The points that the camera has to see: those of the surface, or, where they would have to be
    fetched from a server or from blocks, the corners of the box around it."""
    if not servermanager.ActiveConnection.IsRemote():
        surface = servermanager.Fetch(field)
        if surface.IsA("vtkPolyData"):
            return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    bounds = field.GetDataInformation(0).GetBounds()
    return np.array(list(itertools.product(bounds[0:2], bounds[2:4], bounds[4:6])))


def place_camera(view, field):
    """In front of the mesh, a little to the left and above, y upwards; flat ones from above. The
    mesh fills the view but for a margin, a little more of it at the bottom, where the caption is.
    ParaView's own ResetCamera() leaves half of the view empty."""
    points = extremes(field)
    low, high = points.min(axis=0), points.max(axis=0)
    towards, up = np.array([-0.25, 0.22, 1.0]), np.array([0.0, 1.0, 0.0])
    if min(high - low) < 0.05 * max(high - low):
        thin = np.argmin(high - low)
        towards = np.eye(3)[thin]
        if thin == 1:
            up = np.array([0.0, 0.0, -1.0])
    towards = towards / np.linalg.norm(towards)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    axes = np.array([right, np.cross(towards, right), towards])
    seen = points @ axes.T
    middle = 0.5 * (seen.min(axis=0) + seen.max(axis=0))
    x, y, z = np.abs(seen[:, 0] - middle[0]), np.abs(seen[:, 1] - middle[1]), seen[:, 2] - middle[2]

    slope = math.tan(math.radians(0.5 * view.CameraViewAngle))
    aspect = view.ViewSize[0] / max(view.ViewSize[1], 1)
    distance = max(np.max(z + x / (0.92 * slope * aspect)), np.max(z + y / (0.84 * slope)), 1e-6)
    middle[1] -= 0.05 * distance * slope
    view.CameraFocalPoint = list(middle @ axes)
    view.CameraPosition = list((middle + [0.0, 0.0, distance]) @ axes)
    view.CameraViewUp = list(axes[1])
    view.CenterOfRotation = list(0.5 * (low + high))
