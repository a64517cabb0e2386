// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Guidance/TensorSection.h"

#include "Curvature/ShapeSmoothing.h"
#include "Interpolation/GivenField.h"
#include "Sections/DoubleCover.h"
#include "Support/Threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace DirectionFields::Internal
{
namespace
{
/// A vertex counts where |q| is more than this many standard deviations of the noise that is left
/// in it, or beside such a vertex more than so few, and more than rounding to single precision may
/// leave of the largest component. Noise alone seldom is beside what is significant.
constexpr double Significant = 6.0;
constexpr double SignificantBeside = 3.0;
constexpr double Rounding = 1e-6;
/// The weight is |q| / sqrt(|q|^2 + e^2), where e is the first of these times the standard
/// deviation, or the second one times the root mean square of |q|, whichever is larger.
constexpr double DeviationsOfHalf = 4.0;
constexpr double PartOfHalf = 0.05;
/// Larger Magnitude has no direction where the moduli of the principal values differ by less than
/// this part of the largest difference that they can have: it jumps there.
constexpr double LeastMagnitude = 0.1;

using Matrix = Eigen::Matrix3d;

/// A tensor over the unit.
Matrix MatrixOf(const SurfaceTensors& tensors, double unit, Index i)
{
  const double* v = &tensors.Values[static_cast<std::size_t>(tensors.Components) * i];
  Matrix matrix;
  if (tensors.Components == 6)
  {
    matrix << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
  }
  else
  {
    matrix << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
  }
  return matrix / unit;
}

Matrix SymmetricPart(const Matrix& matrix)
{
  return 0.5 * matrix + 0.5 * matrix.transpose();
}

/// q and H in the plane of two unit vectors at right angles.
Shape TangentialPart(const Matrix& tensor, const Vector3& x, const Vector3& y)
{
  const double a = x.dot(tensor * x);
  const double c = y.dot(tensor * y);
  Shape part;
  part.Hopf = Complex(0.5 * (a - c), x.dot(tensor * y));
  part.Mean = 0.5 * (a + c);
  return part;
}

/// The size of the shear on a plane over that of the tensor.
double ShearAcross(const Matrix& tensor, const Vector3& normal)
{
  const double size = tensor.norm();
  const Vector3 onPlane = tensor * normal;
  return size > 0.0 ? (onPlane - onPlane.dot(normal) * normal).norm() / size : 0.0;
}

/// The tensor of a triangle as it is seen from one of its corners, in the frame of the vertex: it
/// is carried along the line that halves the corner, so that neither side is preferred.
Shape FromTriangle(
  const SurfaceGeometry& geometry, const TriangleInSpace& triangle, const Matrix& tensor, Index h)
{
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

/// Calls body(v) for all vertices, on the threads of the scope.
template <typename Body>
void ForVertices(const TriangleMesh& mesh, const Body& body)
{
  ParallelFor(mesh.GetNumberOfVertices(), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index v = begin; v < end; ++v)
      {
        body(v);
      }
    });
}

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
    const double third = unit * unit / 3.0;
    const TriangleMesh::Component& component = mesh.GetComponents()[c];
    for (Index h = 3 * component.FirstTriangle; h < 3 * component.EndTriangle; ++h)
    {
      areas[mesh.Tail(h)] += third * geometry.Lengths.Area[h / 3];
    }
  }
  return areas;
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

/// The largest component of the parts that are not symmetric.
double LargestAsymmetry(const TriangleMesh& mesh, const SurfaceTensors& tensors, double unit)
{
  double largest = 0.0;
  if (tensors.Components == 9)
  {
    const Index end =
      tensors.AtTriangles ? mesh.GetNumberOfTriangles() : mesh.GetNumberOfVertices();
    for (Index i = 0; i < end; ++i)
    {
      const Matrix matrix =
        MatrixOf(tensors, unit, tensors.AtTriangles ? mesh.InputTriangle(i) : mesh.Point(i));
      largest = std::max(largest, 0.5 * (matrix - matrix.transpose()).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

double MedianOf(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
}

VertexTensors::VertexTensors(const SurfaceGeometry& geometry, const SurfaceTensors& tensors,
  double scale, const Progress& progress)
  : Parts(geometry.Mesh.GetNumberOfVertices())
  , Weights(Parts.size(), 0.0)
  , Largest(Parts.size(), 0.0)
  , Across(Parts.size(), 0.0)
{
  if (this->Parts.empty())
  {
    return;
  }
  const double largest = LargestOf(geometry.Mesh, tensors);
  this->Unit = largest > 0.0 ? largest : 1.0;
  this->AsymmetricPart = LargestAsymmetry(geometry.Mesh, tensors, this->Unit);
  progress.Report(0.1);
  if (tensors.AtTriangles)
  {
    this->ReadTriangles(geometry, tensors);
  }
  else
  {
    this->ReadPoints(geometry, tensors);
  }
  this->AcrossPart = MedianOf(this->Across);
  progress.Report(0.3);
  SmoothTensors(geometry, scale, this->Parts);
  progress.Report(0.9);
  this->Weigh(geometry);
  this->Largest = {};
  this->Across = {};
}

void VertexTensors::ReadPoints(const SurfaceGeometry& geometry, const SurfaceTensors& tensors)
{
  ForVertices(geometry.Mesh,
    [&](Index v)
    {
      const Matrix tensor = SymmetricPart(MatrixOf(tensors, this->Unit, geometry.Mesh.Point(v)));
      const TangentFrames& frames = geometry.Frames;
      this->Parts[v] = TangentialPart(tensor, frames.X[v], frames.Y(v));
      this->Largest[v] = tensor.cwiseAbs().maxCoeff();
      this->Across[v] = ShearAcross(tensor, frames.Normal[v]);
    });
}

void VertexTensors::ReadTriangles(const SurfaceGeometry& geometry, const SurfaceTensors& tensors)
{
  const TriangleMesh& mesh = geometry.Mesh;
  ForVertices(mesh,
    [&](Index v)
    {
      std::vector<Index> fan;
      mesh.GetFan(v, fan);
      double sum = 0.0;
      for (const Index h : fan)
      {
        const TriangleInSpace triangle = InSpace(geometry, h / 3);
        const Matrix tensor =
          SymmetricPart(MatrixOf(tensors, this->Unit, mesh.InputTriangle(h / 3)));
        const double weight = geometry.Transport.CornerAngle(mesh, h);
        const Shape part = FromTriangle(geometry, triangle, tensor, h);
        this->Parts[v].Hopf += weight * part.Hopf;
        this->Parts[v].Mean += weight * part.Mean;
        this->Largest[v] = std::max(this->Largest[v], tensor.cwiseAbs().maxCoeff());
        this->Across[v] += weight * ShearAcross(tensor, triangle.Normal);
        sum += weight;
      }
      this->Parts[v].Hopf /= sum;
      this->Parts[v].Mean /= sum;
      this->Across[v] /= sum;
    });
}

std::vector<char> VertexTensors::CountingOf(
  const TriangleMesh& mesh, const TriangleMesh::Component& component) const
{
  const Index first = component.FirstVertex;
  const double largest =
    *std::max_element(this->Largest.begin() + first, this->Largest.begin() + component.EndVertex);
  enum : char
  {
    Isotropic,
    Doubtful,
    Counting
  };
  std::vector<char> kinds(component.EndVertex - first, Isotropic);
  for (Index v = first; v < component.EndVertex; ++v)
  {
    const double size = std::abs(this->Parts[v].Hopf);
    const double deviation = std::sqrt(this->Parts[v].Variance);
    if (size > SignificantBeside * deviation && size > Rounding * largest)
    {
      kinds[v - first] = size > Significant * deviation ? Counting : Doubtful;
    }
  }
  std::vector<char> counts(kinds.size(), 0);
  for (Index h = 3 * component.FirstTriangle; h < 3 * component.EndTriangle; ++h)
  {
    const Index tail = mesh.Tail(h) - first;
    const Index head = mesh.Head(h) - first;
    // Two that are doubtful do not help each other.
    const bool isOneCounting = kinds[tail] == Counting || kinds[head] == Counting;
    counts[tail] |= isOneCounting && kinds[tail] != Isotropic ? 1 : 0;
    counts[head] |= isOneCounting && kinds[head] != Isotropic ? 1 : 0;
  }
  return counts;
}

void VertexTensors::Weigh(const SurfaceGeometry& geometry)
{
  const std::vector<double> areas = AreasOf(geometry);
  double total = 0.0;
  for (const TriangleMesh::Component& component : geometry.Mesh.GetComponents())
  {
    const std::vector<char> counts = this->CountingOf(geometry.Mesh, component);
    double squares = 0.0;
    double area = 0.0;
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      squares += areas[v] * std::norm(this->Parts[v].Hopf);
      area += areas[v];
    }
    const double least = PartOfHalf * std::sqrt(area > 0.0 ? squares / area : 0.0);
    for (Index v = component.FirstVertex; v < component.EndVertex; ++v)
    {
      if (counts[v - component.FirstVertex] != 0)
      {
        const double size = std::abs(this->Parts[v].Hopf);
        const double deviation = std::sqrt(this->Parts[v].Variance);
        this->Weights[v] = size / std::hypot(size, std::max(DeviationsOfHalf * deviation, least));
      }
      else
      {
        this->IsotropicShare += areas[v];
      }
    }
    total += area;
  }
  this->IsotropicShare /= total > 0.0 ? total : 1.0;
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

Complex LineOf(const Shape& part, TensorDirection direction)
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
    {
      const double magnitude = std::clamp(part.Mean / size, -1.0, 1.0);
      return std::abs(magnitude) < LeastMagnitude ? 0.0 : part.Hopf / size * magnitude;
    }
    case TensorDirection::Major:
      break;
  }
  return part.Hopf / size;
}

std::vector<Complex> TensorSection(const SurfaceGeometry& geometry, const VertexTensors& tensors,
  int degree, TensorDirection direction)
{
  const TriangleMesh& mesh = geometry.Mesh;
  std::vector<Complex> section(tensors.Parts.size(), 0.0);
  ForVertices(mesh,
    [&](Index v)
    {
      const Complex major = LineOf(tensors.Parts[v], TensorDirection::Major);
      const Complex power = degree == 4 ? major * major : LineOf(tensors.Parts[v], direction);
      section[v] = tensors.Weights[v] * power;
    });
  for (const TriangleMesh::Component& component : mesh.GetComponents())
  {
    const DoubleCover cover(geometry, component, degree);
    for (Index v = component.FirstVertex; component.IsCover && v < component.EndVertex; ++v)
    {
      if (mesh.IsFrontVertex(v))
      {
        section[mesh.MirrorVertex(v)] = cover.Mirrored(v, section[v]);
      }
    }
  }
  return section;
}

TensorGuidance AtPoints(const SurfaceGeometry& geometry, const VertexTensors& tensors,
  TensorDirection direction, const std::vector<Index>& vertices)
{
  const std::size_t points = vertices.size();
  TensorGuidance guidance;
  guidance.Guidance.Vectors.assign(points, Vector3::Zero());
  guidance.Guidance.Weights.assign(points, 0.0);
  guidance.MajorValue.assign(points, 0.0);
  guidance.MinorValue.assign(points, 0.0);
  guidance.Anisotropy.assign(points, 0.0);
  guidance.Tangential.assign(points, {});
  guidance.IsotropicShare = tensors.IsotropicShare;
  guidance.AsymmetricPart = tensors.AsymmetricPart;
  guidance.AcrossPart = tensors.AcrossPart;
  ParallelFor(static_cast<Index>(points), MediumPiece,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const Index v = vertices[i];
        if (v == None)
        {
          continue;
        }
        const Shape& part = tensors.Parts[v];
        const Complex line = LineOf(part, direction);
        const Complex z = std::polar(1.0, 0.5 * std::arg(line));
        const double size = std::abs(part.Hopf);
        const Vector3& x = geometry.Frames.X[v];
        const Vector3 y = geometry.Frames.Y(v);
        guidance.Guidance.Weights[i] = tensors.Weights[v] * std::abs(line);
        guidance.Guidance.Vectors[i] = z.real() * x + z.imag() * y;
        guidance.MajorValue[i] = (part.Mean + size) * tensors.Unit;
        guidance.MinorValue[i] = (part.Mean - size) * tensors.Unit;
        guidance.Anisotropy[i] = size * tensors.Unit;
        const Matrix t = tensors.Unit *
          ((part.Mean + part.Hopf.real()) * x * x.transpose() +
            part.Hopf.imag() * (x * y.transpose() + y * x.transpose()) +
            (part.Mean - part.Hopf.real()) * y * y.transpose());
        guidance.Tangential[i] = { t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2) };
      }
    });
  return guidance;
}
}
