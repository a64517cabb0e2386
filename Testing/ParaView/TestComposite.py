# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Blocks, each with a field of its own: TestComposite.py PLUGIN"""
import sys

from paraview import servermanager
from paraview.simple import *

from Figures import figures, names

LoadPlugin(sys.argv[1], remote=False, ns=globals())

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
print("passed")
