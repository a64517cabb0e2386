# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Uses direction_fields as it is installed: UsePackage.py PREFIX"""

import importlib.metadata
import sys

import direction_fields as df

assert df.__file__.startswith(sys.argv[1]), df.__file__
field = df.field([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
assert field.indices.sum() == 8
files = importlib.metadata.distribution("direction_fields")
accessor, = (point for point in files.entry_points if point.group == "pyvista.accessors")
assert (accessor.name, accessor.value) == ("directions", "direction_fields.pyvista")
print("direction_fields", files.version, "works from", df.__file__)
