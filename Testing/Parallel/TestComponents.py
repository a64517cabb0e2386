# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many components, of which most are on one process alone: mpiexec -n 3 pvbatch --symmetric TestComponents.py PACKAGES [TEST...]

Those are solved for as one process does, on all processes at once, as others are that are moved to a process; what is larger than a
process's share and lies across processes is solved for by all."""
import re
import sys
import time

sys.path.insert(0, sys.argv[1])

import numpy as np

import Surfaces
from Comparing import check, compare, compare_singularities, count, end, make, rank, total
from directionfields_vtk import vtkDirectionField, vtkPDirectionField

DIRECT, MULTIGRID = vtkDirectionField.SOLVER_DIRECT, vtkDirectionField.SOLVER_MULTIGRID


def many():
    """Closed and bounded components beside each other, and which process has which triangle."""
    points, triangles, owner, first = [], [], [], 0
    for k in range(8):
        own, corners = (Surfaces.half if k % 3 == 2 else Surfaces.potato)(7 + k % 4 if k < 5 else 10 if k < 7 else 28)
        points.append(own * (1.0, 1.0 + 0.1 * k, 1.0) + (3.0 * k, 0.0, 0.0))
        triangles.append(corners + first)
        first += len(own)
        # The last three lie across processes, and the last one is too large to be moved to one.
        owner.append(np.full(len(corners), k % count) if k < 5 else
                     Surfaces.owners(own, corners, ("slabs", "random", "scattered")[k - 5], count))
    return np.concatenate(points), np.concatenate(triangles), np.concatenate(owner)


def test_fields():
    points, triangles, owner = many()
    arrays = {"Wanted": points[:, [1, 2, 0]] + 0.3, "Few": (points[:, 1] > 0.9) * 1.5}
    guided = {"Alignment": vtkDirectionField.ALIGN_POINT_VECTORS, "GuidanceVectors": "Wanted"}
    for options in ({}, {"ConstrainBoundary": 1, "Degree": 2}, guided,
                    {**guided, "GuidanceWeights": "Few", "ConstrainGuidance": 1, "ConstrainBoundary": 1}):
        whole = make(vtkDirectionField, options, Surfaces.piece(points, triangles, arrays, owner * 0, 0))
        part = make(vtkPDirectionField, {**options, "Distribution": vtkPDirectionField.DISTRIBUTED},
                    Surfaces.piece(points, triangles, arrays, owner, rank))
        name = f"components {options}"
        data = [field.GetOutput().GetFieldData() for field in (whole, part)]
        check(Surfaces.array(data[1], "Distribution").reshape(-1)[0] == 2, name)
        compare(whole, part, options.get("Degree", 4), name)
        compare_singularities(whole, part, name)
        # Those of one process are solved for in the same way as if it had nothing else.
        order = [np.argsort(Surfaces.array(each, "SmoothnessEnergy")) for each in data]
        for figure in ("SolverUsed", "Lambda", "SmoothnessEnergy"):
            wanted, found = (Surfaces.array(each, figure)[k] for each, k in zip(data, order))
            if figure == "SolverUsed":
                check(sorted(found) == [MULTIGRID] + [DIRECT] * 7, name, found)
            else:
                check(np.allclose(found, wanted, rtol=1e-8), name, figure, wanted, found)


def row(parts, way):
    """Components beside each other, each in pieces: points, triangles, the process of each, and arrays."""
    points, triangles, owner, first = [], [], [], 0
    for k, (own, corners) in enumerate(parts):
        points.append(own * (1.0, 1.0 + 0.02 * k, 1.0) + (3.0 * k, 0.0, 0.0))
        triangles.append(corners + first)
        owner.append(Surfaces.owners(own, corners, way, count))
        first += len(own)
    points = np.concatenate(points)
    return points, np.concatenate(triangles), np.concatenate(owner), {
        "Wanted": points[:, [1, 2, 0]] + 0.3, "Few": (points[:, 1] > 0.9) * 1.5}


def compare_moved(parts, way, across):
    """Compares with one process; components are solved for as there, but for some that all processes solve for."""
    points, triangles, owner, arrays = row(parts, way)
    guided = {"Alignment": vtkDirectionField.ALIGN_POINT_VECTORS, "GuidanceVectors": "Wanted"}
    for options in ({}, {**guided, "GuidanceWeights": "Few", "ConstrainGuidance": 1, "ConstrainBoundary": 1},
                    {"Alignment": vtkDirectionField.ALIGN_PRINCIPAL_CURVATURE}):
        whole = make(vtkDirectionField, options, Surfaces.piece(points, triangles, arrays, owner * 0, 0))
        fields = [make(vtkPDirectionField, {**options, "Distribution": vtkPDirectionField.DISTRIBUTED},
                       Surfaces.piece(points, triangles, arrays, owner, rank)) for _ in range(1 if options else 2)]
        name = f"{len(parts)} components, {way} {options}"
        used = Surfaces.array(fields[0].GetOutput().GetFieldData(), "SolverUsed")
        check(len(used) == len(parts) and (used == MULTIGRID).sum() == across, name, used)
        if count > 1:
            check(Surfaces.array(fields[0].GetOutput().GetFieldData(), "Distribution").reshape(-1)[0] == 2, name)
        compare(whole, fields[0], 4, name)
        compare_singularities(whole, fields[0], name)
        # Whenever it is computed it is the same, to the last bit.
        first, last = (Surfaces.array(field.GetOutput().GetPointData(), "Direction0") for field in (fields[0], fields[-1]))
        check(np.array_equal(first, last), name)


def test_moved():
    """Components in pieces are moved to one process each, evenly, and solved for there: as on one process."""
    parts = [(Surfaces.half if k % 3 == 2 else Surfaces.potato)(5 + k % 2) for k in range(30)]
    compare_moved(parts, "random", 0)


def test_shares():
    """So are all that are no larger than a process's share, however few they are; a larger one is solved for by all."""
    small = [(Surfaces.half if k % 3 == 2 else Surfaces.potato)(size) for k, size in enumerate((9, 7, 13, 14, 10, 11))]
    for way in ("slabs", "random"):
        compare_moved([*small[:3], Surfaces.potato(25), *small[3:]], way, 1)
    # As large as the share, to the triangle.
    compare_moved([Surfaces.potato(8)] * count, "slabs", 0)


def chain():
    """Components that cannot be moved, each on few of the processes: those without common processes are solved for at once."""
    points, triangles, owner = [], [], []
    processes = [[k, k + 1] for k in range(count - 1)] + [[0, count - 1], list(range(count)), [count - 2, count - 1]]
    for k, members in enumerate(processes):
        # The first one is larger than a share, the others have only one side.
        own, corners = Surfaces.moebius(32 + 2 * k, 6) if k else Surfaces.potato(22)
        owner.append(np.array(members)[Surfaces.owners(own, corners, ("slabs", "random")[k % 2], len(members))])
        triangles.append(corners + sum(map(len, points)))
        points.append(own * (1.0, 1.0 + 0.1 * k, 1.0) + (3.0 * k, 0.0, 0.0))
    return np.concatenate(points), np.concatenate(triangles), np.concatenate(owner), len(processes)


def test_groups():
    points, triangles, owner, number = chain()
    arrays = {"Wanted": points[:, [1, 2, 0]] + 0.3, "Few": (points[:, 1] > 0.9) * 1.5}
    guided = {"Alignment": vtkDirectionField.ALIGN_POINT_VECTORS, "GuidanceVectors": "Wanted"}
    for options in ({}, {**guided, "GuidanceWeights": "Few", "ConstrainGuidance": 1, "ConstrainBoundary": 1}):
        whole = make(vtkDirectionField, options, Surfaces.piece(points, triangles, arrays, owner * 0, 0))
        part = make(vtkPDirectionField, {**options, "Distribution": vtkPDirectionField.DISTRIBUTED},
                    Surfaces.piece(points, triangles, arrays, owner, rank))
        name = f"groups {options}"
        compare(whole, part, 4, name)
        compare_singularities(whole, part, name)
        used = Surfaces.array(part.GetOutput().GetFieldData(), "SolverUsed")
        check(len(used) == number and (used == MULTIGRID).sum() == number, name, used)


def test_stop_while_waiting():
    """A process that waits for others, which solve for a component that it has no part of, can stop them."""
    points, triangles = Surfaces.pair(12)
    # The last one has a small component of its own.
    ball, more = Surfaces.potato(4, shift=9.0)
    owner = np.concatenate([Surfaces.owners(points, triangles, "random", count - 1), np.full(len(more), count - 1)])
    points, triangles = np.concatenate([points, ball]), np.concatenate([triangles, more + len(points)])
    field = vtkPDirectionField()
    field.SetDistribution(vtkPDirectionField.DISTRIBUTED)
    field.SetInputData(Surfaces.piece(points, triangles, {}, owner, rank))
    began = []

    def stop(source, event):
        began.append(source.GetProgress())
        if rank == count - 1 and source.GetProgress() > 0.5:
            source.SetAbortExecute(1)
        elif rank < count - 1:
            # Whoever works must still be at it when the message comes.
            time.sleep(0.01 if len(began) < 200 else 0.0)
    field.AddObserver("ProgressEvent", stop)
    field.Update()
    check(field.GetOutput().GetNumberOfPoints() == 0, "stopped by the one that waits", began)


def test_one_sided():
    """Components with one side that lie on one process each, and one that lies across all."""
    parts = [Surfaces.potato(9), Surfaces.moebius(40, 7), Surfaces.moebius(32, 6), Surfaces.moebius(36, 8)]
    points = np.concatenate([own * (1.0, 1.0 + 0.1 * k, 1.0) + (4.0 * k, 0.0, 0.0) for k, (own, _) in enumerate(parts)])
    first = np.cumsum([0] + [len(own) for own, _ in parts])
    triangles = np.concatenate([corners + first[k] for k, (_, corners) in enumerate(parts)])
    sizes = [len(corners) for _, corners in parts]
    owner = np.concatenate([np.full(sizes[0], count - 1), np.full(sizes[1], 0), np.full(sizes[2], count - 1),
                            np.arange(sizes[3]) % count])
    for options in ({}, {"ConstrainBoundary": 1}):
        whole = make(vtkDirectionField, options, Surfaces.piece(points, triangles, {}, owner * 0, 0))
        part = make(vtkPDirectionField, {**options, "Distribution": vtkPDirectionField.DISTRIBUTED},
                    Surfaces.piece(points, triangles, {}, owner, rank))
        name = f"one-sided {options}"
        data = [field.GetOutput().GetFieldData() for field in (whole, part)]
        check(Surfaces.array(data[1], "Distribution").reshape(-1)[0] == 2, name)
        compare(whole, part, 4, name)
        # Neither side is counted by itself.
        texts = [each.GetAbstractArray("Summary").GetValue(0) for each in data]
        given = [re.findall(r"([0-9,. ]+) points constrained", text) for text in texts]
        check(given[0] == given[1] and len(given[0]) == len(options), name, texts)


def test_faded():
    """Where a field fades away on a rough surface the user is told as on one process."""
    points, triangles = Surfaces.potato(24)
    edge = np.linalg.norm(points[triangles[:, 0]] - points[triangles[:, 1]], axis=1).mean()
    points = points + np.random.default_rng(1).uniform(-edge, edge, points.shape)
    owner = Surfaces.owners(points, triangles, "slabs", count)
    shares = []
    for kind, options, own in ((vtkDirectionField, {}, owner * 0),
                               (vtkPDirectionField, {"Distribution": vtkPDirectionField.DISTRIBUTED}, owner)):
        field = make(kind, {"Tolerance": 1e-6, **options},
                     Surfaces.piece(points, triangles, {}, own, 0 if kind is vtkDirectionField else rank))
        warnings = field.GetOutput().GetFieldData().GetAbstractArray("Warnings")
        texts = [warnings.GetValue(k) for k in range(warnings.GetNumberOfValues())] if warnings else []
        shares += [int(text.split(" faded at ")[1].split(" %")[0]) for text in texts if " faded at " in text]
    check(len(shares) == 2 and abs(shares[0] - shares[1]) < 10, "faded", shares)


def test_stop():
    """Whoever is stopped while it solves for components of its own stops all, and the next time all go on."""
    points, triangles, owner = many()
    for stopping in range(count):
        field = vtkPDirectionField()
        field.SetDistribution(vtkPDirectionField.DISTRIBUTED)
        field.SetInputData(Surfaces.piece(points, triangles, {}, owner, rank))
        heard = []
        field.AddObserver("ErrorEvent", lambda *_: heard.append(1))

        def stop(source, event):
            if rank == stopping and source.GetProgress() > 0.1:
                source.SetAbortExecute(1)
        field.AddObserver("ProgressEvent", stop)
        field.Update()
        check(field.GetOutput().GetNumberOfPoints() == 0 and not heard, "stopped by", stopping)
        field.RemoveAllObservers()
        field.SetAbortExecute(0)
        field.Modified()
        field.Update()
        check(total(field.GetOutput().GetNumberOfCells()) == len(triangles), "after a stop")


tests = (test_fields, test_moved, test_shares, test_groups, test_one_sided, test_faded, test_stop, test_stop_while_waiting)
chosen = sys.argv[2:]
for test in tests:
    if not chosen or test.__name__.removeprefix("test_") in chosen:
        test()
end()
