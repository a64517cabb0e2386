# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A state file keeps the filter and its properties: TestState.py PLUGIN STATE_FILE"""
import os
import sys

from paraview import servermanager
from paraview.simple import *

LoadPlugin(sys.argv[1], remote=False, ns=globals())
state = sys.argv[2]
if os.path.exists(state):
    os.remove(state)

values = {"Degree": 3, "EnergyBias": -0.25, "Tolerance": 1e-8, "MaximumIterations": 123}


def figures(field):
    surface = servermanager.Fetch(field)
    singularities = servermanager.Fetch(field, idx=1)
    data = surface.GetFieldData()
    return [data.GetArray(name).GetTuple1(0) for name in ("Eigenvalue", "Residual", "IndexSum")] + [
        surface.GetNumberOfPoints(), singularities.GetNumberOfPoints()]


field = DirectionField(registrationName="field", Input=Sphere(ThetaResolution=24), **values)
before = figures(field)
assert before[2] == 6, before
SaveState(state)
del field

ResetSession()
assert FindSource("field") is None
LoadState(state)
field = FindSource("field")
assert field.GetXMLName() == "DirectionField"
for name, value in values.items():
    assert getattr(field, name) == value, (name, getattr(field, name))
assert figures(field) == before, (figures(field), before)
print("passed")
