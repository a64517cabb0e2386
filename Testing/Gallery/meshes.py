# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of the gallery's figures, as vtkPolyData."""

import itertools
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataConnectivityFilter


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


def ordered(points, triangles):
    """Points by their coordinates, triangles by their points: versions of VTK number what their
    filters make differently, and noise and the places of glyphs follow the numbers."""
    order = np.lexsort(np.round(points, 4).T)
    number = np.empty(len(order), dtype=np.int64)
    number[order] = np.arange(len(order))
    triangles = number[triangles]
    first = np.argmin(triangles, axis=1)
    turned = triangles[np.arange(len(triangles))[:, None], (first[:, None] + np.arange(3)) % 3]
    return points[order], turned[np.lexsort(turned.T[::-1])]


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


def sleeve(around=96, along=120):
    """A bent tube that gets narrower, with an arc of 70 degrees."""
    part, angle = np.meshgrid(np.linspace(0.0, 1.0, along + 1),
                              2.0 * np.pi * np.arange(around) / around, indexing="ij")
    bend = np.radians(70.0) * part
    radius = 1.0 - 0.5 * part
    reach = 4.0 + radius * np.cos(angle)
    points = np.stack([reach * np.cos(bend), reach * np.sin(bend), radius * np.sin(angle)], axis=-1)
    return polydata(points.reshape(-1, 3), grid_triangles(around, along + 1, wrap_columns=True))


def annulus(around=108, across=10):
    """A flat ring around a hole of half its radius, with the point vectors Around."""
    radius, angle = np.meshgrid(np.linspace(2.0, 1.0, across + 1),
                                2.0 * np.pi * np.arange(around) / around, indexing="ij")
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.0 * radius], axis=-1)
    mesh = polydata(points.reshape(-1, 3), grid_triangles(around, across + 1, wrap_columns=True))
    vectors = np.stack([-np.sin(angle), np.cos(angle), 0.0 * angle], axis=-1).reshape(-1, 3)
    array = numpy_to_vtk(vectors, deep=True)
    array.SetName("Around")
    mesh.GetPointData().AddArray(array)
    return mesh


def with_stress(mesh, stress):
    """The mesh with n x 6 tensors at its points, XX, YY, ZZ, XY, YZ, XZ."""
    array = numpy_to_vtk(stress, deep=True)
    array.SetName("Stress")
    mesh.GetPointData().AddArray(array)
    return mesh


def stressed_plate(around=192, across=60):
    """A plate with a hole of radius 1 that is pulled along x (G. Kirsch 1898), finer near the hole."""
    t = 2.0 * np.pi * np.arange(around) / around
    end = 4.0 / np.maximum(np.abs(np.cos(t)), np.abs(np.sin(t)))
    radius = end ** np.linspace(0.0, 1.0, across + 1)[:, None]
    points = np.stack([radius * np.cos(t), radius * np.sin(t), 0.0 * radius], axis=-1).reshape(-1, 3)
    s = 1.0 / np.maximum(1.0, radius**2)
    mean = 0.5 - s * np.cos(2.0 * t)
    polar = (-s + (1.0 - 2.0 * s + 3.0 * s**2) * np.cos(2.0 * t)
             - 1j * (1.0 + 2.0 * s - 3.0 * s**2) * np.sin(2.0 * t)) / 2.0
    q, zero = polar * np.exp(2j * t), 0.0 * s
    stress = np.stack([mean + q.real, mean - q.real, zero, q.imag, zero, zero], axis=-1)
    triangles = grid_triangles(around, across + 1, wrap_columns=True)
    return with_stress(polydata(points, triangles[:, ::-1]), stress.reshape(-1, 6))


def pressurized_torus(around=120, across=60, minor=0.4):
    """A shell of radii 1 and minor under pressure 1, of thickness 1."""
    b, a = np.meshgrid(2.0 * np.pi * np.arange(across) / across,
                       2.0 * np.pi * np.arange(around) / around, indexing="ij")
    ring = 1.0 + minor * np.cos(b)
    points = np.stack([ring * np.cos(a), ring * np.sin(a), minor * np.sin(b)], axis=-1)
    along = np.stack([-np.sin(a), np.cos(a), 0.0 * a], axis=-1)
    tube = np.stack([-np.sin(b) * np.cos(a), -np.sin(b) * np.sin(a), np.cos(b)], axis=-1)
    pull = 0.5 * minor * (1.0 + ring) / ring
    stress = [pull * tube[..., i] * tube[..., j] + 0.5 * minor * along[..., i] * along[..., j]
              for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))]
    return with_stress(polydata(points.reshape(-1, 3), grid_triangles(around, across, True, True)),
                       np.stack(stress, axis=-1).reshape(-1, 6))


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


def icosahedron(subdivisions=16):
    """An icosahedron whose edges are divided into so many parts, and its flat faces with them."""
    golden = 0.5 * (1.0 + math.sqrt(5.0))
    corners = np.array([
        np.roll((0.0, y, z * golden), turn)
        for turn in range(3) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    faces = [
        face for face in itertools.combinations(range(12), 3)
        if all(np.linalg.norm(corners[a] - corners[b]) < 2.1
               for a, b in itertools.combinations(face, 2))]
    # Weights in whole numbers, so that the points of an edge are the same from both its faces.
    number = {}
    triangles = []

    def point(face, *weights):
        key = frozenset((v, w) for v, w in zip(face, weights) if w > 0)
        return number.setdefault(key, len(number))

    n = subdivisions
    for face in faces:
        if np.linalg.det(corners[list(face)]) < 0.0:
            face = face[::-1]
        for i in range(n):
            for j in range(n - i):
                k = n - i - j
                a, b = point(face, k, i, j), point(face, k - 1, i + 1, j)
                c = point(face, k - 1, i, j + 1)
                triangles.append((a, b, c))
                if k > 1:
                    triangles.append((b, point(face, k - 2, i + 1, j + 1), c))
    points = [sum(w * corners[v] for v, w in key) / (n * golden) for key in number]
    return closed(*ordered(np.array(points), np.array(triangles)))


def rounded_cube():
    """The surface |x|^6 + |y|^6 + |z|^6 = 1."""
    ball = icosahedron(32)
    points = vtk_to_numpy(ball.GetPoints().GetData()).astype(float)
    points /= np.sum(points ** 6, axis=1)[:, None] ** (1.0 / 6.0)
    return closed(points, vtk_to_numpy(ball.GetPolys().GetConnectivityArray()).reshape(-1, 3))


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
    points, triangles = ordered(
        vtk_to_numpy(mesh.GetPoints().GetData()).astype(float),
        vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3))
    points += noise * np.random.RandomState(seed).standard_normal(points.shape)
    return closed(points, triangles)
