// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/StreamlineTrace.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace DirectionFields::Internal
{
namespace
{
/// Step of a line, as a part of the size of the triangle.
constexpr double StepPart = 0.25;
/// Step near a singularity, as a part of the distance.
constexpr double ZeroPart = 0.25;
/// Steps are halved where the field turns by more than this part of the angle between two
/// directions.
constexpr double MostTurn = 0.2;
constexpr int MostHalvings = 6;
/// Lines cross edges at least this part of their length away from the ends.
constexpr double OffVertices = 1e-9;
/// A streamline is stuck if this number of steps is together shorter than this part of a triangle's
/// size, as around a vertex without directions.
constexpr int StepsToLookAt = 256;
constexpr double LeastProgress = 1e-3;
/// A streamline that makes 8 steps below 1e-7 of a triangle's size alternating between two
/// triangles runs along their edge, and is kept on it.
constexpr int FewWithoutProgress = 8;
/// A barycentric coordinate that is 0 up to rounding.
constexpr double OnEdge = 1e-12;
constexpr double Progress = 1e-7;
/// Straight walks of one length over few triangles, and over many: those that wind around a spike
/// more often lead nowhere near.
constexpr Index LeastCrossings = 4096;
constexpr Index MostCrossings = 1 << 20;
/// The most pieces of all lines together, which take some five gigabytes up to the filter's output,
/// and of one line: this number, and more for each triangle of the surface.
constexpr std::size_t MostPieces = 20000000;
constexpr std::size_t LeastOfLine = 200000;
constexpr std::size_t PerTriangle = 1000;

/// Where in (0, 1] a cubic vanishes that has these values and slopes at 0 and 1 and is negative at
/// 1. One that starts at 0 already, on the edge that the line has come through, and rises from
/// there, vanishes once more; one that falls leaves at once.
double RootOfCubic(double begin, double beginSlope, double end, double endSlope)
{
  const bool startsAtZero = !(begin > OnEdge);
  if (startsAtZero && !(beginSlope > 0.0))
  {
    return 0.0;
  }
  // Divided by t where it starts at 0.
  const auto value = [&](double t)
  {
    const double s = 1.0 - t;
    const double rest = end * t * (3.0 - 2.0 * t) - endSlope * t * s;
    return startsAtZero ? beginSlope * s * s + rest
                        : begin * s * s * (1.0 + 2.0 * t) + t * (beginSlope * s * s + rest);
  };
  const auto derivative = [&](double t)
  {
    const double s = 1.0 - t;
    return startsAtZero
      ? end * (3.0 - 4.0 * t) - 2.0 * beginSlope * s - endSlope * (s - t)
      : 6.0 * t * s * (end - begin) + beginSlope * s * (s - 2.0 * t) - endSlope * t * (2.0 * s - t);
  };
  // Newton's steps; where they leave the bracket, and after ten of them, its middle.
  double low = 0.0;
  double high = 1.0;
  const double atLow = value(low);
  double t = atLow / (atLow - value(high));
  for (int i = 0; i < 60 && high - low > 1e-14; ++i)
  {
    const double at = value(t);
    (at > 0.0 ? low : high) = t;
    const double step = at / derivative(t);
    if (std::abs(at) < 1e-15 || std::abs(step) < 1e-15)
    {
      return t;
    }
    const double next = t - step;
    t = next > low && next < high && i < 10 ? next : 0.5 * (low + high);
  }
  return high;
}

/// The same place and direction in the triangle beyond an edge, and that triangle.
struct Beyond
{
  Index Triangle;
  int Edge;
  double Part;
  /// Against the edge, which runs the other way there.
  Complex Turn;

  Complex Place(const FlatTriangle& flat) const
  {
    const Complex& from = flat.Corner((this->Edge + 1) % 3);
    return from + this->Part * (flat.Corner(this->Edge) - from);
  }
  Complex Direction(const FlatTriangle& flat) const
  {
    const Complex direction = -flat.Along(this->Edge) * this->Turn;
    return direction / std::abs(direction);
  }
};

/// @param edge the corner where the edge starts
Beyond AcrossEdge(const TriangleMesh& mesh, const FlatTriangle& flat, Index triangle, int edge,
  const Complex& place, const Complex& direction)
{
  const Complex offset = (place - flat.Corner(edge)) * std::conj(flat.Along(edge));
  const double part = std::clamp(offset.real() / flat.Length(edge), OffVertices, 1.0 - OffVertices);
  const Index twin = mesh.Twin(3 * triangle + edge);
  return { twin == None ? None : twin / 3, twin == None ? 0 : twin % 3, part,
    direction * std::conj(flat.Along(edge)) };
}
}

PieceLimit::PieceLimit(Index triangles)
  : MostOfLine(LeastOfLine + PerTriangle * static_cast<std::size_t>(triangles))
{
}

void PieceLimit::Count(std::size_t ofLine) const
{
  this->RequireFew(this->Counted.fetch_add(PerCall) + PerCall > MostPieces
      ? MostPieces + this->MostOfLine
      : ofLine);
}

void PieceLimit::RequireFew(std::size_t ofLine) const
{
  if (ofLine > this->MostOfLine)
  {
    throw std::invalid_argument(
      "The lines are so long, or triangles so small, that they would have "
      "many million points. Lower Maximum Streamline Length.");
  }
}

Complex TracedField::DirectionNear(const Complex& power, int degree, const Complex& near, int sense)
{
  if (degree == 1)
  {
    const double size = std::sqrt(std::norm(power));
    return size > 0.0 ? static_cast<double>(sense) * power / size : near;
  }
  // The angle from it to the nearest one, by the n-th powers of both.
  const Complex turn =
    power * std::conj(IntegerPower(near, degree)) * (sense < 0 && degree % 2 == 1 ? -1.0 : 1.0);
  return near * UnitNumber(AngleOf(turn) / degree);
}

StreamlineTrace::StreamlineTrace(const TracedField& field, const LineStart& start)
  : Traced(field)
  , At(start.Place)
  , Heading(start.Direction)
  , Sense(start.Sense)
{
  this->Enter(start.Triangle);
  this->Heading = this->DirectionAt(this->At, this->Heading);
}

void StreamlineTrace::StartAtZero(double arc)
{
  this->FreeUntil = arc;
}

void StreamlineTrace::Enter(Index triangle)
{
  const GivenField& field = this->Traced.Field;
  this->Current = triangle;
  this->Power.emplace(field.GetGeometry(), field.GetDegree(), field.GetSection().data(), triangle);
  this->Size = std::sqrt(2.0 * this->Power->Flat().Area());
  this->Zero = this->Traced.Zeros.ZeroIn(triangle);
  if (this->Zero != None)
  {
    this->ZeroPlace = this->Traced.Zeros.PlaceIn(triangle);
  }
  this->Beside = this->Traced.Zeros.Beside(triangle);
}

Complex StreamlineTrace::DirectionAt(const Complex& place, const Complex& near) const
{
  return TracedField::DirectionNear(
    this->Power->At(place), this->Power->Degree(), near, this->Sense);
}

double StreamlineTrace::StepLength() const
{
  double length = std::min(StepPart * this->Size, this->Traced.LongestStep);
  if (this->Zero != None)
  {
    const double distance = std::abs(this->At - this->ZeroPlace);
    length = std::min(length, ZeroPart * std::max(distance, 0.01 * this->Size));
  }
  for (const ZeroBeside* beside = this->Beside.first; beside != this->Beside.second; ++beside)
  {
    const double distance = std::abs(this->At - beside->Near(this->At));
    length = std::min(length, ZeroPart * std::max(distance, 0.05 * this->Size));
  }
  return length;
}

bool StreamlineTrace::RunsIntoBeside()
{
  if (this->Done < this->FreeUntil)
  {
    return false;
  }
  const SurfaceGeometry& geometry = this->Traced.Field.GetGeometry();
  for (const ZeroBeside* beside = this->Beside.first; beside != this->Beside.second; ++beside)
  {
    const Complex offset = beside->Near(this->At) - this->At;
    const double size = std::sqrt(2.0 * geometry.Lengths.Area[beside->ZeroTriangle]);
    const double distance = std::abs(offset);
    if (!(distance <= this->Traced.Capture * size) || distance == 0.0)
    {
      continue;
    }
    std::vector<LinePiece> pieces;
    const LineStart end = WalkStraight(this->Traced.Field,
      { this->Current, this->At, offset / distance, this->Sense }, distance, &pieces);
    // On the other side of the vertex it would miss it.
    if (end.Triangle == beside->ZeroTriangle &&
      std::abs(end.Place - this->Traced.Zeros.PlaceIn(end.Triangle)) < 1e-6 * size)
    {
      pieces.front().BeginDirection = this->Heading;
      pieces.back().End = this->Traced.Zeros.PlaceIn(end.Triangle);
      this->PiecesInto.assign(pieces.rbegin(), pieces.rend());
      this->RanInto = beside->Zero;
      return true;
    }
  }
  return false;
}

StreamlineTrace::Step StreamlineTrace::Advance(double length) const
{
  const double most = std::cos(MostTurn * Pi / this->Power->Degree());
  const auto turnsLittle = [most](const Complex& a, const Complex& b)
  { return a.real() * b.real() + a.imag() * b.imag() > most; };
  // That of the field at this place already.
  const Complex first = this->Heading;
  for (int halving = 0;; ++halving, length *= 0.5)
  {
    const Complex second = this->DirectionAt(this->At + 0.5 * length * first, first);
    const bool isLast = halving == MostHalvings;
    if (!isLast && !turnsLittle(first, second))
    {
      continue;
    }
    const Complex third = this->DirectionAt(this->At + 0.5 * length * second, second);
    const Complex fourth = this->DirectionAt(this->At + length * third, third);
    if (!isLast && !turnsLittle(second, fourth))
    {
      continue;
    }
    const Complex mean = (first + 2.0 * (second + third) + fourth) / 6.0;
    return { this->At + length * mean, first, fourth, length };
  }
}

int StreamlineTrace::CutAtExit(Step& step) const
{
  const FlatTriangle& flat = this->Power->Flat();
  int exit = None;
  double earliest = 1.0;
  for (int c = 0; c < 3; ++c)
  {
    const double end = flat.Weight(c, step.Place);
    if (end >= 0.0)
    {
      continue;
    }
    const Complex& slope = flat.Slope(c);
    const auto along = [&](const Complex& direction)
    { return step.Length * (slope.real() * direction.real() + slope.imag() * direction.imag()); };
    const double part = RootOfCubic(
      flat.Weight(c, this->At), along(step.BeginDirection), end, along(step.EndDirection));
    // The edge opposite of the corner.
    if (exit == None || part < earliest)
    {
      earliest = part;
      exit = (c + 1) % 3;
    }
  }
  if (exit != None)
  {
    const double t = earliest;
    const double s = 1.0 - t;
    const Complex place = this->At * (s * s * (1.0 + 2.0 * t)) +
      step.BeginDirection * (step.Length * t * s * s) + step.Place * (t * t * (3.0 - 2.0 * t)) -
      step.EndDirection * (step.Length * t * t * s);
    // Onto the edge, between its ends.
    const Complex& from = flat.Corner(exit);
    const Complex& along = flat.Along(exit);
    const double length = flat.Length(exit);
    const double part = std::clamp(
      ((place - from) * std::conj(along)).real() / length, OffVertices, 1.0 - OffVertices);
    step.Place = from + part * length * along;
    step.EndDirection =
      this->DirectionAt(step.Place, t < 0.5 ? step.BeginDirection : step.EndDirection);
  }
  return exit;
}

int StreamlineTrace::MoveInside(Step& step) const
{
  const FlatTriangle& flat = this->Power->Flat();
  std::array<double, 3> weights = flat.Weights(step.Place);
  double sum = 0.0;
  for (double& weight : weights)
  {
    weight = std::max(weight, OffVertices);
    sum += weight;
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  step.Place = flat.Place(weights);
  return None;
}

void StreamlineTrace::Cross(int edge, const Step& step)
{
  const Beyond beyond = AcrossEdge(this->Traced.Field.GetMesh(), this->Power->Flat(), this->Current,
    edge, step.Place, step.EndDirection);
  if (beyond.Triangle == None)
  {
    this->Reason = StreamlineEnd::Boundary;
    return;
  }
  this->Enter(beyond.Triangle);
  this->At = beyond.Place(this->Power->Flat());
  this->Heading = beyond.Direction(this->Power->Flat());
}

std::optional<LinePiece> StreamlineTrace::Next()
{
  if (this->Reason != StreamlineEnd::None)
  {
    return std::nullopt;
  }
  LinePiece piece{ this->Current, this->At, this->At, this->Heading, this->Heading, this->Done };
  const bool runsInto = this->Zero != None && this->Done >= this->FreeUntil &&
    std::abs(this->At - this->ZeroPlace) <= this->Traced.Capture * this->Size;
  if (runsInto)
  {
    piece.End = this->ZeroPlace;
    this->At = this->ZeroPlace;
    if (piece.Length() > 0.0)
    {
      piece.EndDirection = (piece.End - piece.Begin) / piece.Length();
    }
    this->Done += piece.Length();
    this->Reason = StreamlineEnd::Singularity;
    this->RanInto = this->Zero;
    return piece;
  }
  if (!this->PiecesInto.empty() || this->RunsIntoBeside())
  {
    piece = this->PiecesInto.back();
    piece.Arc = this->Done;
    this->PiecesInto.pop_back();
    this->At = piece.End;
    this->Done += piece.Length();
    this->Reason = this->PiecesInto.empty() ? StreamlineEnd::Singularity : StreamlineEnd::None;
    return piece;
  }
  Step step = this->Advance(this->StepLength());
  const bool staysOnEdge = this->WithoutProgress == FewWithoutProgress;
  const int exit = staysOnEdge ? this->MoveInside(step) : this->CutAtExit(step);
  piece.BeginDirection = step.BeginDirection;
  piece.EndDirection = step.EndDirection;
  piece.End = step.Place;
  const double length = piece.Length();
  this->Done += length;
  this->WithoutProgress = length > Progress * this->Size ? 0 : this->WithoutProgress + 1;
  const bool isToBeLookedAt = ++this->Steps % StepsToLookAt == 0;
  const bool isStuck = isToBeLookedAt && this->Done - this->LookedAt < LeastProgress * this->Size;
  if (isToBeLookedAt)
  {
    this->LookedAt = this->Done;
  }
  if (isStuck)
  {
    this->Reason = StreamlineEnd::Stuck;
  }
  else if (exit != None)
  {
    this->Cross(exit, step);
  }
  else
  {
    this->At = step.Place;
    this->Heading = this->DirectionAt(this->At, step.EndDirection);
    piece.EndDirection = this->Heading;
  }
  return piece;
}

LineStart WalkStraight(
  const GivenField& field, const LineStart& start, double length, std::vector<LinePiece>* pieces)
{
  LineStart at = start;
  double left = length;
  FlatTriangle flat(field.GetGeometry(), at.Triangle);
  const Index triangles = field.GetMesh().GetNumberOfTriangles();
  const Index most = std::min(MostCrossings, LeastCrossings + std::min(triangles, MostCrossings));
  for (Index crossing = 0; crossing < most; ++crossing)
  {
    int exit = None;
    double nearest = left;
    for (int c = 0; c < 3; ++c)
    {
      const Complex& slope = flat.Slope(c);
      const double falls =
        -(slope.real() * at.Direction.real() + slope.imag() * at.Direction.imag());
      if (falls > 0.0)
      {
        const double distance = std::max(flat.Weight(c, at.Place), 0.0) / falls;
        if (distance < nearest)
        {
          nearest = distance;
          exit = (c + 1) % 3;
        }
      }
    }
    const Complex from = at.Place;
    at.Place += nearest * at.Direction;
    if (pieces)
    {
      pieces->push_back({ at.Triangle, from, at.Place, at.Direction, at.Direction, length - left });
    }
    left -= nearest;
    if (exit == None)
    {
      return at;
    }
    const Beyond beyond =
      AcrossEdge(field.GetMesh(), flat, at.Triangle, exit, at.Place, at.Direction);
    at.Triangle = beyond.Triangle;
    if (beyond.Triangle == None)
    {
      return at;
    }
    flat = FlatTriangle(field.GetGeometry(), at.Triangle);
    at.Place = beyond.Place(flat);
    at.Direction = beyond.Direction(flat);
  }
  at.Triangle = None;
  return at;
}
}
