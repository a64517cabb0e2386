// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DirectionFieldActions.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqSaveDataReaction.h"
#include "pqUndoStack.h"
#include "vtkPythonInterpreter.h"
#include "vtkSMProxy.h"

#include <QAction>
#include <QIcon>

#include <cstring>

namespace
{
/// Calls a function of the Python module, which itself raises nothing, as one step to undo. The
/// modules of plugins are known once ParaView's own are.
void Run(const QString& button, const char* function)
{
  BEGIN_UNDO_SET(button);
  const QString script = QString("try:\n"
                                 "  import paraview.simple\n"
                                 "  import directionfields\n"
                                 "  directionfields.%2()\n"
                                 "except ImportError as problem:\n"
                                 "  from vtkmodules.vtkCommonCore import vtkOutputWindow\n"
                                 "  vtkOutputWindow.GetInstance().DisplayWarningText(\n"
                                 "    f'%1 needs a module of Python that is not there: "
                                 "{problem}\\n')\n")
                           .arg(button, function);
  vtkPythonInterpreter::RunSimpleString(script.toUtf8().constData());
  END_UNDO_SET();
  pqApplicationCore::instance()->render();
}

/// The selected mesh of quads, if it is on show and no change of it waits for Apply.
pqPipelineSource* ShownQuads()
{
  auto& active = pqActiveObjects::instance();
  pqPipelineSource* const source = active.activeSource();
  if (!source || strcmp(source->getProxy()->GetXMLName(), "FieldAlignedRemesh") != 0 ||
    source->modifiedState() != pqProxy::UNMODIFIED)
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
  this->connect(this->newAction("ShowDirectionField", tr("Show direction field"),
                  tr("Show the selected mesh with its direction field: all directions as glyphs, "
                     "singularities as red and blue balls")),
    &QAction::triggered, this, &DirectionFieldActions::show);
  this->connect(
    this->newAction("RemeshToQuads", tr("Remesh to quads"),
      tr("Show the selected mesh as quads along its direction field, vertices of more or fewer "
         "edges than four as blue and red balls; pressed again, save the quads to a file")),
    &QAction::triggered, this, &DirectionFieldActions::remesh);
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
  Run("Show direction field", "show_active");
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
  Run("Remesh to quads", "remesh_active");
}
