// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef DirectionFields_System_h
#define DirectionFields_System_h

#include "Geometry/SurfaceGeometry.h"
#include "Matrices/CompactValues.h"
#include "Sections/Assembly.h"

#include <random>

/// The matrices of a surface's first component, and the geometry that they come from.
namespace Meshes
{
using namespace DirectionFields;

struct System : SurfaceGeometry
{
  System(const Surface& surface, int degree, double energyBias)
    : SurfaceGeometry(surface)
    , Matrices(AssembleOperators(*this, this->Mesh.GetComponents()[0], degree, energyBias))
    , Scale(2.0 * Pi * degree / this->Lengths.ComponentArea[0])
  {
  }
  Operators Matrices;
  double Scale;
};

inline ComplexVector RandomVector(Eigen::Index n, unsigned seed)
{
  std::mt19937 engine(seed);
  ComplexVector v(n);
  for (Complex& z : v)
  {
    z = std::polar(1.0, engine() / 4294967296.0 * 2.0 * Pi);
  }
  return v;
}

/// One section in single precision.
inline CompactSections Compact(const ComplexVector& x)
{
  CompactSections compact;
  for (const Complex& z : x)
  {
    compact.push_back(static_cast<float>(z.real()));
    compact.push_back(static_cast<float>(z.imag()));
  }
  return compact;
}

inline ComplexVector Widened(const CompactSections& x)
{
  ComplexVector wide(static_cast<Eigen::Index>(x.size() / 2));
  for (Eigen::Index v = 0; v < wide.size(); ++v)
  {
    wide[v] = Complex(x[2 * v], x[2 * v + 1]);
  }
  return wide;
}
}

#endif
