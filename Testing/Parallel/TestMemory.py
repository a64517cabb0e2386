# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Too little memory on one process is an error of all: mpiexec -n 2 pvbatch --symmetric TestMemory.py PACKAGES

The process has room for its piece, but not for what the distributed solver takes."""
import resource
import sys

sys.path.insert(0, sys.argv[1])

import Surfaces
from Comparing import check, count, rank
from directionfields_vtk import vtkPDirectionField


def field_with(room):
    """The field, and what was wrong, where the last process gets no more than some bytes."""
    points, triangles = Surfaces.potato(30)
    field = vtkPDirectionField()
    field.SetDistribution(vtkPDirectionField.DISTRIBUTED)
    field.SetNumberOfThreads(1)
    field.SetInputData(Surfaces.piece(points, triangles, {}, Surfaces.owners(points, triangles, "slabs", count), rank))
    heard = []

    def hear(source, event, message):
        heard.append(message)
    hear.CallDataType = "string0"
    field.AddObserver("ErrorEvent", hear)
    limits = resource.getrlimit(resource.RLIMIT_AS)
    if room and rank == count - 1:
        with open("/proc/self/statm", encoding="ascii") as sizes:
            size = int(sizes.read().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (size + room, limits[1]))
    try:
        field.Update()
    finally:
        resource.setrlimit(resource.RLIMIT_AS, limits)
    return field, "".join(heard)


for room in (3 << 20, 4 << 20, 5 << 20):
    field, text = field_with(room)
    check(f"there is too little memory on process {count - 1}" in text, room, text)
    check(field.GetOutput().GetNumberOfCells() == 0, room)
field, text = field_with(None)
check(not text and field.GetOutput().GetPointData().HasArray("Direction0"), "after the errors", text)
if rank == 0:
    # Open MPI 5 may lose what is still on its way when processes end.
    print("passed", flush=True)
