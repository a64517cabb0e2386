// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/DistributedMesh.h"

#include "Mesh/CoveredPiece.h"
#include "Mesh/JoinedComponents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace DirectionFields::Parallel
{
namespace
{
constexpr const char* CannotBeOriented = "it has only one side, as a Moebius strip has";

/// Whether a point of the piece belongs to one of its own triangles.
bool IsInPiece(const PieceWithSurroundings& piece, Index point)
{
  return point < piece.InputPoints && piece.Number[point] >= 0;
}
}

DistributedMesh::DistributedMesh(Processes& processes, const Messages& messages,
  const PieceWithSurroundings& piece, const SharedPoints& shared)
  : All(messages)
{
  std::string fault;
  processes.Together(
    [&]
    {
      this->Geometry = std::make_unique<SurfaceGeometry>(piece.Surface);
      fault = this->FindFaults(piece);
    });
  if (!messages.Any(!fault.empty()))
  {
    const Repairs& repairs = this->GetMesh().GetRepairs();
    this->WoundOtherwise =
      messages.Any(repairs.ReversedTriangles > 0 || repairs.NonOrientableComponents > 0);
    fault = this->WoundOtherwise ? CannotBeOriented : "";
  }
  // The first process with a fault speaks.
  const Messages::Collected<char> faults =
    messages.AllGather(std::vector<char>(fault.begin(), fault.end()));
  for (std::size_t p = 0; p + 1 < faults.First.size() && this->Reason.empty(); ++p)
  {
    this->Reason.assign(
      faults.Values.begin() + faults.First[p], faults.Values.begin() + faults.First[p + 1]);
  }
  if (!this->Reason.empty())
  {
    return;
  }
  processes.Together([&] { this->FindOwned(piece, shared); });
  this->FindExchange(processes, piece, shared);
  this->JoinComponents(processes, piece, shared);
  this->FindCovers(processes, piece);
  if (messages.Any(this->Disagrees(piece)))
  {
    this->Reason = "its pieces do not agree on what is around the points that they share";
  }
  const std::vector<double> meanEdges = this->MeanEdges(processes, piece);
  if (this->Reason.empty() && messages.Any(this->HasDoubtfulEdges(meanEdges)))
  {
    this->Reason =
      "some of its edges are so short that only the whole tells which triangles have no area";
  }
  for (int component = 0; component < this->Components; ++component)
  {
    for (const std::size_t c : this->Parts[component])
    {
      if (this->ProcessOf(component) < 0)
      {
        this->Geometry->Lengths.SetUnit(
          this->GetMesh(), static_cast<Index>(c), meanEdges[component]);
      }
    }
  }
}

std::string DistributedMesh::FindFaults(const PieceWithSurroundings& piece) const
{
  const TriangleMesh& mesh = this->GetMesh();
  const Repairs& repairs = mesh.GetRepairs();
  if (repairs.NonManifoldEdges > 0 || repairs.DuplicateTriangles > 0)
  {
    return "some of its edges have more than two triangles";
  }
  std::vector<char> isUsed(piece.Number.size(), 0);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index point = mesh.Point(v);
    if (!mesh.IsFrontVertex(v))
    {
      continue;
    }
    if (isUsed[point] && IsInPiece(piece, point))
    {
      return "several sheets of it meet in a point";
    }
    isUsed[point] = 1;
  }
  if (this->HasChangedEdgesNearGhosts(piece))
  {
    return "triangles without area lie where its pieces meet";
  }
  return {};
}

bool DistributedMesh::HasChangedEdgesNearGhosts(const PieceWithSurroundings& piece) const
{
  const SurfaceGeometry& geometry = *this->Geometry;
  const TriangleMesh& mesh = geometry.Mesh;
  if (geometry.Lengths.DegenerateTriangles == 0)
  {
    return false;
  }
  constexpr double rounding = 1e-9;
  std::vector<Index> fan;
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    for (Index e = component.FirstEdge; e < component.EndEdge; ++e)
    {
      const Index h = mesh.HalfEdge(e);
      const double length =
        (geometry.Positions[mesh.Head(h)] - geometry.Positions[mesh.Tail(h)]).norm();
      const double used = std::sqrt(geometry.Lengths.SquaredLength[e]) * geometry.Lengths.Unit[c];
      if (std::abs(used - length) <= rounding * used)
      {
        continue;
      }
      for (const Index end : { mesh.Tail(h), mesh.Head(h) })
      {
        mesh.GetFan(end, fan);
        for (const Index k : fan)
        {
          if (piece.Surface.Ghost[mesh.InputTriangle(k / 3)] != 0)
          {
            return true;
          }
        }
      }
    }
  }
  return false;
}

void DistributedMesh::FindOwned(const PieceWithSurroundings& piece, const SharedPoints& shared)
{
  const TriangleMesh& mesh = this->GetMesh();
  const int own = this->All.Own();
  this->Owned.assign(static_cast<std::size_t>(mesh.GetNumberOfVertices()), 0);
  this->VertexOfPoint.assign(piece.Number.size(), None);
  for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Index point = mesh.Point(v);
    this->VertexOfPoint[point] = v;
    this->Owned[v] = piece.Number[point] >= shared.FirstNumber[own] &&
      piece.Number[point] < shared.FirstNumber[own + 1];
  }
}

void DistributedMesh::FindExchange(
  Processes& processes, const PieceWithSurroundings& piece, const SharedPoints& shared)
{
  const TriangleMesh& mesh = this->GetMesh();
  std::vector<char> matters;
  processes.Together(
    [&]
    {
      matters.assign(this->Owned.size(), 0);
      for (Index h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
      {
        const Index tail = mesh.Tail(h);
        const Index head = mesh.Head(h);
        matters[head] |= IsInPiece(piece, mesh.Point(tail)) ? 1 : 0;
        matters[tail] |= IsInPiece(piece, mesh.Point(head)) ? 1 : 0;
      }
    });
  this->AllTravellers = this->FindTravellers(processes, piece, shared, matters);
  // At the rim of the surroundings triangles are missing.
  std::vector<std::array<double, 3>> normals;
  processes.Together(
    [&]
    {
      for (char& one : matters)
      {
        one = one ? 0 : 1;
      }
      normals.resize(matters.size());
      for (std::size_t v = 0; v < normals.size(); ++v)
      {
        std::copy_n(this->Geometry->Frames.Normal[v].data(), 3, normals[v].data());
      }
    });
  Exchange(this->All, normals, this->FindTravellers(processes, piece, shared, matters));
  for (std::size_t v = 0; v < normals.size(); ++v)
  {
    this->Geometry->Frames.Normal[v] = Vector3(normals[v].data());
  }
}

DistributedMesh::Travellers DistributedMesh::FindTravellers(Processes& processes,
  const PieceWithSurroundings& piece, const SharedPoints& shared,
  const std::vector<char>& matters) const
{
  const TriangleMesh& mesh = this->GetMesh();
  const auto processCount = static_cast<std::size_t>(this->All.Count());
  std::vector<std::vector<vtkIdType>> wanted(processCount);
  Travellers travellers;
  travellers.Received.resize(processCount);
  processes.Together(
    [&]
    {
      for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        if (matters[v] && !this->Owned[v])
        {
          const vtkIdType number = piece.Number[mesh.Point(v)];
          const int owner = shared.OwnerOf(number);
          wanted[owner].push_back(number);
          travellers.Received[owner].push_back(v);
        }
      }
    });
  const std::vector<std::vector<vtkIdType>> asked = this->All.Exchange(wanted);
  processes.Together(
    [&]
    {
      std::unordered_map<vtkIdType, Index> ownVertex;
      for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        if (this->Owned[v])
        {
          ownVertex.emplace(piece.Number[mesh.Point(v)], v);
        }
      }
      travellers.Sent.resize(asked.size());
      for (std::size_t p = 0; p < asked.size(); ++p)
      {
        for (const vtkIdType number : asked[p])
        {
          travellers.Sent[p].push_back(ownVertex.at(number));
        }
      }
    });
  return travellers;
}

void DistributedMesh::CompleteBytes(char* values, std::size_t size) const
{
  const Travellers& travellers = this->AllTravellers;
  std::vector<std::vector<char>> sent;
  this->All.Together(
    [&]
    {
      for (const std::vector<Index>& vertices : travellers.Sent)
      {
        std::vector<char>& own = sent.emplace_back();
        for (const Index vertex : vertices)
        {
          const char* const value = values + static_cast<std::size_t>(vertex) * size;
          own.insert(own.end(), value, value + size);
        }
      }
    });
  const std::vector<std::vector<char>> received = this->All.Exchange(sent);
  for (std::size_t p = 0; p < received.size(); ++p)
  {
    const char* value = received[p].data();
    for (const Index vertex : travellers.Received[p])
    {
      std::copy_n(value, size, values + static_cast<std::size_t>(vertex) * size);
      value += size;
    }
  }
}

void DistributedMesh::JoinComponents(
  Processes& processes, const PieceWithSurroundings& piece, const SharedPoints& shared)
{
  const std::vector<TriangleMesh::Component>& parts = this->GetMesh().GetComponents();
  std::vector<vtkIdType> first;
  std::vector<int> partOf;
  processes.Together(
    [&]
    {
      partOf.resize(this->Owned.size());
      first = FirstTriangles(this->GetMesh(), piece);
      for (std::size_t c = 0; c < parts.size(); ++c)
      {
        std::fill(partOf.begin() + parts[c].FirstVertex, partOf.begin() + parts[c].EndVertex,
          static_cast<int>(c));
      }
    });
  const Messages::Collected<vtkIdType> all = this->All.AllGather(first);
  const int begin = all.First[this->All.Own()];
  std::vector<int> own;
  processes.Together(
    [&]
    {
      for (const vtkIdType point : shared.OwnBorder)
      {
        const Index vertex = this->VertexOfPoint[point];
        own.push_back(vertex == None ? -1 : begin + partOf[vertex]);
      }
    });
  const std::vector<int> partsOfBorder = this->All.AllGather(own).Values;
  std::vector<int> components;
  processes.Together(
    [&] { components = JoinedComponents(all.Values, partsOfBorder, shared.BorderNumber); });
  this->Components =
    components.empty() ? 0 : 1 + *std::max_element(components.begin(), components.end());
  this->ProcessOfComponent = OnlyProcesses(components, all.First, this->Components);
  this->Parts.resize(static_cast<std::size_t>(this->Components));
  for (std::size_t c = 0; c < parts.size(); ++c)
  {
    const int component = components[static_cast<std::size_t>(begin) + c];
    this->ComponentOfPart.push_back(component);
    if (component >= 0)
    {
      this->Parts[component].push_back(c);
    }
  }
  processes.Together([&] { this->FindTravellersOfComponents(partOf); });
}

void DistributedMesh::FindTravellersOfComponents(const std::vector<int>& partOf)
{
  this->TravellersOf.resize(static_cast<std::size_t>(this->Components));
  for (int component = 0; component < this->Components; ++component)
  {
    if (this->ProcessOf(component) < 0)
    {
      this->TravellersOf[component].Sent.resize(this->AllTravellers.Sent.size());
      this->TravellersOf[component].Received.resize(this->AllTravellers.Sent.size());
    }
  }
  const auto share = [&](const std::vector<std::vector<Index>>& all,
                       std::vector<std::vector<Index>> Travellers::*list)
  {
    for (std::size_t p = 0; p < all.size(); ++p)
    {
      for (const Index vertex : all[p])
      {
        const int component = this->ComponentOfPart[partOf[vertex]];
        if (component >= 0 && this->ProcessOf(component) < 0)
        {
          (this->TravellersOf[component].*list)[p].push_back(vertex);
        }
      }
    }
  };
  share(this->AllTravellers.Sent, &Travellers::Sent);
  share(this->AllTravellers.Received, &Travellers::Received);
}

void DistributedMesh::FindCovers(Processes& processes, const PieceWithSurroundings& piece)
{
  this->FrontPoints = piece.FrontPoints;
  std::vector<double> covers;
  processes.Together(
    [&]
    {
      covers.assign(static_cast<std::size_t>(this->Components), 0.0);
      if (piece.FrontPoints > 0)
      {
        this->VertexBehind = VerticesBehind(this->GetMesh(), piece);
      }
      for (int c = 0; c < this->Components && piece.FrontPoints > 0; ++c)
      {
        for (const std::size_t k : this->Parts[c])
        {
          const TriangleMesh::Component& part = this->GetMesh().GetComponents()[k];
          const auto first = this->VertexBehind.begin();
          covers[c] += std::any_of(first + part.FirstVertex, first + part.EndVertex,
            [](Index behind) { return behind != None; });
        }
      }
      this->Covers.resize(covers.size());
    });
  this->All.Largest(covers.data(), this->Components);
  for (int component = 0; component < this->Components; ++component)
  {
    this->Covers[component] = covers[component] > 0.0 ? 1 : 0;
    if (this->IsCover(component))
    {
      this->ProcessOfComponent[component] = -1;
      // Without any vertices of others where it lies on one process.
      this->TravellersOf[component].Sent.resize(this->AllTravellers.Sent.size());
      this->TravellersOf[component].Received.resize(this->AllTravellers.Sent.size());
    }
  }
}

double DistributedMesh::LengthOf(Index edge) const
{
  const TriangleMesh& mesh = this->GetMesh();
  const Index h = mesh.HalfEdge(edge);
  const std::vector<Vector3>& positions = this->Geometry->Positions;
  return (positions[mesh.Head(h)] - positions[mesh.Tail(h)]).stableNorm();
}

std::vector<double> DistributedMesh::MeanEdges(
  Processes& processes, const PieceWithSurroundings& piece) const
{
  const TriangleMesh& mesh = this->GetMesh();
  // Of the edges of each component the sum of the lengths and the number: each counts where its end
  // of the lower number is owned, as all edges at that end are known there.
  std::vector<double> sums;
  processes.Together([&] { sums.assign(2 * static_cast<std::size_t>(this->Components), 0.0); });
  for (int component = 0; component < this->Components; ++component)
  {
    for (const std::size_t c : this->Parts[component])
    {
      const TriangleMesh::Component& part = mesh.GetComponents()[c];
      for (Index e = part.FirstEdge; e < part.EndEdge; ++e)
      {
        const Index tail = mesh.Tail(mesh.HalfEdge(e));
        const Index head = mesh.Head(mesh.HalfEdge(e));
        const bool isTailFirst = piece.Number[mesh.Point(tail)] < piece.Number[mesh.Point(head)];
        if (this->IsOwned(isTailFirst ? tail : head))
        {
          sums[2 * component] += this->LengthOf(e);
          sums[2 * component + 1] += 1.0;
        }
      }
    }
  }
  this->All.Sum(sums.data(), static_cast<int>(sums.size()));
  std::vector<double> means;
  for (std::size_t k = 0; k < sums.size(); k += 2)
  {
    // Where all points coincide every edge counts as 1, as in Metric.
    means.push_back(sums[k] > 0.0 ? sums[k] / std::max(1.0, sums[k + 1]) : 1.0);
  }
  return means;
}

bool DistributedMesh::HasDoubtfulEdges(const std::vector<double>& meanEdges) const
{
  // Metric lengthens edges that are shorter than a part of the mean.
  constexpr double shortest = 1e-9;
  for (int component = 0; component < this->Components; ++component)
  {
    const double mean = meanEdges[component];
    for (const std::size_t c : this->Parts[component])
    {
      const double here = this->Geometry->Lengths.Unit[c];
      const TriangleMesh::Component& part = this->GetMesh().GetComponents()[c];
      for (Index e = part.FirstEdge; e < part.EndEdge && this->ProcessOf(component) < 0; ++e)
      {
        const double length = this->LengthOf(e);
        if ((length < shortest * here) != (length < shortest * mean))
        {
          return true;
        }
      }
    }
  }
  return false;
}

bool DistributedMesh::Disagrees(const PieceWithSurroundings& piece) const
{
  // The reference edge and the number of triangles at each vertex.
  const TriangleMesh& mesh = this->GetMesh();
  std::vector<std::array<vtkIdType, 2>> own;
  std::vector<std::array<vtkIdType, 2>> owners;
  const auto describe = [&]
  {
    std::vector<Index> fan;
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      mesh.GetFan(v, fan);
      Index reference = fan.front();
      for (const Index h : fan)
      {
        reference = this->Geometry->Transport.EdgeAngle[h] == 0.0 ? h : reference;
      }
      own.push_back({ piece.Number[mesh.Point(mesh.Head(reference))],
        2 * static_cast<vtkIdType>(fan.size()) + (mesh.IsBoundary(v) ? 1 : 0) });
    }
    owners = own;
  };
  this->All.Together(describe);
  this->Complete(owners);
  return owners != own;
}
}
