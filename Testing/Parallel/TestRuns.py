# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Glyphs, errors, stops and composite data over processes:
mpiexec -n 3 pvbatch --symmetric TestRuns.py PACKAGES distributed|gathered, what the build has"""
import sys
import time

sys.path.insert(0, sys.argv[1])

import numpy as np
from paraview import simple  # noqa: F401, starts MPI
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPolyData
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

import Surfaces
from Comparing import end
from directionfields_vtk import (vtkDirectionField, vtkDirectionFieldGlyphs, vtkPDirectionField,
                                 vtkPDirectionFieldGlyphs, vtkPGatheredSurface, vtkPStripePattern)

controller = vtkMultiProcessController.GetGlobalController()
rank, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
points, triangles = Surfaces.potato(14)
owner = Surfaces.owners(points, triangles, "slabs", count)


# Ways to solve for pieces that the build has.
WAYS = [vtkPDirectionField.GATHER] + [vtkPDirectionField.DISTRIBUTED] * (sys.argv[2] == "distributed")


def reduced(value, operation=vtkCommunicator.SUM_OP):
    own, result = vtkDoubleArray(), vtkDoubleArray()
    own.InsertNextValue(float(value))
    result.SetNumberOfTuples(1)
    controller.AllReduce(own, result, operation)
    return result.GetValue(0)


def check(condition, *what):
    """Fails on all processes, that none waits for another one."""
    failed = reduced(not condition)
    assert not failed, (rank, *what, "here" if not condition else "elsewhere")


def own_piece(**kind):
    return Surfaces.piece(points, triangles, {}, owner, rank, **kind)


def whole_mesh():
    return Surfaces.piece(points, triangles, {}, owner * 0, 0)


def messages_of(algorithm, event="ErrorEvent"):
    found = []

    def hear(source, event, message):
        found.append(message)
    hear.CallDataType = "string0"
    for source in (algorithm, algorithm.GetExecutive()):
        source.AddObserver(event, hear)
    return found


def test_glyphs():
    """The glyphs of all processes are as many and as dense as those of one, each on one process."""
    serial = vtkDirectionFieldGlyphs()
    field = vtkDirectionField()
    field.SetTolerance(1e-10)
    field.SetInputData(whole_mesh())
    serial.SetInputConnection(field.GetOutputPort())
    serial.SetMaximumNumberOfGlyphs(2000)
    serial.Update()
    for kind in ({}, {"ghosts": True}):
        part = vtkPDirectionField()
        part.SetTolerance(1e-10)
        part.SetInputData(own_piece(**kind))
        glyphs = vtkPDirectionFieldGlyphs()
        glyphs.SetInputConnection(part.GetOutputPort())
        glyphs.SetMaximumNumberOfGlyphs(2000)
        glyphs.Update()
        # The order of the points decides which samples are tried first: not the same places, but as many.
        wanted, found = found_number(serial), found_number(glyphs)
        check(abs(wanted / found - 1.0) < 0.05, "number of glyphs", wanted, found)
        wanted, found = found_spacing(serial), found_spacing(glyphs)
        check(abs(wanted / found - 1.0) < 0.05, "spacing", wanted, found)
        cells = glyphs.GetOutput().GetCellData()
        locations = Surfaces.array(cells, "Location").astype(int)
        here = np.zeros(int(found_number(glyphs)))
        here[np.unique(locations)] = 1
        everywhere = vtkDoubleArray()
        sent = vtkDoubleArray()
        for value in here:
            sent.InsertNextValue(value)
        everywhere.SetNumberOfTuples(len(here))
        controller.AllReduce(sent, everywhere, vtkCommunicator.SUM_OP)
        each = [everywhere.GetValue(i) for i in range(len(here))]
        check(all(value == 1 for value in each), "each glyph on one process")
        ids = Surfaces.array(cells, "PointId").astype(int)
        check((ids < part.GetOutput().GetNumberOfPoints()).all(), "ids of the piece")
        center = np.array([part.GetOutput().GetPoint(i) for i in ids]).reshape(-1, 3)
        box = np.array([glyphs.GetOutput().GetCell(i).GetBounds()
                        for i in range(glyphs.GetOutput().GetNumberOfCells())]).reshape(-1, 3, 2)
        distance = np.linalg.norm(box.mean(axis=2) - center, axis=1)
        check((distance < 2.0 * found_spacing(serial)).all(), "glyphs at their points", distance.max(initial=0.0))


def found_number(glyphs):
    return glyphs.GetOutput().GetFieldData().GetArray("NumberOfGlyphs").GetTuple1(0)


def found_spacing(glyphs):
    return glyphs.GetOutput().GetFieldData().GetArray("Spacing").GetTuple1(0)


def test_error():
    """What is wrong on one process is an error of all, in the same words, and the filter works again after."""
    for kind in (vtkPDirectionField, vtkPDirectionFieldGlyphs):
        mesh = own_piece()
        if rank == count - 1:
            mesh.GetPoints().SetPoint(3, float("nan"), 0.0, 0.0)
        filter = kind()
        heard = messages_of(filter)
        filter.SetInputData(mesh)
        filter.Update()
        text = "".join(heard)
        check("1 point of the surface has NaN or infinite coordinates, the first is point 3" in text and
              f"On process {count - 1}." in text, text)
        check(filter.GetOutput().GetNumberOfPoints() == 0, "outputs are empty")
    for way in WAYS:
        field = vtkPDirectionField()
        field.SetDistribution(way)
        field.SetInputData(mesh)
        heard = messages_of(field)
        field.Update()
        text = "".join(heard)
        check("the first is point 3" in text and f"On process {count - 1}." in text, way, text)
        field.SetInputData(own_piece())
        field.Update()
        check(field.GetOutput().GetPointData().HasArray("Direction0"), "after an error", way)
        # What only the process with the whole surface notices, or all of them.
        field.SetDegree(3)
        field.SetAlignment(vtkDirectionField.ALIGN_PRINCIPAL_CURVATURE)
        del heard[:]
        field.Update()
        check("Degree" in "".join(heard), way, heard)
        # An array that one process lacks.
        field = vtkPDirectionField()
        field.SetDistribution(way)
        field.SetAlignment(vtkDirectionField.ALIGN_POINT_VECTORS)
        field.SetGuidanceVectors("From" if rank == 0 else "Nothing")
        field.SetInputData(own_piece())
        heard = messages_of(field)
        field.Update()
        check(heard and reduced(field.GetOutput().GetNumberOfCells()) == 0, way, heard)


def test_stop():
    """Whoever is asked to stop stops all, wherever the work is done."""
    for stopping, way in ((stopping, way) for stopping in range(count) for way in WAYS):
        field = vtkPDirectionField()
        field.SetDistribution(way)
        field.SetInputData(own_piece())
        heard = messages_of(field)
        began = []

        def stop(source, event):
            began.append(time.time())
            if rank == stopping:
                source.SetAbortExecute(1)
        field.AddObserver("ProgressEvent", stop)
        # Whoever works must still be at it when the message comes.
        def wait(source, event):
            if len(began) < 40:
                time.sleep(0.01)
        field.AddObserver("ProgressEvent", wait)
        field.Update()
        check(field.GetOutput().GetNumberOfPoints() == 0, "stopped by", stopping, way)
        check(not heard, heard)
        field.RemoveAllObservers()
        field.SetAbortExecute(0)
        field.Modified()
        field.Update()
        check(field.GetOutput().GetPointData().HasArray("Direction0"), "after a stop", way)


def test_empty():
    """No process has anything, or points without cells only."""
    for mesh in (Surfaces.poly_data(np.zeros((0, 3)), np.zeros((0, 3))),
                 Surfaces.poly_data(points[:5 * rank], np.zeros((0, 3)))):
        field = vtkPDirectionField()
        field.SetDistribution(WAYS[-1])
        field.SetInputData(mesh)
        field.Update()
        check(field.GetOutput().GetNumberOfPoints() == mesh.GetNumberOfPoints(), "points")
        check(field.GetOutput().GetPointData().HasArray("Direction3"), "directions")
        check(field.GetOutput(1).GetPointData().HasArray("CellId"), "singularities")


def test_arrays():
    """Arrays that only one process has, without a name or of an earlier field, change nothing and stay as they are."""
    for way in WAYS:
        wanted = earlier = None
        for kind in ("no more", "unnamed", "earlier"):
            mesh = own_piece()
            more = numpy_to_vtk(np.arange(mesh.GetNumberOfPoints()) + 1000.0 * rank, deep=True)
            if kind == "unnamed" and rank != 1:
                mesh.GetPointData().AddArray(more)
            if kind == "earlier" and rank == 0:
                mesh = earlier
            field = vtkPDirectionField()
            field.SetDistribution(way)
            field.SetTolerance(1e-10)
            field.SetInputData(mesh)
            field.Update()
            output = field.GetOutput().GetPointData()
            found = [Surfaces.array(output, name)
                     for name in ("Direction1", "RepresentationMagnitude", "EnergyDensity")]
            wanted = wanted or found
            earlier = earlier or field.GetOutput()
            check(all(np.allclose(a, b, rtol=1e-5, atol=1e-5) for a, b in zip(found, wanted)), way, kind)
            kept = np.arange(mesh.GetNumberOfPoints()) + 1000.0 * rank
            check(not len(kept) or np.array_equal(Surfaces.vtk_to_numpy(more), kept), way, kind, "changed")


def test_field_data():
    """All processes have the same field data, whatever their numbers: here the lowest that there is."""
    for way in WAYS:
        mesh = own_piece()
        places = Surfaces.vtk_to_numpy(mesh.GetPoints().GetData())
        wanted = numpy_to_vtk(places[:, [1, 2, 0]].astype(float) + 0.3, deep=True)
        wanted.SetName("Wanted")
        mesh.GetPointData().AddArray(wanted)
        field = vtkPDirectionField()
        field.SetDistribution(way)
        field.SetAlignment(vtkDirectionField.ALIGN_POINT_VECTORS)
        field.SetGuidanceVectors("Wanted")
        field.SetAlignmentStrength(1.0)
        field.SetInputData(mesh)
        heard = messages_of(field)
        field.Update()
        check(not heard, way, heard)
        data = field.GetOutput().GetFieldData()
        check(Surfaces.array(data, "Lambda")[0] == -sys.float_info.max, way)
        figures = ("Eigenvalue", "Residual", "Energy")
        found = [Surfaces.array(data, name)[0] for name in figures if data.HasArray(name)]
        check(len(found) > 0 and reduced(sum(found)) == count * sum(found), way, found)


def test_composite():
    """Blocks at the same place are one surface, also where a process has none of it or fewer of them."""
    serial = vtkDirectionField()
    serial.SetInputData(whole_mesh())
    serial.Update()
    wanted = serial.GetOutput().GetFieldData().GetArray("Eigenvalue").GetTuple1(0)
    blocks = vtkMultiBlockDataSet()
    blocks.SetNumberOfBlocks(3)
    blocks.SetBlock(0, own_piece() if len(np.flatnonzero(owner == rank)) else None)
    if rank == 1:
        blocks.SetBlock(2, whole_mesh())
    blocks.GetMetaData(2).Set(vtkMultiBlockDataSet.NAME(), "second")
    partitions = vtkPartitionedDataSet()
    partitions.SetPartition(0, own_piece())
    if rank == 0:
        partitions.SetPartition(1, whole_mesh())
    for data, last in ((blocks, 2), (partitions, 1)):
        field = vtkPDirectionField()
        field.SetInputData(data)
        field.Update()
        output = field.GetOutputDataObject(0)
        check(output.GetClassName() == data.GetClassName(), output)
        block = output.GetBlock if data is blocks else output.GetPartitionAsDataObject
        check(abs(block(0).GetFieldData().GetArray("Eigenvalue").GetTuple1(0) / wanted - 1.0) < 1e-9, "first")
        alone = (rank == 1) if data is blocks else (rank == 0)
        other = block(last) if alone or data is blocks else None
        check((other is not None) == alone, "where the second one is")
        check(not alone or other.GetPointData().HasArray("Direction0"), "second")
        glyphs = vtkPDirectionFieldGlyphs()
        glyphs.SetInputConnection(field.GetOutputPort())
        glyphs.Update()
        check(glyphs.GetOutputDataObject(0).GetNumberOfCells() > 0, "glyphs")


class Failing(VTKPythonAlgorithmBase):
    """A source that fails on one process, in one of the passes of an update."""

    def __init__(self, failing_pass):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self.Pass = failing_pass

    def result(self, name):
        return 0 if self.Pass == name and rank == count - 1 else 1

    def RequestDataObject(self, request, inputs, outputs):
        if not vtkPolyData.GetData(outputs):
            outputs.GetInformationObject(0).Set(vtkPolyData.DATA_OBJECT(), vtkPolyData())
        return self.result("data object")

    def RequestInformation(self, request, inputs, outputs):
        return self.result("information")

    def RequestData(self, request, inputs, outputs):
        vtkPolyData.GetData(outputs).ShallowCopy(own_piece())
        return self.result("data")


def test_failure_upstream():
    """No process waits for one whose input has failed, and the next time all execute."""
    passes = ("data object", "information", "data")
    for kind, name in ((k, p) for k in (vtkPDirectionField, vtkPDirectionFieldGlyphs) for p in passes):
        source = Failing(name)
        field = vtkPDirectionField()
        field.SetInputConnection(source.GetOutputPort())
        filter = field
        if kind is vtkPDirectionFieldGlyphs:
            filter = kind()
            filter.SetInputConnection(field.GetOutputPort())
        heard = messages_of(filter)
        filter.Update()
        # Where there are two of our filters all processes have failed for the second one.
        check(f"has failed on process {0 if filter is not field else count - 1}" in "".join(heard), name, heard)
        check(len(heard) == 1, name, heard)
        source.Pass = None
        source.Modified()
        filter.Update()
        check(reduced(filter.GetOutput().GetNumberOfCells()) > 0, "after a failure")


def warned(limit, distribution):
    """The warnings of the field, those of all processes, and how it was computed."""
    field = vtkPDirectionField()
    heard = messages_of(field, "WarningEvent")
    field.SetGatherLimit(limit)
    field.SetDistribution(distribution)
    field.SetInputData(own_piece())
    field.Update()
    data = field.GetOutput().GetFieldData()
    warnings = data.GetAbstractArray("Warnings")
    return (warnings.GetValue(0) if warnings else "", reduced(len(heard)),
            Surfaces.array(data, "Distribution").reshape(-1)[0])


def test_limit():
    """Beyond the limit the surface is distributed; where that is not to be, one process warns."""
    automatic, gather = vtkPDirectionField.AUTOMATIC, vtkPDirectionField.GATHER
    check(warned(len(triangles), automatic) == ("", 0, 1), "at the limit")
    text, count, used = warned(len(triangles) - 1, gather)
    check("more than Gather Limit" in text and (count, used) == (1, 1), text, count, used)
    text, count, used = warned(len(triangles) - 1, automatic)
    if sys.argv[2] == "distributed":
        check((text, count, used) == ("", 0, 2), text, count, used)
        return
    check("libpetsc-complex-dev" in text and (count, used) == (1, 1), text, count, used)

    field = vtkPDirectionField()
    field.SetDistribution(vtkPDirectionField.DISTRIBUTED)
    field.SetInputData(own_piece())
    heard = messages_of(field)
    field.Update()
    check("libpetsc-complex-dev" in "".join(heard) and field.GetOutput().GetNumberOfCells() == 0, heard)


def test_limit_of_filters():
    """The filters after the field warn beyond the same limit, in the same words, on one process."""
    field = vtkPDirectionField()
    field.SetDegree(2)
    field.SetInputData(own_piece())
    for kind in (vtkPDirectionFieldGlyphs, vtkPStripePattern, vtkPGatheredSurface):
        for limit, wanted in ((len(triangles), 0), (len(triangles) - 1, 1), (-5, 1)):
            limited = kind()
            heard = messages_of(limited, "WarningEvent")
            limited.SetGatherLimit(limit)
            check(limited.GetGatherLimit() == max(limit, 0), "limit", limited.GetGatherLimit())
            limited.SetInputConnection(field.GetOutputPort())
            limited.Update()
            check(reduced(len(heard)) == wanted, kind.__name__, limit, heard)
            check(all("more than Gather Limit" in text for text in heard), heard)


def test_controllers():
    """Processes that have worked in another company before: first all but the last, then all, then each one but the first."""
    if len(WAYS) < 2:
        return
    points, triangles = Surfaces.potato(9)
    for first, last in ((0, count - 1), (0, count), (1, count)):
        isThere = first <= rank < last
        part = controller.PartitionController(1 if isThere else 0, rank)
        if isThere:
            owner = Surfaces.owners(points, triangles, "slabs", last - first)
            field = vtkPDirectionField()
            field.SetController(part)
            field.SetDistribution(vtkPDirectionField.DISTRIBUTED)
            field.SetInputData(Surfaces.piece(points, triangles, {}, owner, rank - first))
            heard = messages_of(field)
            field.Update()
            used = Surfaces.array(field.GetOutput().GetFieldData(), "Distribution").reshape(-1)
        check(not isThere or (not heard and used[0] == 2 and used[1] == last - first), first, last)


for test in (test_controllers, test_glyphs, test_error, test_stop, test_empty, test_arrays, test_field_data,
             test_composite, test_failure_upstream, test_limit, test_limit_of_filters):
    test()
end()
