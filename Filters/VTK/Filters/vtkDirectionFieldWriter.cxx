// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldWriter.h"

#include "Conversion/Input/GivenPolyData.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Support/DefaultThreads.h"

#include <DirectionFields/Exchange/FieldExport.h>
#include <DirectionFields/Options.h>
#include <DirectionFields/Support/Threads.h>

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDirectionFieldWriter);

//------------------------------------------------------------------------------
vtkDirectionFieldWriter::vtkDirectionFieldWriter()
  : FileName(nullptr)
  , FieldOn(CELLS)
{
  const DirectionFields::Options defaults;
  this->FeatureAngle = defaults.FeatureAngle;
  this->MinimumFeatureLength = defaults.MinimumFeatureLength;
}

//------------------------------------------------------------------------------
vtkDirectionFieldWriter::~vtkDirectionFieldWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FieldOn: " << this->FieldOn << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MinimumFeatureLength: " << this->MinimumFeatureLength << "\n";
}

//------------------------------------------------------------------------------
vtkPolyData* vtkDirectionFieldWriter::GetInput()
{
  return vtkPolyData::SafeDownCast(this->Superclass::GetInput());
}

//------------------------------------------------------------------------------
vtkPolyData* vtkDirectionFieldWriter::GetInput(int port)
{
  return vtkPolyData::SafeDownCast(this->Superclass::GetInput(port));
}

//------------------------------------------------------------------------------
int vtkDirectionFieldWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkDirectionFieldWriter::WriteFiles(vtkPolyData* input)
{
  if (!input || !this->FileName || !*this->FileName)
  {
    throw std::invalid_argument("There is no File Name to write to, or no input.");
  }
  DirectionFields::ExportOptions options;
  options.Format = DirectionFields::FormatOf(this->FileName);
  options.On =
    this->FieldOn == POINTS ? DirectionFields::FieldOn::Points : DirectionFields::FieldOn::Cells;
  options.FeatureAngle = this->FeatureAngle;
  options.MinimumFeatureLength = this->MinimumFeatureLength;
  if (options.Format == DirectionFields::FieldFormat::ObjComments)
  {
    throw std::invalid_argument(
      "A direction field is written to a .rosy, .ffield, .rawfield or .sing file; its mesh, .obj, comes with it.");
  }
  DirectionFields::Threads threads(DirectionFields::DefaultThreads());
  const DirectionFields::Threads::Scope scope(threads);
  DirectionFields::CheckPolyData(input);
  const DirectionFields::TriangulatedPolyData surface = DirectionFields::PolyDataToSurface(input);
  DirectionFields::RequireTriangles(input);
  DirectionFields::WriteFiles(
    this->FileName, DirectionFields::FilesOfPolyData(input, surface.Mesh, options));
}

//------------------------------------------------------------------------------
std::string vtkDirectionFieldWriter::WriteSurface(vtkPolyData* surface)
{
  try
  {
    this->WriteFiles(surface);
    return {};
  }
  catch (const std::bad_alloc&)
  {
    return "Out of memory. Decimate the surface or process it in parts.";
  }
  catch (const std::exception& exception)
  {
    return exception.what();
  }
}

//------------------------------------------------------------------------------
void vtkDirectionFieldWriter::WriteData()
{
  const std::string error = this->WriteSurface(this->GetInput());
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
  }
}
