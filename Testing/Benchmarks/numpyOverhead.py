# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What direction_fields takes beyond the libraries: numpyOverhead.py MEASURECORE [TRIANGLES [RUNS]]

Prints the ratio of the times of a smoothest cross field, added up over the processors, which does not depend on what
else the machine does; and memory: the most that a process of Python takes beyond
what it had with the arrays, against the libraries' process and the arrays of the result."""

import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

import direction_fields as df

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "NumPy"))
from surfaces import torus

triangles = int(sys.argv[2]) if len(sys.argv) > 2 else 100000
runs = int(sys.argv[3]) if len(sys.argv) > 3 else 5
rows = int((triangles / 4) ** 0.5) + 1
points, cells = torus(rows, 2 * rows)
cells = cells.astype(np.int32)
with tempfile.TemporaryDirectory() as folder:
    names = [os.path.join(folder, name) for name in ("points", "triangles")]
    points.tofile(names[0])
    cells.tofile(names[1])
    seconds, core = [], []
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    # In turns, so that both see the same machine; a process's first run takes longer.
    for _ in range(runs):
        core.append([float(word) for word in subprocess.run(
            [sys.argv[1], *names, "3" if core else "1"], check=True, capture_output=True, text=True).stdout.split()])
        for _ in range(3):
            begin = time.process_time()
            field = df.field(points, cells)
            seconds.append(time.process_time() - begin)
            if len(seconds) == 1:
                after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
outputs = sum(value.nbytes for value in vars(field).values() if isinstance(value, np.ndarray))
alone, memory = (min(column) for column in zip(*core))
print(f"{len(cells)} triangles: {min(seconds):.3f} s in Python, {alone:.3f} s in the libraries alone, "
      f"ratio {min(seconds) / alone:.3f}")
print(f"memory: {(after - before) / 1e6:.0f} MB more in Python, {memory / 1e6:.0f} MB in the libraries' process, "
      f"{outputs / 1e6:.0f} MB of arrays come out")
