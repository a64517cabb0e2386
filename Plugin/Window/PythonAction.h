// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Runs a function of the Python module directionfields, which itself raises nothing, as one step to
 * undo of the name `step`, and shows the views again.
 */

#ifndef PythonAction_h
#define PythonAction_h

#include <QString>

/// `call` is the name of the function and its arguments, "show_active()".
void RunPythonAction(const QString& step, const QString& call);

#endif
