// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BenchmarkMeshes.h"

#include "CliffMeshes.h"
#include "Meshes/PolyData.h"
#include "Meshes/Surfaces.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPoints.h"
#include "vtkSTLReader.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

using DirectionFields::Index;
using DirectionFields::Surface;
using DirectionFields::Vector3;

namespace BenchmarkMeshes
{
namespace
{
/// The unit sphere with bumps.
Vector3 Bumpy(const Vector3& direction)
{
  const Vector3 p = direction.normalized();
  const double radius = 1.0 + 0.15 * std::sin(2.0 * p.x() + 0.5) +
    0.1 * std::sin(3.0 * p.y() + p.x()) + 0.12 * std::cos(2.5 * p.z() - p.y() + 0.3) +
    0.05 * std::sin(7.0 * p.x() + 3.0 * p.y()) + 0.04 * std::sin(6.0 * p.y() - 5.0 * p.z() + 1.0) +
    0.04 * std::sin(8.0 * p.z() + 2.0 * p.x() + 2.0);
  return radius * p.cwiseProduct(Vector3(1.4, 1.0, 0.8));
}

Vector3 Round(const Vector3& direction)
{
  return direction.normalized();
}

/// Of the least subdivision that has as many triangles.
int FrequencyFor(int triangles)
{
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(triangles / 20.0))));
}

/// The icosahedron, each triangle split into frequency^2.
class Subdivision
{
public:
  using Map = Vector3 (*)(const Vector3&);
  /// @param place takes a direction to a point
  Subdivision(int frequency, Map place)
    : Frequency(frequency)
    , Place(place)
    , Coarse(Meshes::Icosahedron())
  {
    this->Points->SetDataTypeToFloat();
    for (const Vector3& corner : this->Coarse.Points)
    {
      this->Add(corner);
    }
    const vtkIdType triangles = 20 * static_cast<vtkIdType>(frequency) * frequency;
    this->Polys->AllocateExact(triangles, 3 * triangles);
  }

  vtkSmartPointer<vtkPolyData> Make()
  {
    for (const auto& face : this->Coarse.Triangles)
    {
      this->Split(face);
    }
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(this->Points);
    mesh->SetPolys(this->Polys);
    return mesh;
  }

private:
  vtkIdType Add(const Vector3& position)
  {
    const Vector3 p = this->Place(position);
    return this->Points->InsertNextPoint(p.data());
  }

  /// The inner points of an edge, from its lower end on.
  vtkIdType FirstOnEdge(Index low, Index high)
  {
    const auto [entry, isNew] =
      this->Edges.try_emplace({ low, high }, this->Points->GetNumberOfPoints());
    for (int k = 1; isNew && k < this->Frequency; ++k)
    {
      this->Add((this->Frequency - k) * this->Coarse.Points[low] + k * this->Coarse.Points[high]);
    }
    return entry->second;
  }

  /// The k-th point from a corner to another.
  vtkIdType OnEdge(Index from, Index to, int k)
  {
    if (k == 0 || k == this->Frequency)
    {
      return k == 0 ? from : to;
    }
    return from < to ? this->FirstOnEdge(from, to) + k - 1
                     : this->FirstOnEdge(to, from) + this->Frequency - k - 1;
  }

  /// Row by row, from the edge ab to c.
  void Split(const DirectionFields::Triangle& face)
  {
    const auto [a, b, c] = face;
    const int f = this->Frequency;
    std::vector<vtkIdType> below;
    std::vector<vtkIdType> row;
    for (int j = 0; j <= f; ++j)
    {
      row.clear();
      for (int i = 0; i <= f - j; ++i)
      {
        if (j == 0)
        {
          row.push_back(this->OnEdge(a, b, i));
        }
        else if (i == 0)
        {
          row.push_back(this->OnEdge(a, c, j));
        }
        else if (i == f - j)
        {
          row.push_back(this->OnEdge(b, c, j));
        }
        else
        {
          row.push_back(this->Add((f - i - j) * this->Coarse.Points[a] +
            i * this->Coarse.Points[b] + j * this->Coarse.Points[c]));
        }
      }
      for (int i = 0; j > 0 && i <= f - j; ++i)
      {
        this->Polys->InsertNextCell({ below[i], below[i + 1], row[i] });
        if (i < f - j)
        {
          this->Polys->InsertNextCell({ below[i + 1], row[i + 1], row[i] });
        }
      }
      below.swap(row);
    }
  }

  int Frequency;
  Map Place;
  Surface Coarse;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polys;
  std::map<std::pair<Index, Index>, vtkIdType> Edges;
};

template <typename Reader>
vtkSmartPointer<vtkPolyData> Read(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  // Where a reader gives every corner a point of its own there would be no surface.
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(reader->GetOutputPort());
  clean->SetTolerance(0.0);
  clean->ConvertPolysToLinesOff();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(clean->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(triangles->GetOutput()->GetPoints());
  mesh->SetPolys(triangles->GetOutput()->GetPolys());
  if (mesh->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error(path + " has no triangles.");
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> ReadFile(const std::string& path)
{
  const std::string suffix = path.substr(std::min(path.size(), path.rfind('.')));
  if (suffix == ".ply")
  {
    return Read<vtkPLYReader>(path);
  }
  if (suffix == ".obj")
  {
    return Read<vtkOBJReader>(path);
  }
  if (suffix == ".stl")
  {
    return Read<vtkSTLReader>(path);
  }
  throw std::runtime_error(
    path + " is neither a number of triangles nor a .ply, .obj or .stl file.");
}
}

vtkSmartPointer<vtkPolyData> Potato(int triangles)
{
  return Subdivision(FrequencyFor(triangles), Bumpy).Make();
}

vtkSmartPointer<vtkPolyData> Sphere(int triangles)
{
  return Subdivision(FrequencyFor(triangles), Round).Make();
}

vtkSmartPointer<vtkPolyData> Make(const std::string& name)
{
  if (!name.empty() && name.find_first_not_of("0123456789") == std::string::npos)
  {
    return Potato(std::stoi(name));
  }
  if (vtkSmartPointer<vtkPolyData> mesh = MakeCliff(name))
  {
    return mesh;
  }
  const std::size_t at = name.rfind('@');
  vtkSmartPointer<vtkPolyData> mesh = ReadFile(name.substr(0, at));
  const int levels = at == std::string::npos ? 0 : std::stoi(name.substr(at + 1));
  return levels == 0
    ? mesh
    : Meshes::ToPolyData(Meshes::FlatlySubdivided(Meshes::ToSurface(mesh), levels), VTK_FLOAT);
}
}
