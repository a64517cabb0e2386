// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewCaption.h"

#include "vtkCoordinate.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <set>

vtkStandardNewMacro(ViewCaption);

namespace
{
// Points, as the summary of the button's picture.
constexpr int FontSize = 14;
/// A surface behind the sentences is seen through their ground, and they are read on any surface.
constexpr double GroundOpacity = 0.8;
}

//------------------------------------------------------------------------------
ViewCaption::ViewCaption()
{
  this->VisibilityOff();
  this->PickableOff();
  this->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->SetPosition(0.01, 0.985);
  vtkTextProperty* const text = this->GetTextProperty();
  text->SetJustificationToLeft();
  text->SetVerticalJustificationToTop();
  text->SetFontSize(FontSize);
  text->SetBackgroundOpacity(GroundOpacity);
}

//------------------------------------------------------------------------------
ViewCaption* ViewCaption::Of(vtkRenderer* renderer)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* const prop = props->GetNextProp(at))
  {
    if (auto* const caption = dynamic_cast<ViewCaption*>(prop))
    {
      return caption;
    }
  }
  vtkNew<ViewCaption> caption;
  renderer->AddActor(caption);
  return caption;
}

//------------------------------------------------------------------------------
void ViewCaption::SetSentences(const void* display, const std::vector<std::string>& sentences)
{
  const auto place = std::find_if(this->Places.begin(), this->Places.end(),
    [&](const auto& one) { return one.first == display; });
  if (place == this->Places.end())
  {
    this->Places.emplace_back(display, sentences);
  }
  else if (place->second == sentences)
  {
    return;
  }
  else
  {
    place->second = sentences;
  }
  this->Rewrite();
}

//------------------------------------------------------------------------------
void ViewCaption::Remove(const void* display)
{
  this->Places.erase(std::remove_if(this->Places.begin(), this->Places.end(),
                       [&](const auto& one) { return one.first == display; }),
    this->Places.end());
  this->Rewrite();
}

//------------------------------------------------------------------------------
void ViewCaption::Rewrite()
{
  std::string text;
  std::set<std::string> written;
  for (const auto& [display, sentences] : this->Places)
  {
    for (const std::string& sentence : sentences)
    {
      if (written.count(sentence) == 0)
      {
        text += (text.empty() ? "" : "\n") + sentence;
      }
    }
    // Only now, for blocks of one display may have the same summary.
    written.insert(sentences.begin(), sentences.end());
  }
  this->SetInput(text.c_str());
  this->SetVisibility(!text.empty());
}

//------------------------------------------------------------------------------
void ViewCaption::ContrastWith(const double background[3])
{
  const double ink = background[0] + background[1] + background[2] > 1.5 ? 0.15 : 1.0;
  this->GetTextProperty()->SetColor(ink, ink, ink);
  this->GetTextProperty()->SetBackgroundColor(background[0], background[1], background[2]);
}
