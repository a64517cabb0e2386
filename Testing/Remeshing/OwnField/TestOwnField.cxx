// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

using namespace DirectionFields;

namespace
{
RemeshResult Remeshed(const Surface& surface, Index faces, double strength,
  FieldAlignment alignment = FieldAlignment::Shape)
{
  RemeshOptions options;
  options.NumberOfFaces = faces;
  options.Alignment = alignment;
  options.AlignmentStrength = strength;
  return Remesh(std::make_shared<Surface>(surface)).Compute(options);
}

/// Follows the lines of edges of a mesh of quads straight through its vertices.
class EdgeLines
{
public:
  explicit EdgeLines(const RemeshResult& mesh)
  {
    for (const std::array<Index, 4>& face : mesh.Faces)
    {
      for (int c = 0; c < 4; ++c)
      {
        this->Next[{ face[c], face[(c + 1) % 4] }] = face[(c + 2) % 4];
      }
    }
  }

  /// Calls a function with the edges of each line, once in each direction.
  void ForEach(const std::function<void(const std::vector<std::array<Index, 2>>&)>& visit) const
  {
    std::map<std::array<Index, 2>, bool> isSeen;
    for (const auto& start : this->Next)
    {
      std::vector<std::array<Index, 2>> line;
      for (std::array<Index, 2> edge = start.first; edge[1] != None && !isSeen[edge];)
      {
        isSeen[edge] = true;
        line.push_back(edge);
        edge = { edge[1], this->StraightOn(edge) };
      }
      if (!line.empty())
      {
        visit(line);
      }
    }
  }

private:
  /// None on the boundary.
  Index StraightOn(const std::array<Index, 2>& edge) const
  {
    const auto left = this->Next.find(edge);
    if (left == this->Next.end())
    {
      return None;
    }
    const auto across = this->Next.find({ left->second, edge[1] });
    return across == this->Next.end() ? None : across->second;
  }

  /// The vertex after each directed edge in the face on its left.
  std::map<std::array<Index, 2>, Index> Next;
};

/// By how many turns an angle grows along a line.
double Turns(const std::vector<std::array<Index, 2>>& line, const RemeshResult& mesh,
  const std::function<double(const Vector3&)>& angle)
{
  double sum = 0.0;
  for (const std::array<Index, 2>& edge : line)
  {
    sum += std::remainder(angle(mesh.Points[edge[1]]) - angle(mesh.Points[edge[0]]), 2.0 * Pi);
  }
  return sum / (2.0 * Pi);
}

/// A tube around an arc of a circle of radius 3, whose own radius goes up and down, with the
/// angles of a place along the arc and around it.
constexpr double Bend = 3.0;
double Along(const Vector3& p)
{
  return std::atan2(p[1], p[0]);
}
double Around(const Vector3& p)
{
  return std::atan2(p[2], std::hypot(p[0], p[1]) - Bend);
}
Surface BentTube(int around, int along)
{
  Surface tube = Meshes::Cylinder(around, along, 1.0);
  for (Vector3& p : tube.Points)
  {
    const double t = 3.0 * p[2];
    const double radius = 0.5 + 0.15 * std::sin(4.0 * t);
    const double out = Bend + radius * p[0];
    p = Vector3(out * std::cos(t), out * std::sin(t), radius * p[1]);
  }
  return tube;
}
}

TEST(OwnField, LoopsOfEdgesCloseAroundATorus)
{
  for (const double minor : { 0.25, 0.4, 0.7 })
  {
    const RemeshResult mesh = Remeshed(Meshes::Torus(96, 40, 1.0, minor), 2000, 0.25);
    EXPECT_EQ(Meshes::FlawOf(mesh), "");
    EXPECT_EQ(mesh.Triangles, 0) << minor;
    EXPECT_EQ(mesh.IrregularVertices, 0) << minor;
    EXPECT_NEAR(mesh.Quads, 2000.0, 100.0) << minor;
    const auto along = [](const Vector3& p) { return std::atan2(p[1], p[0]); };
    const auto across = [](const Vector3& p)
    { return std::atan2(p[2], std::hypot(p[0], p[1]) - 1.0); };
    EdgeLines(mesh).ForEach(
      [&](const std::vector<std::array<Index, 2>>& line)
      {
        // Once around one way, and not around the other way.
        EXPECT_EQ(line.back()[1], line.front()[0]);
        EXPECT_NEAR(
          std::abs(Turns(line, mesh, along)) + std::abs(Turns(line, mesh, across)), 1.0, 1e-9)
          << minor;
      });
  }
}

TEST(OwnField, NoLineOfEdgesWindsAroundABentTube)
{
  const RemeshResult mesh = Remeshed(BentTube(40, 120), 1500, 0.25);
  EXPECT_EQ(Meshes::FlawOf(mesh), "");
  EXPECT_EQ(mesh.Triangles, 0);
  EXPECT_EQ(mesh.IrregularVertices, 0);
  EdgeLines(mesh).ForEach(
    [&](const std::vector<std::array<Index, 2>>& line)
    {
      const double around = std::abs(Turns(line, mesh, Around));
      if (line.back()[1] == line.front()[0])
      {
        EXPECT_NEAR(around, 1.0, 1e-9);
        EXPECT_NEAR(Turns(line, mesh, Along), 0.0, 1e-9);
      }
      else
      {
        EXPECT_LT(around, 0.1);
      }
    });
}

TEST(OwnField, StrengthZeroIsTheSmoothestField)
{
  const Surface surface = Meshes::Potato(4);
  const RemeshResult none = Remeshed(surface, 500, 0.0);
  const RemeshResult smooth = Remeshed(surface, 500, 0.25, FieldAlignment::Smooth);
  const RemeshResult shape = Remeshed(surface, 500, 0.25);
  EXPECT_EQ(none.Points, smooth.Points);
  EXPECT_NE(shape.Points, smooth.Points);
}

TEST(OwnField, AnotherAlignmentIsAnotherMeshOfTheSameMesher)
{
  const auto surface = std::make_shared<Surface>(Meshes::Potato(4));
  RemeshOptions options;
  options.NumberOfFaces = 500;
  Remesh kept(surface);
  kept.Compute(options);
  options.SingularityCost = 0.0;
  EXPECT_EQ(kept.Compute(options).Points, Remesh(surface).Compute(options).Points);
  options.Alignment = FieldAlignment::Smooth;
  EXPECT_EQ(kept.Compute(options).Points, Remesh(surface).Compute(options).Points);
}

namespace
{
/// The standard deviation of the lengths of edges over their mean, those of interior edges twice.
double Unevenness(const RemeshResult& mesh)
{
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (const std::array<Index, 4>& face : mesh.Faces)
  {
    const int size = face[3] == None ? 3 : 4;
    for (int c = 0; c < size; ++c)
    {
      const double length = (mesh.Points[face[(c + 1) % size]] - mesh.Points[face[c]]).norm();
      count += 1.0;
      sum += length;
      squares += length * length;
    }
  }
  return std::sqrt(squares * count / (sum * sum) - 1.0);
}
}

TEST(OwnField, CheapSingularitiesMakeEdgesEven)
{
  // A ball with limbs of several lengths.
  Surface body = Meshes::Icosphere(5);
  for (Vector3& p : body.Points)
  {
    double height = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      height += (1.25 + 0.625 * axis) * std::exp(6.0 * (std::abs(p[axis]) - 1.0));
    }
    p *= height;
  }
  const auto surface = std::make_shared<Surface>(body);
  RemeshOptions options;
  options.NumberOfFaces = 2000;
  Remesh mesher(surface);
  const RemeshResult dear = mesher.Compute(options);
  options.SingularityCost = 0.0;
  const RemeshResult cheap = mesher.Compute(options);
  EXPECT_GT(cheap.IrregularVertices, dear.IrregularVertices);
  EXPECT_LT(Unevenness(cheap), 0.95 * Unevenness(dear));
}

TEST(OwnField, TrianglesAreMadeAlongTheSmoothestField)
{
  const auto surface = std::make_shared<Surface>(Meshes::Potato(3));
  RemeshOptions options;
  options.NumberOfFaces = 500;
  options.Element = Element::Triangles;
  const RemeshResult mesh = Remesh(surface).Compute(options);
  options.Alignment = FieldAlignment::Smooth;
  EXPECT_EQ(mesh.Points, Remesh(surface).Compute(options).Points);
}
