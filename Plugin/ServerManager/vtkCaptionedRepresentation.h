// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCaptionedRepresentation
 * @brief ParaView's display of geometry, with lines of words at the top left of the view
 *
 * The words are there while the display is visible. They come from its proxy
 * (vtkSMDirectionFieldRepresentationProxy), hence are drawn by the client only, which draws what is
 * written over a picture, wherever the rest is rendered.
 */

#ifndef vtkCaptionedRepresentation_h
#define vtkCaptionedRepresentation_h

#include "vtkDirectionFieldsServerManagerModule.h" // For export macro
#include "vtkPVCompositeRepresentation.h"
#include "vtkWeakPointer.h" // For the renderers

#include <string>
#include <vector>

class vtkRenderer;

class VTKDIRECTIONFIELDSSERVERMANAGER_EXPORT vtkCaptionedRepresentation
  : public vtkPVCompositeRepresentation
{
public:
  static vtkCaptionedRepresentation* New();
  vtkTypeMacro(vtkCaptionedRepresentation, vtkPVCompositeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the words are shown. Off by default.
   */
  void SetShowSummary(bool shown);
  vtkGetMacro(ShowSummary, bool);
  ///@}

  ///@{
  /**
   * The sentences, in lines as they are shown. None by default.
   */
  void SetSummary(const std::vector<std::string>& sentences);
  const std::vector<std::string>& GetSummary() const { return this->Summary; }
  ///@}

  void SetVisibility(bool visible) override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;

protected:
  vtkCaptionedRepresentation();
  ~vtkCaptionedRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  void UpdateCaption();

  bool ShowSummary = false;
  std::vector<std::string> Summary;
  /// The one that the words are drawn in, and the one whose background they are seen against.
  vtkWeakPointer<vtkRenderer> Front;
  vtkWeakPointer<vtkRenderer> Scene;

  vtkCaptionedRepresentation(const vtkCaptionedRepresentation&) = delete;
  void operator=(const vtkCaptionedRepresentation&) = delete;
};

#endif
