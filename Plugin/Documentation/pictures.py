# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of the help pages: pvbatch pictures.py PLUGIN MESH [NAME.png ...]

remesh.png and tensors.png are not among them: they are parts of the gallery's figures Remeshed and Stress."""
import os
import sys
import tempfile

from paraview import simple
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkImagingCore import vtkImageShrink3D

SIZE = (230, 230)
FACTOR = 3

simple.LoadPlugin(sys.argv[1], remote=False)
import directionfields


def tile(append, mesh, folder, after=None, glyphs=None, **options):
    view = simple.CreateView("RenderView", ViewSize=SIZE, OrientationAxesVisibility=0,
                             UseColorPaletteForBackground=0, Background=[1.0, 1.0, 1.0])
    glyphs = {"MaximumNumberOfGlyphs": 500, **(glyphs or {})}
    shown = directionfields.show(mesh, view=view, legend=False, glyphs=glyphs, **options)
    if after:
        after(shown)
    add(append, view, folder)
    return shown


def add(append, view, folder):
    """Adds a picture of a view, which is deleted, to a row of pictures."""
    path = os.path.join(folder, f"{append.GetNumberOfInputConnections(0)}.png")
    for display in view.Representations:
        if display.GetProperty("ShowSummary"):
            display.ShowSummary = 0
    simple.SaveScreenshot(path, view, ImageResolution=[FACTOR * pixels for pixels in SIZE])
    reader = vtkPNGReader()
    reader.SetFileName(path)
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(reader.GetOutputPort())
    shrink.SetShrinkFactors(FACTOR, FACTOR, 1)
    shrink.AveragingOn()
    shrink.Update()
    append.AddInputConnection(shrink.GetOutputPort())
    simple.Delete(view)


def draw(name, mesh, choices, tile=tile):
    if sys.argv[3:] and name not in sys.argv[3:]:
        return
    with tempfile.TemporaryDirectory() as folder:
        append = vtkImageAppend()
        for options in choices:
            tile(append, options.pop("mesh", mesh), folder, **options)
        writer = vtkPNGWriter()
        writer.SetInputConnection(append.GetOutputPort())
        writer.SetFileName(os.path.join(os.path.dirname(os.path.abspath(__file__)), name))
        writer.Write()


def lines_tile(append, mesh, folder, degree, **options):
    """A tile with lines in place of glyphs."""
    view = simple.CreateView("RenderView", ViewSize=SIZE, OrientationAxesVisibility=0,
                             UseColorPaletteForBackground=0, Background=[1.0, 1.0, 1.0])
    field = simple.DirectionField(Input=mesh, Degree=degree)
    simple.Show(field, view)
    simple.Show(simple.DirectionFieldStreamlines(Input=field, **options), view).LineWidth = 3.0
    simple.ResetCamera(view)
    add(append, view, folder)


def stripes_tile(append, mesh, folder, degree, isWeave=False, **options):
    """A tile with stripes in two colors, and lines across them for a weave."""
    view = simple.CreateView("RenderView", ViewSize=SIZE, OrientationAxesVisibility=0,
                             UseColorPaletteForBackground=0, Background=[1.0, 1.0, 1.0])
    field = simple.DirectionField(Input=mesh, Degree=degree)
    simple.Show(simple.OutputPort(simple.StripePattern(Input=field, **options), 1), view)
    if isWeave:
        weft = simple.StripePattern(Input=field, StripeDirection="Across Field", Bands=0, **options)
        simple.Show(weft, view).DiffuseColor = [0.85, 0.51, 0.18]
    simple.ResetCamera(view)
    add(append, view, folder)


mesh = directionfields.read(sys.argv[2])
draw("degrees.png", mesh, [{"degree": degree} for degree in (1, 2, 4)])
draw("alignment.png", mesh, [{"Alignment": "Principal Curvature", "AlignmentStrength": strength}
                             for strength in (0.0, 0.5, 0.9)])
ring = simple.Triangulate(Input=simple.Disk(RadialResolution=12, CircumferentialResolution=72))
draw("boundary.png", ring, [{"degree": 2, "ConstrainBoundary": on} for on in (0, 1)])

# A curve around the bunny, shown as a tube.
curve = simple.Slice(Input=mesh, SliceType="Plane")
curve.SliceType.Normal = [1.0, 0.8, 0.3]


def show_curve(shown):
    display = simple.Show(simple.Tube(Input=curve, Radius=0.09), shown.view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0.85, 0.51, 0.18]


guided = simple.GuidanceFromCurves(Input=mesh, Curves=curve, Degree=4)
draw("curves.png", mesh, [
    {}, {"mesh": guided, "ConstrainGuidance": 1, "GuidanceVectors": "GuidanceVectors",
         "GuidanceWeights": "GuidanceWeights", "after": show_curve}])

# Two fields, and the angles between them.
fields = []


def compare(shown):
    simple.HideAll(shown.view)
    compared = simple.CompareDirectionFields(Input=fields[0].field, Other=fields[1].field)
    display = simple.Show(compared, shown.view)
    simple.ColorBy(display, ("POINTS", "AngleDifference"))
    display.LookupTable.ApplyPreset("Viridis (matplotlib)", True)
    display.LookupTable.RescaleTransferFunction(0.0, 45.0)


draw("comparison.png", mesh, [
    {"after": fields.append}, {"Alignment": "Principal Curvature", "after": fields.append},
    {"after": compare}])
draw("lines.png", mesh, [{"degree": 2}, {"degree": 4},
                         {"degree": 4, "SeedType": "Singularities", "StopAtCrossings": 1}],
     lines_tile)
draw("stripes.png", mesh, [{"degree": 1}, {"degree": 2, "Spacing": 0.25},
                           {"degree": 2, "isWeave": True}], stripes_tile)


def edges_tile(append, mesh, folder):
    """A tile with the triangles of a mesh."""
    view = simple.CreateView("RenderView", ViewSize=SIZE, OrientationAxesVisibility=0,
                             UseColorPaletteForBackground=0, Background=[1.0, 1.0, 1.0])
    display = simple.Show(mesh, view, "GeometryRepresentation")
    display.SetRepresentationType("Surface With Edges")
    simple.ResetCamera(view)
    add(append, view, folder)


draw("glyphs.png", mesh, [{"degree": 4, "glyphs": {"GlyphType": kind}}
                          for kind in ("Lines", "Ribbons", "Tubes")])

# The singularities of one field given to another.
free = simple.DirectionField(Input=mesh)
fewer = simple.DirectionField(Input=mesh, UnitLength=1, SingularityCost=1.0)
edited = simple.EditSingularities(Input=free, Singularities=simple.OutputPort(fewer, 1))
draw("editing.png", mesh, [{"mesh": free}, {"mesh": edited}])

# A file of one direction for each triangle, and what is made of it.
with tempfile.TemporaryDirectory() as folder:
    simple.SaveData(os.path.join(folder, "mesh.rosy"), proxy=free)
    plain = directionfields.read(os.path.join(folder, "mesh.obj"))
    given = simple.ReadDirectionField(Input=plain, FileName=os.path.join(folder, "mesh.rosy"))
    draw("files.png", plain, [{"draw": edges_tile, "mesh": plain}, {"mesh": given}],
         lambda append, mesh, folder, draw=tile, **options: draw(append, mesh, folder, **options))
