// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lays out glyphs of two cross fields on a torus. Their places are no nearer to each other than a
// spacing s and leave no room for another: N of them on an area A have 1 / pi <= N s^2 / A <= 2 /
// sqrt(3) (circles of radius s cover the surface, those of half of it are packed). They are
// found once for both fields.

#include <DirectionFields/DirectionField.h>
#include <DirectionFields/Glyphs.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

using namespace DirectionFields;

int main()
{
  constexpr Index n = 96, m = 48;
  const auto torus = std::make_shared<Surface>();
  for (Index k = 0; k < n * m; ++k)
  {
    const Index i = k % n, j = k / n, right = j * n + (i + 1) % n, up = (j + 1) % m * n;
    const double phi = 2.0 * Pi * i / n, theta = 2.0 * Pi * j / m, radius = 2.0 + std::cos(theta);
    torus->Points.emplace_back(radius * std::cos(phi), radius * std::sin(phi), std::sin(theta));
    torus->Triangles.push_back({ k, right, up + (i + 1) % n });
    torus->Triangles.push_back({ k, up + (i + 1) % n, up + i });
  }
  GlyphSurface surface(torus);
  bool isRight = true;
  for (const int degree : { 2, 4 })
  {
    Options options;
    options.Degree = degree;
    const Result result = DirectionField(*torus).Compute(options);
    const Glyphs glyphs = MakeGlyphs(surface, DirectionsOf(result));

    const double cover = glyphs.Point.size() * glyphs.Spacing * glyphs.Spacing / (8.0 * Pi * Pi);
    std::printf("%zu glyphs of %d arms, N s^2 / A = %.2f\n", glyphs.Point.size(), degree, cover);
    isRight = isRight && cover > 1.0 / Pi && cover < 2.0 / std::sqrt(3.0);
    // The arms of a glyph are evenly turned unit vectors: they sum up to zero.
    for (std::size_t g = 0; g < glyphs.Point.size(); ++g)
    {
      Vector3 sum = Vector3::Zero();
      for (int k = 0; k < degree; ++k)
      {
        sum += glyphs.Direction[g * degree + k];
      }
      isRight = isRight && sum.norm() < 1e-9;
    }
  }
  return isRight && surface.GetNumberOfSamplings() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
