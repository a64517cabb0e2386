# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What gathering costs: PYTHONPATH=build/lib/python3/dist-packages mpiexec -n 2 pvbatch --symmetric gather.py [TRIANGLES [ROUNDS]]

A surface in slabs, beside the same surface in one process while the others wait. Prints seconds, their ratio (the
median of rounds in turns) and the most memory that each process had."""
import os
import resource
import statistics
import sys
import time

import numpy as np
from paraview import simple  # noqa: F401, starts MPI
from vtkmodules.vtkParallelCore import vtkMultiProcessController

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Parallel"))
import Surfaces
from directionfields_vtk import vtkPDirectionField

triangles_wanted = int(sys.argv[1]) if len(sys.argv) > 1 else 400000
rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 3
controller = vtkMultiProcessController.GetGlobalController()
rank, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()


def memory():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2 ** 20


def seconds(mesh):
    field = vtkPDirectionField()
    field.KeepStagesOff()
    field.SetInputData(mesh)
    controller.Barrier()
    began = time.time()
    field.Update()
    controller.Barrier()
    return time.time() - began


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
ratio = statistics.median(a / b for a, b in zip(several, one))
for process in range(count):
    controller.Barrier()
    if process == rank:
        print(f"process {rank}: {before:.2f} GB with the surface, {memory():.2f} GB at most", flush=True)
controller.Barrier()
if rank == 0:
    print(f"{size} triangles on {count} processes: {min(several):.2f} s in pieces, {min(one):.2f} s in one; "
          f"ratio {ratio:.2f}", flush=True)
