// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Remeshes a torus, given as triangles, to quads along its smoothest field, writes them as torus.obj,
// and checks two things that are known of any such mesh: V - E + F = 0, and that the points lie on
// the torus, up to the height of its triangles.

#include <DirectionFields/Remesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>

using namespace DirectionFields;

int main()
{
  constexpr int around = 120;
  constexpr int across = 60;
  auto torus = std::make_shared<Surface>();
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * Pi * i / around;
      const double v = 2.0 * Pi * j / across;
      const double radius = 1.0 + 0.4 * std::cos(v);
      torus->Points.emplace_back(radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v));
      const auto at = [](int k, int l) { return k % around * across + l % across; };
      torus->Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      torus->Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  RemeshOptions options;
  options.NumberOfFaces = 1000;
  options.PureQuads = true;
  const RemeshResult mesh = Remesh(torus).Compute(options);
  std::ofstream file("torus.obj");
  double farthest = 0.0;
  for (const Vector3& p : mesh.Points)
  {
    const double fromAxis = std::hypot(p.x(), p.y());
    farthest = std::max(farthest, std::abs(std::hypot(fromAxis - 1.0, p.z()) - 0.4));
    file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (const std::array<Index, 4>& f : mesh.Faces)
  {
    file << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << ' ' << f[3] + 1 << '\n';
  }
  // Every edge has two faces, and every face has four edges: E = 2 F.
  const bool isTorus = mesh.Triangles == 0 && mesh.Points.size() == mesh.Faces.size();
  const bool isNear = farthest < 2e-3;
  std::printf("%s quads, %s the torus\n", isTorus ? "V = F: only" : "Not only",
    isNear ? "all on" : "some far from");
  return isTorus && isNear && file ? EXIT_SUCCESS : EXIT_FAILURE;
}
