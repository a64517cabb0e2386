// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkAbaqusMeshWriter.h"

#include "Conversion/Regions/PolyDataToShell.h"

#include <DirectionFields/SolverFiles/AbaqusFile.h>

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkAbaqusMeshWriter);

//------------------------------------------------------------------------------
vtkAbaqusMeshWriter::vtkAbaqusMeshWriter()
  : FileName(nullptr)
  , RegionArray(nullptr)
  , DirectionArray(nullptr)
  , SecondOrder(false)
  , Thickness(0.0)
{
  this->SetRegionArray(DirectionFields::AutomaticRegions);
}

//------------------------------------------------------------------------------
vtkAbaqusMeshWriter::~vtkAbaqusMeshWriter()
{
  this->SetFileName(nullptr);
  this->SetRegionArray(nullptr);
  this->SetDirectionArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkAbaqusMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "RegionArray: " << (this->RegionArray ? this->RegionArray : "(none)") << "\n";
  os << indent << "DirectionArray: " << (this->DirectionArray ? this->DirectionArray : "(none)")
     << "\n";
  os << indent << "SecondOrder: " << this->SecondOrder << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
}

//------------------------------------------------------------------------------
vtkPolyData* vtkAbaqusMeshWriter::GetInput()
{
  return vtkPolyData::SafeDownCast(this->Superclass::GetInput());
}

//------------------------------------------------------------------------------
vtkPolyData* vtkAbaqusMeshWriter::GetInput(int port)
{
  return vtkPolyData::SafeDownCast(this->Superclass::GetInput(port));
}

//------------------------------------------------------------------------------
int vtkAbaqusMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkAbaqusMeshWriter::WriteMesh(vtkPolyData* mesh)
{
  if (!mesh || !this->FileName || !*this->FileName)
  {
    throw std::invalid_argument("There is no File Name to write to, or no input.");
  }
  DirectionFields::AbaqusOptions options;
  options.SecondOrder = this->SecondOrder;
  options.Thickness = this->Thickness;
  std::vector<std::string> warnings;
  DirectionFields::WriteAbaqus(this->FileName,
    DirectionFields::PolyDataToShell(mesh, this->RegionArray, this->DirectionArray, warnings),
    options);
  for (const std::string& warning : warnings)
  {
    vtkWarningMacro(<< warning);
  }
}

//------------------------------------------------------------------------------
void vtkAbaqusMeshWriter::WriteData()
{
  std::string error;
  try
  {
    this->WriteMesh(this->GetInput());
  }
  catch (const std::bad_alloc&)
  {
    error = "Out of memory. Write the mesh in parts.";
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
  }
}
