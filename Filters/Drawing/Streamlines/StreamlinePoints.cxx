// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/StreamlinePoints.h"

#include "Support/Threads.h"
#include "Support/VectorMath.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index FewLines = 4;

/// A volume that is a smaller part of the area to the power 3/2 says nothing: a sphere's is 0.094.
constexpr double LeastVolume = 0.01;

/// The side that is outside, for each component: -1 where the normals point into the volume that it
/// encloses, with holes or without, else 1.
std::vector<double> OutwardSigns(const GivenField& field)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const auto& components = geometry.Mesh.GetComponents();
  std::vector<double> signs;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const TriangleMesh::Component& component = components[c];
    const double unit = geometry.Lengths.Unit[c];
    Vector3 middle = Vector3::Zero();
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      middle += (geometry.Positions[v] - geometry.Positions[component.FirstVertex]) / unit;
    }
    middle /= component.Vertices();
    const auto corner = [&](Index h) -> Vector3
    {
      return (geometry.Positions[geometry.Mesh.Tail(h)] -
               geometry.Positions[component.FirstVertex]) /
        unit -
        middle;
    };
    double volume = 0.0;
    for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
    {
      volume += corner(3 * t).cross(corner(3 * t + 1)).dot(corner(3 * t + 2)) / 6.0;
    }
    const double least = LeastVolume * std::pow(geometry.Lengths.ComponentArea[c], 1.5);
    signs.push_back(!component.IsCover && volume < -least ? -1.0 : 1.0);
  }
  return signs;
}

/// Writes the points of one line after the other.
class Writer
{
public:
  Writer(
    const GivenField& field, const PointDirections& directions, double height, Streamlines& result)
    : Field(field)
    , Directions(directions)
    , Height(height)
    , Signs(OutwardSigns(field))
    , Result(result)
  {
  }

  void Write(const TracedStreamline& line, Index number) const
  {
    auto at = static_cast<std::size_t>(this->Result.Offsets[number]);
    const double unit = this->Field.GetGeometry().Lengths.Unit[line.Component];
    const double first = line.Pieces.front().Arc;
    std::optional<Place> in;
    for (const LinePiece& piece : line.Pieces)
    {
      if (!in || in->Triangle != piece.Triangle)
      {
        in.emplace(this->Field, piece.Triangle);
      }
      this->WritePoint(line, *in, piece.Begin, piece.BeginDirection, at);
      this->Result.Arc[at++] = unit * (piece.Arc - first);
    }
    const LinePiece& last = line.Pieces.back();
    this->WritePoint(line, *in, last.End, last.EndDirection, at);
    this->Result.Arc[at] = unit * line.Length();
    if (line.IsClosed)
    {
      this->Result.Points[at] = this->Result.Points[this->Result.Offsets[number]];
    }
  }

private:
  /// The triangle that a line is in: several of its points are as a rule.
  struct Place
  {
    Place(const GivenField& field, Index triangle)
      : Triangle(triangle)
      , Power(field.GetGeometry(), field.GetDegree(), field.GetSection().data(), triangle)
      , Space(field.InSpace(triangle))
    {
    }

    /// The direction given at a corner, once it has been asked for.
    struct Given
    {
      bool IsRead = false;
      bool IsDirection = false;
      double Angle = 0.0;
      int Sense = 1;
    };

    Index Triangle;
    FieldInterpolant Power;
    TriangleInSpace Space;
    std::array<Given, 3> AtCorner;
  };

  void WritePoint(const TracedStreamline& line, Place& in, const Complex& place,
    const Complex& direction, std::size_t at) const
  {
    const SurfaceGeometry& geometry = this->Field.GetGeometry();
    const Index triangle = in.Triangle;
    const FieldInterpolant& power = in.Power;
    const TriangleInSpace& space = in.Space;
    const std::array<double, 3> weights = power.Flat().Weights(place);
    Vector3 normal = Vector3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      normal += weights[c] * geometry.Frames.Normal[geometry.Mesh.Tail(3 * triangle + c)];
    }
    normal = normal.norm() > 1e-6 ? Vector3(normal.normalized()) : space.Normal;
    normal *= this->Signs[line.Component];
    this->Result.Points[at] = space.Position(weights) + this->Height * normal;
    this->Result.Normals[at] = normal;
    this->Result.Directions[at] = space.Direction(direction);
    this->Result.Magnitude[at] = Modulus(power.At(place));
    const auto corner =
      static_cast<int>(std::max_element(weights.begin(), weights.end()) - weights.begin());
    const Index point = this->Field.PointAt(triangle, corner);
    this->Result.Triangle[at] = geometry.Mesh.InputTriangle(triangle);
    for (int c = 0; c < 3; ++c)
    {
      this->Result.Weights[at][c] = weights[this->Field.MeshCorner(triangle, c)];
    }
    this->Result.Point[at] = point;
    this->Result.Branch[at] =
      this->BranchAt(in, corner, point, place, static_cast<double>(line.Sense) * direction);
  }

  /// Which of the directions at a point is nearest to one in a triangle.
  int BranchAt(
    Place& in, int corner, Index point, const Complex& place, const Complex& direction) const
  {
    const int degree = this->Field.GetDegree();
    Place::Given& given = in.AtCorner[corner];
    if (!given.IsRead)
    {
      given = this->GivenAt(in.Triangle, corner, point);
    }
    if (!given.IsDirection)
    {
      return 0;
    }
    const double angle = AngleOf(direction) - in.Power.AngleInFlat(corner, given.Angle, place);
    const int turns = given.Sense * static_cast<int>(std::lround(angle / (2.0 * Pi / degree)));
    return (turns % degree + degree) % degree;
  }

  /// The first direction at the corner of a triangle.
  Place::Given GivenAt(Index triangle, int corner, Index point) const
  {
    const SurfaceGeometry& geometry = this->Field.GetGeometry();
    const Index vertex = geometry.Mesh.Tail(3 * triangle + corner);
    const Vector3 first = this->Directions.Direction(point, 0);
    const Complex tangential = geometry.Frames.Tangential(vertex, first);
    Place::Given given;
    given.IsRead = true;
    given.IsDirection = std::norm(tangential) > 0.0 && std::isfinite(std::norm(tangential));
    given.Angle = given.IsDirection ? std::arg(tangential) : 0.0;
    // They may count the other way around.
    given.Sense = this->Field.GetDegree() > 2 &&
        first.cross(this->Directions.Direction(point, 1)).dot(geometry.Frames.Normal[vertex]) < 0.0
      ? -1
      : 1;
    return given;
  }

  const GivenField& Field;
  const PointDirections& Directions;
  double Height;
  std::vector<double> Signs;
  Streamlines& Result;
};

Vector3 PositionOn(const GivenField& field, Index triangle, const Complex& place)
{
  return field.InSpace(triangle).Position(
    FlatTriangle(field.GetGeometry(), triangle).Weights(place));
}

/// Adds the singularities, then the other ends of lines, and says which the lines end in.
void AddNodes(const GivenField& field, const SingularPoints& zeros,
  const std::vector<TracedStreamline>& lines, Streamlines& result)
{
  const TriangleMesh& mesh = field.GetMesh();
  for (const SingularPoint& zero : zeros.GetZeros())
  {
    result.Nodes.push_back({ PositionOn(field, zero.Triangle, zero.Place),
      StreamlineNodeType::Singularity, zero.Index_, mesh.InputTriangle(zero.Triangle) });
  }
  result.EndNodes.assign(lines.size(), { None, None });
  for (const StreamlineNodeType type :
    { StreamlineNodeType::Crossing, StreamlineNodeType::Boundary })
  {
    const StreamlineEnd reason =
      type == StreamlineNodeType::Crossing ? StreamlineEnd::Crossing : StreamlineEnd::Boundary;
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      for (int e = 0; e < 2; ++e)
      {
        if (lines[i].Ends[e] == StreamlineEnd::Singularity)
        {
          result.EndNodes[i][e] = lines[i].Zeros[e];
        }
        else if (lines[i].Ends[e] == reason)
        {
          const LinePiece& piece = e == 0 ? lines[i].Pieces.front() : lines[i].Pieces.back();
          result.EndNodes[i][e] = static_cast<Index>(result.Nodes.size());
          result.Nodes.push_back(
            { PositionOn(field, piece.Triangle, e == 0 ? piece.Begin : piece.End), type, 0,
              mesh.InputTriangle(piece.Triangle) });
        }
      }
    }
  }
}
}

Streamlines ToStreamlines(const GivenField& field, const PointDirections& directions,
  const SingularPoints& zeros, const std::vector<TracedStreamline>& lines, double height)
{
  Streamlines result;
  for (const TracedStreamline& line : lines)
  {
    result.Offsets.push_back(
      result.Offsets.back() + static_cast<std::int64_t>(line.Pieces.size()) + 1);
  }
  const auto points = static_cast<std::size_t>(result.Offsets.back());
  for (std::vector<Vector3>* vectors : { &result.Points, &result.Normals, &result.Directions })
  {
    vectors->resize(points);
  }
  result.Arc.resize(points);
  result.Magnitude.resize(points);
  result.Point.resize(points);
  result.Branch.resize(points);
  result.Triangle.resize(points);
  result.Weights.resize(points);
  const Writer writer(field, directions, height, result);
  ParallelFor(static_cast<Index>(lines.size()), FewLines,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        writer.Write(lines[i], i);
      }
    });
  const int families = NumberOfFamilies(field.GetDegree());
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const TracedStreamline& line = lines[i];
    result.Seed.push_back(line.Seed);
    result.Family.push_back(result.Branch[result.Offsets[i]] % families);
    result.Length.push_back(result.Arc[result.Offsets[i + 1] - 1]);
    result.Closed.push_back(line.IsClosed ? 1 : 0);
    result.Ends.push_back(line.Ends);
  }
  AddNodes(field, zeros, lines, result);
  return result;
}
}
