// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Streamlines/SingularPoints.h"

#include "Support/Threads.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
constexpr Index FewZeros = 16;
/// Radius of the circle around a singularity, as a part of the size of its triangle.
constexpr double Circle = 0.02;
/// Singularities are seen from other triangles if they are nearer than this part of the size of
/// their own.
constexpr double Reach = 0.1;
const Complex Far(1e300, 0.0);
/// Places on the circle where it is looked at; the angles between them are found by bisection.
constexpr int Places = 360;
constexpr int Bisections = 50;

/// How the difference of n beta and arg q goes around a circle.
class Turning
{
public:
  Turning(const FieldInterpolant& power, const Complex& center, double radius)
    : Power(power)
    , Center(center)
    , Radius(radius)
  {
  }

  Complex ValueAt(double angle) const
  {
    return this->Power.At(this->Center + std::polar(this->Radius, angle));
  }
  /// (n beta - arg q) up to multiples of 2 pi, -pi to pi.
  double DifferenceAt(double angle) const
  {
    return std::arg(
      std::polar(1.0, this->Power.Degree() * angle) * std::conj(this->ValueAt(angle)));
  }
  /// The part of q that turns k times: its argument at angle 0.
  double PhaseOf(int k) const
  {
    Complex sum = 0.0;
    for (int i = 0; i < Places; ++i)
    {
      const double angle = 2.0 * Pi * i / Places;
      sum += this->ValueAt(angle) * std::polar(1.0, -k * angle);
    }
    return std::arg(sum);
  }
  /// Differences at places from an angle on, all around, without jumps: Places + 1 of them.
  std::vector<double> Unwrapped(double first) const
  {
    std::vector<double> differences = { this->DifferenceAt(first) };
    for (int i = 1; i <= Places; ++i)
    {
      const double next = this->DifferenceAt(first + 2.0 * Pi * i / Places);
      const double step = next - differences.back();
      differences.push_back(differences.back() + step - 2.0 * Pi * std::round(step / (2.0 * Pi)));
    }
    return differences;
  }
  /// Where the difference has a value modulo 2 pi, between two angles where it is less and more.
  double Solve(double low, double high, bool rises, double value) const
  {
    const auto above = [&](double angle)
    { return std::arg(std::polar(1.0, this->DifferenceAt(angle) - value)); };
    for (int i = 0; i < Bisections; ++i)
    {
      const double middle = 0.5 * (low + high);
      (above(middle) > 0.0) == rises ? high = middle : low = middle;
    }
    return 0.5 * (low + high);
  }

private:
  const FieldInterpolant& Power;
  Complex Center;
  double Radius;
};

/// The angles where n beta - arg q is `value` modulo 2 pi, one for each time it should be.
/// @param phase of the isotropic part of q at angle 0
std::vector<double> RayAngles(
  const Turning& turning, int degree, int index, double phase, double value)
{
  const int count = degree - index;
  std::vector<double> angles;
  if (count == 0)
  {
    return angles;
  }
  // From the middle between two rays of the isotropic part on.
  const double first = (phase + value - Pi) / count;
  const std::vector<double> differences = turning.Unwrapped(first);
  const double step = 2.0 * Pi / Places;
  const double gained = differences.back() - differences.front();
  const bool isRegular = std::abs(gained - 2.0 * Pi * count) < 1.0;
  // The level that the isotropic part passes next.
  const double sign = count > 0 ? 1.0 : -1.0;
  const double next =
    value + 2.0 * Pi * std::round((differences.front() + sign * Pi - value) / (2.0 * Pi));
  for (int m = 0; m < std::abs(count); ++m)
  {
    const double isotropic = first + (2 * m + 1) * Pi / std::abs(count);
    const double level = next + sign * 2.0 * Pi * m;
    double best = isotropic;
    double least = -1.0;
    for (int i = 0; isRegular && i < Places; ++i)
    {
      const bool passes = (differences[i] < level) != (differences[i + 1] < level);
      const double away = std::abs(first + (i + 0.5) * step - isotropic);
      if (passes && (least < 0.0 || away < least))
      {
        least = away;
        best = turning.Solve(
          first + i * step, first + (i + 1) * step, differences[i + 1] > differences[i], value);
      }
    }
    angles.push_back(best);
  }
  return angles;
}

/// The half-edge that leaves the same vertex next; None at a boundary.
Index NextSpoke(const TriangleMesh& mesh, Index spoke, bool counterClockwise)
{
  const Index twin = mesh.Twin(counterClockwise ? TriangleMesh::Previous(spoke) : spoke);
  return counterClockwise || twin == None ? twin : TriangleMesh::Next(twin);
}

/// The turn by the angle of a triangle where a half-edge of it starts.
Complex CornerTurn(const SurfaceGeometry& geometry, Index spoke)
{
  const FlatTriangle flat(geometry, spoke / 3);
  const int c = spoke % 3;
  return -flat.Along((c + 2) % 3) * std::conj(flat.Along(c));
}

/// A place in a triangle from where a half-edge starts, against its direction.
Complex OffsetAtSpoke(const SurfaceGeometry& geometry, Index spoke, const Complex& place)
{
  const FlatTriangle flat(geometry, spoke / 3);
  return (place - flat.Corner(spoke % 3)) * std::conj(flat.Along(spoke % 3));
}

/// The place with such an offset.
Complex SeenAtSpoke(const SurfaceGeometry& geometry, Index spoke, const Complex& offset)
{
  const FlatTriangle flat(geometry, spoke / 3);
  return flat.Corner(spoke % 3) + flat.Along(spoke % 3) * offset;
}
}

SingularPoints::SingularPoints(const GivenField& field)
  : Field(field)
  , ZeroOfTriangle(field.GetMesh().GetNumberOfTriangles())
{
  const TriangleMesh& mesh = field.GetMesh();
  const std::vector<int> indices = field.Indices();
  for (Index t = 0; t < mesh.GetNumberOfTriangles(); ++t)
  {
    this->ZeroOfTriangle[t] = None;
    if (indices[t] != 0 && mesh.IsFront(t))
    {
      this->ZeroOfTriangle[t] = static_cast<Index>(this->Zeros.size());
      this->Zeros.push_back({ t, indices[t], 0.0 });
    }
  }
  ParallelFor(static_cast<Index>(this->Zeros.size()), FewZeros,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        SingularPoint& zero = this->Zeros[i];
        const FieldInterpolant power(
          field.GetGeometry(), field.GetDegree(), field.GetSection().data(), zero.Triangle);
        zero.Place = FindZero(power, zero.Index_ > 0 ? 1 : -1).Place;
      }
    });
  for (Index i = 0; i < static_cast<Index>(this->Zeros.size()); ++i)
  {
    const Index mirror = mesh.Mirror(3 * this->Zeros[i].Triangle);
    if (mirror != None)
    {
      this->ZeroOfTriangle[mirror / 3] = i;
    }
  }
  for (Index i = 0; i < static_cast<Index>(this->Zeros.size()); ++i)
  {
    const Index mirror = mesh.Mirror(3 * this->Zeros[i].Triangle);
    this->FindBeside(i, this->Zeros[i].Triangle);
    if (mirror != None)
    {
      this->FindBeside(i, mirror / 3);
    }
  }
  this->SortBeside();
}

Complex SingularPoints::PlaceIn(Index meshTriangle) const
{
  const SingularPoint& zero = this->Zeros[this->ZeroOfTriangle[meshTriangle]];
  return zero.Triangle == meshTriangle ? zero.Place
                                       : Mirrored(this->Field, zero.Triangle, zero.Place);
}

void SingularPoints::FindBeside(Index zero, Index zeroTriangle)
{
  const SurfaceGeometry& geometry = this->Field.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  const FlatTriangle flat(geometry, zeroTriangle);
  const Complex place = this->PlaceIn(zeroTriangle);
  const double reach = Reach * std::sqrt(2.0 * flat.Area());
  for (int c = 0; c < 3; ++c)
  {
    const Index spoke = 3 * zeroTriangle + c;
    if (std::abs(place - flat.Corner(c)) < reach)
    {
      this->AddAround(c, zero, zeroTriangle);
    }
    const Complex offset = (place - flat.Corner(c)) * std::conj(flat.Along(c));
    const Index twin = mesh.Twin(spoke);
    if (std::abs(offset.imag()) < reach && twin != None)
    {
      this->AddAcross(twin, zero, zeroTriangle);
    }
  }
}

void SingularPoints::AddAround(int corner, Index zero, Index zeroTriangle)
{
  const SurfaceGeometry& geometry = this->Field.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  const Index own = 3 * zeroTriangle + corner;
  const Complex offset = OffsetAtSpoke(geometry, own, this->PlaceIn(zeroTriangle));
  struct Spoke
  {
    Index HalfEdge;
    std::array<Complex, 2> Seen;
  };
  std::vector<Spoke> spokes;
  Complex turn = 1.0;
  Index h = own;
  for (Index next = NextSpoke(mesh, h, true); next != None && next != own;
       next = NextSpoke(mesh, h, true))
  {
    turn *= std::conj(CornerTurn(geometry, h));
    h = next;
    spokes.push_back({ h, { Far, SeenAtSpoke(geometry, h, turn * offset) } });
  }
  const bool isClosed = NextSpoke(mesh, h, true) == own;
  turn = 1.0;
  std::size_t at = spokes.size();
  for (h = NextSpoke(mesh, own, false); h != None && h != own; h = NextSpoke(mesh, h, false))
  {
    turn *= CornerTurn(geometry, h);
    const Complex seen = SeenAtSpoke(geometry, h, turn * offset);
    if (isClosed)
    {
      // The same ones from the other end.
      spokes[--at].Seen[0] = seen;
    }
    else
    {
      spokes.push_back({ h, { seen, Far } });
    }
  }
  for (const Spoke& spoke : spokes)
  {
    if (this->ZeroOfTriangle[spoke.HalfEdge / 3] == None)
    {
      this->AllBeside.push_back({ spoke.HalfEdge / 3, zeroTriangle, zero, spoke.Seen });
    }
  }
}

void SingularPoints::AddAcross(Index twin, Index zero, Index zeroTriangle)
{
  if (this->ZeroOfTriangle[twin / 3] != None)
  {
    return;
  }
  const SurfaceGeometry& geometry = this->Field.GetGeometry();
  const TriangleMesh& mesh = geometry.Mesh;
  ZeroBeside beside{ twin / 3, zeroTriangle, zero, { Far, Far } };
  for (const bool counterClockwise : { true, false })
  {
    Complex turn = 1.0;
    Index spoke = twin;
    while (spoke != None && spoke / 3 != zeroTriangle)
    {
      const Index next = NextSpoke(mesh, spoke, counterClockwise);
      if (next != None)
      {
        turn *=
          counterClockwise ? CornerTurn(geometry, spoke) : std::conj(CornerTurn(geometry, next));
      }
      spoke = next == twin ? None : next;
    }
    if (spoke != None)
    {
      const Complex offset = OffsetAtSpoke(geometry, spoke, this->PlaceIn(zeroTriangle));
      beside.Seen[counterClockwise ? 0 : 1] = SeenAtSpoke(geometry, twin, turn * offset);
    }
  }
  this->AllBeside.push_back(beside);
}

void SingularPoints::SortBeside()
{
  std::stable_sort(this->AllBeside.begin(), this->AllBeside.end(),
    [](const ZeroBeside& a, const ZeroBeside& b) { return a.Triangle < b.Triangle; });
  for (Index k = static_cast<Index>(this->AllBeside.size()) - 1; k >= 0; --k)
  {
    this->ZeroOfTriangle[this->AllBeside[k].Triangle] = None - 1 - k;
  }
}

std::pair<const ZeroBeside*, const ZeroBeside*> SingularPoints::Beside(Index meshTriangle) const
{
  const Index code = this->ZeroOfTriangle[meshTriangle];
  if (code >= None)
  {
    return { nullptr, nullptr };
  }
  const ZeroBeside* begin = this->AllBeside.data() + (None - 1 - code);
  const ZeroBeside* const all = this->AllBeside.data() + this->AllBeside.size();
  const ZeroBeside* end = begin;
  while (end != all && end->Triangle == meshTriangle)
  {
    ++end;
  }
  return { begin, end };
}

std::vector<ZeroRay> SingularPoints::Rays(Index zero) const
{
  const SingularPoint& at = this->Zeros[zero];
  const int n = this->Field.GetDegree();
  const FieldInterpolant power(
    this->Field.GetGeometry(), n, this->Field.GetSection().data(), at.Triangle);
  // Beyond the edges it is that of the triangle still: singularities may lie close to an edge.
  const double radius = Circle * std::sqrt(2.0 * power.Flat().Area());
  const Turning turning(power, at.Place, radius);
  const double phase = turning.PhaseOf(at.Index_);
  std::vector<ZeroRay> rays;
  for (int sense = 1; sense >= (n % 2 == 1 ? -1 : 1); sense -= 2)
  {
    for (const double angle : RayAngles(turning, n, at.Index_, phase, sense > 0 ? 0.0 : Pi))
    {
      rays.push_back({ zero, angle, radius, sense });
    }
  }
  std::stable_sort(
    rays.begin(), rays.end(), [](const ZeroRay& a, const ZeroRay& b) { return a.Angle < b.Angle; });
  return rays;
}

Complex Mirrored(const GivenField& field, Index triangle, const Complex& place)
{
  const SurfaceGeometry& geometry = field.GetGeometry();
  const std::array<double, 3> weights = FlatTriangle(geometry, triangle).Weights(place);
  const FlatTriangle other(geometry, geometry.Mesh.Mirror(3 * triangle) / 3);
  // An edge from corner c on one side runs to corner -c on the other.
  return other.Place({ weights[0], weights[2], weights[1] });
}
}
