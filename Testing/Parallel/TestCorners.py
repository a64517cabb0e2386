# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What geometry leaves open is decided for pieces as for the whole: mpiexec -n 3 pvbatch --symmetric TestCorners.py PACKAGES

At the corners of a box three edges are equally sharp, and vectors may point along all of them or against all: the order
of points decides, which global ids keep."""
import sys

sys.path.insert(0, sys.argv[1])

import numpy as np

import Surfaces
from Comparing import compare, count, end, make, rank
from directionfields_vtk import vtkDirectionField, vtkPDirectionField


def box(size=7):
    """Of equal squares, its points in no order."""
    u = np.linspace(0.0, 1.0, size)
    s, t = (values.reshape(-1) for values in np.meshgrid(u, u, indexing="ij"))
    points, triangles = [], []
    for axis in range(3):
        for side in (0.0, 1.0):
            face = np.full((size * size, 3), side)
            face[:, (axis + 1) % 3], face[:, (axis + 2) % 3] = s, t
            cells = Surfaces.grid_triangles(size, size)
            triangles.append((cells if side else cells[:, ::-1]) + size * size * len(points))
            points.append(face)
    points, inverse = np.unique(np.round(np.concatenate(points), 9), axis=0, return_inverse=True)
    number = np.random.default_rng(4).permutation(len(points))
    shuffled = np.empty_like(points)
    shuffled[number] = points
    return shuffled * (1.0, 1.0, 2.0), number[inverse.reshape(-1)][np.concatenate(triangles)]


def main():
    points, triangles = box()
    for degree in (1, 2, 3, 4, 6):
        for way in ("random", "slabs"):
            options = {"Degree": degree, "ConstrainSharpEdges": 1}
            owner = Surfaces.owners(points, triangles, way, count)
            whole = make(vtkDirectionField, options, Surfaces.piece(points, triangles, {}, owner * 0, 0))
            options["Distribution"] = vtkPDirectionField.GATHER
            part = make(vtkPDirectionField, options,
                        Surfaces.piece(points, triangles, {}, owner, rank, ids=True))
            compare(whole, part, degree, f"degree {degree}, {way}")


main()
end()
