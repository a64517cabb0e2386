// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/JoinedComponents.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// The least member of a joined set.
int Find(std::vector<int>& parents, int k)
{
  while (parents[k] != k)
  {
    parents[k] = parents[parents[k]];
    k = parents[k];
  }
  return k;
}

/// Joins parts of several processes that share a point, and gives each part a representative of its
/// set.
/// @param border  the part at each point on the border of a piece; -1 for none
/// @param numbers of these points, equal for the same point
std::vector<int> JoinParts(
  std::size_t count, const std::vector<int>& border, const std::vector<vtkIdType>& numbers)
{
  std::vector<int> parents(count);
  std::iota(parents.begin(), parents.end(), 0);
  std::unordered_map<vtkIdType, int> partAt;
  for (std::size_t k = 0; k < border.size(); ++k)
  {
    if (border[k] >= 0)
    {
      const auto [entry, isNew] = partAt.try_emplace(numbers[k], border[k]);
      const int a = Find(parents, entry->second);
      const int b = Find(parents, border[k]);
      parents[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    parents[k] = Find(parents, static_cast<int>(k));
  }
  return parents;
}

/// Numbers the components by their first triangles.
/// @param roots a representative of the component of each part
/// @param first the first triangle of each part, or -1
/// @return the number of each part's component; -1 where no part of it has a triangle
std::vector<int> NumberComponents(
  const std::vector<int>& roots, const std::vector<vtkIdType>& first)
{
  std::unordered_map<int, vtkIdType> firstOfRoot;
  for (std::size_t k = 0; k < roots.size(); ++k)
  {
    if (first[k] >= 0)
    {
      const auto [entry, isNew] = firstOfRoot.try_emplace(roots[k], first[k]);
      entry->second = std::min(entry->second, first[k]);
    }
  }
  std::vector<std::pair<vtkIdType, int>> order;
  for (const auto& [root, triangle] : firstOfRoot)
  {
    order.emplace_back(triangle, root);
  }
  std::sort(order.begin(), order.end());
  std::unordered_map<int, int> numberOfRoot;
  for (const auto& [triangle, root] : order)
  {
    numberOfRoot.emplace(root, static_cast<int>(numberOfRoot.size()));
  }
  std::vector<int> components;
  for (const int root : roots)
  {
    const auto there = numberOfRoot.find(root);
    components.push_back(there == numberOfRoot.end() ? -1 : there->second);
  }
  return components;
}
}

std::vector<vtkIdType> FirstTriangles(const TriangleMesh& mesh, const PieceWithSurroundings& piece)
{
  const auto ownTriangles = static_cast<Index>(piece.InputTriangle.size());
  std::vector<vtkIdType> first;
  for (const TriangleMesh::Component& part : mesh.GetComponents())
  {
    Index least = ownTriangles;
    for (Index t = part.FirstTriangle; t < part.EndTriangle; ++t)
    {
      least = std::min(least, mesh.InputTriangle(t));
    }
    first.push_back(least < ownTriangles ? piece.FirstTriangle + least : -1);
  }
  return first;
}

std::vector<int> JoinedComponents(const std::vector<vtkIdType>& first,
  const std::vector<int>& border, const std::vector<vtkIdType>& numbers)
{
  return NumberComponents(JoinParts(first.size(), border, numbers), first);
}

std::vector<int> OnlyProcesses(
  const std::vector<int>& components, const std::vector<int>& first, int count)
{
  std::vector<int> parts(static_cast<std::size_t>(count), 0);
  std::vector<int> processes(parts.size(), -1);
  for (std::size_t p = 0; p + 1 < first.size(); ++p)
  {
    for (int k = first[p]; k < first[p + 1]; ++k)
    {
      if (components[k] >= 0)
      {
        const bool isOnly = ++parts[components[k]] == 1;
        processes[components[k]] = isOnly ? static_cast<int>(p) : -1;
      }
    }
  }
  return processes;
}
}
