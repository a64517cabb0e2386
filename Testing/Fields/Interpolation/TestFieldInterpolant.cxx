// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Geometry/SurfaceGeometry.h"
#include "Interpolation/FieldInterpolant.h"
#include "Interpolation/InterpolantZero.h"
#include "Meshes/Surfaces.h"
#include "Sections/Singularities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace DirectionFields;

namespace
{
const std::vector<int> Degrees = { 1, 2, 3, 4, 6, 9 };

/// Vectors of all lengths and directions: many triangles are singular. On both sides of a cover they are
/// the same.
std::vector<Complex> RandomSection(const SurfaceGeometry& geometry, int degree, unsigned seed)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::mt19937 engine(seed);
  const auto random = [&] { return engine() / 4294967296.0; };
  std::vector<Complex> section;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double length = 0.2 + random();
    section.push_back(std::polar(length, 2.0 * Pi * random()));
  }
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index mirror = mesh.MirrorVertex(v);
    if (mirror != None && mesh.IsFrontVertex(v))
    {
      const Complex turn = geometry.Frames.Tangential(mirror, geometry.Frames.X[v]);
      section[mirror] = std::conj(section[v]) * IntegerPower(turn, degree);
    }
  }
  return section;
}

/// Surfaces that are closed, open, bent, of slivers and covered.
std::vector<Surface> ManySurfaces()
{
  return { Meshes::Tetrahedron(), Meshes::Cube(), Meshes::Potato(2), Meshes::Torus(7, 5),
    Meshes::Hemisphere(2), Meshes::MoebiusStrip(7), Meshes::BadSquare(6, 3),
    Meshes::BadSphere(2, 0.6, 1) };
}

/// A number that is measured against the x axis of the flat triangle, against a direction instead.
Complex Against(const Complex& direction, int degree, const Complex& value)
{
  return value * std::conj(IntegerPower(direction, degree));
}

template <typename Body>
void ForEachField(const Body& body)
{
  for (const Surface& surface : ManySurfaces())
  {
    const SurfaceGeometry geometry(surface);
    for (const int degree : Degrees)
    {
      body(geometry, degree, RandomSection(geometry, degree, 17 + degree));
    }
  }
}
}

TEST(FieldInterpolant, IsTheLinearBlendOfBothEndsOnEdgesFromBothSides)
{
  ForEachField(
    [](const SurfaceGeometry& geometry, int degree, const std::vector<Complex>& section)
    {
      const TriangleMesh& mesh = geometry.Mesh;
      double largest = 0.0;
      for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
      {
        const int c = h % 3;
        const Index twin = mesh.Twin(h);
        const FieldInterpolant here(geometry, degree, section.data(), h / 3);
        const double back = twin == None ? geometry.Transport.AngleSum[mesh.Head(h)]
                                         : geometry.Transport.EdgeAngle[twin];
        const Complex tail =
          section[mesh.Tail(h)] * std::polar(1.0, -degree * geometry.Transport.EdgeAngle[h]);
        const Complex head = section[mesh.Head(h)] * std::polar(1.0, -degree * (back - Pi));
        for (const double part : { 0.0, 0.25, 0.9 })
        {
          const FlatTriangle& flat = here.Flat();
          const Complex place = flat.Corner(c) + part * (flat.Corner((c + 1) % 3) - flat.Corner(c));
          const Complex value = Against(flat.Along(c), degree, here.At(place));
          largest = std::max(largest, std::abs(value - ((1.0 - part) * tail + part * head)));
          if (twin != None)
          {
            const FieldInterpolant there(geometry, degree, section.data(), twin / 3);
            const int d = twin % 3;
            const Complex from = there.Flat().Corner((d + 1) % 3);
            const Complex same = from + part * (there.Flat().Corner(d) - from);
            const Complex other = Against(-there.Flat().Along(d), degree, there.At(same));
            largest = std::max(largest, part > 0.0 ? std::abs(value - other) : 0.0);
          }
        }
      }
      EXPECT_LT(largest, 1e-12) << "degree " << degree;
    });
}

TEST(FieldInterpolant, IsTheGivenVectorAtCorners)
{
  ForEachField(
    [](const SurfaceGeometry& geometry, int degree, const std::vector<Complex>& section)
    {
      const TriangleMesh& mesh = geometry.Mesh;
      for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); h += 5)
      {
        const int c = h % 3;
        const Index v = mesh.Tail(h);
        const FieldInterpolant power(geometry, degree, section.data(), h / 3);
        const double corner = geometry.Lengths.CornerAngle(mesh, h);
        for (const double part : { 0.1, 0.5, 0.8 })
        {
          const Complex ray = power.Flat().Along(c) * std::polar(1.0, part * corner);
          const double away =
            1e-7 * std::min(power.Flat().Length(c), power.Flat().Length((c + 2) % 3));
          const double cone =
            geometry.Transport.EdgeAngle[h] + part * corner * geometry.Transport.Scale[v];
          const Complex value = power.At(power.Flat().Corner(c) + away * ray);
          EXPECT_NEAR(
            std::abs(Against(ray, degree, value) - section[v] * std::polar(1.0, -degree * cone)),
            0.0, 1e-4);
          // The n directions of the vertex, found one by one.
          const double angle = power.AngleInFlat(
            c, std::arg(section[v]) / degree, power.Flat().Corner(c) + away * ray);
          EXPECT_NEAR(
            std::abs(std::polar(1.0, degree * angle) - value / std::abs(value)), 0.0, 1e-4);
        }
      }
    });
}

TEST(FieldInterpolant, WindsByTheIndex)
{
  ForEachField(
    [](const SurfaceGeometry& geometry, int degree, const std::vector<Complex>& section)
    {
      const TriangleMesh& mesh = geometry.Mesh;
      const std::vector<int> indices = SingularityIndices(geometry, degree, section);
      for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
      {
        const FieldInterpolant power(geometry, degree, section.data(), t);
        const FlatTriangle& flat = power.Flat();
        double winding = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          const double scale = geometry.Transport.Scale[mesh.Tail(3 * t + c)];
          winding += degree * (scale - 1.0) * geometry.Lengths.CornerAngle(mesh, 3 * t + c);
          const Complex edge = flat.Corner((c + 1) % 3) - flat.Corner(c);
          // From just after one corner to just before the next one.
          constexpr int steps = 200;
          constexpr double least = 1e-9;
          Complex last = 0.0;
          for (int k = 0; k <= steps; ++k)
          {
            const double part = least + k * (1.0 - 2.0 * least) / steps;
            const Complex value = power.At(flat.Corner(c) + part * edge);
            winding += k > 0 ? std::arg(value / last) : 0.0;
            last = value;
          }
        }
        EXPECT_NEAR(winding, 2.0 * Pi * indices[t], 1e-4) << "degree " << degree;
      }
    });
}

TEST(FieldInterpolant, JetIsTheDerivative)
{
  const SurfaceGeometry geometry(Meshes::Potato(1));
  for (const int degree : Degrees)
  {
    const std::vector<Complex> section = RandomSection(geometry, degree, 3);
    for (Index t = 0; t < geometry.Mesh.GetNumberOfTriangles(); t += 7)
    {
      const FieldInterpolant power(geometry, degree, section.data(), t);
      const Complex place = power.Flat().Place({ 0.2, 0.5, 0.3 });
      const FieldInterpolant::Jet jet = power.JetAt(place);
      EXPECT_LT(std::abs(jet.Value - power.At(place)), 1e-14);
      for (const Complex& step : { Complex(1e-5, 0.0), Complex(0.0, 1e-5) })
      {
        const Complex change = 0.5 * (power.At(place + step) - power.At(place - step));
        EXPECT_LT(std::abs(change - jet.Times(step)), 1e-12);
      }
    }
  }
}

TEST(FieldInterpolant, DoesNotDependOnNumbersPlaceOrScale)
{
  const Surface surface = Meshes::Potato(2);
  std::vector<Index> newPoint;
  std::vector<Index> newTriangle;
  Surface moved = Meshes::Shuffled(surface, 5, newPoint, newTriangle);
  moved = Meshes::Transformed(moved, 3e4 * Meshes::ObliqueRotation(0.7), { 7, 8, 9 });
  const SurfaceGeometry one(surface);
  const SurfaceGeometry two(moved);
  for (const int degree : Degrees)
  {
    // The same directions in space: frames follow the surface.
    const std::vector<Complex> section = RandomSection(one, degree, 8);
    std::vector<Complex> same(section.size());
    std::vector<Index> vertexOfPoint(section.size());
    std::vector<Index> triangleOfInput(surface.Triangles.size());
    for (Index v = 0; v < two.Mesh.GetNumberOfVertices(); ++v)
    {
      vertexOfPoint[two.Mesh.Point(v)] = v;
    }
    for (Index t = 0; t < two.Mesh.GetNumberOfTriangles(); ++t)
    {
      triangleOfInput[two.Mesh.InputTriangle(t)] = t;
    }
    for (Index v = 0; v < one.Mesh.GetNumberOfVertices(); ++v)
    {
      const Index w = vertexOfPoint[newPoint[one.Mesh.Point(v)]];
      const Complex turn = two.Frames.Tangential(w, Meshes::ObliqueRotation(0.7) * one.Frames.X[v]);
      same[w] = section[v] * IntegerPower(turn, degree);
    }
    for (Index t = 0; t < one.Mesh.GetNumberOfTriangles(); ++t)
    {
      const Index other = triangleOfInput[newTriangle[one.Mesh.InputTriangle(t)]];
      int first = 0;
      while (two.Mesh.Point(two.Mesh.Tail(3 * other + first)) !=
        newPoint[one.Mesh.Point(one.Mesh.Tail(3 * t))])
      {
        ++first;
      }
      const std::array<double, 3> weights = { 0.15, 0.25, 0.6 };
      std::array<double, 3> turned;
      for (int c = 0; c < 3; ++c)
      {
        turned[(first + c) % 3] = weights[c];
      }
      const FieldInterpolant here(one, degree, section.data(), t);
      const FieldInterpolant there(two, degree, same.data(), other);
      const Complex a = Against(here.Flat().Along(0), degree, here.At(here.Flat().Place(weights)));
      const Complex b =
        Against(there.Flat().Along(first), degree, there.At(there.Flat().Place(turned)));
      EXPECT_LT(std::abs(a - b), 1e-9);
    }
  }
}

TEST(InterpolantZero, IsFoundWithTheSignOfTheIndex)
{
  int found = 0;
  int singular = 0;
  ForEachField(
    [&](const SurfaceGeometry& geometry, int degree, const std::vector<Complex>& section)
    {
      const std::vector<int> indices = SingularityIndices(geometry, degree, section);
      for (Index t = 0; t < geometry.Mesh.GetNumberOfTriangles(); ++t)
      {
        if (std::abs(indices[t]) != 1)
        {
          continue;
        }
        ++singular;
        const FieldInterpolant power(geometry, degree, section.data(), t);
        const InterpolantZero zero = FindZero(power, indices[t]);
        for (const double weight : power.Flat().Weights(zero.Place))
        {
          EXPECT_GT(weight, 0.99 * InterpolantZero::LeastWeight);
        }
        if (zero.Converged)
        {
          EXPECT_LT(std::abs(power.At(zero.Place)), 1e-11);
          EXPECT_EQ(zero.Sign(), indices[t]);
          ++found;
        }
      }
    });
  // Zeros on the rim of their triangles are rare.
  EXPECT_GT(singular, 1000);
  EXPECT_GE(found, 0.99 * singular) << found << " of " << singular;
}

TEST(InterpolantZero, IsWhereTheFieldOnThePlaneVanishes)
{
  Surface disk = Meshes::Disk(5);
  const Complex center(0.033, 0.021);
  const SurfaceGeometry geometry(disk);
  for (const int index : { 1, -1 })
  {
    std::vector<Complex> section;
    for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
    {
      const Complex z(geometry.Positions[v].x(), geometry.Positions[v].y());
      const Complex x(geometry.Frames.X[v].x(), geometry.Frames.X[v].y());
      const Complex u = index > 0 ? z - center : std::conj(z - center);
      section.push_back(u * std::conj(IntegerPower(x, 4)));
    }
    const std::vector<int> indices = SingularityIndices(geometry, 4, section);
    const auto at = std::find_if(indices.begin(), indices.end(), [](int k) { return k != 0; });
    ASSERT_NE(at, indices.end());
    const auto t = static_cast<Index>(at - indices.begin());
    const FieldInterpolant power(geometry, 4, section.data(), t);
    const InterpolantZero zero = FindZero(power);
    EXPECT_TRUE(zero.Converged);
    const std::array<double, 3> weights = power.Flat().Weights(zero.Place);
    Vector3 place = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      place += weights[c] * geometry.Positions[geometry.Mesh.Tail(3 * t + c)];
    }
    EXPECT_LT((place - Vector3(center.real(), center.imag(), 0.0)).norm(), 1e-12);
    EXPECT_EQ(zero.Sign(), index);
  }
}
