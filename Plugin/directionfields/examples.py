# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples of the menu Help: state files, with their meshes, in a folder beside the plugin."""

import os

from paraview import servermanager
from paraview import simple

from directionfields.picture import complain, is_render_view
from directionfields.pipeline import sources
from directionfields.restore import Pipeline

# The state files, by what the menu calls them.
EXAMPLES = {"Scan with strokes": "scan_with_strokes.py", "Part": "part.py",
            "Stripes": "stripes.py", "Quads": "quads.py"}
FOLDER = "examples"
_PLUGIN = "DirectionFields"


def open_example(name):
    """Opens an example, which is a state file in Python: what the menu "Direction field examples"
    does.

    name  "Scan with strokes", "Part", "Stripes" or "Quads", the keys of examples.EXAMPLES

    What is there stays: beside other sources the example gets a layout of its own. Returns its render
    view, or None where it could not be opened; then one sentence in ParaView's messages says why, and
    everything is as it was."""
    layout = None
    try:
        if name not in EXAMPLES:
            raise ValueError(f"There is no example {name}, but {', '.join(EXAMPLES)}.")
        # The state is read here, what it names is read by the server.
        with open(os.path.join(folder_of(local_plugin()), EXAMPLES[name]), encoding="utf-8") as file:
            state = file.read()
        with Pipeline():
            active = simple.GetActiveView()
            if sources() or not is_render_view(active):
                view = simple.CreateView("RenderView")
                layout = simple.CreateLayout(name)
                simple.AssignViewToLayout(view=view, layout=layout, hint=0)
                simple.SetActiveView(view)
            try:
                exec(compile(state, EXAMPLES[name], "exec"), {"__name__": "__main__"})
            except Exception:
                if layout is not None:
                    simple.Delete(layout)
                raise
            return simple.GetActiveView()
    except Exception as problem:  # A menu has nobody to catch what it raises.
        complain("Direction field examples", problem)
        return None


def example_file(name):
    """The path of a mesh of the examples, such as "bunny.ply", where ParaView's server finds it."""
    session = servermanager.ActiveConnection.Session
    is_remote = servermanager.ActiveConnection.IsRemote()
    plugin = plugin_of(manager().GetRemoteInformation(session)) if is_remote else local_plugin()
    if plugin is None:
        raise RuntimeError("The server has not loaded the plugin DirectionFields: load it there, "
                           "too, with Tools, Manage Plugins.")
    return f"{folder_of(plugin, is_remote)}/{name}"


def manager():
    return servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()


def plugin_of(plugins):
    """The file of the plugin among those that a process knows of, or None."""
    for k in range(plugins.GetNumberOfPlugins()):
        if plugins.GetPluginName(k) == _PLUGIN and plugins.GetPluginLoaded(k):
            return plugins.GetPluginFileName(k)
    return None


def local_plugin():
    plugin = plugin_of(manager().GetLocalInformation())
    if plugin is None:
        raise RuntimeError("The plugin DirectionFields is not loaded: see Tools, Manage Plugins.")
    return plugin


def folder_of(plugin, is_remote=False):
    """The folder of the examples that belong to a plugin's file, which may be a link to it."""
    # Links of another computer cannot be followed.
    path = plugin if is_remote else os.path.realpath(plugin)
    folder = f"{path.replace(os.sep, '/').rpartition('/')[0]}/{FOLDER}"
    if not is_remote and not os.path.isdir(folder):
        raise RuntimeError(f"There are no examples in {folder}: install the plugin with "
                           "cmake --install, which puts them there.")
    return folder
