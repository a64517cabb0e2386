# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playback of the same name. Checks that what the ParaView
window shows changes while sliders are held."""
import functools
import hashlib
import os
import sys
import time

import directionfields
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

sys.path.insert(0, os.environ["HOME"])
import Steps


def keep(name, value):
    os.environ["DIRECTIONFIELDS_TEST_" + name] = str(value)


def kept(name):
    return os.environ["DIRECTIONFIELDS_TEST_" + name]


def shown():
    """What is on the screen, without another rendering."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(GetActiveView().GetRenderWindow())
    grab.ShouldRerenderOff()
    grab.Update()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return hashlib.sha1(pixels.tobytes()).hexdigest()


def value(name):
    return float(getattr(GetActiveSource(), name))


def prepare(name):
    field = FindSource("Field of bunny.ply")
    if name == "AlignmentStrength":
        field.Alignment = "Principal Curvature"
    elif name == "Spacing":
        SetActiveSource(FindSource("Glyphs of bunny.ply"))
    elif name == "NumberOfFaces":
        SetActiveSource(field)
        assert directionfields.remesh_active() is not None
    Render()


def start(name):
    keep("PICTURES", shown())
    keep("VALUES", value(name))
    # A move that takes longer waits for a pause.
    time.sleep(0.5)


def wait(name):
    time.sleep(0.5)


def check_held(name):
    """Another picture, of another value."""
    pictures, values = kept("PICTURES").split(), list(map(float, kept("VALUES").split()))
    assert shown() not in pictures, (name, value(name), values)
    assert value(name) > values[-1], (name, value(name), values)
    keep("PICTURES", " ".join(pictures + [shown()]))
    keep("VALUES", " ".join(map(str, values + [value(name)])))


def check_released(name):
    """The last picture stays. ParaView's own sliders are 50 pixels wide beside their numbers; this one
    is as wide as the panel lets it, hence a move of 84 pixels is only a part of its way."""
    values = list(map(float, kept("VALUES").split()))
    assert shown() == kept("PICTURES").split()[-1] and value(name) == values[-1], values
    if name == "AlignmentStrength":
        assert 0.1 < values[-1] < 0.7, values


steps = (prepare, start, wait, check_held, wait, check_held, check_released)
Steps.take_next([functools.partial(step, name)
                 for name in ("AlignmentStrength", "SingularityCost", "Spacing", "NumberOfFaces")
                 for step in steps])
