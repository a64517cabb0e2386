// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SolverFiles/ShellChecks.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace DirectionFields::Internal
{
int CornersOf(const std::array<Index, 4>& face)
{
  return face[3] == None ? 3 : 4;
}

Vector3 NormalOf(const ShellMesh& mesh, const std::array<Index, 4>& face)
{
  const Vector3& a = mesh.Points[face[0]];
  const Vector3& b = mesh.Points[face[1]];
  const Vector3& c = mesh.Points[face[2]];
  return face[3] == None ? (b - a).cross(c - a) : (c - a).cross(mesh.Points[face[3]] - b);
}

namespace
{
void CheckSets(const std::vector<NamedSet>& sets, std::size_t count, const char* members)
{
  for (const NamedSet& set : sets)
  {
    for (const Index member : set.Members)
    {
      if (member < 0 || static_cast<std::size_t>(member) >= count)
      {
        throw std::invalid_argument("The set \"" + set.Name + "\" has the number " +
          std::to_string(member) + ", but there are " + std::to_string(count) + " " + members +
          ", from 0 on.");
      }
    }
  }
}

void CheckFace(const ShellMesh& mesh, std::size_t f)
{
  const std::array<Index, 4>& face = mesh.Faces[f];
  const int corners = CornersOf(face);
  for (int k = 0; k < corners; ++k)
  {
    if (face[k] < 0 || static_cast<std::size_t>(face[k]) >= mesh.Points.size())
    {
      throw std::invalid_argument("Face " + std::to_string(f) + " has the point " +
        std::to_string(face[k]) + ", but there are " + std::to_string(mesh.Points.size()) +
        ", from 0 on.");
    }
    if (!mesh.Points[face[k]].allFinite())
    {
      throw std::invalid_argument("The coordinates of point " + std::to_string(face[k]) +
        " are no finite numbers. Remove it with its faces.");
    }
  }
  // As no solver takes them, which say so with numbers of their own only.
  if (!(NormalOf(mesh, face).stableNorm() > 0.0))
  {
    throw std::invalid_argument("Face " + std::to_string(f) +
      " has no area: two of its corners are at one place, or all on a line. Remove it, or join "
      "such points with Clean.");
  }
  // With an area it is a quad, and these two are beside each other.
  for (int k = 1; k < corners; ++k)
  {
    if (std::find(face.begin(), face.begin() + k, face[k]) != face.begin() + k)
    {
      throw std::invalid_argument("Face " + std::to_string(f) + " has point " +
        std::to_string(face[k]) + " twice. Clean makes a triangle of it.");
    }
  }
}
}

void CheckMesh(const ShellMesh& mesh)
{
  if (mesh.Faces.empty())
  {
    throw std::invalid_argument("The mesh has no faces to write.");
  }
  if (!mesh.Directions.empty() && mesh.Directions.size() != mesh.Faces.size())
  {
    throw std::invalid_argument("There are " + std::to_string(mesh.Directions.size()) +
      " directions for " + std::to_string(mesh.Faces.size()) + " faces.");
  }
  for (std::size_t f = 0; f < mesh.Faces.size(); ++f)
  {
    CheckFace(mesh, f);
  }
  CheckSets(mesh.FaceSets, mesh.Faces.size(), "faces");
  CheckSets(mesh.PointSets, mesh.Points.size(), "points");
}
}
