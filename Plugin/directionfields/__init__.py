# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Direction fields in ParaView scripts; comes with the DirectionFields plugin.

    from paraview.simple import *
    LoadPlugin("/.../DirectionFields.so", ns=globals())
    import directionfields

    picture = directionfields.show("bunny.ply", degree=4)
    SaveScreenshot("field.png", picture.view)

show() computes a field and builds the whole picture of it, show_active() does so for the active
source, as the button "Show direction field" of ParaView's window, remesh_active() shows quads of
it, as the button "Remesh to quads", draw_stroke(), select_stroke(), toggle_stroke() and remove_stroke()
change the curves that a field follows, as the mouse does with "Draw strokes", add_strokes() adds
given ones, set_stroke_strength() makes them hard or soft, move_singularity(), merge_singularity() and
add_singularities() edit its singularities, as it does with "Edit singularities", apply_preset()
chooses properties for a kind of surface, as the menu "Direction field preset", open_example() opens
an example, as the menu Help, and read() reads a mesh.
"""

from directionfields.examples import open_example
from directionfields.files import read
from directionfields.picture import Picture, show, show_active
from directionfields.presets import apply_preset
from directionfields.quads import QuadPicture, remesh_active
from directionfields.singularities import (add_singularities, merge_singularity,
                                           move_singularity)
from directionfields.strokes import (add_strokes, draw_stroke, remove_stroke, select_stroke,
                                     set_stroke_strength, toggle_stroke)

__all__ = ["Picture", "QuadPicture", "add_singularities", "add_strokes", "apply_preset",
           "draw_stroke", "merge_singularity", "move_singularity", "open_example", "read",
           "remesh_active", "remove_stroke", "select_stroke", "set_stroke_strength", "show",
           "show_active", "toggle_stroke"]
