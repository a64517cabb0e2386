# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The remesher in ParaView's Python: TestRemesh.py PLUGIN PRINT_PROPERTIES MESH

PRINT_PROPERTIES is the program that prints the defaults and ranges of the C++ filters."""
import sys

from paraview import servermanager
from paraview.simple import *

import AllFigures
from Properties import check_properties, printed

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()

ENUMERATIONS = {
    "Element": ["Quads", "Triangles"],
    "SizeMode": ["Number Of Faces", "Edge Length", "Lengths At Points"],
    "SizeSource": ["Sizing Array", "Curvature", "Second Derivatives"],
    "BoundarySpacing": ["Free", "Even", "Keep"],
    "Alignment": ["Shape", "Smooth"],
}
ADVANCED = ("GatherLimit", "Gradation", "AddIrregularPairs", "KeepSoftFeatures", "AlignmentStrength", "SingularityCost",
            "SmoothingIterations", "MinimumScaledJacobian", "MaximumAspectRatio", "MaximumWarpage", "ConservedArray", "KeepStages", "NumberOfThreads")


def number(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    remesh = FieldAlignedRemesh(Input=Sphere())
    [expected] = printed(sys.argv[2], "FieldAlignedRemesh")
    check_properties(remesh, expected, ENUMERATIONS, ADVANCED, others=("Input", "KeptCurves"))
    # ParaView's window looks for the input under the first name in the alphabet.
    inputs = [name for name in remesh.ListProperties()
              if remesh.GetProperty(name).SMProperty.IsA("vtkSMInputProperty")]
    assert sorted(inputs) == ["Input", "KeptCurves"], inputs


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
    sphere = Sphere(ThetaResolution=20, PhiResolution=20)
    diagonal = Calculator(Input=sphere, Function="iHat+jHat", ResultArrayName="Diagonal")
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
    sized = Calculator(Input=Plane(XResolution=40, YResolution=40), Function="2+coordsX",
                       ResultArrayName="Size")
    remesh = FieldAlignedRemesh(Input=sized, NumberOfFaces=1000, SizingArray="Size")
    mesh = servermanager.Fetch(remesh)
    below = sum(mesh.GetPoint(i)[0] < 0 for i in range(mesh.GetNumberOfPoints()))
    assert below > 0.54 * mesh.GetNumberOfPoints(), below / mesh.GetNumberOfPoints()
    # The same as lengths.
    sized = Calculator(Input=Plane(XResolution=40, YResolution=40), Function="0.02*(2+coordsX)",
                       ResultArrayName="Size")
    remesh = FieldAlignedRemesh(Input=sized, SizeMode="Lengths At Points", SizingArray="Size", Gradation=1.3)
    mesh = servermanager.Fetch(remesh)
    assert 500 < mesh.GetNumberOfCells() < 800, mesh.GetNumberOfCells()
    assert number(mesh, "EdgesAsWanted") > 0.9
    assert "% of edges within 25 %" in mesh.GetFieldData().GetAbstractArray("Summary").GetValue(0)


def test_boundary():
    """A boundary is kept to the point, or evenly spaced, and the summary says so."""
    disk = Disk(InnerRadius=0.3, OuterRadius=1.0, RadialResolution=12, CircumferentialResolution=64)
    remesh = FieldAlignedRemesh(Input=disk, NumberOfFaces=900, BoundarySpacing="Keep", PureQuads=1)
    mesh = servermanager.Fetch(remesh)
    assert number(mesh, "BoundaryPoints") == 128 == number(mesh, "BoundaryPointsKept")
    assert "128 of 128 points of the boundary kept" in mesh.GetFieldData().GetAbstractArray("Summary").GetValue(0)
    remesh.BoundarySpacing = "Even"
    mesh = servermanager.Fetch(remesh)
    assert number(mesh, "BoundaryUnevenness") < 0.02
    assert "edges of the boundary even to" in mesh.GetFieldData().GetAbstractArray("Summary").GetValue(0)
    assert mesh.GetFieldData().GetArray("BoundaryPoints") is None


def test_size_sources():
    """Sizes come from the shape, or from a function that is to be interpolated."""
    egg = Transform(Input=Sphere(ThetaResolution=64, PhiResolution=64))
    egg.Transform.Scale = [4, 1, 1]
    remesh = FieldAlignedRemesh(Input=egg, NumberOfFaces=1000)
    even = servermanager.Fetch(remesh)
    assert even.GetFieldData().GetArray("ErrorOfSizes") is None
    remesh.SizeSource = "Curvature"
    mesh = servermanager.Fetch(remesh)
    assert 0 < number(mesh, "ErrorOfSizes") < number(even, "MaximumDistance")
    assert "sizes for an error of" in mesh.GetFieldData().GetAbstractArray("Summary").GetValue(0)
    front = Calculator(Input=Plane(XResolution=60, YResolution=60), Function="(coordsX+0.5)^6",
                       ResultArrayName="Front")
    remesh = FieldAlignedRemesh(Input=front, NumberOfFaces=1000, SizingArray="Front", SizeSource="Second Derivatives")
    mesh = servermanager.Fetch(remesh)
    right = sum(mesh.GetPoint(i)[0] > 0 for i in range(mesh.GetNumberOfPoints()))
    assert right > 0.6 * mesh.GetNumberOfPoints(), right / mesh.GetNumberOfPoints()


def test_quality():
    """Faces beyond a limit are marked, counted and said; without limits there is no mark."""
    remesh = FieldAlignedRemesh(Input=Sphere(ThetaResolution=40, PhiResolution=30), NumberOfFaces=200)
    assert servermanager.Fetch(remesh).GetCellData().GetArray("Pass") is None
    warnings = []
    # It takes the warning: one that is printed makes the test fail.
    remesh.GetClientSideObject().AddObserver("WarningEvent", lambda filter, event: warnings.append(event))
    remesh.MaximumWarpage = 0.001
    mesh = servermanager.Fetch(remesh)
    warpage, passed = (mesh.GetCellData().GetArray(name) for name in ("Warpage", "Pass"))
    failed = [cell for cell in range(mesh.GetNumberOfCells()) if warpage.GetTuple1(cell) > 0.001]
    assert failed == [cell for cell in range(mesh.GetNumberOfCells()) if passed.GetTuple1(cell) == 0]
    assert len(warnings) == 1
    assert 0 < len(failed) < mesh.GetNumberOfCells() and number(mesh, "FailedFaces") == len(failed)
    assert f"{len(failed)} faces fail the limits" in mesh.GetFieldData().GetAbstractArray("Summary").GetValue(0)


def test_data():
    """The integral of a cell array is kept, as ParaView measures it, also where faces are larger than
    its peaks; numbers of parts are not mixed."""
    sphere = Sphere(ThetaResolution=60, PhiResolution=40)
    peaks = Calculator(Input=PointDatatoCellData(Input=Calculator(
        Input=sphere, Function="exp(30*coordsX)", ResultArrayName="Load")), AttributeType="Cell Data",
        Function="round(Load/1e5)", ResultArrayName="Part", ResultArrayType="Int")
    remesh = FieldAlignedRemesh(Input=peaks, NumberOfFaces=300, ConservedArray="Load")
    given, kept = (servermanager.Fetch(IntegrateVariables(Input=source)).GetCellData().GetArray("Load").GetTuple1(0)
                   for source in (peaks, remesh))
    assert abs(kept / given - 1) < 1e-11, kept / given - 1
    parts = [servermanager.Fetch(source).GetCellData().GetArray("Part") for source in (peaks, remesh)]
    before, after = ({part.GetTuple1(cell) for cell in range(part.GetNumberOfTuples())} for part in parts)
    assert len(after) > 1 and after <= before, after - before


def check_given_points(surface):
    """Points become vertices, and lines have the cell arrays of what they come from."""
    points = Calculator(Input=PointSource(Center=[0.21, 0.13, 0]), AttributeType="Cell Data", Function="7",
                        ResultArrayName="Load")
    remesh = FieldAlignedRemesh(Input=surface, KeptCurves=points, NumberOfFaces=400)
    mesh, lines = servermanager.Fetch(remesh), servermanager.Fetch(remesh, idx=2)
    given = mesh.GetPointData().GetArray("GivenPoint")
    found = [p for p in range(mesh.GetNumberOfPoints()) if given.GetTuple1(p) == 0]
    assert len(found) == 1, found
    place = mesh.GetPoint(found[0])
    assert max(abs(a - b) for a, b in zip(place, (0.21, 0.13, 0))) < 1e-7, place
    cells = lines.GetCellData()
    assert lines.GetNumberOfVerts() == 1 and cells.GetAbstractArray("ChainName").GetValue(0) == "Point 0"
    assert cells.GetArray("ChainKind").GetTuple1(0) == 4 and cells.GetArray("Load").GetTuple1(0) == 7
    assert cells.GetArray("CurveId").GetTuple1(0) == -1 and cells.GetArray("GivenPoint").GetTuple1(0) == 0
    assert cells.GetArray("ChainId").GetTuple1(0) == lines.GetNumberOfLines()
    names = mesh.GetFieldData().GetAbstractArray("ChainNames")
    assert names.GetValue(names.GetNumberOfValues() - 1) == "Point 0"


def test_regions():
    """Bands of a plane: their borders are edges, and faces have their numbers."""
    cells = PointDatatoCellData(Input=Calculator(
        Input=Plane(XResolution=20, YResolution=20), Function="coordsX", ResultArrayName="X"))
    bands = Calculator(Input=cells, AttributeType="Cell Data", Function="floor(2*X+1)", ResultArrayName="Band")
    remesh = FieldAlignedRemesh(Input=bands, NumberOfFaces=400, RegionArray="Band")
    mesh = servermanager.Fetch(remesh)
    assert number(mesh, "Regions") == 2 and number(mesh, "BordersKept") > 1 - 1e-9
    values = mesh.GetCellData().GetArray("Band")
    for cell in range(mesh.GetNumberOfCells()):
        left, right = mesh.GetCell(cell).GetBounds()[:2]
        assert values.GetTuple1(cell) == (1 if left + right > 0 else 0)
        assert left > -1e-6 or right < 1e-6
    lines = servermanager.Fetch(remesh, idx=2)
    names = lines.GetCellData().GetAbstractArray("ChainName")
    assert lines.GetNumberOfCells() == 7 and names.GetValue(6) == "Border 0/1 1", names.GetValue(6)
    assert lines.GetCell(6).GetBounds()[:2] == (0.0, 0.0), lines.GetCell(6).GetBounds()
    curve = PolyLineSource(Points=[-0.5, 0.3, 0, 0.5, -0.1, 0])
    lines = servermanager.Fetch(FieldAlignedRemesh(Input=bands, KeptCurves=curve, NumberOfFaces=400), idx=2)
    assert lines.GetNumberOfCells() == 7, lines.GetNumberOfCells()
    check_given_points(bands)
    assert "2 regions with 100 % of their borders" in mesh.GetFieldData().GetAbstractArray("Summary").GetValue(0)


test_properties()
test_scan()
test_field()
test_options()
test_boundary()
test_size_sources()
test_quality()
test_data()
test_regions()
print("passed")
