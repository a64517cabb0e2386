// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PythonAction.h"

#include "pqApplicationCore.h"
#include "pqUndoStack.h"
#include "vtkPythonInterpreter.h"

namespace
{
void RunPython(const QString& name, const QString& call)
{
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
                           .arg(name, call);
  vtkPythonInterpreter::RunSimpleString(script.toUtf8().constData());
}
}

//------------------------------------------------------------------------------
void RunPythonAction(const QString& step, const QString& call)
{
  BEGIN_UNDO_SET(step);
  RunPython(step, call);
  END_UNDO_SET();
  pqApplicationCore::instance()->render();
}

//------------------------------------------------------------------------------
void RunPythonBetweenSteps(const QString& name, const QString& call)
{
  BEGIN_UNDO_EXCLUDE();
  RunPython(name, call);
  END_UNDO_EXCLUDE();
  pqApplicationCore::instance()->render();
}
