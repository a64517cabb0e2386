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

from directionfields.files import read

SURFACE_COLOR = [0.93, 0.91, 0.87]
GLYPH_COLOR = [0.00, 0.42, 0.46]
POSITIVE_COLOR = [0.84, 0.10, 0.11]
NEGATIVE_COLOR = [0.09, 0.30, 0.86]
DARK, LIGHT = [0.15, 0.15, 0.17], [1.0, 1.0, 1.0]
MOST_DIRECTIONS = 16

Picture = collections.namedtuple("Picture", "field surface glyphs legend caption view")
Picture.__doc__ = """What show() has built.

field    the filter Direction Field; its second output port are the singularities
surface  the surface that is shown: the field with normals for smooth shading
glyphs   the filter Direction Field Glyphs
legend   the scalar bar of the singularities, or None
caption  the annotation that counts the singularities, or None
view     the render view"""


def show(mesh, degree=4, view=None, *, glyphs=None, legend=True, **properties):
    """Computes the direction field of a mesh and builds the whole picture of it in a view.

    The surface is shown in a light solid colour, with glyphs of all directions and, at the
    singularities, spheres that are red for a positive and blue for a negative index and as large as
    the index. Everything stays a pipeline: properties can be changed afterwards.

    mesh        a source, an output port of one, a Direction Field filter, which is shown as it is,
                or the name of a .ply, .obj, .stl or .vtp file
    degree      directions per point, 1 to 16
    view        a render view; by default the active one, or else a new one with a white background.
                In an empty view the camera is placed in front of the mesh
    glyphs      properties of the filter Direction Field Glyphs, as a dictionary
    legend      whether to add a legend and the number of singularities
    properties  other properties of the filter Direction Field: EnergyBias=1.0, ...

    Returns a Picture of the proxies."""
    marks = new("DirectionFieldGlyphs", glyphs or {})
    field = compute(mesh, degree, properties)
    marks = connect(marks, field, glyphs or {})
    if view is None:
        view = simple.GetActiveView()
        if not is_render_view(view):
            view = white_view()
    if not is_render_view(view):
        raise TypeError("show() draws in a render view.")
    empty = not any(shown.Visibility for shown in view.Representations)
    if simple.GetRepresentation(field.Input, view):
        simple.Hide(field.Input, view)

    surface = show_surface(field, view)
    marks = show_glyphs(marks, view)
    lookup = show_singularities(field, view)
    bar = caption = None
    if legend:
        bar, caption = show_legend(field, lookup, view)
    if empty:
        place_camera(view, field)
    simple.SetActiveSource(field)
    simple.Render(view)
    return Picture(field, surface, marks, bar, caption, view)


def is_render_view(view):
    return isinstance(view, servermanager.Proxy) and view.GetXMLName() == "RenderView"


def white_view():
    view = simple.CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.UseFXAA = 1
    return view


def new(name, properties):
    """A filter of the plugin and, to find mistakes before anything is computed, a look at the names
    of its properties. paraview.simple knows the filter only if it has been told."""
    # ParaView 6 always knows.
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
        field = new("DirectionField", properties)
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
        surface = normals(registrationName="Surface", Input=field, FeatureAngle=60.0, Consistency=0)
    display = simple.Show(surface, view)
    display.SetRepresentationType("Surface")
    color(display, SURFACE_COLOR)
    display.Specular = 0.1
    display.Ambient = 0.2
    if surface is not field and simple.GetRepresentation(field, view):
        simple.Hide(field, view)
    return surface


def show_glyphs(marks, view):
    display = simple.Show(marks, view)
    display.SetRepresentationType("Surface")
    color(display, GLYPH_COLOR)
    display.Ambient = 0.3
    return marks


def show_singularities(field, view):
    singularities = simple.OutputPort(field, 1)
    display = simple.Show(singularities, view)
    display.SetRepresentationType("3D Glyphs")
    display.GlyphType = "Sphere"
    display.GlyphType.ThetaResolution = 24
    display.GlyphType.PhiResolution = 16
    # The size follows the magnitude of the index: a negative one would turn its sphere inside out,
    # which cannot be seen.
    display.Scaling = 1
    display.ScaleMode = "Magnitude"
    display.SelectScaleArray = "SingularityIndex"
    display.ScaleFactor = 0.022 * diagonal(field)
    display.Specular = 0.4
    # The spheres have a color map of their own, which the index of the cells does not share. It is
    # set by hand because ColorBy() warns where there is no singularity to take the range from.
    display.UseSeparateColorMap = 1
    lookup = simple.GetColorTransferFunction("SingularityIndex", display, separate=True)
    display.ColorArrayName = ["POINTS", "SingularityIndex"]
    display.LookupTable = lookup
    lookup.AutomaticRescaleRangeMode = "Never"
    lookup.ColorSpace = "Step"
    lookup.Discretize = 1
    lookup.NumberOfTableValues = 2
    lookup.RGBPoints = [-1.0, *NEGATIVE_COLOR, 0.0, *NEGATIVE_COLOR,
                        0.0, *POSITIVE_COLOR, 1.0, *POSITIVE_COLOR]
    lookup.AnnotationsInitialized = 1
    lookup.Annotations = ["-0.5", "negative", "0.5", "positive"]
    return lookup


def text_color(view):
    background = view.Background if not view.UseColorPaletteForBackground else [0.32, 0.34, 0.43]
    return DARK if sum(background) > 1.5 else LIGHT


def show_legend(field, lookup, view):
    bar = simple.GetScalarBar(lookup, view)
    bar.Title = "Singularities"
    bar.ComponentTitle = ""
    bar.HorizontalTitle = 1
    bar.DrawTickMarks = bar.DrawTickLabels = bar.AddRangeLabels = 0
    bar.ScalarBarLength = 0.12
    bar.WindowLocation = "Any Location"
    # Legend and caption must fit side by side even into a small window.
    bar.Position = [0.87, 0.03]
    bar.TitleFontSize = bar.LabelFontSize = 13
    bar.TitleColor = bar.LabelColor = text_color(view)
    bar.Visibility = 1
    caption = simple.PythonAnnotation(
        registrationName="Number of singularities", Input=simple.OutputPort(field, 1),
        ArrayAssociation="Point Data",
        Expression="'%d positive, %d negative singularities' % "
                   "(sum(SingularityIndex > 0), sum(SingularityIndex < 0))")
    display = simple.Show(caption, view)
    display.Color = text_color(view)
    display.WindowLocation = "Lower Left Corner"
    display.FontSize = 14
    return bar, caption


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
    # The first render would reset the camera.
    simple._DisableFirstRenderCameraReset()
    view.CameraFocalPoint = list(middle @ axes)
    view.CameraPosition = list((middle + [0.0, 0.0, distance]) @ axes)
    view.CameraViewUp = list(axes[1])
    view.CenterOfRotation = list(0.5 * (low + high))
