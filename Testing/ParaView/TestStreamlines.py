# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter for lines in Python: TestStreamlines.py PLUGIN PRINT_PROPERTIES STATE_FILE

PRINT_PROPERTIES is the program that prints the defaults and ranges of the C++ filters."""
import os
import sys

from paraview import servermanager
from paraview.simple import *

import AllFigures
from Properties import check_properties, printed

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()

ENUMERATIONS = {
    "SeedType": ["Evenly Spaced", "Singularities", "Points"],
    "IntegrationDirection": ["Both", "Forward", "Backward"],
}
ADVANCED = ("GatherLimit", "SeedSource", "SeparatingDistanceRatio", "MinimumStreamlineLength",
            "MaximumNumberOfLines", "Offset")
# Which properties are shown for which seed type only.
SHOWN_FOR = {"SeparatingDistance": "0", "SeparatingDistanceRatio": "0", "StopAtCrossings": "1",
             "IntegrationDirection": "2"}


def make(degree=4, **properties):
    field = DirectionField(Input=Sphere(ThetaResolution=32, PhiResolution=24), Degree=degree)
    return field, DirectionFieldStreamlines(Input=field, **properties)


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    _, lines = make()
    [expected] = printed(sys.argv[2], "DirectionFieldStreamlines")
    check_properties(lines, expected, ENUMERATIONS, ADVANCED, others=("Input", "SeedSource"))
    for name, seeds in SHOWN_FOR.items():
        decorator = lines.SMProxy.GetProperty(name).GetHints().FindNestedElementByName(
            "PropertyWidgetDecorator")
        assert [decorator.GetAttribute(key)
                for key in ("type", "mode", "property", "value")] == [
                    "GenericDecorator", "visibility", "SeedType", seeds], name


def test_menu():
    _, lines = make()
    assert lines.SMProxy.GetXMLLabel() == "Direction Field Streamlines"
    hints = lines.SMProxy.GetHints()
    # The surface stays to be seen, and no dialog asks for seeds.
    assert hints.FindNestedElementByName("Visibility").GetAttribute("replace_input") == "0"
    seeds = lines.SMProxy.GetProperty("SeedSource")
    assert seeds.GetHints().FindNestedElementByName("Optional")
    assert lines.SMProxy.GetNumberOfOutputPorts() == 2


def test_lines():
    for degree in (1, 2, 3, 4, 6):
        _, lines = make(degree)
        data = servermanager.Fetch(lines)
        assert data.GetNumberOfLines() > 10, (degree, data.GetNumberOfLines())
        families = degree if degree % 2 else degree // 2
        assert data.GetCellData().GetArray("Family").GetRange()[1] <= families - 1
        lines.SeedType = "Singularities"
        lines.MaximumStreamlineLength = 0.5
        lines.UpdatePipeline()
        nodes = servermanager.Fetch(lines, idx=1)
        indices = [int(nodes.GetPointData().GetArray("SingularityIndex").GetTuple1(i))
                   for i in range(nodes.GetNumberOfPoints())]
        assert sum(indices) == 2 * degree, (degree, indices)
        count = sum(abs(degree - k) for k in indices if k) * (2 if degree % 2 else 1)
        assert servermanager.Fetch(lines).GetNumberOfLines() == count, degree


def test_points():
    seeds = PointSource(Center=[0.0, 0.0, 1.0], NumberOfPoints=3, Radius=0.1)
    _, lines = make(4, SeedSource=seeds, SeedType="Points", MaximumStreamlineLength=0.5)
    data = servermanager.Fetch(lines)
    assert data.GetNumberOfLines() == 6, data.GetNumberOfLines()
    assert data.GetCellData().GetArray("Length").GetRange()[1] < 0.501


def test_blocks():
    """Each block of a composite input has lines of its own."""
    a, b = Sphere(), Sphere(Center=[3.0, 0.0, 0.0])
    field = DirectionField(Input=GroupDatasets(Input=[a, b]), Degree=2)
    lines = DirectionFieldStreamlines(Input=field)
    lines.UpdatePipeline()
    bounds = lines.GetDataInformation().GetBounds()
    assert bounds[0] < -0.4 and bounds[1] > 3.4, bounds


def test_time_steps():
    """Each time step of a surface that grows has the lines of that step, at a spacing that grows with it."""
    folder = os.path.dirname(os.path.abspath(sys.argv[3]))
    files = []
    for i, radius in enumerate((0.5, 1.0)):
        files.append(os.path.join(folder, f"growing{i}.vtp"))
        SaveData(files[-1], proxy=Sphere(Radius=radius, ThetaResolution=24, PhiResolution=16),
                 DataMode="Binary")
    field = DirectionField(Input=XMLPolyDataReader(FileName=files), Degree=2)
    lines = DirectionFieldStreamlines(Input=field)
    found = []
    for time in (0.0, 1.0, 0.0):
        lines.UpdatePipeline(time)
        data = servermanager.Fetch(lines)
        found.append((data.GetNumberOfLines(), data.GetNumberOfPoints(), data.GetBounds()[1],
                      data.GetFieldData().GetArray("SeparatingDistance").GetTuple1(0)))
    assert found[0] == found[2], found
    assert abs(found[1][3] - 2.0 * found[0][3]) < 1e-6 * found[1][3], found
    assert abs(found[1][2] - 2.0 * found[0][2]) < 1e-2, found


def test_first_look():
    """Shown without any setting, the lines have one quiet colour, on the surface."""
    field, lines = make()
    view = CreateRenderView(ViewSize=[200, 200])
    surface = Show(field, view)
    display = Show(lines, view)
    assert display.Representation == "Surface", display.Representation
    assert display.ColorArrayName[1] in ("", None), list(display.ColorArrayName)
    assert [round(c, 2) for c in display.DiffuseColor] == [0.0, 0.42, 0.46]
    assert [round(c, 2) for c in surface.DiffuseColor] != [0.0, 0.42, 0.46]
    assert display.LineWidth == 2.0
    Delete(view)


def test_state():
    state = sys.argv[3]
    if os.path.exists(state):
        os.remove(state)
    values = {"SeedType": "Singularities", "SeparatingDistance": 0.125,
              "SeparatingDistanceRatio": 0.75, "StopAtCrossings": 1,
              "IntegrationDirection": "Forward", "MaximumStreamlineLength": 7.5,
              "MinimumStreamlineLength": 0.0625, "MaximumNumberOfLines": 321, "Offset": 0.25}
    RenameSource("lines", make(4, **values)[1])
    SaveState(state)
    ResetSession()
    LoadState(state)
    lines = FindSource("lines")
    assert lines.GetXMLName() == "DirectionFieldStreamlines"
    for name, value in values.items():
        assert getattr(lines, name) == value, (name, getattr(lines, name))
    assert servermanager.Fetch(lines).GetNumberOfLines() >= 4


test_properties()
test_menu()
test_lines()
test_points()
test_blocks()
test_time_steps()
test_first_look()
test_state()
print("passed")
