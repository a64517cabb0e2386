# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of the gallery's figures, as vtkPolyData."""

import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataConnectivityFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource


def polydata(points, triangles):
    """A mesh from arrays of n x 3 coordinates and m x 3 corners."""
    triangles = np.asarray(triangles, dtype=np.int64)
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.asarray(points, dtype=float), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(vtk_points)
    mesh.SetPolys(cells)
    return mesh


def closed(points, triangles):
    """A closed mesh, wound so that its volume is positive."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    volume = np.sum(a * np.cross(b, c))
    return polydata(points, triangles if volume > 0.0 else triangles[:, ::-1])


def grid_triangles(columns, rows, wrap_columns=False, wrap_rows=False):
    """Two triangles for each square of a lattice whose points are numbered row by row."""
    i, j = np.meshgrid(
        np.arange(columns if wrap_columns else columns - 1),
        np.arange(rows if wrap_rows else rows - 1))
    i, j = i.ravel(), j.ravel()
    a = j * columns + i
    b = j * columns + (i + 1) % columns
    c = (j + 1) % rows * columns + (i + 1) % columns
    d = (j + 1) % rows * columns + i
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def torus(around=120, across=60, major=1.0, minor=0.42):
    """A torus with bumps, so that its field is unique."""
    b, a = np.meshgrid(
        2.0 * math.pi * np.arange(across) / across, 2.0 * math.pi * np.arange(around) / around,
        indexing="ij")
    r = minor * (1.0 + 0.12 * np.sin(2.0 * a + 0.4) * np.cos(b))
    ring = major + r * np.cos(b)
    points = np.stack([ring * np.cos(a), ring * np.sin(a), r * np.sin(b)], axis=-1)
    return polydata(points.reshape(-1, 3), grid_triangles(around, across, True, True))


def disk(cells=24):
    """The unit disk, of squares bent to circles; a quarter turn maps it to itself."""
    i, j = np.meshgrid(np.arange(-cells, cells + 1), np.arange(-cells, cells + 1))
    p = np.stack([i, j], axis=-1).reshape(-1, 2) / cells
    ring = np.abs(p).max(axis=1)
    length = np.linalg.norm(p, axis=1)
    p = p * np.where(length > 0.0, ring / np.maximum(length, 1e-300), 0.0)[:, None]
    n = 2 * cells + 1
    triangles = []
    for y in range(2 * cells):
        for x in range(2 * cells):
            a = y * n + x
            b, c, d = a + 1, a + 1 + n, a + n
            # Diagonals point to the center in all four quadrants.
            if (x < cells) == (y < cells):
                triangles += [(a, b, c), (a, c, d)]
            else:
                triangles += [(a, b, d), (b, c, d)]
    return polydata(np.column_stack([p, np.zeros(len(p))]), triangles)


def icosahedron(subdivisions=4):
    """An icosahedron whose flat faces are subdivided."""
    solid = vtkPlatonicSolidSource()
    solid.SetSolidTypeToIcosahedron()
    fine = vtkLinearSubdivisionFilter()
    fine.SetNumberOfSubdivisions(subdivisions)
    fine.SetInputConnection(solid.GetOutputPort())
    fine.Update()
    mesh = fine.GetOutput()
    # The solid's own scalars are of no concern here.
    return closed(
        vtk_to_numpy(mesh.GetPoints().GetData()).astype(float),
        vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def plate(around=192, across=60, radius=0.6, bevel=0.15):
    """A square plate with a large round hole, whose sides are bent down over bevels."""
    wall = 0.5 * math.pi * bevel + 0.3
    t, a = np.meshgrid(
        np.arange(across + 1) / across,
        2.0 * math.pi * np.arange(around) / around + 0.25 * math.pi, indexing="ij")
    ray = np.stack([np.cos(a), np.sin(a)], axis=-1)
    largest = np.abs(ray).max(axis=-1)
    p = ((1.0 - t) * radius + t * (1.0 + wall) / largest)[..., None] * ray
    outer = np.abs(p).max(axis=-1)
    beyond = outer - (1.0 - bevel)
    bend = np.clip(beyond / bevel, 0.0, 0.5 * math.pi)
    scale = np.where(beyond > 0.0, (1.0 - bevel + bevel * np.sin(bend)) / outer, 1.0)
    z = bevel * (np.cos(bend) - 1.0) - np.maximum(0.0, beyond - 0.5 * math.pi * bevel)
    points = np.concatenate([p * scale[..., None], z[..., None]], axis=-1).reshape(-1, 3)
    return polydata(points, grid_triangles(around, across + 1, True)[:, [0, 2, 1]])


def noisy_part(resolution=60, noise=0.006, seed=7):
    """A machined part with sharp edges, cut out of implicit functions, its points shaken."""
    axis = np.linspace(-1.2, 1.2, resolution)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    block = np.maximum.reduce([np.abs(x) - 0.9, np.abs(y) - 0.65, np.abs(z) - 0.45])
    groove = 0.42 - np.hypot(y - 0.65, z - 0.45)
    slope = (x + 1.1 * z - 0.75) / math.hypot(1.0, 1.1)
    bore = 0.28 - np.hypot(x + 0.3, y + 0.05)
    image = vtkImageData()
    image.SetDimensions(resolution, resolution, resolution)
    image.SetOrigin(-1.2, -1.2, -1.2)
    image.SetSpacing(*3 * (2.4 / (resolution - 1),))
    values = np.maximum.reduce([block, groove, slope, bore])
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    contour = vtkContourFilter()
    contour.SetInputData(image)
    contour.SetValue(0, 0.0)
    contour.ComputeScalarsOff()
    contour.ComputeNormalsOff()
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(contour.GetOutputPort())
    largest.SetExtractionModeToLargestRegion()
    largest.Update()
    mesh = largest.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    points += noise * np.random.RandomState(seed).standard_normal(points.shape)
    return closed(
        points, vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3))
