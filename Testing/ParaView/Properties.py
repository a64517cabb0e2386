# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the properties of a proxy are those of the C++ filter behind it."""
import json
import subprocess

# A range that ends beyond this has no upper limit in C++, where it ends at VTK_DOUBLE_MAX.
UNLIMITED = 1e299


def printed(program, *filters):
    """From name to the figures of each property, as the program prints them, for each of the filters."""
    figures = json.loads(subprocess.check_output([program], text=True))
    return [figures[name] for name in filters]


def check_property(property, name, figures, enumerations):
    """Compares default and range, as a program has printed them, with those of a property."""
    value = property.GetElement(0)
    if figures["default"] in (None, "None"):
        assert value in ("", "None"), (name, value)
        assert property.GetDomain("array_list"), name
        return
    assert value == figures["default"], (name, value)
    if name in enumerations:
        domain = property.GetDomain("enum")
        entries = [(domain.GetEntryValue(i), domain.GetEntryText(i))
                   for i in range(domain.GetNumberOfEntries())]
        assert entries == list(enumerate(enumerations[name])), entries
        assert (entries[0][0], entries[-1][0]) == (figures["min"], figures["max"]), name
    elif isinstance(value, str):
        assert property.GetDomain("array_list"), name
    elif "min" not in figures:
        assert property.GetDomain("bool"), name
    else:
        domain = property.GetDomain("range")
        assert domain.GetMinimumExists(0) and domain.GetMinimum(0) == figures["min"], name
        assert bool(domain.GetMaximumExists(0)) == (figures["max"] < UNLIMITED), name
        if figures["max"] < UNLIMITED:
            assert domain.GetMaximum(0) == figures["max"], name


def check_properties(proxy, expected, enumerations, advanced, others=("Input",)):
    """Checks all properties of a filter: defaults, ranges, entries, visibility and documentation.

    expected      from name to the figures that the C++ class has printed
    enumerations  from name to the texts of the entries
    advanced      the names of those that only the advanced panel shows
    others        the names of those that no figures are printed of"""
    names = [name for name in proxy.ListProperties() if name not in (*others, "Diagnostics")]
    assert sorted(names) == sorted(expected), names
    if "Diagnostics" in proxy.ListProperties():
        # Menus of ParaView list all arrays; programs are given them.
        switch = proxy.SMProxy.GetProperty("Diagnostics")
        assert switch.GetDomain("bool") and switch.GetPanelVisibility() == "advanced"
        assert switch.GetDocumentation().GetDescription()
    for name, figures in expected.items():
        property = proxy.SMProxy.GetProperty(name)
        check_property(property, name, figures, enumerations)
        visibility = property.GetPanelVisibility()
        wanted = "advanced" if name in advanced else "default"
        # What the window alone sets is in no panel.
        assert visibility == ("never" if property.GetIsInternal() else wanted), (name, visibility)
    for name in proxy.ListProperties():
        documentation = proxy.SMProxy.GetProperty(name).GetDocumentation()
        assert documentation and documentation.GetDescription().strip(), name
    documentation = proxy.SMProxy.GetDocumentation()
    for text in (documentation.GetDescription(), documentation.GetShortHelp(),
                 documentation.GetLongHelp()):
        assert text and text.strip()
