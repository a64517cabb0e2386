# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the camera of a picture stands."""

import itertools
import math

import numpy as np
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy


def extremes(field):
    """The points that the camera has to see: those of the surface, or, where they would have to be
    fetched from a server or from blocks, the corners of the box around it."""
    if not servermanager.ActiveConnection.IsRemote():
        surface = servermanager.Fetch(field)
        if surface.IsA("vtkPolyData"):
            return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    bounds = field.GetDataInformation(0).GetBounds()
    return np.array(list(itertools.product(bounds[0:2], bounds[2:4], bounds[4:6])))


# Where place_camera() has left the cameras of the views.
_placed = {}


def camera_of(view):
    camera = view.GetActiveCamera()
    return np.array([camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()])


def put_camera(view, camera):
    """Puts a camera where camera_of() has found it."""
    for name, value in zip(("CameraPosition", "CameraFocalPoint", "CameraViewUp"), camera):
        setattr(view, name, list(value))


def is_untouched(view, field):
    """Whether a view shows nothing yet, or its camera stands where ParaView or place_camera() has
    put it, and not where a user has moved it to; or, not turned by a user, it misses the field, as
    one does that ParaView has placed for other data."""
    if not any(shown.Visibility for shown in view.Representations):
        return True
    now = camera_of(view)
    last = _placed.get(view.SMProxy.GetGlobalID())
    if last is not None and np.allclose(now, last, rtol=1e-6, atol=1e-12):
        return True
    along = now[1] - now[0]
    distance = np.linalg.norm(along)
    if not (np.allclose(along, [0.0, 0.0, -distance], atol=1e-6 * distance) and
            np.allclose(now[2], [0.0, 1.0, 0.0], atol=1e-6)):
        return False
    is_flat = view.InteractionMode == "2D" or view.CameraParallelProjection
    slope = math.tan(math.radians(0.5 * view.CameraViewAngle))
    half = view.CameraParallelScale if is_flat else slope * distance
    bounds = np.array(field.GetDataInformation(field.Port).GetBounds()).reshape(3, 2)
    radius = 0.5 * np.linalg.norm(bounds[:, 1] - bounds[:, 0])
    if radius > 2.0 * half or np.any(np.abs(bounds.mean(axis=1) - now[1])[:2] > half):
        return True
    scale, center = view.CameraParallelScale, list(view.CenterOfRotation)
    view.ResetCamera()
    reset, reset_scale = camera_of(view), view.CameraParallelScale
    put_camera(view, now)
    view.CameraParallelScale, view.CenterOfRotation = scale, center
    if is_flat:
        # ParaView shows flat data from very far away.
        return bool(np.linalg.norm(reset[1] - now[1]) < 0.05 * reset_scale and
                    abs(reset_scale - scale) < 0.05 * reset_scale)
    return bool(np.all(np.linalg.norm(reset - now, axis=1)[:2] < 0.05 * distance))


def place_camera(view, field):
    """In front of the mesh, a little to the left and above, y upwards; flat ones from above. The
    mesh fills the view but for a margin, a little more of it at the bottom, where the caption is.
    ParaView's own ResetCamera() leaves half of the view empty."""
    points = extremes(field)
    low, high = points.min(axis=0), points.max(axis=0)
    towards, up = np.array([-0.25, 0.22, 1.0]), np.array([0.0, 1.0, 0.0])
    if min(high - low) < 0.05 * max(high - low):
        thin = np.argmin(high - low)
        towards = np.eye(3)[thin]
        if thin == 1:
            up = np.array([0.0, 0.0, -1.0])
    towards = towards / np.linalg.norm(towards)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    axes = np.array([right, np.cross(towards, right), towards])
    seen = points @ axes.T
    middle = 0.5 * (seen.min(axis=0) + seen.max(axis=0))
    x, y, z = np.abs(seen[:, 0] - middle[0]), np.abs(seen[:, 1] - middle[1]), seen[:, 2] - middle[2]

    slope = math.tan(math.radians(0.5 * view.CameraViewAngle))
    aspect = view.ViewSize[0] / max(view.ViewSize[1], 1)
    distance = max(np.max(z + x / (0.92 * slope * aspect)), np.max(z + y / (0.84 * slope)), 1e-6)
    middle[1] -= 0.05 * distance * slope
    view.CameraFocalPoint = list(middle @ axes)
    view.CameraPosition = list((middle + [0.0, 0.0, distance]) @ axes)
    view.CameraViewUp = list(axes[1])
    view.CameraParallelScale = distance * slope
    view.CenterOfRotation = list(0.5 * (low + high))
    _placed[view.SMProxy.GetGlobalID()] = camera_of(view)
