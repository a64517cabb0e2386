// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/TensorGuidance.h"

#include "Curvature/ShapeSmoothing.h"
#include "Interpolation/GivenField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace DirectionFields
{
namespace
{
using Internal::Shape;

/// A vertex counts where |q| is more than this many standard deviations of what noise is left in
/// it, and more than rounding to single precision may leave of the largest component.
constexpr double Significant = 6.0;
constexpr double Rounding = 1e-6;
/// The weight is |q| / sqrt(|q|^2 + e^2), with e the larger one of so many deviations and of this
/// part of the root mean square of |q|.
constexpr double DeviationsOfHalf = 4.0;
constexpr double PartOfHalf = 0.05;

/// A symmetric tensor, in parts of the largest component of all.
struct Tensor
{
  Eigen::Matrix3d Symmetric;
  double Largest = 0.0;
};

class Tensors
{
public:
  Tensors(const SurfaceTensors& given, double largest)
    : Given(given)
    , Unit(largest > 0.0 ? largest : 1.0)
  {
  }

  Tensor At(Index i) const
  {
    const double* v = &this->Given.Values[static_cast<std::size_t>(this->Given.Components) * i];
    Eigen::Matrix3d matrix;
    if (this->Given.Components == 6)
    {
      matrix << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
    }
    else
    {
      matrix << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
    }
    matrix /= this->Unit;
    const Eigen::Matrix3d symmetric = 0.5 * matrix + 0.5 * matrix.transpose();
    return { symmetric, symmetric.cwiseAbs().maxCoeff() };
  }

  /// The largest component of the part that is not symmetric.
  double Asymmetric(Index i) const
  {
    if (this->Given.Components == 6)
    {
      return 0.0;
    }
    const double* v = &this->Given.Values[static_cast<std::size_t>(9) * i];
    return 0.5 *
      std::max({ std::abs(v[1] / this->Unit - v[3] / this->Unit),
        std::abs(v[2] / this->Unit - v[6] / this->Unit),
        std::abs(v[5] / this->Unit - v[7] / this->Unit) });
  }

  double GetUnit() const { return this->Unit; }

private:
  const SurfaceTensors& Given;
  double Unit;
};

/// q and H in the plane of two unit vectors at right angles.
Shape TangentialPart(const Eigen::Matrix3d& tensor, const Vector3& x, const Vector3& y)
{
  const double a = x.dot(tensor * x);
  const double c = y.dot(tensor * y);
  Shape part;
  part.Hopf = Complex(0.5 * (a - c), x.dot(tensor * y));
  part.Mean = 0.5 * (a + c);
  return part;
}

/// The tensor of a triangle as it is seen from one of its corners, in the frame of the vertex: it
/// is carried along the line that halves the corner, so that neither side is preferred.
Shape FromTriangle(const SurfaceGeometry& geometry, const Eigen::Matrix3d& tensor, Index h)
{
  const TriangleInSpace triangle = InSpace(geometry, h / 3);
  const Vector3& corner = triangle.Corners[h % 3];
  Vector3 x = (triangle.Corners[(h + 1) % 3] - corner).stableNormalized() +
    (triangle.Corners[(h + 2) % 3] - corner).stableNormalized();
  x -= x.dot(triangle.Normal) * triangle.Normal;
  x = x.norm() > 1e-6 ? Vector3(x.normalized()) : triangle.X;
  Shape part = TangentialPart(tensor, x, triangle.Normal.cross(x));
  const double angle =
    geometry.Transport.EdgeAngle[h] + 0.5 * geometry.Transport.CornerAngle(geometry.Mesh, h);
  part.Hopf *= std::polar(1.0, 2.0 * angle);
  return part;
}

/// The tangential parts at the vertices, and the largest component of the tensors that they are of.
struct VertexTensors
{
  VertexTensors(const SurfaceGeometry& geometry, const Tensors& tensors, bool atTriangles)
    : Parts(geometry.Mesh.GetNumberOfVertices())
    , Largest(Parts.size(), 0.0)
  {
    const TriangleMesh& mesh = geometry.Mesh;
    std::vector<Index> fan;
    for (Index v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (!atTriangles)
      {
        const Tensor tensor = tensors.At(mesh.Point(v));
        const TangentFrames& frames = geometry.Frames;
        this->Parts[v] = TangentialPart(tensor.Symmetric, frames.X[v], frames.Y(v));
        this->Largest[v] = tensor.Largest;
        continue;
      }
      mesh.GetFan(v, fan);
      double sum = 0.0;
      for (const Index h : fan)
      {
        const Tensor tensor = tensors.At(mesh.InputTriangle(h / 3));
        const double weight = geometry.Transport.CornerAngle(mesh, h);
        const Shape part = FromTriangle(geometry, tensor.Symmetric, h);
        this->Parts[v].Hopf += weight * part.Hopf;
        this->Parts[v].Mean += weight * part.Mean;
        this->Largest[v] = std::max(this->Largest[v], tensor.Largest);
        sum += weight;
      }
      this->Parts[v].Hopf /= sum;
      this->Parts[v].Mean /= sum;
    }
  }

  std::vector<Shape> Parts;
  std::vector<double> Largest;
};

/// A third of the area of the triangles at each vertex, in the square of the largest unit of a
/// component.
std::vector<double> AreasOf(const SurfaceGeometry& geometry)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<double> areas(mesh.GetNumberOfVertices(), 0.0);
  const std::vector<double>& units = geometry.Lengths.Unit;
  const double largest = units.empty() ? 1.0 : *std::max_element(units.begin(), units.end());
  for (std::size_t c = 0; c < mesh.GetComponents().size(); ++c)
  {
    const double unit = units[c] / largest;
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      std::vector<Index> fan;
      mesh.GetFan(v, fan);
      for (const Index h : fan)
      {
        areas[v] += geometry.Lengths.Area[h / 3] / 3.0 * unit * unit;
      }
    }
  }
  return areas;
}

/// The weights of the vertices of a component.
void Weigh(const TriangleMesh::Component& component, const std::vector<Shape>& parts,
  const std::vector<double>& areas, double largest, std::vector<double>& weights)
{
  double squares = 0.0;
  double area = 0.0;
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    squares += areas[v] * std::norm(parts[v].Hopf);
    area += areas[v];
  }
  const double least = PartOfHalf * std::sqrt(area > 0.0 ? squares / area : 0.0);
  for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
  {
    const double size = std::abs(parts[v].Hopf);
    const double deviation = std::sqrt(parts[v].Variance);
    if (size > Significant * deviation && size > Rounding * largest)
    {
      weights[v] = size / std::hypot(size, std::max(DeviationsOfHalf * deviation, least));
    }
  }
}

void Check(
  const Surface& surface, const SurfaceTensors& tensors, const TensorGuidanceOptions& options)
{
  if (!(options.Scale >= 0.0 && options.Scale <= 32.0))
  {
    throw std::invalid_argument("Tensor Scale must be 0 to 32.");
  }
  if (tensors.Components != 6 && tensors.Components != 9)
  {
    throw std::invalid_argument("Choose tensors of 6 or 9 components: these have " +
      std::to_string(tensors.Components) + ".");
  }
  const std::size_t places = tensors.AtTriangles ? surface.Triangles.size() : surface.Points.size();
  if (tensors.Values.size() != places * static_cast<std::size_t>(tensors.Components))
  {
    throw std::invalid_argument("Give one tensor for each " +
      std::string(tensors.AtTriangles ? "triangle" : "point") +
      " of the surface: " + std::to_string(places * static_cast<std::size_t>(tensors.Components)) +
      " numbers, not " + std::to_string(tensors.Values.size()) + ".");
  }
}

/// The largest component of the tensors that the mesh uses. Throws std::invalid_argument where one
/// is not finite.
double LargestOf(const TriangleMesh& mesh, const SurfaceTensors& tensors)
{
  double largest = 0.0;
  const Index end = tensors.AtTriangles ? mesh.GetNumberOfTriangles() : mesh.GetNumberOfVertices();
  for (Index i = 0; i < end; ++i)
  {
    const Index at = tensors.AtTriangles ? mesh.InputTriangle(i) : mesh.Point(i);
    for (int k = 0; k < tensors.Components; ++k)
    {
      const double value = tensors.Values[static_cast<std::size_t>(tensors.Components) * at + k];
      if (!std::isfinite(value))
      {
        throw std::invalid_argument(
          "Fill in or leave out the tensors that are not finite: that of " +
          std::string(tensors.AtTriangles ? "triangle " : "point ") + std::to_string(at) +
          " is not.");
      }
      largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

/// What the options ask for, as a complex number whose angle is twice the direction's, of modulus 0
/// to 1.
Complex Asked(const Shape& part, TensorDirection direction)
{
  const double size = std::abs(part.Hopf);
  if (size == 0.0)
  {
    return 0.0;
  }
  switch (direction)
  {
    case TensorDirection::Minor:
      return -part.Hopf / size;
    case TensorDirection::LargerMagnitude:
      return part.Hopf / size * std::clamp(part.Mean / size, -1.0, 1.0);
    case TensorDirection::Major:
      break;
  }
  return part.Hopf / size;
}

TensorGuidance Empty(std::size_t points)
{
  TensorGuidance guidance;
  guidance.Guidance.Vectors.assign(points, Vector3::Zero());
  guidance.Guidance.Weights.assign(points, 0.0);
  guidance.MajorValue.assign(points, 0.0);
  guidance.MinorValue.assign(points, 0.0);
  guidance.Anisotropy.assign(points, 0.0);
  return guidance;
}

/// Points that share a vertex have the values of the first of them.
void Share(const std::vector<Index>& first, TensorGuidance& guidance)
{
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    guidance.Guidance.Vectors[i] = guidance.Guidance.Vectors[first[i]];
    guidance.Guidance.Weights[i] = guidance.Guidance.Weights[first[i]];
    guidance.MajorValue[i] = guidance.MajorValue[first[i]];
    guidance.MinorValue[i] = guidance.MinorValue[first[i]];
    guidance.Anisotropy[i] = guidance.Anisotropy[first[i]];
  }
}
}

TensorGuidance GuideByTensors(const Surface& surface, const SurfaceTensors& tensors,
  const TensorGuidanceOptions& options, const Progress& progress)
{
  Check(surface, tensors, options);
  TensorGuidance guidance = Empty(surface.Points.size());
  if (surface.Triangles.empty())
  {
    return guidance;
  }
  const FieldSurface made(surface);
  const SurfaceGeometry& geometry = *made.Geometry;
  const TriangleMesh& mesh = geometry.Mesh;
  progress.Report(0.3);
  const Tensors scaled(tensors, LargestOf(mesh, tensors));
  VertexTensors at(geometry, scaled, tensors.AtTriangles);
  progress.Report(0.5);
  Internal::SmoothTensors(geometry, options.Scale, at.Parts);
  progress.Report(0.9);
  const std::vector<double> areas = AreasOf(geometry);
  std::vector<double> weights(areas.size(), 0.0);
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    const double largest = *std::max_element(
      at.Largest.begin() + component.FirstVertex, at.Largest.begin() + component.EndVertex);
    Weigh(component, at.Parts, areas, largest, weights);
  }
  double area = 0.0;
  for (Index v = mesh.GetNumberOfVertices() - 1; v >= 0; --v)
  {
    const Shape& part = at.Parts[v];
    const Complex asked = Asked(part, options.Direction);
    const Complex z = std::polar(1.0, 0.5 * std::arg(asked));
    const double size = std::abs(part.Hopf);
    const Index point = mesh.Point(v);
    area += areas[v];
    guidance.IsotropicShare += weights[v] > 0.0 ? 0.0 : areas[v];
    guidance.Guidance.Weights[point] = weights[v] * std::abs(asked);
    guidance.Guidance.Vectors[point] =
      z.real() * geometry.Frames.X[v] + z.imag() * geometry.Frames.Y(v);
    guidance.MajorValue[point] = (part.Mean + size) * scaled.GetUnit();
    guidance.MinorValue[point] = (part.Mean - size) * scaled.GetUnit();
    guidance.Anisotropy[point] = size * scaled.GetUnit();
  }
  guidance.IsotropicShare /= area > 0.0 ? area : 1.0;
  const auto places = static_cast<Index>(tensors.Values.size() / tensors.Components);
  for (Index i = 0; i < places; ++i)
  {
    guidance.AsymmetricPart = std::max(guidance.AsymmetricPart, scaled.Asymmetric(i));
  }
  Share(made.FirstPoint, guidance);
  progress.Report(1.0);
  return guidance;
}
}
