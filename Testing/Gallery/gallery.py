# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a figure of the gallery, checks the numbers behind it and compares it with its baseline.

    pvpython gallery.py PLUGIN MESHES FIGURE OUTPUT BASELINE

PLUGIN and MESHES are the plugin's file and the directory of the meshes. Then the directions are turned
by ten degrees, a singularity is left out, and the figure is drawn once more, beside OUTPUT: the
comparison must find that.
"""

import importlib
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

import patterns  # beside this file

PANEL = (600, 600)
# Directions of view, up, and zoom.
BUNNY_CAMERA = ([-0.35, 0.25, 1.0], [0.0, 1.0, 0.0], 1.25)
OBLIQUE = ([0.75, -0.9, 0.75], [0.0, 0.0, 1.0], 1.1)
# In percent. What is drawn anew on this or another machine stays below the first, what is drawn of
# a field turned by ten degrees above the second.
SAME, DIFFERENT = 0.3, 0.6
# A pixel differs where a color does by more than this, of 255: edges are smoothed.
COLOR = 40
TURN = np.radians(10.0)


class Field:
    """The arrays of a computed field, fetched from its filter."""

    def __init__(self, proxy):
        self.surface = servermanager.Fetch(proxy, idx=0)
        self.singularities = servermanager.Fetch(proxy, idx=1)
        data = self.surface.GetPointData()
        self.points = vtk_to_numpy(self.surface.GetPoints().GetData()).astype(float)
        self.triangles = vtk_to_numpy(
            self.surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.index = vtk_to_numpy(self.surface.GetCellData().GetArray("SingularityIndex"))
        self.directions = []
        while data.GetArray(f"Direction{len(self.directions)}"):
            self.directions.append(
                vtk_to_numpy(data.GetArray(f"Direction{len(self.directions)}")).astype(float))
        for k, direction in enumerate(self.directions):
            lengths = np.linalg.norm(direction, axis=1)
            assert np.allclose(lengths, 1.0, atol=1e-5), f"Direction{k} is not of unit length"
        kind = data.GetArray("ConstraintKind")
        self.kind = vtk_to_numpy(kind) if kind else np.zeros(len(self.points), dtype=int)

    def figure(self, name):
        """Field data of the only component."""
        array = self.surface.GetFieldData().GetArray(name)
        assert array.GetNumberOfTuples() == 1, name
        return array.GetTuple1(0)

    def count(self):
        """Number of singularities."""
        return int(np.count_nonzero(self.index))

    def check_sum(self, closed=True):
        assert self.singularities.GetNumberOfPoints() == self.count()
        assert self.index.sum() == self.figure("IndexSum")
        if closed:
            expected = len(self.directions) * self.figure("EulerCharacteristic")
            assert self.index.sum() == expected, (self.index.sum(), expected)

    def deviation(self, axis):
        """Angle in degrees from an axis, or one for each point, to the nearest direction."""
        axis = np.broadcast_to(axis, self.points.shape)
        axis = axis / np.linalg.norm(axis, axis=1, keepdims=True)
        cosines = np.max([np.sum(d * axis, axis=1) for d in self.directions], axis=0)
        return np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0)))


def bunny(directory):
    return simple.PLYReader(FileNames=[os.path.join(directory, "bunny.ply")])


def producer(mesh):
    """A source of a vtkPolyData."""
    proxy = simple.TrivialProducer()
    proxy.GetClientSideObject().SetOutput(mesh)
    return proxy


def turned(field):
    """The surface of a field with all directions turned about the normal."""
    mesh = vtkPolyData()
    mesh.ShallowCopy(field.surface)
    a, b, c = (field.points[field.triangles[:, k]] for k in range(3))
    normals = np.zeros_like(field.points)
    for k in range(3):
        np.add.at(normals, field.triangles[:, k], np.cross(b - a, c - a))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    for k, direction in enumerate(field.directions):
        vectors = np.cos(TURN) * direction + np.sin(TURN) * np.cross(normals, direction)
        array = numpy_to_vtk(np.ascontiguousarray(vectors), deep=True)
        array.SetName(f"Direction{k}")
        mesh.GetPointData().AddArray(array)
    return mesh


def without_one(singularities):
    """The singularities but the first."""
    mesh = vtkPolyData()
    mesh.ShallowCopy(singularities)
    verts = vtkCellArray()
    for point in range(1, singularities.GetNumberOfPoints()):
        verts.InsertNextCell(1)
        verts.InsertCellPoint(point)
    mesh.SetVerts(verts)
    return mesh


def white_view():
    """The view of one panel: white, and without ParaView's axes."""
    view = simple.CreateRenderView()
    view.ViewSize = PANEL
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    return view


def without_summaries(view):
    """Leaves out what the displays write into a view: what a panel shows is said below it."""
    for display in view.Representations:
        if display.GetProperty("ShowSummary"):
            display.ShowSummary = 0


class Panel:
    """A picture of a field, one of the parts of a figure."""

    def __init__(self, source, degree, camera, glyphs=500, **properties):
        self.view = white_view()
        import directionfields
        self.picture = directionfields.show(
            source, degree, self.view, glyphs={"MaximumNumberOfGlyphs": glyphs}, legend=False,
            Diagnostics=1, **properties)
        self.proxy = self.picture.field
        self.field = Field(self.proxy)
        self.camera = camera

    def spoil(self):
        self.picture.glyphs.Input = producer(turned(self.field))
        if self.field.count() > 0:
            display = simple.GetRepresentation(simple.OutputPort(self.proxy, 1), self.view)
            display.Input = producer(without_one(self.field.singularities))

    def image(self, path):
        position, up, zoom = self.camera
        self.view.CameraPosition = position
        self.view.CameraFocalPoint = [0.0, 0.0, 0.0]
        self.view.CameraViewUp = up
        simple.ResetCamera(self.view)
        self.view.CameraParallelProjection = 1
        self.view.CameraParallelScale /= zoom
        without_summaries(self.view)
        simple.Render(self.view)
        simple.SaveScreenshot(path, self.view, ImageResolution=PANEL)
        image = read(path)
        os.remove(path)
        return image


def read(path):
    """The colors of a PNG file, rows from below."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[..., :3]


def write(image, path):
    rows, columns, _ = image.shape
    data = vtkImageData()
    data.SetDimensions(columns, rows, 1)
    data.GetPointData().SetScalars(
        numpy_to_vtk(np.ascontiguousarray(image).reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.Write()


def difference(image, baseline):
    """How much of the picture differs, in percent."""
    expected = read(baseline)
    if expected.shape != image.shape:
        return 100.0
    steps = np.abs(image.astype(int) - expected.astype(int)).max(axis=-1)
    return 100.0 * np.count_nonzero(steps > COLOR) / steps.size


def tiles(image):
    """The panels of a picture."""
    columns, rows = PANEL
    return [image[y:y + rows, x:x + columns]
            for y in range(0, image.shape[0], rows) for x in range(0, image.shape[1], columns)]


def compare(name, panels, image, baseline):
    """How much a picture differs from its baseline, and the most that it may and the least that a wrong one must."""
    if not getattr(panels[0], "is_pattern", False):
        percent = difference(image, baseline)
        print(f"{name}: {percent:.3f} % differ")
        return percent, SAME, DIFFERENT
    expected = read(baseline)
    turns = ([patterns.turn(a, b, panel.cell) for a, b, panel in zip(tiles(image), tiles(expected), panels)]
             if expected.shape == image.shape else [45.0])
    print(f"{name}: turned by {', '.join(f'{turn:.2f}' for turn in turns)} degrees")
    return max(turns), patterns.SAME, patterns.DIFFERENT


def draw(panels, output):
    """The picture of all panels, which is written to a file."""
    images = [panel.image(output + f".{k}.png") for k, panel in enumerate(panels)]
    # Four panels in two rows, the first above.
    rows = [images[2:], images[:2]] if len(images) == 4 else [images]
    image = np.concatenate([np.concatenate(row, axis=1) for row in rows], axis=0)
    write(image, output)
    return image


def main(plugin, meshes, name, output, baseline):
    simple.LoadPlugin(plugin, ns=simple.__dict__)
    figure = importlib.import_module("figures").FIGURES[name]
    panels = figure(meshes)
    image = draw(panels, output)
    if not os.path.exists(baseline):
        sys.exit(f"There is no baseline {baseline}.")
    found, most, _ = compare(name, panels, image, baseline)
    if found > most:
        sys.exit(f"{output} is not like {baseline}.")

    for panel in panels:
        panel.spoil()
    spoiled = draw(panels, output.replace(".png", "Spoiled.png"))
    # The driver does not like several windows to be there at the end.
    for panel in panels:
        simple.Delete(panel.view)
    found, _, least = compare(name + ", spoiled", panels, spoiled, baseline)
    if found < least:
        sys.exit("The comparison does not see that the field is wrong.")


if __name__ == "__main__":
    main(*sys.argv[1:])
