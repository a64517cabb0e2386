# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks, each with a field of its own and what is made of it: TestComposite.py PLUGIN"""
import sys

from paraview import servermanager
from paraview.simple import *

import AllFigures
from Figures import figures, names

LoadPlugin(sys.argv[1], remote=False, ns=globals())
AllFigures.switch_on()

# The second sphere is twice as large, the cylinder is an annulus without its caps.
blocks = [Sphere(ThetaResolution=24, PhiResolution=16),
          Sphere(ThetaResolution=24, PhiResolution=16, Radius=1.0, Center=[3, 0, 0]),
          Cylinder(Resolution=16, Capping=0)]
alone = []
for block in blocks:
    field = DirectionField(Input=block, Degree=2)
    alone.append(figures(servermanager.Fetch(field), servermanager.Fetch(field, idx=1)))
    Delete(field)
assert [found["Total"] for found in alone] == [4, 4, 0], alone
assert abs(alone[0]["Eigenvalue"][0] / alone[1]["Eigenvalue"][0] - 4.0) < 1e-4, alone

field = DirectionField(Input=GroupDatasets(Input=blocks), Degree=2)
surfaces = servermanager.Fetch(field)
singularities = servermanager.Fetch(field, idx=1)
for result in (surfaces, singularities):
    assert result.IsA("vtkMultiBlockDataSet") or result.IsA("vtkPartitionedDataSetCollection")
    assert result.GetNumberOfBlocks() == 3
for k, expected in enumerate(alone):
    surface = surfaces.GetBlock(k)
    assert "Direction1" in names(surface.GetPointData())
    found = figures(surface, singularities.GetBlock(k))
    assert found == expected, (k, found, expected)

# A block that a filter before has left empty changes nothing for the others.
empty = Threshold(Input=blocks[2], Scalars=["POINTS", "Normals"], LowerThreshold=7,
                  UpperThreshold=8)
field = DirectionField(Input=GroupDatasets(Input=[blocks[0], ExtractSurface(Input=empty)]),
                       Degree=2)
surfaces = servermanager.Fetch(field)
assert figures(surfaces.GetBlock(0), servermanager.Fetch(field, idx=1).GetBlock(0)) == alone[0]


def line_field(mesh):
    return DirectionField(Input=mesh, Degree=2)


def lines(mesh):
    return DirectionFieldStreamlines(Input=line_field(mesh))


def stripes(mesh):
    return StripePattern(Input=line_field(mesh), Spacing=0.1)


def remesh(mesh):
    return FieldAlignedRemesh(Input=mesh, NumberOfFaces=300)


def edit(mesh):
    field = line_field(mesh)
    return EditSingularities(Input=field, Singularities=OutputPort(field, 1))


def sizes(data):
    return data.GetNumberOfPoints(), data.GetNumberOfCells()


# What one does with the fields gives of each block what it gives of it alone.
for tool, ports in ((lines, 2), (stripes, 3), (remesh, 2), (edit, 2)):
    singles = [tool(block) for block in blocks]
    together = tool(GroupDatasets(Input=blocks))
    for port in range(ports):
        expected = [sizes(servermanager.Fetch(single, idx=port)) for single in singles]
        assert port > 0 or all(cells > 0 for _, cells in expected), (tool.__name__, expected)
        result = servermanager.Fetch(together, idx=port)
        found = [sizes(result.GetBlock(k)) for k in range(len(blocks))]
        assert found == expected, (tool.__name__, port, found, expected)
print("passed")
