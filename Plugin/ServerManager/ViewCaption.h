// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class ViewCaption
 * @brief the lines at the top left of a view, which its displays share
 *
 * Each display has a place of its own, in the order in which they came, so that the lines of one do
 * not lie upon those of another.
 */

#ifndef ViewCaption_h
#define ViewCaption_h

#include "vtkTextActor.h"

#include <string>
#include <utility>
#include <vector>

class vtkRenderer;

class ViewCaption : public vtkTextActor
{
public:
  static ViewCaption* New();
  vtkTypeMacro(ViewCaption, vtkTextActor);

  /// The caption of a renderer, which has one from the first call on.
  static ViewCaption* Of(vtkRenderer* renderer);

  /// Shows the sentences of a display in its place, each in lines of its own; what another display
  /// says before is left out. None: nothing is shown, and the place is kept.
  void SetSentences(const void* display, const std::vector<std::string>& sentences);

  /// Gives up the place of a display.
  void Remove(const void* display);

  /// Makes the words dark on light, and light on dark.
  void ContrastWith(const double background[3]);

protected:
  ViewCaption();
  ~ViewCaption() override = default;

private:
  void Rewrite();

  std::vector<std::pair<const void*, std::vector<std::string>>> Places;

  ViewCaption(const ViewCaption&) = delete;
  void operator=(const ViewCaption&) = delete;
};

#endif
