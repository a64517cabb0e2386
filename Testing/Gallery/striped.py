# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The panels of the figures of stripes."""

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from eigenstripes import EigenStripes
from gallery import Field, Panel, producer, turned, white_view


class StripePanel:
    """Stripes on a field, in two colors, with the lines of others on top if there are any."""
    # Rounding decides where stripes branch: pictures are compared by how they run.
    is_pattern = True
    # ... in cells of this many pixels.
    cell = 50

    def __init__(self, field, camera, lines=None, **properties):
        self.view = white_view()
        self.field = Field(field)
        self.camera = camera
        self.stripes = simple.StripePattern(Input=field, Diagnostics=1, **properties)
        simple.Show(simple.OutputPort(self.stripes, 1), self.view)
        if lines:
            display = simple.Show(lines, self.view)
            display.AmbientColor = display.DiffuseColor = [0.85, 0.51, 0.18]

    def spoil(self):
        self.stripes.Input = producer(turned(self.field))

    def figure(self, name):
        return servermanager.Fetch(self.stripes).GetFieldData().GetArray(name).GetTuple1(0)

    def share(self):
        """The length of the lines over the one that area and spacing ask for."""
        length = vtk_to_numpy(servermanager.Fetch(self.stripes).GetCellData().GetArray("Length")).sum()
        a, b, c = (self.field.points[self.field.triangles[:, k]] for k in range(3))
        area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
        return length * self.figure("Spacing") / area

    image = Panel.image


class EigenStripesPanel(StripePanel):
    """The smallest eigenvector's stripes across a field on a plane surface."""

    def __init__(self, field, camera, spacing):
        super().__init__(field, camera, StripeDirection="Across Field", Spacing=spacing)
        self.spacing = spacing
        simple.Hide(simple.OutputPort(self.stripes, 1), self.view)
        self.eigen = self.draw(self.field.directions[0])

    def draw(self, directions):
        eigen = EigenStripes(self.field.points, self.field.triangles, directions, self.spacing)
        self.bands = producer(eigen.bands())
        display = simple.Show(self.bands, self.view)
        # The colors are those of Stripe Pattern.
        simple.ColorBy(display, ("CELLS", "Stripe"))
        display.SetScalarBarVisibility(self.view, False)
        display.Ambient, display.Diffuse = 1.0, 0.0
        display.LookupTable = simple.GetRepresentation(
            simple.OutputPort(self.stripes, 1), self.view).LookupTable
        return eigen

    def spoil(self):
        simple.Hide(self.bands, self.view)
        self.draw(vtk_to_numpy(turned(self.field).GetPointData().GetArray("Direction0")))
