// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_CurveGuidance_h
#define DirectionFields_CurveGuidance_h

#include "Progress.h"
#include "Surface.h"

#include <memory>
#include <vector>

namespace DirectionFields
{
class ClosestPoints;
class GivenField;

struct CurveGuidanceOptions
{
  /// n of the field that is to be guided, 1 to 16.
  int Degree = 4;
  /// How far from the curves vertices are guided, along the surface, in its unit of length. 0: only
  /// the corners of the triangles that curves run through.
  double Radius = 0.0;
  /// The standard deviation of the Gaussian by which the weight falls with the distance, in parts
  /// of Radius, greater than 0.
  double Falloff = 0.5;
  /// Parts of curves that are farther from the surface do not count, in its unit of length. 0: all
  /// count.
  double MaximumDistance = 0.0;
  /// The strength of each curve, 0 to 1, or empty for 1: Guidance::Strengths of the vertices
  /// that it guides. Curves of strength 0 do not count.
  std::vector<double> Strengths = {};
};

/// Directions that curves ask for.
struct CurveGuidance
{
  /// Over the points of the surface: one of the n directions, of the length of its weight, and the
  /// weight: 1 on a curve, falling with the distance from it, and less where curves do not agree.
  /// Zero elsewhere, and where less than LeastCoherence is left of directions that cancel.
  std::vector<Vector3> Vectors;
  std::vector<double> Weights;
  /// Guidance::Strengths; empty where the options have none. At vertices that curves of strength 1
  /// run by the softer ones do not count; of these the stiffer count for more, as tau / (1 - tau).
  std::vector<double> Strengths;
  /// Samples taken of the curves, and those of them that are too far from the surface.
  Index Samples = 0;
  Index FarSamples = 0;

  static constexpr double LeastCoherence = 0.1;
};

/// Tangents of poly lines as guidance for a field of degree n. They are sampled every half edge
/// length and laid into the nearest triangles, carried along straight lines to the corners, and
/// added up as n-th powers, weighted by length and nearness: so opposite senses agree for even n,
/// and curves that cross at right angles agree for n = 4 and cancel for n = 2. Farther vertices get
/// the mean of their nearer neighbours' values, carried along the edges.
///
/// Throws std::invalid_argument for options out of their ranges and for other than one
/// strength a curve, MeshError and Stopped. Takes n log n time.
/// @param curves poly lines; places that are not finite break them
CurveGuidance GuideByCurves(const Surface& surface, const std::vector<std::vector<Vector3>>& curves,
  const CurveGuidanceOptions& options, const Progress& progress = {});

/// GuideByCurves for one surface and curves that change, as when they are drawn: the mesh and the
/// tree of the surface's triangles are made for the first ones, and kept. The same bytes.
class SurfaceCurves
{
public:
  explicit SurfaceCurves(std::shared_ptr<const Surface> surface);
  ~SurfaceCurves();
  SurfaceCurves(const SurfaceCurves&) = delete;
  SurfaceCurves& operator=(const SurfaceCurves&) = delete;

  /// Throws as GuideByCurves; then all that was kept stays.
  CurveGuidance Guide(const std::vector<std::vector<Vector3>>& curves,
    const CurveGuidanceOptions& options, const Progress& progress = {});

  const Surface& GetSurface() const { return *this->Input; }
  /// The tree of its triangles.
  const ClosestPoints& GetTriangles();

private:
  struct Kept;
  /// The mesh, as a field of a degree that has no directions.
  const GivenField& FieldOf(int degree);

  std::shared_ptr<const Surface> Input;
  std::unique_ptr<Kept> Last;
};
}

#endif
