# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the mouse does, in ParaView's Python trace: as calls with places in space, which a script
repeats in a view of any size."""

from paraview import smtrace
from paraview.modules.vtkRemotingServerManager import vtkSMTrace

from directionfields.pipeline import name_of


class Traced:
    """While ParaView records a trace, what happens within a `with` leaves only `text` there, which is
    set before its end: single changes of properties, which Python makes, would be missing."""

    def __init__(self):
        self.text = None
        self.block = None

    def __enter__(self):
        if vtkSMTrace.GetActiveTracer() is not None:
            try:
                self.block = smtrace._create_trace_item_internal("BlockTraceItems")
            except smtrace.Untraceable:  # Within something that is traced as a whole.
                pass
        return self

    def __exit__(self, kind, problem, trace):
        if self.block is None:
            return False
        self.block = None
        if kind is None and self.text is not None:
            smtrace._create_trace_item_internal("TraceText", [f"import directionfields\n{self.text}"])
        return False


def named(source):
    """An output of a source, as scripts say it."""
    text = f"FindSource({name_of(source)!r})"
    port = getattr(source, "Port", 0)
    return f"OutputPort({text}, {port})" if port else text
