# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The arrays that ParaView offers to color by are few: TestMenus.py PLUGIN"""
import sys

from paraview import simple

import Views

plugin = sys.argv[1]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields

view = Views.new_view()


def apply(source):
    """The displays that Apply shows."""
    return [display for display in Views.apply(view, source) if display is not None]


def menu(display):
    """The arrays that the colour menu of a display offers."""
    domain = display.GetProperty("ColorArrayName").GetDomain("array_list")
    return [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]


def check(name, displays, most):
    for display in displays:
        assert 0 < len(menu(display)) <= most, (name, menu(display))
        assert "Summary" not in menu(display) and "Normals" not in menu(display), menu(display)
        display.Visibility = 0


def test_fields():
    """Of any number of directions, with all constraints and alignments."""
    # Bent, with sharp edges, and no arrays of its own.
    cone = simple.Triangulate(Input=simple.Cone(Resolution=12))
    source = simple.Subdivide(Input=cone, NumberofSubdivisions=3)
    field = DirectionField(Input=source)
    for properties in ({"Degree": 1}, {"Degree": 2}, {"Degree": 4}, {"Degree": 6},
                       {"Degree": 4, "Diagnostics": 1}, {"Diagnostics": 0}, {"ConstrainSharpEdges": 1},
                       {"ConstrainCurvature": 1}, {"Alignment": "Principal Curvature"}):
        for name, value in properties.items():
            setattr(field, name, value)
        displays = apply(field)
        check(properties, displays, 6)
        assert {"EnergyDensity", "RepresentationMagnitude", "SingularityIndex"} <= set(
            menu(displays[0])), menu(displays[0])
    assert {"ConstraintKind", "MeanCurvature", "GaussianCurvature"} <= set(menu(displays[0]))


def test_filters():
    """What the other filters make: streamlines have at most five arrays, the others six."""
    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
    field, other = (DirectionField(Input=sphere, Degree=2, EnergyBias=bias) for bias in (0.0, 0.5))
    curve = simple.PolyLineSource(Points=[0.5, 0, 0, 0.35, 0, 0.35, 0, 0, 0.5])
    check("lines", apply(DirectionFieldStreamlines(Input=field)), 5)
    for made in (DirectionFieldGlyphs(Input=field), StripePattern(Input=field),
                 EditSingularities(Input=field),
                 CompareDirectionFields(Input=field, Other=other),
                 FieldAlignedRemesh(Input=sphere, NumberOfFaces=200, MinimumScaledJacobian=0.5),
                 GuidanceFromCurves(Input=sphere, Curves=curve),
                 DirectionField(Input=GuidanceFromCurves(Input=sphere, Curves=curve),
                                Alignment="Point Vectors", GuidanceVectors="GuidanceVectors")):
        check(made.GetXMLLabel(), apply(made), 6)
    # The picture of the button has the same menus.
    shown = directionfields.show(sphere, 2, view)
    check("the button", [simple.GetRepresentation(shown.surface, view),
                         simple.GetRepresentation(shown.glyphs, view)], 6)


def test_blocks():
    """The blocks of a group may differ in what is one color in each."""
    group = simple.GroupDatasets(Input=[simple.Sphere(Center=[-1, 0, 0]), simple.Sphere()])
    [surface] = apply(DirectionField(Input=group, Diagnostics=1))[:1]
    assert "Eigenvalue" in menu(surface) and "Summary" not in menu(surface), menu(surface)


def test_colors():
    """A script may color by what the menu leaves out, and a surface without a plugin's field, or
    with another display, has all its arrays."""
    field = DirectionField(Input=simple.Sphere())
    [surface] = apply(field)[:1]
    simple.ColorBy(surface, ("POINTS", "Direction1"))
    simple.Render(view)
    assert surface.ColorArrayName[:] == ["POINTS", "Direction1"]
    [plain] = apply(simple.Sphere())
    assert menu(plain) == ["Normals"], menu(plain)


test_fields()
test_filters()
test_blocks()
test_colors()
print("passed")
