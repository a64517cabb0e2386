// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StrokeTool.h"

#include "PythonAction.h"
#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqQVTKWidget.h"
#include "pqRenderView.h"

#include <QCursor>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPainter>
#include <QStatusBar>
#include <QStringList>

namespace
{
/// A hand that clicks moves the mouse by up to so many pixels.
constexpr double CLICK = 3.0;

/// The way of the mouse, over the picture, until it is a stroke on the surface.
class StrokeLine : public QWidget
{
public:
  StrokeLine(QWidget* parent, const QPolygonF& path)
    : QWidget(parent)
    , Path(path)
  {
    this->setAttribute(Qt::WA_TransparentForMouseEvents);
    this->setAttribute(Qt::WA_NoSystemBackground);
    this->setGeometry(parent->rect());
    this->show();
    this->raise();
  }

protected:
  void paintEvent(QPaintEvent*) override
  {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(217, 115, 13), 3.0));
    painter.drawPolyline(this->Path);
  }

private:
  const QPolygonF& Path;
};

void Say(const QString& text)
{
  if (auto* const window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget()))
  {
    window->statusBar()->showMessage(text);
  }
}

QString Tuple(const QPointF& point)
{
  return QString("(%1, %2)").arg(point.x()).arg(point.y());
}
}

//------------------------------------------------------------------------------
StrokeTool* StrokeTool::instance()
{
  static QPointer<StrokeTool> tool;
  if (!tool)
  {
    tool = new StrokeTool(pqApplicationCore::instance());
  }
  return tool;
}

//------------------------------------------------------------------------------
StrokeTool::StrokeTool(QObject* parent)
  : QObject(parent)
{
  this->connect(&pqActiveObjects::instance(), SIGNAL(viewChanged(pqView*)), SLOT(follow()));
}

//------------------------------------------------------------------------------
void StrokeTool::setOn(bool on)
{
  if (on == this->IsOn)
  {
    return;
  }
  this->IsOn = on;
  this->follow();
  Say(on
      ? tr(
          "Drag over a surface to draw a stroke that its field follows; click on a stroke to select "
          "it; Delete takes that or the one under the mouse away, Escape ends drawing")
      : QString());
  emit this->toggled(on);
}

//------------------------------------------------------------------------------
void StrokeTool::follow()
{
  this->leave();
  auto* const view = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  this->View = view ? qobject_cast<pqQVTKWidget*>(view->widget()) : nullptr;
  if (this->IsOn && this->View)
  {
    this->View->renderWidget()->installEventFilter(this);
    this->View->setCursor(Qt::CrossCursor);
    // Keys go to the widget with the focus: Delete elsewhere would delete a filter.
    this->View->renderWidget()->setFocus();
  }
}

//------------------------------------------------------------------------------
void StrokeTool::leave()
{
  this->IsDrawing = false;
  delete this->Line;
  if (this->View)
  {
    this->View->renderWidget()->removeEventFilter(this);
    this->View->unsetCursor();
  }
}

//------------------------------------------------------------------------------
bool StrokeTool::eventFilter(QObject* object, QEvent* event)
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
bool StrokeTool::mouse(QMouseEvent* event)
{
  // Pressed soon after the last time, a button tells of a double click instead.
  const bool isPress =
    event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
  if (isPress && event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier)
  {
    delete this->Line;
    this->IsDrawing = true;
    this->Path = QPolygonF({ event->localPos() });
    this->Line = new StrokeLine(this->View, this->Path);
    this->View->renderWidget()->setFocus();
    return true;
  }
  if (!this->IsDrawing)
  {
    return false;
  }
  if (event->localPos() != this->Path.last())
  {
    this->Path << event->localPos();
    this->Line->update();
  }
  if (event->type() == QEvent::MouseButtonRelease && event->button() == Qt::LeftButton)
  {
    this->IsDrawing = false;
    delete this->Line;
    this->draw();
  }
  return true;
}

//------------------------------------------------------------------------------
bool StrokeTool::key(QKeyEvent* event)
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
    const QPointF place = this->pixel(this->View->renderWidget()->mapFromGlobal(QCursor::pos()));
    RunPythonAction(tr("Remove stroke"), QString("remove_stroke(%1)").arg(Tuple(place)));
  }
  else
  {
    this->setOn(false);
  }
  return true;
}

//------------------------------------------------------------------------------
void StrokeTool::draw()
{
  const QRectF box = this->Path.boundingRect();
  if (box.width() <= CLICK && box.height() <= CLICK)
  {
    RunPythonAction(
      tr("Select stroke"), QString("select_stroke(%1)").arg(Tuple(this->pixel(this->Path.last()))));
    return;
  }
  QStringList points;
  for (const QPointF& position : this->Path)
  {
    points << Tuple(this->pixel(position));
  }
  RunPythonAction(tr("Draw stroke"), QString("draw_stroke([%1])").arg(points.join(", ")));
}

//------------------------------------------------------------------------------
QPointF StrokeTool::pixel(const QPointF& position) const
{
  const double ratio = this->View->effectiveDevicePixelRatio();
  const double height = this->View->renderWidget()->height();
  return QPointF(position.x(), height - 1.0 - position.y()) * ratio;
}
