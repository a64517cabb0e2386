# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The surface of a picture: TestShadedSurface.py PLUGIN"""
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals, vtkStripper
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource, vtkSphereSource

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())


def made(source):
    source.Update()
    data = vtkPolyData()
    data.DeepCopy(source.GetOutput())
    data.GetPointData().SetNormals(None)
    data.GetPointData().Initialize()
    return data


def with_data(mesh, factor):
    """The same points and cells with other data, as a filter for data makes it."""
    data = vtkPolyData()
    data.ShallowCopy(mesh)
    for name, attributes, count in (("p", data.GetPointData(), mesh.GetNumberOfPoints()),
                                    ("c", data.GetCellData(), mesh.GetNumberOfCells())):
        array = numpy_to_vtk(factor * np.arange(count, dtype=float), deep=True)
        array.SetName(name)
        array.GetRange()
        attributes.AddArray(array)
    return data


def expected(data, angle=60.0):
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SetFeatureAngle(angle)
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def numbers(data):
    points, cells = data.GetPointData(), data.GetCellData()
    return [vtk_to_numpy(array) for array in (
        data.GetPoints().GetData(), points.GetNormals(), points.GetArray("p"),
        cells.GetArray("c"), data.GetPolys().GetConnectivityArray(),
        data.GetLines().GetConnectivityArray(), data.GetVerts().GetConnectivityArray())]


def check(got, data, angle=60.0):
    wanted = numbers(expected(data, angle))
    for one, other in zip(numbers(got), wanted):
        assert one.shape == other.shape and np.array_equal(one, other), (one, other)
    # As many values may be there again, but no others.
    for attributes, name in ((got.GetPointData(), "p"), (got.GetCellData(), "c")):
        values = vtk_to_numpy(attributes.GetArray(name))
        assert attributes.GetArray(name).GetRange() == (values.min(), values.max())


def meshes():
    """Smooth, with sharp edges, of strips, and beside lines."""
    sphere, cube = vtkSphereSource(), vtkCubeSource()
    strips, both = vtkStripper(), vtkAppendPolyData()
    strips.SetInputConnection(sphere.GetOutputPort())
    for source in (cube, vtkLineSource()):
        both.AddInputConnection(source.GetOutputPort())
    return [made(source) for source in (sphere, cube, strips, both)]


def shaded(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    surface = ShadedSurface(Input=source)
    return source.GetClientSideObject(), surface


def output(surface):
    surface.UpdatePipeline()
    return surface.GetClientSideObject().GetOutputDataObject(0)


def test_is_that_of_normals():
    for mesh in meshes():
        producer, surface = shaded(with_data(mesh, 1.0))
        check(output(surface), with_data(mesh, 1.0))
        before = output(surface)
        points, normals = before.GetPoints(), before.GetPointData().GetNormals()
        cells = before.GetPolys()
        # Only the data change: the rest stays, as the same objects.
        producer.SetOutput(with_data(mesh, 3.0))
        surface.Input.SMProxy.MarkDirty(None)
        after = output(surface)
        check(after, with_data(mesh, 3.0))
        assert after.GetPoints() is points and after.GetPointData().GetNormals() is normals
        assert after.GetPolys() is cells
        # Points that move in place, and another angle.
        mesh.GetPoints().SetPoint(0, 0.1, 0.2, 0.9)
        mesh.GetPoints().Modified()
        producer.SetOutput(with_data(mesh, 2.0))
        surface.Input.SMProxy.MarkDirty(None)
        check(output(surface), with_data(mesh, 2.0))
        surface.FeatureAngle = 10.0
        check(output(surface), with_data(mesh, 2.0), 10.0)


def test_blocks():
    """Each block has its own, also where they change places."""
    first, second = meshes()[:2]
    blocks = vtkMultiBlockDataSet()
    producer, surface = shaded(blocks)
    for k, (one, other) in enumerate(((first, second), (second, first))):
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, with_data(one, 1.0 + k))
        blocks.SetBlock(2, with_data(other, 5.0 + k))
        producer.SetOutput(blocks)
        surface.Input.SMProxy.MarkDirty(None)
        got = output(surface)
        check(got.GetBlock(0), with_data(one, 1.0 + k))
        check(got.GetBlock(2), with_data(other, 5.0 + k))


def test_nothing():
    producer, surface = shaded(vtkPolyData())
    assert output(surface).GetNumberOfPoints() == 0


test_is_that_of_normals()
test_blocks()
test_nothing()
print("passed")
