// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionFieldToolBar.h"

#include "DirectionFieldActions.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqProxyGroupMenuManager.h"
#include "pqSettings.h"

#include <QAction>
#include <QMainWindow>
#include <QMetaObject>
#include <QToolBar>

namespace
{
/// The toolbar of the filters' category; ParaView 5.12 and newer put the group before its name.
QToolBar* FindBar(const QWidget* window)
{
  for (const char* name : { "Direction Fields", "filters.Direction Fields" })
  {
    if (auto* const bar = window->findChild<QToolBar*>(name))
    {
      return bar;
    }
  }
  return nullptr;
}

/// Puts the toolbar at the end of the last row, unless ParaView restores the places that its user
/// has left. It adds the toolbars of plugins that it loads early in front of the row of its own
/// filters, after many others, where most buttons would be cut off.
void PlaceBar(QMainWindow* window, QToolBar* bar)
{
  if (window && !pqApplicationCore::instance()->settings()->contains("MainWindow/Layout"))
  {
    window->addToolBar(bar);
    bar->show();
  }
}
}

//------------------------------------------------------------------------------
DirectionFieldToolBar::DirectionFieldToolBar(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
void DirectionFieldToolBar::startup()
{
  QWidget* const window = pqCoreUtilities::mainWidget();
  if (!window || this->Separator)
  {
    return;
  }
  this->Buttons = (new DirectionFieldActions(this))->actions();
  this->Separator = new QAction(this);
  this->Separator->setSeparator(true);
  // ParaView's own slots have to fill the toolbar before.
  for (auto* menu : window->findChildren<pqProxyGroupMenuManager*>())
  {
    this->connect(menu, SIGNAL(menuPopulated()), SLOT(insertButtons()), Qt::QueuedConnection);
    // Newer versions of ParaView tell changes of categories apart.
    if (menu->metaObject()->indexOfSignal("categoriesUpdated()") >= 0)
    {
      this->connect(menu, SIGNAL(categoriesUpdated()), SLOT(insertButtons()), Qt::QueuedConnection);
    }
  }
  QMetaObject::invokeMethod(this, "insertButtons", Qt::QueuedConnection);
}

//------------------------------------------------------------------------------
void DirectionFieldToolBar::insertButtons()
{
  QWidget* const window = pqCoreUtilities::mainWidget();
  QToolBar* const bar = window ? FindBar(window) : nullptr;
  QAction* const first = bar ? bar->actions().value(0) : nullptr;
  if (!bar || first == this->Buttons.first())
  {
    return;
  }
  bar->insertActions(first, this->Buttons);
  for (QAction* action : bar->actions())
  {
    // In a window of 1280 pixels there is no room for all. Fields of files are opened by File,
    // Open, few compare fields, and the menu has both filters. ParaView 5.11 ignores the attribute
    // omit_from_toolbar.
    if (action->objectName() == "ReadDirectionField" ||
      action->objectName() == "CompareDirectionFields")
    {
      bar->removeAction(action);
    }
  }
  bar->insertAction(first, this->Separator);
  if (!this->IsPlaced)
  {
    this->IsPlaced = true;
    PlaceBar(qobject_cast<QMainWindow*>(window), bar);
  }
}
