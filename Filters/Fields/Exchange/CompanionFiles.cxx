// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/CompanionFiles.h"

#include "Exchange/TextWriter.h"

namespace DirectionFields::Internal
{
const std::string_view ObjMark = "# The mesh of a direction field written by Direction Fields";

std::string WriteObj(const Surface& surface)
{
  TextWriter text;
  text << ObjMark << "\n";
  for (const Vector3& point : surface.Points)
  {
    text << "v " << point << "\n";
  }
  for (const Triangle& triangle : surface.Triangles)
  {
    text << "f " << triangle[0] + 1 << " " << triangle[1] + 1 << " " << triangle[2] + 1 << "\n";
  }
  return text.Take();
}

std::string WriteSharp(const std::vector<SharpEdge>& edges)
{
  TextWriter text;
  text << static_cast<std::int64_t>(edges.size()) << "\n";
  for (const SharpEdge& edge : edges)
  {
    text << (edge.IsConvex ? "1," : "0,") << edge.Triangle << "," << edge.Corner << "\n";
  }
  return text.Take();
}

std::string WriteSingularities(int degree, const std::vector<SingularElement>& elements)
{
  TextWriter text;
  text << degree << " " << static_cast<std::int64_t>(elements.size()) << "\n";
  for (const SingularElement& element : elements)
  {
    text << element.Element << " " << element.SingularityIndex << "\n";
  }
  return text.Take();
}
}
