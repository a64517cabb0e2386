# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Too little memory on one process is an error of all: mpiexec -n 2 pvbatch --symmetric TestMemory.py PACKAGES LIBRARY [WAYS]

The process has room for its piece, but not for what the distributed solver takes. With the library of failing
allocations, which LD_PRELOAD names, one allocation after another fails: as many of each field as WAYS says."""
import ctypes
import resource
import sys

sys.path.insert(0, sys.argv[1])

import numpy as np

import Surfaces
from Comparing import check, count, end, rank, total
from directionfields_vtk import vtkPDirectionField


def field_of(surface, options):
    """The filter of a surface in pieces, and a list of what will be wrong."""
    points, triangles = surface
    arrays = {"Wanted": points[:, [1, 2, 0]] + 0.3}
    field = vtkPDirectionField()
    field.SetDistribution(vtkPDirectionField.DISTRIBUTED)
    field.SetNumberOfThreads(1)
    for name, value in options.items():
        getattr(field, "Set" + name)(value)
    field.SetInputData(Surfaces.piece(points, triangles, arrays, Surfaces.owners(points, triangles, "slabs", count), rank))
    heard = []

    def hear(source, event, message):
        heard.append(message)
    hear.CallDataType = "string0"
    field.AddObserver("ErrorEvent", hear)
    return field, heard


def field_with(room, surface, options):
    """The field, and what was wrong, where the last process gets no more than some bytes."""
    field, heard = field_of(surface, options)
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


def test_room(surface, options, rooms):
    for room in rooms:
        field, text = field_with(room, surface, options)
        check(f"there is too little memory on process {count - 1}" in text, room, text)
        check(field.GetOutput().GetNumberOfCells() == 0, room)
    field, text = field_with(None, surface, options)
    check(not text and field.GetOutput().GetPointData().HasArray("Direction0"), "after the errors", text)


# Of the surface's arrays. Lists of processes and components always find room.
LEAST = 4096


def test_failures(surface, options, ways, library):
    """Lets allocations of the last process fail, each by itself: none ends the program or keeps the others waiting."""

    def run(number):
        field, heard = field_of(surface, options)
        if rank == count - 1:
            library.FailAllocation(ctypes.c_longlong(number), ctypes.c_longlong(LEAST))
        field.Update()
        counted = library.StopFailingAllocations()
        return field, "".join(heard), int(total(counted if rank == count - 1 else 0))

    counted = run(-1)[2]
    check(counted > 100, counted)
    errors = 0
    for k in range(ways):
        field, text, _ = run(k * counted // ways)
        is_short = "there is too little memory" in text
        errors += is_short
        check(is_short or not text, k, text)
        check((field.GetOutput().GetNumberOfCells() == 0) == is_short, k)
    check(2 * errors > ways, errors, ways, counted)


def two(size):
    """Two surfaces across processes, which are moved to one process each."""
    points, triangles = Surfaces.potato(size)
    return np.concatenate([points, points + (0.0, 4.0, 0.0)]), np.concatenate([triangles, triangles + len(points)])


test_room(Surfaces.potato(30), {}, (3 << 20, 4 << 20, 5 << 20))
curved = {"Alignment": vtkPDirectionField.ALIGN_PRINCIPAL_CURVATURE}
test_room(Surfaces.potato(40), curved, (1 << 20, 5 << 18, 3 << 19, 1 << 21, 3 << 20))
failing = ctypes.CDLL(sys.argv[2])
failing.StopFailingAllocations.restype = ctypes.c_longlong
if failing.HasFailingAllocations():
    most = int(sys.argv[3]) if len(sys.argv) > 3 else 40
    guided = {"Alignment": vtkPDirectionField.ALIGN_POINT_VECTORS, "GuidanceVectors": "Wanted"}
    test_failures(Surfaces.moebius(40, 8), {}, most, failing)
    test_failures(Surfaces.half(20), {**guided, "ConstrainBoundary": 1}, most, failing)
    test_failures(two(16), {}, most, failing)
    # The larger one is solved for by both processes, the other one is moved.
    test_failures(Surfaces.pair(16), {}, most, failing)
end()
