# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces without symmetry, and the ways in which they come to lie on several processes."""
import numpy as np
from vtkmodules.numpy_interface import dataset_adapter as dsa
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData


def poly_data(points, triangles):
    """A vtkPolyData of arrays of shape (points, 3) and (triangles, 3)."""
    mesh = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    mesh.SetPoints(places)
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(
            np.ascontiguousarray(triangles, dtype=np.int64).reshape(-1), deep=True))
    mesh.SetPolys(cells)
    return mesh


def grid_triangles(columns, rows):
    """Triangles between the points column * rows + row."""
    i, j = np.meshgrid(np.arange(columns - 1), np.arange(rows - 1), indexing="ij")
    a = (i * rows + j).reshape(-1)
    return np.concatenate([np.stack([a, a + rows, a + 1], axis=1),
                           np.stack([a + 1, a + rows, a + rows + 1], axis=1)])


def potato(size=24, shift=0.0):
    """Closed, a cube blown up to an ellipsoid with bumps: its smallest eigenvalues differ."""
    u = np.linspace(-1.0, 1.0, size)
    points, triangles = [], []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            s, t = np.meshgrid(u, u, indexing="ij")
            face = np.empty((size * size, 3))
            face[:, axis] = sign
            face[:, (axis + 1) % 3] = s.reshape(-1)
            face[:, (axis + 2) % 3] = t.reshape(-1)
            cells = grid_triangles(size, size)
            triangles.append((cells if sign > 0 else cells[:, ::-1]) + size * size * len(points))
            points.append(face)
    points, triangles = np.concatenate(points), np.concatenate(triangles)
    unique, inverse = np.unique(np.round(points, 9), axis=0, return_inverse=True)
    triangles = inverse.reshape(-1)[triangles]
    points = unique / np.linalg.norm(unique, axis=1)[:, None]
    x, y, z = points.T
    bump = 1.0 + 0.13 * x * y + 0.09 * np.sin(3.0 * z + x) + 0.05 * y ** 3
    points = points * bump[:, None] * (1.0, 1.3, 0.8) + (shift, 0.0, 0.0)
    return points, triangles


def half(size=24):
    """With a boundary: what of a potato is below a slanted plane."""
    points, triangles = potato(size)
    below = points @ (0.2, 0.1, 1.0) < 0.1
    triangles = triangles[below[triangles].all(axis=1)]
    used, triangles = np.unique(triangles, return_inverse=True)
    return points[used], triangles.reshape(-1, 3)


def noisy(size=24):
    """A component with noise but on one side, as of a scanner, and one without noise."""
    points, triangles = potato(size)
    random = np.random.default_rng(4)
    edge = np.linalg.norm(points[triangles[:, 0]] - points[triangles[:, 1]], axis=1).mean()
    errors = 0.03 * edge * random.normal(size=len(points)) * (points @ (0.9, 0.3, 0.2) > -0.4)
    others, more = potato(size - 3, shift=2.5)
    return (np.concatenate([points * (1.0 + errors[:, None]), others]),
            np.concatenate([triangles, more + len(points)]))


def turned(size=24):
    """Closed, a third of its triangles inside out."""
    points, triangles = potato(size)
    flipped = np.random.default_rng(3).random(len(triangles)) < 1.0 / 3.0
    triangles[flipped] = triangles[flipped][:, ::-1]
    return points, triangles


def pair(size=16):
    """Two components."""
    points, triangles = potato(size)
    others, more = potato(size - 3, shift=2.1)
    return (np.concatenate([points, others * (1.0, 0.7, 1.0)]),
            np.concatenate([triangles, more + len(points)]))


def moebius(columns=60, rows=9):
    """A strip that cannot be oriented, wider on one side."""
    angle = np.linspace(0.0, 2.0 * np.pi, columns)[:, None]
    across = np.linspace(-0.4, 0.4, rows)[None, :] * (1.0 + 0.2 * np.sin(angle + 0.4))
    radius = 1.0 + across * np.cos(angle / 2.0) + 0.1 * np.cos(2.0 * angle)
    points = np.stack([radius * np.cos(angle), 1.2 * radius * np.sin(angle),
                       across * np.sin(angle / 2.0)], axis=2).reshape(-1, 3)
    triangles = grid_triangles(columns, rows)
    last = (columns - 1) * rows
    number = np.arange(len(points))
    # The last column is the first one upside down.
    number[last:] = np.arange(rows)[::-1]
    return points[:last], number[triangles]


def klein(columns=48, rows=24):
    """A closed surface with one side, whose tube is an eight that makes half a turn on its way around."""
    u, v = np.meshgrid(np.arange(columns) * 2.0 * np.pi / columns, (np.arange(rows) + 0.5) * 2.0 * np.pi / rows,
                       indexing="ij")
    across, along = np.sin(v) * (1.0 + 0.1 * np.cos(u)), np.sin(2.0 * v) * 0.9
    radius = 2.5 + np.cos(u / 2.0) * across - np.sin(u / 2.0) * along
    height = np.sin(u / 2.0) * across + np.cos(u / 2.0) * along
    points = np.stack([radius * np.cos(u), 1.2 * radius * np.sin(u), height], axis=2).reshape(-1, 3)
    number = np.arange(columns * rows).reshape(columns, rows)
    # After half a turn v is where -v was.
    number = np.concatenate([number, number[:1, ::-1]])
    number = np.concatenate([number, number[:, :1]], axis=1)
    corners = number.reshape(-1)
    return points, corners[grid_triangles(columns + 1, rows + 1)]


def mixed():
    """A component with one side between two with two sides, some of whose triangles are inside out."""
    points, triangles = turned(9)
    strip, more = moebius(40, 7)
    ball, last = potato(8, shift=7.0)
    return (np.concatenate([points, strip + (3.5, 0.0, 0.0), ball]),
            np.concatenate([triangles, more + len(points), last + len(points) + len(strip)]))


def sheets(size=14):
    """Three sheets that meet in an edge."""
    s, t = np.meshgrid(np.linspace(0.0, 1.0, size), np.linspace(0.0, 1.3, size), indexing="ij")
    points, triangles = [], []
    for angle in (0.0, 1.9, 4.0):
        bent = 0.1 * np.sin(3.0 * t + angle) * s
        points.append(np.stack([s * np.cos(angle) - bent * np.sin(angle),
                                s * np.sin(angle) + bent * np.cos(angle), t],
                               axis=2).reshape(-1, 3))
        triangles.append(grid_triangles(size, size) + size * size * len(triangles))
    points, triangles = np.concatenate(points), np.concatenate(triangles)
    unique, inverse = np.unique(np.round(points, 9), axis=0, return_inverse=True)
    return unique, inverse.reshape(-1)[triangles]


def owners(points, triangles, way, count):
    """The process of each triangle."""
    center = points[triangles].mean(axis=1)
    if way == "random":
        return np.random.default_rng(5).integers(0, count, len(triangles))
    if way == "scattered":
        # The rings around the first process's triangles meet in single vertices, too.
        few = np.random.default_rng(5).uniform(size=len(triangles)) < 0.03
        return np.where(few, 0, 1 + np.arange(len(triangles)) % max(1, count - 1))
    if way == "ids":
        return np.arange(len(triangles)) * count // len(triangles)
    if way == "one":
        return np.full(len(triangles), count - 1)
    # Slanted slabs of equal numbers, hence through vertices everywhere.
    along = center @ (0.9, 0.3, 0.2)
    used = max(1, count - 1) if way == "empty" else count
    order = np.argsort(np.argsort(along))
    return order * used // len(triangles)


def piece(points, triangles, arrays, owner, rank, ghosts=False, ids=False, noise=0.0, cell_arrays=None):
    """The piece of one process, with where its points and cells are from.

    ghosts adds the triangles around the piece, marked as copies; ids adds global ids; noise moves points
    as rounding does, on each process otherwise."""
    own = owner == rank
    mark = np.zeros(len(triangles), dtype=np.uint8)
    if ghosts:
        touched = np.zeros(len(points), dtype=bool)
        touched[triangles[own].reshape(-1)] = True
        around = touched[triangles].any(axis=1) & ~own
        mark[around] = vtkDataSetAttributes.DUPLICATECELL
        own = own | around
    cells = np.flatnonzero(own)
    used, corners = np.unique(triangles[cells], return_inverse=True)
    places = points[used]
    if noise:
        places = places + np.random.default_rng(rank).uniform(-noise, noise, places.shape)
    mesh = poly_data(places.astype(points.dtype), corners.reshape(-1, 3))
    wrapped = dsa.WrapDataObject(mesh)
    wrapped.PointData.append(used.astype(np.int64), "From")
    wrapped.CellData.append(cells.astype(np.int64), "From")
    for name, values in arrays.items():
        wrapped.PointData.append(values[used], name)
    for name, values in (cell_arrays or {}).items():
        wrapped.CellData.append(values[cells], name)
    if ghosts:
        marks = numpy_to_vtk(mark[cells], deep=True, array_type=VTK_UNSIGNED_CHAR)
        marks.SetName(vtkDataSetAttributes.GhostArrayName())
        mesh.GetCellData().AddArray(marks)
    if ids:
        numbers = numpy_to_vtkIdTypeArray(used.astype(np.int64) * 3 + 7, deep=True)
        numbers.SetName("GlobalIds")
        mesh.GetPointData().SetGlobalIds(numbers)
    return mesh


def array(data, name):
    """An array as numpy's; of shape (0,) where it is empty."""
    values = data.GetArray(name)
    assert values is not None, f"no array {name}"
    return vtk_to_numpy(values) if values.GetNumberOfTuples() else np.zeros(0)
