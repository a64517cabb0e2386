// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPython.h" // Must come first.

#include "SingularityTool.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqQVTKWidget.h"
#include "pqRenderView.h"
#include "pqUndoStack.h"
#include "vtkPythonInterpreter.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMenu>
#include <QMouseEvent>

namespace
{
/// In milliseconds: a field that takes longer follows the mouse at its pauses.
constexpr qint64 SLOW = 200;
constexpr int PAUSE = 250;

/// The text that an expression of Python gives.
QString Evaluate(const QString& expression)
{
  const QString script = QString("_directionfields_answer = ''\n"
                                 "try:\n"
                                 "  import paraview.simple\n"
                                 "  import directionfields.singularities\n"
                                 "  _directionfields_answer = directionfields.singularities.%1\n"
                                 "except ImportError as problem:\n"
                                 "  _directionfields_answer = str(problem)\n")
                           .arg(expression);
  vtkPythonInterpreter::RunSimpleString(script.toUtf8().constData());
  vtkPythonScopeGilEnsurer lock;
  PyObject* const answer =
    PyObject_GetAttrString(PyImport_AddModule("__main__"), "_directionfields_answer");
  const char* const text = answer && PyUnicode_Check(answer) ? PyUnicode_AsUTF8(answer) : nullptr;
  const QString found = text ? QString::fromUtf8(text) : QString();
  Py_XDECREF(answer);
  PyErr_Clear();
  return found;
}
}

//------------------------------------------------------------------------------
SingularityTool* SingularityTool::instance()
{
  static QPointer<SingularityTool> tool;
  if (!tool)
  {
    tool = new SingularityTool(pqApplicationCore::instance());
  }
  return tool;
}

//------------------------------------------------------------------------------
SingularityTool::SingularityTool(QObject* parent)
  : ViewTool(parent)
{
  this->Move.setSingleShot(true);
  this->Refresh.setSingleShot(true);
  this->connect(&this->Move, &QTimer::timeout, this, &SingularityTool::drag);
  this->connect(&this->Refresh, &QTimer::timeout, this, &SingularityTool::refresh);
  this->connect(&pqActiveObjects::instance(), SIGNAL(viewChanged(pqView*)), SLOT(end()));
}

//------------------------------------------------------------------------------
void SingularityTool::setOn(bool on)
{
  if (on == this->IsOn)
  {
    return;
  }
  if (this->IsBusy)
  {
    emit this->toggled(this->IsOn);
    return;
  }
  this->IsOn = on;
  QString problem;
  if (on)
  {
    BEGIN_UNDO_SET(tr("Edit singularities"));
    problem = this->ask("begin()");
    END_UNDO_SET();
    this->IsOn = problem.isEmpty();
    pqPipelineSource* const source = pqActiveObjects::instance().activeSource();
    this->Edited = source ? source->getProxy() : nullptr;
  }
  else
  {
    this->ask("end()");
  }
  this->follow();
  ViewTool::say(!on ? QString()
      : !problem.isEmpty()
      ? problem
      : tr("Drag a singularity along the surface; Shift-click adds some, Delete takes the one "
           "under the mouse away, Escape ends editing"));
  emit this->toggled(this->IsOn);
}

//------------------------------------------------------------------------------
void SingularityTool::follow()
{
  this->leave();
  pqRenderView* const view = this->IsOn ? this->attach() : nullptr;
  if (view)
  {
    this->View->renderWidget()->setMouseTracking(true);
    // The camera, or properties in the panel, may have changed.
    this->Rendered = this->connect(view, &pqView::endRender, this,
      [this]
      {
        if (!this->IsBusy && !this->IsDragging)
        {
          this->Refresh.start(PAUSE);
        }
      });
  }
}

//------------------------------------------------------------------------------
void SingularityTool::end()
{
  if (!this->IsBusy)
  {
    this->setOn(false);
  }
}

//------------------------------------------------------------------------------
void SingularityTool::leave()
{
  this->drop();
  this->Refresh.stop();
  this->detach();
  QObject::disconnect(this->Rendered);
}

//------------------------------------------------------------------------------
bool SingularityTool::mouse(QMouseEvent* event)
{
  this->Mouse = ViewTool::placeOf(event);
  if (this->IsDragging)
  {
    if (event->type() == QEvent::MouseMove && !(event->buttons() & Qt::LeftButton))
    {
      // Another window, or a computation, has had the release.
      this->drop();
    }
    else if (event->type() == QEvent::MouseMove)
    {
      this->HasMoved = true;
      // Moves that come during an update are taken together; a slow one waits for a pause.
      if (this->IsSlow || !this->Move.isActive())
      {
        this->Move.start(this->IsSlow ? PAUSE : 0);
      }
    }
    else if (event->type() == QEvent::MouseButtonRelease && event->button() == Qt::LeftButton)
    {
      this->drop();
    }
    return true;
  }
  if (this->IsBusy || ViewTool::isComputing())
  {
    return event->type() == QEvent::MouseButtonPress;
  }
  const bool isPress =
    event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
  if (isPress && event->button() == Qt::LeftButton && event->modifiers() == Qt::ShiftModifier)
  {
    this->offer(this->Mouse);
    return true;
  }
  if (isPress && event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier)
  {
    const QString answer = this->look(QString("press(%1)").arg(this->place(this->Mouse)));
    if (answer.startsWith('+'))
    {
      this->IsDragging = true;
      this->HasMoved = false;
      this->View->setCursor(Qt::ClosedHandCursor);
      BEGIN_UNDO_SET(tr("Move singularity"));
      ViewTool::say(answer.mid(1));
      return true;
    }
  }
  else if (event->type() == QEvent::MouseMove && event->buttons() == Qt::NoButton)
  {
    const QString answer = this->look(QString("hover(%1)").arg(this->place(this->Mouse)));
    this->View->setCursor(answer.isEmpty() ? Qt::ArrowCursor : Qt::OpenHandCursor);
    this->View->setToolTip(answer);
    if (!answer.isEmpty())
    {
      ViewTool::say(answer);
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void SingularityTool::drag()
{
  if (this->IsDragging && !this->IsBusy && this->View && !ViewTool::isComputing())
  {
    QElapsedTimer timer;
    timer.start();
    ViewTool::say(this->ask(QString("drag(%1)").arg(this->place(this->Mouse))));
    this->IsSlow = timer.elapsed() > SLOW;
  }
}

//------------------------------------------------------------------------------
void SingularityTool::drop()
{
  if (!this->IsDragging)
  {
    return;
  }
  if (this->IsBusy)
  {
    // The last place of the mouse is still to come.
    QTimer::singleShot(PAUSE, this, &SingularityTool::drop);
    return;
  }
  if (this->HasMoved)
  {
    this->drag();
  }
  this->IsDragging = false;
  this->Move.stop();
  this->ask("drop()");
  if (this->HasMoved)
  {
    this->record();
  }
  END_UNDO_SET();
  if (this->View)
  {
    this->View->setCursor(Qt::OpenHandCursor);
  }
}

//------------------------------------------------------------------------------
void SingularityTool::remove()
{
  if (!this->IsDragging && !this->IsBusy && !ViewTool::isComputing())
  {
    this->change(tr("Remove singularity"), QString("merge(%1)").arg(this->place(this->Mouse)));
  }
}

//------------------------------------------------------------------------------
void SingularityTool::offer(const QPointF& position)
{
  auto* const menu = new QMenu(this->View);
  menu->setObjectName("AddSingularities");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const struct
  {
    const char* name;
    QString text;
    int index;
    bool isPair;
  } entries[] = {
    { "Pair", tr("Add a pair, the positive one here"), 1, true },
    { "OppositePair", tr("Add a pair, the negative one here"), -1, true },
    { "Positive", tr("Add a positive one (free boundary)"), 1, false },
    { "Negative", tr("Add a negative one (free boundary)"), -1, false },
  };
  for (const auto& entry : entries)
  {
    QAction* const action = menu->addAction(entry.text);
    action->setObjectName(entry.name);
    const QString call = QString("add(%1, %2, %3)")
                           .arg(this->place(position))
                           .arg(entry.index)
                           .arg(entry.isPair ? "True" : "False");
    this->connect(action, &QAction::triggered, this,
      [this, call] { this->change(tr("Add singularities"), call); });
  }
  menu->popup(this->View->renderWidget()->mapToGlobal(position.toPoint()));
}

//------------------------------------------------------------------------------
void SingularityTool::refresh()
{
  if (this->IsOn && !this->IsBusy && !this->IsDragging && !ViewTool::isComputing() &&
    QApplication::mouseButtons() == Qt::NoButton)
  {
    this->look("refresh()");
  }
}

//------------------------------------------------------------------------------
QString SingularityTool::ask(const QString& call)
{
  if (this->IsBusy)
  {
    return QString();
  }
  this->IsBusy = true;
  const QString answer = Evaluate(call);
  this->IsBusy = false;
  return answer;
}

//------------------------------------------------------------------------------
QString SingularityTool::look(const QString& call)
{
  // Else what the hand is asked would be steps to undo, between those of the user.
  BEGIN_UNDO_EXCLUDE();
  const QString answer = this->ask(call);
  END_UNDO_EXCLUDE();
  return answer;
}

//------------------------------------------------------------------------------
void SingularityTool::change(const QString& step, const QString& call)
{
  BEGIN_UNDO_SET(step);
  const QString note = this->ask(call);
  this->record();
  END_UNDO_SET();
  ViewTool::say(note);
}

//------------------------------------------------------------------------------
void SingularityTool::record()
{
  vtkSMProxy* const proxy = this->Edited;
  if (proxy && proxy->GetProperty("SingularityList"))
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
    // A trace has what is modified within it.
    proxy->GetProperty("Objective")->Modified();
    proxy->GetProperty("SingularityList")->Modified();
    proxy->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
QString SingularityTool::place(const QPointF& position) const
{
  const QPointF pixel = this->pixel(position);
  return QString("%1, %2").arg(pixel.x()).arg(pixel.y());
}
