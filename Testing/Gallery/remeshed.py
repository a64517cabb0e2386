# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A panel of the gallery that shows the mesh which Field Aligned Remesh makes, with the numbers of its faces."""

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from gallery import Panel, white_view


class RemeshedPanel(Panel):
    """The new mesh of a surface with the edges of its faces, as Apply alone shows it, and its irregular vertices."""
    least_marks = 0

    def __init__(self, source, camera, **properties):
        self.view = white_view()
        self.proxy = simple.FieldAlignedRemesh(Input=source, Diagnostics=1, **properties)
        self.camera = camera
        self.mesh = servermanager.Fetch(self.proxy)
        self.points = vtk_to_numpy(self.mesh.GetPoints().GetData()).astype(float)
        polys = self.mesh.GetPolys()
        self.ids = vtk_to_numpy(polys.GetConnectivityArray())
        self.offsets = vtk_to_numpy(polys.GetOffsetsArray())
        self.sizes = np.diff(self.offsets)
        display = simple.Show(self.proxy, self.view)
        display.SetRepresentationType("Surface With Edges")
        display.ColorArrayName = [None, ""]
        simple.Show(simple.OutputPort(self.proxy, 1), self.view)

    def image(self, path):
        image = super().image(path)
        # Red and blue, and so many pixels that no irregular vertex is behind the faces around it.
        r, g, b = np.moveaxis(image.astype(int), -1, 0)
        marks = np.count_nonzero(((r > b + 60) & (r > g + 60)) | ((b > r + 60) & (b > g + 40)))
        assert marks >= self.least_marks, marks
        return image

    def number(self, name, component=0):
        return self.mesh.GetFieldData().GetArray(name).GetComponent(0, component)

    def least_quality(self):
        """The least scaled Jacobian of all faces."""
        return vtk_to_numpy(self.mesh.GetCellData().GetArray("ScaledJacobian")).min()

    def edges(self):
        """The middles of the sides of all faces, and their lengths."""
        nexts = np.arange(len(self.ids)) + 1
        nexts[self.offsets[1:] - 1] = self.offsets[:-1]
        a, b = self.points[self.ids], self.points[self.ids[nexts]]
        return 0.5 * (a + b), np.linalg.norm(b - a, axis=1)

    def check(self, corners, part):
        """So many faces have the wanted number of corners, and handles and boundaries are those of the surface."""
        assert np.mean(self.sizes == corners) >= part, np.mean(self.sizes == corners)
        assert self.number("EulerCharacteristic") == self.number("EulerCharacteristic", 1)
        return vtk_to_numpy(self.mesh.GetPointData().GetArray("VertexKind"))

    def check_irregular(self):
        """Most irregular vertices are singularities of the field, or corners."""
        kind = vtk_to_numpy(self.mesh.GetPointData().GetArray("VertexKind"))
        index = vtk_to_numpy(self.mesh.GetPointData().GetArray("FieldIndex"))
        wanted = np.count_nonzero((index != 0) | (kind == 3))
        assert self.number("IrregularVertices") <= 1.3 * wanted + 4, wanted

    def spoil(self):
        """Vertices where the map has them, and fewer faces: some are folded, which a warning says."""
        self.proxy.GetClientSideObject().AddObserver("WarningEvent", lambda *_: None)
        self.proxy.SmoothingIterations = 0
        self.proxy.NumberOfFaces = int(0.8 * self.proxy.NumberOfFaces)
