// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_SingularPoints_h
#define DirectionFields_SingularPoints_h

#include "Interpolation/GivenField.h"
#include "Interpolation/InterpolantZero.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace DirectionFields::Internal
{
/// A singularity of a field: a triangle whose index is not 0, and the place in it where the field
/// is not defined.
struct SingularPoint
{
  /// Of the mesh, on the front.
  Index Triangle = None;
  /// In units of 1/n.
  int Index_ = 0;
  /// In the flat triangle.
  Complex Place;
};

/// A line that ends in a singularity: the angle in the flat triangle under which it leaves.
struct ZeroRay
{
  /// Number of the singularity.
  Index Zero = None;
  double Angle = 0.0;
  /// Distance from the singularity at which the angle holds, in the unit of the component.
  double Radius = 0.0;
  /// -1 where the field points along the line to the singularity: half of the rays for odd n.
  int Sense = 1;
};

/// A singularity that is closer to an edge or a corner of its triangle than lines are caught from,
/// as it is seen from a triangle that shares these.
struct ZeroBeside
{
  /// Of the mesh: from where it is seen, and the one that it is in.
  Index Triangle = None;
  Index ZeroTriangle = None;
  /// Number of the singularity.
  Index Zero = None;
  /// Its place in the triangle's plane, with the triangles between laid flat around the common
  /// vertex, counter-clockwise and clockwise: infinitely far where none are.
  std::array<Complex, 2> Seen;

  /// The place that is nearer to another one.
  const Complex& Near(const Complex& from) const
  {
    return this->Seen[std::norm(this->Seen[1] - from) < std::norm(this->Seen[0] - from) ? 1 : 0];
  }
};

/// All singularities of a field on the front, in the order of their triangles. On surfaces that
/// cannot be oriented the back has the same ones again, as places only.
class SingularPoints
{
public:
  /// Takes time linear in the triangles, on the threads of the scope.
  explicit SingularPoints(const GivenField& field);

  const std::vector<SingularPoint>& GetZeros() const { return this->Zeros; }
  /// The number of the singularity in a triangle of the mesh, on the front or the back; None if
  /// none is.
  Index ZeroIn(Index meshTriangle) const
  {
    return std::max(this->ZeroOfTriangle[meshTriangle], None);
  }
  /// Its place in that flat triangle.
  Complex PlaceIn(Index meshTriangle) const;
  /// The singularities that lie beside a triangle of the mesh without one: two iterators. On
  /// symmetric surfaces they lie on vertices, and lines run into them from all triangles there.
  std::pair<const ZeroBeside*, const ZeroBeside*> Beside(Index meshTriangle) const;

  /// The rays of a singularity of index k/n, counter-clockwise: |n - k| of them, and 2 |n - k| for
  /// odd n, on which the field points outwards, or along every second one inwards. None for k = n:
  /// there are only lines that run around, into or out of it.
  ///
  /// On a small circle around a singularity, the field points outwards where n beta = arg q(beta).
  /// Both sides are continuous; their difference grows by 2 pi (n - k) around the circle and so
  /// passes that many multiples of 2 pi. Where it passes one of them several times, which takes a
  /// strongly anisotropic singularity, the passage nearest to that of the isotropic part counts.
  std::vector<ZeroRay> Rays(Index zero) const;

private:
  void FindBeside(Index zero, Index zeroTriangle);
  /// Adds it to the triangles around a corner of its own, in time linear in their number.
  void AddAround(int corner, Index zero, Index zeroTriangle);
  /// Adds it to the triangle on the other side of an edge of its own.
  void AddAcross(Index twin, Index zero, Index zeroTriangle);
  void SortBeside();

  const GivenField& Field;
  std::vector<SingularPoint> Zeros;
  /// None - 1 - k where the first of AllBeside is number k.
  LargeArray<Index> ZeroOfTriangle;
  /// In the order of triangles.
  std::vector<ZeroBeside> AllBeside;
};

/// A place in a flat triangle of the mesh as seen in the flat triangle on the other side of a
/// cover.
Complex Mirrored(const GivenField& field, Index triangle, const Complex& place);
}

#endif
