// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_TestedComponents_h
#define DirectionFields_TestedComponents_h

#include "Geometry/SurfaceGeometry.h"
#include "TrivialConnection/TreeCotree.h"

#include <random>
#include <vector>

/// The first component of a surface with the parts that trivial connections are made of.
namespace Components
{
using namespace DirectionFields;

struct Tested
{
  /// @param given points whose directions are given
  explicit Tested(const Surface& surface, const std::vector<Index>& given = {})
    : Geometry(surface)
    , Mesh(Geometry.Mesh)
    , Component(Mesh.GetComponents().front())
    , Forms(Geometry, Component)
    , Constrained(Mesh, Component, Given(Mesh, given))
    , Trees(Forms, Constrained)
  {
  }

  static std::vector<char> Given(const TriangleMesh& mesh, const std::vector<Index>& points)
  {
    std::vector<char> given(points.empty() ? 0 : mesh.GetNumberOfVertices(), 0);
    for (std::size_t v = 0; v < given.size(); ++v)
    {
      given[v] = std::count(points.begin(), points.end(), mesh.Point(static_cast<Index>(v))) > 0;
    }
    return given;
  }

  EdgeForm Dense(const std::vector<TreeCotree::Term>& terms) const
  {
    EdgeForm form(Component.Edges(), 0.0);
    for (const TreeCotree::Term& term : terms)
    {
      form[term.Edge] += term.Value;
    }
    return form;
  }

  /// The largest sum of a form around a triangle.
  double LargestCurl(const EdgeForm& form) const
  {
    double largest = 0.0;
    for (Index t = 0; t < Component.Triangles(); ++t)
    {
      largest = std::max(largest, std::abs(Forms.Around(form, t)));
    }
    return largest;
  }

  SurfaceGeometry Geometry;
  const TriangleMesh& Mesh;
  const TriangleMesh::Component& Component;
  DiscreteForms Forms;
  ConstrainedSets Constrained;
  TreeCotree Trees;
};

inline Eigen::VectorXd RandomNumbers(Eigen::Index size, unsigned seed)
{
  std::mt19937 random(seed);
  Eigen::VectorXd numbers(size);
  for (double& number : numbers)
  {
    number = random() / 4294967296.0 - 0.5;
  }
  return numbers;
}

/// The rise of values along each edge.
inline EdgeForm Rise(const DiscreteForms& forms, const Eigen::VectorXd& values)
{
  EdgeForm rise(forms.GetComponent().Edges(), 0.0);
  forms.SubtractRise(-values, rise);
  return rise;
}
}

#endif
