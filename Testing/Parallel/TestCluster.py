# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example for clusters, run as it says: TestCluster.py MPIEXEC PVBATCH PLUGIN SOURCE OUTPUT distributed|gathered

By plain Python: pvpython is a process of MPI itself, which cannot start others. A process that dies in the midst
of it must end all of them, soon."""
import base64
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import time
import zlib

mpiexec, pvbatch, plugin, source, output, distributes = sys.argv[1:]
example = os.path.join(source, "Examples", "cluster", "contour.py")
batch = [mpiexec, "-n", "2", pvbatch, "--force-offscreen-rendering"]

shutil.rmtree(output, ignore_errors=True)
ran = subprocess.run([*batch, example, plugin, output], text=True, stdout=subprocess.PIPE,
                     stderr=subprocess.STDOUT, check=False)
print(ran.stdout)
assert ran.returncode == 0, ran.returncode
said = re.search(r"(\d+) triangles in 2 pieces with (\d+) common points", ran.stdout)
assert said, ran.stdout


def pieces_of(name):
    """The XML of the two files that processes have written, each its own."""
    with open(os.path.join(output, name + ".pvtp"), encoding="latin-1") as file:
        sources = re.findall(r'<Piece Source="([^"]+)"', file.read())
    assert len(set(sources)) == 2, sources
    texts = []
    for one in sources:
        with open(os.path.join(output, one), encoding="latin-1") as file:
            texts.append(file.read())
    return texts


def count_of(text, kind):
    return int(re.search(r'<Piece [^>]*NumberOf%s="(\d+)"' % kind, text)[1])


def integers_of(text, part, name):
    """The values of an array of the points, the cells or the whole; none without it."""
    found = re.search(r'<%s\b(?:(?!</%s>).)*?<DataArray type="(Int32|UInt8)" Name="%s"[^>]*format="binary"[^>]*>\s*([^<\s]+)' %
                      (part, part, name), text, re.DOTALL)
    if not found:
        return ()
    assert "compressor=" not in text and 'byte_order="LittleEndian"' in text
    header = 8 if 'header_type="UInt64"' in text else 4
    data = base64.b64decode(found[2])
    size = int.from_bytes(data[:header], "little")
    width, kind = (4, "i") if found[1] == "Int32" else (1, "B")
    return struct.unpack("<%d%s" % (size // width, kind), data[header:header + size])


fields, points = pieces_of("field"), pieces_of("singularities")
indices = []
for text in fields:
    index = integers_of(text, "CellData", "SingularityIndex")
    assert len(index) == count_of(text, "Polys"), len(index)
    # Copies of another process' triangles are none of this one's.
    ghosts = integers_of(text, "CellData", "vtkGhostType") or (0,) * len(index)
    indices.append([one for one, ghost in zip(index, ghosts) if ghost == 0])
assert min(map(len, indices)) > 100 and sum(map(len, indices)) == int(said[1]), (list(map(len, indices)), said[1])
assert int(said[2]) > 10
# Each singularity is in one piece, as a triangle and as a point. Those of all add up to what the components have.
singular = [sorted(index for index in values if index) for values in indices]
assert singular == [sorted(integers_of(text, "PointData", "SingularityIndex")) for text in points], singular
wanted = [sum(integers_of(text, "FieldData", "IndexSum")) for text in fields]
assert sum(map(sum, singular)) == wanted[0] == wanted[1], (singular, wanted)
assert sum(map(len, singular)) > 4, singular
with open(os.path.join(output, "field.png"), "rb") as picture:
    data = picture.read()
# What is compressed of the rows of pixels is not the same everywhere.
begin, pixels = 8, b""
while begin < len(data):
    size, kind = struct.unpack(">I4s", data[begin:begin + 8])
    pixels += data[begin + 8:begin + 8 + size] if kind == b"IDAT" else b""
    begin += size + 12
assert len(set(zlib.decompress(pixels))) > 60, "an empty picture"

# Each process writes down its number, waits until all have, and goes on to the field; the second one is
# killed before that. Their outputs would run into one another.
script = os.path.join(output, "killed.py")
with open(script, "w", encoding="utf-8") as text:
    text.write("""
import os, time
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
simple.LoadPlugin(%r, remote=False, ns=vars(simple))
name = os.path.join(%r, "process%%d" %% controller.GetLocalProcessId())
with open(name + ".new", "w") as file:
    file.write(str(os.getpid()))
os.rename(name + ".new", name)
controller.Barrier()
if controller.GetLocalProcessId() == 1:
    time.sleep(3600)
field = simple.DirectionField(Input=simple.Sphere(ThetaResolution=100, PhiResolution=100))
field.UpdatePipeline()
print("a field without one of its pieces", flush=True)
""" % (plugin, output))
running = subprocess.Popen([*batch, "--symmetric", script], text=True, stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT)
names = [os.path.join(output, "process%d" % k) for k in range(2)]
began = time.time()
while not all(map(os.path.exists, names)) and time.time() - began < 120.0:
    time.sleep(0.1)
pids = []
for name in names:
    with open(name, encoding="utf-8") as file:
        pids.append(int(file.read()))
time.sleep(3.0)
began = time.time()
os.kill(pids[1], signal.SIGKILL)
rest = running.communicate(timeout=60)[0]
assert running.returncode != 0, rest
assert "a field without" not in rest
assert time.time() - began < 60.0

# The second process dies in the midst of what all solve together.
dying = os.path.join(output, "dying.py")
with open(dying, "w", encoding="utf-8") as text:
    text.write("""
import os, signal
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
simple.LoadPlugin(%r, remote=False, ns=vars(simple))
field = simple.DirectionField(Input=simple.Sphere(ThetaResolution=100, PhiResolution=100))
field.Distribution = "Distributed"
field.Tolerance = 1e-12
filter = field.SMProxy.GetClientSideObject()
def die(source, event):
    if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 1 and filter.GetProgress() > 0.3:
        open(%r, "w").close()
        os.kill(os.getpid(), signal.SIGKILL)
filter.AddObserver("ProgressEvent", die)
field.UpdatePipeline()
print("a field without one of its pieces", flush=True)
""" % (plugin, os.path.join(output, "dies")))
if distributes == "distributed":
    ended = subprocess.run([*batch, "--symmetric", dying], text=True, stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, check=False, timeout=120)
    assert os.path.exists(os.path.join(output, "dies")), ended.stdout
    assert time.time() - os.path.getmtime(os.path.join(output, "dies")) < 60.0
    assert ended.returncode != 0, ended.stdout
    assert "a field without" not in ended.stdout
print("passed")
