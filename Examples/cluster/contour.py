# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The direction field of an isosurface, on many processes: mpiexec -n 8 pvbatch contour.py PLUGIN OUTPUT [VOLUME ARRAY VALUE]

Reads a volume in pieces, contours it in parallel, computes one field over all pieces and saves the surface with
the field (OUTPUT/field.pvtp), its singularities (OUTPUT/singularities.pvtp) and a picture (OUTPUT/field.png).
Without a volume it takes ParaView's Wavelet."""
import os
import sys

from paraview.simple import *

plugin, output = sys.argv[1:3]
LoadPlugin(os.path.abspath(plugin), ns=globals())
os.makedirs(output, exist_ok=True)

if len(sys.argv) > 3:
    name, array, value = sys.argv[3:6]
    volume = OpenDataFile(name)
else:
    volume, array, value = Wavelet(), "RTData", 170.0
surface = Contour(Input=volume, ContourBy=["POINTS", array], Isosurfaces=[float(value)], ComputeScalars=0)

# The same filter as on one process. Of the surface no process but one needs more than its piece.
field = DirectionField(Input=surface, Degree=4, Diagnostics=1)
field.UpdatePipeline()
# At the seams pieces may have copies of each other's triangles, which would be counted twice.
own = RemoveGhostInformation(Input=field)
own.UpdatePipeline()
distribution = field.FieldData["Distribution"]
eigenvalues = field.FieldData["Eigenvalue"].GetRange()
print("%d triangles in %d pieces with %d common points, smallest eigenvalues from %g to %g" % (
    own.GetDataInformation().GetNumberOfCells(), distribution.GetRange(1)[0],
    distribution.GetRange(2)[0], *eigenvalues))

# Binary: what Debian 12's ParaView appends to a file cannot be read again.
SaveData(os.path.join(output, "field.pvtp"), proxy=field, DataMode="Binary")
SaveData(os.path.join(output, "singularities.pvtp"), proxy=OutputPort(field, 1), DataMode="Binary")

glyphs = DirectionFieldGlyphs(Input=field)
view = CreateRenderView(ViewSize=[1200, 900])
Show(field, view).Representation = "Surface"
shown = Show(glyphs, view)
shown.AmbientColor = shown.DiffuseColor = [0.1, 0.2, 0.5]
view.ResetCamera()
SaveScreenshot(os.path.join(output, "field.png"), view)
