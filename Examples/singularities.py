# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A cross field on a sphere that is nearly a cube, with four of its eight singularities between the corners, and moved to them."""

import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource

from directionfields_vtk import vtkDirectionField, vtkDirectionFieldSingularities

# An icosahedron, subdivided and blown up to |x|^6 + |y|^6 + |z|^6 = 1.
solid = vtkPlatonicSolidSource()
solid.SetSolidTypeToIcosahedron()
subdivision = vtkLinearSubdivisionFilter()
subdivision.SetInputConnection(solid.GetOutputPort())
subdivision.SetNumberOfSubdivisions(4)
subdivision.Update()
surface = subdivision.GetOutput()
points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
points /= np.sum(points**6, axis=1)[:, None] ** (1 / 6)
surface.GetPoints().SetData(numpy_to_vtk(points, deep=True))

field = vtkDirectionField()
field.SetInputData(surface)
field.SetDegree(4)



def four(height, turned):
    """Four corners of the cube |x| = |y| = |z| = 3^(-1/6), turned about its axis by an angle in degrees."""
    size = 3 ** (-1 / 6)
    for k in range(4):
        angle = math.radians(45 + 90 * k + turned)
        yield [math.sqrt(2) * size * math.cos(angle), math.sqrt(2) * size * math.sin(angle), height * size]


def edit(places):
    """The field with singularities at some places; without an array SingularityIndex each has the index 1/4."""
    points = vtkPolyData()
    points.SetPoints(vtkPoints())
    for place in places:
        points.GetPoints().InsertNextPoint(place)
    singularities.SetSingularitiesData(points)
    singularities.Update()
    figures = singularities.GetOutputDataObject(0).GetFieldData()
    print(
        f"{singularities.GetOutputDataObject(1).GetNumberOfPoints()} singularities,"
        f" energy of the rotation {figures.GetArray('RotationEnergy').GetValue(0):.0f},"
        f" {figures.GetArray('WrongTriangles').GetValue(0)} wrong triangles"
    )


singularities = vtkDirectionFieldSingularities()
singularities.SetInputConnection(field.GetOutputPort())
edit([*four(1, 45), *four(-1, 0)])
edit([*four(1, 0), *four(-1, 0)])
