// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkDirectionFieldRepresentation.h"

#include "vtkDirectionFieldGlyphs.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
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
// The surface is the data of port 0.
constexpr int GlyphPort = 1;
}

//------------------------------------------------------------------------------
vtkDirectionFieldRepresentation::vtkDirectionFieldRepresentation()
{
  this->GlyphMapper->ScalarVisibilityOff();
  this->GlyphActor->SetMapper(this->GlyphMapper);
  this->GlyphActor->GetProperty()->SetColor(Teal[0], Teal[1], Teal[2]);
  this->GlyphActor->GetProperty()->SetAmbient(0.3);
  // A click selects cells of the surface.
  this->GlyphActor->PickableOff();
}

//------------------------------------------------------------------------------
vtkDirectionFieldRepresentation::~vtkDirectionFieldRepresentation() = default;

//------------------------------------------------------------------------------
void vtkDirectionFieldRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkDirectionFieldRepresentation::GlyphsOf(vtkPolyData* block, std::size_t number)
{
  vtkDataArray* const direction = block ? block->GetPointData()->GetArray("Direction0") : nullptr;
  if (!direction || direction->GetNumberOfComponents() != 3)
  {
    return nullptr;
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
  return this->Filters[number]->GetOutput();
}

//------------------------------------------------------------------------------
int vtkDirectionFieldRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* const input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[0], 0)
    : nullptr;
  vtkNew<vtkAppendPolyData> all;
  std::size_t blocks = 0;
  const auto add = [&](vtkDataObject* data)
  {
    if (vtkPolyData* const glyphs = this->GlyphsOf(vtkPolyData::SafeDownCast(data), blocks))
    {
      all->AddInputData(glyphs);
      ++blocks;
    }
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
  this->Glyphs->Initialize();
  if (blocks > 0)
  {
    all->Update();
    // The mapper needs points, cells and normals only.
    this->Glyphs->CopyStructure(all->GetOutput());
    this->Glyphs->GetPointData()->SetNormals(all->GetOutput()->GetPointData()->GetNormals());
  }
  this->Glyphs->Modified();
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkDirectionFieldRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  if (!this->Superclass::ProcessViewRequest(request, input, output))
  {
    this->GlyphActor->VisibilityOff();
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVView::SetPiece(input, this, this->Glyphs, 0, GlyphPort);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->GlyphMapper->SetInputConnection(
      vtkPVRenderView::GetPieceProducer(input, this, GlyphPort));
    // The user may have hidden or moved the surface.
    vtkPVLODActor* const surface = this->GetRenderedProp();
    this->GlyphActor->SetVisibility(surface->GetVisibility());
    this->GlyphActor->SetOrigin(surface->GetOrigin());
    this->GlyphActor->SetPosition(surface->GetPosition());
    this->GlyphActor->SetOrientation(surface->GetOrientation());
    this->GlyphActor->SetScale(surface->GetScale());
    this->GlyphActor->SetUserTransform(surface->GetUserTransform());
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkDirectionFieldRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->GlyphActor->SetVisibility(visible);
}

//------------------------------------------------------------------------------
bool vtkDirectionFieldRepresentation::AddToView(vtkView* view)
{
  auto* const renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetRenderer()->AddActor(this->GlyphActor);
  }
  return renderView && this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkDirectionFieldRepresentation::RemoveFromView(vtkView* view)
{
  auto* const renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetRenderer()->RemoveActor(this->GlyphActor);
  }
  return renderView && this->Superclass::RemoveFromView(view);
}
