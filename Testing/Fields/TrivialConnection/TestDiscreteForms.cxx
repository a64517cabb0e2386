// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TrivialConnection/DiscreteForms.h"

#include "Fields/TrivialConnection/Components.h"
#include "Meshes/Surfaces.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

using namespace DirectionFields;
using Components::Tested;

TEST(DiscreteForms, RisesHaveNoCurl)
{
  for (const Surface& surface :
    { Meshes::Potato(2), Meshes::Torus(16, 9), Meshes::Disk(4), Meshes::MoebiusStrip(20, 3) })
  {
    const Tested tested(surface);
    const EdgeForm rise =
      Components::Rise(tested.Forms, Components::RandomNumbers(tested.Component.Vertices(), 1));
    EXPECT_LT(tested.LargestCurl(rise), 1e-14);
  }
}

/// The divergence is the adjoint of the gradient with respect to the products of forms and of vertices.
TEST(DiscreteForms, InflowIsTheAdjointOfTheRise)
{
  for (const Surface& surface :
    { Meshes::Potato(2), Meshes::Disk(5), Meshes::BadSphere(2, 0.4, 3) })
  {
    const Tested tested(surface);
    const Eigen::VectorXd values = Components::RandomNumbers(tested.Component.Vertices(), 2);
    const Eigen::VectorXd numbers = Components::RandomNumbers(tested.Component.Edges(), 3);
    const EdgeForm form(numbers.begin(), numbers.end());
    const double product = tested.Forms.Product(form, Components::Rise(tested.Forms, values));
    EXPECT_NEAR(product, tested.Forms.Inflow(form).dot(values), 1e-12 * (1.0 + std::abs(product)));
    EXPECT_NEAR(tested.Forms.Inflow(form).sum(), 0.0, 1e-9);
  }
}

/// The Hodge star is exact for gradients of linear functions: their product is the integral over the surface.
TEST(DiscreteForms, ProductOfLinearFunctionsIsTheirDirichletProduct)
{
  const Surface plane = Meshes::BadSquare(12, 5);
  const Tested tested(plane);
  Eigen::VectorXd x(tested.Component.Vertices());
  Eigen::VectorXd y(tested.Component.Vertices());
  for (Index v = 0; v < x.size(); ++v)
  {
    x[v] = tested.Geometry.Positions[v].x();
    y[v] = tested.Geometry.Positions[v].y();
  }
  const EdgeForm alongX = Components::Rise(tested.Forms, x);
  const EdgeForm alongY = Components::Rise(tested.Forms, 2.0 * y + x);
  EXPECT_NEAR(tested.Forms.Product(alongX, alongX), 1.0, 1e-9);
  EXPECT_NEAR(tested.Forms.Product(alongX, alongY), 1.0, 1e-9);
  EXPECT_NEAR(tested.Forms.Product(alongY, alongY), 5.0, 1e-9);
}

TEST(DiscreteForms, VertexAreasAddUpToTheArea)
{
  const Tested tested(Meshes::Potato(2));
  const Eigen::VectorXd areas = tested.Forms.VertexAreas();
  EXPECT_GT(areas.minCoeff(), 0.0);
  EXPECT_NEAR(areas.sum(), tested.Geometry.Lengths.ComponentArea[0], 1e-12 * areas.sum());
}

/// Hodge: the forms with neither curl nor inflow have the dimension 2g.
TEST(DiscreteForms, HarmonicFormsHaveTwiceTheGenusAsDimension)
{
  for (const auto& [surface, dimension] : { std::pair(Meshes::Icosphere(1), 0),
         std::pair(Meshes::Jittered(Meshes::Torus(9, 6), 0.02, 1), 2),
         std::pair(Meshes::DoubleTorus(), 4) })
  {
    const Tested tested(surface);
    const Index edges = tested.Component.Edges();
    const Index vertices = tested.Component.Vertices();
    Eigen::MatrixXd equations(vertices + tested.Component.Triangles(), edges);
    for (Index e = 0; e < edges; ++e)
    {
      EdgeForm form(edges, 0.0);
      form[e] = 1.0;
      equations.col(e).head(vertices) = tested.Forms.Inflow(form);
      for (Index t = 0; t < tested.Component.Triangles(); ++t)
      {
        equations(vertices + t, e) = tested.Forms.Around(form, t);
      }
    }
    const Eigen::MatrixXd normal = equations.transpose() * equations;
    Eigen::FullPivLU<Eigen::MatrixXd> factor(normal);
    factor.setThreshold(1e-9);
    EXPECT_EQ(factor.dimensionOfKernel(), dimension);
  }
}
