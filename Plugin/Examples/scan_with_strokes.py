# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scan whose cross field follows three strokes: switch Draw strokes on and draw another one."""
from paraview.simple import *

LoadDistributedPlugin("DirectionFields", remote=False, ns=globals())
import directionfields
from directionfields.examples import example_file

# The number of a stroke, and x, y and z of a point of it.
POINTS = [
    0, -2.25, 7.89, 0.75, 0, -2.03, 8.03, 0.55, 0, -1.79, 8.21, 0.42, 0, -1.56, 8.36, 0.29,
    0, -1.32, 8.53, 0.13, 0, -1.06, 8.67, -0.07, 0, -0.80, 8.83, -0.30, 0, -0.52, 8.98, -0.56,
    0, -0.23, 9.13, -0.83, 0, 0.07, 9.28, -1.14, 1, -1.34, 5.72, 1.84, 1, -1.08, 5.76, 1.72,
    1, -0.82, 5.79, 1.63, 1, -0.57, 5.80, 1.61, 1, -0.34, 5.84, 1.69, 1, -0.12, 5.84, 1.83,
    1, 0.09, 5.84, 1.99, 1, 0.30, 5.81, 2.15, 1, 0.52, 5.75, 2.28, 1, 0.72, 5.67, 2.40,
    1, 0.93, 5.57, 2.50, 1, 1.13, 5.46, 2.59, 1, 1.33, 5.32, 2.65, 1, 1.52, 5.15, 2.69,
    1, 1.70, 4.98, 2.73, 1, 1.85, 4.81, 2.80, 1, 1.99, 4.64, 2.91, 1, 2.11, 4.46, 3.02,
    1, 2.23, 4.25, 3.11, 1, 2.32, 4.03, 3.16, 1, 2.41, 3.79, 3.20, 1, 2.48, 3.56, 3.25,
    1, 2.54, 3.31, 3.26, 1, 2.59, 3.05, 3.27, 1, 2.62, 2.78, 3.23, 1, 2.64, 2.50, 3.17,
    2, -3.16, 5.30, 3.05, 2, -3.17, 5.05, 2.77, 2, -3.12, 4.76, 2.68, 2, -3.07, 4.54, 2.74,
    2, -2.98, 4.34, 2.81, 2, -2.88, 4.14, 2.89, 2, -2.74, 3.96, 2.94, 2, -2.57, 3.78, 2.98,
    2, -2.40, 3.60, 2.98, 2, -2.21, 3.43, 2.99, 2, -2.01, 3.25, 2.96, 2, -1.81, 3.09, 2.91,
    2, -1.60, 2.92, 2.87, 2, -1.39, 2.75, 2.85, 2, -1.17, 2.59, 2.81, 2, -0.96, 2.43, 2.78,
    2, -0.76, 2.28, 2.80, 2, -0.58, 2.14, 2.90, 2, -0.43, 2.01, 3.04, 2, -0.28, 1.88, 3.19,
    2, -0.11, 1.74, 3.31, 2, 0.06, 1.56, 3.40, 2, 0.23, 1.37, 3.42, 2, 0.41, 1.14, 3.40,
    2, 0.59, 0.88, 3.32, 2, 0.77, 0.62, 3.23]

mesh = PLYReader(registrationName="bunny.ply", FileNames=[example_file("bunny.ply")])
strokes = SurfaceStrokes(registrationName="Strokes on bunny.ply", Points=POINTS)
guidance = GuidanceFromCurves(registrationName="Guidance of bunny.ply", Input=mesh, Curves=strokes)
field = DirectionField(registrationName="Field of bunny.ply", Input=guidance, UnitLength=1,
                       GuidanceVectors="GuidanceVectors", GuidanceWeights="GuidanceWeights",
                       ConstrainGuidance=1)
picture = directionfields.show(field)
Show(strokes, picture.view)
Render(picture.view)
