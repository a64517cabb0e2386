# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cross field of a PLY file, in the Python of VTK, as NumPy arrays."""

import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOPLY import vtkPLYReader

from directionfields_vtk import vtkDirectionField

reader = vtkPLYReader()
reader.SetFileName(sys.argv[1])
field = vtkDirectionField()
field.SetInputConnection(reader.GetOutputPort())
field.SetDegree(4)
field.Update()
surface = field.GetOutput(0)
directions = [
    vtk_to_numpy(surface.GetPointData().GetArray(f"Direction{k}"))
    for k in range(field.GetDegree())
]
index = vtk_to_numpy(surface.GetCellData().GetArray("SingularityIndex"))
print(
    f"{surface.GetNumberOfPoints()} points with {len(directions)} directions,"
    f" {(index != 0).sum()} singularities, index sum {index.sum()}"
)
