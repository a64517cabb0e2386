# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a mesh of quads along a direction field."""

import collections

from paraview import simple

from directionfields import preview
from directionfields.camera import is_untouched, place_camera
from directionfields.compute import (check_properties, connect, given, has_field, register,
                                     surface_of)
from directionfields.pipeline import (MAKERS, REMESHERS, fields_of, follower, mesh_of, name_of,
                                      proxy_of, upstream)
from directionfields.picture import (complain, hide_others, part_name, show_balls_legend,
                                     view_of_button)
from directionfields.restore import Messages, Pipeline

QuadPicture = collections.namedtuple("QuadPicture", "quads legend view")
QuadPicture.__doc__ = """What remesh_active() has built.

quads   the filter Field Aligned Remesh; its second output port are the irregular vertices
legend  the scalar bar of the irregular vertices, or None where there are none
view    the render view"""


def remesh_active():
    """Shows a mesh of quads of the active source: what the button "Remesh to quads" does.

    The source may be a mesh, a field, or anything made of these. The mesh follows the field of
    degree 4 that is there, which stays as it is; without one, Field Aligned Remesh computes its
    own. Where there are quads of it already, these are shown. Of image data and grids the surface
    is taken. What else the view shows of the mesh and of its fields is hidden.

    Returns the QuadPicture, or None where there is nothing to remesh; then one sentence in
    ParaView's messages says why, and everything is as it was."""
    try:
        source = simple.GetActiveSource()
        with Pipeline():
            view = view_of_button()
            # Quads of a preview would be made twice.
            preview.finish()
            return draw(quads_for(source), view)
    except Exception as problem:  # A button has nobody to catch what it raises.
        complain("Remesh to quads", problem)
        return None


def draw(quads, view):
    """Builds the picture of quads that are there."""
    is_free = is_untouched(view, quads)
    # The first render would reset the camera.
    simple._DisableFirstRenderCameraReset()
    # The plugin gives quads and irregular vertices their look, and the view the summary.
    display = simple.Show(quads, view)
    display.SetRepresentationType("Surface With Edges")
    display.ShowSummary = 1
    balls = simple.Show(simple.OutputPort(quads, 1), view)
    bar = show_balls_legend(balls, view)
    hide_others(quads, [quads, balls.Input], view)
    if is_free:
        place_camera(view, quads)
    simple.SetActiveSource(quads)
    simple.Render(view)
    return QuadPicture(quads, bar, view)


def quads_for(source):
    """The quads that a source is or is made of, or that were made of it, or else new ones."""
    if source is None:
        raise ValueError("There is no mesh: open one, press Apply, and select it.")
    source.UpdatePipeline()
    for before in upstream(source):
        if is_quads(before):
            return simple.OutputPort(before, 0)
        if before.GetXMLName() in MAKERS:
            break
    base, name = base_of(source)
    known = follower(base, *REMESHERS)
    if known is not None and is_quads(known):
        known.UpdatePipeline()
        return simple.OutputPort(known, 0)
    return remeshed(base, name)


def is_quads(source):
    return source.GetXMLName() in REMESHERS and source.Element == "Quads"


def degree_of(field):
    """How many directions a field has at a point."""
    points = field.GetDataInformation(field.Port).GetPointDataInformation()
    degree = 0
    while points.GetArrayInformation(f"Direction{degree}"):
        degree += 1
    return degree


def base_of(source):
    """What quads of a source are made of, and what they are named after: its field, or the newest
    field of its mesh, where it has four directions at a point, or else the mesh."""
    mesh = source
    if has_field(source):
        field = given(source)
        if degree_of(field) == 4:
            return field, part_name("Remesh", field)
        mesh = mesh_of(field)
    crosses = [field for field in (simple.OutputPort(field, 0) for field in fields_of(mesh))
               if degree_of(field) == 4]
    if crosses:
        return crosses[-1], part_name("Remesh", crosses[-1])
    surface, is_new = surface_of(mesh)
    name = name_of(mesh)
    surface.UpdatePipeline()
    if surface.GetDataInformation(surface.Port).GetNumberOfCells() == 0:
        raise ValueError(f"{name} has no cells: open a mesh, press Apply, and select it.")
    if is_new:
        register(surface, f"Surface of {name}")
    return simple.OutputPort(surface, surface.Port), f"Remesh of {name}"


def remeshed(base, name):
    """A new mesh of quads."""
    with Messages() as messages:
        quads = connect(check_properties("FieldAlignedRemesh", {}), base, {})
        quads.UpdatePipeline()
    if quads.GetDataInformation(0).GetNumberOfCells() == 0:
        why = messages.errors[0] if messages.errors else (
            "It has no faces, only points or lines: select a mesh.")
        raise ValueError(f"{name_of(base)} cannot be remeshed. {why}")
    return simple.OutputPort(register(quads, name), 0)
