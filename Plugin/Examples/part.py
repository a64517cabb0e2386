# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A part whose cross field runs along its sharp edges: move the slider of Singularity Cost, or press
Remesh to quads."""
from paraview.simple import *

LoadDistributedPlugin("DirectionFields", remote=False, ns=globals())
import directionfields
from directionfields.examples import example_file

part = STLReader(registrationName="bracket.stl", FileNames=[example_file("bracket.stl")])
mesh = Subdivide(registrationName="Finer part", Input=part, NumberofSubdivisions=2)
directionfields.show(mesh, 4, UnitLength=1, ConstrainSharpEdges=1, SingularityCost=0.0)
