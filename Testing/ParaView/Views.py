# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views as Apply leaves them in the window, and what is read off them."""
import os
import sys

from paraview import servermanager, simple

SIZE = [800, 600]


def picture_of(view, name):
    """The path of a picture of a view, in the folder that is the last argument of the test."""
    path = os.path.join(sys.argv[-1], name)
    simple.SaveScreenshot(path, view, ImageResolution=SIZE)
    return path


def new_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    return view


def shown_field(view, field):
    """The displays of a field's surface and of its singularities."""
    return simple.Show(field, view), simple.Show(simple.OutputPort(field, 1), view)


def color_of(lookup, value):
    rgb = [0.0, 0.0, 0.0]
    lookup.GetClientSideObject().GetColor(value, rgb)
    return [255 * c for c in rgb]


def apply(view, source):
    """What Apply does in the window."""
    controller = servermanager.vtkSMParaViewPipelineControllerWithRendering()
    for port in range(source.GetNumberOfOutputPorts()):
        controller.ShowInPreferredView(source.SMProxy, port, view.SMProxy)
    simple.Render(view)
    return [simple.GetRepresentation(simple.OutputPort(source, port), view)
            if view.FindRepresentation(source.SMProxy, port) else None
            for port in range(source.GetNumberOfOutputPorts())]


def orange(r, g, b):
    return (r > b + 100) & (r > g + 50) & (g > b + 30)


def caption(view):
    """What stands at the top left of a view, by the displays that have made it."""
    props = view.GetClientSideObject().GetNonCompositedRenderer().GetViewProps()
    texts = [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]
    texts = [text for text in texts if text.IsA("vtkTextActor") and text.GetVisibility()]
    assert len(texts) <= 1, texts
    return texts[0].GetInput() if texts else ""


def summary(source):
    words = source.GetDataInformation(0).GetFieldDataInformation().GetArrayInformation("Summary")
    return words.GetStringValue(0)
