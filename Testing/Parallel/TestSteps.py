# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What nothing but a rule decides, on several processes: mpiexec -n 2 pvbatch --symmetric TestSteps.py PACKAGES WAY...

The phase of each time step of a moving surface, and which of several smoothest fields is chosen. WAY is gathered or distributed."""
import sys

sys.path.insert(0, sys.argv[1])

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject

import Surfaces
from Comparing import check, compare, count, directions, end, rank
from directionfields_vtk import vtkDirectionField, vtkPDirectionField

WAYS = {"gathered": vtkPDirectionField.GATHER, "distributed": vtkPDirectionField.DISTRIBUTED}


def turned(points, angle, moving):
    """The points that move are turned about the z axis."""
    turn = np.array([[np.cos(angle), np.sin(angle), 0.0], [-np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])
    return np.where(moving[:, None], points @ turn, points)


def make(kind, way=None):
    field = kind()
    field.SetTolerance(1e-10)
    if way is not None:
        field.SetDistribution(way)
    return field


def step(field, mesh, time):
    mesh.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
    field.SetInputData(mesh)
    field.Update()


def first_angle(one, other):
    """The largest angle between the first directions of two fields of degree 4 up to a quarter turn, at most of the points."""
    a, b = (directions(field.GetOutput().GetPointData(), 4)[:, 0] for field in (one, other))
    angle = np.arccos(np.clip((a * b).sum(axis=1), -1.0, 1.0)) % (np.pi / 2.0)
    return np.quantile(np.minimum(angle, np.pi / 2.0 - angle), 0.9)


def test_steps(way):
    """A surface turns, and its field with it; with only one of two components moving, that of the other one stays."""
    for surface, which in ((Surfaces.potato(9), "all"), (Surfaces.pair(8), "one"), (Surfaces.moebius(40, 7), "strip")):
        points, triangles = surface
        moving = np.ones(len(points), dtype=bool) if which != "one" else points[:, 0] < 1.05
        # The pieces of the second surface are its components, nearly: one process has moved and the other has not.
        owner = Surfaces.owners(points, triangles, "ids" if which == "one" else "slabs", count)
        whole, part = make(vtkDirectionField), make(vtkPDirectionField, WAYS[way])
        # A field of a surface with one side can only change its sign, by an eighth of a turn.
        for time, angle in enumerate((0.0, 0.4, 0.8) if which == "strip" else (0.0, 0.35, 0.7)):
            places = turned(points, angle, moving)
            step(whole, Surfaces.piece(places, triangles, {}, owner * 0, 0), time)
            step(part, Surfaces.piece(places, triangles, {}, owner, rank), time)
            compare(whole, part, 4, f"{which} {way} step {time} process {rank}")
            used = Surfaces.array(part.GetOutput().GetFieldData(), "Distribution").reshape(-1)[0]
            check(used == (2 if way == "distributed" else 1), which, way, used)
        # Without the steps before, the phase is another one.
        alone = make(vtkDirectionField)
        step(alone, Surfaces.piece(places, triangles, {}, owner * 0, 0), 0)
        check(first_angle(alone, whole) > 0.1, "the steps matter", first_angle(alone, whole))


def sphere(rows=8):
    """An octahedron blown up: the smallest eigenvalue of vector fields is triple, for its turns mix three of them."""
    points, triangles = [], []
    for signs in np.ndindex(2, 2, 2):
        x, y, z = 1.0 - 2.0 * np.array(signs)
        corners = np.array([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]])[::int(x * y * z)]
        number = {}
        for i in range(rows + 1):
            for j in range(rows + 1 - i):
                number[i, j] = len(points)
                points.append(np.array([rows - i - j, i, j]) @ corners)
        for i, j in number:
            if i + j < rows:
                triangles.append([number[i, j], number[i + 1, j], number[i, j + 1]])
            if i + j < rows - 1:
                triangles.append([number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]])
    unique, inverse = np.unique(np.array(points), axis=0, return_inverse=True)
    return unique / np.linalg.norm(unique, axis=1)[:, None], inverse.reshape(-1)[np.array(triangles)]


def test_several(way):
    """Where there are several smoothest fields, that is said; where there is one, or something guides it, it is not."""
    guided = {"Alignment": vtkDirectionField.ALIGN_POINT_VECTORS, "GuidanceVectors": "Wanted"}
    for name, (points, triangles), options, degree, wanted in (
            ("sphere", sphere(), {}, 1, True), ("guided sphere", sphere(), guided, 1, False),
            ("potato", Surfaces.potato(9), {}, 4, False)):
        owner = Surfaces.owners(points, triangles, "slabs", count)
        vectors = np.stack([points[:, 1], -points[:, 0], 0.2 + points[:, 2]], axis=1)
        field = make(vtkPDirectionField, WAYS[way])
        field.SetDegree(degree)
        for option, value in options.items():
            getattr(field, "Set" + option)(value)
        heard = []
        field.AddObserver("WarningEvent", lambda *_: heard.append(1))
        field.SetInputData(Surfaces.piece(points, triangles, {"Wanted": vectors}, owner, rank))
        field.Update()
        warnings = field.GetOutput().GetFieldData().GetAbstractArray("Warnings")
        texts = [warnings.GetValue(k) for k in range(warnings.GetNumberOfValues())] if warnings else []
        used = Surfaces.array(field.GetOutput().GetFieldData(), "Distribution").reshape(-1)[0]
        check(used == (2 if way == "distributed" else 1), name, used, texts)
        said = any("several smoothest fields" in text for text in texts)
        check(said == (wanted and way == "distributed"), name, texts)
        check(bool(heard) == (said and rank == 0), name, "heard", heard)


for way in filter(None, sys.argv[2:]):
    for test in (test_steps, test_several):
        test(way)
end()
