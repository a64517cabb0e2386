// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/FieldImport.h"

#include "Computation/FieldToResult.h"
#include "Exchange/FaceField.h"
#include "Guidance/Guidance.h"
#include "Interpolation/FieldInterpolant.h"
#include "Mesh/MergePoints.h"
#include "Mesh/OutputPoints.h"
#include "Sections/DoubleCover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Directions of a row whose n-th powers agree less than this do not stand at equal angles, by
/// about five degrees for crosses.
constexpr double LeastAgreement = 0.99;
constexpr double LeastTangential = 1e-6;

/// The unit directions of a row as the n-th power in a plane; 0 where there are none.
Complex PowerOf(const FieldFile& file, std::size_t row, const Vector3& x, const Vector3& y)
{
  Complex sum = 0.0;
  for (int k = 0; k < file.PerRow; ++k)
  {
    const Vector3 direction = file.Direction(row, k).stableNormalized();
    const Complex tangential(direction.dot(x), direction.dot(y));
    const double length = std::abs(tangential);
    if (length > LeastTangential)
    {
      sum += IntegerPower(tangential / length, file.Degree);
    }
  }
  return sum / static_cast<double>(file.PerRow);
}

/// How many rows have directions that do not stand at equal angles.
std::size_t CountAsymmetric(const FieldFile& file)
{
  std::size_t count = 0;
  for (std::size_t row = 0; file.PerRow > 1 && row < file.Rows(); ++row)
  {
    const Vector3 x = file.Direction(row, 0).stableNormalized();
    Vector3 normal = Vector3::Zero();
    for (int k = 1; k < file.PerRow; ++k)
    {
      const Vector3 cross = x.cross(file.Direction(row, k).stableNormalized());
      normal = cross.squaredNorm() > normal.squaredNorm() ? cross : normal;
    }
    const Vector3 y = normal.stableNormalized().cross(x);
    count += !x.isZero(0.0) && std::abs(PowerOf(file, row, x, y)) < LeastAgreement ? 1 : 0;
  }
  return count;
}

/// Coordinates as the single precision that meshes are mostly kept in has them.
using Place = std::array<float, 3>;
struct PlaceHash
{
  std::size_t operator()(const Place& place) const
  {
    std::size_t hash = 0;
    for (const float x : place)
    {
      hash = hash * 1000003U ^ std::hash<float>()(x);
    }
    return hash;
  }
};
Place PlaceOf(const Vector3& point)
{
  Place place;
  for (int c = 0; c < 3; ++c)
  {
    // -0 is 0.
    place[static_cast<std::size_t>(c)] = static_cast<float>(point[c]) + 0.0F;
  }
  return place;
}

/// The row of each point, by place; None where there is none.
std::vector<Index> RowsByPlace(const FieldFile& file, const Surface& surface)
{
  std::unordered_map<Place, Index, PlaceHash> rowAt;
  for (std::size_t row = file.Rows(); row-- > 0;)
  {
    rowAt[PlaceOf(file.Places[row])] = static_cast<Index>(row);
  }
  std::vector<Index> rows(surface.Points.size(), None);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const auto found = rowAt.find(PlaceOf(surface.Points[i]));
    rows[i] = found == rowAt.end() ? None : found->second;
  }
  return rows;
}

std::string Counted(std::size_t count, const char* things)
{
  return std::to_string(count) + " " + things;
}

[[noreturn]] void RefuseCount(
  const FieldFile& file, const Surface& surface, FieldOn on, bool facesAreTriangles)
{
  std::string sentence = "The file has " + Counted(file.Rows(), "rows") + ", but the surface has ";
  if (on != FieldOn::Points)
  {
    sentence += facesAreTriangles
      ? Counted(surface.Triangles.size(), "triangles")
      : "faces that are no triangles, for which rows cannot count (Triangulate makes triangles)";
  }
  sentence += on == FieldOn::Automatic ? " and " : "";
  if (on != FieldOn::Cells)
  {
    sentence += Counted(surface.Points.size(), "points");
  }
  throw FileError(sentence +
    ". Give the very mesh that the file belongs to, its points and faces in the same order.");
}

/// Whether the rows are for the triangles (FieldOn::Cells) or the points. Throws FileError.
FieldOn Decide(const FieldFile& file, const Surface& surface, FieldOn on, bool facesAreTriangles)
{
  const bool fitsCells = facesAreTriangles && file.Rows() == surface.Triangles.size();
  const bool fitsPoints = file.Rows() == surface.Points.size();
  if (on != FieldOn::Points && fitsCells && file.Places.empty())
  {
    return FieldOn::Cells;
  }
  if (!file.Places.empty() || (on != FieldOn::Cells && fitsPoints))
  {
    return FieldOn::Points;
  }
  RefuseCount(file, surface, on, facesAreTriangles);
}

/// The section that rows for the points give.
std::vector<Complex> FromPoints(
  const SurfaceGeometry& geometry, const FieldFile& file, const Surface& surface)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const bool isByPlace = file.Rows() != surface.Points.size();
  const std::vector<Index> rows = isByPlace ? RowsByPlace(file, surface) : std::vector<Index>();
  if (isByPlace && std::all_of(rows.begin(), rows.end(), [](Index row) { return row == None; }))
  {
    throw FileError("None of the " + Counted(file.Rows(), "vertices") +
      " of the file is at the place of a point of the surface. Open the mesh from the same file.");
  }
  std::vector<Complex> section(mesh.GetNumberOfVertices(), 0.0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index row = isByPlace ? rows[mesh.Point(v)] : mesh.Point(v);
    if (row != None)
    {
      const Complex power = PowerOf(file, row, geometry.Frames.X[v], geometry.Frames.Y(v));
      const double modulus = std::abs(power);
      section[v] = modulus > LeastTangential ? power / modulus : Complex(0.0);
    }
  }
  return section;
}

std::size_t CountZeros(const TriangleMesh& mesh, const std::vector<Complex>& section)
{
  std::size_t count = 0;
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    count += mesh.IsFrontVertex(v) && section[v] == 0.0 ? 1 : 0;
  }
  return count;
}

/// Makes the section the same on both sides of surfaces that cannot be oriented, to the last bit.
void Symmetrize(const IntrinsicGeometry& geometry, int degree, std::vector<Complex>& section)
{
  for (const TriangleMesh::Component& component : geometry.Mesh.GetComponents())
  {
    if (component.IsCover)
    {
      const DoubleCover cover(geometry, component, degree);
      ComplexVector part =
        Eigen::Map<ComplexVector>(section.data() + component.FirstVertex, component.Vertices());
      cover.Symmetrize(part);
      std::copy(part.begin(), part.end(), section.begin() + component.FirstVertex);
    }
  }
}
}

ImportedField ImportField(const FieldFile& file, const Surface& surface, FieldOn on,
  bool facesAreTriangles, const Progress& progress)
{
  const FieldOn rowsAreFor = Decide(file, surface, on, facesAreTriangles);
  ImportedField imported;
  if (const std::size_t count = CountAsymmetric(file))
  {
    imported.Warnings.push_back("In " + Counted(count, "of ") + Counted(file.Rows(), "rows") +
      " the directions do not stand at equal angles. Those are taken that are nearest to them and do.");
  }
  MergedMesh merged = MergedMesh::AcrossSeams(surface);
  Index mergedPoints = 0;
  for (std::size_t i = 0; i < merged.FirstPoint.size(); ++i)
  {
    mergedPoints += merged.FirstPoint[i] != static_cast<Index>(i) ? 1 : 0;
  }
  const SurfaceGeometry geometry(std::move(merged.Mesh), surface);
  progress.Report(0.5);
  std::vector<Complex> section = rowsAreFor == FieldOn::Cells
    ? ToVertices(geometry,
        FromVectors(geometry, file.Degree, file.Directions, static_cast<std::size_t>(file.PerRow)))
    : FromPoints(geometry, file, surface);
  if (const std::size_t count = CountZeros(geometry.Mesh, section))
  {
    imported.Warnings.push_back("The file has no direction for " + Counted(count, "points") +
      "; they get those of their neighbours.");
    Continue(geometry, file.Degree, section);
  }
  Symmetrize(geometry, file.Degree, section);
  progress.Report(0.7);
  imported.Field.Degree = file.Degree;
  imported.Field.Repaired.MergedPoints = mergedPoints;
  AddSection(geometry, surface, OutputPoints(geometry.Mesh, surface, merged.FirstPoint), section,
    imported.Field);
  return imported;
}
}
