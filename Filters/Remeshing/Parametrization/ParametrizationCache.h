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
/// Cached cut mesh, energy and factor of one component, reused for other edge lengths. The mesh is
/// set up again only if the features have changed, the energy also if other feature isolines need a
/// bound. The old ones are released first, so that there are never two of them.
class ParametrizationCache
{
public:
  /// Of one component and one field, always the same.
  const CutMesh& MeshFor(const SurfaceGeometry& geometry, const TriangleMesh::Component& component,
    const FieldMatching& matching, const FeatureLines& features,
    const std::vector<char>& isFrameless, const std::vector<Complex>& section);
  /// The energy on the mesh of the last MeshFor.
  /// @param perLength 1 / h of each of its vertices, h the wanted length of an edge of the grid
  ParametrizationEnergy& EnergyFor(const std::vector<double>& perLength);
  /// Releases the factor if it takes too much memory. The mesh stays.
  /// @param share the component's part of all triangles
  void Shrink(double share);

private:
  /// The input of a cut mesh besides the field.
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

    /// The number, whether it is a feature, the line, the axis and the base of each edge that is or
    /// was a feature.
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
