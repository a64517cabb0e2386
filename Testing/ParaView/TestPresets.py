# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The presets of fields: TestPresets.py PLUGIN MESH"""
import sys

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow

import Messages

plugin, mesh = sys.argv[1:3]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields
from directionfields import presets

messages = []


def words(field):
    data = servermanager.Fetch(field).GetFieldData()
    assert not data.HasArray("Warnings"), data.GetAbstractArray("Warnings").GetValue(0)
    return data.GetAbstractArray("Summary").GetValue(0)


def test_kinds():
    """On a scan, a plane and a part each preset gives a field without a warning, and
    leaves on what the surface has."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [200, 150]
    for make, boundary, edges in (
            (lambda: simple.PLYReader(FileNames=[mesh]), 0, 1),
            (lambda: simple.Plane(XResolution=8, YResolution=8), 1, 0),
            (lambda: simple.Box(), 0, 1)):
        source, made = make(), None
        for name in presets.PRESETS:
            simple.SetActiveSource(source)
            field = directionfields.apply_preset(name)
            assert field is not None and not messages, (name, messages)
            # There is one field, which each of them changes.
            assert made is None or field.SMProxy == made.SMProxy
            made = field
            degree = 2 if name == "Fibres" else 4
            text = words(field)
            assert field.Degree == degree and field.UnitLength, name
            assert field.ConstrainBoundary == (boundary and name != "Fibres"), (name, text)
            assert field.ConstrainSharpEdges == (edges and name == "CAD part"), (name, text)
            assert simple.GetRepresentation(simple.OutputPort(field, 0), view) is not None
        for source in reversed(directionfields.pipeline.sources()):
            simple.Delete(source)


def test_groups():
    """What changes nothing on the blocks of a group within a group is left off, too."""
    simple.CreateView("RenderView").ViewSize = [200, 150]
    balls = [simple.Sphere(), simple.Sphere(Center=[2.0, 0.0, 0.0])]
    group = simple.GroupDatasets(Input=[simple.GroupDatasets(Input=balls)])
    simple.SetActiveSource(group)
    field = directionfields.apply_preset("Sheet")
    assert field is not None and not messages, messages
    assert not field.ConstrainBoundary
    for source in reversed(directionfields.pipeline.sources()):
        simple.Delete(source)


def test_refused():
    """A wrong name, no mesh, and a mesh that has no field leave everything as it was."""
    simple.SetActiveSource(None)
    for source, name, text in ((None, "Scan", "no mesh"), (None, "Cloth", "no preset Cloth"),
                               (simple.Line(), "Scan", "no direction field")):
        simple.SetActiveSource(source)
        before = len(simple.GetSources())
        assert directionfields.apply_preset(name) is None
        assert len(messages) == 1 and text in messages[0], messages
        assert messages.pop().startswith("Direction field preset: ")
        assert len(simple.GetSources()) == before


window = Messages.collect(messages)
try:
    test_kinds()
    test_groups()
    test_refused()
finally:
    vtkOutputWindow.SetInstance(window)
print("passed")
