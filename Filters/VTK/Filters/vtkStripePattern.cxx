// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkStripePattern.h"

#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToField.h"
#include "Conversion/Input/PolyDataToGuidance.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/StripesToPolyData.h"
#include "Support/AlgorithmProgress.h"

#include <DirectionFields/Reports/DrawingReports.h>

#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <functional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkStripePattern);

namespace
{
// Where the phases of the progress end: reading the input, making the pattern.
constexpr double ProgressRead = 0.1;
constexpr double ProgressMade = 0.9;
}

//------------------------------------------------------------------------------
vtkStripePattern::vtkStripePattern()
{
  const DirectionFields::StripeOptions defaults;
  this->StripeDirection = static_cast<int>(defaults.Direction);
  this->Spacing = defaults.Spacing;
  this->SpacingArray = nullptr;
  this->LineOffset = defaults.LineOffset;
  this->Bands = defaults.Bands;
  this->TextureCoordinates = defaults.BandPhases;
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkStripePattern::~vtkStripePattern()
{
  this->SetSpacingArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkStripePattern::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StripeDirection: " << this->StripeDirection << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "SpacingArray: " << (this->SpacingArray ? this->SpacingArray : "(none)") << "\n";
  os << indent << "LineOffset: " << this->LineOffset << "\n";
  os << indent << "Bands: " << this->Bands << "\n";
  os << indent << "TextureCoordinates: " << this->TextureCoordinates << "\n";
}

//------------------------------------------------------------------------------
void vtkStripePattern::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  auto* const input = vtkPolyData::SafeDownCast(inputs[0]);
  DirectionFields::CheckPolyData(input);
  if (input->GetNumberOfPoints() == 0)
  {
    // There is nothing to cover, but cells without points are an error.
    DirectionFields::PolyDataToSurface(input);
    return;
  }
  const DirectionFields::PointDirections directions = DirectionFields::RequireDirections(input);
  if (directions.Degree > 2)
  {
    // The field that Direction Field gives as it comes is such a one.
    const std::string number = std::to_string(directions.Degree);
    this->Warn({ "Stripes follow a field of one or two directions per point, and this one is of "
                 "degree " +
      number + ". Set Directions Per Point (Degree) of Direction Field to 2." });
    // The surface is still to be seen, with its directions.
    vtkPolyData* const bands = vtkPolyData::SafeDownCast(outputs[1]);
    if (this->Bands)
    {
      bands->ShallowCopy(input);
    }
    Summarize("no stripes, for the field has " + number +
        " directions per point: set Directions Per Point of Direction Field to 2",
      outputs);
    return;
  }
  const std::vector<double> spacings =
    DirectionFields::PointValues(input, this->SpacingArray, "Spacing Array");
  const DirectionFields::TriangulatedPolyData surface =
    DirectionFields::PolyDataToSurface(input, progress.Part(0.0, 0.5 * ProgressRead));
  const DirectionFields::GivenField field(surface.Mesh, directions);
  DirectionFields::StripeOptions options;
  options.Direction = static_cast<DirectionFields::StripeDirection>(this->StripeDirection);
  options.Spacing = this->Spacing;
  options.LineOffset = this->LineOffset;
  options.Bands = this->Bands;
  options.BandPhases = this->TextureCoordinates;
  std::function<double(DirectionFields::Index)> spacing;
  if (!spacings.empty())
  {
    spacing = [&spacings](DirectionFields::Index point) { return spacings[point]; };
  }
  const DirectionFields::StripePattern pattern = DirectionFields::MakeStripes(
    field, options, spacing, DirectionFields::ReportTo(this, ProgressRead, ProgressMade));
  this->ThrowIfStopped(pattern.Aborted);
  this->Warn(DirectionFields::Warnings(pattern, options));
  const int type = input->GetPoints()->GetDataType();
  DirectionFields::AddStripeLines(pattern, type, vtkPolyData::SafeDownCast(outputs[0]));
  DirectionFields::AddStripeBands(input, surface, pattern, vtkPolyData::SafeDownCast(outputs[1]));
  DirectionFields::AddStripeSingularities(
    surface, pattern, type, vtkPolyData::SafeDownCast(outputs[2]));
  const std::string summary = DirectionFields::Summary(pattern);
  Summarize(summary, outputs);
}

//------------------------------------------------------------------------------
const char* vtkStripePattern::MemoryAdvice() const
{
  return "Raise Spacing, turn Bands off, or decimate the surface";
}
