# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests read off a direction field."""
import re


def names(attributes):
    return [attributes.GetArrayName(k) for k in range(attributes.GetNumberOfArrays())]


def values(array):
    return [array.GetTuple1(k) for k in range(array.GetNumberOfTuples())]


def total(array):
    return sum(int(value) for value in values(array))


def figures(surface, singularities):
    """The figures of a field: with Diagnostics those of each connected component, too."""
    data = surface.GetFieldData()
    found = {name: values(data.GetArray(name))
             for name in ("Eigenvalue", "Residual", "IndexSum", "EulerCharacteristic")
             if data.HasArray(name)}
    found["Singularities"] = singularities.GetNumberOfPoints()
    found["Total"] = total(singularities.GetPointData().GetArray("SingularityIndex"))
    return found


def sets(trace, variable, name, value):
    """Whether a Python trace gives a property of a variable that value. ParaView 6 sets all properties
    in one call, one a line."""
    return (f"{variable}.{name} = {value}\n" in trace
            or re.search(rf"\b{variable}\.Set\([^)]*\b{name}={value}[,)\n]", trace) is not None)


def pixels(path, condition):
    """How many pixels of a PNG file satisfy condition(red, green, blue)."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    rgb = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
    return int(condition(rgb[:, 0], rgb[:, 1], rgb[:, 2]).sum())


def red(r, g, b):
    return (r > 100) & (g < r / 3) & (b < r / 3)


def blue(r, g, b):
    return (b > 100) & (r < b / 2.5) & (g < b / 1.8)


def teal(r, g, b):
    return (g > 1.6 * r) & (b > 1.6 * r) & (b < 1.5 * g) & (g > 60)
