# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: checks the pipeline that the playback has built in the ParaView window."""
import os
import traceback

from paraview import servermanager
from paraview.simple import *


def check():
    # Names tell the mesh, through other filters of the plugin, and are not given twice.
    another = FindSource("Field of bunny.ply (2)")
    field = FindSource("Field of bunny.ply")
    assert another and another.Input == field, list(GetSources())
    Delete(another)
    SetActiveSource(field)
    assert field.GetXMLName() == "DirectionField", field.GetXMLName()
    assert field.Input.GetXMLName() == "PLYReader", field.Input.GetXMLName()
    # The playback has set the degree and the edges in the panel, and left the iterations alone.
    assert field.Degree == 2, field.Degree
    assert field.MaximumIterations == 200, field.MaximumIterations
    assert field.ConstrainSharpEdges == 1, field.ConstrainSharpEdges
    assert field.FeatureAngle == 70.0, field.FeatureAngle
    # The alignment was chosen before the degree passed through 3, which has none to curvature.
    assert field.Alignment == "Principal Curvature", field.Alignment

    surface = servermanager.Fetch(field)
    names = [surface.GetPointData().GetArrayName(i)
             for i in range(surface.GetPointData().GetNumberOfArrays())]
    for k in range(2):
        assert "Direction%d" % k in names, names
    summary = surface.GetFieldData().GetAbstractArray("Summary").GetValue(0)
    assert "not converged" not in summary, summary
    singularities = servermanager.Fetch(field, idx=1)
    index = singularities.GetPointData().GetArray("SingularityIndex")
    total = sum(int(index.GetTuple1(i)) for i in range(index.GetNumberOfTuples()))
    assert f"index sum {total}" in summary, (total, summary)
    assert singularities.GetNumberOfPoints() > 0

    view = GetActiveView()
    assert GetDisplayProperties(field, view).Visibility == 1
    HideAll(view)
    display = Show(field, view)
    ColorBy(display, ("POINTS", "RepresentationMagnitude"))
    glyph = Glyph(Input=field, GlyphType="Arrow")
    glyph.GlyphMode = "All Points"
    assert list(glyph.OrientationArray) == ["POINTS", "Direction0"], list(glyph.OrientationArray)
    glyph.ScaleArray = ["POINTS", "No scale array"]
    bounds = surface.GetBounds()
    glyph.ScaleFactor = 0.03 * (bounds[1] - bounds[0])
    Show(glyph, view)
    points = Show(OutputPort(field, 1), view)
    points.SetRepresentationType("Points")
    points.PointSize = 12
    points.RenderPointsAsSpheres = 1
    ColorBy(points, ("POINTS", "SingularityIndex"))
    ResetCamera(view)
    SaveScreenshot(os.path.join(output, "Window.png"), view, ImageResolution=[800, 600])


output = os.environ["DIRECTIONFIELDS_TEST_OUTPUT"]
verdict = "passed\n"
try:
    check()
except BaseException:
    verdict = traceback.format_exc()
with open(os.path.join(output, "Window.txt"), "w") as file:
    file.write(verdict)
