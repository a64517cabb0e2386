# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own filters and representations take the arrays as they are:
TestConsumers.py PLUGIN MESH OUTDIR"""
import os
import sys

import numpy as np
from paraview import servermanager
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

LoadPlugin(sys.argv[1], remote=False, ns=globals())
mesh, output = sys.argv[2:4]

field = DirectionField(Input=PLYReader(FileNames=[mesh]), Degree=2)
surface = servermanager.Fetch(field)
points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
direction = vtk_to_numpy(surface.GetPointData().GetArray("Direction0")).astype(float)
view = CreateRenderView()
view.ViewSize = [600, 450]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]


def gray_picture(name):
    """The picture as rows of gray values from 0 to 255."""
    from vtkmodules.vtkIOImage import vtkPNGReader
    path = os.path.join(output, name)
    SaveScreenshot(path, view, ImageResolution=view.ViewSize)
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    rgb = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(float)
    return rgb.mean(axis=1).reshape(view.ViewSize[1], view.ViewSize[0])


def stripes(gray, angle):
    """Mean change of the gray value along the angle, in degrees, in the middle of the picture."""
    step = 3.0 * np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    rows, columns = np.mgrid[175:275, 250:350]
    moved = gray[np.rint(rows + step[1]).astype(int), np.rint(columns + step[0]).astype(int)]
    return np.abs(moved - gray[175:275, 250:350]).mean()


def test_surface_lic():
    """The stripes of the line integral convolution run along the field: on a plane, whose field is
    given, they can be told from the picture."""
    plane = Plane(XResolution=20, YResolution=20)
    for wanted in (30.0, 120.0):
        c, s = np.cos(np.radians(wanted)), np.sin(np.radians(wanted))
        guide = Calculator(Input=plane, Function=f"{c}*iHat+{s}*jHat", ResultArrayName="Guide")
        given = DirectionField(Input=Triangulate(Input=guide), Degree=2, Alignment="Point Vectors",
                               GuidanceVectors="Guide", AlignmentStrength=1.0)
        display = Show(given, view)
        display.SetRepresentationType("Surface LIC")
        # No other property has to be set.
        assert list(display.SelectInputVectors) == ["POINTS", "Direction0"]
        view.ResetActiveCameraToNegativeZ()
        ResetCamera(view)
        gray = gray_picture(f"SurfaceLIC{wanted:.0f}.png")
        changes = {angle: stripes(gray, angle) for angle in range(0, 180, 30)}
        assert min(changes, key=changes.get) == wanted, changes
        assert changes[wanted] < 0.7 * changes[(wanted + 90.0) % 180.0], changes
        Hide(given, view)


def test_glyph():
    """One line for each point, along each of the directions."""
    for k in range(2):
        glyph = Glyph(Input=field, GlyphType="Line", GlyphMode="All Points", ScaleFactor=0.1,
                      OrientationArray=["POINTS", f"Direction{k}"],
                      ScaleArray=["POINTS", "No scale array"])
        lines = servermanager.Fetch(glyph)
        assert lines.GetNumberOfCells() == surface.GetNumberOfPoints()
        ends = vtk_to_numpy(lines.GetPoints().GetData()).astype(float).reshape(
            surface.GetNumberOfPoints(), -1, 3)
        along = (ends[:, -1] - ends[:, 0]) / 0.1
        expected = vtk_to_numpy(surface.GetPointData().GetArray(f"Direction{k}"))
        assert np.abs(along - expected).max() < 1e-3
        Delete(glyph)


def test_stream_tracer():
    """Streamlines of the surface stay on it and run along the field."""
    size = np.ptp(points, axis=0).max()
    seeds = MaskPoints(Input=field, OnRatio=10, MaximumNumberofPoints=1000)
    tracer = StreamTracerWithCustomSource(
        Input=field, SeedSource=seeds, Vectors=["POINTS", "Direction0"], SurfaceStreamlines=1,
        MaximumStreamlineLength=0.2 * size)
    lines = servermanager.Fetch(tracer)
    assert lines.GetNumberOfCells() > 0.5 * servermanager.Fetch(seeds).GetNumberOfPoints()
    traced = vtk_to_numpy(lines.GetPoints().GetData()).astype(float)
    offsets = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
    lengths, cosines = [], []
    for begin, end in zip(offsets[:-1], offsets[1:]):
        line = traced[ids[begin:end]]
        steps = np.diff(line, axis=0)
        lengths.append(np.linalg.norm(steps, axis=1).sum())
        nearest = np.argmin(((points - line[0]) ** 2).sum(axis=1))
        first = steps[0] / max(np.linalg.norm(steps[0]), 1e-300)
        cosines.append(abs(first @ direction[nearest]))
    assert np.median(lengths) > 0.05 * size, np.median(lengths)
    assert np.median(cosines) > 0.98, np.median(cosines)
    distance = [np.sqrt(((points - point) ** 2).sum(axis=1).min()) for point in traced[::50]]
    assert max(distance) < 0.05 * size, max(distance)
    display = Show(tracer, view)
    display.RenderLinesAsTubes = 1
    display.LineWidth = 3.0
    Show(field, view)
    ResetCamera(view)
    gray_picture("StreamTracer.png")
    HideAll(view)


def test_tensor_glyph():
    """Tensor Glyph wants tensors of nine components, which Python Calculator makes of the vectors;
    their largest eigenvector is the direction."""
    tensors = PythonCalculator(
        Input=field, ArrayName="Tensor",
        Expression="(Direction0[:,:,None] * Direction0[:,None,:] + 0.1 * numpy.eye(3))"
                   ".reshape(-1, 9)")
    array = servermanager.Fetch(tensors).GetPointData().GetArray("Tensor")
    assert array.GetNumberOfComponents() == 9
    glyph = TensorGlyph(Input=tensors, GlyphType="Sphere", Tensors=["POINTS", "Tensor"],
                        ScaleFactor=0.1)
    spheres = servermanager.Fetch(glyph)
    shape = vtk_to_numpy(spheres.GetPoints().GetData()).astype(float).reshape(
        surface.GetNumberOfPoints(), -1, 3)
    for k in range(0, len(points), 200):
        offset = shape[k] - points[k]
        longest = offset[np.argmax(np.linalg.norm(offset, axis=1))]
        assert abs(longest @ direction[k]) > 0.9 * np.linalg.norm(longest), k
        # Glyphs without thickness could not be seen.
        extents = np.linalg.svd(offset, compute_uv=False)
        assert extents[2] > 0.05 * extents[0], k


test_surface_lic()
test_glyph()
test_stream_tracer()
test_tensor_glyph()
print("passed")
