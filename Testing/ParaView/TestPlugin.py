# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in Python: TestPlugin.py PLUGIN PRINT_PROPERTIES

PRINT_PROPERTIES is the program that prints the defaults and ranges of the C++ filter."""
import json
import subprocess
import sys

from paraview import servermanager
from paraview.simple import *

LoadPlugin(sys.argv[1], remote=False, ns=globals())


def names(attributes):
    return [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]


def total(array):
    return sum(int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples()))


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    field = DirectionField(Input=Sphere())
    expected = json.loads(subprocess.check_output([sys.argv[2]], text=True))
    properties = [name for name in field.ListProperties() if name != "Input"]
    assert sorted(properties) == sorted(expected), properties
    for name, figures in expected.items():
        assert getattr(field, name) == figures["default"], name
        domain = field.SMProxy.GetProperty(name).GetDomain("range")
        assert domain.GetMinimumExists(0) and domain.GetMaximumExists(0), name
        assert domain.GetMinimum(0) == figures["min"], name
        assert domain.GetMaximum(0) == figures["max"], name
    for name in ["Input"] + properties:
        documentation = field.SMProxy.GetProperty(name).GetDocumentation()
        assert documentation and documentation.GetDescription().strip(), name
    documentation = field.SMProxy.GetDocumentation()
    for text in (documentation.GetDescription(), documentation.GetShortHelp(),
                 documentation.GetLongHelp()):
        assert text and text.strip()
    for name in properties:
        visibility = field.SMProxy.GetProperty(name).GetPanelVisibility()
        advanced = name in ("Tolerance", "MaximumIterations")
        assert visibility == ("advanced" if advanced else "default"), (name, visibility)
    Delete(field)


def test_menu_and_ports():
    field = DirectionField(Input=Sphere())
    assert field.SMProxy.GetXMLLabel() == "Direction Field"
    assert field.SMProxy.GetXMLGroup() == "filters"
    menu = field.SMProxy.GetHints().FindNestedElementByName("ShowInMenu")
    assert menu.GetAttribute("category") == "Direction Fields"
    assert field.SMProxy.GetNumberOfOutputPorts() == 2
    assert field.SMProxy.GetOutputPortName(0) == "Direction Field"
    assert field.SMProxy.GetOutputPortName(1) == "Singularities"
    Delete(field)


def test_field(degree):
    mesh = Sphere(ThetaResolution=32, PhiResolution=24)
    field = DirectionField(Input=mesh)
    field.Degree = degree
    surface = servermanager.Fetch(field)
    points = names(surface.GetPointData())
    for k in range(16):
        assert ("Direction%d" % k in points) == (k < degree), points
    assert "RepresentationMagnitude" in points
    assert surface.GetPointData().GetVectors().GetName() == "Direction0"
    assert total(surface.GetCellData().GetArray("SingularityIndex")) == 2 * degree
    values = surface.GetFieldData()
    for name in ("Eigenvalue", "Residual", "Iterations", "EulerCharacteristic", "IndexSum"):
        assert values.GetArray(name).GetNumberOfTuples() == 1, name
    assert values.GetArray("IndexSum").GetTuple1(0) == 2 * degree
    # Radius 1/2: the eigenvalue of the unit sphere, n, times 4.
    assert abs(values.GetArray("Eigenvalue").GetTuple1(0) / (4.0 * degree) - 1.0) < 0.1
    for k in range(degree):
        array = surface.GetPointData().GetArray("Direction%d" % k)
        low, high = array.GetRange(-1)
        assert abs(low - 1.0) < 1e-5 and abs(high - 1.0) < 1e-5

    singularities = servermanager.Fetch(field, idx=1)
    assert singularities.GetNumberOfPoints() > 0
    assert sorted(names(singularities.GetPointData())) == [
        "CellId", "Index", "Normals", "SingularityIndex"]
    assert total(singularities.GetPointData().GetArray("SingularityIndex")) == 2 * degree

    # The second output by its name, in a pipeline of its own.
    glyphs = Glyph(Input=field["Singularities"], GlyphType="Sphere")
    glyphs.GlyphMode = "All Points"
    glyphs.ScaleFactor = 0.02
    glyphs.UpdatePipeline()
    assert (glyphs.GetDataInformation().GetNumberOfPoints() %
            singularities.GetNumberOfPoints() == 0)
    assert glyphs.GetDataInformation().GetNumberOfPoints() > 0
    for proxy in (glyphs, field, mesh):
        Delete(proxy)


test_properties()
test_menu_and_ports()
for n in (1, 2, 4, 6):
    test_field(n)
print("passed")
