# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in Python: TestPlugin.py PLUGIN PRINT_PROPERTIES

PRINT_PROPERTIES is the program that prints the defaults and ranges of the C++ filters."""
import sys

from paraview import servermanager
from paraview.simple import *

import AllFigures
from Properties import check_properties, printed

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()


def names(attributes):
    return [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]


def total(array):
    return sum(int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples()))


# Shift is not one of them, because it takes the place of the strength where UseShift is on.
ADVANCED = ("Tolerance", "MaximumIterations", "Solver", "NumberOfStarts", "NumberOfThreads",
            "KeepStages", "Distribution", "GatherLimit",
            "IntrinsicDelaunay", "CellDirections", "UseShift", "CurvatureScale", "TensorScale")
ENUMERATIONS = {
    "Alignment": ["None", "Principal Curvature", "Point Vectors", "Tensor"],
    "CurvatureDirection": ["Maximum", "Minimum", "Least Bent", "Most Bent"],
    "ConstraintSolver": ["Least Squares", "Energy"],
    "Distribution": ["Automatic", "Gather", "Distributed"],
    "MergePoints": ["Off", "On", "Automatic"],
    "Solver": ["Automatic", "Multigrid", "Direct"],
    "TensorDirection": ["Major", "Minor", "Larger Magnitude"],
}


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    field = DirectionField(Input=Sphere())
    [expected] = printed(sys.argv[2], "DirectionField")
    # The array of tensors is one of the algorithm's own settings.
    check_properties(field, expected, ENUMERATIONS, ADVANCED, ("Input", "TensorArray"))
    Delete(field)


def test_alignments_of_degrees():
    """An alignment is kept while the degree passes through one that has none of that kind; where it
    is applied with such a degree, the reason and the remedy are said."""
    field = DirectionField(Input=Sphere())
    field.Degree = 2
    field.Alignment = "Principal Curvature"
    for n in (3, 4):
        field.Degree = n
        assert field.Alignment == "Principal Curvature", n
    field.Degree = 3
    messages = []

    def hear(source, event, message):
        messages.append(message)
    hear.CallDataType = "string0"
    # Both tell of the error, and are silent where somebody listens.
    field.GetClientSideObject().AddObserver("ErrorEvent", hear)
    field.GetClientSideObject().GetExecutive().AddObserver("ErrorEvent", hear)
    field.UpdatePipeline()
    text = "\n".join(messages)
    assert "Set Directions per point (Degree) to 2 or 4" in text, text
    try:
        field.Alignment = "Curvature"
    except ValueError as problem:
        assert "Curvature" in str(problem), problem
    else:
        raise AssertionError("There is no such alignment.")
    Delete(field)


def is_true(element, values):
    """Whether a decorator, or an expression of them, lets a property be shown or used."""
    children = [element.GetNestedElement(i) for i in range(element.GetNumberOfNestedElements())]
    if element.GetName() == "Expression":
        combine = {"and": all, "or": any}[element.GetAttribute("type")]
        return combine(is_true(child, values) for child in children)
    assert element.GetName() == "PropertyWidgetDecorator", element.GetName()
    if element.GetAttribute("type") == "CompositeDecorator":
        assert len(children) == 1
        return is_true(children[0], values)
    assert element.GetAttribute("type") == "GenericDecorator"
    assert element.GetAttribute("mode") in ("visibility", "enabled_state")
    several = element.GetAttribute("values")
    allowed = several.split() if several else [element.GetAttribute("value")]
    return str(values[element.GetAttribute("property")]) in allowed


def used(field, **values):
    """The properties, other than those that always are, that the panel shows or lets be used."""
    names = [name for name in field.ListProperties() if name != "Input"]
    values = {**{name: field.SMProxy.GetProperty(name).GetElement(0) for name in names}, **values}
    result = set()
    for name in names:
        hints = field.SMProxy.GetProperty(name).GetHints()
        elements = [hints.GetNestedElement(i) for i in range(hints.GetNumberOfNestedElements())
                    ] if hints else []
        decorators = [element for element in elements if element.GetName() != "Row"]
        if decorators and all(is_true(decorator, values) for decorator in decorators):
            result.add(name)
    return result


def test_rows():
    """What appears or disappears with a property stands below it, so that nothing moves under the
    mouse."""
    field = DirectionField(Input=Sphere())
    order = []
    for i in range(field.SMProxy.GetNumberOfPropertyGroups()):
        group = field.SMProxy.GetPropertyGroup(i)
        order += [group.GetProperty(k).GetXMLName() for k in range(group.GetNumberOfProperties())]

    def switches(element):
        own = [element.GetAttribute("property")] if element.GetAttribute("property") else []
        return own + sum((switches(element.GetNestedElement(i))
                          for i in range(element.GetNumberOfNestedElements())), [])

    def is_hidden_by(element):
        return (element.GetAttribute("mode") == "visibility" or any(
            is_hidden_by(element.GetNestedElement(i))
            for i in range(element.GetNumberOfNestedElements())))
    moving = 0
    for name in order:
        hints = field.SMProxy.GetProperty(name).GetHints()
        for i in range(hints.GetNumberOfNestedElements() if hints else 0):
            decorator = hints.GetNestedElement(i)
            if decorator.GetName() == "PropertyWidgetDecorator" and is_hidden_by(decorator):
                moving += 1
                for switch in set(switches(decorator)) & set(order):
                    assert order.index(switch) < order.index(name), (switch, name)
    assert moving >= 6, moving
    Delete(field)


def test_panel():
    """Properties appear where they apply, in groups."""
    field = DirectionField(Input=Sphere())
    groups = {}
    for i in range(field.SMProxy.GetNumberOfPropertyGroups()):
        group = field.SMProxy.GetPropertyGroup(i)
        groups[group.GetXMLLabel()] = [
            group.GetProperty(k).GetXMLName() for k in range(group.GetNumberOfProperties())]
    assert list(groups) == ["Alignment", "Guidance", "Constraints", "Mesh", "Solver"], groups
    outside = {"Degree", "EnergyBias", "UnitLength", "SingularityCost", "NumberOfStarts", "Preview",
               "Input"}
    assert sorted(sum(groups.values(), [])) == sorted(set(field.ListProperties()) - outside), groups

    curvature = {"ConstrainCurvature"}
    scale = {"CurvatureScale"}
    strength = {"AlignmentStrength", "UseShift"}
    guidance = {"GuidanceVectors", "GuidanceWeights"}
    tensor = {"TensorArray", "TensorScale", "TensorStrength", "UseShift"}
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
            ({"Alignment": 3}, curvature | tensor),
            ({"Alignment": 3, "Degree": 2}, curvature | tensor | {"TensorDirection"}),
            ({"Alignment": 3, "Degree": 3}, tensor),
            ({"Alignment": 3, "UseShift": 1},
             curvature | tensor - {"TensorStrength"} | {"Shift"}),
            ({"ConstrainGuidance": 1, "Degree": 3}, guidance | {"GuidanceStrengths"} | solver),
            ({"ConstrainBoundary": 1, "Degree": 3}, solver),
            ({"ConstrainSharpEdges": 1, "Degree": 3}, {"FeatureAngle", "MinimumFeatureLength"} | solver),
            ({"ConstrainCurvature": 1}, curvature | scale | consistency | solver),
            ({"ConstrainCurvature": 1, "Degree": 2},
             curvature | scale | consistency | solver | {"CurvatureDirection"}),
            # Constraints of another degree are an error, which the user must be able to switch off.
            ({"ConstrainCurvature": 1, "Degree": 6}, curvature | scale | consistency | solver)):
        assert used(field, **settings) == expected, (settings, used(field, **settings))
    Delete(field)


def test_menu_and_ports():
    field = DirectionField(Input=Sphere())
    assert field.SMProxy.GetXMLLabel() == "Direction Field"
    assert field.SMProxy.GetXMLGroup() == "filters"
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
test_rows()
test_menu_and_ports()
for n in (1, 2, 4, 6):
    test_field(n)
print("passed")
