// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CliffMeshes_h
#define CliffMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace BenchmarkMeshes
{
/// Meshes that a solver may fall off at. NAME:TRIANGLES or NAME:TRIANGLES:AMOUNT, where NAME is one of
///   noisy      a Potato, AMOUNT the noise along the normals in edges
///   terrain    a square height field of hills, AMOUNT the noise of the heights in edges
///   noisytorus a torus, AMOUNT the noise along the normals in edges
///   gyroid     the isosurface of AMOUNT^3 periods
///   sphere     round
///   flat       a square in a plane
///   strip      a flat strip of quads, AMOUNT wide, cut in two triangles each
///   blobs      an isosurface of about AMOUNT closed components of different size
///   holes      a flat square with about AMOUNT round holes, which has no point inside
///   polygon    a single concave polygon, of two corners more than triangles
/// The numbers of triangles are about the ones asked for. Null for another name.
vtkSmartPointer<vtkPolyData> MakeCliff(const std::string& name);
}

#endif
