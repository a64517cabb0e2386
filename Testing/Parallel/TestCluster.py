# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example for clusters, run as it says: TestCluster.py MPIEXEC PVBATCH PLUGIN SOURCE OUTPUT

By plain Python: pvpython is a process of MPI itself, which cannot start others. A process that dies in the midst
of it must end all of them, soon."""
import os
import shutil
import signal
import struct
import subprocess
import sys
import time
import zlib

mpiexec, pvbatch, plugin, source, output = sys.argv[1:]
example = os.path.join(source, "Examples", "cluster", "contour.py")
batch = [mpiexec, "-n", "2", pvbatch, "--force-offscreen-rendering"]

shutil.rmtree(output, ignore_errors=True)
ran = subprocess.run([*batch, example, plugin, output], text=True, stdout=subprocess.PIPE,
                     stderr=subprocess.STDOUT, check=False)
print(ran.stdout)
assert ran.returncode == 0, ran.returncode
assert " triangles in 2 pieces with " in ran.stdout
for name in ("field.pvtp", "singularities.pvtp"):
    pieces = os.path.splitext(name)[0]
    assert os.path.exists(os.path.join(output, name)), name
    assert len(os.listdir(os.path.join(output, pieces))) == 2, pieces
with open(os.path.join(output, "field.png"), "rb") as picture:
    data = picture.read()
# What is compressed of the rows of pixels is not the same everywhere.
begin, pixels = 8, b""
while begin < len(data):
    size, kind = struct.unpack(">I4s", data[begin:begin + 8])
    pixels += data[begin + 8:begin + 8 + size] if kind == b"IDAT" else b""
    begin += size + 12
assert len(set(zlib.decompress(pixels))) > 60, "an empty picture"

# Each process says its number, waits until all have, and goes on to the field; the second one is killed.
script = os.path.join(output, "killed.py")
with open(script, "w", encoding="utf-8") as text:
    text.write("""
import os, time
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
print("process", controller.GetLocalProcessId(), os.getpid(), flush=True)
simple.LoadPlugin(%r, remote=False, ns=vars(simple))
controller.Barrier()
if controller.GetLocalProcessId() == 1:
    time.sleep(3600)
field = simple.DirectionField(Input=simple.Sphere(ThetaResolution=100, PhiResolution=100))
field.UpdatePipeline()
print("a field without one of its pieces", flush=True)
""" % plugin)
running = subprocess.Popen([*batch, "--symmetric", script], text=True, stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT)
pids = {}
lines = []
for line in running.stdout:
    lines.append(line)
    words = line.split()
    if words[:1] == ["process"] and len(words) == 3:
        pids[int(words[1])] = int(words[2])
    if len(pids) == 2:
        break
assert len(pids) == 2, lines
time.sleep(3.0)
began = time.time()
os.kill(pids[1], signal.SIGKILL)
rest = running.communicate(timeout=60)[0]
assert running.returncode != 0, rest
assert "a field without" not in rest
assert time.time() - began < 60.0
print("passed")
