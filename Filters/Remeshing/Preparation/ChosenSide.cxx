// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Preparation/ChosenSide.h"

#include <utility>

namespace DirectionFields::Internal
{
std::vector<char> ChosenSide(const TriangleMesh& mesh, const std::vector<Vector3>& points)
{
  constexpr int mostSweeps = 200;
  std::vector<char> isChosen(mesh.GetNumberOfTriangles());
  std::vector<Index> covered;
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    isChosen[t] = mesh.IsFront(t) ? 1 : 0;
    if (mesh.IsFront(t) && mesh.Mirror(3 * t) != None)
    {
      covered.push_back(t);
    }
  }
  bool hasChanged = true;
  for (int k = 0; k < mostSweeps && hasChanged; ++k)
  {
    hasChanged = false;
    for (const Index front : covered)
    {
      const Index back = mesh.Mirror(3 * front) / 3;
      const Index t = isChosen[front] != 0 ? front : back;
      // By how much the line becomes shorter if the triangle is taken from the other side.
      double shorter = 0.0;
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index twin = mesh.Twin(h);
        const double length =
          (points[mesh.Point(mesh.Head(h))] - points[mesh.Point(mesh.Tail(h))]).norm();
        shorter += twin == None ? 0.0 : (isChosen[twin / 3] != 0 ? -length : length);
      }
      if (shorter > 0.0)
      {
        std::swap(isChosen[front], isChosen[back]);
        hasChanged = true;
      }
    }
  }
  return isChosen;
}
}
