// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldRepresentation.h"

#include "ConstraintLines.h"
#include "vtkDirectionFieldGlyphs.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkDirectionFieldRepresentation);

namespace
{
// The colour that the display of Direction Field Glyphs begins with.
constexpr double Teal[3] = { 0.0, 0.42, 0.46 };
// That of the strokes of Guidance From Curves.
constexpr double Orange[3] = { 0.85, 0.45, 0.05 };
constexpr float LineWidth = 3.0F;
// The surface is the data of port 0.
constexpr int GlyphPort = 1;
constexpr int LinePort = 2;
}

//------------------------------------------------------------------------------
vtkDirectionFieldRepresentation::vtkDirectionFieldRepresentation()
{
  for (Part* const part : { &this->Glyphs, &this->Lines })
  {
    part->Mapper->ScalarVisibilityOff();
    part->Actor->SetMapper(part->Mapper);
    // A click selects cells of the surface.
    part->Actor->PickableOff();
  }
  this->Glyphs.Actor->GetProperty()->SetColor(Teal[0], Teal[1], Teal[2]);
  this->Glyphs.Actor->GetProperty()->SetAmbient(0.3);
  this->Lines.Actor->GetProperty()->SetColor(Orange[0], Orange[1], Orange[2]);
  this->Lines.Actor->GetProperty()->SetLineWidth(LineWidth);
  this->Lines.Actor->GetProperty()->LightingOff();
}

//------------------------------------------------------------------------------
vtkDirectionFieldRepresentation::~vtkDirectionFieldRepresentation() = default;

//------------------------------------------------------------------------------
void vtkDirectionFieldRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
bool vtkDirectionFieldRepresentation::AddBlock(
  vtkPolyData* block, std::size_t number, vtkAppendPolyData* glyphs, vtkAppendPolyData* lines)
{
  vtkDataArray* const direction = block ? block->GetPointData()->GetArray("Direction0") : nullptr;
  if (!direction || direction->GetNumberOfComponents() != 3)
  {
    return false;
  }
  if (number == this->Filters.size())
  {
    this->Filters.push_back(vtkSmartPointer<vtkDirectionFieldGlyphs>::New());
  }
  // The pipeline of the block's own filter must not be asked from here.
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(block);
  this->Filters[number]->SetInputData(copy);
  this->Filters[number]->Update();
  glyphs->AddInputData(this->Filters[number]->GetOutput());
  lines->AddInputData(ConstraintLines(copy));
  return true;
}

//------------------------------------------------------------------------------
int vtkDirectionFieldRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[0], 0)
    : nullptr;
  vtkNew<vtkAppendPolyData> glyphs;
  vtkNew<vtkAppendPolyData> lines;
  std::size_t blocks = 0;
  const auto add = [&](vtkDataObject* data)
  {
    auto* const block = vtkPolyData::SafeDownCast(data);
    blocks += this->AddBlock(block, blocks, glyphs, lines) ? 1 : 0;
  };
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      add(at->GetCurrentDataObject());
    }
  }
  else
  {
    add(input);
  }
  this->Filters.resize(blocks);
  this->Glyphs.Data->Initialize();
  this->Lines.Data->Initialize();
  if (blocks > 0)
  {
    glyphs->Update();
    lines->Update();
    // The mappers need points, cells and normals only.
    vtkPolyData* const all = glyphs->GetOutput();
    this->Glyphs.Data->CopyStructure(all);
    this->Glyphs.Data->GetPointData()->SetNormals(all->GetPointData()->GetNormals());
    this->Lines.Data->CopyStructure(lines->GetOutput());
  }
  this->Glyphs.Data->Modified();
  this->Lines.Data->Modified();
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkDirectionFieldRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  if (!this->Superclass::ProcessViewRequest(request, input, output))
  {
    this->Glyphs.Actor->VisibilityOff();
    this->Lines.Actor->VisibilityOff();
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(input, this, this->Glyphs.Data, 0, GlyphPort);
    vtkPVView::SetPiece(input, this, this->Lines.Data, 0, LinePort);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->Glyphs.Mapper->SetInputConnection(
      vtkPVRenderView::GetPieceProducer(input, this, GlyphPort));
    this->Lines.Mapper->SetInputConnection(
      vtkPVRenderView::GetPieceProducer(input, this, LinePort));
    // The user may have hidden or moved the surface.
    vtkPVLODActor* const surface = this->GetRenderedProp();
    for (vtkActor* const actor : { this->Glyphs.Actor.Get(), this->Lines.Actor.Get() })
    {
      actor->SetVisibility(surface->GetVisibility());
      actor->SetOrigin(surface->GetOrigin());
      actor->SetPosition(surface->GetPosition());
      actor->SetOrientation(surface->GetOrientation());
      actor->SetScale(surface->GetScale());
      actor->SetUserTransform(surface->GetUserTransform());
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkDirectionFieldRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Glyphs.Actor->SetVisibility(visible);
  this->Lines.Actor->SetVisibility(visible);
}

//------------------------------------------------------------------------------
bool vtkDirectionFieldRepresentation::AddToView(vtkView* view)
{
  auto* const renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetRenderer()->AddActor(this->Glyphs.Actor);
    renderView->GetRenderer()->AddActor(this->Lines.Actor);
  }
  return renderView && this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkDirectionFieldRepresentation::RemoveFromView(vtkView* view)
{
  auto* const renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetRenderer()->RemoveActor(this->Glyphs.Actor);
    renderView->GetRenderer()->RemoveActor(this->Lines.Actor);
  }
  return renderView && this->Superclass::RemoveFromView(view);
}
