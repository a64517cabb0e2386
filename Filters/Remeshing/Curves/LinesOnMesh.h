// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_LinesOnMesh_h
#define DirectionFields_LinesOnMesh_h

#include "Chains/MeshChain.h"
#include "Curves/CurveCut.h"
#include "FaceMesh/FaceMesh.h"
#include "Preparation/PreparedSurface.h"

#include <string>
#include <vector>

namespace DirectionFields::Internal
{
/// Which points the vertices of a mesh are to be: of those given all on the surface, but those that
/// are closer than a tenth of an edge to one before them; and tips of cones.
class ChosenPoints
{
public:
  ChosenPoints() = default;
  /// @param cut        null where no points are given
  /// @param tips       points of the surface, ascending; those with a given point close by are left
  ///                   out
  /// @param sizes      at the points of the cut surface
  /// @param edgeLength of size 1, in the unit of the surface
  ChosenPoints(const CurveCut* cut, const std::vector<Index>& tips,
    const std::vector<double>& sizes, double edgeLength);

  /// Points of the cut surface, ascending.
  const std::vector<Index>& OnSurface() const { return this->Surface; }

  /// Puts the vertices of a mesh that are given points onto their places, where they stay.
  void Place(const PreparedSurface& surface, const CurveCut& cut, FaceMesh& mesh) const;
  /// Chains of one vertex for the points that are vertices of the mesh, and sentences for the user
  /// on those that are none.
  std::vector<MeshChain> Find(const PreparedSurface& surface, const CurveCut& cut,
    const FaceMesh& mesh, std::vector<std::string>& sentences) const;

private:
  void Choose(const CurveCut& cut, const std::vector<double>& sizes, double edgeLength);
  void AddTips(const CurveCut* cut, const std::vector<Index>& tips,
    const std::vector<double>& sizes, double edgeLength);
  /// The number of the given point at a point of the cut surface, or None.
  Index NumberOf(Index point) const;

  std::vector<Index> Surface;
  /// Of the same place in the list; None for tips.
  std::vector<Index> Numbers;
  /// Points that have taken the same one of the surface as others before them, and points too close
  /// to others.
  std::vector<Index> AtOthers;
  std::vector<Index> TooClose;
};

/// What the lines of a mesh come from.
struct LineSources
{
  const PreparedSurface& Surface;
  /// The lines of the mesh are numbered by these.
  const FeatureLines& Features;
  /// Null where no curves and points are given.
  const CurveCut* Cut;
};

/// The chains of a mesh, and then the points given. An edge of a line is on the curve where the
/// place on its line is that is closest to its middle.
/// @param points  chosen
/// @param regions of the faces; empty for none
/// @param names   of the regions, by their numbers; empty for the numbers themselves
/// @param sentences gets those on points that are no vertices
std::vector<MeshChain> LinesOn(const FaceMesh& mesh, const LineSources& sources,
  const ChosenPoints& points, const std::vector<Index>& regions,
  const std::vector<std::string>& names, std::vector<std::string>& sentences);
}

#endif
