# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Client and server: TestServer.py PLUGIN PVSERVER PVPYTHON, TestServer.py PLUGIN PORT

Starts a server and a client of it, a process of its own, for only its end surely ends the
connection. The server computes, the client compares with what it has computed itself."""
import os
import subprocess
import sys

from Figures import figures

plugin = sys.argv[1]


def serve(pvserver, pvpython):
    server = subprocess.Popen([pvserver, "--server-port=0"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        # Port 0 asks for one that is free; the server says "Accepting connection(s): host:port".
        for line in server.stdout:
            if "Accepting connection" in line:
                port = line.strip().rsplit(":", 1)[1]
                break
        subprocess.run([pvpython, os.path.abspath(__file__), plugin, port], check=True)
        # The server stops when its only client leaves.
        assert server.wait(30) == 0, server.returncode
    finally:
        server.kill()


def client(port):
    from paraview import servermanager, simple

    def compute():
        field = simple.DirectionField(
            Input=simple.Sphere(ThetaResolution=24, PhiResolution=16), Diagnostics=1)
        surface = servermanager.Fetch(field)
        found = figures(surface, servermanager.Fetch(field, idx=1))
        found["Direction0"] = surface.GetPointData().GetArray("Direction0").GetTuple3(7)
        return found

    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    expected = compute()
    assert expected["Total"] == 8, expected

    simple.Connect("localhost", port)
    assert servermanager.ActiveConnection.IsRemote()
    simple.LoadPlugin(plugin, remote=True, ns=vars(simple))
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    assert compute() == expected
    import directionfields
    shown = directionfields.show(simple.Sphere(ThetaResolution=24, PhiResolution=16))
    caption = servermanager.Fetch(shown.caption).GetColumn(0).GetValue(0)
    assert caption.startswith("8 singularities (8 +, 0 -), index sum 8"), caption

    # A singularity of a field that only the server has is dragged.
    from directionfields import singularities as room
    from directionfields.strokes import Screen
    simple.SetActiveSource(shown.field)
    assert room.begin() == "", room.begin()
    hand = room._handles.hand
    number = [k for k in range(8) if hand.seen[k]][0]
    x, y = Screen(hand.view).pixels(hand.rows[number:number + 1, :3])[0]
    middle = [0.5 * size for size in hand.view.ViewSize]
    x, y = x + 0.2 * (middle[0] - x), y + 0.2 * (middle[1] - y)
    hand.step(room.MOVE, number, (x, y))
    moved = list(hand.edit.SingularityList)[4 * number:4 * number + 3]
    pixel = Screen(hand.view).pixels([moved])[0]
    assert abs(pixel[0] - x) < 1.0 and abs(pixel[1] - y) < 1.0, (pixel, x, y)
    assert servermanager.Fetch(hand.edit, idx=1).GetNumberOfPoints() == 8
    room.end()

    # A stroke on a mesh that only the server has, made soft.
    for known in reversed(directionfields.pipeline.sources()):
        simple.Delete(known)
    view = simple.CreateView("RenderView")
    view.ViewSize = [400, 300]
    source = simple.Sphere(registrationName="ball", ThetaResolution=24, PhiResolution=16)
    simple.Show(source, view)
    simple.SetActiveSource(source)
    simple.ResetCamera(view)
    simple.Render(view)
    strokes = directionfields.draw_stroke([(170, 150), (230, 160)])
    assert strokes.GetClientSideObject() is None
    assert servermanager.Fetch(strokes).GetNumberOfLines() == 1
    field = simple.FindSource("Field of ball")
    hard = servermanager.Fetch(field).GetPointData().GetArray("ConstraintKind")
    assert hard is not None
    assert directionfields.toggle_stroke((200, 155)) == (strokes, 0, 0.5)
    strength = servermanager.Fetch(strokes).GetCellData().GetArray("Strength")
    assert strength.GetValue(0) == 0.5
    assert servermanager.Fetch(field).GetPointData().GetArray("ConstraintKind") is None
    assert directionfields.remove_stroke((200, 155)) and simple.FindSource("Strokes on ball") is None

    # The server reads the mesh of an example from beside its own plugin.
    assert directionfields.open_example("Scan with strokes") is not None
    strokes = simple.FindSource("Strokes on bunny.ply")
    assert servermanager.Fetch(strokes).GetNumberOfLines() == 3
    assert simple.FindSource("bunny.ply").GetDataInformation().GetNumberOfPoints() == 1839


if len(sys.argv) == 4:
    serve(*sys.argv[2:])
    print("passed")
else:
    client(int(sys.argv[2]))
