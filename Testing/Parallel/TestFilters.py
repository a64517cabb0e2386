# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every filter gives for pieces what it gives for the whole surface: mpiexec -n 2 pvbatch --symmetric TestFilters.py PACKAGES [WAY...]

Every process executes the filters on the whole surface by itself, too, and compares. The whole surface is the gathered one, whose points
and cells are in the order of the pieces: lines and meshes depend on that order in their last digits."""
import os
import sys
import tempfile

sys.path.insert(0, sys.argv[1])

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFeatureEdges

import Surfaces
import directionfields_vtk
from Comparing import check, controller, count, end, rank, total

WAYS = ("slabs", "random", "one", "empty")


def whole_in_order(points, triangles, owner):
    """The triangles in the order of the pieces, and with global ids, the points in their own."""
    order = np.argsort(owner, kind="stable")
    whole = Surfaces.piece(points, triangles[order], arrays_of(points), np.zeros(len(triangles)), 0, ids=True)
    Surfaces.array(whole.GetCellData(), "From")[:] = order
    return whole


def arrays_of(points):
    return {"Spacing": 0.1 + 0.02 * points[:, 2] ** 2,
            "Wanted": np.stack([points[:, 1], -points[:, 0], 0.3 + points[:, 2]], axis=1)}


def run(name, options, *inputs):
    """A filter of directionfields_vtk by its name."""
    executed = getattr(directionfields_vtk, name)()
    for option, value in options.items():
        getattr(executed, "Set" + option)(value)
    for port, data in enumerate(inputs):
        executed.SetInputData(port, data)
    executed.Update()
    return executed


def field_of(kind, surface, **options):
    kept = vtkPolyData()
    kept.ShallowCopy(run(kind, {"Tolerance": 1e-10, **options}, surface).GetOutput())
    return kept


def sizes(executed):
    """For each output the numbers of points, polygons and lines on all processes."""
    found = []
    for port in range(executed.GetNumberOfOutputPorts()):
        data = executed.GetOutput(port)
        found.append([data.GetNumberOfPoints(), data.GetNumberOfPolys(), data.GetNumberOfLines()])
    return found


def summary(data):
    return data.GetFieldData().GetAbstractArray("Summary").GetValue(0)


def names(data):
    return sorted(data.GetArrayName(k) for k in range(data.GetNumberOfArrays()))


def compare_datasets(whole, part, name, ports):
    """Outputs that are datasets of their own: the same sizes, arrays, words, and place."""
    wanted, found = sizes(whole), [[total(n) for n in port] for port in sizes(part)]
    for port in ports:
        check(wanted[port] == found[port], name, port, wanted, found)
        one, other = whole.GetOutput(port), part.GetOutput(port)
        check(summary(one) == summary(other), name, summary(one), summary(other))
        for attributes in ("GetPointData", "GetCellData"):
            a, b = names(getattr(one, attributes)()), names(getattr(other, attributes)())
            check(set(a) == set(b), name, port, attributes, a, b)
        if other.GetNumberOfPoints() == one.GetNumberOfPoints() > 0:
            check(np.allclose(one.GetBounds(), other.GetBounds(), atol=1e-4), name, "bounds")
        else:
            check(True)


def compare_streamlines(whole, pieces, name):
    for seeds in (0, 1, 2):
        options = {"SeedType": seeds, "SeparatingDistance": 0.15}
        # Each process has a point of its own.
        places = np.array([[0.4, 0.9, 0.3], [0.1, -1.0, 0.4], [-0.8, 0.2, 0.3], [0.2, 0.3, -0.8]])
        all_seeds = Surfaces.poly_data(places[:min(count, 4)], np.zeros((0, 3)))
        own_seeds = Surfaces.poly_data(places[rank % 4:rank % 4 + 1], np.zeros((0, 3)))
        compare_datasets(run("vtkDirectionFieldStreamlines", options, whole, all_seeds),
                         run("vtkPDirectionFieldStreamlines", options, pieces, own_seeds), name, (0, 1))


def sorted_places(data):
    """The coordinates of all processes' points, each axis by itself and in order."""
    own, everywhere = vtkDoubleArray(), vtkDoubleArray()
    for value in (vtk_to_numpy(data.GetPoints().GetData()).reshape(-1) if data.GetNumberOfPoints() else ()):
        own.InsertNextValue(value)
    controller.AllGatherV(own, everywhere)
    return np.sort(vtk_to_numpy(everywhere).reshape(-1, 3), axis=0)


def compare_glyphs(whole, pieces, name):
    for options in ({"Spacing": 0.25}, {"Spacing": 0.4, "GlyphType": 2, "FollowSurface": 0}):
        one = run("vtkDirectionFieldGlyphs", options, whole)
        other = run("vtkPDirectionFieldGlyphs", options, pieces)
        compare_datasets(one, other, name, (0,))
        wanted = np.sort(vtk_to_numpy(one.GetOutput().GetPoints().GetData()).astype(float), axis=0)
        found = sorted_places(other.GetOutput())
        check(len(wanted) > 100 and np.allclose(found, wanted, atol=1e-4), name, "places")


def compare_cells(whole, pieces, name):
    """A field of its own, with directions of cells."""
    options = {"CellDirections": 1, "Tolerance": 1e-10, "Alignment": 2, "GuidanceVectors": "Wanted"}
    one = run("vtkDirectionField", options, whole)
    other = run("vtkPDirectionField", {**options, "Distribution": 1}, pieces)
    check("Direction3" in names(other.GetOutput().GetCellData()), name, names(other.GetOutput().GetCellData()))
    compare_surfaces(one, other, name)


def compare_stripes(whole, pieces, name):
    options = {"Spacing": 0.2, "Bands": 1}
    compare_datasets(run("vtkStripePattern", options, whole), run("vtkPStripePattern", options, pieces),
                     name, (0, 1, 2))


def compare_meshes(whole, pieces, name):
    options = {"NumberOfFaces": 300}
    part = run("vtkPFieldAlignedRemesh", options, pieces)
    compare_datasets(run("vtkFieldAlignedRemesh", options, whole), part, name, (0, 1))
    edges = vtkFeatureEdges()
    edges.SetInputData(part.GetOutput())
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    check(edges.GetOutput().GetNumberOfLines() == 0, name, "open edges")


def compare_surfaces(whole, part, name):
    """Outputs on the surface: the arrays of each process's piece are those of the whole surface at its points and cells."""
    one, other = whole.GetOutput(), part.GetOutput()
    check(summary(one) == summary(other), name, summary(one), summary(other))
    check(total(other.GetNumberOfPolys()) == one.GetNumberOfPolys(), name, "polygons")
    for attributes in ("GetPointData", "GetCellData"):
        a, b = getattr(one, attributes)(), getattr(other, attributes)()
        check(set(names(a)) == set(names(b)), name, attributes, names(a), names(b))
        came_from = Surfaces.array(a, "From").astype(int)
        place = np.empty(len(came_from), dtype=int)
        place[came_from] = np.arange(len(came_from))
        here = place[Surfaces.array(b, "From").astype(int)]
        for array in names(a):
            wanted = Surfaces.array(a, array)[here]
            if array != "GlobalIds" and len(here):
                # Where there is no curl it is NaN.
                found = Surfaces.array(b, array)
                check(np.allclose(found, wanted, rtol=1e-4, atol=2e-4, equal_nan=True), name, array)
            else:
                check(True)


def compare_guidance(whole, pieces, name):
    places = np.array([[-0.9, -0.4, 0.5], [0.0, 0.2, 0.9], [0.8, 0.7, 0.3]])
    curve = Surfaces.poly_data(places, np.zeros((0, 3)))
    lines = vtkCellArray()
    lines.InsertNextCell(3, [0, 1, 2])
    curve.SetLines(lines)
    # All processes have the same curve, which counts once.
    one = run("vtkGuidanceCurves", {}, whole, curve)
    other = run("vtkPGuidanceCurves", {}, pieces, curve)
    compare_surfaces(one, other, name)
    compare_datasets(one, other, name, (1,))


def compare_edits(whole, pieces, name):
    for options in ({}, {"Objective": 1}):
        one = run("vtkDirectionFieldSingularities", options, whole)
        other = run("vtkPDirectionFieldSingularities", options, pieces)
        compare_surfaces(one, other, name)
        compare_datasets(one, other, name, (1,))
    # Each process asks for a singularity of its own.
    places = np.array([[0.9, 0.3, 0.1], [-0.9, 0.2, 0.0], [0.1, 1.2, 0.1], [0.0, -1.2, 0.0]])[:count]
    asked = [Surfaces.poly_data(some, np.zeros((0, 3))) for some in (places, places[rank:rank + 1])]
    one = run("vtkDirectionFieldSingularities", {"SingularityMode": 1, "BalanceAutomatically": 1}, whole, asked[0])
    other = run("vtkPDirectionFieldSingularities", {"SingularityMode": 1, "BalanceAutomatically": 1}, pieces, asked[1])
    compare_surfaces(one, other, name)
    compare_datasets(one, other, name, (1,))


def compare_comparisons(whole, pieces, name):
    guided = {"Degree": 2, "Alignment": 2, "GuidanceVectors": "Wanted"}
    others = (field_of("vtkDirectionField", whole, **guided), field_of("vtkPDirectionField", pieces, **guided))
    one = run("vtkCompareDirectionFields", {"DivergenceAndCurl": 1}, whole, others[0])
    other = run("vtkPCompareDirectionFields", {"DivergenceAndCurl": 1}, pieces, others[1])
    compare_surfaces(one, other, name)
    compare_datasets(one, other, name, (1,))


def write(kind, directory, data):
    """The lines of the files that a writer leaves in a directory of this process."""
    os.mkdir(directory)
    writer = getattr(directionfields_vtk, kind)()
    writer.SetFileName(os.path.join(directory, "field.rosy"))
    writer.SetFieldOn(writer.POINTS)
    writer.SetInputData(data)
    writer.Write()
    check(writer.GetErrorCode() == 0, kind, writer.GetErrorCode())
    return {name: open(os.path.join(directory, name)).read().splitlines() for name in sorted(os.listdir(directory))}


def compare_files(whole, pieces, name):
    # Each process has the file of its own, which only the one that gathers reads and writes.
    with tempfile.TemporaryDirectory() as directory:
        wanted = write("vtkDirectionFieldWriter", os.path.join(directory, "whole"), whole)
        found = write("vtkPDirectionFieldWriter", os.path.join(directory, "pieces"), pieces)
        check(total(len(found)) == len(wanted) == 3, name, "files", list(found), list(wanted))
        check(not found or found == wanted, name, "files differ",
              [pair for key in found for pair in zip(found[key], wanted[key]) if pair[0] != pair[1]][:4])
        options = {"FileName": os.path.join(directory, "whole", "field.rosy"),
                   "FieldOn": directionfields_vtk.vtkDirectionFieldReader.POINTS}
        one = run("vtkDirectionFieldReader", options, whole)
        other = run("vtkPDirectionFieldReader", options, pieces)
        compare_surfaces(one, other, name)
        compare_datasets(one, other, name, (1,))


# With the degrees of the fields that they are given.
FILTERS = {"glyphs": (4, compare_glyphs), "cells": (4, compare_cells), "streamlines": (4, compare_streamlines),
           "stripes": (2, compare_stripes), "meshes": (4, compare_meshes), "guidance": (4, compare_guidance),
           "edits": (4, compare_edits), "comparisons": (2, compare_comparisons), "files": (4, compare_files)}


def main():
    points, triangles = Surfaces.potato(11)
    for way in sys.argv[2:] or WAYS:
        owner = Surfaces.owners(points, triangles, way, count)
        own = Surfaces.piece(points, triangles, arrays_of(points), owner, rank, ids=True)
        all_of_it = whole_in_order(points, triangles, owner)
        fields = {degree: (field_of("vtkDirectionField", all_of_it, Degree=degree),
                           field_of("vtkPDirectionField", own, Degree=degree)) for degree in (2, 4)}
        for name, (degree, compare) in FILTERS.items():
            compare(*fields[degree], f"{name}, {way}, process {rank} of {count}")


main()
end()
