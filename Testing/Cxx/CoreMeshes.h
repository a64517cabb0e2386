// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef CoreMeshes_h
#define CoreMeshes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

/// The surfaces of the Core's tests, as polydata.
namespace CoreMeshes
{
/// "disk": unit disk with the symmetries of the square; "icosahedron": with flat subdivided faces.
/// Null for other names.
vtkSmartPointer<vtkPolyData> Make(const std::string& name);
}

#endif
