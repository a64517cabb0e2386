# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What stands before and after a filter in the pipeline."""

from paraview import servermanager
from paraview import simple


def proxy_of(source):
    """The proxy itself, whichever of its output ports is given."""
    return source.SMProxy if isinstance(source, servermanager.Proxy) else None


def input_of(source):
    """What a filter has as its first input, or None."""
    if source.GetProperty("Input") is None:
        return None
    first = source.Input
    if isinstance(first, servermanager.ProxyProperty):
        first = first[0] if len(first) else None
    return first if isinstance(first, servermanager.SourceProxy) else None


def field_of(source):
    """The filter Direction Field that a source is, or that it comes from; else None."""
    while source is not None and source.GetXMLName() != "DirectionField":
        source = input_of(source)
    return source


def fields_of(mesh):
    """The filters Direction Field whose input is a mesh, the newest last."""
    return [source for source in simple.GetSources().values()
            if source.GetXMLName() == "DirectionField" and
            input_of(source) is not None and proxy_of(input_of(source)) == proxy_of(mesh)]


def follower(source, *names):
    """The newest filter of one of these names whose input is the first port of a source."""
    found = None
    for candidate in simple.GetSources().values():
        before = input_of(candidate) if candidate.GetXMLName() in names else None
        if (before is not None and proxy_of(before) == proxy_of(source) and
                getattr(before, "Port", 0) == 0):
            found = candidate
    return found
