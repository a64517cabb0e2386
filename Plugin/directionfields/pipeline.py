# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What stands before and after a filter in the pipeline."""

from paraview import servermanager
from paraview import simple

# Filters that add a field to a surface.
MAKERS = ("DirectionField", "ReadDirectionField", "DirectionFieldFile", "EditSingularities")
# Those that draw a field: what they give may have directions, too, but the field is their input's.
DRAWINGS = ("DirectionFieldGlyphs", "DirectionFieldStreamlines", "StripePattern",
            "CompareDirectionFields", "PythonAnnotation", "ShadedSurface", "PPolyDataNormals",
            "PolyDataNormals", "SurfaceNormals")
# Those that make a new mesh along a field.
REMESHERS = ("FieldAlignedRemesh",)
# The names that Extract Surface has had.
EXTRACTORS = ("DataSetSurfaceFilter", "GeometryFilter", "ExtractSurface")
# Those that hand a mesh on to the filter of its field.
BETWEEN = EXTRACTORS + ("GuidanceFromCurves",)


def proxy_of(source):
    """The proxy itself, whichever of its output ports is given."""
    return source.SMProxy if isinstance(source, servermanager.Proxy) else None


def sources():
    """The sources and filters of the pipeline, the oldest first."""
    return sorted(simple.GetSources().values(), key=lambda source: source.SMProxy.GetGlobalID())


def name_of(source):
    """What the pipeline browser calls a source."""
    for (name, _), candidate in simple.GetSources().items():
        if proxy_of(candidate) == proxy_of(source):
            return name
    return source.GetXMLLabel()


def input_of(source):
    """What a filter has as its first input, or None."""
    if source.GetProperty("Input") is None:
        return None
    first = source.Input
    if isinstance(first, servermanager.ProxyProperty):
        first = first[0] if len(first) else None
    return first if isinstance(first, servermanager.SourceProxy) else None


def upstream(source):
    """A source and what it comes from by the first inputs, the nearest first."""
    chain = []
    while source is not None:
        chain.append(source)
        source = input_of(source)
    return chain


def is_field(source, port=0):
    """Whether an output has directions at its points; it is not computed for that. Where there are
    no faces they are zero."""
    points = source.GetDataInformation(port).GetPointDataInformation()
    array = points.GetArrayInformation("Direction0")
    return (array is not None and array.GetNumberOfComponents() == 3 and
            array.GetComponentRange(-1)[1] > 0.5)


def fields_before(source):
    """The outputs with a field that a source is or is made of, the nearest first.

    A filter that should have a field and has none, as one without a file, ends the search: what
    comes before it is another field."""
    found = []
    for candidate in upstream(source):
        name = candidate.GetXMLName()
        if name in DRAWINGS:
            continue
        ports = range(proxy_of(candidate).GetNumberOfOutputPorts())
        found += [simple.OutputPort(candidate, port) for port in ports
                  if is_field(candidate, port)][:1]
        if name in MAKERS:
            break
    return found


def mesh_of(field):
    """The source of the surface that a field is on; the field itself where a file has both."""
    chain = upstream(field)
    for source in chain[1:]:
        if not is_field(source) and source.GetXMLName() not in BETWEEN:
            return source
    return chain[-1]


def fields_of(mesh):
    """The filters that have a field on a mesh, or on the surface extracted from it, the newest
    last."""
    return [source for source in sources() if source.GetXMLName() in MAKERS and is_field(source) and
            proxy_of(mesh) in (proxy_of(mesh_of(source)), proxy_of(input_of(source)))]


def singularities_port(field):
    """The output of a field that has its singularities, or None."""
    proxy = proxy_of(field)
    for port in range(proxy.GetNumberOfOutputPorts()):
        if proxy.GetOutputPortName(port) == "Singularities":
            return port
    return None


def follower(source, *names):
    """The newest filter of one of these names whose input is this output of a source."""
    found = None
    for candidate in sources():
        before = input_of(candidate) if candidate.GetXMLName() in names else None
        if (before is not None and proxy_of(before) == proxy_of(source) and
                getattr(before, "Port", 0) == getattr(source, "Port", 0)):
            found = candidate
    return found
