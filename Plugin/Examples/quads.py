# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scan as a mesh of quads, with its irregular vertices: move the slider of Number Of Faces, or press
Remesh to quads again, which saves them."""
from paraview.simple import *

LoadDistributedPlugin("DirectionFields", remote=False, ns=globals())
import directionfields
from directionfields.examples import example_file

mesh = PLYReader(registrationName="bunny.ply", FileNames=[example_file("bunny.ply")])
quads = FieldAlignedRemesh(registrationName="Remesh of bunny.ply", Input=mesh, NumberOfFaces=2000)
SetActiveSource(quads)
directionfields.remesh_active()
