# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The field of a surface in pieces is that of the whole: mpiexec -n 3 pvbatch --symmetric TestPieces.py PACKAGES [distributed] [SURFACE...]

Every process computes the field of the whole surface by itself, too, and compares its own piece with it. With distributed none has more than its piece, but of what can
only be gathered."""
import sys

sys.path.insert(0, sys.argv[1])

import numpy as np

import Surfaces
from Comparing import check, compare, compare_singularities, count, end, make, rank
from directionfields_vtk import vtkDirectionField, vtkPDirectionField

def inside_out():
    """Closed, with a flat top, and wound inside out."""
    points, triangles = Surfaces.potato(13)
    points[:, 2] = np.minimum(points[:, 2], 0.25)
    return points, triangles[:, ::-1].copy()


SURFACES = {"closed": Surfaces.potato(15), "bounded": Surfaces.half(15), "pair": Surfaces.pair(11),
            "strip": Surfaces.moebius(), "klein": Surfaces.klein(), "mixed": Surfaces.mixed(),
            "turned": Surfaces.turned(11), "sheets": Surfaces.sheets(), "inside out": inside_out(),
            "noisy": Surfaces.noisy(19)}
ORDINARY = [name for name in SURFACES if name not in ("inside out", "klein", "mixed", "noisy")]
WAYS = {"slabs": {}, "random": {}, "ids": {}, "one": {}, "empty": {},
        "slabs with ghosts": {"ghosts": True}, "random with ghosts": {"ghosts": True, "noise": 3e-8},
        "slabs with ids": {"ids": True, "noise": 3e-8}, "ids with ghosts": {"ghosts": True, "ids": True},
        "slabs with noise": {"noise": 1e-7}}
GUIDED = {"Alignment": vtkDirectionField.ALIGN_POINT_VECTORS, "GuidanceVectors": "Wanted",
          "GuidanceWeights": "Weight"}
FIELDS = {"smoothest": {}, "aligned": {"Alignment": vtkDirectionField.ALIGN_PRINCIPAL_CURVATURE},
          "guided": GUIDED, "constrained": {"ConstrainBoundary": 1, "ConstrainSharpEdges": 1},
          "faces": {"CellDirections": 1, "UnitLength": 1}, "merged": {"MergePoints": 1},
          "boundary": {"ConstrainBoundary": 1},
          "aligned lines": {"Alignment": vtkDirectionField.ALIGN_PRINCIPAL_CURVATURE, "Degree": 2},
          "given": {**GUIDED, "GuidanceWeights": "Few", "ConstrainGuidance": 1},
          "bounded by": {**GUIDED, "ConstrainBoundary": 1, "AlignmentStrength": 0.8},
          "unmerged": {"MergePoints": 0}, "multigrid": {"Solver": 1, "Tolerance": 1e-10},
          "stress": {"Alignment": vtkDirectionField.ALIGN_TENSOR, "TensorArray": (0, "Stress")},
          "stress of cells": {"Alignment": vtkDirectionField.ALIGN_TENSOR, "TensorArray": (1, "Stress")}}


# What can be had without gathering.
DISTRIBUTED_SURFACES = ("closed", "bounded", "pair", "turned", "inside out", "noisy")
DISTRIBUTED_FIELDS = ("smoothest", "aligned", "aligned lines", "guided", "given", "unmerged", "multigrid")
DISTRIBUTED_WITH_BOUNDARY = ("boundary", "bounded by")
# Curvatures of what has only one side need the whole.
ONE_SIDED = ("strip", "klein", "mixed")
DISTRIBUTED_ONE_SIDED = [field for field in DISTRIBUTED_FIELDS if not field.startswith("aligned")]


def warnings_of(field):
    warnings = field.GetOutput().GetFieldData().GetAbstractArray("Warnings")
    return [warnings.GetValue(k) for k in range(warnings.GetNumberOfValues())] if warnings else []


def run(surface, way, field, distribute):
    points, triangles = SURFACES[surface]
    options = dict(FIELDS[field])
    kind = WAYS[way]
    name = f"{surface}, {way}, {field}, process {rank} of {count}"
    vectors = np.stack([points[:, 1], -points[:, 0], 0.3 + points[:, 2] ** 2], axis=1)
    arrays = {"Wanted": vectors, "Weight": 1.0 + points[:, 2] ** 2,
              "Few": (points[:, 1] > 0.6) * 1.5}
    # Tensors that turn along the surface, and no less where it is level.
    turn = np.stack([np.cos(points[:, 2]), np.sin(points[:, 2]), points[:, 0]], axis=1)
    tensors = np.stack([turn[:, a] * turn[:, b] for a, b in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))], axis=1)
    arrays["Stress"] = tensors
    kind = {**kind, "cell_arrays": {"Stress": tensors[triangles].mean(axis=1)}}
    owner = Surfaces.owners(points, triangles, way.split()[0], count)
    mesh = Surfaces.piece(points, triangles, arrays, owner * 0, 0, cell_arrays=kind["cell_arrays"])
    whole = make(vtkDirectionField, options, mesh)
    options["Distribution"] = (vtkPDirectionField.GATHER, vtkPDirectionField.DISTRIBUTED)[distribute]
    part = make(vtkPDirectionField, options, Surfaces.piece(points, triangles, arrays, owner, rank, **kind))
    if "noise" not in kind:
        # Moved points have another field, but as many of them are shared.
        compare(whole, part, options.get("Degree", 4), name)
        compare_singularities(whole, part, name)
    done = Surfaces.array(part.GetOutput().GetFieldData(), "Distribution").reshape(-1)
    pieces = len(np.unique(owner))
    if pieces == 1:
        check(done[0] == 0, name, done)
        return
    shared = np.zeros((count, len(points)), dtype=bool)
    for process in range(count):
        shared[process, triangles[owner == process].reshape(-1)] = True
    is_possible = (surface in DISTRIBUTED_SURFACES and field in DISTRIBUTED_FIELDS or
                   surface in ONE_SIDED and field in DISTRIBUTED_ONE_SIDED or
                   surface in ("bounded", "strip", "mixed") and field in DISTRIBUTED_WITH_BOUNDARY)
    used = 2 if distribute and is_possible else 1
    texts = warnings_of(part)
    if surface == "inside out":
        told, = warnings_of(whole)
        check("wound inside out" in told and told in texts, name, told, texts)
    reasons = sum("gathered on one process, for " in text for text in texts)
    check(reasons == (1 if distribute and not is_possible else 0), name, texts)
    check(done.tolist() == [used, pieces, int((shared.sum(axis=0) > 1).sum())], name, done)


def main():
    distribute = "distributed" in sys.argv[2:]
    for surface in [name for name in sys.argv[2:] if name != "distributed"] or ORDINARY:
        for way in WAYS:
            run(surface, way, "smoothest", distribute)
        for k, field in enumerate(FIELDS):
            run(surface, ("random", "slabs with ghosts")[k % 2], field, distribute)
        # A process without any of the surface takes part in what its guidance needs.
        for field in ("guided", "given", "boundary", "aligned"):
            run(surface, "empty", field, distribute)
    if distribute and "closed" in sys.argv[2:]:
        # Where it is flat the field goes on from where it is curved.
        for way in ("slabs", "random with ghosts", "empty"):
            run("inside out", way, "aligned lines", distribute)
        # Most of a component has noise, though not most of what each process has of it.
        for way in ("slabs", "random with ghosts", "empty"):
            run("noisy", way, "aligned", distribute)


main()
end()
