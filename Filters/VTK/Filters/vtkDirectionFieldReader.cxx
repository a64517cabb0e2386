// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldReader.h"

#include "Conversion/Input/GivenPolyData.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/SingularityPoints.h"

#include <DirectionFields/Exchange/FieldImport.h>
#include <DirectionFields/Reports/FieldSummary.h>

#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkDirectionFieldReader);

namespace
{
// Where the phases of the progress end: reading the input and the file, laying the one on the
// other.
constexpr double ProgressRead = 0.3;
constexpr double ProgressImported = 0.8;
}

//------------------------------------------------------------------------------
vtkDirectionFieldReader::vtkDirectionFieldReader()
  : FileName(nullptr)
  , FieldOn(AUTOMATIC)
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDirectionFieldReader::~vtkDirectionFieldReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FieldOn: " << this->FieldOn << "\n";
}

//------------------------------------------------------------------------------
void vtkDirectionFieldReader::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  auto* const input = vtkPolyData::SafeDownCast(inputs[0]);
  auto* const output = vtkPolyData::SafeDownCast(outputs[0]);
  auto* const singularities = vtkPolyData::SafeDownCast(outputs[1]);
  DirectionFields::CheckPolyData(input);
  if (!this->FileName || !*this->FileName)
  {
    // Windows apply the filter before a user can have chosen a file.
    this->Warn({ "Choose a File Name: that of a .rosy, .ffield, .rawfield or .obj file." });
    DirectionFields::CopyWithoutReports(input, output);
    Summarize("no file yet", { output, singularities });
    return;
  }
  const DirectionFields::FieldFile file = DirectionFields::ReadFieldFile(this->FileName);
  const DirectionFields::TriangulatedPolyData surface =
    DirectionFields::PolyDataToSurface(input, progress.Part(0.0, ProgressRead));
  const DirectionFields::ImportedField imported = DirectionFields::ImportField(file, surface.Mesh,
    static_cast<DirectionFields::FieldOn>(this->FieldOn), DirectionFields::HasOnlyTriangles(input),
    progress.Part(ProgressRead, ProgressImported));
  this->Warn(imported.Warnings);
  DirectionFields::CopyWithoutReports(input, output);
  DirectionFields::AddGivenField(
    surface, imported.Field, output, progress.Part(ProgressImported, 1.0));
  DirectionFields::AddReport(imported.Field.Repaired, imported.Warnings, output->GetFieldData());
  DirectionFields::MakeSingularPoints(surface, imported.Field,
    DirectionFields::FiguresOf(surface.Mesh, imported.Field.SingularityIndex),
    input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT, singularities);
  const std::string summary = DirectionFields::SummaryOfFile(imported.Field, this->FileName);
  Summarize(summary, { output, singularities });
}
