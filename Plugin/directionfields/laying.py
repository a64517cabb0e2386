# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A way over a view, laid on the surface below it."""

import numpy as np
from paraview import servermanager
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkPolygon, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

# A stroke has a point every so many pixels of its way over the view.
STEP = 6.0
# Where the surface runs steeper from one point to the next, the stroke goes on elsewhere.
STEEPEST = 8.0
# How far a stroke is over the surface, relative to the diagonal of its box.
LIFT = 0.002
# Surfaces are at the same place where they differ by less than this part of the depth of the view.
SAME = 1e-6


class Screen:
    """The way between the pixels of a view and the points of its space."""

    def __init__(self, view):
        self.size = np.array(view.ViewSize, float)
        matrix = view.GetActiveCamera().GetCompositeProjectionTransformMatrix(
            self.size[0] / self.size[1], -1.0, 1.0)
        self.matrix = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        self.inverse = np.linalg.inv(self.matrix)

    def ray(self, pixel):
        """The nearest and the farthest point that a pixel shows."""
        x, y = 2.0 * (np.array(pixel) + 0.5) / self.size - 1.0
        ends = self.inverse @ np.array([[x, x], [y, y], [-1.0, 1.0], [1.0, 1.0]])
        return (ends[:3] / ends[3]).T

    def pixels(self, points):
        seen = np.c_[points, np.ones(len(points))] @ self.matrix.T
        return (0.5 * (seen[:, :2] / seen[:, 3:] + 1.0)) * self.size - 0.5


class Surface:
    """The polygons of a source, which rays can be sent at."""

    def __init__(self, source):
        data = servermanager.Fetch(source)
        if data.IsA("vtkCompositeDataSet"):
            append, blocks = vtkAppendPolyData(), data.NewIterator()
            blocks.InitTraversal()
            while not blocks.IsDoneWithTraversal():
                append.AddInputData(blocks.GetCurrentDataObject())
                blocks.GoToNextItem()
            append.Update()
            data = append.GetOutput()
        # Lines and points are not what is drawn on.
        self.data = data.NewInstance()
        self.data.SetPoints(data.GetPoints())
        self.data.SetPolys(data.GetPolys())
        self.data.SetStrips(data.GetStrips())
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.data)
        if self.data.GetNumberOfCells():
            self.locator.BuildLocator()

    def hit(self, ray):
        """The first point of the surface on a ray, or None."""
        if not self.data.GetNumberOfCells():
            return None
        t, part, point, coordinates = mutable(0.0), mutable(0), [0.0] * 3, [0.0] * 3
        # Else rays might pass through edges.
        close = 1e-6 * self.data.GetLength()
        found = self.locator.IntersectWithLine(ray[0], ray[1], close, t, point, coordinates, part)
        return np.array(point) if found else None

    def over(self, point, eye):
        """The nearest place to a point, on the eye's side so little over the surface that the edges
        of its faces do not hide a line from there to the next place."""
        found, cell, part, distance = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
        self.locator.FindClosestPoint(point, found, cell, part, distance)
        normal = [0.0] * 3
        vtkPolygon.ComputeNormal(self.data.GetCell(int(cell)).GetPoints(), normal)
        side = np.sign(np.dot(normal, np.array(eye) - found))
        return np.array(found) + LIFT * self.data.GetLength() * side * np.array(normal)


# The surfaces under the last stroke, by what they were made of.
_last = {}


def surfaces_under(found):
    """The polygons of some sources; those of the last time where their data are the same."""
    known = dict(_last)
    _last.clear()
    surfaces = []
    for source in found:
        source.UpdatePipeline()
        filter = source.GetClientSideObject()
        data = filter.GetOutputDataObject(source.Port) if filter else None
        key = (source.SMProxy.GetGlobalID(), source.Port, data.GetMTime()) if data else None
        surface = known.get(key) if data else None
        surfaces.append(surface or Surface(source))
        if data:
            _last[key] = surfaces[-1]
    return surfaces


def evenly(path):
    """Points of a way at equal distances, with its end."""
    path = np.array(path, float).reshape(-1, 2)
    lengths = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    places = np.linspace(0.0, lengths[-1], max(int(round(lengths[-1] / STEP)), 1) + 1)
    return np.c_[np.interp(places, lengths, path[:, 0]), np.interp(places, lengths, path[:, 1])]


def depth(point, ray):
    """How far a point is on the way from the start of a ray to its end."""
    return np.linalg.norm(point - ray[0]) / np.linalg.norm(ray[1] - ray[0])


def nearest(surfaces, ray):
    """The surface that a ray meets first, the first one of those at the same place, and where; or
    Nones."""
    hits = [(surface, surface.hit(ray)) for surface in surfaces]
    hits = [(surface, point) for surface, point in hits if point is not None]
    first = min((depth(point, ray) for _, point in hits), default=0.0)
    return next(((surface, point) for surface, point in hits
                 if depth(point, ray) <= first + SAME), (None, None))


def laid(path, surfaces, screen):
    """The first of surfaces that a way meets, and its parts there, as lists of points; or None."""
    parts, last, surface = [[]], None, None
    for pixel in evenly(path):
        ray = screen.ray(pixel)
        met, point = nearest(surfaces, ray)
        surface = surface or met
        if met is not surface:
            point = None
        if point is not None and last is not None:
            # How long a step is that the eye sees straight from the front.
            beside = screen.ray(pixel + [STEP, 0.0])
            part = depth(point, ray)
            flat = np.linalg.norm((1.0 - part) * (beside[0] - ray[0]) + part * (beside[1] - ray[1]))
            if np.linalg.norm(point - last) > STEEPEST * flat:
                last = None
        if point is None or last is None:
            parts.append([])
        if point is not None:
            parts[-1].append((point, ray[0]))
        last = point
    return surface, [smooth(*np.swapaxes(part, 0, 1), surface) for part in parts if len(part) > 1]


def smooth(points, eyes, surface):
    """The mouse trembles: without that, over the surface."""
    for _ in range(2):
        points[1:-1] = 0.25 * points[:-2] + 0.5 * points[1:-1] + 0.25 * points[2:]
    return [surface.over(point, eye) for point, eye in zip(points, eyes)]
