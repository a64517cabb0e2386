# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example for clusters, run as it says: TestCluster.py MPIEXEC PVBATCH PLUGIN SOURCE OUTPUT distributed|gathered

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

mpiexec, pvbatch, plugin, source, output, distributes = sys.argv[1:]
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
