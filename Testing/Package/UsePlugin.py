# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView knows the plugin of the installed package by its name."""

import sys

from paraview.simple import *

LoadDistributedPlugin("DirectionFields", ns=globals())
mesh = PLYReader(FileNames=[sys.argv[1]])
field = DirectionField(Input=mesh, Degree=4, Diagnostics=1)
field.UpdatePipeline()
assert field.FieldData["IndexSum"].GetRange() == (8, 8)
assert field.PointData["Direction3"].GetNumberOfComponents() == 3
glyphs = DirectionFieldGlyphs(Input=field)
glyphs.UpdatePipeline()
assert glyphs.GetDataInformation().GetNumberOfCells() > 1000
