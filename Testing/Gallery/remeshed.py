# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A panel of the gallery that shows the mesh which Field Aligned Remesh makes, with the numbers of its faces."""

import os

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import meshes
from gallery import BUNNY_CAMERA, OBLIQUE, Panel, bunny, producer, white_view


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


def remeshed(directory):
    """Meshes of a scan, of a part with its features, of triangles, and of faces smaller on one side."""
    part = simple.STLReader(FileNames=[os.path.join(directory, "bracket.stl")])
    scan = RemeshedPanel(bunny(directory), BUNNY_CAMERA, NumberOfFaces=2500)
    scan.check(4, 0.98)
    bracket = RemeshedPanel(
        part, ([0.75, -0.9, 0.75], [0.0, 0.0, 1.0], 0.85), NumberOfFaces=1500)
    kind = bracket.check(4, 0.99)
    assert np.count_nonzero(kind == 2) > 100 and np.count_nonzero(kind == 3) >= 8, kind
    hexagonal = RemeshedPanel(producer(meshes.torus()), OBLIQUE, Element="Triangles",
                              NumberOfFaces=3000)
    hexagonal.check(3, 1.0)
    for panel in (scan, bracket, hexagonal):
        panel.check_irregular()
    # Nine corners are in view, of 8 x 8 pixels less the edges on them.
    bracket.least_marks = 300
    _, lengths = hexagonal.edges()
    assert np.std(lengths) < 0.2 * np.mean(lengths), np.std(lengths) / np.mean(lengths)
    sized = simple.Calculator(Input=bunny(directory), ResultArrayName="Size",
                              Function="2^(-coordsY/9.66)")
    # A field that is drawn nowhere leaves the sizes the most room.
    sizing = RemeshedPanel(
        sized, BUNNY_CAMERA, SizingArray="Size", NumberOfFaces=2500, Alignment="Smooth")
    sizing.check(4, 0.97)
    middles, lengths = sizing.edges()
    # Edges are as long as they are asked to be.
    slope = np.polyfit(-middles[:, 1] / 9.66, np.log2(lengths), 1)[0]
    assert 0.85 < slope < 1.1, slope
    return [scan, bracket, hexagonal, sizing]
