# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Direction fields in ParaView scripts; comes with the DirectionFields plugin.

    from paraview.simple import *
    LoadPlugin("/.../DirectionFields.so", ns=globals())
    import directionfields

    picture = directionfields.show("bunny.ply", degree=4)
    SaveScreenshot("field.png", picture.view)

show() computes a field and builds the whole picture of it, read() reads a mesh, and
install_macro() adds a button "Show direction field" to ParaView's toolbar.
"""

from directionfields.files import read
from directionfields.macro import install_macro
from directionfields.picture import Picture, show

__all__ = ["Picture", "install_macro", "read", "show"]
