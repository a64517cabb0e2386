# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs an example page and compares a picture of its results: TestPictures.py PAGE BASELINE OUTPUT"""

import doctest
import os
import sys

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, brings the classes that draw
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

WHITE, DARK, RED, BLUE = (0.93, 0.93, 0.9), (0.15, 0.2, 0.35), (0.75, 0.1, 0.15), (0.1, 0.35, 0.7)
# By how much a picture may differ from the baseline, as a share of how much it does without its lines. With
# another compiler, rounding decides otherwise between starts of lines that are equally good on symmetric
# surfaces: 5 % have been seen.
MOST_DIFFERENCE = 0.1


def cells(offsets, corners):
    result = vtkCellArray()
    result.SetData(numpy_to_vtkIdTypeArray(np.asarray(offsets, np.int64), deep=True),
                   numpy_to_vtkIdTypeArray(np.asarray(corners, np.int64), deep=True))
    return result


def polydata(points, polygons=None, lines=None):
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    if polygons is not None:
        size = polygons.shape[1]
        mesh.SetPolys(cells(np.arange(len(polygons) + 1) * size, polygons.ravel()))
    if lines is not None:
        mesh.SetLines(cells(lines, np.arange(len(points))))
    return mesh


class Panel:
    def __init__(self, window, number, of, position, up):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.renderer.SetViewport(number / of, 0, (number + 1) / of, 1)
        window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*position)
        camera.SetViewUp(*up)

    def add(self, mesh, color, edges=False):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetEdgeVisibility(edges)
        actor.GetProperty().SetEdgeColor(*DARK)
        self.renderer.AddActor(actor)
        return actor

    def tubes(self, points, offsets, radius, color=DARK):
        tubes = vtkTubeFilter()
        tubes.SetInputData(polydata(points, lines=offsets))
        tubes.SetRadius(radius)
        tubes.SetNumberOfSides(8)
        tubes.Update()
        return self.add(tubes.GetOutput(), color)

    def strokes(self, middles, directions, length, radius, color=DARK):
        arms = 0.5 * length * directions
        ends = np.stack([middles - arms, middles + arms], axis=1).reshape(-1, 3)
        self.tubes(ends, 2 * np.arange(len(middles) + 1), radius, color)


def smooth(points, triangles):
    normals = vtkPolyDataNormals()
    normals.SetInputData(polydata(points, triangles))
    normals.SplittingOff()
    normals.Update()
    return normals.GetOutput()


def quads(window, of_page):
    field, lines, mesh = of_page["field"], of_page["lines"], of_page["quads"]
    panels = [Panel(window, k, 3, (-0.35, 0.25, 1.0), (0, 1, 0)) for k in range(3)]
    for panel in panels[:2]:
        panel.add(smooth(field.points, field.triangles), WHITE)
    for sign, color in ((1, RED), (-1, BLUE)):
        places = of_page["places"][np.sign(field.indices[field.singularities]) == sign]
        for axis in np.eye(3):
            panels[0].strokes(places, np.tile(axis, (len(places), 1)), 0.2, 0.1, color)
    panels[1].tubes(lines.points, lines.offsets, 0.02)
    panels[2].add(polydata(mesh.points, mesh.faces), WHITE, edges=True)
    return panels


def fibres(window, of_page):
    field, elements = of_page["field"], of_page["quads"]
    panels = [Panel(window, k, 2, (0, 0, 1), (0, 1, 0)) for k in range(2)]
    panels[0].add(polydata(field.points, field.triangles), WHITE)
    lines = of_page["df"].streamlines(field, spacing=0.12)
    panels[0].tubes(lines.points, lines.offsets, 0.01)
    panels[1].add(polydata(of_page["points"], elements), WHITE, edges=True)
    middles = of_page["points"][elements].mean(axis=1) + [0, 0, 0.02]
    panels[1].strokes(middles, of_page["direction"], 0.09, 0.012, RED)
    return panels


def compare(image, baseline):
    difference = vtkImageDifference()
    reader = vtkPNGReader()
    reader.SetFileName(baseline)
    difference.SetInputConnection(reader.GetOutputPort())
    difference.SetImageData(image)
    difference.Update()
    return difference.GetThresholdedError()


def main(page, baseline, output):
    with open(page, encoding="utf-8") as text:
        test = doctest.DocTestParser().get_doctest(text.read(), {}, page, page, 0)
    runner = doctest.DocTestRunner()
    runner.run(test, clear_globs=False)
    if runner.failures:
        sys.exit(1)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    make = quads if "Quads" in page else fibres
    panels = make(window, test.globs)
    window.SetSize(500 * len(panels), 500)
    for panel in panels:
        panel.renderer.ResetCamera()
        panel.renderer.GetActiveCamera().Zoom(1.25)
    errors = []
    for spoil in (False, True):
        if spoil:
            panels[-2].renderer.GetActors().GetLastActor().VisibilityOff()
        window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.Update()
        if not spoil:
            writer = vtkPNGWriter()
            writer.SetFileName(output)
            writer.SetInputConnection(grab.GetOutputPort())
            writer.Write()
        errors.append(compare(grab.GetOutput(), baseline) if os.path.exists(baseline) else np.nan)
    print(f"difference {errors[0]:.2f}, without the lines {errors[1]:.2f}")
    sys.exit(not errors[0] <= MOST_DIFFERENCE * errors[1])


if __name__ == "__main__":
    main(*sys.argv[1:])
