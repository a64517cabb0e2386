// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StrokeTool.h"

#include "PythonAction.h"
#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqQVTKWidget.h"
#include "pqUndoStack.h"

#include <QCursor>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>

namespace
{
/// A hand that clicks moves the mouse by up to so many pixels.
constexpr double CLICK = 3.0;
/// A hand that has drawn nothing for so many milliseconds rests.
constexpr int PAUSE = 800;

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
  : ViewTool(parent)
{
  this->connect(&pqActiveObjects::instance(), SIGNAL(viewChanged(pqView*)), SLOT(follow()));
  this->Rest.setSingleShot(true);
  this->Rest.setInterval(PAUSE);
  this->connect(&this->Rest, &QTimer::timeout, this, &StrokeTool::finish);
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
  ViewTool::say(on
      ? tr(
          "Drag over a surface to draw a stroke that its field follows; click on a stroke to select "
          "it, double-click to make it soft or hard; Delete takes that or the one under the mouse "
          "away, Escape ends drawing")
      : QString());
  emit this->toggled(on);
}

//------------------------------------------------------------------------------
void StrokeTool::follow()
{
  this->leave();
  if (this->IsOn && this->attach())
  {
    this->View->setCursor(Qt::CrossCursor);
  }
}

//------------------------------------------------------------------------------
void StrokeTool::finish()
{
  if (this->IsDrawing || this->IsBusy || ViewTool::isComputing())
  {
    this->Rest.start();
    return;
  }
  RunPythonBetweenSteps(tr("Draw strokes"), "preview.finish()");
}

//------------------------------------------------------------------------------
void StrokeTool::leave()
{
  this->IsDrawing = false;
  delete this->Line;
  this->detach();
}

//------------------------------------------------------------------------------
bool StrokeTool::mouse(QMouseEvent* event)
{
  // Pressed soon after the last time, a button tells of a double click instead.
  const bool isPress =
    event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
  if (isPress && event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier)
  {
    if (this->IsBusy || ViewTool::isComputing())
    {
      ViewTool::say(tr("Wait until ParaView has computed, then draw"));
      return true;
    }
    delete this->Line;
    this->IsDrawing = true;
    this->IsDouble = event->type() == QEvent::MouseButtonDblClick;
    this->Path = QPolygonF({ ViewTool::placeOf(event) });
    this->Line = new StrokeLine(this->View, this->Path);
    this->View->renderWidget()->setFocus();
    return true;
  }
  if (!this->IsDrawing)
  {
    return false;
  }
  if (event->type() == QEvent::MouseMove && !(event->buttons() & Qt::LeftButton))
  {
    // Another window, or a computation, has had the release.
    this->IsDrawing = false;
    delete this->Line;
    return false;
  }
  if (ViewTool::placeOf(event) != this->Path.last())
  {
    this->Path << ViewTool::placeOf(event);
    this->Line->update();
  }
  if (event->type() == QEvent::MouseButtonRelease && event->button() == Qt::LeftButton)
  {
    this->IsDrawing = false;
    // The way stays to be seen until the picture with the stroke is there.
    this->draw();
    delete this->Line;
  }
  return true;
}

//------------------------------------------------------------------------------
void StrokeTool::remove()
{
  const QPointF place = this->pixel(this->View->renderWidget()->mapFromGlobal(QCursor::pos()));
  this->run(tr("Remove stroke"), "remove_stroke", Tuple(place));
}

//------------------------------------------------------------------------------
void StrokeTool::run(const QString& step, const QString& function, const QString& arguments)
{
  if (this->IsBusy || ViewTool::isComputing())
  {
    return;
  }
  this->IsBusy = true;
  RunPythonAction(
    step, QString("preview.previewed(directionfields.%1, %2)").arg(function, arguments));
  this->IsBusy = false;
  this->Rest.start();
  // Undo and redo bring previews back.
  if (pqUndoStack* const stack = pqApplicationCore::instance()->getUndoStack())
  {
    this->connect(stack, &pqUndoStack::stackChanged, &this->Rest, qOverload<>(&QTimer::start),
      Qt::UniqueConnection);
  }
}

//------------------------------------------------------------------------------
void StrokeTool::draw()
{
  const QRectF box = this->Path.boundingRect();
  if (box.width() <= CLICK && box.height() <= CLICK)
  {
    const QString place = Tuple(this->pixel(this->Path.last()));
    if (this->IsDouble)
    {
      this->run(tr("Make stroke soft or hard"), "toggle_stroke", place);
    }
    else
    {
      this->run(tr("Select stroke"), "select_stroke", place);
    }
    return;
  }
  QStringList points;
  for (const QPointF& position : this->Path)
  {
    points << Tuple(this->pixel(position));
  }
  this->run(tr("Draw stroke"), "draw_stroke", QString("[%1]").arg(points.join(", ")));
}
