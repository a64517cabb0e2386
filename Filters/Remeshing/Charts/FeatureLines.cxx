// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/FeatureLines.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
namespace
{
/// Calls visit(h, reversed) for the edges at a vertex counter-clockwise, each with one of its
/// half-edges, and whether that one runs towards the vertex, as for the last edge of a boundary
/// vertex.
template <typename Visit>
void ForEdgesAt(const TriangleMesh& mesh, Index vertex, const Visit& visit)
{
  const Index first = mesh.Outgoing(vertex);
  Index h = first;
  do
  {
    visit(h, false);
    const Index next = mesh.NextOutgoing(h);
    if (next == None)
    {
      visit(TriangleMesh::Previous(h), true);
    }
    h = next;
  } while (h != None && h != first);
}

/// How many edges at a vertex are features.
int FeatureValence(const TriangleMesh& mesh, const std::vector<char>& isFeature, Index vertex)
{
  int valence = 0;
  ForEdgesAt(mesh, vertex, [&](Index h, bool) { valence += isFeature[mesh.Edge(h)] != 0 ? 1 : 0; });
  return valence;
}

std::vector<int> FeatureValences(const TriangleMesh& mesh, const std::vector<char>& isFeature)
{
  std::vector<int> valence(mesh.GetNumberOfVertices());
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    valence[v] = FeatureValence(mesh, isFeature, v);
  }
  return valence;
}

std::vector<char> WithBoundary(const TriangleMesh& mesh, const std::vector<char>& isFeature)
{
  std::vector<char> features = isFeature;
  features.resize(mesh.GetNumberOfEdges(), 0);
  for (Index e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (mesh.Twin(mesh.HalfEdge(e)) == None)
    {
      features[e] = 1;
    }
  }
  return features;
}

/// Whether two features at an interior vertex are opposite, to the nearest multiple of 2 pi / n.
/// Angles are the surface's, not scaled.
bool GoesStraight(
  const IntrinsicGeometry& geometry, int degree, const std::vector<char>& isFeature, Index vertex)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::array<double, 2> sector{ 0.0, 0.0 };
  int side = 0;
  ForEdgesAt(mesh, vertex,
    [&](Index h, bool)
    {
      side = isFeature[mesh.Edge(h)] != 0 ? 1 - side : side;
      sector[side] += geometry.Transport.CornerAngle(mesh, h) / geometry.Transport.Scale[vertex];
    });
  const auto isStraight = [&](double angle)
  { return std::lround(angle * degree / (2.0 * Pi)) == degree / 2; };
  return isStraight(sector[0]) && isStraight(sector[1]);
}

/// The directions along a chain, one step after the other, in a frame that is carried along.
struct LiftedDirections
{
  /// In units of 2 pi / n.
  std::vector<double> Direction;
  std::vector<double> Length;
  /// The turn of the frame where the step has its axis, in units of 2 pi / n.
  std::vector<int> Turned;
};

/// The means over a window of the steps' lengths, rounded.
std::vector<int> RoundedMeans(const LiftedDirections& lifted, double window)
{
  const std::size_t count = lifted.Direction.size();
  std::vector<double> end(count + 1, 0.0);
  std::vector<double> integral(count + 1, 0.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    end[i + 1] = end[i] + lifted.Length[i];
    integral[i + 1] = integral[i] + lifted.Length[i] * lifted.Direction[i];
  }
  std::vector<int> rounded(count);
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double middle = 0.5 * (end[i] + end[i + 1]);
    // A window that is the same to both sides keeps corners where they are.
    const double half = std::min({ 0.5 * window, middle, end[count] - middle });
    const auto at = [&](double place, std::size_t& step)
    {
      while (step + 1 < count && end[step + 1] < place)
      {
        ++step;
      }
      return integral[step] + (place - end[step]) * lifted.Direction[step];
    };
    while (first > 0 && end[first] > middle - half)
    {
      --first;
    }
    while (last > 0 && end[last] > middle + half)
    {
      --last;
    }
    const double sum = at(middle + half, last) - at(middle - half, first);
    const double mean = half > 0.25 * lifted.Length[i] ? sum / (2.0 * half) : lifted.Direction[i];
    rounded[i] = static_cast<int>(std::lround(mean));
  }
  return rounded;
}

/// Runs of equal values that are shorter than a length take the value of the longer neighbour.
void AbsorbShortRuns(const std::vector<double>& length, double shortest, std::vector<int>& value)
{
  struct Run
  {
    std::size_t End;
    double Length;
    int Value;
  };
  std::vector<Run> runs;
  for (std::size_t i = 0; i < value.size(); ++i)
  {
    if (runs.empty() || runs.back().Value != value[i])
    {
      runs.push_back({ i, 0.0, value[i] });
    }
    runs.back().End = i + 1;
    runs.back().Length += length[i];
  }
  for (std::size_t r = 0; runs.size() > 1 && r < runs.size(); ++r)
  {
    if (runs[r].Length < shortest)
    {
      const double before = r > 0 ? runs[r - 1].Length : -1.0;
      const double after = r + 1 < runs.size() ? runs[r + 1].Length : -1.0;
      runs[r].Value = before >= after ? runs[r - 1].Value : runs[r + 1].Value;
    }
  }
  std::size_t i = 0;
  for (const Run& run : runs)
  {
    for (; i < run.End; ++i)
    {
      value[i] = run.Value;
    }
  }
}
}

std::vector<char> FramelessVertices(
  const IntrinsicGeometry& geometry, int degree, const std::vector<char>& isFeature)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const std::vector<char> features = WithBoundary(mesh, isFeature);
  std::vector<char> isFrameless(mesh.GetNumberOfVertices(), 0);
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    UpdateFrameless(geometry, degree, component, features, isFrameless);
  }
  return isFrameless;
}

void UpdateFrameless(const IntrinsicGeometry& geometry, int degree,
  const TriangleMesh::Component& component, const std::vector<char>& isFeature,
  std::vector<char>& isFrameless)
{
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    const int valence =
      geometry.Mesh.IsBoundary(v) ? 0 : FeatureValence(geometry.Mesh, isFeature, v);
    isFrameless[v] =
      valence > 2 || (valence == 2 && !GoesStraight(geometry, degree, isFeature, v)) ? 1 : 0;
  }
}

FeatureLines::FeatureLines(const IntrinsicGeometry& geometry, const FieldMatching& matching,
  const std::vector<char>& isFeature, const std::vector<char>& isFrameless,
  const std::vector<double>& window, const std::vector<char>& isCorner)
  : IsFeature(WithBoundary(geometry.Mesh, isFeature))
  , Line(geometry.Mesh.GetNumberOfEdges(), 0)
  , Axis(geometry.Mesh.GetNumberOfEdges(), 0)
  , Base(geometry.Mesh.GetNumberOfEdges(), None)
{
  this->FindChains(geometry.Mesh, isFrameless, isCorner);
  this->FindAxes(geometry, matching, isFrameless, window);
}

void FeatureLines::FindChains(
  const TriangleMesh& mesh, const std::vector<char>& isFrameless, const std::vector<char>& isCorner)
{
  const std::vector<int> valence = FeatureValences(mesh, this->IsFeature);
  std::vector<char> isSeen(mesh.GetNumberOfEdges(), 0);
  const auto isEnd = [&](Index v)
  { return valence[v] != 2 || isFrameless[v] != 0 || (!isCorner.empty() && isCorner[v] != 0); };
  const auto follow = [&](Step step)
  {
    Chain chain;
    const Index start = Start(mesh, step);
    while (true)
    {
      isSeen[mesh.Edge(step.HalfEdge)] = 1;
      this->Line[mesh.Edge(step.HalfEdge)] = static_cast<Index>(this->Chains.size()) + 1;
      chain.Steps.push_back(step);
      const Index v = End(mesh, step);
      chain.IsClosed = v == start && !isEnd(v);
      if (isEnd(v) || v == start)
      {
        break;
      }
      Step next{ None, false };
      ForEdgesAt(mesh, v,
        [&](Index h, bool isReversed)
        {
          if (this->IsFeature[mesh.Edge(h)] != 0 && isSeen[mesh.Edge(h)] == 0)
          {
            next = { h, isReversed };
          }
        });
      if (next.HalfEdge == None)
      {
        break;
      }
      step = next;
    }
    this->Chains.push_back(std::move(chain));
  };
  const auto followAllAt = [&](Index v)
  {
    ForEdgesAt(mesh, v,
      [&](Index h, bool isReversed)
      {
        if (this->IsFeature[mesh.Edge(h)] != 0 && isSeen[mesh.Edge(h)] == 0)
        {
          follow({ h, isReversed });
        }
      });
  };
  for (const bool atEnds : { true, false })
  {
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (valence[v] > 0 && isEnd(v) == atEnds)
      {
        followAllAt(v);
      }
    }
  }
}

void FeatureLines::FindAxes(const IntrinsicGeometry& geometry, const FieldMatching& matching,
  const std::vector<char>& isFrameless, const std::vector<double>& window)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const int degree = matching.Degree;
  std::vector<Index> component(mesh.GetNumberOfVertices(), 0);
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& part = mesh.GetComponents()[c];
    std::fill(component.begin() + part.FirstVertex, component.begin() + part.EndVertex,
      static_cast<Index>(c));
  }
  for (const Chain& chain : this->Chains)
  {
    const Index c = component[Start(mesh, chain.Steps.front())];
    LiftedDirections lifted;
    int turned = 0;
    // A closed chain is walked three times, so that the window is complete all around.
    const std::size_t count = chain.Steps.size();
    const std::size_t rounds = chain.IsClosed ? 3 : 1;
    for (std::size_t i = 0; i < rounds * count; ++i)
    {
      const Step& step = chain.Steps[i % count];
      const Index h = step.HalfEdge;
      const int turn =
        step.IsReversed ? -matching.MatchingAlong(mesh, h) : matching.MatchingAlong(mesh, h);
      const double half = 0.5 * matching.RemainderAlong(mesh, h);
      const bool hasFrame = isFrameless[Start(mesh, step)] == 0;
      // The angle in the chart of the step's start, else in that of its end.
      double angle = hasFrame != step.IsReversed ? matching.AngleAtTail(geometry, h) - half
                                                 : matching.AngleAtHead(geometry, h) + half;
      angle += step.IsReversed ? Pi : 0.0;
      double direction = angle * degree / (2.0 * Pi) + turned;
      if (!lifted.Direction.empty())
      {
        direction -= degree * std::nearbyint((direction - lifted.Direction.back()) / degree);
      }
      lifted.Direction.push_back(direction);
      lifted.Length.push_back(
        std::sqrt(geometry.Lengths.SquaredLength[mesh.Edge(h)]) * geometry.Lengths.Unit[c]);
      lifted.Turned.push_back(turned);
      turned += hasFrame ? turn : 0;
    }
    std::vector<int> rounded = RoundedMeans(lifted, window[c]);
    AbsorbShortRuns(lifted.Length, 0.5 * window[c], rounded);
    const std::size_t offset = chain.IsClosed ? count : 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Step& step = chain.Steps[i];
      const Index e = mesh.Edge(step.HalfEdge);
      const Index h = mesh.HalfEdge(e);
      this->Base[e] = isFrameless[Start(mesh, step)] == 0 ? Start(mesh, step) : End(mesh, step);
      const bool isAgainst = (h == step.HalfEdge) == step.IsReversed;
      const int axis =
        rounded[offset + i] - lifted.Turned[offset + i] + (isAgainst ? degree / 2 : 0);
      this->Axis[e] = ((axis % degree) + degree) % degree;
    }
  }
}
}
