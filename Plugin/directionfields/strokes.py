# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strokes that are drawn on a surface with the mouse, and the field along them."""

import numpy as np
from paraview import servermanager
from paraview import simple
from paraview.modules.vtkRemotingViews import vtkSMSelectionHelper
from vtkmodules.vtkCommonDataModel import vtkDataObject

from directionfields import preview
from directionfields.camera import camera_of, put_camera
from directionfields.compute import (check_properties, computed, connect, register, surface_of)
from directionfields.laying import Screen, laid, surfaces_under
from directionfields.picture import complain, draw, view_of_button
from directionfields.pipeline import (fields_before, fields_of, input_of, is_field, mesh_of,
                                      name_of, proxy_of, sources, upstream, REMESHERS)
from directionfields.restore import Messages, Pipeline, Properties
from directionfields.tracing import Traced, named

# How far from a stroke it can be pointed at, in pixels.
REACH = 15.0


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
        with Pipeline(), Traced() as traced:
            mesh, surface, parts = stroke_under(path, view)
            strokes = add(mesh, surface, parts, view)
            lines = [[tuple(map(float, point)) for point in part] for part in parts]
            traced.text = f"directionfields.add_strokes({named(mesh)}, {lines})"
            return strokes
    except Exception as problem:  # A button has nobody to catch what it raises.
        complain("Draw strokes", problem)
        return None


def add_strokes(mesh, lines):
    """Adds strokes that are given in space, as draw_stroke() adds what is drawn: ParaView's Python
    trace of a stroke is a call of it.

    mesh   the surface, or a field on it or something made of that
    lines  a list of points (x, y, z) for each stroke, on the surface or near it, at least two

    Returns the Surface Strokes; raises ValueError for what is none of these, or where no field can
    follow them, and then everything is as it was."""
    parts = [[np.array(point, float) for point in line] for line in lines]
    if not parts or any(len(part) < 2 or np.shape(part) != (len(part), 3) or
                        not np.isfinite(part).all() for part in parts):
        raise ValueError("A stroke needs two points or more, each with finite x, y and z.")
    with Pipeline():
        base = base_of(mesh)
        surface, is_new = surface_of(base)
        if is_new:
            register(surface, f"Surface of {name_of(base)}")
        return add(base, simple.OutputPort(surface, surface.Port), parts, view_of_button())


def select_stroke(pixel):
    """Selects the stroke that is near a pixel of the active view, which ParaView highlights, for
    remove_stroke(); near none, none is selected any more. Returns its Surface Strokes and its
    number there, or None; the field is not computed again."""
    try:
        return select(pixel, view_of_button())
    except Exception as problem:
        complain("Draw strokes", problem)
        return None


def remove_stroke(pixel=None, *, strokes=None, number=None):
    """Takes the stroke of a number in Surface Strokes away, if both are given, or else the selected
    one, or else the one that is near a pixel of the active view, or
    else the last one that was drawn and that the view shows; with the last one of a surface, what draw_stroke() has put
    between the mesh and its field, unless other filters have that as an input, too. Returns whether there was
    one, and says so in a sentence if not."""
    try:
        view = view_of_button()
        with Pipeline(), Traced() as traced:
            if strokes is None:
                strokes, number = pointed_at(pixel, view)
            name = named(strokes)
            take_away(strokes, number, view)
            traced.text = f"directionfields.remove_stroke(strokes={name}, number={int(number)})"
        return True
    except Exception as problem:
        complain("Draw strokes", problem)
        return False


def toggle_stroke(pixel):
    """Makes the stroke that is near a pixel of the active view soft if it is hard, and hard if it is
    soft, as a double click does. Returns its Surface Strokes, its number there and its strength, or
    None where none is near."""
    try:
        view = view_of_button()
        strokes, number = near(pixel, shown_in(view), view)
        if strokes is None:
            return None
        strength = SOFT if strengths_of(strokes).get(number, 1.0) >= 1.0 else 1.0
        with Pipeline(), Traced() as traced:
            soften(strokes, number, strength, view)
            traced.text = (f"directionfields.set_stroke_strength({named(strokes)}, {int(number)}, "
                           f"{strength})")
        return strokes, int(number), strength
    except Exception as problem:
        complain("Draw strokes", problem)
        return None


def set_stroke_strength(strokes, number, strength):
    """Sets how strongly the field follows the stroke of a number in Surface Strokes: exactly at 1, as
    far as the rest of the field lets it below 1, and not at all at 0. ParaView's Python trace of a
    double click is a call of it. Raises ValueError for numbers that are none of these."""
    if not 0.0 <= strength <= 1.0:
        raise ValueError(f"The strength of a stroke is 0 to 1, not {strength}.")
    if number not in rows_of(strokes)[:, 0]:
        raise ValueError(f"{name_of(strokes)} has no stroke {number}.")
    with Pipeline():
        soften(strokes, number, strength, view_of_button())


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
          "GuidanceStrengths": "GuidanceStrengths", "ConstrainGuidance": 1}
# What a double click makes of a hard stroke.
SOFT = 0.5
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
            preview.begin([field])
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
        preview.begin([field])
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
    display = view.FindRepresentation(proxy_of(strokes), 0)
    if display is None or not display.GetProperty("Visibility").GetElement(0):
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


def strengths_of(strokes):
    """The strengths of soft strokes by their numbers."""
    values = list(strokes.Strengths)
    return dict(zip(values[0::2], values[1::2]))


def put_strengths(strokes, strengths):
    strokes.Strengths = [float(x) for pair in sorted(strengths.items()) for x in pair]


def fields_along(strokes):
    """The fields that follow strokes."""
    return [source for source in sources() if source.GetXMLName() == "DirectionField" and
            proxy_of(guided_of([source])[2]) == proxy_of(strokes)]


def soften(strokes, number, strength, view):
    """Sets the strength of a stroke, and shows that."""
    global _selected
    fields = fields_along(strokes)
    changed = {strokes: ["Strengths"]}
    changed.update({field: ["GuidanceStrengths"] for field in fields})
    strengths = strengths_of(strokes)
    strengths.pop(number, None)
    if strength < 1.0:
        strengths[float(number)] = strength
    with Properties(changed):
        preview.begin(fields)
        put_strengths(strokes, strengths)
        for field in fields:
            # States of older versions have none.
            if field.GuidanceStrengths != GUIDED["GuidanceStrengths"]:
                field.Input.UpdatePipeline()
                field.GuidanceStrengths = GUIDED["GuidanceStrengths"]
        # What is selected hides how the stroke looks.
        simple.ClearSelection(strokes)
        _selected = None
        shown = simple.GetRepresentation(strokes, view)
        if not shown.ColorArrayName[1]:
            shown.ColorArrayName, shown.MapScalars = ["POINTS", "Color"], 0
        simple.Render(view)


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


def pointed_at(pixel, view):
    """The Surface Strokes and the number there of the stroke that goes first."""
    known = shown_in(view)
    if not known:
        raise ValueError("There are no strokes in this view.")
    strokes, number = selected_in(known)
    if strokes is None and pixel is not None:
        strokes, number = near(pixel, known, view)
    if strokes is None:
        strokes = next((one for one in known if one.SMProxy.GetGlobalID() == _drawn), known[-1])
        number = rows_of(strokes)[-1, 0]
    return strokes, number


def take_away(strokes, number, view):
    global _selected
    rows = rows_of(strokes)
    rest = rows[rows[:, 0] != number]
    if len(rest) == len(rows):
        raise ValueError(f"{name_of(strokes)} has no stroke {number}.")
    simple.ClearSelection(strokes)
    _selected = None
    preview.begin(fields_along(strokes))
    if len(rest):
        strokes.Points = [float(x) for x in rest.ravel()]
        put_strengths(strokes, {known: strength for known, strength in
                                strengths_of(strokes).items() if known in rest[:, 0]})
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
        strokes.Strengths = []
    else:
        simple.Delete(strokes)


def is_used(source):
    """Whether a filter has a source as an input, of any kind."""
    consumers = [source.SMProxy.GetConsumerProxy(k)
                 for k in range(source.SMProxy.GetNumberOfConsumers())]
    return any(proxy_of(user) in consumers for user in sources())
