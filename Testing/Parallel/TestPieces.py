# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The field of a surface in pieces is that of the whole: mpiexec -n 3 pvbatch --symmetric TestPieces.py PACKAGES [distributed] [SURFACE...]

Every process computes the field of the whole surface by itself, too, and compares its own piece with it. With distributed none has more than its piece, but of what can
only be gathered."""
import sys

sys.path.insert(0, sys.argv[1])

import numpy as np
from paraview import simple  # noqa: F401, starts MPI
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

import Surfaces
from directionfields_vtk import vtkDirectionField, vtkPDirectionField

controller = vtkMultiProcessController.GetGlobalController()
rank, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def total(value):
    """The sum over all processes."""
    from vtkmodules.vtkCommonCore import vtkDoubleArray
    own, sums = vtkDoubleArray(), vtkDoubleArray()
    own.InsertNextValue(float(value))
    sums.SetNumberOfTuples(1)
    controller.AllReduce(own, sums, vtkCommunicator.SUM_OP)
    return sums.GetValue(0)


def make(kind, options, mesh):
    field = kind()
    field.SetTolerance(1e-10)
    for name, value in options.items():
        getattr(field, "Set" + name)(value)
    field.SetInputData(mesh)
    field.Update()
    return field


def check(condition, *what):
    """Fails on all processes, that none waits for another one."""
    failed = total(not condition)
    assert not failed, (rank, *what, "here" if not condition else "elsewhere")


def directions(data, degree):
    return np.stack([Surfaces.array(data, f"Direction{k}").reshape(-1, 3) for k in range(degree)], axis=1)


def corners(mesh):
    """The points of the triangles."""
    ids = mesh.GetPolys().GetConnectivityArray()
    return vtk_to_numpy(ids).reshape(-1, 3) if ids.GetNumberOfTuples() else np.zeros((0, 3), dtype=int)


def compare(whole, part, degree, name):
    mesh, piece = whole.GetOutput(), part.GetOutput()
    fields = [field.GetOutput().GetFieldData() for field in (whole, part)]
    wanted, found = (np.sort(Surfaces.array(data, "Eigenvalue")) for data in fields)
    check(np.allclose(found, wanted, rtol=1e-9, atol=1e-12), name, "eigenvalue", wanted, found)
    repairs = [Surfaces.array(data, "Repairs").tolist() for data in fields]
    check(repairs[0] == repairs[1], name, "repairs", repairs)
    for sums in ("IndexSum", "EulerCharacteristic"):
        wanted, found = (sorted(Surfaces.array(data, sums)) for data in fields)
        check(wanted == found, name, sums, wanted, found)

    points = Surfaces.array(piece.GetPointData(), "From").astype(int)
    cells = Surfaces.array(piece.GetCellData(), "From").astype(int)
    index = Surfaces.array(mesh.GetCellData(), "SingularityIndex")[cells]
    own = Surfaces.array(piece.GetCellData(), "SingularityIndex")
    check(np.array_equal(index, own), name, "index", np.flatnonzero(index != own))

    # Corner by corner: where sheets were torn apart, points have several directions. Copied cells keep theirs.
    ghosts = piece.GetCellData().GetArray("vtkGhostType")
    is_own = Surfaces.array(piece.GetCellData(), "vtkGhostType") == 0 if ghosts else slice(None)
    is_split = mesh.GetPointData().HasArray("OriginalPointIds")
    chosen = is_own if is_split else slice(None)
    wanted = corners(mesh)[cells][chosen].reshape(-1)
    found = corners(piece)[chosen].reshape(-1)
    worst = 0.0
    if len(found):
        magnitude = Surfaces.array(mesh.GetPointData(), "RepresentationMagnitude")[wanted]
        there = directions(mesh.GetPointData(), degree)[wanted]
        here = directions(piece.GetPointData(), degree)[found]
        # Which of the directions is the first one may differ where two are as near to the axis.
        sine = np.linalg.norm(np.cross(here[:, :1], there), axis=2)
        cosine = (here[:, :1] * there).sum(axis=2)
        angle = np.arctan2(sine, cosine).min(axis=1)
        worst = angle[magnitude > 0.05].max(initial=0.0)
    check(worst < 1e-6, name, "angle", worst)

    # All processes send what they have of each point; the largest and the smallest must be the same bits.
    if is_split:
        return
    here = directions(piece.GetPointData(), degree)
    several = []
    for operation, nothing in ((vtkCommunicator.MAX_OP, -9.0), (vtkCommunicator.MIN_OP, 9.0)):
        values = np.full((mesh.GetNumberOfPoints(), 3 * degree), nothing)
        if len(points):
            values[points] = here.reshape(len(points), -1)
        sent, received = (numpy_to_vtk(values.copy(), deep=True) for _ in range(2))
        controller.AllReduce(sent, received, operation)
        several.append(vtk_to_numpy(received))
    check(np.array_equal(*several), name, "shared points")


def compare_singularities(whole, part, name):
    wanted, found = whole.GetOutput(1), part.GetOutput(1)
    check(total(found.GetNumberOfPoints()) == wanted.GetNumberOfPoints(), name, "singularities")
    cells = Surfaces.array(part.GetOutput().GetCellData(), "From").astype(int)
    here = cells[Surfaces.array(found.GetPointData(), "CellId").astype(int)]
    ids = Surfaces.array(wanted.GetPointData(), "CellId").astype(int).tolist()
    check(set(here) <= set(ids) and len(set(here)) == len(here), name, "cells of singularities")
    sizes = dict(zip(ids, Surfaces.array(wanted.GetPointData(), "Size")))
    own = Surfaces.array(found.GetPointData(), "Size")
    check(all(abs(sizes[c] / s - 1.0) < 1e-5 for c, s in zip(here, own)), name, "sizes")


SURFACES = {"closed": Surfaces.potato(15), "bounded": Surfaces.half(15), "pair": Surfaces.pair(11),
            "strip": Surfaces.moebius(),
            "turned": Surfaces.turned(11), "sheets": Surfaces.sheets()}
WAYS = {"slabs": {}, "random": {}, "ids": {}, "one": {}, "empty": {},
        "slabs with ghosts": {"ghosts": True}, "random with ghosts": {"ghosts": True, "noise": 3e-8},
        "slabs with ids": {"ids": True, "noise": 3e-8}, "ids with ghosts": {"ghosts": True, "ids": True},
        "slabs with noise": {"noise": 1e-7}}
GUIDED = {"Alignment": vtkDirectionField.ALIGN_POINT_VECTORS, "GuidanceVectors": "Wanted",
          "GuidanceWeights": "Weight"}
FIELDS = {"smoothest": {}, "aligned": {"Alignment": vtkDirectionField.ALIGN_PRINCIPAL_CURVATURE},
          "guided": GUIDED, "constrained": {"ConstrainBoundary": 1, "ConstrainSharpEdges": 1},
          "faces": {"CellDirections": 1, "UnitLength": 1}, "merged": {"MergePoints": 1},
          "boundary": {"ConstrainBoundary": 1},
          "given": {**GUIDED, "GuidanceWeights": "Few", "ConstrainGuidance": 1},
          "bounded by": {**GUIDED, "ConstrainBoundary": 1, "AlignmentStrength": 0.8},
          "unmerged": {"MergePoints": 0}, "multigrid": {"Solver": 1, "Tolerance": 1e-10}}


# What can be had without gathering.
DISTRIBUTED_SURFACES = ("closed", "bounded", "pair", "turned")
DISTRIBUTED_FIELDS = ("smoothest", "guided", "given", "unmerged", "multigrid")
DISTRIBUTED_WITH_BOUNDARY = ("boundary", "bounded by")


def run(surface, way, field, distribute):
    points, triangles = SURFACES[surface]
    options = dict(FIELDS[field])
    kind = WAYS[way]
    name = f"{surface}, {way}, {field}, process {rank} of {count}"
    vectors = np.stack([points[:, 1], -points[:, 0], 0.3 + points[:, 2] ** 2], axis=1)
    arrays = {"Wanted": vectors, "Weight": 1.0 + points[:, 2] ** 2,
              "Few": (points[:, 1] > 0.6) * 1.5}
    owner = Surfaces.owners(points, triangles, way.split()[0], count)
    mesh = Surfaces.piece(points, triangles, arrays, owner * 0, 0)
    whole = make(vtkDirectionField, options, mesh)
    options["Distribution"] = (vtkPDirectionField.GATHER, vtkPDirectionField.DISTRIBUTED)[distribute]
    part = make(vtkPDirectionField, options, Surfaces.piece(points, triangles, arrays, owner, rank, **kind))
    if "noise" not in kind:
        # Moved points have another field, but as many of them are shared.
        compare(whole, part, 4, name)
        compare_singularities(whole, part, name)
    done = Surfaces.array(part.GetOutput().GetFieldData(), "Distribution").reshape(-1)
    pieces = len(np.unique(owner))
    if pieces == 1:
        check(done[0] == 0, name, done)
        return
    shared = np.zeros((count, len(points)), dtype=bool)
    for process in range(count):
        shared[process, triangles[owner == process].reshape(-1)] = True
    is_possible = (surface in DISTRIBUTED_SURFACES and field in DISTRIBUTED_FIELDS or
                   surface == "bounded" and field in DISTRIBUTED_WITH_BOUNDARY)
    used = 2 if distribute and is_possible else 1
    warnings = part.GetOutput().GetFieldData().GetAbstractArray("Warnings")
    texts = [warnings.GetValue(k) for k in range(warnings.GetNumberOfValues())] if warnings else []
    reasons = sum("gathered on one process, for " in text for text in texts)
    check(reasons == (1 if distribute and not is_possible else 0), name, texts)
    check(done.tolist() == [used, pieces, int((shared.sum(axis=0) > 1).sum())], name, done)


def main():
    distribute = "distributed" in sys.argv[2:]
    for surface in [name for name in sys.argv[2:] if name != "distributed"] or SURFACES:
        for way in WAYS:
            run(surface, way, "smoothest", distribute)
        for k, field in enumerate(FIELDS):
            run(surface, ("random", "slabs with ghosts")[k % 2], field, distribute)
        # A process without any of the surface takes part in what its guidance needs.
        for field in ("guided", "given", "boundary"):
            run(surface, "empty", field, distribute)


main()
if rank == 0:
    # Open MPI 5 may lose what is still on its way when processes end.
    print("passed", flush=True)
