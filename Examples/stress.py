# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the forces run in a plate with a hole: pvpython stress.py PLUGIN [PICTURE.png]

The stress is G. Kirsch's of 1898, of a plate that is pulled along x: no solver is needed. Lines follow both principal
directions, red where they are pulled and blue where they are pressed; quads and fibres run along them, too."""

import sys

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

LoadPlugin(sys.argv[1], remote=False, ns=globals())

disk = Disk(InnerRadius=1, OuterRadius=4, RadialResolution=48, CircumferentialResolution=192)
plate = ProgrammableFilter(Input=Triangulate(Input=disk), Script="""
import numpy as np

points = inputs[0].Points.astype(float)
x, y = points[:, 0], points[:, 1]
s, t = 1 / (x * x + y * y), np.arctan2(y, x)
radial = (1 - s + (1 - 4 * s + 3 * s * s) * np.cos(2 * t)) / 2
around = (1 + s - (1 + 3 * s * s) * np.cos(2 * t)) / 2
shear = -(1 + 2 * s - 3 * s * s) * np.sin(2 * t) / 2
cosine, sine, zero = np.cos(t), np.sin(t), 0 * t
output.PointData.append(np.stack([  # XX, YY, ZZ, XY, YZ, XZ
    radial * cosine**2 + around * sine**2 - 2 * shear * sine * cosine,
    radial * sine**2 + around * cosine**2 + 2 * shear * sine * cosine,
    zero, (radial - around) * sine * cosine + shear * (cosine**2 - sine**2), zero, zero], axis=1), "Stress")
""")
tensors = {"Alignment": "Tensor", "TensorArray": ["POINTS", "Stress"]}


def point_values(proxy, name):
    return vtk_to_numpy(servermanager.Fetch(proxy).GetPointData().GetArray(name))


# Both families of lines, with the stress along them.
both = DirectionField(Input=plate, Degree=4, **tensors)
lines = DirectionFieldStreamlines(Input=both)
along = point_values(lines, "PrincipalValue")
print(f"stress along the lines from {along.min():.1f} to {along.max():.1f}")

# Quads along them.
quads = FieldAlignedRemesh(Input=both, NumberOfFaces=1500)
quads.UpdatePipeline()
mesh = servermanager.Fetch(quads)
print(f"{mesh.GetNumberOfCells()} faces,", mesh.GetFieldData().GetAbstractArray("Summary").GetValue(0))

# Fibres along the major direction, and across it.
pull = DirectionField(Input=plate, Degree=2, **tensors)
print(servermanager.Fetch(pull).GetFieldData().GetAbstractArray("Summary").GetValue(0))
fibres = [StripePattern(Input=pull, StripeDirection=direction, Bands=0)
          for direction in ("Along Field", "Across Field")]
print(*(servermanager.Fetch(layer).GetNumberOfLines() for layer in fibres), "fibres along and across")

if sys.argv[2:]:
    view = CreateView("RenderView", ViewSize=[900, 900])
    Show(plate, view, ColorArrayName=[None, ""])
    display = Show(lines, view)
    display.LineWidth = 3
    # They come colored by PrincipalValue, which is 3 at the hole and 1 elsewhere.
    GetColorTransferFunction("PrincipalValue").RescaleTransferFunction(-1.5, 1.5)
    ResetCamera(view)
    SaveScreenshot(sys.argv[2], view)

# The hole has three times the pull at its sides, and the same as pressure at its ends.
stress = point_values(pull, "MajorValue"), point_values(pull, "MinorValue")
assert abs(stress[0].max() - 3) < 0.1 and abs(stress[1].min() + 1) < 0.1, stress
assert along.min() < -0.7 and along.max() > 2.5, along
assert np.mean(np.diff(vtk_to_numpy(mesh.GetPolys().GetOffsetsArray())) == 4) > 0.95
