# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""direction_fields gives, byte for byte, what the filter for VTK gives: 20 surfaces, 12 sets of options."""

import pathlib
import sys
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject

import direction_fields as df
from directionfields_vtk import vtkDirectionField
from surfaces import OCTAHEDRON
from surfaces import torus as smooth_torus

sys.path.append(str(pathlib.Path(__file__).parents[1] / "Checksums"))
import meshes


def quads(made):
    points, cells = made
    return points, meshes.halved(np.asarray(cells))


def triangles(made):
    points, cells = made
    return np.asarray(points, float), np.asarray([list(cell) for cell in cells])


SURFACES = {
    "octahedron": OCTAHEDRON,
    "smooth torus": smooth_torus(10, 20),
    "torus": quads(meshes.torus(20, 10)),
    "sphere": meshes.icosphere(2),
    "potato": meshes.potato(2),
    "plane": quads(meshes.plane(8)),
    "hill": quads(meshes.plane(9, lambda x, y: (x, y, 0.3 * np.sin(4.0 * x * y)))),
    "vase": quads(meshes.vase()),
    "moebius": quads(meshes.moebius(24, 3)),
    "klein bottle": quads(meshes.klein_bottle(20, 12)),
    "box": quads(meshes.box(3, 2, 2)),
    "pierced box": quads(meshes.box(3, 3, 1, holes=[(1, 1, 0)])),
    "cubes on an edge": quads(meshes.voxels(np.eye(2)[:, :, None])),
    "cone": triangles(meshes.cone(17)),
    "soup": meshes.soup(*meshes.icosphere(1)),
    "dirty": meshes.dirty(),
    "rough": meshes.rough(*meshes.icosphere(2), 0.05, 1),
    "two": triangles(meshes.joined(meshes.icosphere(1), meshes.potato(1))),
    "flat": quads(meshes.plane(6, lambda x, y: (x, 0.01 * y, 0.0 * x))),
    "large": (1e6 * meshes.potato(2)[0], meshes.potato(2)[1]),
}
OPTIONS = (
    {},
    {"degree": 1, "energy_bias": 0.7},
    {"degree": 2, "alignment": "curvature", "curvature_direction": "least_bent"},
    {"degree": 4, "alignment": "curvature", "alignment_strength": 0.9, "curvature_scale": 3.0},
    {"degree": 6, "constrain_boundary": True, "constrain_sharp_edges": True, "feature_angle": 35.0},
    {"degree": 4, "unit_length": True, "singularity_cost": 1.0},
    {"degree": 3, "alignment": "vectors", "use_shift": True, "shift": 0.5},
    {"degree": 4, "constrain_guidance": True, "constraint_solver": "least_squares"},
    {"degree": 16, "merge_points": "off", "intrinsic_delaunay": True},
    {"degree": 4, "solver": "multigrid", "constrain_curvature": True, "tolerance": 1e-8},
    {"degree": 2, "alignment": "tensor", "tensor_direction": "larger_magnitude"},
    {"degree": 4, "alignment": "tensor", "tensor_strength": 0.9, "constrain_boundary": True},
)


def by_filter(mesh, options):
    vtk = vtkDirectionField()
    vtk.SetInputData(mesh)
    for keyword, value in options.items():
        names = df.options()[keyword][1:]
        if names and isinstance(names[0], list):
            value = names[0].index(value)
        getattr(vtk, "Set" + "".join(word.capitalize() for word in keyword.split("_")))(value)
    vtk.SetTensorArray(0, "tensors")
    vtk.SetGuidanceVectors("Guide")
    vtk.SetGuidanceWeights("Weight")
    vtk.Update()
    return vtk.GetOutput()


class Same(unittest.TestCase):
    def compare(self, points, cells, options):
        mesh = meshes.with_data(meshes.polydata(points, cells))
        data = mesh.GetPointData()
        guide = vtk_to_numpy(data.GetArray("Guide"))
        tensors = np.einsum("pi,pj->pij", guide, guide).reshape(-1, 9)
        data.AddArray(meshes.array("tensors", tensors))
        output = by_filter(mesh, options)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            field = df.field(
                points, cells, vectors=guide,
                tensors=tensors if options.get("alignment") == "tensor" else None,
                weights=vtk_to_numpy(data.GetArray("Weight")), **options)
        data = output.GetPointData()
        for k in range(field.degree):
            expected = vtk_to_numpy(data.GetArray(f"Direction{k}"))
            self.assertEqual(field.directions[:, k].tobytes(), expected.tobytes())
        for name, values in (
                ("RepresentationMagnitude", field.magnitudes), ("EnergyDensity", field.energy_density),
                ("ConstraintDirection", field.constraint_directions),
                ("MajorValue", getattr(field, "major_values", None)),
                ("SurfaceTensor", getattr(field, "surface_tensors", None))):
            array = data.GetArray(name)
            if array:
                self.assertEqual(values.tobytes(), vtk_to_numpy(array).tobytes(), name)
        indices = output.GetCellData().GetArray("SingularityIndex")
        self.assertTrue(np.array_equal(vtk_to_numpy(indices), field.indices))
        told = output.GetFieldData().GetAbstractArray("Summary").GetValue(0)
        self.assertEqual(told.split(", guidance is there")[0], field.summary)
        told = output.GetFieldData().GetAbstractArray("Warnings")
        self.assertEqual(told.GetNumberOfValues() if told else 0, len(field.warnings))

    def test_20_surfaces_with_12_sets_of_options(self):
        vtkObject.GlobalWarningDisplayOff()
        self.assertEqual((len(SURFACES), len(OPTIONS)), (20, 12))
        for name, (points, cells) in SURFACES.items():
            for options in OPTIONS:
                with self.subTest(surface=name, options=options):
                    self.compare(points, cells, options)


if __name__ == "__main__":
    unittest.main()
