# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView would write into its messages."""
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow, vtkStringOutputWindow


def collect(messages):
    """Puts errors and warnings into a list from now on. Returns the window that Python's own words
    need again at the end."""
    def hear(_, event, text):
        messages.append(text)
    hear.CallDataType = VTK_STRING
    window = vtkStringOutputWindow()
    window.AddObserver("WarningEvent", hear)
    window.AddObserver("ErrorEvent", hear)
    before = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    return before
