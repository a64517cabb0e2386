# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK's data and messages are compared by: a dictionary of short texts, one for each array."""

import hashlib
import json
import pathlib
import re

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSetAttributes

# Hexadecimal digits that are kept of a SHA-256.
DIGITS = 16


def line_of(mesh, name, options, items):
    """The line of a case; items are pairs of texts without tabs and line ends."""
    return "\t".join([mesh, name, options, *("=".join(item) for item in items)]) + "\n"


def short(digest):
    return digest.hexdigest()[:DIGITS]


def digest_of(array):
    """Type, components with their names, and bytes of an array; texts themselves."""
    if array.GetDataTypeAsString() == "string":
        return json.dumps([array.GetValue(k) for k in range(array.GetNumberOfValues())], ensure_ascii=False)
    components = range(array.GetNumberOfComponents())
    names = [array.GetComponentName(k) for k in components]
    kind = [array.GetDataTypeAsString(), array.GetNumberOfTuples(), names]
    digest = hashlib.sha256(json.dumps(kind).encode())
    if array.GetNumberOfValues():
        digest.update(vtk_to_numpy(array).tobytes())
    return short(digest)


def describe_attributes(data, prefix):
    """The arrays of point, cell or field data by their names; their order and which are active."""
    arrays = [data.GetAbstractArray(k) for k in range(data.GetNumberOfArrays())]
    if not arrays:
        return
    order = [array.GetName() for array in arrays]
    active = []
    if isinstance(data, vtkDataSetAttributes):
        active = [
            [data.GetAttributeTypeAsString(kind), data.GetAbstractAttribute(kind).GetName()]
            for kind in range(vtkDataSetAttributes.NUM_ATTRIBUTES) if data.GetAbstractAttribute(kind)]
    yield f"{prefix}.order", short(hashlib.sha256(json.dumps([order, active]).encode()))
    for array in sorted(arrays, key=lambda array: array.GetName() or ""):
        yield f"{prefix}.{array.GetName()}", digest_of(array)


def describe_polydata(data, prefix):
    """One item for each array of a polydata, its cells and its attributes."""
    yield f"{prefix}.size", f"{data.GetNumberOfPoints()} points, {data.GetNumberOfCells()} cells"
    if data.GetPoints():
        yield f"{prefix}.points", digest_of(data.GetPoints().GetData())
    for kind in ("Verts", "Lines", "Polys", "Strips"):
        cells = getattr(data, f"Get{kind}")()
        if cells.GetNumberOfCells():
            yield f"{prefix}.{kind}.offsets", digest_of(cells.GetOffsetsArray())
            yield f"{prefix}.{kind}.points", digest_of(cells.GetConnectivityArray())
    yield from describe_attributes(data.GetPointData(), f"{prefix}.point")
    yield from describe_attributes(data.GetCellData(), f"{prefix}.cell")
    yield from describe_attributes(data.GetFieldData(), f"{prefix}.field")


def describe_data(data, prefix):
    """The items of a polydata, or of all blocks of a composite dataset."""
    if not isinstance(data, vtkCompositeDataSet):
        yield from describe_polydata(data, prefix)
        return
    yield f"{prefix}.type", data.GetClassName()
    blocks = data.NewIterator()
    while not blocks.IsDoneWithTraversal():
        yield from describe_polydata(blocks.GetCurrentDataObject(), f"{prefix}[{blocks.GetCurrentFlatIndex()}]")
        blocks.GoToNextItem()
    yield from describe_attributes(data.GetFieldData(), f"{prefix}.field")


def describe_files(directory):
    """The bytes of all files of a directory."""
    for path in sorted(pathlib.Path(directory).iterdir()):
        yield f"file.{path.name}", short(hashlib.sha256(path.read_bytes()))


def describe_settings(algorithm):
    """What a new filter prints of its own properties, which follow those of all algorithms."""
    text = str(algorithm).partition("Progress Text:")[2]
    for line in text.splitlines()[1:]:
        name, separator, value = line.strip().partition(": ")
        if separator:
            yield name, re.sub(r"0x[0-9a-f]+", "0x", value)


class Messages:
    """What VTK says while this is entered, without places in the sources, addresses and times."""

    def __init__(self):
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        self.texts = []
        self.window = None

    def __enter__(self):
        self.texts = []
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)
        return self

    def __exit__(self, *_):
        vtkOutputWindow.SetInstance(None)
        text = self.window.GetOutput()
        text = re.sub(r"(ERROR|Warning|Generic Warning|Debug): In .*, line \d+\n", "\x1e\\1: ", text)
        text = re.sub(r" ?\(0x[0-9a-f]+\)", "", text)
        # The pipeline prints a request with its addresses after this.
        text = re.sub(r"(returned failure for request): [^\x1e]*", r"\1", text)
        self.texts = [message.strip() for message in text.split("\x1e") if message.strip()]

    def describe(self):
        if self.texts:
            yield "messages", json.dumps(self.texts, ensure_ascii=False)
