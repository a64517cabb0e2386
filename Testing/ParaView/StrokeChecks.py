# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of strokes have in common. The plugin has to be loaded."""
import numpy as np
from directionfields import strokes
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = [800, 600]


def middle(view, source):
    """Where the view shows the middle of a source."""
    bounds = np.array(source.GetDataInformation().GetBounds()).reshape(3, 2)
    return strokes.Screen(view).pixels(bounds.mean(axis=1)[None])[0]


def names():
    """The kinds of sources."""
    return sorted(source.GetXMLName() for source in simple.GetSources().values())


def points_of(source):
    """The points of each line of a source of strokes."""
    data = servermanager.Fetch(source)
    points = vtk_to_numpy(data.GetPoints().GetData())

    def numbers(cell):
        return [cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]
    return [points[numbers(data.GetCell(k))] for k in range(data.GetNumberOfCells())]


def pixels_of(picture, view, color):
    """How many pixels of a view have a color, by way of a file for the picture."""
    simple.SaveScreenshot(picture, view, ImageResolution=SIZE)
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    scalars = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3] / 255.0
    return int((np.abs(scalars - color).max(axis=1) < 0.05).sum())


def new_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    return view


def caption(field):
    return servermanager.Fetch(field).GetFieldData().GetAbstractArray("Summary").GetValue(0)
