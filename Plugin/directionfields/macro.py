# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The toolbar button."""

import os
import sys

NAME = "Show direction field"

MACRO = '''\
# Shows the active source with its direction field.
from paraview.simple import *

try:
    import directionfields
except ImportError:
    LoadPlugin({plugin!r}, remote=False)
    import directionfields

directionfields.show(GetActiveSource(), view=GetActiveViewOrCreate("RenderView"))
'''


def macro_directory():
    """Where ParaView looks for the user's macros."""
    if sys.platform == "win32":
        return os.path.join(os.environ["APPDATA"], "ParaView", "Macros")
    settings = os.environ.get("XDG_CONFIG_HOME") or os.path.join(os.path.expanduser("~"), ".config")
    return os.path.join(settings, "ParaView", "Macros")


def plugin_path():
    """The loaded plugin's own file, so that the macro can load it in the next session."""
    from paraview.modules.vtkRemotingCore import vtkPVPluginTracker
    tracker = vtkPVPluginTracker.GetInstance()
    for k in range(tracker.GetNumberOfPlugins()):
        if tracker.GetPluginName(k) == "DirectionFields" and tracker.GetPluginLoaded(k):
            return tracker.GetPluginFileName(k)
    return "DirectionFields"


def install_macro(directory=None):
    """Adds the button "Show direction field" to ParaView's macros; returns the macro's path.

    The button shows the active source as show() does. ParaView looks for macros when it starts; in
    a running window choose the file with Macros > Import new macro. Macros > Delete removes it."""
    directory = directory or macro_directory()
    os.makedirs(directory, exist_ok=True)
    path = os.path.join(directory, NAME + ".py")
    with open(path, "w", encoding="utf-8") as file:
        file.write(MACRO.format(plugin=plugin_path()))
    return path
