// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Curves/CurveSentences.h"

#include "Support/Sentences.h"

#include <algorithm>

namespace DirectionFields::Internal
{
bool IsDot(const std::vector<Vector3>& curve)
{
  return std::all_of(
    curve.begin(), curve.end(), [&](const Vector3& place) { return place == curve.front(); });
}

std::string AboutFarPoints(const std::vector<Index>& points)
{
  return Numbered("Point", points) + (points.size() > 1 ? " are no vertices" : " is no vertex") +
    " of the mesh: farther from the surface than a hundredth of its diagonal. Points have to lie on "
    "it.";
}

std::string AboutFarCurves(const std::vector<Index>& curves)
{
  return "Parts of " + Numbered("curve", curves) +
    " are no lines of the mesh: they are farther from the surface than a hundredth of its diagonal, "
    "or the surface ends between two of their points. Curves have to lie on it.";
}

std::string AboutDots(const std::vector<Index>& curves)
{
  return Numbered("Curve", curves) +
    (curves.size() > 1 ? " have no length and are no lines" : " has no length and is no line") +
    " of the mesh. A point that is to be a vertex of it is given as a vertex cell.";
}
}
