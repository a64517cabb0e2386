// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewTool.h"

#include "pqActiveObjects.h"
#include "pqCoreUtilities.h"
#include "pqQVTKWidget.h"
#include "pqRenderView.h"
#include "pqServer.h"

#include <QKeyEvent>
#include <QMainWindow>
#include <QMouseEvent>
#include <QStatusBar>

//------------------------------------------------------------------------------
ViewTool::ViewTool(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
bool ViewTool::eventFilter(QObject* object, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Enter:
      this->View->renderWidget()->setFocus();
      return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
      return this->mouse(static_cast<QMouseEvent*>(event));
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      return this->key(static_cast<QKeyEvent*>(event));
    default:
      return this->QObject::eventFilter(object, event);
  }
}

//------------------------------------------------------------------------------
bool ViewTool::key(QKeyEvent* event)
{
  const bool isDelete = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
  if (!isDelete && event->key() != Qt::Key_Escape)
  {
    return false;
  }
  if (event->type() == QEvent::ShortcutOverride)
  {
    // Not a shortcut of the window, which would delete a filter.
    event->accept();
  }
  else if (isDelete)
  {
    this->remove();
  }
  else
  {
    this->setOn(false);
  }
  return true;
}

//------------------------------------------------------------------------------
pqRenderView* ViewTool::attach()
{
  auto* const view = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  this->View = view ? qobject_cast<pqQVTKWidget*>(view->widget()) : nullptr;
  if (!this->View)
  {
    return nullptr;
  }
  this->View->renderWidget()->installEventFilter(this);
  // Keys go to the widget with the focus: Delete elsewhere would delete a filter.
  this->View->renderWidget()->setFocus();
  return view;
}

//------------------------------------------------------------------------------
void ViewTool::detach()
{
  if (this->View)
  {
    this->View->renderWidget()->removeEventFilter(this);
    this->View->unsetCursor();
  }
}

//------------------------------------------------------------------------------
QPointF ViewTool::pixel(const QPointF& position) const
{
  const double ratio = this->View->effectiveDevicePixelRatio();
  const double height = this->View->renderWidget()->height();
  return QPointF(position.x(), height - 1.0 - position.y()) * ratio;
}

//------------------------------------------------------------------------------
QPointF ViewTool::placeOf(const QMouseEvent* event)
{
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  return event->position();
#else
  return event->localPos();
#endif
}

//------------------------------------------------------------------------------
void ViewTool::say(const QString& text)
{
  if (auto* const window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget()))
  {
    window->statusBar()->showMessage(text);
  }
}

//------------------------------------------------------------------------------
bool ViewTool::isComputing()
{
  auto* const server = pqActiveObjects::instance().activeServer();
  return !server || server->isProgressPending();
}
