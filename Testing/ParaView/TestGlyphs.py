# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The glyph filter in Python: TestGlyphs.py PLUGIN PRINT_PROPERTIES STATE_FILE

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
    "GlyphType": ["Automatic", "Lines", "Arrows", "Ribbons", "Tubes"],
    "GlyphMode": ["Spread Evenly", "All Points"],
    "Side": ["Automatic", "Front", "Back", "Both"],
}
ADVANCED = ("GatherLimit", "Side", "Offset", "FollowSurface")


def make(degree=4, **properties):
    field = DirectionField(Input=Sphere(ThetaResolution=32, PhiResolution=24), Degree=degree)
    return field, DirectionFieldGlyphs(Input=field, **properties)


def field_data(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def test_properties():
    """Defaults and ranges equal those of C++, and everything is documented."""
    _, glyphs = make()
    [expected] = printed(sys.argv[2], "DirectionFieldGlyphs")
    check_properties(glyphs, expected, ENUMERATIONS, ADVANCED)


def test_panel():
    """Groups, and the spacing only where glyphs are spread."""
    _, glyphs = make()
    groups = {}
    for i in range(glyphs.SMProxy.GetNumberOfPropertyGroups()):
        group = glyphs.SMProxy.GetPropertyGroup(i)
        groups[group.GetXMLLabel()] = [
            group.GetProperty(k).GetXMLName() for k in range(group.GetNumberOfProperties())]
    assert groups == {
        "Glyphs": ["GlyphType", "Scale", "Side", "Offset", "FollowSurface"],
        "Distribution": ["GlyphMode", "MaximumNumberOfGlyphs", "Spacing"]}, groups
    for name in sum(groups.values(), []):
        hints = glyphs.SMProxy.GetProperty(name).GetHints()
        if name == "Spacing":
            decorator = hints.FindNestedElementByName("PropertyWidgetDecorator")
            assert [decorator.GetAttribute(key)
                    for key in ("type", "mode", "property", "value")] == [
                        "GenericDecorator", "visibility", "GlyphMode", "0"]
        else:
            assert not hints or not hints.FindNestedElementByName("PropertyWidgetDecorator"), name


def test_menu():
    _, glyphs = make()
    assert glyphs.SMProxy.GetXMLLabel() == "Direction Field Glyphs"
    hints = glyphs.SMProxy.GetHints()
    # The surface stays to be seen.
    assert hints.FindNestedElementByName("Visibility").GetAttribute("replace_input") == "0"
    assert glyphs.SMProxy.GetNumberOfOutputPorts() == 1


def test_glyphs():
    for degree in (1, 2, 4, 6):
        _, glyphs = make(degree)
        data = servermanager.Fetch(glyphs)
        assert 425 < field_data(data, "NumberOfGlyphs") <= 500
        names = [data.GetCellData().GetArrayName(i)
                 for i in range(data.GetCellData().GetNumberOfArrays())]
        assert sorted(names) == [
            "Branch", "Direction", "Location", "PointId", "RepresentationMagnitude"], names
        assert data.GetCellData().GetArray("Branch").GetRange() == (0.0, degree - 1.0)
        assert data.GetPointData().GetNormals() is not None
    _, glyphs = make(4, GlyphMode="Spread Evenly", Spacing=0.1, GlyphType="Lines")
    data = servermanager.Fetch(glyphs)
    assert field_data(data, "Spacing") == 0.1
    assert data.GetNumberOfLines() == 4 * field_data(data, "NumberOfGlyphs")
    glyphs.GlyphMode = "All Points"
    assert field_data(servermanager.Fetch(glyphs), "NumberOfGlyphs") == 32 * 22 + 2


def test_first_look():
    """Shown without any setting, the glyphs have one colour, and none by an array."""
    field, glyphs = make()
    view = CreateRenderView(ViewSize=[200, 200])
    surface = Show(field, view)
    display = Show(glyphs, view)
    assert display.Representation == "Surface", display.Representation
    assert list(surface.ColorArrayName)[1] in ("", None), list(surface.ColorArrayName)
    assert list(display.ColorArrayName)[1] in ("", None), list(display.ColorArrayName)
    Delete(view)


def test_state():
    state = sys.argv[3]
    if os.path.exists(state):
        os.remove(state)
    values = {"GlyphType": "Tubes", "GlyphMode": "All Points", "MaximumNumberOfGlyphs": 321,
              "Spacing": 0.25, "Scale": 0.75, "Side": "Back", "Offset": 0.125, "FollowSurface": 0}
    RenameSource("glyphs", make(6, **values)[1])
    SaveState(state)
    ResetSession()
    assert FindSource("glyphs") is None
    LoadState(state)
    glyphs = FindSource("glyphs")
    assert glyphs.GetXMLName() == "DirectionFieldGlyphs"
    for name, value in values.items():
        assert getattr(glyphs, name) == value, (name, getattr(glyphs, name))
    assert 250 < field_data(servermanager.Fetch(glyphs), "NumberOfGlyphs") <= 321


test_properties()
test_panel()
test_menu()
test_glyphs()
test_first_look()
test_state()
print("passed")
