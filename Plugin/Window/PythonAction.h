// SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Run a function of the Python module directionfields, which itself raises nothing, and show the
 * views again.
 */

#ifndef PythonAction_h
#define PythonAction_h

#include <QString>

/// As one step to undo of the name `step`.
/// `call` is the name of the function and its arguments, "show_active()".
void RunPythonAction(const QString& step, const QString& call);
/// As what no step to undo has in it; `name` is what messages call it.
void RunPythonBetweenSteps(const QString& name, const QString& call);

#endif
