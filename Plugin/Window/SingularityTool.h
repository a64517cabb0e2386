// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * While it is on, the singularities of the selected field are handles in the active view: dragging
 * one with the left button moves it along the surface, and its field follows, at each move where
 * that takes less than a fifth of a second, or else at each pause; Shift and the left button
 * open a menu of what can be added there, and the keys Delete and Backspace take the one under
 * the mouse away. Other drags move the camera as always; Escape ends it. What is done stands in
 * directionfields.singularities; each change is one step to undo and one line of a trace.
 */

#ifndef SingularityTool_h
#define SingularityTool_h

#include "ViewTool.h"
#include "vtkSMProxy.h"
#include "vtkWeakPointer.h"

#include <QPointF>
#include <QTimer>

class SingularityTool : public ViewTool
{
  Q_OBJECT

public:
  /// The one of the window.
  static SingularityTool* instance();

public slots:
  void setOn(bool on) override;

private slots:
  /// The handles are in one view only: the tool is switched off with it.
  void end();
  void drag();
  void refresh();

private:
  explicit SingularityTool(QObject* parent);
  /// Listens to the active view.
  void follow();
  void leave();
  bool mouse(QMouseEvent* event) override;
  void remove() override;
  void offer(const QPointF& position);
  void drop();
  /// Calls a function of directionfields.singularities; the answer is a sentence for the user.
  QString ask(const QString& call);
  /// The same where nothing is edited.
  QString look(const QString& call);
  /// The same as one step to undo.
  void change(const QString& step, const QString& call);
  void record();
  QString place(const QPointF& position) const;

  bool IsDragging = false;
  bool IsBusy = false;
  bool IsSlow = false;
  bool HasMoved = false;
  /// The filter whose singularities are edited.
  vtkWeakPointer<vtkSMProxy> Edited;
  QPointF Mouse;
  QTimer Move;
  QTimer Refresh;
  QMetaObject::Connection Rendered;
};

#endif
