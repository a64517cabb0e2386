# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What gathering costs: PYTHONPATH=build/lib/python3/dist-packages mpiexec -n 2 pvbatch --symmetric gather.py [TRIANGLES [ROUNDS]]

A surface in slabs, beside the same surface in one process while the others wait. Prints seconds, the processors' time
of all processes, which is what counts on a busy machine, their ratios (medians of rounds in turns) and the most
memory that each process had."""
import os
import resource
import statistics
import sys
import time

import numpy as np
from paraview import simple  # noqa: F401, starts MPI
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Parallel"))
import Surfaces
from directionfields_vtk import vtkPDirectionField

triangles_wanted = int(sys.argv[1]) if len(sys.argv) > 1 else 400000
rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 3
controller = vtkMultiProcessController.GetGlobalController()
rank, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def memory():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2 ** 20


def processor_time():
    """Seconds of all processes together."""
    own, total = vtkDoubleArray(), vtkDoubleArray()
    own.InsertNextValue(time.process_time())
    total.SetNumberOfTuples(1)
    controller.AllReduce(own, total, vtkCommunicator.SUM_OP)
    return total.GetValue(0)


def seconds(mesh):
    """Of the clock and of the processors."""
    field = vtkPDirectionField()
    field.KeepStagesOff()
    field.SetInputData(mesh)
    controller.Barrier()
    began, worked = time.time(), processor_time()
    field.Update()
    controller.Barrier()
    return time.time() - began, processor_time() - worked


points, triangles = Surfaces.potato(int((triangles_wanted / 12) ** 0.5) + 1)
points = points.astype(np.float32)
owner = Surfaces.owners(points, triangles, "slabs", count)
empty = Surfaces.poly_data(np.zeros((0, 3), dtype=np.float32), np.zeros((0, 3)))
part = Surfaces.piece(points, triangles, {}, owner, rank)
whole = Surfaces.piece(points, triangles, {}, owner * 0, 0) if rank == 0 else empty
size = len(triangles)
del points, triangles, owner
before = memory()
one, several = [], []
for _ in range(rounds):
    several.append(seconds(part))
    one.append(seconds(whole))
ratios = [statistics.median(a[k] / b[k] for a, b in zip(several, one)) for k in range(2)]
for process in range(count):
    controller.Barrier()
    if process == rank:
        print(f"process {rank}: {before:.2f} GB with the surface, {memory():.2f} GB at most", flush=True)
controller.Barrier()
if rank == 0:
    (clock, work), (clock_of_one, work_of_one) = min(several), min(one)
    print(f"{size} triangles on {count} processes: {clock:.2f} s in pieces, {clock_of_one:.2f} s in one, "
          f"ratio {ratios[0]:.2f}; of the processors {work:.2f} s and {work_of_one:.2f} s, ratio {ratios[1]:.2f}",
          flush=True)
