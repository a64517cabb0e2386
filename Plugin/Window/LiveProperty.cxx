// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LiveProperty.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMTrace.h"

#include <QElapsedTimer>

namespace
{
constexpr int SLOW = 200;
constexpr int PAUSE = 250;
}

//------------------------------------------------------------------------------
LiveProperty::LiveProperty(vtkSMProxy* proxy, vtkSMProperty* property, bool isSlow, QObject* parent)
  : QObject(parent)
  , Proxy(proxy)
  , Property(property)
  , IsSlow(isSlow)
{
  this->Timer.setSingleShot(true);
  this->connect(&this->Timer, &QTimer::timeout, this, &LiveProperty::apply);
}

//------------------------------------------------------------------------------
LiveProperty::~LiveProperty()
{
  this->finish();
}

//------------------------------------------------------------------------------
bool LiveProperty::canChange() const
{
  auto* const model = pqApplicationCore::instance()->getServerManagerModel();
  auto* const source = model->findItem<pqPipelineSource*>(this->Proxy.GetPointer());
  return source && source->modifiedState() != pqProxy::UNINITIALIZED;
}

//------------------------------------------------------------------------------
void LiveProperty::change(double value, bool isHeld)
{
  this->Value = value;
  if (!isHeld)
  {
    this->Timer.stop();
    this->apply();
    this->finish();
  }
  else if (this->IsSlow)
  {
    // Anew, so that it waits for a pause.
    this->Timer.start(PAUSE);
  }
  else if (!this->Timer.isActive())
  {
    // Moves of the mouse that have come meanwhile are taken together.
    this->Timer.start(0);
  }
}

//------------------------------------------------------------------------------
void LiveProperty::apply()
{
  if (!this->Proxy || !this->Property ||
    vtkSMPropertyHelper(this->Property).GetAsDouble() == this->Value)
  {
    return;
  }
  if (!this->HasBegun)
  {
    this->HasBegun = true;
    BEGIN_UNDO_SET(tr("Change %1").arg(this->Property->GetXMLLabel()));
  }
  QElapsedTimer timer;
  timer.start();
  vtkSMPropertyHelper(this->Property).Set(this->Value);
  this->Proxy->UpdateVTKObjects();
  // At once, since a render that only waits for its turn would not count as time.
  auto* const model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqView* const view : model->findItems<pqView*>())
  {
    view->forceRender();
  }
  this->IsSlow = timer.elapsed() > SLOW;
}

//------------------------------------------------------------------------------
void LiveProperty::finish()
{
  if (!this->HasBegun)
  {
    return;
  }
  this->HasBegun = false;
  if (this->Proxy && this->Property)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->Proxy.GetPointer());
    // A trace has what is modified within it.
    this->Property->Modified();
    this->Proxy->UpdateVTKObjects();
  }
  END_UNDO_SET();
}
