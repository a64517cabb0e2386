// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Solver/PreviousPhase.h"

#include "Guidance/Guidance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace DirectionFields::Parallel
{
namespace
{
/// Sums over the owned vertices of a component.
struct Overlap
{
  double Real = 0.0;
  double Imaginary = 0.0;
  /// Of the moduli.
  double Size = 0.0;
  /// How many vertices something guides or constrains.
  double Guided = 0.0;
};

bool IsGuided(const DistributedGuide& guide, Index v)
{
  return (!guide.Drawn.empty() && guide.Drawn[v] != 0.0) ||
    (!guide.Kind.empty() && guide.Kind[v] != ConstraintKind::None);
}

std::vector<Overlap> AddUp(const Messages& messages, const DistributedMesh& mesh,
  const DistributedGuide& guide, const std::vector<Complex>& reference,
  const std::vector<Complex>& section)
{
  std::vector<double> sums(4 * static_cast<std::size_t>(mesh.CountComponents()), 0.0);
  for (int c = 0; c < mesh.CountComponents(); ++c)
  {
    Overlap sum;
    for (const std::size_t part : mesh.PartsOf(c))
    {
      const TriangleMesh::Component& range = mesh.GetMesh().GetComponents()[part];
      for (Index v = range.FirstVertex; v < range.EndVertex; ++v)
      {
        if (mesh.IsOwned(v))
        {
          const Complex product = std::conj(section[v]) * reference[v];
          sum.Real += product.real();
          sum.Imaginary += product.imag();
          sum.Size += std::abs(product);
          sum.Guided += IsGuided(guide, v) ? 1.0 : 0.0;
        }
      }
    }
    double* const values = sums.data() + 4 * static_cast<std::size_t>(c);
    values[0] = sum.Real;
    values[1] = sum.Imaginary;
    values[2] = sum.Size;
    values[3] = sum.Guided;
  }
  messages.Sum(sums.data(), static_cast<int>(sums.size()));
  std::vector<Overlap> all;
  for (std::size_t k = 0; k < sums.size(); k += 4)
  {
    all.push_back({ sums[k], sums[k + 1], sums[k + 2], sums[k + 3] });
  }
  return all;
}
}

void FollowPrevious(Processes& processes, const Messages& messages, const DistributedMesh& mesh,
  const PieceWithSurroundings& piece, const DistributedGuide& guide, std::vector<Vector3> previous,
  int degree, std::vector<Complex>& section)
{
  const bool isThere = previous.size() == static_cast<std::size_t>(piece.InputPoints);
  if (messages.Any(!piece.InputTriangle.empty() && !isThere))
  {
    return;
  }
  Guidance directions;
  directions.Vectors = isThere ? std::move(previous) : std::vector<Vector3>();
  // Vectors of the same length must count alike on all processes.
  GuidanceScale scale = ScaleOf(directions);
  scale.Longest = messages.Largest(scale.Longest);
  std::vector<Complex> reference;
  processes.Together(
    [&]
    {
      directions.Vectors.resize(piece.Number.size(), Vector3::Zero());
      reference = GuidanceSection(mesh.GetGeometry(), directions, degree, scale);
    });
  const std::vector<Overlap> overlaps = AddUp(messages, mesh, guide, reference, section);
  for (int c = 0; c < mesh.CountComponents(); ++c)
  {
    const Overlap& overlap = overlaps[c];
    Complex sum(overlap.Real, overlap.Imaginary);
    // As for one process: nothing is done where the two have nothing in common.
    if (overlap.Guided > 0.0 || std::abs(sum) <= 1e-3 * overlap.Size)
    {
      continue;
    }
    if (mesh.IsCover(c))
    {
      sum = sum.real() < 0.0 ? -1.0 : 1.0;
    }
    for (const std::size_t part : mesh.PartsOf(c))
    {
      const TriangleMesh::Component& range = mesh.GetMesh().GetComponents()[part];
      std::for_each(section.begin() + range.FirstVertex, section.begin() + range.EndVertex,
        [factor = sum / std::abs(sum)](Complex& value) { value *= factor; });
    }
  }
}
}
