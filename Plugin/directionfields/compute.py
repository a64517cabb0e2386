# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The field that a picture shows: one that is there, or a new one."""

import os

from paraview import servermanager
from paraview import simple

from directionfields import preview
from directionfields.files import read
from directionfields.pipeline import (EXTRACTORS, MAKERS, fields_before, fields_of, follower,
                                      is_field, name_of, upstream)
from directionfields.restore import Messages

MOST_DIRECTIONS = 16
# What Extract Surface takes.
WITH_SURFACE = ("vtkPolyData", "vtkImageData", "vtkUniformGrid", "vtkRectilinearGrid",
                "vtkStructuredGrid", "vtkUnstructuredGrid", "vtkExplicitStructuredGrid")


def check_properties(name, properties):
    """Finds mistakes before anything is computed. paraview.simple knows the filter only if it has
    been told; ParaView 6 always knows."""
    if not hasattr(servermanager.filters, name) and hasattr(servermanager, "updateModules"):
        servermanager.updateModules()
    if not hasattr(servermanager.filters, name):
        raise RuntimeError(f"ParaView does not know the filter {name}: load the plugin "
                           "DirectionFields, on a remote server, too.")
    proxy = getattr(servermanager.filters, name)()
    known = set(proxy.ListProperties()) - {"Input"}
    unknown = sorted(set(properties) - known)
    if unknown:
        raise TypeError(f"{proxy.GetXMLLabel()} has no property {unknown[0]}, but "
                        f"{', '.join(sorted(known))}.")
    return proxy


def connect(proxy, source, properties):
    """Makes a filter ready, but for the pipeline browser, in which register() puts it."""
    controller = servermanager.ParaViewPipelineController()
    controller.PreInitializeProxy(proxy)
    proxy.Input = source
    for name, value in properties.items():
        setattr(proxy, name, value)
    controller.PostInitializeProxy(proxy)
    return proxy


def register(proxy, name):
    """Puts a filter into the pipeline browser, under a name that no other one has."""
    taken = {known for known, _ in simple.GetSources()}
    number, unique = 1, name
    while unique in taken:
        number += 1
        unique = f"{name} ({number})"
    servermanager.ParaViewPipelineController().RegisterPipelineProxy(proxy, unique)
    return proxy


def blocks_of(source):
    """The types of a dataset, or of all blocks of a composite one."""
    information = source.GetDataInformation(source.Port).DataInformation
    types = [information.GetDataSetType()]
    if information.IsCompositeDataSet():
        types = list(information.GetUniqueBlockTypes())
    return [information.GetDataSetTypeAsString(type) for type in types if type >= 0]


def surface_of(mesh):
    """What a field can be computed on, and whether that is a new filter: the mesh, or, of image
    data, grids and groups of such, its surface."""
    mesh.UpdatePipeline()
    types = blocks_of(mesh)
    if types and all(type == "vtkPolyData" for type in types):
        return mesh, False
    if not any(type in WITH_SURFACE for type in types):
        kind = mesh.GetDataInformation(mesh.Port).GetPrettyDataTypeString()
        raise ValueError(f"{name_of(mesh)} has no surface for a field (it is of the type {kind}): "
                         "select a mesh.")
    extracted = follower(mesh, *EXTRACTORS)
    if extracted is not None:
        return extracted, False
    return connect(servermanager.filters.ExtractSurface(), mesh, {}), True


def compute(mesh, degree, properties):
    """The field that a source has, or a new one on a mesh.

    Nothing is in the pipeline browser that was not there before, unless the field is good."""
    if isinstance(mesh, (str, os.PathLike)):
        mesh = read(mesh)
    if mesh is None:
        raise ValueError("There is no mesh: open one, press Apply, and select it.")
    if not isinstance(mesh, servermanager.SourceProxy):
        raise TypeError("show() takes a source, an output port or the name of a file, not "
                        f"{type(mesh).__name__}.")
    if has_field(mesh):
        if properties:
            raise TypeError("show() does not change the properties of a filter that it is given.")
        return given(mesh)
    return computed(mesh, degree, properties)


def field_for(source, **properties):
    """The field that a source has, or that was computed of it before, or else a new one."""
    if source is None:
        raise ValueError("There is no mesh: open one, press Apply, and select it.")
    source.UpdatePipeline()
    if has_field(source):
        return given(source)
    known = fields_of(source)
    return simple.OutputPort(known[-1], 0) if known else computed(source, 4, properties)


def has_field(source):
    """Whether a source is a field, or is made of one, or should be."""
    return bool(fields_before(source)) or any(
        before.GetXMLName() in MAKERS for before in upstream(source))


def is_drawable(field):
    """Whether a field is on faces, and not only on points and lines, as in a slice."""
    if field.GetXMLName() in MAKERS:
        return True
    glyphs = check_properties("DirectionFieldGlyphs", {})
    probe = connect(glyphs, field, {"MaximumNumberOfGlyphs": 1})
    probe.UpdatePipeline()
    return probe.GetDataInformation().GetNumberOfCells() > 0


def given(source):
    """The field that a source is or is made of, as it is."""
    source.UpdatePipeline()
    for field in fields_before(source):
        surface, is_new = surface_of(field)
        if is_drawable(surface):
            if is_new:
                register(surface, f"Surface of {name_of(field)}")
            return simple.OutputPort(surface, surface.Port)
    makers = [before for before in upstream(source) if before.GetXMLName() in MAKERS]
    raise ValueError(f"{name_of(makers[0] if makers else source)} has no field yet: look what its "
                     "Properties lack, and press Apply.")


def computed(mesh, degree, properties):
    """A new field."""
    if isinstance(degree, bool) or degree not in range(1, MOST_DIRECTIONS + 1):
        raise ValueError(f"The degree is a whole number from 1 to {MOST_DIRECTIONS}, not "
                         f"{degree!r}.")
    field = check_properties("DirectionField", properties)
    name = name_of(mesh)
    with Messages() as messages:
        surface, is_new = surface_of(mesh)
        surface.UpdatePipeline()
        if surface.GetDataInformation(surface.Port).GetNumberOfCells() == 0:
            raise ValueError(f"{name} has no cells: open a mesh, press Apply, and select it.")
        # The degree decides which alignments there are, hence it is set first.
        connect(field, surface, {"Degree": int(degree), **properties})
        preview.begin([field])
        field.UpdatePipeline()
    if not is_field(field):
        why = messages.errors[0] if messages.errors else (
            "It has no faces, only points or lines: select a mesh.")
        raise ValueError(f"{name} has no direction field. {why}")
    if is_new:
        register(surface, f"Surface of {name}")
    return simple.OutputPort(register(field, f"Field of {name}"), 0)
