// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_GlyphSurfaceData_h
#define DirectionFields_GlyphSurfaceData_h

#include "Glyphs.h"
#include "Glyphs/SurfaceSampling.h"
#include "Interpolation/GivenField.h"
#include "Paths/SurfaceIncidence.h"
#include "Progress.h"
#include "Surface.h"

#include <memory>
#include <optional>
#include <vector>

namespace DirectionFields::Internal
{
/// The data of a GlyphSurface, each computed when it is first needed: the triangles at each point
/// with their normals, the places of the glyphs, the mesh of the field and the outside.
class GlyphSurfaceData
{
public:
  /// @param excludedTriangles not 0 for triangles without glyphs; empty for none
  /// @param excludedPoints    not 0 for points without glyphs; empty for none
  explicit GlyphSurfaceData(std::shared_ptr<const Surface> surface,
    std::vector<char> excludedTriangles = {}, std::vector<char> excludedPoints = {});
  GlyphSurfaceData(const GlyphSurfaceData&) = delete;
  GlyphSurfaceData& operator=(const GlyphSurfaceData&) = delete;

  /// The triangles in a unit of length of 2^GetExponent(), in which the squares of areas are
  /// numbers.
  const SurfaceIncidence& GetIncidence() const { return *this->Incidence; }
  int GetExponent() const { return this->Exponent; }

  /// The places of the glyphs, in the unit of the triangles. They are computed again where the
  /// mode, the spacing or the maximum number have changed.
  ///
  /// Throws Stopped, and keeps the former places then.
  const SurfaceSamples& GetPlaces(const GlyphOptions& options, const Progress& progress);
  /// How many times places were sought.
  int GetNumberOfSamplings() const { return this->NumberOfSamplings; }

  /// The mesh that fields between the points are interpolated on, in the unit of the triangles.
  const std::shared_ptr<const FieldSurface>& GetFieldSurface();

  /// Of each triangle, see OutwardSides.
  const std::vector<signed char>& GetOutwardSides();

private:
  /// The options that the places depend on.
  struct Key
  {
    GlyphMode Mode = GlyphMode::SpreadEvenly;
    double Spacing = 0.0;
    Index MaximumNumber = 0;

    bool operator==(const Key& other) const
    {
      return this->Mode == other.Mode && this->Spacing == other.Spacing &&
        this->MaximumNumber == other.MaximumNumber;
    }
  };

  std::shared_ptr<const Surface> Triangles;
  std::vector<char> ExcludedTriangles;
  std::vector<char> ExcludedPoints;
  int Exponent = 0;
  std::optional<SurfaceIncidence> Incidence;
  std::optional<Key> PlacesKey;
  SurfaceSamples Places;
  std::shared_ptr<const FieldSurface> FieldMesh;
  std::optional<std::vector<signed char>> Sides;
  int NumberOfSamplings = 0;
};

/// A number times a power of two, but finite where the number is.
double TimesPower(double number, int exponent);
}

#endif
