# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Stripes in ParaView's Python: TestStripes.py PLUGIN PRINT_PROPERTIES MESH OUTPUT

PRINT_PROPERTIES is the program that prints the defaults and ranges of the C++ filters."""
import os
import sys

from paraview import servermanager
from paraview.simple import *

import AllFigures
from Properties import check_properties, printed

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()

ENUMERATIONS = {"StripeDirection": ["Along Field", "Across Field"]}
ADVANCED = ("GatherLimit", "SpacingArray", "LineOffset", "Bands", "TextureCoordinates")


def number(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def length(lines):
    array = lines.GetCellData().GetArray("Length")
    return sum(array.GetTuple1(i) for i in range(array.GetNumberOfTuples()))


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    stripes = StripePattern(Input=DirectionField(Input=Sphere(), Degree=2))
    [expected] = printed(sys.argv[2], "StripePattern")
    check_properties(stripes, expected, ENUMERATIONS, ADVANCED)


def test_scan():
    """Lines, bands and branch points of a scan, along and across."""
    field = DirectionField(Input=OpenDataFile(sys.argv[3]), Degree=2)
    stripes = StripePattern(Input=field)
    for stripes.StripeDirection in ("Along Field", "Across Field"):
        lines = servermanager.Fetch(stripes, idx=0)
        bands = servermanager.Fetch(stripes, idx=1)
        branches = servermanager.Fetch(stripes, idx=2)
        area = 1600.0 * number(lines, "Spacing") ** 2
        assert abs(length(lines) * number(lines, "Spacing") / area - 1.0) < 0.03
        assert bands.GetNumberOfCells() > branches.GetNumberOfPoints() + lines.GetNumberOfPoints()
        assert bands.GetCellData().GetArray("Stripe").GetRange() == (0.0, 1.0)
        index = branches.GetPointData().GetArray("StripeIndex")
        count = sum(index.GetTuple1(i) != 0.0 for i in range(index.GetNumberOfTuples()))
        assert count == number(branches, "BranchPoints") > 0


def pixels(view):
    """Red, green and blue of the pixels of a view."""
    picture = os.path.join(sys.argv[4], "Stripes.png")
    SaveScreenshot(picture, view)
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(float).T


def test_first_look():
    """The bands of a new filter have the colors of stripes and of the surface, and lines are seen on them."""
    view = CreateRenderView(ViewSize=[300, 300], OrientationAxesVisibility=0)
    stripes = StripePattern(Input=DirectionField(Input=OpenDataFile(sys.argv[3]), Degree=2))
    display = Show(OutputPort(stripes, 1), view)
    assert list(display.ColorArrayName)[:2] == ["CELLS", "Stripe"], display.ColorArrayName
    ResetCamera(view)
    red, _, blue = pixels(view)
    light = ((red > 150) & (red >= blue)).sum()
    dark = ((red < 70) & (blue > 40) & (red < blue - 30)).sum()
    assert min(dark, light) > 2700, (dark, light)
    lines = Show(OutputPort(stripes, 0), view)
    lines.AmbientColor = lines.DiffuseColor = [1.0, 0.0, 0.0]
    lines.Ambient, lines.Diffuse = 1.0, 0.0
    red, _, blue = pixels(view)
    assert ((red > 150) & (blue < 80)).sum() > 2700, ((red > 150) & (blue < 80)).sum()
    Delete(view)


def test_spacings_of_points():
    """A point array of spacings, in place of the one for all."""
    plane = Plane(XResolution=30, YResolution=30)
    sized = Calculator(Input=DirectionField(Input=plane, Degree=1), Function="0.05",
                       ResultArrayName="Size")
    lines = servermanager.Fetch(StripePattern(Input=sized, SpacingArray="Size"), idx=0)
    assert abs(length(lines) * 0.05 - 1.0) < 0.05
    assert number(lines, "Spacing") == 0.0


def test_composite():
    """The blocks of a composite input have stripes each."""
    group = GroupDatasets(Input=[Sphere(PhiResolution=30, ThetaResolution=30),
                                 Plane(XResolution=20, YResolution=20)])
    stripes = StripePattern(Input=DirectionField(Input=group, Degree=1))
    for port in range(3):
        assert servermanager.Fetch(stripes, idx=port).GetNumberOfBlocks() == 2
    blocks = servermanager.Fetch(stripes, idx=0)
    assert all(blocks.GetBlock(k).GetNumberOfLines() > 5 for k in range(2))


test_properties()
test_scan()
test_spacings_of_points()
test_composite()
test_first_look()
print("passed")
