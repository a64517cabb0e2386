// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PythonAction.h"

#include "pqApplicationCore.h"
#include "pqUndoStack.h"
#include "vtkPythonInterpreter.h"

//------------------------------------------------------------------------------
void RunPythonAction(const QString& step, const QString& call)
{
  BEGIN_UNDO_SET(step);
  // The modules of plugins are known once ParaView's own are.
  const QString script = QString("try:\n"
                                 "  import paraview.simple\n"
                                 "  import directionfields\n"
                                 "  directionfields.%2\n"
                                 "except ImportError as problem:\n"
                                 "  from vtkmodules.vtkCommonCore import vtkOutputWindow\n"
                                 "  vtkOutputWindow.GetInstance().DisplayWarningText(\n"
                                 "    f'%1 needs a module of Python that is not there: "
                                 "{problem}\\n')\n")
                           .arg(step, call);
  vtkPythonInterpreter::RunSimpleString(script.toUtf8().constData());
  END_UNDO_SET();
  pqApplicationCore::instance()->render();
}
