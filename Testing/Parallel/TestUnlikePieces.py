# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pieces that differ in what must not matter: numbers of points, types, arrays, sizes of triangles.
mpiexec -n 3 pvbatch --symmetric TestUnlikePieces.py PACKAGES distributed|gathered, what the build has"""
import sys
import zlib

sys.path.insert(0, sys.argv[1])

import numpy as np
from vtkmodules.vtkCommonCore import VTK_DOUBLE

import Surfaces
from Comparing import check, compare, compare_singularities, count, end, make, rank, total
from directionfields_vtk import vtkDirectionField, vtkPDirectionField

WAYS = [vtkPDirectionField.GATHER] + [vtkPDirectionField.DISTRIBUTED] * (sys.argv[2] == "distributed")


def both(points, triangles, owner, options, way, name, dtype=None, **kind):
    """The fields of the whole and of the pieces, compared."""
    mesh = Surfaces.piece(points, triangles, {}, owner * 0, 0)
    whole = make(vtkDirectionField, options, mesh)
    own = points if dtype is None else points.astype(dtype)
    part = make(vtkPDirectionField, {**options, "Distribution": way},
                Surfaces.piece(own, triangles, {}, owner, rank, **kind))
    used = Surfaces.array(part.GetOutput().GetFieldData(), "Distribution").reshape(-1)[0]
    check(used == way, name, "was not done as asked for", used)
    compare(whole, part, options.get("Degree", 4), name)
    compare_singularities(whole, part, name)
    return whole, part


def check_same_arrays(part, name):
    """All processes have arrays of the same names, types and numbers of components, active vectors among them."""
    kinds = []
    for port in range(2):
        for data in (part.GetOutput(port).GetPointData(), part.GetOutput(port).GetCellData()):
            arrays = [data.GetArray(k) for k in range(data.GetNumberOfArrays())]
            kinds.append(sorted((a.GetName(), a.GetDataType(), a.GetNumberOfComponents()) for a in arrays
                                if a.GetName() not in ("From", "vtkGhostType")))
            kinds.append(data.GetVectors() and data.GetVectors().GetName())
    digest = zlib.crc32(repr(kinds).encode())
    check(total(digest) == count * digest, name, "arrays", kinds)


def bumpy_square(size=9):
    """Flat where it ends, on a grid."""
    x, y = np.meshgrid(np.linspace(0.0, 1.0, size), np.linspace(0.0, 1.0, size), indexing="ij")
    z = 0.4 * (x * y * (1.0 - x) * (1.0 - y) * 16.0) ** 3 * (1.0 + 0.3 * x)
    return np.stack([x, y, z], axis=2).reshape(-1, 3), Surfaces.grid_triangles(size, size)


def test_corners():
    """Which edge stands for a right-angled corner of lines depends neither on numbers nor on the pieces."""
    points, triangles = bumpy_square()
    for way in WAYS:
        for seed in range(2):
            owner = np.random.default_rng(seed).integers(0, count, len(triangles))
            both(points, triangles, owner, {"Degree": 2, "ConstrainBoundary": 1}, way, f"corners {way} {seed}")


def test_types():
    """Pieces of single and of double precision have arrays of double precision, and the same bits where they meet."""
    points, triangles = Surfaces.half(11)
    # Coordinates that single precision has.
    points = points.astype(np.float32).astype(np.float64)
    for way in WAYS:
        for options, kind in (({}, {"ghosts": True}), ({"ConstrainBoundary": 1}, {})):
            owner = Surfaces.owners(points, triangles, "slabs", count)
            dtype = np.float32 if rank % 2 == 0 else np.float64
            name = f"types {way} {options} {kind}"
            _, part = both(points, triangles, owner, options, way, name, dtype, **kind)
            check_same_arrays(part, name)
            check(part.GetOutput().GetPointData().GetArray("Direction0").GetDataType() == VTK_DOUBLE, name)
            check(not part.GetOutput(1).GetNumberOfPoints() or
                  part.GetOutput(1).GetPoints().GetDataType() == VTK_DOUBLE, name, "singularities")


def test_arrays():
    """A process without any of the surface, with or without points, has the arrays that the others have."""
    points, triangles = Surfaces.half(9)
    owner = Surfaces.owners(points, triangles, "empty", count)
    for way in WAYS:
        for options in ({}, {"ConstrainBoundary": 1, "Degree": 2}):
            name = f"arrays {way} {options}"
            _, part = both(points, triangles, owner, options, way, name)
            check_same_arrays(part, name)
            mesh = Surfaces.piece(points, triangles, {}, owner, rank)
            if rank == count - 1:
                mesh = Surfaces.poly_data(points[:5], np.zeros((0, 3)))
            part = make(vtkPDirectionField, {**options, "Distribution": way}, mesh)
            check_same_arrays(part, name + ", points alone")
            constraint = part.GetOutput().GetPointData().GetArray("ConstraintKind")
            check((constraint is not None) == ("ConstrainBoundary" in options), name)
            check(constraint is None or constraint.GetNumberOfTuples() == mesh.GetNumberOfPoints(), name)


def test_lost_copies():
    """Ghost cells that are copies of nothing show no field, and one process says how many there are."""
    points, triangles = Surfaces.half(9)
    owner = Surfaces.owners(points, triangles, "slabs", count)
    # The cells of one process that others have copies of, at one point.
    shared = [np.isin(np.arange(len(points)), triangles[owner == p]) for p in (0, 1)]
    point = np.flatnonzero(shared[0] & shared[1])[0]
    lost = (triangles == point).any(axis=1) & (owner == 1)
    pieces_with = [p for p in range(count) if p != 1 and np.isin(triangles[lost], triangles[owner == p]).any()]
    check(lost.any() and 0 in pieces_with, "there is something to be lost")
    owner[lost] = count
    for way in WAYS:
        name = f"lost copies {way}"
        mesh = Surfaces.piece(points, triangles, {}, owner, rank, ghosts=True)
        heard = []
        whole = make(vtkDirectionField, {}, Surfaces.piece(points, triangles[~lost], {}, owner[~lost] * 0, 0))
        field = vtkPDirectionField()
        field.AddObserver("WarningEvent", lambda *_: heard.append(1))
        field.SetTolerance(1e-10)
        field.SetDistribution(way)
        field.SetInputData(mesh)
        field.Update()
        data = field.GetOutput().GetFieldData()
        copies = Surfaces.array(mesh.GetCellData(), "vtkGhostType") == 1
        cells = Surfaces.array(mesh.GetCellData(), "From").astype(int)
        number = int(total(np.count_nonzero(copies & lost[cells])))
        warnings = data.GetAbstractArray("Warnings")
        texts = [warnings.GetValue(k) for k in range(warnings.GetNumberOfValues())] if warnings else []
        check(sum(f" {number} ghost cell" in text for text in texts) == 1 and total(len(heard)) == 1,
              name, texts, heard, number)
        for figure in ("Eigenvalue", "IndexSum"):
            wanted, found = (Surfaces.array(each.GetOutput().GetFieldData(), figure)[0] for each in (whole, field))
            check(abs(found - wanted) <= 1e-9 * abs(wanted), name, figure, wanted, found)
        # Points that only lost copies have.
        known = np.isin(Surfaces.array(mesh.GetPointData(), "From"), triangles[~lost])
        direction = Surfaces.array(field.GetOutput().GetPointData(), "Direction0").reshape(-1, 3)
        length = np.linalg.norm(direction, axis=1)
        check(np.allclose(length[known], 1.0, atol=1e-6) and not length[~known].any(), name, length)


def test_lengths():
    """Edges that are short beside the whole surface, but not beside those of their piece."""
    around, rings = 24, 14
    angle = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)
    radius = 10.0 ** -np.arange(rings)[:, None]
    ring = np.stack([radius * np.cos(angle), radius * np.sin(angle), 0.3 * radius ** 2 * np.sin(2.0 * angle)], axis=2)
    points = np.concatenate([ring.reshape(-1, 3), np.zeros((1, 3))])
    k, j = (x.reshape(-1) for x in np.meshgrid(np.arange(rings - 1), np.arange(around), indexing="ij"))
    a, b = k * around + j, k * around + (j + 1) % around
    inner = (rings - 1) * around + np.arange(around)
    triangles = np.concatenate([np.stack([a, b, b + around], axis=1), np.stack([a, b + around, a + around], axis=1),
                                np.stack([inner, np.roll(inner, -1), np.full(around, len(points) - 1)], axis=1)])
    # The outermost point of each triangle decides.
    owner = np.minimum(triangles.min(axis=1) // around // 2, count - 1)
    for way in WAYS:
        whole = make(vtkDirectionField, {}, Surfaces.piece(points, triangles, {}, owner * 0, 0))
        part = make(vtkPDirectionField, {"Distribution": way}, Surfaces.piece(points, triangles, {}, owner, rank))
        compare(whole, part, 4, f"lengths {way}")
        repairs = Surfaces.array(whole.GetOutput().GetFieldData(), "Repairs").reshape(-1)
        check(repairs[3] > 0, "triangles without area", repairs)


tests = [test_corners, test_types, test_arrays, test_lost_copies, test_lengths]
for test in tests:
    test()
end()
