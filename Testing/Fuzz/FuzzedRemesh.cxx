// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FuzzedRemesh.h"

#include "FuzzedSurface.h"
#include "Meshes/Remeshed.h"
#include "Meshes/Surfaces.h"
#include "Remesh.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace DirectionFields;

namespace
{
constexpr std::size_t OptionsSize = 16;

RemeshOptions ReadOptions(const Bytes& bytes)
{
  RemeshOptions options;
  options.Element = bytes.At(0) % 3 == 2 ? Element::Triangles : Element::Quads;
  // The default takes long for so many inputs.
  // Billions would be made, too, and ten times the largest number is none.
  options.NumberOfFaces =
    std::clamp(Whole(bytes.At(1), 100, 1, 240), -1, 241) * (bytes.At(2) % 4 == 3 ? 10 : 1);
  options.UseEdgeLength = bytes.At(3) % 4 == 1;
  options.EdgeLength = Real(bytes.At(4), 0.5, 0.05, 4.0);
  options.PureQuads = bytes.At(5) % 2 != 0;
  options.KeepFeatures = bytes.At(6) % 2 == 0;
  options.FeatureAngle = Real(bytes.At(7), options.FeatureAngle, 0.0, 180.0);
  options.MinimumFeatureLength = Real(bytes.At(8), options.MinimumFeatureLength, 0.0, 1.0);
  options.SmoothingIterations = Whole(bytes.At(9), 3, 0, 12);
  options.Alignment = bytes.At(11) % 2 == 0 ? FieldAlignment::Shape : FieldAlignment::Smooth;
  options.AlignmentStrength = Real(bytes.At(12), options.AlignmentStrength, 0.0, 1.0);
  options.SingularityCost = Real(bytes.At(13), options.SingularityCost, 0.0, 4.0);
  options.KeepThinParts = bytes.At(14) % 2 == 0;
  options.KeepSoftFeatures = bytes.At(6) / 2 % 2 == 0;
  options.NumberOfThreads = bytes.At(10) < FirstInvalid ? static_cast<int>(bytes.At(10) % 4) : -1;
  return options;
}

bool AreValid(const RemeshOptions& options, const Surface& surface)
{
  try
  {
    Check(options, surface.Points.size(), surface.Triangles.size());
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
  return true;
}

/// Bytes from here on make a surface hard to remesh.
constexpr unsigned FirstHard = 192;

/// A surface with noise, handles or long triangles, as scanners, isosurfaces and CAD programs make them.
Surface Harder(unsigned byte, Surface surface)
{
  using namespace Meshes;
  const bool isSound = std::all_of(surface.Triangles.begin(), surface.Triangles.end(),
    [&](const Triangle& t) {
      return std::all_of(t.begin(), t.end(), [&](Index point) { return Exists(point, surface); });
    });
  if (byte < FirstHard || !isSound)
  {
    return surface;
  }
  const int amount = static_cast<int>(byte - FirstHard) / 4;
  switch (byte % 4)
  {
    case 0:
      // Up to nearly two edges.
      return Roughened(std::move(surface), 0.125 * amount, byte);
    case 1:
      return Roughened(FlatlySubdivided(DoubleTorus(), 1), 0.02 * amount, byte);
    case 2:
      // One triangle from end to end.
      return Joined(surface, Cylinder(3 + 3 * amount, 1, 1.0 + amount));
    default:
      return Transformed(surface,
        Vector3(1.0, 1.0, 1.0 + 4.0 * amount).asDiagonal().toDenseMatrix(), Vector3::Zero());
  }
}

/// One region, runs of triangles, noise, or two halves.
std::vector<Index> Regions(unsigned byte, Index triangles)
{
  std::vector<Index> regions;
  for (Index t = 0; byte % 4 != 0 && t < triangles; ++t)
  {
    regions.push_back(byte % 4 == 1 ? t / 16
        : byte % 4 == 2             ? static_cast<Index>((t * 2654435761U >> 7U) % 3)
                                    : static_cast<Index>(2 * t < triangles));
  }
  return regions;
}

/// Whether a surface may be refused: for ids, and for coordinates of which there are no lengths.
bool MayBeRefused(const Surface& surface)
{
  constexpr double large = 1e150;
  const bool isFar = std::any_of(surface.Points.begin(), surface.Points.end(),
    [](const Vector3& p) { return !p.allFinite() || p.lpNorm<Eigen::Infinity>() > large; });
  return isFar ||
    std::any_of(surface.Triangles.begin(), surface.Triangles.end(),
      [&](const Triangle& t) {
        return std::any_of(
          t.begin(), t.end(), [&](Index point) { return !Exists(point, surface); });
      });
}
}

std::string FuzzedRemesh(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  RemeshOptions options = ReadOptions(bytes);
  const unsigned again = bytes.At(11);
  const unsigned sizing = bytes.At(12);
  const unsigned regions = bytes.At(14);
  const unsigned hardness = bytes.At(15);
  bytes.Skip(OptionsSize);
  const auto surface = std::make_shared<Surface>(Harder(hardness, ReadSurface(bytes)));
  for (std::size_t p = 0; sizing % 2 != 0 && p < surface->Points.size(); ++p)
  {
    options.Sizing.push_back(ReadNumber(bytes));
  }
  options.Regions = Regions(regions, static_cast<Index>(surface->Triangles.size()));
  const bool isValid = AreValid(options, *surface);
  Remesh remesh(surface);
  RemeshResult mesh;
  try
  {
    mesh = remesh.Compute(options);
    if (again % 2 != 0)
    {
      const std::vector<Vector3> points = mesh.Points;
      RemeshOptions other = options;
      other.NumberOfFaces = options.NumberOfFaces / 2 + 1;
      remesh.Compute(other);
      mesh = remesh.Compute(options);
      if (mesh.Points != points)
      {
        return "another mesh after one of another size";
      }
    }
  }
  catch (const std::invalid_argument& error)
  {
    return isValid ? std::string("refused: ") + error.what() : "";
  }
  catch (const MeshError& error)
  {
    return MayBeRefused(*surface) ? "" : std::string("refused: ") + error.what();
  }
  if (!isValid)
  {
    return "invalid options were taken";
  }
  // Surfaces of one side have no common winding, and where more than two triangles meet in an edge more than two
  // faces do.
  const bool hasSeams =
    mesh.Repaired.NonManifoldEdges > 0 || mesh.Repaired.NonOrientableComponents > 0;
  return hasSeams ? "" : Meshes::FlawOf(mesh);
}
