# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strokes and moved singularities come again in another process: TestAgain.py PLUGIN MESH OUTPUT,
TestAgain.py PLUGIN STATE PICTURE -"""
import os
import subprocess
import sys

import numpy as np
from paraview import servermanager, simple, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

plugin = sys.argv[1]
simple.LoadPlugin(plugin, remote=False, ns=globals())
import directionfields
from directionfields import laying

SIZE = [640, 480]


def bunny(mesh, size=SIZE):
    view = simple.CreateView("RenderView")
    view.ViewSize = size
    source = simple.PLYReader(registrationName="bunny", FileNames=[mesh])
    simple.Show(source, view)
    simple.SetActiveSource(source)
    simple.ResetCamera(view)
    simple.Render(view)
    bounds = np.array(source.GetDataInformation().GetBounds()).reshape(3, 2)
    return laying.Screen(view).pixels(bounds.mean(axis=1)[None])[0]


def draw_three(x, y):
    for away in (-40, 0, 40):
        way = [(x - 60, y + away), (x, y + away + 10), (x + 60, y + away)]
        assert directionfields.draw_stroke(way) is not None


def rows():
    return np.array(simple.FindSource("Strokes on bunny").Points).reshape(-1, 4)


def directions():
    data = servermanager.Fetch(simple.FindSource("Field of bunny")).GetPointData()
    return np.array([vtk_to_numpy(data.GetArray(f"Direction{k}")) for k in range(4)], float)


def angles(one, other):
    """Between two cross fields at each point, in degrees."""
    cosines = (one[:1] * other).sum(axis=2).max(axis=0)
    return np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0)))


def test_trace(mesh):
    """A trace of three strokes, of which one is taken away, gives the same strokes and the same field,
    in a view of another size, too."""
    x, y = bunny(mesh)
    config = smtrace.start_trace()
    config.SetFullyTraceSupplementalProxies(False)
    draw_three(x, y)
    assert directionfields.remove_stroke((x, y + 7))
    # What is refused leaves nothing.
    assert directionfields.draw_stroke([(1, 1), (1, 30)]) is None
    text = smtrace.stop_trace()
    assert text.count("directionfields.add_strokes(FindSource('bunny')") == 3, text
    assert text.count("directionfields.remove_stroke(strokes=FindSource(") == 1, text
    assert "GuidanceFromCurves(" not in text, text
    before, field = rows(), directions()
    assert 0.0 in before[:, 0] and 1.0 not in before[:, 0] and 2.0 in before[:, 0]

    simple.ResetSession()
    bunny(mesh, [300, 200])
    exec(compile(text, "trace", "exec"), dict(globals()))
    assert np.array_equal(rows(), before)
    assert np.array_equal(directions(), field), angles(directions(), field).max()
    simple.ResetSession()


def test_given(mesh):
    """Strokes that are none are refused, and leave everything as it was."""
    bunny(mesh)
    source = simple.FindSource("bunny")
    for lines in ([], [[(0, 0, 0)]], [[(0, 0), (1, 1)]], [[(0, 0, 0), (0, float("nan"), 1)]]):
        try:
            directionfields.add_strokes(source, lines)
            assert False, lines
        except ValueError as problem:
            assert "two points or more" in str(problem)
    assert len(simple.GetSources()) == 1
    simple.ResetSession()


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


def test_state(mesh, output):
    """A state with strokes and a singularity that was moved shows the same pixels in another process."""
    x, y = bunny(mesh)
    draw_three(x, y)
    plain = os.path.join(output, "AgainPlain.png")
    simple.SaveScreenshot(plain, ImageResolution=SIZE)
    simple.SetActiveSource(simple.FindSource("Field of bunny"))
    from directionfields import singularities as room
    assert room.begin() == ""
    hand = room._handles.hand
    number = next(k for k in range(len(hand.rows)) if hand.seen[k])
    at = laying.Screen(hand.view).pixels(hand.rows[number:number + 1, :3])[0]
    hand.step(room.MOVE, number, tuple(at + 0.1 * (np.array([x, y]) - at)))
    room.end()
    state, first, second = (os.path.join(output, name) for name in (
        "Again.pvsm", "AgainFirst.png", "AgainSecond.png"))
    simple.SaveState(state)
    simple.SaveScreenshot(first, ImageResolution=SIZE)
    subprocess.run([sys.executable if "pvpython" in sys.executable else "pvpython",
                    os.path.abspath(__file__), plugin, state, second, "-"], check=True)
    assert np.array_equal(pixels(first), pixels(second))
    assert not np.array_equal(pixels(first), pixels(plain))


if len(sys.argv) == 5:
    simple.LoadState(sys.argv[2])
    simple.SaveScreenshot(sys.argv[3], simple.GetActiveView(), ImageResolution=SIZE)
else:
    test_trace(sys.argv[2])
    test_given(sys.argv[2])
    test_state(*sys.argv[2:])
    print("passed")
