// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionFieldMenu.h"

#include "PythonAction.h"
#include "pqCoreUtilities.h"

#include <QAction>
#include <QMenu>

//------------------------------------------------------------------------------
DirectionFieldMenu::DirectionFieldMenu(QObject* parent)
  : DirectionFieldActions(parent)
{
  auto* menu = new QMenu(tr("Direction field preset"), pqCoreUtilities::mainWidget());
  menu->setObjectName("DirectionFieldPresets");
  menu->setToolTipsVisible(true);
  const QString common = tr("Unit Length, and ");
  const QString idle = tr("; what changes nothing on the surface is left off");
  const struct
  {
    const char* name;
    QString tip;
  } presets[] = {
    { "Scan",
      tr("four directions, Alignment Principal Curvature with strength 0.25, Singularity Cost 1, "
         "Constrain Boundary") },
    { "CAD part",
      tr("four directions, Constrain Boundary, Sharp Edges and Curvature, Singularity Cost 0") },
    { "Sheet", tr("four directions, Constrain Boundary, Singularity Cost 1") },
    { "Fibres",
      tr(
        "two directions, Alignment Principal Curvature along what is bent least, with strength 0.5, "
        "Singularity Cost 1") },
  };
  for (const auto& preset : presets)
  {
    QAction* const action = menu->addAction(tr(preset.name));
    action->setObjectName(preset.name);
    action->setToolTip(common + preset.tip + idle);
    const QString call = QString("apply_preset('%1')").arg(preset.name);
    this->connect(action, &QAction::triggered, this,
      [call] { RunPythonAction(tr("Direction field preset"), call); });
  }
  this->addAction(menu->menuAction());
  // The toolbar's actions have none: a shortcut of two actions starts neither.
  for (QAction* const action : this->actions())
  {
    if (action->objectName() == "actionDrawStrokes")
    {
      action->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_D);
    }
    else if (action->objectName() == "actionEditSingularitiesByHand")
    {
      action->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_E);
    }
  }
}
