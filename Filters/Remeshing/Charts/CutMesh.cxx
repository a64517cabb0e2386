// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Charts/CutMesh.h"

#include <algorithm>
#include <cmath>

namespace DirectionFields::Internal
{
SymbolicTransition SymbolicTransition::Composed(
  const SymbolicTransition& s, const SymbolicTransition& t, int degree)
{
  SymbolicTransition composed{ (s.Turn + t.Turn) % degree, s.Jumps };
  for (const Jump& jump : t.Jumps)
  {
    composed.Jumps.push_back({ jump.Variable, (jump.Turn + s.Turn) % degree });
  }
  composed.Simplify(degree);
  return composed;
}

SymbolicTransition SymbolicTransition::Inverse(int degree) const
{
  SymbolicTransition inverse{ (degree - this->Turn) % degree, this->Jumps };
  for (Jump& jump : inverse.Jumps)
  {
    jump.Turn = (jump.Turn + degree - this->Turn + degree / 2) % degree;
  }
  return inverse;
}

void SymbolicTransition::Simplify(int degree)
{
  if (this->Jumps.size() < 2)
  {
    return;
  }
  std::sort(this->Jumps.begin(), this->Jumps.end(),
    [](const Jump& a, const Jump& b)
    { return a.Variable != b.Variable ? a.Variable < b.Variable : a.Turn < b.Turn; });
  // zeta^k + zeta^(k + n / 2) = 0
  for (std::size_t i = 0; i < this->Jumps.size(); ++i)
  {
    for (std::size_t j = i + 1;
         j < this->Jumps.size() && this->Jumps[j].Variable == this->Jumps[i].Variable; ++j)
    {
      if (this->Jumps[j].Turn - this->Jumps[i].Turn == degree / 2)
      {
        this->Jumps.erase(this->Jumps.begin() + static_cast<std::ptrdiff_t>(j));
        this->Jumps.erase(this->Jumps.begin() + static_cast<std::ptrdiff_t>(i));
        i = static_cast<std::size_t>(-1);
        break;
      }
    }
  }
}

struct CutMesh::Builder
{
  const SurfaceGeometry& Geometry;
  const TriangleMesh& Mesh;
  const TriangleMesh::Component& Part;
  const FieldMatching& Matching;
  const FeatureLines& Features;
  const std::vector<char>& IsFrameless;
  const CutGraph& Graph;
  double Unit;
  CutMesh& Out;
  /// The half-edges of the component in the cut mesh.
  std::vector<Index> Image;

  Index Local(Index vertex) const { return vertex - this->Part.FirstVertex; }
  /// From the chart of the head of a half-edge to that of its tail.
  SymbolicTransition Along(Index h) const
  {
    SymbolicTransition t{ this->Matching.MatchingAlong(this->Mesh, h),
      this->Graph.At(this->Mesh.Edge(h)) };
    if (!this->Mesh.GivesDirection(h))
    {
      t.Turn = (this->Out.Degree - t.Turn) % this->Out.Degree;
      return t.Inverse(this->Out.Degree);
    }
    return t;
  }
  double Length(Index h) const
  {
    return std::sqrt(this->Geometry.Lengths.SquaredLength[this->Mesh.Edge(h)]) * this->Unit;
  }
  /// The target of a half-edge in the triangle's chart.
  Complex Target(Index h, const MapTriangle& t, int corner) const
  {
    const double length = this->Length(h);
    const double step = 2.0 * Pi / this->Out.Degree;
    if (this->IsFrameless[this->Mesh.Tail(h)] == 0)
    {
      const bool bothHave = this->IsFrameless[this->Mesh.Head(h)] == 0;
      const double half = bothHave ? 0.5 * this->Matching.RemainderAlong(this->Mesh, h) : 0.0;
      return std::polar(length,
        this->Matching.AngleAtTail(this->Geometry, h) - half + step * t.Corner[corner].Turn);
    }
    return std::polar(length,
      this->Matching.AngleAtHead(this->Geometry, h) + step * t.Corner[(corner + 1) % 3].Turn);
  }
  static double HalfCotangent(double angle)
  {
    const double tangent = std::tan(angle);
    return 0.5 * std::clamp(tangent != 0.0 ? 1.0 / tangent : 20.0, -20.0, 20.0);
  }

  /// A triangle whose corners all have frames: its chart is that of the first.
  void AddRegular(Index t)
  {
    MapTriangle& out = this->Out.Triangles[t - this->Part.FirstTriangle];
    out.Corner[1] = this->Along(3 * t);
    out.Corner[2] = this->Along(3 * t + 2).Inverse(this->Out.Degree);
    this->Fill(t, out);
  }
  void Fill(Index t, MapTriangle& out)
  {
    const std::array<double, 3> angles = this->Geometry.Lengths.CornerAngles(this->Mesh, t);
    for (int c = 0; c < 3; ++c)
    {
      const Index h = 3 * t + c;
      out.Vertex[c] = this->Local(this->Mesh.Tail(h));
      out.Target[c] = this->Target(h, out, c);
      out.Weight[c] = HalfCotangent(angles[(c + 2) % 3]);
      out.Feature[c] = this->Features.Line[this->Mesh.Edge(h)];
      this->Image[h - 3 * this->Part.FirstTriangle] = 3 * (t - this->Part.FirstTriangle) + c;
    }
  }

  /// The triangles around a vertex that has no frame. The chart of each is that of its next corner.
  void AddStar(Index vertex)
  {
    std::vector<Index> fan;
    this->Mesh.GetFan(vertex, fan);
    SymbolicTransition back;
    for (const Index h : fan)
    {
      MapTriangle& out = this->Out.Triangles[h / 3 - this->Part.FirstTriangle];
      const int c = h % 3;
      const SymbolicTransition ring = this->Along(TriangleMesh::Next(h));
      out.Corner[c] = back.Inverse(this->Out.Degree);
      out.Corner[(c + 1) % 3] = {};
      out.Corner[(c + 2) % 3] = ring;
      this->Fill(h / 3, out);
      back = SymbolicTransition::Composed(back, ring, this->Out.Degree);
    }
    this->Out.Cones.push_back({ this->Local(vertex), back });
    this->Out.ConeIndex[this->Local(vertex)] =
      back.Turn == 0 ? 0 : (back.Turn == 1 ? -1 : this->Out.Degree - back.Turn);
    this->Out.IsCorner[this->Local(vertex)] = 1;
  }

  /// Weights of the corners where the section vanishes within a triangle.
  std::array<double, 3> ZeroOf(Index t, const std::vector<Complex>& section) const
  {
    std::array<Complex, 3> value;
    double phase = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const Index h = 3 * t + c;
      value[c] = std::polar(std::abs(section[this->Mesh.Tail(h)]), phase);
      phase += this->Out.Degree * this->Matching.RemainderAlong(this->Mesh, h);
    }
    std::array<double, 3> weight;
    double sum = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      weight[c] = (std::conj(value[(c + 1) % 3]) * value[(c + 2) % 3]).imag();
      sum += weight[c];
    }
    double clamped = 0.0;
    for (double& w : weight)
    {
      w = sum != 0.0 && std::isfinite(w / sum) ? std::max(0.12, w / sum) : 1.0;
      clamped += w;
    }
    for (double& w : weight)
    {
      w /= clamped;
    }
    return weight;
  }

  /// A singular triangle becomes three around a new vertex.
  void AddCone(Index t, const std::vector<Complex>& section)
  {
    const std::array<double, 3> weight = this->ZeroOf(t, section);
    // The triangle laid flat, its first corner in the origin.
    const double area = this->Geometry.Lengths.Area[t];
    const std::array<double, 3> length = { this->Length(3 * t), this->Length(3 * t + 1),
      this->Length(3 * t + 2) };
    const double x =
      (length[0] * length[0] + length[2] * length[2] - length[1] * length[1]) / (2.0 * length[0]);
    const std::array<Complex, 3> flat = { 0.0, length[0],
      Complex(x, 2.0 * area * this->Unit * this->Unit / length[0]) };
    const Complex middle = weight[0] * flat[0] + weight[1] * flat[1] + weight[2] * flat[2];
    const Index cone = static_cast<Index>(this->Out.Positions.size());
    const Index own = t - this->Part.FirstTriangle;
    const auto extra = static_cast<Index>(this->Out.Triangles.size());
    const std::array<Index, 3> number = { own, extra, extra + 1 };
    this->Out.Triangles.resize(this->Out.Triangles.size() + 2);
    Vector3 position = Vector3::Zero();
    SymbolicTransition back;
    // Angles and lengths of the spokes, seen from the corners.
    std::array<Complex, 3> spoke;
    for (int c = 0; c < 3; ++c)
    {
      const Index h = 3 * t + c;
      const Index v = this->Mesh.Tail(h);
      const Complex away = middle - flat[c];
      const double inside = std::arg(away / (flat[(c + 1) % 3] - flat[c]));
      spoke[c] = std::polar(std::abs(away),
        this->Matching.AngleAtTail(this->Geometry, h) + this->Geometry.Transport.Scale[v] * inside);
      position += weight[c] * this->Geometry.Positions[v];
    }
    for (int c = 0; c < 3; ++c)
    {
      const Index h = 3 * t + c;
      const int next = (c + 1) % 3;
      MapTriangle& out = this->Out.Triangles[number[c]];
      const SymbolicTransition ring = this->Along(h);
      out.Vertex = { cone, this->Local(this->Mesh.Tail(h)), this->Local(this->Mesh.Head(h)) };
      out.Corner[0] = back.Inverse(this->Out.Degree);
      out.Corner[1] = {};
      out.Corner[2] = ring;
      const double half = 0.5 * this->Matching.RemainderAlong(this->Mesh, h);
      out.Target = { -spoke[c],
        std::polar(this->Length(h), this->Matching.AngleAtTail(this->Geometry, h) - half),
        spoke[next] * std::polar(1.0, 2.0 * Pi * ring.Turn / this->Out.Degree) };
      const auto angleAt = [](const Complex& p, const Complex& q, const Complex& r)
      { return std::abs(std::arg((r - p) / (q - p))); };
      out.Weight = { HalfCotangent(angleAt(flat[next], middle, flat[c])),
        HalfCotangent(angleAt(middle, flat[c], flat[next])),
        HalfCotangent(angleAt(flat[c], flat[next], middle)) };
      out.Feature = { 0, this->Features.Line[this->Mesh.Edge(h)], 0 };
      out.Twin = { 3 * number[(c + 2) % 3] + 2, None, 3 * number[next] };
      this->Image[h - 3 * this->Part.FirstTriangle] = 3 * number[c] + 1;
      back = SymbolicTransition::Composed(back, ring, this->Out.Degree);
    }
    this->Out.Positions.push_back(position);
    this->Out.Cones.push_back({ cone, back });
    this->Out.ConeIndex.push_back(this->Matching.SingularityIndex[t]);
    this->Out.IsCorner.push_back(0);
    this->Out.IsChainEnd.push_back(0);
  }

  void LinkAndMark()
  {
    std::vector<int> valence(this->Part.Vertices(), 0);
    std::vector<int> axisAt(this->Part.Vertices(), -1);
    for (Index h = 3 * this->Part.FirstTriangle; h < 3 * this->Part.EndTriangle; ++h)
    {
      const Index image = this->Image[h - 3 * this->Part.FirstTriangle];
      const Index twin = this->Mesh.Twin(h);
      MapTriangle& t = this->Out.Triangles[image / 3];
      t.Twin[image % 3] = twin == None ? None : this->Image[twin - 3 * this->Part.FirstTriangle];
      const Index e = this->Mesh.Edge(h);
      if (!this->Mesh.GivesDirection(h) || this->Features.IsFeature[e] == 0)
      {
        continue;
      }
      ++valence[this->Local(this->Mesh.Tail(h))];
      ++valence[this->Local(this->Mesh.Head(h))];
      const Index base = this->Local(this->Features.Base[e]);
      const int corner = image % 3;
      const int baseCorner = t.Vertex[corner] == base ? corner : (corner + 1) % 3;
      const int axis = (this->Features.Axis[e] + t.Corner[baseCorner].Turn) % this->Out.Degree;
      this->Out.Isolines.push_back({ image / 3, corner, axis, e });
      for (const int c : { corner, (corner + 1) % 3 })
      {
        const int own = (axis + this->Out.Degree - t.Corner[c].Turn) % (this->Out.Degree / 2);
        int& known = axisAt[t.Vertex[c]];
        const bool isTurn = known != -1 && known != own;
        this->Out.IsChainEnd[t.Vertex[c]] =
          isTurn || this->Out.IsChainEnd[t.Vertex[c]] != 0 ? 1 : 0;
        known = own;
      }
    }
    for (Index v = 0; v < this->Part.Vertices(); ++v)
    {
      const bool isEnd =
        !this->Features.IsEnd.empty() && this->Features.IsEnd[this->Part.FirstVertex + v] != 0;
      this->Out.IsChainEnd[v] =
        isEnd || valence[v] == 1 || valence[v] > 2 || this->Out.IsChainEnd[v] != 0 ? 1 : 0;
    }
  }
};

CutMesh::CutMesh(const SurfaceGeometry& geometry, const TriangleMesh::Component& component,
  const FieldMatching& matching, const FeatureLines& features, const std::vector<char>& isFrameless,
  const CutGraph& graph, const std::vector<Complex>& section)
  : Degree(matching.Degree)
  , Triangles(component.Triangles())
  , Positions(geometry.Positions.begin() + component.FirstVertex,
      geometry.Positions.begin() + component.EndVertex)
  , NumberOfJumps(graph.GetNumberOfVariables())
  , ConeIndex(component.Vertices(), 0)
  , IsCorner(component.Vertices(), 0)
  , IsChainEnd(component.Vertices(), 0)
{
  const TriangleMesh& mesh = geometry.Mesh;
  const std::size_t number = &component - mesh.GetComponents().data();
  Builder builder{ geometry, mesh, component, matching, features, isFrameless, graph,
    geometry.Lengths.Unit[number], *this, std::vector<Index>(3 * component.Triangles()) };
  std::vector<char> isInStar(component.Triangles(), 0);
  std::vector<Index> fan;
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    if (isFrameless[v] != 0)
    {
      mesh.GetFan(v, fan);
      for (const Index h : fan)
      {
        isInStar[h / 3 - component.FirstTriangle] = 1;
      }
      builder.AddStar(v);
    }
  }
  for (Index t = component.FirstTriangle; t < component.EndTriangle; ++t)
  {
    if (isInStar[t - component.FirstTriangle] != 0)
    {
      continue;
    }
    if (matching.SingularityIndex[t] != 0 || t == graph.GetSeed())
    {
      builder.AddCone(t, section);
    }
    else
    {
      builder.AddRegular(t);
    }
  }
  builder.LinkAndMark();
}
}
