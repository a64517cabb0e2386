// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_RemeshReports_h
#define DirectionFields_RemeshReports_h

#include "Quality/QualityReport.h"
#include "Remesh.h"

#include <string>
#include <vector>

namespace DirectionFields
{
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
/// @param quality of the faces, which says how many fail where there are limits
std::string Summary(const RemeshResult& mesh, const QualityReport& quality);
}

#endif
