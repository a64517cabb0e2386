# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playback of the same name. Checks that what is in the way
of the mouse in the ParaView window leaves everything as it is, with one sentence at most. A dialog
would end the playback."""
import os
import sys

import numpy as np
from paraview.simple import *
from directionfields import singularities as room
from directionfields import strokes as drawing

sys.path.insert(0, os.environ["HOME"])
import Steps

MESSAGES = "DIRECTIONFIELDS_TEST_MESSAGES"


def hear():
    """Keeps what the tool writes into ParaView's messages."""
    write = drawing.complain

    def keep(button, problem):
        os.environ[MESSAGES] += "\n" + " ".join(str(problem).split())
        write(button, problem)
    os.environ[MESSAGES] = ""
    drawing.complain = keep


def messages():
    return os.environ[MESSAGES].strip().splitlines()


def only(source):
    """Shows a source alone."""
    for other in list(GetSources().values()):
        if other != source:
            Delete(other)
    if source is not None:
        Show(source)
        SetActiveSource(source)
    ResetCamera()
    Render()


def kinds():
    return sorted(source.GetXMLName() for source in GetSources().values())


def start():
    hear()
    only(Line())


def check_lines():
    assert kinds() == ["LineSource"], kinds()
    assert len(messages()) == 1 and "no surface under the stroke" in messages()[0], messages()
    only(None)


def check_nothing():
    assert kinds() == [], kinds()
    assert len(messages()) == 2 and "no surface under the stroke" in messages()[1], messages()
    only(Sphere())


def check_lost_release():
    """The stroke whose button is no longer pressed is forgotten."""
    assert kinds() == ["SphereSource"] and len(messages()) == 2, (kinds(), messages())
    only(Plane(XResolution=30, YResolution=30))


def check_left():
    """The stroke, which is a little above the square, ends where the mouse leaves that."""
    strokes = np.array(list(FindSource("Strokes on Plane1").Points)).reshape(-1, 4)
    assert np.unique(strokes[:, 0]).size == 1 and len(strokes) > 1, strokes
    assert np.abs(strokes[:, 1:3]).max() < 0.5 + 1e-6 and np.abs(strokes[:, 3]).max() < 0.01
    assert strokes[:, 1].max() > 0.2, strokes
    assert len(messages()) == 2, messages()


def rows():
    return room._handles.hand.rows


def share(row):
    """Where the view shows a singularity, in parts of its width and height."""
    view = GetActiveView()
    return room.Screen(view).pixels(row[None, :3])[0] / np.array(view.ViewSize)


def put_pair():
    assert GetActiveSource().GetXMLName() == "EditSingularities" and len(rows()) == 0
    width, height = GetActiveView().ViewSize
    note = room.add(width / 2, height / 2, 1, True)
    assert len(rows()) == 2, (note, rows())
    assert np.abs(share(rows()[0]) - 0.5).max() < 0.01, share(rows()[0])
    room.refresh()


def check_outside():
    """Beyond the boundary there is no place to go: it stays on the square."""
    assert len(rows()) == 2 and np.isfinite(rows()).all(), rows()
    assert np.abs(rows()[:, :2]).max() < 0.5 + 1e-6, rows()
    assert rows()[:, 3].tolist() == [1.0, -1.0], rows()


def check_back():
    """It is where the mouse has let it go, however it came there."""
    check_outside()
    place = share(rows()[0])
    assert abs(place[0] - 0.55) < 0.01 and abs(place[1] - 0.5) < 0.01, place


def check_end():
    assert room._handles is None
    assert len(messages()) == 2, messages()


Steps.take_next([start, check_lines, check_nothing, check_lost_release, check_left, put_pair,
                 check_outside, check_back, check_end])
