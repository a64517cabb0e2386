// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionFieldActions.h"

#include "PythonAction.h"
#include "SingularityTool.h"
#include "StrokeTool.h"
#include "pqActiveObjects.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSaveDataReaction.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QAction>
#include <QIcon>

#include <cstring>

namespace
{
/// The value of Element for quads.
constexpr int QUADS = 0;

/// The selected mesh of quads, if it is on show and no change of it waits for Apply.
pqPipelineSource* ShownQuads()
{
  auto& active = pqActiveObjects::instance();
  pqPipelineSource* const source = active.activeSource();
  if (!source || strcmp(source->getProxy()->GetXMLName(), "FieldAlignedRemesh") != 0 ||
    source->modifiedState() != pqProxy::UNMODIFIED ||
    vtkSMPropertyHelper(source->getProxy(), "Element").GetAsInt() != QUADS)
  {
    return nullptr;
  }
  pqDataRepresentation* const display =
    source->getOutputPort(0)->getRepresentation(active.activeView());
  return display && display->isVisible() ? source : nullptr;
}
}

//------------------------------------------------------------------------------
DirectionFieldActions::DirectionFieldActions(QObject* parent)
  : QActionGroup(parent)
{
  // Else what can be switched on could not be switched off.
  this->setExclusive(false);
  this->connect(this->newAction("ShowDirectionField", tr("Show direction field"),
                  tr("Show the selected mesh with its direction field: all directions as glyphs, "
                     "singularities as red and blue balls")),
    &QAction::triggered, this, &DirectionFieldActions::show);
  this->connect(
    this->newAction("RemeshToQuads", tr("Remesh to quads"),
      tr("Show the selected mesh as quads along its direction field, vertices of more or fewer "
         "edges than four as blue and red balls; pressed again, save the quads to a file")),
    &QAction::triggered, this, &DirectionFieldActions::remesh);
  QAction* const draw = this->newAction("DrawStrokes", tr("Draw strokes"),
    tr("While this is on, drag with the left button over a surface to draw strokes that its "
       "direction field follows; a click selects a stroke; Delete takes away that one, or the one "
       "under the mouse, or the last one"));
  draw->setCheckable(true);
  // The toolbar and the menu have an action each.
  this->connect(draw, &QAction::toggled, StrokeTool::instance(), &StrokeTool::setOn);
  this->connect(StrokeTool::instance(), &StrokeTool::toggled, draw, &QAction::setChecked);
  QAction* const edit = this->newAction("EditSingularitiesByHand", tr("Edit singularities"),
    tr("While this is on, drag the singularities of the selected field over its surface, and the "
       "field follows; Shift-click adds some, Delete takes the one under the mouse away"));
  edit->setCheckable(true);
  this->connect(edit, &QAction::toggled, SingularityTool::instance(), &SingularityTool::setOn);
  this->connect(SingularityTool::instance(), &SingularityTool::toggled, edit, &QAction::setChecked);
  // The mouse does one of them only.
  this->connect(edit, &QAction::toggled, draw,
    [draw](bool isOn)
    {
      if (isOn)
      {
        draw->setChecked(false);
      }
    });
  this->connect(draw, &QAction::toggled, edit,
    [edit](bool isOn)
    {
      if (isOn)
      {
        edit->setChecked(false);
      }
    });
}

//------------------------------------------------------------------------------
QAction* DirectionFieldActions::newAction(const char* name, const QString& text, const QString& tip)
{
  auto* action =
    new QAction(QIcon(QString(":/DirectionFields/Icons/%1.svg").arg(name)), text, this);
  action->setObjectName(QString("action%1").arg(name));
  action->setToolTip(tip);
  return this->addAction(action);
}

//------------------------------------------------------------------------------
void DirectionFieldActions::show()
{
  RunPythonAction("Show direction field", "show_active()");
}

//------------------------------------------------------------------------------
void DirectionFieldActions::remesh()
{
  pqPipelineSource* const quads = ShownQuads();
  if (quads)
  {
    // Not the irregular vertices, which may be what is selected.
    pqActiveObjects::instance().setActivePort(quads->getOutputPort(0));
    pqSaveDataReaction::saveActiveData();
    return;
  }
  RunPythonAction("Remesh to quads", "remesh_active()");
}
