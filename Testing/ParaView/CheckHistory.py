# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A macro: checks what the playbacks History, Undo and Redo have done. History runs it twice: first it
starts a trace, then it ends and checks it."""
import os
import re
import sys

from paraview import smtrace
from paraview.simple import *

sys.path.insert(0, os.environ["HOME"])
import Steps


def filters():
    return [proxy for proxy in GetSources().values() if proxy.GetXMLName() == "DirectionField"]


def start():
    smtrace.start_trace()


def check_trace_and_replay():
    text = smtrace.stop_trace()
    for line in ("directionField1 = DirectionField(registrationName='DirectionField1', Input=",
                 "Show(directionField1, ", "Show(OutputPort(directionField1, 1), "):
        assert line in text, (line, text)
    for name, value in (("Degree", "6"), ("EnergyBias", "0.25")):
        # ParaView 6 sets all properties in one call, one a line.
        assert (f"directionField1.{name} = {value}\n" in text
                or re.search(rf"directionField1\.Set\([^)]*\b{name}={value}\b", text)), (name, text)
    # In the window a filter is named after its mesh.
    assert FindSource("Field of bunny.ply") == filters()[0], list(GetSources())
    # One press of Apply shows a surface in a solid colour with its directions, and the singularities.
    view = GetActiveView()
    display = GetRepresentation(filters()[0], view)
    assert display.Visibility == 1 and display.Representation == "Direction Field"
    assert not display.ColorArrayName[1], display.ColorArrayName
    assert GetRepresentation(OutputPort(filters()[0], 1), view).Visibility == 1
    # The panel Information lists the figures of the computation only where they are switched on.
    data = filters()[0].GetDataInformation(0).GetFieldDataInformation()
    assert data.GetArrayInformation("Summary") and not data.GetArrayInformation("IndexSum")
    filters()[0].Diagnostics = 1
    filters()[0].UpdatePipeline()
    data = filters()[0].GetDataInformation(0).GetFieldDataInformation()
    for name in ("Eigenvalue", "Residual", "Iterations", "EulerCharacteristic", "IndexSum"):
        array = data.GetArrayInformation(name)
        assert array and array.GetNumberOfTuples() == 1, name
    assert data.GetArrayInformation("IndexSum").GetComponentRange(0) == (12.0, 12.0)
    exec(compile(text, "trace", "exec"), {})
    assert [field.Degree for field in filters()] == [6, 6], filters()


def check_undo():
    assert not filters(), filters()


def check_redo():
    assert [field.Degree for field in filters()] == [6], filters()
    assert FindSource("Field of bunny.ply") == filters()[0], list(GetSources())
    assert GetRepresentation(filters()[0]).Visibility == 1


name = os.environ["DIRECTIONFIELDS_TEST_NAME"]
steps = {"History": (start, check_trace_and_replay), "Undo": (check_undo,), "Redo": (check_redo,)}[name]
Steps.take_next(steps)
