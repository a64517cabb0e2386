# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strokes that are drawn on a surface with the mouse, and the field along them."""

import numpy as np
from paraview import servermanager
from paraview import simple
from paraview.modules.vtkRemotingViews import vtkSMSelectionHelper
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolygon, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from directionfields.camera import camera_of, put_camera
from directionfields.compute import (check_properties, computed, connect, register, surface_of)
from directionfields.picture import complain, draw, view_of_button
from directionfields.pipeline import (fields_before, fields_of, input_of, is_field, mesh_of,
                                      name_of, proxy_of, sources, upstream, REMESHERS)
from directionfields.restore import Messages, Pipeline, Properties

# A stroke has a point every so many pixels of its way over the view.
STEP = 6.0
# Where the surface runs steeper from one point to the next, the stroke goes on elsewhere.
STEEPEST = 8.0
# How far a stroke is over the surface, relative to the diagonal of its box.
LIFT = 0.002
# How far from a stroke it can be pointed at, in pixels.
REACH = 15.0
# Surfaces are at the same place where they differ by less than this part of the depth of the view.
SAME = 1e-6


def draw_stroke(path):
    """Lays a way over the active view on the surface below it, adds that to the strokes of the
    surface, and makes its field follow them all: what the button "Draw strokes" does.

    path  the pixels of the way, as (x, y) from the lower left corner of the view

    The surface is that of what the view shows which is the nearest one where the way begins. Where
    the way leaves the surface, or goes on behind it or behind another one, the stroke ends and
    another one begins. The field is the selected one, if it is on that surface, or else the newest. The strokes are a source, Surface Strokes; Guidance From Curves and
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


def select_stroke(pixel):
    """Selects the stroke that is near a pixel of the active view, which ParaView highlights, for
    remove_stroke(); near none, none is selected any more. Returns its Surface Strokes and its
    number there, or None; the field is not computed again."""
    try:
        return select(pixel, view_of_button())
    except Exception as problem:
        complain("Draw strokes", problem)
        return None


def remove_stroke(pixel):
    """Takes the selected stroke away, or else the one that is near a pixel of the active view, or
    else the last one that was drawn and that the view shows; with the last one of a surface, what draw_stroke() has put
    between the mesh and its field, unless other filters have that as an input, too. Returns whether there was
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
        # Else rays might pass through edges.
        close = 1e-6 * self.data.GetLength()
        found = self.locator.IntersectWithLine(ray[0], ray[1], close, t, point, coordinates, part)
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


# The surfaces under the last stroke, by what they were made of.
_last = {}


def surfaces_under(found):
    """The polygons of some sources; those of the last time where their data are the same."""
    known = dict(_last)
    _last.clear()
    surfaces = []
    for source in found:
        source.UpdatePipeline()
        filter = source.GetClientSideObject()
        data = filter.GetOutputDataObject(source.Port) if filter else None
        key = (source.SMProxy.GetGlobalID(), source.Port, data.GetMTime()) if data else None
        surface = known.get(key) if data else None
        surfaces.append(surface or Surface(source))
        if data:
            _last[key] = surfaces[-1]
    return surfaces


def evenly(path):
    """Points of a way at equal distances, with its end."""
    path = np.array(path, float).reshape(-1, 2)
    lengths = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    places = np.linspace(0.0, lengths[-1], max(int(round(lengths[-1] / STEP)), 1) + 1)
    return np.c_[np.interp(places, lengths, path[:, 0]), np.interp(places, lengths, path[:, 1])]


def depth(point, ray):
    """How far a point is on the way from the start of a ray to its end."""
    return np.linalg.norm(point - ray[0]) / np.linalg.norm(ray[1] - ray[0])


def nearest(surfaces, ray):
    """The surface that a ray meets first, the first one of those at the same place, and where; or
    Nones."""
    hits = [(surface, surface.hit(ray)) for surface in surfaces]
    hits = [(surface, point) for surface, point in hits if point is not None]
    first = min((depth(point, ray) for _, point in hits), default=0.0)
    return next(((surface, point) for surface, point in hits
                 if depth(point, ray) <= first + SAME), (None, None))


def laid(path, surfaces, screen):
    """The first of surfaces that a way meets, and its parts there, as lists of points; or None."""
    parts, last, surface = [[]], None, None
    for pixel in evenly(path):
        ray = screen.ray(pixel)
        met, point = nearest(surfaces, ray)
        surface = surface or met
        if met is not surface:
            point = None
        if point is not None and last is not None:
            # How long a step is that the eye sees straight from the front.
            beside = screen.ray(pixel + [STEP, 0.0])
            part = depth(point, ray)
            flat = np.linalg.norm((1.0 - part) * (beside[0] - ray[0]) + part * (beside[1] - ray[1]))
            if np.linalg.norm(point - last) > STEEPEST * flat:
                last = None
        if point is None or last is None:
            parts.append([])
        if point is not None:
            parts[-1].append((point, ray[0]))
        last = point
    return surface, [smooth(*np.swapaxes(part, 0, 1), surface) for part in parts if len(part) > 1]


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
    selected = [base_of(active)] if active else []
    # What is selected comes first, where two are at the same place.
    meshes = sorted(map(base_of, shown),
                    key=lambda mesh: proxy_of(mesh) not in map(proxy_of, selected))
    found, tried = [], []
    for mesh in meshes:
        if mesh.GetXMLName() == "SurfaceStrokes" or proxy_of(mesh) in tried:
            continue
        tried.append(proxy_of(mesh))
        try:
            found.append((mesh, *surface_of(mesh)))
        except ValueError:  # An annotation, say, has no surface.
            continue
    surfaces = surfaces_under([surface for _, surface, _ in found])
    met, parts = laid(path, surfaces, Screen(view))
    if not parts:
        raise ValueError("There is no surface under the stroke: show a mesh, and draw on it.")
    mesh, surface, is_new = found[surfaces.index(met)]
    if is_new:
        register(surface, f"Surface of {name_of(mesh)}")
    return mesh, simple.OutputPort(surface, surface.Port), parts


def fields_to_guide(mesh):
    """The Direction Fields of a mesh that may follow a stroke, the newest last: those that are
    selected, or else all."""
    fields = [field for field in fields_of(mesh) if field.GetXMLName() == "DirectionField"]
    chain = list(map(proxy_of, upstream(simple.GetActiveSource())))
    return [field for field in fields if proxy_of(field) in chain] or fields


def guided_of(fields):
    """The one of fields that follows strokes, its guidance, and these; or Nones."""
    for field in reversed(fields):
        guidance = input_of(field)
        if guidance is not None and guidance.GetXMLName() == "GuidanceFromCurves":
            curves = guidance.Curves
            if curves is not None and curves.GetXMLName() == "SurfaceStrokes":
                return field, guidance, curves
    return None, None, None


# What makes a field follow its guidance.
GUIDED = {"GuidanceVectors": "GuidanceVectors", "GuidanceWeights": "GuidanceWeights",
          "ConstrainGuidance": 1}
# The identifier of the Surface Strokes that were drawn last.
_drawn = None


def add(mesh, surface, parts, view):
    global _drawn
    fields = fields_to_guide(mesh)
    field, _, strokes = guided_of(fields)
    empty = emptied(mesh) if strokes is None else None
    rows = list(strokes.Points) if strokes else []
    first = int(max(rows[0::4], default=-1.0)) + 1
    for k, part in enumerate(parts):
        for point in part:
            rows += [float(first + k)] + [float(x) for x in point]
    changed = {one: ["Points"] for one in (strokes, empty) if one}
    changed.update({one: ["Input", *GUIDED] for one in fields[-1:]})
    with Properties(changed):
        if strokes is None:
            strokes = empty or connected(mesh)
            strokes.Points = rows
            field = guided(mesh, surface, strokes, fields)
        else:
            strokes.Points = rows
        show(field, strokes, view)
    _drawn = strokes.SMProxy.GetGlobalID()
    return strokes


def emptied(mesh):
    """The strokes of a mesh that have been taken away, and that other filters still have as an
    input; or None."""
    known = simple.FindSource(f"Strokes on {name_of(mesh)}")
    is_empty = known and known.GetXMLName() == "SurfaceStrokes" and not len(known.Points)
    return known if is_empty else None


def connected(mesh):
    strokes = servermanager.sources.SurfaceStrokes()
    controller = servermanager.ParaViewPipelineController()
    controller.PreInitializeProxy(strokes)
    controller.PostInitializeProxy(strokes)
    return register(strokes, f"Strokes on {name_of(mesh)}")


def guided(mesh, surface, strokes, known):
    """The last field known, or else a new one of a mesh, now along strokes."""
    name = name_of(mesh)
    if known and (known[-1].ConstrainGuidance or known[-1].Alignment == "Point Vectors"):
        raise ValueError(f"{name_of(known[-1])} follows other vectors already: turn Constrain "
                         "Guidance and Point Vectors off in its Properties, press Apply, and draw again.")
    base = input_of(known[-1]) if known else surface
    guidance = connect(check_properties("GuidanceFromCurves", {}), base,
                       {"Curves": strokes, "Degree": known[-1].Degree if known else 4})
    register(guidance, f"Guidance of {name}")
    guidance.UpdatePipeline()
    if not known:
        field = computed(guidance, 4, {"UnitLength": 1, **GUIDED})
        simple.RenameSource(f"Field of {name}", field)
        return field
    field = known[-1]
    with Messages() as messages:
        field.Input = simple.OutputPort(guidance, 0)
        for key, value in GUIDED.items():
            setattr(field, key, value)
        field.UpdatePipeline()
    if not is_field(field):
        raise ValueError(messages.errors[0] if messages.errors else f"{name} has no field.")
    return field


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


def shown_in(view):
    """The strokes that a view shows."""
    shown = [proxy_of(display.Input) for display in view.Representations
             if display.Visibility and display.GetProperty("Input") is not None]
    return [source for source in sources() if source.GetXMLName() == "SurfaceStrokes" and
            proxy_of(source) in shown and len(source.Points)]


def rows_of(strokes):
    return np.array(list(strokes.Points)).reshape(-1, 4)


def near(pixel, known, view):
    """Which of some strokes runs the closest to a pixel, and the number there of the one that does;
    Nones where none is within reach."""
    screen, closest = Screen(view), (REACH, None, None)
    for strokes in known:
        rows = rows_of(strokes)
        places = screen.pixels(rows[:, 1:])
        for number in np.unique(rows[:, 0]):
            distance = to_line(np.array(pixel, float), places[rows[:, 0] == number])
            if distance < closest[0]:
                closest = distance, strokes, number
    return closest[1:]


def to_line(place, line):
    """The distance of a place from a poly line in the plane."""
    starts, steps = line[:-1], np.diff(line, axis=0)
    if not len(steps):
        return np.linalg.norm(line[0] - place)
    squares = np.maximum((steps ** 2).sum(axis=1), 1e-300)
    parts = np.clip(((place - starts) * steps).sum(axis=1) / squares, 0.0, 1.0)
    return np.linalg.norm(starts + parts[:, None] * steps - place, axis=1).min()


# The identifier of the Surface Strokes with the selected stroke, its number there and the identifier of
# the selection that shows it; or None.
_selected = None


def select(pixel, view):
    global _selected
    strokes, number = near(pixel, shown_in(view), view)
    for known in sources():
        if known.GetXMLName() == "SurfaceStrokes":
            simple.ClearSelection(known)
    _selected = None
    if strokes is not None:
        # As ParaView's own selections, so that the strokes stay the same data. Its window expects
        # a sum of selections, which simple.SelectCells() does not make.
        query = servermanager.sources.SelectionQuerySource()
        query.ElementType = vtkDataObject.CELL
        query.QueryString = f"Stroke == {int(number)}"
        combined = vtkSMSelectionHelper.NewAppendSelectionsFromSelectionSource(query.SMProxy)
        strokes.SMProxy.SetSelectionInput(0, combined, 0)
        _selected = strokes.SMProxy.GetGlobalID(), number, combined.GetGlobalID()
        combined.UnRegister(None)
    simple.Render(view)
    return None if strokes is None else (strokes, int(number))


def selected_in(known):
    """Which of some strokes has the selected one, and its number there, or Nones."""
    for strokes in known:
        selection = strokes.SMProxy.GetSelectionInput(0)
        if (_selected and strokes.SMProxy.GetGlobalID() == _selected[0] and
                selection and selection.GetGlobalID() == _selected[2] and
                _selected[1] in rows_of(strokes)[:, 0]):
            return strokes, _selected[1]
    return None, None


def remove(pixel, view):
    global _selected
    known = shown_in(view)
    if not known:
        raise ValueError("There are no strokes in this view.")
    strokes, number = selected_in(known)
    if strokes is None:
        strokes, number = near(pixel, known, view)
    strokes = strokes or next((one for one in known if one.SMProxy.GetGlobalID() == _drawn),
                              known[-1])
    simple.ClearSelection(strokes)
    _selected = None
    rows = rows_of(strokes)
    rows = rows[rows[:, 0] != (rows[-1, 0] if number is None else number)]
    if len(rows):
        strokes.Points = [float(x) for x in rows.ravel()]
    else:
        take_out(strokes)
    simple.Render(view)


def take_out(strokes):
    """Takes strokes and their guidance out of the pipeline, or only the points where other filters
    have these as an input; fields are free again."""
    for guidance in [source for source in sources()
                     if source.GetXMLName() == "GuidanceFromCurves" and
                     proxy_of(source.Curves) == proxy_of(strokes)]:
        for user in sources():
            if proxy_of(input_of(user)) == proxy_of(guidance):
                if user.GetProperty("ConstrainGuidance"):
                    user.ConstrainGuidance = 0
                user.Input = guidance.Input
        if not is_used(guidance):
            simple.Delete(guidance)
    if is_used(strokes):
        strokes.Points = []
    else:
        simple.Delete(strokes)


def is_used(source):
    """Whether a filter has a source as an input, of any kind."""
    consumers = [source.SMProxy.GetConsumerProxy(k)
                 for k in range(source.SMProxy.GetNumberOfConsumers())]
    return any(proxy_of(user) in consumers for user in sources())
