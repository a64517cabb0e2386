# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hand in ParaView's window as a sequence of images, hand0000.png and so on: strokes are drawn, one
is made soft, a singularity is dragged, and the mesh becomes quads.

    pvbatch Utilities/animation.py PLUGIN MESH OUTDIR [WIDTH]

It calls what the mouse calls, in a view of WIDTH by 3/4 WIDTH pixels, 480 by default; the places are
those of Data/Meshes/bunny.ply. Any program makes one file of the images; with ImageMagick

    convert -delay 25 -loop 0 OUTDIR/hand*.png -layers optimize -colors 64 Documentation/hand.gif

The other picture of Documentation/Hand.md is made by

    convert OUTDIR/hand0009.png OUTDIR/hand0018.png +append OUTDIR/first.png
    convert OUTDIR/hand0023.png OUTDIR/hand0034.png +append OUTDIR/second.png
    convert OUTDIR/first.png OUTDIR/second.png -append -colors 128 Documentation/hand.png

In each picture a ring is where the mouse is."""
import os
import sys

import numpy as np
from paraview import simple

plugin, mesh, output = sys.argv[1:4]
width = int(sys.argv[4]) if len(sys.argv) > 4 else 480
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields
from directionfields import singularities
from directionfields.laying import Screen
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkPolyDataMapper2D

# Ways over the view, in parts of its width and height.
STROKES = [[(0.36, 0.50), (0.44, 0.49), (0.52, 0.52), (0.60, 0.50)],
           [(0.42, 0.34), (0.50, 0.31), (0.58, 0.33), (0.65, 0.38)],
           [(0.58, 0.61), (0.65, 0.57), (0.69, 0.49), (0.70, 0.41)]]
# Near this place there is the singularity that is dragged, and where to, in parts of the width.
HELD, PULL = (0.30, 0.56), (0.012, -0.01)


class Film:
    """Takes a picture after each step."""

    def __init__(self, view):
        self.view, self.count = view, 0
        self.size = np.array(view.ViewSize, float)
        self.title = simple.Text(Text=" ")
        shown = simple.Show(self.title, view)
        shown.WindowLocation, shown.Color, shown.FontSize = "Upper Left Corner", [0.1, 0.1, 0.1], 16
        self.mouse, self.way = self.line(5.0), self.line(3.0)

    def line(self, thickness):
        data, actor, mapper = vtkPolyData(), vtkActor2D(), vtkPolyDataMapper2D()
        mapper.SetInputData(data)
        actor.SetMapper(mapper)
        actor.GetProperty().SetLineWidth(thickness)
        actor.GetProperty().SetColor(0.85, 0.45, 0.05)
        self.view.GetRenderWindow().GetRenderers().GetFirstRenderer().AddActor2D(actor)
        return data

    @staticmethod
    def put(data, places):
        points, cells = vtkPoints(), vtkCellArray()
        cells.InsertNextCell(len(places))
        for x, y in places:
            cells.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
        data.SetPoints(points)
        data.SetLines(cells if len(places) > 1 else vtkCellArray())
        data.Modified()

    def take(self, mouse=None, way=(), times=1):
        angles = np.linspace(0.0, 2.0 * np.pi, 25)
        ring = [] if mouse is None else [
            (mouse[0] + 7.0 * np.cos(a), mouse[1] + 7.0 * np.sin(a)) for a in angles]
        self.put(self.mouse, ring)
        self.put(self.way, list(way))
        for shown in self.view.Representations:
            # Words other than the title would not be read in time.
            made = shown.Input.GetXMLName() if shown.GetProperty("Input") else shown.GetXMLName()
            if made in ("PythonAnnotation", "ScalarBarWidgetRepresentation"):
                shown.Visibility = 0
            elif shown.GetProperty("ShowSummary"):
                shown.ShowSummary = 0
        simple.Render(self.view)
        for _ in range(times):
            path = os.path.join(output, f"hand{self.count:04}.png")
            simple.SaveScreenshot(path, self.view, ImageResolution=[int(x) for x in self.size])
            self.count += 1

    def say(self, text):
        self.title.Text = text


def along(path, share):
    """A way up to a share of it."""
    path = np.array(path)
    lengths = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    places = np.linspace(0.0, share * lengths[-1], 12)
    return np.c_[np.interp(places, lengths, path[:, 0]), np.interp(places, lengths, path[:, 1])]


def play(film):
    film.say("Draw strokes: the field follows")
    film.take(times=2)
    for path in STROKES:
        for share in (0.4, 0.75):
            way = along(np.array(path) * film.size, share)
            film.take(way[-1], way)
        way = along(np.array(path) * film.size, 1.0)
        if directionfields.draw_stroke([tuple(place) for place in way]) is None:
            sys.exit("There is no surface where the strokes are to be.")
        film.take(way[-1], times=2)
    film.say("A double click makes a stroke soft")
    place = along(np.array(STROKES[0]) * film.size, 0.5)[-1]
    film.take(place)
    directionfields.toggle_stroke(tuple(place))
    film.take(place, times=4)
    drag(film)
    film.say("One button to quads")
    if directionfields.remesh_active() is None:
        sys.exit("There are no quads.")
    film.take(times=8)


def drag(film):
    """A singularity goes a part of the width."""
    film.say("Edit singularities: drag one")
    trouble = singularities.begin()
    if trouble:
        sys.exit(trouble)
    hand = singularities._handles.hand
    pixels = Screen(film.view).pixels(hand.rows[:, :3])
    away = np.where(hand.seen, np.linalg.norm(pixels - np.array(HELD) * film.size, axis=1), np.inf)
    place = pixels[int(np.argmin(away))]
    singularities.press(*place)
    film.take(place, times=2)
    for _ in range(6):
        place = place + film.size[0] * np.array(PULL)
        singularities.drag(*place)
        film.take(place)
    singularities.drop()
    singularities.end()
    film.take(times=2)


view = simple.CreateView("RenderView")
view.ViewSize = [width, 3 * width // 4]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground, view.Background = 0, [1.0, 1.0, 1.0]
source = directionfields.read(mesh)
simple.SetActiveSource(source)
directionfields.show_active()
play(Film(view))
print(f"Wrote the images hand*.png to {output}.")
