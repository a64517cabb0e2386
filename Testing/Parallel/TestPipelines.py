# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ways in which ParaView itself comes to surfaces in pieces: mpiexec -n 2 pvbatch TestPipelines.py PACKAGES PLUGIN DIRECTORY

One script steers all processes, as for users, and compares with what VTK gives in one piece."""
import os
import sys

sys.path.insert(0, sys.argv[1])

from paraview import servermanager, simple
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

from directionfields_vtk import vtkDirectionField

plugin, directory = sys.argv[2:4]
simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
count = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


FIGURES = ("Eigenvalue", "EulerCharacteristic", "IndexSum")


def figures(source):
    """The ranges over the components, which may have another order; the same on all processes."""
    source.UpdatePipeline()
    information = source.GetFieldDataInformation()
    return [information.GetArray(name).GetRange(0) for name in FIGURES]


def check(field, wanted, what):
    """Compares with the figures of one process, and counts the singularities of all processes."""
    found = figures(field)
    assert found[1:] == wanted[1:], (what, found, wanted)
    for a, b in zip(found[0], wanted[0]):
        assert abs(a / b - 1.0) < 1e-5, (what, found, wanted)
    summary = servermanager.Fetch(field).GetFieldData().GetAbstractArray("Summary").GetValue(0)
    singularities = field.GetDataInformation(1).GetNumberOfPoints()
    assert summary.startswith(f"{singularities} singularities"), (what, singularities, summary)


def serial(algorithm):
    field = vtkDirectionField()
    field.SetInputConnection(algorithm.GetOutputPort())
    field.Update()
    data = field.GetOutput().GetFieldData()
    return [data.GetArray(name).GetRange(0) for name in FIGURES]


def whole_contour():
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-10, 10, -10, 10, -10, 10)
    contour = vtkFlyingEdges3D()
    contour.SetInputConnection(source.GetOutputPort())
    contour.SetValue(0, 170.0)
    return contour


def contour():
    return simple.Contour(Input=simple.Wavelet(), ContourBy=["POINTS", "RTData"], Isosurfaces=[170.0],
                          ComputeScalars=0)


def ellipsoid():
    source = simple.Transform(Input=simple.Sphere(ThetaResolution=40, PhiResolution=30))
    source.Transform.Scale = [1.0, 1.4, 0.7]
    return source


def whole_ellipsoid():
    source = vtkSphereSource()
    source.SetThetaResolution(40)
    source.SetPhiResolution(30)
    transform = vtkTransform()
    transform.Scale(1.0, 1.4, 0.7)
    whole = vtkTransformPolyDataFilter()
    whole.SetTransform(transform)
    whole.SetInputConnection(source.GetOutputPort())
    return whole


def check_file(field):
    """Points of several pieces have one row, as one process writes them."""
    whole = whole_ellipsoid()
    whole.Update()
    surface = whole.GetOutput()
    name = os.path.join(directory, "written%d" % count)
    for ending in ("rosy", "obj", "sharp"):
        if os.path.exists(f"{name}.{ending}"):
            os.remove(f"{name}.{ending}")
    simple.SaveData(name + ".rosy", field, FieldOn="Points")
    with open(name + ".obj") as mesh:
        lines = [line.split()[:1] for line in mesh]
    assert lines.count(["v"]) == surface.GetNumberOfPoints(), (lines.count(["v"]), surface.GetNumberOfPoints())
    assert lines.count(["f"]) == surface.GetNumberOfPolys(), (lines.count(["f"]), surface.GetNumberOfPolys())
    with open(name + ".rosy") as rows:
        assert rows.readline().split() == [str(surface.GetNumberOfPoints())], "rows"


def main():
    wanted = serial(whole_contour())
    surface = contour()
    check(simple.DirectionField(Input=surface, Diagnostics=1), wanted, "contour")
    # Binary: on Debian 12 what is appended reads back empty.
    name = os.path.join(directory, "contour%d.pvtp" % count)
    simple.SaveData(name, surface, DataMode="Binary")
    check(simple.DirectionField(Input=simple.OpenDataFile(name), Diagnostics=1), wanted, "file")

    wanted = serial(whole_ellipsoid())
    field = simple.DirectionField(Input=ellipsoid(), Diagnostics=1)
    check(field, wanted, "sources")
    check_file(field)
    parts = simple.RedistributeDataSet(Input=ellipsoid())
    check(simple.DirectionField(
        Input=simple.ExtractSurface(Input=parts), Diagnostics=1), wanted, "redistributed")

    glyphs = simple.DirectionFieldGlyphs(Input=field, Diagnostics=1)
    glyphs.UpdatePipeline()
    assert glyphs.GetFieldDataInformation().GetArray("NumberOfGlyphs").GetRange(0)[0] > 100
    mesh = simple.FieldAlignedRemesh(Input=field, NumberOfFaces=400)
    seams = simple.FeatureEdges(Input=mesh, FeatureEdges=0, NonManifoldEdges=0)
    seams.UpdatePipeline()
    assert seams.GetDataInformation().GetNumberOfCells() == 0, "the mesh has seams"


main()
# Open MPI 5 may lose what is still on its way when processes end.
print(f"passed on all {count} processes", flush=True)
