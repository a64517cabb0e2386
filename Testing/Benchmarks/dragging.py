# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a change of AlignmentStrength takes in ParaView while all is shown, part by part:

    pvpython Testing/Benchmarks/dragging.py PLUGIN [--triangles 70000] [--changes 20] [--most SECONDS]

A bumpy torus has a cross field aligned with its curvature, its singularities, and glyphs; nothing is
rendered. The first strength is not counted, as it prepares for the others. The median and the least of
the changes are printed: of the field, of its second output, of the glyphs, and of the three together;
and beside them what ParaView takes to look through all arrays for its panels, most of whose ranges
the filters have kept. With --most the program fails where the median of the three together is longer."""
import argparse
import statistics
import sys
import time

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def bumpy_torus(triangles):
    """A closed surface without symmetry, of two triangles for each of m by 2 m quads."""
    across = max(8, round((triangles / 4.0) ** 0.5))
    around = 2 * across
    i, j = numpy.meshgrid(numpy.arange(around), numpy.arange(across), indexing="ij")
    u, v = 2.0 * numpy.pi * i / around, 2.0 * numpy.pi * j / across
    tube = 0.4 + 0.05 * numpy.sin(5.0 * u + 1.0) * numpy.sin(3.0 * v) + 0.04 * numpy.cos(2.0 * u)
    radius = 1.0 + tube * numpy.cos(v)
    coordinates = numpy.stack(
        [radius * numpy.cos(u), radius * numpy.sin(u), tube * numpy.sin(v)], axis=-1)
    next_i, next_j = (i + 1) % around, (j + 1) % across
    a, b = i * across + j, next_i * across + j
    c, d = next_i * across + next_j, i * across + next_j
    corners = numpy.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)

    points = vtkPoints()
    points.SetData(numpy_to_vtk(coordinates.reshape(-1, 3).astype(numpy.float32), deep=True))
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(numpy.arange(0, corners.size + 1, 3, dtype=numpy.int64), deep=True),
        numpy_to_vtkIdTypeArray(corners.reshape(-1).astype(numpy.int64), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def timed(times, name, step):
    begin = time.perf_counter()
    step()
    times.setdefault(name, []).append(time.perf_counter() - begin)


def measure(mesh, changes):
    """For each part of a change the seconds that it took, each time."""
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(mesh)
    field = DirectionField(Input=source, Alignment="Principal Curvature", AlignmentStrength=0.5)
    singularities = OutputPort(field, 1)
    glyphs = DirectionFieldGlyphs(Input=field)
    times = {}
    for change in range(-1, changes):
        field.AlignmentStrength = 0.2 + 0.6 * (change + 1) / (changes + 1)
        timed(times, "field", lambda: field.UpdatePipeline())
        timed(times, "singularities", lambda: singularities.UpdatePipeline())
        timed(times, "glyphs", lambda: glyphs.UpdatePipeline())
        timed(times, "information", lambda: [
            proxy.GetDataInformation().GetNumberOfPoints()
            for proxy in (field, singularities, glyphs)])
    return {name: values[1:] for name, values in times.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("plugin")
    parser.add_argument("--triangles", type=int, default=70000)
    parser.add_argument("--changes", type=int, default=20)
    parser.add_argument("--most", type=float, help="seconds")
    options = parser.parse_args()
    LoadPlugin(options.plugin, remote=False, ns=globals())

    mesh = bumpy_torus(options.triangles)
    times = measure(mesh, options.changes)
    times["together"] = [
        sum(step) for step in zip(times["field"], times["singularities"], times["glyphs"])]
    print(f"{mesh.GetNumberOfCells()} triangles, {options.changes} changes of AlignmentStrength, "
          "milliseconds")
    print(f"{'':>14} {'median':>8} {'least':>8}")
    for name in ("field", "singularities", "glyphs", "together", "information"):
        values = [1e3 * value for value in times[name]]
        print(f"{name:>14} {statistics.median(values):8.1f} {min(values):8.1f}")
    whole = statistics.median(times["together"])
    if options.most is not None and whole > options.most:
        sys.exit(f"A change takes {whole:.3f} s, not {options.most} s.")


if __name__ == "__main__":
    main()
