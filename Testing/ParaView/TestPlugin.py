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


# Shift is not one of them, because it takes the place of the strength where UseShift is on.
ADVANCED = ("Tolerance", "MaximumIterations", "Solver", "NumberOfThreads", "KeepStages",
            "IntrinsicDelaunay", "UseShift", "CurvatureScale")
ENUMERATIONS = {
    "Alignment": ["None", "Principal Curvature", "Point Vectors"],
    "CurvatureDirection": ["Maximum", "Minimum", "Least Bent", "Most Bent"],
    "ConstraintSolver": ["Least Squares", "Energy"],
    "MergePoints": ["Off", "On", "Automatic"],
    "Solver": ["Automatic", "Multigrid", "Direct"],
}
# A range that ends beyond this has no upper limit in C++, where it ends at VTK_DOUBLE_MAX.
UNLIMITED = 1e299


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    field = DirectionField(Input=Sphere())
    expected = json.loads(subprocess.check_output([sys.argv[2]], text=True))
    properties = [name for name in field.ListProperties() if name != "Input"]
    assert sorted(properties) == sorted(expected), properties
    for name, figures in expected.items():
        proxy = field.SMProxy.GetProperty(name)
        value = proxy.GetElement(0)
        if figures["default"] is None:
            assert value in ("", "None"), (name, value)
            assert proxy.GetDomain("array_list"), name
            continue
        assert value == figures["default"], (name, value)
        if "min" not in figures:
            assert proxy.GetDomain("bool"), name
        elif name in ENUMERATIONS:
            domain = proxy.FindDomain("vtkSMEnumerationDomain")
            entries = [(domain.GetEntryValue(i), domain.GetEntryText(i))
                       for i in range(domain.GetNumberOfEntries())]
            assert entries == list(enumerate(ENUMERATIONS[name])), entries
            assert (entries[0][0], entries[-1][0]) == (figures["min"], figures["max"]), name
        else:
            domain = proxy.GetDomain("range")
            assert domain.GetMinimumExists(0), name
            assert domain.GetMinimum(0) == figures["min"], name
            assert bool(domain.GetMaximumExists(0)) == (figures["max"] < UNLIMITED), name
            if figures["max"] < UNLIMITED:
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
        assert visibility == ("advanced" if name in ADVANCED else "default"), (name, visibility)
    Delete(field)


def test_alignments_of_degrees():
    """Principal curvature is offered where there is a field of it, also before Apply."""
    field = DirectionField(Input=Sphere())
    degree = field.SMProxy.GetProperty("Degree")
    for n in list(range(1, 17)) + [4]:
        expected = [text for text in ENUMERATIONS["Alignment"]
                    if text != "Principal Curvature" or n in (2, 4)]
        degree.SetUncheckedElement(0, n)
        assert field.GetProperty("Alignment").Available == expected, n
        degree.ClearUncheckedElements()
        field.Degree = n
        assert field.GetProperty("Alignment").Available == expected, n
    field.Alignment = "Principal Curvature"
    assert field.SMProxy.GetProperty("Alignment").GetElement(0) == 1
    field.Alignment = "None"
    field.Degree = 6
    try:
        field.Alignment = "Principal Curvature"
    except ValueError:
        pass
    else:
        raise AssertionError("Degree 6 took the principal curvature.")
    field.Alignment = "Point Vectors"
    assert field.SMProxy.GetProperty("Alignment").GetElement(0) == 2
    Delete(field)


def is_true(element, values):
    """Whether a decorator, or an expression of them, lets a property be shown."""
    children = [element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements())]
    if element.GetName() == "Expression":
        combine = {"and": all, "or": any}[element.GetAttribute("type")]
        return combine(is_true(child, values) for child in children)
    assert element.GetName() == "PropertyWidgetDecorator", element.GetName()
    if element.GetAttribute("type") == "CompositeDecorator":
        assert len(children) == 1
        return is_true(children[0], values)
    assert element.GetAttribute("type") == "GenericDecorator"
    assert element.GetAttribute("mode") == "visibility"
    several = element.GetAttribute("values")
    allowed = several.split() if several else [element.GetAttribute("value")]
    return str(values[element.GetAttribute("property")]) in allowed


def shown(field, **values):
    """The properties, other than those that always are, that the panel shows."""
    names = [name for name in field.ListProperties() if name != "Input"]
    values = {**{name: field.SMProxy.GetProperty(name).GetElement(0) for name in names}, **values}
    result = set()
    for name in names:
        hints = field.SMProxy.GetProperty(name).GetHints()
        if hints and all(is_true(hints.GetNestedElement(i), values)
                         for i in range(hints.GetNumberOfNestedElements())):
            result.add(name)
    return result


def test_panel():
    """Properties appear where they apply, in groups."""
    field = DirectionField(Input=Sphere())
    groups = {}
    for i in range(field.SMProxy.GetNumberOfPropertyGroups()):
        group = field.SMProxy.GetPropertyGroup(i)
        groups[group.GetXMLLabel()] = [
            group.GetProperty(k).GetXMLName() for k in range(group.GetNumberOfProperties())]
    assert list(groups) == ["Alignment", "Constraints"], groups
    outside = {"Degree", "EnergyBias", "UnitLength", "SingularityCost", "MergePoints",
               "Tolerance", "MaximumIterations", "Solver", "NumberOfThreads", "KeepStages",
               "IntrinsicDelaunay", "Input"}
    assert sorted(sum(groups.values(), [])) == sorted(set(field.ListProperties()) - outside), groups

    curvature = {"ConstrainCurvature"}
    scale = {"CurvatureScale"}
    strength = {"AlignmentStrength", "UseShift"}
    guidance = {"GuidanceVectors", "GuidanceWeights"}
    solver = {"ConstraintSolver"}
    consistency = {"CurvatureTolerance", "ConsistencyAngle", "DropConstraintsAtSingularities"}
    for settings, expected in (
            ({}, curvature),
            ({"Degree": 6}, set()),
            ({"Degree": 2}, curvature),
            ({"Alignment": 1}, curvature | scale | strength),
            ({"Alignment": 1, "Degree": 2},
             curvature | scale | strength | {"CurvatureDirection"}),
            ({"Alignment": 1, "UseShift": 1}, curvature | scale | {"UseShift", "Shift"}),
            ({"UseShift": 1}, curvature),
            ({"Alignment": 2, "Degree": 2}, curvature | strength | guidance),
            ({"Alignment": 2, "Degree": 3}, strength | guidance),
            ({"ConstrainGuidance": 1, "Degree": 3}, guidance | solver),
            ({"ConstrainBoundary": 1, "Degree": 3}, solver),
            ({"ConstrainSharpEdges": 1, "Degree": 3}, {"FeatureAngle", "MinimumFeatureLength"} | solver),
            ({"ConstrainCurvature": 1}, curvature | scale | consistency | solver),
            ({"ConstrainCurvature": 1, "Degree": 2},
             curvature | scale | consistency | solver | {"CurvatureDirection"}),
            # Constraints of another degree are an error, which the user must be able to switch off.
            ({"ConstrainCurvature": 1, "Degree": 6}, curvature | scale | consistency | solver)):
        assert shown(field, **settings) == expected, (settings, shown(field, **settings))
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
    for name in ("Eigenvalue", "Residual", "Iterations", "EulerCharacteristic", "IndexSum",
                 "Lambda", "SmoothnessEnergy", "SystemResidual"):
        assert values.GetArray(name).GetNumberOfTuples() == 1, name
    assert values.GetArray("IndexSum").GetTuple1(0) == 2 * degree
    # A sphere of radius 1/2 has 4 times the eigenvalue of the unit sphere, which is n.
    assert abs(values.GetArray("Eigenvalue").GetTuple1(0) / (4.0 * degree) - 1.0) < 0.1
    for k in range(degree):
        array = surface.GetPointData().GetArray("Direction%d" % k)
        low, high = array.GetRange(-1)
        assert abs(low - 1.0) < 1e-5 and abs(high - 1.0) < 1e-5

    singularities = servermanager.Fetch(field, idx=1)
    assert singularities.GetNumberOfPoints() > 0
    assert sorted(names(singularities.GetPointData())) == [
        "CellId", "Index", "Normals", "SingularityIndex", "Size"]
    assert total(singularities.GetPointData().GetArray("SingularityIndex")) == 2 * degree

    # The second output is found by its name, in a pipeline of its own.
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
test_alignments_of_degrees()
test_panel()
test_menu_and_ports()
for n in (1, 2, 4, 6):
    test_field(n)
print("passed")
