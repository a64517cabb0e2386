// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Exchange/FieldExport.h"

#include "Exchange/CompanionFiles.h"
#include "Exchange/FileSet.h"
#include "Exchange/SharpEdges.h"
#include "Exchange/TextFile.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace DirectionFields
{
namespace
{
/// The mesh that is written, and where its points come from.
struct WrittenMesh
{
  Surface Mesh;
  /// The point of the surface and the number of the written point of each other's.
  std::vector<Index> Point;
  std::vector<Index> Written;

  /// Points that became one are there once, others as they are.
  explicit WrittenMesh(const GivenField& field)
  {
    const Surface& surface = field.GetSurface();
    const TriangleMesh& mesh = field.GetMesh();
    this->Mesh.Triangles = surface.Triangles;
    bool isMerged = false;
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      const Index at = field.GetMeshTriangles()[t];
      for (int c = 0; at != None && c < 3; ++c)
      {
        Index& point = this->Mesh.Triangles[t][c];
        const Index first = mesh.Point(mesh.Tail(3 * at + field.MeshCorner(at, c)));
        isMerged = isMerged || first != point;
        point = first;
      }
    }
    std::vector<char> isUsed(surface.Points.size(), isMerged ? 0 : 1);
    for (const Triangle& triangle : this->Mesh.Triangles)
    {
      for (const Index point : triangle)
      {
        isUsed[point] = 1;
      }
    }
    this->Written.assign(surface.Points.size(), None);
    for (std::size_t i = 0; i < isUsed.size(); ++i)
    {
      if (isUsed[i] != 0)
      {
        this->Written[i] = static_cast<Index>(this->Point.size());
        this->Point.push_back(static_cast<Index>(i));
        this->Mesh.Points.push_back(surface.Points[i]);
      }
    }
    for (Triangle& triangle : this->Mesh.Triangles)
    {
      for (Index& point : triangle)
      {
        point = this->Written[point];
      }
    }
  }
};

/// Whether the mesh has a triangle the other way around than the surface.
bool IsTurned(const GivenField& field, Index meshTriangle)
{
  return (field.MeshCorner(meshTriangle, 0) + 1) % 3 != field.MeshCorner(meshTriangle, 1);
}

/// Puts direction k = 0 ... n-1 of a row in its place: in reverse order on triangles that were
/// turned.
void SetDirection(FieldFile& file, std::size_t row, int k, bool isTurned, const Vector3& direction)
{
  const int at = isTurned && k > 0 ? file.Degree - k : k;
  file.Directions[row * static_cast<std::size_t>(file.PerRow) + static_cast<std::size_t>(at)] =
    direction;
}

FieldFile RowsForTriangles(const GivenField& field, const FaceField& faces)
{
  const Surface& surface = field.GetSurface();
  FieldFile file;
  file.Degree = faces.Degree;
  file.PerRow = faces.Degree;
  file.Directions.resize(surface.Triangles.size() * static_cast<std::size_t>(file.PerRow));
  for (int k = 0; k < file.Degree; ++k)
  {
    const std::vector<Vector3> directions = DirectionsInSpace(field, faces, k);
    for (std::size_t t = 0; t < directions.size(); ++t)
    {
      const Index at = field.GetMeshTriangles()[t];
      SetDirection(file, t, k, at != None && IsTurned(field, at), directions[t]);
    }
  }
  return file;
}

FieldFile RowsForPoints(const GivenField& field, const WrittenMesh& written)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  FieldFile file;
  file.Degree = field.GetDegree();
  file.PerRow = field.GetDegree();
  file.Directions.assign(
    written.Point.size() * static_cast<std::size_t>(file.PerRow), Vector3::Zero());
  for (Index v = 0; v < geometry.Mesh.GetNumberOfVertices(); ++v)
  {
    const Complex& u = field.GetSection()[v];
    if (!geometry.Mesh.IsFrontVertex(v) || u == 0.0)
    {
      continue;
    }
    const bool isTurned = IsTurned(field, geometry.Mesh.Outgoing(v) / 3);
    for (int k = 0; k < file.Degree; ++k)
    {
      const double angle = (std::arg(u) + 2.0 * Pi * k) / file.Degree;
      SetDirection(file, written.Written[geometry.Mesh.Point(v)], k, isTurned,
        std::cos(angle) * geometry.Frames.X[v] + std::sin(angle) * geometry.Frames.Y(v));
    }
  }
  return file;
}

/// Singular vertices of the written mesh, where the directions are those of the triangles.
std::vector<SingularElement> SingularVertices(
  const GivenField& field, const FaceField& faces, const WrittenMesh& written)
{
  const TriangleMesh& mesh = field.GetMesh();
  const std::vector<int> indices = FaceSingularityIndices(field.GetGeometry(), faces);
  std::vector<int> sums(written.Point.size(), 0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsFrontVertex(v))
    {
      sums[written.Written[mesh.Point(v)]] += indices[v];
    }
  }
  std::vector<SingularElement> singular;
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    if (sums[i] != 0)
    {
      singular.push_back({ static_cast<Index>(i), sums[i] });
    }
  }
  return singular;
}

std::vector<SingularElement> SingularTriangles(const GivenField& field)
{
  const std::vector<int> indices = field.Indices();
  std::vector<SingularElement> singular;
  for (std::size_t t = 0; t < field.GetMeshTriangles().size(); ++t)
  {
    const Index at = field.GetMeshTriangles()[t];
    if (at != None && indices[at] != 0)
    {
      singular.push_back({ static_cast<Index>(t), indices[at] });
    }
  }
  return singular;
}

/// The checksum of a file; empty where it cannot be read.
std::string ChecksumOf(const std::string& path)
{
  try
  {
    return Checksum(ReadText(path));
  }
  catch (const FileError&)
  {
    return {};
  }
}

[[noreturn]] void RefuseForeign(const std::string& path)
{
  throw FileError("There is a file " + path +
    " already, which was not written here or has been changed since, and would be replaced: a field's "
    "file comes with the mesh that its rows belong to. Choose another name.");
}

/// The files beside a mesh that an earlier run wrote and nobody changed since. Throws FileError
/// where another file than these, or another mesh, would be replaced.
FileRecord RequireOwn(const std::string& name, const std::vector<ExportedFile>& files)
{
  const std::string mesh = name + ".obj";
  std::optional<FileRecord> record;
  if (IsThere(mesh))
  {
    record = RecordOf(ReadText(mesh));
    if (!record)
    {
      RefuseForeign(mesh);
    }
  }
  FileRecord own;
  for (const auto& [ending, checksum] : record.value_or(FileRecord()))
  {
    if (ChecksumOf(name + ending) == checksum)
    {
      own[ending] = checksum;
    }
  }
  for (std::size_t i = 1; i < files.size(); ++i)
  {
    const std::string& ending = files[i].Ending;
    if (ending != ".obj" && IsThere(name + ending) && own.count(ending) == 0)
    {
      RefuseForeign(name + ending);
    }
  }
  return own;
}
}

std::vector<ExportedFile> ExportField(
  const GivenField& field, const FaceField* given, const ExportOptions& options)
{
  if (field.GetSurface().Triangles.empty())
  {
    throw FileError("There is nothing to write: the surface has no triangles.");
  }
  const bool isOnPoints = options.On == FieldOn::Points;
  const WrittenMesh written(field);
  const FaceField faces = isOnPoints ? FaceField() : given ? *given : AtCentroids(field);
  const auto singularities = [&]
  {
    return WriteSingularities(field.GetDegree(),
      isOnPoints ? SingularTriangles(field) : SingularVertices(field, faces, written));
  };
  std::vector<ExportedFile> files;
  if (options.Format == FieldFormat::Singularities)
  {
    files.push_back({ ".sing", singularities() });
  }
  else
  {
    const FieldFile rows =
      isOnPoints ? RowsForPoints(field, written) : RowsForTriangles(field, faces);
    const char* const ending = options.Format == FieldFormat::Rosy ? ".rosy"
      : options.Format == FieldFormat::FrameField                  ? ".ffield"
                                                                   : ".rawfield";
    files.push_back({ ending, WriteField(rows, options.Format) });
  }
  files.push_back({ ".obj", WriteObj(written.Mesh) });
  if (options.Format == FieldFormat::Rosy)
  {
    files.push_back({ ".sharp",
      WriteSharp(
        FindSharpEdges(written.Mesh, options.FeatureAngle, options.MinimumFeatureLength)) });
  }
  if (options.Format == FieldFormat::RawField)
  {
    files.push_back({ ".sing", singularities() });
  }
  return files;
}

void WriteFiles(const std::string& fileName, const std::vector<ExportedFile>& files)
{
  const std::string name = fileName.substr(0, fileName.rfind('.'));
  FileRecord record = RequireOwn(name, files);
  for (const ExportedFile& file : files)
  {
    if (file.Ending != ".obj")
    {
      record[file.Ending] = Checksum(file.Text);
    }
  }
  std::vector<FileText> written;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const ExportedFile& file = files[i];
    written.push_back({ i == 0 ? fileName : name + file.Ending,
      file.Ending == ".obj" ? WithRecord(file.Text, record) : file.Text });
  }
  WriteTogether(written);
}
}
