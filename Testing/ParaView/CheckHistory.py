# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: each run is the next step of the playback of the same name. Starts a trace, ends and
checks it, and checks what undo and redo have done."""
import os
import traceback

from paraview import smtrace
from paraview.simple import *


def filters():
    return [proxy for proxy in GetSources().values() if proxy.GetXMLName() == "DirectionField"]


def start():
    smtrace.start_trace()


def check_trace():
    text = smtrace.stop_trace()
    for line in ("directionField1 = DirectionField(registrationName='DirectionField1', Input=",
                 "Show(directionField1, ", "Show(OutputPort(directionField1, 1), "):
        assert line in text, (line, text)
    for name, value in (("Degree", "6"), ("EnergyBias", "0.25")):
        # ParaView 6 sets all in one call.
        assert (f"directionField1.{name} = {value}\n" in text
                or f"    {name}={value},\n" in text), (name, text)
    # One press of Apply shows a surface in a solid colour, and the singularities.
    view = GetActiveView()
    display = GetRepresentation(filters()[0], view)
    assert display.Visibility == 1 and display.Representation == "Surface"
    assert not display.ColorArrayName[1], display.ColorArrayName
    assert GetRepresentation(OutputPort(filters()[0], 1), view).Visibility == 1
    # The panel Information lists these.
    data = filters()[0].GetDataInformation(0).GetFieldDataInformation()
    for name in ("Eigenvalue", "Residual", "Iterations", "EulerCharacteristic", "IndexSum"):
        array = data.GetArrayInformation(name)
        assert array and array.GetNumberOfTuples() == 1, name
    assert data.GetArrayInformation("IndexSum").GetComponentRange(0) == (12.0, 12.0)
    os.environ["DIRECTIONFIELDS_TEST_TRACE"] = text


def check_undo():
    assert not filters(), filters()


def check_redo_and_replay():
    for count in (1, 2):
        assert [field.Degree for field in filters()] == [6] * count, filters()
        assert all(GetRepresentation(field).Visibility for field in filters())
        exec(compile(os.environ["DIRECTIONFIELDS_TEST_TRACE"], "trace", "exec"), {})


STEPS = (start, check_trace, check_undo, check_redo_and_replay)
path = os.path.join(os.environ["DIRECTIONFIELDS_TEST_OUTPUT"], "History.txt")
step = int(os.environ.get("DIRECTIONFIELDS_TEST_STEP", "0"))
os.environ["DIRECTIONFIELDS_TEST_STEP"] = str(step + 1)
verdict = "passed\n" if step + 1 == len(STEPS) else None
try:
    STEPS[step]()
except BaseException:
    verdict = traceback.format_exc()
# The first failure is the one that counts.
if verdict and not os.path.exists(path):
    with open(path, "w") as file:
        file.write(verdict)
