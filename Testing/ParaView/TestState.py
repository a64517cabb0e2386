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

# Values that suit the surface and each other. None is the default, and those of the other properties are
# made from their domains.
chosen = {
    "Degree": 2, "EnergyBias": -0.25, "Tolerance": 1e-8, "MaximumIterations": 123,
    "Solver": "Direct", "NumberOfThreads": 3, "GatherLimit": 54321, "Distribution": "Gather",
    "MergePoints": "On", "SingularityCost": 1.5,
    "Alignment": "Principal Curvature", "CurvatureDirection": "Least Bent",
    "CurvatureScale": 3.5, "Shift": 2.5, "GuidanceVectors": "Vectors", "GuidanceWeights": "Weights",
    "GuidanceStrengths": "Strengths",
    "FeatureAngle": 20.0, "CurvatureTolerance": 0.5, "TensorArray": ["CELLS", "Stress"]}


def other_value(property):
    """A value of a property's domain that is not its default."""
    value = property.GetElement(0)
    if property.GetDomain("bool"):
        return 1 - value
    entries = property.GetDomain("enum")
    if entries:
        texts = [entries.GetEntryText(i) for i in range(entries.GetNumberOfEntries())]
        return next(texts[i] for i in range(len(texts)) if entries.GetEntryValue(i) != value)
    limits = property.GetDomain("range")
    if limits.GetMaximumExists(0) and value + 1 > limits.GetMaximum(0):
        return 0.5 * (value + limits.GetMinimum(0))
    return value + (0.25 if isinstance(value, float) else 1)


def given(field, name):
    """The value of a property; the association and the name of an array."""
    value = getattr(field, name)
    return [value.GetAssociation(), value.GetArrayName()] if name == "TensorArray" else value


def figures(field):
    surface = servermanager.Fetch(field)
    singularities = servermanager.Fetch(field, idx=1)
    data = surface.GetFieldData()
    return [data.GetArray(name).GetTuple1(0) for name in (
        "Eigenvalue", "Residual", "Lambda", "SmoothnessEnergy")] + [
        surface.GetNumberOfPoints(), singularities.GetNumberOfPoints()]


# A sphere that is cut open and stretched has a boundary, sharp edges, and points of strong curvature
# that have no vector.
mesh = Sphere(ThetaResolution=24, PhiResolution=16, EndPhi=120.0)
stretched = Transform(Input=mesh)
stretched.Transform.Scale = [1.0, 0.5, 2.0]
vectors = Calculator(Input=stretched, ResultArrayName="Vectors",
                     Function="coordsY*iHat-coordsX*jHat")
others = Calculator(Input=vectors, ResultArrayName="Others", Function="coordsZ*iHat")
weights = Calculator(Input=others, ResultArrayName="Weights", Function="coordsZ-0.5")
strengths = Calculator(Input=weights, ResultArrayName="Strengths", Function="0.5+0*coordsX")
field = DirectionField(registrationName="field", Input=strengths)
values = {name: chosen[name] if name in chosen else other_value(field.SMProxy.GetProperty(name))
          for name in field.ListProperties()
          if name != "Input" and not field.SMProxy.GetProperty(name).GetIsInternal()}
assert set(chosen) <= set(values)
for name, value in values.items():
    setattr(field, name, value)
before = figures(field)
# Each property arrives where it belongs.
described = [line.strip() for line in str(field.GetClientSideObject()).splitlines()]
for name in values:
    element = field.SMProxy.GetProperty(name).GetElement(4 if name == "TensorArray" else 0)
    line = "%s: %s" % (name, element if isinstance(element, str) else "%g" % element)
    assert line in described, (line, described)
SaveState(state)
defaults = DirectionField(Input=strengths)
for name, value in values.items():
    assert given(defaults, name) != value, name
del field, defaults, mesh, stretched, vectors, others, weights, strengths

ResetSession()
assert FindSource("field") is None
LoadState(state)
field = FindSource("field")
assert field.GetXMLName() == "DirectionField"
for name, value in values.items():
    assert given(field, name) == value, (name, given(field, name))
assert figures(field) == before, (figures(field), before)
print("passed")
