// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ExampleMenu.h"

#include "PythonAction.h"
#include "pqCoreUtilities.h"

#include <QAction>
#include <QMenu>

//------------------------------------------------------------------------------
ExampleMenu::ExampleMenu(QObject* parent)
  : QActionGroup(parent)
{
  auto* menu = new QMenu(tr("Direction field examples"), pqCoreUtilities::mainWidget());
  menu->setObjectName("DirectionFieldExamples");
  menu->setToolTipsVisible(true);
  const struct
  {
    const char* name;
    QString tip;
  } examples[] = {
    { "Scan with strokes", tr("A cross field that follows three strokes drawn on a scan") },
    { "Part", tr("A cross field along the sharp edges of a part") },
    { "Stripes", tr("Stripes along a line field on a scan, as fibres lie") },
    { "Quads", tr("A scan as a mesh of quads, with its irregular vertices") },
  };
  for (const auto& example : examples)
  {
    QAction* const action = menu->addAction(tr(example.name));
    action->setObjectName(QString(example.name).remove(' '));
    action->setToolTip(example.tip);
    const QString call = QString("open_example('%1')").arg(example.name);
    this->connect(
      action, &QAction::triggered, this, [call] { RunPythonAction(tr("Open an example"), call); });
  }
  this->addAction(menu->menuAction());
}
