// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldWriter.h"

#include "Conversion/Input/GivenPolyData.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Exchange/CompanionFiles.h"
#include "Exchange/FieldExport.h"
#include "Exchange/TextFile.h"
#include "Options.h"
#include "Support/DefaultThreads.h"
#include "Support/Threads.h"

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

namespace
{
/// The name of a file without its ending.
std::string WithoutEnding(const std::string& fileName)
{
  return fileName.substr(0, fileName.rfind('.'));
}

/// Throws FileError where a file that is not an earlier run's would be replaced.
void RequireOwn(const std::string& name, const std::vector<DirectionFields::ExportedFile>& files)
{
  const std::string mesh = name + ".obj";
  const std::string mark(DirectionFields::ObjMark);
  if (DirectionFields::IsThere(mesh) && DirectionFields::ReadText(mesh, mark.size()) == mark)
  {
    return;
  }
  for (std::size_t i = 1; i < files.size(); ++i)
  {
    if (DirectionFields::IsThere(name + files[i].Ending))
    {
      throw DirectionFields::FileError("There is a file " + name + files[i].Ending +
        " already, which was not written here and would be replaced: a field's file comes with the mesh that "
        "its rows belong to. Choose another name.");
    }
  }
}
}

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
void vtkDirectionFieldWriter::WriteFiles()
{
  vtkPolyData* input = this->GetInput();
  if (!input || !this->FileName || !*this->FileName)
  {
    throw std::invalid_argument("There is no FileName to write to, or no input.");
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
  const std::vector<DirectionFields::ExportedFile> files =
    DirectionFields::FilesOfPolyData(input, surface.Mesh, options);
  const std::string name = WithoutEnding(this->FileName);
  RequireOwn(name, files);
  DirectionFields::WriteText(this->FileName, files[0].Text);
  for (std::size_t i = 1; i < files.size(); ++i)
  {
    DirectionFields::WriteText(name + files[i].Ending, files[i].Text);
  }
}

//------------------------------------------------------------------------------
void vtkDirectionFieldWriter::WriteData()
{
  std::string error;
  try
  {
    this->WriteFiles();
    return;
  }
  catch (const std::bad_alloc&)
  {
    error = "Out of memory. Decimate the surface or process it in parts.";
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  vtkErrorMacro(<< error);
  this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
}
