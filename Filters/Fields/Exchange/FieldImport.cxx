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

/// Throws FileError where a component has no direction that the others could be continued from.
void RequireDirections(const TriangleMesh& mesh, const std::vector<Complex>& section)
{
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    const auto begin = section.begin() + component.FirstVertex;
    const auto end = section.begin() + component.EndVertex;
    if (begin != end && std::all_of(begin, end, [](const Complex& u) { return u == 0.0; }))
    {
      throw FileError("The file has no direction for any of the " +
        Counted(static_cast<std::size_t>(component.Vertices()), "points") +
        " of a part of the surface (point " + std::to_string(mesh.Point(component.FirstVertex)) +
        " is one of them): its rows are zero, upright on the surface, or cancel. Rows must be vectors along "
        "the surface.");
    }
  }
}

/// How far the directions of a file stand out of the planes of the elements, in degrees.
class PlaneDeviation
{
public:
  void Add(const FieldFile& file, std::size_t row, const Vector3& normal)
  {
    double largest = 0.0;
    bool isGiven = false;
    for (int k = 0; k < file.PerRow; ++k)
    {
      const Vector3 direction = file.Direction(row, k).stableNormalized();
      isGiven = isGiven || !direction.isZero(0.0);
      largest = std::max(largest, std::abs(direction.dot(normal)));
    }
    if (isGiven && !normal.isZero(0.0))
    {
      const double angle = std::asin(std::min(largest, 1.0)) * 180.0 / Pi;
      this->Sum += angle;
      ++this->Rows;
      this->Outside += angle > Outlying ? 1 : 0;
    }
  }

  /// Throws FileError where directions of most rows stand out of their planes: the mesh must be
  /// another one. A sentence where a few do; else empty.
  /// @param isExact other programs have the same planes, as those of triangles; normals of points
  ///                are a matter of weights
  std::string Check(bool isExact) const
  {
    if (this->Rows == 0)
    {
      return {};
    }
    const double mean = this->Sum / static_cast<double>(this->Rows);
    std::string sentence = "The directions of the file stand out of the surface by " +
      std::to_string(std::lround(mean)) + " degrees in the mean, and by more than " +
      std::to_string(std::lround(Outlying)) + " in " + Counted(this->Outside, "of ") +
      Counted(this->Rows, "rows") + ". ";
    if (mean > LargestMean)
    {
      throw FileError(sentence +
        "The file seems to belong to another mesh. Give the very mesh, its points and faces in the same "
        "order, at the same places.");
    }
    const bool isNoted = isExact ? this->Outside > 0 : mean > LargestMeanOfPoints;
    return isNoted ? sentence +
        "Their tangential parts are taken. If this is not the mesh that the file belongs to, the field is wrong."
                   : std::string();
  }

private:
  /// Directions that have nothing to do with the surface stand out by 33 degrees in the mean. Those
  /// for other normals of the same points hardly reach ten, even where there are many edges.
  static constexpr double LargestMean = 20.0;
  static constexpr double LargestMeanOfPoints = 10.0;
  static constexpr double Outlying = 5.0;

  double Sum = 0.0;
  std::size_t Rows = 0;
  std::size_t Outside = 0;
};

Vector3 NormalOf(const Surface& surface, const Triangle& triangle)
{
  const Vector3& a = surface.Points[triangle[0]];
  const Vector3 along = (surface.Points[triangle[1]] - a).stableNormalized();
  const Vector3 other = (surface.Points[triangle[2]] - a).stableNormalized();
  // Needles have no normal that the digits of a file could tell.
  constexpr double leastSine = 1e-3;
  const Vector3 normal = along.cross(other);
  return normal.norm() < leastSine ? Vector3(Vector3::Zero()) : normal.stableNormalized();
}

/// Compares the rows with the planes of the mesh's triangles or vertices (PlaneDeviation::Check).
std::string CheckPlanes(
  const FieldFile& file, const SurfaceGeometry& geometry, const Surface& surface, FieldOn on)
{
  PlaneDeviation deviation;
  const TriangleMesh& mesh = geometry.Mesh;
  for (Index t = 0; on == FieldOn::Cells && t < mesh.GetNumberOfTriangles(); ++t)
  {
    const Index row = mesh.InputTriangle(t);
    if (mesh.IsFront(t))
    {
      deviation.Add(file, static_cast<std::size_t>(row), NormalOf(surface, surface.Triangles[row]));
    }
  }
  // Rows that are found by their places belong to the mesh.
  const bool isByNumber = file.Rows() == surface.Points.size();
  for (Index v = 0; on == FieldOn::Points && isByNumber && v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsFrontVertex(v))
    {
      deviation.Add(file, static_cast<std::size_t>(mesh.Point(v)), geometry.Frames.Normal[v]);
    }
  }
  return deviation.Check(on == FieldOn::Cells);
}

/// A sentence where the directions of neighbours agree as little as directions at random; else
/// empty.
/// @param section of modulus 1 or 0 for rows of points; else its modulus is how much the triangles
///                around a vertex agree
std::string CheckAgreement(
  const SurfaceGeometry& geometry, int degree, const std::vector<Complex>& section, FieldOn on)
{
  // Of directions at random the means are near 0.37 around six triangles, and 0 along edges. The
  // means of few say nothing.
  constexpr double leastOfCells = 0.5;
  constexpr double leastOfPoints = 0.2;
  constexpr double leastCount = 50.0;
  const TriangleMesh& mesh = geometry.Mesh;
  double sum = 0.0;
  double count = 0.0;
  for (Index v = 0; on == FieldOn::Cells && v < mesh.GetNumberOfVertices(); ++v)
  {
    const bool counts = mesh.IsFrontVertex(v) && !mesh.IsBoundary(v);
    sum += counts ? std::abs(section[v]) : 0.0;
    count += counts ? 1.0 : 0.0;
  }
  for (Index e = 0; on == FieldOn::Points && e < mesh.GetNumberOfEdges(); ++e)
  {
    const Index h = mesh.HalfEdge(e);
    const Complex there = section[mesh.Head(h)];
    const Complex carried =
      section[mesh.Tail(h)] * std::polar(1.0, degree * geometry.Transport.RotationAlong(mesh, h));
    const bool counts = there != 0.0 && carried != 0.0;
    sum += counts ? std::real(carried * std::conj(there)) : 0.0;
    count += counts ? 1.0 : 0.0;
  }
  const double least = on == FieldOn::Cells ? leastOfCells : leastOfPoints;
  if (count < leastCount || sum >= least * count)
  {
    return {};
  }
  return "The directions of neighbours agree as little as directions at random. If this is not the mesh that "
         "the file belongs to, its points and faces in the same order, the field is wrong.";
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
  const auto note = [&](const std::string& sentence)
  {
    if (!sentence.empty())
    {
      imported.Warnings.push_back(sentence);
    }
  };
  note(CheckPlanes(file, geometry, surface, rowsAreFor));
  std::vector<Complex> section = rowsAreFor == FieldOn::Cells
    ? ToVertices(geometry,
        FromVectors(geometry, file.Degree, file.Directions, static_cast<std::size_t>(file.PerRow)))
    : FromPoints(geometry, file, surface);
  RequireDirections(geometry.Mesh, section);
  note(CheckAgreement(geometry, file.Degree, section, rowsAreFor));
  if (const std::size_t count = CountZeros(geometry.Mesh, section))
  {
    note("The file has no direction for " + Counted(count, "points") +
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
