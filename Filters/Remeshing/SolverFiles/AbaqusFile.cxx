// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SolverFiles/AbaqusFile.h"

#include "Exchange/FileSet.h"
#include "Exchange/TextWriter.h"
#include "SolverFiles/EdgeMiddles.h"
#include "SolverFiles/SetNames.h"
#include "SolverFiles/ShellChecks.h"
#include "SolverFiles/ShellEdges.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace DirectionFields
{
namespace
{
/// Of a number: CalculiX cuts what is longer, and with it the exponent.
constexpr std::size_t MostCharacters = 20;
/// Members on a line of a set.
constexpr std::size_t MostOnLine = 16;

std::string Number(double given)
{
  // Not the 0 below 0.
  const double number = given + 0.0;
  std::array<char, 32> digits{};
  char* const begin = digits.data();
  char* end = std::to_chars(begin, begin + digits.size(), number).ptr;
  for (int places = 16; end - begin > static_cast<std::ptrdiff_t>(MostCharacters); --places)
  {
    end = std::to_chars(begin, begin + digits.size(), number, std::chars_format::scientific, places)
            .ptr;
  }
  return { begin, end };
}

std::string Numbers(const Vector3& vector)
{
  return Number(vector.x()) + ", " + Number(vector.y()) + ", " + Number(vector.z());
}

/// Makes the text of an input file part by part.
class InputFile
{
public:
  InputFile(const ShellMesh& mesh, const AbaqusOptions& options)
    : Mesh(mesh)
    , Options(options)
    , MeshEdges(mesh)
    , Names({ "NALL", "EALL", "NBOUNDARY", "SECTION_REST", "MATERIAL", "DIRECTIONS" })
  {
  }

  std::string Make()
  {
    this->Text << "** A mesh of shells, written by Direction Fields: node i + 1 is point i, and "
                  "element i + 1 face i.\n";
    this->AddNodes();
    this->AddElements(4);
    this->AddElements(3);
    this->AddFaceSets();
    this->AddPointSets();
    if (!this->Mesh.Directions.empty())
    {
      this->AddDirections();
    }
    else if (this->Options.Thickness > 0.0)
    {
      this->AddSections();
    }
    return this->Text.Take();
  }

private:
  std::int64_t NodeOfEdge(std::int64_t edge) const
  {
    return static_cast<std::int64_t>(this->Mesh.Points.size()) + 1 + edge;
  }

  void AddNodes()
  {
    std::vector<char> isUsed(this->Mesh.Points.size(), 0);
    for (const std::array<Index, 2>& ends : this->MeshEdges.Ends)
    {
      isUsed[ends[0]] = isUsed[ends[1]] = 1;
    }
    this->Text << "*NODE, NSET=NALL\n";
    for (std::size_t p = 0; p < isUsed.size(); ++p)
    {
      if (isUsed[p] != 0)
      {
        this->Text << static_cast<std::int64_t>(p) + 1 << ", " << Numbers(this->Mesh.Points[p])
                   << "\n";
      }
    }
    std::int64_t edge = 0;
    for (const Vector3& middle :
      this->Options.SecondOrder ? MiddlesOf(this->Mesh, this->MeshEdges) : std::vector<Vector3>())
    {
      this->Text << this->NodeOfEdge(edge++) << ", " << Numbers(middle) << "\n";
    }
    this->IsUsed = std::move(isUsed);
  }

  /// The faces of this number of corners.
  void AddElements(int corners)
  {
    const char* const type =
      this->Options.SecondOrder ? (corners == 4 ? "S8R" : "S6") : (corners == 4 ? "S4" : "S3");
    bool isFirst = true;
    for (std::size_t f = 0; f < this->Mesh.Faces.size(); ++f)
    {
      if (CornersOf(this->Mesh.Faces[f]) != corners)
      {
        continue;
      }
      if (std::exchange(isFirst, false))
      {
        if (this->Options.SecondOrder && corners == 3)
        {
          this->Text << "** Abaqus: STRI65 in place of S6.\n";
        }
        this->Text << "*ELEMENT, TYPE=" << type << ", ELSET=EALL\n";
      }
      this->Text << static_cast<std::int64_t>(f) + 1;
      for (int k = 0; k < corners; ++k)
      {
        this->Text << ", " << this->Mesh.Faces[f][k] + 1;
      }
      for (int k = 0; this->Options.SecondOrder && k < corners; ++k)
      {
        this->Text << ", " << this->NodeOfEdge(this->MeshEdges.OfFace[f][k]);
      }
      this->Text << "\n";
    }
  }

  /// A set under a name that is allowed already; none without members, since CalculiX stops there.
  void AddSet(const char* kind, std::string_view name, std::vector<std::int64_t> numbers)
  {
    if (numbers.empty())
    {
      return;
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    this->Text << "*" << kind << ", " << kind << "=" << name << "\n";
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      this->Text << numbers[i]
                 << (i + 1 == numbers.size() || i % MostOnLine == MostOnLine - 1 ? "\n" : ", ");
    }
  }

  /// The name of a set as it is allowed, and a comment where that is another.
  std::string NameOf(const NamedSet& set)
  {
    std::string name = this->Names.Unique(set.Name);
    if (name != set.Name)
    {
      std::string original = set.Name;
      std::replace_if(
        original.begin(), original.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
      this->Text << "** " << name << ": " << original << "\n";
    }
    return name;
  }

  void AddFaceSets()
  {
    for (const NamedSet& set : this->Mesh.FaceSets)
    {
      this->FaceSetNames.push_back(this->NameOf(set));
      this->AddSet("ELSET", this->FaceSetNames.back(), FromOne(set.Members));
    }
  }

  void AddPointSets()
  {
    std::vector<std::int64_t> boundary;
    for (std::size_t e = 0; e < this->MeshEdges.Ends.size(); ++e)
    {
      if (this->MeshEdges.IsBoundary[e] != 0)
      {
        boundary.push_back(this->MeshEdges.Ends[e][0] + 1);
        boundary.push_back(this->MeshEdges.Ends[e][1] + 1);
        if (this->Options.SecondOrder)
        {
          boundary.push_back(this->NodeOfEdge(static_cast<std::int64_t>(e)));
        }
      }
    }
    this->AddSet("NSET", "NBOUNDARY", std::move(boundary));
    std::vector<char> isIn(this->Mesh.Points.size(), 0);
    for (const NamedSet& set : this->Mesh.PointSets)
    {
      this->AddPointSet(set, isIn);
    }
  }

  /// @param isIn 0 for each point, as which it is left
  void AddPointSet(const NamedSet& set, std::vector<char>& isIn)
  {
    std::vector<std::int64_t> numbers;
    for (const Index point : set.Members)
    {
      if (this->IsUsed[point] != 0)
      {
        isIn[point] = 1;
        numbers.push_back(point + 1);
      }
    }
    for (const Index point : set.Members)
    {
      const std::array<std::int64_t, 2> edges = this->MeshEdges.From(point);
      for (std::int64_t e = edges[0]; this->Options.SecondOrder && e < edges[1]; ++e)
      {
        if (isIn[this->MeshEdges.Ends[static_cast<std::size_t>(e)][1]] != 0)
        {
          numbers.push_back(this->NodeOfEdge(e));
        }
      }
    }
    for (const Index point : set.Members)
    {
      isIn[point] = 0;
    }
    const std::string name = this->NameOf(set);
    this->AddSet("NSET", name, std::move(numbers));
  }

  static std::vector<std::int64_t> FromOne(const std::vector<Index>& members)
  {
    std::vector<std::int64_t> numbers;
    numbers.reserve(members.size());
    for (const Index member : members)
    {
      numbers.push_back(static_cast<std::int64_t>(member) + 1);
    }
    return numbers;
  }

  /// The number of the set that each face has its material of; None for none.
  std::vector<Index> SetOfFaces() const
  {
    std::vector<Index> setOf(this->Mesh.Faces.size(), None);
    for (std::size_t s = 0; s < this->Mesh.FaceSets.size(); ++s)
    {
      for (const Index face : this->Mesh.FaceSets[s].Members)
      {
        if (setOf[face] != None)
        {
          throw std::invalid_argument("Face " + std::to_string(face) +
            " is in two sets, so that its material is not known. Leave the Thickness 0, and write "
            "the sections by hand.");
        }
        setOf[face] = static_cast<Index>(s);
      }
    }
    return setOf;
  }

  std::string_view MaterialOf(Index set) const
  {
    return set == None ? std::string_view("MATERIAL") : this->FaceSetNames[set];
  }

  void AddSection(
    std::string_view elements, std::string_view material, std::string_view orientation)
  {
    this->Text << "*SHELL SECTION, ELSET=" << elements << ", MATERIAL=" << material;
    if (!orientation.empty())
    {
      this->Text << ", ORIENTATION=" << orientation;
    }
    this->Text << "\n" << Number(this->Options.Thickness) << "\n";
  }

  void AddSections()
  {
    const std::vector<Index> setOf = this->SetOfFaces();
    std::vector<std::int64_t> rest;
    for (std::size_t f = 0; f < setOf.size(); ++f)
    {
      if (setOf[f] == None)
      {
        rest.push_back(static_cast<std::int64_t>(f) + 1);
      }
    }
    if (!rest.empty())
    {
      const bool isAll = rest.size() == setOf.size();
      if (!isAll)
      {
        this->AddSet("ELSET", "SECTION_REST", rest);
      }
      this->AddSection(isAll ? "EALL" : "SECTION_REST", this->MaterialOf(None), {});
    }
    for (std::size_t s = 0; s < this->FaceSetNames.size(); ++s)
    {
      if (!this->Mesh.FaceSets[s].Members.empty())
      {
        this->AddSection(this->FaceSetNames[s], this->FaceSetNames[s], {});
      }
    }
  }

  /// The first and the second axis of the material of a face, in its plane.
  /// @param isGiven whether there is such a direction
  std::array<Vector3, 2> AxesOf(std::size_t f, bool& isGiven) const
  {
    constexpr double least = 1e-6;
    const std::array<Index, 4>& face = this->Mesh.Faces[f];
    const Vector3 normal = NormalOf(this->Mesh, face).stableNormalized();
    const auto inPlane = [&](const Vector3& vector)
    {
      const Vector3 unit = vector.stableNormalized();
      return Vector3(unit - unit.dot(normal) * normal);
    };
    Vector3 axis = inPlane(this->Mesh.Directions[f]);
    isGiven = axis.allFinite() && axis.norm() > least;
    if (!isGiven)
    {
      axis = inPlane(this->Mesh.Points[face[1]] - this->Mesh.Points[face[0]]);
    }
    axis.normalize();
    return { axis, normal.cross(axis) };
  }

  void AddDirections()
  {
    std::vector<std::array<Vector3, 2>> axes;
    std::int64_t missing = 0;
    for (std::size_t f = 0; f < this->Mesh.Faces.size(); ++f)
    {
      bool isGiven = false;
      axes.push_back(this->AxesOf(f, isGiven));
      missing += isGiven ? 0 : 1;
    }
    if (missing > 0)
    {
      this->Text << "** No direction in the plane of " << missing
                 << " elements: along their first edges there.\n";
    }
    if (!(this->Options.Thickness > 0.0))
    {
      this->AddDistribution(axes);
      return;
    }
    const std::vector<Index> setOf = this->SetOfFaces();
    for (std::size_t f = 0; f < axes.size(); ++f)
    {
      const std::string number = std::to_string(f + 1);
      const std::string elements = this->Names.Unique("E_" + number);
      const std::string orientation = this->Names.Unique("O_" + number);
      this->Text << "*ELSET, ELSET=" << elements << "\n" << number << "\n";
      this->Text << "*ORIENTATION, NAME=" << orientation << "\n"
                 << Numbers(axes[f][0]) << ", " << Numbers(axes[f][1]) << "\n3, 0.\n";
      this->AddSection(elements, this->MaterialOf(setOf[f]), orientation);
    }
  }

  void AddDistribution(const std::vector<std::array<Vector3, 2>>& axes)
  {
    this->Text << "*DISTRIBUTION TABLE, NAME=DIRECTIONS_TABLE\nCOORD3D, COORD3D\n"
                  "*DISTRIBUTION, LOCATION=ELEMENT, TABLE=DIRECTIONS_TABLE, "
                  "NAME=DIRECTIONS_OF_ELEMENTS\n"
                  ", 1., 0., 0., 0., 1., 0.\n";
    for (std::size_t f = 0; f < axes.size(); ++f)
    {
      this->Text << static_cast<std::int64_t>(f) + 1 << ", " << Numbers(axes[f][0]) << ", "
                 << Numbers(axes[f][1]) << "\n";
    }
    this->Text << "*ORIENTATION, NAME=DIRECTIONS\nDIRECTIONS_OF_ELEMENTS\n3, 0.\n";
  }

  const ShellMesh& Mesh;
  const AbaqusOptions& Options;
  ShellEdges MeshEdges;
  SetNames Names;
  TextWriter Text;
  std::vector<char> IsUsed;
  std::vector<std::string> FaceSetNames;
};
}

std::string AbaqusText(const ShellMesh& mesh, const AbaqusOptions& options)
{
  if (!(options.Thickness >= 0.0) || !std::isfinite(options.Thickness))
  {
    throw std::invalid_argument("Thickness has to be a number from 0 on.");
  }
  CheckMesh(mesh);
  return InputFile(mesh, options).Make();
}

void WriteAbaqus(const std::string& fileName, const ShellMesh& mesh, const AbaqusOptions& options)
{
  WriteTogether({ { fileName, AbaqusText(mesh, options) } });
}
}
