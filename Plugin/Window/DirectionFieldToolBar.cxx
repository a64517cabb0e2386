// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionFieldToolBar.h"

#include "ShowDirectionFieldActions.h"
#include "pqCoreUtilities.h"
#include "pqProxyGroupMenuManager.h"

#include <QAction>
#include <QMainWindow>
#include <QMetaObject>
#include <QToolBar>

//------------------------------------------------------------------------------
DirectionFieldToolBar::DirectionFieldToolBar(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void DirectionFieldToolBar::startup()
{
  QWidget* const window = pqCoreUtilities::mainWidget();
  if (!window || this->Button)
  {
    return;
  }
  this->Button = (new ShowDirectionFieldActions(this))->actions().first();
  this->Separator = new QAction(this);
  this->Separator->setSeparator(true);
  // ParaView's own slots have to fill the toolbar before.
  for (auto* menu : window->findChildren<pqProxyGroupMenuManager*>())
  {
    this->connect(menu, SIGNAL(menuPopulated()), SLOT(insertButton()), Qt::QueuedConnection);
    // Newer versions of ParaView tell changes of categories apart.
    if (menu->metaObject()->indexOfSignal("categoriesUpdated()") >= 0)
    {
      this->connect(menu, SIGNAL(categoriesUpdated()), SLOT(insertButton()), Qt::QueuedConnection);
    }
  }
  QMetaObject::invokeMethod(this, "insertButton", Qt::QueuedConnection);
}

//------------------------------------------------------------------------------
void DirectionFieldToolBar::insertButton()
{
  QWidget* const window = pqCoreUtilities::mainWidget();
  auto* const bar = window ? window->findChild<QToolBar*>("Direction Fields") : nullptr;
  QAction* const first = bar ? bar->actions().value(0) : nullptr;
  if (bar && first != this->Button)
  {
    bar->insertAction(first, this->Button);
    bar->insertAction(first, this->Separator);
  }
}
