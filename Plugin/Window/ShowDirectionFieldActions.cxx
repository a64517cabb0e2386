// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShowDirectionFieldActions.h"

#include "pqApplicationCore.h"
#include "pqUndoStack.h"
#include "vtkPythonInterpreter.h"

#include <QAction>
#include <QIcon>

//------------------------------------------------------------------------------
ShowDirectionFieldActions::ShowDirectionFieldActions(QObject* parent)
  : QActionGroup(parent)
{
  auto* action = new QAction(
    QIcon(":/DirectionFields/Icons/ShowDirectionField.svg"), tr("Show direction field"), this);
  action->setObjectName("actionShowDirectionField");
  action->setToolTip(
    tr("Show the selected mesh with its direction field: all directions as glyphs, "
       "singularities as red and blue balls"));
  this->addAction(action);
  this->connect(action, &QAction::triggered, this, &ShowDirectionFieldActions::show);
}

//------------------------------------------------------------------------------
void ShowDirectionFieldActions::show()
{
  // One step back undoes the whole picture.
  BEGIN_UNDO_SET("Show direction field");
  // The modules of plugins are known once ParaView's own are. show_active() itself raises nothing.
  vtkPythonInterpreter::RunSimpleString(
    "try:\n"
    "  import paraview.simple\n"
    "  import directionfields\n"
    "  directionfields.show_active()\n"
    "except ImportError as problem:\n"
    "  from vtkmodules.vtkCommonCore import vtkOutputWindow\n"
    "  vtkOutputWindow.GetInstance().DisplayWarningText(\n"
    "    f'Show direction field needs a module of Python that is not there: {problem}\\n')\n");
  END_UNDO_SET();
  pqApplicationCore::instance()->render();
}
