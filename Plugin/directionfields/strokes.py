# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strokes that are drawn on a surface with the mouse, and the field along them."""

import numpy as np
from paraview import servermanager
from paraview import simple
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkPolygon, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from directionfields.camera import camera_of, put_camera
from directionfields.compute import (check_properties, computed, connect, register, surface_of)
from directionfields.picture import complain, draw, view_of_button
from directionfields.pipeline import (fields_before, fields_of, input_of, is_field, mesh_of,
                                      name_of, proxy_of, sources, upstream, REMESHERS)
from directionfields.restore import Messages, Pipeline

# A stroke has a point every so many pixels of its way over the view.
STEP = 6.0
# Where the surface runs steeper from one point to the next, the stroke goes on elsewhere.
STEEPEST = 8.0
# How far a stroke is over the surface, relative to the diagonal of its box.
LIFT = 0.002
# How far from a stroke it can be pointed at, in pixels.
REACH = 15.0


def draw_stroke(path):
    """Lays a way over the active view on the surface below it, adds that to the strokes of the
    surface, and makes its field follow them all: what the button "Draw strokes" does.

    path  the pixels of the way, as (x, y) from the lower left corner of the view

    The surface is the nearest one under the way that belongs to the selected source, or else to
    anything that the view shows. Where the way leaves the surface, or goes on behind it, the stroke
    ends and another one begins. The strokes are a source, Surface Strokes; Guidance From Curves and
    Direction Field, which then constrains its directions to them, are made if they are not there. A
    Direction Field that is there keeps its other properties.

    Returns the Surface Strokes, or None where nothing could be drawn; then one sentence in
    ParaView's messages says why, and everything is as it was."""
    try:
        view = view_of_button()
        with Pipeline():
            return add(*stroke_under(path, view), view)
    except Exception as problem:  # A button has nobody to catch what it raises.
        complain("Draw strokes", problem)
        return None


def remove_stroke(pixel):
    """Takes the stroke away that is near a pixel of the active view, or else the last one; with the
    last one, what draw_stroke() has put between the mesh and its field. Returns whether there was
    one, and says so in a sentence if not."""
    try:
        view = view_of_button()
        with Pipeline():
            remove(pixel, view)
        return True
    except Exception as problem:
        complain("Draw strokes", problem)
        return False


class Screen:
    """The way between the pixels of a view and the points of its space."""

    def __init__(self, view):
        self.size = np.array(view.ViewSize, float)
        matrix = view.GetActiveCamera().GetCompositeProjectionTransformMatrix(
            self.size[0] / self.size[1], -1.0, 1.0)
        self.matrix = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        self.inverse = np.linalg.inv(self.matrix)

    def ray(self, pixel):
        """The nearest and the farthest point that a pixel shows."""
        x, y = 2.0 * (np.array(pixel) + 0.5) / self.size - 1.0
        ends = self.inverse @ np.array([[x, x], [y, y], [-1.0, 1.0], [1.0, 1.0]])
        return (ends[:3] / ends[3]).T

    def pixels(self, points):
        seen = np.c_[points, np.ones(len(points))] @ self.matrix.T
        return (0.5 * (seen[:, :2] / seen[:, 3:] + 1.0)) * self.size - 0.5


class Surface:
    """The polygons of a source, which rays can be sent at."""

    def __init__(self, source):
        data = servermanager.Fetch(source)
        if data.IsA("vtkCompositeDataSet"):
            append, blocks = vtkAppendPolyData(), data.NewIterator()
            blocks.InitTraversal()
            while not blocks.IsDoneWithTraversal():
                append.AddInputData(blocks.GetCurrentDataObject())
                blocks.GoToNextItem()
            append.Update()
            data = append.GetOutput()
        # Lines and points are not what is drawn on.
        self.data = data.NewInstance()
        self.data.SetPoints(data.GetPoints())
        self.data.SetPolys(data.GetPolys())
        self.data.SetStrips(data.GetStrips())
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.data)
        if self.data.GetNumberOfCells():
            self.locator.BuildLocator()

    def hit(self, ray):
        """The first point of the surface on a ray, or None."""
        if not self.data.GetNumberOfCells():
            return None
        t, part, point, coordinates = mutable(0.0), mutable(0), [0.0] * 3, [0.0] * 3
        found = self.locator.IntersectWithLine(ray[0], ray[1], 0.0, t, point, coordinates, part)
        return np.array(point) if found else None

    def over(self, point, eye):
        """The nearest place to a point, on the eye's side so little over the surface that the edges
        of its faces do not hide a line from there to the next place."""
        found, cell, part, distance = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
        self.locator.FindClosestPoint(point, found, cell, part, distance)
        normal = [0.0] * 3
        vtkPolygon.ComputeNormal(self.data.GetCell(int(cell)).GetPoints(), normal)
        side = np.sign(np.dot(normal, np.array(eye) - found))
        return np.array(found) + LIFT * self.data.GetLength() * side * np.array(normal)


# The last surface that was drawn on, and what it was made of.
_last = {}


def surface_under(source):
    """The polygons of a source; those of the last time where its data are the same."""
    source.UpdatePipeline()
    filter = source.GetClientSideObject()
    data = filter.GetOutputDataObject(source.Port) if filter else None
    key = (source.SMProxy.GetGlobalID(), source.Port, data.GetMTime()) if data else None
    if key is None or key not in _last:
        _last.clear()
        _last[key] = Surface(source)
    return _last[key]


def evenly(path):
    """Points of a way at equal distances, with its end."""
    path = np.array(path, float).reshape(-1, 2)
    lengths = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    places = np.linspace(0.0, lengths[-1], max(int(round(lengths[-1] / STEP)), 1) + 1)
    return np.c_[np.interp(places, lengths, path[:, 0]), np.interp(places, lengths, path[:, 1])]


def laid(path, surface, screen):
    """The parts of a way that lie on a surface, as lists of points."""
    parts, last = [[]], None
    for pixel in evenly(path):
        ray = screen.ray(pixel)
        point = surface.hit(ray)
        if point is not None and last is not None:
            # How long a step is that the eye sees straight from the front.
            beside = screen.ray(pixel + [STEP, 0.0])
            part = np.linalg.norm(point - ray[0]) / np.linalg.norm(ray[1] - ray[0])
            flat = np.linalg.norm((1.0 - part) * (beside[0] - ray[0]) + part * (beside[1] - ray[1]))
            if np.linalg.norm(point - last) > STEEPEST * flat:
                last = None
        if point is None or last is None:
            parts.append([])
        if point is not None:
            parts[-1].append((point, ray[0]))
        last = point
    return [smooth(*np.swapaxes(part, 0, 1), surface) for part in parts if len(part) > 1]


def smooth(points, eyes, surface):
    """The mouse trembles: without that, over the surface."""
    for _ in range(2):
        points[1:-1] = 0.25 * points[:-2] + 0.5 * points[1:-1] + 0.25 * points[2:]
    return [surface.over(point, eye) for point, eye in zip(points, eyes)]


def base_of(source):
    """The mesh that a source is or is made of."""
    fields = fields_before(source)
    if fields:
        return mesh_of(fields[0])
    made = [before for before in upstream(source) if before.GetXMLName() in REMESHERS]
    return mesh_of(made[-1]) if made else source


def stroke_under(path, view):
    """The mesh under a way over a view, and the parts of the way on it."""
    if len(path) < 2:
        raise ValueError("Drag the mouse over a surface to draw a stroke.")
    shown = [display.Input for display in view.Representations
             if display.Visibility and display.GetProperty("Input") is not None]
    active = simple.GetActiveSource()
    screen, tried = Screen(view), []
    for source in ([active] if active else []) + shown:
        mesh = base_of(source)
        if mesh.GetXMLName() == "SurfaceStrokes" or proxy_of(mesh) in tried:
            continue
        tried.append(proxy_of(mesh))
        try:
            surface, is_new = surface_of(mesh)
        except ValueError:  # An annotation, say, has no surface.
            continue
        parts = laid(path, surface_under(surface), screen)
        if parts:
            if is_new:
                register(surface, f"Surface of {name_of(mesh)}")
            return mesh, simple.OutputPort(surface, surface.Port), parts
    raise ValueError("There is no surface under the stroke: show a mesh, and draw on it.")


def guided_of(mesh):
    """The Direction Field of a mesh that follows strokes, its guidance, and these; or Nones."""
    for field in reversed(fields_of(mesh)):
        guidance = input_of(field)
        if guidance is not None and guidance.GetXMLName() == "GuidanceFromCurves":
            curves = guidance.Curves
            if curves is not None and curves.GetXMLName() == "SurfaceStrokes":
                return field, guidance, curves
    return None, None, None


def add(mesh, surface, parts, view):
    field, guidance, strokes = guided_of(mesh)
    rows = list(strokes.Points) if strokes else []
    first = int(max(rows[0::4], default=-1.0)) + 1
    for k, part in enumerate(parts):
        for point in part:
            rows += [float(first + k)] + [float(x) for x in point]
    if strokes is None:
        strokes = connected(rows, mesh)
        field, guidance = guided(mesh, surface, strokes)
    else:
        strokes.Points = rows
    show(field, strokes, view)
    return strokes


def connected(rows, mesh):
    strokes = servermanager.sources.SurfaceStrokes()
    controller = servermanager.ParaViewPipelineController()
    controller.PreInitializeProxy(strokes)
    strokes.Points = rows
    controller.PostInitializeProxy(strokes)
    return register(strokes, f"Strokes on {name_of(mesh)}")


def guided(mesh, surface, strokes):
    """The field of a mesh, now along strokes, and its guidance."""
    name = name_of(mesh)
    known = [field for field in fields_of(mesh) if field.GetXMLName() == "DirectionField"]
    if known and (known[-1].ConstrainGuidance or known[-1].Alignment == "Point Vectors"):
        raise ValueError(f"{name_of(known[-1])} follows other vectors already: turn Constrain "
                         "Guidance and Point Vectors off in its Properties, press Apply, and draw again.")
    base = input_of(known[-1]) if known else surface
    guidance = connect(check_properties("GuidanceFromCurves", {}), base,
                       {"Curves": strokes, "Degree": known[-1].Degree if known else 4})
    register(guidance, f"Guidance of {name}")
    guidance.UpdatePipeline()
    along = {"GuidanceVectors": "GuidanceVectors", "GuidanceWeights": "GuidanceWeights",
             "ConstrainGuidance": 1}
    if not known:
        field = computed(guidance, 4, {"UnitLength": 1, **along})
        simple.RenameSource(f"Field of {name}", field)
        return field, guidance
    field = known[-1]
    with Messages() as messages:
        field.Input = simple.OutputPort(guidance, 0)
        for key, value in along.items():
            setattr(field, key, value)
        field.UpdatePipeline()
    if not is_field(field):
        raise ValueError(messages.errors[0] if messages.errors else f"{name} has no field.")
    return field, guidance


def show(field, strokes, view):
    """Shows the strokes, and the field unless the view shows something made of it already."""
    followed = [display for display in view.Representations
                if display.Visibility and display.GetProperty("Input") is not None and
                proxy_of(field) in map(proxy_of, upstream(display.Input))]
    simple._DisableFirstRenderCameraReset()
    # The camera stays where the stroke was drawn.
    before, scale = camera_of(view), view.CameraParallelScale
    if not followed:
        draw(simple.OutputPort(field, 0), view, {}, True)
    simple.Show(strokes, view)
    put_camera(view, before)
    view.CameraParallelScale = scale
    simple.SetActiveSource(field)
    simple.Render(view)


def remove(pixel, view):
    known = [source for source in sources() if source.GetXMLName() == "SurfaceStrokes" and
             len(source.Points)]
    if not known:
        raise ValueError("There are no strokes.")
    screen, nearest = Screen(view), (REACH, None, None)
    for strokes in known:
        rows = np.array(list(strokes.Points)).reshape(-1, 4)
        distances = np.linalg.norm(screen.pixels(rows[:, 1:]) - np.array(pixel, float), axis=1)
        k = int(np.argmin(distances))
        if distances[k] < nearest[0]:
            nearest = distances[k], strokes, rows[k, 0]
    _, strokes, number = nearest
    strokes = strokes or known[-1]
    rows = np.array(list(strokes.Points)).reshape(-1, 4)
    rows = rows[rows[:, 0] != (rows[-1, 0] if number is None else number)]
    if len(rows):
        strokes.Points = [float(x) for x in rows.ravel()]
    else:
        take_out(strokes)
    simple.Render(view)


def take_out(strokes):
    """Takes strokes and their guidance out of the pipeline; fields are free again."""
    for guidance in [source for source in sources()
                     if source.GetXMLName() == "GuidanceFromCurves" and
                     proxy_of(source.Curves) == proxy_of(strokes)]:
        for user in sources():
            if proxy_of(input_of(user)) == proxy_of(guidance):
                if user.GetProperty("ConstrainGuidance"):
                    user.ConstrainGuidance = 0
                user.Input = guidance.Input
        simple.Delete(guidance)
    simple.Delete(strokes)
