# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a field costs that is not gathered: PYTHONPATH=build/lib/python3/dist-packages mpiexec -n 2 pvbatch --symmetric distributed.py [TRIANGLES [COMPONENTS]]

A surface in slabs, or several COMPONENTS beside each other, each of them in slabs. Prints the V-cycles, and for each process its
processor time and the most memory that it took beyond its piece, by the triangle of its own; one process alone solves as ever. With
PETSC_OPTIONS=-log_view PETSc adds its tables, the messages of all V-cycles among them."""
import ctypes.util
import os
import sys
import time

import numpy as np
from paraview import simple  # noqa: F401, starts MPI
from vtkmodules.vtkParallelCore import vtkMultiProcessController

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Parallel"))
import Surfaces
from directionfields_vtk import vtkPDirectionField


def status(what):
    """A line of the system's figures of this process, in bytes."""
    with open("/proc/self/status") as lines:
        return next(1024 * int(line.split()[1]) for line in lines if line.startswith(what))


controller = vtkMultiProcessController.GetGlobalController()
rank, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
wanted, parts = (int(sys.argv[k]) if len(sys.argv) > k else default for k, default in ((1, 400000), (2, 1)))
points, triangles = Surfaces.potato(int((wanted / parts / 12) ** 0.5) + 1)
owner = np.tile(Surfaces.owners(points, triangles, "slabs", count), parts)
points, triangles = (np.concatenate([points * (1.0, 1.0 + 0.1 * k, 1.0) + (0.0, 0.0, 4.0 * k) for k in range(parts)]),
                     np.concatenate([triangles + k * len(points) for k in range(parts)]))
size = len(triangles)
piece = Surfaces.piece(points, triangles, {}, owner, rank)
del points, triangles, owner
# From here on the peak counts.
with open("/proc/self/clear_refs", "w") as reset:
    reset.write("5")
before = status("VmRSS")
field = vtkPDirectionField()
field.KeepStagesOff()
field.SetNumberOfThreads(1)
field.SetDistribution(vtkPDirectionField.DISTRIBUTED)
field.SetInputData(piece)
began = time.process_time()
field.Update()
worked = time.process_time() - began
taken = status("VmHWM") - before
data = field.GetOutput().GetFieldData()
for process in range(count):
    controller.Barrier()
    if process == rank:
        own = piece.GetNumberOfPolys()
        print(f"process {rank} of {count}: {own} of {size} triangles, {data.GetArray('Iterations').GetValue(0)} cycles, "
              f"{worked:.1f} s, {taken / 1e6:.0f} MB, {taken / own:.0f} bytes a triangle", flush=True)
controller.Barrier()
if os.environ.get("PETSC_OPTIONS") and count > 1:
    # PETSc writes its log when it ends.
    ctypes.CDLL(next(line.split()[-1] for line in open("/proc/self/maps") if "petsc" in line)).PetscFinalize()
