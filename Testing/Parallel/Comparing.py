# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the field of pieces with that of the whole surface, which every process has, too."""
import os
import sys
import traceback

import numpy as np
from paraview import simple  # noqa: F401, starts MPI
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

import Surfaces

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


def end():
    """Says that all processes have come to the end of their script, which is what ctest looks for."""
    reached = total(1)
    if rank == 0:
        # Open MPI 5 may lose what is still on its way when processes end.
        print(f"passed on all {reached:.0f} processes", flush=True)


def end_all(kind, error, where):
    """An error of one process ends all, which would wait for it."""
    traceback.print_exception(kind, error, where)
    sys.stderr.flush()
    os._exit(1)


sys.excepthook = end_all


def make(kind, options, mesh):
    field = kind()
    field.SetTolerance(1e-10)
    for name, value in options.items():
        getattr(field, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
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

    for curvature in ("MeanCurvature", "GaussianCurvature"):
        if mesh.GetPointData().HasArray(curvature) and len(found):
            values = Surfaces.array(mesh.GetPointData(), curvature)
            off = np.abs(Surfaces.array(piece.GetPointData(), curvature)[found] - values[wanted]).max()
            worst = max(worst, off / np.abs(values).max())
    check(worst < 1e-6, name, "curvature", worst)

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
