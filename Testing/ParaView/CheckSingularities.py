# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playback of the same name. Checks what the mouse has done
with singularities in the ParaView window."""
import os
import sys

import numpy as np
from directionfields import singularities as room
from paraview import smtrace
from paraview.simple import *

sys.path.insert(0, os.environ["HOME"])
import Steps


def rows(name="Edited field of bunny.ply"):
    return np.array(list(FindSource(name).SingularityList), float).reshape(-1, 4)


def keep(name, value):
    os.environ["DIRECTIONFIELDS_TEST_" + name] = " ".join(map(str, np.ravel(value)))


def kept(name):
    return np.array(os.environ["DIRECTIONFIELDS_TEST_" + name].split(), float)


def aim(view):
    """Puts a singularity that is seen, and far from others, into the middle of the view."""
    assert len(rows()) == 0 and GetActiveSource().GetXMLName() == "EditSingularities"
    hand = room._handles.hand
    assert hand.seen.sum() > 3
    gaps = np.linalg.norm(hand.rows[:, None, :3] - hand.rows[None, :, :3], axis=2)
    gaps[np.diag_indices(len(gaps))] = np.inf
    # Not at the outline either, where there is no way to drag it.
    towards = np.array(view.CameraPosition) - np.array(view.CameraFocalPoint)
    level = hand.rows[:, :3] @ towards / np.linalg.norm(towards)
    number = int(np.argmax(np.where(hand.seen, gaps.min(axis=1) + level, -np.inf)))
    shift = hand.rows[number, :3] - np.array(view.CameraFocalPoint)
    view.CameraFocalPoint = list(np.array(view.CameraFocalPoint) + shift)
    view.CameraPosition = list(np.array(view.CameraPosition) + shift)
    Render(view)
    room.refresh()
    smtrace.start_trace()
    keep("COUNT", len(hand.rows))
    keep("NUMBER", number)
    keep("PLACE", hand.rows[number])


def moved_to(view, share):
    """Whether one, and the same as before, is where the mouse has been at this share of the width."""
    now, number = rows(), int(kept("NUMBER")[0])
    assert len(now) == kept("COUNT")[0], len(now)
    assert now[number, 3] == kept("PLACE")[3]
    pixel = room.Screen(view).pixels(now[number:number + 1, :3])[0]
    width, height = view.ViewSize
    return abs(pixel[0] - share * width) < 3.0 and abs(pixel[1] - 0.5 * height) < 3.0


def check_dragged(view):
    """One follows the mouse. Where an update takes longer than a fifth of a second, as on a loaded
    machine, the last place of the mouse comes at its next pause or release."""
    assert moved_to(view, 0.52) or moved_to(view, 0.54)


def check_dropped(view):
    """One is where the mouse has let go."""
    assert moved_to(view, 0.54)


def check_second(view):
    """The second drag goes on from the first one; what was recorded has both, and repeats them."""
    assert moved_to(view, 0.56)
    keep("SECOND", rows())
    text = smtrace.stop_trace()
    with open(os.path.join(os.environ["DIRECTIONFIELDS_TEST_OUTPUT"], "Singularities.py"), "w") as file:
        file.write(text)


def check_undone(view):
    """One edit is undone, and then the other one."""
    assert moved_to(view, 0.54)


def check_empty(view):
    assert len(rows()) == 0, len(rows())
    assert FindSource("Edited field of bunny.ply").Objective == "Least Change"


def check_again(view):
    assert np.array_equal(rows().ravel(), kept("SECOND"))


def check_script(view):
    """The script that was recorded makes the same list out of none, to the last digit."""
    edit = FindSource("Edited field of bunny.ply")
    edit.SingularityList = []
    SetActiveSource(edit)
    with open(os.path.join(os.environ["DIRECTIONFIELDS_TEST_OUTPUT"], "Singularities.py")) as file:
        exec(compile(file.read(), "trace", "exec"), {})
    check_again(view)


view = GetActiveView()
Steps.take_next([lambda step=step: step(view)
                 for step in (aim, check_dragged, check_dropped, check_second, check_undone,
                              check_empty, check_undone, check_again, check_script)])
