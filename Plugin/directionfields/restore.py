# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What makes an attempt leave nothing behind: the pipeline as it was, and messages held back."""

import re

from paraview import servermanager
from paraview import simple
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow, vtkStringOutputWindow

CAMERA = ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraParallelScale",
          "CenterOfRotation")
SHOWN = ("Visibility", "Representation")


class Pipeline:
    """The pipeline and its views as they are now. Used in a `with`, it is so again after an
    exception, which goes on."""

    def __enter__(self):
        self.sources = {source.SMProxy for source in simple.GetSources().values()}
        self.active = simple.GetActiveSource(), simple.GetActiveView()
        self.views = []
        for view in simple.GetViews():
            camera = {name: list(view.GetPropertyValue(name)) if name != "CameraParallelScale"
                      else view.GetPropertyValue(name) for name in CAMERA if view.GetProperty(name)}
            displays = [(display, {name: display.GetProperty(name).GetElement(0) for name in SHOWN
                                   if display.GetProperty(name)})
                        for display in displays_of(view)]
            self.views.append((view, camera, displays))
        return self

    def __exit__(self, kind, problem, trace):
        if kind is not None:
            self.take_back()
        return False

    def take_back(self):
        new = [source for source in simple.GetSources().values()
               if source.SMProxy not in self.sources]
        for source in sorted(new, key=lambda one: one.SMProxy.GetGlobalID(), reverse=True):
            simple.Delete(source)
        known = {view.SMProxy for view, _, _ in self.views}
        for view in simple.GetViews():
            if view.SMProxy not in known:
                simple.Delete(view)
        for view, camera, displays in self.views:
            before = {display for display, _ in displays}
            for display in displays_of(view):
                if display not in before and display.GetProperty("Visibility"):
                    servermanager._getPyProxy(display).Visibility = 0
            for proxy, properties in [(view, camera)] + [
                    (servermanager._getPyProxy(display), shown) for display, shown in displays]:
                for name, value in properties.items():
                    setattr(proxy, name, value)
        source, view = self.active
        if view is not None:
            simple.SetActiveView(view)
        simple.SetActiveSource(source)


class Properties:
    """Properties of some proxies as they are now, given as {proxy: names}. Used in a `with`, they are
    so again after an exception, which goes on."""

    def __init__(self, names):
        self.names = names

    def __enter__(self):
        self.before = []
        for proxy, names in self.names.items():
            for name in names:
                property = proxy.SMProxy.GetProperty(name)
                copy = property.NewInstance()
                copy.Copy(property)
                self.before.append((proxy.SMProxy, property, copy))
        return self

    def __exit__(self, kind, problem, trace):
        if kind is not None:
            for proxy, property, copy in self.before:
                property.Copy(copy)
                proxy.UpdateVTKObjects()
        return False


def displays_of(view):
    """The proxies of a view's displays. ParaView's Python objects of them would take a millisecond
    each to make."""
    displays = view.SMProxy.GetProperty("Representations")
    return [displays.GetProxy(k) for k in range(displays.GetNumberOfProxies())] if displays else []


class Messages:
    """Holds back what VTK says within a `with`. Afterwards errors are in `errors`, as sentences;
    warnings are passed on unless there was an exception."""

    def __enter__(self):
        self.errors, self.warnings = [], []
        self.before = vtkOutputWindow.GetInstance()
        window = vtkStringOutputWindow()
        window.AddObserver("ErrorEvent", self.listener(self.errors))
        window.AddObserver("WarningEvent", self.listener(self.warnings))
        vtkOutputWindow.SetInstance(window)
        return self

    def __exit__(self, kind, problem, trace):
        vtkOutputWindow.SetInstance(self.before)
        for text in self.warnings if kind is None else ():
            self.before.DisplayWarningText(text)
        self.errors = [sentence_of(text) for text in self.errors]
        return False

    @staticmethod
    def listener(texts):
        def hear(_, event, text):
            texts.append(text)
        hear.CallDataType = VTK_STRING
        return hear


def sentence_of(text):
    """What VTK's error says, without the place in the source code and the object's address."""
    text = re.sub(r"^(ERROR|Warning): In .*\n", "", text.strip())
    return re.sub(r"^\w+ \(0x[0-9a-f]+\): ", "", text).strip()
