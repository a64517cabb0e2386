// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCaptionedRepresentation.h"

#include "ViewCaption.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkCaptionedRepresentation);

//------------------------------------------------------------------------------
vtkCaptionedRepresentation::vtkCaptionedRepresentation() = default;
vtkCaptionedRepresentation::~vtkCaptionedRepresentation() = default;

//------------------------------------------------------------------------------
void vtkCaptionedRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShowSummary: " << this->ShowSummary << "\n";
  for (const std::string& sentence : this->Summary)
  {
    os << indent << "Summary: " << sentence << "\n";
  }
}

//------------------------------------------------------------------------------
void vtkCaptionedRepresentation::SetShowSummary(bool shown)
{
  this->ShowSummary = shown;
  this->UpdateCaption();
}

//------------------------------------------------------------------------------
void vtkCaptionedRepresentation::SetSummary(const std::vector<std::string>& sentences)
{
  this->Summary = sentences;
  this->UpdateCaption();
}

//------------------------------------------------------------------------------
void vtkCaptionedRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->UpdateCaption();
}

//------------------------------------------------------------------------------
void vtkCaptionedRepresentation::UpdateCaption()
{
  if (this->Front)
  {
    const bool isShown = this->ShowSummary && this->GetVisibility();
    ViewCaption::Of(this->Front)
      ->SetSentences(this, isShown ? this->Summary : std::vector<std::string>());
  }
}

//------------------------------------------------------------------------------
int vtkCaptionedRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  if (request == vtkPVView::REQUEST_RENDER() && this->Front && this->Scene)
  {
    ViewCaption::Of(this->Front)->ContrastWith(this->Scene->GetBackground());
  }
  return this->Superclass::ProcessViewRequest(request, input, output);
}

//------------------------------------------------------------------------------
bool vtkCaptionedRepresentation::AddToView(vtkView* view)
{
  if (auto* const renderView = vtkPVRenderView::SafeDownCast(view))
  {
    this->Front = renderView->GetNonCompositedRenderer();
    this->Scene = renderView->GetRenderer();
    this->UpdateCaption();
  }
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkCaptionedRepresentation::RemoveFromView(vtkView* view)
{
  if (this->Front)
  {
    ViewCaption::Of(this->Front)->Remove(this);
    this->Front = nullptr;
    this->Scene = nullptr;
  }
  return this->Superclass::RemoveFromView(view);
}
