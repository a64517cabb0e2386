# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cases of surfaces in pieces on several processes, which checksums.py runs:

    mpiexec -n 2 pvbatch --symmetric pieces.py PACKAGE DIRECTORY

Each process writes the lines of its pieces to DIRECTORY/RANK.txt.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import cases
import digests
import meshes

SURFACES = ("square", "moebius", "potato", "noisy-bracket", "components", "touching-edge", "large-torus")
GATHER, DISTRIBUTED = {"Distribution": 1}, {"Distribution": 2}
FIELDS = [
    cases.of(4), cases.of(1, {"EnergyBias": 0.5}), cases.of(2, cases.GUIDED), cases.of(4, cases.HELD),
    cases.of(4, {"ConstrainBoundary": True}), cases.of(2, cases.MULTIGRID, {"Tolerance": 1e-9}),
    cases.of(4, cases.ALIGNED), cases.of(2, {"UnitLength": True, "CellDirections": True}),
    cases.of(4, {"ConstrainSharpEdges": True, "MergePoints": 0}),
]
# More processes than processors, and root's, as the tests under mpiexec have them.
ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1", "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe"}


def start(processes, package):
    """Runs this file on several processes; returns the lines of all."""
    with tempfile.TemporaryDirectory() as directory:
        command = ["mpiexec", "-n", str(processes), "pvbatch", "--force-offscreen-rendering", "--symmetric"]
        subprocess.run([*command, __file__, package, directory], check=True, env={**os.environ, **ENVIRONMENT})
        files = [pathlib.Path(directory) / f"{rank}.txt" for rank in range(processes)]
        return [line for file in files for line in file.read_text(encoding="utf-8").splitlines(keepends=True)]


def piece(surface, rank, count):
    """The cells of a process: one of slanted slabs of equal numbers."""
    points = meshes.points_of(surface)
    corners = meshes.ids_of(surface.GetPolys()).reshape(-1, 3)
    along = points[corners].mean(axis=1) @ (0.9, 0.3, 0.2)
    own = np.argsort(np.argsort(along, kind="stable"), kind="stable") * count // len(corners) == rank
    used, triangles = np.unique(corners[own], return_inverse=True)
    part = meshes.polydata(points[used], triangles.reshape(-1, 3))
    for name in ("Guide", "Weight"):
        part.GetPointData().AddArray(meshes.array(name, vtk_to_numpy(surface.GetPointData().GetArray(name))[used]))
    return part


def main():
    package, directory = sys.argv[1:]
    sys.path.insert(0, package)
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    import directionfields_vtk as filters
    controller = vtkMultiProcessController.GetGlobalController()
    rank, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    with open(pathlib.Path(directory) / f"{rank}.txt", "w", encoding="utf-8") as file:
        for name, _, surface in meshes.surfaces([]):
            if name not in SURFACES:
                continue
            mesh = f"{name}, piece {rank + 1} of {count}"
            runner = cases.Runner(filters, lambda *case, mesh=mesh: file.write(digests.line_of(mesh, *case)))
            part = piece(surface, rank, count)
            for distribution in (GATHER, DISTRIBUTED):
                for options in FIELDS:
                    field = runner.run("vtkPDirectionField", [part], [{**options, **distribution}])[0]
                    if options == FIELDS[0]:
                        of_field = f"of {cases.label([distribution])}: "
                        runner.run("vtkPDirectionFieldGlyphs", [field], [{"MaximumNumberOfGlyphs": 300}], of_field)
    # Open MPI 5 may lose what is still on its way when processes end.
    controller.Barrier()


if __name__ == "__main__":
    main()
