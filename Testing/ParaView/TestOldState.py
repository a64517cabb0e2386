# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A state file that ParaView 5.11 has written opens in this version: TestOldState.py PLUGIN STATE OUTDIR

STATE is compressed by gzip. "TestOldState.py PLUGIN STATE" writes such a file, if there is none."""
import gzip
import os
import sys

from paraview import servermanager, simple

from Figures import blue, pixels, red

plugin, state = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False)
import directionfields

VALUES = {"Degree": 3, "EnergyBias": -0.25, "Solver": "Direct", "MergePoints": "On",
          "ConstrainBoundary": 1, "ConstraintSolver": "Least Squares"}


def write():
    mesh = simple.Sphere(ThetaResolution=24, PhiResolution=16, EndPhi=120.0)
    options = {name: value for name, value in VALUES.items() if name != "Degree"}
    directionfields.show(mesh, VALUES["Degree"], **options)
    simple.SaveState("state.pvsm")
    with open("state.pvsm", "rb") as file, gzip.open(state, "wb") as compressed:
        compressed.write(file.read())


def check(directory):
    plain = os.path.join(directory, "OldState.pvsm")
    with gzip.open(state) as compressed, open(plain, "wb") as file:
        file.write(compressed.read())
    simple.LoadState(plain)
    field = simple.FindSource("DirectionField1")
    assert field.GetXMLName() == "DirectionField"
    for name, value in VALUES.items():
        assert getattr(field, name) == value, (name, getattr(field, name))
    same = simple.DirectionField(Input=field.Input, **VALUES)
    for port in (0, 1):
        found, expected = (servermanager.Fetch(f, idx=port) for f in (field, same))
        assert found.GetNumberOfPoints() == expected.GetNumberOfPoints()
        name = ("Direction0", "Index")[port]
        for k in range(found.GetNumberOfPoints()):
            assert (found.GetPointData().GetArray(name).GetTuple(k)
                    == expected.GetPointData().GetArray(name).GetTuple(k)), (name, k)
    simple.Delete(same)
    # The whole picture is back: surface, glyphs and spheres at the singularities.
    view = simple.GetActiveViewOrCreate("RenderView")
    assert simple.GetRepresentation(simple.FindSource("DirectionFieldGlyphs1"), view).Visibility == 1
    assert simple.GetRepresentation(field, view).Visibility == 1
    spheres = simple.GetRepresentation(simple.OutputPort(field, 1), view)
    assert spheres.Visibility == 1 and spheres.Representation == "3D Glyphs"
    path = os.path.join(directory, "OldState.png")
    simple.SaveScreenshot(path, view, ImageResolution=[800, 600])
    counts = pixels(path, red), pixels(path, blue)
    assert max(counts) > 100, counts
    # A new picture takes the place of the old one's caption, too.
    for mesh in (simple.Cone(), field):
        directionfields.show(mesh, view=view)
        captions = [name for (name, _), source in simple.GetSources().items()
                    if source.GetXMLName() == "PythonAnnotation" and
                    view.FindRepresentation(source.SMProxy, 0) and
                    simple.GetRepresentation(source, view).Visibility]
        assert len(captions) == 1, captions


if os.path.exists(state):
    check(sys.argv[3])
    print("passed")
else:
    write()
