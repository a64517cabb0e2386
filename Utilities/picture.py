# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a direction field: the surface, stars of all n directions, and the singularities."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import (
    vtkGlyph3D, vtkPolyDataNormals, vtkTriangleFilter, vtkTubeFilter)
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkImagingCore import vtkImageShrink3D

SIZE = (1600, 1200)
STARS = 1200
SURFACE_COLOR = (0.93, 0.91, 0.87)
STAR_COLOR = (0.00, 0.42, 0.46)
TEXT_COLOR = (0.15, 0.15, 0.17)
POSITIVE_COLOR = (0.84, 0.10, 0.11)
NEGATIVE_COLOR = (0.09, 0.30, 0.86)


def normalized(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def nearest(points, targets):
    """For each point the number of the nearest target."""
    return np.argmin(np.sum(targets ** 2, axis=1) - 2.0 * points @ targets.T, axis=1)


class Surface:
    """The triangles of a field, as arrays."""

    def __init__(self, field, degree):
        triangulate = vtkTriangleFilter()
        triangulate.SetInputData(field)
        triangulate.PassVertsOff()
        triangulate.PassLinesOff()
        triangulate.Update()
        normals = vtkPolyDataNormals()
        normals.SetInputConnection(triangulate.GetOutputPort())
        normals.SplittingOff()
        normals.ConsistencyOff()
        normals.Update()
        self.polydata = normals.GetOutput()
        self.degree = degree
        self.points = vtk_to_numpy(self.polydata.GetPoints().GetData()).astype(float)
        self.corners = vtk_to_numpy(
            self.polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int64)
        data = self.polydata.GetPointData()
        self.direction = vtk_to_numpy(data.GetArray("Direction0")).astype(float)
        self.magnitude = vtk_to_numpy(data.GetArray("RepresentationMagnitude")).astype(float)
        self.point_normals = vtk_to_numpy(data.GetNormals()).astype(float)
        p = self.points[self.corners]
        cross = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
        self.areas = 0.5 * np.linalg.norm(cross, axis=1)
        self.normals = normalized(cross)

    def scatter(self, count):
        """Points spread evenly: their triangles, weights of the corners, positions, spacing."""
        candidates = 24 * count
        steps = np.arange(candidates)
        triangles = np.searchsorted(
            np.cumsum(self.areas), (steps + 0.5) / candidates * self.areas.sum())
        triangles = np.minimum(triangles, len(self.areas) - 1)
        # Multiples of these two numbers, modulo 1, fill the square evenly.
        u, v = np.outer((0.7548776662466927, 0.5698402909980532), steps + 0.5) % 1.0
        root = np.sqrt(u)
        weights = np.column_stack((1.0 - root, root * (1.0 - v), root * v))
        positions = np.einsum("ik,ikd->id", weights, self.points[self.corners[triangles]])
        normals = normalized(
            np.einsum("ik,ikd->id", weights, self.point_normals[self.corners[triangles]]))
        spacing = np.sqrt(1.15 * self.areas.sum() / count)
        # Normals count as coordinates so that both sides of a thin part carry stars of their own.
        places = np.hstack((positions - positions.mean(axis=0), 0.35 * spacing * normals))
        places = places.astype(np.float32)
        # Farthest points first: each next candidate is the one farthest from those before it.
        chosen = np.empty((count, 6), dtype=np.float32)
        gap = np.full(candidates, np.inf)
        for k in range(count):
            chosen[k] = places[np.argmax(gap)]
            np.minimum(gap, np.sum((places - chosen[k]) ** 2, axis=1), out=gap)
        # Lloyd's iteration: each point moves to the middle of the candidates nearest to it.
        for _ in range(20):
            owner = np.concatenate([nearest(part, chosen)
                                    for part in np.array_split(places, candidates // 2000 + 1)])
            sums = np.column_stack([np.bincount(owner, axis, count) for axis in places.T])
            counts = np.bincount(owner, minlength=count)[:, None]
            chosen = np.where(counts > 0, sums / np.maximum(counts, 1), chosen).astype(np.float32)
        chosen = np.unique(nearest(chosen, places))
        return triangles[chosen], weights[chosen], positions[chosen], spacing

    def directions_at(self, triangles, weights):
        """Unit vectors, shape (points, n, 3), interpolated the way n-fold directions add up."""
        normal = self.normals[triangles]
        p = self.points[self.corners[triangles]]
        x = normalized(p[:, 1] - p[:, 0])
        y = np.cross(normal, x)
        direction = self.direction[self.corners[triangles]]
        angle = np.arctan2(np.einsum("ikd,id->ik", direction, y),
                           np.einsum("ikd,id->ik", direction, x))
        representation = np.sum(weights * self.magnitude[self.corners[triangles]] *
                                np.exp(1j * self.degree * angle), axis=1)
        turns = 2.0 * np.pi * np.arange(self.degree) / self.degree
        angle = np.angle(representation)[:, None] / self.degree + turns
        return np.cos(angle)[:, :, None] * x[:, None] + np.sin(angle)[:, :, None] * y[:, None]


def stars(surface):
    """Tapered arms in all n directions, bent along the surface."""
    steps = 6
    triangles, weights, positions, spacing = surface.scatter(STARS)
    directions = surface.directions_at(triangles, weights)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface.polydata)
    locator.BuildLocator()
    length = spacing * (0.43 if surface.degree > 1 else 0.8)
    thick, thin = 0.09 * spacing, 0.035 * spacing
    closest, cell, sub, distance = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
    points, radii = [], []
    for triangle, position, arms in zip(triangles, positions, directions):
        for arm in arms:
            point, heading, normal = position, arm, surface.normals[triangle]
            for k in range(steps + 1):
                points.append(point + 0.6 * thick * normal)
                radii.append(thick + (thin - thick) * k / steps)
                locator.FindClosestPoint(point + heading * length / steps, closest, cell, sub,
                                         distance)
                point = np.array(closest)
                normal = surface.normals[cell.get()]
                heading = normalized(heading - normal * (heading @ normal))
    polydata = vtkPolyData()
    polydata.SetPoints(vtkPoints())
    polydata.GetPoints().SetData(numpy_to_vtk(np.array(points), deep=True))
    lines = vtkCellArray()
    lines.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, len(points) + 1, steps + 1), deep=True),
        numpy_to_vtkIdTypeArray(np.arange(len(points)), deep=True))
    polydata.SetLines(lines)
    radius = numpy_to_vtk(np.array(radii), deep=True)
    radius.SetName("Radius")
    polydata.GetPointData().SetScalars(radius)
    tubes = vtkTubeFilter()
    tubes.SetInputData(polydata)
    tubes.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
    tubes.SetNumberOfSides(12)
    tubes.CappingOn()
    tubes.Update()
    return tubes.GetOutput(), spacing


def show(view, polydata, color, **properties):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(polydata)
    source.UpdatePipeline()
    display = simple.Show(source, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = color
    for name, value in properties.items():
        setattr(display, name, value)
    return display


def show_balls(view, centres, radius, color):
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(24)
    polydata = vtkPolyData()
    polydata.SetPoints(vtkPoints())
    polydata.GetPoints().SetData(numpy_to_vtk(np.atleast_2d(centres), deep=True))
    glyph = vtkGlyph3D()
    glyph.SetInputData(polydata)
    glyph.SetSourceConnection(ball.GetOutputPort())
    glyph.ScalingOff()
    glyph.Update()
    show(view, glyph.GetOutput(), color, Specular=0.4, SpecularPower=30.0, Ambient=0.2)


class Frame:
    """The camera: sees the mesh from the front, a little from the left and above, y upwards."""

    def __init__(self, points):
        extent = np.ptp(points, axis=0)
        towards, up = np.array([-0.25, 0.22, 1.0]), np.array([0.0, 1.0, 0.0])
        if extent.min() < 0.05 * extent.max():
            towards = np.eye(3)[np.argmin(extent)]
            if towards[1] == 1.0:
                up = np.array([0.0, 0.0, -1.0])
        self.towards = normalized(towards)
        self.right = normalized(np.cross(up, self.towards))
        self.up = np.cross(self.towards, self.right)
        axes = np.array([self.right, self.up, self.towards])
        seen = points @ axes.T
        size = np.ptp(seen, axis=0)
        # Below the mesh is a strip for the caption.
        self.scale = max(size[1] / 1.68, size[0] / 1.86 * SIZE[1] / SIZE[0])
        middle = 0.5 * (seen.min(axis=0) + seen.max(axis=0)) - [0.0, 0.06 * self.scale, 0.0]
        self.focus = middle @ axes
        self.depth = np.linalg.norm(extent)

    def place(self, view):
        view.CameraParallelProjection = 1
        view.CameraParallelScale = self.scale
        view.CameraFocalPoint = list(self.focus)
        view.CameraPosition = list(self.focus + 4.0 * self.depth * self.towards)
        view.CameraViewUp = list(self.up)

    def position(self, x, y):
        """The point in front of the mesh that is seen at x, y, each from 0 to 1."""
        return (self.focus + self.depth * self.towards +
                self.scale * (2.0 * y - 1.0) * self.up +
                self.scale * (2.0 * x - 1.0) * SIZE[0] / SIZE[1] * self.right)


def write(view, text, x, y, color=TEXT_COLOR):
    display = simple.Show(simple.Text(Text=text), view)
    display.WindowLocation = "Any Location"
    display.Position = [x, y]
    display.FontSize = 24
    display.Color = color


def describe(indices, degree):
    if np.all(indices == indices[0]):
        return f"index {indices[0]:+d}/{degree}: {len(indices)}"
    return f"{'positive' if indices[0] > 0 else 'negative'} index: {len(indices)}"


def save(view, path):
    """Saves the view, drawn at twice the size for smooth edges."""
    simple.SaveScreenshot(path, view, ImageResolution=[2 * pixels for pixels in SIZE])
    reader = vtkPNGReader()
    reader.SetFileName(path)
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(reader.GetOutputPort())
    shrink.SetShrinkFactors(2, 2, 1)
    shrink.AveragingOn()
    shrink.Update()
    writer = vtkPNGWriter()
    writer.SetInputConnection(shrink.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def draw(field, singularities, degree, title, path):
    surface = Surface(field, degree)
    tubes, spacing = stars(surface)
    view = simple.CreateRenderView()
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.UseFXAA = 1
    show(view, surface.polydata, SURFACE_COLOR, Specular=0.1, Ambient=0.25)
    show(view, tubes, STAR_COLOR, Specular=0.2, Ambient=0.3)
    frame = Frame(surface.points[np.unique(surface.corners)])
    frame.place(view)
    name = {1: "Vector field", 2: "Line field", 4: "Cross field", 6: "Hex field"}.get(
        degree, f"Field of {degree} directions")
    write(view, f"{name} of {title}", 0.04, 0.04)
    if singularities.GetNumberOfPoints() > 0:
        centres = vtk_to_numpy(singularities.GetPoints().GetData())
        index = vtk_to_numpy(singularities.GetPointData().GetArray("SingularityIndex"))
        radius = 0.42 * spacing
        for chosen, color, x in ((index > 0, POSITIVE_COLOR, 0.42),
                                 (index < 0, NEGATIVE_COLOR, 0.70)):
            if np.any(chosen):
                show_balls(view, centres[chosen], radius, color)
                show_balls(view, frame.position(x, 0.054), radius, color)
                write(view, describe(index[chosen], degree), x + 0.022, 0.04)
    save(view, path)
