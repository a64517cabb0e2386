// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/SpacedLine.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// Parts of the spacing: between samples of a line; how far a line runs before it minds itself; how
/// near it must come back to its start to be closed, and from where on it may come to that.
constexpr double SamplePart = 0.2;
/// From one sample to the next a streamline turns by at most this part of the angle within which
/// streamlines see each other: where two see each other anywhere, their samples do so widely
/// (LineGrid).
constexpr double MostTurn = 0.2;
constexpr std::ptrdiff_t MarksPerSeed = 3;
constexpr double OwnPart = 3.0;
constexpr double ClosedPart = 0.1;
constexpr double ClosingPart = 0.15;
constexpr double NearStartPart = 0.6;
/// The part of a line between samples may be this many times as long as it is wide: a longer one
/// winds around something that is much thinner than the spacing, a spike for instance. Its width is
/// looked at each time that it has as many pieces more. It may come back to the triangle where it
/// begins this many times: long triangles are wound around in long turns.
constexpr double MostWinding = 4.0;
constexpr std::size_t PiecesPerLook = 16;
constexpr int MostReturns = 2;

/// The part of a line since a sample that is there for its length, not for its turn.
class SinceSample
{
public:
  /// @param length of the line up to here
  SinceSample(const Vector3& position, Index triangle, double length)
    : Position(position)
    , Triangle(triangle)
    , Before(length)
  {
  }

  /// Whether the part winds around something thin, now that it has come to the end of a piece.
  /// @param position returns the place in space, which takes time
  template <typename Place>
  bool Winds(Index triangle, double length, const Place& position)
  {
    const bool isBack = triangle == this->Triangle;
    this->Returns += isBack && !this->WasBack ? 1 : 0;
    this->WasBack = isBack;
    if (++this->Pieces % PiecesPerLook == 0)
    {
      this->Width = std::max(this->Width, (position() - this->Position).stableNorm());
      return length - this->Before > MostWinding * this->Width;
    }
    return this->Returns > MostReturns;
  }

private:
  Vector3 Position;
  Index Triangle;
  double Before;
  std::size_t Pieces = 0;
  int Returns = 0;
  bool WasBack = true;
  /// How far any place that was looked at is from the sample.
  double Width = 0.0;
};

LineStart PlaceOn(const LinePiece& piece, double part, int sense)
{
  const Complex direction =
    piece.BeginDirection + part * (piece.EndDirection - piece.BeginDirection);
  return { piece.Triangle, piece.Begin + part * (piece.End - piece.Begin),
    direction / std::abs(direction), sense };
}

Vector3 Lateral(const LineSample& sample, const Vector3& position)
{
  const Vector3 tangent = sample.Tangent;
  const Vector3 offset = position - sample.Position;
  return offset - offset.dot(tangent) * tangent;
}
}

void SpacedHalf::Keep(std::size_t marks)
{
  this->Marks.resize(std::min(marks, this->Marks.size()));
  this->End = StreamlineEnd::TooClose;
  this->Zero = None;
  this->IsClosed = false;
  if (this->Marks.empty())
  {
    this->Pieces.clear();
    return;
  }
  const Mark& last = this->Marks.back();
  this->Pieces.resize(last.Piece + 1);
  LinePiece& piece = this->Pieces.back();
  piece.End = piece.Begin + last.Part * (piece.End - piece.Begin);
  piece.EndDirection = last.Place.Direction;
}

double SpacedLine::Length() const
{
  double length = 0.0;
  for (const SpacedHalf* half : { &this->Forward, &this->Backward })
  {
    length += half->Pieces.empty() ? 0.0 : half->Pieces.back().Arc + half->Pieces.back().Length();
  }
  return length;
}

void SpacedLine::InsertInto(LineGrid& grid) const
{
  for (const SpacedHalf* half : { &this->Backward, &this->Forward })
  {
    for (const SpacedHalf::Mark& mark : half->Marks)
    {
      grid.Insert(mark.Sample);
    }
  }
}

std::vector<LineStart> SpacedLine::Places() const
{
  std::vector<LineStart> places;
  const std::vector<SpacedHalf::Mark>& behind = this->Backward.Marks;
  const auto back = static_cast<std::ptrdiff_t>(behind.size());
  const auto ahead = static_cast<std::ptrdiff_t>(this->Forward.Marks.size());
  for (std::ptrdiff_t i = -back; i < ahead; i += MarksPerSeed)
  {
    places.push_back(i < 0 ? behind[-i - 1].Place : this->Forward.Marks[i].Place);
    places.back().Direction *= i < 0 ? -1.0 : 1.0;
  }
  return places;
}

TracedStreamline SpacedLine::Joined() &&
{
  TracedStreamline forward;
  forward.Pieces = std::move(this->Forward.Pieces);
  forward.Ends[1] = this->Forward.End;
  forward.Zeros[1] = this->Forward.Zero;
  if (this->Forward.IsClosed)
  {
    forward.IsClosed = true;
    forward.Ends[0] = StreamlineEnd::Loop;
    return forward;
  }
  TracedStreamline backward;
  backward.Pieces = std::move(this->Backward.Pieces);
  backward.Ends[1] = this->Backward.End;
  backward.Zeros[1] = this->Backward.Zero;
  return DirectionFields::Joined(std::move(backward), std::move(forward));
}

SpacedTracing::SpacedTracing(
  const GivenField& field, const SingularPoints& zeros, Index component, const EvenOptions& options)
  : Field(field)
  , Limit(field.GetMesh().GetNumberOfTriangles())
  , Traced{ field, zeros, this->Limit }
  , Options(options)
  , Component(component)
  , Unit(field.GetGeometry().Lengths.Unit[component])
{
  this->Traced.LongestStep = SamplePart * options.Spacing / this->Unit;
  const int families = NumberOfFamilies(field.GetDegree());
  this->LeastTurn = families == 1 ? -2.0 : std::cos(MostTurn * 0.5 * Pi / families);
}

LineGrid SpacedTracing::MakeGrid() const
{
  const TriangleMesh& mesh = this->Field.GetMesh();
  const TriangleMesh::Component& range = mesh.GetComponents()[this->Component];
  return { this->Field.GetGeometry().Positions[range.FirstVertex], this->Options.Spacing,
    NumberOfFamilies(this->Field.GetDegree()), range.IsCover };
}

Vector3 SpacedTracing::PositionOf(Index triangle, const Complex& place) const
{
  const SurfaceGeometry& geometry = this->Field.GetGeometry();
  const std::array<double, 3> weights = FlatTriangle(geometry, triangle).Weights(place);
  Vector3 position = Vector3::Zero();
  for (int c = 0; c < 3; ++c)
  {
    position += weights[c] * geometry.Positions[geometry.Mesh.Tail(3 * triangle + c)];
  }
  return position;
}

LineSample SpacedTracing::SampleAt(const LineStart& start, double arc) const
{
  const TriangleInSpace triangle = this->Field.InSpace(start.Triangle);
  const FlatTriangle flat(this->Field.GetGeometry(), start.Triangle);
  LineSample sample;
  sample.Position = triangle.Position(flat.Weights(start.Place));
  sample.Normal = triangle.Normal;
  sample.Tangent = triangle.Direction(start.Direction);
  sample.Arc = arc;
  return sample;
}

LineStart SpacedTracing::Aligned(const LineStart& start) const
{
  LineStart aligned = start;
  const int degree = this->Field.GetDegree();
  const FieldInterpolant power(
    this->Field.GetGeometry(), degree, this->Field.GetSection().data(), start.Triangle);
  const Complex value = power.At(start.Place);
  aligned.Sense = 1;
  aligned.Direction = TracedField::DirectionNear(value, degree, start.Direction, 1);
  return aligned;
}

bool SpacedTracing::IsTooClose(const LineSample& sample, const LineGrid& grid, const LineGrid& own,
  const LineSample& first) const
{
  const double spacing = this->Options.Spacing;
  const double radius = this->Options.Ratio * spacing;
  if (grid.IsNearWidely(sample, radius))
  {
    return true;
  }
  const auto counts = [&](const LineSample& other)
  {
    if (std::abs(other.Arc - sample.Arc) < OwnPart * spacing)
    {
      return false;
    }
    // Where it closes it may come near its first part.
    const bool mayClose = std::abs(other.Arc - first.Arc) <= spacing && sample.Arc > 0.0 &&
      other.Tangent.dot(sample.Tangent) > 0.9 &&
      Lateral(other, sample.Position).stableNorm() < ClosingPart * spacing;
    return !mayClose;
  };
  return own.IsNear(sample, radius, counts);
}

bool SpacedTracing::Closes(const LineSample& first, SpacedHalf& half) const
{
  LinePiece& piece = half.Pieces.back();
  const Vector3 tangent = first.Tangent;
  const Vector3 begin = this->PositionOf(piece.Triangle, piece.Begin) - first.Position;
  const Vector3 end = this->PositionOf(piece.Triangle, piece.End) - first.Position;
  const double before = begin.dot(tangent);
  const double after = end.dot(tangent);
  if (!(before < 0.0 && after >= 0.0) ||
    (end - begin).dot(tangent) < 0.8 * (end - begin).stableNorm())
  {
    return false;
  }
  const double part = before / (before - after);
  const Vector3 passes = begin + part * (end - begin);
  if (passes.stableNorm() >= ClosedPart * this->Options.Spacing)
  {
    return false;
  }
  piece.End = piece.Begin + part * (piece.End - piece.Begin);
  half.End = StreamlineEnd::Loop;
  half.IsClosed = true;
  return true;
}

void SpacedTracing::TraceHalf(const LineStart& start, int sense, double mostLength,
  const LineGrid& grid, LineGrid& own, SpacedHalf& half) const
{
  const double spacing = this->Options.Spacing;
  const double step = SamplePart * spacing / this->Unit;
  StreamlineTrace trace(this->Traced, start);
  const LineSample first = this->SampleAt(start, 0.0);
  double length = 0.0;
  double nextMark = sense > 0 ? 0.0 : step;
  bool isNearStart = false;
  // Since the last sample.
  Complex turn = 1.0;
  SinceSample since(first.Position, start.Triangle, 0.0);
  const auto mark = [&](const LinePiece& piece, double part)
  {
    const LineStart place = PlaceOn(piece, part, start.Sense);
    LineSample sample = this->SampleAt(place, 0.0);
    sample.Arc = sense * this->Unit * (piece.Arc + part * piece.Length());
    if (this->IsTooClose(sample, grid, own, first))
    {
      return false;
    }
    isNearStart = sense > 0 && sample.Arc > OwnPart * spacing &&
      (sample.Position - first.Position).stableNorm() < NearStartPart * spacing;
    own.Insert(sample);
    half.Marks.push_back({ sample, half.Pieces.size() - 1, part, place });
    turn = 1.0;
    return true;
  };
  while (std::optional<LinePiece> piece = trace.Next())
  {
    this->Limit.RequireFew(half.Pieces.size());
    piece->Arc = length;
    half.Pieces.push_back(*piece);
    const double pieceLength = piece->Length();
    if (isNearStart && this->Closes(first, half))
    {
      return;
    }
    while (nextMark <= length + pieceLength)
    {
      const double at = pieceLength > 0.0 ? (nextMark - length) / pieceLength : 0.0;
      if (!mark(*piece, std::clamp(at, 0.0, 1.0)))
      {
        half.Keep(half.Marks.size());
        return;
      }
      since = { half.Marks.back().Sample.Position, piece->Triangle, this->Unit * nextMark };
      nextMark += step;
    }
    turn *= piece->EndDirection * std::conj(piece->BeginDirection);
    if (turn.real() < this->LeastTurn && !mark(*piece, 1.0))
    {
      half.Keep(half.Marks.size());
      return;
    }
    length += pieceLength;
    if (since.Winds(piece->Triangle, this->Unit * length,
          [&] { return this->PositionOf(piece->Triangle, piece->End); }))
    {
      half.End = StreamlineEnd::TooClose;
      return;
    }
    if (length >= mostLength)
    {
      half.Keep(half.Marks.size());
      half.End = StreamlineEnd::Length;
      return;
    }
  }
  half.End = trace.End();
  half.Zero = trace.EndZero();
  if (!half.Pieces.empty() && !mark(half.Pieces.back(), 1.0))
  {
    half.Keep(half.Marks.size());
  }
}

SpacedLine SpacedTracing::Trace(const LineStart& seed, const LineGrid& grid) const
{
  SpacedLine line;
  line.Seed = seed;
  LineGrid own = this->MakeGrid();
  const double most = this->Options.MaximumLength / this->Unit;
  this->TraceHalf(seed, 1, most, grid, own, line.Forward);
  if (!line.Forward.IsClosed)
  {
    const LineStart back{ seed.Triangle, seed.Place, -seed.Direction, -seed.Sense };
    this->TraceHalf(back, -1, std::max(most - line.Length(), 0.0), grid, own, line.Backward);
  }
  return line;
}

void SpacedTracing::Cut(SpacedLine& line, const LineGrid& grid) const
{
  const double radius = this->Options.Ratio * this->Options.Spacing;
  for (SpacedHalf* half : { &line.Forward, &line.Backward })
  {
    const auto bad = std::find_if(half->Marks.begin(), half->Marks.end(),
      [&](const SpacedHalf::Mark& mark) { return grid.IsNearWidely(mark.Sample, radius); });
    if (bad != half->Marks.end())
    {
      if (half->IsClosed)
      {
        // It begins at its seed now, where another line is near.
        line.Backward.End = StreamlineEnd::TooClose;
      }
      half->Keep(static_cast<std::size_t>(bad - half->Marks.begin()));
    }
  }
}
}
