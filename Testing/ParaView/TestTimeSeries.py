# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface that changes with time: TestTimeSeries.py PLUGIN OUTDIR"""
import os
import sys

from paraview import servermanager
from paraview.simple import *

import AllFigures
from Figures import figures

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()
output = sys.argv[2]

# The steps are a sphere, a sphere twice as large, and two spheres, which are two components.
small = Sphere(ThetaResolution=24, PhiResolution=16)
large = Sphere(ThetaResolution=24, PhiResolution=16, Radius=1.0)
two = AppendGeometry(Input=[small, Sphere(Center=[3, 0, 0])])
files = []
for k, mesh in enumerate((small, large, two)):
    files.append(os.path.join(output, f"TestTimeSeries{k}.vtp"))
    SaveData(files[-1], proxy=mesh, DataMode="Binary")

series = XMLPolyDataReader(FileName=files)
series.UpdatePipelineInformation()
assert list(series.TimestepValues) == [0.0, 1.0, 2.0], list(series.TimestepValues)
field = DirectionField(Input=series, Degree=4)
found = []
for time in (0.0, 1.0, 2.0, 0.0):
    field.UpdatePipeline(time)
    found.append(figures(servermanager.Fetch(field), servermanager.Fetch(field, idx=1)))
assert [f["IndexSum"] for f in found] == [[8], [8], [8, 8], [8]], found
assert [f["Total"] for f in found] == [8, 8, 16, 8], found
assert abs(found[0]["Eigenvalue"][0] / found[1]["Eigenvalue"][0] - 4.0) < 1e-4, found
assert found[3] == found[0]

# What one does with the field has the step that is asked for, also when time goes back.
tools = (DirectionFieldStreamlines(Input=field), FieldAlignedRemesh(Input=field, NumberOfFaces=1000),
         StripePattern(Input=DirectionField(Input=series, Degree=2), Spacing=0.1),
         EditSingularities(Input=field, Singularities=OutputPort(field, 1)))
for tool in tools:
    bounds = []
    for time in (0.0, 1.0, 2.0, 0.0):
        tool.UpdatePipeline(time)
        bounds.append(servermanager.Fetch(tool).GetBounds())
    ends = [bound[1] for bound in bounds]
    assert all(abs(end - expected) < 0.05 * expected for end, expected in
               zip(ends, (0.5, 1.0, 3.5, 0.5))), (tool, ends)
    assert bounds[0] == bounds[3], (tool, bounds)

# The animation asks for each of them, too.
view = CreateRenderView()
Show(field, view)
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
seen = []
scene.GoToFirst()
for _ in range(3):
    seen.append(field.GetDataInformation(0).GetNumberOfPoints())
    scene.GoToNext()
assert seen[0] == seen[1] and seen[2] > seen[1], seen
print("passed")
