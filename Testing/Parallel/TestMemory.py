# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Too little memory on one process is an error of all: mpiexec -n 2 pvbatch --symmetric TestMemory.py PACKAGES

The process has room for its piece, but not for what the distributed solver takes."""
import resource
import sys

sys.path.insert(0, sys.argv[1])

import Surfaces
from Comparing import check, count, end, rank
from directionfields_vtk import vtkPDirectionField


def field_with(room, points, triangles):
    """The field, and what was wrong, where the last process gets no more than some bytes."""
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


def test(surface, rooms):
    short = 0
    for room in rooms:
        field, text = field_with(room, *surface)
        is_short = f"there is too little memory on process {count - 1}" in text
        short += is_short
        check(is_short or not text, room, text)
        check((field.GetOutput().GetNumberOfCells() == 0) == is_short, room)
    field, text = field_with(None, *surface)
    check(not text and field.GetOutput().GetPointData().HasArray("Direction0"), "after the errors", text)
    return short


check(test(Surfaces.potato(30), (3 << 20, 4 << 20, 5 << 20)) == 3, "none was short")
# Each of these ends in another step on the way to the cover of a surface with one side.
rooms = range(1 << 20, 12 << 20, 1 << 20)
check(3 < test(Surfaces.moebius(150, 30), rooms) <= len(rooms), "few were short")
end()
