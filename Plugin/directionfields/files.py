# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes from files."""

import os

from paraview import simple

READERS = {
    ".ply": lambda path: simple.PLYReader(FileNames=[path]),
    ".stl": lambda path: simple.STLReader(FileNames=[path]),
    ".obj": lambda path: simple.WavefrontOBJReader(FileName=path),
    ".vtp": lambda path: simple.XMLPolyDataReader(FileName=[path]),
}


def read(path):
    """The mesh in a .ply, .obj, .stl or .vtp file, ready for a direction field: a source."""
    path = os.fspath(path)
    suffix = os.path.splitext(path)[1].lower()
    if suffix not in READERS:
        raise ValueError(f"{path} is not a .ply, .obj, .stl or .vtp file; open it with "
                         "paraview.simple.OpenDataFile and pass the source instead.")
    if not os.path.isfile(path):
        raise FileNotFoundError(f"There is no file {path}.")
    reader = READERS[suffix](path)
    simple.RenameSource(os.path.basename(path), reader)
    reader.UpdatePipeline()
    if suffix == ".obj":
        with open(path, encoding="utf-8", errors="replace") as file:
            vertices = sum(line.startswith(("v ", "v\t")) for line in file)
        if reader.GetDataInformation().GetNumberOfPoints() > vertices:
            # Where there are texture coordinates, VTK's reader may give every corner of a triangle
            # a point of its own, which leaves no surface to compute on.
            return simple.Clean(Input=reader, ConvertPolysToLines=0, Tolerance=0.0)
    return reader
