# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Singularities of a field that are moved, taken away and added with the mouse."""

import numpy as np
from paraview import servermanager
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkTextActor

from directionfields.compute import check_properties, connect, field_for, register
from directionfields.picture import complain, draw, view_of_button
from directionfields.pipeline import input_of, name_of, proxy_of, upstream
from directionfields.quads import degree_of
from directionfields.restore import Messages, Pipeline
from directionfields.strokes import Screen

BUTTON = "Edit singularities"
# How far from a handle it can be taken, and its diameter, in pixels.
REACH, SIZE = 12.0, 15.0
RED, BLUE, HELD = (215, 26, 28), (23, 77, 219), (255, 255, 255)
LOOK, MOVE, MERGE, ADD, ADD_PAIR = range(5)


def move_singularity(number, pixel):
    """Moves a singularity of the active Edit Singularities, by its place in the list, to where the
    surface is seen at a pixel of the active view, as (x, y) from the lower left corner, as a drag does with
    the button "Edit singularities". Returns what there is to tell, "" if nothing."""
    return once(MOVE, number, pixel)


def merge_singularity(number):
    """Takes a singularity of the active Edit Singularities away: it goes into the nearest one of
    opposite sign on the same part of the surface, or leaves through a free boundary. Returns the
    sentence that says which."""
    return once(MERGE, number)


def add_singularities(pixel, index=1, pair=True):
    """Adds a singularity of an index, in units of 1/n, to the active Edit Singularities, where the
    surface is seen at a pixel of the active view, and one of the opposite index beside it, which
    only a part of the surface with a free boundary can do without. Returns what there is to
    tell."""
    return once(ADD_PAIR if pair else ADD, index, pixel)


def once(step, number, pixel=None):
    hand = Hand(edited_of(simple.GetActiveSource()), view_of_button())
    hand.step(step, number, pixel)
    return hand.note


def edited_of(source):
    """The Edit Singularities that a source is or is made of, or a new one on its field."""
    for before in upstream(source):
        if before.GetXMLName() == "EditSingularities":
            return servermanager._getPyProxy(proxy_of(before))
    field = field_for(source, UnitLength=1)
    known = [other for other in simple.GetSources().values()
             if other.GetXMLName() == "EditSingularities" and
             proxy_of(input_of(other)) == proxy_of(field)]
    if known:
        return known[-1]
    with Messages() as messages:
        edit = connect(check_properties("EditSingularities", {}), field,
                       {"Objective": "Least Change"})
        edit.UpdatePipeline()
    if messages.errors:
        raise ValueError(messages.errors[0])
    return register(edit, f"Edited field of {name_of(field).removeprefix('Field of ')}")


def rows_of(edit):
    """The list of a filter, or what it gives while it has none, a row for each singularity."""
    rows = list(edit.SingularityList)
    if rows:
        return np.array(rows, float).reshape(-1, 4)
    found = [np.empty((0, 4))]
    data = servermanager.Fetch(edit, idx=1)
    for block in blocks_of(data):
        if block.GetNumberOfPoints():
            index = vtk_to_numpy(block.GetPointData().GetArray("SingularityIndex"))
            found.append(np.c_[vtk_to_numpy(block.GetPoints().GetData()), index])
    return np.concatenate(found)


def blocks_of(data):
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    blocks, at = [], data.NewIterator()
    at.InitTraversal()
    while not at.IsDoneWithTraversal():
        blocks.append(at.GetCurrentDataObject())
        at.GoToNextItem()
    return blocks


def put(proxy, **properties):
    """Sets properties of a proxy that ParaView has no class for."""
    for name, value in properties.items():
        proxy.SetPropertyWithName(name, value)


class Hand:
    """What changes the list of an Edit Singularities; the surface stays on the server."""

    def __init__(self, edit, view):
        self.edit, self.view, self.note = edit, view, ""
        manager = servermanager.ProxyManager()
        # On several processes the hand needs the whole surface.
        self.whole = servermanager.SourceProxy(
            proxy=manager.NewProxy("internal_writers", "DirectionFieldGather"))
        put(self.whole, Input=edit.Input)
        self.proxy = servermanager.SourceProxy(proxy=manager.NewProxy("internal_writers", "SingularityHand"))
        put(self.proxy, Input=self.whole)
        self.degree = 0
        self.look()

    def ask(self, step, number=0, pixel=None):
        """The rows after a step, whether they are seen, and whether it was done."""
        camera = self.view.GetActiveCamera()
        eye = ([*(-np.array(camera.GetDirectionOfProjection())), 0.0]
               if camera.GetParallelProjection() else [*camera.GetPosition(), 1.0])
        rows = self.rows
        ray = Screen(self.view).ray(pixel) if pixel is not None else np.zeros(6)
        put(self.proxy, SingularityList=[float(x) for x in rows.ravel()], Step=step, Eye=eye,
            KeepConstraints=self.edit.KeepConstraints, Ray=[float(x) for x in np.ravel(ray)],
            **{"Index" if step in (ADD, ADD_PAIR) else "Which": number})
        # Of several processes of a server the first one has the answer.
        data = servermanager.Fetch(self.proxy, 0)
        fields, points = data.GetFieldData(), data.GetPointData()
        note, done = fields.GetAbstractArray("Note"), fields.GetArray("IsDone")
        self.note = note.GetValue(0) if note and note.GetNumberOfValues() else ""
        if done is None or points.GetArray("Visible") is None or not data.GetNumberOfPoints():
            return rows, np.zeros(len(rows), bool), False
        index = vtk_to_numpy(points.GetArray("SingularityIndex"))
        return (np.c_[vtk_to_numpy(data.GetPoints().GetData()), index],
                vtk_to_numpy(points.GetArray("Visible")) != 0, bool(done.GetValue(0)))

    def look(self):
        """Reads the list, and which of its singularities are seen."""
        put(self.whole, Input=self.edit.Input)
        self.rows = rows_of(self.edit)
        self.degree = degree_of(simple.OutputPort(self.edit, 0))
        note = self.note
        _, self.seen, _ = self.ask(LOOK)
        self.note = note

    def step(self, step, number, pixel=None):
        """Changes the list by a step, if it can be done; returns whether."""
        rows, seen, is_done = self.ask(step, number, pixel)
        if not is_done:
            return False
        if not len(self.edit.SingularityList):
            # The first change by hand is to change no more than it has to.
            self.edit.Objective = "Least Change"
        self.rows, self.seen = rows, seen
        self.edit.SingularityList = [float(x) for x in rows.ravel()]
        with Messages() as messages:
            self.edit.UpdatePipeline()
        if messages.errors:
            self.note = messages.errors[0]
        return True

    def at(self, pixel):
        """The number of the handle at a pixel, or None."""
        if not len(self.rows):
            return None
        away = np.linalg.norm(Screen(self.view).pixels(self.rows[:, :3]) - np.array(pixel), axis=1)
        away[~self.seen | (self.rows[:, 3] == 0)] = np.inf
        nearest = int(np.argmin(away))
        return nearest if away[nearest] < REACH else None

    def describe(self, number):
        return f"Singularity of index {int(self.rows[number, 3]):+d}/{self.degree}"


class Handles:
    """The drawing of the hand in a view: a ball of some pixels for each singularity that is seen, the
    one under the mouse white, and a line of text."""

    def __init__(self, hand):
        self.hand, self.held, self.data = hand, None, vtkPolyData()
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(self.data)
        self.actor, self.text = vtkActor(), vtkTextActor()
        self.actor.SetMapper(mapper)
        self.actor.GetProperty().SetPointSize(SIZE)
        self.actor.GetProperty().SetRenderPointsAsSpheres(True)
        self.actor.GetProperty().SetAmbient(0.3)
        self.actor.PickableOff()
        style = self.text.GetTextProperty()
        style.SetFontSize(16)
        style.SetColor(0.75, 0.1, 0.05)
        style.SetBackgroundColor(1.0, 1.0, 1.0)
        style.SetBackgroundOpacity(0.75)
        style.SetJustificationToCentered()
        self.text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        self.text.SetPosition(0.5, 0.93)
        # What is drawn there lies over the picture, on the client, wherever that was rendered.
        self.renderer = hand.view.SMProxy.GetClientSideView().GetNonCompositedRenderer()
        self.renderer.AddActor(self.actor)
        self.renderer.AddActor(self.text)
        self.say("")
        self.draw()

    def draw(self):
        hand = self.hand
        shown = np.flatnonzero(hand.seen & (hand.rows[:, 3] != 0)) if len(hand.rows) else []
        points, cells = vtkPoints(), vtkCellArray()
        colors = np.zeros((len(shown), 3), np.uint8)
        for k, number in enumerate(shown):
            cells.InsertNextCell(1, [points.InsertNextPoint(hand.rows[number, :3])])
            colors[k] = (HELD if number == self.held else
                         RED if hand.rows[number, 3] > 0 else BLUE)
        self.data.SetPoints(points)
        self.data.SetVerts(cells)
        self.data.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
        self.data.Modified()

    def say(self, text):
        self.text.SetInput(text)
        self.text.SetVisibility(bool(text))

    def remove(self):
        self.renderer.RemoveActor(self.actor)
        self.renderer.RemoveActor(self.text)


# The handles while the button is on; see SingularityTool.
_handles = None


def answers(act):
    """A function for the window: what goes wrong is a sentence in the status bar, for the mouse
    moves on and must not meet an error each time."""
    def run(*arguments):
        try:
            return act(*arguments) or ""
        except Exception as problem:
            return " ".join(str(problem).split()) or type(problem).__name__
    return run


def begin():
    """Shows the handles of the selected field, which Edit Singularities gets first if it has not been
    edited. Returns "" if it worked, or what is in the way."""
    global _handles
    end()
    try:
        source = simple.GetActiveSource()
        with Pipeline():
            view = view_of_button()
            edit = edited_of(source)
            shown = view.FindRepresentation(proxy_of(edit), 0)
            if shown is None or not servermanager._getPyProxy(shown).Visibility:
                draw(simple.OutputPort(edit, 0), view, {}, True)
            simple.SetActiveSource(edit)
            _handles = Handles(Hand(edit, view))
            simple.Render(view)
    except Exception as problem:
        end()
        complain(BUTTON, problem)
        return " ".join(str(problem).split()) or type(problem).__name__
    return ""


def end():
    """Takes the handles away."""
    global _handles
    if _handles is not None:
        handles, _handles = _handles, None
        handles.remove()
        if handles.hand.view in simple.GetViews():
            simple.Render(handles.hand.view)


def alive():
    """The handles, unless their filter or view has been deleted."""
    if _handles is None:
        return None
    # A list of all sources would take longer than to look these up.
    proxies = servermanager.ProxyManager()
    if not all(proxies.GetProxyName(group, proxy_of(proxy)) for group, proxy in (
            ("sources", _handles.hand.edit), ("views", _handles.hand.view))):
        end()
    return _handles


@answers
def refresh():
    """After the camera, the list or the field has changed."""
    handles = alive()
    if handles is None:
        return
    before = handles.hand.rows, handles.hand.seen
    handles.hand.look()
    if not all(np.array_equal(*pair) for pair in zip(before, (handles.hand.rows,
                                                              handles.hand.seen))):
        handles.held = None
        handles.draw()
        simple.Render(handles.hand.view)


@answers
def hover(x, y):
    handles = alive()
    if handles is None:
        return
    number = handles.hand.at((x, y))
    if number != handles.held:
        handles.held = number
        handles.say("")
        handles.draw()
        simple.Render(handles.hand.view)
    return handles.hand.describe(number) if number is not None else ""


@answers
def press(x, y):
    """Whether there is a handle to drag: then the answer begins with +."""
    refresh()
    text = hover(x, y)
    handles = alive()
    is_there = handles is not None and handles.hand.at((x, y)) is not None
    return f"+{text}" if is_there else ""


def change(step, number, pixel, is_kept=False):
    handles = alive()
    if handles is None:
        return ""
    handles.hand.step(step, number, pixel)
    if not is_kept:
        handles.held = None
    handles.say(handles.hand.note)
    handles.draw()
    simple.Render(handles.hand.view)
    return handles.hand.note


@answers
def drag(x, y):
    """Moves the handle that is held, with its field."""
    handles = alive()
    if handles is None or handles.held is None:
        return
    note = change(MOVE, handles.held, (x, y), True)
    return note or handles.hand.describe(handles.held)


@answers
def drop():
    """The handle is let go."""
    if _handles is not None:
        _handles.say("")
        simple.Render(_handles.hand.view)


@answers
def add(x, y, index, pair):
    refresh()
    return change(ADD_PAIR if pair else ADD, index, (x, y))


@answers
def merge(x, y):
    refresh()
    handles = alive()
    number = handles.hand.at((x, y)) if handles else None
    return "There is no singularity under the mouse." if number is None else (
        change(MERGE, number, None))
