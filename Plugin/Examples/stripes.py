# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stripes along a line field on a scan, as fibres lie: move the slider of Spacing, or set Stripe
Direction to Across Field."""
from paraview.simple import *

LoadDistributedPlugin("DirectionFields", remote=False, ns=globals())
import directionfields
from directionfields.examples import example_file

mesh = PLYReader(registrationName="bunny.ply", FileNames=[example_file("bunny.ply")])
picture = directionfields.show(mesh, 2, UnitLength=1, Alignment="Principal Curvature",
                               AlignmentStrength=0.5, CurvatureDirection="Least Bent")
HideAll(picture.view)
stripes = StripePattern(registrationName="Stripes on bunny.ply", Input=picture.field)
Show(OutputPort(stripes, 1), picture.view)
SetActiveSource(stripes)
Render(picture.view)
