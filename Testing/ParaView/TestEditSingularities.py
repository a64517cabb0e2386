# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Edit Singularities in Python: TestEditSingularities.py PLUGIN PRINT_PROPERTIES DIRECTORY

PRINT_PROPERTIES is the program that prints the defaults and ranges of the C++ classes."""
import math
import os
import sys

from paraview import servermanager
from paraview.simple import *

import AllFigures
from Properties import check_properties, printed

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()
FOLDER = os.path.join(sys.argv[3], "EditSingularities")
os.makedirs(FOLDER, exist_ok=True)
ENUMERATIONS = {"SingularityMode": ["Replace", "Add"], "Objective": ["Smoothest", "Least Change"],
                "Alignment": ["None", "Principal Curvature", "Point Vectors"]}


def field():
    return DirectionField(Input=Sphere(ThetaResolution=48, PhiResolution=32))


def corners():
    """The corners of a cube on the sphere, a point source each."""
    half = 0.5 / math.sqrt(3.0)
    places = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    return AppendDatasets(Input=[PointSource(Center=place, NumberOfPoints=1, Radius=0.0)
                                 for place in places])


def numbers(data, name):
    return data.GetFieldData().GetArray(name).GetTuple(0)


def test_properties():
    [expected] = printed(sys.argv[2], "EditSingularities")
    edit = EditSingularities(Input=field(), Singularities=Sphere())
    check_properties(edit, expected, ENUMERATIONS, ["GatherLimit", "KeepStages"],
                     others=("Input", "Singularities", "SingularityList"))
    assert edit.SMProxy.GetXMLLabel() == "Edit Singularities"


def test_cube():
    edit = EditSingularities(Input=field(), Singularities=corners())
    data = servermanager.Fetch(edit)
    singularities = servermanager.Fetch(edit, idx=1)
    assert singularities.GetNumberOfPoints() == 8
    assert numbers(data, "WrongTriangles") == (0.0,)
    assert numbers(data, "IndexSum") == (8.0,)
    assert numbers(data, "MaximumRotation")[0] < 1.0
    best = numbers(data, "RotationEnergy")[0]
    given = servermanager.Fetch(EditSingularities(Input=edit.Input, Singularities=OutputPort(edit.Input, 1)))
    assert numbers(given, "RotationEnergy")[0] > best
    # Glyphs and lines take it for a field.
    assert servermanager.Fetch(DirectionFieldGlyphs(Input=edit)).GetNumberOfPoints() > 0
    assert servermanager.Fetch(DirectionFieldStreamlines(Input=edit)).GetNumberOfLines() > 0


def test_transformed_singularities():
    """The second output, turned, goes in again."""
    base = field()
    turned = Transform(Input=OutputPort(base, 1))
    turned.Transform.Rotate = [20.0, 0.0, 0.0]
    edit = EditSingularities(Input=base, Singularities=turned, Objective="Least Change")
    assert servermanager.Fetch(edit, idx=1).GetNumberOfPoints() == servermanager.Fetch(
        base, idx=1).GetNumberOfPoints()


def test_composite():
    group = GroupDatasets(Input=[Sphere(), Sphere(Center=[3, 0, 0])])
    base = DirectionField(Input=group)
    data = servermanager.Fetch(EditSingularities(Input=base, Singularities=OutputPort(base, 1)))
    assert data.GetNumberOfBlocks() == 2
    for k in range(2):
        assert data.GetBlock(k).GetFieldData().GetArray("IndexSum").GetValue(0) == 8


def test_state():
    state = os.path.join(FOLDER, "state.pvsm")
    RenameSource("edit", EditSingularities(
        Input=field(), Singularities=Sphere(), SingularityMode="Add", Objective="Least Change",
        BalanceAutomatically=1, RefineWhereNeeded=1, KeepConstraints=0,
        Alignment="Principal Curvature", AlignmentStrength=0.25, KeepStages=0))
    SaveState(state)
    ResetSession()
    LoadState(state)
    edit = FindSource("edit")
    assert (edit.SingularityMode, edit.Objective, edit.BalanceAutomatically, edit.RefineWhereNeeded,
            edit.KeepConstraints, edit.Alignment, edit.AlignmentStrength, edit.KeepStages) == (
                "Add", "Least Change", 1, 1, 0, "Principal Curvature", 0.25, 0)


test_properties()
test_cube()
test_transformed_singularities()
test_composite()
test_state()
print("passed")
