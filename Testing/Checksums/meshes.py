# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces whose results are compared: made by formulas, or read from files, as vtkPolyData.

Each has the point arrays Guide (vectors), Weight (with zeros) and Size, which options name, and the cell array
Number.
"""

import itertools
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader

# How much is computed on a surface.
BASIC, FULL, LARGE = "basic", "full", "large"
# Files of more cells are large.
MOST_CELLS_OF_SMALL_FILES = 8000


def array(name, values):
    result = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    result.SetName(name)
    return result


def cell_array(cells):
    """Cells of any numbers of points, as lists or as rows of an array."""
    result = vtkCellArray()
    sizes = [len(cell) for cell in cells]
    ids = np.concatenate([np.asarray(cell, np.int64) for cell in cells]) if sizes else np.empty(0, np.int64)
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    result.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(ids, deep=True))
    return result


def polydata(points, polys, strips=(), lines=(), verts=(), precision=np.float64):
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(np.asarray(points, dtype=precision).reshape(-1, 3), deep=True))
    for kind, cells in (("Verts", verts), ("Lines", lines), ("Polys", polys), ("Strips", strips)):
        if len(cells):
            getattr(mesh, f"Set{kind}")(cell_array(cells))
    return mesh


def points_of(mesh):
    """The places as n x 3 doubles."""
    if not mesh.GetNumberOfPoints():
        return np.zeros((0, 3))
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(np.float64)


def ids_of(cells):
    return vtk_to_numpy(cells.GetConnectivityArray())


def with_data(mesh):
    """The mesh with the arrays that options name."""
    points = points_of(mesh)
    finite = points[np.isfinite(points).all(axis=1)]
    low = finite.min(axis=0) if len(finite) else np.zeros(3)
    size = np.linalg.norm(np.ptp(finite, axis=0)) if len(finite) else 1.0
    x, y, z = (np.nan_to_num((points - low) / max(size, 1e-300))).T
    guide = np.stack([np.sin(5.0 * y) + 0.3, np.cos(4.0 * z + x), x - y], axis=-1)
    data = mesh.GetPointData()
    data.AddArray(array("Guide", guide))
    data.AddArray(array("Weight", np.maximum(0.0, np.sin(9.0 * x + 5.0 * z + 1.0)).astype(np.float32)))
    data.AddArray(array("Size", 1.0 + 0.5 * np.sin(6.0 * x + 1.0)))
    mesh.GetCellData().AddArray(array("Number", np.arange(mesh.GetNumberOfCells(), dtype=np.int32)))
    return mesh


def lattice(columns, rows, wrap_columns=False, wrap_rows=False):
    """The squares of a lattice whose points are numbered row by row."""
    i, j = (k.ravel() for k in np.meshgrid(
        np.arange(columns if wrap_columns else columns - 1), np.arange(rows if wrap_rows else rows - 1)))
    right, above = (i + 1) % columns, (j + 1) % rows
    return np.stack([j * columns + i, j * columns + right, above * columns + right, above * columns + i], axis=-1)


def halved(quads):
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def lattice_points(columns, rows, place):
    """place(u, v) over [0, 1) x [0, 1]: three coordinates."""
    v, u = np.meshgrid(np.linspace(0.0, 1.0, rows), np.arange(columns) / columns, indexing="ij")
    return np.stack(np.broadcast_arrays(*place(u, v)), axis=-1).reshape(-1, 3)


def icosphere(levels):
    golden = 0.5 * (1.0 + 5.0 ** 0.5)
    points = np.array([
        np.roll((0.0, y, z * golden), turn) for turn in range(3) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    distances = np.linalg.norm(points[:, None] - points[None], axis=-1)
    near = (distances > 0.1) & (distances < 2.1)
    triangles = np.array([
        (a, b, c) if np.linalg.det(points[[a, b, c]]) > 0.0 else (a, c, b)
        for a in range(12) for b in range(a) for c in range(b) if near[a, b] and near[b, c] and near[c, a]])
    for _ in range(levels):
        points, triangles = subdivided(points, triangles)
    return points / np.linalg.norm(points, axis=1)[:, None], triangles


def subdivided(points, triangles):
    """Each triangle split in four."""
    a, b, c = triangles.T
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges, number = np.unique(edges, axis=0, return_inverse=True)
    ab, bc, ca = number.reshape(3, -1) + len(points)
    fine = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return (
        np.concatenate([points, 0.5 * (points[edges[:, 0]] + points[edges[:, 1]])]),
        np.concatenate([np.stack(triangle, axis=-1) for triangle in fine]))


def potato(levels):
    """A closed surface without symmetries."""
    points, triangles = icosphere(levels)
    x, y, z = points.T
    radius = 1.0 + 0.2 * np.sin(2.0 * x + 0.5) + 0.15 * np.cos(3.0 * y - z) + 0.1 * np.sin(4.0 * z + 2.0 * x * y)
    return points * radius[:, None] * [1.0, 1.2, 0.8], triangles


def torus(around, across, minor=0.4):
    """A torus with bumps, of quads."""
    def place(u, v):
        a, b = 2.0 * np.pi * u, 2.0 * np.pi * v * (across - 1) / across
        r = minor * (1.0 + 0.12 * np.sin(2.0 * a + 0.4) * np.cos(b))
        return (1.0 + r * np.cos(b)) * np.cos(a), (1.0 + r * np.cos(b)) * np.sin(a), r * np.sin(b)
    return lattice_points(around, across, place), lattice(around, across, True, True)


def plane(cells, place=lambda x, y: (x, y, 0.0 * x)):
    """A square of side 1, of quads, bent by place(x, y)."""
    side = np.linspace(0.0, 1.0, cells + 1)
    y, x = np.meshgrid(side, side, indexing="ij")
    return np.stack(place(x, y), axis=-1).reshape(-1, 3), lattice(cells + 1, cells + 1)


def tube(around, along, place):
    """An open tube of quads; place(angle, height)."""
    points = lattice_points(around, along + 1, lambda u, v: place(2.0 * np.pi * u, v))
    return points, lattice(around, along + 1, wrap_columns=True)


def vase():
    """A surface of revolution that is convex and concave."""
    def place(angle, height):
        radius = 0.5 + 0.25 * np.sin(5.0 * height)
        return radius * np.cos(angle), radius * np.sin(angle), 2.0 * height
    return tube(32, 24, place)


def moebius(around, across):
    """A strip closed with a half turn."""
    u, v = np.meshgrid(np.arange(around) / around, np.linspace(-0.3, 0.3, across + 1), indexing="ij")
    angle = 2.0 * np.pi * u
    ring = 1.0 + v * np.cos(0.5 * angle)
    points = np.stack([ring * np.cos(angle), ring * np.sin(angle), v * np.sin(0.5 * angle)], axis=-1)
    quads = lattice(across + 1, around + 1)
    last = quads >= around * (across + 1)
    return points.reshape(-1, 3), np.where(last, across - (quads - around * (across + 1)), quads)


def klein_bottle(around, across):
    """A figure eight that is turned half around on its way around a circle."""
    u, v = (2.0 * np.pi * k for k in np.meshgrid(
        np.arange(around) / around, np.arange(across) / across, indexing="ij"))
    out = np.cos(0.5 * u) * np.sin(v) - np.sin(0.5 * u) * np.sin(2.0 * v)
    up = np.sin(0.5 * u) * np.sin(v) + np.cos(0.5 * u) * np.sin(2.0 * v)
    points = np.stack([(2.0 + out) * np.cos(u), (2.0 + out) * np.sin(u), up], axis=-1).reshape(-1, 3)
    quads = lattice(across, around + 1, wrap_columns=True)
    last = quads >= around * across
    return points, np.where(last, -(quads - around * across) % across, quads)


def voxels(filled):
    """The boundary of a solid of unit cubes, of quads; no manifold where cubes touch in an edge or a corner."""
    filled = np.pad(np.asarray(filled, dtype=bool), 1)
    corners = []
    for axis in range(3):
        u, v = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]]
        for sign in (1, -1):
            cells = np.argwhere(filled & ~np.roll(filled, -sign, axis))
            base = cells + (np.eye(3, dtype=int)[axis] if sign > 0 else 0)
            quad = [base, base + u, base + u + v, base + v]
            corners.append(np.stack(quad[::sign], axis=1))
    corners = np.concatenate(corners)
    points, number = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return points - 1.0, number.reshape(-1, 4)


def box(*sizes, holes=()):
    solid = np.ones(sizes, dtype=bool)
    for hole in holes:
        solid[hole] = False
    return voxels(solid)


def dual(points, triangles):
    """The polygons around the points of a closed mesh."""
    centers = points[triangles].mean(axis=1)
    polygons = []
    for v, normal in enumerate(points):
        around = np.argwhere((triangles == v).any(axis=1)).ravel()
        x = centers[around[0]] - points[v]
        arms = centers[around] - points[v]
        angles = np.arctan2(arms @ np.cross(normal, x), arms @ x)
        polygons.append(around[np.argsort(angles)])
    return centers, polygons


def letters():
    """Plane polygons that are not convex: an L, a U beside it, and a square ring joined by a bridge."""
    points = [
        (0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3), (6, 0), (6, 3), (5, 3), (5, 1), (4, 1), (4, 3), (3, 3),
        (0, 6), (3, 6), (1, 4), (2, 4), (2, 5), (1, 5)]
    polygons = [(0, 1, 2, 3, 4, 5), (1, 6, 7, 8, 9, 10, 11, 12, 2), (5, 12, 14, 13, 5, 15, 18, 17, 16, 15)]
    return [(x, y, 0.1 * x * y) for x, y in points], polygons


def star(corners):
    """A plane polygon that is not convex, of many corners, beside a triangle."""
    angle = 2.0 * np.pi * np.arange(corners) / corners
    radius = 1.0 + 0.5 * np.cos(17.0 * angle)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.0 * angle], axis=-1)
    return np.concatenate([points, [(2.0, 2.0, 0.0)]]), [range(corners), (1, 0, corners)]


def cone(around):
    """A fan of many triangles around the tip."""
    angle = 2.0 * np.pi * np.arange(around) / around
    points = np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=-1)
    return np.concatenate([points, [(0.0, 0.0, 0.7)]]), [(k, (k + 1) % around, around) for k in range(around)]


def doubled():
    """Quads of which some are there twice, from another corner on or wound the other way, and a pillow."""
    points, quads = plane(6)
    pillow = np.array([(0, 1, 2, 3), (0, 3, 2, 1)]) + len(points)
    places = [(2, 0, 0), (3, 0, 0), (3, 1, 0.1), (2, 1, 0)]
    more = [quads[4], quads[9, [2, 3, 0, 1]], quads[20, ::-1], *pillow]
    return np.concatenate([points, places]), np.concatenate([quads, more])


def strips():
    """A tube of triangle strips, one a ring."""
    points, quads = tube(24, 10, lambda a, h: (np.cos(a), np.sin(a), 3.0 * h))
    rows = [np.stack([row[:, 0], row[:, 3]], axis=1).ravel() for row in quads.reshape(10, 24, 4)]
    return points, [np.concatenate([row, row[:2]])[::-1] for row in rows]


def joined(*parts):
    """Meshes side by side, each moved along x."""
    points, cells, count = [], [], 0
    for k, (place, some) in enumerate(parts):
        points.append(np.asarray(place) + [3.0 * k, 0.0, 0.0])
        cells += [np.asarray(cell) + count for cell in some]
        count += len(place)
    return np.concatenate(points), cells


def soup(points, triangles):
    """Each triangle with points of its own."""
    return points[triangles].reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)


def moved(points, length, seed, directions=(1.0, 1.0, 1.0)):
    noise = np.random.RandomState(seed).standard_normal(points.shape)
    return points + length * noise * np.asarray(directions)


def rough(points, triangles, length, seed):
    """Noise along the normals of a surface around the origin."""
    heights = np.random.RandomState(seed).standard_normal(len(points))
    return points + length * heights[:, None] * points / np.linalg.norm(points, axis=1)[:, None], triangles


def dirty():
    """Turned, doubled, collapsed and flat triangles, and points that none uses."""
    points, triangles = icosphere(2)
    triangles = triangles.copy()
    triangles[::9] = triangles[::9, ::-1]
    a, b, c = triangles[40]
    points = np.concatenate([points, [0.5 * (points[a] + points[b]), (5.0, 5.0, 5.0)]])
    more = [triangles[3], triangles[5][[1, 2, 0]], (a, a, c), (a, b, len(points) - 2)]
    return points, np.concatenate([triangles, more])


def mixed():
    """Vertices, lines, triangles, quads and strips in one dataset, with cell data of several types."""
    points, quads = plane(12, lambda x, y: (x, y, 0.2 * np.sin(4.0 * x * y)))
    points = np.concatenate([points, [(0.5, 0.5, 1.0)]])
    rows = quads.reshape(12, 12, 4)
    polys = [*halved(rows[:4].reshape(-1, 4)), *rows[4:8].reshape(-1, 4)]
    bands = [np.concatenate([row[:, [3, 0]].ravel(), row[-1, [2, 1]]]) for row in rows[8:]]
    mesh = polydata(points, polys, strips=bands, lines=[(0, 1, 2), (5, 18)], verts=[(3,), (len(points) - 1,)])
    names = vtkStringArray()
    names.SetName("Name")
    for k in range(mesh.GetNumberOfCells()):
        names.InsertNextValue(f"cell {k}")
    mesh.GetCellData().AddArray(names)
    warmth = np.linspace(0.0, 1.0, mesh.GetNumberOfCells()).astype(np.float32)
    mesh.GetCellData().SetScalars(array("Temperature", warmth))
    mesh.GetPointData().SetScalars(array("Color", (np.arange(len(points)) % 251).astype(np.uint8)))
    mesh.GetFieldData().AddArray(array("Time", np.array([0.25])))
    return mesh


def ghosts():
    """Cells of another piece, hidden cells and a hidden point."""
    points, quads = plane(14, lambda x, y: (x, y, 0.3 * x * x))
    mesh = polydata(points, halved(quads))
    kinds = np.zeros(mesh.GetNumberOfCells(), dtype=np.uint8)
    kinds[:28] = vtkDataSetAttributes.DUPLICATECELL
    kinds[200:206] = vtkDataSetAttributes.HIDDENCELL
    mesh.GetCellData().AddArray(array("vtkGhostType", kinds))
    return mesh


def triangulated(mesh, **options):
    points, quads = mesh
    return polydata(points, halved(quads), **options)


def closed_surfaces():
    sphere, noisy = icosphere(3), potato(3)
    yield "tetrahedron", BASIC, polydata(
        [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)])
    yield "sphere", BASIC, polydata(*sphere)
    yield "potato", FULL, polydata(*noisy)
    yield "potato-float", BASIC, polydata(*noisy, precision=np.float32)
    yield "potato-tiny", BASIC, polydata(noisy[0] * 1e-9, noisy[1])
    yield "potato-far", BASIC, polydata(noisy[0] + [1e5, -2e5, 3e5], noisy[1])
    yield "noisy-sphere", BASIC, polydata(*rough(*sphere, 0.03, 1))
    around = moved(sphere[0], 0.03, 2)
    around /= np.linalg.norm(around, axis=1)[:, None]
    yield "sliver-sphere", FULL, polydata(around * [20.0, 1.0, 1.0], sphere[1])
    yield "torus", FULL, triangulated(torus(40, 20))
    yield "quad-torus", BASIC, polydata(*torus(30, 14))
    yield "polygons", FULL, polydata(*dual(*icosphere(3)))
    yield "box", FULL, triangulated(box(8, 6, 4))
    yield "quad-l", BASIC, polydata(*box(9, 9, 3, holes=[np.s_[3:, 3:]]))
    yield "genus-two", FULL, triangulated(box(12, 8, 3, holes=[np.s_[2:5, 3:5], np.s_[7:10, 3:5]]))
    yield "hollow", BASIC, triangulated(box(6, 6, 6, holes=[np.s_[2:4, 2:4, 2:4]]))
    points, quads = box(9, 9, 6, holes=[np.s_[4:, 4:]])
    yield "noisy-bracket", FULL, polydata(moved(points, 0.06, 3), halved(quads))


def open_surfaces():
    yield "triangle", BASIC, polydata([(0, 0, 0), (1, 0, 0), (0.3, 1, 0.2)], [(0, 1, 2)])
    yield "two-triangles", BASIC, triangulated(plane(1))
    yield "square", FULL, triangulated(plane(16))
    yield "saddle", BASIC, triangulated(plane(20, lambda x, y: (x, y, (x - 0.4) ** 2 - (y - 0.5) ** 2)))
    yield "cylinder", BASIC, triangulated(tube(24, 16, lambda a, h: (np.cos(a), np.sin(a), 3.0 * h)))
    yield "vase", FULL, triangulated(vase())
    points, quads = plane(16)
    center = points[quads].mean(axis=1)
    yield "l-shape", FULL, polydata(points, halved(quads[(center[:, 0] < 0.5) | (center[:, 1] < 0.5)]))
    ring = np.abs(center - [0.5, 0.5, 0.0]).max(axis=1) > 0.2
    yield "square-ring", BASIC, polydata(points, halved(quads[ring]))
    yield "needles", BASIC, polydata(moved(points, 0.015, 4, (1, 1, 0)) * [50.0, 1.0, 1.0], halved(quads))
    yield "moebius", FULL, triangulated(moebius(40, 5))
    yield "klein-bottle", FULL, triangulated(klein_bottle(40, 20))
    yield "graded", BASIC, triangulated(plane(16, lambda x, y: (x ** 4, y, 0.3 * np.sin(3.0 * x))))
    yield "cone", BASIC, polydata(*cone(150))
    yield "letters", BASIC, polydata(*letters())
    yield "star", BASIC, polydata(*star(240))
    points, bands = strips()
    yield "strips", BASIC, polydata(points, (), strips=bands)
    yield "mixed", FULL, mixed()
    yield "ghosts", FULL, ghosts()


def broken_surfaces():
    points, triangles = icosphere(2)
    square = plane(6)
    yield "components", FULL, polydata(*joined(
        potato(2), (torus(16, 8)[0], halved(torus(16, 8)[1])), (square[0], halved(square[1])),
        ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])))
    yield "many-components", BASIC, polydata(*joined(*[icosphere(0)] * 60))
    yield "soup", FULL, polydata(*soup(points, triangles))
    yield "doubled", BASIC, polydata(*doubled())
    yield "dirty", FULL, polydata(*dirty())
    touching = np.zeros((6, 6, 3), dtype=bool)
    touching[:3, :3] = touching[3:, 3:] = True
    yield "touching-edge", FULL, triangulated(voxels(touching))
    yield "quad-touching-edge", BASIC, polydata(*voxels(touching))
    touching = np.zeros((4, 4, 4), dtype=bool)
    touching[:2, :2, :2] = touching[2:, 2:, 2:] = True
    yield "touching-corner", BASIC, triangulated(voxels(touching))
    sheets = [plane(8, lambda x, y, a=a: (x * np.cos(a), x * np.sin(a), y)) for a in (0.0, 2.0, 4.2)]
    book, cells = joined(*((p - [3.0 * k, 0.0, 0.0], halved(q)) for k, (p, q) in enumerate(sheets)))
    places, number = np.unique(np.round(book, 9), axis=0, return_inverse=True)
    yield "book", FULL, polydata(places, number.ravel()[np.array(cells)])
    yield "nothing", BASIC, vtkPolyData()
    yield "points-only", BASIC, polydata(points, (), verts=[(0,), (1,)])
    points = points.copy()
    points[7, 1] = np.nan
    yield "not-finite", BASIC, polydata(points, triangles)


def large_surfaces():
    """For multigrid, and for factors of more rows than the solver takes one for by itself."""
    yield "large-torus", LARGE, triangulated(torus(120, 60))
    yield "large-potato", LARGE, polydata(*potato(5), precision=np.float32)
    points, quads = box(40, 30, 12, holes=[np.s_[15:, 12:]])
    yield "large-bracket", LARGE, polydata(moved(points, 0.05, 5), halved(quads))


def files(directory):
    """The meshes of a directory's .ply, .obj and .stl files."""
    readers = {".ply": vtkPLYReader, ".obj": vtkOBJReader, ".stl": vtkSTLReader}
    for path in sorted(pathlib.Path(directory).iterdir()):
        if path.suffix in readers:
            reader = readers[path.suffix]()
            reader.SetFileName(str(path))
            reader.Update()
            mesh = reader.GetOutput()
            yield path.name, BASIC if mesh.GetNumberOfCells() <= MOST_CELLS_OF_SMALL_FILES else LARGE, mesh


def surfaces(directories):
    """Name, extent and mesh of all, those of the directories' files last."""
    made = (open_surfaces(), closed_surfaces(), broken_surfaces(), large_surfaces())
    for name, extent, mesh in itertools.chain(*made, *map(files, directories)):
        yield name, extent, with_data(mesh)
