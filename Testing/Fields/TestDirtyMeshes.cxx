// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionField.h"
#include "Meshes/Soundness.h"
#include "Meshes/Surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

using namespace DirectionFields;
using namespace Meshes;

namespace
{
class Dirt
{
public:
  explicit Dirt(unsigned seed)
    : Engine(seed)
  {
  }

  unsigned Pick(std::size_t n) { return static_cast<unsigned>(this->Engine() % n); }
  double Fraction() { return this->Engine() / 4294967296.0; }
  bool Chance(double probability) { return this->Fraction() < probability; }

  Triangle& AnyTriangle(Surface& s) { return s.Triangles[this->Pick(s.Triangles.size())]; }
  Index AnyPoint(const Surface& s) { return static_cast<Index>(this->Pick(s.Points.size())); }

  /// One of the things that go wrong with meshes.
  void Spoil(Surface& s)
  {
    if (s.Triangles.empty())
    {
      return;
    }
    Triangle& t = this->AnyTriangle(s);
    switch (this->Pick(11))
    {
      case 0:
        std::swap(t[0], t[1]);
        break;
      case 1:
        s.Triangles.push_back(t);
        break;
      case 2:
        s.Triangles.erase(s.Triangles.begin() + this->Pick(s.Triangles.size()));
        break;
      case 3:
        t[0] = t[1];
        break;
      case 4:
        s.Points[t[0]] = s.Points[t[1]];
        break;
      case 5:
        s.Points[t[0]] = 0.5 * (s.Points[t[1]] + s.Points[t[2]]);
        break;
      case 6:
        s.Points[t[0]] = s.Points[t[1]] = s.Points[t[2]];
        break;
      case 7:
        // Two points become one, anywhere: pinched, glued and crowded.
        this->Merge(s, this->AnyPoint(s), this->AnyPoint(s));
        break;
      case 8:
      {
        const Index tip = static_cast<Index>(s.Points.size());
        const Triangle base = t;
        s.Points.push_back(s.Points[base[0]] + Vector3(0.1, 0.2, 0.7));
        s.Triangles.push_back({ base[0], base[1], tip });
        break;
      }
      case 9:
        s.Triangles.push_back({ this->AnyPoint(s), this->AnyPoint(s), this->AnyPoint(s) });
        break;
      default:
        s.Points[this->AnyPoint(s)] *= std::pow(10.0, 6.0 * this->Fraction() - 3.0);
    }
  }

private:
  static void Merge(Surface& s, Index from, Index to)
  {
    for (Triangle& t : s.Triangles)
    {
      std::replace(t.begin(), t.end(), from, to);
    }
  }

  std::mt19937 Engine;
};

/// Statements that hold for any surface.
void ExpectSound(const Surface& surface, const Options& options, const Result& result)
{
  ASSERT_EQ(Flaw(surface, options, result), "");
  for (const ComponentReport& component : result.Components)
  {
    EXPECT_TRUE(component.Converged)
      << "residual " << component.Residual << ", system " << component.SystemResidual;
  }
}
}

TEST(DirtyMeshes, AnyDirtGivesASoundField)
{
  Index nonOrientable = 0;
  for (unsigned seed = 0; seed < 1500; ++seed)
  {
    Dirt dirt(seed);
    const std::vector<Surface> surfaces = { Icosahedron(), Cube(), Potato(1), Torus(8, 6), Disk(3),
      Square(4), Joined(Tetrahedron(), Cube()) };
    Surface surface = surfaces[dirt.Pick(surfaces.size())];
    for (unsigned k = dirt.Pick(7); k > 0; --k)
    {
      dirt.Spoil(surface);
    }
    Options options;
    options.Degree = 1 + static_cast<int>(dirt.Pick(6));
    options.ConstrainBoundary = dirt.Chance(0.3);
    options.ConstrainSharpEdges = dirt.Chance(0.3);
    options.ConstraintSolver =
      dirt.Chance(0.5) ? ConstraintSolver::Energy : ConstraintSolver::LeastSquares;
    if (options.Degree == 2 || options.Degree == 4)
    {
      options.Alignment = dirt.Chance(0.3) ? Alignment::PrincipalCurvature : Alignment::None;
      options.ConstrainCurvature = dirt.Chance(0.3);
    }
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Result result = DirectionField(surface).Compute(options);
    ExpectSound(surface, options, result);
    nonOrientable += result.Repaired.NonOrientableComponents;
    if (HasFatalFailure())
    {
      return;
    }
  }
  EXPECT_GT(nonOrientable, 0);
}

TEST(DirtyMeshes, RandomTriangleSoup)
{
  for (unsigned seed = 0; seed < 500; ++seed)
  {
    Dirt dirt(seed + 10000);
    Surface surface;
    for (unsigned k = 1 + dirt.Pick(12); k > 0; --k)
    {
      surface.Points.emplace_back(dirt.Fraction(), dirt.Fraction(), dirt.Fraction());
    }
    for (unsigned k = dirt.Pick(25); k > 0; --k)
    {
      surface.Triangles.push_back(
        { dirt.AnyPoint(surface), dirt.AnyPoint(surface), dirt.AnyPoint(surface) });
    }
    Options options;
    options.Degree = 1 + static_cast<int>(dirt.Pick(16));
    SCOPED_TRACE("seed " + std::to_string(seed));
    ExpectSound(surface, options, DirectionField(surface).Compute(options));
    if (HasFatalFailure())
    {
      return;
    }
  }
}
