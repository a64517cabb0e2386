# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Alignment and constraints in Python: TestAlignment.py PLUGIN"""
import math
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from paraview import servermanager
from paraview.simple import *

import AllFigures

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()


def source(points, cells, **arrays):
    """A source of quads with point arrays. The first one of 3 components is the active vectors."""
    mesh = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetDataTypeToDouble()
    for point in points:
        coordinates.InsertNextPoint(point)
    polygons = vtkCellArray()
    for cell in cells:
        polygons.InsertNextCell(len(cell), cell)
    mesh.SetPoints(coordinates)
    mesh.SetPolys(polygons)
    for name, values in arrays.items():
        array = vtkDoubleArray()
        array.SetName(name)
        array.SetNumberOfComponents(len(values[0]))
        for value in values:
            array.InsertNextTuple(value)
        mesh.GetPointData().AddArray(array)
        if len(values[0]) == 3 and not mesh.GetPointData().GetVectors():
            mesh.GetPointData().SetActiveVectors(name)
    proxy = TrivialProducer()
    proxy.GetClientSideObject().SetOutput(mesh)
    proxy.UpdatePipeline()
    return proxy


def cylinder(around=48, along=24):
    """A cylinder of radius 1 and height 3 with helical vectors of slope 1/2, with weights on the
    upper half, and with a stress of 2 around it and -1 along it."""
    angles = [2.0 * math.pi * i / around for i in range(around)]
    points = [(math.cos(a), math.sin(a), 3.0 * j / along) for j in range(along + 1) for a in angles]
    cells = [(j * around + i, j * around + (i + 1) % around, (j + 1) * around + (i + 1) % around,
              (j + 1) * around + i) for j in range(along) for i in range(around)]
    helix = [(-y, x, 0.5) for x, y, z in points]
    stress = [(2.0 * y * y, 2.0 * x * x, -1.0, -2.0 * x * y, 0.0, 0.0) for x, y, z in points]
    return source(points, cells, Helix=helix, Stress=stress,
                  Upper=[(1.0 if z > 1.5 else 0.0,) for x, y, z in points])


def disk(cells=12):
    """A disk of radius 1, made of squares about the center that are bent to circles."""
    n = 2 * cells + 1
    points = []
    for j in range(-cells, cells + 1):
        for i in range(-cells, cells + 1):
            ring = max(abs(i), abs(j)) / cells
            length = math.hypot(i, j) or 1.0
            points.append((ring * i / length, ring * j / length, 0.0))
    quads = [(j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i)
             for j in range(n - 1) for i in range(n - 1)]
    return source(points, quads)


def value(surface, name):
    return surface.GetFieldData().GetArray(name).GetTuple1(0)


def largest_angle(surface, degree, wanted, where=lambda point: True):
    """The largest angle, in degrees, between a wanted direction and the nearest one of the field, at
    the points where(point) allows."""
    arrays = [surface.GetPointData().GetArray("Direction%d" % k) for k in range(degree)]
    largest = 0.0
    count = 0
    for i in range(surface.GetNumberOfPoints()):
        point = surface.GetPoint(i)
        if where(point):
            target = wanted(point)
            length = math.sqrt(sum(t * t for t in target))
            cosine = max(sum(t * d for t, d in zip(target, array.GetTuple3(i))) / length
                         for array in arrays)
            largest = max(largest, math.degrees(math.acos(min(1.0, cosine))))
            count += 1
    assert count > 40, count
    return largest


def around(point):
    return (-point[1], point[0], 0.0)


def test_curvature():
    mesh = cylinder()
    inside = lambda point: 0.5 < point[2] < 2.5
    field = DirectionField(Input=mesh, Alignment="Principal Curvature", AlignmentStrength=0.7,
                           GuidanceVectors="Helix")
    assert field.Alignment == "Principal Curvature" and field.GuidanceVectors == "Helix"
    surface = servermanager.Fetch(field)
    assert largest_angle(surface, 4, around, inside) < 2.0
    points = surface.GetPointData()
    for name in ("PrincipalDirection0", "PrincipalDirection1", "MeanCurvature",
                 "GaussianCurvature"):
        assert points.GetArray(name), name
    low, high = points.GetArray("MeanCurvature").GetRange()
    assert 0.2 < low and high < 0.55, (low, high)
    assert value(surface, "Lambda") < value(surface, "Eigenvalue")
    assert value(surface, "SystemResidual") < 1e-6

    field.Degree = 2
    assert largest_angle(servermanager.Fetch(field), 2, around, inside) < 2.0
    field.CurvatureDirection = "Minimum"
    assert largest_angle(servermanager.Fetch(field), 2, lambda p: (0, 0, 1), inside) < 2.0

    # Without alignment none of its arrays remain.
    field.Alignment = "None"
    surface = servermanager.Fetch(field)
    assert not surface.GetPointData().GetArray("MeanCurvature")
    assert value(surface, "Lambda") == value(surface, "Eigenvalue")
    for proxy in (field, mesh):
        Delete(proxy)


def test_vectors():
    mesh = cylinder()
    helix = lambda point: (-point[1], point[0], 0.5)
    field = DirectionField(Input=mesh, Degree=6, Alignment="Point Vectors")
    # The panel starts with the active vectors and without weights.
    assert field.GuidanceVectors == "Helix", field.GuidanceVectors
    assert field.GuidanceWeights == "None", field.GuidanceWeights
    energies = []
    angles = []
    for strength in (0.0, 0.3, 0.6, 0.9, 1.0):
        field.AlignmentStrength = strength
        surface = servermanager.Fetch(field)
        energies.append(value(surface, "SmoothnessEnergy"))
        angles.append(largest_angle(surface, 6, helix))
    assert all(a <= b + 1e-9 for a, b in zip(energies, energies[1:])), energies
    assert angles[-1] < 0.01, angles

    # A shift of the same size in 1 / length^2 gives the same field.
    field.AlignmentStrength = 0.6
    surface = servermanager.Fetch(field)
    shift = value(surface, "Eigenvalue") - value(surface, "Lambda")
    field.UseShift = 1
    field.Shift = shift
    field.AlignmentStrength = 0.1
    shifted = servermanager.Fetch(field)
    assert abs(value(shifted, "Lambda") - value(surface, "Lambda")) < 1e-9 * shift
    assert abs(value(shifted, "SmoothnessEnergy") / value(surface, "SmoothnessEnergy") - 1) < 1e-6

    # The same vectors are constraints where the weight is positive.
    field.Alignment = "None"
    field.ConstrainGuidance = 1
    field.GuidanceWeights = "Upper"
    for solver in ("Least Squares", "Energy"):
        field.ConstraintSolver = solver
        surface = servermanager.Fetch(field)
        kinds = surface.GetPointData().GetArray("ConstraintKind")
        for i in range(surface.GetNumberOfPoints()):
            assert kinds.GetTuple1(i) == (5 if surface.GetPoint(i)[2] > 1.5 else 0), i
        assert largest_angle(surface, 6, helix, lambda point: point[2] > 1.5) < 0.01
    for proxy in (field, mesh):
        Delete(proxy)


def test_tensor():
    """Tension around a cylinder, compression along it: which array, which direction, which values."""
    mesh = cylinder()
    cells = PointDatatoCellData(Input=mesh, ProcessAllArrays=1)
    cells.UpdatePipeline()
    for proxy, association in ((mesh, "POINTS"), (cells, "CELLS")):
        # As in the window, where the input is the active source.
        SetActiveSource(proxy)
        field = DirectionField(Input=proxy, Alignment="Tensor", Degree=2)
        # The panel starts with the array that there is.
        assert field.TensorArray.GetAssociation() == association, field.TensorArray
        assert field.TensorArray.GetArrayName() == "Stress"
        assert largest_angle(servermanager.Fetch(field), 2, around) < 0.1
        field.TensorDirection = "Minor"
        assert largest_angle(servermanager.Fetch(field), 2, lambda p: (0, 0, 1)) < 0.1
        field.Degree = 4
        surface = servermanager.Fetch(field)
        assert largest_angle(surface, 4, around) < 0.1
        values = [surface.GetPointData().GetArray(name).GetRange() for name in (
            "MajorValue", "MinorValue", "TensorAnisotropy")]
        # Means over cells lose a little of what is bent.
        assert all(abs(value - wanted) < 0.03 for pair, wanted in zip(values, (2.0, -1.0, 1.5))
                   for value in pair), values
        lines = DirectionFieldStreamlines(Input=field)
        low, high = servermanager.Fetch(lines).GetPointData().GetArray("PrincipalValue").GetRange()
        assert abs(low + 1.0) < 0.03 and abs(high - 2.0) < 0.05, (low, high)
        for made in (lines, field):
            Delete(made)
    field = DirectionField(Input=mesh, Alignment="Tensor", TensorArray=["POINTS", "Stress"], Degree=2)
    field.TensorStrength = 0.5
    assert value(servermanager.Fetch(field), "Lambda") < value(servermanager.Fetch(field), "Eigenvalue")
    for proxy in (field, cells, mesh):
        Delete(proxy)


def test_boundary():
    mesh = disk()
    field = DirectionField(Input=mesh)
    surface = servermanager.Fetch(field)
    assert value(surface, "IndexSum") == 0
    assert not surface.GetPointData().GetArray("ConstraintKind")
    on_boundary = lambda point: math.hypot(point[0], point[1]) > 0.999
    assert largest_angle(surface, 4, around, on_boundary) > 30.0

    field.ConstrainBoundary = 1
    energies = set()
    for solver in ("Least Squares", "Energy"):
        field.ConstraintSolver = solver
        surface = servermanager.Fetch(field)
        assert value(surface, "IndexSum") == 4
        energies.add(value(surface, "SmoothnessEnergy"))
        assert largest_angle(surface, 4, around, on_boundary) < 0.1
        kinds = surface.GetPointData().GetArray("ConstraintKind")
        constrained = [i for i in range(kinds.GetNumberOfTuples()) if kinds.GetTuple1(i) == 1]
        assert len(constrained) == 8 * 12, len(constrained)
        assert kinds.GetRange() == (0, 1)
        singularities = servermanager.Fetch(field, idx=1)
        index = singularities.GetPointData().GetArray("SingularityIndex")
        assert singularities.GetNumberOfPoints() == 4
        assert index.GetRange() == (1, 1)
    assert len(energies) == 2 and min(energies) > 0.0, energies
    for proxy in (field, mesh):
        Delete(proxy)


test_curvature()
test_vectors()
test_tensor()
test_boundary()
print("passed")
