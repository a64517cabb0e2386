// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldGlyphs.h"

#include "Conversion/Input/PolyDataCheck.h"
#include "Conversion/Input/PolyDataToField.h"
#include "Conversion/Input/PolyDataToSurface.h"
#include "Conversion/Output/GlyphsToPolyData.h"
#include "Support/AlgorithmProgress.h"
#include "Support/GlyphSurfaceCache.h"

#include <DirectionFields/Reports/DrawingReports.h>

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkDirectionFieldGlyphs);

namespace
{
// Where the phases of the progress end: reading the input, making the glyphs.
constexpr double ProgressRead = 0.2;
constexpr double ProgressDrawn = 0.9;
}

//------------------------------------------------------------------------------
vtkDirectionFieldGlyphs::vtkDirectionFieldGlyphs()
  : Surfaces(std::make_unique<DirectionFields::GlyphSurfaceCache>())
{
  const DirectionFields::GlyphOptions defaults;
  this->GlyphType = static_cast<int>(defaults.Type);
  this->GlyphMode = static_cast<int>(defaults.Mode);
  this->Side = static_cast<int>(defaults.Side);
  this->Spacing = defaults.Spacing;
  this->MaximumNumberOfGlyphs = defaults.MaximumNumber;
  this->Scale = defaults.Scale;
  this->Offset = defaults.Offset;
  this->FollowSurface = defaults.FollowSurface;
  // The pipeline says when an input begins and ends, and newer ones do for each of its blocks, too.
  // Each block is a call of RequestData.
  this->AddObserver(vtkCommand::StartEvent, this, &vtkDirectionFieldGlyphs::BeginBlocks);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkDirectionFieldGlyphs::EndBlocks);
}

//------------------------------------------------------------------------------
vtkDirectionFieldGlyphs::~vtkDirectionFieldGlyphs() = default;

//------------------------------------------------------------------------------
void vtkDirectionFieldGlyphs::BeginBlocks()
{
  if (this->BlockDepth++ == 0)
  {
    this->Surfaces->Begin();
  }
}

//------------------------------------------------------------------------------
void vtkDirectionFieldGlyphs::EndBlocks()
{
  if (--this->BlockDepth == 0)
  {
    this->Surfaces->End();
  }
}

//------------------------------------------------------------------------------
void vtkDirectionFieldGlyphs::ReleaseSurfaces()
{
  *this->Surfaces = {};
}

//------------------------------------------------------------------------------
void vtkDirectionFieldGlyphs::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GlyphType: " << this->GlyphType << "\n";
  os << indent << "GlyphMode: " << this->GlyphMode << "\n";
  os << indent << "Side: " << this->Side << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "MaximumNumberOfGlyphs: " << this->MaximumNumberOfGlyphs << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "FollowSurface: " << this->FollowSurface << "\n";
}

//------------------------------------------------------------------------------
DirectionFields::GlyphOptions vtkDirectionFieldGlyphs::MakeOptions() const
{
  DirectionFields::GlyphOptions options;
  options.Type = static_cast<DirectionFields::GlyphType>(this->GlyphType);
  options.Mode = static_cast<DirectionFields::GlyphMode>(this->GlyphMode);
  options.Side = static_cast<DirectionFields::GlyphSide>(this->Side);
  options.Spacing = this->Spacing;
  options.MaximumNumber = this->MaximumNumberOfGlyphs;
  options.Scale = this->Scale;
  options.Offset = this->Offset;
  options.FollowSurface = this->FollowSurface;
  return options;
}

//------------------------------------------------------------------------------
void vtkDirectionFieldGlyphs::Execute(
  const Ports& inputs, const Ports& outputs, const DirectionFields::Progress& progress)
{
  auto* const input = vtkPolyData::SafeDownCast(inputs[0]);
  DirectionFields::CheckPolyData(input);
  if (input->GetNumberOfPoints() == 0)
  {
    // Nothing to draw, but cells without points are an error.
    DirectionFields::PolyDataToSurface(input);
    return;
  }
  const DirectionFields::PointDirections field = DirectionFields::RequireDirections(input);
  if (this->BlockDepth == 0)
  {
    // Somebody has removed the observers: there is one block, as far as can be told.
    this->Surfaces->Begin();
  }
  DirectionFields::GlyphSurface& surface =
    this->Surfaces->Next(input, progress.Part(0.0, ProgressRead));
  const DirectionFields::Glyphs glyphs = DirectionFields::MakeGlyphs(surface, field,
    this->MakeOptions(), DirectionFields::ReportTo(this, ProgressRead, ProgressDrawn));
  this->ThrowIfStopped(glyphs.Aborted);
  DirectionFields::AddGlyphs(
    glyphs, input->GetPoints()->GetDataType(), input, vtkPolyData::SafeDownCast(outputs[0]));
  Summarize(DirectionFields::Summary(glyphs), outputs);
}

//------------------------------------------------------------------------------
void vtkDirectionFieldGlyphs::Release(bool hasFailed)
{
  if (hasFailed)
  {
    // The surfaces that are kept may take the memory that is too little.
    this->ReleaseSurfaces();
  }
}

//------------------------------------------------------------------------------
const char* vtkDirectionFieldGlyphs::MemoryAdvice() const
{
  return "Lower Maximum Number Of Glyphs or decimate the surface";
}
