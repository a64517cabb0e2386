// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * While it is on, dragging with the left button over a 3-D view draws a stroke on the surface
 * below, which directionfields.draw_stroke() adds to the pipeline when the button is let go; a click
 * selects the stroke below, or none; a double click makes it soft, or hard again. The keys Delete
 * and Backspace take the selected stroke away, or the one under the mouse, or the last one. Other
 * buttons and the wheel move the camera as always; Escape ends it. On large surfaces the field is a
 * preview until the hand rests.
 */

#ifndef StrokeTool_h
#define StrokeTool_h

#include "ViewTool.h"

#include <QPointer>
#include <QPolygonF>
#include <QTimer>

class StrokeTool : public ViewTool
{
  Q_OBJECT

public:
  /// The one of the window.
  static StrokeTool* instance();

public slots:
  void setOn(bool on) override;

private slots:
  /// Goes over to the active view.
  void follow();
  /// Has previews computed whole.
  void finish();

private:
  explicit StrokeTool(QObject* parent);
  void leave();
  bool mouse(QMouseEvent* event) override;
  void remove() override;
  void draw();
  /// Calls a function of directionfields with these arguments as one step to undo; another one is
  /// not begun meanwhile.
  void run(const QString& step, const QString& function, const QString& arguments);

  bool IsDrawing = false;
  bool IsBusy = false;
  /// Whether the button has been pressed twice.
  bool IsDouble = false;
  QPolygonF Path;
  QPointer<QWidget> Line;
  /// Runs since the last change of a field that may be a preview.
  QTimer Rest;
};

#endif
