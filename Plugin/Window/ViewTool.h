// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A tool of the mouse in the active 3-D view. While it is attached, the buttons of the mouse, Delete,
 * Backspace and Escape, which switches it off, come to it before the view and the window have them.
 */

#ifndef ViewTool_h
#define ViewTool_h

#include <QObject>
#include <QPointF>
#include <QPointer>

class QKeyEvent;
class QMouseEvent;
class pqQVTKWidget;
class pqRenderView;

class ViewTool : public QObject
{
  Q_OBJECT

public:
  bool eventFilter(QObject* object, QEvent* event) override;

public slots:
  virtual void setOn(bool on) = 0;

signals:
  void toggled(bool on);

protected:
  explicit ViewTool(QObject* parent);
  /// Returns the view, or null where the active one is none of 3-D.
  pqRenderView* attach();
  void detach();
  /// Returns whether the view does not get the event.
  virtual bool mouse(QMouseEvent* event) = 0;
  /// The key Delete or Backspace.
  virtual void remove() = 0;
  /// From the upper left corner of the view, in pixels of the screen's scale.
  static QPointF placeOf(const QMouseEvent* event);
  /// From the lower left corner of the view.
  QPointF pixel(const QPointF& position) const;
  static void say(const QString& text);
  /// Whether ParaView is computing. It shows its progress, during which events arrive, and nothing
  /// else may begin.
  static bool isComputing();

  bool IsOn = false;
  QPointer<pqQVTKWidget> View;

private:
  bool key(QKeyEvent* event);
};

#endif
