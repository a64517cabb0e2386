// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_ParametrizationCache_h
#define DirectionFields_ParametrizationCache_h

#include "Charts/FeatureLines.h"
#include "Parametrization/ParametrizationEnergy.h"

#include <array>
#include <memory>
#include <vector>

namespace DirectionFields::Internal
{
/// What is needed to make the map of a component, kept from one wanted length of edges to the next: it is made anew only
/// where the features have changed, or which stretches of them have a bound. That is decided before anything is
/// made, so that there never is more than one.
class ParametrizationCache
{
public:
  /// Of one component and one field, always the same.
  const CutMesh& MeshFor(const SurfaceGeometry& geometry, const TriangleMesh::Component& component,
    const FieldMatching& charts, const FeatureLines& features, const std::vector<char>& isFrameless,
    const std::vector<Complex>& section);
  /// Of that mesh.
  /// @param perLength 1 / h of each of its vertices, h the wanted length of an edge of the lattice
  ParametrizationEnergy& EnergyFor(const std::vector<double>& perLength);
  /// Releases what is too much to be kept. The mesh stays.
  /// @param share of the component in the triangles of all
  void Shrink(double share);

private:
  /// What charts depend on besides the field.
  struct Features
  {
    Features() = default;
    Features(const TriangleMesh::Component& component, const FeatureLines& features,
      const std::vector<char>& isFrameless);
    bool operator==(const Features& other) const
    {
      return this->Edges == other.Edges && this->Frameless == other.Frameless &&
        this->Ends == other.Ends;
    }

    /// The number, whether it is a feature, the line, the axis and the base of each edge that is, or was, a feature.
    std::vector<std::array<Index, 5>> Edges;
    std::vector<Index> Frameless;
    std::vector<Index> Ends;
  };

  Features Made;
  std::unique_ptr<const CutMesh> Mesh;
  std::unique_ptr<ParametrizationEnergy> Energy;
};
}

#endif
