// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RemeshReports_h
#define DirectionFields_RemeshReports_h

#include "Remesh.h"

#include <string>
#include <vector>

namespace DirectionFields
{
/// The least sine of an angle of each face, with the sign of its side: 1 for a square and, as by
/// Verdict, for an even triangle, too; not positive for a face that is folded.
std::vector<double> ScaledJacobians(const RemeshResult& mesh);

/// An interior vertex with another number of edges than 4, or 6 for triangles.
struct IrregularVertex
{
  Index Point;
  int Edges;
};

/// All of them, by their points. Takes n log n time.
/// @param degree of the field, 4 or 6, which is the number of edges of a regular vertex
std::vector<IrregularVertex> IrregularVertices(const RemeshResult& mesh, int degree);

/// One line in ASCII that describes the mesh. Lengths are in the surface's unit, with three digits.
/// @param leastScaledJacobian of all faces
std::string Summary(const RemeshResult& mesh, double leastScaledJacobian);
}

#endif
