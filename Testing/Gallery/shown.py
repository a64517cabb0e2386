# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Panels of the gallery that show more than glyphs of a new field: comparisons, fields of files, lines."""

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from gallery import Field, Panel, producer, turned, white_view


class ComparisonPanel(Panel):
    """The angles between two fields in colors, and lines between the singularities that match."""

    def __init__(self, one, other, camera):
        super().__init__(one.Input, one.Degree, camera)
        simple.HideAll(self.view)
        self.other = other
        self.compared = simple.CompareDirectionFields(Input=one, Other=other, Diagnostics=1)
        display = simple.Show(self.compared, self.view)
        simple.ColorBy(display, ("POINTS", "AngleDifference"))
        # ParaView 6 has another name for the same colors.
        presets = servermanager.vtkSMTransferFunctionPresets()
        old, new = "Viridis (matplotlib)", "Viridis"
        display.LookupTable.ApplyPreset(old if presets.HasPreset(old) else new, True)
        display.LookupTable.RescaleTransferFunction(0.0, 45.0)
        lines = simple.Tube(Input=simple.OutputPort(self.compared, 1), Radius=0.07)
        matches = simple.Show(lines, self.view)
        matches.ColorArrayName = ["POINTS", ""]
        matches.AmbientColor = matches.DiffuseColor = [0.84, 0.10, 0.11]

    def spoil(self):
        self.compared.Input = producer(turned(self.field))


class GivenPanel(Panel):
    """A field that was read from a file."""

    def __init__(self, proxy, camera):
        self.view = white_view()
        self.proxy = proxy
        self.field = Field(proxy)
        self.camera = camera
        for port in (0, 1):
            simple.Show(simple.OutputPort(proxy, port), self.view)
        self.glyphs = simple.DirectionFieldGlyphs(Input=proxy, MaximumNumberOfGlyphs=500)
        simple.Show(self.glyphs, self.view)

    def spoil(self):
        self.glyphs.Input = producer(turned(self.field))


class LinesPanel(Panel):
    """Lines along a field, as ParaView shows them on its own, on the surface that they follow."""

    def __init__(self, source, degree, camera, options=None, **properties):
        self.view = white_view()
        self.proxy = simple.DirectionField(Input=source, Degree=degree, Diagnostics=1, **(options or {}))
        self.field = Field(self.proxy)
        self.camera = camera
        for port in (0, 1):
            simple.Show(simple.OutputPort(self.proxy, port), self.view)
        self.lines = simple.DirectionFieldStreamlines(Input=self.proxy, Diagnostics=1, **properties)
        simple.Show(self.lines, self.view)
        self.traced = servermanager.Fetch(self.lines, idx=0)
        self.nodes = servermanager.Fetch(self.lines, idx=1)

    def array(self, name):
        return vtk_to_numpy(self.traced.GetCellData().GetArray(name))

    def spoil(self):
        self.lines.Input = producer(turned(self.field))
