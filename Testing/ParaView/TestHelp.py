# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The help that the plugin brings: TestHelp.py PLUGIN QCH MENU

A Qt help file is an SQLite database of compressed files."""
import html
import re
import sqlite3
import sys
import xml.etree.ElementTree
import zlib

from paraview.simple import *

LoadPlugin(sys.argv[1], remote=False, ns=globals())
with sqlite3.connect(f"file:{sys.argv[2]}?mode=ro", uri=True) as database:
    files = {name: data for name, data in database.execute(
        "SELECT n.Name, d.Data FROM FileNameTable n JOIN FileDataTable d ON n.FileId = d.Id")}
    contents = database.execute("SELECT Data FROM ContentsTable").fetchone()[0]


def page(name):
    # The compressed text follows four bytes with its length.
    return zlib.decompress(files[name][4:]).decode("utf-8")


# The guide is what the title of the plugin's help leads to, and all that it refers to is there.
titles = re.findall(r"(?:index|[a-z]*(?:filters|sources|writers)\.\w+)\.html",
                    contents.decode("utf-16-be", errors="replace"))
menu = [f"filters.{proxy.get('name')}.html"
        for proxy in xml.etree.ElementTree.parse(sys.argv[3]).iter("Proxy")]
assert len(menu) == 9
# Below it they are the guide, the filters in the menu's order, and the files.
assert titles == ["index.html", "index.html", *menu, "sources.DirectionFieldFile.html",
                  "sources.SurfaceStrokes.html", "filters.ShadedSurface.html", "writers.DirectionFieldWriter.html",
                  "writers.AbaqusMeshWriter.html"], titles
pages = {name for name in files if name.endswith(".html")}
assert pages == set(titles), pages ^ set(titles)
# A page begins with a picture and the way to the guide.
for name in pages - {"index.html"}:
    start = re.search(r'</h2>\s*<p><img src="(\w+\.png)"[^>]*/></p>\s*<p><a href="index.html">',
                      page(name))
    assert start and start[1] in files, name
guide = page("index.html")
targets = re.findall(r'(?:href|src)="([^"]*)"', guide)
assert len(targets) >= 5, targets
for target in targets:
    assert target in files, target
# Each filter has a page with all of its properties, which the guide leads to.
for filter, inputs in ((DirectionField, {}), (DirectionFieldGlyphs, {}), (ReadDirectionField, {}),
                       (DirectionFieldStreamlines, {}), (FieldAlignedRemesh, {}),
                       (StripePattern, {}),
                       (GuidanceFromCurves, {"Curves": SplineSource()}),
                       (EditSingularities, {"Singularities": Sphere()}),
                       (CompareDirectionFields, {"Other": Sphere()})):
    proxy = filter(Input=Sphere(), **inputs)
    name = f"filters.{proxy.GetXMLName()}.html"
    assert name in targets, name
    text = " ".join(html.unescape(page(name)).split())
    for name in proxy.ListProperties():
        label = proxy.SMProxy.GetProperty(name).GetXMLLabel()
        assert f"<th>{label}</th>" in text, (label, text)
# ParaView shows these pages as Latin-1.
for name in files:
    if name.startswith("filters."):
        assert page(name).isascii(), (name, [c for c in page(name) if not c.isascii()])
# The guide knows the arrays that there are.
field = DirectionField(Input=Sphere(), Degree=2)
field.UpdatePipeline()
for port, kinds in ((0, ("PointData", "CellData", "FieldData")), (1, ("PointData",))):
    for kind in kinds:
        for name in getattr(OutputPort(field, port), kind).keys():
            if name != "Normals" or port == 1:
                assert f"<code>{name}</code>" in guide, name
print("passed")
