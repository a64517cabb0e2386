// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaceMesh/FaceCounts.h"

#include <cstddef>

namespace DirectionFields::Internal
{
FaceCounts::FaceCounts(const FaceMesh& mesh, int degree)
{
  std::vector<int> valence(mesh.Points.size(), 0);
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    (face[3] == None ? this->Triangles : this->Quads) += 1;
    for (const Index v : face)
    {
      if (v != None)
      {
        ++valence[v];
      }
    }
  }
  for (std::size_t v = 0; v < valence.size(); ++v)
  {
    const bool isRegular = valence[v] == degree || mesh.Vertices[v].IsBoundary;
    this->IrregularVertices += isRegular ? 0 : 1;
  }
}
}
