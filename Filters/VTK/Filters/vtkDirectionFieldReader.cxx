// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldReader.h"

#include "Conversion/Input/GivenPolyData.h"
#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/FieldToPolyData.h"
#include "Conversion/Output/SingularityPoints.h"

#include <DirectionFields/Exchange/FieldImport.h>

#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkDirectionFieldReader);

namespace
{
// Where the phases of the progress end: reading the input and the file, laying the one on the
// other.
constexpr double ProgressRead = 0.3;
constexpr double ProgressImported = 0.8;

/// One line that describes the field.
std::string SummaryOf(const DirectionFields::Result& field)
{
  const auto& indices = field.SingularityIndex;
  const auto positive = std::count_if(indices.begin(), indices.end(), [](int k) { return k > 0; });
  const auto negative = std::count_if(indices.begin(), indices.end(), [](int k) { return k < 0; });
  return std::to_string(positive + negative) + " singularities (" + std::to_string(positive) +
    " +, " + std::to_string(negative) + " -), index sum " +
    std::to_string(std::accumulate(indices.begin(), indices.end(), 0)) + ", read from a file";
}
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
  if (!this->FileName || !*this->FileName)
  {
    throw std::invalid_argument(
      "There is no FileName. Choose a .rosy, .ffield, .rawfield or .obj file.");
  }
  DirectionFields::CheckPolyData(input);
  const DirectionFields::FieldFile file = DirectionFields::ReadFieldFile(this->FileName);
  const DirectionFields::TriangulatedPolyData surface =
    DirectionFields::PolyDataToSurface(input, progress.Part(0.0, ProgressRead));
  const DirectionFields::ImportedField imported = DirectionFields::ImportField(file, surface.Mesh,
    static_cast<DirectionFields::FieldOn>(this->FieldOn), DirectionFields::HasOnlyTriangles(input),
    progress.Part(ProgressRead, ProgressImported));
  this->Warn(imported.Warnings);
  output->ShallowCopy(input);
  DirectionFields::AddGivenField(
    surface, imported.Field, output, progress.Part(ProgressImported, 1.0));
  DirectionFields::AddReport(imported.Field.Repaired, imported.Warnings, output->GetFieldData());
  DirectionFields::MakeSingularPoints(surface, imported.Field,
    DirectionFields::FiguresOf(surface.Mesh, imported.Field.SingularityIndex),
    input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_FLOAT, singularities);
  const std::string summary = SummaryOf(imported.Field);
  for (vtkPolyData* const data : { output, singularities })
  {
    DirectionFields::AddSummary(summary, data->GetFieldData());
  }
}
