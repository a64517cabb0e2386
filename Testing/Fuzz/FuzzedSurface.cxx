// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedSurface.h"

#include "Meshes/Surfaces.h"

#include <cmath>
#include <utility>

using namespace DirectionFields;

namespace
{
/// Surfaces that have hardly any shape but that of noise, as scans and surfaces turned in space do.
Surface ReadNoisy(unsigned kind, Bytes& bytes)
{
  using namespace Meshes;
  // From the size of rounding to several edges.
  const double noise = std::pow(10.0, bytes.Take() / 15.0 - 16.0);
  const unsigned seed = bytes.Take();
  const Eigen::Matrix3d turn = ObliqueRotation(0.1 * seed);
  const Surface flat = Jittered(Transformed(Square(5), turn, Vector3::Zero()), noise, seed);
  switch (kind % 5)
  {
    case 0:
      return Jittered(Potato(2), noise, seed);
    case 1:
      return Jittered(Disk(5), noise, seed);
    case 2:
      return flat;
    case 3:
      return Joined(flat, Potato(1));
    default:
    {
      // As single precision has it.
      Surface rounded = Transformed(LShape(4), turn, Vector3::Constant(noise * 1e16));
      for (Vector3& point : rounded.Points)
      {
        point = point.cast<float>().cast<double>();
      }
      return rounded;
    }
  }
}

constexpr unsigned FirstNoisy = 230;

Surface ReadBase(unsigned byte, Bytes& bytes)
{
  using namespace Meshes;
  if (byte >= FirstInvalid)
  {
    // Enough vertices for multigrid.
    return byte % 2 != 0 ? Potato(3) : Disk(12);
  }
  if (byte >= FirstNoisy)
  {
    return ReadNoisy(byte, bytes);
  }
  switch (byte % 12)
  {
    case 1:
      return Tetrahedron();
    case 2:
      return Octahedron();
    case 3:
      return Icosahedron();
    case 4:
      return Cube();
    case 5:
      return Potato(1);
    case 6:
      return Torus(8, 6);
    case 7:
      return Disk(3);
    case 8:
      return Square(4);
    case 9:
      return Cylinder(7, 2, 1.0);
    case 10:
      return MoebiusStrip(8);
    case 11:
      return Joined(Tetrahedron(), Cube());
    default:
      return {};
  }
}

/// An id of a point, or now and then one that does not exist.
Index ReadPoint(Bytes& bytes, const Surface& surface)
{
  const auto points = static_cast<Index>(surface.Points.size());
  const auto byte = static_cast<Index>(bytes.Take());
  return byte == 255 ? bytes.Take() % 2 != 0 ? points : None : points == 0 ? 0 : byte % points;
}

Triangle& ReadTriangle(Bytes& bytes, Surface& surface)
{
  return surface.Triangles[bytes.Take() % surface.Triangles.size()];
}

void ReadEdit(Bytes& bytes, Surface& surface)
{
  const unsigned edit = bytes.Take() % 8;
  if (edit == 0)
  {
    surface.Points.push_back(ReadVector(bytes));
  }
  else if (edit == 1)
  {
    const Index a = ReadPoint(bytes, surface);
    const Index b = ReadPoint(bytes, surface);
    surface.Triangles.push_back({ a, b, ReadPoint(bytes, surface) });
  }
  else if (edit == 2)
  {
    const Index point = ReadPoint(bytes, surface);
    const Vector3 place = ReadVector(bytes);
    if (Exists(point, surface))
    {
      surface.Points[point] = place;
    }
  }
  else if (edit == 3)
  {
    // One place, two points.
    const Index from = ReadPoint(bytes, surface);
    const Index to = ReadPoint(bytes, surface);
    if (Exists(from, surface) && Exists(to, surface))
    {
      surface.Points[from] = surface.Points[to];
    }
  }
  else if (!surface.Triangles.empty())
  {
    Triangle& triangle = ReadTriangle(bytes, surface);
    if (edit == 4)
    {
      triangle[bytes.Take() % 3] = ReadPoint(bytes, surface);
    }
    else if (edit == 5)
    {
      std::swap(triangle[0], triangle[1]);
    }
    else if (edit == 6)
    {
      const Triangle copy = triangle;
      surface.Triangles.push_back(copy);
    }
    else
    {
      triangle = surface.Triangles.back();
      surface.Triangles.pop_back();
    }
  }
}
}

bool Exists(Index point, const Surface& surface)
{
  return point >= 0 && point < static_cast<Index>(surface.Points.size());
}

Surface ReadSurface(Bytes& bytes)
{
  const unsigned base = bytes.Take();
  Surface surface = ReadBase(base, bytes);
  const unsigned scale = bytes.Take();
  const Vector3 shift = scale >= 128 ? ReadVector(bytes) : Vector3::Zero();
  const unsigned edits = bytes.Take();
  for (unsigned k = 0; k < edits && !bytes.AtEnd(); ++k)
  {
    ReadEdit(bytes, surface);
  }
  const int exponent = static_cast<int>(scale % 128);
  const double factor = std::pow(10.0, exponent > 63 ? exponent - 128 : exponent);
  for (Vector3& point : surface.Points)
  {
    point = factor * point + shift;
  }
  return surface;
}
