// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Dislocations/SizedRows.h"

#include "Dislocations/RowSearch.h"
#include "Improvement/FaceSmoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace DirectionFields::Internal
{
namespace
{
/// How often rows are searched for, and how often in a row without more edges as wanted.
constexpr int MostRounds = 20;
constexpr int MostInVain = 3;
/// How often a round leaves out the rows beside bad faces and tries again.
constexpr int MostTrials = 12;
/// The rows of a round crowd the ones beside them until vertices have moved this often.
constexpr int Steps = 30;
/// Rows are left out beside which faces would have a scaled Jacobian below this.
constexpr double LeastQuality = 0.35;

/// The middles of bad faces.
std::vector<Vector3> BadPlaces(const FaceMesh& mesh)
{
  std::vector<Vector3> places;
  for (const Faces::Face& face : mesh.Cells.Corners)
  {
    if (!(ScaledJacobian(mesh.Points, face) >= LeastQuality))
    {
      places.push_back(MiddleOf(mesh.Points, face));
    }
  }
  return places;
}

void Smooth(FaceMesh& mesh, const RowsDomain& domain, const Progress& progress)
{
  const std::vector<double> wanted = domain.LengthsAt(mesh.Points);
  const VertexStars stars(mesh.Cells, static_cast<Index>(mesh.Points.size()), mesh.LineEdges);
  SmoothingDomain smoothing{ domain.Surface, domain.Lines, {}, wanted, 0.0, false,
    domain.PatchesOf(mesh) };
  for (const FaceMesh::Vertex& vertex : mesh.Vertices)
  {
    smoothing.Line.push_back(vertex.Line);
  }
  MovableFaces movable(stars, smoothing, mesh.Points);
  RelaxFaces(movable, Steps, progress.Part(0.0, 0.7));
  ImproveFaces(movable, progress.Part(0.7, 1.0));
}

/// The edits that no bad face of the mesh after them is closest to: unless there was one closer
/// already.
std::vector<RowEdit> WithoutBlame(const std::vector<RowEdit>& edits, const EdgeLoops& chains,
  const FaceMesh& before, const FaceMesh& after)
{
  const std::vector<Vector3> bad = BadPlaces(after);
  if (bad.empty())
  {
    return edits;
  }
  std::vector<ClosestPoints::Corners> places;
  std::vector<std::size_t> causes;
  for (const Vector3& place : BadPlaces(before))
  {
    places.push_back({ place, place, place });
    causes.push_back(edits.size());
  }
  for (std::size_t k = 0; k < edits.size(); ++k)
  {
    for (const Index h : edits[k].HalfEdges)
    {
      const Vector3& head = before.Points[chains.Head(h)];
      places.push_back({ before.Points[chains.Tail(h)], head, head });
      causes.push_back(k);
    }
  }
  const ClosestPoints closest(places);
  std::vector<char> isToBlame(edits.size() + 1, 0);
  for (const Vector3& place : bad)
  {
    const Index nearest = closest.Find(place).Triangle;
    // A place that is no number has none.
    isToBlame[nearest == None ? edits.size() : causes[nearest]] = 1;
  }
  std::vector<RowEdit> left;
  for (std::size_t k = 0; k < edits.size(); ++k)
  {
    if (isToBlame[k] == 0)
    {
      left.push_back(edits[k]);
    }
  }
  return left;
}

/// Puts rows in and takes rows out, as many as leave good faces. Returns whether there were any.
bool DoRound(FaceMesh& mesh, const RowsDomain& domain, const Progress& progress)
{
  const EdgeLoops chains(mesh);
  std::vector<RowEdit> edits = FindRows(mesh, chains, domain.LengthsAt(mesh.Points));
  for (int trials = 0; trials < MostTrials && !edits.empty(); ++trials)
  {
    FaceMesh trial = mesh;
    Apply(edits, chains, trial);
    Smooth(trial, domain, progress);
    std::vector<RowEdit> left = WithoutBlame(edits, chains, mesh, trial);
    if (left.size() == edits.size())
    {
      mesh = std::move(trial);
      return true;
    }
    edits = std::move(left);
  }
  return false;
}
}

bool AddSizedRows(FaceMesh& mesh, const RowsDomain& domain, const Progress& progress)
{
  double most = EdgesAsWanted(mesh.Points, mesh.Cells, domain.LengthsAt(mesh.Points));
  FaceMesh current = mesh;
  bool isBetter = false;
  int inVain = 0;
  for (int round = 0; round < MostRounds && inVain < MostInVain; ++round)
  {
    const Progress part =
      progress.Part(static_cast<double>(round) / MostRounds, (round + 1.0) / MostRounds);
    if (!DoRound(current, domain, part))
    {
      break;
    }
    const double share =
      EdgesAsWanted(current.Points, current.Cells, domain.LengthsAt(current.Points));
    ++inVain;
    if (share > most)
    {
      most = share;
      mesh = current;
      isBetter = true;
      inVain = 0;
    }
  }
  return isBetter;
}
}
