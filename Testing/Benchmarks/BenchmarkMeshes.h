// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BenchmarkMeshes_h
#define BenchmarkMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

/// The surfaces that the benchmarks compute fields of.
namespace BenchmarkMeshes
{
/// A mesh by its name: a number, the least number of triangles of a Potato; the path of a .ply, .obj or .stl
/// file, followed by @k for k midpoint subdivisions; or one of CliffMeshes.h. Throws std::runtime_error for
/// what is none of these.
vtkSmartPointer<vtkPolyData> Make(const std::string& name);

/// A closed surface without symmetries, bumpy, of well-shaped triangles of about the same size: 20
/// f^2 of them, f the least number that gives those asked for. The second eigenvalue of cross fields
/// is 6 % above the first.
vtkSmartPointer<vtkPolyData> Potato(int triangles);

/// The unit sphere, triangulated likewise.
vtkSmartPointer<vtkPolyData> Sphere(int triangles);
}

#endif
