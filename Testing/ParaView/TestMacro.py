# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts the macro where the window will find it: TestMacro.py PLUGIN DIRECTORY"""
import os
import sys

from paraview import simple

simple.LoadPlugin(sys.argv[1], remote=False)
import directionfields

path = os.path.join(sys.argv[2], "Show direction field.py")
if os.path.exists(path):
    os.remove(path)
assert directionfields.install_macro() == path
assert os.path.exists(path)
print("passed")
