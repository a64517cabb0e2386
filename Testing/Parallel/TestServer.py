# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A client and a server of two processes: TestServer.py PLUGIN MPIEXEC PVSERVER PVPYTHON, TestServer.py PLUGIN PORT

By plain Python: pvpython is a process of MPI itself, which cannot start others. The client compares what the
server gives of a surface in two pieces with what it has computed itself."""
import os
import re
import subprocess
import sys

plugin = sys.argv[1]


def serve(mpiexec, pvserver, pvpython):
    server = subprocess.Popen([mpiexec, "-n", "2", pvserver, "--server-port=0"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        # Port 0 asks for one that is free; the server says "Accepting connection(s): host:port".
        for line in server.stdout:
            if "Accepting connection" in line:
                port = line.strip().rsplit(":", 1)[1]
                break
        client = subprocess.run([pvpython, os.path.abspath(__file__), plugin, port], check=True, timeout=240, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        print(client.stdout)
        # What the client has counted, of both pieces.
        counted = re.search(r"the same (\d+) triangles with (\d+) singularities and (\d+) points of glyphs", client.stdout)
        assert counted and int(counted[1]) == 2 * 40 * 28 and int(counted[2]) >= 8, client.stdout
        assert server.wait(60) == 0, server.returncode
    finally:
        server.kill()


def client(port):
    from paraview import servermanager, simple

    def compute():
        scaled = simple.Transform(Input=simple.Sphere(ThetaResolution=40, PhiResolution=30))
        scaled.Transform.Scale = [1.0, 1.4, 0.7]
        field = simple.DirectionField(Input=scaled, Diagnostics=1)
        glyphs = simple.DirectionFieldGlyphs(Input=field)
        glyphs.UpdatePipeline()
        whole = servermanager.Fetch(field)
        data = whole.GetFieldData()
        counts = (whole.GetNumberOfCells(),
                  sum(whole.GetCellData().GetArray("SingularityIndex").GetTuple1(k) != 0
                      for k in range(whole.GetNumberOfCells())),
                  servermanager.Fetch(glyphs).GetNumberOfPoints())
        points = servermanager.Fetch(field, idx=1).GetNumberOfPoints()
        distribution = data.GetArray("Distribution")
        return ([data.GetArray(name).GetTuple1(0) for name in
                 ("Eigenvalue", "EulerCharacteristic", "IndexSum")], points,
                distribution and distribution.GetTuple3(0), data.GetAbstractArray("Summary").GetValue(0), counts)

    def drag():
        """A singularity of a surface in two pieces is moved by hand: one process has the whole."""
        import numpy as np
        from directionfields import singularities as room
        from directionfields.strokes import Screen
        field = [one for one in simple.GetSources().values() if one.GetXMLName() == "DirectionField"][-1]
        field.UnitLength = 1
        simple.SetActiveSource(field)
        assert room.begin() == "", room.begin()
        hand = room._handles.hand
        assert hand.rows[:, 3].sum() == 8 and len(hand.seen) == len(hand.rows) and hand.seen.any()
        number = int(np.argmax(hand.seen))
        x, y = Screen(hand.view).pixels(hand.rows[number:number + 1, :3])[0]
        middle = [0.5 * size for size in hand.view.ViewSize]
        x, y = x + 0.2 * (middle[0] - x), y + 0.2 * (middle[1] - y)
        assert hand.step(room.MOVE, number, (x, y)), hand.note
        moved = list(hand.edit.SingularityList)[4 * number:4 * number + 3]
        assert np.abs(Screen(hand.view).pixels([moved])[0] - [x, y]).max() < 1.0
        room.end()

    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    wanted = compute()
    simple.Connect("localhost", port)
    simple.LoadPlugin(plugin, remote=True, ns=vars(simple))
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))
    found = compute()
    assert abs(found[0][0] / wanted[0][0] - 1.0) < 1e-5, (found, wanted)
    assert found[0][1:] == wanted[0][1:] == [2.0, 8.0], (found, wanted)
    assert found[1] == wanted[1], (found, wanted)
    assert found[4][:2] == wanted[4][:2], (found, wanted)
    # Glyphs begin somewhere else, and are as many.
    assert abs(found[4][2] / wanted[4][2] - 1.0) < 0.1, (found, wanted)
    drag()
    print("the same %d triangles with %d singularities and %d points of glyphs" % found[4], flush=True)
    assert wanted[2] is None and found[2][:2] == (1.0, 2.0) and found[2][2] > 50, (found, wanted)


if len(sys.argv) == 5:
    serve(*sys.argv[2:])
    print("passed")
else:
    client(int(sys.argv[2]))
