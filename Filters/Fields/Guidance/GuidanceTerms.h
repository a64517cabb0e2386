// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GuidanceTerms_h
#define DirectionFields_GuidanceTerms_h

#include "Guidance/SoftConstraints.h"
#include "Matrices/FreeVertices.h"
#include "Matrices/Operators.h"

#include <vector>

namespace DirectionFields::Internal
{
/// Guidance and constraints of one component, counted from its first vertex.
struct ComponentGuide
{
  /// The section that the field is drawn to, one value for each vertex; empty for nothing.
  ComplexVector Guidance;
  /// The constraints.
  GivenValues Given;
  /// How much of the strength that the options ask for is meant for this component, 0 to 1.
  double Share = 1.0;
  /// Directions that free vertices are drawn to.
  SoftConstraints Soft = {};
};

/// A third of the area of the triangles at each vertex: each triangle adds a sixth of its area to
/// the diagonal of the mass matrix at its three corners.
Eigen::VectorXd VertexAreas(const SparseMatrix& mass);
/// Sets the areas of the given vertices and of their neighbours to 0: there guidance does not
/// count.
void ClearNear(const std::vector<Index>& given, const SparseMatrix& mass, Eigen::VectorXd& areas);
/// The largest real or imaginary part, in modulus, at the vertices whose area is not 0.
double LargestPart(const ComplexVector& guidance, const Eigen::VectorXd& areas);

/// A guide's terms in the linear systems of its component, for any strength: M q of the guidance q,
/// which is scaled to modulus 1 in the mean square over all vertices that are neither constrained
/// nor next to a constrained one. There the guidance is as large as the constraints.
class GuidanceTerms
{
public:
  GuidanceTerms(const Operators& operators, const ComponentGuide& guide);

  /// Whether these terms are those of the guide.
  bool Fit(const ComponentGuide& guide) const;

  /// Whether anything is left of the guidance.
  bool Any() const { return this->MassTimes.size() > 0; }
  /// M q; empty where nothing is left of the guidance.
  const ComplexVector& GetMassTimes() const { return this->MassTimes; }
  /// The factor times M q, zero at constrained vertices and their neighbours. Zero without
  /// guidance.
  ComplexVector RightHandSide(const Operators& operators, double factor) const;
  /// Area of the component, in unit^2.
  double GetArea() const { return this->Area; }

private:
  ComplexVector Guidance;
  std::vector<Index> GivenVertices;
  ComplexVector MassTimes;
  double Area = 0.0;
};
}

#endif
