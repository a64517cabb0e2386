# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The remesher in ParaView's Python: TestRemesh.py PLUGIN PRINT_PROPERTIES MESH

PRINT_PROPERTIES is the program that prints the defaults and ranges of the C++ filter."""
import json
import subprocess
import sys

from paraview import servermanager
from paraview.simple import *

LoadPlugin(sys.argv[1], remote=False, ns=globals())

ENUMERATIONS = {
    "Element": ["Quads", "Triangles"],
    "SizeMode": ["Number Of Faces", "Edge Length"],
}
ADVANCED = ("SizingArray", "SmoothingIterations", "KeepStages", "NumberOfThreads")
UNLIMITED = 1e299


def number(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    remesh = FieldAlignedRemesh(Input=Sphere())
    expected = json.loads(subprocess.check_output([sys.argv[2]], text=True))
    properties = [name for name in remesh.ListProperties() if name != "Input"]
    assert sorted(properties) == sorted(expected), properties
    for name, figures in expected.items():
        proxy = remesh.SMProxy.GetProperty(name)
        assert proxy.GetElement(0) == figures["default"], (name, proxy.GetElement(0))
        if name in ENUMERATIONS:
            domain = proxy.GetDomain("enum")
            entries = [domain.GetEntryText(i) for i in range(domain.GetNumberOfEntries())]
            assert entries == ENUMERATIONS[name], entries
        elif "min" in figures:
            domain = proxy.GetDomain("range")
            assert domain.GetMinimumExists(0) and domain.GetMinimum(0) == figures["min"], name
            assert bool(domain.GetMaximumExists(0)) == (figures["max"] < UNLIMITED), name
        assert proxy.GetPanelVisibility() == (
            "advanced" if name in ADVANCED else "default"), name
    for name in ["Input"] + properties:
        documentation = remesh.SMProxy.GetProperty(name).GetDocumentation()
        assert documentation and documentation.GetDescription().strip(), name


def test_scan():
    """Apply alone gives a mesh of quads; the irregular vertices are the second output."""
    remesh = FieldAlignedRemesh(Input=OpenDataFile(sys.argv[3]), NumberOfFaces=2000)
    mesh = servermanager.Fetch(remesh)
    assert abs(mesh.GetNumberOfCells() - 2000) < 200, mesh.GetNumberOfCells()
    assert number(mesh, "Quads") > 0.97 * mesh.GetNumberOfCells()
    euler = mesh.GetFieldData().GetArray("EulerCharacteristic")
    assert euler.GetComponent(0, 0) == euler.GetComponent(0, 1)
    irregular = servermanager.Fetch(remesh, idx=1)
    assert irregular.GetNumberOfPoints() == number(mesh, "IrregularVertices")
    valence = irregular.GetPointData().GetArray("Valence")
    assert all(valence.GetTuple1(i) != 4 for i in range(irregular.GetNumberOfPoints()))


def test_field():
    """The field of Direction Field is followed, and its degree has to be that of the mesh."""
    plane = Plane(XResolution=10, YResolution=10)
    # Along the diagonals.
    diagonal = Calculator(Input=plane, Function="iHat+jHat", ResultArrayName="Diagonal")
    field = DirectionField(Input=diagonal, Degree=4, Alignment="Point Vectors",
                           GuidanceVectors="Diagonal", AlignmentStrength=1)
    mesh = servermanager.Fetch(FieldAlignedRemesh(Input=field, NumberOfFaces=200))
    assert mesh.GetPointData().GetArray("Diagonal") is not None
    assert mesh.GetPointData().GetArray("Direction0") is None
    along = servermanager.Fetch(FieldAlignedRemesh(Input=plane, NumberOfFaces=196))
    assert number(along, "Triangles") == 0 and number(along, "IrregularVertices") == 0


def test_options():
    """Pure quads, triangles, edge length, sizing."""
    sphere = Sphere(ThetaResolution=40, PhiResolution=30)
    remesh = FieldAlignedRemesh(Input=sphere, NumberOfFaces=800, PureQuads=1)
    mesh = servermanager.Fetch(remesh)
    assert number(mesh, "Triangles") == 0
    remesh.Element = "Triangles"
    mesh = servermanager.Fetch(remesh)
    assert number(mesh, "Quads") == 0
    remesh.SizeMode = "Edge Length"
    remesh.EdgeLength = 0.1
    mesh = servermanager.Fetch(remesh)
    assert abs(number(mesh, "EdgeLength") - 0.1) < 1e-12
    sized = Calculator(Input=sphere, Function="1+coordsZ", ResultArrayName="Size")
    remesh = FieldAlignedRemesh(Input=sized, NumberOfFaces=1000, SizingArray="Size")
    mesh = servermanager.Fetch(remesh)
    below = sum(mesh.GetPoint(i)[2] < 0 for i in range(mesh.GetNumberOfPoints()))
    assert below > 0.55 * mesh.GetNumberOfPoints(), below


test_properties()
test_scan()
test_field()
test_options()
print("passed")
