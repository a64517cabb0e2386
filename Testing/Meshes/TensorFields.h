// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef TensorFields_h
#define TensorFields_h

#include "Guidance/TensorGuidance.h"
#include "Meshes/Surfaces.h"
#include "Result.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

/// Tensors on surfaces whose principal directions and isotropic points are known.
namespace Meshes
{
using DirectionFields::Complex;
using DirectionFields::Index;
using DirectionFields::Pi;
using DirectionFields::Result;
using DirectionFields::SurfaceTensors;
using DirectionFields::Triangle;

using Matrix = Eigen::Matrix3d;
using TensorAt = std::function<Matrix(const Vector3&)>;

constexpr double HoleRadius = 0.15;

/// The plane tensor of mean h and deviator q.
inline Matrix Plane(const Complex& q, double h)
{
  Matrix tensor = Matrix::Zero();
  tensor.topLeftCorner<2, 2>() << h + q.real(), q.imag(), q.imag(), h - q.real();
  return tensor;
}

/// Half of the difference of the principal stresses and the mean around a hole in a plate that is
/// pulled along x (G. Kirsch 1898).
inline Complex KirschDeviator(const Vector3& p)
{
  const double s = HoleRadius * HoleRadius / (p.x() * p.x() + p.y() * p.y());
  const double t = std::atan2(p.y(), p.x());
  const Complex polar(0.5 * (-s + (1.0 - 2.0 * s + 3.0 * s * s) * std::cos(2.0 * t)),
    -0.5 * (1.0 + 2.0 * s - 3.0 * s * s) * std::sin(2.0 * t));
  return polar * std::polar(1.0, 2.0 * t);
}

inline Matrix Kirsch(const Vector3& p)
{
  const double s = HoleRadius * HoleRadius / (p.x() * p.x() + p.y() * p.y());
  return Plane(KirschDeviator(p), 0.5 - s * std::cos(2.0 * std::atan2(p.y(), p.x())));
}

/// The square plate [-1, 1]^2 with a hole, its points closer to each other near the hole, as meshes
/// for stress have it: the distances from the middle grow by the same factor from ring to ring.
inline Surface Plate(int around, int across)
{
  Surface plate = PlateWithHole(around, across, HoleRadius, false);
  for (Vector3& p : plate.Points)
  {
    const double end = p.norm() / p.lpNorm<Eigen::Infinity>();
    const double t = (p.norm() - HoleRadius) / (end - HoleRadius);
    p *= HoleRadius * std::pow(end / HoleRadius, t) / p.norm();
  }
  return plate;
}

/// A ring around the hole with a radius of four times that, in even steps, as a simple mesher has it:
/// coarse where the stress of the hole changes most.
inline Surface EvenRing(int around, int across)
{
  Surface ring = PlateWithHole(around, across, HoleRadius, false);
  for (std::size_t i = 0; i < ring.Points.size(); ++i)
  {
    const double step = static_cast<double>(i / around) / across;
    ring.Points[i] *= HoleRadius * (1.0 + 3.0 * step) / ring.Points[i].norm();
  }
  return ring;
}

inline std::vector<double> Areas(const Surface& surface)
{
  std::vector<double> areas(surface.Points.size(), 0.0);
  for (const Triangle& t : surface.Triangles)
  {
    const Vector3& p = surface.Points[t[0]];
    const double area = (surface.Points[t[1]] - p).cross(surface.Points[t[2]] - p).norm() / 6.0;
    for (const Index corner : t)
    {
      areas[corner] += area;
    }
  }
  return areas;
}

/// The membrane stress in a torus of radii 1 and 0.4 under pressure 1, of thickness 1.
inline Matrix TorusStress(const Vector3& p)
{
  const Vector3 outwards = Vector3(p.x(), p.y(), 0.0).normalized();
  const Vector3 along(-outwards.y(), outwards.x(), 0.0);
  const Vector3 normal = (p - outwards).normalized();
  const Vector3 around = along.cross(normal);
  const double distance = std::hypot(p.x(), p.y());
  return 0.2 * (1.0 + distance) / distance * around * around.transpose() +
    0.2 * along * along.transpose();
}

inline void Append(const Matrix& t, std::vector<double>& values)
{
  values.insert(values.end(), { t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2) });
}

inline SurfaceTensors AtPoints(const Surface& surface, const TensorAt& at)
{
  SurfaceTensors tensors;
  for (const Vector3& p : surface.Points)
  {
    Append(at(p), tensors.Values);
  }
  return tensors;
}

inline SurfaceTensors AtTriangles(const Surface& surface, const TensorAt& at)
{
  SurfaceTensors tensors;
  tensors.AtTriangles = true;
  for (const Triangle& t : surface.Triangles)
  {
    Append(at((surface.Points[t[0]] + surface.Points[t[1]] + surface.Points[t[2]]) / 3.0),
      tensors.Values);
  }
  return tensors;
}

inline void AddNoise(double size, unsigned seed, SurfaceTensors& tensors)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, size);
  for (double& value : tensors.Values)
  {
    value += normal(generator);
  }
}

/// The tensor of deviator prod (z - wedge) prod conj(z - trisector) on the unit square.
struct Zeros
{
  std::vector<Complex> Wedges;
  std::vector<Complex> Trisectors;

  Complex operator()(const Vector3& p) const
  {
    const Complex z(p.x(), p.y());
    Complex q = 1.0;
    for (const Complex& w : this->Wedges)
    {
      q *= z - w;
    }
    for (const Complex& t : this->Trisectors)
    {
      q *= std::conj(z - t);
    }
    return q;
  }
};

inline double MeanSquare(const Surface& surface, const std::function<Complex(const Vector3&)>& q)
{
  double sum = 0.0;
  for (const Vector3& p : surface.Points)
  {
    sum += std::norm(q(p));
  }
  return sum / static_cast<double>(surface.Points.size());
}

/// Root mean square over the area of angles in degrees from the direction of a plane deviator, where
/// that is more than a twentieth of its own.
/// @param off gives the angle of a point at which the deviator has a value
inline double RootMeanSquare(const Surface& surface,
  const std::function<Complex(const Vector3&)>& q,
  const std::function<double(std::size_t, const Complex&)>& off)
{
  const double least = 0.05 * std::sqrt(MeanSquare(surface, q));
  const std::vector<double> areas = Areas(surface);
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const Complex at = q(surface.Points[i]);
    if (std::abs(at) > least)
    {
      sum += areas[i] * std::pow(off(i, at), 2);
      area += areas[i];
    }
  }
  return std::sqrt(sum / area);
}

/// The error of a field.
inline double Error(
  const Result& field, const Surface& surface, const std::function<Complex(const Vector3&)>& q)
{
  return RootMeanSquare(surface, q,
    [&](std::size_t i, const Complex& at)
    {
      const Complex z = std::polar(1.0, 0.5 * std::arg(at));
      return Deviation(field, static_cast<Index>(i), Vector3(z.real(), z.imag(), 0.0));
    });
}

/// The error of the tensors' own eigenvectors.
inline double RawError(const SurfaceTensors& tensors, const Surface& surface,
  const std::function<Complex(const Vector3&)>& q)
{
  return RootMeanSquare(surface, q,
    [&](std::size_t i, const Complex& at)
    {
      const double* t = &tensors.Values[6 * i];
      return 0.5 * std::arg(Complex(0.5 * (t[0] - t[1]), t[3]) / at) * 180.0 / Pi;
    });
}

inline Index Singular(const Result& field)
{
  return static_cast<Index>(std::count_if(field.SingularityIndex.begin(),
    field.SingularityIndex.end(), [](int index) { return index != 0; }));
}

const Zeros Four{ { { 0.25, 0.3 }, { 0.73, 0.71 } }, { { 0.71, 0.27 }, { 0.28, 0.74 } } };

/// The distance of a place in the plane from the nearest triangle of an index.
inline double NearestOfIndex(
  const Result& field, const Surface& surface, int index, const Complex& place)
{
  double nearest = 1e9;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    if (field.SingularityIndex[t] == index)
    {
      const auto& corners = surface.Triangles[t];
      const Vector3 sum =
        surface.Points[corners[0]] + surface.Points[corners[1]] + surface.Points[corners[2]];
      nearest = std::min(nearest, std::abs(Complex(sum.x() / 3.0, sum.y() / 3.0) - place));
    }
  }
  return nearest;
}

/// The largest distance of a wedge or trisector from the nearest triangle of a line field that has
/// its index.
inline double FarthestZero(const Result& field, const Surface& surface, const Zeros& zeros)
{
  double farthest = 0.0;
  for (const Complex& wedge : zeros.Wedges)
  {
    farthest = std::max(farthest, NearestOfIndex(field, surface, 1, wedge));
  }
  for (const Complex& trisector : zeros.Trisectors)
  {
    farthest = std::max(farthest, NearestOfIndex(field, surface, -1, trisector));
  }
  return farthest;
}

/// The membrane stress in an ellipsoid of revolution about z under pressure 1, of thickness 1.
/// @param equator, pole its half axes
inline Matrix EllipsoidStress(const Vector3& p, double equator, double pole)
{
  const double a = equator * equator;
  const Vector3 gradient(p.x() / a, p.y() / a, p.z() / (pole * pole));
  const double around = a * gradient.norm();
  const double along = around * around * around * pole * pole / (a * a);
  const Vector3 normal = gradient.normalized();
  const Vector3 hoop = Vector3::UnitZ().cross(normal).stableNormalized();
  const Vector3 meridian = normal.cross(hoop);
  return 0.5 * around * meridian * meridian.transpose() +
    (around - 0.5 * around * around / along) * hoop * hoop.transpose();
}
}

#endif
